//! Floor 7: random meshes made by construction, for property tests with [`proptest`] (feature
//! `strategies`).
//!
//! | strategy | gives | shrinks to |
//! | --- | --- | --- |
//! | [`small`], [`fraction`], [`number`] | rational numbers: many coincidences, few, both | 0, integers |
//! | [`combinatorics`], [`any_mesh`] | faces of all kinds, without any property | one triangle |
//! | [`quad_patches`], [`polygons`] | planar meshes: quads, n-gons of any size | one face |
//! | [`translational`], [`cauchy`], [`factorised`], [`circular`] | i-circular meshes | one face |
//! | [`conical`] | i-conical meshes | the star of one vertex |
//! | [`koebe`] | i-Koebe meshes with their radii | one face |
//! | [`i_minimal`], [`f_parallel`], [`v_parallel`] | a mesh with its Gauss image | one face, one star |
//! | [`star`], [`lattice`], [`jittered`], [`delaunay_graph`] | triangle meshes | one star, two triangles |
//! | [`rotation`], [`motion`], [`scaling`], [`moebius`], [`laguerre`] | transformations | the identity |
//! | [`near_degenerate`] | a mesh with something degenerate, or almost | the mesh |
//! | [`broken`] | faces that form no mesh | one or two faces |
//!
//! All numbers are rational, in whatever exact type is asked for. What a strategy promises holds for
//! every value, and for every value that it shrinks to: rows and columns are cut off before numbers
//! are made simpler, so that what is left of a failure can be drawn by hand.
//!
//! ```
//! use isogeo::check::{Plain, Verdict};
//! use isogeo::net::{Net, Property};
//! use isogeo::scalar::Rational;
//! use isogeo::strategy::conical;
//! use proptest::test_runner::{Config, TestRunner};
//! let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(16) });
//! runner.run(&conical::<Rational>(), |mesh| {
//!     let report = Net::new(&mesh.topology, &Plain(&mesh.points)).check(Property::IConical);
//!     proptest::prop_assert_eq!(report.verdict(), Verdict::Proved);
//!     Ok(())
//! })?;
//! # Ok::<(), proptest::test_runner::TestError<isogeo::mesh::Mesh<Rational>>>(())
//! ```

mod broken;
mod circular;
mod combinatorics;
mod conical;
mod koebe;
mod near;
mod number;
mod pair;
mod planar;
mod transformation;
mod triangles;

pub use broken::{Broken, Defect, broken};
pub use circular::{cauchy, circular, factorised, i_minimal, translational};
pub use combinatorics::{any_mesh, combinatorics, relabelled};
pub use conical::conical;
pub use koebe::koebe;
pub use near::near_degenerate;
pub use number::{fraction, nonzero, number, proper, small};
pub use pair::{f_parallel, v_parallel};
pub use planar::{polygons, quad_patches};
pub use transformation::{laguerre, moebius, motion, rotation, scaling};
pub use triangles::{delaunay_graph, jittered, lattice, star};
