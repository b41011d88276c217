//! Angles that may turn without end: their whole turns are counted beside the state, so that what is in it stays small.
//!
//! Poses and constraints know an angle by its sine and cosine, to which whole turns are nothing. What reads the angle itself (a
//! spring, a condition, an output) reads `theta + 2 pi n`. Bodies whose angles a constraint keeps at one difference have
//! one count. An angle that a constraint reads in another way (a gear, a drive, a slide on the ground) has none: there whole turns
//! are not nothing.

use crate::collect::{CollectVec, PushAll};
use crate::sorted::SortedSet;

use plm_cas::{Expr, Function, Node, Number, algebra};

use crate::model::{Contact, Counted, Model, Switch, When};

/// Counts the turns of all angles that may have any. Gives the angles, and what stands for them where they are read
/// themselves.
pub(crate) fn count_turns(model: &mut Model) -> Vec<(Expr, Expr)> {
    model.turns = counted(model);
    let whole_turn = Expr::from(Number::pi()) * Expr::from(2);
    let mut pairs = Vec::new();
    for counted in &model.turns {
        let turned = whole_turn * counted.symbol;
        let angles = counted.bodies.iter().map(|&body| model.bodies[body].q[2]);
        pairs.push_all(angles.map(|angle| (angle, angle + turned)));
    }
    let mut places: Vec<&mut Expr> = Vec::new();
    places.push_all(model.loads.iter_mut().flat_map(|load| &mut load.force));
    places.push_all(model.states.iter_mut().map(|state| &mut state.rate));
    places.push_all(model.outputs.iter_mut().flat_map(|output| &mut output.components));
    places.push_all(model.contacts.iter_mut().flat_map(Contact::expressions_mut));
    places.push_all(model.whens.iter_mut().flat_map(When::expressions_mut));
    for Switch { difference, beyond, .. } in &mut model.switches {
        places.push(difference);
        places.push_all(beyond.as_mut());
    }
    places.push_all(&mut model.kinks);
    let read: Vec<Expr> = places.iter().map(|place| **place).collect_vec();
    places.into_iter().zip(with_turns(&read, &pairs)).for_each(|(place, whole)| *place = whole);
    pairs
}

/// Expressions that read whole angles; `pairs` as from [`count_turns`].
pub(crate) fn with_turns(exprs: &[Expr], pairs: &[(Expr, Expr)]) -> Vec<Expr> {
    if pairs.is_empty() {
        return exprs.to_vec();
    }
    let angles: SortedSet<Expr> = pairs.iter().map(|pair| pair.0).collect();
    let periodic = algebra::reachable(exprs).into_iter().filter(|&expr| is_periodic(expr, &angles));
    let all: Vec<(Expr, Expr)> = periodic.map(|expr| (expr, expr)).chain(pairs.iter().copied()).collect_vec();
    algebra::substitute(exprs, &all)
}

/// The angles that turn as one, by count.
fn counted(model: &Model) -> Vec<Counted> {
    let angles: SortedSet<Expr> = model.bodies.iter().map(|body| body.q[2]).collect();
    let body_of = |angle: Expr| model.bodies.iter().position(|body| body.q[2] == angle);
    // Of each body the first one that it turns with; none if it has no count.
    let mut leader: Vec<Option<usize>> = (0..model.bodies.len()).map(Some).collect_vec();
    let mut join = |bodies: &[usize], turn_as_one: bool| {
        let joined: Vec<Option<usize>> = bodies.iter().map(|&body| leader[body]).collect_vec();
        // None is less than any.
        let first = joined.iter().copied().min().flatten().filter(|_| turn_as_one);
        for own in leader.iter_mut().filter(|own| own.is_some() && joined.contains(own)) {
            *own = first;
        }
    };
    // A pair may say by a sine that nothing turns; joint coordinates have one angle for both bodies all the same.
    for part in model.parts.iter().filter(|part| part.pair.is_some_and(|pair| !pair.turns())) {
        if let [Some(a), Some(b)] = part.frames.iter().map(|frame| frame.body).collect_vec()[..] {
            join(&[a, b], true);
        }
    }
    let rows = model.rows.iter().map(|row| row.phi);
    for phi in rows.chain(model.released.iter().map(|(_, condition)| *condition)) {
        let read = read_itself(phi, &angles);
        let bodies: Vec<usize> = read.into_iter().filter_map(body_of).collect_vec();
        join(&bodies, is_difference(phi, &angles));
    }
    let first = (0..model.bodies.len()).filter(|&body| leader[body] == Some(body));
    let of_leader = |first: usize| Counted {
        symbol: Expr::symbol(format!("{}.turns", model.bodies[first].name.text)),
        bodies: (0..model.bodies.len()).filter(|&body| leader[body] == Some(first)).collect_vec(),
    };
    first.map(of_leader).collect_vec()
}

/// Is it the difference of two angles, and of what knows none?
fn is_difference(phi: Expr, angles: &SortedSet<Expr>) -> bool {
    let coefficients = coefficients(phi, angles).unwrap_or_default();
    matches!(coefficients[..], [(Some(1), a), (Some(-1), b)] | [(Some(-1), a), (Some(1), b)] if a != b)
}

/// The angles that a sum has, each with its coefficient if that is a whole number; sums that are named in it are parts of
/// it. `None` if another term knows an angle.
fn coefficients(expr: Expr, angles: &SortedSet<Expr>) -> Option<Vec<(Option<i64>, Expr)>> {
    let (mut open, mut found) = (vec![(Number::ONE, expr)], Vec::new());
    while let Some((factor, term)) = open.pop() {
        match term.node() {
            _ if angles.contains(&term) => found.push((factor.as_int(), term)),
            Node::Defined(value) => open.push((factor, value)),
            Node::Sum { terms, .. } => {
                open.push_all(terms.iter().map(|&(coefficient, term)| (factor * coefficient, term)));
            }
            _ if algebra::symbols(&[term]).iter().any(|symbol| angles.contains(symbol)) => return None,
            _ => {}
        }
    }
    Some(found)
}

/// The angles that an expression reads in another way than by a function to which whole turns are nothing.
fn read_itself(expr: Expr, angles: &SortedSet<Expr>) -> Vec<Expr> {
    let (mut open, mut seen, mut found) = (vec![expr], SortedSet::new(), Vec::new());
    while let Some(expr) = open.pop() {
        if !seen.insert(expr) || is_periodic(expr, angles) {
            continue;
        }
        if angles.contains(&expr) {
            found.push(expr);
        }
        expr.node().for_each_child(|child| open.push(child));
    }
    found.sort_unstable();
    found
}

/// Is it a sine or cosine of angles times whole numbers?
fn is_periodic(expr: Expr, angles: &SortedSet<Expr>) -> bool {
    let Node::Call(Function::Sin | Function::Cos, arguments) = expr.node() else {
        return false;
    };
    let coefficients = arguments.first().and_then(|&argument| coefficients(argument, angles));
    coefficients.is_some_and(|all| !all.is_empty() && all.iter().all(|(factor, _)| factor.is_some()))
}
