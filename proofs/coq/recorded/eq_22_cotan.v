(** eq-22-cotan (Sec. 4, (22), Fig. 11)

    With the lift to Σ as Gauss image, the mixed measure of a vertex of a triangle mesh is the
    cotangent Laplacian of the heights, and the measure of its image is the signed area of the
    polygon of circumcentres: 2H is the cotangent Laplacian over that area, on obtuse and
    non-Delaunay stars, too.

        2 D(v, s) = Σ ½ (cot α_j + cot β_j) (f_j - f_v),  D(s) = area of the circumcentres

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a star of k triangles; size 3.
    Code: src/pair/area.rs, src/pair/cotangent.rs, src/pair/forms.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/pair/weight.rs, src/scalar/ring.rs, src/space/circle.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
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
  Constant 1; Constant 0; Mul 33 33; Mul 33 33; Add 1 0; Mul 4 0; Div 5 38; Mul 1 0; Mul 6 39;
  Mul 7 39; Add 1 0; Add 0 9; Add 4 0; Mul 42 42; Mul 42 42; Add 1 0; Mul 15 0; Mul 0 10;
  Mul 16 47; Mul 17 47; Add 1 0; Add 0 19; Add 4 0; Mul 50 50; Mul 50 50; Add 1 0; Mul 25 0;
  Mul 0 20; Mul 26 55; Mul 27 55; Add 1 0; Add 0 29; Add 4 0; Mul 48 48; Mul 48 48; Add 1 0;
  Mul 35 0; Mul 0 30; Mul 36 53; Mul 37 53; Add 1 0; Add 0 39; Add 4 0; Sub 20 30; Sub 11 31;
  Div 44 64; Mul 2 68; Mul 71 2; Sub 1 0; Mul 0 3; Mul 75 5; Mul 7 74; Sub 1 0; Mul 0 7;
  Sub 11 41; Div 54 64; Mul 11 68; Mul 79 2; Sub 1 0; Mul 0 3; Mul 83 5; Mul 16 74; Sub 1 0;
  Mul 0 7; Div 63 67; Mul 10 89; Mul 78 22; Sub 1 0; Mul 0 3; Mul 82 25; Mul 15 95; Sub 1 0;
  Mul 0 7; Sub 13 23; Sub 10 20; Sub 6 25; Sub 3 22; Mul 3 0; Mul 3 2; Sub 1 0; Add 78 0;
  Mul 0 113; Constant 4; Div 82 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 116 116;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 116 116;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 116 116;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 116 116;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 116 116;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 116 116;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 106 106;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 106 106;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Div 92 109; Sub 44 25; Sub 41 22; Mul 121 0; Mul 121 2; Sub 1 0; Mul 0 5; Sub 131 127;
  Sub 131 127; Sub 131 129; Sub 131 129; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 140 126; Sub 140 126; Sub 144 128; Sub 144 128; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3;
  Mul 6 5; Sub 1 0; Div 3 0; Add 11 0; Mul 0 116; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 124 131; Mul 149 51; Mul 149 53; Sub 1 0; Mul 0 3; Sub 157 145; Sub 157 145; Mul 18 1;
  Mul 18 1; Add 1 0; Mul 21 3; Mul 21 5; Sub 1 0; Div 3 0; Sub 166 168; Sub 166 168; Sub 172 170;
  Sub 172 170; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0; Div 3 0; Add 11 0; Mul 0 144;
  Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 152 153; Sub 85 94; Sub 82 91; Mul 169 0; Mul 169 2; Sub 1 0; Mul 0 5; Sub 175 189;
  Sub 175 189; Mul 20 1; Mul 20 1; Add 1 0; Mul 23 3; Mul 23 5; Sub 1 0; Div 3 0; Sub 184 196;
  Sub 184 196; Mul 1 70; Mul 1 70; Add 1 0; Mul 4 72; Mul 4 74; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 172; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Sub 2 3; Sub 2 4; Mul 1 209; Mul 212 1; Sub 1 0;
  Mul 0 144; Mul 216 4; Mul 6 215; Sub 1 0; Mul 0 148; Sub 10 13; Mul 9 208; Mul 219 1; Sub 1 0;
  Mul 0 143; Mul 223 4; Mul 14 214; Sub 1 0; Mul 0 147; Mul 8 228; Mul 217 19; Sub 1 0; Mul 0 142;
  Mul 221 22; Mul 13 234; Sub 1 0; Mul 0 146; Sub 12 21; Sub 9 18; Sub 6 23; Sub 3 20; Mul 3 139;
  Mul 3 141; Sub 1 0; Mul 145 3; Mul 145 5; Sub 1 0; Add 3 0; Add 221 0; Mul 0 140; Mul 0 257;
  Mul 102 40; Add 225 0; Mul 76 41; Add 1 0; Mul 50 34; Add 1 0; Sub 0 6;
  ShowZero 0; (* cotangent Laplacian *)
  Mul 133 47; Add 232 0; Mul 105 48; Add 1 0; Mul 77 41; Add 1 0; Sub 0 13;
  ShowZero 0; (* Laplacian *)
  Sub 49 32; Sub 46 29; Mul 267 0; Mul 267 2; Sub 1 0; Mul 0 151; Mul 269 32; Mul 269 34; Sub 1 0;
  Mul 0 123; Sub 42 50; Sub 39 47; Mul 265 0; Mul 265 2; Sub 1 0; Mul 0 101; Mul 10 272;
  Add 255 0; Mul 8 264; Add 1 0; Mul 4 260; Add 1 0; Mul 36 294; Sub 1 0;
  ShowZero 0; (* hinges *)
  Mul 283 296; Div 264 0; Mul 282 288; Mul 291 273; Sub 1 0; Mul 0 3; Mul 295 276; Mul 287 294;
  Sub 1 0; Mul 0 7; Add 305 4; Add 305 1; Mul 285 308; Div 276 0; Mul 284 290; Mul 301 279;
  Sub 1 0; Mul 0 3; Mul 305 282; Mul 289 296; Sub 1 0; Mul 0 7; Add 317 4; Add 317 1; Mul 291 320;
  Div 288 0; Mul 290 314; Mul 303 307; Sub 1 0; Mul 0 3; Mul 307 310; Mul 295 320; Sub 1 0;
  Mul 0 7; Add 329 4; Add 329 1; Sub 13 25; Sub 13 25; Sub 3 27; Sub 3 27; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 305 0; Mul 223 340; Sub 1 0;
  ShowZero 0; (* area of the circumcentres *)
  Div 309 228; Mul 87 0; Mul 0 227; Mul 0 345; Sub 0 82;
  ShowZero 0 (* 2H *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a star given by its circumcentres; size 3.
    Code: src/pair/area.rs, src/pair/cotangent.rs, src/pair/forms.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/pair/weight.rs, src/scalar/ring.rs, src/space/circle.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_3 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Neg 3; Neg 3; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1;
  Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 4; Unknown 5; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 8; Neg 8; Add 21 1; Add 21 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Constant 2; Mul 27 24; Mul 27 26; Sub 1 0; Mul 3 0; Div 0 21; Neg 0; Mul 31 21; Mul 31 23;
  Sub 1 0; Mul 9 0; Div 0 18; Neg 0; Constant 0; Sub 38 40; Sub 38 40; Neg 0; Mul 0 10; Mul 3 11;
  Sub 34 43; Sub 34 43; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0;
  Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 49 59; Mul 49 61; Sub 1 0; Mul 36 0; Div 0 38; Neg 0; Sub 66 55; Sub 66 55; Neg 0; Mul 0 3;
  Mul 3 4; Sub 1 31; Sub 1 32; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 27; Mul 7 29; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Sub 45 45;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 42 42;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 42 42;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 39 39;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 39 39;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 20 20;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 20 20;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowZero 6; (* the lift *)
  Constant 1; Mul 53 53; Add 0 0; Mul 2 0; Div 3 69; Mul 1 0; Add 3 58; Add 1 0; Sub 0 60;
  ShowZero 0; (* the lift *)
  ShowZero 14; (* the lift *)
  ShowZero 13; (* the lift *)
  Mul 101 57; Mul 101 57; Add 1 0; Mul 60 60; Mul 60 60; Add 1 0; Mul 14 0; Mul 0 11; Mul 69 65;
  Mul 70 65; Add 1 0; Add 0 72; Add 4 0; Sub 0 10;
  ShowZero 0; (* the lift *)
  ShowZero 26; (* the lift *)
  ShowZero 25; (* the lift *)
  Mul 113 66; Mul 113 66; Add 1 0; Mul 69 69; Mul 69 69; Add 1 0; Mul 28 0; Mul 0 25; Mul 83 74;
  Mul 84 74; Add 1 0; Add 0 86; Add 4 0; Sub 0 10;
  ShowZero 0; (* the lift *)
  ShowZero 38; (* the lift *)
  ShowZero 37; (* the lift *)
  Mul 118 59; Mul 118 59; Add 1 0; Mul 62 62; Mul 62 62; Add 1 0; Mul 42 0; Mul 0 39; Mul 97 67;
  Mul 98 67; Add 1 0; Add 0 100; Add 4 0; Sub 0 10;
  ShowZero 0; (* the lift *)
  Sub 1 43; Sub 30 44; Div 52 63; Mul 2 94; Mul 74 2; Sub 1 0; Mul 0 3; Mul 78 5; Mul 7 100;
  Sub 1 0; Mul 0 7; Sub 26 54; Div 62 79; Mul 1 83; Mul 103 13; Sub 1 0; Mul 0 3; Mul 107 16;
  Mul 6 89; Sub 1 0; Mul 0 7; Div 71 79; Sub 15 5; Sub 12 2; Mul 95 0; Mul 95 2; Sub 1 0; Mul 0 5;
  Sub 131 127; Sub 132 127; Sub 103 129; Sub 103 129; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5;
  Sub 1 0; Div 3 0; Sub 112 133; Sub 112 133; Sub 144 135; Sub 145 135; Mul 3 1; Mul 3 1; Add 1 0;
  Mul 6 3; Mul 6 5; Sub 1 0; Div 3 0; Add 11 0; Mul 0 97; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 103 139; Mul 52 143; Mul 146 43; Sub 1 0; Mul 0 3; Mul 150 46; Mul 57 149; Sub 1 0; Mul 0 7;
  Div 112 145; Sub 5 56; Sub 2 53; Mul 157 0; Mul 157 2; Sub 1 0; Mul 0 5; Sub 168 163;
  Sub 168 163; Mul 29 1; Mul 29 1; Add 1 0; Mul 32 3; Mul 32 5; Sub 1 0; Div 3 0; Sub 177 151;
  Sub 177 151; Sub 183 153; Sub 184 153; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Add 11 0; Mul 0 136; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 142 156; Sub 76 35; Sub 73 32; Mul 185 0; Mul 185 2; Sub 1 0; Mul 0 5; Sub 193 172;
  Sub 193 172; Mul 20 1; Mul 20 1; Add 1 0; Mul 23 3; Mul 23 5; Sub 1 0; Div 3 0; Sub 202 207;
  Sub 202 207; Mul 1 81; Mul 1 81; Add 1 0; Mul 4 83; Mul 4 85; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 164; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Unknown 6; Mul 223 0; Mul 223 1; Add 226 1; Add 227 1; Mul 222 4; Mul 222 5; Add 3 1; Add 3 1;
  Mul 5 223; Mul 5 223; Add 1 0; Mul 4 205; Mul 4 205; Add 1 0; Sub 0 238; Sub 167 239; Mul 1 228;
  Mul 208 1; Sub 1 0; Mul 0 137; Mul 212 4; Mul 6 234; Sub 1 0; Mul 0 141; Sub 13 248; Mul 9 235;
  Mul 238 1; Sub 1 0; Mul 0 95; Mul 242 4; Mul 14 241; Sub 1 0; Mul 0 99; Mul 8 224; Mul 244 19;
  Sub 1 0; Mul 0 144; Mul 248 22; Mul 13 230; Sub 1 0; Mul 0 148; Sub 12 21; Sub 9 18; Sub 6 23;
  Sub 3 20; Sub 149 159; Sub 146 156; Mul 5 0; Mul 5 2; Sub 1 0; Mul 107 5; Mul 107 7; Sub 1 0;
  Add 3 0; Add 278 0; Constant 4; Div 227 0; Mul 2 0; Mul 0 295; Mul 128 44; Add 284 0; Mul 91 45;
  Add 1 0; Mul 65 38; Add 1 0; Sub 0 6;
  ShowZero 0; (* cotangent Laplacian *)
  Mul 159 51; Add 291 0; Mul 120 52; Add 1 0; Mul 92 45; Add 1 0; Sub 0 13;
  ShowZero 0; (* Laplacian *)
  Sub 53 36; Sub 50 33; Mul 267 0; Mul 267 2; Sub 1 0; Mul 0 177; Mul 292 36; Mul 292 38; Sub 1 0;
  Mul 0 140; Sub 46 54; Sub 43 51; Mul 296 0; Mul 296 2; Sub 1 0; Mul 0 116; Mul 10 268;
  Add 314 0; Mul 8 295; Add 1 0; Mul 4 278; Add 1 0; Mul 36 332; Sub 1 0;
  ShowZero 0; (* hinges *)
  Mul 154 50; Mul 154 52; Sub 1 0; Add 324 0; Mul 0 338; Mul 284 339; Div 274 0; Mul 283 316;
  Mul 296 309; Sub 1 0; Mul 0 3; Mul 300 312; Mul 288 322; Sub 1 0; Mul 0 7; Add 336 4; Add 337 1;
  Mul 321 351; Div 286 0; Mul 320 326; Mul 329 302; Sub 1 0; Mul 0 3; Mul 333 305; Mul 325 332;
  Sub 1 0; Mul 0 7; Add 348 4; Add 349 1; Mul 314 363; Div 298 0; Mul 313 319; Mul 339 308;
  Sub 1 0; Mul 0 3; Mul 343 311; Mul 318 325; Sub 1 0; Mul 0 7; Add 360 4; Add 361 1; Mul 36 81;
  Sub 14 26; Sub 14 26; Sub 4 28; Sub 4 28; Mul 3 0; Mul 3 2; Sub 1 0; Add 370 0; Mul 8 384;
  Sub 1 0;
  ShowZero 0; (* area of the circumcentres *)
  Div 320 47; Mul 95 0; Mul 0 12; Mul 0 389; Sub 0 88;
  ShowZero 0 (* 2H *)
].

Theorem part_2_size_3_valid : valid part_2_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a star given by its circumcentres; size 4.
    Code: src/pair/area.rs, src/pair/cotangent.rs, src/pair/forms.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/pair/weight.rs, src/scalar/ring.rs, src/space/circle.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_4 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Neg 14; Neg 14; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 8; Neg 8; Add 21 1; Add 21 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 26; Neg 26; Add 26 1; Add 26 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 31; Neg 31; Add 37 1; Add 37 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Constant 2; Mul 43 29; Mul 43 31; Sub 1 0; Mul 3 0; Div 0 26; Neg 0; Mul 36 46; Mul 36 48;
  Sub 1 0; Mul 9 0; Div 0 25; Neg 0; Constant 0; Sub 43 56; Sub 43 56; Neg 0; Mul 0 10; Mul 3 11;
  Sub 59 48; Sub 59 48; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0;
  Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 74 71; Mul 74 73; Sub 1 0; Mul 36 0; Div 0 45; Neg 0; Neg 75; Mul 0 1; Mul 78 2; Sub 1 29;
  Sub 1 30; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 89 92; Mul 89 94; Sub 1 0; Mul 53 0; Div 0 55; Neg 0; Neg 90; Mul 0 1; Mul 93 2; Sub 1 46;
  Sub 1 47; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 42; Mul 7 44; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Constant 1; Mul 61 61; Add 0 0; Mul 2 0; Div 3 77; Mul 1 0; Add 3 66; Add 1 0; Mul 64 64;
  Mul 64 64; Add 1 0; Mul 10 0; Mul 0 7; Mul 73 69; Mul 74 69; Add 1 0; Add 0 76; Add 4 0;
  Mul 69 69; Mul 69 69; Add 1 0; Mul 20 0; Mul 0 17; Mul 83 74; Mul 84 74; Add 1 0; Add 0 86;
  Add 4 0; Mul 60 60; Mul 60 60; Add 1 0; Mul 30 0; Mul 0 27; Mul 93 65; Mul 94 65; Add 1 0;
  Add 0 96; Add 4 0; Mul 53 53; Mul 53 53; Add 1 0; Mul 40 0; Mul 0 37; Mul 103 58; Mul 104 58;
  Add 1 0; Add 0 106; Add 4 0; Sub 0 40; Sub 31 41; Div 49 53; Mul 2 99; Mul 64 2; Sub 1 0;
  Mul 0 3; Mul 68 5; Mul 7 105; Sub 1 0; Mul 0 7; Sub 31 51; Div 59 103; Mul 11 107; Mul 110 2;
  Sub 1 0; Mul 0 3; Mul 114 5; Mul 16 113; Sub 1 0; Mul 0 7; Sub 31 61; Div 69 96; Mul 11 100;
  Mul 118 2; Sub 1 0; Mul 0 3; Mul 122 5; Mul 16 106; Sub 1 0; Mul 0 7; Div 78 88; Mul 10 92;
  Mul 110 32; Sub 1 0; Mul 0 3; Mul 114 35; Mul 15 98; Sub 1 0; Mul 0 7; Sub 23 33; Sub 20 30;
  Sub 15 35; Sub 12 32; Mul 3 0; Mul 3 2; Sub 1 0; Add 155 0; Sub 12 41; Sub 9 38; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Mul 0 175; Constant 4; Div 103 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 166 166;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 163 163;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 163 163;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 160 160;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 160 160;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 143 143;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 143 143;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 128 128;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 128 128;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowZero 8; (* the lift *)
  Sub 107 175;
  ShowZero 0; (* the lift *)
  ShowZero 8; (* the lift *)
  ShowZero 7; (* the lift *)
  Mul 232 172; Mul 232 172; Add 1 0; Sub 101 0;
  ShowZero 0; (* the lift *)
  ShowZero 10; (* the lift *)
  ShowZero 9; (* the lift *)
  Mul 223 171; Mul 223 171; Add 1 0; Sub 95 0;
  ShowZero 0; (* the lift *)
  ShowZero 12; (* the lift *)
  ShowZero 11; (* the lift *)
  Mul 238 156; Mul 238 156; Add 1 0; Sub 89 0;
  ShowZero 0; (* the lift *)
  ShowZero 14; (* the lift *)
  ShowZero 13; (* the lift *)
  Mul 240 143; Mul 240 143; Add 1 0; Sub 83 0;
  ShowZero 0; (* the lift *)
  Div 131 132; Sub 78 49; Sub 75 46; Mul 148 0; Mul 148 2; Sub 1 0; Mul 0 5; Sub 199 195;
  Sub 200 195; Sub 156 197; Sub 156 197; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 165 182; Sub 165 182; Sub 212 184; Sub 213 184; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3;
  Mul 6 5; Sub 1 0; Div 3 0; Add 11 0; Mul 0 157; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 163 204; Mul 214 75; Mul 214 77; Sub 1 0; Mul 0 3; Sub 229 220; Sub 230 220; Sub 227 222;
  Sub 227 222; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0; Div 3 0; Sub 236 195;
  Sub 236 195; Sub 242 197; Sub 243 197; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Add 11 0; Mul 0 187; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 193 217; Sub 120 130; Sub 117 127; Mul 244 0; Mul 244 2; Sub 1 0; Mul 0 5; Sub 252 233;
  Sub 252 233; Mul 50 1; Mul 50 1; Add 1 0; Mul 53 3; Mul 53 5; Sub 1 0; Div 3 0; Sub 261 266;
  Sub 261 266; Mul 1 72; Mul 1 72; Add 1 0; Mul 4 74; Mul 4 76; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 215; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 221 228; Sub 139 148; Sub 136 145; Mul 255 0; Mul 255 2; Sub 1 0; Mul 0 5; Sub 261 244;
  Sub 261 244; Mul 48 1; Mul 48 1; Add 1 0; Mul 51 3; Mul 51 5; Sub 1 0; Div 3 0; Sub 270 289;
  Sub 270 289; Mul 1 70; Mul 1 70; Add 1 0; Mul 4 72; Mul 4 74; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 243; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Unknown 8; Unknown 9; Mul 311 1; Mul 311 2; Add 314 1; Add 315 1; Mul 310 4; Mul 310 5; Add 3 1;
  Add 3 1; Sub 320 1; Sub 321 1; Mul 1 369; Mul 1 371; Sub 1 0; Div 0 369; Mul 376 0; Mul 376 1;
  Add 9 1; Add 9 1; Mul 15 321; Mul 15 321; Add 1 0; Mul 14 305; Mul 14 305; Add 1 0; Mul 7 291;
  Mul 7 291; Add 1 0; Sub 0 339; Sub 264 340; Mul 1 329; Mul 294 1; Sub 1 0; Mul 0 233; Mul 298 4;
  Mul 6 335; Sub 1 0; Mul 0 237; Sub 16 349; Mul 9 336; Mul 339 1; Sub 1 0; Mul 0 232; Mul 343 4;
  Mul 14 342; Sub 1 0; Mul 0 236; Sub 22 358; Mul 9 328; Mul 346 1; Sub 1 0; Mul 0 231; Mul 350 4;
  Mul 14 334; Sub 1 0; Mul 0 235; Mul 8 319; Mul 337 28; Sub 1 0; Mul 0 230; Mul 341 31;
  Mul 13 325; Sub 1 0; Mul 0 234; Sub 21 30; Sub 18 27; Sub 14 32; Sub 11 29; Mul 3 227;
  Mul 3 229; Sub 1 0; Mul 233 3; Mul 233 5; Sub 1 0; Add 3 0; Add 386 0; Sub 16 42; Sub 13 39;
  Mul 11 231; Mul 11 233; Sub 1 0; Mul 241 3; Mul 241 5; Sub 1 0; Add 3 0; Add 9 0; Mul 0 232;
  Mul 0 411; Mul 176 59; Add 400 0; Mul 148 60; Add 1 0; Mul 122 53; Add 1 0; Mul 96 46; Add 1 0;
  Sub 0 8;
  ShowZero 0; (* cotangent Laplacian *)
  Mul 209 68; Add 409 0; Mul 181 69; Add 1 0; Mul 151 62; Add 1 0; Mul 125 55; Add 1 0; Sub 0 17;
  ShowZero 0; (* Laplacian *)
  Sub 72 46; Sub 69 43; Mul 372 0; Mul 372 2; Sub 1 0; Mul 0 229; Mul 412 46; Mul 412 48; Sub 1 0;
  Mul 0 201; Sub 64 73; Sub 61 70; Mul 416 0; Mul 416 2; Sub 1 0; Mul 0 177; Sub 62 70; Sub 59 67;
  Mul 405 0; Mul 405 2; Sub 1 0; Mul 0 155; Mul 16 379; Add 440 0; Mul 14 421; Add 1 0;
  Mul 10 406; Add 1 0; Mul 6 391; Add 1 0; Mul 48 460; Sub 1 0;
  ShowZero 0; (* hinges *)
  Mul 392 462; Div 389 0; Mul 391 439; Mul 404 432; Sub 1 0; Mul 0 3; Mul 408 435; Mul 396 445;
  Sub 1 0; Mul 0 7; Add 459 4; Add 460 1; Mul 444 474; Div 401 0; Mul 443 449; Mul 452 427;
  Sub 1 0; Mul 0 3; Mul 456 430; Mul 448 455; Sub 1 0; Mul 0 7; Add 471 4; Add 472 1; Mul 439 486;
  Div 413 0; Mul 438 444; Mul 462 422; Sub 1 0; Mul 0 3; Mul 466 425; Mul 443 450; Sub 1 0;
  Mul 0 7; Add 483 4; Add 484 1; Mul 434 498; Div 425 0; Mul 433 439; Mul 457 428; Sub 1 0;
  Mul 0 3; Mul 461 431; Mul 438 445; Sub 1 0; Mul 0 7; Add 495 4; Add 496 1; Sub 25 37; Sub 25 37;
  Sub 15 39; Sub 15 39; Mul 3 0; Mul 3 2; Sub 1 0; Add 504 0; Sub 9 45; Sub 9 45; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Mul 345 524; Sub 1 0;
  ShowZero 0; (* area of the circumcentres *)
  Div 452 350; Mul 117 0; Mul 0 349; Mul 0 529; Sub 0 110;
  ShowZero 0 (* 2H *)
].

