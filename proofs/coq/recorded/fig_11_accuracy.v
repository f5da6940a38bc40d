(** fig-11-accuracy (Sec. 4, Fig. 11)

    On a triangulation that is invariant under a lattice (22) is exact for quadratic functions and
    of second order for others; on the union-jack grid H is exact for them, and K is off by f_xy²,
    up at valence 4 and down at valence 8.

        K_h = K + h² (4 a02 a40 + 4 a04 a20 - 2 a11 (a13 + a22 + a31) - a12² - 2 a12 a21 - a21²) + O(h⁴)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** quadratics on any lattice; size 1.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs, src/space/surface.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the lattice vectors are not parallel *)
  Unknown 4; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 5; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 3 10; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 3 11; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 14 12; Add 8 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 16 14; Add 9 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 13 18; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 13 19; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 24; Add 18 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 26; Add 19 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 15; Add 24 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 15; Add 25 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 34; Add 30 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 36; Add 31 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 0; Constant 1;
  Mul 7 0; Mul 0 1; Add 3 0; Mul 9 3; Mul 4 45; Mul 1 0; Add 3 0; Mul 12 7; Mul 3 49; Mul 1 0;
  Add 3 0; Mul 11 54; Mul 16 0; Mul 0 13; Add 3 0; Mul 18 3; Mul 0 11; Add 2 0; Mul 6 61;
  Mul 21 0; Mul 0 20; Add 3 0; Mul 22 59; Mul 19 0; Add 21 0; Mul 2 62; Mul 18 0; Add 2 0;
  Mul 28 67; Mul 33 0; Mul 0 30; Add 3 0; Mul 35 3; Mul 0 10; Add 2 0; Mul 6 74; Mul 38 0;
  Mul 0 37; Add 3 0; Mul 39 70; Mul 36 0; Add 38 0; Mul 2 73; Mul 35 0; Add 2 0; Mul 45 79;
  Mul 50 0; Mul 0 47; Add 3 0; Mul 52 3; Mul 0 10; Add 2 0; Mul 6 86; Mul 55 0; Mul 0 54; Add 3 0;
  Mul 56 83; Mul 53 0; Add 55 0; Mul 2 86; Mul 52 0; Add 2 0; Mul 62 91; Mul 67 0; Mul 0 64;
  Add 3 0; Mul 69 3; Mul 0 10; Add 2 0; Mul 6 98; Mul 72 0; Mul 0 71; Add 3 0; Mul 73 94;
  Mul 70 0; Add 72 0; Mul 2 97; Mul 69 0; Add 2 0; Mul 79 103; Mul 84 0; Mul 0 81; Add 3 0;
  Mul 86 3; Mul 0 10; Add 2 0; Mul 6 110; Mul 89 0; Mul 0 88; Add 3 0; Mul 90 105; Mul 87 0;
  Add 89 0; Mul 2 108; Mul 86 0; Add 2 0; Mul 96 114; Mul 101 0; Mul 0 98; Add 3 0; Mul 103 3;
  Mul 0 10; Add 2 0; Mul 6 121; Mul 106 0; Mul 0 105; Add 3 0; Mul 107 116; Mul 104 0; Add 106 0;
  Mul 2 119; Mul 103 0; Add 2 0; Mul 113 125; Mul 118 0; Mul 0 115; Add 3 0; Mul 120 3; Mul 0 10;
  Add 2 0; Mul 6 132; Mul 123 0; Mul 0 122; Add 3 0; Mul 167 167; Mul 166 166; Add 1 0; Mul 127 0;
  Div 128 179; Mul 1 0; Mul 131 173; Mul 132 172; Add 1 0; Add 0 134; Add 4 0; Mul 174 174;
  Mul 173 173; Add 1 0; Mul 138 0; Mul 0 10; Mul 141 179; Mul 142 178; Add 1 0; Add 0 144;
  Add 4 0; Mul 179 179; Mul 177 177; Add 1 0; Mul 148 0; Mul 0 20; Mul 151 184; Mul 152 182;
  Add 1 0; Add 0 154; Add 4 0; Mul 184 184; Mul 183 183; Add 1 0; Mul 158 0; Mul 0 30;
  Mul 161 189; Mul 162 188; Add 1 0; Add 0 164; Add 4 0; Mul 189 189; Mul 187 187; Add 1 0;
  Mul 168 0; Mul 0 40; Mul 171 194; Mul 172 192; Add 1 0; Add 0 174; Add 4 0; Mul 193 193;
  Mul 191 191; Add 1 0; Mul 178 0; Mul 0 50; Mul 181 198; Mul 182 196; Add 1 0; Add 0 184;
  Add 4 0; Mul 197 197; Mul 195 195; Add 1 0; Mul 188 0; Mul 0 60; Mul 191 202; Mul 192 200;
  Add 1 0; Add 0 194; Add 4 0; Sub 234 238; Sub 233 237; Sub 158 175; Sub 232 241; Sub 230 240;
  Sub 144 178; Mul 5 1; Mul 5 3; Sub 1 0; Div 204 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8;
  Mul 12 11; Sub 1 0; Mul 0 7; Sub 242 256; Sub 241 255; Sub 142 193; Mul 17 1; Mul 17 3; Sub 1 0;
  Div 219 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Sub 252 271; Sub 250 270; Sub 140 208; Mul 17 1; Mul 17 3; Sub 1 0; Div 234 0; Mul 19 5;
  Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 261 286; Sub 259 285;
  Sub 138 223; Mul 17 1; Mul 17 3; Sub 1 0; Div 249 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3;
  Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 270 301; Sub 268 300; Sub 136 238; Mul 17 1;
  Mul 17 3; Sub 1 0; Div 264 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11;
  Sub 1 0; Mul 0 7; Mul 14 76; Mul 14 78; Sub 1 0; Div 276 0; Mul 16 80; Mul 18 80; Sub 1 0;
  Mul 0 3; Mul 22 83; Mul 21 86; Sub 1 0; Mul 0 7; Sub 140 150; Sub 131 151; Mul 1 87; Mul 91 1;
  Sub 1 0; Mul 0 85; Mul 95 4; Mul 6 93; Sub 1 0; Mul 0 89; Sub 130 160; Mul 9 81; Mul 97 1;
  Sub 1 0; Mul 0 79; Mul 101 4; Mul 14 87; Sub 1 0; Mul 0 83; Sub 129 169; Mul 9 75; Mul 91 1;
  Sub 1 0; Mul 0 73; Mul 95 4; Mul 14 81; Sub 1 0; Mul 0 77; Sub 128 178; Mul 9 69; Mul 85 1;
  Sub 1 0; Mul 0 67; Mul 89 4; Mul 14 75; Sub 1 0; Mul 0 71; Sub 127 187; Mul 9 63; Mul 79 1;
  Sub 1 0; Mul 0 61; Mul 83 4; Mul 14 69; Sub 1 0; Mul 0 65; Mul 8 134; Mul 72 46; Sub 1 0;
  Mul 0 57; Mul 76 49; Mul 13 140; Sub 1 0; Mul 0 61; Sub 115 130; Sub 112 127; Sub 41 50;
  Sub 38 47; Sub 104 134; Sub 101 131; Sub 36 54; Sub 33 51; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5;
  Mul 8 7; Sub 1 0; Add 3 0; Add 355 0; Mul 13 8; Mul 13 10; Sub 1 0; Add 359 0; Sub 105 150;
  Sub 102 147; Sub 43 70; Sub 40 67; Mul 19 0; Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0;
  Add 3 0; Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0; Sub 106 166; Sub 103 163; Sub 50 86;
  Sub 47 83; Mul 19 0; Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0; Add 15 0;
  Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0; Sub 110 182; Sub 107 179; Sub 58 102; Sub 55 99;
  Mul 19 0; Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0; Add 15 0; Mul 25 8;
  Mul 25 10; Sub 1 0; Add 15 0; Mul 0 458; Div 408 0; Mul 6 0; Mul 412 461; Mul 416 462;
  Mul 2 463; Add 2 1; Sub 1 0;
  ShowZero 0; (* 2H = Δf *)
  Mul 75 70; Mul 75 72; Sub 1 0; Add 419 0; Mul 75 58; Mul 75 60; Sub 1 0; Add 3 0; Mul 63 46;
  Mul 63 48; Sub 1 0; Add 3 0; Mul 51 34; Mul 51 36; Sub 1 0; Add 3 0; Mul 0 482; Mul 0 23;
  Mul 22 21; Mul 437 437; Sub 1 0; Sub 3 0;
  ShowZero 0 (* K = det *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** quartics on the square lattice; size 1.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the mesh size is not 0 *)
  Constant 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant 1; Mul 0 3; Add 3 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 5 6; Add 6 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant (-1); Mul 0 10; Add 10 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 10 10; Add 13 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 15 13; Add 16 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 9 16; Add 19 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8;
  Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15; Mul 14 34;
  Mul 0 35; Add 38 0; Mul 16 37; Mul 38 40; Mul 1 0; Add 3 0; Mul 19 41; Mul 3 44; Mul 1 0;
  Add 3 0; Mul 22 45; Mul 3 48; Mul 1 0; Add 3 0; Mul 25 49; Mul 3 52; Mul 1 0; Add 3 0;
  Mul 28 14; Mul 0 54; Add 2 0; Mul 30 17; Mul 0 18; Add 2 0; Mul 32 20; Mul 0 17; Add 2 0;
  Mul 34 23; Mul 0 16; Add 2 0; Mul 36 22; Mul 0 66; Add 2 0; Mul 38 25; Mul 0 30; Add 2 0;
  Mul 40 28; Mul 0 29; Add 2 0; Mul 42 27; Mul 0 75; Add 2 0; Mul 44 30; Mul 0 39; Add 2 0;
  Mul 46 29; Mul 0 81; Add 2 0; Mul 83 78; Mul 46 0; Add 48 0; Mul 2 81; Mul 45 0; Add 2 0;
  Mul 2 84; Mul 44 0; Add 2 0; Mul 2 87; Mul 43 0; Add 2 0; Mul 95 93; Mul 71 0; Mul 0 97;
  Add 3 0; Mul 73 3; Mul 0 16; Add 2 0; Mul 75 6; Mul 0 16; Add 2 0; Mul 77 9; Mul 0 16; Add 2 0;
  Mul 12 106; Mul 80 0; Mul 0 110; Add 3 0; Mul 82 3; Mul 0 29; Add 2 0; Mul 84 6; Mul 0 29;
  Add 2 0; Mul 9 116; Mul 87 0; Mul 0 120; Add 3 0; Mul 89 3; Mul 0 39; Add 2 0; Mul 6 123;
  Mul 92 0; Mul 0 127; Add 3 0; Mul 91 33; Add 93 0; Mul 89 22; Add 1 0; Mul 87 14; Add 1 0;
  Mul 85 9; Add 1 0; Add 0 39; Mul 38 42; Add 1 0; Mul 37 31; Add 1 0; Mul 36 23; Add 1 0;
  Add 0 33; Mul 32 49; Add 1 0; Mul 31 38; Add 1 0; Add 0 28; Mul 27 54; Add 1 0; Add 0 24;
  Mul 128 69; Mul 0 154; Add 18 0; Mul 130 72; Mul 0 61; Add 2 0; Mul 132 75; Mul 0 51; Add 2 0;
  Mul 134 78; Mul 0 44; Add 2 0; Mul 136 78; Mul 0 166; Add 2 0; Mul 138 81; Mul 0 73; Add 2 0;
  Mul 140 84; Mul 0 63; Add 2 0; Mul 142 84; Mul 0 175; Add 2 0; Mul 144 87; Mul 0 82; Add 2 0;
  Mul 146 87; Mul 0 181; Add 2 0; Mul 183 174; Mul 159 0; Mul 0 185; Add 91 0; Mul 161 3;
  Mul 0 104; Add 2 0; Mul 163 6; Mul 0 104; Add 2 0; Mul 165 9; Mul 0 104; Add 2 0; Mul 12 187;
  Mul 168 0; Mul 0 198; Add 3 0; Mul 170 3; Mul 0 117; Add 2 0; Mul 172 6; Mul 0 117; Add 2 0;
  Mul 9 197; Mul 175 0; Mul 0 208; Add 3 0; Mul 177 3; Mul 0 127; Add 2 0; Mul 6 204; Mul 180 0;
  Mul 0 215; Add 3 0; Mul 179 33; Add 181 0; Mul 177 22; Add 1 0; Mul 175 14; Add 1 0; Mul 173 9;
  Add 1 0; Add 0 39; Mul 38 42; Add 1 0; Mul 37 31; Add 1 0; Mul 36 23; Add 1 0; Add 0 33;
  Mul 32 49; Add 1 0; Mul 31 38; Add 1 0; Add 0 28; Mul 27 54; Add 1 0; Add 0 24; Add 16 86;
  Mul 85 58; Add 1 0; Mul 84 47; Add 1 0; Mul 83 39; Add 1 0; Add 0 81; Mul 80 65; Add 1 0;
  Mul 79 54; Add 1 0; Add 0 77; Mul 76 70; Add 1 0; Add 0 74; Mul 259 259; Add 0 0; Mul 259 0;
  Div 260 264; Mul 1 0; Add 3 264; Add 1 0; Mul 262 262; Mul 260 260; Add 1 0; Mul 267 0; Mul 0 7;
  Mul 271 267; Mul 272 265; Add 1 0; Add 0 274; Add 4 0; Add 9 9; Mul 275 0; Mul 0 15; Add 7 7;
  Add 0 280; Add 2 0; Add 14 15; Mul 281 0; Mul 0 21; Add 12 13; Add 0 286; Add 2 0; Mul 277 277;
  Add 0 21; Mul 288 0; Mul 0 28; Mul 292 281; Add 0 20; Add 0 294; Add 3 0; Add 7 7; Mul 295 0;
  Mul 0 35; Add 6 6; Add 0 300; Add 2 0; Add 34 13; Mul 301 0; Mul 0 41; Add 32 12; Add 0 306;
  Add 2 0; Sub 304 308; Sub 302 309; Sub 179 225; Sub 156 226; Mul 3 3; Mul 3 4; Sub 1 0;
  Div 313 0; Mul 5 7; Mul 7 5; Sub 1 0; Mul 0 3; Mul 11 8; Sub 0 4; Mul 0 6; Sub 138 238;
  Mul 15 14; Sub 12 0; Div 324 0; Mul 15 18; Mul 19 4; Sub 1 0; Mul 0 3; Mul 19 21; Sub 3 0;
  Mul 0 6; Sub 323 334; Sub 116 250; Mul 26 26; Mul 28 2; Sub 1 0; Div 337 0; Mul 16 30; Mul 32 5;
  Sub 1 0; Mul 0 3; Mul 34 8; Mul 21 10; Sub 1 0; Mul 0 7; Sub 105 263; Mul 14 14; Mul 40 15;
  Sub 1 0; Div 350 0; Mul 17 18; Mul 44 5; Sub 1 0; Mul 0 3; Mul 22 8; Sub 0 4; Mul 0 6;
  Sub 101 275; Mul 26 51; Sub 12 0; Div 361 0; Mul 15 29; Mul 30 4; Sub 1 0; Mul 0 3; Mul 19 58;
  Sub 3 0; Mul 0 6; Mul 36 62; Sub 35 0; Div 371 0; Mul 13 64; Mul 40 64; Sub 1 0; Mul 0 3;
  Mul 68 67; Mul 18 70; Sub 1 0; Mul 0 7; Sub 106 116; Sub 101 117; Mul 1 75; Mul 75 1; Sub 1 0;
  Mul 0 71; Mul 79 4; Sub 0 4; Mul 0 74; Sub 103 125; Mul 8 83; Mul 84 1; Sub 1 0; Mul 0 68;
  Mul 12 86; Sub 3 0; Mul 0 71; Sub 103 133; Mul 8 90; Mul 92 1; Sub 1 0; Mul 0 63; Mul 94 4;
  Mul 13 70; Sub 1 0; Mul 0 67; Sub 106 142; Mul 9 74; Mul 100 1; Sub 1 0; Mul 0 59; Mul 78 4;
  Sub 0 4; Mul 0 62; Sub 108 150; Mul 8 82; Mul 83 1; Sub 1 0; Mul 0 56; Mul 12 111; Sub 3 0;
  Mul 0 59; Mul 7 114; Mul 90 42; Sub 1 0; Mul 0 53; Mul 118 45; Mul 12 120; Sub 1 0; Mul 0 57;
  Sub 101 112; Sub 99 110; Sub 38 46; Sub 36 44; Sub 92 116; Sub 89 114; Sub 34 50; Sub 31 48;
  Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 447 0; Mul 13 8; Mul 13 10;
  Sub 1 0; Add 451 0; Sub 95 132; Sub 93 130; Sub 41 66; Sub 39 64; Mul 19 0; Mul 19 2; Sub 1 0;
  Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0; Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0;
  Sub 100 148; Sub 98 146; Sub 49 82; Sub 47 80; Mul 19 0; Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7;
  Sub 1 0; Add 3 0; Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0; Sub 106 164; Sub 103 162;
  Sub 58 98; Sub 55 96; Mul 19 0; Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0;
  Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0; Mul 0 502; Div 499 0; Mul 6 0; Mul 504 504;
  Add 473 480; Add 469 479; Mul 0 2; Add 2 0; Sub 5 0;
  ShowZero 0; (* H *)
  Mul 76 71; Mul 76 73; Sub 1 0; Add 512 0; Mul 76 59; Mul 76 61; Sub 1 0; Add 3 0; Mul 64 47;
  Mul 64 49; Sub 1 0; Add 3 0; Mul 52 35; Mul 52 37; Sub 1 0; Add 3 0; Mul 0 527; Mul 0 24;
  Mul 525 510; Mul 488 0; Add 490 0; Mul 2 513; Mul 487 0; Add 2 0; Mul 2 516; Mul 486 0; Add 2 0;
  Mul 2 519; Mul 485 0; Add 2 0; Mul 537 525; Mul 513 0; Mul 0 539; Add 3 0; Mul 515 3; Mul 0 16;
  Add 2 0; Mul 517 6; Mul 0 16; Add 2 0; Mul 519 9; Mul 0 16; Add 2 0; Mul 12 538; Mul 522 0;
  Mul 0 552; Add 3 0; Mul 524 3; Mul 0 29; Add 2 0; Mul 526 6; Mul 0 29; Add 2 0; Mul 9 548;
  Mul 529 0; Mul 0 562; Add 3 0; Mul 531 3; Mul 0 39; Add 2 0; Mul 6 555; Mul 534 0; Mul 0 569;
  Add 3 0; Mul 533 33; Add 535 0; Mul 531 22; Add 1 0; Mul 529 14; Add 1 0; Mul 527 9; Add 1 0;
  Add 0 39; Mul 38 42; Add 1 0; Mul 37 31; Add 1 0; Mul 36 23; Add 1 0; Add 0 33; Mul 32 49;
  Add 1 0; Mul 31 38; Add 1 0; Add 0 28; Mul 27 54; Add 1 0; Add 0 24; Mul 570 69; Mul 0 596;
  Add 18 0; Mul 572 72; Mul 0 61; Add 2 0; Mul 574 75; Mul 0 51; Add 2 0; Mul 576 78; Mul 0 44;
  Add 2 0; Mul 578 78; Mul 0 608; Add 2 0; Mul 580 81; Mul 0 73; Add 2 0; Mul 582 84; Mul 0 63;
  Add 2 0; Mul 584 84; Mul 0 617; Add 2 0; Mul 586 87; Mul 0 82; Add 2 0; Mul 588 87; Mul 0 623;
  Add 2 0; Mul 625 607; Mul 601 0; Mul 0 627; Add 91 0; Mul 603 3; Mul 0 104; Add 2 0; Mul 605 6;
  Mul 0 104; Add 2 0; Mul 607 9; Mul 0 104; Add 2 0; Mul 12 620; Mul 610 0; Mul 0 640; Add 3 0;
  Mul 612 3; Mul 0 117; Add 2 0; Mul 614 6; Mul 0 117; Add 2 0; Mul 9 630; Mul 617 0; Mul 0 650;
  Add 3 0; Mul 619 3; Mul 0 127; Add 2 0; Mul 6 637; Mul 622 0; Mul 0 657; Add 3 0; Mul 621 33;
  Add 623 0; Mul 619 22; Add 1 0; Mul 617 14; Add 1 0; Mul 615 9; Add 1 0; Add 0 39; Mul 38 42;
  Add 1 0; Mul 37 31; Add 1 0; Mul 36 23; Add 1 0; Add 0 33; Mul 32 49; Add 1 0; Mul 31 38;
  Add 1 0; Add 0 28; Mul 27 54; Add 1 0; Add 0 24; Add 16 86; Mul 85 58; Add 1 0; Mul 84 47;
  Add 1 0; Mul 83 39; Add 1 0; Add 0 81; Mul 80 65; Add 1 0; Mul 79 54; Add 1 0; Add 0 77;
  Mul 76 70; Add 1 0; Add 0 74; Mul 687 687; Mul 685 685; Add 1 0; Mul 702 0; Mul 0 442;
  Mul 706 692; Mul 707 690; Add 1 0; Add 0 709; Add 4 0; Add 9 9; Mul 710 0; Mul 0 450; Add 7 7;
  Add 0 715; Add 2 0; Add 14 15; Mul 716 0; Mul 0 456; Add 12 13; Add 0 721; Add 2 0; Mul 703 703;
  Add 0 21; Mul 723 0; Mul 0 463; Mul 727 707; Add 0 20; Add 0 729; Add 3 0; Add 7 7; Mul 730 0;
  Mul 0 470; Add 6 6; Add 0 735; Add 2 0; Add 34 13; Mul 736 0; Mul 0 476; Add 32 12; Add 0 741;
  Add 2 0; Sub 729 743; Sub 727 744; Sub 172 660; Sub 149 661; Mul 3 3; Mul 3 4; Sub 1 0;
  Div 748 0; Mul 5 7; Mul 7 5; Sub 1 0; Mul 0 3; Mul 11 8; Sub 0 4; Mul 0 6; Sub 131 673;
  Mul 15 14; Sub 12 0; Div 759 0; Mul 15 18; Mul 19 4; Sub 1 0; Mul 0 3; Mul 19 21; Sub 3 0;
  Mul 0 6; Sub 749 769; Sub 109 685; Mul 26 26; Mul 28 2; Sub 1 0; Div 772 0; Mul 16 30; Mul 32 5;
  Sub 1 0; Mul 0 3; Mul 34 8; Mul 21 10; Sub 1 0; Mul 0 7; Sub 98 698; Mul 14 14; Mul 40 15;
  Sub 1 0; Div 785 0; Mul 17 18; Mul 44 5; Sub 1 0; Mul 0 3; Mul 22 8; Sub 0 4; Mul 0 6;
  Sub 94 710; Mul 26 51; Sub 12 0; Div 796 0; Mul 15 29; Mul 30 4; Sub 1 0; Mul 0 3; Mul 19 58;
  Sub 3 0; Mul 0 6; Mul 36 62; Sub 35 0; Div 806 0; Mul 13 64; Mul 40 64; Sub 1 0; Mul 0 3;
  Mul 68 67; Mul 18 70; Sub 1 0; Mul 0 7; Sub 106 551; Sub 101 552; Mul 1 75; Mul 75 1; Sub 1 0;
  Mul 0 71; Mul 79 4; Sub 0 4; Mul 0 74; Sub 103 560; Mul 8 83; Mul 84 1; Sub 1 0; Mul 0 68;
  Mul 12 86; Sub 3 0; Mul 0 71; Sub 103 568; Mul 8 90; Mul 92 1; Sub 1 0; Mul 0 63; Mul 94 4;
  Mul 13 70; Sub 1 0; Mul 0 67; Sub 106 577; Mul 9 74; Mul 100 1; Sub 1 0; Mul 0 59; Mul 78 4;
  Sub 0 4; Mul 0 62; Sub 108 585; Mul 8 82; Mul 83 1; Sub 1 0; Mul 0 56; Mul 12 111; Sub 3 0;
  Mul 0 59; Mul 7 114; Mul 90 42; Sub 1 0; Mul 0 53; Mul 118 45; Mul 12 120; Sub 1 0; Mul 0 57;
  Sub 101 112; Sub 99 110; Sub 38 46; Sub 36 44; Sub 92 116; Sub 89 114; Sub 34 50; Sub 31 48;
  Mul 7 2; Mul 7 4; Sub 1 0; Add 878 0; Mul 9 4; Mul 9 6; Sub 1 0; Add 882 0; Sub 91 128;
  Sub 89 126; Sub 37 62; Sub 35 60; Mul 15 2; Mul 15 4; Sub 1 0; Add 11 0; Mul 17 4; Mul 17 6;
  Sub 1 0; Add 11 0; Sub 92 140; Sub 90 138; Sub 41 74; Sub 39 72; Mul 15 2; Mul 15 4; Sub 1 0;
  Add 11 0; Mul 17 4; Mul 17 6; Sub 1 0; Add 11 0; Sub 94 152; Sub 91 150; Sub 46 86; Sub 43 84;
  Mul 15 2; Mul 15 4; Sub 1 0; Add 11 0; Mul 17 4; Mul 17 6; Sub 1 0; Add 11 0; Mul 4 921;
  Mul 1 922; Div 919 0; Mul 2 0; Constant 4; Mul 0 893; Mul 0 901; Mul 898 898; Sub 1 0;
  Mul 4 904; Mul 0 893; Mul 6 904; Mul 0 900; Add 2 0; Mul 935 905; Add 904 901; Add 0 900;
  Mul 2 0; Sub 4 0; Mul 909 909; Sub 1 0; Mul 942 911; Mul 0 909; Sub 2 0; Mul 911 911; Sub 1 0;
  Sub 22 17; Sub 0 1; Mul 2 443; Add 20 0; Mul 445 445; Mul 3 0; Add 2 0; Sub 425 0;
  ShowZero 0 (* K *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** quadratics on the union-jack grid; size 4.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs, src/space/surface.rs *)
