//! Impacts in corners: those that rigid bodies leave open, with several outcomes or impulses that rows share in many ways, and gaps that
//! close at one moment because others are closed.

use plm_runtime::contact::{self, ImpactLaw, Law, Limit, Modes, Outcome, Rows};
use plm_runtime::{Dop853, Mechanism, Scalar};

use crate::bodies::{inverse_mass, point};
use crate::support::{Row, Scene, system};

/// A body of 1 kg and 1 kg m^2 in a corner, which touches the floor and the wall in two of its points: x, y, angle.
#[derive(Clone, Copy, Debug)]
struct Corner {
    /// The points that touch floor and wall, seen from G, m.
    points: [[f64; 2]; 2],
    velocity: [f64; 3],
    friction: f64,
    /// Coefficients of restitution at floor and wall.
    restitution: [f64; 2],
    law: ImpactLaw,
}

impl Corner {
    /// Directions of the gap and the slip at the floor, then at the wall.
    fn directions(&self) -> [[f64; 3]; 4] {
        let [floor, wall] = self.points;
        [[0.0, 1.0, floor[0]], [1.0, 0.0, -floor[1]], [1.0, 0.0, -wall[1]], [0.0, 1.0, wall[0]]]
    }
}

impl Scene<3, 4> for Corner {
    fn laws(&self) -> [Law<f64>; 4] {
        let [floor, wall] = self.restitution.map(|restitution| Law::Unilateral { restitution });
        [floor, Law::Friction, wall, Law::Friction]
    }
    fn impacts(&self) -> ImpactLaw {
        self.law
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        [T::ZERO; 3]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], _v: [T; 3]) -> [Row<T, 3>; 4] {
        self.directions().map(|w| {
            let w = w.map(T::lit);
            Row::fixed(w[0] * q[0] + w[1] * q[1] + w[2] * q[2], w)
        })
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3], rows: &mut Rows<T, 4>) {
        rows.set_friction(1, Limit::of(0, T::lit(self.friction)));
        rows.set_friction(3, Limit::of(2, T::lit(self.friction)));
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        ([0.0; 3], self.velocity)
    }
}

system!(Corner, 3, 4);

fn outcome(corner: &Corner) -> Outcome {
    let (mut modes, [vx, vy, omega]) = (Modes::open(), corner.velocity);
    let mut x = [0.0, 0.0, 0.0, vx, vy, omega];
    contact::begin::<_, 4>(corner, 0.0, &mut modes, &mut x).unwrap()
}

/// A body that comes into a corner with as much friction as push.
const WEDGED: Corner = Corner {
    points: [[-1.5, -2.0], [-1.0, -0.5]],
    velocity: [-1.0, -2.0, -0.5],
    friction: 1.0,
    restitution: [0.0; 2],
    law: ImpactLaw::Poisson,
};

/// Three sets of impulses satisfy all laws: at the wall alone, at the floor alone, at both while both slip.
#[test]
fn a_corner_with_three_outcomes_is_told() {
    let all = [[0.0, 0.0, 13.0 / 9.0, 10.0 / 9.0], [49.0 / 29.0, 41.0 / 29.0, 0.0, 0.0], [0.625; 4]];
    let w = WEDGED.directions();
    let rate = |row: usize, impulses: &[f64; 4]| -> f64 {
        let along = |i: usize| WEDGED.velocity[i] + (0..4).map(|j| w[j][i] * impulses[j]).sum::<f64>();
        (0..3).map(|i| w[row][i] * along(i)).sum()
    };
    for impulses in &all {
        for gap in [0, 2] {
            let (push, rub, [opens, slips]) =
                (impulses[gap], impulses[gap + 1], [gap, gap + 1].map(|row| rate(row, impulses)));
            assert!(push >= 0.0 && opens > -1e-12 && (push * opens).abs() < 1e-12, "{impulses:?}");
            let sticks = slips.abs() < 1e-12 && rub.abs() <= push;
            assert!(sticks || (rub + push * slips.signum()).abs() < 1e-12, "{impulses:?} {slips}");
        }
    }
    assert!(outcome(&WEDGED).doubts.is_ambiguous);
    let calm = Corner { friction: 0.3, ..WEDGED };
    assert!(!outcome(&calm).doubts.is_ambiguous && !outcome(&calm).doubts.is_undetermined);
}

