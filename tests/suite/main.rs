//! The one test binary: laws, values, files, reports, and the rules of the house.

#[cfg(feature = "cli")]
mod cli;
mod files;
mod meshes;
mod nets;
mod scalars;
mod space;
