//! What parameters may be, at the start and while it runs.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

#[macro_use]
#[path = "support/scene.rs"]
mod scene;

use plm::{Cause, Dop853, Fault, Mechanism as _, Rk4, Sim};
use scene::{Given as _, Named as _, Scene};

// Its fields, its start values by type and its dual numbers are what rustc gives: compiled.
mod slider {
    plm::mechanism! {
        pub Slider {
            param m1: kg = 1 kg;
            param i1: kg*m^2 = 1 kg*m^2;
            param grip: N/m = 100 N/m;
            ground { port o: (0, 0) m; }
            body b { mass: m1; inertia: i1; port p: (0, 0) m; start x: 0.1 m, locked; start vx: 7.5 mm/s*(grip/(1 N/m)); }
            prismatic g(ground.o, b.p) { stiffness: grip; }
            require pulls_back: grip > 10 N/m and grip <= 1e6 N/m;
            state filling: m = 10 N/grip;
            rate filling = 0 m/s;
            output b.x, b.vx, filling;
        }
    }
}

#[test]
fn starts_follow_the_parameters_that_they_read() {
    use slider::Slider;
    let start = |mechanism: Slider| {
        let sim = mechanism.start().unwrap();
        [sim.b().vx, sim.filling()]
    };
    assert_eq!(start(Slider::new()), [0.75, 0.1]);
    let stiffer = Slider { grip: 400.0, ..Slider::new() };
    assert_eq!(start(stiffer), [3.0, 0.025]);
    assert_eq!(stiffer.assemble().unwrap().v[0], 3.0);
    // What is set by hand stays.
    let mut thrown = stiffer;
    thrown.start.b.vx.value = 7.0;
    assert_eq!(start(thrown), [7.0, 0.025]);
    thrown.grip = 100.0;
    assert_eq!(start(thrown), [7.0, 0.1]);
    // So does what comes from a run, although it is what the declaration had said.
    let from_a_run = Slider { start: Slider::new().start().unwrap().starts(), ..stiffer };
    assert_eq!(start(from_a_run), [0.75, 0.1]);
    // By number, as other languages set parameters: grip is the third.
    let mut numbered = Slider::new();
    assert!(plm::runtime::described::by_number::set_parameter(&mut numbered, 2, 400.0));
    assert_eq!(start(numbered), [3.0, 0.025]);
    // Derivatives by a parameter go through the starts that read it.
    let grip = plm::Dual::variable(400.0, 0);
    let sim = Slider::<plm::Dual<f64, 1>> { grip, ..Slider::of() }.start().unwrap();
    assert_eq!([sim.b().vx, sim.filling()].map(|number| number.tangents[0]), [0.0075, -10.0 / 160_000.0]);
}

#[test]
fn requirements_of_parameters_are_looked_at_when_they_change() {
    use plm::runtime::system::Events;
    use slider::Slider;
    // They cost a step nothing.
    assert_eq!(Slider::new().guard_count(), 0);
    let unmet = |outcome: Result<(), Fault>| match outcome {
        Err(Fault { part, time, cause: Cause::NotMet { by } }) => (part, time, by),
        other => panic!("{other:?}"),
    };
    for (grip, by) in [(-5.0, 15.0), (9.0, 1.0), (1.5e6, 0.5e6), (f64::INFINITY, f64::INFINITY)] {
        let slider = Slider { grip, ..Slider::new() };
        assert_eq!(unmet(slider.start().map(|_| ())), ("pulls_back", 0.0, by));
        let mut sim = Slider::new().start().unwrap();
        sim.step(0.1).unwrap();
        sim.mechanism.grip = grip;
        assert_eq!(unmet(sim.step(0.1)), ("pulls_back", 0.1, by));
        sim.mechanism.grip = 10.0;
        sim.step(0.1).unwrap();
    }
}

scene! {
    /// Three bars; the second has what the parameters say, the third hangs on a joint that gives way.
    pub Chain {
        gravity: 9.81 m/s^2;
        allow(W0004);
        param m2: kg = 1 kg;
        param i2: kg*m^2 = 0.1 kg*m^2;
        param give: m/N = 1e-6 m/N;
        param lag: s = 1 ms;
        ground { port o: (0, 0) m; }
        body one { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 10 deg, locked; }
        body two { mass: m2; inertia: i2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 1.5 m; }
        body three { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; start x: 2.5 m; }
        revolute first(ground.o, one.a);
        revolute second(one.b, two.a);
        revolute third(two.b, three.a) { compliance: give; relaxation: lag; }
    }
}

