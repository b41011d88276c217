//! What a package of Python has of a run, without Python: bytes by every method, the state, its rates and their derivatives.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use plm::foreign::{Foreign, Kind, Status};
use plm::python::{Asked, Run, Runnable, Running, method};
use plm::runtime::contact::Mode;
use plm::{Cause, Described, Fault};

plm::mechanism! {
    /// A loop no link of which goes round, so that each chart is flat somewhere; with a first-order state.
    Rocker {
        gravity: 9.81 m/s^2;
        param load: kg = 1 kg;
        input drive: N*m = 1 N*m;
        state lag: N*m = 0;
        rate lag = (drive - lag)/0.2 s;
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (-0.4, 0) m; port a: (0.4, 0) m; start angle: 60 deg, locked; start omega: 3 rad/s; }
        body coupler { mass: load; inertia: 0.1 kg*m^2; port a: (-0.3, 0) m; port b: (0.3, 0) m; start angle: -10 deg; }
        body rocker { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.35, 0) m; port b: (0.35, 0) m; start angle: 95 deg; }
        revolute a0(ground.o, crank.o) { drive: lag; }
        revolute a(crank.a, coupler.a);
        revolute b(coupler.b, rocker.b);
        revolute b0(ground.p, rocker.p) { damping: 0.1 N*m*s/rad; }
        output crank.angle, rocker.angle;
    }
}

plm::mechanism! {
    /// Known times, a condition that switches, and what is stiff; derivatives are sparse.
    Hopper {
        gravity: 9.81 m/s^2;
        param stiff: N/m = 5000 N/m;
        input push: N = 0 N;
        state valve: N = 0;
        rate valve = (push - valve)/1 ms;
        ground { port o: (0, 0) m, axis: 90 deg; }
        body ball { mass: 1 kg; inertia: 0.01 kg*m^2; port c: (0, 0) m; start y: 0.5 m, locked; }
        prismatic guide(ground.o, ball.c);
        force floor(ball.c) { y: if ball.y < 0.1 m then stiff*(0.1 m - ball.y) - 2 N*s/m*ball.vy else valve; }
        force kick(ball.c) { y: if t > 0.37 s then 2 N else 0 N; }
        output ball.y, ball.vy;
    }
}

plm::mechanism! {
    /// Absolute coordinates, which drift.
    Swing {
        formulation: absolute;
        gravity: 9.81 m/s^2;
        param load: kg = 2 kg;
        input drive: N*m = 0;
        ground { port o: (0, 0) m; }
        body arm { mass: load; inertia: 0.1 kg*m^2; port o: (0, 0.5) m; port a: (0, -0.5) m; start angle: 40 deg, locked; }
        body bob { mass: 1 kg; inertia: 0.05 kg*m^2; port a: (0, 0.3) m; start angle: -20 deg, locked; }
        revolute shoulder(ground.o, arm.o) { drive: drive; }
        revolute elbow(arm.a, bob.a);
        output arm.angle, bob.angle;
    }
}

plm::mechanism! {
    /// A block that is thrown on a rough floor, bounces, slides to and fro on a spring, and sticks.
    Thrown {
        gravity: 9.81 m/s^2;
        param stiff: N/m = 20 N/m;
        input pull: N = 0 N;
        ground { port o: (0, 0) m; }
        body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start y: 0.2 m; start vx: 1 m/s; }
        constraint level: block.angle = 0;
        force hand(block.o) { x: pull - stiff*block.x; }
        unilateral floor: block.y >= 0 m { restitution: 0.4; }
        friction slip: rate(block.x) within 0.3*reaction(floor) { static: 0.4*reaction(floor); }
        output block.x, block.y, push = reaction(floor);
    }
}

const METHODS: [(&str, Option<f64>); 10] = [
    ("dop853", None),
    ("vern9", None),
    ("adams", None),
    ("dopri5", None),
    ("radauiia5", None),
    ("rk4", Some(2e-3)),
    ("semiimpliciteuler", Some(2e-3)),
    ("gauss2", Some(2e-3)),
    ("gauss3", Some(2e-3)),
    ("ros34pw2", Some(2e-3)),
];

fn start<M: Runnable>(declared: M, (name, step): (&str, Option<f64>)) -> Run<M> {
    Run::start(declared, method(name, None, step).unwrap(), (&[], &[]), 0.0).unwrap()
}

