//! Joint coordinates: which they are, where they put the bodies, and the loops that tie them.
//!
//! A revolute is left to the absolute angles of its bodies, so that no sine of a sum is needed and velocities have no
//! Coriolis terms; a prismatic joint or a slot adds its displacement; a body that hangs on nothing adds the position
//! of its G. Bodies that never turn against each other (prismatic, weld) share one angle, which is called an orientation. What is left of a
//! loop of joints is that its vectors sum to zero.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, Rotation, Vec2, algebra};

use crate::formulate::reduced::joints::chain::{Chain, cross};
use crate::formulate::reduced::joints::explicit::{Explicit, explicit};
use crate::model::{FrameRef, Model, Pair, Port};
use crate::topology::{Forest, shortest_cycle_basis, spanning_forest};

/// Kinds of coordinates.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unknown {
    /// The angle of an orientation, that of the body `body`.
    Angle { orientation: usize, body: usize },
    /// The displacement in a prismatic joint or slot: index of the part.
    Displacement { part: usize },
    /// x (0) or y (1) of G of a body that hangs on nothing.
    Centre { body: usize, axis: usize },
}

impl Unknown {
    /// Its name, as a path of the model.
    pub(crate) fn name(self, model: &Model) -> String {
        match self {
            Unknown::Angle { body, .. } => format!("{}.angle", model.bodies[body].name.text),
            Unknown::Centre { body, axis } => {
                format!("{}.{}", model.bodies[body].name.text, ["x", "y"][axis])
            }
            Unknown::Displacement { part } => format!("{}.displacement", model.parts[part].name.text),
        }
    }

    /// The body whose angle it is, if it is one.
    pub(crate) fn turning_body(self) -> Option<usize> {
        match self {
            Unknown::Angle { body, .. } => Some(body),
            Unknown::Centre { .. } | Unknown::Displacement { .. } => None,
        }
    }
}

/// A joint that the coordinates walk through.
#[derive(Clone, Copy)]
pub(crate) struct Joint {
    /// Index of the part.
    pub(crate) part: usize,
    pub(crate) pair: Pair,
    pub(crate) a: FrameRef,
    pub(crate) b: FrameRef,
    /// The unknown of its displacement.
    pub(crate) displacement: Option<usize>,
}

/// The absolute angle of a body: that of its orientation, plus a constant.
#[derive(Clone, Copy)]
pub(crate) struct AbsoluteAngle {
    pub(crate) orientation: usize,
    pub(crate) offset: Expr,
}

/// The joint coordinates of a mechanism.
pub(crate) struct Coordinates {
    pub(crate) unknowns: Vec<Unknown>,
    /// By orientation; the ground has none.
    pub(crate) angle_of_orientation: Vec<Option<usize>>,
    /// By body.
    pub(crate) absolute_angles: Vec<AbsoluteAngle>,
    /// G of each body.
    pub(crate) centres: Vec<Chain>,
    pub(crate) joints: Vec<Joint>,
    /// Bodies from the ground outwards: body, the joint that holds it, and the body on its other side.
    pub(crate) order: Vec<TreeEdge>,
    /// Independent loops: vectors that sum to zero.
    pub(crate) closures: Vec<Chain>,
    /// Rows that are no joint's, explicit in an unknown.
    pub(crate) rows: Vec<Explicit>,
    /// The joints that each loop goes through, by their places in [`Coordinates::joints`].
    pub(crate) loops: Vec<Vec<usize>>,
    /// The joints that close them.
    pub(crate) chords: Vec<usize>,
    /// By loop, the joints that it goes through, and how often from `a` to `b`.
    pub(crate) crossed: Vec<Vec<(usize, i32)>>,
}

/// Edge of the spanning tree: the joint that holds a body on the way from the ground.
#[derive(Clone, Copy)]
pub(crate) struct TreeEdge {
    pub(crate) body: usize,
    /// The joint, by its place in [`Coordinates::joints`]; none for a body that hangs on nothing.
    pub(crate) joint: Option<usize>,
    /// The body on the other side; none for the ground.
    pub(crate) parent: Option<usize>,
}

