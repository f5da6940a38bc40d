//! Sec. 3.2, Theorem 2: i-conical meshes, their duals and their circumscribed Gauss images.

use super::instance::{
    CORNERS, all_different, free_top_view, gradient_incircle, incircle, on_circle, pyramid, star,
};
use super::theorem_1::net;
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::Residual;
use crate::construct::{
    NoDual, circumscribed_f_parallel, circumscribed_v_parallel, delaunay, lift, metric_dual,
    translational_net,
};
use crate::mesh::{Data, FaceId, FaceList, Mesh, NoPlane, VertexId};
use crate::net::i_conical::Balance;
use crate::net::scribed::TouchesSigma;
use crate::pair::Which;
use crate::scalar::{Field, Ordered, Rational, RationalField, Ring, Sign};
use crate::space::{Dual, Gradient, ParabolicSphere, Point, TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "thm-2-dual",
        statement: "The metric dual of an i-conical mesh is i-circular and that of an i-circular mesh \
                    i-conical: the gradients of the faces around an element of M are the top views of \
                    the corners of its dual, and conversely. The dual of the dual is the mesh.",
        formula: "",
        source: Source::Paper("Sec. 3.2, Theorem 2"),
        hypotheses: &[Hypothesis::silent(NOT_VERTICAL), Hypothesis::silent(NOT_COLLINEAR)],
        said: Grade::Decided,
        argument: "A pyramid has an interior vertex of valence 4 and a face of 4 corners, and so has its \
                   dual; duality is local, so the same holds at every vertex and face of any mesh, and \
                   for more corners three and each other one are compared.",
        evidence: &[
            Evidence::identity::<DualPyramid>("a pyramid, twice", &[1], &[1]),
            Evidence::experiment::<DualNet>("nets", &[3, 4]),
        ],
        controls: &[
            Control {
                without: NOT_VERTICAL,
                shows: "the pole of a vertical face is at infinity",
                counterexample: Counterexample::Witness(vertical_face),
            },
            Control {
                without: NOT_COLLINEAR,
                shows: "the dual of a cylinder over a parabola has collinear faces, and no dual",
                counterexample: Counterexample::Witness(cylinder),
            },
        ],
    },
    Claim {
        id: "thm-2-f",
        statement: "An i-conical mesh has a circumscribed mesh with parallel face planes and edges: its \
                    planes are z = p·x - |p|²/2, and those around a vertex meet in one point.",
        formula: "",
        source: Source::Paper("Sec. 3.2, Theorem 2"),
        hypotheses: &[Hypothesis::stated(CONICAL), Hypothesis::silent(NOT_COLLINEAR)],
        said: Grade::Decided,
        argument: "Each vertex is placed by the planes around it alone, and a pyramid has those of any \
                   vertex of valence 4 at its apex. Edges between faces that are not coplanar lie in two \
                   planes, which are parallel to those of M.",
        evidence: &[
            Evidence::identity::<CircumscribedPyramid>("a pyramid", &[1], &[1]),
            Evidence::experiment::<CircumscribedNet>("duals of i-circular nets", &[3]),
        ],
        controls: &[
            Control {
                without: CONICAL,
                shows: "gradients on no circle: the four planes have no common point",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["1", "2", "1", "1", "2", "-2", "1/2", "1", "0"],
                    constrained: &["-1", "-1"],
                },
            },
            Control {
                without: NOT_COLLINEAR,
                shows: "collinear gradients: the planes are parallel to that of a vertical cylinder",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["1", "2", "1", "1", "2", "-2", "5", "1", "0"],
                    constrained: &["-1", "4"],
                },
            },
        ],
    },
    Claim {
        id: "thm-2-v",
        statement: "An i-conical mesh has a circumscribed mesh with the same top view for every point of \
                    contact of one face: the contacts of neighbouring faces are mirror images at their \
                    edge, and around a balanced vertex of valence 4 they close.",
        formula: "",
        source: Source::Paper("Sec. 3.2, Theorem 2"),
        hypotheses: &[
            Hypothesis::stated(BALANCED),
            Hypothesis::silent(EDGES),
            Hypothesis::silent(EVEN),
            Hypothesis::silent(SIMPLY),
        ],
        said: Grade::Decided,
        argument: "This is thm-1-f for the dual mesh: a vertex of valence 2n is cut into vertices of \
                   valence 4 by planes through it, and with all interior vertices closed every cycle of \
                   faces of a simply connected mesh closes.",
        evidence: &[
            Evidence::identity::<MirroredContacts>("the star of a vertex", &[1], &[1]),
            Evidence::experiment::<SameTopView>("duals of i-circular nets", &[3]),
        ],
        controls: &[
            Control {
                without: BALANCED,
                shows: "a star of four triangles that is not i-conical",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &[
                        "0", "0", "0", "1", "0", "0", "1", "-1", "0", "1", "0", "0", "0", "0", "1",
                        "2",
                    ],
                    constrained: &["-1", "-1"],
                },
            },
            Control {
                without: EDGES,
                shows: "an edge over a point is no mirror",
                counterexample: Counterexample::Witness(edge_over_point),
            },
            Control {
                without: EVEN,
                shows: "three reflections at lines through a point are no identity",
                counterexample: Counterexample::Witness(odd_star),
            },
            Control {
                without: SIMPLY,
                shows: "a flat ring of three quads, without an interior vertex",
                counterexample: Counterexample::Witness(ring_of_three),
            },
        ],
    },
    Claim {
        id: "thm-2-voronoi",
        statement: "Each vertex of the top view of an i-conical mesh is the centre of a circle through the \
                    contacts of the faces around it with Σ, in a circumscribed v-parallel mesh S₁, and \
                    each edge the radical axis of its two faces' contacts, its mirror. Where S₁ is \
                    convex these circles have no contact inside: the top view is a Voronoi diagram.",
        formula: "",
        source: Source::Paper("Sec. 3.2, Theorem 2"),
        hypotheses: &[Hypothesis::silent(CONVEX)],
        said: Grade::Instances,
        argument: "",
        evidence: &[
            Evidence::experiment::<ContactCircles>("centres of circles", &[3]),
            Evidence::experiment::<EmptyCircles>("empty circles", &[4, 6, 9]),
        ],
        controls: &[Control {
            without: CONVEX,
            shows: "contacts on a grid with one row folded back",
            counterexample: Counterexample::Witness(folded_grid),
        }],
    },
];

