//! The contracts of the runtime, implemented for the mechanism.

use plm_cas::{Expr, algebra};

use super::{Emission, defaults, mechanism, push, reduced, sides, singular, solved};
use crate::formulate::coordinate_name;
use crate::model::{Stabilisation, State, Turn};

pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::new();
    push(
        &mut text,
        format_args!(
            "    use {path}::runtime as rt;\n    use {path}::runtime::absolute;\n\n",
            path = emission.model.crate_path
        ),
    );
    push(
        &mut text,
        format_args!(
            "    /// What assembly found.\n    pub type Assembly<S = f64> = rt::Assembly<S, NQ, NC>;\n\n"
        ),
    );
    if emission.reduced.is_some() {
        reduced::contract(&mut text, emission);
    } else {
        system(&mut text, emission);
        singular::emit(&mut text, emission);
    }
    mechanism::emit(&mut text, emission);
    constraints(&mut text, emission);
    text.push_str(&solved::emit(emission));
    text
}

/// `System`: rates, projection, typical sizes.
fn system(text: &mut String, emission: &Emission) {
    let Emission { equations, .. } = emission;
    let (nq, nc, nx) = (equations.q.len(), equations.phi.len(), equations.x.len());
    let length = 2 * nq + nx;
    let first_order = if nx == 0 {
        String::new()
    } else {
        format!(
            "            let mut x_dot = [S::lit(0.0); {nx}];
            self.x_dot(t, u, x, &mut x_dot);
            for (rate, value) in dx.iter_mut().skip(2 * NQ).zip(x_dot) {{
                *rate = value;
            }}
"
        )
    };
    rate(
        text,
        emission,
        nq,
        &format!(
            "let mut lambda = [S::lit(0.0); {nc}];
            rt::Health(self.dynamics(t, u, x, dx, &mut lambda))"
        ),
    );
    push(text, format_args!(
        "        fn rate_by_rank(&self, t: S, u: &Self::U, x: &[S; {length}], dx: &mut [S; {length}]) -> Result<(), Fault> {{
            let solution = self.accelerate(t, u, x)?;
            let (_, v): ([S; {nq}], [S; {nq}]) = absolute::split(x);
            absolute::join(&v, &solution.a, dx);
{first_order}            Ok(())
        }}

"
    ));
    match emission.model.stabilisation {
        Stabilisation::Projection => push(
            text,
            format_args!(
                "        fn settle(&self, t: S, x: &mut [S; {length}]) -> Result<(), Fault> {{
            absolute::settle_state::<S, Self, NQ, NC, {length}>(self, t, x)
        }}

        fn drift(&self, t: S, x: &[S; {length}]) -> rt::Drift<S> {{
            absolute::drift::<S, Self, NQ, NC, {length}>(self, t, x)
        }}

"
            ),
        ),
        Stabilisation::Baumgarte(tau) => {
            let value = defaults::inline(emission, tau, &emission.parameters());
            push(
                text,
                format_args!(
                    "        fn baumgarte_rate(&self) -> Option<f64> {{
            let lit = S::lit;
            let tau: S = {value};
            Some(1.0 / rt::Scalar::to_f64(tau))
        }}

"
                ),
            );
        }
    }
    sides::contract(text, emission, "self.switching(t, u, x, g)", None);
    energy(text, emission);
    typical(text, emission);
    text.push_str("    }\n\n");
}

/// `energy`, where no constraint knows the time.
pub(super) fn energy(text: &mut String, emission: &Emission) {
    let Emission { model, .. } = emission;
    let rows = model.rows.iter().map(|row| row.phi);
    let sides = model.jumps.iter().map(|jump| model.sides[jump.side].difference);
    let released = model.released.iter().map(|(_, condition)| *condition);
    let roots: Vec<Expr> = rows.chain(sides).chain(released).collect();
    if algebra::symbols(&roots).contains(&model.time) {
        return;
    }
    let (length, _) = emission.state_length();
    push(
        text,
        format_args!(
            "        fn energy(&self, t: S, u: &Self::U, x: &[S; {length}]) -> Option<rt::Energy<S>> {{
            let state = <State<S> as rt::Moment>::new(*self, *u, t, *x);
            let (kinetic, gravity) = (state.kinetic_energy(), state.gravity_energy());
            Some(rt::Energy {{ kinetic, gravity, power: state.load_power() }})
        }}

"
        ),
    );
}

