//! `plm import`: motions, notices, exit codes. Numbers are those of MuJoCo, by `crates/plm-import/tests/reference.py`.

#[path = "../../../../tests/support/random.rs"]
mod random;

use std::fs;

use plm_import::{Level, Options};

use self::random::Random;
use super::{Said, folder, plm, plm_in, root};

/// Models of mechanisms.
const MODELS: [&str; 7] =
    ["cart.xml", "oblique.xml", "four_bar.xml", "four_bar.sdf", "follow.xml", "puck.xml", "arm.urdf"];

fn models() -> std::path::PathBuf {
    root().join("crates/plm-import/tests/models")
}

/// Output, messages and exit code of the import of a model.
fn import(name: &str, words: &[&str]) -> Said {
    plm_in(&models(), &[&["import", name], words].concat(), b"")
}

/// Imports a model without limits and dry friction, runs it with inputs for 0.4 s, and gives its coordinates by joint.
fn run(name: &str, inputs: &[&str]) -> Vec<(String, f64)> {
    let folder = folder();
    let said = import(name, &["--without", "limits", "--without", "friction"]);
    assert_eq!(said.code, 0, "{said:?}");
    fs::write(folder.join("model.plm"), said.output).unwrap();
    let given: Vec<&str> = inputs.iter().flat_map(|input| ["--input", input]).collect();
    let words =
        ["run", "model.plm", "--until", "0.4", "--every", "0.4", "--csv", "-", "--method", "Dop853:1e-12"];
    let said = plm_in(&folder, &[&words, &given[..]].concat(), b"");
    assert_eq!(said.code, 0, "{said:?}");
    let mut lines = said.output.lines();
    let names = lines.next().unwrap().split(',').map(|name| name.split('.').next().unwrap().to_owned());
    let numbers = lines.last().unwrap().split(',').map(|number| number.parse().unwrap());
    names.zip(numbers).collect()
}

/// Coordinates after 0.4 s, by MuJoCo 4.0.0.
const CART: [(&str, f64); 3] =
    [("rail", -0.007_995_906_509_087), ("pin", 0.382_399_200_056_469), ("elbow", 1.437_280_452_340_393)];
const OBLIQUE: [(&str, f64); 3] = [
    ("slope", 0.055_670_019_282_071),
    ("shoulder", -0.792_027_001_243_762),
    ("wrist", 0.094_115_621_057_329),
];
const FOUR_BAR: [(&str, f64); 3] =
    [("drive", -0.973_423_635_149_713), ("pin", 1.340_895_957_872_434), ("pivot", 0.024_119_660_764_297)];
const FOLLOW: [(&str, f64); 2] = [("lead", -1.234_502_569_311_652), ("bend", -1.444_801_033_543_914)];
const PUCK: [(&str, f64); 3] =
    [("along", 0.302_320_943_022_305), ("across", 0.105_442_730_380_094), ("elbow", 0.714_072_609_384_409)];
const ARM: [(&str, f64); 3] = [
    ("shoulder", -0.781_864_038_786_984),
    ("reach", 0.441_054_634_792_909),
    ("wrist", 0.093_223_019_114_143),
];

#[test]
fn imported_mechanisms_move_as_in_mujoco() {
    // Measured: 2.2e-11, 2.4e-12, 1.2e-11, 1.2e-11, 3.3e-12, 2.3e-12, 1.6e-13. MuJoCo's RK4 does not locate where the bounded force of cart.xml switches.
    for (name, inputs, expected, tolerance) in [
        ("cart.xml", &["push=0.6", "aim=0.2"][..], &CART[..], 1e-10),
        ("oblique.xml", &[], &OBLIQUE, 1e-11),
        ("four_bar.xml", &["torque=0.5"], &FOUR_BAR, 5e-11),
        ("four_bar.sdf", &["drive_input=0.5"], &FOUR_BAR, 5e-11),
        ("follow.xml", &[], &FOLLOW, 2e-11),
        ("puck.xml", &["pull=0.7", "twist=3"], &PUCK, 1e-11),
        ("arm.urdf", &[], &ARM, 1e-12),
    ] {
        let found = run(name, inputs);
        for (joint, wanted) in expected {
            let (_, got) = found.iter().find(|(known, _)| known == joint).unwrap();
            assert!((got - wanted).abs() < tolerance, "{name} {joint}: {got} for {wanted}");
        }
    }
}

