(** thm-3 (Sec. 3.4, Theorem 3)

    An edge of a planar mesh touches Σ iff its top view touches the circle over which the face
    plane cuts Σ: the faces of the top view of a midscribed mesh have incircles. Those of two faces
    touch their edge at one point; the contacts around a vertex lie on a circle orthogonal to the
    incircles. Conversely such circles lift to a midscribed mesh, their radii at a quad satisfy
    Schramm's equation, and a mesh with its top view is i-isothermic.

        ρ² (r₁ + r₂ + r₃ + r₄) = r₁ r₂ r₃ + r₂ r₃ r₄ + r₃ r₄ r₁ + r₄ r₁ r₂

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** edges, faces and vertices; size 1.
    Code: src/net/scribed.rs, src/space/circle.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs, src/space/sphere.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7; Sub 2 4;
  Sub 2 4; Mul 9 6; Mul 9 6; Add 1 0; Add 0 10; Mul 13 8; Mul 13 8; Add 1 0; Add 0 14; Neg 8;
  Mul 0 11; Mul 11 12; Add 20 1; Add 20 1; Mul 1 19; Mul 1 19; Add 1 0; Sub 12 0; Mul 5 21;
  Mul 5 21; Add 1 0; Add 0 3; Sub 13 0;
  ShowZero 0; (* the second face has the edge, too *)
  Constant 1; Sub 15 19; Mul 30 25; Mul 30 25; Add 1 0; Mul 3 4; Sub 1 0; Mul 25 6; Mul 36 36;
  Mul 36 36; Add 1 0; Sub 0 3; Sub 0 4; Mul 6 6; Mul 37 37; Mul 37 37; Add 1 0; Mul 0 4; Sub 4 0;
  Constant 0; Div 19 19; Sub 52 1; Sub 52 2; Mul 1 2; Mul 1 3; Sub 54 5; Constant 2; Mul 1 0;
  Sub 8 59; Sub 9 59; Mul 1 1; Mul 1 1; Add 1 0; Mul 32 5; Add 1 0; Mul 14 14; Mul 1 0; Sub 13 65;
  Sub 13 65; Mul 62 0; Mul 62 2; Sub 1 0; Mul 5 25; Mul 1 1; Sub 1 0; Sub 0 26;
  ShowZero 0; (* the top view touches the incircle *)
  Mul 8 8; Mul 8 8; Add 1 0; Sub 0 12; Add 42 42; Sub 0 40; Neg 0; Sub 3 0;
  ShowZero 0; (* the circle of the contacts at a vertex *)
  Sub 30 80; Sub 30 80; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 22; Mul 74 59; Add 0 0; Mul 88 88;
  Mul 88 88; Add 1 0; Sub 3 0; Neg 0; Sub 7 0;
  ShowZero 0; (* the circle of the contacts at a vertex *)
  Sub 78 48; Sub 78 49; Mul 1 49; Mul 1 50; Sub 77 52; Mul 0 46; Sub 54 84; Sub 55 84; Mul 1 1;
  Mul 1 1; Add 1 0; Mul 78 5; Add 1 0; Mul 0 45; Sub 11 110; Sub 11 110; Mul 107 0; Mul 107 2;
  Sub 1 0; Mul 5 70; Mul 1 1; Sub 1 0; Sub 0 71;
  ShowZero 0; (* the top view touches the incircle *)
  Mul 8 8; Mul 8 8; Add 1 0; Sub 0 12; Sub 0 42;
  ShowZero 0; (* the circle of the contacts at a vertex *)
  Sub 25 122; Sub 25 122; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 19; Sub 0 35;
  ShowZero 0; (* the circle of the contacts at a vertex *)
  Sub 32 79; Sub 32 79; Mul 1 128; Mul 1 128; Add 1 0;
  ShowZero 0 (* one contact for both faces *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k contacts; size 3.
    Code: src/construct/koebe.rs, src/net/i_isothermic.rs, src/net/scribed.rs, src/scalar/ring.rs,
    src/space/circle.rs, src/space/motion.rs, src/space/oriented_circle.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the incircle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* consecutive tangents meet *)
  Mul 2 2; Add 6 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 5 0; Add 9 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 7 11;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 12 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 5 14; Add 14 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 7 16;
  Nonzero 0; (* different contacts *)
  Sub 8 13;
  Nonzero 0; (* different contacts *)
  Unknown 4; Unknown 5; Div 21 4; Sub 20 6; Mul 0 1; Add 14 23; Mul 0 3; Add 6 2; Add 6 1;
  Sub 27 18; Mul 0 7; Div 30 23; Sub 29 25; Mul 0 1; Add 32 28; Mul 0 3; Add 15 2; Add 15 1;
  Mul 24 6; Div 38 26; Sub 37 28; Mul 0 1; Add 36 31; Mul 0 3; Add 23 2; Add 23 1; Mul 26 6;
  Mul 19 19; Mul 19 19; Add 1 0; Mul 19 19; Sub 1 0; Div 49 52; Mul 1 0; Mul 17 17; Mul 17 17;
  Add 1 0; Mul 18 18; Sub 1 0; Mul 0 6; Mul 15 15; Mul 15 15; Add 1 0; Mul 16 16; Sub 1 0;
  Mul 0 12; Sub 29 38; Sub 29 38; Sub 8 14; Sub 24 41; Sub 24 41; Sub 5 17; Mul 5 1; Mul 5 3;
  Sub 1 0; Div 72 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Sub 0 59;
  ShowZero 0; (* centre of the incircle *)
  Mul 14 9; Mul 13 12; Sub 1 0; Mul 0 8; Sub 0 63;
  ShowZero 0; (* centre of the incircle *)
  Add 55 47; Sub 7 59; Sub 3 59; Mul 22 0; Mul 22 2; Sub 1 0; Div 0 5; Sub 0 92;
  ShowZero 0; (* radius of the incircle *)
  Sub 66 57; Sub 66 57; Mul 1 1; Mul 1 1; Add 1 0; Mul 12 12; Sub 1 0;
  ShowZero 0; (* the circles of an edge touch *)
  Mul 73 34; Mul 73 34; Add 1 0; Mul 35 101; Sub 1 0; Mul 52 103; Sub 57 0; Sub 0 1; Mul 3 3;
  Mul 43 43; Mul 43 43; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 87 94; Sub 87 94; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 69; Mul 120 120; Sub 1 0;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 120 118; Sub 121 120; Mul 0 1; Mul 0 125; Add 106 0; Div 97 41; Mul 62 0; Add 102 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 130 132; Mul 0 9; Mul 0 133; Add 113 0; Mul 68 7; Add 108 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 102 94; Sub 102 94; Mul 1 1; Mul 1 1; Add 1 0; Add 105 97; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 102 110; Sub 102 110; Sub 83 89; Mul 113 2; Mul 113 2; Add 1 0; Mul 3 150; Sub 1 0;
  Mul 95 152; Sub 99 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 127 143; Sub 127 143; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 111; Sub 0 48;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 168 161; Sub 169 163; Mul 0 1; Mul 0 173; Add 154 0; Div 137 31; Mul 29 0; Add 141 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 174 180; Mul 0 9; Mul 0 181; Add 161 0; Mul 35 7; Add 147 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Mul 117 117; Mul 117 117; Add 1 0; Add 143 159; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 165 148; Sub 165 148; Sub 141 129; Mul 151 2; Mul 151 2; Add 1 0; Mul 3 196; Sub 1 0;
  Mul 135 198; Sub 139 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 165 189; Sub 165 189; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 151; Sub 0 94;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 214 201; Sub 215 203; Mul 0 1; Mul 0 219; Add 200 0; Div 175 31; Mul 29 0; Add 179 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 215 226; Mul 0 9; Mul 0 227; Add 207 0; Mul 35 7; Add 185 0; Sub 0 2;
  ShowZero 0 (* the contact *)
].

