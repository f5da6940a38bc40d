(** * Whole nets

    From faces to meshes with the combinatorics of a rectangular patch of m x n quads, vertices p i j with
    i <= m and j <= n: what closes around every face closes altogether.

    - [faces m n F]: F i j holds for all faces;
    - [edge_step p q x]: the step of Inscribed.v along the edge p q of space, the same from both ends;
    - [koebe_face v R i j]: the corners of a face lie around a circle, with the tangent lengths R.

    Statements
    - [transport]: maps along edges that agree around every face come from one map of vertices;
    - [thm_1_f_net]: a planar net with concyclic faces is parallel to an inscribed one through every
      point of Σ;
    - [thm_1_f_ring_sharp]: a flat ring of three trapezoids between a triangle and its double: the faces
      are concyclic, and around the hole nearly no start closes;
    - [christoffel_dual_net]: a net with touching incircles has a Christoffel dual, with edges
      e/(R_i R_j) along rows and -e/(R_i R_j) along columns and mixed area 0 at every face. *)

From Isogeo.theory Require Export Inscribed Quads Christoffel.

Definition faces (m n : nat) (F : nat -> nat -> Prop) := forall i j, (i < m)%nat -> (j < n)%nat -> F i j.

(** Values at vertices that follow from those of their neighbours. *)
Section Transport.
Variables (A : Type) (m n : nat) (H V : nat -> nat -> A -> A) (start : A).
Hypothesis commute : faces m n (fun i j => forall x, V (S i) j (H i j x) = H i (S j) (V i j x)).

Fixpoint bottom (i : nat) : A := match i with O => start | S i => H i 0 (bottom i) end.
Fixpoint value (i j : nat) : A := match j with O => bottom i | S j => V i j (value i j) end.

Lemma transport :
  value 0 0 = start /\
  (forall i j, (i < m)%nat -> (j <= n)%nat -> value (S i) j = H i j (value i j)) /\
  (forall i j, value i (S j) = V i j (value i j)).
Proof.
  split; [reflexivity | split; [ | reflexivity]].
  intros i j L. induction j as [ | j IH]; intro M; [reflexivity | ].
  cbn [value]. rewrite (IH (Nat.lt_le_incl _ _ M)). exact (commute i j L M _).
Qed.

End Transport.

Section Nets.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (i j m n : nat).

(** ** Theorem 1 *)

Definition edge_step (p q : point K) (x : vec K) : vec K :=
  let d := (q - p)%P in (x + (2 * (pz d - dot x (top d)) / ||top d||²) ** top d)%V.

Lemma edge_step_symmetric p q x : edge_step p q x = edge_step q p x.
Proof.
  unfold edge_step. cbn zeta.
  replace (||top (p - q)%P||²) with (||top (q - p)%P||²) by (spatial; ring).
  replace (pz (p - q)%P - dot x (top (p - q)%P)) with (- (pz (q - p)%P - dot x (top (q - p)%P)))
    by (spatial; ring).
  set (a := pz (q - p)%P - dot x (top (q - p)%P)). set (b := ||top (q - p)%P||²).
  replace (2 * - a / b) with (- (2 * a / b)).
  - generalize (2 * a / b). intro l. apply vec_eq; spatial; ring.
  - rewrite !(Fdiv_def (laws K)). ring.
Qed.

(** On a plane it is the step of its gradient. *)
Lemma edge_step_plane (P : plane K) p q x :
  on p P -> on q P -> edge_step p q x = step (slope P) (top q - top p) x.
Proof.
  intros A B. apply on_iff in A, B. unfold edge_step, step. cbn [psub top pz]. rewrite A, B.
  replace (at_plane P (top q) - at_plane P (top p) - dot x (top q - top p))
    with (dot (slope P - x) (top q - top p)) by (spatial; ring).
  reflexivity.
Qed.

Lemma edge_step_parallel p q x :
  ||top q - top p||² <> 0 ->
  exists l, (lift (edge_step p q x) - lift x)%P = (l ** (q - p))%P.
