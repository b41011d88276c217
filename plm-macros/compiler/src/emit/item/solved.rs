//! Accelerations and multipliers at a state, for outputs that read them.

use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::contract::contact;
use super::super::{Emission, Sizes};
use crate::derive::feeds_back;

/// Accelerations and multipliers of a state, and which of them redundancy leaves undetermined.
pub(crate) fn solved(emission: &Emission) -> TokenStream {
    if emission.reactions().is_some() { of_tree(emission) } else { of_absolute(emission) }
}

/// The discrete state, with the forces of contact where there are some.
fn loaded(emission: &Emission) -> TokenStream {
    if contact::are_there(emission) {
        quote!(common.loaded.get_or_init(|| self.loaded_()))
    } else {
        quote!(&self.held)
    }
}

/// By the backward pass of a tree, whose reactions nothing leaves undetermined.
fn of_tree(emission: &Emission) -> TokenStream {
    let Sizes { nq, nc, .. } = &emission.sizes;
    let held = loaded(emission);
    let solved = emission.reads_solution().then(|| {
        quote! {
            /// Accelerations and multipliers.
            #[inline]
            fn solved_(&self, common: &Common<S>) -> ([S; #nq], [S; #nc]) {
                let (mut a, mut lambda) = ([S::lit(0.0); #nq], [S::lit(0.0); #nc]);
                self.mechanism.reactions(self.time, #held, &self.x, &mut a, &mut lambda);
                (a, lambda)
            }
        }
    });
    quote! {
        impl<S: Real> State<S> {
            #solved
            /// Reactions that redundancy leaves undetermined, by constraint row: none.
            pub fn undetermined(&self) -> [bool; #nc] {
                [false; #nc]
            }
        }
    }
}

/// By absolute coordinates, and by rank where elimination is unhealthy.
fn of_absolute(emission: &Emission) -> TokenStream {
    let Emission { name, sizes: Sizes { nq, nc, full, .. }, .. } = emission;
    let held = loaded(emission);
    let common = contact::are_there(emission).then(|| quote!(let common = &Common::<S>::new();));
    // Forces that read the unknowns are known for independent constraints alone.
    let refusal = feeds_back(emission.model)
        .then(|| quote!(return Err(Fault::new(t.to_f64(), rt::Cause::Singular { rows: #nc }));));
    quote! {
        impl<S: Real> #name<S> {
            /// Accelerations and multipliers by a rank-revealing decomposition.
            #[cold]
            fn accelerate(
                &self, t: S, u: &Held<S>, x: &[S; #full]
            ) -> Result<absolute::Acceleration<S, NQ, NC>, Fault> {
                #refusal
                let (q, _): ([S; #nq], [S; #nq]) = absolute::split(x);
                let (mut force, mut gamma) = ([S::lit(0.0); #nq], [S::lit(0.0); #nc]);
                self.free(t, u, x, &mut force, &mut gamma);
                let inverse_mass = absolute::Absolute::<S, NQ, NC>::inverse_mass(self);
                absolute::accelerate(t, &inverse_mass, &force, &gamma, |rows| absolute::phi_q_matrix(self, t, &q, rows))
            }
        }

        impl<S: Real> State<S> {
            /// Accelerations and multipliers; multipliers that redundancy leaves undetermined have their minimum norm.
            fn solved_(&self, common: &Common<S>) -> ([S; #nq], [S; #nc]) {
                let (mut dx, mut lambda) = ([S::lit(0.0); #full], [S::lit(0.0); #nc]);
                let (u, x) = (#held, self.joined_(common.pose.get_or_init(|| self.pose_())));
                let health = self.mechanism.dynamics(self.time, u, &x, &mut dx, &mut lambda);
                if !rt::Health(health).is_good() {
                    if let Ok(solution) = self.mechanism.accelerate(self.time, u, &x) {
                        return (solution.a, solution.lambda);
                    }
                }
                let (_, a): ([S; #nq], [S; #nq]) = absolute::split(&dx);
                (a, lambda)
            }

            /// Reactions that redundancy leaves undetermined, by constraint row; they are given with minimum norm.
            pub fn undetermined(&self) -> [bool; #nc] {
                #common
                match self.mechanism.accelerate(self.time, #held, &self.absolute_()) {
                    Ok(solution) => solution.undetermined,
                    Err(_) => [true; #nc],
                }
            }
        }
    }
}