scene! {
    /// A chain of which the middle bar may be without mass or without inertia.
    pub Hung {
        gravity: 9.81 m/s^2;
        param m2: kg = 1 kg;
        param i2: kg*m^2 = 0.1 kg*m^2;
        ground { port o: (0, 0) m; }
        body one { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 10 deg, locked; }
        body two { mass: m2; inertia: i2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 1.5 m; }
        body three { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; start x: 2.5 m; }
        revolute first(ground.o, one.a);
        revolute second(one.b, two.a);
        revolute third(two.b, three.a);
    }
}

scene! {
    pub HungAbsolute {
        formulation: absolute;
        param m2: kg = 1 kg;
        ground { port o: (0, 0) m; }
        body one { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 10 deg, locked; }
        body two { mass: m2; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; start x: 1.5 m; }
        revolute first(ground.o, one.a);
        revolute second(one.b, two.a);
    }
}

scene! {
    pub LoopOf {
        param span: m = 2 m;
        param coupler: m = 2 m;
        ground { port a: (0, 0) m; port d: (span, 0 m); }
        body crank  { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.5, 0) m; start angle: 90 deg, locked; start omega: 1 rad/s, locked; }
        body bar    { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (coupler, 0 m); start y: 0.5 m; }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (1, 0) m; start x: 2 m; start angle: 90 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, bar.b);
        revolute c(bar.c, rocker.c);
        revolute d(ground.d, rocker.d);
    }
}

scene! {
    pub LoopAbsolute {
        formulation: absolute;
        param span: m = 2 m;
        param coupler: m = 2 m;
        ground { port a: (0, 0) m; port d: (span, 0 m); }
        body crank  { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.5, 0) m; start angle: 90 deg, locked; start omega: 1 rad/s, locked; }
        body bar    { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (coupler, 0 m); start y: 0.5 m; }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (1, 0) m; start x: 2 m; start angle: 90 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, bar.b);
        revolute c(bar.c, rocker.c);
        revolute d(ground.d, rocker.d);
    }
}

/// The part and words of a fault of a value that is not allowed.
fn refused(outcome: Result<impl Sized, Fault>) -> (&'static str, &'static str) {
    match outcome.err() {
        Some(Fault { part, cause: Cause::NotAllowed { what, .. }, .. }) => (part, what),
        other => panic!("{other:?}"),
    }
}

