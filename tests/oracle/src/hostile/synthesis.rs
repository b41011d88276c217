//! `plm::synthesis` with hostile numbers.

use std::hint::black_box;

use plm_studies::synthesis::balance::{balance_spring, counterweights};
use plm_studies::synthesis::function::{Pair, Scales, chebyshev, generators};
use plm_studies::synthesis::kinematics::{
    Build, FiveBar, Joint, Link, Loop, SliderCrank, centrodes, images, kennedy, loop_images, mobility,
};
use plm_studies::synthesis::motion::{
    BodyPose, Dyad, burmester_curves, centre_point, circle_point, five_pose_dyads, guides,
};
use plm_studies::synthesis::path::{self, Crank, Path, Timing};
use plm_studies::synthesis::six_bar::{self, Chain, Task};
use plm_studies::synthesis::{Demands, FourBar, Image, LinkMass};

use super::{Call, Hostile, Outcome, refusing};

pub(super) const CALLS: &[Call] = &[
    Call { name: "synthesis::function", call: function },
    Call { name: "synthesis::motion", call: dyads },
    Call { name: "synthesis::motion::three", call: three_poses },
    Call { name: "synthesis::path", call: path },
    Call { name: "synthesis::six_bar", call: six_bar },
    Call { name: "synthesis::loops", call: loops },
    Call { name: "synthesis::four_bar", call: four_bar },
    Call { name: "synthesis::kinematics", call: kinematics },
];

fn pairs(h: &mut Hostile, count: usize) -> Vec<Pair> {
    (0..count).map(|_| Pair { crank: h.number(), rocker: h.number() }).collect()
}

fn function(h: &mut Hostile) -> Outcome {
    let (count, scales) = *h.draw.one_of(&[
        (3, Scales::Given),
        (6, Scales::Given),
        (4, Scales::FreeCrank),
        (5, Scales::FreeBoth),
    ]);
    let pairs = pairs(h, count);
    refusing(generators(&pairs, h.within(0.1, 2.0), scales))
}

fn poses(h: &mut Hostile, count: usize) -> Vec<BodyPose> {
    (0..count).map(|_| BodyPose { place: h.numbers(), angle: h.number() }).collect()
}

fn dyads(h: &mut Hostile) -> Outcome {
    let found = five_pose_dyads(&poses(h, 5));
    if let Ok(found) = &found {
        black_box(guides(&poses(h, 5), found, &demands(h)));
        return Outcome::Done;
    }
    refusing(found)
}

fn three_poses(h: &mut Hostile) -> Outcome {
    let (three, four) = (poses(h, 3), poses(h, 4));
    let centre = centre_point(&three, h.numbers());
    let circle = circle_point(&three, h.numbers());
    if let (Ok(Some(centre)), Ok(Some(circle))) = (&centre, &circle) {
        let both: [Dyad; 2] = [*centre, *circle];
        black_box(both.map(|dyad| dyad.deviations(&three)));
    }
    if centre.is_err() || circle.is_err() {
        return refusing(centre.and(circle));
    }
    refusing(burmester_curves(&four, h.numbers(), 5))
}

fn timing(h: &mut Hostile, count: usize) -> Timing {
    let angles = (0..count).map(|_| h.number()).collect();
    match h.draw.below(3) {
        0 => Timing::Given(angles),
        1 => Timing::Steps(angles),
        _ => Timing::Given((0..count).map(|k| k as f64).collect()),
    }
}

const FEW: path::Search = path::Search { starts: 3, seed: 1, keep: 1 };

fn path(h: &mut Hostile) -> Outcome {
    let points = (0..4).map(|_| h.numbers()).collect();
    let mut bounds = path::Bounds::up_to(h.within(0.5, 3.0));
    bounds.ground_angle = h.numbers();
    if h.draw.chance(0.3) {
        bounds.point = [h.numbers(), h.numbers()];
        bounds.lengths[h.draw.below(4)] = h.numbers();
    }
    let crank = *h.draw.one_of(&[Crank::Turns, Crank::Any]);
    let path = Path { points, timing: timing(h, 4), bounds, crank, transmission: h.within(0.0, 1.0) };
    refusing(path.search(&FEW))
}