Definition part_3_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the mesh size is not 0 *)
  Unknown 1; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 2; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant 1; Mul 0 5; Add 5 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant 0; Mul 0 9; Add 7 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 11 2; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 11 8; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant (-1); Mul 0 17; Add 17 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 17 2; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8; Mul 5 23; Mul 0 24; Add 21 0;
  Mul 7 26; Mul 27 29; Mul 1 0; Add 3 0; Mul 10 30; Mul 3 33; Mul 1 0; Add 3 0; Mul 34 38;
  Mul 14 0; Mul 0 36; Add 3 0; Mul 16 3; Mul 0 11; Add 2 0; Mul 6 45; Mul 19 0; Mul 0 43; Add 3 0;
  Mul 45 39; Mul 19 0; Add 21 0; Mul 2 42; Mul 18 0; Add 2 0; Mul 51 49; Mul 31 0; Mul 0 53;
  Add 3 0; Mul 33 3; Mul 0 10; Add 2 0; Mul 6 56; Mul 36 0; Mul 0 60; Add 3 0; Mul 62 52;
  Mul 36 0; Add 38 0; Mul 2 55; Mul 35 0; Add 2 0; Mul 68 60; Mul 48 0; Mul 0 70; Add 3 0;
  Mul 50 3; Mul 0 10; Add 2 0; Mul 6 67; Mul 53 0; Mul 0 77; Add 3 0; Mul 79 65; Mul 59 0;
  Mul 0 81; Add 31 0; Mul 61 3; Mul 0 38; Add 2 0; Mul 6 72; Mul 64 0; Mul 0 88; Add 3 0;
  Mul 90 74; Mul 64 0; Add 66 0; Mul 2 77; Mul 63 0; Add 2 0; Add 0 25; Mul 24 6; Add 1 0;
  Add 0 21; Mul 104 104; Mul 103 103; Add 1 0; Mul 103 0; Div 104 110; Mul 1 0; Mul 102 110;
  Mul 103 109; Add 1 0; Add 0 105; Add 4 0; Mul 109 109; Mul 106 106; Add 1 0; Mul 114 0;
  Mul 0 10; Mul 112 114; Mul 113 111; Add 1 0; Add 0 115; Add 4 0; Mul 113 113; Mul 112 112;
  Add 1 0; Mul 124 0; Mul 0 20; Mul 122 118; Mul 123 117; Add 1 0; Add 0 125; Add 4 0;
  Mul 117 117; Add 0 19; Mul 133 0; Mul 0 29; Mul 131 121; Add 0 18; Add 0 133; Add 3 0;
  Mul 123 123; Add 18 0; Mul 141 0; Mul 0 37; Mul 139 127; Add 17 0; Add 0 141; Add 3 0;
  Sub 145 151; Sub 142 150; Sub 87 104; Sub 142 154; Sub 141 153; Sub 73 107; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 156 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Sub 151 169; Sub 76 121; Mul 16 18; Mul 16 2; Sub 1 0; Div 170 0; Mul 18 22; Mul 20 5; Sub 1 0;
  Mul 0 3; Mul 24 8; Mul 23 10; Sub 1 0; Mul 0 7; Sub 163 181; Sub 80 135; Mul 15 1; Sub 0 27;
  Div 183 0; Mul 17 4; Mul 36 4; Sub 1 0; Mul 0 3; Mul 22 7; Mul 22 38; Sub 1 0; Mul 0 7;
  Mul 12 44; Sub 25 0; Div 194 0; Mul 14 46; Mul 16 46; Sub 1 0; Mul 0 3; Mul 48 49; Mul 19 52;
  Sub 1 0; Mul 0 7; Sub 82 92; Sub 73 93; Mul 1 53; Mul 57 1; Sub 1 0; Mul 0 51; Mul 61 4;
  Mul 6 59; Sub 1 0; Mul 0 55; Sub 74 102; Mul 9 65; Mul 63 1; Sub 1 0; Mul 0 46; Mul 67 4;
  Mul 14 53; Sub 1 0; Mul 0 50; Sub 75 111; Mul 9 43; Mul 75 1; Sub 1 0; Mul 0 42; Mul 61 4;
  Mul 14 77; Sub 1 0; Mul 0 46; Mul 8 82; Mul 52 28; Sub 1 0; Mul 0 39; Mul 84 31; Mul 13 88;
  Sub 1 0; Mul 0 43; Sub 64 78; Sub 61 75; Sub 23 32; Sub 20 29; Sub 55 82; Sub 52 79; Sub 18 36;
  Sub 15 33; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 250 0; Mul 13 8;
  Mul 13 10; Sub 1 0; Add 254 0; Sub 60 98; Sub 57 95; Sub 26 52; Sub 23 49; Mul 19 0; Mul 19 2;
  Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0; Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0;
  Mul 0 281; Div 276 0; Mul 6 0; Mul 255 284; Mul 259 285; Mul 2 286; Add 2 1; Sub 1 0;
  ShowZero 0; (* 2H = Δf *)
  Mul 43 38; Mul 43 40; Sub 1 0; Add 282 0; Mul 43 26; Mul 43 28; Sub 1 0; Add 3 0; Mul 0 297;
  Mul 0 15; Mul 271 271; Mul 15 14; Sub 0 1; Add 0 2; Sub 4 0;
  ShowZero 0 (* K is off by f_xy² *)
].

