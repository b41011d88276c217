//! Rows of contact: tables and functions.

use plm_compiler::lowered::{self, ContactKind, Lowered, ReadByConditions};
use plm_runtime::absolute::Layout;

use crate::code::Code;
use crate::kept::kept;
use crate::places::Room;

/// Rows of contact of a mechanism.
#[derive(Debug)]
pub(crate) struct Contacts {
    pub(crate) lowered: &'static lowered::Contacts,
    /// Coefficients of restitution of the rows.
    pub(crate) restitutions: Vec<Code>,
    pub(crate) exist: Option<Code>,
    /// Functions chart by chart.
    pub(crate) charts: Vec<InChart>,
    pub(crate) conditional: Option<Conditional>,
}

/// Functions of the rows in a chart.
#[derive(Debug)]
pub(crate) struct InChart {
    pub(crate) kinematics: Code,
    pub(crate) motion: Code,
    pub(crate) together: Option<Code>,
    pub(crate) sliding: Option<Sliding>,
}

/// Functions of rows that all slip.
#[derive(Debug)]
pub(crate) struct Sliding {
    pub(crate) motion: Code,
    pub(crate) sweep: Code,
    pub(crate) sizes: Code,
    pub(crate) is_explicit: bool,
    pub(crate) known: usize,
    /// By coordinate, what makes its acceleration one of an angle: over the length of the scene where it is a length.
    pub(crate) weights: Vec<f64>,
}

/// Constraints with a condition.
#[derive(Debug)]
pub(crate) struct Conditional {
    pub(crate) rows: Vec<usize>,
    pub(crate) layout: Layout,
    pub(crate) phi: Code,
    pub(crate) phi_dot: Code,
    pub(crate) phi_q: Code,
    pub(crate) places: Vec<[usize; 2]>,
}

impl Contacts {
    pub(crate) fn new(mechanism: &'static Lowered, joints: &Layout, state: Room) -> Option<Contacts> {
        let of = mechanism.contacts.as_ref()?;
        let chart = |chart: &'static lowered::ContactChart| InChart {
            kinematics: Code::new(&chart.kinematics, &[], state),
            motion: Code::new(&chart.motion, &["dx"], state),
            together: chart.together.as_ref().map(|together| Code::new(together, &["dx"], state)),
            sliding: chart.sliding.as_ref().map(|sliding| Sliding::new(sliding, mechanism.length, state)),
        };
        Some(Contacts {
            restitutions: of.rows.iter().map(|row| Code::new(&row.restitution, &["values"], state)).collect(),
            exist: of.exist.as_ref().map(|exist| Code::new(exist, &["exist"], state)),
            charts: of.charts.iter().map(chart).collect(),
            conditional: of.conditional.as_ref().map(|own| Conditional::new(own, joints, state)),
            lowered: of,
        })
    }

    /// Do conditions read what contacts do?
    pub(crate) fn decide_sides(&self) -> bool {
        self.lowered.read != ReadByConditions::Nothing
    }

    /// The kind of the law of a row; none of a place after the last row.
    pub(crate) fn kind(&self, row: usize) -> Option<ContactKind> {
        self.lowered.rows.get(row).map(|row| row.kind)
    }
}

impl Sliding {
    fn new(of: &'static lowered::Sliding, length: f64, state: Room) -> Sliding {
        let inverse = 1.0 / length;
        Sliding {
            motion: Code::new(&of.motion, &["dx", "free", "known", "slope"], state),
            sweep: Code::new(&of.sweep, &["next", "changed"], state),
            sizes: Code::new(&of.sizes, &["sizes"], state),
            is_explicit: of.is_explicit,
            known: of.known,
            weights: of.angles.iter().map(|angle| if *angle { 1.0 } else { inverse }).collect(),
        }
    }
}

impl Conditional {
    fn new(of: &'static lowered::Conditional, joints: &Layout, state: Room) -> Conditional {
        let joined = |own: &'static [&'static str], others: &'static [String]| {
            kept(own.iter().copied().chain(others.iter().map(String::as_str)))
        };
        Conditional {
            rows: of.rows.clone(),
            layout: Layout {
                rows: joined(joints.rows, &of.names),
                parts: joined(joints.parts, &of.parts),
                angular: kept(joints.angular.iter().copied().chain(of.angular.iter().copied())),
                ..*joints
            },
            phi: Code::new(&of.phi, &["phi"], state),
            phi_dot: Code::new(&of.phi_dot, &["phi_dot"], state),
            phi_q: Code::new(&of.phi_q, &["phi_q"], state),
            places: of.places.clone(),
        }
    }
}
