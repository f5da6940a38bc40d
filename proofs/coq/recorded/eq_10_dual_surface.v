(** eq-10-dual-surface (Sec. 2.1, (10))

    The poles of the tangent planes of a graph make up the surface (10), and where it is regular
    the poles of its tangent planes are the points of the graph.

        (x, y, f)* = (f_x, f_y, x f_x + y f_y − f)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** poles of tangent planes; size 2.
    Code: src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs, src/space/polynomial.rs *)
Definition part_1_size_2 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
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
  Constant 1; Mul 0 4;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 1 3;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 9 3;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 3 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 11 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 5 2;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 6 4;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 7 2;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  ShowNonzero 8; (* as src/space/polynomial.rs finds *)
  Mul 8 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 9 5;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Add 3 3;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 17;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 17; Add 0 3;
  ShowZero 0; (* as src/space/polynomial.rs finds *)
  Neg 17; Add 0 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 20; Add 0 8;
  ShowZero 0; (* as src/space/polynomial.rs finds *)
  Neg 20; Add 0 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 21; Add 0 15;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Unknown 6; Unknown 7; Constant 0; Mul 24 25; Mul 0 26; Add 2 0; Mul 26 28; Mul 29 5; Mul 1 0;
  Add 3 0; Mul 32 9; Mul 30 0; Mul 0 34; Add 3 0; Sub 0 0;
  ShowZero 0; (* pole of the tangent plane *)
  Mul 33 37; Mul 0 38; Add 14 0; Mul 35 40; Mul 0 11; Add 2 0; Mul 41 10; Mul 0 44; Add 2 0;
  Sub 0 0;
  ShowZero 0; (* pole of the tangent plane *)
  Mul 53 47; Mul 0 48; Add 24 0; Mul 55 50; Mul 0 21; Add 2 0; Mul 56 53; Mul 24 30; Mul 1 0;
  Add 3 0; Mul 61 24; Mul 0 58; Add 2 0; Mul 62 27; Mul 0 31; Add 2 0; Mul 30 40; Mul 65 0;
  Mul 0 65; Add 3 0; Mul 55 67; Mul 0 68; Add 44 0; Mul 54 70; Mul 0 16; Add 2 0; Mul 53 40;
  Mul 0 44; Add 2 0; Mul 54 12; Mul 0 77; Add 2 0; Mul 43 56; Mul 34 56; Add 1 0; Sub 15 0; Neg 0;
  Sub 5 0;
  ShowZero 0; (* pole of the tangent plane *)
  ShowZero 48; (* (10) *)
  ShowZero 38; (* (10) *)
  Mul 62 49; Mul 62 40; Add 1 0; Sub 0 21; Sub 10 0;
  ShowZero 0 (* (10) *)
].

