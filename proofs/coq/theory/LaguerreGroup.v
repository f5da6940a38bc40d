(** * The Laguerre group

    Maps S to a + R S of oriented spheres, with R bijective, linear and Rᵀ D R = D (Sec. 2.2).

    - [form]: the inner product of R^4, [contact]: oriented contact of spheres;
    - [laguerre L]: L is such a map;  [image_plane a R P]: its action on oriented planes.

    Statements
    - [laguerre_group_composition], [laguerre_group_inverse]: a group;
    - [laguerre_group_contact]: spheres in contact stay so;
    - [laguerre_group_planes]: planes go to planes and tangency is kept;
    - [laguerre_group_moebius]: in the isotropic model points go to points and those of an i-M-sphere to
      those of one: an i-M-transformation;
    - [laguerre_group_offset], [laguerre_group_offset_touch]: offsetting by d is z += d (1 + |x|²)/2;
    - [laguerre_group_sharp]: twice the radius does not keep contact.

    Unsaid in the paper: the image of a plane does not have the normal (0, 0, -1). *)

From Isogeo.theory Require Export Laguerre.

Section Group.
Context {K : Scalar}.
Add Field scalars : (laws K).
Local Notation ball := (@ball K).
Local Notation oriented := (@oriented K).
Implicit Types (P : oriented) (S T : ball).

Definition form S T := dot3 (m S) (m T) - r S * r T.
Definition difference S T := Ball (m S - m T)%P (r S - r T).
Definition sum S T := Ball (m S + m T)%P (r S + r T).
Definition times (k : K) S := Ball (k ** m S)%P (k * r S).
(** Spheres in oriented contact have a common tangent plane at a common point. *)
Definition contact S T := form (difference S T) (difference S T) = 0.
Definition linear (R : ball -> ball) :=
  (forall S T, R (sum S T) = sum (R S) (R T)) /\ (forall k S, R (times k S) = times k (R S)).
(** Rᵀ D R = D. *)
Definition keeps_form (R : ball -> ball) := forall S T, form (R S) (R T) = form S T.
Definition laguerre (L : ball -> ball) :=
  exists (a : ball) R R', linear R /\ keeps_form R /\
    (forall S, R (R' S) = S) /\ (forall S, R' (R S) = S) /\ forall S, L S = sum a (R S).

Ltac in_coordinates := unfold difference, sum, times, form, dot3 in *; cbn [m r] in *.
Ltac componentwise := f_equal; [apply point_eq; [apply vec_eq | ] | ]; cbn; ring.

Lemma difference_times S T : difference S T = sum S (times (- (1)) T).
Proof.
  destruct S as [[[? ?] ?] ?], T as [[[? ?] ?] ?]. unfold difference, sum, times. componentwise.
Qed.

Lemma linear_difference R S T : linear R -> R (difference S T) = difference (R S) (R T).
Proof. intros [A B]. rewrite !difference_times, A, B. reflexivity. Qed.

Lemma difference_translate a S T : difference (sum a S) (sum a T) = difference S T.
Proof.
  destruct a as [[[? ?] ?] ?], S as [[[? ?] ?] ?], T as [[[? ?] ?] ?].
  unfold difference, sum. componentwise.
Qed.

Lemma sum_associative S T U : sum S (sum T U) = sum (sum S T) U.
Proof.
  destruct S as [[[? ?] ?] ?], T as [[[? ?] ?] ?], U as [[[? ?] ?] ?]. unfold sum. componentwise.
Qed.

Theorem laguerre_group_contact L S T : laguerre L -> (contact (L S) (L T) <-> contact S T).
Proof.
  intros (a & R & R' & A & B & _ & _ & C). unfold contact.
  rewrite !C, difference_translate, <- linear_difference, B by exact A. reflexivity.
Qed.

Theorem laguerre_group_composition L M : laguerre L -> laguerre M -> laguerre (fun S => L (M S)).
Proof.
  intros (a & R & R' & [A A'] & B & I & J & C) (b & Q & Q' & [D D'] & E & F & G & H).
  exists (sum a (R b)), (fun S => R (Q S)), (fun S => Q' (R' S)). split; [split | ]; [ | | repeat split].
  - intros S T. rewrite D, A. reflexivity.
  - intros k S. rewrite D', A'. reflexivity.
  - intros S T. rewrite B, E. reflexivity.
  - intro S. rewrite F, I. reflexivity.
  - intro S. rewrite J, G. reflexivity.
  - intro S. rewrite C, H, A, sum_associative. reflexivity.
Qed.

Theorem laguerre_group_inverse L : laguerre L ->
  exists M, laguerre M /\ (forall S, M (L S) = S) /\ (forall S, L (M S) = S).
