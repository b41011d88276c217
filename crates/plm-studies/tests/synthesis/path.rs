//! Path generation: the five cases of the literature.
//!
//! Points, bounds, timing and published designs are those of Nguyen-Van, Lieu, Nguyen Xuan-Mung and Nguyen (Symmetry 14, 381, 2022;
//! data at github.com/sy-nguyen-van/DE_Jaya_Synthesis_Four_Bar_Mechanisms), who compare their runs with the designs of Kunjur and
//! Krishnamurty (J. Mech. Des. 119, 1997), Cabrera, Simon and Prado (Mech. Mach. Theory 37, 2002), Acharyya and Mandal (Mech. Mach.
//! Theory 44, 2009) and Cabrera, Ortiz, Nadal and Castillo (MUMSA, Mech. Mach. Theory 46, 2011). The error is the sum of squared
//! distances. A published error is that of the published design, computed anew.

use plm_dynamic::Mechanism;
use plm_studies::synthesis::FourBar;
use plm_studies::synthesis::path::{Bounds, Crank, Found, NoPath, Path, Search, Timing};

fn bounds(length: [f64; 2], place: f64) -> Bounds {
    let place = [-place, place];
    Bounds {
        pivot: [place; 2],
        ground_angle: [0.0, std::f64::consts::TAU],
        lengths: [length; 4],
        point: [place; 2],
    }
}

/// Length of a link that the literature bounds by 0.
const SHORTEST: f64 = 0.001;

fn line() -> Path {
    let points = (0..6).map(|k| [20.0, 20.0 + 5.0 * f64::from(k)]).collect();
    Path {
        points,
        timing: Timing::Free,
        bounds: bounds([SHORTEST, 60.0], 60.0),
        crank: Crank::Turns,
        transmission: 0.0,
    }
}

fn five_angles() -> Path {
    let points = vec![[3.0, 3.0], [2.759, 3.363], [2.372, 3.663], [1.890, 3.862], [1.355, 3.943]];
    let angles = [30.0_f64, 45.0, 60.0, 75.0, 90.0].map(f64::to_radians).to_vec();
    let bounds = Bounds { pivot: [[0.0; 2]; 2], ground_angle: [0.0; 2], ..bounds([SHORTEST, 50.0], 50.0) };
    Path { points, timing: Timing::Given(angles), bounds, crank: Crank::Turns, transmission: 0.0 }
}

fn eighteen() -> Path {
    let points = vec![
        [0.5, 1.1],
        [0.4, 1.1],
        [0.3, 1.1],
        [0.2, 1.0],
        [0.1, 0.9],
        [0.05, 0.75],
        [0.02, 0.6],
        [0.0, 0.5],
        [0.0, 0.4],
        [0.03, 0.3],
        [0.1, 0.25],
        [0.15, 0.2],
        [0.2, 0.3],
        [0.3, 0.4],
        [0.4, 0.5],
        [0.5, 0.7],
        [0.6, 0.9],
        [0.6, 1.0],
    ];
    let steps = (0..18).map(|k| (20.0 * f64::from(k)).to_radians()).collect();
    Path {
        points,
        timing: Timing::Steps(steps),
        bounds: bounds([SHORTEST, 50.0], 50.0),
        crank: Crank::Turns,
        transmission: 0.0,
    }
}

fn semicircle() -> Path {
    let points =
        vec![[0.0, 0.0], [1.9098, 5.8779], [6.9098, 9.5106], [13.09, 9.5106], [18.09, 5.8779], [20.0, 0.0]];
    let angles = (1..=6).map(|k| (30.0 * f64::from(k)).to_radians()).collect();
    Path {
        points,
        timing: Timing::Given(angles),
        bounds: bounds([5.0, 50.0], 50.0),
        crank: Crank::Turns,
        transmission: 0.0,
    }
}

fn ellipse() -> Path {
    let points = vec![
        [20.0, 10.0],
        [17.66, 15.142],
        [11.736, 17.878],
        [5.0, 16.928],
        [0.60307, 12.736],
        [0.60307, 7.2638],
        [5.0, 3.0718],
        [11.736, 2.1215],
        [17.66, 4.8577],
        [20.0, 10.0],
    ];
    Path {
        points,
        timing: Timing::Free,
        bounds: bounds([SHORTEST, 80.0], 80.0),
        crank: Crank::Turns,
        transmission: 0.0,
    }
}

fn best(path: &Path, starts: u64) -> Found {
    path.search(&Search { starts, ..Search::default() }).unwrap().swap_remove(0)
}

/// Sum of squared distances of a run of the linkage's declaration to the points.
fn error_of_run(found: &Found, path: &Path) -> f64 {
    let first = found.angles[0];
    let way = if found.angles[1] < first { -1.0 } else { 1.0 };
    let text = found.four_bar.declaration("Drawer", first).unwrap();
    let mut mechanism = Mechanism::from_text(&text).unwrap();
    mechanism.set_parameter("speed", way).unwrap();
    let mut run = mechanism.start().unwrap();
    let mut error = 0.0;
    for (angle, point) in found.angles.iter().zip(&path.points) {
        // Linkages without a defect pass all points in one turn.
        run.step_to(((angle - first) * way).max(run.time())).unwrap();
        let [x, y] = ["x", "y"].map(|axis| run.output(&format!("coupler.tracer.position.{axis}")).unwrap());
        error += (x - point[0]).powi(2) + (y - point[1]).powi(2);
    }
    error
}