Theorem part_1_size_2_valid : valid part_1_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** poles of tangent planes; size 3.
    Code: src/space/duality.rs, src/space/gradient.rs, src/space/plane.rs, src/space/polynomial.rs *)
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
  Constant 1; Mul 0 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 1 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 2 5;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 15 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 16 6;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 16 6;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 6 15;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 19 14;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 19 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 21 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 10 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 11 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 12 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 25 7;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 14 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 27 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 16 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 29 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 18 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  ShowNonzero 19; (* as src/space/polynomial.rs finds *)
  Mul 19 18;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 20 17;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 21 15;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 22 15;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 23 14;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 24 13;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Add 10 10;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Add 7 5;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Add 2 14;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 38;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 38; Add 0 7;
  ShowZero 0; (* as src/space/polynomial.rs finds *)
  Neg 38; Add 0 15;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 37; Add 0 10;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 43; Add 0 16;
  ShowZero 0; (* as src/space/polynomial.rs finds *)
  Neg 43; Add 0 12;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 42; Add 0 13;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 46; Add 0 30;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 45; Add 0 16;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 46; Add 0 24;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Unknown 10; Unknown 11; Constant 0; Mul 49 50; Mul 0 51; Add 2 0; Mul 51 53; Mul 54 5; Mul 1 0;
  Add 3 0; Mul 54 57; Mul 3 9; Mul 1 0; Add 3 0; Mul 61 13; Mul 58 0; Mul 0 63; Add 3 0; Mul 60 3;
  Mul 0 11; Add 2 0; Mul 6 20; Mul 63 0; Mul 0 70; Add 3 0; Sub 0 0;
  ShowZero 0; (* pole of the tangent plane *)
  Mul 66 73; Mul 0 74; Add 25 0; Mul 68 76; Mul 0 22; Add 2 0; Mul 70 79; Mul 0 21; Add 2 0;
  Mul 80 20; Mul 0 83; Add 2 0; Mul 75 23; Mul 0 31; Add 2 0; Mul 77 19; Mul 0 89; Add 2 0;
  Sub 0 0;
  ShowZero 0; (* pole of the tangent plane *)
  Mul 102 92; Mul 0 93; Add 44 0; Mul 104 95; Mul 0 41; Add 2 0; Mul 105 98; Mul 0 40; Add 2 0;
  Mul 105 101; Mul 43 53; Mul 1 0; Add 3 0; Mul 113 43; Mul 0 106; Add 2 0; Mul 114 46; Mul 0 54;
  Add 2 0; Mul 114 49; Mul 0 53; Add 2 0; Mul 119 45; Mul 0 115; Add 2 0; Mul 119 48; Mul 0 63;
  Add 2 0; Mul 51 72; Mul 122 0; Mul 0 122; Add 3 0; Mul 95 124; Mul 0 125; Add 76 0; Mul 94 127;
  Mul 0 69; Add 2 0; Mul 95 130; Mul 0 28; Add 2 0; Mul 94 71; Mul 0 79; Add 2 0; Mul 95 74;
  Mul 0 78; Add 2 0; Mul 96 70; Mul 0 140; Add 2 0; Mul 97 73; Mul 0 88; Add 2 0; Mul 98 24;
  Mul 0 146; Add 2 0; Mul 76 100; Mul 58 100; Add 1 0; Sub 27 0; Neg 0; Sub 5 0;
  ShowZero 0; (* pole of the tangent plane *)
  ShowZero 81; (* (10) *)
  ShowZero 62; (* (10) *)
  Mul 106 82; Mul 106 64; Add 1 0; Sub 0 33; Sub 10 0;
  ShowZero 0 (* (10) *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the dual of the dual; size 2.
    Code: src/space/duality.rs, src/space/gradient.rs, src/space/parametric.rs, src/space/plane.rs,
    src/space/point.rs, src/space/polynomial.rs, src/space/surface.rs *)
Definition part_2_size_2 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
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
  Constant 1; Mul 0 2; Mul 8 2; Mul 9 5; Mul 3 1; Constant 0; Mul 1 5; Mul 0 6; Add 2 0; Mul 8 7;
  Mul 0 9; Mul 0 10; Add 6 0; Mul 12 9; Mul 0 13; Mul 0 14; Add 10 0; Mul 8 0; Mul 5 5; Sub 1 0;
  Nonzero 0; (* K != 0 *)
  Mul 19 23;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  ShowNonzero 19; (* as src/space/polynomial.rs finds *)
  ShowNonzero 18; (* as src/space/polynomial.rs finds *)
  Mul 20 25;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  ShowNonzero 18; (* as src/space/polynomial.rs finds *)
  ShowNonzero 17; (* as src/space/polynomial.rs finds *)
  ShowNonzero 12; (* as src/space/polynomial.rs finds *)
  ShowNonzero 8; (* as src/space/polynomial.rs finds *)
  ShowNonzero 21; (* as src/space/polynomial.rs finds *)
  Mul 21 1;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 22 1;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Add 14 14;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 30;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 30; Add 0 3;
  ShowZero 0; (* as src/space/polynomial.rs finds *)
  Neg 30; Add 0 15;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 33; Add 0 8;
  ShowZero 0; (* as src/space/polynomial.rs finds *)
  Neg 33; Add 0 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Neg 34; Add 0 30;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 35 2;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 43 1;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 44 8;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 38 1;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 39 3;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Mul 40 2;
  ShowNonzero 0; (* as src/space/polynomial.rs finds *)
  Unknown 6; Unknown 7; Mul 7 43; Mul 44 1; Mul 1 0; Add 41 0; Mul 47 5; Mul 11 0; Mul 0 49;
  Add 3 0; Mul 13 51; Mul 0 7; Add 48 0; Mul 18 6; Mul 0 55; Add 2 0; Div 57 38; Neg 46; Mul 43 1;
  Mul 1 2; Mul 10 1; Mul 5 1; Add 1 0; Sub 0 22;
  ShowZero 0; (* the point of the graph *)
  Mul 57 7; Mul 15 5; Mul 10 1; Add 1 0; Sub 0 26;
  ShowZero 0; (* the point of the graph *)
  Mul 76 70; Mul 0 71; Add 67 0; Mul 78 73; Mul 0 29; Add 2 0; Mul 79 76; Mul 32 34; Mul 1 0;
  Add 3 0; Mul 84 32; Mul 0 81; Add 2 0; Mul 85 35; Mul 0 39; Add 2 0; Mul 38 44; Mul 88 0;
  Mul 0 88; Add 3 0; Mul 70 90; Mul 0 91; Add 87 0; Mul 92 93; Mul 0 49; Add 2 0; Mul 94 48;
  Mul 0 97; Add 2 0; Mul 78 99; Mul 0 100; Add 96 0; Mul 99 102; Mul 0 58; Add 2 0; Mul 104 57;
  Mul 0 106; Add 2 0; Mul 83 108; Mul 0 109; Add 105 0; Mul 82 111; Mul 0 34; Add 2 0; Mul 81 66;
  Mul 0 70; Add 2 0; Mul 82 30; Mul 0 118; Add 2 0; Mul 56 21; Mul 52 13; Add 1 0; Sub 3 0; Neg 0;
  Sub 0 35;
  ShowZero 0 (* the point of the graph *)
].

