//! Inputs, and the drives of joints that read them.

use super::joint::{Units, units};
use super::{Lines, sum};
use crate::names::Names;
use crate::number::short;
use crate::planar::Planar;
use crate::spatial::{Drive, Quantity, Spatial};

/// Inputs with their units, and the law of each driven pair.
#[derive(Debug, Default)]
pub(super) struct Drives {
    /// Name, unit, and what it is.
    inputs: Vec<(String, String, String)>,
    /// By the number of the pair.
    laws: Vec<(usize, String)>,
}

impl Drives {
    pub(super) fn of(planar: &Planar, spatial: &Spatial, names: &mut Names) -> Drives {
        let mut drives = Drives::default();
        for drive in &spatial.drives {
            let pair = planar.pairs.iter().position(|pair| pair.joint == drive.joint);
            let Some((number, units)) =
                pair.and_then(|number| Some((number, units(planar.pairs[number].kind)?)))
            else {
                continue;
            };
            let joint = &planar.pairs[number].name;
            let input = names.give(&drive.name, "input");
            let unit = match drive.input {
                Quantity::Number => "1".to_owned(),
                Quantity::Coordinate => units.unit.to_owned(),
                Quantity::Rate => format!("{}/s", units.unit),
                Quantity::Force => units.force.to_owned(),
            };
            drives.laws.push((number, law(drive, &input, &unit, joint, &units)));
            let shown = match drive.input {
                Quantity::Number => "Control",
                Quantity::Coordinate => "Wanted place",
                Quantity::Rate => "Wanted speed",
                Quantity::Force if units.unit == "rad" => "Torque",
                Quantity::Force => "Force",
            };
            drives.inputs.push((input, unit, format!("{shown} of `{joint}`.")));
        }
        drives
    }

    pub(super) fn inputs(&self, lines: &mut Lines) {
        for (name, unit, title) in &self.inputs {
            lines.line(&format!("/// {title}"));
            lines.line(&format!("input {name}: {unit} = 0;"));
        }
    }

    /// The expression that drives a pair.
    pub(super) fn law(&self, pair: usize) -> Option<String> {
        let laws: Vec<&str> =
            self.laws.iter().filter(|(of, _)| *of == pair).map(|(_, law)| law.as_str()).collect();
        (!laws.is_empty()).then(|| laws.join(" + "))
    }
}

/// `gear clamp(gain clamp(input) + bias)` as an expression of the language.
fn law(drive: &Drive, input: &str, unit: &str, joint: &str, units: &Units) -> String {
    let input = match drive.input_range {
        Some([low, high]) => {
            let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
            let bound =
                |bound: f64| if bound == 0.0 { "0".to_owned() } else { format!("{}{unit}", short(bound)) };
            format!("clamp({input}, {}, {})", bound(low), bound(high))
        }
        None => input.to_owned(),
    };
    // Without a bound of the force the gear is part of the factors.
    let outer = if drive.force_range.is_some() { 1.0 } else { drive.gear };
    let of_input = match drive.input {
        Quantity::Number => units.force,
        Quantity::Coordinate => units.stiffness,
        Quantity::Rate => units.damping,
        Quantity::Force => "",
    };
    let [constant, of_coordinate, of_rate] = drive.bias;
    let mut terms = Vec::new();
    let mut term = |factor: f64, unit: &str, of: &str| {
        if factor == 0.0 {
            return;
        }
        let scale = match (short(factor.abs()), unit) {
            (one, "") if one == "1" => String::new(),
            (number, "") => format!("{number}*"),
            (number, unit) => format!("{number} {unit}*"),
        };
        terms.push((
            factor < 0.0,
            if of.is_empty() { scale.trim_end_matches('*').to_owned() } else { format!("{scale}{of}") },
        ));
    };
    term(outer * drive.gain, of_input, &input);
    term(outer * constant, units.force, "");
    term(outer * drive.gear * of_coordinate, units.stiffness, &format!("{joint}.{}", units.coordinate));
    term(outer * drive.gear * of_rate, units.damping, &format!("{joint}.speed"));
    let sum = sum(&terms);
    let Some([low, high]) = drive.force_range else { return sum };
    let bound =
        |bound: f64| if bound == 0.0 { "0".to_owned() } else { format!("{} {}", short(bound), units.force) };
    let bounded = format!("clamp({sum}, {}, {})", bound(low), bound(high));
    if drive.gear == 1.0 { bounded } else { format!("{}*{bounded}", short(drive.gear)) }
}
