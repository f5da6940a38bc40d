(** * The Christoffel dual of a quad is unique

    Of two parallel quads with mixed area 0 one determines the other up to scale and translation; so the
    dual of a quad with an incircle has one.

    - [proper v]: no two consecutive sides of the quad are parallel.

    Statements
    - [christoffel_dual_unique]: two quads that are parallel to v with mixed area 0, the first not a
      point, are homothetic;
    - [eq_20_incircle]: a quad that is parallel to one with an incircle, with mixed area 0, has one.

    Unsaid in the paper: S is not a point, no vertex of F lies on its incircle; F is proper. *)

From Isogeo.theory Require Export Quads Christoffel.

Section Quads.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types v w : nat -> vec K.

Definition proper v :=
  let e j := (v (S j) - v j)%V in
  det (e 0%nat) (e 1%nat) <> 0 /\ det (e 1%nat) (e 2%nat) <> 0 /\
  det (e 2%nat) (e 3%nat) <> 0 /\ det (e 3%nat) (e 0%nat) <> 0.

Lemma det_nonzero_left (a b : vec K) : det a b <> 0 -> a <> null.
Proof. intros D Z. apply D. rewrite Z. coordinates. ring. Qed.

Definition multiples v w (l : nat -> K) :=
  forall j, (j < 4)%nat -> (w (S j) - w j)%V = (l j ** (v (S j) - v j))%V.

Lemma multiples_exist v w : proper v -> parallel_quads v w -> exists l, multiples v w l.
Proof.
  intros (D0 & D1 & D2 & D3) P.
  destruct (parallel_multiple _ _ (det_nonzero_left _ _ D0) (P 0%nat ltac:(repeat constructor))) as [l0 E0].
  destruct (parallel_multiple _ _ (det_nonzero_left _ _ D1) (P 1%nat ltac:(repeat constructor))) as [l1 E1].
  destruct (parallel_multiple _ _ (det_nonzero_left _ _ D2) (P 2%nat ltac:(repeat constructor))) as [l2 E2].
  destruct (parallel_multiple _ _ (det_nonzero_left _ _ D3) (P 3%nat ltac:(repeat constructor))) as [l3 E3].
  exists (fun j => match j with O => l0 | 1 => l1 | 2 => l2 | _ => l3 end)%nat.
  intros j L. destruct j as [ | [ | [ | [ | j]]]]; try assumption.
  exfalso. do 4 apply Nat.succ_lt_mono in L. exact (Nat.nlt_0_r j L).
Qed.

(** The factors of consecutive sides are in the ratios of the corners of F. *)
Lemma dual_ratios v w l :
  closed 4 v -> closed 4 w -> parallel_quads v w -> multiples v w l -> mixed 4 v w = 0 ->
  let e j := (v (S j) - v j)%V in
  l 0%nat * det (e 3%nat) (e 0%nat) = - (l 1%nat * det (e 1%nat) (e 2%nat)) /\
  l 2%nat * det (e 2%nat) (e 3%nat) = - (l 1%nat * det (e 0%nat) (e 1%nat)) /\
  l 3%nat * det (e 2%nat) (e 3%nat) = - (l 0%nat * det (e 0%nat) (e 1%nat)).
