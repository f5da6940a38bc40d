//! Sec. 4: i-minimal meshes from Koebe meshes, and their metric duals.

use super::packing::{
    free_star, has_circles, one_face, radii_of, ring_around, tangential, translated, witnessed,
};
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::check::Residual;
use crate::construct::minimal::{MeshPair, enneper};
use crate::construct::{
    christoffel_by_radii, face_circle, koebe_mesh, metric_dual, vertex_circles,
};
use crate::mesh::{FaceId, Mesh, VertexId};
use crate::net::i_minimal::MixedMeasure;
use crate::net::scribed::EdgeTouchesSigma;
use crate::pair::{FParallel, Misfit, VParallel};
use crate::scalar::{Field, Rational};
use crate::space::{Point, TopView};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "koebe-minimal",
        statement: "The Christoffel dual of an isotropic Koebe mesh is i-minimal at its faces, with the \
                    Koebe mesh as Gauss image, and it is i-isothermic: its circles with the inverse radii \
                    touch along its edges, too.",
        formula: "area(F, S) = 0,  K(F) = -R_0 R_1 R_2 R_3",
        source: Source::Paper("Sec. 4"),
        hypotheses: &[Hypothesis::silent(OFF_CIRCLE), Hypothesis::silent(EVEN_FACES)],
        said: Grade::Certified,
        argument: "It is a statement on single faces and edges once the dual exists, for which see \
                   christoffel-dual, also for all k. Similarities and translations along Σ bring the \
                   incircle of a face to the unit circle about any centre.",
        evidence: &[
            Evidence::identity::<KoebeFace>("a face with k corners", &[4, 6, 8], &[4, 6, 8]),
            Evidence::identity::<KoebeStar>("four quads around a vertex", &[1], &[1]),
        ],
        controls: &[
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
                without: EVEN_FACES,
                shows: "the tangent triangles of Σ are parallel to no others than similar ones",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 3,
                    unknowns: &["0", "2", "-3"],
                    constrained: &[],
                },
            },
        ],
    },
    Claim {
        id: "minimal-at-vertices",
        statement: "The Christoffel dual of a Koebe mesh is i-minimal at its vertices as well, with the Koebe \
                    mesh over its own circles as v-parallel Gauss image; there -K is the product of the radii \
                    of the face circles of the first.",
        formula: "D(v, s) = 0,  K(v) = -ρ_0 ρ_1 ρ_2 ρ_3",
        source: Source::Ours,
        hypotheses: &[Hypothesis::stated(OFF_CIRCLE)],
        said: Grade::Certified,
        argument: "The star is any four quads with touching circles around a vertex; further faces do not enter. The \
                   polygons of gradients are quads around the circles of the vertex, dual to each other: for K \
                   that is christoffel-dual, and is looked at on one surface.",
        evidence: &[
            Evidence::identity::<MinimalAtVertex>("four quads around a vertex", &[1], &[1]),
            Evidence::identity::<EnneperResidual>(
                "K, and the residual of checks, on the Enneper surface",
                &[1],
                &[1],
            ),
        ],
        controls: &[Control {
            without: OFF_CIRCLE,
            shows: "a circle of radius 0 has no inverse",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 1,
                unknowns: &["0", "1/2", "3", "-1/2", "1", "0", "1", "2", "1"],
                constrained: &[],
            },
        }],
    },
    Claim {
        id: "i-minimal-dual",
        statement: "The metric dual of an i-minimal mesh is i-minimal at its vertices, with the metric dual \
                    of the Gauss image as v-parallel Gauss image.",
        formula: "area(F, S) = 0  =>  D(F*, S*) = 0",
        source: Source::Paper("Sec. 2.1 and 4"),
        hypotheses: &[Hypothesis::stated(MINIMAL), Hypothesis::silent(VERTEX_SENSE)],
        said: Grade::Certified,
        argument: "For all k as in eq-21-22-duality: the corners of F are the gradients around F*. After \
                   an i-motion F lies in the plane z = 0; outside of the ring around F nothing enters.",
        evidence: &[
            Evidence::identity::<DualOfMinimal>(
                "a face with k corners and the ring around it",
                &[4, 5, 6],
                &[4, 5, 6, 8],
            ),
            Evidence::identity::<DualOfEnneper>("the Enneper surface", &[1], &[1]),
        ],
        controls: &[
            Control {
                without: MINIMAL,
                shows: "the unit square with itself as Gauss image",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 4,
                    unknowns: &["0", "0", "1", "0", "1", "1", "0", "1", "1", "1", "1", "1", "1"],
                    constrained: &["1"],
                },
            },
            Control {
                without: VERTEX_SENSE,
                shows: "as a pair of faces (M*, S*) has parallel vertices, not parallel planes",
                counterexample: Counterexample::Witness(|| {
                    let centre = [Rational::from_ratio(-1, 3), Rational::from_ratio(-2, 5)];
                    let [x, y] = centre;
                    let pair = enneper(3, 3, &TopView::new(x, y)).map_err(|e| e.to_string())?;
                    let [m, s] = [&pair.surface, &pair.gauss].map(metric_dual);
                    let (m, s) = (m.map_err(|e| e.to_string())?, s.map_err(|e| e.to_string())?);
                    match FParallel::new(&m, &s) {
                        Err(Misfit::FacePlanes { residual, .. }) => witnessed(
                            "a corner of S* misses the plane parallel to M* by",
                            &residual,
                        ),
                        other => Err(format!("{other:?}")),
                    }
                }),
            },
        ],
    },
];

