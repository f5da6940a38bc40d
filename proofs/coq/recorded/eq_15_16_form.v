(** eq-15-16-form (Sec. 4, (15), (16))

    The mixed area of polygons with k corners is the polar form of the area: symmetric, linear in
    each polygon, unchanged by translations.

        area(F + dS) = area(F) + 2d area(F, S) + d² area(S)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the law of offsets, symmetry, linearity, translations; size 3.
    Code: src/pair/area.rs, src/space/point.rs *)
Definition part_1_size_3 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Mul 6 0; Mul 6 1; Add 14 1; Add 14 1;
  Mul 8 4; Mul 8 5; Add 16 1; Add 16 1; Mul 10 8; Mul 10 9; Add 18 1; Add 18 1; Constant 2;
  Sub 23 25; Sub 23 25; Constant 0; Sub 24 28; Sub 24 28; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0;
  Mul 9 0; Mul 10 23; Sub 28 30; Sub 28 30; Sub 28 32; Sub 28 32; Mul 14 0; Mul 14 2; Sub 1 0;
  Add 15 0; Mul 7 14; Mul 7 16; Sub 1 0; Add 3 0; Mul 12 0; Add 14 0; Mul 38 38; Mul 26 0;
  Mul 15 12; Mul 15 14; Sub 1 0; Add 27 0; Mul 4 0; Add 7 0; Sub 39 43; Sub 39 43; Sub 37 45;
  Sub 37 45; Mul 3 0; Mul 3 2; Sub 1 0; Add 37 0; Mul 41 0; Sub 0 9;
  ShowZero 0; (* 4 area(F + dS) *)
  Add 40 21; Add 0 26; Sub 22 0;
  ShowZero 0; (* symmetric *)
  Unknown 13; Unknown 14; Unknown 15; Unknown 16; Unknown 17; Unknown 18; Sub 3 5; Sub 3 5;
  Sub 3 7; Sub 3 7; Mul 3 41; Mul 3 43; Sub 1 0; Add 56 0; Mul 48 4; Mul 48 6; Sub 1 0; Add 3 0;
  Mul 77 0; Add 42 0; Mul 19 79; Mul 19 80; Add 93 1; Add 93 1; Mul 21 83; Mul 21 84; Add 95 1;
  Add 95 1; Mul 23 87; Mul 23 88; Add 97 1; Add 97 1; Sub 5 9; Sub 5 9; Sub 3 11; Sub 3 11;
  Mul 3 67; Mul 3 69; Sub 1 0; Add 82 0; Mul 74 4; Mul 74 6; Sub 1 0; Add 3 0; Sub 0 24;
  ShowZero 0; (* linear *)
  Unknown 19; Unknown 20; Add 118 1; Add 118 1; Add 118 3; Add 118 3; Add 118 5; Add 118 5;
  Sub 3 5; Sub 3 5; Sub 3 7; Sub 3 7; Mul 3 88; Mul 3 90; Sub 1 0; Add 103 0; Mul 95 4; Mul 95 6;
  Sub 1 0; Add 3 0; Sub 0 88;
  ShowZero 0 (* translated *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the law of offsets, symmetry, linearity, translations; size 4.
    Code: src/pair/area.rs, src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Unknown 16; Mul 8 0; Mul 8 1; Add 18 1; Add 18 1; Mul 10 4; Mul 10 5; Add 20 1; Add 20 1;
  Mul 12 8; Mul 12 9; Add 22 1; Add 22 1; Mul 14 12; Mul 14 13; Add 24 1; Add 24 1; Constant 2;
  Sub 31 33; Sub 31 33; Constant 0; Sub 32 36; Sub 32 36; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0;
  Sub 36 42; Sub 36 42; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 15 0; Mul 16 33; Sub 40 42;
  Sub 40 42; Sub 40 44; Sub 40 44; Mul 20 0; Mul 20 2; Sub 1 0; Add 21 0; Mul 7 20; Mul 7 22;
  Sub 1 0; Add 3 0; Sub 48 54; Sub 48 54; Mul 27 0; Mul 27 2; Sub 1 0; Add 5 0; Mul 15 24;
  Mul 15 26; Sub 1 0; Add 3 0; Mul 22 0; Add 24 0; Mul 58 58; Mul 42 0; Mul 25 22; Mul 25 24;
  Sub 1 0; Add 43 0; Mul 27 16; Mul 27 18; Sub 1 0; Add 3 0; Mul 8 0; Add 11 0; Sub 63 67;
  Sub 63 67; Sub 61 69; Sub 61 69; Mul 3 0; Mul 3 2; Sub 1 0; Add 57 0; Sub 63 75; Sub 63 75;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 67 0; Sub 0 15;
  ShowZero 0; (* 4 area(F + dS) *)
  Add 66 41; Add 0 46; Add 0 33; Add 0 38; Sub 34 0;
  ShowZero 0; (* symmetric *)
  Unknown 17; Unknown 18; Unknown 19; Unknown 20; Unknown 21; Unknown 22; Unknown 23; Unknown 24;
  Sub 5 7; Sub 5 7; Sub 5 9; Sub 5 9; Mul 3 65; Mul 3 67; Sub 1 0; Add 86 0; Mul 72 4; Mul 72 6;
  Sub 1 0; Add 3 0; Sub 13 19; Sub 13 19; Mul 11 65; Mul 11 67; Sub 1 0; Add 5 0; Mul 80 4;
  Mul 80 6; Sub 1 0; Add 3 0; Mul 121 0; Add 66 0; Mul 31 123; Mul 31 124; Add 141 1; Add 141 1;
  Mul 33 127; Mul 33 128; Add 143 1; Add 143 1; Mul 35 131; Mul 35 132; Add 145 1; Add 145 1;
  Mul 37 135; Mul 37 136; Add 147 1; Add 147 1; Sub 9 13; Sub 9 13; Sub 7 15; Sub 7 15; Mul 3 105;
  Mul 3 107; Sub 1 0; Add 126 0; Mul 112 4; Mul 112 6; Sub 1 0; Add 3 0; Sub 13 25; Sub 13 25;
  Mul 11 105; Mul 11 107; Sub 1 0; Add 5 0; Mul 120 4; Mul 120 6; Sub 1 0; Add 3 0; Sub 0 38;
  ShowZero 0; (* linear *)
  Unknown 25; Unknown 26; Add 180 1; Add 180 1; Add 180 3; Add 180 3; Add 180 5; Add 180 5;
  Add 180 7; Add 180 7; Sub 5 7; Sub 5 7; Sub 5 9; Sub 5 9; Mul 3 138; Mul 3 140; Sub 1 0;
  Add 159 0; Mul 145 4; Mul 145 6; Sub 1 0; Add 3 0; Sub 13 19; Sub 13 19; Mul 11 138; Mul 11 140;
  Sub 1 0; Add 5 0; Mul 153 4; Mul 153 6; Sub 1 0; Add 3 0; Sub 0 138;
  ShowZero 0 (* translated *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the law of offsets, symmetry, linearity, translations; size 5.
    Code: src/pair/area.rs, src/space/point.rs *)
Definition part_1_size_5 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Unknown 16; Unknown 17; Unknown 18; Unknown 19; Unknown 20; Mul 10 0; Mul 10 1; Add 22 1;
  Add 22 1; Mul 12 4; Mul 12 5; Add 24 1; Add 24 1; Mul 14 8; Mul 14 9; Add 26 1; Add 26 1;
  Mul 16 12; Mul 16 13; Add 28 1; Add 28 1; Mul 18 16; Mul 18 17; Add 30 1; Add 30 1; Constant 2;
  Sub 39 41; Sub 39 41; Constant 0; Sub 40 44; Sub 40 44; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0;
  Sub 44 50; Sub 44 50; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 48 56; Sub 48 56; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Mul 21 0; Mul 22 43; Sub 52 54; Sub 52 54; Sub 52 56; Sub 52 56;
  Mul 26 0; Mul 26 2; Sub 1 0; Add 27 0; Mul 7 26; Mul 7 28; Sub 1 0; Add 3 0; Sub 60 66;
  Sub 60 66; Mul 33 0; Mul 33 2; Sub 1 0; Add 5 0; Mul 15 30; Mul 15 32; Sub 1 0; Add 3 0;
  Sub 68 76; Sub 68 76; Mul 37 0; Mul 37 2; Sub 1 0; Add 5 0; Mul 15 34; Mul 15 36; Sub 1 0;
  Add 3 0; Mul 32 0; Add 34 0; Mul 78 78; Mul 58 0; Mul 35 32; Mul 35 34; Sub 1 0; Add 59 0;
  Mul 37 26; Mul 37 28; Sub 1 0; Add 3 0; Mul 31 20; Mul 31 22; Sub 1 0; Add 3 0; Mul 12 0;
  Add 15 0; Sub 87 91; Sub 87 91; Sub 85 93; Sub 85 93; Mul 3 0; Mul 3 2; Sub 1 0; Add 77 0;
  Sub 87 99; Sub 87 99; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 89 105; Sub 89 105; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Mul 93 0; Sub 0 21;
  ShowZero 0; (* 4 area(F + dS) *)
  Add 92 61; Add 0 66; Add 0 53; Add 0 58; Add 0 45; Add 0 50; Sub 46 0;
  ShowZero 0; (* symmetric *)
  Unknown 21; Unknown 22; Unknown 23; Unknown 24; Unknown 25; Unknown 26; Unknown 27; Unknown 28;
  Unknown 29; Unknown 30; Sub 7 9; Sub 7 9; Sub 7 11; Sub 7 11; Mul 3 89; Mul 3 91; Sub 1 0;
  Add 116 0; Mul 96 4; Mul 96 6; Sub 1 0; Add 3 0; Sub 15 21; Sub 15 21; Mul 11 89; Mul 11 91;
  Sub 1 0; Add 5 0; Mul 104 4; Mul 104 6; Sub 1 0; Add 3 0; Sub 23 31; Sub 23 31; Mul 11 89;
  Mul 11 91; Sub 1 0; Add 5 0; Mul 104 4; Mul 104 6; Sub 1 0; Add 3 0; Mul 165 0; Add 90 0;
  Mul 43 167; Mul 43 168; Add 189 1; Add 189 1; Mul 45 171; Mul 45 172; Add 191 1; Add 191 1;
  Mul 47 175; Mul 47 176; Add 193 1; Add 193 1; Mul 49 179; Mul 49 180; Add 195 1; Add 195 1;
  Mul 51 183; Mul 51 184; Add 197 1; Add 197 1; Sub 13 17; Sub 13 17; Sub 11 19; Sub 11 19;
  Mul 3 143; Mul 3 145; Sub 1 0; Add 170 0; Mul 150 4; Mul 150 6; Sub 1 0; Add 3 0; Sub 17 29;
  Sub 17 29; Mul 11 143; Mul 11 145; Sub 1 0; Add 5 0; Mul 158 4; Mul 158 6; Sub 1 0; Add 3 0;
  Sub 23 39; Sub 23 39; Mul 11 143; Mul 11 145; Sub 1 0; Add 5 0; Mul 158 4; Mul 158 6; Sub 1 0;
  Add 3 0; Sub 0 52;
  ShowZero 0; (* linear *)
  Unknown 31; Unknown 32; Add 242 1; Add 242 1; Add 242 3; Add 242 3; Add 242 5; Add 242 5;
  Add 242 7; Add 242 7; Add 242 9; Add 242 9; Sub 7 9; Sub 7 9; Sub 7 11; Sub 7 11; Mul 3 188;
  Mul 3 190; Sub 1 0; Add 215 0; Mul 195 4; Mul 195 6; Sub 1 0; Add 3 0; Sub 15 21; Sub 15 21;
  Mul 11 188; Mul 11 190; Sub 1 0; Add 5 0; Mul 203 4; Mul 203 6; Sub 1 0; Add 3 0; Sub 23 31;
  Sub 23 31; Mul 11 188; Mul 11 190; Sub 1 0; Add 5 0; Mul 203 4; Mul 203 6; Sub 1 0; Add 3 0;
  Sub 0 188;
  ShowZero 0 (* translated *)
].

