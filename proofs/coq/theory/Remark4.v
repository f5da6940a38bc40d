(** * Biharmonic graphs: Remark 4

    For functions as in Differential.v: rho = x² + y², inversion at the unit cylinder.

    - [biharmonic f]: Δ Δ f = 0;
    - [Inversion]: an inverse i of rho, and the composition c with (x, y) to (x, y)/rho, given by the
      chain rule.

    Statements
    - [remark_4_product]: rho g is biharmonic for harmonic g;
    - [remark_4_inversion]: Δ (c f) = i² c (Δ f), so inversions keep harmonic functions;
    - [remark_4]: the inverted graph, rho c f, of a harmonic f is biharmonic;
    - [remark_4_mirror]: so is 2 S - f for an i-M-sphere S;
    - [remark_4_sharp]: for f = x² the product rho f is not: Δ Δ of it is 32. *)

From Isogeo.theory Require Export Differential.

Section Airy.
Variable A : Functions.
Add Ring functions : (ring_laws A).
Implicit Types f g : A.

Definition biharmonic f := laplace A (laplace A f) = 0.

(** Second derivatives in one order. *)
Ltac order := rewrite ?(commute A) in *.

Lemma laplace_rho g :
  laplace A (rho A * g) =
  (1 + 1 + 1 + 1) * g + (1 + 1 + 1 + 1) * (X * dx g + Y * dy g) + rho A * laplace A g.
Proof. unfold laplace, rho. derive. ring. Qed.

Lemma laplace_euler g :
  laplace A (X * dx g + Y * dy g) =
  (1 + 1) * laplace A g + (X * dx (laplace A g) + Y * dy (laplace A g)).
Proof. unfold laplace. derive. order. derive. order. ring. Qed.

Lemma laplace_add f g : laplace A (f + g) = laplace A f + laplace A g.
Proof. unfold laplace. derive. ring. Qed.

Lemma laplace_four g : laplace A ((1 + 1 + 1 + 1) * g) = (1 + 1 + 1 + 1) * laplace A g.
Proof. unfold laplace. derive. ring. Qed.

Theorem remark_4_product g : laplace A g = 0 -> biharmonic (rho A * g).
Proof.
  intro H. unfold biharmonic. rewrite laplace_rho, H.
  replace (rho A * 0) with (0 : A) by ring.
  rewrite !laplace_add, !laplace_four, laplace_euler, H.
  unfold laplace. derive. ring.
Qed.

(** The inversion (x, y) to (x, y)/rho: composition with it is a map of functions. *)
Record Inversion := MakeInversion {
  i : A;
  c : A -> A;
  i_rho : i * rho A = 1;
  c_add : forall f g, c (f + g) = c f + c g;
  chain_x : forall f, dx (c f) = dx (X * i) * c (dx f) + dx (Y * i) * c (dy f);
  chain_y : forall f, dy (c f) = dy (X * i) * c (dx f) + dy (Y * i) * c (dy f)
}.

Section Inverted.
Variable I : Inversion.

Lemma dx_i : dx (i I) = - (1 + 1) * X * (i I * i I).
Proof.
  assert (E : dx (i I) * rho A + i I * (X + X) = 0).
  { transitivity (dx (i I * rho A)); [unfold rho; derive; ring | rewrite i_rho; derive; ring]. }
  transitivity ((dx (i I) * rho A + i I * (X + X)) * i I - i I * i I * (X + X)
    + dx (i I) * (1 - i I * rho A)); [ring | ].
  rewrite E, i_rho. ring.
Qed.

Lemma dy_i : dy (i I) = - (1 + 1) * Y * (i I * i I).
Proof.
  assert (E : dy (i I) * rho A + i I * (Y + Y) = 0).
  { transitivity (dy (i I * rho A)); [unfold rho; derive; ring | rewrite i_rho; derive; ring]. }
  transitivity ((dy (i I) * rho A + i I * (Y + Y)) * i I - i I * i I * (Y + Y)
    + dy (i I) * (1 - i I * rho A)); [ring | ].
  rewrite E, i_rho. ring.
Qed.

(** The Jacobian of the inversion: (y² - x², -2xy; -2xy, x² - y²)/rho². *)
Let a := (Y * Y - X * X) * (i I * i I).
Let b := - (1 + 1) * X * Y * (i I * i I).

