(** remark-1 (Sec. 3.2, Remark 1)

    The map τ of (12) sends an i-circular mesh to a conical mesh with unit normals in the field:
    the corners of a face become oriented planes that touch the cone of its circle.
    i-M-transformations map i-circular meshes to such, circle to circle; seen through τ they are
    L-transformations, cone to cone.

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a face and its cone; size 4.
    Code: src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs,
    src/space/laguerre/cone.rs, src/space/laguerre/plane.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Mul 6 6; Mul 6 6; Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 6 19; Constant 1; Div 0 1; Mul 6 12;
  Mul 15 4; Sub 1 0; Mul 0 3; Mul 19 7; Mul 11 18; Sub 1 0; Mul 0 7; Add 29 4; Add 29 1; Mul 6 6;
  Mul 3 3; Add 1 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3; Add 18 0;
  Nonzero 0; (* no face circle is the image of a great circle *)
  Mul 39 39; Mul 39 39; Add 1 0; Add 22 0;
  Nonzero 0; (* 1 + |x'|² is not 0 *)
  Mul 41 41; Mul 41 41; Add 1 0; Add 26 0;
  Nonzero 0; (* 1 + |x'|² is not 0 *)
  Mul 43 43; Mul 43 43; Add 1 0; Add 30 0;
  Nonzero 0; (* 1 + |x'|² is not 0 *)
  Unknown 6; Unknown 7; Mul 1 1; Mul 1 1; Add 1 0; Add 36 0;
  Nonzero 0; (* 1 + |x'|² is not 0 *)
  Sub 5 57; Sub 5 57; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 44; Mul 1 54; Sub 1 0; Mul 3 57; Mul 8 48;
  Sub 1 0; Mul 10 59; Mul 10 61; Sub 1 0; Mul 65 6; Mul 65 4; Add 1 0; Mul 59 3; Add 1 0;
  Zero 0; (* M is i-circular *)
  Div 56 33; Mul 78 0; Mul 78 0; Mul 78 1; Sub 60 38; Mul 0 4; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3;
  Add 1 0; Sub 0 67;
  ShowZero 0; (* unit normal *)
  Unknown 8; Unknown 9; Unknown 10; Mul 2 91; Mul 2 91; Add 1 0; Add 0 3; Div 75 56; Mul 97 0;
  Mul 6 0; Neg 0; Mul 0 69; Sub 0 11; Mul 2 70; Sub 0 12; Mul 8 25; Mul 25 3; Mul 25 2; Add 1 0;
  Mul 25 8; Add 1 0; Add 0 5;
  ShowZero 0; (* through the vertex of the cone *)
  Mul 80 13; Mul 80 14; Sub 92 74; Mul 0 17; Mul 35 3; Mul 35 3; Add 1 0; Mul 35 3; Add 1 0;
  Sub 0 99;
  ShowZero 0; (* touches the cone *)
  Div 100 73; Mul 122 0; Mul 120 0; Mul 120 1; Sub 104 78; Mul 0 4; Mul 3 3; Mul 3 3; Add 1 0;
  Mul 3 3; Add 1 0; Sub 0 111;
  ShowZero 0; (* unit normal *)
  Mul 43 130; Mul 43 130; Add 1 0; Add 0 44; Mul 0 14; Mul 14 36; Mul 14 35; Add 1 0; Mul 14 41;
  Add 1 0; Add 0 5;
  ShowZero 0; (* through the vertex of the cone *)
  Mul 20 32; Mul 20 32; Add 1 0; Mul 20 32; Add 1 0; Sub 0 128;
  ShowZero 0; (* touches the cone *)
  Div 129 98; Mul 151 0; Mul 147 0; Mul 147 1; Sub 133 103; Mul 0 4; Mul 3 3; Mul 3 3; Add 1 0;
  Mul 3 3; Add 1 0; Sub 0 140;
  ShowZero 0; (* unit normal *)
  Mul 72 157; Mul 72 157; Add 1 0; Add 0 73; Mul 0 14; Mul 14 65; Mul 14 64; Add 1 0; Mul 14 70;
  Add 1 0; Add 0 5;
  ShowZero 0; (* through the vertex of the cone *)
  Mul 20 61; Mul 20 61; Add 1 0; Mul 20 61; Add 1 0; Sub 0 157;
  ShowZero 0; (* touches the cone *)
  Div 158 121; Mul 180 0; Mul 128 0; Mul 128 1; Sub 162 126; Mul 0 4; Mul 3 3; Mul 3 3; Add 1 0;
  Mul 3 3; Add 1 0; Sub 0 169;
  ShowZero 0; (* unit normal *)
  Mul 101 138; Mul 101 138; Add 1 0; Add 0 102; Mul 0 14; Mul 14 94; Mul 14 93; Add 1 0;
  Mul 14 99; Add 1 0; Add 0 5;
  ShowZero 0; (* through the vertex of the cone *)
  Mul 20 90; Mul 20 90; Add 1 0; Mul 20 90; Add 1 0; Sub 0 186;
  ShowZero 0 (* touches the cone *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face and its image; size 4.
    Code: src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs, src/space/moebius.rs,
    src/space/plane.rs, src/space/point.rs, src/space/similarity.rs, src/space/sphere.rs *)
Definition part_2_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Mul 12 12; Mul 12 12; Add 1 0;
  Nonzero 0; (* no vertex lies over the centre *)
  Mul 13 13; Mul 13 13; Add 1 0;
  Nonzero 0; (* no vertex lies over the centre *)
  Mul 14 14; Mul 14 14; Add 1 0;
  Nonzero 0; (* no vertex lies over the centre *)
  Unknown 6; Unknown 7; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no vertex lies over the centre *)
  Mul 20 20; Mul 20 20; Add 1 0; Mul 21 21; Mul 21 21; Add 1 0; Mul 20 33; Constant 1; Div 0 1;
  Mul 6 26; Mul 29 4; Sub 1 0; Mul 0 3; Mul 33 7; Mul 11 32; Sub 1 0; Mul 0 7; Add 43 4; Add 43 1;
  Mul 6 6; Mul 3 3; Add 1 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3;
  Nonzero 0; (* no face circle passes through the centre *)
  Sub 30 52; Sub 30 52; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 25; Mul 1 49; Sub 1 0; Mul 3 52;
  Mul 8 29; Sub 1 0; Mul 10 54; Mul 10 56; Sub 1 0; Mul 60 6; Mul 60 4; Add 1 0; Mul 40 3;
  Add 1 0;
  Zero 0; (* M is i-circular *)
  ShowNonzero 37; (* as src/space/sphere.rs finds *)
  Unknown 8; Unknown 9; Unknown 10; Mul 2 74; Mul 2 74; Add 1 0; Add 0 3; Unknown 11; Unknown 12;
  Unknown 13; Unknown 14; Constant 0; Mul 0 0; Add 0 0; Sub 0 51; Div 52 87; Mul 1 0; Neg 5;
  Div 90 55; Sub 7 7; Neg 3; Neg 58; Mul 2 1; Mul 3 5; Add 1 0; Add 0 1; Mul 6 4; Add 1 0;
  Mul 0 9; Mul 0 66; Sub 10 0; Add 0 19; Mul 3 14; Sub 13 0; Add 0 22; Mul 6 18; Sub 16 0;
  Add 0 25; Sub 75 26; Mul 0 18; Add 0 16; Add 0 17; Add 0 15; Mul 0 24; Mul 0 81; Sub 6 0;
  Add 0 34; Mul 3 29; Sub 28 0; Add 0 37; Mul 6 33; Sub 31 0; Add 0 40; Sub 6 21; Sub 4 19;
  Sub 2 17; Mul 17 38; Add 34 0; Add 0 34; Add 0 32; Mul 0 41; Mul 0 98; Sub 42 0; Add 0 51;
  Mul 3 46; Sub 26 0; Add 0 54; Sub 47 2; Add 0 56; Mul 8 52; Sub 50 0; Add 0 59; Sub 8 40;
  Sub 6 38; Sub 5 39; Sub 3 37; Add 51 19; Add 0 50; Mul 0 59; Mul 0 116; Sub 60 0; Add 0 69;
  Mul 3 64; Sub 63 0; Add 0 72; Sub 46 2; Add 0 74; Mul 8 70; Sub 68 0; Add 0 77; Sub 8 58;
  Sub 6 56; Sub 5 57; Sub 3 55; Mul 55 72; Add 69 0; Mul 0 77; Mul 0 134; Sub 78 0; Add 0 87;
  Mul 3 82; Sub 81 0; Add 0 90; Mul 6 86; Sub 65 0; Add 0 93; Sub 6 74; Sub 4 72; Sub 2 70;
  Add 101 101; Add 101 101; Add 101 101; Add 101 101; Mul 91 59; Mul 96 59; Add 1 0; Add 0 1;
  Mul 99 61; Add 1 0; Mul 101 65; Mul 98 65; Add 1 0; Add 0 7; Add 0 5; Add 4 9; Add 0 4; Add 0 8;
  Add 2 12; Mul 106 72; Add 1 0; Mul 108 57; Mul 113 57; Add 1 0; Mul 115 58; Add 1 0; Mul 117 59;
  Add 1 0; Mul 119 64; Mul 116 64; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 121 68; Add 1 0;
  Add 0 9; Add 3 12; Mul 125 71; Add 1 0; Mul 127 58; Mul 132 58; Add 1 0; Mul 134 59; Add 1 0;
  Mul 136 60; Add 1 0; Mul 138 65; Mul 135 65; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 140 69;
  Add 1 0; Add 0 9; Add 3 12; Mul 144 72; Add 1 0; Mul 146 61; Mul 151 61; Add 1 0; Add 0 1;
  Mul 154 63; Add 1 0; Mul 156 67; Mul 153 67; Add 1 0; Add 0 7; Add 0 5; Add 4 9; Add 0 4;
  Add 0 8; Add 2 12; Mul 161 74; Add 1 0; Mul 222 222; Mul 164 154; Mul 169 152; Add 1 0; Add 0 1;
  Mul 172 152; Add 1 0; Mul 174 160; Mul 171 158; Add 1 0; Add 0 7; Add 0 5; Add 4 9; Add 0 4;
  Add 0 8; Add 2 12; Mul 179 163; Add 1 0; Add 11 93; Add 7 93; Add 5 93; Add 3 93; Mul 244 88;
  Mul 196 84; Add 1 0; Mul 198 83; Add 1 0; Mul 200 82; Add 1 0; Mul 202 95; Mul 252 91; Add 1 0;
  Add 0 6; Add 0 5; Add 4 10; Mul 257 93; Add 1 0; Add 0 9; Add 3 12; Mul 261 94; Add 1 0;
  Mul 263 89; Mul 215 85; Add 1 0; Mul 217 83; Add 1 0; Mul 219 82; Add 1 0; Mul 221 96;
  Mul 271 92; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 276 93; Add 1 0; Add 0 9; Add 3 12;
  Mul 280 94; Add 1 0; Mul 282 89; Mul 234 85; Add 1 0; Mul 236 83; Add 1 0; Mul 238 82; Add 1 0;
  Mul 240 96; Mul 290 92; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 295 93; Add 1 0; Add 0 9;
  Add 3 12; Mul 299 94; Add 1 0; Mul 301 90; Mul 253 86; Add 1 0; Mul 255 85; Add 1 0; Mul 257 84;
  Add 1 0; Mul 259 97; Mul 309 93; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 314 95; Add 1 0;
  Add 0 9; Add 3 12; Mul 318 96; Add 1 0; Mul 97 320; Mul 321 80; Mul 273 80; Add 1 0; Mul 275 81;
  Add 1 0; Mul 277 82; Add 1 0; Mul 279 87; Mul 329 87; Add 1 0; Add 0 6; Add 0 5; Add 4 10;
  Mul 334 91; Add 1 0; Add 0 9; Add 3 12; Mul 338 94; Add 1 0; Add 12 295; Add 8 295; Add 5 295;
  Add 3 295; Sub 363 295; Mul 0 292; Neg 380; Neg 380; Mul 97 348; Mul 79 2; Add 1 0; Mul 62 3;
  Add 1 0; Mul 45 7; Add 1 0; Mul 99 355; Mul 81 9; Add 1 0; Mul 64 10; Add 1 0; Mul 47 14;
  Add 1 0; Mul 102 362; Mul 84 16; Add 1 0; Mul 67 17; Add 1 0; Mul 50 21; Add 1 0; Mul 106 369;
  Mul 88 23; Add 1 0; Mul 71 24; Add 1 0; Mul 54 28; Add 1 0; Mul 55 332; Neg 33; Neg 37;
  Mul 24 1; Mul 18 38; Add 1 0; Mul 13 39; Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Div 387 32; Neg 26;
  Mul 0 1; Neg 21; Mul 0 3; Mul 5 4; Mul 375 340; Neg 384; Neg 384; Mul 126 1; Add 48 0;
  Mul 109 2; Add 1 0; Mul 92 6; Add 1 0; Mul 127 7; Add 47 0; Mul 110 8; Add 1 0; Mul 93 12;
  Add 1 0; Mul 129 13; Add 46 0; Mul 112 14; Add 1 0; Mul 95 18; Add 1 0; Mul 132 19; Add 45 0;
  Mul 115 20; Add 1 0; Mul 98 24; Add 1 0; Mul 169 371; Mul 151 383; Add 1 0; Mul 134 384;
  Add 1 0; Mul 117 385; Add 1 0; Mul 171 378; Mul 153 390; Add 1 0; Mul 136 391; Add 1 0;
  Mul 119 392; Add 1 0; Mul 174 385; Mul 156 397; Add 1 0; Mul 139 398; Add 1 0; Mul 122 399;
  Add 1 0; Mul 178 392; Mul 160 404; Add 1 0; Mul 143 405; Add 1 0; Mul 126 406; Add 1 0;
  Add 21 107; Add 15 107; Add 9 107; Add 3 107; Div 452 50; Mul 4 0; Mul 0 46; Mul 1 41; Mul 2 36;
  Sub 7 2; Sub 7 2; Sub 7 2; Mul 2 70; Mul 2 69; Add 1 0; Add 0 3; Sub 71 0;
  ShowZero 0; (* in the plane of the image of the circle *)
  Neg 57; Mul 0 13; Neg 53; Mul 0 15; Mul 455 148; Mul 17 17; Mul 1 0; Sub 5 82; Sub 4 81;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* on the image of the circle *)
  Mul 440 510; Mul 440 510; Add 1 0; Add 0 441; Sub 498 433; Mul 0 430; Neg 516; Neg 516;
  Mul 216 1; Add 138 0; Mul 199 2; Add 1 0; Mul 182 6; Add 1 0; Mul 217 7; Add 137 0; Mul 200 8;
  Add 1 0; Mul 183 12; Add 1 0; Mul 219 13; Add 136 0; Mul 202 14; Add 1 0; Mul 185 18; Add 1 0;
  Mul 222 19; Add 135 0; Mul 205 20; Add 1 0; Mul 188 24; Add 1 0; Mul 189 28; Mul 19 133;
  Mul 14 170; Add 1 0; Mul 10 171; Add 1 0; Mul 6 137; Add 1 0; Sub 7 0; Div 519 27; Neg 22;
  Mul 0 1; Neg 18; Mul 0 3; Mul 5 4; Mul 67 3; Mul 67 2; Add 1 0; Add 0 68; Sub 4 0;
  ShowZero 0; (* in the plane of the image of the circle *)
  Sub 63 8; Sub 62 7; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 63;
  ShowZero 0; (* on the image of the circle *)
  Mul 498 566; Mul 498 566; Add 1 0; Add 0 499; Sub 553 491; Mul 0 488; Neg 572; Neg 572;
  Mul 274 1; Add 196 0; Mul 257 2; Add 1 0; Mul 240 6; Add 1 0; Mul 275 7; Add 195 0; Mul 258 8;
  Add 1 0; Mul 241 12; Add 1 0; Mul 277 13; Add 194 0; Mul 260 14; Add 1 0; Mul 243 18; Add 1 0;
  Mul 280 19; Add 193 0; Mul 263 20; Add 1 0; Mul 246 24; Add 1 0; Mul 247 28; Mul 19 191;
  Mul 14 228; Add 1 0; Mul 10 229; Add 1 0; Mul 6 195; Add 1 0; Sub 7 0; Div 577 27; Neg 22;
  Mul 0 1; Neg 18; Mul 0 3; Mul 5 4; Mul 125 3; Mul 125 2; Add 1 0; Add 0 126; Sub 4 0;
  ShowZero 0; (* in the plane of the image of the circle *)
  Sub 121 8; Sub 120 7; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 121;
  ShowZero 0; (* on the image of the circle *)
  Mul 556 606; Mul 556 606; Add 1 0; Add 0 557; Sub 606 549; Mul 0 546; Neg 612; Neg 612;
  Mul 332 1; Add 254 0; Mul 315 2; Add 1 0; Mul 298 6; Add 1 0; Mul 333 7; Add 253 0; Mul 316 8;
  Add 1 0; Mul 299 12; Add 1 0; Mul 335 13; Add 252 0; Mul 318 14; Add 1 0; Mul 301 18; Add 1 0;
  Mul 338 19; Add 251 0; Mul 321 20; Add 1 0; Mul 304 24; Add 1 0; Mul 305 28; Mul 19 249;
  Mul 14 286; Add 1 0; Mul 10 287; Add 1 0; Mul 6 253; Add 1 0; Sub 7 0; Div 635 27; Neg 22;
  Mul 0 1; Neg 18; Mul 0 3; Mul 5 4; Mul 183 3; Mul 183 2; Add 1 0; Add 0 184; Sub 4 0;
  ShowZero 0; (* in the plane of the image of the circle *)
  Sub 179 8; Sub 178 7; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 179;
  ShowZero 0; (* on the image of the circle *)
  Sub 130 262; Sub 129 261; Sub 129 261; Sub 75 265; Sub 74 264; Sub 74 264; Sub 20 268;
  Sub 19 267; Sub 19 267; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* planar *)
  Mul 22 22; Mul 22 22; Add 1 0; Mul 22 22; Mul 22 22; Add 1 0; Mul 22 22; Mul 22 22; Add 1 0;
  Mul 24 3; Mul 1 28; Sub 1 0; Mul 3 31; Mul 29 7; Sub 1 0; Mul 31 33; Mul 31 35; Sub 1 0;
  Mul 40 6; Mul 40 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0 (* i-circular *)
].

Theorem part_2_size_4_valid : valid part_2_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** L-transformations of the cone; size 1.
    Code: src/scalar/ring.rs, src/space/laguerre/cone.rs, src/space/laguerre/sphere.rs,
    src/space/laguerre/transformation.rs, src/space/moebius.rs, src/space/point.rs,
    src/space/similarity.rs, src/space/sphere.rs *)
