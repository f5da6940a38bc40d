(** laguerre-group (Sec. 2.2)

    The maps S ↦ a + R S with RᵀDR = D keep the contact of oriented spheres and the tangency of
    planes and spheres, and they form a group. In the isotropic model they are the
    i-M-transformations; offsetting by d is z ↦ z + d(1 + |x'|²)/2.

        RᵀDR = D,  D = diag(1, 1, 1, −1)

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** contact, tangency; size 1.
    Code: src/space/laguerre/plane.rs, src/space/laguerre/sphere.rs,
    src/space/laguerre/transformation.rs, src/space/point.rs, src/space/similarity.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Mul 3 3; Mul 3 3; Add 1 0; Mul 4 4; Add 1 0;
  Mul 5 5; Sub 1 0;
  Nonzero 0; (* the vector of the reflection has a length *)
  Unknown 4; Unknown 5; Constant 1; Mul 2 2; Mul 2 2; Add 1 0; Add 3 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Neg 14; Mul 15 0; Add 11 0; Div 7 0; Constant 0; Mul 0 22; Mul 1 22; Add 1 0; Mul 3 23; Add 1 0;
  Mul 5 9; Add 1 0; Mul 0 8; Constant 2; Mul 1 0; Mul 0 32; Sub 11 0; Mul 2 33; Sub 13 0;
  Mul 4 34; Sub 15 0; Mul 6 35; Sub 17 0; Mul 27 40; Add 0 17; Add 0 16; Add 0 15; Mul 0 23;
  Mul 0 14; Mul 0 46; Sub 34 0; Mul 2 47; Sub 27 0; Mul 4 48; Sub 29 0; Mul 6 49; Sub 31 0;
  Sub 6 20; Sub 5 19; Sub 4 18; Sub 3 17; Mul 45 57; Add 36 0; Add 0 34; Add 0 33; Mul 0 41;
  Mul 0 32; Mul 0 64; Sub 43 0; Mul 2 65; Sub 54 0; Mul 4 66; Sub 47 0; Mul 6 67; Sub 49 0;
  Sub 6 38; Sub 5 37; Sub 4 36; Sub 3 35; Mul 63 74; Add 52 0; Add 0 50; Mul 0 58; Mul 0 49;
  Mul 0 81; Sub 60 0; Mul 2 82; Sub 62 0; Mul 4 83; Sub 73 0; Mul 6 84; Sub 66 0; Sub 6 55;
  Sub 5 54; Sub 4 53; Sub 3 52; Mul 80 75; Add 67 0; Mul 0 74; Mul 0 65; Mul 0 97; Sub 76 0;
  Mul 2 98; Sub 78 0; Mul 4 99; Sub 80 0; Mul 6 100; Sub 91 0; Sub 6 71; Sub 5 70; Sub 4 69;
  Sub 3 68; Mul 87 54; Mul 88 54; Add 1 0; Mul 90 55; Add 1 0; Mul 101 56; Add 1 0; Mul 94 43;
  Mul 95 43; Add 1 0; Mul 97 44; Add 1 0; Mul 108 45; Add 1 0; Mul 101 33; Mul 102 33; Add 1 0;
  Mul 104 34; Add 1 0; Mul 115 35; Add 1 0; Mul 108 24; Mul 109 24; Add 1 0; Mul 111 25; Add 1 0;
  Mul 122 26; Add 1 0; Div 124 120; Mul 107 0; Mul 128 0; Mul 128 1; Sub 128 125; Mul 0 4;
  Mul 27 3; Mul 21 3; Add 1 0; Mul 16 3; Add 1 0; Mul 11 135; Add 1 0;
  Nonzero 0; (* an isotropic vector has a last coordinate, as in ordered fields *)
  ShowNonzero 137; (* as src/space/similarity.rs finds *)
  Mul 137 95; Add 0 40; Add 0 39; Mul 131 95; Add 1 0; Mul 142 99; Add 46 0; Add 0 44; Add 0 4;
  Mul 146 102; Add 48 0; Add 0 7; Neg 46; Mul 8 8; Mul 5 5; Add 1 0; Mul 4 4; Add 1 0; Mul 52 5;
  Add 1 0; Neg 148; Mul 158 158; Mul 150 150; Add 1 0; Add 0 1; Mul 153 4; Add 1 0; Mul 0 164;
  Sub 8 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Mul 166 106; Add 0 62; Add 0 61; Mul 160 106; Add 1 0; Mul 171 110; Add 68 0; Add 0 66; Add 0 4;
  Mul 175 113; Add 70 0; Add 0 7; Neg 68; Mul 37 8; Mul 34 5; Add 1 0; Mul 33 4; Add 1 0;
  Mul 81 5; Add 1 0; Mul 186 177; Mul 178 187; Add 1 0; Add 0 29; Add 0 27; Mul 0 191; Sub 6 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Mul 193 116; Add 0 82; Add 0 81; Mul 187 116; Add 1 0; Mul 198 120; Add 88 0; Add 0 86; Add 0 4;
  Mul 202 123; Add 90 0; Add 0 7; Neg 88; Mul 64 8; Mul 61 5; Add 1 0; Mul 60 4; Add 1 0;
  Mul 108 5; Add 1 0; Add 26 53; Add 0 26; Add 0 52; Mul 0 216; Sub 4 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Mul 218 125; Add 0 100; Add 0 99; Mul 212 125; Add 1 0; Mul 223 129; Add 106 0; Add 0 104;
  Add 0 4; Mul 227 132; Add 108 0; Add 0 7; Neg 106; Mul 89 8; Mul 86 5; Add 1 0; Mul 85 4;
  Add 1 0; Mul 133 5; Add 1 0; Neg 238; Add 25 79; Mul 231 1; Add 1 0; Mul 0 242; Sub 5 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Mul 73 73; Mul 70 70; Add 1 0; Mul 69 69; Add 1 0; Mul 139 70; Add 1 0; Add 91 92; Add 0 92;
  Add 0 90; Mul 0 254; Sub 4 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Mul 85 58; Mul 82 55; Add 1 0; Mul 81 54; Add 1 0; Mul 151 55; Add 1 0; Add 103 76; Add 0 76;
  Add 0 102; Mul 0 266; Sub 4 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Mul 97 45; Mul 94 42; Add 1 0; Mul 93 41; Add 1 0; Mul 163 42; Add 1 0; Add 11 115; Add 0 35;
  Mul 0 277; Sub 3 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Mul 81 81; Mul 78 78; Add 1 0; Mul 77 77; Add 1 0; Mul 167 78; Add 1 0; Add 126 126; Add 0 128;
  Add 0 125; Mul 0 289; Sub 4 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Mul 93 68; Mul 90 65; Add 1 0; Mul 89 64; Add 1 0; Mul 179 65; Add 1 0; Add 11 111; Add 0 58;
  Mul 0 300; Sub 3 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Mul 79 79; Mul 76 76; Add 1 0; Mul 75 75; Add 1 0; Mul 183 76; Add 1 0; Add 22 149; Mul 310 71;
  Add 1 0; Mul 0 312; Sub 4 0;
  ShowZero 0; (* as src/space/similarity.rs finds *)
  Unknown 6; Unknown 7; Unknown 8; Unknown 9; Mul 318 297; Mul 310 296; Add 1 0; Mul 312 296;
  Add 1 0; Mul 314 296; Add 1 0; Mul 316 304; Mul 326 303; Add 1 0; Add 0 6; Add 0 5; Add 4 10;
  Mul 331 306; Add 1 0; Add 0 9; Add 3 12; Mul 335 308; Add 1 0; Add 12 22; Add 8 22; Add 5 22;
  Add 3 22; Unknown 10; Unknown 11; Unknown 12; Unknown 13; Unknown 14; Unknown 15; Unknown 16;
  Unknown 17; Mul 207 7; Mul 179 7; Add 1 0; Mul 154 8; Add 1 0; Mul 131 9; Add 1 0; Mul 210 14;
  Mul 182 14; Add 1 0; Mul 157 15; Add 1 0; Mul 134 16; Add 1 0; Mul 214 21; Mul 186 21; Add 1 0;
  Mul 161 22; Add 1 0; Mul 138 23; Add 1 0; Mul 267 28; Mul 261 28; Add 1 0; Mul 256 29; Add 1 0;
  Mul 251 30; Add 1 0; Add 21 39; Add 15 39; Add 9 39; Add 3 39; Mul 239 35; Mul 211 35; Add 1 0;
  Mul 186 36; Add 1 0; Mul 163 37; Add 1 0; Mul 242 42; Mul 214 42; Add 1 0; Mul 189 43; Add 1 0;
  Mul 166 44; Add 1 0; Mul 246 49; Mul 218 49; Add 1 0; Mul 193 50; Add 1 0; Mul 170 51; Add 1 0;
  Mul 299 56; Mul 293 56; Add 1 0; Mul 288 57; Add 1 0; Mul 283 58; Add 1 0; Add 21 71; Add 15 71;
  Add 9 71; Add 3 71; Sub 35 3; Sub 35 3; Sub 35 3; Sub 35 3; Mul 3 3; Mul 3 3; Add 1 0; Mul 4 4;
  Add 1 0; Mul 5 5; Sub 1 0; Sub 82 78; Sub 82 78; Sub 82 78; Sub 82 78; Mul 3 3; Mul 3 3;
  Add 1 0; Mul 4 4; Add 1 0; Mul 5 5; Sub 1 0; Sub 11 0;
  ShowZero 0; (* contact *)
  Unknown 18; Mul 0 311; Mul 296 311; Mul 268 311; Add 1 0; Mul 243 311; Add 1 0; Mul 220 443;
  Add 1 0; Mul 299 318; Mul 271 318; Add 1 0; Mul 246 318; Add 1 0; Mul 223 450; Add 1 0;
  Mul 303 325; Mul 275 325; Add 1 0; Mul 250 325; Add 1 0; Mul 227 457; Add 1 0; Mul 459 21;
  Neg 119; Mul 16 123; Mul 10 123; Add 1 0; Mul 5 124; Add 1 0; Mul 329 5; Add 1 0; Sub 8 0;
  Div 469 332; Mul 25 0; Mul 19 1; Mul 13 2; Mul 4 3; Mul 3 96; Mul 3 96; Add 1 0; Mul 4 97;
  Add 1 0; Add 0 5; Sub 0 99; Mul 0 344; Mul 355 140; Mul 355 140; Add 1 0; Mul 355 141; Add 1 0;
  Add 0 49; Sub 0 143; Sub 7 0;
  ShowZero 0; (* tangency *)
  Mul 19 19; Mul 19 19; Add 1 0; Mul 20 20; Add 1 0; Sub 0 495;
  ShowZero 0 (* a unit normal *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** products, inverses; size 1.
    Code: src/space/laguerre/transformation.rs, src/space/similarity.rs *)
Definition part_2_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Mul 3 3; Mul 3 3; Add 1 0; Mul 4 4; Add 1 0;
  Mul 5 5; Sub 1 0;
  Nonzero 0; (* the vector of the reflection has a length *)
  Unknown 4; Unknown 5; Unknown 6; Unknown 7; Mul 3 3; Mul 3 3; Add 1 0; Mul 4 4; Add 1 0;
  Mul 5 5; Sub 1 0;
  Nonzero 0; (* the vector of the reflection has a length *)
  Unknown 8; Unknown 9; Unknown 10; Unknown 11; Neg 22; Mul 23 0; Add 19 0; Constant 1; Div 0 1;
  Constant 0; Mul 0 31; Mul 1 31; Add 1 0; Mul 3 32; Add 1 0; Mul 5 10; Add 1 0; Mul 0 8;
  Constant 2; Mul 1 0; Mul 0 41; Sub 11 0; Mul 2 42; Sub 13 0; Mul 4 43; Sub 15 0; Mul 6 44;
  Sub 17 0; Mul 20 49; Add 0 17; Add 0 16; Add 0 15; Mul 0 23; Mul 0 14; Mul 0 55; Sub 27 0;
  Mul 2 56; Sub 27 0; Mul 4 57; Sub 29 0; Mul 6 58; Sub 31 0; Sub 6 20; Sub 5 19; Sub 4 18;
  Sub 3 17; Mul 38 66; Add 36 0; Add 0 34; Add 0 33; Mul 0 41; Mul 0 32; Mul 0 73; Sub 43 0;
  Mul 2 74; Sub 47 0; Mul 4 75; Sub 47 0; Mul 6 76; Sub 49 0; Sub 6 38; Sub 5 37; Sub 4 36;
  Sub 3 35; Mul 56 83; Add 52 0; Add 0 50; Mul 0 58; Mul 0 49; Mul 0 90; Sub 60 0; Mul 2 91;
  Sub 62 0; Mul 4 92; Sub 66 0; Mul 6 93; Sub 66 0; Sub 6 55; Sub 5 54; Sub 4 53; Sub 3 52;
  Mul 73 76; Add 67 0; Mul 0 74; Mul 0 65; Mul 0 106; Sub 76 0; Mul 2 107; Sub 78 0; Mul 4 108;
  Sub 80 0; Mul 6 109; Sub 84 0; Sub 6 71; Sub 5 70; Sub 4 69; Sub 3 68; Mul 89 54; Mul 88 54;
  Add 1 0; Mul 90 55; Add 1 0; Mul 92 56; Add 1 0; Mul 94 61; Mul 97 61; Add 1 0; Add 0 6;
  Add 0 5; Add 4 10; Mul 102 65; Add 1 0; Add 0 9; Add 3 12; Mul 106 68; Add 1 0; Mul 108 55;
  Mul 107 55; Add 1 0; Mul 109 56; Add 1 0; Mul 111 57; Add 1 0; Mul 113 62; Mul 116 62; Add 1 0;
  Add 0 6; Add 0 5; Add 4 10; Mul 121 66; Add 1 0; Add 0 9; Add 3 12; Mul 125 69; Add 1 0;
  Mul 127 57; Mul 126 57; Add 1 0; Mul 128 58; Add 1 0; Mul 130 59; Add 1 0; Mul 132 64;
  Mul 135 64; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 140 68; Add 1 0; Add 0 9; Add 3 12;
  Mul 144 71; Add 1 0; Mul 146 60; Mul 145 60; Add 1 0; Mul 147 61; Add 1 0; Mul 149 62; Add 1 0;
  Mul 151 67; Mul 154 67; Add 1 0; Add 0 6; Add 0 5; Add 4 10; Mul 159 71; Add 1 0; Add 0 9;
  Add 3 12; Mul 163 74; Add 1 0; Mul 165 151; Mul 164 150; Add 1 0; Mul 166 150; Add 1 0;
  Mul 168 150; Add 1 0; Mul 170 158; Mul 173 157; Add 1 0; Add 0 6; Add 0 5; Add 4 10;
  Mul 178 160; Add 1 0; Add 0 9; Add 3 12; Mul 182 162; Add 1 0; Add 12 191; Add 8 191; Add 5 191;
  Add 3 191; Unknown 12; Neg 204; Mul 205 0; Add 201 0; Div 192 0; Mul 191 211; Mul 192 211;
  Add 1 0; Mul 194 212; Add 1 0; Mul 196 8; Add 1 0; Mul 0 7; Mul 0 190; Mul 0 220; Sub 201 0;
  Mul 2 221; Sub 203 0; Mul 4 222; Sub 205 0; Mul 6 223; Sub 207 0; Mul 210 228; Add 0 16;
  Add 0 15; Add 0 14; Mul 0 21; Mul 0 204; Mul 0 234; Sub 217 0; Mul 2 235; Sub 217 0; Mul 4 236;
  Sub 219 0; Mul 6 237; Sub 221 0; Sub 6 20; Sub 5 19; Sub 4 18; Sub 3 17; Mul 228 245; Add 35 0;
  Add 0 33; Add 0 32; Mul 0 39; Mul 0 222; Mul 0 252; Sub 233 0; Mul 2 253; Sub 237 0; Mul 4 254;
  Sub 237 0; Mul 6 255; Sub 239 0; Sub 6 38; Sub 5 37; Sub 4 36; Sub 3 35; Mul 246 262; Add 51 0;
  Add 0 49; Mul 0 56; Mul 0 239; Mul 0 269; Sub 250 0; Mul 2 270; Sub 252 0; Mul 4 271; Sub 256 0;
  Mul 6 272; Sub 256 0; Sub 6 55; Sub 5 54; Sub 4 53; Sub 3 52; Mul 263 73; Add 66 0; Mul 0 72;
  Mul 0 255; Mul 0 285; Sub 266 0; Mul 2 286; Sub 268 0; Mul 4 287; Sub 270 0; Mul 6 288;
  Sub 274 0; Sub 6 71; Sub 5 70; Sub 4 69; Sub 3 68; Mul 279 54; Mul 278 54; Add 1 0; Mul 280 55;
  Add 1 0; Mul 282 56; Add 1 0; Mul 286 43; Mul 285 43; Add 1 0; Mul 287 44; Add 1 0; Mul 289 45;
  Add 1 0; Mul 293 33; Mul 292 33; Add 1 0; Mul 294 34; Add 1 0; Mul 296 35; Add 1 0; Mul 300 24;
  Mul 299 24; Add 1 0; Mul 301 25; Add 1 0; Mul 303 26; Add 1 0; Mul 307 103; Mul 306 102;
  Add 1 0; Mul 308 102; Add 1 0; Mul 310 102; Add 1 0; Add 0 125; Unknown 13; Unknown 14;
  Unknown 15; Unknown 16; Mul 33 223; Mul 27 219; Add 1 0; Mul 22 217; Add 1 0; Mul 17 216;
  Add 1 0; Mul 40 211; Mul 34 207; Add 1 0; Mul 29 205; Add 1 0; Mul 24 204; Add 1 0; Mul 47 199;
  Mul 41 195; Add 1 0; Mul 36 193; Add 1 0; Mul 31 192; Add 1 0; Mul 54 187; Mul 48 183; Add 1 0;
  Mul 43 181; Add 1 0; Mul 38 180; Add 1 0; Mul 61 162; Mul 55 162; Add 1 0; Mul 50 163; Add 1 0;
  Mul 45 164; Add 1 0; Add 0 39; Mul 259 39; Mul 241 39; Add 1 0; Mul 224 40; Add 1 0; Mul 207 41;
  Add 1 0; Mul 261 46; Mul 243 46; Add 1 0; Mul 226 47; Add 1 0; Mul 209 48; Add 1 0; Mul 264 53;
  Mul 246 53; Add 1 0; Mul 229 54; Add 1 0; Mul 212 55; Add 1 0; Mul 268 60; Mul 250 60; Add 1 0;
  Mul 233 61; Add 1 0; Mul 216 62; Add 1 0; Add 21 198; Add 15 198; Add 9 198; Add 3 198;
  Mul 61 71; Mul 55 71; Add 1 0; Mul 50 72; Add 1 0; Mul 45 73; Add 1 0; Add 0 39; Mul 109 11;
  Mul 103 11; Add 1 0; Mul 98 12; Add 1 0; Mul 93 13; Add 1 0; Add 0 87; Sub 8 0;
  ShowZero 0; (* one after the other *)
  Unknown 17; Mul 403 180; Mul 406 180; Add 1 0; Add 0 125; Add 0 124; Mul 408 167; Mul 411 167;
  Add 1 0; Add 0 123; Add 0 122; Mul 413 155; Mul 416 155; Add 1 0; Add 0 121; Add 0 120;
  Mul 418 144; Mul 421 144; Add 1 0; Add 0 119; Add 0 118; Mul 423 221; Mul 426 220; Add 1 0;
  Add 0 117; Add 0 116; Add 0 25; Mul 21 335; Mul 17 331; Add 1 0; Mul 14 329; Add 1 0;
  Mul 11 328; Add 1 0; Mul 28 323; Mul 24 319; Add 1 0; Mul 21 317; Add 1 0; Mul 18 316; Add 1 0;
  Mul 35 311; Mul 31 307; Add 1 0; Mul 28 305; Add 1 0; Mul 25 304; Add 1 0; Mul 42 299;
  Mul 38 295; Add 1 0; Mul 35 293; Add 1 0; Mul 32 292; Add 1 0; Mul 49 274; Mul 45 274; Add 1 0;
  Mul 42 275; Add 1 0; Mul 39 276; Add 1 0; Add 0 35; Mul 29 151; Mul 23 151; Add 1 0; Mul 18 152;
  Add 1 0; Mul 13 153; Add 1 0; Add 0 7; Mul 65 91; Mul 61 91; Add 1 0; Mul 58 92; Add 1 0;
  Mul 55 93; Add 1 0; Add 0 51; Sub 8 0;
  ShowZero 0; (* one after the other *)
  Unknown 18; Add 79 204; Mul 486 259; Add 1 0; Add 0 203; Add 78 201; Mul 490 245; Add 1 0;
  Add 0 200; Add 77 198; Mul 494 232; Add 1 0; Add 0 197; Add 76 195; Mul 498 220; Add 1 0;
  Add 0 194; Add 75 192; Mul 502 294; Add 1 0; Add 0 191; Add 0 20; Mul 17 410; Mul 14 406;
  Add 1 0; Mul 12 404; Add 1 0; Mul 10 403; Add 1 0; Mul 24 398; Mul 21 394; Add 1 0; Mul 19 392;
  Add 1 0; Mul 17 391; Add 1 0; Mul 31 386; Mul 28 382; Add 1 0; Mul 26 380; Add 1 0; Mul 24 379;
  Add 1 0; Mul 38 374; Mul 35 370; Add 1 0; Mul 33 368; Add 1 0; Mul 31 367; Add 1 0; Mul 45 349;
  Mul 42 349; Add 1 0; Mul 40 350; Add 1 0; Mul 38 351; Add 1 0; Add 0 35; Mul 29 226; Mul 23 226;
  Add 1 0; Mul 18 227; Add 1 0; Mul 13 228; Add 1 0; Add 0 7; Mul 61 166; Mul 58 166; Add 1 0;
  Mul 56 167; Add 1 0; Mul 54 168; Add 1 0; Add 0 51; Sub 8 0;
  ShowZero 0; (* one after the other *)
  Unknown 19; Add 74 277; Mul 561 333; Add 1 0; Add 73 273; Mul 564 318; Add 1 0; Add 72 269;
  Mul 567 304; Add 1 0; Add 71 265; Mul 570 291; Add 1 0; Add 70 261; Mul 573 363; Add 1 0;
  Add 0 15; Mul 13 480; Mul 11 476; Add 1 0; Mul 10 474; Add 1 0; Mul 9 473; Add 1 0; Mul 20 468;
  Mul 18 464; Add 1 0; Mul 17 462; Add 1 0; Mul 16 461; Add 1 0; Mul 27 456; Mul 25 452; Add 1 0;
  Mul 24 450; Add 1 0; Mul 23 449; Add 1 0; Mul 34 444; Mul 32 440; Add 1 0; Mul 31 438; Add 1 0;
  Mul 30 437; Add 1 0; Mul 41 419; Mul 39 419; Add 1 0; Mul 38 420; Add 1 0; Mul 37 421; Add 1 0;
  Add 0 35; Mul 29 296; Mul 23 296; Add 1 0; Mul 18 297; Add 1 0; Mul 13 298; Add 1 0; Add 0 7;
  Mul 57 236; Mul 55 236; Add 1 0; Mul 54 237; Add 1 0; Mul 53 238; Add 1 0; Add 0 51; Sub 8 0;
  ShowZero 0; (* one after the other *)
  Mul 629 629; Div 630 0; Neg 523; Mul 536 1; Mul 532 2; Mul 529 3; Mul 3 4; Mul 3 451; Mul 3 451;
  Add 1 0; Mul 4 452; Add 1 0; Mul 5 453; Add 1 0; Neg 0; Mul 11 260; Mul 11 260; Add 1 0;
  Mul 12 261; Add 1 0; Mul 13 262; Add 1 0; Add 0 7; Sub 0 336;
  ShowZero 0; (* there and back *)
  Neg 526; Mul 539 23; Mul 535 24; Mul 532 25; Mul 3 26; Mul 3 473; Mul 3 473; Add 1 0; Mul 4 474;
  Add 1 0; Mul 5 475; Add 1 0; Neg 0; Mul 11 282; Mul 11 282; Add 1 0; Mul 12 283; Add 1 0;
  Mul 13 284; Add 1 0; Add 0 7; Sub 0 357;
  ShowZero 0; (* there and back *)
  Neg 529; Mul 542 45; Mul 538 46; Mul 535 47; Mul 3 48; Mul 3 495; Mul 3 495; Add 1 0; Mul 4 496;
  Add 1 0; Mul 5 497; Add 1 0; Neg 0; Mul 11 304; Mul 11 304; Add 1 0; Mul 12 305; Add 1 0;
  Mul 13 306; Add 1 0; Add 0 7; Sub 0 378;
  ShowZero 0; (* there and back *)
  Neg 532; Neg 545; Neg 541; Neg 538; Neg 3; Mul 3 71; Mul 3 72; Mul 3 73; Mul 3 74; Mul 3 521;
  Mul 3 521; Add 1 0; Mul 4 522; Add 1 0; Mul 5 523; Add 1 0; Neg 0; Mul 11 330; Mul 11 330;
  Add 1 0; Mul 12 331; Add 1 0; Mul 13 332; Add 1 0; Add 0 7; Sub 0 403;
  ShowZero 0; (* there and back *)
  Mul 90 407; Mul 90 407; Add 1 0; Mul 91 408; Add 1 0; Mul 92 409; Add 1 0; Mul 75 414;
  Mul 75 414; Add 1 0; Mul 76 415; Add 1 0; Mul 77 416; Add 1 0; Mul 60 421; Mul 60 421; Add 1 0;
  Mul 61 422; Add 1 0; Mul 62 423; Add 1 0; Mul 41 428; Mul 41 428; Add 1 0; Mul 42 429; Add 1 0;
  Mul 43 430; Add 1 0; Add 21 107; Add 15 86; Add 9 65; Add 3 40; Mul 659 3; Mul 641 3; Add 1 0;
  Mul 624 4; Add 1 0; Mul 607 5; Add 1 0; Add 0 577; Sub 0 447;
  ShowZero 0; (* back and there *)
  Mul 663 12; Mul 645 12; Add 1 0; Mul 628 13; Add 1 0; Mul 611 14; Add 1 0; Add 0 585; Sub 0 455;
  ShowZero 0; (* back and there *)
  Mul 668 21; Mul 650 21; Add 1 0; Mul 633 22; Add 1 0; Mul 616 23; Add 1 0; Add 0 593; Sub 0 463;
  ShowZero 0; (* back and there *)
  Mul 674 30; Mul 656 30; Add 1 0; Mul 639 31; Add 1 0; Mul 622 32; Add 1 0; Add 0 601; Sub 0 471;
  ShowZero 0; (* back and there *)
  Mul 791 475; Mul 790 475; Add 1 0; Mul 792 476; Add 1 0; Mul 794 477; Add 1 0; Add 0 796;
  Sub 0 483;
  ShowZero 0; (* the identity *)
  Mul 798 484; Mul 801 484; Add 1 0; Add 0 8; Add 0 7; Add 0 803; Sub 0 489;
  ShowZero 0; (* the identity *)
  Add 6 14; Mul 808 490; Add 1 0; Add 0 13; Add 0 809; Sub 0 494;
  ShowZero 0; (* the identity *)
  Add 5 18; Mul 814 495; Add 1 0; Add 0 814; Sub 0 498;
  ShowZero 0 (* the identity *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** offsets; size 1.
    Code: src/scalar/ring.rs, src/space/laguerre/plane.rs, src/space/laguerre/sphere.rs,
    src/space/laguerre/transformation.rs, src/space/moebius.rs, src/space/point.rs,
    src/space/similarity.rs *)
Definition part_3_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 1; Mul 2 2; Mul 2 2; Add 1 0; Add 3 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Constant 0; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Mul 9 3; Mul 5 3; Add 1 0; Mul 7 4;
  Add 1 0; Mul 9 5; Add 1 0; Add 0 11; Sub 0 11;
  ShowZero 0; (* the centre stays *)
  Mul 13 12; Mul 19 12; Add 1 0; Add 0 8; Add 0 7; Add 0 18; Sub 0 17;
  ShowZero 0; (* the centre stays *)
  Add 6 14; Mul 26 18; Add 1 0; Add 0 13; Add 0 24; Sub 0 22;
  ShowZero 0; (* the centre stays *)
  Unknown 6; Add 6 19; Mul 33 24; Add 1 0; Add 0 3; Add 27 4; Sub 1 0;
  ShowZero 0; (* the radius grows *)
  Div 38 34; Mul 42 0; Mul 42 0; Mul 42 1; Sub 42 39; Mul 0 4; Mul 44 3; Mul 40 3; Add 1 0;
  Mul 42 3; Add 1 0; Mul 44 49; Add 1 0; Mul 46 10; Add 0 6; Mul 53 9; Add 1 0; Add 0 5; Add 3 8;
  Mul 57 57; Add 1 0; Div 59 0; Mul 9 0; Mul 5 1; Add 0 62; Div 63 0; Mul 3 0; Sub 0 67;
  ShowZero 0; (* the point is raised *)
  Mul 66 24; Add 15 0; Add 0 20; Add 0 19; Mul 0 10; Mul 0 7; Sub 0 73;
  ShowZero 0; (* the point is raised *)
  Unknown 7; Mul 0 34; Mul 75 0; Neg 44; Mul 26 72; Mul 8 73; Add 1 0; Mul 24 75; Add 1 0;
  Mul 23 5; Add 1 0; Sub 8 0; Mul 0 25; Div 86 89; Mul 83 0; Mul 56 0; Add 15 0; Mul 4 26;
  Sub 0 1;
  ShowZero 0; (* the point is raised *)
  Mul 87 5; Neg 88; Sub 1 89; Add 2 90; Mul 96 2; Mul 92 3; Add 1 0; Mul 94 4; Add 1 0; Mul 96 5;
  Add 1 0; Add 5 5; Mul 104 9; Add 1 0; Add 0 4; Add 3 7; Mul 108 12; Add 1 0; Add 7 105;
  Add 4 106; Add 2 80; Add 1 0; Neg 3; Mul 115 28; Sub 0 111; Add 1 112; Mul 113 1; Add 20 0;
  Mul 115 2; Add 1 0; Mul 122 5; Add 19 0; Add 0 3; Add 21 6; Mul 126 8; Add 1 0; Add 6 123;
  Add 4 124; Add 2 98; Add 1 0; Neg 3; Sub 1 19; Sub 1 19; Neg 135; Mul 136 0; Add 0 39; Add 0 38;
  Add 0 37; Mul 135 4; Add 0 43; Add 0 37; Add 0 41; Add 2 44; Add 0 36; Add 6 141; Add 3 142;
  Add 2 116; Add 1 0; Neg 3; Sub 1 37; Sub 1 37; Add 56 12; Add 0 54; Add 0 53; Add 58 15;
  Add 0 52; Add 0 56; Add 2 59; Add 0 51; Add 5 156; Add 3 157; Add 2 131; Add 1 0; Neg 3;
  Sub 1 52; Sub 1 52; Sub 75 168; Add 76 169; Mul 165 1; Add 72 0; Mul 167 2; Add 1 0; Mul 174 5;
  Add 71 0; Add 0 3; Add 73 6; Mul 178 8; Add 1 0; Add 6 175; Add 4 176; Add 2 150; Add 1 0;
  Neg 3; Sub 1 71; Sub 1 71; Sub 184 182; Mul 0 101; Neg 191; Neg 191; Mul 57 191; Mul 40 2;
  Add 1 0; Mul 27 3; Add 1 0; Mul 10 7; Add 1 0; Mul 63 198; Mul 46 9; Add 1 0; Mul 33 10;
  Add 1 0; Mul 16 14; Add 1 0; Div 205 7; Neg 1; Mul 0 1; Sub 0 210;
  ShowZero 0; (* by the i-M-transformation *)
  Add 111 112; Add 0 110; Add 0 109; Add 0 207; Neg 0; Add 4 95; Add 0 94; Add 0 211; Neg 0;
  Sub 0 4; Add 78 122; Add 0 120; Add 0 119; Add 0 217; Neg 0; Sub 0 10; Add 127 88; Add 0 126;
  Add 0 125; Add 0 223; Neg 0; Sub 0 16; Add 21 60; Add 0 59; Add 0 228; Neg 0; Sub 0 21;
  Mul 17 236; Mul 12 47; Add 1 0; Mul 8 48; Add 1 0; Mul 5 52; Add 1 0; Neg 0; Mul 0 38;
  Sub 0 246;
  ShowZero 0; (* by the i-M-transformation *)
  Sub 133 134; Mul 0 160; Sub 117 118; Mul 0 162; Sub 0 2; Sub 102 103; Mul 0 165; Sub 0 5;
  Sub 90 91; Mul 0 168; Sub 0 8; Sub 74 75; Mul 0 171; Sub 0 11; Mul 9 260; Mul 7 71; Add 1 0;
  Mul 6 72; Add 1 0; Mul 5 76; Add 1 0; Mul 267 193; Neg 20; Neg 155; Mul 72 1; Mul 66 156;
  Add 1 0; Mul 30 59; Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Mul 0 72; Sub 0 189;
  ShowZero 0 (* by the i-M-transformation *)
].

Theorem part_3_size_1_valid : valid part_3_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the same in the isotropic model; size 1.
    Code: src/scalar/ring.rs, src/space/laguerre/plane.rs, src/space/laguerre/sphere.rs,
    src/space/laguerre/transformation.rs, src/space/moebius.rs, src/space/point.rs,
    src/space/similarity.rs *)
