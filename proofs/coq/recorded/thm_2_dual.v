(** thm-2-dual (Sec. 3.2, Theorem 2)

    The metric dual of an i-conical mesh is i-circular and that of an i-circular mesh i-conical:
    the gradients of the faces around an element of M are the top views of the corners of its dual,
    and conversely. The dual of the dual is the mesh.

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a pyramid, twice; size 1.
    Code: src/scalar/ring.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* around every vertex are three gradients that are not collinear *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* around every vertex are three gradients that are not collinear *)
  Sub 15 17; Sub 15 17; Sub 8 19; Sub 8 19; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* around every vertex are three gradients that are not collinear *)
  Sub 26 22; Sub 26 22; Sub 15 24; Sub 15 24; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* around every vertex are three gradients that are not collinear *)
  Unknown 8;
  Nonzero 0; (* the apex is not in the base *)
  Constant 0; Sub 22 0; Sub 22 1; Sub 37 2; Sub 37 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the base meets the edges of the apex *)
  Sub 40 7; Sub 40 8; Mul 6 0; Mul 6 2; Sub 1 0;
  Nonzero 0; (* the base meets the edges of the apex *)
  Sub 43 12; Sub 43 13; Mul 6 0; Mul 6 2; Sub 1 0;
  Nonzero 0; (* the base meets the edges of the apex *)
  Mul 4 15; Mul 4 17; Sub 1 0;
  Nonzero 0; (* the base meets the edges of the apex *)
  Neg 48; Div 22 9; Mul 1 0; Mul 52 1; Neg 38; Div 26 8; Mul 1 0; Mul 42 1; Neg 33; Div 30 9;
  Mul 1 0; Mul 37 1; Sub 5 1; Sub 5 1; Sub 34 34; Sub 12 4; Sub 12 4; Mul 4 0; Mul 4 2; Sub 1 0;
  Constant 1; Div 0 1; Mul 7 5; Mul 9 8; Sub 1 0; Mul 0 3; Mul 13 11; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 19; Mul 1 19; Add 1 0; Sub 53 0; Add 1 0; Sub 55 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 29; Mul 7 29; Add 1 0; Add 0 5; Sub 60 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 38; Add 1 0; Add 0 10; Sub 65 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 101 88; Sub 101 88; Neg 0; Div 70 62; Mul 1 0; Mul 4 1; Mul 26 1; Mul 23 1; Add 1 0;
  Add 0 21; Sub 76 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 6 77; Sub 6 78; Sub 79 80; Sub 57 80; Sub 57 81; Mul 4 0; Mul 4 2; Sub 1 0; Div 44 0;
  Mul 6 4; Mul 8 7; Sub 1 0; Mul 0 3; Mul 12 10; Mul 11 10; Sub 1 0; Mul 0 7; Mul 4 94; Mul 1 95;
  Add 1 0; Sub 98 0; Neg 0; Sub 72 99; Sub 72 100; Mul 20 0; Mul 20 2; Sub 1 0; Div 63 0;
  Mul 25 4; Mul 24 26; Sub 1 0; Mul 0 3; Mul 28 29; Mul 30 10; Sub 1 0; Mul 0 7; Mul 4 113;
  Mul 1 114; Add 1 0; Sub 117 0; Neg 0; Sub 87 118; Sub 87 119; Mul 20 0; Mul 20 2; Sub 1 0;
  Div 82 0; Mul 44 4; Mul 24 45; Sub 1 0; Mul 0 3; Mul 28 48; Mul 49 10; Sub 1 0; Mul 0 7;
  Mul 4 132; Mul 1 133; Add 1 0; Sub 136 0; Neg 0; Sub 28 47; Sub 25 44; Sub 21 40; Sub 12 50;
  Sub 9 47; Sub 5 43; Mul 5 1; Mul 5 3; Sub 1 0; Div 105 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 65; Mul 1 62; Add 1 0; Sub 59 0; Add 1 0; Sub 61 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 52; Mul 7 49; Add 1 0; Add 0 5; Sub 47 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 38; Mul 12 35; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 52 92; Mul 52 94; Sub 1 0; Div 133 0; Mul 95 96; Mul 56 96; Sub 1 0; Mul 0 3; Mul 60 99;
  Mul 100 102; Sub 1 0; Mul 0 7; Mul 4 183; Mul 1 184; Add 1 0; Sub 187 0; Neg 0; Mul 37 9;
  Mul 34 6; Add 1 0; Add 0 32; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 103 103;
  ShowZero 0; (* top view of a pole *)
  Sub 100 100;
  ShowZero 0; (* top view of a pole *)
  Sub 86 86;
  ShowZero 0; (* top view of a pole *)
  Sub 83 83;
  ShowZero 0; (* top view of a pole *)
  Sub 69 69;
  ShowZero 0; (* top view of a pole *)
  Sub 66 66;
  ShowZero 0; (* top view of a pole *)
  Sub 20 20;
  ShowZero 0; (* top view of a pole *)
  Sub 17 17;
  ShowZero 0; (* top view of a pole *)
  Sub 155 155;
  ShowZero 0; (* top view of a pole *)
  Sub 152 152;
  ShowZero 0; (* top view of a pole *)
  Sub 203 52;
  ShowZero 0; (* gradient of a dual face *)
  Sub 204 49;
  ShowZero 0; (* gradient of a dual face *)
  Neg 151; Sub 27 116; Sub 24 113; Sub 20 109; Sub 163 119; Sub 160 116; Sub 5 112; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 174 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Sub 149 0;
  ShowZero 0; (* gradient of a dual face *)
  Mul 14 9; Mul 13 12; Sub 1 0; Mul 0 8; Sub 153 0;
  ShowZero 0; (* gradient of a dual face *)
  Mul 16 87; Mul 16 89; Sub 1 0; Div 188 0; Mul 18 91; Mul 20 91; Sub 1 0; Mul 0 3; Sub 211 0;
  ShowZero 0; (* gradient of a dual face *)
  Mul 25 95; Mul 24 98; Sub 1 0; Mul 0 8; Sub 215 0;
  ShowZero 0; (* gradient of a dual face *)
  Sub 194 131; Sub 191 128; Sub 36 124; Sub 115 134; Sub 112 131; Sub 108 127; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 208 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Sub 227 0;
  ShowZero 0; (* gradient of a dual face *)
  Mul 14 9; Mul 13 12; Sub 1 0; Mul 0 8; Sub 231 0;
  ShowZero 0; (* gradient of a dual face *)
  Sub 214 132; Sub 211 129; Sub 56 125; Sub 84 135; Sub 81 132; Sub 77 128; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 228 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Sub 243 0;
  ShowZero 0; (* gradient of a dual face *)
  Mul 14 9; Mul 13 12; Sub 1 0; Mul 0 8; Sub 247 0;
  ShowZero 0; (* gradient of a dual face *)
  Mul 142 142; Mul 142 142; Add 1 0; Mul 142 142; Mul 142 142; Add 1 0; Mul 79 79; Mul 79 79;
  Add 1 0; Mul 81 3; Mul 1 148; Sub 1 0; Mul 3 151; Mul 86 7; Sub 1 0; Mul 88 153; Mul 88 155;
  Sub 1 0; Mul 160 6; Mul 160 4; Add 1 0; Mul 18 3; Add 1 0; Sub 0 0;
  ShowZero 0; (* dual face *)
  Sub 281 233; Sub 281 233; Sub 279 235; Sub 279 235; Sub 277 237; Sub 277 237; Mul 5 5; Mul 5 5;
  Add 1 0; Mul 6 6; Mul 6 6; Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12; Sub 1 0;
  Mul 3 15; Mul 14 7; Sub 1 0; Mul 16 17; Mul 16 19; Sub 1 0; Mul 23 6; Mul 23 4; Add 1 0;
  Mul 18 3; Add 1 0; Sub 99 113; Sub 95 109; Sub 81 115; Sub 77 111; Sub 63 117; Sub 59 113;
  Mul 5 5; Mul 5 5; Add 1 0; Mul 6 6; Mul 6 6; Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3;
  Mul 1 12; Sub 1 0; Mul 3 15; Mul 14 7; Sub 1 0; Mul 16 17; Mul 16 19; Sub 1 0; Mul 23 6;
  Mul 23 4; Add 1 0; Mul 18 3; Add 1 0; Sub 29 0;
  ShowZero 0; (* dual vertex *)
  ShowZero 159; (* the dual of the dual *)
  ShowZero 158; (* the dual of the dual *)
  Neg 204; Sub 365 0;
  ShowZero 0; (* the dual of the dual *)
  ShowZero 144; (* the dual of the dual *)
  ShowZero 139; (* the dual of the dual *)
  Mul 145 275; Mul 141 272; Add 1 0; Sub 269 0; Neg 0; Sub 370 0;
  ShowZero 0; (* the dual of the dual *)
  ShowZero 136; (* the dual of the dual *)
  ShowZero 131; (* the dual of the dual *)
  Mul 137 281; Mul 133 278; Add 1 0; Sub 275 0; Neg 0; Sub 376 0;
  ShowZero 0; (* the dual of the dual *)
  ShowZero 122; (* the dual of the dual *)
  ShowZero 117; (* the dual of the dual *)
  Mul 123 268; Mul 119 265; Add 1 0; Sub 262 0; Neg 0; Sub 382 0;
  ShowZero 0; (* the dual of the dual *)
  ShowZero 108; (* the dual of the dual *)
  ShowZero 103; (* the dual of the dual *)
  Mul 109 255; Mul 105 252; Add 1 0; Sub 249 0; Neg 0; Sub 388 0;
  ShowZero 0 (* the dual of the dual *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
