//! A mechanism that is run from outside, by number.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use plm::Described;
use plm::dynamic::{Compiled, Small};
use plm::live::{Live, with_pulls};
use plm::runtime::{Ports, Statics};

plm::mechanism! {
    /// A four-bar with a parameter and an input, and what `with_pulls` adds to its declaration.
    FourBar {
        gravity: 9.81 m/s^2;
        param reach: m = 0.9 m;
        input torque: N*m = 0;
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0, 0) m; port b: (0.3, 0) m; start angle: 60 deg, locked; }
        body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (0, 0) m; port c: (reach, 0); centre: (0.4, 0.1) m; }
        body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (0.4, 0) m; port p: (-0.4, 0) m; start angle: 100 deg; }
        revolute o(ground.o, crank.a) { drive: torque; }
        revolute b(crank.b, coupler.b) { pin_diameter: reach/8; }
        revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
        revolute p(ground.p, rocker.p);
        part plm_pull(a: body) { input x: N = 0; input y: N = 0; input turn: N*m = 0; force on a: (x, y); torque on a: turn; }
        input plm_pull_0_x: N = 0; input plm_pull_0_y: N = 0; input plm_pull_0_turn: N*m = 0;
        plm_pull plm_pull_0(crank) { x: plm_pull_0_x; y: plm_pull_0_y; turn: plm_pull_0_turn; }
        output crank.angle in deg;
    }
}

fn angle(live: &mut Live<FourBar>, body: usize) -> f64 {
    live.read()[1 + 6 * body + 2]
}

#[test]
fn it_runs_as_a_simulation_does() {
    let mut live = Live::new(FourBar::new());
    let mut sim = FourBar::new().start().unwrap();
    for _ in 0..50 {
        assert!(live.step(0.01));
        sim.step(0.01).unwrap();
    }
    assert_eq!(live.read()[0].to_bits(), sim.time().to_bits());
    assert_eq!(angle(&mut live, 0).to_bits(), sim.crank().angle.to_bits());
    let length = 1 + 6 * 3 + 3 * 2 + <FourBar>::OBSERVED.len();
    assert_eq!(live.read().len(), length);
}

/// What a picture needs follows the parameters.
#[test]
fn its_shape_has_the_parameters_of_now() {
    let mut live = Live::new(FourBar::new());
    let declared = live.shape().to_vec();
    // Mass, inertia, depth, two ports, no contour.
    let of_body = 3 + 2 * 3 + 1;
    assert_eq!(declared.len(), 3 * of_body + 2 * 4 + 4);
    // The crank's ports are given from its centre of gravity, which is at its first one.
    assert_eq!(declared[..of_body], [1.0, 0.02, 0.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.0]);
    // The coupler's centre of gravity stands at (0.4, 0.1).
    let end = of_body + 3 + 3;
    assert_eq!([declared[end], declared[end + 1]], [0.9 - 0.4, -0.1]);
    assert_eq!(declared[3 * of_body + 4..][..4], [1.0, 0.0, 0.0, 0.0]);
    // The four pins; one of them is an eighth of the parameter.
    assert_eq!(live.size_names(), "o pin_diameter\nb pin_diameter\nc pin_diameter\np pin_diameter");
    assert_eq!(declared[3 * of_body + 8..], [0.0, 0.9 / 8.0, 0.0, 0.0]);
    live.set_parameter(0, 0.95);
    assert_eq!(live.shape()[end], 0.95 - 0.4);
    assert_eq!(live.shape()[3 * of_body + 9], 0.95 / 8.0);
}

/// The work of the pull at the end of the crank stands in the energy.
#[test]
fn a_pull_acts_where_it_is_applied() {
    let mut live = Live::new(FourBar::new());
    let mut sim = FourBar::new().start().unwrap();
    let (x, y) = {
        let n = live.read();
        (n[1] + 0.3 * n[3].cos(), n[2] + 0.3 * n[3].sin())
    };
    live.pull(0, [x, y], [0.0, 40.0]);
    assert!(live.step(1e-3));
    // The same as a torque about the fixed pivot, to the first order of the step.
    sim.input.torque = 0.3 * sim.crank().angle.cos() * 40.0;
    sim.step(1e-3).unwrap();
    let (pulled, driven) = (live.read()[1 + 5], sim.crank().omega);
    assert!((pulled - driven).abs() < 1e-3 * driven.abs() && driven > 0.0, "{pulled} {driven}");
}

