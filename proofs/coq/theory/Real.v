(** * The real numbers as scalars

    For statements that speak of order or angles, and for counterexamples. The axioms used from here
    on are those by which the standard library of Coq makes the real numbers. *)

Require Export Reals Lra.
From Isogeo.theory Require Export Scalar Vector.

Lemma real_two : (1 + 1)%R <> 0%R.
Proof. lra. Qed.

Lemma real_decidable (x : R) : x = 0%R \/ x <> 0%R.
Proof. exact (Req_dec x 0). Qed.

Definition Reals : Scalar :=
  MakeScalar R 0%R 1%R Rplus Rmult Rminus Ropp Rdiv Rinv Rfield real_two real_decidable.

Canonical Reals.

(** Makes plain arithmetic of real numbers out of geometry over [Reals]. *)
Ltac real_in := coordinates; cbn [carrier zero one add mul sub opp div inv Reals vx vy] in *.
Ltac real := real_in; try lra.
