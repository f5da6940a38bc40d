(** (20): the recorded program says what the paper writes.

    For any two quads; [13] is the diagonal from corner 1 to corner 3. *)

Require Import ZArith List Field.
Require Import Isogeo.program.Script Isogeo.bridge.Offsets.
Require Isogeo.recorded.eq_20.
Import ListNotations.

Section Quads.
  (** Any field. *)
  Variable F : Type.
  Variables (zero one : F) (add mul sub : F -> F -> F) (opp : F -> F) (div : F -> F -> F).
  Variable inv : F -> F.
  Hypothesis laws : field_theory zero one add mul sub opp div inv eq.

  Add Field the_field : laws.

  Definition from (v w : point F) : point F := (sub (fst w) (fst v), sub (snd w) (snd v)).

  Theorem mixed_area_by_diagonals (f1 f2 f3 f4 s1 s2 s3 s4 : point F) :
    four_mixed_areas F zero add mul sub [f1; f2; f3; f4] [s1; s2; s3; s4] =
    add (det F mul sub (from f1 f3) (from s2 s4)) (det F mul sub (from s1 s3) (from f2 f4)).
  Proof.
    destruct f1 as [x1 y1], f2 as [x2 y2], f3 as [x3 y3], f4 as [x4 y4], s1 as [u1 v1],
      s2 as [u2 v2], s3 as [u3 v3], s4 as [u4 v4].
    known (eq_20.part_2_size_1_valid (field F zero one add mul sub opp div inv laws)
      [x1; y1; x2; y2; x3; y3; x4; y4; u1; v1; u2; v2; u3; v3; u4; v4]) T.
    destruct T as (E & _). apply (difference_zero F zero one add mul sub opp div inv laws) in E.
    cbv [four_mixed_areas det from sum edges map combine app fst snd].
    match type of E with
    | ?v = ?w => transitivity v; [ring|rewrite E; ring]
    end.
  Qed.
End Quads.
