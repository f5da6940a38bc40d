(** * Functions of two variables, as algebra

    A commutative ring with two commuting derivations and elements x, y that they know as coordinates:
    smooth functions in a region of the plane are one, and so are polynomials, rational functions and
    power series. What is proved here holds for all of these; nothing is said about existence, limits or
    domains, and division is by elements with an inverse.

    - [Functions]: such a ring, [dx] and [dy] its derivations, [X] and [Y] the coordinates;
    - [laplace], [rho]: Δ and x² + y²;
    - [hessian_xx], ...: second derivatives; [gauss_curvature], [mean_twice]: K of (8) and 2H of (9).

    Statements
    - [eq_8_9_curvatures]: K and 2H by principal curvatures;  [eq_6_gauss_shape]: the derivative of the
      Gauss map is the Hessian (6), (7). *)

Require Export Ring.

Record Functions := MakeFunctions {
  elements :> Type;
  zero : elements;
  one : elements;
  add : elements -> elements -> elements;
  mul : elements -> elements -> elements;
  sub : elements -> elements -> elements;
  opp : elements -> elements;
  ring_laws : ring_theory zero one add mul sub opp (@eq elements);
  dx : elements -> elements;
  dy : elements -> elements;
  X : elements;
  Y : elements;
  dx_add : forall f g, dx (add f g) = add (dx f) (dx g);
  dy_add : forall f g, dy (add f g) = add (dy f) (dy g);
  dx_mul : forall f g, dx (mul f g) = add (mul (dx f) g) (mul f (dx g));
  dy_mul : forall f g, dy (mul f g) = add (mul (dy f) g) (mul f (dy g));
  commute : forall f, dx (dy f) = dy (dx f);
  dx_X : dx X = one;
  dy_X : dy X = zero;
  dx_Y : dx Y = zero;
  dy_Y : dy Y = one
}.

Arguments zero {_}.
Arguments one {_}.
Arguments add {_}.
Arguments mul {_}.
Arguments sub {_}.
Arguments opp {_}.
Arguments dx {_}.
Arguments dy {_}.
Arguments X {_}.
Arguments Y {_}.

Declare Scope function_scope'.
Delimit Scope function_scope' with F.
Bind Scope function_scope' with elements.
Notation "0" := zero : function_scope'.
Notation "1" := one : function_scope'.
Notation "x + y" := (add x y) : function_scope'.
Notation "x * y" := (mul x y) : function_scope'.
Notation "x - y" := (sub x y) : function_scope'.
Notation "- x" := (opp x) : function_scope'.
Open Scope function_scope'.

Section Rules.
Variable A : Functions.
Add Ring functions : (ring_laws A).
Implicit Types f g : A.

Lemma cancel_add f g : f = f + g -> g = 0.
Proof. intro E. replace g with (f + g - f) by ring. rewrite <- E. ring. Qed.

Lemma dx_zero : dx (0 : A) = 0.
Proof. apply (cancel_add (dx 0)). rewrite <- dx_add. f_equal. ring. Qed.

Lemma dy_zero : dy (0 : A) = 0.
Proof. apply (cancel_add (dy 0)). rewrite <- dy_add. f_equal. ring. Qed.

Lemma dx_one : dx (1 : A) = 0.
Proof.
  apply (cancel_add (dx 1)). transitivity (dx ((1 : A) * 1)); [f_equal; ring | ].
  rewrite dx_mul. ring.
Qed.

Lemma dy_one : dy (1 : A) = 0.
Proof.
  apply (cancel_add (dy 1)). transitivity (dy ((1 : A) * 1)); [f_equal; ring | ].
  rewrite dy_mul. ring.
Qed.

Lemma dx_opp f : dx (- f) = - dx f.
Proof.
  transitivity (dx (- f) + dx f - dx f); [ring | ]. rewrite <- dx_add.
  replace (- f + f) with (0 : A) by ring. rewrite dx_zero. ring.
