(** eq-6-gauss (Sec. 2.1, (6), (7))

    The tangent planes of a graph and of Σ at the Gauss image are parallel, and the shape operator
    is the derivative of the Gauss map.

        σ(x, y, f) = (f_x, f_y, (f_x² + f_y²)/2),  dσ'(v) = ∇²f · v

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** graphs of second order; size 2.
    Code: src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs,
    src/space/polynomial.rs, src/space/sphere.rs, src/space/surface.rs *)
Definition part_1_size_2 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 1;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 2;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 3;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 4;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Constant 1; Mul 0 4;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 1 3;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 8 3;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 3 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 10 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 5 2;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 6 4;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 7 2;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Unknown 5; Unknown 6; Constant 0; Mul 10 11; Mul 0 12; Add 2 0; Mul 12 14; Mul 15 5; Mul 1 0;
  Add 3 0; Mul 18 9; Mul 16 0; Mul 0 20; Add 3 0; Mul 18 22; Mul 0 23; Add 13 0; Mul 20 25;
  Mul 0 10; Add 2 0; Mul 26 9; Mul 0 29; Add 2 0; Mul 9 9; Mul 1 1; Add 1 0; Mul 34 0; Div 35 41;
  Mul 1 0; Mul 26 15; Mul 27 7; Add 1 0; Add 0 29; Add 4 0; Sub 0 1; Mul 0 49; Sub 0 9;
  ShowZero 0; (* on Σ *)
  Mul 23 45; Mul 15 46; Add 36 1; Add 37 1; Sub 1 27; Sub 1 19; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0; (* parallel planes *)
  ShowZero 4; (* parallel planes *)
  ShowZero 3; (* parallel planes *)
  Mul 48 54; Mul 0 55; Add 45 0; Mul 50 57; Mul 0 58; Add 48 0; Unknown 7; Unknown 8; Add 53 1;
  Add 53 1; Mul 64 0; Mul 50 0; Add 52 0; Mul 67 4; Mul 65 0; Mul 0 69; Add 3 0; Mul 14 10;
  Mul 12 10; Add 1 0; Add 52 0; Sub 4 0;
  ShowZero 0; (* shape operator *)
  Mul 68 76; Mul 0 77; Add 67 0; Mul 53 14; Add 55 0; Mul 79 13; Mul 0 82; Add 2 0; Mul 24 23;
  Mul 6 23; Add 1 0; Add 56 0; Sub 4 0;
  ShowZero 0 (* shape operator *)
].

Theorem part_1_size_2_valid : valid part_1_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
