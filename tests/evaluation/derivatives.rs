//! Exact derivatives of generated equations against difference quotients.

use plm::runtime::linalg::Dense;
use plm::runtime::{Health, Linear, Ports, Vector};
use plm::{Mechanism, Moment};

use crate::scenes::{s1, s1_baumgarte, s2, s5, s6};

/// A tree with a parameter, an input, a first-order state, and the time in its equations.
mod cart {
    plm::mechanism! {
        pub Cart {
            gravity: 9.81 m/s^2;
            param stiffness: N/m = 50 N/m;
            input push: N = 20 N;
            ground { port rail: (0, 0) m, axis: 10 deg; }
            body cart {
                mass: 2 kg;
                inertia: 0.1 kg*m^2;
                port slide: (0.1, 0) m;
                port pin: (0, 0.05) m;
                start angle: 10 deg;
            }
            body bob {
                mass: 1 kg;
                inertia: 0.02 kg*m^2;
                port pin: (0, 0.4) m;
                start angle: 40 deg, locked;
                start omega: 2 rad/s, locked;
            }
            state filtered: N = 3 N;
            rate filtered = (push - filtered)/0.2 s;
            prismatic rail(ground.rail, cart.slide) {
                stiffness: stiffness;
                damping: 3 N*s/m;
                drive: filtered*sin(3*t*1 rad/s);
            }
            revolute pin(cart.pin, bob.pin) { damping: 0.1 N*m*s/rad; }
            output bob.angle in deg, pin.force;
        }
    }
}

/// Two pendulums that know nothing of each other, a body on springs, lags behind one and the other, in absolute coordinates:
/// columns share directions, and some need none.
mod apart {
    plm::mechanism! {
        pub Apart {
            gravity: 9.81 m/s^2;
            formulation: absolute;
            ground { port o: (0, 0) m; port p: (1 m, 0.1 m*sin(3 rad/s*t)); port q: (2, 0) m; }
            body left { mass: 2 kg; inertia: 0.1 kg*m^2; port pin: (0, 0.4) m; start angle: 40 deg, locked; start omega: 2 rad/s, locked; }
            body right { mass: 1 kg; inertia: 0.2 kg*m^2; port pin: (0.1, 0.3) m; start angle: -30 deg, locked; start omega: -1 rad/s, locked; }
            body bird { mass: 1 kg; inertia: 0.2 kg*m^2; port hook: (0.1, 0.3) m; start x: 2 m, locked; start vy: 1 m/s, locked; start omega: 1 rad/s, locked; }
            revolute first(ground.o, left.pin) { damping: 0.1 N*m*s/rad; drive: held; }
            revolute second(ground.p, right.pin) { stiffness: 2 N*m/rad; }
            spring leash(ground.q, bird.hook) { stiffness: 50 N/m; damping: 0.4 N*s/m; free_length: 0.4 m; }
            state held: N*m = 0.3 N*m;
            rate held = (0.1 N*m*s*left.omega*abs(left.omega)*1 s - held)/0.2 s;
            state other: 1 = 0.1;
            rate other = (sin(right.angle) - other^3)/0.1 s;
        }
    }
}

/// A loop with lags, one of which drives it, and so many that its matrix is not emitted: both images of the loop are charts.
mod lags {
    plm::mechanism! {
        pub Lags {
            gravity: 9.81 m/s^2;
            ground { port o: (0, 0) m; port p: (0.8, 0) m; }
            body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 40 deg, locked; start omega: 5 rad/s, locked; }
            body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (-0.4, 0) m; port c: (0.4, 0) m; }
            body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (0.35, 0) m; port p: (-0.35, 0) m; start angle: 100 deg; }
            revolute o(ground.o, crank.a) { drive: torque; }
            revolute b(crank.b, coupler.b);
            revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
            revolute p(ground.p, rocker.p) { stiffness: 2 N*m/rad; }
            state torque: N*m = 0.5 N*m;
            rate torque = (1 N*m*first - torque)/0.1 s;
            repeat i in 0..3 { state lag[i]: 1 = 0.1*i; rate lag[i] = (0.2*exp(-lag[i]^2) - lag[i])/(0.1 s + 0.02 s*i); }
            state first: 1 = 0.2; rate first = (0.1 s/rad*crank.omega - first)/0.3 s;
        }
    }
}