impl Coordinates {
    /// Of some unknowns those that are angles, by their places among all angles.
    pub(crate) fn places_of_angles(&self, unknowns: &[usize]) -> Vec<usize> {
        let angles = (0..self.unknowns.len()).filter(|&k| self.unknowns[k].turning_body().is_some());
        angles
            .enumerate()
            .filter(|(_, unknown)| unknowns.contains(unknown))
            .map(|(place, _)| place)
            .collect_vec()
    }

    /// Does nothing tie the unknowns to each other?
    pub(crate) fn is_tree(&self) -> bool {
        self.closures.is_empty() && self.rows.is_empty()
    }

    /// Does anything move with the time, whatever the coordinates do?
    pub(crate) fn moves_with(&self, time: Expr) -> bool {
        let chains = self.closures.iter().chain(&self.centres);
        let vectors = chains.flat_map(|chain| chain.terms().flat_map(|(_, _, vector)| vector.components()));
        let all: Vec<Expr> = vectors.chain(self.rows.iter().map(|row| row.phi)).collect_vec();
        algebra::symbols(&all).contains(&time)
    }

    /// The coordinates of a mechanism that is made of pairs.
    ///
    /// # Errors
    /// Why this mechanism has none: words that go on "absolute coordinates because …".
    pub(crate) fn new(model: &Model) -> Result<Coordinates, String> {
        let joints = joints(model)?;
        let node = |frame: FrameRef| frame.body.map_or(0, |body| body + 1);
        let edges: Vec<(usize, usize)> =
            joints.iter().map(|joint| (node(joint.a), node(joint.b))).collect_vec();
        let nodes = model.bodies.len() + 1;
        let forest = spanning_forest(nodes, &edges);
        let order = forest.order.iter().filter(|&&node| node > 0).map(|&node| {
            let held = forest.parent[node];
            let parent = held.and_then(|(_, parent)| parent.checked_sub(1));
            TreeEdge { body: node - 1, joint: held.map(|(joint, _)| joint), parent }
        });
        let order: Vec<TreeEdge> = order.collect_vec();
        let mut coordinates = Coordinates {
            unknowns: Vec::new(),
            angle_of_orientation: vec![None],
            absolute_angles: absolute_angles(model, &joints, &edges, &order)?,
            centres: vec![Chain::default(); model.bodies.len()],
            joints,
            order,
            closures: Vec::new(),
            rows: Vec::new(),
            loops: Vec::new(),
            chords: forest.chords,
            crossed: Vec::new(),
        };
        coordinates.walk(model);
        for chord in coordinates.chords.clone() {
            coordinates.add_displacement(chord);
        }
        for cycle in shortest_cycle_basis(nodes, &edges) {
            coordinates.loops.push(cycle.iter().map(|step| step.0).collect_vec());
            let (mut closure, mut crossed) = (Chain::default(), Vec::new());
            for (joint, along) in cycle {
                coordinates.add_across(&mut closure, model, joint, !along);
                cross(&mut crossed, joint, if along { 1 } else { -1 });
            }
            coordinates.crossed.push(crossed);
            coordinates.closures.push(closure);
        }
        coordinates.shorten_closures();
        for row in &model.rows {
            if model.parts[row.part].pair.is_none() {
                let explicit = explicit(model, &coordinates, row.phi);
                let own = || format!("`{}` constrains in a way of its own", model.parts[row.part].name.text);
                coordinates.rows.push(explicit.ok_or_else(own)?);
            }
        }
        Ok(coordinates)
    }

    /// From the ground outwards: a coordinate for every freedom, a place for every body.
    fn walk(&mut self, model: &Model) {
        for edge in self.order.clone() {
            let orientation = self.absolute_angles[edge.body].orientation;
            if orientation == self.angle_of_orientation.len() {
                let unknown = self.new_unknown(Unknown::Angle { orientation, body: edge.body });
                self.angle_of_orientation.push(Some(unknown));
            }
            let Some(joint) = edge.joint else {
                for axis in 0..2 {
                    let along = [Vec2::X, Vec2::Y][axis];
                    let unknown = self.new_unknown(Unknown::Centre { body: edge.body, axis });
                    self.centres[edge.body].add(0, Some(unknown), along, false);
                }
                continue;
            };
            self.add_displacement(joint);
            let mut centre = edge.parent.map_or(Chain::default(), |parent| self.centres[parent].clone());
            let outward = self.joints[joint].b.body == Some(edge.body);
            self.add_across(&mut centre, model, joint, !outward);
            self.centres[edge.body] = centre;
        }
    }

