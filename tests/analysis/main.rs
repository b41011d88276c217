//! Analysis on hosts: linearisation, equilibria, methods that are chosen. Here linearisation of systems written as
//! generated code is, against analytic frequencies and dampings.
#![allow(
    clippy::large_types_passed_by_value,
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    unreachable_pub,
    reason = "tests"
)]

#[macro_use]
#[path = "../support/scene.rs"]
mod scene;

#[macro_use]
#[path = "../scenes/analysis.rs"]
mod declared;

mod auto;
mod contact;
mod control;
mod inverse;
mod linearise;
mod linkages;
mod pressures;
mod settings;
mod stabilise;

use plm::runtime::{At, Constraints, Dual, Events, Health, Labels, Linear, Ports, Rate, Vector};
use plm::{Fault, Linearisation, Mechanism, Real, linearise};

/// Declares a mechanism with one parameter and one input, as generated code would.
macro_rules! mechanism {
    ($(#[$doc:meta])* $name:ident { $param:ident }, input $input:ident in $input_unit:literal,
        states $n:literal, coordinates $nq:literal,
        rate |$m:ident, $u:ident, $x:ident| $rate:expr,
        constraints |$cx:ident| $constraints:expr,
        outputs $names:expr, |$s:ident| $outputs:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        struct $name<S> {
            $param: S,
        }

        impl<S: Real> Rate for $name<S> {
            type S = S;
            type X = [S; $n];
            type U = S;
            const NQ: usize = $nq;

            fn rate(&self, _t: S, u: &S, $x: &[S; $n], dx: &mut [S; $n]) -> Health<S> {
                let ($m, $u) = (self, *u);
                *dx = $rate;
                Health::perfect()
            }
        }

        impl<S: Real> Constraints for $name<S> {}

        impl<S: Real> Events for $name<S> {
            type G = [S; 0];
        }

        impl<S: Real> Labels for $name<S> {}

        impl<S: Real> Linear for $name<S> {
            type Lifted<const K: usize> = $name<Dual<S, K>>;
            type In<T: Real> = $name<T>;
            type Derivatives = [[S; $n]; $n];

            fn lift<const K: usize>(&self, held: &S) -> ($name<Dual<S, K>>, Dual<S, K>) {
                self.in_numbers(held, Dual::constant)
            }
            fn in_numbers<T: Real>(&self, held: &S, number: impl Fn(S) -> T) -> ($name<T>, T) {
                ($name { $param: number(self.$param) }, number(*held))
            }
            fn constraints(&self, _t: S, $cx: &[S; $n], row: &mut impl FnMut(S)) {
                $constraints.into_iter().for_each(row);
            }
        }

        impl<S: Real> Mechanism for $name<S> {
            type State = At<Self>;
            type Rescue = plm::runtime::singular::Never<Self>;

            fn start_state(&self, _t: S) -> Result<(S, [S; $n]), Fault> {
                Ok((S::ZERO, [S::ZERO; $n]))
            }
        }

        impl<S: Real> Ports for $name<S> {
            type Input = S;
            const INPUTS: &'static [(&'static str, &'static str)] = &[(stringify!($input), $input_unit)];
            const OUTPUTS: &'static [(&'static str, &'static str)] = &$names;

            fn inputs(held: &mut S) -> &mut S {
                held
            }
            fn input(input: &mut S, index: usize) -> Option<&mut S> {
                [input].into_iter().nth(index)
            }
            fn outputs($s: &At<Self>, each: &mut impl FnMut(S)) {
                $outputs.into_iter().for_each(each);
            }
        }
    };
}

fn lit<S: Real>(x: f64) -> S {
    S::lit(x)
}

mechanism! {
    /// A point mass of 2 kg on a rod of 0.5 m: 0.5 a'' = -g sin a - damping a' + drive / (m l) in m/s^2.
    Pendulum { damping }, input drive in "N*m", states 2, coordinates 1,
    rate |m, u, x| {
        let torque = u - m.damping * x[1] - lit::<S>(2.0 * 9.81 * 0.5) * x[0].sin();
        [x[1], torque / lit(2.0 * 0.25)]
    },
    constraints |_x| [S::ZERO; 0],
    outputs [("angle", "deg"), ("force", "N")], |s| [
        s.x[0] / lit(1_f64.to_radians()),
        // Along the rod: gravity, the centripetal force, and something of the drive.
        lit::<S>(2.0 * 9.81) * s.x[0].cos() + s.x[1] * s.x[1] + lit::<S>(3.0) * s.held,
    ]
}

mechanism! {
    /// Two equal point masses on equal massless rods; the force drives the lower one.
    DoublePendulum { ratio }, input drive in "m/s^2", states 4, coordinates 2,
    rate |m, u, x| {
        let [a, b, va, vb] = *x;
        let (sin, cos) = (a - b).sin_cos();
        let two = lit::<S>(2.0);
        // 2 a'' + cos b'' = f, cos a'' + b'' = g, with ratio = gravity / length.
        let f = -(two * m.ratio * a.sin()) - sin * vb * vb;
        let g = sin * va * va - m.ratio * b.sin() + u * b.cos();
        let determinant = two - cos * cos;
        [va, vb, (f - cos * g) / determinant, (two * g - cos * f) / determinant]
    },
    constraints |_x| [S::ZERO; 0],
    outputs [("lower", "rad")], |s| [s.x[1]]
}

mechanism! {
    /// A point mass on a rod in absolute coordinates (x, y): the rod is a constraint.
    Rod { length }, input push in "N", states 4, coordinates 2,
    rate |m, u, x| {
        // q'' = f - lambda q with q q'' = -v^2.
        let f = [u, lit::<S>(-9.81)];
        let square = x[0] * x[0] + x[1] * x[1];
        let lambda = (x[0] * f[0] + x[1] * f[1] + x[2] * x[2] + x[3] * x[3]) / square;
        let _ = m.length;
        [x[2], x[3], f[0] - lambda * x[0], f[1] - lambda * x[1]]
    },
    constraints |x| [x[0] * x[0] + x[1] * x[1] - lit(1.0), lit::<S>(2.0) * (x[0] * x[2] + x[1] * x[3])],
    outputs [("x", "m"), ("height", "m")], |s| [s.x[0], s.x[1]]
}

fn at<M: Mechanism<S = f64, U = f64>>(mechanism: M, x: M::X) -> At<M> {
    At { mechanism, held: 0.0, time: 0.0, x }
}

fn assert_close(got: f64, want: f64) {
    assert!((got - want).abs() < 1e-12 * want.abs().max(1.0), "{got} {want}");
}

#[test]
fn a_damped_pendulum() {
    let system = linearise(&at(Pendulum { damping: 0.4 }, [0.0; 2])).unwrap();
    // m l^2 = 0.5, m g l = 9.81.
    for (i, j, want) in [(0, 0, 0.0), (0, 1, 1.0), (1, 0, -19.62), (1, 1, -0.8)] {
        assert_close(system.a[(i, j)], want);
    }
    assert_eq!((system.b[(0, 0)], system.b[(1, 0)]), (0.0, 2.0));
    assert_close(system.c[(0, 0)], 180.0 / core::f64::consts::PI);
    assert_eq!((system.c[(0, 1)], system.c[(1, 0)], system.c[(1, 1)]), (0.0, 0.0, 0.0));
    assert_eq!((system.d[(0, 0)], system.d[(1, 0)]), (0.0, 3.0));
    assert_eq!((system.inputs, system.outputs.len()), (&[("drive", "N*m")][..], 2));

    let modes = system.modes();
    assert_eq!(modes.len(), 2);
    for mode in &modes {
        assert_close(mode.frequency, 19.62_f64.sqrt());
        assert_close(mode.damping, 0.4 / 19.62_f64.sqrt());
        assert_close(mode.eigenvalue.re, -0.4);
        assert_close(mode.eigenvalue.im.abs(), (19.62_f64 - 0.16).sqrt());
    }
    assert!(modes[0].eigenvalue.im < 0.0 && modes[1].eigenvalue.im > 0.0);
}

#[test]
fn an_inverted_pendulum_falls() {
    let system = linearise(&at(Pendulum { damping: 0.0 }, [core::f64::consts::PI, 0.0])).unwrap();
    let [falls, rises] = system.modes()[..] else { panic!("two modes") };
    // Equal in frequency: told apart by the damping.
    let mut rates = [falls.eigenvalue.re, rises.eigenvalue.re];
    rates.sort_by(f64::total_cmp);
    assert_close(rates[0], -(19.62_f64.sqrt()));
    assert_close(rates[1], 19.62_f64.sqrt());
    assert_close(falls.damping.abs(), 1.0);
}

#[test]
fn overdamped_modes_do_not_oscillate() {
    let system = linearise(&at(Pendulum { damping: 50.0 }, [0.0; 2])).unwrap();
    // lambda^2 + 100 lambda + 19.62 = 0.
    let root = (2500.0_f64 - 19.62).sqrt();
    let [slow, fast] = system.modes()[..] else { panic!("two modes") };
    assert_close(slow.eigenvalue.re, -19.62 / (50.0 + root));
    assert_close(fast.eigenvalue.re, -50.0 - root);
    assert_eq!((slow.damping, fast.damping), (1.0, 1.0));
}

#[test]
fn a_double_pendulum_that_hangs() {
    let system = linearise(&at(DoublePendulum { ratio: 9.81 }, [0.0; 4])).unwrap();
    let modes = system.modes();
    // w^2 = g / l (2 -+ sqrt 2) (L. D. Landau, E. M. Lifshitz, Mechanics, section 23, problem 2, with equal masses and
    // lengths).
    let expected = [-1.0, -1.0, 1.0, 1.0].map(|sign| (9.81 * (2.0 + sign * 2_f64.sqrt())).sqrt());
    for (mode, frequency) in modes.iter().zip(expected) {
        assert_close(mode.frequency, frequency);
        assert!(mode.damping.abs() < 1e-12, "{mode:?}");
    }
    // The drive turns the lower rod by 2 and the upper one by -1.
    assert_close(system.b[(2, 0)], -1.0);
    assert_close(system.b[(3, 0)], 2.0);
}

#[test]
fn constraints_leave_the_modes_that_move() {
    let system = linearise(&at(Rod { length: 1.0 }, [0.0, -1.0, 0.0, 0.0])).unwrap();
    assert_eq!((system.a.shape(), system.basis.shape()), ((2, 2), (4, 2)));
    for mode in system.modes() {
        assert_close(mode.frequency, 9.81_f64.sqrt());
        assert!(mode.damping.abs() < 1e-12, "{mode:?}");
    }
    // The answer to a slow push is that of a pendulum: x = push / g, and no height to first order.
    let still = static_gain(&system);
    assert_close(still[(0, 0)], 1.0 / 9.81);
    assert!(still[(1, 0)].abs() < 1e-14);
}

/// D - C A^-1 B.
fn static_gain(system: &Linearisation) -> nalgebra::DMatrix<f64> {
    &system.d - &system.c * system.a.clone().lu().solve(&system.b).unwrap()
}

#[test]
fn states_without_derivatives_are_refused() {
    let fault = linearise(&at(Rod { length: 1.0 }, [0.0; 4])).unwrap_err();
    assert!(matches!(fault.cause, plm::Cause::Singular { .. }), "{fault}");
    assert_eq!(<[f64; 4] as Vector<f64>>::LEN, 4);
}
