//! Images of i-isothermic meshes under i-M-transformations, by their incircles (Remarks 2 and 4).
//!
//! Such a mesh has vertex circles that touch, and incircles of faces that are orthogonal to them. The
//! planes of the inverted incircles meet again in points over the centres of the inverted vertex
//! circles: they are the incircles of another i-isothermic mesh. If the mesh is i-minimal, the image
//! discretises a biharmonic function; under τ it is an L-minimal edge-offset mesh.

use std::fmt;

use super::koebe::{poles, section, vertex_circles};
use crate::mesh::{FaceId, Mesh, NoPlane, VertexId};
use crate::scalar::Field;
use crate::space::{Circle, Gradient, ICircle, MoebiusTransformation, OrientedCircle, Plane};

/// Why the incircles of a mesh have no image that is a mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum NoIncircleImage<T> {
    /// Not one radius for every vertex.
    NoRadii,
    /// A transformation with a factor `k ≠ 1`, whose root the radii would take.
    NotAnIsometry,
    /// A face without a plane, or with an isotropic one.
    Plane(NoPlane<T>),
    /// A face whose vertex circles have no common orthogonal circle.
    NoCircle {
        /// The face.
        face: FaceId,
        /// How far the pole of a circle lies above the plane of three others, exactly.
        residual: T,
    },
    /// Two neighbouring vertex circles that do not touch.
    NotTouching {
        /// The ends of the edge.
        edge: [VertexId; 2],
        /// `|x_i − x_j|² − (r_i + r_j)²` for the images in the top view, exactly.
        residual: T,
    },
    /// The plane of an inverted incircle passes the vertex by.
    NotConcurrent {
        /// The face.
        face: FaceId,
        /// The vertex.
        vertex: VertexId,
        /// How far the vertex lies above the plane, exactly.
        residual: T,
    },
    /// A vertex whose circle passes through the centre.
    Vertex(VertexId),
    /// A face whose incircle passes through the centre.
    Face(FaceId),
}

impl<T> NoIncircleImage<T> {
    /// The same with `f` applied to every number, to show them in another form.
    pub fn map<S>(&self, f: impl Fn(&T) -> S) -> NoIncircleImage<S> {
        match self {
            NoIncircleImage::NoRadii => NoIncircleImage::NoRadii,
            NoIncircleImage::NotAnIsometry => NoIncircleImage::NotAnIsometry,
            NoIncircleImage::Plane(reason) => NoIncircleImage::Plane(reason.map(f)),
            NoIncircleImage::NoCircle { face, residual } => {
                NoIncircleImage::NoCircle { face: *face, residual: f(residual) }
            }
            NoIncircleImage::NotTouching { edge, residual } => {
                NoIncircleImage::NotTouching { edge: *edge, residual: f(residual) }
            }
            NoIncircleImage::NotConcurrent { face, vertex, residual } => {
                let residual = f(residual);
                NoIncircleImage::NotConcurrent { face: *face, vertex: *vertex, residual }
            }
            NoIncircleImage::Vertex(v) => NoIncircleImage::Vertex(*v),
            NoIncircleImage::Face(face) => NoIncircleImage::Face(*face),
        }
    }
}

impl<T: fmt::Display> fmt::Display for NoIncircleImage<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoIncircleImage::NoRadii => write!(f, "there is not one radius for every vertex"),
            NoIncircleImage::NotAnIsometry => {
                write!(f, "the transformation scales radii by a factor that is known squared only")
            }
            NoIncircleImage::Plane(reason) => reason.fmt(f),
            NoIncircleImage::NoCircle { face, residual } => write!(
                f,
                "the vertex circles of face {} have no common orthogonal circle: residual {residual}",
                face.0
            ),
            NoIncircleImage::NotTouching { edge: [v, w], residual } => write!(
                f,
                "the circles of vertices {} and {} do not touch: residual {residual}",
                v.0, w.0
            ),
            NoIncircleImage::NotConcurrent { face, vertex, residual } => write!(
                f,
                "the image of vertex {} lies {residual} above the plane of face {}",
                vertex.0, face.0
            ),
            NoIncircleImage::Vertex(v) => {
                write!(f, "the circle of vertex {} passes through the centre", v.0)
            }
            NoIncircleImage::Face(face) => {
                write!(f, "the incircle of face {} passes through the centre", face.0)
            }
        }
    }
}

impl<T: fmt::Debug + fmt::Display> std::error::Error for NoIncircleImage<T> {}

impl<T> From<NoPlane<T>> for NoIncircleImage<T> {
    fn from(reason: NoPlane<T>) -> Self {
        NoIncircleImage::Plane(reason)
    }
}

