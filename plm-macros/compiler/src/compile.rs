//! Compilation: all passes, in order.
//!
//! The model gives equations, the equations a program in absolute coordinates. That program assembles the start in numbers. Joint
//! coordinates follow where the mechanism allows them, then the report and the text. A check follows each pass. Who runs a mechanism by
//! its tables, or asks what is wrong with it, leaves out the text.

use crate::collect::CollectVec;
use std::cell::RefCell;

use plm_cas::{Expr, Graph, algebra};

use crate::check;
use crate::derive::{Equations, Massless, count_turns, derive, hold_switches, with_turns};
use crate::diag::Diagnostics;
use crate::emit::{self, Code, Place};
use crate::fallback;
use crate::formulate::{Program, formulate, reduce};
use crate::front::{self, Reading};
use crate::model::{Model, Output};
use crate::numeric::{Assembly, Reach, Scene, assemble, freedom};
use crate::oracle::Oracle;
use crate::report::Report;
use crate::token::Sources;

/// Result of a compilation.
#[derive(Debug, Default)]
pub struct Expansion {
    /// Rust source: the mechanism, or after errors one with its names so that nothing cascades; `None` if not even its
    /// own name was found, or none was asked for.
    pub code: Option<Code>,
    /// Everything that is wrong.
    pub diagnostics: Diagnostics,
    /// Report of what was found and chosen; `None` after errors.
    pub report: Option<Report>,
    /// The mechanism for the interpreter; `None` after errors.
    pub oracle: Option<Oracle>,
}

/// Compiles the declaration that is the first of `sources`; library files that it needs are added after it.
///
/// Mistakes never end the compilation early with nothing: they are all in [`Expansion::diagnostics`].
pub fn compile(sources: &mut Sources) -> Expansion {
    expanded(sources, Some(emit::emit))
}

/// As [`compile`], without code: diagnostics, report and the mechanism for the interpreter.
pub fn analyse(sources: &mut Sources) -> Expansion {
    expanded(sources, None)
}

/// Writes the text of a mechanism. A pointer, so that a program that only analyses does not link emission.
type Emit = for<'a> fn(&'a Model, &'a Equations, &'a Program, &'a Report, Place<'a>) -> Code;

/// Runs the passes, the last of them where there is one.
fn expanded(sources: &mut Sources, emit: Option<Emit>) -> Expansion {
    let mut sink = Diagnostics::new();
    let reading = front::read(sources, &mut sink);
    let place = |span| sources.place_in_rust(span);
    let model = reading.model(&mut sink);
    let expansion = model.and_then(|model| {
        check::check_names(&model, &mut sink);
        let (model, observed) = split_observed(&reading, model);
        back_end(model, observed, (emit, &place), &mut sink)
    });
    let mut expansion = expansion.unwrap_or_default();
    if sink.has_errors() {
        sink.drop_hints();
        // A mechanism that is complete but for its start is emitted as it is; else one with its names has to do.
        let code = expansion.code.or_else(|| placeholder_code(&reading, (emit?, &place)));
        expansion = Expansion { code, ..Expansion::default() };
    }
    sink.count_unshown();
    expansion.diagnostics = sink;
    expansion
}

/// A mechanism with the names of the declaration and nothing after them, for code that uses it where [`compile`] gives
/// none; `None` if it has no name itself.
pub fn names_only(sources: &mut Sources) -> Option<Code> {
    let reading = front::read(sources, &mut Diagnostics::new());
    placeholder_code(&reading, (emit::emit, &|span| sources.place_in_rust(span)))
}

/// Observed outputs, and their graph.
type Observed = Option<(Vec<Output>, Graph)>;

/// Splits what is observed from the model until all else is done, so that the step keeps its bits.
fn split_observed(reading: &Reading, model: Model) -> (Model, Observed) {
    if model.outputs.iter().all(|output| output.declared) {
        return (model, None);
    }
    let Some(unobserved) = reading.unobserved() else { return (model, None) };
    let observed = model.outputs.into_iter().filter(|output| !output.declared).collect_vec();
    (unobserved, Some((observed, model.graph)))
}

