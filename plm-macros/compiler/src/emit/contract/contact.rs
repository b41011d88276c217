//! `Contacts`: rows of contact as the runtime asks for them, and what the other contracts call of them.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use proc_macro2::{Literal, TokenStream};

use super::super::lower::inline;
use super::super::{Emission, Sizes, number};
use super::{contact_motion, contact_sliding};
use crate::facts::contact as facts;
use crate::model::{ContactLaw, Impacts, Stabilisation};

/// Has the mechanism rows of contact?
pub(in super::super) fn are_there(emission: &Emission) -> bool {
    !emission.model.contacts.is_empty()
}

/// Room for rows, and for the reactions that bound them: the larger number of both.
pub(in super::super) fn count(emission: &Emission) -> Literal {
    number(facts::places(emission.model))
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
    let [functions, rows] = contact_motion::functions(emission);
    let (sliding, contract) = (contact_sliding::functions(emission), contract(emission));
    quote!(#functions #rows #sliding #contract)
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
    let (joints, existence, motion_at) =
        (joints(emission), existence(emission), contact_motion::motion_at(emission));
    let (pushes, falling) = (bounded_by_pushes(emission), bounds_that_may_fall(emission));
    let sliding = contact_sliding::contract(emission);
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
                mechanism.contact_rows_(t, &held, &rt::Vector::from_fn(x))
            }

            fn rows_at(&self, t: S, u: &Held<S>, x: &[S; #length]) -> rt::contact::Rows<S, #count> {
                self.contact_rows_(t, u, x)
            }

            fn kinematics<T: Scalar>(
                &self, t: T, u: &Held<S>, x: &impl Fn(usize) -> T, constant: &impl Fn(S) -> T
            ) -> rt::contact::Kinematics<T, #count> {
                use rt::lanes::Pack;
                let number = |[s]: [S; 1]| constant(s);
                let (mechanism, held) = (self.pack([self], number), Self::pack_held(u, [u], number));
                mechanism.contact_kinematics_(t, &held, &rt::Vector::from_fn(x))
            }

            fn kinematics_at(&self, t: S, u: &Held<S>, x: &[S; #length]) -> rt::contact::Kinematics<S, #count> {
                self.contact_kinematics_(t, u, x)
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

            #motion_at

            fn impact_law(&self) -> rt::contact::ImpactLaw {
                rt::contact::ImpactLaw::#impacts
            }

            fn length(&self) -> S {
                S::lit(#size)
            }

            #existence
            #pushes
            #falling
            #sliding
            #joints
        }
    }
}

/// Which rows exist, where that is a question.
fn existence(emission: &Emission) -> Option<TokenStream> {
    let count = count(emission);
    let rows = emission.model.contacts.len();
    let are_more = facts::places(emission.model) > rows;
    if !facts::some_may_not_exist(emission.model) {
        let rows = number(rows);
        return are_more.then(|| {
            quote! {
                fn exists(&self, _u: &Held<S>, row: usize) -> bool {
                    row < #rows
                }
            }
        });
    }
    Some(quote! {
        fn exists(&self, u: &Held<S>, row: usize) -> bool {
            let mut exist = [S::lit(0.0); #count];
            self.rows_exist(u, &mut exist);
            exist[row] > S::lit(0.5)
        }
    })
}

/// Frictions that are off without a push.
fn bounded_by_pushes(emission: &Emission) -> Option<TokenStream> {
    let rows = facts::bounded_by_pushes(emission.model).into_iter().map(number).collect_vec();
    (!rows.is_empty()).then(|| {
        quote! {
            fn is_bounded_by_pushes(&self, row: usize) -> bool {
                matches!(row, #(#rows)|*)
            }
        }
    })
}

/// Frictions whose bounds follow the state or the time, and are not known to be positive whatever these are.
fn bounds_that_may_fall(emission: &Emission) -> Option<TokenStream> {
    let rows = facts::bounds_that_may_fall(emission.model).into_iter().map(number).collect_vec();
    (!rows.is_empty()).then(|| {
        quote! {
            fn bound_may_fall(&self, row: usize) -> bool {
                matches!(row, #(#rows)|*)
            }
        }
    })
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
