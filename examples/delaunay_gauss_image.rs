//! From scattered samples of a surface to its curvatures: the exact Delaunay mesh, its lift to Σ as
//! Gauss image, and H, K of (22) at the vertices.
//!
//! `cargo run --example delaunay_gauss_image` prints them beside those of the smooth surface. On
//! random samples they do not converge to these, however dense the samples are; in the mean over
//! areas they do.

use std::error::Error;
use std::fmt::Write as _;

use isogeo::check::{Decider, Verdict};
use isogeo::construct::accuracy::vertex_curvatures;
use isogeo::construct::{delaunay, voronoi_areas};
use isogeo::net::{Net, Property};
use isogeo::scalar::{Approx, Field, Rational};
use isogeo::space::{Expression, Graph, Jet2, TopView};

/// The samples, the mesh, and a line for every interior vertex.
pub fn report() -> Result<String, Box<dyn Error>> {
    let surface: Expression = "x^2/2 - x*y/5 + y^3/6".parse()?;
    // Points of a sequence that fills the unit square.
    let places = (1..=40i64).map(|i| TopView::new(fraction(i * 55, 89), fraction(i * 34, 97)));
    let samples = places.map(|at| surface.height_at(&at).map(|z| at.at_height(z)));
    let mesh = delaunay(samples.collect::<Option<_>>().ok_or("not defined")?)?;

    // Nothing is believed: the check of the crate decides.
    let decider = Decider::of_rationals(&mesh.points);
    let verdict = Net::new(&mesh.topology, &decider).check(Property::Delaunay).verdict();
    assert_eq!(verdict, Verdict::Proved);

    let areas = voronoi_areas(&mesh);
    let mut text = String::from("vertex  area of cell         H (smooth)          K (smooth)\n");
    for v in mesh.topology.interior_vertices() {
        let (Some([h, k]), Some(area)) = (vertex_curvatures(&mesh, v), &areas[v.index()]) else {
            continue;
        };
        let jet: Jet2<Rational> =
            surface.jet(&mesh.points[v.index()].top_view()).ok_or("no jet")?;
        let [area, h, k] = [area, &h, &k].map(Approx::to_f64);
        let smooth = [jet.mean_curvature(), jet.curvature()].map(|c| c.to_f64());
        writeln!(
            text,
            "{:>6}  {area:>12.5}  {h:>9.4} ({:>7.4})  {k:>9.4} ({:>7.4})",
            v.0, smooth[0], smooth[1]
        )?;
    }
    Ok(text)
}

/// The part of `p / q` after the point.
fn fraction(p: i64, q: i64) -> Rational {
    Rational::from_ratio(p % q, q)
}

#[allow(dead_code, reason = "the tests call `report` alone")]
fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", report()?);
    Ok(())
}