const NOT_VERTICAL: &str = "no face of M is vertical";
const NOT_COLLINEAR: &str = "around every vertex are three gradients that are not collinear";
const CONICAL: &str = "the gradients around every vertex are concyclic";
const BALANCED: &str = "every interior vertex is balanced, (14) modulo π";
const EDGES: &str = "no edge is isotropic";
const EVEN: &str = "interior vertices have even valence";
const SIMPLY: &str = "M is simply connected";
const CONVEX: &str = "S₁ is convex";

/// Gradients of the sides of a pyramid: any, or concyclic ones.
fn sides<T: Field>(
    trial: &mut Trial<T>,
    hypothesis: Option<&'static str>,
) -> Result<[Gradient<T>; 4], Stop> {
    let [a, b, c] = [(); 3].map(|()| free_top_view(trial));
    trial.nonzero(NOT_COLLINEAR, &(&b - &a).det(&(&c - &a)))?;
    let d = match hypothesis {
        Some(hypothesis) => on_circle(trial, hypothesis, [&a, &b, &c])?,
        None => free_top_view(trial),
    };
    for [x, y, z] in [[&a, &b, &d], [&b, &c, &d], [&c, &a, &d]] {
        trial.nonzero(NOT_COLLINEAR, &(y - x).det(&(z - x)))?;
    }
    let xs = [&a.x, &b.x, &c.x, &d.x, &T::zero()];
    all_different(trial, "the gradients differ in x", &xs)?;
    Ok([a, b, c, d].map(|x| x.dual()))
}

/// The gradients of all faces, where every face has one.
fn gradients<T: Field>(mesh: &Mesh<T>, hypothesis: &'static str) -> Result<Vec<Gradient<T>>, Stop> {
    let plane = |face| match mesh.face_plane(face) {
        Ok(plane) => Ok(plane.gradient),
        Err(NoPlane::NotAGraph(_)) => Err(Stop::Excluded(hypothesis)),
        Err(error) => Err(Stop::Failed(format!("{error:?}").into())),
    };
    mesh.topology.faces().map(plane).collect()
}

/// The numbers of the faces around a vertex.
fn around<T>(mesh: &Mesh<T>, v: VertexId) -> Vec<usize> {
    mesh.topology.star(v).map(|h| mesh.topology.face_at(h).index()).collect()
}

struct DualPyramid;

