(** * Curvatures at vertices

    A star: the vertex v, its neighbours z_j in the top view, triangles (v, z_j, z_(j+1)), and heights;
    p_j and q_j are the gradients of two surfaces in the triangle j. Sequences repeat after k. The
    measures of (21), (22) are the areas of Offsets.v, of the polygons of gradients.

    - [gradients v z p f c]: p_j is the gradient of the heights f_j at z_j and c at v, in each triangle;
    - [cot a b c]: the cotangent of the angle at a from b to c;
    - [cotan_weight v z j]: half the sum of the two cotangents opposite to the edge v z_(j+1);
    - [vertex_gauss], [vertex_mean]: K(v) = D(v)/D(s), H(v) = D(v, s)/D(s).

    Statements
    - [eq_21_22_duality]: they are the curvatures of the dual face combined by (11);
    - [i_minimal_dual]: the metric dual of a face with H = 0 is a vertex with H = 0;
    - [vertex_stress], [vertex_stress_equilibrium]: 2 D(v, s) = sum w_j f_j where gradients jump by
      w_j J e_j, and the w_j e_j add up to 0;
    - [eq_22_cotan]: with the lift to Σ, 2 D(v, s) is the cotangent Laplacian, for every valence;
      [eq_22_cotan_circumcentre]: its gradients are the circumcentres, so D(s) is the area of their
      polygon;  [eq_22_cotan_mean]: 2H is the quotient;
    - [eq_22_cotan_sharp]: a star inscribed to a circle around no matter what centre has D(s) = 0;
    - [v_offset_mean], [v_offset_gauss]: v-offsets, H + d and K + 2 d H + d².

    Unsaid in the paper: no triangle is vertical, D(s) != 0. Nothing is Delaunay or embedded. *)

From Isogeo.theory Require Export Offsets Isotropic.

Section Vertices.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (v : vec K) (z p q : nat -> vec K) (f w : nat -> K) (k j : nat).

Definition vertex_gauss k p q : K := area k p / area k q.
Definition vertex_mean k p q : K := mixed k p q / area k q.

Theorem eq_21_22_duality k p q :
  area k p <> 0 -> area k q <> 0 ->
  vertex_mean k p q = mean k p q / gauss k p q /\ vertex_gauss k p q = 1 / gauss k p q.
Proof. intros A B. unfold vertex_mean, vertex_gauss, mean, gauss. split; field; split; assumption. Qed.

(** The faces around a vertex of the dual are the polar planes of the corners of a face. *)
Theorem i_minimal_dual k (M S : nat -> point K) :
  let corners X j := top (X j) in
  let gradients X j := slope (polar (X j)) in
  mixed k (corners M) (corners S) = 0 -> mixed k (gradients M) (gradients S) = 0.
Proof. intros c g H. exact H. Qed.

(** ** Stress *)

Definition gradients v z p f (c : K) :=
  forall j, dot (p j) (z j - v) = f j - c /\ dot (p j) (z (S j) - v) = f (S j) - c.

Definition jumps v z q w := forall j, (q (S j) - q j)%V = (w (S j) ** J (z (S j) - v))%V.

Theorem vertex_stress k v z p q f (c : K) w :
  closed k p -> closed k q -> gradients v z p f c -> jumps v z q w ->
  2 * mixed k p q = sum k (fun j => w (S j) * (f (S j) - c)).
Proof.
  intros P Q G U. unfold mixed.
  rewrite (sum_equal k _ (fun j => (- (1) * (det (p (S j)) (q (S j)) - det (p j) (q j)))
    + 2 * (w (S j) * (f (S j) - c)))).
  - rewrite sum_add, !sum_scale, (sum_telescope k (fun j => det (p j) (q j))), P, Q. field. nonzero.
  - intro j. set (e := (z (S j) - v)%V) in *.
    assert (A : dot (p j) e = f (S j) - c) by exact (proj2 (G j)).
    assert (B : dot (p (S j)) e = f (S j) - c) by exact (proj1 (G (S j))).
    assert (V : q (S j) = (q j + w (S j) ** J e)%V).
    { transitivity ((q (S j) - q j) + q j)%V; [apply vec_eq; coordinates; ring | ].
      rewrite (U j). apply vec_eq; unfold e; coordinates; ring. }
    transitivity (- (1) * (det (p (S j)) (q (S j)) - det (p j) (q j))
      + w (S j) * (dot (p j) e + dot (p (S j)) e)).
    + rewrite V. coordinates. ring.
    + rewrite A, B. ring.
