(** vertex-stress (ours)

    The weights of the edges at a vertex of a v-parallel pair (jump of the gradient over length)
    are in equilibrium; the mixed measure is the Laplacian of the heights of one mesh with the
    weights of the other; and the weights are the derivatives of the measure by the heights.

        Σ w_j e_j = 0,  2 D(v, s) = Σ w_j(f) (g_j - g_v) = Σ w_j(g) (f_j - f_v),  ∂D(v)/∂f_j = w_j

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** any two v-parallel stars; size 3.
    Code: src/pair/forms.rs, src/pair/star.rs, src/pair/v_parallel.rs, src/pair/vertex.rs,
    src/pair/weight.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 6; Unknown 7; Sub 1 17; Sub 1 17; Mul 11 0; Mul 11 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 14 14; Mul 14 14; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 18; Mul 7 20; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Sub 31 31;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 31 31;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 31 31;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 31 31;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 31 31;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 31 31;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 21 21;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 21 21;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowNonzero 27; (* as a test finds *)
  ShowNonzero 17; (* as a test finds *)
  ShowNonzero 11; (* as a test finds *)
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Sub 6 7; Sub 6 8; Constant 1; Div 0 38; Mul 3 42; Mul 45 3; Sub 1 0; Mul 0 3; Mul 49 6;
  Mul 8 48; Sub 1 0; Mul 0 7; Sub 16 19; Div 10 38; Mul 12 42; Mul 53 2; Sub 1 0; Mul 0 3;
  Mul 57 5; Mul 17 48; Sub 1 0; Mul 0 7; Div 19 41; Mul 10 63; Mul 52 23; Sub 1 0; Mul 0 3;
  Mul 56 26; Mul 15 69; Sub 1 0; Mul 0 7; Sub 33 34; Sub 33 35; Mul 1 71; Mul 74 1; Sub 1 0;
  Mul 0 32; Mul 78 4; Mul 6 77; Sub 1 0; Mul 0 36; Sub 41 44; Mul 9 70; Mul 81 1; Sub 1 0;
  Mul 0 31; Mul 85 4; Mul 14 76; Sub 1 0; Mul 0 35; Mul 8 90; Mul 79 19; Sub 1 0; Mul 0 30;
  Mul 83 22; Mul 13 96; Sub 1 0; Mul 0 34; Sub 40 50; Sub 37 47; Sub 14 23; Sub 11 20; Constant 0;
  Sub 36 55; Sub 33 52; Sub 11 28; Sub 8 25; Mul 8 0; Mul 8 2; Sub 1 0; Mul 9 5; Mul 9 7; Sub 1 0;
  Add 3 0; Add 11 0; Constant 4; Div 73 0; Mul 2 0; Mul 0 126; Div 76 111; Sub 72 53; Sub 69 50;
  Mul 123 0; Mul 123 2; Sub 1 0; Mul 0 5; Div 83 108; Mul 126 27; Mul 126 29; Sub 1 0; Mul 0 3;
  Div 88 107; Sub 65 74; Sub 62 71; Mul 123 0; Mul 123 2; Sub 1 0; Mul 0 5; Mul 12 66; Add 36 0;
  Mul 9 67; Add 1 0; Mul 4 60; Add 1 0; Sub 0 25;
  ShowZero 0; (* load *)
  Sub 68 51; Sub 65 48; Mul 148 0; Mul 148 2; Sub 1 0; Mul 0 30; Mul 150 49; Mul 150 51; Sub 1 0;
  Mul 0 27; Sub 61 69; Sub 58 66; Mul 146 0; Mul 146 2; Sub 1 0; Mul 0 28; Mul 10 120; Add 59 0;
  Mul 8 121; Add 1 0; Mul 4 112; Add 1 0; Sub 0 48;
  ShowZero 0; (* Laplacian *)
  Mul 169 42; Add 66 0; Mul 169 39; Add 1 0; Mul 161 34; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 174 48; Add 72 0; Mul 174 45; Add 1 0; Mul 166 40; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 181 29; Add 78 0; Mul 181 27; Add 1 0; Mul 173 23; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 186 35; Add 84 0; Mul 186 33; Add 1 0; Mul 178 29; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 93 87; Mul 93 89; Sub 1 0; Add 92 0; Mul 0 204; Mul 176 182; Mul 199 186; Mul 199 188;
  Sub 1 0; Mul 160 186; Mul 160 1; Sub 1 0; Mul 151 199; Add 1 0; Mul 164 0; Mul 0 186; Add 105 0;
  Mul 166 204; Mul 209 210; Mul 209 212; Sub 1 0; Mul 171 192; Mul 161 1; Sub 1 0; Add 0 14;
  Mul 164 0; Mul 0 8; Add 10 0; Mul 177 205; Mul 210 219; Mul 210 221; Sub 1 0; Mul 183 0;
  Sub 20 0; Add 0 12; Mul 186 0; Mul 0 7; Add 9 0; Mul 0 238; Mul 33 226; Mul 35 0; Sub 2 0;
  ShowZero 0; (* 4 D(v) *)
  Mul 161 28; Mul 0 214; Add 133 0; Mul 155 20; Mul 0 28; Add 2 0; Mul 168 13; Mul 0 20; Add 2 0;
  Mul 0 251; Mul 129 12; Sub 1 0;
  ShowZero 0; (* 4 D(v, s) *)
  Mul 145 139; Mul 145 141; Sub 1 0; Add 146 0; Mul 0 258; Mul 179 236; Mul 179 51; Sub 1 0;
  Mul 172 249; Add 1 0; Mul 183 0; Mul 0 236; Add 155 0; Mul 186 238; Mul 178 47; Sub 1 0;
  Add 0 10; Mul 181 0; Mul 0 54; Add 6 0; Mul 194 42; Sub 12 0; Add 0 8; Mul 197 0; Mul 0 49;
  Add 5 0; Mul 0 280; Mul 22 41; Sub 1 0;
  ShowZero 0; (* 4 D(s) *)
  Add 172 149; Add 0 145; Add 0 139; Neg 0; Add 246 236; Constant (-1); Add 248 0; Sub 248 2;
  Sub 248 3; Mul 1 282; Mul 285 1; Sub 1 0; Mul 0 243; Mul 289 4; Mul 6 288; Sub 1 0; Mul 0 247;
  Sub 256 12; Mul 9 281; Mul 292 1; Sub 1 0; Mul 0 242; Mul 296 4; Mul 14 287; Sub 1 0; Mul 0 246;
  Mul 8 301; Mul 290 19; Sub 1 0; Mul 0 241; Mul 294 22; Mul 13 307; Sub 1 0; Mul 0 245;
  Sub 275 27; Sub 275 28; Mul 1 309; Mul 312 1; Sub 1 0; Mul 0 270; Mul 316 4; Mul 6 315; Sub 1 0;
  Mul 0 274; Sub 283 37; Mul 9 308; Mul 319 1; Sub 1 0; Mul 0 269; Mul 323 4; Mul 14 314; Sub 1 0;
  Mul 0 273; Mul 8 328; Mul 317 19; Sub 1 0; Mul 0 268; Mul 321 22; Mul 13 334; Sub 1 0;
  Mul 0 272; Sub 39 48; Sub 36 45; Sub 33 50; Sub 30 47; Mul 3 0; Mul 3 2; Sub 1 0; Add 240 0;
  Mul 0 352; Sub 21 30; Sub 18 27; Sub 15 32; Sub 12 29; Mul 3 0; Mul 3 2; Sub 1 0; Add 249 0;
  Mul 0 361; Mul 9 237; Mul 1 238; Sub 1 0; Mul 78 365; Sub 1 0;
  ShowZero 0; (* derivative of D(v) *)
  Add 325 316; Add 326 79; Sub 1 328; Mul 0 360; Sub 0 317; Mul 0 320; Mul 3 364; Sub 317 0;
  Mul 0 323; Mul 356 6; Sub 305 0; Mul 0 307; Mul 360 9; Sub 0 303; Mul 0 310; Sub 13 341;
  Mul 0 373; Sub 0 330; Mul 0 333; Mul 3 377; Sub 330 0; Mul 0 336; Mul 369 6; Sub 318 0;
  Mul 0 320; Mul 373 9; Sub 0 316; Mul 0 323; Sub 329 22; Sub 326 20; Sub 18 24; Sub 16 22;
  Mul 3 0; Mul 3 2; Sub 1 0; Add 291 0; Mul 0 403; Sub 338 18; Sub 335 16; Sub 14 20; Sub 12 18;
  Mul 3 0; Mul 3 2; Sub 1 0; Add 300 0; Mul 0 412; Mul 9 288; Mul 1 289; Sub 1 0; Mul 282 416;
  Sub 1 0;
  ShowZero 0 (* derivative of D(v) *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** any two v-parallel stars; size 4.
    Code: src/pair/forms.rs, src/pair/star.rs, src/pair/v_parallel.rs, src/pair/vertex.rs,
    src/pair/weight.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 6; Unknown 7; Sub 1 17; Sub 1 17; Mul 11 0; Mul 11 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 14 14; Mul 14 14; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 8; Unknown 9; Sub 1 27; Sub 1 27; Mul 11 0; Mul 11 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 14 14; Mul 14 14; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 28; Mul 7 30; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Sub 41 41;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 41 41;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 41 41;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 41 41;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 41 41;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 41 41;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 31 31;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 31 31;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 23 23;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 23 23;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowNonzero 39; (* as a test finds *)
  ShowNonzero 29; (* as a test finds *)
  ShowNonzero 19; (* as a test finds *)
  ShowNonzero 13; (* as a test finds *)
  Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15; Unknown 16; Unknown 17;
  Unknown 18; Unknown 19; Sub 8 9; Sub 8 10; Constant 1; Div 0 52; Mul 3 56; Mul 59 3; Sub 1 0;
  Mul 0 3; Mul 63 6; Mul 8 62; Sub 1 0; Mul 0 7; Sub 18 21; Div 10 52; Mul 12 56; Mul 67 2;
  Sub 1 0; Mul 0 3; Mul 71 5; Mul 17 62; Sub 1 0; Mul 0 7; Sub 27 31; Div 20 52; Mul 11 56;
  Mul 67 2; Sub 1 0; Mul 0 3; Mul 71 5; Mul 16 62; Sub 1 0; Mul 0 7; Div 29 55; Mul 10 87;
  Mul 66 33; Sub 1 0; Mul 0 3; Mul 70 36; Mul 15 93; Sub 1 0; Mul 0 7; Sub 44 45; Sub 44 46;
  Mul 1 95; Mul 98 1; Sub 1 0; Mul 0 42; Mul 102 4; Mul 6 101; Sub 1 0; Mul 0 46; Sub 52 55;
  Mul 9 94; Mul 105 1; Sub 1 0; Mul 0 41; Mul 109 4; Mul 14 100; Sub 1 0; Mul 0 45; Sub 60 64;
  Mul 9 93; Mul 104 1; Sub 1 0; Mul 0 40; Mul 108 4; Mul 14 99; Sub 1 0; Mul 0 44; Mul 8 123;
  Mul 102 28; Sub 1 0; Mul 0 39; Mul 106 31; Mul 13 129; Sub 1 0; Mul 0 43; Sub 59 69; Sub 56 66;
  Sub 23 32; Sub 20 29; Constant 0; Sub 54 74; Sub 51 71; Sub 19 37; Sub 16 34; Mul 8 0; Mul 8 2;
  Sub 1 0; Mul 9 5; Mul 9 7; Sub 1 0; Add 3 0; Add 11 0; Sub 57 86; Sub 54 83; Sub 23 49;
  Sub 20 46; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0;
  Constant 4; Div 104 0; Mul 2 0; Mul 0 171; Div 107 156; Sub 103 74; Sub 100 71; Mul 168 0;
  Mul 168 2; Sub 1 0; Mul 0 5; Div 114 153; Mul 171 39; Mul 171 41; Sub 1 0; Mul 0 3; Div 119 148;
  Sub 95 105; Sub 92 102; Mul 168 0; Mul 168 2; Sub 1 0; Mul 0 5; Div 126 149; Sub 93 102;
  Sub 90 99; Mul 165 0; Mul 165 2; Sub 1 0; Mul 0 5; Mul 19 94; Add 55 0; Mul 16 95; Add 1 0;
  Mul 11 88; Add 1 0; Mul 6 81; Add 1 0; Sub 0 34;
  ShowZero 0; (* load *)
  Sub 98 72; Sub 95 69; Mul 202 0; Mul 202 2; Sub 1 0; Mul 0 39; Mul 204 70; Mul 204 72; Sub 1 0;
  Mul 0 36; Sub 90 99; Sub 87 96; Mul 200 0; Mul 200 2; Sub 1 0; Mul 0 37; Sub 88 96; Sub 85 93;
  Mul 196 0; Mul 196 2; Sub 1 0; Mul 0 36; Mul 16 166; Add 86 0; Mul 14 167; Add 1 0; Mul 10 158;
  Add 1 0; Mul 6 150; Add 1 0; Sub 0 65;
  ShowZero 0; (* Laplacian *)
  Mul 231 59; Add 95 0; Mul 231 56; Add 1 0; Mul 223 51; Add 1 0; Mul 215 46; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 238 67; Add 103 0; Mul 238 64; Add 1 0; Mul 230 59; Add 1 0; Mul 222 54; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 247 41; Add 111 0; Mul 247 39; Add 1 0; Mul 239 35; Add 1 0; Mul 231 31; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 254 49; Add 119 0; Mul 254 47; Add 1 0; Mul 246 43; Add 1 0; Mul 238 39; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 130 124; Mul 130 126; Sub 1 0; Add 129 0; Mul 129 116; Mul 129 118; Sub 1 0; Add 3 0;
  Mul 0 278; Mul 240 246; Mul 0 257; Mul 274 261; Mul 274 263; Sub 1 0; Mul 221 261; Mul 221 1;
  Sub 1 0; Mul 212 274; Add 1 0; Mul 225 0; Mul 0 10; Add 147 0; Mul 227 279; Mul 284 263;
  Mul 284 265; Sub 1 0; Mul 232 263; Mul 222 1; Sub 1 0; Mul 214 276; Add 1 0; Mul 8 262;
  Mul 227 1; Mul 0 1; Add 12 0; Mul 12 282; Mul 241 283; Mul 288 299; Mul 288 301; Sub 1 0;
  Mul 235 271; Mul 226 1; Sub 1 0; Mul 250 280; Add 1 0; Mul 230 0; Mul 0 10; Add 12 0;
  Mul 11 285; Mul 290 309; Mul 290 311; Sub 1 0; Mul 237 309; Mul 260 1; Sub 1 0; Mul 261 286;
  Add 1 0; Mul 264 0; Mul 0 9; Add 11 0; Mul 0 330; Mul 50 318; Mul 53 0; Sub 2 0;
  ShowZero 0; (* 4 D(v) *)
  Mul 229 45; Mul 0 55; Add 192 0; Mul 223 36; Mul 0 36; Add 2 0; Mul 217 25; Mul 0 35; Add 2 0;
  Mul 239 16; Mul 0 25; Add 2 0; Mul 0 346; Mul 179 15; Sub 1 0;
  ShowZero 0; (* 4 D(v, s) *)
  Mul 207 201; Mul 207 203; Sub 1 0; Add 208 0; Mul 206 193; Mul 206 195; Sub 1 0; Add 3 0;
  Mul 0 357; Mul 254 335; Mul 254 75; Sub 1 0; Mul 247 348; Add 1 0; Mul 258 0; Mul 0 84;
  Add 221 0; Mul 261 333; Mul 253 71; Sub 1 0; Mul 246 346; Add 1 0; Mul 257 0; Mul 0 70; Add 7 0;
  Mul 260 335; Mul 252 65; Sub 1 0; Mul 273 344; Add 1 0; Mul 256 0; Mul 0 74; Add 7 0;
  Mul 259 369; Mul 279 61; Sub 1 0; Mul 280 346; Add 1 0; Mul 283 0; Mul 0 69; Add 7 0; Mul 0 390;
  Mul 33 59; Sub 1 0;
  ShowZero 0; (* 4 D(s) *)
  Add 249 214; Add 0 210; Add 0 204; Add 0 198; Neg 0; Add 345 333; Constant (-1); Add 347 0;
  Sub 347 2; Sub 347 3; Mul 1 393; Mul 396 1; Sub 1 0; Mul 0 340; Mul 400 4; Mul 6 399; Sub 1 0;
  Mul 0 344; Sub 355 12; Mul 9 392; Mul 403 1; Sub 1 0; Mul 0 339; Mul 407 4; Mul 14 398; Sub 1 0;
  Mul 0 343; Sub 363 21; Mul 9 391; Mul 402 1; Sub 1 0; Mul 0 338; Mul 406 4; Mul 14 397; Sub 1 0;
  Mul 0 342; Mul 8 421; Mul 400 28; Sub 1 0; Mul 0 337; Mul 404 31; Mul 13 427; Sub 1 0;
  Mul 0 341; Sub 383 36; Sub 383 37; Mul 1 429; Mul 432 1; Sub 1 0; Mul 0 376; Mul 436 4;
  Mul 6 435; Sub 1 0; Mul 0 380; Sub 391 46; Mul 9 428; Mul 439 1; Sub 1 0; Mul 0 375; Mul 443 4;
  Mul 14 434; Sub 1 0; Mul 0 379; Sub 399 55; Mul 9 427; Mul 438 1; Sub 1 0; Mul 0 374; Mul 442 4;
  Mul 14 433; Sub 1 0; Mul 0 378; Mul 8 457; Mul 436 28; Sub 1 0; Mul 0 373; Mul 440 31;
  Mul 13 463; Sub 1 0; Mul 0 377; Sub 57 66; Sub 54 63; Sub 50 68; Sub 47 65; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 336 0; Sub 48 74; Sub 45 71; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 487;
  Sub 36 45; Sub 33 42; Sub 29 47; Sub 26 44; Mul 3 0; Mul 3 2; Sub 1 0; Add 351 0; Sub 27 53;
  Sub 24 50; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 502; Mul 15 333; Mul 1 334; Sub 1 0;
  Mul 108 506; Sub 1 0;
  ShowZero 0; (* derivative of D(v) *)
  Add 454 443; Add 455 109; Sub 1 457; Mul 0 501; Sub 0 444; Mul 0 447; Mul 3 505; Sub 444 0;
  Mul 0 450; Mul 487 6; Sub 422 0; Mul 0 424; Mul 491 9; Sub 0 420; Mul 0 427; Sub 13 470;
  Mul 0 514; Sub 0 457; Mul 0 460; Mul 3 518; Sub 457 0; Mul 0 463; Mul 500 6; Sub 435 0;
  Mul 0 437; Mul 504 9; Sub 0 433; Mul 0 440; Sub 456 22; Sub 453 20; Sub 448 24; Sub 445 22;
  Mul 3 0; Mul 3 2; Sub 1 0; Add 399 0; Sub 24 30; Sub 22 28; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Mul 0 550; Sub 471 24; Sub 468 22; Sub 463 26; Sub 460 24; Mul 3 0; Mul 3 2; Sub 1 0; Add 414 0;
  Sub 26 32; Sub 24 30; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 565; Mul 15 396; Mul 1 397;
  Sub 1 0; Mul 390 569; Sub 1 0;
  ShowZero 0 (* derivative of D(v) *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 3.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs, src/pair/weight.rs,
    src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Constant 0; Sub 6 8; Sub 6 8; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9;
  Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 8; Sub 29 25; Sub 29 25; Neg 0; Mul 0 3; Mul 3 4; Sub 1 26; Sub 1 27; Mul 15 0;
  Mul 15 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 18 18; Mul 18 18; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 22; Mul 7 24; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Sub 40 40;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 37 37;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 37 37;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 34 34;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 34 34;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 20 20;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 20 20;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 9; Mul 47 0; Mul 47 1; Add 50 1; Add 51 1; Mul 46 4; Mul 46 5; Add 3 1; Add 3 1;
  Mul 64 52; Mul 64 52; Add 1 0; Mul 65 50; Mul 65 50; Add 1 0; Mul 66 37; Mul 66 37; Add 1 0;
  Mul 65 61; Mul 66 61; Add 1 0; Mul 17 59; Mul 17 59; Add 1 0; Mul 16 46; Mul 16 46; Add 1 0;
  Sub 9 74; Sub 16 75; Constant 1; Div 0 40; Mul 3 66; Mul 51 3; Sub 1 0; Mul 0 3; Mul 55 6;
  Mul 8 72; Sub 1 0; Mul 0 7; Sub 24 86; Div 10 70; Mul 12 74; Mul 77 2; Sub 1 0; Mul 0 3;
  Mul 81 5; Mul 17 80; Sub 1 0; Mul 0 7; Div 19 65; Mul 10 69; Mul 84 23; Sub 1 0; Mul 0 3;
  Mul 88 26; Mul 15 75; Sub 1 0; Mul 0 7; Sub 31 105; Sub 38 106; Mul 1 95; Mul 80 1; Sub 1 0;
  Mul 0 32; Mul 84 4; Mul 6 101; Sub 1 0; Mul 0 36; Sub 44 115; Mul 9 102; Mul 105 1; Sub 1 0;
  Mul 0 31; Mul 109 4; Mul 14 108; Sub 1 0; Mul 0 35; Mul 8 96; Mul 111 19; Sub 1 0; Mul 0 30;
  Mul 115 22; Mul 13 102; Sub 1 0; Mul 0 34; Sub 40 50; Sub 37 47; Sub 14 23; Sub 11 20;
  Sub 35 54; Sub 32 51; Sub 10 27; Sub 7 24; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0;
  Add 3 0; Add 147 0; Constant 4; Div 72 0; Mul 2 0; Mul 0 160; Div 75 112; Sub 71 52; Sub 68 49;
  Mul 128 0; Mul 128 2; Sub 1 0; Mul 0 5; Div 82 139; Mul 149 26; Mul 149 28; Sub 1 0; Mul 0 3;
  Div 87 130; Sub 64 73; Sub 61 70; Mul 154 0; Mul 154 2; Sub 1 0; Mul 0 5; Mul 12 65; Add 172 0;
  Mul 9 66; Add 1 0; Mul 4 59; Add 1 0; Sub 0 25;
  ShowZero 0; (* load *)
  Sub 67 50; Sub 64 47; Mul 153 0; Mul 153 2; Sub 1 0; Mul 0 30; Mul 173 48; Mul 173 50; Sub 1 0;
  Mul 0 27; Sub 60 68; Sub 57 65; Mul 177 0; Mul 177 2; Sub 1 0; Mul 0 28; Mul 10 119; Add 195 0;
  Mul 8 120; Add 1 0; Mul 4 111; Add 1 0; Sub 0 48;
  ShowZero 0; (* Laplacian *)
  Mul 174 42; Add 202 0; Mul 192 39; Add 1 0; Mul 192 34; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 179 48; Add 208 0; Mul 197 45; Add 1 0; Mul 197 40; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 186 29; Add 214 0; Mul 204 27; Add 1 0; Mul 204 23; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 191 35; Add 220 0; Mul 209 33; Add 1 0; Mul 209 29; Add 1 0;
  ShowZero 0 (* equilibrium *)
].

Theorem part_2_size_3_valid : valid part_2_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 4.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs, src/pair/weight.rs,
    src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Constant 0; Sub 4 17; Sub 4 17; Neg 0; Mul 0 5;
  Mul 3 6; Sub 20 9; Sub 20 9; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13;
  Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 10; Neg 31; Mul 0 1; Mul 34 2; Sub 1 24; Sub 1 25; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 11; Neg 41; Mul 0 1; Mul 44 2; Sub 1 36; Sub 1 37; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 32; Mul 7 34; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Sub 50 50;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 47 47;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 47 47;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 44 44;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 44 44;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 32 32;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 32 32;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 22 22;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 22 22;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 12; Unknown 13; Mul 60 1; Mul 60 2; Add 63 1; Add 64 1; Mul 59 4; Mul 59 5; Add 3 1;
  Add 3 1; Sub 69 1; Sub 70 1; Mul 1 79; Mul 1 81; Sub 1 0; Div 0 79; Mul 86 0; Mul 86 1; Add 9 1;
  Add 9 1; Mul 96 75; Mul 96 75; Add 1 0; Mul 86 73; Mul 86 73; Add 1 0; Mul 100 62; Mul 100 62;
  Add 1 0; Mul 101 53; Mul 101 53; Add 1 0; Mul 91 87; Mul 92 87; Add 1 0; Mul 30 85; Mul 30 85;
  Add 1 0; Mul 29 74; Mul 29 74; Add 1 0; Mul 22 65; Mul 22 65; Add 1 0; Sub 12 103; Sub 22 104;
  Constant 1; Div 0 59; Mul 3 95; Mul 70 3; Sub 1 0; Mul 0 3; Mul 74 6; Mul 8 101; Sub 1 0;
  Mul 0 7; Sub 30 115; Div 10 99; Mul 12 103; Mul 106 2; Sub 1 0; Mul 0 3; Mul 110 5; Mul 17 109;
  Sub 1 0; Mul 0 7; Sub 37 125; Div 20 97; Mul 11 101; Mul 114 2; Sub 1 0; Mul 0 3; Mul 118 5;
  Mul 16 107; Sub 1 0; Mul 0 7; Div 29 94; Mul 10 98; Mul 111 33; Sub 1 0; Mul 0 3; Mul 115 36;
  Mul 15 104; Sub 1 0; Mul 0 7; Sub 41 144; Sub 51 145; Mul 1 134; Mul 109 1; Sub 1 0; Mul 0 42;
  Mul 113 4; Mul 6 140; Sub 1 0; Mul 0 46; Sub 57 154; Mul 9 141; Mul 144 1; Sub 1 0; Mul 0 41;
  Mul 148 4; Mul 14 147; Sub 1 0; Mul 0 45; Sub 63 163; Mul 9 138; Mul 151 1; Sub 1 0; Mul 0 40;
  Mul 155 4; Mul 14 144; Sub 1 0; Mul 0 44; Mul 8 134; Mul 147 28; Sub 1 0; Mul 0 39; Mul 151 31;
  Mul 13 140; Sub 1 0; Mul 0 43; Sub 59 69; Sub 56 66; Sub 23 32; Sub 20 29; Sub 53 73; Sub 50 70;
  Sub 18 36; Sub 15 33; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 195 0;
  Sub 56 85; Sub 53 82; Sub 22 48; Sub 19 45; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7;
  Sub 1 0; Add 3 0; Add 11 0; Constant 4; Div 103 0; Mul 2 0; Mul 0 229; Div 106 162; Sub 102 73;
  Sub 99 70; Mul 178 0; Mul 178 2; Sub 1 0; Mul 0 5; Div 113 199; Mul 209 38; Mul 209 40; Sub 1 0;
  Mul 0 3; Div 118 192; Sub 94 104; Sub 91 101; Mul 214 0; Mul 214 2; Sub 1 0; Mul 0 5;
  Div 125 187; Sub 92 101; Sub 89 98; Mul 209 0; Mul 209 2; Sub 1 0; Mul 0 5; Mul 19 93;
  Add 239 0; Mul 16 94; Add 1 0; Mul 11 87; Add 1 0; Mul 6 80; Add 1 0; Sub 0 34;
  ShowZero 0; (* load *)
  Sub 97 71; Sub 94 68; Mul 212 0; Mul 212 2; Sub 1 0; Mul 0 39; Mul 242 69; Mul 242 71; Sub 1 0;
  Mul 0 36; Sub 89 98; Sub 86 95; Mul 246 0; Mul 246 2; Sub 1 0; Mul 0 37; Sub 87 95; Sub 84 92;
  Mul 240 0; Mul 240 2; Sub 1 0; Mul 0 36; Mul 16 165; Add 270 0; Mul 14 166; Add 1 0; Mul 10 157;
  Add 1 0; Mul 6 149; Add 1 0; Sub 0 65;
  ShowZero 0; (* Laplacian *)
  Mul 241 59; Add 279 0; Mul 269 56; Add 1 0; Mul 269 51; Add 1 0; Mul 259 46; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 248 67; Add 287 0; Mul 276 64; Add 1 0; Mul 276 59; Add 1 0; Mul 266 54; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 257 41; Add 295 0; Mul 285 39; Add 1 0; Mul 285 35; Add 1 0; Mul 275 31; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 264 49; Add 303 0; Mul 292 47; Add 1 0; Mul 292 43; Add 1 0; Mul 282 39; Add 1 0;
  ShowZero 0 (* equilibrium *)
].

Theorem part_2_size_4_valid : valid part_2_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 5.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs, src/pair/weight.rs,
    src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_5 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 0; Sub 6 19;
  Sub 6 19; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10;
  Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 12; Sub 38 25; Sub 38 25; Neg 0; Mul 0 3; Mul 3 4; Sub 1 26; Sub 1 27; Mul 15 0;
  Mul 15 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 18 18; Mul 18 18; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 13; Neg 47; Mul 0 1; Mul 50 2; Sub 1 38; Sub 1 39; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 14; Neg 57; Mul 0 1; Mul 60 2; Sub 1 50; Sub 1 51; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 46; Mul 7 48; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Sub 64 64;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 61 61;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 61 61;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 58 58;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 58 58;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 44 44;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 44 44;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 34 34;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 34 34;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 15; Unknown 16; Unknown 17; Mul 77 2; Mul 77 3; Add 80 1; Add 81 1; Mul 76 5; Mul 76 6;
  Add 3 1; Add 3 1; Mul 64 8; Mul 64 9; Add 3 1; Add 3 1; Sub 90 1; Sub 91 1; Mul 1 102;
  Mul 1 104; Sub 1 0; Div 0 102; Mul 109 0; Mul 109 1; Add 9 1; Add 9 1; Mul 119 96; Mul 119 96;
  Add 1 0; Mul 109 94; Mul 109 94; Add 1 0; Mul 110 81; Mul 110 81; Add 1 0; Mul 126 72;
  Mul 126 72; Add 1 0; Mul 127 63; Mul 127 63; Add 1 0; Mul 115 111; Mul 116 111; Add 1 0;
  Mul 37 109; Mul 37 109; Add 1 0; Mul 36 96; Mul 36 96; Add 1 0; Mul 35 87; Mul 35 87; Add 1 0;
  Mul 28 78; Mul 28 78; Add 1 0; Sub 15 130; Sub 28 131; Constant 1; Div 0 72; Mul 3 122;
  Mul 83 3; Sub 1 0; Mul 0 3; Mul 87 6; Mul 8 128; Sub 1 0; Mul 0 7; Sub 36 142; Div 10 126;
  Mul 12 130; Mul 133 2; Sub 1 0; Mul 0 3; Mul 137 5; Mul 17 136; Sub 1 0; Mul 0 7; Sub 43 152;
  Div 20 122; Mul 11 126; Mul 141 2; Sub 1 0; Mul 0 3; Mul 145 5; Mul 16 132; Sub 1 0; Mul 0 7;
  Sub 50 162; Div 30 120; Mul 11 124; Mul 137 2; Sub 1 0; Mul 0 3; Mul 141 5; Mul 16 130; Sub 1 0;
  Mul 0 7; Div 39 117; Mul 10 121; Mul 134 43; Sub 1 0; Mul 0 3; Mul 138 46; Mul 15 127; Sub 1 0;
  Mul 0 7; Sub 51 181; Sub 64 182; Mul 1 171; Mul 132 1; Sub 1 0; Mul 0 52; Mul 136 4; Mul 6 177;
  Sub 1 0; Mul 0 56; Sub 70 191; Mul 9 178; Mul 181 1; Sub 1 0; Mul 0 51; Mul 185 4; Mul 14 184;
  Sub 1 0; Mul 0 55; Sub 76 200; Mul 9 173; Mul 188 1; Sub 1 0; Mul 0 50; Mul 192 4; Mul 14 179;
  Sub 1 0; Mul 0 54; Sub 82 209; Mul 9 170; Mul 183 1; Sub 1 0; Mul 0 49; Mul 187 4; Mul 14 176;
  Sub 1 0; Mul 0 53; Mul 8 166; Mul 179 37; Sub 1 0; Mul 0 48; Mul 183 40; Mul 13 172; Sub 1 0;
  Mul 0 52; Sub 78 88; Sub 75 85; Sub 32 41; Sub 29 38; Sub 72 92; Sub 69 89; Sub 27 45;
  Sub 24 42; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 241 0; Sub 74 104;
  Sub 71 101; Sub 30 57; Sub 27 54; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0;
  Add 3 0; Add 11 0; Sub 77 116; Sub 74 113; Sub 34 69; Sub 31 66; Mul 15 0; Mul 15 2; Sub 1 0;
  Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Constant 4; Div 134 0; Mul 2 0; Mul 0 289;
  Div 137 206; Sub 133 94; Sub 130 91; Mul 222 0; Mul 222 2; Sub 1 0; Mul 0 5; Div 144 257;
  Mul 267 50; Mul 267 52; Sub 1 0; Mul 0 3; Div 149 248; Sub 125 135; Sub 122 132; Mul 272 0;
  Mul 272 2; Sub 1 0; Mul 0 5; Div 156 243; Sub 122 132; Sub 119 129; Mul 265 0; Mul 265 2;
  Sub 1 0; Mul 0 5; Div 163 238; Sub 120 129; Sub 117 126; Mul 260 0; Mul 260 2; Sub 1 0; Mul 0 5;
  Mul 26 121; Add 304 0; Mul 23 122; Add 1 0; Mul 18 115; Add 1 0; Mul 13 108; Add 1 0; Mul 8 101;
  Add 1 0; Sub 0 43;
  ShowZero 0; (* load *)
  Sub 127 92; Sub 124 89; Mul 265 0; Mul 265 2; Sub 1 0; Mul 0 48; Mul 309 90; Mul 309 92;
  Sub 1 0; Mul 0 45; Sub 119 128; Sub 116 125; Mul 313 0; Mul 313 2; Sub 1 0; Mul 0 46;
  Sub 116 125; Sub 113 122; Mul 305 0; Mul 305 2; Sub 1 0; Mul 0 45; Sub 114 122; Sub 111 119;
  Mul 299 0; Mul 299 2; Sub 1 0; Mul 0 44; Mul 22 211; Add 343 0; Mul 20 212; Add 1 0; Mul 16 203;
  Add 1 0; Mul 12 195; Add 1 0; Mul 8 187; Add 1 0; Sub 0 82;
  ShowZero 0; (* Laplacian *)
  Mul 302 76; Add 354 0; Mul 344 73; Add 1 0; Mul 344 68; Add 1 0; Mul 332 63; Add 1 0;
  Mul 322 58; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 311 86; Add 364 0; Mul 353 83; Add 1 0; Mul 353 78; Add 1 0; Mul 341 73; Add 1 0;
  Mul 331 68; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 322 53; Add 374 0; Mul 364 51; Add 1 0; Mul 364 47; Add 1 0; Mul 352 43; Add 1 0;
  Mul 342 39; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 331 63; Add 384 0; Mul 373 61; Add 1 0; Mul 373 57; Add 1 0; Mul 361 53; Add 1 0;
  Mul 351 49; Add 1 0;
  ShowZero 0 (* equilibrium *)
].

