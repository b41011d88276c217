//! The model from its unresolved, when every name is bound.

mod bound;
pub(super) mod compliance;
mod contact;
mod observe;
mod output;
mod placeholders;
mod reaction;
pub(super) mod release;
pub(super) mod warnings;

use crate::collect::{CollectVec, MapEach};
use plm_cas::algebra::{self, Vec2};
use plm_cas::{Expr, Graph};

use crate::diag::Code;
use crate::evaluated;
use crate::model::{Body, Decisions, FrameRef, Impacts, Input, Model, Name, Param, Port, Row, Start};
use crate::resolve::Resolver;
use crate::resolve::declarations::body::assumed_mass;
use crate::resolve::declarations::declare::UnresolvedField;
use crate::resolve::values::{Eval, Failed, Reads, all};
use crate::span::Span;
use crate::syntax::ast::{self, Mechanism};
use crate::units::{Dimension, DisplayUnit};

impl<'a> Resolver<'a> {
    /// Evaluates what is left and puts the model together. `None` if there is an error.
    pub(crate) fn into_model(
        mut self,
        declaration: &ast::Declaration,
        mechanism: &'a Mechanism,
    ) -> Option<Model> {
        let params = self.evaluate_params();
        let inputs = self.evaluate_inputs();
        let gravity = self.evaluate_gravity();
        let stabilisation = self.evaluate_stabilisation();
        let bodies = self.evaluate_bodies();
        let ground = self.evaluate_ports(None);
        let rows = self.evaluate_rows();
        let mut loads = self.evaluate_loads();
        let mut contacts = self.evaluate_contacts(&mut loads);
        let mut states = self.evaluate_states();
        let mut outputs = self.evaluate_outputs();
        self.evaluate_observed(&mut outputs);
        let mut switches = self.evaluate_requirements();
        let mut whens = self.evaluate_whens();
        if let Ok(contacts) = &mut contacts {
            let of_switches = switches.iter_mut().map(|(switch, _)| &mut switch.difference).collect_vec();
            let events = (of_switches, &mut whens[..]);
            self.replace_placeholders(&mut states, &mut loads, &mut outputs, events, contacts);
        }
        let switches = self.changing(switches, params.as_deref().unwrap_or_default());
        loads.retain(|load| load.force != [Expr::ZERO; 3]);
        let of_contact = contacts.as_deref_mut().unwrap_or_default();
        let rows = rows.and_then(|rows| {
            let others = (of_contact, &mut whens[..]);
            self.apply_compliances(rows, &mut loads, &mut states, &mut outputs, others)
        });
        let rows = rows.and_then(|(rows, compliant)| {
            let of_contact = contacts.as_mut().map_err(|Failed| Failed)?;
            let rows =
                self.apply_conditions(rows, &mut loads, (&states, &mut outputs, &mut whens), of_contact)?;
            Ok((rows, compliant))
        });
        // Last of all, so that pictures have no part in the order in which terms are made.
        let instances = self.evaluate_instances();
        let bodies = bodies.and_then(|bodies| self.with_holes(bodies));
        self.warn(declaration, mechanism);
        if self.sink.has_errors() {
            return None;
        }
        let (rows, compliant) = rows.ok()?;
        Some(Model {
            name: Name { text: mechanism.name.text.clone(), span: mechanism.name.span },
            visibility: mechanism.visibility.clone(),
            docs: mechanism.docs.clone(),
            text: String::new(),
            crate_path: declaration.crate_path.clone().unwrap_or_else(|| "::plm".to_string()),
            graph: Graph::new(),
            time: self.calculus.time,
            most_growth: self.calculus.most_growth,
            agreement: self.calculus.agreement,
            precision: self.calculus.precision,
            gravity: gravity.ok()?,
            stabilisation: stabilisation.ok()?,
            formulation: self.unresolved.settings.formulation,
            repetitions: self.unresolved.settings.repetitions.map(|(repetitions, _)| repetitions),
            steps: self.unresolved.settings.steps.keys().copied().collect(),
            params: params.ok()?,
            inputs: inputs.ok()?,
            bodies: bodies.ok()?,
            ground: ground.ok()?,
            parts: self.unresolved.parts,
            rows,
            compliant,
            contacts: contacts.ok()?,
            impacts: self.unresolved.settings.impacts.map_or_else(Impacts::default, |(law, _)| law),
            limits: self.unresolved.limits,
            comparisons: self.unresolved.comparisons,
            jumps: Vec::new(),
            released: Vec::new(),
            loads,
            states,
            outputs,
            instances: instances.ok()?,
            files: self.files.keys().cloned().collect_vec(),
            switches,
            whens,
            decisions: Decisions::default(),
            kinks: Vec::new(),
            turns: Vec::new(),
            allowed: self.unresolved.settings.allowed,
        })
    }

    /// Defaults of parameters may read parameters that stand above them.
    fn evaluate_params(&mut self) -> Eval<Vec<Param>> {
        let defaults = self.defaults()?;
        let states = std::mem::take(&mut self.unresolved.params);
        all(states.into_iter().zip(defaults).map(|(state, (_, default))| {
            let (required, default) = (state.ast.value.is_none(), default?);
            if algebra::symbols(&[default]).into_iter().any(|symbol| symbol >= state.symbol) {
                let message =
                    format!("the default of `{}` reads a parameter that stands below it", state.name.text);
                self.error(state.scope, Code::NotConstant, state.name.span, message);
            }
            let docs = state.docs.to_vec();
            Ok(Param { name: state.name, symbol: state.symbol, default, required, unit: state.unit, docs })
        }))
    }

