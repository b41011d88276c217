//! The model on its way: what is declared, in the order of declaration, until it is evaluated.

pub(super) mod body;
pub(super) mod branch;
pub(super) mod contact;
pub(super) mod declare;
pub(super) mod event;
mod fields;
pub(super) mod frame;
mod given;
pub(super) mod handed;
pub(super) mod hull;
pub(super) mod load;
pub(super) mod node;
pub(super) mod part;
pub(super) mod picture;
pub(super) mod plate;
pub(super) mod requirement;
pub(super) mod row;
pub(super) mod settings;
pub(super) mod state;

use plm_cas::Expr;

use crate::model::{Comparison, Limit, Part};
use crate::resolve::declarations::body::UnresolvedBody;
use crate::resolve::declarations::contact::UnresolvedContact;
use crate::resolve::declarations::declare::UnresolvedField;
use crate::resolve::declarations::frame::UnresolvedPort;
use crate::resolve::declarations::load::{Action, UnresolvedLoad};
use crate::resolve::declarations::node::UnresolvedNode;
use crate::resolve::declarations::picture::{UnresolvedShape, UnresolvedSize};
use crate::resolve::declarations::requirement::{Requirement, Switched};
use crate::resolve::declarations::row::UnresolvedRow;
use crate::resolve::declarations::settings::Settings;
use crate::resolve::declarations::state::{UnresolvedRate, UnresolvedState};
use crate::resolve::names::ScopeId;
use crate::resolve::values::Eval;
use crate::resolve::values::drawn::DrawnPose;
use crate::resolve::values::lazy::Lazy;
use crate::span::Span;
use crate::syntax::ast;

/// The declarations of a mechanism before evaluation.
#[derive(Default)]
pub(crate) struct UnresolvedModel<'a> {
    pub(crate) settings: Settings<'a>,
    pub(crate) params: Vec<UnresolvedField<'a>>,
    pub(crate) inputs: Vec<UnresolvedField<'a>>,
    /// Parameters with their defaults.
    pub(crate) defaults: Lazy<Vec<(Expr, Eval<Expr>)>>,
    pub(crate) states: Vec<UnresolvedState<'a>>,
    /// Rates, which are given to their states when all states are declared.
    pub(crate) rates: Vec<UnresolvedRate<'a>>,
    /// Ports of the ground.
    pub(crate) ground: Vec<UnresolvedPort<'a>>,
    pub(crate) bodies: Vec<UnresolvedBody<'a>>,
    /// The pose as drawn, of all coordinates and the time.
    pub(crate) drawn: Lazy<DrawnPose>,
    /// Some value reads a place as drawn. The start of a body whose position is not declared is then where joints put it: directions from
    /// one place to another are none where all bodies stand at the origin.
    pub(crate) draws_rows: bool,
    /// Domains of nodes, in the order in which they are met.
    pub(crate) domains: Vec<&'a ast::Domain>,
    pub(crate) nodes: Vec<UnresolvedNode<'a>>,
    /// The parts of the mechanism; what they contain counts as theirs, but for joints.
    pub(crate) parts: Vec<Part>,
    pub(crate) rows: Vec<UnresolvedRow<'a>>,
    pub(crate) contacts: Vec<UnresolvedContact<'a>>,
    /// Symbols of rows that can hold nothing, with their values.
    pub(crate) idle: Vec<(Expr, Expr, Span)>,
    pub(crate) requirements: Vec<Requirement<'a>>,
    /// Events that set states.
    pub(crate) whens: Vec<(ScopeId, &'a ast::When)>,
    /// Comparisons as they were written.
    pub(crate) comparisons: Vec<Comparison>,
    /// Requirements that uses of parts switch on or off.
    pub(crate) switched: Vec<Switched>,
    /// Values that must be positive when parameters are known.
    pub(crate) limits: Vec<Limit>,
    pub(crate) loads: Vec<UnresolvedLoad<'a>>,
    /// All loads are evaluated: the summands of sums at nodes are known.
    pub(crate) has_all_loads: bool,
    /// Actions of parts on bodies and on the ground, for who observes them.
    pub(crate) applied: Vec<Action>,
    /// Scopes of what acts on nodes by more than zero.
    pub(crate) on_nodes: Vec<ScopeId>,
    /// Outputs of the mechanism, with the documentation of their items.
    pub(crate) outputs: Vec<(ScopeId, &'a ast::Output, &'a [String])>,
    /// Names of `observe`.
    pub(crate) observed: Vec<(ScopeId, &'a ast::Expr)>,
    /// Sizes of parts for pictures.
    pub(crate) sizes: Vec<UnresolvedSize>,
    /// Shapes of parts for pictures.
    pub(crate) shapes: Vec<UnresolvedShape<'a>>,
    /// Turns of repetitions so far.
    pub(crate) turns: usize,
    /// It has been said that there are too many parts.
    pub(crate) too_many: bool,
}