Theorem part_2_size_4_valid : valid part_2_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a star given by its circumcentres; size 5.
    Code: src/pair/area.rs, src/pair/cotangent.rs, src/pair/forms.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/pair/weight.rs, src/scalar/ring.rs, src/space/circle.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_5 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Neg 14; Neg 14; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 8; Unknown 9; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 8; Neg 8; Add 30 1; Add 30 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 35; Neg 35; Add 35 1; Add 35 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 40; Neg 40; Add 46 1; Add 46 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Constant 2; Mul 52 38; Mul 52 40; Sub 1 0; Mul 3 0; Div 0 35; Neg 0; Mul 45 35; Mul 45 37;
  Sub 1 0; Mul 9 0; Div 0 32; Neg 0; Constant 0; Sub 52 65; Sub 52 65; Neg 0; Mul 0 10; Mul 3 11;
  Sub 48 57; Sub 48 57; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0;
  Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 63 82; Mul 63 84; Sub 1 0; Mul 36 0; Div 0 52; Neg 0; Sub 89 69; Sub 89 69; Neg 0; Mul 0 3;
  Mul 3 4; Sub 1 31; Sub 1 32; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 102 99; Mul 102 101; Sub 1 0; Mul 55 0; Div 0 64; Neg 0; Neg 103; Mul 0 1; Mul 106 2;
  Sub 1 48; Sub 1 49; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 117 120; Mul 117 122; Sub 1 0; Mul 72 0; Div 0 74; Neg 0; Neg 118; Mul 0 1; Mul 121 2;
  Sub 1 65; Sub 1 66; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 61; Mul 7 63; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Constant 1; Mul 80 80; Add 0 0; Mul 2 0; Div 3 96; Mul 1 0; Add 3 85; Add 1 0; Mul 83 83;
  Mul 83 83; Add 1 0; Mul 10 0; Mul 0 7; Mul 92 88; Mul 93 88; Add 1 0; Add 0 95; Add 4 0;
  Mul 88 88; Mul 88 88; Add 1 0; Mul 20 0; Mul 0 17; Mul 102 93; Mul 103 93; Add 1 0; Add 0 105;
  Add 4 0; Mul 77 77; Mul 77 77; Add 1 0; Mul 30 0; Mul 0 27; Mul 112 82; Mul 113 82; Add 1 0;
  Add 0 115; Add 4 0; Mul 70 70; Mul 70 70; Add 1 0; Mul 40 0; Mul 0 37; Mul 122 75; Mul 123 75;
  Add 1 0; Add 0 125; Add 4 0; Mul 63 63; Mul 63 63; Add 1 0; Mul 50 0; Mul 0 47; Mul 132 68;
  Mul 133 68; Add 1 0; Add 0 135; Add 4 0; Sub 0 50; Sub 41 51; Div 59 63; Mul 2 128; Mul 74 2;
  Sub 1 0; Mul 0 3; Mul 78 5; Mul 7 134; Sub 1 0; Mul 0 7; Sub 41 61; Div 69 132; Mul 11 136;
  Mul 139 2; Sub 1 0; Mul 0 3; Mul 143 5; Mul 16 142; Sub 1 0; Mul 0 7; Sub 41 71; Div 79 123;
  Mul 11 127; Mul 147 2; Sub 1 0; Mul 0 3; Mul 151 5; Mul 16 133; Sub 1 0; Mul 0 7; Sub 41 81;
  Div 89 116; Mul 11 120; Mul 138 2; Sub 1 0; Mul 0 3; Mul 142 5; Mul 16 126; Sub 1 0; Mul 0 7;
  Div 98 108; Mul 10 112; Mul 130 42; Sub 1 0; Mul 0 3; Mul 134 45; Mul 15 118; Sub 1 0; Mul 0 7;
  Sub 33 43; Sub 30 40; Sub 25 45; Sub 22 42; Mul 3 0; Mul 3 2; Sub 1 0; Add 194 0; Sub 21 51;
  Sub 18 48; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 18 57; Sub 15 54; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Mul 0 220; Constant 4; Div 129 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 211 211;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 208 208;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 208 208;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 205 205;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 205 205;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 186 186;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 186 186;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 171 171;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 171 171;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 156 156;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 156 156;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowZero 10; (* the lift *)
  Sub 135 222;
  ShowZero 0; (* the lift *)
  ShowZero 10; (* the lift *)
  ShowZero 9; (* the lift *)
  Mul 288 219; Mul 288 219; Add 1 0; Sub 129 0;
  ShowZero 0; (* the lift *)
  ShowZero 12; (* the lift *)
  ShowZero 11; (* the lift *)
  Mul 279 218; Mul 279 218; Add 1 0; Sub 123 0;
  ShowZero 0; (* the lift *)
  ShowZero 14; (* the lift *)
  ShowZero 13; (* the lift *)
  Mul 274 201; Mul 274 201; Add 1 0; Sub 117 0;
  ShowZero 0; (* the lift *)
  ShowZero 16; (* the lift *)
  ShowZero 15; (* the lift *)
  Mul 298 188; Mul 298 188; Add 1 0; Sub 111 0;
  ShowZero 0; (* the lift *)
  ShowZero 18; (* the lift *)
  ShowZero 17; (* the lift *)
  Mul 300 175; Mul 300 175; Add 1 0; Sub 105 0;
  ShowZero 0; (* the lift *)
  Div 163 164; Sub 100 61; Sub 97 58; Mul 180 0; Mul 180 2; Sub 1 0; Mul 0 5; Sub 250 246;
  Sub 251 246; Sub 188 248; Sub 188 248; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 197 214; Sub 197 214; Sub 263 216; Sub 264 216; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3;
  Mul 6 5; Sub 1 0; Div 3 0; Add 11 0; Mul 0 189; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 195 255; Mul 265 87; Mul 265 89; Sub 1 0; Mul 0 3; Sub 280 271; Sub 281 271; Sub 278 273;
  Sub 278 273; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0; Div 3 0; Sub 287 227;
  Sub 287 227; Sub 293 229; Sub 294 229; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Add 11 0; Mul 0 219; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 225 266; Sub 142 152; Sub 139 149; Mul 295 0; Mul 295 2; Sub 1 0; Mul 0 5; Sub 312 282;
  Sub 313 282; Sub 305 284; Sub 305 284; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 314 319; Sub 314 319; Mul 1 74; Mul 1 74; Add 1 0; Mul 4 76; Mul 4 78; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 249; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 255 279; Sub 162 172; Sub 159 169; Mul 306 0; Mul 306 2; Sub 1 0; Mul 0 5; Sub 312 295;
  Sub 312 295; Mul 80 1; Mul 80 1; Add 1 0; Mul 83 3; Mul 83 5; Sub 1 0; Div 3 0; Sub 321 342;
  Sub 321 342; Mul 1 72; Mul 1 72; Add 1 0; Mul 4 74; Mul 4 76; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 277; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 283 290; Sub 181 190; Sub 178 187; Mul 317 0; Mul 317 2; Sub 1 0; Mul 0 5; Sub 323 306;
  Sub 323 306; Mul 78 1; Mul 78 1; Add 1 0; Mul 81 3; Mul 81 5; Sub 1 0; Div 3 0; Sub 332 349;
  Sub 332 349; Mul 1 68; Mul 1 68; Add 1 0; Mul 4 70; Mul 4 72; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 305; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Unknown 10; Unknown 11; Unknown 12; Mul 393 2; Mul 393 3; Add 396 1; Add 397 1; Mul 392 5;
  Mul 392 6; Add 3 1; Add 3 1; Mul 375 8; Mul 375 9; Add 3 1; Add 3 1; Sub 406 1; Sub 407 1;
  Mul 1 464; Mul 1 466; Sub 1 0; Div 0 464; Mul 471 0; Mul 471 1; Add 9 1; Add 9 1; Mul 19 407;
  Mul 19 407; Add 1 0; Mul 18 389; Mul 18 389; Add 1 0; Mul 17 375; Mul 17 375; Add 1 0;
  Mul 10 361; Mul 10 361; Add 1 0; Sub 0 428; Sub 334 429; Mul 1 418; Mul 364 1; Sub 1 0;
  Mul 0 293; Mul 368 4; Mul 6 424; Sub 1 0; Mul 0 297; Sub 19 438; Mul 9 425; Mul 428 1; Sub 1 0;
  Mul 0 292; Mul 432 4; Mul 14 431; Sub 1 0; Mul 0 296; Sub 25 447; Mul 9 415; Mul 435 1; Sub 1 0;
  Mul 0 291; Mul 439 4; Mul 14 421; Sub 1 0; Mul 0 295; Sub 31 456; Mul 9 407; Mul 425 1; Sub 1 0;
  Mul 0 290; Mul 429 4; Mul 14 413; Sub 1 0; Mul 0 294; Mul 8 398; Mul 416 37; Sub 1 0; Mul 0 289;
  Mul 420 40; Mul 13 404; Sub 1 0; Mul 0 293; Sub 30 39; Sub 27 36; Sub 23 41; Sub 20 38;
  Mul 3 286; Mul 3 288; Sub 1 0; Mul 292 3; Mul 292 5; Sub 1 0; Add 3 0; Add 484 0; Sub 24 51;
  Sub 21 48; Mul 11 290; Mul 11 292; Sub 1 0; Mul 300 3; Mul 300 5; Sub 1 0; Add 3 0; Add 9 0;
  Sub 26 61; Sub 23 58; Mul 11 294; Mul 11 296; Sub 1 0; Mul 304 3; Mul 304 5; Sub 1 0; Add 3 0;
  Add 9 0; Mul 0 295; Mul 0 519; Mul 233 78; Add 508 0; Mul 205 79; Add 1 0; Mul 177 72; Add 1 0;
  Mul 151 65; Add 1 0; Mul 125 58; Add 1 0; Sub 0 10;
  ShowZero 0; (* cotangent Laplacian *)
  Mul 268 89; Add 519 0; Mul 240 90; Add 1 0; Mul 210 83; Add 1 0; Mul 182 76; Add 1 0;
  Mul 156 69; Add 1 0; Sub 0 21;
  ShowZero 0; (* Laplacian *)
  Sub 95 60; Sub 92 57; Mul 465 0; Mul 465 2; Sub 1 0; Mul 0 290; Mul 524 60; Mul 524 62; Sub 1 0;
  Mul 0 262; Sub 87 96; Sub 84 93; Mul 528 0; Mul 528 2; Sub 1 0; Mul 0 238; Sub 84 93; Sub 81 90;
  Mul 515 0; Mul 515 2; Sub 1 0; Mul 0 214; Sub 82 90; Sub 79 87; Mul 504 0; Mul 504 2; Sub 1 0;
  Mul 0 192; Mul 22 478; Add 558 0; Mul 20 539; Add 1 0; Mul 16 522; Add 1 0; Mul 12 507; Add 1 0;
  Mul 8 492; Add 1 0; Mul 60 580; Sub 1 0;
  ShowZero 0; (* hinges *)
  Mul 493 582; Div 490 0; Mul 492 559; Mul 505 552; Sub 1 0; Mul 0 3; Mul 509 555; Mul 497 565;
  Sub 1 0; Mul 0 7; Add 579 4; Add 580 1; Mul 564 594; Div 502 0; Mul 563 569; Mul 572 545;
  Sub 1 0; Mul 0 3; Mul 576 548; Mul 568 575; Sub 1 0; Mul 0 7; Add 591 4; Add 592 1; Mul 557 606;
  Div 514 0; Mul 556 562; Mul 582 540; Sub 1 0; Mul 0 3; Mul 586 543; Mul 561 568; Sub 1 0;
  Mul 0 7; Add 603 4; Add 604 1; Mul 552 618; Div 526 0; Mul 551 557; Mul 575 535; Sub 1 0;
  Mul 0 3; Mul 579 538; Mul 556 563; Sub 1 0; Mul 0 7; Add 615 4; Add 616 1; Mul 547 630;
  Div 538 0; Mul 546 552; Mul 570 541; Sub 1 0; Mul 0 3; Mul 574 544; Mul 551 558; Sub 1 0;
  Mul 0 7; Add 627 4; Add 628 1; Sub 37 49; Sub 37 49; Sub 27 51; Sub 27 51; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 636 0; Sub 21 57; Sub 21 57; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 15 63;
  Sub 15 63; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 438 662; Sub 1 0;
  ShowZero 0; (* area of the circumcentres *)
  Div 571 443; Mul 147 0; Mul 0 442; Mul 0 667; Sub 0 138;
  ShowZero 0 (* 2H *)
].

