//! Fig. 10: rotational meshes of hexagons.

use super::draw::{Anchor, Scene};
use super::sheet::{seen, solid};
use super::{Exhibit, Figure, NoFigure, Plate};
use crate::construct::hexagonal::HexagonalRings;
use crate::construct::minimal::MeshPair;
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Approx, Field, Rational};
use crate::space::Rotation;

pub(super) const FIGURE: Figure = Figure {
    number: 10,
    title: "rotational meshes of hexagons with H = 0, with constant H and with constant K",
    caption: "Rings of 11 hexagons with the half sector (24/25, 7/25), so that they nearly close. Left: \
              H = 0, slopes (13/8)^k, 0 <= k <= 6, first integral 1, the image circumscribed to the unit \
              i-sphere. Middle: H = 1, slopes -5/2, -5/4, -1/3, 1/2, 3/2, 8/3, 17/4, with r f' = r^2 - 1 \
              in the limit. Right: K = 1, slopes 1/8, 3/4, 3/2, 5/2, 4, 13/2, with f'^2 = r^2 - 1 in the \
              limit. H and K are exactly the same at all faces; on the right two the steps of the image are near \
              to those of the circumscribed one. Heights are scaled.",
    claims: &["hex-rotational", "eq-17-18"],
    make,
};

/// Faces of a ring.
const HEXAGONS: usize = 11;

fn make() -> Result<Plate, NoFigure> {
    let q = Rational::from_ratio;
    let growing: Vec<Rational> = (0..7).map(|k| q(13_i64.pow(k), 8_i64.pow(k))).collect();
    let minimal = rings(growing)?;
    let round = minimal.circumscribed();
    let steps = minimal.minimal(&round, &q(1, 1)).ok_or_else(singular)?;
    let minimal = minimal.pair(&steps, &round, HEXAGONS).map_err(NoFigure::of)?;
    let trough = [(-5, 2), (-5, 4), (-1, 3), (1, 2), (3, 2), (8, 3), (17, 4)];
    let bowl = [(1, 8), (3, 4), (3, 2), (5, 2), (4, 1), (13, 2)];
    let [mean, gauss] = [constant_mean(&trough)?, constant_gauss(&bowl)?];
    let mut scene = Scene::new(160.0, 48.0);
    let mut exhibits = Vec::new();
    let all = [
        ("minimal", "minimal-gauss", "H = 0", PairProperty::IMinimal, minimal, 0.5),
        ("cmc", "cmc-gauss", "H constant", PairProperty::Cmc, mean, 0.4),
        ("constant-k", "constant-k-gauss", "K constant", PairProperty::ConstantK, gauss, 0.4),
    ];
    for (i, (name, image, label, property, pair, rise)) in all.into_iter().enumerate() {
        let x = 2.0 + 53.0 * i as f64;
        scene.place(seen(solid(&pair.surface), [-3.0, -4.0, 3.4], rise), [x, 9.0], [50.0, 37.0]);
        scene.text([x + 25.0, 3.0], 3.0, Anchor::Middle, label);
        let pair_properties = [PairProperty::FParallel, property];
        exhibits.push(
            Exhibit::new(name, pair.surface).is(&[Property::Planar]).gauss(image, &pair_properties),
        );
        exhibits.push(Exhibit::new(image, pair.gauss).is(&[Property::Planar]));
    }
    Ok(Plate { exhibits, scene })
}

fn singular() -> NoFigure {
    NoFigure::Construction("a step is 0".into())
}

fn rings(slopes: Vec<Rational>) -> Result<HexagonalRings<Rational>, NoFigure> {
    let q = Rational::from_ratio;
    let half_sector = Rotation::new(q(24, 25), q(7, 25)).map_err(NoFigure::of)?;
    HexagonalRings::new(half_sector, slopes).map_err(NoFigure::of)
}

/// The fraction with the denominator 4096 next to a number.
fn near(number: f64) -> Rational {
    Rational::from_ratio((number * 4096.0).round() as i64, 4096)
}

fn fractions(slopes: &[(i64, i64)]) -> Vec<Rational> {
    slopes.iter().map(|(p, q)| Rational::from_ratio(*p, *q)).collect()
}

/// H = 1 with the first integral −1: steps near the greater roots of `δ² − δ̂ δ = AB`.
fn constant_mean(slopes: &[(i64, i64)]) -> Result<MeshPair<Rational>, NoFigure> {
    let rings = rings(fractions(slopes))?;
    let round = rings.circumscribed();
    let step = |(d, product): (&Rational, &Rational)| {
        let (d, product) = (d.to_f64(), product.to_f64());
        near((d + (d * d + 4.0 * product).sqrt()) / 2.0)
    };
    let steps: Vec<Rational> = round.iter().zip(rings.products()).map(step).collect();
    let [mean, integral] = [1, -1].map(|n| Rational::from_ratio(n, 1));
    let image = rings.constant_mean(&steps, &mean, &integral).ok_or_else(singular)?;
    rings.pair(&steps, &image, HEXAGONS).map_err(NoFigure::of)
}

/// K = 1 with the first integral 1: factors near those of the circumscribed image.
fn constant_gauss(slopes: &[(i64, i64)]) -> Result<MeshPair<Rational>, NoFigure> {
    let rings = rings(fractions(slopes))?;
    let round = rings.circumscribed();
    let factor = |(d, product): (&Rational, &Rational)| {
        let (d, product) = (d.to_f64(), product.to_f64());
        near((d * d + product).sqrt() - d)
    };
    let factors: Vec<Rational> = round.iter().zip(rings.products()).map(factor).collect();
    let one = Rational::from_ratio(1, 1);
    let (steps, image) = rings.constant_gauss(&factors, &one, &one).ok_or_else(singular)?;
    rings.pair(&steps, &image, HEXAGONS).map_err(NoFigure::of)
}
