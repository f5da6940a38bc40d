//! Floor 7: optimisation in doubles, and the way back to exact meshes.

mod cholesky;
mod condition;
mod goal;
mod gradient;
mod mobility;
mod normal;
mod projection;
mod report;
mod system;

pub use cholesky::NoFactor;
pub use condition::{Conditions, Everywhere, MOST_POINTS};
pub use goal::Goal;
pub use gradient::{Differentiable, by_dual_numbers};
pub use mobility::Mobility;
pub use projection::Projection;
pub use report::{Ending, Step, Worst};
pub use system::{Linearisation, System};
