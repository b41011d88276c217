//! `plm export --mjcf` and `--urdf`: the motion is that of MuJoCo, by `crates/plm-import/tests/reference.py --exports`, and of what `plm import`
//! reads back; what a format does not have is told.

use std::fs;
use std::path::Path;

use super::{Said, folder, plm_in, root};

/// Coordinates of machine.plm after 0.4 s, by MuJoCo 4.0.0 from its export.
const MACHINE: [(&str, f64); 6] = [
    ("drive.angle", -1.104_061_041_682_844),
    ("pin.angle", -1.068_281_125_783_139),
    ("pivot.angle", -0.152_543_932_244_352),
    ("rail.displacement", -0.450_118_548_225_054),
    ("swing.angle", 1.971_212_813_142_182),
    ("groove.angle", -3.132_308_436_681_981),
];

/// Coordinates of servo.plm after 0.4 s, as above.
const SERVO: [(&str, f64); 4] = [
    ("shoulder.angle", 0.962_494_453_743_560),
    ("elbow.angle", 1.135_745_696_369_659),
    ("wrist.angle", 0.661_980_478_119_136),
    ("pivot.angle", 0.174_532_925_199_433),
];

fn model(name: &str) -> String {
    fs::read_to_string(root().join("crates/plm-import/tests/models").join(name)).unwrap()
}

/// Outputs of a declaration at its start and after 0.4 s, by name.
fn run(folder: &Path, text: &str, inputs: &[&str]) -> Vec<(String, [f64; 2])> {
    let words = ["run", "-", "--until", "0.4", "--every", "0.4", "--csv", "-", "--method", "Dop853:1e-12"];
    let given: Vec<&str> = inputs.iter().flat_map(|input| ["--input", input]).collect();
    let said = plm_in(folder, &[&words, &given[..]].concat(), text.as_bytes());
    assert_eq!(said.code, 0, "{said:?}\n{text}");
    let mut lines = said.output.lines();
    let names = lines.next().unwrap().split(',').map(|name| name.split(' ').next().unwrap().to_owned());
    let rows = [lines.next(), lines.last()]
        .map(|line| line.unwrap().split(',').map(|number| number.parse().unwrap()).collect::<Vec<f64>>());
    names.enumerate().map(|(k, name)| (name, [rows[0][k], rows[1][k]])).collect()
}

fn export(folder: &Path, text: &str, format: &str) -> Said {
    plm_in(folder, &["export", "-", format, "-"], text.as_bytes())
}

#[test]
fn an_exported_model_moves_as_in_mujoco() {
    for (file, inputs, expected) in [
        ("machine.plm", ["torque=0.3", "pull=0.5"], &MACHINE[..]),
        ("servo.plm", ["aim=0.9", "push=0.5"], &SERVO),
    ] {
        let found = run(&folder(), &model(file), &inputs);
        for (name, wanted) in expected {
            let (_, [_, got]) = found.iter().find(|(known, _)| known == name).unwrap();
            // Measured: 3.3e-13.
            assert!((got - wanted).abs() < 2e-12, "{name}: {got} for {wanted}");
        }
    }
}

#[test]
fn what_is_read_back_moves_as_before() {
    let folder = folder();
    // A slot in which something acts is more than `plm import` takes.
    let acting = " { stiffness: 25 N/m; damping: 0.4 N*s/m; rotary_damping: 0.01 N*m*s/rad; }";
    let machine =
        model("machine.plm").replace(acting, ";").replace(", groove.angle, groove.displacement", "");
    let imported = |name: &str| {
        let words = ["import", name, "--without", "limits", "--without", "friction"];
        plm_in(&root().join("crates/plm-import/tests/models"), &words, b"").output
    };
    for (text, format, inputs) in [
        (imported("oblique.xml"), "--mjcf", &[][..]),
        (imported("four_bar.xml"), "--mjcf", &["torque=0.5"]),
        (imported("arm.urdf"), "--mjcf", &[]),
        (machine, "--mjcf", &["torque=0.3", "pull=0.5"]),
        (model("servo.plm"), "--mjcf", &["aim=0.9", "push=0.5"]),
        (model("robot.plm"), "--mjcf", &["motor=0.5"]),
        (model("robot.plm"), "--urdf", &["motor=0.5"]),
    ] {
        let said = export(&folder, &text, format);
        // Pictures of other parts are left out.
        assert!(said.code == 0 && !said.errors.contains("error"), "{format} {said:?}");
        let said = plm_in(&folder, &["import", "-"], said.output.as_bytes());
        assert_eq!((said.code, said.errors.as_str()), (0, ""), "{format}");
        // The accelerations are outputs of the one, too.
        let outputs = text.lines().find(|line| line.contains("acceleration")).unwrap_or_default();
        let read_back = said.output.trim_end().trim_end_matches('}').to_owned() + outputs + "\n}\n";
        let before = run(&folder, &text, inputs);
        let mut compared = 0;
        for (name, numbers) in run(&folder, &read_back, inputs) {
            let Some((_, wanted)) = before.iter().find(|(known, _)| *known == name) else { continue };
            let size = wanted.iter().fold(1.0_f64, |size, number| size.max(number.abs()));
            for (number, wanted) in numbers.iter().zip(wanted) {
                // `plm import` rounds lengths to 1e-12 m. Measured: 1.1e-12.
                assert!((number - wanted).abs() < 3e-12 * size, "{format} {name}: {number} for {wanted}");
            }
            compared += 1;
        }
        assert!(compared > 2, "{format}: {compared}");
    }
}

