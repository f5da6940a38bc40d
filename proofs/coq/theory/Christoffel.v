(** * Polygons with an incircle and Christoffel duality

    A polygon around a circle of radius r is given by unit tangents u_j and tangent lengths R_j: its
    corner j has the distance R_j from the contacts of the sides j - 1 and j; all with signs.

    - [normal u]: the unit normal, u turned clockwise;
    - [tangential r u R]: consecutive sides meet at the corners;  [corner r u R j]: the corner j;
    - [dual_tangent], [dual_length]: (-1)^j u_j and 1/R_j, with the radius -1/r;
    - [has_incircle k v m rho2]: the sides of v touch the circle with centre m and squared radius rho2.

    Statements
    - [tangential_incircle]: the corners do have an incircle;
    - [christoffel_dual_tangential], [christoffel_dual_edges], [christoffel_dual_closes]: the vectors
      ± e/(R_i R_j) are the sides of a polygon around a circle, which closes for every even k;
    - [christoffel_dual_mixed]: its mixed area with the first is 0 (koebe-minimal, for even k);
    - [thm_3_schramm]: r² (R0 + R1 + R2 + R3) = R0 R1 R2 + ...;
    - [christoffel_dual_area_ratio]: for quads area F / area S = - R0 R1 R2 R3;
      [koebe_minimal_gauss]: that is K;
    - [koebe_minimal_circles]: the dual of a Koebe mesh is isothermic;
    - [minimal_at_vertices], [minimal_at_vertices_gauss]: the same two facts for gradients at a vertex.
    See ChristoffelQuads.v for uniqueness and (20), Counterexamples.v for a triangle.

    Unsaid in the paper: no R_j is 0 (no vertex on its incircle), faces have an even number of sides. *)

From Isogeo.theory Require Export Offsets.

Section Tangential.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (r : K) (u v : nat -> vec K) (R : nat -> K) (j k : nat).

Definition normal (u : vec K) := vopp (J u).

Definition tangential r u R :=
  (forall j, ||u j||² = 1) /\
  (forall j, (r ** (normal (u (S j)) - normal (u j)))%V = (R (S j) ** (u (S j) + u j))%V).

Definition corner r u R j := (r ** normal (u j) - R j ** u j)%V.

Definition dual_tangent u j := (sign j ** u j)%V.
Definition dual_length R j := 1 / R j.
Definition dual_corner r u R := corner (- (1 / r)) (dual_tangent u) (dual_length R).

Definition has_incircle k v (m : vec K) (rho2 : K) :=
  rho2 <> 0 /\
  forall j, (j < k)%nat -> (det (v (S j) - v j) (m - v j))² = rho2 * ||v (S j) - v j||².

Lemma corner_next r u R j : tangential r u R ->
  corner r u R (S j) = (r ** normal (u j) + R (S j) ** u j)%V.
Proof.
  intros [_ T]. unfold corner.
  transitivity (r ** (normal (u (S j)) - normal (u j)) + (r ** normal (u j) - R (S j) ** u (S j)))%V.
  - apply vec_eq; coordinates; ring.
  - rewrite T. apply vec_eq; coordinates; ring.
Qed.

Lemma tangential_edge r u R j : tangential r u R ->
  (corner r u R (S j) - corner r u R j)%V = ((R j + R (S j)) ** u j)%V.
Proof. intro T. rewrite corner_next by exact T. apply vec_eq; unfold corner; coordinates; ring. Qed.

Lemma det_normal (x : vec K) : det (normal x) x = ||x||².
Proof. unfold normal. coordinates. ring. Qed.

Lemma tangential_incircle k r u R : r <> 0 -> tangential r u R -> has_incircle k (corner r u R) null r².
Proof.
  intros N T. split; [nonzero | ]. intros j _. rewrite tangential_edge by exact T.
  assert (U := proj1 T j).
  transitivity ((r * (R j + R (S j)) * ||u j||²)²).
  - unfold corner, normal. coordinates. ring.
  - transitivity (r² * ((R j + R (S j))² * ||u j||²) * ||u j||²); [ring | ].
    rewrite U at 2. coordinates. ring.
