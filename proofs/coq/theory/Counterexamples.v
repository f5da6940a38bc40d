(** * Counterexamples

    What fails without a hypothesis, in numbers; those that need no numbers stand with their theorems.

    - [koebe_vertex_sharp]: four unit circles on a rhombus touch in a cycle, with concyclic contacts, and
      have no common orthogonal circle;
    - [christoffel_dual_sharp]: the sides of the triangle 3, 4, 5 over R_i R_j close with no signs;
    - [minkowski_reflex_sharp]: a quad with a reflex corner: H² - K = -2;
    - [minkowski_parallel_sharp]: a square and a quarter turn of it, H² - K = -1;
    - [eq_17_18_sharp]: a bow-tie has area 0;
    - [eq_22_cotan_negative]: an embedded star with D(s) = -99/4;
    - [fig_11_star]: a star on which (22) gives 2H = 68/31, K = 412/775 for z = x²;
    - [eq_3_sections_empty]: a plane that misses the unit sphere Σ. *)

From Isogeo.theory Require Import Real Koebe Vertices Minkowski Christoffel Duality.

Local Open Scope R_scope.
Local Notation V := (@Vec Reals).

Ltac by_numbers :=
  unfold quad, corners, cycle, Offsets.area, Offsets.mixed, Vertices.cot, cotan_weight;
  cbn -[IZR Rplus Rminus Rmult Rdiv];
  real_in; cbn [nth Nat.modulo Nat.divmod Nat.sub fst snd length] in *.

(** The centre of a common orthogonal circle would have equal distances from all four centres. *)
Theorem koebe_vertex_sharp :
  let c0 := V (10 / 13) 0 in let c1 := V 0 (24 / 13) in
  let c2 := V (- 10 / 13) 0 in let c3 := V 0 (- 24 / 13) in
  let r : Reals := 1 in
  tangent_circles c0 r c1 r /\ tangent_circles c1 r c2 r /\
  tangent_circles c2 r c3 r /\ tangent_circles c3 r c0 r /\
  ~ exists (m : vec Reals) (rho2 : Reals),
    orthogonal_circle m rho2 c0 r /\ orthogonal_circle m rho2 c1 r /\
    orthogonal_circle m rho2 c2 r /\ orthogonal_circle m rho2 c3 r.
Proof.
  intros c0 c1 c2 c3 r. unfold tangent_circles, orthogonal_circle, c0, c1, c2, c3, r.
  repeat split; try (real_in; lra).
  intros ([x y] & rho2 & A & B & C & D). real_in. lra.
Qed.

(** Sides 3, 4, 5 with the tangent lengths 1, 2, 3 and the incircle of radius 1. *)
Theorem christoffel_dual_sharp (s0 s1 s2 : R) :
  s0 = 1 \/ s0 = - (1) -> s1 = 1 \/ s1 = - (1) -> s2 = 1 \/ s2 = - (1) ->
  (((s0 / (2 * 1)) ** V 3 0 + ((s1 / (1 * 3)) ** V 0 4 + (s2 / (3 * 2)) ** V (- (3)) (- (4))))%V : vec Reals)
  <> V 0 0.
Proof.
  intros A B C E. assert (X := f_equal vx E). clear E. real_in.
  destruct A as [-> | ->], C as [-> | ->]; lra.
Qed.

Theorem eq_17_18_sharp : Offsets.area 4 (quad (V 0 0) (V 1 1) (V 1 0) (V 0 1)) = 0.
Proof. by_numbers. lra. Qed.

(** A dart, and twice, three times, minus once and not at all its sides. *)
Theorem minkowski_reflex_sharp :
  let v := quad (V 0 0) (V 2 (- (1))) (V 1 0) (V 2 1) in
  let w := quad (V 0 0) (V 4 (- (2))) (V 1 1) (V 0 0) in
  parallel_quads v w /\ reflex v /\ mean 4 v w * mean 4 v w - gauss 4 v w = - (2).
Proof.
  intros v w. split; [ | split].
  - intros j L. destruct j as [ | [ | [ | [ | j]]]];
      [ | | | | exfalso; do 4 apply Nat.succ_lt_mono in L; exact (Nat.nlt_0_r j L)];
      unfold v, w; by_numbers; lra.
  - unfold reflex, corner_det, v. by_numbers. lra.
  - assert (A : Offsets.area 4 v = 1) by (unfold v; by_numbers; lra).
    assert (B : Offsets.area 4 w = 3) by (unfold w; by_numbers; lra).
    assert (C : Offsets.mixed 4 v w = 1) by (unfold v, w; by_numbers; lra).
    unfold mean, gauss. rewrite A, B, C. cbn. lra.
