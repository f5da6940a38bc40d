(** * Angles

    (13) and (14) with real angles: the last step from the identities modulo π of Conical.v. Edges are
    given by lengths and polar angles, l (cos φ, sin φ) with l > 0.

    - [polar l phi]: that vector; [polar_exists]: every vector but 0 is one, with φ between -π and π.

    Statements
    - [eq_14_conical_sine]: the balance of a star is the product of the lengths times -sin (ω0 + ω2);
    - [eq_14_conical_angles]: edges in cyclic order: balanced iff ω0 + ω2 = ω1 + ω3 = π, so with
      Conical.v iff the four planes are those of a cone;
    - [eq_14_conical_angles_sharp]: an i-conical star with one edge turned around has ω1 + ω3 != π;
    - [eq_13_circular_angles]: a convex quad has opposite angles that add up to π iff it is concyclic.

    Unsaid in the paper: in (14) the edges are in cyclic order in the top view, in (13) the quad is
    embedded and convex. *)

From Isogeo.theory Require Export Real Conical.

Local Open Scope R_scope.

Definition polar (l phi : R) : vec Reals := @Vec Reals (l * cos phi)%R (l * sin phi)%R.

Lemma polar_exists (a : vec Reals) :
  a <> null -> exists l phi, 0 < l /\ - PI <= phi <= PI /\ a = polar l phi.
