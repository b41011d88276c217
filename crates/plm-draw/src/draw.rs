//! Drawing: the edits that gestures are.

use crate::edit::{Edit, applied, difference, in_order};
use crate::gesture::{Drawn, End, Gesture};
use crate::insert::{Insertion, Section, Words};
use crate::layout::formatted;
use crate::names::{GROUND, PortName};
use crate::number::{Change, degrees, rounded};
use crate::picture::{Picture, Point, between};
use crate::refusal::Refusal;
use crate::rules::{Drag, Dragged, FINE, Held, drag};
use crate::sheet::{Axes, Handle, Place, Sheet};
use crate::tools::Tool;
use crate::{copy, lock, mirror, port, remove, rename, setting, slide, start, typed};

/// How a motor turns at first.
const SPEED: &str = "60 rev/min*t";

/// The section of a bar.
const SECTION: &str = "width: 20 mm; thickness: 5 mm";

/// The material of bars, and its density.
const STEEL: [&str; 2] = ["steel", "7850 kg/m^3"];

/// The edits and values that a gesture is. A text that has its layout keeps it.
///
/// # Errors
/// [`Refusal`]: the text cannot be changed so.
pub fn draw(sheet: &Sheet<'_>, picture: &Picture, gesture: &Gesture) -> Result<Drawn, Refusal> {
    let mut drawn = edited(sheet, picture, gesture)?;
    drawn.edits = laid_out(sheet.text, in_order(drawn.edits));
    Ok(drawn)
}

/// The values of a drag that goes on, with edits as they are: nothing is read and nothing laid out, so that it answers sooner.
///
/// # Errors
/// As [`draw`] of the same drag.
pub fn follow(held: &Held, to: Point, grid: f64) -> Result<Drawn, Refusal> {
    let mut drawn = of_dragged(held.changes(to, grid)?);
    drawn.edits = in_order(drawn.edits);
    Ok(drawn)
}

/// Edits after which a text has its layout, if it has it before.
fn laid_out(text: &str, edits: Vec<Edit>) -> Vec<Edit> {
    if formatted(text).as_deref() != Ok(text) {
        return edits;
    }
    let made = applied(text, &edits);
    match formatted(&made) {
        Ok(better) if better != made => difference(text, &better),
        _ => edits,
    }
}

fn edited(sheet: &Sheet<'_>, picture: &Picture, gesture: &Gesture) -> Result<Drawn, Refusal> {
    let only = |edits: Vec<Edit>| Drawn { edits, ..Drawn::default() };
    match gesture {
        Gesture::Drag(of) => dragged(sheet, picture, of),
        Gesture::Typed(of) => Ok(of_changes(&typed::changes(sheet, picture, of)?)),
        Gesture::Bar { ends, grid } => bar(sheet, picture, ends, *grid),
        Gesture::Ground { port, grid } => ground(sheet, picture, port, *grid),
        Gesture::GroundPoint { at, grid } => ground_point(sheet, *at, *grid),
        Gesture::Merge { drag, onto } => merge(sheet, picture, drag, onto),
        Gesture::Motor { body } => motor(sheet, picture, body),
        Gesture::Join { tool, ports: [one, other], grid } => {
            let tool = Tool::named(tool).ok_or_else(|| Refusal::Unknown(tool.clone()))?;
            let (mut words, mut insertion) = (Words::of(sheet.text), Insertion::default());
            for port in [one, other] {
                handle_of(&sheet.handles(), port)?;
            }
            let name = tool.put([one, other], (picture, *grid), &mut words, &mut insertion)?;
            Ok(Drawn { made: vec![name], ..only(insertion.edits(sheet)?) })
        }
        Gesture::Slide { port, toward, grid } => slide::slide(sheet, picture, port, *toward, *grid),
        Gesture::Groove { port, body, grid } => port::groove(sheet, picture, port, body, *grid),
        Gesture::Port { body, end, grid } => port::put(sheet, picture, body, end, *grid),
        Gesture::Mirror { port, grid } => {
            dragged(sheet, picture, &mirror::image(sheet, picture, port, *grid)?)
        }
        Gesture::Copy { body, by, grid } => copy::body(sheet, picture, body, *by, *grid),
        Gesture::Lock { port, dimension } => lock::locked(sheet, port, *dimension),
        Gesture::Unlock { port, dimension } => lock::unlocked(sheet, port, *dimension),
        Gesture::Set { name, value } => Ok(of_changes(&setting::changes(sheet, name, *value)?)),
        Gesture::Start { starts, ahead, grid } => Ok(only(start::edits(sheet, starts, ahead, *grid)?)),
        Gesture::Delete { name } => Ok(only(remove::thing(sheet, name)?)),
        Gesture::Unpin { port } => Ok(only(remove::pin(sheet, port)?)),
        Gesture::DeletePort { port } => Ok(only(remove::port(sheet, port)?)),
        Gesture::Rename { from, to } => Ok(only(rename::thing(sheet, from, to)?)),
        Gesture::RenamePort { from, to } => Ok(only(rename::port(sheet, from, to)?)),
    }
}

