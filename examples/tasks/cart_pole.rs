//! Which gains hold a pole upright on a cart, and how far does the cart go from 20 degrees?
use std::error::Error;

use nalgebra::{Matrix4, RowVector4, Vector4};

use super::{Answer, Answers};

plm::mechanism! {
    pub Cart {
        gravity: 9.81 m/s^2;
        /// Force of the motor on the cart.
        input push: N = 0 N;
        ground { port rail: (0, 0) m; }
        body cart { mass: 1 kg; inertia: 0.01 kg*m^2; port rail: (0, 0) m; port hinge: (0, 0) m; start x: 0 m, locked; }
        body pole { mass: 0.2 kg; inertia: rod(0.2 kg, 0.6 m); port hinge: (0, -0.3) m; start angle: 0 deg, locked; }
        prismatic rail(ground.rail, cart.rail) { drive: push; }
        revolute hinge(cart.hinge, pole.hinge);
    }
}

/// State feedback with four poles at `pole`, by Ackermann's formula.
fn gains(pole: f64) -> Result<RowVector4<f64>, Box<dyn Error>> {
    let system = plm::linearise(&Cart::new().start()?)?;
    let a = Matrix4::from_iterator(system.a.iter().copied());
    let b = Vector4::from_iterator(system.b.iter().copied());
    let reached = Matrix4::from_columns(&[b, a * b, a * a * b, a * a * a * b]);
    let inverse = reached.try_inverse().ok_or("the motor cannot move all states")?;
    let shifted = a - Matrix4::identity() * pole;
    Ok(inverse.row(3) * (shifted * shifted) * (shifted * shifted))
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let gains = gains(-4.0)?;
    let mut cart = Cart::new();
    cart.start.pole.angle.value = 20_f64.to_radians();
    let mut sim = cart.start()?;
    let (mut farthest, mut strongest, mut settled) = (0.0_f64, 0.0_f64, 0.0);
    for _ in 0..1000 {
        // A controller that samples at 200 Hz.
        let (cart, pole) = (sim.cart(), sim.pole());
        sim.input.push = -(gains * Vector4::new(cart.x, pole.angle, cart.vx, pole.omega))[0];
        farthest = farthest.max(cart.x.abs());
        strongest = strongest.max(sim.input.push.abs());
        sim.step(5e-3)?;
        settled = if sim.pole().angle.abs() > 0.5_f64.to_radians() { sim.time() } else { settled };
    }
    Ok(vec![
        Answer::new("gain of the place", gains[0], "N/m"),
        Answer::new("gain of the angle", gains[1], "N/rad"),
        Answer::new("gain of the cart's speed", gains[2], "N*s/m"),
        Answer::new("gain of the pole's rate", gains[3], "N*s/rad"),
        Answer::new("the cart goes by up to", farthest, "m"),
        Answer::new("the motor gives up to", strongest, "N"),
        Answer::new("within half a degree from", settled, "s"),
    ])
}
