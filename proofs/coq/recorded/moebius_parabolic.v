(** moebius-parabolic (Sec. 2.1, isotropic sphere transformations)

    The inversion at an i-M-sphere is an involution that keeps top views. It maps i-M-spheres to
    i-M-spheres and elliptic i-circles to such.

        (x', z) ↦ (x', 2s(x') − z)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** points and i-M-spheres; size 1.
    Code: src/scalar/ring.rs, src/space/gradient.rs, src/space/moebius.rs, src/space/plane.rs,
    src/space/point.rs, src/space/similarity.rs, src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 1; Constant 0; Neg 1; Neg 1; Mul 5 5; Mul 5 5; Add 1 0; Sub 0 5;
  Div 7 10; Mul 1 0; Neg 11; Neg 11; Mul 9 11; Mul 9 2; Add 1 0; Mul 11 3; Add 1 0; Mul 13 7;
  Add 1 0; Mul 15 18; Mul 17 9; Add 1 0; Add 0 6; Add 0 5; Div 23 5; Neg 1; Mul 0 1; Sub 0 28;
  ShowZero 0; (* the inversion *)
  Add 8 14; Mul 26 17; Add 1 0; Add 0 13; Neg 0; Mul 0 8; Sub 0 34;
  ShowZero 0; (* the inversion *)
  Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Add 4 4; Add 4 4; Add 4 4; Add 4 4;
  Add 15 28; Mul 42 35; Add 1 0; Mul 46 7; Neg 4; Neg 8; Mul 31 1; Mul 27 9; Add 1 0; Mul 21 10;
  Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Mul 0 33; Mul 23 52; Mul 0 51; Mul 24 62; Mul 24 62;
  Add 1 0; Add 0 25; Add 4 0; Mul 68 0; Sub 0 27; Sub 9 0;
  ShowZero 0; (* the inversion *)
  Mul 42 42; Mul 36 36; Add 1 0; Sub 0 70; Mul 0 64; Neg 47; Neg 41; Mul 72 1; Add 64 0; Mul 74 2;
  Add 1 0; Mul 76 6; Add 1 0; Mul 79 7; Add 63 0; Add 0 5; Add 0 4; Div 85 4; Neg 1; Mul 0 1;
  Sub 0 90;
  ShowZero 0; (* an involution *)
  Add 70 13; Mul 88 15; Add 1 0; Add 0 12; Neg 0; Mul 0 8; Sub 0 96;
  ShowZero 0; (* an involution *)
  Add 6 18; Mul 95 24; Add 1 0; Mul 99 41; Mul 19 52; Mul 16 60; Add 1 0; Mul 10 61; Add 1 0;
  Mul 6 56; Add 1 0; Sub 7 0; Mul 0 22; Sub 0 70;
  ShowZero 0; (* an involution *)
  Unknown 7; Unknown 8; Unknown 9; Unknown 10; Mul 112 3; Mul 112 3; Add 1 0; Mul 114 4; Add 1 0;
  Mul 116 5; Add 1 0; Mul 118 10; Mul 120 10; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 125 14;
  Add 1 0; Add 0 9; Add 3 12; Mul 129 17; Add 1 0; Add 12 93; Add 8 93; Add 5 93; Add 3 93;
  Mul 2 111; Mul 2 105; Add 1 0; Add 0 3; Sub 83 0; Mul 0 145; Mul 9 72; Sub 1 0; Mul 33 147;
  Mul 33 147; Add 1 0; Add 0 34; Sub 110 0; Mul 0 153; Mul 40 145; Sub 1 0; Add 8 0;
  ShowZero 0; (* points of spheres *)
  Mul 152 119; Mul 152 119; Add 1 0; Mul 154 120; Add 1 0; Mul 156 121; Add 1 0; Mul 158 126;
  Mul 160 126; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 165 130; Add 1 0; Add 0 9; Add 3 12;
  Mul 169 133; Add 1 0; Add 12 133; Add 8 133; Add 5 133; Add 3 133; Mul 2 179; Mul 2 179;
  Add 1 0; Add 0 3; Sub 142 0; Mul 0 185; Mul 9 177; Sub 1 0; Sub 146 121; Mul 0 189; Sub 0 128;
  Sub 3 0;
  ShowZero 0; (* its sphere stays *)
  Mul 162 162; Mul 156 156; Add 1 0;
  ShowZero 0 (* the top view stays *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** elliptic i-circles; size 1.
    Code: src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs, src/space/moebius.rs,
    src/space/plane.rs, src/space/point.rs, src/space/similarity.rs, src/space/sphere.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Constant 1; Constant 0; Neg 1; Neg 1; Add 7 7;
  Add 7 7; Add 7 7; Add 7 7; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8; Unknown 9;
  Unknown 10; Sub 3 1; Sub 3 1; Mul 1 1; Mul 1 1; Add 1 0; Mul 11 6; Mul 11 6; Add 1 0; Add 0 12;
  Mul 12 12; Mul 12 12; Add 1 0; Sub 0 7; Div 27 32; Mul 1 0; Neg 18; Neg 18; Mul 29 31; Mul 29 2;
  Add 1 0; Mul 31 3; Add 1 0; Mul 33 7; Add 1 0; Mul 35 38; Mul 37 9; Add 1 0; Add 0 6; Add 0 5;
  Add 4 10; Mul 42 13; Add 1 0; Add 0 9; Add 3 12; Mul 46 19; Add 1 0; Mul 48 49; Mul 48 43;
  Add 1 0; Mul 50 44; Add 1 0; Mul 52 45; Add 1 0; Mul 54 56; Mul 56 50; Add 1 0; Add 0 6;
  Add 0 5; Add 4 10; Mul 61 54; Add 1 0; Add 0 9; Add 3 12; Mul 65 57; Add 1 0; Add 12 65;
  Add 8 65; Add 5 65; Add 3 65; Div 73 35; Mul 4 0; Mul 0 32; Mul 1 29; Mul 2 27; Sub 7 2;
  Sub 7 2; Sub 7 2; Mul 68 68; Mul 68 68; Add 1 0; Sub 0 83; Mul 0 57; Neg 73; Neg 73; Mul 85 1;
  Add 57 0; Mul 87 2; Add 1 0; Mul 89 6; Add 1 0; Mul 92 7; Add 56 0; Add 0 5; Add 0 4; Add 59 9;
  Mul 97 11; Add 1 0; Add 0 8; Add 3 11; Mul 101 17; Add 1 0; Mul 105 82; Neg 99; Neg 103;
  Mul 14 1; Mul 11 104; Add 1 0; Mul 9 105; Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Div 116 22;
  Neg 19; Mul 0 1; Neg 17; Mul 0 3; Mul 5 4; Mul 43 3; Mul 43 2; Add 1 0; Add 0 44; Sub 4 0;
  ShowZero 0; (* in the plane *)
  Neg 84; Mul 0 54; Neg 82; Mul 0 56; Mul 112 131; Mul 58 58; Mul 1 0; Sub 5 15; Sub 4 14;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* in the top view *)
  Mul 11 11; Mul 10 10; Add 1 0; Sub 0 9; Mul 0 116; Neg 16; Neg 15; Mul 144 1; Add 116 0;
  Mul 146 2; Add 1 0; Mul 148 6; Add 1 0; Mul 151 7; Add 115 0; Add 0 5; Add 0 4; Mul 154 78;
  Add 107 0; Mul 156 79; Add 1 0; Mul 158 80; Add 1 0; Mul 161 84; Add 106 0; Add 0 5; Add 0 4;
  Add 4 163; Add 1 163; Div 169 16; Mul 2 0; Mul 0 14; Sub 3 0; Sub 0 165;
  ShowZero 0; (* there and back: plane *)
  Add 135 26; Mul 173 28; Add 1 0; Add 0 25; Add 120 20; Mul 177 99; Add 1 0; Add 0 19; Add 0 176;
  Mul 12 5; Sub 1 0; Sub 0 176;
  ShowZero 0; (* there and back: plane *)
  Add 11 36; Mul 185 42; Add 1 0; Add 10 29; Mul 188 109; Add 1 0; Add 0 185; Mul 22 4; Sub 1 0;
  Sub 0 185;
  ShowZero 0; (* there and back: plane *)
  Neg 39; Mul 0 27; Sub 0 187;
  ShowZero 0; (* there and back: centre *)
  Neg 21; Mul 0 30; Sub 0 189;
  ShowZero 0; (* there and back: centre *)
  Mul 68 202; Mul 33 33; Mul 1 0; Sub 0 186;
  ShowZero 0 (* there and back: radius *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
