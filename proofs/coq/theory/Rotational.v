(** * Rotational meshes

    First integrals of meshes of quads and hexagons with rotational symmetry: areas and mixed areas of a
    face are differences of one expression at its two rings.

    - [trapezoid t r R]: the face between rings of radii r and R with the sector t, a unit vector;
    - [hexagon t u l U L]: the face with corners u, U at the angles 0 and ±φ, l, L at ±φ and 0;

    Statements
    - [quad_rotational_mixed], [quad_rotational_mean], [quad_rotational_gauss];
    - [hex_rotational_vertices]: radii δ/A and δ/B of the vertices between two rings of planes;
    - [hex_rotational_mixed], [hex_rotational_minimal], [hex_rotational_mean], [hex_rotational_gauss].

    Unsaid in the paper: sin φ, A, B and the areas are not 0. *)

From Isogeo.theory Require Export Quads.

Section Rotational.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (t : vec K) (r R H C : K).

Definition at_angle (r : K) t := (r ** t)%V.
Definition trapezoid t r R : nat -> vec K :=
  quad (r ** Vec 1 0)%V (R ** Vec 1 0)%V (R ** t)%V (r ** t)%V.

Theorem quad_rotational_mixed t r R r' R' :
  mixed 4 (trapezoid t r R) (trapezoid t r' R') = vy t / 2 * (R * R' - r * r').
Proof. unfold mixed, trapezoid, quad, corners, cycle. cbn. coordinates. field. nonzero. Qed.

Lemma quad_rotational_area t r R : area 4 (trapezoid t r R) = vy t / 2 * (R² - r²).
Proof. rewrite <- eq_15_16_diagonal. apply quad_rotational_mixed. Qed.

Lemma ratio_iff (a b x : K) : b <> 0 -> (a / b = x <-> a - x * b = 0).
Proof.
  intro N. split.
  - intros <-. field. exact N.
  - intro Z. apply difference_zero. transitivity ((a - x * b) / b); [field; exact N | ].
    rewrite Z. field. exact N.
Qed.

Lemma difference_iff (x a b : K) : x <> 0 -> (x * (a - b) = 0 <-> a = b).
Proof.
  intro N. rewrite <- (difference_zero K a b). split; [apply cancel; exact N | intros ->; ring].
Qed.

Lemma half_nonzero (x : K) : x <> 0 -> x / 2 <> 0.
Proof. intros N Z. apply quotient_zero in Z; [exact (N Z) | nonzero]. Qed.

Theorem quad_rotational_mean t r R r' R' H :
  vy t <> 0 -> area 4 (trapezoid t r R) <> 0 ->
  (mean 4 (trapezoid t r R) (trapezoid t r' R') = H <-> R * R' - H * R² = r * r' - H * r²).
Proof.
  intros N A. unfold mean. rewrite ratio_iff by exact A.
  rewrite quad_rotational_mixed, quad_rotational_area.
  rewrite <- (difference_iff (vy t / 2) (R * R' - H * R²) (r * r' - H * r²)) by (apply half_nonzero, N).
  replace (vy t / 2 * (R * R' - H * R² - (r * r' - H * r²)))
    with (vy t / 2 * (R * R' - r * r') - H * (vy t / 2 * (R² - r²))) by (field; nonzero).
  reflexivity.
Qed.

Theorem quad_rotational_gauss t r R r' R' C :
  vy t <> 0 -> area 4 (trapezoid t r R) <> 0 -> C <> 0 ->
  (gauss 4 (trapezoid t r R) (trapezoid t r' R') = C <-> R² - R'² / C = r² - r'² / C).
Proof.
  intros N A M. unfold gauss. rewrite ratio_iff by exact A.
  rewrite !quad_rotational_area.
  rewrite <- (difference_iff (- (C * (vy t / 2))) (R² - R'² / C) (r² - r'² / C)).
  - replace (- (C * (vy t / 2)) * (R² - R'² / C - (r² - r'² / C)))
      with (vy t / 2 * (R'² - r'²) - C * (vy t / 2 * (R² - r²))) by (field; nonzero).
    reflexivity.
  - intro Z. apply (product_nonzero K C (vy t / 2) M (half_nonzero _ N)), opposite_zero, Z.
Qed.

(** ** Hexagons

    The planes of a ring are z = R e · x + τ, with e at the angles of its axes; consecutive rings are
    turned by φ against each other, t = (cos φ, sin φ). *)

Definition ring_plane R (e : vec K) (tau : K) : plane K := Plane (R ** e)%V tau.