fn of_changes(changes: &[Change]) -> Drawn {
    let new = changes.iter().filter(|change| change.is_new());
    let edits = new.map(|change| Edit::new(change.literal.range.clone(), change.text.clone())).collect();
    Drawn { edits, values: changes.iter().map(Change::si).collect(), ..Drawn::default() }
}

fn dragged(sheet: &Sheet<'_>, picture: &Picture, of: &Drag) -> Result<Drawn, Refusal> {
    Ok(of_dragged(drag(sheet, picture, of)?))
}

fn of_dragged(of: Dragged) -> Drawn {
    let drawn = of_changes(&of.changes);
    Drawn { to: Some(of.to), also: of.also, open: of.open, told: of.told, ..drawn }
}

/// A port of the text.
pub(crate) fn handle_of<'a, 's>(
    handles: &'a [Handle<'s>],
    name: &PortName,
) -> Result<&'a Handle<'s>, Refusal> {
    handles.iter().find(|handle| handle.name == *name).ok_or_else(|| Refusal::Unknown(name.to_string()))
}

/// The place of a port.
pub(crate) fn place_of(picture: &Picture, name: &PortName) -> Result<Point, Refusal> {
    Ok(picture.port(name).ok_or_else(|| Refusal::NotShown(name.clone()))?.at)
}

/// The name of the point of a drawing where a port stands, if it has one in absolute axes.
pub(crate) fn point_of<'s>(handle: &Handle<'s>) -> Option<&'s str> {
    match handle.place {
        Place::Numbers { through, .. }
            if handle.axes == Axes::Absolute || handle.axes == Axes::Drawing(0.0) =>
        {
            through
        }
        Place::Polar { through, .. }
            if handle.axes == Axes::Absolute || handle.axes == Axes::Drawing(0.0) =>
        {
            Some(through)
        }
        _ => None,
    }
}

/// The words that give a port an axis along a direction; none along x.
pub(crate) fn axis_along([x, y]: Point) -> String {
    match degrees(y.atan2(x)).as_str() {
        "0" => String::new(),
        angle => format!(", axis: {angle} deg"),
    }
}

/// A point as it is written.
pub(crate) fn point_at(at: Point, grid: f64) -> String {
    let [x, y] = at.map(|of| rounded(1e3 * of, 1e3 * FINE * grid));
    format!("({x}, {y}) mm")
}

/// A point that gets a name.
pub(crate) fn named_point(at: Point, grid: f64, words: &mut Words, insertion: &mut Insertion) -> String {
    let name = words.fresh("p");
    insertion.put(Section::Things, format!("let {name} = {};", point_at(at, grid)));
    name
}

fn bar(sheet: &Sheet<'_>, picture: &Picture, ends: &[End; 2], grid: f64) -> Result<Drawn, Refusal> {
    let handles = sheet.handles();
    let (mut words, mut insertion) = (Words::of(sheet.text), Insertion::default());
    let mut places = Vec::new();
    for end in ends {
        places.push(match end {
            End::Point(at) | End::Ground(at) => *at,
            End::Port(port) => {
                handle_of(&handles, port)?;
                place_of(picture, port)?
            }
        });
    }
    let [dx, dy] = between(places[0], places[1]);
    if dx.hypot(dy) < FINE * grid {
        return Err(Refusal::NoLength);
    }
    let body = words.fresh("bar");
    let density = density(sheet, &words, &mut insertion);
    let (mut made, mut points, mut joints) = (vec![body.clone()], Vec::new(), Vec::new());
    for ((end, at), side) in ends.iter().zip(places).zip(["a", "b"]) {
        let known = match end {
            End::Port(port) => point_of(handle_of(&handles, port)?),
            _ => None,
        };
        let point = match known {
            Some(name) => name.to_owned(),
            None => named_point(at, grid, &mut words, &mut insertion),
        };
        match end {
            End::Point(_) => {}
            End::Ground(_) => joints.push(new_ground(&point, &mut words, &mut insertion, side)),
            End::Port(port) => joints.push((port.to_string(), side)),
        }
        points.push(point);
    }
    insertion.put(
        Section::Things,
        format!(
            "body {body} {{ coordinates: absolute; {SECTION}; density: {density}; port a: {}; port b: {}; }}",
            points[0], points[1]
        ),
    );
    for (port, side) in joints {
        let name = words.fresh("pin");
        insertion.put(Section::Joints, format!("revolute {name}({port}, {body}.{side});"));
        made.push(name);
    }
    Ok(Drawn { edits: insertion.edits(sheet)?, made, ..Drawn::default() })
}

/// A new port of the ground at a point; gives it and the end that it is for.
pub(crate) fn new_ground<'a>(
    point: &str,
    words: &mut Words,
    insertion: &mut Insertion,
    side: &'a str,
) -> (String, &'a str) {
    let place = words.fresh("g");
    insertion.put(Section::Things, format!("ground {{ port {place}: {point}; }}"));
    (format!("{GROUND}.{place}"), side)
}

