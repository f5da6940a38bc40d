(** * Vectors of the top view

    Plane vectors over a field, which are complex numbers, too; quads and their in-circle determinant.

    - [det a b], [dot a b], [norm2 a]: area, scalar product, squared length;
      [J a]: a quarter turn, counterclockwise;
    - [cmul], [conj]: product and conjugate of complex numbers, [im]: the imaginary part;
    - [concyclic_or_collinear]: the in-circle determinant [incircle] vanishes;
    - [parallel a b]: the determinant vanishes; the zero vector is parallel to everything. *)

From Isogeo.theory Require Export Scalar.

Record vec (K : Scalar) := Vec { vx : K; vy : K }.
Arguments Vec {K}.
Arguments vx {K}.
Arguments vy {K}.
Declare Scope vec_scope.
Delimit Scope vec_scope with V.
Bind Scope vec_scope with vec.

Section Vectors.
Context {K : Scalar}.
Add Field scalars : (laws K).

Definition null : vec K := Vec 0 0.
Definition vadd (a b : vec K) := Vec (vx a + vx b) (vy a + vy b).
Definition vsub (a b : vec K) := Vec (vx a - vx b) (vy a - vy b).
Definition vopp (a : vec K) := Vec (- vx a) (- vy a).
Definition scale (r : K) (a : vec K) := Vec (r * vx a) (r * vy a).
Definition dot (a b : vec K) := vx a * vx b + vy a * vy b.
Definition det (a b : vec K) := vx a * vy b - vy a * vx b.
Definition norm2 (a : vec K) := dot a a.
Definition J (a : vec K) := Vec (- vy a) (vx a).
Definition conj (a : vec K) := Vec (vx a) (- vy a).
Definition cmul (a b : vec K) := Vec (vx a * vx b - vy a * vy b) (vx a * vy b + vy a * vx b).
Definition im (a : vec K) := vy a.
Definition parallel (a b : vec K) := det a b = 0.

(** The determinant with the rows (v, |v|²) for v = b - a, c - a, d - a. *)
Definition incircle (a b c d : vec K) :=
  let u := vsub b a in let v := vsub c a in let w := vsub d a in
  norm2 u * det v w - norm2 v * det u w + norm2 w * det u v.

Definition concyclic_or_collinear (a b c d : vec K) := incircle a b c d = 0.

End Vectors.

Notation "a + b" := (vadd a b) : vec_scope.
Notation "a - b" := (vsub a b) : vec_scope.
Notation "- a" := (vopp a) : vec_scope.
Notation "r ** a" := (scale r%K a) (at level 39, right associativity) : vec_scope.
Notation "|| a ||²" := (norm2 a) (at level 0, a at level 99, format "|| a ||²") : scalar_scope.

(** Everything in coordinates. *)
Ltac coordinates :=
  unfold parallel, concyclic_or_collinear, incircle, norm2, dot, det, J, conj, cmul, im,
    vadd, vsub, vopp, scale, null in *;
  cbn [vx vy] in *.

Section Laws.
Context {K : Scalar}.
Add Field scalars' : (laws K).
Implicit Types a b c d m p : vec K.

Lemma vec_eq a b : vx a = vx b -> vy a = vy b -> a = b.
Proof. destruct a, b. cbn. intros -> ->. reflexivity. Qed.

Lemma vec_eta a : a = Vec (vx a) (vy a).
Proof. destruct a. reflexivity. Qed.

Lemma vsub_zero a b : (a - b)%V = null <-> a = b.
Proof.
  split; [intro H | intros ->].
  - apply vec_eq; apply difference_zero.
    + exact (f_equal vx H).
    + exact (f_equal vy H).
  - apply vec_eq; coordinates; ring.
Qed.

Lemma vec_nonzero a : a <> null -> vx a <> 0 \/ vy a <> 0.
Proof.
  intro H. destruct (decidable K (vx a)) as [X | X]; [right | left; exact X].
  intro Y. apply H, vec_eq; assumption.
Qed.

(** What is parallel to a vector that is not 0 is a multiple of it. *)
Lemma parallel_multiple a b : a <> null -> parallel a b -> exists r, b = (r ** a)%V.
Proof.
  intros H P. destruct (vec_nonzero a H) as [X | Y].
  - exists (vx b / vx a). apply vec_eq; coordinates; [field; exact X | ].
    apply (equals_by K (vx a)); [exact X | ]. apply difference_zero. rewrite <- P. field. exact X.
  - exists (vy b / vy a). apply vec_eq; coordinates; [ | field; exact Y].
    apply (equals_by K (vy a)); [exact Y | ]. apply difference_zero, opposite_zero.
    rewrite <- P. field. exact Y.
Qed.

Lemma scale_zero (r : K) a : a <> null -> (r ** a)%V = null -> r = 0.
Proof.
  intros H E. destruct (vec_nonzero a H) as [X | Y].
  - apply (cancel K (vx a)); [exact X | ].
    transitivity (vx (r ** a)%V); [coordinates; ring | rewrite E; reflexivity].
  - apply (cancel K (vy a)); [exact Y | ].
    transitivity (vy (r ** a)%V); [coordinates; ring | rewrite E; reflexivity].
Qed.

(** The in-circle determinant of a quad by its edges: with complex numbers, the imaginary part of
    e0 e2 conj (e1 e3). *)
Lemma incircle_edges p0 p1 p2 p3 :
  incircle p0 p1 p2 p3 =
  im (cmul (cmul (p1 - p0) (p3 - p2)) (conj (cmul (p2 - p1) (p0 - p3)))).
Proof. coordinates. ring. Qed.

(** Points at the same distance from a centre are concyclic. *)
Lemma incircle_of_circle m (r2 : K) p0 p1 p2 p3 :
  ||p0 - m||² = r2 -> ||p1 - m||² = r2 -> ||p2 - m||² = r2 -> ||p3 - m||² = r2 ->
  incircle p0 p1 p2 p3 = 0.
Proof.
  intros H0 H1 H2 H3. coordinates.
  destruct p0 as [x0 y0], p1 as [x1 y1], p2 as [x2 y2], p3 as [x3 y3], m as [u v]. cbn in *.
  eliminate.
Qed.

(** The centre of the circle through three points. *)
Definition circumcentre p0 p1 p2 : vec K :=
  let u := (p1 - p0)%V in let v := (p2 - p0)%V in
  (p0 + (1 / (2 * det u v)) ** Vec (||u||² * vy v - ||v||² * vy u) (||v||² * vx u - ||u||² * vx v))%V.

Lemma circumcentre_equidistant p0 p1 p2 :
  det (p1 - p0) (p2 - p0) <> 0 ->
  let m := circumcentre p0 p1 p2 in
  ||p1 - m||² = ||p0 - m||² /\ ||p2 - m||² = ||p0 - m||².
Proof.
  intros D m. unfold m, circumcentre. coordinates.
  split; field; nonzero.
Qed.

(** Conversely: with three corners that are not collinear, concyclic means on one circle. *)
Lemma circle_of_incircle p0 p1 p2 p3 :
  det (p1 - p0) (p2 - p0) <> 0 -> incircle p0 p1 p2 p3 = 0 ->
  let m := circumcentre p0 p1 p2 in ||p3 - m||² = ||p0 - m||².
Proof.
  intros D I m. apply difference_zero. apply (cancel K (det (p1 - p0) (p2 - p0))); [exact D | ].
  rewrite <- I. unfold m, circumcentre. coordinates. field. nonzero.
Qed.

End Laws.
