//! A compiled mechanism at its start, in names and numbers: for whoever writes it in another format.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, Function, Node, algebra};

use crate::model::{Body, FrameRef, Input, Model, Name, Part, SetField};
use crate::numeric::{Assembly, Scene, at_start, freedom, value};
use crate::oracle::Oracle;
use crate::picture::{PicturePort, points, port};
use crate::span::Span;

/// A mechanism with parameters as declared, at its assembled start.
#[derive(Clone, Debug, PartialEq)]
pub struct Assembled {
    /// Name of the mechanism.
    pub name: String,
    /// The place of the name.
    pub span: Span,
    /// Acceleration of gravity, absolute axes, m/s^2.
    pub gravity: [f64; 2],
    /// The inputs.
    pub inputs: Vec<AssembledInput>,
    /// The bodies.
    pub bodies: Vec<AssembledBody>,
    /// Ports of the ground.
    pub ground: Vec<PicturePort>,
    /// The parts of the declaration, rows of its own among them.
    pub parts: Vec<AssembledPart>,
    /// The places of its events.
    pub events: Vec<Span>,
    /// Degrees of freedom: coordinates less the rank of the constraints.
    pub freedom: usize,
    /// The parts of rows that say at the start what others say.
    pub redundant: Vec<String>,
}

/// An input.
#[derive(Clone, Debug, PartialEq)]
pub struct AssembledInput {
    /// Its name.
    pub name: String,
    /// The place of the name.
    pub span: Span,
    /// Its value at the start, SI.
    pub start: f64,
}

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct AssembledBody {
    /// Its name.
    pub name: String,
    /// The place of the name.
    pub span: Span,
    /// Place of G and angle of the body: m, m, rad.
    pub pose: [f64; 3],
    /// Velocity of G and angular velocity: m/s, m/s, rad/s.
    pub velocity: [f64; 3],
    /// Mass, kg; nothing where none is declared.
    pub mass: Option<f64>,
    /// Moment of inertia about G, kg m^2.
    pub inertia: f64,
    /// G from the origin of the body, in the axes of the body, m.
    pub centre: [f64; 2],
    /// Place across the plane, m.
    pub depth: f64,
    /// From G, in the axes of the body.
    pub ports: Vec<PicturePort>,
    /// Points from G, in the axes of the body, m; none without outline.
    pub contour: Vec<[f64; 2]>,
    /// Holes of the outline, in the same axes, m.
    pub holes: Vec<Vec<[f64; 2]>>,
    /// Width of the rounded hull of the ports, m; nothing where none is declared.
    pub width: Option<f64>,
}

/// A part of the declaration.
#[derive(Clone, Debug, PartialEq)]
pub struct AssembledPart {
    /// Its name.
    pub name: String,
    /// Name of its definition; the word of a row.
    pub kind: String,
    /// The place of the name.
    pub span: Span,
    /// The frames that it joins, in the order of its arguments.
    pub frames: Vec<FrameRef>,
    /// The fields that its use sets.
    pub fields: Vec<(String, FieldValue)>,
    /// Is it a joint whose definition is that of the library?
    pub of_library: bool,
    /// The residuals of its rows; nothing for a row that is not affine.
    pub rows: Vec<Option<Affine>>,
    /// Has it rows, contacts or loads?
    pub acts: bool,
}

/// A multiple of an input, `factor * input`, or `factor * clamp(input, range)`.
#[derive(Clone, Debug, PartialEq)]
pub struct InputTerm {
    /// The input.
    pub input: String,
    /// The factor, SI.
    pub factor: f64,
    /// The values of the input beyond which nothing changes, SI.
    pub range: Option<[f64; 2]>,
}

/// A value that is affine in one input at most, and in angles and angular velocities of bodies, SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Affine {
    /// The value where all of them are zero.
    pub constant: f64,
    /// The input and its factor.
    pub input: Option<(String, f64)>,
    /// Bodies by number, and the factors of their angles.
    pub angles: Vec<(usize, f64)>,
    /// Bodies by number, and the factors of their angular velocities.
    pub speeds: Vec<(usize, f64)>,
}

/// A value that the use of a part sets.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldValue {
    /// A number, SI, that parameters alone decide.
    Number(f64),
    /// A multiple of one input.
    Input(InputTerm),
    /// An affine function of an input and of the motion.
    Affine(Affine),
    /// A value that depends otherwise on the state, on the time or on several inputs, or that nothing reads.
    Other,
}