Theorem part_2_size_3_valid : valid part_2_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k contacts; size 4.
    Code: src/construct/koebe.rs, src/net/i_isothermic.rs, src/net/scribed.rs, src/scalar/ring.rs,
    src/space/circle.rs, src/space/gradient.rs, src/space/motion.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the incircle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* consecutive tangents meet *)
  Mul 2 2; Add 6 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 5 0; Add 9 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 7 11;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 12 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 4; Mul 6 0; Add 15 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 17;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 18 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 5 20; Add 20 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 7 18;
  Nonzero 0; (* different contacts *)
  Unknown 5; Unknown 6; Div 26 3; Sub 25 5; Mul 0 1; Add 13 28; Mul 0 3; Add 6 2; Add 6 1;
  Sub 32 17; Mul 0 7; Div 35 28; Sub 34 30; Mul 0 1; Add 37 33; Mul 0 3; Add 15 2; Add 15 1;
  Mul 29 6; Div 43 31; Sub 42 33; Mul 0 1; Add 41 36; Mul 0 3; Add 23 2; Add 23 1; Sub 40 45;
  Mul 0 7; Mul 20 20; Mul 20 20; Add 1 0; Mul 20 20; Sub 1 0; Div 55 58; Mul 1 0; Mul 18 18;
  Mul 18 18; Add 1 0; Mul 19 19; Sub 1 0; Mul 0 6; Mul 16 16; Mul 16 16; Add 1 0; Mul 16 16;
  Sub 1 0; Mul 0 12; Sub 30 39; Sub 30 39; Sub 8 14; Sub 25 42; Sub 25 42; Sub 5 17; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 78 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 57; Mul 1 57; Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 54; Mul 7 54; Add 1 0; Add 0 5; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 51; Mul 12 51; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 105 87; Sub 104 89; Mul 0 1; Add 98 92; Mul 0 3; Add 85 2; Add 85 1; Sub 96 102; Mul 0 7;
  Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 61; Mul 35 9; Mul 32 9; Add 1 0; Add 0 30;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 40 100;
  ShowZero 0; (* centre of the incircle *)
  Sub 37 100;
  ShowZero 0; (* centre of the incircle *)
  Add 92 84; Sub 43 96; Sub 40 96; Mul 58 0; Mul 58 2; Sub 1 0; Div 0 5; Sub 0 134;
  ShowZero 0; (* radius of the incircle *)
  Sub 103 94; Sub 103 94; Mul 1 1; Mul 1 1; Add 1 0; Mul 12 12; Sub 1 0;
  ShowZero 0; (* the circles of an edge touch *)
  Mul 110 70; Mul 110 70; Add 1 0; Mul 71 143; Sub 1 0; Mul 88 145; Sub 93 0; Sub 0 1; Mul 3 3;
  Mul 79 79; Mul 79 79; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 124 131; Sub 124 131; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 105; Mul 162 162; Sub 1 0;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 162 160; Sub 163 162; Mul 0 1; Mul 0 167; Add 143 0; Div 134 41; Mul 98 0; Add 139 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 172 174; Mul 0 9; Mul 0 175; Add 150 0; Mul 104 7; Add 145 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 139 131; Sub 139 131; Mul 1 1; Mul 1 1; Add 1 0; Add 142 133; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 139 147; Sub 139 147; Sub 119 125; Mul 150 2; Mul 150 2; Add 1 0; Mul 3 192; Sub 1 0;
  Mul 131 194; Sub 135 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 164 180; Sub 164 180; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 147; Sub 0 48;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 210 203; Sub 211 205; Mul 0 1; Mul 0 215; Add 191 0; Div 174 31; Mul 29 0; Add 178 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 216 222; Mul 0 9; Mul 0 223; Add 198 0; Mul 35 7; Add 184 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 179 117; Sub 179 117; Mul 1 1; Mul 1 1; Add 1 0; Add 181 119; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 125 187; Sub 125 187; Sub 118 167; Mul 190 2; Mul 190 2; Add 1 0; Mul 3 240; Sub 1 0;
  Mul 173 242; Sub 177 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 204 228; Sub 204 228; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 189; Sub 0 96;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 258 245; Sub 259 247; Mul 0 1; Mul 0 263; Add 239 0; Div 213 31; Mul 29 0; Add 218 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 259 270; Mul 0 9; Mul 0 271; Add 246 0; Mul 35 7; Add 224 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 165 244; Sub 165 244; Mul 1 1; Mul 1 1; Add 1 0; Add 167 246; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 252 173; Sub 252 173; Sub 227 166; Mul 176 2; Mul 176 2; Add 1 0; Mul 3 288; Sub 1 0;
  Mul 172 290; Sub 176 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 190 276; Sub 190 276; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 188; Sub 0 144;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 306 287; Sub 307 289; Mul 0 1; Mul 0 311; Add 287 0; Div 199 31; Mul 29 0; Add 204 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 301 318; Mul 0 9; Mul 0 319; Add 294 0; Mul 35 7; Add 210 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 261 268; Sub 171 0; Mul 251 251; Mul 251 251; Add 1 0; Sub 260 273; Sub 1 0; Sub 213 275;
  Sub 51 0; Mul 257 0; Mul 3 56; Sub 1 0; Mul 5 59; Mul 262 4; Sub 1 0; Mul 264 61; Mul 264 63;
  Sub 1 0; Mul 270 6; Mul 270 4; Add 1 0; Mul 19 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Add 219 113; Mul 185 0; Mul 314 306; Mul 0 116; Sub 2 0; Mul 300 238; Mul 0 225; Sub 2 0;
  ShowZero 0 (* Schramm's equation *)
].

