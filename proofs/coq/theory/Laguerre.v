(** * Laguerre geometry and its isotropic model

    Oriented planes n · x + h = 0 with |n|² = 1, oriented spheres (m, r), and the points (12) that stand
    for planes (Sec. 2.2). Vectors of Euclidean space are written as points, a top view and a height.

    - [oriented]: a plane (n, h), [unit]: its normal has length 1;  [ball]: a sphere (m, r);
    - [touch P S]: n · m + h = r;  [image P]: the point P^i of (12);
    - [sphere_of S]: the i-M-sphere (A, B, C, D) = (r + m3, -m1, -m2, (r - m3)/2), [ball_of] its inverse;
    - [on_circle c r2 p t]: a point of the i-circle over |x - c|² = r2 in the plane z = p · x + t.

    Statements
    - [eq_12_spheres_height], [eq_12_spheres]: planes that touch a sphere are the points of an i-M-sphere;
      [eq_12_spheres_bijection], [eq_12_spheres_bijection_inverse]; [eq_12_spheres_sigma]: Σ;
    - [eq_12_spheres_image]: every point stands for a plane;
    - [eq_12_cones]: the points of an i-circle are planes through one point with normals in a plane that
      misses the origin, the tangent planes of a cone of revolution;
    - [eq_12_cones_cylinder_sharp]: for 1 + N = 0 that plane passes through the origin: a cylinder.

    Unsaid in the paper: n3 != -1; no circle is the image of a great circle, 1 + |c|² - r2 != 0. *)

From Isogeo.theory Require Export Isotropic.

Section Laguerre.
Context {K : Scalar}.
Add Field scalars : (laws K).

Record oriented := Oriented { n : point K; h : K }.
Record ball := Ball { m : point K; r : K }.
Implicit Types (P : oriented) (S T : ball) (q : point K) (x c p : vec K).

Definition dot3 (p q : point K) := dot (top p) (top q) + pz p * pz q.
Definition unit P := dot3 (n P) (n P) = 1.
Definition touch P S := dot3 (n P) (m S) + h P = r S.
Definition image P := Point ((1 / (pz (n P) + 1)) ** top (n P))%V (h P / (pz (n P) + 1)).
Definition sphere_of S :=
  Sphere (r S + pz (m S)) (vopp (top (m S))) ((r S - pz (m S)) / 2).
Definition ball_of (T : sphere K) :=
  Ball (Point (vopp (tilt T)) (bend T / 2 - base T)) (bend T / 2 + base T).

Ltac flat := unfold unit, touch, image, sphere_of, ball_of, dot3 in *; cbn [n h m r] in *; spatial.

Theorem eq_12_spheres_height P S :
  unit P -> pz (n P) + 1 <> 0 ->
  (pz (n P) + 1) * over_sphere (sphere_of S) (image P) = dot3 (n P) (m S) + h P - r S.
Proof.
  destruct P as [[[a b] c] d], S as [[[e f] g] k]. intros U N. flat.
  assert (E : a² + b² = (1 - c) * (1 + c))
    by (transitivity (a * a + b * b + c * c - c²); [ring | rewrite U; ring]).
  transitivity (d + a * e + b * f - (k + g) / 2 * ((a² + b²) / (c + 1)) - (k - g) / 2 * (c + 1)).
  - field. nonzero.
  - rewrite E. field. nonzero.
Qed.

Theorem eq_12_spheres P S :
  unit P -> pz (n P) + 1 <> 0 -> (on_sphere (image P) (sphere_of S) <-> touch P S).
Proof.
  intros U N. unfold on_sphere, touch. rewrite <- (difference_zero K (dot3 _ _ + _)).
  rewrite <- (eq_12_spheres_height P S U N). split; intro Z; [rewrite Z; ring | ].
  exact (cancel K _ _ N Z).
Qed.

Theorem eq_12_spheres_bijection S : ball_of (sphere_of S) = S.
Proof.
  destruct S as [[[a b] c] d]. flat. f_equal; [apply point_eq; [apply vec_eq; cbn; ring | ] | ];
    cbn; field; nonzero.
Qed.

Theorem eq_12_spheres_bijection_inverse (T : sphere K) : sphere_of (ball_of T) = T.
Proof.
  destruct T as [a [b c] d]. flat. f_equal; [field; nonzero | f_equal; ring | field; nonzero].
Qed.

Theorem eq_12_spheres_sigma : ball_of Sigma = Ball (Point null (1 / 2)) (1 / 2).
Proof. flat. f_equal; [apply point_eq; [apply vec_eq; cbn; ring | ] | ]; cbn; field; nonzero. Qed.

(** Every point of isotropic space stands for an oriented plane, up to n3 = -1 for just one. *)
Theorem eq_12_spheres_image q :
  1 + ||top q||² <> 0 ->
  let w := 2 / (1 + ||top q||²) in
  let P := Oriented (Point (w ** top q)%V (w - 1)) (w * pz q) in
  unit P /\ image P = q.
