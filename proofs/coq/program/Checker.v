(** The checker: decides a program by computation, each value once; proved for every field. *)

Require Import ZArith Bool List Lia Field.
Require Import Isogeo.program.Script Isogeo.program.Polynomial Isogeo.program.Fraction.
Require Ring_polynom.
Import ListNotations.

(** What is known on the way. *)
Record state := State {
  (** An integer that is not zero in the field. *)
  unit : Z;
  (** Numerators that are not zero. *)
  stated : list poly;
  (** Numerators that are zero. *)
  relations : list poly;
  (** Factors of denominators. *)
  factors : list poly;
  (** The values, the last first. *)
  fractions : list fraction
}.

Definition start : state := State 1 [] [] [] [].

Definition nth_fraction (s : state) (n : nat) : fraction :=
  nth n (fractions s) (of_poly (Ring_polynom.Pc 0%Z)).

(** All primes of [c] divide [u]. *)
Definition nonzero_integer (u c : Z) : bool :=
  negb (Z.eqb c 0) && (Z.eqb (Z.abs c) 1 || Z.eqb (Z.pow u (Z.log2 (Z.abs c)) mod c) 0).

(** The first result. *)
Fixpoint first {A B} (f : A -> option B) (l : list A) : option B :=
  match l with
  | [] => None
  | a :: l => match f a with Some b => Some b | None => first f l end
  end.

(** Whether a polynomial is not zero since it is made of divisors of what is stated. *)
Fixpoint follows (fuel : nat) (u : Z) (stated : list poly) (p : poly) : bool :=
  let (c, p) := primitive p in
  nonzero_integer u c &&
  match fuel, p with
  | _, Ring_polynom.Pc c => nonzero_integer u c
  | O, _ => false
  | S fuel, _ =>
    match first (fun t => exact t p) stated with
    | Some _ => true
    | None =>
      match first (exact p) stated with
      | Some q => follows fuel u stated q
      | None => false
      end
    end
  end.

Definition nonzero (s : state) (p : poly) : bool := follows most (unit s) (stated s) p.

(** Whether a polynomial is a multiple of a relation. *)
Definition vanishes (s : state) (p : poly) : bool :=
  is_zero p || match first (exact p) (relations s) with Some _ => true | None => false end.

Definition push (s : state) (f : fraction) : state :=
  State (unit s) (stated s) (relations s) (factors s) (f :: fractions s).

Fixpoint check (unknowns : nat) (s : state) (steps : list step) : bool :=
  let value := nth_fraction s in
  let computed f rest := check unknowns (push s f) rest in
  match steps with
  | [] => true
  | Unknown n :: rest => computed (of_poly (unknown n)) rest
  | Constant n :: rest => computed (of_poly (Ring_polynom.Pc n)) rest
  | Add a b :: rest => computed (plus (factors s) (value a) (value b)) rest
  | Sub a b :: rest => computed (plus (factors s) (value a) (opposite (value b))) rest
  | Mul a b :: rest => computed (times (factors s) (value a) (value b)) rest
  | Neg a :: rest => computed (opposite (value a)) rest
  | Div a b :: rest =>
    nonzero s (num (value b)) &&
    (let (f, factors) := ratio unknowns (factors s) (value a) (value b) in
     check unknowns (State (unit s) (stated s) (relations s) factors (f :: fractions s)) rest)
  | Nonzero a :: rest =>
    let (c, p) := primitive (num (value a)) in
    let stated := match p with Ring_polynom.Pc _ => stated s | _ => stated s ++ [p] end in
    check unknowns (State (unit s * c) stated (relations s) (factors s) (fractions s)) rest
  | Zero a :: rest =>
    let relations := relations s ++ [num (value a)] in
    check unknowns (State (unit s) (stated s) relations (factors s) (fractions s)) rest
  | ShowNonzero a :: rest => nonzero s (num (value a)) && check unknowns s rest
  | ShowZero a :: rest => vanishes s (num (value a)) && check unknowns s rest
  end.

(** How many unknowns a program has. *)
Fixpoint unknowns_of (steps : list step) : nat :=
  match steps with
  | [] => 0
  | Unknown n :: rest => max (S n) (unknowns_of rest)
  | _ :: rest => unknowns_of rest
  end.

Definition accepts (steps : list step) : bool := check (unknowns_of steps) start steps.

(** ** The proof *)

