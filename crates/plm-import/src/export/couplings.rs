//! Rows that the formats have as properties of joints: rotors that turn with a joint, and joints that follow others.

use plm_compiler::{Affine, Assembled, AssembledPart};

use super::pairs::{Kind, Pair};
use super::tree::Tree;

/// A rotor on a joint, whose inertia the joint has.
pub(super) struct Rotor {
    /// The part.
    pub(super) part: usize,
    /// The body of the part.
    pub(super) body: usize,
}

impl Rotor {
    /// Is it the name of something inside of the rotor?
    pub(super) fn has(&self, name: &str, mechanism: &Assembled) -> bool {
        is_inside(name, &mechanism.parts[self.part].name)
    }
}

/// A hinge that follows another one, `q = ratio q_of` from the start on, or that is fixed.
pub(super) struct Coupling {
    /// The row of the declaration.
    pub(super) part: usize,
    /// The hinge.
    pub(super) pair: usize,
    /// The other hinge and the ratio.
    pub(super) of: Option<(usize, f64)>,
}

/// The rotors on revolute joints, which get their inertias.
pub(super) fn rotors(mechanism: &Assembled, pairs: &mut [Pair]) -> Vec<Rotor> {
    let parts = mechanism.parts.iter().enumerate().filter(|(_, part)| part.kind == "attached_rotor");
    parts.filter_map(|(number, part)| rotor(mechanism, part, number, pairs)).collect()
}

fn rotor(mechanism: &Assembled, part: &AssembledPart, number: usize, pairs: &mut [Pair]) -> Option<Rotor> {
    let body = mechanism.bodies.iter().position(|body| is_inside(&body.name, &part.name))?;
    let is_own = |(other, _): &&(usize, f64)| *other == body;
    let ties = part.rows.iter().flatten().map(|row| &row.angles);
    let angles = ties.into_iter().find(|angles| angles.iter().any(|of| is_own(&of)))?;
    let (own, others): (Vec<_>, Vec<_>) = angles.iter().partition(is_own);
    let hinges = pairs.iter_mut().filter(|pair| pair.kind == Kind::Revolute);
    let (pair, factor) = hinges
        .filter_map(|pair| pair.factor_in(&others).map(|factor| (pair, factor)))
        .find(|(_, factor)| *factor != 0.0)?;
    let ratio = factor / own.iter().map(|(_, factor)| factor).sum::<f64>();
    pair.hinge.armature += mechanism.bodies[body].inertia * ratio * ratio;
    Some(Rotor { part: number, body })
}

/// Is it the name of something inside of a part?
pub(super) fn is_inside(name: &str, part: &str) -> bool {
    name.strip_prefix(part).is_some_and(|rest| rest.starts_with('.'))
}

/// Constraints of the declaration between one hinge or two.
pub(super) fn couplings(mechanism: &Assembled, pairs: &[Pair], tree: &Tree) -> Vec<Coupling> {
    let rows = mechanism.parts.iter().enumerate().filter(|(_, part)| part.kind == "constraint");
    rows.filter_map(|(number, part)| coupling(part, number, pairs, tree)).collect()
}

fn coupling(part: &AssembledPart, number: usize, pairs: &[Pair], tree: &Tree) -> Option<Coupling> {
    let [Some(Affine { angles, speeds, input: None, .. })] = &part.rows[..] else { return None };
    let hinges = tree.in_hinges(angles, pairs).filter(|_| speeds.is_empty())?;
    if hinges.iter().any(|(pair, _)| pairs[*pair].kind != Kind::Revolute) {
        return None;
    }
    let of = match hinges[..] {
        [_] => None,
        [(_, own), (other, factor)] => Some((other, -factor / own)),
        _ => return None,
    };
    hinges.first().map(|(pair, _)| Coupling { part: number, pair: *pair, of })
}