Proof.
  intro N. destruct a as [x y].
  assert (Q : 0 < x * x + y * y).
  { destruct (Req_dec x 0) as [X | X].
    - destruct (Req_dec y 0) as [Y | Y]; [exfalso; apply N; rewrite X, Y; reflexivity | nra].
    - nra. }
  set (l := sqrt (x * x + y * y)).
  assert (L : 0 < l) by (apply sqrt_lt_R0, Q).
  assert (S : l * l = x * x + y * y) by (apply sqrt_sqrt; lra).
  assert (X1 : x <= l) by (destruct (Rle_or_lt x l); [assumption | exfalso; nra]).
  assert (X2 : - l <= x) by (destruct (Rle_or_lt (- l) x); [assumption | exfalso; nra]).
  assert (E : x / l * l = x) by (field; lra).
  assert (D : -1 <= x / l <= 1) by (split; apply (Rmult_le_reg_r l); lra).
  assert (G : continuity (fun t => cos t - x / l)).
  { intro t. apply continuity_pt_minus; [apply continuity_cos | apply continuity_pt_const].
    intros u v. reflexivity. }
  destruct (IVT_cor (fun t => cos t - x / l) 0 PI G) as (phi & B & Z).
  { apply Rlt_le, PI_RGT_0. }
  { cbv beta. rewrite cos_0, cos_PI. nra. }
  assert (C : l * cos phi = x) by (replace (cos phi) with (x / l) by lra; lra).
  assert (P : 0 <= l * sin phi) by (apply Rmult_le_pos; [lra | apply sin_ge_0; lra]).
  assert (M : (l * sin phi) * (l * sin phi) = y * y).
  { assert (U := sin2_cos2 phi). unfold Rsqr in U.
    transitivity (l * l * (sin phi * sin phi + cos phi * cos phi) - (l * cos phi) * (l * cos phi)); [ring | ].
    rewrite U, C. lra. }
  destruct (Rle_or_lt 0 y) as [Y | Y].
  - exists l, phi. split; [exact L | split; [lra | ]].
    assert (E' : l * sin phi = y) by nra. unfold polar. rewrite C, E'. reflexivity.
  - exists l, (- phi). split; [exact L | split; [lra | ]].
    assert (E' : l * sin phi = - y) by nra.
    unfold polar. rewrite cos_neg, sin_neg, C. f_equal. cbn. lra.
Qed.

(** The only zero of the sine between 0 and 2π. *)
Lemma sine_zero (x : R) : 0 < x < 2 * PI -> (sin x = 0 <-> x = PI).
Proof.
  intros [A B]. split; [intro Z | intros ->; exact sin_PI].
  destruct (Rtotal_order x PI) as [L | [E | L]]; [ | exact E | ].
  - assert (G := sin_gt_0 x A L). lra.
  - assert (G := sin_lt_0 x L B). lra.
Qed.

Lemma balance_sine (l0 l1 l2 l3 a0 a1 a2 a3 : R) :
  balance (polar l0 a0) (polar l1 a1) (polar l2 a2) (polar l3 a3) =
  - (l0 * l1 * l2 * l3 * sin ((a1 - a0) + (a3 - a2))).
Proof.
  replace ((a1 - a0) + (a3 - a2)) with ((a1 + a3) - (a0 + a2)) by ring.
  rewrite sin_minus, !sin_plus, !cos_plus.
  unfold balance, polar. real_in. ring.
Qed.

Section Star.
Variables l0 l1 l2 l3 a0 a1 a2 a3 : R.
Hypothesis lengths : 0 < l0 /\ 0 < l1 /\ 0 < l2 /\ 0 < l3.

Let omega0 := a1 - a0.
Let omega1 := a2 - a1.
Let omega2 := a3 - a2.
Let omega3 := a0 + 2 * PI - a3.

Theorem eq_14_conical_sine :
  balance (polar l0 a0) (polar l1 a1) (polar l2 a2) (polar l3 a3) =
  - (l0 * l1 * l2 * l3 * sin (omega0 + omega2)).
Proof. apply balance_sine. Qed.

Lemma lengths_product : l0 * l1 * l2 * l3 <> 0.
Proof.
  destruct lengths as (A & B & C & D).
  apply Rgt_not_eq. repeat apply Rmult_lt_0_compat; assumption.
Qed.

Lemma balance_zero : balance (polar l0 a0) (polar l1 a1) (polar l2 a2) (polar l3 a3) = 0 <->
  sin (omega0 + omega2) = 0.
Proof.
  rewrite eq_14_conical_sine. split; intro Z.
  - assert (P : l0 * l1 * l2 * l3 * sin (omega0 + omega2) = 0) by lra.
    apply Rmult_integral in P. destruct P as [P | P]; [ | exact P]. destruct (lengths_product P).
  - rewrite Z. real_in. ring.
Qed.

Theorem eq_14_conical_angles :
  a0 < a1 < a2 -> a2 < a3 < a0 + 2 * PI ->
  (balance (polar l0 a0) (polar l1 a1) (polar l2 a2) (polar l3 a3) = 0 <->
   omega0 + omega2 = PI /\ omega1 + omega3 = PI).
Proof.
  intros A B. rewrite balance_zero, sine_zero; unfold omega0, omega1, omega2, omega3; [ | lra].
  split; [intro Z; split; lra | intros [Z _]; exact Z].
Qed.

End Star.

(** The four edges at the angles 0, π/2, π, 3π/2 are balanced; with the second turned around, to -π/2,
    the balance is still 0, but the angles of neighbours are -π/2, 3π/2, π/2, π/2. *)
Theorem eq_14_conical_angles_sharp :
  balance (polar 1 0) (polar 1 (- (PI / 2))) (polar 1 PI) (polar 1 (PI / 2 + PI)) = 0 /\
  (- (PI / 2) - 0) + ((PI / 2 + PI) - PI) <> PI.
Proof.
  split.
  - rewrite balance_sine.
    replace (- (PI / 2) - 0 + (PI / 2 + PI - PI)) with 0 by lra. rewrite sin_0. real_in. ring.
  - assert (P := PI_RGT_0). lra.
Qed.

(** ** Convex quads

    Sides with polar angles that turn left by τ_j between 0 and π, once around; the inner angle at the
    corner between the sides j and j + 1 is π - τ_j. *)

Section Quad.
Variables x0 x1 x2 x3 : vec Reals.
Variables l0 l1 l2 l3 a0 a1 a2 a3 : R.
Hypothesis lengths : 0 < l0 /\ 0 < l1 /\ 0 < l2 /\ 0 < l3.
Hypothesis side0 : (x1 - x0)%V = polar l0 a0.
Hypothesis side1 : (x2 - x1)%V = polar l1 a1.
Hypothesis side2 : (x3 - x2)%V = polar l2 a2.
Hypothesis side3 : (x0 - x3)%V = polar l3 a3.
Hypothesis convex : 0 < a1 - a0 < PI /\ 0 < a2 - a1 < PI /\ 0 < a3 - a2 < PI /\ 0 < a0 + 2 * PI - a3 < PI.

Let alpha1 := PI - (a1 - a0).
Let alpha2 := PI - (a2 - a1).
Let alpha3 := PI - (a3 - a2).
Let alpha0 := PI - (a0 + 2 * PI - a3).

Theorem eq_13_circular_angles :
  incircle x0 x1 x2 x3 = 0 <-> alpha1 + alpha3 = PI /\ alpha0 + alpha2 = PI.
Proof.
  rewrite eq_13_circular, side0, side1, side2, side3.
  rewrite (balance_zero _ _ _ _ _ _ _ _ lengths), sine_zero by lra.
  unfold alpha0, alpha1, alpha2, alpha3. split; [intro Z; split; lra | intros [Z _]; lra].
Qed.

End Quad.
