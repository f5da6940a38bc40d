(** * i-circular and conical meshes: Remark 1

    A face of an i-circular mesh, under inversions and in Euclidean space.

    - [circular p0 p1 p2 p3 P m r2]: the four points lie in the plane P, over the circle |x - m|² = r2.

    Statements
    - [remark_1_cone]: the oriented planes of the corners touch one cone of revolution: they pass through
      one point, with normals of one product with its axis;
    - [remark_1_parabolic], [remark_1_cylindrical]: inversions keep i-circular faces;
    - [remark_1_cylinder_sharp]: if the circle is the image of a great circle, all normals are orthogonal to
      one direction.

    Unsaid in the paper: no face circle is the image of a great circle or passes through the centre, no
    vertex lies on the axis. That inversions generate the group is not used. *)

From Isogeo.theory Require Export Laguerre Moebius.

Section Remark1.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (p : nat -> point K) (m g : vec K).

(** Any number of corners. *)
Definition circular p (P : plane K) m (r2 : K) := forall j, on (p j) P /\ ||top (p j) - m||² = r2.

Theorem remark_1_cone p g (t : K) m (r2 : K) (planes : nat -> oriented) :
  circular p (Plane g t) m r2 ->
  (forall j, unit (planes j) /\ pz (n (planes j)) + 1 <> 0 /\ image (planes j) = p j) ->
  1 + (||m||² - r2) <> 0 ->
  exists vertex axis, forall j, on_cone vertex axis (planes j).
Proof.
  intros C I G. eexists. eexists. intro j. destruct (I j) as (U & A & E).
  apply (proj1 (eq_12_cones (planes j) m r2 g t U A G)).
  destruct (C j) as [O D]. unfold on_circle. rewrite E. split; [exact D | ].
  apply on_iff in O. exact O.
Qed.

Theorem remark_1_cylinder_sharp p g (t : K) m (r2 : K) (planes : nat -> oriented) :
  circular p (Plane g t) m r2 ->
  (forall j, unit (planes j) /\ pz (n (planes j)) + 1 <> 0 /\ image (planes j) = p j) ->
  1 + (||m||² - r2) = 0 ->
  forall j, dot3 (n (planes j)) (Point m 1) = 0.
Proof.
  intros C I G j. destruct (I j) as (U & A & E).
  apply (proj1 (eq_12_cones_cylinder_sharp (planes j) m r2 U A G)). rewrite E. exact (proj2 (C j)).
Qed.

Theorem remark_1_parabolic S p P m (r2 : K) :
  circular p P m r2 -> exists Q, circular (fun j => mirror S (p j)) Q m r2.
Proof.
  intro C. destruct (moebius_parabolic_circles S P m r2) as [Q H]. exists Q. intro j.
  destruct (C j) as [O D]. split; [exact (H (p j) D O) | exact D].
Qed.

Theorem remark_1_cylindrical (c : point K) (k : K) p P m (r2 : K) :
  k <> 0 -> ||m - top c||² - r2 <> 0 -> (forall j, ||top (p j) - top c||² <> 0) ->
  circular p P m r2 -> exists Q m' r2', circular (fun j => invert c k (p j)) Q m' r2'.
Proof.
  intros N W A C. destruct (moebius_cylindrical_circles c k P m r2 N W) as [Q H].
  exists Q. eexists. eexists. intro j. destruct (C j) as [O D].
  destruct (H (p j) (A j) D O) as [X Y]. split; [exact Y | exact X].
Qed.

End Remark1.
