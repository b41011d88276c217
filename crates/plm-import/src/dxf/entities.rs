//! Entities of a DXF file (AutoCAD DXF Reference, entities section) as lines of points.

use super::curves::{Spline, arc, bulged, ellipse};
use super::groups::Group;
use super::place::Placing;
use crate::notice::{Notices, Place, Told};

/// Points one after the other.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) is_closed: bool,
    pub(super) place: Place,
}

/// An entity: its name, the groups after it, and the corners of a polyline of the old form.
pub(super) struct Entity<'g> {
    pub(super) name: &'g str,
    pub(super) place: &'g Place,
    pub(super) groups: &'g [Group],
    pub(super) vertices: Vec<([f64; 2], f64)>,
}

/// Points, and whether they close.
type Line = (Vec<[f64; 2]>, bool);

/// Entities that are lines.
const CURVES: &[&str] = &["LINE", "CIRCLE", "ARC", "LWPOLYLINE", "POLYLINE", "ELLIPSE", "SPLINE"];

/// Entities that draw nothing of a body.
const SAYS_NOTHING: &[&str] = &["ATTDEF", "ATTRIB", "VIEWPORT", "SEQEND", "ACAD_PROXY_ENTITY", "POINT"];

impl<'g> Entity<'g> {
    pub(super) fn text(&self, code: i32) -> Option<&'g str> {
        self.groups.iter().find(|group| group.code == code).map(|group| group.value.as_str())
    }

    pub(super) fn number(&self, code: i32) -> Option<f64> {
        self.text(code)?.parse().ok().filter(|number: &f64| number.is_finite())
    }

    pub(super) fn count(&self, code: i32) -> i64 {
        self.text(code).and_then(|text| text.parse().ok()).unwrap_or_default()
    }

    /// The point whose x has this code, and its y the one ten above.
    pub(super) fn point(&self, code: i32) -> Option<[f64; 2]> {
        Some([self.number(code)?, self.number(code + 10)?])
    }

    /// The layer, `0` without one.
    pub(super) fn layer(&self) -> &'g str {
        self.text(8).unwrap_or("0")
    }

    /// Does it stand on a sheet of paper, or is it hidden?
    pub(super) fn is_elsewhere(&self) -> bool {
        self.count(67) == 1 || self.count(60) == 1
    }

    fn is_closed(&self) -> bool {
        self.count(70) & 1 == 1
    }

    /// The direction from which it is drawn: 1 from the front, −1 from the back. Others are reported.
    pub(super) fn side(&self, notices: &mut Notices) -> Option<f64> {
        let normal = [210, 220, 230].map(|code| self.number(code));
        let [x, y, z] = [normal[0].unwrap_or(0.0), normal[1].unwrap_or(0.0), normal[2].unwrap_or(1.0)];
        if x.hypot(y) > 1e-6 * z.abs() {
            notices.error(self.place, format!("{}: it does not lie in the plane of the drawing", self.name));
            return None;
        }
        Some(z.signum())
    }

    /// The points of an entity; reports one that is not taken.
    pub(super) fn chain(&self, placing: &Placing, notices: &mut Notices) -> Option<Chain> {
        if SAYS_NOTHING.contains(&self.name) {
            return None;
        }
        if !CURVES.contains(&self.name) {
            notices.warn(self.place, format!("{} is not taken", self.name));
            return None;
        }
        let Some((points, is_closed)) = self.drawn(notices).ok()? else {
            notices.error(self.place, format!("{}: a number is missing or is none", self.name));
            return None;
        };
        let points: Vec<[f64; 2]> = points.into_iter().map(|point| placing.point(point)).collect();
        Some(Chain { points, is_closed, place: self.place.clone() })
    }

    /// Points in the plane of the drawing; none of numbers that are none.
    fn drawn(&self, notices: &mut Notices) -> Result<Option<Line>, Told> {
        let side = self.side(notices).ok_or(Told)?;
        // An entity seen from the back has its x reversed; lines, ellipses and splines are given in the world (arbitrary axis algorithm).
        let own = |points: Vec<[f64; 2]>| points.into_iter().map(|[x, y]| [side * x, y]).collect();
        Ok(match self.name {
            "LINE" => self.point(10).zip(self.point(11)).map(|(from, to)| (vec![from, to], false)),
            "CIRCLE" => self.point(10).zip(self.number(40)).map(|(centre, radius)| {
                let mut points = arc(centre, radius, 0.0, 360.0);
                points.pop();
                (own(points), true)
            }),
            "ARC" => self.arc().map(|points| (own(points), false)),
            "ELLIPSE" => self.ellipse(side),
            "SPLINE" => self.spline(),
            "POLYLINE" if self.count(70) & (8 | 16 | 64) != 0 => {
                notices.warn(self.place, "POLYLINE: a mesh or a line in space is not taken");
                return Err(Told);
            }
            "POLYLINE" => Some((own(self.polyline(&self.vertices)), self.is_closed())),
            _ => Some((own(self.polyline(&self.corners())), self.is_closed())),
        })
    }

    fn arc(&self) -> Option<Vec<[f64; 2]>> {
        let (centre, radius) = (self.point(10)?, self.number(40)?);
        let (from, to) = (self.number(50)?, self.number(51)?);
        let sweep = (to - from).rem_euclid(360.0);
        Some(arc(centre, radius, from, if sweep == 0.0 { 360.0 } else { sweep }))
    }

    /// Centre, the end of the major axis from there, the ratio of both, and the parameter at both ends, rad.
    fn ellipse(&self, side: f64) -> Option<Line> {
        let (centre, major, ratio) = (self.point(10)?, self.point(11)?, self.number(40)?);
        let (from, to) = (self.number(41).unwrap_or(0.0), self.number(42).unwrap_or(core::f64::consts::TAU));
        let minor = [-side * ratio * major[1], side * ratio * major[0]];
        let sweep = (to - from).to_degrees();
        let sweep = if sweep <= 0.0 { sweep + 360.0 } else { sweep };
        let is_whole = sweep > 360.0 - 1e-6;
        let mut points = ellipse(centre, major, minor, from.to_degrees(), sweep);
        if is_whole {
            points.pop();
        }
        Some((points, is_whole))
    }

    /// Degree, knots, weights and control points; a spline by the points that it fits alone is none.
    fn spline(&self) -> Option<Line> {
        let all = |code: i32| {
            let own = self.groups.iter().filter(move |group| group.code == code);
            own.map(|group| group.value.parse().ok().filter(|number: &f64| number.is_finite())).collect()
        };
        let (x, y): (Option<Vec<f64>>, Option<Vec<f64>>) = (all(10), all(20));
        let (weights, knots): (Option<Vec<f64>>, Option<Vec<f64>>) = (all(41), all(40));
        let (x, y, weights) = (x?, y?, weights?);
        let weight = |k: usize| weights.get(k).copied().unwrap_or(1.0);
        let controls = x.iter().zip(&y).enumerate().map(|(k, (x, y))| [*x, *y, weight(k)]).collect();
        let degree = usize::try_from(self.count(71)).ok()?;
        let spline = Spline { degree, knots: knots?, controls };
        let points = spline.is_right().then(|| spline.points())?;
        Some((points, false))
    }

    /// Corners with the bulge of the side after each.
    fn corners(&self) -> Vec<([f64; 2], f64)> {
        let mut corners: Vec<([f64; 2], f64)> = Vec::new();
        let mut x = None;
        for group in self.groups {
            let number = || group.value.parse().unwrap_or(f64::NAN);
            match group.code {
                10 => x = Some(number()),
                20 => corners.extend(x.take().map(|x| ([x, number()], 0.0))),
                42 => {
                    if let Some(last) = corners.last_mut() {
                        last.1 = number();
                    }
                }
                _ => {}
            }
        }
        corners
    }

    fn polyline(&self, corners: &[([f64; 2], f64)]) -> Vec<[f64; 2]> {
        let mut points = Vec::new();
        for (k, &(at, bulge)) in corners.iter().enumerate() {
            points.push(at);
            let next = match corners.get(k + 1) {
                Some(&(next, _)) => next,
                None if self.is_closed() => corners[0].0,
                None => break,
            };
            if bulge != 0.0 {
                points.extend(bulged(at, next, bulge));
            }
        }
        points
    }
}