Theorem part_2_size_5_valid : valid part_2_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a star given by its circumcentres; size 6.
    Code: src/pair/area.rs, src/pair/cotangent.rs, src/pair/forms.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/pair/weight.rs, src/scalar/ring.rs, src/space/circle.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_6 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Neg 14; Neg 14; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 8; Unknown 9; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 10; Unknown 11; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 8; Neg 8; Add 39 1; Add 39 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 44; Neg 44; Add 44 1; Add 44 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 49; Neg 49; Add 55 1; Add 55 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Constant 2; Mul 61 47; Mul 61 49; Sub 1 0; Mul 3 0; Div 0 44; Neg 0; Mul 54 44; Mul 54 46;
  Sub 1 0; Mul 9 0; Div 0 41; Neg 0; Constant 0; Sub 61 74; Sub 61 74; Neg 0; Mul 0 10; Mul 3 11;
  Sub 57 66; Sub 57 66; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0;
  Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 72 62; Mul 72 64; Sub 1 0; Mul 36 0; Div 0 59; Neg 0; Sub 69 78; Sub 69 78; Neg 0; Mul 0 3;
  Mul 3 4; Sub 1 31; Sub 1 32; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 82 110; Mul 82 112; Sub 1 0; Mul 55 0; Div 0 71; Neg 0; Sub 117 88; Sub 117 88; Neg 0;
  Mul 0 3; Mul 3 4; Sub 1 50; Sub 1 51; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 130 127; Mul 130 129; Sub 1 0; Mul 74 0; Div 0 83; Neg 0; Neg 131; Mul 0 1; Mul 134 2;
  Sub 1 67; Sub 1 68; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 145 148; Mul 145 150; Sub 1 0; Mul 91 0; Div 0 93; Neg 0; Neg 146; Mul 0 1; Mul 149 2;
  Sub 1 84; Sub 1 85; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 80; Mul 7 82; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Constant 1; Mul 99 99; Add 0 0; Mul 2 0; Div 3 115; Mul 1 0; Add 3 104; Add 1 0; Mul 102 102;
  Mul 102 102; Add 1 0; Mul 10 0; Mul 0 7; Mul 111 107; Mul 112 107; Add 1 0; Add 0 114; Add 4 0;
  Mul 107 107; Mul 107 107; Add 1 0; Mul 20 0; Mul 0 17; Mul 121 112; Mul 122 112; Add 1 0;
  Add 0 124; Add 4 0; Mul 96 96; Mul 96 96; Add 1 0; Mul 30 0; Mul 0 27; Mul 131 101; Mul 132 101;
  Add 1 0; Add 0 134; Add 4 0; Mul 87 87; Mul 87 87; Add 1 0; Mul 40 0; Mul 0 37; Mul 141 92;
  Mul 142 92; Add 1 0; Add 0 144; Add 4 0; Mul 80 80; Mul 80 80; Add 1 0; Mul 50 0; Mul 0 47;
  Mul 151 85; Mul 152 85; Add 1 0; Add 0 154; Add 4 0; Mul 73 73; Mul 73 73; Add 1 0; Mul 60 0;
  Mul 0 57; Mul 161 78; Mul 162 78; Add 1 0; Add 0 164; Add 4 0; Sub 0 60; Sub 51 61; Div 69 73;
  Mul 2 157; Mul 84 2; Sub 1 0; Mul 0 3; Mul 88 5; Mul 7 163; Sub 1 0; Mul 0 7; Sub 51 71;
  Div 79 161; Mul 11 165; Mul 168 2; Sub 1 0; Mul 0 3; Mul 172 5; Mul 16 171; Sub 1 0; Mul 0 7;
  Sub 51 81; Div 89 152; Mul 11 156; Mul 176 2; Sub 1 0; Mul 0 3; Mul 180 5; Mul 16 162; Sub 1 0;
  Mul 0 7; Sub 51 91; Div 99 143; Mul 11 147; Mul 167 2; Sub 1 0; Mul 0 3; Mul 171 5; Mul 16 153;
  Sub 1 0; Mul 0 7; Sub 51 101; Div 109 136; Mul 11 140; Mul 158 2; Sub 1 0; Mul 0 3; Mul 162 5;
  Mul 16 146; Sub 1 0; Mul 0 7; Div 118 128; Mul 10 132; Mul 150 52; Sub 1 0; Mul 0 3; Mul 154 55;
  Mul 15 138; Sub 1 0; Mul 0 7; Sub 43 53; Sub 40 50; Sub 35 55; Sub 32 52; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 233 0; Sub 31 61; Sub 28 58; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 27 67;
  Sub 24 64; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 24 73; Sub 21 70; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Mul 0 265; Constant 4; Div 155 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 256 256;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 253 253;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 253 253;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 250 250;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 250 250;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 231 231;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 231 231;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 214 214;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 214 214;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 199 199;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 199 199;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 184 184;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 184 184;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowZero 12; (* the lift *)
  Sub 163 269;
  ShowZero 0; (* the lift *)
  ShowZero 12; (* the lift *)
  ShowZero 11; (* the lift *)
  Mul 344 266; Mul 344 266; Add 1 0; Sub 157 0;
  ShowZero 0; (* the lift *)
  ShowZero 14; (* the lift *)
  ShowZero 13; (* the lift *)
  Mul 335 265; Mul 335 265; Add 1 0; Sub 151 0;
  ShowZero 0; (* the lift *)
  ShowZero 16; (* the lift *)
  ShowZero 15; (* the lift *)
  Mul 330 248; Mul 330 248; Add 1 0; Sub 145 0;
  ShowZero 0; (* the lift *)
  ShowZero 18; (* the lift *)
  ShowZero 17; (* the lift *)
  Mul 325 233; Mul 325 233; Add 1 0; Sub 139 0;
  ShowZero 0; (* the lift *)
  ShowZero 20; (* the lift *)
  ShowZero 19; (* the lift *)
  Mul 358 220; Mul 358 220; Add 1 0; Sub 133 0;
  ShowZero 0; (* the lift *)
  ShowZero 22; (* the lift *)
  ShowZero 21; (* the lift *)
  Mul 360 207; Mul 360 207; Add 1 0; Sub 127 0;
  ShowZero 0; (* the lift *)
  Div 195 196; Sub 122 73; Sub 119 70; Mul 212 0; Mul 212 2; Sub 1 0; Mul 0 5; Sub 301 297;
  Sub 302 297; Sub 220 299; Sub 220 299; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 229 246; Sub 229 246; Sub 314 248; Sub 315 248; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3;
  Mul 6 5; Sub 1 0; Div 3 0; Add 11 0; Mul 0 221; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 227 306; Mul 316 99; Mul 316 101; Sub 1 0; Mul 0 3; Sub 331 322; Sub 332 322; Sub 329 324;
  Sub 329 324; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0; Div 3 0; Sub 338 259;
  Sub 338 259; Sub 344 261; Sub 345 261; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Add 11 0; Mul 0 251; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 257 317; Sub 164 174; Sub 161 171; Mul 346 0; Mul 346 2; Sub 1 0; Mul 0 5; Sub 363 333;
  Sub 364 333; Sub 356 335; Sub 356 335; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 365 370; Sub 365 370; Mul 1 74; Mul 1 74; Add 1 0; Mul 4 76; Mul 4 78; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 281; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 287 328; Sub 184 194; Sub 181 191; Mul 357 0; Mul 357 2; Sub 1 0; Mul 0 5; Sub 393 344;
  Sub 394 344; Sub 365 346; Sub 365 346; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 374 395; Sub 374 395; Mul 1 74; Mul 1 74; Add 1 0; Mul 4 76; Mul 4 78; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 311; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 317 341; Sub 204 214; Sub 201 211; Mul 368 0; Mul 368 2; Sub 1 0; Mul 0 5; Sub 374 357;
  Sub 374 357; Mul 110 1; Mul 110 1; Add 1 0; Mul 113 3; Mul 113 5; Sub 1 0; Div 3 0; Sub 383 402;
  Sub 383 402; Mul 1 70; Mul 1 70; Add 1 0; Mul 4 72; Mul 4 74; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 339; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 345 352; Sub 223 232; Sub 220 229; Mul 379 0; Mul 379 2; Sub 1 0; Mul 0 5; Sub 385 368;
  Sub 385 368; Mul 108 1; Mul 108 1; Add 1 0; Mul 111 3; Mul 111 5; Sub 1 0; Div 3 0; Sub 394 411;
  Sub 394 411; Mul 1 68; Mul 1 68; Add 1 0; Mul 4 70; Mul 4 72; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 367; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Unknown 12; Unknown 13; Unknown 14; Unknown 15; Mul 475 3; Mul 475 4; Add 478 1; Add 479 1;
  Mul 474 6; Mul 474 7; Add 3 1; Add 3 1; Mul 457 9; Mul 457 10; Add 3 1; Add 3 1; Mul 442 12;
  Mul 442 13; Add 3 1; Add 3 1; Sub 492 1; Sub 493 1; Mul 1 559; Mul 1 561; Sub 1 0; Div 0 559;
  Mul 566 0; Mul 566 1; Add 9 1; Add 9 1; Mul 23 493; Mul 23 493; Add 1 0; Mul 22 475; Mul 22 475;
  Add 1 0; Mul 21 459; Mul 21 459; Add 1 0; Mul 20 445; Mul 20 445; Add 1 0; Mul 13 431;
  Mul 13 431; Add 1 0; Sub 0 517; Sub 404 518; Mul 1 507; Mul 434 1; Sub 1 0; Mul 0 353;
  Mul 438 4; Mul 6 513; Sub 1 0; Mul 0 357; Sub 22 527; Mul 9 514; Mul 517 1; Sub 1 0; Mul 0 352;
  Mul 521 4; Mul 14 520; Sub 1 0; Mul 0 356; Sub 28 536; Mul 9 504; Mul 524 1; Sub 1 0; Mul 0 351;
  Mul 528 4; Mul 14 510; Sub 1 0; Mul 0 355; Sub 34 545; Mul 9 494; Mul 514 1; Sub 1 0; Mul 0 350;
  Mul 518 4; Mul 14 500; Sub 1 0; Mul 0 354; Sub 40 554; Mul 9 486; Mul 504 1; Sub 1 0; Mul 0 349;
  Mul 508 4; Mul 14 492; Sub 1 0; Mul 0 353; Mul 8 477; Mul 495 46; Sub 1 0; Mul 0 348;
  Mul 499 49; Mul 13 483; Sub 1 0; Mul 0 352; Sub 39 48; Sub 36 45; Sub 32 50; Sub 29 47;
  Mul 3 345; Mul 3 347; Sub 1 0; Mul 351 3; Mul 351 5; Sub 1 0; Add 3 0; Add 582 0; Sub 33 60;
  Sub 30 57; Mul 11 349; Mul 11 351; Sub 1 0; Mul 359 3; Mul 359 5; Sub 1 0; Add 3 0; Add 9 0;
  Sub 34 70; Sub 31 67; Mul 11 353; Mul 11 355; Sub 1 0; Mul 363 3; Mul 363 5; Sub 1 0; Add 3 0;
  Add 9 0; Sub 36 80; Sub 33 77; Mul 11 357; Mul 11 359; Sub 1 0; Mul 367 3; Mul 367 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 358; Mul 0 627; Mul 290 97; Add 616 0; Mul 262 98; Add 1 0; Mul 234 91;
  Add 1 0; Mul 206 84; Add 1 0; Mul 180 77; Add 1 0; Mul 154 70; Add 1 0; Sub 0 12;
  ShowZero 0; (* cotangent Laplacian *)
  Mul 327 110; Add 629 0; Mul 299 111; Add 1 0; Mul 269 104; Add 1 0; Mul 241 97; Add 1 0;
  Mul 213 90; Add 1 0; Mul 187 83; Add 1 0; Sub 0 25;
  ShowZero 0; (* Laplacian *)
  Sub 118 74; Sub 115 71; Mul 558 0; Mul 558 2; Sub 1 0; Mul 0 351; Mul 636 74; Mul 636 76;
  Sub 1 0; Mul 0 323; Sub 110 119; Sub 107 116; Mul 640 0; Mul 640 2; Sub 1 0; Mul 0 299;
  Sub 107 116; Sub 104 113; Mul 627 0; Mul 627 2; Sub 1 0; Mul 0 275; Sub 104 113; Sub 101 110;
  Mul 614 0; Mul 614 2; Sub 1 0; Mul 0 251; Sub 102 110; Sub 99 107; Mul 603 0; Mul 603 2;
  Sub 1 0; Mul 0 229; Mul 28 577; Add 676 0; Mul 26 657; Add 1 0; Mul 22 640; Add 1 0; Mul 18 623;
  Add 1 0; Mul 14 608; Add 1 0; Mul 10 593; Add 1 0; Mul 72 700; Sub 1 0;
  ShowZero 0; (* hinges *)
  Mul 594 702; Div 591 0; Mul 593 679; Mul 606 672; Sub 1 0; Mul 0 3; Mul 610 675; Mul 598 685;
  Sub 1 0; Mul 0 7; Add 699 4; Add 700 1; Mul 684 714; Div 603 0; Mul 683 689; Mul 692 665;
  Sub 1 0; Mul 0 3; Mul 696 668; Mul 688 695; Sub 1 0; Mul 0 7; Add 711 4; Add 712 1; Mul 677 726;
  Div 615 0; Mul 676 682; Mul 702 658; Sub 1 0; Mul 0 3; Mul 706 661; Mul 681 688; Sub 1 0;
  Mul 0 7; Add 723 4; Add 724 1; Mul 670 738; Div 627 0; Mul 669 675; Mul 695 653; Sub 1 0;
  Mul 0 3; Mul 699 656; Mul 674 681; Sub 1 0; Mul 0 7; Add 735 4; Add 736 1; Mul 665 750;
  Div 639 0; Mul 664 670; Mul 688 648; Sub 1 0; Mul 0 3; Mul 692 651; Mul 669 676; Sub 1 0;
  Mul 0 7; Add 747 4; Add 748 1; Mul 660 762; Div 651 0; Mul 659 665; Mul 683 654; Sub 1 0;
  Mul 0 3; Mul 687 657; Mul 664 671; Sub 1 0; Mul 0 7; Add 759 4; Add 760 1; Sub 49 61; Sub 49 61;
  Sub 39 63; Sub 39 63; Mul 3 0; Mul 3 2; Sub 1 0; Add 768 0; Sub 33 69; Sub 33 69; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 27 75; Sub 27 75; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 21 81;
  Sub 21 81; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 531 800; Sub 1 0;
  ShowZero 0; (* area of the circumcentres *)
  Div 690 536; Mul 177 0; Mul 0 535; Mul 0 805; Sub 0 166;
  ShowZero 0 (* 2H *)
].

