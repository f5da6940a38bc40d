(** cgc-offset (Sec. 4, after (18))

    A mesh of constant mean curvature H has an offset of constant curvature 4H².

        d = -1/(2H):  K(Fᵈ) = 4H²

    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.

(** K of the offset at d = -1/(2H); size 1.
    Code: src/pair/curvature.rs *)
Definition part_1_size_1 : list step := [
  Constant 2;
  Nonzero 0; (* 2 != 0 in the field *)
  Unknown 0;
  Nonzero 0; (* H != 0 *)
  Unknown 1;
  Nonzero 0; (* K != 0 *)
  Constant (-2); Mul 0 2; Constant 1; Div 0 1; Mul 0 4; Add 6 0; Add 7 0; Mul 3 0; Add 5 0;
  Div 6 0; Mul 10 0; Constant 4; Mul 13 13; Mul 1 0; Sub 3 0;
  ShowZero 0 (* K(Fᵈ) = 4H² *)
].

Theorem part_1_size_1_valid : valid part_1_size_1.
Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.