Proof.
  intro N. exists (2 * (pz (q - p)%P - dot x (top (q - p)%P)) / ||top (q - p)%P||²).
  unfold edge_step. cbn zeta. apply point_eq; [apply vec_eq | ]; spatial; field; nonzero.
Qed.

(** Two ways around a face: the steps e0, e1 and back e2, e3 close. *)
Lemma face_commutes (g a b c d x : vec K) :
  ||b - a||² <> 0 -> ||c - b||² <> 0 -> ||d - c||² <> 0 -> ||a - d||² <> 0 ->
  incircle a b c d = 0 ->
  step g (c - b) (step g (b - a) x) = step g (c - d) (step g (d - a) x).
Proof.
  intros N0 N1 N2 N3 I.
  assert (E := thm_1_f_quad_closes g a b c d x N0 N1 N2 N3 I). unfold around in E.
  assert (B : forall e y, ||e||² <> 0 -> step g (- e) y = step g e y).
  { intros e y N. unfold step. replace (||- e||²) with (||e||²) by (coordinates; ring).
    apply vec_eq; coordinates; field; exact N. }
  replace (c - d)%V with (- (d - c))%V by (apply vec_eq; coordinates; ring).
  replace (d - a)%V with (- (a - d))%V by (apply vec_eq; coordinates; ring).
  rewrite !B by assumption.
  set (y := step g (c - b) (step g (b - a) x)) in *. rewrite <- E at 1.
  rewrite (proj1 (proj2 (thm_1_f_mirror g (a - d) (step g (d - c) y) N3))).
  rewrite (proj1 (proj2 (thm_1_f_mirror g (d - c) y N2))). reflexivity.
Qed.

Definition parallel_edge (p q s t : point K) := exists l, (t - s)%P = (l ** (q - p))%P.

Theorem thm_1_f_net m n (p : nat -> nat -> point K) (P : nat -> nat -> plane K) (x : vec K) :
  faces m n (fun i j =>
    on (p i j) (P i j) /\ on (p (S i) j) (P i j) /\ on (p (S i) (S j)) (P i j) /\ on (p i (S j)) (P i j)) ->
  faces m n (fun i j => incircle (top (p i j)) (top (p (S i) j)) (top (p (S i) (S j))) (top (p i (S j))) = 0) ->
  (forall i j, (i < m)%nat -> (j <= n)%nat -> ||top (p (S i) j) - top (p i j)||² <> 0) ->
  (forall i j, (i <= m)%nat -> (j < n)%nat -> ||top (p i (S j)) - top (p i j)||² <> 0) ->
  exists s : nat -> nat -> point K,
    s 0%nat 0%nat = lift x /\
    (forall i j, on_sigma (s i j)) /\
    (forall i j, (i < m)%nat -> (j <= n)%nat -> parallel_edge (p i j) (p (S i) j) (s i j) (s (S i) j)) /\
    (forall i j, (i <= m)%nat -> (j < n)%nat -> parallel_edge (p i j) (p i (S j)) (s i j) (s i (S j))).
Proof.
  intros Q I EH EV.
  set (H i j := edge_step (p i j) (p (S i) j)). set (V i j := edge_step (p i j) (p i (S j))).
  assert (C : faces m n (fun i j => forall y, V (S i) j (H i j y) = H i (S j) (V i j y))).
  { intros i j Li Lj y. destruct (Q i j Li Lj) as (A & B & D & E). unfold H, V.
    rewrite (edge_step_plane (P i j) _ _ y A B), (edge_step_plane (P i j) _ _ y A E).
    rewrite (edge_step_plane (P i j) _ _ _ B D), (edge_step_plane (P i j) _ _ _ E D).
    assert (R : forall a b : vec K, ||b - a||² <> 0 -> ||a - b||² <> 0).
    { intros a b N. replace (||a - b||²) with (||b - a||²) by (coordinates; ring). exact N. }
    assert (Ki := Nat.lt_le_incl _ _ Li). assert (Kj := Nat.lt_le_incl _ _ Lj).
    apply face_commutes;
      [exact (EH i j Li Kj) | exact (EV (S i) j Li Lj) | exact (R _ _ (EH i (S j) Li Lj))
      | exact (R _ _ (EV i j Ki Lj)) | exact (I i j Li Lj)]. }
  destruct (transport (vec K) m n H V x C) as (T0 & T1 & T2).
  exists (fun i j => lift (value (vec K) H V x i j)). split; [reflexivity | split; [ | split]].
  - intros i j. unfold on_sigma, over_sigma. cbn. ring.
  - intros i j Li Lj. unfold parallel_edge. rewrite (T1 i j Li Lj).
    exact (edge_step_parallel _ _ _ (EH i j Li Lj)).
  - intros i j Li Lj. unfold parallel_edge. rewrite (T2 i j).
    exact (edge_step_parallel _ _ _ (EV i j Li Lj)).
