//! `modelDescription.xml`, from the tables of a mechanism.

use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::{String, ToString};
use core::fmt::{self, Write};

use plm_runtime::described::Quantity;
use plm_runtime::{StartValues, System, Vector};

use super::names::names;
use super::structure::structure;
use super::{Exchanged, Variable};
use crate::border::Block;
use crate::{Names, Si, Text};

/// Exponents of m, kg, s, K, A, mol, rad, as [`Quantity`] has them.
type Exponents = [i8; 7];

/// SI units with a name of their own.
const NAMED: [(&str, Exponents); 20] = [
    ("m", [1, 0, 0, 0, 0, 0, 0]),
    ("kg", [0, 1, 0, 0, 0, 0, 0]),
    ("s", [0, 0, 1, 0, 0, 0, 0]),
    ("K", [0, 0, 0, 1, 0, 0, 0]),
    ("A", [0, 0, 0, 0, 1, 0, 0]),
    ("mol", [0, 0, 0, 0, 0, 1, 0]),
    ("rad", [0, 0, 0, 0, 0, 0, 1]),
    ("N", [1, 1, -2, 0, 0, 0, 0]),
    ("Pa", [-1, 1, -2, 0, 0, 0, 0]),
    ("J", [2, 1, -2, 0, 0, 0, 0]),
    ("W", [2, 1, -3, 0, 0, 0, 0]),
    ("Hz", [0, 0, -1, 0, 0, 0, 0]),
    ("C", [0, 0, 1, 0, 1, 0, 0]),
    ("V", [2, 1, -3, 0, -1, 0, 0]),
    ("ohm", [2, 1, -3, 0, -2, 0, 0]),
    ("F", [-2, -1, 4, 0, 2, 0, 0]),
    ("H", [2, 1, -2, 0, -2, 0, 0]),
    ("Wb", [2, 1, -2, 0, -1, 0, 0]),
    ("T", [0, 1, -2, 0, -1, 0, 0]),
    ("1", [0; 7]),
];

/// Units by name: their exponents, and the units for display with their factors.
type Units = BTreeMap<String, (Exponents, BTreeMap<String, f64>)>;

/// Tells FMUs apart: the name of the mechanism and a number of its declaration.
pub fn token<M: Exchanged>() -> Text {
    Text::of(format_args!("{{{}-{:016x}}}", M::TABLES.name, Block::<M>::MARK))
}

/// Writes `modelDescription.xml` of a mechanism.
///
/// # Errors
/// Those of the writer.
pub fn description<M: Exchanged>(declared: &M, to: &mut impl Write) -> fmt::Result {
    let (name, docs) = (M::TABLES.name, M::TABLES.docs);
    let (mut units, mut variables) = (Units::new(), String::new());
    for ((reference, variable), name) in Variable::all(declared).enumerate().zip(names(declared)) {
        line(declared, (reference, variable, &name), &mut units, &mut variables)?;
    }
    let identifier = Names::lower(name);
    writeln!(to, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    writeln!(to, "<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\"", Xml(name))?;
    writeln!(to, "  instantiationToken=\"{}\" description=\"{}\"", Xml(token::<M>().as_str()), Xml(docs))?;
    writeln!(
        to,
        "  generationTool=\"plm {}\" variableNamingConvention=\"flat\">",
        env!("CARGO_PKG_VERSION")
    )?;
    let common = format!(
        "modelIdentifier=\"{identifier}\" canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\" providesDirectionalDerivatives=\"true\""
    );
    writeln!(to, "  <ModelExchange {common} needsCompletedIntegratorStep=\"true\"/>")?;
    writeln!(
        to,
        "  <CoSimulation {common} canHandleVariableCommunicationStepSize=\"true\" hasEventMode=\"true\"/>"
    )?;
    writeln!(to, "  <UnitDefinitions>")?;
    units.iter().try_for_each(|(name, unit)| unit_line(name, unit, to))?;
    writeln!(to, "  </UnitDefinitions>")?;
    writeln!(to, "  <LogCategories>\n    <Category name=\"logStatusError\"/>\n  </LogCategories>")?;
    writeln!(
        to,
        "  <DefaultExperiment startTime=\"0\"/>\n  <ModelVariables>\n{variables}  </ModelVariables>"
    )?;
    writeln!(to, "  <ModelStructure>")?;
    structure(declared, to)?;
    writeln!(to, "  </ModelStructure>")?;
    writeln!(to, "</fmiModelDescription>")
}

/// The declared output of an observed quantity, if it is one.
pub(super) fn output<M: Exchanged>(index: usize) -> Option<&'static Quantity> {
    let (name, _) = M::OBSERVED.get(index)?;
    M::TABLES.outputs.iter().find(|row| row.name == *name)
}

