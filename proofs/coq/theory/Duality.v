(** * Metric duality

    The polarity at Σ: p = (p1, p2, p3) and z = p1 x + p2 y - p3 (Sec. 2.1, "Metric duality").

    - [duality_involution_*]: twice dual is the object itself;
    - [duality_incidence]: inclusions are reversed;
    - [duality_metric]: the i-distance of points is the i-angle of their planes;
    - [duality_parallel]: parallel points and parallel planes;
    - [duality_sigma], [duality_sigma_contact]: planes that touch Σ are those with poles on Σ;
    - [duality_f_v]: f-parallel and v-parallel elements, [duality_f_v_inscribed],
      [duality_f_v_midscribed], [duality_f_v_midscribed_iff]: inscribed, circumscribed, midscribed;
    - [eq_6_gauss]: the Gauss image is where Σ has a parallel plane;
    - [eq_3_sections]: a plane cuts an i-sphere in an i-circle around (p - (B, C))/A.

    Unsaid in the paper: no plane is isotropic; the circle of a section may have a radius whose square
    is no square or 0 ([eq_3_sections_empty] in Counterexamples.v). *)

From Isogeo.theory Require Import Isotropic.

Section Duality.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (p q : point K) (P Q : plane K) (x : vec K).

Theorem duality_involution_point p : pole (polar p) = p.
Proof. apply point_eq; spatial; [reflexivity | ring]. Qed.

Theorem duality_involution_plane P : polar (pole P) = P.
Proof. apply plane_eq; spatial; [reflexivity | ring]. Qed.

(** A point lies over a plane by as much as the pole over the polar plane. *)
Theorem duality_incidence_height p P : over P p = over (polar p) (pole P).
Proof. spatial. ring. Qed.

Theorem duality_incidence p P : on p P <-> on (pole P) (polar p).
Proof. unfold on. rewrite duality_incidence_height. reflexivity. Qed.

Theorem duality_metric p q : idist2 p q = iangle2 (polar p) (polar q).
Proof. reflexivity. Qed.

Theorem duality_metric_planes P Q : iangle2 P Q = idist2 (pole P) (pole Q).
Proof. reflexivity. Qed.

Theorem duality_parallel p q : parallel_points p q <-> parallel_planes (polar p) (polar q).
Proof. reflexivity. Qed.

Theorem duality_parallel_zero p q : p = q <-> polar p = polar q.
Proof.
  split; [intros ->; reflexivity | intro H].
  rewrite <- (duality_involution_point p), <- (duality_involution_point q), H. reflexivity.
Qed.

Theorem duality_sigma P : touches_sigma P <-> on_sigma (pole P).
Proof.
  rewrite on_sigma_iff. split.
  - intros [x ->]. spatial. ring.
  - intro H. exists (slope P). apply plane_eq; [reflexivity | ]. cbn in *. rewrite <- H. ring.
Qed.

(** The plane touches in the pole: Σ lies over it by half a square, 0 only there. *)
Theorem duality_sigma_contact P x :
  touches_sigma P -> over P (lift x) = ||x - top (pole P)||² / 2.
Proof. intros [c ->]. spatial. field. nonzero. Qed.

(** ** Pairs of meshes

    The vertices of the dual of a mesh are the poles of its faces, its faces the polar planes of the
    vertices: the statements are about one element and its partner. *)

Theorem duality_f_v (M S : plane K) : parallel_planes M S <-> parallel_points (pole M) (pole S).
Proof. reflexivity. Qed.

Theorem duality_f_v_inscribed p : on_sigma p <-> touches_sigma (polar p).
Proof. rewrite duality_sigma, duality_involution_point. reflexivity. Qed.

(** The line through p and q touches Σ: the height over Σ along it has a double zero, that is, its
    discriminant vanishes. *)
Definition line_discriminant p q :=
  let d := (q - p)%P in
  (pz d - dot (top p) (top d))² + 2 * ||top d||² * over_sigma p.