#[test]
fn what_is_written_is_laid_out_and_compiles_without_warnings() {
    let folder = folder();
    for name in MODELS {
        let said = import(name, &[]);
        assert_eq!(said.code, 0, "{said:?}");
        fs::write(folder.join("model.plm"), &said.output).unwrap();
        let checked = plm_in(&folder, &["check", "model.plm"], b"");
        assert_eq!((checked.code, checked.errors.as_str()), (0, ""), "{}", said.output);
        assert_eq!(plm_in(&folder, &["fmt", "--check", "model.plm"], b"").code, 0, "{}", said.output);
    }
}

/// The example of the book is what the command writes.
#[test]
fn the_page_of_the_book_shows_what_is_written() {
    let page = fs::read_to_string(root().join("docs/src/running/import.md")).unwrap();
    let block = |word: &str| {
        let (_, after) = page.split_once(&format!("```{word}\n")).unwrap();
        after.split_once("```").unwrap().0.to_owned()
    };
    let folder = folder();
    fs::write(folder.join("pendulum.xml"), block("xml")).unwrap();
    let expected = Said { code: 0, output: block("plm"), errors: String::new() };
    assert_eq!(plm_in(&folder, &["import", "pendulum.xml"], b""), expected);
}

#[test]
fn joints_have_limits_friction_rotors_and_drives() {
    let Said { output, .. } = import("cart.xml", &[]);
    for line in [
        "    attached_mass rail_rotor(rail.slider) { mass: 0.3 kg; }",
        "        drive: 8 N*clamp(push, -1, 1);",
        "        stiffness: 0.5 N*m/rad;",
        "        rest: 20 deg;",
        "        lower_limit: -100 deg;",
        "        seal_friction: 0.01 N*m;",
        "        port tip: (0, 0.6) m;",
        "    input aim: rad = 0;",
        "        start angle: -10 deg, locked;",
        "        drive: clamp(3 N*m/rad*clamp(aim, -2 rad, 2 rad) - 3 N*m/rad*elbow.angle - 0.1 N*m*s/rad*elbow.speed, -0.5 N*m, 0.5 N*m);",
    ] {
        assert!(output.lines().any(|known| known == line), "{line}\n{output}");
    }
    let Said { output, .. } = import("follow.xml", &[]);
    assert!(
        output.contains("    constraint tendon: bend.angle = 0.8*lead.angle - 0.3*lead.angle^2;\n"),
        "{output}"
    );
    let Said { output, .. } = import("arm.urdf", &[]);
    for line in [
        "        drive: clamp(20*motor, -60 N*m, 60 N*m);",
        "    weld camera_mount(hand.camera_mount, camera.camera_mount);",
        // A link without mass that is fixed to another one is part of it.
        "        contour: (0, -0.04), (0.6, -0.04), (0.6, 0.04), (0, 0.04) m;",
    ] {
        assert!(output.lines().any(|known| known == line), "{line}\n{output}");
    }
}

#[test]
fn each_element_that_is_not_taken_is_told_with_its_place() {
    let lines = |name: &str| import(name, &[]).errors;
    let expected = "warning: <mesh> is not drawn\n --> arm.urdf:21:23\nwarning: <gazebo> is not taken\n --> arm.urdf:81:3\n";
    assert_eq!(lines("arm.urdf"), expected);
    assert_eq!(
        lines("four_bar.sdf"),
        "warning: collision of link `crank`: contacts are left out\n --> four_bar.sdf:16:9\n\
         warning: <sensor> `imu` of <link> `coupler` is not taken\n --> four_bar.sdf:26:9\n"
    );
}

