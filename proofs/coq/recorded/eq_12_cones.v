(** eq-12-cones (Sec. 2.2, (12))

    The points of an i-M-circle are the tangent planes of an oriented cone of revolution. Its
    vertex is finite iff the circle is not the image of a great circle; otherwise the planes
    envelop a cylinder.

        g₃ = −2t/(1 + N), g' = g₃c − p, s = (2c, 1 − N)/(1 + N), N = |c|² − ρ²

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** elliptic i-circles; size 1.
    Code: src/space/circle.rs, src/space/gradient.rs, src/space/laguerre/cone.rs,
    src/space/laguerre/plane.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Constant 1; Constant 0; Sub 4 0; Sub 4 1; Mul 1 1; Mul 1 1;
  Add 1 0; Sub 0 7; Add 7 0;
  Nonzero 0; (* 1 + N != 0: the i-circle is not the image of a great circle *)
  Unknown 3; Unknown 4; Mul 1 1; Mul 1 1; Add 1 0; Add 13 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 5; Unknown 6; Unknown 7; Mul 20 20; Mul 20 20; Add 1 0; Sub 0 21; Add 21 0; Div 22 0;
  Mul 27 0; Mul 7 0; Neg 0; Mul 0 29; Sub 0 12; Mul 2 30; Sub 0 13; Unknown 8; Div 31 17;
  Mul 36 0; Mul 24 0; Mul 24 1; Sub 35 22; Mul 0 4; Mul 6 4; Mul 23 29; Mul 23 29; Add 1 0;
  Add 0 24; Sub 11 0; Sub 46 34; Sub 46 34; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 49; Mul 15 21;
  Mul 15 20; Add 1 0; Mul 15 26; Add 1 0; Add 0 16; Mul 0 41; Mul 60 13; Mul 31 8; Sub 1 0;
  Sub 3 0;
  ShowZero 0; (* through the vertex *)
  Mul 63 36; Mul 63 37; Sub 62 41; Mul 0 40; Mul 30 3; Mul 30 3; Add 1 0; Mul 30 3; Add 1 0;
  Sub 0 69; Mul 0 56; Mul 0 63; Mul 76 23; Add 1 0;
  ShowZero 0; (* at an angle to the axis *)
  Add 74 10; Div 75 0; Mul 15 0; Mul 51 0; Sub 0 50; Sub 0 64;
  ShowZero 0; (* the plane again *)
  Mul 18 4; Mul 55 0; Sub 0 52; Sub 0 67;
  ShowZero 0; (* the plane again *)
  Mul 58 8; Neg 0; Sub 0 69;
  ShowZero 0; (* the plane again *)
  Sub 10 90;
  ShowZero 0; (* the centre again *)
  Sub 7 90;
  ShowZero 0; (* the centre again *)
  Mul 12 12; Mul 9 9; Add 1 0; Sub 92 28; Mul 0 17; Sub 2 0; Sub 0 96;
  ShowZero 0 (* the radius again *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** normals in a plane; size 1.
    Code: src/space/circle.rs, src/space/laguerre/plane.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Unknown 0; Unknown 1; Constant 1; Mul 2 2; Mul 2 2; Add 1 0; Add 3 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 2; Unknown 3; Unknown 4; Div 7 3; Constant 2; Mul 0 1; Mul 12 0; Mul 12 1; Sub 12 9;
  Mul 0 5; Constant 0; Sub 10 0; Sub 10 1; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 13; Mul 16 10;
  Mul 16 10; Add 1 0; Mul 0 15; Sub 25 4; Mul 0 12; Add 2 0; Sub 0 28; Sub 0 8; Sub 25 32;
  Sub 25 32; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 28; Mul 6 32; Mul 28 1; Add 1 0;
  ShowZero 0 (* normals in a plane *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two i-M-spheres; size 1.
    Code: src/scalar/ring.rs, src/space/gradient.rs, src/space/laguerre/plane.rs,
    src/space/laguerre/sphere.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_3_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Constant 1; Div 0 5; Mul 5 0; Add 0 5; Mul 5 2;
  Add 0 5; Sub 0 2;
  Nonzero 0; (* the spheres do not envelop a cylinder *)
  Unknown 4; Unknown 5; Mul 1 1; Mul 1 1; Add 1 0; Add 11 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Neg 3; Neg 3; Sub 16 21; Neg 4; Neg 4; Sub 17 22;
  Div 22 16; Mul 18 0; Mul 21 1; Mul 8 1; Mul 6 1; Sub 1 0; Mul 10 4; Mul 8 4; Sub 1 0; Mul 12 7;
  Mul 10 7; Sub 1 0; Unknown 10; Div 35 23; Mul 41 0; Mul 30 0; Mul 30 1; Sub 39 28; Mul 0 4;
  Mul 6 4; Mul 4 14; Mul 4 12; Add 1 0; Mul 4 11; Add 1 0; Add 0 5; Mul 35 41; Mul 35 41; Add 1 0;
  Add 0 54; Sub 17 0; Mul 0 58; Mul 58 43; Sub 1 0; Mul 41 49; Mul 41 49; Add 1 0; Add 0 60;
  Sub 25 0; Mul 0 66; Mul 64 51; Sub 1 0; Mul 16 52; Mul 9 41; Mul 2 41; Sub 1 0; Sub 3 0;
  ShowZero 0 (* common planes pass through the vertex *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