/// The i-isothermic mesh whose incircles are the images of those of an i-isothermic mesh, with the
/// signed radii of its vertex circles as data.
///
/// The inversion at the unit cylinder sends a vertex v with the radius r to `v/n` with the radius `r/n`,
/// `n = |v'|² − r²`: see [`MoebiusTransformation::map_centred`]. It is not the
/// [image of the vertices](super::moebius_image()). That circles touch and that planes meet at the vertices is
/// asked of the result; whether the surface is i-minimal does not matter for that.
///
/// ```
/// use isogeo::construct::{incircle_image, minimal::saddle};
/// use isogeo::scalar::{Field, Rational, Ring};
/// use isogeo::space::{Circle, CylindricalSphere, MoebiusTransformation, TopView};
/// let mesh = saddle::<Rational>(1, 1)?.surface;
/// let centre = TopView::new(Rational::from_ratio(-1, 1), Rational::zero());
/// let unit = CylindricalSphere::new(Circle::new(centre, Rational::one()))?;
/// let map = MoebiusTransformation::inversion_at_cylinder(&unit, &Rational::zero());
/// let radii = &incircle_image(&mesh, &map)?.data.vertex["radius"];
/// assert_eq!(radii[0], Rational::from_ratio(2, 3)); // r = 1/2, n = 3/4
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// See [`NoIncircleImage`]. In `f64` circles are never found to touch.
pub fn incircle_image<T: Field>(
    mesh: &Mesh<T>,
    map: &MoebiusTransformation<T>,
) -> Result<Mesh<T>, NoIncircleImage<T>> {
    let heights: Vec<T> = mesh.points.iter().map(|p| p.z.clone()).collect();
    let images = images(mesh, &heights, map)?;
    let points: Vec<_> = images.iter().map(|(c, z)| c.centre.at_height(z.clone())).collect();
    for (face, top_view) in mesh.topology.faces().zip(incircles(mesh)?) {
        let circle = ICircle { plane: mesh.face_plane(face)?, top_view };
        let plane = map.map_circle(&circle).map_err(|_| NoIncircleImage::Face(face))?.plane;
        for &vertex in mesh.topology.face(face) {
            let point = &points[vertex.index()];
            let residual = &point.z - plane.point_at(&point.top_view()).z;
            if !residual.is_zero() {
                return Err(NoIncircleImage::NotConcurrent { face, vertex, residual });
            }
        }
    }
    let circles = images.into_iter().map(|(circle, _)| circle).collect();
    Ok(Mesh { points, ..poles(mesh.topology.clone(), circles) })
}

/// The Koebe mesh over the images of the vertex circles, with their signed radii.
///
/// Its edges touch Σ, as those of the Koebe mesh over the circles themselves do; the heights of the
/// given mesh do not enter. So any i-isothermic mesh with radii has its Koebe mesh, with the identity,
/// and all Möbius images of that. Circles of faces are images, too.
///
/// # Errors
/// See [`NoIncircleImage`]. In `f64` circles are never found to touch.
pub fn koebe_image<T: Field>(
    mesh: &Mesh<T>,
    map: &MoebiusTransformation<T>,
) -> Result<Mesh<T>, NoIncircleImage<T>> {
    let images = images(mesh, &vec![T::zero(); mesh.points.len()], map)?;
    let level = Plane::new(Gradient::new(T::zero(), T::zero()), T::zero());
    for (face, top_view) in mesh.topology.faces().zip(incircles(mesh)?) {
        let circle = ICircle { plane: level.clone(), top_view };
        map.map_circle(&circle).map_err(|_| NoIncircleImage::Face(face))?;
    }
    let circles = images.into_iter().map(|(circle, _)| circle).collect();
    Ok(poles(mesh.topology.clone(), circles))
}

/// The images of the vertex circles with points at heights over their centres, if they touch.
fn images<T: Field>(
    mesh: &Mesh<T>,
    heights: &[T],
    map: &MoebiusTransformation<T>,
) -> Result<Vec<(OrientedCircle<T>, T)>, NoIncircleImage<T>> {
    if *map.factor() != T::one() {
        return Err(NoIncircleImage::NotAnIsometry);
    }
    let circles = vertex_circles(mesh).ok_or(NoIncircleImage::NoRadii)?;
    let image = |(v, (circle, height)): (usize, (&OrientedCircle<T>, &T))| {
        map.map_centred(circle, height).map_err(|_| NoIncircleImage::Vertex(VertexId(v as u32)))
    };
    let images =
        circles.iter().zip(heights).enumerate().map(image).collect::<Result<Vec<_>, _>>()?;
    for h in mesh.topology.edges() {
        let edge = [mesh.topology.origin(h), mesh.topology.target(h)];
        let [a, b] = edge.map(|v| &images[v.index()].0);
        let residual = a.tangency(b);
        if !residual.is_zero() {
            return Err(NoIncircleImage::NotTouching { edge, residual });
        }
    }
    Ok(images)
}

/// The circles of the top view that are orthogonal to the vertex circles of a face, for all faces.
fn incircles<T: Field>(mesh: &Mesh<T>) -> Result<Vec<Circle<T>>, NoIncircleImage<T>> {
    let circles = vertex_circles(mesh).ok_or(NoIncircleImage::NoRadii)?;
    let koebe = poles(mesh.topology.clone(), circles);
    let circle = |face: FaceId| match koebe.face_plane(face) {
        Ok(plane) => Ok(section(plane)),
        Err(NoPlane::NotPlanar { face, residual }) => {
            Err(NoIncircleImage::NoCircle { face, residual })
        }
        Err(reason) => Err(reason.into()),
    };
    mesh.topology.faces().map(circle).collect()
}
