(** thm-1-v (Sec. 3.2, Theorem 1)

    A planar mesh is i-circular iff its lift to Σ has planar faces: the in-circle determinant of
    four top views is, up to its sign, twice the determinant of the lifted points, six times their
    volume. Then the lift is the only inscribed v-parallel mesh.

        in-circle determinant = -2 det(s₁ - s₀, s₂ - s₀, s₃ - s₀)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the volume; size 4.
    Code: src/net/scribed.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs, src/space/sphere.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Constant 1; Constant 0; Mul 9 9; Mul 9 9; Add 1 0; Mul 4 0; Div 5 14; Mul 1 0; Mul 6 15;
  Mul 7 15; Add 1 0; Add 0 9; Add 4 0; Mul 18 18; Mul 18 18; Add 1 0; Mul 15 0; Mul 0 10;
  Mul 16 23; Mul 17 23; Add 1 0; Add 0 19; Add 4 0; Mul 26 26; Mul 26 26; Add 1 0; Mul 25 0;
  Mul 0 20; Mul 26 31; Mul 27 31; Add 1 0; Add 0 29; Add 4 0; Mul 34 34; Mul 34 34; Add 1 0;
  Mul 35 0; Mul 0 30; Mul 36 39; Mul 37 39; Add 1 0; Add 0 39; Add 4 0; Sub 48 50; Sub 48 50;
  Sub 22 32; Sub 49 53; Sub 49 53; Sub 15 35; Sub 50 56; Sub 50 56; Sub 8 38; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0;
  Mul 18 3; Add 1 0; Mul 22 22; Mul 22 22; Add 1 0; Mul 22 22; Mul 22 22; Add 1 0; Mul 22 22;
  Mul 22 22; Add 1 0; Mul 24 3; Mul 1 28; Sub 1 0; Mul 3 31; Mul 29 7; Sub 1 0; Mul 31 33;
  Mul 31 35; Sub 1 0; Mul 40 6; Mul 40 4; Add 1 0; Mul 18 3; Add 1 0; Constant (-2); Mul 24 0;
  Sub 0 2;
  ShowZero 0; (* volume *)
  Mul 79 91; Add 0 0; Sub 0 89;
  ShowZero 0; (* on Σ *)
  Mul 72 94; Add 0 0; Sub 0 81;
  ShowZero 0; (* on Σ *)
  Mul 65 97; Add 0 0; Sub 0 74;
  ShowZero 0; (* on Σ *)
  Mul 58 100; Add 0 0; Sub 0 67;
  ShowZero 0 (* on Σ *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** one face with k corners; size 4.
    Code: src/net/scribed.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 10 10; Mul 10 10; Add 1 0; Mul 11 11; Mul 11 11;
  Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 17; Sub 1 0; Mul 3 20; Mul 14 7; Sub 1 0;
  Mul 16 22; Mul 16 24; Sub 1 0; Mul 28 6; Mul 28 4; Add 1 0; Mul 18 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Sub 39 39;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 39 39;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 39 39;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 39 39;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 39 39;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 39 39;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 32 32;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 32 32;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 8; Unknown 9; Unknown 10; Mul 2 50; Mul 2 50; Add 1 0; Add 0 3; Mul 6 52; Mul 6 52;
  Add 1 0; Add 0 7; Mul 10 54; Mul 10 54; Add 1 0; Add 0 11; Sub 4 8; Sub 1 9; Constant 1;
  Div 0 53; Mul 3 57; Mul 60 3; Sub 1 0; Mul 0 3; Mul 64 6; Mul 8 63; Sub 1 0; Mul 0 7; Mul 4 74;
  Mul 1 74; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 78; Mul 7 78; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 81; Mul 12 81; Add 1 0; Add 0 10; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 42 77; Mul 42 77; Add 1 0; Add 0 43; Mul 24 81; Mul 21 81; Add 1 0; Add 0 19; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Constant 0; Mul 100 100; Mul 100 100; Add 1 0; Mul 38 0; Div 39 105; Mul 1 0; Mul 6 106;
  Mul 7 106; Add 1 0; Add 0 9; Add 4 0; Mul 109 109; Mul 109 109; Add 1 0; Mul 49 0; Mul 0 10;
  Mul 16 114; Mul 17 114; Add 1 0; Add 0 19; Add 4 0; Mul 117 117; Mul 117 117; Add 1 0; Mul 59 0;
  Mul 0 20; Mul 26 122; Mul 27 122; Add 1 0; Add 0 29; Add 4 0; Sub 10 20; Sub 1 21; Mul 1 124;
  Mul 127 1; Sub 1 0; Mul 0 70; Mul 131 4; Mul 6 130; Sub 1 0; Mul 0 74; Mul 4 141; Mul 1 141;
  Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 145; Mul 7 145; Add 1 0; Add 0 5; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 148; Mul 12 148; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 144 144; Mul 144 144; Add 1 0; Mul 95 0; Mul 0 56; Mul 62 149; Mul 63 149; Add 1 0;
  Add 0 65; Add 4 0; Mul 30 154; Mul 27 154; Add 1 0; Add 0 25; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 132 132; Mul 132 132; Add 1 0; Sub 0 75;
  ShowZero 0; (* the same top view *)
  Mul 65 111; Add 0 0; Sub 0 75;
  ShowZero 0; (* on Σ *)
  Mul 137 137; Mul 137 137; Add 1 0; Sub 0 82;
  ShowZero 0; (* the same top view *)
  Mul 62 118; Add 0 0; Sub 0 71;
  ShowZero 0; (* on Σ *)
  Mul 142 142; Mul 142 142; Add 1 0; Sub 0 89;
  ShowZero 0; (* the same top view *)
  Mul 59 125; Add 0 0; Sub 0 68;
  ShowZero 0; (* on Σ *)
  Mul 147 147; Mul 147 147; Add 1 0; Sub 0 96;
  ShowZero 0; (* the same top view *)
  Mul 30 132; Add 0 0; Sub 0 39;
  ShowZero 0 (* on Σ *)
].

Theorem part_2_size_4_valid : valid part_2_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** one face with k corners; size 5.
    Code: src/net/scribed.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_5 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 10 10; Mul 10 10; Add 1 0; Mul 11 11; Mul 11 11;
  Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 17; Sub 1 0; Mul 3 20; Mul 14 7; Sub 1 0;
  Mul 16 22; Mul 16 24; Sub 1 0; Mul 28 6; Mul 28 4; Add 1 0; Mul 18 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 8; Unknown 9; Sub 1 41; Sub 1 41; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 24; Mul 1 38;
  Sub 1 0; Mul 3 41; Mul 8 28; Sub 1 0; Mul 10 43; Mul 10 45; Sub 1 0; Mul 49 6; Mul 49 4;
  Add 1 0; Mul 39 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Sub 60 60;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 60 60;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 60 60;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 60 60;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 60 60;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 60 60;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 53 53;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 53 53;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 28 28;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 28 28;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 10; Unknown 11; Unknown 12; Mul 2 73; Mul 2 73; Add 1 0; Add 0 3; Mul 6 75; Mul 6 75;
  Add 1 0; Add 0 7; Mul 10 77; Mul 10 77; Add 1 0; Add 0 11; Sub 4 8; Sub 1 9; Constant 1;
  Div 0 76; Mul 3 80; Mul 83 3; Sub 1 0; Mul 0 3; Mul 87 6; Mul 8 86; Sub 1 0; Mul 0 7; Mul 4 97;
  Mul 1 97; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 101; Mul 7 101; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 104; Mul 12 104; Add 1 0; Add 0 10; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 42 100; Mul 42 100; Add 1 0; Add 0 43; Mul 24 104; Mul 21 104; Add 1 0; Add 0 19; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 51 82; Mul 51 82; Add 1 0; Add 0 52; Mul 33 86; Mul 30 86; Add 1 0; Add 0 28; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Constant 0; Mul 132 132; Mul 132 132; Add 1 0; Mul 47 0; Div 48 137; Mul 1 0; Mul 6 138;
  Mul 7 138; Add 1 0; Add 0 9; Add 4 0; Mul 141 141; Mul 141 141; Add 1 0; Mul 58 0; Mul 0 10;
  Mul 16 146; Mul 17 146; Add 1 0; Add 0 19; Add 4 0; Mul 149 149; Mul 149 149; Add 1 0; Mul 68 0;
  Mul 0 20; Mul 26 154; Mul 27 154; Add 1 0; Add 0 29; Add 4 0; Sub 10 20; Sub 1 21; Mul 1 156;
  Mul 159 1; Sub 1 0; Mul 0 79; Mul 163 4; Mul 6 162; Sub 1 0; Mul 0 83; Mul 4 173; Mul 1 173;
  Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 177; Mul 7 177; Add 1 0; Add 0 5; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 180; Mul 12 180; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 176 176; Mul 176 176; Add 1 0; Mul 104 0; Mul 0 56; Mul 62 181; Mul 63 181; Add 1 0;
  Add 0 65; Add 4 0; Mul 30 186; Mul 27 186; Add 1 0; Add 0 25; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 164 164; Mul 164 164; Add 1 0; Mul 119 0; Mul 0 71; Mul 77 169; Mul 78 169; Add 1 0;
  Add 0 80; Add 4 0; Mul 45 174; Mul 42 174; Add 1 0; Add 0 40; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 158 158; Mul 158 158; Add 1 0; Sub 0 90;
  ShowZero 0; (* the same top view *)
  Mul 80 135; Add 0 0; Sub 0 90;
  ShowZero 0; (* on Σ *)
  Mul 163 163; Mul 163 163; Add 1 0; Sub 0 97;
  ShowZero 0; (* the same top view *)
  Mul 77 142; Add 0 0; Sub 0 86;
  ShowZero 0; (* on Σ *)
  Mul 168 168; Mul 168 168; Add 1 0; Sub 0 104;
  ShowZero 0; (* the same top view *)
  Mul 74 149; Add 0 0; Sub 0 83;
  ShowZero 0; (* on Σ *)
  Mul 173 173; Mul 173 173; Add 1 0; Sub 0 111;
  ShowZero 0; (* the same top view *)
  Mul 45 156; Add 0 0; Sub 0 54;
  ShowZero 0; (* on Σ *)
  Mul 178 178; Mul 178 178; Add 1 0; Sub 0 118;
  ShowZero 0; (* the same top view *)
  Mul 37 163; Add 0 0; Sub 0 46;
  ShowZero 0 (* on Σ *)
].

