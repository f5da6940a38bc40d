//! Offsets at constant distance of vertices: circular meshes.

use crate::claim::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Trial,
};

use super::{
    STRAIGHT, concyclic, free_top_view, from_origin, horizontal, polygon, rational_polygon,
    triangles,
};
use crate::check::Residual;
use crate::construct::inscribed_f_parallel;
use crate::mesh::{FaceList, Mesh, VertexId};
use crate::net::i_circular::Concyclic;
use crate::pair::Parallel;
use crate::scalar::{Field, Rational, Ring};
use crate::space::{Point, TopView};

pub(in crate::claim) const CLAIMS: &[Claim] = &[Claim {
    id: "offset-vertex",
    statement: "The vertices of M + dS have the distance d from those of M iff S is inscribed to \
                    the unit sphere. Such an S exists, for every start, iff the faces of M have \
                    circumcircles.",
    formula: "|m_i' − m_i|² = d² |s_i|²",
    source: Source::Paper("Sec. 3.1, meshes with offsets (i)"),
    hypotheses: &[
        Hypothesis::stated(QUADS),
        Hypothesis::stated(EDGES),
        Hypothesis::silent(SIMPLY_CONNECTED),
    ],
    said: Grade::Certified,
    argument: "Faces span planes. A face of S lies in one, which cuts the sphere in a circle; turned so that the \
                   plane is horizontal, it is a circle around the gradient of the face, as for Σ. From \
                   a point of the circle the direction of an edge leads to one other; which one \
                   depends on the edge alone, so in a simply connected mesh nothing is asked but that \
                   faces close.",
    evidence: &[
        Evidence::identity::<VertexDistance>("distances of vertices", &[1], &[1]),
        Evidence::identity::<Circular>("faces parallel to a concyclic quad", &[1], &[1]),
        Evidence::identity::<Closing>("circular faces close", &[1], &[1]),
    ],
    controls: &[
        Control {
            without: QUADS,
            shows: "every triangle has a circumcircle, and does not close",
            counterexample: Counterexample::Witness(triangle_opens),
        },
        Control {
            without: EDGES,
            shows: "one point of the sphere is inscribed and parallel to a kite",
            counterexample: Counterexample::Witness(one_point),
        },
        Control {
            without: SIMPLY_CONNECTED,
            shows: "three trapezoids between two triangles do not close around the hole",
            counterexample: Counterexample::Witness(annulus_opens),
        },
    ],
}];

const QUADS: &str = "faces are quads";

const EDGES: &str = "no edge of S has length 0";

const SIMPLY_CONNECTED: &str = "M is simply connected";

struct VertexDistance;

impl Identity for VertexDistance {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let ([m, s, offset], d) = triangles(trial)?;
        for ((p, q), s) in m.points.iter().zip(&offset.points).zip(&s.points) {
            let expected = d.square() * from_origin(s).length2();
            trial.equal("distance", &(q - p).length2(), &expected);
        }
        Ok(())
    }
}

struct Circular;

impl Identity for Circular {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let s = concyclic(trial)?;
        let edges: [_; 4] = std::array::from_fn(|i| &s[(i + 1) % 4] - &s[i]);
        // Two factors are free, two are such that the quad closes.
        let start = TopView::new(T::zero(), T::zero());
        let first = &start + &edges[0].scaled(&trial.free());
        let second = &first + &edges[1].scaled(&trial.free());
        let straight = edges[2].det(&edges[3]);
        trial.parameter(STRAIGHT, &straight)?;
        let factor = -second.position().det(&edges[3]);
        let factor = trial.accepted("straight", factor.try_div(&straight).ok_or(()))?;
        let last = &second + &edges[2].scaled(&factor);
        let f = [start, first, second, last].each_ref().map(horizontal);
        let (m, s) = (polygon(f.to_vec()), polygon(s.each_ref().map(horizontal).to_vec()));
        let (m, s) = (trial.accepted("no mesh", m)?, trial.accepted("no mesh", s)?);
        trial.accepted("not parallel", Parallel::new(&m, &s).map(|_| ()))?;
        trial.exhibit("F", &m);
        trial.zero("concyclic", Concyclic.eval(&f, &T::one()));
        Ok(())
    }
}

