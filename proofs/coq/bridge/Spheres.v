(** (12): the recorded program says what the paper writes. *)

Require Import ZArith List Field.
Require Import Isogeo.program.Script Isogeo.bridge.Offsets.
Require Isogeo.recorded.eq_12_spheres.
Import ListNotations.

Section Spheres.
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

  (** The oriented plane [n x + h = 0] with unit normal, as a point of the isotropic model. *)
  Definition isotropic (n : F * F * F) (h : F) : F * F * F :=
    let '((n1, n2), n3) := n in ((n1 / (n3 + 1), n2 / (n3 + 1)), h / (n3 + 1)).

  (** The residual [2 (z - B x - C y - D) - A (x^2 + y^2)] of the i-M-sphere of an oriented sphere
      with centre [m] and radius [r]: [A = r + m3], [B = -m1], [C = -m2], [D = (r - m3)/2]. *)
  Definition sphere (m : F * F * F) (r : F) (p : F * F * F) : F :=
    let '((m1, m2), m3) := m in let '((x, y), z) := p in
    two * (z - (- m1 * x + - m2 * y + (r - m3) / two)) - (r + m3) * (x * x + y * y).

  (** The plane touches the sphere where [n m + h = r]. *)
  Definition tangency (n : F * F * F) (h : F) (m : F * F * F) (r : F) : F :=
    let '((n1, n2), n3) := n in let '((m1, m2), m3) := m in
    n1 * m1 + n2 * m2 + n3 * m3 + h - r.

  Theorem eq_12 (n1 n2 n3 h r : F) (m : F * F * F) : two <> 0 ->
    n1 * n1 + n2 * n2 + n3 * n3 = 1 -> 1 + n3 <> 0 ->
    let n := ((n1, n2), n3) in
    sphere m r (isotropic n h) * (1 + n3) = two * tangency n h m r.
  Proof.
    destruct m as [[m1 m2] m3]. intros N2 U N3.
    assert (N3' : n3 + 1 <> 0) by (intro E; apply N3; transitivity (n3 + 1); [ring|exact E]).
    known (eq_12_spheres.part_1_size_1_valid field [n3; n1; n2; h; m1; m2; m3; r]) T.
    destruct (T N2 N3) as (_ & T'). clear T.
    match type of T' with
    | (?v = _ -> _) -> (?w = _) -> _ =>
      assert (W : w = 0);
      [transitivity (n1 * n1 + n2 * n2 + n3 * n3 - 1); [ring|rewrite U; ring]|];
      assert (V : v <> 0);
      [intro E; apply N2; assert (X : two * (n3 + 1) = v * ((n3 + 1) * (n3 + 1)));
        [unfold two; transitivity ((n3 + 1) * (n3 + 1) + (n1 * n1 + n2 * n2 + n3 * n3 - n3 * n3));
          [rewrite U; ring|field; exact N3']
        |rewrite E in X; transitivity (two * (n3 + 1) / (n3 + 1));
          [unfold two; field; exact N3'|rewrite X; field; exact N3']]|]
    end.
    destruct (T' V W) as (_ & _ & E & _). apply difference_zero in E.
    cbv [sphere isotropic tangency].
    match type of E with
    | ?a = ?b => transitivity a; [unfold Offsets.two in *; field; split; assumption
                                 |rewrite E; unfold Offsets.two; ring]
    end.
  Qed.
End Spheres.
