(** eq-3-sections (Sec. 2.1, (3))

    A non-isotropic plane cuts an i-sphere of parabolic type in an i-circle, whose top view is a
    circle, real or imaginary; an isotropic plane cuts it in a parabola of the curvature A.

        centre (p − (B, C))/A, squared radius (|p − (B, C)|² + 2A(t − D))/A²

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a non-isotropic plane; size 1.
    Code: src/space/circle.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs,
    src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0;
  Nonzero 0; (* A != 0 *)
  Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Mul 4 1; Mul 4 1; Add 1 0; Add 0 5;
  Sub 0 0;
  ShowZero 0; (* in the plane *)
  Unknown 6; Unknown 7; Unknown 8; Constant 1; Div 0 14; Sub 14 4; Sub 14 4; Mul 1 2; Mul 1 3;
  Sub 16 6; Constant 2; Mul 1 0; Sub 11 21; Sub 11 21; Mul 1 1; Mul 1 1; Add 1 0; Mul 27 5;
  Add 1 0; Mul 14 14; Mul 1 0; Sub 13 27; Sub 13 27; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Mul 26 33; Mul 26 33; Add 1 0; Add 0 27; Sub 32 0; Mul 0 21; Mul 39 39; Mul 39 39; Add 1 0;
  Mul 46 0; Sub 4 0; Mul 48 11; Add 1 0;
  ShowZero 0; (* the sphere over the circle *)
  Mul 49 32; Mul 49 32; Add 1 0; Add 0 50; Sub 0 0;
  ShowZero 0; (* the centre *)
  Mul 55 55; Mul 25 0; Sub 0 28;
  ShowZero 0 (* tangent where r = 0 *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** an isotropic plane; size 1.
    Code: src/scalar/ring.rs, src/space/gradient.rs, src/space/parabolic_circle.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* the direction has a length *)
  Unknown 2; Sub 0 0;
  ShowZero 0; (* curvature *)
  Unknown 3; Unknown 4; Unknown 5; Mul 9 0; Mul 9 1; Add 4 1; Add 4 1; Sub 1 6; Sub 1 6; Mul 15 0;
  Mul 15 2; Sub 1 0;
  ShowZero 0; (* in the plane *)
  Unknown 6; Unknown 7; Unknown 8; Mul 14 14; Mul 14 14; Add 1 0; Mul 19 0; Constant 1; Div 0 27;
  Mul 2 0; Mul 9 21; Mul 9 21; Add 1 0; Add 0 10; Add 4 0; Mul 26 28; Mul 26 29; Add 16 1;
  Add 16 1; Mul 1 37; Mul 1 37; Add 1 0; Unknown 9; Mul 27 41; Mul 27 41; Add 1 0; Div 0 40;
  Mul 40 41; Mul 0 1; Add 0 7; Add 0 8; Mul 0 4; Mul 0 23; Add 0 18; Sub 11 0; Mul 54 0;
  Mul 35 42; Mul 35 42; Add 1 0; Add 0 36; Sub 17 0; Mul 0 60; Mul 48 48; Mul 48 48; Add 1 0;
  Mul 58 0; Sub 4 0; Sub 11 0;
  ShowZero 0; (* over the parabola *)
  Mul 20 57; Add 0 27; Add 0 28; Mul 0 60; Mul 0 43; Add 0 38; Sub 0 14; Mul 0 74; Sub 0 10;
  ShowZero 0 (* on the sphere *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
