//! What a file says of an exact mesh near its own, and whether it is so.

use std::cell::OnceCell;

use super::input::Input;
use crate::net::Property;
use crate::scalar::Rational;

/// What became of a certificate of existence: the radius and words, or why it is not verified.
pub type Verified = Result<(Rational, String), String>;

/// The certificate of existence of a mesh, verified when it is first asked for.
pub struct Existence<'a> {
    input: &'a Input,
    verified: OnceCell<Verified>,
}

impl<'a> Existence<'a> {
    /// The certificate of a mesh, if there is one.
    pub fn new(input: &'a Input) -> Self {
        Existence { input, verified: OnceCell::new() }
    }

    /// What the certificate says of a property, if it speaks of it.
    #[cfg(feature = "optimise")]
    pub fn of(&self, property: Property) -> Option<Verified> {
        use crate::optimise::Goal;
        use crate::optimise::existence::Certificate;
        let claim = self.input.file.certificate.as_ref()?.get(Certificate::NAME)?;
        let certificate = match Certificate::read(claim) {
            Ok(certificate) => certificate,
            Err(why) => {
                let can_be_certified = Goal::ALL.iter().any(|goal| goal.property() == property);
                return can_be_certified.then(|| Err(why.to_string()));
            }
        };
        let verify = || {
            let mesh = self.input.exact();
            let proved = certificate.verify(&mesh.topology, &mesh.points);
            proved.map_err(|why| why.to_string())?;
            Ok((certificate.radius.clone(), super::certify::in_words(&certificate)))
        };
        certificate.covers(property).then(|| self.verified.get_or_init(verify).clone())
    }

    /// Nothing is verified without optimisation.
    #[cfg(not(feature = "optimise"))]
    pub fn of(&self, _: Property) -> Option<Verified> {
        let claim = self.input.file.certificate.as_ref()?.get("existence");
        let why = || Err("this program was built without optimisation".to_owned());
        claim.map(|_| self.verified.get_or_init(why).clone())
    }
}
