(** * Isotropic motions

    The group (1) and what it keeps.

    - [motion]: a rotation (c, s), a translation (a, b, c0) and a shear (c1, c2);
    - [move], [move_plane]: its action on points and planes.

    Statements
    - [eq_1_motions_composition], [eq_1_motions_inverse]: a group;
    - [eq_1_motions_distance], [eq_1_motions_angle]: i-distances (2) and i-angles;
    - [eq_1_motions_incidence], [eq_1_motions_parallel_points], [eq_1_motions_parallel_planes];
    - [eq_1_motions_incircle], [eq_1_motions_gradients]: concyclic top views, concyclic gradients;
    - [eq_1_motions_area]: areas, so H and K of f-parallel pairs;
    - [eq_1_motions_stretch]: without c² + s² = 1 distances change. *)

From Isogeo.theory Require Export Isotropic Offsets.

Section Motions.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (p q : point K) (P Q : plane K).

(** The rotation is a complex number. *)
Record motion := Motion { turn : vec K; shift : vec K; raise : K; shear : vec K }.
Definition rotation (M : motion) := ||turn M||² = 1.

Definition move (M : motion) p :=
  Point (shift M + cmul (turn M) (top p))%V (raise M + dot (shear M) (top p) + pz p).

(** The image of a plane: its gradient is turned, too, after the shear is added. *)
Definition move_plane (M : motion) P :=
  let g := cmul (turn M) (slope P + shear M) in
  Plane g (level P + raise M - dot g (shift M)).

Definition compose (M N : motion) :=
  Motion (cmul (turn M) (turn N)) (shift M + cmul (turn M) (shift N))%V
    (raise M + dot (shear M) (shift N) + raise N)
    (shear N + cmul (conj (turn N)) (shear M))%V.

Definition inverse (M : motion) :=
  let t := conj (turn M) in
  let h := (- cmul (turn M) (shear M))%V in
  Motion t (- cmul t (shift M))%V (- (raise M + dot h (shift M))) h.

Theorem eq_1_motions_composition M N p :
  move (compose M N) p = move M (move N p) /\ (rotation M -> rotation N -> rotation (compose M N)).
Proof.
  split.
  - unfold move, compose. cbn [turn shift raise shear].
    apply point_eq; [apply vec_eq | ]; spatial; ring.
  - unfold rotation, compose. cbn [turn]. intros A B.
    transitivity (||turn M||² * ||turn N||²); [coordinates; ring | rewrite A, B; ring].
Qed.

Theorem eq_1_motions_inverse M p :
  rotation M -> move (inverse M) (move M p) = p /\ move M (move (inverse M) p) = p /\ rotation (inverse M).
Proof.
  destruct M as [[c s] [a b] r [d e]], p as [[x y] z]. unfold rotation, inverse, move. spatial.
  cbn [turn shift raise shear vx vy top pz]. intro U.
  assert (E : c² = 1 - s²) by (rewrite <- U; ring).
  repeat split; [ | | rewrite <- U; ring];
    (apply point_eq; [apply vec_eq | ]); cbn [vx vy top pz]; ring [E].
Qed.

Theorem eq_1_motions_distance M p q : rotation M -> idist2 (move M p) (move M q) = idist2 p q.
Proof.
  intro U. transitivity (||turn M||² * idist2 p q); [unfold move; spatial; ring | ].
  unfold rotation in U. rewrite U. ring.
Qed.

Theorem eq_1_motions_angle M P Q : rotation M -> iangle2 (move_plane M P) (move_plane M Q) = iangle2 P Q.
Proof.
  intro U. transitivity (||turn M||² * iangle2 P Q); [unfold move_plane; spatial; ring | ].
  unfold rotation in U. rewrite U. ring.
Qed.

Theorem eq_1_motions_incidence M p P : rotation M -> over (move_plane M P) (move M p) = over P p.
Proof.
  intro U. transitivity (over P p + (1 - ||turn M||²) * dot (slope P + shear M) (top p)).
  - unfold move, move_plane. spatial. ring.
  - unfold rotation in U. rewrite U. ring.
Qed.

Theorem eq_1_motions_parallel_points M p q : parallel_points p q -> parallel_points (move M p) (move M q).
Proof. unfold parallel_points, move. cbn [top]. intros ->. reflexivity. Qed.

Theorem eq_1_motions_parallel_planes M P Q :
  parallel_planes P Q -> parallel_planes (move_plane M P) (move_plane M Q).
Proof. unfold parallel_planes, move_plane. cbn [slope]. intros ->. reflexivity. Qed.

Theorem eq_1_motions_incircle M p0 p1 p2 p3 : rotation M ->
  incircle (top (move M p0)) (top (move M p1)) (top (move M p2)) (top (move M p3)) =
  incircle (top p0) (top p1) (top p2) (top p3).
Proof.
  intro U. rewrite !incircle_edges.
  transitivity (||turn M||² * ||turn M||² *
    im (cmul (cmul (top p1 - top p0) (top p3 - top p2)) (conj (cmul (top p2 - top p1) (top p0 - top p3))))).
  - unfold move. spatial. ring.
  - unfold rotation in U. rewrite U. ring.
Qed.

Theorem eq_1_motions_gradients M P0 P1 P2 P3 : rotation M ->
  incircle (slope (move_plane M P0)) (slope (move_plane M P1)) (slope (move_plane M P2)) (slope (move_plane M P3))
  = incircle (slope P0) (slope P1) (slope P2) (slope P3).
Proof.
  intro U. rewrite !incircle_edges.
  transitivity (||turn M||² * ||turn M||² *
    im (cmul (cmul (slope P1 - slope P0) (slope P3 - slope P2))
      (conj (cmul (slope P2 - slope P1) (slope P0 - slope P3))))).
  - unfold move_plane. spatial. ring.
  - unfold rotation in U. rewrite U. ring.
Qed.

Theorem eq_1_motions_area M k (v w : nat -> vec K) : rotation M ->
  mixed k (fun j => cmul (turn M) (v j)) (fun j => cmul (turn M) (w j)) = mixed k v w.
Proof.
  intro U. unfold mixed.
  rewrite (sum_equal k _ (fun j => ||turn M||² * (det (v j) (w (S j)) + det (w j) (v (S j))))).
  - rewrite sum_scale. unfold rotation in U. rewrite U. ring.
  - intro j. coordinates. ring.
Qed.

(** c = 2, s = 0: the points 0 and (1, 0) move to distance 2. *)
Theorem eq_1_motions_stretch :
  let M := Motion (Vec 2 0) null 0 null in
  idist2 (move M (Point null 0)) (move M (Point (Vec 1 0) 0)) = 4 /\
  idist2 (Point null 0) (Point (Vec 1 0) 0) = (1 : K).
Proof. cbn zeta. unfold move. cbn [turn shift raise shear]. spatial. split; ring. Qed.

End Motions.
