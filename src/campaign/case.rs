//! One case: its name, how it fails, and a file that says it again without the generator.

use std::fmt;
use std::fmt::Write as _;
use std::str::FromStr;

use serde_json::{Value, json};

use super::instance::Parts;
use super::run::Runner;
use super::{Property, property};
use crate::claim::{self, Claim, Run, Seed, Stop};
use crate::mesh::Mesh;
use crate::mesh::file::{Format, Options, parse_fraction, read_bytes, write_string};
use crate::scalar::{Rational, RationalField, ReadAs, Ring};

/// How often a failing case of a law is made simpler.
const ATTEMPTS: usize = 4096;

/// A case by its name `property:seed:index`.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// The property.
    pub property: Property,
    /// The seed of the campaign.
    pub seed: Seed,
    /// The index in it.
    pub index: u64,
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.property.id(), self.seed, self.index)
    }
}

/// The text is no `property:seed:index`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoCase(&'static str);

impl fmt::Display for NoCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

impl std::error::Error for NoCase {}

impl FromStr for Case {
    type Err = NoCase;

    fn from_str(text: &str) -> Result<Self, NoCase> {
        let mut words = text.split(':');
        let (Some(id), Some(seed), Some(index), None) =
            (words.next(), words.next(), words.next(), words.next())
        else {
            return Err(NoCase("a case is property:seed:index, or a file"));
        };
        Ok(Case {
            property: property(id).ok_or(NoCase("there is no such property"))?,
            seed: seed.parse().map_err(|_| NoCase("the seed is none"))?,
            index: index.parse().map_err(|_| NoCase("the index is no number"))?,
        })
    }
}

impl Case {
    /// Runs it.
    ///
    /// # Errors
    /// Where it is excluded, or fails.
    pub fn run(&self) -> Run {
        Runner::new(self.property).run(self.seed, self.index, &mut Vec::new())
    }

    /// What it consists of, as it was drawn. Of a claim the numbers are that of the piece of evidence,
    /// the size, and the unknowns; the meshes are those that the evidence shows.
    pub fn parts(&self) -> Parts {
        match self.property {
            Property::Claim(claim) => {
                let instance = claim::Instance::new(claim, self.seed, self.index);
                instance.map_or_else(Parts::default, |instance| of_instance(claim, &instance))
            }
            Property::Law(law) => (law.cases)().parts(&self.seed.bytes(law.id, self.index)),
        }
    }

    /// How it fails, as it was drawn or made simpler; `None` where it does not fail.
    pub fn failure(&self, simpler: bool) -> Option<Failure> {
        let (parts, what) = match self.property {
            Property::Claim(claim) => of_claim(claim, self.seed, self.index, simpler)?,
            Property::Law(law) => {
                let attempts = if simpler { ATTEMPTS } else { 0 };
                (law.cases)().failure(&self.seed.bytes(law.id, self.index), attempts)?
            }
        };
        Some(Failure { case: *self, what, parts })
    }
}

fn of_instance(claim: &Claim, instance: &claim::Instance<'_>) -> Parts {
    let (evidence, size) = instance.place(claim);
    let mut numbers: Vec<_> = [evidence, size].map(|n| Rational::from_i64(n as i64)).into();
    let (unknowns, meshes) = instance.show();
    numbers.extend(unknowns);
    Parts { numbers, meshes }
}

fn of_claim(claim: &Claim, seed: Seed, index: u64, simpler: bool) -> Option<(Parts, String)> {
    let instance = claim::Instance::new(claim, seed, index)?;
    let failure = instance.failure(simpler)?;
    let place = [instance.place(claim).0, failure.size];
    let mut numbers: Vec<_> = place.map(|n| Rational::from_i64(n as i64)).into();
    numbers.extend(failure.unknowns.iter().filter_map(|text| parse_fraction(text).ok()));
    let meshes = failure.meshes.iter().filter_map(|(_, text)| mesh_of(text));
    Some((Parts { numbers, meshes: meshes.collect() }, failure.what))
}

fn mesh_of(text: &str) -> Option<Mesh<Rational>> {
    read_bytes("", Format::IsoJson, text.as_bytes()).ok()?.to_exact(ReadAs::Decimal).ok()
}

/// A case that fails, with all that it consists of.
#[derive(Clone, Debug)]
pub struct Failure {
    /// The case.
    pub case: Case,
    /// What fails.
    pub what: String,
    /// Its numbers and meshes, see [`Case::parts`].
    pub parts: Parts,
}