/// Outputs are read in the units that they ask for, as a page shows them; all else in SI.
#[test]
fn an_output_is_read_in_its_unit() {
    let mut live = Live::new(FourBar::new());
    let mut sim = FourBar::new().start().unwrap();
    assert!(live.step(0.1));
    sim.step(0.1).unwrap();
    let (mut degrees, numbers) = (Vec::new(), live.read().to_vec());
    FourBar::outputs(sim.state(), &mut |output| degrees.push(output));
    let first = 1 + 6 * 3 + 3 * 2;
    for (k, (name, _)) in <FourBar>::OBSERVED.iter().enumerate() {
        let expected =
            if *name == "crank.angle" { degrees[0] } else { FourBar::observed(sim.state(), k).unwrap() };
        assert_eq!(numbers[first + k].to_bits(), expected.to_bits(), "{name}");
    }
    assert!((degrees[0].to_radians() - sim.crank().angle).abs() < 1e-15);
}

#[test]
fn what_cannot_be_assembled_says_which_joint_stays_open_and_is_mended() {
    let mut live = Live::new(FourBar::new());
    live.set_parameter(0, 3.0);
    assert!(!live.restart());
    let error = live.error().unwrap().clone();
    assert!(!error.part.is_empty() && !error.text.is_empty(), "{error:?}");
    assert!(!live.step(0.1));
    assert_eq!(live.read().len(), 1 + 18 + 6 + <FourBar>::OBSERVED.len());
    live.set_parameter(0, 0.8);
    assert!(live.restart() && live.error().is_none());
    assert!(live.step(0.1));
    assert_eq!(live.parameter(0), 0.8);
    assert!(live.reset());
    assert_eq!(live.parameter(0), 0.9);
}

/// A parameter that is turned while it runs: the joints close anew.
#[test]
fn a_parameter_is_turned_while_it_runs() {
    let mut live = Live::new(FourBar::new());
    assert!(live.step(0.2));
    live.set_parameter(0, 0.85);
    assert!(live.step(0.01), "{:?}", live.error());
    let n = live.read().to_vec();
    let (cx, cy, ca) = (n[7], n[8], n[9]);
    // From G of the coupler, (0.4, 0.1) from its first pivot, to the second, and from the rocker's G.
    let [dx, dy] = [0.85 - 0.4, -0.1];
    let c = [cx + dx * ca.cos() - dy * ca.sin(), cy + dx * ca.sin() + dy * ca.cos()];
    let r = [n[13] + 0.4 * n[15].cos(), n[14] + 0.4 * n[15].sin()];
    assert!((c[0] - r[0]).abs() < 1e-9 && (c[1] - r[1]).abs() < 1e-9, "{c:?} {r:?}");
}

#[test]
fn a_body_is_placed_by_hand_and_the_joints_close() {
    let mut live = Live::new(FourBar::new());
    let n = live.read().to_vec();
    let before = n[3];
    assert!(live.place(0, [n[1], n[2], before + 0.3]));
    let after = angle(&mut live, 0);
    assert!((0.1..0.4).contains(&(after - before)), "{before} {after}");
    assert_eq!(live.read()[0], 0.0);
    // The coupler's G is off its origin: placed where it is, nothing moves.
    let n = live.read().to_vec();
    assert!(live.place(1, [n[7], n[8], n[9]]));
    let gap = n[1..19].iter().zip(&live.read()[1..19]).fold(0.0_f64, |gap, (a, b)| gap.max((a - b).abs()));
    assert!(gap < 1e-9, "{gap:e}");
    // Far out nothing closes; all stays as it was.
    assert!(!live.place(1, [1e3, 1e3, 0.0]) || live.error().is_none());
}

#[test]
fn a_declaration_gets_its_pulls() {
    let text = with_pulls("pub A { body b { mass: 1 kg; } }\n", &["b"]);
    assert!(text.contains("plm_pull plm_pull_0(b)") && text.trim_end().ends_with('}'));
    assert!(<FourBar>::DECLARATION.contains("body crank"), "{}", <FourBar>::DECLARATION);
}

