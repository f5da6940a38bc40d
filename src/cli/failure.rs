//! Errors, shown with the place in the file.

use std::fmt;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError,
    MietteSpanContents, SourceCode, SourceSpan, SpanContents,
};

use super::arguments::Layout;
use super::output;
use crate::mesh::file::{FileError, Place};

/// Why a command could not do its work.
#[derive(Debug)]
pub struct Failure(Box<FileError>);

impl Failure {
    /// Wrong usage, in words.
    pub fn usage(message: impl Into<String>) -> Failure {
        Failure::coded("isogeo::usage", message, None)
    }

    /// Wrong usage, with advice.
    pub fn with_help(message: impl Into<String>, help: impl Into<String>) -> Failure {
        Failure::coded("isogeo::usage", message, Some(help.into()))
    }

    /// The system does not let us print.
    pub fn io(message: impl Into<String>) -> Failure {
        Failure::coded("isogeo::io", message, None)
    }

    fn coded(code: &str, message: impl Into<String>, help: Option<String>) -> Failure {
        Failure(Box::new(FileError {
            code: code.into(),
            message: message.into(),
            file: String::new(),
            place: None,
            label: String::new(),
            help,
        }))
    }

    /// Prints the error: to standard error for people, to standard output as JSON for programs.
    pub fn print(&self, layout: Layout) {
        if layout.is_json() && output::print_json(&self.json()).is_ok() {
            return;
        }
        let terminal = std::io::IsTerminal::is_terminal(&std::io::stderr());
        let colours = terminal && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty());
        let theme =
            if colours { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
        let mut text = String::new();
        let handler = GraphicalReportHandler::new_themed(theme).with_width(96);
        match handler.render_report(&mut text, &Shown::new(&self.0)) {
            Ok(()) => output::complain(&text),
            Err(_) => output::complain(&format!("{}\n", self.0)),
        }
    }

    fn json(&self) -> serde_json::Value {
        let error = &self.0;
        let place = error.place.as_deref();
        serde_json::json!({
            "schema": "isogeo.error/1",
            "code": &*error.code,
            "message": error.message,
            "file": (!error.file.is_empty()).then_some(&error.file),
            "line": place.map(|p| p.line),
            "column": place.map(|p| p.column),
            "offset": place.map(|p| p.span.start),
            "expected": (!error.label.is_empty()).then_some(&error.label),
            "help": error.help,
        })
    }
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Failure {
        Failure(Box::new(error))
    }
}

/// The error as miette shows it, with the line it speaks of.
#[derive(Debug)]
struct Shown<'a> {
    error: &'a FileError,
    line: Option<Line<'a>>,
}

impl<'a> Shown<'a> {
    fn new(error: &'a FileError) -> Self {
        let line = error.place.as_deref().map(|place| Line { file: &error.file, place });
        Shown { error, line }
    }
}

/// One line of a file, all that is left of it.
#[derive(Debug)]
struct Line<'a> {
    file: &'a str,
    place: &'a Place,
}

impl SourceCode for Line<'_> {
    fn read_span<'a>(
        &'a self,
        _: &SourceSpan,
        lines_before: usize,
        _: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let Place { line, column, excerpt, .. } = self.place;
        // Without context, the place itself is asked for.
        let column = if lines_before == 0 { column - 1 } else { 0 };
        let whole = SourceSpan::new(0.into(), excerpt.len());
        let name = self.file.to_owned();
        let bytes = excerpt.as_bytes();
        Ok(Box::new(MietteSpanContents::new_named(name, bytes, whole, line - 1, column, 1)))
    }
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let FileError { message, file, label, .. } = self.error;
        match &self.line {
            // Nothing is drawn below an empty line, not even the label.
            Some(line) if line.place.excerpt.is_empty() && !label.is_empty() => {
                write!(f, "{message}: {label}")
            }
            None if !file.is_empty() => write!(f, "{}", self.error),
            _ => write!(f, "{message}"),
        }
    }
}

impl std::error::Error for Shown<'_> {}

impl Diagnostic for Shown<'_> {
    fn code(&self) -> Option<Box<dyn fmt::Display + '_>> {
        Some(Box::new(&self.error.code))
    }

    fn help(&self) -> Option<Box<dyn fmt::Display + '_>> {
        self.error.help.as_ref().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.line.as_ref().map(|line| line as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let place = self.line.as_ref()?.place;
        let start = place.span.start.saturating_sub(place.excerpt_start).min(place.excerpt.len());
        let length = place.span.len().min(place.excerpt.len() - start);
        let label = (!self.error.label.is_empty()).then(|| self.error.label.clone());
        Some(Box::new(std::iter::once(LabeledSpan::new(label, start, length))))
    }
}
