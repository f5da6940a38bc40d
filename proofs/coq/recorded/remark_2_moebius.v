(** remark-2-moebius (Sec. 3.4, Remark 2)

    An i-M-transformation maps the i-circles inscribed to the faces of an i-isothermic mesh to
    those of another: at every edge the images touch in one point, their planes meet over the
    common tangent, and around every vertex they meet in one point, over the centre of the image of
    the vertex circle.

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the incircles around a vertex; size 3.
    Code: src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs, src/space/moebius.rs,
    src/space/motion.rs, src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs,
    src/space/similarity.rs, src/space/sphere.rs *)
Definition part_1_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the vertex circle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 6 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 7 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 6 0; Add 10 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 8 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 13 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 5 15; Add 15 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 7 17;
  Nonzero 0; (* no edges agree *)
  Unknown 4; Unknown 5; Mul 21 21; Mul 2 2; Mul 2 2; Add 1 0; Sub 0 3;
  Nonzero 0; (* no vertex circle passes through the centre *)
  Div 26 8; Sub 25 10; Mul 0 1; Add 18 28; Mul 0 3; Add 11 2; Add 11 1; Sub 32 22; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 38 36; Sub 39 38; Mul 0 1; Mul 42 44; Mul 0 3; Mul 2 45; Mul 1 46; Add 27 1; Add 27 1;
  Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 52 45; Sub 51 47; Mul 0 1; Add 54 50; Mul 0 3; Add 37 2; Add 37 1; Sub 54 58; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 64 56; Sub 65 58; Mul 0 1; Mul 64 70; Mul 0 3; Mul 2 71; Mul 1 72; Add 53 1; Add 53 1;
  Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 78 65; Sub 77 67; Mul 0 1; Add 76 70; Mul 0 3; Add 63 2; Add 63 1; Sub 74 80; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 90 76; Sub 91 78; Mul 0 1; Mul 84 96; Mul 0 3; Mul 2 97; Mul 1 98; Add 79 1; Add 79 1;
  Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no incircle passes through the centre *)
  ShowNonzero 102; (* as src/space/sphere.rs finds *)
  Unknown 6; Unknown 7; Unknown 8; Sub 7 87; Sub 7 87; Sub 2 4; Sub 62 90; Sub 62 90; Sub 6 7;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 114 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 105; Mul 1 105; Add 1 0; Sub 23 0; Mul 8 29; Mul 5 29; Add 1 0; Add 0 3;
  Sub 26 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 102 34; Sub 102 34; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 103;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 92; Mul 16 92; Add 1 0; Add 0 14; Sub 38 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 113 97; Sub 113 97; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 114;
  ShowZero 0; (* the contact is on the incircle *)
  Unknown 9; Sub 78 132; Sub 78 132; Sub 2 49; Mul 44 1; Mul 44 3; Sub 1 0; Div 156 0; Mul 46 5;
  Mul 48 5; Sub 1 0; Mul 0 3; Mul 52 8; Mul 51 11; Sub 1 0; Mul 0 7; Mul 4 147; Mul 1 147;
  Add 1 0; Sub 65 0; Mul 8 123; Mul 5 123; Add 1 0; Add 0 3; Sub 69 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 118 128; Sub 118 128; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 119;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 108; Mul 16 108; Add 1 0; Add 0 14; Sub 34 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 129 113; Sub 129 113; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 130;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 40 84; Mul 40 86; Sub 1 0; Div 194 0; Mul 42 88; Mul 44 88; Sub 1 0; Mul 0 3; Mul 48 91;
  Mul 47 94; Sub 1 0; Mul 0 7; Mul 4 185; Mul 1 185; Add 1 0; Sub 103 0; Mul 8 135; Mul 5 135;
  Add 1 0; Add 0 3; Sub 61 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 130 140; Sub 130 140; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 131;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 120; Mul 16 120; Add 1 0; Add 0 14; Sub 117 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 141 125; Sub 141 125; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 142;
  ShowZero 0; (* the contact is on the incircle *)
  Unknown 10; Unknown 11; Unknown 12; Unknown 13; Constant 0; Mul 0 0; Add 0 0; Sub 0 236;
  Div 237 240; Mul 1 0; Neg 5; Div 243 240; Sub 7 7; Neg 3; Neg 243; Mul 2 1; Mul 3 5; Add 1 0;
  Add 0 1; Mul 6 4; Add 1 0; Mul 0 9; Mul 0 251; Sub 10 0; Add 0 19; Mul 3 14; Sub 13 0; Add 0 22;
  Mul 6 18; Sub 16 0; Add 0 25; Sub 260 26; Mul 0 18; Add 0 16; Add 0 17; Add 0 15; Mul 0 24;
  Mul 0 266; Sub 6 0; Add 0 34; Mul 3 29; Sub 28 0; Add 0 37; Mul 6 33; Sub 31 0; Add 0 40;
  Sub 6 21; Sub 4 19; Sub 2 17; Mul 17 38; Add 34 0; Add 0 34; Add 0 32; Mul 0 41; Mul 0 283;
  Sub 42 0; Add 0 51; Mul 3 46; Sub 26 0; Add 0 54; Sub 47 2; Add 0 56; Mul 8 52; Sub 50 0;
  Add 0 59; Sub 8 40; Sub 6 38; Sub 5 39; Sub 3 37; Add 51 19; Add 0 50; Mul 0 59; Mul 0 301;
  Sub 60 0; Add 0 69; Mul 3 64; Sub 63 0; Add 0 72; Sub 46 2; Add 0 74; Mul 8 70; Sub 68 0;
  Add 0 77; Sub 8 58; Sub 6 56; Sub 5 57; Sub 3 55; Mul 55 72; Add 69 0; Mul 0 77; Mul 0 319;
  Sub 78 0; Add 0 87; Mul 3 82; Sub 81 0; Add 0 90; Mul 6 86; Sub 65 0; Add 0 93; Sub 6 74;
  Sub 4 72; Sub 2 70; Add 101 101; Add 101 101; Add 101 101; Add 101 101; Mul 91 59; Mul 96 59;
  Add 1 0; Add 0 1; Mul 99 61; Add 1 0; Mul 101 65; Mul 98 65; Add 1 0; Add 0 7; Add 0 5; Add 4 9;
  Add 0 4; Add 0 8; Add 2 12; Mul 106 72; Add 1 0; Mul 108 57; Mul 113 57; Add 1 0; Mul 115 58;
  Add 1 0; Mul 117 59; Add 1 0; Mul 119 64; Mul 116 64; Add 1 0; Add 0 6; Add 0 5; Add 4 10;
  Mul 121 68; Add 1 0; Add 0 9; Add 3 12; Mul 125 71; Add 1 0; Mul 127 58; Mul 132 58; Add 1 0;
  Mul 134 59; Add 1 0; Mul 136 60; Add 1 0; Mul 138 65; Mul 135 65; Add 1 0; Add 0 6; Add 0 5;
  Add 4 10; Mul 140 69; Add 1 0; Add 0 9; Add 3 12; Mul 144 72; Add 1 0; Mul 146 61; Mul 151 61;
  Add 1 0; Add 0 1; Mul 154 63; Add 1 0; Mul 156 67; Mul 153 67; Add 1 0; Add 0 7; Add 0 5;
  Add 4 9; Add 0 4; Add 0 8; Add 2 12; Mul 161 74; Add 1 0; Mul 407 407; Mul 164 154; Mul 169 152;
  Add 1 0; Add 0 1; Mul 172 152; Add 1 0; Mul 174 160; Mul 171 158; Add 1 0; Add 0 7; Add 0 5;
  Add 4 9; Add 0 4; Add 0 8; Add 2 12; Mul 179 163; Add 1 0; Add 11 93; Add 7 93; Add 5 93;
  Add 3 93; Mul 429 88; Mul 196 84; Add 1 0; Mul 198 83; Add 1 0; Mul 200 82; Add 1 0; Mul 202 95;
  Mul 437 91; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 442 93; Add 1 0; Add 0 9; Add 3 12;
  Mul 446 94; Add 1 0; Mul 448 89; Mul 215 85; Add 1 0; Mul 217 83; Add 1 0; Mul 219 82; Add 1 0;
  Mul 221 96; Mul 456 92; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 461 93; Add 1 0; Add 0 9;
  Add 3 12; Mul 465 94; Add 1 0; Mul 467 89; Mul 234 85; Add 1 0; Mul 236 83; Add 1 0; Mul 238 82;
  Add 1 0; Mul 240 96; Mul 475 92; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 480 93; Add 1 0;
  Add 0 9; Add 3 12; Mul 484 94; Add 1 0; Mul 486 90; Mul 253 86; Add 1 0; Mul 255 85; Add 1 0;
  Mul 257 84; Add 1 0; Mul 259 97; Mul 494 93; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 499 95;
  Add 1 0; Add 0 9; Add 3 12; Mul 503 96; Add 1 0; Mul 97 505; Mul 506 80; Mul 273 80; Add 1 0;
  Mul 275 81; Add 1 0; Mul 277 82; Add 1 0; Mul 279 87; Mul 514 87; Add 1 0; Add 0 6; Add 0 5;
  Add 4 10; Mul 519 91; Add 1 0; Add 0 9; Add 3 12; Mul 523 94; Add 1 0; Add 12 295; Add 8 295;
  Add 5 295; Add 3 295; Mul 491 291; Neg 500; Neg 500; Mul 96 532; Mul 78 2; Add 1 0; Mul 61 3;
  Add 1 0; Mul 44 7; Add 1 0; Mul 98 539; Mul 80 9; Add 1 0; Mul 63 10; Add 1 0; Mul 46 14;
  Add 1 0; Mul 101 546; Mul 83 16; Add 1 0; Mul 66 17; Add 1 0; Mul 49 21; Add 1 0; Mul 105 553;
  Mul 87 23; Add 1 0; Mul 70 24; Add 1 0; Mul 53 28; Add 1 0; Mul 124 326; Mul 106 442; Add 1 0;
  Mul 89 440; Add 1 0; Mul 72 438; Add 1 0; Mul 126 333; Mul 108 449; Add 1 0; Mul 91 447;
  Add 1 0; Mul 74 445; Add 1 0; Mul 129 340; Mul 111 456; Add 1 0; Mul 94 454; Add 1 0;
  Mul 77 452; Add 1 0; Mul 133 347; Mul 115 463; Add 1 0; Mul 98 461; Add 1 0; Mul 81 459;
  Add 1 0; Add 21 62; Add 15 62; Add 9 62; Add 3 62; Div 592 53; Mul 4 0; Mul 0 48; Mul 1 42;
  Mul 2 36; Sub 7 2; Sub 7 2; Sub 7 2; Sub 550 366; Mul 0 363; Neg 556; Neg 556; Mul 149 1;
  Add 72 0; Mul 132 2; Add 1 0; Mul 115 6; Add 1 0; Mul 150 7; Add 71 0; Mul 133 8; Add 1 0;
  Mul 116 12; Add 1 0; Mul 152 13; Add 70 0; Mul 135 14; Add 1 0; Mul 118 18; Add 1 0; Mul 155 19;
  Add 69 0; Mul 138 20; Add 1 0; Mul 121 24; Add 1 0; Mul 122 524; Neg 100; Neg 104; Mul 21 1;
  Mul 16 105; Add 1 0; Mul 12 106; Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Div 639 29; Neg 24;
  Mul 0 1; Neg 20; Mul 0 3; Mul 5 4; Mul 47 3; Mul 47 2; Add 1 0; Add 0 48; Sub 4 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Neg 104; Mul 0 58; Neg 99; Mul 0 60; Mul 620 148; Mul 62 62; Mul 1 0; Sub 5 15; Sub 4 14;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 599 425; Neg 608; Neg 608; Mul 211 1; Add 134 0; Mul 194 2; Add 1 0; Mul 177 6; Add 1 0;
  Mul 212 7; Add 133 0; Mul 195 8; Add 1 0; Mul 178 12; Add 1 0; Mul 214 13; Add 132 0;
  Mul 197 14; Add 1 0; Mul 180 18; Add 1 0; Mul 217 19; Add 131 0; Mul 200 20; Add 1 0;
  Mul 183 24; Add 1 0; Mul 235 529; Add 130 0; Mul 218 527; Add 1 0; Mul 201 525; Add 1 0;
  Mul 236 535; Add 129 0; Mul 219 533; Add 1 0; Mul 202 531; Add 1 0; Mul 238 541; Add 128 0;
  Mul 221 539; Add 1 0; Mul 204 537; Add 1 0; Mul 241 547; Add 127 0; Mul 224 545; Add 1 0;
  Mul 207 543; Add 1 0; Add 18 188; Add 13 188; Add 8 188; Add 3 188; Div 718 46; Mul 4 0;
  Mul 0 42; Mul 1 37; Mul 2 32; Sub 7 2; Sub 7 2; Sub 7 2; Mul 2 84; Mul 2 83; Add 1 0; Add 0 3;
  Sub 85 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Neg 53; Mul 0 13; Neg 49; Mul 0 15; Mul 675 229; Mul 17 17; Mul 1 0; Sub 5 96; Sub 4 95;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 86 4; Mul 86 6; Sub 1 0;
  ShowZero 0; (* the images touch *)
  Sub 23 149; Sub 23 149; Mul 1 90; Mul 1 92; Sub 1 0;
  ShowZero 0; (* over the common tangent *)
  Sub 734 518; Sub 734 519; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 737; Div 758 0; Mul 6 0; Mul 6 1;
  Add 527 1; Add 528 1; Mul 165 1; Mul 165 1; Add 1 0; Add 0 166; Sub 0 0;
  ShowZero 0; (* through one point *)
  Mul 770 9; Sub 127 7; Sub 126 7; Mul 1 1; Mul 1 1; Add 1 0; Mul 5 5; Sub 1 0;
  ShowZero 0; (* on the vertex circle *)
  Sub 700 542; Mul 0 539; Neg 706; Neg 706; Mul 325 1; Add 248 0; Mul 308 2; Add 1 0; Mul 291 6;
  Add 1 0; Mul 326 7; Add 247 0; Mul 309 8; Add 1 0; Mul 292 12; Add 1 0; Mul 328 13; Add 246 0;
  Mul 311 14; Add 1 0; Mul 294 18; Add 1 0; Mul 331 19; Add 245 0; Mul 314 20; Add 1 0;
  Mul 297 24; Add 1 0; Mul 298 654; Mul 19 175; Mul 14 279; Add 1 0; Mul 10 280; Add 1 0;
  Mul 6 179; Add 1 0; Sub 7 0; Div 813 27; Neg 22; Mul 0 1; Neg 18; Mul 0 3; Mul 5 4; Mul 95 3;
  Mul 95 2; Add 1 0; Add 0 96; Sub 4 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Sub 91 8; Sub 90 7; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 91;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 740 592; Neg 749; Neg 749; Mul 378 1; Add 301 0; Mul 361 2; Add 1 0; Mul 344 6; Add 1 0;
  Mul 379 7; Add 300 0; Mul 362 8; Add 1 0; Mul 345 12; Add 1 0; Mul 381 13; Add 299 0;
  Mul 364 14; Add 1 0; Mul 347 18; Add 1 0; Mul 384 19; Add 298 0; Mul 367 20; Add 1 0;
  Mul 350 24; Add 1 0; Mul 402 658; Add 297 0; Mul 385 656; Add 1 0; Mul 368 654; Add 1 0;
  Mul 403 664; Add 296 0; Mul 386 662; Add 1 0; Mul 369 660; Add 1 0; Mul 405 670; Add 295 0;
  Mul 388 668; Add 1 0; Mul 371 666; Add 1 0; Mul 408 676; Add 294 0; Mul 391 674; Add 1 0;
  Mul 374 672; Add 1 0; Add 18 355; Add 13 355; Add 8 355; Add 3 355; Div 885 46; Mul 4 0;
  Mul 0 42; Mul 1 37; Mul 2 32; Sub 7 2; Sub 7 2; Sub 7 2; Mul 2 77; Mul 2 76; Add 1 0; Add 0 3;
  Sub 78 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Neg 53; Mul 0 13; Neg 49; Mul 0 15; Mul 816 396; Mul 17 17; Mul 1 0; Sub 5 89; Sub 4 88;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 86 4; Mul 86 6; Sub 1 0;
  ShowZero 0; (* the images touch *)
  Sub 23 190; Sub 23 190; Mul 1 90; Mul 1 92; Sub 1 0;
  ShowZero 0; (* over the common tangent *)
  Mul 195 157; Mul 195 157; Add 1 0; Add 0 196; Sub 0 156;
  ShowZero 0; (* through one point *)
  Sub 108 162; Sub 107 162; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 154;
  ShowZero 0; (* on the vertex circle *)
  Sub 828 696; Mul 0 693; Neg 834; Neg 834; Mul 479 1; Add 402 0; Mul 462 2; Add 1 0; Mul 445 6;
  Add 1 0; Mul 480 7; Add 401 0; Mul 463 8; Add 1 0; Mul 446 12; Add 1 0; Mul 482 13; Add 400 0;
  Mul 465 14; Add 1 0; Mul 448 18; Add 1 0; Mul 485 19; Add 399 0; Mul 468 20; Add 1 0;
  Mul 451 24; Add 1 0; Mul 452 853; Mul 19 329; Mul 14 433; Add 1 0; Mul 10 434; Add 1 0;
  Mul 6 333; Add 1 0; Sub 7 0; Div 967 27; Neg 22; Mul 0 1; Neg 18; Mul 0 3; Mul 5 4; Mul 82 3;
  Mul 82 2; Add 1 0; Add 0 83; Sub 4 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Sub 78 8; Sub 77 7; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 78;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 386 14; Mul 386 13; Add 1 0; Add 0 387; Sub 15 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Sub 337 19; Sub 336 18; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 337;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 16 4; Mul 16 6; Sub 1 0;
  ShowZero 0; (* the images touch *)
  Sub 400 107; Sub 400 107; Mul 1 20; Mul 1 22; Sub 1 0;
  ShowZero 0; (* over the common tangent *)
  Mul 112 241; Mul 112 241; Add 1 0; Add 0 113; Sub 0 240;
  ShowZero 0; (* through one point *)
  Sub 38 246; Sub 37 246; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 238;
  ShowZero 0 (* on the vertex circle *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the incircles around a vertex; size 4.
    Code: src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs, src/space/moebius.rs,
    src/space/motion.rs, src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs,
    src/space/similarity.rs, src/space/sphere.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the vertex circle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 6 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 7 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 6 0; Add 10 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 8 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 13 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 4; Mul 6 0; Add 16 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 8 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 19 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 5 21; Add 21 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 7 23;
  Nonzero 0; (* no edges agree *)
  Unknown 5; Unknown 6; Mul 27 27; Mul 2 2; Mul 2 2; Add 1 0; Sub 0 3;
  Nonzero 0; (* no vertex circle passes through the centre *)
  Div 32 8; Sub 31 10; Mul 0 1; Add 18 34; Mul 0 3; Add 11 2; Add 11 1; Sub 38 22; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 44 42; Sub 45 44; Mul 0 1; Mul 48 50; Mul 0 3; Mul 2 51; Mul 1 52; Add 27 1; Add 27 1;
  Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 58 51; Sub 57 53; Mul 0 1; Add 60 56; Mul 0 3; Add 37 2; Add 37 1; Sub 60 64; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 70 62; Sub 71 64; Mul 0 1; Mul 70 76; Mul 0 3; Mul 2 77; Mul 1 78; Add 53 1; Add 53 1;
  Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 84 71; Sub 83 73; Mul 0 1; Add 82 76; Mul 0 3; Add 63 2; Add 63 1; Sub 80 86; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 96 82; Sub 97 84; Mul 0 1; Mul 90 102; Mul 0 3; Mul 2 103; Mul 1 104; Add 79 1; Add 79 1;
  Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 110 91; Sub 109 93; Mul 0 1; Add 102 96; Mul 0 3; Add 89 2; Add 89 1; Sub 100 106; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3;
  Nonzero 0; (* no incircle passes through the centre *)
  Div 122 102; Sub 123 104; Mul 0 1; Mul 110 128; Mul 0 3; Mul 2 129; Mul 1 130; Add 105 1;
  Add 105 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no incircle passes through the centre *)
  ShowNonzero 134; (* as src/space/sphere.rs finds *)
  Unknown 7; Unknown 8; Unknown 9; Sub 7 113; Sub 7 113; Sub 2 4; Sub 88 116; Sub 88 116; Sub 6 7;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 146 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 131; Mul 1 131; Add 1 0; Sub 23 0; Mul 8 29; Mul 5 29; Add 1 0; Add 0 3;
  Sub 26 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 128 34; Sub 128 34; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 129;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 118; Mul 16 118; Add 1 0; Add 0 14; Sub 38 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 139 123; Sub 139 123; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 140;
  ShowZero 0; (* the contact is on the incircle *)
  Unknown 10; Sub 104 158; Sub 104 158; Sub 2 49; Mul 44 1; Mul 44 3; Sub 1 0; Div 188 0;
  Mul 46 5; Mul 48 5; Sub 1 0; Mul 0 3; Mul 52 8; Mul 51 11; Sub 1 0; Mul 0 7; Mul 4 173;
  Mul 1 173; Add 1 0; Sub 65 0; Mul 8 149; Mul 5 149; Add 1 0; Add 0 3; Sub 69 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 144 154; Sub 144 154; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 145;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 134; Mul 16 134; Add 1 0; Add 0 14; Sub 34 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 155 139; Sub 155 139; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 156;
  ShowZero 0; (* the contact is on the incircle *)
  Unknown 11; Sub 120 200; Sub 120 200; Sub 2 91; Mul 44 1; Mul 44 3; Sub 1 0; Div 230 0;
  Mul 46 5; Mul 48 5; Sub 1 0; Mul 0 3; Mul 52 8; Mul 51 11; Sub 1 0; Mul 0 7; Mul 4 215;
  Mul 1 215; Add 1 0; Sub 107 0; Mul 8 165; Mul 5 165; Add 1 0; Add 0 3; Sub 65 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 160 170; Sub 160 170; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 161;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 150; Mul 16 150; Add 1 0; Add 0 14; Sub 34 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 171 155; Sub 171 155; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 172;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 40 126; Mul 40 128; Sub 1 0; Div 268 0; Mul 42 130; Mul 44 130; Sub 1 0; Mul 0 3;
  Mul 48 133; Mul 47 136; Sub 1 0; Mul 0 7; Mul 4 253; Mul 1 253; Add 1 0; Sub 145 0; Mul 8 177;
  Mul 5 177; Add 1 0; Add 0 3; Sub 61 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 172 182; Sub 172 182; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 173;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 162; Mul 16 162; Add 1 0; Add 0 14; Sub 159 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 183 167; Sub 183 167; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 184;
  ShowZero 0; (* the contact is on the incircle *)
  Unknown 12; Unknown 13; Unknown 14; Unknown 15; Constant 0; Mul 0 0; Add 0 0; Sub 0 310;
  Div 311 314; Mul 1 0; Neg 5; Div 317 314; Sub 7 7; Neg 3; Neg 317; Mul 2 1; Mul 3 5; Add 1 0;
  Add 0 1; Mul 6 4; Add 1 0; Mul 0 9; Mul 0 325; Sub 10 0; Add 0 19; Mul 3 14; Sub 13 0; Add 0 22;
  Mul 6 18; Sub 16 0; Add 0 25; Sub 334 26; Mul 0 18; Add 0 16; Add 0 17; Add 0 15; Mul 0 24;
  Mul 0 340; Sub 6 0; Add 0 34; Mul 3 29; Sub 28 0; Add 0 37; Mul 6 33; Sub 31 0; Add 0 40;
  Sub 6 21; Sub 4 19; Sub 2 17; Mul 17 38; Add 34 0; Add 0 34; Add 0 32; Mul 0 41; Mul 0 357;
  Sub 42 0; Add 0 51; Mul 3 46; Sub 26 0; Add 0 54; Sub 47 2; Add 0 56; Mul 8 52; Sub 50 0;
  Add 0 59; Sub 8 40; Sub 6 38; Sub 5 39; Sub 3 37; Add 51 19; Add 0 50; Mul 0 59; Mul 0 375;
  Sub 60 0; Add 0 69; Mul 3 64; Sub 63 0; Add 0 72; Sub 46 2; Add 0 74; Mul 8 70; Sub 68 0;
  Add 0 77; Sub 8 58; Sub 6 56; Sub 5 57; Sub 3 55; Mul 55 72; Add 69 0; Mul 0 77; Mul 0 393;
  Sub 78 0; Add 0 87; Mul 3 82; Sub 81 0; Add 0 90; Mul 6 86; Sub 65 0; Add 0 93; Sub 6 74;
  Sub 4 72; Sub 2 70; Add 101 101; Add 101 101; Add 101 101; Add 101 101; Mul 91 59; Mul 96 59;
  Add 1 0; Add 0 1; Mul 99 61; Add 1 0; Mul 101 65; Mul 98 65; Add 1 0; Add 0 7; Add 0 5; Add 4 9;
  Add 0 4; Add 0 8; Add 2 12; Mul 106 72; Add 1 0; Mul 108 57; Mul 113 57; Add 1 0; Mul 115 58;
  Add 1 0; Mul 117 59; Add 1 0; Mul 119 64; Mul 116 64; Add 1 0; Add 0 6; Add 0 5; Add 4 10;
  Mul 121 68; Add 1 0; Add 0 9; Add 3 12; Mul 125 71; Add 1 0; Mul 127 58; Mul 132 58; Add 1 0;
  Mul 134 59; Add 1 0; Mul 136 60; Add 1 0; Mul 138 65; Mul 135 65; Add 1 0; Add 0 6; Add 0 5;
  Add 4 10; Mul 140 69; Add 1 0; Add 0 9; Add 3 12; Mul 144 72; Add 1 0; Mul 146 61; Mul 151 61;
  Add 1 0; Add 0 1; Mul 154 63; Add 1 0; Mul 156 67; Mul 153 67; Add 1 0; Add 0 7; Add 0 5;
  Add 4 9; Add 0 4; Add 0 8; Add 2 12; Mul 161 74; Add 1 0; Mul 481 481; Mul 164 154; Mul 169 152;
  Add 1 0; Add 0 1; Mul 172 152; Add 1 0; Mul 174 160; Mul 171 158; Add 1 0; Add 0 7; Add 0 5;
  Add 4 9; Add 0 4; Add 0 8; Add 2 12; Mul 179 163; Add 1 0; Add 11 93; Add 7 93; Add 5 93;
  Add 3 93; Mul 503 88; Mul 196 84; Add 1 0; Mul 198 83; Add 1 0; Mul 200 82; Add 1 0; Mul 202 95;
  Mul 511 91; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 516 93; Add 1 0; Add 0 9; Add 3 12;
  Mul 520 94; Add 1 0; Mul 522 89; Mul 215 85; Add 1 0; Mul 217 83; Add 1 0; Mul 219 82; Add 1 0;
  Mul 221 96; Mul 530 92; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 535 93; Add 1 0; Add 0 9;
  Add 3 12; Mul 539 94; Add 1 0; Mul 541 89; Mul 234 85; Add 1 0; Mul 236 83; Add 1 0; Mul 238 82;
  Add 1 0; Mul 240 96; Mul 549 92; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 554 93; Add 1 0;
  Add 0 9; Add 3 12; Mul 558 94; Add 1 0; Mul 560 90; Mul 253 86; Add 1 0; Mul 255 85; Add 1 0;
  Mul 257 84; Add 1 0; Mul 259 97; Mul 568 93; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 573 95;
  Add 1 0; Add 0 9; Add 3 12; Mul 577 96; Add 1 0; Mul 97 579; Mul 580 80; Mul 273 80; Add 1 0;
  Mul 275 81; Add 1 0; Mul 277 82; Add 1 0; Mul 279 87; Mul 588 87; Add 1 0; Add 0 6; Add 0 5;
  Add 4 10; Mul 593 91; Add 1 0; Add 0 9; Add 3 12; Mul 597 94; Add 1 0; Add 12 295; Add 8 295;
  Add 5 295; Add 3 295; Mul 559 291; Neg 568; Neg 568; Mul 96 606; Mul 78 2; Add 1 0; Mul 61 3;
  Add 1 0; Mul 44 7; Add 1 0; Mul 98 613; Mul 80 9; Add 1 0; Mul 63 10; Add 1 0; Mul 46 14;
  Add 1 0; Mul 101 620; Mul 83 16; Add 1 0; Mul 66 17; Add 1 0; Mul 49 21; Add 1 0; Mul 105 627;
  Mul 87 23; Add 1 0; Mul 70 24; Add 1 0; Mul 53 28; Add 1 0; Mul 124 326; Mul 106 484; Add 1 0;
  Mul 89 482; Add 1 0; Mul 72 480; Add 1 0; Mul 126 333; Mul 108 491; Add 1 0; Mul 91 489;
  Add 1 0; Mul 74 487; Add 1 0; Mul 129 340; Mul 111 498; Add 1 0; Mul 94 496; Add 1 0;
  Mul 77 494; Add 1 0; Mul 133 347; Mul 115 505; Add 1 0; Mul 98 503; Add 1 0; Mul 81 501;
  Add 1 0; Add 21 62; Add 15 62; Add 9 62; Add 3 62; Div 666 53; Mul 4 0; Mul 0 48; Mul 1 42;
  Mul 2 36; Sub 7 2; Sub 7 2; Sub 7 2; Sub 618 366; Mul 0 363; Neg 624; Neg 624; Mul 149 1;
  Add 72 0; Mul 132 2; Add 1 0; Mul 115 6; Add 1 0; Mul 150 7; Add 71 0; Mul 133 8; Add 1 0;
  Mul 116 12; Add 1 0; Mul 152 13; Add 70 0; Mul 135 14; Add 1 0; Mul 118 18; Add 1 0; Mul 155 19;
  Add 69 0; Mul 138 20; Add 1 0; Mul 121 24; Add 1 0; Mul 122 566; Neg 100; Neg 104; Mul 21 1;
  Mul 16 105; Add 1 0; Mul 12 106; Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Div 713 29; Neg 24;
  Mul 0 1; Neg 20; Mul 0 3; Mul 5 4; Mul 47 3; Mul 47 2; Add 1 0; Add 0 48; Sub 4 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Neg 104; Mul 0 58; Neg 99; Mul 0 60; Mul 688 148; Mul 62 62; Mul 1 0; Sub 5 15; Sub 4 14;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 667 425; Neg 676; Neg 676; Mul 211 1; Add 134 0; Mul 194 2; Add 1 0; Mul 177 6; Add 1 0;
  Mul 212 7; Add 133 0; Mul 195 8; Add 1 0; Mul 178 12; Add 1 0; Mul 214 13; Add 132 0;
  Mul 197 14; Add 1 0; Mul 180 18; Add 1 0; Mul 217 19; Add 131 0; Mul 200 20; Add 1 0;
  Mul 183 24; Add 1 0; Mul 235 571; Add 130 0; Mul 218 569; Add 1 0; Mul 201 567; Add 1 0;
  Mul 236 577; Add 129 0; Mul 219 575; Add 1 0; Mul 202 573; Add 1 0; Mul 238 583; Add 128 0;
  Mul 221 581; Add 1 0; Mul 204 579; Add 1 0; Mul 241 589; Add 127 0; Mul 224 587; Add 1 0;
  Mul 207 585; Add 1 0; Add 18 188; Add 13 188; Add 8 188; Add 3 188; Div 792 46; Mul 4 0;
  Mul 0 42; Mul 1 37; Mul 2 32; Sub 7 2; Sub 7 2; Sub 7 2; Mul 2 84; Mul 2 83; Add 1 0; Add 0 3;
  Sub 85 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Neg 53; Mul 0 13; Neg 49; Mul 0 15; Mul 743 229; Mul 17 17; Mul 1 0; Sub 5 96; Sub 4 95;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 86 4; Mul 86 6; Sub 1 0;
  ShowZero 0; (* the images touch *)
  Sub 23 149; Sub 23 149; Mul 1 90; Mul 1 92; Sub 1 0;
  ShowZero 0; (* over the common tangent *)
  Sub 802 518; Sub 802 519; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 805; Div 832 0; Mul 6 0; Mul 6 1;
  Add 527 1; Add 528 1; Mul 165 1; Mul 165 1; Add 1 0; Add 0 166; Sub 0 0;
  ShowZero 0; (* through one point *)
  Mul 844 9; Sub 127 7; Sub 126 7; Mul 1 1; Mul 1 1; Add 1 0; Mul 5 5; Sub 1 0;
  ShowZero 0; (* on the vertex circle *)
  Sub 768 542; Mul 0 539; Neg 774; Neg 774; Mul 325 1; Add 248 0; Mul 308 2; Add 1 0; Mul 291 6;
  Add 1 0; Mul 326 7; Add 247 0; Mul 309 8; Add 1 0; Mul 292 12; Add 1 0; Mul 328 13; Add 246 0;
  Mul 311 14; Add 1 0; Mul 294 18; Add 1 0; Mul 331 19; Add 245 0; Mul 314 20; Add 1 0;
  Mul 297 24; Add 1 0; Mul 298 696; Mul 19 175; Mul 14 279; Add 1 0; Mul 10 280; Add 1 0;
  Mul 6 179; Add 1 0; Sub 7 0; Div 887 27; Neg 22; Mul 0 1; Neg 18; Mul 0 3; Mul 5 4; Mul 95 3;
  Mul 95 2; Add 1 0; Add 0 96; Sub 4 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Sub 91 8; Sub 90 7; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 91;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 808 592; Neg 817; Neg 817; Mul 378 1; Add 301 0; Mul 361 2; Add 1 0; Mul 344 6; Add 1 0;
  Mul 379 7; Add 300 0; Mul 362 8; Add 1 0; Mul 345 12; Add 1 0; Mul 381 13; Add 299 0;
  Mul 364 14; Add 1 0; Mul 347 18; Add 1 0; Mul 384 19; Add 298 0; Mul 367 20; Add 1 0;
  Mul 350 24; Add 1 0; Mul 402 696; Add 297 0; Mul 385 694; Add 1 0; Mul 368 692; Add 1 0;
  Mul 403 702; Add 296 0; Mul 386 700; Add 1 0; Mul 369 698; Add 1 0; Mul 405 708; Add 295 0;
  Mul 388 706; Add 1 0; Mul 371 704; Add 1 0; Mul 408 714; Add 294 0; Mul 391 712; Add 1 0;
  Mul 374 710; Add 1 0; Add 18 355; Add 13 355; Add 8 355; Add 3 355; Div 959 46; Mul 4 0;
  Mul 0 42; Mul 1 37; Mul 2 32; Sub 7 2; Sub 7 2; Sub 7 2; Mul 2 77; Mul 2 76; Add 1 0; Add 0 3;
  Sub 78 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Neg 53; Mul 0 13; Neg 49; Mul 0 15; Mul 884 396; Mul 17 17; Mul 1 0; Sub 5 89; Sub 4 88;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 86 4; Mul 86 6; Sub 1 0;
  ShowZero 0; (* the images touch *)
  Sub 23 190; Sub 23 190; Mul 1 90; Mul 1 92; Sub 1 0;
  ShowZero 0; (* over the common tangent *)
  Mul 195 157; Mul 195 157; Add 1 0; Add 0 196; Sub 0 156;
  ShowZero 0; (* through one point *)
  Sub 108 162; Sub 107 162; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 154;
  ShowZero 0; (* on the vertex circle *)
  Sub 896 696; Mul 0 693; Neg 902; Neg 902; Mul 479 1; Add 402 0; Mul 462 2; Add 1 0; Mul 445 6;
  Add 1 0; Mul 480 7; Add 401 0; Mul 463 8; Add 1 0; Mul 446 12; Add 1 0; Mul 482 13; Add 400 0;
  Mul 465 14; Add 1 0; Mul 448 18; Add 1 0; Mul 485 19; Add 399 0; Mul 468 20; Add 1 0;
  Mul 451 24; Add 1 0; Mul 452 808; Mul 19 329; Mul 14 433; Add 1 0; Mul 10 434; Add 1 0;
  Mul 6 333; Add 1 0; Sub 7 0; Div 1041 27; Neg 22; Mul 0 1; Neg 18; Mul 0 3; Mul 5 4; Mul 82 3;
  Mul 82 2; Add 1 0; Add 0 83; Sub 4 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Sub 78 8; Sub 77 7; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 78;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 936 746; Neg 945; Neg 945; Mul 532 1; Add 455 0; Mul 515 2; Add 1 0; Mul 498 6; Add 1 0;
  Mul 533 7; Add 454 0; Mul 516 8; Add 1 0; Mul 499 12; Add 1 0; Mul 535 13; Add 453 0;
  Mul 518 14; Add 1 0; Mul 501 18; Add 1 0; Mul 538 19; Add 452 0; Mul 521 20; Add 1 0;
  Mul 504 24; Add 1 0; Mul 556 812; Add 451 0; Mul 539 810; Add 1 0; Mul 522 808; Add 1 0;
  Mul 557 818; Add 450 0; Mul 540 816; Add 1 0; Mul 523 814; Add 1 0; Mul 559 824; Add 449 0;
  Mul 542 822; Add 1 0; Mul 525 820; Add 1 0; Mul 562 830; Add 448 0; Mul 545 828; Add 1 0;
  Mul 528 826; Add 1 0; Add 18 509; Add 13 509; Add 8 509; Add 3 509; Div 1113 46; Mul 4 0;
  Mul 0 42; Mul 1 37; Mul 2 32; Sub 7 2; Sub 7 2; Sub 7 2; Mul 2 77; Mul 2 76; Add 1 0; Add 0 3;
  Sub 78 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Neg 53; Mul 0 13; Neg 49; Mul 0 15; Mul 1012 550; Mul 17 17; Mul 1 0; Sub 5 89; Sub 4 88;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 86 4; Mul 86 6; Sub 1 0;
  ShowZero 0; (* the images touch *)
  Sub 23 177; Sub 23 177; Mul 1 90; Mul 1 92; Sub 1 0;
  ShowZero 0; (* over the common tangent *)
  Mul 182 311; Mul 182 311; Add 1 0; Add 0 183; Sub 0 310;
  ShowZero 0; (* through one point *)
  Sub 108 316; Sub 107 316; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 308;
  ShowZero 0; (* on the vertex circle *)
  Sub 1024 850; Mul 0 847; Neg 1030; Neg 1030; Mul 633 1; Add 556 0; Mul 616 2; Add 1 0;
  Mul 599 6; Add 1 0; Mul 634 7; Add 555 0; Mul 617 8; Add 1 0; Mul 600 12; Add 1 0; Mul 636 13;
  Add 554 0; Mul 619 14; Add 1 0; Mul 602 18; Add 1 0; Mul 639 19; Add 553 0; Mul 622 20; Add 1 0;
  Mul 605 24; Add 1 0; Mul 606 1049; Mul 19 483; Mul 14 587; Add 1 0; Mul 10 588; Add 1 0;
  Mul 6 487; Add 1 0; Sub 7 0; Div 1195 27; Neg 22; Mul 0 1; Neg 18; Mul 0 3; Mul 5 4; Mul 82 3;
  Mul 82 2; Add 1 0; Add 0 83; Sub 4 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Sub 78 8; Sub 77 7; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 78;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 540 14; Mul 540 13; Add 1 0; Add 0 541; Sub 15 0;
  ShowZero 0; (* the contact is in the image of the plane *)
  Sub 491 19; Sub 490 18; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 491;
  ShowZero 0; (* the contact is on the image of the incircle *)
  Mul 16 4; Mul 16 6; Sub 1 0;
  ShowZero 0; (* the images touch *)
  Sub 554 107; Sub 554 107; Mul 1 20; Mul 1 22; Sub 1 0;
  ShowZero 0; (* over the common tangent *)
  Mul 112 395; Mul 112 395; Add 1 0; Add 0 113; Sub 0 394;
  ShowZero 0; (* through one point *)
  Sub 38 400; Sub 37 400; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 392;
  ShowZero 0 (* on the vertex circle *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