Theorem part_3_size_4_valid : valid part_3_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** quadratics on the union-jack grid; size 8.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs, src/space/surface.rs *)
Definition part_3_size_8 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the mesh size is not 0 *)
  Unknown 1; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 2; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant 1; Mul 0 5; Add 5 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant 0; Mul 0 9; Add 7 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 9 6; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 13 4; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant (-1); Mul 0 17; Add 17 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Add 17 2; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8; Mul 5 23; Mul 0 24; Add 21 0;
  Mul 7 26; Mul 27 29; Mul 1 0; Add 3 0; Mul 10 30; Mul 3 33; Mul 1 0; Add 3 0; Mul 34 38;
  Mul 14 0; Mul 0 36; Add 3 0; Mul 16 3; Mul 0 11; Add 2 0; Mul 6 45; Mul 19 0; Mul 0 43; Add 3 0;
  Mul 45 39; Mul 19 0; Add 21 0; Mul 2 42; Mul 18 0; Add 2 0; Mul 51 49; Mul 31 0; Mul 0 53;
  Add 3 0; Mul 33 3; Mul 0 10; Add 2 0; Mul 6 56; Mul 36 0; Mul 0 60; Add 3 0; Mul 62 54;
  Mul 36 0; Add 38 0; Mul 2 57; Mul 35 0; Add 2 0; Add 0 14; Mul 13 6; Add 1 0; Add 0 10;
  Mul 72 62; Mul 52 0; Mul 0 74; Add 7 0; Mul 54 3; Mul 0 14; Add 2 0; Mul 6 69; Mul 57 0;
  Mul 0 81; Add 3 0; Mul 83 69; Mul 63 0; Mul 0 85; Add 18 0; Mul 65 3; Mul 0 25; Add 2 0;
  Mul 6 76; Mul 68 0; Mul 0 92; Add 3 0; Add 43 8; Mul 7 49; Add 1 0; Add 0 4; Mul 98 82;
  Mul 72 0; Add 74 0; Mul 2 85; Mul 71 0; Add 2 0; Add 0 18; Mul 17 6; Add 1 0; Add 0 14;
  Add 4 33; Mul 32 10; Add 1 0; Add 0 29; Add 8 58; Mul 57 14; Add 1 0; Add 0 54; Mul 120 120;
  Mul 119 119; Add 1 0; Mul 119 0; Div 120 126; Mul 1 0; Mul 118 126; Mul 119 125; Add 1 0;
  Add 0 121; Add 4 0; Mul 125 125; Mul 122 122; Add 1 0; Mul 130 0; Mul 0 10; Mul 128 130;
  Mul 129 127; Add 1 0; Add 0 131; Add 4 0; Mul 129 129; Add 10 0; Mul 139 0; Mul 0 19;
  Mul 137 133; Add 9 0; Add 0 139; Add 3 0; Mul 135 135; Add 0 8; Mul 147 0; Mul 0 27;
  Mul 145 139; Add 0 8; Add 0 147; Add 3 0; Mul 139 139; Add 0 16; Mul 155 0; Mul 0 35;
  Mul 153 143; Add 0 16; Add 0 155; Add 3 0; Add 7 32; Mul 162 0; Mul 0 42; Add 6 30; Add 0 161;
  Add 2 0; Mul 151 151; Add 14 0; Mul 169 0; Mul 0 49; Mul 167 155; Add 14 0; Add 0 169; Add 3 0;
  Add 29 7; Mul 176 0; Mul 0 56; Add 28 6; Add 0 175; Add 2 0; Add 53 13; Mul 182 0; Mul 0 62;
  Add 51 12; Add 0 181; Add 2 0; Sub 185 191; Sub 182 190; Sub 127 144; Sub 182 192; Sub 119 146;
  Mul 4 1; Mul 4 5; Sub 1 0; Div 195 0; Mul 6 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 11 13;
  Sub 1 0; Mul 0 7; Sub 194 208; Sub 122 160; Mul 15 1; Sub 14 0; Div 208 0; Mul 17 18; Mul 19 4;
  Sub 1 0; Mul 0 3; Mul 25 7; Mul 22 9; Sub 1 0; Mul 0 7; Sub 203 221; Sub 124 173; Mul 14 28;
  Mul 29 2; Sub 1 0; Div 222 0; Mul 17 32; Mul 33 5; Sub 1 0; Mul 0 3; Mul 22 8; Mul 22 10;
  Sub 1 0; Mul 0 7; Sub 133 186; Mul 14 43; Sub 0 12; Div 234 0; Mul 16 46; Mul 45 4; Sub 1 0;
  Mul 0 3; Mul 21 7; Mul 21 22; Sub 1 0; Mul 0 7; Sub 227 245; Sub 136 199; Mul 27 1; Mul 57 28;
  Sub 1 0; Div 248 0; Mul 17 5; Mul 61 5; Sub 1 0; Mul 0 3; Mul 35 8; Mul 22 36; Sub 1 0; Mul 0 7;
  Sub 145 212; Mul 14 53; Sub 13 0; Div 260 0; Mul 16 17; Mul 18 4; Sub 1 0; Mul 0 3; Mul 47 7;
  Mul 21 61; Sub 1 0; Mul 0 7; Sub 153 224; Mul 65 26; Mul 27 83; Sub 1 0; Div 273 0; Mul 16 30;
  Mul 31 5; Sub 1 0; Mul 0 3; Mul 73 8; Mul 21 91; Sub 1 0; Mul 0 7; Mul 94 93; Sub 0 11;
  Div 284 0; Mul 15 96; Mul 42 96; Sub 1 0; Mul 0 3; Mul 101 99; Mul 20 102; Sub 1 0; Mul 0 7;
  Sub 156 166; Sub 149 167; Mul 1 104; Mul 107 1; Sub 1 0; Mul 0 102; Mul 111 4; Mul 6 112;
  Sub 1 0; Mul 0 106; Sub 150 176; Mul 9 113; Mul 114 1; Sub 1 0; Mul 0 98; Mul 120 4; Mul 14 104;
  Sub 1 0; Mul 0 102; Sub 151 185; Mul 9 122; Mul 123 1; Sub 1 0; Mul 0 93; Mul 112 4; Mul 14 100;
  Sub 1 0; Mul 0 97; Sub 154 194; Mul 9 133; Mul 132 1; Sub 1 0; Mul 0 90; Mul 108 4; Mul 14 109;
  Sub 1 0; Mul 0 94; Sub 155 203; Mul 9 87; Mul 143 1; Sub 1 0; Mul 0 85; Mul 117 4; Mul 14 118;
  Sub 1 0; Mul 0 89; Sub 158 212; Mul 9 96; Mul 97 1; Sub 1 0; Mul 0 82; Mul 126 4; Mul 14 140;
  Sub 1 0; Mul 0 86; Sub 161 221; Mul 9 105; Mul 106 1; Sub 1 0; Mul 0 78; Mul 148 4; Mul 14 166;
  Sub 1 0; Mul 0 82; Mul 8 168; Mul 114 64; Sub 1 0; Mul 0 75; Mul 173 67; Mul 13 174; Sub 1 0;
  Mul 0 79; Sub 152 165; Sub 149 162; Sub 59 68; Sub 56 65; Sub 142 169; Sub 139 166; Sub 54 72;
  Sub 51 69; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 376 0; Mul 13 8;
  Mul 13 10; Sub 1 0; Add 380 0; Sub 146 185; Sub 143 182; Sub 61 88; Sub 58 85; Mul 19 0;
  Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0; Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0;
  Add 15 0; Sub 148 201; Sub 145 198; Sub 68 104; Sub 65 101; Mul 19 0; Mul 19 2; Sub 1 0;
  Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0; Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0;
  Sub 152 217; Sub 149 214; Sub 75 120; Sub 72 117; Mul 19 0; Mul 19 2; Sub 1 0; Mul 20 5;
  Mul 20 7; Sub 1 0; Add 3 0; Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0; Sub 155 233;
  Sub 152 230; Sub 82 136; Sub 79 133; Mul 19 0; Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0;
  Add 3 0; Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0; Sub 160 249; Sub 157 246; Sub 90 152;
  Sub 87 149; Mul 19 0; Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0; Add 15 0;
  Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0; Mul 0 471; Div 466 0; Mul 6 0; Mul 445 474; Mul 449 475;
  Mul 2 476; Add 2 1; Sub 1 0;
  ShowZero 0; (* 2H = Δf *)
  Mul 107 102; Mul 107 104; Sub 1 0; Add 472 0; Mul 107 90; Mul 107 92; Sub 1 0; Add 3 0;
  Mul 95 78; Mul 95 80; Sub 1 0; Add 3 0; Mul 83 66; Mul 83 68; Sub 1 0; Add 3 0; Mul 71 54;
  Mul 71 56; Sub 1 0; Add 3 0; Mul 59 42; Mul 59 44; Sub 1 0; Add 3 0; Mul 0 503; Mul 0 31;
  Mul 477 477; Neg 0; Mul 32 31; Sub 0 2; Add 0 2; Sub 5 0;
  ShowZero 0 (* K is off by f_xy² *)
].

