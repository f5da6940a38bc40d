(** * Isotropic Koebe meshes

    Circles of the top view, with signed radii, stand for planes: Σ lies over the plane of a circle by
    half the power of the circle (Sec. 3.4).

    - [circle_plane c r]: the plane that cuts Σ over |x - c|² = r²;
    - [tangent_circles], [contact]: |c1 - c2|² = (r1 + r2)² and where they touch;
    - [orthogonal_circle v r2 c r]: |v - c|² = r2 + r².

    Statements
    - [koebe_edge]: the planes of tangent circles meet over the common tangent,
      [koebe_edge_touches]: where the height over Σ is -|x - t|²/2;
    - [koebe_vertex]: the plane of a circle passes through v iff the circle is orthogonal to that with
      centre v' and squared radius |v'|² - 2 v3, for any number of circles;
    - [koebe_vertex_contact]: contacts lie on that circle;
    - [koebe_vertex_contacts]: the contacts of a cycle of four are concyclic in any case;
      four unit circles on a rhombus, [koebe_vertex_sharp] in Counterexamples.v, touch in a cycle and have
      no common orthogonal circle. *)

From Isogeo.theory Require Export Isotropic.

Section Koebe.
Context {K : Scalar}.
Add Field scalars : (laws K).
Implicit Types (c t x u : vec K) (v : point K) (r : K).

Definition circle_plane c r : plane K := Plane c (- ((||c||² - r²) / 2)).
Definition tangent_circles c1 r1 c2 r2 := ||c1 - c2||² = (r1 + r2)².
Definition contact c1 (r1 : K) c2 (r2 : K) := ((1 / (r1 + r2)) ** (r2 ** c1 + r1 ** c2))%V.
Definition orthogonal_circle (m : vec K) (rho2 : K) c r := ||m - c||² = rho2 + r².

Lemma circle_plane_section c r x : on (lift x) (circle_plane c r) <-> ||x - c||² = r².
Proof.
  rewrite section_circle. unfold circle_plane. cbn [slope level].
  replace (||c||² + 2 * - ((||c||² - r²) / 2)) with r²; [reflexivity | field; nonzero].
Qed.

Lemma contact_on_circles c1 r1 c2 r2 :
  r1 + r2 <> 0 -> tangent_circles c1 r1 c2 r2 ->
  ||contact c1 r1 c2 r2 - c1||² = r1² /\ ||contact c1 r1 c2 r2 - c2||² = r2².
Proof.
  intros N T. unfold tangent_circles in T.
  split; apply (equals_by K ((r1 + r2)²)); try nonzero.
  - transitivity (r1² * ||c1 - c2||²); [unfold contact; coordinates; field; exact N | rewrite T; ring].
  - transitivity (r2² * ||c1 - c2||²); [unfold contact; coordinates; field; exact N | rewrite T; ring].
Qed.

(** The point of the common tangent at the distance l |c2 - c1| from the contact. *)
Definition on_tangent c1 r1 c2 r2 (l : K) := (contact c1 r1 c2 r2 + l ** J (c2 - c1))%V.

Theorem koebe_edge c1 r1 c2 r2 l :
  r1 + r2 <> 0 -> tangent_circles c1 r1 c2 r2 ->
  at_plane (circle_plane c1 r1) (on_tangent c1 r1 c2 r2 l) =
  at_plane (circle_plane c2 r2) (on_tangent c1 r1 c2 r2 l).
Proof.
  intros N T. apply difference_zero. apply (cancel K (2 * (r1 + r2))); [nonzero | ].
  transitivity ((r1 - r2) * ((r1 + r2)² - ||c1 - c2||²)).
  - unfold on_tangent, contact, circle_plane. spatial. field. nonzero.
  - unfold tangent_circles in T. rewrite T. ring.
Qed.

Theorem koebe_edge_touches c1 r1 c2 r2 l :
  r1 + r2 <> 0 -> tangent_circles c1 r1 c2 r2 ->
  let t := contact c1 r1 c2 r2 in let x := on_tangent c1 r1 c2 r2 l in
  at_plane (circle_plane c1 r1) x - s x = - (||x - t||² / 2).
Proof.
  intros N T t x. assert (E := proj1 (contact_on_circles c1 r1 c2 r2 N T)). fold t in E.
  assert (O : dot (t - c1) (x - t) = 0) by (unfold x, on_tangent, t, contact; coordinates; field; exact N).
  transitivity ((r1² - ||t - c1||² - 2 * dot (t - c1) (x - t) - ||x - t||²) / 2).
  - unfold circle_plane. spatial. field. nonzero.
  - rewrite E, O. field. nonzero.
Qed.

Theorem koebe_vertex v c r :
  on v (circle_plane c r) <-> orthogonal_circle (top v) (||top v||² - 2 * pz v) c r.
Proof.
  unfold orthogonal_circle. rewrite <- (difference_zero K (||top v - c||²)).
  replace (||top v - c||² - (||top v||² - 2 * pz v + r²)) with (2 * over (circle_plane c r) v)
    by (unfold circle_plane; spatial; field; nonzero).
  unfold on. split; intro Z; [rewrite Z; ring | apply (cancel K 2); [nonzero | exact Z]].
Qed.

(** Conversely a circle that is orthogonal to all, with a squared radius, is that of a point. *)
Theorem koebe_vertex_point (m : vec K) (rho2 : K) :
  exists v, top v = m /\ ||top v||² - 2 * pz v = rho2.
