(** thm-2-v (Sec. 3.2, Theorem 2)

    An i-conical mesh has a circumscribed mesh with the same top view for every point of contact of
    one face: the contacts of neighbouring faces are mirror images at their edge, and around a
    balanced vertex of valence 4 they close.

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the star of a vertex; size 1.
    Code: src/construct/circumscribed.rs, src/net/i_conical.rs, src/net/scribed.rs,
    src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs, src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 2; Unknown 3; Mul 6 0; Mul 6 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Mul 4 4; Mul 4 4; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 4; Unknown 5; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 6; Unknown 7; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 8; Unknown 9; Add 1 24; Add 1 24; Add 3 21; Add 3 21; Add 5 15; Add 5 15; Add 7 12;
  Add 7 12; Sub 7 9; Sub 7 9; Sub 7 11; Sub 7 11; Sub 7 13; Sub 7 13; Sub 7 15; Sub 7 15; Mul 5 1;
  Mul 5 1; Sub 1 0; Mul 8 3; Mul 8 5; Add 1 0; Mul 13 9; Mul 13 9; Sub 1 0; Mul 16 11; Mul 16 13;
  Add 1 0; Mul 9 0; Mul 7 4; Sub 1 0;
  Zero 0; (* every interior vertex is balanced, (14) modulo π *)
  Unknown 10; Unknown 11; Neg 21; Sub 35 2; Sub 35 2; Mul 2 1; Mul 26 1; Add 1 0; Mul 64 0;
  Mul 6 6; Mul 30 30; Add 1 0; Div 3 0; Mul 10 0; Mul 34 1; Add 14 1; Add 14 1; Neg 34; Sub 50 2;
  Sub 50 2; Mul 2 1; Mul 39 1; Add 1 0; Mul 79 0; Mul 6 6; Mul 43 43; Add 1 0; Div 3 0; Mul 10 0;
  Mul 47 1; Add 14 1; Add 14 1; Neg 47; Sub 65 2; Sub 65 2; Mul 2 1; Mul 52 1; Add 1 0; Mul 94 0;
  Mul 6 6; Mul 56 56; Add 1 0; Div 3 0; Mul 10 0; Mul 60 1; Add 14 1; Add 14 1; Neg 68; Sub 80 2;
  Sub 80 2; Mul 2 1; Mul 73 1; Add 1 0; Mul 109 0; Mul 6 6; Mul 77 77; Add 1 0; Div 3 0; Mul 10 0;
  Add 13 0; Sub 0 59;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 83 3; Add 15 0; Sub 0 61;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 16 60; Mul 87 60; Add 1 0; Mul 123 0; Div 0 11; Mul 21 0; Add 69 0; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 94 3; Add 71 0; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 107 103; Sub 107 103; Neg 0; Sub 106 77; Sub 106 77; Mul 2 1; Mul 5 1; Add 1 0; Mul 139 0;
  Mul 6 6; Mul 9 9; Add 1 0; Div 3 0; Mul 10 0; Add 88 0; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 15 3; Add 90 0; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 126 118; Sub 126 118; Neg 0; Sub 121 26; Sub 121 24; Mul 2 1; Mul 5 1; Add 1 0; Mul 158 0;
  Mul 6 6; Mul 9 9; Add 1 0; Div 3 0; Mul 10 0; Add 37 0; Sub 141 135; Sub 141 135; Neg 0;
  Sub 138 22; Sub 138 20; Mul 2 1; Mul 5 1; Add 1 0; Mul 173 0; Mul 6 6; Mul 9 9; Add 1 0;
  Div 3 0; Mul 10 0; Add 33 0; Sub 0 15;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 30 18; Add 52 0; Mul 17 5; Add 35 0; Sub 0 2;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 154 21; Sub 154 4; Mul 35 1; Mul 38 1; Add 1 0; Mul 191 0; Div 0 30; Mul 40 0; Add 29 0;
  Sub 0 68;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 45 3; Add 14 0; Sub 0 68;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 175 175;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Constant 1; Constant 0; Mul 65 65; Mul 63 63; Add 1 0; Mul 4 0; Div 5 215; Mul 1 0; Mul 6 71;
  Mul 7 69; Add 1 0; Add 0 9; Add 4 0; Mul 76 12; Mul 74 13; Add 13 1; Add 14 1; Mul 1 80;
  Mul 1 78; Add 1 0; Sub 7 0; Mul 5 202; Mul 5 202; Add 1 0; Add 0 3; Mul 107 107; Mul 105 105;
  Add 1 0; Mul 27 0; Mul 0 22; Mul 28 112; Mul 29 110; Add 1 0; Add 0 31; Add 4 0; Mul 117 34;
  Mul 115 35; Add 35 1; Add 36 1; Mul 1 121; Mul 1 119; Add 1 0; Sub 7 0; Mul 5 228; Mul 5 228;
  Add 1 0; Add 0 3; Mul 9 230; Mul 9 230; Add 1 0; Add 0 7; Sub 0 4; Sub 27 5; Mul 228 225;
  Mul 228 227; Sub 1 0; Div 55 0; Mul 5 229; Mul 232 5; Sub 1 0; Mul 0 3; Sub 0 213;
  ShowZero 0; (* the first contact *)
  Mul 237 9; Mul 11 236; Sub 1 0; Mul 0 8; Sub 0 217;
  ShowZero 0; (* the first contact *)
  Sub 8 9; Sub 4 5; Mul 1 254; Mul 1 254; Add 1 0; Mul 16 25; Add 1 0; Mul 0 18; Add 0 0; Mul 8 8;
  Mul 8 8; Add 1 0; Mul 0 78; Add 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 125 125; Mul 108 108; Add 1 0; Mul 83 0; Mul 0 78; Mul 84 130; Mul 85 113; Add 1 0;
  Add 0 87; Add 4 0; Mul 135 90; Mul 118 91; Add 91 1; Add 92 1; Mul 1 139; Mul 1 122; Add 1 0;
  Sub 7 0; Mul 5 278; Mul 5 278; Add 1 0; Add 0 3; Sub 0 56; Mul 276 0; Mul 52 275; Sub 1 0;
  Mul 54 278; Mul 281 4; Sub 1 0; Mul 283 280; Mul 283 282; Sub 1 0; Mul 6 298; Mul 4 298;
  Add 1 0; Mul 3 69; Add 1 0; Mul 0 5; Add 0 0; Mul 13 13; Mul 11 11; Add 1 0; Mul 0 122; Add 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 87 302; Mul 87 302; Add 1 0; Add 0 85; Sub 0 82; Mul 300 0; Mul 27 299; Sub 1 0; Mul 29 302;
  Mul 305 4; Sub 1 0; Mul 307 304; Mul 307 306; Sub 1 0; Mul 6 324; Mul 4 324; Add 1 0; Mul 3 95;
  Add 1 0; Mul 0 5; Add 0 0; Mul 13 13; Mul 11 11; Add 1 0; Mul 0 148; Add 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 319 99; Mul 22 326; Sub 1 0; Mul 24 329; Mul 324 103; Sub 1 0; Mul 326 331; Mul 326 333;
  Sub 1 0; Mul 6 345; Mul 4 345; Add 1 0; Mul 3 116; Add 1 0; Mul 0 5; Add 0 0; Mul 13 13;
  Mul 11 11; Add 1 0; Mul 0 169; Add 4 0;
  ShowZero 0; (* touches Σ *)
  ShowZero 181; (* the same top view *)
  ShowZero 180; (* the same top view *)
  ShowZero 179; (* the same top view *)
  ShowZero 178; (* the same top view *)
  ShowZero 177; (* the same top view *)
  ShowZero 176; (* the same top view *)
  ShowZero 175; (* the same top view *)
  ShowZero 174; (* the same top view *)
  ShowZero 173; (* the same top view *)
  ShowZero 172 (* the same top view *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
