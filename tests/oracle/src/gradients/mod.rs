//! Derivatives of runs by starts, lengths, masses and parameters, forward and backward, beside differences of runs without derivatives.
//!
//! Machines are drawn as people draw them: closed to the last digit, at rest, in a line with the axes, turned by 90, 180 and 37 deg,
//! mirrored.

mod beside;
mod drawn;
mod kinks;
mod linkages;
mod single;

use plm_dynamic::{Mechanism, Small};
use plm_runtime::adjoint::NoGradient;
use plm_runtime::gradient::By;
use plm_runtime::{Cause, Described, Fault, StartValues, Statics};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};
use beside::{Beside, backward, beside_differences, forward};

/// Derivatives are taken by so many numbers of a case.
const MOST: usize = 4;

/// A declaration, and until when it runs.
struct Machine {
    family: &'static str,
    text: String,
    /// s.
    until: f64,
    /// Expectation of its derivatives.
    known: Known,
}

/// Expectation of the derivatives of a machine.
#[derive(Clone, Copy, PartialEq)]
enum Known {
    /// They are what differences of runs tell.
    Differences,
    /// There are none: the motion touches the boundary of a condition exactly.
    Touches,
    /// There are none by lengths: the motion goes through a pose at which a loop can go on in two ways.
    ChangePoint,
}

type Family = fn(&mut Draw) -> Machine;

const FAMILIES: [Family; 10] = [
    single::hanging,
    single::cart,
    linkages::double_pendulum,
    linkages::four_bar,
    linkages::driven,
    linkages::slider_crank,
    linkages::thrown,
    kinks::bumper,
    kinks::ceiling,
    kinks::neutral,
];

/// A machine, derived by some of its starts and parameters.
pub(crate) fn case(draw: &mut Draw) -> Case {
    let machine = draw.one_of(&FAMILIES)(draw);
    let (by, verdict) = match Mechanism::from_text(&machine.text).and_then(|mechanism| mechanism.small()) {
        Ok(own) => {
            let by = chosen(draw, &own);
            let verdict = judged(&machine, &own, &by);
            (by, verdict)
        }
        Err(error) => (Vec::new(), Verdict::Wrong(format!("refused: {error}"))),
    };
    Case {
        family: machine.family.to_owned(),
        text: format!("{}\n{} s, by {by:?}", machine.text, machine.until),
        verdict,
    }
}

/// Some of the parameters and starts.
fn chosen(draw: &mut Draw, own: &Small) -> Vec<By<'static>> {
    let mut all: Vec<By<'static>> =
        own.tables().parameters.iter().map(|parameter| By::Parameter(parameter.name)).collect();
    let mut starts = *own;
    starts.starts_mut().each(&mut |name, _| all.push(By::Start(name)));
    let mut chosen = Vec::new();
    while chosen.len() < MOST && !all.is_empty() {
        chosen.push(all.swap_remove(draw.below(all.len())));
    }
    chosen
}

fn judged(machine: &Machine, own: &Small, by: &[By<'static>]) -> Verdict {
    let mut worst = 0.0_f64;
    let (mut decided, mut stopped) = (false, false);
    let after = backward(own, by, machine.until);
    for (k, of) in by.iter().enumerate() {
        let ahead = match (forward(own, *of, machine.until), machine.known) {
            (Ok(ahead), _) => ahead,
            (Err(Cause::Grazes), Known::Touches) | (Err(Cause::ChangePoint), Known::ChangePoint) => {
                stopped = true;
                continue;
            }
            (Err(cause), _) => return Verdict::Wrong(format!("{of:?}: {cause:?}")),
        };
        let gradient = match &after {
            Ok(gradient) => Some(&gradient[k]),
            Err(NoGradient::Short(_)) => None,
            Err(NoGradient::Fault(Fault { cause: Cause::Grazes, .. })) if machine.known == Known::Touches => {
                None
            }
            Err(NoGradient::Fault(Fault { cause: Cause::ChangePoint, .. }))
                if machine.known == Known::ChangePoint =>
            {
                None
            }
            Err(error) => return Verdict::Wrong(format!("backward: {error}")),
        };
        match beside_differences(own, *of, machine.until, (&ahead, gradient)) {
            Beside::Right(share) => (decided, worst) = (true, worst.max(share)),
            Beside::Nothing => {}
            Beside::Wrong(why) => return Verdict::Wrong(format!("{of:?}: {why}")),
        }
    }
    match () {
        () if decided => Verdict::Right(worst),
        () if stopped => Verdict::Stopped("it has no derivatives".to_owned()),
        () => Verdict::Undecided("differences do not agree".to_owned()),
    }
}
