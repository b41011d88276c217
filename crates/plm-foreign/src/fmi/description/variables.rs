//! Variables of the model description, and how each version writes them.

use alloc::format;
use alloc::string::{String, ToString};
use core::fmt::{self, Write};

use plm_runtime::described::Quantity;

use super::units::{Unit, Units};
use super::{METHODS, MODES, Xml};
use crate::fmi::{Facts, Parameter, Variable, Version};

/// Attributes of a variable; those that it lacks are empty.
#[derive(Default)]
pub(super) struct Row<'a> {
    reference: usize,
    name: String,
    causality: &'static str,
    variability: &'static str,
    initial: &'static str,
    start: Option<String>,
    unit: Unit,
    nominal: Option<f64>,
    /// The reference of the state that it is the rate of.
    of_state: Option<usize>,
    /// The type of a variable of whole numbers.
    whole: Option<&'static str>,
    docs: &'a str,
}

impl<'a> Row<'a> {
    /// That of a variable.
    pub(super) fn new(
        facts: &Facts<'a>,
        (reference, variable, name): (usize, Variable, String),
        units: &mut Units,
    ) -> Self {
        let (row, quantity) = Self::of(facts, variable);
        let unit = match (quantity, variable) {
            (Some(quantity), _) => units.of(quantity),
            (None, Variable::Output(k)) => units.named(facts.observed.get(k).map_or("", |(_, unit)| unit)),
            (None, Variable::Time | Variable::Step) => units.named("s"),
            (None, Variable::Start(k)) if k < 6 * facts.tables.bodies.len() => {
                units.named(["m", "m", "rad", "m/s", "m/s", "rad/s"].get(k % 6).unwrap_or(&""))
            }
            (None, Variable::State(k)) => unit_of_state(facts, k, units),
            (None, Variable::Rate(k)) => {
                let unit = unit_of_state(facts, k, &mut Units::default()).si;
                if unit.is_empty() { Unit::default() } else { units.rate_of(&unit) }
            }
            (None, _) => Unit::default(),
        };
        let of_state = matches!(variable, Variable::Rate(_)).then(|| reference - facts.states.len());
        let docs = quantity.map_or(row.docs, |quantity| quantity.docs);
        Self { reference, name, unit, of_state, docs, ..row }
    }

    /// Attributes of its kind, and the quantity that was declared.
    fn of(facts: &Facts<'a>, variable: Variable) -> (Self, Option<&'a Quantity>) {
        let tables = facts.tables;
        let number = |number: f64| Some(format!("{number:?}"));
        let row = |causality| Self { causality, ..Self::default() };
        let parameter = |variability, start| Self { variability, start, ..row("parameter") };
        match variable {
            Variable::Time => (row("independent"), None),
            Variable::Parameter(k) => {
                let own = facts.parameters.get(k);
                let start = number(own.map_or(0.0, |own| own.value));
                let row = match own {
                    Some(Parameter { is_constant: true, .. }) => {
                        Self { variability: "constant", initial: "exact", start, ..row("local") }
                    }
                    _ => parameter("tunable", start),
                };
                (row, tables.parameters.get(k))
            }
            Variable::Start(k) => {
                (parameter("fixed", number(facts.starts.get(k).map_or(0.0, |(_, value)| *value))), None)
            }
            Variable::Method => {
                let (start, docs) = (Some(String::from("1")), "method of co-simulation");
                (Self { whole: Some(METHODS), docs, ..parameter("fixed", start) }, None)
            }
            Variable::Step => {
                let docs = "longest step of methods of co-simulation with steps of fixed length";
                (Self { docs, ..parameter("fixed", number(facts.step)) }, None)
            }
            Variable::Input(k) => {
                let start = facts.inputs.get(k).copied().unwrap_or_default();
                (Self { start: number(start), ..row("input") }, tables.inputs.get(k))
            }
            Variable::Output(k) => {
                (row(if facts.output(k).is_some() { "output" } else { "local" }), facts.output(k))
            }
            Variable::State(k) => {
                let nominal = facts.states.get(k).map(|(_, nominal)| *nominal);
                (Self { initial: "calculated", nominal, ..row("local") }, None)
            }
            Variable::Rate(_) | Variable::Indicator(_) => (row("local"), None),
            Variable::Contact(_) => {
                let (variability, docs) = ("discrete", "what the row of contact does");
                (Self { whole: Some(MODES), variability, docs, ..row("local") }, None)
            }
        }
    }

    /// Writes it as a version has it.
    pub(super) fn write(&self, version: Version, to: &mut String) -> fmt::Result {
        let kind = match (version, self.whole) {
            (Version::Two, None) => "Real",
            (Version::Three, None) => "Float64",
            (_, Some(_)) => "Enumeration",
        };
        write!(to, "    <{}", version.pick("ScalarVariable", kind))?;
        self.of_variable(to)?;
        if version == Version::Two {
            write!(to, "><{kind}")?;
        }
        self.of_type(version, to)?;
        writeln!(to, "{}", version.pick("/></ScalarVariable>", "/>"))
    }

    /// The attributes that every variable may have.
    fn of_variable(&self, to: &mut String) -> fmt::Result {
        let Self { reference, name, causality, variability, initial, docs, .. } = self;
        write!(to, " name=\"{}\" valueReference=\"{reference}\" causality=\"{causality}\"", Xml(name))?;
        let mut more =
            [("variability", variability), ("initial", initial), ("description", docs)].into_iter();
        more.try_for_each(|(attribute, value)| {
            perhaps(to, attribute, Some(value).filter(|text| !text.is_empty()))
        })
    }

    /// The attributes of its type.
    fn of_type(&self, version: Version, to: &mut String) -> fmt::Result {
        let Self { start, unit, nominal, of_state, whole, .. } = self;
        perhaps(to, "declaredType", *whole)?;
        perhaps(to, "start", start.as_ref())?;
        perhaps(to, "unit", Some(&unit.si).filter(|unit| !unit.is_empty()))?;
        perhaps(to, "displayUnit", Some(&unit.display).filter(|unit| !unit.is_empty()))?;
        perhaps(to, "nominal", nominal.map(|nominal| format!("{nominal:?}")))?;
        perhaps(to, "reinit", nominal.map(|_| "true"))?;
        // 2.0 counts variables from 1.
        perhaps(to, "derivative", of_state.map(|state| (state + version.pick(1, 0)).to_string()))
    }
}

/// Writes an attribute that may not be there.
fn perhaps(to: &mut String, attribute: &str, value: Option<impl AsRef<str>>) -> fmt::Result {
    value.map_or(Ok(()), |value| write!(to, " {attribute}=\"{}\"", Xml(value.as_ref())))
}

/// The unit of a state; none of a coordinate that is an angle in one chart and a length in another.
fn unit_of_state(facts: &Facts, index: usize, units: &mut Units) -> Unit {
    if let Some(row) = index.checked_sub(2 * facts.coordinates).and_then(|k| facts.tables.states.get(k)) {
        return units.of(row);
    }
    let unit = |name: &str| match name.rsplit('.').next() {
        Some("angle") => "rad",
        Some("omega") => "rad/s",
        Some("x" | "y" | "displacement") => "m",
        Some("vx" | "vy" | "speed") => "m/s",
        _ => "",
    };
    let mut all = facts.states.get(index).map_or("", |(name, _)| name).split(" or ").map(unit);
    let first = all.next().unwrap_or_default();
    units.named(if all.all(|other| other == first) { first } else { "" })
}
