(** fig-8-planar-lines (Sec. 4, Fig. 8)

    In the i-minimal meshes from the square grid, its inversions, rotational Koebe meshes and
    theirs, and in these Koebe meshes, all row and column polygons are planar.

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the Enneper surface; size 1.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/minimal/enneper.rs, src/construct/packing.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
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
  Sub 24 4; Mul 0 0; Add 0 17; Sub 0 16;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 26 25; Sub 29 0; Mul 0 0; Add 0 14; Sub 0 21;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 7 11; Sub 0 23;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 37 31; Sub 36 0; Mul 0 0; Add 0 29; Sub 0 28;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 42 37; Sub 41 0; Mul 0 0; Add 0 26; Sub 0 33;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 7 23; Sub 0 35;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 48 43; Sub 48 0; Mul 0 0; Add 0 41; Sub 0 40;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 2 30; Sub 0 42;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Constant 4; Div 53 0; Sub 43 56; Sub 44 56; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 33 62; Mul 0 0; Add 0 4; Sub 0 9;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 25 66; Mul 0 0; Add 0 8; Sub 0 13;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Div 68 71; Constant 12; Div 70 0; Sub 69 73; Sub 70 73; Mul 1 1; Mul 1 1; Mul 1 6; Sub 1 0;
  Add 0 6; Mul 6 0; Mul 4 10; Sub 0 6; Sub 0 10; Mul 9 0; Mul 85 4; Mul 85 1; Add 1 0; Sub 11 12;
  Mul 0 86; Add 0 2; Sub 89 91; Mul 0 0; Mul 0 22; Sub 17 0; Add 0 22; Mul 4 0; Sub 15 4;
  Sub 0 25; Mul 24 0; Mul 100 3; Mul 100 1; Add 1 0; Sub 26 10; Mul 0 101; Add 0 2; Sub 104 105;
  Mul 0 0; Sub 0 14; Add 0 36; Mul 18 0; Mul 3 40; Sub 0 19; Sub 0 40; Mul 7 0; Mul 115 4;
  Mul 115 1; Add 1 0; Sub 10 25; Mul 0 116; Add 0 2; Sub 24 40; Sub 22 37; Sub 17 32; Sub 13 43;
  Sub 10 40; Sub 5 35; Mul 5 1; Mul 5 3; Sub 1 0; Div 128 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 58; Mul 1 55; Add 1 0; Sub 51 0; Add 1 0; Sub 53 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 48; Mul 7 46; Add 1 0; Add 0 5; Sub 43 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 77; Add 0 83; Mul 83 0; Sub 46 82; Sub 0 86; Mul 53 0; Mul 161 3; Mul 161 1; Add 1 0;
  Sub 56 88; Mul 0 162; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 96 95; Sub 0 117; Div 172 0; Mul 101 0; Mul 101 1; Add 177 1; Add 177 1; Mul 4 176;
  Add 87 103; Sub 0 125; Div 180 0; Mul 91 0; Mul 109 1; Add 185 1; Add 185 1; Mul 4 184;
  Mul 10 10; Mul 10 10; Add 1 0; Mul 11 11; Sub 1 0; Mul 0 190; Mul 8 8; Mul 8 8; Add 1 0;
  Mul 9 9; Sub 1 0; Mul 0 196; Mul 65 22; Mul 62 22; Add 1 0; Sub 9 0; Mul 69 18; Mul 66 18;
  Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 116 101; Sub 0 154; Div 209 0; Mul 120 0; Mul 106 1; Add 214 1; Add 214 1; Mul 4 213;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 219; Mul 88 8; Mul 85 8; Add 1 0; Add 0 22;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 152 120; Sub 0 173; Div 228 0; Mul 157 0; Mul 125 1; Add 233 1; Add 233 1; Mul 4 232;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 238; Mul 107 8; Mul 104 8; Add 1 0; Add 0 41;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 249 247; Mul 0 0; Mul 0 178; Sub 173 0; Add 0 178; Mul 4 0; Sub 171 4; Sub 0 181; Mul 180 0;
  Mul 256 3; Mul 256 1; Add 1 0; Sub 182 10; Mul 0 257; Add 0 2; Sub 154 12; Add 0 190; Mul 16 0;
  Sub 153 16; Sub 0 193; Mul 160 0; Mul 268 3; Mul 268 1; Add 1 0; Sub 163 22; Mul 0 269; Add 0 2;
  Sub 21 177; Sub 19 175; Sub 14 170; Sub 12 180; Sub 10 178; Sub 5 173; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 281 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 195; Mul 1 193; Add 1 0; Sub 189 0; Add 1 0; Sub 191 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 45; Mul 7 43; Add 1 0; Add 0 5; Sub 40 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 197; Mul 17 194; Add 1 0; Add 0 15; Sub 191 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 64 236; Sub 0 258; Div 313 0; Mul 68 0; Mul 242 1; Add 318 1; Add 318 1; Mul 4 317; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 323; Mul 39 141; Mul 36 141; Add 1 0; Sub 130 0;
  Mul 43 12; Mul 40 12; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 87 228; Sub 0 281; Div 336 0; Mul 91 0; Mul 233 1; Add 341 1; Add 341 1; Mul 4 340; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 346; Mul 62 8; Mul 59 8; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 67 140; Mul 64 140; Add 1 0; Add 0 27; Sub 136 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 361 360; Mul 0 0; Mul 0 291; Sub 286 0; Add 0 291; Mul 4 0; Sub 284 4; Sub 0 294; Mul 293 0;
  Mul 369 3; Mul 369 1; Add 1 0; Sub 295 10; Mul 0 370; Add 0 2; Sub 267 12; Add 0 303; Mul 16 0;
  Sub 266 16; Sub 0 306; Mul 273 0; Mul 381 3; Mul 381 1; Add 1 0; Sub 276 22; Mul 0 382; Add 0 2;
  Sub 21 134; Sub 19 132; Sub 14 127; Sub 12 137; Sub 10 135; Sub 5 130; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 394 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 152; Mul 1 150; Add 1 0; Sub 146 0; Add 1 0; Sub 148 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 45; Mul 7 43; Add 1 0; Add 0 5; Sub 40 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 156; Mul 17 154; Add 1 0; Add 0 15; Sub 151 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 64 349; Sub 0 371; Div 426 0; Mul 68 0; Mul 355 1; Add 431 1; Add 431 1; Mul 4 430; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 436; Mul 39 121; Mul 36 121; Add 1 0; Sub 116 0;
  Mul 43 12; Mul 40 12; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 87 341; Sub 0 394; Div 449 0; Mul 91 0; Mul 346 1; Add 454 1; Add 454 1; Mul 4 453; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 459; Mul 62 8; Mul 59 8; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 67 126; Mul 64 126; Add 1 0; Add 0 27; Sub 122 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Div 471 293; Div 472 238; Div 473 287; Div 474 259; Sub 291 299; Mul 4 2; Mul 1 0; Add 476 0;
  Sub 266 295; Mul 6 5; Neg 0; Mul 2 0; Add 4 0; Sub 252 271; Mul 10 12; Mul 1 0; Add 3 0;
  Sub 312 256; Mul 16 17; Neg 0; Mul 2 0; Add 4 0; Sub 0 491;
  ShowZero 0; (* as a test finds *)
  Sub 309 317; Mul 0 18; Add 494 0; Sub 283 312; Mul 0 16; Add 2 0; Sub 267 286; Mul 0 15;
  Add 2 0; Sub 326 270; Mul 0 13; Add 2 0; Sub 0 504;
  ShowZero 0; (* as a test finds *)
  Sub 309 315; Mul 0 31; Add 507 0; Sub 289 312; Mul 0 29; Add 2 0; Sub 273 292; Mul 0 28;
  Add 2 0; Sub 324 276; Mul 0 26; Add 2 0; Sub 0 517;
  ShowZero 0; (* as a test finds *)
  Div 520 201; Div 521 179; Sub 205 338; Mul 49 2; Mul 1 0; Add 523 0; Sub 186 209; Mul 6 5;
  Neg 0; Mul 2 0; Add 4 0; Sub 318 191; Mul 10 57; Mul 1 0; Add 3 0; Sub 351 322; Mul 61 62;
  Neg 0; Mul 2 0; Add 4 0; Sub 0 538;
  ShowZero 0; (* as a test finds *)
  Sub 223 356; Mul 0 18; Add 541 0; Sub 203 226; Mul 0 16; Add 2 0; Sub 333 206; Mul 0 15;
  Add 2 0; Sub 365 336; Mul 0 13; Add 2 0; Sub 0 551;
  ShowZero 0; (* as a test finds *)
  Sub 229 356; Mul 0 31; Add 554 0; Sub 209 232; Mul 0 29; Add 2 0; Sub 339 212; Mul 0 28;
  Add 2 0; Sub 365 342; Mul 0 26; Add 2 0; Sub 0 564;
  ShowZero 0; (* as a test finds *)
  Div 567 135; Div 568 113; Sub 139 252; Mul 49 2; Mul 1 0; Add 570 0; Sub 120 143; Mul 6 5;
  Neg 0; Mul 2 0; Add 4 0; Sub 238 125; Mul 10 57; Mul 1 0; Add 3 0; Sub 265 242; Mul 61 62;
  Neg 0; Mul 2 0; Add 4 0; Sub 0 585;
  ShowZero 0; (* as a test finds *)
  Sub 157 270; Mul 0 18; Add 588 0; Sub 137 160; Mul 0 16; Add 2 0; Sub 253 140; Mul 0 15;
  Add 2 0; Sub 279 256; Mul 0 13; Add 2 0; Sub 0 598;
  ShowZero 0; (* as a test finds *)
  Sub 163 276; Mul 0 31; Add 601 0; Sub 143 166; Mul 0 29; Add 2 0; Sub 259 146; Mul 0 28;
  Add 2 0; Sub 285 262; Mul 0 26; Add 2 0; Sub 0 611;
  ShowZero 0; (* as a test finds *)
  Sub 135 135;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 118 118;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 106 106;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 133 133;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 118 118;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 106 106;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 618 128; Sub 133 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 620 117; Sub 120 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 622 106; Sub 109 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 134; Sub 0 625;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 123; Sub 0 627;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 112; Sub 0 629;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 153 107; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 137 91; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 126 80; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 154 104; Add 6 109; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 141 92; Add 7 96; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 131 82; Add 8 86; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 113; Sub 0 164;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 100; Sub 0 150;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 89; Sub 0 139;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 81; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 65; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 54; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 78; Add 6 83; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 66; Add 7 70; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 56; Add 8 60; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 87; Sub 0 30;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 74; Sub 0 29;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 63; Sub 0 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 195 672; Sub 178 673; Sub 463 500; Sub 463 500; Sub 194 676; Sub 179 677; Mul 204 0;
  Mul 186 2; Sub 1 0; Add 681 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 456 512; Sub 456 512;
  Sub 69 688; Sub 68 689; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 67 221; Sub 66 204; Sub 362 518; Sub 362 518; Sub 65 225; Sub 63 208; Mul 183 0; Mul 165 2;
  Sub 1 0; Add 707 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 230 235; Sub 215 218; Mul 13 0;
  Mul 13 2; Sub 1 0; Add 5 0; Mul 15 222; Mul 15 241; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 70 91; Sub 69 90; Sub 273 409; Sub 273 409; Sub 68 95; Sub 66 94; Mul 160 0; Mul 142 2;
  Sub 1 0; Add 731 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 99 105; Sub 97 104; Mul 13 0;
  Mul 13 2; Sub 1 0; Add 5 0; Mul 15 199; Mul 15 218; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 497 669; Sub 495 666; Sub 490 661; Sub 387 672; Sub 385 669; Sub 380 664; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 643 6; Mul 643 4; Add 1 0;
  Mul 644 3; Add 1 0;
  ShowZero 0; (* column *)
  Sub 659 612; Sub 656 610; Sub 651 605; Sub 508 615; Sub 506 613; Sub 501 608; Sub 398 618;
  Sub 396 616; Sub 391 611; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* column *)
  Sub 474 615; Sub 474 615; Sub 468 601; Sub 364 618; Sub 364 618; Sub 358 604; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 330 6; Mul 312 4; Add 1 0;
  Mul 301 3; Add 1 0;
  ShowZero 0; (* column *)
  Sub 598 579; Sub 598 579; Sub 592 573; Sub 474 582; Sub 474 582; Sub 468 576; Sub 364 585;
  Sub 364 585; Sub 358 579; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* column *)
  Mul 714 156; Mul 714 158; Sub 1 0; Mul 361 713; Mul 343 715; Sub 1 0; Add 3 0; Add 839 0;
  Sub 686 763; Sub 684 760; Mul 721 154; Mul 721 156; Sub 1 0; Mul 170 3; Mul 170 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 798;
  ShowZero 0; (* area(F, S) *)
  Mul 580 149; Mul 580 151; Sub 1 0; Mul 333 579; Mul 315 581; Sub 1 0; Add 3 0; Add 858 0;
  Sub 752 766; Sub 749 764; Mul 587 365; Mul 587 384; Sub 1 0; Mul 163 3; Mul 163 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 817;
  ShowZero 0; (* area(F, S) *)
  Mul 486 144; Mul 486 146; Sub 1 0; Mul 305 485; Mul 287 487; Sub 1 0; Add 3 0; Add 877 0;
  Sub 617 629; Sub 615 627; Mul 493 337; Mul 493 356; Sub 1 0; Mul 158 3; Mul 158 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 836;
  ShowZero 0; (* area(F, S) *)
  Sub 812 812; Sub 890 890; Mul 0 839; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 812 812; Sub 0 2;
  ShowZero 0; (* the Christoffel dual *)
  Sub 808 808; Sub 0 4;
  ShowZero 0; (* the Christoffel dual *)
  Mul 208 845; Sub 57 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 209 847; Sub 58 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 738 814; Sub 279 902; Mul 0 851; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 232 853; Sub 788 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 233 855; Sub 789 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 401 909; Mul 0 858; Sub 791 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 235 860; Sub 792 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 236 862; Sub 793 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 405 916; Mul 0 865; Sub 795 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 288 919; Mul 0 868; Sub 174 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 289 922; Mul 0 871; Sub 176 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 290 925; Mul 0 874; Sub 178 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 667 851; Sub 292 929; Mul 0 878; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 668 851; Sub 293 933; Mul 0 882; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 666 849; Sub 294 937; Mul 0 886; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 288 940; Mul 0 889; Sub 192 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 289 943; Mul 0 892; Sub 194 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 290 946; Mul 0 895; Sub 196 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 575 872; Sub 292 950; Mul 0 899; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 576 872; Sub 293 954; Mul 0 903; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 574 870; Sub 294 958; Mul 0 907; Sub 2 0;
  ShowZero 0 (* the Christoffel dual *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the Enneper surface; size 2.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/minimal/enneper.rs, src/construct/packing.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_2 : list step := [
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
  Add 2 26; Sub 0 38;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 4 18; Sub 0 40;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 10; Sub 0 42;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Constant 4; Div 53 0; Sub 43 56; Sub 44 56; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 37 61; Mul 0 0; Add 5 0; Sub 0 9;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 31 65; Mul 0 0; Add 9 0; Sub 0 13;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Div 68 71; Constant 12; Div 70 0; Sub 69 73; Sub 70 73; Mul 1 1; Mul 1 1; Mul 1 6; Sub 1 0;
  Add 0 6; Mul 6 0; Mul 4 10; Sub 0 6; Sub 0 10; Mul 9 0; Mul 85 4; Mul 85 1; Add 1 0; Sub 11 12;
  Mul 0 86; Add 0 2; Sub 89 91; Mul 0 0; Mul 0 22; Sub 17 0; Add 0 22; Mul 4 0; Sub 15 4;
  Sub 0 25; Mul 24 0; Mul 100 3; Mul 100 1; Add 1 0; Sub 26 10; Mul 0 101; Add 0 2; Sub 104 105;
  Mul 0 0; Sub 0 14; Add 0 36; Mul 18 0; Mul 3 40; Sub 0 19; Sub 0 40; Mul 7 0; Mul 115 4;
  Mul 115 1; Add 1 0; Sub 10 25; Mul 0 116; Add 0 2; Sub 24 40; Sub 22 37; Sub 17 32; Sub 13 43;
  Sub 10 40; Sub 5 35; Mul 5 1; Mul 5 3; Sub 1 0; Div 128 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 58; Mul 1 55; Add 1 0; Sub 51 0; Add 1 0; Sub 53 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 48; Mul 7 46; Add 1 0; Add 0 5; Sub 43 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 77; Add 0 83; Mul 83 0; Sub 46 82; Sub 0 86; Mul 53 0; Mul 161 3; Mul 161 1; Add 1 0;
  Sub 56 88; Mul 0 162; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 96 95; Sub 0 117; Div 172 0; Mul 101 0; Mul 101 1; Add 177 1; Add 177 1; Mul 4 176;
  Add 87 103; Sub 0 125; Div 180 0; Mul 91 0; Mul 109 1; Add 185 1; Add 185 1; Mul 4 184;
  Mul 10 10; Mul 10 10; Add 1 0; Mul 11 11; Sub 1 0; Mul 0 190; Mul 8 8; Mul 8 8; Add 1 0;
  Mul 9 9; Sub 1 0; Mul 0 196; Mul 65 22; Mul 62 22; Add 1 0; Sub 9 0; Mul 69 18; Mul 66 18;
  Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 116 101; Sub 0 154; Div 209 0; Mul 120 0; Mul 106 1; Add 214 1; Add 214 1; Mul 4 213;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 219; Mul 88 8; Mul 85 8; Add 1 0; Add 0 22;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 152 120; Sub 0 173; Div 228 0; Mul 157 0; Mul 125 1; Add 233 1; Add 233 1; Mul 4 232;
  Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 238; Mul 107 8; Mul 104 8; Add 1 0; Add 0 41;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 249 246; Mul 0 0; Sub 0 155; Add 0 177; Mul 159 0; Mul 3 181; Sub 0 160; Sub 0 181; Mul 7 0;
  Mul 256 4; Mul 256 1; Add 1 0; Sub 10 166; Mul 0 257; Add 0 2; Sub 151 104; Sub 148 102;
  Sub 143 97; Sub 13 107; Sub 10 105; Sub 5 100; Mul 5 1; Mul 5 3; Sub 1 0; Div 269 0; Mul 7 5;
  Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 122; Mul 1 120; Add 1 0;
  Sub 116 0; Add 1 0; Sub 118 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 175; Mul 7 172; Add 1 0; Add 0 5; Sub 169 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 218; Add 0 224; Mul 224 0; Sub 46 223; Sub 0 227; Mul 53 0; Mul 302 3; Mul 302 1;
  Add 1 0; Sub 56 229; Mul 0 303; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 37 79; Mul 34 79; Add 1 0; Sub 74 0; Mul 41 102; Mul 38 102; Add 1 0; Add 0 3; Sub 98 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 229 73; Sub 0 267; Div 322 0; Mul 233 0; Mul 78 1; Add 327 1; Add 327 1; Mul 4 326; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 332; Mul 60 8; Mul 57 8; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 265 92; Sub 0 286; Div 341 0; Mul 270 0; Mul 97 1; Add 346 1; Add 346 1; Mul 4 345; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 351; Mul 79 8; Mul 76 8; Add 1 0; Add 0 41; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 361 359; Mul 0 0; Sub 0 268; Add 0 290; Mul 272 0; Mul 3 294; Sub 0 273; Sub 0 294; Mul 7 0;
  Mul 369 4; Mul 369 1; Add 1 0; Sub 10 279; Mul 0 370; Add 0 2; Sub 123 76; Sub 120 74;
  Sub 115 69; Sub 13 79; Sub 10 77; Sub 5 72; Mul 5 1; Mul 5 3; Sub 1 0; Div 382 0; Mul 7 5;
  Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 94; Mul 1 92; Add 1 0;
  Sub 88 0; Add 1 0; Sub 90 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 147; Mul 7 144; Add 1 0; Add 0 5; Sub 141 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 331; Add 0 337; Mul 337 0; Sub 46 336; Sub 0 340; Mul 53 0; Mul 415 3; Mul 415 1;
  Add 1 0; Sub 56 342; Mul 0 416; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 37 79; Mul 34 79; Add 1 0; Sub 74 0; Mul 41 102; Mul 38 102; Add 1 0; Add 0 3; Sub 98 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 342 73; Sub 0 380; Div 435 0; Mul 346 0; Mul 78 1; Add 440 1; Add 440 1; Mul 4 439; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 445; Mul 60 8; Mul 57 8; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 378 92; Sub 0 399; Div 454 0; Mul 383 0; Mul 97 1; Add 459 1; Add 459 1; Mul 4 458; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 464; Mul 79 8; Mul 76 8; Add 1 0; Add 0 41; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Div 471 293; Div 472 238; Div 473 287; Div 474 259; Sub 291 299; Mul 4 2; Mul 1 0; Add 476 0;
  Sub 266 295; Mul 6 5; Neg 0; Mul 2 0; Add 4 0; Sub 252 271; Mul 10 12; Mul 1 0; Add 3 0;
  Sub 312 256; Mul 16 17; Neg 0; Mul 2 0; Add 4 0; Sub 0 491;
  ShowZero 0; (* as a test finds *)
  Sub 309 317; Mul 0 18; Add 494 0; Sub 283 312; Mul 0 16; Add 2 0; Sub 267 286; Mul 0 15;
  Add 2 0; Sub 326 270; Mul 0 13; Add 2 0; Sub 0 504;
  ShowZero 0; (* as a test finds *)
  Sub 309 315; Mul 0 31; Add 507 0; Sub 289 312; Mul 0 29; Add 2 0; Sub 273 292; Mul 0 28;
  Add 2 0; Sub 324 276; Mul 0 26; Add 2 0; Sub 0 517;
  ShowZero 0; (* as a test finds *)
  Div 520 173; Div 521 193; Sub 309 290; Mul 50 48; Mul 1 0; Add 523 0; Sub 200 313; Mul 52 5;
  Neg 0; Mul 2 0; Add 4 0; Sub 186 205; Mul 10 11; Mul 1 0; Add 3 0; Sub 303 190; Mul 15 63;
  Neg 0; Mul 2 0; Add 4 0; Sub 0 538;
  ShowZero 0; (* as a test finds *)
  Sub 327 308; Mul 0 18; Add 541 0; Sub 217 330; Mul 0 16; Add 2 0; Sub 201 220; Mul 0 15;
  Add 2 0; Sub 317 204; Mul 0 13; Add 2 0; Sub 0 551;
  ShowZero 0; (* as a test finds *)
  Sub 333 314; Mul 0 31; Add 554 0; Sub 223 336; Mul 0 29; Add 2 0; Sub 207 226; Mul 0 28;
  Add 2 0; Sub 323 210; Mul 0 26; Add 2 0; Sub 0 564;
  ShowZero 0; (* as a test finds *)
  Div 567 107; Div 568 127; Sub 243 224; Mul 49 48; Mul 1 0; Add 570 0; Sub 134 247; Mul 52 5;
  Neg 0; Mul 2 0; Add 4 0; Sub 120 139; Mul 10 11; Mul 1 0; Add 3 0; Sub 237 124; Mul 15 62;
  Neg 0; Mul 2 0; Add 4 0; Sub 0 585;
  ShowZero 0; (* as a test finds *)
  Sub 261 242; Mul 0 18; Add 588 0; Sub 151 264; Mul 0 16; Add 2 0; Sub 135 154; Mul 0 15;
  Add 2 0; Sub 251 138; Mul 0 13; Add 2 0; Sub 0 598;
  ShowZero 0; (* as a test finds *)
  Sub 267 248; Mul 0 31; Add 601 0; Sub 157 270; Mul 0 29; Add 2 0; Sub 141 160; Mul 0 28;
  Add 2 0; Sub 257 144; Mul 0 26; Add 2 0; Sub 0 611;
  ShowZero 0; (* as a test finds *)
  Sub 135 135;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 118 118;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 106 106;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 133 133;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 118 118;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 106 106;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 618 128; Sub 133 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 620 117; Sub 120 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 622 106; Sub 109 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 134; Sub 0 625;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 123; Sub 0 627;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 112; Sub 0 629;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 148 102; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 134 88; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 123 77; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 17 99; Add 6 105; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 89; Add 7 93; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 19 79; Add 8 83; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 108; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 97; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 86; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 76; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 62; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 51; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 73; Add 6 79; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 63; Add 7 67; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 53; Add 8 57; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 82; Sub 0 30;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 71; Sub 0 29;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 60; Sub 0 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 195 672; Sub 178 673; Sub 463 500; Sub 463 500; Sub 194 676; Sub 179 677; Mul 204 0;
  Mul 186 2; Sub 1 0; Add 681 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 456 512; Sub 456 512;
  Sub 69 688; Sub 68 689; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 216 79; Sub 201 78; Sub 376 470; Sub 376 470; Sub 71 83; Sub 70 82; Mul 183 0; Mul 165 2;
  Sub 1 0; Add 707 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 369 482; Sub 369 482; Sub 77 95;
  Sub 75 94; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 93 87; Sub 92 85; Sub 289 383; Sub 289 383; Sub 76 91; Sub 75 89; Mul 162 0; Mul 144 2;
  Sub 1 0; Add 733 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 282 395; Sub 282 395; Sub 82 103;
  Sub 80 101; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 596 673; Sub 594 670; Sub 589 665; Sub 458 676; Sub 456 673; Sub 451 668; Sub 348 679;
  Sub 346 676; Sub 341 671; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 666 680; Sub 663 678; Sub 658 673; Sub 528 683; Sub 525 681; Sub 520 676; Sub 418 686;
  Sub 415 684; Sub 410 679; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 558 606; Sub 454 623; Sub 454 623; Sub 448 609; Sub 344 626; Sub 344 626; Sub 338 612;
  Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 125 6;
  Mul 125 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 493 635; Sub 493 635; Sub 487 623; Sub 383 638; Sub 383 638; Sub 377 626; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 354 6; Mul 337 4; Add 1 0;
  Mul 326 3; Add 1 0;
  ShowZero 0; (* row *)
  Mul 719 161; Mul 719 163; Sub 1 0; Mul 366 718; Mul 348 720; Sub 1 0; Add 3 0; Add 844 0;
  Mul 724 157; Mul 724 159; Sub 1 0; Mul 173 96; Mul 173 98; Sub 1 0; Add 3 0; Add 7 0; Mul 0 801;
  ShowZero 0; (* area(F, S) *)
  Mul 595 152; Mul 595 154; Sub 1 0; Mul 336 594; Mul 318 596; Sub 1 0; Add 3 0; Add 861 0;
  Sub 567 708; Sub 565 706; Mul 602 150; Mul 602 152; Sub 1 0; Mul 166 3; Mul 166 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 820;
  ShowZero 0; (* area(F, S) *)
  Mul 501 145; Mul 501 147; Sub 1 0; Mul 308 500; Mul 290 502; Sub 1 0; Add 3 0; Add 880 0;
  Sub 473 586; Sub 471 584; Mul 508 143; Mul 508 145; Sub 1 0; Mul 159 3; Mul 159 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 839;
  ShowZero 0; (* area(F, S) *)
  Sub 815 815; Sub 893 893; Mul 0 842; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 815 815; Sub 0 2;
  ShowZero 0; (* the Christoffel dual *)
  Sub 811 811; Sub 0 4;
  ShowZero 0; (* the Christoffel dual *)
  Mul 211 848; Sub 150 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 212 850; Sub 151 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 281 904; Mul 0 853; Sub 153 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 270 907; Mul 0 856; Sub 155 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 270 910; Mul 0 859; Sub 157 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 270 913; Mul 0 862; Sub 159 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 258 916; Mul 0 865; Sub 161 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 258 919; Mul 0 868; Sub 163 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 258 922; Mul 0 871; Sub 165 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 252 873; Sub 808 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 253 875; Sub 809 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 421 929; Mul 0 878; Sub 811 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 255 880; Sub 812 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 256 882; Sub 813 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 425 936; Mul 0 885; Sub 815 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 691 862; Sub 309 940; Mul 0 889; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 691 862; Sub 311 944; Mul 0 893; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 689 860; Sub 313 948; Mul 0 897; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 590 874; Sub 300 952; Mul 0 901; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 590 874; Sub 302 956; Mul 0 905; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 588 872; Sub 304 960; Mul 0 909; Sub 2 0;
  ShowZero 0 (* the Christoffel dual *)
].

Theorem part_1_size_2_valid : valid part_1_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the logarithmoid; size 1.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/minimal/logarithmoid.rs, src/construct/packing.rs, src/pair/area.rs,
    src/pair/face.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/motion.rs, src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Constant 1; Sub 0 1;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Add 1 2;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Mul 3 3; Add 3 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Div 4 0; Mul 6 7; Mul 0 1;
  ShowNonzero 0; (* as src/construct/packing.rs finds *)
  Add 7 0;
  ShowNonzero 0; (* as src/construct/packing.rs finds *)
  Sub 8 5; Mul 0 4; Sub 10 3; Div 3 0; Mul 12 0; Mul 3 3; Mul 7 7; Sub 1 0; Mul 6 9; Mul 10 7;
  Add 1 0; Constant 0; Mul 4 20; Mul 2 1; Sub 1 0; Mul 4 23; Mul 8 4; Add 1 0; Mul 26 26;
  Mul 27 7; Mul 15 28; Mul 16 9; Mul 17 7; Mul 18 5; Div 32 20; Mul 33 0; Mul 27 36; Neg 8;
  Mul 9 0; Mul 9 1; Mul 3 18; Mul 5 5; Neg 0; Mul 12 0; Mul 12 1; Mul 8 43; Mul 13 3; Mul 13 4;
  Sub 4 9; Sub 4 9; Sub 4 9; Sub 4 12; Sub 4 12; Mul 4 0; Mul 4 2; Sub 1 0; Div 54 0; Mul 6 4;
  Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10; Mul 11 10; Sub 1 0; Mul 0 7; Mul 4 26; Mul 1 26; Add 1 0;
  Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 27; Mul 7 27; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 29; Mul 12 29; Add 1 0; Add 0 10; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 79 56; Mul 80 54; Mul 1 45; Mul 1 46; Mul 24 1; Mul 21 1; Add 1 0; Add 0 19; Sub 48 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 88 81; Mul 76 82; Mul 63 63; Mul 63 63; Add 1 0; Mul 4 4; Sub 1 0; Div 95 97; Mul 1 0;
  Mul 68 68; Mul 68 68; Add 1 0; Mul 10 10; Sub 1 0; Mul 0 6; Mul 44 76; Mul 41 76; Add 1 0;
  Sub 9 0; Mul 48 78; Mul 45 78; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 81 81; Mul 81 81; Add 1 0; Sub 0 14; Mul 0 20; Mul 58 86; Mul 55 86; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 42 42; Mul 42 42; Add 1 0; Sub 0 31; Mul 0 30; Mul 68 47; Mul 65 47; Add 1 0; Add 0 23;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 119 120; Mul 0 133; Mul 1 114; Mul 2 112; Mul 3 110; Mul 103 104; Mul 0 0; Neg 0; Mul 6 0;
  Mul 6 1; Mul 107 144; Mul 7 3; Mul 7 4; Sub 4 103; Sub 4 103; Sub 4 103; Sub 4 106; Sub 4 106;
  Mul 4 0; Mul 4 2; Sub 1 0; Div 153 0; Mul 6 4; Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10; Mul 11 10;
  Sub 1 0; Mul 0 7; Mul 4 120; Mul 1 120; Add 1 0; Sub 121 0; Add 1 0; Sub 123 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 27; Mul 7 27; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 29; Mul 12 29; Add 1 0; Add 0 10; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 133; Mul 17 133; Add 1 0; Add 0 15; Sub 138 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 50 176; Mul 50 50; Mul 50 50; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 93; Mul 32 161; Mul 29 161;
  Add 1 0; Sub 90 0; Mul 36 60; Mul 33 60; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 63 63; Mul 63 63; Add 1 0; Sub 0 14; Mul 0 107; Mul 46 68; Mul 43 68; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 51 178; Mul 48 178; Add 1 0; Add 0 18; Sub 96 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 81 202; Mul 0 215; Mul 1 196; Mul 2 194; Mul 3 192; Mul 81 186; Mul 0 0; Neg 0; Mul 6 0;
  Mul 6 1; Constant 3; Mul 190 0; Mul 8 4; Mul 8 5; Sub 5 87; Sub 5 87; Sub 4 87; Sub 4 90;
  Sub 4 90; Mul 4 0; Mul 4 2; Sub 1 0; Div 236 0; Mul 6 4; Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10;
  Mul 11 10; Sub 1 0; Mul 0 7; Mul 4 104; Mul 1 104; Add 1 0; Sub 105 0; Add 1 0; Sub 107 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 28; Mul 7 28; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 29; Mul 12 29; Add 1 0; Add 0 10; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 117; Mul 17 117; Add 1 0; Add 0 15; Sub 122 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 51 259; Mul 51 51; Mul 51 51; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 176; Mul 32 139; Mul 29 139;
  Add 1 0; Sub 86 0; Mul 36 61; Mul 33 61; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 64 64; Mul 64 64; Add 1 0; Sub 0 14; Mul 0 190; Mul 46 69; Mul 43 69; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 51 156; Mul 48 156; Add 1 0; Add 0 18; Sub 92 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Div 297 208; Div 298 208; Sub 270 272; Mul 2 1; Mul 1 0; Add 282 0; Sub 272 274; Mul 5 5; Neg 0;
  Mul 2 0; Add 4 0; Sub 228 277; Mul 10 11; Mul 1 0; Add 3 0; Sub 285 232; Mul 15 15; Neg 0;
  Mul 2 0; Add 4 0; Sub 0 297;
  ShowZero 0; (* as a test finds *)
  Sub 288 290; Mul 0 18; Add 300 0; Sub 289 291; Mul 0 16; Add 2 0; Sub 243 292; Mul 0 15;
  Add 2 0; Sub 299 246; Mul 0 13; Add 2 0; Sub 0 310;
  ShowZero 0; (* as a test finds *)
  Sub 228 234; Mul 0 31; Add 313 0; Sub 217 231; Mul 0 29; Add 2 0; Sub 210 220; Mul 0 28;
  Add 2 0; Sub 243 213; Mul 0 26; Add 2 0; Sub 0 323;
  ShowZero 0; (* as a test finds *)
  Div 344 160; Sub 211 316; Mul 47 1; Mul 1 0; Add 328 0; Sub 213 215; Mul 5 5; Neg 0; Mul 2 0;
  Add 4 0; Sub 323 218; Mul 10 56; Mul 1 0; Add 3 0; Sub 329 327; Mul 0 53; Add 2 0; Sub 0 341;
  ShowZero 0; (* as a test finds *)
  Sub 227 332; Mul 0 16; Add 344 0; Sub 228 230; Mul 0 14; Add 2 0; Sub 336 231; Mul 0 13;
  Add 2 0; Sub 341 339; Mul 0 66; Add 2 0; Sub 0 354;
  ShowZero 0; (* as a test finds *)
  Sub 185 272; Mul 0 29; Add 357 0; Sub 174 188; Mul 0 27; Add 2 0; Sub 264 177; Mul 0 26;
  Add 2 0; Sub 281 267; Mul 0 79; Add 2 0; Sub 0 367;
  ShowZero 0; (* as a test finds *)
  Div 388 121; Sub 173 255; Mul 45 1; Mul 1 0; Add 372 0; Sub 175 177; Mul 5 5; Neg 0; Mul 2 0;
  Add 4 0; Sub 262 180; Mul 10 54; Mul 1 0; Add 3 0; Sub 268 266; Mul 0 51; Add 2 0; Sub 0 385;
  ShowZero 0; (* as a test finds *)
  Sub 189 271; Mul 0 16; Add 388 0; Sub 190 192; Mul 0 14; Add 2 0; Sub 275 193; Mul 0 13;
  Add 2 0; Sub 280 278; Mul 0 64; Add 2 0; Sub 0 398;
  ShowZero 0; (* as a test finds *)
  Sub 146 229; Mul 0 29; Add 401 0; Sub 135 149; Mul 0 27; Add 2 0; Sub 221 138; Mul 0 26;
  Add 2 0; Sub 238 224; Mul 0 77; Add 2 0; Sub 0 411;
  ShowZero 0; (* as a test finds *)
  Sub 129 129;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 112 112;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 100 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 127 127;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 112 112;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 100 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 418 122; Sub 127 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 420 111; Sub 114 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 422 100; Sub 103 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 128; Sub 0 425;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 117; Sub 0 427;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 106; Sub 0 429;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 147 102; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 131 88; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 120 77; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 148 99; Add 6 104; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 135 89; Add 7 93; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 125 79; Add 8 83; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 108; Sub 0 158;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 97; Sub 0 144;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 86; Sub 0 133;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 79; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 65; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 54; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 76; Add 6 81; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 66; Add 7 70; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 56; Add 8 60; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 85; Sub 0 30;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 74; Sub 0 29;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 63; Sub 0 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 189 472; Sub 172 473; Sub 463 467; Sub 463 467; Sub 188 476; Sub 173 477; Mul 198 0;
  Mul 180 2; Sub 1 0; Add 481 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 426 479; Sub 426 479;
  Sub 69 488; Sub 68 489; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 67 215; Sub 66 198; Sub 384 491; Sub 384 491; Sub 65 219; Sub 63 202; Mul 178 0; Mul 162 2;
  Sub 1 0; Add 507 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 224 229; Sub 209 212; Mul 13 0;
  Mul 13 2; Sub 1 0; Add 5 0; Mul 15 216; Mul 15 235; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 70 91; Sub 69 90; Sub 326 410; Sub 326 410; Sub 68 95; Sub 66 94; Mul 158 0; Mul 142 2;
  Sub 1 0; Add 531 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 99 105; Sub 97 104; Mul 13 0;
  Mul 13 2; Sub 1 0; Add 5 0; Mul 15 196; Mul 15 213; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 425 529; Sub 425 529; Sub 425 529; Sub 346 532; Sub 346 532; Sub 345 532; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 534 6; Mul 534 4; Add 1 0;
  Mul 535 3; Add 1 0;
  ShowZero 0; (* column *)
  Sub 541 504; Sub 541 504; Sub 444 506; Sub 444 506; Sub 363 508; Sub 363 508; Mul 2 20;
  Mul 24 1; Sub 1 0; Mul 26 4; Mul 7 24; Sub 1 0; Mul 9 6; Mul 9 8; Sub 1 0; Mul 14 6; Mul 14 4;
  Add 1 0; Mul 555 3; Add 1 0;
  ShowZero 0; (* column *)
  Sub 472 579; Sub 472 579; Sub 418 511; Sub 393 582; Sub 393 582; Sub 338 514; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 321 6; Mul 303 4; Add 1 0;
  Mul 292 3; Add 1 0;
  ShowZero 0; (* column *)
  Sub 595 546; Sub 595 546; Sub 511 501; Sub 493 549; Sub 493 549; Sub 427 504; Sub 414 552;
  Sub 414 552; Sub 347 507; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* column *)
  Mul 602 153; Mul 602 155; Sub 1 0; Mul 352 601; Mul 334 603; Sub 1 0; Add 3 0; Add 636 0;
  Sub 575 620; Sub 575 620; Mul 609 151; Mul 609 153; Sub 1 0; Mul 167 3; Mul 167 5; Sub 1 0;
  Add 3 0; Add 9 0; Constant 4; Div 668 0; Mul 2 0;
  ShowZero 0; (* area(F, S) *)
  Mul 524 148; Mul 524 150; Sub 1 0; Mul 327 523; Mul 311 525; Sub 1 0; Add 3 0; Add 657 0;
  Sub 633 636; Sub 633 636; Mul 531 358; Mul 531 377; Sub 1 0; Mul 162 3; Mul 162 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 19;
  ShowZero 0; (* area(F, S) *)
  Mul 460 143; Mul 460 145; Sub 1 0; Mul 302 459; Mul 286 461; Sub 1 0; Add 3 0; Add 676 0;
  Sub 553 556; Sub 553 556; Mul 467 333; Mul 467 350; Sub 1 0; Mul 157 3; Mul 157 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 38;
  ShowZero 0; (* area(F, S) *)
  Sub 671 671; Sub 689 689; Mul 0 695; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 674 674; Sub 0 2;
  ShowZero 0; (* the Christoffel dual *)
  Sub 675 675; Sub 0 4;
  ShowZero 0; (* the Christoffel dual *)
  Mul 207 701; Sub 59 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 208 703; Sub 60 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 277 700; Mul 0 706; Sub 7 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 230 708; Sub 677 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 231 710; Sub 678 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 393 707; Mul 0 713; Sub 680 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 233 715; Sub 681 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 234 717; Sub 682 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 397 714; Mul 0 720; Sub 687 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 286 717; Mul 0 723; Sub 172 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 287 720; Mul 0 726; Sub 174 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 288 723; Mul 0 729; Sub 176 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 602 709; Sub 290 727; Mul 0 733; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 605 712; Sub 291 731; Mul 0 737; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 291 734; Mul 0 740; Sub 187 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 285 737; Mul 0 743; Sub 189 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 286 740; Mul 0 746; Sub 191 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 287 743; Mul 0 749; Sub 193 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 539 729; Sub 289 747; Mul 0 753; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 542 732; Sub 290 751; Mul 0 757; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 290 754; Mul 0 760; Sub 204 0;
  ShowZero 0 (* the Christoffel dual *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the logarithmoid; size 2.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/minimal/logarithmoid.rs, src/construct/packing.rs, src/pair/area.rs,
    src/pair/face.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/motion.rs, src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_2 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Constant 1; Sub 0 1;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Add 1 2;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Mul 3 3; Add 3 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Div 4 0; Mul 6 7; Mul 0 1;
  ShowNonzero 0; (* as src/construct/packing.rs finds *)
  Add 7 0;
  ShowNonzero 0; (* as src/construct/packing.rs finds *)
  Sub 8 5; Mul 0 4; Sub 10 3; Div 3 0; Mul 12 0; Mul 3 3; Mul 7 7; Sub 1 0; Mul 6 9; Mul 10 7;
  Add 1 0; Constant 0; Mul 4 20; Mul 2 1; Sub 1 0; Mul 4 23; Mul 8 4; Add 1 0; Mul 26 26;
  Mul 27 7; Mul 15 28; Mul 16 9; Mul 17 7; Mul 18 5; Div 32 20; Mul 33 0; Mul 27 36; Neg 8;
  Mul 9 0; Mul 9 1; Mul 3 18; Mul 5 5; Neg 0; Mul 12 0; Mul 12 1; Mul 8 43; Mul 13 3; Mul 13 4;
  Sub 4 9; Sub 4 9; Sub 4 9; Sub 4 12; Sub 4 12; Mul 4 0; Mul 4 2; Sub 1 0; Div 54 0; Mul 6 4;
  Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10; Mul 11 10; Sub 1 0; Mul 0 7; Mul 4 26; Mul 1 26; Add 1 0;
  Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 27; Mul 7 27; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 29; Mul 12 29; Add 1 0; Add 0 10; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 79 56; Mul 80 54; Mul 1 45; Mul 1 46; Mul 24 1; Mul 21 1; Add 1 0; Add 0 19; Sub 48 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 88 81; Mul 76 82; Mul 63 63; Mul 63 63; Add 1 0; Mul 4 4; Sub 1 0; Div 95 97; Mul 1 0;
  Mul 68 68; Mul 68 68; Add 1 0; Mul 10 10; Sub 1 0; Mul 0 6; Mul 44 76; Mul 41 76; Add 1 0;
  Sub 9 0; Mul 48 78; Mul 45 78; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 81 81; Mul 81 81; Add 1 0; Sub 0 14; Mul 0 20; Mul 58 86; Mul 55 86; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 42 42; Mul 42 42; Add 1 0; Sub 0 31; Mul 0 30; Mul 68 47; Mul 65 47; Add 1 0; Add 0 23;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 116 109; Mul 114 107; Sub 1 0; Mul 116 112; Mul 120 110; Add 1 0; Mul 125 3; Mul 126 1;
  Mul 1 99; Mul 1 100; Sub 97 60; Sub 97 60; Sub 3 62; Sub 3 62; Mul 3 0; Mul 3 2; Sub 1 0;
  Div 149 0; Mul 101 4; Mul 7 102; Sub 1 0; Mul 0 3; Mul 11 105; Mul 106 10; Sub 1 0; Mul 0 7;
  Mul 4 76; Mul 1 76; Add 1 0; Sub 122 0; Add 1 0; Sub 124 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 119; Mul 7 119; Add 1 0; Add 0 5; Sub 124 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 129 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 174 39; Mul 175 37; Mul 1 140; Mul 1 141; Mul 24 1; Mul 21 1; Add 1 0; Add 0 19; Sub 143 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 29 103; Mul 26 103; Add 1 0; Sub 59 0; Mul 33 156; Mul 30 156; Add 1 0; Add 0 3; Sub 74 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 53 53; Mul 53 53; Add 1 0; Sub 0 94; Mul 0 100; Mul 43 58; Mul 40 58; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 27 27; Mul 27 27; Add 1 0; Sub 0 111; Mul 0 110; Mul 53 32; Mul 50 32; Add 1 0; Add 0 23;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 196 77; Mul 194 75; Sub 1 0; Mul 196 80; Mul 200 78; Add 1 0; Mul 205 3; Mul 206 1;
  Mul 1 179; Mul 1 180; Sub 81 45; Sub 81 45; Sub 3 47; Sub 3 47; Mul 3 0; Mul 3 2; Sub 1 0;
  Div 229 0; Mul 181 4; Mul 7 182; Sub 1 0; Mul 0 3; Mul 11 185; Mul 186 10; Sub 1 0; Mul 0 7;
  Mul 4 61; Mul 1 61; Add 1 0; Sub 202 0; Add 1 0; Sub 204 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 103; Mul 7 103; Add 1 0; Add 0 5; Sub 204 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 209 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 254 39; Mul 255 37; Mul 1 220; Mul 1 221; Mul 24 1; Mul 21 1; Add 1 0; Add 0 19; Sub 223 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 29 88; Mul 26 88; Add 1 0; Sub 59 0; Mul 33 128; Mul 30 128; Add 1 0; Add 0 3; Sub 74 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 53 53; Mul 53 53; Add 1 0; Sub 0 174; Mul 0 180; Mul 43 58; Mul 40 58; Add 1 0; Add 0 13;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 27 27; Mul 27 27; Add 1 0; Sub 0 191; Mul 0 190; Mul 53 32; Mul 50 32; Add 1 0; Add 0 23;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Div 292 203; Div 293 203; Sub 265 267; Mul 2 1; Mul 1 0; Add 277 0; Sub 267 269; Mul 5 5; Neg 0;
  Mul 2 0; Add 4 0; Sub 223 272; Mul 10 11; Mul 1 0; Add 3 0; Sub 280 227; Mul 15 15; Neg 0;
  Mul 2 0; Add 4 0; Sub 0 292;
  ShowZero 0; (* as a test finds *)
  Sub 283 285; Mul 0 18; Add 295 0; Sub 284 286; Mul 0 16; Add 2 0; Sub 238 287; Mul 0 15;
  Add 2 0; Sub 294 241; Mul 0 13; Add 2 0; Sub 0 305;
  ShowZero 0; (* as a test finds *)
  Sub 223 229; Mul 0 31; Add 308 0; Sub 212 226; Mul 0 29; Add 2 0; Sub 205 215; Mul 0 28;
  Add 2 0; Sub 238 208; Mul 0 26; Add 2 0; Sub 0 318;
  ShowZero 0; (* as a test finds *)
  Sub 308 259; Mul 0 44; Add 321 0; Sub 203 311; Mul 0 42; Add 2 0; Sub 170 206; Mul 0 41;
  Add 2 0; Sub 268 173; Mul 0 39; Add 2 0; Sub 0 331;
  ShowZero 0; (* as a test finds *)
  Sub 320 271; Mul 0 57; Add 334 0; Sub 215 323; Mul 0 55; Add 2 0; Sub 182 218; Mul 0 54;
  Add 2 0; Sub 280 185; Mul 0 52; Add 2 0; Sub 0 344;
  ShowZero 0; (* as a test finds *)
  Sub 248 238; Mul 0 70; Add 347 0; Sub 171 251; Mul 0 68; Add 2 0; Sub 164 174; Mul 0 67;
  Add 2 0; Sub 247 167; Mul 0 65; Add 2 0; Sub 0 357;
  ShowZero 0; (* as a test finds *)
  Sub 239 203; Mul 0 83; Add 360 0; Sub 162 242; Mul 0 81; Add 2 0; Sub 129 165; Mul 0 80;
  Add 2 0; Sub 212 132; Mul 0 78; Add 2 0; Sub 0 370;
  ShowZero 0; (* as a test finds *)
  Sub 251 215; Mul 0 96; Add 373 0; Sub 174 254; Mul 0 94; Add 2 0; Sub 141 177; Mul 0 93;
  Add 2 0; Sub 224 144; Mul 0 91; Add 2 0; Sub 0 383;
  ShowZero 0; (* as a test finds *)
  Sub 207 197; Mul 0 109; Add 386 0; Sub 130 210; Mul 0 107; Add 2 0; Sub 123 133; Mul 0 106;
  Add 2 0; Sub 206 126; Mul 0 104; Add 2 0; Sub 0 396;
  ShowZero 0; (* as a test finds *)
  Sub 119 119;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 102 102;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 90 90;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 117 117;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 102 102;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 90 90;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 403 112; Sub 117 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 405 101; Sub 104 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 407 90; Sub 93 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 118; Sub 0 410;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 107; Sub 0 412;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 96; Sub 0 414;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 132 91; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 118 80; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 107 69; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 17 91; Add 6 95; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 81; Add 7 85; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 19 71; Add 8 75; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 100; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 89; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 78; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 73; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 62; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 51; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 73; Add 6 77; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 63; Add 7 67; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 53; Add 8 57; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 82; Sub 0 30;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 71; Sub 0 29;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 60; Sub 0 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 179 457; Sub 162 458; Sub 448 452; Sub 448 452; Sub 178 461; Sub 163 462; Mul 188 0;
  Mul 170 2; Sub 1 0; Add 466 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 411 464; Sub 411 464;
  Sub 69 473; Sub 68 474; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 200 79; Sub 185 78; Sub 366 425; Sub 366 425; Sub 71 83; Sub 70 82; Mul 169 0; Mul 157 2;
  Sub 1 0; Add 492 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 342 437; Sub 342 437; Sub 77 95;
  Sub 75 94; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 93 87; Sub 92 85; Sub 312 356; Sub 312 356; Sub 76 91; Sub 75 89; Mul 156 0; Mul 144 2;
  Sub 1 0; Add 518 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 288 368; Sub 288 368; Sub 82 103;
  Sub 80 101; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 473 518; Sub 473 518; Sub 518 518; Sub 381 521; Sub 381 521; Sub 303 523; Sub 303 523;
  Mul 2 4; Mul 5 1; Sub 1 0; Mul 7 4; Mul 7 8; Sub 1 0; Mul 9 6; Mul 9 8; Sub 1 0; Mul 15 6;
  Mul 15 4; Add 1 0; Mul 16 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 531 534; Sub 531 534; Sub 534 534; Sub 438 537; Sub 438 537; Sub 360 539; Sub 360 539;
  Mul 2 4; Mul 5 1; Sub 1 0; Mul 7 4; Mul 7 8; Sub 1 0; Mul 9 6; Mul 9 8; Sub 1 0; Mul 15 6;
  Mul 15 4; Add 1 0; Mul 16 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 470 500; Sub 423 571; Sub 423 571; Sub 393 503; Sub 346 574; Sub 346 574; Sub 316 506;
  Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 121 6;
  Mul 121 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 479 589; Sub 479 589; Sub 423 517; Sub 402 592; Sub 402 592; Sub 346 520; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 334 6; Mul 317 4; Add 1 0;
  Mul 306 3; Add 1 0;
  ShowZero 0; (* row *)
  Mul 591 157; Mul 591 159; Sub 1 0; Mul 346 590; Mul 328 592; Sub 1 0; Add 3 0; Add 625 0;
  Mul 596 153; Mul 596 155; Sub 1 0; Mul 169 92; Mul 169 94; Sub 1 0; Add 3 0; Add 7 0;
  Constant 4; Div 655 0; Mul 2 0;
  ShowZero 0; (* area(F, S) *)
  Mul 514 150; Mul 514 152; Sub 1 0; Mul 320 514; Mul 308 516; Sub 1 0; Add 3 0; Add 644 0;
  Sub 488 583; Sub 488 583; Mul 522 148; Mul 522 150; Sub 1 0; Mul 164 3; Mul 164 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 19;
  ShowZero 0; (* area(F, S) *)
  Mul 453 143; Mul 453 145; Sub 1 0; Mul 300 453; Mul 288 455; Sub 1 0; Add 3 0; Add 663 0;
  Sub 427 507; Sub 427 507; Mul 461 141; Mul 461 143; Sub 1 0; Mul 157 3; Mul 157 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 38;
  ShowZero 0; (* area(F, S) *)
  Sub 658 658; Sub 676 676; Mul 0 682; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 661 661; Sub 0 2;
  ShowZero 0; (* the Christoffel dual *)
  Sub 143 3;
  ShowZero 0; (* the Christoffel dual *)
  Mul 208 687; Sub 147 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 209 689; Sub 148 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 278 686; Mul 0 692; Sub 150 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 267 689; Mul 0 695; Sub 152 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 267 692; Mul 0 698; Sub 154 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 267 695; Mul 0 701; Sub 159 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 255 698; Mul 0 704; Sub 159 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 255 701; Mul 0 707; Sub 161 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 255 704; Mul 0 710; Sub 168 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 249 712; Sub 681 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 250 714; Sub 682 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 402 711; Mul 0 717; Sub 684 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 252 719; Sub 685 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 253 721; Sub 686 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 406 718; Mul 0 724; Sub 691 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 600 704; Sub 306 722; Mul 0 728; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 603 707; Sub 308 726; Mul 0 732; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 309 729; Mul 0 735; Sub 702 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 531 715; Sub 296 733; Mul 0 739; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 534 718; Sub 298 737; Mul 0 743; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 299 740; Mul 0 746; Sub 713 0;
  ShowZero 0 (* the Christoffel dual *)
].