/// What no mass can be.
const WRONG: [f64; 4] = [-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

#[test]
fn a_mass_that_cannot_be_is_told_at_the_start() {
    use slider::Slider;
    let told = (Slider { m1: -1.0, ..Slider::new() }).start().err().unwrap();
    assert_eq!(told.to_string(), "t = 0 s: b: the mass must be positive and finite, found -1 kg");
    for wrong in WRONG.into_iter().chain([0.0]) {
        let (part, what) = refused((Slider { m1: wrong, ..Slider::new() }).start());
        let expected = if wrong.is_nan() { ("m1", "parameter") } else { ("b", "mass") };
        assert_eq!((part, what), expected, "{wrong}");
        assert_eq!(refused((Slider { m1: wrong, ..Slider::new() }).assemble()), expected, "{wrong}");
    }
}

#[test]
fn a_mass_inside_a_chain_is_told_by_its_body() {
    for wrong in [-1.0, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(refused(Chain::new().with("m2", wrong).start()), ("two", "mass"));
        assert_eq!(refused(Chain::new().with("i2", wrong).start()), ("two", "inertia"));
        assert_eq!(refused(Chain::new().with("give", wrong).start()), ("third", "compliance"));
        assert_eq!(refused(Chain::new().with("lag", wrong).start()), ("third", "relaxation"));
    }
    assert_eq!(refused(Chain::new().with("give", 0.0).start()), ("third", "compliance"));
    // Without relaxation there is no damping in the joint.
    assert!(Chain::new().with("lag", 0.0).start().is_ok());
}

#[test]
fn a_body_without_mass_is_carried_by_others_or_refused() {
    // The tip's weight turns the middle bar; with mass and inertia alike gone it is a link.
    for (m2, i2) in [(1.0, 0.0), (0.0, 0.1), (0.0, 0.0)] {
        let run = |m2: f64, i2: f64| {
            let mut sim = Hung::new().with("m2", m2).with("i2", i2).start_with(Dop853::new(1e-11)).unwrap();
            let energy = sim.kinetic_energy() + sim.gravity_energy();
            sim.step(1.0).unwrap();
            let change = sim.kinetic_energy() + sim.gravity_energy() - energy;
            assert!(change.abs() < 1e-8, "{m2} kg, {i2} kg m^2: {change:e} J");
            sim.state_of("three").angle
        };
        // The limit of small ones is the same motion.
        let (gone, small) = (run(m2, i2), run(m2.max(1e-9), i2.max(1e-9)));
        assert!((gone - small).abs() < 1e-6, "{m2} kg, {i2} kg m^2: {gone} and {small}");
    }
    // What moves alone has to have mass.
    let told = (slider::Slider { m1: 0.0, ..slider::Slider::new() }).start().err().unwrap();
    let expected = "t = 0 s: b: the mass must be positive where no other mass carries it, found 0 kg";
    assert_eq!(told.to_string(), expected);
    // It never turns: any inertia is as good as another.
    assert!((slider::Slider { i1: 0.0, ..slider::Slider::new() }).start().is_ok());
    // Absolute coordinates divide by every mass.
    assert_eq!(refused(HungAbsolute::new().with("m2", 0.0).start()), ("two", "mass"));
}

#[test]
fn a_length_that_is_not_a_number_is_told_at_the_start() {
    let told = LoopOf::new().with("span", f64::NAN).start().err().unwrap();
    assert_eq!(told.to_string(), "t = 0 s: span: the parameter must be a number, found NaN m");
    let told = LoopOf::new().with("span", f64::INFINITY).start().err().unwrap();
    assert_eq!((told.part, told.cause), ("d", Cause::NotFinite), "{told}");
}

#[test]
fn a_parameter_is_looked_at_when_it_is_changed_while_it_runs() {
    let mut sim = slider::Slider::new().start_with(Rk4::new(1e-3)).unwrap();
    sim.step(0.1).unwrap();
    let before = (sim.time(), sim.b());
    for wrong in WRONG {
        sim.mechanism.m1 = wrong;
        for _ in 0..2 {
            let expected = if wrong.is_nan() { "m1" } else { "b" };
            assert_eq!(refused(sim.step(0.1)).0, expected);
            assert_eq!(refused(sim.run(1.0, 0.1, |_| ())).0, expected);
            assert_eq!((sim.time(), sim.b()), before);
        }
    }
    // It goes on when it is mended; with twice the mass, as if it had started here.
    sim.mechanism.m1 = 2.0;
    sim.step(0.1).unwrap();
    assert_eq!(sim.stats().renewed, 1);
    let root = 50.0_f64.sqrt();
    let (x, v) = (before.1.x, before.1.vx);
    let expected = x * (root * 0.1).cos() + v / root * (root * 0.1).sin();
    assert!((sim.b().x - expected).abs() < 1e-9, "{} {expected}", sim.b().x);
}

/// How far the joints of a loop of some lengths are open.
fn gap(sim: &Sim<Scene>, span: f64, coupler: f64) -> f64 {
    let [bar, rocker, crank] = ["bar", "rocker", "crank"].map(|body| sim.state_of(body));
    let tip = (bar.x + coupler * bar.angle.cos(), bar.y + coupler * bar.angle.sin());
    let end = (rocker.x + rocker.angle.cos(), rocker.y + rocker.angle.sin());
    let knee = (crank.x + 0.5 * crank.angle.cos(), crank.y + 0.5 * crank.angle.sin());
    (tip.0 - end.0).hypot(tip.1 - end.1)
        + (bar.x - knee.0).hypot(bar.y - knee.1)
        + (rocker.x - span).hypot(rocker.y)
}

/// Changes lengths of a loop in a run: those that it can have close it, the others end the run.
fn changes_lengths(mechanism: &Scene) {
    let mut sim = mechanism.start_with(Dop853::new(1e-10)).unwrap();
    sim.step(0.3).unwrap();
    for (span, coupler) in [(2.1, 2.0), (2.1, 2.2), (1.9, 1.7), (2.0, 2.0)] {
        sim.set_parameter("span", span);
        sim.set_parameter("coupler", coupler);
        sim.step(0.05).unwrap();
        let gap = gap(&sim, span, coupler);
        assert!(gap < 1e-8, "{span}, {coupler}: {gap:e}");
    }
    assert_eq!(sim.stats().renewed, 4);
    let saved = sim.save();
    // Crank, coupler and rocker together do not reach that far.
    sim.set_parameter("span", 5.0);
    assert!(sim.drift().phi > 0.1, "{:?}", sim.drift());
    for _ in 0..2 {
        let told = sim.step(0.05).unwrap_err();
        assert!(matches!(told.cause, Cause::Open { gap } if gap > 0.1), "{told}");
    }
    // As it was it goes on to the bit.
    sim.set_parameter("span", 2.0);
    sim.step(0.05).unwrap();
    let mended = sim.state_of("rocker");
    sim.resume(&saved);
    sim.step(0.05).unwrap();
    let off = (mended.angle - sim.state_of("rocker").angle).abs();
    assert!(off < 1e-12, "{off:e}");
}

#[test]
fn a_loop_in_closed_form_is_assembled_anew_by_new_lengths() {
    changes_lengths(&LoopOf::new());
}

#[test]
fn a_loop_in_absolute_coordinates_is_assembled_anew_by_new_lengths() {
    changes_lengths(&LoopAbsolute::new());
}

#[test]
fn an_input_alone_assembles_nothing() {
    let mut sim = Chain::new().start().unwrap();
    sim.set_parameter("m2", 1.0);
    sim.step(0.01).unwrap();
    assert_eq!(sim.stats().renewed, 0);
}

scene! {
    /// A four-bar of any size, which the default says nothing of.
    pub AnySize {
        param size: m = 1 m;
        ground { port a: (0, 0) m; port d: (2*size, 0 m); }
        body crank  { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.5*size, 0 m); start angle: 80 deg, locked; start omega: 1 rad/s, locked; }
        body bar    { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (2*size, 0 m); }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (size, 0 m); start angle: 90 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, bar.b);
        revolute c(bar.c, rocker.c);
        revolute d(ground.d, rocker.d);
    }
}