Theorem part_2_size_5_valid : valid part_2_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 6.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs, src/pair/weight.rs,
    src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_6 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 0; Sub 6 19;
  Sub 6 19; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10;
  Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 12; Unknown 13; Unknown 14; Sub 2 27; Sub 2 27; Neg 0; Mul 0 3; Mul 3 4; Sub 1 28;
  Sub 1 29; Mul 17 0; Mul 17 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 20 20; Mul 20 20; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 15; Sub 54 16; Sub 54 16; Neg 0; Mul 0 3; Mul 3 4; Sub 1 42; Sub 1 43; Mul 15 0;
  Mul 15 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 18 18; Mul 18 18; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 16; Neg 63; Mul 0 1; Mul 66 2; Sub 1 54; Sub 1 55; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 17; Neg 73; Mul 0 1; Mul 76 2; Sub 1 66; Sub 1 67; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 62; Mul 7 64; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Sub 80 80;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 77 77;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 77 77;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 74 74;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 74 74;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 58 58;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 58 58;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 46 46;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 46 46;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 36 36;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 36 36;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 26 26;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 26 26;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 18; Unknown 19; Unknown 20; Unknown 21; Mul 96 3; Mul 96 4; Add 99 1; Add 100 1;
  Mul 95 6; Mul 95 7; Add 3 1; Add 3 1; Mul 81 9; Mul 81 10; Add 3 1; Add 3 1; Mul 71 12;
  Mul 71 13; Add 3 1; Add 3 1; Sub 113 1; Sub 114 1; Mul 1 125; Mul 1 127; Sub 1 0; Div 0 125;
  Mul 132 0; Mul 132 1; Add 9 1; Add 9 1; Mul 142 119; Mul 142 119; Add 1 0; Mul 132 117;
  Mul 132 117; Add 1 0; Mul 133 102; Mul 133 102; Add 1 0; Mul 111 91; Mul 111 91; Add 1 0;
  Mul 152 82; Mul 152 82; Add 1 0; Mul 153 73; Mul 153 73; Add 1 0; Mul 141 137; Mul 142 137;
  Add 1 0; Mul 44 135; Mul 44 135; Add 1 0; Mul 43 120; Mul 43 120; Add 1 0; Mul 42 109;
  Mul 42 109; Add 1 0; Mul 41 100; Mul 41 100; Add 1 0; Mul 34 91; Mul 34 91; Add 1 0; Sub 18 159;
  Sub 34 160; Constant 1; Div 0 85; Mul 3 151; Mul 96 3; Sub 1 0; Mul 0 3; Mul 100 6; Mul 8 157;
  Sub 1 0; Mul 0 7; Sub 42 171; Div 10 155; Mul 12 159; Mul 162 2; Sub 1 0; Mul 0 3; Mul 166 5;
  Mul 17 165; Sub 1 0; Mul 0 7; Sub 49 181; Div 20 149; Mul 11 153; Mul 170 2; Sub 1 0; Mul 0 3;
  Mul 174 5; Mul 16 159; Sub 1 0; Mul 0 7; Sub 56 191; Div 30 145; Mul 11 149; Mul 164 2; Sub 1 0;
  Mul 0 3; Mul 168 5; Mul 16 155; Sub 1 0; Mul 0 7; Sub 63 201; Div 40 143; Mul 11 147; Mul 160 2;
  Sub 1 0; Mul 0 3; Mul 164 5; Mul 16 153; Sub 1 0; Mul 0 7; Div 49 140; Mul 10 144; Mul 157 53;
  Sub 1 0; Mul 0 3; Mul 161 56; Mul 15 150; Sub 1 0; Mul 0 7; Sub 61 220; Sub 77 221; Mul 1 210;
  Mul 155 1; Sub 1 0; Mul 0 62; Mul 159 4; Mul 6 216; Sub 1 0; Mul 0 66; Sub 83 230; Mul 9 217;
  Mul 220 1; Sub 1 0; Mul 0 61; Mul 224 4; Mul 14 223; Sub 1 0; Mul 0 65; Sub 89 239; Mul 9 210;
  Mul 227 1; Sub 1 0; Mul 0 60; Mul 231 4; Mul 14 216; Sub 1 0; Mul 0 64; Sub 95 248; Mul 9 205;
  Mul 220 1; Sub 1 0; Mul 0 59; Mul 224 4; Mul 14 211; Sub 1 0; Mul 0 63; Sub 101 257; Mul 9 202;
  Mul 215 1; Sub 1 0; Mul 0 58; Mul 219 4; Mul 14 208; Sub 1 0; Mul 0 62; Mul 8 198; Mul 211 46;
  Sub 1 0; Mul 0 57; Mul 215 49; Mul 13 204; Sub 1 0; Mul 0 61; Sub 97 107; Sub 94 104; Sub 41 50;
  Sub 38 47; Sub 91 111; Sub 88 108; Sub 36 54; Sub 33 51; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5;
  Mul 8 7; Sub 1 0; Add 3 0; Add 289 0; Sub 93 123; Sub 90 120; Sub 39 66; Sub 36 63; Mul 15 0;
  Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Sub 95 135; Sub 92 132;
  Sub 42 78; Sub 39 75; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0;
  Add 11 0; Sub 98 147; Sub 95 144; Sub 46 90; Sub 43 87; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5;
  Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Constant 4; Div 165 0; Mul 2 0; Mul 0 349; Div 168 250;
  Sub 164 115; Sub 161 112; Mul 266 0; Mul 266 2; Sub 1 0; Mul 0 5; Div 175 317; Mul 327 62;
  Mul 327 64; Sub 1 0; Mul 0 3; Div 180 306; Sub 156 166; Sub 153 163; Mul 332 0; Mul 332 2;
  Sub 1 0; Mul 0 5; Div 187 299; Sub 153 163; Sub 150 160; Mul 323 0; Mul 323 2; Sub 1 0; Mul 0 5;
  Div 194 294; Sub 150 160; Sub 147 157; Mul 316 0; Mul 316 2; Sub 1 0; Mul 0 5; Div 201 289;
  Sub 148 157; Sub 145 154; Mul 311 0; Mul 311 2; Sub 1 0; Mul 0 5; Mul 33 149; Add 371 0;
  Mul 30 150; Add 1 0; Mul 25 143; Add 1 0; Mul 20 136; Add 1 0; Mul 15 129; Add 1 0; Mul 10 122;
  Add 1 0; Sub 0 52;
  ShowZero 0; (* load *)
  Sub 157 113; Sub 154 110; Mul 318 0; Mul 318 2; Sub 1 0; Mul 0 57; Mul 378 111; Mul 378 113;
  Sub 1 0; Mul 0 54; Sub 149 158; Sub 146 155; Mul 382 0; Mul 382 2; Sub 1 0; Mul 0 55;
  Sub 146 155; Sub 143 152; Mul 372 0; Mul 372 2; Sub 1 0; Mul 0 54; Sub 143 152; Sub 140 149;
  Mul 364 0; Mul 364 2; Sub 1 0; Mul 0 53; Sub 141 149; Sub 138 146; Mul 358 0; Mul 358 2;
  Sub 1 0; Mul 0 52; Mul 28 257; Add 418 0; Mul 26 258; Add 1 0; Mul 22 249; Add 1 0; Mul 18 241;
  Add 1 0; Mul 14 233; Add 1 0; Mul 10 225; Add 1 0; Sub 0 99;
  ShowZero 0; (* Laplacian *)
  Mul 363 93; Add 431 0; Mul 421 90; Add 1 0; Mul 421 85; Add 1 0; Mul 407 80; Add 1 0;
  Mul 395 75; Add 1 0; Mul 385 70; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 374 105; Add 443 0; Mul 432 102; Add 1 0; Mul 432 97; Add 1 0; Mul 418 92; Add 1 0;
  Mul 406 87; Add 1 0; Mul 396 82; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 387 65; Add 455 0; Mul 445 63; Add 1 0; Mul 445 59; Add 1 0; Mul 431 55; Add 1 0;
  Mul 419 51; Add 1 0; Mul 409 47; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 398 77; Add 467 0; Mul 456 75; Add 1 0; Mul 456 71; Add 1 0; Mul 442 67; Add 1 0;
  Mul 430 63; Add 1 0; Mul 420 59; Add 1 0;
  ShowZero 0 (* equilibrium *)
].

