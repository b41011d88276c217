//! The small problem of contact at a state: joints are eliminated from accelerations, forces of rows are its unknowns.

use super::linear::{solve, solve_one};
use super::world::{Bound, Force, Law, Pose, Seen, World};

/// Mode of a row of contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    Open,
    Closed,
    Off,
    Sticks,
    Forwards,
    Backwards,
}

impl Mode {
    pub fn holds(self) -> bool {
        matches!(self, Self::Closed | Self::Sticks)
    }

    pub fn sign(self) -> f64 {
        match self {
            Self::Forwards => 1.0,
            Self::Backwards => -1.0,
            _ => 0.0,
        }
    }
}

/// A number that is affine in the forces of the rows.
#[derive(Clone, Debug)]
pub struct Affine {
    pub own: f64,
    pub by: Vec<f64>,
}

impl Affine {
    pub fn at(&self, lambda: &[f64]) -> f64 {
        self.own + self.by.iter().zip(lambda).map(|(by, lambda)| by * lambda).sum::<f64>()
    }
}

/// Accelerations of the rows are c + D lambda.
#[derive(Clone, Debug)]
pub struct Problem {
    pub laws: Vec<Law>,
    pub rows: Vec<Seen>,
    pub c: Vec<f64>,
    pub d: Vec<Vec<f64>>,
    /// Forces of the joints' rows.
    pub joints: Vec<Affine>,
    free: Vec<f64>,
    /// Accelerations of the coordinates by a unit force of each row, with the reactions of the joints to it.
    response: Vec<Vec<f64>>,
}

/// A sparse product.
fn dot(a: &Seen, b: &Seen, inertia: &[f64]) -> f64 {
    let of = |k: usize| b.slopes.iter().filter(move |(l, _)| *l == k);
    a.slopes.iter().map(|(k, x)| of(*k).map(|(_, y)| x * y / inertia[*k]).sum::<f64>()).sum()
}

impl Problem {
    pub fn new(world: &World, t: f64, q: &[f64], v: &[f64]) -> Self {
        let (n, pose) = (world.inertia.len(), Pose::new(t, q, v));
        let mut h = vec![0.0; n];
        for (k, h) in h.iter_mut().enumerate().filter(|(k, _)| k % 3 != 2) {
            *h = world.inertia[k] * world.gravity[k % 3];
        }
        for force in &world.forces {
            match force {
                Force::On { coordinate, constant, amplitude, omega, phase } => {
                    h[*coordinate] += constant + amplitude * (omega * t + phase).sin();
                }
                Force::Spring { place, stiffness, rest, damping } => {
                    let seen = place.see(&pose);
                    let force = stiffness * (seen.value - rest) + damping * seen.rate;
                    seen.slopes.iter().for_each(|(k, slope)| h[*k] -= force * slope);
                }
            }
        }
        let mut free: Vec<f64> = h.iter().zip(&world.inertia).map(|(h, m)| h / m).collect();
        let joints: Vec<Seen> = world.joints.iter().map(|place| place.see(&pose)).collect();
        let rows: Vec<Seen> = world.rows.iter().map(|(place, _)| place.see(&pose)).collect();
        let laws = world.rows.iter().map(|(_, law)| *law).collect();
        let along =
            |seen: &Seen, a: &[f64]| seen.zeta + seen.slopes.iter().map(|(k, w)| w * a[*k]).sum::<f64>();
        // The forces of the joints, without those of the rows, and by each of them.
        let matrix =
            joints.iter().map(|a| joints.iter().map(|b| dot(a, b, &world.inertia)).collect()).collect();
        let right = joints.iter().map(|a| {
            let own = -along(a, &free);
            std::iter::once(own).chain(rows.iter().map(|b| -dot(a, b, &world.inertia))).collect()
        });
        // Where joints are singular nothing is a number.
        let unknown = || vec![vec![f64::NAN; 1 + rows.len()]; joints.len()];
        let forces = solve(matrix, right.collect()).map_or_else(unknown, |(forces, _)| forces);
        let forces: Vec<Affine> =
            forces.into_iter().map(|row| Affine { own: row[0], by: row[1..].to_vec() }).collect();
        for (joint, force) in joints.iter().zip(&forces) {
            joint.slopes.iter().for_each(|(k, w)| free[*k] += w * force.own / world.inertia[*k]);
        }
        let response = rows.iter().enumerate().map(|(j, row)| {
            let mut moved = vec![0.0; n];
            row.slopes.iter().for_each(|(k, w)| moved[*k] += w / world.inertia[*k]);
            for (joint, force) in joints.iter().zip(&forces) {
                joint.slopes.iter().for_each(|(k, w)| moved[*k] += w * force.by[j] / world.inertia[*k]);
            }
            moved
        });
        let response: Vec<Vec<f64>> = response.collect();
        let product = |row: &Seen, a: &[f64]| row.slopes.iter().map(|(k, w)| w * a[*k]).sum::<f64>();
        let d = rows.iter().map(|row| response.iter().map(|moved| product(row, moved)).collect()).collect();
        let c = rows.iter().map(|row| along(row, &free)).collect();
        Self { laws, rows, c, d, joints: forces, free, response }
    }

    /// Problem of an impact: rates in the place of accelerations and impulses in that of forces. Own bounds carry no impulse.
    pub fn of_rates(&self) -> Self {
        let mut problem = self.clone();
        problem.c = self.rows.iter().map(|row| row.rate).collect();
        problem.joints.iter_mut().for_each(|joint| joint.own = 0.0);
        for law in &mut problem.laws {
            if let Law::Rub(bound) = law {
                (bound.own, bound.adhesion) = ([0.0; 2], 1.0);
            }
        }
        problem
    }

