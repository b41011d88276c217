//! Small systems with known solutions or invariants, as generated code would be for them.
#![allow(dead_code, reason = "each uses its part")]

use plm_runtime::{Constraints, Dual, Events, Fault, Health, Labels, Linear, Mechanism, Rate, Real};

use crate::linkage::At;

/// A system of `N` states with parameters, its first `NQ` rates the velocities.
macro_rules! system {
    ($(#[$doc:meta])* $name:ident { $($field:ident),* }, states $n:literal, coordinates $nq:literal,
        rate |$m:ident, $t:ident, $x:ident| $rate:expr, start |$s:ident| $start:expr
        $(, typical $typical:expr)?) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name<S> {
            $(pub $field: S,)*
        }

        impl<S: Real> Rate for $name<S> {
            type S = S;
            type X = [S; $n];
            type U = ();
            const NQ: usize = $nq;

            fn rate(&self, $t: S, (): &(), $x: &[S; $n], dx: &mut [S; $n]) -> Health<S> {
                let $m = self;
                *dx = $rate;
                Health::perfect()
            }
            $(fn typical(&self) -> [S; $n] {
                $typical.map(S::lit)
            })?
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

            fn lift<const K: usize>(&self, (): &()) -> ($name<Dual<S, K>>, ()) {
                self.in_numbers(&(), Dual::constant)
            }

            fn in_numbers<T: Real>(&self, (): &(), number: impl Fn(S) -> T) -> ($name<T>, ()) {
                let _ = &number;
                ($name { $($field: number(self.$field)),* }, ())
            }
        }

        impl<S: Real> Mechanism for $name<S> {
            type State = At<Self>;
            type Rescue = plm_runtime::singular::Never<Self>;

            fn start_state(&self, _t: S) -> Result<((), [S; $n]), Fault> {
                let $s = self;
                Ok(((), $start))
            }
        }
    };
}

system! {
    /// q'' = -w^2 q - 2 z w q': the solution is a damped oscillation, from q = 1 at rest.
    Spring { w, z }, states 2, coordinates 1,
    rate |m, _t, x| [x[1], -(m.w * m.w * x[0]) - S::lit(2.0) * m.z * m.w * x[1]],
    start |_m| [S::lit(1.0), S::ZERO]
}

system! {
    /// x' = lambda (x - cos t) - sin t with the solution cos t (A. Prothero, A. Robinson, On the stability and accuracy of
    /// one-step methods for solving stiff systems of ordinary differential equations, Math. Comp. 28, 1974).
    ProtheroRobinson { lambda }, states 1, coordinates 0,
    rate |m, t, x| [m.lambda * (x[0] - t.cos()) - t.sin()],
    start |_m| [S::lit(1.0)]
}

system! {
    /// x' = cos(w t x): neither linear nor autonomous.
    Chirp { w }, states 1, coordinates 0,
    rate |m, t, x| [(m.w * t * x[0]).cos()],
    start |_m| [S::lit(0.3)]
}

system! {
    /// The plane two-body problem with the eccentricity e, from the pericentre; period 2 pi.
    Kepler { e }, states 4, coordinates 2,
    rate |_m, _t, x| {
        let square = x[0] * x[0] + x[1] * x[1];
        let cube = square * square.sqrt();
        [x[2], x[3], -x[0] / cube, -x[1] / cube]
    },
    start |m| {
        let one = S::lit(1.0);
        [one - m.e, S::ZERO, S::ZERO, ((one + m.e) / (one - m.e)).sqrt()]
    }
}

system! {
    /// q'' = ((1 - q^2) q' - q) / epsilon, van der Pol's equation in the scaling of Hairer and Wanner II, IV.1, from (2, 0).
    VanDerPol { epsilon }, states 2, coordinates 1,
    rate |m, _t, x| [x[1], ((S::lit(1.0) - x[0] * x[0]) * x[1] - x[0]) / m.epsilon],
    start |_m| [S::lit(2.0), S::ZERO]
}

system! {
    /// Robertson's chemical reaction (Hairer and Wanner II, IV.1, eq. (1.4)).
    Robertson { fast }, states 3, coordinates 0,
    rate |m, _t, x| {
        let slow = S::lit(0.04) * x[0];
        let back = S::lit(1e4) * x[1] * x[2];
        let made = m.fast * x[1] * x[1];
        [back - slow, slow - back - made, made]
    },
    start |_m| [S::lit(1.0), S::ZERO, S::ZERO],
    typical [1e-6, 1e-12, 1.0]
}

system! {
    /// A point mass of 1 kg on a spring of 1 m and the given stiffness, in a gravity of 1 m/s^2, from a horizontal spring
    /// at rest (Ch. Lubich, Integration of stiff mechanical systems by Runge-Kutta methods, ZAMP 44, 1993).
    StiffPendulum { stiffness }, states 4, coordinates 2,
    rate |m, _t, x| {
        let length = (x[0] * x[0] + x[1] * x[1]).sqrt();
        let pull = m.stiffness * (length - S::lit(1.0)) / length;
        [x[2], x[3], -(pull * x[0]), -(pull * x[1]) - S::lit(1.0)]
    },
    start |_m| [S::lit(1.0), S::ZERO, S::ZERO, S::ZERO]
}

system! {
    /// A massless rod of 1 m with a point mass, at an angle from the downward vertical, at rest.
    Rod { gravity, angle }, states 2, coordinates 1,
    rate |m, _t, x| [x[1], -(m.gravity * x[0].sin())],
    start |m| [m.angle, S::ZERO]
}

system! {
    /// Two equal point masses m on massless rods of the length l; angles from the downward vertical, absolute.
    DoublePendulum { gravity, first, second }, states 4, coordinates 2,
    rate |m, _t, x| {
        let [a, b, va, vb] = *x;
        let two = S::lit(2.0);
        let (sin, cos) = (a - b).sin_cos();
        // 2 a'' + cos b'' = f, cos a'' + b'' = g.
        let f = -(two * m.gravity * a.sin()) - sin * vb * vb;
        let g = sin * va * va - m.gravity * b.sin();
        let determinant = two - cos * cos;
        [va, vb, (f - cos * g) / determinant, (two * g - cos * f) / determinant]
    },
    start |m| [m.first, m.second, S::ZERO, S::ZERO]
}

impl DoublePendulum<f64> {
    /// Energy over m l^2.
    pub fn energy(&self, &[a, b, va, vb]: &[f64; 4]) -> f64 {
        va * va + 0.5 * vb * vb + va * vb * (a - b).cos() - self.gravity * (2.0 * a.cos() + b.cos())
    }
}

/// The spring's solution with z < 1.
pub fn spring(w: f64, z: f64, t: f64) -> [f64; 2] {
    let damped = w * (1.0 - z * z).sqrt();
    let (sin, cos) = (damped * t).sin_cos();
    let decay = (-z * w * t).exp();
    [decay * (cos + z * w / damped * sin), -(decay * w * w / damped * sin)]
}
