//! Joints, rotors on them, joints that follow others, and outputs.

use super::drive::Drives;
use super::{Lines, sum};
use crate::names::Names;
use crate::number::{angle, length, short};
use crate::planar::{Pair, PairKind, Planar};
use crate::space::dot;
use crate::spatial::{Joint, Kind, Spatial};

/// Units of a joint's coordinate and of what acts along it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    /// The output that is the coordinate.
    pub(super) coordinate: &'static str,
    pub(super) unit: &'static str,
    pub(super) force: &'static str,
    pub(super) stiffness: &'static str,
    pub(super) damping: &'static str,
    /// The parameter at which a spring is free, the port of a rotor, the rotor and its inertia.
    rest: &'static str,
    node: &'static str,
    rotor: [&'static str; 3],
}

pub(super) const TURNING: Units = Units {
    coordinate: "angle",
    unit: "rad",
    force: "N*m",
    stiffness: "N*m/rad",
    damping: "N*m*s/rad",
    rest: "rest",
    node: "shaft",
    rotor: ["attached_rotor", "inertia", "kg*m^2"],
};

pub(super) const SLIDING: Units = Units {
    coordinate: "displacement",
    unit: "m",
    force: "N",
    stiffness: "N/m",
    damping: "N*s/m",
    rest: "free_length",
    node: "slider",
    rotor: ["attached_mass", "mass", "kg"],
};

impl Units {
    /// A coordinate as it is written.
    fn value(&self, coordinate: f64) -> String {
        if self.unit == "rad" { angle(coordinate) } else { format!("{} m", length(coordinate)) }
    }
}

/// The units of a pair that has a coordinate with forces.
pub(super) fn units(kind: PairKind) -> Option<Units> {
    match kind {
        PairKind::Revolute => Some(TURNING),
        PairKind::Prismatic | PairKind::Slide => Some(SLIDING),
        PairKind::Weld | PairKind::Slot | PairKind::Upright => None,
    }
}

/// Does a hinge have its bodies in the other order than the file?
pub(super) fn is_reversed(planar: &Planar, spatial: &Spatial, pair: &Pair) -> bool {
    let joint = &spatial.joints[pair.joint];
    pair.kind == PairKind::Revolute
        && joint.kind == Kind::Revolute
        && dot(joint.axis, planar.plane.normal) < 0.0
}

pub(super) fn pairs(
    planar: &Planar,
    spatial: &Spatial,
    drives: &Drives,
    names: &mut Names,
    lines: &mut Lines,
) {
    for (number, pair) in planar.pairs.iter().enumerate() {
        let (a, b) = (planar.path(pair.a), planar.path(pair.b));
        let name = &pair.name;
        match pair.kind {
            PairKind::Revolute | PairKind::Prismatic | PairKind::Slide => {
                let word = match pair.kind {
                    PairKind::Revolute => "revolute",
                    PairKind::Slide => "free_slide",
                    _ => "prismatic",
                };
                let joint = &spatial.joints[pair.joint];
                let Some(units) = units(pair.kind) else { continue };
                let mut fields = fields(joint, &units);
                fields.extend(drives.law(number).map(|law| format!("drive: {law};")));
                if fields.is_empty() {
                    lines.line(&format!("{word} {name}({a}, {b});"));
                } else {
                    lines.block(&format!("{word} {name}({a}, {b})"), |lines| {
                        for field in &fields {
                            lines.line(field);
                        }
                    });
                }
                if joint.armature > 0.0 {
                    let rotor = names.give(&format!("{name}_rotor"), "part");
                    let [part, field, unit] = units.rotor;
                    // It starts where the joint does: else assembly would move both.
                    let start = match joint.start {
                        0.0 => String::new(),
                        start => format!("start: {}; ", units.value(start)),
                    };
                    lines.line(&format!(
                        "{part} {rotor}({name}.{}) {{ {field}: {} {unit}; {start}}}",
                        units.node,
                        short(joint.armature)
                    ));
                }
            }
            PairKind::Weld => lines.line(&format!("weld {name}({a}, {b});")),
            PairKind::Slot => lines.line(&format!("pin_slot {name}({a}, {b});")),
            PairKind::Upright => lines.line(&format!("constraint {name}: {a}.angle = {b}.angle;")),
        }
    }
}

