//! Prescribed motions that no motor can follow.

use crate::collect::CollectVec;
use crate::sorted::sort_by;
use plm_cas::{Expr, algebra};

use crate::diag::{Code, Diagnostics};
use crate::model::{Model, Port, Steady};

/// Reports rows whose place or speed jumps at a known time, each once.
pub(crate) fn check_jumps(model: &Model, diagnostics: &mut Diagnostics) {
    for row in 0..model.rows.len() {
        let mut steady: Vec<Steady> =
            model.jumps.iter().filter(|jump| jump.row == row).filter_map(|jump| jump.steady).collect_vec();
        sort_by(&mut steady, |a, b| a.of_speed.cmp(&b.of_speed).then(a.at.total_cmp(&b.at)));
        report(model, row, &steady, diagnostics);
    }
}

/// Reports the first of the jumps of a row, and when the others are.
fn report(model: &Model, index: usize, steady: &[Steady], diagnostics: &mut Diagnostics) {
    let Some((first, others)) = steady.split_first() else { return };
    let row = &model.rows[index];
    let (what, per) = if first.of_speed { ("speed", "/s") } else { ("place", "") };
    let Steady { at, by, .. } = first;
    let unit = &row.unit.text;
    let message =
        format!("the {what} that `{}` prescribes jumps by {by} {unit}{per} at t = {at} s", row.name);
    let diagnostic = diagnostics.error(Code::JumpingMotion, row.span, message);
    let times: Vec<String> = others.iter().take(8).map(|other| format!("{} s", other.at)).collect_vec();
    if !times.is_empty() {
        diagnostic.note(format!("it jumps too at t = {}", times.join(", ")));
    }
    for port in moving_ports(model, index) {
        diagnostic.note_at(port.name.span, format!("the port `{}` of the ground moves", port.name.text));
    }
    diagnostic.help(if first.of_speed {
        "lead it there smoothly: `smooth_table(t, …)` goes through the points of a table without kinks"
    } else {
        "no body is at two places: lead it from one to the other, as in `smooth_table(t, (1 s, 0 m), (1.5 s, 2 m))`"
    });
}

/// Ports of the ground on which the part of a row stands and whose place reads what jumps in it.
fn moving_ports(model: &Model, row: usize) -> impl Iterator<Item = &Port> {
    let jumps = model.jumps.iter().filter(move |jump| jump.row == row && jump.steady.is_some());
    let switches: Vec<Expr> = jumps.map(|jump| model.switches[jump.switch].symbol).collect_vec();
    let frames = model.parts[model.rows[row].part].frames.iter().filter(|frame| frame.body.is_none());
    frames.filter_map(|frame| model.ground.get(frame.port)).filter(move |port| {
        let read = algebra::symbols(&[port.at.x, port.at.y, port.angle]);
        switches.iter().any(|switch| read.contains(switch))
    })
}
