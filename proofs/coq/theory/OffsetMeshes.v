(** * Meshes with offsets

    Vertices, edges and faces at constant distance, in Euclidean space (Sec. 3.1); vectors are points of
    Isotropic.v, a top view and a height.

    - [dot3], [cross3], [norm3]: products and squared length;
    - [line_distance p q e]: squared distance of q from the line through p in the direction e, times |e|².

    Statements
    - [offset_vertex]: |m' - m|² = d² iff s lies on the unit sphere, m' = m + d s;
    - [offset_edge]: corresponding lines have the distance d iff that of s touches the unit sphere;
    - [offset_face]: corresponding planes have the distance d iff that of s touches the unit sphere;
    - [offset_face_cone]: the planes of S at s touch the unit sphere: equal angles with the axis s;
    - [offset_face_conical]: unit normals at a vertex, three of them independent, belong to planes that
      are those of a cone of revolution iff they lie in a plane;
    - [parallel_linear]: edges parallel to a given one form a linear space, so parallel meshes do, and
      v-parallel ones ([parallel_linear_heights]), without their dimensions;
    - [r_normals_coplanar]: relative normals at the ends of an edge lie in a plane with it;
      [r_normals_coplanar_sharp]: if edges are not parallel they need not.

    Unsaid in the paper: d != 0, edges have a length. *)

From Isogeo.theory Require Export Isotropic.

Section Offset.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (m s e n : point K) (d h : K).

Definition dot3 (p q : point K) := dot (top p) (top q) + pz p * pz q.
Definition norm3 p := dot3 p p.
Definition cross3 (p q : point K) :=
  Point (Vec (vy (top p) * pz q - pz p * vy (top q)) (pz p * vx (top q) - vx (top p) * pz q))
    (det (top p) (top q)).
Definition offset_point d m s := (m + d ** s)%P.
Definition line_distance (p q : point K) e := norm3 (cross3 (q - p) e).

Theorem offset_vertex d m s :
  d <> 0 -> (norm3 (offset_point d m s - m) = d² <-> norm3 s = 1).
Proof.
  intro D. assert (E : norm3 (offset_point d m s - m) = d² * norm3 s)
    by (unfold norm3, dot3, offset_point; spatial; ring).
  rewrite E. split; [ | intros ->; ring].
  intro Z. apply (equals_by K d²); [nonzero | rewrite Z; ring].
Qed.

(** The line through s in the direction e touches the unit sphere iff |s × e|² = |e|². *)
Theorem offset_edge d m s e :
  d <> 0 ->
  (line_distance m (offset_point d m s) e = d² * norm3 e <-> norm3 (cross3 s e) = norm3 e).
Proof.
  intro D. assert (E : line_distance m (offset_point d m s) e = d² * norm3 (cross3 s e))
    by (unfold line_distance, norm3, dot3, cross3, offset_point; spatial; ring).
  rewrite E. split; [ | intros ->; ring].
  intro Z. apply (equals_by K d²); [nonzero | exact Z].
Qed.

(** The plane n · x + h = 0, |n| = 1, through m: the signed distance of the offset point. *)
Theorem offset_face d m s n h :
  d <> 0 -> dot3 n m + h = 0 -> (dot3 n (offset_point d m s) + h = d <-> dot3 n s = 1).
Proof.
  intros D O. assert (E : dot3 n (offset_point d m s) + h = d * dot3 n s).
  { transitivity ((dot3 n m + h) + d * dot3 n s); [unfold dot3, offset_point; spatial; ring | ].
    rewrite O. ring. }
  rewrite E. split; [ | intros ->; ring].
  intro Z. apply (equals_by K d); [exact D | rewrite Z; ring].
Qed.

