//! Discrete surfaces in isotropic geometry, checked exactly.
//!
//! This crate implements H. Pottmann and Y. Liu, *Discrete Surfaces in Isotropic Geometry* (2007);
//! equation numbers are those of the paper, and [`notation`] maps its symbols to items.
//!
//! # Conventions
//!
//! - The z-axis is the isotropic direction and points up. The *top view* of `(x, y, z)` is `(x, y)`.
//! - The unit i-sphere Σ is `2 z = x² + y²` (5).
//! - Metric duality sends the point `(p₁, p₂, p₃)` to the plane `z = p₁ x + p₂ y − p₃`: the sign of the
//!   height changes. It is an involution, and a plane touches Σ iff its pole lies on it.
//! - i-distance and i-angle are kept squared, so that no root is taken.
//! - Faces are oriented; the signed area of a top view is positive if it runs counter-clockwise.
//!
//! # Modules, from below
//!
//! | module | what is there |
//! | --- | --- |
//! | [`scalar`] | numbers: everything above is generic over them |
//! | [`space`] | isotropic 3-space: points, planes, duality, spheres, circles, motions; Laguerre geometry |
//! | [`mesh`] | combinatorics without coordinates, data on elements, files |
//! | [`check`] | from residuals to verdicts |
//! | [`net`] | classes of mesh: planar, i-circular, i-conical, ... |
//! | [`pair`] | pairs of meshes: parallel, f-parallel, v-parallel; curvatures, linear spaces |
//! | [`construct`] | exact families, circle patterns, metric and Christoffel duals, Gauss images, images in Euclidean space, subdivision, Delaunay meshes of samples |
//! | `strategy` (feature) | random meshes made by construction, for property tests |
//! | `optimise` (feature) | meshes that are moved until they are in a class; exact meshes near them, and proofs that there are |
//! | [`claim`] | the ledger: what the paper claims, decided for all inputs |
//! | `campaign` (feature) | laws and claims on millions of random cases |
//!
//! # Example
//!
//! ```
//! use isogeo::check::{Decider, Verdict};
//! use isogeo::mesh::file::{Coordinates, Format, read_bytes};
//! use isogeo::net::{Net, Property};
//! // A trapezoid with its plane and its circle, and four decimals to say so.
//! let obj = b"v -2 0 1.5\nv 2 0 1.5\nv 1 1 0.25\nv -1 1 0.25\nf 1 2 3 4\n";
//! let file = read_bytes("trapezoid.obj", Format::Obj, obj)?;
//! if let Coordinates::Numerals(mesh) = &file.coordinates {
//!     let decider = Decider::new(&mesh.points);
//!     let net = Net::new(&mesh.topology, &decider);
//!     assert_eq!(net.check(Property::Planar).verdict(), Verdict::Proved);
//!     assert_eq!(net.check(Property::ICircular).verdict(), Verdict::Proved);
//! }
//! # Ok::<(), isogeo::mesh::file::FileError>(())
//! ```

#[cfg(feature = "campaigns")]
pub mod campaign;
pub mod check;
pub mod claim;
#[cfg(feature = "cli")]
pub mod cli;
pub mod construct;
pub mod figure;
pub mod mesh;
pub mod net;
#[cfg(feature = "optimise")]
pub mod optimise;
pub mod pair;
pub mod scalar;
pub mod space;
#[cfg(feature = "strategies")]
pub mod strategy;

#[doc = include_str!("../docs/notation.md")]
pub mod notation {}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
