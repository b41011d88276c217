//! Instant centres and centrodes.

use plm_runtime::BodyState;

use crate::synthesis::four_bar::{FourBar, Point, Pose, Vector, point, unit, vector};

/// Instant centre of two bodies: the point at which both have one velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Centre {
    /// A point, m.
    At(Point),
    /// At infinity: the bodies move along each other without turning; the unit vector of their relative velocity.
    AtInfinity(Point),
    /// The bodies do not move against each other.
    AtRest,
}

/// Instant centre of two bodies by their velocities, in whatever mechanism they are. `None` for a body is the ground.
///
/// Rates below 1e-12 of the larger one count as equal.
pub fn instant_centre(one: Option<&BodyState<f64>>, other: Option<&BodyState<f64>>) -> Centre {
    let zero = Vector::from(0.0);
    let i = Vector::new(0.0, 1.0);
    // Velocity at the origin of the plane, if the body reached there, and the rate of turning.
    let motion = |body: Option<&BodyState<f64>>| {
        body.map_or((zero, 0.0), |b| (Vector::new(b.vx, b.vy) - i * Vector::new(b.x, b.y) * b.omega, b.omega))
    };
    let ((v, rate), (w, other_rate)) = (motion(one), motion(other));
    let (turning, moving) = (rate - other_rate, v - w);
    if turning.abs() > 1e-12 * rate.abs().max(other_rate.abs()) {
        return Centre::At(point(i * moving / turning));
    }
    let speed = moving.norm();
    if speed > 1e-12 * v.norm().max(w.norm()) {
        Centre::AtInfinity(point(moving / speed))
    } else {
        Centre::AtRest
    }
}

/// All six instant centres of a four-bar by the theorem of Kennedy and Aronhold: three bodies have their centres on one line. In the order
/// ground–crank, crank–coupler, coupler–rocker, ground–rocker, ground–coupler, crank–rocker.
pub fn kennedy(four_bar: &FourBar, pose: &Pose) -> [Centre; 6] {
    let [[pivot, other_pivot], [pin, other_pin]] = [four_bar.pivots, pose.pins];
    let of_coupler = crossing([pivot, pin], [other_pivot, other_pin]);
    let of_rocker = crossing([pivot, other_pivot], [pin, other_pin]);
    let [pivot, pin, other_pin, other_pivot] = [pivot, pin, other_pin, other_pivot].map(Centre::At);
    [pivot, pin, other_pin, other_pivot, of_coupler, of_rocker]
}

/// Crossing of the lines through two pairs of points; of parallel ones it lies at infinity, across their direction of motion.
fn crossing(one: [Point; 2], other: [Point; 2]) -> Centre {
    let [a, b] = one.map(vector);
    let [c, d] = other.map(vector);
    let (along, across) = (b - a, d - c);
    let determinant = (along.conj() * across).im;
    if determinant.abs() <= 1e-12 * along.norm() * across.norm() {
        return Centre::AtInfinity(point(Vector::new(0.0, 1.0) * along / along.norm()));
    }
    Centre::At(point(a + along * (((c - a).conj() * across).im / determinant)))
}

/// Centrodes of a coupler at so many angles of the crank: the instant centre of coupler and ground, on the ground and in the frame of the
/// coupler at its pin with the crank, m. The coupler moves as if the second rolled on the first. Poses whose centre is at infinity are
/// left out.
pub fn centrodes(four_bar: &FourBar, count: usize) -> Vec<[Point; 2]> {
    let Some(limits) = four_bar.crank_limits() else { return Vec::new() };
    let (from, to) = limits.range();
    let first = four_bar.ground_angle() + from;
    let pair = |k: usize| {
        let pose = four_bar.pose(first + (to - from) * k as f64 / count as f64)?;
        let Centre::At(centre) = kennedy(four_bar, &pose)[4] else { return None };
        let moving = (vector(centre) - vector(pose.pins[0])) * unit(-pose.angles[1]);
        Some([centre, point(moving)])
    };
    (0..count).filter_map(pair).collect()
}