impl Identity for DualPyramid {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (height, p) = (trial.free(), sides(trial, None)?);
        let m = pyramid(trial, &height, &p)?;
        trial.nonzero(NOT_VERTICAL, &height)?;
        let dual = trial.accepted("the dual", metric_dual(&m))?;
        let dual = trial.made_mesh(dual);
        let own = gradients(&m, NOT_VERTICAL)?;
        let other = gradients(&dual, NOT_COLLINEAR)?;
        for (p, pole) in own.iter().zip(&dual.points) {
            trial.equal("top view of a pole", &p.x, &pole.x);
            trial.equal("top view of a pole", &p.y, &pole.y);
        }
        for (x, p) in m.points.iter().zip(&other) {
            trial.equal("gradient of a dual face", &x.x, &p.x);
            trial.equal("gradient of a dual face", &x.y, &p.y);
        }
        // The apex and its dual face; the base and its dual vertex.
        let [a, b, c, d] = [0, 1, 2, 3].map(|j| dual.points[j].top_view());
        let circle = incircle([&a, &b, &c, &d]);
        trial.equal("dual face", &circle, &gradient_incircle([&own[0], &own[1], &own[2], &own[3]]));
        let [a, b, c, d] = [1, 2, 3, 4].map(|j| m.points[j].top_view());
        let circle = incircle([&a, &b, &c, &d]);
        let conical = gradient_incircle([&other[1], &other[2], &other[3], &other[4]]);
        trial.equal("dual vertex", &circle, &conical);
        let twice = trial.accepted("the dual of the dual", metric_dual(&dual))?;
        for (x, y) in m.points.iter().zip(&twice.points) {
            trial.equal_points("the dual of the dual", x, y);
        }
        trial.exhibit("M", &m);
        trial.exhibit("M*", &dual);
        Ok(())
    }
}

/// The dual of an i-circular net, with the gradients of its faces.
fn dual_net<T: RationalField>(
    trial: &mut Trial<T>,
    hypothesis: &'static str,
) -> Result<(Mesh<T>, Vec<Gradient<T>>), Stop> {
    let m = net(trial)?;
    let dual = match metric_dual(&m) {
        Err(NoDual::NoPole(_)) => return Err(Stop::Excluded(CORNERS)),
        dual => trial.accepted("the dual", dual)?,
    };
    let gradients = gradients(&dual, hypothesis)?;
    Ok((dual, gradients))
}

struct DualNet;

impl Experiment for DualNet {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (dual, p) = dual_net(trial, NOT_COLLINEAR)?;
        for v in dual.topology.interior_vertices() {
            let p: Vec<_> = around(&dual, v).into_iter().map(|f| &p[f]).collect();
            if let [a, b, c, d] = p.as_slice() {
                trial.zero("i-conical", gradient_incircle([a, b, c, d]));
            }
            let ends: Vec<_> = dual.topology.star(v).map(|h| dual.topology.target(h)).collect();
            if let [a, b, c, d] = ends.as_slice() {
                let at = [v, *a, *b, *c, *d].map(|v| dual.points[v.index()].clone());
                trial.zero("balanced", Balance.eval(&at, &T::one()));
            }
        }
        trial.exhibit("M*", &dual);
        Ok(())
    }
}

fn mesh_of(points: &[[i64; 3]], faces: &[&[u32]]) -> Result<Mesh<Rational>, String> {
    let mut list = FaceList::new();
    faces.iter().for_each(|face| list.push(face.iter().copied()));
    let q = Rational::from_i64;
    let points = points.iter().map(|&[x, y, z]| Point::new(q(x), q(y), q(z))).collect();
    Mesh::new(points, list).map_err(|error| error.to_string())
}

fn vertical_face() -> Result<String, String> {
    let m = mesh_of(&[[0, 0, 0], [1, 1, 0], [1, 1, 1], [0, 0, 1]], &[&[0, 1, 2, 3]])?;
    metric_dual(&m).map_or_else(|error| Ok(error.to_string()), |_| Err("it has a dual".into()))
}

fn cylinder() -> Result<String, String> {
    let q = Rational::from_i64;
    let curve: Vec<_> = (0..5).map(|i| (q(i), q(i * i))).collect();
    let line: Vec<_> = (0..5).map(|i| (q(i), q(i))).collect();
    let m = translational_net(&curve, &line).map_err(|error| error.to_string())?;
    let dual = metric_dual(&m).map_err(|error| error.to_string())?;
    metric_dual(&dual).map_or_else(|error| Ok(error.to_string()), |_| Err("it has a dual".into()))
}

struct CircumscribedPyramid;