Definition part_4_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Mul 3 3; Mul 3 3; Add 1 0; Mul 4 4; Add 1 0;
  Mul 5 5; Sub 1 0;
  Nonzero 0; (* the vector of the reflection has a length *)
  Unknown 4; Unknown 5; Constant 1; Mul 2 2; Mul 2 2; Add 1 0; Add 3 0;
  Nonzero 0; (* 1 + |x'|² is not 0, as in ordered fields *)
  Neg 14; Mul 15 0; Add 11 0; Div 7 0; Constant 0; Mul 0 22; Mul 1 22; Add 1 0; Mul 3 23; Add 1 0;
  Mul 5 9; Add 1 0; Mul 0 8; Constant 2; Mul 1 0; Mul 0 32; Sub 11 0; Mul 2 33; Sub 13 0;
  Mul 4 34; Sub 15 0; Mul 6 35; Sub 17 0; Mul 27 40; Add 0 17; Add 0 16; Add 0 15; Mul 0 23;
  Mul 0 14; Mul 0 46; Sub 34 0; Mul 2 47; Sub 27 0; Mul 4 48; Sub 29 0; Mul 6 49; Sub 31 0;
  Sub 6 20; Sub 5 19; Sub 4 18; Sub 3 17; Mul 45 57; Add 36 0; Add 0 34; Add 0 33; Mul 0 41;
  Mul 0 32; Mul 0 64; Sub 43 0; Mul 2 65; Sub 54 0; Mul 4 66; Sub 47 0; Mul 6 67; Sub 49 0;
  Sub 6 38; Sub 5 37; Sub 4 36; Sub 3 35; Mul 63 74; Add 52 0; Add 0 50; Mul 0 58; Mul 0 49;
  Mul 0 81; Sub 60 0; Mul 2 82; Sub 62 0; Mul 4 83; Sub 73 0; Mul 6 84; Sub 66 0; Sub 6 55;
  Sub 5 54; Sub 4 53; Sub 3 52; Mul 80 75; Add 67 0; Mul 0 74; Mul 0 65; Mul 0 97; Sub 76 0;
  Mul 2 98; Sub 78 0; Mul 4 99; Sub 80 0; Mul 6 100; Sub 91 0; Sub 6 71; Sub 5 70; Sub 4 69;
  Sub 3 68; Mul 87 54; Mul 88 54; Add 1 0; Mul 90 55; Add 1 0; Mul 101 56; Add 1 0; Mul 94 43;
  Mul 95 43; Add 1 0; Mul 97 44; Add 1 0; Mul 108 45; Add 1 0; Mul 101 33; Mul 102 33; Add 1 0;
  Mul 104 34; Add 1 0; Mul 115 35; Add 1 0; Mul 108 24; Mul 109 24; Add 1 0; Mul 111 25; Add 1 0;
  Mul 122 26; Add 1 0; Div 124 120; Mul 107 0; Mul 128 0; Mul 128 1; Sub 128 125; Mul 0 4;
  Mul 27 3; Mul 21 3; Add 1 0; Mul 16 3; Add 1 0; Mul 11 135; Add 1 0;
  Nonzero 0; (* an isotropic vector has a last coordinate, as in ordered fields *)
  Mul 137 93; Add 39 0; Mul 130 94; Add 1 0; Mul 141 79; Add 36 0; Mul 134 80; Add 1 0;
  Mul 145 66; Add 33 0; Mul 138 67; Add 1 0; Mul 149 54; Add 30 0; Mul 142 55; Add 1 0; Mul 12 26;
  Mul 9 26; Add 1 0; Mul 7 26; Add 1 0; Mul 5 158; Add 1 0; Div 160 23; Mul 1 0; Add 162 0;
  Nonzero 0; (* the image of the plane does not have the normal (0, 0, −1) *)
  Unknown 6; Unknown 7; Unknown 8; Mul 166 124; Add 0 69; Add 0 68; Add 0 29; Mul 170 110;
  Add 0 66; Add 0 65; Add 0 29; Mul 174 97; Add 0 63; Add 0 62; Add 0 29; Mul 178 85; Add 0 60;
  Add 0 59; Add 0 29; Mul 182 161; Mul 174 160; Add 1 0; Mul 176 160; Add 1 0; Mul 178 160;
  Add 1 0; Mul 180 168; Add 0 6; Mul 191 166; Add 1 0; Add 0 5; Add 3 8; Mul 195 168; Add 1 0;
  Add 8 33; Add 4 33; Add 2 33; Div 200 182; Mul 192 0; Neg 193; Sub 1 194; Add 2 195; Mul 35 2;
  Mul 32 3; Add 1 0; Mul 30 4; Add 1 0; Mul 28 5; Add 1 0; Mul 71 9; Mul 68 10; Add 1 0;
  Mul 66 11; Add 1 0; Mul 64 12; Add 1 0; Mul 116 16; Mul 110 17; Add 1 0; Mul 105 18; Add 1 0;
  Mul 100 19; Add 1 0; Add 14 28; Add 8 28; Add 2 28; Add 1 0; Neg 3; Mul 231 30; Sub 0 223;
  Add 1 224; Mul 56 1; Add 27 0; Mul 54 2; Add 1 0; Mul 89 5; Add 24 0; Mul 87 6; Add 1 0;
  Mul 125 9; Add 21 0; Mul 120 10; Add 1 0; Add 8 48; Add 5 48; Add 2 48; Add 1 0; Neg 3;
  Sub 1 21; Sub 1 21; Neg 253; Mul 84 0; Add 0 48; Add 0 47; Add 0 46; Mul 117 4; Add 0 45;
  Add 0 44; Add 0 43; Mul 159 8; Add 0 42; Add 0 41; Add 0 40; Add 8 68; Add 5 68; Add 2 68;
  Add 1 0; Neg 3; Sub 1 41; Sub 1 41; Mul 99 19; Add 68 0; Add 0 66; Add 0 65; Mul 132 23;
  Add 65 0; Add 0 63; Add 0 62; Mul 171 27; Add 62 0; Add 0 60; Add 0 59; Add 8 87; Add 5 87;
  Add 2 87; Add 1 0; Neg 3; Sub 1 60; Sub 1 60; Sub 90 292; Add 91 293; Mul 116 1; Add 87 0;
  Mul 114 2; Add 1 0; Mul 149 5; Add 84 0; Mul 147 6; Add 1 0; Mul 185 9; Add 81 0; Mul 180 10;
  Add 1 0; Add 8 108; Add 5 108; Add 2 108; Add 1 0; Neg 3; Sub 1 81; Sub 1 81; Mul 143 186;
  Mul 140 186; Add 1 0; Mul 138 186; Add 1 0; Mul 136 318; Add 1 0; Mul 0 159; Sub 318 312;
  Mul 0 121; Neg 325; Neg 325; Mul 73 325; Mul 54 2; Add 1 0; Mul 37 3; Add 1 0; Mul 18 7;
  Add 1 0; Mul 79 332; Mul 60 9; Add 1 0; Mul 43 10; Add 1 0; Mul 24 14; Add 1 0; Div 339 7;
  Neg 1; Mul 0 1; Add 180 342; Div 343 0; Mul 23 0; Sub 3 0;
  ShowZero 0; (* planes and points *)
  Unknown 9; Mul 347 304; Add 251 0; Add 0 249; Add 0 210; Mul 351 290; Add 248 0; Add 0 246;
  Add 0 210; Mul 355 277; Add 245 0; Add 0 243; Add 0 210; Mul 359 265; Add 242 0; Add 0 240;
  Add 0 210; Mul 363 340; Add 174 0; Add 0 179; Add 0 178; Add 0 20; Mul 17 165; Mul 14 166;
  Add 1 0; Mul 12 167; Add 1 0; Mul 10 168; Add 1 0; Add 0 7; Neg 0; Mul 18 144; Add 7 0;
  Mul 16 145; Add 1 0; Add 0 13; Neg 0; Sub 0 6; Mul 33 130; Add 0 15; Add 0 14; Add 0 13;
  Add 0 20; Neg 0; Sub 0 13; Mul 36 137; Add 23 0; Add 0 21; Add 0 20; Add 0 27; Neg 0; Sub 0 20;
  Mul 39 105; Add 28 0; Mul 37 106; Add 1 0; Add 0 34; Neg 0; Sub 0 27; Mul 54 278; Mul 51 278;
  Add 1 0; Mul 49 278; Add 1 0; Mul 47 410; Add 1 0; Mul 0 251; Mul 29 413; Mul 23 90; Add 1 0;
  Mul 18 91; Add 1 0; Mul 13 95; Add 1 0; Neg 0; Mul 0 81; Mul 9 78; Sub 1 0;
  ShowZero 0; (* planes and points *)
  Mul 424 424; Sub 196 197; Mul 0 225; Sub 178 179; Mul 0 227; Sub 0 2; Sub 161 162; Mul 0 230;
  Sub 0 5; Sub 145 146; Mul 0 233; Sub 0 8; Sub 127 128; Mul 0 236; Sub 0 11; Unknown 10;
  Mul 0 314; Mul 16 0; Neg 242; Mul 123 245; Mul 32 76; Add 1 0; Mul 286 247; Add 1 0; Mul 311 5;
  Add 1 0; Sub 8 0; Mul 0 290; Mul 22 452; Mul 20 129; Add 1 0; Mul 19 130; Add 1 0; Mul 18 134;
  Add 1 0; Mul 34 19; Neg 33; Neg 231; Mul 130 1; Mul 124 232; Add 1 0; Mul 45 88; Add 1 0;
  Mul 8 5; Add 1 0; Sub 9 0; Mul 0 130; Mul 19 127; Sub 1 0;
  ShowZero 0; (* planes and points *)
  Unknown 11; Unknown 12; Unknown 13; Unknown 14; Add 1 0; Neg 4; Neg 4; Sub 3 4; Mul 0 280;
  Mul 230 4; Mul 211 4; Add 1 0; Mul 194 5; Add 1 0; Mul 175 5; Add 1 0; Add 0 259; Mul 349 16;
  Mul 346 16; Add 1 0; Mul 344 17; Add 1 0; Mul 342 18; Add 1 0; Mul 394 23; Mul 388 23; Add 1 0;
  Mul 383 24; Add 1 0; Mul 378 25; Add 1 0; Add 7 305; Add 1 305; Add 1 0; Sub 17 0;
  ShowZero 0; (* spheres *)
  Mul 255 30; Mul 236 30; Add 1 0; Mul 219 31; Add 1 0; Mul 200 31; Add 1 0; Add 0 284;
  Mul 346 42; Mul 343 42; Add 1 0; Mul 341 43; Add 1 0; Mul 339 44; Add 1 0; Add 0 325; Neg 0;
  Sub 9 0;
  ShowZero 0; (* spheres *)
  Mul 142 48; Mul 136 48; Add 1 0; Mul 131 49; Add 1 0; Mul 126 49; Add 1 0; Add 0 156;
  Mul 183 60; Mul 180 60; Add 1 0; Mul 178 61; Add 1 0; Mul 176 62; Add 1 0; Add 0 173; Neg 0;
  Sub 9 0;
  ShowZero 0; (* spheres *)
  Mul 114 66; Mul 112 66; Add 1 0; Mul 111 67; Add 1 0; Mul 110 67; Add 1 0; Add 0 124; Sub 46 47;
  Mul 0 352; Sub 2 0;
  ShowZero 0; (* spheres *)
  Add 546 546; Sub 547 547; Mul 0 356; Mul 305 2; Mul 286 356; Add 1 0; Mul 269 358; Add 1 0;
  Mul 250 5; Add 1 0; Add 0 334; Neg 0; Mul 294 313; Add 9 0; Add 0 7; Add 0 6; Add 0 340; Neg 0;
  Sub 0 6; Mul 282 320; Add 14 0; Add 0 12; Add 0 346; Neg 0; Sub 0 12; Add 580 571; Sub 572 581;
  Mul 0 381; Mul 330 2; Add 0 24; Add 0 23; Mul 273 3; Add 1 0; Add 0 357; Neg 0; Sub 0 23;
  Add 582 591; Sub 592 583; Mul 0 392; Mul 341 2; Add 0 35; Add 0 34; Mul 284 3; Add 1 0;
  Add 0 368; Neg 0; Sub 0 34; Mul 28 128; Mul 23 128; Add 1 0; Mul 14 129; Add 1 0; Mul 5 130;
  Add 1 0; Add 0 42; Sub 0 86;
  ShowZero 0; (* there and back *)
  Mul 227 55; Mul 221 409; Add 1 0; Mul 216 411; Add 1 0; Mul 211 58; Add 1 0; Add 0 241; Neg 0;
  Mul 229 366; Add 9 0; Add 0 7; Add 0 6; Add 0 247; Neg 0; Sub 0 6; Mul 229 373; Add 14 0;
  Add 0 12; Add 0 253; Neg 0; Sub 0 12; Mul 249 52; Add 0 21; Add 0 20; Mul 231 53; Add 1 0;
  Add 0 261; Neg 0; Sub 0 20; Mul 257 49; Add 0 29; Add 0 28; Mul 239 50; Add 1 0; Add 0 269;
  Neg 0; Sub 0 28; Mul 22 175; Mul 17 175; Add 1 0; Mul 11 176; Add 1 0; Mul 5 177; Add 1 0;
  Add 0 36; Sub 0 115;
  ShowZero 0; (* there and back *)
  Mul 406 102; Mul 387 456; Add 1 0; Mul 370 458; Add 1 0; Mul 351 105; Add 1 0; Mul 235 109;
  Mul 233 463; Add 1 0; Mul 232 465; Add 1 0; Mul 231 112; Add 1 0; Add 7 442; Add 1 246;
  Mul 1 473; Sub 0 1; Mul 404 422; Add 18 0; Add 0 16; Add 0 15; Mul 247 426; Add 15 0; Add 0 13;
  Add 0 12; Add 4 454; Add 1 258; Mul 1 485; Sub 0 1; Sub 0 12; Mul 398 435; Add 29 0; Add 0 27;
  Mul 256 438; Add 25 0; Add 0 23; Add 3 465; Add 1 269; Mul 1 496; Sub 0 1; Sub 0 23;
  Mul 448 119; Add 0 41; Add 0 40; Mul 391 120; Add 1 0; Mul 275 124; Add 0 39; Add 0 38;
  Mul 269 125; Add 1 0; Add 5 480; Add 1 284; Mul 1 511; Sub 0 1; Sub 0 38; Mul 463 123; Add 0 56;
  Add 0 55; Mul 406 124; Add 1 0; Mul 290 128; Add 0 54; Add 0 53; Mul 284 129; Add 1 0;
  Add 5 495; Add 1 299; Mul 1 526; Sub 0 1; Sub 0 53; Mul 41 256; Mul 31 256; Add 1 0; Mul 18 257;
  Add 1 0; Mul 5 258; Add 1 0; Add 0 61; Sub 0 233;
  ShowZero 0; (* there and back *)
  Add 64 65; Add 53 54; Sub 0 1; Add 44 45; Sub 0 3; Add 31 32; Sub 0 5; Add 18 19; Sub 0 7;
  Mul 6 274; Mul 5 274; Add 1 0; Mul 5 275; Add 1 0; Mul 5 276; Add 1 0; Add 0 15; Sub 0 250;
  ShowZero 0 (* there and back *)
].