/// The numbers of a text that stand between blanks and quotes.
fn numbers(text: &str) -> Vec<f64> {
    text.split([' ', '"']).filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn urdf_has_the_joints_at_zero_wherever_they_start() {
    let folder = folder();
    let usual = model("robot.plm");
    let other = usual
        .replace("start angle: -45 deg", "start angle: 20 deg")
        .replace("start angle: -65 deg", "start angle: 100 deg");
    let said = export(&folder, &other.replace("start x: 0.855006684424 m, locked;", ""), "--urdf");
    assert!(
        said.code == 0 && said.errors.contains("`shoulder` is drawn at 0 and not at its start, 1.134464"),
        "{}",
        said.errors
    );
    let [one, other] = [export(&folder, &usual, "--urdf").output, said.output].map(|text| numbers(&text));
    assert!(one.len() == other.len() && one.len() > 50);
    for (one, other) in one.iter().zip(other) {
        assert!((one - other).abs() < 1e-14 * one.abs().max(1.0), "{one} {other}");
    }
}

#[test]
fn what_a_format_does_not_have_is_told_and_nothing_is_written() {
    let bodies = "ground { port o: (0, 0) m; port p: (1, 0) m; }\n\
                  body a { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; port p: (1, 0) m; }\n\
                  body b { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }\n";
    let pin = "revolute pin(ground.o, a.o)";
    let folder = folder();
    for (items, format, wanted) in [
        (
            format!("{pin};\nspring s(ground.p, a.p) {{ stiffness: 1 N/m; }}"),
            "--mjcf",
            "error: the spring `s` is not written: what it does would be missing\n --> <stdin>:6:8",
        ),
        (
            format!("input u: N*m = 0;\n{pin} {{ drive: u^2/(1 N*m); }}"),
            "--mjcf",
            "error: `drive` of revolute `pin` is not a multiple of one input, clamped or not, which a motor is; of a revolute it may be affine \
             in one input, the angle and the speed, which a servo is\n --> <stdin>:6:10",
        ),
        (
            format!(
                "input u: N*m = 0;\nrevolute swing(ground.p, b.o);\n{pin} {{ drive: u - 1 N*m/rad*b.angle; }}"
            ),
            "--mjcf",
            "error: `drive` of revolute `pin` is not a multiple of one input",
        ),
        (
            format!("input u: N*m = 0;\n{pin} {{ drive: u - 1 N*m/rad*pin.angle; }}"),
            "--urdf",
            "error: the drive of `pin` is a servo, and URDF has motors alone",
        ),
        (
            format!("{pin};\nattached_rotor r(pin.shaft) {{ }}"),
            "--urdf",
            "error: the rotor of `pin` is not written: URDF has none",
        ),
        (
            format!("{pin};\nconstraint c: a.angle = 0;"),
            "--urdf",
            "error: `c` holds `pin`, which URDF does not have",
        ),
        (
            format!("{pin} {{ friction: 0.1; pin_diameter: 1 cm; }}"),
            "--mjcf",
            "error: `friction` of revolute `pin` has no counterpart in the format",
        ),
        (format!("{pin};\nconstraint c: a.x = 0;"), "--mjcf", "error: the constraint `c` is not written"),
        (
            format!("{pin};\nconstraint c: a.angle = 1 rad/s*t;"),
            "--mjcf",
            "error: the constraint `c` is not written",
        ),
        (
            format!("{pin};\nwhen a.omega > 1 rad/s {{ a.omega = 0; }}"),
            "--mjcf",
            "error: an event that sets states is not written\n --> <stdin>:6:6",
        ),
        (
            format!("{pin} {{ stiffness: 1 N*m/rad; }}"),
            "--urdf",
            "error: the spring of `pin` is not written: URDF has none",
        ),
        (
            format!("{pin};\nrevolute other(ground.p, a.p);"),
            "--urdf",
            "error: `other` closes a loop, which URDF does not have\n --> <stdin>:6:10",
        ),
        (
            format!(
                "{pin} {{ damping: 1 N*m*s/rad; }}\nrevolute other(ground.p, a.p) {{ damping: 1 N*m*s/rad; }}"
            ),
            "--mjcf",
            "error: `other` closes a loop: MJCF closes loops by points that coincide, in which nothing acts",
        ),
    ] {
        let said = export(&folder, &format!("pub T {{\n{bodies}{items}\n}}\n"), format);
        assert_eq!((said.code, said.output.as_str()), (1, ""), "{items}\n{}", said.errors);
        assert!(said.errors.contains(wanted), "{wanted}\n{}", said.errors);
    }
    // A joint of the library's name that is none of the library.
    let own = format!(
        "pub T {{\njoint revolute(a: frame, b: frame) {{ pair: revolute; constraint x: b.x - a.x = 0; constraint y: b.y - a.y = 0; torque on b from a: 1 N*m; }}\n{bodies}{pin};\n}}\n"
    );
    let said = export(&folder, &own, "--mjcf");
    assert!(said.code == 1 && said.errors.contains("error: the revolute `pin` is not written"), "{said:?}");
    // A warning leaves out what does not act.
    let text = format!(
        "pub T {{\n{bodies}{pin};\nvelocity_sensor v(a.p) {{ }}\ninput u: 1 = 0;\noutput w = u*a.angle;\n}}\n"
    );
    let said = export(&folder, &text, "--mjcf");
    assert!(
        said.code == 0
            && said
                .errors
                .contains("warning: the input `u` drives no joint: it is left out\n --> <stdin>:7:7"),
        "{said:?}"
    );
}