const OFF_CIRCLE: &str = "no vertex lies on its incircles: R_j != 0";
const EVEN_FACES: &str = "the faces have an even number of sides";
const MINIMAL: &str = "(M, S) is i-minimal: area(F, S) = 0";
const VERTEX_SENSE: &str =
    "curvatures of M* are those at vertices, of the v-parallel pair (M*, S*)";

/// Goals: a mesh with radii is i-isothermic, a planar mesh whose circles touch along the edges and
/// have a common orthogonal circle at every face.
fn is_isothermic<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>) -> Run {
    for face in mesh.topology.faces() {
        trial.accepted("a planar face", mesh.face_plane(face))?;
    }
    has_circles(trial, mesh);
    Ok(())
}

/// Goals: the edges of a Koebe mesh touch Σ.
fn is_koebe<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>) {
    for h in mesh.topology.edges() {
        let ends = [mesh.topology.origin(h), mesh.topology.target(h)];
        let ends = ends.map(|v| mesh.points[v.index()].clone());
        trial.zero("touches Σ", EdgeTouchesSigma.eval(&ends, &T::one()));
    }
}

/// The dual of a Koebe mesh, and goals: it is minimal and i-isothermic.
fn minimal_dual<T: Field>(trial: &mut Trial<T>, koebe: &Mesh<T>) -> Result<Mesh<T>, Stop> {
    trial.exhibit("S", koebe);
    is_koebe(trial, koebe);
    let dual = trial.accepted("the dual", christoffel_by_radii(koebe, radii_of(koebe)))?;
    let dual = trial.made_mesh(dual.mesh);
    trial.exhibit("M", &dual);
    is_isothermic(trial, &dual)?;
    let pair = trial.accepted("f-parallel", FParallel::new(&dual, koebe))?;
    for face in dual.topology.faces() {
        let forms = pair.face_forms(face);
        trial.zero("area(F, S)", forms.mixed_area());
        let corners = dual.topology.face(face);
        if corners.len() == 4 {
            let radii = radii_of(koebe);
            let product = corners.iter().fold(T::one(), |product, v| product * &radii[v.index()]);
            trial.zero("K(F)", forms.image_area() + forms.area() * product);
        }
    }
    Ok(dual)
}

struct KoebeFace;

impl Identity for KoebeFace {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let k = trial.size();
        let circles = tangential(trial, k, OFF_CIRCLE)?;
        let by = trial.free_vector2();
        let circles = translated(circles, &by);
        let koebe = trial.accepted("S", koebe_mesh(circles, one_face(k)))?;
        minimal_dual(trial, &koebe)?;
        Ok(())
    }
}

struct KoebeStar;

impl Identity for KoebeStar {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let koebe = free_star(trial, 4, OFF_CIRCLE)?;
        minimal_dual(trial, &koebe)?;
        Ok(())
    }
}

struct MinimalAtVertex;

