//! The module of a mechanism in the language Python, and its types.

use plm_foreign::{Foreign, Si, declared};
use plm_runtime::described::Quantity;
use plm_runtime::{Scalar, StartValues};

/// Keywords, which cannot be names.
const KEYWORDS: [&str; 35] = [
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue", "def",
    "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import", "in", "is",
    "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try", "while", "with", "yield",
];
/// Members of every mechanism, in `_mechanism.py`.
const MEMBERS: [&str; 22] = [
    "bodies",
    "contacts",
    "from_bytes",
    "get",
    "inputs",
    "jacobian",
    "linearise",
    "outputs",
    "parameters",
    "pose",
    "rates",
    "restore",
    "run",
    "save",
    "set",
    "starts",
    "state",
    "state_names",
    "states",
    "stats",
    "step",
    "time",
];
/// Keyword arguments of every mechanism, in `_mechanism.py`, with their types and defaults.
const OWN: [(&str, &str, &str); 6] = [
    ("start", "Mapping[str, float] | None", "None"),
    ("method", "str", "\"dop853\""),
    ("tolerance", "float | None", "None"),
    ("longest_step", "float | None", "None"),
    ("time", "float", "0.0"),
    ("parameters", "Mapping[str, float] | None", "None"),
];
/// Names of the module beside the mechanism, with the file of each.
const COMMON: [(&str, &str); 9] = [
    ("_values", "Event"),
    ("_values", "Fault"),
    ("_values", "Jacobian"),
    ("_values", "Linearisation"),
    ("_mechanism", "Mechanism"),
    ("_values", "Pose"),
    ("_values", "Quantity"),
    ("_values", "Results"),
    ("_saved", "Snapshot"),
];

/// `__init__.py`
pub(super) fn source<M: Foreign>(mechanism: &M) -> String {
    let (name, docs) = (M::TABLES.name, M::TABLES.docs.trim());
    let docs: String = if docs.is_empty() { name.to_owned() } else { docs.to_owned() };
    let parameters: Vec<String> = M::TABLES.parameters.iter().map(told).collect();
    let keywords = if parameters.is_empty() {
        String::new()
    } else {
        format!("\n\nParameters:\n{}", parameters.concat())
    };
    let (mut starts, mut declared) = (Vec::new(), declared(mechanism).declared_starts());
    declared.each(&mut |name, value| starts.push(start::<M>(starts.len(), name, value.value.to_f64())));
    let outputs: Vec<String> = M::OBSERVED.iter().map(|(name, unit)| output::<M>(name, unit)).collect();
    let bodies: Vec<String> = M::TABLES.bodies.iter().map(|body| format!("{},", text(body.name))).collect();
    let contacts = (0..M::CONTACTS).map(|row| format!("{},", text(mechanism.contact_name(row))));
    let contacts: Vec<String> = contacts.collect();
    let rows = |rows: &[Quantity]| tuple(&rows.iter().map(quantity).collect::<Vec<String>>());
    format!(
        "{module}\n\nfrom . import _mechanism, _native, _values\n{common}\n{all}\n__version__ = {version}\n\n\n\
         class {name}(_mechanism.Mechanism):\n    {class}\n\n    __slots__ = ()\n    _native = _native\n    \
         _tables = _values.Tables(\n        parameters={parameters},\n        inputs={inputs},\n        \
         states={states},\n        outputs={outputs},\n        starts={starts},\n        bodies=({bodies}),\n        \
         declared={declared},\n        contacts=({contacts}),\n    )\n",
        module = text(&docs),
        common = imports(),
        all = all(name),
        version = text(&plm_view::package::version()),
        class = text(&format!("{docs}{keywords}")),
        parameters = rows(M::TABLES.parameters),
        inputs = rows(M::TABLES.inputs),
        states = rows(M::TABLES.states),
        outputs = tuple(&outputs),
        starts = tuple(&starts),
        bodies = bodies.join(" "),
        declared = rows(M::TABLES.outputs),
        contacts = contacts.join(" "),
    )
}

