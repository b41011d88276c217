//! A pose as the start: which coordinates say it, asked of the compiled text, and tried on the text that is made.

use std::f64::consts::TAU;

use plm_compiler::{Assembled, AssembledBody, Oracle, without_panic};
use plm_draw::{Ahead, Coordinate, Drawn, Gesture, Picture, Sheet, StartAt, applied, draw};

use crate::checked::checked;

/// A text that begins so near to the wanted pose begins there: parts of the mechanism's size, and rad. Angles are written to 2e-5 rad.
const SAME: f64 = 1e-3;
/// One that begins no nearer begins elsewhere, and the text stays. What is between comes of sliders that the text does not know.
const ELSEWHERE: f64 = 0.05;
/// A coordinate is taken in the order of preference where it moves by this part of what the one that moves most does.
const MOVES: f64 = 0.3;
/// Rows that say what others say, as a part of themselves.
const DEPENDENT: f64 = 1e-9;
/// Prescribed angles that are nearer are the same, rad.
const STANDS: f64 = 1e-6;

/// The pose of a body: place of G and angle.
pub(super) struct PoseOf {
    pub(super) body: String,
    pub(super) pose: [f64; 3],
}

/// The text with what is known of it.
pub(super) struct Source<'a> {
    pub(super) name: &'a str,
    pub(super) text: &'a str,
    pub(super) masked: Option<&'a str>,
}

impl Source<'_> {
    fn oracle(&self) -> Option<Oracle> {
        without_panic(|| checked(self.name, self.text, self.masked).expansion.oracle).ok()?
    }
}

/// The edits after which a text begins in a pose, or why it cannot.
pub(super) fn begun(of: &Source<'_>, poses: &[PoseOf], grid: f64) -> Result<Drawn, String> {
    let oracle = of.oracle().ok_or("a text with errors has no start: mend them first")?;
    let assembled = oracle.assembled();
    let pose_of = |body: &AssembledBody| poses.iter().find(|of| of.body == body.name).map(|of| of.pose);
    let wanted: Option<Vec<[f64; 3]>> = assembled.bodies.iter().map(pose_of).collect();
    let wanted = wanted.ok_or("the picture is not that of the text")?;
    let sheet = Sheet::read(of.text, of.masked);
    let gesture = |tried: &Tried| tried.gesture(&sheet, &assembled, &wanted, grid);
    let free = determining(&oracle, &wanted.concat(), size(&assembled), &order(&sheet, &assembled));
    let mut best: Option<(f64, Drawn)> = None;
    for tried in Tried::all(&free) {
        let drawn = draw(&sheet, &Picture::default(), &gesture(&tried)).map_err(|why| why.to_string())?;
        let away = away(of, &drawn, &wanted);
        if best.as_ref().is_none_or(|(before, _)| away < *before) {
            best = Some((away, drawn));
        }
        if away <= SAME {
            break;
        }
    }
    match best {
        Some((away, drawn)) if away <= ELSEWHERE => Ok(drawn),
        _ => Err("from this pose the joints of the text close elsewhere: sliders that were turned are written first".to_owned()),
    }
}

/// The largest extent of a body, m.
fn size(assembled: &Assembled) -> f64 {
    let ports = assembled.bodies.iter().flat_map(|body| &body.ports);
    let largest =
        ports.flat_map(|port| [port.place[0], port.place[1]]).fold(0.0, |most: f64, at| most.max(at.abs()));
    if largest > 0.0 { largest } else { 1.0 }
}

/// How far the text that edits make begins from the wanted pose, in parts of its size and rad.
fn away(of: &Source<'_>, drawn: &Drawn, wanted: &[[f64; 3]]) -> f64 {
    let text = applied(of.text, &drawn.edits);
    let masked = of.masked.map(|masked| applied(masked, &drawn.edits));
    let made = Source { name: of.name, text: &text, masked: masked.as_deref() };
    let Some(oracle) = made.oracle() else { return f64::INFINITY };
    let assembled = oracle.assembled();
    let size = size(&assembled);
    let of_body = |(body, wanted): (&AssembledBody, &[f64; 3])| {
        let [dx, dy, turn] = [0, 1, 2].map(|k| body.pose[k] - wanted[k]);
        let turn = turn - (turn / TAU).round() * TAU;
        (dx.hypot(dy) / size).max(turn.abs())
    };
    assembled.bodies.iter().zip(wanted).map(of_body).fold(0.0, f64::max)
}

/// Coordinates in the order in which a reader would give them: those that the text locks, angles of bodies on the ground, other angles,
/// places.
fn order(sheet: &Sheet<'_>, assembled: &Assembled) -> Vec<usize> {
    let number = |name: &str| assembled.bodies.iter().position(|body| body.name == name);
    let locked = sheet.locked_starts().into_iter();
    let locked = locked.filter_map(|(body, of)| Some(3 * number(&body)? + of as usize));
    let grounded = sheet.handles().into_iter().filter(|handle| {
        !handle.name.is_of_ground() && sheet.pin(&handle.name).iter().any(plm_draw::PortName::is_of_ground)
    });
    let grounded: Vec<usize> = grounded.filter_map(|handle| number(&handle.name.owner)).collect();
    let all = 0..assembled.bodies.len();
    let angles = grounded.into_iter().chain(all.clone()).map(|body| 3 * body + Coordinate::Angle as usize);
    let places = all.flat_map(|body| [3 * body, 3 * body + 1]);
    locked.chain(angles).chain(places).collect()
}

