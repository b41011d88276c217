//! Gestures as JSON.

use plm_draw::{Dimension, Drag, End, Gesture, Placed, Point, PortName, Typed};
use serde_json::Value;

/// The step of a picture that says none, m.
const GRID: f64 = 1e-3;

/// A request that cannot be read, and what was expected.
pub(super) struct Unread(pub(super) &'static str);

pub(super) fn gesture(asked: &Value) -> Result<Gesture, Unread> {
    let word = |of: &str, what| asked[of].as_str().map(str::to_owned).ok_or(Unread(what));
    let grid = grid(asked);
    let is_of_port = asked["port"].is_object();
    Ok(match asked["kind"].as_str().unwrap_or_default() {
        "drag" => Gesture::Drag(dragged(asked)?),
        "typed" => Gesture::Typed(Typed {
            port: port(&asked["port"])?,
            dimension: dimension(asked)?,
            text: word("text", "text")?,
            grid,
        }),
        "bar" => Gesture::Bar { ends: [end(&asked["ends"][0])?, end(&asked["ends"][1])?], grid },
        "ground" if !is_of_port => Gesture::GroundPoint { at: point(&asked["at"])?, grid },
        "ground" => Gesture::Ground { port: port(&asked["port"])?, grid },
        "merge" => {
            let onto = port(&asked["onto"])?;
            let own = port(&asked["port"])?;
            let to = asked["to"].as_array().map_or(Ok([0.0; 2]), |_| point(&asked["to"]))?;
            Gesture::Merge { drag: Drag { port: own, to, grid, free: asked["free"] == true }, onto }
        }
        "motor" => Gesture::Motor { body: word("body", "body")? },
        "join" => {
            let ports = [port(&asked["ports"][0])?, port(&asked["ports"][1])?];
            Gesture::Join { tool: word("tool", "tool")?, ports, grid }
        }
        "slide" => Gesture::Slide { port: port(&asked["port"])?, toward: point(&asked["toward"])?, grid },
        "groove" => Gesture::Groove { port: port(&asked["port"])?, body: word("body", "body")?, grid },
        "port" => Gesture::Port { body: word("body", "body")?, end: end(&asked["end"])?, grid },
        "mirror" => Gesture::Mirror { port: port(&asked["port"])?, grid },
        "copy" => Gesture::Copy { body: word("body", "body")?, by: point(&asked["by"])?, grid },
        "lock" => Gesture::Lock { port: port(&asked["port"])?, dimension: dimension(asked)? },
        "unlock" => Gesture::Unlock { port: port(&asked["port"])?, dimension: dimension(asked)? },
        "set" => {
            let value = asked["value"].as_f64().ok_or(Unread("value that is a number"))?;
            Gesture::Set { name: word("name", "name")?, value }
        }
        "unpin" => Gesture::Unpin { port: port(&asked["port"])? },
        "delete" if is_of_port => Gesture::DeletePort { port: port(&asked["port"])? },
        "delete" => Gesture::Delete { name: word("name", "name")? },
        "rename" if is_of_port => {
            Gesture::RenamePort { from: port(&asked["port"])?, to: word("to", "new name")? }
        }
        "rename" => Gesture::Rename { from: word("name", "name")?, to: word("to", "new name")? },
        _ => return Err(Unread("kind that is known")),
    })
}

fn dimension(asked: &Value) -> Result<Dimension, Unread> {
    let found = Dimension::ALL.into_iter().find(|dimension| asked["dimension"] == dimension.word());
    found.ok_or(Unread("dimension: x, y, length or angle"))
}

pub(super) fn grid(asked: &Value) -> f64 {
    asked["grid"].as_f64().filter(|grid| *grid > 0.0).unwrap_or(GRID)
}

pub(super) fn dragged(asked: &Value) -> Result<Drag, Unread> {
    let (port, to) = (port(&asked["port"])?, point(&asked["to"])?);
    Ok(Drag { port, to, grid: grid(asked), free: asked["free"] == true })
}

pub(super) fn point(of: &Value) -> Result<Point, Unread> {
    let [x, y] = [0, 1].map(|axis| of[axis].as_f64());
    x.zip(y).map(|(x, y)| [x, y]).ok_or(Unread("point of two numbers"))
}

pub(super) fn port(of: &Value) -> Result<PortName, Unread> {
    let [owner, port] = ["owner", "port"].map(|word| of[word].as_str());
    owner.zip(port).map(|(owner, port)| PortName::new(owner, port)).ok_or(Unread("port with its owner"))
}

fn end(of: &Value) -> Result<End, Unread> {
    if of["owner"].is_string() {
        return port(of).map(End::Port);
    }
    let at = point(&of["at"])?;
    Ok(if of["ground"] == true { End::Ground(at) } else { End::Point(at) })
}

pub(super) fn placed(of: &Value) -> Option<Placed> {
    let name = port(of).ok()?;
    let at = point(&of["at"]).ok()?;
    Some(Placed { name, at, angle: of["angle"].as_f64().unwrap_or_default() })
}
