//! Faces that form no mesh are refused.

use super::check;
use crate::campaign::instance::{Instance, Parts, Source};
use crate::campaign::law::{Law, drawn};
use crate::claim::Run;
use crate::mesh::{Topology, TopologyError};
use crate::strategy::{Broken, Defect, broken};

/// The number of vertices, the defect, and the faces.
impl Instance for Broken {
    fn put(&self, parts: &mut Parts) {
        (self.vertices as u32).put(parts);
        (self.defect as u8).put(parts);
        self.faces.put(parts);
    }

    fn take(source: &mut Source) -> Option<Self> {
        let (vertices, defect, faces) = <(u32, u8, Vec<Vec<u32>>)>::take(source)?;
        let defect = Defect::ALL.into_iter().find(|d| *d as u8 == defect)?;
        Some(Broken { vertices: vertices as usize, faces, defect })
    }
}

fn refused(faces: &Broken) -> Run {
    let found = Topology::new(faces.vertices, faces.face_list());
    let fits = match (&found, faces.defect) {
        (Ok(_), _) => false,
        (Err(error), Defect::TooSmall) => matches!(error, TopologyError::FaceTooSmall { .. }),
        (Err(error), Defect::NoSuchVertex) => matches!(error, TopologyError::NoSuchVertex { .. }),
        (Err(error), Defect::Repeated) => matches!(error, TopologyError::RepeatedVertex { .. }),
        (Err(_), Defect::Doubled | Defect::TurnedOver | Defect::ThreeAtAnEdge) => true,
    };
    check(fits, || format!("{:?}: {:?}", faces.defect, found.err()))
}

pub(super) const LAWS: &[Law] = &[Law {
    id: "broken-faces",
    says: "faces that form no mesh are refused for what is wrong with them",
    control: false,
    cases: || drawn(broken(), refused),
}];