(** Over the axis of the next ring two planes of this one meet one of that, and the other way round. *)
Theorem hex_rotational_vertices t r R (tau tau' : K) :
  ||t||² = 1 ->
  let A := R - vx t * r in let B := vx t * R - r in let delta := tau - tau' in
  A <> 0 -> B <> 0 ->
  let U := ((delta / A) ** Vec 1 0)%V in let L := ((delta / B) ** Vec 1 0)%V in
  at_plane (ring_plane r t tau) U = at_plane (ring_plane R (Vec 1 0) tau') U /\
  at_plane (ring_plane r (conj t) tau) U = at_plane (ring_plane R (Vec 1 0) tau') U /\
  at_plane (ring_plane r (Vec 1 0) tau) L = at_plane (ring_plane R t tau') L /\
  at_plane (ring_plane r (Vec 1 0) tau) L = at_plane (ring_plane R (conj t) tau') L.
Proof.
  intros _ A B delta NA NB U L. unfold U, L, delta, A, B in *. unfold ring_plane. spatial.
  repeat split; field; assumption.
Qed.

Definition hexagon t (u l U L : K) : nat -> vec K :=
  corners ((u ** Vec 1 0)%V :: (l ** conj t)%V :: (U ** conj t)%V :: (L ** Vec 1 0)%V ::
    (U ** t)%V :: (l ** t)%V :: nil) null.

Theorem hex_rotational_mixed t (u l U L u' l' U' L' : K) :
  mixed 6 (hexagon t u l U L) (hexagon t u' l' U' L') =
  vy t / 2 * ((U * L' + U' * L) - (u * l' + u' * l)).
Proof. unfold mixed, hexagon, corners, cycle. cbn. coordinates. field. nonzero. Qed.

(** The face between two pairs of rings, by the steps d, d' and D, D' of the offsets of M and S. *)
Definition hexagon_of t (a b d A B D : K) := hexagon t (d / a) (d / b) (D / A) (D / B).

Lemma hex_mixed_steps t (a b A B d d' D D' : K) :
  a <> 0 -> b <> 0 -> A <> 0 -> B <> 0 ->
  mixed 6 (hexagon_of t a b d A B D) (hexagon_of t a b d' A B D') =
  vy t * (D * D' / (A * B) - d * d' / (a * b)).
Proof.
  intros. unfold hexagon_of. rewrite hex_rotational_mixed. field. nonzero.
Qed.

Section Steps.
Variables (t : vec K) (a b A B d d' D D' : K).
Hypothesis nonzeros : a <> 0 /\ b <> 0 /\ A <> 0 /\ B <> 0 /\ vy t <> 0.
Let M := hexagon_of t a b d A B D.
Let S := hexagon_of t a b d' A B D'.

Theorem hex_rotational_minimal : mixed 6 M S = 0 <-> D * D' / (A * B) = d * d' / (a * b).
Proof.
  destruct nonzeros as (Na & Nb & NA & NB & N). unfold M, S.
  rewrite hex_mixed_steps by assumption. apply difference_iff, N.
Qed.

Theorem hex_rotational_mean H : area 6 M <> 0 ->
  (mean 6 M S = H <-> (D * D' - H * D²) / (A * B) = (d * d' - H * d²) / (a * b)).
Proof.
  destruct nonzeros as (Na & Nb & NA & NB & N). intro Z. unfold mean. rewrite ratio_iff by exact Z.
  rewrite <- eq_15_16_diagonal. unfold M, S. rewrite !hex_mixed_steps by assumption.
  rewrite <- (difference_iff (vy t) ((D * D' - H * D²) / (A * B)) ((d * d' - H * d²) / (a * b))) by exact N.
  replace (vy t * ((D * D' - H * D²) / (A * B) - (d * d' - H * d²) / (a * b)))
    with (vy t * (D * D' / (A * B) - d * d' / (a * b)) - H * (vy t * (D² / (A * B) - d² / (a * b))))
    by (field; nonzero).
  reflexivity.
Qed.

Theorem hex_rotational_gauss C : area 6 M <> 0 -> C <> 0 ->
  (gauss 6 M S = C <-> (D² - D'² / C) / (A * B) = (d² - d'² / C) / (a * b)).
Proof.
  destruct nonzeros as (Na & Nb & NA & NB & N). intros Z NC. unfold gauss. rewrite ratio_iff by exact Z.
  rewrite <- !eq_15_16_diagonal. unfold M, S. rewrite !hex_mixed_steps by assumption.
  rewrite <- (difference_iff (- (C * vy t)) ((D² - D'² / C) / (A * B)) ((d² - d'² / C) / (a * b))).
  - replace (- (C * vy t) * ((D² - D'² / C) / (A * B) - (d² - d'² / C) / (a * b)))
      with (vy t * (D'² / (A * B) - d'² / (a * b)) - C * (vy t * (D² / (A * B) - d² / (a * b))))
      by (field; nonzero).
    reflexivity.
  - intro E. apply (product_nonzero K C (vy t) NC N), opposite_zero, E.
Qed.

End Steps.

End Rotational.
