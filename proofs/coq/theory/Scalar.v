(** * Scalars

    A field in which 2 is not 0 and of any element one can say whether it is 0.
    Whatever needs no order is proved for every such field: the reals, the rationals, the fields that
    the library computes in. Nothing here or built on it alone uses an axiom.

    - [Scalar]: the field;  [Reals]: the real numbers as one (in Real.v).
    - [scalar], [nonzero]: tactics, [field] with the known non-zero elements. *)

Require Export Ring Field.
Require Import NsatzTactic.

Record Scalar := MakeScalar {
  carrier :> Type;
  zero : carrier;
  one : carrier;
  add : carrier -> carrier -> carrier;
  mul : carrier -> carrier -> carrier;
  sub : carrier -> carrier -> carrier;
  opp : carrier -> carrier;
  div : carrier -> carrier -> carrier;
  inv : carrier -> carrier;
  laws : field_theory zero one add mul sub opp div inv (@eq carrier);
  two_nonzero : add one one <> zero;
  decidable : forall x : carrier, x = zero \/ x <> zero
}.

Arguments zero {s}.
Arguments one {s}.
Arguments add {s}.
Arguments mul {s}.
Arguments sub {s}.
Arguments opp {s}.
Arguments div {s}.
Arguments inv {s}.

Declare Scope scalar_scope.
Delimit Scope scalar_scope with K.
Bind Scope scalar_scope with carrier.
Notation "0" := zero : scalar_scope.
Notation "1" := one : scalar_scope.
Notation "2" := (add one one) : scalar_scope.
Notation "3" := (add (add one one) one) : scalar_scope.
Notation "4" := (mul (add one one) (add one one)) : scalar_scope.
Notation "x + y" := (add x y) : scalar_scope.
Notation "x * y" := (mul x y) : scalar_scope.
Notation "x - y" := (sub x y) : scalar_scope.
Notation "- x" := (opp x) : scalar_scope.
Notation "x / y" := (div x y) : scalar_scope.
Notation "x ²" := (mul x x) (at level 1, format "x ²") : scalar_scope.
Open Scope scalar_scope.

Section Laws.
Variable K : Scalar.
Add Field scalars : (laws K).

Lemma one_nonzero : (1 : K) <> 0.
Proof. exact (F_1_neq_0 (laws K)). Qed.

Lemma cancel (a x : K) : a <> 0 -> a * x = 0 -> x = 0.
Proof. intros H E. replace x with (a * x / a) by (field; exact H). rewrite E. field. exact H. Qed.

Lemma product_zero (x y : K) : x * y = 0 -> x = 0 \/ y = 0.
Proof.
  intro E. destruct (decidable K x) as [H | H]; [left; exact H | right].
  exact (cancel x y H E).
Qed.

Lemma product_nonzero (x y : K) : x <> 0 -> y <> 0 -> x * y <> 0.
Proof. intros H G E. exact (G (cancel x y H E)). Qed.

Lemma quotient_zero (a b : K) : b <> 0 -> (a / b = 0 <-> a = 0).
Proof.
  intro H. split; intro E.
  - replace a with (b * (a / b)) by (field; exact H). rewrite E. ring.
  - rewrite E. field. exact H.
Qed.

Lemma difference_zero (a b : K) : a - b = 0 <-> a = b.
Proof.
  split; intro E.
  - replace a with (a - b + b) by ring. rewrite E. ring.
  - rewrite E. ring.
Qed.

Lemma opposite_zero (a : K) : - a = 0 <-> a = 0.
Proof.
  split; intro E.
  - replace a with (- - a) by ring. rewrite E. ring.
  - rewrite E. ring.
Qed.

Lemma equals_by (a x y : K) : a <> 0 -> a * x = a * y -> x = y.
Proof.
  intros H E. apply difference_zero, (cancel a); [exact H | ].
  replace (a * (x - y)) with (a * x - a * y) by ring. rewrite E. ring.
Qed.

(** What [nsatz] asks for. *)
Global Instance scalar_ops : @Ring_ops K 0 1 add mul sub opp eq := {}.
Global Instance scalar_ring : Ring (Ro := scalar_ops).
Proof.
  constructor; try exact _; intros; cbv [equality eq_notation addition add_notation
    multiplication mul_notation subtraction sub_notation opposite opp_notation
    Algebra_syntax.zero zero_notation Algebra_syntax.one one_notation]; ring.
Qed.
Global Instance scalar_cring : Cring (Rr := scalar_ring).
Proof. intros x y. change (x * y = y * x). ring. Qed.
Global Instance scalar_domain : Integral_domain (Rcr := scalar_cring).
Proof. constructor; [exact product_zero | exact one_nonzero]. Qed.

End Laws.

(** Closes goals [a <> 0] and conjunctions of them. *)
Ltac nonzero :=
  repeat split; try assumption; try apply two_nonzero; try apply one_nonzero;
  repeat apply product_nonzero; try assumption; try apply two_nonzero; try apply one_nonzero.

(** Polynomial equations from polynomial equations. *)
Ltac eliminate := nsatz.
