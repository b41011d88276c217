//! Rows of contact of mechanisms from text, up to the most that there is room for.

use plm::dynamic::Mechanism;

use crate::near;

/// A wheel of spokes without a rim, of a mass of 1 kg with the inertia `INERTIA` and a radius of 1 m, on a slope. It begins on a spoke that is
/// perpendicular to the slope.
struct Wheel {
    spokes: u32,
    slope: f64,
    omega: f64,
}

const INERTIA: f64 = 0.5;
const GRAVITY: f64 = 9.81;

impl Wheel {
    /// Half of the angle between spokes.
    fn half(&self) -> f64 {
        core::f64::consts::PI / f64::from(self.spokes)
    }

    /// The declaration, with `items` beside.
    fn text(&self, items: &str) -> String {
        let Wheel { slope, omega, .. } = self;
        let corner = |k: u32| {
            let (sin, cos) = (2.0 * f64::from(k) * self.half()).sin_cos();
            format!("({sin:?}, {:?})", -cos)
        };
        let corners = (0..self.spokes).map(corner).collect::<Vec<_>>().join(", ");
        format!(
            "pub Rim {{ gravity: {GRAVITY} m/s^2*(sin({slope} rad), -cos({slope} rad)); allow(W0002, W0007);
                ground {{ port o: (0, 0) m; }}
                body w {{ mass: 1 kg; inertia: {INERTIA} kg*m^2; port g: (0, 0) m; start x: 0 m, locked; start y: 1 m, locked;
                    start angle: 0 rad, locked; start vx: {omega} m/s, locked; start vy: 0 m/s, locked; start omega: -{omega} rad/s, locked; }}
                polygon_on_line feet(ground.o, w.g) {{ corners: {corners} m; friction: 5; }}
                output w.x, w.angle, w.omega, feet.push; {items} }}"
        )
    }

    /// Square of the angular velocity after the wheel has turned by an angle. Between impacts energy stays; an impact leaves
    /// (I + m l^2 cos 2 alpha)/(I + m l^2) of the angular velocity (T. McGeer, Passive dynamic walking, 1990).
    fn square(&self, turned: f64) -> f64 {
        let (half, inertia) = (self.half(), INERTIA + 1.0);
        let gained = |from: f64, to: f64| 2.0 * GRAVITY * (from.cos() - to.cos()) / inertia;
        let (first, last) = (self.slope - half, self.slope + half);
        let share = (INERTIA + (2.0 * half).cos()) / inertia;
        let (mut square, mut left) = (self.omega * self.omega - gained(first, self.slope), turned + half);
        while left > 2.0 * half {
            square = share * share * (square + gained(first, last));
            left -= 2.0 * half;
        }
        square + gained(first, first + left)
    }
}

/// Up to 16 rows, of which one or two touch at a time: by steps with dense output.
#[test]
fn wheels_of_spokes_roll_down_a_slope() {
    for (spokes, slope, omega) in [(6, 0.15, 1.6), (7, 0.12, 1.6), (8, 0.1, 1.6)] {
        let wheel = Wheel { spokes, slope, omega };
        // Conditions that matter as others hold, of which none ever changes anything.
        let conditions = "param high = 1e3; state idle: 1 = 0;
             rate idle = if w.x/(1 m) > high then (if w.omega/(1 rad/s) > high then 1/(1 s) else 2/(1 s)) else 0/(1 s);";
        for items in ["", conditions] {
            let rim = Mechanism::from_text(&wheel.text(items)).unwrap();
            let mut run = rim.start_with("Dop853:1e-11".parse().unwrap()).unwrap();
            let mut most: f64 = 0.0;
            for sample in 1..=60 {
                run.step_to(f64::from(sample) * 0.05).unwrap();
                let state = run.body("w").unwrap();
                most = most.max(-state.angle);
                near(state.omega * state.omega, wheel.square(-state.angle), 1e-7);
            }
            assert!(most > 6.0 * wheel.half(), "{spokes} spokes turned by {most} rad");
        }
    }
}

/// Two boxes on each other have sixteen rows, of which all but eight are open.
#[test]
fn boxes_on_each_other_rest() {
    let boxes = |count: usize| -> String {
        let body = |k: usize| {
            let below = k.checked_sub(1).map_or("ground.top".to_owned(), |below| format!("b{below}.top"));
            format!(
                "body b{k} {{ mass: 2 kg; inertia: plate(2 kg, 0.4 m, 0.2 m); port middle: (0, 0) m; port top: (0, 0.1) m, axis: 0 deg;
                    start x: 0 m; start y: {:?} m; start angle: 0 rad; }}
                polygon_on_line on{k}({below}, b{k}.middle) {{
                    corners: (-0.2, -0.1), (0.2, -0.1), (0.2, 0.1), (-0.2, 0.1) m; friction: 0.5;
                }}
                output push{k} = on{k}.push;",
                0.1 + 0.2 * k as f64
            )
        };
        let all: String = (0..count).map(body).collect();
        format!(
            "pub Boxes {{ gravity: {GRAVITY} m/s^2; allow(W0002); ground {{ port top: (0, 0) m, axis: 0 deg; }} {all} }}"
        )
    };
    for count in [1, 2] {
        for method in ["Dop853:1e-9", "MoreauJean:1e-3", "Rk4:1e-3"] {
            let stack = Mechanism::from_text(&boxes(count)).unwrap();
            let mut run = stack.start_with(method.parse().unwrap()).unwrap();
            run.step_to(0.25).unwrap();
            for (k, push) in run.row().into_iter().enumerate() {
                let state = run.body(&format!("b{k}")).unwrap();
                near(state.y, 0.1 + 0.2 * k as f64, 1e-12);
                near(push, 2.0 * GRAVITY * (count - k) as f64, 1e-6);
            }
        }
    }
}
