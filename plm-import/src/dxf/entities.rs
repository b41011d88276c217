//! Entities of a DXF file: pairs of lines, a group code and its value.

use std::rc::Rc;

use crate::notice::{Notices, Place};

/// Degrees between two corners on an arc, at most.
const STEP: f64 = 5.0;

/// Points one after the other.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) is_closed: bool,
    pub(super) place: Place,
}

/// Unit and chains of a drawing.
#[derive(Debug, Default)]
pub(super) struct Drawing {
    /// `$INSUNITS`.
    pub(super) unit: Option<i64>,
    pub(super) chains: Vec<Chain>,
}

/// A group code with its value and its place.
struct Group<'a> {
    code: i32,
    value: &'a str,
    place: Place,
}

/// An entity: its name, and the groups behind it.
struct Entity<'a, 'g> {
    name: &'a str,
    place: &'g Place,
    groups: &'g [Group<'a>],
}

impl Drawing {
    pub(super) fn read(file: &Rc<str>, text: &str, notices: &mut Notices) -> Option<Drawing> {
        let groups = groups(file, text, notices)?;
        let mut drawing = Drawing::default();
        let mut section = "";
        let mut k = 0;
        // A polyline of the old form whose vertices follow.
        let mut open: Option<Vertices> = None;
        while k < groups.len() {
            let end = (k + 1..groups.len()).find(|&next| groups[next].code == 0).unwrap_or(groups.len());
            let entity =
                Entity { name: groups[k].value, place: &groups[k].place, groups: &groups[k + 1..end] };
            match entity.name {
                "SECTION" => section = entity.text(2).unwrap_or_default(),
                "ENDSEC" => section = "",
                "VERTEX" if section == "ENTITIES" => {
                    if let (Some(open), Some(at)) = (open.as_mut(), entity.point(10)) {
                        open.corners.push((at, entity.number(42).unwrap_or_default()));
                    }
                }
                "POLYLINE" if section == "ENTITIES" => open = Some(Vertices::new(&entity)),
                "SEQEND" => drawing.chains.extend(open.take().map(Vertices::chain)),
                _ if section == "ENTITIES" => drawing.chains.extend(entity.chain(notices)),
                _ => {}
            }
            if section == "HEADER" {
                drawing.unit = unit(entity.groups).or(drawing.unit);
            }
            k = end;
        }
        Some(drawing)
    }
}

fn unit(groups: &[Group<'_>]) -> Option<i64> {
    let at = groups.iter().position(|group| group.code == 9 && group.value == "$INSUNITS")?;
    groups.get(at + 1)?.value.parse().ok()
}

fn groups<'a>(file: &Rc<str>, text: &'a str, notices: &mut Notices) -> Option<Vec<Group<'a>>> {
    let mut groups = Vec::new();
    let mut lines = text.lines().enumerate();
    while let (Some((number, code)), Some((_, value))) = (lines.next(), lines.next()) {
        let place = Place { file: file.clone(), line: number as u32 + 1, column: 1 };
        let Ok(code) = code.trim().parse() else {
            notices.error(
                &place,
                format!("this is no DXF of text: expected a group code, found `{}`", code.trim()),
            );
            return None;
        };
        groups.push(Group { code, value: value.trim(), place });
    }
    if groups.first().is_none_or(|first| !matches!(first.code, 0 | 999)) {
        let place = Place { file: file.clone(), line: 1, column: 1 };
        notices.error(&place, "this is no DXF: it does not begin with a section");
        return None;
    }
    // Comments.
    groups.retain(|group| group.code != 999);
    Some(groups)
}

