//! The meshes of figures that an optimisation produced: it runs again and finds them.

use isogeo::check::{Decider, Verdict};
use isogeo::mesh::file::read;
use isogeo::net::{Net, Property};
use isogeo::optimise::{Goal, Movement, mean_edge};
use isogeo::scalar::{Approx, ReadAs};

#[path = "../../examples/frozen.rs"]
mod recipes;

/// How far a frozen mesh may be from what the optimisation finds, in mean edges: rounding has a
/// hundredth, other machines the rest.
const NEAR: f64 = 1.0 / 64.0;

#[test]
fn the_optimisation_finds_the_frozen_meshes_again() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/figure/frozen");
    for recipe in &recipes::RECIPES {
        let levels = recipe.levels().expect("an optimisation");
        for (name, [before, found]) in recipe.names.iter().rev().zip(levels.iter().rev()) {
            let file = read(folder.join(format!("{name}.iso.json"))).expect(name);
            let frozen = file.to_exact(ReadAs::Decimal).expect(name);
            assert_eq!(frozen.topology, found.topology, "{name}");
            let property = match recipe.goal {
                Goal::ICircular => Property::ICircular,
                _ => Property::IConical,
            };
            let decider = Decider::of_rationals(&frozen.points);
            let verdict = Net::new(&frozen.topology, &decider).check(property).verdict();
            assert_eq!(verdict, Verdict::Proved, "{name}");
            let frozen = frozen.map(Approx::to_f64);
            let edge = mean_edge(&found.topology, &found.points);
            let distance = |points| Movement::between(&frozen.points, points).largest / edge;
            let (rerun, control) = (distance(&found.points), distance(&before.points));
            assert!(rerun < NEAR, "{name}: {rerun} edges");
            // What was only subdivided is farther.
            assert!(control > NEAR, "{name}: {control} edges before the optimisation");
        }
    }
}
