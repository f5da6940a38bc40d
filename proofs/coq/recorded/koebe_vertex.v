(** koebe-vertex (Sec. 3.4)

    The planes of circles meet in a point v iff their poles are coplanar, that is, iff a circle
    orthogonal to all exists; its centre is v', its squared radius |v'|² - 2 v₃. Circles that touch
    in a cycle of four have concyclic contacts; that does not suffice.

        ρ² = |v'|² - 2 v₃

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** four circles; size 1.
    Code: src/net/i_isothermic.rs, src/scalar/ring.rs, src/space/circle.rs, src/space/duality.rs,
    src/space/gradient.rs, src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 5; Sub 3 5; Sub 3 7;
  Sub 3 7; Mul 3 0; Mul 3 2; Sub 1 0;
  Nonzero 0; (* the centres are not collinear *)
  Unknown 6; Unknown 7; Unknown 8; Mul 15 15; Mul 15 15; Add 1 0; Mul 5 5; Sub 1 0; Constant 1;
  Div 0 22; Mul 2 0; Mul 21 21; Mul 21 21; Add 1 0; Mul 12 12; Sub 1 0; Mul 0 6; Mul 25 25;
  Mul 25 25; Add 1 0; Mul 17 17; Sub 1 0; Mul 0 12; Sub 6 12; Sub 1 13; Div 16 25; Mul 2 29;
  Mul 32 2; Sub 1 0; Mul 0 3; Mul 36 5; Mul 7 35; Sub 1 0; Mul 0 7; Mul 4 46; Mul 1 46; Add 1 0;
  Sub 26 0; Neg 0; Neg 28; Mul 52 10; Mul 52 7; Add 1 0; Add 0 3; Sub 5 0;
  ShowZero 0; (* in the plane of a circle *)
  Neg 28; Mul 56 16; Mul 56 13; Add 1 0; Add 0 3; Sub 11 0;
  ShowZero 0; (* in the plane of a circle *)
  Neg 28; Mul 60 22; Mul 60 19; Add 1 0; Add 0 3; Sub 17 0;
  ShowZero 0; (* in the plane of a circle *)
  Mul 27 27; Mul 24 24; Add 1 0; Mul 73 21; Sub 1 0; Sub 32 74; Sub 29 74; Mul 1 1; Mul 1 1;
  Add 1 0; Sub 0 5; Sub 0 61;
  ShowZero 0; (* orthogonal *)
  Sub 39 79; Sub 36 79; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 12; Sub 0 60;
  ShowZero 0; (* orthogonal *)
  Sub 46 84; Sub 43 84; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 19; Sub 0 61;
  ShowZero 0; (* orthogonal *)
  Unknown 9; Unknown 10; Unknown 11; Mul 2 2; Mul 2 2; Add 1 0; Mul 3 3; Sub 1 0; Mul 0 81; Neg 0;
  Mul 9 63; Mul 9 60; Add 1 0; Add 0 3; Sub 58 0; Sub 68 14; Sub 65 14; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 0 41; Sub 0 14; Mul 118 7; Sub 0 1;
  ShowZero 0; (* the fourth plane *)
  Mul 113 113; Mul 113 113; Add 1 0; Sub 95 103; Sub 1 0; Mul 116 116; Mul 116 116; Add 1 0;
  Sub 94 108; Sub 1 0; Sub 33 129; Sub 33 129; Mul 1 1; Mul 1 1; Add 1 0; Sub 32 115; Sub 1 0;
  Mul 127 0; Mul 8 6; Sub 1 0; Mul 10 9; Mul 132 4; Sub 1 0; Mul 134 11; Mul 134 13; Sub 1 0;
  Mul 139 6; Mul 139 4; Add 1 0; Mul 24 3; Add 1 0; Mul 33 138; Sub 1 0;
  ShowZero 0; (* four poles *)
  Constant 0; Sub 153 111; Sub 153 108; Mul 1 1; Mul 1 1; Add 1 0; Sub 0 139; Mul 6 6; Sub 1 0;
  Sub 0 87;
  ShowZero 0 (* by the pair *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.

(** a cycle of four; size 1.
    Code: src/scalar/ring.rs, src/space/motion.rs, src/space/oriented_circle.rs, src/space/point.rs *)
Definition part_2_size_1 : list step := [
  Unknown 0; Constant 1; Mul 1 1; Add 1 0;
  Nonzero 0; (* a direction *)
  Unknown 1; Mul 0 0; Add 4 0;
  Nonzero 0; (* a direction *)
  Unknown 2; Unknown 3; Unknown 4; Div 8 6; Sub 9 8; Mul 0 1; Constant 2; Mul 13 0; Mul 0 4;
  Div 14 9; Sub 15 11; Mul 0 1; Mul 14 5; Mul 0 3; Add 13 12; Constant 0; Add 15 13; Mul 11 0;
  Mul 9 1; Add 3 1; Add 4 1; Sub 6 1; Sub 6 1; Mul 11 21; Mul 10 22; Add 3 1; Add 3 1; Mul 1 15;
  Mul 1 14; Add 1 0; Sub 0 27; Mul 0 24;
  Nonzero 0; (* the fourth circle is no line *)
  Nonzero 17; (* r₁ + r₂ is not 0 *)
  Mul 29 29; Mul 7 7; Mul 7 7; Add 1 0; Sub 3 0; Div 0 5; Add 36 0;
  Nonzero 0; (* r₁ + r₂ is not 0 *)
  Add 1 36;
  Nonzero 0; (* r₁ + r₂ is not 0 *)
  Sub 24 25; Sub 25 25; Mul 1 1; Mul 1 1; Add 1 0; Mul 30 30; Sub 1 0;
  ShowZero 0; (* touching *)
  Mul 35 8; Mul 34 9; Add 34 1; Add 34 1; Sub 36 1; Sub 36 1; Mul 1 1; Mul 1 1; Add 1 0;
  Mul 17 17; Sub 1 0;
  ShowZero 0; (* touching *)
  Sub 8 38; Sub 8 38; Mul 1 1; Mul 1 1; Add 1 0; Mul 23 23; Sub 1 0;
  ShowZero 0; (* touching *)
  Sub 45 49; Sub 45 50; Mul 1 1; Mul 1 1; Add 1 0; Add 67 69; Mul 0 0; Sub 2 0;
  ShowZero 0; (* touching *)
  Div 72 58; Sub 59 58; Mul 0 1; Mul 34 2; Add 61 1; Add 62 1; Div 77 40; Sub 30 65; Sub 30 65;
  Mul 1 2; Mul 1 3; Add 69 1; Add 69 1; Div 48 46; Sub 67 37; Sub 67 37; Mul 1 2; Mul 1 3;
  Add 41 1; Add 41 1; Div 90 22; Sub 78 74; Mul 0 1; Mul 73 2; Add 77 1; Add 77 1; Sub 14 21;
  Sub 14 21; Sub 9 23; Sub 9 23; Sub 5 25; Sub 5 25; Mul 5 5; Mul 5 5; Add 1 0; Mul 6 6; Mul 6 6;
  Add 1 0; Mul 7 7; Mul 7 7; Add 1 0; Mul 9 3; Mul 1 12; Sub 1 0; Mul 3 15; Mul 14 7; Sub 1 0;
  Mul 16 17; Mul 16 19; Sub 1 0; Mul 23 6; Mul 23 4; Add 1 0; Mul 18 3; Add 1 0;
  ShowZero 0 (* the contacts are concyclic *)
].

Theorem part_2_size_1_valid : valid part_2_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