Theorem part_2_size_4_valid : valid part_2_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k contacts; size 5.
    Code: src/construct/koebe.rs, src/net/i_isothermic.rs, src/net/scribed.rs, src/scalar/ring.rs,
    src/space/circle.rs, src/space/gradient.rs, src/space/motion.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_5 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the incircle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* consecutive tangents meet *)
  Mul 2 2; Add 6 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 5 0; Add 9 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 7 11;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 12 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 4; Mul 6 0; Add 15 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 17;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 18 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 5; Mul 6 0; Add 21 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 23;
  Nonzero 0; (* different contacts *)
  Sub 9 20;
  Nonzero 0; (* different contacts *)
  Mul 4 4; Add 25 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 6 27; Add 27 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 25;
  Nonzero 0; (* different contacts *)
  Sub 9 21;
  Nonzero 0; (* different contacts *)
  Unknown 6; Unknown 7; Div 34 4; Sub 33 6; Mul 0 1; Add 15 36; Mul 0 3; Add 6 2; Add 6 1;
  Sub 40 19; Mul 0 7; Div 43 36; Sub 42 38; Mul 0 1; Add 45 41; Mul 0 3; Add 15 2; Add 15 1;
  Mul 37 6; Div 51 39; Sub 50 41; Mul 0 1; Add 49 44; Mul 0 3; Add 23 2; Add 23 1; Sub 48 53;
  Mul 0 7; Mul 20 20; Mul 20 20; Add 1 0; Mul 20 20; Sub 1 0; Div 63 66; Mul 1 0; Mul 18 18;
  Mul 18 18; Add 1 0; Mul 19 19; Sub 1 0; Mul 0 6; Mul 16 16; Mul 16 16; Add 1 0; Mul 16 16;
  Sub 1 0; Mul 0 12; Sub 30 39; Sub 30 39; Sub 8 14; Sub 25 42; Sub 25 42; Sub 5 17; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 86 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 57; Mul 1 57; Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 54; Mul 7 54; Add 1 0; Add 0 5; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 51; Mul 12 51; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 113 95; Sub 112 97; Mul 0 1; Add 106 100; Mul 0 3; Add 85 2; Add 85 1; Sub 104 110; Mul 0 7;
  Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 61; Mul 35 9; Mul 32 9; Add 1 0; Add 0 30;
  Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 133 109; Sub 132 111; Mul 0 1; Add 120 114; Mul 0 3; Add 105 2; Add 105 1; Sub 118 124;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 81; Mul 55 9; Mul 52 9; Add 1 0;
  Add 0 50; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 60 120;
  ShowZero 0; (* centre of the incircle *)
  Sub 57 120;
  ShowZero 0; (* centre of the incircle *)
  Add 112 104; Sub 63 116; Sub 60 116; Mul 78 0; Mul 78 2; Sub 1 0; Div 0 5; Sub 0 162;
  ShowZero 0; (* radius of the incircle *)
  Sub 123 114; Sub 123 114; Mul 1 1; Mul 1 1; Add 1 0; Mul 12 12; Sub 1 0;
  ShowZero 0; (* the circles of an edge touch *)
  Mul 130 90; Mul 130 90; Add 1 0; Mul 91 171; Sub 1 0; Mul 108 173; Sub 113 0; Sub 0 1; Mul 3 3;
  Mul 99 99; Mul 99 99; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 144 151; Sub 144 151; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 125; Mul 190 190; Sub 1 0;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 190 188; Sub 191 190; Mul 0 1; Mul 0 195; Add 163 0; Div 154 41; Mul 118 0; Add 159 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 200 202; Mul 0 9; Mul 0 203; Add 170 0; Mul 124 7; Add 165 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 159 151; Sub 159 151; Mul 1 1; Mul 1 1; Add 1 0; Add 162 153; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 159 167; Sub 159 167; Sub 139 145; Mul 170 2; Mul 170 2; Add 1 0; Mul 3 220; Sub 1 0;
  Mul 151 222; Sub 155 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 184 200; Sub 184 200; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 167; Sub 0 48;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 238 231; Sub 239 233; Mul 0 1; Mul 0 243; Add 211 0; Div 194 31; Mul 29 0; Add 198 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 244 250; Mul 0 9; Mul 0 251; Add 218 0; Mul 35 7; Add 204 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 199 137; Sub 199 137; Mul 1 1; Mul 1 1; Add 1 0; Add 201 139; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 145 207; Sub 145 207; Sub 138 187; Mul 210 2; Mul 210 2; Add 1 0; Mul 3 268; Sub 1 0;
  Mul 193 270; Sub 197 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 224 248; Sub 224 248; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 209; Sub 0 96;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 286 273; Sub 287 275; Mul 0 1; Mul 0 291; Add 259 0; Div 233 31; Mul 29 0; Add 238 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 287 298; Mul 0 9; Mul 0 299; Add 266 0; Mul 35 7; Add 244 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 185 165; Sub 185 165; Mul 1 1; Mul 1 1; Add 1 0; Add 187 167; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 173 193; Sub 173 193; Sub 166 186; Mul 196 2; Mul 196 2; Add 1 0; Mul 3 316; Sub 1 0;
  Mul 192 318; Sub 196 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 210 296; Sub 210 296; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 208; Sub 0 144;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 334 315; Sub 335 317; Mul 0 1; Mul 0 339; Add 307 0; Div 219 31; Mul 29 0; Add 224 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 329 346; Mul 0 9; Mul 0 347; Add 314 0; Mul 35 7; Add 230 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 213 312; Sub 213 312; Mul 1 1; Mul 1 1; Add 1 0; Add 215 314; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 320 221; Sub 320 221; Sub 295 214; Mul 224 2; Mul 224 2; Add 1 0; Mul 3 364; Sub 1 0;
  Mul 220 366; Sub 224 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 238 344; Sub 238 344; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 236; Sub 0 192;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 382 356; Sub 383 358; Mul 0 1; Mul 0 387; Add 355 0; Div 247 31; Mul 29 0; Add 252 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 371 394; Mul 0 9; Mul 0 395; Add 362 0; Mul 35 7; Add 258 0; Sub 0 2;
  ShowZero 0 (* the contact *)
].