Theorem part_2_size_2_valid : valid part_2_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the counterpart of Bonnet's surface; size 1.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/minimal/bonnet.rs, src/construct/packing.rs, src/pair/area.rs,
    src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_3_size_1 : list step := [
  Unknown 0;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Constant 1; Sub 0 1;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Mul 2 2; Add 2 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Div 3 0; Constant 2; Mul 6 0; Mul 0 2; Unknown 1; Unknown 2; Constant 0; Mul 10 10; Mul 11 1;
  Mul 12 5; Mul 0 0; Sub 3 6; Sub 3 6; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 20 18; Mul 0 17; Mul 0 0; Mul 16 16; Sub 1 0; Mul 3 18; Mul 19 4; Add 1 0; Mul 3 28;
  Mul 1 19; Sub 1 0; Mul 3 31; Mul 7 22; Add 1 0; Mul 34 3; Mul 35 1; Sub 1 28; Sub 1 28; Mul 1 1;
  Mul 1 1; Add 1 0; Sub 0 27;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 42 35; Sub 43 36; Div 1 0; Mul 45 0; Mul 0 46; Mul 1 37; Mul 2 41; Mul 0 0; Sub 3 42;
  Sub 3 42; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 10 25; Mul 11 23; Sub 1 50; Sub 1 50; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 13;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 18 19; Mul 0 65; Mul 1 56; Mul 2 60; Mul 0 0; Sub 3 61; Sub 3 61; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 0 5;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 10 44; Mul 11 42; Sub 1 69; Sub 1 69; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 13;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 18 38; Mul 0 84; Mul 1 75; Mul 2 79; Mul 0 0; Sub 3 80; Sub 3 80; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 0 5;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 10 63; Mul 11 61; Sub 1 88; Sub 1 88; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 13;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Div 102 82; Mul 88 0; Mul 88 1; Add 97 1; Add 97 1; Div 107 51; Mul 57 0; Mul 57 1; Add 102 1;
  Add 102 1; Div 112 48; Mul 54 0; Mul 54 1; Add 107 1; Add 107 1; Sub 6 11; Sub 6 11; Sub 3 13;
  Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0; Add 114 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Div 125 50; Mul 56 0; Mul 56 1; Add 120 1; Add 120 1; Div 130 47; Mul 53 0; Mul 53 1; Add 125 1;
  Add 125 1; Sub 6 24; Sub 6 24; Sub 3 26; Sub 3 26; Mul 3 0; Mul 3 2; Sub 1 0; Add 132 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Div 143 49; Mul 55 0; Mul 55 1; Add 138 1; Add 138 1; Div 148 46; Mul 52 0; Mul 52 1; Add 143 1;
  Add 143 1; Sub 6 24; Sub 6 24; Sub 3 26; Sub 3 26; Mul 3 0; Mul 3 2; Sub 1 0; Add 150 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  ShowNonzero 154; (* as src/construct/packing.rs finds *)
  ShowNonzero 118; (* as src/construct/packing.rs finds *)
  Mul 148 58; Mul 113 54; Mul 114 50; Mul 58 58; Mul 58 58; Add 1 0; Mul 5 5; Sub 1 0;
  Div 169 164; Mul 1 0; Mul 60 60; Mul 60 60; Add 1 0; Mul 11 11; Sub 1 0; Mul 0 6; Mul 61 61;
  Mul 61 61; Add 1 0; Mul 16 16; Sub 1 0; Mul 0 12; Sub 6 12; Sub 1 13; Div 185 61; Mul 2 65;
  Mul 68 2; Sub 1 0; Mul 0 3; Mul 72 5; Mul 7 71; Sub 1 0; Mul 0 7; Mul 4 88; Mul 1 88; Add 1 0;
  Sub 26 0; Add 1 0; Sub 28 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 89; Mul 7 89; Add 1 0; Add 0 5; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 89; Mul 12 89; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 210 168; Mul 174 0; Mul 174 1; Add 205 1; Add 205 1; Mul 202 4; Mul 2 2; Mul 2 2; Add 1 0;
  Mul 3 3; Sub 1 0; Mul 0 51; Mul 32 8; Mul 29 8; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 159 101; Mul 160 97; Mul 100 100; Mul 100 100; Add 1 0; Mul 4 4; Sub 1 0; Mul 0 64;
  Mul 101 101; Mul 101 101; Add 1 0; Mul 9 9; Sub 1 0; Mul 0 70; Sub 6 64; Sub 1 65; Div 243 101;
  Mul 2 105; Mul 108 2; Sub 1 0; Mul 0 3; Mul 112 5; Mul 7 111; Sub 1 0; Mul 0 7; Mul 4 141;
  Mul 1 141; Add 1 0; Sub 78 0; Add 1 0; Sub 80 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 129; Mul 7 129; Add 1 0; Add 0 5; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 129; Mul 12 129; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 152; Mul 17 152; Add 1 0; Add 0 15; Sub 89 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 186 129; Mul 187 125; Mul 128 128; Mul 128 128; Add 1 0; Mul 4 4; Sub 1 0; Mul 0 110;
  Mul 129 129; Mul 129 129; Add 1 0; Mul 9 9; Sub 1 0; Mul 0 116; Sub 6 52; Sub 1 53; Div 289 129;
  Mul 2 133; Mul 136 2; Sub 1 0; Mul 0 3; Mul 140 5; Mul 7 139; Sub 1 0; Mul 0 7; Mul 4 169;
  Mul 1 169; Add 1 0; Sub 66 0; Add 1 0; Sub 68 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 157; Mul 7 157; Add 1 0; Add 0 5; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 157; Mul 12 157; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 180; Mul 17 180; Add 1 0; Add 0 15; Sub 77 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 319 157; Div 320 104; Div 321 158; Div 322 158; Mul 3 1; Mul 206 0; Add 315 0; Sub 210 215;
  Mul 5 4; Neg 0; Mul 2 0; Add 4 0; Sub 117 215; Mul 9 11; Mul 1 0; Add 3 0; Sub 229 121;
  Mul 15 16; Neg 0; Mul 2 0; Add 4 0; Sub 0 330;
  ShowZero 0; (* as a test finds *)
  Mul 222 17; Add 332 0; Sub 226 231; Mul 0 15; Add 2 0; Sub 131 229; Mul 0 14; Add 2 0;
  Sub 242 134; Mul 0 12; Add 2 0; Sub 0 342;
  ShowZero 0; (* as a test finds *)
  Mul 169 29; Add 344 0; Sub 172 178; Mul 0 27; Add 2 0; Sub 136 175; Mul 0 26; Add 2 0;
  Sub 190 139; Mul 0 24; Add 2 0; Sub 0 354;
  ShowZero 0; (* as a test finds *)
  Div 365 137; Div 366 137; Mul 45 1; Mul 232 0; Add 359 0; Sub 236 241; Mul 5 4; Neg 0; Mul 2 0;
  Add 4 0; Sub 259 241; Mul 9 53; Mul 1 0; Add 3 0; Sub 268 263; Mul 57 58; Neg 0; Mul 2 0;
  Add 4 0; Sub 0 374;
  ShowZero 0; (* as a test finds *)
  Mul 248 17; Add 376 0; Sub 252 257; Mul 0 15; Add 2 0; Sub 273 255; Mul 0 14; Add 2 0;
  Sub 281 276; Mul 0 12; Add 2 0; Sub 0 386;
  ShowZero 0; (* as a test finds *)
  Mul 155 29; Add 388 0; Sub 158 164; Mul 0 27; Add 2 0; Sub 219 161; Mul 0 26; Add 2 0;
  Sub 228 222; Mul 0 24; Add 2 0; Sub 0 398;
  ShowZero 0; (* as a test finds *)
  Div 409 135; Div 410 135; Mul 45 1; Mul 258 0; Add 403 0; Sub 262 267; Mul 5 4; Neg 0; Mul 2 0;
  Add 4 0; Sub 285 267; Mul 9 53; Mul 1 0; Add 3 0; Sub 294 289; Mul 57 58; Neg 0; Mul 2 0;
  Add 4 0; Sub 0 418;
  ShowZero 0; (* as a test finds *)
  Mul 274 17; Add 420 0; Sub 278 283; Mul 0 15; Add 2 0; Sub 299 281; Mul 0 14; Add 2 0;
  Sub 307 302; Mul 0 12; Add 2 0; Sub 0 430;
  ShowZero 0; (* as a test finds *)
  Mul 153 29; Add 432 0; Sub 156 162; Mul 0 27; Add 2 0; Sub 205 159; Mul 0 26; Add 2 0;
  Sub 214 208; Mul 0 24; Add 2 0; Sub 0 442;
  ShowZero 0; (* as a test finds *)
  Sub 127 127;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 111 111;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 100 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 125 125;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 111 111;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 100 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 449 120; Sub 125 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 451 110; Sub 113 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 453 100; Sub 103 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 126; Sub 0 456;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 116; Sub 0 458;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 106; Sub 0 460;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 145 102; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 130 87; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 120 77; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 146 99; Add 6 104; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 134 88; Add 7 92; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 125 79; Add 8 83; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 108; Sub 0 156;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 96; Sub 0 143;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 86; Sub 0 133;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 79; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 64; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 54; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 76; Add 6 81; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 65; Add 7 69; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 56; Add 8 60; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 85; Sub 0 30;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 73; Sub 0 29;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 63; Sub 0 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 187 503; Sub 171 504; Sub 184 505; Sub 170 506; Mul 399 0; Mul 399 2; Sub 1 0; Add 510 0;
  Mul 7 400; Mul 7 402; Sub 1 0; Add 3 0; Sub 311 419; Sub 311 419; Sub 67 517; Sub 66 518;
  Mul 409 0; Mul 409 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 65 211; Sub 64 195; Sub 61 213; Sub 59 197; Mul 405 0; Mul 405 2; Sub 1 0; Add 534 0;
  Mul 7 406; Mul 7 408; Sub 1 0; Add 3 0; Sub 218 223; Sub 204 207; Mul 413 0; Mul 413 2; Sub 1 0;
  Add 5 0; Mul 15 211; Mul 15 229; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 66 87; Sub 65 86; Sub 62 89; Sub 60 88; Mul 409 0; Mul 409 2; Sub 1 0; Add 556 0; Mul 7 410;
  Mul 7 412; Sub 1 0; Add 3 0; Sub 93 99; Sub 91 98; Mul 417 0; Mul 417 2; Sub 1 0; Add 5 0;
  Mul 15 189; Mul 15 207; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Mul 261 557; Mul 0 420; Sub 0 559;
  ShowZero 0; (* radii *)
  Mul 263 560; Mul 0 369; Sub 0 562;
  ShowZero 0; (* radii *)
  Mul 265 563; Mul 0 425; Sub 0 565;
  ShowZero 0; (* radii *)
  Mul 267 566; Mul 0 427; Sub 0 568;
  ShowZero 0; (* radii *)
  Mul 227 569; Mul 0 366; Sub 0 571;
  ShowZero 0; (* radii *)
  Mul 229 572; Mul 0 368; Sub 0 574;
  ShowZero 0; (* radii *)
  Mul 189 575; Mul 0 326; Sub 0 577;
  ShowZero 0; (* radii *)
  Mul 191 578; Mul 0 328; Sub 0 580;
  ShowZero 0; (* radii *)
  Mul 595 581; Mul 280 582; Mul 264 583; Mul 253 584; Mul 137 585; Mul 136 586; Mul 135 587;
  Mul 119 588; Mul 118 589; Mul 117 590; Sub 8 9; Sub 8 10; Sub 8 11; Sub 8 12; Sub 8 13;
  Sub 8 14; Sub 8 15; Sub 8 16; Sub 8 17; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0;
  Mul 11 7; Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* column *)
  Mul 178 614; Mul 177 615; Mul 176 616; Mul 310 617; Mul 296 618; Mul 285 619; Mul 166 620;
  Mul 164 621; Mul 162 622; Mul 148 623; Mul 146 624; Mul 144 625; Sub 8 11; Sub 8 11; Sub 8 11;
  Sub 8 14; Sub 8 14; Sub 8 14; Sub 8 17; Sub 8 17; Sub 8 17; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5;
  Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* column *)
  Sub 544 567; Sub 544 567; Sub 440 504; Sub 529 570; Sub 529 570; Sub 397 507; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 570 6; Mul 570 4; Add 1 0;
  Mul 507 3; Add 1 0;
  ShowZero 0; (* column *)
  Sub 577 479; Sub 577 479; Sub 512 473; Sub 562 482; Sub 562 482; Sub 457 476; Sub 547 485;
  Sub 547 485; Sub 414 479; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0 (* column *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the counterpart of Bonnet's surface; size 2.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/minimal/bonnet.rs, src/construct/packing.rs, src/pair/area.rs,
    src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_3_size_2 : list step := [
  Unknown 0;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Constant 1; Sub 0 1;
  Nonzero 0; (* the sine of half a sector is not 0, 1 or -1 *)
  Mul 2 2; Add 2 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Div 3 0; Constant 2; Mul 6 0; Mul 0 2; Unknown 1; Unknown 2; Constant 0; Mul 10 10; Mul 11 1;
  Mul 12 5; Mul 0 0; Sub 3 6; Sub 3 6; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 20 18; Mul 0 17; Mul 0 0; Mul 16 16; Sub 1 0; Mul 3 18; Mul 19 4; Add 1 0; Mul 3 28;
  Mul 1 19; Sub 1 0; Mul 3 31; Mul 7 22; Add 1 0; Mul 34 3; Mul 35 1; Sub 1 28; Sub 1 28; Mul 1 1;
  Mul 1 1; Add 1 0; Sub 0 27;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 17 11; Mul 15 9; Sub 1 0; Mul 17 14; Mul 21 12; Add 1 0; Mul 48 3; Mul 49 1; Sub 1 42;
  Sub 1 42; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 41;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 31 11; Mul 29 9; Sub 1 0; Mul 31 14; Mul 35 12; Add 1 0; Mul 62 3; Mul 63 1; Sub 1 56;
  Sub 1 56; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 55;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 70 63; Sub 71 64; Div 1 0; Mul 73 0; Mul 0 74; Mul 1 65; Mul 2 69; Mul 0 0; Sub 3 70;
  Sub 3 70; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 10 53; Mul 11 51; Sub 1 78; Sub 1 78; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 13;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 18 47; Mul 19 45; Sub 1 86; Sub 1 86; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 21;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Mul 26 41; Mul 27 39; Sub 1 94; Sub 1 94; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 29;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Div 108 88; Mul 94 0; Mul 94 1; Add 103 1; Add 103 1; Div 113 29; Mul 35 0; Mul 35 1; Add 108 1;
  Add 108 1; Div 118 26; Mul 32 0; Mul 32 1; Add 113 1; Add 113 1; Sub 6 11; Sub 6 11; Sub 3 13;
  Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0; Add 120 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Div 131 89; Mul 95 0; Mul 95 1; Add 126 1; Add 126 1; Div 136 36; Mul 42 0; Mul 42 1; Add 131 1;
  Add 131 1; Sub 19 6; Sub 19 6; Sub 3 8; Sub 3 8; Mul 3 0; Mul 3 2; Sub 1 0; Add 138 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Div 149 93; Mul 99 0; Mul 99 1; Add 144 1; Add 144 1; Div 154 46; Mul 52 0; Mul 52 1; Add 149 1;
  Add 149 1; Sub 19 6; Sub 19 6; Sub 3 8; Sub 3 8; Mul 3 0; Mul 3 2; Sub 1 0; Add 156 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  ShowNonzero 160; (* as src/construct/packing.rs finds *)
  ShowNonzero 96; (* as src/construct/packing.rs finds *)
  Mul 154 58; Mul 91 54; Mul 92 50; Mul 58 58; Mul 58 58; Add 1 0; Mul 5 5; Sub 1 0; Div 175 170;
  Mul 1 0; Mul 60 60; Mul 60 60; Add 1 0; Mul 11 11; Sub 1 0; Mul 0 6; Mul 61 61; Mul 61 61;
  Add 1 0; Mul 16 16; Sub 1 0; Mul 0 12; Sub 6 12; Sub 1 13; Div 191 61; Mul 2 65; Mul 68 2;
  Sub 1 0; Mul 0 3; Mul 72 5; Mul 7 71; Sub 1 0; Mul 0 7; Mul 4 88; Mul 1 88; Add 1 0; Sub 26 0;
  Add 1 0; Sub 28 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 89; Mul 7 89; Add 1 0; Add 0 5; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 89; Mul 12 89; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 203 84; Mul 82 82; Mul 82 82; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 46; Mul 27 88; Mul 24 88;
  Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 151 91; Mul 89 89; Mul 89 89; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 58; Sub 46 12; Sub 1 13;
  Div 237 89; Mul 2 93; Mul 96 2; Sub 1 0; Mul 0 3; Mul 100 5; Mul 7 99; Sub 1 0; Mul 0 7;
  Mul 4 111; Mul 1 111; Add 1 0; Sub 26 0; Add 1 0; Sub 28 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 130; Mul 7 130; Add 1 0; Add 0 5; Sub 67 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 117; Mul 12 117; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 249 112; Mul 110 110; Mul 110 110; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 92; Mul 27 116;
  Mul 24 116; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 197 119; Mul 117 117; Mul 117 117; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 104; Sub 46 12;
  Sub 1 13; Div 283 117; Mul 2 121; Mul 124 2; Sub 1 0; Mul 0 3; Mul 128 5; Mul 7 127; Sub 1 0;
  Mul 0 7; Mul 4 139; Mul 1 139; Add 1 0; Sub 26 0; Add 1 0; Sub 28 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 158; Mul 7 158; Add 1 0; Add 0 5; Sub 67 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 145; Mul 12 145; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 308 238; Mul 244 0; Mul 244 1; Add 303 1; Add 303 1; Mul 300 4; Mul 2 2; Mul 2 2; Add 1 0;
  Mul 3 3; Sub 1 0; Mul 0 143; Mul 32 8; Mul 29 8; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 325 157; Div 326 109; Div 327 158; Div 328 158; Mul 3 1; Mul 206 0; Add 321 0; Sub 210 215;
  Mul 5 4; Neg 0; Mul 2 0; Add 4 0; Sub 202 215; Mul 9 11; Mul 1 0; Add 3 0; Sub 229 206;
  Mul 15 16; Neg 0; Mul 2 0; Add 4 0; Sub 0 336;
  ShowZero 0; (* as a test finds *)
  Mul 222 17; Add 338 0; Sub 226 231; Mul 0 15; Add 2 0; Sub 216 229; Mul 0 14; Add 2 0;
  Sub 242 219; Mul 0 12; Add 2 0; Sub 0 348;
  ShowZero 0; (* as a test finds *)
  Mul 169 29; Add 350 0; Sub 172 178; Mul 0 27; Add 2 0; Sub 141 175; Mul 0 26; Add 2 0;
  Sub 190 144; Mul 0 24; Add 2 0; Sub 0 360;
  ShowZero 0; (* as a test finds *)
  Div 371 108; Div 372 143; Mul 46 44; Mul 232 0; Add 365 0; Sub 236 254; Mul 48 4; Neg 0;
  Mul 2 0; Add 4 0; Sub 228 241; Mul 9 10; Mul 1 0; Add 3 0; Sub 250 232; Mul 14 59; Neg 0;
  Mul 2 0; Add 4 0; Sub 0 380;
  ShowZero 0; (* as a test finds *)
  Mul 248 17; Add 382 0; Sub 252 270; Mul 0 15; Add 2 0; Sub 242 255; Mul 0 14; Add 2 0;
  Sub 263 245; Mul 0 12; Add 2 0; Sub 0 392;
  ShowZero 0; (* as a test finds *)
  Mul 167 29; Add 394 0; Sub 170 216; Mul 0 27; Add 2 0; Sub 139 173; Mul 0 26; Add 2 0;
  Sub 188 142; Mul 0 24; Add 2 0; Sub 0 404;
  ShowZero 0; (* as a test finds *)
  Div 415 101; Div 416 141; Mul 45 44; Mul 258 0; Add 409 0; Sub 262 280; Mul 48 4; Neg 0;
  Mul 2 0; Add 4 0; Sub 113 267; Mul 9 10; Mul 1 0; Add 3 0; Sub 276 117; Mul 14 58; Neg 0;
  Mul 2 0; Add 4 0; Sub 0 424;
  ShowZero 0; (* as a test finds *)
  Mul 274 17; Add 426 0; Sub 278 296; Mul 0 15; Add 2 0; Sub 127 281; Mul 0 14; Add 2 0;
  Sub 289 130; Mul 0 12; Add 2 0; Sub 0 436;
  ShowZero 0; (* as a test finds *)
  Mul 165 29; Add 438 0; Sub 168 214; Mul 0 27; Add 2 0; Sub 132 171; Mul 0 26; Add 2 0;
  Sub 186 135; Mul 0 24; Add 2 0; Sub 0 448;
  ShowZero 0; (* as a test finds *)
  Sub 127 127;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 111 111;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 100 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 125 125;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 111 111;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 100 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 455 120; Sub 125 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 457 110; Sub 113 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 459 100; Sub 103 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 126; Sub 0 462;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 116; Sub 0 464;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 106; Sub 0 466;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 140 97; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 127 84; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 117 74; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 17 94; Add 6 100; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 85; Add 7 89; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 19 76; Add 8 80; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 103; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 93; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 83; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 74; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 61; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 51; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 71; Add 6 77; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 62; Add 7 66; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 53; Add 8 57; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 80; Sub 0 30;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 70; Sub 0 29;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 60; Sub 0 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 187 509; Sub 171 510; Sub 184 511; Sub 170 512; Mul 399 0; Mul 399 2; Sub 1 0; Add 516 0;
  Mul 7 400; Mul 7 402; Sub 1 0; Add 3 0; Sub 396 419; Sub 396 419; Sub 67 523; Sub 66 524;
  Mul 409 0; Mul 409 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 206 77; Sub 192 76; Sub 67 79; Sub 66 78; Mul 405 0; Mul 405 2; Sub 1 0; Add 540 0;
  Mul 7 406; Mul 7 408; Sub 1 0; Add 3 0; Sub 402 420; Sub 402 420; Sub 73 91; Sub 71 90;
  Mul 415 0; Mul 415 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 89 83; Sub 88 81; Sub 70 85; Sub 69 83; Mul 411 0; Mul 411 2; Sub 1 0; Add 564 0; Mul 7 412;
  Mul 7 414; Sub 1 0; Add 3 0; Sub 267 426; Sub 267 426; Sub 76 97; Sub 74 95; Mul 421 0;
  Mul 421 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Mul 265 567; Mul 0 424; Sub 0 569;
  ShowZero 0; (* radii *)
  Mul 267 570; Mul 0 378; Sub 0 572;
  ShowZero 0; (* radii *)
  Mul 225 573; Mul 0 335; Sub 0 575;
  ShowZero 0; (* radii *)
  Mul 184 576; Mul 0 287; Sub 0 578;
  ShowZero 0; (* radii *)
  Mul 275 579; Mul 0 435; Sub 0 581;
  ShowZero 0; (* radii *)
  Mul 277 582; Mul 0 437; Sub 0 584;
  ShowZero 0; (* radii *)
  Mul 236 585; Mul 0 381; Sub 0 587;
  ShowZero 0; (* radii *)
  Mul 195 588; Mul 0 338; Sub 0 590;
  ShowZero 0; (* radii *)
  Mul 605 591; Mul 150 592; Mul 149 593; Mul 148 594; Mul 135 595; Mul 133 596; Mul 131 597;
  Mul 117 598; Mul 115 599; Mul 113 600; Sub 8 9; Sub 8 10; Sub 8 11; Sub 8 12; Sub 8 13;
  Sub 8 14; Sub 8 15; Sub 8 16; Sub 8 17; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0;
  Mul 11 7; Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* row *)
  Mul 316 624; Mul 300 625; Mul 289 626; Mul 314 627; Mul 300 628; Mul 289 629; Mul 176 630;
  Mul 175 631; Mul 174 632; Mul 158 633; Mul 157 634; Mul 156 635; Sub 8 11; Sub 8 11; Sub 8 11;
  Sub 8 14; Sub 8 14; Sub 8 14; Sub 8 17; Sub 8 17; Sub 8 17; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5;
  Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 460 506; Sub 531 572; Sub 531 572; Sub 417 509; Sub 375 575; Sub 375 575; Sub 369 512;
  Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 167 6;
  Mul 167 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 564 587; Sub 564 587; Sub 471 523; Sub 549 590; Sub 549 590; Sub 428 526; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 386 6; Mul 370 4; Add 1 0;
  Mul 360 3; Add 1 0;
  ShowZero 0 (* row *)
].

