//! Is the formulation that the user ordered to be had?

use crate::diag::{Code, Diagnostics};
use crate::formulate::Program;
use crate::model::{Formulation, Model};

/// Reports an order of joint coordinates for a mechanism that has none, and why.
pub(crate) fn check_formulation(model: &Model, program: &Program, diagnostics: &mut Diagnostics) {
    let (Some((formulation @ (Formulation::Tree | Formulation::Loops), span)), Err(reason)) =
        (model.formulation, &program.reduced)
    else {
        return;
    };
    let message = format!("there is no formulation `{}` of this mechanism: {reason}", formulation.name());
    diagnostics
        .error(Code::NoFormulation, span, message)
        .help("leave `formulation` out: the least formulation is taken, and the report says which and why");
}
