//! The passes, in order.

use std::cell::{OnceCell, RefCell};

use plm_cas::{Expr, Graph, algebra};

use crate::check::{self, Assembly};
use crate::derive::{Equations, check_feedback, derive, feeds_back, hold};
use crate::diag::{Code as Problem, Diagnostics};
use crate::emit::{self, Code, Place};
use crate::fallback;
use crate::formulate::{Absolute, Assembled, Known, Reduced, formulate, lay_out, reduce};
use crate::front::{self, Reading};
use crate::model::{Model, Output, Rung, Stabilisation};
use crate::oracle::Oracle;
use crate::report::{self, Report};
use crate::token::Sources;

/// What the compiler makes of a declaration.
#[derive(Debug, Default)]
pub struct Expansion {
    /// Rust source: the mechanism, or after errors one with its names so that nothing cascades; `None` if not even its
    /// own name was found.
    pub code: Option<Code>,
    /// Everything that is wrong.
    pub diagnostics: Diagnostics,
    /// What was found and chosen; `None` after errors.
    pub report: Option<Report>,
    /// The mechanism for the interpreter; `None` after errors.
    pub oracle: Option<Oracle>,
}

/// Compiles the declaration that is the first of `sources`; library files that it needs are added behind it.
///
/// Mistakes never end the compilation early with nothing: they are all in [`Expansion::diagnostics`].
pub fn compile(sources: &mut Sources) -> Expansion {
    let mut sink = Diagnostics::new();
    let reading = front::read(sources, &mut sink);
    let place = |span| sources.place_in_rust(span);
    let mut expansion = match reading.model(&mut sink) {
        Some(model) => {
            check::check_names(&model, &mut sink);
            let (model, observed) = apart(&reading, model);
            back_end(model, observed, &place, &mut sink)
        }
        None => Expansion::default(),
    };
    if sink.has_errors() {
        sink.drop_hints();
        // A mechanism that is complete but for its start is emitted as it is; else one with its names has to do.
        let code = expansion.code.or_else(|| stand_in(&reading, &place));
        expansion = Expansion { code, ..Expansion::default() };
    }
    expansion.diagnostics = sink;
    expansion
}

/// A mechanism with the names of the declaration and nothing behind them, for code that uses it where [`compile`] gives
/// none; `None` if it has no name itself.
pub fn names_only(sources: &mut Sources) -> Option<Code> {
    let reading = front::read(sources, &mut Diagnostics::new());
    stand_in(&reading, &|span| sources.place_in_rust(span))
}

/// What is observed, and its graph.
type Observed = Option<(Vec<Output>, Graph)>;

/// What is observed is kept apart from the model until all else is done: it leaves the step as it is, to the bit.
fn apart(reading: &Reading, model: Model) -> (Model, Observed) {
    if model.outputs.iter().all(|output| output.declared) {
        return (model, None);
    }
    let Some(unobserved) = reading.unobserved() else { return (model, None) };
    let observed = model.outputs.into_iter().filter(|output| !output.declared).collect();
    (unobserved, Some((observed, model.graph)))
}

/// From the model to source text.
fn back_end(mut model: Model, observed: Observed, place: Place, sink: &mut Diagnostics) -> Expansion {
    let mut graph = std::mem::take(&mut model.graph);
    let mut expansion = graph.enter(|| passes(model, observed, place, sink));
    if let Some(oracle) = &mut expansion.oracle {
        oracle.graph = RefCell::new(graph);
    }
    expansion
}

/// The passes behind the model, in its graph.
fn passes(model: Model, observed: Observed, place: Place, sink: &mut Diagnostics) -> Expansion {
    check::check_reach(&model, sink);
    if sink.has_errors() {
        return Expansion::default();
    }
    let derived = Derived::of(model);
    check::check_size(&derived.model, &derived.equations, sink);
    if sink.has_errors() {
        return Expansion::default();
    }
    let lowered = lower(derived, observed);
    check_feedback(&lowered.model, sink);
    check::check_branches(&lowered.model, &lowered.equations, sink);
    check::check_jumps(&lowered.model, sink);
    if sink.has_errors() {
        return Expansion::default();
    }
    let length = report::length(&lowered.model, &check::defaults(&lowered.model));
    check::check_pairs(&lowered.model, &lowered.equations, length, sink);
    if let (Some((rung @ (Rung::Tree | Rung::Loops), span)), Err(reason)) =
        (lowered.model.rung, &lowered.reduced)
    {
        let name = rung.name();
        sink.error(Problem::NoRung, span, format!("there is no rung `{name}` of this mechanism: {reason}"))
            .help("leave `rung` out: the least formulation is taken, and the report says which and why");
    }
    let mut report = lowered.report();
    let Lowered { model, equations, program, reduced, .. } = &lowered;
    let forms = (program, reduced.as_ref().ok());
    check::check_assembly(model, equations, forms, lowered.assembly(), &mut report, sink);
    sink.allow(&model.allowed);
    let code = lowered.emit(&report, place);
    let Lowered { model, equations, program, reduced, .. } = lowered;
    let oracle = Oracle { graph: RefCell::default(), model, equations, program, reduced: reduced.ok() };
    Expansion { code: Some(code), report: Some(report), oracle: Some(oracle), ..Expansion::default() }
}

