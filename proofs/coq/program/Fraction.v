(** Fractions of polynomials: a numerator over an integer and powers of known factors.

    Denominators are products of the factors that were divided by; the factors that divide the
    numerator are cancelled by trial. *)

Require Import ZArith Bool List Lia Field.
Require Import Isogeo.program.Script Isogeo.program.Polynomial.
Require Ring_polynom.
Import ListNotations.

Record fraction := Fraction { num : poly; int : Z; den : list nat }.

Definition of_poly (p : poly) : fraction := Fraction p 1 [].

(** [p] times powers of factors. *)
Fixpoint times_power (p f : poly) (n : nat) : poly :=
  match n with
  | O => p
  | S n => times_power (pmul p f) f n
  end.

Fixpoint times_powers (factors : list poly) (e : list nat) (p : poly) : poly :=
  match factors, e with
  | f :: factors, n :: e => times_powers factors e (times_power p f n)
  | _, _ => p
  end.

(** The greater powers, and what the first and the second lack of them. *)
Fixpoint common (a b : list nat) : list nat * list nat * list nat :=
  match a, b with
  | [], _ => (b, b, [])
  | _, [] => (a, [], a)
  | m :: a, n :: b =>
    let '(c, x, y) := common a b in (max m n :: c, max m n - m :: x, max m n - n :: y)
  end.

Fixpoint sum_of_powers (a b : list nat) : list nat :=
  match a, b with
  | [], _ => b
  | _, [] => a
  | m :: a, n :: b => m + n :: sum_of_powers a b
  end.

(** Cancels a factor up to [n] times; what remains of the numerator and of the power. *)
Fixpoint cancel (p f : poly) (n : nat) : poly * nat :=
  match n with
  | O => (p, O)
  | S m =>
    match exact p f with
    | Some q => cancel q f m
    | None => (p, n)
    end
  end.

(** Cancels the chosen factors. *)
Fixpoint cancel_all (factors : list poly) (e : list nat) (which : list bool) (p : poly)
  : poly * list nat :=
  match factors, e with
  | f :: factors, n :: e =>
    let (p, m) := if hd true which then cancel p f n else (p, n) in
    let (p, rest) := cancel_all factors e (tl which) p in
    (p, m :: rest)
  | _, _ => (p, e)
  end.

(** Without the common divisor of the integers. *)
Definition reduced (f : fraction) : fraction :=
  if is_zero (num f) then of_poly (Ring_polynom.Pc 0%Z)
  else if Z.eqb (int f) 1 then f
  else
    let (c, p) := primitive (num f) in
    let g := Z.gcd c (int f) in
    if Z.eqb (int f) (int f / g * g) && Z.eqb c (c / g * g)
    then Fraction (scaled p (c / g)) (int f / g) (den f) else f.

Fixpoint equal_powers (a b : list nat) : list bool :=
  match a, b with
  | m :: a, n :: b => Nat.eqb m n :: equal_powers a b
  | _, _ => map (fun _ => false) (a ++ b)
  end.

(** Only a factor of both, in the same power, may divide the sum. *)
Definition plus (factors : list poly) (a b : fraction) : fraction :=
  let '(e, x, y) := common (den a) (den b) in
  let '(n, m) := if Z.eqb (int a) (int b) then (1, 1)%Z else (int b, int a) in
  let p := padd (times_powers factors x (scaled (num a) n))
                (times_powers factors y (scaled (num b) m)) in
  let (p, e) := cancel_all factors e (equal_powers (den a) (den b)) p in
  reduced (Fraction p (int a * n) e).

Definition opposite (a : fraction) : fraction := Fraction (popp (num a)) (int a) (den a).

Definition times (factors : list poly) (a b : fraction) : fraction :=
  let (p, e) := cancel_all factors (den b) [] (num a) in
  let (q, f) := cancel_all factors (den a) [] (num b) in
  reduced (Fraction (pmul p q) (int a * int b) (sum_of_powers e f)).

