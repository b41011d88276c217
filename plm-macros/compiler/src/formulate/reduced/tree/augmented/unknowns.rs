//! Unknowns of the linearised equations, and the order of their elimination.

use crate::collect::CollectVec;
use crate::sorted::sort_by_key;
use crate::sorted::{SortedMap, SortedSet};

use plm_cas::{Expr, Vec2, algebra};

use crate::derive::Equations;
use crate::formulate::linearised::Part;
use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};
use crate::formulate::reduced::motion::Motion;
use crate::model::Model;

/// Everything that is solved for, and the symbols that stand for it.
pub(crate) struct Unknowns {
    /// Second derivatives of the coordinates.
    pub(crate) accelerations: Vec<Expr>,
    /// Force through the joint of each body.
    pub(crate) forces: Vec<Vec2>,
    /// Column of a symbol: unknown and part of it.
    pub(crate) column: SortedMap<Expr, (usize, Part)>,
    /// By body: acceleration and force, then place and velocity where they are wanted.
    pub(crate) of_body: Vec<SortedMap<Kind, [usize; 2]>>,
    states: usize,
    count: usize,
}

/// Unknowns of a body, in the order of elimination.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    Force,
    Acceleration,
    Velocity,
    Place,
}

impl Unknowns {
    pub(crate) fn new(model: &Model, equations: &Equations, motion: &Motion) -> Unknowns {
        let coordinates = motion.coordinates;
        let n = coordinates.unknowns.len();
        let bodies = model.bodies.len();
        let mut unknowns = Unknowns {
            accelerations: (0..n).map(|_| Expr::symbol("acceleration")).collect_vec(),
            forces: (0..bodies)
                .map(|_| Vec2::new(Expr::symbol("force_x"), Expr::symbol("force_y")))
                .collect_vec(),
            column: SortedMap::new(),
            of_body: vec![SortedMap::new(); bodies],
            states: equations.x.len(),
            count: n + equations.x.len(),
        };
        for k in 0..n {
            unknowns.column.insert(motion.value[k], (k, Part::Position));
            unknowns.column.insert(motion.rate[k], (k, Part::Velocity));
            unknowns.column.insert(unknowns.accelerations[k], (k, Part::Acceleration));
        }
        for (k, &state) in equations.x.iter().enumerate() {
            unknowns.column.insert(state, (n + k, Part::Value));
        }
        for (body, declared) in model.bodies.iter().enumerate() {
            if let Some(angle) =
                coordinates.angle_of_orientation[coordinates.absolute_angles[body].orientation]
            {
                unknowns.column.insert(declared.q[2], (angle, Part::Position));
                unknowns.column.insert(declared.v[2], (angle, Part::Velocity));
            }
            let force = unknowns.forces[body];
            unknowns.add(body, Kind::Force, force);
            unknowns.add(body, Kind::Acceleration, Vec2::new(declared.a[0], declared.a[1]));
        }
        unknowns.add_wanted(model, equations, coordinates);
        unknowns
    }

    fn add(&mut self, body: usize, kind: Kind, symbols: Vec2) {
        let own = [self.count, self.count + 1];
        self.of_body[body].insert(kind, own);
        for (symbol, unknown) in symbols.components().into_iter().zip(own) {
            self.column.insert(symbol, (unknown, Part::Value));
        }
        self.count += 2;
    }

    /// Places and velocities that forces or rates depend on, and those that they follow from.
    fn add_wanted(&mut self, model: &Model, equations: &Equations, coordinates: &Coordinates) {
        let loads = model.loads.iter().flat_map(|load| load.force);
        let read: Vec<Expr> = loads.chain(equations.x_dot.iter().copied()).collect_vec();
        let read: SortedSet<Expr> = algebra::symbols(&read).into_iter().collect();
        let mut wanted = vec![[false; 2]; model.bodies.len()];
        for edge in coordinates.order.iter().rev() {
            let declared = &model.bodies[edge.body];
            for (k, symbols) in [declared.q, declared.v].into_iter().enumerate() {
                wanted[edge.body][k] |= symbols[..2].iter().any(|symbol| read.contains(symbol));
            }
            // Those of a body that hangs on nothing are coordinates.
            if edge.joint.is_none() {
                continue;
            }
            for (k, kind) in [Kind::Place, Kind::Velocity].into_iter().enumerate() {
                if wanted[edge.body][k] {
                    let [x, y, _] = [declared.q, declared.v][k];
                    self.add(edge.body, kind, Vec2::new(x, y));
                    if let Some(parent) = edge.parent {
                        wanted[parent][k] = true;
                    }
                }
            }
        }
    }

    /// First-order states, then from the tips to the ground what belongs to each body: pivots are sums of positive masses
    /// and of what h makes of stiffness and damping.
    pub(crate) fn order(&self, coordinates: &Coordinates) -> Vec<usize> {
        let n = coordinates.unknowns.len();
        let mut order: Vec<usize> = (n..n + self.states).collect_vec();
        for edge in coordinates.order.iter().rev() {
            order.extend(self.of_body[edge.body].values().flatten());
            let displacement = edge.joint.and_then(|joint| coordinates.joints[joint].displacement);
            let own = coordinates.unknowns.iter().enumerate().filter(|(k, unknown)| match **unknown {
                Unknown::Angle { body, .. } | Unknown::Centre { body, .. } => body == edge.body,
                Unknown::Displacement { .. } => displacement == Some(*k),
            });
            let mut own: Vec<usize> = own.map(|(k, _)| k).collect_vec();
            sort_by_key(&mut own, |&k| matches!(coordinates.unknowns[k], Unknown::Angle { .. }));
            order.extend(own);
        }
        order
    }
}