impl Identity for MinimalAtVertex {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let koebe = free_star(trial, 4, OFF_CIRCLE)?;
        let dual = christoffel_by_radii(&koebe, radii_of(&koebe)).ok();
        let surface = trial.defined(OFF_CIRCLE, dual)?.mesh;
        let circles = trial.defined(OFF_CIRCLE, vertex_circles(&surface))?;
        let image = Mesh { points: circles.iter().map(|c| c.pole()).collect(), ..surface.clone() };
        trial.exhibit("M", &surface);
        trial.exhibit("S", &image);
        let v = VertexId(0);
        let pair = trial.accepted("v-parallel", VParallel::new(&surface, &image))?;
        let forms = trial.accepted("interior", pair.vertex_forms(v))?;
        trial.zero("D(v, s)", forms.mixed_measure());
        // The circles of faces have inverse radii, too.
        for face in surface.topology.faces() {
            let circle = |mesh: &Mesh<T>| face_circle(mesh, face).ok().flatten();
            let [own, other] = [circle(&image), circle(&koebe)];
            let own = trial.defined(OFF_CIRCLE, own)?.radius;
            let other = trial.defined(OFF_CIRCLE, other)?.radius;
            trial.equal("radius of a face", &(own * &other).square(), &T::one());
        }
        Ok(())
    }
}

/// The residual of the checks at the middle of a patch of two by two quads.
struct EnneperResidual;

impl Identity for EnneperResidual {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let koebe = super::lines::free_enneper(trial, 2, 2, None)?.gauss;
        let surface =
            trial.accepted("the dual", christoffel_by_radii(&koebe, radii_of(&koebe)))?.mesh;
        let v = VertexId(4);
        let circles = trial.defined(OFF_CIRCLE, vertex_circles(&surface))?;
        let image = Mesh { points: circles.iter().map(|c| c.pole()).collect(), ..surface.clone() };
        let pair = trial.accepted("v-parallel", VParallel::new(&surface, &image))?;
        let forms = trial.accepted("interior", pair.vertex_forms(v))?;
        let mut product = T::one();
        for face in koebe.topology.faces() {
            let [a, b] = [0, 1].map(|n| koebe.topology.face(face)[n].index());
            let length = &radii_of(&koebe)[a] + &radii_of(&koebe)[b];
            trial.parameter("no edge has length 0", &length)?;
            let circle = face_circle(&koebe, face).ok().flatten();
            product = product * trial.defined(OFF_CIRCLE, circle)?.radius;
        }
        trial.zero("K(v)", forms.measure() + forms.image_measure() * product);
        let around = surface.topology.star(v).map(|h| surface.topology.target(h));
        let at: Vec<VertexId> = std::iter::once(v).chain(around).collect();
        let points: [Point<T>; 10] = std::array::from_fn(|i| match i {
            0..5 => surface.points[at[i].index()].clone(),
            _ => {
                let radius = radii_of(&surface)[at[i - 5].index()].clone();
                Point::new(radius, T::zero(), T::zero())
            }
        });
        trial.zero("residual", MixedMeasure::<true> { valence: 4 }.eval(&points, &T::one()));
        Ok(())
    }
}

struct DualOfMinimal;

impl Identity for DualOfMinimal {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let [surface, gauss] = ring_around(trial, MINIMAL)?;
        let v = mixed_measure_of_duals(trial, &MeshPair { surface, gauss }, VertexId(0))?;
        trial.zero("D(F*, S*)", v);
        Ok(())
    }
}

fn mixed_measure_of_duals<T: Field>(
    trial: &mut Trial<T>,
    pair: &MeshPair<T>,
    v: VertexId,
) -> Result<T, Stop> {
    trial.exhibit("M", &pair.surface);
    trial.exhibit("S", &pair.gauss);
    trial.accepted("f-parallel", FParallel::new(&pair.surface, &pair.gauss))?;
    let dual = trial.accepted("M*", metric_dual(&pair.surface))?;
    let image = trial.accepted("S*", metric_dual(&pair.gauss))?;
    let v_pair = trial.accepted("v-parallel", VParallel::new(&dual, &image))?;
    Ok(trial.accepted("interior", v_pair.vertex_forms(v))?.mixed_measure())
}

struct DualOfEnneper;

impl Identity for DualOfEnneper {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let pair = super::lines::free_enneper(trial, 3, 3, None)?;
        let mixed = FParallel::new(&pair.surface, &pair.gauss);
        let mixed = trial.accepted("f-parallel", mixed)?.face_forms(FaceId(4)).mixed_area();
        trial.zero("area(F, S)", mixed);
        let v = mixed_measure_of_duals(trial, &pair, VertexId(4))?;
        trial.zero("D(F*, S*)", v);
        Ok(())
    }
}
