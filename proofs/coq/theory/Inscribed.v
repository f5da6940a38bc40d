(** * Inscribed parallel meshes: Theorem 1

    A mesh with edges parallel to those of M and vertices on Σ is made step by step: from a point of Σ
    along the direction of an edge to the other point of Σ on that line.

    - [step g e x]: the top view of a step along the edge e of a plane with the gradient g, from over x;
    - [walk g v x j]: j steps along the polygon v.

    Statements
    - [thm_1_f_step]: the other point of Σ is the step;  [thm_1_f_mirror]: its top view is the mirror
      image at the line through g across e;  [thm_1_f_edge]: it is the same for both faces of the edge;
    - [thm_1_f_defect]: around a quad the steps miss the start by (2 Im w / |w|²) i w (x - g),
      w = e1 e3 conj (e0 e2), [thm_1_f_defect_incircle]: -Im w is the in-circle determinant;
    - [thm_1_f_quad_closes], [thm_1_f_quad_closes_only]: so it closes iff the quad is concyclic;
    - [thm_1_f_closes]: every inscribed polygon with an even number of corners closes;
    - [thm_1_f_odd]: with an odd number it closes from one line of starting points only;
    - [thm_1_converse]: a quad parallel to an inscribed one without edges of length 0 is concyclic;
      [thm_1_converse_sharp]: any quad is parallel to a point of Σ;
    - [thm_1_v]: four points of Σ are coplanar iff their top views are concyclic or collinear,
      [thm_1_v_only]: only the lift has its vertices on Σ over given top views.

    Unsaid in the paper: edges have a length; faces have an even number of sides; the start does not
    lie over g; M is simply connected (no statement here goes around a hole). *)

From Isogeo.theory Require Export Isotropic Sums.

Definition step {K : Scalar} (g e x : vec K) : vec K := (x + (2 * dot (g - x) e / ||e||²) ** e)%V.

Fixpoint walk {K : Scalar} (g : vec K) (v : nat -> vec K) (x : vec K) (j : nat) : vec K :=
  match j with O => x | S i => step g (v (S i) - v i) (walk g v x i) end.

Section Steps.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (g e x y z m : vec K) (v : nat -> vec K).

Theorem thm_1_f_step g e x (r : K) :
  ||e||² <> 0 ->
  (on_sigma (lift x + r ** Point e (dot g e))%P <-> r = 0 \/ (x + r ** e)%V = step g e x).
Proof.
  intro N.
  assert (H : 2 * over_sigma (lift x + r ** Point e (dot g e))%P = r * (2 * dot (g - x) e - r * ||e||²))
    by (spatial; field; nonzero).
  unfold on_sigma. split.
  - intro Z. rewrite Z in H.
    destruct (product_zero K r (2 * dot (g - x) e - r * ||e||²)) as [R | R];
      [rewrite <- H; ring | left; exact R | right].
    assert (E : r = 2 * dot (g - x) e / ||e||²).
    { apply (equals_by K ||e||²); [exact N | ]. symmetry. apply difference_zero. rewrite <- R.
      field. exact N. }
    unfold step. rewrite <- E. reflexivity.
  - intro D. apply (cancel K 2); [nonzero | ]. rewrite H. destruct D as [-> | E]; [ring | ].
    assert (R : r * ||e||² = 2 * dot (g - x) e).
    { transitivity (dot ((x + r ** e) - x) e); [coordinates; ring | ].
      rewrite E. unfold step. coordinates. field. exact N. }
    rewrite R. ring.
Qed.

(** A mirror image: the distance to g is kept, and so is the point if it lies on the mirror. *)
Theorem thm_1_f_mirror g e x :
  ||e||² <> 0 ->
  ||step g e x - g||² = ||x - g||² /\ step g e (step g e x) = x /\
  (dot (x - g) e = 0 -> step g e x = x).
Proof.
  intro N. unfold step. split; [coordinates; field; exact N | split].
  - apply vec_eq; coordinates; field; exact N.
  - intro Z. replace (2 * dot (g - x) e / ||e||²) with (0 : K).
    + apply vec_eq; coordinates; ring.
    + symmetry. apply quotient_zero; [exact N | ].
      transitivity (- (2) * dot (x - g) e); [coordinates; ring | rewrite Z; ring].
Qed.