Theorem part_2_size_5_valid : valid part_2_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** one face with k corners; size 6.
    Code: src/net/scribed.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_6 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 10 10; Mul 10 10; Add 1 0; Mul 11 11; Mul 11 11;
  Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 17; Sub 1 0; Mul 3 20; Mul 14 7; Sub 1 0;
  Mul 16 22; Mul 16 24; Sub 1 0; Mul 28 6; Mul 28 4; Add 1 0; Mul 18 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 8; Unknown 9; Sub 1 41; Sub 1 41; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 24; Mul 1 38;
  Sub 1 0; Mul 3 41; Mul 8 28; Sub 1 0; Mul 10 43; Mul 10 45; Sub 1 0; Mul 49 6; Mul 49 4;
  Add 1 0; Mul 39 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 10; Unknown 11; Sub 1 62; Sub 1 62; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 45; Mul 1 59;
  Sub 1 0; Mul 3 62; Mul 8 49; Sub 1 0; Mul 10 64; Mul 10 66; Sub 1 0; Mul 70 6; Mul 70 4;
  Add 1 0; Mul 60 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Sub 81 81;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 81 81;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 81 81;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 81 81;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 81 81;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 81 81;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 74 74;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 74 74;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 49 49;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 49 49;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 30 30;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 30 30;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 12; Unknown 13; Unknown 14; Mul 2 96; Mul 2 96; Add 1 0; Add 0 3; Mul 6 98; Mul 6 98;
  Add 1 0; Add 0 7; Mul 10 100; Mul 10 100; Add 1 0; Add 0 11; Sub 4 8; Sub 1 9; Constant 1;
  Div 0 99; Mul 3 103; Mul 106 3; Sub 1 0; Mul 0 3; Mul 110 6; Mul 8 109; Sub 1 0; Mul 0 7;
  Mul 4 120; Mul 1 120; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 124; Mul 7 124; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 127; Mul 12 127; Add 1 0; Add 0 10; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 42 123; Mul 42 123; Add 1 0; Add 0 43; Mul 24 127; Mul 21 127; Add 1 0; Add 0 19; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 51 105; Mul 51 105; Add 1 0; Add 0 52; Mul 33 109; Mul 30 109; Add 1 0; Add 0 28; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 60 93; Mul 60 93; Add 1 0; Add 0 61; Mul 42 97; Mul 39 97; Add 1 0; Add 0 37; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Constant 0; Mul 164 164; Mul 164 164; Add 1 0; Mul 56 0; Div 57 169; Mul 1 0; Mul 6 170;
  Mul 7 170; Add 1 0; Add 0 9; Add 4 0; Mul 173 173; Mul 173 173; Add 1 0; Mul 67 0; Mul 0 10;
  Mul 16 178; Mul 17 178; Add 1 0; Add 0 19; Add 4 0; Mul 181 181; Mul 181 181; Add 1 0; Mul 77 0;
  Mul 0 20; Mul 26 186; Mul 27 186; Add 1 0; Add 0 29; Add 4 0; Sub 10 20; Sub 1 21; Mul 1 188;
  Mul 191 1; Sub 1 0; Mul 0 88; Mul 195 4; Mul 6 194; Sub 1 0; Mul 0 92; Mul 4 205; Mul 1 205;
  Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 209; Mul 7 209; Add 1 0; Add 0 5; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 212; Mul 12 212; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 208 208; Mul 208 208; Add 1 0; Mul 113 0; Mul 0 56; Mul 62 213; Mul 63 213; Add 1 0;
  Add 0 65; Add 4 0; Mul 30 218; Mul 27 218; Add 1 0; Add 0 25; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 196 196; Mul 196 196; Add 1 0; Mul 128 0; Mul 0 71; Mul 77 201; Mul 78 201; Add 1 0;
  Add 0 80; Add 4 0; Mul 45 206; Mul 42 206; Add 1 0; Add 0 40; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 190 190; Mul 190 190; Add 1 0; Mul 143 0; Mul 0 86; Mul 92 195; Mul 93 195; Add 1 0;
  Add 0 95; Add 4 0; Mul 60 200; Mul 57 200; Add 1 0; Add 0 55; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 184 184; Mul 184 184; Add 1 0; Sub 0 105;
  ShowZero 0; (* the same top view *)
  Mul 95 159; Add 0 0; Sub 0 105;
  ShowZero 0; (* on Σ *)
  Mul 189 189; Mul 189 189; Add 1 0; Sub 0 112;
  ShowZero 0; (* the same top view *)
  Mul 92 166; Add 0 0; Sub 0 101;
  ShowZero 0; (* on Σ *)
  Mul 194 194; Mul 194 194; Add 1 0; Sub 0 119;
  ShowZero 0; (* the same top view *)
  Mul 89 173; Add 0 0; Sub 0 98;
  ShowZero 0; (* on Σ *)
  Mul 199 199; Mul 199 199; Add 1 0; Sub 0 126;
  ShowZero 0; (* the same top view *)
  Mul 60 180; Add 0 0; Sub 0 69;
  ShowZero 0; (* on Σ *)
  Mul 204 204; Mul 204 204; Add 1 0; Sub 0 133;
  ShowZero 0; (* the same top view *)
  Mul 52 187; Add 0 0; Sub 0 61;
  ShowZero 0; (* on Σ *)
  Mul 209 209; Mul 209 209; Add 1 0; Sub 0 140;
  ShowZero 0; (* the same top view *)
  Mul 44 194; Add 0 0; Sub 0 53;
  ShowZero 0 (* on Σ *)
].

