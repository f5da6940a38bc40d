//! Sec. 4: i-minimal meshes with planar parameter lines (Figs. 8 and 9).

use super::packing::radii_of;
use super::stars::{ParallelPolygons, star_of};
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::check::Residual;
use crate::construct::minimal::{MeshPair, bonnet, enneper, logarithmoid, saddle};
use crate::construct::{christoffel_by_radii, metric_dual, polar_packing, square_packing};
use crate::mesh::{FaceId, Mesh};
use crate::net::planar::Coplanar;
use crate::pair::{FParallel, twice_area};
use crate::scalar::Field;
use crate::space::{Dual, OrientedCircle, Plane, Point, Rotation, TopView};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "fig-8-planar-lines",
        statement: "In the i-minimal meshes from the square grid, its inversions, rotational Koebe meshes \
                    and theirs, and in these Koebe meshes, all row and column polygons are planar.",
        formula: "",
        source: Source::Paper("Sec. 4, Fig. 8"),
        hypotheses: &[Hypothesis::silent(THROUGH), Hypothesis::silent(SECTOR)],
        said: Grade::Certified,
        argument: "The centre is any, so a shift of the grid moves any four consecutive points of a line to \
                   the first ones, for the rotational meshes up to a turn and a scale. Four consecutive \
                   points lie in a plane, so all do: the next plane has three of them in common. That \
                   no other i-minimal meshes have planar lines is not claimed.",
        evidence: &[
            Evidence::identity::<EnneperLines>("the Enneper surface", &[1, 2], &[1, 2, 4]),
            Evidence::identity::<LogarithmoidLines>("the logarithmoid", &[1, 2], &[1, 2, 4]),
            Evidence::identity::<BonnetLines>(
                "the counterpart of Bonnet's surface",
                &[1, 2],
                &[1, 2],
            ),
            Evidence::identity::<SaddleLines>("the paraboloid", &[1, 2], &[1, 2, 5]),
        ],
        controls: &[
            Control {
                without: THROUGH,
                shows: "a circle through the centre has no image",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["1/2", "0"],
                    constrained: &[],
                },
            },
            Control {
                without: SECTOR,
                shows: "sectors without a width",
                counterexample: Counterexample::Unknowns {
                    evidence: 1,
                    size: 1,
                    unknowns: &["0"],
                    constrained: &[],
                },
            },
        ],
    },
    Claim {
        id: "fig-9-concurrent",
        statement: "In the metric duals of these meshes the planes of all faces along a row or a column pass \
                    through one point, which may be at infinity; for the Enneper surface it is known.",
        formula: "row y: (0, 1/(2y), -y²/3 - 1/24)",
        source: Source::Paper("Sec. 4, Fig. 9"),
        hypotheses: &[Hypothesis::silent(THROUGH), Hypothesis::silent(SECTOR)],
        said: Grade::Certified,
        argument: "Face planes of the dual are poles of vertices, which is decided, so by fig-8-planar-lines the point is the pole of \
                   the plane of a line of vertices. Four consecutive planes suffice as there.",
        evidence: &[
            Evidence::identity::<EnneperPoints>("the dual of the Enneper surface", &[1], &[1]),
            Evidence::identity::<LogarithmoidPoints>("the dual of the logarithmoid", &[1], &[1]),
            Evidence::identity::<Pole>("a face of the dual is the pole of a vertex", &[4], &[4]),
            Evidence::identity::<BonnetPoints>(
                "the dual of the counterpart of Bonnet's surface, on instances",
                &[],
                &[1, 2],
            ),
        ],
        controls: &[
            Control {
                without: THROUGH,
                shows: "a circle through the centre has no image",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["1/2", "0"],
                    constrained: &[],
                },
            },
            Control {
                without: SECTOR,
                shows: "sectors without a width",
                counterexample: Counterexample::Unknowns {
                    evidence: 1,
                    size: 1,
                    unknowns: &["0"],
                    constrained: &[],
                },
            },
        ],
    },
];

const THROUGH: &str = "no circle of a vertex or a face passes through the centre of the inversion";
const SECTOR: &str = "the sine of half a sector is not 0, 1 or -1";

/// The Enneper surface about a free centre, none of whose circles passes through it.
pub(super) fn free_enneper<T: Field>(
    trial: &mut Trial<T>,
    rows: usize,
    columns: usize,
    through: Option<&'static str>,
) -> Result<MeshPair<T>, Stop> {
    let centre = TopView::new(trial.free(), trial.free());
    free_enneper_at(trial, rows, columns, &centre, through)
}

