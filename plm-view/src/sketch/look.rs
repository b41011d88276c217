//! Colours and lines of a picture, light and dark, and its frame.

use super::paper::{escaped, number};
use crate::chart::{INK, PALETTE};

/// What is the same in light and dark.
const LINES: &str = "\
text{font:13px sans-serif;text-anchor:middle;dominant-baseline:central}\
.small{font-size:11px}.title{font-weight:bold;text-anchor:start}\
path,circle{stroke-width:1.6;fill:none;stroke-linejoin:round;stroke-linecap:round}\
.dash{stroke-dasharray:4 4}.edge{stroke-width:11}.link{stroke-width:8}.rail{stroke-width:3}.ground,.axis{stroke-width:1.2}";

/// Colours, as SVG has them.
struct Colours {
    ink: String,
    soft: String,
    paper: String,
    body: String,
    pale: String,
    ground: String,
    force: String,
    flow: String,
}

impl Colours {
    fn light() -> Self {
        let [ink, flow, force] = [INK, PALETTE[0], PALETTE[1]]
            .map(|colour| format!("#{:02X}{:02X}{:02X}", colour.0, colour.1, colour.2));
        let [soft, paper, body, pale, ground] =
            ["#6F7783", "#FFFFFF", "#CFE0F0", "#ECEFF3", "#C62828"].map(str::to_owned);
        Self { ink, soft, paper, body, pale, ground, force, flow }
    }

    fn dark() -> Self {
        let [ink, soft, paper, body, pale, ground, force, flow] =
            ["#E4E7EC", "#99A2AF", "#1B1F26", "#35506B", "#2A303A", "#FF7A70", "#FF9E4A", "#6CC0F0"]
                .map(str::to_owned);
        Self { ink, soft, paper, body, pale, ground, force, flow }
    }

    /// Bodies are links with an edge; what is not in question is `back`.
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

/// The whole file: shapes between `top` and `bottom`, in a frame that is `width` wide, pixels.
pub(super) fn file(title: &str, shapes: &str, width: f64, [top, bottom]: [f64; 2]) -> String {
    let (light, dark) = (Colours::light().rules(), Colours::dark().rules());
    let (title, [w, t, h]) = (escaped(title), [width, top, bottom - top].map(number));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{title}\" width=\"{w}\" height=\"{h}\" \
         viewBox=\"0 {t} {w} {h}\">\n<title>{title}</title>\n<style>{LINES}{light}@media(prefers-color-scheme:dark){{{dark}}}\
         </style>\n<rect class=\"paper\" y=\"{t}\" width=\"{w}\" height=\"{h}\"/>\n{shapes}</svg>\n"
    )
}
