//! Sec. 3.2, Theorem 2: the contacts of circumscribed meshes with the same top view.

use super::i_conical::{around, dual_net};
use super::instance::{CORNERS, free_top_view, mesh_of, star};
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::Residual;
use crate::construct::{circumscribed_v_parallel, delaunay, lift, translational_net};
use crate::mesh::{Data, FaceId, Mesh, VertexId};
use crate::net::i_conical::Balance;
use crate::net::scribed::TouchesSigma;
use crate::pair::Which;
use crate::scalar::{Field, Ordered, Rational, RationalField, Ring, Sign};
use crate::space::{Dual, ParabolicSphere, Point, TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[
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
        said: Grade::Certified,
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

const BALANCED: &str = "every interior vertex is balanced, (14) modulo π";
const EDGES: &str = "no edge is isotropic";
const EVEN: &str = "interior vertices have even valence";
const SIMPLY: &str = "M is simply connected";
const CONVEX: &str = "S₁ is convex";

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
