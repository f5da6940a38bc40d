(** koebe-minimal (Sec. 4)

    The Christoffel dual of an isotropic Koebe mesh is i-minimal at its faces, with the Koebe mesh
    as Gauss image, and it is i-isothermic: its circles with the inverse radii touch along its
    edges, too.

        area(F, S) = 0,  K(F) = -R_0 R_1 R_2 R_3

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** a face with k corners; size 4.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/net/i_isothermic.rs, src/net/scribed.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Sub 1 0;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 1; Mul 2 3; Add 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 2; Sub 0 5;
  Nonzero 0; (* no edge has length 0 *)
  Sub 1 7;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 8 2; Add 6 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 3; Sub 0 11;
  Nonzero 0; (* no edge has length 0 *)
  Sub 1 6;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 7 2; Add 11 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Sub 14 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 15; Add 14 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Div 15 13; Sub 16 15; Mul 0 1; Mul 19 2; Div 19 12; Sub 20 14; Mul 0 1; Mul 17 2; Div 23 11;
  Sub 24 13; Mul 0 1; Mul 16 2; Div 27 12; Sub 28 14; Mul 0 1; Mul 17 2; Unknown 4; Add 14 0;
  Add 11 1; Add 8 2; Add 5 3; Div 36 17; Div 37 14; Div 38 11; Div 39 8; Constant 0; Sub 7 8;
  Mul 5 4; Mul 1 0; Add 3 0; Sub 10 11; Mul 8 7; Neg 0; Mul 2 0; Add 4 0; Sub 14 15; Mul 12 11;
  Mul 1 0; Add 3 0; Sub 21 18; Mul 15 18; Neg 0; Mul 2 0; Add 4 0; Sub 0 18;
  ShowZero 0; (* as a test finds *)
  Add 62 63; Mul 0 45; Add 65 59; Mul 0 43; Add 61 56; Mul 0 41; Add 58 68; Mul 0 39; Unknown 5;
  Add 7 0; Add 6 1; Add 5 2; Add 4 3; Sub 2 3; Mul 0 31; Add 34 0; Sub 4 5; Mul 0 29; Add 2 0;
  Sub 6 7; Mul 0 28; Add 2 0; Sub 12 9; Mul 0 26; Add 2 0; Sub 0 44;
  ShowZero 0; (* as a test finds *)
  Mul 53 53; Mul 17 17; Add 1 0; Mul 70 70; Sub 1 0; Div 91 95; Mul 1 0; Mul 59 59; Mul 23 23;
  Add 1 0; Mul 73 73; Sub 1 0; Mul 0 6; Mul 64 64; Mul 28 28; Add 1 0; Mul 75 75; Sub 1 0;
  Mul 0 12; Mul 69 69; Mul 33 33; Add 1 0; Mul 77 77; Sub 1 0; Mul 0 18; Sub 12 18; Mul 0 69;
  Add 72 0; Sub 9 15; Mul 0 67; Add 2 0; Sub 6 12; Mul 0 66; Add 2 0; Sub 27 9; Mul 0 64; Add 2 0;
  Sub 0 82;
  ShowZero 0; (* as a test finds *)
  Sub 79 79;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 49 49;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 12 12;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 77 77;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 49 49;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 12 12;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 89 72; Sub 77 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 91 48; Sub 51 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 93 12; Sub 15 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 78; Sub 0 96;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 54; Sub 0 98;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 18; Sub 0 100;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 97 101; Sub 67 102; Sub 109 111; Sub 73 75; Sub 96 105; Sub 68 106; Mul 106 0; Mul 75 2;
  Sub 1 0; Add 110 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 120 123; Sub 84 87; Sub 27 117;
  Sub 26 118; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 54 127; Sub 52 128; Mul 27 22; Mul 27 24; Sub 1 0; Div 173 0; Mul 5 26; Mul 31 5; Sub 1 0;
  Mul 0 3; Mul 35 8; Mul 10 32; Sub 1 0; Mul 0 7; Mul 4 141; Mul 1 142; Add 1 0; Sub 144 0;
  Add 1 0; Sub 146 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 143; Mul 7 113; Add 1 0; Add 0 5; Sub 78 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 143; Mul 12 115; Add 1 0; Add 0 10; Sub 80 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 67; Mul 17 66; Add 1 0; Add 0 15; Sub 67 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 170; Mul 22 134; Add 1 0; Sub 113 0; Mul 29 173; Mul 26 137; Add 1 0; Add 0 3; Sub 112 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 34 177; Mul 31 141; Add 1 0; Add 0 8; Sub 111 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 39 181; Mul 36 145; Add 1 0; Add 0 13; Sub 110 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 189 180; Mul 153 149; Add 1 0; Mul 113 225; Sub 1 0; Mul 134 227; Sub 139 0; Sub 0 1;
  Mul 3 3; Mul 189 189; Mul 158 158; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 202 190; Mul 166 160; Add 1 0; Mul 124 239; Sub 1 0; Mul 142 241; Sub 146 0; Sub 0 1;
  Mul 3 3; Mul 199 199; Mul 169 169; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 215 199; Mul 179 171; Add 1 0; Mul 135 253; Sub 1 0; Mul 150 255; Sub 154 0; Sub 0 1;
  Mul 3 3; Mul 208 208; Mul 180 180; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 228 209; Mul 192 182; Add 1 0; Mul 146 267; Sub 1 0; Mul 158 269; Sub 162 0; Sub 0 1;
  Mul 3 3; Mul 218 218; Mul 191 191; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Sub 237 233; Sub 238 203; Mul 1 1; Mul 1 1; Add 1 0; Add 246 245; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 241 236; Sub 211 208; Mul 1 1; Mul 1 1; Add 1 0; Add 253 252; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 244 163; Sub 216 162; Mul 1 1; Mul 1 1; Add 1 0; Add 260 259; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 143 143; Mul 143 143; Add 1 0; Add 265 268; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 165 165; Mul 165 165; Add 1 0; Mul 273 273; Mul 275 275; Sub 1 0; Sub 3 0; Mul 168 168;
  Mul 168 168; Add 1 0; Mul 279 279; Sub 0 6; Sub 2 0; Mul 281 281; Sub 0 9; Sub 18 0; Mul 176 0;
  Mul 4 165; Sub 1 0; Mul 6 168; Mul 181 4; Sub 1 0; Mul 183 170; Mul 183 172; Sub 1 0; Mul 190 6;
  Mul 190 4; Add 1 0; Mul 21 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Add 183 187; Add 298 0; Add 173 177; Add 1 0; Constant 4; Div 343 0; Mul 2 0;
  ShowZero 0; (* area(F, S) *)
  Add 304 172; Mul 304 200; Mul 273 202; Sub 1 0; Add 308 0; Add 4 17; Mul 206 193; Mul 206 195;
  Sub 1 0; Add 4 0; Mul 4 359; Mul 1 360; Mul 357 338; Mul 0 335; Mul 0 332; Mul 0 329; Mul 4 17;
  Mul 6 18; Mul 0 2; Add 2 0;
  ShowZero 0 (* K(F) *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k corners; size 6.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/net/i_isothermic.rs, src/net/scribed.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_6 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Sub 1 0;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 1; Mul 2 3; Add 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 2; Sub 0 5;
  Nonzero 0; (* no edge has length 0 *)
  Sub 1 7;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 8 2; Add 6 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 3; Sub 0 11;
  Nonzero 0; (* no edge has length 0 *)
  Sub 1 6;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 7 2; Add 11 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 4; Sub 0 5;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 6 1; Add 15 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 5; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 19 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Sub 22 3;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 4 23; Add 22 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Div 23 21; Sub 24 23; Mul 0 1; Mul 27 2; Div 27 20; Sub 28 22; Mul 0 1; Mul 25 2; Div 31 19;
  Sub 32 21; Mul 0 1; Mul 24 2; Div 35 19; Sub 36 21; Mul 0 1; Mul 24 2; Div 39 19; Sub 40 21;
  Mul 0 1; Mul 24 2; Div 43 20; Sub 44 22; Mul 0 1; Mul 25 2; Unknown 6; Add 22 0; Add 19 1;
  Add 16 2; Add 13 3; Add 10 4; Add 7 5; Div 54 27; Div 55 24; Div 56 21; Div 57 18; Div 58 15;
  Div 59 12; Constant 0; Sub 11 12; Mul 7 6; Mul 1 0; Add 3 0; Sub 14 15; Mul 10 9; Neg 0;
  Mul 2 0; Add 4 0; Sub 18 19; Mul 14 13; Mul 1 0; Add 3 0; Sub 21 22; Mul 17 16; Neg 0; Mul 2 0;
  Add 4 0; Sub 25 26; Mul 21 20; Mul 1 0; Add 3 0; Sub 34 29; Mul 24 29; Neg 0; Mul 2 0; Add 4 0;
  Sub 0 27;
  ShowZero 0; (* as a test finds *)
  Add 91 92; Mul 0 66; Add 94 88; Mul 0 64; Add 90 85; Mul 0 62; Add 87 82; Mul 0 60; Add 84 80;
  Mul 0 58; Add 82 101; Mul 0 56; Unknown 7; Add 11 0; Add 10 1; Add 9 2; Add 8 3; Add 7 4;
  Add 6 5; Sub 4 5; Mul 0 46; Add 49 0; Sub 6 7; Mul 0 44; Add 2 0; Sub 8 9; Mul 0 43; Add 2 0;
  Sub 10 11; Mul 0 41; Add 2 0; Sub 12 13; Mul 0 40; Add 2 0; Sub 20 15; Mul 0 38; Add 2 0;
  Sub 0 65;
  ShowZero 0; (* as a test finds *)
  Mul 78 78; Mul 25 25; Add 1 0; Mul 103 103; Sub 1 0; Div 132 136; Mul 1 0; Mul 84 84; Mul 31 31;
  Add 1 0; Mul 106 106; Sub 1 0; Mul 0 6; Mul 89 89; Mul 36 36; Add 1 0; Mul 108 108; Sub 1 0;
  Mul 0 12; Mul 94 94; Mul 41 41; Add 1 0; Mul 110 110; Sub 1 0; Mul 0 18; Mul 99 99; Mul 46 46;
  Add 1 0; Mul 112 112; Sub 1 0; Mul 0 24; Mul 104 104; Mul 51 51; Add 1 0; Mul 114 114; Sub 1 0;
  Mul 0 30; Sub 24 30; Mul 0 102; Add 105 0; Sub 21 27; Mul 0 100; Add 2 0; Sub 18 24; Mul 0 99;
  Add 2 0; Sub 15 21; Mul 0 97; Add 2 0; Sub 12 18; Mul 0 96; Add 2 0; Sub 45 15; Mul 0 94;
  Add 2 0; Sub 0 121;
  ShowZero 0; (* as a test finds *)
  Sub 118 118;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 73 73;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 116 116;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 73 73;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 115 115;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 73 73;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 18 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 131 105; Sub 0 111; Sub 115 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 134 70; Sub 0 74; Sub 77 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 137 17; Sub 0 21; Sub 24 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 119; Sub 0 9;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 6 81; Sub 0 8;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 27; Sub 0 7;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 14 120; Sub 0 147;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 13 84; Sub 0 149;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 12 30; Sub 0 151;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 148 152; Sub 103 153; Sub 164 166; Sub 111 113; Sub 147 156; Sub 104 157; Mul 157 0;
  Mul 111 2; Sub 1 0; Add 161 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 175 178; Sub 122 125;
  Sub 155 168; Sub 113 169; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0; Sub 186 190; Sub 133 137; Sub 47 180; Sub 45 181; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0;
  Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0; Sub 197 202; Sub 144 149; Sub 60 192; Sub 58 193;
  Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 96 202; Sub 94 203; Mul 51 46; Mul 51 48; Sub 1 0; Div 268 0; Mul 5 50; Mul 55 5; Sub 1 0;
  Mul 0 3; Mul 59 8; Mul 10 56; Sub 1 0; Mul 0 7; Mul 4 216; Mul 1 217; Add 1 0; Sub 219 0;
  Add 1 0; Sub 221 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 218; Mul 7 173; Add 1 0; Add 0 5; Sub 120 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 218; Mul 12 175; Add 1 0; Add 0 10; Sub 122 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 219; Mul 17 177; Add 1 0; Add 0 15; Sub 124 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 104; Mul 22 102; Add 1 0; Add 0 20; Sub 102 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 30 110; Mul 27 108; Add 1 0; Add 0 25; Sub 108 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 35 259; Mul 32 206; Add 1 0; Sub 177 0; Mul 39 262; Mul 36 209; Add 1 0; Add 0 3; Sub 176 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 44 266; Mul 41 213; Add 1 0; Add 0 8; Sub 175 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 49 270; Mul 46 217; Add 1 0; Add 0 13; Sub 174 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 54 274; Mul 51 221; Add 1 0; Add 0 18; Sub 173 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 59 278; Mul 56 225; Add 1 0; Add 0 23; Sub 172 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 288 275; Mul 235 229; Add 1 0; Mul 175 340; Sub 1 0; Mul 208 342; Sub 213 0; Sub 0 1;
  Mul 3 3; Mul 284 284; Mul 238 238; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 301 285; Mul 248 240; Add 1 0; Mul 186 354; Sub 1 0; Mul 216 356; Sub 220 0; Sub 0 1;
  Mul 3 3; Mul 294 294; Mul 249 249; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 314 294; Mul 261 251; Add 1 0; Mul 197 368; Sub 1 0; Mul 224 370; Sub 228 0; Sub 0 1;
  Mul 3 3; Mul 303 303; Mul 260 260; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 327 304; Mul 274 262; Add 1 0; Mul 208 382; Sub 1 0; Mul 232 384; Sub 236 0; Sub 0 1;
  Mul 3 3; Mul 313 313; Mul 271 271; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 340 313; Mul 287 273; Add 1 0; Mul 219 396; Sub 1 0; Mul 240 398; Sub 244 0; Sub 0 1;
  Mul 3 3; Mul 322 322; Mul 282 282; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 353 323; Mul 300 284; Add 1 0; Mul 230 410; Sub 1 0; Mul 248 412; Sub 252 0; Sub 0 1;
  Mul 3 3; Mul 332 332; Mul 293 293; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Sub 360 356; Sub 361 311; Mul 1 1; Mul 1 1; Add 1 0; Add 371 370; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 364 359; Sub 319 316; Mul 1 1; Mul 1 1; Add 1 0; Add 378 377; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 367 363; Sub 324 321; Mul 1 1; Mul 1 1; Add 1 0; Add 385 384; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 371 251; Sub 329 249; Mul 1 1; Mul 1 1; Add 1 0; Add 392 391; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 259 260; Sub 257 258; Mul 1 1; Mul 1 1; Add 1 0; Add 399 398; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 207 207; Mul 207 207; Add 1 0; Add 404 409; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 253 253; Mul 253 253; Add 1 0; Mul 414 414; Mul 416 416; Sub 1 0; Sub 3 0; Mul 256 256;
  Mul 256 256; Add 1 0; Mul 420 420; Sub 0 6; Sub 2 0; Mul 250 250; Mul 250 250; Add 1 0;
  Mul 425 425; Sub 0 12; Sub 2 0; Mul 267 0; Mul 7 256; Sub 1 0; Mul 9 259; Mul 272 4; Sub 1 0;
  Mul 274 261; Mul 274 263; Sub 1 0; Mul 281 6; Mul 281 4; Add 1 0; Mul 24 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 258 258; Mul 258 258; Add 1 0; Mul 444 444; Sub 0 32; Sub 2 0; Mul 287 0; Mul 27 264;
  Sub 1 0; Mul 29 267; Mul 292 4; Sub 1 0; Mul 294 269; Mul 294 271; Sub 1 0; Mul 301 6;
  Mul 301 4; Add 1 0; Mul 44 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 460 460; Sub 0 49; Sub 58 0; Mul 304 0; Mul 44 269; Sub 1 0; Mul 46 272; Mul 309 4; Sub 1 0;
  Mul 311 274; Mul 311 276; Sub 1 0; Mul 318 6; Mul 318 4; Add 1 0; Mul 61 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Add 311 315; Add 477 0; Add 301 305; Add 1 0; Add 291 295; Add 1 0; Add 281 285; Add 1 0;
  Constant 4; Div 546 0; Mul 2 0;
  ShowZero 0 (* area(F, S) *)
].

Theorem part_1_size_6_valid : valid part_1_size_6.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face with k corners; size 8.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/net/i_isothermic.rs, src/net/scribed.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/oriented_circle.rs,
    src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_8 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Sub 1 0;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 1; Mul 2 3; Add 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 2; Sub 0 5;
  Nonzero 0; (* no edge has length 0 *)
  Sub 1 7;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 8 2; Add 6 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 3; Sub 0 11;
  Nonzero 0; (* no edge has length 0 *)
  Sub 1 6;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 7 2; Add 11 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 4; Sub 0 5;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 6 1; Add 15 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 5; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 19 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 6; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 23 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 7; Sub 0 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 1; Add 27 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Sub 30 3;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 4 31; Add 30 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Div 31 29; Sub 32 31; Mul 0 1; Mul 35 2; Div 35 28; Sub 36 30; Mul 0 1; Mul 33 2; Div 39 27;
  Sub 40 29; Mul 0 1; Mul 32 2; Div 43 27; Sub 44 29; Mul 0 1; Mul 32 2; Div 47 27; Sub 48 29;
  Mul 0 1; Mul 32 2; Div 51 27; Sub 52 29; Mul 0 1; Mul 32 2; Div 55 27; Sub 56 29; Mul 0 1;
  Mul 32 2; Div 59 28; Sub 60 30; Mul 0 1; Mul 33 2; Unknown 8; Add 30 0; Add 27 1; Add 24 2;
  Add 21 3; Add 18 4; Add 15 5; Add 12 6; Add 9 7; Div 72 37; Div 73 34; Div 74 31; Div 75 28;
  Div 76 25; Div 77 22; Div 78 19; Div 79 16; Constant 0; Sub 15 16; Mul 9 8; Mul 1 0; Add 3 0;
  Sub 18 19; Mul 12 11; Neg 0; Mul 2 0; Add 4 0; Sub 22 23; Mul 16 15; Mul 1 0; Add 3 0;
  Sub 25 26; Mul 19 18; Neg 0; Mul 2 0; Add 4 0; Sub 29 30; Mul 23 22; Mul 1 0; Add 3 0;
  Sub 32 33; Mul 26 25; Neg 0; Mul 2 0; Add 4 0; Sub 36 37; Mul 30 29; Mul 1 0; Add 3 0;
  Sub 47 40; Mul 33 40; Neg 0; Mul 2 0; Add 4 0; Sub 0 36;
  ShowZero 0; (* as a test finds *)
  Add 120 121; Mul 0 87; Add 123 117; Mul 0 85; Add 119 114; Mul 0 83; Add 116 111; Mul 0 81;
  Add 113 109; Mul 0 79; Add 111 107; Mul 0 77; Add 109 105; Mul 0 75; Add 107 134; Mul 0 73;
  Unknown 9; Add 15 0; Add 14 1; Add 13 2; Add 12 3; Add 11 4; Add 10 5; Add 9 6; Add 8 7;
  Sub 6 7; Mul 0 61; Add 64 0; Sub 8 9; Mul 0 59; Add 2 0; Sub 10 11; Mul 0 58; Add 2 0;
  Sub 12 13; Mul 0 56; Add 2 0; Sub 14 15; Mul 0 55; Add 2 0; Sub 16 17; Mul 0 53; Add 2 0;
  Sub 18 19; Mul 0 52; Add 2 0; Sub 28 21; Mul 0 50; Add 2 0; Sub 0 86;
  ShowZero 0; (* as a test finds *)
  Mul 103 103; Mul 33 33; Add 1 0; Mul 136 136; Sub 1 0; Div 173 177; Mul 1 0; Mul 109 109;
  Mul 39 39; Add 1 0; Mul 139 139; Sub 1 0; Mul 0 6; Mul 114 114; Mul 44 44; Add 1 0; Mul 141 141;
  Sub 1 0; Mul 0 12; Mul 119 119; Mul 49 49; Add 1 0; Mul 143 143; Sub 1 0; Mul 0 18; Mul 124 124;
  Mul 54 54; Add 1 0; Mul 145 145; Sub 1 0; Mul 0 24; Mul 129 129; Mul 59 59; Add 1 0;
  Mul 147 147; Sub 1 0; Mul 0 30; Mul 134 134; Mul 64 64; Add 1 0; Mul 149 149; Sub 1 0; Mul 0 36;
  Mul 139 139; Mul 69 69; Add 1 0; Mul 151 151; Sub 1 0; Mul 0 42; Sub 36 42; Mul 0 135;
  Add 138 0; Sub 33 39; Mul 0 133; Add 2 0; Sub 30 36; Mul 0 132; Add 2 0; Sub 27 33; Mul 0 130;
  Add 2 0; Sub 24 30; Mul 0 129; Add 2 0; Sub 21 27; Mul 0 127; Add 2 0; Sub 18 24; Mul 0 126;
  Add 2 0; Sub 63 21; Mul 0 124; Add 2 0; Sub 0 160;
  ShowZero 0; (* as a test finds *)
  Sub 157 157;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 97 97;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 155 155;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 97 97;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 154 154;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 97 97;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 152 152;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 97 97;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 24 24;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 173 138; Sub 0 144; Sub 0 149; Sub 154 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 177 92; Sub 0 96; Sub 0 100; Sub 103 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 181 22; Sub 0 26; Sub 0 30; Sub 33 0;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 9 159; Sub 0 11;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 7 108; Sub 0 9;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 5 36; Sub 0 7;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 16 161; Sub 0 18;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 14 111; Sub 0 16;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 12 39; Sub 0 14;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 23 162; Sub 0 198;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 21 114; Sub 0 200;
  ShowZero 0; (* as src/space/point.rs finds *)
  Add 19 42; Sub 0 202;
  ShowZero 0; (* as src/space/point.rs finds *)
  Sub 199 203; Sub 139 204; Sub 219 221; Sub 149 151; Sub 198 207; Sub 140 208; Mul 208 0;
  Mul 147 2; Sub 1 0; Add 212 0; Mul 9 6; Mul 9 8; Sub 1 0; Add 3 0; Sub 230 233; Sub 160 163;
  Sub 206 219; Sub 149 220; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0;
  Add 3 0; Sub 241 245; Sub 171 175; Sub 213 231; Sub 158 232; Mul 15 0; Mul 15 2; Sub 1 0;
  Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0; Sub 252 257; Sub 182 187; Sub 67 243; Sub 64 244;
  Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0; Sub 263 269;
  Sub 193 199; Sub 80 255; Sub 77 256; Mul 15 0; Mul 15 2; Sub 1 0; Add 7 0; Mul 17 6; Mul 17 8;
  Sub 1 0; Add 3 0; Sub 274 281; Sub 204 211; Sub 93 267; Sub 90 268; Mul 15 0; Mul 15 2; Sub 1 0;
  Add 7 0; Mul 17 6; Mul 17 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* as src/construct/christoffel/mod.rs finds *)
  Sub 138 277; Sub 136 278; Mul 75 70; Mul 75 72; Sub 1 0; Div 363 0; Mul 5 74; Mul 79 5; Sub 1 0;
  Mul 0 3; Mul 83 8; Mul 10 80; Sub 1 0; Mul 0 7; Mul 4 291; Mul 1 292; Add 1 0; Sub 294 0;
  Add 1 0; Sub 296 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 293; Mul 7 233; Add 1 0; Add 0 5; Sub 162 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 293; Mul 12 235; Add 1 0; Add 0 10; Sub 164 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 294; Mul 17 237; Add 1 0; Add 0 15; Sub 166 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 25 294; Mul 22 239; Add 1 0; Add 0 20; Sub 168 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 30 141; Mul 27 138; Add 1 0; Add 0 25; Sub 137 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 35 147; Mul 32 144; Add 1 0; Add 0 30; Sub 143 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 40 153; Mul 37 150; Add 1 0; Add 0 35; Sub 149 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 45 348; Mul 42 278; Add 1 0; Sub 241 0; Mul 49 351; Mul 46 281; Add 1 0; Add 0 3; Sub 240 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 54 355; Mul 51 285; Add 1 0; Add 0 8; Sub 239 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 59 359; Mul 56 289; Add 1 0; Add 0 13; Sub 238 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 64 363; Mul 61 293; Add 1 0; Add 0 18; Sub 237 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 69 367; Mul 66 297; Add 1 0; Add 0 23; Sub 236 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 74 371; Mul 71 301; Add 1 0; Add 0 28; Sub 235 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 79 375; Mul 76 305; Add 1 0; Add 0 33; Sub 234 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 387 370; Mul 317 309; Add 1 0; Mul 237 455; Sub 1 0; Mul 282 457; Sub 287 0; Sub 0 1;
  Mul 3 3; Mul 379 379; Mul 318 318; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 400 380; Mul 330 320; Add 1 0; Mul 248 469; Sub 1 0; Mul 290 471; Sub 294 0; Sub 0 1;
  Mul 3 3; Mul 389 389; Mul 329 329; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 413 389; Mul 343 331; Add 1 0; Mul 259 483; Sub 1 0; Mul 298 485; Sub 302 0; Sub 0 1;
  Mul 3 3; Mul 398 398; Mul 340 340; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 426 399; Mul 356 342; Add 1 0; Mul 270 497; Sub 1 0; Mul 306 499; Sub 310 0; Sub 0 1;
  Mul 3 3; Mul 408 408; Mul 351 351; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 439 408; Mul 369 353; Add 1 0; Mul 281 511; Sub 1 0; Mul 314 513; Sub 318 0; Sub 0 1;
  Mul 3 3; Mul 417 417; Mul 362 362; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 452 418; Mul 382 364; Add 1 0; Mul 292 525; Sub 1 0; Mul 322 527; Sub 326 0; Sub 0 1;
  Mul 3 3; Mul 427 427; Mul 373 373; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 465 427; Mul 395 375; Add 1 0; Mul 303 539; Sub 1 0; Mul 330 541; Sub 334 0; Sub 0 1;
  Mul 3 3; Mul 436 436; Mul 384 384; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 478 437; Mul 408 386; Add 1 0; Mul 314 553; Sub 1 0; Mul 338 555; Sub 342 0; Sub 0 1;
  Mul 3 3; Mul 446 446; Mul 395 395; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Sub 483 479; Sub 484 419; Mul 1 1; Mul 1 1; Add 1 0; Add 496 495; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 487 482; Sub 427 424; Mul 1 1; Mul 1 1; Add 1 0; Add 503 502; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 490 486; Sub 432 429; Mul 1 1; Mul 1 1; Add 1 0; Add 510 509; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 494 489; Sub 437 434; Mul 1 1; Mul 1 1; Add 1 0; Add 517 516; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 497 339; Sub 442 336; Mul 1 1; Mul 1 1; Add 1 0; Add 524 523; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 347 348; Sub 344 345; Mul 1 1; Mul 1 1; Add 1 0; Add 531 530; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 356 357; Sub 353 354; Mul 1 1; Mul 1 1; Add 1 0; Add 538 537; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 271 271; Mul 271 271; Add 1 0; Add 543 550; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 341 341; Mul 341 341; Add 1 0; Mul 555 555; Mul 557 557; Sub 1 0; Sub 3 0; Mul 344 344;
  Mul 344 344; Add 1 0; Mul 561 561; Sub 0 6; Sub 2 0; Mul 338 338; Mul 338 338; Add 1 0;
  Mul 566 566; Sub 0 12; Sub 2 0; Mul 355 0; Mul 7 344; Sub 1 0; Mul 9 347; Mul 360 4; Sub 1 0;
  Mul 362 349; Mul 362 351; Sub 1 0; Mul 369 6; Mul 369 4; Add 1 0; Mul 24 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 346 346; Mul 346 346; Add 1 0; Mul 585 585; Sub 0 32; Sub 2 0; Mul 375 0; Mul 27 352;
  Sub 1 0; Mul 29 355; Mul 380 4; Sub 1 0; Mul 382 357; Mul 382 359; Sub 1 0; Mul 389 6;
  Mul 389 4; Add 1 0; Mul 44 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 354 354; Mul 354 354; Add 1 0; Mul 604 604; Sub 0 52; Sub 2 0; Mul 395 0; Mul 47 360;
  Sub 1 0; Mul 49 363; Mul 400 4; Sub 1 0; Mul 402 365; Mul 402 367; Sub 1 0; Mul 409 6;
  Mul 409 4; Add 1 0; Mul 64 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 362 362; Mul 362 362; Add 1 0; Mul 623 623; Sub 0 72; Sub 2 0; Mul 415 0; Mul 67 368;
  Sub 1 0; Mul 69 371; Mul 420 4; Sub 1 0; Mul 422 373; Mul 422 375; Sub 1 0; Mul 429 6;
  Mul 429 4; Add 1 0; Mul 84 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 639 639; Sub 0 89; Sub 98 0; Mul 432 0; Mul 84 373; Sub 1 0; Mul 86 376; Mul 437 4; Sub 1 0;
  Mul 439 378; Mul 439 380; Sub 1 0; Mul 446 6; Mul 446 4; Add 1 0; Mul 101 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Add 439 443; Add 656 0; Add 429 433; Add 1 0; Add 419 423; Add 1 0; Add 409 413; Add 1 0;
  Add 399 403; Add 1 0; Add 389 393; Add 1 0; Constant 4; Div 749 0; Mul 2 0;
  ShowZero 0 (* area(F, S) *)
].