Lemma line_discriminant_meaning p q (t : K) :
  2 * over_sigma (p + t ** (q - p))%P =
  2 * over_sigma p + 2 * t * (pz (q - p)%P - dot (top p) (top (q - p)%P)) - t² * ||top (q - p)%P||².
Proof. spatial. field. nonzero. Qed.

(** Two points on two planes, and the two poles on the dual line: one line touches Σ iff the other
    does, if neither the points nor the planes are parallel. *)
Theorem duality_f_v_midscribed p q P Q :
  on p P -> on q P -> on p Q -> on q Q ->
  line_discriminant p q * iangle2 P Q = - (line_discriminant (pole P) (pole Q) * idist2 p q).
Proof.
  destruct p as [[a b] c], q as [[d e] f], P as [[g h] i], Q as [[j k] l].
  unfold line_discriminant. intros H1 H2 H3 H4. spatial.
  assert (E1 : c = g * a + h * b + i) by (apply difference_zero; exact H1).
  assert (E2 : f = g * d + h * e + i) by (apply difference_zero; exact H2).
  assert (E3 : l = c - j * a - k * b) by (apply difference_zero, opposite_zero; rewrite <- H3; ring).
  clear H1 H2 H3. subst l f c.
  assert (E : (j - g) * (d - a) + (k - h) * (e - b) = 0)
    by (apply opposite_zero; rewrite <- H4; ring). clear H4.
  apply (equals_by K 4); [nonzero | ].
  set (u := j - g) in *. set (v := k - h) in *. set (m := d - a) in *. set (n := e - b) in *.
  replace j with (g + u) by (unfold u; ring). replace k with (h + v) by (unfold v; ring).
  replace d with (a + m) by (unfold m; ring). replace e with (b + n) by (unfold n; ring).
  clearbody u v m n. clear j k d e. field_simplify_eq; [ | nonzero]. eliminate.
Qed.

Theorem duality_f_v_midscribed_iff p q P Q :
  on p P -> on q P -> on p Q -> on q Q -> idist2 p q <> 0 -> iangle2 P Q <> 0 ->
  (line_discriminant p q = 0 <-> line_discriminant (pole P) (pole Q) = 0).
Proof.
  intros A B C D N M. assert (E := duality_f_v_midscribed p q P Q A B C D). split; intro Z; rewrite Z in E.
  - apply (cancel K _ _ N). transitivity (- - (line_discriminant (pole P) (pole Q) * idist2 p q)); [ring | ].
    rewrite <- E. ring.
  - apply (cancel K _ _ M). transitivity (line_discriminant p q * iangle2 P Q); [ring | rewrite E; ring].
Qed.

(** ** Sections and the Gauss map *)

Theorem eq_6_gauss (g : vec K) (t : K) x :
  slope (tangent x) = slope (Plane g t) <-> lift x = Point g (s g).
Proof.
  cbn. split; [intros ->; reflexivity | ]. intro H. exact (f_equal top H).
Qed.

Theorem eq_3_sections (S : sphere K) P x :
  bend S <> 0 ->
  let c := ((1 / bend S) ** (slope P - tilt S))%V in
  let r2 := (||slope P - tilt S||² + 2 * bend S * (level P - base S)) / (bend S)² in
  at_sphere S x = at_plane P x <-> ||x - c||² = r2.
Proof.
  intros A c r2. rewrite <- difference_zero, <- (difference_zero K (||x - c||²)).
  replace (||x - c||² - r2) with (2 / bend S * (at_sphere S x - at_plane P x)).
  - split; intro H; [rewrite H; ring | ]. apply (cancel K (2 / bend S)); [ | exact H].
    intro Z. apply quotient_zero in Z; [exact (two_nonzero K Z) | exact A].
  - unfold c, r2. spatial. field. nonzero.
Qed.

End Duality.
