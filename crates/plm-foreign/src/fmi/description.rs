//! `modelDescription.xml`, from the tables of a mechanism.

mod units;
mod variables;

use alloc::format;
use alloc::string::String;
use core::fmt::{self, Write};

use plm_runtime::contact::Mode;

use self::units::Units;
use self::variables::Row;
use super::method::Choice;
use super::structure::structure;
use super::{Code, Exchanged, Facts, Variable, Version};
use crate::ffi::Block;
use crate::{Names, Text};

/// The types of the method's parameter and of modes of contact rows; no name of a declaration contains parentheses.
const METHODS: &str = "plm(methods)";
const MODES: &str = "plm(contact)";

/// Token that identifies the FMU: the name of the mechanism and a number of its declaration.
pub fn token<M: Exchanged>() -> Text {
    Text::of(format_args!("{{{}-{:016x}}}", M::TABLES.name, Block::<M>::MARK))
}

/// Writes `modelDescription.xml` of a compiled mechanism for a version of the standard.
///
/// # Errors
/// Those of the writer.
pub fn description<M: Exchanged>(version: Version, declared: &M, to: &mut impl Write) -> fmt::Result {
    Facts::of(declared).describe(version, to)
}

impl Facts<'_> {
    /// Writes `modelDescription.xml` of an FMU with these facts for a version of the standard.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn describe(&self, version: Version, to: &mut impl Write) -> fmt::Result {
        let (mut units, mut variables) = (Units::default(), String::new());
        for ((reference, variable), name) in self.variables.iter().enumerate().zip(self.names()) {
            Row::new(self, (reference, *variable, name), &mut units).write(version, &mut variables)?;
        }
        writeln!(to, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
        self.head(version, to)?;
        if !units.is_empty() {
            writeln!(to, "  <UnitDefinitions>")?;
            units.write(to)?;
            writeln!(to, "  </UnitDefinitions>")?;
        }
        self.types(version, to)?;
        writeln!(to, "  <LogCategories>\n    <Category name=\"logStatusWarning\"/>")?;
        writeln!(to, "    <Category name=\"logStatusDiscard\"/>\n    <Category name=\"logStatusError\"/>")?;
        write!(to, "  </LogCategories>\n  <DefaultExperiment startTime=\"{}\"", self.time)?;
        if let Some(tolerance) = self.tolerance {
            write!(to, " tolerance=\"{tolerance:?}\"")?;
        }
        if matches!(self.code, Code::Source(_)) && self.interfaces.co_simulation() {
            write!(to, " stepSize=\"{:?}\"", self.step)?;
        }
        writeln!(to, "/>\n  <ModelVariables>\n{variables}  </ModelVariables>\n  <ModelStructure>")?;
        structure(version, self, to)?;
        writeln!(to, "  </ModelStructure>\n</fmiModelDescription>")
    }

    /// The types of whole numbers that variables have.
    fn types(&self, version: Version, to: &mut impl Write) -> fmt::Result {
        let has_methods = self.variables.contains(&Variable::Method);
        if !has_methods && self.contacts.is_empty() {
            return Ok(());
        }
        writeln!(to, "  <TypeDefinitions>")?;
        if has_methods {
            let methods = Choice::ALL.into_iter().map(|choice| (choice.number(), choice.words()));
            enumeration(version, METHODS, methods, to)?;
        }
        if !self.contacts.is_empty() {
            let modes = Mode::ALL.into_iter().map(|mode| (mode.number(), of_mode(mode)));
            enumeration(version, MODES, modes, to)?;
        }
        writeln!(to, "  </TypeDefinitions>")
    }

    /// The mechanism, and what it can do.
    fn head(&self, version: Version, to: &mut impl Write) -> fmt::Result {
        let (name, docs) = (self.tables.name, self.tables.docs);
        write!(to, "<fmiModelDescription fmiVersion=\"{}\" modelName=\"{}\"", version.number(), Xml(name))?;
        write!(to, " {}=\"{}\"", version.pick("guid", "instantiationToken"), Xml(&self.token))?;
        write!(to, " description=\"{}\" generationTool=\"plm {}\"", Xml(docs), env!("CARGO_PKG_VERSION"))?;
        if version == Version::Two {
            write!(to, " numberOfEventIndicators=\"{}\"", self.indicators())?;
        }
        writeln!(to, " variableNamingConvention=\"flat\">")?;
        // In 2.0 an importer calls it unless this attribute says otherwise.
        let exchange = version.pick("", " needsCompletedIntegratorStep=\"true\"");
        let events =
            if self.code == Code::Compiled { version.pick("", " hasEventMode=\"true\"") } else { "" };
        if self.interfaces.exchange() {
            self.interface("ModelExchange", version, exchange, to)?;
        }
        if self.interfaces.co_simulation() {
            let own = format!(" canHandleVariableCommunicationStepSize=\"true\"{events}");
            self.interface("CoSimulation", version, &own, to)?;
        }
        Ok(())
    }

    /// An interface: its abilities, and the files of its source.
    fn interface(&self, interface: &str, version: Version, own: &str, to: &mut impl Write) -> fmt::Result {
        let states = version.pick(
            "canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\"",
            "canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\"",
        );
        let compiled = version.pick(
            " providesDirectionalDerivative=\"true\" canNotUseMemoryManagementFunctions=\"true\"",
            " providesDirectionalDerivatives=\"true\"",
        );
        let made = if self.code == Code::Compiled { compiled } else { "" };
        let identifier = Names::lower(self.tables.name);
        write!(to, "  <{interface} modelIdentifier=\"{identifier}\" {states}{made}{own}")?;
        match self.code {
            // 3.0 lists them in a file of their own.
            Code::Source(files) if version == Version::Two => {
                writeln!(to, ">\n    <SourceFiles>")?;
                for file in files {
                    writeln!(to, "      <File name=\"{}\"/>", Xml(file))?;
                }
                writeln!(to, "    </SourceFiles>\n  </{interface}>")
            }
            _ => writeln!(to, "/>"),
        }
    }
}

/// Writes `buildDescription.xml` of FMI 3.0: the files of a source in C99, which need nothing else.
///
/// # Errors
/// Those of the writer.
pub fn build_description(identifier: &str, files: &[&str], to: &mut impl Write) -> fmt::Result {
    writeln!(to, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiBuildDescription fmiVersion=\"3.0\">")?;
    writeln!(to, "  <BuildConfiguration modelIdentifier=\"{}\">", Xml(identifier))?;
    writeln!(to, "    <SourceFileSet language=\"C99\">")?;
    for file in files {
        writeln!(to, "      <SourceFile name=\"{}\"/>", Xml(file))?;
    }
    writeln!(to, "    </SourceFileSet>\n  </BuildConfiguration>\n</fmiBuildDescription>")
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
