//! Start values of bodies, and which of them assembly must not change.

use core::fmt;

use crate::scalar::Scalar;
use crate::vector::Vector;

/// A start value, and whether assembly must keep it.
#[derive(Clone, Copy, Debug)]
pub struct Start<S> {
    /// The value, SI units.
    pub value: S,
    /// True if assembly leaves the value unchanged (a lock); false if it may move it to close the joints.
    pub locked: bool,
    /// Made by the declaration: it follows the parameters that it reads, unless another value was set.
    is_declared: bool,
}

impl<S: PartialEq> PartialEq for Start<S> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value && self.locked == other.locked
    }
}

/// The values of starts.
// A function of nothing but numbers: one for all mechanisms of a size.
pub(crate) fn values<S: Scalar, const N: usize>(starts: &[Start<S>; N]) -> [S; N] {
    Vector::from_fn(|k| starts[k].value)
}

/// 0 where a start is locked, else 1.
pub(crate) fn freedoms<S: Scalar, const N: usize>(starts: &[Start<S>; N]) -> [S; N] {
    Vector::from_fn(|k| S::lit(if starts[k].locked { 0.0 } else { 1.0 }))
}

impl<S> Start<S> {
    /// A value that assembly may change.
    pub const fn free(value: S) -> Self {
        Self { value, locked: false, is_declared: false }
    }

    /// A value that assembly must keep.
    pub const fn locked(value: S) -> Self {
        Self { value, locked: true, is_declared: false }
    }

    /// A value of the declaration, with its lock: until another one is set, it follows the parameters that it reads.
    pub const fn declared(value: S, locked: bool) -> Self {
        Self { value, locked, is_declared: true }
    }

    /// Start with another value and this lock; it counts as set by hand.
    #[must_use]
    pub fn at(self, value: S) -> Self {
        Self { value, locked: self.locked, is_declared: false }
    }

    /// Start with its value converted to another number type.
    pub fn map<T>(self, f: impl Fn(S) -> T) -> Start<T> {
        Start { value: f(self.value), locked: self.locked, is_declared: self.is_declared }
    }
}

impl<S: Default> Default for Start<S> {
    /// Zero and free.
    fn default() -> Self {
        Self::free(S::default())
    }
}

/// Start pose and velocity of a body's origin O, in absolute axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyStart<S> {
    /// Position of O, m.
    pub x: Start<S>,
    /// Position of O, m.
    pub y: Start<S>,
    /// Angle of the body axes, rad.
    pub angle: Start<S>,
    /// Velocity of O, m/s.
    pub vx: Start<S>,
    /// Velocity of O, m/s.
    pub vy: Start<S>,
    /// Angular velocity, rad/s.
    pub omega: Start<S>,
}

impl<S> BodyStart<S> {
    /// Start with its values converted to another number type.
    pub fn map<T>(self, f: impl Fn(S) -> T) -> BodyStart<T> {
        BodyStart {
            x: self.x.map(&f),
            y: self.y.map(&f),
            angle: self.angle.map(&f),
            vx: self.vx.map(&f),
            vy: self.vy.map(&f),
            omega: self.omega.map(&f),
        }
    }
}

impl<S: Copy> BodyStart<S> {
    /// Start with other values and these locks.
    #[must_use]
    pub fn at(self, [x, y, angle]: [S; 3], [vx, vy, omega]: [S; 3]) -> Self {
        Self {
            x: self.x.at(x),
            y: self.y.at(y),
            angle: self.angle.at(angle),
            vx: self.vx.at(vx),
            vy: self.vy.at(vy),
            omega: self.omega.at(omega),
        }
    }
}

impl<S> BodyStart<S> {
    /// Gives `each` every start value with its name.
    pub fn each(&mut self, names: [&'static str; 6], each: &mut impl FnMut(&'static str, &mut Start<S>)) {
        let Self { x, y, angle, vx, vy, omega } = self;
        for (name, start) in names.into_iter().zip([x, y, angle, vx, vy, omega]) {
            each(name, start);
        }
    }
}

/// All start values of a mechanism: the generated `Starts`.
pub trait StartValues<S>: Copy {
    /// Gives `each` every start value with its name: `arm.x`, `arm.y`, `arm.angle`, `arm.vx`, `arm.vy`, `arm.omega` of each
    /// body, then the first-order states.
    fn each(&mut self, each: &mut impl FnMut(&'static str, &mut Start<S>));
}

/// So many start values are compared in one pass over them: there is no room for all.
const PASS: usize = 64;

/// Makes declared start values those of `after` where they are those of `before`: they follow the parameters that they read. Those that
/// were set by hand, or come from a run, stay.
pub fn follow<S: Scalar, T: StartValues<S>>(starts: &mut T, before: T, after: T) {
    follow_where(starts, before, after, |start| start.is_declared);
}

/// As [`follow`], for those start values for which `follows` is true.
pub(crate) fn follow_where<S: Scalar, T: StartValues<S>>(
    starts: &mut T,
    mut before: T,
    mut after: T,
    follows: impl Fn(&Start<S>) -> bool,
) {
    let (mut first, mut count) = (0, PASS);
    while count == PASS {
        let mut declared = [(S::ZERO, S::ZERO); PASS];
        count = each_of(&mut before, first, &mut |k, start| declared[k].0 = start.value);
        each_of(&mut after, first, &mut |k, start| declared[k].1 = start.value);
        each_of(starts, first, &mut |k, start| {
            let (before, after) = declared[k];
            if follows(start) && start.value == before {
                start.value = after;
            }
        });
        first += PASS;
    }
}

/// Gives `each` the start values of one pass, and how many there are.
fn each_of<S: Scalar>(
    starts: &mut impl StartValues<S>,
    first: usize,
    each: &mut impl FnMut(usize, &mut Start<S>),
) -> usize {
    let (mut index, mut count) = (0_usize, 0);
    starts.each(&mut |_, start| {
        if let Some(place) = index.checked_sub(first).filter(|place| *place < PASS) {
            each(place, start);
            count += 1;
        }
        index += 1;
    });
    count
}

/// Writes start values one a line, `arm.angle = 0.7853981633974483`, SI units, in so many digits that they come back as
/// they are. Locks are not written: they belong to the declaration.
///
/// # Errors
/// Those of the formatter.
pub fn write_starts<S: Scalar>(mut starts: impl StartValues<S>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let mut outcome = Ok(());
    starts.each(&mut |name, start| {
        outcome = outcome.and_then(|()| writeln!(f, "{name} = {:?}", start.value.to_f64()));
    });
    outcome
}