Lemma jacobian : dx (X * i I) = a /\ dx (Y * i I) = b /\ dy (X * i I) = b /\ dy (Y * i I) = - a.
Proof.
  unfold a, b. assert (R := i_rho I). unfold rho in R. repeat split; derive; rewrite ?dx_i, ?dy_i.
  - transitivity (i I * (i I * (X * X + Y * Y)) - (1 + 1) * (X * X) * (i I * i I)); [rewrite R; ring | ring].
  - ring.
  - ring.
  - transitivity (i I * (i I * (X * X + Y * Y)) - (1 + 1) * (Y * Y) * (i I * i I)); [rewrite R; ring | ring].
Qed.

Theorem remark_4_inversion f : laplace A (c I f) = i I * i I * c I (laplace A f).
Proof.
  destruct jacobian as (J1 & J2 & J3 & J4). assert (R := i_rho I). unfold rho in R.
  unfold laplace. rewrite chain_x, chain_y, J1, J2, J3, J4. rewrite c_add.
  derive. rewrite !chain_x, !chain_y, J1, J2, J3, J4, !(commute A).
  assert (Da : dx a + dy b = 0).
  { unfold a, b. derive. rewrite !dx_i, !dy_i. 
    transitivity ((1 + 1 + 1 + 1) * X * (i I * i I) * (i I * (X * X + Y * Y) - 1)); [ring | rewrite R; ring]. }
  assert (Db : dx b - dy a = 0).
  { unfold a, b. derive. rewrite !dx_i, !dy_i.
    transitivity ((1 + 1 + 1 + 1) * Y * (i I * i I) * (i I * (X * X + Y * Y) - 1)); [ring | rewrite R; ring]. }
  assert (N : a * a + b * b = i I * i I).
  { unfold a, b. transitivity (i I * i I * ((i I * (X * X + Y * Y)) * (i I * (X * X + Y * Y)))); [ring | ].
    rewrite R. ring. }
  clearbody a b.
  transitivity ((dx a + dy b) * c I (dx f) + (dx b - dy a) * c I (dy f)
    + (a * a + b * b) * (c I (dx (dx f)) + c I (dy (dy f)))).
  - ring.
  - rewrite Da, Db, N. ring.
Qed.

(** z = f goes to z = rho (c f): points (x, z) to (x, z)/rho. *)
Theorem remark_4 f : laplace A f = 0 -> biharmonic (rho A * c I f).
Proof.
  intro H. apply remark_4_product. rewrite remark_4_inversion, H.
  assert (Z : c I 0 = 0).
  { apply (cancel_add A (c I 0)). rewrite <- c_add. f_equal. ring. }
  rewrite Z. ring.
Qed.

End Inverted.

(** An i-M-sphere a rho + b x + c y + d with constants, and twice of it minus f. *)
Theorem remark_4_mirror f (k b c d : A) :
  dx k = 0 -> dy k = 0 -> dx b = 0 -> dy b = 0 -> dx c = 0 -> dy c = 0 -> dx d = 0 -> dy d = 0 ->
  laplace A f = 0 ->
  biharmonic (k * rho A + b * X + c * Y + d - f).
Proof.
  intros K1 K2 B1 B2 C1 C2 D1 D2 H. unfold biharmonic.
  assert (E : laplace A (k * rho A + b * X + c * Y + d - f) = (1 + 1 + 1 + 1) * k - laplace A f).
  { unfold laplace, rho. derive. rewrite ?K1, ?K2, ?B1, ?B2, ?C1, ?C2, ?D1, ?D2. derive.
    rewrite ?K1, ?K2, ?B1, ?B2, ?C1, ?C2, ?D1, ?D2. derive. ring. }
  rewrite E, H. unfold laplace. derive. rewrite K1, K2. derive. ring.
Qed.

(** A function that is not harmonic. *)
Theorem remark_4_sharp :
  laplace A (laplace A (rho A * (X * X))) = (1 + 1) * (1 + 1) * (1 + 1) * (1 + 1 + 1 + 1).
Proof.
  assert (E : laplace A (X * X) = 1 + 1) by (unfold laplace; derive; ring).
  rewrite laplace_rho, E. derive. unfold laplace, rho. derive. ring.
Qed.

End Airy.
