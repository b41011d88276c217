//! `modelDescription.xml`, from the tables of a mechanism.

mod units;
mod variables;

use alloc::string::String;
use core::fmt::{self, Write};

use plm_runtime::contact::Mode;
use plm_runtime::described::Quantity;

use self::units::Units;
use self::variables::Row;
use super::follow;
use super::method::{Choice, Settings};
use super::names::names;
use super::structure::structure;
use super::{Exchanged, Variable, Version};
use crate::ffi::Block;
use crate::{Names, Text};

/// The types of the method's parameter and of modes of contact rows; no name of a declaration contains parentheses.
const METHODS: &str = "plm(methods)";
const MODES: &str = "plm(contact)";

/// Token that identifies the FMU: the name of the mechanism and a number of its declaration.
pub fn token<M: Exchanged>() -> Text {
    Text::of(format_args!("{{{}-{:016x}}}", M::TABLES.name, Block::<M>::MARK))
}

/// Writes `modelDescription.xml` of a mechanism for a version of the standard.
///
/// # Errors
/// Those of the writer.
pub fn description<M: Exchanged>(version: Version, declared: &M, to: &mut impl Write) -> fmt::Result {
    let (mut units, mut variables) = (Units::default(), String::new());
    for ((reference, variable), name) in Variable::all(declared).enumerate().zip(names(declared)) {
        Row::new(declared, (reference, variable, name), &mut units).write(version, &mut variables)?;
    }
    writeln!(to, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    head(version, declared, to)?;
    writeln!(to, "  <UnitDefinitions>")?;
    units.write(to)?;
    writeln!(to, "  </UnitDefinitions>\n  <TypeDefinitions>")?;
    let methods = Choice::ALL.into_iter().map(|choice| (choice.number(), choice.words()));
    enumeration(version, METHODS, methods, to)?;
    if declared.contact_count() > 0 {
        let modes = Mode::ALL.into_iter().map(|mode| (mode.number(), of_mode(mode)));
        enumeration(version, MODES, modes, to)?;
    }
    writeln!(to, "  </TypeDefinitions>\n  <LogCategories>")?;
    writeln!(to, "    <Category name=\"logStatusWarning\"/>")?;
    writeln!(to, "    <Category name=\"logStatusDiscard\"/>\n    <Category name=\"logStatusError\"/>")?;
    let tolerance = Settings::usual::<M>().tolerance;
    writeln!(to, "  </LogCategories>\n  <DefaultExperiment startTime=\"0\" tolerance=\"{tolerance:?}\"/>")?;
    writeln!(to, "  <ModelVariables>\n{variables}  </ModelVariables>\n  <ModelStructure>")?;
    structure(version, declared, to)?;
    writeln!(to, "  </ModelStructure>\n</fmiModelDescription>")
}

/// The mechanism, and what it can do.
fn head<M: Exchanged>(version: Version, declared: &M, to: &mut impl Write) -> fmt::Result {
    let (name, docs, token) = (M::TABLES.name, M::TABLES.docs, token::<M>());
    write!(to, "<fmiModelDescription fmiVersion=\"{}\" modelName=\"{}\"", version.number(), Xml(name))?;
    write!(to, " {}=\"{}\"", version.pick("guid", "instantiationToken"), Xml(token.as_str()))?;
    write!(to, " description=\"{}\" generationTool=\"plm {}\"", Xml(docs), env!("CARGO_PKG_VERSION"))?;
    if version == Version::Two {
        write!(to, " numberOfEventIndicators=\"{}\"", follow::indicators(declared))?;
    }
    writeln!(to, " variableNamingConvention=\"flat\">")?;
    let own = version.pick(
        "canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\" providesDirectionalDerivative=\"true\" \
         canNotUseMemoryManagementFunctions=\"true\"",
        "canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\" providesDirectionalDerivatives=\"true\"",
    );
    // In 2.0 an importer calls it unless this attribute says otherwise.
    let exchange = version.pick("", " needsCompletedIntegratorStep=\"true\"");
    let events = version.pick("", " hasEventMode=\"true\"");
    let identifier = Names::lower(name);
    writeln!(to, "  <ModelExchange modelIdentifier=\"{identifier}\" {own}{exchange}/>")?;
    writeln!(
        to,
        "  <CoSimulation modelIdentifier=\"{identifier}\" {own} canHandleVariableCommunicationStepSize=\"true\"{events}/>"
    )
}

/// A type of whole numbers: each with its name, and what it is.
fn enumeration<N: fmt::Display>(
    version: Version,
    name: &str,
    items: impl Iterator<Item = (N, (&'static str, &'static str))>,
    to: &mut impl Write,
) -> fmt::Result {
    let (begin, inner, end) = version.pick(
        ("SimpleType", "<Enumeration>", "    </Enumeration></SimpleType>"),
        ("EnumerationType", "", "    </EnumerationType>"),
    );
    writeln!(to, "    <{begin} name=\"{name}\">{inner}")?;
    for (number, (name, what)) in items {
        writeln!(to, "      <Item name=\"{name}\" value=\"{number}\" description=\"{}\"/>", Xml(what))?;
    }
    writeln!(to, "{end}")
}

/// Name and description of a mode of contact.
fn of_mode(mode: Mode) -> (&'static str, &'static str) {
    match mode {
        Mode::Open => ("open", "a gap is open"),
        Mode::Closed => ("closed", "a gap is closed"),
        Mode::Off => ("unloaded", "a friction has no normal force"),
        Mode::Sticks => ("sticks", "a friction holds"),
        Mode::Forwards => ("forwards", "a friction slips forwards"),
        Mode::Backwards => ("backwards", "a friction slips backwards"),
    }
}

/// The declared output of an observed quantity, if it is one.
pub(super) fn output<M: Exchanged>(index: usize) -> Option<&'static Quantity> {
    let (name, _) = M::OBSERVED.get(index)?;
    M::TABLES.outputs.iter().find(|row| row.name == *name)
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