/// The error is at or below the best published one, and is found again by independent starts and by a run. No tolerance but that of the
/// iteration's end.
fn assert_error(path: &Path, starts: u64, error: f64, published: f64) {
    let found = best(path, starts);
    assert_eq!(found.defects, []);
    let rounding = 1e-25;
    assert!(found.error <= published, "{:e}", found.error);
    assert!(found.error <= error * (1.0 + 1e-6) + rounding, "{:e}", found.error);
    assert!((error_of_run(&found, path) - found.error).abs() <= 1e-7 * found.error + rounding);
    let bounds = path.bounds.lengths.iter().zip(found.four_bar.lengths());
    assert!(bounds.into_iter().all(|([least, most], length)| (*least..=*most).contains(&length)));
}

#[test]
fn six_points_on_a_line_are_met() {
    // 2.5e-29 in the data of 2022: zero but for rounding.
    assert_error(&line(), 300, 0.0, 1e-25);
}

#[test]
fn five_points_with_given_angles() {
    // MUMSA; 1.83e-6 of Cabrera, Simon and Prado, 9.53e-4 of Kunjur and Krishnamurty.
    assert_error(&five_angles(), 300, 7.41575e-7, 1.284_001e-6);
}

#[test]
fn eighteen_points_with_equal_steps() {
    // The runs of 2022; 1.94e-2 of MUMSA, 3.37e-2 of Cabrera, Simon and Prado, 6.61e-2 of Kunjur and Krishnamurty.
    assert_error(&eighteen(), 300, 9.02888e-3, 1.607_769e-2);
}

#[test]
fn six_points_of_a_semicircle_with_given_angles() {
    // A design of others in the data of 2022, with lengths from 5. From 0 the runs reach 1.2162 by a linkage that misses Grashof's rule by
    // 8e-7, at a transmission angle of 0 or nearly so: no crank turns it.
    let published = 2.580_355_625_7;
    assert_error(&semicircle(), 300, published, published * (1.0 + 1e-9));
}

#[test]
fn ten_points_of_an_ellipse() {
    // The runs of 2022, which name 4.02e-4 as the best of others.
    assert_error(&ellipse(), 300, 4.01992e-4, 4.02e-4);
}

#[test]
fn a_least_transmission_angle_bounds_the_lengths() {
    let free = best(&ellipse(), 300);
    let least = |found: &Found| {
        let [least, most] = found.four_bar.transmission_extremes().unwrap();
        least.min(std::f64::consts::PI - most)
    };
    let demanded = 55_f64.to_radians();
    assert!(least(&free) < demanded - 0.1, "{}", least(&free).to_degrees());
    let bound = best(&Path { transmission: demanded, ..ellipse() }, 300);
    assert_eq!(bound.defects, []);
    assert!(least(&bound) >= demanded * (1.0 - 1e-6), "{}", least(&bound).to_degrees());
    assert!(bound.error >= free.error && bound.error < 10.0 * free.error, "{}", bound.error);
    assert!((error_of_run(&bound, &ellipse()) - bound.error).abs() <= 1e-7 * bound.error);
}

/// The same bound at the points alone, of linkages whose crank need not turn.
#[test]
fn a_least_transmission_angle_bounds_the_points_of_any_crank() {
    let demanded = 55_f64.to_radians();
    let any = Path { crank: Crank::Any, transmission: demanded, ..ellipse() };
    let found = best(&any, 300);
    assert_eq!(found.defects, []);
    let folded = |angle: &f64| {
        let angle = FourBar::transmission_angle(&found.four_bar.pose(*angle).unwrap());
        angle.min(std::f64::consts::PI - angle)
    };
    let least = found.angles.iter().map(folded).fold(f64::INFINITY, f64::min);
    // The bound is met, and it is what the error comes from.
    assert!(least >= demanded * (1.0 - 1e-6) && least < demanded * 1.01, "{}", least.to_degrees());
    let over_turn = best(&Path { transmission: demanded, ..ellipse() }, 300);
    assert!(found.error <= over_turn.error * (1.0 + 1e-9), "{} {}", found.error, over_turn.error);
}

#[test]
fn a_search_does_not_depend_on_threads() {
    let search = Search { starts: 200, seed: 9, keep: 5 };
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| ellipse().search(&search).unwrap())
    };
    let alone = on(1);
    assert!(!alone.is_empty());
    assert_eq!(alone, on(3));
}

#[test]
fn what_is_asked_wrongly_has_a_name() {
    let short = Path { points: vec![[0.0, 0.0]], ..line() };
    assert_eq!(short.search(&Search::default()), Err(NoPath::TooFewPoints));
    let angles = Path { timing: Timing::Given(vec![0.0; 3]), ..line() };
    assert_eq!(angles.search(&Search::default()), Err(NoPath::Angles { points: 6, angles: 3 }));
    let mut crossed = line();
    crossed.bounds.lengths[1] = [2.0, 1.0];
    assert_eq!(crossed.search(&Search::default()), Err(NoPath::Bounds));
}
