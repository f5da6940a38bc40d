//! The one test binary: laws, values, files, reports, and the rules of the house.

mod examples;
mod files;
mod house;
mod meshes;
mod nets;
mod scalars;
mod space;
mod triangulate;