Theorem part_1_size_5_valid : valid part_1_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the law of offsets, symmetry, linearity, translations; size 6.
    Code: src/pair/area.rs, src/space/point.rs *)
Definition part_1_size_6 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Unknown 16; Unknown 17; Unknown 18; Unknown 19; Unknown 20; Unknown 21; Unknown 22; Unknown 23;
  Unknown 24; Mul 12 0; Mul 12 1; Add 26 1; Add 26 1; Mul 14 4; Mul 14 5; Add 28 1; Add 28 1;
  Mul 16 8; Mul 16 9; Add 30 1; Add 30 1; Mul 18 12; Mul 18 13; Add 32 1; Add 32 1; Mul 20 16;
  Mul 20 17; Add 34 1; Add 34 1; Mul 22 20; Mul 22 21; Add 36 1; Add 36 1; Constant 2; Sub 47 49;
  Sub 47 49; Constant 0; Sub 48 52; Sub 48 52; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0; Sub 52 58;
  Sub 52 58; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 56 64; Sub 56 64; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Sub 60 70; Sub 60 70; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 27 0; Mul 28 53;
  Sub 64 66; Sub 64 66; Sub 64 68; Sub 64 68; Mul 32 0; Mul 32 2; Sub 1 0; Add 33 0; Mul 7 32;
  Mul 7 34; Sub 1 0; Add 3 0; Sub 72 78; Sub 72 78; Mul 39 0; Mul 39 2; Sub 1 0; Add 5 0;
  Mul 15 36; Mul 15 38; Sub 1 0; Add 3 0; Sub 80 88; Sub 80 88; Mul 43 0; Mul 43 2; Sub 1 0;
  Add 5 0; Mul 15 40; Mul 15 42; Sub 1 0; Add 3 0; Sub 88 98; Sub 88 98; Mul 47 0; Mul 47 2;
  Sub 1 0; Add 5 0; Mul 15 44; Mul 15 46; Sub 1 0; Add 3 0; Mul 42 0; Add 44 0; Mul 98 98;
  Mul 74 0; Mul 45 42; Mul 45 44; Sub 1 0; Add 75 0; Mul 47 36; Mul 47 38; Sub 1 0; Add 3 0;
  Mul 41 30; Mul 41 32; Sub 1 0; Add 3 0; Mul 35 24; Mul 35 26; Sub 1 0; Add 3 0; Mul 16 0;
  Add 19 0; Sub 111 115; Sub 111 115; Sub 109 117; Sub 109 117; Mul 3 0; Mul 3 2; Sub 1 0;
  Add 97 0; Sub 111 123; Sub 111 123; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 113 129;
  Sub 113 129; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 115 135; Sub 115 135; Mul 7 0; Mul 7 2;
  Sub 1 0; Add 5 0; Mul 119 0; Sub 0 27;
  ShowZero 0; (* 4 area(F + dS) *)
  Add 118 81; Add 0 86; Add 0 73; Add 0 78; Add 0 65; Add 0 70; Add 0 57; Add 0 62; Sub 58 0;
  ShowZero 0; (* symmetric *)
  Unknown 25; Unknown 26; Unknown 27; Unknown 28; Unknown 29; Unknown 30; Unknown 31; Unknown 32;
  Unknown 33; Unknown 34; Unknown 35; Unknown 36; Sub 9 11; Sub 9 11; Sub 9 13; Sub 9 13;
  Mul 3 113; Mul 3 115; Sub 1 0; Add 146 0; Mul 120 4; Mul 120 6; Sub 1 0; Add 3 0; Sub 17 23;
  Sub 17 23; Mul 11 113; Mul 11 115; Sub 1 0; Add 5 0; Mul 128 4; Mul 128 6; Sub 1 0; Add 3 0;
  Sub 25 33; Sub 25 33; Mul 11 113; Mul 11 115; Sub 1 0; Add 5 0; Mul 128 4; Mul 128 6; Sub 1 0;
  Add 3 0; Sub 33 43; Sub 33 43; Mul 11 113; Mul 11 115; Sub 1 0; Add 5 0; Mul 128 4; Mul 128 6;
  Sub 1 0; Add 3 0; Mul 209 0; Add 114 0; Mul 55 211; Mul 55 212; Add 237 1; Add 237 1;
  Mul 57 215; Mul 57 216; Add 239 1; Add 239 1; Mul 59 219; Mul 59 220; Add 241 1; Add 241 1;
  Mul 61 223; Mul 61 224; Add 243 1; Add 243 1; Mul 63 227; Mul 63 228; Add 245 1; Add 245 1;
  Mul 65 231; Mul 65 232; Add 247 1; Add 247 1; Sub 17 21; Sub 17 21; Sub 15 23; Sub 15 23;
  Mul 3 181; Mul 3 183; Sub 1 0; Add 214 0; Mul 188 4; Mul 188 6; Sub 1 0; Add 3 0; Sub 21 33;
  Sub 21 33; Mul 11 181; Mul 11 183; Sub 1 0; Add 5 0; Mul 196 4; Mul 196 6; Sub 1 0; Add 3 0;
  Sub 27 43; Sub 27 43; Mul 11 181; Mul 11 183; Sub 1 0; Add 5 0; Mul 196 4; Mul 196 6; Sub 1 0;
  Add 3 0; Sub 33 53; Sub 33 53; Mul 11 181; Mul 11 183; Sub 1 0; Add 5 0; Mul 196 4; Mul 196 6;
  Sub 1 0; Add 3 0; Sub 0 66;
  ShowZero 0; (* linear *)
  Unknown 37; Unknown 38; Add 304 1; Add 304 1; Add 304 3; Add 304 3; Add 304 5; Add 304 5;
  Add 304 7; Add 304 7; Add 304 9; Add 304 9; Add 304 11; Add 304 11; Sub 9 11; Sub 9 11;
  Sub 9 13; Sub 9 13; Mul 3 238; Mul 3 240; Sub 1 0; Add 271 0; Mul 245 4; Mul 245 6; Sub 1 0;
  Add 3 0; Sub 17 23; Sub 17 23; Mul 11 238; Mul 11 240; Sub 1 0; Add 5 0; Mul 253 4; Mul 253 6;
  Sub 1 0; Add 3 0; Sub 25 33; Sub 25 33; Mul 11 238; Mul 11 240; Sub 1 0; Add 5 0; Mul 253 4;
  Mul 253 6; Sub 1 0; Add 3 0; Sub 33 43; Sub 33 43; Mul 11 238; Mul 11 240; Sub 1 0; Add 5 0;
  Mul 253 4; Mul 253 6; Sub 1 0; Add 3 0; Sub 0 238;
  ShowZero 0 (* translated *)
].

