//! Contract of generated code: all items of this crate that the code of `mechanism!` names.
//!
//! It is no promise to users. Items may change or go with every release; the crates of a release ask for each other exactly, so that
//! generated code and runtime always belong together. What is documented outside of this module is for users, and changes by the rules of
//! semantic versions.
//!
//! `plm-macros/compiler/src/emit/` writes the code. Whatever it names in a new way has to be named here too; whatever stands here and is
//! named no more fails `cargo test -p xtask --test files`.

pub use crate::double_double::DoubleDouble;
pub use crate::dual::Dual;
pub use crate::enclosure::Enclosed;
pub use crate::fault::{Cause, Fault, Names};
pub use crate::held::Held;
pub use crate::limits::{Least, Limit};
pub use crate::linear::Linear;
pub use crate::mechanism::{HasMasses, InPlace, Mechanism, Moment};
pub use crate::method::Method;
pub use crate::ports::Ports;
pub use crate::scalar::{Factor, Real, Scalar};
pub use crate::sim::Sim;
pub use crate::start::{BodyStart, Start, StartValues, follow};
pub use crate::statics::Statics;
pub use crate::switched::{Switched, Switches};
pub use crate::system::{
    Computation, Constraints, Drift, Energy, Events, Health, LabelTable, Labels, PartNames, Question, Rate,
    Updated,
};
pub use crate::vector::Vector;
pub use crate::{Assembly, BodyState, Common, Described, Observed, Operations};

pub mod absolute {
    pub use crate::absolute::{
        Absolute, Acceleration, Branch, Conditional, Layout, accelerate, assemble, assemble_held, balance,
        check_carried, drift, join, opening, phi_q_matrix, project_state, renew, residuals, split,
    };
}

pub mod charts {
    pub use crate::charts::{
        Charted, Charts, Continuation, ContinuationData, OfLoops, Revolutions, are_calm, are_short, enter,
        full, is_calm, is_free, look, not_regular, pose, update,
    };
}

pub mod compact {
    pub use crate::compact::{
        below, bodies, chosen, frames, names, numbers, pairs, parts, pivots, places, singles, terms,
    };
}

pub mod contact {
    pub use crate::contact::{
        Contacts, Held, ImpactLaw, Kinematics, Law, Load, Motion, Proposed, Rows, Solution, Stride,
        add_forces, appear, begin, drift, guard_count, held_rows, packed_steps, project, settle, slide,
        slipping, sum_of, update, with_multipliers,
    };
}

pub mod described {
    pub use crate::described::{
        Body, Frame, GroundPort, Hole, Motion, Part, Quantity, Reads, Report, Shape, Tables,
    };
}

pub mod events {
    pub use crate::events::{Sets, begin, change, switch_where_due, take_sides, with_velocities};
}

pub mod held {
    pub use crate::held::Loops;
}

pub mod lanes {
    pub use crate::lanes::{Pack, Two};
}

pub mod limits {
    pub use crate::limits::{check, check_numbers, fingerprint};
}

pub mod linalg {
    pub use crate::linalg::{Derivatives, Mixed, Pattern, Patterned, Sparse};
}

pub mod linear {
    pub use crate::linear::{Colours, ask, by_directions, compute, finite};
}

pub mod method {
    pub use crate::method::Ros34Pw2Formula;
}

pub mod singular {
    pub use crate::singular::{ExtendedPrecision, InAbsolute, InCharts, NearSingular, Never, refine};
}

pub mod start {
    pub use crate::start::write_starts;
}

pub mod step {
    pub use crate::step::{Remainder, Stepped, moreau_jean, rk4, singular, solvable, step, take};
}

pub mod system {
    pub use crate::system::rate_aside;
}

pub mod switched {
    pub use crate::switched::{NoContact, WithContact, jump, take_sides_at_time};
}

pub mod turns {
    pub use crate::turns::{add, all_near, are_due, unwind, whole};
}

pub mod workspace {
    pub use crate::workspace::of;
}
