//! Closed forms: parabolas and impacts of a mass of 1 kg under 10 m/s^2, half cycles of a spring of 20 N/m with Coulomb's friction.

use super::Numbers;

const G: f64 = 10.0;
const STIFFNESS: f64 = 20.0;
/// A bounce to a lower speed is none, m/s.
const SLOW: f64 = 1e-7;
/// Nearer to an event than this it is not decided whether it was, s.
const NEAR: f64 = 1e-6;

/// Closed form at a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    /// x, vx, y, vy.
    pub(super) numbers: [f64; 4],
    /// Events until then.
    pub(super) events: usize,
    /// The speed of the last bounce, m/s: infinite before the first one, zero where it rests.
    pub(super) bounce: f64,
    /// It sticks.
    pub(super) sticks: bool,
}

/// A box that bounces with friction, slides and sticks; none near an event.
pub(super) fn bounced(of: &Numbers, t: f64) -> Option<Known> {
    let (mut x, mut vx, mut y, mut vy) = (0.0, of.speed, of.height, 0.0_f64);
    let (mut now, mut events, mut bounce) = (0.0, 0, f64::INFINITY);
    while y > 0.0 || vy > SLOW {
        let fall = (vy + (vy * vy + 2.0 * G * y).sqrt()) / G;
        if (now + fall - t).abs() < NEAR {
            return None;
        }
        if now + fall > t {
            let s = t - now;
            return Some(Known {
                numbers: [x + vx * s, vx, y + vy * s - G * s * s / 2.0, vy - G * s],
                events,
                bounce,
                sticks: false,
            });
        }
        let speed = (vy * vy + 2.0 * G * y).sqrt();
        (x, y, vy, now, events) = (x + vx * fall, 0.0, of.e * speed, now + fall, events + 1);
        bounce = vy;
        vx -= vx.signum() * vx.abs().min(of.mu * (1.0 + of.e) * speed);
    }
    // Sliding to a stop, if it does not stand.
    let (s, brake) = (t - now, of.mu * G);
    let stops = if vx == 0.0 { 0.0 } else { vx.abs() / brake };
    if (stops - s).abs() < NEAR && vx != 0.0 {
        return None;
    }
    let slides = s.min(stops);
    let numbers = [
        x + vx * slides - vx.signum() * brake * slides * slides / 2.0,
        if s < stops { vx - vx.signum() * brake * s } else { 0.0 },
        0.0,
        0.0,
    ];
    Some(Known { numbers, events: events + 1, bounce: 0.0, sticks: s > stops })
}

/// A block on a spring with a friction that is larger while it sticks; none near an event, or where a stop is near that limit.
pub(super) fn slid(of: &Numbers, t: f64) -> Option<Known> {
    let (omega, kinetic, limit) = (STIFFNESS.sqrt(), of.mu * G, of.mu * (1.0 + of.e) * G);
    let (mut x, mut v, mut now, mut events) = (of.height, of.speed, 0.0, 0);
    loop {
        let force = -STIFFNESS * x;
        if v == 0.0 {
            if (force.abs() - limit).abs() < 1e-6 * (1.0 + limit) && limit > 0.0 {
                return None;
            }
            if force.abs() <= limit {
                return Some(Known { numbers: [x, 0.0, 0.0, 0.0], events, bounce: 0.0, sticks: true });
            }
        }
        let side = if v == 0.0 { force.signum() } else { v.signum() };
        let centre = -side * kinetic / STIFFNESS;
        // x = centre + a cos(omega s + phase): it stops where that angle is the next multiple of pi.
        let (a, phase) =
            (((x - centre).powi(2) + (v / omega).powi(2)).sqrt(), (-v / omega).atan2(x - centre));
        let turns = std::f64::consts::PI;
        let next = if v == 0.0 { turns } else { ((phase / turns).floor() + 1.0) * turns - phase };
        let lasts = next / omega;
        if (now + lasts - t).abs() < NEAR {
            return None;
        }
        if now + lasts > t {
            let angle = omega * (t - now) + phase;
            let numbers = [centre + a * angle.cos(), -a * omega * angle.sin(), 0.0, 0.0];
            return Some(Known { numbers, events, bounce: f64::INFINITY, sticks: false });
        }
        (x, v, now, events) = (centre + a * (omega * lasts + phase).cos(), 0.0, now + lasts, events + 1);
    }
}

/// A ball that is thrown back with a part of both speeds; none near an event, and where these accumulate.
pub(super) fn thrown_back(of: &Numbers, t: f64) -> Option<Known> {
    let (mut x, mut vx, mut y, mut vy) = (0.0, of.speed, of.height, 0.0_f64);
    let (mut now, mut events) = (0.0, 0);
    loop {
        let fall = (vy + (vy * vy + 2.0 * G * y).sqrt()) / G;
        if (now + fall - t).abs() < NEAR || fall < 1e-3 {
            return None;
        }
        if now + fall > t {
            let s = t - now;
            return Some(Known {
                numbers: [x + vx * s, vx, y + vy * s - G * s * s / 2.0, vy - G * s],
                events,
                bounce: f64::INFINITY,
                sticks: false,
            });
        }
        let speed = (vy * vy + 2.0 * G * y).sqrt();
        (x, y, vy, now, events) = (x + vx * fall, 0.0, of.e * speed, now + fall, events + 1);
        vx *= 1.0 - of.mu;
    }
}
