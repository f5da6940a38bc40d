(** * Parallel quads of mixed area 0

    (20) and what it needs. A quad is given by four corners of the top view; areas are those of
    Offsets.v at k = 4.

    - [quad a b c d]: the closed polygon; [parallel_quads v w]: corresponding edges are parallel;

    Statements
    - [eq_20_identity]: 4 area (F, S) = det (13, s2 s4) + det (s1 s3, 24), for any two quads 1234, s1 s2 s3 s4;
    - [eq_20]: for parallel quads, mixed area 0 iff the diagonals are parallel crosswise;
    - [eq_20_one_diagonal], [eq_20_other_diagonal]: either condition is enough;
    - [eq_20_space]: the same for quads in parallel planes of space;
    - [eq_20_needs_parallel]: a pair of quads without parallel edges.

    The zero vector is parallel to everything; nothing has to be convex or non-degenerate. *)

From Isogeo.theory Require Export Offsets Isotropic.

Definition quad {K : Scalar} (a b c d : vec K) : nat -> vec K := corners (a :: b :: c :: d :: nil) a.

Definition parallel_quads {K : Scalar} (v w : nat -> vec K) :=
  forall j, (j < 4)%nat -> parallel (v (S j) - v j) (w (S j) - w j).

Section Quads.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types v w : nat -> vec K.

Lemma quad_closed (a b c d : vec K) : closed 4 (quad a b c d).
Proof. reflexivity. Qed.

Theorem eq_20_identity v w :
  closed 4 v -> closed 4 w ->
  4 * mixed 4 v w =
  det (v 2%nat - v 0%nat) (w 3%nat - w 1%nat) + det (w 2%nat - w 0%nat) (v 3%nat - v 1%nat).
Proof.
  intros C D. unfold mixed. cbn [sum]. rewrite C, D. coordinates. field. nonzero.
Qed.

Lemma eq_20_two v w :
  closed 4 v -> closed 4 w -> parallel_quads v w ->
  det (v 2%nat - v 0%nat) (w 3%nat - w 1%nat) = det (w 2%nat - w 0%nat) (v 3%nat - v 1%nat).
Proof.
  intros C D P.
  assert (P0 := P 0%nat ltac:(repeat constructor)). assert (P1 := P 1%nat ltac:(repeat constructor)).
  assert (P2 := P 2%nat ltac:(repeat constructor)). assert (P3 := P 3%nat ltac:(repeat constructor)).
  rewrite C, D in P3. apply difference_zero.
  transitivity (- det (v 1%nat - v 0%nat) (w 1%nat - w 0%nat)
    + det (v 2%nat - v 1%nat) (w 2%nat - w 1%nat) - det (v 3%nat - v 2%nat) (w 3%nat - w 2%nat)
    + det (v 0%nat - v 3%nat) (w 0%nat - w 3%nat)).
  - coordinates. ring.
  - unfold parallel in *. rewrite P0, P1, P2, P3. ring.
Qed.

Theorem eq_20_one_diagonal v w :
  closed 4 v -> closed 4 w -> parallel_quads v w ->
  2 * mixed 4 v w = det (v 2%nat - v 0%nat) (w 3%nat - w 1%nat).
Proof.
  intros C D P. apply (equals_by K 2); [nonzero | ].
  transitivity (4 * mixed 4 v w); [ring | ].
  rewrite (eq_20_identity v w C D), <- (eq_20_two v w C D P). ring.
Qed.

Theorem eq_20_other_diagonal v w :
  closed 4 v -> closed 4 w -> parallel_quads v w ->
  2 * mixed 4 v w = det (w 2%nat - w 0%nat) (v 3%nat - v 1%nat).
Proof. intros C D P. rewrite <- (eq_20_two v w C D P). exact (eq_20_one_diagonal v w C D P). Qed.

Theorem eq_20 v w :
  closed 4 v -> closed 4 w -> parallel_quads v w ->
  (mixed 4 v w = 0 <->
   parallel (v 2%nat - v 0%nat) (w 3%nat - w 1%nat) /\ parallel (v 3%nat - v 1%nat) (w 2%nat - w 0%nat)).
Proof.
  intros C D P. assert (E := eq_20_one_diagonal v w C D P).
  assert (G := eq_20_other_diagonal v w C D P). unfold parallel. split.
  - intro Z. rewrite Z in *. split; [rewrite <- E; ring | ].
    apply opposite_zero. transitivity (2 * (0 : K)); [rewrite G; coordinates; ring | ring].
  - intros [Z _]. apply (cancel K 2); [nonzero | rewrite E; exact Z].
Qed.

(** Quads in space, in planes of one gradient: their edges and diagonals are parallel iff those of the
    top views are. *)
Theorem eq_20_space (g : vec K) (t u : K) v w :
  closed 4 v -> closed 4 w ->
  let p j := Point (v j) (dot g (v j) + t) in
  let q j := Point (w j) (dot g (w j) + u) in
  (forall j, (j < 4)%nat -> cross_zero (p (S j) - p j) (q (S j) - q j)) ->
  (mixed 4 v w = 0 <->
   cross_zero (p 2%nat - p 0%nat) (q 3%nat - q 1%nat) /\ cross_zero (p 3%nat - p 1%nat) (q 2%nat - q 0%nat)).
Proof.
  intros C D p q H.
  assert (Hp : forall i j, pz (p j - p i)%P = dot g (top (p j - p i)%P))
    by (intros i j; unfold p; spatial; ring).
  assert (Hq : forall i j, pz (q j - q i)%P = dot g (top (q j - q i)%P))
    by (intros i j; unfold q; spatial; ring).
  rewrite (parallel_in_plane g _ _ (Hp _ _) (Hq _ _)), (parallel_in_plane g _ _ (Hp _ _) (Hq _ _)).
  apply eq_20; [exact C | exact D | ].
  intros j L. apply (parallel_in_plane g _ _ (Hp _ _) (Hq _ _)), H, L.
Qed.

(** The unit square and a quad with other edges: mixed area 0 without parallel diagonals. *)
Theorem eq_20_needs_parallel :
  let v := quad (Vec 0 0) (Vec 1 0) (Vec 1 1) (Vec 0 1) : nat -> vec K in
  let w := quad (Vec 0 0) (Vec 0 0) (Vec (- (1)) 0) (Vec 1 2) : nat -> vec K in
  mixed 4 v w = 0 /\ ~ parallel (v 2%nat - v 0%nat) (w 3%nat - w 1%nat).
Proof.
  intros v w. unfold mixed, v, w, quad, corners, cycle. cbn. coordinates. split.
  - field. nonzero.
  - intro Z. apply (one_nonzero K). rewrite <- Z. ring.
Qed.

End Quads.