/// The source of a model that stands for one with errors; nothing about it is checked.
fn stand_in(reading: &Reading, place: Place) -> Option<Code> {
    let unchecked = || {
        let lowered = lower(Derived::of(fallback::model(reading)?), None);
        Some(lowered.emit(&lowered.report(), place))
    };
    Graph::new().enter(unchecked)
}

/// A model and its equations.
struct Derived {
    model: Model,
    /// What conditions that are held over a step stand for.
    held: Vec<(Expr, Expr)>,
    equations: Equations,
}

impl Derived {
    fn of(mut model: Model) -> Self {
        let held = hold(&mut model);
        let equations = derive(&model);
        Self { model, held, equations }
    }
}

/// A model on the way to source text.
struct Lowered {
    model: Model,
    equations: Equations,
    /// Rung 5, which assembly, reactions and the fallback need on every rung.
    program: Absolute,
    /// The rung above it that is taken, or why there is none.
    reduced: Result<Reduced, String>,
    /// The declared start, once somebody asks for it.
    assembly: OnceCell<Assembly>,
}

/// Values of parameters that are tried until the joints close.
const VARIATIONS: u64 = 8;

fn lower(derived: Derived, observed: Observed) -> Lowered {
    let Derived { mut model, held, equations } = derived;
    let mut program = formulate(&model, &equations);
    let assembly = OnceCell::new();
    let reduced = match (model.rung, model.stabilisation) {
        (Some((Rung::Absolute, _)), _) => Err("it is ordered".to_owned()),
        (_, Stabilisation::Baumgarte(_)) => Err("Baumgarte's method is ordered".to_owned()),
        _ if feeds_back(&model) => Err("forces or rates read accelerations or reactions".to_owned()),
        _ => {
            let length = report::length(&model, &check::defaults(&model));
            let assembled = || {
                let others = check::defaults(&model);
                let assemble = || check::assemble(&model, &equations, &program, &others);
                let found = assembly.get_or_init(assemble);
                let mut values = found.values(&equations, &others);
                check::add_sides(&model, &mut values);
                found.is_closed().then(|| Assembled {
                    freedom: check::freedom(&equations, &program, (&others, length), found),
                    values,
                })
            };
            // With other values of the parameters, dimensions do not make rows say what others say.
            let freedom_elsewhere = || {
                (1..=VARIATIONS).find_map(|seed| {
                    let others = check::varied(&model, seed)?;
                    let found = check::assemble(&model, &equations, &program, &others);
                    let freedom = || check::freedom(&equations, &program, (&others, length), &found);
                    found.is_closed().then(freedom)
                })
            };
            let known = Known { length, assembled: &assembled, freedom_elsewhere: &freedom_elsewhere };
            let reduced = reduce(&model, &equations, known);
            if model.rung.is_some() {
                reduced
            } else {
                reduced.and_then(|reduced| cheaper(reduced, &program))
            }
        }
    };
    if let Some((mut outputs, from)) = observed {
        let roots: Vec<Expr> = outputs.iter().flat_map(|output| &output.components).copied().collect();
        let imported = algebra::import(&from, &roots);
        let components = algebra::substitute(&imported, &held);
        let places = outputs.iter_mut().flat_map(|output| &mut output.components);
        places.zip(components).for_each(|(place, component)| *place = component);
        program.outputs.user.extend(lay_out(&outputs, &equations));
        model.outputs.extend(outputs);
    }
    Lowered { model, equations, program, reduced, assembly }
}

/// Rung 4, if it has fewer operations than rung 5, of which iterations can take more; a rung above it is taken as it is.
fn cheaper(reduced: Reduced, program: &Absolute) -> Result<Reduced, String> {
    let Some(chart) = reduced.first().filter(|_| reduced.iterates()) else { return Ok(reduced) };
    let [iterated, absolute] = [&chart.rate, &program.dynamics].map(|form| form.tape().count().total());
    if iterated < absolute {
        return Ok(reduced);
    }
    let groups = chart.groups.join("; ");
    Err(format!("its loops need {groups}: {iterated} operations, and absolute coordinates {absolute}"))
}

impl Lowered {
    /// The declared start as it can be assembled.
    fn assembly(&self) -> &Assembly {
        let Lowered { model, equations, program, .. } = self;
        let assemble = || check::assemble(model, equations, program, &check::defaults(model));
        self.assembly.get_or_init(assemble)
    }

    fn report(&self) -> Report {
        let defaults = check::defaults(&self.model);
        let formulation = self.reduced.as_ref().map_err(String::as_str);
        Report::new(&self.model, &self.equations, &self.program, formulation, &defaults)
    }

    fn emit(&self, report: &Report, place: Place) -> Code {
        let Lowered { model, equations, program, reduced, .. } = self;
        emit::emit(model, equations, program, reduced.as_ref().ok(), (report, place))
    }
}