fn six_bar(h: &mut Hostile) -> Outcome {
    let chain = *h.draw.one_of(&[
        Chain::WattOne,
        Chain::WattTwo,
        Chain::StephensonOne,
        Chain::StephensonThree,
        Chain::StephensonTwo,
    ]);
    let task = if h.draw.chance(0.5) {
        Task::Function { pairs: pairs(h, 4), scales: Scales::Given }
    } else {
        Task::Path { points: (0..4).map(|_| h.numbers()).collect(), timing: timing(h, 4) }
    };
    let bounds = six_bar::Bounds::up_to(h.within(0.5, 3.0));
    let problem =
        six_bar::Problem { chain, task, bounds, crank: Crank::Turns, transmission: h.within(0.0, 1.0) };
    refusing(problem.search(&FEW))
}

fn loops(h: &mut Hostile) -> Outcome {
    let two = |h: &mut Hostile, of: [usize; 3]| Loop {
        vectors: of.map(|body| (body, h.numbers())).into(),
        known: h.numbers(),
    };
    let loops = if h.draw.chance(0.5) {
        vec![Loop { vectors: vec![(0, h.numbers()), (1, h.numbers())], known: h.numbers() }]
    } else {
        vec![two(h, [0, 1, 2]), two(h, [0, 2, 3])]
    };
    refusing(loop_images(&loops))
}

fn linkage(h: &mut Hostile) -> FourBar {
    let [crank, coupler, rocker] = [(); 3].map(|()| h.within(0.2, 2.0));
    let image = *h.draw.one_of(&[Image::Left, Image::Right]);
    FourBar { pivots: [h.numbers(), h.numbers()], crank, coupler, rocker, point: h.numbers(), image }
}

fn demands(h: &mut Hostile) -> Demands {
    Demands { turns: h.draw.chance(0.5), order: h.draw.chance(0.5), transmission: h.number() }
}

fn four_bar(h: &mut Hostile) -> Outcome {
    let own = linkage(h);
    black_box((
        own.class(),
        own.crank_limits(),
        own.rocker_limits(),
        own.transmission_extremes(),
        own.lengths(),
    ));
    black_box((own.ground_angle(), own.images(h.number()), own.curve(7), centrodes(&own, 7)));
    let positions: Vec<(f64, Image)> = h.list(5).into_iter().map(|angle| (angle, own.image)).collect();
    black_box(own.defects(&positions, &demands(h)));
    if let Some(pose) = own.pose(h.number()) {
        let _ = black_box((
            FourBar::transmission_angle(&pose),
            own.velocity_ratios(&pose),
            own.mechanical_advantage(&pose),
        ));
        black_box(kennedy(&own, &pose));
    }
    let mass = LinkMass { mass: h.number(), inertia: h.number(), centre: h.numbers() };
    for weight in counterweights(&own, &[mass; 3]) {
        black_box(weight.added_to(&mass, h.number()));
    }
    black_box(own.declaration("Own", h.number()));
    black_box(own.declaration_with_masses("Own", h.number(), &[mass; 3]));
    black_box(balance_spring(h.number(), h.numbers(), h.number(), h.number(), h.number()));
    Outcome::Done
}

fn kinematics(h: &mut Hostile) -> Outcome {
    black_box(chebyshev(5, h.number(), h.number()));
    let slider = SliderCrank { crank: h.number(), rod: h.number(), offset: h.number() };
    black_box((slider.pose(h.number(), Image::Left), slider.turns(), slider.dead_points(), slider.stroke()));
    black_box((slider.time_ratio(), slider.least_transmission_angle()));
    let five = FiveBar { pivots: [h.numbers(), h.numbers()], cranks: h.numbers(), bars: h.numbers() };
    black_box((
        five.poses(h.numbers()),
        five.poses_at(h.numbers()),
        five.reaches(h.numbers()),
        five.reach_circles(),
    ));
    black_box(five.hold_singularities(9));
    let pin = Joint::Revolute([Link::Ground, Link::Body(0)], h.numbers());
    black_box(mobility(2, &[pin, Joint::Revolute([Link::Body(0), Link::Body(1)], h.numbers())]));
    let given = [h.numbers(), h.numbers(), h.numbers()];
    let steps = [
        Build::Pin { from: [0, 1], lengths: h.numbers() },
        Build::OnLine { from: 2, length: h.number(), line: [0, 1] },
        Build::OnBody { body: [0, 1], at: h.numbers() },
    ];
    let _ = black_box(images(&given, &steps));
    Outcome::Done
}
