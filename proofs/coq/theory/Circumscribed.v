(** * Circumscribed meshes: Theorem 2

    What is dual to Inscribed.v. A mesh with planes that touch Σ is given by their contacts; two of them
    meet over the edge between their faces iff one contact is the mirror image of the other.

    - [conical_at], [circular_face]: concyclic gradients, concyclic corners;
    - [reflect v d x]: the mirror image of x at the line through v in the direction d.

    Statements
    - [thm_2_dual]: the dual of an i-conical vertex is an i-circular face, [thm_2_dual_face] and
      conversely; [thm_2_dual_plane]: the corners of the dual face lie in the polar plane of the vertex;
    - [thm_2_f]: tangent planes with the gradients of an i-conical vertex meet in one point, and only
      there ([thm_2_f_only]);
    - [thm_2_v]: tangent planes meet over an edge iff contacts are mirror images at it;
    - [thm_2_v_closes], [thm_2_v_closes_only]: around a vertex with four edges the contacts close iff
      the vertex is balanced, (14) modulo π;
    - [thm_2_voronoi_centre]: the contacts around a vertex lie on a circle about it,
      [thm_2_voronoi_axis]: edges are the radical axes of contacts.

    Unsaid in the paper: three gradients are not collinear; edges have a length in the top view; M is
    simply connected. Empty circles are not treated. *)

From Isogeo.theory Require Export Inscribed Conical Duality.

Section Theorem2.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (v : point K) (P : plane K) (x y d : vec K).

Definition conical_at (P0 P1 P2 P3 : plane K) :=
  concyclic_or_collinear (slope P0) (slope P1) (slope P2) (slope P3).
Definition circular_face (p0 p1 p2 p3 : point K) :=
  coplanar p0 p1 p2 p3 /\ concyclic_or_collinear (top p0) (top p1) (top p2) (top p3).

Lemma coplanar_of_plane (P : plane K) (a b c e : point K) : on a P -> on b P -> on c P -> on e P -> coplanar a b c e.
Proof.
  rewrite !on_iff. intros A B C D. unfold coplanar, volume, psub. cbn [top pz].
  rewrite A, B, C, D. spatial. ring.
Qed.

Theorem thm_2_dual_plane v P : on v P -> on (pole P) (polar v).
Proof. apply duality_incidence. Qed.

Theorem thm_2_dual v P0 P1 P2 P3 :
  on v P0 -> on v P1 -> on v P2 -> on v P3 ->
  (conical_at P0 P1 P2 P3 <-> circular_face (pole P0) (pole P1) (pole P2) (pole P3)).
Proof.
  intros A B C D. apply duality_incidence in A, B, C, D. unfold conical_at, circular_face.
  cbn [pole top]. split; [intro I | intros [_ I]; exact I]. split; [ | exact I].
  exact (coplanar_of_plane (polar v) _ _ _ _ A B C D).
Qed.

Theorem thm_2_dual_face P (p0 p1 p2 p3 : point K) :
  on p0 P -> on p1 P -> on p2 P -> on p3 P ->
  (circular_face p0 p1 p2 p3 <-> conical_at (polar p0) (polar p1) (polar p2) (polar p3)).
Proof.
  intros A B C D. unfold conical_at, circular_face. cbn [polar slope].
  split; [intros [_ I]; exact I | intro I; split; [ | exact I]].
  exact (coplanar_of_plane P _ _ _ _ A B C D).
Qed.

(** ** f-parallel to a circumscribed mesh *)

Theorem thm_2_f (g0 g1 g2 g3 : vec K) :
  det (g1 - g0) (g2 - g0) <> 0 -> concyclic_or_collinear g0 g1 g2 g3 ->
  exists v, on v (tangent g0) /\ on v (tangent g1) /\ on v (tangent g2) /\ on v (tangent g3).
Proof.
  intros D I. destruct (conical_cone_vertex g0 g1 g2 g3 D) as (A & B & C & E). cbn zeta in *.
  eexists. repeat split; [exact A | exact B | exact C | exact (E I)].
Qed.

Theorem thm_2_f_only v (g0 g1 g2 g3 : vec K) :
  on v (tangent g0) -> on v (tangent g1) -> on v (tangent g2) -> on v (tangent g3) ->
  concyclic_or_collinear g0 g1 g2 g3.
Proof. rewrite !conical_cone_apex. apply incircle_of_circle. Qed.

(** ** v-parallel to circumscribed meshes *)

Definition reflect (v d x : vec K) : vec K := step v (J d) x.

Lemma norm2_J (d : vec K) : ||J d||² = ||d||².
Proof. coordinates. ring. Qed.

(** The planes that touch Σ over x and y agree along the line through a in the direction d. *)
Theorem thm_2_v (a d x y : vec K) :
  ||d||² <> 0 -> x <> y ->
  (at_plane (tangent x) a = at_plane (tangent y) a /\ dot x d = dot y d <-> y = reflect a d x).
