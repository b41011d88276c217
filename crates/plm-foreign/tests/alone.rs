//! Steps by themselves, starts at a time, rates and matrices, by number.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs, reason = "tests")]

use plm_foreign::{By, Either, Foreign, Kind, Matrix, Object, ObjectBy, Run, Status};

plm::mechanism! {
    /// A bar on a pin with a spring against the weight.
    Bar {
        gravity: 9.81 m/s^2;
        emit: step(rk4, linearly_implicit);
        param load: kg = 2 kg;
        input drive: N*m = 0;
        state heat: J = 0;
        rate heat = 3 W - heat/2 s;
        ground { port o: (0, 0) m; }
        body bar { mass: load; inertia: 0.1 kg*m^2; port pivot: (-0.5, 0) m; start angle: -60 deg, locked; start omega: 2 rad/s, locked; }
        revolute hinge(ground.o, bar.pivot) { damping: 0.3 N*m*s/rad; drive: drive; }
        output bar.angle in deg;
    }
}

plm::mechanism! {
    /// The same in absolute coordinates.
    Absolute {
        gravity: 9.81 m/s^2;
        formulation: absolute;
        param load: kg = 2 kg;
        input drive: N*m = 0;
        state heat: J = 0;
        rate heat = 3 W - heat/2 s;
        ground { port o: (0, 0) m; }
        body bar { mass: load; inertia: 0.1 kg*m^2; port pivot: (-0.5, 0) m; start angle: -60 deg, locked; start omega: 2 rad/s, locked; }
        revolute hinge(ground.o, bar.pivot) { damping: 0.3 N*m*s/rad; drive: drive; }
        output bar.angle in deg;
    }
}

fn started<M: Foreign>(declared: M) -> Object<M> {
    let mut object = Object::new(declared);
    object.start().unwrap();
    object
}

fn output<M: Foreign<S = f64>, R: Run<M>>(object: &ObjectBy<M, R>) -> f64 {
    object.get(Kind::Output, 0).unwrap()
}

/// Rows of a matrix.
fn matrix<M: Foreign<S = f64>>(object: &Object<M>, which: Matrix) -> Vec<Vec<f64>> {
    let found = object.linearised().unwrap();
    let (rows, columns) = found.shape(which);
    let mut all = vec![vec![f64::NAN; columns]; rows];
    found.each(which, &mut |row, column, number| all[row][column] = number);
    all
}

#[test]
fn a_step_by_itself_has_the_bits_of_the_state() {
    let (mut object, mut state) = (started(Bar::new()), *plm::Mechanism::start(Bar::new()).unwrap().state());
    for k in 0..200 {
        if k == 50 {
            object.set(Kind::Input, 0, 4.0).unwrap();
            state.input.drive = 4.0;
        }
        object.step_alone(|state| state.step_rk4(1e-3)).unwrap();
        state.step_rk4(1e-3).unwrap();
        object.step_alone(|state| state.step_linearly_implicit(1e-3)).unwrap();
        state.step_linearly_implicit(1e-3).unwrap();
        assert_eq!(output(&object).to_bits(), state.bar().angle.to_bits(), "step {k}");
    }
    // A run goes on after it.
    object.step(0.1).unwrap();
    assert!((object.time().unwrap() - 0.5).abs() < 1e-12);
}

#[test]
fn a_step_by_itself_looks_at_parameters_that_were_set() {
    let mut object = started(Bar::new());
    object.set(Kind::Parameter, 0, -1.0).unwrap();
    let (time, angle) = (object.time(), output(&object));
    for _ in 0..2 {
        let fault = object.step_alone(|state| state.step_rk4(1e-3)).unwrap_err();
        assert_eq!(fault.status(), Status::Parameter, "{fault}");
        assert_eq!((object.time(), output(&object)), (time, angle));
    }
    object.set(Kind::Parameter, 0, 3.0).unwrap();
    object.step_alone(|state| state.step_rk4(1e-3)).unwrap();
    let fault = object.step_alone(|state| state.step_rk4(-1e-3)).unwrap_err();
    assert_eq!(fault.status(), Status::Accuracy);
    let unstarted = Object::new(Bar::new()).step_alone(|state| state.step_rk4(1e-3)).unwrap_err();
    assert_eq!(unstarted.status(), Status::NotStarted);
}

#[test]
fn a_run_begins_at_its_time_and_changes_its_method() {
    type Two = Either<plm::Sim<Bar>, plm::Sim<Bar, plm::Rk4<f64>>>;
    let mut object = ObjectBy::<Bar, Two>::new(Bar::new());
    assert_eq!(object.start_at(f64::NAN).unwrap_err().status(), Status::NotFinite);
    object.start_at(7.5).unwrap();
    object.step(0.25).unwrap();
    assert_eq!(object.time().unwrap(), 7.75);
    object.set_method(By::Rk4).unwrap();
    let mut before = object;
    // Without a longest step a call is one step of the formula, here of a length that the times hold exactly.
    let (mut state, h) = (*object.state().unwrap(), 0.007_812_5);
    object.step(h).unwrap();
    state.step_rk4(h).unwrap();
    assert_eq!(output(&object).to_bits(), state.bar().angle.to_bits());
    before.set_longest_step(1e-3).unwrap();
    before.step(h).unwrap();
    let difference = (output(&before) - output(&object)).abs();
    assert!(difference > 0.0 && difference < 1e-6, "{difference:e}");
    // A parameter that was set is looked at by the old method before the new one begins.
    object.set(Kind::Parameter, 0, -1.0).unwrap();
    assert_eq!(object.set_method(By::Dop853).unwrap_err().status(), Status::Parameter);
    assert_eq!(object.step(0.01).unwrap_err().status(), Status::Parameter);
}