Proof.
  destruct q as [[a b] c]. intros N w P.
  assert (W : w <> 0) by (intro Z; apply quotient_zero in Z; [exact (two_nonzero K Z) | exact N]).
  split.
  - unfold P, w. flat. field. exact N.
  - unfold P. flat. replace (w - 1 + 1) with w by ring.
    apply point_eq; [apply vec_eq | ]; cbn [vx vy top pz]; field; exact W.
Qed.

(** ** Cones *)

Definition on_circle c (r2 : K) p (t : K) q := ||top q - c||² = r2 /\ pz q = dot p (top q) + t.

(** The tangent planes of a cone of revolution: through its vertex, with normals of one product with
    the direction of its axis. *)
Definition on_cone (vertex axis : point K) P := dot3 (n P) vertex + h P = 0 /\ dot3 (n P) axis = 1.

Theorem eq_12_cones P c (r2 : K) p (t : K) :
  unit P -> pz (n P) + 1 <> 0 ->
  let N := ||c||² - r2 in
  1 + N <> 0 ->
  let g3 := - (2 * t / (1 + N)) in
  let vertex := Point (g3 ** c - p)%V g3 in
  let axis := Point ((2 / (1 + N)) ** c)%V ((1 - N) / (1 + N)) in
  (on_circle c r2 p t (image P) <-> on_cone vertex axis P).
Proof.
  intros U A N B g3 vertex axis. unfold on_circle, on_cone.
  rewrite <- (difference_zero K (||_||²)), <- (difference_zero K (pz (image P))),
    <- (difference_zero K (dot3 (n P) axis)).
  assert (E : ||top (image P) - c||² - r2 = - ((1 + N) / (pz (n P) + 1)) * (dot3 (n P) axis - 1)).
  { unfold axis, N in *. clear vertex g3. destruct P as [[[a b] d] k], c as [e f]. flat.
    assert (E : a² + b² = (1 - d) * (1 + d))
      by (transitivity (a * a + b * b + d * d - d²); [ring | rewrite U; ring]).
    transitivity ((a² + b²) / (d + 1)² - 2 * (a * e + b * f) / (d + 1) + e² + f² - r2).
    - field. exact A.
    - rewrite E. field. nonzero. }
  assert (F : pz (image P) - (dot p (top (image P)) + t) =
    1 / (pz (n P) + 1) * (dot3 (n P) vertex + h P) + t / (pz (n P) + 1) * (dot3 (n P) axis - 1)).
  { unfold vertex, axis, g3, N in *. clear E. destruct P as [[[a b] d] k], c as [e f]. flat.
    field. nonzero. }
  rewrite E, F. set (u := dot3 (n P) vertex + h P). set (v := dot3 (n P) axis - 1). split.
  - intros [V W].
    assert (V0 : v = 0).
    { apply (cancel K (- ((1 + N) / (pz (n P) + 1)))); [ | exact V].
      intro Z. apply opposite_zero, quotient_zero in Z; [exact (B Z) | exact A]. }
    split; [ | exact V0]. rewrite V0 in W.
    apply (cancel K (1 / (pz (n P) + 1))).
    + intro Z. apply quotient_zero in Z; [exact (one_nonzero K Z) | exact A].
    + rewrite <- W. ring.
  - intros [-> ->]. split; ring.
Qed.

(** The points over a circle with 1 + N = 0 are planes with normals in a plane through the origin. *)
Theorem eq_12_cones_cylinder_sharp P c (r2 : K) :
  unit P -> pz (n P) + 1 <> 0 -> 1 + (||c||² - r2) = 0 ->
  (||top (image P) - c||² = r2 <-> dot3 (n P) (Point c 1) = 0).
Proof.
  intros U A B. rewrite <- (difference_zero K (||_||²)).
  assert (E : ||top (image P) - c||² - r2 = - (2 / (pz (n P) + 1)) * dot3 (n P) (Point c 1)).
  { transitivity (||top (image P) - c||² - (||c||² + 1) + (1 + (||c||² - r2))); [ring | rewrite B].
    destruct P as [[[a b] d] k], c as [e f]. flat.
    assert (E : a² + b² = (1 - d) * (1 + d))
      by (transitivity (a * a + b * b + d * d - d²); [ring | rewrite U; ring]).
    transitivity ((a² + b²) / (d + 1)² - 2 * (a * e + b * f) / (d + 1) - 1).
    - field. exact A.
    - rewrite E. field. exact A. }
  rewrite E. split; [ | intros ->; ring]. apply cancel.
  intro Z. apply opposite_zero, quotient_zero in Z; [exact (two_nonzero K Z) | exact A].
Qed.

End Laguerre.