    /// Adds loops to others where that leaves fewer vectors that move: three bodies on one pin hang on each other in the order
    /// of their joints, though each two of them are as near.
    fn shorten_closures(&mut self) {
        let count = self.closures.len();
        let all: Vec<(usize, usize, bool)> = (0..count)
            .flat_map(|i| (0..count).flat_map(move |j| [(i, j, false), (i, j, true)]))
            .filter(|(i, j, _)| i != j)
            .collect_vec();
        // Every change shortens a loop, so there is an end.
        while let Some((i, j, negative, shorter)) = all.iter().find_map(|&(i, j, negative)| {
            let mut sum = self.closures[i].clone();
            for (orientation, displacement, vector) in self.closures[j].terms() {
                sum.add(orientation, displacement, vector, negative);
            }
            (sum.moving() < self.closures[i].moving()).then_some((i, j, negative, sum))
        }) {
            self.closures[i] = shorter;
            for (joint, times) in self.crossed[j].clone() {
                cross(&mut self.crossed[i], joint, if negative { -times } else { times });
            }
        }
    }

    /// A coordinate for the displacement in a joint that has one.
    fn add_displacement(&mut self, joint: usize) {
        let Joint { part, pair, .. } = self.joints[joint];
        if pair.slides() {
            self.joints[joint].displacement = Some(self.new_unknown(Unknown::Displacement { part }));
        }
    }

    fn new_unknown(&mut self, unknown: Unknown) -> usize {
        self.unknowns.push(unknown);
        self.unknowns.len() - 1
    }

    /// The joint of a loop that some unknowns close: between their bodies, or the one that slides.
    pub(crate) fn closing(&self, closure: usize, unknowns: &[usize]) -> usize {
        let orientation = |&unknown: &usize| match self.unknowns[unknown] {
            Unknown::Angle { orientation, .. } => Some(orientation),
            _ => None,
        };
        let solved: Vec<usize> = unknowns.iter().filter_map(orientation).collect_vec();
        let within = |frame: FrameRef| {
            frame.body.is_some_and(|body| solved.contains(&self.absolute_angles[body].orientation))
        };
        let rank = |&joint: &usize| {
            let Joint { a, b, displacement, .. } = self.joints[joint];
            let is_sought = displacement.is_some_and(|displacement| unknowns.contains(&displacement));
            (is_sought || (within(a) && within(b)), within(a) || within(b))
        };
        self.loops[closure].iter().copied().max_by_key(rank).unwrap_or(0)
    }

    /// Of values by unknown, those of x and y of G of a body that hangs on nothing; 0 where they are no unknowns.
    pub(crate) fn centre(&self, body: usize, values: &[Expr]) -> Vec2 {
        let of = |axis| self.unknowns.iter().position(|&unknown| unknown == Unknown::Centre { body, axis });
        Vec2::from([0, 1].map_each(|axis| of(axis).map_or(Expr::ZERO, |unknown| values[unknown])))
    }

    /// Absolute angle of the body of a frame.
    pub(crate) fn absolute_angle(&self, frame: FrameRef) -> AbsoluteAngle {
        frame
            .body
            .map_or(AbsoluteAngle { orientation: 0, offset: Expr::ZERO }, |body| self.absolute_angles[body])
    }

    /// From G (on the ground: from the origin) to a port, in the axes of the orientation.
    pub(crate) fn arm(&self, model: &Model, frame: FrameRef) -> (usize, Vec2) {
        let absolute_angle = self.absolute_angle(frame);
        (absolute_angle.orientation, Rotation::by(absolute_angle.offset) * port(model, frame).at)
    }

    /// The x axis of a port, in the axes of the orientation.
    pub(crate) fn axis(&self, model: &Model, frame: FrameRef) -> (usize, Vec2) {
        let absolute_angle = self.absolute_angle(frame);
        let angle = absolute_angle.offset + port(model, frame).angle;
        (absolute_angle.orientation, Rotation::by(angle).axis())
    }

    /// Adds the way from G of the body of `a` to G of the body of `b` through a joint, or its negative.
    fn add_across(&self, chain: &mut Chain, model: &Model, joint: usize, negative: bool) {
        let Joint { a, b, displacement, .. } = self.joints[joint];
        let (orientation, arm) = self.arm(model, a);
        chain.add(orientation, None, arm, negative);
        if displacement.is_some() {
            let (orientation, axis) = self.axis(model, a);
            chain.add(orientation, displacement, axis, negative);
        }
        let (orientation, arm) = self.arm(model, b);
        chain.add(orientation, None, arm, !negative);
    }
}

