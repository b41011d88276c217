//! Workspace and dead points of mechanisms from text, against closed forms.

use std::f64::consts::{PI, TAU};

use plm_dynamic::{Mechanism, OnRun};
use plm_runtime::{Described, Linear, Method, Sim, Statics};
use plm_studies::synthesis::kinematics::{DeadPoint, FiveBar, NoReach, Reach, dead_points, workspace};
use plm_studies::synthesis::{FourBar, Image, Limits, LinkMass};

/// Workspace of a point of a body.
struct AskReach(&'static str, [f64; 2], usize);

impl OnRun for AskReach {
    type Output = Result<Vec<Reach>, NoReach>;

    fn on<M, I>(self, sim: &mut Sim<M, I>) -> Self::Output
    where
        M: Described<S = f64> + Statics + Linear<Lifted<1>: Described + Statics>,
        I: Method<M>,
    {
        workspace(sim, self.0, self.1, self.2)
    }
}

/// Dead points of a coordinate.
struct AskDead(&'static str);

impl OnRun for AskDead {
    type Output = Result<Vec<DeadPoint>, NoReach>;

    fn on<M, I>(self, sim: &mut Sim<M, I>) -> Self::Output
    where
        M: Described<S = f64> + Statics + Linear<Lifted<1>: Described + Statics>,
        I: Method<M>,
    {
        dead_points(sim, self.0)
    }
}

fn asked<Q: OnRun>(text: &str, question: Q) -> Q::Output {
    Mechanism::from_text(text).unwrap().start().unwrap().then(question)
}

/// Five-bar without drives, its pin at a place.
fn five_bar_text(five_bar: &FiveBar, pin: [f64; 2]) -> String {
    let pose = five_bar.poses_at(pin).into_iter().next().unwrap();
    let [[x0, y0], [x1, y1]] = five_bar.pivots;
    let arm = |name: &str, k: usize| {
        let [x, y] = five_bar.pivots[k];
        let (crank, bar, angle) = (five_bar.cranks[k], five_bar.bars[k], pose.cranks[k]);
        let elbow = [x + crank * angle.cos(), y + crank * angle.sin()];
        let turned = (pose.pin[1] - elbow[1]).atan2(pose.pin[0] - elbow[0]);
        format!(
            "    body crank_{name} {{ mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: ({crank:?}, 0) m;
                start x: {x:?} m; start y: {y:?} m; start angle: {angle:?} rad; }}
            body bar_{name} {{ mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: ({bar:?}, 0) m;
                start x: {:?} m; start y: {:?} m; start angle: {turned:?} rad; }}
            revolute pivot_{name}(ground.{name}, crank_{name}.a);
            revolute elbow_{name}(crank_{name}.b, bar_{name}.a);\n",
            elbow[0], elbow[1]
        )
    };
    format!(
        "pub FiveBar {{\n    ground {{ port one: ({x0:?}, {y0:?}) m; port two: ({x1:?}, {y1:?}) m; }}\n{}{}    revolute pin(bar_one.b, bar_two.b);\n}}\n",
        arm("one", 0),
        arm("two", 1)
    )
}

/// Distance from a place along a direction to a circle: the nearest crossing ahead.
fn to_circle(from: [f64; 2], direction: f64, centre: [f64; 2], radius: f64) -> f64 {
    let (sin, cos) = direction.sin_cos();
    let off = [from[0] - centre[0], from[1] - centre[1]];
    let along = off[0] * cos + off[1] * sin;
    let square = along * along - (off[0] * off[0] + off[1] * off[1] - radius * radius);
    if square < 0.0 {
        return f64::INFINITY;
    }
    [-along - square.sqrt(), -along + square.sqrt()].into_iter().find(|d| *d > 1e-9).unwrap_or(f64::INFINITY)
}

#[test]
fn a_five_bar_reaches_its_circles() {
    let five_bar = FiveBar { pivots: [[0.0, 0.0], [1.0, 0.1]], cranks: [0.9, 0.7], bars: [0.7, 1.0] };
    let pin = [0.35, 0.95];
    let found = asked(&five_bar_text(&five_bar, pin), AskReach("bar_one", [0.7, 0.0], 9)).unwrap();
    let circles = five_bar.reach_circles();
    for reach in &found {
        let all =
            (0..2).flat_map(|k| circles[k].map(|r| to_circle(pin, reach.direction, five_bar.pivots[k], r)));
        let expected = all.fold(f64::INFINITY, f64::min);
        assert!((reach.distance - expected).abs() < 1e-9, "{reach:?} {expected}");
        let [x, y] = reach.border.unwrap();
        let (sin, cos) = reach.direction.sin_cos();
        assert!((x - pin[0] - expected * cos).hypot(y - pin[1] - expected * sin) < 1e-9);
    }
    let none = asked(&five_bar_text(&five_bar, pin), AskReach("bar", [0.0; 2], 4));
    assert_eq!(none, Err(NoReach::Unknown { name: "bar".to_owned() }));
}

