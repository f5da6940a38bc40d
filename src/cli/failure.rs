//! Errors, shown with the place in the file.

use std::fmt;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource, SourceCode,
};

use super::arguments::Layout;
use super::output;
use crate::mesh::file::FileError;

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
        let handler =
            GraphicalReportHandler::new_themed(theme).with_width(96).with_context_lines(0);
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
    source: Option<NamedSource<String>>,
}

impl<'a> Shown<'a> {
    fn new(error: &'a FileError) -> Self {
        // Empty lines before the excerpt make miette count to its line.
        let source = error.place.as_deref().filter(|p| p.line <= MAX_LINES).map(|p| {
            let text = "\n".repeat(p.line - 1) + &p.excerpt;
            NamedSource::new(&error.file, text)
        });
        Shown { error, source }
    }
}

/// Beyond this line the place is named but the line is not shown.
const MAX_LINES: usize = 10_000_000;

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.source, self.error.file.as_str()) {
            (Some(_), _) | (None, "") => write!(f, "{}", self.error.message),
            (None, _) => write!(f, "{}", self.error),
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
        self.source.as_ref().map(|s| s as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let place = self.error.place.as_deref()?;
        let source = self.source.as_ref()?;
        let start = place.span.start.saturating_sub(place.excerpt_start).min(place.excerpt.len());
        let length = place.span.len().min(place.excerpt.len() - start);
        let label = (!self.error.label.is_empty()).then(|| self.error.label.clone());
        let offset = source.inner().len() - place.excerpt.len() + start;
        Some(Box::new(std::iter::once(LabeledSpan::new(label, offset, length))))
    }
}