impl Identity for CircumscribedPyramid {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (height, p) = (trial.free(), sides(trial, Some(CONICAL))?);
        let m = pyramid(trial, &height, &p)?;
        let image = trial.accepted("circumscribed and f-parallel", circumscribed_f_parallel(&m))?;
        trial.accepted("with parallel edges", image.pair.parallel())?;
        trial.zero("nothing is free", T::from_i64(image.free.len() as i64));
        let s = trial.made_mesh(image.pair.image().clone());
        for face in m.topology.faces() {
            let plane = ParabolicSphere::unit().tangent_plane(&image.pair.gradient(face).dual());
            for v in m.topology.face(face) {
                trial.zero("in the plane that touches Σ", plane.residual(&s.points[v.index()]));
            }
        }
        trial.exhibit("M", &m);
        trial.exhibit("S", &s);
        Ok(())
    }
}

struct CircumscribedNet;

impl Experiment for CircumscribedNet {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (m, _) = dual_net(trial, NOT_COLLINEAR)?;
        let image = match circumscribed_f_parallel(&m) {
            Err(error) if error.is_undefined() => return Err(Stop::Excluded(NOT_COLLINEAR)),
            image => trial.accepted("circumscribed and f-parallel", image)?,
        };
        let s = image.pair.image();
        for face in m.topology.faces() {
            let plane = ParabolicSphere::unit().tangent_plane(&image.pair.gradient(face).dual());
            for v in m.topology.face(face) {
                trial.zero("in the plane that touches Σ", plane.residual(&s.points[v.index()]));
            }
        }
        trial.exhibit("M", &m);
        Ok(())
    }
}

struct MirroredContacts;

impl Identity for MirroredContacts {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let v = trial.free_point();
        let [a, b, c] = [(); 3].map(|()| trial.free_vector2());
        let length = trial.free();
        // The argument of -a c / b.
        let product = Vector2::new(&a.x * &c.x - &a.y * &c.y, &a.x * &c.y + &a.y * &c.x);
        let fourth = Vector2::new(b.dot(&product), b.det(&product)).scaled(&-length);
        let d = trial.constrained_vector2(fourth);
        let e = [a, b, c, d];
        let heights = [(); 4].map(|()| trial.free());
        let start = free_top_view(trial);
        let mut at = vec![v.clone()];
        at.extend(e.iter().zip(heights).map(|(e, z)| (&v.top_view() + e).at_height(z)));
        let corners = std::array::from_fn(|i| at[i].clone());
        trial.relation(BALANCED, Balance.eval(&corners, &T::one()))?;
        for (j, one) in e.iter().enumerate() {
            trial.nonzero(EDGES, &one.length2())?;
            trial.parameter(CORNERS, &one.det(&e[(j + 1) % 4]))?;
        }
        let m = star(trial, at)?;
        let pair = circumscribed_v_parallel(&m, FaceId(0), &start);
        let pair = trial.accepted("circumscribed and v-parallel", pair)?;
        let contact = pair.gradient(Which::Image, FaceId(0)).dual();
        trial.equal("the first contact", &contact.x, &start.x);
        trial.equal("the first contact", &contact.y, &start.y);
        let s = trial.made_mesh(pair.image().clone());
        for face in s.topology.faces() {
            let corners = s.topology.face(face);
            let at = std::array::from_fn(|i| s.points[corners[i].index()].clone());
            trial.zero("touches Σ", TouchesSigma.eval(&at, &T::one()));
        }
        for (p, q) in m.points.iter().zip(&s.points) {
            trial.equal("the same top view", &p.x, &q.x);
            trial.equal("the same top view", &p.y, &q.y);
        }
        trial.exhibit("M", &m);
        trial.exhibit("S", &s);
        Ok(())
    }
}

/// The dual of an i-circular net with a circumscribed mesh of the same top view, and the contacts.
fn contacts<T: RationalField>(trial: &mut Trial<T>) -> Result<(Mesh<T>, Vec<TopView<T>>), Stop> {
    let (m, _) = dual_net(trial, CORNERS)?;
    let start = free_top_view(trial);
    for h in m.topology.edges() {
        let [v, w] = [m.topology.origin(h), m.topology.target(h)].map(VertexId::index);
        trial.parameter(EDGES, &m.points[v].i_distance2(&m.points[w]))?;
    }
    let pair = circumscribed_v_parallel(&m, FaceId(0), &start);
    let pair = trial.accepted("circumscribed and v-parallel", pair)?;
    let contacts = m.topology.faces().map(|f| pair.gradient(Which::Image, f).dual()).collect();
    let s = pair.into_image();
    Ok((s, contacts))
}

