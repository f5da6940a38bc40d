(** eq-11-curvatures (Sec. 2.1, (11))

    The curvatures of the dual surface are H/K and 1/K. The dual of an i-minimal surface is
    i-minimal.

        H* = H/K,  K* = 1/K

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the surface (10); size 3.
    Code: src/scalar/ring.rs, src/space/parametric.rs, src/space/point.rs, src/space/polynomial.rs,
    src/space/surface.rs *)
Definition part_1_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 3;
  Nonzero 0; (* 3 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 1;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 2;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 3;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 4;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 5;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 6;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 7;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 8;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 9;
  Nonzero 0; (* a coefficient is not 0; those with 0 are limits *)
  Unknown 10; Unknown 11; Constant 1; Mul 0 8; Mul 1 6; Mul 16 9; Mul 17 7; Mul 17 7; Mul 19 14;
  Mul 19 12; Mul 21 12; Mul 8 5; Mul 9 5; Mul 24 5; Constant 0; Mul 3 12; Mul 0 13; Add 2 0;
  Mul 5 15; Mul 16 17; Mul 1 0; Add 3 0; Mul 19 21; Mul 9 0; Mul 0 21; Add 3 0; Mul 23 22;
  Mul 38 22; Mul 1 25; Mul 0 26; Add 15 0; Mul 3 28; Mul 0 12; Add 2 0; Mul 21 11; Mul 0 32;
  Add 2 0; Mul 34 28; Mul 49 28; Mul 36 28; Mul 2 37; Mul 0 38; Add 27 0; Mul 4 40; Mul 0 24;
  Add 2 0; Mul 6 23; Mul 0 44; Add 2 0; Mul 23 0; Mul 13 13; Sub 1 0;
  Nonzero 0; (* K != 0 *)
  Mul 49 59;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  ShowNonzero 49; (* as src/space/polynomial.rs finds *)
  ShowNonzero 48; (* as src/space/polynomial.rs finds *)
  ShowNonzero 47; (* as src/space/polynomial.rs finds *)
  ShowNonzero 46; (* as src/space/polynomial.rs finds *)
  ShowNonzero 45; (* as src/space/polynomial.rs finds *)
  Mul 50 61;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  ShowNonzero 45; (* as src/space/polynomial.rs finds *)
  ShowNonzero 44; (* as src/space/polynomial.rs finds *)
  ShowNonzero 43; (* as src/space/polynomial.rs finds *)
  Mul 51 55;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  ShowNonzero 43; (* as src/space/polynomial.rs finds *)
  ShowNonzero 42; (* as src/space/polynomial.rs finds *)
  ShowNonzero 41; (* as src/space/polynomial.rs finds *)
  ShowNonzero 28; (* as src/space/polynomial.rs finds *)
  ShowNonzero 27; (* as src/space/polynomial.rs finds *)
  ShowNonzero 17; (* as src/space/polynomial.rs finds *)
  ShowNonzero 16; (* as src/space/polynomial.rs finds *)
  ShowNonzero 15; (* as src/space/polynomial.rs finds *)
  ShowNonzero 52; (* as src/space/polynomial.rs finds *)
  Mul 52 2;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 53 51;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 54 49;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 55 4;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 56 49;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 57 5;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Add 34 34;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Add 22 5;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Add 2 50;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 73;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 73; Add 0 7;
  ShowZero 0; (* as src/space/polynomial.rs finds *)
  Neg 73; Add 0 30;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 72; Add 0 10;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 78; Add 0 16;
  ShowZero 0; (* as src/space/polynomial.rs finds *)
  Neg 78; Add 0 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 77; Add 0 13;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 81; Add 0 66;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 80; Add 0 16;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 81; Add 0 24;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 80 69;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 81 71;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 82 57;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 97 31;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 84 0;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 85 48;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 86 50;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 87 15;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 88 14;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 103 13;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 104 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 104 11;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 106 26;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 106 25;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 108 20;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 95 17;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 96 6;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 97 6;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 112 6;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 99 11;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 114 11;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 101 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 116 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 103 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 23 104; Mul 0 105; Add 94 0; Mul 25 107; Mul 0 108; Add 97 0; Mul 27 110; Mul 0 111;
  Add 100 0; Mul 28 113; Mul 0 114; Add 103 0; Mul 30 116; Mul 0 117; Add 106 0; Mul 32 119;
  Mul 0 120; Add 109 0; Mul 85 122; Mul 0 106; Add 96 0; Mul 41 105; Mul 0 126; Add 2 0;
  Mul 31 128; Mul 0 129; Add 118 0; Mul 33 131; Mul 0 115; Add 2 0; Mul 35 114; Mul 0 135;
  Add 2 0; Mul 37 137; Mul 0 138; Add 127 0; Mul 39 140; Mul 0 124; Add 2 0; Mul 45 123;
  Mul 0 144; Add 2 0; Mul 44 146; Mul 0 147; Add 136 0; Mul 46 149; Mul 0 133; Add 2 0;
  Mul 48 132; Mul 0 153; Add 2 0; Mul 67 155; Mul 0 139; Add 145 0; Mul 69 158; Mul 142 160;
  Mul 1 0; Add 3 0; Mul 72 142; Mul 0 163; Add 2 0; Mul 74 145; Mul 0 149; Add 2 0; Mul 148 170;
  Mul 77 0; Mul 0 170; Add 3 0; Mul 79 172; Mul 0 156; Add 162 0; Mul 81 175; Mul 0 16; Add 2 0;
  Mul 90 158; Mul 0 179; Add 2 0; Mul 86 161; Mul 0 165; Add 2 0; Mul 88 15; Mul 0 185; Add 2 0;
  Mul 153 59; Sub 141 0; Div 189 0; Neg 62; Mul 145 1; Mul 1 2; Neg 159; Mul 0 4; Mul 172 5;
  Mul 24 4; Mul 10 4; Add 1 0; Mul 27 4; Mul 13 4; Add 1 0; Mul 65 10; Mul 57 10; Add 1 0;
  Mul 59 13; Mul 51 13; Add 1 0; Mul 16 3; Mul 16 1; Add 1 0; Mul 104 19; Mul 102 19; Add 1 0;
  Mul 104 22; Mul 102 22; Add 1 0; Mul 25 3; Mul 25 1; Add 1 0; Mul 21 0; Sub 10 0; Mul 106 30;
  Mul 104 30; Add 1 0; Mul 106 33; Mul 104 33; Add 1 0; Mul 36 3; Mul 36 1; Add 1 0; Mul 29 0;
  Sub 10 0; Mul 96 38; Mul 88 38; Add 1 0; Mul 90 41; Mul 82 41; Add 1 0; Mul 47 3; Mul 47 1;
  Add 1 0; Mul 135 47; Mul 133 47; Add 1 0; Mul 135 50; Mul 133 50; Add 1 0; Mul 56 3; Mul 56 1;
  Add 1 0; Mul 52 0; Sub 10 0; Mul 137 58; Mul 135 58; Add 1 0; Mul 137 61; Mul 135 61; Add 1 0;
  Mul 67 3; Mul 67 1; Add 1 0; Mul 60 0; Sub 10 0; Mul 69 28; Mul 69 26; Add 1 0; Mul 72 22;
  Mul 72 20; Add 1 0; Mul 71 0; Sub 4 0; Mul 77 16; Mul 77 14; Add 1 0; Mul 73 0; Sub 4 0;
  Mul 44 0; Mul 14 14; Sub 1 0; Mul 231 0; Sub 0 281;
  ShowZero 0; (* K K* *)
  Add 259 236; Div 283 297; Mul 1 0; Add 52 8; Mul 0 2; Mul 0 238; Sub 0 3;
  ShowZero 0 (* H* K *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the dual jet; size 1.
    Code: src/scalar/ring.rs, src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/surface.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Mul 2 0; Mul 2 2; Sub 1 0;
  Nonzero 0; (* K != 0 *)
  Neg 4; Constant 1; Div 0 2; Mul 6 0; Mul 3 1; Mul 10 2; Mul 2 0; Mul 2 2; Sub 1 0; Mul 9 0;
  Sub 0 8;
  ShowZero 0; (* K K* *)
  Add 7 5; Div 10 18; Mul 1 0; Mul 0 14; Add 20 18; Mul 0 3; Sub 2 0;
  ShowZero 0; (* H* K *)
  Unknown 3; Sub 0 0;
  ShowZero 0; (* pole *)
  Unknown 4; Sub 0 0;
  ShowZero 0; (* pole *)
  Unknown 5; Unknown 6; Unknown 7; Mul 6 2; Mul 5 2; Add 1 0; Sub 3 0; Neg 0; Sub 0 0;
  ShowZero 0; (* pole *)
  Sub 8 8;
  ShowZero 0; (* polar plane *)
  Sub 8 8;
  ShowZero 0; (* polar plane *)
  Mul 10 14; Mul 10 13; Add 1 0; Sub 6 0; Neg 12; Sub 1 0;
  ShowZero 0; (* polar plane *)
  Unknown 8; Unknown 9; Mul 46 1; Mul 46 1; Add 1 0; Mul 48 4; Mul 48 4; Add 1 0; Mul 43 3;
  Mul 43 1; Add 1 0; Sub 0 10;
  ShowZero 0; (* inverse shape operator *)
  Mul 46 7; Mul 46 5; Add 1 0; Sub 0 13;
  ShowZero 0 (* inverse shape operator *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
