(** * Conical vertices

    Planes through a point v that touch a common isotropic cone of revolution, and the balance (14).

    - [cone v m r2]: the points p with (z - v_z - m · h)² = r2 |h|², h = p' - v': the planes through v
      whose i-angle with that of gradient m has the square r2 envelop it;
    - [touches_cone]: the plane meets the cone in a line counted twice;
    - [balance e0 e1 e2 e3]: Im (e0 e2 conj (e1 e3)), a multiple of sin (ω1 + ω3), see Angles.v.

    Statements
    - [conical_cone_touches]: a plane touches the cone iff its gradient lies on the circle around m;
    - [conical_cone]: four planes through v touch one cone iff their gradients are concyclic;
    - [conical_cone_apex], [conical_cone_vertex]: the circumscribed mesh: its planes meet in the point
      over the centre;
    - [eq_14_conical]: gradients jump by w_j J e_j across the edges, and the in-circle determinant of
      four is w0 w1 w2 w3 times the balance;  [eq_14_conical_iff]: (14) modulo π;
    - [eq_14_coplanar_sharp]: two coplanar faces: concyclic, whatever the angles;
    - [eq_13_circular]: in-circle determinant by edges, (13) modulo π.

    Unsaid in the paper: three gradients are not collinear (else a cylinder); adjacent faces are not
    coplanar and no edge is isotropic. *)

From Isogeo.theory Require Export Isotropic.

Section Conical.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (v p : point K) (m g h e x : vec K) (P : plane K).

Definition cone v m (r2 : K) p :=
  let h := (top p - top v)%V in (pz p - pz v - dot m h)² = r2 * ||h||².

(** On a plane through v with the gradient g the cone is the zero set of the form
    ((g - m) · h)² - r2 |h|² in h, of which this is the determinant. *)
Definition cone_form g m (r2 : K) h := (dot (g - m) h)² - r2 * ||h||².
Definition cone_discriminant g m (r2 : K) :=
  let u := (g - m)%V in (vx u * vx u - r2) * (vy u * vy u - r2) - (vx u * vy u) * (vx u * vy u).
Definition touches_cone v m (r2 : K) P := on v P /\ cone_discriminant (slope P) m r2 = 0.

Lemma cone_form_meaning v m (r2 : K) P h :
  on v P -> (cone v m r2 (v + Point h (dot (slope P) h))%P <-> cone_form (slope P) m r2 h = 0).
Proof.
  intros _. unfold cone, cone_form. rewrite <- difference_zero.
  replace ((pz (v + Point h (dot (slope P) h))%P - pz v - dot m (top (v + Point h (dot (slope P) h))%P - top v))²
    - r2 * ||top (v + Point h (dot (slope P) h))%P - top v||²)
  with ((dot (slope P - m) h)² - r2 * ||h||²); [reflexivity | spatial; ring].
Qed.

Theorem conical_cone_touches v m (r2 : K) P :
  r2 <> 0 -> on v P -> (touches_cone v m r2 P <-> ||slope P - m||² = r2).
Proof.
  intros R O. unfold touches_cone, cone_discriminant.
  replace ((vx (slope P - m)%V * vx (slope P - m)%V - r2) * (vy (slope P - m)%V * vy (slope P - m)%V - r2)
    - vx (slope P - m)%V * vy (slope P - m)%V * (vx (slope P - m)%V * vy (slope P - m)%V))
  with (r2 * (r2 - ||slope P - m||²)) by (spatial; ring).
  split.
  - intros [_ Z]. symmetry. apply difference_zero. exact (cancel K r2 _ R Z).
  - intro E. split; [exact O | rewrite E; ring].
Qed.

(** The plane through v with the gradient g. *)
Definition through v g := Plane g (pz v - dot g (top v)).

Lemma through_on v g : on v (through v g).
Proof. unfold through. spatial. ring. Qed.

(** Four planes through v, three of them with gradients that are not collinear. *)
Theorem conical_cone v g0 g1 g2 g3 :
  det (g1 - g0) (g2 - g0) <> 0 -> ||g0 - circumcentre g0 g1 g2||² <> 0 ->
  (incircle g0 g1 g2 g3 = 0 <->
   exists m r2, r2 <> 0 /\
     touches_cone v m r2 (through v g0) /\ touches_cone v m r2 (through v g1) /\
     touches_cone v m r2 (through v g2) /\ touches_cone v m r2 (through v g3)).
Proof.
  intros D R. split.
  - intro I. exists (circumcentre g0 g1 g2), (||g0 - circumcentre g0 g1 g2||²).
    destruct (circumcentre_equidistant g0 g1 g2 D) as [E1 E2].
    assert (E3 := circle_of_incircle g0 g1 g2 g3 D I). cbn zeta in *.
    split; [exact R | ].
    repeat split; try apply through_on;
      apply (conical_cone_touches v _ _ (through v _) R (through_on v _)); cbn; congruence.
  - intros (m & r2 & N & T0 & T1 & T2 & T3).
    apply conical_cone_touches in T0, T1, T2, T3; try assumption; try apply through_on.
    exact (incircle_of_circle m r2 g0 g1 g2 g3 T0 T1 T2 T3).
Qed.