Theorem part_2_size_6_valid : valid part_2_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** one face with k corners; size 7.
    Code: src/net/scribed.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_7 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 10 10; Mul 10 10; Add 1 0; Mul 11 11; Mul 11 11;
  Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 17; Sub 1 0; Mul 3 20; Mul 14 7; Sub 1 0;
  Mul 16 22; Mul 16 24; Sub 1 0; Mul 28 6; Mul 28 4; Add 1 0; Mul 18 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 8; Unknown 9; Sub 1 41; Sub 1 41; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 24; Mul 1 38;
  Sub 1 0; Mul 3 41; Mul 8 28; Sub 1 0; Mul 10 43; Mul 10 45; Sub 1 0; Mul 49 6; Mul 49 4;
  Add 1 0; Mul 39 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 10; Unknown 11; Sub 1 62; Sub 1 62; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 45; Mul 1 59;
  Sub 1 0; Mul 3 62; Mul 8 49; Sub 1 0; Mul 10 64; Mul 10 66; Sub 1 0; Mul 70 6; Mul 70 4;
  Add 1 0; Mul 60 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 12; Unknown 13; Sub 1 83; Sub 1 83; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 66; Mul 1 80;
  Sub 1 0; Mul 3 83; Mul 8 70; Sub 1 0; Mul 10 85; Mul 10 87; Sub 1 0; Mul 91 6; Mul 91 4;
  Add 1 0; Mul 81 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Sub 102 102;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 102 102;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 102 102;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 102 102;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 102 102;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 102 102;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 95 95;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 95 95;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 70 70;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 70 70;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 51 51;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 51 51;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 32 32;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 32 32;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 14; Unknown 15; Unknown 16; Mul 2 119; Mul 2 119; Add 1 0; Add 0 3; Mul 6 121;
  Mul 6 121; Add 1 0; Add 0 7; Mul 10 123; Mul 10 123; Add 1 0; Add 0 11; Sub 4 8; Sub 1 9;
  Constant 1; Div 0 122; Mul 3 126; Mul 129 3; Sub 1 0; Mul 0 3; Mul 133 6; Mul 8 132; Sub 1 0;
  Mul 0 7; Mul 4 143; Mul 1 143; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 147; Mul 7 147; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 150; Mul 12 150; Add 1 0; Add 0 10; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 42 146; Mul 42 146; Add 1 0; Add 0 43; Mul 24 150; Mul 21 150; Add 1 0; Add 0 19; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 51 128; Mul 51 128; Add 1 0; Add 0 52; Mul 33 132; Mul 30 132; Add 1 0; Add 0 28; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 60 116; Mul 60 116; Add 1 0; Add 0 61; Mul 42 120; Mul 39 120; Add 1 0; Add 0 37; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 69 104; Mul 69 104; Add 1 0; Add 0 70; Mul 51 108; Mul 48 108; Add 1 0; Add 0 46; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Constant 0; Mul 196 196; Mul 196 196; Add 1 0; Mul 65 0; Div 66 201; Mul 1 0; Mul 6 202;
  Mul 7 202; Add 1 0; Add 0 9; Add 4 0; Mul 205 205; Mul 205 205; Add 1 0; Mul 76 0; Mul 0 10;
  Mul 16 210; Mul 17 210; Add 1 0; Add 0 19; Add 4 0; Mul 213 213; Mul 213 213; Add 1 0; Mul 86 0;
  Mul 0 20; Mul 26 218; Mul 27 218; Add 1 0; Add 0 29; Add 4 0; Sub 10 20; Sub 1 21; Mul 1 220;
  Mul 223 1; Sub 1 0; Mul 0 97; Mul 227 4; Mul 6 226; Sub 1 0; Mul 0 101; Mul 4 237; Mul 1 237;
  Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 241; Mul 7 241; Add 1 0; Add 0 5; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 244; Mul 12 244; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 240 240; Mul 240 240; Add 1 0; Mul 122 0; Mul 0 56; Mul 62 245; Mul 63 245; Add 1 0;
  Add 0 65; Add 4 0; Mul 30 250; Mul 27 250; Add 1 0; Add 0 25; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 228 228; Mul 228 228; Add 1 0; Mul 137 0; Mul 0 71; Mul 77 233; Mul 78 233; Add 1 0;
  Add 0 80; Add 4 0; Mul 45 238; Mul 42 238; Add 1 0; Add 0 40; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 222 222; Mul 222 222; Add 1 0; Mul 152 0; Mul 0 86; Mul 92 227; Mul 93 227; Add 1 0;
  Add 0 95; Add 4 0; Mul 60 232; Mul 57 232; Add 1 0; Add 0 55; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 216 216; Mul 216 216; Add 1 0; Mul 167 0; Mul 0 101; Mul 107 221; Mul 108 221; Add 1 0;
  Add 0 110; Add 4 0; Mul 75 226; Mul 72 226; Add 1 0; Add 0 70; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 210 210; Mul 210 210; Add 1 0; Sub 0 120;
  ShowZero 0; (* the same top view *)
  Mul 110 183; Add 0 0; Sub 0 120;
  ShowZero 0; (* on Σ *)
  Mul 215 215; Mul 215 215; Add 1 0; Sub 0 127;
  ShowZero 0; (* the same top view *)
  Mul 107 190; Add 0 0; Sub 0 116;
  ShowZero 0; (* on Σ *)
  Mul 220 220; Mul 220 220; Add 1 0; Sub 0 134;
  ShowZero 0; (* the same top view *)
  Mul 104 197; Add 0 0; Sub 0 113;
  ShowZero 0; (* on Σ *)
  Mul 225 225; Mul 225 225; Add 1 0; Sub 0 141;
  ShowZero 0; (* the same top view *)
  Mul 75 204; Add 0 0; Sub 0 84;
  ShowZero 0; (* on Σ *)
  Mul 230 230; Mul 230 230; Add 1 0; Sub 0 148;
  ShowZero 0; (* the same top view *)
  Mul 67 211; Add 0 0; Sub 0 76;
  ShowZero 0; (* on Σ *)
  Mul 235 235; Mul 235 235; Add 1 0; Sub 0 155;
  ShowZero 0; (* the same top view *)
  Mul 59 218; Add 0 0; Sub 0 68;
  ShowZero 0; (* on Σ *)
  Mul 240 240; Mul 240 240; Add 1 0; Sub 0 162;
  ShowZero 0; (* the same top view *)
  Mul 51 225; Add 0 0; Sub 0 60;
  ShowZero 0 (* on Σ *)
].

