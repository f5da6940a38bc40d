//! What exact families cost: making them with their certificates, and proving what they are.
//!
//! `cargo bench --bench family` takes all rows; `-- enneper weierstrass` those of these families.
//! Everything is over rational numbers: a certificate is the signed radii of vertex circles, the
//! factors of a Christoffel dual, or the bounds of an enclosure. `proving` decides all properties that
//! the family proves, of the mesh and of the pair; `digits` are those of its longest denominator.

use std::hint::black_box;
use std::time::Instant;

use isogeo::check::{Decider, Verdict};
use isogeo::construct::christoffel_by_radii;
use isogeo::construct::family::{Family, Member, Values};
use isogeo::mesh::{Mesh, VertexId};
use isogeo::net::{Net, RADIUS};
use isogeo::pair::Couple;
use isogeo::scalar::{Rational, RationalField, Ring};
use isogeo::space::Point;

/// Family, rows and columns, parameters. Powers of a rotation have ever more digits: few sectors.
type Row = (&'static str, [usize; 2], &'static [(&'static str, &'static str)]);

const ROWS: [Row; 11] = [
    ("saddle", [200, 200], &[]),
    ("enneper", [200, 200], &[("center", "-1/2,-1/3")]),
    ("logarithmoid", [40, 14], &[]),
    ("bonnet", [12, 14], &[]),
    ("weierstrass", [6, 6], &[]),
    ("circular-net", [6, 6], &[]),
    ("conical-net", [4, 4], &[]),
    ("rotational-cmc", [100, 14], &[]),
    ("rotational-constant-k", [100, 14], &[("curvature", "4"), ("integral", "3/7")]),
    ("rotational-constant-k", [100, 14], &[("curvature", "2"), ("integral", "3/7")]),
    ("hex-minimal", [12, 14], &[]),
];

fn main() {
    let named: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    println!("family                           faces   making  proving   digits  (seconds)");
    for (name, size, given) in ROWS {
        if named.is_empty() || named.iter().any(|n| n == name) {
            row(Family::from_name(name).expect("a family"), size, given);
        }
    }
    if named.is_empty() || named.iter().any(|n| n == "christoffel") {
        christoffel([200, 200]);
    }
}

fn row(family: Family, size: [usize; 2], given: &[(&str, &str)]) {
    let given: Vec<_> = given.iter().map(|&(n, v)| (n.to_owned(), v.to_owned())).collect();
    let values = Values::new(family, &given).expect("parameters");
    let (making, member) = best(|| family.member(size, &values).expect("a member"));
    let (proving, ()) = best(|| prove(family, &member));
    let enclosed = if member.enclosure.is_some() { " enclosed" } else { "" };
    print(&format!("{}{enclosed}", family.name()), &member.surface, making, Some(proving));
}

/// The Christoffel dual of a Koebe mesh by its radii, every face and cycle closed exactly.
fn christoffel(size: [usize; 2]) {
    let family = Family::Enneper;
    let values = Values::new(family, &[]).expect("parameters");
    let member = family.member(size, &values).expect("a member");
    let gauss = member.gauss.expect("a Koebe mesh");
    let radii = &gauss.data.vertex[RADIUS];
    let (making, dual) = best(|| christoffel_by_radii(&gauss, radii).expect("a dual"));
    print("christoffel dual", &dual.mesh, making, None);
}

/// The shortest of three times, and the result.
fn best<T>(run: impl Fn() -> T) -> (f64, T) {
    let time = || {
        let start = Instant::now();
        let result = black_box(run());
        (start.elapsed().as_secs_f64(), result)
    };
    let first = time();
    (0..2).map(|_| time()).fold(first, |best, next| if next.0 < best.0 { next } else { best })
}

fn prove(family: Family, member: &Member) {
    let (alone, pair) = member.proves(family);
    let surface = &member.surface;
    let mut points = surface.points.clone();
    let start = VertexId(points.len() as u32);
    let radii = surface.data.vertex.get(RADIUS);
    let zero = Rational::zero;
    points.extend(radii.into_iter().flatten().map(|r| Point::new(r.clone(), zero(), zero())));
    let decider = Decider::of_rationals(&points);
    let mut net = Net::new(&surface.topology, &decider);
    if radii.is_some() {
        net = net.with_radii(start);
    }
    for property in alone {
        assert_eq!(net.check(property).verdict(), Verdict::Proved, "{property:?}");
    }
    let Some(gauss) = &member.gauss else { return };
    let points = [surface.points.as_slice(), &gauss.points].concat();
    let decider = Decider::of_rationals(&points);
    let couple = Couple::new(&surface.topology, &gauss.topology, &decider).expect("a pair");
    for property in pair {
        assert_eq!(couple.check(property).verdict(), Verdict::Proved, "{property:?}");
    }
}

fn print(name: &str, mesh: &Mesh<Rational>, making: f64, proving: Option<f64>) {
    let numbers = mesh.points.iter().flat_map(Point::coordinates);
    let digits = numbers.map(|x| x.denominator().to_string().len()).max().unwrap_or(0);
    let proving = proving.map_or("-".to_owned(), |t| format!("{t:.4}"));
    let faces = mesh.topology.face_count();
    println!("{name:<31}{faces:>7}{making:>9.4}{proving:>9}{digits:>9}");
}