Proof.
  intros N D. split.
  - intros [A B].
    assert (P : parallel (J d) (y - x)).
    { transitivity (dot x d - dot y d); [coordinates; ring | rewrite B; ring]. }
    assert (M : J d <> null).
    { intro Z. apply N. rewrite <- norm2_J, Z. coordinates. ring. }
    destruct (parallel_multiple _ _ M P) as [l L].
    assert (Y : y = (x + l ** J d)%V) by (rewrite <- L; apply vec_eq; coordinates; ring).
    assert (R : l <> 0).
    { intro Z. apply D. rewrite Y, Z. apply vec_eq; coordinates; ring. }
    assert (E : l * (2 * dot (a - x) (J d) - l * ||d||²) = 0).
    { transitivity (2 * (at_plane (tangent y) a - at_plane (tangent x) a)).
      - rewrite Y. spatial. field. nonzero.
      - rewrite A. ring. }
    apply cancel in E; [ | exact R].
    assert (F : l = 2 * dot (a - x) (J d) / ||J d||²).
    { rewrite norm2_J. apply (equals_by K ||d||²); [exact N | ]. symmetry. apply difference_zero.
      rewrite <- E. field. exact N. }
    unfold reflect, step. rewrite <- F. exact Y.
  - intros ->. unfold reflect, step. rewrite norm2_J. split; spatial; field; nonzero.
Qed.

(** Edges in the directions e_j from a vertex over v: the contact of one face, mirrored four times. *)
Lemma balance_J (e0 e1 e2 e3 : vec K) :
  im (cmul (cmul (J e1) (J e3)) (conj (cmul (J e0) (J e2)))) = - balance e0 e1 e2 e3.
Proof. unfold balance. coordinates. ring. Qed.

Definition reflect_around (v e0 e1 e2 e3 x : vec K) := around v (J e0) (J e1) (J e2) (J e3) x.

Theorem thm_2_v_closes (v e0 e1 e2 e3 x : vec K) :
  ||e0||² <> 0 -> ||e1||² <> 0 -> ||e2||² <> 0 -> ||e3||² <> 0 ->
  balance e0 e1 e2 e3 = 0 -> reflect_around v e0 e1 e2 e3 x = x.
Proof.
  intros N0 N1 N2 N3 B. unfold reflect_around.
  rewrite <- norm2_J in N0, N1, N2, N3. rewrite thm_1_f_defect by assumption.
  rewrite balance_J, B. set (w := cmul _ _).
  assert (N : ||w||² <> 0).
  { unfold w. rewrite !norm2_cmul. replace (||conj (cmul (J e0) (J e2))||²) with (||J e0||² * ||J e2||²)
      by (coordinates; ring). nonzero. }
  clearbody w. apply vec_eq; coordinates; field; exact N.
Qed.

Theorem thm_2_v_closes_only (v e0 e1 e2 e3 x : vec K) :
  ||e0||² <> 0 -> ||e1||² <> 0 -> ||e2||² <> 0 -> ||e3||² <> 0 -> ||x - v||² <> 0 ->
  reflect_around v e0 e1 e2 e3 x = x -> balance e0 e1 e2 e3 = 0.
Proof.
  intros N0 N1 N2 N3 X E. unfold reflect_around in E.
  rewrite <- norm2_J in N0, N1, N2, N3. rewrite thm_1_f_defect in E by assumption.
  rewrite balance_J in E. set (w := cmul _ _) in E.
  assert (N : ||w||² <> 0).
  { unfold w. rewrite !norm2_cmul. replace (||conj (cmul (J e0) (J e2))||²) with (||J e0||² * ||J e2||²)
      by (coordinates; ring). nonzero. }
  assert (Z : ((2 * - balance e0 e1 e2 e3 / ||w||²) ** J (cmul w (x - v)))%V = null).
  { transitivity ((x + (2 * - balance e0 e1 e2 e3 / ||w||²) ** J (cmul w (x - v))) - x)%V;
      [ | rewrite E]; apply vec_eq; coordinates; ring. }
  apply scale_zero in Z.
  - apply quotient_zero in Z; [ | exact N]. apply opposite_zero. apply (cancel K 2); [nonzero | exact Z].
  - intro O. apply (product_nonzero K _ _ N X). rewrite <- norm2_cmul, <- norm2_J, O. coordinates. ring.
Qed.

Theorem thm_2_voronoi_centre (v d x : vec K) : ||d||² <> 0 -> ||reflect v d x - v||² = ||x - v||².
Proof. intro N. rewrite <- norm2_J in N. apply (thm_1_f_mirror v (J d) x N). Qed.

(** Points over the edge have the same distance from both contacts. *)
Theorem thm_2_voronoi_axis (v d x : vec K) (l : K) :
  ||d||² <> 0 -> ||v + l ** d - reflect v d x||² = ||v + l ** d - x||².
Proof. intro N. unfold reflect, step. rewrite norm2_J. coordinates. field. exact N. Qed.

End Theorem2.
