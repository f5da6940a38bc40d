(** * Isotropic Moebius inversions

    Inversions at i-M-spheres and at i-spheres of cylindrical type (Sec. 2.1).

    - [mirror S]: the inversion at the i-M-sphere S, (x, z) to (x, 2 S(x) - z);
    - [invert c k]: that at the cylinder of squared radius k about the centre c on its axis;
    - [mirror_sphere], [invert_sphere]: the images of an i-M-sphere.

    Statements
    - [moebius_parabolic], [moebius_parabolic_spheres], [moebius_parabolic_circles];
    - [moebius_cylindrical], [moebius_cylindrical_center], [moebius_cylindrical_spheres],
      [moebius_cylindrical_circles]: involution, collinear with the centre, spheres, circles;
    - [moebius_cylindrical_sharp]: a circle through the centre: its image has a collinear top view.

    Unsaid in the paper: points lie off the axis, circles do not pass through the centre. *)

From Isogeo.theory Require Export Isotropic.

Section Moebius.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (S T : sphere K) (p c : point K) (k : K) (m : vec K).

Definition mirror S p := Point (top p) (2 * at_sphere S (top p) - pz p).
Definition mirror_sphere S T :=
  Sphere (2 * bend S - bend T) (2 ** tilt S - tilt T)%V (2 * base S - base T).

Theorem moebius_parabolic S p : mirror S (mirror S p) = p /\ top (mirror S p) = top p.
Proof. split; [ | reflexivity]. apply point_eq; [reflexivity | unfold mirror; cbn [top pz]; ring]. Qed.

Theorem moebius_parabolic_height S T p :
  over_sphere (mirror_sphere S T) (mirror S p) = - over_sphere T p.
Proof. unfold mirror, mirror_sphere. spatial. field. nonzero. Qed.

Theorem moebius_parabolic_spheres S T p :
  on_sphere (mirror S p) (mirror_sphere S T) <-> on_sphere p T.
Proof. unfold on_sphere. rewrite moebius_parabolic_height. apply opposite_zero. Qed.

(** A plane: points over a circle in it go to points over that circle in a plane. *)
Theorem moebius_parabolic_circles S (P : plane K) m (r2 : K) :
  exists Q, forall p, ||top p - m||² = r2 -> on p P -> on (mirror S p) Q.
Proof.
  exists (Plane ((2 * bend S) ** m + 2 ** tilt S - slope P)%V
    (bend S * (r2 - ||m||²) + 2 * base S - level P)).
  intros p <- O. apply on_iff in O. unfold on, mirror, over. cbn [top pz]. rewrite O.
  spatial. field. nonzero.
Qed.

Definition invert c k p :=
  (c + (k / ||top p - top c||²) ** (p - c))%P.

(** The i-M-sphere T, seen from the centre: its coefficients are those of heights over c. *)
Definition invert_sphere c k T :=
  let b := (tilt T + bend T ** top c)%V in
  let d := at_sphere T (top c) - pz c in
  Sphere (2 * d / k) (b - (2 * d / k) ** top c)%V
    (pz c + bend T * k / 2 - dot b (top c) + d / k * ||top c||²).

Theorem moebius_cylindrical c k p :
  k <> 0 -> ||top p - top c||² <> 0 -> invert c k (invert c k p) = p.
Proof.
  intros N M. unfold invert.
  assert (E : ||top (c + (k / ||top p - top c||²) ** (p - c))%P - top c||² = k² / ||top p - top c||²)
    by (spatial; field; exact M).
  rewrite E. apply point_eq; [apply vec_eq | ]; spatial; field; nonzero.
Qed.

Theorem moebius_cylindrical_center c k p :
  ||top p - top c||² <> 0 ->
  dot (top (invert c k p) - top c) (top p - top c) = k /\
  exists r, (invert c k p - c)%P = (r ** (p - c))%P.
Proof.
  intro M. split; [unfold invert; spatial; field; exact M | ].
  exists (k / ||top p - top c||²). unfold invert. apply point_eq; [apply vec_eq | ]; spatial; ring.
Qed.

