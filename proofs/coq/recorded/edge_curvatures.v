(** edge-curvatures (ours)

    Areas of parallel faces are sums over their edges and the ratios κ of edges of S to those of M;
    for a quad H and K are means of those of two opposite corners, weighted by their triangles,
    whichever two are taken. Under duality κ becomes 1/κ.

        2 area(F, S) = Σ ½ (κ_i + κ_j) det(e_i, e_j),  2 area(S) = Σ κ_i κ_j det(e_i, e_j),  i < j < k - 1

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** parallel k-gons in space; size 3.
    Code: src/pair/edge.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Mul 1 1;
  Mul 1 1; Add 1 0; Mul 6 4; Mul 6 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 6; Unknown 7; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0; Mul 18 4; Mul 18 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Sub 27 11; Sub 27 11; Mul 1 1; Mul 1 1; Add 1 0; Mul 28 4; Mul 28 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 8; Constant 0; Mul 33 1; Mul 33 2; Add 2 1; Add 3 1; Mul 39 43; Mul 39 43; Add 1 0;
  Add 0 7; Mul 43 45; Mul 43 45; Add 1 0; Add 0 11; Mul 47 12; Mul 47 13; Add 1 0; Add 0 15;
  Mul 51 13; Mul 51 13; Add 1 0; Add 0 19; Sub 8 12; Sub 17 21; Sub 2 6; Mul 55 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 23 26; Mul 6 0; Mul 61 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 63 8; Mul 63 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 54 34; Mul 54 35; Add 32 1; Add 32 1; Mul 72 60; Mul 72 60; Add 1 0; Add 0 40; Mul 76 5;
  Mul 76 5; Add 1 0; Add 0 44; Sub 4 33; Sub 9 42; Sub 2 27; Mul 68 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 48; Mul 6 0; Mul 74 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 76 8; Mul 76 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 50 17; Sub 59 22; Sub 44 15; Mul 71 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 64 28; Mul 6 0; Mul 77 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 79 8; Mul 79 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 104 44; Mul 104 50; Add 1 0; Mul 53 51; Add 1 0; Mul 55 55; Add 106 0; Div 2 0; Sub 0 80;
  ShowZero 0; (* κ *)
  Mul 101 28; Mul 101 34; Add 1 0; Mul 37 35; Add 1 0; Mul 39 39; Add 103 0; Div 2 0; Sub 0 89;
  ShowZero 0; (* κ *)
  Mul 100 24; Mul 100 30; Add 1 0; Mul 33 31; Add 1 0; Mul 35 35; Add 102 0; Div 2 0; Sub 0 98;
  ShowZero 0; (* κ *)
  Mul 131 118; Mul 131 120; Sub 1 0; Add 101 0; Sub 125 141; Sub 125 141; Mul 137 0; Mul 137 2;
  Sub 1 0; Add 107 0; Mul 0 148; Constant 1; Div 0 150; Mul 2 0; Sub 10 0;
  ShowZero 0; (* 2 area(F) *)
  Add 34 25; Mul 13 0; Mul 0 4; Add 116 0; Sub 81 117; Sub 81 118; Mul 152 0; Mul 152 2; Sub 1 0;
  Mul 95 18; Mul 101 20; Sub 1 0; Add 3 0; Add 126 0; Mul 0 16; Sub 11 0;
  ShowZero 0; (* 2 area(F, S) *)
  Mul 28 50; Mul 0 42; Add 131 0; Mul 105 13; Mul 111 15; Sub 1 0; Add 135 0; Mul 0 176; Mul 0 26;
  Sub 6 0;
  ShowZero 0 (* 2 area(S) *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** parallel k-gons in space; size 4.
    Code: src/pair/edge.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Sub 3 16; Sub 3 16; Mul 1 1; Mul 1 1; Add 1 0;
  Mul 6 4; Mul 6 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Sub 24 13; Sub 24 13; Mul 1 1; Mul 1 1; Add 1 0; Mul 16 4; Mul 16 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 30 30; Mul 30 30; Add 1 0; Mul 24 33; Mul 24 33; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 36 36; Mul 36 36; Add 1 0; Mul 32 39; Mul 32 39; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 10; Constant 0; Mul 37 1; Mul 37 2; Add 2 1; Add 3 1; Mul 43 58; Mul 43 58; Add 1 0;
  Add 0 7; Mul 47 49; Mul 47 49; Add 1 0; Add 0 11; Mul 51 12; Mul 51 13; Add 1 0; Add 0 15;
  Mul 55 13; Mul 55 13; Add 1 0; Add 0 19; Sub 8 12; Sub 17 21; Sub 2 6; Mul 59 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 23 26; Mul 6 0; Mul 65 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 67 8; Mul 67 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 11; Mul 61 0; Mul 61 1; Add 33 1; Add 33 1; Mul 77 90; Mul 77 90; Add 1 0; Add 0 41;
  Mul 81 5; Mul 81 5; Add 1 0; Add 0 45; Sub 4 34; Sub 9 43; Sub 2 28; Mul 75 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 49; Mul 6 0; Mul 81 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 83 8; Mul 83 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 59 22; Sub 60 22; Mul 1 106; Mul 1 108; Sub 1 0; Div 0 106; Mul 113 0; Mul 113 1; Add 30 1;
  Add 30 1; Mul 108 119; Mul 108 119; Add 1 0; Add 0 72; Mul 112 5; Mul 112 5; Add 1 0; Add 0 76;
  Sub 4 35; Sub 9 40; Sub 2 33; Mul 127 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 46; Mul 6 0; Mul 133 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 135 8; Mul 135 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 82 17; Sub 91 22; Sub 76 15; Mul 138 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 96 28; Mul 6 0; Mul 144 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 146 8; Mul 146 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 140 76; Mul 140 82; Add 1 0; Mul 85 83; Add 1 0; Mul 87 87; Add 142 0; Div 2 0; Sub 0 112;
  ShowZero 0; (* κ *)
  Mul 139 59; Mul 139 65; Add 1 0; Mul 68 66; Add 1 0; Mul 70 70; Add 141 0; Div 2 0; Sub 0 86;
  ShowZero 0; (* κ *)
  Mul 169 37; Mul 169 43; Add 1 0; Mul 46 44; Add 1 0; Mul 48 48; Add 142 0; Div 2 0; Sub 0 64;
  ShowZero 0; (* κ *)
  Mul 178 69; Mul 178 71; Sub 1 0; Div 0 175; Mul 180 37; Mul 180 43; Add 1 0; Mul 46 44; Add 1 0;
  Mul 48 48; Add 147 0; Div 2 0; Sub 0 8;
  ShowZero 0; (* κ *)
  Mul 180 169; Mul 180 171; Sub 1 0; Add 146 0; Mul 184 194; Mul 184 196; Sub 1 0; Add 3 0;
  Mul 178 198; Mul 178 200; Sub 1 0; Add 3 0; Sub 207 209; Sub 207 209; Mul 194 0; Mul 194 2;
  Sub 1 0; Add 160 0; Sub 211 215; Sub 211 215; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 222;
  Constant 1; Div 0 224; Mul 2 0; Sub 16 0;
  ShowZero 0; (* 2 area(F) *)
  Add 61 52; Mul 27 0; Mul 0 4; Add 175 0; Add 65 47; Mul 27 0; Mul 0 8; Add 3 0; Add 60 51;
  Mul 27 0; Mul 0 12; Add 3 0; Sub 147 184; Sub 147 185; Mul 223 0; Mul 223 2; Sub 1 0;
  Mul 162 32; Mul 168 34; Sub 1 0; Add 3 0; Add 193 0; Sub 126 194; Sub 126 195; Mul 40 0;
  Mul 40 2; Sub 1 0; Mul 14 36; Mul 14 38; Sub 1 0; Add 3 0; Add 9 0; Mul 0 34; Sub 21 0;
  ShowZero 0; (* 2 area(F, S) *)
  Mul 60 95; Mul 0 87; Add 208 0; Mul 59 98; Mul 0 81; Add 2 0; Mul 58 92; Mul 0 84; Add 2 0;
  Mul 188 29; Mul 194 31; Sub 1 0; Add 218 0; Mul 34 23; Mul 34 25; Sub 1 0; Add 3 0; Mul 0 278;
  Mul 0 54; Sub 10 0;
  ShowZero 0; (* 2 area(S) *)
  Mul 53 56; Mul 81 0; Add 228 0; Add 100 87; Mul 0 60; Mul 273 0; Add 3 0; Sub 0 28;
  ShowZero 0; (* H of two corners *)
  Mul 123 114; Mul 89 0; Add 236 0; Mul 108 95; Mul 280 0; Add 2 0; Sub 0 15;
  ShowZero 0; (* K of two corners *)
  Mul 60 71; Mul 88 0; Add 243 0; Add 102 133; Mul 0 75; Mul 292 282; Mul 292 284; Sub 1 0;
  Mul 0 3; Add 6 0; Sub 0 46;
  ShowZero 0; (* H of two corners *)
  Mul 132 123; Mul 99 0; Add 254 0; Mul 113 144; Mul 7 0; Add 2 0; Sub 0 33;
  ShowZero 0 (* K of two corners *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** parallel k-gons in space; size 5.
    Code: src/pair/edge.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_5 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Sub 3 16; Sub 3 16; Mul 1 1; Mul 1 1; Add 1 0;
  Mul 6 4; Mul 6 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 10; Unknown 11; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0; Mul 18 4; Mul 18 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Sub 36 11; Sub 36 11; Mul 1 1; Mul 1 1; Add 1 0; Mul 28 4; Mul 28 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 42 42; Mul 42 42; Add 1 0; Mul 36 45; Mul 36 45; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 48 48; Mul 48 48; Add 1 0; Mul 44 51; Mul 44 51; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 12; Constant 0; Mul 49 1; Mul 49 2; Add 2 1; Add 3 1; Mul 55 70; Mul 55 70; Add 1 0;
  Add 0 7; Mul 59 61; Mul 59 61; Add 1 0; Add 0 11; Mul 63 12; Mul 63 13; Add 1 0; Add 0 15;
  Mul 67 13; Mul 67 13; Add 1 0; Add 0 19; Sub 8 12; Sub 17 21; Sub 2 6; Mul 71 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 23 26; Mul 6 0; Mul 77 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 79 8; Mul 79 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 13; Mul 71 0; Mul 71 1; Add 33 1; Add 33 1; Mul 89 77; Mul 89 77; Add 1 0; Add 0 41;
  Mul 93 5; Mul 93 5; Add 1 0; Add 0 45; Sub 4 34; Sub 9 43; Sub 2 28; Mul 85 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 49; Mul 6 0; Mul 91 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 93 8; Mul 93 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 14; Mul 87 0; Mul 87 1; Add 25 1; Add 25 1; Mul 115 128; Mul 115 128; Add 1 0; Add 0 67;
  Mul 119 5; Mul 119 5; Add 1 0; Add 0 71; Sub 4 30; Sub 9 35; Sub 2 28; Mul 101 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 107 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 109 8; Mul 109 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 85 22; Sub 86 22; Mul 1 144; Mul 1 146; Sub 1 0; Div 0 144; Mul 151 0; Mul 151 1; Add 30 1;
  Add 30 1; Mul 146 157; Mul 146 157; Add 1 0; Add 0 98; Mul 150 5; Mul 150 5; Add 1 0; Add 0 102;
  Sub 4 35; Sub 9 40; Sub 2 33; Mul 165 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 46; Mul 6 0; Mul 171 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 173 8; Mul 173 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 108 17; Sub 117 22; Sub 102 15; Mul 176 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 122 28; Mul 6 0; Mul 182 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 184 8; Mul 184 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 178 102; Mul 178 108; Add 1 0; Mul 111 109; Add 1 0; Mul 113 113; Add 180 0; Div 2 0;
  Sub 0 138;
  ShowZero 0; (* κ *)
  Mul 175 85; Mul 175 91; Add 1 0; Mul 94 92; Add 1 0; Mul 96 96; Add 177 0; Div 2 0; Sub 0 112;
  ShowZero 0; (* κ *)
  Mul 174 68; Mul 174 74; Add 1 0; Mul 77 75; Add 1 0; Mul 79 79; Add 176 0; Div 2 0; Sub 0 95;
  ShowZero 0; (* κ *)
  Mul 216 46; Mul 216 52; Add 1 0; Mul 55 53; Add 1 0; Mul 57 57; Add 177 0; Div 2 0; Sub 0 73;
  ShowZero 0; (* κ *)
  Mul 225 78; Mul 225 80; Sub 1 0; Div 0 222; Mul 227 46; Mul 227 52; Add 1 0; Mul 55 53; Add 1 0;
  Mul 57 57; Add 182 0; Div 2 0; Sub 0 8;
  ShowZero 0; (* κ *)
  Mul 227 214; Mul 227 216; Sub 1 0; Add 181 0; Mul 231 208; Mul 231 210; Sub 1 0; Add 3 0;
  Mul 223 212; Mul 223 214; Sub 1 0; Add 3 0; Mul 239 249; Mul 239 251; Sub 1 0; Add 3 0;
  Mul 231 253; Mul 231 255; Sub 1 0; Add 3 0; Mul 225 257; Mul 225 259; Sub 1 0; Add 3 0;
  Sub 241 268; Sub 241 268; Mul 253 0; Mul 253 2; Sub 1 0; Add 207 0; Sub 272 274; Sub 272 274;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 276 280; Sub 276 280; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Mul 0 287; Constant 1; Div 0 289; Mul 2 0; Sub 22 0;
  ShowZero 0; (* 2 area(F) *)
  Add 88 79; Mul 45 0; Mul 0 4; Add 228 0; Add 92 74; Mul 45 0; Mul 0 8; Add 3 0; Add 87 78;
  Mul 45 0; Mul 0 12; Add 3 0; Add 100 73; Mul 45 0; Mul 0 16; Add 3 0; Add 95 77; Mul 45 0;
  Mul 0 20; Add 3 0; Add 90 81; Mul 45 0; Mul 0 24; Add 3 0; Sub 212 249; Sub 212 250; Mul 300 0;
  Mul 300 2; Sub 1 0; Mul 227 50; Mul 233 52; Sub 1 0; Add 3 0; Add 258 0; Sub 196 259;
  Sub 196 260; Mul 58 0; Mul 58 2; Sub 1 0; Mul 14 54; Mul 14 56; Sub 1 0; Add 3 0; Add 9 0;
  Sub 175 269; Sub 175 270; Mul 62 0; Mul 62 2; Sub 1 0; Mul 14 58; Mul 14 60; Sub 1 0; Add 3 0;
  Add 9 0; Mul 0 56; Sub 31 0;
  ShowZero 0; (* 2 area(F, S) *)
  Mul 100 144; Mul 0 136; Add 283 0; Mul 99 147; Mul 0 130; Add 2 0; Mul 98 141; Mul 0 133;
  Add 2 0; Mul 97 153; Mul 0 127; Add 2 0; Mul 96 147; Mul 0 130; Add 2 0; Mul 95 141; Mul 0 133;
  Add 2 0; Mul 272 48; Mul 278 50; Sub 1 0; Add 302 0; Mul 53 42; Mul 53 44; Sub 1 0; Add 3 0;
  Mul 47 36; Mul 47 38; Sub 1 0; Add 3 0; Mul 0 378; Mul 0 89; Sub 14 0;
  ShowZero 0 (* 2 area(S) *)
].

Theorem part_1_size_5_valid : valid part_1_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** parallel k-gons in space; size 6.
    Code: src/pair/edge.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_6 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Sub 3 16; Sub 3 16; Mul 1 1; Mul 1 1; Add 1 0;
  Mul 6 4; Mul 6 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 10; Unknown 11; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0; Mul 18 4; Mul 18 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 12; Unknown 13; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0; Mul 30 4; Mul 30 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Sub 48 11; Sub 48 11; Mul 1 1; Mul 1 1; Add 1 0; Mul 40 4; Mul 40 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 54 54; Mul 54 54; Add 1 0; Mul 48 57; Mul 48 57; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 60 60; Mul 60 60; Add 1 0; Mul 56 63; Mul 56 63; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 14; Constant 0; Mul 61 1; Mul 61 2; Add 2 1; Add 3 1; Mul 67 82; Mul 67 82; Add 1 0;
  Add 0 7; Mul 71 73; Mul 71 73; Add 1 0; Add 0 11; Mul 75 12; Mul 75 13; Add 1 0; Add 0 15;
  Mul 79 13; Mul 79 13; Add 1 0; Add 0 19; Sub 8 12; Sub 17 21; Sub 2 6; Mul 83 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 23 26; Mul 6 0; Mul 89 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 91 8; Mul 91 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 15; Mul 83 0; Mul 83 1; Add 33 1; Add 33 1; Mul 101 89; Mul 101 89; Add 1 0; Add 0 41;
  Mul 105 5; Mul 105 5; Add 1 0; Add 0 45; Sub 4 34; Sub 9 43; Sub 2 28; Mul 97 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 49; Mul 6 0; Mul 103 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 105 8; Mul 105 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 16; Mul 97 0; Mul 97 1; Add 25 1; Add 25 1; Mul 127 103; Mul 127 103; Add 1 0; Add 0 67;
  Mul 131 5; Mul 131 5; Add 1 0; Add 0 71; Sub 4 30; Sub 9 35; Sub 2 28; Mul 111 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 117 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 119 8; Mul 119 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 17; Mul 113 0; Mul 113 1; Add 25 1; Add 25 1; Mul 153 166; Mul 153 166; Add 1 0;
  Add 0 93; Mul 157 5; Mul 157 5; Add 1 0; Add 0 97; Sub 4 30; Sub 9 35; Sub 2 28; Mul 127 0;
  Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 133 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 135 8; Mul 135 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 111 22; Sub 112 22; Mul 1 182; Mul 1 184; Sub 1 0; Div 0 182; Mul 189 0; Mul 189 1;
  Add 30 1; Add 30 1; Mul 184 195; Mul 184 195; Add 1 0; Add 0 124; Mul 188 5; Mul 188 5; Add 1 0;
  Add 0 128; Sub 4 35; Sub 9 40; Sub 2 33; Mul 203 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 46; Mul 6 0; Mul 209 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 211 8; Mul 211 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 134 17; Sub 143 22; Sub 128 15; Mul 214 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 148 28; Mul 6 0; Mul 220 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 222 8; Mul 222 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 216 128; Mul 216 134; Add 1 0; Mul 137 135; Add 1 0; Mul 139 139; Add 218 0; Div 2 0;
  Sub 0 164;
  ShowZero 0; (* κ *)
  Mul 213 111; Mul 213 117; Add 1 0; Mul 120 118; Add 1 0; Mul 122 122; Add 215 0; Div 2 0;
  Sub 0 138;
  ShowZero 0; (* κ *)
  Mul 210 94; Mul 210 100; Add 1 0; Mul 103 101; Add 1 0; Mul 105 105; Add 212 0; Div 2 0;
  Sub 0 121;
  ShowZero 0; (* κ *)
  Mul 209 77; Mul 209 83; Add 1 0; Mul 86 84; Add 1 0; Mul 88 88; Add 211 0; Div 2 0; Sub 0 104;
  ShowZero 0; (* κ *)
  Mul 263 55; Mul 263 61; Add 1 0; Mul 64 62; Add 1 0; Mul 66 66; Add 212 0; Div 2 0; Sub 0 82;
  ShowZero 0; (* κ *)
  Mul 272 87; Mul 272 89; Sub 1 0; Div 0 269; Mul 274 55; Mul 274 61; Add 1 0; Mul 64 62; Add 1 0;
  Mul 66 66; Add 217 0; Div 2 0; Sub 0 8;
  ShowZero 0; (* κ *)
  Mul 274 261; Mul 274 263; Sub 1 0; Add 216 0; Mul 278 253; Mul 278 255; Sub 1 0; Add 3 0;
  Mul 270 257; Mul 270 259; Sub 1 0; Add 3 0; Mul 286 251; Mul 286 253; Sub 1 0; Add 3 0;
  Mul 278 255; Mul 278 257; Sub 1 0; Add 3 0; Mul 270 259; Mul 270 261; Sub 1 0; Add 3 0;
  Mul 298 308; Mul 298 310; Sub 1 0; Add 3 0; Mul 290 312; Mul 290 314; Sub 1 0; Add 3 0;
  Mul 282 316; Mul 282 318; Sub 1 0; Add 3 0; Mul 276 320; Mul 276 322; Sub 1 0; Add 3 0;
  Sub 304 331; Sub 304 331; Mul 316 0; Mul 316 2; Sub 1 0; Add 258 0; Sub 298 337; Sub 298 337;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 341 343; Sub 341 343; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Sub 345 349; Sub 345 349; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 356; Constant 1;
  Div 0 358; Mul 2 0; Sub 28 0;
  ShowZero 0; (* 2 area(F) *)
  Add 119 110; Mul 67 0; Mul 0 4; Add 285 0; Add 123 105; Mul 67 0; Mul 0 8; Add 3 0; Add 118 109;
  Mul 67 0; Mul 0 12; Add 3 0; Add 131 104; Mul 67 0; Mul 0 16; Add 3 0; Add 126 108; Mul 67 0;
  Mul 0 20; Add 3 0; Add 121 112; Mul 67 0; Mul 0 24; Add 3 0; Add 143 107; Mul 67 0; Mul 0 28;
  Add 3 0; Add 138 111; Mul 67 0; Mul 0 32; Add 3 0; Add 133 115; Mul 67 0; Mul 0 36; Add 3 0;
  Add 128 119; Mul 67 0; Mul 0 40; Add 3 0; Sub 285 322; Sub 285 323; Mul 385 0; Mul 385 2;
  Sub 1 0; Mul 300 72; Mul 306 74; Sub 1 0; Add 3 0; Add 331 0; Sub 269 332; Sub 269 333;
  Mul 80 0; Mul 80 2; Sub 1 0; Mul 14 76; Mul 14 78; Sub 1 0; Add 3 0; Add 9 0; Sub 253 342;
  Sub 253 343; Mul 84 0; Mul 84 2; Sub 1 0; Mul 14 80; Mul 14 82; Sub 1 0; Add 3 0; Add 9 0;
  Sub 232 352; Sub 232 353; Mul 88 0; Mul 88 2; Sub 1 0; Mul 14 84; Mul 14 86; Sub 1 0; Add 3 0;
  Add 9 0; Mul 0 82; Sub 41 0;
  ShowZero 0; (* 2 area(F, S) *)
  Mul 148 201; Mul 0 193; Add 366 0; Mul 147 204; Mul 0 187; Add 2 0; Mul 146 198; Mul 0 190;
  Add 2 0; Mul 145 210; Mul 0 184; Add 2 0; Mul 144 204; Mul 0 187; Add 2 0; Mul 143 198;
  Mul 0 190; Add 2 0; Mul 142 219; Mul 0 184; Add 2 0; Mul 141 213; Mul 0 187; Add 2 0;
  Mul 140 207; Mul 0 190; Add 2 0; Mul 139 201; Mul 0 193; Add 2 0; Mul 367 70; Mul 373 72;
  Sub 1 0; Add 397 0; Mul 75 64; Mul 75 66; Sub 1 0; Add 3 0; Mul 69 58; Mul 69 60; Sub 1 0;
  Add 3 0; Mul 63 52; Mul 63 54; Sub 1 0; Add 3 0; Mul 0 489; Mul 0 131; Sub 18 0;
  ShowZero 0 (* 2 area(S) *)
].

Theorem part_1_size_6_valid : valid part_1_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** parallel k-gons in space; size 7.
    Code: src/pair/edge.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_7 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Sub 3 16; Sub 3 16; Mul 1 1; Mul 1 1; Add 1 0;
  Mul 6 4; Mul 6 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 10; Unknown 11; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0; Mul 18 4; Mul 18 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 12; Unknown 13; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0; Mul 30 4; Mul 30 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 14; Unknown 15; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0; Mul 42 4; Mul 42 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Sub 60 11; Sub 60 11; Mul 1 1; Mul 1 1; Add 1 0; Mul 52 4; Mul 52 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 66 66; Mul 66 66; Add 1 0; Mul 60 69; Mul 60 69; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 72 72; Mul 72 72; Add 1 0; Mul 68 75; Mul 68 75; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 16; Constant 0; Mul 73 1; Mul 73 2; Add 2 1; Add 3 1; Mul 79 94; Mul 79 94; Add 1 0;
  Add 0 7; Mul 83 85; Mul 83 85; Add 1 0; Add 0 11; Mul 87 12; Mul 87 13; Add 1 0; Add 0 15;
  Mul 91 13; Mul 91 13; Add 1 0; Add 0 19; Sub 8 12; Sub 17 21; Sub 2 6; Mul 95 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 23 26; Mul 6 0; Mul 101 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 103 8; Mul 103 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 17; Mul 95 0; Mul 95 1; Add 33 1; Add 33 1; Mul 113 101; Mul 113 101; Add 1 0; Add 0 41;
  Mul 117 5; Mul 117 5; Add 1 0; Add 0 45; Sub 4 34; Sub 9 43; Sub 2 28; Mul 109 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 49; Mul 6 0; Mul 115 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 117 8; Mul 117 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 18; Mul 109 0; Mul 109 1; Add 25 1; Add 25 1; Mul 139 115; Mul 139 115; Add 1 0;
  Add 0 67; Mul 143 5; Mul 143 5; Add 1 0; Add 0 71; Sub 4 30; Sub 9 35; Sub 2 28; Mul 123 0;
  Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 129 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 131 8; Mul 131 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 19; Mul 123 0; Mul 123 1; Add 25 1; Add 25 1; Mul 165 129; Mul 165 129; Add 1 0;
  Add 0 93; Mul 169 5; Mul 169 5; Add 1 0; Add 0 97; Sub 4 30; Sub 9 35; Sub 2 28; Mul 137 0;
  Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 143 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 145 8; Mul 145 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 20; Mul 139 0; Mul 139 1; Add 25 1; Add 25 1; Mul 191 204; Mul 191 204; Add 1 0;
  Add 0 119; Mul 195 5; Mul 195 5; Add 1 0; Add 0 123; Sub 4 30; Sub 9 35; Sub 2 28; Mul 153 0;
  Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 159 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 161 8; Mul 161 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 137 22; Sub 138 22; Mul 1 220; Mul 1 222; Sub 1 0; Div 0 220; Mul 227 0; Mul 227 1;
  Add 30 1; Add 30 1; Mul 222 233; Mul 222 233; Add 1 0; Add 0 150; Mul 226 5; Mul 226 5; Add 1 0;
  Add 0 154; Sub 4 35; Sub 9 40; Sub 2 33; Mul 241 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 46; Mul 6 0; Mul 247 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 249 8; Mul 249 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 160 17; Sub 169 22; Sub 154 15; Mul 252 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 174 28; Mul 6 0; Mul 258 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 260 8; Mul 260 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 254 154; Mul 254 160; Add 1 0; Mul 163 161; Add 1 0; Mul 165 165; Add 256 0; Div 2 0;
  Sub 0 190;
  ShowZero 0; (* κ *)
  Mul 251 137; Mul 251 143; Add 1 0; Mul 146 144; Add 1 0; Mul 148 148; Add 253 0; Div 2 0;
  Sub 0 164;
  ShowZero 0; (* κ *)
  Mul 248 120; Mul 248 126; Add 1 0; Mul 129 127; Add 1 0; Mul 131 131; Add 250 0; Div 2 0;
  Sub 0 147;
  ShowZero 0; (* κ *)
  Mul 245 103; Mul 245 109; Add 1 0; Mul 112 110; Add 1 0; Mul 114 114; Add 247 0; Div 2 0;
  Sub 0 130;
  ShowZero 0; (* κ *)
  Mul 244 86; Mul 244 92; Add 1 0; Mul 95 93; Add 1 0; Mul 97 97; Add 246 0; Div 2 0; Sub 0 113;
  ShowZero 0; (* κ *)
  Mul 310 64; Mul 310 70; Add 1 0; Mul 73 71; Add 1 0; Mul 75 75; Add 247 0; Div 2 0; Sub 0 91;
  ShowZero 0; (* κ *)
  Mul 319 96; Mul 319 98; Sub 1 0; Div 0 316; Mul 321 64; Mul 321 70; Add 1 0; Mul 73 71; Add 1 0;
  Mul 75 75; Add 252 0; Div 2 0; Sub 0 8;
  ShowZero 0; (* κ *)
  Mul 321 308; Mul 321 310; Sub 1 0; Add 251 0; Mul 325 300; Mul 325 302; Sub 1 0; Add 3 0;
  Mul 317 304; Mul 317 306; Sub 1 0; Add 3 0; Mul 333 296; Mul 333 298; Sub 1 0; Add 3 0;
  Mul 325 300; Mul 325 302; Sub 1 0; Add 3 0; Mul 317 304; Mul 317 306; Sub 1 0; Add 3 0;
  Mul 345 298; Mul 345 300; Sub 1 0; Add 3 0; Mul 337 302; Mul 337 304; Sub 1 0; Add 3 0;
  Mul 329 306; Mul 329 308; Sub 1 0; Add 3 0; Mul 321 310; Mul 321 312; Sub 1 0; Add 3 0;
  Mul 361 371; Mul 361 373; Sub 1 0; Add 3 0; Mul 353 375; Mul 353 377; Sub 1 0; Add 3 0;
  Mul 345 379; Mul 345 381; Sub 1 0; Add 3 0; Mul 337 383; Mul 337 385; Sub 1 0; Add 3 0;
  Mul 331 387; Mul 331 389; Sub 1 0; Add 3 0; Sub 371 398; Sub 371 398; Mul 383 0; Mul 383 2;
  Sub 1 0; Add 313 0; Sub 365 404; Sub 365 404; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 359 410;
  Sub 359 410; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 414 416; Sub 414 416; Mul 7 0; Mul 7 2;
  Sub 1 0; Add 5 0; Sub 418 422; Sub 418 422; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 429;
  Constant 1; Div 0 431; Mul 2 0; Sub 34 0;
  ShowZero 0; (* 2 area(F) *)
  Add 154 145; Mul 93 0; Mul 0 4; Add 346 0; Add 158 140; Mul 93 0; Mul 0 8; Add 3 0; Add 153 144;
  Mul 93 0; Mul 0 12; Add 3 0; Add 166 139; Mul 93 0; Mul 0 16; Add 3 0; Add 161 143; Mul 93 0;
  Mul 0 20; Add 3 0; Add 156 147; Mul 93 0; Mul 0 24; Add 3 0; Add 178 142; Mul 93 0; Mul 0 28;
  Add 3 0; Add 173 146; Mul 93 0; Mul 0 32; Add 3 0; Add 168 150; Mul 93 0; Mul 0 36; Add 3 0;
  Add 163 154; Mul 93 0; Mul 0 40; Add 3 0; Add 194 149; Mul 93 0; Mul 0 44; Add 3 0; Add 189 153;
  Mul 93 0; Mul 0 48; Add 3 0; Add 184 157; Mul 93 0; Mul 0 52; Add 3 0; Add 179 161; Mul 93 0;
  Mul 0 56; Add 3 0; Add 174 165; Mul 93 0; Mul 0 60; Add 3 0; Sub 366 403; Sub 366 404;
  Mul 478 0; Mul 478 2; Sub 1 0; Mul 381 98; Mul 387 100; Sub 1 0; Add 3 0; Add 412 0;
  Sub 350 413; Sub 350 414; Mul 106 0; Mul 106 2; Sub 1 0; Mul 14 102; Mul 14 104; Sub 1 0;
  Add 3 0; Add 9 0; Sub 334 423; Sub 334 424; Mul 110 0; Mul 110 2; Sub 1 0; Mul 14 106;
  Mul 14 108; Sub 1 0; Add 3 0; Add 9 0; Sub 318 433; Sub 318 434; Mul 114 0; Mul 114 2; Sub 1 0;
  Mul 14 110; Mul 14 112; Sub 1 0; Add 3 0; Add 9 0; Sub 297 443; Sub 297 444; Mul 118 0;
  Mul 118 2; Sub 1 0; Mul 14 114; Mul 14 116; Sub 1 0; Add 3 0; Add 9 0; Mul 0 112; Sub 51 0;
  ShowZero 0; (* 2 area(F, S) *)
  Mul 204 266; Mul 0 258; Add 457 0; Mul 203 269; Mul 0 252; Add 2 0; Mul 202 263; Mul 0 255;
  Add 2 0; Mul 201 275; Mul 0 249; Add 2 0; Mul 200 269; Mul 0 252; Add 2 0; Mul 199 263;
  Mul 0 255; Add 2 0; Mul 198 284; Mul 0 249; Add 2 0; Mul 197 278; Mul 0 252; Add 2 0;
  Mul 196 272; Mul 0 255; Add 2 0; Mul 195 266; Mul 0 258; Add 2 0; Mul 194 296; Mul 0 252;
  Add 2 0; Mul 193 290; Mul 0 255; Add 2 0; Mul 192 284; Mul 0 258; Add 2 0; Mul 191 278;
  Mul 0 261; Add 2 0; Mul 190 272; Mul 0 264; Add 2 0; Mul 473 95; Mul 479 97; Sub 1 0; Add 503 0;
  Mul 100 89; Mul 100 91; Sub 1 0; Add 3 0; Mul 94 83; Mul 94 85; Sub 1 0; Add 3 0; Mul 88 77;
  Mul 88 79; Sub 1 0; Add 3 0; Mul 82 71; Mul 82 73; Sub 1 0; Add 3 0; Mul 0 611; Mul 0 180;
  Sub 22 0;
  ShowZero 0 (* 2 area(S) *)
].