Theorem part_2_size_5_valid : valid part_2_size_5.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k contacts; size 6.
    Code: src/construct/koebe.rs, src/net/i_isothermic.rs, src/net/scribed.rs, src/scalar/ring.rs,
    src/space/circle.rs, src/space/gradient.rs, src/space/motion.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_6 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the incircle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* consecutive tangents meet *)
  Mul 2 2; Add 6 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 5 0; Add 9 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 7 11;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 12 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 4; Mul 6 0; Add 15 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 17;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 18 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 5; Mul 6 0; Add 21 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 19;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 24 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 6; Mul 6 0; Add 27 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 29;
  Nonzero 0; (* different contacts *)
  Sub 9 21;
  Nonzero 0; (* different contacts *)
  Mul 4 4; Add 31 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 6 33; Add 33 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 31;
  Nonzero 0; (* different contacts *)
  Sub 9 21;
  Nonzero 0; (* different contacts *)
  Unknown 7; Unknown 8; Div 40 4; Sub 39 6; Mul 0 1; Add 15 42; Mul 0 3; Add 6 2; Add 6 1;
  Sub 46 19; Mul 0 7; Div 49 42; Sub 48 44; Mul 0 1; Add 51 47; Mul 0 3; Add 15 2; Add 15 1;
  Mul 43 6; Div 57 45; Sub 56 47; Mul 0 1; Add 55 50; Mul 0 3; Add 23 2; Add 23 1; Sub 54 59;
  Mul 0 7; Mul 20 20; Mul 20 20; Add 1 0; Mul 20 20; Sub 1 0; Div 69 72; Mul 1 0; Mul 18 18;
  Mul 18 18; Add 1 0; Mul 19 19; Sub 1 0; Mul 0 6; Mul 16 16; Mul 16 16; Add 1 0; Mul 16 16;
  Sub 1 0; Mul 0 12; Sub 30 39; Sub 30 39; Sub 8 14; Sub 25 42; Sub 25 42; Sub 5 17; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 92 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 57; Mul 1 57; Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 54; Mul 7 54; Add 1 0; Add 0 5; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 51; Mul 12 51; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 119 101; Sub 118 103; Mul 0 1; Add 112 106; Mul 0 3; Add 85 2; Add 85 1; Sub 110 116;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 61; Mul 35 9; Mul 32 9; Add 1 0;
  Add 0 30; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 139 115; Sub 138 117; Mul 0 1; Add 126 120; Mul 0 3; Add 105 2; Add 105 1; Sub 124 130;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 81; Mul 55 9; Mul 52 9; Add 1 0;
  Add 0 50; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 159 129; Sub 158 131; Mul 0 1; Add 140 134; Mul 0 3; Add 125 2; Add 125 1; Sub 138 144;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 101; Mul 75 9; Mul 72 9; Add 1 0;
  Add 0 70; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 80 140;
  ShowZero 0; (* centre of the incircle *)
  Sub 77 140;
  ShowZero 0; (* centre of the incircle *)
  Add 132 124; Sub 83 136; Sub 80 136; Mul 98 0; Mul 98 2; Sub 1 0; Div 0 5; Sub 0 188;
  ShowZero 0; (* radius of the incircle *)
  Sub 143 134; Sub 143 134; Mul 1 1; Mul 1 1; Add 1 0; Mul 12 12; Sub 1 0;
  ShowZero 0; (* the circles of an edge touch *)
  Mul 150 110; Mul 150 110; Add 1 0; Mul 111 197; Sub 1 0; Mul 128 199; Sub 133 0; Sub 0 1;
  Mul 3 3; Mul 119 119; Mul 119 119; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 164 171; Sub 164 171; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 145; Mul 216 216; Sub 1 0;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 216 214; Sub 217 216; Mul 0 1; Mul 0 221; Add 183 0; Div 174 41; Mul 138 0; Add 179 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 226 228; Mul 0 9; Mul 0 229; Add 190 0; Mul 144 7; Add 185 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 179 171; Sub 179 171; Mul 1 1; Mul 1 1; Add 1 0; Add 182 173; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 179 187; Sub 179 187; Sub 159 165; Mul 190 2; Mul 190 2; Add 1 0; Mul 3 246; Sub 1 0;
  Mul 171 248; Sub 175 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 204 220; Sub 204 220; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 187; Sub 0 48;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 264 257; Sub 265 259; Mul 0 1; Mul 0 269; Add 231 0; Div 214 31; Mul 29 0; Add 218 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 270 276; Mul 0 9; Mul 0 277; Add 238 0; Mul 35 7; Add 224 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 219 157; Sub 219 157; Mul 1 1; Mul 1 1; Add 1 0; Add 221 159; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 165 227; Sub 165 227; Sub 158 207; Mul 230 2; Mul 230 2; Add 1 0; Mul 3 294; Sub 1 0;
  Mul 213 296; Sub 217 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 244 268; Sub 244 268; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 229; Sub 0 96;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 312 299; Sub 313 301; Mul 0 1; Mul 0 317; Add 279 0; Div 253 31; Mul 29 0; Add 258 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 313 324; Mul 0 9; Mul 0 325; Add 286 0; Mul 35 7; Add 264 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 205 185; Sub 205 185; Mul 1 1; Mul 1 1; Add 1 0; Add 207 187; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 193 213; Sub 193 213; Sub 186 206; Mul 216 2; Mul 216 2; Add 1 0; Mul 3 342; Sub 1 0;
  Mul 212 344; Sub 216 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 230 316; Sub 230 316; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 228; Sub 0 144;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 360 341; Sub 361 343; Mul 0 1; Mul 0 365; Add 327 0; Div 239 31; Mul 29 0; Add 244 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 355 372; Mul 0 9; Mul 0 373; Add 334 0; Mul 35 7; Add 250 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 233 213; Sub 233 213; Mul 1 1; Mul 1 1; Add 1 0; Add 235 215; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 221 241; Sub 221 241; Sub 214 234; Mul 244 2; Mul 244 2; Add 1 0; Mul 3 390; Sub 1 0;
  Mul 240 392; Sub 244 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 258 364; Sub 258 364; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 256; Sub 0 192;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 408 383; Sub 409 385; Mul 0 1; Mul 0 413; Add 375 0; Div 267 31; Mul 29 0; Add 272 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 397 420; Mul 0 9; Mul 0 421; Add 382 0; Mul 35 7; Add 278 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 261 380; Sub 261 380; Mul 1 1; Mul 1 1; Add 1 0; Add 263 382; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 388 269; Sub 388 269; Sub 363 262; Mul 272 2; Mul 272 2; Add 1 0; Mul 3 438; Sub 1 0;
  Mul 268 440; Sub 272 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 286 412; Sub 286 412; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 284; Sub 0 240;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 456 424; Sub 457 426; Mul 0 1; Mul 0 461; Add 423 0; Div 295 31; Mul 29 0; Add 300 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 439 468; Mul 0 9; Mul 0 469; Add 430 0; Mul 35 7; Add 306 0; Sub 0 2;
  ShowZero 0 (* the contact *)
].

