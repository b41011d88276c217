//! Cross sections of bars: areas and second moments of area.
//!
//! Rolled sections are those of EN 10365:2017 (series IPE, HEA, HEB): height, width, web, flange and root radius in mm. Their area
//! and their second moment follow from these with the fillets, as the standard's own do. Three tables that are published as Python
//! packages have the same sizes and values to the digits that they print: `eurocodepy` 0.1.44, `steelsnakes` 0.0.1a11 and
//! `steel-sections` 0.1.0.

use plm_cas::{Expr, Number};

use crate::collect::{CollectVec, MapEach};
use crate::diag::{Code, help_similar};
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Value};
use crate::syntax::ast::{self, ExprKind};
use crate::units::Dimension;

/// Property of a section.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum SectionValue {
    /// Its area.
    Area,
    /// Its second moment of area about the axis across its height.
    Moment,
}

/// Area and second moment of area about the axis across the height.
#[derive(Clone, Copy)]
struct Section {
    area: Expr,
    moment: Expr,
}

/// A rolled section: its size by name, height, width, web, flange, and root radius, mm times 10.
type Rolled = (i64, [i32; 5]);

/// How a section follows from the sizes after its name.
#[derive(Clone, Copy)]
enum Shape {
    /// Of lengths.
    Simple(fn(&[Expr]) -> Section),
    /// Of a series, by the size that names it.
    Rolled(&'static [Rolled]),
}

/// Sections by their names, with the sizes that follow the name.
const SHAPES: [(&str, &[&str], Shape); 7] = [
    ("rectangle", &["width", "height"], Shape::Simple(|sizes| rectangle(sizes[0], sizes[1]))),
    ("round", &["diameter"], Shape::Simple(|sizes| round(sizes[0]))),
    ("tube", &["diameter", "wall"], Shape::Simple(|sizes| tube(sizes[0], sizes[1]))),
    ("box", &["width", "height", "wall"], Shape::Simple(|sizes| hollow(sizes[0], sizes[1], sizes[2]))),
    ("ipe", &["size"], Shape::Rolled(IPE)),
    ("hea", &["size"], Shape::Rolled(HEA)),
    ("heb", &["size"], Shape::Rolled(HEB)),
];

const IPE: &[Rolled] = &[
    (80, [800, 460, 38, 52, 50]),
    (100, [1000, 550, 41, 57, 70]),
    (120, [1200, 640, 44, 63, 70]),
    (140, [1400, 730, 47, 69, 70]),
    (160, [1600, 820, 50, 74, 90]),
    (180, [1800, 910, 53, 80, 90]),
    (200, [2000, 1000, 56, 85, 120]),
    (220, [2200, 1100, 59, 92, 120]),
    (240, [2400, 1200, 62, 98, 150]),
    (270, [2700, 1350, 66, 102, 150]),
    (300, [3000, 1500, 71, 107, 150]),
    (330, [3300, 1600, 75, 115, 180]),
    (360, [3600, 1700, 80, 127, 180]),
    (400, [4000, 1800, 86, 135, 210]),
    (450, [4500, 1900, 94, 146, 210]),
    (500, [5000, 2000, 102, 160, 210]),
    (550, [5500, 2100, 111, 172, 240]),
    (600, [6000, 2200, 120, 190, 240]),
];

const HEA: &[Rolled] = &[
    (100, [960, 1000, 50, 80, 120]),
    (120, [1140, 1200, 50, 80, 120]),
    (140, [1330, 1400, 55, 85, 120]),
    (160, [1520, 1600, 60, 90, 150]),
    (180, [1710, 1800, 60, 95, 150]),
    (200, [1900, 2000, 65, 100, 180]),
    (220, [2100, 2200, 70, 110, 180]),
    (240, [2300, 2400, 75, 120, 210]),
    (260, [2500, 2600, 75, 125, 240]),
    (280, [2700, 2800, 80, 130, 240]),
    (300, [2900, 3000, 85, 140, 270]),
    (320, [3100, 3000, 90, 155, 270]),
    (340, [3300, 3000, 95, 165, 270]),
    (360, [3500, 3000, 100, 175, 270]),
    (400, [3900, 3000, 110, 190, 270]),
    (450, [4400, 3000, 115, 210, 270]),
    (500, [4900, 3000, 120, 230, 270]),
    (550, [5400, 3000, 125, 240, 270]),
    (600, [5900, 3000, 130, 250, 270]),
    (650, [6400, 3000, 135, 260, 270]),
    (700, [6900, 3000, 145, 270, 270]),
    (800, [7900, 3000, 150, 280, 300]),
    (900, [8900, 3000, 160, 300, 300]),
    (1000, [9900, 3000, 165, 310, 300]),
];

const HEB: &[Rolled] = &[
    (100, [1000, 1000, 60, 100, 120]),
    (120, [1200, 1200, 65, 110, 120]),
    (140, [1400, 1400, 70, 120, 120]),
    (160, [1600, 1600, 80, 130, 150]),
    (180, [1800, 1800, 85, 140, 150]),
    (200, [2000, 2000, 90, 150, 180]),
    (220, [2200, 2200, 95, 160, 180]),
    (240, [2400, 2400, 100, 170, 210]),
    (260, [2600, 2600, 100, 175, 240]),
    (280, [2800, 2800, 105, 180, 240]),
    (300, [3000, 3000, 110, 190, 270]),
    (320, [3200, 3000, 115, 205, 270]),
    (340, [3400, 3000, 120, 215, 270]),
    (360, [3600, 3000, 125, 225, 270]),
    (400, [4000, 3000, 135, 240, 270]),
    (450, [4500, 3000, 140, 260, 270]),
    (500, [5000, 3000, 145, 280, 270]),
    (550, [5500, 3000, 150, 290, 270]),
    (600, [6000, 3000, 155, 300, 270]),
    (650, [6500, 3000, 160, 310, 270]),
    (700, [7000, 3000, 170, 320, 270]),
    (800, [8000, 3000, 175, 330, 300]),
    (900, [9000, 3000, 185, 350, 300]),
    (1000, [10000, 3000, 190, 360, 300]),
];

impl<'a> Resolver<'a> {
    /// `section_area(ipe, 200)`, `section_moment(tube, 40 mm, 3 mm)`
    pub(crate) fn of_section(
        &mut self,
        scope: ScopeId,
        wanted: SectionValue,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let (first, sizes) = (&arguments[0], &arguments[1..]);
        let name = match &first.kind {
            ExprKind::Name(name) if name.indices.is_empty() => name.ident.text.as_str(),
            _ => "",
        };
        let Some((name, takes, shape)) = SHAPES.iter().find(|(known, ..)| *known == name) else {
            let names: Vec<&str> = SHAPES.iter().map(|(known, ..)| *known).collect_vec();
            let diagnostic =
                self.error(scope, Code::UnknownOption, first.span, "the name of a section is expected");
            help_similar(diagnostic, name, "section", "sections", &names);
            return Err(Failed);
        };
        if sizes.len() != takes.len() {
            let message = format!("a section `{name}` has {} sizes, found {}", takes.len(), sizes.len());
            self.error(scope, Code::WrongCount, first.span, message)
                .note(format!("its sizes: {}", takes.join(", ")));
            return Err(Failed);
        }
        let (section, reads) = match shape {
            Shape::Rolled(series) => (self.rolled_section(scope, name, series, &sizes[0])?, Reads::NOTHING),
            Shape::Simple(section) => {
                let (lengths, reads) = self.lengths_of_section(scope, sizes)?;
                (section(&lengths), reads)
            }
        };
        let (value, power) = match wanted {
            SectionValue::Area => (section.area, 2),
            SectionValue::Moment => (section.moment, 4),
        };
        let dimension = Dimension { m: power, ..Dimension::NUMBER };
        Ok(Quantity::new(value, Nature::derived(dimension, reads)).into())
    }

