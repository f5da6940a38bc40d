(** * Isothermic meshes: Theorem 3 and Remark 2

    Circles of Koebe.v as incircles of faces; their images under inversions and in Euclidean space.

    - [touches_line p q c r2]: the line through p and q touches the circle |x - c|² = r2;
    - [power c0 c r]: the power of a point, [image_centre], [image_radius]: a circle after the inversion
      at the circle of squared radius k about c0, with signed radii;
    - [axis c r]: the point of Euclidean space that stands for the axis of the cone of a circle.

    Statements
    - [thm_3_edge]: an edge touches Σ iff its top view touches the incircle of its plane;
    - [thm_3_lift]: over a tangent circle pattern the planes of two faces at an edge meet over it;
    - [remark_2_moebius_circle]: the image of a circle, [remark_2_moebius_tangent],
      [remark_2_moebius_orthogonal]: tangent and orthogonal circles stay so;
    - [remark_2_edge_offset]: the line of two axes touches the unit sphere iff the circles touch, one of
      them perhaps turned over ([remark_2_edge_offset_axis]).

    Unsaid in the paper: no circle passes through the centre; none is the image of a great circle. *)

From Isogeo.theory Require Export Koebe Duality OffsetMeshes.

Section Isothermic.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (p q : point K) (P : plane K) (c x : vec K) (r k : K).

Definition touches_line (x y c : vec K) (r2 : K) := (det (y - x) (c - x))² = r2 * ||y - x||².

Theorem thm_3_edge p q P :
  on p P -> on q P ->
  (line_discriminant p q = 0 <->
   touches_line (top p) (top q) (slope P) (||slope P||² + 2 * level P)).
Proof.
  intros A B. apply on_iff in A, B. unfold touches_line. rewrite <- (difference_zero K (_²)).
  assert (E : line_discriminant p q =
    - ((det (top q - top p) (slope P - top p))² - (||slope P||² + 2 * level P) * ||top q - top p||²)).
  { unfold line_discriminant, psub, over_sigma. cbn [top pz]. rewrite A, B. spatial. field. nonzero. }
  rewrite E. apply opposite_zero.
Qed.

(** Conversely: two circles that touch at t, in the direction J (c2 - c1) of the edge. *)
Theorem thm_3_lift c1 r1 c2 r2 (l : K) :
  r1 + r2 <> 0 -> tangent_circles c1 r1 c2 r2 ->
  at_plane (circle_plane c1 r1) (on_tangent c1 r1 c2 r2 l) =
  at_plane (circle_plane c2 r2) (on_tangent c1 r1 c2 r2 l).
Proof. apply koebe_edge. Qed.

(** ** Inversions of circles *)

Definition power (c0 c : vec K) r : K := ||c - c0||² - r².
Definition image_centre k (c0 c : vec K) r := (c0 + (k / power c0 c r) ** (c - c0))%V.
Definition image_radius k (c0 c : vec K) r := k * r / power c0 c r.
Definition invert_top k (c0 x : vec K) := (c0 + (k / ||x - c0||²) ** (x - c0))%V.

Theorem remark_2_moebius_circle k c0 c r x :
  power c0 c r <> 0 -> ||x - c0||² <> 0 -> ||x - c||² = r² ->
  ||invert_top k c0 x - image_centre k c0 c r||² = (image_radius k c0 c r)².
Proof.
  intros W N C. unfold image_centre, image_radius, invert_top.
  assert (E : power c0 c r = 2 * dot (x - c0) (c - c0) - ||x - c0||²).
  { unfold power. rewrite <- C. coordinates. ring. }
  assert (R : r² = ||c - c0||² - power c0 c r) by (unfold power; ring).
  set (w := power c0 c r) in *. clearbody w. clear C.
  transitivity (k² * (||c - c0||² - w) / w²); [ | rewrite <- R; field; exact W].
  transitivity (k² * (1 / ||x - c0||² - 2 * dot (x - c0) (c - c0) / (||x - c0||² * w) + ||c - c0||² / w²)).
  - clear E R. coordinates. field. split; [exact W | exact N].
  - replace (2 * dot (x - c0) (c - c0)) with (w + ||x - c0||²) by (rewrite E; ring).
    generalize (||c - c0||²). intro g. field. split; assumption.
Qed.

