//! Rows of contact: gaps that push, and frictions.

use plm_cas::Expr;

use super::Declared;
use crate::collect::CollectVec;
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
    /// Symbol for 1 where a gap is open, where a friction sticks, else 0; events and outputs may hold it.
    pub mode: Expr,
    /// The law of its force.
    pub law: ContactLaw,
    /// 1 where it exists, else 0; nothing where it always does.
    pub exists: Option<Expr>,
    /// `m` or `rad`.
    pub unit: DisplayUnit,
    /// Place of its part in the declaration.
    pub span: Span,
    /// Place of the row itself.
    pub declared: Declared,
}

/// A mode of rows of contact that events and outputs may ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactMode {
    /// A gap is open.
    Open,
    /// A friction sticks.
    Sticking,
}

/// The law of a row of contact.
#[derive(Clone, Debug)]
pub enum ContactLaw {
    /// A gap is not negative, nor is the push; one of the two is zero.
    Unilateral {
        /// The coefficient of restitution, 0 to 1.
        restitution: Expr,
    },
    /// A constraint while the row exists.
    Constraint,
    /// A force against the slip, between `-lower` and `upper`, N or N m; affine in the multipliers of unilateral rows and in
    /// the sizes of reactions.
    Friction {
        /// `[lower, upper]` while it slips.
        kinetic: [Expr; 2],
        /// `[lower, upper]` while it sticks.
        adhesion: [Expr; 2],
        /// The reactions of joints that the limits read by their sizes; other frictions may read them too.
        reactions: Vec<Reaction>,
    },
}

impl Contact {
    /// Can it hold nothing? A row that never exists, or a friction without a bound.
    pub(crate) fn is_idle(&self) -> bool {
        let is_weak = match &self.law {
            ContactLaw::Friction { kinetic, adhesion, .. } => {
                kinetic.iter().chain(adhesion).all(|limit| limit.is_zero())
            }
            ContactLaw::Unilateral { .. } | ContactLaw::Constraint => false,
        };
        is_weak || self.exists.is_some_and(Expr::is_zero)
    }

    /// The reactions of joints that bound it.
    pub(crate) fn reactions(&self) -> &[Reaction] {
        match &self.law {
            ContactLaw::Unilateral { .. } | ContactLaw::Constraint => &[],
            ContactLaw::Friction { reactions, .. } => reactions,
        }
    }

    /// The mode for which its symbol stands.
    pub(crate) fn kind_of_mode(&self) -> ContactMode {
        match self.law {
            ContactLaw::Unilateral { .. } | ContactLaw::Constraint => ContactMode::Open,
            ContactLaw::Friction { .. } => ContactMode::Sticking,
        }
    }

    /// Its expressions.
    pub(crate) fn expressions_mut(&mut self) -> Vec<&mut Expr> {
        let of_law: Vec<&mut Expr> = match &mut self.law {
            ContactLaw::Unilateral { restitution } => vec![restitution],
            ContactLaw::Constraint => Vec::new(),
            ContactLaw::Friction { kinetic, adhesion, reactions } => {
                let components = reactions.iter_mut().flat_map(|reaction| &mut reaction.components);
                kinetic.iter_mut().chain(adhesion).chain(components).collect_vec()
            }
        };
        [&mut self.displacement].into_iter().chain(of_law).chain(self.exists.as_mut()).collect_vec()
    }
}

/// The reactions of joints that bound frictions, each once: their numbers at run time.
pub(crate) fn bounding_reactions(contacts: &[Contact]) -> Vec<&Reaction> {
    let mut all: Vec<&Reaction> = Vec::new();
    for reaction in contacts.iter().flat_map(Contact::reactions) {
        if all.iter().all(|known| known.size != reaction.size) {
            all.push(reaction);
        }
    }
    all
}

/// A reaction of joints that bounds frictions.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// Stands in the limits for its size, N or N m.
    pub size: Expr,
    /// Its one component along a line, or its two in the plane: linear in multipliers of joints.
    pub components: Vec<Expr>,
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
