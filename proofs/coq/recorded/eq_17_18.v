(** eq-17-18 (Sec. 4, (17), (18))

    The curvatures of the face F + dS, seen with the same S, follow from those of F.

        K(Fᵈ) = K / (1 + 2dH + d²K),  H(Fᵈ) = (H + dK) / (1 + 2dH + d²K)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** (15)-(18) on the corners of F + dS; size 3.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/space/point.rs *)
Definition part_1_size_3 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Constant 0;
  Sub 4 8; Sub 4 8; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0; Constant 2; Mul 1 0;
  Nonzero 0; (* area(F) != 0 *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Sub 4 6;
  Sub 4 6; Sub 4 8; Sub 4 8; Mul 21 0; Mul 21 2; Sub 1 0; Mul 6 20; Mul 6 22; Sub 1 0; Add 3 0;
  Add 26 0; Mul 11 8; Mul 11 10; Sub 1 0; Add 30 0; Mul 0 24; Mul 17 0; Add 6 0; Add 7 0;
  Mul 20 0; Add 28 0;
  Nonzero 0; (* 1 + 2dH + d²K != 0, that is, area(F + dS) != 0 *)
  Mul 28 22; Mul 28 23; Add 47 1; Add 47 1; Mul 30 26; Mul 30 27; Add 49 1; Add 49 1; Mul 32 30;
  Mul 32 31; Add 51 1; Add 51 1; Sub 5 9; Sub 5 9; Sub 3 11; Sub 3 11; Mul 3 0; Mul 3 2; Sub 1 0;
  Add 56 0; Mul 0 50; Sub 0 21;
  ShowZero 0; (* area *)
  Mul 9 40; Mul 9 42; Sub 1 0; Mul 46 9; Mul 46 11; Sub 1 0; Add 3 0; Add 66 0; Constant 1;
  Div 0 60; Mul 42 0; Mul 38 1; Mul 56 0; Add 2 0; Add 3 0; Mul 59 0; Add 7 0; Div 8 0; Mul 4 0;
  Div 10 20; Mul 12 0; Sub 0 2;
  ShowZero 0; (* H *)
  Mul 10 4; Mul 50 3; Sub 0 1;
  ShowZero 0 (* K *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** (15)-(18) on the corners of F + dS; size 4.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Sub 5 7;
  Sub 5 7; Constant 0; Sub 6 10; Sub 6 10; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0; Sub 10 16;
  Sub 10 16; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Constant 2; Mul 1 0;
  Nonzero 0; (* area(F) != 0 *)
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Unknown 16; Sub 6 8; Sub 6 8; Sub 6 10; Sub 6 10; Mul 29 0; Mul 29 2; Sub 1 0; Mul 6 28;
  Mul 6 30; Sub 1 0; Add 3 0; Add 34 0; Mul 11 8; Mul 11 10; Sub 1 0; Add 38 0; Sub 18 24;
  Sub 18 24; Mul 40 0; Mul 40 2; Sub 1 0; Mul 18 36; Mul 18 38; Sub 1 0; Add 3 0; Add 13 0;
  Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0; Mul 0 40; Mul 31 0; Add 6 0; Add 7 0; Mul 34 0;
  Add 44 0;
  Nonzero 0; (* 1 + 2dH + d²K != 0, that is, area(F + dS) != 0 *)
  Mul 44 36; Mul 44 37; Add 71 1; Add 71 1; Mul 46 40; Mul 46 41; Add 73 1; Add 73 1; Mul 48 44;
  Mul 48 45; Add 75 1; Add 75 1; Mul 50 48; Mul 50 49; Add 77 1; Add 77 1; Sub 9 13; Sub 9 13;
  Sub 7 15; Sub 7 15; Mul 3 0; Mul 3 2; Sub 1 0; Add 82 0; Sub 9 21; Sub 9 21; Mul 7 0; Mul 7 2;
  Sub 1 0; Add 5 0; Mul 0 76; Sub 0 31;
  ShowZero 0; (* area *)
  Mul 15 64; Mul 15 66; Sub 1 0; Mul 70 15; Mul 70 17; Sub 1 0; Add 3 0; Add 98 0; Mul 21 58;
  Mul 21 60; Sub 1 0; Mul 76 17; Mul 76 19; Sub 1 0; Add 3 0; Add 7 0; Constant 1; Div 0 94;
  Mul 60 0; Mul 56 1; Mul 88 0; Add 2 0; Add 3 0; Mul 91 0; Add 7 0; Div 8 0; Mul 4 0; Div 10 28;
  Mul 12 0; Sub 0 2;
  ShowZero 0; (* H *)
  Mul 10 4; Mul 68 3; Sub 0 1;
  ShowZero 0 (* K *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** (15)-(18) on the corners of F + dS; size 5.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/space/point.rs *)
Definition part_1_size_5 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Sub 7 9; Sub 7 9; Constant 0; Sub 8 12; Sub 8 12; Mul 4 0; Mul 4 2;
  Sub 1 0; Add 5 0; Sub 12 18; Sub 12 18; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 16 24;
  Sub 16 24; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Constant 2; Mul 1 0;
  Nonzero 0; (* area(F) != 0 *)
  Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15; Unknown 16; Unknown 17;
  Unknown 18; Unknown 19; Unknown 20; Sub 8 10; Sub 8 10; Sub 8 12; Sub 8 12; Mul 37 0; Mul 37 2;
  Sub 1 0; Mul 6 36; Mul 6 38; Sub 1 0; Add 3 0; Add 42 0; Mul 11 8; Mul 11 10; Sub 1 0; Add 46 0;
  Sub 20 26; Sub 20 26; Mul 48 0; Mul 48 2; Sub 1 0; Mul 18 44; Mul 18 46; Sub 1 0; Add 3 0;
  Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0; Sub 32 40; Sub 32 40; Mul 56 0; Mul 56 2;
  Sub 1 0; Mul 18 52; Mul 18 54; Sub 1 0; Add 3 0; Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0;
  Add 13 0; Mul 0 56; Mul 45 0; Add 6 0; Add 7 0; Mul 48 0; Add 60 0;
  Nonzero 0; (* 1 + 2dH + d²K != 0, that is, area(F + dS) != 0 *)
  Mul 60 50; Mul 60 51; Add 95 1; Add 95 1; Mul 62 54; Mul 62 55; Add 97 1; Add 97 1; Mul 64 58;
  Mul 64 59; Add 99 1; Add 99 1; Mul 66 62; Mul 66 63; Add 101 1; Add 101 1; Mul 68 66; Mul 68 67;
  Add 103 1; Add 103 1; Sub 13 17; Sub 13 17; Sub 11 19; Sub 11 19; Mul 3 0; Mul 3 2; Sub 1 0;
  Add 108 0; Sub 13 25; Sub 13 25; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 15 31; Sub 15 31;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 102; Sub 0 41;
  ShowZero 0; (* area *)
  Mul 21 88; Mul 21 90; Sub 1 0; Mul 94 21; Mul 94 23; Sub 1 0; Add 3 0; Add 130 0; Mul 27 82;
  Mul 27 84; Sub 1 0; Mul 100 23; Mul 100 25; Sub 1 0; Add 3 0; Add 7 0; Mul 29 76; Mul 29 78;
  Sub 1 0; Mul 94 25; Mul 94 27; Sub 1 0; Add 3 0; Add 7 0; Constant 1; Div 0 128; Mul 78 0;
  Mul 74 1; Mul 120 0; Add 2 0; Add 3 0; Mul 123 0; Add 7 0; Div 8 0; Mul 4 0; Div 10 36;
  Mul 12 0; Sub 0 2;
  ShowZero 0; (* H *)
  Mul 10 4; Mul 86 3; Sub 0 1;
  ShowZero 0 (* K *)
].

Theorem part_1_size_5_valid : valid part_1_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** (15)-(18) on the corners of F + dS; size 6.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/space/point.rs *)
Definition part_1_size_6 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Sub 9 11; Sub 9 11; Constant 0; Sub 10 14;
  Sub 10 14; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0; Sub 14 20; Sub 14 20; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Sub 18 26; Sub 18 26; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 22 32; Sub 22 32;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Constant 2; Mul 1 0;
  Nonzero 0; (* area(F) != 0 *)
  Unknown 12; Unknown 13; Unknown 14; Unknown 15; Unknown 16; Unknown 17; Unknown 18; Unknown 19;
  Unknown 20; Unknown 21; Unknown 22; Unknown 23; Unknown 24; Sub 10 12; Sub 10 12; Sub 10 14;
  Sub 10 14; Mul 45 0; Mul 45 2; Sub 1 0; Mul 6 44; Mul 6 46; Sub 1 0; Add 3 0; Add 50 0;
  Mul 11 8; Mul 11 10; Sub 1 0; Add 54 0; Sub 22 28; Sub 22 28; Mul 56 0; Mul 56 2; Sub 1 0;
  Mul 18 52; Mul 18 54; Sub 1 0; Add 3 0; Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0;
  Sub 34 42; Sub 34 42; Mul 64 0; Mul 64 2; Sub 1 0; Mul 18 60; Mul 18 62; Sub 1 0; Add 3 0;
  Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0; Sub 46 56; Sub 46 56; Mul 72 0; Mul 72 2;
  Sub 1 0; Mul 18 68; Mul 18 70; Sub 1 0; Add 3 0; Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0;
  Add 13 0; Mul 0 72; Mul 59 0; Add 6 0; Add 7 0; Mul 62 0; Add 76 0;
  Nonzero 0; (* 1 + 2dH + d²K != 0, that is, area(F + dS) != 0 *)
  Mul 76 64; Mul 76 65; Add 119 1; Add 119 1; Mul 78 68; Mul 78 69; Add 121 1; Add 121 1;
  Mul 80 72; Mul 80 73; Add 123 1; Add 123 1; Mul 82 76; Mul 82 77; Add 125 1; Add 125 1;
  Mul 84 80; Mul 84 81; Add 127 1; Add 127 1; Mul 86 84; Mul 86 85; Add 129 1; Add 129 1;
  Sub 17 21; Sub 17 21; Sub 15 23; Sub 15 23; Mul 3 0; Mul 3 2; Sub 1 0; Add 134 0; Sub 17 29;
  Sub 17 29; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 19 35; Sub 19 35; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Sub 21 41; Sub 21 41; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 128; Sub 0 51;
  ShowZero 0; (* area *)
  Mul 27 112; Mul 27 114; Sub 1 0; Mul 118 27; Mul 118 29; Sub 1 0; Add 3 0; Add 162 0;
  Mul 33 106; Mul 33 108; Sub 1 0; Mul 124 29; Mul 124 31; Sub 1 0; Add 3 0; Add 7 0; Mul 35 100;
  Mul 35 102; Sub 1 0; Mul 118 31; Mul 118 33; Sub 1 0; Add 3 0; Add 7 0; Mul 37 94; Mul 37 96;
  Sub 1 0; Mul 112 33; Mul 112 35; Sub 1 0; Add 3 0; Add 7 0; Constant 1; Div 0 162; Mul 96 0;
  Mul 92 1; Mul 152 0; Add 2 0; Add 3 0; Mul 155 0; Add 7 0; Div 8 0; Mul 4 0; Div 10 44;
  Mul 12 0; Sub 0 2;
  ShowZero 0; (* H *)
  Mul 10 4; Mul 104 3; Sub 0 1;
  ShowZero 0 (* K *)
].

