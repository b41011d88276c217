//! Mirror images that joints ask for, against the intersections of circles and lines.

use plm::Cause;

/// A four-bar whose start is nearer to the image in which the rocker turns left from the coupler.
macro_rules! four_bar {
    ($module:ident, { $($formulation:tt)* }, { $($branch:tt)* }) => {
        mod $module {
            plm::mechanism! {
                pub FourBar {
                    $($formulation)*
                    param reach: m = 0.9 m;
                    ground { port a: (0, 0) m; port d: (1, 0) m; }
                    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; }
                    body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (-reach/2, 0 m); port c: (reach/2, 0 m); start angle: 30 deg; }
                    body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0) m; start x: 1 m; start angle: 95 deg; }
                    revolute drive(ground.a, crank.a);
                    $($branch)*
                    revolute pivot(ground.d, rocker.d);
                    output tip = coupler.c.position;
                }
            }
        }
    };
}

four_bar!(free, {}, { revolute pin(crank.b, coupler.b); revolute wrist(coupler.c, rocker.c); });
four_bar!(left, {}, { revolute pin(crank.b, coupler.b); revolute wrist(coupler.c, rocker.c) { branch: left; } });
four_bar!(right, {}, { revolute pin(crank.b, coupler.b); revolute wrist(coupler.c, rocker.c) { branch: right; } });
four_bar!(other_order, {}, { revolute pin(crank.b, coupler.b); revolute wrist(rocker.c, coupler.c) { branch: right; } });
four_bar!(absolute, { formulation: absolute; }, { revolute pin(crank.b, coupler.b); revolute wrist(coupler.c, rocker.c) { branch: right; } });
four_bar!(none, {}, { revolute pin(crank.b, coupler.b) { branch: left; } revolute wrist(coupler.c, rocker.c); });

/// Where the circle of the coupler about the crank's pin and that of the rocker about (1, 0) m meet: above, and below.
fn meetings(crank: f64, coupler: f64) -> [[f64; 2]; 2] {
    let (sin, cos) = crank.sin_cos();
    let [x, y] = [0.3 * cos, 0.3 * sin];
    let (dx, dy) = (1.0 - x, -y);
    let distance = dx.hypot(dy);
    let along = (distance * distance + coupler * coupler - 0.49) / (2.0 * distance);
    let across = (coupler * coupler - along * along).sqrt();
    let at = |side: f64| [x + (along * dx - side * dy) / distance, y + (along * dy + side * dx) / distance];
    let (one, other) = (at(across), at(-across));
    if one[1] > other[1] { [one, other] } else { [other, one] }
}

#[track_caller]
fn assert_at(found: [f64; 2], expected: [f64; 2]) {
    let gap = (found[0] - expected[0]).hypot(found[1] - expected[1]);
    assert!(gap < 1e-12, "{found:?} and {expected:?}");
}

/// Seen from the coupler, which comes from the left, the rocker turns right where the wrist is above.
#[test]
fn a_four_bar_starts_on_the_branch_that_is_asked_for() {
    let [above, below] = meetings(60_f64.to_radians(), 0.9);
    assert_at(free::FourBar::new().start().unwrap().tip(), above);
    assert_at(right::FourBar::new().start().unwrap().tip(), above);
    assert_at(left::FourBar::new().start().unwrap().tip(), below);
    assert_at(other_order::FourBar::new().start().unwrap().tip(), below);
    assert_at(absolute::FourBar::new().start().unwrap().tip(), above);
}

/// From starts near to either image, with other lengths and other angles of the crank, which stays where it is locked.
#[test]
fn starts_on_either_side_lead_to_the_branch() {
    for (reach, crank) in [(0.9, 60.0_f64), (0.75, -100.0), (1.1, 160.0)] {
        let crank = crank.to_radians();
        let images = meetings(crank, reach);
        for [x, y] in images {
            for beside in [-0.3, 0.0, 0.3] {
                let (sin, cos) = crank.sin_cos();
                let coupler = (y - 0.3 * sin).atan2(x - 0.3 * cos) + beside;
                let rocker = y.atan2(x - 1.0) + beside;
                let mut one = right::FourBar { reach, ..right::FourBar::new() };
                let mut other = left::FourBar { reach, ..left::FourBar::new() };
                (one.start.crank.angle.value, other.start.crank.angle.value) = (crank, crank);
                (one.start.coupler.angle.value, other.start.coupler.angle.value) = (coupler, coupler);
                (one.start.rocker.angle.value, other.start.rocker.angle.value) = (rocker, rocker);
                let (one, other) = (one.start().unwrap(), other.start().unwrap());
                assert_at(one.tip(), images[0]);
                assert_at(other.tip(), images[1]);
                assert!((one.crank().angle - crank).abs() < 1e-15);
            }
        }
    }
}

