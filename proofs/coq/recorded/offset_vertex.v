(** offset-vertex (Sec. 3.1, meshes with offsets (i))

    The vertices of M + dS have the distance d from those of M iff S is inscribed to the unit
    sphere. Such an S exists, for every start, iff the faces of M have circumcircles.

        |m_i' − m_i|² = d² |s_i|²

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** distances of vertices; size 1.
    Code: src/pair/offset.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Mul 2 6; Mul 3 6;
  Add 3 1; Add 3 1; Mul 6 8; Mul 7 8; Add 7 1; Add 7 1; Sub 12 14; Sub 12 14; Sub 3 7; Sub 3 7;
  Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 7; Unknown 8; Unknown 9; Mul 20 2; Add 1 0; Mul 22 3; Add 3 0; Sub 5 6; Sub 1 3;
  Mul 14 0; Mul 2 13; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 16; Mul 19 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 10; Unknown 11; Mul 34 1; Mul 35 1; Add 35 1; Add 35 1; Sub 5 40; Sub 5 40; Sub 3 31;
  Sub 3 31; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 12; Mul 46 0; Add 27 0; Sub 2 29; Sub 1 25; Mul 10 0; Mul 2 9; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 12; Mul 15 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 60 23; Sub 60 23; Sub 53 21; Sub 53 21; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 45 17; Sub 42 16; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 13; Mul 0 50; Add 55 0; Mul 2 69; Add 79 0; Mul 4 70; Add 80 0; Mul 6 6; Mul 57 57;
  Mul 75 75; Add 1 0; Mul 76 76; Add 1 0; Mul 5 0; Sub 11 67; Sub 10 90; Sub 9 90; Mul 2 2;
  Mul 2 2; Add 1 0; Mul 3 3; Add 1 0; Sub 0 8;
  ShowZero 0; (* distance *)
  Mul 22 70; Add 76 0; Mul 24 87; Add 99 0; Mul 26 88; Add 100 0; Mul 76 76; Mul 92 92; Add 1 0;
  Mul 93 93; Add 1 0; Mul 26 0; Sub 10 87; Sub 9 109; Sub 8 109; Mul 2 2; Mul 2 2; Add 1 0;
  Mul 3 3; Add 1 0; Sub 0 8;
  ShowZero 0; (* distance *)
  Mul 43 67; Add 70 0; Mul 45 80; Add 85 0; Mul 47 81; Add 86 0; Mul 73 73; Mul 85 85; Add 1 0;
  Mul 86 86; Add 1 0; Mul 47 0; Sub 10 81; Sub 9 95; Sub 8 95; Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3;
  Add 1 0; Sub 0 8;
  ShowZero 0 (* distance *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** faces parallel to a concyclic quad; size 1.
    Code: src/scalar/ring.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 1; Sub 3 1; Sub 7 5;
  Sub 7 5; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* a corner of the face is not straight, as on a circle *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Sub 12 16; Sub 12 16; Sub 16 18; Sub 16 18; Mul 5 5;
  Mul 5 5; Add 1 0; Mul 6 6; Mul 6 6; Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12;
  Sub 1 0; Mul 3 15; Mul 14 7; Sub 1 0; Mul 16 17; Mul 16 19; Sub 1 0; Mul 23 6; Mul 23 4;
  Add 1 0; Mul 18 3; Add 1 0;
  Zero 0; (* four corners are concyclic *)
  Constant 0; Unknown 8; Mul 29 0; Add 2 0; Sub 0 3; Sub 4 4; Mul 1 0; Mul 1 34; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 37 7; Add 9 0; Sub 0 10; Mul 6 40; Mul 1 7; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 3 42; Mul 11 44; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 56 47; Unknown 9; Mul 1 0; Add 17 0; Sub 0 18; Mul 0 17; Mul 18 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 65 56; Mul 0 7; Add 17 0; Sub 0 18; Mul 24 3; Mul 1 25; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 3 14; Mul 11 7; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 7 70; Mul 15 72; Sub 1 0; Neg 0; Div 0 71; Mul 77 0; Add 20 0; Sub 0 21; Mul 0 38;
  Mul 39 81; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 84 6; Add 19 0; Sub 0 20; Mul 44 87; Mul 1 45; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 3 89; Mul 10 91; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 55 13; Mul 0 51; Mul 52 92; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 59 11; Mul 55 96; Mul 1 56; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 3 98; Mul 8 100; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 38 66; Sub 46 67; Sub 20 68; Sub 27 69; Mul 59 59; Mul 67 67; Add 1 0; Mul 6 6; Mul 6 6;
  Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12; Sub 1 0; Mul 3 15; Mul 14 7; Sub 1 0;
  Mul 16 17; Mul 16 19; Sub 1 0; Mul 77 6; Mul 85 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0 (* concyclic *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** circular faces close; size 1.
    Code: src/construct/inscribed.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_3_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Sub 1 3; Sub 1 3; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* edges have a length *)
  Unknown 4; Unknown 5; Sub 1 8; Sub 1 8; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* edges have a length *)
  Unknown 6; Unknown 7; Sub 1 8; Sub 1 8; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* edges have a length *)
  Sub 22 6; Sub 22 6; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* edges have a length *)
  Sub 18 27; Sub 18 27; Mul 25 0; Mul 25 2; Sub 1 0;
  Nonzero 0; (* a corner of the face is not straight, as on a circle *)
  Sub 16 32; Sub 16 32; Mul 6 6; Mul 6 6; Add 1 0; Mul 4 4; Mul 4 4; Add 1 0; Mul 6 3; Mul 1 12;
  Sub 1 0; Mul 3 15; Mul 11 7; Sub 1 0; Mul 13 17; Mul 13 19; Sub 1 0; Mul 45 6; Mul 45 4;
  Add 1 0; Mul 44 3; Add 1 0;
  Zero 0; (* four corners are concyclic *)
  Unknown 8; Unknown 9; Constant 0; Sub 0 0; Constant 1; Div 0 51; Mul 5 56; Mul 5 56; Add 1 0;
  Sub 5 0; Mul 0 4; Mul 0 66; Mul 0 62; Mul 1 62; Add 13 1; Add 13 1; Div 11 55; Mul 2 60;
  Mul 2 60; Add 1 0; Sub 16 0; Mul 0 4; Mul 0 77; Mul 0 66; Mul 1 66; Add 10 1; Add 10 1;
  Div 22 59; Mul 2 64; Mul 2 64; Add 1 0; Sub 27 0; Mul 0 4; Mul 0 88; Mul 0 70; Mul 1 70;
  Add 10 1; Add 10 1; Div 33 65; Mul 2 70; Mul 2 70; Add 1 0; Sub 38 0; Mul 0 4; Mul 0 99;
  Mul 0 76; Add 9 0; Sub 0 46;
  ShowZero 0; (* as a test finds *)
  Mul 3 78; Add 11 0; Sub 0 48;
  ShowZero 0; (* as a test finds *)
  Mul 50 50; Mul 50 50; Add 1 0; Mul 49 0; Div 50 110; Mul 1 0; Mul 54 56; Mul 55 56; Add 1 0;
  Add 0 57; Add 4 0; Mul 50 58; Add 1 0; Mul 41 60; Add 1 0; Mul 32 62; Add 1 0; Mul 23 64;
  Add 1 0; Sub 0 8;
  ShowZero 0; (* as a test finds *)
  Sub 56 56;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 56 56;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 9 9;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 48 48;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 48 48;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 10 10;
  ShowZero 0; (* as src/space/point.rs finds *)
  Div 72 91; Mul 77 99; Mul 77 99; Add 1 0; Sub 77 0; Mul 0 4; Mul 0 138; Mul 0 105; Add 84 0;
  Sub 49 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 3 107; Add 86 0; Sub 51 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 6 86; Add 29 0; Sub 24 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 7 124; Mul 5 124; Add 1 0; Sub 92 0; Mul 0 58; Mul 0 153; Mul 0 130; Add 14 0; Sub 0 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 3 132; Add 14 0; Sub 0 102;
  ShowZero 0; (* as src/space/point.rs finds *)
  Mul 6 101; Add 14 0; Sub 0 45;
  ShowZero 0; (* as src/space/point.rs finds *)
  Div 103 130; Mul 105 134; Mul 159 106; Sub 1 0; Mul 0 3; Mul 163 109; Mul 110 140; Sub 1 0;
  Mul 0 7; Mul 4 171; Mul 1 171; Add 1 0; Sub 117 0; Add 1 0; Sub 119 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 175; Mul 7 175; Add 1 0; Add 0 5; Sub 124 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 173; Mul 12 173; Add 1 0; Add 0 10; Sub 129 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 171; Mul 17 171; Add 1 0; Add 0 15; Sub 134 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 137; Mul 22 137; Add 1 0; Sub 79 0; Mul 29 127; Mul 26 127; Add 1 0; Add 0 3; Sub 82 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 121; Mul 31 121; Add 1 0; Add 0 8; Sub 85 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 66; Mul 36 64; Add 1 0; Add 0 13; Sub 64 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 103 103;
  ShowZero 0; (* a circle around the gradient *)
  Mul 143 143; Mul 143 143; Add 1 0; Sub 0 107;
  ShowZero 0; (* a circle around the gradient *)
  Mul 136 136; Mul 136 136; Add 1 0; Sub 0 111;
  ShowZero 0; (* a circle around the gradient *)
  Mul 80 80; Mul 78 78; Add 1 0; Sub 0 115;
  ShowZero 0; (* a circle around the gradient *)
  Sub 169 84; Sub 169 82; Mul 1 202; Mul 1 204; Sub 1 0;
  ShowZero 0 (* the last edge *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
