//! Power series in time of everything that the equations are made of, order by order.
//!
//! Recurrences as in R. E. Moore, Interval Analysis (1966), chapter 11, and À. Jorba, M. Zou, A software package for the
//! numerical integration of ODEs by means of high-order Taylor methods, Experiment. Math. 14 (2005), section 2.

use super::dd::{Dd, Sum, convolved, summed};

/// A node of the tape, by number.
pub type Id = usize;

enum Node {
    /// A coordinate: its series is put in from outside.
    Coordinate(usize),
    /// Sine of a node that holds an angle; the node after it is the cosine.
    Sine(Id),
    /// Cosine of the angle; the node before it is the sine.
    Cosine(Id),
    /// A constant and multiples of nodes.
    Linear(Dd, Vec<(Id, Dd)>),
    Product(Id, Id),
}

/// Nodes in an order in which each reads only those before it.
#[derive(Default)]
pub struct Tape {
    nodes: Vec<Node>,
    /// Coefficients, one list a node.
    pub series: Vec<Vec<Dd>>,
    /// Corrections by [`Tape::correct`] to the coefficients of the last order, by node.
    gain: Vec<Dd>,
    /// `1/k` of every order `k` but zero.
    inverse: Vec<Dd>,
}

impl Tape {
    fn push(&mut self, node: Node) -> Id {
        self.nodes.push(node);
        self.series.push(Vec::new());
        self.nodes.len() - 1
    }

    pub fn coordinate(&mut self, index: usize) -> Id {
        self.push(Node::Coordinate(index))
    }

    /// Sine and cosine.
    pub fn sin_cos(&mut self, angle: Id) -> (Id, Id) {
        (self.push(Node::Sine(angle)), self.push(Node::Cosine(angle)))
    }

    pub fn linear(&mut self, constant: Dd, terms: &[(Id, Dd)]) -> Id {
        self.push(Node::Linear(constant, terms.to_vec()))
    }

    pub fn product(&mut self, a: Id, b: Id) -> Id {
        self.push(Node::Product(a, b))
    }

    /// Room for series up to an order.
    pub fn reserve(&mut self, order: usize) {
        for series in &mut self.series {
            series.clear();
            series.resize(order + 1, Dd::ZERO);
        }
        self.gain.resize(self.nodes.len(), Dd::ZERO);
        self.inverse = (0..=order).map(|k| Dd::ONE / Dd::from(k.max(1) as f64)).collect();
    }

    /// Coefficients of order `k` from those of the coordinates and of lower orders.
    pub fn evaluate(&mut self, k: usize, coordinates: &[Vec<Dd>]) {
        for id in 0..self.nodes.len() {
            let value = match &self.nodes[id] {
                Node::Coordinate(index) => coordinates[*index][k],
                Node::Sine(angle) if k == 0 => {
                    let (sine, cosine) = self.series[*angle][0].sin_cos();
                    self.series[id + 1][0] = cosine;
                    sine
                }
                Node::Cosine(_) if k == 0 => self.series[id][0],
                Node::Sine(angle) => self.rotated(*angle, id + 1, k),
                Node::Cosine(angle) => -self.rotated(*angle, id - 1, k),
                Node::Linear(constant, terms) => {
                    let first = if k == 0 { *constant } else { Dd::ZERO };
                    summed(first, terms.iter().map(|(node, factor)| (self.series[*node][k], *factor)))
                }
                Node::Product(a, b) => convolved(&self.series[*a], &self.series[*b], k),
            };
            self.series[id][k] = value;
        }
    }

    /// Of order `k` in the integral of the angle's rate times `other`.
    fn rotated(&self, angle: Id, other: Id, k: usize) -> Dd {
        let (angle, other) = (&self.series[angle], &self.series[other]);
        let rates = angle[..=k].iter().enumerate().map(|(j, angle)| angle.times(j as f64));
        summed(Dd::ZERO, rates.zip(other[..=k].iter().rev().copied())) * self.inverse[k]
    }

    /// Brings order `k` up to date after the coordinates of that order, zero until now, were found. What is linear in
    /// them has the derivatives of order zero as factors.
    pub fn correct(&mut self, k: usize, coordinates: &[Vec<Dd>]) {
        for id in 0..self.nodes.len() {
            let gain = match &self.nodes[id] {
                Node::Coordinate(index) => coordinates[*index][k],
                Node::Sine(angle) => self.gain[*angle] * self.series[id + 1][0],
                Node::Cosine(angle) => -self.gain[*angle] * self.series[id - 1][0],
                Node::Linear(_, terms) => {
                    summed(Dd::ZERO, terms.iter().map(|(node, factor)| (self.gain[*node], *factor)))
                }
                Node::Product(a, b) => {
                    let first = Sum::from(Dd::ZERO).plus(self.series[*a][0], self.gain[*b]);
                    first.plus(self.gain[*a], self.series[*b][0]).value()
                }
            };
            self.gain[id] = gain;
            self.series[id][k] += gain;
        }
    }
}