    pub fn count(&self) -> usize {
        self.rows.len()
    }

    /// Accelerations of the coordinates.
    pub fn accelerations(&self, lambda: &[f64]) -> Vec<f64> {
        let mut a = self.free.clone();
        self.push(lambda, &mut a);
        a
    }

    /// Adds what forces add to accelerations, or impulses to velocities.
    pub fn push(&self, lambda: &[f64], a: &mut [f64]) {
        for (moved, lambda) in self.response.iter().zip(lambda) {
            a.iter_mut().zip(moved).for_each(|(a, moved)| *a += moved * lambda);
        }
    }

    /// The acceleration of a row, and the size of its terms.
    pub fn acceleration(&self, row: usize, lambda: &[f64]) -> (f64, f64) {
        let terms = self.d[row].iter().zip(lambda).map(|(d, lambda)| d * lambda);
        terms.fold((self.c[row], self.c[row].abs()), |(sum, size), x| (sum + x, size + x.abs()))
    }

    fn joint(&self, bound: &Bound, lambda: &[f64]) -> [f64; 2] {
        let Some((x, y, _)) = bound.joint else { return [0.0; 2] };
        [self.joints[x].at(lambda), y.map_or(0.0, |y| self.joints[y].at(lambda))]
    }

    /// The largest force of friction against a slip forwards (0) or backwards (1).
    pub fn bound(&self, row: usize, side: usize, lambda: &[f64]) -> f64 {
        let Law::Rub(bound) = &self.laws[row] else { return 0.0 };
        let [x, y] = self.joint(bound, lambda);
        let share = bound.joint.map_or(0.0, |(_, _, share)| share);
        bound.own[side] + bound.by.map_or(0.0, |(k, mu)| mu * lambda[k]) + share * x.hypot(y)
    }

    /// The force of the joint that bounds a row, where it is along a line.
    pub fn line(&self, row: usize, lambda: &[f64]) -> Option<f64> {
        match &self.laws[row] {
            Law::Rub(bound @ Bound { joint: Some((_, None, _)), .. }) => Some(self.joint(bound, lambda)[0]),
            _ => None,
        }
    }

    /// The forces in these modes, with the determinant of their equations; `guess` is where Newton's method begins.
    pub fn forces(&self, modes: &[Mode], guess: &[f64]) -> Option<(Vec<f64>, f64)> {
        let active: Vec<usize> =
            (0..self.count()).filter(|i| modes[*i].holds() || modes[*i].sign() != 0.0).collect();
        let mut lambda = guess.to_vec();
        for _ in 0..60 {
            let (mut matrix, mut right) = (Vec::new(), Vec::new());
            for i in &active {
                let (row, b) = self.equation(*i, modes[*i], &lambda);
                matrix.push(active.iter().map(|j| row[*j]).collect());
                right.push(b);
            }
            let (found, determinant) =
                if active.is_empty() { (Vec::new(), 1.0) } else { solve_one(matrix, &right)? };
            let mut next = vec![0.0; self.count()];
            active.iter().zip(found).for_each(|(i, x)| next[*i] = x);
            let size = next.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let change = next.iter().zip(&lambda).fold(0.0, |size: f64, (a, b)| size.max((a - b).abs()));
            lambda = next;
            let is_linear = !active.iter().any(|i| {
                modes[*i].sign() != 0.0 && matches!(self.laws[*i], Law::Rub(Bound { joint: Some(_), .. }))
            });
            if is_linear || change <= 1e-14 * size {
                return Some((lambda, determinant));
            }
        }
        None
    }

    /// A row of the equations of the forces. The size of a joint's force is taken along its last direction.
    fn equation(&self, i: usize, mode: Mode, lambda: &[f64]) -> (Vec<f64>, f64) {
        let Law::Rub(bound) = &self.laws[i] else { return (self.d[i].clone(), -self.c[i]) };
        if mode.holds() {
            return (self.d[i].clone(), -self.c[i]);
        }
        let (sign, side) = (mode.sign(), usize::from(mode == Mode::Backwards));
        let (mut row, mut own) = (vec![0.0; self.count()], bound.own[side]);
        if let Some((k, mu)) = bound.by {
            row[k] += sign * mu;
        }
        if let Some((x, y, share)) = bound.joint {
            let [rx, ry] = self.joint(bound, lambda);
            let size = rx.hypot(ry);
            for (joint, r) in [(Some(x), rx), (y, ry)] {
                let Some(joint) = joint.filter(|_| size > 0.0) else { continue };
                let joint = &self.joints[joint];
                own += share * r / size * joint.own;
                row.iter_mut().zip(&joint.by).for_each(|(row, by)| *row += sign * share * r / size * by);
            }
        }
        row[i] += 1.0;
        (row, -sign * own)
    }

    /// Do the rows that hold leave the row no freedom?
    pub fn depends(&self, row: usize, modes: &[Mode]) -> bool {
        let held: Vec<usize> = (0..self.count()).filter(|i| modes[*i].holds()).collect();
        if held.is_empty() {
            return false;
        }
        let matrix = held.iter().map(|i| held.iter().map(|j| self.d[*i][*j]).collect()).collect();
        let right: Vec<f64> = held.iter().map(|i| self.d[*i][row]).collect();
        let Some((y, _)) = solve_one(matrix, &right) else { return false };
        let own = y.iter().zip(&right).fold(self.d[row][row], |own, (y, d)| own - y * d);
        own < 1e-9 * self.d[row][row]
    }
}