/// `__init__.pyi`
pub(super) fn stub<M: Foreign>(_: &M) -> String {
    let (name, parameters) = (M::TABLES.name, M::TABLES.parameters);
    let is_keyword = |row: &&Quantity| is_name(row.name) && OWN.iter().all(|(own, ..)| *own != row.name);
    let given = parameters.iter().filter(is_keyword).map(|row| {
        let default = row.default.map_or(String::new(), |value| format!(" = {}", number(value)));
        format!("        {}: float{default},\n", row.name)
    });
    let own = OWN.iter().map(|(name, kind, default)| format!("        {name}: {kind} = {default},\n"));
    let keywords: String = given.chain(own).collect();
    let settable = |rows: &'static [Quantity]| rows.iter().map(|row| (row.name, true));
    // The first that has a name has the property.
    let all_names = settable(parameters)
        .chain(settable(M::TABLES.inputs))
        .chain(M::OBSERVED.iter().map(|(name, _)| (*name, false)))
        .chain(settable(M::TABLES.states));
    let mut seen: Vec<&str> = Vec::new();
    let mut properties = String::new();
    for (name, is_settable) in all_names {
        if is_name(name) && !MEMBERS.contains(&name) && !name.starts_with('_') && !seen.contains(&name) {
            seen.push(name);
            properties.push_str(&property(name, is_settable));
        }
    }
    format!(
        "from collections.abc import Mapping\n\nfrom . import _mechanism\n{}\n{}\n__version__: str\n\n\
         class {name}(_mechanism.Mechanism):\n    def __init__(\n        self,\n        *,\n{keywords}    ) -> None: ...\n\
         {properties}",
        imports(),
        all(name),
    )
}

fn property(name: &str, is_settable: bool) -> String {
    let get = format!("    @property\n    def {name}(self) -> float: ...\n");
    let set = format!("    @{name}.setter\n    def {name}(self, value: float) -> None: ...\n");
    if is_settable { get + &set } else { get }
}

/// A line each, as types want it of what is handed on.
fn imports() -> String {
    let lines: Vec<String> =
        COMMON.iter().map(|(module, name)| format!("from .{module} import {name} as {name}\n")).collect();
    lines.concat()
}

fn all(name: &str) -> String {
    let names = std::iter::once(name).chain(COMMON.iter().map(|(_, name)| *name));
    let names: Vec<String> = names.map(text).collect();
    format!("__all__ = [{}]", names.join(", "))
}

/// Can it be written as a name?
fn is_name(name: &str) -> bool {
    let plain = name.chars().all(|letter| letter.is_alphanumeric() || letter == '_');
    plain && !name.starts_with(|letter: char| letter.is_numeric()) && !is_keyword(name)
}

pub(super) fn is_keyword(name: &str) -> bool {
    KEYWORDS.contains(&name)
}

/// Text for a parameter.
fn told(row: &Quantity) -> String {
    let default = row.default.map_or("to be given".to_owned(), |value| format!("{value:?} as declared"));
    let unit = Si(row).to_string();
    let unit = if unit.is_empty() { unit } else { format!("{unit}, ") };
    let docs: Vec<&str> = row.docs.lines().map(str::trim).collect();
    let docs = if docs.is_empty() { String::new() } else { format!(". {}", docs.join(" ")) };
    format!("\n    {}: {unit}{default}{docs}", row.name)
}

fn quantity(row: &Quantity) -> String {
    let default = row.default.map_or("None".to_owned(), number);
    made(row.name, [&Si(row).to_string(), row.unit], row.factor, (row.docs, &default))
}

/// A quantity that is observed; what was declared of it, if it was.
fn output<M: Foreign>(name: &str, unit: &str) -> String {
    let declared = M::TABLES.outputs.iter().find(|row| row.name == name);
    match declared {
        Some(row) => made(name, [unit, row.unit], row.factor, (row.docs, "None")),
        None => made(name, [unit, unit], 1.0, ("", "None")),
    }
}

/// A start value: six of each body, then those of the first-order states.
fn start<M: Foreign>(index: usize, name: &str, value: f64) -> String {
    let units = ["m", "m", "rad", "m/s", "m/s", "rad/s"];
    let state = index.checked_sub(units.len() * M::TABLES.bodies.len()).and_then(|k| M::TABLES.states.get(k));
    let own = units[index % units.len()];
    let (unit, declared, factor) =
        state.map_or((own.to_owned(), own, 1.0), |row| (Si(row).to_string(), row.unit, row.factor));
    // A parameter without default has no value yet.
    let default = if value.is_finite() { number(value) } else { "None".to_owned() };
    made(name, [&unit, declared], factor, (state.map_or("", |row| row.docs), &default))
}

fn made(name: &str, [unit, declared]: [&str; 2], factor: f64, (docs, default): (&str, &str)) -> String {
    let [name, unit, declared, docs] = [name, unit, declared, docs.trim()].map(text);
    format!("_values.Quantity({name}, {unit}, {declared}, {}, {docs}, {default})", number(factor))
}

fn tuple(rows: &[String]) -> String {
    let rows: Vec<String> = rows.iter().map(|row| format!("            {row},\n")).collect();
    if rows.is_empty() { "()".to_owned() } else { format!("(\n{}        )", rows.concat()) }
}

fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { format!("float(\"{value}\")") }
}

/// A text as Python reads it.
fn text(words: &str) -> String {
    let escaped = words.replace('\\', "\\\\").replace('"', "\\\"").replace('\r', "").replace('\n', "\\n");
    format!("\"{escaped}\"")
}