Theorem part_2_size_6_valid : valid part_2_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 7.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs, src/pair/weight.rs,
    src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_7 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 0; Sub 6 19;
  Sub 6 19; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10;
  Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 12; Unknown 13; Unknown 14; Sub 2 27; Sub 2 27; Neg 0; Mul 0 3; Mul 3 4; Sub 1 28;
  Sub 1 29; Mul 17 0; Mul 17 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 20 20; Mul 20 20; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 15; Unknown 16; Unknown 17; Sub 2 18; Sub 2 18; Neg 0; Mul 0 3; Mul 3 4; Sub 1 44;
  Sub 1 45; Mul 17 0; Mul 17 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 20 20; Mul 20 20; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 18; Sub 70 16; Sub 70 16; Neg 0; Mul 0 3; Mul 3 4; Sub 1 58; Sub 1 59; Mul 15 0;
  Mul 15 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 18 18; Mul 18 18; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 19; Neg 79; Mul 0 1; Mul 82 2; Sub 1 70; Sub 1 71; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 20; Neg 89; Mul 0 1; Mul 92 2; Sub 1 82; Sub 1 83; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 78; Mul 7 80; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Sub 96 96;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 93 93;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 93 93;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 90 90;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 90 90;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 74 74;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 74 74;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 60 60;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 60 60;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 48 48;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 48 48;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 38 38;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 38 38;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 28 28;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 28 28;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 21; Unknown 22; Unknown 23; Unknown 24; Unknown 25; Mul 115 4; Mul 115 5; Add 118 1;
  Add 119 1; Mul 114 7; Mul 114 8; Add 3 1; Add 3 1; Mul 100 10; Mul 100 11; Add 3 1; Add 3 1;
  Mul 88 13; Mul 88 14; Add 3 1; Add 3 1; Mul 78 16; Mul 78 17; Add 3 1; Add 3 1; Sub 136 1;
  Sub 137 1; Mul 1 148; Mul 1 150; Sub 1 0; Div 0 148; Mul 155 0; Mul 155 1; Add 9 1; Add 9 1;
  Mul 165 142; Mul 165 142; Add 1 0; Mul 155 140; Mul 155 140; Add 1 0; Mul 156 125; Mul 156 125;
  Add 1 0; Mul 134 112; Mul 134 112; Add 1 0; Mul 121 101; Mul 121 101; Add 1 0; Mul 178 92;
  Mul 178 92; Add 1 0; Mul 179 83; Mul 179 83; Add 1 0; Mul 167 163; Mul 168 163; Add 1 0;
  Mul 51 161; Mul 51 161; Add 1 0; Mul 50 146; Mul 50 146; Add 1 0; Mul 49 133; Mul 49 133;
  Add 1 0; Mul 48 122; Mul 48 122; Add 1 0; Mul 47 113; Mul 47 113; Add 1 0; Mul 40 104;
  Mul 40 104; Add 1 0; Sub 21 188; Sub 40 189; Constant 1; Div 0 98; Mul 3 180; Mul 109 3;
  Sub 1 0; Mul 0 3; Mul 113 6; Mul 8 186; Sub 1 0; Mul 0 7; Sub 48 200; Div 10 184; Mul 12 188;
  Mul 191 2; Sub 1 0; Mul 0 3; Mul 195 5; Mul 17 194; Sub 1 0; Mul 0 7; Sub 55 210; Div 20 178;
  Mul 11 182; Mul 199 2; Sub 1 0; Mul 0 3; Mul 203 5; Mul 16 188; Sub 1 0; Mul 0 7; Sub 62 220;
  Div 30 172; Mul 11 176; Mul 193 2; Sub 1 0; Mul 0 3; Mul 197 5; Mul 16 182; Sub 1 0; Mul 0 7;
  Sub 69 230; Div 40 168; Mul 11 172; Mul 187 2; Sub 1 0; Mul 0 3; Mul 191 5; Mul 16 178; Sub 1 0;
  Mul 0 7; Sub 76 240; Div 50 166; Mul 11 170; Mul 183 2; Sub 1 0; Mul 0 3; Mul 187 5; Mul 16 176;
  Sub 1 0; Mul 0 7; Div 59 163; Mul 10 167; Mul 180 63; Sub 1 0; Mul 0 3; Mul 184 66; Mul 15 173;
  Sub 1 0; Mul 0 7; Sub 71 259; Sub 90 260; Mul 1 249; Mul 178 1; Sub 1 0; Mul 0 72; Mul 182 4;
  Mul 6 255; Sub 1 0; Mul 0 76; Sub 96 269; Mul 9 256; Mul 259 1; Sub 1 0; Mul 0 71; Mul 263 4;
  Mul 14 262; Sub 1 0; Mul 0 75; Sub 102 278; Mul 9 249; Mul 266 1; Sub 1 0; Mul 0 70; Mul 270 4;
  Mul 14 255; Sub 1 0; Mul 0 74; Sub 108 287; Mul 9 242; Mul 259 1; Sub 1 0; Mul 0 69; Mul 263 4;
  Mul 14 248; Sub 1 0; Mul 0 73; Sub 114 296; Mul 9 237; Mul 252 1; Sub 1 0; Mul 0 68; Mul 256 4;
  Mul 14 243; Sub 1 0; Mul 0 72; Sub 120 305; Mul 9 234; Mul 247 1; Sub 1 0; Mul 0 67; Mul 251 4;
  Mul 14 240; Sub 1 0; Mul 0 71; Mul 8 230; Mul 243 55; Sub 1 0; Mul 0 66; Mul 247 58; Mul 13 236;
  Sub 1 0; Mul 0 70; Sub 116 126; Sub 113 123; Sub 50 59; Sub 47 56; Sub 110 130; Sub 107 127;
  Sub 45 63; Sub 42 60; Mul 7 0; Mul 7 2; Sub 1 0; Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 337 0;
  Sub 112 142; Sub 109 139; Sub 48 75; Sub 45 72; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7;
  Sub 1 0; Add 3 0; Add 11 0; Sub 114 154; Sub 111 151; Sub 51 87; Sub 48 84; Mul 15 0; Mul 15 2;
  Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Sub 116 166; Sub 113 163; Sub 54 99;
  Sub 51 96; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0;
  Sub 119 178; Sub 116 175; Sub 58 111; Sub 55 108; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5;
  Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Constant 4; Div 196 0; Mul 2 0; Mul 0 409; Div 199 294;
  Sub 195 136; Sub 192 133; Mul 310 0; Mul 310 2; Sub 1 0; Mul 0 5; Div 206 377; Mul 387 74;
  Mul 387 76; Sub 1 0; Mul 0 3; Div 211 366; Sub 187 197; Sub 184 194; Mul 392 0; Mul 392 2;
  Sub 1 0; Mul 0 5; Div 218 357; Sub 184 194; Sub 181 191; Mul 383 0; Mul 383 2; Sub 1 0; Mul 0 5;
  Div 225 350; Sub 181 191; Sub 178 188; Mul 374 0; Mul 374 2; Sub 1 0; Mul 0 5; Div 232 345;
  Sub 178 188; Sub 175 185; Mul 367 0; Mul 367 2; Sub 1 0; Mul 0 5; Div 239 340; Sub 176 185;
  Sub 173 182; Mul 362 0; Mul 362 2; Sub 1 0; Mul 0 5; Mul 40 177; Add 438 0; Mul 37 178; Add 1 0;
  Mul 32 171; Add 1 0; Mul 27 164; Add 1 0; Mul 22 157; Add 1 0; Mul 17 150; Add 1 0; Mul 12 143;
  Add 1 0; Sub 0 61;
  ShowZero 0; (* load *)
  Sub 187 134; Sub 184 131; Mul 371 0; Mul 371 2; Sub 1 0; Mul 0 66; Mul 447 132; Mul 447 134;
  Sub 1 0; Mul 0 63; Sub 179 188; Sub 176 185; Mul 451 0; Mul 451 2; Sub 1 0; Mul 0 64;
  Sub 176 185; Sub 173 182; Mul 441 0; Mul 441 2; Sub 1 0; Mul 0 63; Sub 173 182; Sub 170 179;
  Mul 431 0; Mul 431 2; Sub 1 0; Mul 0 62; Sub 170 179; Sub 167 176; Mul 423 0; Mul 423 2;
  Sub 1 0; Mul 0 61; Sub 168 176; Sub 165 173; Mul 417 0; Mul 417 2; Sub 1 0; Mul 0 60;
  Mul 34 303; Add 493 0; Mul 32 304; Add 1 0; Mul 28 295; Add 1 0; Mul 24 287; Add 1 0;
  Mul 20 279; Add 1 0; Mul 16 271; Add 1 0; Mul 12 263; Add 1 0; Sub 0 116;
  ShowZero 0; (* Laplacian *)
  Mul 424 110; Add 508 0; Mul 498 107; Add 1 0; Mul 498 102; Add 1 0; Mul 484 97; Add 1 0;
  Mul 470 92; Add 1 0; Mul 458 87; Add 1 0; Mul 448 82; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 437 124; Add 522 0; Mul 511 121; Add 1 0; Mul 511 116; Add 1 0; Mul 497 111; Add 1 0;
  Mul 483 106; Add 1 0; Mul 471 101; Add 1 0; Mul 461 96; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 452 77; Add 536 0; Mul 526 75; Add 1 0; Mul 526 71; Add 1 0; Mul 512 67; Add 1 0;
  Mul 498 63; Add 1 0; Mul 486 59; Add 1 0; Mul 476 55; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 465 91; Add 550 0; Mul 539 89; Add 1 0; Mul 539 85; Add 1 0; Mul 525 81; Add 1 0;
  Mul 511 77; Add 1 0; Mul 499 73; Add 1 0; Mul 489 69; Add 1 0;
  ShowZero 0 (* equilibrium *)
].