    fn rolled_section(
        &mut self,
        scope: ScopeId,
        name: &str,
        series: &[Rolled],
        size: &'a ast::Expr,
    ) -> Eval<Section> {
        let wanted = self.eval_int(scope, size)?;
        let Some((_, sizes)) = series.iter().find(|(known, _)| *known == wanted) else {
            let message = format!("there is no `{name}` section of the size {wanted}");
            let known = series.iter().map(|(known, _)| known.to_string()).collect_vec();
            self.error(scope, Code::UnknownOption, size.span, message)
                .note(format!("its sizes: {}", known.join(", ")));
            return Err(Failed);
        };
        Ok(i_section((*sizes).map_each(|tenths| Expr::from(tenths) / Expr::from(10_000))))
    }

    fn lengths_of_section(&mut self, scope: ScopeId, sizes: &'a [ast::Expr]) -> Eval<(Vec<Expr>, Reads)> {
        let (mut lengths, mut reads) = (Vec::new(), Reads::NOTHING);
        for size in sizes {
            let found = self.eval_quantity(scope, size, Dimension::LENGTH, Reads::ALL)?;
            let number = found.value.as_number().map(Number::to_f64);
            if let Some(length) = number.filter(|length| *length <= 0.0) {
                let message = format!("the sizes of a section are positive, found {length} m");
                self.error(scope, Code::NotPositive, size.span, message);
                return Err(Failed);
            }
            lengths.push(found.value);
            reads = reads.and(found.nature.reads);
        }
        Ok((lengths, reads))
    }
}

impl Section {
    /// Without another one about the same centre.
    fn less(self, other: Section) -> Section {
        Section { area: self.area - other.area, moment: self.moment - other.moment }
    }
}

fn rectangle(width: Expr, height: Expr) -> Section {
    Section { area: width * height, moment: width * height.powi(3) / Expr::from(12) }
}

fn round(diameter: Expr) -> Section {
    let pi = Expr::pi();
    Section { area: pi * diameter.powi(2) / Expr::from(4), moment: pi * diameter.powi(4) / Expr::from(64) }
}

fn tube(diameter: Expr, wall: Expr) -> Section {
    round(diameter).less(round(diameter - Expr::from(2) * wall))
}

fn hollow(width: Expr, height: Expr, wall: Expr) -> Section {
    let two = Expr::from(2);
    rectangle(width, height).less(rectangle(width - two * wall, height - two * wall))
}

/// Two flanges, a web, and four fillets: what a quarter of a circle leaves of a square with the side r. Its area is `(1 - pi/4) r^2`, and
/// from the centre of the circle its first moment is `r^3/6` and its second moment `(1/3 - pi/16) r^4`.
fn i_section([height, width, web, flange, radius]: [Expr; 5]) -> Section {
    let (pi, two) = (Expr::pi(), Expr::from(2));
    let inner = height - two * flange;
    let outside = rectangle(width, height).less(rectangle(width, inner));
    let between = rectangle(web, inner);
    let share = Expr::ONE - pi / Expr::from(4);
    let first = Expr::ONE / Expr::from(6);
    let second = Expr::ONE / Expr::from(3) - pi / Expr::from(16);
    // From the axis of the section to the centre of the circle.
    let arm = inner / two - radius;
    let fillets = Section {
        area: Expr::from(4) * share * radius.powi(2),
        moment: Expr::from(4)
            * (share * radius.powi(2) * arm.powi(2)
                + two * first * radius.powi(3) * arm
                + second * radius.powi(4)),
    };
    Section {
        area: outside.area + between.area + fillets.area,
        moment: outside.moment + between.moment + fillets.moment,
    }
}