Qed.

Theorem vertex_stress_equilibrium k v z q w :
  closed k q -> jumps v z q w ->
  sum k (fun j => w (S j) * vx (z (S j) - v)%V) = 0 /\ sum k (fun j => w (S j) * vy (z (S j) - v)%V) = 0.
Proof.
  intros Q U. split.
  - rewrite (sum_equal k _ (fun j => vy (q (S j)) - vy (q j))).
    + rewrite (sum_telescope k (fun j => vy (q j))), Q. ring.
    + intro j. assert (E := f_equal vy (U j)). revert E. coordinates. intros ->. ring.
  - rewrite (sum_equal k _ (fun j => - (1) * (vx (q (S j)) - vx (q j)))).
    + rewrite sum_scale, (sum_telescope k (fun j => vx (q j))), Q. ring.
    + intro j. assert (E := f_equal vx (U j)). revert E. coordinates. intros ->. ring.
Qed.

(** ** Cotangents *)

Definition cot (a b c : vec K) : K := dot (b - a) (c - a) / det (b - a) (c - a).

Definition cotan_weight v z j : K :=
  (cot (z j) (z (S j)) v + cot (z (S (S j))) v (z (S j))) / 2.

Lemma equal_products (a b x y : vec K) :
  det a b <> 0 -> dot x a = dot y a -> dot x b = dot y b -> x = y.
Proof.
  intros D A B. apply vec_eq; apply (equals_by K (det a b)); try exact D.
  - transitivity (dot x a * vy b - dot x b * vy a); [coordinates; ring | ].
    rewrite A, B. coordinates. ring.
  - transitivity (dot x b * vx a - dot x a * vx b); [coordinates; ring | ].
    rewrite A, B. coordinates. ring.
Qed.

(** The gradient of the lift is the circumcentre. *)
Theorem eq_22_cotan_circumcentre (q a b : vec K) :
  dot q (b - a) = s b - s a <-> ||q - b||² = ||q - a||².
Proof.
  rewrite <- (difference_zero K (dot q (b - a))), <- (difference_zero K (||q - b||²)).
  replace (||q - b||² - ||q - a||²) with (- (2) * (dot q (b - a) - (s b - s a)))
    by (spatial; field; nonzero).
  split; [intros ->; ring | apply cancel]. intro Z. apply (two_nonzero K), opposite_zero, Z.
Qed.

(** From the middle of the edge v b to the circumcentres of its triangles. *)
Lemma circumcentre_left (v a b q : vec K) :
  det (a - v) (b - v) <> 0 ->
  dot q (a - v) = s a - s v -> dot q (b - v) = s b - s v ->
  q = ((1 / 2) ** (v + b) - (cot a b v / 2) ** J (b - v))%V.
Proof.
  intros D A B. apply (equal_products (a - v) (b - v)); [exact D | rewrite A | rewrite B];
    unfold cot; assert (E : det (b - a) (v - a) = det (a - v) (b - v)) by (coordinates; ring);
    rewrite E; revert D; clear; spatial; intro D; field; nonzero.
Qed.

Lemma circumcentre_right (v b c q : vec K) :
  det (b - v) (c - v) <> 0 ->
  dot q (b - v) = s b - s v -> dot q (c - v) = s c - s v ->
  q = ((1 / 2) ** (v + b) + (cot c v b / 2) ** J (b - v))%V.
Proof.
  intros D A B. apply (equal_products (b - v) (c - v)); [exact D | rewrite A | rewrite B];
    unfold cot; assert (E : det (v - c) (b - c) = det (b - v) (c - v)) by (coordinates; ring);
    rewrite E; revert D; clear; spatial; intro D; field; nonzero.
Qed.

Lemma lift_jumps v z q :
  (forall j, det (z j - v) (z (S j) - v) <> 0) ->
  gradients v z q (fun j => s (z j)) (s v) ->
  jumps v z q (fun j => match j with O => 0 | S i => cotan_weight v z i end).
