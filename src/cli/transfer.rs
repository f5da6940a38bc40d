//! `isogeo transfer`: the map τ of Laguerre geometry, and back.

use serde_json::json;

use super::arguments::{Circles, Layout, Space, TransferOptions};
use super::failure::Failure;
use super::input::{self, Input};
use super::numbers::numbers;
use super::{Status, output, words};
use crate::check::{Decider, Verdict};
use crate::construct::transfer::{
    EuclideanImage, NoTransfer, circular_image, conical_image, edge_offset_image, isothermic_image,
    observed_image, oriented_planes, stored_axes, stored_planes,
};
use crate::mesh::file::Options;
use crate::mesh::{FaceId, Mesh};
use crate::net::{Net, Property};
use crate::scalar::{Approx, Numeral, Rational, Ring};
use crate::space::Point;

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
    /// The faces that run against their oriented planes.
    turned: Vec<FaceId>,
}

impl Found {
    fn new(image: EuclideanImage<Rational>, kind: &'static str) -> Found {
        let turned = image.turned_faces();
        Found { image: image.mesh, gauss: Some(image.gauss), kind, turned }
    }

    /// Whether some faces, but not all, run against their planes.
    fn is_singular(&self) -> bool {
        !self.turned.is_empty() && self.turned.len() < self.image.topology.face_count()
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
    if let Some(axes) = stored_axes(mesh) {
        let image = isothermic_image(mesh, &axes)?;
        return Ok(Found { image, gauss: None, kind: "i-isothermic", turned: Vec::new() });
    }
    let planes = stored_planes(mesh).unwrap_or_else(|| oriented_planes(mesh))?;
    let image = circular_image(mesh, &planes)?;
    Ok(Found { image, gauss: None, kind: "i-circular", turned: Vec::new() })
}

fn write(found: &Found, options: &TransferOptions, layout: Layout) -> Result<Status, Failure> {
    let path = &options.output.output;
    if let (Some(gauss), Some(path)) = (&found.gauss, &options.gauss) {
        crate::mesh::file::write(path, gauss, &Options::default())?;
    }
    let (faces, turned) = (found.image.topology.face_count(), found.turned.len());
    let list: Vec<u32> = found.turned.iter().map(|f| f.0).collect();
    let said = json!({ "kind": found.kind, "turned_faces": list });
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
    let observed = match reason {
        NoTransfer::Irrational { .. } => observed_defect(&input.exact()),
        _ => None,
    };
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.no-transfer/1",
            "file": input.file.name,
            "to": match to { Space::Euclidean => "euclidean", Space::Isotropic => "isotropic" },
            "reason": reason.to_string(),
            "observed_defect": observed,
        }))?;
    } else {
        let mut hint = String::new();
        if status == Status::Open && !undefined {
            hint += "\n  it may exist within the digits; it is made from the numbers as they are printed";
        }
        if let Some(defect) = observed.map(words::defect) {
            hint += &format!(
                "\n  observed in doubles: the image is i-circular up to a defect of {defect}"
            );
        }
        let (name, reason) = (&input.file.name, reason.map(words::exact));
        output::print(&format!("{name}: no image: {reason}{hint}\n"))?;
    }
    Ok(status)
}

/// How far what doubles show of the image in isotropic space is from being i-circular; `None` where
/// there is nothing to see.
fn observed_defect(mesh: &Mesh<Rational>) -> Option<f64> {
    let image = observed_image(&mesh.map(Approx::to_f64)).ok()?;
    let exact = |p: &Point<f64>| {
        let [x, y, z] = p.coordinates().map(|x| Numeral::from_f64(*x).map(|n| n.value()));
        Some(Point::new(x?, y?, z?))
    };
    let points = image.points.iter().map(exact).collect::<Option<Vec<_>>>()?;
    let decider = Decider::of_rationals(&points);
    let report = Net::new(&image.topology, &decider).check(Property::ICircular);
    report.worst.map(|worst| worst.failure.defect)
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