Theorem part_2_size_6_valid : valid part_2_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k contacts; size 7.
    Code: src/construct/koebe.rs, src/net/i_isothermic.rs, src/net/scribed.rs, src/scalar/ring.rs,
    src/space/circle.rs, src/space/gradient.rs, src/space/motion.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_7 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the incircle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* consecutive tangents meet *)
  Mul 2 2; Add 6 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 5 0; Add 9 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 7 11;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 12 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 4; Mul 6 0; Add 15 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 17;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 18 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 5; Mul 6 0; Add 21 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 19;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 24 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 6; Mul 6 0; Add 27 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 20;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 30 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 7; Mul 6 0; Add 33 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 35;
  Nonzero 0; (* different contacts *)
  Sub 9 21;
  Nonzero 0; (* different contacts *)
  Mul 4 4; Add 37 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 6 39; Add 39 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 37;
  Nonzero 0; (* different contacts *)
  Sub 9 21;
  Nonzero 0; (* different contacts *)
  Unknown 8; Unknown 9; Div 46 4; Sub 45 6; Mul 0 1; Add 15 48; Mul 0 3; Add 6 2; Add 6 1;
  Sub 52 19; Mul 0 7; Div 55 48; Sub 54 50; Mul 0 1; Add 57 53; Mul 0 3; Add 15 2; Add 15 1;
  Mul 49 6; Div 63 51; Sub 62 53; Mul 0 1; Add 61 56; Mul 0 3; Add 23 2; Add 23 1; Sub 60 65;
  Mul 0 7; Mul 20 20; Mul 20 20; Add 1 0; Mul 20 20; Sub 1 0; Div 75 78; Mul 1 0; Mul 18 18;
  Mul 18 18; Add 1 0; Mul 19 19; Sub 1 0; Mul 0 6; Mul 16 16; Mul 16 16; Add 1 0; Mul 16 16;
  Sub 1 0; Mul 0 12; Sub 30 39; Sub 30 39; Sub 8 14; Sub 25 42; Sub 25 42; Sub 5 17; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 98 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 57; Mul 1 57; Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 54; Mul 7 54; Add 1 0; Add 0 5; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 51; Mul 12 51; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 125 107; Sub 124 109; Mul 0 1; Add 118 112; Mul 0 3; Add 85 2; Add 85 1; Sub 116 122;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 61; Mul 35 9; Mul 32 9; Add 1 0;
  Add 0 30; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 145 121; Sub 144 123; Mul 0 1; Add 132 126; Mul 0 3; Add 105 2; Add 105 1; Sub 130 136;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 81; Mul 55 9; Mul 52 9; Add 1 0;
  Add 0 50; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 165 135; Sub 164 137; Mul 0 1; Add 146 140; Mul 0 3; Add 125 2; Add 125 1; Sub 144 150;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 101; Mul 75 9; Mul 72 9; Add 1 0;
  Add 0 70; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 185 149; Sub 184 151; Mul 0 1; Add 160 154; Mul 0 3; Add 145 2; Add 145 1; Sub 158 164;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 121; Mul 95 9; Mul 92 9; Add 1 0;
  Add 0 90; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 100 160;
  ShowZero 0; (* centre of the incircle *)
  Sub 97 160;
  ShowZero 0; (* centre of the incircle *)
  Add 152 144; Sub 103 156; Sub 100 156; Mul 118 0; Mul 118 2; Sub 1 0; Div 0 5; Sub 0 214;
  ShowZero 0; (* radius of the incircle *)
  Sub 163 154; Sub 163 154; Mul 1 1; Mul 1 1; Add 1 0; Mul 12 12; Sub 1 0;
  ShowZero 0; (* the circles of an edge touch *)
  Mul 170 130; Mul 170 130; Add 1 0; Mul 131 223; Sub 1 0; Mul 148 225; Sub 153 0; Sub 0 1;
  Mul 3 3; Mul 139 139; Mul 139 139; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 184 191; Sub 184 191; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 165; Mul 242 242; Sub 1 0;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 242 240; Sub 243 242; Mul 0 1; Mul 0 247; Add 203 0; Div 194 41; Mul 158 0; Add 199 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 252 254; Mul 0 9; Mul 0 255; Add 210 0; Mul 164 7; Add 205 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 199 191; Sub 199 191; Mul 1 1; Mul 1 1; Add 1 0; Add 202 193; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 199 207; Sub 199 207; Sub 179 185; Mul 210 2; Mul 210 2; Add 1 0; Mul 3 272; Sub 1 0;
  Mul 191 274; Sub 195 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 224 240; Sub 224 240; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 207; Sub 0 48;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 290 283; Sub 291 285; Mul 0 1; Mul 0 295; Add 251 0; Div 234 31; Mul 29 0; Add 238 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 296 302; Mul 0 9; Mul 0 303; Add 258 0; Mul 35 7; Add 244 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 239 177; Sub 239 177; Mul 1 1; Mul 1 1; Add 1 0; Add 241 179; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 185 247; Sub 185 247; Sub 178 227; Mul 250 2; Mul 250 2; Add 1 0; Mul 3 320; Sub 1 0;
  Mul 233 322; Sub 237 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 264 288; Sub 264 288; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 249; Sub 0 96;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 338 325; Sub 339 327; Mul 0 1; Mul 0 343; Add 299 0; Div 273 31; Mul 29 0; Add 278 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 339 350; Mul 0 9; Mul 0 351; Add 306 0; Mul 35 7; Add 284 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 225 205; Sub 225 205; Mul 1 1; Mul 1 1; Add 1 0; Add 227 207; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 213 233; Sub 213 233; Sub 206 226; Mul 236 2; Mul 236 2; Add 1 0; Mul 3 368; Sub 1 0;
  Mul 232 370; Sub 236 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 250 336; Sub 250 336; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 248; Sub 0 144;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 386 367; Sub 387 369; Mul 0 1; Mul 0 391; Add 347 0; Div 259 31; Mul 29 0; Add 264 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 381 398; Mul 0 9; Mul 0 399; Add 354 0; Mul 35 7; Add 270 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 253 233; Sub 253 233; Mul 1 1; Mul 1 1; Add 1 0; Add 255 235; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 241 261; Sub 241 261; Sub 234 254; Mul 264 2; Mul 264 2; Add 1 0; Mul 3 416; Sub 1 0;
  Mul 260 418; Sub 264 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 278 384; Sub 278 384; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 276; Sub 0 192;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 434 409; Sub 435 411; Mul 0 1; Mul 0 439; Add 395 0; Div 287 31; Mul 29 0; Add 292 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 423 446; Mul 0 9; Mul 0 447; Add 402 0; Mul 35 7; Add 298 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 281 261; Sub 281 261; Mul 1 1; Mul 1 1; Add 1 0; Add 283 263; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 269 289; Sub 269 289; Sub 262 282; Mul 292 2; Mul 292 2; Add 1 0; Mul 3 464; Sub 1 0;
  Mul 288 466; Sub 292 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 306 432; Sub 306 432; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 304; Sub 0 240;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 482 451; Sub 483 453; Mul 0 1; Mul 0 487; Add 443 0; Div 315 31; Mul 29 0; Add 320 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 465 494; Mul 0 9; Mul 0 495; Add 450 0; Mul 35 7; Add 326 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 309 448; Sub 309 448; Mul 1 1; Mul 1 1; Add 1 0; Add 311 450; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 456 317; Sub 456 317; Sub 431 310; Mul 320 2; Mul 320 2; Add 1 0; Mul 3 512; Sub 1 0;
  Mul 316 514; Sub 320 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 334 480; Sub 334 480; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 332; Sub 0 288;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 530 492; Sub 531 494; Mul 0 1; Mul 0 535; Add 491 0; Div 343 31; Mul 29 0; Add 348 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 507 542; Mul 0 9; Mul 0 543; Add 498 0; Mul 35 7; Add 354 0; Sub 0 2;
  ShowZero 0 (* the contact *)
].

