(** remark-2-edge-offset (Sec. 3.4, Remark 2)

    The map τ sends the incircles of an i-isothermic mesh to cones of revolution whose vertices
    form a mesh N with planar faces. The axes of the cones form a mesh parallel to N with edges
    that touch the unit sphere: so edges of N and of its offsets are at constant distance, and the
    edges at a vertex of N lie on a cone about its axis.

        (e·s)² = |e|² (|s|² - 1)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the cones around a vertex; size 3.
    Code: src/space/circle.rs, src/space/gradient.rs, src/space/laguerre/cone.rs,
    src/space/motion.rs, src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the vertex circle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 6 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 7 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 6 0; Add 10 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 8 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 13 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 5 15; Add 15 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 7 17;
  Nonzero 0; (* no edges agree *)
  Unknown 4; Unknown 5; Div 21 3; Sub 20 5; Mul 0 1; Add 13 23; Mul 0 3; Add 6 2; Add 6 1;
  Sub 27 17; Mul 0 7; Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3; Add 33 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Div 36 29; Sub 35 31; Mul 0 1; Add 38 34; Mul 0 3; Add 21 2; Add 21 1; Sub 38 42; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3; Add 48 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Div 51 38; Sub 50 40; Mul 0 1; Add 49 43; Mul 0 3; Add 36 2; Add 36 1; Sub 47 53; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3; Add 63 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Unknown 6; Div 65 63; Sub 66 65; Mul 0 1; Mul 69 71; Mul 0 3; Mul 2 72; Mul 1 73; Add 54 1;
  Add 54 1; Unknown 7; Div 75 61; Sub 76 63; Mul 0 1; Mul 69 81; Mul 0 3; Mul 2 82; Mul 1 83;
  Add 64 1; Add 64 1; Unknown 8; Sub 2 67; Sub 2 67; Sub 2 22; Sub 15 70; Sub 15 70; Sub 15 25;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 94 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 85; Mul 1 85; Add 1 0; Sub 41 0; Mul 8 24; Mul 5 24; Add 1 0; Add 0 3;
  Sub 26 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 87 29; Sub 87 29; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 88;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 45; Mul 16 45; Add 1 0; Add 0 14; Sub 47 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 98 50; Sub 98 50; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 99;
  ShowZero 0; (* the contact is on the incircle *)
  Div 129 121; Sub 130 123; Mul 0 1; Mul 129 135; Mul 0 3; Mul 2 136; Mul 1 137; Add 118 1;
  Add 118 1; Unknown 9; Sub 2 121; Sub 2 121; Sub 2 76; Mul 53 1; Mul 53 3; Sub 1 0; Div 145 0;
  Mul 55 5; Mul 57 5; Sub 1 0; Mul 0 3; Mul 61 8; Mul 60 11; Sub 1 0; Mul 0 7; Mul 4 136;
  Mul 1 136; Add 1 0; Sub 92 0; Mul 8 85; Mul 5 85; Add 1 0; Add 0 3; Sub 87 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 123 90; Sub 123 90; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 124;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 32; Mul 16 32; Add 1 0; Add 0 14; Sub 34 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 134 37; Sub 134 37; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 135;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 40 93; Mul 40 95; Sub 1 0; Div 183 0; Mul 42 97; Mul 44 97; Sub 1 0; Mul 0 3; Mul 48 100;
  Mul 47 103; Sub 1 0; Mul 0 7; Mul 4 174; Mul 1 174; Add 1 0; Sub 130 0; Mul 8 59; Mul 5 59;
  Add 1 0; Add 0 3; Sub 61 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 146 64; Sub 146 64; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 147;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 124; Mul 16 124; Add 1 0; Add 0 14; Sub 126 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 157 129; Sub 157 129; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 158;
  ShowZero 0; (* the contact is on the incircle *)
  Div 218 184; Mul 222 0; Mul 113 0; Neg 0; Mul 0 196; Sub 0 120; Mul 198 4; Sub 225 192; Mul 0 7;
  Div 227 178; Mul 231 0; Mul 71 0; Neg 0; Mul 0 190; Sub 0 78; Mul 192 4; Sub 234 186; Mul 0 7;
  Sub 3 12; Sub 6 15; Neg 238; Mul 14 0; Mul 13 1; Add 1 7; Add 1 6; Mul 6 0; Mul 6 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 24 221; Sub 0 148; Mul 223 28; Mul 18 209; Sub 0 100; Mul 211 22; Sub 1 4; Mul 4 14;
  Add 0 2; Mul 17 0; Mul 3 13; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 16; Mul 22 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 36 25; Mul 35 28; Sub 1 0; Mul 37 12; Mul 16 29; Sub 1 0; Mul 18 33; Mul 43 16; Sub 1 0;
  Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 34 34; Add 1 0; Mul 35 35; Add 1 0;
  Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 32 32; Mul 57 57; Add 1 0; Mul 57 57; Add 1 0; Sub 0 286; Mul 7 0; Mul 33 39; Mul 47 64;
  Add 1 0; Mul 48 64; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 43 43; Mul 62 62; Add 1 0; Mul 62 62; Add 1 0; Sub 0 300; Mul 21 0; Mul 47 50; Mul 61 69;
  Add 1 0; Mul 62 69; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Div 309 245; Mul 313 0; Mul 115 0; Neg 0; Mul 0 257; Sub 0 122; Mul 259 4; Sub 316 253; Mul 0 7;
  Sub 3 85; Sub 6 88; Mul 86 81; Mul 85 82; Add 1 6; Add 1 5; Mul 5 0; Mul 5 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 14 272; Sub 0 140; Mul 274 18; Sub 1 79; Mul 79 92; Add 0 2; Mul 13 0; Mul 3 10; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 13; Mul 18 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 105 21; Mul 104 24; Sub 1 0; Mul 106 12; Mul 91 25; Sub 1 0; Mul 93 29; Mul 112 16; Sub 1 0;
  Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 31 31; Add 1 0; Mul 32 32; Add 1 0;
  Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 1 58; Mul 27 108; Mul 38 127; Add 1 0; Mul 39 127; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 37 37; Mul 52 52; Add 1 0; Mul 52 52; Add 1 0; Sub 0 372; Mul 15 0; Mul 41 44; Mul 52 59;
  Add 1 0; Mul 53 59; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Sub 157 66; Sub 160 69; Mul 67 144; Mul 66 145; Add 1 160; Add 1 159; Mul 5 0; Mul 5 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Sub 142 61; Mul 61 152; Add 0 143; Mul 10 0; Mul 3 7; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 10; Mul 15 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 83 172; Mul 82 175; Sub 1 0; Mul 84 153; Mul 73 176; Sub 1 0; Mul 75 180; Mul 90 157;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 28 28; Add 1 0; Mul 29 29;
  Add 1 0; Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 1 46; Mul 27 90; Mul 35 105; Add 1 0; Mul 36 105; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 9 140; Mul 35 179; Mul 43 204; Add 1 0; Mul 44 204; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 437 437; Mul 418 418; Mul 418 418; Add 1 0; Sub 0 3; Mul 422 192; Mul 422 217; Add 1 0;
  Add 0 378; Mul 447 0; Sub 445 5; Mul 0 224; Add 2 0;
  ShowZero 0; (* 2 v₁ x + 2 v₂ y + (1 - n) z + 2 v₃ = 0 *)
  Mul 430 197; Mul 430 216; Add 1 0; Add 0 386; Mul 455 0; Mul 7 222; Add 1 0;
  ShowZero 0; (* 2 v₁ x + 2 v₂ y + (1 - n) z + 2 v₃ = 0 *)
  Mul 437 126; Mul 437 141; Add 1 0; Add 0 393; Mul 462 0; Mul 14 147; Add 1 0;
  ShowZero 0 (* 2 v₁ x + 2 v₂ y + (1 - n) z + 2 v₃ = 0 *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the cones around a vertex; size 4.
    Code: src/space/circle.rs, src/space/gradient.rs, src/space/laguerre/cone.rs,
    src/space/motion.rs, src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the vertex circle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 6 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 7 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 6 0; Add 10 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 8 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 13 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 4; Mul 6 0; Add 16 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 8 2;
  Nonzero 0; (* no edges agree *)
  Mul 3 3; Add 19 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 5 21; Add 21 0;
  Nonzero 0; (* no edges are opposite *)
  Sub 7 23;
  Nonzero 0; (* no edges agree *)
  Unknown 5; Unknown 6; Div 27 3; Sub 26 5; Mul 0 1; Add 13 29; Mul 0 3; Add 6 2; Add 6 1;
  Sub 33 17; Mul 0 7; Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3; Add 39 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Div 42 35; Sub 41 37; Mul 0 1; Add 44 40; Mul 0 3; Add 21 2; Add 21 1; Sub 44 48; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3; Add 54 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Div 57 44; Sub 56 46; Mul 0 1; Add 55 49; Mul 0 3; Add 36 2; Add 36 1; Sub 53 59; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3; Add 69 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Div 72 53; Sub 71 55; Mul 0 1; Add 64 58; Mul 0 3; Add 51 2; Add 51 1; Sub 62 68; Mul 0 7;
  Mul 0 0; Mul 4 4; Mul 4 4; Add 1 0; Sub 0 3; Add 84 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Unknown 7; Div 86 84; Sub 87 86; Mul 0 1; Mul 90 92; Mul 0 3; Mul 2 93; Mul 1 94; Add 69 1;
  Add 69 1; Unknown 8; Div 96 76; Sub 97 78; Mul 0 1; Mul 84 102; Mul 0 3; Mul 2 103; Mul 1 104;
  Add 79 1; Add 79 1; Unknown 9; Sub 2 82; Sub 2 82; Sub 2 22; Sub 15 85; Sub 15 85; Sub 15 25;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 115 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Mul 4 100; Mul 1 100; Add 1 0; Sub 41 0; Mul 8 24; Mul 5 24; Add 1 0; Add 0 3;
  Sub 26 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 102 29; Sub 102 29; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 103;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 45; Mul 16 45; Add 1 0; Add 0 14; Sub 47 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 113 50; Sub 113 50; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 114;
  ShowZero 0; (* the contact is on the incircle *)
  Div 150 142; Sub 151 144; Mul 0 1; Mul 150 156; Mul 0 3; Mul 2 157; Mul 1 158; Add 133 1;
  Add 133 1; Unknown 10; Sub 2 136; Sub 2 136; Sub 2 76; Mul 53 1; Mul 53 3; Sub 1 0; Div 166 0;
  Mul 55 5; Mul 57 5; Sub 1 0; Mul 0 3; Mul 61 8; Mul 60 11; Sub 1 0; Mul 0 7; Mul 4 151;
  Mul 1 151; Add 1 0; Sub 92 0; Mul 8 85; Mul 5 85; Add 1 0; Add 0 3; Sub 87 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 138 90; Sub 138 90; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 139;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 32; Mul 16 32; Add 1 0; Add 0 14; Sub 34 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 149 37; Sub 149 37; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 150;
  ShowZero 0; (* the contact is on the incircle *)
  Div 201 187; Sub 202 189; Mul 0 1; Mul 195 207; Mul 0 3; Mul 2 208; Mul 1 209; Add 184 1;
  Add 184 1; Unknown 11; Sub 2 187; Sub 2 187; Sub 2 127; Mul 53 1; Mul 53 3; Sub 1 0; Div 217 0;
  Mul 55 5; Mul 57 5; Sub 1 0; Mul 0 3; Mul 61 8; Mul 60 11; Sub 1 0; Mul 0 7; Mul 4 202;
  Mul 1 202; Add 1 0; Sub 143 0; Mul 8 72; Mul 5 72; Add 1 0; Add 0 3; Sub 74 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 174 77; Sub 174 77; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 175;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 32; Mul 16 32; Add 1 0; Add 0 14; Sub 34 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 185 37; Sub 185 37; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 186;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 40 144; Mul 40 146; Sub 1 0; Div 255 0; Mul 42 148; Mul 44 148; Sub 1 0; Mul 0 3;
  Mul 48 151; Mul 47 154; Sub 1 0; Mul 0 7; Mul 4 240; Mul 1 240; Add 1 0; Sub 181 0; Mul 8 59;
  Mul 5 59; Add 1 0; Add 0 3; Sub 61 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 197 64; Sub 197 64; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 198;
  ShowZero 0; (* the contact is on the incircle *)
  Mul 19 175; Mul 16 175; Add 1 0; Add 0 14; Sub 177 0;
  ShowZero 0; (* the contact is in the face *)
  Sub 208 180; Sub 208 180; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 209;
  ShowZero 0; (* the contact is on the incircle *)
  Div 290 250; Mul 294 0; Mul 164 0; Neg 0; Mul 0 262; Sub 0 171; Mul 264 4; Sub 297 258; Mul 0 7;
  Div 299 244; Mul 303 0; Mul 122 0; Neg 0; Mul 0 256; Sub 0 129; Mul 258 4; Sub 306 252; Mul 0 7;
  Sub 3 12; Sub 6 15; Neg 310; Mul 14 0; Mul 13 1; Add 1 7; Add 1 6; Mul 6 0; Mul 6 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 24 287; Sub 0 199; Mul 289 28; Mul 18 275; Sub 0 151; Mul 277 22; Sub 1 4; Mul 4 14;
  Add 0 2; Mul 17 0; Mul 3 13; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 16; Mul 22 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 36 25; Mul 35 28; Sub 1 0; Mul 37 12; Mul 16 29; Sub 1 0; Mul 18 33; Mul 43 16; Sub 1 0;
  Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 34 34; Add 1 0; Mul 35 35; Add 1 0;
  Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 32 32; Mul 57 57; Add 1 0; Mul 57 57; Add 1 0; Sub 0 358; Mul 7 0; Mul 33 39; Mul 47 64;
  Add 1 0; Mul 48 64; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 43 43; Mul 62 62; Add 1 0; Mul 62 62; Add 1 0; Sub 0 372; Mul 21 0; Mul 47 50; Mul 61 69;
  Add 1 0; Mul 62 69; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Div 381 311; Mul 385 0; Mul 153 0; Neg 0; Mul 0 323; Sub 0 160; Mul 325 4; Sub 388 319; Mul 0 7;
  Sub 3 85; Sub 6 88; Mul 86 81; Mul 85 82; Add 1 6; Add 1 5; Mul 5 0; Mul 5 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 14 338; Sub 0 178; Mul 340 18; Sub 1 79; Mul 79 92; Add 0 2; Mul 13 0; Mul 3 10; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 13; Mul 18 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 105 21; Mul 104 24; Sub 1 0; Mul 106 12; Mul 91 25; Sub 1 0; Mul 93 29; Mul 112 16; Sub 1 0;
  Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 31 31; Add 1 0; Mul 32 32; Add 1 0;
  Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 1 58; Mul 27 108; Mul 38 127; Add 1 0; Mul 39 127; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 37 37; Mul 52 52; Add 1 0; Mul 52 52; Add 1 0; Sub 0 444; Mul 15 0; Mul 41 44; Mul 52 59;
  Add 1 0; Mul 53 59; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Div 453 368; Mul 457 0; Mul 187 0; Neg 0; Mul 0 380; Sub 0 194; Mul 382 4; Sub 460 376; Mul 0 7;
  Sub 3 75; Sub 6 78; Mul 76 153; Mul 75 154; Add 1 6; Add 1 5; Mul 5 0; Mul 5 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 14 395; Sub 0 212; Mul 397 18; Sub 1 73; Mul 73 164; Add 0 2; Mul 13 0; Mul 3 10; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 13; Mul 18 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 95 21; Mul 94 24; Sub 1 0; Mul 96 12; Mul 85 25; Sub 1 0; Mul 87 29; Mul 102 16; Sub 1 0;
  Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 31 31; Add 1 0; Mul 32 32; Add 1 0;
  Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 1 58; Mul 27 102; Mul 38 117; Add 1 0; Mul 39 117; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 37 37; Mul 52 52; Add 1 0; Mul 52 52; Add 1 0; Sub 0 516; Mul 15 0; Mul 41 44; Mul 52 59;
  Add 1 0; Mul 53 59; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Sub 229 66; Sub 232 69; Mul 67 216; Mul 66 217; Add 1 232; Add 1 231; Mul 5 0; Mul 5 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Sub 214 61; Mul 61 224; Add 0 215; Mul 10 0; Mul 3 7; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 10; Mul 15 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 83 244; Mul 82 247; Sub 1 0; Mul 84 225; Mul 73 248; Sub 1 0; Mul 75 252; Mul 90 229;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 28 28; Add 1 0; Mul 29 29;
  Add 1 0; Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 1 46; Mul 27 90; Mul 35 105; Add 1 0; Mul 36 105; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 9 212; Mul 35 251; Mul 43 276; Add 1 0; Mul 44 276; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 581 581; Mul 556 556; Mul 556 556; Add 1 0; Sub 0 3; Mul 560 264; Mul 560 289; Add 1 0;
  Add 0 501; Mul 591 0; Sub 589 5; Mul 0 296; Add 2 0;
  ShowZero 0; (* 2 v₁ x + 2 v₂ y + (1 - n) z + 2 v₃ = 0 *)
  Mul 568 269; Mul 568 288; Add 1 0; Add 0 509; Mul 599 0; Mul 7 294; Add 1 0;
  ShowZero 0; (* 2 v₁ x + 2 v₂ y + (1 - n) z + 2 v₃ = 0 *)
  Mul 575 198; Mul 575 213; Add 1 0; Add 0 516; Mul 606 0; Mul 14 219; Add 1 0;
  ShowZero 0; (* 2 v₁ x + 2 v₂ y + (1 - n) z + 2 v₃ = 0 *)
  Mul 582 133; Mul 582 148; Add 1 0; Add 0 523; Mul 613 0; Mul 21 154; Add 1 0;
  ShowZero 0 (* 2 v₁ x + 2 v₂ y + (1 - n) z + 2 v₃ = 0 *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a patch over an inverted packing; size 1.
    Code: src/construct/koebe.rs, src/construct/packing.rs, src/construct/transfer/euclidean.rs,
    src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs, src/space/laguerre/cone.rs,
    src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 0; Constant 1; Div 0 4; Mul 0 0; Sub 3 5; Sub 4 5; Mul 1 1;
  Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no circle passes through the centre *)
  Sub 8 10; Mul 0 0; Add 5 0; Sub 0 9;
  Nonzero 0; (* no circle passes through the centre *)
  Sub 16 14; Mul 0 0; Add 9 0; Sub 0 13;
  Nonzero 0; (* no circle passes through the centre *)
  Sub 16 19; Mul 0 0; Add 0 12; Sub 0 17;
  Nonzero 0; (* no circle passes through the centre *)
  Add 2 10; Sub 0 19;
  Nonzero 0; (* no circle passes through the centre *)
  Add 4 8; Sub 0 21;
  Nonzero 0; (* no circle passes through the centre *)
  Sub 28 27; Mul 0 0; Add 0 20; Sub 0 25;
  Nonzero 0; (* no circle passes through the centre *)
  Add 2 18; Sub 0 27;
  Nonzero 0; (* no circle passes through the centre *)
  Add 4 16; Sub 0 29;
  Nonzero 0; (* no circle passes through the centre *)
  Div 32 24; Mul 30 0; Mul 30 1; Add 38 1; Add 38 1; Div 37 25; Mul 35 0; Mul 30 1; Add 43 1;
  Add 43 1; Div 42 22; Mul 26 0; Mul 40 1; Add 48 1; Add 48 1; Sub 6 11; Sub 6 11; Sub 3 13;
  Sub 3 13; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Div 54 38; Mul 52 0; Mul 43 1; Add 60 1; Add 60 1; Div 59 37; Mul 43 0; Mul 52 1; Add 65 1;
  Add 65 1; Sub 6 23; Sub 6 23; Sub 3 25; Sub 3 25; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Div 71 43; Mul 47 0; Mul 69 1; Add 77 1; Add 77 1; Sub 13 30; Sub 13 30; Sub 3 32; Sub 3 32;
  Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Div 83 59; Mul 67 0; Mul 72 1; Add 89 1; Add 89 1; Div 88 58; Mul 64 0; Mul 81 1; Add 94 1;
  Add 94 1; Sub 6 30; Sub 6 30; Sub 3 32; Sub 3 32; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Sub 99 103; Sub 100 103; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 103; Div 106 0; Mul 6 0; Mul 6 1;
  Add 112 1; Add 112 1; Mul 110 4; Mul 0 0; Mul 3 3; Mul 3 3; Add 1 0; Sub 0 3; Add 117 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Constant 3; Div 0 123; Sub 0 122; Mul 0 0; Add 19 0; Sub 0 121; Div 124 0; Mul 24 0; Mul 5 1;
  Add 130 1; Add 130 1; Mul 128 4; Mul 0 0; Mul 3 3; Mul 3 3; Add 1 0; Sub 0 3; Add 135 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Sub 16 139; Mul 0 0; Add 0 34; Sub 0 137; Div 140 0; Mul 4 0; Mul 40 1; Add 146 1; Add 146 1;
  Mul 144 4; Mul 0 0; Mul 3 3; Mul 3 3; Add 1 0; Sub 0 3; Add 151 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Add 14 30; Sub 0 151; Div 154 0; Mul 18 0; Mul 35 1; Add 160 1; Add 160 1; Mul 158 4; Mul 0 0;
  Mul 3 3; Mul 3 3; Add 1 0; Sub 0 3; Add 165 0;
  Nonzero 0; (* no incircle is the image of a great circle *)
  Mul 165 133; Mul 166 124; Sub 132 122; Sub 132 122; Mul 1 1; Mul 1 1; Add 1 0; Add 6 5; Mul 0 0;
  Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Mul 175 116; Sub 131 114; Sub 131 114; Mul 1 1; Mul 1 1; Add 1 0; Add 14 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Mul 184 147; Mul 119 119; Mul 119 119; Add 1 0; Add 12 3; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Mul 144 144; Mul 144 144; Add 1 0; Add 9 28; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Mul 197 114; Sub 136 112; Sub 136 112; Mul 1 1; Mul 1 1; Add 1 0; Add 27 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Mul 206 152; Sub 121 150; Sub 121 150; Mul 1 1; Mul 1 1; Add 1 0; Add 14 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Mul 151 151; Mul 151 151; Add 1 0; Add 11 33; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Mul 221 150; Sub 177 148; Sub 177 148; Mul 1 1; Mul 1 1; Add 1 0; Add 60 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Mul 230 142; Sub 157 140; Sub 157 140; Mul 1 1; Mul 1 1; Add 1 0; Add 14 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Mul 144 144; Mul 144 144; Add 1 0; Add 11 66; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Div 246 214; Mul 222 0; Mul 235 1; Add 252 1; Add 252 1; Mul 250 4; Sub 160 2; Sub 160 2;
  Mul 1 1; Mul 1 1; Add 1 0; Add 25 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Sub 10 173; Sub 10 173; Mul 1 1; Mul 1 1; Add 1 0; Add 13 66; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Sub 269 269; Div 269 215; Mul 1 219; Mul 222 2; Sub 1 0; Mul 0 3; Mul 226 5; Mul 6 225; Sub 1 0;
  Mul 0 7; Mul 4 242; Mul 1 242; Add 1 0; Sub 282 0; Mul 8 219; Mul 5 219; Add 1 0; Add 0 3;
  Sub 223 250; Sub 223 250; Sub 2 289; Mul 239 1; Mul 239 3; Sub 1 0; Div 292 0; Mul 24 5;
  Mul 243 5; Sub 1 0; Mul 0 3; Mul 247 8; Mul 29 11; Sub 1 0; Mul 0 7; Mul 4 265; Mul 1 265;
  Add 1 0; Sub 305 0; Add 1 0; Sub 307 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 261; Mul 7 261; Add 1 0; Add 0 5; Sub 312 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 249; Mul 12 249; Add 1 0; Add 0 10; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 276; Mul 17 276; Add 1 0; Add 0 15; Sub 322 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 286 286; Mul 286 286; Add 1 0; Mul 158 158; Sub 1 0; Mul 0 326; Mul 282 282; Mul 282 282;
  Add 1 0; Mul 163 163; Sub 1 0; Mul 0 332; Mul 271 271; Mul 271 271; Add 1 0; Mul 160 160;
  Sub 1 0; Mul 0 338; Sub 6 12; Sub 1 13; Mul 1 54; Mul 292 1; Sub 1 0; Mul 0 52; Mul 296 4;
  Mul 6 60; Sub 1 0; Mul 0 56; Mul 4 314; Mul 1 314; Add 1 0; Sub 25 0; Add 1 0; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 310; Mul 7 310; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 298; Mul 12 298; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 325 325; Mul 325 325; Add 1 0; Mul 183 183; Sub 1 0; Mul 0 370; Mul 26 331; Mul 23 331;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Unknown 2; Sub 0 379; Div 379 308; Mul 1 312; Mul 315 92; Sub 1 0; Mul 0 3; Mul 319 95;
  Mul 6 318; Sub 1 0; Mul 0 7; Mul 4 347; Mul 1 347; Add 1 0; Sub 392 0; Mul 8 305; Mul 5 305;
  Add 1 0; Add 0 3; Sub 309 355; Sub 309 355; Sub 2 399; Mul 332 1; Mul 332 3; Sub 1 0; Div 402 0;
  Mul 114 5; Mul 336 5; Sub 1 0; Mul 0 3; Mul 340 8; Mul 119 11; Sub 1 0; Mul 0 7; Mul 4 370;
  Mul 1 370; Add 1 0; Sub 415 0; Add 1 0; Sub 417 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 354; Mul 7 354; Add 1 0; Add 0 5; Sub 135 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 335; Mul 12 335; Add 1 0; Add 0 10; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 369; Mul 17 369; Add 1 0; Add 0 15; Sub 53 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 345 345; Mul 345 345; Add 1 0; Mul 236 236; Sub 1 0; Mul 0 436; Sub 98 66; Sub 1 67;
  Mul 1 42; Mul 373 1; Sub 1 0; Mul 0 40; Mul 377 4; Mul 6 48; Sub 1 0; Mul 0 44; Mul 4 407;
  Mul 1 407; Add 1 0; Sub 79 0; Add 1 0; Sub 81 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 391; Mul 7 391; Add 1 0; Add 0 5; Sub 118 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 372; Mul 12 372; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 406 406; Mul 406 406; Add 1 0; Mul 259 259; Sub 1 0; Mul 0 468; Mul 26 412; Mul 23 412;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Unknown 3; Sub 0 477; Div 477 394; Mul 189 398; Mul 401 2; Sub 1 0; Mul 0 3; Mul 405 5;
  Mul 194 404; Sub 1 0; Mul 0 7; Mul 4 440; Mul 1 440; Add 1 0; Sub 490 0; Mul 8 398; Mul 5 398;
  Add 1 0; Add 0 3; Sub 402 448; Sub 402 448; Sub 2 497; Mul 418 1; Mul 418 3; Sub 1 0; Div 500 0;
  Mul 24 5; Mul 422 5; Sub 1 0; Mul 0 3; Mul 426 8; Mul 29 11; Sub 1 0; Mul 0 7; Mul 4 463;
  Mul 1 463; Add 1 0; Sub 513 0; Add 1 0; Sub 515 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 440; Mul 7 440; Add 1 0; Add 0 5; Sub 43 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 428; Mul 12 428; Add 1 0; Add 0 10; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 462; Mul 17 462; Add 1 0; Add 0 15; Sub 243 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 455 455; Mul 455 455; Add 1 0; Mul 310 310; Sub 1 0; Mul 0 534; Mul 444 444; Mul 444 444;
  Add 1 0; Mul 307 307; Sub 1 0; Mul 0 540; Sub 6 208; Sub 1 209; Mul 1 48; Mul 465 1; Sub 1 0;
  Mul 0 46; Mul 469 4; Mul 6 54; Sub 1 0; Mul 0 50; Mul 4 506; Mul 1 506; Add 1 0; Sub 221 0;
  Add 1 0; Sub 223 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 483; Mul 7 483; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 471; Mul 12 471; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 505; Mul 17 505; Add 1 0; Add 0 15; Sub 232 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 177 287; Sub 80 288; Div 575 475; Mul 2 479; Mul 482 2; Sub 1 0; Mul 0 3; Mul 486 5;
  Mul 7 485; Sub 1 0; Mul 0 7; Mul 4 521; Mul 1 521; Add 1 0; Sub 301 0; Mul 8 338; Mul 5 338;
  Add 1 0; Add 0 3; Sub 342 529; Sub 342 529; Sub 2 308; Mul 499 1; Mul 499 3; Sub 1 0; Div 598 0;
  Mul 24 5; Mul 503 5; Sub 1 0; Mul 0 3; Mul 507 8; Mul 29 11; Sub 1 0; Mul 0 7; Mul 4 544;
  Mul 1 544; Add 1 0; Sub 324 0; Add 1 0; Sub 326 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 521; Mul 7 521; Add 1 0; Add 0 5; Sub 123 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 368; Mul 12 368; Add 1 0; Add 0 10; Sub 30 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 536; Mul 17 536; Add 1 0; Add 0 15; Sub 231 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 378 378; Mul 378 378; Add 1 0; Mul 379 379; Sub 1 0; Mul 0 632; Sub 92 294; Sub 1 295;
  Mul 1 42; Mul 540 1; Sub 1 0; Mul 0 40; Mul 544 4; Mul 6 48; Sub 1 0; Mul 0 44; Mul 4 581;
  Mul 1 581; Add 1 0; Sub 307 0; Add 1 0; Sub 309 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 558; Mul 7 558; Add 1 0; Add 0 5; Sub 112 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 405; Mul 12 405; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 573; Mul 17 573; Add 1 0; Add 0 15; Sub 226 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 319 319; Mul 316 316; Add 1 0; Mul 314 672; Add 1 0; Sub 2 0; Add 671 0; Div 672 0;
  Mul 677 0; Mul 369 0; Neg 0; Mul 0 326; Sub 0 376; Mul 328 4; Sub 679 8; Mul 0 7; Mul 133 133;
  Mul 130 130; Add 1 0; Mul 128 688; Add 1 0; Sub 2 0; Add 687 0; Div 688 0; Mul 693 0; Mul 177 0;
  Neg 0; Mul 0 140; Sub 0 184; Mul 142 4; Sub 695 8; Mul 0 7; Sub 3 19; Sub 6 22; Neg 699;
  Mul 21 0; Mul 20 1; Add 1 7; Add 1 6; Mul 6 0; Mul 6 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 31 361; Sub 0 411; Mul 363 35; Mul 18 162; Sub 0 206; Mul 164 22; Sub 1 4; Mul 4 14;
  Add 0 2; Mul 17 0; Mul 3 13; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 16; Mul 22 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 43 25; Mul 42 28; Sub 1 0; Mul 44 12; Mul 16 29; Sub 1 0; Mul 18 33; Mul 50 16; Sub 1 0;
  Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 34 34; Add 1 0; Mul 35 35; Add 1 0;
  Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 32 32; Mul 64 64; Add 1 0; Mul 64 64; Add 1 0; Sub 0 747; Mul 7 0; Mul 33 39; Mul 47 71;
  Add 1 0; Mul 48 71; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 43 43; Mul 62 62; Add 1 0; Mul 62 62; Add 1 0; Sub 0 761; Mul 21 0; Mul 47 50; Mul 61 69;
  Add 1 0; Mul 62 69; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 130 130; Mul 127 127; Add 1 0; Mul 125 777; Add 1 0; Sub 2 0; Add 776 0; Div 777 0;
  Mul 782 0; Mul 168 0; Neg 0; Mul 0 137; Sub 0 175; Mul 139 4; Sub 784 8; Mul 0 7; Sub 3 92;
  Sub 6 95; Mul 93 88; Mul 92 89; Add 1 6; Add 1 5; Mul 5 0; Mul 5 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 14 155; Sub 0 193; Mul 157 18; Sub 1 86; Mul 86 99; Add 0 2; Mul 13 0; Mul 3 10; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 13; Mul 18 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 112 21; Mul 111 24; Sub 1 0; Mul 113 12; Mul 98 25; Sub 1 0; Mul 100 29; Mul 119 16;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 31 31; Add 1 0; Mul 32 32;
  Add 1 0; Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 1 65; Mul 27 115; Mul 38 134; Add 1 0; Mul 39 134; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 37 37; Mul 52 52; Add 1 0; Mul 52 52; Add 1 0; Sub 0 840; Mul 15 0; Mul 41 44; Mul 52 59;
  Add 1 0; Mul 53 59; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 405 405; Mul 402 402; Add 1 0; Mul 400 856; Add 1 0; Sub 2 0; Add 855 0; Div 856 0;
  Mul 861 0; Mul 443 0; Neg 0; Mul 0 412; Sub 0 450; Mul 414 4; Sub 863 8; Mul 0 7; Sub 3 82;
  Sub 6 85; Mul 83 167; Mul 82 168; Add 1 6; Add 1 5; Mul 5 0; Mul 5 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 14 430; Sub 0 468; Mul 432 18; Sub 1 80; Mul 80 178; Add 0 2; Mul 13 0; Mul 3 10; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 13; Mul 18 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 102 21; Mul 101 24; Sub 1 0; Mul 103 12; Mul 92 25; Sub 1 0; Mul 94 29; Mul 109 16; Sub 1 0;
  Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 31 31; Add 1 0; Mul 32 32; Add 1 0;
  Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 1 65; Mul 27 109; Mul 38 124; Add 1 0; Mul 39 124; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 37 37; Mul 52 52; Add 1 0; Mul 52 52; Add 1 0; Sub 0 919; Mul 15 0; Mul 41 44; Mul 52 59;
  Add 1 0; Mul 53 59; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Sub 250 66; Sub 253 69; Mul 67 230; Mul 66 231; Add 1 253; Add 1 252; Mul 5 0; Mul 5 2; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Sub 228 61; Mul 61 238; Add 0 229; Mul 10 0; Mul 3 7; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 5 10; Mul 15 4; Sub 1 0;
  ShowZero 0; (* the axes are parallel to N *)
  Mul 83 265; Mul 82 268; Sub 1 0; Mul 84 239; Mul 73 269; Sub 1 0; Mul 75 273; Mul 90 243;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 20 20; Mul 28 28; Add 1 0; Mul 29 29;
  Add 1 0; Sub 5 0;
  ShowZero 0; (* their edge touches the unit sphere *)
  Mul 1 46; Mul 27 90; Mul 35 105; Add 1 0; Mul 36 105; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Mul 9 226; Mul 35 265; Mul 43 297; Add 1 0; Mul 44 297; Add 1 0; Mul 0 0; Sub 0 6;
  ShowZero 0; (* the edge is on a cone about the axis *)
  Sub 185 273; Sub 200 305; Sub 203 308; Sub 109 276; Sub 124 308; Sub 127 311; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 283 6; Mul 300 4; Add 1 0;
  Mul 301 3; Add 1 0;
  ShowZero 0 (* a planar face *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
