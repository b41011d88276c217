//! Pictures of the book's page about contact.

use std::fs;
use std::path::Path;

use plm::{Dop853, Mechanism as _, Moment as _, Scalar};
use plm_view::{Axis, Chart, Rule, Series};

use crate::declared::Oscillator;
use crate::scene::{Given as _, Named as _};

/// A mass on a belt: its speed, and the friction.
fn belt() -> Chart {
    let belt = Oscillator::new()
        .with("kinetic", 0.25 * 9.81)
        .with("adhesion", 0.4 * 9.81)
        .with("belt", 0.1)
        .with_start("mass.x", 0.0)
        .with_start("mass.vx", 0.1);
    let (mut speeds, mut forces) = (Vec::new(), Vec::new());
    let mut sim = belt.start_with(Dop853::new(1e-10)).unwrap();
    sim.run(2.5, 0.005, |state| {
        speeds.push((state.time(), state.state_of("mass").vx));
        forces.push((state.time(), state.value_of("drag")));
    })
    .unwrap();
    Chart::new(Axis::linear("time", "s"), Axis::linear("speed", "m/s"))
        .titled("A mass on a belt, held by a spring")
        .noted("1 kg, 100 N/m, a belt at 0.1 m/s; static friction 3.924 N, kinetic 2.4525 N.")
        .with(Series::new("speed of the mass", speeds))
        .with_rule(Rule::horizontal(0.1, "belt"))
        .below(Axis::linear("friction", "N").including(0.0))
        .with(Series::new("friction", forces))
        .with_rule(Rule::horizontal(3.924, "static"))
}

/// Painlevé's rod: 1 - 3 mu sin th cos th/(1 + 3 cos^2 th).
fn painleve() -> Chart {
    let chart = Chart::new(Axis::linear("angle to the ground", "deg"), Axis::linear("share of D_nn", ""))
        .titled("A rod whose lower tip slides ahead of it")
        .noted("p = D_nn - sigma mu D_nt as a share of D_nn. Where it is negative rigid bodies have no unique motion.");
    let curve = |mu: f64| {
        let share = move |degrees: f64| {
            let (sin, cos) = Scalar::sin_cos(degrees.to_radians());
            (degrees, 1.0 - 3.0 * mu * sin * cos / (1.0 + 3.0 * cos * cos))
        };
        Series::new(format!("mu = {mu:.2}"), (0..=180).map(move |k| share(0.5 * f64::from(k))))
    };
    [1.0, 4.0 / 3.0, 1.5, 2.0].into_iter().fold(chart, |chart, mu| chart.with(curve(mu)))
}

/// `cargo xtask bless contact` writes them.
#[test]
fn pictures_of_the_book_are_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/src/images/theory");
    for (name, chart) in [("belt.svg", belt()), ("painleve.svg", painleve())] {
        let (file, svg) = (folder.join(name), chart.to_svg());
        if std::env::var_os("PLM_BLESS").is_some() {
            fs::create_dir_all(&folder).unwrap();
            fs::write(&file, &svg).unwrap();
        }
        assert!(fs::read_to_string(&file).ok() == Some(svg), "{name} differs: cargo xtask bless contact");
    }
}