/// One variable.
fn line<M: Exchanged>(
    declared: &M,
    (reference, variable, name): (usize, Variable, &str),
    units: &mut Units,
    to: &mut String,
) -> fmt::Result {
    let tables = M::TABLES;
    let states = <M as System>::X::LEN;
    let (more, row) = match variable {
        Variable::Time => ("causality=\"independent\"".to_string(), None),
        Variable::Parameter(k) => {
            let start = declared.parameter(k).unwrap_or_default();
            let more = format!("causality=\"parameter\" variability=\"tunable\" start=\"{start:?}\"");
            (more, tables.parameters.get(k))
        }
        Variable::Start(k) => {
            let (mut copy, mut at, mut start) = (*declared, 0, 0.0);
            copy.starts_mut().each(&mut |_, own| {
                if at == k {
                    start = own.value;
                }
                at += 1;
            });
            (format!("causality=\"parameter\" variability=\"fixed\" start=\"{start:?}\""), None)
        }
        Variable::Input(k) => {
            let start = tables.inputs.get(k).and_then(|row| row.default).unwrap_or_default();
            (format!("causality=\"input\" start=\"{start:?}\""), tables.inputs.get(k))
        }
        Variable::Output(k) => {
            let causality = if output::<M>(k).is_some() { "output" } else { "local" };
            (format!("causality=\"{causality}\""), output::<M>(k))
        }
        Variable::State(k) => {
            let nominal = declared.typical().at(k);
            let more = "causality=\"local\" initial=\"calculated\" reinit=\"true\"";
            (format!("{more} nominal=\"{nominal:?}\""), None)
        }
        Variable::Rate(_) => (format!("causality=\"local\" derivative=\"{}\"", reference - states), None),
        Variable::Indicator(_) => ("causality=\"local\"".to_string(), None),
    };
    write!(to, "    <Float64 name=\"{}\" valueReference=\"{reference}\" {more}", Xml(name))?;
    let observed = if let Variable::Output(k) = variable { M::OBSERVED.get(k) } else { None };
    match (row, observed) {
        (Some(row), _) => write!(to, "{}", with_unit(row, units))?,
        (None, Some((_, unit))) if named(unit).is_some() => {
            units.entry((*unit).to_string()).or_insert((named(unit).unwrap_or_default(), BTreeMap::new()));
            write!(to, " unit=\"{}\"", Xml(unit))?;
        }
        (None, _) => {
            let unit = match variable {
                Variable::Time => "s",
                Variable::Start(k) => *["m", "m", "rad", "m/s", "m/s", "rad/s"]
                    .get(k % 6)
                    .filter(|_| k < 6 * tables.bodies.len())
                    .unwrap_or(&""),
                _ => "",
            };
            if let Some(exponents) = named(unit) {
                units.entry(unit.to_string()).or_insert((exponents, BTreeMap::new()));
                write!(to, " unit=\"{unit}\"")?;
            }
        }
    }
    if let Some(row) = row.filter(|row| !row.docs.is_empty()) {
        write!(to, " description=\"{}\"", Xml(row.docs))?;
    }
    writeln!(to, "/>")
}

/// The unit of a quantity, and the one for display.
fn with_unit(row: &Quantity, units: &mut Units) -> String {
    let si = Si(row).to_string();
    if row.unit.is_empty() || si.is_empty() {
        return String::new();
    }
    let (_, display) = units.entry(si.clone()).or_insert((row.exponents, BTreeMap::new()));
    if row.unit == si {
        return format!(" unit=\"{}\"", Xml(&si));
    }
    display.insert(row.unit.to_string(), 1.0 / row.factor);
    format!(" unit=\"{}\" displayUnit=\"{}\"", Xml(&si), Xml(row.unit))
}

/// The exponents of a product of SI units, `kg*m^2/s`.
fn named(unit: &str) -> Option<Exponents> {
    let (mut sum, mut sign, mut rest) = ([0; 7], 1, unit);
    while !rest.is_empty() {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let (factor, after) = rest.split_at(end);
        let (name, power) =
            factor.split_once('^').map_or((factor, Ok(1)), |(name, power)| (name, power.parse::<i8>()));
        let (_, own) = NAMED.iter().find(|(own, _)| *own == name)?;
        let power = sign * power.ok()?;
        sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += power * own);
        sign = if after.starts_with('/') { -1 } else { 1 };
        rest = after.get(1..).unwrap_or_default();
    }
    (!unit.is_empty()).then_some(sum)
}

fn unit_line(
    name: &str,
    (exponents, display): &(Exponents, BTreeMap<String, f64>),
    to: &mut impl Write,
) -> fmt::Result {
    write!(to, "    <Unit name=\"{}\">\n      <BaseUnit", Xml(name))?;
    for (base, exponent) in ["m", "kg", "s", "K", "A", "mol", "rad"].iter().zip(exponents) {
        if *exponent != 0 {
            write!(to, " {base}=\"{exponent}\"")?;
        }
    }
    writeln!(to, "/>")?;
    for (name, factor) in display {
        writeln!(to, "      <DisplayUnit name=\"{}\" factor=\"{factor:?}\"/>", Xml(name))?;
    }
    writeln!(to, "    </Unit>")
}

/// Text within XML.
struct Xml<'a>(&'a str);

impl fmt::Display for Xml<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|letter| match letter {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '"' => f.write_str("&quot;"),
            '\n' => f.write_str("&#10;"),
            other => f.write_char(other),
        })
    }
}