/// Largest difference between the derivatives of the rate by state and time and central difference quotients, as a
/// fraction of the largest derivative; half a second after the start, where nothing is at rest.
fn worst<M>(mechanism: M) -> f64
where
    M: Mechanism<S = f64> + Linear,
{
    let mut sim = mechanism.start().unwrap();
    sim.step(0.01).unwrap();
    let state = sim.state();
    let (t, held, x, size) = (state.time(), state.held(), *state.x(), M::X::LEN);
    let (mut by_x, mut by_t) = (M::X::zeros(), x);
    assert!(mechanism.jacobian(t, &held, &x, &mut by_x, Some(&mut by_t)).is_good());
    let rate = |t: f64, x: &M::X| {
        let mut dx = *x;
        assert!(mechanism.rate(t, &held, x, &mut dx).is_good());
        dx
    };
    let (mut error, mut largest): (f64, f64) = (0.0, 0.0);
    for j in 0..=size {
        let h = 1e-6 * if j < size { x.at(j).abs().max(1.0) } else { 1.0 };
        let beside = |h: f64| {
            let mut moved = x;
            moved.set(j, x.at(j) + h);
            if j < size { rate(t, &moved) } else { rate(t + h, &x) }
        };
        let (after, before) = (beside(h), beside(-h));
        for i in 0..size {
            let exact = if j < size { M::X::entry(&by_x, i, j) } else { by_t.at(i) };
            error = error.max((exact - (after.at(i) - before.at(i)) / (2.0 * h)).abs());
            largest = largest.max(exact.abs());
        }
    }
    assert!(largest > 1.0, "{largest}");
    error / largest
}

#[test]
fn derivatives_agree_with_difference_quotients() {
    // Trees.
    assert!(worst(s1::DoublePendulum::new()) < 1e-8);
    assert!(worst(cart::Cart::new()) < 1e-8);
    // Absolute coordinates.
    assert!(worst(s1_baumgarte::DoublePendulum::new()) < 1e-8);
    assert!(worst(apart::Apart::new()) < 1e-8);
    // Loops.
    assert!(worst(lags::Lags::new()) < 1e-8);
    assert!(worst(s2::FourBar::new()) < 1e-8);
    assert!(worst(s6::SliderCrank::new()) < 1e-8);
    assert!(worst(s5::Andrews::new()) < 1e-8);
}

/// Columns that share a direction have the bits that they have one by one; a zero may have another sign. Where derivatives are
/// symbolic there is nothing to compare.
fn has_the_bits_of_columns<M>(mechanism: M)
where
    M: Mechanism<S = f64> + Linear,
{
    let mut sim = mechanism.start().unwrap();
    for _ in 0..20 {
        sim.step(0.05).unwrap();
        let state = sim.state();
        let (t, held, x, size) = (state.time(), state.held(), *state.x(), M::X::LEN);
        let (mut by_x, mut by_t) = (M::X::zeros(), x);
        assert!(mechanism.jacobian(t, &held, &x, &mut by_x, Some(&mut by_t)).is_good());
        let mut without = M::X::zeros();
        assert!(mechanism.jacobian(t, &held, &x, &mut without, None).is_good());
        for j in 0..=size {
            let along = Vector::from_fn(|i| f64::from(u8::from(i == j)));
            let (by, mut column) = (f64::from(u8::from(j == size)), x);
            assert!(mechanism.jvp(t, &held, &x, (by, &along), &mut column).is_good());
            for i in 0..size {
                let entry = if j < size { M::X::entry(&by_x, i, j) } else { by_t.at(i) };
                assert!(entry == column.at(i), "t = {t}, {i} by {j}: {entry:e} and {:e}", column.at(i));
                assert!(j == size || entry == M::X::entry(&without, i, j));
            }
        }
    }
}

#[test]
fn columns_that_share_a_direction_are_as_one_by_one() {
    has_the_bits_of_columns(apart::Apart::new());
    has_the_bits_of_columns(lags::Lags::new());
    has_the_bits_of_columns(s1_baumgarte::DoublePendulum::new());
    has_the_bits_of_columns(s2::FourBar::new());
    has_the_bits_of_columns(s6::SliderCrank::new());
}

#[test]
fn a_direction_is_a_sum_of_columns() {
    let mechanism = s1_baumgarte::DoublePendulum::new();
    let sim = mechanism.start().unwrap();
    let (held, x) = (sim.state().held(), *sim.state().x());
    let direction = Vector::<f64>::from_fn(|i| f64::from(i as u32 % 5) - 1.7);
    let (mut by_x, mut along) = (<[f64; 12]>::zeros(), x);
    let _ = mechanism.jacobian(0.0, &held, &x, &mut by_x, None);
    let Health(health) = mechanism.jvp(0.0, &held, &x, (0.0, &direction), &mut along);
    assert!(health > 0.01);
    for i in 0..x.len() {
        let sum: f64 = (0..x.len()).map(|j| <[f64; 12]>::entry(&by_x, i, j) * direction.at(j)).sum();
        assert!((along[i] - sum).abs() < 1e-12 * sum.abs().max(100.0), "{i}: {} {sum}", along[i]);
    }
}

#[test]
fn inputs_and_outputs_have_numbers() {
    type Cart = cart::Cart<f64>;
    assert_eq!(<Cart as Ports>::INPUTS, [("push", "N")]);
    let names = [("bob.angle", "deg"), ("pin.force.x", "N"), ("pin.force.y", "N")];
    assert_eq!(<Cart as Ports>::OUTPUTS, names);
    let mut sim = Cart::new().start().unwrap();
    *Cart::input(&mut sim.input, 0).unwrap() = 7.0;
    assert_eq!((sim.input.push, Cart::input(&mut sim.input, 1)), (7.0, None));
    let mut values = Vec::new();
    Cart::outputs(sim.state(), &mut |value| values.push(value));
    assert_eq!(values, sim.outputs());
}
