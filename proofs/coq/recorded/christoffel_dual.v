(** christoffel-dual (Sec. 4, Fig. 7)

    In a mesh whose top view has incircles that touch along the edges, the vectors ±e/(R_i R_j) are
    the edges of a parallel mesh with mixed area 0 at every face, signs alternating around every
    face; it is unique up to scale and translation for quads, and with exactly these edges
    area(F)/area(S) = -R_0 R_1 R_2 R_3.

        s_j - s_i = ± (v_j - v_i)/(R_i R_j)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a face in space with any even number of sides; size 4.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs, src/pair/area.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Unknown 0; Unknown 1; Sub 1 0;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 1; Mul 2 3; Add 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 2; Sub 0 6;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 7 1; Add 5 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 3; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 9 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Sub 12 3;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 4 13; Add 12 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Div 13 11; Sub 14 13; Mul 0 1; Mul 17 2; Div 17 11; Sub 18 13; Mul 0 1; Mul 16 2; Div 21 11;
  Sub 22 13; Mul 0 1; Mul 16 2; Div 25 12; Sub 26 14; Mul 0 1; Mul 17 2; Div 29 12; Div 30 9;
  Div 31 6; Div 32 3; Constant 0; Sub 14 18; Mul 5 4; Mul 1 0; Add 3 0; Sub 14 18; Mul 8 7; Neg 0;
  Mul 2 0; Add 4 0; Sub 15 19; Mul 12 11; Mul 1 0; Add 3 0; Sub 31 19; Mul 15 18; Neg 0; Mul 2 0;
  Add 4 0; Sub 0 18;
  ShowZero 0; (* as a test finds *)
  Add 55 56; Mul 0 40; Add 58 52; Mul 0 38; Add 54 50; Mul 0 36; Add 52 61; Mul 0 34; Sub 4 6;
  Mul 0 26; Add 29 0; Sub 5 7; Mul 0 24; Add 2 0; Sub 6 8; Mul 0 23; Add 2 0; Sub 15 9; Mul 0 21;
  Add 2 0; Sub 0 39;
  ShowZero 0; (* as a test finds *)
  Unknown 4; Unknown 5; Mul 1 60; Mul 1 22; Add 1 0; Add 0 45; Mul 5 60; Mul 5 24; Add 1 0;
  Add 0 49; Mul 9 60; Mul 9 26; Add 1 0; Add 0 53; Mul 13 60; Mul 13 28; Add 1 0; Add 0 57;
  Sub 8 12; Mul 0 57; Add 60 0; Sub 7 11; Mul 0 55; Add 2 0; Sub 6 10; Mul 0 54; Add 2 0;
  Sub 21 9; Mul 0 52; Add 2 0; Sub 0 70;
  ShowZero 0; (* as a test finds *)
  Sub 67 67;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 42 42;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 12 12;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 65 65;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 42 42;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 12 12;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 77 60; Sub 65 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 79 41; Sub 44 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 81 12; Sub 15 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 66; Sub 0 84;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 47; Sub 0 86;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 18; Sub 0 88;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 85 89; Sub 60 90; Sub 101 109; Sub 67 71; Sub 84 93; Sub 61 94; Mul 94 0; Mul 68 2; Sub 1 0;
  Add 98 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 109 121; Sub 77 83; Sub 27 105; Sub 26 106;
  Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 54 115; Mul 88 0; Mul 58 26; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 60 29; Mul 119 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 121 31; Mul 95 33; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 92 95; Sub 62 65; Mul 96 0; Mul 66 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 121 126; Mul 69 0; Mul 127 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 129 8; Mul 104 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 57 104; Sub 56 74; Mul 105 0; Mul 75 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 64 133; Mul 78 0; Mul 134 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 136 8; Mul 113 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 149 69; Sub 150 68; Mul 114 0; Mul 84 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 154 76; Mul 87 0; Mul 142 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 144 8; Mul 122 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  ShowZero 46; (* 4 area(F, S) *)
  Mul 178 174; Mul 72 0; Sub 0 162;
  ShowZero 0; (* edge *)
  Mul 73 2; Sub 0 137;
  ShowZero 0; (* edge *)
  Mul 50 4; Sub 0 108;
  ShowZero 0; (* edge *)
  Mul 181 177; Neg 0; Mul 39 0; Sub 0 166;
  ShowZero 0; (* edge *)
  Mul 46 2; Sub 0 142;
  ShowZero 0; (* edge *)
  Mul 47 4; Sub 0 113;
  ShowZero 0; (* edge *)
  Mul 185 181; Mul 34 0; Sub 0 168;
  ShowZero 0; (* edge *)
  Mul 41 2; Sub 0 146;
  ShowZero 0; (* edge *)
  Mul 42 4; Sub 0 117;
  ShowZero 0; (* edge *)
  Mul 188 200; Neg 0; Mul 30 0; Sub 0 172;
  ShowZero 0; (* edge *)
  Mul 37 2; Sub 0 151;
  ShowZero 0; (* edge *)
  Mul 38 4; Sub 0 122;
  ShowZero 0; (* edge *)
  Mul 225 208; Mul 0 205; Mul 0 202; Mul 0 199; Mul 194 102; Mul 168 104; Sub 1 0; Add 198 0;
  Mul 107 94; Mul 107 96; Sub 1 0; Add 3 0; Mul 113 108; Mul 113 110; Sub 1 0; Add 206 0;
  Mul 113 100; Mul 113 102; Sub 1 0; Add 3 0; Mul 0 16; Add 9 0;
  ShowZero 0; (* area(F) = -area(S) ∏ R *)
  Mul 217 230; Sub 0 248;
  ShowZero 0; (* radius *)
  Mul 215 215; Add 0 0;
  ShowZero 0; (* first corner *)
  Mul 220 230; Sub 0 252;
  ShowZero 0; (* radius *)
  Mul 221 228; Sub 0 254;
  ShowZero 0; (* radius *)
  Mul 222 226; Sub 0 256;
  ShowZero 0 (* radius *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face in space with any even number of sides; size 6.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs, src/pair/area.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_6 : list step := [
  Unknown 0; Unknown 1; Sub 1 0;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 1; Mul 2 3; Add 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 2; Sub 0 6;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 7 1; Add 5 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 3; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 9 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 4; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 13 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 5; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 17 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Sub 20 3;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 4 21; Add 20 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Div 21 19; Sub 22 21; Mul 0 1; Mul 25 2; Div 25 19; Sub 26 21; Mul 0 1; Mul 24 2; Div 29 19;
  Sub 30 21; Mul 0 1; Mul 24 2; Div 33 19; Sub 34 21; Mul 0 1; Mul 24 2; Div 37 19; Sub 38 21;
  Mul 0 1; Mul 24 2; Div 41 20; Sub 42 22; Mul 0 1; Mul 25 2; Div 45 20; Div 46 17; Div 47 14;
  Div 48 11; Div 49 8; Div 50 5; Constant 0; Sub 24 28; Mul 7 6; Mul 1 0; Add 3 0; Sub 24 28;
  Mul 10 9; Neg 0; Mul 2 0; Add 4 0; Sub 25 29; Mul 14 13; Mul 1 0; Add 3 0; Sub 25 29; Mul 17 16;
  Neg 0; Mul 2 0; Add 4 0; Sub 26 30; Mul 21 20; Mul 1 0; Add 3 0; Sub 50 30; Mul 24 29; Neg 0;
  Mul 2 0; Add 4 0; Sub 0 27;
  ShowZero 0; (* as a test finds *)
  Add 82 83; Mul 0 59; Add 85 79; Mul 0 57; Add 81 77; Mul 0 55; Add 79 75; Mul 0 53; Add 77 73;
  Mul 0 51; Add 75 92; Mul 0 49; Sub 8 10; Mul 0 39; Add 42 0; Sub 9 11; Mul 0 37; Add 2 0;
  Sub 10 12; Mul 0 36; Add 2 0; Sub 11 13; Mul 0 34; Add 2 0; Sub 12 14; Mul 0 33; Add 2 0;
  Sub 25 15; Mul 0 31; Add 2 0; Sub 0 58;
  ShowZero 0; (* as a test finds *)
  Unknown 6; Unknown 7; Mul 1 89; Mul 1 32; Add 1 0; Add 0 64; Mul 5 89; Mul 5 34; Add 1 0;
  Add 0 68; Mul 9 89; Mul 9 36; Add 1 0; Add 0 72; Mul 13 89; Mul 13 38; Add 1 0; Add 0 76;
  Mul 17 89; Mul 17 40; Add 1 0; Add 0 80; Mul 21 89; Mul 21 42; Add 1 0; Add 0 84; Sub 16 20;
  Mul 0 84; Add 87 0; Sub 15 19; Mul 0 82; Add 2 0; Sub 14 18; Mul 0 81; Add 2 0; Sub 13 17;
  Mul 0 79; Add 2 0; Sub 12 16; Mul 0 78; Add 2 0; Sub 35 15; Mul 0 76; Add 2 0; Sub 0 103;
  ShowZero 0; (* as a test finds *)
  Sub 100 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 62 62;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 98 98;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 62 62;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 97 97;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 62 62;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 113 87; Sub 0 93; Sub 97 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 116 59; Sub 0 63; Sub 66 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 119 17; Sub 0 21; Sub 24 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 101; Sub 0 9;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 70; Sub 0 8;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 27; Sub 0 7;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 14 102; Sub 0 129;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 13 73; Sub 0 131;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 12 30; Sub 0 133;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 130 134; Sub 92 135; Sub 156 164; Sub 103 107; Sub 129 138; Sub 93 139; Mul 139 0;
  Mul 100 2; Sub 1 0; Add 143 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 164 176; Sub 113 119;
  Sub 137 150; Sub 102 151; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0; Sub 172 188; Sub 123 131; Sub 47 162; Sub 45 163; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0;
  Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0; Sub 180 200; Sub 133 143; Sub 60 174; Sub 58 175;
  Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 96 184; Mul 144 0; Mul 100 50; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 102 53; Mul 188 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 190 55; Mul 151 57; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 148 151; Sub 104 107; Mul 152 0; Mul 108 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 190 195; Mul 111 0; Mul 196 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 198 8; Mul 160 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 157 160; Sub 113 116; Mul 161 0; Mul 117 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 198 202; Mul 120 0; Mul 203 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 205 8; Mul 169 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 100 169; Sub 98 125; Mul 170 0; Mul 126 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 108 210; Mul 129 0; Mul 211 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 213 8; Mul 178 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 113 112; Sub 111 110; Mul 179 0; Mul 135 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 121 120; Mul 138 0; Mul 218 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 220 8; Mul 187 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 242 125; Sub 243 123; Mul 188 0; Mul 144 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 247 133; Mul 147 0; Mul 226 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 228 8; Mul 196 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  ShowZero 70; (* 4 area(F, S) *)
  Mul 281 277; Mul 120 0; Sub 0 255;
  ShowZero 0; (* edge *)
  Mul 121 2; Sub 0 217;
  ShowZero 0; (* edge *)
  Mul 74 4; Sub 0 174;
  ShowZero 0; (* edge *)
  Mul 284 280; Neg 0; Mul 63 0; Sub 0 259;
  ShowZero 0; (* edge *)
  Mul 70 2; Sub 0 222;
  ShowZero 0; (* edge *)
  Mul 71 4; Sub 0 179;
  ShowZero 0; (* edge *)
  Mul 288 284; Mul 58 0; Sub 0 261;
  ShowZero 0; (* edge *)
  Mul 65 2; Sub 0 226;
  ShowZero 0; (* edge *)
  Mul 66 4; Sub 0 183;
  ShowZero 0; (* edge *)
  Mul 291 287; Neg 0; Mul 54 0; Sub 0 265;
  ShowZero 0; (* edge *)
  Mul 61 2; Sub 0 231;
  ShowZero 0; (* edge *)
  Mul 62 4; Sub 0 188;
  ShowZero 0; (* edge *)
  Mul 295 291; Mul 49 0; Sub 0 267;
  ShowZero 0; (* edge *)
  Mul 56 2; Sub 0 235;
  ShowZero 0; (* edge *)
  Mul 57 4; Sub 0 192;
  ShowZero 0; (* edge *)
  Mul 298 318; Neg 0; Mul 45 0; Sub 0 271;
  ShowZero 0; (* edge *)
  Mul 52 2; Sub 0 240;
  ShowZero 0; (* edge *)
  Mul 53 4; Sub 0 197;
  ShowZero 0; (* edge *)
  Mul 305 326; Sub 0 352;
  ShowZero 0; (* radius *)
  Mul 301 301; Add 0 0;
  ShowZero 0; (* first corner *)
  Mul 308 326; Sub 0 356;
  ShowZero 0; (* radius *)
  Mul 309 324; Sub 0 358;
  ShowZero 0; (* radius *)
  Mul 310 322; Sub 0 360;
  ShowZero 0; (* radius *)
  Mul 311 320; Sub 0 362;
  ShowZero 0; (* radius *)
  Mul 312 318; Sub 0 364;
  ShowZero 0 (* radius *)
].

Theorem part_1_size_6_valid : valid part_1_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face in space with any even number of sides; size 8.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs, src/pair/area.rs,
    src/space/gradient.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_8 : list step := [
  Unknown 0; Unknown 1; Sub 1 0;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 1; Mul 2 3; Add 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 2; Sub 0 6;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 7 1; Add 5 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 3; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 9 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 4; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 13 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 5; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 17 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 6; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 21 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 7; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 25 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Sub 28 3;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 4 29; Add 28 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Div 29 27; Sub 30 29; Mul 0 1; Mul 33 2; Div 33 27; Sub 34 29; Mul 0 1; Mul 32 2; Div 37 27;
  Sub 38 29; Mul 0 1; Mul 32 2; Div 41 27; Sub 42 29; Mul 0 1; Mul 32 2; Div 45 27; Sub 46 29;
  Mul 0 1; Mul 32 2; Div 49 27; Sub 50 29; Mul 0 1; Mul 32 2; Div 53 27; Sub 54 29; Mul 0 1;
  Mul 32 2; Div 57 28; Sub 58 30; Mul 0 1; Mul 33 2; Div 61 28; Div 62 25; Div 63 22; Div 64 19;
  Div 65 16; Div 66 13; Div 67 10; Div 68 7; Constant 0; Sub 34 38; Mul 9 8; Mul 1 0; Add 3 0;
  Sub 34 38; Mul 12 11; Neg 0; Mul 2 0; Add 4 0; Sub 35 39; Mul 16 15; Mul 1 0; Add 3 0;
  Sub 35 39; Mul 19 18; Neg 0; Mul 2 0; Add 4 0; Sub 36 40; Mul 23 22; Mul 1 0; Add 3 0;
  Sub 36 40; Mul 26 25; Neg 0; Mul 2 0; Add 4 0; Sub 37 41; Mul 30 29; Mul 1 0; Add 3 0;
  Sub 69 41; Mul 33 40; Neg 0; Mul 2 0; Add 4 0; Sub 0 36;
  ShowZero 0; (* as a test finds *)
  Add 109 110; Mul 0 78; Add 112 106; Mul 0 76; Add 108 104; Mul 0 74; Add 106 102; Mul 0 72;
  Add 104 100; Mul 0 70; Add 102 98; Mul 0 68; Add 100 96; Mul 0 66; Add 98 123; Mul 0 64;
  Sub 12 14; Mul 0 52; Add 55 0; Sub 13 15; Mul 0 50; Add 2 0; Sub 14 16; Mul 0 49; Add 2 0;
  Sub 15 17; Mul 0 47; Add 2 0; Sub 16 18; Mul 0 46; Add 2 0; Sub 17 19; Mul 0 44; Add 2 0;
  Sub 18 20; Mul 0 43; Add 2 0; Sub 35 21; Mul 0 41; Add 2 0; Sub 0 77;
  ShowZero 0; (* as a test finds *)
  Unknown 8; Unknown 9; Mul 1 118; Mul 1 42; Add 1 0; Add 0 83; Mul 5 118; Mul 5 44; Add 1 0;
  Add 0 87; Mul 9 118; Mul 9 46; Add 1 0; Add 0 91; Mul 13 118; Mul 13 48; Add 1 0; Add 0 95;
  Mul 17 118; Mul 17 50; Add 1 0; Add 0 99; Mul 21 118; Mul 21 52; Add 1 0; Add 0 103; Mul 25 118;
  Mul 25 54; Add 1 0; Add 0 107; Mul 29 118; Mul 29 56; Add 1 0; Add 0 111; Sub 24 28; Mul 0 111;
  Add 114 0; Sub 23 27; Mul 0 109; Add 2 0; Sub 22 26; Mul 0 108; Add 2 0; Sub 21 25; Mul 0 106;
  Add 2 0; Sub 20 24; Mul 0 105; Add 2 0; Sub 19 23; Mul 0 103; Add 2 0; Sub 18 22; Mul 0 102;
  Add 2 0; Sub 49 21; Mul 0 100; Add 2 0; Sub 0 136;
  ShowZero 0; (* as a test finds *)
  Sub 133 133;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 82 82;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 131 131;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 82 82;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 130 130;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 82 82;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 128 128;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 82 82;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 149 114; Sub 0 120; Sub 0 125; Sub 130 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 153 77; Sub 0 81; Sub 0 85; Sub 88 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 157 22; Sub 0 26; Sub 0 30; Sub 33 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 9 135; Sub 0 11;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 93; Sub 0 9;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 36; Sub 0 7;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 16 137; Sub 0 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 14 96; Sub 0 16;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 12 39; Sub 0 14;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 23 138; Sub 0 174;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 21 99; Sub 0 176;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 19 42; Sub 0 178;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 175 179; Sub 124 180; Sub 211 219; Sub 139 143; Sub 174 183; Sub 125 184; Mul 184 0;
  Mul 132 2; Sub 1 0; Add 188 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 219 231; Sub 149 155;
  Sub 182 195; Sub 134 196; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0; Sub 227 243; Sub 159 167; Sub 189 207; Sub 143 208; Mul 15 0; Mul 15 2; Sub 1 0;
  Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0; Sub 235 255; Sub 169 179; Sub 67 219; Sub 64 220;
  Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0; Sub 243 267;
  Sub 179 191; Sub 80 231; Sub 77 232; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8;
  Sub 1 0; Add 3 0; Sub 251 279; Sub 189 203; Sub 93 243; Sub 90 244; Mul 15 0; Mul 15 2; Sub 1 0;
  Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 138 253; Mul 200 0; Mul 142 74; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 144 77; Mul 257 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 259 79; Mul 207 81; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 204 207; Sub 146 149; Mul 208 0; Mul 150 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 259 264; Mul 153 0; Mul 265 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 267 8; Mul 216 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 213 216; Sub 155 158; Mul 217 0; Mul 159 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 267 271; Mul 162 0; Mul 272 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 274 8; Mul 225 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 222 225; Sub 164 167; Mul 226 0; Mul 168 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 274 279; Mul 171 0; Mul 280 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 282 8; Mul 234 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 143 234; Sub 140 176; Mul 235 0; Mul 177 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 152 286; Mul 180 0; Mul 287 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 289 8; Mul 243 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 156 155; Sub 153 152; Mul 244 0; Mul 186 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 165 164; Mul 189 0; Mul 295 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 297 8; Mul 252 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 169 168; Sub 166 165; Mul 253 0; Mul 195 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 178 177; Mul 198 0; Mul 302 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 304 8; Mul 261 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 335 181; Sub 336 178; Mul 262 0; Mul 204 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 340 190; Mul 207 0; Mul 310 5; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 312 8; Mul 270 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  ShowZero 94; (* 4 area(F, S) *)
  Mul 384 380; Mul 168 0; Sub 0 348;
  ShowZero 0; (* edge *)
  Mul 169 2; Sub 0 297;
  ShowZero 0; (* edge *)
  Mul 98 4; Sub 0 240;
  ShowZero 0; (* edge *)
  Mul 387 383; Neg 0; Mul 87 0; Sub 0 352;
  ShowZero 0; (* edge *)
  Mul 94 2; Sub 0 302;
  ShowZero 0; (* edge *)
  Mul 95 4; Sub 0 245;
  ShowZero 0; (* edge *)
  Mul 391 387; Mul 82 0; Sub 0 354;
  ShowZero 0; (* edge *)
  Mul 89 2; Sub 0 306;
  ShowZero 0; (* edge *)
  Mul 90 4; Sub 0 249;
  ShowZero 0; (* edge *)
  Mul 394 390; Neg 0; Mul 78 0; Sub 0 358;
  ShowZero 0; (* edge *)
  Mul 85 2; Sub 0 311;
  ShowZero 0; (* edge *)
  Mul 86 4; Sub 0 254;
  ShowZero 0; (* edge *)
  Mul 398 394; Mul 73 0; Sub 0 360;
  ShowZero 0; (* edge *)
  Mul 80 2; Sub 0 315;
  ShowZero 0; (* edge *)
  Mul 81 4; Sub 0 258;
  ShowZero 0; (* edge *)
  Mul 401 397; Neg 0; Mul 69 0; Sub 0 364;
  ShowZero 0; (* edge *)
  Mul 76 2; Sub 0 320;
  ShowZero 0; (* edge *)
  Mul 77 4; Sub 0 263;
  ShowZero 0; (* edge *)
  Mul 405 401; Mul 64 0; Sub 0 366;
  ShowZero 0; (* edge *)
  Mul 71 2; Sub 0 324;
  ShowZero 0; (* edge *)
  Mul 72 4; Sub 0 267;
  ShowZero 0; (* edge *)
  Mul 408 436; Neg 0; Mul 60 0; Sub 0 370;
  ShowZero 0; (* edge *)
  Mul 67 2; Sub 0 329;
  ShowZero 0; (* edge *)
  Mul 68 4; Sub 0 272;
  ShowZero 0; (* edge *)
  Mul 415 444; Sub 0 478;
  ShowZero 0; (* radius *)
  Mul 409 409; Add 0 0;
  ShowZero 0; (* first corner *)
  Mul 418 444; Sub 0 482;
  ShowZero 0; (* radius *)
  Mul 419 442; Sub 0 484;
  ShowZero 0; (* radius *)
  Mul 420 440; Sub 0 486;
  ShowZero 0; (* radius *)
  Mul 421 438; Sub 0 488;
  ShowZero 0; (* radius *)
  Mul 422 436; Sub 0 490;
  ShowZero 0; (* radius *)
  Mul 423 434; Sub 0 492;
  ShowZero 0; (* radius *)
  Mul 424 432; Sub 0 494;
  ShowZero 0 (* radius *)
].

Theorem part_1_size_8_valid : valid part_1_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** by radii and by diagonals; size 1.
    Code: src/construct/christoffel/diagonals.rs, src/construct/christoffel/mod.rs,
    src/construct/christoffel/radii.rs, src/pair/area.rs, src/space/gradient.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Unknown 0; Unknown 1; Sub 1 0;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 1; Mul 2 3; Add 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 2; Sub 0 6;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 7 1; Add 5 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 3; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 9 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Sub 12 3;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 4 13; Add 12 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Div 13 11; Sub 14 13; Mul 0 1; Add 18 19; Mul 0 3; Div 18 12; Sub 19 14; Mul 0 1; Add 24 18;
  Mul 0 3; Div 23 13; Sub 24 15; Mul 0 1; Add 23 19; Mul 0 3; Sub 7 12; Sub 6 11; Sub 4 14;
  Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no three corners lie on a line *)
  Div 35 22; Sub 36 24; Mul 0 1; Add 31 40; Mul 0 3; Sub 14 19; Sub 13 18; Sub 4 21; Sub 3 20;
  Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no three corners lie on a line *)
  Sub 9 21; Sub 8 20; Sub 33 23; Sub 32 22; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no three corners lie on a line *)
  Sub 38 16; Sub 37 15; Sub 35 18; Sub 34 17; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* no three corners lie on a line *)
  Mul 62 47; Mul 58 43; Mul 55 39; Mul 53 28; Div 65 3; Div 66 3; Div 67 3; Div 68 3; Constant 0;
  Mul 4 3; Mul 42 0; Add 2 0; Mul 6 5; Neg 0; Mul 34 0; Add 3 0; Mul 9 8; Mul 30 0; Add 2 0;
  Mul 11 14; Neg 0; Mul 27 0; Add 3 0; Sub 0 14;
  ShowZero 0; (* as a test finds *)
  Mul 55 14; Add 16 0; Mul 45 12; Add 1 0; Mul 40 11; Add 1 0; Mul 35 9; Add 1 0; Sub 0 23;
  ShowZero 0; (* as a test finds *)
  Sub 24 24; Mul 0 24; Add 26 0; Mul 2 22; Add 1 0; Mul 4 21; Add 1 0; Mul 6 19; Add 1 0;
  Sub 0 33;
  ShowZero 0; (* as a test finds *)
  Sub 31 31;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 9 9;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 30 30;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 19 19;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 10 10;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 40 27; Sub 31 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 42 20; Sub 22 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 44 12; Sub 14 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 33; Sub 0 47;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 26; Sub 0 49;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 18; Sub 0 51;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 49 52; Sub 36 53; Sub 47 54; Sub 36 55; Mul 97 0; Mul 97 2; Sub 1 0; Add 59 0; Mul 7 98;
  Mul 7 100; Sub 1 0; Add 3 0; Sub 96 118; Sub 95 117; Sub 25 66; Sub 24 67; Mul 107 0; Mul 107 2;
  Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Div 146 111; Mul 52 115; Mul 118 53; Sub 1 0; Mul 0 3; Mul 122 56; Mul 57 121; Sub 1 0; Mul 0 7;
  Mul 4 139; Mul 1 138; Add 1 0; Sub 88 0; Add 1 0; Sub 90 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 140; Mul 7 139; Add 1 0; Add 0 5; Sub 95 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 140; Mul 12 139; Add 1 0; Add 0 10; Sub 100 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 133; Mul 17 132; Add 1 0; Add 0 15; Sub 105 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  ShowNonzero 129; (* as src/construct/christoffel/diagonals.rs finds *)
  ShowNonzero 122; (* as src/construct/christoffel/diagonals.rs finds *)
  Sub 160 155; Sub 159 154; Mul 1 134; Mul 1 136; Sub 1 0; Div 134 0; Mul 182 0; Sub 0 0;
  ShowZero 0; (* as a test finds *)
  Sub 163 158; Sub 162 157; Mul 1 135; Mul 1 137; Sub 1 0; Div 135 0; Mul 190 0; Sub 0 0;
  ShowZero 0; (* as a test finds *)
  Div 192 192; Div 193 10; Div 194 3; Mul 2 2; Mul 167 0; Add 127 0; Mul 5 4; Mul 158 0; Add 2 0;
  Mul 7 6; Mul 154 0; Add 2 0; Mul 9 11; Mul 150 0; Add 2 0; Sub 0 137;
  ShowZero 0; (* as a test finds *)
  Mul 178 12; Add 139 0; Mul 168 11; Add 1 0; Mul 163 10; Add 1 0; Mul 158 9; Add 1 0; Sub 0 146;
  ShowZero 0; (* as a test finds *)
  Mul 122 21; Add 148 0; Mul 124 20; Add 1 0; Mul 126 19; Add 1 0; Mul 128 18; Add 1 0; Sub 0 155;
  ShowZero 0; (* as a test finds *)
  Sub 28 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 17 17;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 9 9;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 28 28;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 10 10;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 162 26; Sub 29 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 164 19; Sub 21 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 166 12; Sub 14 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 32; Sub 0 169;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 25; Sub 0 171;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 18; Sub 0 173;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 46 174; Sub 35 175; Sub 45 176; Sub 35 177; Mul 219 0; Mul 219 2; Sub 1 0; Add 181 0;
  Mul 7 220; Mul 7 222; Sub 1 0; Add 3 0; Sub 23 186; Sub 22 187; Mul 227 0; Mul 227 2; Sub 1 0;
  Add 5 0; Mul 15 126; Mul 15 128; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 73 266;
  ShowZero 0; (* ν of the first vertex *)
  Sub 22 70;
  ShowZero 0; (* edge *)
  Sub 22 59;
  ShowZero 0; (* edge *)
  Sub 68 71; Sub 0 70;
  ShowZero 0; (* edge *)
  Sub 59 61; Sub 0 61;
  ShowZero 0; (* edge *)
  Sub 40 72; Sub 0 71;
  ShowZero 0; (* edge *)
  Sub 40 63; Sub 0 63;
  ShowZero 0; (* edge *)
  Sub 207 44; Sub 0 72;
  ShowZero 0; (* edge *)
  Sub 209 44; Sub 0 65;
  ShowZero 0; (* edge *)
  Sub 184 211; Sub 63 212; Mul 160 160; Mul 160 160; Add 1 0; Mul 4 4; Add 1 0; Mul 43 165;
  Mul 43 165; Add 1 0; Mul 8 9; Add 1 0; Mul 48 5; Mul 171 1; Sub 1 0;
  ShowZero 0; (* the same up to scale *)
  Mul 50 8; Mul 173 4; Sub 1 0;
  ShowZero 0; (* the same up to scale *)
  Mul 16 11; Mul 18 7; Sub 1 0;
  ShowZero 0; (* the same up to scale *)
  Mul 55 14; Mul 178 10; Sub 1 0;
  ShowZero 0; (* the same up to scale *)
  Mul 57 17; Mul 180 13; Sub 1 0;
  ShowZero 0; (* the same up to scale *)
  Sub 209 238; Sub 88 239; Mul 0 22; Mul 2 18; Sub 1 0;
  ShowZero 0; (* the same up to scale *)
  Mul 56 25; Mul 177 21; Sub 1 0;
  ShowZero 0; (* the same up to scale *)
  Mul 58 28; Mul 179 24; Sub 1 0;
  ShowZero 0; (* the same up to scale *)
  Sub 204 249; Sub 83 250; Mul 0 33; Mul 2 29; Sub 1 0;
  ShowZero 0; (* the same up to scale *)
  ShowZero 229 (* the first corner *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** four quads around a vertex; size 1.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs, src/pair/area.rs,
    src/pair/face.rs, src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs,
    src/space/motion.rs, src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_3_size_1 : list step := [
  Unknown 0; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 1; Mul 0 0; Add 4 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 0 0; Add 7 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 0 0; Add 10 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Unknown 5;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Unknown 6;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Unknown 7;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Unknown 8;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Div 16 14; Sub 17 16; Mul 0 1; Constant 2; Mul 21 0; Mul 0 4; Div 22 17; Sub 23 19; Mul 0 1;
  Mul 22 5; Mul 0 3; Mul 8 2; Mul 6 1; Add 1 0; Add 30 0;
  Nonzero 0; (* spokes that follow each other are not opposite *)
  Mul 19 18; Mul 19 18; Add 1 0; Mul 20 22; Add 1 0; Mul 24 24; Mul 18 10; Mul 16 13; Sub 1 0;
  Mul 0 0; Mul 4 0; Mul 11 11; Mul 7 0; Sub 2 0;
  Nonzero 0; (* the fourth corner is not at infinity *)
  Mul 32 32; Mul 0 3; Add 0 5;
  Nonzero 0; (* the circle of a face and that of a corner differ *)
  Div 48 40; Sub 49 42; Mul 0 1; Mul 45 31; Mul 0 3; Mul 28 2; Mul 27 1; Add 1 0; Add 56 0;
  Nonzero 0; (* spokes that follow each other are not opposite *)
  Mul 45 43; Mul 44 43; Add 1 0; Mul 45 48; Add 1 0; Mul 37 9; Mul 36 12; Sub 1 0; Mul 0 0;
  Mul 29 0; Mul 10 10; Mul 6 0; Sub 2 0;
  Nonzero 0; (* the fourth corner is not at infinity *)
  Mul 56 56; Mul 0 3; Add 0 5;
  Nonzero 0; (* the circle of a face and that of a corner differ *)
  Div 73 62; Sub 74 64; Mul 0 1; Mul 67 56; Mul 0 3; Mul 27 2; Mul 26 1; Add 1 0; Add 81 0;
  Nonzero 0; (* spokes that follow each other are not opposite *)
  Mul 70 67; Mul 68 67; Add 1 0; Mul 69 73; Add 1 0; Mul 36 9; Mul 35 12; Sub 1 0; Mul 0 0;
  Mul 54 0; Mul 10 10; Mul 6 0; Sub 2 0;
  Nonzero 0; (* the fourth corner is not at infinity *)
  Mul 80 80; Mul 0 3; Add 0 5;
  Nonzero 0; (* the circle of a face and that of a corner differ *)
  Mul 22 79; Mul 21 77; Add 1 0; Add 101 0;
  Nonzero 0; (* spokes that follow each other are not opposite *)
  Mul 90 86; Mul 87 90; Add 1 0; Mul 92 93; Add 1 0; Mul 31 85; Mul 30 89; Sub 1 0; Mul 0 0;
  Mul 74 0; Mul 10 10; Mul 6 0; Sub 2 0;
  Nonzero 0; (* the fourth corner is not at infinity *)
  Mul 99 99; Mul 0 3; Add 0 5;
  Nonzero 0; (* the circle of a face and that of a corner differ *)
  Add 106 105; Add 0 105; Mul 88 106; Mul 0 78; Mul 80 2; Sub 1 0; Div 0 79;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Add 113 111; Add 0 111; Mul 69 112; Mul 0 60; Mul 62 2; Sub 1 0; Div 0 61;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Add 120 117; Add 0 117; Mul 51 118; Mul 0 42; Mul 44 2; Sub 1 0; Div 0 43;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Add 127 123; Add 0 127; Mul 38 128; Mul 0 29; Mul 31 2; Sub 1 0; Div 0 30;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 0; Mul 128 28; Mul 126 29; Add 2 1; Add 3 1; Mul 126 25; Mul 125 26; Add 6 1; Add 7 1;
  Sub 8 1; Sub 9 1; Sub 7 3; Sub 7 3; Mul 3 0; Mul 3 2; Sub 1 0; Add 15 0;
  Nonzero 0; (* no face has three corners on a line *)
  Mul 112 30; Mul 111 31; Add 18 1; Add 19 1; Sub 20 1; Sub 21 1; Sub 15 3; Sub 15 3; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 27 0;
  Nonzero 0; (* no face has three corners on a line *)
  Mul 99 35; Mul 98 36; Add 30 1; Add 31 1; Sub 32 1; Sub 33 1; Sub 15 3; Sub 15 3; Mul 3 0;
  Mul 3 2; Sub 1 0; Add 39 0;
  Nonzero 0; (* no face has three corners on a line *)
  Sub 40 37; Sub 41 37; Sub 11 39; Sub 11 39; Mul 3 0; Mul 3 2; Sub 1 0; Add 47 0;
  Nonzero 0; (* no face has three corners on a line *)
  Add 176 170; Div 184 165; Mul 1 0; Neg 79; Mul 180 0; Add 2 0; Mul 181 188; Mul 0 159;
  Div 0 155; Mul 3 0; Add 186 0; Add 193 81; Mul 1 0; Add 58 0; Div 209 197; Div 210 197;
  Div 211 197; Div 212 87; Mul 1 3; Mul 58 0; Add 68 0; Sub 66 69; Mul 7 6; Neg 0; Mul 2 0;
  Add 4 0; Sub 12 71; Mul 11 9; Mul 1 0; Add 3 0; Sub 71 16; Mul 13 14; Neg 0; Mul 2 0; Add 4 0;
  Sub 0 83;
  ShowZero 0; (* as a test finds *)
  Add 209 204; Mul 0 35; Mul 211 34; Add 1 0; Mul 0 31; Add 214 0; Mul 0 30; Add 87 0; Mul 82 25;
  Add 93 0; Sub 90 94; Mul 0 23; Add 2 0; Sub 5 93; Mul 0 22; Add 2 0; Sub 92 8; Mul 0 20;
  Add 2 0; Sub 0 103;
  ShowZero 0; (* as a test finds *)
  Mul 104 104; Add 0 0; Sub 0 216; Div 254 234; Mul 1 0; Mul 106 106; Mul 106 106; Add 1 0;
  Sub 0 213; Mul 0 5; Mul 107 107; Mul 107 107; Add 1 0; Sub 0 193; Mul 0 10; Mul 57 57;
  Mul 28 28; Add 1 0; Mul 144 144; Sub 1 0; Mul 0 16; Sub 16 6; Mul 0 59; Add 127 0; Sub 14 19;
  Mul 0 57; Add 2 0; Sub 6 17; Mul 0 56; Add 2 0; Sub 15 9; Mul 0 54; Add 2 0; Sub 0 137;
  ShowZero 0; (* as a test finds *)
  Add 260 234; Div 274 229; Mul 1 0; Neg 162; Mul 264 0; Add 2 0; Mul 271 277; Mul 0 224;
  Div 0 220; Mul 3 0; Add 270 0; Add 282 164; Mul 1 0; Add 144 0; Div 299 284; Div 300 168;
  Mul 1 91; Neg 0; Mul 135 0; Add 157 0; Sub 151 158; Mul 96 94; Mul 1 0; Add 3 0; Sub 10 155;
  Mul 98 9; Neg 0; Mul 2 0; Add 4 0; Sub 148 15; Mul 14 15; Mul 1 0; Add 3 0; Sub 0 171;
  ShowZero 0; (* as a test finds *)
  Add 292 266; Mul 0 33; Mul 294 32; Add 1 0; Mul 0 29; Add 297 0; Mul 0 28; Add 171 0;
  Mul 158 24; Add 181 0; Sub 174 182; Mul 0 23; Add 2 0; Sub 5 177; Mul 0 21; Add 2 0; Sub 168 8;
  Mul 0 20; Add 2 0; Sub 0 191;
  ShowZero 0; (* as a test finds *)
  Mul 173 173; Mul 173 173; Add 1 0; Sub 0 246; Mul 0 88; Mul 45 45; Mul 18 18; Add 1 0;
  Mul 215 215; Sub 1 0; Mul 0 94; Sub 94 6; Mul 0 48; Add 205 0; Sub 87 97; Mul 0 47; Add 2 0;
  Sub 6 90; Mul 0 45; Add 2 0; Sub 15 9; Mul 0 44; Add 2 0; Sub 0 215;
  ShowZero 0; (* as a test finds *)
  Add 312 287; Div 352 282; Mul 1 0; Neg 233; Mul 316 0; Add 2 0; Mul 349 354; Mul 0 277;
  Div 0 273; Mul 3 0; Add 322 0; Add 359 235; Mul 1 0; Add 210 0; Div 377 361; Div 378 239;
  Mul 1 169; Mul 200 0; Add 234 0; Sub 216 235; Mul 173 83; Neg 0; Mul 2 0; Add 4 0; Sub 10 221;
  Mul 88 9; Mul 1 0; Add 3 0; Sub 213 14; Mul 13 14; Neg 0; Mul 2 0; Add 4 0; Sub 0 249;
  ShowZero 0; (* as a test finds *)
  Add 344 319; Mul 0 33; Mul 346 32; Add 1 0; Mul 0 29; Add 349 0; Mul 0 28; Add 237 0;
  Mul 224 25; Add 259 0; Sub 240 260; Mul 0 23; Add 2 0; Sub 5 243; Mul 0 22; Add 2 0; Sub 234 8;
  Mul 0 20; Add 2 0; Sub 0 269;
  ShowZero 0; (* as a test finds *)
  Mul 239 239; Mul 239 239; Add 1 0; Sub 0 304; Mul 0 166; Mul 45 45; Mul 18 18; Add 1 0;
  Mul 286 286; Sub 1 0; Mul 0 172; Sub 172 6; Mul 0 49; Add 283 0; Sub 87 175; Mul 0 47; Add 2 0;
  Sub 6 90; Mul 0 46; Add 2 0; Sub 15 9; Mul 0 44; Add 2 0; Sub 0 293;
  ShowZero 0; (* as a test finds *)
  Add 365 422; Div 430 340; Mul 1 0; Neg 304; Mul 369 0; Add 2 0; Mul 427 431; Mul 0 335;
  Div 0 331; Mul 3 0; Add 375 0; Add 436 306; Mul 1 0; Add 276 0; Div 455 309; Mul 245 246; Neg 0;
  Mul 270 0; Add 312 0; Sub 282 313; Mul 251 83; Mul 1 0; Add 3 0; Sub 9 286; Mul 87 9; Neg 0;
  Mul 2 0; Add 4 0; Sub 319 14; Mul 14 259; Mul 1 0; Add 3 0; Sub 0 326;
  ShowZero 0; (* as a test finds *)
  Add 396 452; Mul 0 32; Mul 398 31; Add 1 0; Mul 0 28; Add 401 0; Mul 0 27; Add 302 0;
  Mul 293 24; Add 336 0; Sub 305 337; Mul 0 23; Add 2 0; Sub 5 308; Mul 0 21; Add 2 0; Sub 339 8;
  Mul 0 20; Add 2 0; Sub 0 346;
  ShowZero 0; (* as a test finds *)
  Mul 39 39; Mul 13 13; Add 1 0; Mul 351 351; Sub 1 0; Mul 0 244; Sub 244 239; Mul 0 43;
  Add 355 0; Sub 81 247; Mul 0 42; Add 2 0; Sub 6 84; Mul 0 40; Add 2 0; Sub 248 9; Mul 0 39;
  Add 2 0; Sub 0 365;
  ShowZero 0; (* as a test finds *)
  Sub 366 298; Add 0 299; Sub 0 368;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 369 276; Add 0 277; Sub 0 371;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 372 245; Add 0 246; Sub 0 374;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 375 302; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 377 281; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 379 249; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 14 299; Add 6 305; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 14 282; Add 7 286; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 14 251; Add 8 255; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 308; Sub 0 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 290; Sub 0 23;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 258; Sub 0 22;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 396 239; Add 0 240; Sub 0 398;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 399 218; Add 0 219; Sub 0 401;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 402 197; Add 0 198; Sub 0 404;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 38 239; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 37 220; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 36 198; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 241; Sub 0 15;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 223; Sub 0 14;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 201; Sub 0 13;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 417 183; Add 0 184; Sub 0 419;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 420 161; Add 0 162; Sub 0 422;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 423 140; Add 0 141; Sub 0 425;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 29 183; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 28 163; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 27 141; Sub 0 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 184; Sub 0 15;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 166; Sub 0 14;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 144; Sub 0 13;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 62 113; Add 21 118; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 63 96; Add 21 100; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 64 80; Add 21 84; Sub 0 1;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 8 122; Sub 0 72;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 104; Sub 0 72;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 87; Sub 0 72;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 453 86; Sub 454 84; Sub 79 88; Sub 78 86; Mul 448 0; Mul 448 2; Sub 1 0; Add 460 0;
  Mul 7 449; Mul 7 451; Sub 1 0; Add 3 0; Sub 403 458; Sub 374 458; Sub 85 100; Sub 83 98;
  Mul 458 0; Mul 458 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 477 80; Sub 478 78; Sub 112 82; Sub 110 80; Mul 460 0; Mul 460 2; Sub 1 0; Add 484 0;
  Mul 7 461; Mul 7 463; Sub 1 0; Add 3 0; Sub 337 470; Sub 310 470; Sub 85 94; Sub 84 92;
  Mul 470 0; Mul 470 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 501 83; Sub 502 81; Sub 106 85; Sub 104 83; Mul 472 0; Mul 472 2; Sub 1 0; Add 508 0;
  Mul 7 473; Mul 7 475; Sub 1 0; Add 3 0; Sub 283 482; Sub 256 482; Sub 88 97; Sub 87 95;
  Mul 482 0; Mul 482 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 525 149; Sub 526 148; Sub 109 151; Sub 107 150; Mul 488 0; Mul 488 2; Sub 1 0; Add 532 0;
  Mul 7 489; Mul 7 491; Sub 1 0; Add 3 0; Sub 229 534; Sub 203 534; Sub 100 163; Sub 98 162;
  Mul 498 0; Mul 498 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 435 430; Div 697 535; Mul 425 539; Mul 542 2; Sub 1 0; Mul 0 3; Mul 546 5; Mul 430 545;
  Sub 1 0; Mul 0 7; Mul 4 552; Mul 1 552; Add 1 0; Sub 443 0; Add 1 0; Sub 445 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 565; Mul 7 566; Add 1 0; Add 0 5; Sub 460 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 567; Mul 12 567; Add 1 0; Add 0 10; Sub 460 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 513; Mul 17 484; Add 1 0; Add 0 15; Sub 454 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 213; Mul 22 211; Add 1 0; Sub 210 0; Add 16 0; Sub 585 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 31 210; Mul 28 209; Add 1 0; Add 0 5; Sub 210 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 36 209; Mul 33 207; Add 1 0; Add 0 10; Sub 207 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 477 399; Div 744 570; Mul 394 574; Mul 577 2; Sub 1 0; Mul 0 3; Mul 581 5; Mul 399 580;
  Sub 1 0; Mul 0 7; Mul 4 587; Mul 1 587; Add 1 0; Sub 412 0; Add 1 0; Sub 414 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 612; Mul 7 613; Add 1 0; Add 0 5; Sub 507 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 610; Mul 12 610; Add 1 0; Add 0 10; Sub 502 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 470; Mul 17 443; Add 1 0; Add 0 15; Sub 423 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 230; Mul 22 228; Add 1 0; Sub 227 0; Add 16 0; Sub 632 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 31 266; Mul 28 264; Add 1 0; Add 0 5; Sub 264 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 36 232; Mul 33 231; Add 1 0; Add 0 10; Sub 232 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 446 368; Div 791 605; Mul 363 609; Mul 612 2; Sub 1 0; Mul 0 3; Mul 616 5; Mul 368 615;
  Sub 1 0; Mul 0 7; Mul 4 622; Mul 1 622; Add 1 0; Sub 381 0; Add 1 0; Sub 383 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 659; Mul 7 660; Add 1 0; Add 0 5; Sub 554 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 645; Mul 12 645; Add 1 0; Add 0 10; Sub 471 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 439; Mul 17 412; Add 1 0; Add 0 15; Sub 392 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 256; Mul 22 254; Add 1 0; Sub 253 0; Add 16 0; Sub 679 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 31 283; Mul 28 281; Add 1 0; Add 0 5; Sub 281 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 36 258; Mul 33 257; Add 1 0; Add 0 10; Sub 258 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Sub 415 576; Div 838 644; Mul 338 648; Mul 651 2; Sub 1 0; Mul 0 3; Mul 655 5; Mul 343 654;
  Sub 1 0; Mul 0 7; Mul 4 697; Mul 1 697; Add 1 0; Sub 589 0; Add 1 0; Sub 591 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 706; Mul 7 707; Add 1 0; Add 0 5; Sub 601 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 680; Mul 12 680; Add 1 0; Add 0 10; Sub 440 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 408; Mul 17 382; Add 1 0; Add 0 15; Sub 367 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 345; Mul 22 344; Add 1 0; Sub 344 0; Add 16 0; Sub 726 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 31 309; Mul 28 307; Add 1 0; Add 0 5; Sub 307 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 36 293; Mul 33 291; Add 1 0; Add 0 10; Sub 291 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Add 277 273; Add 738 0; Add 267 263; Add 1 0; Constant 4; Div 889 0; Mul 2 0;
  ShowZero 0; (* mixed area *)
  Mul 290 287; Mul 290 289; Sub 1 0; Add 747 0; Mul 737 281; Mul 737 283; Sub 1 0; Add 735 0;
  Mul 296 283; Mul 296 285; Sub 1 0; Add 7 0; Mul 4 883; Mul 1 884; Mul 1 15; Mul 1 16;
  Mul 907 893; Mul 0 896; Mul 0 896; Mul 0 785; Mul 4 0; Add 6 0;
  ShowZero 0; (* areas *)
  Add 282 278; Add 767 0; Add 272 268; Add 1 0; Mul 0 27;
  ShowZero 0; (* mixed area *)
  Mul 293 290; Mul 293 292; Sub 1 0; Add 774 0; Mul 752 284; Mul 752 286; Sub 1 0; Add 750 0;
  Mul 299 286; Mul 299 288; Sub 1 0; Add 7 0; Mul 4 910; Mul 1 911; Mul 1 42; Mul 1 43;
  Mul 934 919; Mul 0 923; Mul 0 922; Mul 0 805; Mul 4 0; Add 6 0;
  ShowZero 0; (* areas *)
  Add 285 281; Add 794 0; Add 275 271; Add 1 0; Mul 0 54;
  ShowZero 0; (* mixed area *)
  Mul 296 293; Mul 296 295; Sub 1 0; Add 801 0; Mul 767 287; Mul 767 289; Sub 1 0; Add 765 0;
  Mul 302 289; Mul 302 291; Sub 1 0; Add 7 0; Mul 4 937; Mul 1 938; Mul 1 69; Mul 1 70;
  Mul 961 945; Mul 0 950; Mul 0 948; Mul 0 825; Mul 4 0; Add 6 0;
  ShowZero 0; (* areas *)
  Add 288 284; Add 821 0; Add 278 274; Add 1 0; Mul 0 81;
  ShowZero 0; (* mixed area *)
  Mul 299 296; Mul 299 298; Sub 1 0; Add 828 0; Mul 786 290; Mul 786 292; Sub 1 0; Add 784 0;
  Mul 305 292; Mul 305 294; Sub 1 0; Add 7 0; Mul 4 964; Mul 1 965; Mul 1 96; Mul 1 97;
  Mul 988 975; Mul 0 977; Mul 0 974; Mul 0 845; Mul 4 0; Add 6 0;
  ShowZero 0 (* areas *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