scene! {
    pub Huge {
        ground { port a: (0, 0) m; port d: (2e9, 0) m; }
        body crank  { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.5e9, 0) m; start angle: 80 deg, locked; start omega: 1 rad/s, locked; }
        body bar    { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (2e9, 0) m; start x: 0.1e9 m; start y: 0.5e9 m; }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (1e9, 0) m; start x: 2e9 m; start angle: 90 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, bar.b);
        revolute c(bar.c, rocker.c);
        revolute d(ground.d, rocker.d);
    }
}

#[test]
fn gaps_are_measured_by_the_size_of_the_scene() {
    // Of the same loop in other units of length the angles and their rates are the same.
    let loop_of = |size: f64| {
        let mechanism = AnySize::new()
            .with("size", size)
            .with_start("bar.x", 0.1 * size)
            .with_start("bar.y", 0.5 * size)
            .with_start("rocker.x", 2.0 * size);
        let found = mechanism.assemble().unwrap();
        (found.q, found.v)
    };
    let (q, v) = loop_of(1.0);
    for size in [1e-9, 1e-6, 1e6, 1e9] {
        let (other, speed) = loop_of(size);
        for k in 0..9 {
            let unit = if k % 3 == 2 { 1.0 } else { size };
            // Assembly ends at rounding; the steps before that have weights that are none in other units.
            assert!((other[k] / unit - q[k]).abs() < 1e-6, "{size:e}: {k}: {} {}", other[k] / unit, q[k]);
            assert!((speed[k] / unit - v[k]).abs() < 1e-6, "{size:e}: {k}: {} {}", speed[k] / unit, v[k]);
        }
    }
    let mut sim = Huge::new().start().unwrap();
    sim.step(1.0).unwrap();
    assert!(sim.drift().phi < 1e-10 * 2e9, "{:?}", sim.drift());
}
