(** hex-rotational (Sec. 4, Fig. 10)

    Rotational meshes of hexagons have first integrals: with the steps δ, δ' of the offsets of face
    planes in M and S from ring to ring, H = 0, H constant or K constant at all faces says that one
    number C is the same for all steps.

        H = 0: δδ' = C AB,  H constant: δδ' - Hδ² = C AB,  K constant: δ² - δ'²/K = C AB

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** areas and mixed areas of any steps; size 1.
    Code: src/construct/hexagonal.rs, src/construct/packing.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Div 2 0; Sub 3 2; Mul 0 1; Unknown 1; Unknown 2; Mul 2 1; Sub 1 0;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Mul 4 2; Sub 0 4;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Unknown 3; Sub 0 2;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Mul 8 1; Sub 0 7;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Constant 2; Mul 17 0; Mul 0 14; Unknown 4; Unknown 5; Constant 0; Mul 16 21; Mul 4 1; Sub 1 0;
  Mul 6 24; Mul 20 4; Add 1 0; Mul 22 3; Mul 10 1; Sub 1 0; Mul 12 6; Mul 26 4; Add 1 0;
  Div 33 22; Mul 0 15; Div 35 26; Mul 0 17; Div 37 24; Mul 0 18; Mul 4 15; Mul 5 13; Mul 4 11;
  Mul 5 9; Mul 4 19; Mul 5 17; Sub 5 3; Sub 5 3; Sub 3 5; Sub 3 5; Mul 3 0; Mul 3 2; Sub 1 0;
  Add 31 0;
  Nonzero 0; (* the first corners of a face are not on a line *)
  Mul 44 42;
  ShowNonzero 0; (* as a test finds *)
  Mul 41 39;
  ShowNonzero 0; (* as a test finds *)
  ShowNonzero 37; (* as src/construct/hexagonal.rs finds *)
  Sub 34 36; Mul 50 21; Add 0 36; Mul 51 21; Add 0 3; Sub 4 40; Mul 49 22; Add 0 1; Sub 5 3;
  Sub 1 4; Div 65 13; Mul 2 17; Mul 20 2; Sub 1 0; Mul 0 3; Mul 24 5; Mul 7 23; Sub 1 0; Mul 0 7;
  Mul 4 32; Mul 1 32; Add 1 0; Sub 17 0; Add 1 0; Sub 19 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 40; Mul 7 40; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 41; Mul 12 41; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 90 75; Mul 0 71; Mul 85 0; Add 0 37; Mul 2 64; Mul 3 62; Mul 26 1; Mul 23 1; Add 1 0;
  Add 0 21; Sub 6 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 96 71; Mul 84 69; Sub 1 0; Mul 86 74; Mul 100 72; Add 1 0; Mul 68 3; Mul 69 1; Mul 39 1;
  Mul 36 1; Add 1 0; Add 0 34; Sub 50 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 79 10; Mul 80 8; Mul 46 1; Mul 43 1; Add 1 0; Add 0 41; Sub 62 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Unknown 6; Sub 101 0; Mul 89 1; Mul 118 0; Add 0 104; Mul 90 4; Mul 120 0; Add 0 5; Mul 5 105;
  Mul 6 103; Mul 4 101; Mul 5 99; Mul 127 127; Constant (-1); Div 0 119; Mul 2 0; Add 11 0;
  Add 9 1; Mul 69 7; Mul 66 7; Add 1 0; Sub 3 0; Mul 73 13; Mul 70 13; Add 1 0; Add 0 3; Sub 9 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Unknown 7; Sub 26 0; Mul 112 1; Mul 139 0; Add 0 2; Mul 2 129; Mul 3 127; Add 2 18; Mul 86 2;
  Mul 83 2; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 70 12; Mul 155 0; Add 0 40; Mul 2 134; Mul 3 132; Add 2 29; Mul 97 2; Mul 94 2; Add 1 0;
  Add 0 27; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 21 68; Mul 22 66; Mul 104 1; Mul 101 1; Add 1 0; Add 0 34; Sub 22 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 55 75; Mul 56 73; Mul 111 1; Mul 108 1; Add 1 0; Add 0 41; Sub 47 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 91 144; Sub 91 144; Mul 140 0; Mul 140 2; Sub 1 0; Add 138 0; Sub 84 150; Sub 84 150;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 83 156; Sub 83 156; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Mul 0 188; Mul 185 185; Div 0 151; Mul 0 189; Mul 189 189; Div 0 155; Mul 0 192; Sub 3 0;
  Constant 4; Div 213 0; Mul 9 0; Sub 0 3;
  ShowZero 0; (* area(F) *)
  Sub 86 84; Sub 86 84; Sub 64 86; Sub 64 86; Mul 174 0; Mul 174 2; Sub 1 0; Mul 6 174; Mul 6 176;
  Sub 1 0; Add 3 0; Add 206 0; Sub 63 96; Sub 63 96; Mul 182 0; Mul 182 2; Sub 1 0; Mul 14 45;
  Mul 14 47; Sub 1 0; Add 3 0; Add 9 0; Sub 65 106; Sub 65 106; Mul 53 0; Mul 53 2; Sub 1 0;
  Mul 14 49; Mul 14 51; Sub 1 0; Add 3 0; Add 9 0; Sub 68 116; Sub 68 116; Mul 57 0; Mul 57 2;
  Sub 1 0; Mul 14 53; Mul 14 55; Sub 1 0; Add 3 0; Add 9 0; Mul 238 109; Div 0 204; Mul 0 242;
  Mul 242 139; Div 0 208; Mul 0 245; Sub 3 0; Mul 7 51; Sub 0 1;
  ShowZero 0; (* area(F, S) *)
  Mul 50 47; Mul 50 49; Sub 1 0; Add 249 0; Mul 52 41; Mul 52 43; Sub 1 0; Add 3 0; Mul 46 35;
  Mul 46 37; Sub 1 0; Add 3 0; Mul 40 29; Mul 40 31; Sub 1 0; Add 3 0; Mul 0 267; Mul 135 135;
  Div 0 230; Mul 0 268; Mul 165 165; Div 0 234; Mul 0 271; Sub 3 0; Mul 7 77; Sub 0 1;
  ShowZero 0 (* area(S) *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** H = 0 with any image; size 1.
    Code: src/construct/hexagonal.rs, src/construct/packing.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Unknown 0;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Div 2 0; Sub 3 2; Mul 0 1; Unknown 1; Unknown 2; Mul 2 1; Sub 1 0;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Mul 4 2; Sub 0 4;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Unknown 3; Sub 0 2;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Mul 8 1; Sub 0 7;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Unknown 4;
  Nonzero 0; (* the steps that are divided by are not 0 *)
  Unknown 5;
  Nonzero 0; (* the steps that are divided by are not 0 *)
  Mul 8 6; Unknown 6; Mul 0 1; Div 0 4;
  Nonzero 0; (* C is not 0 and no step of M *)
  Mul 8 6; Unknown 7; Mul 0 1; Div 0 7;
  Nonzero 0; (* C is not 0 and no step of M *)
  Constant 2; Mul 27 0; Mul 0 24; Constant 0; Mul 24 29; Mul 2 1; Sub 1 0; Mul 4 32; Mul 28 4;
  Add 1 0; Mul 30 3; Mul 8 1; Sub 1 0; Mul 10 6; Mul 34 4; Add 1 0; Div 41 30; Mul 0 21;
  Div 43 34; Mul 0 23; Div 45 32; Mul 0 21; Mul 4 15; Mul 5 13; Mul 4 11; Mul 5 9; Mul 4 19;
  Mul 5 17; Sub 5 3; Sub 5 3; Sub 3 5; Sub 3 5; Mul 3 0; Mul 3 2; Sub 1 0; Add 31 0;
  Nonzero 0; (* the first corners of a face are not on a line *)
  Sub 38 42;
  Zero 0; (* C is the same for all steps *)
  ShowNonzero 44; (* as a test finds *)
  ShowNonzero 40; (* as a test finds *)
  ShowNonzero 34; (* as src/construct/hexagonal.rs finds *)
  Sub 33 41; Mul 57 20; Add 0 35; Mul 58 20; Add 0 3; Sub 4 42; Mul 56 21; Add 0 1; Sub 5 3;
  Sub 1 4; Div 72 12; Mul 2 16; Mul 19 2; Sub 1 0; Mul 0 3; Mul 23 5; Mul 7 22; Sub 1 0; Mul 0 7;
  Mul 4 31; Mul 1 31; Add 1 0; Sub 17 0; Add 1 0; Sub 19 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 39; Mul 7 39; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 40; Mul 12 40; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 97 82; Mul 0 73; Mul 92 0; Add 0 37; Mul 2 63; Mul 3 61; Mul 26 1; Mul 23 1; Add 1 0;
  Add 0 21; Sub 6 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 103 70; Mul 81 68; Sub 1 0; Mul 83 73; Mul 107 71; Add 1 0; Mul 67 3; Mul 68 1; Mul 39 1;
  Mul 36 1; Add 1 0; Add 0 34; Sub 50 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 78 10; Mul 79 8; Mul 46 1; Mul 43 1; Add 1 0; Add 0 41; Sub 62 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 99 112; Mul 87 113; Mul 124 0; Add 0 102; Mul 88 116; Mul 126 0; Add 0 5; Mul 5 103;
  Mul 6 101; Mul 4 99; Mul 5 97; Mul 133 133; Constant (-1); Div 0 115; Mul 2 0; Add 11 0;
  Add 9 1; Mul 68 7; Mul 65 7; Add 1 0; Sub 3 0; Mul 72 13; Mul 69 13; Add 1 0; Add 0 3; Sub 9 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 25 137; Mul 109 138; Mul 144 0; Add 0 2; Mul 2 126; Mul 3 124; Add 2 17; Mul 84 2; Mul 81 2;
  Add 1 0; Add 0 15; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 68 149; Mul 160 0; Add 0 39; Mul 2 131; Mul 3 129; Add 2 28; Mul 95 2; Mul 92 2; Add 1 0;
  Add 0 26; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 21 66; Mul 22 64; Mul 102 1; Mul 99 1; Add 1 0; Add 0 33; Sub 22 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 54 73; Mul 55 71; Mul 109 1; Mul 106 1; Add 1 0; Add 0 40; Sub 46 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 55 53; Sub 55 53; Sub 34 55; Sub 34 55; Mul 141 0; Mul 141 2; Sub 1 0; Mul 6 141; Mul 6 143;
  Sub 1 0; Add 3 0; Add 173 0; Sub 101 153; Sub 101 153; Sub 35 67; Sub 35 67; Mul 151 0;
  Mul 151 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Sub 100 165; Sub 100 165;
  Sub 39 79; Sub 39 79; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5; Mul 16 7; Sub 1 0; Add 3 0;
  Add 11 0; Sub 105 177; Sub 105 177; Sub 44 91; Sub 44 91; Mul 15 0; Mul 15 2; Sub 1 0; Mul 16 5;
  Mul 16 7; Sub 1 0; Add 3 0; Add 11 0; Constant 4; Div 240 0; Mul 2 0;
  ShowZero 0 (* area(F, S) *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** H constant; size 1.
    Code: src/construct/hexagonal.rs, src/construct/packing.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_3_size_1 : list step := [
  Unknown 0;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Div 2 0; Sub 3 2; Mul 0 1; Unknown 1; Unknown 2; Mul 2 1; Sub 1 0;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Mul 4 2; Sub 0 4;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Unknown 3; Sub 0 2;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Mul 8 1; Sub 0 7;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Unknown 4;
  Nonzero 0; (* the steps that are divided by are not 0 *)
  Unknown 5;
  Nonzero 0; (* the steps that are divided by are not 0 *)
  Constant 2; Mul 19 0; Mul 0 16; Constant 0; Mul 16 21; Mul 2 1; Sub 1 0; Mul 4 24; Mul 20 4;
  Add 1 0; Mul 22 3; Mul 8 1; Sub 1 0; Mul 10 6; Mul 26 4; Add 1 0; Div 33 22; Mul 0 18;
  Div 35 26; Mul 0 20; Div 37 24; Mul 0 21; Mul 4 15; Mul 5 13; Mul 4 11; Mul 5 9; Mul 4 19;
  Mul 5 17; Sub 5 3; Sub 5 3; Sub 3 5; Sub 3 5; Mul 3 0; Mul 3 2; Sub 1 0; Add 31 0;
  Nonzero 0; (* the first corners of a face are not on a line *)
  Unknown 6; Unknown 7; Sub 0 1;
  Zero 0; (* C is the same for all steps *)
  Mul 47 45;
  ShowNonzero 0; (* as a test finds *)
  Mul 44 42;
  ShowNonzero 0; (* as a test finds *)
  ShowNonzero 38; (* as src/construct/hexagonal.rs finds *)
  Sub 37 42; Mul 53 24; Add 0 39; Mul 54 24; Add 0 3; Sub 4 46; Mul 52 25; Add 0 1; Sub 5 3;
  Sub 1 4; Div 68 16; Mul 2 20; Mul 23 2; Sub 1 0; Mul 0 3; Mul 27 5; Mul 7 26; Sub 1 0; Mul 0 7;
  Mul 4 35; Mul 1 35; Add 1 0; Sub 17 0; Add 1 0; Sub 19 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 43; Mul 7 43; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 44; Mul 12 44; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 93 78; Mul 0 77; Mul 88 0; Add 0 37; Mul 2 67; Mul 3 65; Mul 26 1; Mul 23 1; Add 1 0;
  Add 0 21; Sub 6 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 99 74; Mul 85 72; Sub 1 0; Mul 87 77; Mul 103 75; Add 1 0; Mul 71 3; Mul 72 1; Mul 39 1;
  Mul 36 1; Add 1 0; Add 0 34; Sub 50 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 82 10; Mul 83 8; Mul 46 1; Mul 43 1; Add 1 0; Add 0 41; Sub 62 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Unknown 8; Mul 71 68; Div 0 110; Mul 2 111; Add 0 1; Sub 108 0; Mul 96 1; Mul 125 0; Add 0 111;
  Mul 97 4; Mul 127 0; Add 0 5; Mul 5 112; Mul 6 110; Mul 4 108; Mul 5 106; Mul 134 134;
  Constant (-1); Div 0 124; Mul 2 0; Add 11 0; Add 9 1; Mul 73 7; Mul 70 7; Add 1 0; Sub 3 0;
  Mul 77 13; Mul 74 13; Add 1 0; Add 0 3; Sub 9 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 100 97; Div 0 139; Mul 32 140; Add 0 1; Sub 29 0; Mul 122 1; Mul 149 0; Add 0 2; Mul 2 139;
  Mul 3 137; Add 2 21; Mul 93 2; Mul 90 2; Add 1 0; Add 0 19; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 77 12; Mul 165 0; Add 0 43; Mul 2 144; Mul 3 142; Add 2 32; Mul 104 2; Mul 101 2; Add 1 0;
  Add 0 30; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 21 75; Mul 22 73; Mul 111 1; Mul 108 1; Add 1 0; Add 0 37; Sub 22 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 58 82; Mul 59 80; Mul 118 1; Mul 115 1; Add 1 0; Add 0 44; Sub 50 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 59 57; Sub 59 57; Sub 34 59; Sub 34 59; Mul 154 0; Mul 154 2; Sub 1 0; Mul 6 154; Mul 6 156;
  Sub 1 0; Add 3 0; Add 186 0; Sub 110 166; Sub 110 166; Sub 35 71; Sub 35 71; Mul 164 2;
  Mul 164 4; Sub 1 0; Add 162 0; Mul 168 4; Mul 168 6; Sub 1 0; Mul 20 9; Mul 20 11; Sub 1 0;
  Add 3 0; Add 15 0; Sub 113 182; Sub 113 182; Sub 43 87; Sub 43 87; Mul 19 2; Mul 19 4; Sub 1 0;
  Add 15 0; Mul 23 4; Mul 23 6; Sub 1 0; Mul 24 9; Mul 24 11; Sub 1 0; Add 3 0; Add 15 0;
  Sub 122 198; Sub 122 198; Sub 52 103; Sub 52 103; Mul 19 2; Mul 19 4; Sub 1 0; Add 15 0;
  Mul 23 4; Mul 23 6; Sub 1 0; Mul 24 9; Mul 24 11; Sub 1 0; Add 3 0; Add 15 0; Mul 8 238;
  Constant 4; Div 258 0; Mul 3 0; Mul 3 1; Mul 0 136; Sub 2 0;
  ShowZero 0 (* area(F, S) = H area(F) *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** K = k² constant; size 1.
    Code: src/construct/hexagonal.rs, src/construct/packing.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_4_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Div 2 0; Sub 3 2; Mul 0 1; Unknown 1; Unknown 2; Mul 2 1; Sub 1 0;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Mul 4 2; Sub 0 4;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Unknown 3; Sub 0 2;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Mul 8 1; Sub 0 7;
  Nonzero 0; (* A and B are not 0 between consecutive rings *)
  Unknown 4;
  Nonzero 0; (* the steps that are divided by are not 0 *)
  Unknown 5;
  Nonzero 0; (* the steps that are divided by are not 0 *)
  Mul 18 19; Mul 0 15; Mul 10 8; Mul 7 5; Unknown 6; Div 22 24; Mul 1 3; Div 0 8; Mul 3 4;
  Div 0 9; Add 11 2; Mul 0 5; Add 12 2; Mul 0 7; Constant 0; Mul 27 32; Mul 14 1; Sub 1 0;
  Mul 16 35; Mul 31 4; Add 1 0; Mul 33 3; Mul 20 1; Sub 1 0; Mul 22 6; Mul 37 4; Add 1 0;
  Div 44 33; Mul 0 16; Div 46 37; Mul 0 18; Div 48 35; Mul 0 18; Mul 4 15; Mul 5 13; Mul 4 11;
  Mul 5 9; Mul 4 19; Mul 5 17; Sub 5 3; Sub 5 3; Sub 3 5; Sub 3 5; Mul 3 0; Mul 3 2; Sub 1 0;
  Add 31 0;
  Nonzero 0; (* the first corners of a face are not on a line *)
  ShowNonzero 44; (* as a test finds *)
  ShowNonzero 43; (* as a test finds *)
  ShowNonzero 45; (* as src/construct/hexagonal.rs finds *)
  Sub 32 35; Mul 59 19; Add 0 34; Mul 60 19; Add 0 3; Sub 4 38; Mul 58 20; Add 0 1; Sub 5 3;
  Sub 1 4; Div 74 11; Mul 2 15; Mul 18 2; Sub 1 0; Mul 0 3; Mul 22 5; Mul 7 21; Sub 1 0; Mul 0 7;
  Mul 4 30; Mul 1 30; Add 1 0; Sub 17 0; Add 1 0; Sub 19 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 38; Mul 7 38; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 39; Add 1 0; Add 0 10; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 99 84; Mul 0 69; Mul 94 0; Add 0 37; Mul 2 62; Mul 3 60; Mul 26 1; Mul 23 1; Add 1 0;
  Add 0 21; Sub 6 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 105 69; Mul 92 67; Sub 1 0; Mul 94 72; Mul 109 70; Add 1 0; Mul 66 3; Mul 67 1; Mul 39 1;
  Mul 36 1; Add 1 0; Add 0 34; Sub 50 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 77 10; Mul 78 8; Mul 46 1; Mul 43 1; Add 1 0; Add 0 41; Sub 62 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Unknown 7; Sub 106 115; Mul 1 0; Mul 0 110; Sub 102 0; Mul 90 1; Mul 130 0; Add 0 105; Mul 91 4;
  Mul 132 0; Add 0 5; Mul 5 106; Mul 6 104; Mul 4 102; Mul 5 100; Mul 139 139; Constant (-1);
  Div 0 149; Mul 2 0; Add 11 0; Add 9 1; Mul 72 7; Mul 69 7; Add 1 0; Sub 3 0; Mul 76 13;
  Mul 73 13; Add 1 0; Add 0 3; Sub 9 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 133 143; Mul 30 0; Mul 0 139; Sub 28 0; Mul 115 1; Mul 153 0; Add 0 2; Mul 2 132; Mul 3 130;
  Add 2 20; Mul 91 2; Mul 88 2; Add 1 0; Add 0 18; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 75 12; Mul 169 0; Add 0 42; Mul 2 137; Mul 3 135; Add 2 31; Mul 102 2; Mul 99 2; Add 1 0;
  Add 0 29; Sub 4 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 21 73; Mul 22 71; Mul 109 1; Mul 106 1; Add 1 0; Add 0 36; Sub 22 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 57 80; Mul 58 78; Mul 116 1; Mul 113 1; Add 1 0; Add 0 43; Sub 49 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 58 56; Sub 58 56; Sub 34 58; Sub 34 58; Mul 3 0; Mul 3 2; Sub 1 0; Add 175 0; Sub 104 155;
  Sub 104 155; Sub 31 66; Sub 31 66; Mul 153 2; Mul 153 4; Sub 1 0; Add 151 0; Mul 13 4; Mul 13 6;
  Sub 1 0; Add 11 0; Sub 103 167; Sub 103 167; Sub 35 78; Sub 35 78; Mul 15 2; Mul 15 4; Sub 1 0;
  Add 11 0; Mul 17 4; Mul 17 6; Sub 1 0; Add 11 0; Sub 108 179; Sub 108 179; Sub 40 90; Sub 40 90;
  Mul 15 2; Mul 15 4; Sub 1 0; Add 11 0; Mul 17 4; Mul 17 6; Sub 1 0; Add 11 0; Mul 4 246;
  Mul 1 247; Constant 4; Div 247 0; Mul 2 0; Mul 4 1; Mul 119 119; Mul 1 0; Sub 3 0;
  ShowZero 0 (* area(S) = k² area(F) *)
].

Theorem part_4_size_1_valid : valid part_4_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
