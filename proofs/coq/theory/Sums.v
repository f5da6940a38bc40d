(** * Sums over polygons

    A polygon with k corners is a sequence v 0, v 1, ..., closed if v k = v 0, periodic if all of it
    repeats after k. [sum k f] is f 0 + ... + f (k - 1).

    - [sum_telescope], [sum_shift]: what closing is needed for;  [sum_alternating];
    - [cycle k v]: the periodic sequence of the corners v 0, ..., v (k - 1); [corners]: those of a list. *)

From Isogeo.theory Require Export Vector.
Require Export List PeanoNat.

Section Sums.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types f g : nat -> K.

Fixpoint sum (k : nat) f : K := match k with O => 0 | S n => sum n f + f n end.

Definition closed {A : Type} (k : nat) (v : nat -> A) := v k = v O.
Definition periodic {A : Type} (k : nat) (v : nat -> A) := forall j, v (j + k)%nat = v j.
Definition cycle {A : Type} (k : nat) (v : nat -> A) := fun j => v (j mod k).
Definition corners {A : Type} (l : list A) (default : A) := cycle (length l) (fun j => nth j l default).

Lemma periodic_closed {A : Type} k (v : nat -> A) : periodic k v -> closed k v.
Proof. intro H. exact (H O). Qed.

Lemma cycle_periodic {A : Type} k (v : nat -> A) : k <> O -> periodic k (cycle k v).
Proof.
  intros H j. unfold cycle. f_equal.
  rewrite <- (Nat.mul_1_l k) at 1. apply Nat.mod_add. exact H.
Qed.

Lemma sum_ext k f g : (forall j, (j < k)%nat -> f j = g j) -> sum k f = sum k g.
Proof.
  induction k as [ | k IH]; intro H; [reflexivity | ]. cbn [sum].
  rewrite IH; [rewrite H; [reflexivity | apply Nat.lt_succ_diag_r] | ].
  intros j L. apply H, Nat.lt_lt_succ_r, L.
Qed.

Lemma sum_equal k f g : (forall j, f j = g j) -> sum k f = sum k g.
Proof. intro H. apply sum_ext. intros. apply H. Qed.

Lemma sum_add k f g : sum k (fun j => f j + g j) = sum k f + sum k g.
Proof. induction k as [ | k IH]; cbn [sum]; [ring | rewrite IH; ring]. Qed.

Lemma sum_scale k (c : K) f : sum k (fun j => c * f j) = c * sum k f.
Proof. induction k as [ | k IH]; cbn [sum]; [ring | rewrite IH; ring]. Qed.

Lemma sum_telescope k f : sum k (fun j => f (S j) - f j) = f k - f O.
Proof. induction k as [ | k IH]; cbn [sum]; [ring | rewrite IH; ring]. Qed.

Lemma sum_first k f : sum (S k) f = f O + sum k (fun j => f (S j)).
Proof.
  induction k as [ | k IH]; [cbn; ring | ].
  change (sum (S (S k)) f) with (sum (S k) f + f (S k)). rewrite IH. cbn [sum]. ring.
Qed.

Lemma sum_shift k f : f k = f O -> sum k (fun j => f (S j)) = sum k f.
Proof.
  intro H. apply difference_zero.
  replace (sum k (fun j => f (S j)) - sum k f) with (f O + sum k (fun j => f (S j)) - (sum k f + f O))
    by ring.
  rewrite <- sum_first. cbn [sum]. rewrite H. ring.
Qed.

Lemma sum_zero k f : (forall j, f j = 0) -> sum k f = 0.
Proof. intro H. induction k as [ | k IH]; cbn [sum]; [ring | rewrite IH, H; ring]. Qed.

(** 1, -1, 1, -1, ... *)
Fixpoint sign (j : nat) : K := match j with O => 1 | S n => - sign n end.

Lemma sign_even n : sign (2 * n) = 1.
Proof.
  induction n as [ | n IH]; [reflexivity | ].
  rewrite Nat.mul_succ_r, Nat.add_comm. cbn [Nat.add sign]. rewrite IH. ring.
Qed.

Lemma sign_square j : sign j * sign j = 1.
Proof. induction j as [ | j IH]; cbn [sign]; [ring | ]. rewrite <- IH. ring. Qed.

Lemma sum_alternating k f : sum k (fun j => sign j * (f j + f (S j))) = f O - sign k * f k.
Proof. induction k as [ | k IH]; cbn [sum sign]; [ring | rewrite IH; ring]. Qed.

End Sums.
