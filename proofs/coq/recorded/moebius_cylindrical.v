(** moebius-cylindrical (Sec. 2.1, isotropic sphere transformations)

    The inversion at an i-sphere of cylindrical type, with a centre c on its axis, is an involution
    of the points off the axis. It appears in the top view as the inversion at the circle, and
    corresponding points lie on lines through c. It maps i-M-spheres to i-M-spheres, and elliptic
    i-circles off the centre to such.

        x ↦ c + r² (x − c)/|x' − c'|²

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
  Unknown 0;
  Nonzero 0; (* r² != 0 *)
  Unknown 1; Unknown 2; Unknown 3; Unknown 4; Sub 1 3; Sub 1 3; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* the point does not lie on the axis *)
  Unknown 5; Mul 9 9; Mul 9 9; Add 1 0; Sub 0 13; Constant 1; Div 0 16; Mul 2 0; Neg 16; Neg 16;
  Div 20 19; Constant 0; Sub 0 0; Sub 1 12; Neg 6; Neg 9; Mul 3 1; Mul 4 8; Add 1 0; Mul 6 9;
  Add 1 0; Mul 7 5; Add 1 0; Mul 0 12; Mul 0 18; Sub 12 0; Add 0 14; Mul 3 18; Sub 15 0; Add 0 17;
  Sub 24 18; Mul 0 16; Add 0 14; Add 0 13; Add 0 12; Mul 0 24; Mul 0 30; Sub 6 0; Add 0 26;
  Mul 3 30; Sub 27 0; Add 0 29; Sub 3 15; Sub 1 13; Mul 13 35; Add 28 0; Add 0 26; Add 0 25;
  Mul 0 37; Mul 0 43; Sub 37 0; Add 0 39; Mul 3 43; Sub 22 0; Add 0 42; Sub 3 28; Sub 1 26;
  Mul 26 47; Add 39 0; Add 0 37; Mul 0 49; Mul 0 55; Sub 49 0; Add 0 51; Mul 3 55; Sub 52 0;
  Add 0 54; Sub 3 40; Sub 1 38; Sub 63 68; Mul 0 54; Add 50 0; Mul 0 61; Mul 0 67; Sub 61 0;
  Add 0 63; Mul 3 67; Sub 64 0; Add 0 66; Sub 3 52; Sub 1 50; Mul 87 87; Mul 87 87; Add 1 0;
  Sub 0 72; Mul 0 78; Neg 92; Neg 92; Mul 45 82; Mul 33 2; Add 1 0; Mul 23 3; Add 1 0; Mul 13 7;
  Add 1 0; Mul 51 89; Mul 39 9; Add 1 0; Mul 29 10; Add 1 0; Mul 19 14; Add 1 0; Div 96 7; Neg 1;
  Mul 0 1; Mul 109 114; Add 114 0; Sub 2 115; Mul 0 108; Add 117 0; Sub 0 3;
  ShowZero 0; (* the inversion *)
  Mul 87 101; Sub 99 0; Add 0 101; Mul 78 104; Sub 102 0; Add 0 104; Sub 0 3; Mul 69 108;
  Sub 106 0; Add 0 108; Sub 0 7; Mul 61 112; Sub 92 0; Add 0 112; Sub 0 11; Mul 53 116; Sub 114 0;
  Add 0 116; Sub 0 15; Mul 12 124; Mul 9 44; Add 1 0; Mul 7 45; Add 1 0; Mul 5 49; Add 1 0; Neg 0;
  Mul 0 35; Mul 142 148; Add 147 0; Sub 2 148; Mul 0 142; Add 150 0; Sub 0 3;
  ShowZero 0; (* the inversion *)
  Mul 121 137; Sub 132 0; Add 0 146; Mul 112 140; Sub 135 0; Add 0 149; Sub 0 3; Mul 103 144;
  Sub 139 0; Add 0 153; Sub 0 7; Mul 95 148; Sub 143 0; Add 0 157; Sub 0 11; Mul 87 152; Sub 91 0;
  Add 0 161; Sub 0 15; Unknown 6; Mul 13 159; Mul 10 79; Add 1 0; Mul 8 80; Add 1 0; Mul 6 84;
  Add 1 0; Mul 166 7; Neg 25; Neg 147; Mul 80 1; Mul 74 146; Add 1 0; Mul 41 64; Add 1 0; Mul 8 5;
  Add 1 0; Sub 9 0; Mul 0 80; Sub 19 183; Mul 0 194; Add 185 0; Sub 3 186; Mul 0 188; Add 188 0;
  Sub 0 3;
  ShowZero 0; (* the inversion *)
  Mul 86 86; Mul 53 53; Add 1 0; Sub 0 182; Mul 0 188; Neg 91; Neg 58; Mul 142 1; Add 110 0;
  Mul 132 2; Add 1 0; Mul 122 6; Add 1 0; Mul 147 7; Add 109 0; Mul 137 8; Add 1 0; Mul 127 12;
  Add 1 0; Div 204 6; Neg 1; Mul 0 1; Sub 0 219;
  ShowZero 0; (* an involution *)
  Mul 92 17; Add 84 0; Mul 90 18; Add 1 0; Mul 88 22; Add 1 0; Neg 0; Mul 0 10; Sub 0 227;
  ShowZero 0; (* an involution *)
  Mul 67 26; Add 58 0; Mul 65 27; Add 1 0; Mul 63 31; Add 1 0; Mul 223 45; Mul 26 56; Mul 21 201;
  Add 1 0; Mul 13 119; Add 1 0; Mul 6 60; Add 1 0; Sub 7 0; Mul 0 27; Sub 0 74;
  ShowZero 0; (* an involution *)
  Unknown 7; Unknown 8; Unknown 9; Unknown 10; Mul 201 3; Mul 189 3; Add 1 0; Mul 179 4; Add 1 0;
  Mul 169 5; Add 1 0; Mul 207 10; Mul 195 10; Add 1 0; Mul 185 11; Add 1 0; Mul 175 12; Add 1 0;
  Mul 140 17; Mul 137 17; Add 1 0; Mul 135 18; Add 1 0; Mul 133 19; Add 1 0; Mul 113 24;
  Mul 110 24; Add 1 0; Mul 108 25; Add 1 0; Mul 106 26; Add 1 0; Add 21 245; Add 15 243;
  Add 9 160; Add 3 127; Mul 2 171; Mul 2 138; Add 1 0; Add 0 3; Sub 96 0; Mul 0 291; Mul 9 88;
  Sub 1 0; Mul 0 284; Mul 43 291; Mul 43 291; Add 1 0; Add 0 44; Sub 124 0; Mul 0 300; Mul 50 207;
  Sub 1 0; Mul 0 302; Sub 9 0;
  ShowZero 0; (* points of spheres *)
  Sub 190 190; Sub 157 157; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0 (* seen in the top view *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** elliptic i-circles; size 1.
    Code: src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs, src/space/moebius.rs,
    src/space/plane.rs, src/space/point.rs, src/space/similarity.rs, src/space/sphere.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* r² != 0 *)
  Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Sub 3 1; Sub 3 1; Mul 1 1;
  Mul 1 1; Add 1 0; Sub 8 10; Sub 8 10; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* the top view of the i-circle does not pass through the centre *)
  Sub 12 16; Sub 12 16; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* the point lies off the axis *)
  Unknown 7; Mul 22 22; Mul 22 22; Add 1 0; Sub 0 26; Constant 1; Div 0 29; Mul 2 0; Neg 29;
  Neg 29; Div 33 32; Constant 0; Sub 0 0; Sub 1 12; Neg 6; Neg 9; Mul 3 1; Mul 4 8; Add 1 0;
  Mul 6 9; Add 1 0; Mul 7 5; Add 1 0; Mul 0 12; Mul 0 18; Sub 12 0; Add 0 14; Mul 3 18; Sub 15 0;
  Add 0 17; Mul 6 20; Sub 18 0; Add 0 20; Mul 9 25; Sub 20 0; Add 0 34; Sub 30 24; Mul 0 22;
  Add 0 20; Add 0 19; Add 0 18; Mul 0 30; Mul 0 36; Sub 6 0; Add 0 32; Mul 3 36; Sub 33 0;
  Add 0 35; Mul 6 38; Sub 36 0; Add 0 38; Mul 9 43; Sub 38 0; Add 0 52; Sub 9 27; Sub 7 25;
  Sub 5 23; Sub 3 21; Mul 21 49; Add 42 0; Add 0 40; Add 0 39; Mul 0 51; Mul 0 57; Sub 51 0;
  Add 0 53; Mul 3 57; Sub 30 0; Add 0 56; Mul 6 59; Sub 57 0; Add 0 59; Mul 9 64; Sub 59 0;
  Add 0 73; Sub 9 48; Sub 7 46; Sub 5 44; Sub 3 42; Mul 42 69; Add 61 0; Add 0 59; Mul 0 71;
  Mul 0 77; Sub 71 0; Add 0 73; Mul 3 77; Sub 74 0; Add 0 76; Mul 6 79; Sub 53 0; Add 0 79;
  Mul 9 84; Sub 79 0; Add 0 93; Sub 9 68; Sub 7 66; Sub 5 64; Sub 3 62; Sub 93 98; Mul 0 84;
  Add 80 0; Mul 0 91; Mul 0 97; Sub 91 0; Add 0 93; Mul 3 97; Sub 94 0; Add 0 96; Mul 6 99;
  Sub 97 0; Add 0 99; Mul 9 104; Sub 13 0; Add 0 113; Sub 9 88; Sub 7 86; Sub 5 84; Sub 3 82;
  Unknown 8; Unknown 9; Unknown 10; Mul 2 139; Mul 2 139; Add 1 0; Add 0 3; Mul 145 145;
  Mul 145 145; Add 1 0; Sub 0 140; Mul 0 123; Neg 150; Neg 150; Mul 78 127; Mul 58 2; Add 1 0;
  Mul 40 3; Add 1 0; Mul 22 7; Add 1 0; Mul 84 134; Mul 64 9; Add 1 0; Mul 46 10; Add 1 0;
  Mul 28 14; Add 1 0; Mul 90 141; Mul 70 16; Add 1 0; Mul 52 17; Add 1 0; Mul 34 21; Add 1 0;
  Mul 96 148; Mul 76 23; Add 1 0; Mul 58 24; Add 1 0; Mul 40 28; Add 1 0; Mul 106 149; Mul 86 42;
  Add 1 0; Mul 68 43; Add 1 0; Mul 50 44; Add 1 0; Mul 112 156; Mul 92 49; Add 1 0; Mul 74 50;
  Add 1 0; Mul 56 51; Add 1 0; Mul 118 163; Mul 98 56; Add 1 0; Mul 80 57; Add 1 0; Mul 62 58;
  Add 1 0; Mul 124 170; Mul 104 63; Add 1 0; Mul 86 64; Add 1 0; Mul 68 65; Add 1 0; Add 21 162;
  Add 15 160; Add 9 158; Add 3 156; Div 187 53; Mul 4 0; Mul 0 48; Mul 1 42; Mul 2 36; Sub 7 2;
  Sub 7 2; Sub 7 2; Mul 218 218; Mul 218 218; Add 1 0; Sub 0 192; Mul 0 198; Neg 223; Neg 223;
  Mul 132 1; Add 75 0; Mul 114 2; Add 1 0; Mul 96 6; Add 1 0; Mul 137 7; Add 74 0; Mul 119 8;
  Add 1 0; Mul 101 12; Add 1 0; Mul 142 13; Add 73 0; Mul 124 14; Add 1 0; Mul 106 18; Add 1 0;
  Mul 147 19; Add 72 0; Mul 129 20; Add 1 0; Mul 111 24; Add 1 0; Mul 226 106; Neg 197; Neg 207;
  Mul 21 1; Mul 16 206; Add 1 0; Mul 12 205; Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Div 237 29;
  Neg 24; Mul 0 1; Neg 20; Mul 0 3; Mul 5 4; Mul 50 3; Mul 50 2; Add 1 0; Add 0 51; Sub 4 0;
  ShowZero 0; (* in the plane *)
  Neg 107; Mul 0 61; Neg 102; Mul 0 63; Mul 269 252; Mul 65 65; Mul 1 0; Sub 5 15; Sub 4 14;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* in the top view *)
  Mul 11 11; Mul 10 10; Add 1 0; Sub 0 9; Mul 0 264; Neg 16; Neg 15; Mul 198 1; Add 141 0;
  Mul 180 2; Add 1 0; Mul 162 6; Add 1 0; Mul 203 7; Add 140 0; Mul 185 8; Add 1 0; Mul 167 12;
  Add 1 0; Mul 210 87; Add 125 0; Mul 192 88; Add 1 0; Mul 174 89; Add 1 0; Mul 215 93; Add 124 0;
  Mul 197 94; Add 1 0; Mul 179 95; Add 1 0; Add 6 271; Add 1 269; Div 294 20; Mul 2 0; Mul 0 16;
  Sub 3 0; Sub 0 184;
  ShowZero 0; (* there and back: plane *)
  Mul 227 32; Add 158 0; Mul 209 33; Add 1 0; Mul 191 37; Add 1 0; Mul 233 112; Add 136 0;
  Mul 215 113; Add 1 0; Mul 197 114; Add 1 0; Add 0 284; Mul 16 7; Sub 1 0; Sub 0 199;
  ShowZero 0; (* there and back: plane *)
  Mul 242 48; Add 167 0; Mul 224 49; Add 1 0; Mul 206 53; Add 1 0; Mul 248 128; Add 145 0;
  Mul 230 129; Add 1 0; Mul 212 130; Add 1 0; Add 0 297; Mul 32 7; Sub 1 0; Sub 0 214;
  ShowZero 0; (* there and back: plane *)
  Neg 51; Mul 0 37; Sub 0 358;
  ShowZero 0; (* there and back: centre *)
  Neg 29; Mul 0 40; Sub 0 360;
  ShowZero 0; (* there and back: centre *)
  Mul 82 337; Mul 43 43; Mul 1 0; Sub 0 357;
  ShowZero 0 (* there and back: radius *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** circles of the top view; size 1.
    Code: src/scalar/ring.rs, src/space/moebius.rs, src/space/point.rs, src/space/similarity.rs *)