Qed.

Lemma thm_1_f_triangle (a b c x : vec K) (r2 : K) :
  ||a||² = r2 -> ||b||² = r2 -> ||c||² = r2 -> r2 <> 0 ->
  ||b - a||² <> 0 -> ||c - b||² <> 0 -> ||a - c||² <> 0 ->
  (step null (a - c) (step null (c - b) (step null (b - a) x)) = x <-> parallel a x).
Proof.
  intros A B C N E0 E1 E2. set (v := corners (a :: b :: c :: nil) a).
  assert (P : periodic 3 v) by (apply cycle_periodic; discriminate).
  assert (Z : forall y : vec K, (y - null)%V = y) by (intro y; apply vec_eq; coordinates; ring).
  assert (I : forall F : vec K -> vec K -> Prop, F a b -> F b c -> F c a -> forall j, F (v j) (v (S j))).
  { intros F F0 F1 F2.
    enough (forall j, F (v j) (v (S j)) /\ F (v (S j)) (v (S (S j))) /\ F (v (S (S j))) (v (S (S (S j)))))
      as G by (intro j; exact (proj1 (G j))).
    induction j as [ | j (G0 & G1 & G2)]; [repeat split; assumption | ].
    split; [exact G1 | split; [exact G2 | ]].
    replace (v (S (S (S j)))) with (v j) by (rewrite <- (P j); f_equal; rewrite Nat.add_comm; reflexivity).
    replace (v (S (S (S (S j))))) with (v (S j))
      by (rewrite <- (P (S j)); f_equal; rewrite Nat.add_comm; reflexivity).
    exact G0. }
  assert (G := thm_1_f_odd null null r2 v x).
  specialize (G (I (fun p _ => ||p - null||² = r2) ltac:(cbv beta; rewrite Z; exact A)
    ltac:(cbv beta; rewrite Z; exact B)
    ltac:(cbv beta; rewrite Z; exact C))).
  specialize (G (I (fun p q => ||q - p||² <> 0) E0 E1 E2) 1%nat N eq_refl).
  rewrite !Z in G. exact G.
Qed.

(** A hole: the triangle a, b, c about the origin and its double, in the plane z = 0. *)
Theorem thm_1_f_ring_sharp (a b c x : vec K) (r2 : K) :
  ||a||² = r2 -> ||b||² = r2 -> ||c||² = r2 -> r2 <> 0 ->
  ||b - a||² <> 0 -> ||c - b||² <> 0 -> ||a - c||² <> 0 ->
  incircle a b (2 ** b) (2 ** a) = 0 /\ incircle b c (2 ** c) (2 ** b) = 0 /\
  incircle c a (2 ** a) (2 ** c) = 0 /\
  (step null (a - c) (step null (c - b) (step null (b - a) x)) = x <-> parallel a x).
Proof.
  intros A B C N E0 E1 E2.
  assert (F : forall p q : vec K, ||p||² = r2 -> ||q||² = r2 -> incircle p q (2 ** q) (2 ** p) = 0).
  { intros p q P Q. rewrite incircle_edges.
    transitivity (det p q * (||q||² - ||p||²) * 2); [coordinates; ring | rewrite P, Q; ring]. }
  repeat split; try (apply F; assumption).
  - intro E. apply (thm_1_f_triangle a b c x r2); assumption.
  - intro E. apply (thm_1_f_triangle a b c x r2); assumption.
Qed.

(** ** Christoffel duality *)