    /// Parameters and their defaults, worked out at their first use; 1 where the user has to give one.
    fn defaults(&mut self) -> Eval<Vec<(Expr, Eval<Expr>)>> {
        self.lazy(
            |of| &mut of.unresolved.defaults,
            |_| (),
            |of| {
                let fields = of.unresolved.params.iter();
                let fields = fields.map(|field| (field.symbol, field.ast, field.scope, field.unit.dimension));
                let mut defaults = Vec::new();
                for (symbol, ast, scope, dimension) in fields.collect_vec() {
                    let number = |expr| of.eval_number(scope, expr, dimension, Reads::FIXED);
                    defaults.push((symbol, ast.value.as_ref().map_or(Ok(Expr::ONE), number)));
                }
                Ok(defaults)
            },
        )
    }

    /// Declared values of parameters: those that can be worked out.
    pub(crate) fn declared_values(&mut self) -> Vec<(Expr, f64)> {
        let mut values = Vec::new();
        for (symbol, default) in self.defaults().unwrap_or_default() {
            if let Ok(default) = default {
                values.push((symbol, evaluated::value(default, &values)));
            }
        }
        values
    }

    fn evaluate_inputs(&mut self) -> Eval<Vec<Input>> {
        let states = std::mem::take(&mut self.unresolved.inputs);
        all(states.into_iter().map(|state| {
            let default = self.default_of(&state)?;
            let docs = state.docs.to_vec();
            Ok(Input { name: state.name, symbol: state.symbol, default, unit: state.unit, docs })
        }))
    }

    fn default_of(&mut self, state: &UnresolvedField<'a>) -> Eval<Expr> {
        match &state.ast.value {
            Some(expr) => self.eval_number(state.scope, expr, state.unit.dimension, Reads::FIXED),
            None => Ok(Expr::ZERO),
        }
    }

    fn evaluate_bodies(&mut self) -> Eval<Vec<Body>> {
        all((0..self.unresolved.bodies.len()).map(|body| self.evaluate_body(body)))
    }

    fn evaluate_body(&mut self, body: usize) -> Eval<Body> {
        let has_mass = self.names_mass(body);
        let declared = has_mass.then(|| self.mass_and_inertia(body));
        self.check_plate(body);
        let starts = self.starts(body);
        let contour = self.contour(body);
        let width = if self.is_plate(body) { self.plate(body).map(|plate| plate.width) } else { Ok(None) };
        let (depth, scope) = (self.body_field(body, "depth"), self.unresolved.bodies[body].scope);
        let depth = self.depth(scope, depth);
        let ports = self.evaluate_ports(Some(body));
        let placement = self.placement(body)?;
        let [mut x, mut y, mut angle, vx, vy, omega] = starts?;
        let is_open = |start: &Start| !(start.given || start.locked);
        let stands_anywhere = is_open(&x) && is_open(&y);
        // A body of which nothing is declared would else pull the one that it is welded to.
        let welded = if stands_anywhere && is_open(&angle) { self.welded_start(body)? } else { None };
        if let Some(start) = welded {
            [x.value, y.value, angle.value] = start;
        } else if self.unresolved.draws_rows && stands_anywhere {
            [x.value, y.value] = self.drawn_origin(body)?;
        }
        let (ports, state) = (ports?, &self.unresolved.bodies[body]);
        let ((mass, mass_span), (inertia, inertia_span)) = match declared {
            Some([mass, inertia]) => (mass?, inertia?),
            None => assumed_mass(&ports).map_each(|value| (value, state.name.span)).into(),
        };
        Ok(Body {
            name: state.name.clone(),
            mass,
            mass_span,
            inertia,
            inertia_span,
            has_mass,
            q: state.q,
            v: state.v,
            a: state.a,
            centre: if placement.drawing { Vec2::ZERO } else { placement.centre },
            ports,
            start: [x, y, angle],
            start_velocity: [vx, vy, omega],
            contour: contour?,
            width: width?,
            holes: Vec::new(),
            depth: depth?,
        })
    }

    /// Mass and inertia of a body that has some, and where they stand.
    fn mass_and_inertia(&mut self, body: usize) -> [Eval<(Expr, Span)>; 2] {
        if !self.is_plate(body) {
            let mass = self.body_quantity(body, "mass", Dimension::MASS);
            return [mass, self.body_quantity(body, "inertia", Dimension::INERTIA)];
        }
        let plate = self.plate(body);
        [plate.map(|plate| (plate.mass, plate.span)), plate.map(|plate| (plate.inertia, plate.span))]
    }

    fn evaluate_ports(&mut self, body: Option<usize>) -> Eval<Vec<Port>> {
        let count =
            body.map_or(self.unresolved.ground.len(), |body| self.unresolved.bodies[body].ports.len());
        all((0..count).map(|port| {
            let frame = FrameRef { body, port };
            let geometry = self.frame(frame)?;
            let state = self.unresolved.port(frame);
            let (ast, scope, used) = (state.ast, state.scope, state.used);
            let name = Name { text: state.name.clone(), span: ast.name.ident.span };
            let depth = self.depth(scope, ast.depth.as_ref())?;
            Ok(Port { name, at: geometry.local, angle: geometry.turn, used, depth })
        }))
    }

    fn evaluate_rows(&mut self) -> Eval<Vec<Row>> {
        all((0..self.unresolved.rows.len()).map(|row| {
            let value = self.row(row)?;
            let declared = self.row_declared(row);
            let state = &self.unresolved.rows[row];
            Ok(Row {
                name: state.name.clone(),
                part: state.part,
                phi: value.phi,
                lambda: state.lambda,
                span: state.span,
                declared,
                unit: DisplayUnit::si(value.dimension),
            })
        }))
    }
}
