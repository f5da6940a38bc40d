(** eq-1-motions (Sec. 2.1, (1), (2))

    The i-motions form a group. They keep i-distances and i-angles, parallel points, parallel
    planes and incidence, H and K of surfaces, and the classes of meshes of isotropic geometry;
    those that speak of Σ, with Σ moved along.

        x' ↦ R x' + (a, b),  z ↦ c + c₁x + c₂y + z

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** products and inverses; size 1.
    Code: src/space/action.rs, src/space/motion.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0; Constant 1; Sub 1 0;
  Zero 0; (* c² + s² = 1 *)
  Unknown 2; Unknown 3; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 6;
  Zero 0; (* c² + s² = 1 *)
  ShowZero 6; (* as a test finds *)
  ShowZero 0; (* as a test finds *)
  Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8; Mul 10 4; Mul 10 4; Sub 1 0; Mul 20 13;
  Mul 20 13; Sub 1 0; Mul 23 15; Mul 23 17; Add 1 0; Add 6 11; Mul 4 11; Mul 2 11; Sub 1 0;
  Add 0 3; Mul 31 15; Mul 31 15; Sub 1 0; Mul 33 18; Mul 35 18; Add 1 0; Add 3 24; Add 1 24;
  Mul 32 1; Mul 32 1; Sub 1 0; Add 0 27; Sub 12 0;
  ShowZero 0; (* one after the other *)
  Unknown 9; Mul 37 32; Mul 39 32; Add 1 0; Add 0 3; Mul 23 33; Mul 27 33; Add 1 0; Add 0 3;
  Mul 45 15; Mul 47 15; Add 1 0; Add 0 11; Sub 4 0;
  ShowZero 0; (* one after the other *)
  Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15; Unknown 16; Neg 64;
  Mul 66 4; Mul 1 4; Sub 1 0; Mul 3 7; Mul 70 7; Add 1 0; Add 13 3; Add 13 1; Add 13 10;
  Mul 13 62; Mul 13 62; Add 1 0; Add 3 0; Mul 6 63; Mul 6 63; Add 1 0; Add 0 3; Add 0 18;
  Mul 25 68; Mul 25 68; Add 1 0; Add 0 26; Add 0 23; Mul 27 51; Mul 27 51; Add 1 0; Add 0 28;
  Add 0 4; Sub 10 0;
  ShowZero 0; (* one after the other *)
  Mul 72 72; Mul 70 70; Add 1 0; Sub 0 94;
  ShowZero 0; (* a rotation again *)
  Mul 99 86; Mul 34 86; Sub 1 0; Neg 0; Mul 103 65; Mul 38 65; Sub 1 0; Add 0 3; Sub 0 91;
  ShowZero 0; (* there and back *)
  Mul 42 95; Mul 109 95; Add 1 0; Neg 0; Mul 46 74; Mul 113 74; Add 1 0; Add 0 3; Sub 0 99;
  ShowZero 0; (* there and back *)
  Mul 117 58; Mul 117 58; Sub 1 0; Mul 119 61; Mul 121 61; Add 1 0; Neg 3; Neg 1; Mul 1 112;
  Mul 1 112; Add 1 0; Add 0 67; Neg 0; Mul 6 92; Mul 6 92; Add 1 0; Add 0 3; Add 0 45; Sub 0 70;
  ShowZero 0; (* there and back *)
  Mul 70 119; Sub 105 0; Mul 72 122; Add 0 103; Add 2 37; Add 1 29; Mul 142 1; Mul 142 1; Sub 1 0;
  Add 0 132; Sub 0 130;
  ShowZero 0; (* back and there *)
  Mul 146 6; Mul 148 6; Add 1 0; Add 0 136; Sub 0 134;
  ShowZero 0; (* back and there *)
  Mul 28 136; Mul 28 136; Add 1 0; Add 0 25; Add 0 91; Mul 98 16; Mul 98 16; Add 1 0; Add 0 99;
  Add 0 4; Sub 0 97;
  ShowZero 0; (* back and there *)
  Mul 97 97; Add 162 0; Sub 0 160;
  ShowZero 0; (* the inverse rotation *)
  Constant 0; Mul 162 151; Mul 1 151; Sub 1 0; Add 0 3; Sub 0 155;
  ShowZero 0; (* the identity *)
  Mul 5 156; Mul 168 156; Add 1 0; Add 0 8; Sub 0 159;
  ShowZero 0; (* the identity *)
  Add 4 8; Add 0 11; Add 0 114; Sub 0 115;
  ShowZero 0 (* the identity *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** distances, angles, incidence, spheres; size 1.
    Code: src/scalar/ring.rs, src/space/action.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/plane.rs, src/space/point.rs, src/space/sphere.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0; Constant 1; Sub 1 0;
  Zero 0; (* c² + s² = 1 *)
  ShowZero 0; (* as a test finds *)
  Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Mul 12 3; Mul 12 3; Sub 1 0;
  Mul 14 6; Mul 16 6; Add 1 0; Add 3 11; Add 1 11; Mul 20 9; Mul 20 9; Sub 1 0; Mul 22 12;
  Mul 24 12; Add 1 0; Add 3 19; Add 1 19; Sub 9 1; Sub 9 1; Mul 1 1; Mul 1 1; Add 1 0; Sub 24 22;
  Sub 24 22; Mul 1 1; Mul 1 1; Add 1 0; Sub 5 0;
  ShowZero 0; (* i-distance² *)
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Add 3 5; Add 3 5;
  Mul 47 1; Mul 47 1; Sub 1 0; Mul 49 4; Mul 51 4; Add 1 0; Add 9 13; Add 9 13; Mul 55 1;
  Mul 55 1; Sub 1 0; Mul 57 4; Mul 59 4; Add 1 0; Sub 11 3; Sub 9 1; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 24 22; Sub 24 22; Mul 1 1; Mul 1 1; Add 1 0; Sub 5 0;
  ShowZero 0; (* i-angle² *)
  Unknown 14; Unknown 15; Unknown 16; Mul 35 66; Mul 35 66; Add 1 0; Add 0 5; Add 0 5; Mul 30 73;
  Mul 28 73; Add 1 0; Add 8 10; Sub 0 1; Mul 35 66; Mul 33 66; Add 1 0; Add 0 3; Sub 9 0;
  Mul 48 81; Mul 48 81; Add 1 0; Add 0 18; Sub 20 0; Sub 5 0;
  ShowZero 0; (* incidence *)
  Sub 77 77; Sub 77 77; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0; (* parallel points *)
  Sub 51 51; Sub 49 49; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0; (* parallel planes *)
  Sub 95 97; Sub 95 97; Mul 108 1; Mul 108 1; Sub 1 0; Add 92 0; Sub 0 85;
  ShowZero 0; (* vectors *)
  Mul 112 6; Mul 114 6; Add 1 0; Add 96 0; Sub 0 89;
  ShowZero 0; (* vectors *)
  Unknown 17; Mul 79 108; Mul 79 108; Add 1 0; Add 0 49; Add 0 4; Sub 5 50; Mul 85 18; Mul 85 18;
  Add 1 0; Add 0 3; Add 49 0; Sub 0 6;
  ShowZero 0; (* vectors *)
  Unknown 18; Unknown 19; Mul 75 126; Mul 73 126; Add 1 0; Add 4 63; Sub 0 1; Mul 131 131;
  Mul 131 131; Add 1 0; Mul 8 0; Div 137 143; Mul 1 0; Add 6 0; Neg 12; Mul 139 0; Mul 139 1;
  Add 90 1; Add 88 1; Mul 1 131; Mul 1 131; Add 1 0; Add 0 8; Sub 74 0; Mul 0 156; Mul 137 137;
  Mul 137 137; Add 1 0; Mul 26 0; Sub 4 0; Mul 117 152; Mul 117 152; Add 1 0; Add 0 32; Sub 91 0;
  Mul 0 167; Mul 158 158; Mul 158 158; Add 1 0; Mul 37 0; Sub 4 0; Sub 11 0;
  ShowZero 0; (* points and spheres *)
  Sub 88 28; Mul 0 175; Sub 26 125; Sub 26 123; Mul 1 1; Mul 1 1; Add 1 0; Mul 47 5; Add 1 0;
  Sub 107 50; Mul 0 184; Sub 140 142; Sub 140 142; Mul 1 1; Mul 1 1; Add 1 0; Mul 56 5; Add 1 0;
  Sub 9 0;
  ShowZero 0 (* planes and spheres *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** H, K and the graph of second order; size 1.
    Code: src/scalar/ring.rs, src/space/action.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/plane.rs, src/space/point.rs, src/space/surface.rs *)
Definition part_3_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0; Constant 1; Sub 1 0;
  Zero 0; (* c² + s² = 1 *)
  ShowZero 0; (* as a test finds *)
  Unknown 2; Unknown 3; Unknown 4; Neg 8; Constant 0; Mul 11 6; Mul 2 1; Sub 1 0; Mul 4 9;
  Mul 15 4; Add 1 0; Mul 10 3; Mul 10 1; Add 1 0; Mul 12 6; Mul 12 4; Add 1 0; Mul 23 3; Mul 23 1;
  Sub 1 0; Sub 10 11; Add 14 15; Mul 21 1; Mul 21 1; Add 1 0; Mul 23 4; Mul 23 4; Add 1 0;
  Mul 33 3; Mul 35 1; Add 1 0; Add 11 0; Div 33 39; Mul 1 0; Add 33 31; Mul 0 2; Sub 2 0;
  ShowZero 0; (* H *)
  Mul 42 23; Mul 44 21; Add 1 0; Mul 20 9; Mul 1 1; Sub 1 0; Mul 42 40; Mul 42 42; Sub 1 0;
  Sub 3 0;
  ShowZero 0; (* K *)
  Unknown 5; Unknown 6; Unknown 7; Unknown 8; Unknown 9; Unknown 10; Unknown 11; Unknown 12;
  Unknown 13; Unknown 14; Mul 9 4; Mul 9 4; Add 1 0; Add 0 8; Mul 67 8; Mul 67 8; Sub 1 0;
  Mul 69 11; Mul 71 11; Add 1 0; Add 3 17; Add 1 17; Add 8 14; Add 14 22; Add 14 22; Mul 78 1;
  Mul 78 1; Sub 1 0; Mul 80 4; Mul 82 4; Add 1 0; Unknown 15; Unknown 16; Sub 1 27; Sub 1 27;
  Mul 81 1; Mul 81 1; Add 1 0; Mul 83 4; Mul 83 4; Add 1 0; Mul 7 3; Mul 7 1; Add 1 0; Mul 0 58;
  Mul 36 39; Mul 36 39; Add 1 0; Sub 40 0; Mul 40 17; Mul 40 17; Add 1 0; Add 0 3; Add 0 8;
  Mul 53 22; Mul 53 22; Add 1 0; Add 0 52; Mul 111 26; Mul 111 26; Sub 1 0; Mul 113 29;
  Mul 115 29; Add 1 0; Add 3 61; Add 1 61; Add 8 12; Sub 2 46; Sub 2 46; Mul 96 1; Mul 77 1;
  Add 1 0; Mul 79 4; Mul 89 4; Add 1 0; Mul 7 3; Mul 7 1; Add 1 0; Mul 0 92; Mul 51 58; Mul 49 58;
  Add 1 0; Sub 59 0; Mul 55 18; Mul 53 18; Add 1 0; Add 0 3; Add 0 8; Sub 0 21;
  ShowZero 0 (* the moved graph *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** residuals on points; size 4.
    Code: src/net/i_conical.rs, src/net/i_isothermic.rs, src/net/i_minimal.rs, src/net/koenigs.rs,
    src/scalar/ring.rs, src/space/action.rs, src/space/motion.rs, src/space/point.rs *)
Definition part_4_size_4 : list step := [
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0; Constant 1; Sub 1 0;
  Zero 0; (* c² + s² = 1 *)
  ShowZero 0; (* as a test finds *)
  Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8; Unknown 9;
  Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15; Unknown 16; Unknown 17;
  Unknown 18; Unknown 19; Unknown 20; Unknown 21; Mul 26 17; Mul 26 17; Sub 1 0; Mul 28 20;
  Mul 30 20; Add 1 0; Add 3 25; Add 1 25; Mul 34 23; Mul 34 23; Sub 1 0; Mul 36 26; Mul 38 26;
  Add 1 0; Add 3 33; Add 1 33; Mul 42 29; Mul 42 29; Sub 1 0; Mul 44 32; Mul 46 32; Add 1 0;
  Add 3 41; Add 1 41; Mul 50 35; Mul 50 35; Sub 1 0; Mul 52 38; Mul 54 38; Add 1 0; Add 3 49;
  Add 1 49; Mul 58 41; Mul 58 41; Sub 1 0; Mul 60 44; Mul 62 44; Add 1 0; Add 3 57; Add 1 57;
  Mul 66 47; Mul 66 47; Sub 1 0; Mul 68 50; Mul 70 50; Add 1 0; Add 3 65; Add 1 65; Mul 74 53;
  Mul 74 53; Sub 1 0; Mul 76 56; Mul 78 56; Add 1 0; Add 3 73; Add 1 73; Mul 82 59; Mul 82 59;
  Sub 1 0; Mul 84 62; Mul 86 62; Add 1 0; Add 3 81; Add 1 81; Mul 90 65; Mul 90 65; Sub 1 0;
  Mul 92 68; Mul 94 68; Add 1 0; Add 3 89; Add 1 89; Sub 25 65; Sub 25 65; Sub 51 67; Sub 51 67;
  Mul 3 0; Mul 3 2; Sub 1 0; Mul 100 0; Sub 65 73; Sub 65 73; Mul 9 0; Mul 9 2; Sub 1 0;
  Mul 106 0; Sub 31 79; Sub 31 79; Sub 57 81; Sub 57 81; Mul 3 0; Mul 3 2; Sub 1 0; Mul 13 0;
  Mul 7 18; Mul 7 20; Sub 1 0; Mul 11 0; Sub 35 91; Sub 35 91; Sub 61 93; Sub 61 93; Mul 3 0;
  Mul 3 2; Sub 1 0; Mul 11 0; Mul 7 16; Mul 7 18; Sub 1 0; Mul 11 0; Sub 39 103; Sub 39 103;
  Mul 1 30; Mul 1 32; Sub 1 0; Mul 9 0; Mul 5 14; Mul 5 16; Sub 1 0; Mul 9 0; Sub 4 0;
  Sub 128 138; Sub 128 138; Sub 136 140; Sub 136 140; Mul 3 0; Mul 3 2; Sub 1 0; Mul 149 0;
  Sub 144 146; Sub 144 146; Mul 9 0; Mul 9 2; Sub 1 0; Mul 155 0; Sub 140 152; Sub 140 152;
  Sub 148 154; Sub 148 154; Mul 3 0; Mul 3 2; Sub 1 0; Mul 13 0; Mul 7 18; Mul 7 20; Sub 1 0;
  Mul 11 0; Sub 150 164; Sub 150 164; Sub 158 166; Sub 158 166; Mul 3 0; Mul 3 2; Sub 1 0;
  Mul 11 0; Mul 7 16; Mul 7 18; Sub 1 0; Mul 11 0; Sub 160 176; Sub 160 176; Mul 1 30; Mul 1 32;
  Sub 1 0; Mul 9 0; Mul 5 14; Mul 5 16; Sub 1 0; Mul 9 0; Sub 4 0; Sub 49 0;
  ShowZero 0; (* Koenigs *)
  Unknown 22; Unknown 23; Unknown 24; Unknown 25; Unknown 26; Unknown 27; Unknown 28; Unknown 29;
  Mul 7 196; Mul 7 196; Add 1 0; Add 0 8; Add 0 8; Mul 12 199; Mul 12 199; Add 1 0; Add 0 13;
  Add 0 12; Mul 17 202; Mul 17 202; Add 1 0; Add 0 18; Add 0 16; Mul 22 205; Mul 22 205; Add 1 0;
  Add 0 23; Add 0 20; Mul 27 208; Mul 27 208; Add 1 0; Add 0 28; Add 0 24; Sub 15 20; Sub 11 21;
  Sub 7 22; Sub 3 23; Mul 127 132; Mul 127 134; Sub 1 0; Mul 136 121; Mul 136 123; Sub 1 0;
  Mul 125 112; Mul 125 114; Sub 1 0; Mul 116 135; Mul 116 137; Sub 1 0; Constant 0; Mul 140 140;
  Mul 140 140; Add 1 0; Mul 16 13; Mul 124 149; Mul 124 151; Sub 1 0; Mul 23 0; Sub 4 0;
  Mul 24 10; Add 1 0; Mul 8 0; Mul 0 19; Mul 0 17; Add 14 0; Mul 161 161; Mul 161 161; Add 1 0;
  Mul 34 25; Mul 159 150; Mul 159 152; Sub 1 0; Mul 37 0; Sub 4 0; Mul 38 34; Add 1 0; Mul 8 0;
  Mul 0 31; Mul 0 29; Add 14 0; Mul 162 162; Mul 162 162; Add 1 0; Mul 48 37; Mul 180 153;
  Mul 180 155; Sub 1 0; Mul 51 0; Sub 4 0; Mul 52 46; Add 1 0; Mul 8 0; Mul 0 52; Mul 0 44;
  Add 14 0; Mul 165 165; Mul 165 165; Add 1 0; Mul 62 49; Mul 181 188; Mul 181 190; Sub 1 0;
  Mul 65 0; Sub 4 0; Mul 70 58; Add 1 0; Mul 8 0; Mul 0 67; Mul 0 65; Add 14 0; Sub 105 106;
  Sub 105 107; Sub 105 108; Sub 105 109; Mul 155 160; Mul 155 162; Sub 1 0; Mul 164 149;
  Mul 164 151; Sub 1 0; Mul 153 140; Mul 153 142; Sub 1 0; Mul 144 163; Mul 144 165; Sub 1 0;
  Mul 167 167; Mul 167 167; Add 1 0; Mul 15 12; Mul 151 176; Mul 151 178; Sub 1 0; Mul 22 0;
  Sub 4 0; Mul 23 9; Add 1 0; Mul 8 0; Mul 0 18; Mul 0 16; Add 90 0; Mul 188 188; Mul 188 188;
  Add 1 0; Mul 33 24; Mul 186 177; Mul 186 179; Sub 1 0; Mul 36 0; Sub 4 0; Mul 37 33; Add 1 0;
  Mul 8 0; Mul 0 30; Mul 0 28; Add 14 0; Mul 189 189; Mul 189 189; Add 1 0; Mul 47 36;
  Mul 207 180; Mul 207 182; Sub 1 0; Mul 50 0; Sub 4 0; Mul 51 45; Add 1 0; Mul 8 0; Mul 0 51;
  Mul 0 43; Add 14 0; Mul 192 192; Mul 192 192; Add 1 0; Mul 61 48; Mul 208 215; Mul 208 217;
  Sub 1 0; Mul 64 0; Sub 4 0; Mul 69 57; Add 1 0; Mul 8 0; Mul 0 66; Mul 0 64; Add 14 0; Sub 76 0;
  ShowZero 0; (* i-minimal *)
  Mul 282 151; Mul 153 269; Sub 1 0; Mul 155 272; Mul 287 155; Sub 1 0; Mul 283 3; Mul 283 1;
  Add 1 0; Add 0 127; Mul 243 84; Mul 86 230; Sub 1 0; Mul 88 233; Mul 248 88; Sub 1 0; Mul 244 3;
  Mul 244 1; Add 1 0; Add 0 61; Sub 10 0;
  ShowZero 0; (* planar, asymptotic *)
  Mul 289 140; Mul 126 304; Sub 1 0; Mul 128 307; Mul 294 144; Sub 1 0; Mul 296 309; Mul 296 311;
  Sub 1 0; Mul 307 6; Mul 307 4; Add 1 0; Mul 167 3; Add 1 0; Mul 254 78; Mul 64 269; Sub 1 0;
  Mul 66 272; Mul 259 82; Sub 1 0; Mul 261 274; Mul 261 276; Sub 1 0; Mul 272 6; Mul 272 4;
  Add 1 0; Mul 105 3; Add 1 0; Sub 14 0;
  ShowZero 0; (* i-circular *)
  Mul 333 307; Mul 333 307; Sub 1 0; Add 155 154; Mul 331 323; Mul 331 323; Sub 1 0; Add 174 173;
  Mul 5 0; Mul 5 2; Sub 1 0; Mul 295 269; Mul 295 269; Sub 1 0; Add 90 89; Mul 293 285;
  Mul 293 285; Sub 1 0; Add 109 108; Mul 5 0; Mul 5 2; Sub 1 0; Sub 11 0;
  ShowZero 0; (* i-conical *)
  Sub 455 454; Mul 458 457; Mul 458 459; Add 1 0; Mul 3 461; Mul 1 461; Sub 1 0; Mul 6 463;
  Mul 4 465; Add 1 0; Mul 3 467; Mul 1 467; Sub 1 0; Mul 6 469; Mul 4 471; Add 1 0; Sub 454 460;
  Sub 454 460; Mul 470 1; Mul 229 1; Sub 1 0; Mul 473 3; Mul 232 5; Add 1 0; Sub 470 462;
  Sub 470 462; Mul 478 1; Mul 237 1; Sub 1 0; Mul 481 3; Mul 240 5; Add 1 0; Sub 468 474;
  Sub 468 474; Mul 13 1; Mul 11 1; Sub 1 0; Mul 16 3; Mul 14 5; Add 1 0; Sub 484 476; Sub 484 476;
  Mul 13 1; Mul 11 1; Sub 1 0; Mul 16 3; Mul 14 5; Add 1 0; Sub 482 488; Sub 482 488; Mul 13 1;
  Mul 11 1; Sub 1 0; Mul 16 3; Mul 14 5; Add 1 0; Sub 498 490; Sub 498 490; Mul 13 1; Mul 11 1;
  Sub 1 0; Mul 16 3; Mul 14 5; Add 1 0; Sub 496 510; Sub 496 510; Mul 13 1; Mul 11 1; Sub 1 0;
  Sub 509 501; Sub 509 501; Mul 10 1; Mul 8 1; Sub 1 0; Sub 5 0; Mul 22 9; Mul 20 11; Add 1 0;
  Mul 17 7; Mul 15 9; Add 1 0; Sub 3 0; Mul 69 7; Mul 67 1; Sub 1 0; Sub 469 493; Sub 469 493;
  Mul 539 1; Mul 298 1; Sub 1 0; Mul 542 3; Mul 301 5; Add 1 0; Sub 509 477; Sub 509 477;
  Mul 547 1; Mul 306 1; Sub 1 0; Mul 550 3; Mul 309 5; Add 1 0; Sub 477 501; Sub 477 501;
  Mul 13 1; Mul 11 1; Sub 1 0; Mul 16 3; Mul 14 5; Add 1 0; Sub 517 485; Sub 517 485; Mul 13 1;
  Mul 11 1; Sub 1 0; Mul 16 3; Mul 14 5; Add 1 0; Sub 485 509; Sub 485 509; Mul 13 1; Mul 11 1;
  Sub 1 0; Mul 16 3; Mul 14 5; Add 1 0; Sub 525 493; Sub 525 493; Mul 13 1; Mul 11 1; Sub 1 0;
  Mul 16 3; Mul 14 5; Add 1 0; Sub 493 549; Sub 493 549; Mul 13 1; Mul 11 1; Sub 1 0; Sub 530 498;
  Sub 530 498; Mul 10 1; Mul 8 1; Sub 1 0; Sub 5 0; Sub 0 59;
  ShowZero 0; (* i-isothermic of circular type *)
  Mul 129 70; Mul 133 64; Add 1 0; Mul 26 13; Mul 24 15; Add 1 0; Mul 21 11; Mul 19 13; Add 1 0;
  Sub 3 0; Sub 0 7;
  ShowZero 0 (* i-isothermic of circular type *)
].

Theorem part_4_size_4_valid : valid part_4_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** residuals on points; size 2.
    Code: src/net/i_conical.rs, src/net/i_isothermic.rs, src/net/i_minimal.rs, src/net/koenigs.rs,
    src/scalar/ring.rs, src/space/action.rs, src/space/motion.rs, src/space/point.rs *)
Definition part_4_size_2 : list step := [
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0; Constant 1; Sub 1 0;
  Zero 0; (* c² + s² = 1 *)
  ShowZero 0; (* as a test finds *)
  Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8; Unknown 9;
  Unknown 10; Unknown 11; Unknown 12; Unknown 13; Mul 18 9; Mul 18 9; Sub 1 0; Mul 20 12;
  Mul 22 12; Add 1 0; Add 3 17; Add 1 17; Mul 26 15; Mul 26 15; Sub 1 0; Mul 28 18; Mul 30 18;
  Add 1 0; Add 3 25; Add 1 25; Mul 34 21; Mul 34 21; Sub 1 0; Mul 36 24; Mul 38 24; Add 1 0;
  Add 3 33; Add 1 33; Mul 42 27; Mul 42 27; Sub 1 0; Mul 44 30; Mul 46 30; Add 1 0; Add 3 41;
  Add 1 41; Mul 50 33; Mul 50 33; Sub 1 0; Mul 52 36; Mul 54 36; Add 1 0; Add 3 49; Add 1 49;
  Sub 9 33; Sub 9 33; Sub 19 35; Sub 19 35; Mul 3 0; Mul 3 2; Sub 1 0; Mul 60 0; Sub 33 41;
  Sub 33 41; Mul 9 0; Mul 9 2; Sub 1 0; Mul 66 0; Sub 15 47; Sub 15 47; Mul 1 6; Mul 1 8; Sub 1 0;
  Mul 11 0; Mul 5 16; Mul 5 18; Sub 1 0; Mul 9 0; Sub 4 0; Sub 68 74; Sub 68 74; Sub 72 76;
  Sub 72 76; Mul 3 0; Mul 3 2; Sub 1 0; Mul 85 0; Sub 80 82; Sub 80 82; Mul 9 0; Mul 9 2; Sub 1 0;
  Mul 91 0; Sub 80 88; Sub 80 88; Mul 1 6; Mul 1 8; Sub 1 0; Mul 11 0; Mul 5 16; Mul 5 18;
  Sub 1 0; Mul 9 0; Sub 4 0; Sub 25 0;
  ShowZero 0; (* Koenigs *)
  Unknown 14; Unknown 15; Unknown 16; Unknown 17; Unknown 18; Unknown 19; Mul 5 106; Mul 5 106;
  Add 1 0; Add 0 6; Add 0 6; Mul 10 109; Mul 10 109; Add 1 0; Add 0 11; Add 0 10; Mul 15 112;
  Mul 15 112; Add 1 0; Add 0 16; Add 0 14; Sub 5 10; Sub 1 11; Mul 65 70; Mul 65 72; Sub 1 0;
  Mul 74 67; Mul 74 69; Sub 1 0; Constant 0; Mul 72 72; Mul 72 72; Add 1 0; Mul 10 7; Mul 82 81;
  Mul 82 83; Sub 1 0; Mul 15 0; Sub 4 0; Mul 16 10; Add 1 0; Mul 8 0; Add 12 0; Mul 91 91;
  Mul 91 91; Add 1 0; Mul 24 17; Mul 89 88; Mul 89 90; Sub 1 0; Mul 27 0; Sub 4 0; Mul 30 26;
  Add 1 0; Mul 8 0; Add 12 0; Sub 51 52; Sub 51 53; Mul 75 80; Mul 75 82; Sub 1 0; Mul 84 77;
  Mul 84 79; Sub 1 0; Mul 81 81; Mul 81 81; Add 1 0; Mul 9 6; Mul 91 90; Mul 91 92; Sub 1 0;
  Mul 14 0; Sub 4 0; Mul 15 9; Add 1 0; Mul 8 0; Add 46 0; Mul 100 100; Mul 100 100; Add 1 0;
  Mul 23 16; Mul 98 97; Mul 98 99; Sub 1 0; Mul 26 0; Sub 4 0; Mul 29 25; Add 1 0; Mul 8 0;
  Add 12 0; Sub 34 0;
  ShowZero 0; (* i-minimal *)
  Unknown 20; Mul 91 186; Mul 91 186; Add 1 0; Add 0 92; Add 0 4; Sub 0 86; Mul 145 0; Mul 76 148;
  Sub 1 0; Mul 78 151; Mul 150 4; Sub 1 0; Mul 152 153; Mul 152 155; Sub 1 0; Mul 149 6;
  Mul 149 4; Add 1 0; Mul 88 3; Add 1 0; Sub 20 108; Mul 135 0; Mul 56 138; Sub 1 0; Mul 58 141;
  Mul 140 4; Sub 1 0; Mul 142 143; Mul 142 145; Sub 1 0; Mul 139 6; Mul 139 4; Add 1 0; Mul 68 3;
  Add 1 0; Sub 15 0;
  ShowZero 0; (* planar, asymptotic *)
  Mul 178 178; Mul 178 178; Add 1 0; Mul 180 85; Mul 1 179; Sub 1 0; Mul 3 182; Mul 185 89;
  Sub 1 0; Mul 179 3; Mul 179 1; Add 1 0; Mul 107 184; Add 1 0; Mul 167 167; Mul 167 167; Add 1 0;
  Mul 169 65; Mul 1 168; Sub 1 0; Mul 3 171; Mul 174 69; Sub 1 0; Mul 168 3; Mul 168 1; Add 1 0;
  Mul 87 173; Add 1 0; Sub 14 0;
  ShowZero 0; (* i-circular *)
  Mul 205 193; Mul 205 193; Sub 1 0; Mul 208 195; Mul 208 197; Add 1 0; Mul 205 213; Mul 205 213;
  Sub 1 0; Mul 208 215; Mul 208 217; Add 1 0; Mul 9 0; Mul 7 4; Sub 1 0; Mul 195 183; Mul 195 183;
  Sub 1 0; Mul 198 185; Mul 198 187; Add 1 0; Mul 195 203; Mul 195 203; Sub 1 0; Mul 198 205;
  Mul 198 207; Add 1 0; Mul 9 0; Mul 7 4; Sub 1 0; Sub 15 0;
  ShowZero 0; (* i-conical *)
  Sub 295 294; Mul 298 297; Mul 298 299; Add 1 0; Sub 286 288; Sub 286 288; Mul 298 1; Mul 165 1;
  Sub 1 0; Mul 301 3; Mul 168 5; Add 1 0; Sub 298 294; Sub 298 294; Mul 306 1; Mul 173 1; Sub 1 0;
  Mul 309 3; Mul 176 5; Add 1 0; Sub 300 306; Sub 300 306; Mul 13 1; Mul 11 1; Sub 1 0;
  Sub 309 305; Sub 309 305; Mul 10 1; Mul 8 1; Sub 1 0; Sub 5 0; Mul 22 9; Mul 20 11; Add 1 0;
  Mul 17 7; Mul 15 9; Add 1 0; Sub 3 0; Mul 37 7; Mul 35 1; Sub 1 0; Sub 289 297; Sub 289 297;
  Mul 335 1; Mul 202 1; Sub 1 0; Mul 338 3; Mul 205 5; Add 1 0; Sub 313 297; Sub 313 297;
  Mul 343 1; Mul 210 1; Sub 1 0; Mul 346 3; Mul 213 5; Add 1 0; Sub 297 321; Sub 297 321;
  Mul 13 1; Mul 11 1; Sub 1 0; Sub 318 302; Sub 318 302; Mul 10 1; Mul 8 1; Sub 1 0; Sub 5 0;
  Sub 0 27;
  ShowZero 0; (* i-isothermic of circular type *)
  Mul 65 38; Mul 69 32; Add 1 0; Mul 26 13; Mul 24 15; Add 1 0; Mul 21 11; Mul 19 13; Add 1 0;
  Sub 3 0; Sub 0 7;
  ShowZero 0 (* i-isothermic of circular type *)
].

Theorem part_4_size_2_valid : valid part_4_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** residuals on circles and on pairs; size 1.
    Code: src/net/i_isothermic.rs, src/pair/area.rs, src/scalar/ring.rs, src/space/action.rs,
    src/space/motion.rs, src/space/point.rs *)
