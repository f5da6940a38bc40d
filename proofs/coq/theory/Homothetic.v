(** * Equality in Minkowski's inequality

    Statements
    - [minkowski_homothetic]: parallel quads with a pair of parallel corresponding diagonals are
      homothetic, so by [minkowski_equality] and [minkowski_reflex] convex quads with H² = K are, and
      quads with a reflex corner have H² < K unless they are;
    - [minkowski_homothetic_equality]: homothetic quads have H² = K.

    No corner of F is straight. *)

From Isogeo.theory Require Export Minkowski.

Section Homothetic.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types v w : nat -> vec K.

Theorem minkowski_homothetic v w :
  closed 4 v -> closed 4 w -> parallel_quads v w -> proper v ->
  parallel (v 2%nat - v 0%nat) (w 2%nat - w 0%nat) ->
  exists c t, forall j, (j <= 4)%nat -> w j = (c ** v j + t)%V.
Proof.
  intros Cv Cw P D Z. destruct (multiples_exist v w D P) as [l L].
  assert (L0 := L 0%nat ltac:(repeat constructor)). assert (L1 := L 1%nat ltac:(repeat constructor)).
  assert (L2 := L 2%nat ltac:(repeat constructor)). assert (L3 := L 3%nat ltac:(repeat constructor)).
  destruct D as (D0 & D1 & D2 & D3). cbn zeta in *. rewrite Cv in *. rewrite Cw in *.
  set (e0 := (v 1%nat - v 0%nat)%V) in *. set (e1 := (v 2%nat - v 1%nat)%V) in *.
  set (e2 := (v 3%nat - v 2%nat)%V) in *. set (e3 := (v 0%nat - v 3%nat)%V) in *.
  assert (E3 : e3 = (- (e0 + e1 + e2))%V) by (apply vec_eq; unfold e0, e1, e2, e3; coordinates; ring).
  assert (Q : l 1%nat - l 0%nat = 0).
  { apply (cancel K (det e0 e1)); [exact D0 | ]. rewrite <- Z.
    transitivity (det (e0 + e1) (l 0%nat ** e0 + l 1%nat ** e1)); [coordinates; ring | ].
    rewrite <- L0, <- L1. unfold e0, e1. coordinates. ring. }
  assert (Y : (l 0%nat ** e0 + l 1%nat ** e1 + (l 2%nat ** e2 + l 3%nat ** e3))%V = null).
  { rewrite <- L0, <- L1, <- L2, <- L3. apply vec_eq; coordinates; ring. }
  apply (proj1 (difference_zero K _ _)) in Q. rewrite Q in Y.
  assert (T : l 3%nat = l 0%nat).
  { symmetry. apply difference_zero, (cancel K (det e2 e3)); [exact D2 | ].
    transitivity (det (l 0%nat ** e0 + l 0%nat ** e1 + (l 2%nat ** e2 + l 3%nat ** e3)) e2).
    - rewrite E3. coordinates. ring.
    - rewrite Y. coordinates. ring. }
  assert (U : l 2%nat = l 0%nat).
  { apply difference_zero. apply (scale_zero _ e2).
    - intro O. apply D1. rewrite O. coordinates. ring.
    - rewrite <- Y, T, E3. apply vec_eq; coordinates; ring. }
  assert (A : forall j, (j < 4)%nat -> (w (S j) - w j)%V = (l 0%nat ** (v (S j) - v j))%V).
  { intros j Lj. rewrite (L j Lj).
    destruct j as [ | [ | [ | [ | j]]]]; [ | rewrite Q | rewrite U | rewrite T | ]; try reflexivity.
    exfalso. do 4 apply Nat.succ_lt_mono in Lj. exact (Nat.nlt_0_r j Lj). }
  exists (l 0%nat), (w 0%nat - l 0%nat ** v 0%nat)%V.
  induction j as [ | j IH]; intro Lj.
  - apply vec_eq; coordinates; ring.
  - specialize (IH (Nat.lt_le_incl _ _ Lj)).
    transitivity ((w (S j) - w j) + w j)%V; [apply vec_eq; coordinates; ring | ].
    rewrite (A j Lj), IH. apply vec_eq; coordinates; ring.
Qed.

Theorem minkowski_homothetic_equality k v (c : K) (t : vec K) :
  closed k v ->
  let w j := (c ** v j + t)%V in
  (mixed k v w)² = area k v * area k w.
Proof.
  intros C w.
  assert (M : forall u : nat -> vec K, closed k u -> mixed k u w = c * mixed k u v).
  { intros u U. transitivity (mixed k (fun j => (c ** v j + t)%V) u); [apply eq_15_16_symmetric | ].
    rewrite eq_15_16_translation by exact U. rewrite eq_15_16_symmetric.
    transitivity (mixed k u (offset c (fun _ => null) v)).
    - unfold mixed. f_equal. apply sum_equal. intro j. unfold offset. coordinates. ring.
    - rewrite eq_15_16_linear. unfold mixed at 1. rewrite sum_zero; [ring | ].
      intro j. coordinates. ring. }
  assert (W : closed k w) by (unfold closed, w; rewrite C; reflexivity).
  rewrite <- (eq_15_16_diagonal k w), (M w W), (M v C), (eq_15_16_symmetric k w v), (M v C), eq_15_16_diagonal.
  ring.
Qed.

End Homothetic.
