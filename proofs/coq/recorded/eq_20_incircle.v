(** eq-20-incircle (Sec. 4, Fig. 7)

    If a quad has an incircle, so has every parallel quad with mixed area 0: the lengths of its
    tangents are inverse to those of the first.

        R*_j = μ / R_j

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** the quad made from a parallel diagonal has an incircle; size 1.
    Code: src/construct/koebe.rs, src/net/i_isothermic.rs, src/pair/area.rs, src/scalar/ring.rs,
    src/space/circle.rs, src/space/gradient.rs, src/space/oriented_circle.rs, src/space/plane.rs,
    src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Sub 1 0;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Constant 1; Mul 2 3; Add 1 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 2; Sub 0 5;
  Nonzero 0; (* no edge has length 0 *)
  Mul 7 7; Add 5 0;
  Nonzero 0; (* 1 + t² is not 0 *)
  Sub 3 9;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 10 4; Add 8 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 3; Sub 0 13;
  Nonzero 0; (* no edge has length 0 *)
  Sub 1 8;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 9 2; Add 13 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Sub 16 4;
  Nonzero 0; (* no vertex lies on its incircles: R_j != 0 *)
  Mul 5 17; Add 16 0;
  Nonzero 0; (* consecutive edges are not parallel *)
  Unknown 4;
  Nonzero 0; (* S is not a point *)
  Div 18 16; Sub 19 18; Mul 0 1; Add 23 24; Mul 0 3; Div 23 14; Sub 24 16; Mul 0 1; Add 29 23;
  Mul 0 3; Sub 2 7; Sub 1 6; Mul 1 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* the first edge of F has a length *)
  Mul 34 14; Mul 27 10; Div 35 21; Sub 36 23; Mul 0 1; Add 35 28; Mul 0 3; Mul 28 4; Div 41 24;
  Sub 42 26; Mul 0 1; Add 34 46; Mul 0 3; Constant 0; Sub 9 21; Sub 8 20; Sub 5 23; Sub 4 22;
  Mul 1 33; Mul 1 34; Add 6 1; Add 7 1; Mul 3 6; Mul 3 8; Sub 1 0; Mul 29 9; Mul 29 11; Sub 1 0;
  Div 3 0; Mul 33 0; Mul 33 1; Add 17 1; Add 18 1; Sub 1 19; Sub 1 20; Mul 39 1; Mul 39 1;
  Add 1 0; Mul 0 37; Mul 0 37; Div 0 40; Div 0 40; Div 1 40; Div 2 35; Mul 30 30; Add 0 0;
  Mul 4 4; Sub 1 0; Div 81 85; Mul 1 0; Mul 18 18; Mul 18 18; Add 1 0; Mul 10 10; Sub 1 0;
  Mul 0 6; Mul 35 35; Mul 35 35; Add 1 0; Mul 15 15; Sub 1 0; Mul 0 12; Sub 6 12; Sub 42 49;
  Sub 42 50; Sub 3 15; Mul 32 1; Mul 32 3; Sub 1 0; Div 102 0; Mul 7 5; Mul 36 5; Sub 1 0;
  Mul 0 3; Mul 40 8; Mul 12 11; Sub 1 0; Mul 0 7; Mul 4 64; Mul 1 65; Add 1 0; Sub 31 0; Add 1 0;
  Sub 33 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 10 52; Mul 7 52; Add 1 0; Add 0 5; Sub 32 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 15 68; Mul 12 68; Add 1 0; Add 0 10; Sub 31 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Mul 112 85; Sub 84 90; Sub 83 89; Sub 109 86; Sub 108 85; Mul 80 2; Mul 80 4; Sub 1 0; Mul 4 5;
  Mul 4 7; Sub 1 0; Div 3 0; Mul 8 0; Mul 8 1; Add 94 1; Add 95 1; Div 69 15; Mul 2 2; Mul 2 2;
  Add 1 0; Mul 3 3; Sub 1 0; Mul 0 67; Mul 43 8; Mul 40 8; Add 1 0; Add 0 38; Sub 4 0;
  ShowZero 0; (* as src/mesh/face_plane.rs finds *)
  Sub 117 134; Sub 116 133; Mul 128 59; Mul 128 61; Sub 1 0; Add 113 0; Mul 94 4; Mul 94 6;
  Sub 1 0; Add 3 0; Sub 121 144; Sub 120 143; Sub 25 120; Sub 25 121; Mul 13 0; Mul 13 2; Sub 1 0;
  Add 7 0; Mul 76 6; Mul 76 8; Sub 1 0; Add 3 0;
  ShowZero 0; (* 4 area(F, S) *)
  Sub 130 112; Sub 131 112; Mul 1 1; Mul 1 1; Add 1 0; Add 107 106; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching *)
  ShowZero 0; (* touching circles *)
  Sub 120 131; Sub 120 131; Mul 1 1; Mul 1 1; Add 1 0; Add 114 113; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching *)
  ShowZero 0; (* touching circles *)
  Sub 139 51; Sub 139 51; Mul 1 1; Mul 1 1; Add 1 0; Add 121 54; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching *)
  ShowZero 0; (* touching circles *)
  Mul 33 33; Mul 33 33; Add 1 0; Add 60 129; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching *)
  ShowZero 0; (* touching circles *)
  Mul 140 140; Mul 140 140; Add 1 0; Sub 123 130; Sub 1 0; Mul 115 115; Mul 115 115; Add 1 0;
  Sub 122 135; Sub 1 0; Sub 69 137; Sub 14 0; Mul 121 0; Mul 3 51; Sub 1 0; Mul 5 54; Mul 126 4;
  Sub 1 0; Mul 128 56; Mul 128 58; Sub 1 0; Mul 161 6; Mul 161 4; Add 1 0; Mul 19 3; Add 1 0;
  ShowZero 0; (* coplanar poles *)
  Sub 126 186; Sub 123 187; Mul 168 0; Mul 168 2; Sub 1 0; Div 0 55; Mul 0 56; Sub 2 0;
  ShowZero 0; (* distance from an edge *)
  Mul 2 2; Mul 8 8; Mul 8 8; Add 1 0; Sub 0 3; Sub 0 166;
  ShowZero 0; (* orthogonal *)
  Sub 193 182; Sub 193 182; Sub 142 184; Sub 139 184; Mul 3 0; Mul 3 2; Sub 1 0; Mul 15 63;
  Sub 1 0;
  ShowZero 0; (* distance from an edge *)
  Mul 6 6; Mul 6 6; Add 1 0; Sub 0 17; Sub 0 173;
  ShowZero 0; (* orthogonal *)
  Sub 119 207; Sub 119 207; Sub 156 209; Sub 153 209; Mul 3 0; Mul 3 2; Sub 1 0; Mul 29 69;
  Sub 1 0;
  ShowZero 0; (* distance from an edge *)
  Mul 6 6; Mul 6 6; Add 1 0; Sub 0 31; Sub 0 181;
  ShowZero 0; (* orthogonal *)
  Sub 228 133; Sub 229 133; Sub 170 135; Sub 167 135; Mul 3 0; Mul 3 2; Sub 1 0; Mul 43 77;
  Sub 1 0;
  ShowZero 0; (* distance from an edge *)
  Mul 6 6; Mul 6 6; Add 1 0; Sub 0 45; Sub 0 140;
  ShowZero 0 (* orthogonal *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