fn free_enneper_at<T: Field>(
    trial: &mut Trial<T>,
    rows: usize,
    columns: usize,
    centre: &TopView<T>,
    through: Option<&'static str>,
) -> Result<MeshPair<T>, Stop> {
    let half = T::from_ratio(1, 2);
    let circles = square_packing::<T>(rows, columns);
    let power = |c: &OrientedCircle<T>, by: &T| {
        let at = TopView::new(&c.centre.x + by, &c.centre.y + by);
        centre.distance2(&at) - half.square()
    };
    let mut assume = |value: &T| match through {
        Some(hypothesis) => trial.nonzero(hypothesis, value),
        None => trial.parameter(THROUGH, value),
    };
    for (n, circle) in circles.iter().enumerate() {
        assume(&power(circle, &T::zero()))?;
        // The face that follows in both directions has a circle of the same size.
        if n / (columns + 1) < rows && n % (columns + 1) < columns {
            assume(&power(circle, &half))?;
        }
    }
    trial.defined(THROUGH, enneper(rows, columns, centre).ok())
}

/// Half a sector from its parameter.
fn free_sector<T: Field>(trial: &mut Trial<T>) -> Result<Rotation<T>, Stop> {
    let t = trial.free();
    trial.nonzero(SECTOR, &t)?;
    trial.nonzero(SECTOR, &(T::one() - &t))?;
    trial.nonzero(SECTOR, &(T::one() + &t))?;
    trial.parameter("1 + t² is not 0", &(T::one() + t.square()))?;
    trial.defined(SECTOR, Rotation::from_parameter(&t).ok())
}

/// The counterpart of Bonnet's surface about a free centre.
fn free_bonnet<T: Field>(
    trial: &mut Trial<T>,
    rings: usize,
    sectors: usize,
) -> Result<MeshPair<T>, Stop> {
    let half = free_sector(trial)?;
    let centre = TopView::new(trial.free(), trial.free());
    let circles = trial.defined(SECTOR, polar_packing(rings, sectors, &half))?;
    for circle in &circles {
        trial.nonzero(THROUGH, &circle.circle().power(&centre))?;
    }
    let pair = trial.defined(THROUGH, bonnet(rings, sectors, &half, &centre).ok())?;
    for (radius, image) in radii_of(&pair.surface).iter().zip(radii_of(&pair.gauss)) {
        trial.equal("radii", &(radius * image), &half.sin().square());
    }
    for face in pair.gauss.topology.faces() {
        let corners = pair.gauss.topology.face(face).iter().take(3);
        let views: Vec<_> = corners.map(|v| pair.gauss.points[v.index()].top_view()).collect();
        trial.nonzero(THROUGH, &twice_area(&views))?;
    }
    Ok(pair)
}

/// Goals: each four consecutive points of the lines of a patch of m rows and n columns lie in a plane.
fn planar_lines<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>, m: usize, n: usize) {
    let at = |i: usize, j: usize| mesh.points[i * (n + 1) + j].clone();
    for i in 0..=m {
        for start in 0..(n + 1).saturating_sub(3) {
            let row = std::array::from_fn(|k| at(i, start + k));
            trial.zero("row", Coplanar.eval(&row, &T::one()));
        }
    }
    for j in 0..=n {
        for start in 0..(m + 1).saturating_sub(3) {
            let column = std::array::from_fn(|k| at(start + k, j));
            trial.zero("column", Coplanar.eval(&column, &T::one()));
        }
    }
}

/// Two strips, of one row and of one column; then squares.
fn extent(size: usize) -> (usize, usize) {
    match size {
        1 => (3, 1),
        2 => (1, 3),
        n => (n, n),
    }
}

fn both<T: Field>(
    trial: &mut Trial<T>,
    pair: &MeshPair<T>,
    (m, n): (usize, usize),
) -> Result<Mesh<T>, Stop> {
    trial.exhibit("M", &pair.surface);
    trial.exhibit("S", &pair.gauss);
    planar_lines(trial, &pair.surface, m, n);
    planar_lines(trial, &pair.gauss, m, n);
    let f_pair = trial.accepted("f-parallel", FParallel::new(&pair.surface, &pair.gauss))?;
    for face in pair.surface.topology.faces() {
        trial.zero("area(F, S)", f_pair.face_forms(face).mixed_area());
    }
    let dual = christoffel_by_radii(&pair.gauss, radii_of(&pair.gauss));
    Ok(trial.accepted("the Christoffel dual", dual)?.mesh)
}

/// Goals: a mesh is a multiple of another one, up to a translation.
fn multiple<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>, of: &Mesh<T>, factor: &T) {
    for (p, q) in mesh.points.iter().zip(&of.points) {
        let (d, e) = (p - &mesh.points[0], q - &of.points[0]);
        trial.equal("the Christoffel dual", &d.x, &(&e.x * factor));
        trial.equal("the Christoffel dual", &d.y, &(&e.y * factor));
        trial.equal("the Christoffel dual", &d.z, &(&e.z * factor));
    }
}

struct EnneperLines;

impl Identity for EnneperLines {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (m, n) = extent(trial.size());
        let pair = free_enneper(trial, m, n, Some(THROUGH))?;
        let dual = both(trial, &pair, (m, n))?;
        multiple(trial, &pair.surface, &dual, &T::from_ratio(1, 4));
        Ok(())
    }
}

struct LogarithmoidLines;

