(** * Edges: curvatures and convexity

    - [side v j]: the edge from the corner j to the next;
    - [pairs k F]: the sum of F i j over i < j < k;
    - [edge_weight a b c d]: half the sum of the cotangents at c and d of the triangles at the edge a b.

    Statements
    - [edge_curvatures_mixed], [edge_curvatures_area]: with parallel edges, s_(j+1) - s_j = κ_j e_j,
      2 area (F, S) = sum (κ_i + κ_j)/2 det (e_i, e_j), 2 area S = sum κ_i κ_j det (e_i, e_j), i < j < k;
    - [delaunay_lift_weight]: the weight times two triangles is the in-circle determinant;
    - [delaunay_lift_edge]: it is not negative iff d is not inside of the circle through a, b, c,
      [delaunay_lift_convex]: iff the lift of d is not under the plane of the lifts of a, b, c.

    For delaunay-lift this is the local half: that locally convex lifts of convex hulls are convex is not
    formalised. *)

From Isogeo.theory Require Export Real Vertices.

Section Curvatures.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (v w : nat -> vec K) (k : nat).

Definition side v (j : nat) := (v (S j) - v j)%V.
Definition pairs k (F : nat -> nat -> K) : K := sum k (fun j => sum j (fun i => F i j)).

Lemma det_path v (x : vec K) j : det (v j - v O) x = sum j (fun i => det (side v i) x).
Proof.
  induction j as [ | j IH]; cbn [sum]; [coordinates; ring | ].
  rewrite <- IH. unfold side. coordinates. ring.
Qed.

Lemma mixed_sides k v w : closed k v -> closed k w ->
  4 * mixed k v w = pairs k (fun i j => det (side v i) (side w j) + det (side w i) (side v j)).
Proof.
  intros C D. unfold pairs.
  rewrite (sum_equal k _ (fun j => det (v j - v O) (side w j) + det (w j - w O) (side v j))).
  2: { intro j. rewrite sum_add, <- !det_path. reflexivity. }
  transitivity (sum k (fun j => det (v j) (w (S j)) + det (w j) (v (S j)))).
  - unfold mixed. field. nonzero.
  - apply difference_zero. rewrite <- (sum_zero k (fun _ => 0)) by reflexivity.
    transitivity (sum k (fun j => (det (v O) (w (S j)) + det (w O) (v (S j)))
      - (det (v O) (w j) + det (w O) (v j)))).
    + apply difference_zero.
      transitivity (sum k (fun j => det (v j) (w (S j)) + det (w j) (v (S j)))
        + - (1) * sum k (fun j => det (v j - v O) (side w j) + det (w j - w O) (side v j))
        + - (1) * sum k (fun j => (det (v O) (w (S j)) + det (w O) (v (S j)))
            - (det (v O) (w j) + det (w O) (v j)))); [ring | ].
      rewrite <- !sum_scale, <- !sum_add. apply sum_zero. intro j. unfold side. coordinates. ring.
    + rewrite (sum_telescope k (fun j => det (v O) (w j) + det (w O) (v j))), C, D.
      rewrite sum_zero by reflexivity. ring.
Qed.

Theorem edge_curvatures_mixed k v w (kappa : nat -> K) : closed k v -> closed k w ->
  (forall j, side w j = (kappa j ** side v j)%V) ->
  2 * mixed k v w = pairs k (fun i j => (kappa i + kappa j) / 2 * det (side v i) (side v j)).
Proof.
  intros C D E. apply (equals_by K 2); [nonzero | ].
  transitivity (4 * mixed k v w); [ring | ]. rewrite (mixed_sides k v w C D). unfold pairs.
  rewrite <- sum_scale. apply sum_equal. intro j. rewrite <- sum_scale. apply sum_equal. intro i.
  rewrite !E. coordinates. field. nonzero.
Qed.

