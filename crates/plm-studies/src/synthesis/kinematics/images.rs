//! All images of a mechanism of dyads: every way in which it can be assembled.

use crate::synthesis::four_bar::{Image, Point, Vector, dyad, point, vector};

/// How a point is built from earlier ones, which count from 0: the given points first, then each built one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Build {
    /// Pin of a dyad of two bars: at these distances from two points, m. Two images.
    Pin {
        /// The two points.
        from: [usize; 2],
        /// Lengths of the bars, m.
        lengths: [f64; 2],
    },
    /// Pin of a bar whose other end slides: at a distance from a point, m, on the line through two others. Two images.
    OnLine {
        /// The point.
        from: usize,
        /// Length of the bar, m.
        length: f64,
        /// Two points of the line.
        line: [usize; 2],
    },
    /// Point of a body that two points belong to: in the frame of the first with the x-axis through the second, m. One image.
    OnBody {
        /// The two points.
        body: [usize; 2],
        /// Its coordinates, m.
        at: Point,
    },
}

/// Why there are no images.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoImages {
    /// This step, from 0, names a point that is not built yet.
    Unbuilt {
        /// The step.
        step: usize,
    },
}

impl std::fmt::Display for NoImages {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self::Unbuilt { step } = self;
        write!(f, "step {step} names a point that is not built yet")
    }
}

impl std::error::Error for NoImages {}

/// All images of a mechanism that is built of dyads from given points (pivots, and pins of cranks at their angles), m: each a list of the
/// given points and of all built ones. Empty where no image closes. N dyads have up to 2^N images.
///
/// # Errors
/// [`NoImages`].
pub fn images(given: &[Point], steps: &[Build]) -> Result<Vec<Vec<Point>>, NoImages> {
    for (step, build) in steps.iter().enumerate() {
        let built = given.len() + step;
        let named = match *build {
            Build::Pin { from, .. } => from.to_vec(),
            Build::OnLine { from, line, .. } => vec![from, line[0], line[1]],
            Build::OnBody { body, .. } => body.to_vec(),
        };
        if named.iter().any(|&k| k >= built) {
            return Err(NoImages::Unbuilt { step });
        }
    }
    let mut all = vec![given.to_vec()];
    for step in steps {
        let grown = |points: Vec<Point>| {
            let next = built(step, &points);
            next.into_iter().map(move |next| [points.as_slice(), &[next]].concat())
        };
        all = all.into_iter().flat_map(grown).collect();
    }
    Ok(all)
}

fn built(step: &Build, points: &[Point]) -> Vec<Point> {
    let at = |k: usize| vector(points[k]);
    match *step {
        Build::Pin { from, lengths } => {
            let [one, other] = from.map(at);
            let on = |image| dyad(other - one, lengths[0], lengths[1], image);
            let ends = [Image::Left, Image::Right].into_iter().filter_map(on);
            ends.map(|bar| point(one + bar)).collect()
        }
        Build::OnLine { from, length, line } => {
            let [start, end] = line.map(at);
            let along = (end - start) / (end - start).norm();
            let foot = (at(from) - start) * along.conj();
            let square = length * length - foot.im * foot.im;
            let reach = if square >= 0.0 { vec![square.sqrt(), -square.sqrt()] } else { Vec::new() };
            reach.into_iter().map(|way| point(start + along * (foot.re + way))).collect()
        }
        Build::OnBody { body, at: [x, y] } => {
            let [one, other] = body.map(at);
            let along = (other - one) / (other - one).norm();
            vec![point(one + along * Vector::new(x, y))]
        }
    }
}
