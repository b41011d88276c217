//! Stephenson's second chain, whose four-bar moves: pose, defects, declaration.

use std::f64::consts::PI;

use super::kernel::{Frame, Z};
use super::{SixBar, SixBarPose};
use crate::synthesis::four_bar::{Body, Defect, Demands, Pose, Vector, point, unit, vector};

/// Largest step of the four-bar's first link between two checks of a motion, rad.
const STEP: f64 = PI / 180.0;

impl SixBar {
    /// Pose at an angle of the four-bar's first link from the line of the crank's pins, rad.
    pub(super) fn moving_pose(&self, angle: f64) -> Option<SixBarPose> {
        let dimensions = self.dimensions();
        let solved = dimensions.solve(angle)?;
        let (turn, hinge) = (unit(self.four_bar.ground_angle()), vector(self.four_bar.pivots[0]));
        let complex = |z: Z<f64>| Vector::new(z.re, z.im);
        let held = |frame: Frame<f64>| {
            let Frame { origin, along } = solved.bars[1].relative(frame);
            (hinge + turn * complex(origin), turn * complex(along))
        };
        let base = Frame { origin: Z::new(0.0, 0.0), along: Z::new(1.0, 0.0) };
        let [first, crank] = [Frame { along: Z::unit(angle), ..base }, base].map(|frame| held(frame).1.arg());
        let [(pin, coupler), (pivot, rocker)] = solved.links.map(held);
        let [(from, arm), (to, ground)] = solved.bars.map(held);
        let four_bar = Pose {
            angles: [first, coupler.arg(), rocker.arg()],
            pins: [point(pin), point(pivot + rocker * self.four_bar.rocker)],
            point: point(pin + coupler * vector(self.four_bar.point)),
        };
        Some(SixBarPose {
            four_bar,
            pins: [point(from), point(to), point(from + arm * self.bars[0])],
            angles: [arm.arg(), ground.arg()],
            point: point(pin + coupler * vector(self.point)),
            crank,
        })
    }

    /// Defects at angles of the four-bar's first link, which it passes in their order, by way of all angles between. A crank that would have
    /// to turn back on the way stands at a dead point: what is behind is another branch.
    pub(super) fn moving_defects(&self, angles: &[f64], demands: &Demands) -> Vec<Defect> {
        let open = angles.iter().enumerate().filter(|(_, angle)| self.pose(**angle).is_none());
        let mut defects: Vec<Defect> = open.map(|(position, _)| Defect::Open { position }).collect();
        let (mut way, mut turned) = (0.0, 0.0);
        for (before, pair) in angles.windows(2).enumerate() {
            let position = before + 1;
            match self.turn_between(pair[0], pair[1]) {
                Ok(turn) => {
                    let is_early = turn * way < 0.0 || f64::abs(turned + turn) > 2.0 * PI;
                    if demands.order && is_early {
                        defects.push(Defect::Order { position });
                    }
                    (way, turned) = (if way == 0.0 { turn.signum() } else { way }, turned + turn);
                }
                Err(Halt::Open(angle)) => defects.push(Defect::Stop { position, angle }),
                Err(Halt::Back) => defects.push(Defect::Branch { position }),
            }
        }
        if demands.turns && !angles.first().is_some_and(|first| self.turns(*first)) {
            defects.push(Defect::Crank { class: None });
        }
        defects
    }

    /// Does the crank turn fully, one way, while the first link of the four-bar does?
    fn turns(&self, first: f64) -> bool {
        self.turn_between(first, first + 2.0 * PI).is_ok_and(|turn| (turn.abs() - 2.0 * PI).abs() < 1e-6)
    }

    /// By how much the crank turns, one way, between two angles of the first link, rad.
    fn turn_between(&self, from: f64, to: f64) -> Result<f64, Halt> {
        let count = ((to - from).abs() / STEP).ceil().max(1.0) as usize;
        let look = |k: usize| self.pose(from + (to - from) * k as f64 / count as f64).map(|pose| pose.crank);
        let (mut last, mut turned) = (look(0).ok_or(Halt::Open(f64::NAN))?, 0.0);
        for k in 1..=count {
            let Some(next) = look(k) else { return Err(Halt::Open(last)) };
            let step = (unit(next) * unit(last).conj()).arg();
            if step * turned < 0.0 {
                return Err(Halt::Back);
            }
            (last, turned) = (next, turned + step);
        }
        Ok(turned)
    }

    /// Declaration of a pose, with the bodies `crank`, `link`, `coupler`, `rocker` and `arm`.
    pub(super) fn moving_text(&self, name: &str, pose: &SixBarPose) -> String {
        let [base, link, coupler, rocker] = self.four_bar.lengths();
        let ([hx, hy], [ex, ey]) = (pose.pins[1], pose.pins[2]);
        let start = [0.0, 0.0];
        // The first pin of the crank: its hinge is the second end of the dyad in its frame.
        let left = point(vector(pose.pins[1]) - unit(pose.crank) * vector(self.ends[1]));
        let right = point(vector(left) + unit(pose.crank) * base);
        let body = |name, ports, place, angle| Body { name, ports, place, angle, mass: None };
        let [first, second, third] = pose.four_bar.angles;
        let bodies = [
            body(
                "crank",
                vec![("left", start), ("right", [base, 0.0]), ("hinge", self.ends[1])],
                left,
                pose.crank,
            ),
            body("link", vec![("left", start), ("pin", [link, 0.0])], left, first),
            body(
                "coupler",
                vec![
                    ("pin", start),
                    ("wrist", [coupler, 0.0]),
                    ("shoulder", self.ends[0]),
                    ("tracer", self.point),
                ],
                pose.four_bar.pins[0],
                second,
            ),
            body("rocker", vec![("right", start), ("wrist", [rocker, 0.0])], right, third),
            body(
                "arm",
                vec![("shoulder", start), ("elbow", [self.bars[0], 0.0])],
                pose.pins[0],
                pose.angles[0],
            ),
        ];
        format!(
            "/// A six-bar whose crank turns.
pub {name} {{
    param speed = 1 rad/s;
    ground {{ port hinge: ({hx:?}, {hy:?}) m; port elbow: ({ex:?}, {ey:?}) m; }}
{}    revolute hinge(ground.hinge, crank.hinge);
    revolute left(crank.left, link.left);
    revolute pin(link.pin, coupler.pin);
    revolute wrist(coupler.wrist, rocker.wrist);
    revolute right(crank.right, rocker.right);
    revolute shoulder(coupler.shoulder, arm.shoulder);
    revolute elbow(ground.elbow, arm.elbow);
    constraint drive: crank.angle = {:?} rad + speed*t;
    output coupler.tracer.position, coupler.angle, arm.angle;
}}
",
            bodies.iter().map(Body::text).collect::<String>(),
            pose.crank
        )
    }
}

/// End of a motion between two positions.
enum Halt {
    /// A loop opens at this angle of the crank.
    Open(f64),
    /// The crank would have to turn back.
    Back,
}
