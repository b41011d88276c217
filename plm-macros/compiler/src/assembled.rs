//! A compiled mechanism at its start, in names and numbers: for whoever writes it in another format.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, algebra};

use crate::model::{Body, FrameRef, Input, Model, Name, Part, SetField};
use crate::numeric::{Reach, Scene, add_switches, assemble, value};
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
    /// Has it rows, contacts or loads?
    pub acts: bool,
}

/// A value that the use of a part sets.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldValue {
    /// A number, SI, that parameters alone decide.
    Number(f64),
    /// A multiple of one input: its name, and the factor, SI.
    Input(String, f64),
    /// A value that depends on the state, the time or several inputs, or that nothing reads.
    Other,
}

impl Oracle {
    /// The mechanism at its start. Where it cannot be assembled, this is as near as assembly comes.
    pub fn assembled(&self) -> Assembled {
        self.graph.borrow_mut().enter(|| {
            let model = &self.model;
            let scene = Scene::declared(model, &self.equations, &self.program.absolute);
            let start = assemble(&scene, Reach::Full);
            let mut known = scene.moving(&start.q, &start.v);
            add_switches(model, &mut known);
            let number = |expr: Expr| value(expr, &known);
            let moving = start.q.chunks_exact(3).zip(start.v.chunks_exact(3));
            let parts = model.parts.iter().enumerate();
            Assembled {
                name: model.name.text.clone(),
                span: model.name.span,
                gravity: model.gravity.components().map_each(number),
                inputs: model.inputs.iter().map(|row| input(row, &number)).collect_vec(),
                bodies: model.bodies.iter().zip(moving).map(|(row, at)| body(row, at, &number)).collect_vec(),
                ground: model.ground.iter().map(|row| port(row, &number)).collect_vec(),
                parts: parts.map(|(k, part)| self::part(model, k, part, &number)).collect_vec(),
                events: model.whens.iter().map(|when| when.span).collect_vec(),
            }
        })
    }
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
    }
}

fn part(model: &Model, at: usize, part: &Part, number: &impl Fn(Expr) -> f64) -> AssembledPart {
    let instance = model.instances.iter().find(|instance| instance.name == part.name.text);
    let fields = instance.map_or(&[][..], |instance| &instance.fields);
    let field = |SetField { name, value }: &SetField| (name.clone(), field_value(model, *value, number));
    let rows = model.rows.iter().chain(&model.compliant).map(|row| row.part);
    let contacts = model.contacts.iter().map(|contact| contact.part);
    let loads = model.loads.iter().map(|load| load.part);
    AssembledPart {
        name: part.name.text.clone(),
        kind: part.kind.clone(),
        span: part.name.span,
        frames: part.frames.clone(),
        fields: fields.iter().map(field).collect_vec(),
        // The declaration is source 0.
        of_library: part.declared.as_ref().is_some_and(|declared| declared.span.source != 0),
        acts: rows.chain(contacts).chain(loads).any(|part| part == at),
    }
}

/// The value of a field: a number, a multiple of an input, or neither.
fn field_value(model: &Model, value: Option<Expr>, number: &impl Fn(Expr) -> f64) -> FieldValue {
    let Some(value) = value else { return FieldValue::Other };
    let mut symbols = algebra::symbols(&[value]);
    symbols.retain(|symbol| !model.params.iter().any(|param| param.symbol == *symbol));
    let input = |symbol: Expr| model.inputs.iter().find(|input| input.symbol == symbol);
    match symbols[..] {
        [] => FieldValue::Number(number(value)),
        [symbol] => {
            let factor = value.diff(symbol);
            let at_zero = algebra::substitute(&[value], &[(symbol, Expr::ZERO)]);
            let is_linear = !algebra::symbols(&[factor]).contains(&symbol);
            match input(symbol) {
                Some(input) if is_linear && at_zero.iter().all(|value| value.is_zero()) => {
                    FieldValue::Input(input.name.text.clone(), number(factor))
                }
                _ => FieldValue::Other,
            }
        }
        _ => FieldValue::Other,
    }
}
