//! Conditions as data.

use super::Parts;
use super::routine::Routine;
use crate::collect::CollectVec;
use crate::facts::conditions;
use crate::model;
use crate::source::Origin;

/// Conditions whose sides are held, kinks, and where rows jump.
#[derive(Clone, Debug)]
pub struct Switches {
    /// Conditions: those of the state, then those of the time.
    pub all: Vec<Switch>,
    /// Number of conditions of the state: the first ones have guards.
    pub guards: usize,
    /// Number of kinks after these.
    pub kinks: usize,
    /// `at` and `slope` of conditions that depend on the time alone.
    pub instants: Routine,
    /// Do guards read accelerations or multipliers?
    pub read_solution: bool,
    /// When conditions and kinks matter: nodes (side, yes, no), and where each begins; empty where all matter always.
    pub nodes: Vec<(u8, u16, u16)>,
    /// Roots among the nodes, of each condition of the state, then of each kink.
    pub roots: Vec<u16>,
    /// Rows that may jump.
    pub jumps: Vec<Jump>,
    /// `jump`: five terms of each of these.
    pub terms: Routine,
}

/// A condition.
#[derive(Clone, Debug)]
pub struct Switch {
    /// The part or state that jumps; the requirement.
    pub name: String,
    /// As it was written; with its name where several are written alike.
    pub text: String,
    /// Must it hold, so that the run ends where it does not?
    pub must_hold: bool,
    /// Why the run ends where it changes, if it does.
    pub end: Option<End>,
}

/// Why a run ends where an expression passes zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// Something is divided by it.
    Pole(String),
    /// A function is defined on one side alone.
    Domain(String),
}

/// A row that may jump.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Jump {
    /// The number of the row.
    pub row: usize,
    /// The number of the condition.
    pub switch: usize,
}

impl Switches {
    pub(super) fn new(parts: &Parts) -> Switches {
        let Parts { model, program, equations, .. } = parts;
        let absolute = &program.absolute;
        let texts = conditions::texts(model).collect_vec();
        let texts = texts.into_iter().map(Some).chain(std::iter::repeat(None));
        let all = model.switches.iter().zip(texts).map(|(switch, text)| Switch {
            name: switch.name.clone(),
            text: text.unwrap_or_default(),
            must_hold: switch.must_hold,
            end: switch.end.as_ref().map(|end| match end {
                model::End::Pole(by) => End::Pole(by.clone()),
                model::End::Domain(of) => End::Domain(of.clone()),
            }),
        });
        let model::Decisions { nodes, roots } = &model.decisions;
        let nodes = nodes.iter().map(|&(side, yes, no)| (side as u8, yes as u16, no as u16));
        Switches {
            all: all.collect_vec(),
            guards: model.guards(),
            kinks: model.kinks.len(),
            instants: parts.routine(&absolute.instants, Origin::Arguments),
            read_solution: conditions::read_solution(model, equations),
            nodes: nodes.collect_vec(),
            roots: roots.iter().map(|&root| root as u16).collect_vec(),
            jumps: model.jumps.iter().map(|jump| Jump { row: jump.row, switch: jump.switch }).collect_vec(),
            terms: parts.routine(&absolute.jumps, Origin::Pose),
        }
    }
}