Theorem part_1_size_8_valid : valid part_1_size_8.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** four quads around a vertex; size 1.
    Code: src/construct/christoffel/mod.rs, src/construct/christoffel/radii.rs,
    src/net/i_isothermic.rs, src/net/scribed.rs, src/pair/area.rs, src/pair/face.rs,
    src/pair/forms.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/motion.rs,
    src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
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
  Sub 549 176; Sub 170 177; Mul 97 94; Mul 97 96; Sub 1 0; Div 701 0; Mul 5 98; Mul 101 5;
  Sub 1 0; Mul 0 3; Mul 105 8; Mul 10 104; Sub 1 0; Mul 0 7; Mul 4 196; Mul 1 194; Add 1 0;
  Sub 193 0; Add 1 0; Sub 195 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 569; Mul 7 570; Add 1 0; Add 0 5; Sub 573 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 198; Mul 12 197; Add 1 0; Add 0 10; Sub 198 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 197; Mul 17 195; Add 1 0; Add 0 15; Sub 195 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 584 181; Sub 212 182; Mul 108 105; Mul 108 107; Sub 1 0; Div 736 0; Mul 5 109; Mul 112 5;
  Sub 1 0; Mul 0 3; Mul 116 8; Mul 10 115; Sub 1 0; Mul 0 7; Mul 4 201; Mul 1 199; Add 1 0;
  Sub 198 0; Add 1 0; Sub 200 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 604; Mul 7 605; Add 1 0; Add 0 5; Sub 608 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 242; Mul 12 240; Add 1 0; Add 0 10; Sub 240 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 208; Mul 17 207; Add 1 0; Add 0 15; Sub 208 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 619 195; Sub 217 196; Mul 119 116; Mul 119 118; Sub 1 0; Div 771 0; Mul 5 120; Mul 123 5;
  Sub 1 0; Mul 0 3; Mul 127 8; Mul 10 126; Sub 1 0; Mul 0 7; Mul 4 215; Mul 1 213; Add 1 0;
  Sub 212 0; Add 1 0; Sub 214 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 639; Mul 7 640; Add 1 0; Add 0 5; Sub 643 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 247; Mul 12 245; Add 1 0; Add 0 10; Sub 245 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 222; Mul 17 221; Add 1 0; Add 0 15; Sub 222 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 654 274; Sub 231 275; Mul 130 127; Mul 130 129; Sub 1 0; Div 806 0; Mul 5 131; Mul 134 5;
  Sub 1 0; Mul 0 3; Mul 138 8; Mul 10 137; Sub 1 0; Mul 0 7; Mul 4 292; Mul 1 291; Add 1 0;
  Sub 291 0; Add 1 0; Sub 293 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 674; Mul 7 675; Add 1 0; Add 0 5; Sub 678 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 261; Mul 12 259; Add 1 0; Add 0 10; Sub 259 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 245; Mul 17 243; Add 1 0; Add 0 15; Sub 243 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 130 682; Mul 127 682; Add 1 0; Sub 573 0; Add 121 0; Sub 585 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 136 692; Mul 133 692; Add 1 0; Add 0 5; Sub 585 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 141 638; Mul 138 609; Add 1 0; Add 0 10; Sub 579 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 111 686; Mul 108 686; Add 1 0; Sub 511 0; Add 102 0; Sub 601 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 117 704; Mul 114 704; Add 1 0; Add 0 5; Sub 596 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 122 564; Mul 119 537; Add 1 0; Add 0 10; Sub 517 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 92 690; Mul 89 690; Add 1 0; Sub 449 0; Add 83 0; Sub 617 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 98 708; Mul 95 708; Add 1 0; Add 0 5; Sub 534 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 103 502; Mul 100 475; Add 1 0; Add 0 10; Sub 455 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 73 734; Mul 70 734; Add 1 0; Sub 626 0; Add 64 0; Sub 633 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 79 712; Mul 76 712; Add 1 0; Add 0 5; Sub 472 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 84 440; Mul 81 414; Add 1 0; Add 0 10; Sub 399 0;
  ShowZero 0; (* as src/pair/f_parallel.rs finds *)
  Mul 746 744; Mul 746 744; Add 1 0; Mul 630 903; Sub 1 0; Mul 639 905; Sub 642 0; Sub 0 1;
  Mul 3 3; Mul 753 753; Mul 753 753; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 767 697; Mul 768 673; Add 1 0; Mul 641 917; Sub 1 0; Mul 663 919; Sub 667 0; Sub 0 1;
  Mul 3 3; Mul 706 706; Mul 682 682; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 778 706; Mul 778 684; Add 1 0; Mul 652 931; Sub 1 0; Mul 672 933; Sub 675 0; Sub 0 1;
  Mul 3 3; Mul 715 715; Mul 693 693; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 733 716; Mul 704 695; Add 1 0; Mul 663 945; Sub 1 0; Mul 675 947; Sub 679 0; Sub 0 1;
  Mul 3 3; Mul 725 725; Mul 704 704; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 790 788; Mul 790 788; Add 1 0; Mul 608 959; Sub 1 0; Mul 617 961; Sub 620 0; Sub 0 1;
  Mul 3 3; Mul 797 797; Mul 797 797; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 816 660; Mul 816 638; Add 1 0; Mul 616 973; Sub 1 0; Mul 0 0; Mul 666 666; Mul 644 644;
  Add 1 0; Mul 0 71; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 682 666; Mul 655 646; Add 1 0; Mul 624 984; Sub 1 0; Mul 636 986; Sub 640 0; Sub 0 1;
  Mul 3 3; Mul 675 675; Mul 655 655; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 817 815; Mul 817 815; Add 1 0; Mul 569 998; Sub 1 0; Mul 578 1000; Sub 581 0; Sub 0 1;
  Mul 3 3; Mul 824 824; Mul 824 824; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 843 621; Mul 843 599; Add 1 0; Mul 577 1012; Sub 1 0; Mul 0 0; Mul 627 627; Mul 605 605;
  Add 1 0; Mul 0 54; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 643 628; Mul 616 607; Add 1 0; Mul 585 1023; Sub 1 0; Mul 597 1025; Sub 601 0; Sub 0 1;
  Mul 3 3; Mul 637 637; Mul 616 616; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 856 569; Mul 856 547; Add 1 0; Mul 530 1037; Sub 1 0; Mul 0 0; Mul 575 575; Mul 553 553;
  Add 1 0; Mul 0 40; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Mul 590 575; Mul 564 555; Add 1 0; Mul 538 1048; Sub 1 0; Mul 550 1050; Sub 554 0; Sub 0 1;
  Mul 3 3; Mul 584 584; Mul 564 564; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* touches Σ *)
  Sub 545 912; Sub 543 913; Mul 1 1; Mul 1 1; Add 1 0; Add 852 854; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 394 394; Mul 394 394; Add 1 0; Add 860 859; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 550 544; Sub 549 542; Mul 1 1; Mul 1 1; Add 1 0; Add 867 865; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 466 466; Mul 466 466; Add 1 0; Add 871 872; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 543 940; Sub 541 941; Mul 1 1; Mul 1 1; Add 1 0; Add 792 882; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 581 542; Sub 579 541; Mul 1 1; Mul 1 1; Add 1 0; Add 888 799; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 464 464; Mul 464 464; Add 1 0; Add 805 806; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 544 962; Sub 542 963; Mul 1 1; Mul 1 1; Add 1 0; Add 736 904; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 573 543; Sub 571 542; Mul 1 1; Mul 1 1; Add 1 0; Add 822 743; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 462 462; Mul 462 462; Add 1 0; Add 749 750; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Sub 566 545; Sub 564 543; Mul 1 1; Mul 1 1; Add 1 0; Add 758 680; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 452 452; Mul 452 452; Add 1 0; Add 686 931; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching circles *)
  Mul 544 544; Mul 544 544; Add 1 0; Mul 938 938; Mul 937 937; Sub 1 0; Sub 3 0; Mul 549 549;
  Mul 549 549; Add 1 0; Mul 944 944; Sub 0 6; Sub 2 0; Mul 945 945; Sub 0 9; Sub 76 0; Mul 557 0;
  Mul 4 546; Sub 1 0; Mul 6 549; Mul 562 4; Sub 1 0; Mul 564 551; Mul 564 553; Sub 1 0; Mul 569 6;
  Mul 569 4; Add 1 0; Mul 21 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 550 550; Mul 550 550; Add 1 0; Mul 878 878; Sub 30 0; Sub 2 0; Mul 554 554; Mul 554 554;
  Add 1 0; Sub 34 5; Sub 1 0; Mul 885 885; Sub 0 8; Sub 82 0; Mul 561 0; Mul 4 550; Sub 1 0;
  Mul 6 553; Mul 566 4; Sub 1 0; Mul 568 555; Mul 568 557; Sub 1 0; Mul 573 6; Mul 573 4; Add 1 0;
  Mul 20 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 554 554; Mul 554 554; Add 1 0; Mul 828 828; Sub 58 0; Sub 2 0; Mul 558 558; Mul 558 558;
  Add 1 0; Sub 33 5; Sub 1 0; Mul 835 835; Sub 0 8; Sub 88 0; Mul 565 0; Mul 4 554; Sub 1 0;
  Mul 6 557; Mul 570 4; Sub 1 0; Mul 572 559; Mul 572 561; Sub 1 0; Mul 577 6; Mul 577 4; Add 1 0;
  Mul 20 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Sub 82 75; Sub 162 0; Mul 558 558; Mul 558 558; Add 1 0; Sub 29 80; Sub 1 0; Mul 782 782;
  Sub 0 83; Sub 98 0; Mul 565 0; Mul 4 554; Sub 1 0; Mul 6 557; Mul 570 4; Sub 1 0; Mul 572 559;
  Mul 572 561; Sub 1 0; Mul 577 6; Mul 577 4; Add 1 0; Mul 20 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Add 644 648; Add 1109 0; Add 634 638; Add 1 0; Constant 4; Div 1260 0; Mul 2 0;
  ShowZero 0; (* area(F, S) *)
  Add 1115 561; Add 0 93; Mul 1106 650; Mul 1106 652; Sub 1 0; Add 1104 0; Mul 4 1248; Mul 1 1249;
  Mul 1270 1256; Mul 0 1259; Mul 0 1259; Mul 0 1148; Mul 4 13; Mul 6 14; Mul 0 2; Add 2 0;
  ShowZero 0; (* K(F) *)
  Add 643 647; Add 1132 0; Add 633 637; Add 1 0; Mul 0 21;
  ShowZero 0; (* area(F, S) *)
  Add 1136 547; Add 0 86; Mul 1115 647; Mul 1115 649; Sub 1 0; Add 1113 0; Mul 4 1269; Mul 1 1270;
  Mul 1291 1276; Mul 0 1280; Mul 0 1279; Mul 0 1162; Mul 4 34; Mul 6 35; Mul 0 2; Add 2 0;
  ShowZero 0; (* K(F) *)
  Add 640 644; Add 1153 0; Add 630 634; Add 1 0; Mul 0 42;
  ShowZero 0; (* area(F, S) *)
  Add 1157 533; Add 0 79; Mul 1124 644; Mul 1124 646; Sub 1 0; Add 1122 0; Mul 4 1290; Mul 1 1291;
  Mul 1312 1296; Mul 0 1301; Mul 0 1299; Mul 0 1176; Mul 4 55; Mul 6 56; Mul 0 2; Add 2 0;
  ShowZero 0; (* K(F) *)
  Add 637 641; Add 1174 0; Add 627 631; Add 1 0; Mul 0 63;
  ShowZero 0; (* area(F, S) *)
  Add 1178 519; Add 0 76; Mul 1137 641; Mul 1137 643; Sub 1 0; Add 1135 0; Mul 4 1311; Mul 1 1312;
  Mul 1333 1320; Mul 0 1322; Mul 0 1319; Mul 0 1190; Mul 4 76; Mul 6 77; Mul 0 2; Add 2 0;
  ShowZero 0 (* K(F) *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
