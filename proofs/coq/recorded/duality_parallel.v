(** duality-parallel (Sec. 2.1, metric duality)

    Points are parallel iff their polar planes are.

        p' = q' ⇔ ∇p* = ∇q*

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** differences; size 1.
    Code: src/space/gradient.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Sub 1 0; Sub 0 0;
  ShowZero 0; (* gradients *)
  Unknown 2; Unknown 3; Sub 1 0; Sub 0 0;
  ShowZero 0; (* gradients *)
  Unknown 4; Unknown 5; Sub 1 0; Sub 0 0;
  ShowZero 0; (* top views *)
  Unknown 6; Unknown 7; Sub 1 0; Sub 0 0;
  ShowZero 0; (* top views *)
  Sub 15 15; Sub 12 12; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0; (* parallel points *)
  Sub 12 12; Sub 9 9; Mul 1 1; Mul 1 1; Add 1 0;
  ShowZero 0 (* parallel planes *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
