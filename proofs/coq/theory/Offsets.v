(** * Areas, curvatures of faces, offsets

    Polygons are sequences of corners of the top view, see Sums.v; (15)-(18) hold for every k and even
    for polygons that are not parallel, not planar or not closed.

    - [area k v] (15), [mixed k v w] (16), [mean], [gauss] (17), [offset d v w]: v + d w.

    Statements
    - [eq_15_16_form] and its companions: mixed area is the polar form of the area;
    - [eq_17_18_gauss], [eq_17_18_mean]: (18);
    - [cmc_offset], [cgc_offset]: offsets at -1/H and -1/(2H);
    - [cmc_offset_sharp], [cgc_offset_sharp]: without the hypothesis the area of the offset is 0.

    Unsaid in the paper: area F != 0 and area (F + d S) != 0 in (18); K != H² for the offset at -1/H,
    K != 0 for that at -1/(2H).  Reference for (16): Schneider, Convex bodies. *)

From Isogeo.theory Require Export Sums.

Definition area {K : Scalar} (k : nat) (v : nat -> vec K) : K :=
  1 / 2 * sum k (fun j => det (v j) (v (S j))).

Definition mixed {K : Scalar} (k : nat) (v w : nat -> vec K) : K :=
  1 / 4 * sum k (fun j => det (v j) (w (S j)) + det (w j) (v (S j))).

Definition gauss {K : Scalar} k (v w : nat -> vec K) : K := area k w / area k v.
Definition mean {K : Scalar} k (v w : nat -> vec K) : K := mixed k v w / area k v.

Definition offset {K : Scalar} (d : K) (v w : nat -> vec K) : nat -> vec K := fun j => (v j + d ** w j)%V.

Section Form.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (v w u : nat -> vec K) (k : nat) (d : K).

Theorem eq_15_16_form k v w d :
  area k (offset d v w) = area k v + 2 * d * mixed k v w + d² * area k w.
Proof.
  unfold area, mixed, offset.
  rewrite (sum_equal k _ (fun j => det (v j) (v (S j))
    + (d * (det (v j) (w (S j)) + det (w j) (v (S j))) + d² * det (w j) (w (S j))))).
  - rewrite !sum_add, sum_scale, sum_scale, sum_add. field. nonzero.
  - intro j. coordinates. ring.
Qed.

Theorem eq_15_16_diagonal k v : mixed k v v = area k v.
Proof.
  unfold area, mixed. rewrite (sum_equal k _ (fun j => 2 * det (v j) (v (S j)))).
  - rewrite sum_scale. field. nonzero.
  - intro j. ring.
Qed.

Theorem eq_15_16_symmetric k v w : mixed k v w = mixed k w v.
Proof. unfold mixed. f_equal. apply sum_equal. intro j. ring. Qed.

Theorem eq_15_16_linear k v w u d : mixed k v (offset d w u) = mixed k v w + d * mixed k v u.
Proof.
  unfold mixed, offset.
  rewrite (sum_equal k _ (fun j => (det (v j) (w (S j)) + det (w j) (v (S j)))
    + d * (det (v j) (u (S j)) + det (u j) (v (S j))))).
  - rewrite sum_add, sum_scale. ring.
  - intro j. coordinates. ring.
Qed.

(** Translations: only here the polygon must be closed. *)
Theorem eq_15_16_translation k v w (t : vec K) :
  closed k w -> mixed k (fun j => (v j + t)%V) w = mixed k v w.
Proof.
  intro C. unfold mixed. f_equal.
  rewrite (sum_equal k _ (fun j => (det (v j) (w (S j)) + det (w j) (v (S j)))
    + (det t (w (S j)) - det t (w j)))).
  - rewrite sum_add, (sum_telescope k (fun j => det t (w j))), C. ring.
  - intro j. coordinates. ring.
Qed.

Lemma mean_area k v w : area k v <> 0 -> mixed k v w = mean k v w * area k v.
Proof. intro H. unfold mean. field. exact H. Qed.

Lemma gauss_area k v w : area k v <> 0 -> area k w = gauss k v w * area k v.
Proof. intro H. unfold gauss. field. exact H. Qed.