/// Independent coordinates at a pose, one for each freedom: by pivots of the projector on the motions that the rows leave free.
fn determining(oracle: &Oracle, q: &[f64], size: f64, order: &[usize]) -> Vec<usize> {
    let mut free = projector(oracle, q, size);
    let mut chosen = Vec::new();
    loop {
        let moves = |k: usize| free[k][k].max(0.0).sqrt();
        let most = (0..q.len()).map(moves).fold(0.0, f64::max);
        if most < DEPENDENT.sqrt() {
            return chosen;
        }
        let Some(&k) = order.iter().find(|&&k| moves(k) >= MOVES * most) else { return chosen };
        let pivot = free[k].clone();
        for row in &mut free {
            let share = row[k] / pivot[k];
            row.iter_mut().zip(&pivot).for_each(|(entry, of_pivot)| *entry -= share * of_pivot);
        }
        chosen.push(k);
    }
}

/// The projector on motions that leave all rows closed, with lengths in parts of the size.
fn projector(oracle: &Oracle, q: &[f64], size: f64) -> Vec<Vec<f64>> {
    let count = q.len();
    let rows_at = |moving: Option<usize>| {
        let mut state = vec![0.0; oracle.states()];
        state[..count].copy_from_slice(q);
        if let Some(k) = moving {
            state[count + k] = if k % 3 == Coordinate::Angle as usize { 1.0 } else { size };
        }
        // `phi_q v - nu` is affine in the velocities.
        oracle.phi_dot(0.0, &state)
    };
    let at_rest = rows_at(None);
    let columns: Vec<Vec<f64>> = (0..count).map(|k| rows_at(Some(k))).collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for (row, rest) in at_rest.iter().enumerate() {
        let whole: Vec<f64> = columns.iter().map(|column| column[row] - rest).collect();
        let mut left = whole.clone();
        // Twice is enough (L. Giraud, J. Langou, M. Rozloznik, The loss of orthogonality in the Gram-Schmidt process, 2005).
        for _ in 0..2 {
            for known in &basis {
                let share = dot(&left, known);
                left.iter_mut().zip(known).for_each(|(entry, of_known)| *entry -= share * of_known);
            }
        }
        let (length, before) = (dot(&left, &left).sqrt(), dot(&whole, &whole).sqrt());
        if length > DEPENDENT * before && before.is_finite() {
            basis.push(left.iter().map(|entry| entry / length).collect());
        }
    }
    let entry = |i: usize, j: usize| {
        let held: f64 = basis.iter().map(|row| row[i] * row[j]).sum();
        f64::from(u8::from(i == j)) - held
    };
    (0..count).map(|i| (0..count).map(|j| entry(i, j)).collect()).collect()
}

/// Starts to try: coordinates that are locked; with or without the angles of all other bodies, as proposals; angles as they are, or
/// without whole turns.
struct Tried<'a> {
    locked: &'a [usize],
    proposes: bool,
    keeps_turns: bool,
}

impl<'a> Tried<'a> {
    fn all(locked: &'a [usize]) -> [Tried<'a>; 4] {
        [(false, false), (true, false), (false, true), (true, true)].map(|(proposes, keeps_turns)| Tried {
            locked,
            proposes,
            keeps_turns,
        })
    }

    fn gesture(&self, sheet: &Sheet<'_>, assembled: &Assembled, wanted: &[[f64; 3]], grid: f64) -> Gesture {
        let handles = sheet.handles();
        let driven = |body: &str| handles.iter().any(|of| of.name.owner == body && of.is_driven);
        let (mut starts, mut ahead) = (Vec::new(), Vec::new());
        for (number, (body, [x, y, angle])) in assembled.bodies.iter().zip(wanted).enumerate() {
            let is_locked = |of: Coordinate| self.locked.contains(&(3 * number + of as usize));
            let by = angle - body.pose[2];
            if driven(&body.name) && by.abs() > STANDS {
                let by = if self.keeps_turns { by } else { by - (by / TAU).round() * TAU };
                ahead.push(Ahead { body: body.name.clone(), by });
            }
            let (sin, cos) = angle.sin_cos();
            // Starts are those of the origin; a lock holds G.
            let [cx, cy] = body.centre;
            let origin = [x - cos * cx + sin * cy, y - sin * cx - cos * cy];
            let is_placed = is_locked(Coordinate::X) || is_locked(Coordinate::Y);
            let turns = if self.keeps_turns { 0.0 } else { (angle / TAU).round() * TAU };
            let is_offset = is_placed && body.centre != [0.0; 2];
            for (coordinate, value) in Coordinate::ALL.into_iter().zip([origin[0], origin[1], angle - turns])
            {
                let is_angle = coordinate == Coordinate::Angle;
                let is_locked = is_locked(coordinate);
                if is_locked || is_angle && (self.proposes && !driven(&body.name) || is_offset) {
                    starts.push(StartAt { body: body.name.clone(), coordinate, value, is_locked });
                }
            }
        }
        Gesture::Start { starts, ahead, grid }
    }
}