Theorem part_2_size_7_valid : valid part_2_size_7.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k contacts; size 8.
    Code: src/construct/koebe.rs, src/net/i_isothermic.rs, src/net/scribed.rs, src/scalar/ring.rs,
    src/space/circle.rs, src/space/gradient.rs, src/space/motion.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_8 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* the incircle is no point *)
  Unknown 1; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 2; Mul 4 0; Add 4 0;
  Nonzero 0; (* consecutive tangents meet *)
  Mul 2 2; Add 6 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 3; Mul 5 0; Add 9 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 7 11;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 12 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 4; Mul 6 0; Add 15 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 17;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 18 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 5; Mul 6 0; Add 21 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 19;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 24 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 6; Mul 6 0; Add 27 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 20;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 30 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 7; Mul 6 0; Add 33 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 20;
  Nonzero 0; (* different contacts *)
  Mul 3 3; Add 36 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Unknown 8; Mul 6 0; Add 39 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 41;
  Nonzero 0; (* different contacts *)
  Sub 9 21;
  Nonzero 0; (* different contacts *)
  Mul 4 4; Add 43 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Mul 6 45; Add 45 0;
  Nonzero 0; (* consecutive tangents meet *)
  Sub 8 43;
  Nonzero 0; (* different contacts *)
  Sub 9 21;
  Nonzero 0; (* different contacts *)
  Unknown 9; Unknown 10; Div 52 4; Sub 51 6; Mul 0 1; Add 15 54; Mul 0 3; Add 6 2; Add 6 1;
  Sub 58 19; Mul 0 7; Div 61 54; Sub 60 56; Mul 0 1; Add 63 59; Mul 0 3; Add 15 2; Add 15 1;
  Mul 55 6; Div 69 57; Sub 68 59; Mul 0 1; Add 67 62; Mul 0 3; Add 23 2; Add 23 1; Sub 66 71;
  Mul 0 7; Mul 20 20; Mul 20 20; Add 1 0; Mul 20 20; Sub 1 0; Div 81 84; Mul 1 0; Mul 18 18;
  Mul 18 18; Add 1 0; Mul 19 19; Sub 1 0; Mul 0 6; Mul 16 16; Mul 16 16; Add 1 0; Mul 16 16;
  Sub 1 0; Mul 0 12; Sub 30 39; Sub 30 39; Sub 8 14; Sub 25 42; Sub 25 42; Sub 5 17; Mul 5 1;
  Mul 5 3; Sub 1 0; Div 104 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0;
  Mul 0 7; Mul 4 57; Mul 1 57; Add 1 0; Sub 33 0; Add 1 0; Sub 35 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 54; Mul 7 54; Add 1 0; Add 0 5; Sub 34 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 51; Mul 12 51; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 131 113; Sub 130 115; Mul 0 1; Add 124 118; Mul 0 3; Add 85 2; Add 85 1; Sub 122 128;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 61; Mul 35 9; Mul 32 9; Add 1 0;
  Add 0 30; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 151 127; Sub 150 129; Mul 0 1; Add 138 132; Mul 0 3; Add 105 2; Add 105 1; Sub 136 142;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 81; Mul 55 9; Mul 52 9; Add 1 0;
  Add 0 50; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 171 141; Sub 170 143; Mul 0 1; Add 152 146; Mul 0 3; Add 125 2; Add 125 1; Sub 150 156;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 101; Mul 75 9; Mul 72 9; Add 1 0;
  Add 0 70; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 191 155; Sub 190 157; Mul 0 1; Add 166 160; Mul 0 3; Add 145 2; Add 145 1; Sub 164 170;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 121; Mul 95 9; Mul 92 9; Add 1 0;
  Add 0 90; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 211 169; Sub 210 171; Mul 0 1; Add 180 174; Mul 0 3; Add 165 2; Add 165 1; Sub 178 184;
  Mul 0 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 141; Mul 115 9; Mul 112 9; Add 1 0;
  Add 0 110; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 120 180;
  ShowZero 0; (* centre of the incircle *)
  Sub 117 180;
  ShowZero 0; (* centre of the incircle *)
  Add 172 164; Sub 123 176; Sub 120 176; Mul 138 0; Mul 138 2; Sub 1 0; Div 0 5; Sub 0 240;
  ShowZero 0; (* radius of the incircle *)
  Sub 183 174; Sub 183 174; Mul 1 1; Mul 1 1; Add 1 0; Mul 12 12; Sub 1 0;
  ShowZero 0; (* the circles of an edge touch *)
  Mul 190 150; Mul 190 150; Add 1 0; Mul 151 249; Sub 1 0; Mul 168 251; Sub 173 0; Sub 0 1;
  Mul 3 3; Mul 159 159; Mul 159 159; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 204 211; Sub 204 211; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 185; Mul 268 268; Sub 1 0;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 268 266; Sub 269 268; Mul 0 1; Mul 0 273; Add 223 0; Div 214 41; Mul 178 0; Add 219 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 278 280; Mul 0 9; Mul 0 281; Add 230 0; Mul 184 7; Add 225 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 219 211; Sub 219 211; Mul 1 1; Mul 1 1; Add 1 0; Add 222 213; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 219 227; Sub 219 227; Sub 199 205; Mul 230 2; Mul 230 2; Add 1 0; Mul 3 298; Sub 1 0;
  Mul 211 300; Sub 215 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 244 260; Sub 244 260; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 227; Sub 0 48;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 316 309; Sub 317 311; Mul 0 1; Mul 0 321; Add 271 0; Div 254 31; Mul 29 0; Add 258 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 322 328; Mul 0 9; Mul 0 329; Add 278 0; Mul 35 7; Add 264 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 259 197; Sub 259 197; Mul 1 1; Mul 1 1; Add 1 0; Add 261 199; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 205 267; Sub 205 267; Sub 198 247; Mul 270 2; Mul 270 2; Add 1 0; Mul 3 346; Sub 1 0;
  Mul 253 348; Sub 257 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 284 308; Sub 284 308; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 269; Sub 0 96;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 364 351; Sub 365 353; Mul 0 1; Mul 0 369; Add 319 0; Div 293 31; Mul 29 0; Add 298 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 365 376; Mul 0 9; Mul 0 377; Add 326 0; Mul 35 7; Add 304 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 245 225; Sub 245 225; Mul 1 1; Mul 1 1; Add 1 0; Add 247 227; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 233 253; Sub 233 253; Sub 226 246; Mul 256 2; Mul 256 2; Add 1 0; Mul 3 394; Sub 1 0;
  Mul 252 396; Sub 256 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 270 356; Sub 270 356; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 268; Sub 0 144;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 412 393; Sub 413 395; Mul 0 1; Mul 0 417; Add 367 0; Div 279 31; Mul 29 0; Add 284 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 407 424; Mul 0 9; Mul 0 425; Add 374 0; Mul 35 7; Add 290 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 273 253; Sub 273 253; Mul 1 1; Mul 1 1; Add 1 0; Add 275 255; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 261 281; Sub 261 281; Sub 254 274; Mul 284 2; Mul 284 2; Add 1 0; Mul 3 442; Sub 1 0;
  Mul 280 444; Sub 284 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 298 404; Sub 298 404; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 296; Sub 0 192;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 460 435; Sub 461 437; Mul 0 1; Mul 0 465; Add 415 0; Div 307 31; Mul 29 0; Add 312 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 449 472; Mul 0 9; Mul 0 473; Add 422 0; Mul 35 7; Add 318 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 301 281; Sub 301 281; Mul 1 1; Mul 1 1; Add 1 0; Add 303 283; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 289 309; Sub 289 309; Sub 282 302; Mul 312 2; Mul 312 2; Add 1 0; Mul 3 490; Sub 1 0;
  Mul 308 492; Sub 312 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 326 452; Sub 326 452; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 324; Sub 0 240;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 508 477; Sub 509 479; Mul 0 1; Mul 0 513; Add 463 0; Div 335 31; Mul 29 0; Add 340 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 491 520; Mul 0 9; Mul 0 521; Add 470 0; Mul 35 7; Add 346 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 329 309; Sub 329 309; Mul 1 1; Mul 1 1; Add 1 0; Add 331 311; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 317 337; Sub 317 337; Sub 310 330; Mul 340 2; Mul 340 2; Add 1 0; Mul 3 538; Sub 1 0;
  Mul 336 540; Sub 340 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 354 500; Sub 354 500; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 352; Sub 0 288;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 556 519; Sub 557 521; Mul 0 1; Mul 0 561; Add 511 0; Div 363 31; Mul 29 0; Add 368 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 533 568; Mul 0 9; Mul 0 569; Add 518 0; Mul 35 7; Add 374 0; Sub 0 2;
  ShowZero 0; (* the contact *)
  Sub 357 516; Sub 357 516; Mul 1 1; Mul 1 1; Add 1 0; Add 359 518; Mul 0 0; Sub 2 0;
  ShowZero 0; (* the circles of an edge touch *)
  Sub 524 365; Sub 524 365; Sub 499 358; Mul 368 2; Mul 368 2; Add 1 0; Mul 3 586; Sub 1 0;
  Mul 364 588; Sub 368 0; Sub 0 1; Mul 3 3; Mul 11 11; Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the edge touches Σ *)
  Sub 382 548; Sub 382 548; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 380; Sub 0 336;
  ShowZero 0; (* orthogonal to the incircle *)
  Div 604 560; Sub 605 562; Mul 0 1; Mul 0 609; Add 559 0; Div 391 31; Mul 29 0; Add 396 0;
  Sub 0 3;
  ShowZero 0; (* the contact *)
  Mul 575 616; Mul 0 9; Mul 0 617; Add 566 0; Mul 35 7; Add 402 0; Sub 0 2;
  ShowZero 0 (* the contact *)
].

Theorem part_2_size_8_valid : valid part_2_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