Proof.
  intros C D P M Z e.
  assert (E := eq_20_one_diagonal v w C D P). assert (G := eq_20_other_diagonal v w C D P).
  rewrite Z in E, G.
  assert (M0 := M 0%nat ltac:(repeat constructor)). assert (M1 := M 1%nat ltac:(repeat constructor)).
  assert (M2 := M 2%nat ltac:(repeat constructor)). assert (M3 := M 3%nat ltac:(repeat constructor)).
  unfold e. rewrite C, D in *. clear M.
  assert (W20 : (w 2%nat - w 0%nat = l 0%nat ** (v 1%nat - v 0%nat) + l 1%nat ** (v 2%nat - v 1%nat))%V)
    by (rewrite <- M0, <- M1; apply vec_eq; coordinates; ring).
  assert (W31 : (w 3%nat - w 1%nat = l 1%nat ** (v 2%nat - v 1%nat) + l 2%nat ** (v 3%nat - v 2%nat))%V)
    by (rewrite <- M1, <- M2; apply vec_eq; coordinates; ring).
  assert (W31' : (w 3%nat - w 1%nat = - (l 3%nat ** (v 0%nat - v 3%nat) + l 0%nat ** (v 1%nat - v 0%nat)))%V)
    by (rewrite <- M3, <- M0; apply vec_eq; coordinates; ring).
  assert (E' := E). rewrite W31 in E. rewrite W31' in E'. rewrite W20 in G.
  set (a := v 0%nat) in *. set (b := v 1%nat) in *. set (c := v 2%nat) in *. set (d := v 3%nat) in *.
  clearbody a b c d. clear - E E' G.
  repeat split; apply difference_zero.
  - transitivity (- det (l 0%nat ** (b - a) + l 1%nat ** (c - b)) (d - b) * - (1)); [coordinates; ring | ].
    rewrite <- G. ring.
  - transitivity (det (c - a) (l 1%nat ** (c - b) + l 2%nat ** (d - c))); [coordinates; ring | ].
    rewrite <- E. ring.
  - transitivity (det (c - a) (- (l 3%nat ** (a - d) + l 0%nat ** (b - a)))); [coordinates; ring | ].
    rewrite <- E'. ring.
Qed.

Theorem christoffel_dual_unique v w w' :
  closed 4 v -> closed 4 w -> closed 4 w' -> proper v ->
  parallel_quads v w -> parallel_quads v w' -> mixed 4 v w = 0 -> mixed 4 v w' = 0 ->
  (exists j, (j < 4)%nat /\ w (S j) <> w j) ->
  exists c t, forall j, (j <= 4)%nat -> w' j = (c ** w j + t)%V.
Proof.
  intros Cv Cw Cw' D P P' Z Z' (i & Li & Ni).
  destruct (multiples_exist v w D P) as [l L]. destruct (multiples_exist v w' D P') as [l' L'].
  destruct (dual_ratios v w l Cv Cw P L Z) as (A0 & A2 & A3).
  destruct (dual_ratios v w' l' Cv Cw' P' L' Z') as (B0 & B2 & B3).
  destruct D as (D0 & D1 & D2 & D3). cbn zeta in *.
  set (e j := (v (S j) - v j)%V) in *. fold (e 0%nat) (e 1%nat) (e 2%nat) (e 3%nat) in *.
  set (d01 := det (e 0%nat) (e 1%nat)) in *. set (d12 := det (e 1%nat) (e 2%nat)) in *.
  set (d23 := det (e 2%nat) (e 3%nat)) in *. set (d30 := det (e 3%nat) (e 0%nat)) in *.
  assert (Q : forall j, (j < 4)%nat -> exists q, l j = q * l 1%nat /\ l' j = q * l' 1%nat).
  { assert (Q0 : l 0%nat = - (d12 / d30) * l 1%nat /\ l' 0%nat = - (d12 / d30) * l' 1%nat).
    { split; apply (equals_by K d30); try exact D3.
      - transitivity (l 0%nat * d30); [ring | rewrite A0; field; exact D3].
      - transitivity (l' 0%nat * d30); [ring | rewrite B0; field; exact D3]. }
    intros j Lj. destruct j as [ | [ | [ | [ | j]]]].
    - exists (- (d12 / d30)). exact Q0.
    - exists 1. split; ring.
    - exists (- (d01 / d23)). split; apply (equals_by K d23); try exact D2.
      + transitivity (l 2%nat * d23); [ring | rewrite A2; field; exact D2].
      + transitivity (l' 2%nat * d23); [ring | rewrite B2; field; exact D2].
    - exists (d01 / d23 * (d12 / d30)). split; apply (equals_by K d23); try exact D2.
      + transitivity (l 3%nat * d23); [ring | rewrite A3, (proj1 Q0); field; split; assumption].
      + transitivity (l' 3%nat * d23); [ring | rewrite B3, (proj2 Q0); field; split; assumption].
    - exfalso. do 4 apply Nat.succ_lt_mono in Lj. exact (Nat.nlt_0_r j Lj). }
  assert (N : l 1%nat <> 0).
  { intro O. apply Ni, vsub_zero. rewrite (L i Li). destruct (Q i Li) as (q & -> & _). rewrite O.
    apply vec_eq; coordinates; ring. }
  exists (l' 1%nat / l 1%nat), (w' 0%nat - (l' 1%nat / l 1%nat) ** w 0%nat)%V.
  assert (Step : forall j, (j < 4)%nat -> (w' (S j) - w' j)%V = ((l' 1%nat / l 1%nat) ** (w (S j) - w j))%V).
  { intros j Lj. rewrite (L j Lj), (L' j Lj). destruct (Q j Lj) as (q & -> & ->).
    apply vec_eq; coordinates; field; exact N. }
  induction j as [ | j IH]; intro Lj.
  - apply vec_eq; coordinates; ring.
  - assert (G := Step j Lj). specialize (IH (Nat.lt_le_incl _ _ Lj)).
    transitivity ((w' (S j) - w' j) + w' j)%V; [apply vec_eq; coordinates; ring | ].
    rewrite G, IH. apply vec_eq; coordinates; ring.
Qed.

Lemma dual_parallel (r : K) u R :
  r <> 0 -> (forall j, R j <> 0) -> tangential r u R ->
  parallel_quads (corner r u R) (dual_corner r u R).
Proof.
  intros N M T j _. rewrite christoffel_dual_edges by assumption. coordinates. ring.
Qed.

Theorem eq_20_incircle (r : K) u R w :
  r <> 0 -> (forall j, R j <> 0) -> tangential r u R -> closed 4 u -> closed 4 R ->
  proper (corner r u R) ->
  closed 4 w -> parallel_quads (corner r u R) w -> mixed 4 (corner r u R) w = 0 ->
  (exists j, (j < 4)%nat /\ w (S j) <> w j) ->
  exists m rho2, has_incircle 4 w m rho2.
Proof.
  intros N M T U C D Cw P Z (i & Li & Ni).
  assert (Cv : closed 4 (corner r u R)) by (unfold closed, corner; rewrite U, C; reflexivity).
  assert (Cd : closed 4 (dual_corner r u R)) by exact (christoffel_dual_closes r u R 2 U C).
  destruct (christoffel_dual_unique (corner r u R) (dual_corner r u R) w) as (c & t & E); try assumption.
  - exact (dual_parallel r u R N M T).
  - exact (christoffel_dual_mixed r u R 2 N M T C).
  - exists 0%nat. split; [repeat constructor | ]. intro O. apply vsub_zero in O.
    rewrite christoffel_dual_edges in O by assumption.
    apply scale_zero in O.
    + apply quotient_zero in O; [exact (one_nonzero K O) | ].
      apply product_nonzero; apply M.
    + destruct D as (D & _). exact (det_nonzero_left _ _ D).
  - assert (H : c <> 0).
    { intro O. apply Ni. rewrite (E (S i) Li), (E i (Nat.lt_le_incl _ _ Li)), O.
      apply vec_eq; coordinates; ring. }
    assert (I : - (1 / r) <> 0).
    { intro O. apply opposite_zero, quotient_zero in O; [exact (one_nonzero K O) | exact N]. }
    destruct (tangential_incircle 4 _ _ _ I (christoffel_dual_tangential r u R N M T)) as [A B].
    exists t, (c² * ((- (1 / r))²)). split; [nonzero | ].
    intros j Lj. rewrite (E (S j) Lj), (E j (Nat.lt_le_incl _ _ Lj)).
    specialize (B j Lj). fold (dual_corner r u R) in B.
    set (a := dual_corner r u R (S j)) in *. set (b := dual_corner r u R j) in *. clearbody a b.
    transitivity (c² * c² * (det (a - b) (null - b))²); [coordinates; ring | ].
    rewrite B. coordinates. ring.
Qed.

End Quads.
