//! What the parser of arguments has to say: help, the version, or wrong usage.

use std::env;

use clap::error::Error;

use super::arguments::Layout;
use super::failure::Failure;
use super::{Status, output};

/// Prints help and complaints as the parser words them; wrong usage is a [`Failure`] if JSON is
/// asked for.
pub fn answer(error: &Error) -> (Layout, Result<Status, Failure>) {
    if !error.use_stderr() {
        // Keeps the colours that a terminal can show.
        let printed = error.print().or_else(|e| match e.kind() {
            std::io::ErrorKind::BrokenPipe => Ok(()),
            _ => Err(Failure::io(format!("the help cannot be printed: {e}"))),
        });
        (Layout::Text, printed.map(|()| Status::Proved))
    } else if asks_for_json() {
        (Layout::Json, Err(failure(&error.render().to_string())))
    } else {
        if error.print().is_err() {
            output::complain(&error.render().to_string());
        }
        (Layout::Text, Ok(Status::BadInput))
    }
}

/// Whether the arguments, wrong as they are, contain `--format json`.
fn asks_for_json() -> bool {
    let arguments: Vec<_> = env::args_os().collect();
    let pair = |pair: &[_]| pair[0] == "--format" && pair[1] == "json";
    arguments.windows(2).any(pair) || arguments.iter().any(|a| a == "--format=json")
}

/// The first paragraph is the message, the others are advice.
fn failure(text: &str) -> Failure {
    let mut paragraphs = text.split("\n\n").map(|p| {
        let words: Vec<&str> = p.split_whitespace().collect();
        words.join(" ")
    });
    let message = paragraphs.next().unwrap_or_default();
    let help: Vec<String> = paragraphs.filter(|p| !p.is_empty()).collect();
    Failure::with_help(message.trim_start_matches("error: "), help.join("; "))
}
