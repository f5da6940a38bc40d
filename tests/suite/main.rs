//! The one test binary: laws, values, files, reports, and the rules of the house.

#[cfg(feature = "campaigns")]
mod campaigns;
mod circle_pattern;
mod claims;
#[cfg(feature = "cli")]
mod cli;
mod edge_offset;
mod elimination;
mod examples;
mod figures;
mod files;
#[cfg(feature = "optimise")]
mod frozen;
mod house;
mod incircles;
mod linear_space;
mod meshes;
mod nets;
#[cfg(feature = "optimise")]
mod optimise;
mod pages;
mod pairs;
#[cfg(feature = "png")]
mod png;
mod proofs;
mod scalars;
mod space;
mod strategies;
mod subdivision;
mod theory;
mod topology;
mod transfer;
mod triangulate;
mod vtu;