Theorem part_2_size_6_valid : valid part_2_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a star given by its circumcentres; size 7.
    Code: src/pair/area.rs, src/pair/cotangent.rs, src/pair/forms.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/pair/weight.rs, src/scalar/ring.rs, src/space/circle.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_7 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Neg 14; Neg 14; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 8; Unknown 9; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 10; Unknown 11; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 12; Unknown 13; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 8; Neg 8; Add 48 1; Add 48 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 53; Neg 53; Add 53 1; Add 53 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 58; Neg 58; Add 64 1; Add 64 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Constant 2; Mul 70 56; Mul 70 58; Sub 1 0; Mul 3 0; Div 0 53; Neg 0; Mul 63 53; Mul 63 55;
  Sub 1 0; Mul 9 0; Div 0 50; Neg 0; Constant 0; Sub 70 83; Sub 70 83; Neg 0; Mul 0 10; Mul 3 11;
  Sub 66 75; Sub 66 75; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0;
  Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 81 71; Mul 81 73; Sub 1 0; Mul 36 0; Div 0 68; Neg 0; Sub 78 87; Sub 78 87; Neg 0; Mul 0 3;
  Mul 3 4; Sub 1 31; Sub 1 32; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 91 81; Mul 91 83; Sub 1 0; Mul 55 0; Div 0 78; Neg 0; Sub 88 97; Sub 88 97; Neg 0; Mul 0 3;
  Mul 3 4; Sub 1 50; Sub 1 51; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 101 138; Mul 101 140; Sub 1 0; Mul 74 0; Div 0 90; Neg 0; Sub 145 107; Sub 145 107; Neg 0;
  Mul 0 3; Mul 3 4; Sub 1 69; Sub 1 70; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 158 155; Mul 158 157; Sub 1 0; Mul 93 0; Div 0 102; Neg 0; Neg 159; Mul 0 1; Mul 162 2;
  Sub 1 86; Sub 1 87; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 173 176; Mul 173 178; Sub 1 0; Mul 110 0; Div 0 112; Neg 0; Neg 174; Mul 0 1; Mul 177 2;
  Sub 1 103; Sub 1 104; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 99; Mul 7 101; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Constant 1; Mul 118 118; Add 0 0; Mul 2 0; Div 3 134; Mul 1 0; Add 3 123; Add 1 0; Mul 121 121;
  Mul 121 121; Add 1 0; Mul 10 0; Mul 0 7; Mul 130 126; Mul 131 126; Add 1 0; Add 0 133; Add 4 0;
  Mul 126 126; Mul 126 126; Add 1 0; Mul 20 0; Mul 0 17; Mul 140 131; Mul 141 131; Add 1 0;
  Add 0 143; Add 4 0; Mul 115 115; Mul 115 115; Add 1 0; Mul 30 0; Mul 0 27; Mul 150 120;
  Mul 151 120; Add 1 0; Add 0 153; Add 4 0; Mul 106 106; Mul 106 106; Add 1 0; Mul 40 0; Mul 0 37;
  Mul 160 111; Mul 161 111; Add 1 0; Add 0 163; Add 4 0; Mul 97 97; Mul 97 97; Add 1 0; Mul 50 0;
  Mul 0 47; Mul 170 102; Mul 171 102; Add 1 0; Add 0 173; Add 4 0; Mul 90 90; Mul 90 90; Add 1 0;
  Mul 60 0; Mul 0 57; Mul 180 95; Mul 181 95; Add 1 0; Add 0 183; Add 4 0; Mul 83 83; Mul 83 83;
  Add 1 0; Mul 70 0; Mul 0 67; Mul 190 88; Mul 191 88; Add 1 0; Add 0 193; Add 4 0; Sub 0 70;
  Sub 61 71; Div 79 83; Mul 2 186; Mul 94 2; Sub 1 0; Mul 0 3; Mul 98 5; Mul 7 192; Sub 1 0;
  Mul 0 7; Sub 61 81; Div 89 190; Mul 11 194; Mul 197 2; Sub 1 0; Mul 0 3; Mul 201 5; Mul 16 200;
  Sub 1 0; Mul 0 7; Sub 61 91; Div 99 181; Mul 11 185; Mul 205 2; Sub 1 0; Mul 0 3; Mul 209 5;
  Mul 16 191; Sub 1 0; Mul 0 7; Sub 61 101; Div 109 172; Mul 11 176; Mul 196 2; Sub 1 0; Mul 0 3;
  Mul 200 5; Mul 16 182; Sub 1 0; Mul 0 7; Sub 61 111; Div 119 163; Mul 11 167; Mul 187 2;
  Sub 1 0; Mul 0 3; Mul 191 5; Mul 16 173; Sub 1 0; Mul 0 7; Sub 61 121; Div 129 156; Mul 11 160;
  Mul 178 2; Sub 1 0; Mul 0 3; Mul 182 5; Mul 16 166; Sub 1 0; Mul 0 7; Div 138 148; Mul 10 152;
  Mul 170 62; Sub 1 0; Mul 0 3; Mul 174 65; Mul 15 158; Sub 1 0; Mul 0 7; Sub 53 63; Sub 50 60;
  Sub 45 65; Sub 42 62; Mul 3 0; Mul 3 2; Sub 1 0; Add 272 0; Sub 41 71; Sub 38 68; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 37 77; Sub 34 74; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 33 83;
  Sub 30 80; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 30 89; Sub 27 86; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Mul 0 310; Constant 4; Div 181 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 301 301;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 298 298;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 298 298;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 295 295;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 295 295;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 276 276;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 276 276;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 259 259;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 259 259;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 242 242;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 242 242;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 227 227;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 227 227;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 212 212;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 212 212;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowZero 14; (* the lift *)
  Sub 191 316;
  ShowZero 0; (* the lift *)
  ShowZero 14; (* the lift *)
  ShowZero 13; (* the lift *)
  Mul 400 313; Mul 400 313; Add 1 0; Sub 185 0;
  ShowZero 0; (* the lift *)
  ShowZero 16; (* the lift *)
  ShowZero 15; (* the lift *)
  Mul 391 312; Mul 391 312; Add 1 0; Sub 179 0;
  ShowZero 0; (* the lift *)
  ShowZero 18; (* the lift *)
  ShowZero 17; (* the lift *)
  Mul 386 295; Mul 386 295; Add 1 0; Sub 173 0;
  ShowZero 0; (* the lift *)
  ShowZero 20; (* the lift *)
  ShowZero 19; (* the lift *)
  Mul 381 280; Mul 381 280; Add 1 0; Sub 167 0;
  ShowZero 0; (* the lift *)
  ShowZero 22; (* the lift *)
  ShowZero 21; (* the lift *)
  Mul 376 265; Mul 376 265; Add 1 0; Sub 161 0;
  ShowZero 0; (* the lift *)
  ShowZero 24; (* the lift *)
  ShowZero 23; (* the lift *)
  Mul 418 252; Mul 418 252; Add 1 0; Sub 155 0;
  ShowZero 0; (* the lift *)
  ShowZero 26; (* the lift *)
  ShowZero 25; (* the lift *)
  Mul 420 239; Mul 420 239; Add 1 0; Sub 149 0;
  ShowZero 0; (* the lift *)
  Div 227 228; Sub 144 85; Sub 141 82; Mul 244 0; Mul 244 2; Sub 1 0; Mul 0 5; Sub 352 348;
  Sub 353 348; Sub 252 350; Sub 252 350; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 261 278; Sub 261 278; Sub 365 280; Sub 366 280; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3;
  Mul 6 5; Sub 1 0; Div 3 0; Add 11 0; Mul 0 253; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 259 357; Mul 367 111; Mul 367 113; Sub 1 0; Mul 0 3; Sub 382 373; Sub 383 373; Sub 380 375;
  Sub 380 375; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0; Div 3 0; Sub 389 291;
  Sub 389 291; Sub 395 293; Sub 396 293; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Add 11 0; Mul 0 283; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 289 368; Sub 186 196; Sub 183 193; Mul 397 0; Mul 397 2; Sub 1 0; Mul 0 5; Sub 414 384;
  Sub 415 384; Sub 407 386; Sub 407 386; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 416 421; Sub 416 421; Mul 1 74; Mul 1 74; Add 1 0; Mul 4 76; Mul 4 78; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 313; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 319 379; Sub 206 216; Sub 203 213; Mul 408 0; Mul 408 2; Sub 1 0; Mul 0 5; Sub 444 395;
  Sub 445 395; Sub 416 397; Sub 416 397; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 425 446; Sub 425 446; Mul 1 74; Mul 1 74; Add 1 0; Mul 4 76; Mul 4 78; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 343; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 349 390; Sub 226 236; Sub 223 233; Mul 419 0; Mul 419 2; Sub 1 0; Mul 0 5; Sub 474 406;
  Sub 475 406; Sub 427 408; Sub 427 408; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 436 455; Sub 436 455; Mul 1 72; Mul 1 72; Add 1 0; Mul 4 74; Mul 4 76; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 373; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 379 403; Sub 246 256; Sub 243 253; Mul 430 0; Mul 430 2; Sub 1 0; Mul 0 5; Sub 436 419;
  Sub 436 419; Mul 140 1; Mul 140 1; Add 1 0; Mul 143 3; Mul 143 5; Sub 1 0; Div 3 0; Sub 445 464;
  Sub 445 464; Mul 1 70; Mul 1 70; Add 1 0; Mul 4 72; Mul 4 74; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 401; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 407 414; Sub 265 274; Sub 262 271; Mul 441 0; Mul 441 2; Sub 1 0; Mul 0 5; Sub 447 430;
  Sub 447 430; Mul 138 1; Mul 138 1; Add 1 0; Mul 141 3; Mul 141 5; Sub 1 0; Div 3 0; Sub 456 473;
  Sub 456 473; Mul 1 68; Mul 1 68; Add 1 0; Mul 4 70; Mul 4 72; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 429; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Unknown 14; Unknown 15; Unknown 16; Unknown 17; Unknown 18; Mul 557 4; Mul 557 5; Add 560 1;
  Add 561 1; Mul 556 7; Mul 556 8; Add 3 1; Add 3 1; Mul 539 10; Mul 539 11; Add 3 1; Add 3 1;
  Mul 524 13; Mul 524 14; Add 3 1; Add 3 1; Mul 509 16; Mul 509 17; Add 3 1; Add 3 1; Sub 578 1;
  Sub 579 1; Mul 1 654; Mul 1 656; Sub 1 0; Div 0 654; Mul 661 0; Mul 661 1; Add 9 1; Add 9 1;
  Mul 27 579; Mul 27 579; Add 1 0; Mul 26 561; Mul 26 561; Add 1 0; Mul 25 545; Mul 25 545;
  Add 1 0; Mul 24 529; Mul 24 529; Add 1 0; Mul 23 515; Mul 23 515; Add 1 0; Mul 16 501;
  Mul 16 501; Add 1 0; Sub 0 606; Sub 474 607; Mul 1 596; Mul 504 1; Sub 1 0; Mul 0 413;
  Mul 508 4; Mul 6 602; Sub 1 0; Mul 0 417; Sub 25 616; Mul 9 603; Mul 606 1; Sub 1 0; Mul 0 412;
  Mul 610 4; Mul 14 609; Sub 1 0; Mul 0 416; Sub 31 625; Mul 9 593; Mul 613 1; Sub 1 0; Mul 0 411;
  Mul 617 4; Mul 14 599; Sub 1 0; Mul 0 415; Sub 37 634; Mul 9 583; Mul 603 1; Sub 1 0; Mul 0 410;
  Mul 607 4; Mul 14 589; Sub 1 0; Mul 0 414; Sub 43 643; Mul 9 573; Mul 593 1; Sub 1 0; Mul 0 409;
  Mul 597 4; Mul 14 579; Sub 1 0; Mul 0 413; Sub 49 652; Mul 9 565; Mul 583 1; Sub 1 0; Mul 0 408;
  Mul 587 4; Mul 14 571; Sub 1 0; Mul 0 412; Mul 8 556; Mul 574 55; Sub 1 0; Mul 0 407;
  Mul 578 58; Mul 13 562; Sub 1 0; Mul 0 411; Sub 48 57; Sub 45 54; Sub 41 59; Sub 38 56;
  Mul 3 404; Mul 3 406; Sub 1 0; Mul 410 3; Mul 410 5; Sub 1 0; Add 3 0; Add 680 0; Sub 42 69;
  Sub 39 66; Mul 11 408; Mul 11 410; Sub 1 0; Mul 418 3; Mul 418 5; Sub 1 0; Add 3 0; Add 9 0;
  Sub 43 79; Sub 40 76; Mul 11 412; Mul 11 414; Sub 1 0; Mul 422 3; Mul 422 5; Sub 1 0; Add 3 0;
  Add 9 0; Sub 44 89; Sub 41 86; Mul 11 416; Mul 11 418; Sub 1 0; Mul 426 3; Mul 426 5; Sub 1 0;
  Add 3 0; Add 9 0; Sub 46 99; Sub 43 96; Mul 11 420; Mul 11 422; Sub 1 0; Mul 430 3; Mul 430 5;
  Sub 1 0; Add 3 0; Add 9 0; Mul 0 421; Mul 0 735; Mul 347 116; Add 724 0; Mul 319 117; Add 1 0;
  Mul 291 110; Add 1 0; Mul 263 103; Add 1 0; Mul 235 96; Add 1 0; Mul 209 89; Add 1 0;
  Mul 183 82; Add 1 0; Sub 0 14;
  ShowZero 0; (* cotangent Laplacian *)
  Mul 386 131; Add 739 0; Mul 358 132; Add 1 0; Mul 328 125; Add 1 0; Mul 300 118; Add 1 0;
  Mul 272 111; Add 1 0; Mul 244 104; Add 1 0; Mul 218 97; Add 1 0; Sub 0 29;
  ShowZero 0; (* Laplacian *)
  Sub 141 88; Sub 138 85; Mul 651 0; Mul 651 2; Sub 1 0; Mul 0 412; Mul 748 88; Mul 748 90;
  Sub 1 0; Mul 0 384; Sub 133 142; Sub 130 139; Mul 752 0; Mul 752 2; Sub 1 0; Mul 0 360;
  Sub 130 139; Sub 127 136; Mul 739 0; Mul 739 2; Sub 1 0; Mul 0 336; Sub 127 136; Sub 124 133;
  Mul 726 0; Mul 726 2; Sub 1 0; Mul 0 312; Sub 124 133; Sub 121 130; Mul 713 0; Mul 713 2;
  Sub 1 0; Mul 0 288; Sub 122 130; Sub 119 127; Mul 702 0; Mul 702 2; Sub 1 0; Mul 0 266;
  Mul 34 676; Add 794 0; Mul 32 775; Add 1 0; Mul 28 758; Add 1 0; Mul 24 741; Add 1 0;
  Mul 20 724; Add 1 0; Mul 16 709; Add 1 0; Mul 12 694; Add 1 0; Mul 84 820; Sub 1 0;
  ShowZero 0; (* hinges *)
  Mul 695 822; Div 692 0; Mul 694 799; Mul 707 792; Sub 1 0; Mul 0 3; Mul 711 795; Mul 699 805;
  Sub 1 0; Mul 0 7; Add 819 4; Add 820 1; Mul 804 834; Div 704 0; Mul 803 809; Mul 812 785;
  Sub 1 0; Mul 0 3; Mul 816 788; Mul 808 815; Sub 1 0; Mul 0 7; Add 831 4; Add 832 1; Mul 797 846;
  Div 716 0; Mul 796 802; Mul 822 778; Sub 1 0; Mul 0 3; Mul 826 781; Mul 801 808; Sub 1 0;
  Mul 0 7; Add 843 4; Add 844 1; Mul 790 858; Div 728 0; Mul 789 795; Mul 815 771; Sub 1 0;
  Mul 0 3; Mul 819 774; Mul 794 801; Sub 1 0; Mul 0 7; Add 855 4; Add 856 1; Mul 783 870;
  Div 740 0; Mul 782 788; Mul 808 766; Sub 1 0; Mul 0 3; Mul 812 769; Mul 787 794; Sub 1 0;
  Mul 0 7; Add 867 4; Add 868 1; Mul 778 882; Div 752 0; Mul 777 783; Mul 801 761; Sub 1 0;
  Mul 0 3; Mul 805 764; Mul 782 789; Sub 1 0; Mul 0 7; Add 879 4; Add 880 1; Mul 773 894;
  Div 764 0; Mul 772 778; Mul 796 767; Sub 1 0; Mul 0 3; Mul 800 770; Mul 777 784; Sub 1 0;
  Mul 0 7; Add 891 4; Add 892 1; Sub 61 73; Sub 61 73; Sub 51 75; Sub 51 75; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 900 0; Sub 45 81; Sub 45 81; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 39 87;
  Sub 39 87; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 33 93; Sub 33 93; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Sub 27 99; Sub 27 99; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 624 938; Sub 1 0;
  ShowZero 0; (* area of the circumcentres *)
  Div 809 629; Mul 207 0; Mul 0 628; Mul 0 943; Sub 0 194;
  ShowZero 0 (* 2H *)
].

