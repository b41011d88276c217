//! Texts of faults for Python.

use plm_runtime::{Cause, Fault};

/// Text of a fault with its time and its part. Names of the declaration stand in quotes of Python; details of Rust are left out.
pub fn words(fault: &Fault) -> String {
    let cause = match fault.cause {
        // A run goes on without a chart; it is the rates alone that are not had there.
        Cause::Singular { .. } | Cause::NotRegular => {
            "the pose is singular, or next to one: rates and their derivatives are not determined".to_owned()
        }
        Cause::Workspace { bytes, allowed } => {
            format!("a solution by rank takes {bytes} bytes of stack, and {allowed} are allowed")
        }
        cause => cause.to_string().replace('`', "'"),
    };
    let part = if fault.part.is_empty() { String::new() } else { format!("{}: ", fault.part) };
    format!("t = {} s: {part}{cause}", fault.time)
}

#[cfg(test)]
mod tests {
    use plm_runtime::Names;

    use super::{Cause, Fault, words};

    /// Each cause, with sizes that choose among its texts.
    fn causes() -> impl Iterator<Item = Cause> {
        let names = Names::marked(&["hinge", "guide"], &[true, true]);
        let (joints, locks, count) = (names, names, 1);
        let jumps = [(false, false), (false, true), (true, false), (true, true)];
        let jumps = jumps.map(|(angular, speed)| Cause::Jump { by: 0.1, angular, speed });
        let lengths = [-0.1, 1e-9, f64::NAN].map(|length| Cause::Interval { length });
        let drifts = [(1e-12, 1e-3), (1e-3, 1e-3)].map(|(phi, phi_dot)| Cause::Drift { phi, phi_dot });
        let branches = [true, false].map(|left| Cause::OtherBranch { first: "crank", second: "rod", left });
        let others = [
            Cause::NotFinite,
            Cause::NotAllowed { what: "mass", wanted: "positive", found: -1.0, unit: "kg" },
            Cause::Singular { rows: 3 },
            Cause::NotRegular,
            Cause::Workspace { bytes: 2 << 20, allowed: 1 << 20 },
            Cause::StepTooSmall { step: 1e-12 },
            Cause::StepTooLong { step: 0.1, error: 0.3 },
            Cause::NotConverged { step: 0.1 },
            Cause::Locked,
            Cause::TurnedTooFar { angle: 0.5 },
            Cause::Flat,
            Cause::ChangePoint,
            Cause::NoMotion,
            Cause::Undecided { gap: 1e-15 },
            Cause::EnergyJump { by: 1.0, of: 2.0 },
            Cause::TooManySteps { steps: 10 },
            Cause::Required,
            Cause::Zeno { events: 101, within: 1e-9, conditions: names },
            Cause::NotDecided,
            Cause::Impact { tried: 3 },
            Cause::NoMode { touching: 2, p: -0.1 },
            Cause::NotUnique { p: -1e-12 },
            Cause::ImpactGains { by: 0.1, of: 2.0 },
            Cause::TooManyContacts { touching: 9 },
            Cause::Sunk { by: 0.1 },
            Cause::Slips,
            Cause::Grazes,
            Cause::AtLimit,
            Cause::AtOnce { other: "landing" },
            Cause::Redundant { count, locks, joints },
            Cause::VelocityRedundant { count, locks, joints },
            Cause::Repeats { joints },
            Cause::Open { gap: 0.1 },
            Cause::VelocityOpen { gap: 0.1 },
        ];
        others.into_iter().chain(jumps).chain(lengths).chain(drifts).chain(branches)
    }

    #[test]
    fn python_is_told_nothing_of_rust() {
        for cause in causes() {
            for part in ["", "hinge"] {
                let said = words(&Fault::of_part(0.25, part, cause));
                for word in ["`", "::", "Sim", "Cause", "fn ", "Option", "plm"] {
                    assert!(!said.contains(word), "{word}: {said}");
                }
                assert!(said.starts_with("t = 0.25 s: ") && said.contains(part), "{said}");
            }
        }
    }
}
