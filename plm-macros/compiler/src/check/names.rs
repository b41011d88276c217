//! Names in Rust: two names of the declaration that would be one there are an error, since one of them could not be reached.
//!
//! Bodies and outputs are methods of the state, which a run dereferences to: a method of the run itself would hide them.
//! Paths lose their points and brackets, and capitals, so that `rod.x` and `rod_x` meet.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;
use crate::sorted::sort_by_key;

use crate::diag::{Code, Diagnostics};
use crate::emit::METHODS;
use crate::emit::names::{camel_case, ident, is_type_name};
use crate::model::{Model, Name};

/// Namespace of the emitted code: its names must differ.
struct Scope<'a> {
    /// Kind of name that the user would have read there.
    what: &'static str,
    /// Names that are taken.
    taken: &'a [&'static str],
    /// How what takes them is called.
    by: &'static str,
}

/// Reports names of the declaration that are one in Rust, at the later one.
pub(crate) fn check_names(model: &Model, diagnostics: &mut Diagnostics) {
    check_type_name(&model.name, diagnostics);
    let bodies = || model.bodies.iter().map(|body| ("body", &body.name));
    let states = model.states.iter().map(|state| ("state", &state.name));
    let outputs = model
        .outputs
        .iter()
        .map(|output| (if output.declared { "output" } else { "observed quantity" }, &output.name));
    let params = model.params.iter().map(|param| ("parameter", &param.name));
    let inputs = model.inputs.iter().map(|input| ("input", &input.name));
    let methods = Scope { what: "method of the state", taken: METHODS, by: "every run has a method" };
    let starts = Scope { what: "field of the starts", taken: &[], by: "" };
    let fields =
        Scope { what: "field of the mechanism", taken: &["start"], by: "every mechanism has a field" };
    let held = Scope { what: "field of the inputs", taken: &[], by: "" };
    methods.check(bodies().chain(outputs), diagnostics);
    starts.check(bodies().chain(states), diagnostics);
    fields.check(params, diagnostics);
    held.check(inputs, diagnostics);
}

/// A mechanism is a type in a module: without a capital both would have one name, and that may be of a type of Rust.
fn check_type_name(name: &Name, diagnostics: &mut Diagnostics) {
    if is_type_name(&name.text) {
        return;
    }
    let text = &name.text;
    let better = camel_case(text);
    let (why, help) = if better != *text && is_type_name(&better) {
        ("it becomes a type, which begins with a capital", format!("write `{better}`"))
    } else {
        ("the word belongs to Rust", "choose another name, like `Arm`".to_owned())
    };
    let message = format!("`{text}` cannot be a mechanism's name: {why}");
    diagnostics.error(Code::TypeName, name.span, message).help(help);
}

impl Scope<'_> {
    fn check<'n>(
        &self,
        names: impl Iterator<Item = (&'static str, &'n Name)>,
        diagnostics: &mut Diagnostics,
    ) {
        let mut first: SortedMap<String, (&'static str, &Name)> = SortedMap::new();
        // By place: a library part's own source comes before the declaration only in name.
        let mut sorted: Vec<(&'static str, &Name)> = names.collect_vec();
        sort_by_key(&mut sorted, |(_, name)| (name.span.source == 0, name.span));
        for (kind, name) in sorted {
            let ident = ident(&name.text.to_lowercase());
            let text = &name.text;
            if self.taken.contains(&ident.as_str()) {
                let message = format!("the {kind} `{text}` cannot be named so: {} `{ident}`", self.by);
                diagnostics.error(Code::ReservedName, name.span, message).help("choose another name");
                continue;
            }
            let Some((of, known)) = first.get(&ident) else {
                first.insert(ident, (kind, name));
                continue;
            };
            let message = if known.text == *text && of == &kind {
                format!("the {kind} `{text}` is declared twice")
            } else {
                format!("the {kind} `{text}` and the {of} `{}` have one name in Rust, `{ident}`", known.text)
            };
            diagnostics
                .error(Code::DuplicateName, name.span, message)
                .note_at(known.span, format!("the {of} is declared first"))
                .help(format!("choose another name: each is a {}", self.what));
        }
    }
}