Theorem part_2_size_7_valid : valid part_2_size_7.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** one face with k corners; size 8.
    Code: src/net/scribed.rs, src/pair/v_parallel.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_8 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 10 10; Mul 10 10; Add 1 0; Mul 11 11; Mul 11 11;
  Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 17; Sub 1 0; Mul 3 20; Mul 14 7; Sub 1 0;
  Mul 16 22; Mul 16 24; Sub 1 0; Mul 28 6; Mul 28 4; Add 1 0; Mul 18 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 8; Unknown 9; Sub 1 41; Sub 1 41; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 24; Mul 1 38;
  Sub 1 0; Mul 3 41; Mul 8 28; Sub 1 0; Mul 10 43; Mul 10 45; Sub 1 0; Mul 49 6; Mul 49 4;
  Add 1 0; Mul 39 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 10; Unknown 11; Sub 1 62; Sub 1 62; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 45; Mul 1 59;
  Sub 1 0; Mul 3 62; Mul 8 49; Sub 1 0; Mul 10 64; Mul 10 66; Sub 1 0; Mul 70 6; Mul 70 4;
  Add 1 0; Mul 60 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 12; Unknown 13; Sub 1 83; Sub 1 83; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 66; Mul 1 80;
  Sub 1 0; Mul 3 83; Mul 8 70; Sub 1 0; Mul 10 85; Mul 10 87; Sub 1 0; Mul 91 6; Mul 91 4;
  Add 1 0; Mul 81 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Unknown 14; Unknown 15; Sub 1 104; Sub 1 104; Mul 1 1; Mul 1 1; Add 1 0; Mul 3 87; Mul 1 101;
  Sub 1 0; Mul 3 104; Mul 8 91; Sub 1 0; Mul 10 106; Mul 10 108; Sub 1 0; Mul 112 6; Mul 112 4;
  Add 1 0; Mul 102 3; Add 1 0;
  Zero 0; (* the top view of every face is concyclic *)
  Sub 123 123;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 123 123;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 123 123;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 123 123;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 123 123;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 123 123;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 116 116;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 116 116;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 91 91;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 91 91;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 72 72;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 72 72;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 53 53;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 53 53;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 34 34;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 34 34;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 16; Unknown 17; Unknown 18; Mul 2 142; Mul 2 142; Add 1 0; Add 0 3; Mul 6 144;
  Mul 6 144; Add 1 0; Add 0 7; Mul 10 146; Mul 10 146; Add 1 0; Add 0 11; Sub 4 8; Sub 1 9;
  Constant 1; Div 0 145; Mul 3 149; Mul 152 3; Sub 1 0; Mul 0 3; Mul 156 6; Mul 8 155; Sub 1 0;
  Mul 0 7; Mul 4 166; Mul 1 166; Add 1 0; Sub 23 0; Add 1 0; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 170; Mul 7 170; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 173; Mul 12 173; Add 1 0; Add 0 10; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 42 169; Mul 42 169; Add 1 0; Add 0 43; Mul 24 173; Mul 21 173; Add 1 0; Add 0 19; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 51 151; Mul 51 151; Add 1 0; Add 0 52; Mul 33 155; Mul 30 155; Add 1 0; Add 0 28; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 60 139; Mul 60 139; Add 1 0; Add 0 61; Mul 42 143; Mul 39 143; Add 1 0; Add 0 37; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 69 127; Mul 69 127; Add 1 0; Add 0 70; Mul 51 131; Mul 48 131; Add 1 0; Add 0 46; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 78 115; Mul 78 115; Add 1 0; Add 0 79; Mul 60 119; Mul 57 119; Add 1 0; Add 0 55; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Constant 0; Mul 228 228; Mul 228 228; Add 1 0; Mul 74 0; Div 75 233; Mul 1 0; Mul 6 234;
  Mul 7 234; Add 1 0; Add 0 9; Add 4 0; Mul 237 237; Mul 237 237; Add 1 0; Mul 85 0; Mul 0 10;
  Mul 16 242; Mul 17 242; Add 1 0; Add 0 19; Add 4 0; Mul 245 245; Mul 245 245; Add 1 0; Mul 95 0;
  Mul 0 20; Mul 26 250; Mul 27 250; Add 1 0; Add 0 29; Add 4 0; Sub 10 20; Sub 1 21; Mul 1 252;
  Mul 255 1; Sub 1 0; Mul 0 106; Mul 259 4; Mul 6 258; Sub 1 0; Mul 0 110; Mul 4 269; Mul 1 269;
  Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 273; Mul 7 273; Add 1 0; Add 0 5; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 276; Mul 12 276; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 272 272; Mul 272 272; Add 1 0; Mul 131 0; Mul 0 56; Mul 62 277; Mul 63 277; Add 1 0;
  Add 0 65; Add 4 0; Mul 30 282; Mul 27 282; Add 1 0; Add 0 25; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 260 260; Mul 260 260; Add 1 0; Mul 146 0; Mul 0 71; Mul 77 265; Mul 78 265; Add 1 0;
  Add 0 80; Add 4 0; Mul 45 270; Mul 42 270; Add 1 0; Add 0 40; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 254 254; Mul 254 254; Add 1 0; Mul 161 0; Mul 0 86; Mul 92 259; Mul 93 259; Add 1 0;
  Add 0 95; Add 4 0; Mul 60 264; Mul 57 264; Add 1 0; Add 0 55; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 248 248; Mul 248 248; Add 1 0; Mul 176 0; Mul 0 101; Mul 107 253; Mul 108 253; Add 1 0;
  Add 0 110; Add 4 0; Mul 75 258; Mul 72 258; Add 1 0; Add 0 70; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 242 242; Mul 242 242; Add 1 0; Mul 191 0; Mul 0 116; Mul 122 247; Mul 123 247; Add 1 0;
  Add 0 125; Add 4 0; Mul 90 252; Mul 87 252; Add 1 0; Add 0 85; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 236 236; Mul 236 236; Add 1 0; Sub 0 135;
  ShowZero 0; (* the same top view *)
  Mul 125 207; Add 0 0; Sub 0 135;
  ShowZero 0; (* on Σ *)
  Mul 241 241; Mul 241 241; Add 1 0; Sub 0 142;
  ShowZero 0; (* the same top view *)
  Mul 122 214; Add 0 0; Sub 0 131;
  ShowZero 0; (* on Σ *)
  Mul 246 246; Mul 246 246; Add 1 0; Sub 0 149;
  ShowZero 0; (* the same top view *)
  Mul 119 221; Add 0 0; Sub 0 128;
  ShowZero 0; (* on Σ *)
  Mul 251 251; Mul 251 251; Add 1 0; Sub 0 156;
  ShowZero 0; (* the same top view *)
  Mul 90 228; Add 0 0; Sub 0 99;
  ShowZero 0; (* on Σ *)
  Mul 256 256; Mul 256 256; Add 1 0; Sub 0 163;
  ShowZero 0; (* the same top view *)
  Mul 82 235; Add 0 0; Sub 0 91;
  ShowZero 0; (* on Σ *)
  Mul 261 261; Mul 261 261; Add 1 0; Sub 0 170;
  ShowZero 0; (* the same top view *)
  Mul 74 242; Add 0 0; Sub 0 83;
  ShowZero 0; (* on Σ *)
  Mul 266 266; Mul 266 266; Add 1 0; Sub 0 177;
  ShowZero 0; (* the same top view *)
  Mul 66 249; Add 0 0; Sub 0 75;
  ShowZero 0; (* on Σ *)
  Mul 271 271; Mul 271 271; Add 1 0; Sub 0 184;
  ShowZero 0; (* the same top view *)
  Mul 58 256; Add 0 0; Sub 0 67;
  ShowZero 0 (* on Σ *)
].

Theorem part_2_size_8_valid : valid part_2_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