/// At every tenth step the run is saved, and what was saved, read into a run by another method, is stepped beside it from there on.
fn goes_on<M: Runnable + Foreign>(declared: M) {
    for by in METHODS {
        let (mut run, mut copy) = (start(declared, by), start(declared, METHODS[0]));
        for k in 0..120 {
            if k % 10 == 0 {
                let bytes = run.save().unwrap();
                copy = if k % 20 == 0 { copy.like(&bytes) } else { Run::saved(declared, &bytes) }.unwrap();
            }
            for each in [&mut run, &mut copy] {
                match k {
                    35 => each.set(Kind::Input, 0, -2.0).unwrap(),
                    75 => {
                        let value = each.get(Kind::Parameter, 0).unwrap();
                        each.set(Kind::Parameter, 0, 1.5 * value).unwrap();
                    }
                    _ => {}
                }
                each.step(0.013, &mut |_| true).unwrap();
            }
            assert!(run.save().unwrap() == copy.save().unwrap(), "{} by {}, step {k}", M::TABLES.name, by.0);
        }
    }
}

#[test]
fn a_saved_run_goes_on_to_the_bit_by_every_method() {
    goes_on(Rocker::new());
    goes_on(Hopper::new());
    goes_on(Swing::new());
    goes_on(Thrown::new());
}

/// What a row does is a number, and a start below the floor is told in words.
#[test]
fn rows_of_contact_are_read_by_number() {
    let mut run = start(Thrown::new(), METHODS[0]);
    let rows = |run: &mut Run<Thrown>| [0, 1].map(|row| run.get(Kind::Contact, row).unwrap());
    let numbers = |modes: [Mode; 2]| modes.map(|mode| mode.number() as f64);
    assert_eq!(rows(&mut run), numbers([Mode::Open, Mode::Off]));
    run.step(0.9, &mut |_| true).unwrap();
    assert_eq!(rows(&mut run), numbers([Mode::Closed, Mode::Sticks]));
    run.set(Kind::Input, 0, 14.0).unwrap();
    run.step(0.1, &mut |_| true).unwrap();
    assert_eq!(rows(&mut run), numbers([Mode::Closed, Mode::Forwards]));
    assert_eq!(run.get(Kind::Contact, 2).unwrap_err().status(), Status::NoSuch);

    let trouble = Run::start(Thrown::new(), method("dop853", None, None).unwrap(), (&[], &[(1, -0.01)]), 0.0);
    let Err(plm::foreign::Error::Fault(fault)) = trouble else { panic!("it starts below the floor") };
    assert_eq!((fault.part, fault.cause), ("floor", Cause::Sunk { by: 0.01 }));
    assert!(plm::python::words(&fault).contains("floor"));
}

#[test]
fn bytes_of_another_use_or_mechanism_are_refused() {
    let run = start(Hopper::new(), METHODS[0]);
    let bytes = run.save().unwrap();
    let status = |bytes: &[u8]| run.like(bytes).err().map(|trouble| trouble.status());
    assert_eq!(status(&bytes), None);
    assert_eq!(status(&bytes[1..]), Some(Status::Damaged));
    assert_eq!(status(&start(Swing::new(), METHODS[0]).save().unwrap()), Some(Status::OtherMechanism));
    let mut object = plm::foreign::Object::new(Hopper::new());
    object.start().unwrap();
    let mut of_c = vec![0; object.saved_size()];
    object.save(&mut of_c).unwrap();
    assert!(matches!(status(&of_c), Some(Status::Damaged | Status::OtherMechanism)));
}

/// Names of a loop's coordinate follow its chart.
#[test]
fn a_coordinate_has_the_name_that_it_has_in_its_chart() {
    let mut run = start(Rocker::new(), METHODS[0]);
    let mut seen = Vec::new();
    for _ in 0..200 {
        run.step(0.01, &mut |_| true).unwrap();
        let (names, state) = (run.state_names(), run.state().unwrap());
        let body = ["crank", "coupler", "rocker"].iter().position(|body| names[0] == format!("{body}.angle"));
        let pose = run.pose(body.unwrap()).unwrap();
        let turns = (state[0] - pose[2]) / std::f64::consts::TAU;
        assert!((turns - turns.round()).abs() < 1e-9, "{names:?}: {turns}");
        assert!((state[1] - pose[5]).abs() < 1e-9 && names[2] == "lag", "{names:?}");
        if !seen.contains(&names[0]) {
            seen.push(names[0]);
        }
    }
    assert!(seen.len() > 1, "{seen:?}");
}