Definition part_3_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Mul 2 2; Mul 2 2; Add 1 0; Sub 0 3;
  Nonzero 0; (* no face circle passes through the centre *)
  Constant 1; Add 0 1;
  Nonzero 0; (* no face circle is the image of a great circle *)
  ShowNonzero 1; (* as src/space/sphere.rs finds *)
  Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8; Unknown 9; Constant 0;
  Mul 0 0; Add 0 0; Sub 0 11; Div 12 20; Mul 1 0; Neg 5; Div 23 15; Sub 7 7; Neg 3; Neg 18;
  Mul 2 1; Mul 3 5; Add 1 0; Add 0 1; Mul 6 4; Add 1 0; Mul 0 9; Mul 0 26; Sub 10 0; Add 0 19;
  Mul 3 14; Sub 13 0; Add 0 22; Mul 6 18; Sub 16 0; Add 0 25; Sub 35 26; Mul 0 18; Add 0 16;
  Add 0 17; Add 0 15; Mul 0 24; Mul 0 41; Sub 6 0; Add 0 34; Mul 3 29; Sub 28 0; Add 0 37;
  Mul 6 33; Sub 31 0; Add 0 40; Sub 6 21; Sub 4 19; Sub 2 17; Mul 17 38; Add 34 0; Add 0 34;
  Add 0 32; Mul 0 41; Mul 0 58; Sub 42 0; Add 0 51; Mul 3 46; Sub 26 0; Add 0 54; Sub 47 2;
  Add 0 56; Mul 8 52; Sub 50 0; Add 0 59; Sub 8 40; Sub 6 38; Sub 5 39; Sub 3 37; Add 51 19;
  Add 0 50; Mul 0 59; Mul 0 76; Sub 60 0; Add 0 69; Mul 3 64; Sub 63 0; Add 0 72; Sub 46 2;
  Add 0 74; Mul 8 70; Sub 68 0; Add 0 77; Sub 8 58; Sub 6 56; Sub 5 57; Sub 3 55; Mul 55 72;
  Add 69 0; Mul 0 77; Mul 0 94; Sub 78 0; Add 0 87; Mul 3 82; Sub 81 0; Add 0 90; Mul 6 86;
  Sub 65 0; Add 0 93; Sub 6 74; Sub 4 72; Sub 2 70; Add 101 101; Add 101 101; Add 101 101;
  Add 101 101; Mul 91 59; Mul 96 59; Add 1 0; Add 0 1; Mul 99 61; Add 1 0; Mul 101 65; Mul 98 65;
  Add 1 0; Add 0 7; Add 0 5; Add 4 9; Add 0 4; Add 0 8; Add 2 12; Mul 106 72; Add 1 0; Mul 108 57;
  Mul 113 57; Add 1 0; Mul 115 58; Add 1 0; Mul 117 59; Add 1 0; Mul 119 64; Mul 116 64; Add 1 0;
  Add 0 6; Add 0 5; Add 4 10; Mul 121 68; Add 1 0; Add 0 9; Add 3 12; Mul 125 71; Add 1 0;
  Mul 127 58; Mul 132 58; Add 1 0; Mul 134 59; Add 1 0; Mul 136 60; Add 1 0; Mul 138 65;
  Mul 135 65; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 140 69; Add 1 0; Add 0 9; Add 3 12;
  Mul 144 72; Add 1 0; Mul 146 61; Mul 151 61; Add 1 0; Add 0 1; Mul 154 63; Add 1 0; Mul 156 67;
  Mul 153 67; Add 1 0; Add 0 7; Add 0 5; Add 4 9; Add 0 4; Add 0 8; Add 2 12; Mul 161 74; Add 1 0;
  Mul 182 182; Mul 164 154; Mul 169 152; Add 1 0; Add 0 1; Mul 172 152; Add 1 0; Mul 174 160;
  Mul 171 158; Add 1 0; Add 0 7; Add 0 5; Add 4 9; Add 0 4; Add 0 8; Add 2 12; Mul 179 163;
  Add 1 0; Add 11 93; Add 7 93; Add 5 93; Add 3 93; Mul 204 88; Mul 196 84; Add 1 0; Mul 198 83;
  Add 1 0; Mul 200 82; Add 1 0; Mul 202 95; Mul 212 91; Add 1 0; Add 0 6; Add 0 5; Add 4 10;
  Mul 217 93; Add 1 0; Add 0 9; Add 3 12; Mul 221 94; Add 1 0; Mul 223 89; Mul 215 85; Add 1 0;
  Mul 217 83; Add 1 0; Mul 219 82; Add 1 0; Mul 221 96; Mul 231 92; Add 1 0; Add 0 6; Add 0 5;
  Add 4 10; Mul 236 93; Add 1 0; Add 0 9; Add 3 12; Mul 240 94; Add 1 0; Mul 242 89; Mul 234 85;
  Add 1 0; Mul 236 83; Add 1 0; Mul 238 82; Add 1 0; Mul 240 96; Mul 250 92; Add 1 0; Add 0 6;
  Add 0 5; Add 4 10; Mul 255 93; Add 1 0; Add 0 9; Add 3 12; Mul 259 94; Add 1 0; Mul 261 90;
  Mul 253 86; Add 1 0; Mul 255 85; Add 1 0; Mul 257 84; Add 1 0; Mul 259 97; Mul 269 93; Add 1 0;
  Add 0 6; Add 0 5; Add 4 10; Mul 274 95; Add 1 0; Add 0 9; Add 3 12; Mul 278 96; Add 1 0;
  Mul 97 280; Mul 281 80; Mul 273 80; Add 1 0; Mul 275 81; Add 1 0; Mul 277 82; Add 1 0;
  Mul 279 87; Mul 289 87; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Add 0 9; Mul 295 91; Add 1 0;
  Add 9 292; Add 5 292; Add 2 291; Mul 301 287; Neg 308; Neg 308; Mul 92 303; Mul 74 2; Add 1 0;
  Mul 57 3; Add 1 0; Mul 40 7; Add 1 0; Mul 94 310; Mul 76 9; Add 1 0; Mul 59 10; Add 1 0;
  Mul 42 14; Add 1 0; Mul 97 317; Mul 79 16; Add 1 0; Mul 62 17; Add 1 0; Mul 45 21; Add 1 0;
  Mul 101 324; Mul 83 23; Add 1 0; Mul 66 24; Add 1 0; Mul 49 28; Add 1 0; Mul 120 322;
  Mul 102 330; Add 1 0; Mul 85 331; Add 1 0; Mul 68 332; Add 1 0; Mul 122 329; Mul 104 337;
  Add 1 0; Mul 87 338; Add 1 0; Mul 70 339; Add 1 0; Mul 122 336; Mul 104 344; Add 1 0;
  Mul 87 345; Add 1 0; Mul 70 346; Add 1 0; Add 14 54; Add 8 54; Add 2 54; Div 355 45; Neg 39;
  Mul 0 1; Neg 34; Mul 0 3; Mul 365 79; Mul 5 5; Mul 1 0; Mul 10 7; Mul 0 47; Mul 1 34; Sub 12 1;
  Sub 12 1; Div 368 367; Mul 377 0; Mul 366 0; Neg 0; Mul 0 379; Sub 0 371; Mul 2 380; Sub 0 372;
  Mul 383 6; Mul 383 7; Sub 378 379; Mul 0 10; Mul 22 22; Mul 21 21; Add 1 0; Sub 0 20; Add 384 0;
  Div 385 0; Mul 394 0; Mul 19 0; Neg 0; Mul 0 31; Sub 0 23; Add 382 382; Mul 375 379; Mul 182 1;
  Mul 164 379; Add 1 0; Mul 147 381; Add 1 0; Mul 130 5; Add 1 0; Mul 184 8; Mul 166 386; Add 1 0;
  Mul 149 388; Add 1 0; Mul 132 12; Add 1 0; Mul 184 15; Mul 166 393; Add 1 0; Mul 149 395;
  Add 1 0; Mul 132 19; Add 1 0; Add 14 116; Add 8 116; Add 2 116; Mul 2 404; Neg 2; Add 1 2;
  Mul 190 401; Add 27 0; Add 0 25; Add 0 24; Mul 189 405; Add 24 0; Add 0 22; Add 0 21;
  Mul 186 409; Add 21 0; Add 0 19; Add 0 18; Add 8 134; Add 5 134; Add 2 134; Mul 2 422; Neg 2;
  Add 1 2; Sub 1 19; Sub 1 19; Mul 191 421; Add 45 0; Add 0 43; Mul 189 424; Add 41 0; Add 0 39;
  Mul 185 427; Add 37 0; Add 0 35; Add 6 151; Add 4 151; Add 2 151; Mul 2 439; Neg 2; Add 1 2;
  Sub 1 36; Sub 1 36; Add 457 448; Sub 449 458; Mul 0 446; Mul 249 2; Add 0 66; Add 0 65;
  Mul 195 3; Add 1 0; Mul 249 7; Add 0 64; Add 0 63; Mul 195 8; Add 1 0; Mul 247 12; Add 0 62;
  Add 0 61; Mul 193 13; Add 1 0; Add 10 177; Add 6 177; Add 2 177; Mul 2 465; Neg 2; Add 1 2;
  Sub 1 62; Sub 1 62; Add 474 483; Mul 448 471; Mul 274 1; Add 0 91; Add 0 90; Mul 220 3; Add 1 0;
  Mul 274 6; Add 0 89; Add 0 88; Mul 220 8; Add 1 0; Mul 272 11; Add 0 87; Add 0 86; Mul 218 13;
  Add 1 0; Add 10 202; Add 6 202; Add 2 202; Mul 2 490; Neg 2; Add 1 2; Sub 1 87; Sub 1 87;
  Mul 69 131; Mul 53 131; Add 1 0; Mul 29 131; Add 1 0; Mul 6 513; Add 1 0; Mul 75 138;
  Mul 59 138; Add 1 0; Mul 35 138; Add 1 0; Mul 12 520; Add 1 0; Div 522 0; Mul 8 0; Mul 85 150;
  Mul 69 149; Add 1 0; Mul 45 155; Add 1 0; Mul 22 520; Add 1 0; Mul 91 157; Mul 75 156; Add 1 0;
  Mul 51 162; Add 1 0; Mul 28 527; Add 1 0; Add 7 119; Add 1 119; Mul 0 16; Sub 2 0; Sub 0 151;
  ShowZero 0; (* vertex of the cone *)
  Mul 543 340; Add 250 0; Add 0 258; Add 0 539; Mul 327 538; Mul 309 546; Add 1 0; Mul 292 547;
  Add 1 0; Mul 275 548; Add 1 0; Add 0 7; Mul 191 231; Sub 1 0; Mul 168 197; Sub 0 1; Mul 339 167;
  Mul 321 545; Add 1 0; Mul 304 547; Add 1 0; Mul 287 171; Add 1 0; Add 0 19; Neg 0; Mul 329 549;
  Add 9 0; Add 0 7; Add 0 6; Add 0 25; Neg 0; Sub 0 6; Mul 317 556; Add 14 0; Add 0 12; Add 0 31;
  Neg 0; Sub 0 12; Mul 361 123; Add 0 21; Add 0 20; Mul 307 124; Add 1 0; Add 0 39; Neg 0;
  Sub 0 20; Mul 369 105; Add 0 29; Add 0 28; Mul 315 107; Add 1 0; Add 0 47; Neg 0; Sub 0 28;
  Mul 22 220; Mul 17 220; Add 1 0; Mul 11 220; Add 1 0; Mul 5 602; Add 1 0; Mul 0 81; Mul 30 231;
  Mul 25 230; Add 1 0; Mul 19 236; Add 1 0; Mul 13 601; Add 1 0; Add 0 44; Mul 73 8; Sub 1 0;
  Sub 0 56;
  ShowZero 0; (* vertex of the cone *)
  Sub 198 199; Sub 181 182; Sub 0 1; Sub 166 167; Sub 0 3; Sub 142 143; Sub 0 5; Sub 119 120;
  Sub 0 7; Mul 6 248; Mul 5 248; Add 1 0; Mul 5 248; Add 1 0; Mul 5 630; Add 1 0; Mul 0 109;
  Mul 14 259; Mul 13 258; Add 1 0; Mul 13 264; Add 1 0; Mul 13 629; Add 1 0; Add 0 23; Mul 101 8;
  Sub 1 0; Sub 0 254;
  ShowZero 0; (* vertex of the cone *)
  Mul 286 257; Sub 121 0;
  ShowZero 0; (* axis of the cone *)
  Mul 286 259; Sub 42 0;
  ShowZero 0; (* axis of the cone *)
  Sub 648 264; Mul 0 263; Sub 17 0;
  ShowZero 0 (* axis of the cone *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