impl Identity for LogarithmoidLines {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (m, n) = extent(trial.size());
        let half = free_sector(trial)?;
        let pair = trial.defined(SECTOR, logarithmoid(m, n, &half).ok())?;
        let dual = both(trial, &pair, (m, n))?;
        multiple(trial, &pair.surface, &dual, &half.sin().square());
        Ok(())
    }
}

struct BonnetLines;

impl Identity for BonnetLines {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (m, n) = extent(trial.size());
        let pair = free_bonnet(trial, m, n)?;
        trial.exhibit("M", &pair.surface);
        planar_lines(trial, &pair.surface, m, n);
        planar_lines(trial, &pair.gauss, m, n);
        Ok(())
    }
}

struct SaddleLines;

impl Identity for SaddleLines {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (m, n) = extent(trial.size());
        let pair = trial.accepted("the paraboloid", saddle::<T>(m, n))?;
        let dual = both(trial, &pair, (m, n))?;
        multiple(trial, &pair.surface, &dual, &T::from_ratio(1, 4));
        Ok(())
    }
}

/// The planes of the first four faces of a mesh.
fn four_planes<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>) -> Result<[Plane<T>; 4], Stop> {
    trial.exhibit("M", mesh);
    let dual = trial.accepted("M*", metric_dual(mesh))?;
    trial.exhibit("M*", &dual);
    let mut plane = |face: u32| trial.accepted("a plane of M*", dual.face_plane(FaceId(face)));
    Ok([plane(0)?, plane(1)?, plane(2)?, plane(3)?])
}

/// Goal: four planes have a point in common, which may be at infinity.
fn concurrent<T: Field>(trial: &mut Trial<T>, planes: &[Plane<T>; 4]) {
    let point = |plane: &Plane<T>| {
        let [x, y, z] = [&plane.gradient.x, &plane.gradient.y, &plane.height];
        Point::new(x.clone(), y.clone(), z.clone())
    };
    // The determinant of the rows (p, t, 1).
    trial.zero("through one point", Coplanar.eval(&planes.each_ref().map(point), &T::one()));
}

struct EnneperPoints;

impl Identity for EnneperPoints {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let centre = TopView::new(trial.free(), trial.free());
        for rows in [false, true] {
            let (m, n) = if rows { (5, 2) } else { (2, 5) };
            let pair = free_enneper_at(trial, m, n, &centre, Some(THROUGH))?;
            let planes = four_planes(trial, &pair.surface)?;
            concurrent(trial, &planes);
            // The line with index 1 of the grid.
            let offset = T::one() - if rows { &centre.y } else { &centre.x };
            let height = offset.square() * T::from_ratio(1, 3) + T::from_ratio(1, 24);
            for Plane { gradient: p, height: t } in &planes {
                // The plane at the point, times twice the offset, which may be 0.
                let (along, height) = if rows { (&p.y, -&height) } else { (&p.x, height.clone()) };
                let shear = T::dot([&p.x, &p.y], [&centre.x, &centre.y]);
                let value = (height - shear - t) * &offset * T::from_i64(2) - along;
                trial.zero("the point", value);
            }
        }
        Ok(())
    }
}

struct LogarithmoidPoints;

impl Identity for LogarithmoidPoints {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let half = free_sector(trial)?;
        for (m, n) in [(2, 5), (5, 2)] {
            let pair = trial.defined(SECTOR, logarithmoid(m, n, &half).ok())?;
            let planes = four_planes(trial, &pair.surface)?;
            concurrent(trial, &planes);
        }
        Ok(())
    }
}

/// A strip along a ray or a ring.
struct BonnetPoints;

impl Identity for BonnetPoints {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (m, n) = if trial.size() == 1 { (2, 5) } else { (5, 2) };
        let pair = free_bonnet(trial, m, n)?;
        let planes = four_planes(trial, &pair.surface)?;
        concurrent(trial, &planes);
        Ok(())
    }
}

struct Pole;

impl Identity for Pole {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let gradients = ParallelPolygons::free(trial)?.f;
        let k = gradients.len();
        let reach: Vec<T> = (0..k).map(|_| trial.free()).collect();
        let edge = |j: usize| &gradients[(j + 1) % k] - &gradients[j % k];
        for (j, factor) in reach.iter().enumerate() {
            trial.parameter("no face of the star is vertical", factor)?;
            trial.parameter("no face of the star is vertical", &edge(j).det(&edge(j + 1)))?;
        }
        let star = trial.accepted("M", star_of(&gradients, &gradients, &reach))?;
        let by = trial.free_vector3();
        let points = star.points.iter().map(|p| p + &by).collect();
        let mesh = Mesh { points, ..star };
        let dual = trial.accepted("M*", metric_dual(&mesh))?;
        let plane = trial.accepted("a plane of M*", dual.face_plane(FaceId(0)))?;
        let pole = mesh.points[0].dual();
        trial.equal("gradient", &plane.gradient.x, &pole.gradient.x);
        trial.equal("gradient", &plane.gradient.y, &pole.gradient.y);
        trial.equal("height", &plane.height, &pole.height);
        Ok(())
    }
}
