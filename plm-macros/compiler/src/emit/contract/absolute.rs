//! `Absolute`: the constraints, for assembly, projection and the fallback.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use plm_cas::Vec2;
use proc_macro2::{Literal, TokenStream};

use super::super::bindings::Origin;
use super::super::function::{body, function};
use super::super::item::start;
use super::super::lower::inline;
use super::super::{Emission, Sizes, number, quoted, table_compression};
use crate::formulate::coordinate_name;
use crate::model::{Contact, Row, Turn};

/// `Absolute`.
pub(crate) fn absolute(emission: &Emission) -> TokenStream {
    let Emission { name, equations, program, report, sizes: Sizes { nq, nc, .. }, .. } = emission;
    let layout = layout(emission, &[]);
    let places = equations.phi_q.iter().enumerate();
    let places = places.flat_map(|(i, row)| row.iter().flat_map(move |(j, _)| [i as u32, *j as u32]));
    let places: Vec<u32> = places.collect_vec();
    let (entries, places) = (number(places.len() / 2), table_compression::numbers(emission, &places));
    let length = Literal::f64_unsuffixed(report.length);
    let [(literals, positions), (_, velocities)] = starts(emission);
    let (branch, refine) = (branch(emission), super::singular::refine(emission));
    let of_pose = |docs, arguments: &[&str], of| body(emission, docs, arguments, (of, Origin::Pose));
    let (phi_docs, phi) = of_pose(
        "Residuals of the constraints, m or rad; the rows stand in the table of this module.",
        &["t", "q", "phi"],
        &program.phi,
    );
    let (phi_dot_docs, phi_dot) =
        of_pose("Their rates, `phi_q v - nu`, m/s or rad/s.", &["t", "q", "v", "phi_dot"], &program.phi_dot);
    // By itself, since `phi_q` is compiled for each of its callers.
    let phi_q = function(
        emission,
        "The derivatives of phi by q: the entries that are not zero, row by row.",
        &quote! {
            #[cold]
            fn phi_q_entries(&self, t: S, q: &[S; #nq], phi_q: &mut [S; #entries])
        },
        (&program.phi_q, Origin::Pose),
    );
    let (min_norm_docs, min_norm) = of_pose(
        "The shortest step in the norm of `W^-1` that closes `r`: `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`.
Returns the smallest pivot ratio of the factorisation.",
        &["t", "q", "w", "r", "dq"],
        &program.min_norm,
    );
    let (inverse_mass_docs, inverse_mass) = of_pose(
        "Diagonal of `M^-1`: 1/kg, 1/kg, 1/(kg m^2) per body.",
        &["inverse_mass"],
        &program.inverse_mass,
    );
    // rustdoc shows a constant argument by its source, which is the whole declaration.
    quote! {
        impl<S: Scalar> #name<S> {
            const LAYOUT_: absolute::Layout = #layout;

            #phi_q
        }

        #[doc(hidden)]
        impl<S: Real> absolute::Absolute<S, NQ, NC> for #name<S> {
            fn layout(&self) -> &'static absolute::Layout {
                const { &Self::LAYOUT_ }
            }

            #phi_docs
            fn phi(&self, t: S, q: &[S; #nq]) -> [S; #nc] {
                let mut phi = [S::lit(0.0); #nc];
                #phi
                phi
            }

            #phi_dot_docs
            fn phi_dot(&self, t: S, q: &[S; #nq], v: &[S; #nq]) -> [S; #nc] {
                let mut phi_dot = [S::lit(0.0); #nc];
                #phi_dot
                phi_dot
            }

            fn phi_q(&self, t: S, q: &[S; #nq], each: &mut impl FnMut(usize, usize, S)) {
                let places: &[[u32; 2]] = const { &rt::compact::pairs::<#entries>(&#places) };
                let mut entries = [S::lit(0.0); #entries];
                self.phi_q_entries(t, q, &mut entries);
                for (&[row, column], entry) in places.iter().zip(entries) {
                    each(row as usize, column as usize, entry);
                }
            }

            #min_norm_docs
            fn min_norm(
                &self, t: S, q: &[S; #nq], w: &[S; #nq], r: &[S; #nc], dq: &mut [S; #nq]
            ) -> rt::Health<S> {
                rt::Health({
                    #min_norm
                })
            }

            #inverse_mass_docs
            fn inverse_mass(&self) -> [S; #nq] {
                let mut inverse_mass = [S::lit(0.0); #nq];
                #inverse_mass
                inverse_mass
            }

            fn length(&self) -> S {
                S::lit(#length)
            }
            fn start_position(&self) -> [Start<S>; #nq] {
                #literals
                #positions
            }
            fn start_velocity(&self, q: &[S; #nq]) -> [Start<S>; #nq] {
                #literals
                #velocities
            }
            #branch
            #refine
        }
    }
}

/// Names of the rows of the joints, of others after them, and of coordinates.
pub(super) fn layout(emission: &Emission, others: &[&Contact]) -> TokenStream {
    let Emission { equations, model, .. } = emission;
    let names = model.rows.iter().map(|row| &row.name).chain(others.iter().map(|row| &row.name));
    let owners = model.rows.iter().map(|row| row.part).chain(others.iter().map(|row| row.part));
    let parts = owners.map(|part| model.parts[part].name.text.clone()).collect_vec();
    let angular =
        model.rows.iter().map(Row::is_angular).chain(others.iter().map(|row| row.unit.text == "rad"));
    let coordinates = (0..equations.q.len()).map(|k| coordinate_name(model, k)).collect_vec();
    let [rows, parts, coordinates] = [names.cloned().collect_vec(), parts, coordinates]
        .map_each(|names| table_compression::names(emission, &names));
    let given_angles = model.bodies.iter().map(|body| body.start[2].given).collect_vec();
    let given_angles = if given_angles.contains(&true) { given_angles } else { Vec::new() };
    let [angular, given_angles] = [angular.collect_vec(), given_angles].map_each(|all| marks(emission, &all));
    quote! {
        absolute::Layout {
            rows: const { &#rows },
            parts: const { &#parts },
            coordinates: const { &#coordinates },
            angular: &#angular,
            given_angles: &#given_angles,
        }
    }
}

/// An array of marks.
fn marks(emission: &Emission, marks: &[bool]) -> TokenStream {
    match marks.first() {
        Some(first) if marks.iter().all(|mark| mark == first) => {
            let count = number(marks.len());
            quote!([#first; #count])
        }
        _ => {
            let marks = emission.list(marks.iter().map(bool::to_string));
            quote!([#marks])
        }
    }
}

/// Start positions and velocities of G from those of O, after what it takes to read their constants.
fn starts(emission: &Emission) -> [(Option<TokenStream>, TokenStream); 2] {
    let Emission { model, fields, .. } = emission;
    let bindings = emission.parameters();
    let centres = model
        .bodies
        .iter()
        .map(|body| body.centre.components().map_each(|component| inline(component, &bindings)));
    if emission.rerolled {
        let nq = &emission.sizes.nq;
        let (tables, centre) = start::centre(&centres.collect_vec());
        let (tables, centre) = (emission.text(tables), emission.text(centre));
        let of_all = |value| {
            let before = quote!(let lit = S::lit; #tables);
            (
                Some(before),
                quote!({
                    let mut all = [Start::free(S::ZERO); #nq];
                    let mut starts = self.start;
                    starts.each_body_(&mut |k, body| {
                        if let Some(start) = all.as_chunks_mut::<3>().0.get_mut(k) {
                            *start = #value;
                        }
                    });
                    all
                }),
            )
        };
        let positions = of_all(quote!(body.of_centre(#centre)));
        let angle = quote!(rt::Vector::at(q, 3 * k + 2));
        let velocities = of_all(quote!(body.velocity_of_centre(#centre, #angle)));
        return [positions, velocities];
    }
    let (positions, velocities) = centres
        .zip(&fields.bodies)
        .enumerate()
        .map(|(k, ([x, y], field))| {
            (
                format!("self.start.{field}.of_centre([{x}, {y}])"),
                format!("self.start.{field}.velocity_of_centre([{x}, {y}], q[{}])", 3 * k + 2),
            )
        })
        .unzip();
    let count = number(fields.bodies.len());
    [positions, velocities].map_each(|list| {
        let (literals, list) = emission.values(list);
        let bodies = quote! {
            let bodies: [[Start<S>; 3]; #count] = [#list];
            core::array::from_fn(|k| bodies[k / 3][k % 3])
        };
        (literals, bodies)
    })
}

/// The mirror images that joints ask for.
fn branch(emission: &Emission) -> Option<TokenStream> {
    let Emission { model, equations, .. } = emission;
    let bindings = emission.parameters();
    let end = |end: Vec2| {
        let [x, y] = end.components().map_each(|component| inline(component, &bindings));
        format!("[{x}, {y}]")
    };
    let asked =
        equations.branches.iter().filter_map(|branch| Some((branch, model.parts[branch.part].branch?)));
    let arms = asked.enumerate().map(|(k, (branch, (turn, _)))| {
        let ends = branch.ends.map_each(|ends| format!("[{}]", ends.map_each(end).join(", "))).join(", ");
        let ([first, second], part) = (branch.bodies, &model.parts[branch.part].name.text);
        let names = quoted(branch.bodies.map_each(|body| &model.bodies[body].name.text));
        let left = turn == Turn::Left;
        format!(
            "{k} => Some(absolute::Branch {{
    part: {part:?},
    bodies: [{first}, {second}],
    names: [{names}],
    ends: [{ends}],
    left: {left},
}})"
        )
    });
    let arms: Vec<String> = arms.collect_vec();
    (!arms.is_empty()).then(|| {
        let (literals, arms) = emission.values(arms);
        quote! {
            fn branch(&self, index: usize) -> Option<absolute::Branch<S>> {
                #literals
                match index {
                    #arms
                    _ => None,
                }
            }
        }
    })
}
