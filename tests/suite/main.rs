//! The one test binary: laws, values, files, reports, and the rules of the house.

mod files;
mod meshes;
mod nets;
mod scalars;
mod space;
mod topology;
