(** eq-8-9-curvatures (Sec. 2.1, (8), (9))

    K is the determinant of the Hessian and 2H its trace; they are the product and the sum of the
    i-principal curvatures, whose directions are conjugate and orthogonal in the top view.

        K = κ₁κ₂ = f_xx f_yy − f_xy²,  2H = κ₁ + κ₂ = Δf

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** jets of polynomials; size 2.
    Code: src/scalar/dual.rs, src/scalar/ring.rs, src/space/polynomial.rs, src/space/surface.rs *)
Definition part_1_size_2 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 1;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 2;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 3;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 4;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Constant 1; Mul 0 4;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 1 3;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 8 3;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 3 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 10 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 5 2;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 6 4;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 7 2;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Unknown 5; Unknown 6; Unknown 7; Constant 0; Mul 3 12; Mul 0 13; Add 2 0; Mul 20 15; Mul 16 5;
  Mul 1 0; Add 3 0; Mul 22 19; Mul 3 9; Mul 1 0; Add 3 0; Mul 23 13; Mul 28 0; Mul 0 25; Add 3 0;
  Mul 29 3; Mul 0 11; Add 2 0; Mul 6 20; Mul 32 0; Mul 0 32; Add 3 0; Sub 0 0;
  ShowZero 0; (* f *)
  Mul 34 35; Mul 0 36; Add 25 0; Mul 36 38; Mul 0 22; Add 2 0; Mul 38 17; Mul 0 42; Add 2 0;
  Mul 32 44; Mul 36 33; Add 1 0; Mul 0 47; Mul 35 36; Add 1 0; Add 38 0; Mul 56 39; Add 7 0;
  Mul 41 42; Mul 54 42; Add 1 0; Mul 3 39; Mul 41 1; Add 1 0; Add 8 0; Mul 63 48; Add 16 0;
  Mul 6 51; Mul 46 51; Add 1 0; Mul 3 44; Mul 46 1; Add 1 0; Add 8 0; Mul 57 59; Mul 70 70;
  Add 1 0; Mul 60 48; Mul 77 1; Add 1 0; Mul 0 75; Mul 51 64; Add 1 0; Add 9 0; Mul 81 7; Add 7 0;
  Mul 0 64; Mul 54 26; Add 1 0; Add 5 0; Mul 13 75; Mul 62 86; Add 1 0; Mul 76 57; Mul 90 1;
  Add 1 0; Mul 0 91; Mul 60 80; Add 1 0; Add 9 0; Sub 51 0;
  ShowZero 0; (* f_x *)
  Mul 92 96; Mul 0 97; Add 86 0; Mul 94 99; Mul 0 83; Add 2 0; Mul 100 78; Mul 0 103; Add 2 0;
  Add 51 34; Mul 90 0; Add 50 0; Add 57 0; Mul 3 98; Mul 93 110; Add 1 0; Mul 92 0; Add 47 0;
  Add 5 0; Add 45 60; Mul 120 0; Add 44 0; Mul 0 118; Add 0 42; Add 5 0; Mul 123 5; Add 49 0;
  Mul 0 106; Mul 96 18; Add 1 0; Add 5 0; Mul 11 117; Mul 104 116; Add 1 0; Mul 131 0; Add 42 0;
  Mul 0 132; Add 0 40; Add 7 0; Sub 30 0;
  ShowZero 0; (* f_y *)
  Mul 130 136; Mul 0 137; Add 126 0; Mul 132 139; Mul 0 140; Add 129 0; Mul 134 142; Mul 0 143;
  Add 132 0; Mul 133 133; Add 101 0; Add 1 101; Add 1 0; Mul 0 149; Mul 103 138; Add 1 0;
  Add 1 103; Add 1 0; Add 142 0; Add 9 103; Add 9 0; Add 103 11; Add 12 103; Add 1 0; Add 115 105;
  Add 3 0; Add 108 117; Add 0 2; Mul 7 147; Mul 112 109; Add 1 0; Mul 151 7; Add 2 0; Add 2 0;
  Mul 117 64; Mul 155 9; Add 1 0; Add 6 0; Add 9 3; Mul 159 11; Add 5 0; Add 2 0; Add 23 8;
  Add 24 5; Add 25 2; Add 35 120; Add 35 0; Mul 23 172; Mul 128 172; Add 1 0; Add 1 122; Add 1 0;
  Mul 26 177; Mul 83 177; Add 1 0; Mul 135 191; Add 0 128; Add 2 0; Mul 30 183; Mul 89 195;
  Add 1 0; Add 1 133; Add 1 0; Mul 16 178; Mul 138 135; Add 1 0; Mul 182 14; Add 2 0; Add 2 0;
  Mul 143 93; Mul 186 12; Add 1 0; Add 6 0; Add 9 3; Mul 190 11; Add 5 0; Add 2 0; Add 34 8;
  Add 34 5; Add 34 2; Add 146 171; Add 0 56; Add 1 59; Add 149 73; Add 0 61; Mul 209 149;
  Add 149 0; Mul 227 5; Add 2 0; Add 2 0; Mul 214 110; Mul 231 8; Add 1 0; Add 6 0; Add 157 3;
  Mul 235 10; Add 5 0; Add 2 0; Mul 8 234; Mul 160 223; Add 1 0; Add 1 160; Add 1 0; Mul 9 239;
  Mul 122 228; Add 1 0; Add 0 4; Mul 9 243; Add 0 3; Add 4 168; Add 1 0; Add 33 8; Add 33 5;
  Add 33 2; Mul 252 32; Add 29 0; Add 29 0; Mul 255 34; Add 27 0; Add 32 0; Mul 258 35; Add 30 0;
  Add 27 0; Mul 6 242; Mul 179 204; Add 1 0; Mul 234 102; Add 2 0; Add 2 0; Mul 9 248;
  Mul 143 210; Add 1 0; Mul 187 162; Mul 241 107; Add 1 0; Add 3 0; Mul 13 255; Mul 150 167;
  Add 1 0; Mul 247 111; Add 2 0; Add 2 0; Add 30 13; Add 30 7; Add 30 2; Mul 63 271; Mul 210 282;
  Add 1 0; Add 1 155; Add 1 0; Mul 67 276; Mul 171 287; Add 1 0; Mul 217 277; Add 0 161; Add 2 0;
  Mul 71 282; Mul 177 281; Add 1 0; Add 1 166; Add 1 0; Mul 285 209; Add 209 0; Mul 300 13;
  Add 2 0; Add 2 0; Mul 290 172; Mul 304 11; Add 1 0; Add 6 0; Add 217 3; Mul 308 10; Add 5 0;
  Add 2 0; Mul 8 310; Mul 220 299; Add 1 0; Add 1 220; Add 1 0; Mul 9 315; Mul 184 304; Add 1 0;
  Add 0 4; Mul 9 319; Add 0 3; Add 4 228; Add 1 0; Add 44 8; Add 44 5; Add 44 2; Mul 187 181;
  Mul 185 185; Sub 1 0; Mul 5 3; Mul 5 5; Sub 1 0; Sub 3 0;
  ShowZero 0; (* K *)
  Add 194 188; Div 334 340; Mul 1 0; Mul 342 0; Add 13 11; Sub 1 0;
  ShowZero 0 (* 2H *)
].

