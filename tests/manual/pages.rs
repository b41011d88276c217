//! Runs of the demos as results files and pages, which the browser's tests open (`crates/plm-view/page/browser/scenes.test.js`).

use std::path::{Path, PathBuf};

use plm::live::with_pulls;
use plm::view::live::Module;
use plm::view::{Page, Recorder, Results};
use plm::{Described, Stabilise};

use crate::demos::double_arm::DoubleArm;
use crate::demos::double_pendulum::DoublePendulum;
use crate::demos::plmj00::Plmj00;
use crate::demos::plmtrpi00::Plmtrpi00;
use crate::demos::quadrorhomb::Quadrorhomb;

scene! {
    /// What no demo has: a spring between points, beside a guide and a jack whose diameters are given.
    pub Hoist {
        ground { port o: (0, 0) m, axis: 90 deg; port beam: (0.6, 2) m; port foot: (-0.6, 0) m; }
        body block { mass: 5 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m, angle: 90 deg; port left: (-0.4, 0) m; port right: (0.4, 0) m; start y: 1 m, locked; }
        prismatic guide(ground.o, block.o);
        spring coil(ground.beam, block.right) { stiffness: 200 N/m; free_length: 0.9 m; }
        jack ram(ground.foot, block.left) {
            free_length: 0.6 m; piston_diameter: 0.16 m; rod_diameter: 0.06 m;
            drive: 20 N - 40 N/(m/s)*ram.speed;
        }
        output block.y;
    }
}

fn folder() -> PathBuf {
    super::made("pages")
}

/// Records all that can be observed, and writes the results and their page; the size of the page in bytes.
fn written<M: Described<S = f64>>(mechanism: &M, until: f64, every: f64) -> u64 {
    let name = mechanism.tables().name;
    let mut sim = mechanism.start().unwrap();
    let mut recorder = Recorder::observing_all(&sim);
    recorder.run(&mut sim, until, every).unwrap();
    let results =
        Results { runs: vec![recorder.recording().clone()], ..Results::default() }.to_bytes().unwrap();
    let page = folder().join(name).with_extension("html");
    Page::new(&results, name).write_html(&page).unwrap();
    std::fs::write(page.with_extension("npz"), results).unwrap();
    let size = page.metadata().unwrap().len();
    println!("{}: {size} bytes", page.display());
    size
}

#[test]
fn small_ones() {
    written(&DoublePendulum::new(), 4.0, 0.005);
    written(&Quadrorhomb::new(), 1.4, 0.005);
    written(&Plmj00::new(), 1.0, 0.005);
    written(&Plmtrpi00::new(), 1.0, 0.005);
    written(&Hoist::new(), 2.0, 0.005);
}

/// 4 s at 200 Hz.
#[test]
fn double_arm() {
    let arms = DoubleArm { rated_drop: 1.5e5, ..DoubleArm::new() };
    let size = written(&arms.stabilise().unwrap().mechanism, 4.0, 0.005);
    assert!(size < 500_000, "{size} bytes");
}

/// The page with the mechanism itself in it, which takes the compiler of WebAssembly.
#[test]
fn double_arm_alive() {
    let bodies: Vec<&str> = <DoubleArm>::TABLES.bodies.iter().map(|body| body.name).collect();
    let module = Module {
        name: "DoubleArm",
        declaration: &with_pulls(<DoubleArm>::DECLARATION, &bodies),
        files: <DoubleArm>::FILES,
        plm: Path::new(env!("CARGO_MANIFEST_DIR")),
    };
    // Where `tests/live_module.rs` has built all but the mechanism.
    let bytes = match module.build("target/plm/packages/live") {
        Ok(bytes) => bytes,
        Err(error) if error.to_string().contains("rustup target add") => {
            println!("skipped: {error}");
            return;
        }
        Err(error) => panic!("{error}"),
    };
    let sim = DoubleArm::new().start().unwrap();
    let mut recorder = Recorder::observing_all(&sim);
    recorder.take(sim.state());
    let page = folder().join("DoubleArm-live.html");
    let results =
        Results { runs: vec![recorder.recording().clone()], ..Results::default() }.to_bytes().unwrap();
    Page::new(&results, "DoubleArm").with_module(&bytes).write_html(&page).unwrap();
    let size = page.metadata().unwrap().len();
    println!("{}: {size} bytes, of which the module is {}", page.display(), bytes.len());
    assert!(size < 600_000, "{size} bytes");
}
