(** eq-12-spheres (Sec. 2.2, (12))

    An oriented plane touches an oriented sphere iff its point lies on the i-M-sphere of the
    sphere. Every i-M-sphere is that of exactly one oriented sphere, Σ that of the centre (0, 0,
    1/2) and the radius 1/2.

        (A, B, C, D) = (r + m₃, −m₁, −m₂, (r − m₃)/2)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** planes and spheres; size 1.
    Code: src/scalar/ring.rs, src/space/gradient.rs, src/space/laguerre/plane.rs,
    src/space/laguerre/sphere.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Constant 1; Add 0 1;
  Nonzero 0; (* n₃ != −1 *)
  Unknown 1; Unknown 2; Add 4 3; Div 4 0; Mul 3 0; Mul 3 1; Mul 1 1; Mul 1 1; Add 1 0; Add 10 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Mul 9 9; Mul 9 9; Add 1 0; Mul 15 15; Add 1 0; Sub 0 16;
  Zero 0; (* n·n = 1 *)
  ShowZero 0; (* as a test finds *)
  Unknown 3; Mul 0 13; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Div 23 25; Add 2 1; Neg 5;
  Neg 5; Sub 4 5; Mul 0 4; Mul 3 23; Mul 3 23; Add 1 0; Add 0 3; Sub 14 0; Mul 0 36; Mul 10 25;
  Sub 1 0; Mul 0 36; Mul 36 18; Mul 36 18; Add 1 0; Mul 42 19; Add 1 0; Add 0 25; Sub 0 21;
  Mul 47 0; Sub 8 0;
  ShowZero 0; (* tangency *)
  Div 47 36; Mul 50 0; Mul 43 0; Sub 0 48;
  ShowZero 0; (* the inverse of (12) *)
  Mul 44 2; Sub 0 49;
  ShowZero 0; (* the inverse of (12) *)
  Sub 53 43; Mul 0 6; Sub 0 56;
  ShowZero 0; (* the inverse of (12) *)
  Mul 37 7; Sub 0 39;
  ShowZero 0; (* the inverse of (12) *)
  Mul 8 8; Mul 7 7; Add 1 0; Mul 6 6; Add 1 0; Sub 0 63;
  ShowZero 0 (* a unit normal *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** spheres and i-M-spheres; size 1.
    Code: src/scalar/ring.rs, src/space/gradient.rs, src/space/laguerre/plane.rs,
    src/space/laguerre/sphere.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 1; Mul 2 2; Mul 2 2; Add 1 0; Add 3 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 2; Neg 0; Neg 0; Sub 0 2;
  ShowZero 0; (* the centre again *)
  Unknown 3; Neg 0; Neg 0; Sub 0 2;
  ShowZero 0; (* the centre again *)
  Unknown 4; Unknown 5; Div 14 17; Add 2 1; Sub 2 3; Mul 0 2; Mul 2 3; Sub 0 1; Sub 0 7;
  ShowZero 0; (* the centre again *)
  Add 2 3; Sub 0 8;
  ShowZero 0; (* the radius again *)
  Unknown 6; Unknown 7; Mul 1 10; Sub 0 1; Add 1 2; Add 1 0; Sub 0 5;
  ShowZero 0; (* the i-M-sphere again *)
  Unknown 8; Neg 0; Neg 0; Sub 0 2;
  ShowZero 0; (* the i-M-sphere again *)
  Unknown 9; Neg 0; Neg 0; Sub 0 2;
  ShowZero 0; (* the i-M-sphere again *)
  Sub 10 11; Mul 0 24; Sub 0 15;
  ShowZero 0; (* the i-M-sphere again *)
  Add 26 26; Sub 0 42;
  ShowZero 0; (* Σ *)
  Constant 0; Neg 0; Sub 0 1;
  ShowZero 0; (* Σ *)
  Sub 31 31; Mul 0 32; Sub 0 4;
  ShowZero 0; (* Σ *)
  Unknown 10; Div 50 46; Mul 54 0; Mul 54 0; Mul 54 1; Sub 54 51; Mul 0 4; Mul 6 4; Mul 4 13;
  Mul 4 14; Add 1 0; Mul 4 45; Add 1 0; Add 0 5; Sub 0 48; Mul 60 0; Mul 21 67; Mul 22 67;
  Add 1 0; Add 0 24; Sub 19 0; Mul 0 73; Mul 71 68; Sub 1 0; Sub 8 0;
  ShowZero 0 (* Σ *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
