//! Optimal control against closed forms and Riccati's equation.

use plm::optimise::{Control, Error, NotConverged};

use super::{Few, mechanism};

fn cart() -> Few {
    mechanism(
        "pub Cart {
            input push: N = 0 N;
            ground { port o: (0, 0) m; }
            body cart { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m, locked; start vx: 0 m/s, locked; }
            prismatic rail(ground.o, cart.o) { drive: push; }
            output cart.x, cart.vx;
        }",
    )
}

/// With N intervals of length h the place is h^2 sum (N - k - 1/2) u_k and the speed h sum u_k: of the least square is the force
/// a + b k whose coefficients give (1, 0).
#[test]
fn least_effort_of_a_cart() {
    let count = 10_u32;
    let h = 1.0 / f64::from(count);
    // By symmetry b is against the middle: u_k = b (k - (N - 1)/2), and -h^2 b sum (k - (N - 1)/2)^2 = 1.
    let middle = f64::from(count - 1) / 2.0;
    let spread: f64 = (0..count).map(|k| (f64::from(k) - middle).powi(2)).sum();
    let b = -1.0 / (h * h * spread);
    for segment in [1, 10] {
        let best = Control::new(cart(), 10)
            .input("push", f64::NEG_INFINITY, f64::INFINITY)
            .effort("push", 1.0)
            .at_end("cart.x", 1.0)
            .at_end("cart.vx", 0.0)
            .shoot(segment)
            .run()
            .unwrap();
        for (k, force) in (0..count).zip(&best.inputs[0]) {
            let known = b * (f64::from(k) - middle);
            assert!((force - known).abs() < 1e-6, "{segment} {k} {force} {known} {best:?}");
        }
        assert!((best.cost - h * b * b * spread).abs() < 1e-7, "{best:?}");
    }
}

/// Of a force within 1 N, 1 m takes 2 s at the least: 1 s forwards, 1 s backwards.
#[test]
fn least_time_of_a_cart() {
    let best = Control::new(cart(), 8)
        .duration_within(3.0, 0.5, 10.0)
        .input("push", -1.0, 1.0)
        .time(1.0)
        .at_end("cart.x", 1.0)
        .at_end("cart.vx", 0.0)
        .run()
        .unwrap();
    assert!((best.duration - 2.0).abs() < 1e-7, "{best:?}");
    for (k, force) in best.inputs[0].iter().enumerate() {
        assert!((force - if k < 4 { 1.0 } else { -1.0 }).abs() < 1e-6, "{best:?}");
    }
    // A speed of at most 0.8 m/s takes 0.8 s + 0.45 s + 0.8 s: the intervals of its grid are 2.05 s/41.
    let best = Control::new(cart(), 41)
        .duration_within(3.0, 0.5, 10.0)
        .input("push", -1.0, 1.0)
        .time(1.0)
        .within("cart.vx", -0.8, 0.8)
        .at_end("cart.x", 1.0)
        .at_end("cart.vx", 0.0)
        .shoot(41)
        .run()
        .unwrap();
    assert!((best.duration - 2.05).abs() < 1e-6, "{best:?}");
}

