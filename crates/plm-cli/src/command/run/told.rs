//! Notices, counters and events of a run.

use std::io::{self, Write};

use plm_dynamic::Run;
use plm_runtime::Stats;
use plm_runtime::contact::Counts;

/// Something that switched: time, s, and name.
pub(super) type Event = (f64, String);

/// Writes the notices of a run.
pub(super) fn notices(run: &mut Run, to: &mut dyn Write) -> io::Result<()> {
    run.notices().into_iter().try_for_each(|notice| writeln!(to, "plm: notice: {notice}"))
}

/// Writes counts that are not zero, and all events.
pub(super) fn stats(run: &mut Run, events: &[Event], to: &mut dyn Write) -> io::Result<()> {
    let stats = run.stats();
    writeln!(to, "plm: {}", listed(&steps(&stats)))?;
    if stats.longest_step > 0.0 {
        writeln!(to, "plm: longest step {:.3e} s", stats.longest_step)?;
    }
    if stats.errors > 0.0 {
        let (largest, sum) = (100.0 * stats.largest_error, 100.0 * stats.errors);
        writeln!(to, "plm: steps err by up to {largest:.2e} % of the state, by {sum:.2e} % together")?;
    }
    let contacts = contacts(&run.contact_stats());
    if contacts.iter().any(|(count, _)| *count > 0) {
        writeln!(to, "plm: contact: {}", listed(&contacts))?;
    }
    for (time, what) in events {
        writeln!(to, "plm: t = {time:.9} s: {what}")?;
    }
    Ok(())
}

pub(super) type Counted = (u64, &'static str);

pub(super) fn steps(of: &Stats) -> [Counted; 14] {
    [
        (of.steps, "steps"),
        (of.rejected, "rejected"),
        (of.evaluations, "evaluations"),
        (of.jacobians, "matrices of derivatives"),
        (of.factorisations, "decompositions"),
        (of.projected, "projections"),
        (of.by_rank, "evaluations by rank"),
        (of.charts, "changes of chart"),
        (of.change_points, "change points"),
        (of.near_singular, "steps near singular poses"),
        (of.divided, "made in parts"),
        (of.switches, "switches"),
        (of.passed_over, "passed over"),
        (of.renewed, "assembled anew"),
    ]
}

fn contacts(of: &Counts) -> [Counted; 9] {
    [
        (of.impacts, "impacts"),
        (of.closures, "closures"),
        (of.openings, "openings"),
        (of.sticks, "sticks"),
        (of.slips, "slips"),
        (of.ambiguous, "ambiguous"),
        (of.ambiguous_impacts, "ambiguous impacts"),
        (of.undetermined_impacts, "undetermined impacts"),
        (of.undetermined, "undetermined"),
    ]
}

/// Those that are not zero.
fn listed(counted: &[Counted]) -> String {
    let own = counted.iter().filter(|(count, _)| *count > 0);
    own.map(|(count, what)| format!("{count} {what}")).collect::<Vec<_>>().join(", ")
}