/// The density of bars: that of a name which the first bar gives it.
pub(crate) fn density(sheet: &Sheet<'_>, words: &Words, insertion: &mut Insertion) -> String {
    let [name, density] = STEEL;
    let is_let = sheet.items().iter().any(|item| match &item.kind {
        plm_compiler::syntax::ast::ItemKind::Let(of, _) => of.indices.is_empty() && of.ident.text == name,
        _ => false,
    });
    if is_let {
        return name.to_owned();
    }
    if words.has(name) {
        return density.to_owned();
    }
    insertion.put(Section::Things, format!("let {name} = {density};"));
    name.to_owned()
}

fn ground(sheet: &Sheet<'_>, picture: &Picture, port: &PortName, grid: f64) -> Result<Drawn, Refusal> {
    let handles = sheet.handles();
    let handle = handle_of(&handles, port)?;
    let pin = sheet.pin(port);
    if let Some(held) = pin.iter().find(|of| of.is_of_ground()) {
        return Err(Refusal::Same(port.clone(), held.clone()));
    }
    let at = place_of(picture, port)?;
    let (mut words, mut insertion) = (Words::of(sheet.text), Insertion::default());
    let point = point_of(handle).map_or_else(|| point_at(at, grid), str::to_owned);
    let (place, _) = new_ground(&point, &mut words, &mut insertion, "");
    let name = words.fresh("pin");
    insertion.put(Section::Joints, format!("revolute {name}({place}, {port});"));
    Ok(Drawn { edits: insertion.edits(sheet)?, made: vec![place, name], ..Drawn::default() })
}

/// A port of the ground by itself: the other end of a spring.
fn ground_point(sheet: &Sheet<'_>, at: Point, grid: f64) -> Result<Drawn, Refusal> {
    let (mut words, mut insertion) = (Words::of(sheet.text), Insertion::default());
    let point = named_point(at, grid, &mut words, &mut insertion);
    let (place, _) = new_ground(&point, &mut words, &mut insertion, "");
    Ok(Drawn { edits: insertion.edits(sheet)?, made: vec![place], ..Drawn::default() })
}

/// A pin goes to another one, and a joint holds it there. Two points of a drawing become one.
fn merge(sheet: &Sheet<'_>, picture: &Picture, of: &Drag, onto: &PortName) -> Result<Drawn, Refusal> {
    let handles = sheet.handles();
    let (own, other) = (handle_of(&handles, &of.port)?, handle_of(&handles, onto)?);
    let (pin, target) = (sheet.pin(&of.port), sheet.pin(onto));
    let owners = |pin: &[PortName]| pin.iter().map(|port| port.owner.clone()).collect::<Vec<_>>();
    let shares = owners(&pin).iter().any(|owner| owners(&target).contains(owner));
    if shares {
        return Err(Refusal::Same(of.port.clone(), onto.clone()));
    }
    let to = place_of(picture, onto)?;
    let mut words = Words::of(sheet.text);
    let mut insertion = Insertion::default();
    let name = words.fresh("pin");
    insertion.put(Section::Joints, format!("revolute {name}({onto}, {});", of.port));
    let mut edits = insertion.edits(sheet)?;
    let made = vec![name];
    match point_of(own).zip(point_of(other)) {
        Some((from, into)) if from != into => {
            if sheet.stands_at(into, from) {
                return Err(Refusal::Locked(format!("a dimension of {onto}")));
            }
            edits.extend(remove::replaced_point(sheet, from, into));
            Ok(Drawn { edits, to: Some(to), made, ..Drawn::default() })
        }
        _ => {
            let moved = dragged(sheet, picture, &Drag { to, ..of.clone() })?;
            edits.extend(moved.edits);
            Ok(Drawn { edits, made, ..moved })
        }
    }
}

fn motor(sheet: &Sheet<'_>, picture: &Picture, body: &str) -> Result<Drawn, Refusal> {
    if !sheet.handles().iter().any(|handle| handle.name.owner == body && !handle.name.is_of_ground()) {
        return Err(Refusal::Unknown(body.to_owned()));
    }
    if sheet.drives(body) {
        return Err(Refusal::Driven(body.to_owned()));
    }
    let angle = picture.angle(body).unwrap_or_default().to_degrees();
    // It begins where it stands.
    let begin = match rounded(angle, 1e-3).as_str() {
        "0" => String::new(),
        angle => format!("{angle} deg + "),
    };
    let (mut words, mut insertion) = (Words::of(sheet.text), Insertion::default());
    let name = words.fresh("motor");
    insertion.put(Section::Rows, format!("constraint {name}: {body}.angle = {begin}{SPEED};"));
    Ok(Drawn { edits: insertion.edits(sheet)?, made: vec![name], ..Drawn::default() })
}