Theorem part_1_size_6_valid : valid part_1_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** (15)-(18) on the corners of F + dS; size 7.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/space/point.rs *)
Definition part_1_size_7 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Sub 11 13; Sub 11 13;
  Constant 0; Sub 12 16; Sub 12 16; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0; Sub 16 22; Sub 16 22;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 20 28; Sub 20 28; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 24 34; Sub 24 34; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 28 40; Sub 28 40; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Constant 2; Mul 1 0;
  Nonzero 0; (* area(F) != 0 *)
  Unknown 14; Unknown 15; Unknown 16; Unknown 17; Unknown 18; Unknown 19; Unknown 20; Unknown 21;
  Unknown 22; Unknown 23; Unknown 24; Unknown 25; Unknown 26; Unknown 27; Unknown 28; Sub 12 14;
  Sub 12 14; Sub 12 16; Sub 12 16; Mul 53 0; Mul 53 2; Sub 1 0; Mul 6 52; Mul 6 54; Sub 1 0;
  Add 3 0; Add 58 0; Mul 11 8; Mul 11 10; Sub 1 0; Add 62 0; Sub 24 30; Sub 24 30; Mul 64 0;
  Mul 64 2; Sub 1 0; Mul 18 60; Mul 18 62; Sub 1 0; Add 3 0; Add 13 0; Mul 23 8; Mul 23 10;
  Sub 1 0; Add 13 0; Sub 36 44; Sub 36 44; Mul 72 0; Mul 72 2; Sub 1 0; Mul 18 68; Mul 18 70;
  Sub 1 0; Add 3 0; Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0; Sub 48 58; Sub 48 58;
  Mul 80 0; Mul 80 2; Sub 1 0; Mul 18 76; Mul 18 78; Sub 1 0; Add 3 0; Add 13 0; Mul 23 8;
  Mul 23 10; Sub 1 0; Add 13 0; Sub 60 72; Sub 60 72; Mul 88 0; Mul 88 2; Sub 1 0; Mul 18 84;
  Mul 18 86; Sub 1 0; Add 3 0; Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0; Mul 0 88;
  Mul 73 0; Add 6 0; Add 7 0; Mul 76 0; Add 92 0;
  Nonzero 0; (* 1 + 2dH + d²K != 0, that is, area(F + dS) != 0 *)
  Mul 92 78; Mul 92 79; Add 143 1; Add 143 1; Mul 94 82; Mul 94 83; Add 145 1; Add 145 1;
  Mul 96 86; Mul 96 87; Add 147 1; Add 147 1; Mul 98 90; Mul 98 91; Add 149 1; Add 149 1;
  Mul 100 94; Mul 100 95; Add 151 1; Add 151 1; Mul 102 98; Mul 102 99; Add 153 1; Add 153 1;
  Mul 104 102; Mul 104 103; Add 155 1; Add 155 1; Sub 21 25; Sub 21 25; Sub 19 27; Sub 19 27;
  Mul 3 0; Mul 3 2; Sub 1 0; Add 160 0; Sub 21 33; Sub 21 33; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 23 39; Sub 23 39; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 25 45; Sub 25 45; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 27 51; Sub 27 51; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 154;
  Sub 0 61;
  ShowZero 0; (* area *)
  Mul 33 136; Mul 33 138; Sub 1 0; Mul 142 33; Mul 142 35; Sub 1 0; Add 3 0; Add 194 0;
  Mul 39 130; Mul 39 132; Sub 1 0; Mul 148 35; Mul 148 37; Sub 1 0; Add 3 0; Add 7 0; Mul 41 124;
  Mul 41 126; Sub 1 0; Mul 142 37; Mul 142 39; Sub 1 0; Add 3 0; Add 7 0; Mul 43 118; Mul 43 120;
  Sub 1 0; Mul 136 39; Mul 136 41; Sub 1 0; Add 3 0; Add 7 0; Mul 45 112; Mul 45 114; Sub 1 0;
  Mul 130 41; Mul 130 43; Sub 1 0; Add 3 0; Add 7 0; Constant 1; Div 0 196; Mul 114 0; Mul 110 1;
  Mul 184 0; Add 2 0; Add 3 0; Mul 187 0; Add 7 0; Div 8 0; Mul 4 0; Div 10 52; Mul 12 0; Sub 0 2;
  ShowZero 0; (* H *)
  Mul 10 4; Mul 122 3; Sub 0 1;
  ShowZero 0 (* K *)
].