#[test]
fn what_would_change_the_motion_is_an_error_and_nothing_is_written() {
    let body = |joint: &str| {
        format!(
            "<mujoco><worldbody><body name=\"a\"><joint name=\"p\" axis=\"0 1 0\"/><geom size=\"1\"/>\n\
             <body name=\"b\">{joint}<geom size=\"1\"/></body></body></worldbody></mujoco>"
        )
    };
    for (text, wanted) in [
        (body("<joint type=\"ball\"/>"), "error: <joint>: a ball joint is not planar\n --> <stdin>:2:16"),
        (
            body("<joint name=\"q\" axis=\"1 1 0\"/>"),
            "error: the axis of hinge `q` is not parallel to that of `p`",
        ),
        (
            body("<joint name=\"q\" type=\"slide\" axis=\"0 1 0\"/>"),
            "error: slide `q` leads out of the plane",
        ),
        (
            body("<joint damping=\"one\"/>"),
            "error: damping: expected numbers, found `one`\n --> <stdin>:2:23",
        ),
        (body("<joint class=\"none\"/>"), "error: <joint>: there is no default class `none`"),
        (
            body("<frame><joint name=\"q\" axis=\"0 1 0\"/></frame>"),
            "error: <joint> `q` within a frame is not taken\n --> <stdin>:2:23",
        ),
        (body("<freejoint/></body></body>"), "error: this is no XML: "),
        ("<mujoco><option density=\"1\"/></mujoco>".to_owned(), "forces of a fluid are not taken"),
        ("<mujoco><include file=\"none.xml\"/></mujoco>".to_owned(), "error: <include>: none.xml: "),
        (
            "<html/>".to_owned(),
            "error: <html> is no <robot> (URDF), <sdf> or <mujoco> (MJCF)\n --> <stdin>:1:1",
        ),
        ("<robot><link name=\"a\"/></robot>".to_owned(), "error: nothing in it moves"),
        ("<a>".repeat(5000) + &"</a>".repeat(5000), "error: elements are nested more than 200 deep"),
    ] {
        let Said { code, output, errors } = plm(&["import", "-"], &text);
        assert_eq!((code, output.as_str()), (1, ""), "{text}\n{errors}");
        assert!(errors.contains(wanted), "{wanted}\n{errors}");
    }
    assert_eq!(plm(&["import", "none.xml"], "").code, 2);
    assert_eq!(plm(&["import", "-", "--without", "wheels"], "<sdf/>").code, 2);
}

/// Free bodies, points of mass, starts outside of limits, names that are taken: what is written compiles.
#[test]
fn models_that_need_care_are_taken() {
    for (text, wanted, notice) in [
        (
            "<mujoco model=\"a walker\"><worldbody><body name=\"m\"><joint type=\"slide\" axis=\"1 0 0\"/><joint type=\"slide\" axis=\"0 0 1\"/>\
             <joint axis=\"0 1 0\"/><geom size=\"0.1\"/><body name=\"leg\" pos=\"0 0 -1\"><joint name=\"leg\" axis=\"0 -1 0\" range=\"5 150\"/>\
             <geom size=\"0.1\" pos=\"0 0 -1\"/></body></body></worldbody></mujoco>",
            "    revolute leg_joint(m_body.leg_joint, leg.leg_joint) {\n        lower_limit: 5 deg;",
            Some("joint `leg` would start at 0, outside of its limits: it starts at 0.0872664625997"),
        ),
        (
            "<robot name=\"pendulum\"><link name=\"base\"/><link name=\"bob\"><inertial><origin xyz=\"0 0 -2\"/><mass value=\"3\"/></inertial></link>\
             <joint name=\"pin\" type=\"continuous\"><parent link=\"base\"/><child link=\"bob\"/><axis xyz=\"1 0 0\"/></joint></robot>",
            "inertia: 1.2e-11 kg*m^2;",
            Some("`bob` has no inertia across the plane: 1.2e-11 kg*m^2 is written"),
        ),
        (
            "<robot name=\"xy\"><link name=\"world\"/><link name=\"x_dummy\"/><link name=\"puck\"><inertial><mass value=\"3\"/>\
             <inertia izz=\"0.1\"/></inertial></link><joint name=\"jx\" type=\"prismatic\"><parent link=\"world\"/><child link=\"x_dummy\"/>\
             <axis xyz=\"1 0 0\"/></joint><joint name=\"jy\" type=\"continuous\"><parent link=\"x_dummy\"/><child link=\"puck\"/>\
             <axis xyz=\"0 0 1\"/></joint></robot>",
            "    pin_slot jy(ground.jy, puck.jy);",
            None,
        ),
        // A geom has the class of its frame, and what is wrong with the frame is told once.
        (
            "<mujoco><option><flag contact=\"disable\"/></option><default><default class=\"heavy\"><geom density=\"2000\"/></default></default>\
             <worldbody><body name=\"bob\"><joint name=\"pin\" axis=\"0 1 0\"/><frame pos=\"0 0 -2\" childclass=\"heavy\"><geom size=\"0.1\"/>\
             <geom size=\"0.1\" density=\"500\"/></frame></body></worldbody></mujoco>",
            "mass: 10.471975512 kg;",
            None,
        ),
        // The leader is declared after its follower.
        (
            "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"><inertial><mass>1</mass></inertial></link><link name=\"b\"><inertial><mass>1</mass>\
             </inertial></link><joint name=\"f\" type=\"revolute\"><parent>world</parent><child>a</child><axis><xyz>0 1 0</xyz>\
             <mimic joint=\"g\"><multiplier>2</multiplier><offset>0</offset><reference>0</reference></mimic></axis></joint>\
             <joint name=\"g\" type=\"revolute\"><parent>world</parent><child>b</child><axis><xyz>0 1 0</xyz></axis></joint></model></sdf>",
            "constraint f_follows: ",
            None,
        ),
    ] {
        let Said { code, output, errors } = plm(&["import", "-"], text);
        assert_eq!(code, 0, "{errors}");
        assert!(output.contains(wanted) && !errors.contains("W0"), "{output}\n{errors}");
        assert!(notice.map_or(errors.is_empty(), |notice| errors.contains(notice)), "{output}\n{errors}");
    }
}

