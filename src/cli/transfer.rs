//! `isogeo transfer`: the map τ of Laguerre geometry, and back.

use serde_json::json;

use super::arguments::{Circles, Layout, Space, TransferOptions};
use super::failure::Failure;
use super::input::{self, Input};
use super::numbers::numbers;
use super::{Status, output, words};
use crate::check::Verdict;
use crate::construct::transfer::{
    EuclideanImage, NoTransfer, circular_image, conical_image, edge_offset_image, oriented_planes,
    stored_planes,
};
use crate::mesh::Mesh;
use crate::mesh::file::Options;
use crate::net::{Net, Property};
use crate::scalar::{Rational, Ring};

/// The name under which meshes keep the radii of their vertex circles.
const RADIUS: &str = "radius";

/// Writes the image, or says why there is none: a result, not an error.
pub fn run(options: &TransferOptions, layout: Layout) -> Result<Status, Failure> {
    let input = input::read(&options.input)?;
    let mesh = input.exact();
    let bar = output::progress(mesh.topology.face_count(), "transferring");
    let found = match options.to {
        Space::Euclidean => euclidean(options, &mesh)?,
        Space::Isotropic
            if options.by.is_some() || options.gauss.is_some() || options.distance.is_some() =>
        {
            return Err(Failure::usage("--by, --gauss and --distance belong to --to euclidean"));
        }
        Space::Isotropic => isotropic(&mesh),
    };
    bar.finish_and_clear();
    match found {
        Ok(found) => write(&found, options, layout),
        Err(reason) => refuse(&reason, options.to, &input, layout),
    }
}

/// An image and what belongs to it.
struct Found {
    image: Mesh<Rational>,
    gauss: Option<Mesh<Rational>>,
    kind: &'static str,
    /// How many faces run against their oriented planes.
    turned: usize,
}

impl Found {
    fn new(image: EuclideanImage<Rational>, kind: &'static str) -> Found {
        let turned = image.turned_faces().len();
        Found { image: image.mesh, gauss: Some(image.gauss), kind, turned }
    }

    /// Whether some faces, but not all, run against their planes.
    fn is_singular(&self) -> bool {
        self.turned > 0 && self.turned < self.image.topology.face_count()
    }
}

type Transferred = Result<Found, NoTransfer<Rational>>;

fn euclidean(options: &TransferOptions, mesh: &Mesh<Rational>) -> Result<Transferred, Failure> {
    let distance = options.distance.as_ref().map(|text| numbers("--distance", text)).transpose()?;
    let [distance] = distance.unwrap_or([Rational::zero()]);
    let radii = mesh.data.vertex.get(RADIUS);
    let by = options.by.unwrap_or(match radii {
        Some(_) => Circles::Incircles,
        None => Circles::Circumcircles,
    });
    Ok(match (by, radii) {
        (Circles::Circumcircles, _) => {
            conical_image(mesh).map(|image| Found::new(image.offset(&distance), "conical"))
        }
        (Circles::Incircles, Some(radii)) => edge_offset_image(mesh, radii)
            .map(|image| Found::new(image.offset(&distance), "edge-offset")),
        (Circles::Incircles, None) => {
            return Err(Failure::with_help(
                "--by incircles needs the radii of the vertex circles",
                "they are data on the vertices of an .iso.json file, under the name \"radius\"",
            ));
        }
    })
}

fn isotropic(mesh: &Mesh<Rational>) -> Transferred {
    let planes = stored_planes(mesh).unwrap_or_else(|| oriented_planes(mesh))?;
    let image = circular_image(mesh, &planes)?;
    Ok(Found { image, gauss: None, kind: "i-circular", turned: 0 })
}

fn write(found: &Found, options: &TransferOptions, layout: Layout) -> Result<Status, Failure> {
    let path = &options.output.output;
    if let (Some(gauss), Some(path)) = (&found.gauss, &options.gauss) {
        crate::mesh::file::write(path, gauss, &Options::default())?;
    }
    let (faces, turned) = (found.image.topology.face_count(), found.turned);
    let said = json!({ "kind": found.kind, "turned_faces": turned });
    output::write_saying(path, &found.image, &Options::default(), layout, [("transfer", said)])?;
    if !layout.is_json() {
        let kind = found.kind;
        let text = match found.is_singular() {
            false => format!("  the mesh is {kind}\n"),
            true => format!(
                "  {turned} of {} run against their planes, at singularities: the mesh is {kind} only \
                 as a set\n  of oriented planes; an offset at another --distance may be free of them\n",
                words::count(faces, "face"),
            ),
        };
        output::print(&text)?;
    }
    Ok(if found.is_singular() { Status::Open } else { Status::Proved })
}

/// Says why there is no image, and whether that is certain in the reading of the file.
fn refuse(
    reason: &NoTransfer<Rational>,
    to: Space,
    input: &Input,
    layout: Layout,
) -> Result<Status, Failure> {
    let undefined = reason.is_undefined();
    let status = if !undefined && is_refuted(to, input) { Status::Refuted } else { Status::Open };
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.no-transfer/1",
            "file": input.file.name,
            "to": match to { Space::Euclidean => "euclidean", Space::Isotropic => "isotropic" },
            "reason": reason.to_string(),
        }))?;
    } else {
        let hint = match (reason, status) {
            (NoTransfer::Irrational { .. }, _) => {
                "\n  only meshes with rational unit normals have an exact image; what doubles would \
                 show is observed, not proved"
            }
            (_, Status::Open) if !undefined => {
                "\n  it may exist within the digits; it is made from the numbers as they are printed"
            }
            _ => "",
        };
        let (name, reason) = (&input.file.name, reason.map(words::exact));
        output::print(&format!("{name}: no image: {reason}{hint}\n"))?;
    }
    Ok(status)
}

/// Whether the class of mesh that has images is refuted, whatever the unprinted digits were.
fn is_refuted(to: Space, input: &Input) -> bool {
    if !input.is_rounded() {
        return true;
    }
    let property = match to {
        Space::Euclidean => Property::ICircular,
        Space::Isotropic => Property::Conical,
    };
    let decider = input.decider();
    Net::new(input.topology(), &decider).check(property).verdict() == Verdict::Refuted
}