Definition part_5_size_1 : list step := [
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0; Constant 1; Sub 1 0;
  Zero 0; (* c² + s² = 1 *)
  ShowZero 0; (* as a test finds *)
  Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Unknown 8; Unknown 9;
  Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15; Mul 20 11; Mul 20 11;
  Sub 1 0; Mul 22 14; Mul 24 14; Add 1 0; Add 3 19; Add 1 19; Mul 28 17; Mul 28 17; Sub 1 0;
  Mul 30 20; Mul 32 20; Add 1 0; Add 3 27; Add 1 27; Mul 36 23; Mul 36 23; Sub 1 0; Mul 38 26;
  Mul 40 26; Add 1 0; Add 3 35; Add 1 35; Mul 44 29; Mul 44 29; Sub 1 0; Mul 46 32; Mul 48 32;
  Add 1 0; Add 3 43; Add 1 43; Sub 17 25; Sub 17 25; Mul 1 1; Mul 1 1; Add 1 0; Mul 39 39;
  Mul 41 41; Sub 1 0; Sub 3 0; Sub 18 34; Sub 18 34; Mul 1 1; Mul 1 1; Add 1 0; Mul 47 47;
  Sub 0 8; Sub 2 0; Sub 18 42; Sub 18 42; Mul 1 1; Mul 1 1; Add 1 0; Mul 54 54; Sub 0 16; Sub 2 0;
  Mul 14 0; Mul 9 7; Sub 1 0; Mul 11 10; Mul 19 4; Sub 1 0; Mul 21 12; Mul 21 14; Sub 1 0;
  Mul 33 6; Mul 33 4; Add 1 0; Mul 28 3; Add 1 0; Sub 80 82; Sub 80 82; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 0 36; Sub 84 88; Sub 84 88; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 34; Sub 88 94; Sub 88 94;
  Mul 1 1; Mul 1 1; Add 1 0; Sub 0 32; Mul 10 0; Mul 7 5; Sub 1 0; Mul 9 8; Mul 15 4; Sub 1 0;
  Mul 17 10; Mul 17 12; Sub 1 0; Mul 26 6; Mul 26 4; Add 1 0; Mul 24 3; Add 1 0; Sub 32 0;
  ShowZero 0; (* coplanar poles *)
  Sub 97 89; Sub 97 89; Mul 1 1; Mul 1 1; Add 1 0; Add 112 111; Mul 0 0; Sub 2 0; Sub 123 121;
  Sub 123 121; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 6; Sub 6 0;
  ShowZero 0; (* touching circles *)
  Unknown 16; Unknown 17; Unknown 18; Unknown 19; Unknown 20; Unknown 21; Unknown 22; Unknown 23;
  Unknown 24; Unknown 25; Unknown 26; Unknown 27; Unknown 28; Unknown 29; Unknown 30; Unknown 31;
  Unknown 32; Unknown 33; Mul 17 14; Mul 17 14; Add 1 0; Add 0 18; Mul 161 18; Mul 161 18;
  Sub 1 0; Mul 163 21; Mul 165 21; Add 1 0; Add 3 160; Add 1 160; Add 8 24; Mul 30 24; Mul 30 24;
  Add 1 0; Add 0 31; Mul 174 28; Mul 174 28; Sub 1 0; Mul 176 31; Mul 178 31; Add 1 0; Add 3 173;
  Add 1 173; Add 8 34; Mul 43 34; Mul 43 34; Add 1 0; Add 0 44; Mul 187 38; Mul 187 38; Sub 1 0;
  Mul 189 41; Mul 191 41; Add 1 0; Add 3 186; Add 1 186; Add 8 44; Mul 56 44; Mul 56 44; Add 1 0;
  Add 0 57; Mul 200 48; Mul 200 48; Sub 1 0; Mul 202 51; Mul 204 51; Add 1 0; Add 3 199;
  Add 1 199; Add 8 54; Mul 69 54; Mul 69 54; Add 1 0; Add 0 70; Mul 213 58; Mul 213 58; Sub 1 0;
  Mul 215 61; Mul 217 61; Add 1 0; Add 3 212; Add 1 212; Add 8 64; Sub 41 54; Sub 41 54;
  Sub 41 54; Sub 31 57; Sub 31 57; Sub 31 57; Sub 8 21; Sub 8 21; Sub 8 21; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0;
  Mul 18 3; Add 1 0; Sub 99 102; Sub 99 102; Sub 99 102; Sub 99 105; Sub 99 105; Sub 99 105;
  Sub 96 99; Sub 96 99; Sub 96 99; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7;
  Mul 11 9; Sub 1 0; Mul 17 6; Mul 17 4; Add 1 0; Mul 18 3; Add 1 0; Sub 23 0;
  ShowZero 0; (* parallel planes *)
  Unknown 34; Unknown 35; Mul 271 1; Mul 271 1; Sub 1 0; Mul 273 4; Mul 275 4; Add 1 0; Add 3 270;
  Add 1 270; Constant 0; Sub 2 73; Sub 2 73; Mul 59 0; Mul 59 2; Sub 1 0; Add 5 0; Mul 57 59;
  Mul 57 61; Sub 1 0; Add 3 0; Sub 20 138; Sub 20 138; Mul 46 0; Mul 46 2; Sub 1 0; Add 15 0;
  Mul 44 46; Mul 44 48; Sub 1 0; Add 3 0; Sub 10 0;
  ShowZero 0 (* mixed areas *)
].