/// From the model on, in the model's graph, which the oracle keeps.
fn back_end(
    mut model: Model,
    observed: Observed,
    text: (Option<Emit>, Place),
    sink: &mut Diagnostics,
) -> Option<Expansion> {
    let mut graph = std::mem::take(&mut model.graph);
    let mut expansion = graph.enter(|| passes(model, observed, text, sink))?;
    if let Some(oracle) = &mut expansion.oracle {
        oracle.graph = RefCell::new(graph);
    }
    Some(expansion)
}

/// The passes after the model; nothing where there are errors that leave nothing to go on with.
fn passes(
    mut model: Model,
    observed: Observed,
    (emit, place): (Option<Emit>, Place),
    sink: &mut Diagnostics,
) -> Option<Expansion> {
    check::check_connectivity(&model, sink);
    require_no_errors(sink)?;

    let held = hold_switches(&mut model);
    let revolutions = count_turns(&mut model);
    let equations = derive(&model);
    check::check_size(&model, &equations, sink);
    require_no_errors(sink)?;

    let absolute = formulate(&model, &equations).optimise();
    let scene = Scene::declared(&model, &equations, &absolute);
    let start = assemble(&scene, Reach::Full);
    let reduced = reduce(&scene, Some(&start));
    let massless = massless(&scene, &start);
    let mut program = Program::new(&model, &equations, absolute, reduced);
    if let Some((outputs, from)) = observed {
        let mut outputs = import(outputs, &from, (&held, &revolutions));
        if let Some(massless) = &massless {
            outputs = massless.without_forces(outputs);
        }
        program.observe(&outputs, &equations);
        model.outputs.extend(outputs);
    }
    check::check_feedback(&model, sink);
    check::check_branches(&model, &equations, sink);
    check::check_jumps(&model, sink);
    require_no_errors(sink)?;

    let scene = Scene::declared(&model, &equations, &program.absolute);
    check::check_pairs(&scene, sink);
    check::check_massless(&scene, massless.as_ref(), &start, sink);
    check::check_formulation(&model, &program, sink);
    check::check_start(&scene, &start, sink);
    sink.allow(&model.allowed);
    let mut report = Report::new(&scene, &program);
    report.add_start(&scene, &start, program.reduced());

    let code = emit.map(|emit| emit(&model, &equations, &program, &report, place));
    let oracle = Oracle { graph: RefCell::default(), model, equations, program };
    Some(Expansion { code, report: Some(report), oracle: Some(oracle), ..Expansion::default() })
}

/// The bodies without mass, and what depends on their masses.
fn massless(scene: &Scene, start: &Assembly) -> Option<Massless> {
    let mut massless = Massless::new(scene.model, scene.equations)?;
    massless.repeats = start.is_closed() && freedom(scene, start) > massless.freedom;
    Some(massless)
}

/// `None` if there are errors.
fn require_no_errors(sink: &Diagnostics) -> Option<()> {
    (!sink.has_errors()).then_some(())
}

/// Expressions, and what stands for them.
type Pairs = [(Expr, Expr)];

/// Imports outputs from their own graph into the present one, with the modes of `held` conditions and the counts of `revolutions`.
fn import(mut outputs: Vec<Output>, from: &Graph, (held, revolutions): (&Pairs, &Pairs)) -> Vec<Output> {
    let roots: Vec<Expr> = outputs.iter().flat_map(|output| &output.components).copied().collect_vec();
    let components = algebra::substitute(&algebra::import(from, &roots), held);
    let components = with_turns(&components, revolutions);
    let places = outputs.iter_mut().flat_map(|output| &mut output.components);
    places.zip(components).for_each(|(place, component)| *place = component);
    outputs
}

/// The source of a placeholder for a model with errors; nothing about it is checked, and its start is not assembled.
fn placeholder_code(reading: &Reading, (emit, place): (Emit, Place)) -> Option<Code> {
    let unchecked = || {
        let model = fallback::model(reading)?;
        let equations = derive(&model);
        let absolute = formulate(&model, &equations).optimise();
        let reduced = reduce(&Scene::declared(&model, &equations, &absolute), None);
        let program = Program::new(&model, &equations, absolute, reduced);
        let report = Report::new(&Scene::declared(&model, &equations, &program.absolute), &program);
        Some(emit(&model, &equations, &program, &report, place))
    };
    Graph::new().enter(unchecked)
}
