//! Questions of kinematics beside closed forms, conditions at dead points, and velocities of runs.

use std::f64::consts::{PI, TAU};

use plm_dynamic::{Mechanism, OnRun};
use plm_runtime::{Described, Linear, Method, Sim, Statics};
use plm_studies::synthesis::kinematics::{
    Build, Centre, FiveBar, Joint, Link, Mobility, MobilityAt, Singularity, SliderCrank, centrodes, gruebler,
    images, instant_centre, kennedy, mobility, mobility_at,
};
use plm_studies::synthesis::{Class, Defect, Demands, FourBar, Image, Limits};

fn four_bar(ground: f64, crank: f64, coupler: f64, rocker: f64) -> FourBar {
    let pivots = [[0.0, 0.0], [ground, 0.0]];
    FourBar { pivots, crank, coupler, rocker, point: [0.5 * coupler, 0.3], image: Image::Left }
}

fn near(a: f64, b: f64, within: f64) {
    assert!((a - b).abs() <= within, "{a} {b}");
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[test]
fn classes_and_limits() {
    let kinds = [
        ([1.0, 0.3, 0.9, 0.7], Class::CrankRocker),
        ([1.0, 0.7, 0.9, 0.3], Class::RockerCrank),
        ([0.3, 1.0, 0.9, 0.7], Class::DoubleCrank),
        ([1.0, 0.9, 0.3, 0.7], Class::DoubleRocker),
        ([1.0, 0.4, 0.5, 0.6], Class::TripleRocker),
        ([1.0, 0.4, 1.0, 0.4], Class::ChangePoint),
    ];
    for ([ground, crank, coupler, rocker], class) in kinds {
        let linkage = four_bar(ground, crank, coupler, rocker);
        assert_eq!(linkage.class(), Some(class));
        // The loop closes inside the limits and not beyond.
        let closes = |angle: f64| linkage.pose(angle).is_some();
        let limits = linkage.crank_limits().unwrap();
        let turns = matches!(class, Class::CrankRocker | Class::DoubleCrank | Class::ChangePoint);
        assert_eq!(limits == Limits::Turns, turns, "{class:?}");
        for angle in limits.dead_points() {
            assert_ne!(closes(angle + 1e-6), closes(angle - 1e-6), "{class:?} {angle}");
        }
        let (from, to) = limits.range();
        assert!((1..100).all(|k| closes(from + (to - from) * f64::from(k) / 100.0)), "{class:?}");
    }
    assert_eq!(four_bar(3.0, 0.4, 0.5, 0.6).class(), None);
}

#[test]
fn the_rocker_of_a_crank_rocker_swings_between_its_limits() {
    let linkage = four_bar(1.0, 0.3, 0.9, 0.7);
    let Some(Limits::Between(least, most)) = linkage.rocker_limits() else { panic!() };
    let rocker = |k: i32| PI - linkage.pose(f64::from(k) * TAU / 36000.0).unwrap().angles[2];
    let swung = (0..36000).map(rocker).fold([TAU, 0.0], |[a, b]: [f64; 2], x| [a.min(x), b.max(x)]);
    near(swung[0], least, 1e-7);
    near(swung[1], most, 1e-7);
    let transmission =
        |k: i32| FourBar::transmission_angle(&linkage.pose(f64::from(k) * TAU / 360.0).unwrap());
    let met = (0..360).map(transmission).fold([TAU, 0.0], |[a, b]: [f64; 2], x| [a.min(x), b.max(x)]);
    let extremes = linkage.transmission_extremes().unwrap();
    near(met[0], extremes[0], 1e-12);
    near(met[1], extremes[1], 1e-12);
}

#[test]
fn ratios_and_instant_centres_are_those_of_a_run() {
    let linkage = FourBar { pivots: [[0.2, 0.1], [1.1, 0.4]], ..four_bar(1.0, 0.3, 0.9, 0.7) };
    let text = linkage.declaration("Linkage", 0.3).unwrap();
    let mut run = Mechanism::from_text(&text).unwrap().start().unwrap();
    for time in [0.4, 1.9, 3.3, 5.1] {
        run.step_to(time).unwrap();
        let pose = linkage.pose(0.3 + time).unwrap();
        let [crank, coupler, rocker] = ["crank", "coupler", "rocker"].map(|name| run.body(name).unwrap());
        let [of_coupler, of_rocker] = linkage.velocity_ratios(&pose);
        near(coupler.omega, of_coupler, 1e-10);
        near(rocker.omega, of_rocker, 1e-10);
        near(linkage.mechanical_advantage(&pose) * rocker.omega, 1.0, 1e-9);
        let ground = None;
        let (crank, coupler, rocker) = (Some(&crank), Some(&coupler), Some(&rocker));
        let pairs = [
            (ground, crank),
            (crank, coupler),
            (coupler, rocker),
            (ground, rocker),
            (ground, coupler),
            (crank, rocker),
        ];
        for ((one, other), known) in pairs.into_iter().zip(kennedy(&linkage, &pose)) {
            let (Centre::At(found), Centre::At(known)) = (instant_centre(one, other), known) else {
                panic!()
            };
            assert!(
                distance(found, known) < 1e-8 * (1.0 + known[0].abs() + known[1].abs()),
                "{found:?} {known:?}"
            );
        }
    }
}

#[test]
fn one_centrode_rolls_on_the_other() {
    // An antiparallelogram: its centrodes are congruent ellipses (Reuleaux), with sums of distances of the crank's length.
    let linkage = four_bar(0.6, 1.0, 0.6, 1.0);
    let crossed = FourBar { image: Image::Right, ..linkage };
    let found = [linkage, crossed].map(|linkage| {
        let curves = centrodes(&linkage, 361);
        let off = |&[fixed, _]: &[[f64; 2]; 2]| {
            (distance(fixed, [0.0, 0.0]) + distance(fixed, [0.6, 0.0]) - 1.0).abs()
        };
        curves.iter().filter(|pair| off(pair) < 1e-9).count()
    });
    assert!(found.iter().sum::<usize>() > 300, "{found:?}");
    // Arc lengths of both curves agree.
    let curves = centrodes(&four_bar(1.0, 0.3, 0.9, 0.7), 40_000);
    for pair in curves.windows(2) {
        let [fixed, moving] = [0, 1].map(|k| distance(pair[0][k], pair[1][k]));
        assert!((fixed - moving).abs() <= 1e-3 * fixed || fixed > 1.0, "{fixed} {moving}");
    }
}

#[test]
fn slider_crank_limits() {
    let press = SliderCrank { crank: 0.1, rod: 0.3, offset: 0.04 };
    let [(far, most), (near_angle, least)] = press.dead_points().unwrap();
    for (angle, place) in [(far, most), (near_angle, least)] {
        let pose = press.pose(angle, Image::Right).unwrap();
        near(pose.slider, place, 1e-14);
        near(pose.slider_ratio, 0.0, 1e-14);
    }
    near(press.stroke().unwrap(), (0.16_f64 - 0.0016).sqrt() - (0.04_f64 - 0.0016).sqrt(), 1e-14);
    let h = 1e-6;
    let slider = |angle: f64| press.pose(angle, Image::Right).unwrap();
    for k in 0..60 {
        let angle = 0.1 * f64::from(k);
        let difference = (slider(angle + h).slider - slider(angle - h).slider) / (2.0 * h);
        near(slider(angle).slider_ratio, difference, 1e-9);
        assert!(slider(angle).transmission_angle >= press.least_transmission_angle().unwrap() - 1e-12);
    }
    near(slider(-PI / 2.0).transmission_angle, press.least_transmission_angle().unwrap(), 1e-12);
    // Angles between the dead points.
    near(press.time_ratio().unwrap(), (near_angle - far) / (TAU - near_angle + far), 1e-14);
    assert!(!SliderCrank { offset: 0.25, ..press }.turns());
}

#[test]
fn every_image_of_dyads_closes() {
    // A six-bar of Stephenson: a four-bar with a point of its coupler, and a further dyad.
    let given = [[0.0, 0.0], [1.0, 0.0], [0.2, 0.25], [1.5, -0.2]];
    let steps = [
        Build::Pin { from: [2, 1], lengths: [0.9, 0.7] },
        Build::OnBody { body: [2, 4], at: [0.5, 0.4] },
        Build::Pin { from: [5, 3], lengths: [0.8, 0.9] },
    ];
    let all = images(&given, &steps).unwrap();
    assert_eq!(all.len(), 4);
    for points in &all {
        near(distance(points[2], points[4]), 0.9, 1e-14);
        near(distance(points[1], points[4]), 0.7, 1e-14);
        near(distance(points[2], points[5]), 0.5_f64.hypot(0.4), 1e-14);
        near(distance(points[5], points[6]), 0.8, 1e-14);
        near(distance(points[3], points[6]), 0.9, 1e-14);
    }
    let slider = images(
        &[[0.0, 0.0], [1.0, 0.0], [0.1, 0.2]],
        &[Build::OnLine { from: 2, length: 0.3, line: [0, 1] }],
    );
    let ends: Vec<f64> = slider.unwrap().iter().map(|points| points[3][0]).collect();
    near(ends[0], 0.1 + 0.05_f64.sqrt(), 1e-14);
    near(ends[1], 0.1 - 0.05_f64.sqrt(), 1e-14);
    assert!(images(&given, &[Build::Pin { from: [0, 9], lengths: [1.0, 1.0] }]).is_err());
}

#[test]
fn mobility_by_count_and_by_rank() {
    assert_eq!(gruebler(4, 4, 0), 1);
    let revolute = |one: Link, other: Link, x: f64, y: f64| Joint::Revolute([one, other], [x, y]);
    let body = Link::Body;
    let four = [
        revolute(Link::Ground, body(0), 0.0, 0.0),
        revolute(body(0), body(1), 0.3, 0.4),
        revolute(body(1), body(2), 1.1, 0.8),
        revolute(body(2), Link::Ground, 1.0, 0.0),
    ];
    let found = mobility(3, &four).unwrap();
    assert_eq!((found.counted, found.at_pose, found.redundant), (1, 1, 0));
    // A parallel crank with five parallel links moves though the count says 0.
    let parallel = [
        revolute(Link::Ground, body(0), 0.0, 0.0),
        revolute(body(0), body(3), 0.3, 0.4),
        revolute(Link::Ground, body(1), 1.0, 0.0),
        revolute(body(1), body(3), 1.3, 0.4),
        revolute(Link::Ground, body(2), 2.0, 0.0),
        revolute(body(2), body(3), 2.3, 0.4),
    ];
    let found = mobility(4, &parallel).unwrap();
    assert_eq!((found.counted, found.at_pose, found.redundant), (0, 1, 1));
    // Stretched, a four-bar has one more freedom of its velocities.
    let flat = [
        revolute(Link::Ground, body(0), 0.0, 0.0),
        revolute(body(0), body(1), 0.3, 0.0),
        revolute(body(1), body(2), 1.1, 0.0),
        revolute(body(2), Link::Ground, 1.0, 0.0),
    ];
    assert_eq!(mobility(3, &flat).unwrap().at_pose, 2);
    let slotted = [
        Joint::Prismatic([Link::Ground, body(0)], [1.0, 0.0]),
        Joint::PinInSlot([body(0), body(1)], [0.2, 0.5], [0.0, 1.0]),
        revolute(body(1), Link::Ground, 0.0, 0.0),
    ];
    assert_eq!(mobility(2, &slotted).unwrap().at_pose, 1);
    assert_eq!(mobility(1, &slotted), None);
}

#[test]
fn five_bar_poses_and_singularities() {
    let machine = FiveBar { pivots: [[-0.1, 0.0], [0.1, 0.0]], cranks: [0.2, 0.2], bars: [0.3, 0.25] };
    let poses = machine.poses_at([0.05, 0.3]);
    assert_eq!(poses.len(), 4);
    for pose in &poses {
        let back = machine.poses(pose.cranks);
        assert!(back.iter().any(|found| distance(found.pin, [0.05, 0.3]) < 1e-12));
        assert_eq!(pose.singularity(1e-6), None);
    }
    assert!(
        machine.reaches([0.05, 0.3])
            && !machine.reaches([0.6, 0.3])
            && machine.poses_at([0.6, 0.3]).is_empty()
    );
    let held = machine.hold_singularities(360);
    assert!(held.len() > 90, "{}", held.len());
    for pose in held {
        assert!(matches!(pose.singularity(1e-9), Some(Singularity::Hold | Singularity::Both)));
        // Next to it the poses of the same cranks part: the loop of the bars is flat.
        let there = machine.poses_at(pose.pin);
        assert!(
            there
                .iter()
                .any(|found| (0..2).all(|k| (0.5 * (found.cranks[k] - pose.cranks[k])).sin().abs() < 1e-6))
        );
    }
}

#[test]
fn defects_are_named() {
    let rocker = four_bar(1.0, 0.3, 0.9, 0.7);
    let demands = Demands { turns: true, order: true, transmission: 50_f64.to_radians() };
    let on = |angle: f64| (angle, Image::Left);
    assert_eq!(rocker.defects(&[on(0.1), on(1.0), on(2.0)], &Demands { transmission: 0.5, ..demands }), []);
    assert_eq!(
        rocker.defects(
            &[on(0.1), on(2.0), on(1.0), (3.0, Image::Right)],
            &Demands { transmission: 0.5, ..demands }
        ),
        [Defect::Circuit { position: 3 }, Defect::Order { position: 2 }]
    );
    let [least, _] = rocker.transmission_extremes().unwrap();
    assert_eq!(rocker.defects(&[on(0.1)], &demands), [Defect::Transmission { angle: least }]);
    let triple = four_bar(1.0, 0.4, 0.5, 0.6);
    let found = triple
        .defects(&[on(0.2), (0.3, Image::Right), on(2.0)], &Demands { turns: true, ..Demands::default() });
    assert_eq!(
        found,
        [
            Defect::Open { position: 2 },
            Defect::Branch { position: 1 },
            Defect::Crank { class: Some(Class::TripleRocker) }
        ]
    );
}

/// Mobility where a run is.
struct AskMobility;

impl OnRun for AskMobility {
    type Output = MobilityAt;

    fn on<M, I>(self, sim: &mut Sim<M, I>) -> MobilityAt
    where
        M: Described<S = f64> + Statics + Linear<Lifted<1>: Described + Statics>,
        I: Method<M>,
    {
        mobility_at(sim)
    }
}

#[test]
fn mobility_of_texts() {
    let body = "mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m;";
    let crank = |name: &str, x: f64| {
        format!(
            "body {name} {{ {body} port b: (0.3, 0.4) m; start x: {x} m; }}
            revolute low_{name}(ground.{name}, {name}.a);
            revolute high_{name}({name}.b, plate.{name});"
        )
    };
    let text = |third: &str, port: &str, drive: &str| {
        format!(
            "pub Parallel {{
                ground {{ port one: (0, 0) m; port two: (1, 0) m; port three: (2, 0) m; }}
                body plate {{
                    {body} port one: (0, 0) m; port two: (1, 0) m; {port}
                    start x: 0.3 m; start y: 0.4 m;
                }}
                {} {} {third} {drive}
            }}",
            crank("one", 0.0),
            crank("two", 1.0)
        )
    };
    let ask = |text: &str| Mechanism::from_text(text).unwrap().start().unwrap().then(AskMobility);
    let three = crank("three", 2.0);
    let third = "port three: (2, 0) m;";
    let drive = "constraint drive: one.angle = 1 rad/s*t;";
    // Count, freedoms of the velocities, redundant rows.
    for (text, expected) in [
        (text("", "", ""), (1, 1, 0)),
        (text("", "", drive), (0, 0, 0)),
        (text(&three, third, ""), (0, 1, 1)),
        (text(&three, third, drive), (-1, 0, 1)),
    ] {
        let found = ask(&text);
        let Mobility { counted, at_pose, redundant } = found.mobility;
        assert_eq!((counted, at_pose, redundant), expected, "{text}");
        assert_eq!(found.redundant.len(), redundant, "{:?}", found.redundant);
    }
}