(** The unknowns that divide [p] become factors. *)
Fixpoint with_unknowns (factors : list poly) (n : nat) (p : poly) : list poly :=
  match n with
  | O => factors
  | S n =>
    let factors := with_unknowns factors n p in
    match exact p (unknown n) with
    | Some _ => if existsb (peq (unknown n)) factors then factors else factors ++ [unknown n]
    | None => factors
    end
  end.

(** No power beyond this is looked for. *)
Definition most : nat := 64.

(** The powers of the factors in [p], and the rest. *)
Fixpoint peeled (factors : list poly) (p : poly) : list nat * poly :=
  match factors with
  | [] => ([], p)
  | f :: factors =>
    let (q, n) := match p with Ring_polynom.Pc _ => (p, most) | _ => cancel p f most end in
    let (e, rest) := peeled factors q in
    (most - n :: e, rest)
  end.

(** A polynomial as integer and powers of factors, of which there may be a new one. *)
Definition split (unknowns : nat) (factors : list poly) (p : poly) : Z * list nat * list poly :=
  let (c, p) := primitive p in
  let factors := with_unknowns factors unknowns p in
  let (e, rest) := peeled factors p in
  match rest with
  | Ring_polynom.Pc r => ((c * r)%Z, e, factors)
  | _ => (c, e ++ [1], factors ++ [rest])
  end.

Definition ratio (unknowns : nat) (factors : list poly) (a b : fraction)
  : fraction * list poly :=
  let '(c, e, factors) := split unknowns factors (num b) in
  let '(_, x, y) := common (den a) (den b) in
  let (p, e) := cancel_all factors e [] (num a) in
  let p := times_powers factors x (scaled p (int b)) in
  (reduced (Fraction p (int a * c) (sum_of_powers y e)), factors).

(** ** Values *)

