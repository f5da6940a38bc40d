(** What a recorded program says: its statement over an arbitrary field.

    Nothing else has to be read to know what the theorems in [recorded] say. *)

Require Import ZArith List Field_theory InitialRing.
Import ListNotations.

(** A field, of any characteristic. *)
Record field := Field {
  carrier :> Type;
  zero : carrier;
  one : carrier;
  add : carrier -> carrier -> carrier;
  mul : carrier -> carrier -> carrier;
  sub : carrier -> carrier -> carrier;
  opp : carrier -> carrier;
  div : carrier -> carrier -> carrier;
  inv : carrier -> carrier;
  laws : field_theory zero one add mul sub opp div inv eq
}.

(** The image of an integer. *)
Definition integer (F : field) : Z -> F :=
  gen_phiZ (zero F) (one F) (add F) (mul F) (opp F).

(** One step. Values are named by the distance back: 0 is the value computed last. *)
Inductive step :=
  (** These compute a value. *)
  | Unknown (n : nat)
  | Constant (n : Z)
  | Add (a b : nat)
  | Sub (a b : nat)
  | Mul (a b : nat)
  | Div (a b : nat)
  | Neg (a : nat)
  (** Hypotheses on values. *)
  | Nonzero (a : nat)
  | Zero (a : nat)
  (** What is shown of values. *)
  | ShowNonzero (a : nat)
  | ShowZero (a : nat).

(** The statement: whatever the unknowns, if the hypotheses hold, then nothing is divided by zero,
    and what has to vanish vanishes. *)
Fixpoint holds (F : field) (unknowns : list F) (values : list F) (steps : list step) : Prop :=
  let value n := nth n values (zero F) in
  let computed v rest := holds F unknowns (v :: values) rest in
  match steps with
  | [] => True
  | Unknown n :: rest => computed (nth n unknowns (zero F)) rest
  | Constant n :: rest => computed (integer F n) rest
  | Add a b :: rest => computed (add F (value a) (value b)) rest
  | Sub a b :: rest => computed (sub F (value a) (value b)) rest
  | Mul a b :: rest => computed (mul F (value a) (value b)) rest
  | Div a b :: rest => value b <> zero F /\ computed (div F (value a) (value b)) rest
  | Neg a :: rest => computed (opp F (value a)) rest
  | Nonzero a :: rest => value a <> zero F -> holds F unknowns values rest
  | Zero a :: rest => value a = zero F -> holds F unknowns values rest
  | ShowNonzero a :: rest => value a <> zero F /\ holds F unknowns values rest
  | ShowZero a :: rest => value a = zero F /\ holds F unknowns values rest
  end.

(** For every field and all values of the unknowns. *)
Definition valid (steps : list step) : Prop :=
  forall (F : field) (unknowns : list F), holds F unknowns [] steps.
