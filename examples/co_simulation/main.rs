//! Two FMUs, an arm and its controller, and the run of both in one mechanism: `cargo run --features view --example
//! co_simulation`; `couple.py` beside this file couples the FMUs.

mod mechanisms;

use std::path::Path;

use mechanisms::{Arm, Controller, Whole};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = Path::new("target/plm/co_simulation");
    plm::view::fmu(&Arm::new(), &folder.join("arm.fmu"))?;
    plm::view::fmu(&Controller::new(), &folder.join("controller.fmu"))?;
    let (mut sim, mut rows) = (Whole::new().start()?, Vec::new());
    sim.run(3.0, 0.05, |state| rows.push(format!("{:?},{:?}", state.time(), state.arm_angle())))?;
    std::fs::write(folder.join("whole.csv"), rows.join("\n"))?;
    println!("written to {}: arm.fmu, controller.fmu, whole.csv", folder.display());
    Ok(())
}
