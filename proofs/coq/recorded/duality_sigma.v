(** duality-sigma (Sec. 2.1, 3.2)

    A non-isotropic plane touches Σ iff its pole lies on Σ; it touches in the pole. The plane cuts
    Σ in an i-circle around the point over its pole.

        |p|² + 2t = 0 ⇔ P* ∈ Σ

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** poles and contact; size 1.
    Code: src/scalar/ring.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs, src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 1; Constant 0; Unknown 0; Unknown 1; Unknown 2; Neg 0; Mul 4 3; Mul 5 3; Add 1 0;
  Add 0 7; Sub 4 0; Mul 0 11; Mul 9 9; Mul 9 9; Add 1 0; Mul 14 0; Sub 4 0; Sub 12 15; Mul 0 18;
  Sub 17 16; Sub 18 16; Mul 1 1; Mul 1 1; Add 1 0; Mul 23 5; Add 1 0; Add 0 9;
  ShowZero 0; (* tangency *)
  Div 26 26; Sub 25 26; Sub 25 27; Mul 1 2; Mul 1 3; Sub 1 29; Sub 1 29; Mul 1 1; Mul 1 1;
  Add 1 0;
  ShowZero 0; (* over the centre *)
  Mul 9 9; Mul 12 0; Add 0 22;
  ShowZero 0; (* radius *)
  Unknown 3; Mul 0 40; Add 40 0; Sub 0 2;
  ShowZero 0; (* the pole is the contact *)
  Unknown 4; Mul 0 44; Add 44 0; Sub 0 2;
  ShowZero 0; (* the pole is the contact *)
  Mul 7 7; Mul 4 4; Add 1 0; Mul 50 0; Div 51 52; Mul 1 0; Mul 52 13; Mul 53 10; Add 1 0;
  Add 0 55; Add 4 0; Mul 16 18; Mul 13 15; Add 1 0; Sub 3 0; Neg 0; Sub 0 5;
  ShowZero 0; (* the pole is the contact *)
  Sub 6 7; Mul 0 66; Sub 0 15;
  ShowZero 0; (* on Σ *)
  Mul 66 66; Add 0 0; Mul 0 42; Mul 0 18; Sub 0 70; Neg 71; Mul 0 46; Mul 0 72; Mul 1 72; Add 1 0;
  Add 0 5; Sub 73 0; Mul 0 80; Mul 53 66; Sub 1 0; Sub 0 66;
  ShowZero 0 (* Σ is its own dual *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
