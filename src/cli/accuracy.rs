//! `isogeo accuracy`: the errors of (22) by class of triangulation.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::arguments::{AccuracyOptions, Layout};
use super::failure::Failure;
use super::{Status, output, triangulate};
use crate::construct::accuracy::{Accuracy, Class, Errors, Row, Trend, accuracy, order};
use crate::scalar::Approx;

/// Measures and prints the tables.
pub fn run(options: &AccuracyOptions, layout: Layout) -> Result<Status, Failure> {
    let surface = triangulate::expression(&options.expression)?;
    let classes = options.class.iter().map(|name| class(name)).collect::<Result<Vec<_>, _>>()?;
    let classes = if classes.is_empty() { Class::ALL.to_vec() } else { classes };
    if let Some(n) = options.sizes.iter().find(|&&n| !(4..=512).contains(&n)) {
        return Err(Failure::usage(format!("a mesh size 1/{n} is not between 1/4 and 1/512")));
    }
    let bar = output::progress(usize::MAX, "measuring");
    let measure = |class| accuracy(&surface, class, &options.sizes, options.seed);
    let tables = classes.into_iter().map(measure).collect::<Result<Vec<_>, _>>();
    let tables = tables.map_err(|error| Failure::usage(error.to_string()))?;
    bar.finish_and_clear();
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.accuracy/1",
            "surface": options.expression,
            "samples_exact": surface.is_rational(),
            "seed": options.seed,
            "classes": tables.iter().map(table_json).collect::<Vec<_>>(),
        }))?;
    } else {
        let mut text =
            format!("z = {}: errors of (22) at the vertices inside\n", options.expression);
        if !surface.is_rational() {
            text.push_str("samples and curvatures of the surface are rounded to doubles\n");
        }
        for table in &tables {
            push_table(&mut text, table, options.seed);
        }
        output::print(&text)?;
    }
    Ok(Status::Proved)
}

fn class(name: &str) -> Result<Class, Failure> {
    Class::from_name(name).ok_or_else(|| {
        let names: Vec<&str> = Class::ALL.iter().map(|class| class.name()).collect();
        Failure::with_help(
            format!("'{name}' is no class of triangulation"),
            format!("there are {}", names.join(", ")),
        )
    })
}

fn push_table(text: &mut String, table: &Accuracy, seed: u64) {
    // Writing to a string does not fail.
    let seed =
        if table.class == Class::Delaunay { format!(", seed {seed}") } else { String::new() };
    let _ = writeln!(text, "\n{}{seed} ({})", table.class.name(), table.class.theory());
    let _ = writeln!(
        text,
        "  {:>6} {:>8}   {:>10} {:>10} {:>10} {:>6}   {:>10} {:>10} {:>10} {:>6}",
        "1/h", "vertices", "H largest", "rms", "mean", "order", "K largest", "rms", "mean", "order"
    );
    let mut before: Option<&Row> = None;
    for row in &table.rows {
        let _ = write!(text, "  {:>6} {:>8}", row.n, row.vertices);
        for of in [mean_curvature as fn(&Row) -> &Errors, curvature] {
            let errors = of(row);
            let order = before
                .and_then(|b| order((b.n, &of(b).largest), (row.n, &errors.largest)))
                .map_or("-".into(), |order| format!("{order:.2}"));
            let _ = write!(
                text,
                "   {:>10} {:>10} {:>10} {order:>6}",
                size(&errors.largest),
                number(errors.root_mean_square),
                number(errors.mean)
            );
        }
        text.push('\n');
        if row.undefined > 0 {
            let _ = writeln!(text, "  {:>15} without curvature, left out", row.undefined);
        }
        before = Some(row);
    }
    let trends = [table.trend(mean_curvature), table.trend(curvature)];
    for (i, name) in ["H", "K"].into_iter().enumerate() {
        let trend = words(trends[i], table.class.converges()[i]);
        let quadratics = if table.exact_for_quadratics[i] { "exact" } else { "not exact" };
        let _ = writeln!(text, "  {name}: {trend}; {quadratics} for all quadratics");
    }
}

fn mean_curvature(row: &Row) -> &Errors {
    &row.mean_curvature
}

fn curvature(row: &Row) -> &Errors {
    &row.curvature
}

/// The trend, and what theory says where the trend alone would not be plain.
fn words(trend: Trend, converges: bool) -> String {
    match (trend, converges) {
        (Trend::Exact, _) => "exact here".into(),
        (Trend::Order(order), true) => format!("converges, observed order {order:.1}"),
        (Trend::Order(order), false) => {
            format!("observed order {order:.1}, but no convergence in general")
        }
        (Trend::NoConvergence | Trend::Unknown, false) => "DOES NOT CONVERGE pointwise".into(),
        (Trend::NoConvergence, true) => "no convergence observed at these sizes".into(),
        (Trend::Unknown, true) => "one size shows no order".into(),
    }
}

fn size<T: Approx>(error: &T) -> String {
    if error.is_zero() { "0".into() } else { number(error.to_f64()) }
}

fn number(x: f64) -> String {
    if x == 0.0 { "0".into() } else { format!("{x:.2e}") }
}

fn table_json(table: &Accuracy) -> Value {
    let trend = |trend| match trend {
        Trend::Exact => json!({"trend": "exact", "order": null}),
        Trend::Order(order) => json!({"trend": "converges", "order": order}),
        Trend::NoConvergence => json!({"trend": "does-not-converge", "order": null}),
        Trend::Unknown => json!({"trend": "unknown", "order": null}),
    };
    let errors = |errors: &Errors| {
        json!({
            "largest": errors.largest.to_string(),
            "largest_f64": errors.largest.to_f64(),
            "rms": errors.root_mean_square,
            "mean": errors.mean,
        })
    };
    let row = |row: &Row| {
        json!({
            "n": row.n,
            "vertices": row.vertices,
            "undefined": row.undefined,
            "H": errors(&row.mean_curvature),
            "K": errors(&row.curvature),
        })
    };
    json!({
        "class": table.class.name(),
        "theory": table.class.theory(),
        "exact_for_quadratics": {"H": table.exact_for_quadratics[0], "K": table.exact_for_quadratics[1]},
        "H": trend(table.trend(mean_curvature)),
        "K": trend(table.trend(curvature)),
        "rows": table.rows.iter().map(row).collect::<Vec<_>>(),
    })
}
