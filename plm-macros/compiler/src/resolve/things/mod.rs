//! The model on its way: what is declared, in the order of declaration, until it is evaluated.

pub(super) mod body;
pub(super) mod branch;
pub(super) mod declare;
mod fields;
pub(super) mod frame;
pub(super) mod load;
pub(super) mod node;
pub(super) mod part;
pub(super) mod picture;
pub(super) mod requirement;
pub(super) mod row;
pub(super) mod settings;
pub(super) mod state;

use crate::model::{Limit, Part};
use crate::resolve::names::ScopeId;
use crate::resolve::things::body::BodyDraft;
use crate::resolve::things::declare::FieldDraft;
use crate::resolve::things::frame::PortDraft;
use crate::resolve::things::load::{Action, LoadDraft};
use crate::resolve::things::node::NodeDraft;
use crate::resolve::things::picture::SizeDraft;
use crate::resolve::things::requirement::{Requirement, Switched};
use crate::resolve::things::row::RowDraft;
use crate::resolve::things::settings::Settings;
use crate::resolve::things::state::{RateDraft, StateDraft};
use crate::syntax::ast;

/// What is declared.
#[derive(Default)]
pub(super) struct Draft<'a> {
    pub(super) settings: Settings<'a>,
    pub(super) params: Vec<FieldDraft<'a>>,
    pub(super) inputs: Vec<FieldDraft<'a>>,
    pub(super) states: Vec<StateDraft<'a>>,
    /// Rates, which are given to their states when all states are declared.
    pub(super) rates: Vec<RateDraft<'a>>,
    /// Ports of the ground.
    pub(super) ground: Vec<PortDraft<'a>>,
    pub(super) bodies: Vec<BodyDraft<'a>>,
    /// Domains of nodes, in the order in which they are met.
    pub(super) domains: Vec<&'a ast::Domain>,
    pub(super) nodes: Vec<NodeDraft<'a>>,
    /// The parts of the mechanism; what they contain counts as theirs, but for joints.
    pub(super) parts: Vec<Part>,
    pub(super) rows: Vec<RowDraft<'a>>,
    pub(super) requirements: Vec<Requirement<'a>>,
    /// Requirements that uses of parts switch on or off.
    pub(super) switched: Vec<Switched>,
    /// Values that must be positive when parameters are known.
    pub(super) limits: Vec<Limit>,
    pub(super) loads: Vec<LoadDraft<'a>>,
    /// What parts apply to bodies and to the ground, for who observes them.
    pub(super) applied: Vec<Action>,
    /// Outputs of the mechanism, with the documentation of their items.
    pub(super) outputs: Vec<(ScopeId, &'a ast::Output, &'a [String])>,
    /// What `observe` names.
    pub(super) observed: Vec<(ScopeId, &'a ast::Expr)>,
    /// Sizes of parts for pictures.
    pub(super) sizes: Vec<SizeDraft>,
    /// Turns of repetitions so far.
    pub(super) turns: usize,
    /// It has been said that there are too many parts.
    pub(super) too_many: bool,
}
