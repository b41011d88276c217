//! Links of a mechanism in true size, for a laser or a saw: their outlines with holes at pins as DXF or SVG, and tables of them.

mod dxf;
mod layers;
mod region;
mod sheet;
mod svg;
mod table;

use plm_compiler::model::FrameRef;
use plm_compiler::{Assembled, AssembledBody, AssembledPart};

use self::layers::Motion;
use self::region::{Point, Region};
use self::sheet::Sheet;
use super::PlaceOf;
use super::frames::{Posed, sub, turned};
use crate::notice::{Notice, Notices};
use crate::outline::{area, hull};

/// The layer of names.
const NAMES: &str = "names";

/// A format of drawings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawing {
    /// DXF of R12, in mm.
    Dxf,
    /// SVG, in mm.
    Svg,
}

/// Sizes of what is cut, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutting {
    /// Diameter of holes for pins.
    pub hole: f64,
    /// Width of links that declare none.
    pub width: f64,
    /// Width of what the cut takes away: outlines lie half of it outside, holes half of it inside.
    pub kerf: f64,
}

impl Default for Cutting {
    fn default() -> Self {
        Cutting { hole: 5e-3, width: 20e-3, kerf: 0.0 }
    }
}

/// Drawings and tables of links.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Links {
    /// Names of files and their texts: a sheet, a drawing of each link, tables of pins and of lengths.
    pub files: Vec<(String, String)>,
    /// Messages about them.
    pub notices: Vec<Notice>,
}

/// A body that is cut. Places are from G, in the axes of the body.
struct Link {
    body: usize,
    name: String,
    layer: usize,
    outline: Region,
    holes: Vec<Region>,
    ports: Vec<(String, Point)>,
}

/// A pin between two bodies, or one of them and the ground.
struct Joint {
    name: String,
    bodies: [Option<usize>; 2],
    /// The place of the pin in a body that it does not move in.
    at: Option<(usize, Point)>,
    /// Round holes: bodies, and places in them.
    holes: Vec<(usize, Point)>,
    /// The slot of the pin, by its frame.
    slot: Option<(FrameRef, FrameRef)>,
}

/// The links of a mechanism, over a motion: the poses of all bodies at some moments, the start at least.
pub fn to_links(
    mechanism: &Assembled,
    motion: &[Vec<[f64; 3]>],
    drawing: Drawing,
    cutting: &Cutting,
    place: PlaceOf,
) -> Links {
    let mut notices = Notices::default();
    let joints: Vec<Joint> = mechanism.parts.iter().filter_map(|part| joint(mechanism, part)).collect();
    let bodies = mechanism.bodies.iter().enumerate();
    let mut links: Vec<Link> = bodies
        .filter_map(|(number, body)| {
            let made = link(number, body, cutting);
            match &made {
                None => notices.warn(
                    &place(body.span),
                    format!("`{}` has no port and no contour: it is not drawn", body.name),
                ),
                Some(_) if body.contour.is_empty() && body.width.is_none() => {
                    let width = number_of(1e3 * cutting.width);
                    notices.warn(
                        &place(body.span),
                        format!(
                            "`{}` has no outline: it is drawn {width} mm wide round its ports",
                            body.name
                        ),
                    );
                }
                Some(_) => {}
            }
            made
        })
        .collect();
    for joint in &joints {
        cut(joint, mechanism, motion, cutting, &mut links);
    }
    let found = Motion { links: &links, poses: motion }.layers();
    links.iter_mut().zip(found).for_each(|(link, layer)| link.layer = layer);
    tell(mechanism, &links, &joints, motion, cutting, place, &mut notices);
    Links { files: files(&links, &joints, drawing, cutting), notices: notices.0 }
}

/// Reports slots without a length, holes that leave nothing beside them, and pins that meet links between their layers.
fn tell(
    mechanism: &Assembled,
    links: &[Link],
    joints: &[Joint],
    motion: &[Vec<[f64; 3]>],
    cutting: &Cutting,
    place: PlaceOf,
    notices: &mut Notices,
) {
    let part = |joint: &Joint| {
        mechanism.parts.iter().find(|part| part.name == joint.name).map(|part| place(part.span))
    };
    for joint in joints.iter().filter(|joint| joint.slot.is_some_and(|(slot, _)| slot.body.is_some())) {
        if let Some(at) = part(joint).filter(|_| motion.len() < 2) {
            notices.warn(
                &at,
                format!(
                    "the slot of `{}` is as long as its pin moves: without a motion it is not cut",
                    joint.name
                ),
            );
        }
    }
    for link in links.iter().filter(|link| link.outline.radius > 0.0 && !link.holes.is_empty()) {
        if 2.0 * link.outline.radius <= cutting.hole {
            let [width, hole] = [2e3 * link.outline.radius, 1e3 * cutting.hole].map(number_of);
            notices.warn(
                &place(mechanism.bodies[link.body].span),
                format!("`{}` is {width} mm wide, and its holes {hole} mm", link.name),
            );
        }
    }
    let over = Motion { links, poses: motion };
    for blocked in over.blocked(joints, cutting.hole / 2.0) {
        let (joint, link) = (&joints[blocked.joint], &links[blocked.link]);
        if let Some(at) = part(joint) {
            notices.warn(
                &at,
                format!(
                    "the pin of `{}` passes through layer {}, in which it meets `{}`",
                    joint.name, link.layer, link.name
                ),
            );
        }
    }
}