Qed.

Theorem minkowski_parallel_sharp :
  let v := quad (V 0 0) (V 1 0) (V 1 1) (V 0 1) in
  let w := quad (V 0 0) (V 0 1) (V (- (1)) 1) (V (- (1)) 0) in
  mean 4 v w * mean 4 v w < gauss 4 v w.
Proof.
  intros v w. assert (A : Offsets.area 4 v = 1) by (unfold v; by_numbers; lra).
  assert (B : Offsets.area 4 w = 1) by (unfold w; by_numbers; lra).
  assert (C : Offsets.mixed 4 v w = 0) by (unfold v, w; by_numbers; lra).
  unfold mean, gauss. rewrite A, B, C. cbn. lra.
Qed.

(** The star (3, -2), (0, 1), (-7, 1), (-1, 0) around the origin: its circumcentres. *)
Theorem eq_22_cotan_negative :
  let z := corners (V 3 (- (2)) :: V 0 1 :: V (- (7)) 1 :: V (- (1)) 0 :: nil) (V 0 0) in
  let q := corners (V (5 / 2) (1 / 2) :: V (- 7 / 2) (1 / 2) :: V (- 1 / 2) (43 / 2) ::
    V (- 1 / 2) (- 4) :: nil) (V 0 0) in
  (forall j, (j < 4)%nat -> dot (q j) (z j) = s (z j) /\ dot (q j) (z (S j)) = s (z (S j))) /\
  Offsets.area 4 q = - 99 / 4.
Proof.
  intros z q. split.
  - intros j L. destruct j as [ | [ | [ | [ | j]]]];
      [ | | | | exfalso; do 4 apply Nat.succ_lt_mono in L; exact (Nat.nlt_0_r j L)];
      unfold z, q; by_numbers; unfold s; real_in; split; lra.
  - unfold q. by_numbers. lra.
Qed.

(** The star (2, 0), (1, 1), (-1, 1), (-2, -1), (1, -2) around the origin, the gradients of z = x² on its
    triangles and its circumcentres; by homogeneity it is the same at every scale. *)
Theorem fig_11_star :
  let z := corners (V 2 0 :: V 1 1 :: V (- (1)) 1 :: V (- (2)) (- (1)) :: V 1 (- (2)) :: nil) (V 0 0) in
  let p := corners (V 2 (- (1)) :: V 0 1 :: V (- 5 / 3) (- 2 / 3) :: V (- 7 / 5) (- 6 / 5) ::
    V 2 (1 / 2) :: nil) (V 0 0) in
  let q := corners (V 1 0 :: V 0 1 :: V (- 7 / 6) (- 1 / 6) :: V (- 1 / 2) (- 3 / 2) ::
    V 1 (- 3 / 4) :: nil) (V 0 0) in
  (forall j, (j < 5)%nat ->
    dot (p j) (z j) = vx (z j) * vx (z j) /\ dot (p j) (z (S j)) = vx (z (S j)) * vx (z (S j)) /\
    dot (q j) (z j) = s (z j) /\ dot (q j) (z (S j)) = s (z (S j))) /\
  2 * vertex_mean 5 p q = 68 / 31 /\ vertex_gauss 5 p q = 412 / 775.
Proof.
  intros z p q. split.
  - intros j L. destruct j as [ | [ | [ | [ | [ | j]]]]];
      [ | | | | | exfalso; do 5 apply Nat.succ_lt_mono in L; exact (Nat.nlt_0_r j L)];
      unfold z, p, q; by_numbers; unfold s; real_in; repeat split; lra.
  - assert (A : Offsets.area 5 p = 103 / 60) by (unfold p; by_numbers; lra).
    assert (B : Offsets.area 5 q = 155 / 48) by (unfold q; by_numbers; lra).
    assert (C : Offsets.mixed 5 p q = 85 / 24) by (unfold p, q; by_numbers; lra).
    unfold vertex_mean, vertex_gauss. rewrite A, B, C. cbn. lra.
Qed.

(** The plane z = -1. *)
Theorem eq_3_sections_empty (x : vec Reals) : ~ on (lift x) (@Plane Reals (V 0 0) (- (1))).
Proof.
  rewrite section_circle. cbn [slope level]. destruct x as [x y]. intro E. real_in.
  assert (A := Rle_0_sqr x). assert (B := Rle_0_sqr y). unfold Rsqr in *. lra.
Qed.
