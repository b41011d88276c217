//! A four-bar whose crank is led, with friction in all pins: the balance of each body, with the reactions of four pins and a torque as unknowns.

use super::{GRAVITY, Machine, friction_error};
use crate::draw::Draw;

/// Coefficient of friction times the radius of the pins, m.
struct Pins {
    lever: f64,
    lengths: [f64; 3],
    masses: [f64; 3],
    inertias: [f64; 3],
}

/// Crank, coupler, rocker; a Grashof chain with the shortest crank.
pub(super) fn machine(draw: &mut Draw) -> Machine {
    let crank = draw.number(0.05, 0.1, &[0.08]);
    let lengths = [crank, draw.number(0.25, 0.3, &[0.28]), draw.number(0.22, 0.27, &[0.25])];
    let base = 0.3;
    let masses = [0; 3].map(|_| draw.number(0.2, 3.0, &[1.0]));
    let inertias: [f64; 3] = std::array::from_fn(|k| masses[k] * lengths[k] * lengths[k] / 12.0);
    let friction = draw.number(0.02, 0.3, &[0.1]);
    let radius = draw.number(0.005, 0.015, &[0.01]);
    let body = |k: usize, name: &str, ports: [&str; 2], more: &str| {
        let half = 0.5 * lengths[k];
        format!(
            "body {name} {{ mass: {:?} kg; inertia: {:?} kg*m^2; port {}: ({:?}, 0) m; port {}: ({half:?}, 0) m; {more} }}",
            masses[k], inertias[k], ports[0], -half, ports[1]
        )
    };
    let pin = |of: &str| format!("{of} {{ friction: {friction:?}; pin_diameter: {:?} m; }}", 2.0 * radius);
    let text = format!(
        "pub FourBar {{
    FORMULATION
    gravity: {GRAVITY} m/s^2;
    ground {{ port a: (0, 0) m; port d: ({base:?}, 0) m; }}
    {}
    {}
    {}
    {}
    {}
    {}
    {}
    constraint motor: crank.angle = 60 deg + MOTION;
    output drive = -reaction(motor), pin_a.friction_torque, pin_b.friction_torque, pin_c.friction_torque, pin_d.friction_torque;
    output crank.angle, crank.omega, crank.alpha, crank.ax, crank.ay;
    output coupler.angle, coupler.omega, coupler.alpha, coupler.ax, coupler.ay;
    output rocker.angle, rocker.omega, rocker.alpha, rocker.ax, rocker.ay;
}}",
        body(0, "crank", ["a", "b"], "start angle: 60 deg;"),
        body(1, "coupler", ["b", "c"], "start angle: 20 deg;"),
        body(2, "rocker", ["d", "c"], "start angle: 100 deg;"),
        pin("revolute pin_a(ground.a, crank.a)"),
        pin("revolute pin_b(crank.b, coupler.b)"),
        pin("revolute pin_c(coupler.c, rocker.c)"),
        pin("revolute pin_d(ground.d, rocker.d)"),
    );
    let pins = Pins { lever: friction * radius, lengths, masses, inertias };
    let rubbed = ["a", "b", "c", "d"].map(|pin| format!("pin_{pin}.friction_torque"));
    let moved = ["crank", "coupler", "rocker"]
        .map(|body| ["angle", "omega", "alpha", "ax", "ay"].map(|what| format!("{body}.{what}")));
    let outputs = ["drive".to_owned()].into_iter().chain(rubbed).chain(moved.into_iter().flatten()).collect();
    Machine { family: "four-bar", text, outputs, error: Box::new(move |of| error(&pins, of)) }
}

/// Unknowns: the forces of the pins a, b, c, d on the second body of each, x and y, and the torque on the crank.
fn error(pins: &Pins, of: &[f64]) -> f64 {
    let (Some(drive), Some(rubbed)) = (of.first(), of.get(1..5)) else { return f64::NAN };
    let bodies: Vec<&[f64]> = of[5..].chunks(5).collect();
    // By body: its two pins, each at the left or the right end, with the sign of its force there.
    let at =
        [[(0, -1.0, 1.0), (1, 1.0, -1.0)], [(1, -1.0, 1.0), (2, 1.0, -1.0)], [(3, -1.0, 1.0), (2, 1.0, 1.0)]];
    let mut rows = [[0.0; 10]; 9];
    let mut size: f64 = 0.0;
    for (k, ends) in at.iter().enumerate() {
        let &[angle, _, alpha, ax, ay] = bodies[k] else { return f64::NAN };
        let (sin, cos) = angle.sin_cos();
        let half = 0.5 * pins.lengths[k];
        for &(pin, end, sign) in ends {
            rows[3 * k][2 * pin] += sign;
            rows[3 * k + 1][2 * pin + 1] += sign;
            rows[3 * k + 2][2 * pin] -= sign * end * half * sin;
            rows[3 * k + 2][2 * pin + 1] += sign * end * half * cos;
            rows[3 * k + 2][9] -= sign * rubbed[pin];
        }
        rows[3 * k][9] += pins.masses[k] * ax;
        rows[3 * k + 1][9] += pins.masses[k] * (ay + GRAVITY);
        rows[3 * k + 2][9] += pins.inertias[k] * alpha;
        size += pins.masses[k] * half * (ax.hypot(ay) + GRAVITY) + pins.inertias[k] * alpha.abs();
    }
    rows[2][8] = 1.0;
    let Some(found) = solved(rows) else { return f64::NAN };
    let omega = [0.0, bodies[0][1], bodies[1][1], bodies[2][1]];
    let rates = [omega[1], omega[2] - omega[1], omega[3] - omega[2], omega[3]];
    let frictions = (0..4).map(|pin| {
        let bound = pins.lever * found[2 * pin].hypot(found[2 * pin + 1]);
        friction_error(rubbed[pin], bound, rates[pin])
    });
    (frictions.sum::<f64>() + (drive - found[8]).abs()) / size
}

/// C. F. Gauss's elimination with the largest pivot of each column.
fn solved(mut rows: [[f64; 10]; 9]) -> Option<[f64; 9]> {
    for column in 0..9 {
        let pivot = (column..9).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()))?;
        rows.swap(column, pivot);
        let first = rows[column];
        for (k, row) in rows.iter_mut().enumerate() {
            let factor = row[column] / first[column];
            if k != column {
                row.iter_mut().zip(first).for_each(|(entry, first)| *entry -= factor * first);
            }
        }
    }
    Some(std::array::from_fn(|k| rows[k][9] / rows[k][k]))
}
