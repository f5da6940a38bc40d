//! Floor 10: the command line. Parse, one call of the library, print, exit code; no geometry.

mod accuracy;
mod arguments;
#[cfg(feature = "optimise")]
mod certify;
mod check;
mod christoffel;
mod claims;
mod convert;
mod curvature;
mod dual;
mod existence;
mod failure;
mod figure;
#[cfg(feature = "campaigns")]
mod fuzz;
mod gauss;
mod info;
mod input;
#[cfg(any(feature = "optimise", feature = "campaigns"))]
mod interruption;
mod inversion;
mod koebe;
mod make;
mod memory;
#[cfg(feature = "campaigns")]
mod merge;
mod motion;
mod numbers;
mod offset;
#[cfg(feature = "optimise")]
mod optimize;
mod output;
#[cfg(feature = "campaigns")]
mod replay;
mod subdivide;
mod transfer;
mod triangulate;
mod usage;
mod view;
mod words;

use std::process::ExitCode;

use clap::{CommandFactory, Parser};

use arguments::{Arguments, Command, Layout};
use failure::Failure;

/// What a command found, as an exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Status {
    /// Everything asked for is proved.
    Proved,
    /// Something is refuted.
    Refuted,
    /// The input or the usage is wrong.
    BadInput,
    /// Nothing refuted, but not everything proved.
    Open,
    /// Somebody pressed Ctrl-C.
    #[cfg(any(feature = "optimise", feature = "campaigns"))]
    Interrupted,
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> ExitCode {
        ExitCode::from(match status {
            Status::Proved => 0,
            Status::Refuted => 1,
            Status::BadInput => 2,
            Status::Open => 3,
            #[cfg(any(feature = "optimise", feature = "campaigns"))]
            Status::Interrupted => 130,
        })
    }
}

const FIRST_STEPS: &str = "\
isogeo checks discrete surfaces in isotropic geometry, exactly.

  isogeo check roof.obj                      what the mesh is, with a verdict for every property
  isogeo check roof.obj --is planar          exit code 0 only if that is proved
  isogeo info roof.obj                       counts, valences, boundary, digits

`isogeo --help` lists all commands, `isogeo COMMAND --help` explains one with an example.
";

/// Runs the program on the arguments of the process.
pub fn main() -> ExitCode {
    if std::env::args_os().len() <= 1 {
        output::complain(FIRST_STEPS);
        return Status::BadInput.into();
    }
    let (layout, result) = match Arguments::try_parse() {
        Ok(arguments) => (arguments.format, run(arguments)),
        Err(error) => usage::answer(&error),
    };
    let status = result.unwrap_or_else(|failure| {
        failure.print(layout);
        Status::BadInput
    });
    status.into()
}

fn run(arguments: Arguments) -> Result<Status, Failure> {
    let layout = arguments.format;
    match arguments.command {
        Command::Check(options) => check::run(&options, layout),
        Command::Info(options) => info::run(&options, layout),
        Command::Convert(options) => convert::run(&options, layout),
        Command::Dual(options) => dual::run(&options, layout),
        Command::Curvature(options) => curvature::run(&options, layout),
        Command::Gauss(options) => gauss::run(&options, layout),
        Command::Offset(options) => offset::run(&options, layout),
        Command::Christoffel(options) => christoffel::run(&options, layout),
        Command::Make(options) => make::run(&options, layout),
        Command::Move(options) => motion::run(&options, layout),
        Command::Invert(options) => inversion::run(&options, layout),
        Command::Transfer(options) => transfer::run(&options, layout),
        Command::Subdivide(options) => subdivide::run(&options, layout),
        Command::Triangulate(options) => triangulate::run(&options, layout),
        Command::Accuracy(options) => accuracy::run(&options, layout),
        Command::Claims(options) => claims::run(&options, layout),
        #[cfg(feature = "campaigns")]
        Command::Fuzz(options) => fuzz::run(&options, layout),
        #[cfg(feature = "campaigns")]
        Command::Merge(options) => merge::run(&options, layout),
        #[cfg(feature = "campaigns")]
        Command::Replay(options) => replay::run(&options, layout),
        #[cfg(feature = "optimise")]
        Command::Certify(options) => certify::run(&options, layout),
        #[cfg(feature = "optimise")]
        Command::Optimize(options) => optimize::run(&options, layout),
        Command::Figure(options) => figure::run(&options, layout),
        Command::View(options) => view::run(&options, layout),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "isogeo", &mut script);
            output::print_bytes(&script)?;
            Ok(Status::Proved)
        }
        Command::Man => {
            output::print_bytes(&manual()?)?;
            Ok(Status::Proved)
        }
    }
}

/// The manual page, one section for each command.
fn manual() -> Result<Vec<u8>, Failure> {
    let mut command = Arguments::command();
    command.build();
    let mut page = Vec::new();
    let render = |command: clap::Command, page: &mut Vec<u8>| {
        clap_mangen::Man::new(command).render(page).map_err(|e| Failure::usage(e.to_string()))
    };
    render(command.clone(), &mut page)?;
    for sub in command.get_subcommands().filter(|c| c.get_name() != "help") {
        render(sub.clone(), &mut page)?;
    }
    Ok(page)
}

/// The layout of reports.
impl Layout {
    fn is_json(self) -> bool {
        self == Layout::Json
    }
}