Theorem part_1_size_2_valid : valid part_1_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** jets of polynomials; size 3.
    Code: src/scalar/dual.rs, src/scalar/ring.rs, src/space/polynomial.rs, src/space/surface.rs *)
Definition part_1_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 3;
  Nonzero 0; (* 3 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 1;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 2;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 3;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 4;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 5;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 6;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 7;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 8;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Constant 1; Mul 0 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 1 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 2 5;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 14 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 15 6;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 15 6;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 6 15;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 18 14;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 18 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 20 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 10 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 11 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 12 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 24 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 14 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 26 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 16 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 28 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 18 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Unknown 9; Unknown 10; Unknown 11; Constant 0; Mul 3 23; Mul 0 24; Add 2 0; Mul 35 26; Mul 27 5;
  Mul 1 0; Add 3 0; Mul 37 30; Mul 3 9; Mul 1 0; Add 3 0; Mul 38 34; Mul 3 13; Mul 1 0; Add 3 0;
  Mul 38 17; Mul 47 0; Mul 0 40; Add 3 0; Mul 48 3; Mul 0 15; Add 2 0; Mul 48 6; Mul 0 14;
  Add 2 0; Mul 9 27; Mul 54 0; Mul 0 50; Add 3 0; Mul 54 3; Mul 0 25; Add 2 0; Mul 6 34; Mul 57 0;
  Mul 0 57; Add 3 0; Sub 0 0;
  ShowZero 0; (* f *)
  Mul 59 60; Mul 0 61; Add 39 0; Mul 61 63; Mul 0 36; Add 2 0; Mul 63 66; Mul 0 35; Add 2 0;
  Mul 65 30; Mul 0 70; Add 2 0; Mul 67 33; Mul 0 45; Add 2 0; Mul 69 26; Mul 0 76; Add 2 0;
  Mul 55 78; Mul 59 56; Add 1 0; Mul 0 81; Mul 58 59; Add 1 0; Add 61 0; Mul 94 62; Add 7 0;
  Mul 64 65; Mul 88 65; Add 1 0; Mul 3 62; Mul 64 1; Add 1 0; Add 8 0; Mul 101 71; Add 16 0;
  Mul 6 74; Mul 69 74; Add 1 0; Mul 3 67; Mul 69 1; Add 1 0; Add 8 0; Mul 107 80; Add 25 0;
  Mul 6 83; Mul 74 83; Add 1 0; Mul 3 72; Mul 74 1; Add 1 0; Add 8 0; Mul 89 91; Mul 113 113;
  Add 1 0; Mul 92 76; Mul 124 1; Add 1 0; Mul 0 118; Mul 79 96; Add 1 0; Add 9 0; Mul 128 7;
  Add 7 0; Mul 0 96; Mul 82 35; Add 1 0; Add 5 0; Mul 131 13; Add 13 0; Mul 0 98; Mul 85 32;
  Add 1 0; Add 5 0; Mul 19 113; Mul 96 135; Add 1 0; Mul 114 88; Mul 143 1; Add 1 0; Mul 0 140;
  Mul 91 118; Add 1 0; Add 9 0; Mul 146 7; Add 7 0; Mul 0 118; Mul 94 57; Add 1 0; Add 5 0;
  Mul 13 129; Mul 102 151; Add 1 0; Mul 130 97; Mul 155 1; Add 1 0; Mul 0 156; Mul 100 134;
  Add 1 0; Add 9 0; Sub 82 0;
  ShowZero 0; (* f_x *)
  Mul 154 161; Mul 0 162; Add 140 0; Mul 156 164; Mul 0 137; Add 2 0; Mul 158 167; Mul 0 136;
  Add 2 0; Mul 168 131; Mul 0 171; Add 2 0; Mul 163 134; Mul 0 146; Add 2 0; Mul 165 127;
  Mul 0 177; Add 2 0; Add 91 65; Mul 153 0; Add 90 0; Add 97 0; Mul 3 161; Mul 156 184; Add 1 0;
  Mul 155 0; Add 87 0; Add 5 0; Mul 3 167; Mul 158 190; Add 1 0; Mul 157 0; Add 84 0; Add 5 0;
  Add 82 106; Mul 204 0; Add 81 0; Mul 0 198; Add 0 79; Add 5 0; Mul 207 5; Add 86 0; Mul 0 175;
  Mul 161 24; Add 1 0; Add 5 0; Mul 210 11; Add 92 0; Mul 0 177; Mul 164 24; Add 1 0; Add 5 0;
  Mul 17 192; Mul 175 191; Add 1 0; Mul 221 0; Add 79 0; Mul 0 218; Add 0 77; Add 7 0; Mul 223 5;
  Add 84 0; Mul 0 195; Mul 171 44; Add 1 0; Add 5 0; Mul 11 206; Mul 179 205; Add 1 0; Mul 231 0;
  Add 77 0; Mul 0 232; Add 0 75; Add 7 0; Sub 56 0;
  ShowZero 0; (* f_y *)
  Mul 224 236; Mul 0 237; Add 215 0; Mul 226 239; Mul 0 212; Add 2 0; Mul 228 203; Mul 0 243;
  Add 2 0; Mul 230 245; Mul 0 246; Add 224 0; Mul 232 248; Mul 0 221; Add 2 0; Mul 238 212;
  Mul 0 252; Add 2 0; Mul 237 254; Mul 0 255; Add 233 0; Mul 239 257; Mul 0 230; Add 2 0;
  Mul 241 221; Mul 0 261; Add 2 0; Mul 240 240; Add 185 0; Add 1 185; Add 1 0; Mul 0 267;
  Mul 187 245; Add 1 0; Add 1 187; Add 1 0; Add 249 0; Add 9 187; Add 9 0; Add 187 11; Add 12 187;
  Add 1 0; Add 199 189; Add 3 0; Add 192 201; Add 0 2; Mul 7 254; Mul 196 193; Add 1 0; Mul 258 7;
  Add 2 0; Add 2 0; Mul 201 108; Mul 262 9; Add 1 0; Add 6 0; Add 9 3; Mul 266 11; Add 5 0;
  Add 2 0; Add 23 8; Add 24 5; Add 25 2; Add 35 204; Add 35 0; Mul 23 279; Mul 212 279; Add 1 0;
  Add 1 206; Add 1 0; Mul 26 284; Mul 127 284; Add 1 0; Mul 219 309; Add 0 212; Add 2 0;
  Mul 30 290; Mul 133 313; Add 1 0; Add 1 217; Add 1 0; Mul 16 285; Mul 222 219; Add 1 0;
  Mul 289 14; Add 2 0; Add 2 0; Mul 227 137; Mul 293 12; Add 1 0; Add 6 0; Add 9 3; Mul 297 11;
  Add 5 0; Add 2 0; Add 34 8; Add 34 5; Add 34 2; Add 70 230; Add 70 0; Mul 30 314; Mul 238 314;
  Add 1 0; Add 1 232; Add 1 0; Mul 29 319; Mul 156 319; Add 1 0; Mul 245 344; Add 0 238; Add 2 0;
  Mul 30 325; Mul 162 348; Add 1 0; Add 1 243; Add 1 0; Mul 16 316; Mul 248 245; Add 1 0;
  Mul 320 14; Add 2 0; Add 2 0; Mul 253 166; Mul 324 12; Add 1 0; Add 6 0; Add 9 3; Mul 328 11;
  Add 5 0; Add 2 0; Add 34 8; Add 34 5; Add 34 2; Add 256 290; Add 0 91; Add 1 94; Add 259 108;
  Add 0 96; Mul 351 259; Add 259 0; Mul 384 5; Add 2 0; Add 2 0; Mul 356 183; Mul 388 8; Add 1 0;
  Add 6 0; Add 267 3; Mul 392 10; Add 5 0; Add 2 0; Mul 8 387; Mul 270 365; Add 1 0; Add 1 270;
  Add 1 0; Mul 9 392; Mul 195 370; Add 1 0; Add 0 4; Mul 9 396; Add 0 3; Add 4 278; Add 1 0;
  Add 33 8; Add 33 5; Add 33 2; Mul 409 32; Add 29 0; Add 29 0; Mul 412 34; Add 27 0; Add 32 0;
  Mul 415 35; Add 30 0; Add 27 0; Mul 6 384; Mul 289 323; Add 1 0; Mul 372 137; Add 2 0; Add 2 0;
  Mul 9 390; Mul 216 329; Add 1 0; Mul 297 241; Mul 379 142; Add 1 0; Add 3 0; Mul 13 397;
  Mul 223 246; Add 1 0; Mul 385 146; Add 2 0; Add 2 0; Add 30 13; Add 30 7; Add 30 2; Mul 437 63;
  Add 60 0; Add 60 0; Mul 440 65; Add 58 0; Add 63 0; Mul 443 66; Add 61 0; Add 58 0; Mul 6 411;
  Mul 314 345; Add 1 0; Mul 400 140; Add 2 0; Add 2 0; Mul 9 417; Mul 241 351; Add 1 0;
  Mul 322 266; Mul 407 141; Add 1 0; Add 3 0; Mul 13 424; Mul 248 271; Add 1 0; Mul 413 142;
  Add 2 0; Add 2 0; Add 30 13; Add 30 7; Add 30 2; Mul 94 444; Mul 351 466; Add 1 0; Add 1 253;
  Add 1 0; Mul 98 449; Mul 275 471; Add 1 0; Mul 358 450; Add 0 259; Add 2 0; Mul 102 455;
  Mul 281 454; Add 1 0; Add 1 264; Add 1 0; Mul 458 344; Add 344 0; Mul 488 13; Add 2 0; Add 2 0;
  Mul 463 270; Mul 492 11; Add 1 0; Add 6 0; Add 352 3; Mul 496 10; Add 5 0; Add 2 0; Mul 8 494;
  Mul 355 472; Add 1 0; Add 1 355; Add 1 0; Mul 9 499; Mul 282 477; Add 1 0; Add 0 4; Mul 9 503;
  Add 0 3; Add 4 363; Add 1 0; Add 44 8; Add 44 5; Add 44 2; Mul 512 40; Add 29 0; Add 29 0;
  Mul 515 37; Add 27 0; Add 32 0; Mul 518 35; Add 30 0; Add 27 0; Mul 6 491; Mul 374 430; Add 1 0;
  Mul 469 244; Add 2 0; Add 2 0; Mul 9 497; Mul 303 436; Add 1 0; Mul 382 348; Mul 476 249;
  Add 1 0; Add 3 0; Mul 13 504; Mul 310 353; Add 1 0; Mul 482 253; Add 2 0; Add 2 0; Add 30 13;
  Add 30 7; Add 30 2; Mul 71 520; Mul 405 542; Add 1 0; Add 1 315; Add 1 0; Mul 70 525;
  Mul 331 547; Add 1 0; Mul 412 526; Add 0 321; Add 2 0; Mul 71 531; Mul 337 530; Add 1 0;
  Add 1 326; Add 1 0; Mul 534 404; Add 404 0; Mul 560 13; Add 2 0; Add 2 0; Mul 539 332;
  Mul 564 11; Add 1 0; Add 6 0; Add 412 3; Mul 568 10; Add 5 0; Add 2 0; Mul 8 570; Mul 415 548;
  Add 1 0; Add 1 415; Add 1 0; Mul 9 575; Mul 344 553; Add 1 0; Add 0 4; Mul 9 579; Add 0 3;
  Add 4 423; Add 1 0; Add 44 8; Add 44 5; Add 44 2; Mul 341 323; Mul 333 333; Sub 1 0; Mul 5 3;
  Mul 5 5; Sub 1 0; Sub 3 0;
  ShowZero 0; (* K *)
  Add 348 330; Div 594 605; Mul 1 0; Mul 607 0; Add 13 11; Sub 1 0;
  ShowZero 0 (* 2H *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** principal curvatures; size 1.
    Code: src/scalar/ring.rs, src/space/action.rs, src/space/motion.rs, src/space/point.rs,
    src/space/surface.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0, as in ordered fields *)
  Div 2 0; Sub 3 2; Mul 0 1; Mul 6 7; Mul 0 3; Unknown 1; Unknown 2; Constant 0; Mul 5 10;
  Mul 4 1; Sub 1 0; Mul 6 13; Mul 9 4; Add 1 0; Neg 9; Mul 0 7; Sub 7 0; Mul 2 19; Add 0 5;
  Mul 13 2; Mul 12 1; Add 1 0; Mul 14 5; Mul 16 4; Add 1 0; Mul 22 3; Mul 21 1; Sub 1 0; Mul 23 6;
  Mul 26 4; Add 1 0; Mul 3 20; Mul 1 18; Add 1 0; Mul 23 28; Sub 1 0;
  ShowZero 0; (* an eigenvector *)
  Sub 23 18; Add 21 28; Mul 32 1; Mul 31 1; Add 1 0; Mul 33 4; Mul 35 4; Add 1 0; Mul 39 3;
  Mul 42 1; Add 1 0; Mul 16 36; Mul 1 34; Add 1 0; Mul 36 44; Sub 1 0;
  ShowZero 0; (* an eigenvector *)
  Mul 41 2; Mul 39 19; Sub 1 0;
  ShowZero 0; (* a principal direction *)
  Sub 42 43; Add 46 47; Mul 29 1; Mul 27 1; Add 1 0; Mul 4 53; Sub 1 0;
  ShowZero 0; (* an eigenvector *)
  Mul 31 6; Mul 16 6; Add 1 0; Mul 8 58; Sub 1 0;
  ShowZero 0; (* an eigenvector *)
  Mul 11 2; Mul 11 8; Sub 1 0;
  ShowZero 0; (* a principal direction *)
  Mul 59 10; Mul 57 6; Add 1 0;
  ShowZero 0; (* conjugate *)
  Mul 62 17; Mul 60 17; Add 1 0;
  ShowZero 0; (* orthogonal *)
  Mul 48 29; Mul 46 46; Sub 1 0; Mul 73 72; Sub 1 0;
  ShowZero 0; (* K *)
  Add 53 34; Div 84 86; Mul 1 0; Mul 88 0; Add 79 78; Sub 1 0;
  ShowZero 0 (* 2H *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
