//! What a case consists of: numbers and meshes, in an order from which it can be made again.

use crate::construct::minimal::MeshPair;
use crate::mesh::Mesh;
use crate::scalar::{Rational, RationalField, Ring};
use crate::space::laguerre::LaguerreTransformation;
use crate::space::{MoebiusTransformation, Motion, Rotation, Scaling, Vector2, Vector3};

/// The numbers and meshes of a case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parts {
    /// The numbers, in order.
    pub numbers: Vec<Rational>,
    /// The meshes, in order.
    pub meshes: Vec<Mesh<Rational>>,
}

/// Takes parts one by one.
#[derive(Debug)]
pub struct Source {
    numbers: std::vec::IntoIter<Rational>,
    meshes: std::vec::IntoIter<Mesh<Rational>>,
}

impl From<Parts> for Source {
    fn from(parts: Parts) -> Self {
        Source { numbers: parts.numbers.into_iter(), meshes: parts.meshes.into_iter() }
    }
}

/// What a law may be about: it consists of numbers and meshes.
pub trait Instance {
    /// Adds what it consists of.
    fn put(&self, parts: &mut Parts);

    /// Makes it again; `None` where something is missing or does not fit.
    fn take(source: &mut Source) -> Option<Self>
    where
        Self: Sized;
}

impl Parts {
    /// Appends the same bytes for the same parts.
    pub(super) fn write(&self, bytes: &mut Vec<u8>) {
        self.numbers.iter().for_each(|number| write_number(bytes, number));
        for mesh in &self.meshes {
            let topology = &mesh.topology;
            write_integer(bytes, topology.vertex_count() as u64);
            for face in topology.faces() {
                let corners = topology.face(face);
                write_integer(bytes, corners.len() as u64);
                corners.iter().for_each(|v| write_integer(bytes, v.0.into()));
            }
            let coordinates = mesh.points.iter().flat_map(|p| p.coordinates());
            coordinates.for_each(|number| write_number(bytes, number));
            for (_, values) in mesh.data.vertex.iter().chain(&mesh.data.face) {
                values.iter().for_each(|number| write_number(bytes, number));
            }
        }
    }
}

fn write_integer(bytes: &mut Vec<u8>, n: u64) {
    bytes.extend_from_slice(&n.to_le_bytes());
}

pub(super) fn write_small(bytes: &mut Vec<u8>, (p, q): (i64, i64)) {
    bytes.extend_from_slice(&p.to_le_bytes());
    bytes.extend_from_slice(&q.to_le_bytes());
}

fn write_number(bytes: &mut Vec<u8>, number: &Rational) {
    match number.small_fraction() {
        Some(small) => write_small(bytes, small),
        None => {
            for n in [number.numerator(), number.denominator()] {
                let digits = n.to_signed_bytes_le();
                write_integer(bytes, digits.len() as u64);
                bytes.extend_from_slice(&digits);
            }
        }
    }
}

impl Instance for Rational {
    fn put(&self, parts: &mut Parts) {
        parts.numbers.push(self.clone());
    }

    fn take(source: &mut Source) -> Option<Self> {
        source.numbers.next()
    }
}

impl Instance for Mesh<Rational> {
    fn put(&self, parts: &mut Parts) {
        parts.meshes.push(self.clone());
    }

    fn take(source: &mut Source) -> Option<Self> {
        source.meshes.next()
    }
}

impl Instance for MeshPair<Rational> {
    fn put(&self, parts: &mut Parts) {
        (self.surface.clone(), self.gauss.clone()).put(parts);
    }

    fn take(source: &mut Source) -> Option<Self> {
        let (surface, gauss) = Instance::take(source)?;
        Some(MeshPair { surface, gauss })
    }
}

/// Whole numbers that a double holds, so that no digit is lost in a file.
macro_rules! integers {
    ($($integer:ty),*) => {$(
        impl Instance for $integer {
            fn put(&self, parts: &mut Parts) {
                parts.numbers.push(Rational::from_i64((*self).into()));
            }

            fn take(source: &mut Source) -> Option<Self> {
                let (p, q) = source.numbers.next()?.small_fraction()?;
                (q == 1).then(|| p.try_into().ok())?
            }
        }
    )*};
}
integers!(u8, u32);

impl Instance for bool {
    fn put(&self, parts: &mut Parts) {
        u8::from(*self).put(parts);
    }

    fn take(source: &mut Source) -> Option<Self> {
        Some(u8::take(source)? == 1)
    }
}

impl<T: Instance> Instance for Vec<T> {
    fn put(&self, parts: &mut Parts) {
        (self.len() as u32).put(parts);
        self.iter().for_each(|item| item.put(parts));
    }

    fn take(source: &mut Source) -> Option<Self> {
        (0..u32::take(source)?).map(|_| T::take(source)).collect()
    }
}

/// Things that are made of others, one after the other.
macro_rules! tuples {
    ($(($($name:ident),*)),*) => {$(
        impl<$($name: Instance),*> Instance for ($($name,)*) {
            fn put(&self, parts: &mut Parts) {
                #[allow(non_snake_case, reason = "the types name the values")]
                let ($($name,)*) = self;
                $($name.put(parts);)*
            }

            fn take(source: &mut Source) -> Option<Self> {
                Some(($($name::take(source)?,)*))
            }
        }
    )*};
}
tuples!((A, B), (A, B, C), (A, B, C, D));

impl Instance for Motion<Rational> {
    fn put(&self, parts: &mut Parts) {
        let Motion { rotation, shear, translation } = self;
        let Vector3 { x, y, z } = translation;
        for number in [rotation.cos(), rotation.sin(), &shear.x, &shear.y, x, y, z] {
            number.put(parts);
        }
    }

    fn take(source: &mut Source) -> Option<Self> {
        let mut next = || source.numbers.next();
        let rotation = Rotation::new(next()?, next()?).ok()?;
        let shear = Vector2::new(next()?, next()?);
        Some(Motion { rotation, shear, translation: Vector3::new(next()?, next()?, next()?) })
    }
}

impl Instance for Scaling<Rational> {
    fn put(&self, parts: &mut Parts) {
        self.horizontal().put(parts);
        self.vertical().put(parts);
    }

    fn take(source: &mut Source) -> Option<Self> {
        let (horizontal, vertical) = Instance::take(source)?;
        Scaling::new(horizontal, vertical).ok()
    }
}

impl Instance for MoebiusTransformation<Rational> {
    fn put(&self, parts: &mut Parts) {
        let numbers = self.linear().iter().flatten().chain(self.shift());
        numbers.chain([self.factor()]).for_each(|number| number.put(parts));
    }

    fn take(source: &mut Source) -> Option<Self> {
        let numbers: Vec<Rational> = source.numbers.by_ref().take(21).collect();
        let [linear @ .., a, b, c, d, factor] = numbers.as_slice() else { return None };
        let rows: Vec<[Rational; 4]> =
            linear.chunks(4).map(|row| row.to_vec().try_into().ok()).collect::<Option<_>>()?;
        let shift = [a, b, c, d].map(Rational::clone);
        MoebiusTransformation::with_factor(rows.try_into().ok()?, shift, factor.clone()).ok()
    }
}

impl Instance for LaguerreTransformation<Rational> {
    fn put(&self, parts: &mut Parts) {
        MoebiusTransformation::from(self).put(parts);
    }

    fn take(source: &mut Source) -> Option<Self> {
        MoebiusTransformation::take(source).map(|map| (&map).into())
    }
}