plm::mechanism! {
    /// A mass that starts where a parameter says.
    Placed {
        param place: mm = 100 mm;
        param pressed: N = place*2 N/m;
        ground { port o: (0, 0) m; }
        body mass { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; start x: place, locked; }
        prismatic rail(mass.a, ground.o) { stiffness: 200 N/m; }
        state force: N = pressed + place*1 N/m;
        rate force = 0 N/s;
        output mass.x, force;
    }
}

#[test]
fn starts_that_are_made_of_a_parameter_follow_it() {
    let mut live = Live::new(Placed::new());
    let force = <Placed>::OBSERVED.iter().position(|(name, _)| *name == "force").unwrap();
    let started = |live: &mut Live<Placed>| {
        assert!(live.restart());
        let numbers = live.read();
        [numbers[1], numbers[1 + 6 + 3 + force]]
    };
    live.set_parameter(0, 0.12);
    // The other parameter is a value of its own.
    let [place, force] = started(&mut live);
    assert!(place == 0.12 && (force - (0.2 + 0.12)).abs() < 1e-15, "{place} {force}");
    // What was placed by hand stays there.
    assert!(live.place(0, [0.3, 0.0, 0.0]));
    live.set_parameter(0, 0.15);
    let [place, force] = started(&mut live);
    assert!((place - 0.3).abs() < 1e-12 && (force - 0.35).abs() < 1e-15, "{place} {force}");
}

