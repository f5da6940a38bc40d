(** remark-4 (Sec. 4, Remark 4)

    An i-M-inversion of the graph of a harmonic function is that of a biharmonic one; the inverted
    incircles of an i-isothermic mesh, of an i-minimal one in particular, are the incircles of one
    again, whose vertices lie in the planes of these circles; and τ maps it to an edge-offset mesh.

        Δ²(|x|² f(x/|x|²)) = 0,  v -> v/N,  r -> r/N,  N = |v'|² - r²

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** harmonic functions of degree n; size 2.
    Code: src/scalar/dual.rs, src/scalar/ring.rs, src/space/moebius.rs, src/space/point.rs,
    src/space/similarity.rs *)
Definition part_1_size_2 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Unknown 2;
  Zero 0; (* f is harmonic *)
  Constant 1;
  ShowNonzero 0; (* as src/space/sphere.rs finds *)
  Constant 0; Mul 0 0; Add 0 0; Sub 0 3; Div 4 11; Mul 1 0; Neg 5; Div 14 7; Sub 7 7; Neg 3;
  Neg 10; Mul 2 1; Mul 3 5; Add 1 0; Add 0 1; Mul 6 4; Add 1 0; Mul 0 9; Mul 0 18; Sub 10 0;
  Add 0 19; Mul 3 14; Sub 13 0; Add 0 22; Sub 24 23; Mul 0 15; Add 0 13; Add 0 14; Add 0 12;
  Mul 0 21; Mul 0 30; Sub 6 0; Add 0 31; Mul 3 26; Sub 25 0; Add 0 34; Sub 3 15; Sub 1 13;
  Mul 13 31; Add 27 0; Add 0 27; Add 0 25; Mul 0 34; Mul 0 43; Sub 35 0; Add 0 44; Mul 3 39;
  Sub 22 0; Add 0 47; Sub 3 28; Sub 1 26; Add 37 12; Add 0 36; Mul 0 45; Mul 0 54; Sub 46 0;
  Add 0 55; Mul 3 50; Sub 49 0; Add 0 58; Sub 3 39; Sub 1 37; Mul 37 51; Add 48 0; Mul 0 56;
  Mul 0 65; Sub 57 0; Add 0 66; Mul 3 61; Sub 60 0; Add 0 69; Sub 3 50; Sub 1 48; Sub 75 72;
  Mul 0 69; Neg 81; Neg 81; Mul 40 77; Mul 28 2; Add 1 0; Mul 19 3; Add 1 0; Mul 10 7; Add 1 0;
  Mul 46 84; Mul 34 9; Add 1 0; Mul 25 10; Add 1 0; Mul 16 14; Add 1 0; Div 91 7; Neg 1; Mul 0 1;
  Div 94 96; Mul 101 0; Sub 2 0;
  ShowZero 0; (* the inverse of a point *)
  Sub 88 50; Add 0 97; Sub 0 75; Sub 75 42; Add 0 100; Sub 0 78; Mul 3 27; Add 19 0; Mul 2 28;
  Add 1 0; Add 0 17; Neg 0; Mul 0 17; Mul 115 15; Sub 1 0;
  ShowZero 0; (* the inverse of a point *)
  Unknown 3; Mul 95 107; Sub 105 0; Add 0 114; Mul 86 110; Sub 108 0; Add 0 117; Sub 0 3;
  Mul 77 114; Sub 112 0; Add 0 121; Sub 0 7; Mul 70 118; Sub 116 0; Add 0 125; Sub 0 11;
  Mul 63 122; Sub 104 0; Add 0 129; Sub 0 15; Mul 12 132; Mul 9 57; Add 1 0; Mul 7 58; Add 1 0;
  Mul 5 62; Add 1 0; Mul 139 26; Neg 24; Neg 120; Mul 58 1; Mul 52 119; Add 1 0; Mul 37 121;
  Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Mul 0 58; Mul 38 56; Sub 1 0;
  ShowZero 0; (* the inverse of a point *)
  Unknown 4; Mul 153 160; Mul 154 155; Add 1 0; Add 1 155; Add 1 0; Mul 159 158; Add 158 0;
  Add 3 0; Add 6 2; Add 6 0; Add 5 2; Mul 165 165; Add 11 0; Mul 173 166; Add 8 0; Add 8 0;
  Add 7 1; Add 9 1; Add 6 4; Add 6 0; Add 10 3; Add 10 3; Mul 176 182; Mul 183 177; Add 1 0;
  Mul 178 184; Add 0 178; Add 0 178; Add 179 179; Add 1 0; Mul 189 183; Add 183 0; Add 183 0;
  Add 4 0; Add 7 2; Add 7 2; Add 6 2; Add 11 6; Add 13 0; Add 19 4; Add 19 4; Add 19 4;
  Mul 101 101; Neg 0; Mul 0 5; Add 104 104; Mul 0 1; Neg 0; Mul 0 9; Mul 5 9; Add 1 0; Add 6 6;
  Mul 0 7; Mul 7 2; Add 1 0; Neg 0; Mul 0 17; Mul 9 17; Add 1 0; Mul 15 18; Add 2 0; Add 2 0;
  Add 11 11; Mul 0 18; Mul 12 13; Add 1 0; Mul 20 4; Add 2 0; Add 2 0; Neg 0; Mul 0 31; Mul 15 31;
  Add 1 0; Mul 25 32; Add 2 0; Add 2 0; Mul 32 34; Add 3 0; Add 3 0; Add 3 0; Mul 233 139;
  Mul 234 36; Add 1 0; Mul 236 32; Add 2 0; Add 2 0; Mul 240 24; Add 3 0; Add 3 0; Mul 243 38;
  Add 8 0; Add 8 0; Add 6 3; Mul 247 48; Add 13 0; Mul 255 15; Add 9 0; Add 9 0; Mul 258 36;
  Add 9 0; Add 9 0; Add 12 3; Mul 262 51; Add 9 0; Add 9 0; Add 13 4; Add 13 4; Mul 261 166;
  Mul 268 63; Add 1 0; Mul 263 48; Add 27 0; Add 27 0; Add 27 0; Mul 273 34; Add 4 0; Add 4 0;
  Mul 276 55; Add 34 0; Add 34 0; Add 7 3; Mul 280 70; Add 40 0; Add 40 0; Add 38 4; Add 11 4;
  Mul 285 81; Add 46 0; Mul 21 186; Mul 23 19; Add 1 0; Mul 26 26; Add 2 0; Add 2 0; Mul 28 192;
  Mul 30 25; Add 1 0; Mul 27 31; Add 6 0; Add 6 0; Mul 30 35; Add 5 0; Add 5 0; Add 9 3;
  Mul 39 202; Mul 35 35; Add 1 0; Mul 205 40; Add 10 0; Add 10 0; Mul 208 44; Add 10 0; Add 10 0;
  Add 13 3; Mul 212 49; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 49 217; Mul 218 50; Add 1 0;
  Mul 220 220; Mul 37 206; Mul 39 36; Add 1 0; Mul 42 42; Add 2 0; Add 2 0; Mul 44 212; Mul 46 42;
  Add 1 0; Mul 44 47; Add 6 0; Add 6 0; Mul 47 51; Add 5 0; Add 5 0; Add 9 3; Mul 55 222;
  Mul 52 52; Add 1 0; Mul 225 56; Add 10 0; Add 10 0; Mul 228 60; Add 10 0; Add 10 0; Add 13 3;
  Mul 232 65; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 66 237; Mul 238 67; Add 1 0; Mul 240 240;
  Sub 35 0; Sub 37 2; Sub 43 8; Sub 43 8; Sub 43 8; Mul 96 246; Mul 98 76; Add 1 0; Mul 101 82;
  Add 2 0; Add 2 0; Mul 103 252; Mul 105 82; Add 1 0; Mul 102 87; Add 6 0; Add 6 0; Mul 105 91;
  Add 5 0; Add 5 0; Add 9 3; Mul 114 262; Mul 110 92; Add 1 0; Mul 280 96; Add 10 0; Add 10 0;
  Mul 283 100; Add 10 0; Add 10 0; Add 13 3; Mul 287 105; Add 9 0; Add 9 0; Add 14 4; Add 14 4;
  Mul 124 277; Mul 293 107; Add 1 0; Mul 295 280; Mul 112 296; Mul 114 129; Add 1 0; Mul 117 136;
  Add 2 0; Add 2 0; Mul 119 302; Mul 121 135; Add 1 0; Mul 119 141; Add 6 0; Add 6 0; Mul 122 145;
  Add 5 0; Add 5 0; Add 9 3; Mul 130 312; Mul 127 145; Add 1 0; Mul 300 150; Add 10 0; Add 10 0;
  Mul 303 154; Add 10 0; Add 10 0; Add 13 3; Mul 307 159; Add 9 0; Add 9 0; Add 14 4; Add 14 4;
  Mul 141 327; Mul 313 160; Add 1 0; Mul 315 330; Add 35 0; Add 37 2; Add 43 8; Add 43 8;
  Add 43 8; Mul 75 319; Mul 77 432; Add 1 0; Mul 80 434; Add 2 0; Add 2 0; Mul 82 325; Add 0 3;
  Mul 86 439; Add 5 0; Add 5 0; Add 3 1; Add 6 1; Mul 90 332; Add 0 5; Mul 94 446; Add 7 0;
  Add 7 0; Add 7 0; Add 4 2; Add 8 2; Add 8 2; Mul 100 341; Add 0 7; Mul 103 343; Mul 25 303;
  Mul 27 457; Add 1 0; Mul 30 459; Add 2 0; Add 2 0; Mul 32 309; Add 0 3; Mul 36 464; Add 5 0;
  Add 5 0; Add 3 1; Add 6 1; Mul 40 316; Add 0 5; Mul 44 471; Add 7 0; Add 7 0; Add 7 0; Add 4 2;
  Add 8 2; Add 8 2; Mul 50 325; Add 0 7; Mul 53 327; Add 25 0; Add 27 2; Add 32 7; Add 32 7;
  Add 32 7; Mul 174 170; Mul 176 172; Add 1 0; Mul 179 179; Add 2 0; Add 2 0; Mul 181 176;
  Mul 183 178; Add 1 0; Mul 180 184; Add 6 0; Add 6 0; Mul 183 188; Add 5 0; Add 5 0; Add 9 3;
  Mul 192 186; Mul 188 188; Add 1 0; Mul 189 193; Add 10 0; Add 10 0; Mul 192 197; Add 10 0;
  Add 10 0; Add 13 3; Mul 196 202; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 202 201; Mul 202 203;
  Add 1 0; Mul 204 204; Mul 4 523; Mul 6 522; Add 1 0; Mul 9 524; Add 2 0; Add 2 0; Mul 11 529;
  Add 0 3; Mul 9 529; Add 5 0; Add 5 0; Add 3 1; Add 6 1; Mul 19 536; Add 0 5; Mul 15 536;
  Add 7 0; Add 7 0; Add 7 0; Add 4 2; Add 8 2; Add 8 2; Mul 23 545; Add 0 7; Mul 24 547; Add 64 0;
  Add 64 2; Add 64 7; Add 64 7; Add 64 7; Mul 0 554; Mul 2 360; Add 1 0; Mul 5 361; Add 2 0;
  Add 2 0; Mul 9 363; Add 3 0; Add 3 0; Add 3 0; Mul 14 366; Add 4 0; Add 4 0; Add 4 0; Add 4 0;
  Add 412 565; Add 0 410; Add 411 566; Add 1 0; Add 568 410; Add 570 404; Add 412 0; Add 2 0;
  Add 7 2; Add 7 2; Add 6 2; Add 10 415; Add 424 419; Add 417 7; Add 425 413; Add 2 0; Add 4 2;
  Add 429 416; Add 405 429; Add 0 583; Add 1 426; Add 1 16; Add 409 423; Add 430 405; Add 588 0;
  Add 434 1; Add 23 1; Add 428 409; Add 5 0; Add 8 3; Add 8 3; Add 12 7; Add 12 7; Mul 600 605;
  Mul 606 601; Add 1 0; Add 18 0; Add 21 5; Add 21 5; Add 30 10; Add 30 10; Add 30 10; Mul 399 5;
  Mul 408 5; Add 1 0; Mul 414 6; Add 2 0; Add 2 0; Mul 413 11; Mul 418 11; Add 1 0; Mul 420 14;
  Mul 402 0; Mul 414 2; Add 1 0; Mul 422 7; Add 2 0; Add 2 0; Mul 419 6; Mul 426 8; Add 1 0;
  Mul 428 9; Neg 0; Neg 2; Neg 6; Mul 0 28; Mul 423 26; Add 1 0; Mul 4 30; Mul 434 28; Add 1 0;
  Add 3 0; Mul 8 35; Mul 438 33; Add 1 0; Mul 12 36; Mul 445 34; Add 1 0; Add 7 0; Mul 16 41;
  Mul 449 39; Add 1 0; Add 7 0; Add 11 4; Mul 21 47; Mul 454 45; Add 1 0; Mul 653 35; Add 420 0;
  Mul 655 38; Add 421 0; Add 2 0; Mul 658 44; Add 422 0; Add 3 0; Add 3 0; Mul 662 9; Add 9 0;
  Mul 665 15; Add 9 0; Add 2 0; Mul 668 14; Add 14 0; Mul 676 19; Add 11 0; Add 5 0; Mul 679 23;
  Add 17 0; Add 5 0; Add 8 3; Mul 683 23; Add 23 0; Add 23 0; Add 21 4; Add 18 4; Mul 682 64;
  Add 447 0; Add 28 0; Mul 685 66; Add 451 0; Mul 693 72; Add 450 0; Add 5 0; Mul 696 72;
  Add 455 0; Add 5 0; Add 8 3; Mul 700 75; Add 460 0; Mul 696 81; Add 459 0; Add 40 0; Add 40 0;
  Mul 699 50; Add 44 0; Add 37 0; Mul 708 52; Add 7 0; Add 3 0; Mul 711 56; Add 24 0; Add 43 0;
  Add 6 3; Mul 715 56; Add 25 0; Add 25 0; Add 28 4; Add 14 4; Mul 720 100; Add 472 0; Add 59 0;
  Mul 723 100; Add 471 0; Add 64 0; Add 62 3; Mul 727 103; Add 461 0; Mul 42 628; Mul 31 29;
  Add 1 0; Mul 46 463; Mul 35 35; Add 1 0; Add 3 0; Mul 50 635; Mul 39 36; Add 1 0; Mul 54 475;
  Mul 39 41; Add 1 0; Add 7 0; Mul 58 474; Mul 43 46; Add 1 0; Add 7 0; Add 11 4; Mul 63 647;
  Mul 48 48; Add 1 0; Mul 487 66; Add 21 0; Mul 484 67; Add 20 0; Add 2 0; Mul 487 71; Add 19 0;
  Mul 657 71; Add 18 0; Add 5 0; Mul 660 75; Add 17 0; Add 5 0; Add 8 3; Mul 664 80; Add 16 0;
  Add 16 0; Add 21 4; Add 21 4; Mul 71 669; Mul 507 70; Add 1 0; Mul 75 504; Mul 505 76; Add 1 0;
  Add 3 0; Mul 79 676; Mul 509 77; Add 1 0; Mul 79 516; Mul 680 82; Add 1 0; Add 7 0; Mul 83 515;
  Mul 684 87; Add 1 0; Add 7 0; Add 11 4; Mul 88 688; Mul 689 89; Add 1 0; Mul 72 676; Mul 66 64;
  Add 1 0; Mul 76 508; Mul 70 70; Add 1 0; Add 3 0; Mul 80 683; Mul 74 71; Add 1 0; Mul 84 519;
  Mul 74 76; Add 1 0; Add 7 0; Mul 88 519; Mul 78 81; Add 1 0; Add 7 0; Add 11 4; Mul 93 695;
  Mul 83 83; Add 1 0; Mul 531 96; Add 21 0; Mul 529 97; Add 20 0; Add 2 0; Mul 532 101; Add 19 0;
  Mul 705 101; Add 18 0; Add 5 0; Mul 708 105; Add 17 0; Add 5 0; Add 8 3; Mul 712 110; Add 16 0;
  Add 16 0; Add 21 4; Add 21 4; Mul 106 717; Mul 551 105; Add 1 0; Mul 110 549; Mul 550 111;
  Add 1 0; Add 3 0; Mul 114 724; Mul 554 112; Add 1 0; Mul 114 560; Mul 728 117; Add 1 0; Add 7 0;
  Mul 118 560; Mul 732 122; Add 1 0; Add 7 0; Add 11 4; Mul 123 736; Mul 737 124; Add 1 0;
  Sub 63 0; Sub 68 5; Sub 68 5; Sub 90 27; Sub 90 27; Sub 90 27; Mul 174 745; Mul 163 133;
  Add 1 0; Mul 178 577; Mul 167 139; Add 1 0; Add 3 0; Mul 182 752; Mul 171 140; Add 1 0;
  Mul 186 588; Mul 171 145; Add 1 0; Add 7 0; Mul 190 588; Mul 175 150; Add 1 0; Add 7 0;
  Add 11 4; Mul 195 764; Mul 180 152; Add 1 0; Mul 619 165; Add 21 0; Mul 616 166; Add 20 0;
  Add 2 0; Mul 619 170; Add 19 0; Mul 789 170; Add 18 0; Add 5 0; Mul 792 174; Add 17 0; Add 5 0;
  Add 8 3; Mul 796 179; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 203 786; Mul 639 174; Add 1 0;
  Mul 207 618; Mul 637 180; Add 1 0; Add 3 0; Mul 211 793; Mul 641 181; Add 1 0; Mul 211 629;
  Mul 812 186; Add 1 0; Add 7 0; Mul 215 629; Mul 816 191; Add 1 0; Add 7 0; Add 11 4;
  Mul 220 805; Mul 821 193; Add 1 0; Mul 204 823; Mul 198 224; Add 1 0; Mul 208 658; Mul 202 230;
  Add 1 0; Add 3 0; Mul 212 830; Mul 206 231; Add 1 0; Mul 216 670; Mul 206 236; Add 1 0; Add 7 0;
  Mul 220 669; Mul 210 241; Add 1 0; Add 7 0; Add 11 4; Mul 225 842; Mul 215 243; Add 1 0;
  Mul 663 261; Add 21 0; Mul 661 262; Add 20 0; Add 2 0; Mul 664 266; Add 19 0; Mul 837 266;
  Add 18 0; Add 5 0; Mul 840 270; Add 17 0; Add 5 0; Add 8 3; Mul 844 275; Add 16 0; Add 16 0;
  Add 21 4; Add 21 4; Mul 238 864; Mul 683 265; Add 1 0; Mul 242 699; Mul 682 271; Add 1 0;
  Add 3 0; Mul 246 871; Mul 686 272; Add 1 0; Mul 246 711; Mul 860 277; Add 1 0; Add 7 0;
  Mul 250 710; Mul 864 282; Add 1 0; Add 7 0; Add 11 4; Mul 255 883; Mul 869 284; Add 1 0;
  Add 63 0; Add 68 5; Add 68 5; Add 90 27; Add 90 27; Add 90 27; Mul 132 875; Mul 136 988;
  Add 1 0; Mul 136 990; Mul 140 991; Add 1 0; Add 3 0; Mul 140 882; Add 0 3; Mul 143 996;
  Mul 147 997; Add 1 0; Add 6 0; Add 4 1; Add 7 1; Mul 149 890; Add 0 5; Add 15 569; Add 13 565;
  Add 1 0; Add 9 560; Add 2 0; Add 2 0; Add 6 2; Add 10 2; Add 10 2; Mul 161 901; Add 0 579;
  Add 0 9; Mul 165 904; Add 0 577; Add 0 10; Add 3 10; Mul 170 908; Add 0 574; Mul 35 869;
  Mul 39 1023; Add 1 0; Mul 39 1025; Mul 43 1026; Add 1 0; Add 3 0; Mul 43 876; Add 0 3;
  Mul 46 1031; Mul 50 1032; Add 1 0; Add 6 0; Add 4 1; Add 7 1; Mul 52 884; Add 0 5; Add 15 579;
  Add 13 575; Add 1 0; Add 9 570; Add 2 0; Add 2 0; Add 6 2; Add 10 2; Add 10 2; Mul 64 895;
  Add 0 589; Add 0 9; Mul 68 898; Add 0 587; Add 0 10; Add 3 10; Mul 73 902; Add 0 584; Add 35 0;
  Add 39 4; Add 39 4; Add 49 14; Add 49 14; Add 49 14; Mul 299 747; Mul 281 278; Add 1 0;
  Mul 303 751; Mul 285 285; Add 1 0; Add 3 0; Mul 307 754; Mul 289 285; Add 1 0; Mul 311 763;
  Mul 288 291; Add 1 0; Add 7 0; Mul 315 762; Mul 292 296; Add 1 0; Add 7 0; Add 11 4;
  Mul 320 766; Mul 297 297; Add 1 0; Mul 775 323; Add 21 0; Mul 772 324; Add 20 0; Add 2 0;
  Mul 775 328; Add 19 0; Mul 776 328; Add 18 0; Add 5 0; Mul 779 332; Add 17 0; Add 5 0; Add 8 3;
  Mul 783 337; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 321 788; Mul 795 319; Add 1 0;
  Mul 325 792; Mul 793 326; Add 1 0; Add 3 0; Mul 329 795; Mul 797 326; Add 1 0; Mul 328 804;
  Mul 799 332; Add 1 0; Add 7 0; Mul 332 803; Mul 803 337; Add 1 0; Add 7 0; Add 11 4;
  Mul 337 807; Mul 808 338; Add 1 0; Mul 22 1128; Mul 4 1127; Add 1 0; Mul 26 1129; Mul 8 1130;
  Add 1 0; Add 3 0; Mul 30 1135; Add 0 3; Mul 33 1135; Mul 10 1136; Add 1 0; Add 6 0; Add 4 1;
  Add 7 1; Mul 39 1143; Add 0 5; Add 15 618; Add 13 614; Add 1 0; Add 9 609; Add 2 0; Add 2 0;
  Add 6 2; Add 10 2; Add 10 2; Mul 29 1154; Add 0 628; Add 0 9; Mul 33 1157; Add 0 626; Add 0 10;
  Add 3 10; Mul 33 1161; Add 0 623; Add 103 0; Add 103 4; Add 103 4; Add 103 14; Add 103 14;
  Add 103 14; Mul 0 1170; Mul 4 565; Add 1 0; Mul 4 978; Mul 8 567; Add 1 0; Add 3 0; Mul 9 981;
  Mul 13 570; Add 1 0; Add 4 0; Add 4 0; Mul 630 573; Add 11 0; Mul 633 574; Add 10 0; Add 2 0;
  Mul 637 576; Add 9 0; Add 3 0; Add 3 0; Add 9 0; Add 622 1187; Add 0 1008; Add 1189 619;
  Add 1010 0; Add 3 1; Add 3 1; Add 610 1038; Add 611 1034; Add 1 1036; Add 1038 608;
  Add 1037 609; Add 1039 1; Add 4 1; Add 4 1; Add 9 1; Add 9 1; Add 587 587; Mul 0 588;
  Mul 1008 554; Add 1 0; Neg 0; Mul 0 607; Mul 582 605; Add 1 0; Mul 1016 9; Add 2 0; Add 2 0;
  Add 563 563; Mul 0 599; Mul 12 565; Add 1 0; Mul 1021 4; Add 2 0; Add 2 0; Neg 0; Mul 0 621;
  Mul 15 619; Add 1 0; Mul 598 23; Add 2 0; Add 2 0; Mul 1033 25; Add 3 0; Add 3 0; Add 3 0;
  Add 579 570; Mul 1235 19; Add 573 0; Add 573 0; Add 3 0; Mul 1246 5; Add 4 0; Add 4 0;
  Mul 1249 26; Add 580 0; Add 580 0; Add 7 3; Add 11 1; Add 8 1; Mul 1249 32; Add 586 0;
  Add 586 0; Add 596 582; Add 17 1; Mul 1259 19; Add 5 0; Add 5 0; Mul 1262 40; Add 589 0;
  Add 589 0; Add 8 3; Add 8 1; Add 8 1; Mul 14 1167; Mul 16 568; Add 1 0; Mul 586 586; Add 2 0;
  Add 2 0; Mul 21 1173; Mul 590 574; Add 1 0; Mul 576 24; Add 6 0; Add 6 0; Mul 579 595; Add 5 0;
  Add 5 0; Add 9 3; Mul 1183 30; Add 7 0; Add 7 0; Mul 1186 34; Add 7 0; Add 7 0; Add 10 3;
  Add 8 1; Add 8 1; Mul 25 1177; Mul 27 565; Add 1 0; Mul 578 578; Add 2 0; Add 2 0; Mul 32 1183;
  Mul 582 571; Add 1 0; Mul 573 35; Add 6 0; Add 6 0; Mul 576 587; Add 5 0; Add 5 0; Add 9 3;
  Mul 1193 41; Add 7 0; Add 7 0; Mul 1196 45; Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1;
  Sub 26 1; Sub 26 1; Mul 66 1204; Mul 68 592; Add 1 0; Mul 638 605; Add 2 0; Add 2 0;
  Mul 73 1210; Mul 642 598; Add 1 0; Mul 628 62; Add 6 0; Add 6 0; Mul 631 614; Add 5 0; Add 5 0;
  Add 9 3; Mul 1235 68; Add 7 0; Add 7 0; Mul 1238 72; Add 7 0; Add 7 0; Add 10 3; Add 8 1;
  Add 8 1; Mul 77 1244; Mul 79 645; Add 1 0; Mul 630 663; Add 2 0; Add 2 0; Mul 84 1250;
  Mul 634 651; Add 1 0; Mul 625 101; Add 6 0; Add 6 0; Mul 628 672; Add 5 0; Add 5 0; Add 9 3;
  Mul 1245 107; Add 7 0; Add 7 0; Mul 1248 111; Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1;
  Add 26 1; Add 26 1; Mul 52 1254; Mul 54 1367; Add 1 0; Add 1 372; Add 1 0; Mul 58 1259;
  Add 0 375; Add 3 374; Add 1 375; Add 4 1; Add 377 368; Add 3 0; Add 3 1; Add 3 1; Mul 14 1227;
  Mul 16 1381; Add 1 0; Add 1 351; Add 1 0; Mul 20 1232; Add 0 354; Add 3 353; Add 1 354; Add 4 1;
  Add 356 347; Add 3 0; Add 3 1; Add 3 1; Add 15 1; Add 15 1; Mul 109 1080; Mul 111 611; Add 1 0;
  Mul 637 637; Add 2 0; Add 2 0; Mul 116 1086; Mul 641 617; Add 1 0; Mul 619 119; Add 6 0;
  Add 6 0; Mul 622 646; Add 5 0; Add 5 0; Add 9 3; Mul 1096 125; Add 7 0; Add 7 0; Mul 1099 129;
  Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1; Mul 0 1423; Mul 2 1422; Add 1 0; Add 1 288;
  Add 1 0; Mul 6 1428; Add 0 291; Add 3 290; Add 1 291; Add 4 1; Add 293 284; Add 3 0; Add 3 1;
  Add 3 1; Add 40 1; Add 40 1; Mul 0 1440; Mul 2 835; Add 1 0; Mul 275 834; Add 2 0; Add 2 0;
  Mul 281 239; Add 3 0; Add 3 0; Add 3 0; Mul 900 242; Add 4 0; Add 4 0; Add 4 0; Add 4 0;
  Mul 263 1460; Add 887 0; Add 0 2;
  ShowZero 0 (* Δ² *)
].