/// Riccati's recursion for x_(k+1) = A x_k + B u_k with the cost sum h (x_(k+1)^T Q x_(k+1) + R u_k^2).
#[test]
fn linear_quadratic_case_by_riccati() {
    let mut moved = cart();
    super::set_start(&mut moved, "cart.x", 1.0);
    let (count, h, q, r) = (12_usize, 0.25, [3.0, 0.5], 0.2);
    let best = Control::new(moved, count)
        .duration(h * count as f64)
        .input("push", f64::NEG_INFINITY, f64::INFINITY)
        .effort("push", r)
        .deviation("cart.x", 0.0, q[0])
        .deviation("cart.vx", 0.0, q[1])
        .run()
        .unwrap();
    let (a, b) = ([[1.0, h], [0.0, 1.0]], [0.5 * h * h, h]);
    let mut p = [[0.0; 2]; 2];
    let mut gains = Vec::new();
    for _ in 0..count {
        // The cost from the next state on: P + h Q.
        let s = [[p[0][0] + h * q[0], p[0][1]], [p[1][0], p[1][1] + h * q[1]]];
        let sb = [s[0][0] * b[0] + s[0][1] * b[1], s[1][0] * b[0] + s[1][1] * b[1]];
        let whole = h * r + b[0] * sb[0] + b[1] * sb[1];
        let gain: [f64; 2] = std::array::from_fn(|k| (sb[0] * a[0][k] + sb[1] * a[1][k]) / whole);
        let closed: [[f64; 2]; 2] =
            std::array::from_fn(|i| std::array::from_fn(|k| a[i][k] - b[i] * gain[k]));
        p = std::array::from_fn(|i| {
            std::array::from_fn(|k| {
                let mut sum = h * r * gain[i] * gain[k];
                for (m, row) in s.iter().enumerate() {
                    for (n, entry) in row.iter().enumerate() {
                        sum += closed[m][i] * entry * closed[n][k];
                    }
                }
                sum
            })
        });
        gains.push(gain);
    }
    let (mut x, mut cost) = ([1.0, 0.0], 0.0);
    for (gain, force) in gains.iter().rev().zip(&best.inputs[0]) {
        let known = -(gain[0] * x[0] + gain[1] * x[1]);
        assert!((force - known).abs() < 1e-6, "{force} {known}");
        x = [x[0] + h * x[1] + b[0] * known, x[1] + b[1] * known];
        cost += h * (r * known * known + q[0] * x[0] * x[0] + q[1] * x[1] * x[1]);
    }
    assert!((best.cost - cost).abs() < 1e-9 && (cost - p[0][0]).abs() < 1e-12, "{} {cost}", best.cost);
}

#[test]
fn what_cannot_be_reached_is_told() {
    let best = Control::new(cart(), 4)
        .input("push", -1.0, 1.0)
        .effort("push", 1.0)
        .at_end("cart.x", 1.0)
        .at_end("cart.vx", 0.0)
        .run();
    let why = best.unwrap_err();
    assert!(matches!(why, Error::NotConverged { .. }), "{why}");
    assert!(why.to_string().starts_with("no step comes nearer to what is demanded"), "{why}");
    let unknown = Control::new(cart(), 4).input("pull", -1.0, 1.0).run().unwrap_err();
    assert_eq!(unknown.to_string(), "there is no input `pull`; there are push");
}

/// A search that is ended early says so, whatever is still violated by rounding, and hands its plan out (issue 47).
#[test]
fn issue_047_a_search_that_is_ended_hands_its_plan_out() {
    let pole = mechanism(
        "pub C { gravity: 9.81 m/s^2; input u: N = 0 N; ground { port o: (0, 0) m; }
        body cart { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m, locked; start vx: 0 m/s, locked; }
        body pole { mass: 0.3 kg; inertia: 1e-6 kg*m^2; port h: (0, -0.5) m; start angle: 0.3 rad, locked;
            start omega: 0 rad/s, locked; }
        prismatic r(ground.o, cart.o) { drive: u; } revolute h(cart.o, pole.h);
        output cart.x, cart.vx, pole.angle, pole.omega; }",
    );
    for most in [1, 20] {
        let ended = Control::new(pole, 20)
            .input("u", -15.0, 15.0)
            .effort("u", 0.01)
            .deviation("pole.angle", 0.0, 10.0)
            .deviation("cart.x", 0.0, 1.0)
            .end_deviation("pole.omega", 0.0, 1.0)
            .end_deviation("cart.vx", 0.0, 1.0)
            .iterations(most)
            .run();
        let Err(Error::NotConverged { why, plan, .. }) = ended else { panic!("{ended:?}") };
        assert_eq!(why, NotConverged::Iterations(most));
        assert_eq!((plan.len(), plan[0].len()), (1, 20));
    }
}
