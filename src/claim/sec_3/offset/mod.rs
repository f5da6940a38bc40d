//! Sec. 3.1: offsets of meshes in Euclidean space.

use super::{Stop, Trial};
use crate::check::Residual;
use crate::construct::circular_net;
use crate::mesh::{FaceList, Mesh};
use crate::net::i_circular::Concyclic;
use crate::pair::Parallel;
use crate::scalar::{Field, Rational, Ring};
use crate::space::{Point, TopView, Vector3};

pub(super) mod edge;
pub(super) mod face;
pub(super) mod vertex;

const STRAIGHT: &str = "a corner of the face is not straight, as on a circle";

fn polygon<T: Ring>(corners: Vec<Point<T>>) -> Result<Mesh<T>, String> {
    let mut faces = FaceList::new();
    faces.push(0..corners.len() as u32);
    Mesh::new(corners, faces).map_err(|e| e.to_string())
}

fn horizontal<T: Ring>(at: &TopView<T>) -> Point<T> {
    at.at_height(T::zero())
}

fn free_top_view<T: Field>(trial: &mut Trial<T>) -> TopView<T> {
    TopView::new(trial.free(), trial.free())
}

/// A triangle, its image in a parallel one, and the offset.
fn triangles<T: Field>(trial: &mut Trial<T>) -> Result<([Mesh<T>; 3], T), Stop> {
    let corners = vec![trial.free_point(), trial.free_point(), trial.free_point()];
    let (scale, at) = (trial.free(), trial.free_point());
    let image = |p: &Point<T>| &at + &Vector3::new(&scale * &p.x, &scale * &p.y, &scale * &p.z);
    let s = polygon(corners.iter().map(image).collect());
    let (m, s) = (trial.accepted("no mesh", polygon(corners))?, trial.accepted("no mesh", s)?);
    let d = trial.free();
    let offset = trial.accepted("not parallel", Parallel::new(&m, &s))?.offset(&d);
    let offset = trial.made_mesh(offset);
    Ok(([m, s, offset], d))
}

fn from_origin<T: Ring>(p: &Point<T>) -> Vector3<T> {
    Vector3::new(p.x.clone(), p.y.clone(), p.z.clone())
}

/// Four concyclic top views: three are free, the last is on their circle.
fn concyclic<T: Field>(trial: &mut Trial<T>) -> Result<[TopView<T>; 4], Stop> {
    let [a, b, c] = [(); 3].map(|()| free_top_view(trial));
    let ratio = trial.free();
    let sides = [[&a, &b], [&a, &c]].map(|side| side.map(horizontal));
    let net = circular_net(&sides[0], &sides[1], |_, _| ratio.clone());
    let net = net.ok_or(Stop::Excluded("three corners span a circle"))?;
    let net = trial.accepted("no mesh", net)?;
    let d = net.points.last().map(Point::top_view);
    let d = trial.accepted("no fourth corner", d.ok_or(()))?;
    let d = TopView::new(trial.constrained(d.x), trial.constrained(d.y));
    let corners = [a, b, d, c];
    let residual = Concyclic.eval(&corners.each_ref().map(horizontal), &T::one());
    trial.relation("four corners are concyclic", residual)?;
    Ok(corners)
}

fn rational_polygon(corners: &[[i64; 2]]) -> Result<Mesh<Rational>, String> {
    let at = |&[x, y]: &[i64; 2]| {
        horizontal(&TopView::new(Rational::from_i64(x), Rational::from_i64(y)))
    };
    polygon(corners.iter().map(at).collect())
}