Theorem part_1_size_2_valid : valid part_1_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** harmonic functions of degree n; size 3.
    Code: src/scalar/dual.rs, src/scalar/ring.rs, src/space/moebius.rs, src/space/point.rs,
    src/space/similarity.rs *)
Definition part_1_size_3 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Unknown 2;
  Zero 0; (* f is harmonic *)
  Constant 1;
  ShowNonzero 0; (* as src/space/sphere.rs finds *)
  Constant 0; Mul 0 0; Add 0 0; Sub 0 3; Div 4 11; Mul 1 0; Neg 5; Div 14 7; Sub 7 7; Neg 3;
  Neg 10; Mul 2 1; Mul 3 5; Add 1 0; Add 0 1; Mul 6 4; Add 1 0; Mul 0 9; Mul 0 18; Sub 10 0;
  Add 0 19; Mul 3 14; Sub 13 0; Add 0 22; Sub 24 23; Mul 0 15; Add 0 13; Add 0 14; Add 0 12;
  Mul 0 21; Mul 0 30; Sub 6 0; Add 0 31; Mul 3 26; Sub 25 0; Add 0 34; Sub 3 15; Sub 1 13;
  Mul 13 31; Add 27 0; Add 0 27; Add 0 25; Mul 0 34; Mul 0 43; Sub 35 0; Add 0 44; Mul 3 39;
  Sub 22 0; Add 0 47; Sub 3 28; Sub 1 26; Add 37 12; Add 0 36; Mul 0 45; Mul 0 54; Sub 46 0;
  Add 0 55; Mul 3 50; Sub 49 0; Add 0 58; Sub 3 39; Sub 1 37; Mul 37 51; Add 48 0; Mul 0 56;
  Mul 0 65; Sub 57 0; Add 0 66; Mul 3 61; Sub 60 0; Add 0 69; Sub 3 50; Sub 1 48; Sub 75 72;
  Mul 0 69; Neg 81; Neg 81; Mul 40 77; Mul 28 2; Add 1 0; Mul 19 3; Add 1 0; Mul 10 7; Add 1 0;
  Mul 46 84; Mul 34 9; Add 1 0; Mul 25 10; Add 1 0; Mul 16 14; Add 1 0; Div 91 7; Neg 1; Mul 0 1;
  Div 94 96; Mul 101 0; Sub 2 0;
  ShowZero 0; (* the inverse of a point *)
  Sub 88 50; Add 0 97; Sub 0 75; Sub 75 42; Add 0 100; Sub 0 78; Mul 3 27; Add 19 0; Mul 2 28;
  Add 1 0; Add 0 17; Neg 0; Mul 0 17; Mul 115 15; Sub 1 0;
  ShowZero 0; (* the inverse of a point *)
  Unknown 3; Mul 95 107; Sub 105 0; Add 0 114; Mul 86 110; Sub 108 0; Add 0 117; Sub 0 3;
  Mul 77 114; Sub 112 0; Add 0 121; Sub 0 7; Mul 70 118; Sub 116 0; Add 0 125; Sub 0 11;
  Mul 63 122; Sub 104 0; Add 0 129; Sub 0 15; Mul 12 132; Mul 9 57; Add 1 0; Mul 7 58; Add 1 0;
  Mul 5 62; Add 1 0; Mul 139 26; Neg 24; Neg 120; Mul 58 1; Mul 52 119; Add 1 0; Mul 37 121;
  Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Mul 0 58; Mul 38 56; Sub 1 0;
  ShowZero 0; (* the inverse of a point *)
  Unknown 4; Mul 153 160; Mul 154 155; Add 1 0; Add 1 155; Add 1 0; Mul 159 158; Add 158 0;
  Add 3 0; Add 6 2; Add 6 0; Add 5 2; Mul 165 165; Add 11 0; Mul 173 166; Add 8 0; Add 8 0;
  Add 7 1; Add 9 1; Add 6 4; Add 6 0; Add 10 3; Add 10 3; Mul 176 182; Mul 183 177; Add 1 0;
  Mul 178 184; Add 0 178; Add 0 178; Add 179 179; Add 1 0; Mul 189 183; Add 183 0; Add 183 0;
  Add 4 0; Add 7 2; Add 7 2; Add 6 2; Add 11 6; Add 13 0; Add 19 4; Add 19 4; Add 19 4;
  Mul 101 101; Neg 0; Mul 0 5; Add 104 104; Mul 0 1; Neg 0; Mul 0 9; Mul 5 9; Add 1 0; Add 6 6;
  Mul 0 7; Mul 7 2; Add 1 0; Neg 0; Mul 0 17; Mul 9 17; Add 1 0; Mul 15 18; Add 2 0; Add 2 0;
  Add 11 11; Mul 0 18; Mul 12 13; Add 1 0; Mul 20 4; Add 2 0; Add 2 0; Neg 0; Mul 0 31; Mul 15 31;
  Add 1 0; Mul 25 32; Add 2 0; Add 2 0; Mul 32 34; Add 3 0; Add 3 0; Add 3 0; Mul 233 139;
  Mul 234 36; Add 1 0; Mul 236 32; Add 2 0; Add 2 0; Mul 240 24; Add 3 0; Add 3 0; Mul 243 38;
  Add 8 0; Add 8 0; Add 6 3; Mul 247 48; Add 13 0; Mul 255 15; Add 9 0; Add 9 0; Mul 258 36;
  Add 9 0; Add 9 0; Add 12 3; Mul 262 51; Add 9 0; Add 9 0; Add 13 4; Add 13 4; Mul 261 166;
  Mul 268 63; Add 1 0; Mul 263 48; Add 27 0; Add 27 0; Add 27 0; Mul 273 34; Add 4 0; Add 4 0;
  Mul 276 55; Add 34 0; Add 34 0; Add 7 3; Mul 280 70; Add 40 0; Add 40 0; Add 38 4; Add 11 4;
  Mul 285 81; Add 46 0; Mul 21 186; Mul 23 19; Add 1 0; Mul 26 26; Add 2 0; Add 2 0; Mul 28 192;
  Mul 30 25; Add 1 0; Mul 27 31; Add 6 0; Add 6 0; Mul 30 35; Add 5 0; Add 5 0; Add 9 3;
  Mul 39 202; Mul 35 35; Add 1 0; Mul 205 40; Add 10 0; Add 10 0; Mul 208 44; Add 10 0; Add 10 0;
  Add 13 3; Mul 212 49; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 49 217; Mul 218 50; Add 1 0;
  Mul 220 220; Mul 37 206; Mul 39 36; Add 1 0; Mul 42 42; Add 2 0; Add 2 0; Mul 44 212; Mul 46 42;
  Add 1 0; Mul 44 47; Add 6 0; Add 6 0; Mul 47 51; Add 5 0; Add 5 0; Add 9 3; Mul 55 222;
  Mul 52 52; Add 1 0; Mul 225 56; Add 10 0; Add 10 0; Mul 228 60; Add 10 0; Add 10 0; Add 13 3;
  Mul 232 65; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 66 237; Mul 238 67; Add 1 0; Mul 240 240;
  Sub 35 0; Sub 37 2; Sub 43 8; Sub 43 8; Sub 43 8; Mul 96 246; Mul 98 76; Add 1 0; Mul 101 82;
  Add 2 0; Add 2 0; Mul 103 252; Mul 105 82; Add 1 0; Mul 102 87; Add 6 0; Add 6 0; Mul 105 91;
  Add 5 0; Add 5 0; Add 9 3; Mul 114 262; Mul 110 92; Add 1 0; Mul 280 96; Add 10 0; Add 10 0;
  Mul 283 100; Add 10 0; Add 10 0; Add 13 3; Mul 287 105; Add 9 0; Add 9 0; Add 14 4; Add 14 4;
  Mul 124 277; Mul 293 107; Add 1 0; Mul 295 280; Mul 112 296; Mul 114 129; Add 1 0; Mul 117 136;
  Add 2 0; Add 2 0; Mul 119 302; Mul 121 135; Add 1 0; Mul 119 141; Add 6 0; Add 6 0; Mul 122 145;
  Add 5 0; Add 5 0; Add 9 3; Mul 130 312; Mul 127 145; Add 1 0; Mul 300 150; Add 10 0; Add 10 0;
  Mul 303 154; Add 10 0; Add 10 0; Add 13 3; Mul 307 159; Add 9 0; Add 9 0; Add 14 4; Add 14 4;
  Mul 141 327; Mul 313 160; Add 1 0; Mul 315 330; Add 35 0; Add 37 2; Add 43 8; Add 43 8;
  Add 43 8; Mul 171 79; Mul 173 79; Add 1 0; Mul 176 80; Add 2 0; Add 2 0; Mul 178 85; Mul 180 85;
  Add 1 0; Mul 177 85; Add 6 0; Add 6 0; Mul 180 89; Add 5 0; Add 5 0; Add 9 3; Mul 189 95;
  Mul 185 95; Add 1 0; Mul 355 94; Add 10 0; Add 10 0; Mul 358 98; Add 10 0; Add 10 0; Add 13 3;
  Mul 362 103; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 199 110; Mul 368 110; Add 1 0;
  Mul 370 113; Mul 187 39; Mul 189 39; Add 1 0; Mul 192 40; Add 2 0; Add 2 0; Mul 194 45;
  Mul 196 45; Add 1 0; Mul 194 45; Add 6 0; Add 6 0; Mul 197 49; Add 5 0; Add 5 0; Add 9 3;
  Mul 205 55; Mul 202 55; Add 1 0; Mul 375 54; Add 10 0; Add 10 0; Mul 378 58; Add 10 0; Add 10 0;
  Add 13 3; Mul 382 63; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 216 70; Mul 388 70; Add 1 0;
  Mul 390 73; Sub 35 0; Sub 37 2; Sub 43 8; Sub 43 8; Sub 43 8; Mul 246 79; Mul 248 79; Add 1 0;
  Mul 251 80; Add 2 0; Add 2 0; Mul 253 85; Mul 255 85; Add 1 0; Mul 252 85; Add 6 0; Add 6 0;
  Mul 255 89; Add 5 0; Add 5 0; Add 9 3; Mul 264 95; Mul 260 95; Add 1 0; Mul 430 94; Add 10 0;
  Add 10 0; Mul 433 98; Add 10 0; Add 10 0; Add 13 3; Mul 437 103; Add 9 0; Add 9 0; Add 14 4;
  Add 14 4; Mul 274 110; Mul 443 110; Add 1 0; Mul 445 113; Mul 262 189; Mul 264 189; Add 1 0;
  Mul 267 190; Add 2 0; Add 2 0; Mul 269 195; Mul 271 195; Add 1 0; Mul 269 195; Add 6 0; Add 6 0;
  Mul 272 199; Add 5 0; Add 5 0; Add 9 3; Mul 280 205; Mul 277 205; Add 1 0; Mul 450 204;
  Add 10 0; Add 10 0; Mul 453 208; Add 10 0; Add 10 0; Add 13 3; Mul 457 213; Add 9 0; Add 9 0;
  Add 14 4; Add 14 4; Mul 291 220; Mul 463 220; Add 1 0; Mul 465 223; Add 35 0; Add 37 2;
  Add 43 8; Add 43 8; Add 43 8; Mul 75 469; Mul 77 582; Add 1 0; Mul 80 584; Add 2 0; Add 2 0;
  Mul 82 475; Add 0 3; Mul 86 589; Add 5 0; Add 5 0; Add 3 1; Add 6 1; Mul 90 482; Add 0 5;
  Mul 94 596; Add 7 0; Add 7 0; Add 7 0; Add 4 2; Add 8 2; Add 8 2; Mul 100 491; Add 0 7;
  Mul 103 493; Mul 25 453; Mul 27 607; Add 1 0; Mul 30 609; Add 2 0; Add 2 0; Mul 32 459; Add 0 3;
  Mul 36 614; Add 5 0; Add 5 0; Add 3 1; Add 6 1; Mul 40 466; Add 0 5; Mul 44 621; Add 7 0;
  Add 7 0; Add 7 0; Add 4 2; Add 8 2; Add 8 2; Mul 50 475; Add 0 7; Mul 53 477; Add 25 0;
  Add 27 2; Add 32 7; Add 32 7; Add 32 7; Mul 324 320; Mul 326 322; Add 1 0; Mul 329 329; Add 2 0;
  Add 2 0; Mul 331 326; Mul 333 328; Add 1 0; Mul 330 334; Add 6 0; Add 6 0; Mul 333 338; Add 5 0;
  Add 5 0; Add 9 3; Mul 342 336; Mul 338 338; Add 1 0; Mul 339 343; Add 10 0; Add 10 0;
  Mul 342 347; Add 10 0; Add 10 0; Add 13 3; Mul 346 352; Add 9 0; Add 9 0; Add 14 4; Add 14 4;
  Mul 352 351; Mul 352 353; Add 1 0; Mul 354 354; Mul 4 673; Mul 6 672; Add 1 0; Mul 9 674;
  Add 2 0; Add 2 0; Mul 11 679; Add 0 3; Mul 9 679; Add 5 0; Add 5 0; Add 3 1; Add 6 1;
  Mul 19 686; Add 0 5; Mul 15 686; Add 7 0; Add 7 0; Add 7 0; Add 4 2; Add 8 2; Add 8 2;
  Mul 23 695; Add 0 7; Mul 24 697; Add 64 0; Add 64 2; Add 64 7; Add 64 7; Add 64 7; Mul 0 704;
  Mul 2 510; Add 1 0; Mul 5 511; Add 2 0; Add 2 0; Mul 9 513; Add 3 0; Add 3 0; Add 3 0;
  Mul 14 516; Add 4 0; Add 4 0; Add 4 0; Add 4 0; Add 562 715; Add 0 560; Add 561 716; Add 1 0;
  Add 718 560; Add 720 554; Add 562 0; Add 2 0; Add 7 2; Add 7 2; Add 6 2; Add 10 565;
  Add 574 569; Add 567 7; Add 575 563; Add 2 0; Add 4 2; Add 579 566; Add 555 579; Add 0 733;
  Add 1 576; Add 1 16; Add 559 573; Add 580 555; Add 738 0; Add 584 1; Add 23 1; Add 578 559;
  Add 5 0; Add 8 3; Add 8 3; Add 12 7; Add 12 7; Mul 750 755; Mul 756 751; Add 1 0; Add 18 0;
  Add 21 5; Add 21 5; Add 30 10; Add 30 10; Add 30 10; Mul 549 5; Mul 558 5; Add 1 0; Mul 564 6;
  Add 2 0; Add 2 0; Mul 563 11; Mul 568 11; Add 1 0; Mul 570 14; Mul 552 0; Mul 564 2; Add 1 0;
  Mul 572 7; Add 2 0; Add 2 0; Mul 569 6; Mul 576 8; Add 1 0; Mul 578 9; Neg 0; Neg 2; Neg 6;
  Mul 0 28; Mul 573 26; Add 1 0; Mul 4 30; Mul 584 28; Add 1 0; Add 3 0; Mul 8 35; Mul 588 33;
  Add 1 0; Mul 12 36; Mul 595 34; Add 1 0; Add 7 0; Mul 16 41; Mul 599 39; Add 1 0; Add 7 0;
  Add 11 4; Mul 21 47; Mul 604 45; Add 1 0; Mul 803 35; Add 570 0; Mul 805 38; Add 571 0; Add 2 0;
  Mul 808 44; Add 572 0; Add 3 0; Add 3 0; Mul 812 9; Add 9 0; Mul 815 15; Add 9 0; Add 2 0;
  Mul 818 14; Add 14 0; Mul 826 19; Add 11 0; Add 5 0; Mul 829 23; Add 17 0; Add 5 0; Add 8 3;
  Mul 833 23; Add 23 0; Add 23 0; Add 21 4; Add 18 4; Mul 832 64; Add 597 0; Add 28 0; Mul 835 66;
  Add 601 0; Mul 843 72; Add 600 0; Add 5 0; Mul 846 72; Add 605 0; Add 5 0; Add 8 3; Mul 850 75;
  Add 610 0; Mul 846 81; Add 609 0; Add 40 0; Add 40 0; Mul 849 50; Add 44 0; Add 37 0;
  Mul 858 52; Add 7 0; Add 3 0; Mul 861 56; Add 24 0; Add 43 0; Add 6 3; Mul 865 56; Add 25 0;
  Add 25 0; Add 28 4; Add 14 4; Mul 870 100; Add 622 0; Add 59 0; Mul 873 100; Add 621 0;
  Add 64 0; Add 62 3; Mul 877 103; Add 611 0; Mul 42 778; Mul 31 29; Add 1 0; Mul 46 613;
  Mul 35 35; Add 1 0; Add 3 0; Mul 50 785; Mul 39 36; Add 1 0; Mul 54 625; Mul 39 41; Add 1 0;
  Add 7 0; Mul 58 624; Mul 43 46; Add 1 0; Add 7 0; Add 11 4; Mul 63 797; Mul 48 48; Add 1 0;
  Mul 637 66; Add 21 0; Mul 634 67; Add 20 0; Add 2 0; Mul 637 71; Add 19 0; Mul 807 71; Add 18 0;
  Add 5 0; Mul 810 75; Add 17 0; Add 5 0; Add 8 3; Mul 814 80; Add 16 0; Add 16 0; Add 21 4;
  Add 21 4; Mul 71 819; Mul 657 70; Add 1 0; Mul 75 654; Mul 655 76; Add 1 0; Add 3 0; Mul 79 826;
  Mul 659 77; Add 1 0; Mul 79 666; Mul 830 82; Add 1 0; Add 7 0; Mul 83 665; Mul 834 87; Add 1 0;
  Add 7 0; Add 11 4; Mul 88 838; Mul 839 89; Add 1 0; Mul 72 826; Mul 66 64; Add 1 0; Mul 76 658;
  Mul 70 70; Add 1 0; Add 3 0; Mul 80 833; Mul 74 71; Add 1 0; Mul 84 669; Mul 74 76; Add 1 0;
  Add 7 0; Mul 88 669; Mul 78 81; Add 1 0; Add 7 0; Add 11 4; Mul 93 845; Mul 83 83; Add 1 0;
  Mul 681 96; Add 21 0; Mul 679 97; Add 20 0; Add 2 0; Mul 682 101; Add 19 0; Mul 855 101;
  Add 18 0; Add 5 0; Mul 858 105; Add 17 0; Add 5 0; Add 8 3; Mul 862 110; Add 16 0; Add 16 0;
  Add 21 4; Add 21 4; Mul 106 867; Mul 701 105; Add 1 0; Mul 110 699; Mul 700 111; Add 1 0;
  Add 3 0; Mul 114 874; Mul 704 112; Add 1 0; Mul 114 710; Mul 878 117; Add 1 0; Add 7 0;
  Mul 118 710; Mul 882 122; Add 1 0; Add 7 0; Add 11 4; Mul 123 886; Mul 887 124; Add 1 0;
  Sub 63 0; Sub 68 5; Sub 68 5; Sub 90 27; Sub 90 27; Sub 90 27; Mul 174 895; Mul 163 133;
  Add 1 0; Mul 178 727; Mul 167 139; Add 1 0; Add 3 0; Mul 182 902; Mul 171 140; Add 1 0;
  Mul 186 738; Mul 171 145; Add 1 0; Add 7 0; Mul 190 738; Mul 175 150; Add 1 0; Add 7 0;
  Add 11 4; Mul 195 914; Mul 180 152; Add 1 0; Mul 769 165; Add 21 0; Mul 766 166; Add 20 0;
  Add 2 0; Mul 769 170; Add 19 0; Mul 939 170; Add 18 0; Add 5 0; Mul 942 174; Add 17 0; Add 5 0;
  Add 8 3; Mul 946 179; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 203 936; Mul 789 174; Add 1 0;
  Mul 207 768; Mul 787 180; Add 1 0; Add 3 0; Mul 211 943; Mul 791 181; Add 1 0; Mul 211 779;
  Mul 962 186; Add 1 0; Add 7 0; Mul 215 779; Mul 966 191; Add 1 0; Add 7 0; Add 11 4;
  Mul 220 955; Mul 971 193; Add 1 0; Mul 204 973; Mul 198 224; Add 1 0; Mul 208 808; Mul 202 230;
  Add 1 0; Add 3 0; Mul 212 980; Mul 206 231; Add 1 0; Mul 216 820; Mul 206 236; Add 1 0; Add 7 0;
  Mul 220 819; Mul 210 241; Add 1 0; Add 7 0; Add 11 4; Mul 225 992; Mul 215 243; Add 1 0;
  Mul 813 261; Add 21 0; Mul 811 262; Add 20 0; Add 2 0; Mul 814 266; Add 19 0; Mul 987 266;
  Add 18 0; Add 5 0; Mul 990 270; Add 17 0; Add 5 0; Add 8 3; Mul 994 275; Add 16 0; Add 16 0;
  Add 21 4; Add 21 4; Mul 238 1014; Mul 833 265; Add 1 0; Mul 242 849; Mul 832 271; Add 1 0;
  Add 3 0; Mul 246 1021; Mul 836 272; Add 1 0; Mul 246 861; Mul 1010 277; Add 1 0; Add 7 0;
  Mul 250 860; Mul 1014 282; Add 1 0; Add 7 0; Add 11 4; Mul 255 1033; Mul 1019 284; Add 1 0;
  Add 63 0; Add 68 5; Add 68 5; Add 90 27; Add 90 27; Add 90 27; Mul 306 785; Mul 295 138;
  Add 1 0; Mul 310 787; Mul 299 140; Add 1 0; Add 3 0; Mul 314 792; Mul 303 145; Add 1 0;
  Mul 318 793; Mul 303 146; Add 1 0; Add 7 0; Mul 322 798; Mul 307 151; Add 1 0; Add 7 0;
  Add 11 4; Mul 327 804; Mul 312 157; Add 1 0; Mul 901 156; Add 21 0; Mul 898 157; Add 20 0;
  Add 2 0; Mul 901 161; Add 19 0; Mul 1071 161; Add 18 0; Add 5 0; Mul 1074 165; Add 17 0;
  Add 5 0; Add 8 3; Mul 1078 170; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 335 826;
  Mul 921 179; Add 1 0; Mul 339 828; Mul 919 181; Add 1 0; Add 3 0; Mul 343 833; Mul 923 186;
  Add 1 0; Mul 343 834; Mul 1094 187; Add 1 0; Add 7 0; Mul 347 839; Mul 1098 192; Add 1 0;
  Add 7 0; Add 11 4; Mul 352 845; Mul 1103 198; Add 1 0; Mul 336 773; Mul 330 69; Add 1 0;
  Mul 340 775; Mul 334 71; Add 1 0; Add 3 0; Mul 344 780; Mul 338 76; Add 1 0; Mul 348 781;
  Mul 338 77; Add 1 0; Add 7 0; Mul 352 786; Mul 342 82; Add 1 0; Add 7 0; Add 11 4; Mul 357 792;
  Mul 347 88; Add 1 0; Mul 945 87; Add 21 0; Mul 943 88; Add 20 0; Add 2 0; Mul 946 92; Add 19 0;
  Mul 1119 92; Add 18 0; Add 5 0; Mul 1122 96; Add 17 0; Add 5 0; Add 8 3; Mul 1126 101; Add 16 0;
  Add 16 0; Add 21 4; Add 21 4; Mul 370 814; Mul 965 110; Add 1 0; Mul 374 816; Mul 964 112;
  Add 1 0; Add 3 0; Mul 378 821; Mul 968 117; Add 1 0; Mul 378 822; Mul 1142 118; Add 1 0;
  Add 7 0; Mul 382 827; Mul 1146 123; Add 1 0; Add 7 0; Add 11 4; Mul 387 833; Mul 1151 129;
  Add 1 0; Sub 63 0; Sub 68 5; Sub 68 5; Sub 90 27; Sub 90 27; Sub 90 27; Mul 438 842;
  Mul 427 138; Add 1 0; Mul 442 844; Mul 431 140; Add 1 0; Add 3 0; Mul 446 849; Mul 435 145;
  Add 1 0; Mul 450 850; Mul 435 146; Add 1 0; Add 7 0; Mul 454 855; Mul 439 151; Add 1 0; Add 7 0;
  Add 11 4; Mul 459 861; Mul 444 157; Add 1 0; Mul 1033 156; Add 21 0; Mul 1030 157; Add 20 0;
  Add 2 0; Mul 1033 161; Add 19 0; Mul 1203 161; Add 18 0; Add 5 0; Mul 1206 165; Add 17 0;
  Add 5 0; Add 8 3; Mul 1210 170; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 467 883;
  Mul 1053 179; Add 1 0; Mul 471 885; Mul 1051 181; Add 1 0; Add 3 0; Mul 475 890; Mul 1055 186;
  Add 1 0; Mul 475 891; Mul 1226 187; Add 1 0; Add 7 0; Mul 479 896; Mul 1230 192; Add 1 0;
  Add 7 0; Add 11 4; Mul 484 902; Mul 1235 198; Add 1 0; Mul 468 980; Mul 462 333; Add 1 0;
  Mul 472 982; Mul 466 335; Add 1 0; Add 3 0; Mul 476 987; Mul 470 340; Add 1 0; Mul 480 988;
  Mul 470 341; Add 1 0; Add 7 0; Mul 484 993; Mul 474 346; Add 1 0; Add 7 0; Add 11 4;
  Mul 489 999; Mul 479 352; Add 1 0; Mul 1077 351; Add 21 0; Mul 1075 352; Add 20 0; Add 2 0;
  Mul 1078 356; Add 19 0; Mul 1251 356; Add 18 0; Add 5 0; Mul 1254 360; Add 17 0; Add 5 0;
  Add 8 3; Mul 1258 365; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 502 1021; Mul 1097 374;
  Add 1 0; Mul 506 1023; Mul 1096 376; Add 1 0; Add 3 0; Mul 510 1028; Mul 1100 381; Add 1 0;
  Mul 510 1029; Mul 1274 382; Add 1 0; Add 7 0; Mul 514 1034; Mul 1278 387; Add 1 0; Add 7 0;
  Add 11 4; Mul 519 1040; Mul 1283 393; Add 1 0; Add 63 0; Add 68 5; Add 68 5; Add 90 27;
  Add 90 27; Add 90 27; Mul 132 1289; Mul 136 1402; Add 1 0; Mul 136 1404; Mul 140 1405; Add 1 0;
  Add 3 0; Mul 140 1296; Add 0 3; Mul 143 1410; Mul 147 1411; Add 1 0; Add 6 0; Add 4 1; Add 7 1;
  Mul 149 1304; Add 0 5; Add 15 833; Add 13 829; Add 1 0; Add 9 824; Add 2 0; Add 2 0; Add 6 2;
  Add 10 2; Add 10 2; Mul 161 1315; Add 0 843; Add 0 9; Mul 165 1318; Add 0 841; Add 0 10;
  Add 3 10; Mul 170 1322; Add 0 838; Mul 35 1283; Mul 39 1437; Add 1 0; Mul 39 1439; Mul 43 1440;
  Add 1 0; Add 3 0; Mul 43 1290; Add 0 3; Mul 46 1445; Mul 50 1446; Add 1 0; Add 6 0; Add 4 1;
  Add 7 1; Mul 52 1298; Add 0 5; Add 15 843; Add 13 839; Add 1 0; Add 9 834; Add 2 0; Add 2 0;
  Add 6 2; Add 10 2; Add 10 2; Mul 64 1309; Add 0 853; Add 0 9; Mul 68 1312; Add 0 851; Add 0 10;
  Add 3 10; Mul 73 1316; Add 0 848; Add 35 0; Add 39 4; Add 39 4; Add 49 14; Add 49 14; Add 49 14;
  Mul 563 1161; Mul 545 542; Add 1 0; Mul 567 1165; Mul 549 549; Add 1 0; Add 3 0; Mul 571 1168;
  Mul 553 549; Add 1 0; Mul 575 1177; Mul 552 555; Add 1 0; Add 7 0; Mul 579 1176; Mul 556 560;
  Add 1 0; Add 7 0; Add 11 4; Mul 584 1180; Mul 561 561; Add 1 0; Mul 1189 587; Add 21 0;
  Mul 1186 588; Add 20 0; Add 2 0; Mul 1189 592; Add 19 0; Mul 1190 592; Add 18 0; Add 5 0;
  Mul 1193 596; Add 17 0; Add 5 0; Add 8 3; Mul 1197 601; Add 16 0; Add 16 0; Add 21 4; Add 21 4;
  Mul 585 1202; Mul 1209 583; Add 1 0; Mul 589 1206; Mul 1207 590; Add 1 0; Add 3 0; Mul 593 1209;
  Mul 1211 590; Add 1 0; Mul 592 1218; Mul 1213 596; Add 1 0; Add 7 0; Mul 596 1217; Mul 1217 601;
  Add 1 0; Add 7 0; Add 11 4; Mul 601 1221; Mul 1222 602; Add 1 0; Mul 22 1542; Mul 4 1541;
  Add 1 0; Mul 26 1543; Mul 8 1544; Add 1 0; Add 3 0; Mul 30 1549; Add 0 3; Mul 33 1549;
  Mul 10 1550; Add 1 0; Add 6 0; Add 4 1; Add 7 1; Mul 39 1557; Add 0 5; Add 15 882; Add 13 878;
  Add 1 0; Add 9 873; Add 2 0; Add 2 0; Add 6 2; Add 10 2; Add 10 2; Mul 29 1568; Add 0 892;
  Add 0 9; Mul 33 1571; Add 0 890; Add 0 10; Add 3 10; Mul 33 1575; Add 0 887; Add 103 0;
  Add 103 4; Add 103 4; Add 103 14; Add 103 14; Add 103 14; Mul 0 1584; Mul 4 829; Add 1 0;
  Mul 4 1392; Mul 8 831; Add 1 0; Add 3 0; Mul 9 1395; Mul 13 834; Add 1 0; Add 4 0; Add 4 0;
  Mul 894 837; Add 11 0; Mul 897 838; Add 10 0; Add 2 0; Mul 901 840; Add 9 0; Add 3 0; Add 3 0;
  Add 9 0; Add 886 1601; Add 0 1422; Add 1603 883; Add 1424 0; Add 3 1; Add 3 1; Add 874 1452;
  Add 875 1448; Add 1 1450; Add 1452 872; Add 1451 873; Add 1453 1; Add 4 1; Add 4 1; Add 9 1;
  Add 9 1; Add 851 851; Mul 0 852; Mul 1422 818; Add 1 0; Neg 0; Mul 0 871; Mul 846 869; Add 1 0;
  Mul 1430 9; Add 2 0; Add 2 0; Add 827 827; Mul 0 863; Mul 12 829; Add 1 0; Mul 1435 4; Add 2 0;
  Add 2 0; Neg 0; Mul 0 885; Mul 15 883; Add 1 0; Mul 862 23; Add 2 0; Add 2 0; Mul 1447 25;
  Add 3 0; Add 3 0; Add 3 0; Add 843 834; Mul 1649 19; Add 837 0; Add 837 0; Add 3 0; Mul 1660 5;
  Add 4 0; Add 4 0; Mul 1663 26; Add 844 0; Add 844 0; Add 7 3; Add 11 1; Add 8 1; Mul 1663 32;
  Add 850 0; Add 850 0; Add 860 846; Add 17 1; Mul 1673 19; Add 5 0; Add 5 0; Mul 1676 40;
  Add 853 0; Add 853 0; Add 8 3; Add 8 1; Add 8 1; Mul 14 1581; Mul 16 832; Add 1 0; Mul 850 850;
  Add 2 0; Add 2 0; Mul 21 1587; Mul 854 838; Add 1 0; Mul 840 24; Add 6 0; Add 6 0; Mul 843 859;
  Add 5 0; Add 5 0; Add 9 3; Mul 1597 30; Add 7 0; Add 7 0; Mul 1600 34; Add 7 0; Add 7 0;
  Add 10 3; Add 8 1; Add 8 1; Mul 25 1591; Mul 27 829; Add 1 0; Mul 842 842; Add 2 0; Add 2 0;
  Mul 32 1597; Mul 846 835; Add 1 0; Mul 837 35; Add 6 0; Add 6 0; Mul 840 851; Add 5 0; Add 5 0;
  Add 9 3; Mul 1607 41; Add 7 0; Add 7 0; Mul 1610 45; Add 7 0; Add 7 0; Add 10 3; Add 8 1;
  Add 8 1; Sub 26 1; Sub 26 1; Mul 66 1618; Mul 68 856; Add 1 0; Mul 902 869; Add 2 0; Add 2 0;
  Mul 73 1624; Mul 906 862; Add 1 0; Mul 892 62; Add 6 0; Add 6 0; Mul 895 878; Add 5 0; Add 5 0;
  Add 9 3; Mul 1649 68; Add 7 0; Add 7 0; Mul 1652 72; Add 7 0; Add 7 0; Add 10 3; Add 8 1;
  Add 8 1; Mul 77 1658; Mul 79 909; Add 1 0; Mul 894 927; Add 2 0; Add 2 0; Mul 84 1664;
  Mul 898 915; Add 1 0; Mul 889 101; Add 6 0; Add 6 0; Mul 892 936; Add 5 0; Add 5 0; Add 9 3;
  Mul 1659 107; Add 7 0; Add 7 0; Mul 1662 111; Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1;
  Add 26 1; Add 26 1; Mul 118 1428; Mul 120 781; Add 1 0; Mul 954 780; Add 2 0; Add 2 0;
  Mul 125 1434; Mul 958 787; Add 1 0; Mul 944 62; Add 6 0; Add 6 0; Mul 947 789; Add 5 0; Add 5 0;
  Add 9 3; Mul 1701 68; Add 7 0; Add 7 0; Mul 1704 72; Add 7 0; Add 7 0; Add 10 3; Add 8 1;
  Add 8 1; Mul 129 1378; Mul 131 674; Add 1 0; Mul 946 673; Add 2 0; Add 2 0; Mul 136 1384;
  Mul 950 680; Add 1 0; Mul 941 35; Add 6 0; Add 6 0; Mul 944 682; Add 5 0; Add 5 0; Add 9 3;
  Mul 1711 41; Add 7 0; Add 7 0; Mul 1714 45; Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1;
  Sub 26 1; Sub 26 1; Mul 170 1405; Mul 172 701; Add 1 0; Mul 1006 700; Add 2 0; Add 2 0;
  Mul 177 1411; Mul 1010 707; Add 1 0; Mul 996 62; Add 6 0; Add 6 0; Mul 999 709; Add 5 0;
  Add 5 0; Add 9 3; Mul 1753 68; Add 7 0; Add 7 0; Mul 1756 72; Add 7 0; Add 7 0; Add 10 3;
  Add 8 1; Add 8 1; Mul 181 1505; Mul 183 858; Add 1 0; Mul 998 857; Add 2 0; Add 2 0;
  Mul 188 1511; Mul 1002 864; Add 1 0; Mul 993 139; Add 6 0; Add 6 0; Mul 996 866; Add 5 0;
  Add 5 0; Add 9 3; Mul 1763 145; Add 7 0; Add 7 0; Mul 1766 149; Add 7 0; Add 7 0; Add 10 3;
  Add 8 1; Add 8 1; Add 26 1; Add 26 1; Mul 52 1772; Mul 54 1885; Add 1 0; Add 1 476; Add 1 0;
  Mul 58 1777; Add 0 479; Add 3 478; Add 1 479; Add 4 1; Add 481 472; Add 3 0; Add 3 1; Add 3 1;
  Mul 14 1745; Mul 16 1899; Add 1 0; Add 1 455; Add 1 0; Mul 20 1750; Add 0 458; Add 3 457;
  Add 1 458; Add 4 1; Add 460 451; Add 3 0; Add 3 1; Add 3 1; Add 15 1; Add 15 1; Mul 213 1598;
  Mul 215 979; Add 1 0; Mul 1005 1005; Add 2 0; Add 2 0; Mul 220 1604; Mul 1009 985; Add 1 0;
  Mul 987 223; Add 6 0; Add 6 0; Mul 990 1014; Add 5 0; Add 5 0; Add 9 3; Mul 1614 229; Add 7 0;
  Add 7 0; Mul 1617 233; Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1; Mul 0 1941; Mul 2 1940;
  Add 1 0; Add 1 392; Add 1 0; Mul 6 1946; Add 0 395; Add 3 394; Add 1 395; Add 4 1; Add 397 388;
  Add 3 0; Add 3 1; Add 3 1; Add 40 1; Add 40 1; Mul 0 1958; Mul 2 1203; Add 1 0; Mul 379 1202;
  Add 2 0; Add 2 0; Mul 385 343; Add 3 0; Add 3 0; Add 3 0; Mul 1268 346; Add 4 0; Add 4 0;
  Add 4 0; Add 4 0; Mul 367 1978; Add 1255 0; Add 0 2;
  ShowZero 0 (* Δ² *)
].

