(** * Circular faces of Euclidean space

    Parallel meshes with vertices on the unit sphere, after Theorem 1. A face lies in a plane with the
    orthonormal frame a, b; its corners have coordinates there.

    - [frame a b]; [embed a b x]: the vector with the coordinates x;  [flat a b s]: those of a projection;
    - [sphere_step e s]: the other point of the unit sphere on the line through s in the direction e.

    Statements
    - [offset_vertex_step]: that it is;
    - [offset_vertex_closes], [offset_vertex_closes_only]: around a quad the four steps close from every
      start iff it is concyclic, so quads of circular meshes have vertex offsets.

    Unsaid in the paper: edges have a length; the start does not lie over the centre of the plane. *)

From Isogeo.theory Require Export Inscribed OffsetMeshes.

Section Circular.
Context {K : Scalar}.
Add Field scalars : (laws K).
Variables a b : point K.
Implicit Types (e s : point K) (x y : vec K).

Definition frame := norm3 a = 1 /\ norm3 b = 1 /\ dot3 a b = 0.
Definition embed x : point K := (vx x ** a + vy x ** b)%P.
Definition flat s : vec K := Vec (dot3 s a) (dot3 s b).
Definition sphere_step e s : point K := (s + (- (2 * dot3 s e / norm3 e)) ** e)%P.

Theorem offset_vertex_step e s (l : K) :
  norm3 e <> 0 -> norm3 s = 1 ->
  (norm3 (s + l ** e) = 1 <-> l = 0 \/ (s + l ** e)%P = sphere_step e s).
Proof.
  intros N U. rewrite <- (difference_zero K (norm3 _)).
  assert (E : norm3 (s + l ** e) - 1 = l * (2 * dot3 s e + l * norm3 e)).
  { transitivity (norm3 s - 1 + l * (2 * dot3 s e + l * norm3 e)); [unfold norm3, dot3; spatial; ring | ].
    rewrite U. ring. }
  rewrite E. split.
  - intro Z. destruct (product_zero K _ _ Z) as [Y | Y]; [left; exact Y | right].
    unfold sphere_step. replace (- (2 * dot3 s e / norm3 e)) with l; [reflexivity | ].
    apply (equals_by K (norm3 e)); [exact N | ].
    transitivity (2 * dot3 s e + l * norm3 e - 2 * dot3 s e); [ring | rewrite Y; field; exact N].
  - intros [-> | F]; [ring | ].
    assert (G : l * norm3 e = - (2 * dot3 s e)).
    { transitivity (dot3 ((s + l ** e) - s) e); [unfold norm3, dot3; spatial; ring | ]. rewrite F.
      unfold sphere_step. unfold norm3, dot3 in *. spatial. field. exact N. }
    rewrite G. ring.
Qed.

Hypothesis orthonormal : frame.

Lemma embed_flat x y : dot3 (embed x) (embed y) = dot x y.
Proof.
  destruct orthonormal as (A & B & C). unfold norm3 in *.
  transitivity (vx x * vx y * dot3 a a + vy x * vy y * dot3 b b + (vx x * vy y + vy x * vx y) * dot3 a b).
  - unfold embed, dot3. spatial. ring.
  - rewrite A, B, C. coordinates. ring.
Qed.

Lemma dot_embed s x : dot3 s (embed x) = dot (flat s) x.
Proof. unfold embed, flat, dot3. spatial. ring. Qed.

Lemma flat_embed s x : flat (s + embed x) = (flat s + x)%V.
Proof.
  destruct orthonormal as (A & B & C). unfold norm3 in *. unfold flat. apply vec_eq; cbn [vx vy vadd].
  - transitivity (dot3 s a + (vx x * dot3 a a + vy x * dot3 a b)); [unfold embed, dot3; spatial; ring | ].
    rewrite A, C. ring.
  - transitivity (dot3 s b + (vx x * dot3 a b + vy x * dot3 b b)); [unfold embed, dot3; spatial; ring | ].
    rewrite B, C. ring.
Qed.

(** A step is that of Inscribed.v in the plane, with the gradient 0, and nothing across. *)
Lemma sphere_step_flat x s :
  ||x||² <> 0 ->
  sphere_step (embed x) s = (s + embed (step null x (flat s) - flat s))%P.
Proof.
  intro N. unfold sphere_step. unfold norm3. rewrite embed_flat, dot_embed.
  change (dot x x) with (||x||²). unfold step. generalize (flat s). intro y.
  unfold embed. apply point_eq; [apply vec_eq | ]; spatial; field; exact N.
Qed.

Lemma steps_flat x s y :
  ||x||² <> 0 ->
  sphere_step (embed x) (s + embed y) = (s + embed (step null x (flat s + y) - flat s))%P.
Proof.
  intro N. rewrite sphere_step_flat, flat_embed by exact N. generalize (step null x (flat s + y)) (flat s).
  intros u w. unfold embed. apply point_eq; [apply vec_eq | ]; spatial; ring.
Qed.

Definition around_sphere (e0 e1 e2 e3 : vec K) s :=
  sphere_step (embed e3) (sphere_step (embed e2) (sphere_step (embed e1) (sphere_step (embed e0) s))).

Lemma around_flat (e0 e1 e2 e3 : vec K) s :
  ||e0||² <> 0 -> ||e1||² <> 0 -> ||e2||² <> 0 -> ||e3||² <> 0 ->
  around_sphere e0 e1 e2 e3 s = (s + embed (around null e0 e1 e2 e3 (flat s) - flat s))%P.
Proof.
  intros N0 N1 N2 N3. unfold around_sphere, around.
  assert (Z : forall y, (flat s + (y - flat s))%V = y) by (intro y; apply vec_eq; coordinates; ring).
  rewrite (sphere_step_flat e0 s N0), (steps_flat e1 s _ N1), Z, (steps_flat e2 s _ N2), Z,
    (steps_flat e3 s _ N3), Z. reflexivity.
Qed.

Theorem offset_vertex_closes (p0 p1 p2 p3 : vec K) s :
  ||p1 - p0||² <> 0 -> ||p2 - p1||² <> 0 -> ||p3 - p2||² <> 0 -> ||p0 - p3||² <> 0 ->
  incircle p0 p1 p2 p3 = 0 -> around_sphere (p1 - p0) (p2 - p1) (p3 - p2) (p0 - p3) s = s.
Proof.
  intros N0 N1 N2 N3 I. rewrite around_flat, thm_1_f_quad_closes by assumption.
  unfold embed. apply point_eq; [apply vec_eq | ]; spatial; ring.
Qed.

Theorem offset_vertex_closes_only (p0 p1 p2 p3 : vec K) s :
  ||p1 - p0||² <> 0 -> ||p2 - p1||² <> 0 -> ||p3 - p2||² <> 0 -> ||p0 - p3||² <> 0 ->
  ||flat s - null||² <> 0 ->
  around_sphere (p1 - p0) (p2 - p1) (p3 - p2) (p0 - p3) s = s -> incircle p0 p1 p2 p3 = 0.
Proof.
  intros N0 N1 N2 N3 X E.
  apply (thm_1_f_quad_closes_only null p0 p1 p2 p3 (flat s) N0 N1 N2 N3 X).
  assert (F := f_equal flat E). rewrite around_flat, flat_embed in F by assumption.
  rewrite <- F at 2. apply vec_eq; coordinates; ring.
Qed.

End Circular.
