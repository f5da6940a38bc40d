(** thm-1-converse (Sec. 3.2, Theorem 1)

    A planar quad with edges parallel to those of a quad inscribed to Σ is i-circular.

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** one quad; size 1.
    Code: src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs, src/space/point.rs,
    src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the first and the third corner differ *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Sub 14 16; Sub 14 16; Sub 14 18; Sub 14 18; Mul 5 5;
  Mul 5 5; Add 1 0; Mul 6 6; Mul 6 6; Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12;
  Sub 1 0; Mul 3 15; Mul 14 7; Sub 1 0; Mul 16 17; Mul 16 19; Sub 1 0; Mul 23 6; Mul 23 4;
  Add 1 0; Mul 18 3; Add 1 0;
  Zero 0; (* S₁ is planar and inscribed *)
  Unknown 8; Unknown 9; Unknown 10; Constant 1; Constant 0; Mul 48 48; Mul 48 48; Add 1 0;
  Mul 4 0; Div 5 53; Mul 1 0; Mul 6 54; Mul 7 54; Add 1 0; Add 0 9; Add 4 0; Mul 46 46; Mul 46 46;
  Add 1 0; Mul 15 0; Mul 0 10; Mul 16 51; Mul 17 51; Add 1 0; Add 0 19; Add 4 0; Sub 0 10;
  Mul 54 24; Mul 1 25; Add 28 1; Add 28 1; Sub 1 30; Sub 1 30; Mul 1 6; Mul 1 61; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 11; Mul 65 34; Add 1 0; Sub 0 2; Mul 7 68; Mul 1 14; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 3 70; Mul 12 72; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Unknown 12; Mul 88 88; Mul 88 88; Add 1 0; Mul 46 0; Mul 0 41; Mul 47 93; Mul 48 93; Add 1 0;
  Add 0 50; Add 4 0; Sub 97 86; Sub 1 32; Mul 1 12; Mul 1 13; Add 31 1; Add 31 1; Sub 1 33;
  Sub 1 33; Mul 1 6; Mul 1 8; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 109 98; Mul 0 22; Add 31 0; Sub 0 32; Mul 7 3; Mul 1 14; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 3 17; Mul 12 7; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 117 117; Mul 117 117; Add 1 0; Mul 77 0; Mul 0 72; Mul 78 122; Mul 79 122; Add 1 0;
  Add 0 81; Add 4 0; Sub 72 0; Sub 18 52; Sub 28 89; Mul 128 0; Mul 128 2; Sub 1 0; Div 0 125;
  Mul 129 0; Mul 7 1; Add 96 1; Add 96 1; Sub 1 37; Sub 1 37; Sub 13 44; Mul 2 0; Mul 2 139;
  Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 140 10; Add 69 0; Sub 0 36; Mul 7 145; Mul 1 7; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 3 147; Mul 12 149; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 113 16; Sub 113 16; Mul 1 27; Mul 1 151; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 82 12; Mul 4 155; Mul 1 32; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 3 157; Mul 9 159; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 19 89; Sub 29 126; Mul 88 88; Mul 97 97; Add 1 0; Mul 41 41; Mul 41 41; Add 1 0; Mul 7 7;
  Mul 7 7; Add 1 0; Mul 9 3; Mul 1 47; Sub 1 0; Mul 3 50; Mul 14 7; Sub 1 0; Mul 16 52; Mul 16 54;
  Sub 1 0; Mul 106 6; Mul 115 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0; (* i-circular *)
  Sub 88 149; Sub 53 150; Mul 62 0; Mul 2 26; Sub 1 0; Mul 4 29; Mul 67 4; Sub 1 0; Mul 69 31;
  Mul 69 33; Sub 1 0; Mul 122 6; Mul 131 4; Add 1 0; Mul 132 3; Add 1 0;
  ShowZero 0 (* planar *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
