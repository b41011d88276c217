//! Recordings of mechanisms: what switches and when, beside closed forms; every row, the fault, and files.
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use std::path::PathBuf;

use plm::runtime::{Moment, Seen};
use plm::view::{Recorder, Recording, Results};
use plm::{Dop853, Rk4, Sim};

plm::mechanism! {
    /// A block that is pushed to the middle, a sledge that is pushed for a time, and a mark that moves.
    pub Relay {
        gravity: 9.81 m/s^2;
        /// When the pulse ends.
        param until: s = 0.7 s;
        param wall: cm = 10 m;
        ground { port o: (0, 0) m; port mark: (0.1 m*sin(2 rad/s*t), 1 m), depth: 5 mm; }
        body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 1 m; }
        body sledge { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
        prismatic rail(ground.o, block.o);
        prismatic other(ground.o, sledge.o);
        force back(block.o) { x: if block.x < 0 m then 4 N else -2 N; }
        force pulse(sledge.o) { x: if t < 0.3 s then 0 N else if t < until then 3 N else 0 N; }
        require near: sledge.x < wall;
        output block.x in mm, block.ax, sledge.ax;
        observe block, rail;
    }
}

/// What a run shows: the rows of a recording with the closed form of the block, `x = 1 - t^2/2` until it passes the middle at
/// sqrt 2, and of the sledge, which 3 N push from 0.3 s to 0.7 s.
fn assert_closed_form(recording: &Recording) {
    let times = recording.times().iter().zip(recording.rows());
    for (k, (&t, row)) in times.enumerate() {
        let middle = 2.0_f64.sqrt();
        let after = (t - middle).max(0.0);
        let x = 1.0 - t * t / 2.0 + 1.5 * after * after;
        assert!((row[0] - 1000.0 * x).abs() < 1e-6, "{t}: {} mm, {x} m", row[0]);
        let [block, sledge] = recording.poses(k) else { unreachable!("two bodies") };
        let (pushed, gone) = ((t.min(0.7) - 0.3).max(0.0), (t - 0.7).max(0.0));
        assert!((sledge[3] - 3.0 * pushed).abs() < 1e-9, "{t}: {sledge:?}");
        assert!((sledge[0] - 1.5 * pushed * pushed - 1.2 * gone).abs() < 1e-9, "{t}: {sledge:?}");
        assert_eq!(block[0] / 0.001, row[0]);
        let [still, mark] = recording.ground(k) else { unreachable!("two ports") };
        assert_eq!(*still, [0.0; 3]);
        assert!((mark[0] - 0.1 * (2.0 * t).sin()).abs() < 1e-15 && mark[1] == 1.0, "{t}: {mark:?}");
    }
}

#[test]
fn what_switches_is_recorded_with_the_rows_before_and_after() {
    let mut sim = Relay::new().start().unwrap();
    let mut recorder = Recorder::new(&sim);
    recorder.run(&mut sim, 2.0, 0.25).unwrap();
    let recording = recorder.into_recording();
    assert_closed_form(&recording);
    // Nine samples, and two rows at each event.
    assert_eq!(recording.len(), 9 + 2 * 3);
    let rows: Vec<&[f64]> = recording.rows().collect();
    let expected = [
        ("pulse", 0.3, [-1.0, 0.0], [-1.0, 3.0]),
        ("pulse", 0.7, [-1.0, 3.0], [-1.0, 0.0]),
        ("back", 2.0_f64.sqrt(), [-1.0, 0.0], [2.0, 0.0]),
    ];
    assert_eq!(recording.about.events.len(), expected.len());
    for (event, (what, time, before, after)) in recording.about.events.iter().zip(expected) {
        assert_eq!(event.what, what);
        assert!((event.time - time).abs() < 1e-9, "{event:?}");
        let row = event.row.unwrap();
        assert_eq!([recording.times()[row - 1], recording.times()[row]], [event.time; 2]);
        assert_eq!((&rows[row - 1][1..], &rows[row][1..]), (&before[..], &after[..]), "{event:?}");
    }
    assert_eq!(recording.about.fault, None);
    assert!(
        recording.about.method.starts_with("Dop853, relative tolerance 1e-"),
        "{}",
        recording.about.method
    );
}

/// To be looked at changes no bit.
#[test]
fn a_run_that_is_recorded_is_the_same_run() {
    fn compare<I: plm::Method<Relay>>(method: impl Fn() -> I) {
        let mut plain = Relay::new().start_with(method()).unwrap();
        let mut samples = Vec::new();
        plain.run(2.0, 0.25, |state| samples.push((state.time(), *state.x()))).unwrap();
        let mut watched = Relay::new().start_with(method()).unwrap();
        let (mut seen, mut switches, mut steps) = (Vec::new(), 0, 0);
        Sim::watch(&mut watched, 2.0, 0.25, |what| match what {
            Seen::Sample(state) => seen.push((state.time(), *state.x())),
            Seen::Condition(..) | Seen::Instant(_) => switches += 1,
            Seen::Step(_) => steps += 1,
            _ => {}
        })
        .unwrap();
        assert_eq!(seen, samples);
        assert_eq!((watched.x(), watched.stats()), (plain.x(), plain.stats()));
        assert_eq!((switches, steps), (watched.stats().switches, watched.stats().steps));
        assert!(switches >= 3, "{switches}");
    }
    compare(Dop853::default);
    compare(|| Rk4::new(1e-3));
    compare(|| plm::RadauIia5::new(1e-9));
}