/// A point that comes into a corner at 45 deg: its momentum along the floor is taken by the wall and by the friction of the floor, in
/// any shares. With a restitution at the wall they decide how it goes on.
#[test]
fn a_stop_beside_a_friction_that_sticks_is_told() {
    let point = Corner {
        points: [[0.0; 2]; 2],
        velocity: [-1.0, -1.0, 0.0],
        friction: 0.5,
        restitution: [0.0, 0.5],
        law: ImpactLaw::Poisson,
    };
    assert!(outcome(&point).doubts.is_undetermined);
    // What gives nothing back, and what does not rub, is determined.
    for determined in [Corner { restitution: [0.0; 2], ..point }, Corner { friction: 0.0, ..point }] {
        let outcome = outcome(&determined);
        assert!(outcome.impacts > 0 && !outcome.doubts.is_undetermined, "{outcome:?}");
    }
}

/// Both ends of a beam strike the floor at once: one after the other, the order decides how it goes on.
#[test]
fn what_is_struck_at_once_has_no_order() {
    let beam = |velocity: [f64; 3], law: ImpactLaw| {
        let mut corner = Corner { velocity, law, friction: 0.0, restitution: [0.5; 2], ..WEDGED };
        // The second row is turned into another one of the floor by its point.
        corner.points = [[-1.0, -1.0], [-1.0, -1.0]];
        outcome(&corner).doubts.is_ambiguous
    };
    // Floor: vy - w, wall: vx + w.
    assert!(beam([-1.0, -1.0, 0.0], ImpactLaw::Sequential));
    assert!(!beam([-1.0, -2.0, 0.0], ImpactLaw::Sequential));
    assert!(!beam([-1.0, -1.0, 0.0], ImpactLaw::Poisson));
}

/// Half the width and half the height of a plate, m, and the force that presses it into the corner of a floor and a wall, N.
const HALF: [f64; 2] = [0.4, 0.3];
const PRESS: [f64; 2] = [-30.0, -50.0];
const TILT: f64 = 0.1;

/// A plate of 1 kg and 0.2 kg m^2 that slides into a corner without friction: its toe is on the floor and its heel at the wall. The heel
/// comes to the floor and the corner above it to the wall when it is level, both at one moment by geometry.
#[derive(Clone, Copy, Debug)]
struct Plate;

impl Scene<3, 4> for Plate {
    fn laws(&self) -> [Law<f64>; 4] {
        [Law::Unilateral { restitution: 0.0 }; 4]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        [T::lit(PRESS[0]), T::lit(PRESS[1]), T::ZERO]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 3]) -> [[T; 3]; 3] {
        inverse_mass(0.2)
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], v: [T; 3]) -> [Row<T, 3>; 4] {
        let [w, h] = HALF;
        let (floor, wall) = ([0.0, 1.0], [1.0, 0.0]);
        [([w, -h], floor), ([-w, -h], wall), ([-w, -h], floor), ([-w, h], wall)].map(|(at, normal)| {
            let [gap, _] = point(q, v, at, normal);
            gap
        })
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        let ([w, h], (sin, cos)) = (HALF, TILT.sin_cos());
        ([w * cos + h * sin, h * cos + w * sin, -TILT], [0.0; 3])
    }
}

system!(Plate, 3, 4);

/// One impact, which all of the energy goes into: the work of the forces until there. With a tolerance that lets the rows at rest drift
/// both gaps close at one moment all the same.
#[test]
fn gaps_that_close_together_by_geometry_are_one_impact() {
    let [w, h] = HALF;
    let ([x, y, _], _) = Scene::start(&Plate);
    for tolerance in [1e-6, 1e-7, 3e-8, 3e-9, 1e-9, 1e-11] {
        let mut sim = Plate.start_with(Dop853::new(tolerance)).unwrap();
        let before = sim.stats().switches;
        sim.step_to(0.056).unwrap();
        let [vx, vy, omega] = [3, 4, 5].map(|i| sim.x[i]);
        let energy = 0.5 * (vx * vx + vy * vy + 0.2 * omega * omega);
        let work = PRESS[0] * (sim.x[0] - x) + PRESS[1] * (sim.x[1] - y);
        assert!((energy - work).abs() < 10.0 * tolerance, "{tolerance:e}: {energy} {work}");
        assert!(omega > 1.0 && sim.stats().switches == before, "{tolerance:e}: {omega}");
        sim.step_to(0.1).unwrap();
        assert_eq!(sim.stats().switches - before, 1, "{tolerance:e}: {:?}", sim.x);
        for (i, rest) in [w, h, 0.0, 0.0, 0.0, 0.0].into_iter().enumerate() {
            assert!((sim.x[i] - rest).abs() < 1e-14, "{tolerance:e}: {:?}", sim.x);
        }
    }
}
