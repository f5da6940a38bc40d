(** i-minimal-dual (Sec. 2.1 and 4)

    The metric dual of an i-minimal mesh is i-minimal at its vertices, with the metric dual of the
    Gauss image as v-parallel Gauss image.

        area(F, S) = 0  =>  D(F*, S* ) = 0

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a face with k corners and the ring around it; size 4.
    Code: src/pair/area.rs, src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs,
    src/scalar/ring.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 5 1; Sub 5 1; Sub 5 7;
  Sub 5 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 6;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Unknown 7; Unknown 8; Sub 1 13; Sub 1 13; Mul 9 0; Mul 9 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 9;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Sub 17 7; Sub 17 7; Mul 7 0; Mul 7 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 10;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Mul 5 20; Mul 5 22; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 11;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Unknown 12;
  Nonzero 0; (* no edge of S has length 0 *)
  Unknown 13;
  Nonzero 0; (* no edge of S has length 0 *)
  Constant 0; Mul 26 2; Mul 26 3; Add 2 1; Add 3 1; Mul 22 5; Mul 22 6; Add 3 1; Add 3 1; Sub 8 1;
  Sub 9 1; Mul 1 37; Mul 1 39; Sub 1 0; Div 0 17; Mul 26 0; Mul 26 1; Add 9 1; Add 9 1; Sub 1 11;
  Sub 1 11; Mul 1 47; Mul 1 49; Sub 1 0;
  Nonzero 0; (* no edge of S has length 0 *)
  Sub 23 6; Sub 24 6; Mul 1 50; Mul 1 52; Sub 1 0;
  Nonzero 0; (* no edge of S has length 0 *)
  Mul 46 28; Mul 46 29; Add 27 1; Add 27 1; Sub 32 1; Sub 33 1; Mul 1 61; Mul 1 63; Sub 1 0;
  Div 0 41; Mul 50 0; Mul 50 1; Add 9 1; Add 9 1; Constant 1; Mul 61 0; Mul 61 1; Add 42 1;
  Add 42 1; Sub 47 1; Sub 48 1; Mul 1 76; Mul 1 78; Sub 1 0; Div 0 56; Mul 65 0; Mul 65 1;
  Add 9 1; Add 9 1; Sub 54 57; Sub 54 58; Sub 79 93; Sub 79 93; Sub 30 61; Sub 30 62; Mul 89 0;
  Mul 89 2; Sub 1 0; Add 66 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 101 105; Sub 101 105;
  Sub 32 73; Sub 32 74; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0; Sub 37 83; Sub 37 84; Mul 111 0; Mul 111 2; Sub 1 0; Add 88 0; Add 0 19; Sub 34 90;
  Sub 34 91; Mul 32 0; Mul 32 2; Sub 1 0; Add 5 0; Mul 12 23; Mul 12 25; Sub 1 0; Add 3 0;
  Sub 0 17; Mul 0 102; Add 19 0; Constant 4; Div 61 0; Mul 2 0;
  Zero 0; (* (M, S) is i-minimal: area(F, S) = 0 *)
  Sub 106 106; Mul 133 46; Mul 133 48; Sub 1 0; Div 67 0; Mul 4 50; Mul 137 5; Sub 1 0; Mul 0 3;
  Mul 141 8; Mul 9 56; Sub 1 0; Mul 0 7; Mul 4 153; Mul 1 153; Add 1 0; Sub 122 0; Add 1 0;
  Sub 124 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 157; Mul 7 157; Add 1 0; Add 0 5; Sub 129 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 150; Mul 12 150; Add 1 0; Add 0 10; Sub 134 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 165; Mul 17 165; Add 1 0; Add 0 15; Sub 139 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 140; Mul 22 141; Add 1 0; Sub 143 0; Mul 29 141; Mul 26 141; Add 1 0; Add 0 3; Sub 148 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 142; Mul 31 142; Add 1 0; Add 0 8; Sub 153 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 137; Mul 36 137; Add 1 0; Add 0 13; Sub 158 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 187 162; Mul 187 163; Mul 187 182; Mul 187 183; Neg 1; Neg 1; Add 5 1; Add 5 1; Add 201 1;
  Add 201 1; Mul 4 3; Mul 8 3; Add 1 0; Sub 206 204; Sub 206 204; Sub 6 206; Sub 6 206; Sub 4 176;
  Mul 4 1; Mul 4 3; Sub 1 0; Div 137 0; Mul 74 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 79 11;
  Sub 1 0; Mul 0 7; Mul 4 221; Mul 1 221; Add 1 0; Sub 192 0; Add 1 0; Sub 194 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 229; Mul 7 229; Add 1 0; Add 0 5; Sub 199 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 32; Mul 12 32; Add 1 0; Add 0 10; Sub 32 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 223 218; Mul 223 219; Neg 1; Neg 1; Add 47 1; Add 47 1; Add 243 1; Add 243 1; Mul 4 3;
  Mul 8 3; Add 1 0; Mul 31 4; Mul 28 4; Add 1 0; Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 36 218; Mul 33 218; Add 1 0; Sub 224 0; Mul 40 225; Mul 37 226; Add 1 0; Add 0 3; Sub 229 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 230 64; Add 231 64; Mul 47 1; Mul 44 1; Add 1 0; Add 0 10; Sub 64 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 234 27; Add 234 27; Mul 54 1; Mul 51 1; Add 1 0; Add 0 17; Sub 27 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 276 264; Sub 276 264; Sub 34 266; Sub 34 266; Sub 32 248; Mul 4 1; Mul 4 3; Sub 1 0;
  Div 209 0; Mul 146 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 151 11; Sub 1 0; Mul 0 7;
  Mul 4 281; Mul 1 281; Add 1 0; Sub 264 0; Add 1 0; Sub 266 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 299; Mul 7 299; Add 1 0; Add 0 5; Sub 271 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 60; Mul 12 60; Add 1 0; Add 0 10; Sub 60 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 289 284; Mul 289 285; Neg 1; Neg 1; Add 75 1; Add 75 1; Add 303 1; Add 303 1; Mul 4 3;
  Mul 8 3; Add 1 0; Mul 31 4; Mul 28 4; Add 1 0; Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 36 286; Mul 33 286; Add 1 0; Sub 296 0; Mul 40 294; Mul 37 294; Add 1 0; Add 0 3; Sub 301 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 45 64; Mul 42 64; Add 1 0; Add 0 8; Sub 90 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 300 25; Add 300 25; Mul 52 1; Mul 49 1; Add 1 0; Add 0 15; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 334 344; Sub 334 344; Sub 32 346; Sub 32 346; Sub 30 318; Mul 4 1; Mul 4 3; Sub 1 0;
  Div 279 0; Mul 216 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 221 11; Sub 1 0; Mul 0 7;
  Mul 4 361; Mul 1 361; Add 1 0; Sub 334 0; Add 1 0; Sub 336 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 357; Mul 7 357; Add 1 0; Add 0 5; Sub 341 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 58; Mul 12 58; Add 1 0; Add 0 10; Sub 58 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 187; Neg 187; Add 71 1; Add 71 1; Add 381 1; Add 381 1; Mul 4 3; Mul 194 3; Add 1 0;
  Mul 29 4; Mul 26 4; Add 1 0; Add 0 24; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 34 344; Mul 31 344; Add 1 0; Sub 364 0; Mul 38 358; Mul 35 358; Add 1 0; Add 0 3; Sub 369 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 43 62; Mul 40 62; Add 1 0; Add 0 8; Sub 86 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 358 25; Add 358 25; Mul 50 1; Mul 47 1; Add 1 0; Add 0 15; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 30 416; Sub 30 416; Sub 28 384; Mul 313 1; Mul 313 3; Sub 1 0; Div 345 0; Mul 282 5;
  Mul 317 5; Sub 1 0; Mul 0 3; Mul 321 8; Mul 287 11; Sub 1 0; Mul 0 7; Mul 4 431; Mul 1 431;
  Add 1 0; Sub 400 0; Add 1 0; Sub 402 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 433; Mul 7 433; Add 1 0; Add 0 5; Sub 407 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 56; Mul 12 56; Add 1 0; Add 0 10; Sub 56 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 245; Mul 17 245; Add 1 0; Add 0 15; Sub 245 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 418; Mul 22 419; Add 1 0; Sub 421 0; Mul 29 405; Mul 26 405; Add 1 0; Add 0 3; Sub 426 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 51; Mul 31 51; Add 1 0; Add 0 8; Sub 75 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 201; Mul 36 201; Add 1 0; Add 0 13; Sub 264 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 430 437; Sub 430 438; Mul 381 0; Mul 381 2; Sub 1 0; Div 399 0; Mul 336 4; Mul 385 337;
  Sub 1 0; Mul 0 3; Mul 389 340; Mul 341 10; Sub 1 0; Mul 0 7; Mul 4 451; Mul 1 452; Add 1 0;
  Sub 454 0; Add 1 0; Sub 456 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 454; Mul 7 454; Add 1 0; Add 0 5; Sub 461 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 455; Mul 12 455; Add 1 0; Add 0 10; Sub 466 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 450; Mul 17 450; Add 1 0; Add 0 15; Sub 471 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 472 469; Sub 473 469; Sub 243 471; Sub 243 471; Mul 3 0; Mul 3 2; Sub 1 0; Div 436 0;
  Mul 373 4; Mul 7 304; Sub 1 0; Mul 0 3; Mul 11 307; Mul 378 10; Sub 1 0; Mul 0 7; Mul 4 485;
  Mul 1 485; Add 1 0; Sub 491 0; Add 1 0; Sub 493 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 494; Mul 7 495; Add 1 0; Add 0 5; Sub 498 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 268; Mul 12 268; Add 1 0; Add 0 10; Sub 331 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 266; Mul 17 266; Add 1 0; Add 0 15; Sub 292 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 506 502; Sub 506 502; Sub 273 504; Sub 273 504; Mul 3 0; Mul 3 2; Sub 1 0; Div 473 0;
  Mul 410 4; Mul 7 269; Sub 1 0; Mul 0 3; Mul 11 272; Mul 415 10; Sub 1 0; Mul 0 7; Mul 4 518;
  Mul 1 518; Add 1 0; Sub 528 0; Add 1 0; Sub 530 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 528; Mul 7 528; Add 1 0; Add 0 5; Sub 535 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 298; Mul 12 298; Add 1 0; Add 0 10; Sub 324 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 233; Mul 17 233; Add 1 0; Add 0 15; Sub 257 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 539 529; Sub 539 529; Sub 240 531; Sub 240 531; Mul 3 0; Mul 3 2; Sub 1 0; Div 510 0;
  Mul 447 4; Mul 7 236; Sub 1 0; Mul 0 3; Mul 11 239; Mul 452 10; Sub 1 0; Mul 0 7; Mul 4 545;
  Mul 1 545; Add 1 0; Sub 565 0; Add 1 0; Sub 567 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 561; Mul 7 561; Add 1 0; Add 0 5; Sub 572 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 265; Mul 12 265; Add 1 0; Add 0 10; Sub 289 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 202; Mul 17 202; Add 1 0; Add 0 15; Sub 226 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 566 583; Sub 566 584; Sub 209 585; Sub 209 586; Mul 3 0; Mul 3 2; Sub 1 0; Div 547 0;
  Mul 484 4; Mul 7 207; Sub 1 0; Mul 0 3; Mul 11 210; Mul 489 10; Sub 1 0; Mul 0 7; Mul 4 599;
  Mul 1 600; Add 1 0; Sub 602 0; Add 1 0; Sub 604 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 588; Mul 7 588; Add 1 0; Add 0 5; Sub 609 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 234; Mul 12 234; Add 1 0; Add 0 10; Sub 258 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 384; Mul 17 384; Add 1 0; Add 0 15; Sub 447 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 173 505;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 170 502;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 138 437;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 135 434;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 103 367;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 100 364;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 68 299;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 65 296;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 33 235;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 30 232;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 507; Neg 438; Neg 367; Neg 298; Neg 233; Neg 180; Neg 144; Neg 108; Neg 72; Neg 36;
  Sub 247 525; Sub 244 522; Sub 7 11; Sub 458 528; Sub 455 525; Sub 13 14; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 606 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Sub 401 543; Sub 398 540; Sub 27 29; Mul 17 1; Mul 17 3; Sub 1 0; Div 621 0; Mul 19 5; Mul 21 5;
  Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 346 558; Sub 343 555; Sub 41 44;
  Mul 17 1; Mul 17 3; Sub 1 0; Div 636 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8;
  Mul 24 11; Sub 1 0; Mul 0 7; Mul 14 46; Mul 14 48; Sub 1 0; Div 648 0; Mul 16 50; Mul 18 50;
  Sub 1 0; Mul 0 3; Mul 22 53; Mul 21 56; Sub 1 0; Mul 0 7; Sub 105 253; Sub 102 250; Sub 62 66;
  Sub 219 256; Sub 216 253; Sub 68 69; Mul 5 1; Mul 5 3; Sub 1 0; Div 666 0; Mul 7 5; Mul 9 5;
  Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Sub 197 271; Sub 194 268; Sub 82 84;
  Mul 17 1; Mul 17 3; Sub 1 0; Div 681 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8;
  Mul 24 11; Sub 1 0; Mul 0 7; Sub 175 286; Sub 172 283; Sub 96 99; Mul 17 1; Mul 17 3; Sub 1 0;
  Div 696 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Mul 14 46; Mul 14 48; Sub 1 0; Div 708 0; Mul 16 50; Mul 18 50; Sub 1 0; Mul 0 3; Mul 22 53;
  Mul 21 56; Sub 1 0; Mul 0 7; Sub 91 106; Sub 88 103; Sub 33 48; Sub 30 45; Sub 80 110;
  Sub 77 107; Sub 22 52; Sub 19 49; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0;
  Add 775 0; Sub 80 122; Sub 77 119; Sub 22 64; Sub 19 61; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5;
  Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Mul 0 683;
  ShowZero 0 (* D(F*, S* ) *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k corners and the ring around it; size 5.
    Code: src/pair/area.rs, src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs,
    src/scalar/ring.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_5 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 5 1; Sub 5 1; Sub 5 7;
  Sub 5 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 6;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Unknown 7; Unknown 8; Sub 1 13; Sub 1 13; Mul 9 0; Mul 9 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 9;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Unknown 10; Unknown 11; Sub 1 9; Sub 1 9; Mul 9 0; Mul 9 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 12;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Sub 25 7; Sub 25 7; Mul 7 0; Mul 7 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 13;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Mul 5 28; Mul 5 30; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 14;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Unknown 15;
  Nonzero 0; (* no edge of S has length 0 *)
  Unknown 16;
  Nonzero 0; (* no edge of S has length 0 *)
  Unknown 17;
  Nonzero 0; (* no edge of S has length 0 *)
  Constant 0; Mul 35 3; Mul 35 4; Add 2 1; Add 3 1; Mul 31 6; Mul 31 7; Add 3 1; Add 3 1;
  Mul 27 9; Mul 27 10; Add 3 1; Add 3 1; Sub 12 1; Sub 13 1; Mul 1 50; Mul 1 52; Sub 1 0;
  Div 0 22; Mul 31 0; Mul 31 1; Add 9 1; Add 9 1; Sub 1 11; Sub 1 11; Mul 1 60; Mul 1 62; Sub 1 0;
  Nonzero 0; (* no edge of S has length 0 *)
  Sub 27 6; Sub 28 6; Mul 1 63; Mul 1 65; Sub 1 0;
  Nonzero 0; (* no edge of S has length 0 *)
  Mul 51 32; Mul 51 33; Add 27 1; Add 27 1; Sub 36 1; Sub 37 1; Mul 1 74; Mul 1 76; Sub 1 0;
  Div 0 46; Mul 55 0; Mul 55 1; Add 9 1; Add 9 1; Constant 1; Mul 66 0; Mul 66 1; Add 42 1;
  Add 42 1; Sub 51 1; Sub 52 1; Mul 1 89; Mul 1 91; Sub 1 0; Div 0 61; Mul 70 0; Mul 70 1;
  Add 9 1; Add 9 1; Sub 58 61; Sub 58 62; Sub 92 106; Sub 92 106; Sub 58 65; Sub 58 66; Mul 102 0;
  Mul 102 2; Sub 1 0; Add 70 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 96 118; Sub 96 118;
  Sub 42 77; Sub 42 78; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0; Sub 126 130; Sub 126 130; Sub 44 89; Sub 44 90; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0;
  Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0; Sub 49 99; Sub 49 100; Mul 37 0; Mul 37 2; Sub 1 0;
  Add 29 0; Add 0 19; Sub 46 106; Sub 46 107; Mul 32 0; Mul 32 2; Sub 1 0; Add 5 0; Mul 12 23;
  Mul 12 25; Sub 1 0; Add 3 0; Sub 0 17; Mul 0 118; Add 19 0; Constant 4; Div 73 0; Mul 2 0;
  Zero 0; (* (M, S) is i-minimal: area(F, S) = 0 *)
  Sub 122 122; Mul 158 58; Mul 158 60; Sub 1 0; Div 79 0; Mul 4 62; Mul 162 5; Sub 1 0; Mul 0 3;
  Mul 166 8; Mul 9 68; Sub 1 0; Mul 0 7; Mul 4 178; Mul 1 178; Add 1 0; Sub 138 0; Add 1 0;
  Sub 140 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 182; Mul 7 182; Add 1 0; Add 0 5; Sub 145 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 175; Mul 12 175; Add 1 0; Add 0 10; Sub 150 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 172; Mul 17 172; Add 1 0; Add 0 15; Sub 155 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 195; Mul 22 195; Add 1 0; Add 0 20; Sub 160 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 30 161; Mul 27 162; Add 1 0; Sub 164 0; Mul 34 162; Mul 31 162; Add 1 0; Add 0 3; Sub 169 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 163; Mul 36 163; Add 1 0; Add 0 8; Sub 174 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 44 164; Mul 41 164; Add 1 0; Add 0 13; Sub 179 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 49 159; Mul 46 159; Add 1 0; Add 0 18; Sub 184 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 222 189; Mul 222 190; Mul 222 217; Mul 222 218; Neg 1; Neg 1; Add 5 1; Add 5 1; Add 236 1;
  Add 236 1; Mul 4 3; Mul 8 3; Add 1 0; Sub 241 239; Sub 241 239; Sub 6 241; Sub 6 241; Sub 4 202;
  Mul 4 1; Mul 4 3; Sub 1 0; Div 159 0; Mul 84 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 89 11;
  Sub 1 0; Mul 0 7; Mul 4 256; Mul 1 256; Add 1 0; Sub 218 0; Add 1 0; Sub 220 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 264; Mul 7 264; Add 1 0; Add 0 5; Sub 225 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 32; Mul 12 32; Add 1 0; Add 0 10; Sub 32 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 258 253; Mul 258 254; Neg 1; Neg 1; Add 47 1; Add 47 1; Add 278 1; Add 278 1; Mul 4 3;
  Mul 8 3; Add 1 0; Mul 31 4; Mul 28 4; Add 1 0; Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 36 244; Mul 33 244; Add 1 0; Sub 250 0; Mul 40 251; Mul 37 252; Add 1 0; Add 0 3; Sub 255 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 256 64; Add 257 64; Mul 47 1; Mul 44 1; Add 1 0; Add 0 10; Sub 64 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 260 27; Add 260 27; Mul 54 1; Mul 51 1; Add 1 0; Add 0 17; Sub 27 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 311 299; Sub 311 299; Sub 34 301; Sub 34 301; Sub 32 274; Mul 4 1; Mul 4 3; Sub 1 0;
  Div 231 0; Mul 156 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 161 11; Sub 1 0; Mul 0 7;
  Mul 4 316; Mul 1 316; Add 1 0; Sub 290 0; Add 1 0; Sub 292 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 334; Mul 7 334; Add 1 0; Add 0 5; Sub 297 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 60; Mul 12 60; Add 1 0; Add 0 10; Sub 60 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 322 317; Mul 322 318; Neg 1; Neg 1; Add 75 1; Add 75 1; Add 338 1; Add 338 1; Mul 4 3;
  Mul 8 3; Add 1 0; Mul 31 4; Mul 28 4; Add 1 0; Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 36 312; Mul 33 312; Add 1 0; Sub 322 0; Mul 40 320; Mul 37 320; Add 1 0; Add 0 3; Sub 327 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 45 64; Mul 42 64; Add 1 0; Add 0 8; Sub 90 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 326 25; Add 326 25; Mul 52 1; Mul 49 1; Add 1 0; Add 0 15; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 369 361; Sub 369 361; Sub 32 363; Sub 32 363; Sub 30 344; Mul 4 1; Mul 4 3; Sub 1 0;
  Div 301 0; Mul 226 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 231 11; Sub 1 0; Mul 0 7;
  Mul 4 378; Mul 1 378; Add 1 0; Sub 360 0; Add 1 0; Sub 362 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 392; Mul 7 392; Add 1 0; Add 0 5; Sub 367 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 58; Mul 12 58; Add 1 0; Add 0 10; Sub 58 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 386 381; Mul 386 382; Neg 1; Neg 1; Add 73 1; Add 73 1; Add 400 1; Add 400 1; Mul 4 3;
  Mul 8 3; Add 1 0; Mul 31 4; Mul 28 4; Add 1 0; Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 36 378; Mul 33 378; Add 1 0; Sub 392 0; Mul 40 386; Mul 37 386; Add 1 0; Add 0 3; Sub 397 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 45 64; Mul 42 64; Add 1 0; Add 0 8; Sub 88 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 392 25; Add 392 25; Mul 52 1; Mul 49 1; Add 1 0; Add 0 15; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 431 449; Sub 431 449; Sub 32 451; Sub 32 451; Sub 30 414; Mul 4 1; Mul 4 3; Sub 1 0;
  Div 371 0; Mul 296 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 301 11; Sub 1 0; Mul 0 7;
  Mul 4 466; Mul 1 466; Add 1 0; Sub 430 0; Add 1 0; Sub 432 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 454; Mul 7 454; Add 1 0; Add 0 5; Sub 437 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 58; Mul 12 58; Add 1 0; Add 0 10; Sub 58 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 257; Neg 257; Add 71 1; Add 71 1; Add 486 1; Add 486 1; Mul 4 3; Mul 264 3; Add 1 0;
  Mul 29 4; Mul 26 4; Add 1 0; Add 0 24; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 34 436; Mul 31 436; Add 1 0; Sub 460 0; Mul 38 450; Mul 35 450; Add 1 0; Add 0 3; Sub 465 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 43 62; Mul 40 62; Add 1 0; Add 0 8; Sub 86 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 450 25; Add 450 25; Mul 50 1; Mul 47 1; Add 1 0; Add 0 15; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 30 521; Sub 30 521; Sub 28 480; Mul 393 1; Mul 393 3; Sub 1 0; Div 437 0; Mul 362 5;
  Mul 397 5; Sub 1 0; Mul 0 3; Mul 401 8; Mul 367 11; Sub 1 0; Mul 0 7; Mul 4 536; Mul 1 536;
  Add 1 0; Sub 496 0; Add 1 0; Sub 498 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 538; Mul 7 538; Add 1 0; Add 0 5; Sub 503 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 56; Mul 12 56; Add 1 0; Add 0 10; Sub 56 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 315; Mul 17 315; Add 1 0; Add 0 15; Sub 315 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 514; Mul 22 515; Add 1 0; Sub 517 0; Mul 29 497; Mul 26 497; Add 1 0; Add 0 3; Sub 522 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 51; Mul 31 51; Add 1 0; Add 0 8; Sub 75 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 271; Mul 36 271; Add 1 0; Add 0 13; Sub 334 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 471 466; Mul 471 468; Sub 1 0; Div 489 0; Mul 414 470; Mul 475 415; Sub 1 0; Mul 0 3;
  Mul 479 418; Mul 419 476; Sub 1 0; Mul 0 7; Mul 4 545; Mul 1 546; Add 1 0; Sub 548 0; Add 1 0;
  Sub 550 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 548; Mul 7 548; Add 1 0; Add 0 5; Sub 555 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 549; Mul 12 549; Add 1 0; Add 0 10; Sub 560 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 550; Mul 17 550; Add 1 0; Add 0 15; Sub 565 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 545; Mul 22 545; Add 1 0; Add 0 20; Sub 570 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 571 568; Sub 572 568; Sub 316 570; Sub 316 570; Mul 3 0; Mul 3 2; Sub 1 0; Div 531 0;
  Mul 456 4; Mul 7 377; Sub 1 0; Mul 0 3; Mul 11 380; Mul 461 10; Sub 1 0; Mul 0 7; Mul 4 584;
  Mul 1 584; Add 1 0; Sub 590 0; Add 1 0; Sub 592 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 593; Mul 7 594; Add 1 0; Add 0 5; Sub 597 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 341; Mul 12 341; Add 1 0; Add 0 10; Sub 404 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 339; Mul 17 339; Add 1 0; Add 0 15; Sub 365 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 605 601; Sub 605 601; Sub 346 603; Sub 346 603; Mul 3 0; Mul 3 2; Sub 1 0; Div 568 0;
  Mul 493 4; Mul 7 342; Sub 1 0; Mul 0 3; Mul 11 345; Mul 498 10; Sub 1 0; Mul 0 7; Mul 4 617;
  Mul 1 617; Add 1 0; Sub 627 0; Add 1 0; Sub 629 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 627; Mul 7 627; Add 1 0; Add 0 5; Sub 634 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 371; Mul 12 371; Add 1 0; Add 0 10; Sub 397 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 306; Mul 17 306; Add 1 0; Add 0 15; Sub 330 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 638 634; Sub 638 634; Sub 313 636; Sub 313 636; Mul 3 0; Mul 3 2; Sub 1 0; Div 605 0;
  Mul 530 4; Mul 7 309; Sub 1 0; Mul 0 3; Mul 11 312; Mul 535 10; Sub 1 0; Mul 0 7; Mul 4 650;
  Mul 1 650; Add 1 0; Sub 664 0; Add 1 0; Sub 666 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 660; Mul 7 660; Add 1 0; Add 0 5; Sub 671 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 338; Mul 12 338; Add 1 0; Add 0 10; Sub 362 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 273; Mul 17 273; Add 1 0; Add 0 15; Sub 297 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 671 661; Sub 671 661; Sub 280 663; Sub 280 663; Mul 3 0; Mul 3 2; Sub 1 0; Div 642 0;
  Mul 567 4; Mul 7 276; Sub 1 0; Mul 0 3; Mul 11 279; Mul 572 10; Sub 1 0; Mul 0 7; Mul 4 677;
  Mul 1 677; Add 1 0; Sub 701 0; Add 1 0; Sub 703 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 693; Mul 7 693; Add 1 0; Add 0 5; Sub 708 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 305; Mul 12 305; Add 1 0; Add 0 10; Sub 329 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 242; Mul 17 242; Add 1 0; Add 0 15; Sub 266 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 698 719; Sub 698 720; Sub 249 721; Sub 249 722; Mul 3 0; Mul 3 2; Sub 1 0; Div 679 0;
  Mul 604 4; Mul 7 247; Sub 1 0; Mul 0 3; Mul 11 250; Mul 609 10; Sub 1 0; Mul 0 7; Mul 4 735;
  Mul 1 736; Add 1 0; Sub 738 0; Add 1 0; Sub 740 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 720; Mul 7 720; Add 1 0; Add 0 5; Sub 745 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 274; Mul 12 274; Add 1 0; Add 0 10; Sub 298 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 494; Mul 17 494; Add 1 0; Add 0 15; Sub 557 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 215 625;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 212 622;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 547;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 172 544;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 140 477;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 137 474;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 105 409;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 102 406;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 70 341;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 67 338;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 35 277;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 32 274;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 629; Neg 550; Neg 479; Neg 410; Neg 341; Neg 276; Neg 225; Neg 184; Neg 148; Neg 112;
  Neg 76; Neg 40; Sub 291 649; Sub 288 646; Sub 8 13; Sub 572 652; Sub 569 649; Sub 15 16;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 742 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Sub 515 667; Sub 512 664; Sub 29 31; Mul 17 1; Mul 17 3; Sub 1 0; Div 757 0;
  Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 460 682;
  Sub 457 679; Sub 43 46; Mul 17 1; Mul 17 3; Sub 1 0; Div 772 0; Mul 19 5; Mul 21 5; Sub 1 0;
  Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 405 697; Sub 402 694; Sub 57 61; Mul 17 1;
  Mul 17 3; Sub 1 0; Div 787 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11;
  Sub 1 0; Mul 0 7; Mul 14 61; Mul 14 63; Sub 1 0; Div 799 0; Mul 16 65; Mul 18 65; Sub 1 0;
  Mul 0 3; Mul 22 68; Mul 21 71; Sub 1 0; Mul 0 7; Sub 124 314; Sub 121 311; Sub 77 82;
  Sub 275 317; Sub 272 314; Sub 84 85; Mul 5 1; Mul 5 3; Sub 1 0; Div 817 0; Mul 7 5; Mul 9 5;
  Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Sub 253 332; Sub 250 329; Sub 98 100;
  Mul 17 1; Mul 17 3; Sub 1 0; Div 832 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8;
  Mul 24 11; Sub 1 0; Mul 0 7; Sub 231 347; Sub 228 344; Sub 112 115; Mul 17 1; Mul 17 3; Sub 1 0;
  Div 847 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Sub 209 362; Sub 206 359; Sub 126 130; Mul 17 1; Mul 17 3; Sub 1 0; Div 862 0; Mul 19 5;
  Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Mul 14 61; Mul 14 63;
  Sub 1 0; Div 874 0; Mul 16 65; Mul 18 65; Sub 1 0; Mul 0 3; Mul 22 68; Mul 21 71; Sub 1 0;
  Mul 0 7; Sub 121 136; Sub 118 133; Sub 48 63; Sub 45 60; Sub 110 140; Sub 107 137; Sub 37 67;
  Sub 34 64; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 945 0;
  Sub 107 152; Sub 104 149; Sub 34 79; Sub 31 76; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7;
  Sub 1 0; Add 3 0; Add 11 0; Sub 107 164; Sub 104 161; Sub 34 91; Sub 31 88; Mul 15 0; Mul 15 2;
  Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Mul 0 849;
  ShowZero 0 (* D(F*, S* ) *)
].

Theorem part_1_size_5_valid : valid part_1_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k corners and the ring around it; size 6.
    Code: src/pair/area.rs, src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs,
    src/scalar/ring.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_6 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 5 1; Sub 5 1; Sub 5 7;
  Sub 5 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 6;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Unknown 7; Unknown 8; Sub 1 13; Sub 1 13; Mul 9 0; Mul 9 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 9;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Unknown 10; Unknown 11; Sub 1 9; Sub 1 9; Mul 9 0; Mul 9 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 12;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Unknown 13; Unknown 14; Sub 1 9; Sub 1 9; Mul 9 0; Mul 9 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 15;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Sub 33 7; Sub 33 7; Mul 7 0; Mul 7 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 16;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Mul 5 36; Mul 5 38; Sub 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 17;
  Nonzero 0; (* faces of the ring are not horizontal *)
  Unknown 18;
  Nonzero 0; (* no edge of S has length 0 *)
  Unknown 19;
  Nonzero 0; (* no edge of S has length 0 *)
  Unknown 20;
  Nonzero 0; (* no edge of S has length 0 *)
  Unknown 21;
  Nonzero 0; (* no edge of S has length 0 *)
  Constant 0; Mul 44 4; Mul 44 5; Add 2 1; Add 3 1; Mul 40 7; Mul 40 8; Add 3 1; Add 3 1;
  Mul 36 10; Mul 36 11; Add 3 1; Add 3 1; Mul 32 13; Mul 32 14; Add 3 1; Add 3 1; Sub 16 1;
  Sub 17 1; Mul 1 63; Mul 1 65; Sub 1 0; Div 0 27; Mul 36 0; Mul 36 1; Add 9 1; Add 9 1; Sub 1 11;
  Sub 1 11; Mul 1 73; Mul 1 75; Sub 1 0;
  Nonzero 0; (* no edge of S has length 0 *)
  Sub 31 6; Sub 32 6; Mul 1 76; Mul 1 78; Sub 1 0;
  Nonzero 0; (* no edge of S has length 0 *)
  Mul 56 36; Mul 56 37; Add 27 1; Add 27 1; Sub 40 1; Sub 41 1; Mul 1 87; Mul 1 89; Sub 1 0;
  Div 0 51; Mul 60 0; Mul 60 1; Add 9 1; Add 9 1; Constant 1; Mul 71 0; Mul 71 1; Add 42 1;
  Add 42 1; Sub 55 1; Sub 56 1; Mul 1 102; Mul 1 104; Sub 1 0; Div 0 66; Mul 75 0; Mul 75 1;
  Add 9 1; Add 9 1; Sub 62 65; Sub 62 66; Sub 105 119; Sub 105 119; Sub 62 69; Sub 62 70;
  Mul 115 0; Mul 115 2; Sub 1 0; Add 74 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 109 131;
  Sub 109 131; Sub 70 81; Sub 70 82; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8;
  Sub 1 0; Add 3 0; Sub 113 143; Sub 113 143; Sub 54 93; Sub 54 94; Mul 15 0; Mul 15 2; Sub 1 0;
  Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0; Sub 151 155; Sub 151 155; Sub 56 105; Sub 56 106;
  Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0; Sub 61 115;
  Sub 61 116; Mul 37 0; Mul 37 2; Sub 1 0; Add 29 0; Add 0 19; Sub 58 122; Sub 58 123; Mul 32 0;
  Mul 32 2; Sub 1 0; Add 5 0; Mul 12 23; Mul 12 25; Sub 1 0; Add 3 0; Sub 0 17; Mul 0 134;
  Add 19 0; Constant 4; Div 85 0; Mul 2 0;
  Zero 0; (* (M, S) is i-minimal: area(F, S) = 0 *)
  Sub 138 138; Mul 183 70; Mul 183 72; Sub 1 0; Div 91 0; Mul 4 74; Mul 187 5; Sub 1 0; Mul 0 3;
  Mul 191 8; Mul 9 80; Sub 1 0; Mul 0 7; Mul 4 203; Mul 1 203; Add 1 0; Sub 154 0; Add 1 0;
  Sub 156 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 207; Mul 7 207; Add 1 0; Add 0 5; Sub 161 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 200; Mul 12 200; Add 1 0; Add 0 10; Sub 166 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 197; Mul 17 197; Add 1 0; Add 0 15; Sub 171 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 194; Mul 22 194; Add 1 0; Add 0 20; Sub 176 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 30 225; Mul 27 225; Add 1 0; Add 0 25; Sub 181 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 35 182; Mul 32 183; Add 1 0; Sub 185 0; Mul 39 183; Mul 36 183; Add 1 0; Add 0 3; Sub 190 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 44 184; Mul 41 184; Add 1 0; Add 0 8; Sub 195 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 49 185; Mul 46 185; Add 1 0; Add 0 13; Sub 200 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 54 186; Mul 51 186; Add 1 0; Add 0 18; Sub 205 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 59 181; Mul 56 181; Add 1 0; Add 0 23; Sub 210 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 257 216; Mul 257 217; Mul 257 252; Mul 257 253; Neg 1; Neg 1; Add 5 1; Add 5 1; Add 271 1;
  Add 271 1; Mul 4 3; Mul 8 3; Add 1 0; Sub 276 274; Sub 276 274; Sub 6 276; Sub 6 276; Sub 4 228;
  Mul 4 1; Mul 4 3; Sub 1 0; Div 181 0; Mul 94 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 99 11;
  Sub 1 0; Mul 0 7; Mul 4 291; Mul 1 291; Add 1 0; Sub 244 0; Add 1 0; Sub 246 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 299; Mul 7 299; Add 1 0; Add 0 5; Sub 251 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 32; Mul 12 32; Add 1 0; Add 0 10; Sub 32 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 293 288; Mul 293 289; Neg 1; Neg 1; Add 47 1; Add 47 1; Add 313 1; Add 313 1; Mul 4 3;
  Mul 8 3; Add 1 0; Mul 31 4; Mul 28 4; Add 1 0; Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 36 270; Mul 33 270; Add 1 0; Sub 276 0; Mul 40 277; Mul 37 278; Add 1 0; Add 0 3; Sub 281 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 282 64; Add 283 64; Mul 47 1; Mul 44 1; Add 1 0; Add 0 10; Sub 64 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 286 27; Add 286 27; Mul 54 1; Mul 51 1; Add 1 0; Add 0 17; Sub 27 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 346 334; Sub 346 334; Sub 34 336; Sub 34 336; Sub 32 300; Mul 4 1; Mul 4 3; Sub 1 0;
  Div 253 0; Mul 166 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 171 11; Sub 1 0; Mul 0 7;
  Mul 4 351; Mul 1 351; Add 1 0; Sub 316 0; Add 1 0; Sub 318 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 369; Mul 7 369; Add 1 0; Add 0 5; Sub 323 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 60; Mul 12 60; Add 1 0; Add 0 10; Sub 60 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 357 352; Mul 357 353; Neg 1; Neg 1; Add 75 1; Add 75 1; Add 373 1; Add 373 1; Mul 4 3;
  Mul 8 3; Add 1 0; Mul 31 4; Mul 28 4; Add 1 0; Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 36 338; Mul 33 338; Add 1 0; Sub 348 0; Mul 40 346; Mul 37 346; Add 1 0; Add 0 3; Sub 353 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 45 64; Mul 42 64; Add 1 0; Add 0 8; Sub 90 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 352 25; Add 352 25; Mul 52 1; Mul 49 1; Add 1 0; Add 0 15; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 404 396; Sub 404 396; Sub 32 398; Sub 32 398; Sub 30 370; Mul 4 1; Mul 4 3; Sub 1 0;
  Div 323 0; Mul 236 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 241 11; Sub 1 0; Mul 0 7;
  Mul 4 413; Mul 1 413; Add 1 0; Sub 386 0; Add 1 0; Sub 388 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 427; Mul 7 427; Add 1 0; Add 0 5; Sub 393 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 58; Mul 12 58; Add 1 0; Add 0 10; Sub 58 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 419 414; Mul 419 415; Neg 1; Neg 1; Add 73 1; Add 73 1; Add 435 1; Add 435 1; Mul 4 3;
  Mul 8 3; Add 1 0; Mul 31 4; Mul 28 4; Add 1 0; Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 36 404; Mul 33 404; Add 1 0; Sub 418 0; Mul 40 412; Mul 37 412; Add 1 0; Add 0 3; Sub 423 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 45 64; Mul 42 64; Add 1 0; Add 0 8; Sub 88 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 418 25; Add 418 25; Mul 52 1; Mul 49 1; Add 1 0; Add 0 15; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 466 458; Sub 466 458; Sub 32 460; Sub 32 460; Sub 30 440; Mul 4 1; Mul 4 3; Sub 1 0;
  Div 393 0; Mul 306 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 311 11; Sub 1 0; Mul 0 7;
  Mul 4 475; Mul 1 475; Add 1 0; Sub 456 0; Add 1 0; Sub 458 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 489; Mul 7 489; Add 1 0; Add 0 5; Sub 463 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 58; Mul 12 58; Add 1 0; Add 0 10; Sub 58 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 483 478; Mul 483 479; Neg 1; Neg 1; Add 73 1; Add 73 1; Add 497 1; Add 497 1; Mul 4 3;
  Mul 8 3; Add 1 0; Mul 31 4; Mul 28 4; Add 1 0; Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 36 470; Mul 33 470; Add 1 0; Sub 488 0; Mul 40 478; Mul 37 478; Add 1 0; Add 0 3; Sub 493 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 45 64; Mul 42 64; Add 1 0; Add 0 8; Sub 88 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 484 25; Add 484 25; Mul 52 1; Mul 49 1; Add 1 0; Add 0 15; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 528 554; Sub 528 554; Sub 32 556; Sub 32 556; Sub 30 510; Mul 4 1; Mul 4 3; Sub 1 0;
  Div 463 0; Mul 376 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 381 11; Sub 1 0; Mul 0 7;
  Mul 4 571; Mul 1 571; Add 1 0; Sub 526 0; Add 1 0; Sub 528 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 551; Mul 7 551; Add 1 0; Add 0 5; Sub 533 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 58; Mul 12 58; Add 1 0; Add 0 10; Sub 58 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 327; Neg 327; Add 71 1; Add 71 1; Add 591 1; Add 591 1; Mul 4 3; Mul 334 3; Add 1 0;
  Mul 29 4; Mul 26 4; Add 1 0; Add 0 24; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 34 528; Mul 31 528; Add 1 0; Sub 556 0; Mul 38 542; Mul 35 542; Add 1 0; Add 0 3; Sub 561 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 43 62; Mul 40 62; Add 1 0; Add 0 8; Sub 86 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 542 25; Add 542 25; Mul 50 1; Mul 47 1; Add 1 0; Add 0 15; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 30 626; Sub 30 626; Sub 28 576; Mul 473 1; Mul 473 3; Sub 1 0; Div 529 0; Mul 442 5;
  Mul 477 5; Sub 1 0; Mul 0 3; Mul 481 8; Mul 447 11; Sub 1 0; Mul 0 7; Mul 4 641; Mul 1 641;
  Add 1 0; Sub 592 0; Add 1 0; Sub 594 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 643; Mul 7 643; Add 1 0; Add 0 5; Sub 599 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 56; Mul 12 56; Add 1 0; Add 0 10; Sub 56 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 385; Mul 17 385; Add 1 0; Add 0 15; Sub 385 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 610; Mul 22 611; Add 1 0; Sub 613 0; Mul 29 589; Mul 26 589; Add 1 0; Add 0 3; Sub 618 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 51; Mul 31 51; Add 1 0; Add 0 8; Sub 75 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 341; Mul 36 341; Add 1 0; Add 0 13; Sub 404 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 563 558; Mul 563 560; Sub 1 0; Div 581 0; Mul 494 562; Mul 567 495; Sub 1 0; Mul 0 3;
  Mul 571 498; Mul 499 568; Sub 1 0; Mul 0 7; Mul 4 641; Mul 1 642; Add 1 0; Sub 644 0; Add 1 0;
  Sub 646 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 644; Mul 7 644; Add 1 0; Add 0 5; Sub 651 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 645; Mul 12 645; Add 1 0; Add 0 10; Sub 656 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 646; Mul 17 646; Add 1 0; Add 0 15; Sub 661 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 647; Mul 22 647; Add 1 0; Add 0 20; Sub 666 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 30 642; Mul 27 642; Add 1 0; Add 0 25; Sub 671 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 672 669; Sub 673 669; Sub 391 671; Sub 391 671; Mul 3 0; Mul 3 2; Sub 1 0; Div 628 0;
  Mul 541 4; Mul 7 452; Sub 1 0; Mul 0 3; Mul 11 455; Mul 546 10; Sub 1 0; Mul 0 7; Mul 4 685;
  Mul 1 685; Add 1 0; Sub 691 0; Add 1 0; Sub 693 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 694; Mul 7 695; Add 1 0; Add 0 5; Sub 698 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 416; Mul 12 416; Add 1 0; Add 0 10; Sub 479 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 414; Mul 17 414; Add 1 0; Add 0 15; Sub 440 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 706 702; Sub 706 702; Sub 421 704; Sub 421 704; Mul 3 0; Mul 3 2; Sub 1 0; Div 665 0;
  Mul 578 4; Mul 7 417; Sub 1 0; Mul 0 3; Mul 11 420; Mul 583 10; Sub 1 0; Mul 0 7; Mul 4 718;
  Mul 1 718; Add 1 0; Sub 728 0; Add 1 0; Sub 730 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 728; Mul 7 728; Add 1 0; Add 0 5; Sub 735 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 446; Mul 12 446; Add 1 0; Add 0 10; Sub 472 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 381; Mul 17 381; Add 1 0; Add 0 15; Sub 405 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 739 735; Sub 739 735; Sub 388 737; Sub 388 737; Mul 3 0; Mul 3 2; Sub 1 0; Div 702 0;
  Mul 615 4; Mul 7 384; Sub 1 0; Mul 0 3; Mul 11 387; Mul 620 10; Sub 1 0; Mul 0 7; Mul 4 751;
  Mul 1 751; Add 1 0; Sub 765 0; Add 1 0; Sub 767 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 761; Mul 7 761; Add 1 0; Add 0 5; Sub 772 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 413; Mul 12 413; Add 1 0; Add 0 10; Sub 437 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 348; Mul 17 348; Add 1 0; Add 0 15; Sub 372 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 772 768; Sub 772 768; Sub 355 770; Sub 355 770; Mul 3 0; Mul 3 2; Sub 1 0; Div 739 0;
  Mul 652 4; Mul 7 351; Sub 1 0; Mul 0 3; Mul 11 354; Mul 657 10; Sub 1 0; Mul 0 7; Mul 4 784;
  Mul 1 784; Add 1 0; Sub 802 0; Add 1 0; Sub 804 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 794; Mul 7 794; Add 1 0; Add 0 5; Sub 809 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 380; Mul 12 380; Add 1 0; Add 0 10; Sub 404 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 315; Mul 17 315; Add 1 0; Add 0 15; Sub 339 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 805 795; Sub 805 795; Sub 322 797; Sub 322 797; Mul 3 0; Mul 3 2; Sub 1 0; Div 776 0;
  Mul 689 4; Mul 7 318; Sub 1 0; Mul 0 3; Mul 11 321; Mul 694 10; Sub 1 0; Mul 0 7; Mul 4 811;
  Mul 1 811; Add 1 0; Sub 839 0; Add 1 0; Sub 841 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 827; Mul 7 827; Add 1 0; Add 0 5; Sub 846 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 347; Mul 12 347; Add 1 0; Add 0 10; Sub 371 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 284; Mul 17 284; Add 1 0; Add 0 15; Sub 308 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 832 857; Sub 832 858; Sub 291 859; Sub 291 860; Mul 3 0; Mul 3 2; Sub 1 0; Div 813 0;
  Mul 726 4; Mul 7 289; Sub 1 0; Mul 0 3; Mul 11 292; Mul 731 10; Sub 1 0; Mul 0 7; Mul 4 873;
  Mul 1 874; Add 1 0; Sub 876 0; Add 1 0; Sub 878 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 854; Mul 7 854; Add 1 0; Add 0 5; Sub 883 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 316; Mul 12 316; Add 1 0; Add 0 10; Sub 340 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 606; Mul 17 606; Add 1 0; Add 0 15; Sub 669 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 257 747;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 254 744;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 212 659;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 209 656;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 177 589;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 174 586;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 142 521;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 139 518;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 107 453;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 104 450;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 72 385;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 69 382;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 37 321;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 34 318;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 753; Neg 664; Neg 593; Neg 524; Neg 455; Neg 386; Neg 321; Neg 270; Neg 224; Neg 188;
  Neg 152; Neg 116; Neg 80; Neg 44; Sub 337 775; Sub 334 772; Sub 9 15; Sub 688 778; Sub 685 775;
  Sub 17 18; Mul 5 1; Mul 5 3; Sub 1 0; Div 880 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8;
  Mul 12 11; Sub 1 0; Mul 0 7; Sub 631 793; Sub 628 790; Sub 31 33; Mul 17 1; Mul 17 3; Sub 1 0;
  Div 895 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Sub 576 808; Sub 573 805; Sub 45 48; Mul 17 1; Mul 17 3; Sub 1 0; Div 910 0; Mul 19 5; Mul 21 5;
  Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 521 823; Sub 518 820; Sub 59 63;
  Mul 17 1; Mul 17 3; Sub 1 0; Div 925 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8;
  Mul 24 11; Sub 1 0; Mul 0 7; Sub 466 838; Sub 463 835; Sub 73 78; Mul 17 1; Mul 17 3; Sub 1 0;
  Div 940 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Mul 14 76; Mul 14 78; Sub 1 0; Div 952 0; Mul 16 80; Mul 18 80; Sub 1 0; Mul 0 3; Mul 22 83;
  Mul 21 86; Sub 1 0; Mul 0 7; Sub 143 375; Sub 140 372; Sub 92 98; Sub 331 378; Sub 328 375;
  Sub 100 101; Mul 5 1; Mul 5 3; Sub 1 0; Div 970 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8;
  Mul 12 11; Sub 1 0; Mul 0 7; Sub 309 393; Sub 306 390; Sub 114 116; Mul 17 1; Mul 17 3; Sub 1 0;
  Div 985 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7;
  Sub 287 408; Sub 284 405; Sub 128 131; Mul 17 1; Mul 17 3; Sub 1 0; Div 1000 0; Mul 19 5;
  Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 265 423; Sub 262 420;
  Sub 142 146; Mul 17 1; Mul 17 3; Sub 1 0; Div 1015 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3;
  Mul 25 8; Mul 24 11; Sub 1 0; Mul 0 7; Sub 243 438; Sub 240 435; Sub 156 161; Mul 17 1;
  Mul 17 3; Sub 1 0; Div 1030 0; Mul 19 5; Mul 21 5; Sub 1 0; Mul 0 3; Mul 25 8; Mul 24 11;
  Sub 1 0; Mul 0 7; Mul 14 76; Mul 14 78; Sub 1 0; Div 1042 0; Mul 16 80; Mul 18 80; Sub 1 0;
  Mul 0 3; Mul 22 83; Mul 21 86; Sub 1 0; Mul 0 7; Sub 151 166; Sub 148 163; Sub 63 78; Sub 60 75;
  Sub 140 170; Sub 137 167; Sub 52 82; Sub 49 79; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7;
  Sub 1 0; Add 3 0; Add 1117 0; Sub 137 182; Sub 134 179; Sub 49 94; Sub 46 91; Mul 15 0;
  Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Sub 134 194; Sub 131 191;
  Sub 46 106; Sub 43 103; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0;
  Add 11 0; Sub 134 206; Sub 131 203; Sub 46 118; Sub 43 115; Mul 15 0; Mul 15 2; Sub 1 0;
  Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Mul 0 1017;
  ShowZero 0 (* D(F*, S* ) *)
].

