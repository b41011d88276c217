//! Straightness of a path: its longest portion between two near parallel lines.

/// A portion of a closed path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Portion {
    /// Number of its first sample.
    pub first: usize,
    /// Number of its samples.
    pub count: usize,
    /// Extent along its line.
    pub length: f64,
    /// Half its extent across: the greatest distance from its line.
    pub deviation: f64,
}

/// Sums over the samples before each, of x, y, x^2, x y, y^2, about the first sample.
type Sums = Vec<[f64; 5]>;

fn sums(path: &[[f64; 2]]) -> Sums {
    let mut sums = vec![[0.0; 5]];
    let mut sum = [0.0; 5];
    for k in 0..2 * path.len() {
        let [x, y] = relative(path, k);
        for (sum, term) in sum.iter_mut().zip([x, y, x * x, x * y, y * y]) {
            *sum += term;
        }
        sums.push(sum);
    }
    sums
}

fn relative(path: &[[f64; 2]], k: usize) -> [f64; 2] {
    let ([x, y], [x0, y0]) = (path[k % path.len()], path[0]);
    [x - x0, y - y0]
}

/// The portion of so many samples, with the direction of least squares of the distances as that of its line.
fn portion(path: &[[f64; 2]], sums: &Sums, first: usize, count: usize) -> Portion {
    let n = count as f64;
    let [x, y, xx, xy, yy] = std::array::from_fn(|k| (sums[first + count][k] - sums[first][k]) / n);
    // The principal axis of the covariance.
    let angle = 0.5 * (2.0 * (xy - x * y)).atan2((xx - x * x) - (yy - y * y));
    let (sin, cos) = angle.sin_cos();
    let [mut along, mut across] = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for k in first..first + count {
        let [x, y] = relative(path, k);
        for (range, value) in [(&mut along, x * cos + y * sin), (&mut across, y * cos - x * sin)] {
            *range = [range[0].min(value), range[1].max(value)];
        }
    }
    Portion { first, count, length: along[1] - along[0], deviation: 0.5 * (across[1] - across[0]) }
}

/// The portion that begins with a sample and has so many.
pub fn portion_of(path: &[[f64; 2]], first: usize, count: usize) -> Portion {
    portion(path, &sums(path), first, count)
}

/// The longest portion of at least so many samples whose deviation is at most a fraction of its length, of the portions that begin with
/// each sample and have a multiple of `least/4` samples.
pub fn longest(path: &[[f64; 2]], least: usize, fraction: f64) -> Option<Portion> {
    let sums = sums(path);
    let mut best: Option<Portion> = None;
    for first in 0..path.len() {
        for count in (least..=path.len()).step_by((least / 4).max(1)) {
            let found = portion(path, &sums, first, count);
            let is_straight = found.deviation <= fraction * found.length;
            if is_straight && best.is_none_or(|best| found.length > best.length) {
                best = Some(found);
            }
            // Longer ones hold this one, and are as wide at least.
            if found.deviation > 4.0 * fraction * found.length {
                break;
            }
        }
    }
    best
}