Proof. exists (Point m ((||m||² - rho2) / 2)). cbn. split; [reflexivity | field; nonzero]. Qed.

Theorem koebe_vertex_contact (m : vec K) (rho2 : K) c1 r1 c2 r2 :
  r1 + r2 <> 0 -> tangent_circles c1 r1 c2 r2 ->
  orthogonal_circle m rho2 c1 r1 -> orthogonal_circle m rho2 c2 r2 ->
  ||contact c1 r1 c2 r2 - m||² = rho2.
Proof.
  intros N T O1 O2. apply (equals_by K ((r1 + r2)²)); [nonzero | ].
  unfold tangent_circles, orthogonal_circle in *.
  transitivity ((r1 + r2) * (r2 * ||m - c1||² + r1 * ||m - c2||²) - r1 * r2 * ||c1 - c2||²).
  - unfold contact. coordinates. field. exact N.
  - rewrite O1, O2, T. ring.
Qed.

(** A cycle of four circles, each touching the next in the direction u of unit length. *)
Lemma unit_sum u u' : ||u||² = 1 -> ||u'||² = 1 -> cmul (conj (u + u')) (cmul u u') = (u + u')%V.
Proof.
  intros A B. transitivity (||u||² ** u' + ||u'||² ** u)%V.
  - apply vec_eq; coordinates; ring.
  - rewrite A, B. apply vec_eq; coordinates; ring.
Qed.

Theorem koebe_vertex_contacts c0 c1 c2 c3 u0 u1 u2 u3 (r0 r1 r2 r3 : K) :
  ||u0||² = 1 -> ||u1||² = 1 -> ||u2||² = 1 -> ||u3||² = 1 ->
  (c1 - c0 = (r0 + r1) ** u0)%V -> (c2 - c1 = (r1 + r2) ** u1)%V ->
  (c3 - c2 = (r2 + r3) ** u2)%V -> (c0 - c3 = (r3 + r0) ** u3)%V ->
  incircle (c0 + r0 ** u0) (c1 + r1 ** u1) (c2 + r2 ** u2) (c3 + r3 ** u3) = 0.
Proof.
  intros N0 N1 N2 N3 E0 E1 E2 E3. rewrite incircle_edges.
  assert (F : forall (c c' u u' : vec K) (r r' : K), (c' - c = (r + r') ** u)%V ->
    ((c' + r' ** u') - (c + r ** u) = r' ** (u + u'))%V).
  { intros c c' u u' r r' E. transitivity ((c' - c) + (r' ** u' - r ** u))%V.
    - apply vec_eq; coordinates; ring.
    - rewrite E. apply vec_eq; coordinates; ring. }
  rewrite (F c0 c1 u0 u1 r0 r1 E0), (F c1 c2 u1 u2 r1 r2 E1), (F c2 c3 u2 u3 r2 r3 E2),
    (F c3 c0 u3 u0 r3 r0 E3).
  assert (H0 := unit_sum u0 u1 N0 N1). assert (H1 := unit_sum u1 u2 N1 N2).
  assert (H2 := unit_sum u2 u3 N2 N3). assert (H3 := unit_sum u3 u0 N3 N0).
  assert (M : ||cmul (cmul u0 u1) (cmul u2 u3)||² = 1).
  { transitivity (||u0||² * ||u1||² * (||u2||² * ||u3||²)); [coordinates; ring | ].
    rewrite N0, N1, N2, N3. ring. }
  set (a0 := (u0 + u1)%V) in *. set (a1 := (u1 + u2)%V) in *.
  set (a2 := (u2 + u3)%V) in *. set (a3 := (u3 + u0)%V) in *.
  assert (R : im (cmul (cmul a0 a2) (conj (cmul a1 a3))) = 0).
  { assert (A : cmul (cmul a0 a2) (conj (cmul a1 a3))
      = cmul (cmul (cmul u0 u1) (cmul u2 u3)) (cmul (conj (cmul a0 a2)) (conj (cmul a1 a3)))).
    { rewrite <- H0 at 1. rewrite <- H2 at 1. apply vec_eq; coordinates; ring. }
    assert (B : cmul (conj (cmul a0 a2)) (cmul a1 a3)
      = cmul (cmul (cmul u0 u1) (cmul u2 u3)) (cmul (conj (cmul a0 a2)) (conj (cmul a1 a3)))).
    { rewrite <- H1 at 1. rewrite <- H3 at 1. apply vec_eq; coordinates; ring. }
    assert (C : cmul (cmul a0 a2) (conj (cmul a1 a3)) = conj (cmul (cmul a0 a2) (conj (cmul a1 a3)))).
    { transitivity (cmul (conj (cmul a0 a2)) (cmul a1 a3)); [congruence | apply vec_eq; coordinates; ring]. }
    apply (cancel K 2); [nonzero | ]. assert (D := f_equal vy C). unfold im.
    set (w := cmul (cmul a0 a2) (conj (cmul a1 a3))) in *. clearbody w. cbn [conj vy] in D.
    transitivity (vy w - - vy w); [ring | rewrite <- D; ring]. }
  transitivity (r0 * r1 * (r2 * r3) * im (cmul (cmul a0 a2) (conj (cmul a1 a3)))).
  - clear. coordinates. ring.
  - rewrite R. ring.
Qed.

End Koebe.
