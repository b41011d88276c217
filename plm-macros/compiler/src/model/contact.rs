//! Rows of contact: gaps that push, and frictions.

use plm_cas::Expr;

use super::Declared;
use crate::span::Span;
use crate::units::DisplayUnit;

/// A row of contact. Its force acts on the bodies along the gradient of its displacement; it stands in the loads with `lambda`.
#[derive(Clone, Debug)]
pub struct Contact {
    /// Full name, e.g. `shoe.tip`.
    pub name: String,
    /// Index into [`Model::parts`](super::Model::parts).
    pub part: usize,
    /// The gap z, or the displacement whose rate is the slip, m or rad.
    pub displacement: Expr,
    /// Symbol of its multiplier: the push, never negative, or the friction, N or N m. Outputs and bounds of frictions may hold it.
    pub lambda: Expr,
    /// What it says.
    pub law: ContactLaw,
    /// `m` or `rad`.
    pub unit: DisplayUnit,
    /// Where it stands: the part in the declaration.
    pub span: Span,
    /// Where it was written.
    pub declared: Declared,
}

/// What a row of contact says.
#[derive(Clone, Debug)]
pub enum ContactLaw {
    /// A gap is not negative, nor is the push; one of the two is zero.
    Unilateral {
        /// The coefficient of restitution, 0 to 1.
        restitution: Expr,
    },
    /// A force against the slip, between `-lower` and `upper`, N or N m; affine in the multipliers of unilateral rows.
    Friction {
        /// `[lower, upper]` while it slips.
        kinetic: [Expr; 2],
        /// `[lower, upper]` while it sticks.
        adhesion: [Expr; 2],
    },
}

impl ContactLaw {
    /// Its expressions.
    pub fn expressions_mut(&mut self) -> Vec<&mut Expr> {
        match self {
            ContactLaw::Unilateral { restitution } => vec![restitution],
            ContactLaw::Friction { kinetic, adhesion } => kinetic.iter_mut().chain(adhesion).collect(),
        }
    }
}

/// The law of impact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Impacts {
    /// The fraction e of the impulse of compression comes back.
    #[default]
    Poisson,
    /// The fraction e of the rate of approach comes back.
    Newton,
    /// Poisson's law for one row after the other.
    Sequential,
}

impl Impacts {
    /// Names in the language.
    pub const NAMES: [(&'static str, Impacts); 3] =
        [("poisson", Impacts::Poisson), ("newton", Impacts::Newton), ("sequential", Impacts::Sequential)];

    /// The law of that name.
    pub fn named(name: &str) -> Option<Impacts> {
        Impacts::NAMES.iter().find(|known| known.0 == name).map(|known| known.1)
    }
}
