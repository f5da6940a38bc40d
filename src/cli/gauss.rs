//! `isogeo gauss`: Gauss images.

use serde_json::{Value, json};

use super::arguments::{GaussKind, GaussOptions, Layout};
use super::failure::Failure;
use super::input::{self, Input};
use super::numbers::numbers;
use super::{Status, output, words};
use crate::check::{Decider, Report, Verdict, Witness};
use crate::construct::{
    NoGaussImage, circumscribed_f_parallel, circumscribed_v_parallel, inscribed_f_parallel,
    inscribed_v_parallel, mean_gradient,
};
use crate::mesh::file::Options;
use crate::mesh::{FaceId, Mesh, Topology, VertexId};
use crate::net::{Net, Property};
use crate::scalar::Rational;
use crate::space::TopView;

/// Writes the Gauss image, or says why there is none: a result, not an error.
pub fn run(options: &GaussOptions, layout: Layout) -> Result<Status, Failure> {
    let start = start(options)?;
    let input = input::read(&options.input)?;
    let mesh = input.exact();
    let bar = output::progress(mesh.topology.face_count(), "making the Gauss image");
    let found = find(options, start, &mesh);
    bar.finish_and_clear();
    match found {
        Ok(found) => {
            let path = &options.output.output;
            let report = ("gauss", found.json(options.kind));
            output::write_saying(path, &found.image, &Options::default(), layout, [report])?;
            if !layout.is_json() {
                output::print(&found.remark())?;
            }
            Ok(Status::Proved)
        }
        Err(Refusal::Usage(failure)) => Err(failure),
        Err(Refusal::None(reason)) => refuse(&reason, options.kind, &input, layout),
    }
}

/// The start that was given; an error where it has no meaning.
fn start(options: &GaussOptions) -> Result<Option<TopView<Rational>>, Failure> {
    let (has_start, has_at) = (options.start.is_some(), options.at.is_some());
    match options.kind {
        GaussKind::Lift | GaussKind::Delaunay if has_start || has_at => {
            Err(Failure::usage("a lift is unique: it takes neither --start nor --at"))
        }
        GaussKind::Circumscribed if has_at && !has_start => Err(Failure::with_help(
            "--at says which face touches over --start X,Y",
            "without --start, the image has the same face planes and is unique inside",
        )),
        _ => {
            let numbers =
                options.start.as_ref().map(|text| numbers("--start", text)).transpose()?;
            Ok(numbers.map(|[x, y]| TopView::new(x, y)))
        }
    }
}

/// A Gauss image and what was chosen to make it.
struct Found {
    image: Mesh<Rational>,
    start: Option<(u32, TopView<Rational>)>,
    free: Option<Vec<VertexId>>,
}

enum Refusal {
    Usage(Failure),
    None(Box<NoImage>),
}

/// Why there is no image.
enum NoImage {
    Construction(NoGaussImage<Rational>),
    NotDelaunay(Report<Rational>),
}

impl<E: Into<NoGaussImage<Rational>>> From<E> for Refusal {
    fn from(reason: E) -> Refusal {
        match reason.into() {
            NoGaussImage::NoStart(i) => Refusal::Usage(Failure::with_help(
                format!("there is no vertex or face {i} to start from"),
                "vertices and faces count from 0, in the order of the file",
            )),
            reason => Refusal::None(Box::new(NoImage::Construction(reason))),
        }
    }
}

fn find(
    options: &GaussOptions,
    start: Option<TopView<Rational>>,
    mesh: &Mesh<Rational>,
) -> Result<Found, Refusal> {
    let at = options.at.unwrap_or(0);
    let alone = |image| Found { image, start: None, free: None };
    match (options.kind, start) {
        (GaussKind::Lift, _) => Ok(alone(inscribed_v_parallel(mesh)?.into_image())),
        (GaussKind::Delaunay, _) => {
            is_delaunay(mesh)?;
            Ok(alone(inscribed_v_parallel(mesh)?.into_image()))
        }
        (GaussKind::Circumscribed, None) => {
            let found = circumscribed_f_parallel(mesh)?;
            Ok(Found { free: Some(found.free), ..alone(found.pair.into_image()) })
        }
        (GaussKind::Circumscribed, Some(start)) => {
            let pair = circumscribed_v_parallel(mesh, FaceId(at), &start)?;
            Ok(Found { start: Some((at, start)), ..alone(pair.into_image()) })
        }
        (GaussKind::Inscribed, Some(start)) => {
            let pair = inscribed_f_parallel(mesh, VertexId(at), &start)?;
            Ok(Found { start: Some((at, start)), ..alone(pair.into_image()) })
        }
        (GaussKind::Inscribed, None) => {
            let at = options.at.unwrap_or_else(|| of_most_faces(&mesh.topology));
            let mean = mean_gradient(mesh, VertexId(at))?;
            let start = mean.ok_or(NoGaussImage::NoStart(at))?;
            let pair = inscribed_f_parallel(mesh, VertexId(at), &start)?;
            Ok(Found { start: Some((at, start)), ..alone(pair.into_image()) })
        }
    }
}