Definition lengths (R : nat -> nat -> K) i j : nat -> K :=
  corners (R i j :: R (S i) j :: R (S i) (S j) :: R i (S j) :: nil) 0.

Definition koebe_face (v : nat -> nat -> vec K) R i j :=
  exists (c : vec K) (r : K) (u : nat -> vec K),
    r <> 0 /\ closed 4 u /\ tangential r u (lengths R i j) /\
    v i j = (c + corner r u (lengths R i j) 0)%V /\
    v (S i) j = (c + corner r u (lengths R i j) 1)%V /\
    v (S i) (S j) = (c + corner r u (lengths R i j) 2)%V /\
    v i (S j) = (c + corner r u (lengths R i j) 3)%V.

Lemma lengths_nonzero R i j : (forall i j, R i j <> 0) -> forall k, lengths R i j k <> 0.
Proof.
  intros N k. unfold lengths, corners, cycle. cbn [length].
  assert (L := Nat.mod_upper_bound k 4 ltac:(discriminate)).
  destruct (k mod 4) as [ | [ | [ | [ | l]]]]; cbn; try apply N.
  exfalso. do 4 apply Nat.succ_lt_mono in L. exact (Nat.nlt_0_r l L).
Qed.

Theorem christoffel_dual_net m n (v : nat -> nat -> vec K) (R : nat -> nat -> K) :
  (forall i j, R i j <> 0) -> faces m n (koebe_face v R) ->
  exists s : nat -> nat -> vec K,
    (forall i j, (i < m)%nat -> (j <= n)%nat ->
      (s (S i) j - s i j)%V = ((1 / (R i j * R (S i) j)) ** (v (S i) j - v i j))%V) /\
    (forall i j, (i <= m)%nat -> (j < n)%nat ->
      (s i (S j) - s i j)%V = ((- (1 / (R i j * R i (S j)))) ** (v i (S j) - v i j))%V) /\
    faces m n (fun i j =>
      mixed 4 (quad (v i j) (v (S i) j) (v (S i) (S j)) (v i (S j)))
        (quad (s i j) (s (S i) j) (s (S i) (S j)) (s i (S j))) = 0).
