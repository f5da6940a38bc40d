(** koebe-edge (Sec. 3.4)

    Two touching circles, with signed radii: the planes that cut Σ over them meet over their common
    tangent, in a line that touches Σ over the point of contact; and so does the line of their
    poles, along the centres.

        height over Σ along the tangent = -|x - t|²/2

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** two circles; size 1.
    Code: src/net/i_isothermic.rs, src/net/scribed.rs, src/scalar/ring.rs, src/space/duality.rs,
    src/space/gradient.rs, src/space/oriented_circle.rs, src/space/plane.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0; Unknown 1; Add 1 0;
  Nonzero 0; (* r₁ + r₂ != 0 *)
  Unknown 2; Unknown 3; Unknown 4; Unknown 5; Sub 3 1; Sub 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Mul 9 9; Sub 1 0;
  Zero 0; (* the circles touch, with their signs *)
  ShowZero 0; (* touching *)
  Mul 10 10; Mul 10 10; Add 1 0; Mul 16 16; Sub 1 0; Constant 1; Div 0 20; Mul 2 0; Mul 16 16;
  Mul 16 16; Add 1 0; Mul 23 23; Sub 1 0; Mul 0 6; Sub 22 24; Sub 22 24; Sub 2 8; Mul 27 2;
  Mul 27 2; Add 1 0; Mul 3 14; Sub 1 0; Mul 14 16; Sub 20 0; Sub 0 1; Mul 3 3; Mul 11 11;
  Mul 11 11; Add 1 0; Mul 0 4; Sub 4 0;
  ShowZero 0; (* the line of the poles touches Σ *)
  Div 44 42; Mul 17 0; Mul 17 1; Add 44 1; Add 44 1; Mul 4 19; Add 29 0; Mul 0 32; Add 0 0;
  Mul 5 5; Mul 5 5; Add 1 0; Sub 3 0;
  ShowZero 0; (* over the contact *)
  Unknown 6; Neg 29; Mul 0 1; Mul 32 2; Add 13 1; Add 13 1; Neg 42; Mul 61 2; Mul 61 2; Add 1 0;
  Add 0 3; Neg 41; Mul 64 7; Mul 64 7; Add 1 0; Add 0 3; Sub 5 0;
  ShowZero 0; (* the planes meet over the tangent *)
  Mul 6 55; Add 0 0; Mul 14 14; Mul 14 14; Add 1 0; Sub 3 0; Mul 20 20; Mul 20 20; Add 1 0; Neg 0;
  Sub 4 0;
  ShowZero 0; (* their line touches Σ *)
  Mul 82 37; Mul 82 37; Add 1 0; Add 0 24; Sub 41 27; Sub 41 27; Sub 2 23; Mul 30 2; Mul 30 2;
  Add 1 0; Mul 3 76; Sub 1 0; Sub 18 22; Sub 0 23; Mul 2 2; Mul 10 10; Mul 10 10; Add 1 0;
  Mul 0 4; Sub 4 0;
  ShowZero 0 (* their line as an edge *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