Theorem part_1_size_6_valid : valid part_1_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the law of offsets, symmetry, linearity, translations; size 7.
    Code: src/pair/area.rs, src/space/point.rs *)
Definition part_1_size_7 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Unknown 16; Unknown 17; Unknown 18; Unknown 19; Unknown 20; Unknown 21; Unknown 22; Unknown 23;
  Unknown 24; Unknown 25; Unknown 26; Unknown 27; Unknown 28; Mul 14 0; Mul 14 1; Add 30 1;
  Add 30 1; Mul 16 4; Mul 16 5; Add 32 1; Add 32 1; Mul 18 8; Mul 18 9; Add 34 1; Add 34 1;
  Mul 20 12; Mul 20 13; Add 36 1; Add 36 1; Mul 22 16; Mul 22 17; Add 38 1; Add 38 1; Mul 24 20;
  Mul 24 21; Add 40 1; Add 40 1; Mul 26 24; Mul 26 25; Add 42 1; Add 42 1; Constant 2; Sub 55 57;
  Sub 55 57; Constant 0; Sub 56 60; Sub 56 60; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0; Sub 60 66;
  Sub 60 66; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 64 72; Sub 64 72; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Sub 68 78; Sub 68 78; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 72 84; Sub 72 84;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 33 0; Mul 34 63; Sub 76 78; Sub 76 78; Sub 76 80;
  Sub 76 80; Mul 38 0; Mul 38 2; Sub 1 0; Add 39 0; Mul 7 38; Mul 7 40; Sub 1 0; Add 3 0;
  Sub 84 90; Sub 84 90; Mul 45 0; Mul 45 2; Sub 1 0; Add 5 0; Mul 15 42; Mul 15 44; Sub 1 0;
  Add 3 0; Sub 92 100; Sub 92 100; Mul 49 0; Mul 49 2; Sub 1 0; Add 5 0; Mul 15 46; Mul 15 48;
  Sub 1 0; Add 3 0; Sub 100 110; Sub 100 110; Mul 53 0; Mul 53 2; Sub 1 0; Add 5 0; Mul 15 50;
  Mul 15 52; Sub 1 0; Add 3 0; Sub 108 120; Sub 108 120; Mul 57 0; Mul 57 2; Sub 1 0; Add 5 0;
  Mul 15 54; Mul 15 56; Sub 1 0; Add 3 0; Mul 52 0; Add 54 0; Mul 118 118; Mul 90 0; Mul 55 52;
  Mul 55 54; Sub 1 0; Add 91 0; Mul 57 46; Mul 57 48; Sub 1 0; Add 3 0; Mul 51 40; Mul 51 42;
  Sub 1 0; Add 3 0; Mul 45 34; Mul 45 36; Sub 1 0; Add 3 0; Mul 39 28; Mul 39 30; Sub 1 0;
  Add 3 0; Mul 20 0; Add 23 0; Sub 135 139; Sub 135 139; Sub 133 141; Sub 133 141; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 117 0; Sub 135 147; Sub 135 147; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 137 153; Sub 137 153; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 139 159; Sub 139 159; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 141 165; Sub 141 165; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Mul 145 0; Sub 0 33;
  ShowZero 0; (* 4 area(F + dS) *)
  Add 144 101; Add 0 106; Add 0 93; Add 0 98; Add 0 85; Add 0 90; Add 0 77; Add 0 82; Add 0 69;
  Add 0 74; Sub 70 0;
  ShowZero 0; (* symmetric *)
  Unknown 29; Unknown 30; Unknown 31; Unknown 32; Unknown 33; Unknown 34; Unknown 35; Unknown 36;
  Unknown 37; Unknown 38; Unknown 39; Unknown 40; Unknown 41; Unknown 42; Sub 11 13; Sub 11 13;
  Sub 11 15; Sub 11 15; Mul 3 137; Mul 3 139; Sub 1 0; Add 176 0; Mul 144 4; Mul 144 6; Sub 1 0;
  Add 3 0; Sub 19 25; Sub 19 25; Mul 11 137; Mul 11 139; Sub 1 0; Add 5 0; Mul 152 4; Mul 152 6;
  Sub 1 0; Add 3 0; Sub 27 35; Sub 27 35; Mul 11 137; Mul 11 139; Sub 1 0; Add 5 0; Mul 152 4;
  Mul 152 6; Sub 1 0; Add 3 0; Sub 35 45; Sub 35 45; Mul 11 137; Mul 11 139; Sub 1 0; Add 5 0;
  Mul 152 4; Mul 152 6; Sub 1 0; Add 3 0; Sub 43 55; Sub 43 55; Mul 11 137; Mul 11 139; Sub 1 0;
  Add 5 0; Mul 152 4; Mul 152 6; Sub 1 0; Add 3 0; Mul 253 0; Add 138 0; Mul 67 255; Mul 67 256;
  Add 285 1; Add 285 1; Mul 69 259; Mul 69 260; Add 287 1; Add 287 1; Mul 71 263; Mul 71 264;
  Add 289 1; Add 289 1; Mul 73 267; Mul 73 268; Add 291 1; Add 291 1; Mul 75 271; Mul 75 272;
  Add 293 1; Add 293 1; Mul 77 275; Mul 77 276; Add 295 1; Add 295 1; Mul 79 279; Mul 79 280;
  Add 297 1; Add 297 1; Sub 21 25; Sub 21 25; Sub 19 27; Sub 19 27; Mul 3 219; Mul 3 221; Sub 1 0;
  Add 258 0; Mul 226 4; Mul 226 6; Sub 1 0; Add 3 0; Sub 25 37; Sub 25 37; Mul 11 219; Mul 11 221;
  Sub 1 0; Add 5 0; Mul 234 4; Mul 234 6; Sub 1 0; Add 3 0; Sub 31 47; Sub 31 47; Mul 11 219;
  Mul 11 221; Sub 1 0; Add 5 0; Mul 234 4; Mul 234 6; Sub 1 0; Add 3 0; Sub 37 57; Sub 37 57;
  Mul 11 219; Mul 11 221; Sub 1 0; Add 5 0; Mul 234 4; Mul 234 6; Sub 1 0; Add 3 0; Sub 43 67;
  Sub 43 67; Mul 11 219; Mul 11 221; Sub 1 0; Add 5 0; Mul 234 4; Mul 234 6; Sub 1 0; Add 3 0;
  Sub 0 80;
  ShowZero 0; (* linear *)
  Unknown 43; Unknown 44; Add 366 1; Add 366 1; Add 366 3; Add 366 3; Add 366 5; Add 366 5;
  Add 366 7; Add 366 7; Add 366 9; Add 366 9; Add 366 11; Add 366 11; Add 366 13; Add 366 13;
  Sub 11 13; Sub 11 13; Sub 11 15; Sub 11 15; Mul 3 288; Mul 3 290; Sub 1 0; Add 327 0; Mul 295 4;
  Mul 295 6; Sub 1 0; Add 3 0; Sub 19 25; Sub 19 25; Mul 11 288; Mul 11 290; Sub 1 0; Add 5 0;
  Mul 303 4; Mul 303 6; Sub 1 0; Add 3 0; Sub 27 35; Sub 27 35; Mul 11 288; Mul 11 290; Sub 1 0;
  Add 5 0; Mul 303 4; Mul 303 6; Sub 1 0; Add 3 0; Sub 35 45; Sub 35 45; Mul 11 288; Mul 11 290;
  Sub 1 0; Add 5 0; Mul 303 4; Mul 303 6; Sub 1 0; Add 3 0; Sub 43 55; Sub 43 55; Mul 11 288;
  Mul 11 290; Sub 1 0; Add 5 0; Mul 303 4; Mul 303 6; Sub 1 0; Add 3 0; Sub 0 288;
  ShowZero 0 (* translated *)
].

