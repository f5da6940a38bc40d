//! A mesh of a figure, with what the figure says of it.

use std::fmt;

use super::Surface;
use crate::check::{Decider, Verdict};
use crate::mesh::VertexId;
use crate::net::{Net, Property, RADIUS};
use crate::pair::element::At;
use crate::pair::{Couple, PairProperty};
use crate::scalar::Rational;
use crate::space::Point;

/// A mesh with a name and with what holds on it.
#[derive(Clone, Debug)]
pub struct Exhibit {
    /// The name: of its files, too.
    pub name: &'static str,
    /// The mesh.
    pub mesh: Surface,
    /// What holds on it alone.
    pub holds: Vec<Property>,
    /// What holds with another exhibit, by its name, as S.
    pub with: Vec<(&'static str, PairProperty)>,
    /// The exhibit that is its Gauss image.
    pub gauss: Option<&'static str>,
    /// What else the figure shows of it.
    pub shown: Vec<Remark>,
}

/// Something that only a figure says of a mesh, in words and as an exact test.
#[derive(Clone, Copy, Debug)]
pub struct Remark {
    /// The words.
    pub says: &'static str,
    /// The test.
    pub test: fn(&Surface) -> bool,
}

/// Something that a figure says does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotSo {
    /// The exhibit.
    pub exhibit: &'static str,
    /// What was said of it.
    pub property: &'static str,
    /// What was found.
    pub verdict: &'static str,
}

impl fmt::Display for NotSo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} is {}", self.exhibit, self.property, self.verdict)
    }
}

impl Exhibit {
    /// A mesh of which nothing is said.
    pub fn new(name: &'static str, mesh: Surface) -> Self {
        Exhibit { name, mesh, holds: Vec::new(), with: Vec::new(), gauss: None, shown: Vec::new() }
    }

    /// The same with properties of the mesh alone.
    pub fn is(mut self, properties: &[Property]) -> Self {
        self.holds.extend(properties);
        self
    }

    /// The same with properties of the pair with another exhibit.
    pub fn with(mut self, image: &'static str, properties: &[PairProperty]) -> Self {
        self.with.extend(properties.iter().map(|p| (image, *p)));
        self
    }

    /// The same with another exhibit as its Gauss image, and properties of the pair.
    pub fn gauss(mut self, image: &'static str, properties: &[PairProperty]) -> Self {
        self.gauss = Some(image);
        self.with(image, properties)
    }

    /// The Gauss image, and where the pair has curvatures.
    pub(super) fn curved(&self) -> Option<(&'static str, At)> {
        let mut pairs = self.with.iter().filter(|(image, _)| Some(*image) == self.gauss);
        pairs.find_map(|&(image, property)| match property {
            PairProperty::FParallel => Some((image, At::Faces)),
            PairProperty::VParallel => Some((image, At::Vertices)),
            _ => None,
        })
    }

    /// The same with a remark.
    pub fn shows(mut self, says: &'static str, test: fn(&Surface) -> bool) -> Self {
        self.shown.push(Remark { says, test });
        self
    }

    /// Checks everything exactly.
    ///
    /// # Errors
    /// The first property that is not proved.
    pub fn check(&self, others: &[Exhibit]) -> Result<(), NotSo> {
        let not = |property, verdict: Verdict| {
            Err(NotSo { exhibit: self.name, property, verdict: verdict.name() })
        };
        let radii = self.mesh.data.vertex.get(RADIUS);
        let radius = |r: &Rational| Point::new(r.clone(), Rational::default(), Rational::default());
        let radii: Option<Vec<_>> = radii.map(|radii| radii.iter().map(radius).collect());
        let mut decider = Decider::of_rationals(&self.mesh.points);
        if let Some(radii) = &radii {
            decider = decider.followed_by(Decider::of_rationals(radii));
        }
        let mut net = Net::new(&self.mesh.topology, &decider);
        if radii.is_some() {
            net = net.with_radii(VertexId(self.mesh.topology.vertex_count() as u32));
        }
        for &property in &self.holds {
            match net.check(property).verdict() {
                Verdict::Proved => {}
                verdict => return not(property.name(), verdict),
            }
        }
        for &(image, property) in &self.with {
            let Some(other) = others.iter().find(|e| e.name == image) else {
                return not(property.name(), Verdict::Vacuous);
            };
            let points = [self.mesh.points.as_slice(), &other.mesh.points].concat();
            let decider = Decider::of_rationals(&points);
            let couple = Couple::new(&self.mesh.topology, &other.mesh.topology, &decider);
            match couple.map(|couple| couple.check(property).verdict()) {
                Ok(Verdict::Proved) => {}
                Ok(verdict) => return not(property.name(), verdict),
                Err(_) => return not(property.name(), Verdict::Refuted),
            }
        }
        match self.shown.iter().find(|remark| !(remark.test)(&self.mesh)) {
            Some(remark) => not(remark.says, Verdict::Refuted),
            None => Ok(()),
        }
    }
}