/// What is asked for holds at the start alone, and costs nothing in a step.
#[test]
fn asking_for_a_branch_costs_nothing_in_a_step() {
    assert_eq!(free::four_bar::OPERATIONS, right::four_bar::OPERATIONS);
}

#[test]
fn a_branch_that_is_not_there_is_told() {
    let fault = none::FourBar::new().start().err().unwrap();
    assert!(matches!(fault.cause, Cause::OtherBranch { left: false, .. }), "{fault}");
    assert_eq!(
        fault.to_string(),
        "t = 0 s: pin: on the way along crank to this joint and on along coupler one turns right, and no pose was found where \
         one turns left; start nearer to it"
    );
}

mod slider_crank {
    plm::mechanism! {
        /// The crank is locked, so that the rod alone can turn to the other side.
        pub SliderCrank {
            ground { port o: (0, 0) m; }
            body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port pin: (0.2, 0) m; start angle: 60 deg, locked; }
            body rod { mass: 1 kg; inertia: 0.1 kg*m^2; port pin: (0, 0) m; port end: (0.6, 0) m; }
            body block { mass: 1 kg; inertia: 0.1 kg*m^2; port end: (0, 0) m; start x: 0.7 m; }
            revolute main(ground.o, crank.o);
            revolute big_end(crank.pin, rod.pin) { branch: left; }
            revolute small_end(rod.end, block.end);
            prismatic guide(ground.o, block.end);
        }
    }
}

#[test]
fn a_slider_crank_starts_on_the_other_side() {
    let sim = slider_crank::SliderCrank::new().start().unwrap();
    let (sin, cos) = 60_f64.to_radians().sin_cos();
    let expected = 0.2 * cos - (0.36 - (0.2 * sin).powi(2)).sqrt();
    assert!((sim.block().x - expected).abs() < 1e-12, "{}", sim.block().x);
    assert!((sim.crank().angle - 60_f64.to_radians()).abs() < 1e-15);
}

mod six_bar {
    plm::mechanism! {
        /// Two dyads, one after the other, both on their other side.
        pub SixBar {
            ground { port a: (0, 0) m; port d: (1, 0) m; port g: (2, 0) m; }
            body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.3, 0) m; start angle: 60 deg, locked; }
            body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (0.9, 0) m; start angle: 30 deg; }
            body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (0.7, 0) m; start x: 1 m; start angle: 95 deg; }
            body link { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (0, 0) m; port f: (1, 0) m; start x: 0.9 m; start y: 0.7 m; }
            body lever { mass: 1 kg; inertia: 0.1 kg*m^2; port g: (0, 0) m; port f: (0.8, 0) m; start x: 2 m; start angle: 90 deg; }
            revolute a(ground.a, crank.a);
            revolute b(crank.b, coupler.b);
            revolute c(coupler.c, rocker.c) { branch: left; }
            revolute d(ground.d, rocker.d);
            revolute e(rocker.c, link.c);
            revolute f(link.f, lever.f) { branch: left; }
            revolute g(ground.g, lever.g);
            output wrist = rocker.c.position, elbow = lever.f.position;
        }
    }
}

#[test]
fn several_branches_are_found_one_after_the_other() {
    let sim = six_bar::SixBar::new().start().unwrap();
    let [_, below] = meetings(60_f64.to_radians(), 0.9);
    assert_at(sim.wrist(), below);
    // The elbow is 1 m from the wrist, 0.8 m from (2, 0) m, and right of the way from one to the other.
    let ([x, y], [wx, wy]) = (sim.elbow(), below);
    assert!(((x - wx).hypot(y - wy) - 1.0).abs() < 1e-12 && ((x - 2.0).hypot(y) - 0.8).abs() < 1e-12);
    assert!((2.0 - wx) * (y - wy) - (0.0 - wy) * (x - wx) < 0.0, "{x} {y}");
}