Theorem part_1_size_7_valid : valid part_1_size_7.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the law of offsets, symmetry, linearity, translations; size 8.
    Code: src/pair/area.rs, src/space/point.rs *)
Definition part_1_size_8 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15;
  Unknown 16; Unknown 17; Unknown 18; Unknown 19; Unknown 20; Unknown 21; Unknown 22; Unknown 23;
  Unknown 24; Unknown 25; Unknown 26; Unknown 27; Unknown 28; Unknown 29; Unknown 30; Unknown 31;
  Unknown 32; Mul 16 0; Mul 16 1; Add 34 1; Add 34 1; Mul 18 4; Mul 18 5; Add 36 1; Add 36 1;
  Mul 20 8; Mul 20 9; Add 38 1; Add 38 1; Mul 22 12; Mul 22 13; Add 40 1; Add 40 1; Mul 24 16;
  Mul 24 17; Add 42 1; Add 42 1; Mul 26 20; Mul 26 21; Add 44 1; Add 44 1; Mul 28 24; Mul 28 25;
  Add 46 1; Add 46 1; Mul 30 28; Mul 30 29; Add 48 1; Add 48 1; Constant 2; Sub 63 65; Sub 63 65;
  Constant 0; Sub 64 68; Sub 64 68; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0; Sub 68 74; Sub 68 74;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 72 80; Sub 72 80; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 76 86; Sub 76 86; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 80 92; Sub 80 92; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 84 98; Sub 84 98; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 39 0;
  Mul 40 73; Sub 88 90; Sub 88 90; Sub 88 92; Sub 88 92; Mul 44 0; Mul 44 2; Sub 1 0; Add 45 0;
  Mul 7 44; Mul 7 46; Sub 1 0; Add 3 0; Sub 96 102; Sub 96 102; Mul 51 0; Mul 51 2; Sub 1 0;
  Add 5 0; Mul 15 48; Mul 15 50; Sub 1 0; Add 3 0; Sub 104 112; Sub 104 112; Mul 55 0; Mul 55 2;
  Sub 1 0; Add 5 0; Mul 15 52; Mul 15 54; Sub 1 0; Add 3 0; Sub 112 122; Sub 112 122; Mul 59 0;
  Mul 59 2; Sub 1 0; Add 5 0; Mul 15 56; Mul 15 58; Sub 1 0; Add 3 0; Sub 120 132; Sub 120 132;
  Mul 63 0; Mul 63 2; Sub 1 0; Add 5 0; Mul 15 60; Mul 15 62; Sub 1 0; Add 3 0; Sub 128 142;
  Sub 128 142; Mul 67 0; Mul 67 2; Sub 1 0; Add 5 0; Mul 15 64; Mul 15 66; Sub 1 0; Add 3 0;
  Mul 62 0; Add 64 0; Mul 138 138; Mul 106 0; Mul 65 62; Mul 65 64; Sub 1 0; Add 107 0; Mul 67 56;
  Mul 67 58; Sub 1 0; Add 3 0; Mul 61 50; Mul 61 52; Sub 1 0; Add 3 0; Mul 55 44; Mul 55 46;
  Sub 1 0; Add 3 0; Mul 49 38; Mul 49 40; Sub 1 0; Add 3 0; Mul 43 32; Mul 43 34; Sub 1 0;
  Add 3 0; Mul 24 0; Add 27 0; Sub 159 163; Sub 159 163; Sub 157 165; Sub 157 165; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 137 0; Sub 159 171; Sub 159 171; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 161 177; Sub 161 177; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 163 183; Sub 163 183; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 165 189; Sub 165 189; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 167 195; Sub 167 195; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 171 0; Sub 0 39;
  ShowZero 0; (* 4 area(F + dS) *)
  Add 170 121; Add 0 126; Add 0 113; Add 0 118; Add 0 105; Add 0 110; Add 0 97; Add 0 102;
  Add 0 89; Add 0 94; Add 0 81; Add 0 86; Sub 82 0;
  ShowZero 0; (* symmetric *)
  Unknown 33; Unknown 34; Unknown 35; Unknown 36; Unknown 37; Unknown 38; Unknown 39; Unknown 40;
  Unknown 41; Unknown 42; Unknown 43; Unknown 44; Unknown 45; Unknown 46; Unknown 47; Unknown 48;
  Sub 13 15; Sub 13 15; Sub 13 17; Sub 13 17; Mul 3 161; Mul 3 163; Sub 1 0; Add 206 0; Mul 168 4;
  Mul 168 6; Sub 1 0; Add 3 0; Sub 21 27; Sub 21 27; Mul 11 161; Mul 11 163; Sub 1 0; Add 5 0;
  Mul 176 4; Mul 176 6; Sub 1 0; Add 3 0; Sub 29 37; Sub 29 37; Mul 11 161; Mul 11 163; Sub 1 0;
  Add 5 0; Mul 176 4; Mul 176 6; Sub 1 0; Add 3 0; Sub 37 47; Sub 37 47; Mul 11 161; Mul 11 163;
  Sub 1 0; Add 5 0; Mul 176 4; Mul 176 6; Sub 1 0; Add 3 0; Sub 45 57; Sub 45 57; Mul 11 161;
  Mul 11 163; Sub 1 0; Add 5 0; Mul 176 4; Mul 176 6; Sub 1 0; Add 3 0; Sub 53 67; Sub 53 67;
  Mul 11 161; Mul 11 163; Sub 1 0; Add 5 0; Mul 176 4; Mul 176 6; Sub 1 0; Add 3 0; Mul 297 0;
  Add 162 0; Mul 79 299; Mul 79 300; Add 333 1; Add 333 1; Mul 81 303; Mul 81 304; Add 335 1;
  Add 335 1; Mul 83 307; Mul 83 308; Add 337 1; Add 337 1; Mul 85 311; Mul 85 312; Add 339 1;
  Add 339 1; Mul 87 315; Mul 87 316; Add 341 1; Add 341 1; Mul 89 319; Mul 89 320; Add 343 1;
  Add 343 1; Mul 91 323; Mul 91 324; Add 345 1; Add 345 1; Mul 93 327; Mul 93 328; Add 347 1;
  Add 347 1; Sub 25 29; Sub 25 29; Sub 23 31; Sub 23 31; Mul 3 257; Mul 3 259; Sub 1 0; Add 302 0;
  Mul 264 4; Mul 264 6; Sub 1 0; Add 3 0; Sub 29 41; Sub 29 41; Mul 11 257; Mul 11 259; Sub 1 0;
  Add 5 0; Mul 272 4; Mul 272 6; Sub 1 0; Add 3 0; Sub 35 51; Sub 35 51; Mul 11 257; Mul 11 259;
  Sub 1 0; Add 5 0; Mul 272 4; Mul 272 6; Sub 1 0; Add 3 0; Sub 41 61; Sub 41 61; Mul 11 257;
  Mul 11 259; Sub 1 0; Add 5 0; Mul 272 4; Mul 272 6; Sub 1 0; Add 3 0; Sub 47 71; Sub 47 71;
  Mul 11 257; Mul 11 259; Sub 1 0; Add 5 0; Mul 272 4; Mul 272 6; Sub 1 0; Add 3 0; Sub 53 81;
  Sub 53 81; Mul 11 257; Mul 11 259; Sub 1 0; Add 5 0; Mul 272 4; Mul 272 6; Sub 1 0; Add 3 0;
  Sub 0 94;
  ShowZero 0; (* linear *)
  Unknown 49; Unknown 50; Add 428 1; Add 428 1; Add 428 3; Add 428 3; Add 428 5; Add 428 5;
  Add 428 7; Add 428 7; Add 428 9; Add 428 9; Add 428 11; Add 428 11; Add 428 13; Add 428 13;
  Add 428 15; Add 428 15; Sub 13 15; Sub 13 15; Sub 13 17; Sub 13 17; Mul 3 338; Mul 3 340;
  Sub 1 0; Add 383 0; Mul 345 4; Mul 345 6; Sub 1 0; Add 3 0; Sub 21 27; Sub 21 27; Mul 11 338;
  Mul 11 340; Sub 1 0; Add 5 0; Mul 353 4; Mul 353 6; Sub 1 0; Add 3 0; Sub 29 37; Sub 29 37;
  Mul 11 338; Mul 11 340; Sub 1 0; Add 5 0; Mul 353 4; Mul 353 6; Sub 1 0; Add 3 0; Sub 37 47;
  Sub 37 47; Mul 11 338; Mul 11 340; Sub 1 0; Add 5 0; Mul 353 4; Mul 353 6; Sub 1 0; Add 3 0;
  Sub 45 57; Sub 45 57; Mul 11 338; Mul 11 340; Sub 1 0; Add 5 0; Mul 353 4; Mul 353 6; Sub 1 0;
  Add 3 0; Sub 53 67; Sub 53 67; Mul 11 338; Mul 11 340; Sub 1 0; Add 5 0; Mul 353 4; Mul 353 6;
  Sub 1 0; Add 3 0; Sub 0 338;
  ShowZero 0 (* translated *)
].

Theorem part_1_size_8_valid : valid part_1_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