Proof.
  intros (a & R & R' & [A A'] & B & I & J & C).
  assert (D : forall S T, R' (sum S T) = sum (R' S) (R' T)).
  { intros S T. rewrite <- (J (sum (R' S) (R' T))), A, !I. reflexivity. }
  assert (D' : forall k S, R' (times k S) = times k (R' S)).
  { intros k S. rewrite <- (J (times k (R' S))), A', I. reflexivity. }
  assert (Z : forall X Y, sum (times (- (1)) X) (sum X Y) = Y).
  { intros [[[? ?] ?] ?] [[[? ?] ?] ?]. unfold sum, times. componentwise. }
  assert (Z' : forall X Y, sum X (sum (times (- (1)) X) Y) = Y).
  { intros [[[? ?] ?] ?] [[[? ?] ?] ?]. unfold sum, times. componentwise. }
  exists (fun S => sum (times (- (1)) (R' a)) (R' S)). split; [ | split].
  - exists (times (- (1)) (R' a)), R', R.
    split; [split; [exact D | exact D'] | ]. split; [ | repeat split; auto].
    intros S T. rewrite <- (B (R' S) (R' T)), !I. reflexivity.
  - intro S. rewrite C, D, J. apply Z.
  - intro S. rewrite C, A, A', !I. apply Z'.
Qed.

(** An oriented plane as a vector of length 0: n · m + h = r says that (n, 1) has the product -h with
    (m, r). Its image is divided by its last coordinate. *)
Definition null_vector P := Ball (n P) 1.
Definition image_plane (a : ball) (R : ball -> ball) P :=
  let N := R (null_vector P) in
  Oriented ((1 / r N) ** m N)%P ((h P - form N a) / r N).

Lemma touch_form P S : touch P S <-> form (null_vector P) S + h P = 0.
Proof.
  unfold touch, form, null_vector. cbn [m r]. rewrite <- difference_zero.
  replace (dot3 (n P) (m S) + h P - r S) with (dot3 (n P) (m S) - 1 * r S + h P) by ring. reflexivity.
Qed.

Theorem laguerre_group_planes a R P :
  keeps_form R -> unit P -> r (R (null_vector P)) <> 0 ->
  unit (image_plane a R P) /\
  forall S, touch (image_plane a R P) (sum a (R S)) <-> touch P S.
Proof.
  intros B U N. assert (Z := B (null_vector P) (null_vector P)). split.
  - unfold unit, image_plane in *. cbn zeta. cbn [Laguerre.n].
    assert (E : form (null_vector P) (null_vector P) = 0).
    { unfold form, null_vector. cbn [m r]. rewrite U. ring. }
    rewrite E in Z. destruct (R (null_vector P)) as [q k]. unfold form in Z. cbn [m r] in *.
    transitivity ((dot3 q q - k * k + k * k) / (k * k)).
    + unfold dot3. spatial. field. exact N.
    + rewrite Z. field. exact N.
  - intro S. rewrite !touch_form.
    assert (E : r (R (null_vector P)) *
      (form (null_vector (image_plane a R P)) (sum a (R S)) + h (image_plane a R P)) =
      form (R (null_vector P)) (R S) + h P).
    { unfold image_plane. cbn zeta. generalize dependent (R (null_vector P)). generalize (R S). clear.
      intros [[[x y] z] w] [[[p q] s] k] N _. destruct a as [[[e f] g] b]. cbn [r] in N.
      unfold form, null_vector, sum, dot3. cbn [Laguerre.n Laguerre.h m r]. spatial. field. exact N. }
    rewrite B in E. split; intro T.
    + rewrite <- E, T. ring.
    + apply (cancel K _ _ N). rewrite E. exact T.
Qed.

Theorem laguerre_group_moebius a R P S :
  keeps_form R -> unit P -> r (R (null_vector P)) <> 0 ->
  pz (n P) + 1 <> 0 -> pz (n (image_plane a R P)) + 1 <> 0 ->
  (on_sphere (image (image_plane a R P)) (sphere_of (sum a (R S))) <-> on_sphere (image P) (sphere_of S)).
Proof.
  intros B U N A A'. destruct (laguerre_group_planes a R P B U N) as [U' T].
  rewrite !eq_12_spheres by assumption. apply T.
Qed.

(** The identity with the translation (0, 0, 0, d): each tangent plane moves by d. *)
Definition offset_ball (d : K) S := Ball (m S) (r S + d).
Definition offset_plane (d : K) P := Oriented (n P) (h P + d).

Theorem laguerre_group_offset_touch d P S : touch (offset_plane d P) (offset_ball d S) <-> touch P S.
Proof.
  unfold touch, offset_plane, offset_ball. cbn [n h m r]. rewrite <- !(difference_zero K (dot3 _ _ + _)).
  replace (dot3 (n P) (m S) + (h P + d) - (r S + d)) with (dot3 (n P) (m S) + h P - r S) by ring.
  reflexivity.
Qed.

Theorem laguerre_group_offset d P :
  unit P -> pz (n P) + 1 <> 0 ->
  image (offset_plane d P) =
  Point (top (image P)) (pz (image P) + d * (1 + ||top (image P)||²) / 2).
Proof.
  intros U A. apply point_eq; [reflexivity | ]. destruct P as [[[a b] c] k].
  unfold offset_plane, unit, image, dot3 in *. cbn [Laguerre.n Laguerre.h] in *. spatial.
  assert (E : a² + b² = (1 - c) * (1 + c))
    by (transitivity (a * a + b * b + c * c - c²); [ring | rewrite U; ring]).
  transitivity (k / (c + 1) + d * (1 + (a² + b²) / (c + 1)²) / 2).
  - rewrite E. field. nonzero.
  - field. nonzero.
Qed.

(** Radii times 2: the sphere (0, 1) and the point (1, 0, 0) are in contact, the images are not. *)
Theorem laguerre_group_sharp :
  let S := Ball (Point (Vec 0 0) 0) 1 in let T := Ball (Point (Vec 1 0) 0) (0 : K) in
  let L S := Ball (m S) (2 * r S) in
  (3 : K) <> 0 -> contact S T /\ ~ contact (L S) (L T).
Proof.
  intros S T L N. unfold contact, form, difference, S, T, L, dot3. cbn [m r]. spatial. split; [ring | ].
  intro Z. apply N, opposite_zero. rewrite <- Z. ring.
Qed.

End Group.
