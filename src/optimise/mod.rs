//! Floor 7: optimisation in doubles, and the way back to exact meshes.

mod angle;
mod cholesky;
mod compromise;
mod condition;
mod design;
mod energy;
pub mod existence;
mod frame;
mod goal;
mod gradient;
mod mobility;
mod normal;
mod polynomial;
mod prescribed;
mod projection;
pub mod rationalise;
mod report;
mod system;
mod target;

pub use angle::{AnglesAround, AnglesInSpace, OppositeAngles};
pub use cholesky::NoFactor;
pub use compromise::Compromise;
pub use condition::{Conditions, Everywhere, MOST_POINTS};
pub use design::{Design, Designed, Method, Movement, mean_edge};
pub use energy::{Closeness, Shape, fairness};
pub use frame::Frame;
pub use goal::Goal;
pub use gradient::{Differentiable, by_dual_numbers};
pub use mobility::Mobility;
pub use polynomial::Polynomial;
pub use prescribed::{Each, FaceMean, VertexMean, f_parallel, face_means, vertex_means};
pub use projection::Projection;
pub use report::{Ending, Stage, Step, Worst};
pub use system::{Linearisation, System};
pub use target::{Target, VerticalDistance};
