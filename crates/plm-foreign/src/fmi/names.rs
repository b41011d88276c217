//! Names of variables: all are different, and declared quantities keep their names.

use alloc::collections::BTreeSet;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

use plm_runtime::{Events, Vector};

use super::{Exchanged, Variable};
use crate::Kind;

/// The names of all variables, in the order of their value references.
pub(super) fn names<M: Exchanged>(declared: &M) -> Vec<String> {
    let all: Vec<Variable> = Variable::all(declared).collect();
    let (mut names, mut taken) = (all.iter().map(|_| String::new()).collect::<Vec<_>>(), BTreeSet::new());
    // What a user has declared comes first, the time last.
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by_key(|reference| all.get(*reference).map(|variable| rank(*variable)));
    for reference in order {
        let (Some(variable), Some(name)) = (all.get(reference), names.get_mut(reference)) else { continue };
        let mut candidates = candidates(declared, *variable);
        let last = candidates.pop().unwrap_or_default();
        *name = candidates.into_iter().find(|name| !taken.contains(name)).unwrap_or(last);
        taken.insert(name.clone());
    }
    names
}

fn rank(variable: Variable) -> usize {
    match variable {
        Variable::Parameter(_) => 0,
        Variable::Input(_) => 1,
        Variable::Output(_) => 2,
        Variable::Time => 4,
        _ => 3,
    }
}

/// The name that a variable has, and those where it is taken. The last one has its number, and no other variable has that:
/// in names of a declaration numbers alone stand in brackets.
fn candidates<M: Exchanged>(declared: &M, variable: Variable) -> Vec<String> {
    let numbered = |word: &str, k: usize, name: &str| format!("{word}({k}, {name})");
    let (kind, word, k) = match variable {
        Variable::Time => return vec!["time".to_string(), "independent(time)".to_string()],
        Variable::State(k) => return vec![numbered("state", k, declared.name_of_state(k))],
        Variable::Rate(k) => {
            return vec![format!("der({})", numbered("state", k, declared.name_of_state(k)))];
        }
        Variable::Indicator(k) if k < <M as Events>::G::LEN => {
            return vec![numbered("indicator", k, declared.guard_name(k))];
        }
        Variable::Indicator(k) => return vec![numbered("indicator", k, "loops")],
        // No name of a declaration contains parentheses.
        Variable::Method => return vec!["plm(method)".to_string()],
        Variable::Step => return vec!["plm(step)".to_string()],
        Variable::Parameter(k) => (Kind::Parameter, "parameter", k),
        Variable::Input(k) => (Kind::Input, "input", k),
        Variable::Output(k) => (Kind::Output, "output", k),
        Variable::Contact(k) => (Kind::Contact, "contact", k),
        Variable::Start(k) => (Kind::Start, "start", k),
    };
    let name = kind.name(declared, k).unwrap_or_default();
    let mut all = vec![name.to_string(), format!("{word}({name})"), numbered(word, k, name)];
    if matches!(kind, Kind::Start | Kind::Contact) {
        // The name itself is that of a value of the run, or of a part.
        all.remove(0);
    }
    all
}
