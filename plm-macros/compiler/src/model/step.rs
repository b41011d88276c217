//! Methods of which the user orders a step of its own in the code.

/// A step that is emitted on request.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// The classical Runge-Kutta method of order 4.
    Rk4,
    /// The semi-implicit Euler method.
    SemiImplicitEuler,
    /// A Rosenbrock-W method of order 3, for stiff equations.
    LinearlyImplicit,
    /// The time stepping of Moreau and Jean, over impacts and friction.
    MoreauJean,
}

impl Step {
    /// The methods as the language names them.
    pub const NAMES: [(&'static str, Step); 4] = [
        ("rk4", Step::Rk4),
        ("semi_implicit_euler", Step::SemiImplicitEuler),
        ("linearly_implicit", Step::LinearlyImplicit),
        ("moreau_jean", Step::MoreauJean),
    ];

    /// The method of a name.
    pub fn named(name: &str) -> Option<Step> {
        Step::NAMES.iter().find(|known| known.0 == name).map(|known| known.1)
    }
}
