(** eq-13-circular (Sec. 3.2, (13))

    The sine of the sum of opposite angles of a quad, times its four sides, is, up to its sign, the
    in-circle determinant of the top view: the sums are multiples of π iff the corners are
    concyclic or collinear. In an embedded convex quad they are π iff it is concyclic.

        α₁ + α₃ = α₂ + α₄ = π

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** modulo π; size 1.
    Code: src/scalar/ring.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Sub 5 7;
  Sub 5 7; Sub 3 9; Sub 3 9; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0; Sub 11 13;
  Sub 11 13; Sub 17 15; Sub 17 15; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Sub 23 27; Sub 23 27; Mul 21 21; Mul 21 21; Add 1 0; Mul 4 4; Mul 4 4; Add 1 0; Mul 25 25;
  Mul 25 25; Add 1 0; Mul 27 3; Mul 1 10; Sub 1 0; Mul 3 13; Mul 32 7; Sub 1 0; Mul 34 15;
  Mul 34 17; Sub 1 0; Mul 39 6; Mul 39 4; Add 1 0; Mul 18 3; Add 1 0; Mul 35 28; Mul 39 26;
  Add 1 0; Sub 0 3;
  ShowZero 0; (* sin(α₁ + α₃) *)
  Sub 52 54; Sub 52 54; Sub 58 56; Sub 58 56; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5;
  Sub 1 0; Sub 66 60; Sub 66 60; Sub 64 62; Sub 64 62; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3;
  Mul 6 5; Sub 1 0; Mul 10 3; Mul 14 1; Add 1 0; Neg 27; Sub 1 0;
  ShowZero 0 (* sin(α₂ + α₄) *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