Theorem part_1_size_6_valid : valid part_1_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the Enneper surface; size 1.
    Code: src/construct/minimal/enneper.rs, src/construct/packing.rs, src/pair/face.rs,
    src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs, src/scalar/ring.rs,
    src/space/duality.rs, src/space/gradient.rs, src/space/oriented_circle.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 3;
  Nonzero 0; (* 3 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 1; Div 0 4; Constant 0; Add 0 0; Sub 5 0; Sub 5 1; Mul 1 1;
  Mul 1 1; Add 1 0; Mul 7 7; Sub 1 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 8 9; Sub 13 0; Sub 13 1; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 7;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 17 15; Sub 19 0; Mul 0 0; Add 14 0; Sub 0 12;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 22 21; Sub 24 0; Mul 0 0; Add 11 0; Sub 0 17;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 31 25; Sub 29 0; Mul 0 0; Add 24 0; Sub 0 22;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 36 31; Sub 34 0; Mul 0 0; Add 21 0; Sub 0 27;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 40 35; Sub 39 0; Mul 0 0; Add 34 0; Sub 0 32;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 44 24; Mul 0 0; Add 0 37; Sub 0 36;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 48 23; Mul 0 0; Add 0 33; Sub 0 40;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 30; Sub 0 42;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 4 27; Sub 0 44;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 10 24; Sub 0 46;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 8 21; Sub 0 48;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 14 18; Sub 0 50;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 62 32; Mul 0 0; Add 0 55; Sub 0 54;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 66 31; Mul 0 0; Add 0 51; Sub 0 58;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 48; Sub 0 60;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 4 45; Sub 0 62;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 10 42; Sub 0 64;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 8 39; Sub 0 66;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 14 36; Sub 0 68;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 80 40; Mul 0 0; Add 0 73; Sub 0 72;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 2 62; Sub 0 74;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 4 54; Sub 0 76;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 46; Sub 0 78;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Constant 4; Div 89 0; Sub 79 92; Sub 80 92; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 73 97; Mul 0 0; Add 5 0; Sub 0 9;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 67 101; Mul 0 0; Add 9 0; Sub 0 13;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 81 106; Mul 0 0; Add 0 12; Sub 0 17;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 2 10; Sub 0 19;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 4 8; Sub 0 21;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 79 114; Mul 0 0; Add 0 20; Sub 0 25;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 2 18; Sub 0 27;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 4 16; Sub 0 29;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Div 120 123; Constant 12; Div 122 0; Sub 121 125; Sub 122 125; Mul 1 1; Mul 1 1; Mul 1 6;
  Sub 1 0; Add 0 6; Mul 6 0; Mul 4 10; Sub 0 6; Sub 0 10; Mul 9 0; Mul 137 4; Mul 137 1; Add 1 0;
  Sub 11 12; Mul 0 138; Add 0 2; Sub 141 143; Mul 0 0; Mul 0 22; Sub 17 0; Add 0 22; Mul 4 0;
  Sub 15 4; Sub 0 25; Mul 24 0; Mul 152 3; Mul 152 1; Add 1 0; Sub 26 10; Mul 0 153; Add 0 2;
  Sub 156 157; Mul 0 0; Sub 0 14; Add 0 36; Mul 18 0; Mul 3 40; Sub 0 19; Sub 0 40; Mul 7 0;
  Mul 167 4; Mul 167 1; Add 1 0; Sub 10 25; Mul 0 168; Add 0 2; Sub 24 40; Sub 22 37; Sub 17 32;
  Sub 13 43; Sub 10 40; Sub 5 35; Mul 5 1; Mul 5 3; Sub 1 0; Div 180 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 58; Mul 1 55; Add 1 0; Sub 51 0; Add 1 0;
  Sub 53 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 48; Mul 7 46; Add 1 0; Add 0 5; Sub 43 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 77; Add 0 83; Mul 83 0; Sub 46 82; Sub 0 86; Mul 53 0; Mul 213 3; Mul 213 1; Add 1 0;
  Sub 56 88; Mul 0 214; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 96 95; Sub 0 133; Div 224 0; Mul 101 0; Mul 101 1; Add 229 1; Add 229 1; Mul 4 228;
  Add 87 103; Sub 0 141; Div 232 0; Mul 91 0; Mul 109 1; Add 237 1; Add 237 1; Mul 4 236;
  Mul 10 10; Mul 10 10; Add 1 0; Mul 11 11; Sub 1 0; Mul 0 242; Mul 8 8; Mul 8 8; Add 1 0;
  Mul 9 9; Sub 1 0; Mul 0 248; Mul 65 22; Mul 62 22; Add 1 0; Sub 9 0; Mul 69 18; Mul 66 18;
  Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 116 101; Sub 0 170; Div 261 0; Mul 120 0; Mul 106 1; Add 266 1; Add 266 1; Mul 4 265;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 271; Mul 88 8; Mul 85 8; Add 1 0; Add 0 22;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 152 120; Sub 0 189; Div 280 0; Mul 157 0; Mul 125 1; Add 285 1; Add 285 1; Mul 4 284;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 290; Mul 107 8; Mul 104 8; Add 1 0; Add 0 41;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 301 298; Mul 0 0; Sub 0 155; Add 0 177; Mul 159 0; Mul 3 181; Sub 0 160; Sub 0 181; Mul 7 0;
  Mul 308 4; Mul 308 1; Add 1 0; Sub 10 166; Mul 0 309; Add 0 2; Sub 151 104; Sub 148 102;
  Sub 143 97; Sub 13 107; Sub 10 105; Sub 5 100; Mul 5 1; Mul 5 3; Sub 1 0; Div 321 0; Mul 7 5;
  Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 122; Mul 1 120; Add 1 0;
  Sub 116 0; Add 1 0; Sub 118 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 175; Mul 7 172; Add 1 0; Add 0 5; Sub 169 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 218; Add 0 224; Mul 224 0; Sub 46 223; Sub 0 227; Mul 53 0; Mul 354 3; Mul 354 1;
  Add 1 0; Sub 56 229; Mul 0 355; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 37 79; Mul 34 79; Add 1 0; Sub 74 0; Mul 41 102; Mul 38 102; Add 1 0; Add 0 3; Sub 98 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 229 73; Sub 0 283; Div 374 0; Mul 233 0; Mul 78 1; Add 379 1; Add 379 1; Mul 4 378; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 384; Mul 60 8; Mul 57 8; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 265 92; Sub 0 302; Div 393 0; Mul 270 0; Mul 97 1; Add 398 1; Add 398 1; Mul 4 397; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 403; Mul 79 8; Mul 76 8; Add 1 0; Add 0 41; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 413 411; Mul 0 0; Sub 0 268; Add 0 290; Mul 272 0; Mul 3 294; Sub 0 273; Sub 0 294; Mul 7 0;
  Mul 421 4; Mul 421 1; Add 1 0; Sub 10 279; Mul 0 422; Add 0 2; Sub 123 76; Sub 120 74;
  Sub 115 69; Sub 13 79; Sub 10 77; Sub 5 72; Mul 5 1; Mul 5 3; Sub 1 0; Div 434 0; Mul 7 5;
  Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 94; Mul 1 92; Add 1 0;
  Sub 88 0; Add 1 0; Sub 90 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 147; Mul 7 144; Add 1 0; Add 0 5; Sub 141 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 331; Add 0 337; Mul 337 0; Sub 46 336; Sub 0 340; Mul 53 0; Mul 467 3; Mul 467 1;
  Add 1 0; Sub 56 342; Mul 0 468; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 37 79; Mul 34 79; Add 1 0; Sub 74 0; Mul 41 102; Mul 38 102; Add 1 0; Add 0 3; Sub 98 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 342 73; Sub 0 396; Div 487 0; Mul 346 0; Mul 78 1; Add 492 1; Add 492 1; Mul 4 491; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 497; Mul 60 8; Mul 57 8; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 378 92; Sub 0 415; Div 506 0; Mul 383 0; Mul 97 1; Add 511 1; Add 511 1; Mul 4 510; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 516; Mul 79 8; Mul 76 8; Add 1 0; Add 0 41; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 527 525; Mul 0 0; Mul 0 404; Sub 399 0; Add 0 404; Mul 4 0; Sub 397 4; Sub 0 407; Mul 406 0;
  Mul 534 3; Mul 534 1; Add 1 0; Sub 408 10; Mul 0 535; Add 0 2; Sub 380 12; Add 0 416; Mul 16 0;
  Sub 379 16; Sub 0 419; Mul 386 0; Mul 546 3; Mul 546 1; Add 1 0; Sub 389 22; Mul 0 547; Add 0 2;
  Sub 21 403; Sub 19 401; Sub 14 396; Sub 12 406; Sub 10 404; Sub 5 399; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 559 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 421; Mul 1 419; Add 1 0; Sub 415 0; Add 1 0; Sub 417 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 45; Mul 7 43; Add 1 0; Add 0 5; Sub 40 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 423; Mul 17 420; Add 1 0; Add 0 15; Sub 417 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 64 462; Sub 0 500; Div 591 0; Mul 68 0; Mul 468 1; Add 596 1; Add 596 1; Mul 4 595; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 601; Mul 39 367; Mul 36 367; Add 1 0; Sub 356 0;
  Mul 43 12; Mul 40 12; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 87 454; Sub 0 523; Div 614 0; Mul 91 0; Mul 459 1; Add 619 1; Add 619 1; Mul 4 618; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 624; Mul 62 8; Mul 59 8; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 67 366; Mul 64 366; Add 1 0; Add 0 27; Sub 362 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 337 110; Add 0 514; Mul 114 0; Sub 336 114; Sub 0 517; Mul 343 0; Mul 644 3; Mul 644 1;
  Add 1 0; Sub 346 120; Mul 0 645; Add 0 2; Sub 107 487; Sub 105 484; Sub 100 479; Sub 12 490;
  Sub 10 487; Sub 5 482; Mul 5 1; Mul 5 3; Sub 1 0; Div 657 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 505; Mul 1 502; Add 1 0; Sub 498 0; Add 1 0;
  Sub 500 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 131; Mul 7 129; Add 1 0; Add 0 5; Sub 126 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 380; Mul 17 377; Add 1 0; Add 0 15; Sub 374 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 422; Mul 22 422; Add 1 0; Sub 417 0; Mul 29 73; Mul 26 73; Add 1 0; Add 0 3; Sub 69 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 171 397; Sub 0 607; Div 698 0; Mul 175 0; Mul 402 1; Add 703 1; Add 703 1; Mul 4 702;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 708; Mul 48 8; Mul 45 8; Add 1 0; Add 0 22;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 53 337; Mul 50 337; Add 1 0; Add 0 27; Sub 333 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 308 194; Add 0 598; Mul 198 0; Sub 307 198; Sub 0 601; Mul 314 0; Mul 728 3; Mul 728 1;
  Add 1 0; Sub 317 204; Mul 0 729; Add 0 2; Sub 93 430; Sub 91 427; Sub 86 422; Sub 12 433;
  Sub 10 430; Sub 5 425; Mul 5 1; Mul 5 3; Sub 1 0; Div 741 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 448; Mul 1 445; Add 1 0; Sub 441 0; Add 1 0;
  Sub 443 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 117; Mul 7 115; Add 1 0; Add 0 5; Sub 112 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 351; Mul 17 348; Add 1 0; Add 0 15; Sub 345 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 393; Mul 22 393; Add 1 0; Sub 388 0; Mul 29 73; Mul 26 73; Add 1 0; Add 0 3; Sub 69 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 255 368; Sub 0 691; Div 782 0; Mul 259 0; Mul 373 1; Add 787 1; Add 787 1; Mul 4 786;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 792; Mul 48 8; Mul 45 8; Add 1 0; Add 0 22;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 53 308; Mul 50 308; Add 1 0; Add 0 27; Sub 304 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 807 806; Mul 0 0; Mul 0 685; Sub 680 0; Add 0 685; Mul 4 0; Sub 678 4; Sub 0 688; Mul 687 0;
  Mul 815 3; Mul 815 1; Add 1 0; Sub 689 10; Mul 0 816; Add 0 2; Sub 661 12; Add 0 697; Mul 16 0;
  Sub 660 16; Sub 0 700; Mul 667 0; Mul 827 3; Mul 827 1; Add 1 0; Sub 670 22; Mul 0 828; Add 0 2;
  Sub 21 302; Sub 19 300; Sub 14 295; Sub 12 305; Sub 10 303; Sub 5 298; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 840 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 320; Mul 1 318; Add 1 0; Sub 314 0; Add 1 0; Sub 316 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 45; Mul 7 43; Add 1 0; Add 0 5; Sub 40 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 324; Mul 17 322; Add 1 0; Add 0 15; Sub 319 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 64 743; Sub 0 781; Div 872 0; Mul 68 0; Mul 749 1; Add 877 1; Add 877 1; Mul 4 876; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 882; Mul 39 289; Mul 36 289; Add 1 0; Sub 284 0;
  Mul 43 12; Mul 40 12; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 87 735; Sub 0 804; Div 895 0; Mul 91 0; Mul 740 1; Add 900 1; Add 900 1; Mul 4 899; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 905; Mul 62 8; Mul 59 8; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 67 294; Mul 64 294; Add 1 0; Add 0 27; Sub 290 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 618 110; Add 0 795; Mul 114 0; Sub 617 114; Sub 0 798; Mul 624 0; Mul 925 3; Mul 925 1;
  Add 1 0; Sub 627 120; Mul 0 926; Add 0 2; Sub 107 388; Sub 105 386; Sub 100 381; Sub 12 391;
  Sub 10 389; Sub 5 384; Mul 5 1; Mul 5 3; Sub 1 0; Div 938 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 406; Mul 1 404; Add 1 0; Sub 400 0; Add 1 0;
  Sub 402 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 131; Mul 7 129; Add 1 0; Add 0 5; Sub 126 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 324; Mul 17 322; Add 1 0; Add 0 15; Sub 319 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 350; Mul 22 350; Add 1 0; Sub 345 0; Mul 29 73; Mul 26 73; Add 1 0; Add 0 3; Sub 69 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 171 678; Sub 0 888; Div 979 0; Mul 175 0; Mul 683 1; Add 984 1; Add 984 1; Mul 4 983;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 989; Mul 48 8; Mul 45 8; Add 1 0; Add 0 22;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 53 294; Mul 50 294; Add 1 0; Add 0 27; Sub 290 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 589 194; Add 0 879; Mul 198 0; Sub 588 198; Sub 0 882; Mul 595 0; Mul 1009 3; Mul 1009 1;
  Add 1 0; Sub 598 204; Mul 0 1010; Add 0 2; Sub 93 374; Sub 91 372; Sub 86 367; Sub 12 377;
  Sub 10 375; Sub 5 370; Mul 5 1; Mul 5 3; Sub 1 0; Div 1022 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 392; Mul 1 390; Add 1 0; Sub 386 0;
  Add 1 0; Sub 388 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 117; Mul 7 115; Add 1 0; Add 0 5; Sub 112 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 324; Mul 17 322; Add 1 0; Add 0 15; Sub 319 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 350; Mul 22 350; Add 1 0; Sub 345 0; Mul 29 73; Mul 26 73; Add 1 0; Add 0 3; Sub 69 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 255 649; Sub 0 972; Div 1063 0; Mul 259 0; Mul 654 1; Add 1068 1; Add 1068 1; Mul 4 1067;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 1073; Mul 48 8; Mul 45 8; Add 1 0; Add 0 22;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 53 294; Mul 50 294; Add 1 0; Add 0 27; Sub 290 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 849 857; Sub 849 857; Sub 837 843; Sub 823 860; Sub 823 860; Sub 817 846; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1094 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 875; Mul 1 875; Add 1 0; Sub 862 0; Add 1 0; Sub 864 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 873; Mul 7 873; Add 1 0; Add 0 5; Sub 863 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 849; Mul 12 849; Add 1 0; Add 0 10; Sub 845 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 835; Mul 17 835; Add 1 0; Add 0 15; Sub 831 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 859 840; Sub 859 840; Sub 853 834; Sub 749 843; Sub 749 843; Sub 743 837; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1133 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 858; Mul 1 858; Add 1 0; Sub 853 0; Add 1 0; Sub 855 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 883; Mul 7 883; Add 1 0; Add 0 5; Sub 879 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 775; Mul 12 775; Add 1 0; Add 0 10; Sub 771 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 761; Mul 17 761; Add 1 0; Add 0 15; Sub 757 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 785 766; Sub 785 766; Sub 779 760; Sub 675 769; Sub 675 769; Sub 669 763; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1172 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 784; Mul 1 784; Add 1 0; Sub 779 0; Add 1 0; Sub 781 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 809; Mul 7 809; Add 1 0; Add 0 5; Sub 805 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 701; Mul 12 701; Add 1 0; Add 0 10; Sub 697 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 687; Mul 17 687; Add 1 0; Add 0 15; Sub 683 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 607 966; Sub 607 966; Sub 601 954; Sub 587 969; Sub 587 969; Sub 581 957; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1211 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 984; Mul 1 984; Add 1 0; Sub 973 0; Add 1 0; Sub 975 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 631; Mul 7 631; Add 1 0; Add 0 5; Sub 627 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 613; Mul 12 613; Add 1 0; Add 0 10; Sub 609 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 971; Mul 17 971; Add 1 0; Add 0 15; Sub 967 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 623 976; Sub 623 976; Sub 617 970; Sub 542 979; Sub 542 979; Sub 536 973; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1250 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 994; Mul 1 994; Add 1 0; Sub 989 0; Add 1 0; Sub 991 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 647; Mul 7 647; Add 1 0; Add 0 5; Sub 643 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 568; Mul 12 568; Add 1 0; Add 0 10; Sub 564 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 897; Mul 17 897; Add 1 0; Add 0 15; Sub 893 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 578 902; Sub 578 902; Sub 572 896; Sub 497 905; Sub 497 905; Sub 491 899; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1289 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 920; Mul 1 920; Add 1 0; Sub 915 0; Add 1 0; Sub 917 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 602; Mul 7 602; Add 1 0; Add 0 5; Sub 598 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 523; Mul 12 523; Add 1 0; Add 0 10; Sub 519 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 823; Mul 17 823; Add 1 0; Add 0 15; Sub 819 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 443 724; Sub 443 724; Sub 437 718; Sub 423 727; Sub 423 727; Sub 417 721; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1328 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 742; Mul 1 742; Add 1 0; Sub 737 0; Add 1 0; Sub 739 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 467; Mul 7 467; Add 1 0; Add 0 5; Sub 463 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 449; Mul 12 449; Add 1 0; Add 0 10; Sub 445 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 735; Mul 17 735; Add 1 0; Add 0 15; Sub 731 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 459 740; Sub 459 740; Sub 453 734; Sub 378 743; Sub 378 743; Sub 372 737; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1367 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 758; Mul 1 758; Add 1 0; Sub 753 0; Add 1 0; Sub 755 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 483; Mul 7 483; Add 1 0; Add 0 5; Sub 479 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 404; Mul 12 404; Add 1 0; Add 0 10; Sub 400 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 690; Mul 17 690; Add 1 0; Add 0 15; Sub 686 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 414 695; Sub 414 695; Sub 408 689; Sub 333 698; Sub 333 698; Sub 327 692; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1406 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 713; Mul 1 713; Add 1 0; Sub 708 0; Add 1 0; Sub 710 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 438; Mul 7 438; Add 1 0; Add 0 5; Sub 434 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 359; Mul 12 359; Add 1 0; Add 0 10; Sub 355 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 645; Mul 17 645; Add 1 0; Add 0 15; Sub 641 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 337 1251;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 334 1248;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 300 1112;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 297 1109;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 263 1001;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 260 998;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 226 878;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 223 875;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 189 782;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 186 779;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 152 700;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 149 697;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 115 603;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 112 600;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 78 507;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 75 504;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 41 425;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 38 422;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 1261; Neg 883; Neg 786; Sub 893 1272; Sub 890 1269; Sub 3 4; Sub 798 1275; Sub 795 1272;
  Sub 5 7; Mul 5 1; Mul 5 3; Sub 1 0; Div 1466 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8;
  Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 1290; Mul 1 1287; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 917; Mul 7 914; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 824; Mul 12 821; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 1157; Mul 21 1166; Mul 18 1163; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 743; Sub 836 1172; Sub 833 1169; Sub 43 8; Sub 755 1175; Sub 752 1172; Sub 5 11; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 1507 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 1190; Mul 1 1187; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 860; Mul 7 857; Add 1 0; Add 0 5; Sub 69 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 781; Mul 12 778; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 1085; Mul 21 1094; Mul 18 1091; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 685; Neg 588; Sub 695 976; Sub 692 973; Sub 3 86; Sub 600 979; Sub 597 976; Sub 5 89;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 1549 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 994; Mul 1 991; Add 1 0; Sub 105 0; Add 1 0; Sub 107 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 719; Mul 7 716; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 626; Mul 12 623; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 912; Mul 17 909; Add 1 0; Add 0 15; Sub 121 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 544; Sub 637 918; Sub 634 915; Sub 42 125; Sub 556 921; Sub 553 918; Sub 5 128; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 1589 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 936; Mul 1 933; Add 1 0; Sub 144 0; Add 1 0; Sub 146 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 661; Mul 7 658; Add 1 0; Add 0 5; Sub 68 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 582; Mul 12 579; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 868; Mul 17 865; Add 1 0; Add 0 15; Sub 120 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 512; Neg 396; Neg 358; Sub 406 523; Sub 403 520; Sub 3 4; Sub 370 526; Sub 367 523; Sub 5 7;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 1631 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 541; Mul 1 538; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 430; Mul 7 427; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 396; Mul 12 393; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 510; Mul 21 519; Mul 18 516; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 360; Sub 408 525; Sub 405 522; Sub 43 8; Sub 372 528; Sub 369 525; Sub 5 11; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 1672 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 543; Mul 1 540; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 432; Mul 7 429; Add 1 0; Add 0 5; Sub 69 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 398; Mul 12 395; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 512; Mul 21 521; Mul 18 518; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 362; Neg 324; Sub 372 489; Sub 369 486; Sub 3 86; Sub 336 492; Sub 333 489; Sub 5 89;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 1714 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 507; Mul 1 504; Add 1 0; Sub 105 0; Add 1 0; Sub 107 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 396; Mul 7 393; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 362; Mul 12 359; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 484; Mul 17 481; Add 1 0; Add 0 15; Sub 121 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 325; Sub 373 490; Sub 370 487; Sub 42 125; Sub 337 493; Sub 334 490; Sub 5 128; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 1754 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 508; Mul 1 505; Add 1 0; Sub 144 0; Add 1 0; Sub 146 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 397; Mul 7 394; Add 1 0; Add 0 5; Sub 68 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 363; Mul 12 360; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 485; Mul 17 482; Add 1 0; Add 0 15; Sub 120 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 1135 538; Mul 1135 540; Sub 1 0; Mul 545 1134; Mul 545 1136; Sub 1 0; Add 3 0; Add 1789 0;
  Sub 1490 1631; Sub 1487 1628; Sub 1416 1529; Sub 1416 1529; Mul 1144 0; Mul 1144 2; Sub 1 0;
  Mul 554 5; Mul 554 7; Sub 1 0; Add 3 0; Add 11 0; Mul 0 1714;
  ShowZero 0; (* area(F, S) *)
  Sub 251 334; Sub 248 331; Sub 88 171; Sub 85 168; Sub 215 338; Sub 212 335; Sub 52 175;
  Sub 49 172; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 1818 0;
  Sub 309 350; Sub 306 347; Sub 146 187; Sub 143 184; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5;
  Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Mul 0 1743;
  ShowZero 0 (* D(F*, S* ) *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
