//! `<actuator>`: inputs that drive joints.

use super::Reader;
use super::compiler::Effect;
use crate::spatial::{Drive, Quantity};
use crate::xml::Element;

/// By what an actuator acts that drives no joint.
fn way(element: &Element) -> String {
    let named = |what: &str, attribute: &str| element.get(attribute).map(|name| format!("{what} `{name}`"));
    let slider = named("acts by a slider-crank on the site", "slidersite")
        .or(named("acts by a slider-crank on the site", "cranksite"));
    let known = named("acts by the tendon", "tendon")
        .or(slider)
        .or(named("acts at the site", "site"))
        .or(named("acts at the body", "body"));
    match (known, named("drives the joint", "joint")) {
        (Some(way), _) => format!("{way}, which is not taken"),
        (None, Some(joint)) => format!("{joint}, which is not known"),
        (None, None) => "drives no joint".to_owned(),
    }
}

impl Reader<'_> {
    pub(super) fn actuator(&mut self, element: &Element) {
        if !self.compiler.has(Effect::Actuation) {
            self.notices.warn(&element.place, format!("{}: actuation is disabled", element.shown()));
            return;
        }
        let element = self.defaults.styled(element, None, self.notices);
        let Some(&joint) = element.get("joint").and_then(|name| self.joints.get(name)) else {
            let why = format!("{} {}", element.shown(), way(&element));
            if is_without_bias(&element) {
                self.notices.warn(&element.place, format!("{why}: its input is left out"));
            } else {
                self.notices.error(&element.place, format!("{why}, and acts without an input"));
            }
            return;
        };
        let Some((gain, bias, input)) = self.law(&element) else { return };
        let gear =
            element.numbers("gear", self.notices).and_then(|gear| gear.first().copied()).unwrap_or(1.0);
        // In radians, whatever the unit of the file.
        let input_range = self.range(&element, "ctrlrange", "ctrllimited");
        let force_range = self.range(&element, "forcerange", "forcelimited");
        let name = element
            .get("name")
            .map_or_else(|| format!("{}_input", self.spatial.joints[joint].name), str::to_owned);
        let place = element.place.clone();
        self.spatial.drives.push(Drive {
            name,
            place,
            joint,
            gear,
            gain,
            bias,
            input,
            input_range,
            force_range,
        });
    }

    /// Gain, bias and input of an actuator.
    fn law(&mut self, element: &Element) -> Option<(f64, [f64; 3], Quantity)> {
        let mut number = |name: &str, default: f64| element.number(name, self.notices).unwrap_or(default);
        match element.name.as_str() {
            "motor" => Some((1.0, [0.0; 3], Quantity::Number)),
            "position" if element.get("timeconst").is_none() && element.get("dampratio").is_none() => {
                let (kp, kv) = (number("kp", 1.0), number("kv", 0.0));
                Some((kp, [0.0, -kp, -kv], Quantity::Coordinate))
            }
            "velocity" => {
                let kv = number("kv", 1.0);
                Some((kv, [0.0, 0.0, -kv], Quantity::Rate))
            }
            "general" if element.get("dyntype").is_none_or(|kind| kind == "none") => self.general(element),
            // Their force is none while the input is 0.
            "damper" | "adhesion" => {
                self.notices.warn(
                    &element.place,
                    format!("{}: actuators of this kind are not taken", element.shown()),
                );
                None
            }
            _ => {
                let why = "actuators of this kind are not taken, and this one acts without an input";
                self.notices.error(&element.place, format!("{}: {why}", element.shown()));
                None
            }
        }
    }

    fn general(&mut self, element: &Element) -> Option<(f64, [f64; 3], Quantity)> {
        let first = |numbers: Option<Vec<f64>>, k: usize| numbers.and_then(|numbers| numbers.get(k).copied());
        let gain = first(element.numbers("gainprm", self.notices), 0).unwrap_or(1.0);
        let is_fixed = element.get("gaintype").is_none_or(|kind| kind == "fixed");
        let bias = match element.get("biastype").unwrap_or("none") {
            "none" => Some([0.0; 3]),
            "affine" => {
                let numbers = element.numbers("biasprm", self.notices).unwrap_or_default();
                Some(std::array::from_fn(|k| numbers.get(k).copied().unwrap_or_default()))
            }
            _ => None,
        };
        if bias.is_none() || !is_fixed {
            self.notices.error(
                &element.place,
                format!(
                    "{}: actuators of this kind are not taken, and this one acts without an input",
                    element.shown()
                ),
            );
        }
        Some((gain, bias?, Quantity::Number)).filter(|_| is_fixed)
    }
}

/// Does an actuator without input give no force?
fn is_without_bias(element: &Element) -> bool {
    let has_bias = element.get("biastype").is_some_and(|kind| kind != "none");
    matches!(element.name.as_str(), "motor" | "damper" | "adhesion")
        || (element.name == "general" && !has_bias)
}
