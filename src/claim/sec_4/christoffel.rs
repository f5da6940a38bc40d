//! Sec. 4: Christoffel duals.

use super::packing::{
    around_a_triangle, face_at, free_star, radii_of, star, tangential, touching, witnessed,
};
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Trial,
};
use crate::construct::{NoChristoffelDual, christoffel_by_diagonals, christoffel_by_radii};
use crate::mesh::{FaceId, Mesh};
use crate::pair::{FParallel, Parallel, four_mixed_areas, twice_area};
use crate::scalar::{Field, Rational, Ring};
use crate::space::{Gradient, Plane, Point, TopView};

pub(super) const CLAIMS: &[Claim] = &[Claim {
    id: "christoffel-dual",
    statement: "In a mesh whose top view has incircles that touch along the edges, the vectors \
                    ±e/(R_i R_j) are the edges of a parallel mesh with mixed area 0 at every face, signs \
                    alternating around every face; it is unique up to scale and translation for quads, and \
                    with exactly these edges area(F)/area(S) = -R_0 R_1 R_2 R_3.",
    formula: "s_j - s_i = ± (v_j - v_i)/(R_i R_j)",
    source: Source::Paper("Sec. 4, Fig. 7"),
    hypotheses: &[
        Hypothesis::silent(EVEN_FACES),
        Hypothesis::silent(EVEN_VALENCE),
        Hypothesis::silent(OFF_CIRCLE),
        Hypothesis::silent(SIMPLY_CONNECTED),
    ],
    said: Grade::Certified,
    argument: "For all even k: the dual of a face has the incircle of radius -1/ρ and the tangents 1/R_j \
                   in the same directions, so it closes; an odd k leaves the last sign over. An edge of the \
                   dual is a matter of its two ends, so in a simply connected mesh closed faces close \
                   everything as soon as signs alternate, which around a vertex takes an even valence. \
                   Two quads are parallel with mixed area 0 iff the edges of one are a multiple of those \
                   that the diagonals give: the duals by radii and by diagonals agree up to a factor.",
    evidence: &[
        Evidence::identity::<DualFace>(
            "a face in space with any even number of sides",
            &[4, 6, 8],
            &[4, 6, 8],
        ),
        Evidence::identity::<Unique>("by radii and by diagonals", &[1], &[1]),
        Evidence::identity::<DualStar>("four quads around a vertex", &[1], &[1]),
    ],
    controls: &[
        Control {
            without: EVEN_FACES,
            shows: "a triangle of sides 3, 4, 5: no choice of signs closes",
            counterexample: Counterexample::Witness(|| {
                let corners = [(0, 0), (3, 0), (0, 4)].map(|(x, y)| at(x, y));
                let radii = [1, 2, 3].map(Rational::from_i64);
                let edges: Vec<_> = (0..3)
                    .map(|j| {
                        let (i, j) = (j, (j + 1) % 3);
                        let scale = (&radii[i] * &radii[j]).try_inv();
                        (&corners[j] - &corners[i]).scaled(&scale.unwrap_or_else(Rational::zero))
                    })
                    .collect();
                let least = (0..4)
                    .map(|signs: i64| {
                        let sign = |n: usize| Rational::from_i64(1 - (signs >> n & 1) * 2);
                        let sum = &edges[0] + &edges[1].scaled(&sign(0));
                        (&sum + &edges[2].scaled(&sign(1))).length2()
                    })
                    .min_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
                witnessed("the squared gap is at least", &least.unwrap_or_else(Rational::zero))
            }),
        },
        Control {
            without: EVEN_VALENCE,
            shows: "three quads with touching circles around a vertex",
            counterexample: Counterexample::Witness(|| {
                let numbers = [0, 2, -2, 1, 1, 2, 3].map(Rational::from_i64);
                let mesh = star(None, &numbers[..3], &numbers[3..]).ok_or("no star")?;
                refused(&mesh, |e| matches!(e, NoChristoffelDual::OddVertex(_)))
            }),
        },
        Control {
            without: OFF_CIRCLE,
            shows: "a triangle with the point of contact as a fourth corner",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 4,
                unknowns: &["0", "0", "2", "-3"],
                constrained: &[],
            },
        },
        Control {
            without: SIMPLY_CONNECTED,
            shows: "six quads around a triangle that is no face: three times rows become columns",
            counterexample: Counterexample::Witness(|| {
                let mesh = around_a_triangle().ok_or("no annulus")?;
                refused(&mesh, |e| matches!(e, NoChristoffelDual::FaceCycle(_)))
            }),
        },
    ],
}];

const OFF_CIRCLE: &str = "no vertex lies on its incircles: R_j != 0";
const EVEN_FACES: &str = "the faces have an even number of sides";
const EVEN_VALENCE: &str = "the interior vertices have even valence";
const SIMPLY_CONNECTED: &str = "M is simply connected";

fn at(x: i64, y: i64) -> TopView<Rational> {
    TopView::new(Rational::from_i64(x), Rational::from_i64(y))
}

/// The mesh satisfies all that is asked but one thing, and has no dual for that reason.
fn refused(
    mesh: &Mesh<Rational>,
    reason: impl Fn(&NoChristoffelDual<Rational>) -> bool,
) -> Result<String, String> {
    if touching(mesh).iter().any(|residual| !residual.is_zero()) {
        return Err("the circles do not touch".into());
    }
    match christoffel_by_radii(mesh, radii_of(mesh)) {
        Err(error) if reason(&error) => Ok(error.to_string()),
        other => Err(format!("{other:?}")),
    }
}