/// The first vertex at which the most faces meet: in a patch, one that is not at its boundary.
fn of_most_faces(topology: &Topology) -> u32 {
    let mut faces = vec![0u32; topology.vertex_count()];
    topology.faces().flat_map(|f| topology.face(f)).for_each(|v| faces[v.index()] += 1);
    let most = faces.iter().max().copied().unwrap_or(0);
    faces.iter().position(|&n| n == most).map_or(0, |v| v as u32)
}

fn is_delaunay(mesh: &Mesh<Rational>) -> Result<(), Refusal> {
    let decider = Decider::of_rationals(&mesh.points);
    let report = Net::new(&mesh.topology, &decider).check(Property::Delaunay);
    match report.verdict() {
        // A single triangle leaves nothing to check.
        Verdict::Proved | Verdict::Vacuous => Ok(()),
        _ => Err(Refusal::None(Box::new(NoImage::NotDelaunay(report)))),
    }
}

impl NoImage {
    fn is_undefined(&self) -> bool {
        match self {
            NoImage::Construction(reason) => reason.is_undefined(),
            NoImage::NotDelaunay(report) => report.worst.is_none(),
        }
    }

    /// The reason, with numbers as `show` gives them.
    fn words(&self, show: impl Fn(&Rational) -> String) -> String {
        let report = match self {
            NoImage::Construction(reason) => return reason.map(show).to_string(),
            NoImage::NotDelaunay(report) => report,
        };
        let why = match (&report.worst, report.undefined.first()) {
            (Some(Witness { element, failure }), _) => {
                let residual = failure.residual.as_ref().map(show).unwrap_or_default();
                format!("{element}, {}: residual {residual}", failure.condition)
            }
            (None, Some((element, reason))) => format!("undefined at {element}: {reason}"),
            (None, None) => report.verdict().to_string(),
        };
        format!("the top view is not Delaunay: {why}")
    }
}

fn name(kind: GaussKind) -> &'static str {
    match kind {
        GaussKind::Inscribed => "inscribed",
        GaussKind::Circumscribed => "circumscribed",
        GaussKind::Lift => "lift",
        GaussKind::Delaunay => "delaunay",
    }
}

impl Found {
    fn json(&self, kind: GaussKind) -> Value {
        let start = self.start.as_ref();
        json!({
            "kind": name(kind),
            "at": start.map(|(at, _)| at),
            "start": start.map(|(_, s)| [s.x.to_string(), s.y.to_string()]),
            "free": self.free.as_ref().map(|free| free.iter().map(|v| v.0).collect::<Vec<_>>()),
        })
    }

    fn remark(&self) -> String {
        if let Some((at, TopView { x, y })) = &self.start {
            format!("  started at {at} over ({}, {})\n", words::exact(x), words::exact(y))
        } else if let Some(free) = &self.free {
            format!("  {} placed freely\n", words::vertices(free.len()))
        } else {
            String::new()
        }
    }
}

/// Says why there is no image, and whether that is certain in the reading of the file.
fn refuse(
    reason: &NoImage,
    kind: GaussKind,
    input: &Input,
    layout: Layout,
) -> Result<Status, Failure> {
    let undefined = reason.is_undefined();
    let status = match undefined {
        false if is_refuted(reason, kind, input) => Status::Refuted,
        _ => Status::Open,
    };
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.no-gauss-image/1",
            "file": input.file.name,
            "kind": name(kind),
            "reason": reason.words(Rational::to_string),
        }))?;
    } else {
        let hint = match status {
            Status::Open if !undefined && input.is_rounded() => {
                "\n  it may exist within the digits; it is made from the numbers as they are printed"
            }
            _ => "",
        };
        let (name, reason) = (&input.file.name, reason.words(words::exact));
        output::print(&format!("{name}: no Gauss image: {reason}{hint}\n"))?;
    }
    Ok(status)
}

/// Whether the class of mesh that has such images is refuted, whatever the unprinted digits were.
fn is_refuted(reason: &NoImage, kind: GaussKind, input: &Input) -> bool {
    if !input.is_rounded() {
        return true;
    }
    let property = match (reason, kind) {
        (NoImage::NotDelaunay(_), _) => Property::Delaunay,
        (_, GaussKind::Circumscribed) => Property::IConical,
        _ => Property::ICircular,
    };
    let decider = input.decider();
    Net::new(input.topology(), &decider).check(property).verdict() == Verdict::Refuted
}