plm::mechanism! {
    /// A block on a rough floor, and what `with_pulls` adds to its declaration.
    Block {
        gravity: 9.81 m/s^2;
        param mu = 0.3;
        ground { port o: (0, 0) m; }
        body block { mass: 10 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
        constraint level: block.angle = 0;
        unilateral floor: block.y >= 0 m { restitution: 0.5; }
        friction slip: rate(block.x) within mu*reaction(floor);
        part plm_pull(a: body) { input x: N = 0; input y: N = 0; input turn: N*m = 0; force on a: (x, y); torque on a: turn; }
        input plm_pull_0_x: N = 0; input plm_pull_0_y: N = 0; input plm_pull_0_turn: N*m = 0;
        plm_pull plm_pull_0(block) { x: plm_pull_0_x; y: plm_pull_0_y; turn: plm_pull_0_turn; }
        output push = reaction(floor), drag = reaction(slip);
    }
}

/// x, y, vx, vy.
fn motion(live: &mut Live<Block>) -> [f64; 4] {
    [1, 2, 4, 5].map(|k| live.read()[k])
}

/// 29 N of 29.43 N do not move it; 30 N do, and so do 29 N where the coefficient is turned down; it stops where it is let go.
#[test]
fn a_pull_moves_what_sticks_above_its_bound_alone() {
    let mut live = Live::new(Block::new());
    live.pull(0, [0.0, 0.0], [29.0, 0.0]);
    for _ in 0..100 {
        assert!(live.step(0.01));
    }
    assert_eq!(motion(&mut live), [0.0; 4]);
    assert_eq!(live.contacts(), "closed\tfloor\nsticks\tslip");
    live.pull(0, [0.0, 0.0], [30.0, 0.0]);
    assert!(live.step(2.0));
    assert_eq!(live.contacts(), "closed\tfloor\nslips forwards\tslip");
    let [x, _, vx, _] = motion(&mut live);
    assert!((x - 0.5 * 0.057 * 4.0).abs() < 1e-12 && (vx - 0.114).abs() < 1e-12, "{x} {vx}");
    live.pull(0, [x, 0.0], [0.0, 0.0]);
    assert!(live.step(1.0));
    let [rests, _, vx, _] = motion(&mut live);
    assert!((rests - x - 0.114 * 0.114 / 2.0 / 2.943).abs() < 1e-9 && vx == 0.0, "{rests} {vx}");
    live.pull(0, [rests, 0.0], [29.0, 0.0]);
    assert!(live.step(1.0));
    assert_eq!(motion(&mut live)[0], rests);
    live.set_parameter(0, 0.2);
    assert!(live.error().is_none() && live.step(1.0));
    assert!((motion(&mut live)[2] - (2.9 - 1.962)).abs() < 1e-12);
    assert!(live.reset() && live.step(0.1));
    assert_eq!(motion(&mut live), [0.0; 4]);
}

/// Lifted by hand it falls and bounces between the pictures of a page; put below the floor it is told so, and stays where it was.
#[test]
fn what_is_placed_in_the_air_bounces() {
    let mut live = Live::new(Block::new());
    assert!(live.place(0, [0.3, 1.0, 0.0]), "{:?}", live.error());
    assert_eq!(live.contacts(), "open\tfloor\nunloaded\tslip");
    let (mut heights, mut turns) = (Vec::new(), 0);
    for _ in 0..240 {
        assert!(live.step(1.0 / 60.0));
        heights.push(motion(&mut live)[1]);
    }
    for three in heights.windows(3) {
        turns += u32::from(three[1] > three[0] && three[1] >= three[2]);
    }
    // Apexes of a quarter, a sixteenth, … of the height; from the fifth on, of a millimetre, they are shorter than a picture.
    assert!((3..=6).contains(&turns), "{heights:?}");
    let highest = heights[30..].iter().copied().fold(0.0, f64::max);
    assert!((highest - 0.25).abs() < 1e-3 && heights.iter().all(|height| *height > -1e-12), "{highest}");
    assert_eq!(motion(&mut live)[3], 0.0);
    let before = motion(&mut live);
    assert!(!live.place(0, [0.3, -0.1, 0.0]));
    let error = live.error().unwrap().clone();
    assert!(error.part == "floor" && error.text.contains("gap is negative"), "{error:?}");
    assert_eq!(motion(&mut live), before);
    assert!(live.step(0.1) && live.error().is_none());
}

/// Everything that a page does with a mechanism, and the bits of all that it shows.
fn handled<M: Described<S = f64> + Statics>(mechanism: M) -> Vec<String> {
    let (mut live, mut seen) = (Live::new(mechanism), Vec::new());
    let mut see = |live: &mut Live<M>, done: bool| {
        let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
        let (shape, moment) = (bits(live.shape()), bits(live.read()));
        let error = live.error().map(|error| format!("{} {}: {}", error.time, error.part, error.text));
        seen.push(format!("{done} {shape:?} {moment:?} {error:?}"));
    };
    let (reach, torque) = (live.parameter_named("reach").unwrap(), live.input_named("torque").unwrap());
    let crank = live.body_named("crank").unwrap();
    for k in 0..60 {
        match k {
            10 => live.set_parameter(reach, 0.95),
            20 => live.set_input(torque, 2.0),
            30 => live.pull(crank, [0.1, 0.2], [3.0, -1.0]),
            // No four-bar closes with it: nothing moves until it is taken back.
            40 => live.set_parameter(reach, 9.0),
            43 => live.set_parameter(reach, 0.9),
            _ => {}
        }
        let done = live.step(0.01);
        see(&mut live, done);
    }
    let again: [fn(&mut Live<M>) -> bool; 3] =
        [|live| live.place(0, [0.1, 0.2, 1.3]), |live| live.restart(), |live| live.reset()];
    for begin in again {
        let done = begin(&mut live);
        see(&mut live, done);
        let done = live.step(0.02);
        see(&mut live, done);
    }
    assert_eq!(live.parameter_named("Reach"), None);
    seen
}

/// A mechanism from text in the hands of a page, beside the compiled one: the same bits.
#[test]
fn a_mechanism_from_text_is_handled_as_a_compiled_one() {
    let text: Small = Compiled::new("four-bar", FourBar::<f64>::DECLARATION).unwrap().mechanism().unwrap();
    let (found, expected) = (handled(text), handled(FourBar::new()));
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!(found, expected);
    }
    assert_eq!(found.len(), expected.len());
    assert!(
        expected.iter().any(|seen| seen.starts_with("false")) && expected.last().unwrap().starts_with("true")
    );
}

/// Pulls that are added to a text move its bodies, as those of a declaration do.
#[test]
fn a_mechanism_from_text_is_pulled() {
    let bare = "pub Sled {
        ground { port o: (0, 0) m; }
        body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
        prismatic rail(ground.o, block.o);
    }";
    let text: Small = Compiled::new("sled", &with_pulls(bare, &["block"])).unwrap().mechanism().unwrap();
    let mut live = Live::new(text);
    let block = live.body_named("block").unwrap();
    live.pull(block, [0.0, 0.0], [3.0, 0.0]);
    assert!(live.step(0.5));
    // x = F t^2/(2 m).
    assert!((live.read()[1] - 3.0 * 0.25 / 4.0).abs() < 1e-9);
}
