(** r-normals-coplanar (Sec. 3.1, relative Gauss mapping)

    The relative normals at the ends of an edge lie in a plane, with the edges of all offsets.

        det(m_j − m_i, s_i, s_j) = 0

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** inner edges of f-parallel meshes; size 1.
    Code: src/pair/offset.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
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
  Unknown 20; Mul 76 72; Mul 76 72; Add 1 0; Sub 3 0; Mul 80 68; Mul 80 68; Add 1 0; Add 0 3;
  Mul 84 70; Mul 84 70; Add 1 0; Add 0 7; Sub 4 0; Sub 13 1; Constant 1; Div 0 69; Mul 3 73;
  Mul 76 3; Sub 1 0; Mul 0 3; Mul 80 6; Mul 8 79; Sub 1 0; Mul 0 7; Mul 4 86; Mul 1 86; Add 1 0;
  Sub 15 0; Add 1 0; Sub 17 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 94; Mul 7 94; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 107; Mul 12 107; Add 1 0; Add 0 10; Sub 39 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 116 83; Mul 116 83; Add 1 0; Add 0 39; Mul 24 87; Mul 21 87; Add 1 0; Add 0 19; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Unknown 21; Unknown 22; Unknown 23; Mul 128 2; Mul 128 2; Add 1 0; Sub 3 0; Unknown 24;
  Mul 125 0; Mul 128 1; Add 9 1; Add 9 1; Mul 137 1; Mul 137 1; Add 1 0; Add 0 8; Unknown 25;
  Unknown 26; Mul 143 1; Mul 143 1; Add 1 0; Add 0 14; Mul 51 5; Mul 48 5; Add 1 0; Sub 3 0;
  Mul 55 15; Mul 52 15; Add 1 0; Add 0 3; Sub 14 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 60 30; Mul 57 30; Add 1 0; Add 0 8; Sub 32 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Unknown 27; Mul 133 0; Mul 136 1; Add 38 1; Add 38 1; Mul 166 1; Mul 166 1; Add 1 0; Add 0 37;
  Mul 74 5; Mul 71 5; Add 1 0; Add 0 22; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 152 171; Mul 152 171; Add 1 0; Sub 102 0; Mul 156 138; Mul 156 138; Add 1 0; Add 0 3;
  Sub 107 63; Sub 1 64; Div 94 136; Mul 2 140; Mul 143 2; Sub 1 0; Mul 0 3; Mul 147 5; Mul 7 146;
  Sub 1 0; Mul 0 7; Mul 4 161; Mul 1 161; Add 1 0; Sub 77 0; Add 1 0; Sub 79 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 196; Mul 7 196; Add 1 0; Add 0 5; Sub 128 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 164; Mul 12 164; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Unknown 28; Unknown 29; Mul 189 1; Mul 189 1; Add 1 0; Add 0 36; Mul 26 5; Mul 23 5; Add 1 0;
  Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 31 56; Mul 28 56; Add 1 0; Sub 54 0; Mul 35 99; Mul 32 99; Add 1 0; Add 0 3; Sub 101 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 207 104; Mul 207 104; Add 1 0; Sub 105 0; Unknown 30; Mul 198 0; Mul 201 1; Add 111 1;
  Add 111 1; Mul 216 1; Mul 216 1; Add 1 0; Add 0 8; Mul 53 5; Mul 50 5; Add 1 0; Add 0 21;
  Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Unknown 31; Unknown 32; Mul 227 1; Mul 227 1; Add 1 0; Add 0 19; Mul 64 5; Mul 61 5; Add 1 0;
  Add 0 32; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 257 255; Mul 257 255; Add 1 0; Sub 186 0; Mul 261 207; Mul 261 207; Add 1 0; Add 0 3;
  Mul 265 209; Mul 265 209; Add 1 0; Add 0 7; Sub 0 187; Sub 5 188; Div 182 207; Mul 2 211;
  Mul 214 2; Sub 1 0; Mul 0 3; Mul 218 5; Mul 7 217; Sub 1 0; Mul 0 7; Mul 4 270; Mul 1 270;
  Add 1 0; Sub 201 0; Add 1 0; Sub 203 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 230; Mul 7 230; Add 1 0; Add 0 5; Sub 21 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 237; Mul 12 237; Add 1 0; Add 0 10; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 294; Mul 17 294; Add 1 0; Add 0 15; Sub 226 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 301 177; Mul 301 177; Add 1 0; Sub 178 0; Unknown 33; Unknown 34; Mul 307 1; Mul 307 1;
  Add 1 0; Add 0 5; Mul 35 177; Mul 32 177; Add 1 0; Sub 175 0; Mul 39 9; Mul 36 9; Add 1 0;
  Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Unknown 35; Mul 271 0; Mul 274 1; Add 199 1; Add 199 1; Mul 325 1; Mul 325 1; Add 1 0; Add 0 23;
  Mul 53 5; Mul 50 5; Add 1 0; Add 0 17; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 58 210; Mul 55 210; Add 1 0; Add 0 22; Sub 212 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 316 337; Mul 316 337; Add 1 0; Sub 268 0; Mul 320 278; Mul 320 278; Add 1 0; Add 0 3;
  Sub 82 273; Sub 1 274; Div 260 276; Mul 2 280; Mul 283 2; Sub 1 0; Mul 0 3; Mul 287 5;
  Mul 7 286; Sub 1 0; Mul 0 7; Mul 4 356; Mul 1 356; Add 1 0; Sub 287 0; Add 1 0; Sub 289 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 310; Mul 7 310; Add 1 0; Add 0 5; Sub 103 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 304; Mul 12 304; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 335; Mul 17 335; Add 1 0; Add 0 15; Sub 197 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 255; Mul 22 255; Add 1 0; Sub 256 0; Mul 29 59; Mul 26 59; Add 1 0; Add 0 3; Sub 58 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 365 264; Mul 365 264; Add 1 0; Sub 265 0; Unknown 36; Unknown 37; Mul 371 1; Mul 371 1;
  Add 1 0; Add 0 5; Mul 44 5; Mul 41 5; Add 1 0; Add 0 18; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 49 167; Mul 46 167; Add 1 0; Add 0 23; Sub 166 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 377 406; Sub 377 406; Sub 292 336; Mul 286 243; Mul 286 248; Sub 1 0; Mul 288 251;
  Mul 291 247; Sub 1 0; Mul 293 253; Mul 293 255; Sub 1 0; Mul 11 6; Mul 11 4; Add 1 0; Mul 12 3;
  Add 1 0;
  ShowZero 0; (* coplanar normals *)
  Unknown 38; Mul 0 263; Add 396 0; Mul 2 264; Add 397 0; Mul 4 262; Add 313 0; Mul 6 308;
  Add 431 0; Mul 8 309; Add 432 0; Mul 10 310; Add 363 0; Sub 4 436; Sub 3 436; Sub 2 366;
  Sub 13 439; Sub 12 439; Sub 11 369; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0;
  Mul 11 7; Mul 11 9; Sub 1 0; Mul 44 6; Mul 44 4; Add 1 0; Mul 45 3; Add 1 0;
  ShowZero 0; (* an edge and its offset *)
  Sub 448 456; Sub 448 456; Sub 378 386; Mul 336 322; Mul 336 327; Sub 1 0; Mul 338 330;
  Mul 341 326; Sub 1 0; Mul 343 332; Mul 343 334; Sub 1 0; Mul 11 6; Mul 11 4; Add 1 0; Mul 12 3;
  Add 1 0;
  ShowZero 0; (* coplanar normals *)
  Mul 49 341; Add 466 0; Mul 51 342; Add 467 0; Mul 53 340; Add 398 0; Sub 4 479; Sub 3 479;
  Sub 2 409; Mul 44 0; Mul 44 2; Sub 1 0; Mul 46 5; Mul 49 4; Sub 1 0; Mul 51 7; Mul 51 9;
  Sub 1 0; Mul 34 6; Mul 34 4; Add 1 0; Mul 35 3; Add 1 0;
  ShowZero 0; (* an edge and its offset *)
  Sub 459 496; Sub 459 496; Sub 319 426; Mul 376 260; Mul 376 265; Sub 1 0; Mul 378 268;
  Mul 381 264; Sub 1 0; Mul 383 270; Mul 383 272; Sub 1 0; Mul 11 6; Mul 11 4; Add 1 0; Mul 12 3;
  Add 1 0;
  ShowZero 0; (* coplanar normals *)
  Mul 89 279; Add 477 0; Mul 91 280; Add 478 0; Mul 93 278; Add 339 0; Sub 4 519; Sub 3 519;
  Sub 2 449; Mul 84 0; Mul 84 2; Sub 1 0; Mul 86 5; Mul 89 4; Sub 1 0; Mul 91 7; Mul 91 9;
  Sub 1 0; Mul 34 6; Mul 34 4; Add 1 0; Mul 35 3; Add 1 0;
  ShowZero 0; (* an edge and its offset *)
  Mul 413 209; Mul 413 214; Sub 1 0; Mul 415 217; Mul 418 213; Sub 1 0; Mul 420 219; Mul 420 221;
  Sub 1 0; Mul 480 6; Mul 480 4; Add 1 0; Mul 202 3; Add 1 0;
  ShowZero 0; (* coplanar normals *)
  Mul 126 228; Add 499 0; Mul 128 229; Add 500 0; Mul 130 227; Add 292 0; Sub 4 556; Sub 3 556;
  Sub 2 486; Mul 121 0; Mul 121 2; Sub 1 0; Mul 123 5; Mul 126 4; Sub 1 0; Mul 128 7; Mul 128 9;
  Sub 1 0; Mul 503 6; Mul 503 4; Add 1 0; Mul 225 3; Add 1 0;
  ShowZero 0 (* an edge and its offset *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