Theorem part_1_size_3_valid : valid part_1_size_3.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** harmonic functions of degree n; size 4.
    Code: src/scalar/dual.rs, src/scalar/ring.rs, src/space/moebius.rs, src/space/point.rs,
    src/space/similarity.rs *)
Definition part_1_size_4 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Unknown 2;
  Zero 0; (* f is harmonic *)
  Constant 1;
  ShowNonzero 0; (* as src/space/sphere.rs finds *)
  Constant 0; Mul 0 0; Add 0 0; Sub 0 3; Div 4 11; Mul 1 0; Neg 5; Div 14 7; Sub 7 7; Neg 3;
  Neg 10; Mul 2 1; Mul 3 5; Add 1 0; Add 0 1; Mul 6 4; Add 1 0; Mul 0 9; Mul 0 18; Sub 10 0;
  Add 0 19; Mul 3 14; Sub 13 0; Add 0 22; Sub 24 23; Mul 0 15; Add 0 13; Add 0 14; Add 0 12;
  Mul 0 21; Mul 0 30; Sub 6 0; Add 0 31; Mul 3 26; Sub 25 0; Add 0 34; Sub 3 15; Sub 1 13;
  Mul 13 31; Add 27 0; Add 0 27; Add 0 25; Mul 0 34; Mul 0 43; Sub 35 0; Add 0 44; Mul 3 39;
  Sub 22 0; Add 0 47; Sub 3 28; Sub 1 26; Add 37 12; Add 0 36; Mul 0 45; Mul 0 54; Sub 46 0;
  Add 0 55; Mul 3 50; Sub 49 0; Add 0 58; Sub 3 39; Sub 1 37; Mul 37 51; Add 48 0; Mul 0 56;
  Mul 0 65; Sub 57 0; Add 0 66; Mul 3 61; Sub 60 0; Add 0 69; Sub 3 50; Sub 1 48; Sub 75 72;
  Mul 0 69; Neg 81; Neg 81; Mul 40 77; Mul 28 2; Add 1 0; Mul 19 3; Add 1 0; Mul 10 7; Add 1 0;
  Mul 46 84; Mul 34 9; Add 1 0; Mul 25 10; Add 1 0; Mul 16 14; Add 1 0; Div 91 7; Neg 1; Mul 0 1;
  Div 94 96; Mul 101 0; Sub 2 0;
  ShowZero 0; (* the inverse of a point *)
  Sub 88 50; Add 0 97; Sub 0 75; Sub 75 42; Add 0 100; Sub 0 78; Mul 3 27; Add 19 0; Mul 2 28;
  Add 1 0; Add 0 17; Neg 0; Mul 0 17; Mul 115 15; Sub 1 0;
  ShowZero 0; (* the inverse of a point *)
  Unknown 3; Mul 95 107; Sub 105 0; Add 0 114; Mul 86 110; Sub 108 0; Add 0 117; Sub 0 3;
  Mul 77 114; Sub 112 0; Add 0 121; Sub 0 7; Mul 70 118; Sub 116 0; Add 0 125; Sub 0 11;
  Mul 63 122; Sub 104 0; Add 0 129; Sub 0 15; Mul 12 132; Mul 9 57; Add 1 0; Mul 7 58; Add 1 0;
  Mul 5 62; Add 1 0; Mul 139 26; Neg 24; Neg 120; Mul 58 1; Mul 52 119; Add 1 0; Mul 37 121;
  Add 1 0; Mul 8 5; Add 1 0; Sub 9 0; Mul 0 58; Mul 38 56; Sub 1 0;
  ShowZero 0; (* the inverse of a point *)
  Unknown 4; Mul 153 160; Mul 154 155; Add 1 0; Add 1 155; Add 1 0; Mul 159 158; Add 158 0;
  Add 3 0; Add 6 2; Add 6 0; Add 5 2; Mul 165 165; Add 11 0; Mul 173 166; Add 8 0; Add 8 0;
  Add 7 1; Add 9 1; Add 6 4; Add 6 0; Add 10 3; Add 10 3; Mul 176 182; Mul 183 177; Add 1 0;
  Mul 178 184; Add 0 178; Add 0 178; Add 179 179; Add 1 0; Mul 189 183; Add 183 0; Add 183 0;
  Add 4 0; Add 7 2; Add 7 2; Add 6 2; Add 11 6; Add 13 0; Add 19 4; Add 19 4; Add 19 4;
  Mul 101 101; Neg 0; Mul 0 5; Add 104 104; Mul 0 1; Neg 0; Mul 0 9; Mul 5 9; Add 1 0; Add 6 6;
  Mul 0 7; Mul 7 2; Add 1 0; Neg 0; Mul 0 17; Mul 9 17; Add 1 0; Mul 15 18; Add 2 0; Add 2 0;
  Add 11 11; Mul 0 18; Mul 12 13; Add 1 0; Mul 20 4; Add 2 0; Add 2 0; Neg 0; Mul 0 31; Mul 15 31;
  Add 1 0; Mul 25 32; Add 2 0; Add 2 0; Mul 32 34; Add 3 0; Add 3 0; Add 3 0; Mul 233 139;
  Mul 234 36; Add 1 0; Mul 236 32; Add 2 0; Add 2 0; Mul 240 24; Add 3 0; Add 3 0; Mul 243 38;
  Add 8 0; Add 8 0; Add 6 3; Mul 247 48; Add 13 0; Mul 255 15; Add 9 0; Add 9 0; Mul 258 36;
  Add 9 0; Add 9 0; Add 12 3; Mul 262 51; Add 9 0; Add 9 0; Add 13 4; Add 13 4; Mul 261 166;
  Mul 268 63; Add 1 0; Mul 263 48; Add 27 0; Add 27 0; Add 27 0; Mul 273 34; Add 4 0; Add 4 0;
  Mul 276 55; Add 34 0; Add 34 0; Add 7 3; Mul 280 70; Add 40 0; Add 40 0; Add 38 4; Add 11 4;
  Mul 285 81; Add 46 0; Mul 21 186; Mul 23 19; Add 1 0; Mul 26 26; Add 2 0; Add 2 0; Mul 28 192;
  Mul 30 25; Add 1 0; Mul 27 31; Add 6 0; Add 6 0; Mul 30 35; Add 5 0; Add 5 0; Add 9 3;
  Mul 39 202; Mul 35 35; Add 1 0; Mul 205 40; Add 10 0; Add 10 0; Mul 208 44; Add 10 0; Add 10 0;
  Add 13 3; Mul 212 49; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 49 217; Mul 218 50; Add 1 0;
  Mul 220 220; Mul 37 206; Mul 39 36; Add 1 0; Mul 42 42; Add 2 0; Add 2 0; Mul 44 212; Mul 46 42;
  Add 1 0; Mul 44 47; Add 6 0; Add 6 0; Mul 47 51; Add 5 0; Add 5 0; Add 9 3; Mul 55 222;
  Mul 52 52; Add 1 0; Mul 225 56; Add 10 0; Add 10 0; Mul 228 60; Add 10 0; Add 10 0; Add 13 3;
  Mul 232 65; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 66 237; Mul 238 67; Add 1 0; Mul 240 240;
  Sub 35 0; Sub 37 2; Sub 43 8; Sub 43 8; Sub 43 8; Mul 96 246; Mul 98 76; Add 1 0; Mul 101 82;
  Add 2 0; Add 2 0; Mul 103 252; Mul 105 82; Add 1 0; Mul 102 87; Add 6 0; Add 6 0; Mul 105 91;
  Add 5 0; Add 5 0; Add 9 3; Mul 114 262; Mul 110 92; Add 1 0; Mul 280 96; Add 10 0; Add 10 0;
  Mul 283 100; Add 10 0; Add 10 0; Add 13 3; Mul 287 105; Add 9 0; Add 9 0; Add 14 4; Add 14 4;
  Mul 124 277; Mul 293 107; Add 1 0; Mul 295 280; Mul 112 296; Mul 114 129; Add 1 0; Mul 117 136;
  Add 2 0; Add 2 0; Mul 119 302; Mul 121 135; Add 1 0; Mul 119 141; Add 6 0; Add 6 0; Mul 122 145;
  Add 5 0; Add 5 0; Add 9 3; Mul 130 312; Mul 127 145; Add 1 0; Mul 300 150; Add 10 0; Add 10 0;
  Mul 303 154; Add 10 0; Add 10 0; Add 13 3; Mul 307 159; Add 9 0; Add 9 0; Add 14 4; Add 14 4;
  Mul 141 327; Mul 313 160; Add 1 0; Mul 315 330; Add 35 0; Add 37 2; Add 43 8; Add 43 8;
  Add 43 8; Mul 171 79; Mul 173 79; Add 1 0; Mul 176 80; Add 2 0; Add 2 0; Mul 178 85; Mul 180 85;
  Add 1 0; Mul 177 85; Add 6 0; Add 6 0; Mul 180 89; Add 5 0; Add 5 0; Add 9 3; Mul 189 95;
  Mul 185 95; Add 1 0; Mul 355 94; Add 10 0; Add 10 0; Mul 358 98; Add 10 0; Add 10 0; Add 13 3;
  Mul 362 103; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 199 110; Mul 368 110; Add 1 0;
  Mul 370 113; Mul 187 39; Mul 189 39; Add 1 0; Mul 192 40; Add 2 0; Add 2 0; Mul 194 45;
  Mul 196 45; Add 1 0; Mul 194 45; Add 6 0; Add 6 0; Mul 197 49; Add 5 0; Add 5 0; Add 9 3;
  Mul 205 55; Mul 202 55; Add 1 0; Mul 375 54; Add 10 0; Add 10 0; Mul 378 58; Add 10 0; Add 10 0;
  Add 13 3; Mul 382 63; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 216 70; Mul 388 70; Add 1 0;
  Mul 390 73; Sub 35 0; Sub 37 2; Sub 43 8; Sub 43 8; Sub 43 8; Mul 246 79; Mul 248 79; Add 1 0;
  Mul 251 80; Add 2 0; Add 2 0; Mul 253 85; Mul 255 85; Add 1 0; Mul 252 85; Add 6 0; Add 6 0;
  Mul 255 89; Add 5 0; Add 5 0; Add 9 3; Mul 264 95; Mul 260 95; Add 1 0; Mul 430 94; Add 10 0;
  Add 10 0; Mul 433 98; Add 10 0; Add 10 0; Add 13 3; Mul 437 103; Add 9 0; Add 9 0; Add 14 4;
  Add 14 4; Mul 274 110; Mul 443 110; Add 1 0; Mul 445 113; Mul 262 189; Mul 264 189; Add 1 0;
  Mul 267 190; Add 2 0; Add 2 0; Mul 269 195; Mul 271 195; Add 1 0; Mul 269 195; Add 6 0; Add 6 0;
  Mul 272 199; Add 5 0; Add 5 0; Add 9 3; Mul 280 205; Mul 277 205; Add 1 0; Mul 450 204;
  Add 10 0; Add 10 0; Mul 453 208; Add 10 0; Add 10 0; Add 13 3; Mul 457 213; Add 9 0; Add 9 0;
  Add 14 4; Add 14 4; Mul 291 220; Mul 463 220; Add 1 0; Mul 465 223; Add 35 0; Add 37 2;
  Add 43 8; Add 43 8; Add 43 8; Mul 321 79; Mul 323 79; Add 1 0; Mul 326 80; Add 2 0; Add 2 0;
  Mul 328 85; Mul 330 85; Add 1 0; Mul 327 85; Add 6 0; Add 6 0; Mul 330 89; Add 5 0; Add 5 0;
  Add 9 3; Mul 339 95; Mul 335 95; Add 1 0; Mul 505 94; Add 10 0; Add 10 0; Mul 508 98; Add 10 0;
  Add 10 0; Add 13 3; Mul 512 103; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 349 110; Mul 518 110;
  Add 1 0; Mul 520 113; Mul 337 39; Mul 339 39; Add 1 0; Mul 342 40; Add 2 0; Add 2 0; Mul 344 45;
  Mul 346 45; Add 1 0; Mul 344 45; Add 6 0; Add 6 0; Mul 347 49; Add 5 0; Add 5 0; Add 9 3;
  Mul 355 55; Mul 352 55; Add 1 0; Mul 525 54; Add 10 0; Add 10 0; Mul 528 58; Add 10 0; Add 10 0;
  Add 13 3; Mul 532 63; Add 9 0; Add 9 0; Add 14 4; Add 14 4; Mul 366 70; Mul 538 70; Add 1 0;
  Mul 540 73; Sub 35 0; Sub 37 2; Sub 43 8; Sub 43 8; Sub 43 8; Mul 396 79; Mul 398 79; Add 1 0;
  Mul 401 80; Add 2 0; Add 2 0; Mul 403 85; Mul 405 85; Add 1 0; Mul 402 85; Add 6 0; Add 6 0;
  Mul 405 89; Add 5 0; Add 5 0; Add 9 3; Mul 414 95; Mul 410 95; Add 1 0; Mul 580 94; Add 10 0;
  Add 10 0; Mul 583 98; Add 10 0; Add 10 0; Add 13 3; Mul 587 103; Add 9 0; Add 9 0; Add 14 4;
  Add 14 4; Mul 424 110; Mul 593 110; Add 1 0; Mul 595 113; Mul 412 189; Mul 414 189; Add 1 0;
  Mul 417 190; Add 2 0; Add 2 0; Mul 419 195; Mul 421 195; Add 1 0; Mul 419 195; Add 6 0; Add 6 0;
  Mul 422 199; Add 5 0; Add 5 0; Add 9 3; Mul 430 205; Mul 427 205; Add 1 0; Mul 600 204;
  Add 10 0; Add 10 0; Mul 603 208; Add 10 0; Add 10 0; Add 13 3; Mul 607 213; Add 9 0; Add 9 0;
  Add 14 4; Add 14 4; Mul 441 220; Mul 613 220; Add 1 0; Mul 615 223; Add 35 0; Add 37 2;
  Add 43 8; Add 43 8; Add 43 8; Mul 75 619; Mul 77 732; Add 1 0; Mul 80 734; Add 2 0; Add 2 0;
  Mul 82 625; Add 0 3; Mul 86 739; Add 5 0; Add 5 0; Add 3 1; Add 6 1; Mul 90 632; Add 0 5;
  Mul 94 746; Add 7 0; Add 7 0; Add 7 0; Add 4 2; Add 8 2; Add 8 2; Mul 100 641; Add 0 7;
  Mul 103 643; Mul 25 603; Mul 27 757; Add 1 0; Mul 30 759; Add 2 0; Add 2 0; Mul 32 609; Add 0 3;
  Mul 36 764; Add 5 0; Add 5 0; Add 3 1; Add 6 1; Mul 40 616; Add 0 5; Mul 44 771; Add 7 0;
  Add 7 0; Add 7 0; Add 4 2; Add 8 2; Add 8 2; Mul 50 625; Add 0 7; Mul 53 627; Add 25 0;
  Add 27 2; Add 32 7; Add 32 7; Add 32 7; Mul 474 470; Mul 476 472; Add 1 0; Mul 479 479; Add 2 0;
  Add 2 0; Mul 481 476; Mul 483 478; Add 1 0; Mul 480 484; Add 6 0; Add 6 0; Mul 483 488; Add 5 0;
  Add 5 0; Add 9 3; Mul 492 486; Mul 488 488; Add 1 0; Mul 489 493; Add 10 0; Add 10 0;
  Mul 492 497; Add 10 0; Add 10 0; Add 13 3; Mul 496 502; Add 9 0; Add 9 0; Add 14 4; Add 14 4;
  Mul 502 501; Mul 502 503; Add 1 0; Mul 504 504; Mul 4 823; Mul 6 822; Add 1 0; Mul 9 824;
  Add 2 0; Add 2 0; Mul 11 829; Add 0 3; Mul 9 829; Add 5 0; Add 5 0; Add 3 1; Add 6 1;
  Mul 19 836; Add 0 5; Mul 15 836; Add 7 0; Add 7 0; Add 7 0; Add 4 2; Add 8 2; Add 8 2;
  Mul 23 845; Add 0 7; Mul 24 847; Add 64 0; Add 64 2; Add 64 7; Add 64 7; Add 64 7; Mul 0 854;
  Mul 2 660; Add 1 0; Mul 5 661; Add 2 0; Add 2 0; Mul 9 663; Add 3 0; Add 3 0; Add 3 0;
  Mul 14 666; Add 4 0; Add 4 0; Add 4 0; Add 4 0; Add 712 865; Add 0 710; Add 711 866; Add 1 0;
  Add 868 710; Add 870 704; Add 712 0; Add 2 0; Add 7 2; Add 7 2; Add 6 2; Add 10 715;
  Add 724 719; Add 717 7; Add 725 713; Add 2 0; Add 4 2; Add 729 716; Add 705 729; Add 0 883;
  Add 1 726; Add 1 16; Add 709 723; Add 730 705; Add 888 0; Add 734 1; Add 23 1; Add 728 709;
  Add 5 0; Add 8 3; Add 8 3; Add 12 7; Add 12 7; Mul 900 905; Mul 906 901; Add 1 0; Add 18 0;
  Add 21 5; Add 21 5; Add 30 10; Add 30 10; Add 30 10; Mul 699 5; Mul 708 5; Add 1 0; Mul 714 6;
  Add 2 0; Add 2 0; Mul 713 11; Mul 718 11; Add 1 0; Mul 720 14; Mul 702 0; Mul 714 2; Add 1 0;
  Mul 722 7; Add 2 0; Add 2 0; Mul 719 6; Mul 726 8; Add 1 0; Mul 728 9; Neg 0; Neg 2; Neg 6;
  Mul 0 28; Mul 723 26; Add 1 0; Mul 4 30; Mul 734 28; Add 1 0; Add 3 0; Mul 8 35; Mul 738 33;
  Add 1 0; Mul 12 36; Mul 745 34; Add 1 0; Add 7 0; Mul 16 41; Mul 749 39; Add 1 0; Add 7 0;
  Add 11 4; Mul 21 47; Mul 754 45; Add 1 0; Mul 953 35; Add 720 0; Mul 955 38; Add 721 0; Add 2 0;
  Mul 958 44; Add 722 0; Add 3 0; Add 3 0; Mul 962 9; Add 9 0; Mul 965 15; Add 9 0; Add 2 0;
  Mul 968 14; Add 14 0; Mul 976 19; Add 11 0; Add 5 0; Mul 979 23; Add 17 0; Add 5 0; Add 8 3;
  Mul 983 23; Add 23 0; Add 23 0; Add 21 4; Add 18 4; Mul 982 64; Add 747 0; Add 28 0; Mul 985 66;
  Add 751 0; Mul 993 72; Add 750 0; Add 5 0; Mul 996 72; Add 755 0; Add 5 0; Add 8 3; Mul 1000 75;
  Add 760 0; Mul 996 81; Add 759 0; Add 40 0; Add 40 0; Mul 999 50; Add 44 0; Add 37 0;
  Mul 1008 52; Add 7 0; Add 3 0; Mul 1011 56; Add 24 0; Add 43 0; Add 6 3; Mul 1015 56; Add 25 0;
  Add 25 0; Add 28 4; Add 14 4; Mul 1020 100; Add 772 0; Add 59 0; Mul 1023 100; Add 771 0;
  Add 64 0; Add 62 3; Mul 1027 103; Add 761 0; Mul 42 928; Mul 31 29; Add 1 0; Mul 46 763;
  Mul 35 35; Add 1 0; Add 3 0; Mul 50 935; Mul 39 36; Add 1 0; Mul 54 775; Mul 39 41; Add 1 0;
  Add 7 0; Mul 58 774; Mul 43 46; Add 1 0; Add 7 0; Add 11 4; Mul 63 947; Mul 48 48; Add 1 0;
  Mul 787 66; Add 21 0; Mul 784 67; Add 20 0; Add 2 0; Mul 787 71; Add 19 0; Mul 957 71; Add 18 0;
  Add 5 0; Mul 960 75; Add 17 0; Add 5 0; Add 8 3; Mul 964 80; Add 16 0; Add 16 0; Add 21 4;
  Add 21 4; Mul 71 969; Mul 807 70; Add 1 0; Mul 75 804; Mul 805 76; Add 1 0; Add 3 0; Mul 79 976;
  Mul 809 77; Add 1 0; Mul 79 816; Mul 980 82; Add 1 0; Add 7 0; Mul 83 815; Mul 984 87; Add 1 0;
  Add 7 0; Add 11 4; Mul 88 988; Mul 989 89; Add 1 0; Mul 72 976; Mul 66 64; Add 1 0; Mul 76 808;
  Mul 70 70; Add 1 0; Add 3 0; Mul 80 983; Mul 74 71; Add 1 0; Mul 84 819; Mul 74 76; Add 1 0;
  Add 7 0; Mul 88 819; Mul 78 81; Add 1 0; Add 7 0; Add 11 4; Mul 93 995; Mul 83 83; Add 1 0;
  Mul 831 96; Add 21 0; Mul 829 97; Add 20 0; Add 2 0; Mul 832 101; Add 19 0; Mul 1005 101;
  Add 18 0; Add 5 0; Mul 1008 105; Add 17 0; Add 5 0; Add 8 3; Mul 1012 110; Add 16 0; Add 16 0;
  Add 21 4; Add 21 4; Mul 106 1017; Mul 851 105; Add 1 0; Mul 110 849; Mul 850 111; Add 1 0;
  Add 3 0; Mul 114 1024; Mul 854 112; Add 1 0; Mul 114 860; Mul 1028 117; Add 1 0; Add 7 0;
  Mul 118 860; Mul 1032 122; Add 1 0; Add 7 0; Add 11 4; Mul 123 1036; Mul 1037 124; Add 1 0;
  Sub 63 0; Sub 68 5; Sub 68 5; Sub 90 27; Sub 90 27; Sub 90 27; Mul 174 1045; Mul 163 133;
  Add 1 0; Mul 178 877; Mul 167 139; Add 1 0; Add 3 0; Mul 182 1052; Mul 171 140; Add 1 0;
  Mul 186 888; Mul 171 145; Add 1 0; Add 7 0; Mul 190 888; Mul 175 150; Add 1 0; Add 7 0;
  Add 11 4; Mul 195 1064; Mul 180 152; Add 1 0; Mul 919 165; Add 21 0; Mul 916 166; Add 20 0;
  Add 2 0; Mul 919 170; Add 19 0; Mul 1089 170; Add 18 0; Add 5 0; Mul 1092 174; Add 17 0;
  Add 5 0; Add 8 3; Mul 1096 179; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 203 1086;
  Mul 939 174; Add 1 0; Mul 207 918; Mul 937 180; Add 1 0; Add 3 0; Mul 211 1093; Mul 941 181;
  Add 1 0; Mul 211 929; Mul 1112 186; Add 1 0; Add 7 0; Mul 215 929; Mul 1116 191; Add 1 0;
  Add 7 0; Add 11 4; Mul 220 1105; Mul 1121 193; Add 1 0; Mul 204 1123; Mul 198 224; Add 1 0;
  Mul 208 958; Mul 202 230; Add 1 0; Add 3 0; Mul 212 1130; Mul 206 231; Add 1 0; Mul 216 970;
  Mul 206 236; Add 1 0; Add 7 0; Mul 220 969; Mul 210 241; Add 1 0; Add 7 0; Add 11 4;
  Mul 225 1142; Mul 215 243; Add 1 0; Mul 963 261; Add 21 0; Mul 961 262; Add 20 0; Add 2 0;
  Mul 964 266; Add 19 0; Mul 1137 266; Add 18 0; Add 5 0; Mul 1140 270; Add 17 0; Add 5 0;
  Add 8 3; Mul 1144 275; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 238 1164; Mul 983 265;
  Add 1 0; Mul 242 999; Mul 982 271; Add 1 0; Add 3 0; Mul 246 1171; Mul 986 272; Add 1 0;
  Mul 246 1011; Mul 1160 277; Add 1 0; Add 7 0; Mul 250 1010; Mul 1164 282; Add 1 0; Add 7 0;
  Add 11 4; Mul 255 1183; Mul 1169 284; Add 1 0; Add 63 0; Add 68 5; Add 68 5; Add 90 27;
  Add 90 27; Add 90 27; Mul 306 935; Mul 295 138; Add 1 0; Mul 310 937; Mul 299 140; Add 1 0;
  Add 3 0; Mul 314 942; Mul 303 145; Add 1 0; Mul 318 943; Mul 303 146; Add 1 0; Add 7 0;
  Mul 322 948; Mul 307 151; Add 1 0; Add 7 0; Add 11 4; Mul 327 954; Mul 312 157; Add 1 0;
  Mul 1051 156; Add 21 0; Mul 1048 157; Add 20 0; Add 2 0; Mul 1051 161; Add 19 0; Mul 1221 161;
  Add 18 0; Add 5 0; Mul 1224 165; Add 17 0; Add 5 0; Add 8 3; Mul 1228 170; Add 16 0; Add 16 0;
  Add 21 4; Add 21 4; Mul 335 976; Mul 1071 179; Add 1 0; Mul 339 978; Mul 1069 181; Add 1 0;
  Add 3 0; Mul 343 983; Mul 1073 186; Add 1 0; Mul 343 984; Mul 1244 187; Add 1 0; Add 7 0;
  Mul 347 989; Mul 1248 192; Add 1 0; Add 7 0; Add 11 4; Mul 352 995; Mul 1253 198; Add 1 0;
  Mul 336 923; Mul 330 69; Add 1 0; Mul 340 925; Mul 334 71; Add 1 0; Add 3 0; Mul 344 930;
  Mul 338 76; Add 1 0; Mul 348 931; Mul 338 77; Add 1 0; Add 7 0; Mul 352 936; Mul 342 82;
  Add 1 0; Add 7 0; Add 11 4; Mul 357 942; Mul 347 88; Add 1 0; Mul 1095 87; Add 21 0;
  Mul 1093 88; Add 20 0; Add 2 0; Mul 1096 92; Add 19 0; Mul 1269 92; Add 18 0; Add 5 0;
  Mul 1272 96; Add 17 0; Add 5 0; Add 8 3; Mul 1276 101; Add 16 0; Add 16 0; Add 21 4; Add 21 4;
  Mul 370 964; Mul 1115 110; Add 1 0; Mul 374 966; Mul 1114 112; Add 1 0; Add 3 0; Mul 378 971;
  Mul 1118 117; Add 1 0; Mul 378 972; Mul 1292 118; Add 1 0; Add 7 0; Mul 382 977; Mul 1296 123;
  Add 1 0; Add 7 0; Add 11 4; Mul 387 983; Mul 1301 129; Add 1 0; Sub 63 0; Sub 68 5; Sub 68 5;
  Sub 90 27; Sub 90 27; Sub 90 27; Mul 438 992; Mul 427 138; Add 1 0; Mul 442 994; Mul 431 140;
  Add 1 0; Add 3 0; Mul 446 999; Mul 435 145; Add 1 0; Mul 450 1000; Mul 435 146; Add 1 0;
  Add 7 0; Mul 454 1005; Mul 439 151; Add 1 0; Add 7 0; Add 11 4; Mul 459 1011; Mul 444 157;
  Add 1 0; Mul 1183 156; Add 21 0; Mul 1180 157; Add 20 0; Add 2 0; Mul 1183 161; Add 19 0;
  Mul 1353 161; Add 18 0; Add 5 0; Mul 1356 165; Add 17 0; Add 5 0; Add 8 3; Mul 1360 170;
  Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 467 1033; Mul 1203 179; Add 1 0; Mul 471 1035;
  Mul 1201 181; Add 1 0; Add 3 0; Mul 475 1040; Mul 1205 186; Add 1 0; Mul 475 1041; Mul 1376 187;
  Add 1 0; Add 7 0; Mul 479 1046; Mul 1380 192; Add 1 0; Add 7 0; Add 11 4; Mul 484 1052;
  Mul 1385 198; Add 1 0; Mul 468 1130; Mul 462 333; Add 1 0; Mul 472 1132; Mul 466 335; Add 1 0;
  Add 3 0; Mul 476 1137; Mul 470 340; Add 1 0; Mul 480 1138; Mul 470 341; Add 1 0; Add 7 0;
  Mul 484 1143; Mul 474 346; Add 1 0; Add 7 0; Add 11 4; Mul 489 1149; Mul 479 352; Add 1 0;
  Mul 1227 351; Add 21 0; Mul 1225 352; Add 20 0; Add 2 0; Mul 1228 356; Add 19 0; Mul 1401 356;
  Add 18 0; Add 5 0; Mul 1404 360; Add 17 0; Add 5 0; Add 8 3; Mul 1408 365; Add 16 0; Add 16 0;
  Add 21 4; Add 21 4; Mul 502 1171; Mul 1247 374; Add 1 0; Mul 506 1173; Mul 1246 376; Add 1 0;
  Add 3 0; Mul 510 1178; Mul 1250 381; Add 1 0; Mul 510 1179; Mul 1424 382; Add 1 0; Add 7 0;
  Mul 514 1184; Mul 1428 387; Add 1 0; Add 7 0; Add 11 4; Mul 519 1190; Mul 1433 393; Add 1 0;
  Add 63 0; Add 68 5; Add 68 5; Add 90 27; Add 90 27; Add 90 27; Mul 570 1049; Mul 559 138;
  Add 1 0; Mul 574 1051; Mul 563 140; Add 1 0; Add 3 0; Mul 578 1056; Mul 567 145; Add 1 0;
  Mul 582 1057; Mul 567 146; Add 1 0; Add 7 0; Mul 586 1062; Mul 571 151; Add 1 0; Add 7 0;
  Add 11 4; Mul 591 1068; Mul 576 157; Add 1 0; Mul 1315 156; Add 21 0; Mul 1312 157; Add 20 0;
  Add 2 0; Mul 1315 161; Add 19 0; Mul 1485 161; Add 18 0; Add 5 0; Mul 1488 165; Add 17 0;
  Add 5 0; Add 8 3; Mul 1492 170; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 599 1090;
  Mul 1335 179; Add 1 0; Mul 603 1092; Mul 1333 181; Add 1 0; Add 3 0; Mul 607 1097; Mul 1337 186;
  Add 1 0; Mul 607 1098; Mul 1508 187; Add 1 0; Add 7 0; Mul 611 1103; Mul 1512 192; Add 1 0;
  Add 7 0; Add 11 4; Mul 616 1109; Mul 1517 198; Add 1 0; Mul 600 1037; Mul 594 69; Add 1 0;
  Mul 604 1039; Mul 598 71; Add 1 0; Add 3 0; Mul 608 1044; Mul 602 76; Add 1 0; Mul 612 1045;
  Mul 602 77; Add 1 0; Add 7 0; Mul 616 1050; Mul 606 82; Add 1 0; Add 7 0; Add 11 4;
  Mul 621 1056; Mul 611 88; Add 1 0; Mul 1359 87; Add 21 0; Mul 1357 88; Add 20 0; Add 2 0;
  Mul 1360 92; Add 19 0; Mul 1533 92; Add 18 0; Add 5 0; Mul 1536 96; Add 17 0; Add 5 0; Add 8 3;
  Mul 1540 101; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 634 1078; Mul 1379 110; Add 1 0;
  Mul 638 1080; Mul 1378 112; Add 1 0; Add 3 0; Mul 642 1085; Mul 1382 117; Add 1 0; Mul 642 1086;
  Mul 1556 118; Add 1 0; Add 7 0; Mul 646 1091; Mul 1560 123; Add 1 0; Add 7 0; Add 11 4;
  Mul 651 1097; Mul 1565 129; Add 1 0; Sub 63 0; Sub 68 5; Sub 68 5; Sub 90 27; Sub 90 27;
  Sub 90 27; Mul 702 1106; Mul 691 138; Add 1 0; Mul 706 1108; Mul 695 140; Add 1 0; Add 3 0;
  Mul 710 1113; Mul 699 145; Add 1 0; Mul 714 1114; Mul 699 146; Add 1 0; Add 7 0; Mul 718 1119;
  Mul 703 151; Add 1 0; Add 7 0; Add 11 4; Mul 723 1125; Mul 708 157; Add 1 0; Mul 1447 156;
  Add 21 0; Mul 1444 157; Add 20 0; Add 2 0; Mul 1447 161; Add 19 0; Mul 1617 161; Add 18 0;
  Add 5 0; Mul 1620 165; Add 17 0; Add 5 0; Add 8 3; Mul 1624 170; Add 16 0; Add 16 0; Add 21 4;
  Add 21 4; Mul 731 1147; Mul 1467 179; Add 1 0; Mul 735 1149; Mul 1465 181; Add 1 0; Add 3 0;
  Mul 739 1154; Mul 1469 186; Add 1 0; Mul 739 1155; Mul 1640 187; Add 1 0; Add 7 0; Mul 743 1160;
  Mul 1644 192; Add 1 0; Add 7 0; Add 11 4; Mul 748 1166; Mul 1649 198; Add 1 0; Mul 732 1244;
  Mul 726 333; Add 1 0; Mul 736 1246; Mul 730 335; Add 1 0; Add 3 0; Mul 740 1251; Mul 734 340;
  Add 1 0; Mul 744 1252; Mul 734 341; Add 1 0; Add 7 0; Mul 748 1257; Mul 738 346; Add 1 0;
  Add 7 0; Add 11 4; Mul 753 1263; Mul 743 352; Add 1 0; Mul 1491 351; Add 21 0; Mul 1489 352;
  Add 20 0; Add 2 0; Mul 1492 356; Add 19 0; Mul 1665 356; Add 18 0; Add 5 0; Mul 1668 360;
  Add 17 0; Add 5 0; Add 8 3; Mul 1672 365; Add 16 0; Add 16 0; Add 21 4; Add 21 4; Mul 766 1285;
  Mul 1511 374; Add 1 0; Mul 770 1287; Mul 1510 376; Add 1 0; Add 3 0; Mul 774 1292; Mul 1514 381;
  Add 1 0; Mul 774 1293; Mul 1688 382; Add 1 0; Add 7 0; Mul 778 1298; Mul 1692 387; Add 1 0;
  Add 7 0; Add 11 4; Mul 783 1304; Mul 1697 393; Add 1 0; Add 63 0; Add 68 5; Add 68 5; Add 90 27;
  Add 90 27; Add 90 27; Mul 132 1703; Mul 136 1816; Add 1 0; Mul 136 1818; Mul 140 1819; Add 1 0;
  Add 3 0; Mul 140 1710; Add 0 3; Mul 143 1824; Mul 147 1825; Add 1 0; Add 6 0; Add 4 1; Add 7 1;
  Mul 149 1718; Add 0 5; Add 15 1097; Add 13 1093; Add 1 0; Add 9 1088; Add 2 0; Add 2 0; Add 6 2;
  Add 10 2; Add 10 2; Mul 161 1729; Add 0 1107; Add 0 9; Mul 165 1732; Add 0 1105; Add 0 10;
  Add 3 10; Mul 170 1736; Add 0 1102; Mul 35 1697; Mul 39 1851; Add 1 0; Mul 39 1853; Mul 43 1854;
  Add 1 0; Add 3 0; Mul 43 1704; Add 0 3; Mul 46 1859; Mul 50 1860; Add 1 0; Add 6 0; Add 4 1;
  Add 7 1; Mul 52 1712; Add 0 5; Add 15 1107; Add 13 1103; Add 1 0; Add 9 1098; Add 2 0; Add 2 0;
  Add 6 2; Add 10 2; Add 10 2; Mul 64 1723; Add 0 1117; Add 0 9; Mul 68 1726; Add 0 1115;
  Add 0 10; Add 3 10; Mul 73 1730; Add 0 1112; Add 35 0; Add 39 4; Add 39 4; Add 49 14; Add 49 14;
  Add 49 14; Mul 827 1575; Mul 809 806; Add 1 0; Mul 831 1579; Mul 813 813; Add 1 0; Add 3 0;
  Mul 835 1582; Mul 817 813; Add 1 0; Mul 839 1591; Mul 816 819; Add 1 0; Add 7 0; Mul 843 1590;
  Mul 820 824; Add 1 0; Add 7 0; Add 11 4; Mul 848 1594; Mul 825 825; Add 1 0; Mul 1603 851;
  Add 21 0; Mul 1600 852; Add 20 0; Add 2 0; Mul 1603 856; Add 19 0; Mul 1604 856; Add 18 0;
  Add 5 0; Mul 1607 860; Add 17 0; Add 5 0; Add 8 3; Mul 1611 865; Add 16 0; Add 16 0; Add 21 4;
  Add 21 4; Mul 849 1616; Mul 1623 847; Add 1 0; Mul 853 1620; Mul 1621 854; Add 1 0; Add 3 0;
  Mul 857 1623; Mul 1625 854; Add 1 0; Mul 856 1632; Mul 1627 860; Add 1 0; Add 7 0; Mul 860 1631;
  Mul 1631 865; Add 1 0; Add 7 0; Add 11 4; Mul 865 1635; Mul 1636 866; Add 1 0; Mul 22 1956;
  Mul 4 1955; Add 1 0; Mul 26 1957; Mul 8 1958; Add 1 0; Add 3 0; Mul 30 1963; Add 0 3;
  Mul 33 1963; Mul 10 1964; Add 1 0; Add 6 0; Add 4 1; Add 7 1; Mul 39 1971; Add 0 5; Add 15 1146;
  Add 13 1142; Add 1 0; Add 9 1137; Add 2 0; Add 2 0; Add 6 2; Add 10 2; Add 10 2; Mul 29 1982;
  Add 0 1156; Add 0 9; Mul 33 1985; Add 0 1154; Add 0 10; Add 3 10; Mul 33 1989; Add 0 1151;
  Add 103 0; Add 103 4; Add 103 4; Add 103 14; Add 103 14; Add 103 14; Mul 0 1998; Mul 4 1093;
  Add 1 0; Mul 4 1806; Mul 8 1095; Add 1 0; Add 3 0; Mul 9 1809; Mul 13 1098; Add 1 0; Add 4 0;
  Add 4 0; Mul 1158 1101; Add 11 0; Mul 1161 1102; Add 10 0; Add 2 0; Mul 1165 1104; Add 9 0;
  Add 3 0; Add 3 0; Add 9 0; Add 1150 2015; Add 0 1836; Add 2017 1147; Add 1838 0; Add 3 1;
  Add 3 1; Add 1138 1866; Add 1139 1862; Add 1 1864; Add 1866 1136; Add 1865 1137; Add 1867 1;
  Add 4 1; Add 4 1; Add 9 1; Add 9 1; Add 1115 1115; Mul 0 1116; Mul 1836 1082; Add 1 0; Neg 0;
  Mul 0 1135; Mul 1110 1133; Add 1 0; Mul 1844 9; Add 2 0; Add 2 0; Add 1091 1091; Mul 0 1127;
  Mul 12 1093; Add 1 0; Mul 1849 4; Add 2 0; Add 2 0; Neg 0; Mul 0 1149; Mul 15 1147; Add 1 0;
  Mul 1126 23; Add 2 0; Add 2 0; Mul 1861 25; Add 3 0; Add 3 0; Add 3 0; Add 1107 1098;
  Mul 2063 19; Add 1101 0; Add 1101 0; Add 3 0; Mul 2074 5; Add 4 0; Add 4 0; Mul 2077 26;
  Add 1108 0; Add 1108 0; Add 7 3; Add 11 1; Add 8 1; Mul 2077 32; Add 1114 0; Add 1114 0;
  Add 1124 1110; Add 17 1; Mul 2087 19; Add 5 0; Add 5 0; Mul 2090 40; Add 1117 0; Add 1117 0;
  Add 8 3; Add 8 1; Add 8 1; Mul 14 1995; Mul 16 1096; Add 1 0; Mul 1114 1114; Add 2 0; Add 2 0;
  Mul 21 2001; Mul 1118 1102; Add 1 0; Mul 1104 24; Add 6 0; Add 6 0; Mul 1107 1123; Add 5 0;
  Add 5 0; Add 9 3; Mul 2011 30; Add 7 0; Add 7 0; Mul 2014 34; Add 7 0; Add 7 0; Add 10 3;
  Add 8 1; Add 8 1; Mul 25 2005; Mul 27 1093; Add 1 0; Mul 1106 1106; Add 2 0; Add 2 0;
  Mul 32 2011; Mul 1110 1099; Add 1 0; Mul 1101 35; Add 6 0; Add 6 0; Mul 1104 1115; Add 5 0;
  Add 5 0; Add 9 3; Mul 2021 41; Add 7 0; Add 7 0; Mul 2024 45; Add 7 0; Add 7 0; Add 10 3;
  Add 8 1; Add 8 1; Sub 26 1; Sub 26 1; Mul 66 2032; Mul 68 1120; Add 1 0; Mul 1166 1133; Add 2 0;
  Add 2 0; Mul 73 2038; Mul 1170 1126; Add 1 0; Mul 1156 62; Add 6 0; Add 6 0; Mul 1159 1142;
  Add 5 0; Add 5 0; Add 9 3; Mul 2063 68; Add 7 0; Add 7 0; Mul 2066 72; Add 7 0; Add 7 0;
  Add 10 3; Add 8 1; Add 8 1; Mul 77 2072; Mul 79 1173; Add 1 0; Mul 1158 1191; Add 2 0; Add 2 0;
  Mul 84 2078; Mul 1162 1179; Add 1 0; Mul 1153 101; Add 6 0; Add 6 0; Mul 1156 1200; Add 5 0;
  Add 5 0; Add 9 3; Mul 2073 107; Add 7 0; Add 7 0; Mul 2076 111; Add 7 0; Add 7 0; Add 10 3;
  Add 8 1; Add 8 1; Add 26 1; Add 26 1; Mul 118 1842; Mul 120 1045; Add 1 0; Mul 1218 1044;
  Add 2 0; Add 2 0; Mul 125 1848; Mul 1222 1051; Add 1 0; Mul 1208 62; Add 6 0; Add 6 0;
  Mul 1211 1053; Add 5 0; Add 5 0; Add 9 3; Mul 2115 68; Add 7 0; Add 7 0; Mul 2118 72; Add 7 0;
  Add 7 0; Add 10 3; Add 8 1; Add 8 1; Mul 129 1792; Mul 131 938; Add 1 0; Mul 1210 937; Add 2 0;
  Add 2 0; Mul 136 1798; Mul 1214 944; Add 1 0; Mul 1205 35; Add 6 0; Add 6 0; Mul 1208 946;
  Add 5 0; Add 5 0; Add 9 3; Mul 2125 41; Add 7 0; Add 7 0; Mul 2128 45; Add 7 0; Add 7 0;
  Add 10 3; Add 8 1; Add 8 1; Sub 26 1; Sub 26 1; Mul 170 1819; Mul 172 965; Add 1 0;
  Mul 1270 964; Add 2 0; Add 2 0; Mul 177 1825; Mul 1274 971; Add 1 0; Mul 1260 62; Add 6 0;
  Add 6 0; Mul 1263 973; Add 5 0; Add 5 0; Add 9 3; Mul 2167 68; Add 7 0; Add 7 0; Mul 2170 72;
  Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1; Mul 181 1919; Mul 183 1122; Add 1 0;
  Mul 1262 1121; Add 2 0; Add 2 0; Mul 188 1925; Mul 1266 1128; Add 1 0; Mul 1257 139; Add 6 0;
  Add 6 0; Mul 1260 1130; Add 5 0; Add 5 0; Add 9 3; Mul 2177 145; Add 7 0; Add 7 0; Mul 2180 149;
  Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1; Add 26 1; Add 26 1; Mul 222 1796; Mul 224 885;
  Add 1 0; Mul 1322 884; Add 2 0; Add 2 0; Mul 229 1802; Mul 1326 891; Add 1 0; Mul 1312 62;
  Add 6 0; Add 6 0; Mul 1315 893; Add 5 0; Add 5 0; Add 9 3; Mul 2219 68; Add 7 0; Add 7 0;
  Mul 2222 72; Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1; Mul 233 1746; Mul 235 778; Add 1 0;
  Mul 1314 777; Add 2 0; Add 2 0; Mul 240 1752; Mul 1318 784; Add 1 0; Mul 1309 35; Add 6 0;
  Add 6 0; Mul 1312 786; Add 5 0; Add 5 0; Add 9 3; Mul 2229 41; Add 7 0; Add 7 0; Mul 2232 45;
  Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1; Sub 26 1; Sub 26 1; Mul 274 1773; Mul 276 805;
  Add 1 0; Mul 1374 804; Add 2 0; Add 2 0; Mul 281 1779; Mul 1378 811; Add 1 0; Mul 1364 62;
  Add 6 0; Add 6 0; Mul 1367 813; Add 5 0; Add 5 0; Add 9 3; Mul 2271 68; Add 7 0; Add 7 0;
  Mul 2274 72; Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1; Mul 285 1873; Mul 287 962; Add 1 0;
  Mul 1366 961; Add 2 0; Add 2 0; Mul 292 1879; Mul 1370 968; Add 1 0; Mul 1361 139; Add 6 0;
  Add 6 0; Mul 1364 970; Add 5 0; Add 5 0; Add 9 3; Mul 2281 145; Add 7 0; Add 7 0; Mul 2284 149;
  Add 7 0; Add 7 0; Add 10 3; Add 8 1; Add 8 1; Add 26 1; Add 26 1; Mul 52 2290; Mul 54 2403;
  Add 1 0; Add 1 580; Add 1 0; Mul 58 2295; Add 0 583; Add 3 582; Add 1 583; Add 4 1; Add 585 576;
  Add 3 0; Add 3 1; Add 3 1; Mul 14 2263; Mul 16 2417; Add 1 0; Add 1 559; Add 1 0; Mul 20 2268;
  Add 0 562; Add 3 561; Add 1 562; Add 4 1; Add 564 555; Add 3 0; Add 3 1; Add 3 1; Add 15 1;
  Add 15 1; Mul 317 2116; Mul 319 1347; Add 1 0; Mul 1373 1373; Add 2 0; Add 2 0; Mul 324 2122;
  Mul 1377 1353; Add 1 0; Mul 1355 327; Add 6 0; Add 6 0; Mul 1358 1382; Add 5 0; Add 5 0;
  Add 9 3; Mul 2132 333; Add 7 0; Add 7 0; Mul 2135 337; Add 7 0; Add 7 0; Add 10 3; Add 8 1;
  Add 8 1; Mul 0 2459; Mul 2 2458; Add 1 0; Add 1 496; Add 1 0; Mul 6 2464; Add 0 499; Add 3 498;
  Add 1 499; Add 4 1; Add 501 492; Add 3 0; Add 3 1; Add 3 1; Add 40 1; Add 40 1; Mul 0 2476;
  Mul 2 1571; Add 1 0; Mul 483 1570; Add 2 0; Add 2 0; Mul 489 447; Add 3 0; Add 3 0; Add 3 0;
  Mul 1636 450; Add 4 0; Add 4 0; Add 4 0; Add 4 0; Mul 471 2496; Add 1623 0; Add 0 2;
  ShowZero 0 (* Δ² *)
].