#[test]
fn a_slide_on_an_arm_reaches_without_an_end() {
    // A slider on a swinging rail: the point beside the slider keeps its distance from the pivot, and has no other border.
    let text = "pub Rail {
        ground { port pivot: (0, 0) m; }
        body rail { mass: 1 kg; inertia: 1 kg*m^2; port pivot: (0, 0) m; }
        body slider { mass: 1 kg; inertia: 1 kg*m^2; port way: (0, 0) m; start x: 1 m; }
        revolute pivot(ground.pivot, rail.pivot);
        prismatic way(rail.pivot, slider.way);
    }";
    let side = 0.2;
    let found = asked(text, AskReach("slider", [0.0, side], 5)).unwrap();
    for reach in &found {
        let expected = to_circle([1.0, side], reach.direction, [0.0, 0.0], side);
        let is_same = (reach.distance - expected).abs() < 1e-9 || reach.distance == expected;
        assert!(is_same, "{reach:?} {expected}");
    }
    assert!(found.iter().any(|reach| reach.border.is_none()));
}

const MASS: LinkMass = LinkMass { mass: 1.0, inertia: 1.0, centre: [0.0; 2] };

/// Declaration of a four-bar without its drive.
fn undriven(four_bar: &FourBar, angle: f64) -> String {
    let text = four_bar.declaration_with_masses("Loop", angle, &[MASS; 3]).unwrap();
    let kept = text.lines().filter(|line| !line.contains("drive") && !line.contains("speed"));
    kept.collect::<Vec<_>>().join("\n")
}

fn wrapped(angle: f64) -> f64 {
    let angle = angle.rem_euclid(TAU);
    if angle > PI { angle - TAU } else { angle }
}

#[test]
fn dead_points_are_the_limits_of_a_four_bar() {
    let four_bar = |lengths: [f64; 4]| FourBar {
        pivots: [[0.0, 0.0], [lengths[0], 0.0]],
        crank: lengths[1],
        coupler: lengths[2],
        rocker: lengths[3],
        point: [0.0; 2],
        image: Image::Left,
    };
    // A crank-rocker: the crank has none, the rocker two.
    let turning = four_bar([1.0, 0.3, 0.9, 0.7]);
    let text = undriven(&turning, 0.5);
    assert_eq!(asked(&text, AskDead("crank.angle")), Ok(vec![]));
    let Some(Limits::Between(from, to)) = turning.rocker_limits() else { panic!() };
    let found = asked(&text, AskDead("rocker.angle")).unwrap();
    let mut angles: Vec<f64> = found.iter().map(|dead| wrapped(PI - dead.value).abs()).collect();
    angles.sort_by(f64::total_cmp);
    assert_eq!(angles.len(), 2);
    assert!((angles[0] - from).abs() < 1e-7 && (angles[1] - to).abs() < 1e-7, "{angles:?} {from} {to}");
    // A triple rocker: each link swings, on one circuit, and through both images.
    let swinging = four_bar([1.0, 0.4, 0.5, 0.6]);
    let Some(Limits::Around(limit)) = swinging.crank_limits() else { panic!() };
    let found = asked(&undriven(&swinging, 0.5), AskDead("crank.angle")).unwrap();
    let angles: Vec<f64> = found.iter().map(|dead| wrapped(dead.value)).collect();
    assert_eq!(angles.len(), 2, "{angles:?}");
    assert!(angles.iter().all(|angle| (angle.abs() - limit).abs() < 1e-7), "{angles:?} {limit}");
    assert!(angles[0] * angles[1] < 0.0);
    // With its drive it has no freedom.
    let driven = swinging.declaration("Loop", 0.5).unwrap();
    assert_eq!(asked(&driven, AskDead("crank.angle")), Err(NoReach::Mobility { found: 0, needed: 1 }));
}