Section Proof.
  Variable F : field.
  Variable l : list F.

  Add Field the_field : (laws F).

  Notation at_ := (at_ F l).
  Notation zero := (zero F).
  Notation sound := (sound F l).

  Definition known_nonzero := Forall (fun p => at_ p <> zero).
  Definition known_zero := Forall (fun p => at_ p = zero).

  Record right (s : state) (values : list F) : Prop := Right {
    right_unit : integer F (unit s) <> zero;
    right_stated : known_nonzero (stated s);
    right_relations : known_zero (relations s);
    right_factors : all_nonzero F l (factors s);
    right_fractions : Forall2 (sound (factors s)) (fractions s) values
  }.

  Lemma integer_zero : integer F 0 = zero.
  Proof. reflexivity. Qed.

  Lemma nonzero_integer_sound u c :
    integer F u <> zero -> nonzero_integer u c = true -> integer F c <> zero.
  Proof.
    intros N H. unfold nonzero_integer in H. apply andb_prop in H. destruct H as [Hc H].
    apply negb_true_iff, Z.eqb_neq in Hc. apply orb_prop in H. destruct H as [H|H].
    - apply Z.eqb_eq in H. assert (c * c = 1)%Z by lia.
      apply (left_nonzero F _ (integer F c)). rewrite <- integer_mul, H0.
      exact (one_not_zero F).
    - apply Z.eqb_eq, Z.div_exact in H; [|exact Hc].
      apply (left_nonzero F _ (integer F (u ^ Z.log2 (Z.abs c) / c))).
      rewrite <- integer_mul, <- H.
      generalize (Z.log2_nonneg (Z.abs c)). generalize (Z.log2 (Z.abs c)).
      apply natlike_ind; [exact (one_not_zero F)|].
      intros n L I. rewrite Z.pow_succ_r, integer_mul by exact L.
      now apply product_nonzero.
  Qed.

  Lemma first_some {A B} (f : A -> option B) k b :
    first f k = Some b -> exists a, In a k /\ f a = Some b.
  Proof.
    induction k as [|a k IH]; cbn [first]; [discriminate|].
    destruct (f a) eqn:E.
    - intro H. injection H as <-. exists a. split; [now left|exact E].
    - intro H. destruct (IH H) as (x & I & X). exists x. split; [now right|exact X].
  Qed.

  Lemma follows_sound u st : integer F u <> zero -> known_nonzero st ->
    forall fuel p, follows fuel u st p = true -> at_ p <> zero.
  Proof.
    intros Nu St. induction fuel as [|fuel IH]; intro p; cbn [follows];
      pose proof (at_primitive F l p) as H; destruct (primitive p) as [c q];
      cbn [fst snd] in H; intro E; apply andb_prop in E; destruct E as [Nc E];
      apply (nonzero_integer_sound u c Nu) in Nc; rewrite H;
      apply product_nonzero; try exact Nc.
    - destruct q as [n| |]; try discriminate. exact (nonzero_integer_sound u n Nu E).
    - assert (other : match first (fun t => exact t q) st with
        | Some _ => true
        | None => match first (exact q) st with
          | Some r => follows fuel u st r
          | None => false
          end
        end = true -> at_ q <> zero).
      { destruct (first (fun t => exact t q) st) as [r|] eqn:A.
        - intros _. destruct (first_some _ _ _ A) as (t & I & X).
          apply at_exact with (F := F) (l := l) in X.
          pose proof (proj1 (Forall_forall _ _) St t I) as N. cbn beta in N. rewrite X in N.
          exact (right_nonzero F _ _ N).
        - destruct (first (exact q) st) as [r|] eqn:B; [|discriminate].
          intro R. destruct (first_some _ _ _ B) as (t & I & X).
          apply at_exact with (F := F) (l := l) in X. rewrite X.
          apply product_nonzero; [exact (IH r R)|].
          exact (proj1 (Forall_forall _ _) St t I). }
      destruct q as [n| |]; [exact (nonzero_integer_sound u n Nu E)| |]; exact (other E).
  Qed.

  Lemma nonzero_sound s values p : right s values -> nonzero s p = true -> at_ p <> zero.
  Proof. intros [U S _ _ _]. exact (follows_sound _ _ U S most p). Qed.

  Lemma vanishes_sound s values p : right s values -> vanishes s p = true -> at_ p = zero.
  Proof.
    intros [_ _ R _ _] H. unfold vanishes in H. apply orb_prop in H. destruct H as [H|H].
    - apply at_eq with (F := F) (l := l) in H. exact H.
    - destruct (first (exact p) (relations s)) as [q|] eqn:E; [|discriminate].
      destruct (first_some _ _ _ E) as (r & I & X).
      apply at_exact with (F := F) (l := l) in X. rewrite X.
      rewrite (proj1 (Forall_forall _ _) R r I). ring.
  Qed.

  Lemma value_sound s values n :
    right s values -> sound (factors s) (nth_fraction s n) (nth n values zero).
  Proof.
    intros [_ _ _ _ V]. unfold nth_fraction.
    assert (Z : sound (factors s) (of_poly (Ring_polynom.Pc 0%Z)) zero).
    { exact (of_poly_sound F l (factors s) (Ring_polynom.Pc 0%Z)). }
    revert n. induction V as [|f v fs vs H _ IH]; intros [|n]; cbn [nth]; auto.
  Qed.

  Lemma push_right s values f v :
    right s values -> sound (factors s) f v -> right (push s f) (v :: values).
  Proof.
    intros [U S R A V] H. split; cbn [push unit stated relations factors fractions]; auto.
  Qed.

  Lemma check_sound unknowns : forall steps s values,
    right s values -> check unknowns s steps = true -> holds F l values steps.
  Proof.
    induction steps as [|step steps IH]; intros s values R; [exact (fun _ => I)|].
    pose proof (fun n => value_sound s values n R) as V.
    pose proof (right_factors _ _ R) as A.
    destruct step as [n|n|a b|a b|a b|a b|a|a|a|a|a]; cbn [check holds]; intro H.
    - apply (IH _ _ (push_right _ _ _ _ R
        (of_poly_sound F l (factors s) (unknown n)))) in H.
      now rewrite at_unknown in H.
    - exact (IH _ _ (push_right _ _ _ _ R
        (of_poly_sound F l (factors s) (Ring_polynom.Pc n))) H).
    - exact (IH _ _ (push_right _ _ _ _ R (plus_sound F l _ A _ _ _ _ (V a) (V b))) H).
    - apply (IH _ _ (push_right _ _ _ _ R
        (plus_sound F l _ A _ _ _ _ (V a) (opposite_sound F l _ _ _ (V b))))) in H.
      replace (sub F (nth a values zero) (nth b values zero))
        with (add F (nth a values zero) (opp F (nth b values zero))) by ring.
      exact H.
    - exact (IH _ _ (push_right _ _ _ _ R (times_sound F l _ A _ _ _ _ (V a) (V b))) H).
    - apply andb_prop in H. destruct H as [N H].
      apply (nonzero_sound _ _ _ R) in N.
      assert (Nb : nth b values zero <> zero).
      { intro Z. apply N. exact (zero_numerator F l _ _ _ (V b) Z). }
      split; [exact Nb|].
      destruct (ratio unknowns (factors s) (nth_fraction s a) (nth_fraction s b))
        as [f fs] eqn:Q.
      destruct (ratio_sound F l _ _ _ _ _ _ _ _ A (V a) (V b) Nb Q) as (more & -> & A' & S).
      refine (IH _ _ _ H). destruct R as [U St Re _ W].
      split; cbn [unit stated relations factors fractions]; auto.
      constructor; [exact S|]. clear -W.
      induction W; constructor; [now apply sound_more|assumption].
    - exact (IH _ _ (push_right _ _ _ _ R (opposite_sound F l _ _ _ (V a))) H).
    - intro N. pose proof (at_primitive F l (num (nth_fraction s a))) as P.
      destruct (primitive (num (nth_fraction s a))) as [c p]. cbn [fst snd] in P.
      assert (Np : mul F (at_ p) (integer F c) <> zero).
      { rewrite <- P. intro Z. apply N. exact (numerator_zero F l _ A _ _ (V a) Z). }
      refine (IH _ _ _ H). destruct R as [U St Re _ W].
      split; cbn [unit stated relations factors fractions]; auto.
      + rewrite integer_mul. apply product_nonzero; [exact U|].
        exact (right_nonzero F _ _ Np).
      + assert (known_nonzero (stated s ++ [p])).
        { apply Forall_app. split; [exact St|]. constructor; [|constructor].
          exact (left_nonzero F _ _ Np). }
        destruct p; auto.
    - intro Z. refine (IH _ _ _ H). destruct R as [U St Re _ W].
      split; cbn [unit stated relations factors fractions]; auto.
      apply Forall_app. split; [exact Re|]. constructor; [|constructor].
      exact (zero_numerator F l _ _ _ (V a) Z).
    - apply andb_prop in H. destruct H as [N H]. split; [|exact (IH _ _ R H)].
      apply (nonzero_sound _ _ _ R) in N. intro Z. apply N.
      exact (zero_numerator F l _ _ _ (V a) Z).
    - apply andb_prop in H. destruct H as [Z H]. split; [|exact (IH _ _ R H)].
      apply (vanishes_sound _ _ _ R) in Z.
      exact (numerator_zero F l _ A _ _ (V a) Z).
  Qed.
End Proof.

(** What the checker accepts is true over every field. *)
Theorem accepted (steps : list step) : accepts steps = true -> valid steps.
Proof.
  intros H F l. apply (check_sound F l (unknowns_of steps) steps start []); [|exact H].
  split; cbn [start unit stated relations factors fractions]; try constructor.
  exact (one_not_zero F).
Qed.
