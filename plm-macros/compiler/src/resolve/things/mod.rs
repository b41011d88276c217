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

use crate::model::{Comparison, Limit, Part};
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
pub(crate) struct Draft<'a> {
    pub(crate) settings: Settings<'a>,
    pub(crate) params: Vec<FieldDraft<'a>>,
    pub(crate) inputs: Vec<FieldDraft<'a>>,
    pub(crate) states: Vec<StateDraft<'a>>,
    /// Rates, which are given to their states when all states are declared.
    pub(crate) rates: Vec<RateDraft<'a>>,
    /// Ports of the ground.
    pub(crate) ground: Vec<PortDraft<'a>>,
    pub(crate) bodies: Vec<BodyDraft<'a>>,
    /// Domains of nodes, in the order in which they are met.
    pub(crate) domains: Vec<&'a ast::Domain>,
    pub(crate) nodes: Vec<NodeDraft<'a>>,
    /// The parts of the mechanism; what they contain counts as theirs, but for joints.
    pub(crate) parts: Vec<Part>,
    pub(crate) rows: Vec<RowDraft<'a>>,
    pub(crate) requirements: Vec<Requirement<'a>>,
    /// Comparisons as they were written.
    pub(crate) comparisons: Vec<Comparison>,
    /// Requirements that uses of parts switch on or off.
    pub(crate) switched: Vec<Switched>,
    /// Values that must be positive when parameters are known.
    pub(crate) limits: Vec<Limit>,
    pub(crate) loads: Vec<LoadDraft<'a>>,
    /// What parts apply to bodies and to the ground, for who observes them.
    pub(crate) applied: Vec<Action>,
    /// Outputs of the mechanism, with the documentation of their items.
    pub(crate) outputs: Vec<(ScopeId, &'a ast::Output, &'a [String])>,
    /// What `observe` names.
    pub(crate) observed: Vec<(ScopeId, &'a ast::Expr)>,
    /// Sizes of parts for pictures.
    pub(crate) sizes: Vec<SizeDraft>,
    /// Turns of repetitions so far.
    pub(crate) turns: usize,
    /// It has been said that there are too many parts.
    pub(crate) too_many: bool,
}
