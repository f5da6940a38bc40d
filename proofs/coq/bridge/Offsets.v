(** (15)-(18): the recorded programs say what the paper writes.

    Areas are those of the shoelace formula, once around the polygon. *)

Require Import ZArith List Field.
Require Import Isogeo.program.Script.
Require Isogeo.recorded.eq_17_18 Isogeo.recorded.cmc_offset Isogeo.recorded.cgc_offset.
Import ListNotations.

(** What a theorem says, written out; the kernel compares by computation. *)
Ltac known theorem T :=
  let says := type of theorem in
  let out := eval vm_compute in says in
  assert (T : out) by vm_cast_no_check theorem.

Section Offsets.
  (** Any field. *)
  Variable F : Type.
  Variables (zero one : F) (add mul sub : F -> F -> F) (opp : F -> F) (div : F -> F -> F).
  Variable inv : F -> F.
  Hypothesis laws : field_theory zero one add mul sub opp div inv eq.

  Add Field the_field : laws.
  Notation "0" := zero.
  Notation "1" := one.
  Infix "+" := add.
  Infix "*" := mul.
  Infix "-" := sub.
  Infix "/" := div.
  Notation "- x" := (opp x).

  (** The field as the recorded programs know it. *)
  Definition field : Script.field := Field F zero one add mul sub opp div inv laws.

  Definition point : Type := F * F.
  Definition two : F := 1 + 1.
  Definition det (v w : point) : F := fst v * snd w - snd v * fst w.

  Fixpoint sum (l : list F) : F :=
    match l with
    | [] => 0
    | x :: l => x + sum l
    end.

  (** Each corner with the next, the last with the first. *)
  Definition edges {A} (polygon : list A) : list (A * A) :=
    match polygon with
    | [] => []
    | first :: rest => combine polygon (rest ++ [first])
    end.

  (** [2 area(F)], (15). *)
  Definition twice_area (f : list point) : F :=
    sum (map (fun e => det (fst e) (snd e)) (edges f)).

  (** [4 area(F, S)], (16). *)
  Definition four_mixed_areas (f s : list point) : F :=
    sum (map (fun e => let '((v, w), (v', w')) := e in det v w' + det w v') (edges (combine f s))).

  (** [F + dS]. *)
  Definition offset (f s : list point) (d : F) : list point :=
    map (fun p => let '((x, y), (u, v)) := p in (x + d * u, y + d * v)) (combine f s).

  (** (17). *)
  Definition K (f s : list point) : F := twice_area s / twice_area f.
  Definition H (f s : list point) : F := four_mixed_areas f s / (two * twice_area f).

  (** (18). *)
  Definition law (f s : list point) (d : F) : Prop :=
    two * twice_area f <> 0 -> two * twice_area (offset f s d) <> 0 ->
    let scale := 1 + two * d * H f s + d * d * K f s in
    K (offset f s d) s = K f s / scale /\
    H (offset f s d) s = (H f s + d * K f s) / scale.

  Lemma read (B B' M M' G d A A' S m m' : F) :
    B <> 0 -> B' <> 0 ->
    1 + d * (M * (1 / B) + (M * (1 / B) + d * (G * (1 / B)))) <> 0 ->
    M' * (1 / B') = (M * (1 / B) + d * (G * (1 / B)))
      * (1 / (1 + d * (M * (1 / B) + (M * (1 / B) + d * (G * (1 / B)))))) ->
    G * (1 / B') = G * (1 / B)
      * (1 / (1 + d * (M * (1 / B) + (M * (1 / B) + d * (G * (1 / B)))))) ->
    B = two * A -> B' = two * A' -> G = two * S -> M = m -> M' = m' ->
    let scale := 1 + two * d * (m / (two * A)) + d * d * (S / A) in
    S / A' = S / A / scale /\ m' / (two * A') = (m / (two * A) + d * (S / A)) / scale.
  Proof.
    intros NB NB' N EM EG EB EB' ES <- <-. subst B B' G.
    assert (Nt : two <> 0). { intro Z. apply NB. rewrite Z. ring. }
    assert (NA : A <> 0). { intro Z. apply NB. rewrite Z. ring. }
    assert (NA' : A' <> 0). { intro Z. apply NB'. rewrite Z. ring. }
    assert (L : 1 + d * (M * (1 / (two * A)) + (M * (1 / (two * A)) + d * (two * S * (1 / (two * A)))))
      = 1 + two * d * (M / (two * A)) + d * d * (S / A)).
    { unfold two in *. field. split; assumption. }
    rewrite L in N, EM, EG. cbv zeta. set (scale := 1 + two * d * _ + _) in *.
    split.
    - transitivity (two * S * (1 / (two * A'))); [field; split; assumption|].
      rewrite EG. field. repeat split; assumption.
    - transitivity (M * (1 / (two * A')) + (M' - M) * (1 / (two * A'))); [field; split; assumption|].
      transitivity (M' * (1 / (two * A'))); [ring|]. rewrite EM. field. repeat split; assumption.
  Qed.

  Ltac same_areas :=
    cbv [offset four_mixed_areas twice_area two det sum edges map combine app fst snd]; ring.

  Lemma difference_zero (x y : F) : x - y = 0 -> x = y.
  Proof. intro E. transitivity (x - y + y); [ring|]. rewrite E. ring. Qed.

  (** The law, from what was recorded for these corners. *)
  Ltac recorded theorem Nf No :=
    let T := fresh in known theorem T;
    match type of T with
    | (?v = _ -> _) -> (?w = _ -> _) -> _ =>
      let N := fresh in let N' := fresh in
      assert (N : v <> 0) by (let E := fresh in
        intro E; apply Nf; transitivity v; [same_areas|exact E]);
      assert (N' : w <> 0) by (let E := fresh in
        intro E; apply No; transitivity w; [same_areas|exact E]);
      specialize (T N N')
    end;
    let NB := fresh in let NB' := fresh in let N := fresh in
    let EH := fresh in let EK := fresh in
    destruct T as (_ & NB & N & NB' & EH & EK & _);
    apply difference_zero in EH, EK;
    match goal with
    | |- context [K (offset ?f ?s ?d) _] =>
      exact (read _ _ _ _ _ _ (twice_area f) (twice_area (offset f s d)) (twice_area s)
        (four_mixed_areas f s) (four_mixed_areas (offset f s d) s) NB NB' N EH EK
        ltac:(same_areas) ltac:(same_areas) ltac:(same_areas) ltac:(same_areas)
        ltac:(same_areas))
    end.

  Theorem eq_18_triangles (f0 f1 f2 s0 s1 s2 : point) (d : F) :
    law [f0; f1; f2] [s0; s1; s2] d.
  Proof.
    destruct f0 as [x0 y0], f1 as [x1 y1], f2 as [x2 y2], s0 as [u0 v0], s1 as [u1 v1],
      s2 as [u2 v2].
    intros Nf No. cbv zeta.
    recorded (eq_17_18.part_1_size_3_valid field
      [x0; y0; x1; y1; x2; y2; u0; v0; u1; v1; u2; v2; d]) Nf No.
  Qed.

  Theorem eq_18_quads (f0 f1 f2 f3 s0 s1 s2 s3 : point) (d : F) :
    law [f0; f1; f2; f3] [s0; s1; s2; s3] d.
  Proof.
    destruct f0 as [x0 y0], f1 as [x1 y1], f2 as [x2 y2], f3 as [x3 y3], s0 as [u0 v0],
      s1 as [u1 v1], s2 as [u2 v2], s3 as [u3 v3].
    intros Nf No. cbv zeta.
    recorded (eq_17_18.part_1_size_4_valid field
      [x0; y0; x1; y1; x2; y2; x3; y3; u0; v0; u1; v1; u2; v2; u3; v3; d]) Nf No.
  Qed.

  (** After (18): at [d = -1/H] the mean curvature of the offset is [-H]. *)
  Theorem opposite_mean (h k : F) : h <> 0 -> h * h - k <> 0 ->
    let d := 1 / - h in
    (h + d * k) / (1 + two * d * h + d * d * k) = - h.
  Proof.
    intros Nh N.
    known (cmc_offset.part_1_size_1_valid field [h; k]) T.
    destruct (T Nh N) as (Nd & Ns & E & _). clear T.
    assert (L : 1 + two * (1 / - h) * h + (1 / - h) * (1 / - h) * k
      = 1 + (1 / - h) * (h + (h + (1 / - h) * k))) by (unfold two; ring).
    cbv zeta. rewrite L.
    transitivity ((h + (1 / - h) * k) * (1 / (1 + (1 / - h) * (h + (h + (1 / - h) * k))))
      + h - h); [|rewrite E; ring].
    set (d := 1 / - h) in *. field. exact Ns.
  Qed.

  (** At [d = -1/2H] the curvature of the offset is [4 H^2]. *)
  Theorem constant_gauss (h k : F) : two <> 0 -> h <> 0 -> k <> 0 ->
    let d := 1 / - (two * h) in
    k / (1 + two * d * h + d * d * k) = two * two * (h * h).
  Proof.
    intros N2 Nh Nk.
    known (cgc_offset.part_1_size_1_valid field [h; k]) T.
    destruct (T N2 Nh Nk) as (Nd & Ns & E & _). clear T.
    apply difference_zero in E. unfold two in *.
    replace (- ((1 + 1) * h)) with (- (1 + 1) * h) by ring.
    cbv zeta. set (d := 1 / (- (1 + 1) * h)) in *. rewrite <- E.
    replace (1 + (1 + 1) * d * h + d * d * k) with (1 + d * (h + (h + d * k))) by ring.
    field. exact Ns.
  Qed.
End Offsets.
