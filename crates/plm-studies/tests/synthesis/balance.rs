//! Balancing and tolerances, beside runs and closed forms.

use plm_dynamic::Mechanism;
use plm_runtime::Real;
use plm_studies::synthesis::balance::{balance_spring, counterweights};
use plm_studies::synthesis::tolerance::{Dimension, Distribution, Quantity, monte_carlo, stack};
use plm_studies::synthesis::{FourBar, Image, LinkMass};

/// Largest sum of the forces at the pivots over a turn, N.
fn shaking_force(four_bar: &FourBar, masses: &[LinkMass; 3]) -> f64 {
    let text = four_bar.declaration_with_masses("Shaker", 0.3, masses).unwrap();
    let mut mechanism = Mechanism::from_text(&text).unwrap();
    mechanism.set_parameter("speed", 20.0).unwrap();
    let mut run = mechanism.start().unwrap();
    let mut largest = 0.0_f64;
    for k in 0..100 {
        run.step_to(f64::from(k) * std::f64::consts::TAU / 2000.0).unwrap();
        let (x, y) = (forces(&run, "x"), forces(&run, "y"));
        largest = largest.max(x.hypot(y));
    }
    largest
}

/// Sum of what both joints do to the ground, their first body.
fn forces(run: &plm_dynamic::Run, axis: &str) -> f64 {
    ["motor", "pivot"].iter().map(|joint| run.output(&format!("{joint}.force.{axis}")).unwrap()).sum()
}

#[test]
fn a_balanced_four_bar_does_not_shake() {
    let four_bar = FourBar {
        pivots: [[0.0, 0.0], [0.3, 0.02]],
        crank: 0.1,
        coupler: 0.25,
        rocker: 0.2,
        point: [0.1, 0.05],
        image: Image::Left,
    };
    let masses = [
        LinkMass { mass: 0.4, inertia: 1e-3, centre: [0.05, 0.002] },
        LinkMass { mass: 0.9, inertia: 5e-3, centre: [0.11, 0.03] },
        LinkMass { mass: 0.6, inertia: 2e-3, centre: [0.09, -0.01] },
    ];
    let unbalanced = shaking_force(&four_bar, &masses);
    let [at_crank, at_rocker] = counterweights(&four_bar, &masses);
    let balanced = [at_crank.added_to(&masses[0], 1.5), masses[1], at_rocker.added_to(&masses[2], 2.0)];
    let rest = shaking_force(&four_bar, &balanced);
    assert!(unbalanced > 20.0 && rest < 1e-10 * unbalanced, "{unbalanced} {rest:e}");
}

#[test]
fn a_spring_holds_a_link_in_any_pose() {
    let (mass, centre, height) = (3.0, [0.3, 0.04], 0.25);
    let spring = balance_spring(mass, centre, 9.81, height, 0.2).unwrap();
    for degrees in [-170, -60, 0, 35, 90, 140] {
        let [x, y] = spring.end;
        let text = format!(
            "pub Lamp {{
                gravity: 9.81 m/s^2;
                ground {{ port pivot: (0, 0) m; port hook: (0, {height}) m; }}
                body arm {{
                    mass: {mass:?} kg; inertia: 0.1 kg*m^2;
                    port pivot: ({:?}, {:?}) m; port end: ({:?}, {:?}) m;
                    start angle: {degrees} deg, locked;
                }}
                revolute hinge(ground.pivot, arm.pivot);
                spring balance(ground.hook, arm.end) {{ stiffness: {:?} N/m; free_length: 0 m; }}
            }}",
            -centre[0],
            -centre[1],
            x - centre[0],
            y - centre[1],
            spring.stiffness
        );
        let mut run = Mechanism::from_text(&text).unwrap().start().unwrap();
        let before = run.body("arm").unwrap().angle;
        run.step_to(10.0).unwrap();
        let after = run.body("arm").unwrap();
        assert!((after.angle - before).abs() < 1e-9 && after.omega.abs() < 1e-9, "{degrees} {after:?}");
    }
}

/// Place of the slider of a slider-crank at 50 degrees.
struct Slider;

impl Quantity<3> for Slider {
    fn value<S: Real>(&self, [crank, rod, offset]: [S; 3]) -> Option<S> {
        let (sin, cos) = S::lit(50_f64.to_radians()).sin_cos();
        let height = offset - crank * sin;
        let square = rod * rod - height * height;
        (square.to_f64() > 0.0).then(|| crank * cos + square.sqrt())
    }
}

#[test]
fn tolerances_of_a_slider() {
    let dimension =
        |name, nominal, tolerance, distribution| Dimension { name, nominal, tolerance, distribution };
    let dimensions = [
        dimension("crank", 0.1, 1e-4, Distribution::Normal),
        dimension("rod", 0.3, 2e-4, Distribution::Uniform),
        dimension("offset", 0.02, 5e-4, Distribution::Triangular),
    ];
    let found = stack(&Slider, &dimensions).unwrap();
    // Closed form of the derivatives.
    let (sin, cos) = 50_f64.to_radians().sin_cos();
    let height: f64 = 0.02 - 0.1 * sin;
    let along = (0.09 - height * height).sqrt();
    let exact = [("crank", cos + height * sin / along), ("rod", 0.3 / along), ("offset", -height / along)];
    for (name, derivative) in exact {
        let own = found.contributions.iter().find(|c| c.name == name).unwrap();
        assert!((own.derivative - derivative).abs() < 1e-14);
    }
    let worst: f64 = exact.iter().zip([1e-4, 2e-4, 5e-4]).map(|((_, d), t)| d.abs() * t).sum();
    assert!((found.worst - worst).abs() < 1e-17);
    let [least, most] = found.corners.unwrap();
    // The terms of second order: the offset's square by the way along the line, and less.
    let second = 0.6 * 5e-4_f64.powi(2) / along;
    assert!((most - found.nominal - worst).abs() < second && (found.nominal - least - worst).abs() < second);
    assert!((found.contributions.iter().map(|c| c.share).sum::<f64>() - 1.0).abs() < 1e-14);
    assert!(found.contributions.windows(2).all(|pair| pair[0].share >= pair[1].share));
    let sampled = monte_carlo(&Slider, &dimensions, 40_000, 3);
    // The standard error of a deviation is 1/sqrt(2 n) of it, here 0.35 %.
    assert!(
        (sampled.deviation / found.deviation - 1.0).abs() < 0.015,
        "{} {}",
        sampled.deviation,
        found.deviation
    );
    assert!((sampled.mean - found.nominal).abs() < 4.0 * found.deviation / 200.0);
    assert!(sampled.values[0] >= least && sampled.values[39_999] <= most);
    assert!((sampled.within(least, most) - 1.0).abs() < 1e-15);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let alone = pool.install(|| monte_carlo(&Slider, &dimensions, 40_000, 3));
    assert_eq!(alone, sampled);
}