(** Unit normals n and n' of planes through s that touch the unit sphere make equal angles with s. *)
Theorem offset_face_cone s n n' : dot3 n s = 1 -> dot3 n' s = 1 -> dot3 (n - n') s = 0.
Proof.
  intros A B. transitivity (dot3 n s - dot3 n' s); [unfold dot3; spatial; ring | ].
  rewrite A, B. ring.
Qed.

(** Four normals, three independent: there is one point s in all planes n_j · s = 1 iff the normals are
    coplanar, that is, iff the four planes are those of a cone of revolution about s. *)
Lemma solve (n0 n1 n2 s t : point K) :
  volume n0 n1 n2 <> 0 -> dot3 n0 s = dot3 n0 t -> dot3 n1 s = dot3 n1 t -> dot3 n2 s = dot3 n2 t -> s = t.
Proof.
  intros D E0 E1 E2.
  assert (C : forall x : point K, (volume n0 n1 n2 ** x)%P =
    (dot3 n0 x ** cross3 n1 n2 + (dot3 n1 x ** cross3 n2 n0 + dot3 n2 x ** cross3 n0 n1))%P).
  { intro x. unfold dot3, cross3. apply point_eq; [apply vec_eq | ]; spatial; ring. }
  assert (F : (volume n0 n1 n2 ** s)%P = (volume n0 n1 n2 ** t)%P) by (rewrite (C s), (C t), E0, E1, E2; reflexivity).
  assert (X := f_equal top F). assert (Z := f_equal pz F).
  assert (X1 := f_equal vx X). assert (X2 := f_equal vy X). cbn [pscale scale top pz vx vy] in *.
  apply point_eq; [apply vec_eq | ]; apply (equals_by K (volume n0 n1 n2)); assumption.
Qed.

Theorem offset_face_conical (n0 n1 n2 n3 : point K) :
  volume n0 n1 n2 <> 0 ->
  (coplanar n0 n1 n2 n3 <->
   exists s, dot3 n0 s = 1 /\ dot3 n1 s = 1 /\ dot3 n2 s = 1 /\ dot3 n3 s = 1).
Proof.
  intro D. set (c := (cross3 n1 n2 + (cross3 n2 n0 + cross3 n0 n1))%P).
  assert (E : forall x, dot3 x c = volume n0 n1 n2 + volume (n1 - n0) (n2 - n0) (x - n0))
    by (intro x; unfold c, dot3, cross3; spatial; ring).
  set (s := ((1 / volume n0 n1 n2) ** c)%P).
  assert (F : forall x, dot3 x s = 1 + volume (n1 - n0) (n2 - n0) (x - n0) / volume n0 n1 n2).
  { intro x. transitivity (dot3 x c / volume n0 n1 n2).
    - unfold s, dot3. generalize (volume n0 n1 n2) D. intros d N. spatial. field. exact N.
    - rewrite E. field. exact D. }
  assert (Z0 : volume (n1 - n0) (n2 - n0) (n0 - n0) = 0) by (spatial; ring).
  assert (Z1 : volume (n1 - n0) (n2 - n0) (n1 - n0) = 0) by (spatial; ring).
  assert (Z2 : volume (n1 - n0) (n2 - n0) (n2 - n0) = 0) by (spatial; ring).
  assert (S0 : dot3 n0 s = 1) by (rewrite F, Z0; field; exact D).
  assert (S1 : dot3 n1 s = 1) by (rewrite F, Z1; field; exact D).
  assert (S2 : dot3 n2 s = 1) by (rewrite F, Z2; field; exact D).
  unfold coplanar. split.
  - intro Z. exists s. repeat split; try assumption. rewrite F, Z. field. exact D.
  - intros (t & T0 & T1 & T2 & T3).
    assert (Q : t = s) by (apply (solve n0 n1 n2); congruence). subst t.
    rewrite F in T3. apply (quotient_zero K _ (volume n0 n1 n2)); [exact D | ].
    transitivity (1 + volume (n1 - n0) (n2 - n0) (n3 - n0) / volume n0 n1 n2 - 1); [ring | rewrite T3; ring].
Qed.

Theorem parallel_linear e (p q : point K) (a b : K) :
  cross_zero e p -> cross_zero e q -> cross_zero e (a ** p + b ** q).
Proof.
  intros [A B] [C D]. split.
  - transitivity (a * det (top e) (top p) + b * det (top e) (top q)); [spatial; ring | ].
    rewrite A, C. ring.
  - transitivity (a ** (pz e ** top p) + b ** (pz e ** top q))%V; [apply vec_eq; spatial; ring | ].
    rewrite B, D. apply vec_eq; spatial; ring.
Qed.

Theorem parallel_linear_heights (x y z w : vec K) (f g : vec K -> K) (a b : K) :
  let over f v := Point v (f v) in
  coplanar (over f x) (over f y) (over f z) (over f w) ->
  coplanar (over g x) (over g y) (over g z) (over g w) ->
  let h v := a * f v + b * g v in
  coplanar (over h x) (over h y) (over h z) (over h w).
Proof.
  cbn zeta. unfold coplanar, volume, psub. cbn [top pz]. intros A B.
  set (d1 := det (z - x) (w - x)) in *. set (d2 := det (y - x) (w - x)) in *.
  set (d3 := det (y - x) (z - x)) in *.
  transitivity (a * ((f y - f x) * d1 - (f z - f x) * d2 + (f w - f x) * d3)
    + b * ((g y - g x) * d1 - (g z - g x) * d2 + (g w - g x) * d3)); [ring | ].
  rewrite A, B. ring.
Qed.

Theorem r_normals_coplanar (m m' s s' : point K) (l : K) :
  (s' - s)%P = (l ** (m' - m))%P -> volume (m' - m) s s' = 0.
Proof.
  intro E. assert (F : s' = (s + l ** (m' - m))%P).
  { rewrite <- E. apply point_eq; [apply vec_eq | ]; spatial; ring. }
  rewrite F. spatial. ring.
Qed.

Theorem r_normals_coplanar_sharp :
  let m := Point (Vec 0 0) 0 in let m' := Point (Vec 1 0) 0 in
  let s := Point (Vec 0 0) 1 in let s' := Point (Vec 0 1) (1 : K) in
  volume (m' - m) s s' <> 0.
Proof.
  intros m m' s s' Z. apply (one_nonzero K), opposite_zero. rewrite <- Z.
  unfold m, m', s, s'. spatial. ring.
Qed.

End Offset.
