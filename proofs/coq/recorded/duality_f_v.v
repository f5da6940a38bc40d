(** duality-f-v (Sec. 3.1, mesh parallelism in isotropic space)

    Metric duality maps f-parallel pairs to v-parallel pairs with the dual combinatorics. The dual
    of an inscribed mesh is circumscribed, that of a circumscribed one inscribed, that of a
    midscribed one midscribed.

        ∇M_i = ∇S_i ⇔ (m_i* )' = (s_i* )'

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** an inner vertex with its faces; size 1.
    Code: src/pair/v_parallel.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 5 3; Sub 5 3; Neg 0;
  Unknown 6; Mul 1 0; Mul 4 1; Add 7 1; Add 7 1; Unknown 7; Unknown 8; Sub 3 1; Sub 3 1; Sub 13 3;
  Sub 13 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Unknown 9; Unknown 10; Unknown 11; Unknown 12; Sub 26 3; Sub 26 3; Neg 0; Unknown 13; Mul 1 0;
  Mul 4 1; Add 28 1; Add 28 1; Sub 11 9; Sub 11 9; Neg 0; Unknown 14; Mul 1 0; Mul 4 1; Add 36 1;
  Add 36 1; Sub 38 9; Sub 38 9; Sub 3 11; Sub 3 11; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Sub 47 24; Sub 47 24; Neg 0; Unknown 15; Mul 1 0; Mul 4 1; Add 51 1; Add 51 1; Unknown 16;
  Unknown 17; Sub 1 47; Sub 1 47; Sub 5 49; Sub 5 49; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Unknown 18; Unknown 19; Sub 12 64; Sub 12 64; Sub 3 66; Sub 3 66; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Unknown 20; Unknown 21; Unknown 22; Mul 70 0; Mul 73 1; Add 4 1; Add 4 1; Unknown 23;
  Unknown 24; Sub 3 1; Sub 3 1; Sub 10 3; Sub 10 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Unknown 25; Mul 63 0; Mul 66 1; Add 18 1; Add 18 1; Unknown 26; Mul 60 0; Mul 63 1; Add 23 1;
  Add 23 1; Sub 25 6; Sub 25 6; Sub 3 8; Sub 3 8; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Unknown 27; Mul 57 0; Mul 60 1; Add 35 1; Add 35 1; Unknown 28; Unknown 29; Sub 1 34; Sub 1 34;
  Sub 5 36; Sub 5 36; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Unknown 30; Unknown 31; Sub 12 48; Sub 12 48; Sub 3 50; Sub 3 50; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Unknown 32; Mul 132 128; Mul 132 128; Add 1 0; Sub 3 0; Mul 134 132; Mul 134 132; Add 1 0;
  Sub 7 0; Mul 115 136; Mul 115 136; Add 1 0; Sub 11 0; Mul 144 132; Mul 144 132; Add 1 0;
  Add 0 11; Mul 146 92; Mul 146 92; Add 1 0; Add 0 11; Mul 152 138; Mul 152 138; Add 1 0;
  Add 0 19; Mul 154 98; Mul 154 98; Add 1 0; Add 0 19; Mul 135 93; Mul 135 93; Add 1 0; Add 0 19;
  Sub 16 8; Sub 33 9; Constant 1; Div 0 145; Mul 3 149; Mul 152 3; Sub 1 0; Mul 0 3; Mul 156 6;
  Mul 8 155; Sub 1 0; Mul 0 7; Sub 16 28; Sub 25 29; Div 11 112; Mul 2 116; Mul 119 2; Sub 1 0;
  Mul 0 3; Mul 123 5; Mul 7 122; Sub 1 0; Mul 0 7; Sub 35 55; Sub 24 56; Div 22 114; Mul 2 118;
  Mul 121 2; Sub 1 0; Mul 0 3; Mul 125 5; Mul 7 124; Sub 1 0; Mul 0 7; Sub 15 26; Sub 12 23;
  Sub 6 28; Sub 3 25; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the gradients at no vertex are collinear: no dual face is vertical *)
  Mul 33 191; Mul 30 191; Add 1 0; Sub 52 0; Add 1 0; Sub 54 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 39 199; Mul 36 199; Add 1 0; Add 0 5; Sub 67 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 44 212; Mul 41 212; Add 1 0; Add 0 10; Sub 88 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 221 188; Mul 221 188; Add 1 0; Add 0 88; Mul 53 192; Mul 50 192; Add 1 0; Add 0 19; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Unknown 33; Mul 231 155; Mul 231 155; Add 1 0; Sub 3 0; Mul 235 154; Mul 235 154; Add 1 0;
  Add 0 3; Mul 239 156; Mul 239 156; Add 1 0; Add 0 7; Mul 71 160; Mul 68 160; Add 1 0; Sub 3 0;
  Mul 75 166; Mul 72 166; Add 1 0; Add 0 3; Sub 12 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 80 176; Mul 77 176; Add 1 0; Add 0 8; Sub 25 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 257 162; Mul 257 162; Add 1 0; Add 0 25; Mul 89 166; Mul 86 166; Add 1 0; Add 0 17; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 243 262; Mul 243 262; Add 1 0; Sub 137 0; Mul 247 229; Mul 247 229; Add 1 0; Add 0 3;
  Sub 142 49; Sub 1 50; Div 109 227; Mul 2 231; Mul 234 2; Sub 1 0; Mul 0 3; Mul 238 5; Mul 7 237;
  Sub 1 0; Mul 0 7; Mul 4 252; Mul 1 252; Add 1 0; Sub 63 0; Add 1 0; Sub 65 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 287; Mul 7 287; Add 1 0; Add 0 5; Sub 163 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 255; Mul 12 255; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Unknown 34; Unknown 35; Mul 280 1; Mul 280 1; Add 1 0; Add 0 36; Mul 26 5; Mul 23 5; Add 1 0;
  Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 31 217; Mul 28 217; Add 1 0; Sub 54 0; Mul 35 240; Mul 32 240; Add 1 0; Add 0 3; Sub 89 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 298 245; Mul 298 245; Add 1 0; Sub 93 0; Mul 302 225; Mul 302 225; Add 1 0; Add 0 3;
  Mul 48 229; Mul 45 229; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Unknown 36; Unknown 37; Mul 313 1; Mul 313 1; Add 1 0; Add 0 14; Mul 59 5; Mul 56 5; Add 1 0;
  Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 162 333; Mul 159 333; Add 1 0; Sub 200 0; Add 1 0; Sub 202 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 168 293; Mul 165 293; Add 1 0; Add 0 5; Sub 195 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 173 300; Mul 170 300; Add 1 0; Add 0 10; Sub 208 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 178 357; Mul 175 357; Add 1 0; Add 0 15; Sub 233 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 364 290; Mul 364 290; Add 1 0; Sub 138 0; Mul 368 256; Mul 368 256; Add 1 0; Add 0 3;
  Mul 191 293; Mul 188 293; Add 1 0; Sub 138 0; Mul 195 264; Mul 192 264; Add 1 0; Add 0 3;
  Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 381 271; Mul 381 271; Add 1 0; Add 0 16; Mul 204 275; Mul 201 275; Add 1 0; Add 0 12;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 209 316; Mul 206 316; Add 1 0; Add 0 17; Sub 165 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 203 393; Mul 200 393; Add 1 0; Sub 268 0; Add 1 0; Sub 270 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 209 347; Mul 206 347; Add 1 0; Add 0 5; Sub 255 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 214 341; Mul 211 341; Add 1 0; Add 0 10; Sub 248 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 219 372; Mul 216 372; Add 1 0; Add 0 15; Sub 143 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 224 342; Mul 221 342; Add 1 0; Sub 190 0; Mul 228 310; Mul 225 310; Add 1 0; Add 0 3;
  Sub 39 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 402 351; Mul 402 351; Add 1 0; Sub 199 0; Mul 406 308; Mul 406 308; Add 1 0; Add 0 3;
  Mul 241 312; Mul 238 312; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 246 340; Mul 243 340; Add 1 0; Add 0 21; Sub 115 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 206 202; Sub 215 203; Div 280 356; Mul 2 360; Mul 363 2; Sub 1 0; Mul 0 3; Mul 367 5;
  Mul 7 366; Sub 1 0; Mul 0 7; Mul 4 373; Mul 1 373; Add 1 0; Sub 216 0; Add 1 0; Sub 218 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 381; Mul 7 381; Add 1 0; Add 0 5; Sub 227 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 391; Mul 12 391; Add 1 0; Add 0 10; Sub 240 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 377; Mul 17 377; Add 1 0; Add 0 15; Sub 215 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 246 216; Sub 149 217; Div 312 371; Mul 2 375; Mul 378 2; Sub 1 0; Mul 0 3; Mul 382 5;
  Mul 7 381; Sub 1 0; Mul 0 7; Mul 4 393; Mul 1 393; Add 1 0; Sub 230 0; Add 1 0; Sub 232 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 418; Mul 7 418; Add 1 0; Add 0 5; Sub 267 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 399; Mul 12 399; Add 1 0; Add 0 10; Sub 174 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 169; Mul 17 169; Add 1 0; Add 0 15; Sub 168 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 135 270; Sub 123 271; Div 344 389; Mul 2 393; Mul 396 2; Sub 1 0; Mul 0 3; Mul 400 5;
  Mul 7 399; Sub 1 0; Mul 0 7; Mul 4 439; Mul 1 439; Add 1 0; Sub 284 0; Add 1 0; Sub 286 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 412; Mul 7 412; Add 1 0; Add 0 5; Sub 156 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 419; Mul 12 419; Add 1 0; Add 0 10; Sub 148 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 460; Mul 17 460; Add 1 0; Add 0 15; Sub 309 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 154 310; Sub 107 311; Div 376 412; Mul 2 416; Mul 419 2; Sub 1 0; Mul 0 3; Mul 423 5;
  Mul 7 422; Sub 1 0; Mul 0 7; Mul 4 476; Mul 1 476; Add 1 0; Sub 324 0; Add 1 0; Sub 326 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 446; Mul 7 446; Add 1 0; Add 0 5; Sub 175 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 440; Mul 12 440; Add 1 0; Add 0 10; Sub 132 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 468; Mul 17 468; Add 1 0; Add 0 15; Sub 243 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 121 401;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 118 398;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 91 294;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 88 291;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 61 394;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 58 391;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 31 385;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 28 382;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Neg 372; Neg 233; Neg 182; Sub 1 2; Sub 1 3; Div 419 381; Mul 2 385; Mul 388 2; Sub 1 0;
  Mul 0 3; Mul 392 5; Mul 7 391; Sub 1 0; Mul 0 7; Mul 4 423; Mul 1 420; Add 1 0; Sub 16 0;
  Add 1 0; Sub 18 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 418; Mul 7 415; Add 1 0; Add 0 5; Sub 22 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 412; Mul 12 409; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 322; Mul 21 331; Mul 18 328; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 157; Neg 94; Neg 63; Sub 104 168; Sub 101 165; Sub 3 4; Sub 75 171; Sub 72 168; Sub 5 7;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 462 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 186; Mul 1 183; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 128; Mul 7 125; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 101; Mul 12 98; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Neg 162; Mul 21 171; Mul 18 168; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 488 208; Sub 485 205; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0; (* parallel points *)
  Sub 384 181; Sub 381 178; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0; (* parallel points *)
  Sub 487 154; Sub 484 151; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0; (* parallel points *)
  Sub 481 127; Sub 478 124; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0 (* parallel points *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** residuals at Σ; size 1.
    Code: src/net/scribed.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face is vertical *)
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Unknown 16; Mul 5 8; Mul 5 8; Add 1 0; Sub 9 0; Neg 0; Mul 8 13; Mul 8 13; Add 1 0; Sub 14 0;
  Neg 0; Mul 11 18; Mul 11 18; Add 1 0; Sub 19 0; Neg 0; Sub 18 20; Sub 18 20; Sub 18 22;
  Sub 18 22; Mul 3 0; Mul 3 2; Sub 1 0; Mul 0 0; Constant 1; Mul 30 0; Add 0 0; Mul 34 34;
  Mul 34 34; Add 1 0; Sub 3 0; Mul 0 7; Sub 21 26; Sub 17 27; Mul 16 0; Mul 2 15; Sub 1 0;
  Mul 4 18; Mul 21 4; Sub 1 0; Mul 3 44; Mul 1 44; Add 1 0; Mul 20 37; Add 1 0; Mul 0 22; Add 0 0;
  Mul 10 10; Mul 8 8; Add 1 0; Mul 0 25; Add 4 0; Add 0 20;
  ShowZero 0; (* vertex and dual face *)
  Unknown 17; Unknown 18; Unknown 19; Sub 1 2; Sub 1 3; Div 33 73; Mul 2 77; Mul 80 2; Sub 1 0;
  Mul 0 3; Mul 84 5; Mul 7 83; Sub 1 0; Mul 0 7; Mul 4 94; Mul 1 94; Add 1 0; Sub 16 0; Neg 0;
  Mul 0 47; Add 0 0; Mul 11 11; Mul 8 8; Add 1 0; Sub 3 0; Mul 93 93; Mul 1 0; Sub 19 20;
  Sub 16 17; Mul 1 109; Mul 1 109; Add 1 0; Mul 100 31; Add 1 0; Mul 0 102; Add 0 0; Mul 8 8;
  Mul 8 8; Add 1 0; Mul 0 67; Add 4 0; Add 0 14;
  ShowZero 0; (* face and dual vertex *)
  Unknown 20; Sub 0 42; Div 72 105; Mul 41 109; Mul 119 2; Sub 1 0; Mul 0 3; Mul 123 5;
  Mul 46 115; Sub 1 0; Mul 0 7; Mul 4 133; Mul 1 133; Add 1 0; Sub 55 0; Neg 0; Sub 9 48;
  Sub 6 45; Sub 2 41; Mul 51 2; Mul 48 2; Add 1 0; Mul 3 92; Sub 1 0; Sub 42 46; Sub 0 47;
  Mul 2 2; Mul 10 10; Mul 10 10; Add 1 0; Mul 0 4; Sub 4 0; Sub 154 152; Sub 154 152; Mul 1 1;
  Mul 1 1; Add 1 0; Mul 5 0; Mul 160 154; Mul 160 154; Add 1 0; Mul 79 111; Sub 1 0; Mul 84 113;
  Mul 166 166; Mul 166 166; Add 1 0; Sub 0 3; Sub 0 4; Mul 6 6; Mul 166 166; Mul 166 166; Add 1 0;
  Mul 0 4; Sub 4 0; Sub 87 48; Sub 84 45; Mul 1 1; Mul 1 1; Add 1 0; Mul 5 0; Add 23 0;
  ShowZero 0 (* edge and dual edge *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
