//! Shapes of the modes of a linearisation: eigenvectors, and states along them.

use nalgebra::{Complex, DMatrix, DVector};
use plm_runtime::{Moment, Rate, Vector};

use crate::analysis::linearise::{Linearisation, Mode};

/// A mode with its shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The mode; of an oscillation the eigenvalue with a positive imaginary part.
    pub mode: Mode,
    /// How far coordinates, velocities and first-order states swing, and with which phase, in the order of the states of the
    /// linearisation. The largest coordinate has 1.
    pub vector: Vec<Complex<f64>>,
}

impl Shape {
    /// The change of the state at a phase, rad, of a swing without damping whose largest coordinate swings by `amplitude`, m or rad.
    pub fn change(&self, amplitude: f64, phase: f64) -> Vec<f64> {
        let turn = Complex::from_polar(amplitude, phase);
        self.vector.iter().map(|own| (own * turn).re).collect()
    }

    /// A state that is moved by a change of its numbers. Loops in joint coordinates stay closed.
    pub fn moved<T: Moment<M: Rate<S = f64>>>(&self, state: &T, (amplitude, phase): (f64, f64)) -> T {
        let (mechanism, mut x) = (state.mechanism(), *state.x());
        let own = (0..<<T::M as Rate>::X as Vector<f64>>::LEN).filter(|place| mechanism.has_number(*place));
        for (place, change) in own.zip(self.change(amplitude, phase)) {
            x.set(place, x.at(place) + change);
        }
        let mut moved = *state;
        moved.set(state.time(), &state.held(), &x);
        moved
    }
}

/// Eigenvalues nearer to each other than this fraction of the largest belong together.
const TOGETHER: f64 = 1e-7;
/// Steps of the inverse iteration; one is enough but for bad luck.
const STEPS: usize = 4;

impl Linearisation {
    /// The modes with their shapes, slow ones first, by inverse iteration (J. H. Wilkinson, The Algebraic Eigenvalue Problem, 1965, 5.54).
    /// Modes of one eigenvalue have independent shapes, as far as there are any.
    pub fn shapes(&self) -> Vec<Shape> {
        let modes: Vec<Mode> = self.modes().into_iter().filter(|mode| mode.eigenvalue.im >= 0.0).collect();
        let largest = modes.iter().fold(0.0, |largest: f64, mode| largest.max(mode.frequency));
        let mut found: Vec<(Mode, DVector<Complex<f64>>)> = Vec::new();
        for mode in modes {
            let near = |other: &Mode| (other.eigenvalue - mode.eigenvalue).norm() <= TOGETHER * largest;
            let beside: Vec<_> =
                found.iter().filter(|(other, _)| near(other)).map(|(_, vector)| vector.clone()).collect();
            let vector = self.eigenvector(&mode, &beside, largest);
            found.push((mode, vector));
        }
        found.into_iter().map(|(mode, vector)| Shape { mode, vector: self.shown(&vector) }).collect()
    }

    /// A vector of A - lambda that is independent of others.
    fn eigenvector(
        &self,
        mode: &Mode,
        beside: &[DVector<Complex<f64>>],
        largest: f64,
    ) -> DVector<Complex<f64>> {
        let size = self.a.nrows();
        // Beside the eigenvalue, so that the matrix has an inverse.
        let shift = mode.eigenvalue + 1e-9 * largest.max(f64::MIN_POSITIVE);
        let matrix = self.a.map(|entry| Complex::new(entry, 0.0)) - DMatrix::identity(size, size) * shift;
        let lu = matrix.lu();
        let mut vector =
            DVector::from_fn(size, |k, _| Complex::new(1.0 + 0.37 * ((k + 1) as f64).sin(), 0.0));
        for _ in 0..STEPS {
            for other in beside {
                let part = other.dotc(&vector);
                vector.axpy(-part, other, Complex::new(1.0, 0.0));
            }
            let Some(next) = lu.solve(&vector).filter(|next| next.iter().all(|own| own.norm().is_finite()))
            else {
                break;
            };
            let length = next.norm();
            vector = next / Complex::new(length, 0.0);
        }
        vector
    }

    /// Along all states, turned and scaled so that the largest coordinate is 1.
    fn shown(&self, vector: &DVector<Complex<f64>>) -> Vec<Complex<f64>> {
        let all = self.basis.map(|entry| Complex::new(entry, 0.0)) * vector;
        let coordinates = (0..self.coordinates).map(|k| all[k]);
        let largest = coordinates
            .fold(Complex::new(0.0, 0.0), |a, b| if b.norm() > a.norm() * (1.0 + 1e-9) { b } else { a });
        let unit = if largest.norm() > 0.0 { largest.inv() } else { Complex::new(1.0, 0.0) };
        all.iter().map(|own| own * unit).collect()
    }
}