Qed.

Lemma sign_nonzero j : (sign j : K) <> 0.
Proof. intro Z. apply (one_nonzero K). rewrite <- (sign_square j), Z. ring. Qed.

Theorem christoffel_dual_tangential r u R :
  r <> 0 -> (forall j, R j <> 0) -> tangential r u R ->
  tangential (- (1 / r)) (dual_tangent u) (dual_length R).
Proof.
  intros N M [U T]. split; intro j.
  - unfold dual_tangent. transitivity (sign j * sign j * ||u j||²); [coordinates; ring | ].
    rewrite sign_square, U. ring.
  - unfold dual_tangent, dual_length. cbn [sign].
    assert (A := f_equal J (T j)). set (a := u (S j)) in *. set (b := u j) in *.
    assert (B : (r ** (a - b))%V = (R (S j) ** J (a + b))%V).
    { transitivity (J (r ** (normal a - normal b))%V); [ | rewrite A];
        unfold normal; apply vec_eq; coordinates; ring. }
    assert (C : (J (a + b) = (r / R (S j)) ** (a - b))%V).
    { transitivity ((1 / R (S j)) ** (R (S j) ** J (a + b)))%V.
      - apply vec_eq; coordinates; field; apply M.
      - rewrite <- B. apply vec_eq; coordinates; field; apply M. }
    transitivity (((- (1 / r)) * sign j) ** J (a + b))%V.
    + unfold normal. apply vec_eq; coordinates; ring.
    + rewrite C. assert (X := M (S j)). apply vec_eq; coordinates; field; nonzero.
Qed.

Theorem christoffel_dual_edges r u R j :
  r <> 0 -> (forall j, R j <> 0) -> tangential r u R ->
  (dual_corner r u R (S j) - dual_corner r u R j)%V =
  ((sign j / (R j * R (S j))) ** (corner r u R (S j) - corner r u R j))%V.
Proof.
  intros N M T. unfold dual_corner.
  rewrite tangential_edge, (tangential_edge r u R j) by (try apply christoffel_dual_tangential; assumption).
  unfold dual_length, dual_tangent. assert (X := M j). assert (Y := M (S j)).
  apply vec_eq; coordinates; field; nonzero.
Qed.

Theorem christoffel_dual_closes r u R n :
  closed (2 * n) u -> closed (2 * n) R -> closed (2 * n) (dual_corner r u R).
Proof.
  intros U T. unfold closed, dual_corner, corner, dual_tangent, dual_length. rewrite U, T, sign_even.
  reflexivity.
Qed.

(** ** Areas *)

Lemma tangential_area k r u R : tangential r u R -> closed k R -> area k (corner r u R) = r * sum k R.
Proof.
  intros T C. unfold area.
  rewrite (sum_equal k _ (fun j => r * (R j + R (S j)))).
  - rewrite sum_scale, sum_add, (sum_shift k R C). field. nonzero.
  - intro j. transitivity (det (corner r u R j) (corner r u R (S j) - corner r u R j)%V).
    + coordinates. ring.
    + rewrite tangential_edge by exact T.
      transitivity (r * (R j + R (S j)) * ||u j||²); [unfold corner, normal; coordinates; ring | ].
      rewrite (proj1 T j). ring.
Qed.

Theorem christoffel_dual_mixed r u R n :
  r <> 0 -> (forall j, R j <> 0) -> tangential r u R -> closed (2 * n) R ->
  mixed (2 * n) (corner r u R) (dual_corner r u R) = 0.