Theorem part_2_size_2_valid : valid part_2_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the dual of the dual; size 3.
    Code: src/space/duality.rs, src/space/gradient.rs, src/space/parametric.rs, src/space/plane.rs,
    src/space/point.rs, src/space/polynomial.rs, src/space/surface.rs *)
Definition part_2_size_3 : list step := [
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
  Mul 67 104; Mul 0 88; Add 78 0; Mul 23 87; Mul 0 108; Add 2 0; Mul 22 110; Mul 0 94; Add 100 0;
  Mul 24 113; Mul 97 115; Mul 1 0; Add 3 0; Mul 27 97; Mul 0 118; Add 2 0; Mul 29 100; Mul 0 104;
  Add 2 0; Mul 103 125; Mul 32 0; Mul 0 125; Add 3 0; Mul 34 127; Mul 0 111; Add 117 0;
  Mul 36 130; Mul 0 16; Add 2 0; Mul 45 113; Mul 0 134; Add 2 0; Mul 41 116; Mul 0 120; Add 2 0;
  Mul 43 15; Mul 0 140; Add 2 0; Mul 108 32; Sub 96 0; Div 144 0; Neg 35; Mul 100 1; Mul 1 2;
  Mul 21 1; Mul 7 1; Add 1 0; Sub 0 153;
  ShowZero 0; (* the point of the graph *)
  Neg 118; Mul 0 8; Mul 131 9; Mul 28 1; Mul 14 1; Add 1 0; Sub 0 159;
  ShowZero 0; (* the point of the graph *)
  Mul 171 159; Mul 0 160; Add 149 0; Mul 173 162; Mul 0 146; Add 2 0; Mul 174 165; Mul 0 51;
  Add 2 0; Mul 174 168; Mul 54 170; Mul 1 0; Add 3 0; Mul 182 152; Mul 0 173; Add 2 0;
  Mul 183 155; Mul 0 159; Add 2 0; Mul 183 158; Mul 0 64; Add 2 0; Mul 188 57; Mul 0 182; Add 2 0;
  Mul 188 60; Mul 0 168; Add 2 0; Mul 63 189; Mul 191 0; Mul 0 189; Add 3 0; Mul 141 191;
  Mul 0 192; Add 181 0; Mul 193 194; Mul 0 178; Add 2 0; Mul 195 197; Mul 0 83; Add 2 0;
  Mul 197 180; Mul 0 201; Add 2 0; Mul 199 183; Mul 0 187; Add 2 0; Mul 201 82; Mul 0 207;
  Add 2 0; Mul 158 209; Mul 0 210; Add 199 0; Mul 206 212; Mul 0 196; Add 2 0; Mul 208 215;
  Mul 0 101; Add 2 0; Mul 217 198; Mul 0 219; Add 2 0; Mul 213 201; Mul 0 205; Add 2 0;
  Mul 172 100; Mul 0 225; Add 2 0; Mul 165 227; Mul 0 228; Add 217 0; Mul 164 230; Mul 0 116;
  Add 2 0; Mul 165 233; Mul 0 64; Add 2 0; Mul 164 216; Mul 0 220; Add 2 0; Mul 165 219;
  Mul 0 125; Add 2 0; Mul 166 118; Mul 0 243; Add 2 0; Mul 167 121; Mul 0 229; Add 2 0;
  Mul 168 60; Mul 0 249; Add 2 0; Mul 100 42; Mul 94 25; Add 1 0; Sub 3 0; Neg 0; Sub 0 65;
  ShowZero 0 (* the point of the graph *)
].

Theorem part_2_size_3_valid : valid part_2_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
