(** thm-2-f (Sec. 3.2, Theorem 2)

    An i-conical mesh has a circumscribed mesh with parallel face planes and edges: its planes are
    z = p·x - |p|²/2, and those around a vertex meet in one point.

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a pyramid; size 1.
    Code: src/scalar/ring.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs, src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* around every vertex are three gradients that are not collinear *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* around every vertex are three gradients that are not collinear *)
  Sub 15 17; Sub 15 17; Sub 8 19; Sub 8 19; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* around every vertex are three gradients that are not collinear *)
  Sub 26 22; Sub 26 22; Sub 15 24; Sub 15 24; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* around every vertex are three gradients that are not collinear *)
  Sub 33 31;
  Nonzero 0; (* the gradients differ in x *)
  Nonzero 7; (* the gradients differ in x *)
  Sub 34 21;
  Nonzero 0; (* the gradients differ in x *)
  Constant 0; Sub 36 0;
  Nonzero 0; (* the gradients differ in x *)
  Sub 35 33;
  Nonzero 0; (* the gradients differ in x *)
  Sub 36 25;
  Nonzero 0; (* the gradients differ in x *)
  Sub 37 3;
  Nonzero 0; (* the gradients differ in x *)
  Sub 36 27;
  Nonzero 0; (* the gradients differ in x *)
  Sub 37 5;
  Nonzero 0; (* the gradients differ in x *)
  Sub 29 6;
  Nonzero 0; (* the gradients differ in x *)
  Unknown 8;
  Nonzero 0; (* the apex is not in the base *)
  Sub 30 8; Sub 44 9; Mul 3 0; Mul 2 10; Sub 1 0;
  Nonzero 0; (* the base meets the edges of the apex *)
  Sub 46 13; Mul 13 0; Mul 5 11; Sub 1 0;
  Nonzero 0; (* the base meets the edges of the apex *)
  Sub 48 17; Mul 14 0; Mul 5 13; Sub 1 0;
  Nonzero 0; (* the base meets the edges of the apex *)
  Mul 15 12; Mul 4 15; Sub 1 0;
  Nonzero 0; (* the base meets the edges of the apex *)
  Mul 54 54; Mul 54 54; Add 1 0; Mul 55 55; Mul 55 55; Add 1 0; Mul 51 51; Mul 51 51; Add 1 0;
  Mul 53 3; Mul 1 61; Sub 1 0; Mul 3 64; Mul 58 7; Sub 1 0; Mul 60 66; Mul 60 68; Sub 1 0;
  Mul 72 6; Mul 72 4; Add 1 0; Mul 18 3; Add 1 0;
  Zero 0; (* the gradients around every vertex are concyclic *)
  Sub 82 69; Neg 0; Div 41 36; Mul 1 0; Mul 52 1; Neg 81; Div 45 36; Mul 1 0; Mul 85 1; Neg 71;
  Div 49 36; Mul 1 0; Mul 75 1; Sub 9 60; Sub 9 61; Sub 62 54; Sub 8 63; Sub 8 64; Mul 4 0;
  Mul 4 2; Sub 1 0; Constant 1; Div 0 1; Mul 7 5; Mul 9 8; Sub 1 0; Mul 0 3; Mul 0 5; Add 75 0;
  Sub 17 76; Sub 17 77; Mul 14 0; Mul 14 2; Sub 1 0; Div 12 0; Mul 19 4; Mul 18 20; Sub 1 0;
  Mul 0 3; Mul 0 17; Add 87 0; Sub 12 0;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Neg 95; Div 82 66; Mul 1 0; Mul 99 1; Sub 1 93; Sub 1 94; Mul 18 0; Mul 18 2; Sub 1 0; Div 29 0;
  Mul 36 4; Mul 22 37; Sub 1 0; Mul 0 3; Mul 0 34; Add 104 0; Sub 29 0;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Sub 18 1;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Mul 13 45; Mul 13 47; Sub 1 0; Div 41 0; Mul 48 49; Mul 17 49; Sub 1 0; Mul 0 3; Mul 0 46;
  Add 116 0; Sub 41 0;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Sub 30 1;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Sub 14 2;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Sub 61 28; Sub 61 28; Sub 122 122; Sub 68 31; Sub 68 31; Mul 4 0; Mul 4 2; Sub 1 0; Div 59 0;
  Mul 6 4; Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10; Mul 11 10; Sub 1 0; Mul 0 7; Mul 4 45; Mul 1 45;
  Add 1 0; Sub 140 0; Add 1 0; Sub 142 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 84; Mul 7 84; Add 1 0; Add 0 5; Sub 147 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 93; Mul 12 93; Add 1 0; Add 0 10; Sub 152 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 102; Mul 17 102; Add 1 0; Add 0 15; Sub 157 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 89; Add 159 0; Sub 55 0;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Sub 44 1;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Sub 74 2;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Sub 87 3;
  ShowNonzero 0; (* as src/space/gradient.rs finds *)
  Mul 103 101; Mul 102 101; Sub 1 0; Mul 0 97; Mul 94 94; Mul 1 1; Add 1 0; Mul 102 0;
  Div 103 209; Mul 1 0; Mul 174 100; Mul 175 7; Add 1 0; Add 0 177; Add 4 0; Mul 11 110;
  Add 180 0; Mul 105 107; Mul 1 14; Add 1 0; Sub 5 0; Mul 121 122; Mul 123 109; Sub 1 0;
  Mul 0 106; Mul 103 103; Mul 1 1; Add 1 0; Mul 123 0; Mul 0 20; Mul 194 108; Mul 195 6; Add 1 0;
  Add 0 197; Add 4 0; Mul 10 130; Add 200 0; Mul 113 115; Mul 1 13; Add 1 0; Sub 5 0; Mul 128 142;
  Mul 143 112; Sub 1 0; Mul 0 109; Mul 106 106; Mul 1 1; Add 1 0; Mul 143 0; Mul 0 40;
  Mul 214 111; Mul 215 6; Add 1 0; Add 0 217; Add 4 0; Mul 10 150; Add 220 0; Mul 116 118;
  Mul 1 13; Add 1 0; Sub 5 0; Neg 40; Neg 21; Neg 2; Sub 140 152; Sub 28 48; Sub 3 4; Sub 126 155;
  Sub 11 51; Sub 5 7; Mul 5 1; Mul 5 3; Sub 1 0; Div 168 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 170; Mul 1 66; Add 1 0; Sub 23 0; Neg 0; Mul 146 9;
  Mul 31 6; Add 1 0; Add 0 29; Sub 4 0;
  ShowZero 0; (* as src/construct/circumscribed.rs finds *)
  Mul 162 193; Mul 194 196; Sub 1 0; Mul 0 148; Mul 145 145; Mul 1 1; Add 1 0; Mul 194 0;
  Mul 0 91; Mul 265 150; Mul 266 6; Add 1 0; Add 0 268; Add 4 0; Mul 10 201; Add 271 0;
  Mul 155 157; Mul 1 13; Add 1 0; Sub 5 0; Mul 159 34; Mul 5 31; Add 1 0; Add 0 3; Sub 29 0;
  ShowZero 0; (* as src/construct/circumscribed.rs finds *)
  Mul 148 148; Mul 145 145; Add 1 0; Mul 215 0; Mul 0 112; Mul 286 153; Mul 287 150; Add 1 0;
  Add 0 289; Add 4 0; Mul 154 222; Add 292 0; Mul 133 160; Mul 1 157; Add 1 0; Sub 5 0; Neg 21;
  Neg 1; Sub 182 223; Sub 28 119; Sub 3 75; Sub 142 226; Sub 10 122; Sub 5 78; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 239 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 241; Mul 1 137; Add 1 0; Sub 94 0; Neg 0; Mul 162 9; Mul 30 6; Add 1 0; Add 0 28; Sub 4 0;
  ShowZero 0; (* as src/construct/circumscribed.rs finds *)
  Mul 98 23; Mul 98 25; Sub 1 0; Div 261 0; Mul 100 27; Mul 102 27; Sub 1 0; Mul 0 3; Mul 106 30;
  Mul 105 33; Sub 1 0; Mul 0 7; Mul 4 263; Mul 1 159; Add 1 0; Sub 116 0; Neg 0; Mul 184 9;
  Mul 52 6; Add 1 0; Add 0 50; Sub 4 0;
  ShowZero 0; (* as src/construct/circumscribed.rs finds *)
  Sub 244 261; Sub 129 149; Sub 123 124; Sub 192 264; Sub 60 152; Sub 55 127; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 289 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 279; Mul 1 167; Add 1 0; Sub 143 0; Neg 0; Mul 212 9; Mul 80 6; Add 1 0; Add 0 78;
  Sub 4 0;
  ShowZero 0; (* as src/construct/circumscribed.rs finds *)
  Sub 260 272; Sub 106 157; Sub 81 151; Sub 220 275; Sub 88 160; Sub 83 154; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 317 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 290; Mul 1 175; Add 1 0; Sub 170 0; Neg 0; Mul 240 9; Mul 108 6; Add 1 0; Add 0 106;
  Sub 4 0;
  ShowZero 0; (* as src/construct/circumscribed.rs finds *)
  Mul 331 163; Mul 238 160; Add 1 0; Sub 157 0; Mul 335 96; Mul 242 93; Add 1 0; Add 0 3;
  Sub 91 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 340 79; Mul 247 76; Add 1 0; Add 0 8; Sub 74 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 333 177; Mul 231 174; Add 1 0; Sub 171 0; Mul 337 88; Mul 235 85; Add 1 0; Add 0 3;
  Sub 83 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 342 65; Mul 240 62; Add 1 0; Add 0 8; Sub 60 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 330 191; Mul 225 188; Add 1 0; Sub 185 0; Mul 334 74; Mul 229 71; Add 1 0; Add 0 3;
  Sub 69 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 339 51; Mul 234 48; Add 1 0; Add 0 8; Sub 46 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 332 205; Mul 188 202; Add 1 0; Sub 199 0; Mul 336 60; Mul 192 57; Add 1 0; Add 0 3;
  Sub 55 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 341 143; Mul 197 140; Add 1 0; Add 0 8; Sub 138 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 328 70; Mul 325 67; Add 1 0; Sub 64 0; Mul 332 102; Mul 329 99; Add 1 0; Add 0 3; Sub 97 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 337 135; Mul 334 132; Add 1 0; Add 0 8; Sub 130 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 342 162; Mul 339 159; Add 1 0; Add 0 13; Sub 157 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 163 234; Sub 159 230; Mul 420 0; Mul 420 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 172 243; Mul 423 0; Mul 426 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 428 8; Mul 428 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 436 440; Sub 154 176; Sub 150 172; Mul 2 0; Mul 373 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 443 447; Sub 164 186; Mul 377 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 11 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 506 450; Sub 499 507; Sub 262 169; Sub 258 165; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 513 458; Sub 272 179; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 461 465; Sub 155 183; Sub 151 179; Mul 2 0; Mul 402 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 468 472; Sub 165 193; Mul 406 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 11 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 535 475; Sub 290 169; Sub 286 165; Mul 2 0; Mul 31 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 541 482; Sub 300 179; Mul 35 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 11 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 456 489; Sub 155 183; Sub 151 179; Mul 2 0; Mul 430 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 463 496; Sub 165 193; Mul 434 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 11 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 563 470; Sub 318 169; Sub 314 165; Mul 2 0; Mul 59 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 569 477; Sub 328 179; Mul 63 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 11 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 525 484; Sub 261 183; Sub 257 179; Mul 2 0; Mul 458 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 532 491; Sub 271 193; Mul 462 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 11 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  ShowZero 591; (* nothing is free *)
  Mul 515 349; Mul 411 346; Add 1 0; Add 0 409; Sub 344 0;
  ShowZero 0; (* in the plane that touches Σ *)
  Mul 520 283; Mul 416 280; Add 1 0; Add 0 414; Sub 278 0;
  ShowZero 0; (* in the plane that touches Σ *)
  Mul 525 266; Mul 421 263; Add 1 0; Add 0 419; Sub 261 0;
  ShowZero 0; (* in the plane that touches Σ *)
  Mul 518 364; Mul 406 361; Add 1 0; Add 0 404; Sub 359 0;
  ShowZero 0; (* in the plane that touches Σ *)
  Mul 523 276; Mul 411 273; Add 1 0; Add 0 409; Sub 271 0;
  ShowZero 0; (* in the plane that touches Σ *)
  Mul 528 253; Mul 416 250; Add 1 0; Add 0 414; Sub 248 0;
  ShowZero 0; (* in the plane that touches Σ *)
  ShowZero 365; (* in the plane that touches Σ *)
  Mul 516 258; Mul 401 255; Add 1 0; Add 0 399; Sub 253 0;
  ShowZero 0; (* in the plane that touches Σ *)
  Mul 521 235; Mul 406 232; Add 1 0; Add 0 404; Sub 230 0;
  ShowZero 0; (* in the plane that touches Σ *)
  ShowZero 350; (* in the plane that touches Σ *)
  Mul 514 240; Mul 360 237; Add 1 0; Add 0 358; Sub 235 0;
  ShowZero 0; (* in the plane that touches Σ *)
  Mul 519 323; Mul 365 320; Add 1 0; Add 0 363; Sub 318 0;
  ShowZero 0; (* in the plane that touches Σ *)
  ShowZero 236; (* in the plane that touches Σ *)
  ShowZero 264; (* in the plane that touches Σ *)
  ShowZero 292; (* in the plane that touches Σ *)
  ShowZero 314 (* in the plane that touches Σ *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
