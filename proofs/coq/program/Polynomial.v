(** Polynomials over the integers, those of the tactic [ring], with exact division.

    Division is not proved: its result is multiplied back. *)

Require Import ZArith List Setoid Field_theory Ring_polynom InitialRing BinList.
Require Import Isogeo.program.Script.
Import ListNotations.
Local Open Scope Z_scope.

Definition poly := Pol Z.

Definition padd : poly -> poly -> poly := Padd 0 Z.add Zeq_bool.
Definition psub : poly -> poly -> poly := Psub 0 Z.add Z.sub Z.opp Zeq_bool.
Definition pmul : poly -> poly -> poly := Pmul 0 1 Z.add Z.mul Zeq_bool.
Definition popp : poly -> poly := Popp Z.opp.
Definition peq : poly -> poly -> bool := Peq Zeq_bool.
Definition scaled (p : poly) (n : Z) : poly := PmulC 0 1 Z.mul Zeq_bool p n.
Definition power_of_first (p : poly) (i : positive) (q : poly) : poly := mkPX 0 Zeq_bool p i q.
Definition later (j : positive) (p : poly) : poly := mkPinj j p.

Definition unknown (n : nat) : poly := mk_X 0 1 (Pos.of_succ_nat n).

Definition is_zero (p : poly) : bool := peq p (Pc 0).

(** The greatest common divisor of the coefficients. *)
Fixpoint content_with (g : Z) (p : poly) : Z :=
  match p with
  | Pc c => Z.gcd c g
  | Pinj _ q => content_with g q
  | PX p _ q => let g := content_with g q in if Z.eqb g 1 then 1 else content_with g p
  end.
Definition content : poly -> Z := content_with 0.

Fixpoint over_integer (c : Z) (p : poly) : option poly :=
  match p with
  | Pc n => let (q, r) := Z.div_eucl n c in if Z.eqb r 0 then Some (Pc q) else None
  | Pinj j q => option_map (Pinj j) (over_integer c q)
  | PX p i q =>
    match over_integer c q, over_integer c p with
    | Some q, Some p => Some (PX p i q)
    | _, _ => None
    end
  end.

(** The degree in the first unknown. *)
Fixpoint degree (p : poly) : N :=
  match p with
  | PX p i _ => N.pos i + degree p
  | _ => 0%N
  end.

