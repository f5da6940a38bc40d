(** v-offset (ours)

    Moving the vertices of M by d times the heights of a v-parallel S changes the curvatures at
    vertices polynomially: the dual of (18).

        H(v^d) = H + d,  K(v^d) = K + 2dH + d²

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** any two v-parallel stars; size 3.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 8 0; Mul 8 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 4 12; Mul 4 14; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Sub 2 3; Sub 2 4; Constant 1; Div 0 17; Mul 3 21;
  Mul 24 3; Sub 1 0; Mul 0 3; Mul 28 6; Mul 8 27; Sub 1 0; Mul 0 7; Sub 12 15; Div 10 20;
  Mul 12 24; Mul 32 2; Sub 1 0; Mul 0 3; Mul 36 5; Mul 17 30; Sub 1 0; Mul 0 7; Div 19 26;
  Mul 10 42; Mul 34 23; Sub 1 0; Mul 0 3; Mul 38 26; Mul 15 48; Sub 1 0; Mul 0 7; Sub 13 23;
  Sub 10 20; Constant 0; Sub 7 26; Sub 4 23; Mul 4 0; Mul 4 2; Sub 1 0; Add 5 0; Mul 0 67;
  Constant 4; Div 39 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 70 70;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 70 70;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 70 70;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 70 70;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 70 70;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 70 70;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 63 63;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 63 63;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 12; Unknown 13; Unknown 14; Unknown 15; Unknown 16; Sub 3 4; Sub 3 5; Mul 1 76;
  Mul 79 1; Sub 1 0; Mul 0 58; Mul 83 4; Mul 6 82; Sub 1 0; Mul 0 62; Sub 11 14; Mul 9 78;
  Mul 86 1; Sub 1 0; Mul 0 57; Mul 90 4; Mul 14 84; Sub 1 0; Mul 0 61; Mul 8 95; Mul 87 19;
  Sub 1 0; Mul 0 56; Mul 91 22; Mul 13 101; Sub 1 0; Mul 0 60; Sub 12 21; Sub 9 18; Sub 6 23;
  Sub 3 20; Mul 3 52; Mul 3 54; Sub 1 0; Mul 59 3; Mul 59 5; Sub 1 0; Add 3 0; Add 61 0;
  Div 93 55; Mul 1 0; Mul 41 101; Add 46 0; Mul 43 102; Add 47 0; Mul 45 103; Add 48 0;
  Mul 47 104; Add 49 0; Sub 4 6; Sub 3 7; Mul 1 125; Mul 128 1; Sub 1 0; Mul 0 107; Mul 132 4;
  Mul 6 131; Sub 1 0; Mul 0 111; Sub 10 16; Mul 9 127; Mul 135 1; Sub 1 0; Mul 0 106; Mul 139 4;
  Mul 14 133; Sub 1 0; Mul 0 110; Mul 8 144; Mul 136 19; Sub 1 0; Mul 0 105; Mul 140 22;
  Mul 13 150; Sub 1 0; Mul 0 109; Sub 12 21; Sub 9 18; Sub 6 23; Sub 3 20; Mul 3 101; Mul 3 103;
  Sub 1 0; Mul 108 3; Mul 108 5; Sub 1 0; Add 3 0; Add 110 0; Mul 0 48; Add 48 89; Sub 1 0;
  ShowZero 0; (* H *)
  Mul 63 60; Mul 63 62; Sub 1 0; Add 117 0; Mul 0 179; Mul 0 56; Mul 20 17; Mul 20 19; Sub 1 0;
  Add 123 0; Mul 0 185; Mul 0 62; Add 62 13; Mul 104 0; Add 8 0; Sub 3 0;
  ShowZero 0; (* K *)
  ShowZero 16; (* H + d *)
  Mul 191 107; Mul 0 67; Add 12 0; Mul 110 110; Add 1 0; Sub 9 0;
  ShowZero 0 (* K + 2dH + d² *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** any two v-parallel stars; size 4.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 6; Unknown 7; Sub 1 14; Sub 1 14; Mul 8 0; Mul 8 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 8; Unknown 9; Sub 1 21; Sub 1 21; Mul 8 0; Mul 8 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 4 19; Mul 4 21; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Sub 3 4; Sub 3 5; Constant 1;
  Div 0 25; Mul 3 29; Mul 32 3; Sub 1 0; Mul 0 3; Mul 36 6; Mul 8 35; Sub 1 0; Mul 0 7; Sub 13 16;
  Div 10 28; Mul 12 32; Mul 40 2; Sub 1 0; Mul 0 3; Mul 44 5; Mul 17 38; Sub 1 0; Mul 0 7;
  Sub 22 26; Div 20 31; Mul 11 35; Mul 43 2; Sub 1 0; Mul 0 3; Mul 47 5; Mul 16 41; Sub 1 0;
  Mul 0 7; Div 29 37; Mul 10 60; Mul 45 33; Sub 1 0; Mul 0 3; Mul 49 36; Mul 15 66; Sub 1 0;
  Mul 0 7; Sub 23 33; Sub 20 30; Constant 0; Sub 16 36; Sub 13 33; Mul 4 0; Mul 4 2; Sub 1 0;
  Add 5 0; Sub 13 42; Sub 10 39; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 91; Constant 4;
  Div 55 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 94 94;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 94 94;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 94 94;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 94 94;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 94 94;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 94 94;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 87 87;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 87 87;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 82 82;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 82 82;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Unknown 15; Unknown 16; Unknown 17; Unknown 18; Unknown 19; Unknown 20; Sub 4 5; Sub 4 6;
  Mul 1 103; Mul 106 1; Sub 1 0; Mul 0 77; Mul 110 4; Mul 6 109; Sub 1 0; Mul 0 81; Sub 12 15;
  Mul 9 105; Mul 113 1; Sub 1 0; Mul 0 76; Mul 117 4; Mul 14 111; Sub 1 0; Mul 0 80; Sub 20 24;
  Mul 9 107; Mul 115 1; Sub 1 0; Mul 0 75; Mul 119 4; Mul 14 113; Sub 1 0; Mul 0 79; Mul 8 131;
  Mul 116 28; Sub 1 0; Mul 0 74; Mul 120 31; Mul 13 137; Sub 1 0; Mul 0 78; Sub 21 30; Sub 18 27;
  Sub 14 32; Sub 11 29; Mul 3 70; Mul 3 72; Sub 1 0; Mul 77 3; Mul 77 5; Sub 1 0; Add 3 0;
  Add 79 0; Sub 16 42; Sub 13 39; Mul 11 74; Mul 11 76; Sub 1 0; Mul 84 3; Mul 84 5; Sub 1 0;
  Add 3 0; Add 9 0; Div 131 77; Mul 1 0; Mul 60 140; Add 66 0; Mul 62 141; Add 67 0; Mul 64 142;
  Add 68 0; Mul 66 143; Add 69 0; Mul 68 144; Add 70 0; Sub 6 8; Sub 5 9; Mul 1 173; Mul 176 1;
  Sub 1 0; Mul 0 147; Mul 180 4; Mul 6 179; Sub 1 0; Mul 0 151; Sub 12 18; Mul 9 175; Mul 183 1;
  Sub 1 0; Mul 0 146; Mul 187 4; Mul 14 181; Sub 1 0; Mul 0 150; Sub 19 27; Mul 9 177; Mul 185 1;
  Sub 1 0; Mul 0 145; Mul 189 4; Mul 14 183; Sub 1 0; Mul 0 149; Mul 8 201; Mul 186 28; Sub 1 0;
  Mul 0 144; Mul 190 31; Mul 13 207; Sub 1 0; Mul 0 148; Sub 21 30; Sub 18 27; Sub 14 32;
  Sub 11 29; Mul 3 140; Mul 3 142; Sub 1 0; Mul 147 3; Mul 147 5; Sub 1 0; Add 3 0; Add 149 0;
  Sub 16 42; Sub 13 39; Mul 11 144; Mul 11 146; Sub 1 0; Mul 154 3; Mul 154 5; Sub 1 0; Add 3 0;
  Add 9 0; Mul 0 69; Add 69 129; Sub 1 0;
  ShowZero 0; (* H *)
  Mul 94 91; Mul 94 93; Sub 1 0; Add 166 0; Mul 96 85; Mul 96 87; Sub 1 0; Add 3 0; Mul 0 250;
  Mul 0 81; Mul 34 31; Mul 34 33; Sub 1 0; Add 176 0; Mul 36 25; Mul 36 27; Sub 1 0; Add 3 0;
  Mul 0 260; Mul 0 91; Add 91 21; Mul 152 0; Add 12 0; Sub 3 0;
  ShowZero 0; (* K *)
  ShowZero 24; (* H + d *)
  Mul 266 155; Mul 0 96; Add 16 0; Mul 158 158; Add 1 0; Sub 9 0;
  ShowZero 0 (* K + 2dH + d² *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 3.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Constant 0; Sub 6 8; Sub 6 8; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9;
  Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 8; Sub 26 22; Sub 26 22; Neg 0; Mul 0 3; Mul 3 4; Sub 1 23; Sub 1 24; Mul 12 0;
  Mul 12 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 4 16; Mul 4 18; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 9; Mul 31 0; Mul 31 1; Add 34 1; Add 35 1; Mul 30 4; Mul 30 5; Add 3 1; Add 3 1;
  Mul 40 36; Mul 41 36; Add 1 0; Mul 8 34; Mul 8 34; Add 1 0; Mul 7 24; Mul 7 24; Add 1 0;
  Sub 0 49; Sub 7 50; Constant 1; Div 0 21; Mul 3 41; Mul 29 3; Sub 1 0; Mul 0 3; Mul 33 6;
  Mul 8 47; Sub 1 0; Mul 0 7; Sub 15 61; Div 10 45; Mul 12 49; Mul 52 2; Sub 1 0; Mul 0 3;
  Mul 56 5; Mul 17 55; Sub 1 0; Mul 0 7; Div 19 43; Mul 10 47; Mul 59 23; Sub 1 0; Mul 0 3;
  Mul 63 26; Mul 15 53; Sub 1 0; Mul 0 7; Sub 13 23; Sub 10 20; Sub 6 25; Sub 3 22; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 87 0; Mul 0 97; Constant 4; Div 38 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 92 92;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 89 89;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 89 89;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 86 86;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 86 86;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 75 75;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 75 75;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 107 95; Mul 107 95; Add 1 0; Mul 108 93; Mul 108 93; Add 1 0; Mul 109 83; Mul 109 83;
  Add 1 0; Unknown 10; Sub 1 109; Sub 8 110; Mul 1 99; Mul 87 1; Sub 1 0; Mul 0 61; Mul 91 4;
  Mul 6 105; Sub 1 0; Mul 0 65; Sub 14 119; Mul 9 106; Mul 109 1; Sub 1 0; Mul 0 60; Mul 113 4;
  Mul 14 112; Sub 1 0; Mul 0 64; Mul 8 103; Mul 115 19; Sub 1 0; Mul 0 59; Mul 119 22; Mul 13 109;
  Sub 1 0; Mul 0 63; Sub 12 21; Sub 9 18; Sub 6 23; Sub 3 20; Mul 3 56; Mul 3 58; Sub 1 0;
  Mul 62 3; Mul 62 5; Sub 1 0; Add 3 0; Add 147 0; Div 96 59; Mul 1 0; Mul 41 150; Add 151 0;
  Mul 43 109; Add 51 0; Mul 45 108; Add 50 0; Mul 47 107; Add 49 0; Sub 0 6; Sub 5 7; Mul 1 148;
  Mul 136 1; Sub 1 0; Mul 0 110; Mul 140 4; Mul 6 154; Sub 1 0; Mul 0 114; Sub 12 16; Mul 9 155;
  Mul 158 1; Sub 1 0; Mul 0 109; Mul 162 4; Mul 14 161; Sub 1 0; Mul 0 113; Mul 8 152; Mul 164 19;
  Sub 1 0; Mul 0 108; Mul 168 22; Mul 13 158; Sub 1 0; Mul 0 112; Sub 12 21; Sub 9 18; Sub 6 23;
  Sub 3 20; Mul 3 105; Mul 3 107; Sub 1 0; Mul 111 3; Mul 111 5; Sub 1 0; Add 3 0; Add 196 0;
  Mul 0 48; Add 48 89; Sub 1 0;
  ShowZero 0; (* H *)
  Mul 63 60; Mul 63 62; Sub 1 0; Add 203 0; Mul 0 213; Mul 0 56; Mul 20 17; Mul 20 19; Sub 1 0;
  Add 209 0; Mul 0 219; Mul 0 62; Add 62 13; Mul 104 0; Add 8 0; Sub 3 0;
  ShowZero 0; (* K *)
  ShowZero 16; (* H + d *)
  Mul 225 107; Mul 0 67; Add 12 0; Mul 110 110; Add 1 0; Sub 9 0;
  ShowZero 0 (* K + 2dH + d² *)
].

Theorem part_2_size_3_valid : valid part_2_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 4.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Constant 0; Sub 4 17; Sub 4 17; Neg 0; Mul 0 5;
  Mul 3 6; Sub 20 9; Sub 20 9; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10; Sub 6 11; Sub 3 12; Sub 3 13;
  Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 10; Neg 28; Mul 0 1; Mul 31 2; Sub 1 21; Sub 1 22; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 11; Neg 35; Mul 0 1; Mul 38 2; Sub 1 30; Sub 1 31; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 4 23; Mul 4 25; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 12; Unknown 13; Mul 39 1; Mul 39 2; Add 42 1; Add 43 1; Mul 38 4; Mul 38 5; Add 3 1;
  Add 3 1; Sub 48 1; Sub 49 1; Mul 1 58; Mul 1 60; Sub 1 0; Div 0 58; Mul 65 0; Mul 65 1; Add 9 1;
  Add 9 1; Mul 58 54; Mul 59 54; Add 1 0; Mul 18 52; Mul 18 52; Add 1 0; Mul 17 44; Mul 17 44;
  Add 1 0; Mul 10 38; Mul 10 38; Add 1 0; Sub 0 70; Sub 10 71; Constant 1; Div 0 35; Mul 3 62;
  Mul 43 3; Sub 1 0; Mul 0 3; Mul 47 6; Mul 8 68; Sub 1 0; Mul 0 7; Sub 18 82; Div 10 66;
  Mul 12 70; Mul 73 2; Sub 1 0; Mul 0 3; Mul 77 5; Mul 17 76; Sub 1 0; Mul 0 7; Sub 25 92;
  Div 20 67; Mul 11 71; Mul 81 2; Sub 1 0; Mul 0 3; Mul 85 5; Mul 16 77; Sub 1 0; Mul 0 7;
  Div 29 67; Mul 10 71; Mul 81 33; Sub 1 0; Mul 0 3; Mul 85 36; Mul 15 77; Sub 1 0; Mul 0 7;
  Sub 23 33; Sub 20 30; Sub 15 35; Sub 12 32; Mul 3 0; Mul 3 2; Sub 1 0; Add 118 0; Sub 12 41;
  Sub 9 38; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 143; Constant 4; Div 54 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 129 129;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 126 126;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 126 126;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 123 123;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 123 123;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 114 114;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 114 114;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 107 107;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 107 107;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 155 134; Mul 155 134; Add 1 0; Mul 145 132; Mul 145 132; Add 1 0; Mul 159 124; Mul 159 124;
  Add 1 0; Mul 160 118; Mul 160 118; Add 1 0; Unknown 14; Sub 1 151; Sub 11 152; Mul 1 141;
  Mul 122 1; Sub 1 0; Mul 0 82; Mul 126 4; Mul 6 147; Sub 1 0; Mul 0 86; Sub 17 161; Mul 9 148;
  Mul 151 1; Sub 1 0; Mul 0 81; Mul 155 4; Mul 14 154; Sub 1 0; Mul 0 85; Sub 23 170; Mul 9 148;
  Mul 158 1; Sub 1 0; Mul 0 80; Mul 162 4; Mul 14 154; Sub 1 0; Mul 0 84; Mul 8 147; Mul 157 28;
  Sub 1 0; Mul 0 79; Mul 161 31; Mul 13 153; Sub 1 0; Mul 0 83; Sub 21 30; Sub 18 27; Sub 14 32;
  Sub 11 29; Mul 3 76; Mul 3 78; Sub 1 0; Mul 82 3; Mul 82 5; Sub 1 0; Add 3 0; Add 198 0;
  Sub 16 42; Sub 13 39; Mul 11 80; Mul 11 82; Sub 1 0; Mul 90 3; Mul 90 5; Sub 1 0; Add 3 0;
  Add 9 0; Div 136 83; Mul 1 0; Mul 60 211; Add 212 0; Mul 62 152; Add 73 0; Mul 64 151; Add 72 0;
  Mul 66 150; Add 71 0; Mul 68 149; Add 70 0; Sub 0 8; Sub 7 9; Mul 1 211; Mul 192 1; Sub 1 0;
  Mul 0 152; Mul 196 4; Mul 6 217; Sub 1 0; Mul 0 156; Sub 14 18; Mul 9 218; Mul 221 1; Sub 1 0;
  Mul 0 151; Mul 225 4; Mul 14 224; Sub 1 0; Mul 0 155; Sub 21 27; Mul 9 218; Mul 228 1; Sub 1 0;
  Mul 0 150; Mul 232 4; Mul 14 224; Sub 1 0; Mul 0 154; Mul 8 217; Mul 227 28; Sub 1 0; Mul 0 149;
  Mul 231 31; Mul 13 223; Sub 1 0; Mul 0 153; Sub 21 30; Sub 18 27; Sub 14 32; Sub 11 29;
  Mul 3 146; Mul 3 148; Sub 1 0; Mul 152 3; Mul 152 5; Sub 1 0; Add 3 0; Add 268 0; Sub 16 42;
  Sub 13 39; Mul 11 150; Mul 11 152; Sub 1 0; Mul 160 3; Mul 160 5; Sub 1 0; Add 3 0; Add 9 0;
  Mul 0 69; Add 69 129; Sub 1 0;
  ShowZero 0; (* H *)
  Mul 94 91; Mul 94 93; Sub 1 0; Add 285 0; Mul 96 85; Mul 96 87; Sub 1 0; Add 3 0; Mul 0 308;
  Mul 0 81; Mul 34 31; Mul 34 33; Sub 1 0; Add 295 0; Mul 36 25; Mul 36 27; Sub 1 0; Add 3 0;
  Mul 0 318; Mul 0 91; Add 91 21; Mul 152 0; Add 12 0; Sub 3 0;
  ShowZero 0; (* K *)
  ShowZero 24; (* H + d *)
  Mul 324 155; Mul 0 96; Add 16 0; Mul 158 158; Add 1 0; Sub 9 0;
  ShowZero 0 (* K + 2dH + d² *)
].

Theorem part_2_size_4_valid : valid part_2_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 5.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_5 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 0; Sub 6 19;
  Sub 6 19; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10;
  Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 12; Sub 35 22; Sub 35 22; Neg 0; Mul 0 3; Mul 3 4; Sub 1 23; Sub 1 24; Mul 12 0;
  Mul 12 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 13; Neg 41; Mul 0 1; Mul 44 2; Sub 1 32; Sub 1 33; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 14; Neg 48; Mul 0 1; Mul 51 2; Sub 1 41; Sub 1 42; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 4 34; Mul 4 36; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 15; Unknown 16; Unknown 17; Mul 51 2; Mul 51 3; Add 54 1; Add 55 1; Mul 50 5; Mul 50 6;
  Add 3 1; Add 3 1; Mul 41 8; Mul 41 9; Add 3 1; Add 3 1; Sub 64 1; Sub 65 1; Mul 1 76; Mul 1 78;
  Sub 1 0; Div 0 76; Mul 83 0; Mul 83 1; Add 9 1; Add 9 1; Mul 74 70; Mul 75 70; Add 1 0;
  Mul 22 68; Mul 22 68; Add 1 0; Mul 21 58; Mul 21 58; Add 1 0; Mul 20 52; Mul 20 52; Add 1 0;
  Mul 13 46; Mul 13 46; Add 1 0; Sub 0 89; Sub 13 90; Constant 1; Div 0 43; Mul 3 81; Mul 51 3;
  Sub 1 0; Mul 0 3; Mul 55 6; Mul 8 87; Sub 1 0; Mul 0 7; Sub 21 101; Div 10 85; Mul 12 89;
  Mul 92 2; Sub 1 0; Mul 0 3; Mul 96 5; Mul 17 95; Sub 1 0; Mul 0 7; Sub 28 111; Div 20 84;
  Mul 11 88; Mul 100 2; Sub 1 0; Mul 0 3; Mul 104 5; Mul 16 94; Sub 1 0; Mul 0 7; Sub 35 121;
  Div 30 85; Mul 11 89; Mul 99 2; Sub 1 0; Mul 0 3; Mul 103 5; Mul 16 95; Sub 1 0; Mul 0 7;
  Div 39 85; Mul 10 89; Mul 99 43; Sub 1 0; Mul 0 3; Mul 103 46; Mul 15 95; Sub 1 0; Mul 0 7;
  Sub 33 43; Sub 30 40; Sub 25 45; Sub 22 42; Mul 3 0; Mul 3 2; Sub 1 0; Add 147 0; Sub 21 51;
  Sub 18 48; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 18 57; Sub 15 54; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Mul 0 180; Constant 4; Div 70 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 164 164;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 161 161;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 161 161;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 158 158;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 158 158;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 147 147;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 147 147;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 140 140;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 140 140;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 133 133;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 133 133;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 194 171; Mul 194 171; Add 1 0; Mul 184 169; Mul 184 169; Add 1 0; Mul 185 159; Mul 185 159;
  Add 1 0; Mul 201 153; Mul 201 153; Add 1 0; Mul 202 147; Mul 202 147; Add 1 0; Unknown 18;
  Sub 1 191; Sub 14 192; Mul 1 181; Mul 151 1; Sub 1 0; Mul 0 103; Mul 155 4; Mul 6 187; Sub 1 0;
  Mul 0 107; Sub 20 201; Mul 9 188; Mul 191 1; Sub 1 0; Mul 0 102; Mul 195 4; Mul 14 194; Sub 1 0;
  Mul 0 106; Sub 26 210; Mul 9 186; Mul 198 1; Sub 1 0; Mul 0 101; Mul 202 4; Mul 14 192; Sub 1 0;
  Mul 0 105; Sub 32 219; Mul 9 186; Mul 196 1; Sub 1 0; Mul 0 100; Mul 200 4; Mul 14 192; Sub 1 0;
  Mul 0 104; Mul 8 185; Mul 195 37; Sub 1 0; Mul 0 99; Mul 199 40; Mul 13 191; Sub 1 0; Mul 0 103;
  Sub 30 39; Sub 27 36; Sub 23 41; Sub 20 38; Mul 3 96; Mul 3 98; Sub 1 0; Mul 102 3; Mul 102 5;
  Sub 1 0; Add 3 0; Add 247 0; Sub 24 51; Sub 21 48; Mul 11 100; Mul 11 102; Sub 1 0; Mul 110 3;
  Mul 110 5; Sub 1 0; Add 3 0; Add 9 0; Sub 26 61; Sub 23 58; Mul 11 104; Mul 11 106; Sub 1 0;
  Mul 114 3; Mul 114 5; Sub 1 0; Add 3 0; Add 9 0; Div 176 107; Mul 1 0; Mul 79 270; Add 271 0;
  Mul 81 195; Add 95 0; Mul 83 194; Add 94 0; Mul 85 193; Add 93 0; Mul 87 192; Add 92 0;
  Mul 89 191; Add 91 0; Sub 0 10; Sub 9 11; Mul 1 272; Mul 242 1; Sub 1 0; Mul 0 194; Mul 246 4;
  Mul 6 278; Sub 1 0; Mul 0 198; Sub 16 20; Mul 9 279; Mul 282 1; Sub 1 0; Mul 0 193; Mul 286 4;
  Mul 14 285; Sub 1 0; Mul 0 197; Sub 23 29; Mul 9 277; Mul 289 1; Sub 1 0; Mul 0 192; Mul 293 4;
  Mul 14 283; Sub 1 0; Mul 0 196; Sub 30 38; Mul 9 277; Mul 287 1; Sub 1 0; Mul 0 191; Mul 291 4;
  Mul 14 283; Sub 1 0; Mul 0 195; Mul 8 276; Mul 286 37; Sub 1 0; Mul 0 190; Mul 290 40;
  Mul 13 282; Sub 1 0; Mul 0 194; Sub 30 39; Sub 27 36; Sub 23 41; Sub 20 38; Mul 3 187;
  Mul 3 189; Sub 1 0; Mul 193 3; Mul 193 5; Sub 1 0; Add 3 0; Add 338 0; Sub 24 51; Sub 21 48;
  Mul 11 191; Mul 11 193; Sub 1 0; Mul 201 3; Mul 201 5; Sub 1 0; Add 3 0; Add 9 0; Sub 26 61;
  Sub 23 58; Mul 11 195; Mul 11 197; Sub 1 0; Mul 205 3; Mul 205 5; Sub 1 0; Add 3 0; Add 9 0;
  Mul 0 90; Add 90 169; Sub 1 0;
  ShowZero 0; (* H *)
  Mul 125 122; Mul 125 124; Sub 1 0; Add 365 0; Mul 127 116; Mul 127 118; Sub 1 0; Add 3 0;
  Mul 121 110; Mul 121 112; Sub 1 0; Add 3 0; Mul 0 394; Mul 0 106; Mul 48 45; Mul 48 47; Sub 1 0;
  Add 379 0; Mul 50 39; Mul 50 41; Sub 1 0; Add 3 0; Mul 44 33; Mul 44 35; Sub 1 0; Add 3 0;
  Mul 0 408; Mul 0 120; Add 120 29; Mul 200 0; Add 16 0; Sub 3 0;
  ShowZero 0; (* K *)
  ShowZero 32; (* H + d *)
  Mul 414 203; Mul 0 125; Add 20 0; Mul 206 206; Add 1 0; Sub 9 0;
  ShowZero 0 (* K + 2dH + d² *)
].

