//! Is the formulation that the user ordered to be had?

use crate::diag::{Code, Diagnostics};
use crate::formulate::Program;
use crate::model::{Model, Rung};

/// Reports an order of joint coordinates for a mechanism that has none, and why.
pub(crate) fn check_rung(model: &Model, program: &Program, diagnostics: &mut Diagnostics) {
    let (Some((rung @ (Rung::Tree | Rung::Loops), span)), Err(reason)) = (model.rung, &program.reduced)
    else {
        return;
    };
    let message = format!("there is no rung `{}` of this mechanism: {reason}", rung.name());
    diagnostics
        .error(Code::NoRung, span, message)
        .help("leave `rung` out: the least formulation is taken, and the report says which and why");
}