Theorem part_3_size_8_valid : valid part_3_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** one star that is no lattice star; size 1.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_4_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 3;
  Nonzero 0; (* 3 != 0 in the field *)
  Constant 5;
  Nonzero 0; (* 5 != 0 in the field *)
  Constant 31;
  Nonzero 0; (* 31 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the mesh size is not 0 *)
  Constant 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 6 2; Add 2 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 4 5; Add 5 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant 1; Mul 0 9; Add 9 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant (-1); Mul 0 13; Add 13 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant (-2); Mul 0 17; Add 17 0; Sub 0 0;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 19 19; Mul 17 17; Mul 11 11; Mul 8 8; Mul 5 5; Add 4 4; Mul 17 0; Div 18 31; Mul 1 0;
  Add 3 28; Add 1 0; Mul 24 24; Add 10 0; Mul 24 0; Mul 0 6; Mul 34 31; Mul 35 29; Add 1 0;
  Add 0 37; Add 4 0; Add 17 17; Mul 32 0; Mul 0 14; Mul 42 32; Add 0 0; Add 0 44; Add 3 0;
  Add 23 24; Mul 39 0; Mul 0 21; Mul 49 35; Add 0 7; Add 0 51; Add 3 0; Add 29 30; Mul 46 0;
  Mul 0 28; Mul 56 38; Add 0 7; Add 0 58; Add 3 0; Add 38 36; Mul 53 0; Mul 0 35; Add 20 6;
  Add 0 64; Add 2 0; Sub 63 66; Sub 61 67; Sub 47 48; Sub 59 69; Sub 48 50; Mul 4 1; Mul 4 2;
  Sub 1 0; Div 66 0; Mul 6 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Sub 0 4; Mul 0 6; Sub 68 82;
  Sub 60 63; Mul 14 14; Mul 15 2; Sub 1 0; Div 79 0; Mul 17 18; Mul 19 5; Sub 1 0; Mul 0 3;
  Mul 21 9; Sub 3 0; Mul 0 6; Sub 77 95; Sub 72 76; Mul 14 14; Mul 28 2; Sub 1 0; Div 92 0;
  Mul 17 18; Mul 32 5; Sub 1 0; Mul 0 3; Mul 22 8; Mul 22 10; Sub 1 0; Mul 0 7; Mul 13 13;
  Mul 27 40; Sub 1 0; Div 104 0; Mul 16 17; Mul 31 43; Sub 1 0; Mul 0 3; Mul 21 46; Mul 21 48;
  Sub 1 0; Mul 0 7; Mul 51 53; Mul 26 55; Sub 1 0; Div 116 0; Mul 54 57; Mul 30 57; Sub 1 0;
  Mul 0 3; Mul 59 60; Mul 59 63; Sub 1 0; Mul 0 7; Sub 94 103; Sub 88 104; Mul 1 65; Mul 68 1;
  Sub 1 0; Mul 0 63; Mul 72 4; Sub 0 4; Mul 0 66; Sub 89 112; Mul 8 73; Mul 74 1; Sub 1 0;
  Mul 0 58; Mul 12 64; Sub 3 0; Mul 0 61; Sub 90 120; Mul 8 68; Mul 82 1; Sub 1 0; Mul 0 53;
  Mul 72 4; Mul 13 60; Sub 1 0; Mul 0 57; Sub 93 129; Mul 9 64; Mul 78 1; Sub 1 0; Mul 0 50;
  Mul 68 4; Mul 14 95; Sub 1 0; Mul 0 54; Mul 8 100; Mul 73 35; Sub 1 0; Mul 0 46; Mul 102 38;
  Mul 13 106; Sub 1 0; Mul 0 50; Sub 84 97; Sub 82 95; Sub 31 39; Sub 29 37; Sub 75 101;
  Sub 72 99; Sub 27 43; Sub 24 41; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0;
  Add 191 0; Mul 13 8; Mul 13 10; Sub 1 0; Add 195 0; Sub 79 117; Sub 76 115; Sub 34 59;
  Sub 31 57; Mul 19 0; Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0; Add 15 0;
  Mul 25 8; Mul 25 10; Sub 1 0; Add 15 0; Sub 83 133; Sub 80 131; Sub 42 75; Sub 39 73; Mul 19 0;
  Mul 19 2; Sub 1 0; Mul 20 5; Mul 20 7; Sub 1 0; Add 3 0; Add 15 0; Mul 25 8; Mul 25 10; Sub 1 0;
  Add 15 0; Mul 0 233; Div 221 0; Mul 6 0; Mul 0 236; Constant 68; Div 0 235; Sub 2 0;
  ShowZero 0; (* 2H *)
  Mul 58 53; Mul 58 55; Sub 1 0; Add 238 0; Mul 58 41; Mul 58 43; Sub 1 0; Add 3 0; Mul 46 29;
  Mul 46 31; Sub 1 0; Add 3 0; Mul 0 252; Mul 0 18; Constant 412; Constant 775; Div 1 0; Sub 3 0;
  ShowZero 0 (* K *)
].

Theorem part_4_size_1_valid : valid part_4_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
