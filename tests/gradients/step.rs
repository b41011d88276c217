//! The Jacobian of one interval of a run, and inputs that are derived by.

use plm::runtime::Jacobian;
use plm::runtime::gradient::set_input;
use plm::{By, Dop853, Dual, Labels, Moment, Rk4, Sim, with_derivatives};

use super::adjoint::{Cart, EVERY, PUSHES, carted};
use super::are_slopes;
use super::loops::FourBar;

/// Place, speed and summed way of the cart after an interval.
fn pushed([x, v, way, push, mass, drag]: [f64; 6], t: f64) -> [f64; 3] {
    let (last, k) = (push / drag, mass / drag);
    let (rest, decay) = (v - last, (-t / k).exp());
    let moved = last * t + rest * k * (1.0 - decay);
    [x + moved, last + rest * decay, way + x * t + last * t * t / 2.0 + rest * k * (t - k * (1.0 - decay))]
}

#[test]
fn of_a_cart_by_its_state_an_input_and_parameters() {
    let mut sim = Cart::new().start_with(Dop853::new(1e-13)).unwrap();
    sim.input.push = 3.0;
    sim.step(0.4).unwrap();
    let names: [&str; 3] = core::array::from_fn(|i| sim.state().mechanism().name_of_state(i));
    let by = [
        By::State(names[0]),
        By::State(names[1]),
        By::State(names[2]),
        By::Input("push"),
        By::Parameter("mass"),
        By::Parameter("drag"),
    ];
    let jacobian = Jacobian::<Cart, 6>::of_step(sim.state(), 0.7, Dop853::new(1e-13.into()), by).unwrap();
    let [x, v, way] = *sim.state().x();
    let at = [x, v, way, 3.0, 2.0, 0.5];
    for (row, found) in jacobian.matrix::<3>().into_iter().enumerate() {
        assert!((jacobian.state()[row] - pushed(at, 0.7)[row]).abs() < 1e-12);
        assert_eq!(jacobian.row(row), names[row]);
        are_slopes(found, |p| pushed(p, 0.7)[row], at, 1e-10);
    }
    assert_eq!(names, ["rail.displacement", "rail.speed", "way"]);
    assert_eq!((jacobian.column(3), jacobian.column(6)), (Some(By::Input("push")), None));
    // A name that stands twice has its derivatives twice.
    let twice = [by[0], by[3], by[4], by[0], by[3], by[4]];
    let twice = Jacobian::<Cart, 6>::of_step(sim.state(), 0.7, Dop853::new(1e-13.into()), twice).unwrap();
    for (row, once) in twice.matrix::<3>().into_iter().zip(jacobian.matrix::<3>()) {
        let expected = [once[0], once[3], once[4], once[0], once[3], once[4]];
        assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-13), "{row:?} {expected:?}");
    }
    // Outputs have theirs as well.
    are_slopes(jacobian.moment().way().tangents, |p| pushed(p, 0.7)[2], at, 1e-10);
}

/// A step of fixed length of a loop, beside differences of such steps.
#[test]
fn of_a_loop_beside_differences() {
    let mut sim = FourBar::new().start_with(Rk4::new(0.01)).unwrap();
    *sim = Moment::new(*sim.state().mechanism(), sim.state().held(), 0.0, [0.7, 3.0]);
    let names: [&str; 2] =
        core::array::from_fn(|i| sim.state().mechanism().name_in_chart(&sim.state().held(), i));
    let by = [By::State(names[0]), By::State(names[1]), By::Parameter("swing")];
    let found = Jacobian::<FourBar, 3>::of_step(sim.state(), 0.01, Rk4::new(0.01.into()), by).unwrap();
    let step = |[a, b, swing]: [f64; 3]| {
        let other = FourBar { swing, ..*sim.state().mechanism() };
        let mut other: Sim<FourBar, Rk4<f64>> =
            Sim::new(Moment::new(other, sim.state().held(), 0.0, [a, b]), Rk4::new(0.01));
        other.step(0.01).unwrap();
        *other.state().x()
    };
    let [a, b] = *sim.state().x();
    for (row, found) in found.matrix::<2>().into_iter().enumerate() {
        are_slopes(found, |p| step(p)[row], [a, b, 0.25], 1e-9);
    }
}

/// The intervals of a control grid are directions of their own.
#[test]
fn of_a_control_grid() {
    let mut by = [By::Input("push"); 8];
    by[..3].copy_from_slice(&[By::Parameter("mass"), By::Parameter("drag"), By::Start("cart.vx")]);
    let mut sim = with_derivatives(&Cart::new(), by).unwrap().start_with(Dop853::new(1e-13.into())).unwrap();
    for (k, push) in PUSHES.into_iter().enumerate() {
        set_input(&mut sim, "push", Dual::variable(push, 3 + k)).unwrap();
        sim.step(EVERY.into()).unwrap();
    }
    let [a, b, c, d, e] = PUSHES;
    let at = [2.0, 0.5, 1.0, a, b, c, d, e];
    are_slopes(sim.way().tangents, |p| carted(p)[1], at, 1e-10);
}

#[test]
fn by_a_name_that_is_not_there() {
    let sim = Cart::new().start().unwrap();
    let unknown = |by| {
        let outcome = Jacobian::<Cart, 1>::of_step(sim.state(), 0.1, Rk4::new(0.1.into()), [by]);
        outcome.map(|_| ()).unwrap_err().to_string()
    };
    assert_eq!(unknown(By::Input("pull")), "there is no input `pull`");
    assert_eq!(unknown(By::State("pull")), "there is no state `pull`; only a moment of a run has states");
    assert_eq!(unknown(By::Parameter("pull")), "there is no parameter `pull`");
    assert_eq!(unknown(By::Start("cart.vx")), "there is no start value `cart.vx`");
    let mut sim = sim;
    assert!(set_input(&mut sim, "pull", 1.0).is_err());
}
