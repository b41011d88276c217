//! Tables of links as CSV: their pins and their lengths, in mm.

use std::fmt::Write;

use super::sheet::own_place;
use super::{Cutting, Joint, Link, number};

/// The pins of links: where each stands on the sheet of its link, and what it joins.
pub(super) fn pins(links: &[Link], joints: &[Joint], cutting: &Cutting) -> String {
    let mut text = "link,layer,port,x (mm),y (mm),hole (mm),joint\n".to_owned();
    for link in links {
        for (name, at) in &link.ports {
            let [x, y] = own_place(link, *at).map(number);
            let is_here =
                |joint: &&Joint| joint.holes.iter().any(|(body, hole)| *body == link.body && hole == at);
            let here: Vec<&str> = joints.iter().filter(is_here).map(|joint| joint.name.as_str()).collect();
            let hole = if here.is_empty() { String::new() } else { number(1e3 * cutting.hole) };
            let _ = writeln!(text, "{},{},{name},{x},{y},{hole},{}", link.name, link.layer, here.join(" "));
        }
    }
    text
}

/// The distances between ports of each link.
pub(super) fn lengths(links: &[Link]) -> String {
    let mut text = "link,from,to,length (mm)\n".to_owned();
    for link in links {
        for (k, (from, [x0, y0])) in link.ports.iter().enumerate() {
            for (to, [x1, y1]) in &link.ports[k + 1..] {
                let length = number(1e3 * (x1 - x0).hypot(y1 - y0));
                let _ = writeln!(text, "{},{from},{to},{length}", link.name);
            }
        }
    }
    text
}
