(** eq-21-22-duality (Sec. 4, (21), (22))

    The measures of a vertex of a v-parallel pair (M, S) are the areas of the dual face of the
    f-parallel pair (M*, S* ), so its curvatures are those of that face combined by (11).

        D(v) = area(v* ),  D(v, s) = area(v*, s* ),  H(v) = H(v* )/K(v* ),  K(v) = 1/K(v* )

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a vertex of k faces and the face dual to it, by metric duality; size 3.
    Code: src/pair/curvature.rs, src/pair/edge.rs, src/pair/face.rs, src/pair/forms.rs,
    src/pair/v_parallel.rs, src/pair/vertex.rs, src/scalar/ring.rs, src/space/duality.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 1; Unknown 2; Unknown 3; Unknown 4; Sub 1 3; Sub 1 3; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 5;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 6; Unknown 7; Sub 11 1; Sub 11 1; Mul 1 8; Mul 1 10; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 8;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Sub 7 15; Sub 7 15; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 9;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 11 11; Mul 11 11; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Constant 0; Mul 23 18; Mul 23 19; Add 2 1; Add 3 1; Mul 13 22; Mul 13 23; Add 3 1; Add 3 1;
  Neg 30; Mul 0 37; Mul 33 38; Mul 11 1; Mul 12 1; Add 1 0; Neg 22; Mul 0 25; Mul 25 26; Mul 14 1;
  Mul 14 1; Add 1 0; Neg 34; Mul 0 25; Mul 37 26; Mul 16 1; Mul 16 1; Add 1 0; Sub 4 26; Sub 4 27;
  Sub 2 28; Sub 19 29; Sub 19 30; Sub 17 31; Mul 5 1; Mul 5 3; Sub 1 0; Constant 1; Div 0 1;
  Mul 8 6; Mul 10 6; Sub 1 0; Mul 0 3; Mul 14 9; Mul 13 12; Sub 1 0; Mul 0 7; Sub 29 45;
  Sub 29 46; Sub 27 47; Mul 18 1; Mul 18 3; Sub 1 0; Div 15 0; Mul 20 5; Mul 22 5; Sub 1 0;
  Mul 0 3; Mul 26 8; Mul 25 11; Sub 1 0; Mul 0 7; Mul 14 32; Mul 14 34; Sub 1 0; Div 27 0;
  Mul 16 36; Mul 18 36; Sub 1 0; Mul 0 3; Mul 22 39; Mul 21 42; Sub 1 0; Mul 0 7; Sub 16 31;
  Sub 13 28; Sub 6 33; Sub 3 30; Mul 3 0; Mul 3 2; Sub 1 0; Add 79 0; Mul 0 109; Constant 4;
  Div 46 0; Mul 2 0;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Sub 84 84;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 75 75;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 75 75;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 71 71;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 71 71;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 67 67;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 67 67;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 118 81; Mul 118 81; Add 1 0; Mul 119 78; Mul 119 78; Add 1 0; Mul 114 75; Mul 114 75;
  Add 1 0; Sub 0 100; Sub 7 101; Mul 1 71; Mul 75 1; Sub 1 0; Mul 0 68; Mul 79 4; Mul 6 77;
  Sub 1 0; Mul 0 72; Mul 4 110; Mul 1 111; Add 1 0; Sub 113 0; Neg 0; Sub 18 115; Mul 14 69;
  Mul 86 1; Sub 1 0; Mul 0 67; Mul 90 4; Mul 19 75; Sub 1 0; Mul 0 71; Mul 4 124; Mul 1 125;
  Add 1 0; Sub 127 0; Neg 0; Mul 13 101; Mul 83 29; Sub 1 0; Mul 0 68; Mul 87 32; Mul 18 107;
  Sub 1 0; Mul 0 72; Mul 4 137; Mul 1 138; Add 1 0; Sub 140 0; Neg 0; Mul 101 142; Mul 98 143;
  Add 1 0; Sub 145 0; Neg 0; Mul 91 147; Mul 88 148; Add 1 0; Sub 150 0; Neg 0; Sub 32 46;
  Sub 29 43; Sub 25 39; Sub 22 49; Sub 19 46; Sub 15 42; Mul 5 1; Mul 5 3; Sub 1 0; Div 125 0;
  Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 129; Mul 1 126;
  Add 1 0; Sub 26 0; Mul 8 118; Mul 5 115; Add 1 0; Add 0 3; Sub 26 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 111 179; Mul 108 180; Add 1 0; Sub 182 0; Neg 0; Mul 18 116; Mul 15 113; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 37 42; Mul 36 0; Mul 36 117; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 38 120; Mul 41 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 43 122; Mul 43 124; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 62 75; Sub 58 71; Sub 129 141; Sub 18 50; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 73 86; Sub 139 151; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 104 77; Sub 100 73; Sub 171 144; Sub 70 33; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 115 88; Sub 181 154; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 202 202; Mul 202 202; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 202 202; Mul 202 202; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 189 189; Mul 189 189; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Add 238 77; Mul 0 268; Mul 0 157; Sub 0 0;
  ShowZero 0; (* D(v) *)
  Mul 89 166; Mul 89 168; Sub 1 0; Mul 172 88; Mul 172 90; Sub 1 0; Add 3 0; Add 249 0; Mul 0 167;
  Sub 0 0;
  ShowZero 0; (* D(v, s) *)
  Sub 168 168;
  ShowZero 0; (* D(s) *)
  Sub 147 280;
  ShowZero 0; (* gradient *)
  Sub 144 280;
  ShowZero 0; (* gradient *)
  Sub 214 255;
  ShowZero 0; (* gradient *)
  Sub 211 256;
  ShowZero 0; (* gradient *)
  Sub 137 282;
  ShowZero 0; (* gradient *)
  Sub 134 282;
  ShowZero 0; (* gradient *)
  Sub 203 256;
  ShowZero 0; (* gradient *)
  Sub 200 256;
  ShowZero 0; (* gradient *)
  Sub 128 278;
  ShowZero 0; (* gradient *)
  Sub 125 278;
  ShowZero 0; (* gradient *)
  Sub 195 256;
  ShowZero 0; (* gradient *)
  Sub 192 256;
  ShowZero 0; (* gradient *)
  Mul 43 42; Mul 51 49; Add 1 0; Mul 45 45; Mul 52 52; Add 1 0; Div 3 0; Mul 56 54; Add 5 0;
  Mul 52 52; Mul 60 60; Add 1 0; Mul 61 61; Add 1 0; Div 5 0; Mul 8 0; Sub 0 245;
  ShowZero 0; (* κ κ* *)
  Mul 129 209; Mul 129 209; Add 1 0; Mul 212 212; Mul 212 212; Add 1 0; Div 3 0; Mul 134 99;
  Add 5 0; Mul 138 138; Mul 138 138; Add 1 0; Mul 139 139; Add 1 0; Div 5 0; Mul 8 0; Sub 0 262;
  ShowZero 0; (* κ κ* *)
  Mul 92 91; Mul 100 98; Add 1 0; Mul 94 94; Mul 101 101; Add 1 0; Div 3 0; Mul 105 103; Add 5 0;
  Mul 101 101; Mul 109 109; Add 1 0; Mul 110 110; Add 1 0; Div 5 0; Mul 8 0; Sub 0 279;
  ShowZero 0; (* κ κ* *)
  Div 280 235; Mul 67 0; Div 282 78; Mul 69 0; Mul 239 1; Div 285 0; Mul 2 0; Sub 5 0;
  ShowZero 0; (* H(v) *)
  Mul 84 7; Sub 0 3;
  ShowZero 0 (* K(v) *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a vertex of k faces and the face dual to it, by metric duality; size 4.
    Code: src/pair/curvature.rs, src/pair/edge.rs, src/pair/face.rs, src/pair/forms.rs,
    src/pair/v_parallel.rs, src/pair/vertex.rs, src/scalar/ring.rs, src/space/duality.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 7; Unknown 8; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 9;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 13 4; Mul 13 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 10;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Sub 23 11; Sub 23 11; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 11;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 15 4; Mul 15 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 12;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 29 29; Mul 29 29; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Constant 0; Mul 23 18; Mul 23 19; Add 2 1; Add 3 1; Mul 17 12; Mul 17 13; Add 3 1; Add 3 1;
  Sub 8 1; Sub 9 1; Mul 1 40; Mul 1 42; Sub 1 0; Div 0 40;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 27 46; Mul 27 48; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 13;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 49 49; Mul 49 49; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 54 11; Mul 54 13; Sub 1 0; Div 0 51;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Neg 47; Mul 0 52; Mul 50 53; Mul 67 1; Mul 67 1; Add 1 0; Neg 43; Mul 0 46; Mul 46 47; Mul 59 1;
  Mul 59 1; Add 1 0; Neg 69; Mul 0 42; Mul 72 43; Mul 77 1; Mul 77 1; Add 1 0; Neg 73; Mul 0 26;
  Mul 76 27; Mul 81 1; Mul 81 1; Add 1 0; Sub 4 49; Sub 4 50; Sub 2 51; Sub 25 52; Sub 25 53;
  Sub 23 54; Mul 5 1; Mul 5 3; Sub 1 0; Constant 1; Div 0 1; Mul 8 6; Mul 10 6; Sub 1 0; Mul 0 3;
  Mul 14 9; Mul 13 12; Sub 1 0; Mul 0 7; Sub 35 68; Sub 35 69; Sub 33 70; Mul 18 1; Mul 18 3;
  Sub 1 0; Div 15 0; Mul 20 5; Mul 22 5; Sub 1 0; Mul 0 3; Mul 26 8; Mul 25 11; Sub 1 0; Mul 0 7;
  Sub 44 83; Sub 44 84; Sub 42 85; Mul 17 1; Mul 17 3; Sub 1 0; Div 30 0; Mul 19 5; Mul 21 5;
  Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Mul 14 47; Mul 14 49; Sub 1 0;
  Div 42 0; Mul 16 51; Mul 18 51; Sub 1 0; Mul 0 3; Mul 22 54; Mul 21 57; Sub 1 0; Mul 0 7;
  Sub 31 46; Sub 28 43; Sub 18 48; Sub 15 45; Mul 3 0; Mul 3 2; Sub 1 0; Add 117 0; Sub 12 54;
  Sub 9 51; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 164; Constant 4; Div 67 0; Mul 2 0;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Mul 161 114; Mul 161 115; Add 123 1; Add 123 1; Mul 132 105; Mul 133 105; Add 1 0; Mul 132 102;
  Mul 132 102; Add 1 0; Mul 131 99; Mul 131 99; Add 1 0; Mul 10 96; Mul 10 96; Add 1 0; Sub 0 144;
  Sub 10 145; Mul 1 92; Mul 96 1; Sub 1 0; Mul 0 89; Mul 100 4; Mul 6 98; Sub 1 0; Mul 0 93;
  Sub 16 154; Mul 9 85; Mul 102 1; Sub 1 0; Mul 0 83; Mul 106 4; Mul 14 91; Sub 1 0; Mul 0 87;
  Sub 22 163; Mul 9 79; Mul 95 1; Sub 1 0; Mul 0 77; Mul 99 4; Mul 14 85; Sub 1 0; Mul 0 81;
  Mul 8 121; Mul 88 28; Sub 1 0; Mul 0 73; Mul 92 31; Mul 13 127; Sub 1 0; Mul 0 77; Sub 21 30;
  Sub 18 27; Sub 14 32; Sub 11 29; Mul 3 0; Mul 3 2; Sub 1 0; Add 187 0; Sub 12 38; Sub 9 35;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 234; Mul 0 68;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Sub 196 196;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 170 170;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 170 170;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 166 166;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 166 166;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 162 162;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 162 162;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 158 158;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 158 158;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 141 205; Mul 138 206; Add 1 0; Sub 208 0; Neg 0; Mul 131 210; Mul 128 211; Add 1 0;
  Sub 213 0; Neg 0; Mul 121 215; Mul 118 216; Add 1 0; Sub 218 0; Neg 0; Sub 5 10; Sub 1 11;
  Div 163 105; Mul 2 109; Mul 112 2; Sub 1 0; Mul 0 3; Mul 116 5; Mul 7 115; Sub 1 0; Mul 0 7;
  Mul 4 167; Mul 1 164; Add 1 0; Sub 24 0; Add 1 0; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 158; Mul 7 155; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 148; Mul 12 145; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 141 247; Mul 138 248; Add 1 0; Sub 250 0; Neg 0; Mul 25 146; Mul 22 143; Add 1 0; Add 0 20;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 107 257; Mul 104 258; Add 1 0; Sub 260 0; Neg 0; Mul 103 262; Mul 100 263; Add 1 0;
  Sub 265 0; Neg 0; Mul 40 117; Mul 37 114; Add 1 0; Sub 8 0; Mul 44 112; Mul 41 109; Add 1 0;
  Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 108 276; Mul 105 277; Add 1 0; Sub 279 0; Neg 0; Mul 54 113; Mul 51 110; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 110 286; Mul 107 287; Add 1 0; Sub 289 0; Neg 0; Mul 64 115; Mul 61 112; Add 1 0; Add 0 23;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 29 34; Mul 185 0; Mul 77 116; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 79 119; Mul 190 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 192 121; Mul 192 123; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 208 223; Sub 87 92; Sub 136 145; Sub 28 42; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 219 234; Sub 146 155; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 211 223; Sub 70 102; Sub 143 151; Sub 33 43; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 222 234; Sub 153 161; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 268 226; Sub 127 85; Sub 184 158; Sub 77 48; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 279 237; Sub 194 168; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 301 301; Mul 301 301; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 301 301; Mul 301 301; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 288 288; Mul 288 288; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 276 276; Mul 276 276; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Sub 235 235;
  ShowZero 0; (* D(v) *)
  Mul 253 180; Mul 253 182; Sub 1 0; Mul 186 253; Mul 186 255; Sub 1 0; Add 3 0; Add 371 0;
  Mul 259 182; Mul 259 184; Sub 1 0; Mul 192 255; Mul 192 257; Sub 1 0; Add 3 0; Add 7 0;
  Mul 0 253; Sub 0 0;
  ShowZero 0; (* D(v, s) *)
  Sub 186 186;
  ShowZero 0; (* D(s) *)
  Sub 319 422;
  ShowZero 0; (* gradient *)
  Sub 316 422;
  ShowZero 0; (* gradient *)
  Sub 235 385;
  ShowZero 0; (* gradient *)
  Sub 232 386;
  ShowZero 0; (* gradient *)
  Sub 308 412;
  ShowZero 0; (* gradient *)
  Sub 305 412;
  ShowZero 0; (* gradient *)
  Sub 230 386;
  ShowZero 0; (* gradient *)
  Sub 227 386;
  ShowZero 0; (* gradient *)
  Sub 297 428;
  ShowZero 0; (* gradient *)
  Sub 294 428;
  ShowZero 0; (* gradient *)
  Sub 225 386;
  ShowZero 0; (* gradient *)
  Sub 222 386;
  ShowZero 0; (* gradient *)
  Sub 289 430;
  ShowZero 0; (* gradient *)
  Sub 286 430;
  ShowZero 0; (* gradient *)
  Sub 221 266;
  ShowZero 0; (* gradient *)
  Sub 218 266;
  ShowZero 0; (* gradient *)
  Mul 55 54; Mul 63 61; Add 1 0; Mul 57 57; Mul 64 64; Add 1 0; Div 3 0; Mul 68 66; Add 5 0;
  Mul 64 64; Mul 72 72; Add 1 0; Mul 73 73; Add 1 0; Div 5 0; Mul 8 0; Sub 0 356;
  ShowZero 0; (* κ κ* *)
  Mul 305 235; Mul 305 235; Add 1 0; Mul 238 238; Mul 238 238; Add 1 0; Div 3 0; Mul 202 126;
  Add 5 0; Mul 314 314; Mul 314 314; Add 1 0; Mul 207 207; Add 1 0; Div 5 0; Mul 8 0; Sub 0 373;
  ShowZero 0; (* κ κ* *)
  Mul 119 118; Mul 127 125; Add 1 0; Mul 121 121; Mul 128 128; Add 1 0; Div 3 0; Mul 132 130;
  Add 5 0; Mul 128 128; Mul 136 136; Add 1 0; Mul 137 137; Add 1 0; Div 5 0; Mul 8 0; Sub 0 390;
  ShowZero 0; (* κ κ* *)
  Mul 121 120; Mul 129 127; Add 1 0; Mul 123 123; Mul 130 130; Add 1 0; Div 3 0; Mul 134 132;
  Add 5 0; Mul 130 130; Mul 138 138; Add 1 0; Mul 139 139; Add 1 0; Div 5 0; Mul 8 0; Sub 0 407;
  ShowZero 0; (* κ κ* *)
  Div 408 272; Mul 88 0; Div 410 344; Mul 90 0; Mul 276 1; Div 413 0; Mul 2 0; Sub 5 0;
  ShowZero 0; (* H(v) *)
  Mul 350 7; Sub 0 3;
  ShowZero 0 (* K(v) *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a vertex of k faces and the face dual to it, by metric duality; size 5.
    Code: src/pair/curvature.rs, src/pair/edge.rs, src/pair/face.rs, src/pair/forms.rs,
    src/pair/v_parallel.rs, src/pair/vertex.rs, src/scalar/ring.rs, src/space/duality.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_5 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 7; Unknown 8; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 9;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 13 4; Mul 13 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 10;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 11; Unknown 12; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 13;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 14;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Sub 35 11; Sub 35 11; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 15;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 15 4; Mul 15 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 16;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 41 41; Mul 41 41; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Constant 0; Mul 35 30; Mul 35 31; Add 2 1; Add 3 1; Mul 27 22; Mul 27 23; Add 3 1; Add 3 1;
  Mul 21 16; Mul 21 17; Add 3 1; Add 3 1; Sub 12 1; Sub 13 1; Mul 1 56; Mul 1 58; Sub 1 0;
  Div 0 56;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 31 62; Mul 31 64; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 17;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 65 65; Mul 65 65; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 70 11; Mul 70 13; Sub 1 0; Div 0 67;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Neg 63; Mul 0 68; Mul 66 69; Mul 83 1; Mul 83 1; Add 1 0; Neg 57; Mul 0 62; Mul 60 63; Mul 75 1;
  Mul 75 1; Add 1 0; Neg 53; Mul 0 56; Mul 56 57; Mul 69 1; Mul 69 1; Add 1 0; Neg 91; Mul 0 52;
  Mul 94 53; Mul 99 1; Mul 99 1; Add 1 0; Neg 95; Mul 0 32; Mul 98 33; Mul 103 1; Mul 103 1;
  Add 1 0; Sub 4 59; Sub 4 60; Sub 2 61; Sub 31 62; Sub 31 63; Sub 29 64; Mul 5 1; Mul 5 3;
  Sub 1 0; Constant 1; Div 0 1; Mul 8 6; Mul 10 6; Sub 1 0; Mul 0 3; Mul 14 9; Mul 13 12; Sub 1 0;
  Mul 0 7; Sub 41 78; Sub 41 79; Sub 39 80; Mul 18 1; Mul 18 3; Sub 1 0; Div 15 0; Mul 20 5;
  Mul 22 5; Sub 1 0; Mul 0 3; Mul 26 8; Mul 25 11; Sub 1 0; Mul 0 7; Sub 50 93; Sub 50 94;
  Sub 48 95; Mul 17 1; Mul 17 3; Sub 1 0; Div 30 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3;
  Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 59 108; Sub 59 109; Sub 57 110; Mul 17 1; Mul 17 3;
  Sub 1 0; Div 45 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Mul 14 62; Mul 14 64; Sub 1 0; Div 57 0; Mul 16 66; Mul 18 66; Sub 1 0; Mul 0 3; Mul 22 69;
  Mul 21 72; Sub 1 0; Mul 0 7; Sub 46 61; Sub 43 58; Sub 33 63; Sub 30 60; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 142 0; Sub 24 69; Sub 21 66; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 18 75;
  Sub 15 72; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 207; Constant 4; Div 88 0; Mul 2 0;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Mul 204 141; Mul 204 142; Add 150 1; Add 150 1; Mul 163 132; Mul 164 132; Add 1 0; Mul 163 129;
  Mul 163 129; Add 1 0; Mul 162 126; Mul 162 126; Add 1 0; Mul 161 123; Mul 161 123; Add 1 0;
  Mul 13 120; Mul 13 120; Add 1 0; Sub 0 178; Sub 13 179; Mul 1 116; Mul 120 1; Sub 1 0;
  Mul 0 113; Mul 124 4; Mul 6 122; Sub 1 0; Mul 0 117; Sub 19 188; Mul 9 109; Mul 126 1; Sub 1 0;
  Mul 0 107; Mul 130 4; Mul 14 115; Sub 1 0; Mul 0 111; Sub 25 197; Mul 9 103; Mul 119 1; Sub 1 0;
  Mul 0 101; Mul 123 4; Mul 14 109; Sub 1 0; Mul 0 105; Sub 31 206; Mul 9 97; Mul 113 1; Sub 1 0;
  Mul 0 95; Mul 117 4; Mul 14 103; Sub 1 0; Mul 0 99; Mul 8 154; Mul 106 37; Sub 1 0; Mul 0 91;
  Mul 110 40; Mul 13 160; Sub 1 0; Mul 0 95; Sub 30 39; Sub 27 36; Sub 23 41; Sub 20 38; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 230 0; Sub 20 47; Sub 17 44; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 18 53; Sub 15 50; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 295; Mul 0 86;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Sub 245 245;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 215 215;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 215 215;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 211 211;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 211 211;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 207 207;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 207 207;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 203 203;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 203 203;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 199 199;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 199 199;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 182 256; Mul 179 257; Add 1 0; Sub 259 0; Neg 0; Mul 172 261; Mul 169 262; Add 1 0;
  Sub 264 0; Neg 0; Mul 162 266; Mul 159 267; Add 1 0; Sub 269 0; Neg 0; Sub 5 10; Sub 1 11;
  Div 204 131; Mul 2 135; Mul 138 2; Sub 1 0; Mul 0 3; Mul 142 5; Mul 7 141; Sub 1 0; Mul 0 7;
  Mul 4 208; Mul 1 205; Add 1 0; Sub 24 0; Add 1 0; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 199; Mul 7 196; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 189; Mul 12 186; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 179 298; Mul 176 299; Add 1 0; Sub 301 0; Neg 0; Mul 25 184; Mul 22 181; Add 1 0; Add 0 20;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 177 308; Mul 174 309; Add 1 0; Sub 311 0; Neg 0; Mul 35 182; Mul 32 179; Add 1 0; Add 0 30;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 134 318; Mul 131 319; Add 1 0; Sub 321 0; Neg 0; Mul 130 323; Mul 127 324; Add 1 0;
  Sub 326 0; Neg 0; Mul 50 144; Mul 47 141; Add 1 0; Sub 8 0; Mul 54 139; Mul 51 136; Add 1 0;
  Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 135 337; Mul 132 338; Add 1 0; Sub 340 0; Neg 0; Mul 64 140; Mul 61 137; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 136 347; Mul 133 348; Add 1 0; Sub 350 0; Neg 0; Mul 74 141; Mul 71 138; Add 1 0; Add 0 23;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 138 357; Mul 135 358; Add 1 0; Sub 360 0; Neg 0; Mul 84 143; Mul 81 140; Add 1 0; Add 0 33;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 39 44; Mul 231 0; Mul 97 144; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 99 147; Mul 236 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 238 149; Mul 238 151; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 269 284; Sub 107 112; Sub 173 182; Sub 38 52; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 280 295; Sub 183 192; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 269 284; Sub 90 122; Sub 179 188; Sub 43 53; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 280 295; Sub 189 198; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 272 284; Sub 95 105; Sub 186 194; Sub 48 58; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 283 295; Sub 196 204; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 344 287; Sub 162 110; Sub 236 201; Sub 102 63; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 355 298; Sub 246 211; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 377 377; Mul 377 377; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 377 377; Mul 377 377; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 364 364; Mul 364 364; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 352 352; Mul 352 352; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 340 340; Mul 340 340; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Sub 293 293;
  ShowZero 0; (* D(v) *)
  Mul 317 226; Mul 317 228; Sub 1 0; Mul 232 317; Mul 232 319; Sub 1 0; Add 3 0; Add 460 0;
  Mul 323 228; Mul 323 230; Sub 1 0; Mul 238 319; Mul 238 321; Sub 1 0; Add 3 0; Add 7 0;
  Mul 325 230; Mul 325 232; Sub 1 0; Mul 240 321; Mul 240 323; Sub 1 0; Add 3 0; Add 7 0;
  Mul 0 319; Sub 0 0;
  ShowZero 0; (* D(v, s) *)
  Sub 234 234;
  ShowZero 0; (* D(s) *)
  Sub 406 531;
  ShowZero 0; (* gradient *)
  Sub 403 531;
  ShowZero 0; (* gradient *)
  Sub 298 482;
  ShowZero 0; (* gradient *)
  Sub 295 483;
  ShowZero 0; (* gradient *)
  Sub 395 521;
  ShowZero 0; (* gradient *)
  Sub 392 521;
  ShowZero 0; (* gradient *)
  Sub 293 483;
  ShowZero 0; (* gradient *)
  Sub 290 483;
  ShowZero 0; (* gradient *)
  Sub 384 513;
  ShowZero 0; (* gradient *)
  Sub 381 513;
  ShowZero 0; (* gradient *)
  Sub 288 483;
  ShowZero 0; (* gradient *)
  Sub 285 483;
  ShowZero 0; (* gradient *)
  Sub 373 541;
  ShowZero 0; (* gradient *)
  Sub 370 541;
  ShowZero 0; (* gradient *)
  Sub 283 483;
  ShowZero 0; (* gradient *)
  Sub 280 483;
  ShowZero 0; (* gradient *)
  Sub 365 543;
  ShowZero 0; (* gradient *)
  Sub 362 543;
  ShowZero 0; (* gradient *)
  Sub 279 336;
  ShowZero 0; (* gradient *)
  Sub 276 336;
  ShowZero 0; (* gradient *)
  Mul 70 69; Mul 78 76; Add 1 0; Mul 72 72; Mul 79 79; Add 1 0; Div 3 0; Mul 83 81; Add 5 0;
  Mul 79 79; Mul 87 87; Add 1 0; Mul 88 88; Add 1 0; Div 5 0; Mul 8 0; Sub 0 447;
  ShowZero 0; (* κ κ* *)
  Mul 381 293; Mul 381 293; Add 1 0; Mul 296 296; Mul 296 296; Add 1 0; Div 3 0; Mul 252 156;
  Add 5 0; Mul 390 390; Mul 390 390; Add 1 0; Mul 257 257; Add 1 0; Div 5 0; Mul 8 0; Sub 0 464;
  ShowZero 0; (* κ κ* *)
  Mul 149 148; Mul 157 155; Add 1 0; Mul 151 151; Mul 158 158; Add 1 0; Div 3 0; Mul 162 160;
  Add 5 0; Mul 158 158; Mul 166 166; Add 1 0; Mul 167 167; Add 1 0; Div 5 0; Mul 8 0; Sub 0 481;
  ShowZero 0; (* κ κ* *)
  Mul 151 150; Mul 159 157; Add 1 0; Mul 153 153; Mul 160 160; Add 1 0; Div 3 0; Mul 164 162;
  Add 5 0; Mul 160 160; Mul 168 168; Add 1 0; Mul 169 169; Add 1 0; Div 5 0; Mul 8 0; Sub 0 498;
  ShowZero 0; (* κ κ* *)
  Mul 153 152; Mul 161 159; Add 1 0; Mul 155 155; Mul 162 162; Add 1 0; Div 3 0; Mul 166 164;
  Add 5 0; Mul 162 162; Mul 170 170; Add 1 0; Mul 171 171; Add 1 0; Div 5 0; Mul 8 0; Sub 0 515;
  ShowZero 0; (* κ κ* *)
  Div 516 341; Mul 109 0; Div 518 431; Mul 111 0; Mul 345 1; Div 521 0; Mul 2 0; Sub 5 0;
  ShowZero 0; (* H(v) *)
  Mul 437 7; Sub 0 3;
  ShowZero 0 (* K(v) *)
].

Theorem part_1_size_5_valid : valid part_1_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a vertex of k faces and the face dual to it, by metric duality; size 6.
    Code: src/pair/curvature.rs, src/pair/edge.rs, src/pair/face.rs, src/pair/forms.rs,
    src/pair/v_parallel.rs, src/pair/vertex.rs, src/scalar/ring.rs, src/space/duality.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_6 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 7; Unknown 8; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 9;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 13 4; Mul 13 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 10;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 11; Unknown 12; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 13;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 14;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 15; Unknown 16; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 17;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 18;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Sub 47 11; Sub 47 11; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 19;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 15 4; Mul 15 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 20;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 53 53; Mul 53 53; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Constant 0; Mul 47 42; Mul 47 43; Add 2 1; Add 3 1; Mul 39 34; Mul 39 35; Add 3 1; Add 3 1;
  Mul 31 26; Mul 31 27; Add 3 1; Add 3 1; Mul 25 20; Mul 25 21; Add 3 1; Add 3 1; Sub 16 1;
  Sub 17 1; Mul 1 72; Mul 1 74; Sub 1 0; Div 0 72;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 35 78; Mul 35 80; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 21;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 81 81; Mul 81 81; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 86 11; Mul 86 13; Sub 1 0; Div 0 83;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Neg 79; Mul 0 84; Mul 82 85; Mul 99 1; Mul 99 1; Add 1 0; Neg 73; Mul 0 78; Mul 76 79; Mul 91 1;
  Mul 91 1; Add 1 0; Neg 67; Mul 0 72; Mul 70 73; Mul 85 1; Mul 85 1; Add 1 0; Neg 63; Mul 0 66;
  Mul 66 67; Mul 79 1; Mul 79 1; Add 1 0; Neg 113; Mul 0 62; Mul 116 63; Mul 121 1; Mul 121 1;
  Add 1 0; Neg 117; Mul 0 38; Mul 120 39; Mul 125 1; Mul 125 1; Add 1 0; Sub 4 69; Sub 4 70;
  Sub 2 71; Sub 37 72; Sub 37 73; Sub 35 74; Mul 5 1; Mul 5 3; Sub 1 0; Constant 1; Div 0 1;
  Mul 8 6; Mul 10 6; Sub 1 0; Mul 0 3; Mul 14 9; Mul 13 12; Sub 1 0; Mul 0 7; Sub 47 88;
  Sub 47 89; Sub 45 90; Mul 18 1; Mul 18 3; Sub 1 0; Div 15 0; Mul 20 5; Mul 22 5; Sub 1 0;
  Mul 0 3; Mul 26 8; Mul 25 11; Sub 1 0; Mul 0 7; Sub 56 103; Sub 56 104; Sub 54 105; Mul 17 1;
  Mul 17 3; Sub 1 0; Div 30 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0;
  Mul 0 7; Sub 65 118; Sub 65 119; Sub 63 120; Mul 17 1; Mul 17 3; Sub 1 0; Div 45 0; Mul 19 5;
  Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 74 133; Sub 74 134;
  Sub 72 135; Mul 17 1; Mul 17 3; Sub 1 0; Div 60 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3;
  Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Mul 14 77; Mul 14 79; Sub 1 0; Div 72 0; Mul 16 81;
  Mul 18 81; Sub 1 0; Mul 0 3; Mul 22 84; Mul 21 87; Sub 1 0; Mul 0 7; Sub 61 76; Sub 58 73;
  Sub 48 78; Sub 45 75; Mul 3 0; Mul 3 2; Sub 1 0; Add 167 0; Sub 39 84; Sub 36 81; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 30 90; Sub 27 87; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 24 96;
  Sub 21 93; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 250; Constant 4; Div 109 0; Mul 2 0;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Mul 247 168; Mul 247 169; Add 177 1; Add 177 1; Mul 194 159; Mul 195 159; Add 1 0; Mul 194 156;
  Mul 194 156; Add 1 0; Mul 193 153; Mul 193 153; Add 1 0; Mul 192 150; Mul 192 150; Add 1 0;
  Mul 191 147; Mul 191 147; Add 1 0; Mul 16 144; Mul 16 144; Add 1 0; Sub 0 212; Sub 16 213;
  Mul 1 140; Mul 144 1; Sub 1 0; Mul 0 137; Mul 148 4; Mul 6 146; Sub 1 0; Mul 0 141; Sub 22 222;
  Mul 9 133; Mul 150 1; Sub 1 0; Mul 0 131; Mul 154 4; Mul 14 139; Sub 1 0; Mul 0 135; Sub 28 231;
  Mul 9 127; Mul 143 1; Sub 1 0; Mul 0 125; Mul 147 4; Mul 14 133; Sub 1 0; Mul 0 129; Sub 34 240;
  Mul 9 121; Mul 137 1; Sub 1 0; Mul 0 119; Mul 141 4; Mul 14 127; Sub 1 0; Mul 0 123; Sub 40 249;
  Mul 9 115; Mul 131 1; Sub 1 0; Mul 0 113; Mul 135 4; Mul 14 121; Sub 1 0; Mul 0 117; Mul 8 187;
  Mul 124 46; Sub 1 0; Mul 0 109; Mul 128 49; Mul 13 193; Sub 1 0; Mul 0 113; Sub 39 48;
  Sub 36 45; Sub 32 50; Sub 29 47; Mul 3 0; Mul 3 2; Sub 1 0; Add 273 0; Sub 29 56; Sub 26 53;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 26 62; Sub 23 59; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 24 68; Sub 21 65; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 356; Mul 0 104;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Sub 294 294;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 260 260;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 260 260;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 256 256;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 256 256;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 252 252;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 252 252;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 248 248;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 248 248;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 244 244;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 244 244;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 240 240;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 240 240;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 223 307; Mul 220 308; Add 1 0; Sub 310 0; Neg 0; Mul 213 312; Mul 210 313; Add 1 0;
  Sub 315 0; Neg 0; Mul 203 317; Mul 200 318; Add 1 0; Sub 320 0; Neg 0; Sub 5 10; Sub 1 11;
  Div 245 157; Mul 2 161; Mul 164 2; Sub 1 0; Mul 0 3; Mul 168 5; Mul 7 167; Sub 1 0; Mul 0 7;
  Mul 4 249; Mul 1 246; Add 1 0; Sub 24 0; Add 1 0; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 240; Mul 7 237; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 230; Mul 12 227; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 220 349; Mul 217 350; Add 1 0; Sub 352 0; Neg 0; Mul 25 225; Mul 22 222; Add 1 0; Add 0 20;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 215 359; Mul 212 360; Add 1 0; Sub 362 0; Neg 0; Mul 35 220; Mul 32 217; Add 1 0; Add 0 30;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 213 369; Mul 210 370; Add 1 0; Sub 372 0; Neg 0; Mul 45 218; Mul 42 215; Add 1 0; Add 0 40;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 161 379; Mul 158 380; Add 1 0; Sub 382 0; Neg 0; Mul 157 384; Mul 154 385; Add 1 0;
  Sub 387 0; Neg 0; Mul 60 171; Mul 57 168; Add 1 0; Sub 8 0; Mul 64 166; Mul 61 163; Add 1 0;
  Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 162 398; Mul 159 399; Add 1 0; Sub 401 0; Neg 0; Mul 74 167; Mul 71 164; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 163 408; Mul 160 409; Add 1 0; Sub 411 0; Neg 0; Mul 84 168; Mul 81 165; Add 1 0; Add 0 23;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 164 418; Mul 161 419; Add 1 0; Sub 421 0; Neg 0; Mul 94 169; Mul 91 166; Add 1 0; Add 0 33;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 166 428; Mul 163 429; Add 1 0; Sub 431 0; Neg 0; Mul 104 171; Mul 101 168; Add 1 0;
  Add 0 43; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 49 54; Mul 277 0; Mul 117 172; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 119 175; Mul 282 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 284 177; Mul 284 179; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 330 345; Sub 127 132; Sub 210 219; Sub 48 62; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 341 356; Sub 220 229; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 330 345; Sub 110 142; Sub 216 225; Sub 53 63; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 341 356; Sub 226 235; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 330 345; Sub 115 125; Sub 222 231; Sub 58 68; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 341 356; Sub 232 241; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 333 345; Sub 120 130; Sub 229 237; Sub 63 73; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 344 356; Sub 239 247; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 420 348; Sub 197 135; Sub 288 244; Sub 127 78; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 431 359; Sub 298 254; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 453 453; Mul 453 453; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 453 453; Mul 453 453; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 440 440; Mul 440 440; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 428 428; Mul 428 428; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 416 416; Mul 416 416; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 404 404; Mul 404 404; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Sub 351 351;
  ShowZero 0; (* D(v) *)
  Mul 381 272; Mul 381 274; Sub 1 0; Mul 278 381; Mul 278 383; Sub 1 0; Add 3 0; Add 549 0;
  Mul 387 274; Mul 387 276; Sub 1 0; Mul 284 383; Mul 284 385; Sub 1 0; Add 3 0; Add 7 0;
  Mul 389 276; Mul 389 278; Sub 1 0; Mul 286 385; Mul 286 387; Sub 1 0; Add 3 0; Add 7 0;
  Mul 391 278; Mul 391 280; Sub 1 0; Mul 288 387; Mul 288 389; Sub 1 0; Add 3 0; Add 7 0;
  Mul 0 385; Sub 0 0;
  ShowZero 0; (* D(v, s) *)
  Sub 282 282;
  ShowZero 0; (* D(s) *)
  Sub 493 640;
  ShowZero 0; (* gradient *)
  Sub 490 640;
  ShowZero 0; (* gradient *)
  Sub 361 579;
  ShowZero 0; (* gradient *)
  Sub 358 580;
  ShowZero 0; (* gradient *)
  Sub 482 630;
  ShowZero 0; (* gradient *)
  Sub 479 630;
  ShowZero 0; (* gradient *)
  Sub 356 580;
  ShowZero 0; (* gradient *)
  Sub 353 580;
  ShowZero 0; (* gradient *)
  Sub 471 622;
  ShowZero 0; (* gradient *)
  Sub 468 622;
  ShowZero 0; (* gradient *)
  Sub 351 580;
  ShowZero 0; (* gradient *)
  Sub 348 580;
  ShowZero 0; (* gradient *)
  Sub 460 614;
  ShowZero 0; (* gradient *)
  Sub 457 614;
  ShowZero 0; (* gradient *)
  Sub 346 580;
  ShowZero 0; (* gradient *)
  Sub 343 580;
  ShowZero 0; (* gradient *)
  Sub 449 654;
  ShowZero 0; (* gradient *)
  Sub 446 654;
  ShowZero 0; (* gradient *)
  Sub 341 580;
  ShowZero 0; (* gradient *)
  Sub 338 580;
  ShowZero 0; (* gradient *)
  Sub 441 656;
  ShowZero 0; (* gradient *)
  Sub 438 656;
  ShowZero 0; (* gradient *)
  Sub 337 406;
  ShowZero 0; (* gradient *)
  Sub 334 406;
  ShowZero 0; (* gradient *)
  Mul 85 84; Mul 93 91; Add 1 0; Mul 87 87; Mul 94 94; Add 1 0; Div 3 0; Mul 98 96; Add 5 0;
  Mul 94 94; Mul 102 102; Add 1 0; Mul 103 103; Add 1 0; Div 5 0; Mul 8 0; Sub 0 538;
  ShowZero 0; (* κ κ* *)
  Mul 457 351; Mul 457 351; Add 1 0; Mul 354 354; Mul 354 354; Add 1 0; Div 3 0; Mul 302 186;
  Add 5 0; Mul 466 466; Mul 466 466; Add 1 0; Mul 307 307; Add 1 0; Div 5 0; Mul 8 0; Sub 0 555;
  ShowZero 0; (* κ κ* *)
  Mul 179 178; Mul 187 185; Add 1 0; Mul 181 181; Mul 188 188; Add 1 0; Div 3 0; Mul 192 190;
  Add 5 0; Mul 188 188; Mul 196 196; Add 1 0; Mul 197 197; Add 1 0; Div 5 0; Mul 8 0; Sub 0 572;
  ShowZero 0; (* κ κ* *)
  Mul 181 180; Mul 189 187; Add 1 0; Mul 183 183; Mul 190 190; Add 1 0; Div 3 0; Mul 194 192;
  Add 5 0; Mul 190 190; Mul 198 198; Add 1 0; Mul 199 199; Add 1 0; Div 5 0; Mul 8 0; Sub 0 589;
  ShowZero 0; (* κ κ* *)
  Mul 183 182; Mul 191 189; Add 1 0; Mul 185 185; Mul 192 192; Add 1 0; Div 3 0; Mul 196 194;
  Add 5 0; Mul 192 192; Mul 200 200; Add 1 0; Mul 201 201; Add 1 0; Div 5 0; Mul 8 0; Sub 0 606;
  ShowZero 0; (* κ κ* *)
  Mul 185 184; Mul 193 191; Add 1 0; Mul 187 187; Mul 194 194; Add 1 0; Div 3 0; Mul 198 196;
  Add 5 0; Mul 194 194; Mul 202 202; Add 1 0; Mul 203 203; Add 1 0; Div 5 0; Mul 8 0; Sub 0 623;
  ShowZero 0; (* κ κ* *)
  Div 624 410; Mul 130 0; Div 626 518; Mul 132 0; Mul 414 1; Div 629 0; Mul 2 0; Sub 5 0;
  ShowZero 0; (* H(v) *)
  Mul 524 7; Sub 0 3;
  ShowZero 0 (* K(v) *)
].

Theorem part_1_size_6_valid : valid part_1_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a vertex of k faces and the face dual to it, by metric duality; size 7.
    Code: src/pair/curvature.rs, src/pair/edge.rs, src/pair/face.rs, src/pair/forms.rs,
    src/pair/v_parallel.rs, src/pair/vertex.rs, src/scalar/ring.rs, src/space/duality.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_7 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 7; Unknown 8; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 9;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 13 4; Mul 13 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 10;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 11; Unknown 12; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 13;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 14;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 15; Unknown 16; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 17;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 18;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 19; Unknown 20; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 21;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 22;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Sub 59 11; Sub 59 11; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 23;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 15 4; Mul 15 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 24;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 65 65; Mul 65 65; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Constant 0; Mul 59 54; Mul 59 55; Add 2 1; Add 3 1; Mul 51 46; Mul 51 47; Add 3 1; Add 3 1;
  Mul 43 38; Mul 43 39; Add 3 1; Add 3 1; Mul 35 30; Mul 35 31; Add 3 1; Add 3 1; Mul 29 24;
  Mul 29 25; Add 3 1; Add 3 1; Sub 20 1; Sub 21 1; Mul 1 88; Mul 1 90; Sub 1 0; Div 0 88;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 39 94; Mul 39 96; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 25;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 97 97; Mul 97 97; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 102 11; Mul 102 13; Sub 1 0; Div 0 99;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Neg 95; Mul 0 100; Mul 98 101; Mul 115 1; Mul 115 1; Add 1 0; Neg 89; Mul 0 94; Mul 92 95;
  Mul 107 1; Mul 107 1; Add 1 0; Neg 83; Mul 0 88; Mul 86 89; Mul 101 1; Mul 101 1; Add 1 0;
  Neg 77; Mul 0 82; Mul 80 83; Mul 95 1; Mul 95 1; Add 1 0; Neg 73; Mul 0 76; Mul 76 77; Mul 89 1;
  Mul 89 1; Add 1 0; Neg 135; Mul 0 72; Mul 138 73; Mul 143 1; Mul 143 1; Add 1 0; Neg 139;
  Mul 0 44; Mul 142 45; Mul 147 1; Mul 147 1; Add 1 0; Sub 4 79; Sub 4 80; Sub 2 81; Sub 43 82;
  Sub 43 83; Sub 41 84; Mul 5 1; Mul 5 3; Sub 1 0; Constant 1; Div 0 1; Mul 8 6; Mul 10 6;
  Sub 1 0; Mul 0 3; Mul 14 9; Mul 13 12; Sub 1 0; Mul 0 7; Sub 53 98; Sub 53 99; Sub 51 100;
  Mul 18 1; Mul 18 3; Sub 1 0; Div 15 0; Mul 20 5; Mul 22 5; Sub 1 0; Mul 0 3; Mul 26 8;
  Mul 25 11; Sub 1 0; Mul 0 7; Sub 62 113; Sub 62 114; Sub 60 115; Mul 17 1; Mul 17 3; Sub 1 0;
  Div 30 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Sub 71 128; Sub 71 129; Sub 69 130; Mul 17 1; Mul 17 3; Sub 1 0; Div 45 0; Mul 19 5; Mul 21 5;
  Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 80 143; Sub 80 144; Sub 78 145;
  Mul 17 1; Mul 17 3; Sub 1 0; Div 60 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8;
  Mul 24 11; Sub 1 0; Mul 0 7; Sub 89 158; Sub 89 159; Sub 87 160; Mul 17 1; Mul 17 3; Sub 1 0;
  Div 75 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Mul 14 92; Mul 14 94; Sub 1 0; Div 87 0; Mul 16 96; Mul 18 96; Sub 1 0; Mul 0 3; Mul 22 99;
  Mul 21 102; Sub 1 0; Mul 0 7; Sub 76 91; Sub 73 88; Sub 63 93; Sub 60 90; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 192 0; Sub 54 99; Sub 51 96; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 45 105;
  Sub 42 102; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 36 111; Sub 33 108; Mul 7 0; Mul 7 2;
  Sub 1 0; Add 5 0; Sub 30 117; Sub 27 114; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 293;
  Constant 4; Div 130 0; Mul 2 0;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Mul 290 195; Mul 290 196; Add 204 1; Add 204 1; Mul 225 186; Mul 226 186; Add 1 0; Mul 225 183;
  Mul 225 183; Add 1 0; Mul 224 180; Mul 224 180; Add 1 0; Mul 223 177; Mul 223 177; Add 1 0;
  Mul 222 174; Mul 222 174; Add 1 0; Mul 221 171; Mul 221 171; Add 1 0; Mul 19 168; Mul 19 168;
  Add 1 0; Sub 0 246; Sub 19 247; Mul 1 164; Mul 168 1; Sub 1 0; Mul 0 161; Mul 172 4; Mul 6 170;
  Sub 1 0; Mul 0 165; Sub 25 256; Mul 9 157; Mul 174 1; Sub 1 0; Mul 0 155; Mul 178 4; Mul 14 163;
  Sub 1 0; Mul 0 159; Sub 31 265; Mul 9 151; Mul 167 1; Sub 1 0; Mul 0 149; Mul 171 4; Mul 14 157;
  Sub 1 0; Mul 0 153; Sub 37 274; Mul 9 145; Mul 161 1; Sub 1 0; Mul 0 143; Mul 165 4; Mul 14 151;
  Sub 1 0; Mul 0 147; Sub 43 283; Mul 9 139; Mul 155 1; Sub 1 0; Mul 0 137; Mul 159 4; Mul 14 145;
  Sub 1 0; Mul 0 141; Sub 49 292; Mul 9 133; Mul 149 1; Sub 1 0; Mul 0 131; Mul 153 4; Mul 14 139;
  Sub 1 0; Mul 0 135; Mul 8 220; Mul 142 55; Sub 1 0; Mul 0 127; Mul 146 58; Mul 13 226; Sub 1 0;
  Mul 0 131; Sub 48 57; Sub 45 54; Sub 41 59; Sub 38 56; Mul 3 0; Mul 3 2; Sub 1 0; Add 316 0;
  Sub 38 65; Sub 35 62; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 35 71; Sub 32 68; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 32 77; Sub 29 74; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 30 83;
  Sub 27 80; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 417; Mul 0 122;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Sub 343 343;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 305 305;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 305 305;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 301 301;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 301 301;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 297 297;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 297 297;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 293 293;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 293 293;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 289 289;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 289 289;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 285 285;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 285 285;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 281 281;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 281 281;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 264 358; Mul 261 359; Add 1 0; Sub 361 0; Neg 0; Mul 254 363; Mul 251 364; Add 1 0;
  Sub 366 0; Neg 0; Mul 244 368; Mul 241 369; Add 1 0; Sub 371 0; Neg 0; Sub 5 10; Sub 1 11;
  Div 286 183; Mul 2 187; Mul 190 2; Sub 1 0; Mul 0 3; Mul 194 5; Mul 7 193; Sub 1 0; Mul 0 7;
  Mul 4 290; Mul 1 287; Add 1 0; Sub 24 0; Add 1 0; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 281; Mul 7 278; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 271; Mul 12 268; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 261 400; Mul 258 401; Add 1 0; Sub 403 0; Neg 0; Mul 25 266; Mul 22 263; Add 1 0; Add 0 20;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 256 410; Mul 253 411; Add 1 0; Sub 413 0; Neg 0; Mul 35 261; Mul 32 258; Add 1 0; Add 0 30;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 251 420; Mul 248 421; Add 1 0; Sub 423 0; Neg 0; Mul 45 256; Mul 42 253; Add 1 0; Add 0 40;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 249 430; Mul 246 431; Add 1 0; Sub 433 0; Neg 0; Mul 55 254; Mul 52 251; Add 1 0; Add 0 50;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 188 440; Mul 185 441; Add 1 0; Sub 443 0; Neg 0; Mul 184 445; Mul 181 446; Add 1 0;
  Sub 448 0; Neg 0; Mul 70 198; Mul 67 195; Add 1 0; Sub 8 0; Mul 74 193; Mul 71 190; Add 1 0;
  Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 189 459; Mul 186 460; Add 1 0; Sub 462 0; Neg 0; Mul 84 194; Mul 81 191; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 190 469; Mul 187 470; Add 1 0; Sub 472 0; Neg 0; Mul 94 195; Mul 91 192; Add 1 0; Add 0 23;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 191 479; Mul 188 480; Add 1 0; Sub 482 0; Neg 0; Mul 104 196; Mul 101 193; Add 1 0;
  Add 0 33; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 192 489; Mul 189 490; Add 1 0; Sub 492 0; Neg 0; Mul 114 197; Mul 111 194; Add 1 0;
  Add 0 43; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 194 499; Mul 191 500; Add 1 0; Sub 502 0; Neg 0; Mul 124 199; Mul 121 196; Add 1 0;
  Add 0 53; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 59 64; Mul 323 0; Mul 137 200; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 139 203; Mul 328 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 330 205; Mul 330 207; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 391 406; Sub 147 152; Sub 247 256; Sub 58 72; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 402 417; Sub 257 266; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 391 406; Sub 130 162; Sub 253 262; Sub 63 73; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 402 417; Sub 263 272; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 391 406; Sub 135 145; Sub 259 268; Sub 68 78; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 402 417; Sub 269 278; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 391 406; Sub 140 150; Sub 265 274; Sub 73 83; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 402 417; Sub 275 284; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 394 406; Sub 145 155; Sub 272 280; Sub 78 88; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 405 417; Sub 282 290; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 496 409; Sub 232 160; Sub 340 287; Sub 152 93; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 507 420; Sub 350 297; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 529 529; Mul 529 529; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 529 529; Mul 529 529; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 516 516; Mul 516 516; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 504 504; Mul 504 504; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 492 492; Mul 492 492; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 480 480; Mul 480 480; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 468 468; Mul 468 468; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Sub 409 409;
  ShowZero 0; (* D(v) *)
  Mul 445 318; Mul 445 320; Sub 1 0; Mul 324 445; Mul 324 447; Sub 1 0; Add 3 0; Add 638 0;
  Mul 451 320; Mul 451 322; Sub 1 0; Mul 330 447; Mul 330 449; Sub 1 0; Add 3 0; Add 7 0;
  Mul 453 322; Mul 453 324; Sub 1 0; Mul 332 449; Mul 332 451; Sub 1 0; Add 3 0; Add 7 0;
  Mul 455 324; Mul 455 326; Sub 1 0; Mul 334 451; Mul 334 453; Sub 1 0; Add 3 0; Add 7 0;
  Mul 457 326; Mul 457 328; Sub 1 0; Mul 336 453; Mul 336 455; Sub 1 0; Add 3 0; Add 7 0;
  Mul 0 451; Sub 0 0;
  ShowZero 0; (* D(v, s) *)
  Sub 330 330;
  ShowZero 0; (* D(s) *)
  Sub 580 749;
  ShowZero 0; (* gradient *)
  Sub 577 749;
  ShowZero 0; (* gradient *)
  Sub 424 676;
  ShowZero 0; (* gradient *)
  Sub 421 677;
  ShowZero 0; (* gradient *)
  Sub 569 739;
  ShowZero 0; (* gradient *)
  Sub 566 739;
  ShowZero 0; (* gradient *)
  Sub 419 677;
  ShowZero 0; (* gradient *)
  Sub 416 677;
  ShowZero 0; (* gradient *)
  Sub 558 731;
  ShowZero 0; (* gradient *)
  Sub 555 731;
  ShowZero 0; (* gradient *)
  Sub 414 677;
  ShowZero 0; (* gradient *)
  Sub 411 677;
  ShowZero 0; (* gradient *)
  Sub 547 723;
  ShowZero 0; (* gradient *)
  Sub 544 723;
  ShowZero 0; (* gradient *)
  Sub 409 677;
  ShowZero 0; (* gradient *)
  Sub 406 677;
  ShowZero 0; (* gradient *)
  Sub 536 715;
  ShowZero 0; (* gradient *)
  Sub 533 715;
  ShowZero 0; (* gradient *)
  Sub 404 677;
  ShowZero 0; (* gradient *)
  Sub 401 677;
  ShowZero 0; (* gradient *)
  Sub 525 767;
  ShowZero 0; (* gradient *)
  Sub 522 767;
  ShowZero 0; (* gradient *)
  Sub 399 677;
  ShowZero 0; (* gradient *)
  Sub 396 677;
  ShowZero 0; (* gradient *)
  Sub 517 769;
  ShowZero 0; (* gradient *)
  Sub 514 769;
  ShowZero 0; (* gradient *)
  Sub 395 476;
  ShowZero 0; (* gradient *)
  Sub 392 476;
  ShowZero 0; (* gradient *)
  Mul 100 99; Mul 108 106; Add 1 0; Mul 102 102; Mul 109 109; Add 1 0; Div 3 0; Mul 113 111;
  Add 5 0; Mul 109 109; Mul 117 117; Add 1 0; Mul 118 118; Add 1 0; Div 5 0; Mul 8 0; Sub 0 629;
  ShowZero 0; (* κ κ* *)
  Mul 533 409; Mul 533 409; Add 1 0; Mul 412 412; Mul 412 412; Add 1 0; Div 3 0; Mul 352 216;
  Add 5 0; Mul 542 542; Mul 542 542; Add 1 0; Mul 357 357; Add 1 0; Div 5 0; Mul 8 0; Sub 0 646;
  ShowZero 0; (* κ κ* *)
  Mul 209 208; Mul 217 215; Add 1 0; Mul 211 211; Mul 218 218; Add 1 0; Div 3 0; Mul 222 220;
  Add 5 0; Mul 218 218; Mul 226 226; Add 1 0; Mul 227 227; Add 1 0; Div 5 0; Mul 8 0; Sub 0 663;
  ShowZero 0; (* κ κ* *)
  Mul 211 210; Mul 219 217; Add 1 0; Mul 213 213; Mul 220 220; Add 1 0; Div 3 0; Mul 224 222;
  Add 5 0; Mul 220 220; Mul 228 228; Add 1 0; Mul 229 229; Add 1 0; Div 5 0; Mul 8 0; Sub 0 680;
  ShowZero 0; (* κ κ* *)
  Mul 213 212; Mul 221 219; Add 1 0; Mul 215 215; Mul 222 222; Add 1 0; Div 3 0; Mul 226 224;
  Add 5 0; Mul 222 222; Mul 230 230; Add 1 0; Mul 231 231; Add 1 0; Div 5 0; Mul 8 0; Sub 0 697;
  ShowZero 0; (* κ κ* *)
  Mul 215 214; Mul 223 221; Add 1 0; Mul 217 217; Mul 224 224; Add 1 0; Div 3 0; Mul 228 226;
  Add 5 0; Mul 224 224; Mul 232 232; Add 1 0; Mul 233 233; Add 1 0; Div 5 0; Mul 8 0; Sub 0 714;
  ShowZero 0; (* κ κ* *)
  Mul 217 216; Mul 225 223; Add 1 0; Mul 219 219; Mul 226 226; Add 1 0; Div 3 0; Mul 230 228;
  Add 5 0; Mul 226 226; Mul 234 234; Add 1 0; Mul 235 235; Add 1 0; Div 5 0; Mul 8 0; Sub 0 731;
  ShowZero 0; (* κ κ* *)
  Div 732 479; Mul 151 0; Div 734 605; Mul 153 0; Mul 483 1; Div 737 0; Mul 2 0; Sub 5 0;
  ShowZero 0; (* H(v) *)
  Mul 611 7; Sub 0 3;
  ShowZero 0 (* K(v) *)
].