Theorem part_2_size_7_valid : valid part_2_size_7.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a star given by its circumcentres; size 8.
    Code: src/pair/area.rs, src/pair/cotangent.rs, src/pair/forms.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/pair/weight.rs, src/scalar/ring.rs, src/space/circle.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_8 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Neg 14; Neg 14; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 8; Unknown 9; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 10; Unknown 11; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 12; Unknown 13; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Unknown 14; Unknown 15; Neg 10; Neg 10; Add 3 1; Add 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 8; Neg 8; Add 57 1; Add 57 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 62; Neg 62; Add 62 1; Add 62 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Neg 67; Neg 67; Add 73 1; Add 73 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* consecutive circumcentres differ *)
  Constant 2; Mul 79 65; Mul 79 67; Sub 1 0; Mul 3 0; Div 0 62; Neg 0; Mul 72 62; Mul 72 64;
  Sub 1 0; Mul 9 0; Div 0 59; Neg 0; Constant 0; Sub 79 92; Sub 79 92; Neg 0; Mul 0 10; Mul 3 11;
  Sub 75 84; Sub 75 84; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0;
  Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 6 6; Mul 6 6; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 90 80; Mul 90 82; Sub 1 0; Mul 36 0; Div 0 77; Neg 0; Sub 87 96; Sub 87 96; Neg 0; Mul 0 3;
  Mul 3 4; Sub 1 31; Sub 1 32; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 100 90; Mul 100 92; Sub 1 0; Mul 55 0; Div 0 87; Neg 0; Sub 97 106; Sub 97 106; Neg 0;
  Mul 0 3; Mul 3 4; Sub 1 50; Sub 1 51; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 110 100; Mul 110 102; Sub 1 0; Mul 74 0; Div 0 97; Neg 0; Sub 107 116; Sub 107 116; Neg 0;
  Mul 0 3; Mul 3 4; Sub 1 69; Sub 1 70; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 120 166; Mul 120 168; Sub 1 0; Mul 93 0; Div 0 109; Neg 0; Sub 173 126; Sub 173 126; Neg 0;
  Mul 0 3; Mul 3 4; Sub 1 88; Sub 1 89; Mul 20 0; Mul 20 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 23 23; Mul 23 23; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 186 183; Mul 186 185; Sub 1 0; Mul 112 0; Div 0 121; Neg 0; Neg 187; Mul 0 1; Mul 190 2;
  Sub 1 105; Sub 1 106; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 201 204; Mul 201 206; Sub 1 0; Mul 129 0; Div 0 131; Neg 0; Neg 202; Mul 0 1; Mul 205 2;
  Sub 1 122; Sub 1 123; Mul 18 0; Mul 18 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 21 21; Mul 21 21; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Mul 7 118; Mul 7 120; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 10 10; Mul 10 10; Add 1 0;
  Nonzero 0; (* no edge of the star has length 0 *)
  Constant 1; Mul 137 137; Add 0 0; Mul 2 0; Div 3 153; Mul 1 0; Add 3 142; Add 1 0; Mul 140 140;
  Mul 140 140; Add 1 0; Mul 10 0; Mul 0 7; Mul 149 145; Mul 150 145; Add 1 0; Add 0 152; Add 4 0;
  Mul 145 145; Mul 145 145; Add 1 0; Mul 20 0; Mul 0 17; Mul 159 150; Mul 160 150; Add 1 0;
  Add 0 162; Add 4 0; Mul 134 134; Mul 134 134; Add 1 0; Mul 30 0; Mul 0 27; Mul 169 139;
  Mul 170 139; Add 1 0; Add 0 172; Add 4 0; Mul 125 125; Mul 125 125; Add 1 0; Mul 40 0; Mul 0 37;
  Mul 179 130; Mul 180 130; Add 1 0; Add 0 182; Add 4 0; Mul 116 116; Mul 116 116; Add 1 0;
  Mul 50 0; Mul 0 47; Mul 189 121; Mul 190 121; Add 1 0; Add 0 192; Add 4 0; Mul 107 107;
  Mul 107 107; Add 1 0; Mul 60 0; Mul 0 57; Mul 199 112; Mul 200 112; Add 1 0; Add 0 202; Add 4 0;
  Mul 100 100; Mul 100 100; Add 1 0; Mul 70 0; Mul 0 67; Mul 209 105; Mul 210 105; Add 1 0;
  Add 0 212; Add 4 0; Mul 93 93; Mul 93 93; Add 1 0; Mul 80 0; Mul 0 77; Mul 219 98; Mul 220 98;
  Add 1 0; Add 0 222; Add 4 0; Sub 0 80; Sub 71 81; Div 89 93; Mul 2 215; Mul 104 2; Sub 1 0;
  Mul 0 3; Mul 108 5; Mul 7 221; Sub 1 0; Mul 0 7; Sub 71 91; Div 99 219; Mul 11 223; Mul 226 2;
  Sub 1 0; Mul 0 3; Mul 230 5; Mul 16 229; Sub 1 0; Mul 0 7; Sub 71 101; Div 109 210; Mul 11 214;
  Mul 234 2; Sub 1 0; Mul 0 3; Mul 238 5; Mul 16 220; Sub 1 0; Mul 0 7; Sub 71 111; Div 119 201;
  Mul 11 205; Mul 225 2; Sub 1 0; Mul 0 3; Mul 229 5; Mul 16 211; Sub 1 0; Mul 0 7; Sub 71 121;
  Div 129 192; Mul 11 196; Mul 216 2; Sub 1 0; Mul 0 3; Mul 220 5; Mul 16 202; Sub 1 0; Mul 0 7;
  Sub 71 131; Div 139 183; Mul 11 187; Mul 207 2; Sub 1 0; Mul 0 3; Mul 211 5; Mul 16 193;
  Sub 1 0; Mul 0 7; Sub 71 141; Div 149 176; Mul 11 180; Mul 198 2; Sub 1 0; Mul 0 3; Mul 202 5;
  Mul 16 186; Sub 1 0; Mul 0 7; Div 158 168; Mul 10 172; Mul 190 72; Sub 1 0; Mul 0 3; Mul 194 75;
  Mul 15 178; Sub 1 0; Mul 0 7; Sub 63 73; Sub 60 70; Sub 55 75; Sub 52 72; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 311 0; Sub 51 81; Sub 48 78; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 47 87;
  Sub 44 84; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 43 93; Sub 40 90; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Sub 39 99; Sub 36 96; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 36 105; Sub 33 102;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 355; Constant 4; Div 207 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 346 346;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 343 343;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 343 343;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 340 340;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 340 340;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 321 321;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 321 321;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 304 304;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 304 304;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 287 287;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 287 287;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 270 270;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 270 270;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 255 255;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 255 255;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 240 240;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 240 240;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  ShowZero 16; (* the lift *)
  Sub 219 363;
  ShowZero 0; (* the lift *)
  ShowZero 16; (* the lift *)
  ShowZero 15; (* the lift *)
  Mul 456 360; Mul 456 360; Add 1 0; Sub 213 0;
  ShowZero 0; (* the lift *)
  ShowZero 18; (* the lift *)
  ShowZero 17; (* the lift *)
  Mul 447 359; Mul 447 359; Add 1 0; Sub 207 0;
  ShowZero 0; (* the lift *)
  ShowZero 20; (* the lift *)
  ShowZero 19; (* the lift *)
  Mul 442 342; Mul 442 342; Add 1 0; Sub 201 0;
  ShowZero 0; (* the lift *)
  ShowZero 22; (* the lift *)
  ShowZero 21; (* the lift *)
  Mul 437 327; Mul 437 327; Add 1 0; Sub 195 0;
  ShowZero 0; (* the lift *)
  ShowZero 24; (* the lift *)
  ShowZero 23; (* the lift *)
  Mul 432 312; Mul 432 312; Add 1 0; Sub 189 0;
  ShowZero 0; (* the lift *)
  ShowZero 26; (* the lift *)
  ShowZero 25; (* the lift *)
  Mul 427 297; Mul 427 297; Add 1 0; Sub 183 0;
  ShowZero 0; (* the lift *)
  ShowZero 28; (* the lift *)
  ShowZero 27; (* the lift *)
  Mul 478 284; Mul 478 284; Add 1 0; Sub 177 0;
  ShowZero 0; (* the lift *)
  ShowZero 30; (* the lift *)
  ShowZero 29; (* the lift *)
  Mul 480 271; Mul 480 271; Add 1 0; Sub 171 0;
  ShowZero 0; (* the lift *)
  Div 259 260; Sub 166 97; Sub 163 94; Mul 276 0; Mul 276 2; Sub 1 0; Mul 0 5; Sub 403 399;
  Sub 404 399; Sub 284 401; Sub 284 401; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 293 310; Sub 293 310; Sub 416 312; Sub 417 312; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3;
  Mul 6 5; Sub 1 0; Div 3 0; Add 11 0; Mul 0 285; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 291 408; Mul 418 123; Mul 418 125; Sub 1 0; Mul 0 3; Sub 433 424; Sub 434 424; Sub 431 426;
  Sub 431 426; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0; Div 3 0; Sub 440 323;
  Sub 440 323; Sub 446 325; Sub 447 325; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Add 11 0; Mul 0 315; Sub 24 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 321 419; Sub 208 218; Sub 205 215; Mul 448 0; Mul 448 2; Sub 1 0; Mul 0 5; Sub 465 435;
  Sub 466 435; Sub 458 437; Sub 458 437; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 467 472; Sub 467 472; Mul 1 74; Mul 1 74; Add 1 0; Mul 4 76; Mul 4 78; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 345; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 351 430; Sub 228 238; Sub 225 235; Mul 459 0; Mul 459 2; Sub 1 0; Mul 0 5; Sub 495 446;
  Sub 496 446; Sub 467 448; Sub 467 448; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 476 497; Sub 476 497; Mul 1 74; Mul 1 74; Add 1 0; Mul 4 76; Mul 4 78; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 375; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 381 441; Sub 248 258; Sub 245 255; Mul 470 0; Mul 470 2; Sub 1 0; Mul 0 5; Sub 525 457;
  Sub 526 457; Sub 478 459; Sub 478 459; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 487 506; Sub 487 506; Mul 1 72; Mul 1 72; Add 1 0; Mul 4 74; Mul 4 76; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 405; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 411 452; Sub 268 278; Sub 265 275; Mul 481 0; Mul 481 2; Sub 1 0; Mul 0 5; Sub 555 468;
  Sub 556 468; Sub 489 470; Sub 489 470; Mul 3 1; Mul 3 1; Add 1 0; Mul 6 3; Mul 6 5; Sub 1 0;
  Div 3 0; Sub 498 517; Sub 498 517; Mul 1 72; Mul 1 72; Add 1 0; Mul 4 74; Mul 4 76; Sub 1 0;
  Div 3 0; Add 9 0; Mul 0 435; Sub 22 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 441 465; Sub 288 298; Sub 285 295; Mul 492 0; Mul 492 2; Sub 1 0; Mul 0 5; Sub 498 481;
  Sub 498 481; Mul 170 1; Mul 170 1; Add 1 0; Mul 173 3; Mul 173 5; Sub 1 0; Div 3 0; Sub 507 526;
  Sub 507 526; Mul 1 70; Mul 1 70; Add 1 0; Mul 4 72; Mul 4 74; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 463; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Div 469 476; Sub 307 316; Sub 304 313; Mul 503 0; Mul 503 2; Sub 1 0; Mul 0 5; Sub 509 492;
  Sub 509 492; Mul 168 1; Mul 168 1; Add 1 0; Mul 171 3; Mul 171 5; Sub 1 0; Div 3 0; Sub 518 535;
  Sub 518 535; Mul 1 68; Mul 1 68; Add 1 0; Mul 4 70; Mul 4 72; Sub 1 0; Div 3 0; Add 9 0;
  Mul 0 491; Sub 20 0;
  ShowZero 0; (* ½ (cot α + cot β) *)
  Unknown 16; Unknown 17; Unknown 18; Unknown 19; Unknown 20; Unknown 21; Mul 639 5; Mul 639 6;
  Add 642 1; Add 643 1; Mul 638 8; Mul 638 9; Add 3 1; Add 3 1; Mul 621 11; Mul 621 12; Add 3 1;
  Add 3 1; Mul 606 14; Mul 606 15; Add 3 1; Add 3 1; Mul 591 17; Mul 591 18; Add 3 1; Add 3 1;
  Mul 576 20; Mul 576 21; Add 3 1; Add 3 1; Sub 664 1; Sub 665 1; Mul 1 749; Mul 1 751; Sub 1 0;
  Div 0 749; Mul 756 0; Mul 756 1; Add 9 1; Add 9 1; Mul 31 665; Mul 31 665; Add 1 0; Mul 30 647;
  Mul 30 647; Add 1 0; Mul 29 631; Mul 29 631; Add 1 0; Mul 28 615; Mul 28 615; Add 1 0;
  Mul 27 599; Mul 27 599; Add 1 0; Mul 26 585; Mul 26 585; Add 1 0; Mul 19 571; Mul 19 571;
  Add 1 0; Sub 0 695; Sub 544 696; Mul 1 685; Mul 574 1; Sub 1 0; Mul 0 473; Mul 578 4; Mul 6 691;
  Sub 1 0; Mul 0 477; Sub 28 705; Mul 9 692; Mul 695 1; Sub 1 0; Mul 0 472; Mul 699 4; Mul 14 698;
  Sub 1 0; Mul 0 476; Sub 34 714; Mul 9 682; Mul 702 1; Sub 1 0; Mul 0 471; Mul 706 4; Mul 14 688;
  Sub 1 0; Mul 0 475; Sub 40 723; Mul 9 672; Mul 692 1; Sub 1 0; Mul 0 470; Mul 696 4; Mul 14 678;
  Sub 1 0; Mul 0 474; Sub 46 732; Mul 9 662; Mul 682 1; Sub 1 0; Mul 0 469; Mul 686 4; Mul 14 668;
  Sub 1 0; Mul 0 473; Sub 52 741; Mul 9 652; Mul 672 1; Sub 1 0; Mul 0 468; Mul 676 4; Mul 14 658;
  Sub 1 0; Mul 0 472; Sub 58 750; Mul 9 644; Mul 662 1; Sub 1 0; Mul 0 467; Mul 666 4; Mul 14 650;
  Sub 1 0; Mul 0 471; Mul 8 635; Mul 653 64; Sub 1 0; Mul 0 466; Mul 657 67; Mul 13 641; Sub 1 0;
  Mul 0 470; Sub 57 66; Sub 54 63; Sub 50 68; Sub 47 65; Mul 3 463; Mul 3 465; Sub 1 0; Mul 469 3;
  Mul 469 5; Sub 1 0; Add 3 0; Add 778 0; Sub 51 78; Sub 48 75; Mul 11 467; Mul 11 469; Sub 1 0;
  Mul 477 3; Mul 477 5; Sub 1 0; Add 3 0; Add 9 0; Sub 52 88; Sub 49 85; Mul 11 471; Mul 11 473;
  Sub 1 0; Mul 481 3; Mul 481 5; Sub 1 0; Add 3 0; Add 9 0; Sub 53 98; Sub 50 95; Mul 11 475;
  Mul 11 477; Sub 1 0; Mul 485 3; Mul 485 5; Sub 1 0; Add 3 0; Add 9 0; Sub 54 108; Sub 51 105;
  Mul 11 479; Mul 11 481; Sub 1 0; Mul 489 3; Mul 489 5; Sub 1 0; Add 3 0; Add 9 0; Sub 56 118;
  Sub 53 115; Mul 11 483; Mul 11 485; Sub 1 0; Mul 493 3; Mul 493 5; Sub 1 0; Add 3 0; Add 9 0;
  Mul 0 484; Mul 0 843; Mul 404 135; Add 832 0; Mul 376 136; Add 1 0; Mul 348 129; Add 1 0;
  Mul 320 122; Add 1 0; Mul 292 115; Add 1 0; Mul 264 108; Add 1 0; Mul 238 101; Add 1 0;
  Mul 212 94; Add 1 0; Sub 0 16;
  ShowZero 0; (* cotangent Laplacian *)
  Mul 445 152; Add 849 0; Mul 417 153; Add 1 0; Mul 387 146; Add 1 0; Mul 359 139; Add 1 0;
  Mul 331 132; Add 1 0; Mul 303 125; Add 1 0; Mul 275 118; Add 1 0; Mul 249 111; Add 1 0;
  Sub 0 33;
  ShowZero 0; (* Laplacian *)
  Sub 164 102; Sub 161 99; Mul 744 0; Mul 744 2; Sub 1 0; Mul 0 473; Mul 860 102; Mul 860 104;
  Sub 1 0; Mul 0 445; Sub 156 165; Sub 153 162; Mul 864 0; Mul 864 2; Sub 1 0; Mul 0 421;
  Sub 153 162; Sub 150 159; Mul 851 0; Mul 851 2; Sub 1 0; Mul 0 397; Sub 150 159; Sub 147 156;
  Mul 838 0; Mul 838 2; Sub 1 0; Mul 0 373; Sub 147 156; Sub 144 153; Mul 825 0; Mul 825 2;
  Sub 1 0; Mul 0 349; Sub 144 153; Sub 141 150; Mul 812 0; Mul 812 2; Sub 1 0; Mul 0 325;
  Sub 142 150; Sub 139 147; Mul 801 0; Mul 801 2; Sub 1 0; Mul 0 303; Mul 40 775; Add 912 0;
  Mul 38 893; Add 1 0; Mul 34 876; Add 1 0; Mul 30 859; Add 1 0; Mul 26 842; Add 1 0; Mul 22 825;
  Add 1 0; Mul 18 810; Add 1 0; Mul 14 795; Add 1 0; Mul 96 940; Sub 1 0;
  ShowZero 0; (* hinges *)
  Mul 796 942; Div 793 0; Mul 795 919; Mul 808 912; Sub 1 0; Mul 0 3; Mul 812 915; Mul 800 925;
  Sub 1 0; Mul 0 7; Add 939 4; Add 940 1; Mul 924 954; Div 805 0; Mul 923 929; Mul 932 905;
  Sub 1 0; Mul 0 3; Mul 936 908; Mul 928 935; Sub 1 0; Mul 0 7; Add 951 4; Add 952 1; Mul 917 966;
  Div 817 0; Mul 916 922; Mul 942 898; Sub 1 0; Mul 0 3; Mul 946 901; Mul 921 928; Sub 1 0;
  Mul 0 7; Add 963 4; Add 964 1; Mul 910 978; Div 829 0; Mul 909 915; Mul 935 891; Sub 1 0;
  Mul 0 3; Mul 939 894; Mul 914 921; Sub 1 0; Mul 0 7; Add 975 4; Add 976 1; Mul 903 990;
  Div 841 0; Mul 902 908; Mul 928 884; Sub 1 0; Mul 0 3; Mul 932 887; Mul 907 914; Sub 1 0;
  Mul 0 7; Add 987 4; Add 988 1; Mul 896 1002; Div 853 0; Mul 895 901; Mul 921 879; Sub 1 0;
  Mul 0 3; Mul 925 882; Mul 900 907; Sub 1 0; Mul 0 7; Add 999 4; Add 1000 1; Mul 891 1014;
  Div 865 0; Mul 890 896; Mul 914 874; Sub 1 0; Mul 0 3; Mul 918 877; Mul 895 902; Sub 1 0;
  Mul 0 7; Add 1011 4; Add 1012 1; Mul 886 1026; Div 877 0; Mul 885 891; Mul 909 880; Sub 1 0;
  Mul 0 3; Mul 913 883; Mul 890 897; Sub 1 0; Mul 0 7; Add 1023 4; Add 1024 1; Sub 73 85;
  Sub 73 85; Sub 63 87; Sub 63 87; Mul 3 0; Mul 3 2; Sub 1 0; Add 1032 0; Sub 57 93; Sub 57 93;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 51 99; Sub 51 99; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 45 105; Sub 45 105; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 39 111; Sub 39 111; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 33 117; Sub 33 117; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Mul 717 1076; Sub 1 0;
  ShowZero 0; (* area of the circumcentres *)
  Div 928 722; Mul 237 0; Mul 0 721; Mul 0 1081; Sub 0 222;
  ShowZero 0 (* 2H *)
].

Theorem part_2_size_8_valid : valid part_2_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