Theorem thm_1_f_edge g g' e x : dot g e = dot g' e -> step g e x = step g' e x.
Proof.
  intro H. unfold step. replace (dot (g - x) e) with (dot (g' - x) e); [reflexivity | ].
  transitivity (dot g' e - dot x e); [coordinates; ring | rewrite <- H; coordinates; ring].
Qed.

(** A step with complex numbers: y goes to -(e/|e|)² conj y, y = x - g. *)
Lemma step_complex g e x :
  ||e||² <> 0 -> (||e||² ** (step g e x - g))%V = vopp (cmul (cmul e e) (conj (x - g))).
Proof. intro N. unfold step. apply vec_eq; coordinates; field; exact N. Qed.

(** ** Quads *)

Definition around g e0 e1 e2 e3 x := step g e3 (step g e2 (step g e1 (step g e0 x))).

Lemma two_steps g e f x :
  ||e||² <> 0 -> ||f||² <> 0 ->
  (step g f (step g e x) - g)%V =
  ((1 / (||e||² * ||f||²)) ** cmul (cmul (cmul f f) (conj (cmul e e))) (x - g))%V.
Proof. intros N M. unfold step. apply vec_eq; coordinates; field; nonzero. Qed.

Lemma norm2_cmul x y : ||cmul x y||² = ||x||² * ||y||².
Proof. coordinates. ring. Qed.

Theorem thm_1_f_defect g e0 e1 e2 e3 x :
  ||e0||² <> 0 -> ||e1||² <> 0 -> ||e2||² <> 0 -> ||e3||² <> 0 ->
  let w := cmul (cmul e1 e3) (conj (cmul e0 e2)) in
  around g e0 e1 e2 e3 x = (x + (2 * im w / ||w||²) ** J (cmul w (x - g)))%V.
Proof.
  intros N0 N1 N2 N3 w. set (y := (x - g)%V).
  assert (A : (around g e0 e1 e2 e3 x - g)%V =
    ((1 / (||e2||² * ||e3||²)) ** cmul (cmul (cmul e3 e3) (conj (cmul e2 e2)))
      ((1 / (||e0||² * ||e1||²)) ** cmul (cmul (cmul e1 e1) (conj (cmul e0 e0))) y))%V)
    by (unfold around, y; rewrite two_steps, two_steps by assumption; reflexivity).
  assert (Nw : ||w||² = ||e0||² * ||e1||² * (||e2||² * ||e3||²)) by (unfold w; coordinates; ring).
  assert (B : cmul (cmul (cmul e3 e3) (conj (cmul e2 e2))) (cmul (cmul (cmul e1 e1) (conj (cmul e0 e0))) y)
    = cmul (cmul w w) y) by (unfold w; apply vec_eq; coordinates; ring).
  assert (C : (around g e0 e1 e2 e3 x - g)%V = ((1 / ||w||²) ** cmul (cmul w w) y)%V).
  { rewrite A, Nw, <- B.
    generalize (cmul (cmul e3 e3) (conj (cmul e2 e2))) (cmul (cmul (cmul e1 e1) (conj (cmul e0 e0))) y).
    revert N0 N1 N2 N3. clear. generalize (||e0||²) (||e1||²) (||e2||²) (||e3||²).
    intros n0 n1 n2 n3 N0 N1 N2 N3 a b. apply vec_eq; coordinates; field; nonzero. }
  assert (D : ||w||² <> 0) by (rewrite Nw; nonzero).
  clear A B Nw N0 N1 N2 N3.
  transitivity ((around g e0 e1 e2 e3 x - g) + g)%V; [apply vec_eq; coordinates; ring | ].
  rewrite C. unfold y. clear C y. revert D. generalize w. clear. intros w D.
  apply vec_eq; coordinates; field; exact D.
Qed.

Theorem thm_1_f_defect_incircle a b c d :
  im (cmul (cmul (c - b) (a - d)) (conj (cmul (b - a) (d - c)))) = - incircle (a : vec K) b c d.
Proof. coordinates. ring. Qed.

Theorem thm_1_f_quad_closes g a b c d x :
  ||b - a||² <> 0 -> ||c - b||² <> 0 -> ||d - c||² <> 0 -> ||a - d||² <> 0 ->
  incircle a b c d = 0 -> around g (b - a) (c - b) (d - c) (a - d) x = x.
Proof.
  intros N0 N1 N2 N3 I. rewrite (thm_1_f_defect g _ _ _ _ x N0 N1 N2 N3), thm_1_f_defect_incircle, I.
  set (w := cmul _ _).
  assert (N : ||w||² <> 0) by (unfold w; rewrite !norm2_cmul;
    replace (||conj (cmul (b - a) (d - c))||²) with (||b - a||² * ||d - c||²)
      by (coordinates; ring); nonzero).
  clearbody w. apply vec_eq; coordinates; field; exact N.
Qed.

Theorem thm_1_f_quad_closes_only g a b c d x :
  ||b - a||² <> 0 -> ||c - b||² <> 0 -> ||d - c||² <> 0 -> ||a - d||² <> 0 ->
  ||x - g||² <> 0 -> around g (b - a) (c - b) (d - c) (a - d) x = x -> incircle a b c d = 0.
Proof.
  intros N0 N1 N2 N3 X E. rewrite (thm_1_f_defect g _ _ _ _ x N0 N1 N2 N3), thm_1_f_defect_incircle in E.
  set (w := cmul _ _) in E.
  assert (N : ||w||² <> 0) by (unfold w; rewrite !norm2_cmul;
    replace (||conj (cmul (b - a) (d - c))||²) with (||b - a||² * ||d - c||²)
      by (coordinates; ring); nonzero).
  assert (Z : ((2 * - incircle a b c d / ||w||²) ** J (cmul w (x - g)))%V = null).
  { transitivity ((x + (2 * - incircle a b c d / ||w||²) ** J (cmul w (x - g))) - x)%V;
      [ | rewrite E]; apply vec_eq; coordinates; ring. }
  assert (Y : ||(2 * - incircle a b c d / ||w||²) ** J (cmul w (x - g))||² = (0 : K))
    by (rewrite Z; coordinates; ring).
  apply opposite_zero. apply (cancel K 2); [nonzero | ].
  set (i := 2 * - incircle a b c d) in *. clearbody i.
  assert (W : i * i * (||x - g||² / ||w||²) = 0).
  { rewrite <- Y. clear - N. clearbody w. coordinates. field. exact N. }
  destruct (product_zero K _ _ W) as [I | I].
  - destruct (product_zero K _ _ I); assumption.
  - apply quotient_zero in I; [contradiction | exact N].
Qed.

(** ** Inscribed polygons with any number of corners *)

Section Polygon.
Variables (g m : vec K) (r2 : K) (v : nat -> vec K) (x : vec K).
Hypothesis circle : forall j, ||v j - m||² = r2.
Hypothesis edges : forall j, ||v (S j) - v j||² <> 0.

(** What is turned to and fro. *)
Let q (j : nat) := cmul (conj (v j - m)) (walk g v x j - g).

Lemma walk_alternates j : q (S j) = conj (q j).
Proof.
  unfold q. cbn [walk]. assert (N := edges j). assert (A := circle j). assert (B := circle (S j)).
  set (y := walk g v x j). set (a := v (S j)) in *. set (b := v j) in *. clearbody y a b.
  assert (C : ||a - m||² - ||b - m||² = 0) by (rewrite A, B; ring). clear A B.
  set (e := (a - b)%V) in *.
  assert (G : (||e||² ** (cmul (conj (a - m)) (step g e y - g) - conj (cmul (conj (b - m)) (y - g))))%V
    = null).
  { transitivity (- (||a - m||² - ||b - m||²) ** cmul e (conj (y - g)))%V.
    - unfold step. apply vec_eq; unfold e in *; coordinates; field; exact N.
    - rewrite C. apply vec_eq; coordinates; ring. }
  apply vsub_zero. revert G. generalize (cmul (conj (a - m)) (step g e y - g) - conj (cmul (conj (b - m)) (y - g)))%V.
  intros u G. apply vec_eq; apply (cancel K (||e||²)); try exact N.
  - exact (f_equal vx G).
  - exact (f_equal vy G).
Qed.

Lemma conj_conj (y : vec K) : conj (conj y) = y.
Proof. apply vec_eq; coordinates; ring. Qed.

Lemma walk_even n : q (n + n) = q O.
Proof.
  induction n as [ | n IH]; [reflexivity | ].
  rewrite Nat.add_succ_r. cbn [Nat.add]. rewrite !walk_alternates, conj_conj. exact IH.
Qed.

Lemma walk_closed k : r2 <> 0 -> closed k v -> (q k = q O <-> walk g v x k = x).
Proof.
  intros R C. unfold q. cbn [walk]. rewrite C. split; [ | intros ->; reflexivity].
  intro E. apply vsub_zero.
  assert (A := circle O). set (z := (v O - m)%V) in *. clearbody z.
  assert (B : (r2 ** (walk g v x k - x))%V = null).
  { transitivity (cmul z (cmul (conj z) (walk g v x k - g) - cmul (conj z) (x - g)))%V.
    - rewrite <- A. apply vec_eq; coordinates; ring.
    - rewrite E. apply vec_eq; coordinates; ring. }
  apply vec_eq; apply (cancel K r2); try exact R.
  - exact (f_equal vx B).
  - exact (f_equal vy B).
Qed.

Theorem thm_1_f_closes n : r2 <> 0 -> closed (n + n) v -> walk g v x (n + n) = x.
Proof. intros R C. apply walk_closed, walk_even; assumption. Qed.

Theorem thm_1_f_odd n :
  r2 <> 0 -> closed (S (n + n)) v -> (walk g v x (S (n + n)) = x <-> parallel (v O - m) (x - g)).
Proof.
  intros R C. rewrite <- walk_closed, walk_alternates, walk_even by assumption. unfold q. cbn [walk].
  unfold parallel. set (z := (v O - m)%V). set (y := (x - g)%V). split; intro E.
  - assert (B := f_equal vy E). clear - B. apply opposite_zero, (cancel K 2); [nonzero | ].
    coordinates. cbn [vx vy] in B.
    transitivity (- (vx z * vy y + - vy z * vx y) - (vx z * vy y + - vy z * vx y)); [ring | ].
    rewrite B. ring.
  - apply vec_eq; coordinates; [ring | ].
    transitivity (- (vx z * vy y - vy z * vx y)); [ring | ]. rewrite E.
    transitivity (vx z * vy y - vy z * vx y); [rewrite E | ]; ring.
Qed.

End Polygon.

(** ** The converse *)

(** A quad of Σ in a plane: its corners have one distance from the gradient. *)
Lemma planar_inscribed_concyclic g (t : K) a b c d :
  on (lift a) (Plane g t) -> on (lift b) (Plane g t) ->
  on (lift c) (Plane g t) -> on (lift d) (Plane g t) -> incircle a b c d = 0.
Proof.
  rewrite !section_circle. cbn [slope level].
  exact (incircle_of_circle g (||g||² + 2 * t) a b c d).
Qed.

Theorem thm_1_converse (a b c d p q r s : vec K) g t :
  on (lift p) (Plane g t) -> on (lift q) (Plane g t) ->
  on (lift r) (Plane g t) -> on (lift s) (Plane g t) ->
  (q - p)%V <> null -> (r - q)%V <> null -> (s - r)%V <> null -> (p - s)%V <> null ->
  parallel (q - p) (b - a) -> parallel (r - q) (c - b) ->
  parallel (s - r) (d - c) -> parallel (p - s) (a - d) ->
  incircle a b c d = 0.
Proof.
  intros Hp Hq Hr Hs N0 N1 N2 N3 P0 P1 P2 P3.
  assert (I := planar_inscribed_concyclic g t p q r s Hp Hq Hr Hs).
  destruct (parallel_multiple _ _ N0 P0) as [l0 E0], (parallel_multiple _ _ N1 P1) as [l1 E1],
    (parallel_multiple _ _ N2 P2) as [l2 E2], (parallel_multiple _ _ N3 P3) as [l3 E3].
  rewrite incircle_edges in *. rewrite E0, E1, E2, E3.
  transitivity (l0 * l1 * l2 * l3 * im (cmul (cmul (q - p) (s - r)) (conj (cmul (r - q) (p - s))))).
  - coordinates. ring.
  - rewrite I. ring.
Qed.

Theorem thm_1_converse_sharp (x : vec K) (a b c d : vec K) :
  let s := lift x in on_sigma s /\
  parallel (top s - top s) (b - a) /\ parallel (top s - top s) (c - b) /\
  parallel (top s - top s) (d - c) /\ parallel (top s - top s) (a - d).
Proof. cbn. spatial. repeat split; ring. Qed.

(** ** Lifts *)

Theorem thm_1_v_volume a b c d :
  2 * volume (lift b - lift a) (lift c - lift a) (lift d - lift a) = incircle (a : vec K) b c d.
Proof. spatial. field. nonzero. Qed.

Theorem thm_1_v a b c d : coplanar (lift a) (lift b) (lift c) (lift d) <-> concyclic_or_collinear (a : vec K) b c d.
Proof.
  unfold coplanar, concyclic_or_collinear. rewrite <- thm_1_v_volume. split; intro E.
  - rewrite E. ring.
  - apply (cancel K 2); [nonzero | exact E].
Qed.

Theorem thm_1_v_only (p : point K) : on_sigma p -> p = lift (top p).
Proof. apply on_sigma_lift. Qed.

End Steps.
