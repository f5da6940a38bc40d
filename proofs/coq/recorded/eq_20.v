(** eq-20 (Sec. 4, (20), Fig. 7)

    Two parallel quads have mixed area 0 iff each diagonal of one is parallel to the other diagonal
    of the other.

        area(F, S) = 0  <=>  13 ∥ 2*4*  and  24 ∥ 1*3*

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** parallel quads in space, and the one that has mixed area 0; size 1.
    Code: src/pair/area.rs, src/pair/face.rs, src/pair/forms.rs, src/scalar/ring.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 5;
  Sub 3 5; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* two edges of F that meet at corner 1 or 3 are not parallel *)
  Unknown 6; Unknown 7; Sub 1 10; Sub 1 10; Sub 16 3; Sub 16 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* two edges of F that meet at corner 1 or 3 are not parallel *)
  Sub 17 21; Sub 17 21; Mul 1 14; Mul 1 16; Sub 1 0; Mul 0 5; Mul 5 11; Mul 5 13; Sub 1 0;
  Mul 22 12; Mul 22 14; Sub 1 0; Mul 3 0; Sub 7 0;
  Nonzero 0; (* the factor of edge 12 decides over the mixed area *)
  Unknown 8; Unknown 9; Unknown 10; Mul 2 38; Mul 2 38; Add 1 0; Add 0 3; Mul 6 40; Mul 6 40;
  Add 1 0; Add 0 7; Unknown 11; Unknown 12; Unknown 13; Sub 3 7; Mul 43 3; Add 3 0; Mul 2 5;
  Add 4 0; Sub 2 6; Sub 1 6; Mul 49 0; Mul 7 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 14; Mul 54 13; Add 1 0; Sub 0 2; Mul 13 0; Mul 58 8; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 60 11; Mul 60 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 33 65; Mul 33 65; Add 1 0; Add 0 34; Unknown 15; Sub 1 28; Mul 66 1; Add 24 0; Mul 2 3;
  Add 24 0; Sub 2 27; Sub 1 26; Mul 72 0; Mul 7 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 76 10; Add 23 0; Sub 0 24; Mul 12 0; Mul 80 7; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 82 10; Mul 82 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 57 80; Mul 57 80; Add 1 0; Add 0 58; Sub 0 24; Sub 38 12; Sub 51 22; Mul 1 82; Mul 1 84;
  Sub 1 0; Div 0 82; Mul 88 0; Add 28 0; Mul 8 2; Add 28 0; Sub 2 31; Sub 1 30; Mul 94 0;
  Mul 13 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 98 9; Add 28 0; Sub 0 29; Mul 18 0; Mul 102 7; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 104 10; Mul 104 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 80 25; Sub 75 17; Sub 75 16; Mul 107 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 68 13; Mul 6 0; Mul 113 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 115 8; Mul 115 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 62 93; Mul 130 113; Mul 130 115; Sub 1 0; Constant 1; Div 0 1; Mul 91 118; Mul 135 6;
  Sub 1 0; Mul 0 3; Mul 139 9; Mul 96 124; Sub 1 0; Mul 0 7; Mul 4 149; Mul 1 149; Add 1 0;
  Sub 110 0; Add 1 0; Sub 112 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 153; Mul 7 153; Add 1 0; Add 0 5; Sub 113 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 156; Mul 12 156; Add 1 0; Add 0 10; Sub 91 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 152; Mul 17 152; Add 1 0; Add 0 15; Sub 72 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 110; Mul 22 123; Add 1 0; Sub 124 0; Mul 29 112; Mul 26 123; Add 1 0; Add 0 3; Sub 124 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 93; Mul 31 103; Add 1 0; Add 0 8; Sub 104 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 69; Mul 36 79; Add 1 0; Add 0 13; Sub 80 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 142 159; Mul 184 172; Mul 184 174; Sub 1 0; Mul 3 0; Div 0 159; Mul 186 0; Add 144 0;
  Mul 122 2; Add 144 0; Sub 2 147; Sub 1 146; Mul 192 0; Mul 127 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 196 9; Add 143 0; Sub 0 144; Mul 132 0; Mul 200 7; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 202 10; Mul 202 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 153 7; Sub 166 17; Mul 1 197; Mul 1 199; Sub 1 0; Div 0 197; Mul 203 0; Add 23 0; Mul 123 2;
  Add 23 0; Sub 2 26; Sub 1 25; Mul 209 0; Mul 128 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 213 9; Add 23 0; Sub 0 24; Mul 133 0; Mul 217 7; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 219 10; Mul 219 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 189 16; Sub 189 15; Mul 221 0; Mul 117 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 182 12; Mul 120 0; Mul 227 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 229 8; Mul 229 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 104 43; Mul 101 53; Add 1 0; Add 0 78; Sub 54 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 109 24; Mul 106 34; Add 1 0; Add 0 83; Sub 35 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Constant 0; Sub 174 200; Sub 184 213; Mul 256 0; Mul 256 2; Sub 1 0; Mul 202 242; Mul 211 244;
  Sub 1 0; Add 3 0; Add 9 0; Sub 257 270; Sub 257 270; Sub 157 212; Sub 167 225; Mul 252 0;
  Mul 252 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Constant 4; Div 143 0;
  Mul 2 0; Sub 170 223; Sub 180 234; Mul 265 0; Mul 265 2; Sub 1 0; Mul 5 291; Sub 1 0;
  ShowZero 0; (* det(13, 2*4* ) *)
  Sub 279 290; Sub 279 290; Mul 33 0; Mul 33 2; Sub 1 0; Sub 0 6;
  ShowZero 0; (* det(1*3*, 24) *)
  Add 38 33; Add 0 31; Add 40 23; Add 0 21; Add 2 0; Mul 12 304; Sub 1 0;
  ShowZero 0; (* 4 area(F, S) *)
  Sub 99 245; Sub 109 258; Mul 301 0; Mul 301 2; Sub 1 0; Add 0 42; Add 51 0; Sub 82 252;
  Sub 92 265; Mul 292 0; Mul 292 2; Sub 1 0; Mul 11 45; Mul 11 47; Sub 1 0; Add 3 0; Add 9 0;
  Mul 0 38; Sub 93 261; Sub 103 272; Mul 303 0; Mul 303 2; Sub 1 0; Mul 5 329; Sub 1 0;
  ShowZero 0; (* det(13, 2*4* ) *)
  Mul 24 36; Mul 24 38; Sub 1 0; Sub 0 4;
  ShowZero 0; (* det(1*3*, 24) *)
  Add 74 24; Add 0 67; Add 76 19; Add 0 17; Add 2 0; Mul 10 340; Sub 1 0;
  ShowZero 0; (* 4 area(F, S) *)
  ShowZero 18 (* mixed area *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the two identities for any two quads; size 1.
    Code: src/pair/area.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Sub 11 15; Sub 11 15; Sub 3 7; Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0; Sub 10 14; Sub 10 14;
  Sub 18 22; Sub 18 22; Mul 3 0; Mul 3 2; Sub 1 0; Sub 27 29; Sub 27 29; Sub 21 23; Sub 21 23;
  Constant 0; Mul 4 10; Mul 4 12; Sub 1 0; Add 3 0; Mul 6 21; Mul 6 23; Sub 1 0; Add 3 0;
  Sub 36 42; Sub 36 42; Sub 30 36; Sub 30 36; Mul 30 0; Mul 30 2; Sub 1 0; Add 7 0; Mul 27 6;
  Mul 27 8; Sub 1 0; Add 3 0; Add 32 25; Sub 1 0;
  ShowZero 0; (* 4 area(F, S) *)
  Sub 27 34; Mul 27 24; Mul 27 26; Sub 1 0; Sub 56 58; Sub 56 58; Sub 50 52; Sub 50 52; Mul 3 0;
  Mul 3 2; Sub 1 0; Sub 7 0; Sub 62 64; Sub 62 64; Sub 56 58; Sub 56 58; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 7 0; Sub 76 70; Sub 76 70; Sub 70 64; Sub 70 64; Mul 3 0; Mul 3 2; Sub 1 0;
  Sub 7 0; Sub 27 0;
  ShowZero 0 (* terms *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