Theorem part_1_size_7_valid : valid part_1_size_7.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a vertex of k faces and the face dual to it, by metric duality; size 8.
    Code: src/pair/curvature.rs, src/pair/edge.rs, src/pair/face.rs, src/pair/forms.rs,
    src/pair/v_parallel.rs, src/pair/vertex.rs, src/scalar/ring.rs, src/space/duality.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_8 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 7; Unknown 8; Sub 1 15; Sub 1 15; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 9;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 13 4; Mul 13 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 10;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 11; Unknown 12; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 13;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 14;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 15; Unknown 16; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 17;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 18;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 19; Unknown 20; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 21;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 22;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Unknown 23; Unknown 24; Sub 1 13; Sub 1 13; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 25;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 17 4; Mul 17 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 26;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Sub 71 11; Sub 71 11; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 27;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 15 4; Mul 15 6; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 28;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 77 77; Mul 77 77; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Constant 0; Mul 71 66; Mul 71 67; Add 2 1; Add 3 1; Mul 63 58; Mul 63 59; Add 3 1; Add 3 1;
  Mul 55 50; Mul 55 51; Add 3 1; Add 3 1; Mul 47 42; Mul 47 43; Add 3 1; Add 3 1; Mul 39 34;
  Mul 39 35; Add 3 1; Add 3 1; Mul 33 28; Mul 33 29; Add 3 1; Add 3 1; Sub 24 1; Sub 25 1;
  Mul 1 104; Mul 1 106; Sub 1 0; Div 0 104;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 43 110; Mul 43 112; Sub 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Unknown 29;
  Nonzero 0; (* the neighbours are not over the vertex *)
  Mul 113 113; Mul 113 113; Add 1 0;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Mul 118 11; Mul 118 13; Sub 1 0; Div 0 115;
  Nonzero 0; (* consecutive faces around the vertex are not coplanar, in M and in S *)
  Neg 111; Mul 0 116; Mul 114 117; Mul 131 1; Mul 131 1; Add 1 0; Neg 105; Mul 0 110; Mul 108 111;
  Mul 123 1; Mul 123 1; Add 1 0; Neg 99; Mul 0 104; Mul 102 105; Mul 117 1; Mul 117 1; Add 1 0;
  Neg 93; Mul 0 98; Mul 96 99; Mul 111 1; Mul 111 1; Add 1 0; Neg 87; Mul 0 92; Mul 90 93;
  Mul 105 1; Mul 105 1; Add 1 0; Neg 83; Mul 0 86; Mul 86 87; Mul 99 1; Mul 99 1; Add 1 0;
  Neg 157; Mul 0 82; Mul 160 83; Mul 165 1; Mul 165 1; Add 1 0; Neg 161; Mul 0 50; Mul 164 51;
  Mul 169 1; Mul 169 1; Add 1 0; Sub 4 89; Sub 4 90; Sub 2 91; Sub 49 92; Sub 49 93; Sub 47 94;
  Mul 5 1; Mul 5 3; Sub 1 0; Constant 1; Div 0 1; Mul 8 6; Mul 10 6; Sub 1 0; Mul 0 3; Mul 14 9;
  Mul 13 12; Sub 1 0; Mul 0 7; Sub 59 108; Sub 59 109; Sub 57 110; Mul 18 1; Mul 18 3; Sub 1 0;
  Div 15 0; Mul 20 5; Mul 22 5; Sub 1 0; Mul 0 3; Mul 26 8; Mul 25 11; Sub 1 0; Mul 0 7;
  Sub 68 123; Sub 68 124; Sub 66 125; Mul 17 1; Mul 17 3; Sub 1 0; Div 30 0; Mul 19 5; Mul 21 5;
  Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 77 138; Sub 77 139; Sub 75 140;
  Mul 17 1; Mul 17 3; Sub 1 0; Div 45 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8;
  Mul 24 11; Sub 1 0; Mul 0 7; Sub 86 153; Sub 86 154; Sub 84 155; Mul 17 1; Mul 17 3; Sub 1 0;
  Div 60 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Sub 95 168; Sub 95 169; Sub 93 170; Mul 17 1; Mul 17 3; Sub 1 0; Div 75 0; Mul 19 5; Mul 21 5;
  Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 104 183; Sub 104 184; Sub 102 185;
  Mul 17 1; Mul 17 3; Sub 1 0; Div 90 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8;
  Mul 24 11; Sub 1 0; Mul 0 7; Mul 14 107; Mul 14 109; Sub 1 0; Div 102 0; Mul 16 111; Mul 18 111;
  Sub 1 0; Mul 0 3; Mul 22 114; Mul 21 117; Sub 1 0; Mul 0 7; Sub 91 106; Sub 88 103; Sub 78 108;
  Sub 75 105; Mul 3 0; Mul 3 2; Sub 1 0; Add 217 0; Sub 69 114; Sub 66 111; Mul 7 0; Mul 7 2;
  Sub 1 0; Add 5 0; Sub 60 120; Sub 57 117; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 51 126;
  Sub 48 123; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 42 132; Sub 39 129; Mul 7 0; Mul 7 2;
  Sub 1 0; Add 5 0; Sub 36 138; Sub 33 135; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 336;
  Constant 4; Div 151 0; Mul 2 0;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Mul 333 222; Mul 333 223; Add 231 1; Add 231 1; Mul 256 213; Mul 257 213; Add 1 0; Mul 256 210;
  Mul 256 210; Add 1 0; Mul 255 207; Mul 255 207; Add 1 0; Mul 254 204; Mul 254 204; Add 1 0;
  Mul 253 201; Mul 253 201; Add 1 0; Mul 252 198; Mul 252 198; Add 1 0; Mul 251 195; Mul 251 195;
  Add 1 0; Mul 22 192; Mul 22 192; Add 1 0; Sub 0 280; Sub 22 281; Mul 1 188; Mul 192 1; Sub 1 0;
  Mul 0 185; Mul 196 4; Mul 6 194; Sub 1 0; Mul 0 189; Sub 28 290; Mul 9 181; Mul 198 1; Sub 1 0;
  Mul 0 179; Mul 202 4; Mul 14 187; Sub 1 0; Mul 0 183; Sub 34 299; Mul 9 175; Mul 191 1; Sub 1 0;
  Mul 0 173; Mul 195 4; Mul 14 181; Sub 1 0; Mul 0 177; Sub 40 308; Mul 9 169; Mul 185 1; Sub 1 0;
  Mul 0 167; Mul 189 4; Mul 14 175; Sub 1 0; Mul 0 171; Sub 46 317; Mul 9 163; Mul 179 1; Sub 1 0;
  Mul 0 161; Mul 183 4; Mul 14 169; Sub 1 0; Mul 0 165; Sub 52 326; Mul 9 157; Mul 173 1; Sub 1 0;
  Mul 0 155; Mul 177 4; Mul 14 163; Sub 1 0; Mul 0 159; Sub 58 335; Mul 9 151; Mul 167 1; Sub 1 0;
  Mul 0 149; Mul 171 4; Mul 14 157; Sub 1 0; Mul 0 153; Mul 8 253; Mul 160 64; Sub 1 0; Mul 0 145;
  Mul 164 67; Mul 13 259; Sub 1 0; Mul 0 149; Sub 57 66; Sub 54 63; Sub 50 68; Sub 47 65; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 359 0; Sub 47 74; Sub 44 71; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 44 80; Sub 41 77; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 41 86; Sub 38 83; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 38 92; Sub 35 89; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 36 98;
  Sub 33 95; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 478; Mul 0 140;
  Nonzero 0; (* D(v) != 0 and D(s) != 0 *)
  Sub 392 392;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 350 350;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 350 350;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 346 346;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 346 346;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 342 342;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 342 342;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 338 338;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 338 338;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 334 334;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 334 334;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 330 330;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 330 330;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 326 326;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 326 326;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 322 322;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 322 322;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 305 409; Mul 302 410; Add 1 0; Sub 412 0; Neg 0; Mul 295 414; Mul 292 415; Add 1 0;
  Sub 417 0; Neg 0; Mul 285 419; Mul 282 420; Add 1 0; Sub 422 0; Neg 0; Sub 5 10; Sub 1 11;
  Div 327 209; Mul 2 213; Mul 216 2; Sub 1 0; Mul 0 3; Mul 220 5; Mul 7 219; Sub 1 0; Mul 0 7;
  Mul 4 331; Mul 1 328; Add 1 0; Sub 24 0; Add 1 0; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 322; Mul 7 319; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 312; Mul 12 309; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 302 451; Mul 299 452; Add 1 0; Sub 454 0; Neg 0; Mul 25 307; Mul 22 304; Add 1 0; Add 0 20;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 297 461; Mul 294 462; Add 1 0; Sub 464 0; Neg 0; Mul 35 302; Mul 32 299; Add 1 0; Add 0 30;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 292 471; Mul 289 472; Add 1 0; Sub 474 0; Neg 0; Mul 45 297; Mul 42 294; Add 1 0; Add 0 40;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 287 481; Mul 284 482; Add 1 0; Sub 484 0; Neg 0; Mul 55 292; Mul 52 289; Add 1 0; Add 0 50;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 285 491; Mul 282 492; Add 1 0; Sub 494 0; Neg 0; Mul 65 290; Mul 62 287; Add 1 0; Add 0 60;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 215 501; Mul 212 502; Add 1 0; Sub 504 0; Neg 0; Mul 211 506; Mul 208 507; Add 1 0;
  Sub 509 0; Neg 0; Mul 80 225; Mul 77 222; Add 1 0; Sub 8 0; Mul 84 220; Mul 81 217; Add 1 0;
  Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 216 520; Mul 213 521; Add 1 0; Sub 523 0; Neg 0; Mul 94 221; Mul 91 218; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 217 530; Mul 214 531; Add 1 0; Sub 533 0; Neg 0; Mul 104 222; Mul 101 219; Add 1 0;
  Add 0 23; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 218 540; Mul 215 541; Add 1 0; Sub 543 0; Neg 0; Mul 114 223; Mul 111 220; Add 1 0;
  Add 0 33; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 219 550; Mul 216 551; Add 1 0; Sub 553 0; Neg 0; Mul 124 224; Mul 121 221; Add 1 0;
  Add 0 43; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 220 560; Mul 217 561; Add 1 0; Sub 563 0; Neg 0; Mul 134 225; Mul 131 222; Add 1 0;
  Add 0 53; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 222 570; Mul 219 571; Add 1 0; Sub 573 0; Neg 0; Mul 144 227; Mul 141 224; Add 1 0;
  Add 0 63; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 69 74; Mul 369 0; Mul 157 228; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 159 231; Mul 374 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 376 233; Mul 376 235; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 452 467; Sub 167 172; Sub 284 293; Sub 68 82; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 463 478; Sub 294 303; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 452 467; Sub 150 182; Sub 290 299; Sub 73 83; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 463 478; Sub 300 309; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 452 467; Sub 155 165; Sub 296 305; Sub 78 88; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 463 478; Sub 306 315; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 452 467; Sub 160 170; Sub 302 311; Sub 83 93; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 463 478; Sub 312 321; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 452 467; Sub 165 175; Sub 308 317; Sub 88 98; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 463 478; Sub 318 327; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 455 467; Sub 170 180; Sub 315 323; Sub 93 103; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 466 478; Sub 325 333; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 572 470; Sub 267 185; Sub 392 330; Sub 177 108; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 583 481; Sub 402 340; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 605 605; Mul 605 605; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 605 605; Mul 605 605; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 592 592; Mul 592 592; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 580 580; Mul 580 580; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 568 568; Mul 568 568; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 556 556; Mul 556 556; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 544 544; Mul 544 544; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Mul 532 532; Mul 532 532; Add 1 0;
  ShowNonzero 0; (* as src/pair/edge.rs finds *)
  Sub 467 467;
  ShowZero 0; (* D(v) *)
  Mul 509 364; Mul 509 366; Sub 1 0; Mul 370 509; Mul 370 511; Sub 1 0; Add 3 0; Add 727 0;
  Mul 515 366; Mul 515 368; Sub 1 0; Mul 376 511; Mul 376 513; Sub 1 0; Add 3 0; Add 7 0;
  Mul 517 368; Mul 517 370; Sub 1 0; Mul 378 513; Mul 378 515; Sub 1 0; Add 3 0; Add 7 0;
  Mul 519 370; Mul 519 372; Sub 1 0; Mul 380 515; Mul 380 517; Sub 1 0; Add 3 0; Add 7 0;
  Mul 521 372; Mul 521 374; Sub 1 0; Mul 382 517; Mul 382 519; Sub 1 0; Add 3 0; Add 7 0;
  Mul 523 374; Mul 523 376; Sub 1 0; Mul 384 519; Mul 384 521; Sub 1 0; Add 3 0; Add 7 0;
  Mul 0 517; Sub 0 0;
  ShowZero 0; (* D(v, s) *)
  Sub 378 378;
  ShowZero 0; (* D(s) *)
  Sub 667 858;
  ShowZero 0; (* gradient *)
  Sub 664 858;
  ShowZero 0; (* gradient *)
  Sub 487 773;
  ShowZero 0; (* gradient *)
  Sub 484 774;
  ShowZero 0; (* gradient *)
  Sub 656 848;
  ShowZero 0; (* gradient *)
  Sub 653 848;
  ShowZero 0; (* gradient *)
  Sub 482 774;
  ShowZero 0; (* gradient *)
  Sub 479 774;
  ShowZero 0; (* gradient *)
  Sub 645 840;
  ShowZero 0; (* gradient *)
  Sub 642 840;
  ShowZero 0; (* gradient *)
  Sub 477 774;
  ShowZero 0; (* gradient *)
  Sub 474 774;
  ShowZero 0; (* gradient *)
  Sub 634 832;
  ShowZero 0; (* gradient *)
  Sub 631 832;
  ShowZero 0; (* gradient *)
  Sub 472 774;
  ShowZero 0; (* gradient *)
  Sub 469 774;
  ShowZero 0; (* gradient *)
  Sub 623 824;
  ShowZero 0; (* gradient *)
  Sub 620 824;
  ShowZero 0; (* gradient *)
  Sub 467 774;
  ShowZero 0; (* gradient *)
  Sub 464 774;
  ShowZero 0; (* gradient *)
  Sub 612 816;
  ShowZero 0; (* gradient *)
  Sub 609 816;
  ShowZero 0; (* gradient *)
  Sub 462 774;
  ShowZero 0; (* gradient *)
  Sub 459 774;
  ShowZero 0; (* gradient *)
  Sub 601 880;
  ShowZero 0; (* gradient *)
  Sub 598 880;
  ShowZero 0; (* gradient *)
  Sub 457 774;
  ShowZero 0; (* gradient *)
  Sub 454 774;
  ShowZero 0; (* gradient *)
  Sub 593 882;
  ShowZero 0; (* gradient *)
  Sub 590 882;
  ShowZero 0; (* gradient *)
  Sub 453 546;
  ShowZero 0; (* gradient *)
  Sub 450 546;
  ShowZero 0; (* gradient *)
  Mul 115 114; Mul 123 121; Add 1 0; Mul 117 117; Mul 124 124; Add 1 0; Div 3 0; Mul 128 126;
  Add 5 0; Mul 124 124; Mul 132 132; Add 1 0; Mul 133 133; Add 1 0; Div 5 0; Mul 8 0; Sub 0 720;
  ShowZero 0; (* κ κ* *)
  Mul 609 467; Mul 609 467; Add 1 0; Mul 470 470; Mul 470 470; Add 1 0; Div 3 0; Mul 402 246;
  Add 5 0; Mul 618 618; Mul 618 618; Add 1 0; Mul 407 407; Add 1 0; Div 5 0; Mul 8 0; Sub 0 737;
  ShowZero 0; (* κ κ* *)
  Mul 239 238; Mul 247 245; Add 1 0; Mul 241 241; Mul 248 248; Add 1 0; Div 3 0; Mul 252 250;
  Add 5 0; Mul 248 248; Mul 256 256; Add 1 0; Mul 257 257; Add 1 0; Div 5 0; Mul 8 0; Sub 0 754;
  ShowZero 0; (* κ κ* *)
  Mul 241 240; Mul 249 247; Add 1 0; Mul 243 243; Mul 250 250; Add 1 0; Div 3 0; Mul 254 252;
  Add 5 0; Mul 250 250; Mul 258 258; Add 1 0; Mul 259 259; Add 1 0; Div 5 0; Mul 8 0; Sub 0 771;
  ShowZero 0; (* κ κ* *)
  Mul 243 242; Mul 251 249; Add 1 0; Mul 245 245; Mul 252 252; Add 1 0; Div 3 0; Mul 256 254;
  Add 5 0; Mul 252 252; Mul 260 260; Add 1 0; Mul 261 261; Add 1 0; Div 5 0; Mul 8 0; Sub 0 788;
  ShowZero 0; (* κ κ* *)
  Mul 245 244; Mul 253 251; Add 1 0; Mul 247 247; Mul 254 254; Add 1 0; Div 3 0; Mul 258 256;
  Add 5 0; Mul 254 254; Mul 262 262; Add 1 0; Mul 263 263; Add 1 0; Div 5 0; Mul 8 0; Sub 0 805;
  ShowZero 0; (* κ κ* *)
  Mul 247 246; Mul 255 253; Add 1 0; Mul 249 249; Mul 256 256; Add 1 0; Div 3 0; Mul 260 258;
  Add 5 0; Mul 256 256; Mul 264 264; Add 1 0; Mul 265 265; Add 1 0; Div 5 0; Mul 8 0; Sub 0 822;
  ShowZero 0; (* κ κ* *)
  Mul 249 248; Mul 257 255; Add 1 0; Mul 251 251; Mul 258 258; Add 1 0; Div 3 0; Mul 262 260;
  Add 5 0; Mul 258 258; Mul 266 266; Add 1 0; Mul 267 267; Add 1 0; Div 5 0; Mul 8 0; Sub 0 839;
  ShowZero 0; (* κ κ* *)
  Div 840 548; Mul 172 0; Div 842 692; Mul 174 0; Mul 552 1; Div 845 0; Mul 2 0; Sub 5 0;
  ShowZero 0; (* H(v) *)
  Mul 698 7; Sub 0 3;
  ShowZero 0 (* K(v) *)
].

Theorem part_1_size_8_valid : valid part_1_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
