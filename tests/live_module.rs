//! A mechanism as WebAssembly: node runs it, and gets the bits of the native run. What it writes the tests of the live page use.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use std::path::Path;
use std::process::Command;

use plm::Described;
use plm::live::Live;
use plm::runtime::described::{Place, Quantity};
use plm::view::live::Module;
use serde_json::json;

plm::mechanism! {
    /// A four-bar that goes through its charts, with a spring, a lag, parameters, an input, and two of the pulls that
    /// `plm::live::with_pulls` adds.
    pub FourBar {
        gravity: 9.81 m/s^2;
        param reach: mm = 400 mm;
        param friction: N*m*s/rad = 0.5 N*m*s/rad;
        input torque: N*m = 0;
        ground { port o: (0, 0) m; port p: (0.8, 0) m; }
        body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 40 deg, locked; start omega: 3 rad/s, locked; }
        body coupler {
            mass: 1 kg; inertia: 0.02 kg*m^2; port b: (-reach/2, 0); port c: (reach/2, 0);
            contour: (-0.6*reach, -0.03 m), (0.6*reach, -0.03 m), (0.6*reach, 0.03 m), (-0.6*reach, 0.03 m);
        }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (0.45, 0) m; port p: (-0.45, 0) m; start angle: 120 deg; }
        revolute o(ground.o, crank.a) { drive: lagging + torque; }
        revolute b(crank.b, coupler.b) { pin_diameter: 0.2*reach; }
        revolute c(coupler.c, rocker.c) { damping: friction; }
        revolute p(ground.p, rocker.p) { stiffness: 2 N*m/rad; }
        state lagging: N*m = 0.5 N*m;
        rate lagging = (1 N*m*cos(3 rad/s*t) - lagging)/0.01 s;
        output crank.angle in deg, o.force;
        part plm_pull(a: body) { input x: N = 0; input y: N = 0; input turn: N*m = 0; force on a: (x, y); torque on a: turn; }
        input plm_pull_0_x: N = 0; input plm_pull_0_y: N = 0; input plm_pull_0_turn: N*m = 0;
        plm_pull plm_pull_0(crank) { x: plm_pull_0_x; y: plm_pull_0_y; turn: plm_pull_0_turn; }
        input plm_pull_1_x: N = 0; input plm_pull_1_y: N = 0; input plm_pull_1_turn: N*m = 0;
        plm_pull plm_pull_1(coupler) { x: plm_pull_1_x; y: plm_pull_1_y; turn: plm_pull_1_turn; }
    }
}

/// Runs 300 intervals of 10 ms, turns a parameter and pulls a body in between, and prints the bits of all numbers after each.
const SCRIPT: &str = r#"
const wasm = new WebAssembly.Module(require("fs").readFileSync(process.argv[2]));
const { exports: live } = new WebAssembly.Instance(wasm, {});
for (let k = 0; k < 300; k++) {
    if (k === 150) live.plm_set_parameter(0, 0.41);
    if (k === 200) live.plm_pull(1, 0.3, 0.2, 4, -2);
    if (live.plm_step(0.01) !== 1) throw new Error("stopped");
    // The memory may grow while it is read.
    const [place, length] = [live.plm_read(), live.plm_length()];
    const words = new BigUint64Array(live.memory.buffer, place, length);
    console.log([...words].map((word) => word.toString(16)).join(" "));
}
live.plm_set_parameter(0, 9);
if (live.plm_restart() !== 0) throw new Error("it cannot be assembled with a coupler of 9 m");
const at = live.plm_trouble();
const length = live.plm_text_length();
console.log(new TextDecoder().decode(new Uint8Array(live.memory.buffer, at, length)));
"#;

fn native() -> String {
    let mut live = Live::new(FourBar::new());
    let mut text = String::new();
    for k in 0..300 {
        if k == 150 {
            live.set_parameter(0, 0.41);
        }
        if k == 200 {
            live.pull(1, [0.3, 0.2], [4.0, -2.0]);
        }
        assert!(live.step(0.01));
        let words: Vec<String> = live.read().iter().map(|number| format!("{:x}", number.to_bits())).collect();
        text += &(words.join(" ") + "\n");
    }
    live.set_parameter(0, 9.0);
    assert!(!live.restart());
    let error = live.error().unwrap();
    text + &format!("{}\n{}\n{}\n{}\n", error.time, error.part, error.gap, error.text)
}