/// Parameters of a joint.
fn fields(joint: &Joint, units: &Units) -> Vec<String> {
    let value = |coordinate: f64| units.value(coordinate);
    let mut fields = Vec::new();
    if joint.stiffness != 0.0 {
        fields.push(format!("stiffness: {} {};", short(joint.stiffness), units.stiffness));
        if joint.rest != 0.0 {
            fields.push(format!("{}: {};", units.rest, value(joint.rest)));
        }
    }
    if joint.damping != 0.0 {
        fields.push(format!("damping: {} {};", short(joint.damping), units.damping));
    }
    if joint.friction != 0.0 {
        fields.push(format!("seal_friction: {} {};", short(joint.friction), units.force));
    }
    fields.extend(joint.lower.map(|lower| format!("lower_limit: {};", value(lower))));
    fields.extend(joint.upper.map(|upper| format!("upper_limit: {};", value(upper))));
    if let Some([stiffness, damping]) = joint.soft.filter(|_| joint.lower.is_some() || joint.upper.is_some())
    {
        fields.push(format!("limit_stiffness: {} {};", short(stiffness), units.stiffness));
        fields.push(format!("limit_damping: {} {};", short(damping), units.damping));
    }
    fields
}

/// Constraints of joints that follow others.
pub(super) fn couplings(planar: &Planar, spatial: &Spatial, names: &mut Names, lines: &mut Lines) {
    for coupling in &spatial.couplings {
        let pair = |joint: usize| planar.pairs.iter().find(|pair| pair.joint == joint);
        let path = |pair: &Pair| {
            units(pair.kind).map(|units| (format!("{}.{}", pair.name, units.coordinate), units.unit))
        };
        let Some((own, unit)) = pair(coupling.joint).and_then(path) else { continue };
        let other = coupling.of.and_then(pair).and_then(path);
        let mut terms = Vec::new();
        for (power, coefficient) in
            coupling.coefficients.iter().enumerate().filter(|(_, value)| **value != 0.0)
        {
            let size = short(coefficient.abs());
            let term = match &other {
                _ if power == 0 => format!("{size} {unit}"),
                None => continue,
                Some((of, of_unit)) => term(&size, unit, of, of_unit, power),
            };
            terms.push((*coefficient < 0.0, term));
        }
        let name = names.give(&coupling.name, "row");
        lines.line(&format!("constraint {name}: {own} = {};", sum(&terms)));
    }
}

/// A power of a coordinate with its factor, in the unit of another coordinate; radians cancel.
fn term(size: &str, unit: &str, of: &str, of_unit: &str, power: usize) -> String {
    let of = if power == 1 { of.to_owned() } else { format!("{of}^{power}") };
    let unit = match (unit, of_unit) {
        ("rad", "rad") => String::new(),
        (unit, "rad") => format!(" {unit}"),
        (unit, of_unit) if unit == of_unit && power == 1 => String::new(),
        (unit, of_unit) => format!(" {unit}/{of_unit}^{power}"),
    };
    if size == "1" && unit.is_empty() { of } else { format!("{size}{unit}*{of}") }
}

/// Coordinates of all joints, as the file counts them.
pub(super) fn outputs(planar: &Planar, lines: &mut Lines) {
    let names = planar
        .pairs
        .iter()
        .filter_map(|pair| units(pair.kind).map(|units| format!("{}.{}", pair.name, units.coordinate)));
    let names: Vec<String> = names.collect();
    if !names.is_empty() {
        lines.line(&format!("output {};", names.join(", ")));
    }
}
