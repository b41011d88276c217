//! The mechanism at one moment.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::{Emission, Form, Sizes, number};
use super::input::of_loops;

/// `State`.
pub(crate) fn state(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { length, .. }, .. } = emission;
    let (count, of_loops) = (number(emission.model.switches.len()), of_loops(emission));
    quote! {
        /// The mechanism at one moment; its methods read poses and outputs.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct State<S = f64> {
            /// The mechanism with its parameters.
            pub mechanism: #name<S>,
            /// The inputs.
            pub input: Input<S>,
            time: S,
            x: [S; #length],
            switches: [S; #count],
            of_loops: #of_loops,
        }
    }
}

/// The state in coordinates of all bodies, which rung 5 gives the reactions of loops at, and equilibria and starts are told in.
pub(crate) fn pose(emission: &Emission) -> TokenStream {
    let Sizes { nq, nx, full, second_order, .. } = &emission.sizes;
    let pose = match emission.form {
        Form::Absolute => quote!(absolute::split(&self.x)),
        Form::Tree(_) => quote! {
            let (mut q, mut v) = ([S::lit(0.0); #nq], [S::lit(0.0); #nq]);
            self.mechanism.pose(self.time, &rt::Moment::held(self), &self.x, &mut q, &mut v);
            (q, v)
        },
        Form::Loops(_) => {
            quote!(rt::charts::pose(&self.mechanism, self.time, &rt::Moment::held(self), &self.x))
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
    quote! {
        impl<S: Real> State<S> {
            /// Pose and velocity of every body.
            #[inline]
            fn pose_(&self) -> ([S; #nq], [S; #nq]) {
                #pose
            }
        }

        impl<S: Real> State<S> {
            /// The state in absolute coordinates.
            fn absolute_(&self) -> [S; #full] {
                let (q, v) = self.pose_();
                let mut x = [S::lit(0.0); #full];
                absolute::join(&q, &v, &mut x);
                #first_order
                x
            }
        }
    }
}
