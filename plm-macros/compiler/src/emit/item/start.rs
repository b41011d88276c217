//! Start values: as they are declared, at a moment, and as they are assembled.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use plm_cas::{Expr, algebra};
use proc_macro2::TokenStream;

use super::super::contract::{conditional, contact, limits, sets, statics::MOST_LINES, switched};
use super::super::lower::{Bindings, inline};
use super::super::{Emission, Form, Sizes, docs, number, table_compression};
use super::sides::{sides, take_sides};
use crate::facts::state::OF_BODY;
use crate::model::{Body, Model, Param, Start, State};

/// `Starts`, and what assembly finds for them.
pub(crate) fn values(emission: &Emission) -> TokenStream {
    let Emission { model, fields, .. } = emission;
    let bodies = model.bodies.iter().zip(&fields.bodies).map(|(body, field)| {
        let docs = docs::docs(emission, &format!("Origin of body `{}`.", body.name.text));
        quote!(#docs pub #field: BodyStart<S>,)
    });
    let states = model.states.iter().zip(&fields.states).map(|(state, field)| {
        let docs = emission.text(docs::field(&[], &format!("State `{}`", state.name.text), &state.unit, ""));
        quote!(#docs pub #field: Start<S>,)
    });
    let by_number = emission.rerolled.then(|| by_number(emission));
    quote! {
        /// Start values, SI units.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Starts<S = f64> {
            #(#bodies)*
            #(#states)*
        }
        #by_number

        /// Result of assembly.
        pub type Assembly<S = f64> = rt::Assembly<S, NQ, NC>;
    }
}

/// Bodies by number. One is borrowed at a time, and each is handed to a function that rustc does not see: its work grows
/// with the square of what is borrowed together, and of copies in a row.
fn by_number(emission: &Emission) -> TokenStream {
    let Emission { fields, .. } = emission;
    let zero = emission.list(fields.bodies.iter().map(|field| format!("{field}: zero")));
    let calls = fields.bodies.iter().enumerate();
    let calls: Vec<String> = calls.map(|(k, field)| format!("each({k}, &mut self.{field});\n")).collect_vec();
    let blocks = calls.chunks(MOST_LINES).map(|calls| emission.text(calls.concat()));
    let states = &fields.states;
    quote! {
        impl<S: Scalar> Starts<S> {
            /// All at zero, and free.
            const ZERO_: Self = {
                let value = Start::free(S::ZERO);
                let zero = BodyStart { x: value, y: value, angle: value, vx: value, vy: value, omega: value };
                Starts { #(#states: value,)* #zero }
            };

            /// Gives `each` every body with its number.
            #[inline(never)]
            fn each_body_(&mut self, each: &mut dyn FnMut(usize, &mut BodyStart<S>)) {
                #({ #blocks })*
            }
        }
    }
}

/// Start values as declared, an expression; of many bodies a loop.
pub(super) fn declared_values(emission: &Emission, bindings: &Bindings) -> TokenStream {
    let Emission { model, fields, .. } = emission;
    let states = model.states.iter().zip(&fields.states);
    if !emission.rerolled {
        let bodies = model.bodies.iter().zip(&fields.bodies);
        let bodies =
            bodies.map(|(body, field)| format!("{field}: {}", body_start(body, &model.params, bindings)));
        let states =
            states.map(|(state, field)| format!("{field}: {}", state_start(state, &model.params, bindings)));
        let starts = emission.lines(bodies.chain(states));
        return quote!(Starts { #starts });
    }
    let (mut tables, mut entries) = (String::new(), Vec::new());
    for (k, name) in OF_BODY.into_iter().enumerate() {
        let start = |body: &Body| body.start.iter().chain(&body.start_velocity).nth(k).copied();
        let starts = model.bodies.iter().filter_map(start).collect_vec();
        let values = starts.iter().map(|start| inline(start.value, bindings)).collect_vec();
        let (table, value) = table_compression::element(name, &values, "k");
        let locked = starts.iter().map(|start| start.locked).collect_vec();
        let locked = match locked.first() {
            Some(first) if locked.iter().all(|locked| locked == first) => first.to_string(),
            _ => {
                let name = format!("{}_LOCKED", name.to_uppercase());
                tables = format!("{tables}const {name}: [bool; {}] = {locked:?};\n", locked.len());
                format!("{name}.get(k) == Some(&true)")
            }
        };
        tables.push_str(&table);
        entries.push(format!("{name}: Start::declared({value}, {locked})"));
    }
    let states = states
        .map(|(state, field)| format!("start.{field} = {};\n", state_start(state, &model.params, bindings)));
    let (tables, states) = (emission.text(tables), emission.text(states.collect_vec().concat()));
    let entries = emission.list(entries);
    quote! {{
        let mut start = Starts::ZERO_;
        #tables
        start.each_body_(&mut |k, body| *body = BodyStart { #entries });
        #states
        start
    }}
}

/// The declared start of a body.
fn body_start(body: &Body, params: &[Param], bindings: &Bindings) -> String {
    let starts = body.start.iter().chain(&body.start_velocity);
    let entry = |(name, start): (&str, &Start)| {
        format!("{name}: {}", declared_start((start.value, start.locked), params, bindings))
    };
    let entries: Vec<String> = OF_BODY.into_iter().zip(starts).map(entry).collect_vec();
    format!("BodyStart {{ {} }}", entries.join(", "))
}

/// Start values as declared, with the parameters as they are; nothing where none of them reads a parameter.
pub(crate) fn declared(emission: &Emission) -> Option<TokenStream> {
    reads_parameters(emission.model).then(|| {
        let starts = declared_values(emission, &emission.parameters());
        quote! {
            fn declared_starts(&self) -> Starts<S> {
                let lit = S::lit;
                #starts
            }
        }
    })
}

/// A start as declared. One that reads parameters follows them.
fn declared_start((value, locked): (Expr, bool), params: &[Param], bindings: &Bindings) -> String {
    let text = inline(value, bindings);
    let read = algebra::symbols(&[value]);
    if params.iter().any(|param| read.contains(&param.symbol)) {
        return format!("Start::declared({text}, {locked})");
    }
    format!("Start::{}({text})", if locked { "locked" } else { "free" })
}

/// The mechanism with start values that follow its parameters, where some read them.
pub(super) fn following(emission: &Emission) -> Option<TokenStream> {
    let params = emission.model.params.iter().zip(&emission.fields.params);
    let taken = params.filter(|(param, _)| param.required).map(|(_, field)| field).collect_vec();
    reads_parameters(emission.model).then(|| {
        quote! {
            /// Starts that read parameters follow them, however these were set; starts that were set by hand stay.
            fn following_(mut self) -> Self {
                let (before, after) = (Self::of(#(self.#taken),*).start, rt::Statics::declared_starts(&self));
                rt::follow(&mut self.start, before, after);
                self
            }
        }
    })
}

/// Does a declared start read a parameter?
pub(super) fn reads_parameters(model: &Model) -> bool {
    let of_bodies = model.bodies.iter().flat_map(|body| body.start.iter().chain(&body.start_velocity));
    let values = of_bodies.map(|start| start.value).chain(model.states.iter().map(|state| state.start));
    let known = algebra::symbols(&values.collect_vec());
    model.params.iter().any(|param| known.contains(&param.symbol))
}

/// The declared start of a first-order state.
fn state_start(state: &State, params: &[Param], bindings: &Bindings) -> String {
    declared_start((state.start, state.locked), params, bindings)
}

/// Start values of a state in absolute coordinates, and of a moment.
pub(crate) fn placed(emission: &Emission) -> TokenStream {
    let Emission { model, fields, name, sizes: Sizes { full, .. }, .. } = emission;
    let (bindings, nq) = (emission.parameters(), emission.equations.q.len());
    let centres = model
        .bodies
        .iter()
        .map(|body| body.centre.components().map_each(|component| inline(component, &bindings)));
    let states = fields.states.iter().zip(2 * nq..);
    let (literals, starts) = if emission.rerolled {
        let states = states.map(|(field, k)| format!("start.{field}.value = x[{k}];\n")).collect_vec();
        let (tables, centre) = centre(&centres.collect_vec());
        let (tables, centre) = (emission.text(tables), emission.text(centre));
        let (states, nq) = (emission.text(states.concat()), number(nq));
        let loop_over_all = quote! {{
            #tables
            let mut start = self.start;
            let (q, v): ([S; #nq], [S; #nq]) = absolute::split(x);
            let (q, v) = (q.as_chunks::<3>().0, v.as_chunks::<3>().0);
            start.each_body_(&mut |k, body| {
                if let (Some(q), Some(v)) = (q.get(k), v.get(k)) {
                    *body = body.with_centre_at(#centre, *q, *v);
                }
            });
            #states
            start
        }};
        (Some(quote!(let lit = S::lit;)), loop_over_all)
    } else {
        let bodies = centres.zip(&fields.bodies).enumerate().map(|(k, ([x, y], field))| {
            let [q, v] = [3 * k, nq + 3 * k]
                .map_each(|first| format!("[x[{first}], x[{}], x[{}]]", first + 1, first + 2));
            format!("{field}: self.start.{field}.with_centre_at([{x}, {y}], {q}, {v})")
        });
        let states = states.map(|(field, k)| format!("{field}: self.start.{field}.at(x[{k}])"));
        let (literals, starts) = emission.values(bodies.chain(states).collect_vec());
        (literals, quote!(Starts { #starts }))
    };
    quote! {
        impl<S: Real> #name<S> {
            fn placed(&self, x: &[S; #full]) -> Starts<S> {
                #literals
                #starts
            }
        }

        impl<S: Real> State<S> {
            /// Poses, velocities and states of this moment as start values, with the locks that are set: to go on from here
            /// later, `mechanism.start = sim.starts()`.
            pub fn starts(&self) -> Starts<S> {
                self.mechanism.placed(&<#name<S> as rt::Statics>::full(self))
            }
        }
    }
}

/// The centre of gravity of the body with the number `k`, from O, after the tables that it reads.
pub(crate) fn centre(centres: &[[String; 2]]) -> (String, String) {
    let of_axis = |axis: usize, name| {
        let texts = centres.iter().map(|centre| centre[axis].clone()).collect_vec();
        table_compression::element(name, &texts, "k")
    };
    let [(x_table, x), (y_table, y)] = [of_axis(0, "centre_x"), of_axis(1, "centre_y")];
    (x_table + &y_table, format!("[{x}, {y}]"))
}

/// A look at the parameters, where there are any.
pub(super) fn check(emission: &Emission) -> Option<TokenStream> {
    (!emission.model.params.is_empty()).then(|| quote!(rt::Mechanism::check(self, t)?;))
}

/// After assembly: bodies without mass must be carried, where parameters can make some.
pub(super) fn carried(emission: &Emission) -> Option<TokenStream> {
    let bodies = limits::that_may_be_carried(emission)?;
    let count = number(bodies.len());
    let bodies = emission.lines(bodies);
    Some(quote! {
        const BODIES: [[rt::Limit; 2]; #count] = [#bodies];
        absolute::check_carried::<S, Self, NQ, NC>(self, t, &assembly.q, &BODIES)?;
    })
}

/// The assembled state with inputs.
pub(crate) fn assembled(emission: &Emission) -> TokenStream {
    let Emission { fields, name, sizes: Sizes { length, second_order, .. }, .. } = emission;
    let (check, carried) = (check(emission), carried(emission));
    let states = &fields.states;
    let numbers = (*second_order..).take(states.len()).map(number);
    let (begin, holding) = (begin(emission), holding(emission));
    let following = following(emission);
    let start = following.is_some().then(|| {
        quote! {
            fn start_holding_(&self, t: S, input: Input<S>) -> Result<(Held<S>, [S; #length]), Fault> {
                self.following_().start_here_(t, input)
            }
        }
    });
    let as_set = if start.is_some() { quote!(start_here_) } else { quote!(start_holding_) };
    quote! {
        impl<S: Real> #name<S> {
            #holding
            #following
            #start

            fn #as_set(&self, t: S, input: Input<S>) -> Result<(Held<S>, [S; #length]), Fault> {
                #check
                let assembly = absolute::assemble(self, t)?;
                #carried
                let mut x = [S::lit(0.0); #length];
                #(x[#numbers] = self.start.#states.value;)*
                #begin
                Ok((held, x))
            }
        }
    }
}

/// Discrete state with inputs, before anything is known of a state.
fn holding(emission: &Emission) -> TokenStream {
    let of_loops = match emission.form {
        Form::Loops(_) => {
            quote!(rt::charts::OfLoops::InChart {
                chart: 0,
                continuation: rt::charts::ContinuationData::nothing()
            })
        }
        Form::Tree(_) | Form::Absolute => quote!(()),
    };
    let [count, turns] = [emission.model.switches.len(), emission.model.turns.len()].map_each(number);
    let contact = if contact::are_there(emission) { quote!(rt::contact::Held::open()) } else { quote!(()) };
    quote! {
        fn holding_(input: Input<S>) -> Held<S> {
            rt::Held { input, switches: [S::lit(1.0); #count], turns: [0; #turns], of_loops: #of_loops, contact: #contact }
        }
    }
}

/// From the assembled pose to the state, and the sides of conditions that apply there.
fn begin(emission: &Emission) -> TokenStream {
    let sides = sides(emission);
    let contact = contact::are_there(emission).then(|| {
        let count = contact::count(emission);
        // Conditions read what contacts do: nothing becomes true by what they do where the run begins.
        let sides = sets::are_there(emission).then(|| {
            let count = sets::count(emission);
            quote!(rt::events::begin::<Self, #count>(self, t, &mut held, &x);)
        });
        quote! {
            rt::contact::begin::<Self, #count>(self, t, &mut held, &mut x)?;
            #sides
        }
    });
    // What contacts do, and reactions with their forces, are known after that.
    let again = (contact.is_some() && switched::read_forces(emission)).then(|| {
        let held = quote!(&mut held);
        if !sets::are_there(emission) {
            return take_sides(emission, &held);
        }
        let count = sets::count(emission);
        quote!(rt::events::begin::<Self, #count>(self, t, #held, &x);)
    });
    let mut repeats = None;
    let enter: fn(&TokenStream) -> TokenStream = match emission.form {
        Form::Loops(reduced) => {
            // Charts count on all rows: where some repeat others they would leave out a freedom.
            repeats = (!reduced.is_redundant(emission.model)).then(|| {
                quote! {
                    if assembly.redundant.contains(&true) {
                        let joints = rt::Names::marked(
                            Self::LAYOUT_.parts, &assembly.redundant
                        );
                        return Err(Fault::new(rt::Scalar::to_f64(t), rt::Cause::Repeats { joints }));
                    }
                }
            });
            |pose: &TokenStream| quote!(rt::charts::enter(self, t, &mut held, (#pose), &mut x);)
        }
        Form::Tree(_) => |pose: &TokenStream| quote!(self.to_chart(t, #pose, &mut x);),
        Form::Absolute => |pose: &TokenStream| quote!(absolute::join(#pose, &mut x);),
    };
    let [first, other] = [quote!(&assembly.q, &assembly.v), quote!(&q, &v)].map_each(|pose| enter(&pose));
    let close = conditional::close(emission, &quote!(held = Self::holding_(input); #other #sides));
    quote! {
        #repeats
        let mut held = Self::holding_(input);
        #first
        #sides
        #close
        #contact
        #again
    }
}
