//! What pictures need to know, as constants: contours, depths, sizes. Parameters have their defaults here.

use plm_cas::Expr;

use super::{Emission, push};
use crate::numeric::{defaults, value};

pub(crate) fn emit(text: &mut String, emission: &Emission) {
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
    constant(
        text,
        "CONTOURS",
        "&'static [[f64; 2]]",
        "Outlines of bodies for pictures: points from G in the axes of the body, m.",
        &contours.collect::<Vec<_>>(),
    );
    let of_bodies = model.bodies.iter().map(|body| (body.name.text.clone(), body.depth));
    let of_ground = model.ground.iter().map(|port| (format!("ground.{}", port.name.text), port.depth));
    let depths = of_bodies.chain(of_ground).filter_map(|(name, depth)| Some((name, depth?)));
    constant(
        text,
        "DEPTHS",
        "f64",
        "Depths of bodies and of ports of the ground for pictures, along z, m.",
        &depths.map(|(name, depth)| format!("({name:?}, {:?})", number(depth))).collect::<Vec<_>>(),
    );
    let sizes = model.sizes.iter().map(|size| (&size.name, number(size.value))).filter(|of| of.1 != 0.0);
    constant(
        text,
        "SIZES",
        "f64",
        "Sizes of parts for pictures that are not 0, m.",
        &sizes.map(|(name, size)| format!("({name:?}, {size:?})")).collect::<Vec<_>>(),
    );
    for file in &model.files {
        // The file is read while this is expanded; rustc is told that it matters.
        push(
            text,
            format_args!(
                "    const _: &[u8] = include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/\", {file:?}));\n"
            ),
        );
    }
}

fn constant(text: &mut String, name: &str, kind: &str, doc: &str, entries: &[String]) {
    push(
        text,
        format_args!(
            "    /// {doc}\n    pub const {name}: [(&'static str, {kind}); {}] = [{}];\n",
            entries.len(),
            entries.join(", ")
        ),
    );
}
