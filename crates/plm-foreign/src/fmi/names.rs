//! Names of variables: all are different, and declared quantities keep their names.

use alloc::collections::BTreeSet;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

use super::{Facts, Variable};

/// The names of all variables, in the order of their value references.
pub(super) fn names(facts: &Facts) -> Vec<String> {
    let all = &facts.variables;
    let (mut names, mut taken) = (all.iter().map(|_| String::new()).collect::<Vec<_>>(), BTreeSet::new());
    // What a user has declared comes first, the time last.
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by_key(|reference| all.get(*reference).map(|variable| rank(*variable)));
    for reference in order {
        let (Some(variable), Some(name)) = (all.get(reference), names.get_mut(reference)) else { continue };
        let mut candidates = candidates(facts, *variable);
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
fn candidates(facts: &Facts, variable: Variable) -> Vec<String> {
    let tables = facts.tables;
    let of_state = |k: usize| facts.states.get(k).map_or("", |(name, _)| name);
    let numbered = |word: &str, k: usize, name: &str| format!("{word}({k}, {name})");
    let (name, word, k) = match variable {
        Variable::Time => return vec!["time".to_string(), "independent(time)".to_string()],
        Variable::State(k) => return vec![numbered("state", k, of_state(k))],
        Variable::Rate(k) => {
            return vec![format!("der({})", numbered("state", k, of_state(k)))];
        }
        Variable::Indicator(k) => {
            let name = facts.guards.get(k).copied().unwrap_or("loops");
            return vec![numbered("indicator", k, name)];
        }
        // No name of a declaration contains parentheses.
        Variable::Method => return vec!["plm(method)".to_string()],
        Variable::Step => return vec!["plm(step)".to_string()],
        Variable::Parameter(k) => (tables.parameters.get(k).map(|row| row.name), "parameter", k),
        Variable::Input(k) => (tables.inputs.get(k).map(|row| row.name), "input", k),
        Variable::Output(k) => (facts.observed.get(k).map(|(name, _)| *name), "output", k),
        Variable::Contact(k) => (facts.contacts.get(k).copied(), "contact", k),
        Variable::Start(k) => (facts.starts.get(k).map(|(name, _)| *name), "start", k),
    };
    let name = name.unwrap_or_default();
    let mut all = vec![name.to_string(), format!("{word}({name})"), numbered(word, k, name)];
    if matches!(variable, Variable::Start(_) | Variable::Contact(_)) {
        // The name itself is that of a value of the run, or of a part.
        all.remove(0);
    }
    all
}