Theorem part_2_size_7_valid : valid part_2_size_7.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 8.
    Code: src/pair/forms.rs, src/pair/v_parallel.rs, src/pair/vertex.rs, src/pair/weight.rs,
    src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_8 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 0; Sub 6 19;
  Sub 6 19; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10;
  Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 12; Unknown 13; Unknown 14; Sub 2 27; Sub 2 27; Neg 0; Mul 0 3; Mul 3 4; Sub 1 28;
  Sub 1 29; Mul 17 0; Mul 17 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 20 20; Mul 20 20; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 15; Unknown 16; Unknown 17; Sub 2 18; Sub 2 18; Neg 0; Mul 0 3; Mul 3 4; Sub 1 44;
  Sub 1 45; Mul 17 0; Mul 17 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 20 20; Mul 20 20; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 18; Unknown 19; Unknown 20; Sub 2 18; Sub 2 18; Neg 0; Mul 0 3; Mul 3 4; Sub 1 60;
  Sub 1 61; Mul 17 0; Mul 17 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 20 20; Mul 20 20; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 21; Sub 86 16; Sub 86 16; Neg 0; Mul 0 3; Mul 3 4; Sub 1 74; Sub 1 75; Mul 15 0;
  Mul 15 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 18 18; Mul 18 18; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 22; Neg 95; Mul 0 1; Mul 98 2; Sub 1 86; Sub 1 87; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Unknown 23; Neg 105; Mul 0 1; Mul 108 2; Sub 1 98; Sub 1 99; Mul 13 0; Mul 13 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 16 16; Mul 16 16; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 94; Mul 7 96; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Sub 112 112;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 109 109;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 109 109;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 106 106;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 106 106;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 90 90;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 90 90;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 76 76;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 76 76;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 62 62;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 62 62;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 50 50;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 50 50;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 40 40;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 40 40;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 30 30;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 30 30;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 24; Unknown 25; Unknown 26; Unknown 27; Unknown 28; Unknown 29; Mul 134 5; Mul 134 6;
  Add 137 1; Add 138 1; Mul 133 8; Mul 133 9; Add 3 1; Add 3 1; Mul 119 11; Mul 119 12; Add 3 1;
  Add 3 1; Mul 107 14; Mul 107 15; Add 3 1; Add 3 1; Mul 95 17; Mul 95 18; Add 3 1; Add 3 1;
  Mul 85 20; Mul 85 21; Add 3 1; Add 3 1; Sub 159 1; Sub 160 1; Mul 1 171; Mul 1 173; Sub 1 0;
  Div 0 171; Mul 178 0; Mul 178 1; Add 9 1; Add 9 1; Mul 188 165; Mul 188 165; Add 1 0;
  Mul 178 163; Mul 178 163; Add 1 0; Mul 179 148; Mul 179 148; Add 1 0; Mul 157 135; Mul 157 135;
  Add 1 0; Mul 144 122; Mul 144 122; Add 1 0; Mul 131 111; Mul 131 111; Add 1 0; Mul 204 102;
  Mul 204 102; Add 1 0; Mul 205 93; Mul 205 93; Add 1 0; Mul 193 189; Mul 194 189; Add 1 0;
  Mul 58 187; Mul 58 187; Add 1 0; Mul 57 172; Mul 57 172; Add 1 0; Mul 56 159; Mul 56 159;
  Add 1 0; Mul 55 146; Mul 55 146; Add 1 0; Mul 54 135; Mul 54 135; Add 1 0; Mul 53 126;
  Mul 53 126; Add 1 0; Mul 46 117; Mul 46 117; Add 1 0; Sub 24 217; Sub 46 218; Constant 1;
  Div 0 111; Mul 3 209; Mul 122 3; Sub 1 0; Mul 0 3; Mul 126 6; Mul 8 215; Sub 1 0; Mul 0 7;
  Sub 54 229; Div 10 213; Mul 12 217; Mul 220 2; Sub 1 0; Mul 0 3; Mul 224 5; Mul 17 223; Sub 1 0;
  Mul 0 7; Sub 61 239; Div 20 207; Mul 11 211; Mul 228 2; Sub 1 0; Mul 0 3; Mul 232 5; Mul 16 217;
  Sub 1 0; Mul 0 7; Sub 68 249; Div 30 201; Mul 11 205; Mul 222 2; Sub 1 0; Mul 0 3; Mul 226 5;
  Mul 16 211; Sub 1 0; Mul 0 7; Sub 75 259; Div 40 195; Mul 11 199; Mul 216 2; Sub 1 0; Mul 0 3;
  Mul 220 5; Mul 16 205; Sub 1 0; Mul 0 7; Sub 82 269; Div 50 191; Mul 11 195; Mul 210 2; Sub 1 0;
  Mul 0 3; Mul 214 5; Mul 16 201; Sub 1 0; Mul 0 7; Sub 89 279; Div 60 189; Mul 11 193; Mul 206 2;
  Sub 1 0; Mul 0 3; Mul 210 5; Mul 16 199; Sub 1 0; Mul 0 7; Div 69 186; Mul 10 190; Mul 203 73;
  Sub 1 0; Mul 0 3; Mul 207 76; Mul 15 196; Sub 1 0; Mul 0 7; Sub 81 298; Sub 103 299; Mul 1 288;
  Mul 201 1; Sub 1 0; Mul 0 82; Mul 205 4; Mul 6 294; Sub 1 0; Mul 0 86; Sub 109 308; Mul 9 295;
  Mul 298 1; Sub 1 0; Mul 0 81; Mul 302 4; Mul 14 301; Sub 1 0; Mul 0 85; Sub 115 317; Mul 9 288;
  Mul 305 1; Sub 1 0; Mul 0 80; Mul 309 4; Mul 14 294; Sub 1 0; Mul 0 84; Sub 121 326; Mul 9 281;
  Mul 298 1; Sub 1 0; Mul 0 79; Mul 302 4; Mul 14 287; Sub 1 0; Mul 0 83; Sub 127 335; Mul 9 274;
  Mul 291 1; Sub 1 0; Mul 0 78; Mul 295 4; Mul 14 280; Sub 1 0; Mul 0 82; Sub 133 344; Mul 9 269;
  Mul 284 1; Sub 1 0; Mul 0 77; Mul 288 4; Mul 14 275; Sub 1 0; Mul 0 81; Sub 139 353; Mul 9 266;
  Mul 279 1; Sub 1 0; Mul 0 76; Mul 283 4; Mul 14 272; Sub 1 0; Mul 0 80; Mul 8 262; Mul 275 64;
  Sub 1 0; Mul 0 75; Mul 279 67; Mul 13 268; Sub 1 0; Mul 0 79; Sub 135 145; Sub 132 142;
  Sub 59 68; Sub 56 65; Sub 129 149; Sub 126 146; Sub 54 72; Sub 51 69; Mul 7 0; Mul 7 2; Sub 1 0;
  Mul 8 5; Mul 8 7; Sub 1 0; Add 3 0; Add 385 0; Sub 131 161; Sub 128 158; Sub 57 84; Sub 54 81;
  Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Sub 133 173;
  Sub 130 170; Sub 60 96; Sub 57 93; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0;
  Add 3 0; Add 11 0; Sub 135 185; Sub 132 182; Sub 63 108; Sub 60 105; Mul 15 0; Mul 15 2;
  Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Sub 137 197; Sub 134 194; Sub 66 120;
  Sub 63 117; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0;
  Sub 140 209; Sub 137 206; Sub 70 132; Sub 67 129; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5;
  Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Constant 4; Div 227 0; Mul 2 0; Mul 0 469; Div 230 338;
  Sub 226 157; Sub 223 154; Mul 354 0; Mul 354 2; Sub 1 0; Mul 0 5; Div 237 437; Mul 447 86;
  Mul 447 88; Sub 1 0; Mul 0 3; Div 242 426; Sub 218 228; Sub 215 225; Mul 452 0; Mul 452 2;
  Sub 1 0; Mul 0 5; Div 249 417; Sub 215 225; Sub 212 222; Mul 443 0; Mul 443 2; Sub 1 0; Mul 0 5;
  Div 256 408; Sub 212 222; Sub 209 219; Mul 434 0; Mul 434 2; Sub 1 0; Mul 0 5; Div 263 401;
  Sub 209 219; Sub 206 216; Mul 425 0; Mul 425 2; Sub 1 0; Mul 0 5; Div 270 396; Sub 206 216;
  Sub 203 213; Mul 418 0; Mul 418 2; Sub 1 0; Mul 0 5; Div 277 391; Sub 204 213; Sub 201 210;
  Mul 413 0; Mul 413 2; Sub 1 0; Mul 0 5; Mul 47 205; Add 505 0; Mul 44 206; Add 1 0; Mul 39 199;
  Add 1 0; Mul 34 192; Add 1 0; Mul 29 185; Add 1 0; Mul 24 178; Add 1 0; Mul 19 171; Add 1 0;
  Mul 14 164; Add 1 0; Sub 0 70;
  ShowZero 0; (* load *)
  Sub 217 155; Sub 214 152; Mul 424 0; Mul 424 2; Sub 1 0; Mul 0 75; Mul 516 153; Mul 516 155;
  Sub 1 0; Mul 0 72; Sub 209 218; Sub 206 215; Mul 520 0; Mul 520 2; Sub 1 0; Mul 0 73;
  Sub 206 215; Sub 203 212; Mul 510 0; Mul 510 2; Sub 1 0; Mul 0 72; Sub 203 212; Sub 200 209;
  Mul 500 0; Mul 500 2; Sub 1 0; Mul 0 71; Sub 200 209; Sub 197 206; Mul 490 0; Mul 490 2;
  Sub 1 0; Mul 0 70; Sub 197 206; Sub 194 203; Mul 482 0; Mul 482 2; Sub 1 0; Mul 0 69;
  Sub 195 203; Sub 192 200; Mul 476 0; Mul 476 2; Sub 1 0; Mul 0 68; Mul 40 349; Add 568 0;
  Mul 38 350; Add 1 0; Mul 34 341; Add 1 0; Mul 30 333; Add 1 0; Mul 26 325; Add 1 0; Mul 22 317;
  Add 1 0; Mul 18 309; Add 1 0; Mul 14 301; Add 1 0; Sub 0 133;
  ShowZero 0; (* Laplacian *)
  Mul 485 127; Add 585 0; Mul 575 124; Add 1 0; Mul 575 119; Add 1 0; Mul 561 114; Add 1 0;
  Mul 547 109; Add 1 0; Mul 533 104; Add 1 0; Mul 521 99; Add 1 0; Mul 511 94; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 500 143; Add 601 0; Mul 590 140; Add 1 0; Mul 590 135; Add 1 0; Mul 576 130; Add 1 0;
  Mul 562 125; Add 1 0; Mul 548 120; Add 1 0; Mul 536 115; Add 1 0; Mul 526 110; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 517 89; Add 617 0; Mul 607 87; Add 1 0; Mul 607 83; Add 1 0; Mul 593 79; Add 1 0;
  Mul 579 75; Add 1 0; Mul 565 71; Add 1 0; Mul 553 67; Add 1 0; Mul 543 63; Add 1 0;
  ShowZero 0; (* equilibrium *)
  Mul 532 105; Add 633 0; Mul 622 103; Add 1 0; Mul 622 99; Add 1 0; Mul 608 95; Add 1 0;
  Mul 594 91; Add 1 0; Mul 580 87; Add 1 0; Mul 568 83; Add 1 0; Mul 558 79; Add 1 0;
  ShowZero 0 (* equilibrium *)
].

Theorem part_2_size_8_valid : valid part_2_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