Theorem part_3_size_2_valid : valid part_3_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the paraboloid; size 1.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/minimal/saddle.rs, src/construct/packing.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_4_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 1; Div 0 1; Constant 0; Mul 0 0; Sub 0 0; Mul 0 3; Neg 3; Mul 6 6; Sub 0 4; Mul 0 7;
  Sub 2 2; Mul 0 9; Neg 11; Sub 12 10; Sub 7 7; Sub 5 9; Sub 3 9; Sub 5 11; Mul 4 1; Mul 4 5;
  Sub 1 0; Div 20 0; Mul 6 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 11 13; Sub 1 0; Mul 0 7;
  Mul 4 27; Mul 1 24; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 35; Add 0 5; Add 0 4; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 27; Add 4 0; Add 0 8; Sub 31 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 40 36; Mul 0 43; Add 15 5; Add 0 13; Sub 2 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 45 45; Mul 48 48; Sub 1 0; Mul 0 50; Add 45 49; Sub 0 3; Mul 0 53; Mul 26 53; Add 26 0;
  Sub 5 0; Add 22 2; Add 0 1; Sub 5 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 54 54; Sub 0 12; Mul 0 62; Mul 35 64; Add 29 0; Add 0 8; Sub 3 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 65 61; Sub 0 19; Mul 0 69; Add 41 6; Add 0 14; Sub 2 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 75 75; Sub 0 72; Mul 0 75; Sub 2 70; Mul 0 77; Sub 80 79; Sub 3 71; Sub 2 72; Mul 2 66;
  Mul 69 3; Sub 1 0; Div 85 0; Mul 5 70; Mul 73 5; Sub 1 0; Mul 0 3; Mul 10 8; Mul 10 11; Sub 1 0;
  Mul 0 7; Mul 4 94; Mul 1 89; Add 1 0; Sub 88 0; Add 1 0; Sub 90 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 101; Add 0 5; Add 0 4; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 92; Add 4 0; Add 0 8; Sub 28 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 13 3; Add 0 11; Sub 99 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 36 108; Sub 0 62; Mul 0 112; Mul 20 112; Add 20 0; Sub 61 0; Add 16 2; Add 0 1; Sub 5 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 45 113; Sub 0 71; Mul 0 121; Mul 29 123; Add 23 0; Add 0 8; Sub 3 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 32 3; Add 0 11; Sub 65 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Constant 3; Mul 0 0; Sub 0 129; Mul 0 132; Sub 2 127; Mul 0 134; Sub 5 137; Sub 3 60; Sub 2 61;
  Mul 2 123; Mul 126 3; Sub 1 0; Div 142 0; Mul 5 127; Mul 130 5; Sub 1 0; Mul 0 3; Mul 10 8;
  Mul 10 11; Sub 1 0; Mul 0 7; Mul 4 152; Mul 1 146; Add 1 0; Sub 77 0; Add 1 0; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 26; Add 0 5; Add 0 4; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 149; Add 4 0; Add 0 8; Sub 28 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 13 3; Add 0 11; Sub 88 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 36 165; Sub 0 119; Mul 0 169; Mul 20 169; Add 20 0; Sub 59 0; Add 16 2; Add 0 1; Sub 5 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 45 170; Sub 0 128; Mul 0 178; Mul 29 180; Add 23 0; Add 0 8; Sub 3 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 32 3; Add 0 11; Sub 63 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Div 187 186; Mul 0 0; Mul 176 0; Add 188 0; Sub 191 191; Neg 3; Mul 1 0; Add 3 0; Sub 193 195;
  Mul 0 7; Add 2 0; Sub 196 196; Mul 0 6; Add 2 0; Sub 0 199;
  ShowZero 0; (* as a test finds *)
  Mul 3 13; Add 201 0; Mul 191 11; Add 1 0; Mul 14 17; Add 1 0; Mul 12 15; Add 1 0; Sub 0 208;
  ShowZero 0; (* as a test finds *)
  Sub 156 159; Mul 0 23; Add 211 0; Sub 150 159; Mul 0 22; Add 2 0; Sub 146 153; Mul 0 29;
  Add 2 0; Sub 168 149; Mul 0 28; Add 2 0; Sub 0 221;
  ShowZero 0; (* as a test finds *)
  Mul 144 35; Add 223 0; Sub 227 227; Mul 0 34; Add 2 0; Sub 229 230; Mul 0 41; Add 2 0; Add 0 38;
  Sub 0 231;
  ShowZero 0; (* as a test finds *)
  Sub 120 179; Mul 0 46; Add 234 0; Sub 114 123; Mul 0 45; Add 2 0; Sub 176 117; Mul 0 52;
  Add 2 0; Sub 188 179; Mul 0 51; Add 2 0; Sub 0 244;
  ShowZero 0; (* as a test finds *)
  Mul 110 58; Add 246 0; Sub 118 118; Mul 0 57; Add 2 0; Sub 253 121; Mul 0 64; Add 2 0; Add 0 27;
  Sub 0 254;
  ShowZero 0; (* as a test finds *)
  Sub 86 143; Mul 0 69; Add 257 0; Sub 80 89; Mul 0 68; Add 2 0; Sub 140 83; Mul 0 75; Add 2 0;
  Sub 152 143; Mul 0 74; Add 2 0; Sub 0 267;
  ShowZero 0; (* as a test finds *)
  Sub 79 79;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 67 67;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 58 58;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 78 78;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 68 68;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 58 58;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 274 76; Sub 79 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 276 69; Sub 71 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 278 58; Sub 61 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 82; Sub 0 281;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 75; Sub 0 283;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 64; Sub 0 285;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 97 63; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 86 87; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 78 56; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 99 63; Add 6 67; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 91 90; Add 7 93; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 83 58; Add 8 62; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 72; Sub 0 109;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 98; Sub 0 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 65; Sub 0 91;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 61; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 108; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 54; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 61; Add 6 65; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 111; Add 7 114; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 56; Add 8 60; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 70; Sub 0 30;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 119; Sub 0 29;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 63; Sub 0 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 139 328; Sub 127 329; Sub 137 330; Sub 127 331; Mul 321 0; Mul 136 2; Sub 1 0; Add 335 0;
  Mul 7 325; Mul 7 326; Sub 1 0; Add 3 0; Sub 65 340; Sub 64 341; Mul 331 0; Mul 332 2; Sub 1 0;
  Add 5 0; Mul 15 335; Mul 15 150; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 63 161; Sub 62 149; Sub 59 163; Sub 57 151; Mul 276 0; Mul 158 2; Sub 1 0; Add 357 0;
  Mul 7 347; Mul 7 281; Sub 1 0; Add 3 0; Sub 169 173; Sub 159 161; Mul 286 0; Mul 354 2; Sub 1 0;
  Add 5 0; Mul 15 357; Mul 15 179; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 64 85; Sub 63 84; Sub 60 87; Sub 58 86; Mul 241 0; Mul 180 2; Sub 1 0; Add 379 0; Mul 7 369;
  Mul 7 246; Sub 1 0; Add 3 0; Sub 91 97; Sub 89 96; Mul 251 0; Mul 376 2; Sub 1 0; Add 5 0;
  Mul 15 379; Mul 15 166; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 397 394; Sub 320 392; Sub 267 396; Sub 265 394; Mul 386 0; Mul 3 387; Sub 1 0; Mul 5 4;
  Mul 7 4; Sub 1 0; Mul 9 392; Mul 393 8; Sub 1 0; Mul 396 6; Mul 396 4; Add 1 0; Mul 397 3;
  Add 1 0;
  ShowZero 0; (* column *)
  Sub 402 402; Sub 404 370; Sub 337 371; Sub 281 372; Mul 3 0; Mul 2 4; Sub 1 0; Mul 4 22;
  Mul 25 4; Sub 1 0; Mul 27 9; Mul 10 26; Sub 1 0; Mul 414 6; Mul 13 4; Add 1 0; Mul 14 3;
  Add 1 0;
  ShowZero 0; (* column *)
  Sub 318 380; Sub 262 381; Mul 235 0; Mul 2 236; Sub 1 0; Mul 4 38; Mul 41 4; Sub 1 0;
  Mul 43 241; Mul 242 42; Sub 1 0; Mul 430 6; Mul 245 4; Add 1 0; Mul 234 3; Add 1 0;
  ShowZero 0; (* column *)
  Sub 384 377; Sub 326 378; Sub 270 379; Mul 259 0; Mul 2 260; Sub 1 0; Mul 4 55; Mul 58 4;
  Sub 1 0; Mul 60 265; Mul 266 59; Sub 1 0; Mul 447 6; Mul 269 4; Add 1 0; Mul 14 3; Add 1 0;
  ShowZero 0; (* column *)
  Mul 452 452; Sub 0 447; Mul 268 454; Sub 450 0; Add 2 0; Add 468 0; Mul 455 272; Sub 6 0;
  Mul 460 274; Sub 456 0; Add 2 0; Add 5 0; Constant 4; Div 478 0; Mul 2 0;
  ShowZero 0; (* area(F, S) *)
  Mul 400 467; Sub 0 397; Mul 283 402; Sub 400 0; Add 2 0; Add 483 0; Mul 470 294; Sub 6 0;
  Mul 475 296; Sub 406 0; Add 2 0; Add 5 0; Mul 0 13;
  ShowZero 0; (* area(F, S) *)
  Mul 356 480; Sub 0 353; Mul 296 358; Sub 356 0; Add 2 0; Add 496 0; Mul 483 272; Sub 6 0;
  Mul 488 274; Sub 362 0; Add 2 0; Add 5 0; Mul 0 26;
  ShowZero 0; (* area(F, S) *)
  Mul 307 27; Sub 308 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 494 1;
  ShowZero 0; (* the Christoffel dual *)
  Sub 504 504; Sub 0 3;
  ShowZero 0; (* the Christoffel dual *)
  Mul 168 32; Sub 313 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 169 34; Sub 498 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 470 510; Sub 235 514; Mul 0 38; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 188 40; Sub 507 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 189 42; Sub 508 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 309 521; Mul 0 45; Sub 510 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 193 47; Sub 514 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 194 49; Sub 513 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 313 528; Mul 0 52; Sub 515 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 244 531; Mul 0 55; Sub 138 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 245 534; Mul 0 58; Sub 524 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 246 537; Mul 0 61; Sub 143 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 247 540; Mul 0 64; Sub 147 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 247 543; Mul 0 67; Sub 531 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 469 543; Sub 248 547; Mul 0 71; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 242 550; Mul 0 74; Sub 155 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 243 553; Mul 0 77; Sub 543 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 244 556; Mul 0 80; Sub 160 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 245 559; Mul 0 83; Sub 164 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 245 562; Mul 0 86; Sub 550 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 431 562; Sub 246 566; Mul 0 90; Sub 2 0;
  ShowZero 0 (* the Christoffel dual *)
].

