(** * Planar parameter lines: the paraboloid and the Enneper surface

    The square grid with circles of radius h/2, its inversion, and the Christoffel duals, in closed form
    (Sec. 4, Figs. 8 and 9).

    - [N h x y]: the power of the circle at the grid point (x, y) to the origin;
    - [koebe], [radius]: the vertices of the Koebe mesh and their signed radii;
    - [enneper]: the vertices of the i-minimal mesh, three times those of the ledger;
    - [paraboloid]: those of the dual of the grid itself.

    Statements
    - [fig_8_koebe_lift], [fig_8_koebe]: the edges of the Koebe mesh belong to touching circles;
    - [fig_8_enneper_rows], [fig_8_enneper_columns]: edges of the surface are ± (3h²/4) e/(R_i R_j), the
      Christoffel dual;
    - [fig_8_planar_lines_row], [fig_8_planar_lines_column]: its rows and columns are planar, and so
      are those of the Koebe mesh ([fig_8_planar_lines_koebe_row],
      [fig_8_planar_lines_koebe_column]);
    - [fig_9_concurrent_row], [fig_9_concurrent_column]: the planes of the faces of the metric dual along
      a row or column pass through one point;
    - [fig_8_paraboloid]: the Christoffel dual of the grid itself has its vertices on z = (x² - y²)/2.

    Unsaid in the paper: no circle passes through the centre of the inversion, N != 0; x or y is not 0
    where the plane of a line is not isotropic. The surfaces with rotational symmetry are not here. *)

From Isogeo.theory Require Export Koebe Duality.

Section Enneper.
Context {K : Scalar}.
Add Field scalars : (laws K).
Variable h : K.
Implicit Types x y : K.

Definition N x y := x² + y² - h² / 4.
Definition radius x y := h / 2 / N x y.
Definition koebe x y := Point (Vec (x / N x y) (y / N x y)) (1 / (2 * N x y)).
Definition enneper x y :=
  Point (Vec (3 * x * y² - x * x² + h² * x / 4) (- (3 * x² * y) + y * y² - h² * y / 4))
    (3 * (y² - x²) / 2).
Definition paraboloid x y := Point (Vec x (- y)) ((x² - y²) / 2).

Lemma power_square x y : h² = 4 * (x² + y² - N x y).
Proof. unfold N. field. nonzero. Qed.

Lemma power_right x y : N (x + h) y = N x y + 2 * x * h + h².
Proof. unfold N. ring. Qed.

Lemma power_up x y : N x (y + h) = N x y + 2 * y * h + h².
Proof. unfold N. ring. Qed.

(** Identities between neighbours: powers are unknowns, h² and the next power follow from them. *)
Ltac by_powers x y :=
  assert (E := power_square x y); try assert (E1 := power_right x y); try assert (E2 := power_up x y);
  set (n := N x y) in *; set (n1 := N (x + h) y) in *; set (n2 := N x (y + h)) in *;
  clearbody n n1 n2.

(** The lift of the centre of a circle, and the sides of squares. *)
Theorem fig_8_koebe_lift x y :
  N x y <> 0 -> 2 * pz (koebe x y) = ||top (koebe x y)||² - (radius x y)².
Proof. intro A. unfold koebe, radius. spatial. by_powers x y. field [E]. nonzero. Qed.

Theorem fig_8_koebe x y :
  N x y <> 0 -> N (x + h) y <> 0 -> N x (y + h) <> 0 ->
  tangent_circles (top (koebe x y)) (radius x y) (top (koebe (x + h) y)) (radius (x + h) y) /\
  tangent_circles (top (koebe x y)) (radius x y) (top (koebe x (y + h))) (radius x (y + h)).
Proof.
  intros A B C. unfold tangent_circles, koebe, radius. spatial. by_powers x y.
  split; [field [E E1] | field [E E2]]; nonzero.
Qed.

Theorem fig_8_enneper_rows x y :
  h <> 0 -> N x y <> 0 -> N (x + h) y <> 0 ->
  (enneper (x + h) y - enneper x y)%P =
  ((3 * h² / 4 / (radius x y * radius (x + h) y)) ** (koebe (x + h) y - koebe x y))%P.
Proof.
  intros H A B. unfold enneper, koebe, radius.
  apply point_eq; [apply vec_eq | ]; spatial; by_powers x y; field [E E1]; nonzero.
Qed.

Theorem fig_8_enneper_columns x y :
  h <> 0 -> N x y <> 0 -> N x (y + h) <> 0 ->
  (enneper x (y + h) - enneper x y)%P =
  ((- (3 * h² / 4 / (radius x y * radius x (y + h)))) ** (koebe x (y + h) - koebe x y))%P.
Proof.
  intros H A B. unfold enneper, koebe, radius.
  apply point_eq; [apply vec_eq | ]; spatial; by_powers x y; field [E E2]; nonzero.
Qed.

(** ** Planar lines *)

Definition row_plane y : plane K := Plane (Vec 0 (1 / (2 * y))) (y² + h² / (2 * 4)).
Definition column_plane x : plane K := Plane (Vec (1 / (2 * x)) 0) (- (x² + h² / (2 * 4))).

Theorem fig_8_planar_lines_row x y : y <> 0 -> on (enneper x y) (row_plane y).
Proof. intro Y. unfold enneper, row_plane. spatial. field. nonzero. Qed.

Theorem fig_8_planar_lines_column x y : x <> 0 -> on (enneper x y) (column_plane x).
Proof. intro X. unfold enneper, column_plane. spatial. field. nonzero. Qed.

Theorem fig_8_planar_lines_koebe_row x y :
  y <> 0 -> N x y <> 0 -> on (koebe x y) (Plane (Vec 0 (1 / (2 * y))) 0).
Proof. intros Y A. unfold koebe. spatial. field. nonzero. Qed.

Theorem fig_8_planar_lines_koebe_column x y :
  x <> 0 -> N x y <> 0 -> on (koebe x y) (Plane (Vec (1 / (2 * x)) 0) 0).
Proof. intros X A. unfold koebe. spatial. field. nonzero. Qed.

(** The planes of the faces of the metric dual are polar to the vertices. *)
Theorem fig_9_concurrent_row x y : y <> 0 -> on (pole (row_plane y)) (polar (enneper x y)).
Proof. intro Y. apply (proj1 (duality_incidence _ _)), fig_8_planar_lines_row, Y. Qed.

Theorem fig_9_concurrent_column x y : x <> 0 -> on (pole (column_plane x)) (polar (enneper x y)).
Proof. intro X. apply (proj1 (duality_incidence _ _)), fig_8_planar_lines_column, X. Qed.

(** The dual of the square grid, with R_i R_j = h²/4, up to that factor. *)
Theorem fig_8_paraboloid x y :
  (paraboloid (x + h) y - paraboloid x y)%P = (lift (Vec (x + h) y) - lift (Vec x y))%P /\
  (paraboloid x (y + h) - paraboloid x y)%P = (- (1) ** (lift (Vec x (y + h)) - lift (Vec x y)))%P /\
  pz (paraboloid x y) = ((vx (top (paraboloid x y)))² - (vy (top (paraboloid x y)))²) / 2.
Proof.
  unfold paraboloid. repeat split; [ | | spatial; field; nonzero];
    apply point_eq; [apply vec_eq | | apply vec_eq | ]; spatial; field; nonzero.
Qed.

End Enneper.
