//! The report: a head for programs, a summary for people.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use serde_json::json;

use super::row::Short;
use super::summary::Summary;
use crate::cli::input::Input;
use crate::cli::words;
use crate::pair::element::{At, Undefined};

/// What is said of all elements together.
pub struct Report {
    at: At,
    remark: Option<String>,
    elements: usize,
    /// Of H and of K.
    summaries: [Summary; 2],
    complex: Places,
    reversed: Places,
    undefined: BTreeMap<&'static str, Places>,
}

/// How many elements, and the first of them.
#[derive(Default)]
struct Places {
    count: usize,
    first: usize,
}

impl Places {
    fn add(&mut self, index: usize) {
        if self.count == 0 {
            self.first = index;
        }
        self.count += 1;
    }
}

impl Report {
    /// A report of no elements yet.
    pub fn new(at: At, remark: Option<String>) -> Self {
        Report {
            at,
            remark,
            elements: 0,
            summaries: Default::default(),
            complex: Places::default(),
            reversed: Places::default(),
            undefined: BTreeMap::new(),
        }
    }

    /// Adds one more element.
    pub fn add(&mut self, index: usize, found: &Result<Short, Undefined>) {
        self.elements += 1;
        match found {
            Ok(short) => {
                for (i, summary) in self.summaries.iter_mut().enumerate() {
                    summary.add(short.values[i], short.signs[i]);
                }
                if short.complex {
                    self.complex.add(index);
                }
                if short.reversed {
                    self.reversed.add(index);
                }
            }
            Err(undefined) => self.undefined.entry(undefined.kind).or_default().add(index),
        }
    }

    /// All that comes before the values: the list is as long as the mesh and printed as it comes.
    pub fn json_head(&self, input: &Input, image: &str, output: Option<&Path>) -> String {
        let schema = json!("isogeo.curvature/1");
        let head = json!({
            "at": self.at.name(),
            "file": input.file.name,
            "image": image,
            "output": output.map(|path| path.display().to_string()),
            "read_as": input.read_as.name(),
            "remark": self.remark,
        });
        let head = head.to_string();
        let fields = head.trim_start_matches('{').trim_end_matches('}');
        format!("{{\"schema\":{schema},{fields},\n\"values\":[")
    }

    /// The summary.
    pub fn text(self, input: &Input, image: &str) -> String {
        let (equation, noun) = match self.at {
            At::Faces => ("(17)", "face"),
            At::Vertices => ("(22)", "vertex"),
        };
        let counted = |n: usize| match self.at {
            At::Faces => words::count(n, noun),
            At::Vertices => words::vertices(n),
        };
        let undefined: usize = self.undefined.values().map(|p| p.count).sum();
        let mut text = format!(
            "{}: curvatures {equation} at {} of {}; Gauss image: {image}\n",
            input.file.name,
            self.elements - undefined,
            counted(self.elements),
        );
        for (name, summary) in ["H", "K"].into_iter().zip(self.summaries) {
            if let Some(line) = summary.line() {
                let _ = writeln!(text, "  {name}  {line}");
            }
        }
        let mut places = |places: &Places, what: &str| {
            if places.count > 0 {
                let first = places.first;
                let _ = writeln!(text, "  {} {what}; first: {noun} {first}", counted(places.count));
            }
        };
        places(&self.complex, "with H² < K: no real principal curvatures");
        places(&self.reversed, "where the image is turned over and says nothing of shape");
        for (kind, found) in &self.undefined {
            places(found, &format!("undefined, {kind}"));
        }
        if let Some(remark) = self.remark {
            let _ = writeln!(text, "  {remark}");
        }
        text
    }
}
