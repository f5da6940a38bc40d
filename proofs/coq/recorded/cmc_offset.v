(** cmc-offset (Sec. 4, after (18))

    A mesh of constant mean curvature H has an offset of constant mean curvature -H.

        d = -1/H:  H(Fᵈ) = -H

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** H of the offset at d = -1/H; size 1.
    Code: src/pair/curvature.rs *)
Definition part_1_size_1 : list step := [
  Unknown 0;
  Nonzero 0; (* H != 0 *)
  Unknown 1; Mul 1 1; Sub 0 1;
  Nonzero 0; (* K != H² *)
  Neg 3; Constant 1; Div 0 1; Mul 0 5; Add 7 0; Add 8 0; Mul 3 0; Add 5 0; Div 6 0; Mul 4 0;
  Add 0 13;
  ShowZero 0 (* H(Fᵈ) + H *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
