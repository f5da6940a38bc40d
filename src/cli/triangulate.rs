//! `isogeo triangulate`: the Delaunay mesh of scattered samples.

use std::path::Path;

use serde_json::json;

use super::arguments::{Layout, Reading, TriangulateOptions};
use super::failure::Failure;
use super::{Status, output};
use crate::construct::delaunay;
use crate::mesh::file::{FileError, Options, Place, PointFile, read_points_within};
use crate::scalar::{Numeral, Rational};
use crate::space::{Expression, Point, TopView};

/// Reads or makes the samples, triangulates, writes.
pub fn run(options: &TriangulateOptions, layout: Layout) -> Result<Status, Failure> {
    let mut exact = true;
    let (path, points) = match (&options.points, &options.sample, &options.at) {
        (Some(path), None, None) => (path, given(path, options)?),
        (None, Some(formula), Some(path)) => {
            let surface = expression(formula)?;
            exact = surface.is_rational();
            (path, sampled(formula, &surface, path, options)?)
        }
        _ => {
            return Err(Failure::with_help(
                "either a file of points, or --sample EXPR with --at FILE",
                "isogeo triangulate points.csv -o mesh.iso.json",
            ));
        }
    };
    let bar = output::progress(points.len(), "triangulating");
    let mesh = delaunay(points).map_err(|error| {
        Failure::with_help(
            format!("{}: {error}", path.display()),
            "points count from 0, in the order of the file",
        )
    })?;
    bar.finish_and_clear();
    let extra = options.sample.as_ref().map(|_| ("samples_exact", json!(exact)));
    output::write_saying(&options.output.output, &mesh, &Options::default(), layout, extra)?;
    if !exact && !layout.is_json() {
        output::print("the heights are values of functions, rounded to doubles\n")?;
    }
    Ok(Status::Proved)
}

/// The formula of an option, or the error with its place.
pub fn expression(formula: &str) -> Result<Expression, Failure> {
    formula.parse().map_err(|error: crate::space::ExpressionError| {
        let column = formula[..error.span.start].chars().count() + 1;
        Failure::from(FileError {
            code: "isogeo::expression::syntax".into(),
            message: error.message.clone(),
            file: "EXPR".into(),
            place: Some(Box::new(Place {
                span: error.span,
                line: 1,
                column,
                excerpt: formula.to_owned(),
                excerpt_start: 0,
            })),
            label: String::new(),
            help: Some(
                "numbers, x, y, + - * / ^, parentheses, sin cos exp sqrt log: x^2/2 - 3*x*y".into(),
            ),
        })
    })
}

fn given(path: &Path, options: &TriangulateOptions) -> Result<Vec<Point<Rational>>, Failure> {
    let file = read_points_within(path, &options.limits.limits())?;
    let read = reader(path, options.read_as)?;
    let points = file.points().ok_or_else(|| {
        Failure::with_help(
            format!("{}: there is no third column with heights", path.display()),
            "give lines 'x y z', or heights by --sample EXPR --at FILE",
        )
    })?;
    points
        .iter()
        .enumerate()
        .map(|(i, p)| Ok(Point::new(read(i, &p.x)?, read(i, &p.y)?, read(i, &p.z)?)))
        .collect()
}

fn sampled(
    formula: &str,
    surface: &Expression,
    path: &Path,
    options: &TriangulateOptions,
) -> Result<Vec<Point<Rational>>, Failure> {
    let PointFile { top_views, .. } = read_points_within(path, &options.limits.limits())?;
    let read = reader(path, options.read_as)?;
    let point = |(i, at): (usize, &TopView<Numeral>)| {
        let at = TopView::new(read(i, &at.x)?, read(i, &at.y)?);
        let height = surface.height_at(&at).ok_or_else(|| {
            Failure::usage(format!("{formula} is not defined at point {i}: ({}, {})", at.x, at.y))
        })?;
        Ok(at.at_height(height))
    };
    top_views.iter().enumerate().map(point).collect()
}

/// How a number of the file is understood.
fn reader(
    path: &Path,
    reading: Reading,
) -> Result<impl Fn(usize, &Numeral) -> Result<Rational, Failure>, Failure> {
    if reading == Reading::Rounded {
        return Err(Failure::with_help(
            "samples are points, not boxes: --read-as decimal or double",
            "decimal: the text is the number; double: its nearest double is",
        ));
    }
    let name = path.display().to_string();
    Ok(move |i: usize, number: &Numeral| match reading {
        Reading::Double => {
            Numeral::from_f64(number.nearest_f64()).map(|double| double.value()).ok_or_else(|| {
                Failure::usage(format!("{name}: point {i} is beyond the range of doubles"))
            })
        }
        _ => Ok(number.value()),
    })
}
