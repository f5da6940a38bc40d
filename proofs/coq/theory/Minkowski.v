(** * Principal curvatures of faces

    H² - K >= 0 for parallel quads, F convex; the exact discriminant over any field, and its sign over the
    real numbers.

    - [corner_det v j]: the determinant of the sides that meet at the corner j + 1;
    - [convex v]: all four have one sign;  [reflex v]: exactly one or three have another sign.

    Statements
    - [minkowski_exact]: 4 (area (F, S)² - area F area S) D01 D23 = det (d, d')² D12 D30, d and d'
      corresponding diagonals;
    - [minkowski]: H² >= K for convex F;  [minkowski_combination]: or if v + d w is convex;
    - [minkowski_equality]: H² = K only if diagonals are parallel;
    - [minkowski_reflex]: H² < K for every quad with a reflex corner unless diagonals are parallel;
      a dart is in Counterexamples.v, as is a pair that is not parallel.

    Unsaid in the paper: "any linear combination is convex" must be read as "some". Quads only. *)

From Isogeo.theory Require Export Real Quads ChristoffelQuads.

Section Exact.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types v w : nat -> vec K.

Definition corner_det v (j : nat) : K :=
  match j with
  | 3%nat => det (v 4%nat - v 3%nat) (v 1%nat - v 0%nat)
  | _ => det (v (S j) - v j) (v (S (S j)) - v (S j))
  end.

Definition discriminant v w : K := (mixed 4 v w)² - area 4 v * area 4 w.

Theorem minkowski_exact v w :
  closed 4 v -> closed 4 w -> parallel_quads v w ->
  corner_det v 0 <> 0 -> corner_det v 1 <> 0 -> corner_det v 2 <> 0 -> corner_det v 3 <> 0 ->
  4 * discriminant v w * corner_det v 0 * corner_det v 2 =
  (det (v 2%nat - v 0%nat) (w 2%nat - w 0%nat))² * corner_det v 1 * corner_det v 3.
Proof.
  intros C D P N0 N1 N2 N3. unfold corner_det in *.
  destruct (multiples_exist v w) as [l L]; [unfold proper; tauto | exact P | ].
  assert (L0 := L 0%nat ltac:(repeat constructor)). assert (L1 := L 1%nat ltac:(repeat constructor)).
  assert (L2 := L 2%nat ltac:(repeat constructor)). assert (L3 := L 3%nat ltac:(repeat constructor)).
  assert (M := eq_20_one_diagonal v w C D P).
  assert (A : 2 * area 4 v = det (v 2%nat - v 0%nat) (v 3%nat - v 1%nat)).
  { unfold area. cbn [sum]. rewrite C. coordinates. field. nonzero. }
  assert (B : 2 * area 4 w = det (w 2%nat - w 0%nat) (w 3%nat - w 1%nat)).
  { unfold area. cbn [sum]. rewrite D. coordinates. field. nonzero. }
  rewrite C in *. rewrite D in *. clear L P C D.
  set (e0 := (v 1%nat - v 0%nat)%V) in *. set (e1 := (v 2%nat - v 1%nat)%V) in *.
  set (e2 := (v 3%nat - v 2%nat)%V) in *.
  assert (E3 : (v 0%nat - v 3%nat = - (e0 + e1 + e2))%V) by (apply vec_eq; unfold e0, e1, e2; coordinates; ring).
  assert (V02 : (v 2%nat - v 0%nat = e0 + e1)%V) by (apply vec_eq; unfold e0, e1; coordinates; ring).
  assert (V13 : (v 3%nat - v 1%nat = e1 + e2)%V) by (apply vec_eq; unfold e1, e2; coordinates; ring).
  assert (W02 : (w 2%nat - w 0%nat = l 0%nat ** e0 + l 1%nat ** e1)%V)
    by (rewrite <- L0, <- L1; apply vec_eq; coordinates; ring).
  assert (W13 : (w 3%nat - w 1%nat = l 1%nat ** e1 + l 2%nat ** e2)%V)
    by (rewrite <- L1, <- L2; apply vec_eq; coordinates; ring).
  assert (Z : ((l 0%nat ** e0 + l 1%nat ** e1) + (l 2%nat ** e2 - l 3%nat ** (e0 + e1 + e2)))%V = null).
  { transitivity ((w 1%nat - w 0%nat) + (w 2%nat - w 1%nat) + ((w 3%nat - w 2%nat) + (w 0%nat - w 3%nat)))%V.
    - rewrite L0, L1, L2, L3, E3. apply vec_eq; coordinates; ring.
    - apply vec_eq; coordinates; ring. }
  rewrite E3, V02, V13, W02, W13 in *. unfold discriminant.
  set (m := mixed 4 v w) in *. set (a := area 4 v) in *. set (b := area 4 w) in *.
  clearbody m a b e0 e1 e2. clear L0 L1 L2 L3 E3 V02 V13 W02 W13.
  generalize dependent (l 0%nat). intros l0 W0 Z. set (l1 := l 1%nat) in *. set (l2 := l 2%nat) in *.
  set (l3 := l 3%nat) in *. clearbody l1 l2 l3. clear l v w.
  set (d01 := det e0 e1) in *. set (d02 := det e0 e2). set (d12 := det e1 e2) in *.
  assert (Z0 : (l0 - l3) * d01 = (l2 - l3) * d12).
  { apply difference_zero. transitivity (det ((l0 ** e0 + l1 ** e1) + (l2 ** e2 - l3 ** (e0 + e1 + e2))) e1).
    - unfold d01, d12. coordinates. ring.
    - rewrite Z. coordinates. ring. }
  assert (Z1 : (l1 - l3) * d01 = - ((l2 - l3) * d02)).
  { apply difference_zero. transitivity (det e0 ((l0 ** e0 + l1 ** e1) + (l2 ** e2 - l3 ** (e0 + e1 + e2)))).
    - unfold d01, d02. coordinates. ring.
    - rewrite Z. coordinates. ring. }
  assert (D23 : det e2 (- (e0 + e1 + e2)) = d02 + d12) by (unfold d02, d12; coordinates; ring).
  assert (D30 : det (- (e0 + e1 + e2)) e0 = d01 + d02) by (unfold d01, d02; coordinates; ring).
  rewrite D23, D30 in *.
  assert (A' : a = (d01 + d02 + d12) / 2).
  { apply (equals_by K 2); [nonzero | ]. rewrite A. unfold d01, d02, d12. coordinates. field. nonzero. }
  assert (M' : m = (l1 * d01 + l2 * (d02 + d12)) / 2).
  { apply (equals_by K 2); [nonzero | ]. rewrite M. unfold d01, d02, d12. coordinates. field. nonzero. }
  assert (B' : b = (l0 * l1 * d01 + l0 * l2 * d02 + l1 * l2 * d12) / 2).
  { apply (equals_by K 2); [nonzero | ]. rewrite W0. unfold d01, d02, d12. coordinates. field. nonzero. }
  assert (X : det (e0 + e1) (l0 ** e0 + l1 ** e1) = (l1 - l0) * d01) by (unfold d01; coordinates; ring).
  rewrite X, A', M', B'.
  clearbody d01 d02 d12. clear A M W0 Z X D23 D30 A' M' B' e0 e1 e2 m a b.
  assert (E0 : l0 = l3 + (l2 - l3) * d12 / d01).
  { apply (equals_by K d01); [exact N0 | ].
    transitivity ((l0 - l3) * d01 + l3 * d01); [ring | rewrite Z0; field; exact N0]. }
  assert (E1 : l1 = l3 - (l2 - l3) * d02 / d01).
  { apply (equals_by K d01); [exact N0 | ].
    transitivity ((l1 - l3) * d01 + l3 * d01); [ring | rewrite Z1; field; exact N0]. }
  rewrite E0, E1. field. nonzero.
Qed.

(** The discriminant of combinations. *)
Theorem minkowski_offset v w (d : K) : discriminant (offset d v w) w = discriminant v w.
Proof. unfold discriminant. rewrite offset_mixed, eq_15_16_form. ring. Qed.

Lemma discriminant_curvatures v w :
  area 4 v <> 0 -> (mean 4 v w)² - gauss 4 v w = discriminant v w / (area 4 v)².
Proof. intro N. unfold mean, gauss, discriminant. field. exact N. Qed.

Lemma combination_parallel v w (d : K) : parallel_quads v w -> parallel_quads (offset d v w) w.
Proof.
  intros P j L. specialize (P j L). unfold offset. unfold parallel in *. rewrite <- P.
  coordinates. ring.
Qed.

End Exact.

(** ** Signs *)

Local Open Scope R_scope.
Implicit Types v w : nat -> vec Reals.

Definition convex v :=
  (0 < corner_det v 0 /\ 0 < corner_det v 1 /\ 0 < corner_det v 2 /\ 0 < corner_det v 3) \/
  (corner_det v 0 < 0 /\ corner_det v 1 < 0 /\ corner_det v 2 < 0 /\ corner_det v 3 < 0).

Definition reflex v := corner_det v 0 * corner_det v 1 * (corner_det v 2 * corner_det v 3) < 0.

Lemma square_positive (x : R) : x <> 0 -> 0 < x * x.
Proof. intro N. destruct (Rtotal_order x 0) as [L | [E | L]]; [ | contradiction | ]; nra. Qed.

Lemma discriminant_sign (x a b c d t : R) :
  4 * x * a * c = t * t * b * d -> 0 < a * c -> 0 < b * d -> 0 <= x /\ (x = 0 -> t = 0).
Proof.
  intros E A B.
  assert (E' : x * (4 * (a * c)) = t * t * (b * d)) by lra. clear E.
  set (p := a * c) in *. set (q := b * d) in *. clearbody p q.
  assert (F : x = t * t * q / (4 * p)) by (rewrite <- E'; field; lra).
  split.
  - rewrite F. apply Rmult_le_pos.
    + apply Rmult_le_pos; [apply Rle_0_sqr | lra].
    + apply Rlt_le, Rinv_0_lt_compat. lra.
  - intros ->. destruct (Req_dec t 0) as [Z | N]; [exact Z | ].
    assert (T := square_positive t N). assert (G := Rmult_lt_0_compat _ _ T B). lra.
Qed.

Lemma discriminant_reflex (x a b c d t : R) :
  4 * x * a * c = t * t * b * d -> a * b * (c * d) < 0 -> t <> 0 -> x < 0.
Proof.
  intros E N T. assert (P := square_positive t T).
  assert (A : a * c <> 0).
  { intro Z. replace (a * b * (c * d)) with (a * c * (b * d)) in N by ring. rewrite Z in N. lra. }
  assert (Q := square_positive _ A).
  assert (F : 4 * x * (a * c * (a * c)) = t * t * (a * b * (c * d))).
  { transitivity ((4 * x * a * c) * (a * c)); [ring | rewrite E; ring]. }
  assert (G : 0 < t * t * - (a * b * (c * d))) by (apply Rmult_lt_0_compat; lra).
  destruct (Rlt_or_le x 0) as [L | L]; [exact L | ]. exfalso.
  assert (M : 0 <= x * (a * c * (a * c))) by (apply Rmult_le_pos; [exact L | lra]). lra.
Qed.

Lemma convex_nonzero v : convex v ->
  corner_det v 0 <> 0 /\ corner_det v 1 <> 0 /\ corner_det v 2 <> 0 /\ corner_det v 3 <> 0 /\
  0 < corner_det v 0 * corner_det v 2 /\ 0 < corner_det v 1 * corner_det v 3.
Proof.
  unfold convex. generalize (corner_det v 0) (corner_det v 1) (corner_det v 2) (corner_det v 3).
  intros a b c d. cbn [carrier Reals] in *. intro H. repeat split; destruct H as [H | H]; try lra; nra.
Qed.

Lemma minkowski_discriminant v w :
  closed 4 v -> closed 4 w -> parallel_quads v w -> convex v ->
  0 <= discriminant v w /\
  (discriminant v w = 0 -> parallel (v 2%nat - v 0%nat) (w 2%nat - w 0%nat)).
Proof.
  intros C D P H. destruct (convex_nonzero v H) as (N0 & N1 & N2 & N3 & A & B).
  exact (discriminant_sign _ _ _ _ _ _ (minkowski_exact v w C D P N0 N1 N2 N3) A B).
Qed.

Theorem minkowski v w :
  closed 4 v -> closed 4 w -> parallel_quads v w -> convex v -> area 4 v <> 0 ->
  gauss 4 v w <= mean 4 v w * mean 4 v w.
Proof.
  intros C D P H N. destruct (minkowski_discriminant v w C D P H) as [G _].
  assert (E := discriminant_curvatures v w N). cbn in E, G |- *.
  assert (Q := square_positive _ N). cbn in Q.
  assert (F : 0 <= discriminant v w / (area 4 v * area 4 v)).
  { apply Rmult_le_pos; [exact G | apply Rlt_le, Rinv_0_lt_compat, Q]. }
  cbn in F. lra.
Qed.

Theorem minkowski_equality v w :
  closed 4 v -> closed 4 w -> parallel_quads v w -> convex v -> area 4 v <> 0 ->
  gauss 4 v w = mean 4 v w * mean 4 v w -> parallel (v 2%nat - v 0%nat) (w 2%nat - w 0%nat).
Proof.
  intros C D P H N Z. destruct (minkowski_discriminant v w C D P H) as [_ G]. apply G.
  assert (E := discriminant_curvatures v w N).
  apply (quotient_zero Reals (discriminant v w) (mul (area 4 v) (area 4 v))).
  - exact (product_nonzero Reals _ _ N N).
  - rewrite <- E, Z. cbn. lra.
Qed.

Theorem minkowski_combination v w (d : R) :
  closed 4 v -> closed 4 w -> parallel_quads v w -> convex (offset (d : Reals) v w) -> area 4 v <> 0 ->
  gauss 4 v w <= mean 4 v w * mean 4 v w.
Proof.
  intros C D P H N.
  assert (C' : closed 4 (offset (d : Reals) v w)) by (unfold closed, offset; rewrite C, D; reflexivity).
  destruct (minkowski_discriminant _ w C' D (combination_parallel v w (d : Reals) P) H) as [G _].
  rewrite minkowski_offset in G.
  assert (E := discriminant_curvatures v w N). cbn in E, G |- *.
  assert (Q := square_positive _ N). cbn in Q.
  assert (F : 0 <= discriminant v w / (area 4 v * area 4 v)).
  { apply Rmult_le_pos; [exact G | apply Rlt_le, Rinv_0_lt_compat, Q]. }
  cbn in F. lra.
Qed.

Theorem minkowski_reflex v w :
  closed 4 v -> closed 4 w -> parallel_quads v w -> reflex v -> area 4 v <> 0 ->
  ~ parallel (v 2%nat - v 0%nat) (w 2%nat - w 0%nat) ->
  mean 4 v w * mean 4 v w < gauss 4 v w.
Proof.
  intros C D P H N T.
  assert (A : corner_det v 0 <> 0 /\ corner_det v 1 <> 0 /\ corner_det v 2 <> 0 /\ corner_det v 3 <> 0).
  { unfold reflex in H. revert H.
    generalize (corner_det v 0) (corner_det v 1) (corner_det v 2) (corner_det v 3). cbn.
    intros a b c d H. repeat split; intros ->; lra. }
  destruct A as (N0 & N1 & N2 & N3).
  assert (G := discriminant_reflex _ _ _ _ _ _ (minkowski_exact v w C D P N0 N1 N2 N3) H T).
  assert (E := discriminant_curvatures v w N). cbn in E, G |- *.
  assert (Q := square_positive _ N). cbn in Q.
  assert (F : discriminant v w / (area 4 v * area 4 v) < 0).
  { apply Ropp_lt_cancel. rewrite Ropp_0. unfold Rdiv. rewrite Ropp_mult_distr_l.
    apply Rmult_lt_0_compat; [exact (Ropp_0_gt_lt_contravar _ G) | apply Rinv_0_lt_compat, Q]. }
  cbn in F. lra.
Qed.
