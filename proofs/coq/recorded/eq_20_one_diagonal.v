(** eq-20-one-diagonal (ours)

    For parallel quads one pair of parallel diagonals is enough: the two conditions in (20) are
    equations between the same numbers.

        2 area(F, S) = det(13, 2*4* ) = det(1*3*, 24)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a parallel quad with one parallel diagonal; size 1.
    Code: src/pair/area.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 5;
  Sub 3 5; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* two edges of F that meet at corner 1 or 3 are not parallel *)
  Unknown 6; Unknown 7; Sub 1 10; Sub 1 10; Sub 16 3; Sub 16 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* two edges of F that meet at corner 1 or 3 are not parallel *)
  Unknown 8; Unknown 9; Unknown 10; Sub 11 22; Sub 11 22; Mul 1 4; Mul 1 5; Add 5 1; Add 5 1;
  Mul 3 21; Mul 3 23; Sub 1 0; Div 0 21; Mul 28 0; Mul 28 1; Add 13 1; Add 13 1; Mul 11 22;
  Mul 11 24; Sub 1 0; Mul 24 25; Mul 24 27; Sub 1 0; Div 3 0; Mul 28 0; Mul 28 1; Add 24 1;
  Add 24 1; Sub 12 26; Sub 12 26; Constant 0; Sub 48 52; Sub 48 52; Sub 25 31; Sub 25 31;
  Mul 50 0; Mul 50 2; Sub 1 0; Add 7 0; Mul 10 6; Mul 10 8; Sub 1 0; Add 3 0; Sub 51 64;
  Sub 51 64; Sub 18 43; Sub 18 43; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8;
  Sub 1 0; Add 3 0;
  ShowZero 0; (* 4 area(F, S) *)
  Mul 21 50; Mul 21 52; Sub 1 0;
  ShowZero 0; (* det(1*3*, 24) *)
  Sub 31 42; Sub 31 42; Mul 28 0; Mul 28 2; Sub 1 0;
  ShowZero 0; (* det(13, 2*4* ) *)
  Mul 78 33; Mul 78 35; Sub 1 0;
  ShowZero 0; (* parallel edges *)
  Sub 58 50; Sub 58 50; Mul 81 0; Mul 81 2; Sub 1 0;
  ShowZero 0; (* parallel edges *)
  Sub 44 63; Sub 44 63; Mul 79 0; Mul 79 2; Sub 1 0;
  ShowZero 0; (* parallel edges *)
  Sub 74 49; Sub 74 49; Mul 82 0; Mul 82 2; Sub 1 0;
  ShowZero 0 (* parallel edges *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