impl Failure {
    /// The failure as JSON, schema `isogeo.case/1`.
    pub fn to_json(&self) -> Value {
        let numbers: Vec<String> = self.parts.numbers.iter().map(Rational::to_string).collect();
        let mesh = |mesh: &Mesh<Rational>| {
            let text = write_string("", Format::IsoJson, mesh, &Options::default());
            text.ok().and_then(|(text, _)| serde_json::from_str::<Value>(&text).ok())
        };
        let meshes: Vec<Value> = self.parts.meshes.iter().filter_map(mesh).collect();
        json!({
            "schema": "isogeo.case/1",
            "property": self.case.property.id(),
            "seed": self.case.seed.to_string(),
            "index": self.case.index,
            "what": self.what,
            "numbers": numbers,
            "meshes": meshes,
        })
    }

    /// A failure from its JSON.
    ///
    /// # Errors
    /// What is missing or does not fit.
    pub fn from_json(text: &str) -> Result<Self, NoCase> {
        let value: Value = serde_json::from_str(text).map_err(|_| NoCase("the file is no JSON"))?;
        let text = |key: &str| value[key].as_str().ok_or(NoCase("the file is no isogeo.case/1"));
        if text("schema")? != "isogeo.case/1" {
            return Err(NoCase("the file is no isogeo.case/1"));
        }
        let seed = text("seed")?.parse().map_err(|_| NoCase("the seed is none"))?;
        let property = property(text("property")?).ok_or(NoCase("there is no such property"))?;
        let index = value["index"].as_u64().ok_or(NoCase("the index is no number"))?;
        let list = |key: &str| value[key].as_array().cloned().unwrap_or_default();
        let number = |v: &Value| parse_fraction(v.as_str()?).ok();
        let numbers = list("numbers").iter().map(number).collect::<Option<Vec<Rational>>>();
        let meshes = list("meshes").iter().map(|v| mesh_of(&v.to_string())).collect::<Option<_>>();
        let unfit = NoCase("a number or a mesh of the file cannot be read");
        let (numbers, meshes) = (numbers.ok_or(unfit.clone())?, meshes.ok_or(unfit)?);
        let case = Case { property, seed, index };
        Ok(Failure { case, what: text("what")?.into(), parts: Parts { numbers, meshes } })
    }

    /// Runs it again from its parts; `None` where they are not those of a case.
    pub fn again(&self) -> Option<Run> {
        match self.case.property {
            Property::Claim(claim) => {
                let [evidence, size, unknowns @ ..] = self.parts.numbers.as_slice() else {
                    return None;
                };
                let [evidence, size] =
                    [evidence, size].map(|n| usize::try_from(n.small_fraction()?.0).ok());
                let instance = claim::Instance::given(claim, evidence?, size?, unknowns.to_vec())?;
                Some(instance.run(|_| ()))
            }
            Property::Law(law) => (law.cases)().again(self.parts.clone()),
        }
    }

    /// A test to paste beside the law that it breaks.
    pub fn rust_test(&self) -> String {
        let (property, index) = (self.case.property.id(), self.case.index);
        let name: String =
            property.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
        let mut text = format!("#[test]\nfn {name}_{index}() {{\n");
        // Writing to a string does not fail.
        let _ = writeln!(text, "    // {}", self.what);
        let _ = writeln!(text, "    let case = r##\"{}\"##;", self.to_json());
        text.push_str("    assert_eq!(isogeo::campaign::holds(case), Ok(()));\n}\n");
        text
    }
}

/// Whether a case that failed once, as a file says it, holds now: for the test that keeps it so.
///
/// # Errors
/// What fails, or why the text is no case.
///
/// ```
/// use isogeo::campaign::{Case, holds};
/// let case: Case = "control-meshes-are-planar:2:0".parse()?;
/// let failure = case.failure(true).ok_or("it holds")?;
/// assert_eq!(failure.parts.meshes[0].topology.face_count(), 1);
/// assert_eq!(holds(&failure.to_json().to_string()), Err(failure.what));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn holds(case: &str) -> Result<(), String> {
    let failure = Failure::from_json(case).map_err(|why| why.to_string())?;
    match failure.again() {
        None => Err("these are not the parts of such a case".into()),
        Some(Err(Stop::Failed(why))) => Err(why.into_owned()),
        Some(Ok(()) | Err(Stop::Excluded(_))) => Ok(()),
    }
}
