//! Colours and lines of a picture, light and dark.

use crate::svg::{CURVES, FONT, INK};

/// Style that is equal in light and dark.
const LINES: &str = "\
text{font-size:13px;text-anchor:middle;dominant-baseline:central}\
.small{font-size:11px}.title{font-weight:bold;text-anchor:start}\
path,circle{stroke-width:1.6;fill:none;stroke-linejoin:round;stroke-linecap:round}\
.dash{stroke-dasharray:4 4}.edge{stroke-width:11}.link{stroke-width:8}.rail{stroke-width:3}.ground,.axis{stroke-width:1.2}";

/// Colours, as SVG has them.
struct Colours {
    ink: &'static str,
    soft: &'static str,
    paper: &'static str,
    body: &'static str,
    pale: &'static str,
    ground: &'static str,
    force: &'static str,
    flow: &'static str,
}

impl Colours {
    const LIGHT: Self = Self {
        ink: INK,
        soft: "#6f7783",
        paper: "#ffffff",
        body: "#cfe0f0",
        pale: "#eceff3",
        ground: "#c62828",
        force: CURVES[1],
        flow: CURVES[0],
    };
    const DARK: Self = Self {
        ink: "#e4e7ec",
        soft: "#99a2af",
        paper: "#1b1f26",
        body: "#35506b",
        pale: "#2a303a",
        ground: "#ff7a70",
        force: "#ff9e4a",
        flow: "#6cc0f0",
    };

    /// Bodies are links with an edge; faded ones are `back`.
    fn rules(&self) -> String {
        let Self { ink, soft, paper, body, pale, ground, force, flow } = self;
        format!(
            "text{{fill:{ink}}}.small,.given{{fill:{soft}}}.sign{{fill:{force}}}path,circle{{stroke:{ink}}}\
             .paper,.white{{fill:{paper}}}.black,.edge,.head{{fill:{ink}}}.link{{stroke:{body}}}.link,.plate{{fill:{body}}}\
             .back{{stroke:{soft}}}.back.edge,.back.black{{fill:{soft}}}.back.link{{stroke:{pale}}}.back.link,.back.plate{{fill:{pale}}}\
             .ground{{stroke:{ground}}}.force{{stroke:{force}}}.force.head{{fill:{force}}}\
             .flow{{stroke:{flow}}}.flow.head,.flows{{fill:{flow}}}"
        )
    }
}

/// The style sheet of a picture, which follows the reader's choice of light or dark.
pub(super) fn style() -> String {
    let dark = Colours::DARK.rules();
    format!("{}@media(prefers-color-scheme:dark){{{dark}}}", light())
}

/// The part of it that is light.
fn light() -> String {
    format!("text{{font-family:{FONT}}}{LINES}{}", Colours::LIGHT.rules())
}

/// Lines and colours of an element by the light rules, for pictures in pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Look {
    pub(super) fill: Option<[u8; 3]>,
    /// Its colour, and its width in pixels.
    pub(super) stroke: Option<([u8; 3], f64)>,
    pub(super) is_dashed: bool,
    /// Height of letters, in pixels.
    pub(super) letters: f64,
    /// Does a text begin at its place, which is its middle otherwise?
    pub(super) begins: bool,
}

/// The looks of elements by their names and classes: the cascade of CSS for selectors of an element and classes.
pub(super) struct Looks(String);

impl Looks {
    pub(super) fn light() -> Self {
        Self(light())
    }

    pub(super) fn of(&self, element: &str, class: &str) -> Look {
        let value = |name| self.value(element, class, name);
        let width = value("stroke-width").and_then(|text| text.parse().ok()).unwrap_or(1.0);
        Look {
            fill: value("fill").and_then(colour),
            stroke: value("stroke").and_then(colour).map(|colour| (colour, width)),
            is_dashed: value("stroke-dasharray").is_some(),
            letters: value("font-size")
                .and_then(|text| text.trim_end_matches("px").parse().ok())
                .unwrap_or(13.0),
            begins: value("text-anchor") == Some("start"),
        }
    }

    /// The value of a property: of the selectors that match, those with most classes decide, and of these the last.
    fn value(&self, element: &str, class: &str, property: &str) -> Option<&str> {
        let mut found: Option<(usize, &str)> = None;
        for (selectors, declarations) in self.0.split('}').filter_map(|rule| rule.split_once('{')) {
            let mut own = declarations.split(';').filter_map(|own| own.split_once(':'));
            let Some((_, value)) = own.rfind(|(name, _)| *name == property) else { continue };
            let weight = selectors.split(',').filter_map(|selector| weight(selector, element, class)).max();
            if let Some(weight) = weight
                && found.is_none_or(|(heaviest, _)| weight >= heaviest)
            {
                found = Some((weight, value));
            }
        }
        found.map(|(_, value)| value)
    }
}

/// How much a selector has to say of an element; nothing where it does not match.
fn weight(selector: &str, element: &str, class: &str) -> Option<usize> {
    let (name, wanted) = selector.split_once('.').unwrap_or((selector, ""));
    let mut wanted = wanted.split('.').filter(|name| !name.is_empty());
    let has = |name: &str| class.split(' ').any(|own| own == name);
    let classes = wanted.clone().count();
    let matches = (name.is_empty() || name == element) && wanted.all(has);
    matches.then_some(2 * classes + usize::from(!name.is_empty()))
}

/// `#rrggbb`; none for `none`.
fn colour(text: &str) -> Option<[u8; 3]> {
    let number = u32::from_str_radix(text.strip_prefix('#')?, 16).ok()?;
    let [_, parts @ ..] = number.to_be_bytes();
    Some(parts)
}

#[cfg(test)]
mod tests {
    use super::{Colours, INK, Looks, colour};

    #[test]
    fn more_classes_decide_and_of_as_many_the_last() {
        let (looks, light) = (Looks::light(), Colours::LIGHT);
        let [ink, soft, pale, body] = [INK, light.soft, light.pale, light.body].map(colour);
        let plain = looks.of("path", "");
        assert_eq!((plain.fill, plain.stroke.map(|(own, _)| Some(own))), (None, Some(ink)));
        assert_eq!(plain.stroke.map(|(_, width)| width), Some(1.6));
        let link = looks.of("path", "link");
        assert_eq!((link.fill, link.stroke.map(|(_, width)| width)), (body, Some(8.0)));
        // `.back` comes after `.link`, and `.back.link` has more classes than `.back`.
        let back = looks.of("path", "link back");
        assert_eq!((back.fill, back.stroke.map(|(own, _)| Some(own))), (pale, Some(pale)));
        assert_eq!(looks.of("path", "edge back").fill, soft);
        assert_eq!(looks.of("path", "force head").fill, colour(light.force));
        assert!(looks.of("path", "dash").is_dashed && !plain.is_dashed);
        let title = looks.of("text", "title");
        assert!(title.begins && !looks.of("text", "name").begins && title.stroke.is_none());
        assert_eq!((title.letters, looks.of("text", "small").letters), (13.0, 11.0));
    }
}
