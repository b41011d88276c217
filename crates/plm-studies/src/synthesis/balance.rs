//! Balancing: counterweights of a four-bar, and springs that hold a link in any pose.

use crate::synthesis::four_bar::{FourBar, LinkMass, Point, Vector, point, vector};

/// Counterweight of a link: its mass moment about the pivot of the link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counterweight {
    /// Mass times place in the frame of the link at its pivot, kg m.
    pub moment: Point,
}

impl Counterweight {
    /// Place of the counterweight in the frame of the link, m, if it has a mass, kg.
    pub fn place(&self, mass: f64) -> Point {
        self.moment.map(|moment| moment / mass)
    }

    /// The link with the counterweight, a point mass, kg: the sum of masses, the common centre, and the inertia about it.
    pub fn added_to(&self, link: &LinkMass, mass: f64) -> LinkMass {
        let (own, other) = (vector(link.centre), vector(self.place(mass)));
        let sum = link.mass + mass;
        let centre = (own * link.mass + other * mass) / sum;
        // Steiner's theorem.
        let inertia =
            link.inertia + link.mass * (own - centre).norm_sqr() + mass * (other - centre).norm_sqr();
        LinkMass { mass: sum, inertia, centre: point(centre) }
    }
}

/// Counterweights of crank and rocker with which the centre of gravity of a four-bar rests, so that its shaking force is zero at any
/// motion (Berkof and Lowen, A new method for completely force balancing simple linkages, J. Eng. Ind. 91, 1969).
///
/// The loop `r2 e2 + r3 e3 = r1 + r4 e4` expresses the direction of the coupler by those of crank and rocker. What remains of the sum of
/// the mass moments at e2 and e4 is made zero: with the coupler's centre s from its pin with the crank,
/// `m2 s2 = m3 (r2/r3)(s - r3)` and `m4 s4 = -m3 (r4/r3) s`.
pub fn counterweights(four_bar: &FourBar, masses: &[LinkMass; 3]) -> [Counterweight; 2] {
    let [_, crank, coupler, rocker] = four_bar.lengths();
    let [of_crank, of_coupler, of_rocker] = masses;
    let moment = |link: &LinkMass| vector(link.centre) * link.mass;
    let centre = vector(of_coupler.centre);
    let at_crank = (centre - coupler) * (of_coupler.mass * crank / coupler) - moment(of_crank);
    let at_rocker = -centre * (of_coupler.mass * rocker / coupler) - moment(of_rocker);
    [at_crank, at_rocker].map(|moment| Counterweight { moment: point(moment) })
}

/// Spring whose free length is zero, between a point above the pivot of a link and a point of the link on the ray from the pivot through
/// the centre of gravity. It holds the link in any pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BalanceSpring {
    /// Height of its upper end over the pivot, m.
    pub height: f64,
    /// Its end in the frame of the link at its pivot, m.
    pub end: Point,
    /// Stiffness, N/m.
    pub stiffness: f64,
}

/// Spring that balances a link of a mass, kg, with its centre of gravity at a place of its frame at its pivot, m, under gravity, m/s^2: at
/// a height over the pivot, and at a distance from the pivot, m. With the stiffness `m g s / (height arm)` the torque of the spring,
/// `k height arm sin`, is that of the weight, `m g s sin`, at every angle from the vertical (Carwardine's anglepoise, 1932).
/// `None` if the centre of gravity is at the pivot: there is no weight to balance.
pub fn balance_spring(
    mass: f64,
    centre: Point,
    gravity: f64,
    height: f64,
    arm: f64,
) -> Option<BalanceSpring> {
    let centre: Vector = vector(centre);
    let distance = centre.norm();
    (distance > 0.0).then(|| BalanceSpring {
        height,
        end: point(centre * (arm / distance)),
        stiffness: mass * gravity * distance / (height * arm),
    })
}
