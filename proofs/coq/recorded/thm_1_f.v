(** thm-1-f (Sec. 3.2, Theorem 1)

    A planar i-circular mesh has an inscribed mesh with parallel edges through every point of Σ. A
    step over an edge e is the reflection of the top view at the line through the gradient g of
    either face, across e; around a quad the four steps miss the start x by (2 I / N) i w (x - g),
    with w = e₁ e₃ conj(e₀ e₂), N = |w| and the in-circle determinant I, and so close iff it is
    concyclic.

        x₄ - x = (2 I / N) i w (x - g)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the gap of any quad; size 1.
    Code: src/construct/inscribed.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 0; Unknown 0; Sub 0 1; Sub 2 2; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 1; Unknown 2; Sub 1 7; Sub 1 9; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 3; Unknown 4; Sub 1 8; Sub 1 8; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Sub 20 6; Sub 21 6; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Sub 18 25; Sub 12 26; Sub 12 27; Mul 2 2; Add 0 17; Mul 3 3; Mul 3 3; Add 1 0; Mul 5 3;
  Mul 1 24; Sub 1 0; Mul 3 10; Mul 10 7; Sub 1 0; Mul 12 29; Mul 12 14; Sub 1 0; Mul 40 6;
  Mul 40 4; Add 1 0; Mul 39 3; Add 1 0; Div 0 45;
  Nonzero 0; (* the quad is not concyclic *)
  Unknown 5; Unknown 6; Mul 48 34; Mul 48 34; Sub 1 0; Mul 51 36; Mul 51 38; Add 1 0; Mul 47 35;
  Mul 47 35; Sub 1 0; Mul 50 37; Mul 50 39; Add 1 0; Neg 6; Mul 4 10; Mul 2 1; Sub 1 0; Mul 7 3;
  Mul 5 14; Add 1 0; Sub 20 69; Sub 20 70; Mul 5 0; Mul 3 2; Add 1 0; Neg 0; Div 0 73;
  Nonzero 0; (* the gap has an x *)
  Mul 76 76; Add 0 0; Add 0 78; Mul 79 78; Add 0 3; Add 0 81; Mul 82 75; Mul 83 75; Add 1 0;
  Add 0 85; Mul 86 72; Mul 87 72; Add 1 0; Add 0 89; Sub 8 11; Constant 1; Div 0 86; Mul 44 91;
  Mul 44 91; Add 1 0; Sub 5 0; Mul 0 4; Mul 0 99; Mul 0 97; Mul 1 97; Add 52 1; Add 52 1;
  Sub 17 21; Div 12 91; Mul 3 96; Mul 3 96; Add 1 0; Sub 4 0; Mul 0 4; Mul 0 111; Mul 0 102;
  Mul 1 102; Add 11 1; Add 11 1; Sub 25 29; Div 24 96; Mul 3 101; Mul 3 101; Add 1 0; Sub 4 0;
  Mul 0 4; Mul 0 123; Mul 0 107; Mul 1 107; Add 11 1; Add 11 1; Sub 48 37; Div 36 103; Mul 3 108;
  Mul 3 108; Add 1 0; Sub 4 0; Mul 0 4; Mul 0 135; Mul 0 114; Add 10 0; Sub 0 88;
  ShowNonzero 0; (* as a test finds *)
  Mul 46 132; Mul 0 126; Mul 0 120; Mul 0 116; Mul 143 95; Div 0 1; Mul 69 0; Sub 7 0;
  ShowZero 0; (* gap in x *)
  Mul 80 76; Mul 78 76; Sub 1 0; Mul 0 5; Mul 15 128; Add 24 0; Sub 0 102; Sub 0 3;
  ShowZero 0; (* gap in y *)
  Mul 105 105; Mul 105 105; Add 1 0; Mul 65 0; Div 66 159; Mul 1 0; Mul 160 111; Mul 161 111;
  Add 1 0; Add 0 163; Add 4 0; Mul 66 74; Add 1 0; Mul 56 63; Add 1 0; Mul 46 53; Add 1 0;
  Mul 36 43; Add 1 0; Sub 0 8; Add 125 29; Add 125 25; Mul 1 1; Mul 1 1; Add 1 0; Mul 87 0;
  Mul 0 21; Mul 181 6; Mul 182 6; Add 1 0; Add 0 184; Add 4 0; Sub 0 21; Sub 13 0;
  ShowZero 0 (* gap in z *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** one i-circular face; size 4.
    Code: src/construct/inscribed.rs, src/net/scribed.rs, src/scalar/ring.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Sub 12 10; Sub 12 10; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Sub 15 13; Sub 15 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 6; Unknown 7; Sub 20 1; Sub 20 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Sub 6 29; Sub 6 29; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Mul 28 28; Mul 28 28; Add 1 0; Mul 29 29; Mul 29 29; Add 1 0; Mul 9 0; Mul 7 32; Sub 1 0;
  Mul 9 35; Mul 14 4; Sub 1 0; Mul 16 37; Mul 16 39; Sub 1 0; Mul 43 6; Mul 43 4; Add 1 0;
  Mul 15 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Mul 4 59; Mul 4 59; Add 1 0; Add 0 5;
  Mul 8 61; Mul 8 61; Add 1 0; Add 0 9; Mul 12 63; Mul 12 63; Add 1 0; Add 0 13; Mul 16 48;
  Mul 16 48; Add 1 0; Add 0 17; Sub 8 12; Constant 1; Div 0 40; Mul 20 72; Mul 20 72; Add 1 0;
  Sub 5 0; Mul 0 4; Mul 0 84; Mul 0 78; Mul 1 78; Add 28 1; Add 28 1; Sub 84 86; Sub 84 86;
  Sub 19 23; Mul 2 2; Mul 2 2; Add 1 0; Div 17 0; Mul 8 6; Mul 8 6; Add 1 0; Sub 7 0; Mul 0 4;
  Mul 0 101; Mul 0 12; Mul 1 12; Add 16 1; Add 16 1; Sub 82 101; Sub 82 101; Sub 32 36; Mul 2 2;
  Mul 2 2; Add 1 0; Div 34 0; Mul 8 6; Mul 8 6; Add 1 0; Sub 7 0; Mul 0 4; Mul 0 118; Mul 0 12;
  Mul 1 12; Add 16 1; Add 16 1; Sub 122 99; Sub 122 99; Sub 61 49; Mul 2 2; Mul 2 2; Add 1 0;
  Div 51 0; Mul 8 6; Mul 8 6; Add 1 0; Sub 7 0; Mul 0 4; Mul 0 135; Mul 0 12; Add 15 0; Sub 0 79;
  ShowZero 0; (* as a test finds *)
  Mul 3 14; Add 17 0; Sub 0 81;
  ShowZero 0; (* as a test finds *)
  Constant 0; Mul 84 84; Mul 84 84; Add 1 0; Mul 68 0; Div 69 147; Mul 1 0; Mul 6 90; Mul 7 90;
  Add 1 0; Add 0 9; Add 4 0; Mul 69 77; Add 1 0; Mul 54 64; Add 1 0; Mul 39 49; Add 1 0;
  Mul 24 34; Add 1 0; Sub 0 8;
  ShowZero 0; (* as a test finds *)
  Sub 75 75;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 75 75;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 9 9;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 61 61;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 61 61;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 10 10;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 93 105; Div 92 135; Mul 112 140; Mul 112 140; Add 1 0; Sub 4 0; Mul 0 4; Mul 0 176;
  Mul 0 146; Add 119 0; Sub 57 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 3 148; Add 121 0; Sub 59 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 6 13; Add 30 0; Sub 25 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 7 62; Mul 5 62; Add 1 0; Sub 63 0; Mul 0 60; Mul 0 191; Mul 0 68; Add 14 0; Sub 0 135;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 3 70; Add 14 0; Sub 0 137;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 6 72; Add 14 0; Sub 0 46;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 129 137; Div 124 189; Mul 126 193; Mul 196 2; Sub 1 0; Mul 0 3; Mul 200 5; Mul 131 199;
  Sub 1 0; Mul 0 7; Mul 4 210; Mul 1 210; Add 1 0; Sub 150 0; Add 1 0; Sub 152 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 214; Mul 7 214; Add 1 0; Add 0 5; Sub 153 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 217; Mul 12 217; Add 1 0; Add 0 10; Sub 154 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 203; Mul 17 203; Add 1 0; Add 0 15; Sub 155 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 173; Mul 22 173; Add 1 0; Sub 81 0; Mul 29 148; Mul 26 148; Add 1 0; Add 0 3; Sub 84 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 136; Mul 31 136; Add 1 0; Add 0 8; Sub 87 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 67; Mul 36 65; Add 1 0; Add 0 13; Sub 65 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 162 191; Sub 96 98; Mul 245 0; Mul 177 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 168 197; Mul 180 0; Mul 251 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 253 8; Mul 253 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 157 174; Sub 106 108; Mul 174 0; Mul 174 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 163 180; Mul 177 0; Mul 180 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 182 8; Mul 182 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 93 169; Sub 91 118; Mul 169 0; Mul 169 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 101 175; Mul 172 0; Mul 175 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 177 8; Mul 177 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 227 105; Sub 134 103; Mul 164 0; Mul 164 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 233 113; Mul 167 0; Mul 170 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 172 8; Mul 172 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 145 221; Add 0 0; Sub 0 155;
  ShowZero 0; (* on Σ *)
  Sub 243 246; Sub 243 246; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 0;
  ShowZero 0; (* |s - g| *)
  Mul 152 230; Add 0 0; Mul 222 222; Mul 222 222; Add 1 0; Sub 3 0;
  ShowZero 0; (* on Σ *)
  Sub 226 258; Sub 226 258; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 12;
  ShowZero 0; (* |s - g| *)
  Mul 162 242; Add 0 0; Mul 217 217; Mul 217 217; Add 1 0; Sub 3 0;
  ShowZero 0; (* on Σ *)
  Sub 221 270; Sub 221 270; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 24;
  ShowZero 0; (* |s - g| *)
  Mul 147 254; Add 0 0; Mul 155 155; Mul 153 153; Add 1 0; Sub 3 0;
  ShowZero 0; (* on Σ *)
  Sub 159 282; Sub 157 282; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 36;
  ShowZero 0; (* |s - g| *)
  Sub 239 285; Sub 239 285; Sub 167 287; Sub 165 287; Mul 91 91; Mul 97 97; Add 1 0; Mul 6 6;
  Mul 6 6; Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12; Sub 1 0; Mul 3 15; Mul 14 7;
  Sub 1 0; Mul 16 17; Mul 16 19; Sub 1 0; Mul 109 6; Mul 115 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0 (* S is i-circular *)
].

Theorem part_2_size_4_valid : valid part_2_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a step is the same for both faces; size 1.
    Code: src/construct/inscribed.rs, src/net/scribed.rs, src/scalar/ring.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_3_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 2;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 3;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Add 6 13;
  Add 6 13; Neg 14; Mul 0 11; Mul 17 12; Add 4 1; Add 4 1; Add 13 3; Add 13 3; Mul 13 15;
  Mul 13 15; Add 1 0; Add 0 14; Mul 17 12; Mul 17 12; Add 1 0; Add 0 18; Mul 21 11; Mul 21 11;
  Add 1 0; Add 0 22; Mul 25 13; Mul 25 13; Add 1 0; Add 0 26; Sub 24 31; Sub 24 31; Sub 10 14;
  Mul 2 2; Mul 2 2; Add 1 0; Constant 1; Div 0 1; Mul 34 7; Mul 34 7; Add 1 0; Sub 8 0; Mul 0 4;
  Mul 0 52; Mul 0 13; Mul 1 13; Add 42 1; Add 42 1; Sub 37 42; Sub 37 42; Sub 24 28; Mul 2 2;
  Mul 2 2; Add 1 0; Div 17 0; Mul 8 6; Mul 8 6; Add 1 0; Sub 7 0; Mul 0 4; Mul 0 69; Mul 0 12;
  Mul 1 12; Add 16 1; Add 16 1; Sub 52 54; Sub 52 54; Sub 37 41; Mul 2 2; Mul 2 2; Add 1 0;
  Div 34 0; Mul 8 6; Mul 8 6; Add 1 0; Sub 7 0; Mul 0 4; Mul 0 86; Mul 0 12; Mul 1 12; Add 16 1;
  Add 16 1; Sub 83 69; Sub 83 69; Sub 66 54; Mul 2 2; Mul 2 2; Add 1 0; Div 51 0; Mul 8 6;
  Mul 8 6; Add 1 0; Sub 7 0; Mul 0 4; Mul 0 103; Mul 0 12; Add 15 0; Sub 0 93;
  ShowZero 0; (* as a test finds *)
  Mul 3 14; Add 17 0; Sub 0 95;
  ShowZero 0; (* as a test finds *)
  Constant 0; Mul 98 98; Mul 98 98; Add 1 0; Mul 68 0; Div 69 115; Mul 1 0; Mul 6 104; Mul 7 104;
  Add 1 0; Add 0 9; Add 4 0; Mul 69 80; Add 1 0; Mul 54 64; Add 1 0; Mul 39 49; Add 1 0;
  Mul 24 34; Add 1 0; Sub 0 8;
  ShowZero 0; (* as a test finds *)
  Unknown 11; Mul 115 0; Mul 132 1; Add 124 1; Add 124 1; Mul 1 128; Mul 1 128; Add 1 0;
  Sub 112 0; Mul 123 133; Mul 140 134; Add 134 1; Add 134 1; Add 129 3; Add 129 3; Mul 11 3;
  Mul 11 3; Add 1 0; Add 0 9; Mul 15 5; Mul 15 5; Add 1 0; Add 0 13; Sub 146 139; Sub 146 139;
  Sub 129 125; Mul 2 2; Mul 2 2; Add 1 0; Div 114 0; Mul 105 6; Mul 105 6; Add 1 0; Sub 7 0;
  Mul 0 4; Mul 0 166; Mul 0 12; Mul 1 12; Add 113 1; Add 113 1; Sub 28 163; Sub 28 163;
  Sub 23 146; Mul 2 2; Mul 2 2; Add 1 0; Div 131 0; Mul 8 6; Mul 8 6; Add 1 0; Sub 7 0; Mul 0 4;
  Mul 0 183; Mul 0 12; Mul 1 12; Add 16 1; Add 16 1; Sub 43 45; Sub 43 45; Sub 36 40; Mul 2 2;
  Mul 2 2; Add 1 0; Div 148 0; Mul 8 6; Mul 8 6; Add 1 0; Sub 7 0; Mul 0 4; Mul 0 200; Mul 0 12;
  Mul 1 12; Add 16 1; Add 16 1; Sub 190 60; Sub 190 60; Sub 176 53; Mul 2 2; Mul 2 2; Add 1 0;
  Div 165 0; Mul 8 6; Mul 8 6; Add 1 0; Sub 7 0; Mul 0 4; Mul 0 217; Mul 0 12; Add 15 0;
  Sub 0 164;
  ShowZero 0; (* as a test finds *)
  Mul 3 14; Add 17 0; Sub 0 166;
  ShowZero 0; (* as a test finds *)
  Mul 57 67; Add 101 0; Mul 42 52; Add 1 0; Mul 27 37; Add 1 0; Mul 12 22; Add 1 0; Sub 0 108;
  ShowZero 0; (* as a test finds *)
  Sub 177 177;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 177 177;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 111 111;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 163 163;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 163 163;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 112 112;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 217 231; Sub 217 231; Sub 202 214; Mul 2 2; Mul 2 2; Add 1 0; Div 199 0; Mul 233 6;
  Mul 233 6; Add 1 0; Sub 7 0; Mul 0 4; Mul 0 251; Mul 0 12; Add 240 0; Sub 164 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 3 14; Add 242 0; Sub 166 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 6 16; Add 137 0; Sub 132 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 7 169; Mul 5 169; Add 1 0; Sub 170 0; Mul 0 167; Mul 0 266; Mul 0 175; Add 14 0; Sub 0 256;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 3 177; Add 14 0; Sub 0 258;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 6 179; Add 14 0; Sub 0 153;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 263 104; Mul 263 104; Add 1 0; Sub 105 0; Mul 0 102; Mul 0 281; Mul 0 110; Add 270 0;
  Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 3 112; Add 272 0; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 6 114; Add 167 0; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 146 276; Sub 146 276; Sub 139 262; Mul 2 2; Mul 2 2; Add 1 0; Div 251 0; Mul 242 6;
  Mul 242 6; Add 1 0; Sub 7 0; Mul 0 4; Mul 0 303; Mul 0 12; Add 249 0; Mul 22 117; Mul 20 117;
  Add 1 0; Sub 118 0; Mul 0 115; Mul 0 311; Mul 0 123; Add 29 0; Sub 0 8;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 11 22; Add 259 0; Mul 5 127; Add 31 0; Sub 0 2;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 16 26; Add 197 0; Mul 10 131; Add 33 0; Sub 0 2;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 19 119; Mul 9 119; Add 1 0; Sub 120 0; Mul 0 117; Mul 0 330; Mul 0 125; Add 26 0; Sub 0 277;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 3 127; Add 18 0; Sub 0 279;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 6 129; Add 16 0; Sub 0 215;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 320 332; Sub 320 332; Sub 307 315; Mul 303 1; Mul 303 3; Sub 1 0; Div 300 0; Mul 305 5;
  Mul 307 5; Sub 1 0; Mul 0 3; Mul 311 8; Mul 310 11; Sub 1 0; Mul 0 7; Mul 4 347; Mul 1 347;
  Add 1 0; Sub 331 0; Add 1 0; Sub 333 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 346; Mul 7 346; Add 1 0; Add 0 5; Sub 334 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 346; Mul 12 346; Add 1 0; Add 0 10; Sub 335 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 349; Mul 17 349; Add 1 0; Add 0 15; Sub 336 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 363; Mul 22 363; Add 1 0; Sub 257 0; Mul 29 324; Mul 26 324; Add 1 0; Add 0 3; Sub 260 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 312; Mul 31 312; Add 1 0; Add 0 8; Sub 263 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 136; Mul 36 134; Add 1 0; Add 0 13; Sub 134 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 252 380; Sub 252 380; Sub 247 366; Mul 243 1; Mul 243 3; Sub 1 0; Div 355 0; Mul 245 5;
  Mul 247 5; Sub 1 0; Mul 0 3; Mul 251 8; Mul 250 11; Sub 1 0; Mul 0 7; Mul 4 395; Mul 1 395;
  Add 1 0; Sub 382 0; Add 1 0; Sub 384 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 408; Mul 7 408; Add 1 0; Add 0 5; Sub 393 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 278; Mul 12 278; Add 1 0; Add 0 10; Sub 275 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 281; Mul 17 281; Add 1 0; Add 0 15; Sub 276 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 375; Mul 22 375; Add 1 0; Sub 310 0; Mul 29 422; Mul 26 422; Add 1 0; Add 0 3; Sub 317 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 156; Mul 31 154; Add 1 0; Add 0 8; Sub 154 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 139; Mul 36 129; Add 1 0; Add 0 13; Sub 127 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 394 437; Sub 394 437; Mul 1 411; Mul 1 413; Sub 1 0;
  ShowZero 0; (* across the edge *)
  Sub 442 445; Sub 442 445; Sub 401 447; Sub 401 447; Add 3 1; Add 3 1; Mul 1 421; Mul 1 421;
  Add 1 0;
  ShowZero 0; (* reflected at the line through g *)
  Sub 391 408; Sub 391 408; Mul 1 407; Mul 1 409; Sub 1 0;
  ShowZero 0; (* across the edge *)
  Sub 396 459; Sub 396 459; Add 13 1; Add 13 1; Mul 1 415; Mul 1 415; Add 1 0;
  ShowZero 0; (* reflected at the line through g *)
  Sub 222 403; Sub 220 403; Mul 1 402; Mul 1 404; Sub 1 0;
  ShowZero 0; (* across the edge *)
  Sub 227 471; Sub 225 471; Add 13 1; Add 13 1; Mul 1 410; Mul 1 410; Add 1 0;
  ShowZero 0; (* reflected at the line through g *)
  Sub 475 234; Sub 475 232; Mul 1 397; Mul 1 399; Sub 1 0;
  ShowZero 0; (* across the edge *)
  Add 11 37; Add 11 37; Mul 1 403; Mul 1 403; Add 1 0;
  ShowZero 0; (* reflected at the line through g *)
  Sub 485 442; Sub 485 442; Mul 1 344; Mul 1 346; Sub 1 0;
  ShowZero 0; (* across the edge *)
  Sub 447 368; Sub 447 368; Sub 492 370; Sub 492 370; Add 3 1; Add 3 1; Mul 1 354; Mul 1 354;
  Add 1 0;
  ShowZero 0; (* reflected at the line through g *)
  Sub 228 499; Sub 226 499; Mul 1 341; Mul 1 343; Sub 1 0;
  ShowZero 0; (* across the edge *)
  Sub 233 382; Sub 231 382; Add 13 1; Add 13 1; Mul 1 349; Mul 1 349; Add 1 0;
  ShowZero 0; (* reflected at the line through g *)
  Sub 218 240; Sub 208 238; Mul 1 336; Mul 1 338; Sub 1 0;
  ShowZero 0; (* across the edge *)
  Sub 223 394; Sub 213 394; Add 13 1; Add 13 1; Mul 1 344; Mul 1 344; Add 1 0;
  ShowZero 0; (* reflected at the line through g *)
  Sub 480 230; Sub 480 220; Mul 1 331; Mul 1 333; Sub 1 0;
  ShowZero 0; (* across the edge *)
  Add 11 37; Add 11 37; Mul 1 337; Mul 1 337; Add 1 0;
  ShowZero 0; (* reflected at the line through g *)
  Mul 424 500; Add 0 0; Sub 0 434;
  ShowZero 0; (* on Σ *)
  Mul 425 503; Add 0 0; Mul 495 495; Mul 495 495; Add 1 0; Sub 3 0;
  ShowZero 0; (* on Σ *)
  Mul 429 509; Add 0 0; Mul 484 484; Mul 484 484; Add 1 0; Sub 3 0;
  ShowZero 0; (* on Σ *)
  Mul 301 515; Add 0 0; Mul 309 309; Mul 307 307; Add 1 0; Sub 3 0;
  ShowZero 0; (* on Σ *)
  Mul 277 521; Add 0 0; Mul 285 285; Mul 283 283; Add 1 0; Sub 3 0;
  ShowZero 0; (* on Σ *)
  Mul 251 527; Add 0 0; Mul 269 269; Mul 259 259; Add 1 0; Sub 3 0;
  ShowZero 0 (* on Σ *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