Theorem part_1_size_7_valid : valid part_1_size_7.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** (15)-(18) on the corners of F + dS; size 8.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/space/point.rs *)
Definition part_1_size_8 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Sub 13 15; Sub 13 15; Constant 0; Sub 14 18; Sub 14 18; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0;
  Sub 18 24; Sub 18 24; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 22 30; Sub 22 30; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 26 36; Sub 26 36; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 30 42;
  Sub 30 42; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 34 48; Sub 34 48; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Constant 2; Mul 1 0;
  Nonzero 0; (* area(F) != 0 *)
  Unknown 16; Unknown 17; Unknown 18; Unknown 19; Unknown 20; Unknown 21; Unknown 22; Unknown 23;
  Unknown 24; Unknown 25; Unknown 26; Unknown 27; Unknown 28; Unknown 29; Unknown 30; Unknown 31;
  Unknown 32; Sub 14 16; Sub 14 16; Sub 14 18; Sub 14 18; Mul 61 0; Mul 61 2; Sub 1 0; Mul 6 60;
  Mul 6 62; Sub 1 0; Add 3 0; Add 66 0; Mul 11 8; Mul 11 10; Sub 1 0; Add 70 0; Sub 26 32;
  Sub 26 32; Mul 72 0; Mul 72 2; Sub 1 0; Mul 18 68; Mul 18 70; Sub 1 0; Add 3 0; Add 13 0;
  Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0; Sub 38 46; Sub 38 46; Mul 80 0; Mul 80 2; Sub 1 0;
  Mul 18 76; Mul 18 78; Sub 1 0; Add 3 0; Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0;
  Sub 50 60; Sub 50 60; Mul 88 0; Mul 88 2; Sub 1 0; Mul 18 84; Mul 18 86; Sub 1 0; Add 3 0;
  Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0; Sub 62 74; Sub 62 74; Mul 96 0; Mul 96 2;
  Sub 1 0; Mul 18 92; Mul 18 94; Sub 1 0; Add 3 0; Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0;
  Add 13 0; Sub 74 88; Sub 74 88; Mul 104 0; Mul 104 2; Sub 1 0; Mul 18 100; Mul 18 102; Sub 1 0;
  Add 3 0; Add 13 0; Mul 23 8; Mul 23 10; Sub 1 0; Add 13 0; Mul 0 104; Mul 87 0; Add 6 0;
  Add 7 0; Mul 90 0; Add 108 0;
  Nonzero 0; (* 1 + 2dH + d²K != 0, that is, area(F + dS) != 0 *)
  Mul 108 92; Mul 108 93; Add 167 1; Add 167 1; Mul 110 96; Mul 110 97; Add 169 1; Add 169 1;
  Mul 112 100; Mul 112 101; Add 171 1; Add 171 1; Mul 114 104; Mul 114 105; Add 173 1; Add 173 1;
  Mul 116 108; Mul 116 109; Add 175 1; Add 175 1; Mul 118 112; Mul 118 113; Add 177 1; Add 177 1;
  Mul 120 116; Mul 120 117; Add 179 1; Add 179 1; Mul 122 120; Mul 122 121; Add 181 1; Add 181 1;
  Sub 25 29; Sub 25 29; Sub 23 31; Sub 23 31; Mul 3 0; Mul 3 2; Sub 1 0; Add 186 0; Sub 25 37;
  Sub 25 37; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 27 43; Sub 27 43; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Sub 29 49; Sub 29 49; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 31 55; Sub 31 55;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 33 61; Sub 33 61; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Mul 0 180; Sub 0 71;
  ShowZero 0; (* area *)
  Mul 39 160; Mul 39 162; Sub 1 0; Mul 166 39; Mul 166 41; Sub 1 0; Add 3 0; Add 226 0;
  Mul 45 154; Mul 45 156; Sub 1 0; Mul 172 41; Mul 172 43; Sub 1 0; Add 3 0; Add 7 0; Mul 47 148;
  Mul 47 150; Sub 1 0; Mul 166 43; Mul 166 45; Sub 1 0; Add 3 0; Add 7 0; Mul 49 142; Mul 49 144;
  Sub 1 0; Mul 160 45; Mul 160 47; Sub 1 0; Add 3 0; Add 7 0; Mul 51 136; Mul 51 138; Sub 1 0;
  Mul 154 47; Mul 154 49; Sub 1 0; Add 3 0; Add 7 0; Mul 53 130; Mul 53 132; Sub 1 0; Mul 148 49;
  Mul 148 51; Sub 1 0; Add 3 0; Add 7 0; Constant 1; Div 0 230; Mul 132 0; Mul 128 1; Mul 216 0;
  Add 2 0; Add 3 0; Mul 219 0; Add 7 0; Div 8 0; Mul 4 0; Div 10 60; Mul 12 0; Sub 0 2;
  ShowZero 0; (* H *)
  Mul 10 4; Mul 140 3; Sub 0 1;
  ShowZero 0 (* K *)
].

Theorem part_1_size_8_valid : valid part_1_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