Theorem part_2_size_5_valid : valid part_2_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 6.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_6 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 0; Sub 6 19;
  Sub 6 19; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10;
  Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 12; Unknown 13; Unknown 14; Sub 2 24; Sub 2 24; Neg 0; Mul 0 3; Mul 3 4; Sub 1 25;
  Sub 1 26; Mul 14 0; Mul 14 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 15; Sub 48 13; Sub 48 13; Neg 0; Mul 0 3; Mul 3 4; Sub 1 36; Sub 1 37; Mul 12 0;
  Mul 12 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 16; Neg 54; Mul 0 1; Mul 57 2; Sub 1 45; Sub 1 46; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 17; Neg 61; Mul 0 1; Mul 64 2; Sub 1 54; Sub 1 55; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 4 47; Mul 4 49; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 18; Unknown 19; Unknown 20; Unknown 21; Mul 65 3; Mul 65 4; Add 68 1; Add 69 1;
  Mul 64 6; Mul 64 7; Add 3 1; Add 3 1; Mul 53 9; Mul 53 10; Add 3 1; Add 3 1; Mul 46 12;
  Mul 46 13; Add 3 1; Add 3 1; Sub 82 1; Sub 83 1; Mul 1 94; Mul 1 96; Sub 1 0; Div 0 94;
  Mul 101 0; Mul 101 1; Add 9 1; Add 9 1; Mul 92 88; Mul 93 88; Add 1 0; Mul 26 86; Mul 26 86;
  Add 1 0; Mul 25 74; Mul 25 74; Add 1 0; Mul 24 66; Mul 24 66; Add 1 0; Mul 23 60; Mul 23 60;
  Add 1 0; Mul 16 54; Mul 16 54; Add 1 0; Sub 0 110; Sub 16 111; Constant 1; Div 0 51; Mul 3 102;
  Mul 59 3; Sub 1 0; Mul 0 3; Mul 63 6; Mul 8 108; Sub 1 0; Mul 0 7; Sub 24 122; Div 10 106;
  Mul 12 110; Mul 113 2; Sub 1 0; Mul 0 3; Mul 117 5; Mul 17 116; Sub 1 0; Mul 0 7; Sub 31 132;
  Div 20 103; Mul 11 107; Mul 121 2; Sub 1 0; Mul 0 3; Mul 125 5; Mul 16 113; Sub 1 0; Mul 0 7;
  Sub 38 142; Div 30 102; Mul 11 106; Mul 118 2; Sub 1 0; Mul 0 3; Mul 122 5; Mul 16 112; Sub 1 0;
  Mul 0 7; Sub 45 152; Div 40 103; Mul 11 107; Mul 117 2; Sub 1 0; Mul 0 3; Mul 121 5; Mul 16 113;
  Sub 1 0; Mul 0 7; Div 49 103; Mul 10 107; Mul 117 53; Sub 1 0; Mul 0 3; Mul 121 56; Mul 15 113;
  Sub 1 0; Mul 0 7; Sub 43 53; Sub 40 50; Sub 35 55; Sub 32 52; Mul 3 0; Mul 3 2; Sub 1 0;
  Add 178 0; Sub 31 61; Sub 28 58; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 27 67; Sub 24 64;
  Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 24 73; Sub 21 70; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Mul 0 217; Constant 4; Div 86 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 201 201;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 198 198;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 198 198;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 195 195;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 195 195;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 182 182;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 182 182;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 173 173;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 173 173;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 166 166;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 166 166;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 159 159;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 159 159;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 233 210; Mul 233 210; Add 1 0; Mul 223 208; Mul 223 208; Add 1 0; Mul 224 196; Mul 224 196;
  Add 1 0; Mul 205 188; Mul 205 188; Add 1 0; Mul 243 182; Mul 243 182; Add 1 0; Mul 244 176;
  Mul 244 176; Add 1 0; Unknown 22; Sub 1 233; Sub 17 234; Mul 1 223; Mul 180 1; Sub 1 0;
  Mul 0 124; Mul 184 4; Mul 6 229; Sub 1 0; Mul 0 128; Sub 23 243; Mul 9 230; Mul 233 1; Sub 1 0;
  Mul 0 123; Mul 237 4; Mul 14 236; Sub 1 0; Mul 0 127; Sub 29 252; Mul 9 226; Mul 240 1; Sub 1 0;
  Mul 0 122; Mul 244 4; Mul 14 232; Sub 1 0; Mul 0 126; Sub 35 261; Mul 9 224; Mul 236 1; Sub 1 0;
  Mul 0 121; Mul 240 4; Mul 14 230; Sub 1 0; Mul 0 125; Sub 41 270; Mul 9 224; Mul 234 1; Sub 1 0;
  Mul 0 120; Mul 238 4; Mul 14 230; Sub 1 0; Mul 0 124; Mul 8 223; Mul 233 46; Sub 1 0; Mul 0 119;
  Mul 237 49; Mul 13 229; Sub 1 0; Mul 0 123; Sub 39 48; Sub 36 45; Sub 32 50; Sub 29 47;
  Mul 3 116; Mul 3 118; Sub 1 0; Mul 122 3; Mul 122 5; Sub 1 0; Add 3 0; Add 298 0; Sub 33 60;
  Sub 30 57; Mul 11 120; Mul 11 122; Sub 1 0; Mul 130 3; Mul 130 5; Sub 1 0; Add 3 0; Add 9 0;
  Sub 34 70; Sub 31 67; Mul 11 124; Mul 11 126; Sub 1 0; Mul 134 3; Mul 134 5; Sub 1 0; Add 3 0;
  Add 9 0; Sub 36 80; Sub 33 77; Mul 11 128; Mul 11 130; Sub 1 0; Mul 138 3; Mul 138 5; Sub 1 0;
  Add 3 0; Add 9 0; Div 216 131; Mul 1 0; Mul 98 331; Add 332 0; Mul 100 238; Add 117 0;
  Mul 102 237; Add 116 0; Mul 104 236; Add 115 0; Mul 106 235; Add 114 0; Mul 108 234; Add 113 0;
  Mul 110 233; Add 112 0; Sub 0 12; Sub 11 13; Mul 1 335; Mul 292 1; Sub 1 0; Mul 0 236;
  Mul 296 4; Mul 6 341; Sub 1 0; Mul 0 240; Sub 18 22; Mul 9 342; Mul 345 1; Sub 1 0; Mul 0 235;
  Mul 349 4; Mul 14 348; Sub 1 0; Mul 0 239; Sub 25 31; Mul 9 338; Mul 352 1; Sub 1 0; Mul 0 234;
  Mul 356 4; Mul 14 344; Sub 1 0; Mul 0 238; Sub 32 40; Mul 9 336; Mul 348 1; Sub 1 0; Mul 0 233;
  Mul 352 4; Mul 14 342; Sub 1 0; Mul 0 237; Sub 39 49; Mul 9 336; Mul 346 1; Sub 1 0; Mul 0 232;
  Mul 350 4; Mul 14 342; Sub 1 0; Mul 0 236; Mul 8 335; Mul 345 46; Sub 1 0; Mul 0 231;
  Mul 349 49; Mul 13 341; Sub 1 0; Mul 0 235; Sub 39 48; Sub 36 45; Sub 32 50; Sub 29 47;
  Mul 3 228; Mul 3 230; Sub 1 0; Mul 234 3; Mul 234 5; Sub 1 0; Add 3 0; Add 410 0; Sub 33 60;
  Sub 30 57; Mul 11 232; Mul 11 234; Sub 1 0; Mul 242 3; Mul 242 5; Sub 1 0; Add 3 0; Add 9 0;
  Sub 34 70; Sub 31 67; Mul 11 236; Mul 11 238; Sub 1 0; Mul 246 3; Mul 246 5; Sub 1 0; Add 3 0;
  Add 9 0; Sub 36 80; Sub 33 77; Mul 11 240; Mul 11 242; Sub 1 0; Mul 250 3; Mul 250 5; Sub 1 0;
  Add 3 0; Add 9 0; Mul 0 111; Add 111 209; Sub 1 0;
  ShowZero 0; (* H *)
  Mul 156 153; Mul 156 155; Sub 1 0; Add 447 0; Mul 158 147; Mul 158 149; Sub 1 0; Add 3 0;
  Mul 152 141; Mul 152 143; Sub 1 0; Add 3 0; Mul 146 135; Mul 146 137; Sub 1 0; Add 3 0;
  Mul 0 480; Mul 0 131; Mul 62 59; Mul 62 61; Sub 1 0; Add 465 0; Mul 64 53; Mul 64 55; Sub 1 0;
  Add 3 0; Mul 58 47; Mul 58 49; Sub 1 0; Add 3 0; Mul 52 41; Mul 52 43; Sub 1 0; Add 3 0;
  Mul 0 498; Mul 0 149; Add 149 37; Mul 248 0; Add 20 0; Sub 3 0;
  ShowZero 0; (* K *)
  ShowZero 40; (* H + d *)
  Mul 504 251; Mul 0 154; Add 24 0; Mul 254 254; Add 1 0; Sub 9 0;
  ShowZero 0 (* K + 2dH + d² *)
].

