//! Sec. 4: curvatures at faces, edges and vertices, Christoffel duals, i-minimal meshes.

mod accuracy;
mod airy;
mod christoffel;
mod curvature;
mod edge;
mod lines;
mod minimal;
mod minkowski;
mod packing;
mod quads;
mod rotational;
mod stars;
mod stress;
mod vertex;

use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};

/// The claims, in the order of the paper.
pub(super) const CLAIMS: &[&[Claim]] = &[
    curvature::CLAIMS,
    minkowski::CLAIMS,
    quads::CLAIMS,
    christoffel::CLAIMS,
    minimal::CLAIMS,
    lines::CLAIMS,
    airy::CLAIMS,
    rotational::CLAIMS,
    vertex::CLAIMS,
    stress::CLAIMS,
    edge::CLAIMS,
    accuracy::CLAIMS,
];