/// Rates are what the state does, by a difference quotient of order 4 of a run; derivatives what they do.
fn rates_are_those_of_a_run<M: Runnable>(declared: M, tolerance: f64) {
    let mut run = start(declared, METHODS[0]);
    run.step(0.05, &mut |_| true).unwrap();
    let mut now = run.clone();
    let at = |h: f64| {
        let mut ahead = run.clone();
        ahead.step(h, &mut |_| true).unwrap();
        ahead.state().unwrap()
    };
    // Forward differences: f' = (-25 f0 + 48 f1 - 36 f2 + 16 f3 - 3 f4) / 12 h.
    let h = 1e-3;
    let values: Vec<Vec<f64>> =
        (0..5).map(|k| if k == 0 { now.state().unwrap() } else { at(h * f64::from(k)) }).collect();
    for (i, rate) in now.rates().unwrap().iter().enumerate() {
        let sum: f64 = [-25.0, 48.0, -36.0, 16.0, -3.0].iter().zip(&values).map(|(c, x)| c * x[i]).sum();
        let found = sum / (12.0 * h);
        assert!(
            (found - rate).abs() < tolerance * (1.0 + rate.abs()),
            "{} {i}: {rate} {found}",
            M::TABLES.name
        );
    }
}

#[test]
fn rates_are_what_a_run_does() {
    // The error is h^4 / 5 of a fifth derivative: 1e-12 times powers of rates of some 10/s.
    rates_are_those_of_a_run(Rocker::new(), 1e-6);
    rates_are_those_of_a_run(Swing::new(), 1e-6);
}

/// Of a mechanism without constraints on its state, states are set to the bit, and derivatives are difference quotients of rates.
#[test]
fn derivatives_are_difference_quotients_of_rates() {
    let mut run = start(Rocker::new(), METHODS[0]);
    run.step(0.05, &mut |_| true).unwrap();
    let (state, names, [a, b, c, _]) = (run.state().unwrap(), run.state_names(), run.jacobian().unwrap());
    assert_eq!((a.shape(), b.shape(), c.shape()), ((3, 3), (3, 1), (2, 3)));
    // Of order 4, with an error of some 1e-12 and rounding of 1e-16 / h.
    let h = 1e-3;
    for j in 0..4 {
        let at = |by: f64| {
            let mut other = run.clone();
            let mut x = state.clone();
            if let Some(x) = x.get_mut(j) {
                *x += by;
            } else {
                other.set(Kind::Input, 0, 1.0 + by).unwrap();
            }
            other.set_state(&x).unwrap();
            assert_eq!(other.state_names(), names);
            other.rates().unwrap()
        };
        let (near, far) = ([at(h), at(-h)], [at(2.0 * h), at(-2.0 * h)]);
        for i in 0..3 {
            let found = (8.0 * (near[0][i] - near[1][i]) - (far[0][i] - far[1][i])) / (12.0 * h);
            let known = if j < 3 { a[(i, j)] } else { b[(i, 0)] };
            assert!((found - known).abs() < 1e-6 * (1.0 + known.abs()), "{i}, {j}: {known} {found}");
        }
    }
}

#[test]
fn a_state_that_is_set_is_where_a_run_goes_on_from() {
    // A tree: to the bit, and the same motion as from start values.
    let mut run = start(Hopper::new(), METHODS[0]);
    run.set_state(&[0.3, -1.0, 0.5]).unwrap();
    assert_eq!(run.state().unwrap(), [0.3, -1.0, 0.5]);
    assert_eq!(run.state_names(), ["guide.displacement", "guide.speed", "valve"]);
    run.set(Kind::State, 0, -0.25).unwrap();
    assert_eq!(run.state().unwrap(), [0.3, -1.0, -0.25]);
    assert_eq!(run.set_state(&[0.3, f64::NAN, 0.5]).unwrap_err().cause, Cause::NotFinite);
    assert_eq!(run.set_state(&[0.3]).unwrap_err().cause, Cause::NotFinite);
    assert_eq!(run.state().unwrap(), [0.3, -1.0, -0.25]);
    // Conditions are on the side that belongs to it: in the floor of 5 kN/m a spring of 0.05 m acts, and a damper of 2 N s/m.
    run.set_state(&[0.05, -1.0, 0.0]).unwrap();
    assert!((run.rates().unwrap()[1] - (250.0 + 2.0 - 9.81)).abs() < 1e-9);
    run.set_state(&[0.3, -1.0, 0.0]).unwrap();
    assert!((run.rates().unwrap()[1] + 9.81).abs() < 1e-12);

    // A loop: far from where it was, on the mirror image on which it was, as a run that came there.
    let mut run = start(Rocker::new(), METHODS[0]);
    let mut there = run.clone();
    for _ in 0..30 {
        there.step(0.01, &mut |_| true).unwrap();
        let mut here = run.clone();
        if there.state_names() != here.state_names() {
            break;
        }
        here.set_state(&there.state().unwrap()).unwrap();
        for body in 0..3 {
            for (found, known) in here.pose(body).unwrap().iter().zip(there.pose(body).unwrap()) {
                assert!((found - known).abs() < 1e-9 * (1.0 + known.abs()), "{body}: {found} {known}");
            }
        }
        here.step(0.2, &mut |_| true).unwrap();
    }
    // Where the loop cannot be closed.
    let before = run.save().unwrap();
    let mut x = run.state().unwrap();
    x[0] = 3.1;
    let fault: Fault = run.set_state(&x).unwrap_err();
    assert!(matches!(fault.cause, Cause::Open { .. }), "{fault}");
    assert!(run.save().unwrap() == before);

    // What is off the constraints is projected.
    let mut run = start(Swing::new(), METHODS[0]);
    let mut x = run.state().unwrap();
    x[0] += 1e-3;
    run.set_state(&x).unwrap();
    let arm = run.pose(0).unwrap();
    assert!((arm[0].hypot(arm[1]) - 0.5).abs() < 1e-9, "{arm:?}");
    run.step(0.1, &mut |_| true).unwrap();
}

