//! A method by its name: `--method Rk4:1e-3`.

use std::str::FromStr;

use plm_runtime::{Fault, Linear, Mechanism, Moment, Sim, methods};

use crate::any_method::AnyMethod;
use crate::mistake::{BadOption, nearest};

/// A run by a method of [`Integrator`], which starts it.
pub type AnySim<M> = Sim<M, AnyMethod<M>>;

/// Makes the enumeration and the table of names.
macro_rules! integrator {
    (by_error { $($a:ident ($i:literal, $c:literal, $m:ty, $t:literal, $rtol:literal, $d:literal, $w:literal))* }
     of_length { $($b:ident ($j:literal, $k:literal, $n:ty, $u:literal, $e:literal, $x:literal))* }) => {
        /// A method of `docs/src/running/integrators.md`, with its relative tolerance or its longest step.
        ///
        /// ```
        /// use plm::view::Integrator;
        ///
        /// assert_eq!("Rk4:1e-3".parse::<Integrator>()?, Integrator::Rk4(1e-3));
        /// assert_eq!("dop853".parse::<Integrator>()?, Integrator::default());
        /// assert!("Rk4".parse::<Integrator>().unwrap_err().to_string().contains("Rk4:1e-3"));
        /// # Ok::<(), plm::view::BadOption>(())
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum Integrator {
            $(#[doc = concat!($d, " with its relative tolerance.")] $a(f64),)*
            $(#[doc = concat!($e, " with its longest step, s.")] $b(f64),)*
        }

        const NAMED: &[Named] = &[
            $(Named { name: stringify!($a), number: $i, make: Integrator::$a, tolerance: Some($rtol) },)*
            $(Named { name: stringify!($b), number: $j, make: Integrator::$b, tolerance: None },)*
        ];

    };
}

methods!(integrator);

impl Default for Integrator {
    fn default() -> Self {
        Self::Dop853(1e-9)
    }
}

/// A method as it is named: whether it has a tolerance, which it need not be given, or a step.
struct Named {
    name: &'static str,
    /// In the catalogue.
    number: u64,
    make: fn(f64) -> Integrator,
    tolerance: Option<f64>,
}

impl FromStr for Integrator {
    type Err = BadOption;

    fn from_str(text: &str) -> Result<Self, BadOption> {
        let (name, number) = text.split_once(':').map_or((text, None), |(name, number)| (name, Some(number)));
        let Some(Named { name, make, tolerance, .. }) =
            NAMED.iter().find(|known| known.name.eq_ignore_ascii_case(name))
        else {
            return Err(unknown(name));
        };
        let what = if tolerance.is_some() { "relative tolerance" } else { "longest step in seconds" };
        let example = format!("{name}:{:e}", tolerance.unwrap_or(1e-3));
        let missing = || BadOption::new(format!("{name} wants its {what}, as in {example}"));
        let wrong = |number| {
            BadOption::new(format!("{name} wants a positive {what}, as in {example}, not `{number}`"))
        };
        let value = match number {
            None => tolerance.ok_or_else(missing)?,
            Some(number) => number.parse().map_err(|_| wrong(number))?,
        };
        if value > 0.0 && value.is_finite() {
            Ok(make(value))
        } else {
            Err(wrong(number.unwrap_or_default()))
        }
    }
}

/// Error for an unknown name of a method: it gives the nearest name, and all that there are.
pub fn unknown(name: &str) -> BadOption {
    let names: Vec<&str> = NAMED.iter().map(|known| known.name).collect();
    let near = nearest(name, names.iter().copied());
    let hint = near.map_or("there are".to_owned(), |near| format!("is {near} meant? There are"));
    BadOption::new(format!("there is no method `{name}`; {hint} {}", names.join(", ")))
}

impl Integrator {
    /// The method itself, for a mechanism.
    pub fn method<M: Linear>(self) -> AnyMethod<M> {
        AnyMethod::of(self)
    }

    /// A run by this method that begins at a moment.
    pub fn of<M: Mechanism + Linear>(self, state: M::State) -> AnySim<M> {
        Sim::new(state, self.method())
    }

    /// The names of all methods.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMED.iter().map(|known| known.name)
    }

    /// The name of a method in whatever case, and whether it has a longest step, not a tolerance.
    pub fn named(name: &str) -> Option<(&'static str, bool)> {
        let known = NAMED.iter().find(|known| known.name.eq_ignore_ascii_case(name))?;
        Some((known.name, known.tolerance.is_none()))
    }

    /// A method by its number in the catalogue, with some tolerance or longest step.
    pub fn numbered(number: u64) -> Option<Self> {
        NAMED.iter().find(|known| known.number == number).map(|known| (known.make)(1e-3))
    }

    /// A method with its tolerance or its longest step; none where there is no such method, or where it needs a step.
    pub fn by_name(name: &str, value: Option<f64>) -> Option<Self> {
        let known = NAMED.iter().find(|known| known.name.eq_ignore_ascii_case(name))?;
        value.or(known.tolerance).map(known.make)
    }
}

impl Integrator {
    /// Assembles a mechanism at a time, s, and gives its run by this method.
    ///
    /// # Errors
    /// As [`Mechanism::start_at`].
    pub fn start_at<M>(self, mechanism: M, time: M::S) -> Result<AnySim<M>, Fault>
    where
        M: Mechanism + Linear,
    {
        let (held, x) = mechanism.start_state(time)?;
        Ok(self.of(M::State::new(mechanism, held, time, x)))
    }
}

/// Makes the names for help.
macro_rules! help {
    (by_error { $a:ident $of_a:tt $($b:ident $of_b:tt)* } of_length { $c:ident $of_c:tt $($d:ident $of_d:tt)* }) => {
        concat!(
            stringify!($a), "[:TOLERANCE]" $(, ", ", stringify!($b))*, "; ",
            stringify!($c), ":STEP" $(, ", ", stringify!($d))*
        )
    };
}

/// The names for help.
pub const METHODS: &str = methods!(help);

#[cfg(test)]
mod tests {
    use super::{Integrator, METHODS, NAMED};

    #[test]
    fn every_method_has_its_name() {
        for known in NAMED {
            let text = format!("{}:2.5e-4", known.name.to_lowercase());
            assert_eq!(text.parse::<Integrator>().ok(), Some((known.make)(2.5e-4)), "{text}");
        }
        assert_eq!(
            METHODS,
            "Dop853[:TOLERANCE], Vern9, Adams, Dopri5, RadauIia5; Rk4:STEP, SemiImplicitEuler, Gauss2, Gauss3, Ros34Pw2, MoreauJean"
        );
    }

    #[test]
    fn mistakes_say_what_there_is() {
        let said =
            |text: &str| text.parse::<Integrator>().err().map_or(String::new(), |error| error.to_string());
        assert!(
            said("rk5:1e-3").starts_with("there is no method `rk5`; is Rk4 meant? There are Dop853, Vern9")
        );
        assert_eq!(said("rk4"), "Rk4 wants its longest step in seconds, as in Rk4:1e-3");
        assert_eq!(
            said("Dop853:-1"),
            "Dop853 wants a positive relative tolerance, as in Dop853:1e-9, not `-1`"
        );
        assert_eq!(said("Rk4:x"), "Rk4 wants a positive longest step in seconds, as in Rk4:1e-3, not `x`");
    }
}