/// The pin of a part that has one.
fn joint(mechanism: &Assembled, part: &AssembledPart) -> Option<Joint> {
    let [a, b] = part.frames[..] else { return None };
    let slides = match part.kind.as_str() {
        "revolute" if part.of_library => false,
        "pin_slot" if part.of_library => true,
        _ => return None,
    };
    let at = |frame: FrameRef| frame.body.map(|body| (body, place_of(&mechanism.bodies[body], frame)));
    let holes: Vec<(usize, Point)> =
        if slides { at(b).into_iter().collect() } else { [a, b].into_iter().filter_map(at).collect() };
    Some(Joint {
        name: part.name.clone(),
        bodies: [a.body, b.body],
        at: holes.last().copied(),
        holes,
        slot: slides.then_some((a, b)),
    })
}

fn place_of(body: &AssembledBody, frame: FrameRef) -> Point {
    let [x, y, _] = body.ports[frame.port].place;
    [x, y]
}

/// A body with its outline; nothing of one that has none, and no port round which it would be.
fn link(number: usize, body: &AssembledBody, cutting: &Cutting) -> Option<Link> {
    let ports: Vec<(String, Point)> =
        body.ports.iter().map(|port| (port.name.clone(), [port.place[0], port.place[1]])).collect();
    let outline = if body.contour.is_empty() {
        let mut at: Vec<Point> = ports.iter().map(|(_, at)| *at).collect();
        let first = *at.first()?;
        let corners = Some(hull(&mut at)).filter(|hull| hull.len() > 1).unwrap_or(vec![first]);
        Region { corners, radius: body.width.unwrap_or(cutting.width) / 2.0 }
    } else {
        counter_clockwise(&body.contour)
    };
    let holes = body.holes.iter().map(|hole| counter_clockwise(hole)).collect();
    Some(Link { body: number, name: body.name.clone(), layer: 1, outline, holes, ports })
}

fn counter_clockwise(points: &[Point]) -> Region {
    let mut corners = points.to_vec();
    if area(&corners) < 0.0 {
        corners.reverse();
    }
    Region { corners, radius: 0.0 }
}

/// Cuts the holes of a joint, each once, and its slot over the motion.
fn cut(
    joint: &Joint,
    mechanism: &Assembled,
    motion: &[Vec<[f64; 3]>],
    cutting: &Cutting,
    links: &mut [Link],
) {
    let radius = cutting.hole / 2.0;
    let slot = joint.slot.filter(|_| motion.len() > 1).and_then(|(slot, pin)| {
        let body = slot.body?;
        let [x, y, angle] = mechanism.bodies[body].ports[slot.port].place;
        let slides = motion.iter().map(|poses| {
            let posed = Posed { mechanism, poses };
            let [px, py, _] = posed.frame(pin);
            let [bx, by, turn] = poses[body];
            turned(sub(turned(sub([px, py], [bx, by]), -turn), [x, y]), -angle)[0]
        });
        let (low, high) =
            slides.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
        let end = |at: f64| {
            let [dx, dy] = turned([at, 0.0], angle);
            [x + dx, y + dy]
        };
        let corners = if low < high { vec![end(low), end(high)] } else { vec![end(low)] };
        Some((body, Region { corners, radius }))
    });
    let round = joint.holes.iter().map(|(body, at)| (*body, Region { corners: vec![*at], radius }));
    for (body, hole) in round.chain(slot) {
        let of = links.iter_mut().find(|link| link.body == body);
        if let Some(link) = of.filter(|link| !link.holes.contains(&hole)) {
            link.holes.push(hole);
        }
    }
}

/// The sheet, each link, and the tables.
fn files(links: &[Link], joints: &[Joint], drawing: Drawing, cutting: &Cutting) -> Vec<(String, String)> {
    let (text, ending): (fn(&Sheet) -> String, _) = match drawing {
        Drawing::Dxf => (dxf::text, "dxf"),
        Drawing::Svg => (svg::text, "svg"),
    };
    let mut files = vec![
        (format!("sheet.{ending}"), text(&Sheet::all(links, cutting))),
        ("pins.csv".to_owned(), table::pins(links, joints, cutting)),
        ("lengths.csv".to_owned(), table::lengths(links)),
    ];
    files.extend(links.iter().map(|link| {
        let name: String = link
            .name
            .chars()
            .map(|letter| if letter.is_alphanumeric() || letter == '.' { letter } else { '_' })
            .collect();
        (format!("links/{name}.{ending}"), text(&Sheet::single(link, cutting)))
    }));
    files
}

/// The name of a layer of links.
fn layer_name(layer: usize) -> String {
    format!("layer_{layer}")
}

/// A number of a drawing, mm: to a nanometre.
fn number(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    format!("{:.6}", if rounded == 0.0 { 0.0 } else { rounded })
}

/// A number in a sentence, mm.
fn number_of(value: f64) -> String {
    crate::number::short((value * 1e6).round() / 1e6)
}