/// A record has what switched, and inputs.
#[test]
fn a_record_has_events_and_whatever_is_read() {
    let mut run = start(Hopper::new(), METHODS[0]);
    run.set(Kind::Input, 0, 1.5).unwrap();
    let columns = [(Kind::Input, 0), (Kind::State, 0), (Kind::Parameter, 0), (Kind::Output, 0)];
    let asked = Asked { until: 1.0, every: 0.1, quantities: &columns, poses: true };
    let (record, outcome) = run.run(asked, &mut |_| true);
    outcome.unwrap();
    assert!(record.columns.iter().all(|column| column.len() == 11));
    assert!(
        record.columns[1].iter().all(|push| *push == 1.5) && record.columns[3].iter().all(|k| *k == 5000.0)
    );
    // After them x, y, angle, vx, vy, omega of the ball: at 0.1 s it has fallen g t^2/2 less the push.
    assert_eq!(record.columns.len(), 1 + columns.len() + 6);
    assert_eq!(record.columns[6].last(), Some(&run.pose(0).unwrap()[1]));
    // It falls by 0.4 m from rest: 0.4 m = (g - 1.5 m/s^2) t^2 / 2 + 1.5 m/s^2 tau (t - tau), as the valve lags by tau.
    let (g, tau) = (9.81 - 1.5, 1e-3);
    let root = f64::sqrt((1.5 * tau) * (1.5 * tau) + 2.0 * g * (0.4 + 1.5 * tau * tau));
    let (at, what) = record.events[0];
    assert!((at - (root - 1.5 * tau) / g).abs() < 1e-8 && what == "floor", "{:?}", record.events);
    assert_eq!(record.events[2], (0.37, "kick"));
}

/// The mechanism of the page of the book.
mod of_the_page {
    plm::mechanism! {
        /// A bar on a pin.
        pub Pendulum {
            gravity: 9.81 m/s^2;
            /// Of the bearing.
            param friction: N*m*s/rad = 0.1 N*m*s/rad;
            /// Of the motor.
            input drive: N*m = 0;
            ground { port o: (0, 0) m; }
            body bar { mass: 2 kg; inertia: 0.1 kg*m^2; port pivot: (0, 0.4) m; start angle: 30 deg, locked; }
            revolute hinge(ground.o, bar.pivot) { damping: friction; drive: drive; }
            require below: bar.angle < 270 deg;
            output bar.angle in deg, hinge.force;
        }
    }
}

/// Python has the bits of Rust (tests/python.rs): what the page shows of a step is looked at here, where Python may not be.
#[test]
fn the_page_of_the_book_shows_the_number_of_rust() {
    use of_the_page::Pendulum;
    let page = include_str!("../docs/src/running/python.md");
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let block = page.split("```rust,no_run").nth(1).and_then(|rest| rest.split("fn main").next()).unwrap();
    assert!(
        words(include_str!("python_run.rs")).contains(&words(block)),
        "the page has another mechanism: {block}"
    );
    let mut run =
        Run::start(Pendulum::new(), method("dop853", None, None).unwrap(), (&[(0, 0.3)], &[]), 0.0).unwrap();
    run.step(0.1, &mut |_| true).unwrap();
    let angle = Pendulum::<f64>::OBSERVED.iter().position(|(name, _)| *name == "bar.angle").unwrap();
    let angle = run.get(Kind::Output, angle).unwrap();
    let shown = format!(">>> m = Pendulum(friction=0.3)\n>>> m.step(0.1)\n>>> m[\"bar.angle\"]\n{angle:?}\n");
    assert!(page.contains(&shown), "the page does not show\n{shown}");
}