/// Values of symbols.
struct Known(Vec<(Expr, f64)>);

impl Known {
    fn number(&self, expr: Expr) -> f64 {
        value(expr, &self.0)
    }

    /// These values, with another one of a symbol.
    fn with(&self, symbol: Expr, value: f64) -> Known {
        let others = self.0.iter().copied().filter(|(known, _)| *known != symbol);
        Known(others.chain([(symbol, value)]).collect_vec())
    }
}

impl Oracle {
    /// The mechanism at its start. Where it cannot be assembled, this is as near as assembly comes.
    pub fn assembled(&self) -> Assembled {
        self.graph.borrow_mut().enter(|| {
            let model = &self.model;
            let scene = Scene::declared(model, &self.equations, &self.program.absolute);
            let (start, known) = at_start(&scene);
            let known = Known(known);
            let number = |expr: Expr| known.number(expr);
            let moving = start.q.chunks_exact(3).zip(start.v.chunks_exact(3));
            let parts = model.parts.iter().enumerate();
            Assembled {
                name: model.name.text.clone(),
                span: model.name.span,
                gravity: model.gravity.components().map_each(number),
                inputs: model.inputs.iter().map(|row| input(row, &number)).collect_vec(),
                bodies: model.bodies.iter().zip(moving).map(|(row, at)| body(row, at, &number)).collect_vec(),
                ground: model.ground.iter().map(|row| port(row, &number)).collect_vec(),
                parts: parts.map(|(k, part)| self::part(model, k, part, &known)).collect_vec(),
                events: model.whens.iter().map(|when| when.span).collect_vec(),
                freedom: freedom(&scene, &start),
                redundant: redundant(model, &start),
            }
        })
    }
}

/// The parts of rows that depend on others, each once. Rows of locks come after those of the model.
fn redundant(model: &Model, start: &Assembly) -> Vec<String> {
    let rows = start.rank.dependent.iter().filter_map(|(row, _)| model.rows.get(*row));
    let mut parts: Vec<usize> = rows.map(|row| row.part).collect_vec();
    parts.dedup();
    parts.into_iter().map(|part| model.parts[part].name.text.clone()).collect_vec()
}

fn input(input: &Input, number: &impl Fn(Expr) -> f64) -> AssembledInput {
    let Name { text, span } = &input.name;
    AssembledInput { name: text.clone(), span: *span, start: number(input.default) }
}

fn body(body: &Body, (q, v): (&[f64], &[f64]), number: &impl Fn(Expr) -> f64) -> AssembledBody {
    AssembledBody {
        name: body.name.text.clone(),
        span: body.name.span,
        pose: [q[0], q[1], q[2]],
        velocity: [v[0], v[1], v[2]],
        mass: body.has_mass.then(|| number(body.mass)),
        inertia: number(body.inertia),
        centre: body.centre.components().map_each(number),
        depth: body.depth.map_or(0.0, number),
        ports: body.ports.iter().map(|row| port(row, number)).collect_vec(),
        contour: points(&body.contour, number),
        holes: body.holes.iter().map(|hole| points(hole, number)).collect_vec(),
        width: body.width.map(number),
    }
}

fn part(model: &Model, at: usize, part: &Part, known: &Known) -> AssembledPart {
    let instance = model.instances.iter().find(|instance| instance.name == part.name.text);
    let fields = instance.map_or(&[][..], |instance| &instance.fields);
    let field = |SetField { name, value }: &SetField| (name.clone(), field_value(model, *value, known));
    let rows = model.rows.iter().chain(&model.compliant).map(|row| row.part);
    let contacts = model.contacts.iter().map(|contact| contact.part);
    let loads = model.loads.iter().map(|load| load.part);
    let own = model.rows.iter().filter(|row| row.part == at);
    AssembledPart {
        name: part.name.text.clone(),
        kind: part.kind.clone(),
        span: part.name.span,
        frames: part.frames.clone(),
        fields: fields.iter().map(field).collect_vec(),
        // The declaration is source 0.
        of_library: part.declared.as_ref().is_some_and(|declared| declared.span.source != 0),
        rows: own.map(|row| affine(model, row.phi, known)).collect_vec(),
        acts: rows.chain(contacts).chain(loads).any(|part| part == at),
    }
}