struct SameTopView;

impl Experiment for SameTopView {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (s, contacts) = contacts(trial)?;
        for (face, contact) in s.topology.faces().zip(&contacts) {
            let plane = ParabolicSphere::unit().tangent_plane(contact);
            for v in s.topology.face(face) {
                trial.zero("in the plane that touches Σ", plane.residual(&s.points[v.index()]));
            }
        }
        trial.exhibit("S", &s);
        Ok(())
    }
}

struct ContactCircles;

impl Experiment for ContactCircles {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (s, contacts) = contacts(trial)?;
        for v in s.topology.interior_vertices() {
            let (at, faces) = (s.points[v.index()].top_view(), around(&s, v));
            for f in &faces {
                let distance2 = at.distance2(&contacts[*f]);
                trial.equal("a circle", &distance2, &at.distance2(&contacts[faces[0]]));
            }
        }
        for h in s.topology.edges() {
            let Some(twin) = s.topology.twin(h) else { continue };
            let [f, g] = [h, twin].map(|h| &contacts[s.topology.face_at(h).index()]);
            for v in [s.topology.origin(h), s.topology.target(h)] {
                let at = s.points[v.index()].top_view();
                trial.equal("radical axis", &at.distance2(f), &at.distance2(g));
            }
        }
        trial.exhibit("S", &s);
        Ok(())
    }
}

struct EmptyCircles;

impl Experiment for EmptyCircles {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        // The lift of a Delaunay triangulation is convex, and so is its dual.
        let sites: Vec<Point<T>> = (0..trial.size()).map(|_| trial.free_point()).collect();
        let exact = |c: &T| Rational::from_fraction(c.numerator(), c.denominator());
        let copy = sites.iter().map(|p| p.map(|c| exact(c).unwrap_or_else(Rational::zero)));
        let Ok(mesh) = delaunay(copy.collect()) else { return Err(Stop::Excluded(CORNERS)) };
        let lifted = lift(&Mesh { topology: mesh.topology, points: sites, data: Data::default() });
        for face in lifted.topology.faces() {
            let plane = trial.accepted("a plane", lifted.face_plane(face))?;
            let section = ParabolicSphere::unit().section(&plane).top_view;
            let centre = plane.dual().top_view();
            trial.equal("the centre", &section.centre.distance2(&centre), &T::zero());
            for p in &lifted.points {
                let inside = section.power(&p.top_view()).certain_sign() == Some(Sign::Negative);
                trial.zero("a contact inside", T::from_i64(i64::from(inside)));
            }
        }
        Ok(())
    }
}

fn folded_grid() -> Result<String, String> {
    let q = Rational::from_i64;
    let profile = [0, 2, 1, 3].map(|x| (q(x), q(0)));
    let m = translational_net(&profile, &[(q(0), q(0)), (q(1), q(0))]);
    let lifted = lift(&m.map_err(|error| error.to_string())?);
    let plane = lifted.face_plane(FaceId(0)).map_err(|error| error.to_string())?;
    let circle = ParabolicSphere::unit().section(&plane).top_view;
    let power = circle.power(&lifted.points[4].top_view());
    match power.certain_sign() {
        Some(Sign::Negative) => Ok(format!("power of a contact: {power}")),
        _ => Err("the circle is empty".into()),
    }
}

/// Why a mesh has no circumscribed v-parallel one with the first contact (1, 2).
fn refusal(m: &Mesh<Rational>) -> Result<String, String> {
    let start = TopView::new(Rational::from_i64(1), Rational::from_i64(2));
    let pair = circumscribed_v_parallel(m, FaceId(0), &start);
    pair.map_or_else(|error| Ok(error.to_string()), |_| Err("there is one".into()))
}

fn edge_over_point() -> Result<String, String> {
    let points = [[0, 0, 0], [0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]];
    refusal(&mesh_of(&points, &[&[0, 1, 2, 3], &[1, 0, 4, 5]])?)
}

fn odd_star() -> Result<String, String> {
    let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, -1, 0]];
    refusal(&mesh_of(&points, &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1]])?)
}

fn ring_of_three() -> Result<String, String> {
    let points = [[1, 0, 0], [-1, 1, 0], [-1, -2, 0], [3, 0, 0], [-3, 3, 0], [-3, -6, 0]];
    refusal(&mesh_of(&points, &[&[0, 3, 4, 1], &[1, 4, 5, 2], &[2, 5, 3, 0]])?)
}
