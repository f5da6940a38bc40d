//! The scalar that records: every operation on it is written down, with the place in the source
//! that asked for it.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};
use std::panic::Location;

use super::{Branch, Instruction, NodeId, Outcome, Program};
use crate::scalar::{Field, Ordered, Rational, Ring, Sign};

thread_local! {
    static TAPE: RefCell<Program> = RefCell::new(Program::default());
}

/// An unknown, or what was computed from unknowns.
///
/// It is a node of the program that [`record`] writes down. Every symbol has a *shadow*, its value
/// at one rational place: `==`, [`is_zero`](Ring::is_zero) and the order answer from the shadow,
/// and the answer is recorded as a [`Branch`]. "Not zero" is then right for the rational function,
/// too, since one place shows it; "zero" is an obligation that whoever uses the program has to prove.
///
/// A symbol belongs to the recording, and to the thread, in which it was made.
///
/// ```
/// use isogeo::pair::twice_area;
/// use isogeo::scalar::{NormalForms, Rational, Ring, Symbol, record};
/// use isogeo::space::{TopView, Vector2};
/// // The area of a triangle does not depend on where it lies.
/// let (difference, program) = record(|| {
///     let mut unknown = (1..).map(|n| Symbol::unknown(Rational::from_i64(n)));
///     let mut two = || Some([unknown.next()?, unknown.next()?]);
///     let triangle = [two()?, two()?, two()?].map(|[x, y]| TopView::new(x, y));
///     let [x, y] = two()?;
///     let moved = triangle.each_ref().map(|corner| corner + &Vector2::new(x, y));
///     Some(twice_area(&moved) - twice_area(&triangle))
/// });
/// let node = difference.expect("points").node();
/// assert!(NormalForms::of(&program, &[node])?.quotient(node).is_some_and(|q| q.is_zero()));
/// # Ok::<(), isogeo::scalar::TooLarge>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Symbol(NodeId);

/// Runs `run` and gives its result and all that it did on [`Symbol`]s.
///
/// Recordings may be nested; symbols of one mean nothing in another.
pub fn record<R>(run: impl FnOnce() -> R) -> (R, Program) {
    let outer = TAPE.with(|tape| std::mem::take(&mut *tape.borrow_mut()));
    let result = run();
    (result, TAPE.with(|tape| std::mem::replace(&mut *tape.borrow_mut(), outer)))
}

impl Symbol {
    /// A new unknown with a shadow.
    #[track_caller]
    pub fn unknown(shadow: Rational) -> Self {
        let place = Location::caller();
        TAPE.with(|tape| Symbol(tape.borrow_mut().push_unknown(shadow, place)))
    }

    /// A new unknown with the shadow of this symbol: how it was computed is forgotten.
    #[track_caller]
    pub fn forgotten(self) -> Self {
        Symbol::unknown(self.shadow())
    }

    /// Its node in the program.
    pub fn node(self) -> NodeId {
        self.0
    }

    /// Its value at the place of the shadows.
    pub fn shadow(self) -> Rational {
        TAPE.with(|tape| tape.borrow().shadow(self.0).clone())
    }

    fn push(instruction: Instruction, place: &'static Location<'static>) -> Self {
        TAPE.with(|tape| Symbol(tape.borrow_mut().push(instruction, place)))
    }

    fn decide(self, place: &'static Location<'static>, ordered: bool) -> Sign {
        TAPE.with(|tape| {
            let mut tape = tape.borrow_mut();
            let sign = tape.shadow(self.0).certain_sign().unwrap_or(Sign::Zero);
            let outcome = match sign {
                Sign::Zero => Outcome::Zero,
                sign if ordered => Outcome::Sign(sign),
                _ => Outcome::NotZero,
            };
            tape.push_branch(Branch { node: self.0, outcome, place });
            sign
        })
    }
}

macro_rules! operator {
    ($Trait:ident, $method:ident) => {
        operator!($Trait, $method, Symbol, Symbol);
        operator!($Trait, $method, Symbol, &Symbol);
        operator!($Trait, $method, &Symbol, Symbol);
        operator!($Trait, $method, &Symbol, &Symbol);
    };
    ($Trait:ident, $method:ident, $Left:ty, $Right:ty) => {
        impl $Trait<$Right> for $Left {
            type Output = Symbol;
            #[track_caller]
            fn $method(self, other: $Right) -> Symbol {
                Symbol::push(Instruction::$Trait(self.0, other.0), Location::caller())
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Symbol {
    type Output = Symbol;
    #[track_caller]
    fn neg(self) -> Symbol {
        Symbol::push(Instruction::Neg(self.0), Location::caller())
    }
}

impl Neg for &Symbol {
    type Output = Symbol;
    #[track_caller]
    fn neg(self) -> Symbol {
        -*self
    }
}

impl AddAssign<&Symbol> for Symbol {
    #[track_caller]
    fn add_assign(&mut self, other: &Symbol) {
        *self = *self + other;
    }
}

impl SubAssign<&Symbol> for Symbol {
    #[track_caller]
    fn sub_assign(&mut self, other: &Symbol) {
        *self = *self - other;
    }
}

impl PartialEq for Symbol {
    #[track_caller]
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0 || (self - other).is_zero()
    }
}

impl PartialOrd for Symbol {
    #[track_caller]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(match (self - other).decide(Location::caller(), true) {
            Sign::Negative => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
        })
    }
}

impl Ring for Symbol {
    const EXACT: bool = true;

    #[track_caller]
    fn from_i64(n: i64) -> Self {
        Symbol::push(Instruction::Constant(n), Location::caller())
    }

    #[track_caller]
    fn zero() -> Self {
        Self::from_i64(0)
    }

    #[track_caller]
    fn one() -> Self {
        Self::from_i64(1)
    }

    #[track_caller]
    fn is_zero(&self) -> bool {
        self.decide(Location::caller(), false) == Sign::Zero
    }

    #[track_caller]
    fn square(&self) -> Self {
        self * self
    }

    #[track_caller]
    fn det2(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        a * d - b * c
    }

    #[track_caller]
    fn dot<const N: usize>(a: [&Self; N], b: [&Self; N]) -> Self {
        let mut sum = None;
        for (x, y) in a.into_iter().zip(b) {
            let product = x * y;
            sum = Some(sum.map_or(product, |sum: Symbol| sum + product));
        }
        match sum {
            Some(sum) => sum,
            None => Self::zero(),
        }
    }
}

impl Field for Symbol {
    #[track_caller]
    fn try_inv(&self) -> Option<Self> {
        Symbol::one().try_div(self)
    }

    /// `None` where the shadow of `other` is zero, and that is recorded as a branch.
    #[track_caller]
    fn try_div(&self, other: &Self) -> Option<Self> {
        if other.shadow().is_zero() {
            other.decide(Location::caller(), false);
            return None;
        }
        Some(self / other)
    }
}

impl Ordered for Symbol {
    #[track_caller]
    fn certain_sign(&self) -> Option<Sign> {
        Some(self.decide(Location::caller(), true))
    }
}