Section Values.
  Variable F : field.
  Variable l : list F.

  Add Field the_field : (laws F).

  Notation "0" := (zero F).
  Notation "1" := (one F).
  Notation "x + y" := (add F x y).
  Notation "x * y" := (mul F x y).
  Notation "- x" := (opp F x).
  Notation "x / y" := (div F x y).
  Notation at_ := (at_ F l).
  Notation integer := (integer F).

  Lemma integer_mul m n : integer (m * n) = integer m * integer n.
  Proof. exact (Ring_theory.morph_mul (integers F) m n). Qed.

  Lemma one_not_zero : 1 <> 0.
  Proof. exact (Field_theory.F_1_neq_0 (laws F)). Qed.

  Lemma product_zero x y : x * y = 0 -> y <> 0 -> x = 0.
  Proof.
    intros E N. transitivity (x * y / y); [now field|]. rewrite E. now field.
  Qed.

  Lemma product_nonzero x y : x <> 0 -> y <> 0 -> x * y <> 0.
  Proof. intros Nx Ny E. apply Nx. now apply (product_zero x y). Qed.

  Lemma left_nonzero x y : x * y <> 0 -> x <> 0.
  Proof. intros N E. apply N. rewrite E. ring. Qed.

  Lemma right_nonzero x y : x * y <> 0 -> y <> 0.
  Proof. intros N E. apply N. rewrite E. ring. Qed.

  Lemma cancelled x y z : x * z = y * z -> z <> 0 -> x = y.
  Proof.
    intros E N. transitivity (x * z / z); [now field|]. rewrite E. now field.
  Qed.

  Fixpoint power (x : F) (n : nat) : F :=
    match n with
    | O => 1
    | S n => x * power x n
    end.

  Lemma power_add x m n : power x (m + n) = power x m * power x n.
  Proof. induction m as [|m IH]; cbn [power Nat.add]; [ring|]. rewrite IH. ring. Qed.

  Lemma power_nonzero x n : x <> 0 -> power x n <> 0.
  Proof.
    intro N. induction n as [|n IH]; cbn [power]; [exact one_not_zero|].
    now apply product_nonzero.
  Qed.

  (** The product of powers of the factors. *)
  Fixpoint product (factors : list poly) (e : list nat) : F :=
    match factors, e with
    | f :: factors, n :: e => power (at_ f) n * product factors e
    | _, _ => 1
    end.

  Definition all_nonzero : list poly -> Prop := Forall (fun f => at_ f <> 0).

  Lemma product_nil factors : product factors [] = 1.
  Proof. now destruct factors. Qed.

  Lemma product_not_zero factors : all_nonzero factors -> forall e, product factors e <> 0.
  Proof.
    induction 1 as [|f factors N _ IH]; intros [|n e]; cbn [product]; try exact one_not_zero.
    apply product_nonzero; [now apply power_nonzero|apply IH].
  Qed.

  Lemma product_app factors more e :
    (length e <= length factors)%nat -> product (factors ++ more) e = product factors e.
  Proof.
    revert e. induction factors as [|f factors IH]; intros [|n e] H; cbn in *;
      try (now rewrite product_nil); try lia.
    - reflexivity.
    - now rewrite IH by lia.
  Qed.

  Lemma at_times_power f n : forall p, at_ (times_power p f n) = at_ p * power (at_ f) n.
  Proof.
    induction n as [|n IH]; intro p; cbn [times_power power]; [ring|].
    rewrite IH, at_mul. ring.
  Qed.

  Lemma at_times_powers factors : forall e p,
    at_ (times_powers factors e p) = at_ p * product factors e.
  Proof.
    induction factors as [|f factors IH]; intros [|n e] p; cbn [times_powers product]; try ring.
    rewrite IH, at_times_power. ring.
  Qed.

  Lemma common_length a : forall b e x y, common a b = (e, x, y) ->
    length e = max (length a) (length b) /\ (length x <= length b)%nat /\
    (length y <= length a)%nat.
  Proof.
    induction a as [|m a IH]; intros [|n b] e x y; cbn [common]; intro E.
    1-3: injection E as <- <- <-; cbn; lia.
    destruct (common a b) as [[c x'] y'] eqn:C. injection E as <- <- <-.
    specialize (IH _ _ _ _ C). cbn. lia.
  Qed.

  Lemma common_product factors : forall a b e x y, common a b = (e, x, y) ->
    product factors e = product factors a * product factors x /\
    product factors e = product factors b * product factors y.
  Proof.
    induction factors as [|f factors IH]; intros a b e x y E; [cbn; split; ring|].
    destruct a as [|m a], b as [|n b]; cbn [common] in E.
    1-3: injection E as <- <- <-; cbn [product]; split; ring.
    destruct (common a b) as [[c x'] y'] eqn:C. injection E as <- <- <-.
    destruct (IH _ _ _ _ _ C) as [Ha Hb]. cbn [product].
    split; [rewrite Ha|rewrite Hb].
    - replace (max m n) with (m + (max m n - m))%nat at 1 by lia. rewrite power_add. ring.
    - replace (max m n) with (n + (max m n - n))%nat at 1 by lia. rewrite power_add. ring.
  Qed.

  Lemma sum_of_powers_length a : forall b,
    length (sum_of_powers a b) = max (length a) (length b).
  Proof. induction a as [|m a IH]; intros [|n b]; cbn; auto. Qed.

  Lemma sum_of_powers_product factors : forall a b,
    product factors (sum_of_powers a b) = product factors a * product factors b.
  Proof.
    induction factors as [|f factors IH]; intros a b; [cbn; ring|].
    destruct a as [|m a], b as [|n b]; cbn [sum_of_powers product]; try ring.
    rewrite IH, power_add. ring.
  Qed.

  Lemma cancel_sound f : at_ f <> 0 -> forall n p q m v c, cancel p f n = (q, m) ->
    v * (power (at_ f) n * c) = at_ p -> v * (power (at_ f) m * c) = at_ q.
  Proof.
    intro N. induction n as [|n IH]; intros p q m v c; cbn [cancel]; intros E H.
    - injection E as <- <-. exact H.
    - destruct (exact p f) as [r|] eqn:X; [|injection E as <- <-; exact H].
      apply (IH _ _ _ _ _ E). apply at_exact with (F := F) (l := l) in X.
      apply cancelled with (z := at_ f); [|exact N].
      rewrite <- X, <- H. cbn [power]. ring.
  Qed.

  Lemma cancel_all_sound factors : all_nonzero factors -> forall e which p q d v c,
    cancel_all factors e which p = (q, d) ->
    v * (c * product factors e) = at_ p -> v * (c * product factors d) = at_ q.
  Proof.
    induction 1 as [|f factors N _ IH]; intros e which p q d v c; cbn [cancel_all]; intros E H.
    { injection E as <- <-. exact H. }
    destruct e as [|n e]. { injection E as <- <-. exact H. }
    assert (exists q0 m, (if hd true which then cancel p f n else (p, n)) = (q0, m) /\
      v * (power (at_ f) m * (c * product factors e)) = at_ q0) as (q0 & m & X & H0).
    { destruct (hd true which).
      - destruct (cancel p f n) as [q0 m] eqn:C. exists q0, m. split; [reflexivity|].
        apply (cancel_sound f N n p q0 m); [exact C|]. rewrite <- H. cbn [product]. ring.
      - exists p, n. split; [reflexivity|]. rewrite <- H. cbn [product]. ring. }
    rewrite X in E. destruct (cancel_all factors e (tl which) q0) as [q1 r] eqn:C.
    injection E as <- <-. cbn [product].
    replace (c * (power (at_ f) m * product factors r))
      with ((c * power (at_ f) m) * product factors r) by ring.
    apply (IH _ _ _ _ _ _ _ C). rewrite <- H0. ring.
  Qed.

  Lemma cancel_all_length factors : forall e which p q d,
    cancel_all factors e which p = (q, d) -> length d = length e.
  Proof.
    induction factors as [|f factors IH]; intros e which p q d; cbn [cancel_all]; intro E.
    { now injection E as <- <-. }
    destruct e as [|n e]. { now injection E as <- <-. }
    destruct (if hd true which then cancel p f n else (p, n)) as [q0 m].
    destruct (cancel_all factors e (tl which) q0) as [q1 r] eqn:C.
    injection E as <- <-. cbn. now rewrite (IH _ _ _ _ _ C).
  Qed.

  (** A fraction stands for a value. *)
  Record sound (factors : list poly) (f : fraction) (v : F) : Prop := Sound {
    bounded : (length (den f) <= length factors)%nat;
    defined : integer (int f) <> 0;
    equal : v * (integer (int f) * product factors (den f)) = at_ (num f)
  }.

  Lemma sound_more factors more f v : sound factors f v -> sound (factors ++ more) f v.
  Proof.
    intros [B N E]. split; [rewrite app_length; lia|exact N|]. now rewrite product_app.
  Qed.

  Lemma of_poly_sound factors p : sound factors (of_poly p) (at_ p).
  Proof.
    split; [cbn; lia|exact one_not_zero|].
    cbn [of_poly num int den]. rewrite product_nil. change (integer 1) with 1. ring.
  Qed.

  Section Factors.
    Variable factors : list poly.
    Hypothesis nonzero : all_nonzero factors.

    Lemma denominator_nonzero f v : sound factors f v ->
      integer (int f) * product factors (den f) <> 0.
    Proof. intros [_ N _]. apply product_nonzero; [exact N|now apply product_not_zero]. Qed.

    Lemma numerator_zero f v : sound factors f v -> at_ (num f) = 0 -> v = 0.
    Proof.
      intros S Z. pose proof (denominator_nonzero f v S) as N. destruct S as [_ _ E].
      rewrite Z in E. exact (product_zero _ _ E N).
    Qed.

    Lemma zero_numerator f v : sound factors f v -> v = 0 -> at_ (num f) = 0.
    Proof. intros [_ _ E] ->. rewrite <- E. ring. Qed.

    Lemma reduced_sound f v : sound factors f v -> sound factors (reduced f) v.
    Proof.
      intro S. unfold reduced. destruct (is_zero (num f)) eqn:Z.
      - replace v with (at_ (Ring_polynom.Pc 0%Z)); [apply of_poly_sound|].
        unfold is_zero in Z. apply at_eq with (F := F) (l := l) in Z.
        symmetry. rewrite (numerator_zero f v S); [reflexivity|]. rewrite Z. reflexivity.
      - destruct (Z.eqb (int f) 1); [exact S|].
        pose proof (at_primitive F l (num f)) as P. destruct (primitive (num f)) as [c p].
        cbn [fst snd] in P.
        set (g := Z.gcd c (int f)).
        destruct (Z.eqb (int f) (int f / g * g)) eqn:A; [|exact S].
        destruct (Z.eqb c (c / g * g)) eqn:B; [|exact S].
        apply Z.eqb_eq in A, B. cbn [andb]. destruct S as [L N E]. 
        rewrite A, integer_mul in N, E. rewrite B, integer_mul in P.
        split; cbn [num int den].
        + exact L.
        + exact (left_nonzero _ _ N).
        + rewrite at_scaled.
          apply cancelled with (z := integer g); [|exact (right_nonzero _ _ N)].
          transitivity (at_ (num f)); [rewrite <- E|rewrite P]; ring.
    Qed.

    Lemma plus_sound a b v w : sound factors a v -> sound factors b w ->
      sound factors (plus factors a b) (v + w).
    Proof.
      intros [La Na Ea] [Lb Nb Eb]. unfold plus.
      destruct (common (den a) (den b)) as [[e x] y] eqn:C.
      destruct (common_length _ _ _ _ _ C) as (Le & _ & _).
      destruct (common_product factors _ _ _ _ _ C) as [Ha Hb].
      assert (exists n m, (if Z.eqb (int a) (int b) then (1, 1)%Z else (int b, int a)) = (n, m) /\
        integer n <> 0 /\ integer (int a) * integer n = integer (int b) * integer m)
        as (n & m & X & Nn & M).
      { destruct (Z.eqb (int a) (int b)) eqn:I.
        - apply Z.eqb_eq in I. exists 1%Z, 1%Z. rewrite I.
          repeat split; exact one_not_zero.
        - exists (int b), (int a). repeat split; [exact Nb|ring]. }
      rewrite X.
      destruct (cancel_all factors e _ _) as [p d] eqn:D.
      apply reduced_sound. split; cbn [num int den].
      - rewrite (cancel_all_length _ _ _ _ _ _ D). lia.
      - rewrite integer_mul. now apply product_nonzero.
      - apply (cancel_all_sound factors nonzero _ _ _ _ _ _ _ D).
        rewrite at_add, !at_times_powers, !at_scaled, integer_mul, <- Ea, <- Eb.
        transitivity (v * (integer (int a) * integer n * product factors e)
          + w * (integer (int a) * integer n * product factors e)); [ring|].
        rewrite Ha at 1. rewrite M, Hb. rewrite <- M at 1. ring.
    Qed.

    Lemma opposite_sound a v : sound factors a v -> sound factors (opposite a) (- v).
    Proof.
      intros [L N E]. split; cbn [opposite num int den]; [exact L|exact N|].
      rewrite at_opp, <- E. ring.
    Qed.

    Lemma times_sound a b v w : sound factors a v -> sound factors b w ->
      sound factors (times factors a b) (v * w).
    Proof.
      intros [La Na Ea] [Lb Nb Eb]. unfold times.
      destruct (cancel_all factors (den b) [] (num a)) as [p e] eqn:P.
      destruct (cancel_all factors (den a) [] (num b)) as [q f] eqn:Q.
      apply reduced_sound. split; cbn [num int den].
      - rewrite sum_of_powers_length, (cancel_all_length _ _ _ _ _ _ P),
          (cancel_all_length _ _ _ _ _ _ Q). lia.
      - rewrite integer_mul. now apply product_nonzero.
      - rewrite integer_mul, sum_of_powers_product, at_mul.
        pose proof (product_not_zero factors nonzero) as D.
        (* p / e = num a / den b and q / f = num b / den a. *)
        assert (Hp : at_ p * product factors (den b) = at_ (num a) * product factors e).
        { rewrite <- (cancel_all_sound factors nonzero _ _ _ _ _
            (at_ (num a) / product factors (den b)) 1 P); field; apply D. }
        assert (Hq : at_ q * product factors (den a) = at_ (num b) * product factors f).
        { rewrite <- (cancel_all_sound factors nonzero _ _ _ _ _
            (at_ (num b) / product factors (den a)) 1 Q); field; apply D. }
        apply cancelled with (z := product factors (den b) * product factors (den a));
          [|now apply product_nonzero].
        transitivity ((at_ p * product factors (den b)) * (at_ q * product factors (den a)));
          [|ring].
        rewrite Hp, Hq, <- Ea, <- Eb. ring.
    Qed.
  End Factors.

  Lemma with_unknowns_sound p : at_ p <> 0 -> forall n factors, all_nonzero factors ->
    exists more, with_unknowns factors n p = factors ++ more /\ all_nonzero (factors ++ more).
  Proof.
    intro N. induction n as [|n IH]; intros factors A; cbn [with_unknowns].
    { exists []. now rewrite app_nil_r. }
    destruct (IH factors A) as (more & -> & B).
    destruct (exact p (unknown n)) as [q|] eqn:E; [|now exists more].
    destruct (existsb _ _); [now exists more|].
    exists (more ++ [unknown n]). rewrite app_assoc. split; [reflexivity|].
    apply Forall_app. split; [exact B|]. constructor; [|constructor].
    apply at_exact with (F := F) (l := l) in E. rewrite E in N. exact (right_nonzero _ _ N).
  Qed.

  Lemma cancel_power f : forall n p q m, cancel p f n = (q, m) ->
    at_ p = at_ q * power (at_ f) (n - m) /\ (m <= n)%nat.
  Proof.
    induction n as [|n IH]; intros p q m; cbn [cancel]; intro E.
    { injection E as <- <-. split; [cbn; ring|lia]. }
    destruct (exact p f) as [r|] eqn:X.
    - destruct (IH _ _ _ E) as [H L]. apply at_exact with (F := F) (l := l) in X.
      split; [|lia]. replace (S n - m)%nat with (S (n - m)) by lia.
      rewrite X, H. cbn [power]. ring.
    - injection E as <- <-. split; [|lia]. rewrite Nat.sub_diag. cbn. ring.
  Qed.

  Lemma peeled_sound : forall factors p e rest, peeled factors p = (e, rest) ->
    at_ p = product factors e * at_ rest /\ length e = length factors.
  Proof.
    induction factors as [|f factors IH]; intros p e rest; cbn [peeled]; intro E.
    { injection E as <- <-. split; [cbn; ring|reflexivity]. }
    assert (exists q n, match p with Ring_polynom.Pc _ => (p, most) | _ => cancel p f most end
      = (q, n) /\ at_ p = at_ q * power (at_ f) (most - n)) as (q & n & X & H).
    { destruct p as [c| |]; [exists (Ring_polynom.Pc c), most; split;
        [reflexivity|rewrite Nat.sub_diag; cbn [power]; ring]| |];
      destruct (cancel _ f most) as [q n] eqn:C; exists q, n; split; try reflexivity;
      exact (proj1 (cancel_power _ _ _ _ _ C)). }
    rewrite X in E. destruct (peeled factors q) as [e' r] eqn:P.
    apply pair_equal_spec in E. destruct E as [<- <-]. destruct (IH _ _ _ P) as [H' L].
    split; [|cbn [length]; now rewrite L].
    change (product (f :: factors) (most - n :: e')%nat)
      with (power (at_ f) (most - n) * product factors e').
    rewrite H, H'. ring.
  Qed.

  Lemma split_sound unknowns factors p c e factors' : all_nonzero factors -> at_ p <> 0 ->
    split unknowns factors p = (c, e, factors') ->
    exists more, factors' = factors ++ more /\ all_nonzero factors' /\
    (length e <= length factors')%nat /\ integer c <> 0 /\
    at_ p = integer c * product factors' e.
  Proof.
    intros A N. unfold split. pose proof (at_primitive F l p) as H.
    destruct (primitive p) as [c0 q]. cbn [fst snd] in H. rewrite H in N.
    destruct (with_unknowns_sound q (left_nonzero _ _ N) unknowns factors A) as (more & -> & B).
    apply right_nonzero in N as Nc. apply left_nonzero in N as Nq.
    destruct (peeled (factors ++ more) q) as [e0 rest] eqn:P.
    destruct (peeled_sound _ _ _ _ P) as [Hq L]. rewrite Hq in Nq.
    apply right_nonzero in Nq as Nr.
    assert (new : all_nonzero ((factors ++ more) ++ [rest])).
    { apply Forall_app. split; [exact B|]. now constructor. }
    assert (snoc : product ((factors ++ more) ++ [rest]) (e0 ++ [1%nat])
      = product (factors ++ more) e0 * at_ rest).
    { clear -L. revert e0 L. induction (factors ++ more) as [|f t IH]; intros [|n e0] L;
        cbn in L |- *; try discriminate; [ring|]. rewrite IH by lia. ring. }
    intro E. destruct rest as [r| |]; injection E as <- <- <-.
    - exists more. repeat split; [exact B|lia| |].
      + rewrite integer_mul. now apply product_nonzero.
      + rewrite integer_mul, H, Hq. change (at_ (Ring_polynom.Pc r)) with (integer r). ring.
    - exists (more ++ [Ring_polynom.Pinj p0 rest]). rewrite app_assoc.
      repeat split; [exact new|rewrite !app_length in *; cbn; lia|exact Nc|].
      rewrite snoc, H, Hq. ring.
    - exists (more ++ [Ring_polynom.PX rest1 p0 rest2]). rewrite app_assoc.
      repeat split; [exact new|rewrite !app_length in *; cbn; lia|exact Nc|].
      rewrite snoc, H, Hq. ring.
  Qed.

  Lemma ratio_sound unknowns factors a b v w q factors' : all_nonzero factors ->
    sound factors a v -> sound factors b w -> w <> 0 ->
    ratio unknowns factors a b = (q, factors') ->
    exists more, factors' = factors ++ more /\ all_nonzero factors' /\ sound factors' q (v / w).
  Proof.
    intros A Sa Sb N. unfold ratio.
    assert (Nb : at_ (num b) <> 0).
    { intro Z. apply N. exact (numerator_zero factors A b w Sb Z). }
    destruct (split unknowns factors (num b)) as [[c e] fs] eqn:S.
    destruct (split_sound _ _ _ _ _ _ A Nb S) as (more & -> & A' & Le & Nc & Hb).
    apply sound_more with (more := more) in Sa, Sb.
    set (fs := factors ++ more) in *.
    destruct Sa as [La Na Ea], Sb as [Lb Nib Eb].
    destruct (common (den a) (den b)) as [[m x] y] eqn:C.
    destruct (common_length _ _ _ _ _ C) as (_ & Lx & Ly).
    destruct (common_product fs _ _ _ _ _ C) as [Ha Hy]. rewrite Ha in Hy.
    destruct (cancel_all fs e [] (num a)) as [p d] eqn:P.
    intro E. injection E as <- <-. exists more. split; [reflexivity|split; [exact A'|]].
    apply reduced_sound; [exact A'|]. split; cbn [num int den].
    - rewrite sum_of_powers_length, (cancel_all_length _ _ _ _ _ _ P). lia.
    - rewrite integer_mul. now apply product_nonzero.
    - pose proof (product_not_zero fs A') as D.
      rewrite integer_mul, sum_of_powers_product, at_times_powers, at_scaled.
      assert (Hp : at_ p * product fs e = at_ (num a) * product fs d).
      { rewrite <- (cancel_all_sound fs A' _ _ _ _ _ (at_ (num a) / product fs e) 1 P);
          field; apply D. }
      apply cancelled with
        (z := w * product fs e * product fs (den b) * product fs (den a));
        [|now repeat apply product_nonzero].
      transitivity ((v * (integer (int a) * product fs (den a))) * product fs d
        * (integer c * product fs e) * (product fs (den b) * product fs y));
        [field; exact N|].
      rewrite Ea, <- Hp, <- Hy, <- Hb, <- Eb. ring.
  Qed.
End Values.