Proof.
  intros N M T C. unfold mixed. assert (D := christoffel_dual_tangential r u R N M T).
  rewrite (sum_equal _ _ (fun j => sign j * ((r * (1 / R j) - 1 / r * R j) + (r * (1 / R (S j)) - 1 / r * R (S j))))).
  - rewrite (sum_alternating (2 * n) (fun j => r * (1 / R j) - 1 / r * R j)), sign_even, C. ring.
  - intro j. set (v := corner r u R). set (w := dual_corner r u R).
    transitivity (det (v j) (w (S j) - w j)%V + det (w j) (v (S j) - v j)%V); [coordinates; ring | ].
    unfold v, w, dual_corner. rewrite !tangential_edge by assumption.
    unfold corner, dual_tangent, dual_length. assert (U := proj1 T j). assert (X := M j). assert (Y := M (S j)).
    set (t := u j) in *.
    transitivity (sign j * ||t||² * (r * (1 / R j + 1 / R (S j)) - 1 / r * (R j + R (S j)))).
    + unfold normal. coordinates. field. nonzero.
    + rewrite U. field. nonzero.
Qed.

(** A corner turns the tangent by the argument of (r + i R)². *)
Lemma tangential_turn r u R j : tangential r u R ->
  cmul (Vec r (- R (S j))) (u (S j)) = cmul (Vec r (R (S j))) (u j).
Proof.
  intros [_ T]. assert (A := f_equal J (T j)). apply vsub_zero.
  transitivity (J (r ** (normal (u (S j)) - normal (u j))) - J (R (S j) ** (u (S j) + u j)))%V.
  - unfold normal. apply vec_eq; coordinates; ring.
  - apply vsub_zero, A.
Qed.

Theorem thm_3_schramm r u R :
  r <> 0 -> tangential r u R -> closed 4 u -> closed 4 R ->
  r² * (R 0%nat + R 1%nat + R 2%nat + R 3%nat) =
  R 0%nat * R 1%nat * R 2%nat + R 1%nat * R 2%nat * R 3%nat
  + R 2%nat * R 3%nat * R 0%nat + R 3%nat * R 0%nat * R 1%nat.
Proof.
  intros N T U C.
  assert (T0 := tangential_turn r u R 0 T). assert (T1 := tangential_turn r u R 1 T).
  assert (T2 := tangential_turn r u R 2 T). assert (T3 := tangential_turn r u R 3 T).
  rewrite U, C in T3. assert (L := proj1 T 0%nat).
  set (u0 := u 0%nat) in *. set (u1 := u 1%nat) in *. set (u2 := u 2%nat) in *. set (u3 := u 3%nat) in *.
  set (a := R 0%nat) in *. set (b := R 1%nat) in *. set (c := R 2%nat) in *. set (d := R 3%nat) in *.
  clearbody a b c d u0 u1 u2 u3.
  set (p := fun x : K => Vec r x). set (q := fun x : K => Vec r (- x)).
  assert (H : cmul (cmul (cmul (q b) (q c)) (cmul (q d) (q a))) u0
            = cmul (cmul (cmul (p b) (p c)) (cmul (p d) (p a))) u0).
  { transitivity (cmul (cmul (cmul (q b) (q c)) (q d)) (cmul (q a) u0));
      [unfold p, q; apply vec_eq; coordinates; ring | ].
    unfold q at 4. rewrite T3.
    transitivity (cmul (cmul (cmul (q b) (q c)) (p a)) (cmul (q d) u3));
      [unfold p, q; apply vec_eq; coordinates; ring | ].
    unfold q at 3. rewrite T2.
    transitivity (cmul (cmul (cmul (q b) (p a)) (p d)) (cmul (q c) u2));
      [unfold p, q; apply vec_eq; coordinates; ring | ].
    unfold q at 2. rewrite T1.
    transitivity (cmul (cmul (cmul (p a) (p d)) (p c)) (cmul (q b) u1));
      [unfold p, q; apply vec_eq; coordinates; ring | ].
    unfold p, q. rewrite T0. apply vec_eq; coordinates; ring. }
  assert (I : im (cmul (cmul (p b) (p c)) (cmul (p d) (p a))) = 0).
  { apply (cancel K 2); [nonzero | ].
    transitivity (im (cmul (conj u0) (cmul (cmul (cmul (p b) (p c)) (cmul (p d) (p a))) u0))
      - im (cmul (conj u0) (cmul (cmul (cmul (q b) (q c)) (cmul (q d) (q a))) u0))).
    - transitivity (||u0||² * (2 * im (cmul (cmul (p b) (p c)) (cmul (p d) (p a))))).
      + rewrite L. ring.
      + unfold p, q. coordinates. ring.
    - rewrite H. ring. }
  apply difference_zero, (cancel K r); [exact N | ]. rewrite <- I. unfold p. coordinates. ring.
