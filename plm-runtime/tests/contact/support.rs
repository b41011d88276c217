//! Systems with contact rows, written by hand: what a generated system does with its rows.

use plm_runtime::Scalar;
use plm_runtime::contact::{self, Law, Rows};

/// A scene: bodies on coordinates q with velocities v, and `N` rows.
pub(crate) trait Scene<const NQ: usize, const N: usize>: Copy {
    /// Laws of the rows.
    fn laws(&self) -> [Law<f64>; N];
    /// Accelerations without contact forces.
    fn free<T: Scalar>(&self, t: T, q: [T; NQ], v: [T; NQ]) -> [T; NQ];
    /// The inverse of the mass matrix; the identity unless a scene has another one.
    fn inverse_mass<T: Scalar>(&self, q: [T; NQ]) -> [[T; NQ]; NQ] {
        let _ = q;
        core::array::from_fn(|i| core::array::from_fn(|k| if i == k { T::lit(1.0) } else { T::ZERO }))
    }
    /// Displacements, directions w and what accelerations lack: z'' = w a + zeta; z' = w v + r.
    fn contact<T: Scalar>(&self, t: T, q: [T; NQ], v: [T; NQ]) -> [Row<T, NQ>; N];
    /// Limits of friction.
    fn friction<T: Scalar>(&self, t: T, q: [T; NQ], v: [T; NQ], rows: &mut Rows<T, N>) {
        let _ = (t, q, v, rows);
    }
    fn impacts(&self) -> contact::ImpactLaw {
        contact::ImpactLaw::default()
    }
    fn start(&self) -> ([f64; NQ], [f64; NQ]);
}

/// One row.
#[derive(Clone, Copy)]
pub(crate) struct Row<T, const NQ: usize> {
    pub(crate) gap: T,
    pub(crate) direction: [T; NQ],
    /// r: the part of the rate that time alone gives.
    pub(crate) drive: T,
    /// zeta.
    pub(crate) rest: T,
}

impl<T: Scalar, const NQ: usize> Row<T, NQ> {
    pub(crate) fn fixed(gap: T, direction: [T; NQ]) -> Self {
        Self { gap, direction, drive: T::ZERO, rest: T::ZERO }
    }
}

pub(crate) fn dot<T: Scalar, const K: usize>(a: &[T; K], b: &[T; K]) -> T {
    a.iter().zip(b).fold(T::ZERO, |sum, (a, b)| sum + *a * *b)
}

/// The rows of a scene.
pub(crate) fn rows<T: Scalar, C: Scene<NQ, N>, const NQ: usize, const N: usize>(
    scene: &C,
    t: T,
    x: &impl Fn(usize) -> T,
) -> Rows<T, N> {
    let (q, v): ([T; NQ], [T; NQ]) = (core::array::from_fn(x), core::array::from_fn(|i| x(NQ + i)));
    let (free, inverse, contact) = (scene.free(t, q, v), scene.inverse_mass(q), scene.contact(t, q, v));
    let moved: [[T; NQ]; N] =
        core::array::from_fn(|j| core::array::from_fn(|k| dot(&inverse[k], &contact[j].direction)));
    let mut rows = Rows::none();
    for i in 0..N {
        let row = &contact[i];
        rows.gap[i] = row.gap;
        rows.rate[i] = dot(&row.direction, &v) + row.drive;
        rows.free[i] = dot(&row.direction, &free) + row.rest;
        rows.bias[i] = row.rest;
        for j in 0..N {
            rows.delassus[i][j] = dot(&row.direction, &moved[j]);
        }
    }
    scene.friction(t, q, v, &mut rows);
    rows
}

pub(crate) fn response<C: Scene<NQ, N>, const NQ: usize, const N: usize>(
    scene: &C,
    t: f64,
    x: &impl Fn(usize) -> f64,
    lambda: &[f64; N],
) -> [f64; NQ] {
    let (q, v): ([f64; NQ], [f64; NQ]) = (core::array::from_fn(x), core::array::from_fn(|i| x(NQ + i)));
    let (inverse, contact) = (scene.inverse_mass(q), scene.contact(t, q, v));
    let force: [f64; NQ] =
        core::array::from_fn(|k| (0..N).fold(0.0, |sum, i| sum + contact[i].direction[k] * lambda[i]));
    core::array::from_fn(|k| dot(&inverse[k], &force))
}