(** The area of the offset: the denominator of (18) times the area. *)
Lemma offset_area k v w d : area k v <> 0 ->
  area k (offset d v w) = (1 + 2 * d * mean k v w + d² * gauss k v w) * area k v.
Proof.
  intro H. rewrite eq_15_16_form, (mean_area k v w H), (gauss_area k v w H). ring.
Qed.

Lemma offset_mixed k v w d : mixed k (offset d v w) w = mixed k v w + d * area k w.
Proof.
  rewrite eq_15_16_symmetric, eq_15_16_linear, eq_15_16_diagonal, (eq_15_16_symmetric k w v). reflexivity.
Qed.

Theorem eq_17_18_gauss k v w d :
  area k v <> 0 -> area k (offset d v w) <> 0 ->
  gauss k (offset d v w) w = gauss k v w / (1 + 2 * d * mean k v w + d² * gauss k v w).
Proof.
  intros H G. unfold gauss at 1. rewrite (offset_area k v w d H) in *.
  assert (N : 1 + 2 * d * mean k v w + d² * gauss k v w <> 0)
    by (intro Z; apply G; rewrite Z; ring).
  rewrite (gauss_area k v w H). field. split; assumption.
Qed.

Theorem eq_17_18_mean k v w d :
  area k v <> 0 -> area k (offset d v w) <> 0 ->
  mean k (offset d v w) w =
  (mean k v w + d * gauss k v w) / (1 + 2 * d * mean k v w + d² * gauss k v w).
Proof.
  intros H G. unfold mean at 1. rewrite offset_mixed. rewrite (offset_area k v w d H) in *.
  assert (N : 1 + 2 * d * mean k v w + d² * gauss k v w <> 0)
    by (intro Z; apply G; rewrite Z; ring).
  rewrite (gauss_area k v w H), (mean_area k v w H). field. split; assumption.
Qed.

Theorem cmc_offset k v w :
  area k v <> 0 -> mean k v w <> 0 -> gauss k v w <> (mean k v w)² ->
  mean k (offset (- (1 / mean k v w)) v w) w = - mean k v w.
Proof.
  intros H M N.
  assert (N' : gauss k v w - (mean k v w)² <> 0) by (intro Z; apply N, difference_zero, Z).
  assert (D : 1 + 2 * - (1 / mean k v w) * mean k v w + (- (1 / mean k v w))² * gauss k v w
            = (gauss k v w - (mean k v w)²) / (mean k v w)²) by (field; exact M).
  rewrite eq_17_18_mean; [ | exact H | ].
  - rewrite D. field. split; assumption.
  - rewrite offset_area, D by exact H. apply product_nonzero; [ | exact H].
    intro Z. apply quotient_zero in Z; [exact (N' Z) | apply product_nonzero; exact M].
Qed.

Theorem cmc_offset_sharp k v w :
  area k v <> 0 -> mean k v w <> 0 -> gauss k v w = (mean k v w)² ->
  area k (offset (- (1 / mean k v w)) v w) = 0.
Proof. intros H M E. rewrite offset_area, E by exact H. field. exact M. Qed.

Theorem cgc_offset k v w :
  area k v <> 0 -> mean k v w <> 0 -> gauss k v w <> 0 ->
  gauss k (offset (- (1 / (2 * mean k v w))) v w) w = 4 * (mean k v w)².
Proof.
  intros H M N.
  assert (T : 2 * mean k v w <> 0) by nonzero.
  assert (D : 1 + 2 * - (1 / (2 * mean k v w)) * mean k v w
                + (- (1 / (2 * mean k v w)))² * gauss k v w
            = gauss k v w / (4 * (mean k v w)²)) by (field; nonzero).
  rewrite eq_17_18_gauss; [ | exact H | ].
  - rewrite D. field. nonzero.
  - rewrite offset_area, D by exact H. apply product_nonzero; [ | exact H].
    intro Z. apply quotient_zero in Z; [exact (N Z) | nonzero].
Qed.

Theorem cgc_offset_sharp k v w :
  area k v <> 0 -> mean k v w <> 0 -> gauss k v w = 0 ->
  area k (offset (- (1 / (2 * mean k v w))) v w) = 0.
Proof. intros H M E. rewrite offset_area, E by exact H. field. nonzero. Qed.

End Form.
