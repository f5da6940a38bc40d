(** offset-edge (Sec. 3.1, meshes with offsets (ii))

    The lines of the edges of M + dS have the distance d from those of M iff the edges of S touch
    the unit sphere.

        dist² = d² |s × e|²/|e|²

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** distances of lines; size 1.
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
  Unknown 13; Mul 0 50; Add 55 0; Mul 2 69; Add 79 0; Mul 4 70; Add 80 0; Sub 4 60; Sub 3 83;
  Sub 2 83; Mul 1 69; Mul 1 71; Sub 1 0; Mul 3 59; Mul 6 73; Sub 1 0; Mul 8 76; Mul 8 63; Sub 1 0;
  Mul 18 18; Mul 86 79; Mul 86 81; Sub 1 0; Mul 88 69; Mul 73 83; Sub 1 0; Mul 75 86; Mul 93 73;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 14 0; Mul 22 22; Mul 20 20; Add 1 0;
  Mul 19 19; Add 1 0; Sub 0 5;
  ShowZero 0; (* distance *)
  Mul 40 88; Add 94 0; Mul 42 105; Add 117 0; Mul 44 106; Add 118 0; Sub 4 100; Sub 3 123;
  Sub 2 123; Mul 1 109; Mul 1 111; Sub 1 0; Mul 3 99; Mul 6 113; Sub 1 0; Mul 8 116; Mul 8 103;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Sub 0 29;
  ShowZero 0; (* distance *)
  Sub 22 117; Sub 21 139; Sub 20 139; Mul 1 99; Mul 1 101; Sub 1 0; Mul 3 93; Mul 6 103; Sub 1 0;
  Mul 8 106; Mul 8 97; Sub 1 0; Mul 139 108; Mul 139 110; Sub 1 0; Mul 141 102; Mul 128 112;
  Sub 1 0; Mul 130 115; Mul 146 106; Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0;
  Mul 71 0; Mul 21 21; Mul 19 19; Add 1 0; Mul 18 18; Add 1 0; Sub 0 5;
  ShowZero 0; (* distance *)
  Mul 97 121; Add 124 0; Mul 99 134; Add 139 0; Mul 101 135; Add 140 0; Sub 4 156; Sub 3 178;
  Sub 2 178; Mul 1 138; Mul 1 140; Sub 1 0; Mul 3 132; Mul 6 142; Sub 1 0; Mul 8 145; Mul 8 136;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Sub 0 29;
  ShowZero 0; (* distance *)
  Sub 22 147; Sub 21 161; Sub 20 161; Mul 1 138; Mul 1 140; Sub 1 0; Mul 3 135; Mul 6 142;
  Sub 1 0; Mul 8 145; Mul 8 139; Sub 1 0; Mul 168 147; Mul 168 149; Sub 1 0; Mul 170 144;
  Mul 161 151; Sub 1 0; Mul 163 154; Mul 175 148; Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3;
  Add 1 0; Mul 128 0; Mul 21 21; Mul 19 19; Add 1 0; Mul 18 18; Add 1 0; Sub 0 5;
  ShowZero 0; (* distance *)
  Sub 152 180; Sub 151 194; Sub 150 194; Mul 1 171; Mul 1 173; Sub 1 0; Mul 3 168; Mul 6 175;
  Sub 1 0; Mul 8 178; Mul 8 172; Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Sub 0 23;
  ShowZero 0 (* distance *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