/// Operations up to which a rate is copied into every stage of a method: a dozen stages then stay in a processor's cache for
/// instructions.
const SHORT: usize = 300;

/// `Rate` for any scalar, and the beginning of `System`: its types and its rate.
pub(super) fn rate(text: &mut String, emission: &Emission, coordinates: usize, statements: &str) {
    let (name, held, (length, _)) = (&emission.name, emission.held("S"), emission.state_length());
    let guards = emission.model.guards();
    let short = emission.report.rate.total() <= SHORT;
    let always = if short { "(always)" } else { "" };
    push(
        text,
        format_args!(
            "    impl<S: Scalar> rt::lanes::Rate for {name}<S> {{
        type S = S;
        type X = [S; {length}];
        type U = {held};
        const NQ: usize = {coordinates};

        #[inline{always}]
        fn rate(&self, t: S, u: &Self::U, x: &[S; {length}], dx: &mut [S; {length}]) -> rt::Health<S> {{
            {statements}
        }}
    }}

    impl<S: Real> rt::System for {name}<S> {{
        type S = S;
        type X = [S; {length}];
        type U = {held};
        type G = [S; {guards}];
        const NQ: usize = {coordinates};
        const SHORT: bool = {short};

        #[inline{always}]
        fn rate(&self, t: S, u: &Self::U, x: &[S; {length}], dx: &mut [S; {length}]) -> rt::Health<S> {{
            rt::lanes::Rate::rate(self, t, u, x, dx)
        }}

"
        ),
    );
}

/// The typical size of a state: one of the unit that it is declared in.
pub(super) fn unit_of_state(state: &State) -> String {
    format!("{:?}", state.unit.factor.to_f64())
}

/// Sizes for absolute tolerances: the scene's length for positions, one radian for angles, both per second for rates, one
/// of its unit for a state.
fn typical(text: &mut String, emission: &Emission) {
    let Emission { equations, model, report, .. } = emission;
    let length = format!("{:?}", report.length);
    let pose = |k: usize| if k % 3 == 2 { "1.0" } else { length.as_str() };
    let mut sizes: Vec<&str> = (0..equations.q.len()).chain(0..equations.q.len()).map(pose).collect();
    let units: Vec<String> = model.states.iter().map(unit_of_state).collect();
    sizes.extend(units.iter().map(String::as_str));
    push(
        text,
        format_args!(
            "        fn typical(&self) -> [S; {}] {{\n            [{}].map(S::lit)\n        }}\n\n",
            sizes.len(),
            sizes.join(", ")
        ),
    );
    let bodies: Vec<String> = model.bodies.iter().map(|body| format!("{:?}", body.name.text)).collect();
    let states: Vec<String> = model.states.iter().map(|state| format!("{:?}", state.name.text)).collect();
    push(text, format_args!(
        "        fn part_of_state(&self, index: usize) -> &'static str {{
            const BODIES: &[&str] = &[{}];
            const STATES: &[&str] = &[{}];
            let part = if index < 2 * NQ {{ BODIES.get(index % NQ.max(1) / 3) }} else {{ STATES.get(index - 2 * NQ) }};
            match part {{
                Some(name) => name,
                None => \"\",
            }}
        }}
",
        bodies.join(", "),
        states.join(", ")
    ));
    text.push_str(&name_of_state(emission));
}

