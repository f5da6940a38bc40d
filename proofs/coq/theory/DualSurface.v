(** * The dual surface

    The poles of the tangent planes of a graph z = f(x, y), (10), and its curvatures, (11), for functions
    as in Differential.v.

    - [dual_x], [dual_y], [dual_z]: f_x, f_y, x f_x + y f_y - f;
    - [gradient_along x* y* z* p q]: p, q are the derivatives of z* by x* and y*, by the chain rule.

    Statements
    - [eq_10_dual_surface_tangent]: the gradient of the dual surface is (x, y);
    - [eq_10_dual_surface]: so the dual of the dual is the graph: x x* + y y* - z* = f;
    - [eq_10_dual_surface_unique]: where K is invertible no other p, q are the gradient;
    - [eq_11_curvatures]: its Hessian h has K det h = 1 and K tr h = tr: K* = 1/K, H* = H/K;
    - [eq_11_curvatures_minimal]: minimal iff minimal.

    Unsaid in the paper: K is invertible, not only not 0 as a function. *)

From Isogeo.theory Require Export Differential.

Section Dual.
Variable A : Functions.
Add Ring functions : (ring_laws A).
Implicit Types f p q h : A.

Definition dual_x f := dx f.
Definition dual_y f := dy f.
Definition dual_z f := X * dx f + Y * dy f - f.

Definition gradient_along (x y z p q : A) :=
  dx z = p * dx x + q * dx y /\ dy z = p * dy x + q * dy y.

Theorem eq_10_dual_surface_tangent f : gradient_along (dual_x f) (dual_y f) (dual_z f) X Y.
Proof. unfold gradient_along, dual_x, dual_y, dual_z. split; derive; ring. Qed.

Theorem eq_10_dual_surface f : X * dual_x f + Y * dual_y f - dual_z f = f.
Proof. unfold dual_x, dual_y, dual_z. ring. Qed.

Definition invertible f := exists i, f * i = 1.

Lemma cancel_invertible f p q : invertible f -> f * p = f * q -> p = q.
Proof.
  intros [i I] E. transitivity (f * i * p); [rewrite I; ring | ].
  transitivity (i * (f * p)); [ring | rewrite E].
  transitivity (f * i * q); [ring | rewrite I; ring].
Qed.

Theorem eq_10_dual_surface_unique f p q :
  invertible (gauss_curvature A f) -> gradient_along (dual_x f) (dual_y f) (dual_z f) p q ->
  p = X /\ q = Y.
Proof.
  intros K [P Q]. destruct (eq_10_dual_surface_tangent f) as [P' Q'].
  rewrite P in P'. rewrite Q in Q'. unfold dual_x, dual_y in *.
  rewrite <- ?commute in *.
  split; apply (cancel_invertible (gauss_curvature A f) _ _ K); unfold gauss_curvature in *.
  - transitivity (dy (dy f) * (p * dx (dx f) + q * dx (dy f)) - dx (dy f) * (p * dx (dy f) + q * dy (dy f)));
      [ring | rewrite P', Q'; ring].
  - transitivity (dx (dx f) * (p * dx (dy f) + q * dy (dy f)) - dx (dy f) * (p * dx (dx f) + q * dx (dy f)));
      [ring | rewrite P', Q'; ring].
Qed.

(** The Hessian of the dual surface: the derivatives of its gradient (x, y) by x* and y*. *)
Theorem eq_11_curvatures f h11 h12 h21 h22 :
  invertible (gauss_curvature A f) ->
  gradient_along (dual_x f) (dual_y f) X h11 h12 ->
  gradient_along (dual_x f) (dual_y f) Y h21 h22 ->
  h12 = h21 /\
  gauss_curvature A f * (h11 * h22 - h12 * h21) = 1 /\
  gauss_curvature A f * (h11 + h22) = mean_twice A f.
Proof.
  intros I [E1 E2] [E3 E4]. unfold dual_x, dual_y in *.
  rewrite ?dx_X, ?dy_X, ?dx_Y, ?dy_Y, <- ?commute in *.
  unfold gauss_curvature, mean_twice, laplace in *.
  set (a := dx (dx f)) in *. set (b := dx (dy f)) in *. set (c := dy (dy f)) in *.
  assert (H12 : (a * c - b * b) * h12 = - b).
  { transitivity (a * (h11 * b + h12 * c) - b * (h11 * a + h12 * b)); [ring | rewrite <- E1, <- E2; ring]. }
  assert (H21 : (a * c - b * b) * h21 = - b).
  { transitivity (c * (h21 * a + h22 * b) - b * (h21 * b + h22 * c)); [ring | rewrite <- E3, <- E4; ring]. }
  assert (H11 : (a * c - b * b) * h11 = c).
  { transitivity (c * (h11 * a + h12 * b) - b * (h11 * b + h12 * c)); [ring | rewrite <- E1, <- E2; ring]. }
  assert (H22 : (a * c - b * b) * h22 = a).
  { transitivity (a * (h21 * b + h22 * c) - b * (h21 * a + h22 * b)); [ring | rewrite <- E3, <- E4; ring]. }
  split; [ | split].
  - apply (cancel_invertible (a * c - b * b) _ _ I). rewrite H12, H21. reflexivity.
  - apply (cancel_invertible (a * c - b * b) _ _ I).
    transitivity (((a * c - b * b) * h11) * ((a * c - b * b) * h22)
      - ((a * c - b * b) * h12) * ((a * c - b * b) * h21)); [ring | ].
    rewrite H11, H12, H21, H22. ring.
  - transitivity ((a * c - b * b) * h11 + (a * c - b * b) * h22); [ring | ]. rewrite H11, H22. ring.
Qed.

Theorem eq_11_curvatures_minimal f h11 h12 h21 h22 :
  invertible (gauss_curvature A f) ->
  gradient_along (dual_x f) (dual_y f) X h11 h12 ->
  gradient_along (dual_x f) (dual_y f) Y h21 h22 ->
  (mean_twice A f = 0 <-> h11 + h22 = 0).
Proof.
  intros I P Q. destruct (eq_11_curvatures f h11 h12 h21 h22 I P Q) as (_ & _ & E). split; intro Z.
  - apply (cancel_invertible (gauss_curvature A f) _ _ I). rewrite E, Z. ring.
  - rewrite <- E, Z. ring.
Qed.

End Dual.