/// Where it is ended it stands after a whole step, and from there it comes to where it would have come.
#[test]
fn a_run_that_is_ended_on_its_way_goes_on() {
    fn check<I: plm::Method<Relay>>(method: impl Fn() -> I, tolerance: f64) {
        let mut whole = Relay::new().start_with(method()).unwrap();
        whole.step(2.0).unwrap();
        for asked_at in [0.1, 0.3, 0.5, 0.7, 1.0] {
            let mut sim = Relay::new().start_with(method()).unwrap();
            let mut samples = 0;
            let see = |seen: Seen<'_, _>| samples += usize::from(matches!(seen, Seen::Sample(_)));
            Sim::watch_while(&mut sim, 2.0, 0.25, see, |time| time < asked_at).unwrap();
            let ended = sim.state().time();
            assert!(ended >= asked_at && ended < 2.0, "asked at {asked_at}, ended at {ended}");
            assert_eq!(samples, (ended / 0.25) as usize + 1, "{asked_at} {ended}");
            Sim::step_while(&mut sim, 2.0 - ended, |_| true).unwrap();
            assert_eq!(
                (sim.state().time(), sim.stats().switches),
                (2.0, whole.stats().switches),
                "{asked_at}"
            );
            for (own, other) in sim.x().iter().zip(whole.x()) {
                assert!((own - other).abs() < tolerance, "{asked_at}: {own} {other}");
            }
            let mut sim = Relay::new().start_with(method()).unwrap();
            Sim::step_while(&mut sim, 2.0, |time| time < asked_at).unwrap();
            assert!(sim.state().time() >= asked_at && sim.state().time() < 2.0);
        }
    }
    // Dop853 is given 1e-9; the force is piecewise constant, which both methods integrate to rounding beside the events.
    check(Dop853::default, 1e-8);
    check(|| Rk4::new(1e-3), 1e-8);
}

#[test]
fn internal_steps_are_recorded_if_asked() {
    let mut sim = Relay::new().start_with(Rk4::new(0.0625)).unwrap();
    let mut recorder = Recorder::new(&sim).with_steps();
    recorder.run(&mut sim, 0.25, 0.125).unwrap();
    // Samples stand where steps end, and are one row with them.
    assert_eq!(recorder.recording().times(), [0.0, 0.0625, 0.125, 0.1875, 0.25]);
    assert_eq!(recorder.recording().about.method, "Rk4");
    // It goes on where it was: no row is there twice.
    recorder.run(&mut sim, 0.375, 0.125).unwrap();
    let times = recorder.recording().times();
    assert_eq!(times[4..6], [0.25, 0.3], "a step ends where the pulse begins");
}

/// The sledge is at 0.24 m when the pulse ends, at 1.2 m/s.
#[test]
fn what_came_before_a_fault_is_kept_with_the_fault() {
    let mut sim = Relay { wall: 0.84, ..Relay::new() }.start().unwrap();
    let mut recorder = Recorder::new(&sim);
    let fault = recorder.run(&mut sim, 2.0, 0.25).unwrap_err();
    let path = scratch("fault.npz");
    recorder.recording().write(&path).unwrap();
    let run = Results::read(path).unwrap().runs.remove(0);
    assert_closed_form(&run);
    let told = run.about.fault.as_ref().unwrap();
    assert_eq!((told.part.as_str(), told.time), ("near", fault.time));
    assert!((told.time - 1.2).abs() < 1e-9 && (run.times().last().unwrap() - 1.2).abs() < 1e-9, "{told:?}");
    assert_eq!(told.text, "this requirement does not hold any more");
    assert_eq!(run.about.events.len(), 2);
}

fn scratch(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("recorded").join(name)
}

#[test]
fn runs_with_other_parameters_stand_in_one_file() {
    let run = |until: f64| {
        let mut sim = Relay { until, ..Relay::new() }.start().unwrap();
        let mut recorder = Recorder::new(&sim).named(format!("until {until} s"));
        recorder.run(&mut sim, 1.0, 0.5).unwrap();
        recorder.into_recording()
    };
    let path = scratch("two.npz");
    let written: Results = [0.5, 0.7].map(run).into_iter().collect();
    written.write(&path).unwrap();
    let read = Results::read(path).unwrap();
    for (run, until) in read.runs.iter().zip([0.5, 0.7]) {
        let [until_row, wall] = &run.about.mechanism.parameters[..] else { unreachable!("two parameters") };
        assert_eq!(run.about.name, format!("until {until} s"));
        assert_eq!(
            (until_row.quantity.name.as_str(), until_row.default, until_row.value),
            ("until", Some(0.7), until)
        );
        assert_eq!((wall.quantity.unit.as_str(), wall.quantity.factor, wall.value), ("cm", 0.01, 10.0));
        assert_eq!(run.about.events[1].time, until);
    }
    assert_closed_form(&read.runs[1]);
}

