//! What is written is read again, digit by digit.

use proptest::prelude::*;

use super::{accepted, check};
use crate::campaign::law::{Law, drawn};
use crate::claim::Run;
use crate::mesh::Mesh;
use crate::mesh::file::{Format, Options, Written, read_bytes, write_string};
use crate::scalar::{Rational, ReadAs};
use crate::strategy::{any_mesh, circular, koebe, near_degenerate, number, polygons, small};

fn meshes() -> impl Strategy<Value = Mesh<Rational>> {
    let any = prop_oneof![any_mesh(small()), any_mesh(number())];
    near_degenerate(prop_oneof![any, polygons(), circular(), koebe()])
}

/// Exact where the file says so; else each number is the nearest double.
fn round_trip(mesh: &Mesh<Rational>, format: Format) -> Run {
    let (text, written) = accepted("write", write_string("", format, mesh, &Options::default()))?;
    let file = accepted("read", read_bytes("", format, text.as_bytes()))?;
    check(file.topology() == &mesh.topology, || "the faces are others".into())?;
    let exact = written == Written::Exact;
    check(file.exact == exact, || format!("exact: written {exact}, read {}", file.exact))?;
    if exact {
        let back = accepted("decimals", file.to_exact(ReadAs::Decimal))?;
        return check(back.points == mesh.points, || "the points are others".into());
    }
    let back = accepted("doubles", file.to_exact(ReadAs::Double))?;
    use crate::scalar::Approx;
    let near = |mesh: &Mesh<Rational>| mesh.map(Rational::to_f64).points;
    check(near(&back) == near(mesh), || "the doubles are others".into())
}

fn iso_json(mesh: &Mesh<Rational>) -> Run {
    round_trip(mesh, Format::IsoJson)?;
    let (text, _) =
        accepted("write", write_string("", Format::IsoJson, mesh, &Options::default()))?;
    let file = accepted("read", read_bytes("", Format::IsoJson, text.as_bytes()))?;
    let back = accepted("fractions", file.to_exact(ReadAs::Decimal))?;
    check(back == *mesh, || "data are lost".into())
}

pub(super) const LAWS: &[Law] = &[
    Law {
        id: "file-iso-json",
        says: "an .iso.json file is read as it was written, with its data",
        control: false,
        cases: || drawn(meshes(), iso_json),
    },
    Law {
        id: "file-obj",
        says: "an OBJ file is read as it was written: exactly if it says so, else in doubles",
        control: false,
        cases: || drawn(meshes(), |mesh| round_trip(mesh, Format::Obj)),
    },
    Law {
        id: "file-off",
        says: "an OFF file is read as it was written: exactly if it says so, else in doubles",
        control: false,
        cases: || drawn(meshes(), |mesh| round_trip(mesh, Format::Off)),
    },
    Law {
        id: "file-ply",
        says: "a PLY file is read as it was written: exactly if it says so, else in doubles",
        control: false,
        cases: || drawn(meshes(), |mesh| round_trip(mesh, Format::Ply)),
    },
];