Proof.
  intros D G j. destruct (G j) as [A B], (G (S j)) as [C E].
  rewrite (circumcentre_left v (z j) (z (S j)) (q j) (D j) A B).
  rewrite (circumcentre_right v (z (S j)) (z (S (S j))) (q (S j)) (D (S j)) C E).
  unfold cotan_weight. apply vec_eq; coordinates; field; nonzero.
Qed.

Lemma gradients_periodic k v z p f (c : K) :
  periodic k z -> periodic k f -> (forall j, det (z j - v) (z (S j) - v) <> 0) ->
  gradients v z p f c -> closed k p.
Proof.
  intros Z F D G. unfold closed.
  apply (equal_products (z 0%nat - v) (z 1%nat - v)); [apply D | | ].
  - rewrite (proj1 (G O)). rewrite <- (Z 0%nat), <- (F 0%nat). exact (proj1 (G k)).
  - rewrite (proj2 (G O)). rewrite <- (Z 1%nat), <- (F 1%nat). exact (proj2 (G k)).
Qed.

Theorem eq_22_cotan k v z p q f (c : K) :
  periodic k z -> periodic k f -> (forall j, det (z j - v) (z (S j) - v) <> 0) ->
  gradients v z p f c -> gradients v z q (fun j => s (z j)) (s v) ->
  2 * mixed k p q = sum k (fun j => cotan_weight v z j * (f (S j) - c)).
Proof.
  intros Z F D P Q.
  assert (F' : periodic k (fun j => s (z j))) by (intro j; rewrite (Z j); reflexivity).
  rewrite (vertex_stress k v z p q f c (fun j => match j with O => 0 | S i => cotan_weight v z i end)).
  - reflexivity.
  - exact (gradients_periodic k v z p f c Z F D P).
  - exact (gradients_periodic k v z q _ _ Z F' D Q).
  - exact P.
  - exact (lift_jumps v z q D Q).
Qed.

Theorem eq_22_cotan_mean k v z p q f (c : K) :
  periodic k z -> periodic k f -> (forall j, det (z j - v) (z (S j) - v) <> 0) ->
  gradients v z p f c -> gradients v z q (fun j => s (z j)) (s v) ->
  area k q <> 0 ->
  2 * vertex_mean k p q = sum k (fun j => cotan_weight v z j * (f (S j) - c)) / area k q.
Proof.
  intros Z F D P Q N. rewrite <- (eq_22_cotan k v z p q f c Z F D P Q). unfold vertex_mean.
  field. exact N.
Qed.

(** v and all neighbours on one circle around m. *)
Theorem eq_22_cotan_sharp k v z q m :
  (forall j, det (z j - v) (z (S j) - v) <> 0) ->
  gradients v z q (fun j => s (z j)) (s v) ->
  (forall j, ||m - z j||² = ||m - v||²) -> area k q = 0.
Proof.
  intros D G C.
  assert (E : forall j, q j = m).
  { intro j. destruct (G j) as [A B]. apply (equal_products (z j - v) (z (S j) - v)); [apply D | | ].
    - rewrite A. symmetry. apply eq_22_cotan_circumcentre, C.
    - rewrite B. symmetry. apply eq_22_cotan_circumcentre, C. }
  unfold area. rewrite sum_zero; [ring | ]. intro j. rewrite !E. coordinates. ring.
Qed.

(** ** Offsets of v-parallel meshes: heights f + d g, so gradients p + d q *)

Theorem v_offset_mean k p q (d : K) :
  area k q <> 0 -> vertex_mean k (offset d p q) q = vertex_mean k p q + d.
Proof. intro N. unfold vertex_mean. rewrite offset_mixed. field. exact N. Qed.

Theorem v_offset_gauss k p q (d : K) :
  area k q <> 0 ->
  vertex_gauss k (offset d p q) q = vertex_gauss k p q + 2 * d * vertex_mean k p q + d².
Proof.
  intro N. unfold vertex_gauss, vertex_mean. rewrite eq_15_16_form. field. exact N.
Qed.

End Vertices.