Theorem part_1_size_4_valid : valid part_1_size_4.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a face at a vertex of any i-isothermic mesh; size 1.
    Code: src/scalar/ring.rs, src/space/circle.rs, src/space/gradient.rs, src/space/moebius.rs,
    src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs, src/space/similarity.rs,
    src/space/sphere.rs *)
Definition part_2_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Constant 0; Mul 1 1; Sub 4 1; Sub 4 2; Mul 1 1; Mul 1 1;
  Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Unknown 3; Unknown 4; Sub 12 1; Sub 12 1; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 13; Sub 7 15;
  Sub 7 16; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Constant 1;
  ShowNonzero 0; (* as src/space/sphere.rs finds *)
  Unknown 5; Unknown 6; Unknown 7; Mul 1 28; Mul 1 28; Add 1 0; Sub 5 0; Mul 29 29; Add 0 0;
  Sub 0 9; Div 10 36; Mul 1 0; Neg 34; Div 39 13; Sub 36 36; Neg 3; Neg 16; Mul 2 1; Mul 3 5;
  Add 1 0; Add 0 1; Mul 6 4; Add 1 0; Mul 0 9; Mul 0 24; Sub 10 0; Add 0 48; Mul 3 14; Sub 13 0;
  Add 0 51; Mul 6 18; Sub 16 0; Add 0 54; Sub 33 55; Mul 0 18; Add 0 16; Add 0 17; Add 0 15;
  Mul 0 24; Mul 0 39; Sub 6 0; Add 0 63; Mul 3 29; Sub 28 0; Add 0 66; Mul 6 33; Sub 31 0;
  Add 0 69; Sub 6 21; Sub 4 19; Sub 2 17; Mul 17 38; Add 34 0; Add 0 34; Add 0 32; Mul 0 41;
  Mul 0 56; Sub 42 0; Add 0 80; Mul 3 46; Sub 26 0; Add 0 83; Sub 47 2; Add 0 85; Mul 8 52;
  Sub 50 0; Add 0 88; Sub 8 40; Sub 6 38; Sub 5 39; Sub 3 37; Add 51 19; Add 0 50; Mul 0 59;
  Mul 0 74; Sub 60 0; Add 0 98; Mul 3 64; Sub 63 0; Add 0 101; Sub 46 2; Add 0 103; Mul 8 70;
  Sub 68 0; Add 0 106; Sub 8 58; Sub 6 56; Sub 5 57; Sub 3 55; Mul 55 72; Add 69 0; Mul 0 77;
  Mul 0 92; Sub 78 0; Add 0 116; Mul 3 82; Sub 81 0; Add 0 119; Mul 6 86; Sub 65 0; Add 0 122;
  Sub 6 74; Sub 4 72; Sub 2 70; Mul 118 118; Mul 118 118; Add 1 0; Sub 0 114; Mul 0 97; Neg 123;
  Neg 123; Mul 62 111; Mul 44 2; Add 1 0; Mul 28 3; Add 1 0; Mul 14 7; Add 1 0; Mul 68 118;
  Mul 50 9; Add 1 0; Mul 34 10; Add 1 0; Mul 20 14; Add 1 0; Mul 55 15; Add 7 0; Mul 39 16;
  Add 1 0; Add 0 5; Mul 79 130; Mul 60 21; Add 1 0; Mul 44 22; Add 1 0; Mul 31 26; Add 1 0;
  Mul 88 159; Mul 70 136; Add 1 0; Mul 54 137; Add 1 0; Mul 40 135; Add 1 0; Mul 94 166;
  Mul 76 143; Add 1 0; Mul 60 144; Add 1 0; Mul 46 142; Add 1 0; Mul 81 149; Add 7 0; Mul 65 150;
  Add 1 0; Add 0 5; Mul 105 178; Mul 86 155; Add 1 0; Mul 70 156; Add 1 0; Mul 57 154; Add 1 0;
  Add 19 136; Add 13 134; Add 9 135; Add 3 133; Div 167 49; Mul 4 0; Mul 0 44; Mul 1 40; Mul 2 34;
  Sub 7 2; Sub 7 2; Sub 7 2; Div 175 190; Mul 196 0; Mul 196 1; Add 200 1; Add 201 1; Div 179 195;
  Mul 8 2; Mul 8 2; Add 1 0; Add 0 9; Sub 4 0;
  ShowZero 0; (* the plane meets the vertex *)
  Neg 61; Mul 0 19; Neg 58; Mul 0 21; Mul 197 190; Mul 23 23; Mul 1 0; Mul 216 17; Sub 6 15;
  Sub 5 15; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 6; Mul 6 6; Sub 1 0;
  ShowZero 0 (* orthogonal to the circle of the vertex *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** the inverted Enneper surface and its image under τ; size 2.
    Code: src/construct/koebe.rs, src/construct/minimal/enneper.rs, src/construct/packing.rs,
    src/construct/transfer/euclidean.rs, src/net/i_isothermic.rs, src/scalar/ring.rs,
    src/space/circle.rs, src/space/gradient.rs, src/space/laguerre/cone.rs, src/space/moebius.rs,
    src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs, src/space/similarity.rs,
    src/space/sphere.rs *)
