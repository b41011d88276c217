//! A compiled mechanism at its start, in names and numbers: for drawings that need no rustc.
//!
//! `examples/figures` draws the figures of the book from it, and a test compares them.

use crate::collect::{CollectVec, MapEach};
use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use crate::model::{Body, FrameRef, Instance, Pair, Port, Shape};
use crate::numeric::{Scene, at_start, value};
use crate::oracle::Oracle;

/// Data of a picture, with parameters as declared, at the assembled start.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Name of the mechanism.
    pub name: String,
    /// Acceleration of gravity, absolute axes, m/s^2.
    pub gravity: [f64; 2],
    /// The bodies.
    pub bodies: Vec<PictureBody>,
    /// Ports of the ground.
    pub ground: Vec<PicturePort>,
    /// The parts in use; of those inside of others, what joins frames.
    pub parts: Vec<PicturePart>,
}

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureBody {
    /// Its name.
    pub name: String,
    /// Place of G and angle of the body: m, m, rad.
    pub pose: [f64; 3],
    /// From G, in the axes of the body.
    pub ports: Vec<PicturePort>,
    /// Points from G, in the axes of the body, m; none without outline.
    pub contour: Vec<[f64; 2]>,
    /// Holes of the outline, in the same axes.
    pub holes: Vec<Vec<[f64; 2]>>,
}

/// A port of a body or of the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct PicturePort {
    /// Its name.
    pub name: String,
    /// Place and angle: m, m, rad.
    pub place: [f64; 3],
}

/// A part in use.
#[derive(Clone, Debug, PartialEq)]
pub struct PicturePart {
    /// Its full name.
    pub name: String,
    /// Name of its definition.
    pub kind: String,
    /// Its kinematic pair, if it states one.
    pub pair: Option<&'static str>,
    /// Frames that it joins, by the names of the part.
    pub frames: Vec<(String, FrameRef)>,
    /// Its sizes for pictures, m or rad, by the names of its parameters.
    pub sizes: Vec<(String, f64)>,
    /// Its shapes for pictures.
    pub shapes: Vec<PictureShape>,
}

/// A shape of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureShape {
    /// How it is drawn: `outline`, `mark`, `line`, `surface`, `circle`.
    pub look: &'static str,
    /// Its frame.
    pub at: FrameRef,
    /// The frame that its x axis points to.
    pub towards: Option<FrameRef>,
    /// Do its points count in half widths of a bar?
    pub is_symbol: bool,
    /// Its points.
    pub points: Vec<[f64; 2]>,
}

impl Oracle {
    /// The mechanism at its start. Where it cannot be assembled, this is as near as assembly comes.
    pub fn picture(&self) -> Picture {
        self.graph.borrow_mut().enter(|| {
            let model = &self.model;
            let scene = Scene::declared(model, &self.equations, &self.program.absolute);
            let (start, known) = at_start(&scene);
            let number = |expr: Expr| value(expr, &known);
            let poses = start.q.chunks_exact(3);
            Picture {
                name: model.name.text.clone(),
                gravity: model.gravity.components().map_each(number),
                bodies: model
                    .bodies
                    .iter()
                    .zip(poses)
                    .map(|(row, pose)| body(row, pose, &number))
                    .collect_vec(),
                ground: model.ground.iter().map(|row| port(row, &number)).collect_vec(),
                parts: model.instances.iter().map(|instance| part(instance, &number)).collect_vec(),
            }
        })
    }
}

fn body(body: &Body, pose: &[f64], number: &impl Fn(Expr) -> f64) -> PictureBody {
    PictureBody {
        name: body.name.text.clone(),
        pose: [pose[0], pose[1], pose[2]],
        ports: body.ports.iter().map(|row| port(row, number)).collect_vec(),
        contour: points(&body.contour, number),
        holes: body.holes.iter().map(|hole| points(hole, number)).collect_vec(),
    }
}

pub(crate) fn points(of: &[Vec2], number: &impl Fn(Expr) -> f64) -> Vec<[f64; 2]> {
    of.iter().map(|point| point.components().map_each(number)).collect_vec()
}

pub(crate) fn port(port: &Port, number: &impl Fn(Expr) -> f64) -> PicturePort {
    PicturePort { name: port.name.text.clone(), place: [port.at.x, port.at.y, port.angle].map_each(number) }
}

fn part(instance: &Instance, number: &impl Fn(Expr) -> f64) -> PicturePart {
    let Instance { name, kind, pair, frames, sizes, shapes, .. } = instance.clone();
    let sizes = sizes.into_iter().map(|size| (size.name, number(size.value))).collect_vec();
    let shapes = shapes.into_iter().map(|Shape { look, at, towards, is_symbol, points: of }| PictureShape {
        look: look.name(),
        at,
        towards,
        is_symbol,
        points: points(&of, number),
    });
    PicturePart { name, kind, pair: pair.map(Pair::name), frames, sizes, shapes: shapes.collect_vec() }
}