Qed.

Lemma dy_opp f : dy (- f) = - dy f.
Proof.
  transitivity (dy (- f) + dy f - dy f); [ring | ]. rewrite <- dy_add.
  replace (- f + f) with (0 : A) by ring. rewrite dy_zero. ring.
Qed.

Lemma dx_sub f g : dx (f - g) = dx f - dx g.
Proof. replace (f - g) with (f + - g) by ring. rewrite dx_add, dx_opp. ring. Qed.

Lemma dy_sub f g : dy (f - g) = dy f - dy g.
Proof. replace (f - g) with (f + - g) by ring. rewrite dy_add, dy_opp. ring. Qed.

Definition laplace f := dx (dx f) + dy (dy f).
Definition rho : A := X * X + Y * Y.
Definition gauss_curvature f := dx (dx f) * dy (dy f) - dx (dy f) * dx (dy f).
Definition mean_twice f := laplace f.

(** ** The shape operator *)

(** If the Hessian has the eigenvector (a, b) with the eigenvalue k1 and (-b, a) with k2, a unit vector
    up to an invertible length, its determinant and trace are k1 k2 and k1 + k2. *)
Theorem eq_8_9_curvatures f (a b k1 k2 i : A) :
  (a * a + b * b) * i = 1 ->
  dx (dx f) * a + dx (dy f) * b = k1 * a -> dx (dy f) * a + dy (dy f) * b = k1 * b ->
  dx (dy f) * a - dx (dx f) * b = - (k2 * b) -> dy (dy f) * a - dx (dy f) * b = k2 * a ->
  gauss_curvature f = k1 * k2 /\ mean_twice f = k1 + k2.
Proof.
  unfold gauss_curvature, mean_twice, laplace.
  generalize (dx (dx f)) (dx (dy f)) (dy (dy f)). intros p q r N E1 E2 E3 E4.
  assert (L : forall u v : A, (a * a + b * b) * u = (a * a + b * b) * v -> u = v).
  { intros u v H. transitivity ((a * a + b * b) * i * u); [rewrite N; ring | ].
    transitivity (i * ((a * a + b * b) * u)); [ring | rewrite H].
    transitivity ((a * a + b * b) * i * v); [ring | rewrite N; ring]. }
  split; apply L.
  - transitivity ((p * a + q * b) * (r * a - q * b) - (q * a + r * b) * (q * a - p * b)); [ring | ].
    rewrite E1, E2, E3, E4. ring.
  - transitivity (a * (p * a + q * b) + b * (q * a + r * b) - b * (q * a - p * b) + a * (r * a - q * b)); [ring | ].
    rewrite E1, E2, E3, E4. ring.
Qed.

(** The Gauss image over (f_x, f_y): the derivative of its top view is the Hessian, and its height over
    the plane moves with the gradient as slope, so that its tangent plane is parallel to that of f. *)
Theorem eq_6_gauss_shape f (s : A) :
  s + s = dx f * dx f + dy f * dy f ->
  dx s + dx s = (dx f * dx (dx f) + dy f * dx (dy f)) + (dx f * dx (dx f) + dy f * dx (dy f)) /\
  dy s + dy s = (dx f * dy (dx f) + dy f * dy (dy f)) + (dx f * dy (dx f) + dy f * dy (dy f)).
Proof.
  intro E. split.
  - rewrite <- dx_add, E, dx_add, !dx_mul. ring.
  - rewrite <- dy_add, E, dy_add, !dy_mul. ring.
Qed.

End Rules.

(** Derivatives of sums and products. *)
#[global] Hint Rewrite dx_add dy_add dx_sub dy_sub dx_opp dy_opp dx_mul dy_mul
  dx_X dy_X dx_Y dy_Y dx_zero dy_zero dx_one dy_one : derivatives.
Ltac derive := autorewrite with derivatives.
