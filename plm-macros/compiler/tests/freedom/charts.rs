//! What the report says of the chart that a run begins in.

use plm_compiler::token::Sources;
use plm_compiler::{Report, compile};

/// A slider-crank, whose crank can drive nothing where the rod stands across the slide.
fn slider_crank(starts: [&str; 3]) -> Report {
    let [crank, rod, slider] = starts;
    let mut sources = Sources::new();
    let text = format!(
        "pub SliderCrank {{
            gravity: 9.81 m/s^2;
            ground {{ port o: (0, 0) m; }}
            body crank {{ mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (0.5, 0) m; {crank} }}
            body rod {{ mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0.1, 0.15) m; port q: (0.1, -0.15) m; {rod} }}
            body slider {{ mass: 1 kg; inertia: 0.1 kg*m^2; port q: (0, 0) m; {slider} }}
            revolute a(ground.o, crank.o) {{ damping: 1 N*m*s/rad; }}
            revolute b(crank.p, rod.p);
            revolute c(rod.q, slider.q);
            prismatic d(ground.o, slider.q);
        }}"
    );
    sources.add_text("declaration", &text);
    let expansion = compile(&mut sources);
    let told: Vec<String> = expansion.diagnostics.sorted().iter().map(|d| d.render(&sources)).collect();
    expansion.report.unwrap_or_else(|| panic!("{}", told.concat()))
}

#[test]
fn the_report_counts_the_chart_that_is_taken_first() {
    let across =
        slider_crank(["start angle: atan2(3, 4);", "start x: 0.3 m; start y: 0.15 m;", "start x: 0.4 m;"]);
    let along =
        slider_crank(["start angle: 0.1 rad;", "start x: 0.5 m; start angle: 80 deg;", "start x: 0.7 m;"]);
    let [first, second] = [&along, &across].map(ToString::to_string);
    assert!(!first.contains("is taken first"), "{first}");
    assert!(second.contains("Chart 1 is taken first."), "{second}");
    assert_ne!(along.rate.total(), across.rate.total(), "{first}{second}");
}

/// The slider is a point: no turn of it tells one mirror image from the other.
#[test]
fn a_joint_on_a_point_names_no_branch() {
    let report = slider_crank(["start angle: 0.1 rad;", "start angle: 80 deg;", "start x: 0.7 m;"]);
    let named: Vec<&String> = report.assembly.iter().filter(|line| line.starts_with("branch: ")).collect();
    assert!(named.len() == 1 && named[0].contains("at `b`"), "{named:?}");
}
