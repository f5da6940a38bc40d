(** duality-metric (Sec. 2.1, metric duality)

    The i-distance of points is the i-angle of their polar planes, and conversely.

        |p − q|ᵢ² = ∠ᵢ(p*, q* )²

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** squares of both; size 1.
    Code: src/space/gradient.rs, src/space/point.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0; Unknown 1; Unknown 2; Unknown 3; Sub 3 1; Sub 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 0 0;
  ShowZero 0; (* points *)
  Unknown 4; Unknown 5; Unknown 6; Unknown 7; Sub 3 1; Sub 3 1; Mul 1 1; Mul 1 1; Add 1 0;
  Sub 0 0;
  ShowZero 0 (* planes *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
