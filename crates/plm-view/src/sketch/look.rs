//! Colours and lines of a picture, light and dark, and its frame.

use super::paper::number;
use crate::svg::{CURVES, FONT, INK, escape};

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

/// The whole file: shapes between `top` and `bottom`, in a frame that is `width` wide, pixels.
pub(super) fn file(title: &str, shapes: &str, width: f64, [top, bottom]: [f64; 2]) -> String {
    let (light, dark) = (Colours::LIGHT.rules(), Colours::DARK.rules());
    let (title, [w, t, h]) = (escape(title), [width, top, bottom - top].map(number));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{title}\" width=\"{w}\" height=\"{h}\" \
         viewBox=\"0 {t} {w} {h}\">\n<title>{title}</title>\n<style>text{{font-family:{FONT}}}{LINES}{light}@media(prefers-color-scheme:dark){{{dark}}}\
         </style>\n<rect class=\"paper\" y=\"{t}\" width=\"{w}\" height=\"{h}\"/>\n{shapes}</svg>\n"
    )
}
