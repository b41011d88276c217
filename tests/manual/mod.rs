//! The demos of the manual: every figure that it prints, and the balance of energy and power.
//!
//! `numbers.json` holds the printed figures, how they are to be read, and the exact values after them, which come from an
//! independent model of the same demos.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod assembly;
mod from_text;
mod ledger;
mod modes;
mod numbers;
mod pages;
mod program;
mod runs;

use std::path::PathBuf;
use std::sync::OnceLock;

use crate::demos::DEMOS;
use crate::demos::sheet::{Line, Sheet};

/// A folder where the browser's tests look for what is written here (`crates/plm-view/page/check.sh`): that which cargo names to the programs
/// of `tests/` alone.
fn made(name: &str) -> PathBuf {
    let program = std::env::current_exe().unwrap();
    let target = program.ancestors().nth(3).unwrap();
    target.join("tmp").join(name)
}

/// The sheet of a demo; each runs once.
fn sheet(demo: &str) -> &'static Sheet {
    static SHEETS: [OnceLock<Sheet>; DEMOS.len()] = [const { OnceLock::new() }; DEMOS.len()];
    let index = DEMOS.iter().position(|(name, _)| *name == demo).unwrap();
    SHEETS[index].get_or_init(|| DEMOS[index].1().unwrap())
}

fn line(demo: &str, name: &str) -> &'static Line {
    let found = sheet(demo).lines.iter().find(|line| line.name == name);
    found.unwrap_or_else(|| panic!("{demo} does not show `{name}`"))
}

/// A module of tests per demo: one per printed figure, one for the balance, one for what is known besides.
macro_rules! demos {
    ($($demo:ident: $name:literal, $balanced:literal { $($test:ident: $figure:literal,)* })*) => {
        $(mod $demo {
            $(#[test]
            fn $test() {
                super::numbers::agrees($name, $figure);
            })*

            #[test]
            fn energy_and_power_are_balanced() {
                assert_eq!(super::is_balanced($name), $balanced);
            }

            #[test]
            fn everything_on_the_sheet_holds() {
                let sheet = super::sheet($name);
                assert!(sheet.holds() && sheet.demo == $name, "{sheet}");
            }
        })*

        /// Demos and figures that have a test.
        const TESTED: &[(&str, &[&str])] = &[$(($name, &[$($figure),*])),*];
    };
}

demos! {
    double_pendulum: "DoublePendulum", true {
        unlocked_th1: "unlocked th1",
        unlocked_th2: "unlocked th2",
        locked_x_g1: "locked xG1",
        locked_y_g1: "locked yG1",
        locked_x_g2: "locked xG2",
        locked_y_g2: "locked yG2",
        locked_th1: "locked th1",
        locked_th2: "locked th2",
        force_of_pivot_3: "force pivot3 |Fy| at 40 s",
        force_of_pivot_5: "force pivot5 |Fy| at 40 s",
    }
    prismatic_joint: "PrismaticJoint", true {
        damper_rating: "R = 2*0.7*sqrt(1000*20)",
        displacement: "dy = 20*9.81/10000",
        equilibrium: "y equilibrium",
    }
    connect_plm_hyd: "ConnectPlmHyd", true {
        body_angle: "body angle",
        locked_p2: "p2 (locked)",
        force_of_the_list: "F jack (list, Step 5)",
        force_of_the_text: "F jack (text \"4722.3N\")",
        p1: "p1",
        beta: "beta",
        f_jx: "Fjx analytic",
        f_jy: "Fjy analytic",
        f_jack: "Fjack analytic",
        displacement_at_the_start: "jack displacement start",
        final_displacement_on_the_stop: "final displacement (\"on the end stops\"), dpn=0.5 bar",
    }
    connect_plm_hcd: "ConnectPlmHCD", true {}
    double_arm: "DoubleArm", true {
        angle_of_body_5: "angle body 5",
        x_of_body_17: "xG body 17",
        force_of_jack_1: "F jack 1",
        force_of_jack_2: "F jack 2",
        p1_of_jack_1: "p1 jack 1",
        p1_of_jack_2: "p1 jack 2",
        force_of_jack_1_is_positive: "min jack-1 force > 0 (plot), dpn=1.35 bar: 1=true",
    }
    plmpiv00: "PLMPIV00", true {}
    plmpiv10: "PLMPIV10", true {
        moment_of_inertia: "moment of inertia",
        mean_speed: "mean speed",
    }
    plmtra00: "PLMTRA00", true {}
    plmtra10: "PLMTRA10", true {
        spring_force_at_0_deg: "static spring force 0 deg",
        spring_force_at_30_deg: "static spring force 30 deg",
        spring_force_at_60_deg: "static spring force 60 deg",
        spring_force_at_90_deg: "static spring force 90 deg",
    }
    plmtrpi00: "PLMTRPI00", true {}
    plmj00: "PLMJ00", true {
        static_force: "static force",
    }
    quadrorhomb: "Quadrorhomb", true {}
    plmbod02: "PLMBOD02", true {}
    plmassembly: "PLMASSEMBLY", true {
        redundant_constraints: "redundant constraints",
    }
    plmemb01: "PLMEMB01", true {}
    plmt01d: "PLMT01D", true {}
    plmt01d01: "PLMT01D01", true {}
    // A plate that is fixed: nothing moves.
    plmcalcul: "PLMCALCUL", false {
        case_1_xa: "case 1 Xa",
        case_1_ya: "case 1 Ya",
        case_2_xr: "case 2 Xr",
        case_2_yr: "case 2 Yr",
    }
}

/// Do both balances stand on the sheet, and hold?
fn is_balanced(demo: &str) -> bool {
    let lines = sheet(demo).lines.iter().filter(|line| line.name.ends_with(" balance"));
    let held: Vec<bool> = lines.map(Line::holds).collect();
    assert!(held.iter().all(|held| *held), "{}", sheet(demo));
    held.len() == 2
}

#[test]
fn every_demo_is_tested() {
    let tested: Vec<&str> = TESTED.iter().map(|(demo, _)| *demo).collect();
    let shown: Vec<&str> = DEMOS.iter().map(|(demo, _)| *demo).collect();
    assert_eq!(tested, shown);
}

#[test]
fn every_printed_figure_is_tested() {
    for (demo, tested) in TESTED {
        let tested: Vec<&str> = tested.to_vec();
        let shown: Vec<&str> = sheet(demo)
            .lines
            .iter()
            .filter(|line| line.is_printed())
            .map(|line| line.name.as_str())
            .collect();
        assert_eq!(tested, shown, "{demo}");
        assert_eq!(numbers::reproduced(demo, true).len(), tested.len(), "{demo}");
    }
}

#[test]
fn figures_that_hang_on_what_the_manual_leaves_unsaid_are_those_of_the_independent_model() {
    let mut count = 0;
    for (demo, _) in TESTED {
        for name in numbers::reproduced(demo, false) {
            numbers::agrees_with_the_model(demo, &name);
            count += 1;
        }
    }
    assert_eq!(count, 5);
}