Qed.

Theorem christoffel_dual_area_ratio r u R :
  r <> 0 -> (forall j, R j <> 0) -> tangential r u R -> closed 4 u -> closed 4 R ->
  area 4 (corner r u R) =
  - (R 0%nat * R 1%nat * R 2%nat * R 3%nat) * area 4 (dual_corner r u R).
Proof.
  intros N M T U C. assert (D := christoffel_dual_tangential r u R N M T).
  assert (E : closed 4 (dual_length R)) by (unfold closed, dual_length; rewrite C; reflexivity).
  unfold dual_corner. rewrite !tangential_area by assumption.
  assert (G := thm_3_schramm r u R N T U C). unfold dual_length. cbn [sum].
  assert (M0 := M 0%nat). assert (M1 := M 1%nat). assert (M2 := M 2%nat). assert (M3 := M 3%nat).
  apply (equals_by K r); [exact N | ].
  transitivity (r² * (R 0%nat + R 1%nat + R 2%nat + R 3%nat)); [ring | ]. rewrite G. field. nonzero.
Qed.

(** The dual M of a Koebe face S: K = area S / area M, with areas exchanged - R0 R1 R2 R3. *)
Theorem koebe_minimal_gauss r u R :
  r <> 0 -> (forall j, R j <> 0) -> tangential r u R -> closed 4 u -> closed 4 R ->
  area 4 (dual_corner r u R) <> 0 ->
  mean 4 (dual_corner r u R) (corner r u R) = 0 /\
  gauss 4 (dual_corner r u R) (corner r u R) = - (R 0%nat * R 1%nat * R 2%nat * R 3%nat).
Proof.
  intros N M T U C A. unfold mean, gauss. split.
  - assert (Z : mixed 4 (corner r u R) (dual_corner r u R) = 0)
      by exact (christoffel_dual_mixed r u R 2 N M T C).
    rewrite eq_15_16_symmetric, Z. field. exact A.
  - rewrite christoffel_dual_area_ratio by assumption. field. exact A.
Qed.

(** The vertex circles of the dual, with inverse radii, touch along its edges. *)
Theorem koebe_minimal_circles (e : vec K) (ri rj : K) :
  ri <> 0 -> rj <> 0 -> ||e||² = (ri + rj)² -> ||(1 / (ri * rj)) ** e||² = (1 / ri + 1 / rj)².
Proof.
  intros A B E. transitivity ((1 / (ri * rj))² * ||e||²); [coordinates; ring | ].
  rewrite E. field. split; assumption.
Qed.

(** At vertices: the gradients of the faces around a vertex of a Koebe mesh are the centres of circles
    that touch each other and are orthogonal to that of the vertex, a polygon around it with the radii
    of faces as tangent lengths; those of the dual are dual to it, and (22) exchanges the two. *)
Theorem minimal_at_vertices r u R n :
  r <> 0 -> (forall j, R j <> 0) -> tangential r u R -> closed (2 * n) R ->
  mixed (2 * n) (dual_corner r u R) (corner r u R) = 0.
Proof. intros. rewrite eq_15_16_symmetric. apply christoffel_dual_mixed; assumption. Qed.

Theorem minimal_at_vertices_gauss r u R :
  r <> 0 -> (forall j, R j <> 0) -> tangential r u R -> closed 4 u -> closed 4 R ->
  area 4 (dual_corner r u R) <> 0 ->
  area 4 (corner r u R) / area 4 (dual_corner r u R) = - (R 0%nat * R 1%nat * R 2%nat * R 3%nat).
Proof. intros. rewrite christoffel_dual_area_ratio by assumption. field. assumption. Qed.

End Tangential.