/// `name_of_state`; a coordinate has a name in every chart.
pub(crate) fn name_of_state(emission: &Emission) -> String {
    let Emission { model, equations, reduced, .. } = emission;
    let charts: Vec<Vec<String>> = match reduced {
        Some(reduced) => reduced.charts.iter().map(|chart| chart.names.clone()).collect(),
        None => vec![(0..equations.q.len()).map(|k| coordinate_name(model, k)).collect()],
    };
    let in_all = |k: usize, name: fn(&str) -> String| {
        let mut known = Vec::new();
        for name in charts.iter().filter_map(|names| names.get(k)).map(|of| name(of)) {
            if !known.contains(&name) {
                known.push(name);
            }
        }
        known.join(" or ")
    };
    let count = charts.first().map_or(0, Vec::len);
    let coordinates = (0..count).map(|k| in_all(k, str::to_owned));
    let rates = (0..count).map(|k| in_all(k, rate_of));
    let states = model.states.iter().map(|state| state.name.text.clone());
    let names: Vec<String> = coordinates.chain(rates).chain(states).map(|name| format!("{name:?}")).collect();
    format!(
        "
        fn name_of_state(&self, index: usize) -> &'static str {{
            const NAMES: &[&str] = &[{}];
            match NAMES.get(index) {{
                Some(name) => name,
                None => \"\",
            }}
        }}
",
        names.join(", ")
    )
}

/// The name of the rate of a coordinate: that of `arm.angle` is `arm.omega`.
fn rate_of(coordinate: &str) -> String {
    let (owner, what) = coordinate.rsplit_once('.').unwrap_or(("", coordinate));
    let rate = match what {
        "angle" => "omega".to_owned(),
        "displacement" => "speed".to_owned(),
        axis => format!("v{axis}"),
    };
    format!("{owner}.{rate}")
}