Definition part_3_size_2 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Constant 3;
  Nonzero 0; (* 3 != 0 in the field *)
  Unknown 0; Unknown 1; Constant 1; Div 0 4; Constant 0; Add 0 1; Sub 5 0; Sub 5 1; Mul 1 1;
  Mul 1 1; Add 1 0; Mul 7 7; Sub 1 0;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 10 9; Sub 12 0; Mul 0 0; Add 7 0; Sub 0 5;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 15 13; Add 14 14; Sub 19 1; Sub 19 1; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 13;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 25 12; Mul 0 0; Add 0 18; Sub 0 17;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Sub 28 11; Mul 0 0; Add 9 0; Sub 0 21;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 6 18; Sub 0 23;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 37 31; Sub 36 0; Mul 0 0; Add 0 15; Sub 0 28;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Add 2 9; Sub 0 30;
  Nonzero 0; (* no circle of a vertex or a face passes through the centre of the inversion *)
  Constant 4; Div 41 0; Div 42 45; Constant 12; Div 44 0; Sub 43 47; Sub 44 47; Mul 1 1; Mul 1 1;
  Add 1 0; Sub 0 8; Mul 3 8; Sub 3 0; Add 0 8; Mul 8 0; Mul 6 12; Sub 0 8; Sub 0 12; Mul 11 0;
  Mul 8 58; Mul 0 0; Sub 6 59; Sub 3 60; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Sub 67 68; Mul 0 0; Add 21 0; Sub 0 28; Sub 2 19; Add 0 27; Mul 27 0; Mul 5 31; Sub 0 27;
  Sub 0 31; Mul 9 0; Mul 7 77; Mul 0 0; Sub 6 78; Sub 3 79; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Sub 90 87; Mul 0 0; Add 40 0; Sub 0 47; Sub 2 38; Add 0 46; Mul 46 0; Mul 5 50; Sub 0 46;
  Sub 0 50; Mul 9 0; Mul 7 96; Mul 0 0; Sub 6 97; Sub 3 98; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Sub 105 107; Mul 0 0; Add 0 58; Sub 0 66; Mul 2 66; Sub 61 0; Add 0 66; Mul 6 0; Sub 57 6;
  Sub 0 69; Mul 68 0; Mul 7 115; Mul 0 0; Sub 5 116; Sub 3 117; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Add 17 55; Sub 0 83; Sub 57 16; Add 0 82; Mul 22 0; Sub 54 22; Sub 0 85; Mul 63 0; Mul 6 131;
  Mul 0 0; Sub 5 132; Sub 3 133; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Add 33 52; Sub 0 99; Sub 54 32; Add 0 98; Mul 38 0; Sub 51 38; Sub 0 101; Mul 60 0; Mul 6 147;
  Mul 0 0; Sub 5 148; Sub 3 149; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Sub 160 158; Mul 0 0; Add 0 109; Sub 0 117; Mul 2 117; Sub 112 0; Add 0 117; Mul 6 0; Sub 108 6;
  Sub 0 120; Mul 119 0; Mul 7 166; Mul 0 0; Sub 5 167; Sub 3 168; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Add 17 106; Sub 0 134; Sub 108 16; Add 0 133; Mul 22 0; Sub 105 22; Sub 0 136; Mul 114 0;
  Mul 6 182; Mul 0 0; Sub 5 183; Sub 3 184; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Add 33 103; Sub 0 150; Sub 105 32; Add 0 149; Mul 38 0; Sub 102 38; Sub 0 152; Mul 111 0;
  Mul 6 198; Mul 0 0; Sub 5 199; Sub 3 200; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Add 147 90;
  Nonzero 0; (* no edge has length 0 *)
  Mul 153 153; Mul 150 150; Add 1 0; Sub 0 150; Mul 0 211; Mul 100 100; Mul 98 98; Add 1 0;
  Sub 0 98; Mul 0 216; Mul 89 89; Mul 87 87; Add 1 0; Sub 0 87; Mul 0 221; Sub 110 168;
  Sub 108 165; Sub 7 12; Sub 97 171; Sub 95 168; Sub 5 15; Mul 5 1; Mul 5 3; Sub 1 0; Div 232 0;
  Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Sub 4 186; Sub 1 183;
  Mul 19 0; Mul 19 2; Sub 1 0; Div 0 38; Mul 0 0; Sub 11 246; Sub 8 247; Mul 1 1; Mul 1 1;
  Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Mul 252 252; Add 0 0; Sub 0 256; Mul 0 256; Neg 256; Div 263 259; Sub 258 258; Neg 3; Neg 262;
  Mul 2 1; Mul 3 5; Add 1 0; Add 0 1; Mul 6 4; Add 1 0; Mul 0 9; Mul 0 270; Sub 10 0; Add 0 270;
  Mul 3 14; Sub 13 0; Add 0 273; Sub 276 274; Mul 0 15; Add 0 13; Add 0 14; Add 0 12; Mul 0 21;
  Mul 0 282; Sub 6 0; Add 0 282; Mul 3 26; Sub 25 0; Add 0 285; Sub 3 15; Sub 1 13; Mul 13 31;
  Add 27 0; Add 0 27; Add 0 25; Mul 0 34; Mul 0 295; Sub 35 0; Add 0 295; Mul 3 39; Sub 22 0;
  Add 0 298; Sub 40 2; Add 0 300; Sub 5 30; Sub 3 28; Sub 2 29; Add 40 15; Add 0 39; Mul 0 48;
  Mul 0 309; Sub 49 0; Add 0 309; Mul 3 53; Sub 52 0; Add 0 312; Sub 38 2; Add 0 314; Sub 5 44;
  Sub 3 42; Sub 2 43; Mul 43 57; Add 54 0; Mul 0 62; Mul 0 323; Sub 63 0; Add 0 323; Mul 3 67;
  Sub 66 0; Add 0 326; Sub 3 56; Sub 1 54; Mul 94 94; Mul 91 91; Add 1 0; Sub 0 86; Mul 0 334;
  Neg 99; Neg 96; Mul 49 338; Mul 35 2; Add 1 0; Mul 23 3; Add 1 0; Mul 13 7; Add 1 0; Mul 55 345;
  Mul 41 9; Add 1 0; Mul 29 10; Add 1 0; Mul 19 14; Add 1 0; Mul 46 15; Add 7 0; Mul 34 16;
  Add 1 0; Add 0 5; Div 357 12; Neg 6; Mul 0 1; Neg 3; Mul 0 3; Mul 114 362; Mul 5 5; Mul 1 0;
  Sub 5 363; Sub 4 364; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5; Add 0 371;
  Nonzero 0; (* no incircle is the image of a great circle: 1 + N != 0 *)
  Add 293 239;
  Nonzero 0; (* no edge has length 0 *)
  Mul 299 299; Mul 296 296; Add 1 0; Sub 0 296; Mul 0 376; Mul 233 233; Mul 231 231; Add 1 0;
  Sub 0 231; Mul 0 381; Sub 254 309; Sub 252 306; Sub 162 7; Sub 241 312; Sub 239 309; Sub 5 10;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 392 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Sub 4 327; Sub 1 324; Mul 19 0; Mul 19 2; Sub 1 0; Div 0 33; Mul 0 0;
  Sub 11 406; Sub 8 407; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Mul 17 17; Mul 14 14; Add 1 0; Sub 0 9; Mul 0 417; Neg 22; Neg 19; Mul 117 1; Add 83 0;
  Mul 105 2; Add 1 0; Mul 95 6; Add 1 0; Mul 122 7; Add 82 0; Mul 110 8; Add 1 0; Mul 100 12;
  Add 1 0; Mul 127 13; Add 88 0; Mul 115 14; Add 1 0; Add 0 5; Div 438 11; Neg 6; Mul 0 1; Neg 3;
  Mul 0 3; Mul 35 443; Mul 5 5; Mul 1 0; Sub 5 444; Sub 4 445; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Add 0 452;
  Nonzero 0; (* no incircle is the image of a great circle: 1 + N != 0 *)
  Add 336 285;
  Nonzero 0; (* no edge has length 0 *)
  Mul 290 290; Mul 288 288; Add 1 0; Sub 0 288; Mul 0 457; Mul 279 279; Mul 277 277; Add 1 0;
  Sub 0 277; Mul 0 462; Sub 300 351; Sub 298 349; Sub 7 248; Sub 287 354; Sub 285 352; Sub 5 251;
  Mul 5 1; Mul 5 3; Sub 1 0; Div 473 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11;
  Sub 1 0; Mul 0 7; Sub 4 369; Sub 1 367; Mul 19 0; Mul 19 2; Sub 1 0; Div 0 33; Mul 0 0;
  Sub 11 487; Sub 8 488; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Mul 17 17; Mul 14 14; Add 1 0; Sub 0 9; Mul 0 498; Neg 22; Neg 19; Mul 198 1; Add 164 0;
  Mul 186 2; Add 1 0; Mul 176 6; Add 1 0; Mul 203 7; Add 163 0; Mul 191 8; Add 1 0; Mul 181 12;
  Add 1 0; Mul 208 13; Add 169 0; Mul 196 14; Add 1 0; Add 0 5; Div 519 11; Neg 6; Mul 0 1; Neg 3;
  Mul 0 3; Mul 35 524; Mul 5 5; Mul 1 0; Sub 5 525; Sub 4 526; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Add 0 533;
  Nonzero 0; (* no incircle is the image of a great circle: 1 + N != 0 *)
  Add 401 350;
  Nonzero 0; (* no edge has length 0 *)
  Mul 339 339; Mul 337 337; Add 1 0; Sub 0 337; Mul 0 538; Sub 360 411; Sub 358 409; Sub 78 319;
  Sub 347 414; Sub 345 412; Sub 5 322; Mul 5 1; Mul 5 3; Sub 1 0; Div 549 0; Mul 7 5; Mul 9 5;
  Sub 1 0; Mul 0 3; Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Sub 4 429; Sub 1 427; Mul 19 0;
  Mul 19 2; Sub 1 0; Div 0 28; Mul 0 0; Sub 11 563; Sub 8 564; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Nonzero 0; (* no vertex circle and no incircle passes through the centre of the inversion *)
  Mul 17 17; Mul 14 14; Add 1 0; Sub 0 9; Mul 0 574; Neg 22; Neg 19; Mul 274 1; Add 240 0;
  Mul 262 2; Add 1 0; Mul 252 6; Add 1 0; Mul 279 7; Add 239 0; Mul 267 8; Add 1 0; Mul 257 12;
  Add 1 0; Mul 284 13; Add 245 0; Mul 272 14; Add 1 0; Add 0 5; Div 595 11; Neg 6; Mul 0 1; Neg 3;
  Mul 0 3; Mul 35 600; Mul 5 5; Mul 1 0; Sub 5 601; Sub 4 602; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 5;
  Add 0 609;
  Nonzero 0; (* no incircle is the image of a great circle: 1 + N != 0 *)
  Sub 607 612; Sub 608 612; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 573;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 605 617; Mul 0 0; Add 5 0; Sub 0 577;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Sub 609 622; Mul 0 0; Add 0 8; Sub 0 581;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  Add 2 6; Sub 0 583;
  ShowNonzero 0; (* as src/construct/minimal/enneper.rs finds *)
  ShowNonzero 626; (* as src/space/sphere.rs finds *)
  Mul 628 571; Mul 628 568; Add 1 0; Sub 580 581; Mul 0 629; Add 0 2; Mul 634 519; Mul 634 517;
  Add 1 0; Sub 586 528; Mul 0 635; Add 0 2; Mul 640 509; Mul 640 507; Add 1 0; Sub 572 534;
  Mul 0 641; Add 0 2; Sub 6 12; Sub 1 13; Mul 1 418; Mul 422 1; Sub 1 0; Mul 0 416; Mul 426 4;
  Mul 6 424; Sub 1 0; Mul 0 420; Mul 4 599; Mul 1 596; Add 1 0; Sub 25 0; Add 1 0; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 547; Mul 7 545; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 536; Mul 12 534; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 672 596; Mul 672 593; Add 1 0; Sub 604 625; Mul 0 673; Add 0 2; Mul 26 602; Mul 23 599;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 444 626; Mul 441 623; Add 1 0; Sub 471 0; Add 1 0; Sub 473 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 450 574; Mul 447 572; Add 1 0; Add 0 5; Sub 473 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 455 563; Mul 452 561; Add 1 0; Add 0 10; Sub 473 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 460 623; Mul 457 620; Add 1 0; Add 0 15; Sub 323 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 704 557; Mul 704 555; Add 1 0; Sub 617 598; Mul 0 705; Add 0 2; Sub 64 32; Sub 1 33;
  Mul 1 322; Mul 326 1; Sub 1 0; Mul 0 320; Mul 330 4; Mul 6 328; Sub 1 0; Mul 0 324; Mul 4 644;
  Mul 1 641; Add 1 0; Sub 45 0; Add 1 0; Sub 47 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 595; Mul 7 593; Add 1 0; Add 0 5; Sub 84 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 584; Mul 12 582; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 736 641; Mul 736 638; Add 1 0; Sub 649 689; Mul 0 737; Add 0 2; Mul 26 647; Mul 23 644;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 348 671; Mul 345 668; Add 1 0; Sub 370 0; Add 1 0; Sub 372 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 354 622; Mul 351 620; Add 1 0; Add 0 5; Sub 532 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 359 611; Mul 356 609; Add 1 0; Add 0 10; Sub 377 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 668 668; Mul 665 665; Add 1 0; Sub 0 665; Mul 0 764; Mul 369 673; Mul 366 670; Add 1 0;
  Add 0 20; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 773 607; Mul 773 605; Add 1 0; Sub 725 616; Mul 0 774; Add 0 2; Mul 779 597; Mul 779 595;
  Add 1 0; Sub 711 622; Mul 0 780; Add 0 2; Sub 6 145; Sub 1 146; Mul 1 316; Mul 320 1; Sub 1 0;
  Mul 0 314; Mul 324 4; Mul 6 322; Sub 1 0; Mul 0 318; Mul 4 680; Mul 1 678; Add 1 0; Sub 158 0;
  Add 1 0; Sub 160 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 635; Mul 7 633; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 624; Mul 12 622; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 680; Mul 17 678; Add 1 0; Add 0 15; Sub 169 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 336 701; Mul 333 699; Add 1 0; Sub 599 0; Add 1 0; Sub 601 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 342 656; Mul 339 654; Add 1 0; Add 0 5; Sub 365 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 347 645; Mul 344 643; Add 1 0; Add 0 10; Sub 365 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 352 701; Mul 349 699; Add 1 0; Add 0 15; Sub 611 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 837 639; Mul 837 637; Add 1 0; Sub 750 680; Mul 0 838; Add 0 2; Sub 58 197; Sub 1 198;
  Mul 1 298; Mul 302 1; Sub 1 0; Mul 0 296; Mul 306 4; Mul 6 304; Sub 1 0; Mul 0 300; Mul 4 722;
  Mul 1 720; Add 1 0; Sub 210 0; Add 1 0; Sub 212 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 677; Mul 7 675; Add 1 0; Add 0 5; Sub 78 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 666; Mul 12 664; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 722; Mul 17 720; Add 1 0; Add 0 15; Sub 163 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 318 743; Mul 315 741; Add 1 0; Sub 652 0; Add 1 0; Sub 654 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 324 698; Mul 321 696; Add 1 0; Add 0 5; Sub 418 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 329 687; Mul 326 685; Add 1 0; Add 0 10; Sub 347 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 334 743; Mul 331 741; Add 1 0; Add 0 15; Sub 509 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 893 826; Mul 832 0; Mul 832 1; Add 894 1; Add 895 1; Mul 838 4; Div 899 775; Mul 781 0;
  Mul 781 1; Add 900 1; Add 901 1; Mul 787 4; Sub 8 2; Sub 8 2; Mul 1 1; Mul 1 1; Add 1 0;
  Add 11 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Div 913 773; Mul 779 0; Mul 779 1; Add 914 1; Add 915 1; Mul 785 4; Sub 16 2; Sub 16 2; Mul 1 1;
  Mul 1 1; Add 1 0; Add 19 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Div 927 841; Mul 847 0; Mul 847 1; Add 928 1; Add 929 1; Mul 853 4; Sub 16 2; Sub 16 2; Mul 1 1;
  Mul 1 1; Add 1 0; Add 19 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Sub 10 44; Sub 10 44; Mul 1 1; Mul 1 1; Add 1 0; Add 13 47; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Div 949 793; Mul 799 0; Mul 799 1; Add 950 1; Add 951 1; Mul 805 4; Sub 38 2; Sub 38 2; Mul 1 1;
  Mul 1 1; Add 1 0; Add 41 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Div 963 858; Mul 864 0; Mul 864 1; Add 964 1; Add 965 1; Mul 870 4; Sub 16 2; Sub 16 2; Mul 1 1;
  Mul 1 1; Add 1 0; Add 19 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Sub 10 46; Sub 10 46; Mul 1 1; Mul 1 1; Add 1 0; Add 13 49; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Div 985 810; Mul 816 0; Mul 816 1; Add 986 1; Add 987 1; Mul 822 4; Sub 88 2; Sub 88 2; Mul 1 1;
  Mul 1 1; Add 1 0; Add 91 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Div 999 808; Mul 814 0; Mul 814 1; Add 1000 1; Add 1001 1; Mul 820 4; Sub 16 2; Sub 16 2;
  Mul 1 1; Mul 1 1; Add 1 0; Add 19 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Sub 10 96; Sub 10 96; Mul 1 1; Mul 1 1; Add 1 0; Add 13 99; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Div 1021 814; Mul 820 0; Mul 820 1; Add 1022 1; Add 1023 1; Mul 826 4; Sub 24 2; Sub 24 2;
  Mul 1 1; Mul 1 1; Add 1 0; Add 27 5; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Sub 10 82; Sub 10 82; Mul 1 1; Mul 1 1; Add 1 0; Add 13 85; Mul 0 0; Sub 2 0;
  ShowZero 0; (* as src/construct/transfer/euclidean.rs finds *)
  Div 411 976; Div 406 920; Div 401 905; Sub 143 149; Sub 143 149; Sub 3 4; Sub 132 152;
  Sub 132 152; Sub 5 7; Mul 5 1; Mul 5 3; Sub 1 0; Div 1055 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3;
  Mul 13 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 167; Mul 1 167; Add 1 0; Sub 23 0; Add 1 0;
  Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 167; Mul 7 167; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 158; Mul 12 158; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 404 994; Mul 21 150; Mul 18 150; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 189 189; Mul 189 189; Add 1 0; Mul 190 190; Sub 1 0; Mul 0 1090; Mul 189 189; Mul 189 189;
  Add 1 0; Mul 190 190; Sub 1 0; Mul 0 1096; Mul 181 181; Mul 181 181; Add 1 0; Mul 182 182;
  Sub 1 0; Mul 0 1102; Sub 6 12; Sub 1 13; Mul 1 55; Mul 59 1; Sub 1 0; Mul 0 53; Mul 63 4;
  Mul 6 61; Sub 1 0; Mul 0 57; Mul 4 217; Mul 1 217; Add 1 0; Sub 25 0; Add 1 0; Sub 27 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 217; Mul 7 217; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 208; Mul 12 208; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 199 199; Mul 199 199; Add 1 0; Mul 200 200; Sub 1 0; Mul 0 1134; Mul 26 205; Mul 23 205;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 433 985; Sub 96 61; Sub 190 212; Sub 190 212; Sub 3 64; Mul 212 1; Mul 212 3; Sub 1 0;
  Div 1149 0; Mul 7 5; Mul 216 5; Sub 1 0; Mul 0 3; Mul 220 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 227; Mul 1 227; Add 1 0; Sub 80 0; Add 1 0; Sub 82 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 247; Mul 7 247; Add 1 0; Add 0 5; Sub 122 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 216; Mul 12 216; Add 1 0; Add 0 10; Sub 31 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 434 1069; Mul 21 208; Mul 18 208; Add 1 0; Add 0 16; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 227 227; Mul 227 227; Add 1 0; Mul 228 228; Sub 1 0; Mul 0 1184; Sub 82 50; Sub 1 51;
  Mul 1 43; Mul 254 1; Sub 1 0; Mul 0 41; Mul 258 4; Mul 6 49; Sub 1 0; Mul 0 45; Mul 4 265;
  Mul 1 265; Add 1 0; Sub 63 0; Add 1 0; Sub 65 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 285; Mul 7 285; Add 1 0; Add 0 5; Sub 102 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 254; Mul 12 254; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 245 245; Mul 245 245; Add 1 0; Mul 246 246; Sub 1 0; Mul 0 1216; Mul 26 251; Mul 23 251;
  Add 1 0; Add 0 21; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 446 1048; Div 441 1033; Sub 236 322; Sub 236 322; Sub 3 182; Sub 225 325; Sub 225 325;
  Sub 5 185; Mul 5 1; Mul 5 3; Sub 1 0; Div 1234 0; Mul 7 5; Mul 9 5; Sub 1 0; Mul 0 3; Mul 13 8;
  Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 340; Mul 1 340; Add 1 0; Sub 201 0; Add 1 0; Sub 203 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 260; Mul 7 260; Add 1 0; Add 0 5; Sub 29 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 251; Mul 12 251; Add 1 0; Add 0 10; Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 342; Mul 17 342; Add 1 0; Add 0 15; Sub 217 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 275 275; Mul 275 275; Add 1 0; Mul 276 276; Sub 1 0; Mul 0 1268; Mul 267 267; Mul 267 267;
  Add 1 0; Mul 268 268; Sub 1 0; Mul 0 1274; Sub 6 178; Sub 1 179; Mul 1 48; Mul 52 1; Sub 1 0;
  Mul 0 46; Mul 56 4; Mul 6 54; Sub 1 0; Mul 0 50; Mul 4 383; Mul 1 383; Add 1 0; Sub 191 0;
  Add 1 0; Sub 193 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 303; Mul 7 303; Add 1 0; Add 0 5; Sub 26 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 294; Mul 12 294; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 385; Mul 17 385; Add 1 0; Add 0 15; Sub 202 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Div 466 1100; Sub 83 262; Sub 284 392; Sub 284 392; Sub 3 265; Mul 298 1; Mul 298 3; Sub 1 0;
  Div 1315 0; Mul 7 5; Mul 302 5; Sub 1 0; Mul 0 3; Mul 306 8; Mul 12 11; Sub 1 0; Mul 0 7;
  Mul 4 407; Mul 1 407; Add 1 0; Sub 281 0; Add 1 0; Sub 283 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 327; Mul 7 327; Add 1 0; Add 0 5; Sub 109 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 310; Mul 12 310; Add 1 0; Add 0 10; Sub 31 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 387; Mul 17 387; Add 1 0; Add 0 15; Sub 202 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 320 320; Mul 320 320; Add 1 0; Mul 321 321; Sub 1 0; Mul 0 1349; Sub 75 247; Sub 1 248;
  Mul 1 42; Mul 339 1; Sub 1 0; Mul 0 40; Mul 343 4; Mul 6 48; Sub 1 0; Mul 0 44; Mul 4 444;
  Mul 1 444; Add 1 0; Sub 260 0; Add 1 0; Sub 262 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 364; Mul 7 364; Add 1 0; Add 0 5; Sub 95 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 347; Mul 12 347; Add 1 0; Add 0 10; Sub 25 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 20 424; Mul 17 424; Add 1 0; Add 0 15; Sub 195 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 272 272; Mul 269 269; Add 1 0; Mul 267 1389; Add 1 0; Sub 2 0; Add 1388 0; Div 1389 0;
  Mul 1394 0; Mul 323 0; Neg 0; Mul 0 279; Sub 0 330; Mul 281 4; Sub 1396 8; Mul 0 7; Mul 116 116;
  Mul 113 113; Add 1 0; Mul 111 1405; Add 1 0; Sub 2 0; Add 1404 0; Div 1405 0; Mul 1410 0;
  Mul 160 0; Neg 0; Mul 0 123; Sub 0 167; Mul 125 4; Sub 1412 8; Mul 0 7; Sub 3 19; Sub 6 22;
  Sub 4 20; Sub 3 19; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 28 311; Sub 0 362; Mul 313 32; Mul 15 142; Sub 0 186; Mul 144 19; Sub 1 4; Sub 1 4;
  Mul 13 0; Mul 2 12; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 15; Mul 18 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 78 78; Mul 75 75; Add 1 0; Mul 73 1442; Add 1 0; Sub 2 0; Add 1441 0; Div 1442 0;
  Mul 1447 0; Mul 116 0; Neg 0; Mul 0 85; Sub 0 123; Mul 87 4; Sub 1449 8; Mul 0 7; Sub 3 40;
  Sub 6 43; Sub 4 41; Sub 3 40; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 12 101; Sub 0 139; Mul 103 16; Sub 1 35; Sub 1 35; Mul 10 0; Mul 2 9; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 12; Mul 15 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 277 277; Mul 274 274; Add 1 0; Mul 272 1476; Add 1 0; Sub 2 0; Add 1475 0; Div 1476 0;
  Mul 1481 0; Mul 316 0; Neg 0; Mul 0 284; Sub 0 323; Mul 286 4; Sub 1483 8; Mul 0 7; Sub 3 37;
  Sub 6 40; Sub 4 38; Sub 3 37; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 12 300; Sub 0 339; Mul 302 16; Sub 1 35; Sub 1 35; Mul 10 0; Mul 2 9; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 12; Mul 15 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 108 21; Sub 111 24; Sub 109 22; Sub 108 21; Mul 3 0; Mul 3 2; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Sub 87 16; Sub 87 16; Mul 7 0; Mul 2 6; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 4 9; Mul 12 4; Sub 1 0;
  ShowZero 0; (* as a test finds *)
  Mul 1248 1260; Sub 1258 0; Add 0 1518; Mul 1239 1263; Sub 1261 0; Add 0 1521; Sub 0 3;
  Mul 1230 1267; Sub 1265 0; Add 0 1525; Sub 0 7; Mul 1220 1271; Sub 1269 0; Add 0 1529; Sub 0 11;
  Mul 1210 1275; Sub 1257 0; Add 0 1533; Sub 0 15; Mul 12 1537; Mul 9 1201; Add 1 0; Mul 7 1202;
  Add 1 0; Mul 5 1206; Add 1 0; Mul 1255 1542; Mul 1241 895; Add 1 0; Mul 1229 893; Add 1 0;
  Mul 1219 891; Add 1 0; Mul 1261 1549; Mul 1247 902; Add 1 0; Mul 1235 900; Add 1 0;
  Mul 1225 898; Add 1 0; Mul 1252 908; Add 7 0; Mul 1240 906; Add 1 0; Add 0 5; Mul 38 1561;
  Mul 35 914; Add 1 0; Mul 33 912; Add 1 0; Mul 31 910; Add 1 0; Add 19 1297; Add 13 1295;
  Add 9 1296; Add 3 52; Mul 3 1216; Mul 0 1223; Mul 1 1219; Mul 2 33; Sub 6 2; Sub 6 2; Sub 6 2;
  Mul 2 684; Mul 2 684; Add 1 0; Add 0 3; Sub 541 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1226 689; Sub 1225 689; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1226; Sub 0 502;
  ShowZero 0; (* orthogonal *)
  Mul 14 690; Mul 14 690; Add 1 0; Add 0 15; Sub 552 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1238 695; Sub 1237 695; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1238; Sub 0 508;
  ShowZero 0; (* orthogonal *)
  Mul 26 688; Mul 26 688; Add 1 0; Add 0 27; Sub 563 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1250 693; Sub 1249 693; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1250; Sub 0 514;
  ShowZero 0; (* orthogonal *)
  Mul 38 686; Mul 38 686; Add 1 0; Add 0 39; Sub 540 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1262 691; Sub 1261 691; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1262; Sub 0 494;
  ShowZero 0; (* orthogonal *)
  Mul 100 1209; Add 92 0; Mul 98 1210; Add 1 0; Mul 96 1214; Add 1 0; Mul 1331 921; Add 91 0;
  Mul 1319 919; Add 1 0; Mul 1309 917; Add 1 0; Mul 1336 927; Add 90 0; Mul 1324 925; Add 1 0;
  Mul 1314 923; Add 1 0; Mul 1341 933; Add 96 0; Mul 1329 931; Add 1 0; Add 0 5; Mul 123 938;
  Add 89 0; Mul 121 936; Add 1 0; Mul 119 934; Add 1 0; Add 17 1385; Add 12 1383; Add 8 1384;
  Add 3 140; Mul 3 1223; Mul 0 1230; Mul 1 1226; Mul 2 30; Sub 6 2; Sub 6 2; Sub 6 2; Mul 2 738;
  Mul 2 738; Add 1 0; Add 0 3; Sub 592 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1233 743; Sub 1232 743; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1233; Sub 0 546;
  ShowZero 0; (* orthogonal *)
  Mul 14 764; Mul 14 764; Add 1 0; Add 0 15; Sub 639 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1245 769; Sub 1244 769; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1245; Sub 0 590;
  ShowZero 0; (* orthogonal *)
  Mul 26 740; Mul 26 740; Add 1 0; Add 0 27; Sub 555 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1257 745; Sub 1256 745; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1257; Sub 0 520;
  ShowZero 0; (* orthogonal *)
  Mul 38 738; Mul 38 738; Add 1 0; Add 0 39; Sub 534 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1269 743; Sub 1268 743; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1269; Sub 0 500;
  ShowZero 0; (* orthogonal *)
  Mul 188 1216; Add 180 0; Mul 186 1217; Add 1 0; Mul 184 1221; Add 1 0; Mul 1419 934; Add 179 0;
  Mul 1407 932; Add 1 0; Mul 1397 930; Add 1 0; Mul 1424 940; Add 178 0; Mul 1412 938; Add 1 0;
  Mul 1402 936; Add 1 0; Mul 1429 946; Add 184 0; Mul 1417 944; Add 1 0; Add 0 5; Mul 211 951;
  Add 177 0; Mul 209 949; Add 1 0; Mul 207 947; Add 1 0; Add 17 1473; Add 12 1471; Add 8 1472;
  Add 3 228; Mul 3 1230; Mul 0 1237; Mul 1 1233; Mul 2 30; Sub 6 2; Sub 6 2; Sub 6 2; Mul 2 854;
  Mul 2 854; Add 1 0; Add 0 3; Sub 716 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1240 859; Sub 1239 859; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1240; Sub 0 672;
  ShowZero 0; (* orthogonal *)
  Mul 14 780; Mul 14 780; Add 1 0; Add 0 15; Sub 549 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1252 785; Sub 1251 785; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1252; Sub 0 512;
  ShowZero 0; (* orthogonal *)
  Mul 26 778; Mul 26 778; Add 1 0; Add 0 27; Sub 560 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1264 783; Sub 1263 783; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1264; Sub 0 518;
  ShowZero 0; (* orthogonal *)
  Mul 38 876; Mul 38 876; Add 1 0; Add 0 39; Sub 751 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1276 881; Sub 1275 881; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1276; Sub 0 702;
  ShowZero 0; (* orthogonal *)
  Mul 276 1228; Add 268 0; Mul 274 1229; Add 1 0; Mul 272 1233; Add 1 0; Mul 1507 964; Add 267 0;
  Mul 1495 962; Add 1 0; Mul 1485 960; Add 1 0; Mul 1512 970; Add 266 0; Mul 1500 968; Add 1 0;
  Mul 1490 966; Add 1 0; Mul 1517 976; Add 272 0; Mul 1505 974; Add 1 0; Add 0 5; Mul 299 981;
  Add 265 0; Mul 297 979; Add 1 0; Mul 295 977; Add 1 0; Add 17 1561; Add 12 1559; Add 8 1560;
  Add 3 316; Mul 3 1242; Mul 0 1249; Mul 1 1245; Mul 2 30; Sub 6 2; Sub 6 2; Sub 6 2; Mul 2 928;
  Mul 2 928; Add 1 0; Add 0 3; Sub 803 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1252 933; Sub 1251 933; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1252; Sub 0 754;
  ShowZero 0; (* orthogonal *)
  Mul 14 854; Mul 14 854; Add 1 0; Add 0 15; Sub 636 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1264 859; Sub 1263 859; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1264; Sub 0 594;
  ShowZero 0; (* orthogonal *)
  Mul 26 844; Mul 26 844; Add 1 0; Add 0 27; Sub 565 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1276 849; Sub 1275 849; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1276; Sub 0 531;
  ShowZero 0; (* orthogonal *)
  Mul 38 928; Mul 38 928; Add 1 0; Add 0 39; Sub 743 0;
  ShowZero 0; (* in the plane of the circle *)
  Sub 1288 933; Sub 1287 933; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 1288; Sub 0 708;
  ShowZero 0; (* orthogonal *)
  ShowZero 980; (* touching circles *)
  ShowZero 966; (* touching circles *)
  ShowZero 952; (* touching circles *)
  ShowZero 944; (* touching circles *)
  ShowZero 930; (* touching circles *)
  ShowZero 916; (* touching circles *)
  ShowZero 908; (* touching circles *)
  ShowZero 894; (* touching circles *)
  ShowZero 880; (* touching circles *)
  ShowZero 872; (* touching circles *)
  ShowZero 858; (* touching circles *)
  ShowZero 850; (* touching circles *)
  Mul 846 846; Mul 846 846; Add 1 0; Sub 800 806; Sub 1 0; Mul 848 848; Mul 848 848; Add 1 0;
  Sub 799 811; Sub 1 0; Sub 769 813; Sub 958 0; Mul 854 0; Mul 3 963; Sub 1 0; Mul 5 966;
  Mul 859 4; Sub 1 0; Mul 861 968; Mul 861 970; Sub 1 0; Mul 867 6; Mul 867 4; Add 1 0; Mul 19 3;
  Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Sub 817 785; Sub 982 0; Mul 777 777; Mul 777 777; Add 1 0; Sub 740 790; Sub 1 0; Sub 710 792;
  Sub 945 0; Mul 783 0; Mul 3 950; Sub 1 0; Mul 5 953; Mul 788 4; Sub 1 0; Mul 790 955;
  Mul 790 957; Sub 1 0; Mul 1003 6; Mul 1003 4; Add 1 0; Mul 19 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 716 716; Mul 716 716; Add 1 0; Sub 677 849; Sub 1 0; Mul 718 718; Mul 718 718; Add 1 0;
  Sub 676 854; Sub 1 0; Sub 1035 1049; Sub 1035 1049; Mul 1 1; Mul 1 1; Add 1 0; Sub 855 861;
  Sub 1 0; Mul 729 0; Mul 8 6; Sub 1 0; Mul 10 9; Mul 734 4; Sub 1 0; Mul 736 11; Mul 736 13;
  Sub 1 0; Mul 742 6; Mul 742 4; Add 1 0; Mul 24 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Sub 699 871; Sub 956 0; Mul 665 665; Mul 665 665; Add 1 0; Sub 629 876; Sub 1 0; Sub 1027 1063;
  Sub 1027 1063; Mul 1 1; Mul 1 1; Add 1 0; Sub 801 883; Sub 1 0; Mul 676 0; Mul 8 6; Sub 1 0;
  Mul 10 9; Mul 681 4; Sub 1 0; Mul 683 11; Mul 683 13; Sub 1 0; Mul 982 6; Mul 982 4; Add 1 0;
  Mul 24 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Mul 605 583; Mul 604 585; Sub 1 0; Mul 606 575; Mul 581 587; Sub 1 0; Mul 583 590; Mul 612 579;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 586 586; Mul 599 599; Add 1 0;
  Mul 600 600; Add 1 0; Sub 5 0;
  ShowZero 0; (* an edge at distance 1 *)
  Mul 609 566; Mul 608 568; Sub 1 0; Mul 610 561; Mul 598 570; Sub 1 0; Mul 600 573; Mul 616 565;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 572 572; Mul 582 582; Add 1 0;
  Mul 583 583; Add 1 0; Sub 5 0;
  ShowZero 0; (* an edge at distance 1 *)
  Mul 592 552; Mul 591 554; Sub 1 0; Mul 593 547; Mul 584 556; Sub 1 0; Mul 586 559; Mul 599 551;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 558 558; Mul 568 568; Add 1 0;
  Mul 569 569; Add 1 0; Sub 5 0;
  ShowZero 0; (* an edge at distance 1 *)
  Mul 578 554; Mul 577 556; Sub 1 0; Mul 579 552; Mul 570 558; Sub 1 0; Mul 572 561; Mul 585 556;
  Sub 1 0; Mul 6 6; Mul 4 4; Add 1 0; Mul 3 3; Add 1 0; Mul 563 563; Mul 570 570; Add 1 0;
  Mul 571 571; Add 1 0; Sub 5 0;
  ShowZero 0 (* an edge at distance 1 *)
].

Theorem part_3_size_2_valid : valid part_3_size_2.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
