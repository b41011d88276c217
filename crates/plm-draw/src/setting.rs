//! Settings: a parameter or an input has another value in the text.

use plm_compiler::syntax::ast::ItemKind;

use crate::number::Change;
use crate::refusal::Refusal;
use crate::sheet::Sheet;

/// Values are written to this part of themselves.
const FINE: f64 = 1e-9;

/// The number of a parameter or of an input with another value, SI.
///
/// # Errors
/// The text has no such parameter, or its value is no number.
pub(crate) fn changes(sheet: &Sheet<'_>, name: &str, value: f64) -> Result<Vec<Change>, Refusal> {
    let found = sheet.items().iter().find_map(|item| match &item.kind {
        ItemKind::Param(of) | ItemKind::Input(of) if of.name.ident.text == name => Some(of),
        _ => None,
    });
    let of = found.ok_or_else(|| Refusal::Unknown(name.to_owned()))?;
    let unit = of.unit.as_ref().map_or("", |unit| unit.text.as_str());
    let literal = of.value.as_ref().and_then(|expr| sheet.literal(expr, unit));
    let literal = literal.ok_or_else(|| Refusal::Formula(name.to_owned()))?;
    let size = value.abs().max(literal.si().abs()).max(f64::MIN_POSITIVE);
    Ok(vec![Change::new(&literal, value, FINE * size)])
}
