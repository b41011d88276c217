//! Where a body starts, and what assembly may not change.

use core::fmt;

use crate::scalar::Scalar;

/// A start value, and whether assembly must keep it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start<S> {
    /// The value, SI units.
    pub value: S,
    /// Kept as it is (a lock) rather than moved to close the joints.
    pub locked: bool,
}

impl<S> Start<S> {
    /// A value that assembly may change.
    pub const fn free(value: S) -> Self {
        Self { value, locked: false }
    }

    /// A value that assembly must keep.
    pub const fn locked(value: S) -> Self {
        Self { value, locked: true }
    }

    /// The same start in other numbers.
    pub fn map<T>(self, f: impl Fn(S) -> T) -> Start<T> {
        Start { value: f(self.value), locked: self.locked }
    }
}

impl<S: Default> Default for Start<S> {
    /// Zero and free.
    fn default() -> Self {
        Self { value: S::default(), locked: false }
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
    /// The same start in other numbers.
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
    /// The same locks with other values.
    #[must_use]
    pub fn at(self, [x, y, angle]: [S; 3], [vx, vy, omega]: [S; 3]) -> Self {
        let put = |start: Start<S>, value| Start { value, ..start };
        Self {
            x: put(self.x, x),
            y: put(self.y, y),
            angle: put(self.angle, angle),
            vx: put(self.vx, vx),
            vy: put(self.vy, vy),
            omega: put(self.omega, omega),
        }
    }
}

/// All start values of a mechanism: the generated `Starts`.
pub trait StartValues<S>: Copy {
    /// Gives `each` every start value with its name: `arm.x`, `arm.y`, `arm.angle`, `arm.vx`, `arm.vy`, `arm.omega` of each
    /// body, then the first-order states.
    fn each(&mut self, each: &mut impl FnMut(&'static str, &mut Start<S>));
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
