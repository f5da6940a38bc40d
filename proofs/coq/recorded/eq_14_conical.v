(** eq-14-conical (Sec. 3.2, (14))

    With the jumps p_j - p_(j-1) = w_j J e_j of the gradients across the four edges of a vertex,
    their in-circle determinant is the product of the w_j and the balance Im(e₀ e₂ conj(e₁ e₃)): so
    the vertex is i-conical iff (14) holds modulo π. For edges in cyclic order both sums are then
    π.

        ω₁ + ω₃ = ω₂ + ω₄ = π

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** modulo π; size 1.
    Code: src/net/i_conical.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Sub 3 1; Sub 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* adjacent faces are not coplanar *)
  Unknown 4;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 5; Unknown 6; Sub 1 11; Sub 1 11; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* adjacent faces are not coplanar *)
  Unknown 7;
  Nonzero 0; (* no edge is isotropic *)
  Unknown 8; Unknown 9; Sub 1 9; Sub 1 9; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* adjacent faces are not coplanar *)
  Unknown 10;
  Nonzero 0; (* no edge is isotropic *)
  Sub 23 7; Sub 23 7; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* adjacent faces are not coplanar *)
  Unknown 11;
  Nonzero 0; (* no edge is isotropic *)
  Mul 27 18; Mul 27 20; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Mul 22 13; Mul 22 15; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Mul 17 10; Mul 17 12; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Mul 14 35; Mul 14 37; Sub 1 0;
  Nonzero 0; (* consecutive edges are not collinear in the top view *)
  Unknown 12; Unknown 13; Neg 40; Mul 0 37; Mul 43 38; Add 4 1; Add 4 1; Neg 37; Mul 0 34;
  Mul 40 35; Add 9 1; Add 9 1; Neg 34; Mul 0 31; Mul 37 32; Add 14 1; Add 14 1; Neg 33; Mul 0 30;
  Mul 36 31; Add 19 1; Add 19 1; Sub 16 21; Sub 16 21; Sub 13 23; Sub 13 23; Sub 10 25; Sub 10 25;
  Sub 7 27; Sub 7 27; Mul 5 1; Mul 5 1; Sub 1 0; Mul 8 3; Mul 8 5; Add 1 0; Mul 13 9; Mul 13 9;
  Sub 1 0; Mul 16 11; Mul 16 13; Add 1 0; Mul 9 0; Mul 7 4; Sub 1 0; Mul 22 20; Mul 22 20;
  Add 1 0; Mul 25 22; Mul 25 24; Sub 1 0; Mul 24 22; Mul 24 22; Add 1 0; Mul 27 24; Mul 27 26;
  Sub 1 0; Mul 6 3; Mul 10 1; Add 1 0; Neg 15; Sub 1 0;
  ShowZero 0; (* sin(ω₁ + ω₃) *)
  Mul 37 35; Mul 37 35; Add 1 0; Mul 40 37; Mul 40 39; Sub 1 0; Mul 39 45; Mul 39 45; Add 1 0;
  Mul 42 47; Mul 42 49; Sub 1 0; Mul 6 3; Mul 10 1; Add 1 0; Sub 0 32;
  ShowZero 0; (* sin(ω₂ + ω₄) *)
  Unknown 14; Mul 122 78; Mul 122 78; Add 1 0; Sub 3 0; Mul 126 77; Mul 126 77; Add 1 0; Add 0 3;
  Mul 120 86; Mul 120 86; Add 1 0; Sub 11 0; Mul 124 80; Mul 124 80; Add 1 0; Add 0 3; Mul 136 94;
  Mul 136 94; Add 1 0; Sub 19 0; Mul 140 78; Mul 140 78; Add 1 0; Add 0 3; Sub 16 24; Sub 9 25;
  Constant 1; Div 0 55; Mul 3 81; Mul 84 3; Sub 1 0; Mul 0 3; Mul 88 6; Mul 8 87; Sub 1 0;
  Mul 0 7; Sub 12 36; Div 10 42; Mul 1 93; Mul 88 14; Sub 1 0; Mul 0 3; Mul 92 17; Mul 6 99;
  Sub 1 0; Mul 0 7; Sub 14 4; Sub 11 1; Mul 1 104; Mul 1 104; Add 1 0;
  ShowZero 0; (* jump along the edge *)
  Mul 155 129; Mul 155 129; Add 1 0; Sub 54 0; Mul 159 118; Mul 159 118; Add 1 0; Add 0 3;
  Sub 0 59; Div 33 71; Mul 35 112; Mul 115 2; Sub 1 0; Mul 0 3; Mul 119 5; Mul 40 118; Sub 1 0;
  Mul 0 7; Sub 4 37; Sub 1 34; Mul 1 125; Mul 1 125; Add 1 0;
  ShowZero 0; (* jump along the edge *)
  Div 47 96; Mul 15 124; Mul 127 39; Sub 1 0; Mul 0 3; Mul 131 42; Mul 20 130; Sub 1 0; Mul 0 7;
  Sub 4 18; Sub 1 15; Mul 1 137; Mul 1 137; Add 1 0;
  ShowZero 0; (* jump along the edge *)
  Sub 46 9; Sub 43 6; Mul 1 140; Mul 1 140; Add 1 0;
  ShowZero 0; (* jump along the edge *)
  Neg 148; Mul 47 0; Mul 47 151; Add 1 0; Mul 153 153; Mul 153 153; Add 1 0; Div 3 0; Mul 135 0;
  Neg 155; Mul 33 0; Mul 33 158; Add 1 0; Mul 160 160; Mul 160 160; Add 1 0; Div 3 0; Mul 8 0;
  Neg 162; Mul 28 0; Mul 28 165; Add 1 0; Mul 167 167; Mul 167 167; Add 1 0; Div 3 0; Mul 8 0;
  Neg 169; Mul 32 0; Mul 32 172; Add 1 0; Mul 174 174; Mul 174 174; Add 1 0; Div 3 0; Mul 8 0;
  Sub 50 97; Sub 47 94; Sub 89 99; Sub 86 96; Mul 63 63; Mul 63 63; Add 1 0; Mul 6 6; Mul 6 6;
  Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12; Sub 1 0; Mul 3 15; Mul 14 7; Sub 1 0;
  Mul 16 17; Mul 16 19; Sub 1 0; Mul 81 6; Mul 81 4; Add 1 0; Mul 18 3; Add 1 0; Sub 0 27;
  ShowZero 0 (* in-circle determinant of the gradients *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** gradients by normals; size 1.
    Code: src/net/i_conical.rs, src/scalar/ring.rs, src/space/gradient.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Unknown 6; Unknown 7;
  Unknown 8; Unknown 9; Unknown 10; Sub 5 7; Sub 5 7; Sub 5 9; Sub 5 9; Sub 5 11; Sub 5 11;
  Mul 5 5; Mul 5 5; Add 1 0; Mul 6 6; Mul 6 6; Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3;
  Mul 1 12; Sub 1 0; Mul 3 15; Mul 14 7; Sub 1 0; Mul 16 17; Mul 16 19; Sub 1 0; Mul 23 6;
  Mul 23 4; Add 1 0; Mul 18 3; Add 1 0; Unknown 11; Unknown 12; Unknown 13; Mul 39 42; Mul 39 42;
  Add 1 0; Sub 43 0; Constant 0; Add 47 5; Add 47 1; Mul 46 1; Mul 46 1; Add 1 0; Add 0 6;
  Add 53 13; Add 53 13; Mul 52 1; Mul 52 1; Add 1 0; Add 0 12; Mul 18 17; Mul 0 0; Mul 22 0;
  Unknown 14; Unknown 15; Unknown 16; Mul 60 65; Mul 60 65; Add 1 0; Sub 66 0; Add 69 4; Mul 65 0;
  Mul 65 22; Add 1 0; Add 0 4; Add 74 11; Add 74 11; Mul 71 1; Mul 71 1; Add 1 0; Add 0 10;
  Mul 16 15; Mul 0 0; Mul 20 0; Unknown 17; Unknown 18; Unknown 19; Mul 79 86; Mul 79 86; Add 1 0;
  Sub 87 0; Add 90 4; Mul 84 0; Mul 84 43; Add 1 0; Add 0 4; Add 95 11; Add 95 11; Mul 90 1;
  Mul 90 1; Add 1 0; Add 0 10; Mul 16 15; Mul 0 0; Mul 20 0; Unknown 20; Unknown 21; Unknown 22;
  Mul 98 107; Mul 98 107; Add 1 0; Sub 108 0; Add 111 4; Mul 103 0; Mul 103 64; Add 1 0; Add 0 4;
  Add 116 11; Add 116 11; Mul 109 1; Mul 109 1; Add 1 0; Add 0 10; Mul 16 15; Mul 0 0; Mul 20 0;
  Sub 77 125; Sub 77 125; Sub 74 125; Sub 74 128; Sub 74 128; Sub 71 128; Mul 4 0; Mul 4 2;
  Sub 1 0; Mul 6 5; Mul 9 4; Sub 1 0; Mul 11 7; Mul 11 9; Sub 1 0; Mul 6 0; Mul 4 1; Mul 8 8;
  Mul 6 6; Add 1 0; Mul 5 5; Sub 76 146; Sub 73 145; Sub 73 148; Sub 73 148; Sub 70 148; Mul 24 0;
  Mul 4 2; Sub 1 0; Mul 6 5; Mul 8 4; Sub 1 0; Mul 10 7; Mul 31 9; Sub 1 0; Mul 6 0; Mul 4 1;
  Mul 8 8; Mul 6 6; Add 1 0; Mul 5 5; Sub 75 166; Sub 72 165; Sub 72 168; Sub 72 168; Sub 69 168;
  Mul 44 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 8 4; Sub 1 0; Mul 10 7; Mul 51 9; Sub 1 0; Mul 6 0;
  Mul 4 1; Mul 8 8; Mul 6 6; Add 1 0; Mul 5 5; Sub 74 186; Sub 71 185; Sub 71 188; Sub 71 188;
  Sub 68 188; Mul 64 0; Mul 4 2; Sub 1 0; Mul 6 5; Mul 8 4; Sub 1 0; Mul 10 7; Mul 71 9; Sub 1 0;
  Mul 6 0; Mul 4 1; Mul 8 8; Mul 6 6; Add 1 0; Mul 5 5; Mul 4 21; Mul 2 25; Sub 1 0; Mul 4 28;
  Mul 9 25; Sub 1 0; Mul 11 30; Mul 11 32; Sub 1 0; Mul 54 6; Mul 54 4; Add 1 0; Mul 53 3;
  Add 1 0; Mul 38 15; Mul 36 19; Sub 1 0; Mul 38 22; Mul 43 19; Sub 1 0; Mul 45 24; Mul 45 26;
  Sub 1 0; Mul 88 6; Mul 88 4; Add 1 0; Mul 87 3; Add 1 0; Mul 32 69; Mul 30 73; Sub 1 0;
  Mul 32 76; Mul 37 73; Sub 1 0; Mul 39 78; Mul 39 80; Sub 1 0; Mul 102 6; Mul 102 4; Add 1 0;
  Mul 101 3; Add 1 0; Mul 86 63; Mul 84 67; Sub 1 0; Mul 86 70; Mul 91 67; Sub 1 0; Mul 93 72;
  Mul 93 74; Sub 1 0; Mul 116 6; Mul 116 4; Add 1 0; Mul 115 3; Add 1 0; Mul 116 42; Mul 97 29;
  Add 1 0; Mul 79 17; Add 1 0; Mul 61 5; Add 1 0; Sub 0 144;
  ShowZero 0 (* degree 16 *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