Theorem remark_2_moebius_tangent k c0 c1 r1 c2 r2 :
  power c0 c1 r1 <> 0 -> power c0 c2 r2 <> 0 -> tangent_circles c1 r1 c2 r2 ->
  tangent_circles (image_centre k c0 c1 r1) (image_radius k c0 c1 r1)
    (image_centre k c0 c2 r2) (image_radius k c0 c2 r2).
Proof.
  unfold tangent_circles. rewrite <- !(difference_zero K (||_||²)). intros A B T.
  transitivity (k² / (power c0 c1 r1 * power c0 c2 r2) * (||c1 - c2||² - (r1 + r2)²)).
  - unfold image_centre, image_radius. unfold power in *. coordinates. field. split; assumption.
  - rewrite T. ring.
Qed.

(** The circle of a vertex, |x - m|² = r3², and an incircle. *)
Theorem remark_2_moebius_orthogonal k c0 m r3 c r :
  power c0 m r3 <> 0 -> power c0 c r <> 0 -> orthogonal_circle m r3² c r ->
  orthogonal_circle (image_centre k c0 m r3) ((image_radius k c0 m r3)²)
    (image_centre k c0 c r) (image_radius k c0 c r).
Proof.
  unfold orthogonal_circle. rewrite <- !(difference_zero K (||_||²)). intros A B T.
  transitivity (k² / (power c0 m r3 * power c0 c r) * (||m - c||² - (r3² + r²))).
  - unfold image_centre, image_radius. unfold power in *. coordinates. field. split; assumption.
  - rewrite T. ring.
Qed.

(** ** Edge offsets *)

Definition great c r : K := 1 + (||c||² - r²).
Definition axis c r :=
  Point ((2 / great c r) ** c)%V ((1 - (||c||² - r²)) / great c r).

Theorem remark_2_edge_offset_axis c1 r1 c2 r2 :
  great c1 r1 <> 0 -> great c2 r2 <> 0 ->
  let s1 := axis c1 r1 in let s2 := axis c2 r2 in
  norm3 (cross3 s1 (s2 - s1)) - norm3 (s2 - s1) =
  4 / ((great c1 r1)² * (great c2 r2)²) * (||c1 - c2||² - (r1 + r2)²) * ((r1 - r2)² - ||c1 - c2||²).
Proof.
  intros A B s1 s2. unfold s1, s2, axis.
  assert (E1 : r1² = 1 + ||c1||² - great c1 r1) by (unfold great; ring).
  assert (E2 : r2² = 1 + ||c2||² - great c2 r2) by (unfold great; ring).
  transitivity (4 / ((great c1 r1)² * (great c2 r2)²) *
    (4 * r1² * r2² - (||c1 - c2||² - r1² - r2²)²)).
  - rewrite E1, E2.
    replace (||c1||² - (1 + ||c1||² - great c1 r1)) with (great c1 r1 - 1) by ring.
    replace (||c2||² - (1 + ||c2||² - great c2 r2)) with (great c2 r2 - 1) by ring.
    generalize dependent (great c1 r1). generalize dependent (great c2 r2). intros w B E2 w' A E1.
    clear E1 E2. destruct c1 as [a b], c2 as [d e].
    unfold norm3, dot3, cross3. spatial. field. split; assumption.
  - field. split; assumption.
Qed.

Theorem remark_2_edge_offset c1 r1 c2 r2 :
  great c1 r1 <> 0 -> great c2 r2 <> 0 ->
  let s1 := axis c1 r1 in let s2 := axis c2 r2 in
  (norm3 (cross3 s1 (s2 - s1)) = norm3 (s2 - s1) <->
   tangent_circles c1 r1 c2 r2 \/ tangent_circles c1 r1 c2 (- r2)).
Proof.
  intros A B s1 s2. rewrite <- (difference_zero K (norm3 _)).
  unfold s1, s2. rewrite remark_2_edge_offset_axis by assumption. unfold tangent_circles. split.
  - intro Z. apply product_zero in Z. destruct Z as [Z | Z].
    + apply product_zero in Z. destruct Z as [Z | Z].
      * apply quotient_zero in Z; [ | nonzero]. exfalso.
        apply (product_nonzero K 2 2 (two_nonzero K) (two_nonzero K)), Z.
      * left. apply difference_zero, Z.
    + right. symmetry. apply difference_zero. rewrite <- Z. ring.
  - intros [E | E]; rewrite E; ring.
Qed.

End Isothermic.
