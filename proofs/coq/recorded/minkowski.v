(** minkowski (Sec. 4, after (17))

    Faces that are convex have principal curvatures.

        H² - K >= 0;

        quads: (area(F,S)² - area(F) area(S)) · 4 D12 D34 = det(d, d* )² D23 D41, Dij = det of consecutive edges of F, d and d* corresponding diagonals

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the discriminant of a quad, exactly; size 1.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 5;
  Sub 3 5; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the first corner is not straight *)
  Unknown 6; Unknown 7; Constant 0; Sub 11 15; Sub 11 15; Mul 11 0; Mul 11 2; Sub 1 0; Add 5 0;
  Sub 8 21; Sub 8 21; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Constant 2; Mul 1 0;
  Nonzero 0; (* area(F) != 0 *)
  Sub 16 25; Sub 16 25; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 1; Div 0 24;
  Mul 7 28; Mul 7 30; Sub 1 0; Mul 0 3; Mul 8 0; Sub 10 0; Mul 37 12; Mul 37 14; Sub 1 0; Mul 0 9;
  Mul 14 0; Sub 16 0; Mul 43 6; Mul 43 7; Add 17 1; Add 17 1; Mul 45 4; Mul 45 5; Add 3 1;
  Add 3 1; Add 25 24; Mul 28 0; Mul 28 1; Add 4 1; Add 4 1; Sub 10 28; Sub 10 28; Sub 8 30;
  Sub 8 30; Mul 60 0; Mul 60 2; Sub 1 0; Mul 6 52; Mul 6 54; Sub 1 0; Add 3 0; Add 58 0; Mul 11 8;
  Mul 11 10; Sub 1 0; Add 62 0; Sub 17 44; Sub 17 44; Mul 64 0; Mul 64 2; Sub 1 0; Mul 18 60;
  Mul 18 62; Sub 1 0; Add 3 0; Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0; Mul 0 64;
  Div 57 64; Mul 6 0; Mul 2 1; Mul 1 1; Sub 0 1; Mul 69 69; Mul 1 0; Mul 12 12; Mul 72 8; Sub 1 0;
  Sub 3 0;
  ShowZero 0; (* H² - K from the areas *)
  Sub 104 91; Sub 104 91; Mul 98 75; Mul 98 77; Sub 1 0; Mul 79 3; Mul 79 5; Sub 1 0; Mul 7 105;
  Mul 7 107; Sub 1 0; Mul 99 49; Mul 99 51; Sub 1 0; Constant 4; Mul 1 1; Mul 1 0; Mul 0 12;
  Mul 0 7; Mul 20 111; Mul 0 12; Sub 0 2;
  ShowZero 0 (* the discriminant *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
