(** offset-face (Sec. 3.1, meshes with offsets (iii))

    The planes of the faces of M + dS have the distance d from those of M iff the planes of S touch
    the unit sphere. Around a vertex such an S exists iff the planes touch a cone of revolution.

        n·(v + ds) + h = d n·s

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** distances of planes; size 1.
    Code: src/scalar/ring.rs, src/space/laguerre/cone.rs, src/space/laguerre/plane.rs,
    src/space/laguerre/transformation.rs, src/space/point.rs, src/space/similarity.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 1; Mul 2 2; Mul 2 2; Add 1 0; Add 3 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 2; Unknown 3; Unknown 4; Constant 0; Div 8 4; Mul 12 0; Mul 12 0; Mul 12 1; Sub 12 9;
  Mul 0 4; Mul 6 4; Mul 4 10; Mul 4 10; Add 1 0; Mul 4 11; Add 1 0; Add 0 5; Mul 0 17; Neg 0;
  Div 23 26; Mul 1 0; Mul 0 15; Add 6 0;
  ShowZero 0; (* the plane passes through v *)
  Unknown 5; Unknown 6; Unknown 7; Unknown 8; Mul 0 3; Mul 1 3; Mul 2 3; Add 29 2; Add 29 2;
  Add 29 2; Mul 26 2; Mul 26 2; Add 1 0; Mul 26 3; Add 1 0; Add 0 16; Mul 32 15; Mul 32 15;
  Add 1 0; Mul 32 16; Add 1 0; Mul 17 0; Sub 6 0;
  ShowZero 0; (* distance *)
  Neg 19; Mul 51 40; Mul 44 40; Add 1 0; Mul 46 40; Add 1 0; Mul 48 56; Add 1 0; Mul 50 47;
  Mul 59 47; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 64 50; Add 1 0; Add 0 9; Add 3 12;
  Mul 68 68; Add 1 0; Mul 70 44; Neg 20; Mul 14 64; Mul 10 65; Add 1 0; Mul 8 67; Add 1 0;
  Mul 7 5; Add 1 0; Sub 8 0; Div 80 10; Mul 23 0; Mul 19 1; Mul 16 2; Mul 4 3; Sub 37 85;
  Mul 4 51; Mul 4 51; Add 1 0; Mul 5 52; Add 1 0; Add 0 6; Mul 61 6; Sub 1 0;
  ShowZero 0 (* offset planes *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** four planes at a vertex; size 1.
    Code: src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs,
    src/space/laguerre/cone.rs, src/space/laguerre/plane.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 1; Mul 2 2; Mul 2 2; Add 1 0; Add 3 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 2; Unknown 3; Mul 1 1; Mul 1 1; Add 1 0; Add 9 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 4; Unknown 5; Mul 1 1; Mul 1 1; Add 1 0; Add 15 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 6; Unknown 7; Mul 1 1; Mul 1 1; Add 1 0; Add 21 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Sub 17 24; Sub 17 24; Sub 13 26; Sub 13 26; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* a corner of the face is not straight, as on a circle *)
  Mul 6 6; Mul 6 6; Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 6 38; Div 36 0; Mul 5 11; Mul 14 3;
  Sub 1 0; Mul 0 3; Mul 18 6; Mul 10 17; Sub 1 0; Mul 0 7; Add 47 4; Add 47 1; Mul 6 6; Mul 3 3;
  Add 1 0; Constant 0; Sub 5 0; Sub 5 1; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 6; Add 57 0;
  Nonzero 0; (* the unit normals at a vertex do not lie on a great circle *)
  Sub 41 60; Sub 41 60; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 28; Mul 1 38; Sub 1 0; Mul 3 41;
  Mul 8 32; Sub 1 0; Mul 10 43; Mul 10 45; Sub 1 0; Mul 49 6; Mul 49 4; Add 1 0; Mul 43 3;
  Add 1 0;
  Zero 0; (* four corners are concyclic *)
  Unknown 8; Unknown 9; Unknown 10; Div 80 76; Mul 84 0; Mul 84 0; Mul 84 1; Sub 84 81; Mul 0 4;
  Mul 35 4; Mul 4 9; Mul 4 9; Add 1 0; Mul 4 10; Add 1 0; Add 0 5; Mul 0 89; Neg 0; Div 95 98;
  Mul 1 0; Div 97 87; Mul 101 0; Mul 94 0; Mul 94 1; Sub 101 92; Mul 0 4; Mul 52 4; Mul 4 26;
  Mul 4 26; Add 1 0; Mul 4 27; Add 1 0; Add 0 5; Mul 0 100; Neg 0; Mul 0 16; Div 113 97;
  Mul 117 0; Mul 104 0; Mul 104 1; Sub 117 102; Mul 0 4; Mul 68 4; Mul 4 42; Mul 4 42; Add 1 0;
  Mul 4 43; Add 1 0; Add 0 5; Mul 0 110; Neg 0; Mul 0 32; Sub 16 32; Sub 1 33; Div 131 102;
  Mul 2 106; Mul 109 2; Sub 1 0; Mul 0 3; Mul 113 5; Mul 7 112; Sub 1 0; Mul 0 7; Mul 4 142;
  Mul 1 142; Add 1 0; Sub 46 0; Mul 98 98; Mul 98 98; Add 1 0; Sub 0 97; Add 148 0; Div 149 0;
  Mul 153 0; Mul 7 0; Neg 0; Mul 0 107; Sub 0 18; Sub 0 77;
  ShowZero 0; (* the vertex of the cone *)
  Mul 3 109; Sub 0 17; Sub 0 79;
  ShowZero 0; (* the vertex of the cone *)
  Sub 6 79;
  ShowZero 0; (* the vertex of the cone *)
  Mul 63 78; Add 69 0;
  ShowZero 0; (* a plane through the vertex *)
  Mul 116 11; Mul 116 12; Sub 164 16; Mul 0 15; Mul 83 3; Mul 83 3; Add 1 0; Mul 83 3; Add 1 0;
  Sub 0 171;
  ShowZero 0; (* a plane that touches the cone *)
  Mul 59 73; Add 64 0;
  ShowZero 0; (* a plane through the vertex *)
  Mul 74 11; Mul 74 11; Add 1 0; Mul 74 11; Add 1 0; Sub 0 179;
  ShowZero 0; (* a plane that touches the cone *)
  Mul 51 65; Add 56 0;
  ShowZero 0; (* a plane through the vertex *)
  Mul 66 19; Mul 66 19; Add 1 0; Mul 66 19; Add 1 0; Sub 0 187;
  ShowZero 0; (* a plane that touches the cone *)
  Div 188 166; Mul 192 0; Mul 173 0; Mul 173 1; Sub 192 171; Mul 0 4; Mul 143 4; Mul 4 117;
  Mul 4 117; Add 1 0; Mul 4 118; Add 1 0; Add 0 5; Mul 0 179; Neg 0; Mul 0 107; Mul 0 14; Add 5 0;
  ShowZero 0; (* a plane through the vertex *)
  Mul 15 43; Mul 15 43; Add 1 0; Mul 15 43; Add 1 0; Sub 0 211;
  ShowZero 0 (* a plane that touches the cone *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** their unit normals; size 1.
    Code: src/scalar/ring.rs, src/space/laguerre/plane.rs, src/space/point.rs *)
Definition part_3_size_1 : list step := [
  Unknown 0; Unknown 1; Constant 1; Mul 2 2; Mul 2 2; Add 1 0; Add 3 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 2; Unknown 3; Mul 1 1; Mul 1 1; Add 1 0; Add 9 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 4; Unknown 5; Mul 1 1; Mul 1 1; Add 1 0; Add 15 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Unknown 6; Unknown 7; Mul 1 1; Mul 1 1; Add 1 0; Add 21 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Sub 17 24; Sub 17 24; Sub 13 26; Sub 13 26; Sub 9 28; Sub 9 28; Mul 5 5; Mul 5 5; Add 1 0;
  Mul 6 6; Mul 6 6; Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12; Sub 1 0; Mul 3 15;
  Mul 14 7; Sub 1 0; Mul 16 17; Mul 16 19; Sub 1 0; Mul 23 6; Mul 23 4; Add 1 0; Mul 18 3;
  Add 1 0;
  Zero 0; (* four corners are concyclic *)
  Constant 0; Div 52 48; Constant 2; Mul 0 1; Mul 57 0; Mul 57 1; Sub 57 54; Mul 0 5; Neg 2;
  Neg 1; Sub 9 9; Sub 3 10; Sub 3 11; Sub 3 12; Sub 9 13; Mul 3 0; Mul 3 5; Sub 1 0; Mul 5 4;
  Mul 8 4; Sub 1 0; Mul 10 10; Mul 10 8; Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0;
  Mul 21 21; Sub 1 0;
  ShowZero 0; (* length of a normal *)
  Div 82 72; Mul 29 0; Mul 79 0; Mul 79 1; Sub 86 77; Mul 0 4; Neg 2; Neg 1; Sub 2 38; Sub 2 39;
  Sub 2 40; Sub 8 41; Mul 3 0; Mul 3 33; Sub 1 0; Mul 5 4; Mul 36 4; Sub 1 0; Mul 9 7; Sub 28 0;
  Mul 5 5; Mul 3 3; Add 1 0; Mul 3 3; Add 1 0; Mul 19 19; Sub 1 0;
  ShowZero 0; (* length of a normal *)
  Div 109 93; Mul 56 0; Mul 100 0; Mul 100 1; Sub 113 98; Mul 0 4; Neg 2; Neg 1; Sub 2 65;
  Sub 2 66; Sub 2 67; Sub 8 68; Mul 3 0; Mul 3 60; Sub 1 0; Mul 5 4; Mul 63 4; Sub 1 0; Mul 9 7;
  Sub 55 0; Mul 5 5; Mul 3 3; Add 1 0; Mul 3 3; Add 1 0; Mul 19 19; Sub 1 0;
  ShowZero 0; (* length of a normal *)
  Div 136 114; Mul 83 0; Mul 121 0; Mul 121 1; Sub 140 119; Mul 0 4; Neg 2; Neg 1; Sub 2 92;
  Sub 2 93; Sub 2 94; Sub 8 95; Mul 3 0; Mul 3 87; Sub 1 0; Mul 5 4; Mul 90 4; Sub 1 0; Mul 9 7;
  Sub 82 0; Mul 5 5; Mul 3 3; Add 1 0; Mul 3 3; Add 1 0; Mul 19 19; Sub 1 0;
  ShowZero 0; (* length of a normal *)
  Mul 9 34; Mul 8 37; Sub 1 0; Mul 10 42; Mul 16 38; Sub 1 0; Mul 18 42; Mul 16 46; Sub 1 0;
  Mul 75 6; Mul 73 4; Add 1 0; Mul 73 3; Add 1 0; Mul 50 21; Mul 49 24; Sub 1 0; Mul 51 29;
  Mul 57 25; Sub 1 0; Mul 59 29; Mul 57 33; Sub 1 0; Mul 117 6; Mul 115 4; Add 1 0; Mul 114 3;
  Add 1 0; Mul 37 89; Mul 36 92; Sub 1 0; Mul 38 97; Mul 44 93; Sub 1 0; Mul 46 97; Mul 44 101;
  Sub 1 0; Mul 131 6; Mul 129 4; Add 1 0; Mul 128 3; Add 1 0; Mul 105 76; Mul 104 79; Sub 1 0;
  Mul 106 84; Mul 112 80; Sub 1 0; Mul 114 84; Mul 112 88; Sub 1 0; Mul 145 6; Mul 143 4; Add 1 0;
  Mul 142 3; Add 1 0; Mul 42 160; Add 168 0; Mul 30 133; Add 1 0; Mul 18 108; Add 1 0; Mul 6 83;
  Add 1 0;
  ShowZero 0 (* concyclic normals *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
