(** duality-incidence (Sec. 2.1, metric duality)

    Duality reverses inclusions: a point lies on a non-isotropic plane iff the pole of the plane
    lies on the polar plane of the point.

        p ∈ P ⇔ P* ∈ p*

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** heights over planes; size 1.
    Code: src/scalar/ring.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs, src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the i-sphere is no plane *)
  Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Neg 0; Neg 4; Mul 7 4;
  Mul 7 4; Add 1 0; Add 0 3; Sub 5 0; Mul 9 12; Mul 9 12; Add 1 0; Add 0 10; Sub 14 0; Sub 5 0;
  ShowZero 0; (* heights over planes *)
  Sub 16 3; Neg 0; Sub 0 10; Add 11 0; Sub 2 0;
  ShowZero 0; (* the dual of a contact element *)
  Sub 23 23;
  ShowZero 0; (* the plane of the point *)
  Sub 23 23;
  ShowZero 0; (* the plane of the point *)
  Sub 4 18;
  ShowZero 0; (* the plane of the point *)
  Unknown 7; Unknown 8; Unknown 9; Constant 1; Div 0 31; Mul 4 4; Mul 4 4; Add 1 0; Mul 0 3;
  Div 5 37; Mul 1 0; Sub 0 8; Neg 11; Mul 0 8; Neg 12; Mul 0 10; Mul 2 39; Mul 1 39; Add 1 0;
  Add 0 7; Sub 40 0; Mul 0 49; Mul 45 45; Mul 45 45; Add 1 0; Mul 20 0; Sub 4 0; Mul 0 54; Neg 48;
  Sub 0 26; Mul 0 58; Sub 30 54; Sub 30 54; Mul 1 1; Mul 1 1; Add 1 0; Mul 63 5; Add 1 0;
  Add 10 0;
  ShowZero 0 (* tangent planes *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