impl<'a> Entity<'a, '_> {
    fn text(&self, code: i32) -> Option<&'a str> {
        self.groups.iter().find(|group| group.code == code).map(|group| group.value)
    }

    fn number(&self, code: i32) -> Option<f64> {
        self.text(code)?.parse().ok().filter(|number: &f64| number.is_finite())
    }

    /// The point whose x has this code, and its y the one ten above.
    fn point(&self, code: i32) -> Option<[f64; 2]> {
        Some([self.number(code)?, self.number(code + 10)?])
    }

    fn is_closed(&self) -> bool {
        self.text(70).and_then(|flags| flags.parse::<i64>().ok()).is_some_and(|flags| flags & 1 == 1)
    }

    /// The points of an entity; tells of one that is not taken.
    fn chain(&self, notices: &mut Notices) -> Option<Chain> {
        let chain = |points, is_closed| Some(Chain { points, is_closed, place: self.place.clone() });
        if self.number(230).is_some_and(|normal| normal < 0.0) {
            notices.error(self.place, format!("{}: entities of the back are not taken", self.name));
            return None;
        }
        let made = match self.name {
            "LINE" => self.point(10).zip(self.point(11)).and_then(|(from, to)| chain(vec![from, to], false)),
            "CIRCLE" => self.point(10).zip(self.number(40)).and_then(|(centre, radius)| {
                let mut points = arc(centre, radius, 0.0, 360.0);
                points.pop();
                chain(points, true)
            }),
            "ARC" => self.point(10).zip(self.number(40)).zip(self.angles()).and_then(
                |((centre, radius), [from, to])| {
                    let sweep = (to - from).rem_euclid(360.0);
                    chain(arc(centre, radius, from, if sweep == 0.0 { 360.0 } else { sweep }), false)
                },
            ),
            "LWPOLYLINE" => Some(self.vertices().chain()),
            _ => {
                notices.warn(self.place, format!("{} is not taken", self.name));
                return None;
            }
        };
        if made.is_none() {
            notices.error(self.place, format!("{}: a number is missing or is none", self.name));
        }
        made
    }

    /// Start and end of an arc, degrees.
    fn angles(&self) -> Option<[f64; 2]> {
        Some([self.number(50)?, self.number(51)?])
    }

    fn vertices(&self) -> Vertices {
        let mut vertices = Vertices::new(self);
        let mut x = None;
        for group in self.groups {
            let number = group.value.parse().unwrap_or(f64::NAN);
            match group.code {
                10 => x = Some(number),
                20 => vertices.corners.extend(x.take().map(|x| ([x, number], 0.0))),
                42 => {
                    if let Some(last) = vertices.corners.last_mut() {
                        last.1 = number;
                    }
                }
                _ => {}
            }
        }
        vertices
    }
}

/// Corners of a polyline with the bulge of the side behind each: the tangent of a quarter of its angle.
struct Vertices {
    corners: Vec<([f64; 2], f64)>,
    is_closed: bool,
    place: Place,
}

impl Vertices {
    fn new(entity: &Entity<'_, '_>) -> Vertices {
        Vertices { corners: Vec::new(), is_closed: entity.is_closed(), place: entity.place.clone() }
    }

    fn chain(self) -> Chain {
        let mut points = Vec::new();
        for (k, &(at, bulge)) in self.corners.iter().enumerate() {
            points.push(at);
            let next = match self.corners.get(k + 1) {
                Some(&(next, _)) => next,
                None if self.is_closed => self.corners[0].0,
                None => break,
            };
            if bulge != 0.0 {
                points.extend(bulged(at, next, bulge));
            }
        }
        Chain { points, is_closed: self.is_closed, place: self.place }
    }
}

/// Corners between the ends of an arc that is given by its bulge.
fn bulged(from: [f64; 2], to: [f64; 2], bulge: f64) -> Vec<[f64; 2]> {
    let chord = [to[0] - from[0], to[1] - from[1]];
    // From the middle of the chord to the centre, across the chord.
    let out = (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre =
        [f64::midpoint(from[0], to[0]) - out * chord[1], f64::midpoint(from[1], to[1]) + out * chord[0]];
    let d = [from[0] - centre[0], from[1] - centre[1]];
    let start = d[1].atan2(d[0]).to_degrees();
    let mut points = arc(centre, d[0].hypot(d[1]), start, 4.0 * bulge.atan().to_degrees());
    points.pop();
    points.drain(..1.min(points.len()));
    points
}

/// Points on an arc with both ends; angles in degrees.
fn arc(centre: [f64; 2], radius: f64, from: f64, sweep: f64) -> Vec<[f64; 2]> {
    let count = (sweep.abs() / STEP).ceil().max(1.0) as u32;
    (0..=count)
        .map(|k| {
            let (sin, cos) = (from + sweep * f64::from(k) / f64::from(count)).to_radians().sin_cos();
            [centre[0] + radius * cos, centre[1] + radius * sin]
        })
        .collect()
}