/// A scene as a system: `system!(scene type, coordinates, rows)`, and what is held, where that is not the modes alone.
macro_rules! system {
    ($scene:ident, $nq:literal, $n:literal) => {
        $crate::support::system!($scene, $nq, $n, plm_runtime::contact::Modes<f64, $n>);
    };
    ($scene:ident, $nq:literal, $n:literal, $held:ty) => {
        impl plm_runtime::Rate for $scene {
            type S = f64;
            type X = [f64; 2 * $nq];
            type U = $held;
            const NQ: usize = $nq;

            fn rate(&self, t: f64, u: &Self::U, x: &Self::X, dx: &mut Self::X) -> plm_runtime::Health<f64> {
                plm_runtime::contact::rate::<Self, $n>(self, t, u, x, dx)
            }
        }

        impl plm_runtime::contact::Contacts<$n> for $scene {
            fn law(&self, row: usize) -> plm_runtime::contact::Law<f64> {
                $crate::support::Scene::laws(self)[row]
            }
            fn rows<T: plm_runtime::Scalar>(
                &self,
                t: T,
                _u: &Self::U,
                x: &impl Fn(usize) -> T,
                _constant: &impl Fn(f64) -> T,
            ) -> plm_runtime::contact::Rows<T, $n> {
                $crate::support::rows(self, t, x)
            }
            fn free_rate(
                &self,
                t: f64,
                _u: &Self::U,
                x: &Self::X,
                dx: &mut Self::X,
            ) -> plm_runtime::Health<f64> {
                let (q, v) = (core::array::from_fn(|i| x[i]), core::array::from_fn(|i| x[$nq + i]));
                let free: [f64; $nq] = $crate::support::Scene::free(self, t, q, v);
                for i in 0..$nq {
                    (dx[i], dx[$nq + i]) = (v[i], free[i]);
                }
                plm_runtime::Health::perfect()
            }
            fn response(&self, t: f64, _u: &Self::U, x: &Self::X, lambda: &[f64; $n]) -> Self::X {
                let moved: [f64; $nq] = $crate::support::response(self, t, &|i| x[i], lambda);
                core::array::from_fn(|i| if i < $nq { 0.0 } else { moved[i - $nq] })
            }
            fn impact_law(&self) -> plm_runtime::contact::ImpactLaw {
                $crate::support::Scene::impacts(self)
            }
        }

        impl plm_runtime::Constraints for $scene {
            fn project(&self, t: f64, u: &Self::U, x: &mut Self::X) -> Result<(), plm_runtime::Fault> {
                plm_runtime::contact::project::<Self, $n>(self, t, u, x)
            }
            fn drift(&self, t: f64, u: &Self::U, x: &Self::X) -> plm_runtime::Drift<f64> {
                plm_runtime::contact::drift::<Self, $n>(self, t, u, x)
            }
        }

        impl plm_runtime::Events for $scene {
            type G = [f64; plm_runtime::contact::guard_count($n)];
            fn guards(&self, t: f64, u: &Self::U, x: &Self::X, g: &mut Self::G) {
                plm_runtime::contact::guards::<Self, $n>(self, t, u, x, &mut |i, margin| g[i] = margin);
            }
            fn switch(
                &self,
                t: f64,
                u: &mut Self::U,
                x: &mut Self::X,
                index: usize,
            ) -> Result<(), plm_runtime::Fault> {
                plm_runtime::contact::switch::<Self, $n>(self, t, u, x, index).map(|_| ())
            }
            fn switch_after(
                &self,
                t: f64,
                u: &mut Self::U,
                x: &mut Self::X,
                at: (usize, f64),
            ) -> Result<(), plm_runtime::Fault> {
                plm_runtime::contact::switch_after::<Self, $n>(self, t, u, x, at).map(|_| ())
            }
            const CONTACTS: usize = $n;
            fn contacts(u: &Self::U) -> plm_runtime::contact::Status<'_> {
                plm_runtime::contact::Modal::status(u)
            }
            fn change_contact(u: &mut Self::U, change: plm_runtime::contact::Change) {
                plm_runtime::contact::Modal::modes_mut(u).change = change;
            }
            fn stride<const EVALUATIONS: usize>(
                &self,
                stride: &plm_runtime::contact::Stride<f64>,
                u: &mut Self::U,
                x: &mut Self::X,
                after: impl FnOnce(
                    &mut Self::U,
                    &mut Self::X,
                    &plm_runtime::contact::Solution<f64>,
                ) -> Result<(), plm_runtime::Fault>,
            ) -> Result<plm_runtime::contact::Solution<f64>, plm_runtime::Fault> {
                plm_runtime::contact::step::<Self, $n, EVALUATIONS>(self, stride, u, x, after)
            }
            fn guards_within(
                &self,
                t: plm_runtime::Enclosed<f64>,
                u: &Self::U,
                x: &impl Fn(usize) -> plm_runtime::Enclosed<f64>,
                each: &mut impl FnMut(usize, plm_runtime::Enclosed<f64>),
            ) -> bool {
                plm_runtime::contact::guards_within::<Self, $n>(self, t, u, x, each)
            }
        }

        impl plm_runtime::Labels for $scene {}

        impl plm_runtime::Mechanism for $scene {
            type State = plm_runtime::At<Self>;
            type Rescue = plm_runtime::singular::Never<Self>;

            fn start_state(&self, t: f64) -> Result<(Self::U, Self::X), plm_runtime::Fault> {
                let (q, v) = $crate::support::Scene::start(self);
                let mut x = core::array::from_fn(|i| if i < $nq { q[i] } else { v[i - $nq] });
                let mut u = <$held>::open();
                plm_runtime::contact::begin::<Self, $n>(self, t, &mut u, &mut x)?;
                Ok((u, x))
            }
        }
    };
}
pub(crate) use system;
