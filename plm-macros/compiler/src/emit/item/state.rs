//! The mechanism at one moment.

use crate::collect::MapEach;
use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::contract::turns;
use super::super::{Emission, Form, Sizes, number};
use super::input::{of_contact, of_loops};

/// `State`.
pub(crate) fn state(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let (of_loops, of_contact) = (of_loops(emission), of_contact(emission));
    let [switches, turns] = [emission.model.switches.len(), emission.model.turns.len()].map_each(number);
    let remainder = (!emission.model.steps.is_empty()).then(|| quote!(remainder: rt::step::Remainder<S>,));
    quote! {
        /// The mechanism at one moment; its methods read poses and outputs, `input` has the inputs.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct State<S = f64> {
            /// The mechanism with its parameters.
            pub mechanism: #name<S>,
            held: rt::Held<Input<S>, [S; #switches], [i32; #turns], #of_loops #of_contact>,
            time: S,
            x: [S; #length],
            #remainder
        }

        /// Gives the `input` of a moment, and all else that is held over a step.
        impl<S: Real> core::ops::Deref for State<S> {
            type Target = Held<S>;

            fn deref(&self) -> &Held<S> {
                &self.held
            }
        }

        impl<S: Real> core::ops::DerefMut for State<S> {
            fn deref_mut(&mut self) -> &mut Held<S> {
                &mut self.held
            }
        }
    }
}

/// Pose and velocity of all bodies with all turns, of a `State`.
pub(crate) fn unwrapped_pose(emission: &Emission, state: &TokenStream) -> TokenStream {
    if turns::are_counted(emission) { quote!(#state.unwrapped_pose_()) } else { quote!(#state.pose_()) }
}

/// Poses, velocities and first-order states, in one row.
pub(crate) fn unwrapped_state(emission: &Emission, state: &TokenStream) -> TokenStream {
    if !turns::are_counted(emission) {
        return quote!(#state.absolute_());
    }
    let places = turns::in_pose(emission);
    quote! {{
        let mut x = #state.absolute_();
        rt::turns::add(&#state.held.turns, &mut x, #places);
        x
    }}
}

/// The state in absolute coordinates, where reactions of loops, equilibria and starts are computed.
pub(crate) fn pose(emission: &Emission) -> TokenStream {
    let Sizes { nq, nx, full, second_order, .. } = &emission.sizes;
    let pose = match emission.form {
        Form::Absolute => quote!(absolute::split(&self.x)),
        Form::Tree(_) => quote! {
            let (mut q, mut v) = ([S::lit(0.0); #nq], [S::lit(0.0); #nq]);
            self.mechanism.pose(self.time, &self.held, &self.x, &mut q, &mut v);
            (q, v)
        },
        Form::Loops(_) => {
            quote!(rt::charts::pose(&self.mechanism, self.time, &self.held, &self.x))
        }
    };
    let (to, from) = (number(2 * emission.equations.q.len()), number(*second_order));
    let first_order = (!emission.equations.x.is_empty()).then(|| {
        quote! {
            for k in 0..#nx {
                x[#to + k] = self.x[#from + k];
            }
        }
    });
    let unwrapped = turns::are_counted(emission).then(|| {
        let places = turns::in_pose(emission);
        quote! {
            /// Poses and velocities with all revolutions of the angles.
            fn unwrapped_pose_(&self) -> ([S; #nq], [S; #nq]) {
                let (mut q, v) = self.pose_();
                rt::turns::add(&self.held.turns, &mut q, #places);
                (q, v)
            }
        }
    });
    quote! {
        impl<S: Real> State<S> {
            /// Pose and velocity of every body.
            #[inline]
            fn pose_(&self) -> ([S; #nq], [S; #nq]) {
                #pose
            }
            #unwrapped
        }

        impl<S: Real> State<S> {
            /// The state in absolute coordinates.
            fn absolute_(&self) -> [S; #full] {
                self.joined_(&self.pose_())
            }

            /// The state in absolute coordinates, of pose and velocity.
            fn joined_(&self, (q, v): &([S; #nq], [S; #nq])) -> [S; #full] {
                let mut x = [S::lit(0.0); #full];
                absolute::join(q, v, &mut x);
                #first_order
                x
            }
        }
    }
}
