(** * Isotropic space

    Points, non-isotropic planes and the i-sphere Σ : z = |x'|²/2 of (5), over any field (Sec. 2.1).

    - [point]: a top view and a height; [plane]: z = slope · x' + level, its [slope] is the gradient;
    - [over P p]: how much the point lies over the plane; [on p P]: it lies on it;
    - [idist2], [iangle2]: squared i-distance (2) of points and i-angle of planes;
    - [Sigma], [lift x], [tangent x]: the i-unit sphere, its point over x and its plane there;
    - [polar], [pole]: metric duality;  [sphere]: i-Moebius spheres (3), planes included;
    - [volume], [cross_zero]: coplanar points and parallel vectors of space.

    Statements
    - [section_circle]: Σ and a plane meet over |x - g|² = |g|² + 2t, g its gradient;
    - [duality_sigma_section]: whose centre is the top view of the pole (duality-sigma, Theorem 2). *)

From Isogeo.theory Require Export Vector.

Record point (K : Scalar) := Point { top : vec K; pz : K }.
Arguments Point {K}.
Arguments top {K}.
Arguments pz {K}.
Record plane (K : Scalar) := Plane { slope : vec K; level : K }.
Arguments Plane {K}.
Arguments slope {K}.
Arguments level {K}.
Record sphere (K : Scalar) := Sphere { bend : K; tilt : vec K; base : K }.
Arguments Sphere {K}.
Arguments bend {K}.
Arguments tilt {K}.
Arguments base {K}.
Declare Scope point_scope.
Delimit Scope point_scope with P.
Bind Scope point_scope with point.

Section Space.
Context {K : Scalar}.
Add Field scalars : (laws K).

Definition padd (p q : point K) := Point (top p + top q)%V (pz p + pz q).
Definition psub (p q : point K) := Point (top p - top q)%V (pz p - pz q).
Definition pscale (r : K) (p : point K) := Point (r ** top p)%V (r * pz p).
(** The determinant of three vectors of space. *)
Definition volume (p q r : point K) :=
  pz p * det (top q) (top r) - pz q * det (top p) (top r) + pz r * det (top p) (top q).
(** Parallel vectors of space: their cross product vanishes. *)
Definition cross_zero (p q : point K) :=
  det (top p) (top q) = 0 /\ (pz p ** top q)%V = (pz q ** top p)%V.
Definition coplanar (a b c d : point K) := volume (psub b a) (psub c a) (psub d a) = 0.

(** The height of a plane, of an i-M-sphere and of Σ over a point of the top view. *)
Definition at_plane (P : plane K) (x : vec K) := dot (slope P) x + level P.
Definition at_sphere (S : sphere K) (x : vec K) :=
  bend S / 2 * ||x||² + dot (tilt S) x + base S.
Definition s (x : vec K) := ||x||² / 2.

Definition over (P : plane K) (p : point K) := pz p - at_plane P (top p).
Definition over_sphere (S : sphere K) (p : point K) := pz p - at_sphere S (top p).
Definition over_sigma (p : point K) := pz p - s (top p).
Definition on (p : point K) (P : plane K) := over P p = 0.
Definition on_sphere (p : point K) (S : sphere K) := over_sphere S p = 0.
Definition on_sigma (p : point K) := over_sigma p = 0.

Definition lift (x : vec K) := Point x (s x).
Definition tangent (x : vec K) := Plane x (- s x).
Definition Sigma : sphere K := Sphere 1 null 0.
(** A plane that touches Σ is the tangent plane at some point. *)
Definition touches_sigma (P : plane K) := exists x, P = tangent x.

Definition polar (p : point K) := Plane (top p) (- pz p).
Definition pole (P : plane K) := Point (slope P) (- level P).

Definition idist2 (p q : point K) := ||top q - top p||².
Definition iangle2 (P Q : plane K) := ||slope Q - slope P||².
Definition parallel_points (p q : point K) := top p = top q.
Definition parallel_planes (P Q : plane K) := slope P = slope Q.

End Space.

Notation "p + q" := (padd p q) : point_scope.
Notation "p - q" := (psub p q) : point_scope.
Notation "r ** p" := (pscale r%K p) : point_scope.

Ltac spatial :=
  unfold on, on_sphere, on_sigma, over, over_sphere, over_sigma, at_plane, at_sphere,
    coplanar, volume, cross_zero, padd, psub, pscale, lift, tangent, Sigma, polar, pole, idist2,
    iangle2, parallel_points, parallel_planes, s in *;
  cbn [top pz slope level bend tilt base] in *; coordinates.

Section Laws.
Context {K : Scalar}.
Add Field scalars' : (laws K).
Implicit Types (p q a b c d : point K) (P Q : plane K) (x m : vec K).

Lemma point_eq p q : top p = top q -> pz p = pz q -> p = q.
Proof. destruct p, q. cbn. intros -> ->. reflexivity. Qed.

Lemma plane_eq P Q : slope P = slope Q -> level P = level Q -> P = Q.
Proof. destruct P, Q. cbn. intros -> ->. reflexivity. Qed.

Lemma on_iff p P : on p P <-> pz p = at_plane P (top p).
Proof. apply difference_zero. Qed.

Lemma on_sigma_iff p : on_sigma p <-> pz p = s (top p).
Proof. apply difference_zero. Qed.

Lemma on_sigma_lift p : on_sigma p <-> p = lift (top p).
Proof.
  rewrite on_sigma_iff. split.
  - intro H. apply point_eq; [reflexivity | exact H].
  - intros ->. reflexivity.
Qed.

(** The plane lies under Σ by half the power of a circle around its gradient. *)
Lemma section_power P x :
  2 * over P (lift x) = ||x - slope P||² - (||slope P||² + 2 * level P).
Proof. spatial. field. nonzero. Qed.

Lemma section_circle P x :
  on (lift x) P <-> ||x - slope P||² = ||slope P||² + 2 * level P.
Proof.
  rewrite <- (difference_zero K (||x - slope P||²)), <- section_power. unfold on. split; intro H.
  - rewrite H. ring.
  - apply (cancel K 2); [apply two_nonzero | exact H].
Qed.

Theorem duality_sigma_section P x :
  on (lift x) P <-> ||x - top (pole P)||² = ||slope P||² + 2 * level P.
Proof. apply section_circle. Qed.

(** In a plane that is not isotropic, vectors are parallel iff their top views are. *)
Lemma parallel_in_plane (g : vec K) p q :
  pz p = dot g (top p) -> pz q = dot g (top q) ->
  (cross_zero p q <-> parallel (top p) (top q)).
Proof.
  intros Hp Hq. split; [intros [H _]; exact H | intro H; split; [exact H | ]].
  rewrite Hp, Hq. unfold parallel in H. apply vec_eq; spatial.
  - apply difference_zero. transitivity (- vy g * (vx (top p) * vy (top q) - vy (top p) * vx (top q))).
    + ring.
    + rewrite H. ring.
  - apply difference_zero. transitivity (vx g * (vx (top p) * vy (top q) - vy (top p) * vx (top q))).
    + ring.
    + rewrite H. ring.
Qed.

End Laws.