/// What a results file would say of the mechanism, and the native run, for the tests of the live page
/// (`crates/plm-view/page/browser/live.test.js`).
fn about(native: &str) -> serde_json::Value {
    let (of, tables) = (FourBar::new(), <FourBar>::TABLES);
    let place = |name: &str, place: Option<Place<f64>>| {
        let Place { x, y, angle } = place.unwrap();
        json!({ "name": name, "x": x, "y": y, "angle": angle })
    };
    let bodies = tables.bodies.iter().enumerate().map(|(k, body)| {
        let ports = body.ports.iter().enumerate().map(|(j, name)| place(name, of.port(k, j)));
        let ports: Vec<_> = ports.collect();
        let contour: Vec<_> = (0..body.contour).filter_map(|point| of.contour(k, point)).collect();
        let contour = if contour.is_empty() { json!(null) } else { json!(contour) };
        json!({
            "name": body.name, "mass": of.mass(k), "inertia": of.inertia(k), "depth": of.depth(k), "ports": ports, "contour": contour,
        })
    });
    let ground = tables.ground.iter().enumerate().map(|(k, port)| place(port.name, of.ground(0.0, k)));
    let parts = tables.parts.iter().map(|part| {
        let frames = part.frames.iter();
        let frames =
            frames.map(|frame| json!({ "argument": frame.argument, "body": frame.body, "port": frame.port }));
        let frames: Vec<_> = frames.collect();
        json!({ "name": part.name, "kind": part.kind, "pair": part.pair, "frames": frames })
    });
    let quantity = |row: &Quantity| {
        let Quantity { name, unit, factor, exponents, default, .. } = *row;
        json!({ "name": name, "unit": unit, "factor": factor, "exponents": exponents, "default": default, "value": default })
    };
    let columns = <FourBar>::OBSERVED.iter().map(|(name, unit)| {
        let declared = tables.outputs.iter().find(|output| output.name == *name);
        json!({ "name": name, "unit": declared.map_or(unit, |output| &output.unit) })
    });
    json!({
        "mechanism": {
            "name": tables.name,
            "bodies": bodies.collect::<Vec<_>>(),
            "ground": ground.collect::<Vec<_>>(),
            "parts": parts.collect::<Vec<_>>(),
            "parameters": tables.parameters.iter().map(quantity).collect::<Vec<_>>(),
            "inputs": tables.inputs.iter().map(quantity).collect::<Vec<_>>(),
        },
        "columns": columns.collect::<Vec<_>>(),
        "native": native.lines().take(300).collect::<Vec<_>>(),
    })
}

#[test]
fn the_module_has_the_bits_of_the_native_run() {
    if Command::new("node").arg("--version").output().is_err() {
        println!("skipped: node is not installed (apt-get install nodejs)");
        return;
    }
    let folder = Path::new("target/plm/packages/live");
    let module = Module {
        name: "FourBar",
        declaration: <FourBar>::DECLARATION,
        files: <FourBar>::FILES,
        plm: Path::new(env!("CARGO_MANIFEST_DIR")),
    };
    let bytes = match module.build(folder) {
        Ok(bytes) => bytes,
        Err(error) if error.to_string().contains("rustup target add") => {
            println!("skipped: {error}");
            return;
        }
        Err(error) => panic!("{error}"),
    };
    println!("module of {} bytes", bytes.len());
    let [wasm, script] = ["four_bar.wasm", "run.cjs"].map(|name| folder.join(name));
    std::fs::write(&wasm, &bytes).unwrap();
    std::fs::write(&script, SCRIPT).unwrap();
    let output = Command::new("node").arg(&script).arg(&wasm).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let (found, expected) = (String::from_utf8(output.stdout).unwrap(), native());
    std::fs::write(folder.join("four_bar.json"), about(&expected).to_string()).unwrap();
    for (k, (found, expected)) in found.lines().zip(expected.lines()).enumerate() {
        assert_eq!(found, expected, "interval {k}");
    }
    assert_eq!(found.lines().count(), expected.lines().count());
}