Proof.
  intros N F.
  set (H i j y := (y + (1 / (R i j * R (S i) j)) ** (v (S i) j - v i j))%V).
  set (V i j y := (y + (- (1 / (R i j * R i (S j)))) ** (v i (S j) - v i j))%V).
  assert (D : faces m n (fun i j => exists w : nat -> vec K, exists z : nat -> vec K,
    closed 4 w /\ closed 4 z /\ mixed 4 z w = 0 /\
    (z 2%nat - z 0%nat)%V = (v (S i) (S j) - v i j)%V /\ (z 3%nat - z 1%nat)%V = (v i (S j) - v (S i) j)%V /\
    (w 1%nat - w 0%nat)%V = ((1 / (R i j * R (S i) j)) ** (v (S i) j - v i j))%V /\
    (w 2%nat - w 1%nat)%V = ((- (1 / (R (S i) j * R (S i) (S j)))) ** (v (S i) (S j) - v (S i) j))%V /\
    (w 2%nat - w 3%nat)%V = ((1 / (R i (S j) * R (S i) (S j))) ** (v (S i) (S j) - v i (S j)))%V /\
    (w 3%nat - w 0%nat)%V = ((- (1 / (R i j * R i (S j)))) ** (v i (S j) - v i j))%V)).
  { intros i j Li Lj. destruct (F i j Li Lj) as (c & r & u & Nr & Cu & T & V0 & V1 & V2 & V3).
    assert (M := lengths_nonzero R i j N).
    assert (CR : closed 4 (lengths R i j)) by reflexivity.
    assert (E := christoffel_dual_edges r u (lengths R i j)).
    assert (CW := christoffel_dual_closes r u (lengths R i j) 2 Cu CR).
    assert (CZ : closed 4 (corner r u (lengths R i j))) by (unfold closed, corner; rewrite Cu, CR; reflexivity).
    exists (dual_corner r u (lengths R i j)), (corner r u (lengths R i j)).
    split; [exact CW | ]. split; [exact CZ | ]. split; [exact (christoffel_dual_mixed r u _ 2 Nr M T CR) | ].
    rewrite V0, V1, V2, V3.
    assert (E0 := E 0%nat Nr M T). assert (E1 := E 1%nat Nr M T). assert (E2 := E 2%nat Nr M T).
    assert (E3 := E 3%nat Nr M T). rewrite CZ in E3. cbn in CW. rewrite CW in E3.
    set (w := dual_corner r u (lengths R i j)) in *. set (z := corner r u (lengths R i j)) in *.
    clearbody w z. unfold lengths, corners, cycle in E0, E1, E2, E3. cbn in E0, E1, E2, E3.
    assert (A := N i j). assert (B := N (S i) j). assert (C := N (S i) (S j)). assert (G := N i (S j)).
    repeat split.
    - apply vec_eq; coordinates; ring.
    - apply vec_eq; coordinates; ring.
    - rewrite E0. apply vec_eq; coordinates; field; nonzero.
    - rewrite E1. apply vec_eq; coordinates; field; nonzero.
    - transitivity (- (w 3%nat - w 2%nat))%V; [apply vec_eq; coordinates; ring | rewrite E2].
      apply vec_eq; coordinates; field; nonzero.
    - transitivity (- (w 0%nat - w 3%nat))%V; [apply vec_eq; coordinates; ring | rewrite E3].
      apply vec_eq; coordinates; field; nonzero. }
  assert (C : faces m n (fun i j => forall y, V (S i) j (H i j y) = H i (S j) (V i j y))).
  { intros i j Li Lj y. destruct (D i j Li Lj) as (w & z & _ & _ & _ & _ & _ & W10 & W21 & W23 & W30).
    unfold H, V. rewrite <- W10, <- W21, <- W23, <- W30. apply vec_eq; coordinates; ring. }
  destruct (transport (vec K) m n H V null C) as (_ & T1 & T2).
  set (s := value (vec K) H V null) in *. clearbody s. exists s.
  assert (S1 : forall i j, (i < m)%nat -> (j <= n)%nat ->
    (s (S i) j - s i j)%V = ((1 / (R i j * R (S i) j)) ** (v (S i) j - v i j))%V).
  { intros i j Li Lj. rewrite (T1 i j Li Lj). unfold H. apply vec_eq; coordinates; ring. }
  assert (S2 : forall i j, (s i (S j) - s i j)%V = ((- (1 / (R i j * R i (S j)))) ** (v i (S j) - v i j))%V).
  { intros i j. rewrite (T2 i j). unfold V. apply vec_eq; coordinates; ring. }
  split; [exact S1 | split; [intros i j _ _; apply S2 | ]].
  intros i j Li Lj. destruct (D i j Li Lj) as (w & z & CW & CZ & Z & Z20 & Z31 & W10 & W21 & W23 & W30).
  apply (cancel K 4); [nonzero | ].
  rewrite eq_20_identity by apply quad_closed.
  unfold quad, corners, cycle. cbn.
  transitivity (4 * mixed 4 z w); [ | rewrite Z; ring]. rewrite (eq_20_identity z w CZ CW), Z20, Z31.
  assert (A : (w 3%nat - w 1%nat)%V = (s i (S j) - s (S i) j)%V).
  { transitivity ((w 3%nat - w 0%nat) - (w 1%nat - w 0%nat))%V; [apply vec_eq; coordinates; ring | ].
    rewrite W30, W10, <- (S2 i j), <- (S1 i j Li (Nat.lt_le_incl _ _ Lj)). apply vec_eq; coordinates; ring. }
  assert (B : (w 2%nat - w 0%nat)%V = (s (S i) (S j) - s i j)%V).
  { transitivity ((w 2%nat - w 1%nat) + (w 1%nat - w 0%nat))%V; [apply vec_eq; coordinates; ring | ].
    rewrite W21, W10, <- (S2 (S i) j), <- (S1 i j Li (Nat.lt_le_incl _ _ Lj)). apply vec_eq; coordinates; ring. }
  rewrite A, B. reflexivity.
Qed.

End Nets.