/// Absolute angles of all bodies. Bodies that never turn against each other share an orientation; orientations are numbered in
/// the order of `order`, 0 being the ground. The offset of the first body of each is zero.
///
/// # Errors
/// When joints fix an angle twice and nothing says that they agree.
fn absolute_angles(
    model: &Model,
    joints: &[Joint],
    edges: &[(usize, usize)],
    order: &[TreeEdge],
) -> Result<Vec<AbsoluteAngle>, String> {
    let fixed = |joint: &&Joint| !joint.pair.turns();
    let (ties, tied): (Vec<&Joint>, Vec<(usize, usize)>) = joints
        .iter()
        .zip(edges)
        .filter(|(joint, _)| fixed(joint))
        .map(|(joint, &edge)| (joint, edge))
        .unzip();
    let nodes = model.bodies.len() + 1;
    let Forest { parent, order: outward, roots, chords } = spanning_forest(nodes, &tied);
    // How far the second body of a tie is turned from the first.
    let turn = |tie: usize| port(model, ties[tie].a).angle - port(model, ties[tie].b).angle;
    let mut root = vec![0; nodes];
    let mut angle = vec![Expr::ZERO; nodes];
    for root_node in roots {
        root[root_node] = root_node;
    }
    for &node in &outward {
        let Some((tie, from)) = parent[node] else { continue };
        let by = turn(tie);
        root[node] = root[from];
        angle[node] = if tied[tie].0 == from { angle[from] + by } else { angle[from] - by };
    }
    for chord in chords {
        let (first, second) = tied[chord];
        let by = turn(chord);
        let expected = angle[first] + by;
        if expected != angle[second] {
            return Err(format!(
                "`{}` fixes an angle that is fixed already",
                model.parts[ties[chord].part].name.text
            ));
        }
    }
    let mut first = vec![Expr::ZERO];
    let mut orientation = vec![None; nodes];
    orientation[root[0]] = Some(0);
    let mut absolute_angles = vec![AbsoluteAngle { orientation: 0, offset: Expr::ZERO }; model.bodies.len()];
    for edge in order {
        let node = edge.body + 1;
        let orientation = *orientation[root[node]].get_or_insert_with(|| {
            first.push(angle[node]);
            first.len() - 1
        });
        absolute_angles[edge.body] =
            AbsoluteAngle { orientation, offset: (angle[node] - first[orientation]) };
    }
    Ok(absolute_angles)
}

/// The port of a frame.
pub(crate) fn port(model: &Model, frame: FrameRef) -> &Port {
    match frame.body {
        Some(body) => &model.bodies[body].ports[frame.port],
        None => &model.ground[frame.port],
    }
}

/// All joints, if they are pairs and nothing else constrains.
fn joints(model: &Model) -> Result<Vec<Joint>, String> {
    let mut rows = vec![0; model.parts.len()];
    for row in &model.rows {
        rows[row.part] += 1;
    }
    let mut joints = Vec::new();
    for (part, count) in rows.into_iter().enumerate() {
        let declared = &model.parts[part];
        let expected = declared.pair.map_or(count, Pair::rows);
        let name = &declared.name.text;
        if count != expected {
            return Err(format!("`{name}` constrains in a way of its own"));
        }
        let turning = |frame: &FrameRef| {
            frame.body.is_none() && algebra::symbols(&[port(model, *frame).angle]).contains(&model.time)
        };
        if declared.pair.is_some() && declared.frames.iter().any(turning) {
            return Err(format!("`{name}` stands on a port that turns with the time"));
        }
        if let (Some(pair), &[a, b]) = (declared.pair, declared.frames.as_slice()) {
            joints.push(Joint { part, pair, a, b, displacement: None });
        } else if declared.pair.is_some() {
            return Err(format!("`{name}` does not join two frames"));
        }
    }
    Ok(joints)
}

/// Do the joints of a mechanism make a tree, with no other constraints?
pub(crate) fn is_tree(model: &Model) -> bool {
    Coordinates::new(model).is_ok_and(|coordinates| coordinates.is_tree())
}
