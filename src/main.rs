//! The `isogeo` command.

use std::process::ExitCode;

fn main() -> ExitCode {
    isogeo::cli::main()
}
