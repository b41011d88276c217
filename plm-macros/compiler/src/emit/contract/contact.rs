//! `Contacts`: rows of contact as the runtime asks for them, and what the other contracts call of them.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::{joined, quote};
use proc_macro2::{Literal, TokenStream};

use super::super::bindings::Origin;
use super::super::function::function;
use super::super::lower::inline;
use super::super::{Emission, Form, Sizes, memory, number, quoted};
use super::charted::call;
use super::contact_events::PER_ROW;
use crate::formulate::ContactFunctions;
use crate::model::{ContactLaw, Impacts, Stabilisation};

/// Has the mechanism rows of contact?
pub(in super::super) fn are_there(emission: &Emission) -> bool {
    !emission.model.contacts.is_empty()
}

/// Number of rows.
pub(in super::super) fn count(emission: &Emission) -> Literal {
    number(emission.model.contacts.len())
}

/// The type of what is held of contact.
pub(in super::super) fn held(emission: &Emission) -> TokenStream {
    let count = count(emission);
    if are_there(emission) { quote!(rt::contact::Held<S, #count>) } else { quote!(()) }
}

/// The functions of rows, `Contacts`, and what loads the multipliers; nothing without contact.
pub(crate) fn contacts(emission: &Emission) -> TokenStream {
    if !are_there(emission) {
        return TokenStream::new();
    }
    let (functions, rows, contract) = (functions(emission), rows(emission), contract(emission));
    quote!(#functions #rows #contract)
}

/// The straight-line functions, chart by chart.
fn functions(emission: &Emission) -> TokenStream {
    let name = &emission.name;
    let of: Vec<(&ContactFunctions, Origin)> = match emission.form {
        Form::Absolute => {
            emission.program.contact.iter().map(|contact| (contact, Origin::Arguments)).collect_vec()
        }
        Form::Tree(chart) => {
            chart.contact.iter().map(|contact| (contact, Origin::Chart(chart))).collect_vec()
        }
        Form::Loops(reduced) => {
            let charts = reduced.charts.iter();
            charts.filter_map(|chart| Some((chart.contact.as_ref()?, Origin::Chart(chart)))).collect_vec()
        }
    };
    let all = of.into_iter().enumerate().map(|(k, of)| in_chart(emission, k, of)).collect_vec();
    let (all, exist, count) = (joined(all), &emission.program.rows_exist, count(emission));
    let exist = some_may_not_exist(emission).then(|| {
        function(
            emission,
            "Does each row of contact exist? 1, or 0.",
            &quote!(fn rows_exist(&self, u: &Held<S>, exist: &mut [S; #count])),
            (exist, Origin::Arguments),
        )
    });
    quote!(impl<S: Scalar> #name<S> { #all #exist })
}

fn in_chart(emission: &Emission, k: usize, (contact, origin): (&ContactFunctions, Origin)) -> TokenStream {
    let (Sizes { length, .. }, count) = (&emission.sizes, count(emission));
    let memory = emission.loops().map(|reduced| memory(reduced, &quote!(S)));
    let memory = memory.map(|memory| quote!(m: &#memory,));
    let state = quote!(t: S, u: &Held<S>, #memory x: &[S; #length]);
    let [rows, response] = ["contact_rows", "contact_response"].map_each(|name| emission.in_chart(name, k));
    let rows = function(
        emission,
        "Rows of contact: gaps, rates, accelerations without contact forces, Delassus operator, limits of friction.",
        &quote!(fn #rows(&self, #state, rows: &mut rt::contact::Rows<S, #count>)),
        (&contact.rows, origin),
    );
    let response = function(
        emission,
        "What the multipliers that are held add to the rate.",
        &quote!(fn #response(&self, #state, dx: &mut [S; #length])),
        (&contact.response, origin),
    );
    quote!(#rows #response)
}

/// The rows at a state, and what is held with the multipliers there.
fn rows(emission: &Emission) -> TokenStream {
    let (Emission { name, sizes: Sizes { length, .. }, .. }, count) = (emission, count(emission));
    let [_, memory] = emission.memory_argument();
    let rows = call(emission, "contact_rows", &quote!(t, u, #memory x, &mut rows), &quote!({}));
    let loads = loads(emission);
    let response = call(emission, "contact_response", &quote!(t, u, #memory x, &mut dx), &quote!({}));
    quote! {
        impl<S: Scalar> #name<S> {
            fn contact_rows_(&self, t: S, u: &Held<S>, x: &[S; #length]) -> rt::contact::Rows<S, #count> {
                let mut rows = rt::contact::Rows::none();
                #rows;
                #loads
                rows
            }

            fn contact_response_(
                &self, t: S, u: &Held<S>, x: &[S; #length], lambda: &[S; #count]
            ) -> [S; #length] {
                let mut held = *u;
                held.contact.lambda = *lambda;
                let (u, mut dx) = (&held, [S::lit(0.0); #length]);
                #response;
                dx
            }

            /// The discrete state with the multipliers of contact at a state.
            #[inline]
            fn loaded_(&self, t: S, u: &Held<S>, x: &[S; #length]) -> Held<S> {
                let mut held = *u;
                if !u.contact.has_forces() {
                    return held;
                }
                held.contact = rt::contact::with_multipliers(&self.contact_rows_(t, u, x), &u.contact);
                held
            }
        }

        impl<S: Real> State<S> {
            /// The discrete state with the multipliers of contact.
            fn loaded_(&self) -> Held<S> {
                self.mechanism.loaded_(self.time, &self.held, &self.x)
            }
        }
    }
}

/// Kinds of the reactions that bound frictions; the sign of one along a line is held.
fn loads(emission: &Emission) -> TokenStream {
    let contacts = emission.model.contacts.iter().enumerate();
    let loads = contacts.filter_map(|(row, contact)| {
        let load = match contact.reaction()?.components.len() {
            1 => format!("Line {{ negative: u.contact.modes.negative[{row}] }}"),
            _ => "Plane".to_owned(),
        };
        Some(format!("rows.load[{row}] = rt::contact::Load::{load};"))
    });
    emission.text(loads.collect_vec().concat())
}

/// `Contacts`.
fn contract(emission: &Emission) -> TokenStream {
    let (Emission { name, sizes: Sizes { length, .. }, model, .. }, count) = (emission, count(emission));
    let laws = laws(emission);
    let impacts = match model.impacts {
        Impacts::Poisson => quote!(Poisson),
        Impacts::Newton => quote!(Newton),
        Impacts::Sequential => quote!(Sequential),
    };
    let (joints, existence) = (joints(emission), existence(emission));
    let size = emission.text(format!("{:?}", emission.report.length));
    quote! {
        impl<S: Real> rt::contact::Contacts<#count> for #name<S> {
            #laws

            fn rows<T: Scalar>(
                &self, t: T, u: &Held<S>, x: &impl Fn(usize) -> T, constant: &impl Fn(S) -> T
            ) -> rt::contact::Rows<T, #count> {
                use rt::lanes::Pack;
                let number = |[s]: [S; 1]| constant(s);
                let (mechanism, held) = (self.pack([self], number), Self::pack_held(u, [u], number));
                mechanism.contact_rows_(t, &held, &core::array::from_fn(x))
            }

            fn rows_at(&self, t: S, u: &Held<S>, x: &[S; #length]) -> rt::contact::Rows<S, #count> {
                self.contact_rows_(t, u, x)
            }

            fn free_rate(&self, t: S, u: &Held<S>, x: &[S; #length], dx: &mut [S; #length]) -> rt::Health<S> {
                let mut held = *u;
                held.contact.lambda = [S::lit(0.0); #count];
                self.rate_holding_(t, &held, x, dx)
            }

            fn response(
                &self, t: S, u: &Held<S>, x: &[S; #length], lambda: &[S; #count]
            ) -> [S; #length] {
                self.contact_response_(t, u, x, lambda)
            }

            fn impact_law(&self) -> rt::contact::ImpactLaw {
                rt::contact::ImpactLaw::#impacts
            }

            fn length(&self) -> S {
                S::lit(#size)
            }

            #existence
            #joints
        }
    }
}

/// Which rows exist, where that is a question.
fn existence(emission: &Emission) -> Option<TokenStream> {
    let count = count(emission);
    some_may_not_exist(emission).then(|| {
        quote! {
            fn exists(&self, u: &Held<S>, row: usize) -> bool {
                let mut exist = [S::lit(0.0); #count];
                self.rows_exist(u, &mut exist);
                exist[row] > S::lit(0.5)
            }
        }
    })
}

/// Has a row a condition for its existence?
pub(super) fn some_may_not_exist(emission: &Emission) -> bool {
    emission.model.contacts.iter().any(|row| row.exists.is_some())
}

/// Projection of the joints, where the state is not in coordinates of its own.
fn joints(emission: &Emission) -> Option<TokenStream> {
    let Sizes { length, .. } = &emission.sizes;
    let projects = matches!(emission.model.stabilisation, Stabilisation::Projection);
    (!emission.is_reduced() && projects).then(|| {
        quote! {
            fn project_joints(&self, t: S, _u: &Held<S>, x: &mut [S; #length]) -> Result<(), Fault> {
                absolute::project_state::<S, Self, NQ, NC, #length>(self, t, x)
            }

            fn drift_of_joints(&self, t: S, _u: &Held<S>, x: &[S; #length]) -> rt::Drift<S> {
                absolute::drift::<S, Self, NQ, NC, #length>(self, t, x)
            }
        }
    })
}

/// `contact_name` of `Labels`.
pub(super) fn labels(emission: &Emission) -> Option<TokenStream> {
    let (count, names) = (count(emission), emission.model.contacts.iter().map(|contact| &contact.name));
    let names = emission.text(quoted(names));
    are_there(emission).then(|| {
        quote! {
            fn contact_name(&self, row: usize) -> &'static str {
                const NAMES: [&str; #count] = [#names];
                NAMES.get(row).copied().unwrap_or_default()
            }
        }
    })
}

/// By guard of contact, the name of its row; the determinant of the active rows has that of the first.
pub(super) fn names_of_guards<'a>(emission: &'a Emission) -> impl Iterator<Item = &'a String> {
    let contacts = &emission.model.contacts;
    let of_rows = contacts.iter().flat_map(|contact| [&contact.name; PER_ROW]);
    of_rows.chain(contacts.first().map(|contact| &contact.name))
}

/// Laws of the rows.
fn laws(emission: &Emission) -> TokenStream {
    let bindings = emission.parameters();
    let laws = emission.model.contacts.iter().map(|contact| match &contact.law {
        ContactLaw::Unilateral { restitution } => {
            format!("rt::contact::Law::Unilateral {{ restitution: {} }}", inline(*restitution, &bindings))
        }
        ContactLaw::Friction { .. } => "rt::contact::Law::Friction".to_owned(),
        ContactLaw::Constraint => "rt::contact::Law::Constraint".to_owned(),
    });
    let laws = laws.enumerate().map(|(row, law)| format!("{row} => {law}")).collect_vec();
    let (literals, laws) = emission.values(laws);
    quote! {
        fn law(&self, row: usize) -> rt::contact::Law<S> {
            #literals
            match row {
                #laws
                _ => rt::contact::Law::Friction,
            }
        }
    }
}