/// An included file, whose elements are told at their own places; models within models, and one that is static.
#[test]
fn models_of_several_files_and_of_several_models_are_taken() {
    let folder = folder();
    let bodies = "<mujoco><worldbody><body name=\"bob\"><joint name=\"pin\" axis=\"0 1 0\"/><geom class=\"ball\" pos=\"0 0 -2\"/>\n\
                  </body></worldbody><keyframe><key name=\"up\" qpos=\"3\"/></keyframe></mujoco>";
    fs::write(folder.join("bodies.xml"), bodies).unwrap();
    let outer = "<mujoco><option><flag contact=\"disable\"/></option><default><default class=\"ball\"><geom size=\"0.1\" density=\"500\"/>\
                 </default></default><include file=\"bodies.xml\"/></mujoco>";
    fs::write(folder.join("outer.xml"), outer).unwrap();
    let Said { code, output, errors } = plm_in(&folder, &["import", "outer.xml"], b"");
    assert_eq!(
        (code, errors.as_str()),
        (0, "warning: <key> `up` of <keyframe> is not taken\n --> bodies.xml:2:30\n")
    );
    // 500 kg/m^3 of a ball of 0.1 m.
    assert!(output.contains("mass: 2.09439510239 kg;") && output.contains("centre: (0, -2) m;"), "{output}");

    let link = |name: &str, pose: &str| {
        format!(
            "<link name=\"{name}\"><pose>{pose}</pose><inertial><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.2</iyy><izz>0.3</izz></inertia>\
             </inertial></link>"
        )
    };
    let text = format!(
        "<sdf version=\"1.9\"><world name=\"w\"><model name=\"base\"><static>true</static>{}</model>\
         <model name=\"arm\"><pose>1 0 0 0 0 0</pose><model name=\"tool\"><pose>0 0 -1 0 0.5 0</pose>{}</model></model>\
         <joint name=\"pin\" type=\"revolute\"><parent>base::post</parent><child>arm::tool::tip</child>\
         <axis><xyz expressed_in=\"world\">0 1 0</xyz></axis></joint></world></sdf>",
        link("post", "0 0 0 0 0 0"),
        link("tip", "0.2 0 0 0 0 0")
    );
    let Said { code, output, errors } = plm(&["import", "-"], &text);
    assert_eq!((code, errors.as_str()), (0, ""), "{output}");
    // The inertia about the file's y, and the joint at the place of its child.
    let (sin, cos) = 0.5_f64.sin_cos();
    let place =
        format!("        port pin: ({:.11}, {:.11}) m, axis: -0.5 rad;", 1.0 + 0.2 * cos, -1.0 - 0.2 * sin);
    assert!(output.contains("gravity: 9.8 m/s^2;") && output.contains("inertia: 0.2 kg*m^2;"), "{output}");
    assert!(output.contains(&place), "{place}\n{output}");
}

