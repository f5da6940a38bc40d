(** The metric duality (5): the recorded program says what the paper writes. *)

Require Import ZArith List Field.
Require Import Isogeo.program.Script Isogeo.bridge.Offsets.
Require Isogeo.recorded.duality_incidence.
Import ListNotations.

Section Polarity.
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
  Notation field := (field F zero one add mul sub opp div inv laws).
  Notation two := (two F one add).
  Notation difference_zero := (difference_zero F zero one add mul sub opp div inv laws).

  (** The height of a point over the polar plane [Z = x X + y Y - z] of another. *)
  Definition over_polar (p q : F * F * F) : F :=
    let '((x, y), z) := p in let '((u, v), w) := q in w - (x * u + y * v - z).

  Theorem incidence (p q : F * F * F) : two <> 0 -> over_polar p q = over_polar q p.
  Proof.
    destruct p as [[x y] z], q as [[u v] w]. intro N2.
    known (duality_incidence.part_1_size_1_valid field [1; x; y; z; u; v; - w; 0; 0; 0]) T.
    destruct (T N2 (F_1_neq_0 laws)) as (E & _). apply difference_zero in E.
    unfold over_polar.
    match type of E with
    | ?a = ?b => transitivity a; [ring|rewrite E; ring]
    end.
  Qed.
End Polarity.