struct Closing;

impl Identity for Closing {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let corners = concyclic(trial)?;
        let start = free_top_view(trial);
        for i in 0..4 {
            let edge = &corners[(i + 1) % 4] - &corners[i];
            trial.parameter("edges have a length", &edge.length2())?;
        }
        let straight = (&corners[1] - &corners[0]).det(&(&corners[2] - &corners[0]));
        trial.parameter(STRAIGHT, &straight)?;
        let mesh = polygon(corners.each_ref().map(horizontal).to_vec());
        let mesh = trial.accepted("no mesh", mesh)?;
        trial.exhibit("F", &mesh);
        let pair = inscribed_f_parallel(&mesh, VertexId(0), &start);
        let pair = trial.accepted("it does not close", pair)?;
        for s in &pair.image().points {
            trial.equal("a circle around the gradient", &s.top_view().norm2(), &start.norm2());
        }
        let edge = &pair.image().points[0] - &pair.image().points[3];
        let along = &mesh.points[0] - &mesh.points[3];
        trial.zero("the last edge", edge.top_view().det(&along.top_view()));
        Ok(())
    }
}

fn triangle_opens() -> Result<String, String> {
    let mesh = rational_polygon(&[[0, 0], [2, 0], [0, 2]])?;
    let start = TopView::new(Rational::from_i64(1), Rational::from_i64(3));
    match inscribed_f_parallel(&mesh, VertexId(0), &start) {
        Ok(_) => Err("it closes".into()),
        Err(error) => Ok(error.to_string()),
    }
}

/// Trapezoids between a triangle inscribed to a circle and the same of half the size: an odd number
/// of reflections, which move whatever is not on their common axis.
fn annulus_opens() -> Result<String, String> {
    let corners = [[5, 0], [-3, 4], [-3, -4]];
    let place = |[x, y]: [i64; 2], size: i64| {
        let [x, y] = [x, y].map(|c| Rational::from_i64(size * c));
        horizontal(&TopView::new(x, y))
    };
    let points: Vec<_> = [2, 1].iter().flat_map(|&k| corners.map(|p| place(p, k))).collect();
    let mut faces = FaceList::new();
    for [i, j] in [[0, 1], [1, 2], [2, 0]] {
        faces.push([i, j, j + 3, i + 3]);
        let [a, b, c, d] = [i, j, j + 3, i + 3].map(|v| points[v as usize].clone());
        if !Concyclic.eval(&[a, b, c, d], &Rational::one()).is_zero() {
            return Err("a face without a circumcircle".into());
        }
    }
    let mesh = Mesh::new(points, faces).map_err(|e| e.to_string())?;
    let start = TopView::new(Rational::from_i64(1), Rational::from_i64(3));
    match inscribed_f_parallel(&mesh, VertexId(0), &start) {
        Ok(_) => Err("it closes".into()),
        Err(error) => Ok(error.to_string()),
    }
}

fn one_point() -> Result<String, String> {
    let kite = rational_polygon(&[[0, 0], [1, -1], [3, 0], [1, 1]])?;
    let s = polygon(vec![horizontal(&TopView::new(Rational::one(), Rational::zero())); 4])?;
    Parallel::new(&kite, &s).map_err(|e| e.to_string())?;
    let on_sphere = s.points.iter().all(|p| from_origin(p).length2() == Rational::one());
    let [a, b, c, d] = kite.points.as_slice() else { return Err("no quad".into()) };
    let residual = Concyclic.eval(&[a, b, c, d].map(Point::clone), &Rational::one());
    if !on_sphere || residual.is_zero() {
        return Err("the kite is circular".into());
    }
    Ok(format!("concyclic: {residual}"))
}
