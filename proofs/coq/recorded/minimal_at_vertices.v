(** minimal-at-vertices (ours)

    The Christoffel dual of a Koebe mesh is i-minimal at its vertices as well, with the Koebe mesh
    over its own circles as v-parallel Gauss image; there -K is the product of the radii of the
    face circles of the first.

        D(v, s) = 0,  K(v) = -ρ_0 ρ_1 ρ_2 ρ_3

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** four quads around a vertex; size 1.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/koebe.rs, src/pair/area.rs, src/pair/forms.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 1; Mul 0 0; Add 4 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 0 0; Add 7 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 0 0; Add 10 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Unknown 5;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Unknown 6;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Unknown 7;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Unknown 8;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Div 16 14; Sub 17 16; Mul 0 1; Constant 2; Mul 21 0; Mul 0 4; Div 22 17; Sub 23 19; Mul 0 1;
  Mul 22 5; Mul 0 3; Mul 8 2; Mul 6 1; Add 1 0; Add 30 0;
  Nonzero 0; (* spokes that follow each other are not opposite *)
  Mul 19 18; Mul 19 18; Add 1 0; Mul 20 22; Add 1 0; Mul 24 24; Mul 18 10; Mul 16 13; Sub 1 0;
  Mul 0 0; Mul 4 0; Mul 11 11; Mul 7 0; Sub 2 0;
  Nonzero 0; (* the fourth corner is not at infinity *)
  Mul 32 32; Mul 0 3; Add 0 5;
  Nonzero 0; (* the circle of a face and that of a corner differ *)
  Div 48 40; Sub 49 42; Mul 0 1; Mul 45 31; Mul 0 3; Mul 28 2; Mul 27 1; Add 1 0; Add 56 0;
  Nonzero 0; (* spokes that follow each other are not opposite *)
  Mul 45 43; Mul 44 43; Add 1 0; Mul 45 48; Add 1 0; Mul 37 9; Mul 36 12; Sub 1 0; Mul 0 0;
  Mul 29 0; Mul 10 10; Mul 6 0; Sub 2 0;
  Nonzero 0; (* the fourth corner is not at infinity *)
  Mul 56 56; Mul 0 3; Add 0 5;
  Nonzero 0; (* the circle of a face and that of a corner differ *)
  Div 73 62; Sub 74 64; Mul 0 1; Mul 67 56; Mul 0 3; Mul 27 2; Mul 26 1; Add 1 0; Add 81 0;
  Nonzero 0; (* spokes that follow each other are not opposite *)
  Mul 70 67; Mul 68 67; Add 1 0; Mul 69 73; Add 1 0; Mul 36 9; Mul 35 12; Sub 1 0; Mul 0 0;
  Mul 54 0; Mul 10 10; Mul 6 0; Sub 2 0;
  Nonzero 0; (* the fourth corner is not at infinity *)
  Mul 80 80; Mul 0 3; Add 0 5;
  Nonzero 0; (* the circle of a face and that of a corner differ *)
  Mul 22 79; Mul 21 77; Add 1 0; Add 101 0;
  Nonzero 0; (* spokes that follow each other are not opposite *)
  Mul 90 86; Mul 87 90; Add 1 0; Mul 92 93; Add 1 0; Mul 31 85; Mul 30 89; Sub 1 0; Mul 0 0;
  Mul 74 0; Mul 10 10; Mul 6 0; Sub 2 0;
  Nonzero 0; (* the fourth corner is not at infinity *)
  Mul 99 99; Mul 0 3; Add 0 5;
  Nonzero 0; (* the circle of a face and that of a corner differ *)
  Add 106 105; Add 0 105; Mul 88 106; Mul 0 78; Mul 80 2; Sub 1 0; Div 0 79;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Add 113 111; Add 0 111; Mul 69 112; Mul 0 60; Mul 62 2; Sub 1 0; Div 0 61;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Add 120 117; Add 0 117; Mul 51 118; Mul 0 42; Mul 44 2; Sub 1 0; Div 0 43;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Add 127 123; Add 0 127; Mul 38 128; Mul 0 29; Mul 31 2; Sub 1 0; Div 0 30;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 0; Mul 128 28; Mul 126 29; Add 2 1; Add 3 1; Mul 126 25; Mul 125 26; Add 6 1; Add 7 1;
  Sub 8 1; Sub 9 1; Sub 7 3; Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0; Add 15 0;
  Nonzero 0; (* no face has three corners on a line *)
  Mul 112 30; Mul 111 31; Add 18 1; Add 19 1; Sub 20 1; Sub 21 1; Sub 15 3; Sub 15 3; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 27 0;
  Nonzero 0; (* no face has three corners on a line *)
  Mul 99 35; Mul 98 36; Add 30 1; Add 31 1; Sub 32 1; Sub 33 1; Sub 15 3; Sub 15 3; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 39 0;
  Nonzero 0; (* no face has three corners on a line *)
  Sub 40 37; Sub 41 37; Sub 11 39; Sub 11 39; Mul 3 0; Mul 3 2; Sub 1 0; Add 47 0;
  Nonzero 0; (* no face has three corners on a line *)
  Add 176 170; Div 184 165; Mul 1 0; Neg 79; Mul 180 0; Add 2 0; Mul 181 188; Mul 0 159;
  Div 0 155; Mul 3 0; Add 186 0; Add 193 81; Mul 1 0; Add 58 0; Div 209 197; Div 210 197;
  Div 211 197; Div 212 87; Mul 1 3; Mul 58 0; Add 68 0; Sub 66 69; Mul 7 6; Neg 0; Mul 2 0;
  Add 4 0; Sub 12 71; Mul 11 9; Mul 1 0; Add 3 0; Sub 71 16; Mul 13 14; Neg 0; Mul 2 0; Add 4 0;
  Sub 0 83;
  ShowZero 0; (* as a test finds *)
  Add 209 204; Mul 0 35; Mul 211 34; Add 1 0; Mul 0 31; Add 214 0; Mul 0 30; Add 87 0; Mul 82 25;
  Add 93 0; Sub 90 94; Mul 0 23; Add 2 0; Sub 5 93; Mul 0 22; Add 2 0; Sub 92 8; Mul 0 20;
  Add 2 0; Sub 0 103;
  ShowZero 0; (* as a test finds *)
  Mul 104 104; Add 0 0; Sub 0 216; Div 254 234; Mul 1 0; Mul 106 106; Mul 106 106; Add 1 0;
  Sub 0 213; Mul 0 5; Mul 107 107; Mul 107 107; Add 1 0; Sub 0 193; Mul 0 10; Mul 57 57;
  Mul 28 28; Add 1 0; Mul 144 144; Sub 1 0; Mul 0 16; Sub 16 6; Mul 0 59; Add 127 0; Sub 14 19;
  Mul 0 57; Add 2 0; Sub 6 17; Mul 0 56; Add 2 0; Sub 15 9; Mul 0 54; Add 2 0; Sub 0 137;
  ShowZero 0; (* as a test finds *)
  Add 260 234; Div 274 229; Mul 1 0; Neg 162; Mul 264 0; Add 2 0; Mul 271 277; Mul 0 224;
  Div 0 220; Mul 3 0; Add 270 0; Add 282 164; Mul 1 0; Add 144 0; Div 299 284; Div 300 168;
  Mul 1 91; Neg 0; Mul 135 0; Add 157 0; Sub 151 158; Mul 96 94; Mul 1 0; Add 3 0; Sub 10 155;
  Mul 98 9; Neg 0; Mul 2 0; Add 4 0; Sub 148 15; Mul 14 15; Mul 1 0; Add 3 0; Sub 0 171;
  ShowZero 0; (* as a test finds *)
  Add 292 266; Mul 0 33; Mul 294 32; Add 1 0; Mul 0 29; Add 297 0; Mul 0 28; Add 171 0;
  Mul 158 24; Add 181 0; Sub 174 182; Mul 0 23; Add 2 0; Sub 5 177; Mul 0 21; Add 2 0; Sub 168 8;
  Mul 0 20; Add 2 0; Sub 0 191;
  ShowZero 0; (* as a test finds *)
  Mul 173 173; Mul 173 173; Add 1 0; Sub 0 246; Mul 0 88; Mul 45 45; Mul 18 18; Add 1 0;
  Mul 215 215; Sub 1 0; Mul 0 94; Sub 94 6; Mul 0 48; Add 205 0; Sub 87 97; Mul 0 47; Add 2 0;
  Sub 6 90; Mul 0 45; Add 2 0; Sub 15 9; Mul 0 44; Add 2 0; Sub 0 215;
  ShowZero 0; (* as a test finds *)
  Add 312 287; Div 352 282; Mul 1 0; Neg 233; Mul 316 0; Add 2 0; Mul 349 354; Mul 0 277;
  Div 0 273; Mul 3 0; Add 322 0; Add 359 235; Mul 1 0; Add 210 0; Div 377 361; Div 378 239;
  Mul 1 169; Mul 200 0; Add 234 0; Sub 216 235; Mul 173 83; Neg 0; Mul 2 0; Add 4 0; Sub 10 221;
  Mul 88 9; Mul 1 0; Add 3 0; Sub 213 14; Mul 13 14; Neg 0; Mul 2 0; Add 4 0; Sub 0 249;
  ShowZero 0; (* as a test finds *)
  Add 344 319; Mul 0 33; Mul 346 32; Add 1 0; Mul 0 29; Add 349 0; Mul 0 28; Add 237 0;
  Mul 224 25; Add 259 0; Sub 240 260; Mul 0 23; Add 2 0; Sub 5 243; Mul 0 22; Add 2 0; Sub 234 8;
  Mul 0 20; Add 2 0; Sub 0 269;
  ShowZero 0; (* as a test finds *)
  Mul 239 239; Mul 239 239; Add 1 0; Sub 0 304; Mul 0 166; Mul 45 45; Mul 18 18; Add 1 0;
  Mul 286 286; Sub 1 0; Mul 0 172; Sub 172 6; Mul 0 49; Add 283 0; Sub 87 175; Mul 0 47; Add 2 0;
  Sub 6 90; Mul 0 46; Add 2 0; Sub 15 9; Mul 0 44; Add 2 0; Sub 0 293;
  ShowZero 0; (* as a test finds *)
  Add 365 422; Div 430 340; Mul 1 0; Neg 304; Mul 369 0; Add 2 0; Mul 427 431; Mul 0 335;
  Div 0 331; Mul 3 0; Add 375 0; Add 436 306; Mul 1 0; Add 276 0; Div 455 309; Mul 245 246; Neg 0;
  Mul 270 0; Add 312 0; Sub 282 313; Mul 251 83; Mul 1 0; Add 3 0; Sub 9 286; Mul 87 9; Neg 0;
  Mul 2 0; Add 4 0; Sub 319 14; Mul 14 259; Mul 1 0; Add 3 0; Sub 0 326;
  ShowZero 0; (* as a test finds *)
  Add 396 452; Mul 0 32; Mul 398 31; Add 1 0; Mul 0 28; Add 401 0; Mul 0 27; Add 302 0;
  Mul 293 24; Add 336 0; Sub 305 337; Mul 0 23; Add 2 0; Sub 5 308; Mul 0 21; Add 2 0; Sub 339 8;
  Mul 0 20; Add 2 0; Sub 0 346;
  ShowZero 0; (* as a test finds *)
  Mul 39 39; Mul 13 13; Add 1 0; Mul 351 351; Sub 1 0; Mul 0 244; Sub 244 239; Mul 0 43;
  Add 355 0; Sub 81 247; Mul 0 42; Add 2 0; Sub 6 84; Mul 0 40; Add 2 0; Sub 248 9; Mul 0 39;
  Add 2 0; Sub 0 365;
  ShowZero 0; (* as a test finds *)
  Sub 366 298; Add 0 299; Sub 0 368;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 369 276; Add 0 277; Sub 0 371;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 372 245; Add 0 246; Sub 0 374;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 375 302; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 377 281; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 379 249; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 14 299; Add 6 305; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 14 282; Add 7 286; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 14 251; Add 8 255; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 308; Sub 0 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 290; Sub 0 23;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 258; Sub 0 22;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 396 239; Add 0 240; Sub 0 398;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 399 218; Add 0 219; Sub 0 401;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 402 197; Add 0 198; Sub 0 404;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 38 239; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 37 220; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 36 198; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 241; Sub 0 15;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 223; Sub 0 14;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 201; Sub 0 13;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 417 183; Add 0 184; Sub 0 419;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 420 161; Add 0 162; Sub 0 422;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 423 140; Add 0 141; Sub 0 425;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 29 183; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 28 163; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 27 141; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 184; Sub 0 15;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 166; Sub 0 14;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 144; Sub 0 13;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 62 113; Add 21 118; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 63 96; Add 21 100; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 64 80; Add 21 84; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 122; Sub 0 72;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 104; Sub 0 72;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 87; Sub 0 72;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 453 86; Sub 454 84; Sub 79 88; Sub 78 86; Mul 448 0; Mul 448 2; Sub 1 0; Add 460 0;
  Mul 7 449; Mul 7 451; Sub 1 0; Add 3 0; Sub 403 458; Sub 374 458; Sub 85 100; Sub 83 98;
  Mul 458 0; Mul 458 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 477 80; Sub 478 78; Sub 112 82; Sub 110 80; Mul 460 0; Mul 460 2; Sub 1 0; Add 484 0;
  Mul 7 461; Mul 7 463; Sub 1 0; Add 3 0; Sub 337 470; Sub 310 470; Sub 85 94; Sub 84 92;
  Mul 470 0; Mul 470 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 501 83; Sub 502 81; Sub 106 85; Sub 104 83; Mul 472 0; Mul 472 2; Sub 1 0; Add 508 0;
  Mul 7 473; Mul 7 475; Sub 1 0; Add 3 0; Sub 283 482; Sub 256 482; Sub 88 97; Sub 87 95;
  Mul 482 0; Mul 482 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 525 149; Sub 526 148; Sub 109 151; Sub 107 150; Mul 488 0; Mul 488 2; Sub 1 0; Add 532 0;
  Mul 7 489; Mul 7 491; Sub 1 0; Add 3 0; Sub 229 534; Sub 203 534; Sub 100 163; Sub 98 162;
  Mul 498 0; Mul 498 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 549 549;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowZero 173; (* as src/pair/v_parallel.rs finds *)
  ShowZero 171; (* as src/pair/v_parallel.rs finds *)
  Sub 183 183;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 181 181;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 155 155;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 153 153;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 136 136;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 134 134;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 174 174;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 172 172;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowZero 151; (* as src/pair/v_parallel.rs finds *)
  ShowZero 149; (* as src/pair/v_parallel.rs finds *)
  ShowZero 130; (* as src/pair/v_parallel.rs finds *)
  ShowZero 128; (* as src/pair/v_parallel.rs finds *)
  Sub 119 119;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 117 117;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 560 187; Sub 181 188; Mul 108 105; Mul 108 107; Sub 1 0; Div 712 0; Mul 5 109; Mul 112 5;
  Sub 1 0; Mul 0 3; Mul 116 8; Mul 10 115; Sub 1 0; Mul 0 7; Mul 4 207; Mul 1 205; Add 1 0;
  Sub 204 0; Add 1 0; Sub 206 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 580; Mul 7 581; Add 1 0; Add 0 5; Sub 584 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 209; Mul 12 208; Add 1 0; Add 0 10; Sub 209 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 208; Mul 17 206; Add 1 0; Add 0 15; Sub 206 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 595 192; Sub 223 193; Mul 119 116; Mul 119 118; Sub 1 0; Div 747 0; Mul 5 120; Mul 123 5;
  Sub 1 0; Mul 0 3; Mul 127 8; Mul 10 126; Sub 1 0; Mul 0 7; Mul 4 212; Mul 1 210; Add 1 0;
  Sub 209 0; Add 1 0; Sub 211 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 615; Mul 7 616; Add 1 0; Add 0 5; Sub 619 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 253; Mul 12 251; Add 1 0; Add 0 10; Sub 251 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 219; Mul 17 218; Add 1 0; Add 0 15; Sub 219 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 630 206; Sub 228 207; Mul 130 127; Mul 130 129; Sub 1 0; Div 782 0; Mul 5 131; Mul 134 5;
  Sub 1 0; Mul 0 3; Mul 138 8; Mul 10 137; Sub 1 0; Mul 0 7; Mul 4 226; Mul 1 224; Add 1 0;
  Sub 223 0; Add 1 0; Sub 225 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 650; Mul 7 651; Add 1 0; Add 0 5; Sub 654 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 258; Mul 12 256; Add 1 0; Add 0 10; Sub 256 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 233; Mul 17 232; Add 1 0; Add 0 15; Sub 233 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 665 285; Sub 242 286; Mul 141 138; Mul 141 140; Sub 1 0; Div 817 0; Mul 5 142; Mul 145 5;
  Sub 1 0; Mul 0 3; Mul 149 8; Mul 10 148; Sub 1 0; Mul 0 7; Mul 4 303; Mul 1 302; Add 1 0;
  Sub 302 0; Add 1 0; Sub 304 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 685; Mul 7 686; Add 1 0; Add 0 5; Sub 689 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 272; Mul 12 270; Add 1 0; Add 0 10; Sub 270 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 256; Mul 17 254; Add 1 0; Add 0 15; Sub 254 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 637 637; Sub 595 0; Mul 0 594; Mul 327 327; Mul 326 326; Add 1 0; Mul 642 642; Sub 1 0;
  Mul 0 600; Mul 342 342; Mul 340 340; Add 1 0; Mul 647 647; Sub 1 0; Mul 0 606; Sub 12 0;
  Sub 7 1; Mul 1 260; Mul 263 1; Sub 1 0; Mul 0 154; Mul 267 4; Mul 6 266; Sub 1 0; Mul 0 158;
  Mul 4 358; Mul 1 356; Add 1 0; Sub 13 0; Add 1 0; Sub 15 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 731; Mul 7 732; Add 1 0; Add 0 5; Sub 32 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 360; Mul 12 359; Add 1 0; Add 0 10; Sub 31 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 359 359; Mul 357 357; Add 1 0; Mul 678 678; Sub 1 0; Mul 0 638; Mul 26 365; Mul 23 363;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 355 355; Mul 353 353; Add 1 0; Mul 602 602; Sub 1 0; Mul 0 649; Sub 55 0; Sub 44 1;
  Mul 1 279; Mul 282 1; Sub 1 0; Mul 0 162; Mul 286 4; Mul 6 285; Sub 1 0; Mul 0 166; Mul 4 371;
  Mul 1 369; Add 1 0; Sub 13 0; Add 1 0; Sub 15 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 774; Mul 7 775; Add 1 0; Add 0 5; Sub 75 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 412; Mul 12 410; Add 1 0; Add 0 10; Sub 68 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 378 378; Mul 377 377; Add 1 0; Mul 633 633; Sub 1 0; Mul 0 681; Mul 26 384; Mul 23 383;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 377 377; Mul 375 375; Add 1 0; Mul 567 567; Sub 1 0; Mul 0 692; Sub 98 0; Sub 44 1;
  Mul 1 298; Mul 301 1; Sub 1 0; Mul 0 170; Mul 305 4; Mul 6 304; Sub 1 0; Mul 0 174; Mul 4 393;
  Mul 1 391; Add 1 0; Sub 13 0; Add 1 0; Sub 15 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 817; Mul 7 818; Add 1 0; Add 0 5; Sub 118 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 425; Mul 12 423; Add 1 0; Add 0 10; Sub 68 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 400 400; Mul 399 399; Add 1 0; Mul 598 598; Sub 1 0; Mul 0 724; Mul 26 406; Mul 23 405;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 135 129; Sub 38 130; Mul 1 311; Mul 314 1; Sub 1 0; Mul 0 172; Mul 318 4; Mul 6 317;
  Sub 1 0; Mul 0 176; Mul 4 472; Mul 1 471; Add 1 0; Sub 142 0; Add 1 0; Sub 144 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 854; Mul 7 855; Add 1 0; Add 0 5; Sub 155 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 441; Mul 12 439; Add 1 0; Add 0 10; Sub 62 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 425 425; Mul 423 423; Add 1 0; Mul 558 558; Sub 1 0; Mul 0 761; Mul 26 431; Mul 23 429;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 761 756; Div 1023 861; Mul 751 865; Mul 868 2; Sub 1 0; Mul 0 3; Mul 872 5; Mul 756 871;
  Sub 1 0; Mul 0 7; Mul 4 878; Mul 1 878; Add 1 0; Sub 769 0; Add 1 0; Sub 771 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 891; Mul 7 892; Add 1 0; Add 0 5; Sub 786 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 893; Mul 12 893; Add 1 0; Add 0 10; Sub 786 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 839; Mul 17 810; Add 1 0; Add 0 15; Sub 780 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 787 709; Div 1054 880; Mul 704 884; Mul 887 2; Sub 1 0; Mul 0 3; Mul 891 5; Mul 709 890;
  Sub 1 0; Mul 0 7; Mul 4 897; Mul 1 897; Add 1 0; Sub 722 0; Add 1 0; Sub 724 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 922; Mul 7 923; Add 1 0; Add 0 5; Sub 817 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 920; Mul 12 920; Add 1 0; Add 0 10; Sub 812 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 780; Mul 17 753; Add 1 0; Add 0 15; Sub 733 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 740 662; Div 1085 899; Mul 657 903; Mul 906 2; Sub 1 0; Mul 0 3; Mul 910 5; Mul 662 909;
  Sub 1 0; Mul 0 7; Mul 4 916; Mul 1 916; Add 1 0; Sub 675 0; Add 1 0; Sub 677 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 953; Mul 7 954; Add 1 0; Add 0 5; Sub 848 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 939; Mul 12 939; Add 1 0; Add 0 10; Sub 765 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 733; Mul 17 706; Add 1 0; Add 0 15; Sub 686 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 693 854; Div 1116 922; Mul 616 926; Mul 929 2; Sub 1 0; Mul 0 3; Mul 933 5; Mul 621 932;
  Sub 1 0; Mul 0 7; Mul 4 975; Mul 1 975; Add 1 0; Sub 867 0; Add 1 0; Sub 869 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 984; Mul 7 985; Add 1 0; Add 0 5; Sub 879 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 958; Mul 12 958; Add 1 0; Add 0 10; Sub 718 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 686; Mul 17 660; Add 1 0; Add 0 15; Sub 645 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 394 429; Sub 391 426; Sub 237 280; Sub 234 277; Sub 363 433; Sub 360 430; Sub 198 284;
  Sub 195 281; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 1014 0;
  Sub 340 445; Sub 337 442; Sub 173 296; Sub 170 293; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5;
  Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Constant 4; Div 1175 0; Mul 2 0;
  ShowZero 0; (* D(v, s) *)
  Add 965 967; Sub 310 664; Sub 307 662; Mul 579 0; Mul 579 2; Sub 1 0; Div 0 5; Add 1170 1172;
  Sub 157 1031; Sub 154 1031; Mul 1031 0; Mul 1031 2; Sub 1 0; Div 0 5; Mul 7 0; Mul 0 0;
  Sub 0 1193;
  ShowZero 0; (* radius of a face *)
  Add 894 984; Sub 284 651; Sub 281 649; Mul 572 0; Mul 572 2; Sub 1 0; Div 0 5; Add 1186 1189;
  Sub 143 1036; Sub 140 1036; Mul 1036 0; Mul 1036 2; Sub 1 0; Div 0 5; Mul 7 0; Mul 0 0;
  Sub 0 1210;
  ShowZero 0; (* radius of a face *)
  Add 833 1001; Sub 258 647; Sub 255 645; Mul 565 0; Mul 565 2; Sub 1 0; Div 0 5; Add 1202 1206;
  Sub 129 1041; Sub 126 1041; Mul 1041 0; Mul 1041 2; Sub 1 0; Div 0 5; Mul 7 0; Mul 0 0;
  Sub 0 1227;
  ShowZero 0; (* radius of a face *)
  Add 1017 1018; Sub 238 706; Sub 235 705; Mul 558 0; Mul 558 2; Sub 1 0; Div 0 5; Add 1222 1223;
  Sub 115 1086; Sub 112 1086; Mul 1050 0; Mul 1050 2; Sub 1 0; Div 0 5; Mul 7 0; Mul 0 0;
  Sub 0 1244;
  ShowZero 0 (* radius of a face *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** K, and the residual of checks, on the Enneper surface; size 1.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/koebe.rs, src/construct/minimal/enneper.rs, src/construct/packing.rs,
    src/net/i_isothermic.rs, src/net/i_minimal.rs, src/pair/area.rs, src/pair/forms.rs,
    src/pair/v_parallel.rs, src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 1; Div 0 3; Constant 0; Add 0 0; Sub 5 0; Sub 5 1; Mul 1 1;
  Mul 1 1; Add 1 0; Mul 7 7; Sub 1 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 8 9; Sub 13 0; Sub 13 1; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 7;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 17 15; Sub 19 0; Mul 0 0; Add 14 0; Sub 0 12;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 22 21; Sub 24 0; Mul 0 0; Add 11 0; Sub 0 17;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 30 25; Sub 29 0; Mul 0 0; Add 24 0; Sub 0 22;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 34 14; Mul 0 0; Add 0 27; Sub 0 26;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 38 13; Mul 0 0; Add 0 23; Sub 0 30;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 20; Sub 0 32;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 4 17; Sub 0 34;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 10 14; Sub 0 36;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 48 18; Mul 0 0; Add 0 41; Sub 0 40;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 2 30; Sub 0 42;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 4 22; Sub 0 44;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Constant 4; Div 55 0; Sub 54 58; Sub 55 58; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5; Div 62 0;
  Mul 0 62; Sub 64 66; Mul 0 0; Add 0 6; Sub 0 11; Div 68 0; Mul 0 68; Add 6 0;
  Nonzero 0; (* no edge has length 0 *)
  Sub 71 72; Mul 0 0; Add 14 0; Sub 0 18; Div 75 0; Mul 0 75; Add 11 4; Sub 0 22; Div 79 0;
  Mul 0 79; Add 4 0;
  Nonzero 0; (* no edge has length 0 *)
  Sub 85 84; Mul 0 0; Add 0 24; Sub 0 29; Div 86 0; Mul 0 86; Add 18 0;
  Nonzero 0; (* no edge has length 0 *)
  Add 5 16; Sub 0 34; Div 91 0; Mul 0 91; Add 12 0;
  Nonzero 0; (* no edge has length 0 *)
  Sub 83 96; Sub 84 96; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 43;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 77 101; Mul 0 0; Add 5 0; Sub 0 47;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 81 106; Mul 0 0; Add 0 8; Sub 0 51;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 2 6; Sub 0 53;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Mul 53 47; Add 113 0; Mul 55 36; Add 115 0; Mul 49 45; Add 117 0; Mul 51 36; Add 119 0;
  Div 118 54; Div 119 42; Div 120 50; Div 121 40; Sub 6 10; Mul 4 2; Mul 1 0; Add 123 0; Sub 8 10;
  Mul 6 5; Neg 0; Mul 2 0; Add 4 0; Sub 17 13; Mul 10 12; Mul 1 0; Add 3 0; Sub 23 21; Mul 16 17;
  Neg 0; Mul 2 0; Add 4 0; Sub 0 138;
  ShowZero 0; (* as a test finds *)
  Mul 83 78; Add 143 0; Mul 71 67; Add 145 0; Mul 87 76; Add 147 0; Mul 75 67; Add 149 0; Sub 2 6;
  Mul 0 26; Add 149 0; Sub 3 5; Mul 0 24; Add 2 0; Sub 10 6; Mul 0 23; Add 2 0; Sub 15 13;
  Mul 0 21; Add 2 0; Sub 0 159;
  ShowZero 0; (* as a test finds *)
  Mul 50 50; Mul 20 20; Add 1 0; Mul 101 101; Sub 1 0; Mul 0 166; Mul 54 54; Mul 24 24; Add 1 0;
  Mul 94 94; Sub 1 0; Mul 0 172; Mul 58 58; Mul 28 28; Add 1 0; Mul 107 107; Sub 1 0; Mul 0 178;
  Mul 62 62; Mul 32 32; Add 1 0; Mul 102 102; Sub 1 0; Mul 0 184; Sub 6 18; Mul 0 63; Add 186 0;
  Sub 3 9; Mul 0 61; Add 2 0; Sub 18 6; Mul 0 60; Add 2 0; Sub 27 21; Mul 0 58; Add 2 0;
  Sub 0 196;
  ShowZero 0; (* as a test finds *)
  Sub 202 200; Mul 0 0; Add 142 0; Sub 0 146; Div 203 0; Mul 147 0; Add 207 0; Mul 2 205;
  Add 141 6; Sub 0 152; Div 209 0; Mul 145 0; Add 213 0; Mul 2 211; Div 213 6; Div 214 1;
  Sub 97 101; Mul 96 94; Mul 1 0; Add 216 0; Sub 7 101; Mul 98 5; Neg 0; Mul 2 0; Add 4 0;
  Sub 18 12; Mul 10 11; Mul 1 0; Add 3 0; Sub 114 22; Mul 15 109; Neg 0; Mul 2 0; Add 4 0;
  Sub 0 231;
  ShowZero 0; (* as a test finds *)
  Mul 34 30; Add 236 0; Mul 36 26; Add 238 0; Sub 89 93; Mul 0 22; Add 238 0; Sub 3 92; Mul 0 20;
  Add 2 0; Sub 8 6; Mul 0 19; Add 2 0; Sub 102 11; Mul 0 17; Add 2 0; Sub 0 248;
  ShowZero 0; (* as a test finds *)
  Mul 45 45; Mul 16 16; Add 1 0; Mul 47 47; Sub 1 0; Mul 0 255; Mul 45 45; Mul 20 20; Add 1 0;
  Mul 47 47; Sub 1 0; Mul 0 261; Sub 77 89; Mul 0 47; Add 263 0; Sub 3 80; Mul 0 45; Add 2 0;
  Sub 12 6; Mul 0 44; Add 2 0; Sub 98 15; Mul 0 42; Add 2 0; Sub 0 273;
  ShowZero 0; (* as a test finds *)
  Mul 193 189; Add 279 0; Mul 195 186; Add 281 0; Div 280 192; Div 281 188; Sub 4 166; Mul 162 2;
  Mul 1 0; Add 283 0; Sub 6 8; Mul 6 5; Neg 0; Mul 2 0; Add 4 0; Sub 173 11; Mul 10 170; Mul 1 0;
  Add 3 0; Sub 179 177; Mul 174 175; Neg 0; Mul 2 0; Add 4 0; Sub 0 298;
  ShowZero 0; (* as a test finds *)
  Mul 243 214; Add 303 0; Mul 231 211; Add 305 0; Sub 2 158; Mul 0 22; Add 305 0; Sub 3 5;
  Mul 0 20; Add 2 0; Sub 162 6; Mul 0 19; Add 2 0; Sub 167 165; Mul 0 17; Add 2 0; Sub 0 315;
  ShowZero 0; (* as a test finds *)
  Mul 40 40; Mul 16 16; Add 1 0; Mul 233 233; Sub 1 0; Mul 0 322; Mul 44 44; Mul 20 20; Add 1 0;
  Mul 234 234; Sub 1 0; Mul 0 328; Sub 6 150; Mul 0 47; Add 330 0; Sub 3 9; Mul 0 45; Add 2 0;
  Sub 150 6; Mul 0 44; Add 2 0; Sub 159 153; Mul 0 42; Add 2 0; Sub 0 340;
  ShowZero 0; (* as a test finds *)
  Add 259 142; Sub 0 288; Div 345 0; Mul 263 0; Add 349 0; Mul 2 347; Div 349 0; Sub 70 232;
  Mul 229 69; Mul 1 0; Add 351 0; Sub 6 74; Mul 73 5; Neg 0; Mul 2 0; Add 4 0; Sub 147 11;
  Mul 10 145; Mul 1 0; Add 3 0; Sub 245 151; Mul 149 242; Neg 0; Mul 2 0; Add 4 0; Sub 0 366;
  ShowZero 0; (* as a test finds *)
  Mul 169 23; Add 371 0; Sub 66 222; Mul 0 20; Add 371 0; Sub 3 69; Mul 0 18; Add 2 0; Sub 139 6;
  Mul 0 17; Add 2 0; Sub 231 142; Mul 0 15; Add 2 0; Sub 0 381;
  ShowZero 0; (* as a test finds *)
  Mul 36 36; Mul 14 14; Add 1 0; Mul 38 38; Sub 1 0; Mul 0 388; Sub 60 204; Mul 0 39; Add 390 0;
  Sub 3 63; Mul 0 37; Add 2 0; Sub 133 6; Mul 0 36; Add 2 0; Sub 213 136; Mul 0 34; Add 2 0;
  Sub 0 400;
  ShowZero 0; (* as a test finds *)
  Sub 277 277;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 252 252;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 216 216;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 275 275;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 252 252;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 216 216;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 407 270; Sub 275 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 409 251; Sub 254 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 411 216; Sub 219 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 276; Sub 0 414;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 257; Sub 0 416;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 222; Sub 0 418;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 290 198; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 268 180; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 233 157; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 17 195; Add 6 201; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 181; Add 7 185; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 19 159; Add 8 163; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 204; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 189; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 166; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 316 157; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 292 137; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 257 114; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 317 154; Add 6 159; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 296 138; Add 7 142; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 262 116; Add 8 120; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 163; Sub 0 327;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 146; Sub 0 305;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 123; Sub 0 270;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 41 101; Add 15 106; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 42 87; Add 15 91; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 43 71; Add 15 75; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 110; Sub 0 51;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 95; Sub 0 51;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 78; Sub 0 51;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 352 476; Sub 327 477; Sub 362 368; Sub 332 338; Sub 351 480; Sub 328 481; Mul 361 0;
  Mul 335 2; Sub 1 0; Add 485 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 378 380; Sub 348 350;
  Sub 84 492; Sub 83 493; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 373 94; Sub 350 93; Sub 294 392; Sub 269 362; Sub 86 98; Sub 85 97; Mul 294 0; Mul 272 2;
  Sub 1 0; Add 511 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 312 404; Sub 283 374; Sub 92 110;
  Sub 90 109; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 87 404; Sub 86 379; Sub 252 416; Sub 228 386; Sub 85 408; Sub 83 383; Mul 253 0; Mul 231 2;
  Sub 1 0; Add 537 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 413 418; Sub 390 393; Mul 13 0;
  Mul 13 2; Sub 1 0; Add 5 0; Mul 15 397; Mul 15 424; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 105 423; Sub 103 400; Sub 208 438; Sub 186 408; Sub 94 427; Sub 92 404; Mul 209 0;
  Mul 189 2; Sub 1 0; Add 561 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 146 437; Sub 145 414;
  Mul 13 0; Mul 13 2; Sub 1 0; Add 5 0; Mul 15 332; Mul 15 355; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 576 576;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 169 169;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 168 168;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 153 153;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 151 151;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowZero 179; (* as src/pair/v_parallel.rs finds *)
  ShowZero 178; (* as src/pair/v_parallel.rs finds *)
  ShowZero 176; (* as src/pair/v_parallel.rs finds *)
  ShowZero 175; (* as src/pair/v_parallel.rs finds *)
  ShowZero 160; (* as src/pair/v_parallel.rs finds *)
  ShowZero 158; (* as src/pair/v_parallel.rs finds *)
  ShowZero 139; (* as src/pair/v_parallel.rs finds *)
  ShowZero 137; (* as src/pair/v_parallel.rs finds *)
  Sub 134 134;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 132 132;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 121 121;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 119 119;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 398 585; Sub 396 586; Mul 110 105; Mul 110 107; Sub 1 0; Div 592 0; Mul 5 109; Mul 114 5;
  Sub 1 0; Mul 0 3; Mul 118 8; Mul 10 115; Sub 1 0; Mul 0 7; Mul 4 599; Mul 1 600; Add 1 0;
  Sub 602 0; Add 1 0; Sub 604 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 481; Mul 7 456; Add 1 0; Add 0 5; Sub 422 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 481; Mul 12 458; Add 1 0; Add 0 10; Sub 424 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 207; Mul 17 206; Add 1 0; Add 0 15; Sub 207 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 430 208; Sub 197 209; Mul 119 114; Mul 119 116; Sub 1 0; Div 627 0; Mul 5 118; Mul 123 5;
  Sub 1 0; Mul 0 3; Mul 127 8; Mul 10 124; Sub 1 0; Mul 0 7; Mul 4 226; Mul 1 225; Add 1 0;
  Sub 225 0; Add 1 0; Sub 227 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 511; Mul 7 488; Add 1 0; Add 0 5; Sub 454 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 225; Mul 12 224; Add 1 0; Add 0 10; Sub 225 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 224; Mul 17 222; Add 1 0; Add 0 15; Sub 222 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 210 468; Sub 203 469; Mul 128 123; Mul 128 125; Sub 1 0; Div 662 0; Mul 5 127; Mul 132 5;
  Sub 1 0; Mul 0 3; Mul 136 8; Mul 10 133; Sub 1 0; Mul 0 7; Mul 4 545; Mul 1 520; Add 1 0;
  Sub 485 0; Add 1 0; Sub 487 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 234; Mul 7 233; Add 1 0; Add 0 5; Sub 234 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 233; Mul 12 231; Add 1 0; Add 0 10; Sub 231 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 556; Mul 17 533; Add 1 0; Add 0 15; Sub 499 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 237 500; Sub 223 501; Mul 139 134; Mul 139 136; Sub 1 0; Div 697 0; Mul 5 138; Mul 143 5;
  Sub 1 0; Mul 0 3; Mul 147 8; Mul 10 144; Sub 1 0; Mul 0 7; Mul 4 575; Mul 1 552; Add 1 0;
  Sub 517 0; Add 1 0; Sub 519 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 263; Mul 7 261; Add 1 0; Add 0 5; Sub 261 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 253; Mul 12 251; Add 1 0; Add 0 10; Sub 251 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 300; Mul 17 299; Add 1 0; Add 0 15; Sub 300 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 725 725; Add 0 0; Mul 610 610; Sub 1 0; Mul 0 730; Mul 606 606; Mul 581 581; Add 1 0;
  Mul 614 614; Sub 1 0; Mul 0 736; Mul 607 607; Mul 584 584; Add 1 0; Mul 619 619; Sub 1 0;
  Mul 0 742; Sub 6 12; Sub 1 13; Mul 1 262; Mul 267 1; Sub 1 0; Mul 0 156; Mul 271 4; Mul 6 268;
  Sub 1 0; Mul 0 160; Mul 4 752; Mul 1 753; Add 1 0; Sub 25 0; Add 1 0; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 634; Mul 7 609; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 634; Mul 12 611; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 360 360; Mul 359 359; Add 1 0; Mul 653 653; Sub 1 0; Mul 0 774; Mul 26 366; Mul 23 365;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 359 359; Mul 358 358; Add 1 0; Mul 569 569; Sub 1 0; Mul 0 785; Sub 43 11; Sub 1 12;
  Mul 1 279; Mul 284 1; Sub 1 0; Mul 0 164; Mul 288 4; Mul 6 285; Sub 1 0; Mul 0 168; Mul 4 387;
  Mul 1 386; Add 1 0; Sub 24 0; Add 1 0; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 672; Mul 7 649; Add 1 0; Add 0 5; Sub 63 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 386; Mul 12 385; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 385 385; Mul 383 383; Add 1 0; Mul 602 602; Sub 1 0; Mul 0 817; Mul 26 391; Mul 23 389;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 381 381; Mul 380 380; Add 1 0; Mul 546 546; Sub 1 0; Mul 0 828; Mul 381 381; Mul 379 379;
  Add 1 0; Mul 551 551; Sub 1 0; Mul 0 834; Sub 6 98; Sub 1 99; Mul 1 302; Mul 307 1; Sub 1 0;
  Mul 0 178; Mul 311 4; Mul 6 308; Sub 1 0; Mul 0 182; Mul 4 720; Mul 1 695; Add 1 0; Sub 111 0;
  Add 1 0; Sub 113 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 409; Mul 7 408; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 408; Mul 12 406; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 731; Mul 17 708; Add 1 0; Add 0 15; Sub 122 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 403 403; Mul 401 401; Add 1 0; Mul 520 520; Sub 1 0; Mul 0 871; Sub 37 129; Sub 1 130;
  Mul 1 315; Mul 320 1; Sub 1 0; Mul 0 180; Mul 324 4; Mul 6 321; Sub 1 0; Mul 0 184; Mul 4 752;
  Mul 1 729; Add 1 0; Sub 142 0; Add 1 0; Sub 144 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 440; Mul 7 438; Add 1 0; Add 0 5; Sub 57 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 430; Mul 12 428; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 477; Mul 17 476; Add 1 0; Add 0 15; Sub 116 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 718 736; Mul 782 423; Mul 756 425; Sub 1 0; Div 908 0; Mul 722 427; Mul 760 5; Sub 1 0;
  Mul 0 3; Mul 790 8; Mul 727 433; Sub 1 0; Mul 0 7; Mul 4 805; Mul 1 775; Add 1 0; Sub 752 0;
  Add 1 0; Sub 754 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 807; Mul 7 777; Add 1 0; Add 0 5; Sub 747 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 810; Mul 12 780; Add 1 0; Add 0 10; Sub 746 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 819; Mul 17 789; Add 1 0; Add 0 15; Sub 763 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 675 764; Mul 723 431; Mul 701 433; Sub 1 0; Div 942 0; Mul 679 435; Mul 705 5; Sub 1 0;
  Mul 0 3; Mul 731 8; Mul 684 441; Sub 1 0; Mul 0 7; Mul 4 837; Mul 1 807; Add 1 0; Sub 780 0;
  Add 1 0; Sub 782 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 839; Mul 7 809; Add 1 0; Add 0 5; Sub 775 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 750; Mul 12 725; Add 1 0; Add 0 10; Sub 703 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 761; Mul 17 732; Add 1 0; Add 0 15; Sub 714 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 642 792; Mul 690 439; Mul 668 441; Sub 1 0; Div 976 0; Mul 646 443; Mul 672 5; Sub 1 0;
  Mul 0 3; Mul 698 8; Mul 651 449; Sub 1 0; Mul 0 7; Mul 4 869; Mul 1 839; Add 1 0; Sub 808 0;
  Add 1 0; Sub 810 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 713; Mul 7 689; Add 1 0; Add 0 5; Sub 671 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 716; Mul 12 692; Add 1 0; Add 0 10; Sub 670 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 883; Mul 17 853; Add 1 0; Add 0 15; Sub 819 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 616 820; Mul 656 449; Mul 636 451; Sub 1 0; Div 1010 0; Mul 620 453; Mul 640 5; Sub 1 0;
  Mul 0 3; Mul 664 8; Mul 625 459; Sub 1 0; Mul 0 7; Mul 4 901; Mul 1 871; Add 1 0; Sub 836 0;
  Add 1 0; Sub 838 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 745; Mul 7 721; Add 1 0; Add 0 5; Sub 699 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 682; Mul 12 660; Add 1 0; Add 0 10; Sub 644 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 823; Mul 17 798; Add 1 0; Add 0 15; Sub 776 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 373 443; Sub 370 440; Sub 200 292; Sub 197 289; Sub 342 447; Sub 339 444; Sub 167 296;
  Sub 164 293; Mul 7 2; Mul 7 4; Sub 1 0; Add 1049 0; Mul 9 4; Mul 9 6; Sub 1 0; Add 1053 0;
  Sub 424 459; Sub 421 456; Sub 265 308; Sub 262 305; Mul 15 2; Mul 15 4; Sub 1 0; Add 11 0;
  Mul 17 4; Mul 17 6; Sub 1 0; Add 11 0; Mul 4 1071; Mul 1 1072; Sub 157 958; Sub 154 928;
  Mul 949 0; Mul 923 2; Sub 1 0; Div 0 1004; Mul 1076 0; Sub 130 963; Sub 127 933; Mul 863 0;
  Mul 841 2; Sub 1 0; Div 0 1000; Mul 6 0; Sub 103 968; Sub 100 938; Mul 803 0; Mul 781 2;
  Sub 1 0; Div 0 1000; Mul 6 0; Sub 76 973; Sub 73 943; Mul 742 0; Mul 722 2; Sub 1 0; Div 0 1002;
  Mul 6 0; Mul 29 1042; Mul 29 1043; Mul 0 2; Add 2 0;
  ShowZero 0; (* K(v) *)
  Sub 692 971; Sub 691 948; Sub 690 912; Sub 979 974; Sub 954 951; Sub 918 915; Sub 682 916;
  Mul 6 2; Mul 6 4; Sub 1 0; Mul 6 556; Mul 6 558; Sub 1 0; Mul 560 545; Mul 560 547; Sub 1 0;
  Mul 549 14; Mul 549 16; Sub 1 0; Mul 18 18; Mul 18 18; Add 1 0; Sub 350 382; Sub 1 0; Mul 17 14;
  Mul 558 20; Mul 558 22; Sub 1 0; Mul 25 0; Sub 4 0; Mul 24 11; Add 1 0; Mul 8 0; Mul 0 20;
  Mul 0 18; Add 1135 0; Mul 32 32; Mul 32 32; Add 1 0; Sub 405 399; Sub 1 0; Mul 38 28;
  Mul 41 588; Mul 41 590; Sub 1 0; Mul 39 0; Sub 4 0; Mul 456 37; Add 1 0; Mul 8 0; Mul 0 34;
  Mul 0 32; Add 16 0; Mul 600 600; Mul 600 600; Add 1 0; Sub 324 416; Sub 1 0; Mul 52 42;
  Mul 55 591; Mul 55 593; Sub 1 0; Mul 471 0; Sub 4 0; Mul 57 51; Add 1 0; Mul 8 0; Mul 0 57;
  Mul 0 49; Add 16 0; Mul 603 603; Mul 603 603; Add 1 0; Sub 390 433; Sub 1 0; Mul 484 56;
  Mul 623 74; Mul 623 76; Sub 1 0; Mul 72 0; Sub 4 0; Mul 78 65; Add 1 0; Mul 8 0; Mul 0 74;
  Mul 0 72; Add 16 0;
  ShowZero 0 (* residual *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