Theorem part_2_size_6_valid : valid part_2_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 7.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_7 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 0; Sub 6 19;
  Sub 6 19; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10;
  Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 12; Unknown 13; Unknown 14; Sub 2 24; Sub 2 24; Neg 0; Mul 0 3; Mul 3 4; Sub 1 25;
  Sub 1 26; Mul 14 0; Mul 14 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 15; Unknown 16; Unknown 17; Sub 2 15; Sub 2 15; Neg 0; Mul 0 3; Mul 3 4; Sub 1 38;
  Sub 1 39; Mul 14 0; Mul 14 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 18; Sub 61 13; Sub 61 13; Neg 0; Mul 0 3; Mul 3 4; Sub 1 49; Sub 1 50; Mul 12 0;
  Mul 12 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 19; Neg 67; Mul 0 1; Mul 70 2; Sub 1 58; Sub 1 59; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 20; Neg 74; Mul 0 1; Mul 77 2; Sub 1 67; Sub 1 68; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 4 60; Mul 4 62; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 21; Unknown 22; Unknown 23; Unknown 24; Unknown 25; Mul 79 4; Mul 79 5; Add 82 1;
  Add 83 1; Mul 78 7; Mul 78 8; Add 3 1; Add 3 1; Mul 67 10; Mul 67 11; Add 3 1; Add 3 1;
  Mul 58 13; Mul 58 14; Add 3 1; Add 3 1; Mul 51 16; Mul 51 17; Add 3 1; Add 3 1; Sub 100 1;
  Sub 101 1; Mul 1 112; Mul 1 114; Sub 1 0; Div 0 112; Mul 119 0; Mul 119 1; Add 9 1; Add 9 1;
  Mul 110 106; Mul 111 106; Add 1 0; Mul 30 104; Mul 30 104; Add 1 0; Mul 29 92; Mul 29 92;
  Add 1 0; Mul 28 82; Mul 28 82; Add 1 0; Mul 27 74; Mul 27 74; Add 1 0; Mul 26 68; Mul 26 68;
  Add 1 0; Mul 19 62; Mul 19 62; Add 1 0; Sub 0 131; Sub 19 132; Constant 1; Div 0 59; Mul 3 123;
  Mul 67 3; Sub 1 0; Mul 0 3; Mul 71 6; Mul 8 129; Sub 1 0; Mul 0 7; Sub 27 143; Div 10 127;
  Mul 12 131; Mul 134 2; Sub 1 0; Mul 0 3; Mul 138 5; Mul 17 137; Sub 1 0; Mul 0 7; Sub 34 153;
  Div 20 124; Mul 11 128; Mul 142 2; Sub 1 0; Mul 0 3; Mul 146 5; Mul 16 134; Sub 1 0; Mul 0 7;
  Sub 41 163; Div 30 121; Mul 11 125; Mul 139 2; Sub 1 0; Mul 0 3; Mul 143 5; Mul 16 131; Sub 1 0;
  Mul 0 7; Sub 48 173; Div 40 120; Mul 11 124; Mul 136 2; Sub 1 0; Mul 0 3; Mul 140 5; Mul 16 130;
  Sub 1 0; Mul 0 7; Sub 55 183; Div 50 121; Mul 11 125; Mul 135 2; Sub 1 0; Mul 0 3; Mul 139 5;
  Mul 16 131; Sub 1 0; Mul 0 7; Div 59 121; Mul 10 125; Mul 135 63; Sub 1 0; Mul 0 3; Mul 139 66;
  Mul 15 131; Sub 1 0; Mul 0 7; Sub 53 63; Sub 50 60; Sub 45 65; Sub 42 62; Mul 3 0; Mul 3 2;
  Sub 1 0; Add 209 0; Sub 41 71; Sub 38 68; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 37 77;
  Sub 34 74; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 33 83; Sub 30 80; Mul 7 0; Mul 7 2; Sub 1 0;
  Add 5 0; Sub 30 89; Sub 27 86; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 254; Constant 4;
  Div 102 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 238 238;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 235 235;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 235 235;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 232 232;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 232 232;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 219 219;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 219 219;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 208 208;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 208 208;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 199 199;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 199 199;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 192 192;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 192 192;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 185 185;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 185 185;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 272 249; Mul 272 249; Add 1 0; Mul 262 247; Mul 262 247; Add 1 0; Mul 263 235; Mul 263 235;
  Add 1 0; Mul 244 225; Mul 244 225; Add 1 0; Mul 234 217; Mul 234 217; Add 1 0; Mul 285 211;
  Mul 285 211; Add 1 0; Mul 286 205; Mul 286 205; Add 1 0; Unknown 26; Sub 1 275; Sub 20 276;
  Mul 1 265; Mul 209 1; Sub 1 0; Mul 0 145; Mul 213 4; Mul 6 271; Sub 1 0; Mul 0 149; Sub 26 285;
  Mul 9 272; Mul 275 1; Sub 1 0; Mul 0 144; Mul 279 4; Mul 14 278; Sub 1 0; Mul 0 148; Sub 32 294;
  Mul 9 268; Mul 282 1; Sub 1 0; Mul 0 143; Mul 286 4; Mul 14 274; Sub 1 0; Mul 0 147; Sub 38 303;
  Mul 9 264; Mul 278 1; Sub 1 0; Mul 0 142; Mul 282 4; Mul 14 270; Sub 1 0; Mul 0 146; Sub 44 312;
  Mul 9 262; Mul 274 1; Sub 1 0; Mul 0 141; Mul 278 4; Mul 14 268; Sub 1 0; Mul 0 145; Sub 50 321;
  Mul 9 262; Mul 272 1; Sub 1 0; Mul 0 140; Mul 276 4; Mul 14 268; Sub 1 0; Mul 0 144; Mul 8 261;
  Mul 271 55; Sub 1 0; Mul 0 139; Mul 275 58; Mul 13 267; Sub 1 0; Mul 0 143; Sub 48 57;
  Sub 45 54; Sub 41 59; Sub 38 56; Mul 3 136; Mul 3 138; Sub 1 0; Mul 142 3; Mul 142 5; Sub 1 0;
  Add 3 0; Add 349 0; Sub 42 69; Sub 39 66; Mul 11 140; Mul 11 142; Sub 1 0; Mul 150 3; Mul 150 5;
  Sub 1 0; Add 3 0; Add 9 0; Sub 43 79; Sub 40 76; Mul 11 144; Mul 11 146; Sub 1 0; Mul 154 3;
  Mul 154 5; Sub 1 0; Add 3 0; Add 9 0; Sub 44 89; Sub 41 86; Mul 11 148; Mul 11 150; Sub 1 0;
  Mul 158 3; Mul 158 5; Sub 1 0; Add 3 0; Add 9 0; Sub 46 99; Sub 43 96; Mul 11 152; Mul 11 154;
  Sub 1 0; Mul 162 3; Mul 162 5; Sub 1 0; Add 3 0; Add 9 0; Div 256 155; Mul 1 0; Mul 117 392;
  Add 393 0; Mul 119 281; Add 139 0; Mul 121 280; Add 138 0; Mul 123 279; Add 137 0; Mul 125 278;
  Add 136 0; Mul 127 277; Add 135 0; Mul 129 276; Add 134 0; Mul 131 275; Add 133 0; Sub 0 14;
  Sub 13 15; Mul 1 398; Mul 342 1; Sub 1 0; Mul 0 278; Mul 346 4; Mul 6 404; Sub 1 0; Mul 0 282;
  Sub 20 24; Mul 9 405; Mul 408 1; Sub 1 0; Mul 0 277; Mul 412 4; Mul 14 411; Sub 1 0; Mul 0 281;
  Sub 27 33; Mul 9 401; Mul 415 1; Sub 1 0; Mul 0 276; Mul 419 4; Mul 14 407; Sub 1 0; Mul 0 280;
  Sub 34 42; Mul 9 397; Mul 411 1; Sub 1 0; Mul 0 275; Mul 415 4; Mul 14 403; Sub 1 0; Mul 0 279;
  Sub 41 51; Mul 9 395; Mul 407 1; Sub 1 0; Mul 0 274; Mul 411 4; Mul 14 401; Sub 1 0; Mul 0 278;
  Sub 48 60; Mul 9 395; Mul 405 1; Sub 1 0; Mul 0 273; Mul 409 4; Mul 14 401; Sub 1 0; Mul 0 277;
  Mul 8 394; Mul 404 55; Sub 1 0; Mul 0 272; Mul 408 58; Mul 13 400; Sub 1 0; Mul 0 276;
  Sub 48 57; Sub 45 54; Sub 41 59; Sub 38 56; Mul 3 269; Mul 3 271; Sub 1 0; Mul 275 3; Mul 275 5;
  Sub 1 0; Add 3 0; Add 482 0; Sub 42 69; Sub 39 66; Mul 11 273; Mul 11 275; Sub 1 0; Mul 283 3;
  Mul 283 5; Sub 1 0; Add 3 0; Add 9 0; Sub 43 79; Sub 40 76; Mul 11 277; Mul 11 279; Sub 1 0;
  Mul 287 3; Mul 287 5; Sub 1 0; Add 3 0; Add 9 0; Sub 44 89; Sub 41 86; Mul 11 281; Mul 11 283;
  Sub 1 0; Mul 291 3; Mul 291 5; Sub 1 0; Add 3 0; Add 9 0; Sub 46 99; Sub 43 96; Mul 11 285;
  Mul 11 287; Sub 1 0; Mul 295 3; Mul 295 5; Sub 1 0; Add 3 0; Add 9 0; Mul 0 132; Add 132 249;
  Sub 1 0;
  ShowZero 0; (* H *)
  Mul 187 184; Mul 187 186; Sub 1 0; Add 529 0; Mul 189 178; Mul 189 180; Sub 1 0; Add 3 0;
  Mul 183 172; Mul 183 174; Sub 1 0; Add 3 0; Mul 177 166; Mul 177 168; Sub 1 0; Add 3 0;
  Mul 171 160; Mul 171 162; Sub 1 0; Add 3 0; Mul 0 566; Mul 0 156; Mul 76 73; Mul 76 75; Sub 1 0;
  Add 551 0; Mul 78 67; Mul 78 69; Sub 1 0; Add 3 0; Mul 72 61; Mul 72 63; Sub 1 0; Add 3 0;
  Mul 66 55; Mul 66 57; Sub 1 0; Add 3 0; Mul 60 49; Mul 60 51; Sub 1 0; Add 3 0; Mul 0 588;
  Mul 0 178; Add 178 45; Mul 296 0; Add 24 0; Sub 3 0;
  ShowZero 0; (* K *)
  ShowZero 48; (* H + d *)
  Mul 594 299; Mul 0 183; Add 28 0; Mul 302 302; Add 1 0; Sub 9 0;
  ShowZero 0 (* K + 2dH + d² *)
].