#[test]
fn a_drawing_becomes_contour_and_holes() {
    let Said { code, output, errors } = import("plate.dxf", &[]);
    assert_eq!((code, errors.as_str()), (0, "warning: TEXT is not taken\n --> plate.dxf:99:1\n"));
    let areas: Vec<f64> = output.split(';').filter(|outline| outline.contains('(')).map(area_of).collect();
    let pi = std::f64::consts::PI;
    let exact = [60.0 * 40.0 + pi * 200.0, 20.0 * 10.0 + pi * 25.0, pi * 64.0];
    assert_eq!(areas.len(), exact.len());
    for (found, exact) in areas.iter().zip(exact) {
        // Of a circle of n corners 1 - 6.6/n^2 of the area is there.
        assert!(*found < exact && *found > exact * (1.0 - 6.6 / 72.0 / 72.0), "{found} for {exact}");
    }
    let body = format!(
        "density: 7850 kg/m^3; thickness: 8 mm; {}",
        output.replace("// From plate.dxf (DXF), by plm import.\n", "")
    );
    let text = format!(
        "pub P {{ ground {{ port o: (0, 0) m; }} body b {{ {body} port o: (60, 20) mm; }} revolute pin(ground.o, b.o); }}"
    );
    assert_eq!(plm(&["check", "-"], &text).errors, "");
    let open = fs::read_to_string(models().join("plate.dxf")).unwrap().replace("0\nARC", "0\nTEXT");
    let folder = folder();
    fs::write(folder.join("open.dxf"), open).unwrap();
    let Said { code, errors, .. } = plm_in(&folder, &["import", "open.dxf"], b"");
    assert!(
        code == 1 && errors.contains("error: the outline is open at (60, 0); the next end is 40 away"),
        "{errors}"
    );
}

/// Texts with damage: each gives a text or an error with a place, and no panic.
#[test]
fn damaged_files_are_refused_or_taken() {
    let mut random = Random::new(1, 0);
    let mut refused = 0;
    for name in MODELS.into_iter().chain(["plate.dxf"]) {
        let whole = fs::read_to_string(models().join(name)).unwrap();
        let words: Vec<&str> = whole.split_inclusive([' ', '\n', '"', '<', '>']).collect();
        for _ in 0..60 {
            let mut damaged = words.clone();
            for _ in 0..=random.below(3) {
                let at = random.below(damaged.len());
                match random.below(5) {
                    0 => damaged.truncate(at.max(1)),
                    1 => damaged[at] = words[random.below(words.len())],
                    2 => damaged[at] = "-1e300 ",
                    3 => damaged[at] = "0 ",
                    _ => drop(damaged.remove(at)),
                }
                if damaged.is_empty() {
                    damaged.push("<");
                }
            }
            let text = damaged.concat();
            let imported = if name == "plate.dxf" {
                plm_import::outline(name, &text, &plm_import::Selection::default())
            } else {
                plm_import::mechanism(name, &text, &Options::default(), &mut |_| Err("no file".to_owned()))
            };
            let is_refused = imported.notices.iter().any(|notice| notice.level == Level::Error);
            assert_eq!(imported.text.is_none(), is_refused, "{text}");
            refused += usize::from(is_refused);
        }
    }
    assert!(refused > 100 && refused < 460, "{refused} of 480 refused");
}

/// The area of an outline by its corners.
fn area_of(outline: &str) -> f64 {
    let points: Vec<[f64; 2]> = outline
        .split('(')
        .filter_map(|part| part.split_once(')'))
        .filter_map(|(pair, _)| pair.split_once(", "))
        .filter_map(|(x, y)| Some([x.parse().ok()?, y.parse().ok()?]))
        .collect();
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}