struct DualFace;

impl Identity for DualFace {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let n = trial.size();
        let polygon = tangential(trial, n, OFF_CIRCLE)?;
        let plane = Plane::new(Gradient::new(trial.free(), trial.free()), T::zero());
        let corners = polygon.iter().map(|c| plane.point_at(&c.centre)).collect();
        let mesh = trial.accepted("a face", face_at(corners))?;
        let radii: Vec<T> = polygon.iter().map(|c| c.radius.clone()).collect();
        let dual = trial.accepted("the dual", christoffel_by_radii(&mesh, &radii))?;
        trial.exhibit("F", &mesh);
        let image = trial.made_mesh(dual.mesh);
        trial.exhibit("S", &image);
        trial.accepted("parallel", Parallel::new(&mesh, &image))?;
        let views = |m: &Mesh<T>| m.points.iter().map(Point::top_view).collect::<Vec<_>>();
        let (f, s) = (views(&mesh), views(&image));
        trial.zero("4 area(F, S)", four_mixed_areas(&f, &s));
        for j in 0..n {
            let next = (j + 1) % n;
            let (e, d) =
                (&mesh.points[next] - &mesh.points[j], &image.points[next] - &image.points[j]);
            let product = &radii[j] * &radii[next];
            let product = if j % 2 == 0 { product } else { -product };
            trial.equal("edge", &(&d.x * &product), &e.x);
            trial.equal("edge", &(&d.y * &product), &e.y);
            trial.equal("edge", &(&d.z * &product), &e.z);
        }
        if n == 4 {
            let product = radii.iter().fold(T::one(), |product, r| product * r);
            trial.zero("area(F) = -area(S) ∏ R", twice_area(&f) + twice_area(&s) * product);
        }
        let circles = s.into_iter().zip(dual.factors);
        for (j, (centre, radius)) in circles.enumerate() {
            trial.equal("radius", &(&radius * &radii[j]), &T::one());
            if j == 0 {
                trial.show("radius of the first corner in S", &radius);
                trial.zero("first corner", centre.norm2());
            }
        }
        Ok(())
    }
}

struct Unique;

impl Identity for Unique {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let polygon = tangential(trial, 4, OFF_CIRCLE)?;
        let corners: Vec<_> = polygon.iter().map(|c| c.centre.at_height(T::zero())).collect();
        let mesh = trial.accepted("a face", face_at(corners))?;
        let radii: Vec<T> = polygon.iter().map(|c| c.radius.clone()).collect();
        let view = |j: usize| &polygon[j % 4].centre;
        for j in 0..4 {
            let corner = (view(j + 1) - view(j)).det(&(view(j + 2) - view(j)));
            trial.parameter("no three corners lie on a line", &corner)?;
        }
        let by_radii = trial.accepted("the dual", christoffel_by_radii(&mesh, &radii))?.mesh;
        let by_diagonals = trial.accepted("the dual", christoffel_by_diagonals(&mesh))?;
        let (factors, by_diagonals) = (by_diagonals.factors, by_diagonals.mesh);
        trial.equal("ν of the first vertex", &factors[0], &T::one());
        let (a, b) = (trial.made_mesh(by_radii), trial.made_mesh(by_diagonals));
        for j in 0..4 {
            let next = (j + 1) % 4;
            let (e, d) = (&mesh.points[next] - &mesh.points[j], &b.points[next] - &b.points[j]);
            let factor = &factors[j] * &factors[next];
            trial.equal("edge", &d.x, &(&e.x * &factor));
            trial.equal("edge", &d.y, &(&e.y * &factor));
        }
        for j in 1..4 {
            let (d, e) = (&a.points[1] - &a.points[0], &b.points[1] - &b.points[0]);
            let (p, q) = (&a.points[j] - &a.points[0], &b.points[j] - &b.points[0]);
            // p / d = q / e, with e parallel to d.
            let (scale, other) = (d.dot(&d), e.dot(&d));
            trial.equal("the same up to scale", &(&q.x * &scale), &(&p.x * &other));
            trial.equal("the same up to scale", &(&q.y * &scale), &(&p.y * &other));
            trial.equal("the same up to scale", &(&q.z * &scale), &(&p.z * &other));
        }
        for p in [&a.points[0], &b.points[0]] {
            trial.equal_points("the first corner", p, &Point::new(T::zero(), T::zero(), T::zero()));
        }
        Ok(())
    }
}

struct DualStar;

impl Identity for DualStar {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let mesh = free_star(trial, 4, OFF_CIRCLE)?;
        trial.exhibit("M", &mesh);
        let dual = trial.accepted("the dual", christoffel_by_radii(&mesh, radii_of(&mesh)))?;
        let image = trial.made_mesh(dual.mesh);
        let pair = trial.accepted("f-parallel", FParallel::new(&mesh, &image))?;
        let product = |face: FaceId| {
            let corners = mesh.topology.face(face).iter();
            corners.fold(T::one(), |product, v| product * &radii_of(&mesh)[v.index()])
        };
        for face in mesh.topology.faces() {
            let forms = pair.face_forms(face);
            trial.zero("mixed area", forms.mixed_area());
            trial.zero("areas", forms.area() + forms.image_area() * product(face));
        }
        Ok(())
    }
}
