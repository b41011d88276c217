//! Impacts that rigid bodies leave open: corners with several outcomes, impulses that rows share in many ways.

use plm_runtime::Scalar;
use plm_runtime::contact::{self, ImpactLaw, Law, Limit, Modes, Outcome, Rows};

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
