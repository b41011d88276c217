//! Values that must be positive: masses, inertias, compliances.

use crate::diag::{Code, Diagnostics};
use crate::model::Range;
use crate::numeric::{Scene, value};

/// Reports masses and inertias that are known to be wrong only with the defaults of the parameters that they read.
pub(super) fn check_masses(scene: &Scene, diagnostics: &mut Diagnostics) {
    for body in &scene.model.bodies {
        let mass = ("mass", body.mass, body.mass_span, "kg");
        let inertia = ("inertia", body.inertia, body.inertia_span, "kg*m^2");
        for (what, expr, span, unit) in [mass, inertia] {
            let found = value(expr, &scene.values);
            if scene.model.reads_required(expr) {
                continue;
            }
            if !(found > 0.0 && found.is_finite()) {
                let name = &body.name.text;
                let message =
                    format!("the {what} of `{name}` must be positive and finite, found {found} {unit}");
                let diagnostic = diagnostics.error(Code::NotPositive, span, message);
                if expr.as_number().is_none() {
                    diagnostic.note("this is its value with the defaults of the parameters").help(
                        "give them others: at the start those that are set then are looked at (the book, E0402)",
                    );
                }
            }
        }
    }
}

/// Reports compliances and requirements that are known to be wrong only with the defaults of the parameters that they read; false if
/// there are some.
pub(super) fn check_limits(scene: &Scene, diagnostics: &mut Diagnostics) -> bool {
    let mut are_kept = true;
    for limit in scene.model.limits.iter().filter(|limit| !scene.model.reads_required(limit.value)) {
        let found = value(limit.value, &scene.values);
        if limit.range.holds(found) {
            continue;
        }
        are_kept = false;
        let (what, part, unit, wanted) = (&limit.what, &limit.part, &limit.unit, limit.range.words());
        let space = if unit.is_empty() { "" } else { " " };
        let message = match limit.range {
            Range::Required => format!("the requirement `{part}` does not hold, by {} in SI units", -found),
            _ => format!("the {what} of `{part}` must be {wanted}, found {found}{space}{unit}"),
        };
        diagnostics
            .error(limit.code, limit.span, message)
            .note("this is its value with the defaults of the parameters")
            .help(format!(
                "give them others: at the start those that are set then are looked at (the book, {})",
                limit.code
            ));
    }
    are_kept
}