Theorem moebius_cylindrical_height c k T p :
  k <> 0 -> ||top p - top c||² <> 0 ->
  over_sphere (invert_sphere c k T) (invert c k p) = k / ||top p - top c||² * over_sphere T p.
Proof.
  destruct c as [[a b] d], p as [[x y] z], T as [A [B C] D]. intros N M.
  unfold invert, invert_sphere. spatial. field. nonzero.
Qed.

Theorem moebius_cylindrical_spheres c k T p :
  k <> 0 -> ||top p - top c||² <> 0 ->
  (on_sphere (invert c k p) (invert_sphere c k T) <-> on_sphere p T).
Proof.
  intros N M. unfold on_sphere. rewrite moebius_cylindrical_height by assumption.
  split; [ | intros ->; ring]. apply cancel. intro Z. apply quotient_zero in Z; [exact (N Z) | exact M].
Qed.

(** The circle |x - m|² = r2 with the power w of the centre, in the plane P: the images lie over the
    circle |x - m*|² = r2 k²/w² in a plane. *)
Theorem moebius_cylindrical_circles c k (P : plane K) m (r2 : K) :
  let w := ||m - top c||² - r2 in
  k <> 0 -> w <> 0 ->
  let m' := (top c + (k / w) ** (m - top c))%V in
  exists Q, forall p, ||top p - top c||² <> 0 -> ||top p - m||² = r2 -> on p P ->
    ||top (invert c k p) - m'||² = r2 * k² / w² /\ on (invert c k p) Q.
Proof.
  intros w N W m'. set (d := at_plane P (top c) - pz c).
  exists (Plane (slope P + (2 * d / k) ** (m' - top c))%V
    (pz c - dot (slope P + (2 * d / k) ** (m' - top c)) (top c) - d * k / w)).
  intros p M C O. apply on_iff in O.
  assert (E : ||top p - top c||² = 2 * dot (top p - top c) (m - top c) - w).
  { transitivity (||top p - m||² + 2 * dot (top p - top c) (m - top c) - ||m - top c||²).
    - coordinates. ring.
    - rewrite C. unfold w. ring. }
  assert (R : r2 = ||m - top c||² - w) by (unfold w; ring). split.
  - transitivity (k² * (1 / ||top p - top c||² - 2 * dot (top p - top c) (m - top c) / (||top p - top c||² * w)
      + ||m - top c||² / w²)).
    + unfold m', invert. clear E R C. clearbody w. spatial. field. nonzero.
    + replace (2 * dot (top p - top c) (m - top c)) with (||top p - top c||² + w) by (rewrite E; ring).
      rewrite R. set (q := ||top p - top c||²) in *. set (g := ||m - top c||²). clearbody w q g.
      field. nonzero.
  - unfold on, over, invert. cbn [top pz padd psub pscale].
    transitivity (k / ||top p - top c||² * ((pz p - pz c) - dot (slope P) (top p - top c))
      - d * (2 * dot (top p - top c) (m - top c) - ||top p - top c||²) * (k / (w * ||top p - top c||²))).
    + unfold m'. clear E R C. clearbody w d. spatial. field. nonzero.
    + replace (2 * dot (top p - top c) (m - top c) - ||top p - top c||²) with w by (rewrite E; ring).
      rewrite O. unfold d. clear E R C d. clearbody w. spatial. field. nonzero.
Qed.

(** A circle through the centre: its image lies over a line. *)
Theorem moebius_cylindrical_sharp c k p m :
  ||top p - top c||² <> 0 -> ||top p - m||² = ||m - top c||² ->
  2 * dot (top (invert c k p) - top c) (m - top c) = k.
Proof.
  intros M C.
  assert (E : 2 * dot (top p - top c) (m - top c) = ||top p - top c||²).
  { transitivity (||top p - top c||² - (||top p - m||² - ||m - top c||²)); [coordinates; ring | ].
    rewrite C. ring. }
  transitivity (k / ||top p - top c||² * (2 * dot (top p - top c) (m - top c))).
  - unfold invert. spatial. field. exact M.
  - rewrite E. field. exact M.
Qed.

End Moebius.
