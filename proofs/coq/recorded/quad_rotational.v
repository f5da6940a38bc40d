(** quad-rotational (ours)

    Rotational meshes of quads have first integrals in the radii r, r' of rings of M and S, with
    any sector.

        H constant: rr' - Hr² = C,  K constant: r² - r'²/K = C

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** H constant; size 1.
    Code: src/construct/packing.rs, src/construct/rotational.rs, src/pair/area.rs,
    src/pair/face.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/motion.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0;
  Nonzero 0; (* the sine of a sector is not 0 *)
  Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 1;
  Nonzero 0; (* the radii and parameters that are divided by are not 0 *)
  Unknown 2;
  Nonzero 0; (* the radii and parameters that are divided by are not 0 *)
  Div 4 2; Sub 5 4; Mul 0 1; Constant 2; Mul 9 0; Mul 0 4; Constant 0; Mul 4 11; Mul 2 1; Sub 1 0;
  Mul 4 14; Mul 8 4; Add 1 0; Mul 14 17; Mul 15 7; Mul 15 19; Mul 16 9; Mul 17 7; Mul 18 5;
  Sub 3 5; Sub 3 5; Sub 3 7; Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0; Add 19 0;
  Nonzero 0; (* the first corners of a face are not on a line *)
  ShowNonzero 21; (* as src/construct/rotational.rs finds *)
  Unknown 3; Unknown 4; Mul 1 30; Div 1 31; Add 1 0; Mul 4 32; Div 4 33; Add 1 0; Div 39 31;
  Add 4 1; Mul 0 1; Sub 38 39; Mul 1 0; Add 33 0; Sub 0 34; Div 46 16; Mul 1 20; Mul 23 2;
  Sub 1 0; Mul 0 3; Mul 27 5; Mul 6 26; Sub 1 0; Mul 0 7; Mul 4 37; Mul 1 37; Add 1 0; Sub 47 0;
  Add 1 0; Sub 49 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 41; Mul 7 41; Add 1 0; Add 0 5; Sub 20 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 44; Mul 12 44; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 68 57; Mul 69 55; Mul 22 1; Mul 19 1; Add 1 0; Add 0 17; Sub 66 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 42 78; Mul 43 68; Mul 44 44; Mul 0 41; Mul 43 82; Mul 44 72; Mul 45 45; Mul 0 45; Mul 35 7;
  Mul 32 7; Add 1 0; Sub 7 0; Mul 39 7; Mul 36 7; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 56 81; Mul 57 79; Mul 46 1; Mul 43 1; Add 1 0; Add 0 10; Sub 15 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 66 88; Mul 67 86; Mul 53 1; Mul 50 1; Add 1 0; Add 0 17; Sub 26 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 106 73; Mul 107 107; Mul 79 0; Sub 2 0; Sub 0 80;
  ShowZero 0; (* rr' - Hr² *)
  Mul 110 75; Mul 111 111; Mul 84 0; Sub 2 0; Sub 0 85;
  ShowZero 0; (* rr' - Hr² *)
  Sub 36 40; Sub 36 40; Sub 25 42; Sub 25 42; Mul 99 0; Mul 99 2; Sub 1 0; Mul 6 99; Mul 6 101;
  Sub 1 0; Add 3 0; Add 119 0; Sub 59 113; Sub 59 113; Sub 30 54; Sub 30 54; Mul 109 2; Mul 109 4;
  Sub 1 0; Add 107 0; Mul 113 4; Mul 113 6; Sub 1 0; Mul 20 9; Mul 20 11; Sub 1 0; Add 3 0;
  Add 15 0; Mul 8 139; Constant 4; Div 149 0; Mul 3 0; Mul 3 1; Mul 0 120; Sub 2 0;
  ShowZero 0 (* area(F, S) = H area(F) *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** K = k²; size 1.
    Code: src/construct/packing.rs, src/construct/rotational.rs, src/pair/area.rs,
    src/pair/face.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/motion.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the sine of a sector is not 0 *)
  Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 1;
  Nonzero 0; (* the radii and parameters that are divided by are not 0 *)
  Unknown 2;
  Nonzero 0; (* the radii and parameters that are divided by are not 0 *)
  Unknown 3;
  Nonzero 0; (* the radii and parameters that are divided by are not 0 *)
  Div 5 3; Sub 6 5; Mul 0 1; Mul 9 10; Mul 0 3; Unknown 4; Div 11 13; Div 1 8; Add 9 0; Mul 0 2;
  Div 0 12; Div 5 11; Add 12 0; Mul 0 6; Div 0 16; Constant 0; Mul 13 21; Mul 12 1; Sub 1 0;
  Mul 14 24; Mul 17 4; Add 1 0; Mul 11 27; Mul 12 7; Mul 9 29; Mul 10 9; Mul 11 7; Mul 12 5;
  Sub 3 5; Sub 3 5; Sub 3 7; Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0; Add 19 0;
  Nonzero 0; (* the first corners of a face are not on a line *)
  ShowNonzero 31; (* as src/construct/rotational.rs finds *)
  Sub 37 28; Mul 0 30; Sub 38 26; Mul 0 32; Add 2 0; Mul 0 34; Sub 27 31; Mul 1 0; Add 28 0;
  Sub 0 29; Div 51 11; Mul 1 15; Mul 18 2; Sub 1 0; Mul 0 3; Mul 22 5; Mul 6 21; Sub 1 0; Mul 0 7;
  Mul 4 32; Mul 1 32; Add 1 0; Sub 42 0; Add 1 0; Sub 44 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 36; Mul 7 36; Add 1 0; Add 0 5; Sub 20 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 39; Mul 12 39; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 60 52; Mul 61 50; Mul 22 1; Mul 19 1; Add 1 0; Add 0 17; Sub 61 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 40 83; Mul 41 63; Mul 42 42; Mul 0 74; Mul 42 87; Mul 43 67; Mul 44 44; Mul 0 78; Mul 35 7;
  Mul 32 7; Add 1 0; Sub 7 0; Mul 39 7; Mul 36 7; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 55 76; Mul 56 74; Mul 46 1; Mul 43 1; Add 1 0; Add 0 10; Sub 15 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 64 83; Mul 65 81; Mul 53 1; Mul 50 1; Add 1 0; Add 0 17; Sub 26 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 111 111; Mul 99 99; Mul 1 0; Sub 0 31; Sub 0 107;
  ShowZero 0; (* k² r² - r'² *)
  Mul 99 99; Mul 5 0; Sub 0 31; Sub 0 111;
  ShowZero 0; (* k² r² - r'² *)
  Sub 35 39; Sub 35 39; Sub 24 41; Sub 24 41; Mul 3 0; Mul 3 2; Sub 1 0; Add 109 0; Sub 54 103;
  Sub 54 103; Sub 25 49; Sub 25 49; Mul 99 2; Mul 99 4; Sub 1 0; Add 97 0; Mul 13 4; Mul 13 6;
  Sub 1 0; Add 11 0; Mul 4 145; Mul 1 146; Constant 4; Div 146 0; Mul 2 0; Mul 4 1; Mul 0 34;
  Sub 2 0;
  ShowZero 0 (* area(S) = k² area(F) *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** K = -k²; size 1.
    Code: src/construct/packing.rs, src/construct/rotational.rs, src/pair/area.rs,
    src/pair/face.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/motion.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_3_size_1 : list step := [
  Unknown 0;
  Nonzero 0; (* the sine of a sector is not 0 *)
  Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 1;
  Nonzero 0; (* the radii and parameters that are divided by are not 0 *)
  Unknown 2; Mul 0 0; Add 5 0;
  Nonzero 0; (* 1 + u² is not 0 *)
  Unknown 3; Mul 0 0; Add 8 0;
  Nonzero 0; (* 1 + u² is not 0 *)
  Div 9 7; Sub 10 9; Mul 0 1; Constant 2; Mul 14 0; Mul 0 4; Unknown 4; Div 16 10; Sub 17 12;
  Mul 0 1; Mul 3 0; Div 0 17; Div 21 12; Sub 22 14; Mul 0 1; Mul 8 0; Div 0 22; Constant 0;
  Mul 15 27; Mul 13 1; Sub 1 0; Mul 15 30; Mul 19 4; Add 1 0; Mul 12 33; Mul 13 7; Mul 9 35;
  Mul 10 9; Mul 11 7; Mul 12 5; Sub 3 5; Sub 3 5; Sub 3 7; Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Add 19 0;
  Nonzero 0; (* the first corners of a face are not on a line *)
  ShowNonzero 32; (* as src/construct/rotational.rs finds *)
  Mul 43 34; Mul 0 31; Mul 33 0; Mul 43 37; Mul 0 29; Mul 36 0; Div 53 40; Add 4 1; Mul 0 1;
  Sub 30 35; Mul 1 0; Add 31 0; Sub 0 32; Div 60 14; Mul 1 18; Mul 21 2; Sub 1 0; Mul 0 3;
  Mul 25 5; Mul 6 24; Sub 1 0; Mul 0 7; Mul 4 35; Mul 1 35; Add 1 0; Sub 45 0; Add 1 0; Sub 47 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 39; Mul 7 39; Add 1 0; Add 0 5; Sub 20 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 42; Mul 12 42; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 64 55; Mul 65 53; Mul 22 1; Mul 19 1; Add 1 0; Add 0 17; Sub 64 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 42 92; Mul 43 66; Mul 44 44; Mul 0 41; Mul 43 96; Mul 44 70; Mul 45 45; Mul 0 45; Mul 35 7;
  Mul 32 7; Add 1 0; Sub 7 0; Mul 39 7; Mul 36 7; Add 1 0; Add 0 3; Sub 8 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 56 79; Mul 57 77; Mul 46 1; Mul 43 1; Add 1 0; Add 0 10; Sub 15 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 66 86; Mul 67 84; Mul 53 1; Mul 50 1; Add 1 0; Add 0 17; Sub 26 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 120 120; Mul 103 103; Mul 1 0; Add 0 31; Mul 111 111; Sub 1 0;
  ShowZero 0; (* k² r² + r'² *)
  Mul 103 103; Mul 6 0; Add 0 32; Sub 0 4;
  ShowZero 0; (* k² r² + r'² *)
  Sub 36 40; Sub 36 40; Sub 25 42; Sub 25 42; Mul 3 0; Mul 3 2; Sub 1 0; Add 113 0; Sub 55 107;
  Sub 55 107; Sub 26 50; Sub 26 50; Mul 103 2; Mul 103 4; Sub 1 0; Add 101 0; Mul 13 4; Mul 13 6;
  Sub 1 0; Add 11 0; Mul 4 140; Mul 1 141; Constant 4; Div 156 0; Mul 3 0; Mul 0 34; Neg 0;
  Mul 5 3; Sub 0 1;
  ShowZero 0 (* area(S) = -k² area(F) *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