Theorem part_2_size_7_valid : valid part_2_size_7.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** two stars given by gradients; size 8.
    Code: src/pair/curvature.rs, src/pair/forms.rs, src/pair/offset.rs, src/pair/v_parallel.rs,
    src/pair/vertex.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_8 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 1 3; Sub 1 3; Sub 7 3;
  Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the last two edges are not parallel *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Constant 0; Sub 6 19;
  Sub 6 19; Neg 0; Mul 0 5; Mul 3 6; Sub 9 11; Sub 9 11; Neg 0; Mul 0 9; Mul 3 10; Sub 6 10;
  Sub 6 11; Sub 3 12; Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 12; Unknown 13; Unknown 14; Sub 2 24; Sub 2 24; Neg 0; Mul 0 3; Mul 3 4; Sub 1 25;
  Sub 1 26; Mul 14 0; Mul 14 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 15; Unknown 16; Unknown 17; Sub 2 15; Sub 2 15; Neg 0; Mul 0 3; Mul 3 4; Sub 1 38;
  Sub 1 39; Mul 14 0; Mul 14 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 18; Unknown 19; Unknown 20; Sub 2 15; Sub 2 15; Neg 0; Mul 0 3; Mul 3 4; Sub 1 51;
  Sub 1 52; Mul 14 0; Mul 14 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 21; Sub 74 13; Sub 74 13; Neg 0; Mul 0 3; Mul 3 4; Sub 1 62; Sub 1 63; Mul 12 0;
  Mul 12 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 22; Neg 80; Mul 0 1; Mul 83 2; Sub 1 71; Sub 1 72; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 23; Neg 87; Mul 0 1; Mul 90 2; Sub 1 80; Sub 1 81; Mul 10 0; Mul 10 2; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Mul 4 73; Mul 4 75; Sub 1 0;
  Nonzero 0; (* no face of the star is vertical *)
  Unknown 24; Unknown 25; Unknown 26; Unknown 27; Unknown 28; Unknown 29; Mul 93 5; Mul 93 6;
  Add 96 1; Add 97 1; Mul 92 8; Mul 92 9; Add 3 1; Add 3 1; Mul 81 11; Mul 81 12; Add 3 1;
  Add 3 1; Mul 72 14; Mul 72 15; Add 3 1; Add 3 1; Mul 63 17; Mul 63 18; Add 3 1; Add 3 1;
  Mul 56 20; Mul 56 21; Add 3 1; Add 3 1; Sub 118 1; Sub 119 1; Mul 1 130; Mul 1 132; Sub 1 0;
  Div 0 130; Mul 137 0; Mul 137 1; Add 9 1; Add 9 1; Mul 128 124; Mul 129 124; Add 1 0;
  Mul 34 122; Mul 34 122; Add 1 0; Mul 33 110; Mul 33 110; Add 1 0; Mul 32 100; Mul 32 100;
  Add 1 0; Mul 31 90; Mul 31 90; Add 1 0; Mul 30 82; Mul 30 82; Add 1 0; Mul 29 76; Mul 29 76;
  Add 1 0; Mul 22 70; Mul 22 70; Add 1 0; Sub 0 152; Sub 22 153; Constant 1; Div 0 67; Mul 3 144;
  Mul 75 3; Sub 1 0; Mul 0 3; Mul 79 6; Mul 8 150; Sub 1 0; Mul 0 7; Sub 30 164; Div 10 148;
  Mul 12 152; Mul 155 2; Sub 1 0; Mul 0 3; Mul 159 5; Mul 17 158; Sub 1 0; Mul 0 7; Sub 37 174;
  Div 20 145; Mul 11 149; Mul 163 2; Sub 1 0; Mul 0 3; Mul 167 5; Mul 16 155; Sub 1 0; Mul 0 7;
  Sub 44 184; Div 30 142; Mul 11 146; Mul 160 2; Sub 1 0; Mul 0 3; Mul 164 5; Mul 16 152; Sub 1 0;
  Mul 0 7; Sub 51 194; Div 40 139; Mul 11 143; Mul 157 2; Sub 1 0; Mul 0 3; Mul 161 5; Mul 16 149;
  Sub 1 0; Mul 0 7; Sub 58 204; Div 50 138; Mul 11 142; Mul 154 2; Sub 1 0; Mul 0 3; Mul 158 5;
  Mul 16 148; Sub 1 0; Mul 0 7; Sub 65 214; Div 60 139; Mul 11 143; Mul 153 2; Sub 1 0; Mul 0 3;
  Mul 157 5; Mul 16 149; Sub 1 0; Mul 0 7; Div 69 139; Mul 10 143; Mul 153 73; Sub 1 0; Mul 0 3;
  Mul 157 76; Mul 15 149; Sub 1 0; Mul 0 7; Sub 63 73; Sub 60 70; Sub 55 75; Sub 52 72; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 240 0; Sub 51 81; Sub 48 78; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0;
  Sub 47 87; Sub 44 84; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 43 93; Sub 40 90; Mul 7 0;
  Mul 7 2; Sub 1 0; Add 5 0; Sub 39 99; Sub 36 96; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Sub 36 105;
  Sub 33 102; Mul 7 0; Mul 7 2; Sub 1 0; Add 5 0; Mul 0 291; Constant 4; Div 118 0; Mul 2 0;
  Nonzero 0; (* D(s) != 0 *)
  Sub 275 275;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 272 272;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 272 272;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 269 269;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 269 269;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 256 256;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 256 256;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 245 245;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 245 245;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 234 234;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 234 234;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 225 225;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 225 225;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 218 218;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 218 218;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 211 211;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Sub 211 211;
  ShowZero 0; (* as src/pair/v_parallel.rs finds *)
  Mul 311 288; Mul 311 288; Add 1 0; Mul 301 286; Mul 301 286; Add 1 0; Mul 302 274; Mul 302 274;
  Add 1 0; Mul 283 264; Mul 283 264; Add 1 0; Mul 273 254; Mul 273 254; Add 1 0; Mul 263 246;
  Mul 263 246; Add 1 0; Mul 327 240; Mul 327 240; Add 1 0; Mul 328 234; Mul 328 234; Add 1 0;
  Unknown 30; Sub 1 317; Sub 23 318; Mul 1 307; Mul 238 1; Sub 1 0; Mul 0 166; Mul 242 4;
  Mul 6 313; Sub 1 0; Mul 0 170; Sub 29 327; Mul 9 314; Mul 317 1; Sub 1 0; Mul 0 165; Mul 321 4;
  Mul 14 320; Sub 1 0; Mul 0 169; Sub 35 336; Mul 9 310; Mul 324 1; Sub 1 0; Mul 0 164; Mul 328 4;
  Mul 14 316; Sub 1 0; Mul 0 168; Sub 41 345; Mul 9 306; Mul 320 1; Sub 1 0; Mul 0 163; Mul 324 4;
  Mul 14 312; Sub 1 0; Mul 0 167; Sub 47 354; Mul 9 302; Mul 316 1; Sub 1 0; Mul 0 162; Mul 320 4;
  Mul 14 308; Sub 1 0; Mul 0 166; Sub 53 363; Mul 9 300; Mul 312 1; Sub 1 0; Mul 0 161; Mul 316 4;
  Mul 14 306; Sub 1 0; Mul 0 165; Sub 59 372; Mul 9 300; Mul 310 1; Sub 1 0; Mul 0 160; Mul 314 4;
  Mul 14 306; Sub 1 0; Mul 0 164; Mul 8 299; Mul 309 64; Sub 1 0; Mul 0 159; Mul 313 67;
  Mul 13 305; Sub 1 0; Mul 0 163; Sub 57 66; Sub 54 63; Sub 50 68; Sub 47 65; Mul 3 156;
  Mul 3 158; Sub 1 0; Mul 162 3; Mul 162 5; Sub 1 0; Add 3 0; Add 400 0; Sub 51 78; Sub 48 75;
  Mul 11 160; Mul 11 162; Sub 1 0; Mul 170 3; Mul 170 5; Sub 1 0; Add 3 0; Add 9 0; Sub 52 88;
  Sub 49 85; Mul 11 164; Mul 11 166; Sub 1 0; Mul 174 3; Mul 174 5; Sub 1 0; Add 3 0; Add 9 0;
  Sub 53 98; Sub 50 95; Mul 11 168; Mul 11 170; Sub 1 0; Mul 178 3; Mul 178 5; Sub 1 0; Add 3 0;
  Add 9 0; Sub 54 108; Sub 51 105; Mul 11 172; Mul 11 174; Sub 1 0; Mul 182 3; Mul 182 5; Sub 1 0;
  Add 3 0; Add 9 0; Sub 56 118; Sub 53 115; Mul 11 176; Mul 11 178; Sub 1 0; Mul 186 3; Mul 186 5;
  Sub 1 0; Add 3 0; Add 9 0; Div 296 179; Mul 1 0; Mul 136 453; Add 454 0; Mul 138 324; Add 161 0;
  Mul 140 323; Add 160 0; Mul 142 322; Add 159 0; Mul 144 321; Add 158 0; Mul 146 320; Add 157 0;
  Mul 148 319; Add 156 0; Mul 150 318; Add 155 0; Mul 152 317; Add 154 0; Sub 0 16; Sub 15 17;
  Mul 1 461; Mul 392 1; Sub 1 0; Mul 0 320; Mul 396 4; Mul 6 467; Sub 1 0; Mul 0 324; Sub 22 26;
  Mul 9 468; Mul 471 1; Sub 1 0; Mul 0 319; Mul 475 4; Mul 14 474; Sub 1 0; Mul 0 323; Sub 29 35;
  Mul 9 464; Mul 478 1; Sub 1 0; Mul 0 318; Mul 482 4; Mul 14 470; Sub 1 0; Mul 0 322; Sub 36 44;
  Mul 9 460; Mul 474 1; Sub 1 0; Mul 0 317; Mul 478 4; Mul 14 466; Sub 1 0; Mul 0 321; Sub 43 53;
  Mul 9 456; Mul 470 1; Sub 1 0; Mul 0 316; Mul 474 4; Mul 14 462; Sub 1 0; Mul 0 320; Sub 50 62;
  Mul 9 454; Mul 466 1; Sub 1 0; Mul 0 315; Mul 470 4; Mul 14 460; Sub 1 0; Mul 0 319; Sub 57 71;
  Mul 9 454; Mul 464 1; Sub 1 0; Mul 0 314; Mul 468 4; Mul 14 460; Sub 1 0; Mul 0 318; Mul 8 453;
  Mul 463 64; Sub 1 0; Mul 0 313; Mul 467 67; Mul 13 459; Sub 1 0; Mul 0 317; Sub 57 66;
  Sub 54 63; Sub 50 68; Sub 47 65; Mul 3 310; Mul 3 312; Sub 1 0; Mul 316 3; Mul 316 5; Sub 1 0;
  Add 3 0; Add 554 0; Sub 51 78; Sub 48 75; Mul 11 314; Mul 11 316; Sub 1 0; Mul 324 3; Mul 324 5;
  Sub 1 0; Add 3 0; Add 9 0; Sub 52 88; Sub 49 85; Mul 11 318; Mul 11 320; Sub 1 0; Mul 328 3;
  Mul 328 5; Sub 1 0; Add 3 0; Add 9 0; Sub 53 98; Sub 50 95; Mul 11 322; Mul 11 324; Sub 1 0;
  Mul 332 3; Mul 332 5; Sub 1 0; Add 3 0; Add 9 0; Sub 54 108; Sub 51 105; Mul 11 326; Mul 11 328;
  Sub 1 0; Mul 336 3; Mul 336 5; Sub 1 0; Add 3 0; Add 9 0; Sub 56 118; Sub 53 115; Mul 11 330;
  Mul 11 332; Sub 1 0; Mul 340 3; Mul 340 5; Sub 1 0; Add 3 0; Add 9 0; Mul 0 153; Add 153 289;
  Sub 1 0;
  ShowZero 0; (* H *)
  Mul 218 215; Mul 218 217; Sub 1 0; Add 611 0; Mul 220 209; Mul 220 211; Sub 1 0; Add 3 0;
  Mul 214 203; Mul 214 205; Sub 1 0; Add 3 0; Mul 208 197; Mul 208 199; Sub 1 0; Add 3 0;
  Mul 202 191; Mul 202 193; Sub 1 0; Add 3 0; Mul 196 185; Mul 196 187; Sub 1 0; Add 3 0;
  Mul 0 652; Mul 0 181; Mul 90 87; Mul 90 89; Sub 1 0; Add 637 0; Mul 92 81; Mul 92 83; Sub 1 0;
  Add 3 0; Mul 86 75; Mul 86 77; Sub 1 0; Add 3 0; Mul 80 69; Mul 80 71; Sub 1 0; Add 3 0;
  Mul 74 63; Mul 74 65; Sub 1 0; Add 3 0; Mul 68 57; Mul 68 59; Sub 1 0; Add 3 0; Mul 0 678;
  Mul 0 207; Add 207 53; Mul 344 0; Add 28 0; Sub 3 0;
  ShowZero 0; (* K *)
  ShowZero 56; (* H + d *)
  Mul 684 347; Mul 0 212; Add 32 0; Mul 350 350; Add 1 0; Sub 9 0;
  ShowZero 0 (* K + 2dH + d² *)
].

Theorem part_2_size_8_valid : valid part_2_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
