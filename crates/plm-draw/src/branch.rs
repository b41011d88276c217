//! Branches: on which side of the line between their other ends two bars meet, and where they come into line.
//!
//! A mechanism that something drives passes no pose in which two bars that nothing drives are in line: its dead point. On the other side
//! of it the same lengths are assembled as their mirror image.

use std::collections::BTreeSet;

use crate::names::PortName;
use crate::picture::{Picture, Point, between};
use crate::sheet::{Handle, Sheet};

/// Bars that meet at a smaller sine than that of 3 degrees are in line: forces are twenty times what they hold there.
const IN_LINE: f64 = 0.0523;

/// Two bars that meet in a pin, and that nothing drives.
#[derive(Clone, Debug)]
pub(crate) struct Dyad {
    bodies: [String; 2],
    /// The pin, and the other ends.
    corners: [PortName; 3],
}

impl Dyad {
    /// Those of a mechanism that something drives.
    pub(crate) fn all(sheet: &Sheet<'_>, handles: &[Handle<'_>]) -> Vec<Dyad> {
        let driven = sheet.moved();
        let mut seen: BTreeSet<PortName> = BTreeSet::new();
        let mut dyads = Vec::new();
        for handle in handles.iter().filter(|_| !driven.is_empty()) {
            if !seen.insert(handle.name.clone()) {
                continue;
            }
            let pin = sheet.pin(&handle.name);
            seen.extend(pin.iter().cloned());
            let is_free = |port: &PortName| !port.is_of_ground() && !driven.contains(&port.owner);
            let [one, other] = &pin[..] else { continue };
            let ends = [one, other].map(|port| other_end(sheet, handles, port));
            if let ([Some(first), Some(second)], true) = (ends, is_free(one) && is_free(other)) {
                let bodies = [one.owner.clone(), other.owner.clone()];
                dyads.push(Dyad { bodies, corners: [one.clone(), first, second] });
            }
        }
        dyads
    }

    /// A warning for a hand where a pin has gone.
    pub(crate) fn told(&self, picture: &Picture, pin: &[PortName], to: Point) -> Option<String> {
        let before = self.corners.each_ref().map(|port| picture.port(port).map(|of| of.at));
        let [Some(a), Some(b), Some(c)] = before else { return None };
        let before = [a, b, c];
        let mut after = before;
        for (place, port) in after.iter_mut().zip(&self.corners) {
            if pin.contains(port) {
                *place = to;
            }
        }
        let [one, other] = &self.bodies;
        if after == before {
            None
        } else if sine(after).abs() < IN_LINE {
            Some(format!("dead point: {one} and {other} are in line"))
        } else if sine(after) * sine(before) < 0.0 {
            Some(format!("flipped: {one} and {other} meet on the other side"))
        } else {
            None
        }
    }
}

/// The only other port of a body that a joint holds.
fn other_end(sheet: &Sheet<'_>, handles: &[Handle<'_>], port: &PortName) -> Option<PortName> {
    let joints = sheet.joints();
    let is_held = |name: &PortName| joints.iter().any(|of| !of.is_load() && of.ports.contains(name));
    let others = handles.iter().map(|handle| &handle.name);
    let mut others = others.filter(|name| name.owner == port.owner && *name != port && is_held(name));
    let end = others.next()?;
    others.next().is_none().then(|| end.clone())
}

/// The sine of the angle at a corner between the ways to two others; 0 where it is at one of them.
fn sine([corner, one, other]: [Point; 3]) -> f64 {
    let (a, b) = (between(corner, one), between(corner, other));
    let size = a[0].hypot(a[1]) * b[0].hypot(b[1]);
    if size > 0.0 { (a[0] * b[1] - a[1] * b[0]) / size } else { 0.0 }
}