(** The tangent planes of Σ with the gradients g: s lies on one iff g has a certain distance from s'. *)
Theorem conical_cone_apex v g : on v (tangent g) <-> ||g - top v||² = ||top v||² - 2 * pz v.
Proof.
  rewrite <- (difference_zero K (||g - top v||²)).
  replace (||g - top v||² - (||top v||² - 2 * pz v)) with (2 * over (tangent g) v)
    by (spatial; field; nonzero).
  unfold on. split; intro Z; [rewrite Z; ring | apply (cancel K 2); [nonzero | exact Z]].
Qed.

(** So those of a conical vertex meet in one point, over the centre of the circle of gradients. *)
Theorem conical_cone_vertex g0 g1 g2 g3 :
  det (g1 - g0) (g2 - g0) <> 0 ->
  let m := circumcentre g0 g1 g2 in
  let v := Point m ((||m||² - ||g0 - m||²) / 2) in
  on v (tangent g0) /\ on v (tangent g1) /\ on v (tangent g2) /\
  (incircle g0 g1 g2 g3 = 0 -> on v (tangent g3)).
Proof.
  intros D m v. destruct (circumcentre_equidistant g0 g1 g2 D) as [E1 E2]. cbn zeta in *. fold m in E1, E2.
  assert (H : forall g, ||g - m||² = ||g0 - m||² -> on v (tangent g)).
  { intros g E. apply conical_cone_apex. unfold v. cbn [top pz]. rewrite E. field. nonzero. }
  repeat split; try (apply H; auto; fail).
  intro I. apply H. exact (circle_of_incircle g0 g1 g2 g3 D I).
Qed.

(** ** The balance *)

Definition balance e0 e1 e2 e3 := im (cmul (cmul e0 e2) (conj (cmul e1 e3))).

(** (13): sin (α1 + α3) times the lengths of the sides, up to its sign. *)
Theorem eq_13_circular x0 x1 x2 x3 :
  incircle x0 x1 x2 x3 = balance (x1 - x0) (x2 - x1) (x3 - x2) (x0 - x3).
Proof. apply incircle_edges. Qed.

(** Two planes that agree along the direction e: their gradients differ by a multiple of J e. *)
Lemma gradient_jump g g' e : e <> null -> dot g e = dot g' e -> exists w, (g' - g)%V = (w ** J e)%V.
Proof.
  intros N E. apply (parallel_multiple (J e) (g' - g)%V).
  - intro Z. apply N. apply vec_eq.
    + exact (f_equal vy Z).
    + apply opposite_zero. exact (f_equal vx Z).
  - transitivity (dot g e - dot g' e); [coordinates; ring | rewrite E; ring].
Qed.

Theorem eq_14_conical g0 g1 g2 g3 e0 e1 e2 e3 (w0 w1 w2 w3 : K) :
  (g1 - g0 = w0 ** J e0)%V -> (g2 - g1 = w1 ** J e1)%V ->
  (g3 - g2 = w2 ** J e2)%V -> (g0 - g3 = w3 ** J e3)%V ->
  incircle g0 g1 g2 g3 = w0 * w1 * w2 * w3 * balance e0 e1 e2 e3.
Proof.
  intros E0 E1 E2 E3. rewrite incircle_edges, E0, E1, E2, E3. unfold balance. coordinates. ring.
Qed.

(** (14) modulo π: four planes at a vertex with the directions of their edges, g_j and g_(j+1) at e_j. *)
Theorem eq_14_conical_iff g0 g1 g2 g3 e0 e1 e2 e3 :
  e0 <> null -> e1 <> null -> e2 <> null -> e3 <> null ->
  dot g0 e0 = dot g1 e0 -> dot g1 e1 = dot g2 e1 -> dot g2 e2 = dot g3 e2 -> dot g3 e3 = dot g0 e3 ->
  g0 <> g1 -> g1 <> g2 -> g2 <> g3 -> g3 <> g0 ->
  (concyclic_or_collinear g0 g1 g2 g3 <-> balance e0 e1 e2 e3 = 0).
Proof.
  intros N0 N1 N2 N3 A0 A1 A2 A3 D0 D1 D2 D3. unfold concyclic_or_collinear.
  destruct (gradient_jump _ _ _ N0 A0) as [w0 E0], (gradient_jump _ _ _ N1 A1) as [w1 E1],
    (gradient_jump _ _ _ N2 A2) as [w2 E2], (gradient_jump _ _ _ N3 A3) as [w3 E3].
  rewrite (eq_14_conical _ _ _ _ _ _ _ _ _ _ _ _ E0 E1 E2 E3).
  assert (W : forall g g' (w : K) e, g <> g' -> (g' - g)%V = (w ** e)%V -> w <> 0).
  { intros g g' w e D E Z. apply D. symmetry. apply vsub_zero. rewrite E, Z.
    apply vec_eq; coordinates; ring. }
  split; intro Z; [ | rewrite Z; ring].
  apply (cancel K (w0 * w1 * w2 * w3)); [ | exact Z].
  exact (product_nonzero K _ _ (product_nonzero K _ _ (product_nonzero K _ _
    (W _ _ _ _ D0 E0) (W _ _ _ _ D1 E1)) (W _ _ _ _ D2 E2)) (W _ _ _ _ D3 E3)).
Qed.

(** With g0 = g1 every vertex is conical: the balance may be anything, here -1. *)
Theorem eq_14_coplanar_sharp :
  let e0 := Vec 1 0 : vec K in let e1 := Vec 1 1 in let e2 := Vec (- (1)) 0 in let e3 := Vec 0 (- (1)) in
  let g0 := Vec 0 0 in let g2 := J e1 in let g3 := (g2 + J e2)%V in
  dot g0 e0 = dot g0 e0 /\ dot g0 e1 = dot g2 e1 /\ dot g2 e2 = dot g3 e2 /\
  incircle g0 g0 g2 g3 = 0 /\ balance e0 e1 e2 e3 <> 0.
Proof.
  cbn zeta. unfold balance. coordinates. repeat split; try ring.
  intro Z. apply (one_nonzero K), opposite_zero. rewrite <- Z. ring.
Qed.

End Conical.