Theorem part_4_size_1_valid : valid part_4_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the paraboloid; size 2.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/construct/minimal/saddle.rs, src/construct/packing.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_4_size_2 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 1; Div 0 1; Constant 0; Mul 0 0; Sub 0 0; Mul 0 3; Neg 3; Mul 6 6; Sub 0 4; Mul 0 7;
  Sub 2 2; Mul 0 9; Neg 11; Sub 12 10; Sub 7 7; Sub 5 9; Sub 3 9; Sub 5 11; Mul 4 1; Mul 4 5;
  Sub 1 0; Div 20 0; Mul 6 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 12 8; Mul 11 13; Sub 1 0; Mul 0 7;
  Mul 4 27; Mul 1 24; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 35; Add 0 5; Add 0 4; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 27; Add 4 0; Add 0 8; Sub 31 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 40 36; Mul 0 43; Add 15 5; Add 0 13; Sub 2 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Add 45 45; Mul 48 48; Sub 1 0; Mul 0 50; Add 45 49; Sub 0 3; Mul 0 53; Mul 26 53; Add 26 0;
  Sub 5 0; Add 22 2; Add 0 1; Sub 5 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 54 54; Sub 0 12; Mul 0 62; Mul 35 64; Add 29 0; Add 0 8; Sub 3 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 65 61; Sub 0 19; Mul 0 69; Add 41 6; Add 0 14; Sub 2 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 75 75; Sub 68 0; Mul 0 75; Neg 78; Sub 66 66; Sub 68 34; Sub 2 68; Sub 4 36; Mul 69 1;
  Mul 4 70; Sub 1 0; Div 85 0; Mul 6 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 77 8; Mul 11 78; Sub 1 0;
  Mul 0 7; Mul 4 92; Mul 1 83; Add 1 0; Sub 52 0; Add 1 0; Sub 54 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 100; Add 0 5; Add 0 4; Sub 92 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 26; Add 4 0; Add 0 8; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 105 33; Mul 0 108; Add 15 5; Add 0 13; Sub 2 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 19 113; Add 19 0; Sub 44 0; Add 15 2; Add 0 1; Sub 54 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 112 44; Sub 0 70; Mul 0 120; Mul 28 123; Add 22 0; Add 0 8; Sub 3 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 123 51; Sub 0 77; Mul 0 127; Add 34 6; Add 0 14; Sub 2 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Constant 3; Mul 0 0; Sub 127 0; Mul 0 134; Neg 3; Sub 59 59; Sub 61 28; Sub 2 61; Sub 4 30;
  Mul 128 1; Mul 4 129; Sub 1 0; Div 144 0; Mul 6 5; Mul 8 5; Sub 1 0; Mul 0 3; Mul 136 8;
  Mul 11 137; Sub 1 0; Mul 0 7; Mul 4 151; Mul 1 76; Add 1 0; Sub 46 0; Add 1 0; Sub 48 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 159; Add 0 5; Add 0 4; Sub 85 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 26; Add 4 0; Add 0 8; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 164 33; Mul 0 167; Add 15 5; Add 0 13; Sub 2 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 19 173; Add 19 0; Sub 45 0; Add 15 2; Add 0 1; Sub 55 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 171 44; Sub 0 129; Mul 0 179; Mul 28 48; Add 22 0; Add 0 8; Sub 3 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 182 51; Sub 0 136; Mul 0 186; Add 34 6; Add 0 14; Sub 2 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Div 191 190; Mul 0 0; Mul 180 0; Add 192 0; Sub 195 195; Neg 3; Mul 1 0; Add 3 0; Sub 197 199;
  Mul 0 7; Add 2 0; Sub 200 200; Mul 0 6; Add 2 0; Sub 0 203;
  ShowZero 0; (* as a test finds *)
  Mul 3 13; Add 205 0; Mul 195 11; Add 1 0; Mul 14 17; Add 1 0; Mul 12 15; Add 1 0; Sub 0 212;
  ShowZero 0; (* as a test finds *)
  Sub 160 163; Mul 0 23; Add 215 0; Sub 154 163; Mul 0 22; Add 2 0; Sub 150 157; Mul 0 29;
  Add 2 0; Sub 172 153; Mul 0 28; Add 2 0; Sub 0 225;
  ShowZero 0; (* as a test finds *)
  Add 226 17; Sub 230 229; Mul 0 33; Add 2 0; Sub 233 233; Mul 0 40; Add 2 0; Sub 235 236;
  Mul 0 39; Add 2 0; Sub 0 236;
  ShowZero 0; (* as a test finds *)
  Sub 175 168; Mul 0 47; Add 239 0; Sub 120 178; Mul 0 46; Add 2 0; Sub 116 123; Mul 0 53;
  Add 2 0; Sub 177 119; Mul 0 52; Add 2 0; Sub 0 249;
  ShowZero 0; (* as a test finds *)
  Add 250 18; Sub 120 254; Mul 0 57; Add 2 0; Sub 123 123; Mul 0 64; Add 2 0; Sub 260 126;
  Mul 0 63; Add 2 0; Sub 0 260;
  ShowZero 0; (* as a test finds *)
  Sub 141 134; Mul 0 71; Add 263 0; Sub 85 144; Mul 0 70; Add 2 0; Sub 81 88; Mul 0 77; Add 2 0;
  Sub 143 84; Mul 0 76; Add 2 0; Sub 0 273;
  ShowZero 0; (* as a test finds *)
  Sub 81 81;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 69 69;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 60 60;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 80 80;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 70 70;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 60 60;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 280 78; Sub 81 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 282 71; Sub 73 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 284 60; Sub 63 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 84; Sub 0 287;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 77; Sub 0 289;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 66; Sub 0 291;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 95 96; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 86 65; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 77 54; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 17 96; Add 6 100; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 66; Add 7 70; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 19 56; Add 8 60; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 105; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 74; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 63; Sub 0 27;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 117; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 62; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 20 51; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 117; Add 6 121; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 63; Add 7 67; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 20 53; Add 8 57; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 126; Sub 0 30;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 71; Sub 0 29;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 60; Sub 0 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 141 334; Sub 129 335; Sub 139 336; Sub 129 337; Mul 327 0; Mul 138 2; Sub 1 0; Add 341 0;
  Mul 7 331; Mul 7 332; Sub 1 0; Add 3 0; Sub 65 346; Sub 64 347; Mul 337 0; Mul 338 2; Sub 1 0;
  Add 5 0; Mul 15 341; Mul 15 152; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 159 75; Sub 149 74; Sub 65 77; Sub 64 76; Mul 349 0; Mul 167 2; Sub 1 0; Add 363 0;
  Mul 7 136; Mul 7 354; Sub 1 0; Add 3 0; Sub 69 87; Sub 67 86; Mul 359 0; Mul 143 2; Sub 1 0;
  Add 5 0; Mul 15 146; Mul 15 174; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 85 79; Sub 84 77; Sub 66 81; Sub 65 79; Mul 371 0; Mul 152 2; Sub 1 0; Add 385 0; Mul 7 134;
  Mul 7 376; Sub 1 0; Add 3 0; Sub 70 91; Sub 68 89; Mul 381 0; Mul 141 2; Sub 1 0; Add 5 0;
  Mul 15 144; Mul 15 196; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 357 397; Sub 325 397; Sub 294 399; Sub 268 399; Sub 237 401; Mul 3 0; Mul 3 2; Sub 1 0;
  Mul 5 207; Mul 208 4; Sub 1 0; Mul 210 7; Mul 10 211; Sub 1 0; Mul 213 6; Mul 401 4; Add 1 0;
  Mul 16 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 410 412; Sub 345 413; Sub 287 414; Mul 20 0; Mul 2 19; Sub 1 0; Mul 4 231; Mul 232 4;
  Sub 1 0; Mul 234 24; Mul 27 235; Sub 1 0; Mul 237 6; Mul 418 4; Add 1 0; Mul 14 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 367 386; Sub 440 437; Sub 311 388; Sub 308 439; Sub 254 390; Mul 3 0; Mul 3 2; Sub 1 0;
  Mul 5 243; Mul 244 4; Sub 1 0; Mul 246 7; Mul 10 247; Sub 1 0; Mul 249 6; Mul 440 4; Add 1 0;
  Mul 16 3; Add 1 0;
  ShowZero 0; (* row *)
  Sub 335 402; Sub 277 403; Mul 19 0; Mul 2 18; Sub 1 0; Mul 4 266; Mul 267 4; Sub 1 0;
  Mul 269 23; Mul 26 270; Sub 1 0; Mul 272 6; Mul 456 4; Add 1 0; Mul 252 3; Add 1 0;
  ShowZero 0; (* row *)
  Mul 460 460; Sub 0 455; Mul 272 462; Sub 458 0; Add 2 0; Add 476 0; Mul 463 276; Sub 6 0;
  Mul 468 278; Sub 464 0; Add 2 0; Add 5 0; Constant 4; Div 486 0; Mul 2 0;
  ShowZero 0; (* area(F, S) *)
  Mul 475 258; Sub 0 405; Mul 294 477; Sub 408 0; Add 2 0; Add 491 0; Mul 413 291; Sub 6 0;
  Mul 266 293; Sub 414 0; Add 2 0; Add 5 0; Mul 0 13;
  ShowZero 0; (* area(F, S) *)
  Mul 488 247; Sub 0 359; Mul 270 490; Sub 362 0; Add 2 0; Add 504 0; Mul 367 304; Sub 6 0;
  Mul 255 306; Sub 368 0; Add 2 0; Add 5 0; Mul 0 26;
  ShowZero 0; (* area(F, S) *)
  Mul 311 27; Sub 312 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 502 1;
  ShowZero 0; (* the Christoffel dual *)
  Sub 512 512; Sub 0 3;
  ShowZero 0; (* the Christoffel dual *)
  Mul 170 32; Sub 317 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 171 34; Sub 506 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 236 521; Mul 0 37; Sub 122 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 225 524; Mul 0 40; Sub 325 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 225 527; Mul 0 43; Sub 127 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 225 530; Mul 0 46; Sub 129 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 213 533; Mul 0 49; Sub 334 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 213 536; Mul 0 52; Sub 134 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 213 539; Mul 0 55; Sub 136 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 207 57; Sub 532 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 208 59; Sub 533 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 330 546; Mul 0 62; Sub 535 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 212 64; Sub 539 0;
  ShowZero 0; (* the Christoffel dual *)
  Mul 213 66; Sub 538 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 334 553; Mul 0 69; Sub 540 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 263 556; Mul 0 72; Sub 547 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 264 559; Mul 0 75; Sub 159 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 487 559; Sub 266 563; Mul 0 79; Sub 2 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 252 566; Mul 0 82; Sub 557 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 253 569; Mul 0 85; Sub 167 0;
  ShowZero 0; (* the Christoffel dual *)
  Sub 438 569; Sub 255 573; Mul 0 89; Sub 2 0;
  ShowZero 0 (* the Christoffel dual *)
].

Theorem part_4_size_2_valid : valid part_4_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