Theorem part_5_size_1_valid : valid part_5_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** concyclic gradients; size 1.
    Code: src/net/i_conical.rs, src/scalar/ring.rs, src/space/action.rs, src/space/gradient.rs,
    src/space/motion.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_6_size_1 : list step := [
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0; Constant 1; Sub 1 0;
  Zero 0; (* c² + s² = 1 *)
  ShowZero 0; (* as a test finds *)
  Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Constant 0; Unknown 7; Unknown 8;
  Unknown 9; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15; Unknown 16;
  Unknown 17; Unknown 18; Mul 11 12; Mul 11 13; Add 1 0; Add 0 12; Mul 15 23; Add 0 3; Add 0 15;
  Mul 17 26; Add 7 0; Add 0 18; Mul 18 22; Mul 18 23; Add 1 0; Add 0 19; Mul 22 33; Add 0 3;
  Add 0 22; Mul 24 36; Add 7 0; Add 0 25; Mul 25 32; Mul 25 33; Add 1 0; Add 0 26; Mul 29 43;
  Add 0 3; Add 0 29; Mul 31 46; Add 7 0; Add 0 32; Mul 32 42; Mul 32 43; Add 1 0; Add 0 33;
  Mul 36 53; Add 0 3; Add 0 36; Mul 38 56; Add 7 0; Add 0 39; Mul 57 52; Mul 57 53; Add 1 0;
  Add 0 56; Mul 68 56; Mul 68 57; Sub 1 0; Add 1 2; Add 1 63; Add 1 63; Add 6 46; Mul 68 70;
  Add 0 10; Add 0 66; Mul 78 73; Sub 0 9; Mul 79 75; Add 0 12; Add 2 73; Add 1 73; Add 6 53;
  Mul 77 80; Add 21 0; Add 0 76; Sub 19 7; Add 19 10; Add 1 81; Add 1 81; Add 4 58; Add 25 55;
  Add 16 53; Add 7 51; Add 28 48; Add 19 46; Add 10 44; Add 31 41; Add 22 39; Add 13 37;
  Sub 97 90; Sub 91 91; Sub 73 76; Sub 71 77; Mul 2 0; Mul 2 4; Sub 1 0; Mul 4 5; Mul 7 4;
  Sub 1 0; Mul 9 9; Mul 9 9; Sub 1 0; Mul 6 0; Mul 4 1; Mul 8 8; Mul 6 6; Add 1 0; Mul 5 5;
  Sub 80 83; Sub 78 84; Mul 19 0; Mul 2 21; Sub 1 0; Mul 4 22; Mul 24 4; Sub 1 0; Mul 3 14;
  Mul 1 15; Mul 5 5; Mul 3 3; Add 1 0; Sub 83 86; Sub 81 87; Mul 32 0; Mul 2 34; Sub 1 0;
  Mul 4 35; Mul 37 4; Sub 1 0; Mul 3 27; Mul 1 28; Mul 5 5; Mul 3 3; Add 1 0; Sub 86 89;
  Sub 84 90; Mul 45 0; Mul 2 47; Sub 1 0; Mul 4 48; Mul 50 4; Sub 1 0; Mul 3 40; Mul 1 41;
  Mul 5 5; Mul 3 3; Add 1 0; Mul 3 13; Mul 1 17; Sub 1 0; Mul 3 20; Mul 8 17; Sub 1 0; Mul 10 22;
  Mul 10 24; Sub 1 0; Mul 39 6; Mul 39 4; Add 1 0; Mul 38 3; Add 1 0; Mul 30 14; Mul 28 18;
  Sub 1 0; Mul 30 21; Mul 35 18; Sub 1 0; Mul 37 23; Mul 37 25; Sub 1 0; Mul 67 6; Mul 67 4;
  Add 1 0; Mul 66 3; Add 1 0; Mul 31 54; Mul 29 58; Sub 1 0; Mul 31 61; Mul 36 58; Sub 1 0;
  Mul 38 63; Mul 38 65; Sub 1 0; Mul 81 6; Mul 81 4; Add 1 0; Mul 80 3; Add 1 0; Mul 71 55;
  Mul 69 59; Sub 1 0; Mul 71 62; Mul 76 59; Sub 1 0; Mul 78 64; Mul 78 66; Sub 1 0; Mul 95 6;
  Mul 95 4; Add 1 0; Mul 94 3; Add 1 0; Mul 95 42; Mul 96 29; Add 1 0; Mul 98 17; Add 1 0;
  Mul 100 5; Add 1 0; Sub 140 150; Sub 140 150; Sub 140 150; Sub 135 153; Sub 135 153;
  Sub 135 153; Mul 4 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0;
  Mul 6 0; Mul 4 1; Mul 8 8; Mul 6 6; Add 1 0; Mul 5 5; Sub 149 150; Sub 149 151; Mul 21 0;
  Mul 2 19; Sub 1 0; Mul 4 22; Mul 26 4; Sub 1 0; Mul 3 14; Mul 1 15; Mul 5 5; Mul 3 3; Add 1 0;
  Sub 159 160; Sub 159 161; Mul 34 0; Mul 2 32; Sub 1 0; Mul 4 35; Mul 39 4; Sub 1 0; Mul 3 27;
  Mul 1 28; Mul 5 5; Mul 3 3; Add 1 0; Sub 169 170; Sub 169 171; Mul 47 0; Mul 2 45; Sub 1 0;
  Mul 4 48; Mul 52 4; Sub 1 0; Mul 3 40; Mul 1 41; Mul 5 5; Mul 3 3; Add 1 0; Mul 3 13; Mul 1 17;
  Sub 1 0; Mul 3 20; Mul 8 17; Sub 1 0; Mul 10 22; Mul 10 24; Sub 1 0; Mul 39 6; Mul 39 4;
  Add 1 0; Mul 38 3; Add 1 0; Mul 30 14; Mul 28 18; Sub 1 0; Mul 30 21; Mul 35 18; Sub 1 0;
  Mul 37 23; Mul 37 25; Sub 1 0; Mul 67 6; Mul 67 4; Add 1 0; Mul 66 3; Add 1 0; Mul 31 54;
  Mul 29 58; Sub 1 0; Mul 31 61; Mul 36 58; Sub 1 0; Mul 38 63; Mul 38 65; Sub 1 0; Mul 81 6;
  Mul 81 4; Add 1 0; Mul 80 3; Add 1 0; Mul 71 55; Mul 69 59; Sub 1 0; Mul 71 62; Mul 76 59;
  Sub 1 0; Mul 78 64; Mul 78 66; Sub 1 0; Mul 95 6; Mul 95 4; Add 1 0; Mul 94 3; Add 1 0;
  Mul 95 42; Mul 96 29; Add 1 0; Mul 98 17; Add 1 0; Mul 100 5; Add 1 0; Sub 0 123;
  ShowZero 0 (* i-conical *)
].

Theorem part_6_size_1_valid : valid part_6_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
