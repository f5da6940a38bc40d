(** fig-9-concurrent (Sec. 4, Fig. 9)

    In the metric duals of these meshes the planes of all faces along a row or a column pass
    through one point, which may be at infinity; for the Enneper surface it is known.

        row y: (0, 1/(2y), -y²/3 - 1/24)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the dual of the Enneper surface; size 1.
    Code: src/construct/minimal/enneper.rs, src/construct/packing.rs, src/scalar/ring.rs,
    src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 3;
  Nonzero 0; (* 3 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 1; Div 0 4; Constant 0; Add 0 1; Sub 5 0; Sub 5 1; Mul 1 1;
  Mul 1 1; Add 1 0; Mul 7 7; Sub 1 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 10 9; Sub 12 0; Mul 0 0; Add 7 0; Sub 0 5;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 19 14; Sub 17 0; Mul 0 0; Add 12 0; Sub 0 10;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 23 19; Sub 22 0; Mul 0 0; Add 17 0; Sub 0 15;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Constant 4; Add 0 25; Sub 28 0; Mul 0 0; Add 23 0; Sub 0 21;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 31 29; Add 30 30; Sub 35 1; Sub 35 1; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 29;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 41 28; Mul 0 0; Add 0 34; Sub 0 33;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 44 11; Mul 0 0; Add 9 0; Sub 0 37;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 34; Sub 0 39;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 53 47; Sub 51 0; Mul 0 0; Add 16 0; Sub 0 44;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 13 36; Sub 0 46;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 59 54; Sub 58 0; Mul 0 0; Add 23 0; Sub 0 51;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 20 38; Sub 0 53;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 37 61; Sub 65 0; Mul 0 0; Add 30 0; Sub 0 58;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 27 39; Sub 0 60;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 72 20; Mul 0 0; Add 0 35; Sub 0 64;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 2 29; Sub 0 66;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 4 24; Sub 0 68;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 19; Sub 0 70;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 8 14; Sub 0 72;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 84 66; Mul 0 0; Add 0 77; Sub 0 76;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 2 73; Sub 0 78;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 90 31; Mul 0 0; Add 0 53; Sub 0 82;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 94 71; Mul 0 0; Add 0 87; Sub 0 86;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 51; Sub 0 88;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 4 85; Sub 0 90;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 102 36; Mul 0 0; Add 0 65; Sub 0 94;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 106 77; Mul 0 0; Add 0 99; Sub 0 98;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 63; Sub 0 100;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 4 97; Sub 0 102;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Constant 5; Add 0 111; Sub 116 0; Mul 0 0; Add 0 79; Sub 0 108;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 2 73; Sub 0 110;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Div 120 94; Sub 118 123; Sub 119 123; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 116 128; Mul 0 0; Add 5 0; Sub 0 9;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 115 132; Mul 0 0; Add 9 0; Sub 0 13;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 114 136; Mul 0 0; Add 13 0; Sub 0 17;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 112 140; Mul 0 0; Add 17 0; Sub 0 21;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 132 145; Mul 0 0; Add 0 20; Sub 0 25;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 2 18; Sub 0 27;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 4 16; Sub 0 29;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 6 14; Sub 0 31;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 8 12; Sub 0 33;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Div 155 158; Constant 12; Div 157 0; Sub 156 160; Sub 157 160; Mul 1 1; Mul 1 1; Mul 1 6;
  Sub 1 0; Add 0 6; Mul 6 0; Mul 4 10; Sub 0 6; Sub 0 10; Mul 9 0; Mul 172 4; Mul 172 1; Add 1 0;
  Sub 11 12; Mul 0 173; Add 0 2; Sub 176 178; Mul 0 0; Mul 0 22; Sub 17 0; Add 0 22; Mul 4 0;
  Sub 15 4; Sub 0 25; Mul 24 0; Mul 187 3; Mul 187 1; Add 1 0; Sub 26 10; Mul 0 188; Add 0 2;
  Sub 191 192; Mul 0 0; Sub 0 14; Add 0 36; Mul 18 0; Mul 3 40; Sub 0 19; Sub 0 40; Mul 7 0;
  Mul 202 4; Mul 202 1; Add 1 0; Sub 10 25; Mul 0 203; Add 0 2; Sub 24 40; Sub 22 37; Sub 17 32;
  Sub 13 43; Sub 10 40; Sub 5 35; Mul 5 1; Mul 5 3; Sub 1 0; Div 215 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 58; Mul 1 55; Add 1 0; Sub 51 0; Add 1 0;
  Sub 53 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 48; Mul 7 46; Add 1 0; Add 0 5; Sub 43 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 77; Add 0 83; Mul 83 0; Sub 46 82; Sub 0 86; Mul 53 0; Mul 248 3; Mul 248 1; Add 1 0;
  Sub 56 88; Mul 0 249; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 261 258; Mul 0 0; Sub 0 80; Add 0 102; Mul 84 0; Mul 3 106; Sub 0 85; Sub 0 106; Mul 7 0;
  Mul 268 4; Mul 268 1; Add 1 0; Sub 10 91; Mul 0 269; Add 0 2; Sub 76 29; Sub 73 27; Sub 68 22;
  Sub 13 32; Sub 10 30; Sub 5 25; Mul 5 1; Mul 5 3; Sub 1 0; Div 281 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 47; Mul 1 45; Add 1 0; Sub 41 0; Add 1 0;
  Sub 43 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 100; Mul 7 97; Add 1 0; Add 0 5; Sub 94 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 143; Add 0 149; Mul 149 0; Sub 46 148; Sub 0 152; Mul 53 0; Mul 314 3; Mul 314 1;
  Add 1 0; Sub 56 154; Mul 0 315; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 326 324; Mul 0 0; Sub 0 146; Add 0 168; Mul 150 0; Mul 3 172; Sub 0 151; Sub 0 172; Mul 7 0;
  Mul 334 4; Mul 334 1; Add 1 0; Sub 10 157; Mul 0 335; Add 0 2; Sub 76 29; Sub 73 27; Sub 68 22;
  Sub 13 32; Sub 10 30; Sub 5 25; Mul 5 1; Mul 5 3; Sub 1 0; Div 347 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 47; Mul 1 45; Add 1 0; Sub 41 0; Add 1 0;
  Sub 43 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 100; Mul 7 97; Add 1 0; Add 0 5; Sub 94 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 209; Add 0 215; Mul 215 0; Sub 46 214; Sub 0 218; Mul 53 0; Mul 380 3; Mul 380 1;
  Add 1 0; Sub 56 220; Mul 0 381; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 363 390; Mul 0 0; Sub 0 212; Add 0 234; Mul 216 0; Mul 3 238; Sub 0 217; Sub 0 238; Mul 7 0;
  Mul 400 4; Mul 400 1; Add 1 0; Sub 10 223; Mul 0 401; Add 0 2; Sub 76 29; Sub 73 27; Sub 68 22;
  Sub 13 32; Sub 10 30; Sub 5 25; Mul 5 1; Mul 5 3; Sub 1 0; Div 413 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 47; Mul 1 45; Add 1 0; Sub 41 0; Add 1 0;
  Sub 43 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 100; Mul 7 97; Add 1 0; Add 0 5; Sub 94 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 275; Add 0 281; Mul 281 0; Sub 46 280; Sub 0 284; Mul 53 0; Mul 446 3; Mul 446 1;
  Add 1 0; Sub 56 286; Mul 0 447; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 342 456; Mul 0 0; Sub 0 278; Add 0 300; Mul 282 0; Mul 3 304; Sub 0 283; Sub 0 304; Mul 7 0;
  Mul 466 4; Mul 466 1; Add 1 0; Sub 10 289; Mul 0 467; Add 0 2; Sub 76 29; Sub 73 27; Sub 68 22;
  Sub 13 32; Sub 10 30; Sub 5 25; Mul 5 1; Mul 5 3; Sub 1 0; Div 479 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 47; Mul 1 45; Add 1 0; Sub 41 0; Add 1 0;
  Sub 43 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 100; Mul 7 97; Add 1 0; Add 0 5; Sub 94 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 47 341; Add 0 347; Mul 347 0; Sub 46 346; Sub 0 350; Mul 53 0; Mul 512 3; Mul 512 1;
  Add 1 0; Sub 56 352; Mul 0 513; Add 0 2; Mul 32 9; Mul 29 7; Add 1 0; Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 525 523; Mul 0 0; Mul 0 367; Sub 362 0; Add 0 367; Mul 4 0; Sub 360 4; Sub 0 370; Mul 369 0;
  Mul 532 3; Mul 532 1; Add 1 0; Sub 371 10; Mul 0 533; Add 0 2; Sub 343 12; Add 0 379; Mul 16 0;
  Sub 342 16; Sub 0 382; Mul 349 0; Mul 544 3; Mul 544 1; Add 1 0; Sub 352 22; Mul 0 545; Add 0 2;
  Sub 21 366; Sub 19 364; Sub 14 359; Sub 12 369; Sub 10 367; Sub 5 362; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 557 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 384; Mul 1 382; Add 1 0; Sub 378 0; Add 1 0; Sub 380 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 45; Mul 7 43; Add 1 0; Add 0 5; Sub 40 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 386; Mul 17 383; Add 1 0; Add 0 15; Sub 380 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 328 63; Add 0 430; Mul 67 0; Sub 327 67; Sub 0 433; Mul 334 0; Mul 595 3; Mul 595 1;
  Add 1 0; Sub 337 73; Mul 0 596; Add 0 2; Sub 60 403; Sub 58 400; Sub 53 395; Sub 12 406;
  Sub 10 403; Sub 5 398; Mul 5 1; Mul 5 3; Sub 1 0; Div 608 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 421; Mul 1 418; Add 1 0; Sub 414 0; Add 1 0;
  Sub 416 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 84; Mul 7 82; Add 1 0; Add 0 5; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 371; Mul 17 368; Add 1 0; Add 0 15; Sub 365 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 313 114; Add 0 481; Mul 118 0; Sub 312 118; Sub 0 484; Mul 319 0; Mul 646 3; Mul 646 1;
  Add 1 0; Sub 322 124; Mul 0 647; Add 0 2; Sub 60 388; Sub 58 385; Sub 53 380; Sub 12 391;
  Sub 10 388; Sub 5 383; Mul 5 1; Mul 5 3; Sub 1 0; Div 659 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 406; Mul 1 403; Add 1 0; Sub 399 0; Add 1 0;
  Sub 401 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 84; Mul 7 82; Add 1 0; Add 0 5; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 356; Mul 17 353; Add 1 0; Add 0 15; Sub 350 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 298 165; Add 0 532; Mul 169 0; Sub 297 169; Sub 0 535; Mul 304 0; Mul 697 3; Mul 697 1;
  Add 1 0; Sub 307 175; Mul 0 698; Add 0 2; Sub 60 373; Sub 58 370; Sub 53 365; Sub 12 376;
  Sub 10 373; Sub 5 368; Mul 5 1; Mul 5 3; Sub 1 0; Div 710 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 391; Mul 1 388; Add 1 0; Sub 384 0; Add 1 0;
  Sub 386 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 84; Mul 7 82; Add 1 0; Add 0 5; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 341; Mul 17 338; Add 1 0; Add 0 15; Sub 335 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 283 216; Add 0 583; Mul 220 0; Sub 282 220; Sub 0 586; Mul 289 0; Mul 748 3; Mul 748 1;
  Add 1 0; Sub 292 226; Mul 0 749; Add 0 2; Sub 60 358; Sub 58 355; Sub 53 350; Sub 12 361;
  Sub 10 358; Sub 5 353; Mul 5 1; Mul 5 3; Sub 1 0; Div 761 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 376; Mul 1 373; Add 1 0; Sub 369 0; Add 1 0;
  Sub 371 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 84; Mul 7 82; Add 1 0; Add 0 5; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 326; Mul 17 323; Add 1 0; Add 0 15; Sub 320 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 563; Neg 222; Neg 172; Sub 232 574; Sub 229 571; Sub 3 4; Sub 184 577; Sub 181 574; Sub 5 7;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 803 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 592; Mul 1 589; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 256; Mul 7 253; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 210; Mul 12 207; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 534; Mul 21 543; Mul 18 540; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 162; Sub 222 549; Sub 219 546; Sub 43 8; Sub 174 552; Sub 171 549; Sub 5 11; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 844 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 567; Mul 1 564; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 246; Mul 7 243; Add 1 0; Add 0 5; Sub 69 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 200; Mul 12 197; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 509; Mul 21 518; Mul 18 515; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 152; Sub 212 524; Sub 209 521; Sub 43 8; Sub 164 527; Sub 161 524; Sub 5 11; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 885 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 542; Mul 1 539; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 236; Mul 7 233; Add 1 0; Add 0 5; Sub 69 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 190; Mul 12 187; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 484; Mul 21 493; Mul 18 490; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 142; Sub 202 499; Sub 199 496; Sub 43 8; Sub 154 502; Sub 151 499; Sub 5 11; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 926 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 517; Mul 1 514; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 226; Mul 7 223; Add 1 0; Add 0 5; Sub 69 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 180; Mul 12 177; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 459; Mul 21 468; Mul 18 465; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 941 959; Mul 0 0; Add 0 834; Sub 0 839;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 2 832; Sub 0 841;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 942 965; Mul 0 0; Add 0 840; Sub 0 845;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 2 838; Sub 0 847;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 942 971; Mul 0 0; Add 0 846; Sub 0 851;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 2 844; Sub 0 853;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 978 977; Mul 0 0; Mul 0 821; Sub 816 0; Add 0 821; Mul 4 0; Sub 814 4; Sub 0 824; Mul 823 0;
  Mul 986 3; Mul 986 1; Add 1 0; Sub 825 10; Mul 0 987; Add 0 2; Sub 797 12; Add 0 833; Mul 16 0;
  Sub 796 16; Sub 0 836; Mul 803 0; Mul 998 3; Mul 998 1; Add 1 0; Sub 806 22; Mul 0 999; Add 0 2;
  Sub 21 475; Sub 19 473; Sub 14 468; Sub 12 478; Sub 10 476; Sub 5 471; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 1011 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 493; Mul 1 491; Add 1 0; Sub 487 0; Add 1 0; Sub 489 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 45; Mul 7 43; Add 1 0; Add 0 5; Sub 40 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 497; Mul 17 495; Add 1 0; Add 0 15; Sub 492 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 782 63; Add 0 884; Mul 67 0; Sub 781 67; Sub 0 887; Mul 788 0; Mul 1049 3; Mul 1049 1;
  Add 1 0; Sub 791 73; Mul 0 1050; Add 0 2; Sub 60 514; Sub 58 512; Sub 53 507; Sub 12 517;
  Sub 10 515; Sub 5 510; Mul 5 1; Mul 5 3; Sub 1 0; Div 1062 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 532; Mul 1 530; Add 1 0; Sub 526 0;
  Add 1 0; Sub 528 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 84; Mul 7 82; Add 1 0; Add 0 5; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 497; Mul 17 495; Add 1 0; Add 0 15; Sub 492 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 1066 1094; Mul 0 0; Mul 0 938; Sub 933 0; Add 0 938; Mul 4 0; Sub 931 4; Sub 0 941;
  Mul 940 0; Mul 1103 3; Mul 1103 1; Add 1 0; Sub 942 10; Mul 0 1104; Add 0 2; Sub 914 12;
  Add 0 950; Mul 16 0; Sub 913 16; Sub 0 953; Mul 920 0; Mul 1115 3; Mul 1115 1; Add 1 0;
  Sub 923 22; Mul 0 1116; Add 0 2; Sub 21 138; Sub 19 136; Sub 14 131; Sub 12 141; Sub 10 139;
  Sub 5 134; Mul 5 1; Mul 5 3; Sub 1 0; Div 1128 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8;
  Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 156; Mul 1 154; Add 1 0; Sub 150 0; Add 1 0; Sub 152 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 45; Mul 7 43; Add 1 0; Add 0 5; Sub 40 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 160; Mul 17 158; Add 1 0; Add 0 15; Sub 155 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 899 63; Add 0 1001; Mul 67 0; Sub 898 67; Sub 0 1004; Mul 905 0; Mul 1166 3; Mul 1166 1;
  Add 1 0; Sub 908 73; Mul 0 1167; Add 0 2; Sub 60 177; Sub 58 175; Sub 53 170; Sub 12 180;
  Sub 10 178; Sub 5 173; Mul 5 1; Mul 5 3; Sub 1 0; Div 1179 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 195; Mul 1 193; Add 1 0; Sub 189 0;
  Add 1 0; Sub 191 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 84; Mul 7 82; Add 1 0; Add 0 5; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 160; Mul 17 158; Add 1 0; Add 0 15; Sub 155 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 1096 1211; Mul 0 0; Mul 0 1055; Sub 1050 0; Add 0 1055; Mul 4 0; Sub 1048 4; Sub 0 1058;
  Mul 1057 0; Mul 1220 3; Mul 1220 1; Add 1 0; Sub 1059 10; Mul 0 1221; Add 0 2; Sub 1031 12;
  Add 0 1067; Mul 16 0; Sub 1030 16; Sub 0 1070; Mul 1037 0; Mul 1232 3; Mul 1232 1; Add 1 0;
  Sub 1040 22; Mul 0 1233; Add 0 2; Sub 21 138; Sub 19 136; Sub 14 131; Sub 12 141; Sub 10 139;
  Sub 5 134; Mul 5 1; Mul 5 3; Sub 1 0; Div 1245 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8;
  Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 156; Mul 1 154; Add 1 0; Sub 150 0; Add 1 0; Sub 152 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 45; Mul 7 43; Add 1 0; Add 0 5; Sub 40 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 160; Mul 17 158; Add 1 0; Add 0 15; Sub 155 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 1016 63; Add 0 1118; Mul 67 0; Sub 1015 67; Sub 0 1121; Mul 1022 0; Mul 1283 3; Mul 1283 1;
  Add 1 0; Sub 1025 73; Mul 0 1284; Add 0 2; Sub 60 177; Sub 58 175; Sub 53 170; Sub 12 180;
  Sub 10 178; Sub 5 173; Mul 5 1; Mul 5 3; Sub 1 0; Div 1296 0; Mul 7 5; Mul 9 5; Sub 1 0;
  Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 195; Mul 1 193; Add 1 0; Sub 189 0;
  Add 1 0; Sub 191 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 84; Mul 7 82; Add 1 0; Add 0 5; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 36; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 160; Mul 17 158; Add 1 0; Add 0 15; Sub 155 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 302; Neg 252; Sub 312 766; Sub 309 763; Sub 3 537; Sub 264 769; Sub 261 766; Sub 5 540;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 1337 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 784; Mul 1 781; Add 1 0; Sub 556 0; Add 1 0; Sub 558 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 336; Mul 7 333; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 290; Mul 12 287; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 749; Mul 17 746; Add 1 0; Add 0 15; Sub 572 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 226; Neg 176; Sub 236 353; Sub 233 350; Sub 3 44; Sub 188 356; Sub 185 353; Sub 5 47;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 1378 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 371; Mul 1 368; Add 1 0; Sub 63 0; Add 1 0; Sub 65 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 260; Mul 7 257; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 214; Mul 12 211; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 336; Mul 17 333; Add 1 0; Add 0 15; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 150; Neg 100; Sub 160 277; Sub 157 274; Sub 3 44; Sub 112 280; Sub 109 277; Sub 5 47;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 1419 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 295; Mul 1 292; Add 1 0; Sub 63 0; Add 1 0; Sub 65 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 184; Mul 7 181; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 138; Mul 12 135; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 260; Mul 17 257; Add 1 0; Add 0 15; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 600 641; Sub 597 638; Sub 594 635; Sub 562 644; Sub 559 641; Sub 556 638; Sub 524 647;
  Sub 521 644; Sub 518 641; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* through one point *)
  Constant 24; Div 1473 0; Add 1295 0; Mul 667 1477; Mul 664 1477; Add 1 0; Sub 3 0; Sub 0 663;
  Mul 0 1303; Mul 0 1485; Sub 0 674;
  ShowZero 0; (* the point *)
  Mul 634 1485; Mul 631 1485; Add 1 0; Sub 11 0; Sub 0 630; Mul 0 1311; Mul 0 1493; Sub 0 641;
  ShowZero 0; (* the point *)
  Mul 601 1493; Mul 598 1493; Add 1 0; Sub 19 0; Sub 0 597; Mul 0 1319; Mul 0 1501; Sub 0 608;
  ShowZero 0; (* the point *)
  Mul 568 1501; Mul 565 1501; Add 1 0; Sub 27 0; Sub 0 564; Mul 0 1327; Mul 0 1509; Sub 0 575;
  ShowZero 0; (* the point *)
  Sub 165 699; Sub 162 696; Sub 159 693; Sub 127 702; Sub 124 699; Sub 121 696; Sub 89 705;
  Sub 86 702; Sub 83 699; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* through one point *)
  Add 1333 56; Neg 0; Sub 0 54; Sub 0 717; Mul 0 1342; Mul 0 1539; Sub 0 724;
  ShowZero 0; (* the point *)
  Mul 195 1539; Mul 192 1539; Add 1 0; Sub 8 0; Sub 0 191; Mul 0 1350; Mul 0 1547; Sub 0 198;
  ShowZero 0; (* the point *)
  Mul 162 1547; Mul 159 1547; Add 1 0; Sub 16 0; Sub 0 158; Mul 0 1358; Mul 0 1555; Sub 0 165;
  ShowZero 0; (* the point *)
  Mul 129 1555; Mul 126 1555; Add 1 0; Sub 24 0; Sub 0 125; Mul 0 1366; Mul 0 1563; Sub 0 132;
  ShowZero 0 (* the point *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the dual of the logarithmoid; size 1.
    Code: src/construct/minimal/logarithmoid.rs, src/construct/packing.rs, src/scalar/ring.rs,
    src/space/duality.rs, src/space/gradient.rs, src/space/motion.rs, src/space/plane.rs,
    src/space/point.rs *)
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
  Mul 72 65; Mul 70 63; Sub 1 0; Mul 72 68; Mul 76 66; Add 1 0; Mul 81 3; Mul 82 1; Mul 1 55;
  Mul 1 56; Sub 53 16; Sub 53 16; Sub 3 18; Sub 3 18; Mul 3 0; Mul 3 2; Sub 1 0; Div 105 0;
  Mul 57 4; Mul 7 58; Sub 1 0; Mul 0 3; Mul 11 61; Mul 62 10; Sub 1 0; Mul 0 7; Mul 4 32;
  Mul 1 32; Add 1 0; Sub 78 0; Add 1 0; Sub 80 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 75; Mul 7 75; Add 1 0; Add 0 5; Sub 80 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 85 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 130 39; Mul 131 37; Mul 1 96; Mul 1 97; Mul 24 1; Mul 21 1; Add 1 0; Add 0 19; Sub 99 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 123 48; Mul 121 46; Sub 1 0; Mul 123 51; Mul 127 49; Add 1 0; Mul 132 3; Mul 133 1;
  Mul 1 106; Mul 1 107; Sub 52 16; Sub 52 16; Sub 3 18; Sub 3 18; Mul 3 0; Mul 3 2; Sub 1 0;
  Div 156 0; Mul 108 4; Mul 7 109; Sub 1 0; Mul 0 3; Mul 11 112; Mul 113 10; Sub 1 0; Mul 0 7;
  Mul 4 32; Mul 1 32; Add 1 0; Sub 129 0; Add 1 0; Sub 131 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 74; Mul 7 74; Add 1 0; Add 0 5; Sub 131 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 136 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 181 39; Mul 182 37; Mul 1 147; Mul 1 148; Mul 24 1; Mul 21 1; Add 1 0; Add 0 19; Sub 150 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 174 48; Mul 172 46; Sub 1 0; Mul 174 51; Mul 178 49; Add 1 0; Mul 183 3; Mul 184 1;
  Mul 1 157; Mul 1 158; Sub 52 16; Sub 52 16; Sub 3 18; Sub 3 18; Mul 3 0; Mul 3 2; Sub 1 0;
  Div 207 0; Mul 159 4; Mul 7 160; Sub 1 0; Mul 0 3; Mul 11 163; Mul 164 10; Sub 1 0; Mul 0 7;
  Mul 4 32; Mul 1 32; Add 1 0; Sub 180 0; Add 1 0; Sub 182 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 74; Mul 7 74; Add 1 0; Add 0 5; Sub 182 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 187 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 232 39; Mul 233 37; Mul 1 198; Mul 1 199; Mul 24 1; Mul 21 1; Add 1 0; Add 0 19; Sub 201 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 225 48; Mul 223 46; Sub 1 0; Mul 225 51; Mul 229 49; Add 1 0; Mul 234 3; Mul 235 1;
  Mul 1 208; Mul 1 209; Sub 52 16; Sub 52 16; Sub 3 18; Sub 3 18; Mul 3 0; Mul 3 2; Sub 1 0;
  Div 258 0; Mul 210 4; Mul 7 211; Sub 1 0; Mul 0 3; Mul 11 214; Mul 215 10; Sub 1 0; Mul 0 7;
  Mul 4 32; Mul 1 32; Add 1 0; Sub 231 0; Add 1 0; Sub 233 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 74; Mul 7 74; Add 1 0; Add 0 5; Sub 233 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 238 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 283 39; Mul 284 37; Mul 1 249; Mul 1 250; Mul 24 1; Mul 21 1; Add 1 0; Add 0 19; Sub 252 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 279 280; Mul 0 293; Mul 1 274; Mul 2 272; Mul 3 270; Mul 263 264; Mul 0 0; Neg 0; Mul 6 0;
  Mul 6 1; Mul 267 304; Mul 7 3; Mul 7 4; Sub 4 263; Sub 4 263; Sub 4 263; Sub 4 266; Sub 4 266;
  Mul 4 0; Mul 4 2; Sub 1 0; Div 313 0; Mul 6 4; Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10; Mul 11 10;
  Sub 1 0; Mul 0 7; Mul 4 280; Mul 1 280; Add 1 0; Sub 281 0; Add 1 0; Sub 283 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 27; Mul 7 27; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 29; Mul 12 29; Add 1 0; Add 0 10; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 293; Mul 17 293; Add 1 0; Add 0 15; Sub 298 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 50 252; Mul 51 250; Mul 1 45; Mul 1 46; Sub 43 302; Sub 43 302; Sub 3 304; Sub 3 304;
  Mul 3 0; Mul 3 2; Sub 1 0; Div 354 0; Mul 47 4; Mul 7 48; Sub 1 0; Mul 0 3; Mul 11 51;
  Mul 52 10; Sub 1 0; Mul 0 7; Mul 4 318; Mul 1 318; Add 1 0; Sub 322 0; Add 1 0; Sub 324 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 65; Mul 7 65; Add 1 0; Add 0 5; Sub 70 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 75 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 282; Mul 17 282; Add 1 0; Add 0 15; Sub 339 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 91 242; Mul 92 240; Mul 1 86; Mul 1 87; Sub 42 291; Sub 42 291; Sub 3 293; Sub 3 293;
  Mul 3 0; Mul 3 2; Sub 1 0; Div 395 0; Mul 88 4; Mul 7 89; Sub 1 0; Mul 0 3; Mul 11 92;
  Mul 93 10; Sub 1 0; Mul 0 7; Mul 4 307; Mul 1 307; Add 1 0; Sub 363 0; Add 1 0; Sub 365 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 64; Mul 7 64; Add 1 0; Add 0 5; Sub 111 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 116 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 272; Mul 17 272; Add 1 0; Add 0 15; Sub 380 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 132 232; Mul 133 230; Mul 1 127; Mul 1 128; Sub 42 281; Sub 42 281; Sub 3 283; Sub 3 283;
  Mul 3 0; Mul 3 2; Sub 1 0; Div 436 0; Mul 129 4; Mul 7 130; Sub 1 0; Mul 0 3; Mul 11 133;
  Mul 134 10; Sub 1 0; Mul 0 7; Mul 4 297; Mul 1 297; Add 1 0; Sub 404 0; Add 1 0; Sub 406 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 64; Mul 7 64; Add 1 0; Add 0 5; Sub 152 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 157 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 262; Mul 17 262; Add 1 0; Add 0 15; Sub 421 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 173 222; Mul 174 220; Mul 1 168; Mul 1 169; Sub 42 271; Sub 42 271; Sub 3 273; Sub 3 273;
  Mul 3 0; Mul 3 2; Sub 1 0; Div 477 0; Mul 170 4; Mul 7 171; Sub 1 0; Mul 0 3; Mul 11 174;
  Mul 175 10; Sub 1 0; Mul 0 7; Mul 4 287; Mul 1 287; Add 1 0; Sub 445 0; Add 1 0; Sub 447 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 64; Mul 7 64; Add 1 0; Add 0 5; Sub 193 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 198 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 252; Mul 17 252; Add 1 0; Add 0 15; Sub 462 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 440; Neg 182; Neg 142; Sub 192 451; Sub 189 448; Sub 3 4; Sub 154 454; Sub 151 451; Sub 5 7;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 519 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 469; Mul 1 466; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 216; Mul 7 213; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 180; Mul 12 177; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 426; Mul 21 435; Mul 18 432; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 142; Sub 192 441; Sub 189 438; Sub 43 8; Sub 154 444; Sub 151 441; Sub 5 11; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 560 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 459; Mul 1 456; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 216; Mul 7 213; Add 1 0; Add 0 5; Sub 69 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 180; Mul 12 177; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 416; Mul 21 425; Mul 18 422; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 142; Sub 192 431; Sub 189 428; Sub 43 8; Sub 154 434; Sub 151 431; Sub 5 11; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 601 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 449; Mul 1 446; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 216; Mul 7 213; Add 1 0; Add 0 5; Sub 69 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 180; Mul 12 177; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 406; Mul 21 415; Mul 18 412; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 142; Sub 192 421; Sub 189 418; Sub 43 8; Sub 154 424; Sub 151 421; Sub 5 11; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 642 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 439; Mul 1 436; Add 1 0; Sub 27 0; Add 1 0; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 216; Mul 7 213; Add 1 0; Add 0 5; Sub 69 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 180; Mul 12 177; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 396; Mul 21 405; Mul 18 402; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 380 661; Mul 0 674; Mul 1 655; Mul 2 653; Mul 3 651; Mul 380 645; Mul 0 0; Neg 0; Mul 6 0;
  Mul 6 1; Constant 3; Mul 649 0; Mul 8 4; Mul 8 5; Sub 5 386; Sub 5 386; Sub 4 386; Sub 4 389;
  Sub 4 389; Mul 4 0; Mul 4 2; Sub 1 0; Div 695 0; Mul 6 4; Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10;
  Mul 11 10; Sub 1 0; Mul 0 7; Mul 4 403; Mul 1 403; Add 1 0; Sub 404 0; Add 1 0; Sub 406 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 28; Mul 7 28; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 29; Mul 12 29; Add 1 0; Add 0 10; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 416; Mul 17 416; Add 1 0; Add 0 15; Sub 421 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 51 634; Mul 52 632; Mul 1 46; Mul 1 47; Sub 43 425; Sub 43 425; Sub 3 427; Sub 3 427;
  Mul 3 0; Mul 3 2; Sub 1 0; Div 736 0; Mul 47 4; Mul 7 48; Sub 1 0; Mul 0 3; Mul 11 51;
  Mul 52 10; Sub 1 0; Mul 0 7; Mul 4 441; Mul 1 441; Add 1 0; Sub 445 0; Add 1 0; Sub 447 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 65; Mul 7 65; Add 1 0; Add 0 5; Sub 70 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 75 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 415; Mul 17 415; Add 1 0; Add 0 15; Sub 462 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 92 754; Mul 0 767; Mul 1 748; Mul 2 746; Mul 3 744; Mul 92 738; Mul 0 0; Neg 0; Mul 6 0;
  Mul 6 1; Constant 4; Mul 742 0; Mul 8 4; Mul 8 5; Sub 5 98; Sub 5 98; Sub 4 97; Sub 4 101;
  Sub 4 101; Mul 4 0; Mul 4 2; Sub 1 0; Div 788 0; Mul 6 4; Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10;
  Mul 11 10; Sub 1 0; Mul 0 7; Mul 4 115; Mul 1 115; Add 1 0; Sub 115 0; Add 1 0; Sub 117 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 28; Mul 7 28; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 29; Mul 12 29; Add 1 0; Add 0 10; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 127; Mul 17 127; Add 1 0; Add 0 15; Sub 132 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 51 727; Mul 52 725; Mul 1 46; Mul 1 47; Sub 43 136; Sub 43 136; Sub 3 138; Sub 3 138;
  Mul 3 0; Mul 3 2; Sub 1 0; Div 829 0; Mul 47 4; Mul 7 48; Sub 1 0; Mul 0 3; Mul 11 51;
  Mul 52 10; Sub 1 0; Mul 0 7; Mul 4 152; Mul 1 152; Add 1 0; Sub 156 0; Add 1 0; Sub 158 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 65; Mul 7 65; Add 1 0; Add 0 5; Sub 70 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 75 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 126; Mul 17 126; Add 1 0; Add 0 15; Sub 173 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 92 847; Mul 0 860; Mul 1 841; Mul 2 839; Mul 3 837; Mul 92 831; Mul 0 0; Neg 0; Mul 6 0;
  Mul 6 1; Constant 5; Mul 835 0; Mul 8 4; Mul 8 5; Sub 5 98; Sub 5 98; Sub 4 97; Sub 4 101;
  Sub 4 101; Mul 4 0; Mul 4 2; Sub 1 0; Div 881 0; Mul 6 4; Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10;
  Mul 11 10; Sub 1 0; Mul 0 7; Mul 4 115; Mul 1 115; Add 1 0; Sub 115 0; Add 1 0; Sub 117 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 28; Mul 7 28; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 29; Mul 12 29; Add 1 0; Add 0 10; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 127; Mul 17 127; Add 1 0; Add 0 15; Sub 132 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 51 820; Mul 52 818; Mul 1 46; Mul 1 47; Sub 43 136; Sub 43 136; Sub 3 138; Sub 3 138;
  Mul 3 0; Mul 3 2; Sub 1 0; Div 922 0; Mul 47 4; Mul 7 48; Sub 1 0; Mul 0 3; Mul 11 51;
  Mul 52 10; Sub 1 0; Mul 0 7; Mul 4 152; Mul 1 152; Add 1 0; Sub 156 0; Add 1 0; Sub 158 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 65; Mul 7 65; Add 1 0; Add 0 5; Sub 70 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 28; Mul 12 28; Add 1 0; Add 0 10; Sub 75 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 126; Mul 17 126; Add 1 0; Add 0 15; Sub 173 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 244; Neg 204; Sub 254 636; Sub 251 633; Sub 3 447; Sub 216 639; Sub 213 636; Sub 5 450;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 963 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 654; Mul 1 651; Add 1 0; Sub 466 0; Add 1 0; Sub 468 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 278; Mul 7 275; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 242; Mul 12 239; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 629; Mul 17 626; Add 1 0; Add 0 15; Sub 482 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 192; Neg 152; Sub 202 295; Sub 199 292; Sub 3 44; Sub 164 298; Sub 161 295; Sub 5 47;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 1004 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 313; Mul 1 310; Add 1 0; Sub 63 0; Add 1 0; Sub 65 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 226; Mul 7 223; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 190; Mul 12 187; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 288; Mul 17 285; Add 1 0; Add 0 15; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 140; Neg 100; Sub 150 243; Sub 147 240; Sub 3 44; Sub 112 246; Sub 109 243; Sub 5 47;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 1045 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 261; Mul 1 258; Add 1 0; Sub 63 0; Add 1 0; Sub 65 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 174; Mul 7 171; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 138; Mul 12 135; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 236; Mul 17 233; Add 1 0; Add 0 15; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 510 551; Sub 507 548; Sub 504 545; Sub 472 554; Sub 469 551; Sub 466 548; Sub 434 557;
  Sub 431 554; Sub 428 551; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* through one point *)
  Sub 130 574; Sub 127 571; Sub 124 568; Sub 92 577; Sub 89 574; Sub 86 571; Sub 54 580;
  Sub 51 577; Sub 48 574; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0 (* through one point *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face of the dual is the pole of a vertex; size 4.
    Code: src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_3_size_4 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 7; Unknown 8; Sub 1 15; Sub 1 15; Sub 15 3; Sub 15 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 9;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 5 16; Mul 5 18; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 10;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 11;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 20 11; Mul 20 13; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Constant 0; Neg 15; Mul 0 20; Mul 18 21; Mul 35 1; Mul 35 1; Add 1 0; Neg 19; Mul 0 16;
  Mul 22 17; Mul 27 1; Mul 27 1; Add 1 0; Neg 37; Mul 0 18; Mul 40 19; Mul 45 1; Mul 45 1;
  Add 1 0; Neg 41; Mul 0 23; Mul 44 24; Mul 49 1; Mul 49 1; Add 1 0; Unknown 12; Unknown 13;
  Unknown 14; Add 27 2; Add 28 2; Add 29 2; Add 28 5; Add 28 5; Add 26 5; Add 25 8; Add 25 8;
  Add 23 8; Add 22 11; Add 22 11; Add 20 11; Add 19 14; Add 19 14; Add 17 14; Sub 2 14; Sub 2 14;
  Sub 2 14; Sub 14 17; Sub 14 17; Sub 14 17; Mul 5 1; Mul 5 3; Sub 1 0; Constant 1; Div 0 1;
  Mul 8 6; Mul 10 6; Sub 1 0; Mul 0 3; Mul 14 9; Mul 13 12; Sub 1 0; Mul 0 7; Mul 4 33; Mul 1 33;
  Add 1 0; Sub 34 0; Neg 0; Sub 32 38; Sub 32 38; Sub 32 38; Mul 23 1; Mul 23 3; Sub 1 0;
  Div 20 0; Mul 25 5; Mul 27 5; Sub 1 0; Mul 0 3; Mul 31 8; Mul 30 11; Sub 1 0; Mul 0 7; Mul 4 53;
  Mul 1 53; Add 1 0; Sub 54 0; Neg 0; Sub 49 58; Sub 49 58; Sub 49 58; Mul 22 1; Mul 22 3;
  Sub 1 0; Div 40 0; Mul 24 5; Mul 26 5; Sub 1 0; Mul 0 3; Mul 30 8; Mul 29 11; Sub 1 0; Mul 0 7;
  Mul 4 73; Mul 1 73; Add 1 0; Sub 74 0; Neg 0; Sub 29 49; Sub 26 46; Sub 22 42; Sub 12 52;
  Sub 9 49; Sub 5 45; Mul 5 1; Mul 5 3; Sub 1 0; Div 63 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 67; Mul 1 64; Add 1 0; Sub 61 0; Add 1 0; Sub 63 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 53; Mul 7 50; Add 1 0; Add 0 5; Sub 48 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 35; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 53 96; Mul 53 98; Sub 1 0; Div 91 0; Mul 55 100; Mul 57 100; Sub 1 0; Mul 0 3; Mul 61 103;
  Mul 60 106; Sub 1 0; Mul 0 7; Mul 4 124; Mul 1 124; Add 1 0; Sub 125 0; Neg 0; Mul 37 9;
  Mul 34 6; Add 1 0; Add 0 32; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 42 134;
  ShowZero 0; (* gradient *)
  Sub 39 134;
  ShowZero 0; (* gradient *)
  Neg 134; Sub 37 0;
  ShowZero 0 (* height *)
].

Theorem part_3_size_4_valid : valid part_3_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