Definition part_3_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* r² != 0 *)
  Unknown 1; Unknown 2; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* the point does not lie on the axis *)
  Unknown 3; Unknown 4; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* the point does not lie on the axis *)
  Unknown 5; Unknown 6; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* the point does not lie on the axis *)
  Unknown 7; Unknown 8; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* the point does not lie on the axis *)
  Constant 0; Mul 0 0; Add 0 0; Sub 0 23; Constant 1; Div 0 26; Mul 2 0; Neg 6; Div 29 28;
  Sub 8 8; Neg 3; Neg 6; Mul 2 1; Mul 3 5; Add 1 0; Add 0 1; Mul 6 4; Add 1 0; Mul 0 9; Mul 0 14;
  Sub 10 0; Add 0 20; Mul 3 14; Sub 13 0; Add 0 23; Sub 20 24; Mul 0 15; Add 0 13; Add 0 14;
  Add 0 12; Mul 0 21; Mul 0 26; Sub 6 0; Add 0 32; Mul 3 26; Sub 25 0; Add 0 35; Sub 3 15;
  Sub 1 13; Mul 13 31; Add 27 0; Add 0 27; Add 0 25; Mul 0 34; Mul 0 39; Sub 35 0; Add 0 45;
  Mul 3 39; Sub 22 0; Add 0 48; Sub 40 2; Add 0 50; Sub 5 30; Sub 3 28; Sub 2 29; Add 40 15;
  Add 0 39; Mul 0 48; Mul 0 53; Sub 49 0; Add 0 59; Mul 3 53; Sub 52 0; Add 0 62; Sub 38 2;
  Add 0 64; Sub 5 44; Sub 3 42; Sub 2 43; Mul 43 57; Add 54 0; Mul 0 62; Mul 0 67; Sub 63 0;
  Add 0 73; Mul 3 67; Sub 66 0; Add 0 76; Sub 3 56; Sub 1 54; Sub 95 79; Mul 0 75; Neg 101;
  Neg 101; Mul 46 79; Mul 32 2; Add 1 0; Mul 20 3; Add 1 0; Mul 10 7; Add 1 0; Mul 52 86;
  Mul 38 9; Add 1 0; Mul 26 10; Add 1 0; Mul 16 14; Add 1 0; Mul 43 15; Add 7 0; Mul 31 16;
  Add 1 0; Add 0 5; Div 98 12; Neg 6; Mul 0 1; Neg 3; Mul 0 3; Mul 103 123; Sub 119 108;
  Mul 0 104; Neg 125; Neg 125; Mul 60 1; Add 29 0; Mul 48 2; Add 1 0; Mul 38 6; Add 1 0; Mul 65 7;
  Add 28 0; Mul 53 8; Add 1 0; Mul 43 12; Add 1 0; Mul 70 13; Add 34 0; Mul 58 14; Add 1 0;
  Add 0 5; Div 125 11; Neg 6; Mul 0 1; Neg 3; Mul 0 3; Mul 26 145; Sub 141 135; Mul 0 131;
  Neg 147; Neg 147; Mul 87 1; Add 56 0; Mul 75 2; Add 1 0; Mul 65 6; Add 1 0; Mul 92 7; Add 55 0;
  Mul 80 8; Add 1 0; Mul 70 12; Add 1 0; Mul 97 13; Add 61 0; Mul 85 14; Add 1 0; Add 0 5;
  Div 152 11; Neg 6; Mul 0 1; Neg 3; Mul 0 3; Mul 26 167; Sub 163 162; Mul 0 158; Neg 169;
  Neg 169; Mul 114 1; Add 83 0; Mul 102 2; Add 1 0; Mul 92 6; Add 1 0; Mul 119 7; Add 82 0;
  Mul 107 8; Add 1 0; Mul 97 12; Add 1 0; Mul 124 13; Add 88 0; Mul 112 14; Add 1 0; Add 0 5;
  Div 179 11; Neg 6; Mul 0 1; Neg 3; Mul 0 3; Mul 26 189; Sub 204 209; Sub 204 209; Sub 201 211;
  Sub 201 211; Sub 198 213; Sub 198 213; Mul 5 5; Mul 5 5; Add 1 0; Mul 6 6; Mul 6 6; Add 1 0;
  Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12; Sub 1 0; Mul 3 15; Mul 14 7; Sub 1 0; Mul 16 17;
  Mul 16 19; Sub 1 0; Mul 23 6; Mul 23 4; Add 1 0; Mul 18 3; Add 1 0; Sub 86 113; Sub 85 112;
  Sub 61 115; Sub 60 114; Sub 36 117; Sub 35 116; Mul 5 5; Mul 5 5; Add 1 0; Mul 6 6; Mul 6 6;
  Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12; Sub 1 0; Mul 3 15; Mul 14 7; Sub 1 0;
  Mul 16 17; Mul 16 19; Sub 1 0; Mul 23 6; Mul 23 4; Add 1 0; Mul 18 3; Add 1 0; Mul 268 268;
  Mul 0 0; Mul 2 60; Mul 32 1; Add 1 0;
  ShowZero 0 (* circles to circles *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