Theorem part_1_size_7_valid : valid part_1_size_7.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** parallel k-gons in space; size 8.
    Code: src/pair/edge.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_8 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Sub 3 16; Sub 3 16; Mul 1 1; Mul 1 1; Add 1 0;
  Mul 6 4; Mul 6 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 10; Unknown 11; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0; Mul 18 4; Mul 18 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 12; Unknown 13; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0; Mul 30 4; Mul 30 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 14; Unknown 15; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0; Mul 42 4; Mul 42 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 16; Unknown 17; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0; Mul 54 4; Mul 54 4;
  Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Sub 72 11; Sub 72 11; Mul 1 1; Mul 1 1; Add 1 0; Mul 64 4; Mul 64 4; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 78 78; Mul 78 78; Add 1 0; Mul 72 81; Mul 72 81; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Mul 84 84; Mul 84 84; Add 1 0; Mul 80 87; Mul 80 87; Add 1 0; Mul 0 0; Add 4 0;
  Nonzero 0; (* no edge of M has length 0 *)
  Unknown 18; Constant 0; Mul 85 1; Mul 85 2; Add 2 1; Add 3 1; Mul 91 106; Mul 91 106; Add 1 0;
  Add 0 7; Mul 95 97; Mul 95 97; Add 1 0; Add 0 11; Mul 99 12; Mul 99 13; Add 1 0; Add 0 15;
  Mul 103 13; Mul 103 13; Add 1 0; Add 0 19; Sub 8 12; Sub 17 21; Sub 2 6; Mul 107 0; Mul 3 2;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 23 26; Mul 6 0; Mul 113 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 115 8; Mul 115 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 19; Mul 107 0; Mul 107 1; Add 33 1; Add 33 1; Mul 125 113; Mul 125 113; Add 1 0;
  Add 0 41; Mul 129 5; Mul 129 5; Add 1 0; Add 0 45; Sub 4 34; Sub 9 43; Sub 2 28; Mul 121 0;
  Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 49; Mul 6 0; Mul 127 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 129 8; Mul 129 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 20; Mul 121 0; Mul 121 1; Add 25 1; Add 25 1; Mul 151 127; Mul 151 127; Add 1 0;
  Add 0 67; Mul 155 5; Mul 155 5; Add 1 0; Add 0 71; Sub 4 30; Sub 9 35; Sub 2 28; Mul 135 0;
  Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 141 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 143 8; Mul 143 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 21; Mul 135 0; Mul 135 1; Add 25 1; Add 25 1; Mul 177 141; Mul 177 141; Add 1 0;
  Add 0 93; Mul 181 5; Mul 181 5; Add 1 0; Add 0 97; Sub 4 30; Sub 9 35; Sub 2 28; Mul 149 0;
  Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 155 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 157 8; Mul 157 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 22; Mul 149 0; Mul 149 1; Add 25 1; Add 25 1; Mul 203 155; Mul 203 155; Add 1 0;
  Add 0 119; Mul 207 5; Mul 207 5; Add 1 0; Add 0 123; Sub 4 30; Sub 9 35; Sub 2 28; Mul 163 0;
  Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 169 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 171 8; Mul 171 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 23; Mul 165 0; Mul 165 1; Add 25 1; Add 25 1; Mul 229 242; Mul 229 242; Add 1 0;
  Add 0 145; Mul 233 5; Mul 233 5; Add 1 0; Add 0 149; Sub 4 30; Sub 9 35; Sub 2 28; Mul 179 0;
  Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 41; Mul 6 0; Mul 185 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 187 8; Mul 187 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 163 22; Sub 164 22; Mul 1 258; Mul 1 260; Sub 1 0; Div 0 258; Mul 265 0; Mul 265 1;
  Add 30 1; Add 30 1; Mul 260 271; Mul 260 271; Add 1 0; Add 0 176; Mul 264 5; Mul 264 5; Add 1 0;
  Add 0 180; Sub 4 35; Sub 9 40; Sub 2 33; Mul 279 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 15 46; Mul 6 0; Mul 285 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 287 8; Mul 287 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 186 17; Sub 195 22; Sub 180 15; Mul 290 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 200 28; Mul 6 0; Mul 296 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 298 8; Mul 298 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 292 180; Mul 292 186; Add 1 0; Mul 189 187; Add 1 0; Mul 191 191; Add 294 0; Div 2 0;
  Sub 0 216;
  ShowZero 0; (* κ *)
  Mul 289 163; Mul 289 169; Add 1 0; Mul 172 170; Add 1 0; Mul 174 174; Add 291 0; Div 2 0;
  Sub 0 190;
  ShowZero 0; (* κ *)
  Mul 286 146; Mul 286 152; Add 1 0; Mul 155 153; Add 1 0; Mul 157 157; Add 288 0; Div 2 0;
  Sub 0 173;
  ShowZero 0; (* κ *)
  Mul 283 129; Mul 283 135; Add 1 0; Mul 138 136; Add 1 0; Mul 140 140; Add 285 0; Div 2 0;
  Sub 0 156;
  ShowZero 0; (* κ *)
  Mul 280 112; Mul 280 118; Add 1 0; Mul 121 119; Add 1 0; Mul 123 123; Add 282 0; Div 2 0;
  Sub 0 139;
  ShowZero 0; (* κ *)
  Mul 279 95; Mul 279 101; Add 1 0; Mul 104 102; Add 1 0; Mul 106 106; Add 281 0; Div 2 0;
  Sub 0 122;
  ShowZero 0; (* κ *)
  Mul 357 73; Mul 357 79; Add 1 0; Mul 82 80; Add 1 0; Mul 84 84; Add 282 0; Div 2 0; Sub 0 100;
  ShowZero 0; (* κ *)
  Mul 366 105; Mul 366 107; Sub 1 0; Div 0 363; Mul 368 73; Mul 368 79; Add 1 0; Mul 82 80;
  Add 1 0; Mul 84 84; Add 287 0; Div 2 0; Sub 0 8;
  ShowZero 0; (* κ *)
  Mul 368 355; Mul 368 357; Sub 1 0; Add 286 0; Mul 372 347; Mul 372 349; Sub 1 0; Add 3 0;
  Mul 364 351; Mul 364 353; Sub 1 0; Add 3 0; Mul 380 343; Mul 380 345; Sub 1 0; Add 3 0;
  Mul 372 347; Mul 372 349; Sub 1 0; Add 3 0; Mul 364 351; Mul 364 353; Sub 1 0; Add 3 0;
  Mul 392 343; Mul 392 345; Sub 1 0; Add 3 0; Mul 384 347; Mul 384 349; Sub 1 0; Add 3 0;
  Mul 376 351; Mul 376 353; Sub 1 0; Add 3 0; Mul 368 355; Mul 368 357; Sub 1 0; Add 3 0;
  Mul 408 349; Mul 408 351; Sub 1 0; Add 3 0; Mul 400 353; Mul 400 355; Sub 1 0; Add 3 0;
  Mul 392 357; Mul 392 359; Sub 1 0; Add 3 0; Mul 384 361; Mul 384 363; Sub 1 0; Add 3 0;
  Mul 376 365; Mul 376 367; Sub 1 0; Add 3 0; Mul 428 438; Mul 428 440; Sub 1 0; Add 3 0;
  Mul 420 442; Mul 420 444; Sub 1 0; Add 3 0; Mul 412 446; Mul 412 448; Sub 1 0; Add 3 0;
  Mul 404 450; Mul 404 452; Sub 1 0; Add 3 0; Mul 396 454; Mul 396 456; Sub 1 0; Add 3 0;
  Mul 390 458; Mul 390 460; Sub 1 0; Add 3 0; Sub 442 469; Sub 442 469; Mul 454 0; Mul 454 2;
  Sub 1 0; Add 372 0; Sub 436 475; Sub 436 475; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 430 481;
  Sub 430 481; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 424 487; Sub 424 487; Mul 7 0; Mul 7 2;
  Sub 1 0; Add 5 0; Sub 491 493; Sub 491 493; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 495 499;
  Sub 495 499; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 506; Constant 1; Div 0 508; Mul 2 0;
  Sub 40 0;
  ShowZero 0; (* 2 area(F) *)
  Add 193 184; Mul 123 0; Mul 0 4; Add 411 0; Add 197 179; Mul 123 0; Mul 0 8; Add 3 0;
  Add 192 183; Mul 123 0; Mul 0 12; Add 3 0; Add 205 178; Mul 123 0; Mul 0 16; Add 3 0;
  Add 200 182; Mul 123 0; Mul 0 20; Add 3 0; Add 195 186; Mul 123 0; Mul 0 24; Add 3 0;
  Add 217 181; Mul 123 0; Mul 0 28; Add 3 0; Add 212 185; Mul 123 0; Mul 0 32; Add 3 0;
  Add 207 189; Mul 123 0; Mul 0 36; Add 3 0; Add 202 193; Mul 123 0; Mul 0 40; Add 3 0;
  Add 233 188; Mul 123 0; Mul 0 44; Add 3 0; Add 228 192; Mul 123 0; Mul 0 48; Add 3 0;
  Add 223 196; Mul 123 0; Mul 0 52; Add 3 0; Add 218 200; Mul 123 0; Mul 0 56; Add 3 0;
  Add 213 204; Mul 123 0; Mul 0 60; Add 3 0; Add 253 199; Mul 123 0; Mul 0 64; Add 3 0;
  Add 248 203; Mul 123 0; Mul 0 68; Add 3 0; Add 243 207; Mul 123 0; Mul 0 72; Add 3 0;
  Add 238 211; Mul 123 0; Mul 0 76; Add 3 0; Add 233 215; Mul 123 0; Mul 0 80; Add 3 0;
  Add 228 219; Mul 123 0; Mul 0 84; Add 3 0; Sub 455 492; Sub 455 493; Mul 579 0; Mul 579 2;
  Sub 1 0; Mul 470 128; Mul 476 130; Sub 1 0; Add 3 0; Add 501 0; Sub 439 502; Sub 439 503;
  Mul 136 0; Mul 136 2; Sub 1 0; Mul 14 132; Mul 14 134; Sub 1 0; Add 3 0; Add 9 0; Sub 423 512;
  Sub 423 513; Mul 140 0; Mul 140 2; Sub 1 0; Mul 14 136; Mul 14 138; Sub 1 0; Add 3 0; Add 9 0;
  Sub 407 522; Sub 407 523; Mul 144 0; Mul 144 2; Sub 1 0; Mul 14 140; Mul 14 142; Sub 1 0;
  Add 3 0; Add 9 0; Sub 391 532; Sub 391 533; Mul 148 0; Mul 148 2; Sub 1 0; Mul 14 144;
  Mul 14 146; Sub 1 0; Add 3 0; Add 9 0; Sub 370 542; Sub 370 543; Mul 152 0; Mul 152 2; Sub 1 0;
  Mul 14 148; Mul 14 150; Sub 1 0; Add 3 0; Add 9 0; Mul 0 146; Sub 61 0;
  ShowZero 0; (* 2 area(F, S) *)
  Mul 268 339; Mul 0 331; Add 556 0; Mul 267 342; Mul 0 325; Add 2 0; Mul 266 336; Mul 0 328;
  Add 2 0; Mul 265 348; Mul 0 322; Add 2 0; Mul 264 342; Mul 0 325; Add 2 0; Mul 263 336;
  Mul 0 328; Add 2 0; Mul 262 357; Mul 0 322; Add 2 0; Mul 261 351; Mul 0 325; Add 2 0;
  Mul 260 345; Mul 0 328; Add 2 0; Mul 259 339; Mul 0 331; Add 2 0; Mul 258 369; Mul 0 325;
  Add 2 0; Mul 257 363; Mul 0 328; Add 2 0; Mul 256 357; Mul 0 331; Add 2 0; Mul 255 351;
  Mul 0 334; Add 2 0; Mul 254 345; Mul 0 337; Add 2 0; Mul 253 384; Mul 0 331; Add 2 0;
  Mul 252 378; Mul 0 334; Add 2 0; Mul 251 372; Mul 0 337; Add 2 0; Mul 250 366; Mul 0 340;
  Add 2 0; Mul 249 360; Mul 0 343; Add 2 0; Mul 248 354; Mul 0 346; Add 2 0; Mul 590 123;
  Mul 596 125; Sub 1 0; Add 620 0; Mul 128 117; Mul 128 119; Sub 1 0; Add 3 0; Mul 122 111;
  Mul 122 113; Sub 1 0; Add 3 0; Mul 116 105; Mul 116 107; Sub 1 0; Add 3 0; Mul 110 99;
  Mul 110 101; Sub 1 0; Add 3 0; Mul 104 93; Mul 104 95; Sub 1 0; Add 3 0; Mul 0 744; Mul 0 236;
  Sub 26 0;
  ShowZero 0 (* 2 area(S) *)
].

Theorem part_1_size_8_valid : valid part_1_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