Theorem part_4_size_1_valid : valid part_4_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** cones and i-circles; size 1.
    Code: src/scalar/ring.rs, src/space/circle.rs, src/space/laguerre/cone.rs,
    src/space/laguerre/sphere.rs, src/space/laguerre/transformation.rs, src/space/moebius.rs,
    src/space/point.rs, src/space/similarity.rs, src/space/sphere.rs *)
Definition part_5_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Mul 3 3; Mul 3 3; Add 1 0; Mul 4 4; Add 1 0;
  Mul 5 5; Sub 1 0;
  Nonzero 0; (* the vector of the reflection has a length *)
  Unknown 4; Unknown 5; Unknown 6; Constant 0; Sub 3 0; Sub 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 0 6; Constant 1; Add 0 1;
  Nonzero 0; (* the cone is no cylinder *)
  Unknown 7; Unknown 8; Neg 21; Mul 22 0; Add 18 0; Div 6 0; Mul 14 28; Mul 15 28; Add 1 0;
  Mul 17 29; Add 1 0; Mul 19 8; Add 1 0; Mul 0 7; Mul 0 37; Mul 0 37; Sub 24 0; Mul 2 38;
  Sub 26 0; Mul 4 39; Sub 28 0; Mul 6 40; Sub 30 0; Mul 24 45; Add 0 16; Add 0 15; Add 0 14;
  Mul 0 21; Mul 0 51; Mul 0 51; Sub 31 0; Mul 2 52; Sub 40 0; Mul 4 53; Sub 42 0; Mul 6 54;
  Sub 44 0; Sub 6 20; Sub 5 19; Sub 4 18; Sub 3 17; Mul 42 62; Add 35 0; Add 0 33; Add 0 32;
  Mul 0 39; Mul 0 69; Mul 0 69; Sub 56 0; Mul 2 70; Sub 51 0; Mul 4 71; Sub 60 0; Mul 6 72;
  Sub 62 0; Sub 6 38; Sub 5 37; Sub 4 36; Sub 3 35; Mul 60 79; Add 51 0; Add 0 49; Mul 0 56;
  Mul 0 86; Mul 0 86; Sub 73 0; Mul 2 87; Sub 75 0; Mul 4 88; Sub 70 0; Mul 6 89; Sub 79 0;
  Sub 6 55; Sub 5 54; Sub 4 53; Sub 3 52; Mul 77 73; Add 66 0; Mul 0 72; Mul 0 102; Mul 0 102;
  Sub 89 0; Mul 2 103; Sub 91 0; Mul 4 104; Sub 93 0; Mul 6 105; Sub 88 0; Sub 6 71; Sub 5 70;
  Sub 4 69; Sub 3 68; Mul 100 54; Mul 101 54; Add 1 0; Mul 96 55; Add 1 0; Mul 105 56; Add 1 0;
  Mul 107 59; Add 5 0; Mul 102 60; Add 1 0; Mul 111 47; Mul 112 47; Add 1 0; Mul 107 48; Add 1 0;
  Mul 116 49; Add 1 0; Mul 118 52; Add 5 0; Mul 113 53; Add 1 0; Mul 122 41; Mul 123 41; Add 1 0;
  Mul 118 42; Add 1 0; Mul 127 43; Add 1 0; Mul 129 46; Add 5 0; Mul 124 47; Add 1 0; Mul 133 36;
  Mul 134 36; Add 1 0; Mul 129 37; Add 1 0; Mul 138 38; Add 1 0; Mul 140 41; Add 5 0; Mul 135 42;
  Add 1 0; Mul 144 119; Mul 145 118; Add 1 0; Mul 140 118; Add 1 0; Mul 149 118; Add 1 0;
  Mul 151 122; Add 5 0; Mul 146 122; Add 1 0; Add 4 146; Add 1 146; Div 150 172; Mul 158 0;
  Neg 159; Sub 1 160; Add 2 161; Mul 55 2; Mul 45 3; Add 1 0; Mul 36 4; Add 1 0; Mul 27 5;
  Add 1 0; Mul 58 9; Mul 48 10; Add 1 0; Mul 39 11; Add 1 0; Mul 30 12; Add 1 0; Add 7 20;
  Add 1 20; Add 1 0; Mul 172 21; Sub 0 180; Add 1 181; Mul 53 1; Add 18 0; Mul 44 2; Add 1 0;
  Mul 53 5; Add 15 0; Mul 44 6; Add 1 0; Add 4 34; Add 1 34; Add 1 0; Sub 0 14; Neg 187; Mul 88 0;
  Add 0 32; Add 0 31; Add 0 30; Mul 88 4; Add 0 29; Add 0 28; Add 0 27; Add 4 47; Add 1 47;
  Add 1 0; Sub 0 27; Mul 89 12; Add 45 0; Add 0 43; Add 0 42; Mul 89 16; Add 42 0; Add 0 40;
  Add 0 39; Add 4 59; Add 1 59; Add 1 0; Sub 0 39; Sub 60 212; Add 61 213; Mul 92 1; Add 57 0;
  Mul 83 2; Add 1 0; Mul 92 5; Add 54 0; Mul 83 6; Add 1 0; Add 4 73; Add 1 73; Add 1 0; Sub 0 53;
  Neg 236; Neg 236; Mul 229 77; Mul 42 229; Mul 30 3; Add 1 0; Mul 20 4; Add 1 0; Mul 8 5;
  Add 1 0;
  Nonzero 0; (* the image does not pass through the centre *)
  Unknown 9; Unknown 10; Mul 238 199; Add 0 144; Add 0 139; Add 0 142; Mul 242 202; Add 149 0;
  Add 0 143; Add 0 146; Mul 246 189; Add 0 141; Add 0 136; Add 0 139; Mul 250 192; Add 146 0;
  Add 0 140; Add 0 143; Mul 254 180; Add 0 138; Add 0 133; Add 0 136; Mul 258 183; Add 143 0;
  Add 0 137; Add 0 140; Mul 262 172; Add 0 135; Add 0 130; Add 0 133; Mul 266 175; Add 140 0;
  Add 0 134; Add 0 137; Mul 270 270; Mul 271 253; Add 0 133; Add 0 128; Add 0 131; Mul 275 255;
  Add 138 0; Add 0 132; Add 0 135; Add 4 42; Add 1 42; Mul 39 128; Mul 32 129; Add 1 0;
  Mul 26 130; Add 1 0; Mul 20 131; Add 1 0; Mul 42 135; Mul 35 136; Add 1 0; Mul 29 137; Add 1 0;
  Mul 23 138; Add 1 0; Add 7 15; Add 1 15; Neg 1; Neg 1; Mul 41 125; Add 16 0; Mul 35 126;
  Add 1 0; Mul 41 129; Add 13 0; Mul 35 130; Add 1 0; Add 4 27; Add 1 27; Neg 1; Neg 1; Sub 1 13;
  Sub 1 13; Mul 71 125; Add 0 31; Add 0 30; Add 0 29; Mul 71 129; Add 0 28; Add 0 27; Add 0 26;
  Add 4 41; Add 1 41; Neg 1; Neg 1; Sub 1 27; Sub 1 27; Mul 77 139; Add 46 0; Add 0 44; Add 0 43;
  Mul 77 143; Add 43 0; Add 0 41; Add 0 40; Add 4 55; Add 1 55; Neg 1; Neg 1; Sub 1 41; Sub 1 41;
  Mul 83 128; Add 58 0; Mul 77 129; Add 1 0; Mul 83 132; Add 55 0; Mul 77 133; Add 1 0; Add 4 69;
  Add 1 69; Neg 1; Neg 1; Sub 1 55; Sub 1 55; Mul 365 365; Mul 365 365; Add 1 0; Sub 0 366;
  Mul 0 208; Mul 134 0; Add 127 0; Mul 50 362; Mul 37 136; Add 1 0; Mul 25 137; Add 1 0; Mul 13 7;
  Add 1 0; Mul 56 369; Mul 43 143; Add 1 0; Mul 31 144; Add 1 0; Mul 19 14; Add 1 0; Div 376 14;
  Neg 8; Mul 0 1; Neg 3; Mul 0 3; Mul 389 110; Mul 5 5; Mul 1 0; Sub 5 391; Sub 4 392; Mul 1 1;
  Mul 1 1; Add 1 0; Sub 0 5; Add 390 0;
  Nonzero 0; (* the image of the cone is no cylinder *)
  Unknown 11; Unknown 12; Unknown 13; Add 394 35; Div 395 0; Mul 418 0; Mul 3 0; Neg 0; Mul 0 409;
  Sub 0 8; Mul 2 410; Sub 0 9; Mul 413 6; Mul 413 7; Sub 405 46; Mul 0 10; Sub 236 237; Mul 0 257;
  Sub 224 225; Mul 0 259; Sub 0 2; Sub 214 215; Mul 0 262; Sub 0 5; Sub 205 206; Mul 0 265;
  Sub 0 8; Sub 194 195; Mul 0 268; Sub 0 11; Mul 9 421; Mul 7 195; Add 1 0; Mul 6 196; Add 1 0;
  Mul 5 66; Add 1 0; Mul 241 435; Mul 229 37; Add 1 0; Mul 219 38; Add 1 0; Mul 207 39; Add 1 0;
  Mul 123 442; Mul 110 44; Add 1 0; Mul 98 45; Add 1 0; Mul 86 46; Add 1 0; Mul 30 449; Mul 28 51;
  Add 1 0; Mul 27 52; Add 1 0; Mul 26 53; Add 1 0; Add 14 277; Add 8 152; Add 2 42; Mul 2 75;
  Mul 0 84; Mul 1 26; Sub 4 1; Sub 4 1; Mul 78 78; Mul 77 77; Add 1 0; Sub 0 76; Add 461 0;
  Div 462 0; Mul 485 0; Mul 7 0; Neg 0; Mul 0 87; Sub 0 11; Mul 226 64; Mul 219 64; Add 1 0;
  Mul 213 64; Add 1 0; Mul 207 473; Add 1 0; Mul 371 71; Mul 361 71; Add 1 0; Mul 352 71; Add 1 0;
  Mul 343 480; Add 1 0; Div 482 0; Mul 8 0; Mul 242 83; Mul 235 82; Add 1 0; Mul 229 88; Add 1 0;
  Mul 223 496; Add 1 0; Mul 387 90; Mul 377 89; Add 1 0; Mul 368 95; Add 1 0; Mul 359 503;
  Add 1 0; Add 7 218; Add 1 349; Mul 0 16; Sub 2 0; Sub 0 34;
  ShowZero 0; (* vertex *)
  Mul 190 510; Mul 177 112; Add 1 0; Mul 165 113; Add 1 0; Mul 153 114; Add 1 0; Add 0 211;
  Mul 58 135; Sub 1 0; Mul 47 132; Sub 0 1; Mul 269 111; Mul 262 111; Add 1 0; Mul 256 111;
  Add 1 0; Mul 250 520; Add 1 0; Mul 0 39; Mul 277 122; Mul 270 121; Add 1 0; Mul 264 127;
  Add 1 0; Mul 258 535; Add 1 0; Add 0 249; Mul 31 8; Sub 1 0; Sub 0 18;
  ShowZero 0; (* vertex *)
  Mul 434 130; Mul 424 130; Add 1 0; Mul 415 130; Add 1 0; Mul 406 539; Add 1 0; Mul 0 58;
  Mul 442 141; Mul 432 140; Add 1 0; Mul 423 146; Add 1 0; Mul 414 554; Add 1 0; Add 0 400;
  Mul 50 8; Sub 1 0; Sub 0 86;
  ShowZero 0; (* vertex *)
  Mul 174 89; Sub 70 0;
  ShowZero 0; (* axis *)
  Mul 174 91; Sub 33 0;
  ShowZero 0; (* axis *)
  Sub 557 96; Mul 0 95; Sub 17 0;
  ShowZero 0 (* axis *)
].

Theorem part_5_size_1_valid : valid part_5_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
