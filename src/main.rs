//! The `isogeo` command.

fn main() {}