Theorem edge_curvatures_area k v w (kappa : nat -> K) : closed k w ->
  (forall j, side w j = (kappa j ** side v j)%V) ->
  2 * area k w = pairs k (fun i j => kappa i * kappa j * det (side v i) (side v j)).
Proof.
  intros D E. apply (equals_by K 2); [nonzero | ].
  transitivity (4 * area k w); [ring | ]. rewrite <- eq_15_16_diagonal, (mixed_sides k w w D D). unfold pairs.
  rewrite <- sum_scale. apply sum_equal. intro j. rewrite <- sum_scale. apply sum_equal. intro i.
  rewrite !E. coordinates. ring.
Qed.

(** ** Lifts of two triangles: c to the left of a b, d to the right *)

Definition edge_weight (a b c d : vec K) : K := (cot c a b + cot d b a) / 2.

Theorem delaunay_lift_weight (a b c d : vec K) :
  det (a - c) (b - c) <> 0 -> det (b - d) (a - d) <> 0 ->
  2 * edge_weight a b c d * det (a - c) (b - c) * det (b - d) (a - d) = incircle a b c d.
Proof. intros A B. unfold edge_weight, cot. coordinates. field. nonzero. Qed.

Lemma incircle_power (a b c d m : vec K) :
  ||b - m||² = ||a - m||² -> ||c - m||² = ||a - m||² ->
  det (b - a) (c - a) * (||d - m||² - ||a - m||²) = incircle a b c d.
Proof.
  intros B C.
  assert (B' : ||b - a||² = 2 * dot (m - a) (b - a)).
  { transitivity (||b - m||² - ||a - m||² + 2 * dot (m - a) (b - a)); [coordinates; ring | rewrite B; ring]. }
  assert (C' : ||c - a||² = 2 * dot (m - a) (c - a)).
  { transitivity (||c - m||² - ||a - m||² + 2 * dot (m - a) (c - a)); [coordinates; ring | rewrite C; ring]. }
  unfold incircle. cbn zeta. rewrite B', C'. coordinates. ring.
Qed.

End Curvatures.

Local Open Scope R_scope.
Implicit Types a b c d m : vec Reals.

Theorem delaunay_lift_edge a b c d m :
  0 < det (a - c) (b - c) -> 0 < det (b - d) (a - d) ->
  norm2 (b - m) = norm2 (a - m) -> norm2 (c - m) = norm2 (a - m) ->
  (0 <= edge_weight a b c d <-> norm2 (a - m) <= norm2 (d - m)).
Proof.
  intros A B E F.
  assert (W := delaunay_lift_weight a b c d (Rgt_not_eq _ _ A) (Rgt_not_eq _ _ B)).
  assert (P := incircle_power a b c d m E F).
  assert (T : det (b - a) (c - a) = det (a - c) (b - c)) by (real_in; ring).
  rewrite T in P. rewrite <- P in W. clear P E F T.
  set (x := det (a - c) (b - c)) in *. set (y := det (b - d) (a - d)) in *.
  set (w := edge_weight a b c d) in *. set (p := norm2 (d - m)) in *. set (q := norm2 (a - m)) in *.
  clearbody x y w p q. cbn in *.
  assert (X : 2 * w * y = p - q) by (apply (Rmult_eq_reg_l x); [lra | apply Rgt_not_eq; exact A]).
  split; intro H.
  - assert (0 <= w * y) by (apply Rmult_le_pos; lra). lra.
  - destruct (Rle_or_lt 0 w) as [L | L]; [exact L | ]. exfalso.
    assert (0 < - w * y) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Theorem delaunay_lift_convex (P : plane Reals) a d :
  on (lift a) P -> (0 <= over P (lift d) <-> norm2 (a - slope P) <= norm2 (d - slope P)).
Proof.
  intro O. apply section_circle in O. assert (E := section_power P d). rewrite <- O in E.
  cbn in E |- *. split; intro H; lra.
Qed.
