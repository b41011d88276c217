//! Tools: what is drawn by taking ports, as rows of one table.

use crate::insert::{Insertion, Section, Words};
use crate::names::PortName;
use crate::number::rounded;
use crate::picture::{Picture, between};
use crate::refusal::Refusal;

/// A part between two ports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tool {
    /// Its name in gestures, with which the names of its parts begin.
    pub word: &'static str,
    /// The part.
    part: &'static str,
    /// Its name in menus.
    pub title: &'static str,
    /// Its fields at first; `{length}` is the distance of the ports.
    fields: &'static str,
}

/// Tools that join two ports that are there.
pub const TOOLS: [Tool; 4] = [
    Tool { word: "pin", part: "revolute", title: "Pin", fields: "" },
    Tool { word: "weld", part: "weld", title: "Weld", fields: "" },
    Tool {
        word: "spring",
        part: "spring",
        title: "Spring",
        fields: "stiffness: 1000 N/m; free_length: {length};",
    },
    Tool { word: "damper", part: "spring", title: "Damper", fields: "damping: 100 N/(m/s);" },
];

impl Tool {
    /// A tool by its word.
    pub fn named(word: &str) -> Option<&'static Tool> {
        TOOLS.iter().find(|tool| tool.word == word)
    }

    /// Its part between two ports; gives its name.
    pub(crate) fn put(
        &self,
        [one, other]: [&PortName; 2],
        (picture, grid): (&Picture, f64),
        words: &mut Words,
        insertion: &mut Insertion,
    ) -> Result<String, Refusal> {
        if one.owner == other.owner {
            return Err(Refusal::Same(one.clone(), other.clone()));
        }
        let shown = |port: &PortName| picture.port(port).ok_or_else(|| Refusal::NotShown(port.clone()));
        let [dx, dy] = between(shown(one)?.at, shown(other)?.at);
        let length = format!("{} mm", rounded(1e3 * dx.hypot(dy), 1e3 * grid));
        let name = words.fresh(self.word);
        let fields = self.fields.replace("{length}", &length);
        let end = if fields.is_empty() { ";".to_owned() } else { format!(" {{ {fields} }}") };
        insertion.put(Section::Joints, format!("{} {name}({one}, {other}){end}", self.part));
        Ok(name)
    }
}
