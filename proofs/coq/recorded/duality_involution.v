(** duality-involution (Sec. 2.1, metric duality)

    The metric dual of the dual is the object itself: for points and non-isotropic planes, top
    views and gradients, contact elements and i-spheres.

        (p₁, p₂, p₃)* : z = p₁x + p₂y − p₃

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** twice dual; size 1.
    Code: src/scalar/ring.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the i-sphere is no plane *)
  Unknown 1; Sub 0 0;
  ShowZero 0; (* the polar plane *)
  Unknown 2; Sub 0 0;
  ShowZero 0; (* the polar plane *)
  Unknown 3; Neg 0; Sub 0 0;
  ShowZero 0; (* the polar plane *)
  ShowZero 5; (* point *)
  ShowZero 3; (* point *)
  Neg 1; Sub 0 3;
  ShowZero 0; (* point *)
  Unknown 4; Sub 0 0;
  ShowZero 0; (* plane *)
  Unknown 5; Sub 0 0;
  ShowZero 0; (* plane *)
  Unknown 6; Neg 0; Neg 0; Sub 0 2;
  ShowZero 0; (* plane *)
  Mul 15 15; Mul 14 14; Add 1 0;
  ShowZero 0; (* top view *)
  Mul 9 9; Mul 8 8; Add 1 0;
  ShowZero 0; (* gradient *)
  ShowZero 21; (* contact element *)
  ShowZero 19; (* contact element *)
  Mul 13 22; Mul 12 21; Add 1 0; Sub 21 0; Neg 0; Mul 27 18; Mul 26 17; Add 1 0; Sub 3 0; Neg 0;
  Sub 0 28;
  ShowZero 0; (* contact element *)
  ShowZero 23; (* contact element *)
  ShowZero 21; (* contact element *)
  Sub 1 8; Sub 0 8;
  ShowZero 0; (* contact element *)
  Constant 1; Div 0 37; Div 1 0; Sub 0 39;
  ShowZero 0; (* i-sphere *)
  Unknown 7; Neg 0; Mul 0 4; Neg 0; Mul 0 5; Sub 0 4;
  ShowZero 0; (* i-sphere *)
  Unknown 8; Neg 0; Mul 0 10; Neg 0; Mul 0 11; Sub 0 4;
  ShowZero 0; (* i-sphere *)
  Unknown 9; Mul 12 12; Mul 7 7; Add 1 0; Mul 0 18; Div 20 58; Mul 1 0; Sub 0 6; Mul 17 17;
  Mul 12 12; Add 1 0; Mul 0 24; Mul 0 6; Sub 0 5; Sub 0 13;
  ShowZero 0 (* i-sphere *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