/// The symbols of an expression that are no parameters.
fn variables(model: &Model, value: Expr) -> Vec<Expr> {
    let mut symbols = algebra::symbols(&[value]);
    symbols.retain(|symbol| !model.params.iter().any(|param| param.symbol == *symbol));
    symbols
}

/// The value of a field: a number, a multiple of an input, an affine function, or none of them.
fn field_value(model: &Model, value: Option<Expr>, known: &Known) -> FieldValue {
    let Some(value) = value else { return FieldValue::Other };
    let term = |symbol: Expr| {
        let input = model.inputs.iter().find(|input| input.symbol == symbol)?;
        let (factor, range) = clamped(value, symbol, known)?;
        Some(FieldValue::Input(InputTerm { input: input.name.text.clone(), factor, range }))
    };
    let term = match variables(model, value)[..] {
        [] => Some(FieldValue::Number(known.number(value))),
        [symbol] => term(symbol),
        _ => None,
    };
    let or_affine = term.or_else(|| affine(model, value, known).map(FieldValue::Affine));
    or_affine.unwrap_or(FieldValue::Other)
}

/// An expression as an affine function; nothing of another one.
fn affine(model: &Model, value: Expr, known: &Known) -> Option<Affine> {
    let symbols = variables(model, value);
    let at_zero = symbols.iter().fold(Known(known.0.clone()), |known, symbol| known.with(*symbol, 0.0));
    let mut found = Affine { constant: at_zero.number(value), ..Affine::default() };
    for symbol in symbols {
        let slope = value.diff(symbol);
        if !variables(model, slope).is_empty() {
            return None;
        }
        let factor = known.number(slope);
        let body_of = |own: fn(&Body) -> Expr| model.bodies.iter().position(|body| own(body) == symbol);
        if let Some(input) = model.inputs.iter().find(|input| input.symbol == symbol) {
            if found.input.replace((input.name.text.clone(), factor)).is_some() {
                return None;
            }
        } else if let Some(body) = body_of(|body| body.q[2]) {
            found.angles.push((body, factor));
        } else {
            found.speeds.push((body_of(|body| body.v[2])?, factor));
        }
    }
    Some(found)
}

/// Values of an input at which a clamped multiple of it has reached its bounds.
const FAR: f64 = 1e12;

/// Factor and range of a multiple of an input, which may be clamped; nothing of another function.
///
/// A function with one minimum and one maximum at most, and else sums and factors, is linear piece by piece. Where it is constant on
/// both ends, below and above zero, it has two kinks, so that its slope at zero and its bounds tell all of it.
fn clamped(value: Expr, symbol: Expr, known: &Known) -> Option<(f64, Option<[f64; 2]>)> {
    let at = |u: f64| known.with(symbol, u).number(value);
    let slope = known.with(symbol, 0.0).number(value.diff(symbol));
    if !is_piecewise_linear(value, symbol) || at(0.0) != 0.0 || slope == 0.0 {
        return None;
    }
    let [low, high] = [-FAR, FAR].map_each(|u| at(u) / slope);
    let is_constant = [-FAR, FAR].map_each(|u| at(2.0 * u) == at(u));
    let is_close = |found: f64, wanted: f64| (found - wanted).abs() <= 1e-9 * wanted.abs();
    match is_constant {
        [false, false] if is_close(low, -FAR) && is_close(high, FAR) => Some((slope, None)),
        [true, true] if low < 0.0 && high > 0.0 => Some((slope, Some([low, high]))),
        _ => None,
    }
}

/// Is an expression made of sums, of factors, and of one minimum and one maximum at most?
fn is_piecewise_linear(value: Expr, symbol: Expr) -> bool {
    let reads = |expr: Expr| algebra::symbols(&[expr]).contains(&symbol);
    let (mut minima, mut maxima) = (0, 0);
    let is_linear =
        algebra::reachable(&[value]).into_iter().filter(|&expr| reads(expr)).all(|expr| match expr.node() {
            Node::Symbol | Node::Sum { .. } => true,
            Node::Product(factors) => {
                let mut reading = factors.iter().filter(|(factor, _)| reads(*factor));
                reading.next().is_some_and(|(_, exponent)| *exponent == 1) && reading.next().is_none()
            }
            Node::Call(Function::Min, _) => {
                minima += 1;
                true
            }
            Node::Call(Function::Max, _) => {
                maxima += 1;
                true
            }
            _ => false,
        });
    is_linear && minima <= 1 && maxima <= 1
}