(** Division from the lowest power of the first unknown on. *)
Fixpoint quotient (fuel : nat) (p f : poly) : option poly :=
  match fuel with
  | O => None
  | S fuel =>
    match f, p with
    | _, Pc 0 => Some p
    | Pc c, _ => over_integer c p
    | _, Pc _ => None
    | Pinj j f', Pinj k p' =>
      match Z.pos_sub k j with
      | Z0 => option_map (later j) (quotient fuel p' f')
      | Zpos d => option_map (later j) (quotient fuel (Pinj d p') f')
      | Zneg d => option_map (later k) (quotient fuel p' (Pinj d f'))
      end
    | Pinj j f', PX p' i q' =>
      match quotient fuel q' (mkPinj_pred j f') with
      | None => None
      | Some low =>
        match quotient fuel p' f with
        | None => None
        | Some high => Some (power_of_first high i low)
        end
      end
    | PX _ _ _, Pinj _ _ => None
    | PX a j b, PX p' i q' =>
      if is_zero b then
        if is_zero q' then
          match Z.pos_sub i j with
          | Z0 => quotient fuel p' a
          | Zpos d => quotient fuel (PX p' d (Pc 0)) a
          | Zneg _ => None
          end
        else None
      else if is_zero q' then
        option_map (fun q => power_of_first q i (Pc 0)) (quotient fuel p' f)
      else if N.ltb (degree p) (degree f) then None
      else
        match quotient fuel q' b with
        | None => None
        | Some low =>
          let low := later 1 low in
          match psub (PX p' i (Pc 0)) (power_of_first (pmul a low) j (Pc 0)) with
          | Pc 0 => Some low
          | PX rest m zero =>
            if is_zero zero then
              match quotient fuel rest f with
              | None => None
              | Some high => Some (padd (power_of_first high m (Pc 0)) low)
              end
            else None
          | _ => None
          end
        end
    end
  end.

Definition depth : nat := Nat.pow 2 12.

(** The quotient, where the division goes up. *)
Definition exact (p f : poly) : option poly :=
  match quotient depth p f with
  | Some q => if peq (pmul q f) p then Some q else None
  | None => None
  end.

(** A polynomial as an integer times another. *)
Definition primitive (p : poly) : Z * poly :=
  let c := content p in
  match over_integer c p with
  | Some q => if peq (scaled q c) p then (c, q) else (1, p)
  | None => (1, p)
  end.

(** ** Values *)

Section Values.
  Variable F : field.

  Lemma setoid : Equivalence (@eq F).
  Proof. exact (Eqsth F). Qed.

  Lemma congruent : ring_eq_ext (add F) (mul F) (opp F) eq.
  Proof. constructor; congruence. Qed.

  Lemma ring_laws : ring_theory (zero F) (one F) (add F) (mul F) (sub F) (opp F) eq.
  Proof. exact (F_R (laws F)). Qed.

  Lemma almost_ring_laws :
    almost_ring_theory (zero F) (one F) (add F) (mul F) (sub F) (opp F) eq.
  Proof. exact (Rth_ARth setoid congruent ring_laws). Qed.

  Lemma integers : ring_morph (zero F) (one F) (add F) (mul F) (sub F) (opp F) eq
    0 1 Z.add Z.mul Z.sub Z.opp Zeq_bool (integer F).
  Proof. exact (gen_phiZ_morph setoid congruent ring_laws). Qed.

  Variable l : list F.

  Definition at_ (p : poly) : F := Pphi (zero F) (add F) (mul F) (integer F) l p.

  Lemma at_add p q : at_ (padd p q) = add F (at_ p) (at_ q).
  Proof. exact (Padd_ok setoid congruent almost_ring_laws integers q p l). Qed.

  Lemma at_sub p q : at_ (psub p q) = sub F (at_ p) (at_ q).
  Proof. exact (Psub_ok setoid congruent almost_ring_laws integers q p l). Qed.

  Lemma at_mul p q : at_ (pmul p q) = mul F (at_ p) (at_ q).
  Proof. exact (Pmul_ok setoid congruent almost_ring_laws integers p q l). Qed.

  Lemma at_opp p : at_ (popp p) = opp F (at_ p).
  Proof. exact (Popp_ok setoid congruent almost_ring_laws integers p l). Qed.

  Lemma at_scaled p n : at_ (scaled p n) = mul F (at_ p) (integer F n).
  Proof. exact (PmulC_ok setoid congruent almost_ring_laws integers n p l). Qed.

  Lemma at_eq p q : peq p q = true -> at_ p = at_ q.
  Proof. intro H. exact (Peq_ok setoid congruent integers p q H l). Qed.

  Lemma nth_of_nat n : BinList.nth (zero F) (Pos.of_succ_nat n) l = List.nth n l (zero F).
  Proof.
    revert l. induction n as [|n IH]; intro k.
    - destruct k; reflexivity.
    - cbn [Pos.of_succ_nat].
      transitivity (BinList.nth (zero F) (Pos.of_succ_nat n) (tl k)).
      + rewrite nth_jump. generalize (Pos.of_succ_nat n). intro p. revert k.
        induction p as [p IHp|p IHp|]; intro k; cbn [Pos.succ BinList.nth BinList.jump].
        * rewrite IHp, jump_succ. cbn [BinList.jump]. now rewrite !jump_tl.
        * now rewrite <- nth_jump, jump_tl.
        * reflexivity.
      + rewrite IH. destruct k; [destruct n|]; reflexivity.
  Qed.

  Lemma at_unknown n : at_ (unknown n) = List.nth n l (zero F).
  Proof.
    rewrite <- nth_of_nat. symmetry.
    exact (mkX_ok setoid congruent almost_ring_laws integers (Pos.of_succ_nat n) l).
  Qed.

  Lemma at_exact p f q : exact p f = Some q -> at_ p = mul F (at_ q) (at_ f).
  Proof.
    unfold exact. destruct (quotient depth p f) as [r|]; [|discriminate].
    destruct (peq (pmul r f) p) eqn:E; [|discriminate].
    intro H. injection H as <-. rewrite <- at_mul. symmetry. now apply at_eq.
  Qed.

  Lemma at_primitive p : at_ p = mul F (at_ (snd (primitive p))) (integer F (fst (primitive p))).
  Proof.
    assert (trivial : at_ p = mul F (at_ p) (integer F 1)).
    { change (integer F 1) with (one F).
      now rewrite (Rmul_comm ring_laws), (Rmul_1_l ring_laws). }
    unfold primitive. destruct (over_integer (content p) p) as [q|]; [|exact trivial].
    destruct (peq (scaled q (content p)) p) eqn:E; [|exact trivial].
    cbn [fst snd]. rewrite <- at_scaled. symmetry. now apply at_eq.
  Qed.
End Values.
