//! Floor 5: pairs of meshes with the same combinatorics, and what exists only on them (Sec. 3.1, 4).
//!
//! | pair | corresponding | carries |
//! | --- | --- | --- |
//! | [`Parallel`] | edges are parallel | edge curvatures, corner curvatures |
//! | [`FParallel`] | face planes are parallel | curvatures at faces (17), offsets (18) |
//! | [`VParallel`] | vertices have the same top view | curvatures at vertices (22), edge weights |
//!
//! A curvature is never one of a mesh M alone: it is one of M and a mesh S that stands for its Gauss
//! image, and another S gives another curvature. Each constructor checks exactly that the meshes fit
//! and otherwise names the element and the residual: [`Misfit`].
//!
//! What pair two meshes are, rounded ones too, is asked of a [`Couple`]: verdicts on
//! [`PairProperty`], with the worst element.
//!
//! The meshes parallel and v-parallel to a given one form linear spaces: [`linear_space`].
//!
//! All forms are kept four times as large ([`Forms`]), so that they need no division.

mod area;
mod cleared;
mod cotangent;
mod curvature;
mod edge;
pub(crate) mod element;
mod exact;
mod f_parallel;
mod face;
mod forms;
mod lifted;
pub mod linear_space;
mod misfit;
mod offset;
mod parallel;
mod property;
mod residual;
mod roots;
mod star;
mod total;
mod units;
mod v_parallel;
mod vertex;
mod weight;

pub use area::{Corner, four_mixed_areas, twice_area};
pub use cotangent::{cotangent, cotangent_weight};
pub use curvature::Curvatures;
pub use edge::EdgeUndefined;
pub use exact::ExactPair;
pub use f_parallel::FParallel;
pub use face::{FaceForms, ZeroArea, face_curvatures};
pub use forms::Forms;
pub use lifted::{LiftedForms, NoTriangle};
pub use misfit::{Misfit, Which};
pub use offset::{OffsetLaw, OffsetResiduals};
pub use parallel::Parallel;
pub use property::{Couple, PairProperty};
pub use residual::{MixedArea, ParallelEdges, ParallelPlanes, SameCurvature};
pub use roots::Roots;
use star::star_forms_widened;
pub use star::{Ray, star_forms};
pub use total::TotalForms;
pub use v_parallel::VParallel;
pub use vertex::{VertexForms, VertexUndefined};
pub use weight::StarEdge;