/// I a = T - m g l cos(angle) - d omega about the pin, I = 0.1 + m l^2.
#[test]
fn rates_and_matrices_are_those_of_the_pendulum() {
    let (weight, arm, damping) = (2.0 * 9.81, 0.5, 0.3);
    let (inertia, angle) = (0.1 + 2.0 * arm * arm, (-60.0_f64).to_radians());
    let object = started(Bar::new());
    let rates = object.rates().unwrap();
    let expected = [2.0, (-weight * arm * angle.cos() - damping * 2.0) / inertia, 3.0];
    for (k, expected) in expected.into_iter().enumerate() {
        assert!((rates[k] - expected).abs() < 1e-12, "{k}");
        assert_eq!(object.get(Kind::Rate, k).unwrap(), rates[k]);
    }
    assert_eq!(Kind::Integrated.name(&Bar::new(), 1).unwrap(), "bar.omega");
    assert!((object.get(Kind::Integrated, 0).unwrap() - angle).abs() < 1e-15);
    assert_eq!(object.get(Kind::Rate, 3).unwrap_err().status(), Status::NoSuch);
    let a = matrix(&object, Matrix::A);
    let expected =
        [[0.0, 1.0, 0.0], [weight * arm * angle.sin() / inertia, -damping / inertia, 0.0], [0.0, 0.0, -0.5]];
    for (row, expected) in a.iter().flatten().zip(expected.iter().flatten()) {
        assert!((row - expected).abs() < 1e-12, "{a:?}");
    }
    let b = matrix(&object, Matrix::B);
    assert!(b[0][0] == 0.0 && (b[1][0] - 1.0 / inertia).abs() < 1e-12 && b[2][0] == 0.0, "{b:?}");
    // The angle is an output in rad here.
    assert_eq!(matrix(&object, Matrix::C)[0], [1.0, 0.0, 0.0]);
    assert_eq!(matrix(&object, Matrix::D)[0], [0.0]);
    assert_eq!(matrix(&object, Matrix::Basis), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
}

/// Along what the constraints leave, the system is that of joint coordinates in another basis: same characteristic polynomial,
/// same gains. At rest, where the directions do not turn.
#[test]
fn constraints_leave_the_same_system() {
    fn hanging<M: Foreign<S = f64>>(declared: M) -> Object<M> {
        let mut object = Object::new(declared);
        object.set(Kind::Start, 2, -0.5 * std::f64::consts::PI).unwrap();
        object.set(Kind::Start, 5, 0.0).unwrap();
        object.start().unwrap();
        object
    }
    let (joint, absolute) = (hanging(Bar::new()), hanging(Absolute::new()));
    let (ours, theirs) = (matrix(&absolute, Matrix::A), matrix(&joint, Matrix::A));
    assert_eq!((ours.len(), absolute.rates().unwrap().len()), (3, 7));
    for (ours, theirs) in polynomial(&ours).into_iter().zip(polynomial(&theirs)) {
        assert!((ours - theirs).abs() < 1e-9, "{ours} {theirs}");
    }
    // C A^k B of the angle.
    for k in 0..3 {
        let [ours, theirs] = [gain(&absolute, k), gain(&joint, k)];
        assert!((ours - theirs).abs() < 1e-9, "{k}: {ours} {theirs}");
    }
    let basis = matrix(&absolute, Matrix::Basis);
    for i in 0..3 {
        for j in 0..3 {
            let product: f64 = basis.iter().map(|row| row[i] * row[j]).sum();
            assert!((product - f64::from(u8::from(i == j))).abs() < 1e-14, "{i} {j}");
        }
    }
}

/// Trace, sum of the second minors, determinant.
fn polynomial(a: &[Vec<f64>]) -> [f64; 3] {
    let minor = |i: usize, j: usize| a[i][i] * a[j][j] - a[i][j] * a[j][i];
    let determinant = a[0][0] * minor(1, 2) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0])
        + a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    [a[0][0] + a[1][1] + a[2][2], minor(0, 1) + minor(0, 2) + minor(1, 2), determinant]
}

fn gain<M: Foreign<S = f64>>(object: &Object<M>, power: usize) -> f64 {
    let (a, c) = (matrix(object, Matrix::A), matrix(object, Matrix::C));
    let b: Vec<f64> = matrix(object, Matrix::B).iter().map(|row| row[0]).collect();
    let times = |v: &Vec<f64>| a.iter().map(|row| row.iter().zip(v).map(|(a, v)| a * v).sum()).collect();
    let b = (0..power).fold(b, |b, _| times(&b));
    c[0].iter().zip(b).map(|(c, b)| c * b).sum()
}