#[test]
fn the_file_tells_what_the_mechanism_is() {
    let sim = Relay::new().start().unwrap();
    let mechanism = Recorder::new(&sim).into_recording().about.mechanism;
    assert_eq!((mechanism.name.as_str(), mechanism.bodies.len()), ("Relay", 2));
    assert_eq!((mechanism.bodies[0].mass, mechanism.bodies[1].mass), (2.0, 1.0));
    assert_eq!(
        mechanism.ground.iter().map(|port| (port.moves, port.depth)).collect::<Vec<_>>(),
        [(false, 0.0), (true, 0.005)]
    );
    let rail = &mechanism.parts[0];
    assert_eq!((rail.kind.as_str(), rail.pair.as_deref()), ("prismatic", Some("prismatic")));
    let joined: Vec<_> =
        rail.frames.iter().map(|frame| (frame.argument.as_str(), frame.body, frame.port)).collect();
    assert_eq!(joined, [("a", None, Some(0)), ("b", Some(0), Some(0))]);
    assert_eq!(mechanism.report.degrees_of_freedom, 2);
    assert_eq!(mechanism.report.operations.add, relay::OPERATIONS.add);
}

#[test]
fn quantities_are_chosen_by_name() {
    let mut sim = Relay::new().start().unwrap();
    let mut recorder = Recorder::observing(&sim, ["block.x", "rail.force_on_b.y"]).unwrap();
    recorder.run(&mut sim, 0.5, 0.25).unwrap();
    let recording = recorder.recording();
    let columns: Vec<_> = recording.columns().iter().map(|of| (of.name.as_str(), of.unit.as_str())).collect();
    assert_eq!(columns, [("block.x", "m"), ("rail.force_on_b.y", "N")]);
    let last = recording.rows().last().unwrap();
    // It bears the weight of the block.
    assert!((last[0] - 0.875).abs() < 1e-9 && (last[1] - 2.0 * 9.81).abs() < 1e-9, "{last:?}");
    assert_eq!(Recorder::<Relay>::observing(&sim, ["block.x", "block.z"]).unwrap_err(), "block.z");
}

/// Declared outputs are in their units, with the bits of a recording of outputs alone, and all else is in SI.
#[test]
fn what_is_declared_is_recorded_in_its_unit_beside_all_else() {
    let mut sim = Relay::new().start().unwrap();
    let mut all = Recorder::observing_all(&sim);
    let mut outputs = Recorder::new(&sim);
    let mut own = sim;
    all.run(&mut sim, 0.5, 0.25).unwrap();
    outputs.run(&mut own, 0.5, 0.25).unwrap();
    let (all, outputs) = (all.into_recording(), outputs.into_recording());
    let names: Vec<&str> = all.columns().iter().map(|column| column.name.as_str()).collect();
    assert_eq!(names, relay::State::<f64>::OBSERVED.map(|(name, _)| name));
    let place =
        |of: &Recording, name: &str| of.columns().iter().position(|column| column.name == name).unwrap();
    for (k, column) in outputs.columns().iter().enumerate() {
        let among = place(&all, &column.name);
        assert_eq!(&all.columns()[among], column);
        for (row, all) in outputs.rows().zip(all.rows()) {
            assert_eq!(row[k].to_bits(), all[among].to_bits(), "{column:?}");
        }
    }
    let [x, vx] = ["block.x", "block.vx"].map(|name| &all.columns()[place(&all, name)]);
    assert_eq!((x.unit.as_str(), x.factor), ("mm", Some(0.001)));
    assert_eq!((vx.unit.as_str(), vx.factor), ("m/s", None));
    // x = 1 m - t^2/2.
    let millimetres = all.rows().last().unwrap()[place(&all, "block.x")];
    assert!((millimetres - 875.0).abs() < 1e-6, "{millimetres}");
    let read = Results::from_bytes(&Results::from(all.clone()).to_bytes().unwrap()).0;
    assert_eq!(read.runs[0].columns(), all.columns());
}

#[test]
fn other_scalars_are_recorded_too() {
    let mut sim = Relay::<f32>::of().start_with(Dop853::new(1e-5)).unwrap();
    let mut recorder = Recorder::new(&sim);
    recorder.run(&mut sim, 1.0, 0.5).unwrap();
    assert_eq!(recorder.recording().poses(0)[0][0], 1.0);
    assert!((recorder.recording().rows().last().unwrap()[0] - 500.0).abs() < 0.1);
}
