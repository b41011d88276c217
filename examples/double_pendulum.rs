//! The double pendulum of the manual, section 2.2 (DoublePendulum.ame).
//!
//! ```text
//!            p12 ________________ forearm, G in the middle of 2 m, 0 deg
//!              /
//!             /  arm, 1 m, 45 deg
//!        o0 _/_
//!          ////
//! ```
//!
//! Three runs: the assembly without locks, which lands where the manual's Newton lands; the assembly with both angles
//! locked; and 40 s of falling and swinging with a damper in each pivot. Every figure that the manual prints stands
//! beside its own. The trajectory is written as a page that moves, and its curves, to `target/plm/`; `--help` tells what else.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use plm::view::{Chart, Figures, Options};

plm::mechanism! {
    /// The double pendulum of the manual, section 2.2.
    pub DoublePendulum {
        gravity: 9.81 m/s^2;

        ground { port o0: (0, 0) m; }

        body arm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port o0:  (-0.5, 0) m;
            port p12: ( 0.5, 0) m;
            start angle: 45 deg, locked;
        }
        body forearm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port p12: (-1, 0) m;
            start angle: 0 deg, locked;
        }

        revolute shoulder(ground.o0, arm.o0)    { damping: 1 N*m/(rev/min); }
        revolute elbow(arm.p12, forearm.p12)    { damping: 1 N*m/(rev/min); }

        output arm.angle in deg, forearm.angle in deg, shoulder.force, elbow.force;
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    // The figures are those of one method, and the mechanism has neither parameters nor inputs.
    let options = Options::table().without(&["serve", "method", "set", "input"]).from_args()?;
    if let Some(help) = &options.help {
        println!("{help}");
        return Ok(ExitCode::SUCCESS);
    }
    let mut figures = Figures::new();
    unlocked_assembly(&mut figures)?;
    locked_assembly(&mut figures)?;
    dynamic_run(&options, &mut figures)?;
    Ok(figures.finish())
}

/// Step 5 of the manual: without locks both bodies move to the nearest assembled pose.
fn unlocked_assembly(figures: &mut Figures) -> Result<(), plm::Fault> {
    let mut pendulum = DoublePendulum::new();
    pendulum.start.arm.angle.locked = false;
    pendulum.start.forearm.angle.locked = false;
    let assembly = pendulum.assemble()?;
    println!("Assembly without locks\n{assembly}");
    figures.compare("unlocked th1", assembly.q[2].to_degrees(), "deg", 68.1934, 1e-4);
    figures.compare("unlocked th2", assembly.q[5].to_degrees(), "deg", -25.7586, 1e-4);
    Ok(())
}

/// Step 6 of the manual: both angles are locked, the centres follow.
#[allow(clippy::approx_constant, reason = "the manual prints 1/sqrt(2) to eight digits")]
fn locked_assembly(figures: &mut Figures) -> Result<(), plm::Fault> {
    let assembly = DoublePendulum::new().assemble()?;
    println!("\nAssembly with both angles locked\n{assembly}");
    let [x1, y1, th1, x2, y2, th2] = assembly.q;
    figures.compare("locked xG1", x1, "m", 0.353_553_39, 1e-8);
    figures.compare("locked yG1", y1, "m", 0.353_553_39, 1e-8);
    figures.compare("locked xG2", x2, "m", 1.707_106_78, 1e-8);
    figures.compare("locked yG2", y2, "m", 0.707_106_78, 1e-8);
    figures.compare("locked th1", th1.to_degrees(), "deg", 45.0, 1e-9);
    figures.compare("locked th2", th2.to_degrees(), "deg", 0.0, 1e-9);
    Ok(())
}

/// Step 7 of the manual: 40 s of motion, recorded every 20 ms, unless the options say otherwise.
fn dynamic_run(options: &Options, figures: &mut Figures) -> Result<(), Box<dyn Error>> {
    let mut sim = DoublePendulum::new().start()?;
    for (joint, turn) in sim.branches() {
        println!("\nbranch: {joint} turns by {:.2} deg", turn.to_degrees());
    }
    let mut recorder = options.recorder(&sim);
    let (until, every) = (options.until.unwrap_or(40.0), options.every.unwrap_or(0.02));
    let run = plm::view::run(&mut sim, &mut recorder, until, every);
    // What was recorded before a failure is written all the same.
    let recording = recorder.recording();
    let curves = Path::new("target/plm/double_pendulum.svg");
    Chart::over_time(recording).titled("Double pendulum, manual section 2.2").write_svg(curves)?;
    let mut written = plm::view::write::<DoublePendulum>(options, recording)?;
    run?;
    println!("\nDynamic run: {:?}", sim.stats());
    if until == 40.0 {
        figures.compare("force pivot3 |Fy| at 40 s", sim.shoulder_force()[1].abs(), "N", 200.0, 5.0);
        figures.compare("force pivot5 |Fy| at 40 s", sim.elbow_force()[1].abs(), "N", 100.0, 3.0);
    }
    written.push(curves.to_owned());
    for path in written {
        println!("written: {}", path.display());
    }
    Ok(())
}
