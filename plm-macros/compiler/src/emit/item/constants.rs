//! Sizes, and what pictures need to know: contours, depths, sizes of parts. Parameters have their defaults here.

use plm_cas::Expr;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::super::{Emission, Sizes, docs, number};
use crate::numeric::{defaults, value};

/// `NQ`, `NC`, `NX`, `NDOF` and `OPERATIONS`.
pub(crate) fn sizes(emission: &Emission) -> TokenStream {
    let Emission { report, sizes: Sizes { nq, nc, nx, .. }, .. } = emission;
    let freedom = Literal::isize_unsuffixed(report.freedom);
    let operations = emission.text(docs::operations(&report.rate));
    quote! {
        /// Coordinates: (x, y, theta) of each body.
        pub const NQ: usize = #nq;
        /// Constraint rows.
        pub const NC: usize = #nc;
        /// First-order states.
        pub const NX: usize = #nx;
        /// Degrees of freedom, `3 N - M`.
        pub const NDOF: isize = #freedom;
        /// Operations of one evaluation of the right-hand side.
        pub const OPERATIONS: Operations = #operations;
    }
}

/// `CONTOURS`, `DEPTHS` and `SIZES`.
pub(crate) fn pictures(emission: &Emission) -> TokenStream {
    let Emission { model, .. } = emission;
    let known = defaults(model);
    let number = |expr: Expr| match expr.as_number() {
        Some(number) => number.to_f64(),
        None => value(expr, &known),
    };
    let contours = model.bodies.iter().filter(|body| !body.contour.is_empty()).map(|body| {
        let points = body.contour.iter().map(|at| format!("[{:?}, {:?}]", number(at.x), number(at.y)));
        format!("({:?}, &[{}])", body.name.text, points.collect::<Vec<_>>().join(", "))
    });
    let of_bodies = model.bodies.iter().map(|body| (body.name.text.clone(), body.depth));
    let of_ground = model.ground.iter().map(|port| (format!("ground.{}", port.name.text), port.depth));
    let depths = of_bodies.chain(of_ground).filter_map(|(name, depth)| Some((name, depth?)));
    let sizes = model.sizes.iter().map(|size| (&size.name, number(size.value))).filter(|of| of.1 != 0.0);
    let contours = constant(
        emission,
        ("CONTOURS", quote!(&'static [[f64; 2]])),
        "Outlines of bodies for pictures: points from G in the axes of the body, m.",
        contours.collect(),
    );
    let depths = constant(
        emission,
        ("DEPTHS", quote!(f64)),
        "Depths of bodies and of ports of the ground for pictures, along z, m.",
        depths.map(|(name, depth)| format!("({name:?}, {:?})", number(depth))).collect(),
    );
    let sizes = constant(
        emission,
        ("SIZES", quote!(f64)),
        "Sizes of parts for pictures that are not 0, m.",
        sizes.map(|(name, size)| format!("({name:?}, {size:?})")).collect(),
    );
    // The files are read while this is expanded; rustc is told that they matter.
    let files = &model.files;
    quote! {
        #contours
        #depths
        #sizes
        #(const _: &[u8] = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/", #files));)*
    }
}

fn constant(
    emission: &Emission,
    (name, kind): (&str, TokenStream),
    docs: &str,
    entries: Vec<String>,
) -> TokenStream {
    let (docs, name) = (docs::docs(emission, docs), Ident::new(name, Span::call_site()));
    let (count, entries) = (number(entries.len()), emission.list(entries));
    quote! {
        #docs
        pub const #name: [(&'static str, #kind); #count] = [#entries];
    }
}