/// `Absolute`: the constraints, for assembly, projection and the fallback.
fn constraints(text: &mut String, emission: &Emission) {
    let Emission { name, equations, model, report, .. } = emission;
    let (nq, nc) = (equations.q.len(), equations.phi.len());
    let quoted =
        |names: Vec<String>| names.iter().map(|name| format!("{name:?}")).collect::<Vec<_>>().join(", ");
    let rows = quoted(model.rows.iter().map(|row| row.name.clone()).collect());
    let parts = quoted(model.rows.iter().map(|row| model.parts[row.part].name.text.clone()).collect());
    let coordinates = quoted((0..nq).map(|k| coordinate_name(model, k)).collect());
    let places = equations.phi_q.iter().enumerate();
    let places = places.flat_map(|(i, row)| row.iter().map(move |(j, _)| format!("[{i}, {j}]")));
    let places: Vec<String> = places.collect();
    let angular: Vec<&str> =
        model.rows.iter().map(|row| if row.is_angular() { "true" } else { "false" }).collect();
    push(text, format_args!(
        "    #[doc(hidden)] // rustdoc shows a constant argument by its source, which is the whole declaration.
    impl<S: Real> absolute::Absolute<S, NQ, NC> for {name}<S> {{
        const ROWS: [&'static str; {nc}] = [{rows}];
        const PARTS: [&'static str; {nc}] = [{parts}];
        const COORDINATES: [&'static str; {nq}] = [{coordinates}];
        const ANGULAR: [bool; {nc}] = [{angular}];

        fn phi(&self, t: S, q: &[S; {nq}]) -> [S; {nc}] {{
            let mut phi = [S::lit(0.0); {nc}];
            self.residual(t, q, &mut phi);
            phi
        }}
        fn phi_dot(&self, t: S, q: &[S; {nq}], v: &[S; {nq}]) -> [S; {nc}] {{
            let mut phi_dot = [S::lit(0.0); {nc}];
            self.residual_rate(t, q, v, &mut phi_dot);
            phi_dot
        }}
        fn phi_q(&self, t: S, q: &[S; {nq}], each: &mut impl FnMut(usize, usize, S)) {{
            const PLACES: &[[u32; 2]] = &[{places}];
            let mut entries = [S::lit(0.0); {entries}];
            self.jacobian(t, q, &mut entries);
            for (&[row, column], entry) in PLACES.iter().zip(entries) {{
                each(row as usize, column as usize, entry);
            }}
        }}
        fn min_norm(&self, t: S, q: &[S; {nq}], w: &[S; {nq}], r: &[S; {nc}], dq: &mut [S; {nq}]) -> rt::Health<S> {{
            rt::Health(self.closing_step(t, q, w, r, dq))
        }}
        fn inverse_mass(&self) -> [S; {nq}] {{
            let mut inverse_mass = [S::lit(0.0); {nq}];
            self.reciprocal_mass(&mut inverse_mass);
            inverse_mass
        }}
        fn length(&self) -> S {{
            S::lit({length:?})
        }}
",
        angular = angular.join(", "),
        entries = places.len(),
        places = places.join(", "),
        length = report.length
    ));
    starts(text, emission);
    branches(text, emission);
    text.push_str("    }\n\n");
}

/// The mirror images that joints ask for.
fn branches(text: &mut String, emission: &Emission) {
    let Emission { model, equations, .. } = emission;
    let bindings = emission.parameters();
    let mut arms = String::new();
    let asked =
        equations.branches.iter().filter_map(|branch| Some((branch, model.parts[branch.part].branch?)));
    for (k, (branch, (turn, _))) in asked.enumerate() {
        let end = |end: plm_cas::Vec2| {
            let [x, y] = end.components().map(|component| defaults::inline(emission, component, &bindings));
            format!("[{x}, {y}]")
        };
        let ends = branch.ends.map(|ends| format!("[{}]", ends.map(end).join(", "))).join(", ");
        let ([first, second], part) = (branch.bodies, &model.parts[branch.part].name.text);
        let [of_first, of_second] = branch.bodies.map(|body| &model.bodies[body].name.text);
        let left = turn == Turn::Left;
        push(
            &mut arms,
            format_args!(
                "                {k} => Some(absolute::Branch {{
                    part: {part:?},
                    bodies: [{first}, {second}],
                    names: [{of_first:?}, {of_second:?}],
                    ends: [{ends}],
                    left: {left},
                }}),
"
            ),
        );
    }
    if arms.is_empty() {
        return;
    }
    push(
        text,
        format_args!(
            "        fn branch(&self, index: usize) -> Option<absolute::Branch<S>> {{
            #[allow(unused_variables)] // where no end is a formula
            let lit = S::lit;
            match index {{
{arms}                _ => None,
            }}
        }}
"
        ),
    );
}

/// Starts of G from those of O.
fn starts(text: &mut String, emission: &Emission) {
    let Emission { model, fields, equations, .. } = emission;
    let nq = equations.q.len();
    let bindings = emission.parameters();
    let list = |method: &str, angle: bool| {
        let entries = model.bodies.iter().zip(&fields.bodies).enumerate().map(|(k, (body, field))| {
            let [x, y] =
                body.centre.components().map(|component| defaults::inline(emission, component, &bindings));
            let angle = if angle { format!(", q[{}]", 3 * k + 2) } else { String::new() };
            format!("                self.start.{field}.{method}([{x}, {y}]{angle}),\n")
        });
        entries.collect::<String>()
    };
    push(
        text,
        format_args!(
            "        fn start_position(&self) -> [Start<S>; {nq}] {{
            let lit = S::lit;
            let bodies: [[Start<S>; 3]; {bodies}] = [
{positions}            ];
            core::array::from_fn(|k| bodies[k / 3][k % 3])
        }}
        fn start_velocity(&self, q: &[S; {nq}]) -> [Start<S>; {nq}] {{
            let lit = S::lit;
            let bodies: [[Start<S>; 3]; {bodies}] = [
{velocities}            ];
            core::array::from_fn(|k| bodies[k / 3][k % 3])
        }}
",
            bodies = model.bodies.len(),
            positions = list("of_centre", false),
            velocities = list("velocity_of_centre", true),
        ),
    );
}
