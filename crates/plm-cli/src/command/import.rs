//! `plm import`: declarations from URDF, SDF and MJCF, contours from DXF.

use std::path::Path;

use plm_import::{Options, Selection};

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::checked::{Checked, Declarations};
use crate::read;

pub(super) const COMMAND: Command = Command {
    name: "import",
    usage: "FILE …",
    title: "writes the declaration of a URDF, SDF or MJCF file, the contour of a DXF file",
    options: &[
        ("--without PARTS", "leaves out `limits` of joints or their dry `friction`; as often as wanted"),
        ("--layer NAME", "of a drawing this layer alone; as often as wanted"),
        ("--part NUMBER", "of several bodies in a drawing this one, the largest first"),
        ("--gap LENGTH", "ends of lines that are apart by no more meet, in the unit of the drawing"),
        ("--fix LINK", "joins a link to the world, where contact holds it in the file; as often as wanted"),
    ],
    run,
};

fn run(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let mut options = Options::default();
    for part in words.values("--without") {
        match part.as_str() {
            "limits" => options.without_limits = true,
            "friction" => options.without_friction = true,
            other => return Err(format!("--without wants `limits` or `friction`, not `{other}`").into()),
        }
    }
    options.fixed = words.values("--fix");
    let selection = selection(&mut words)?;
    let name = words.file()?;
    let is_drawing = Path::new(&name).extension().is_some_and(|end| end.eq_ignore_ascii_case("dxf"));
    let imported = if is_drawing {
        let bytes = read::drawing(&name, streams.input)?;
        let text = plm_import::drawing_text(&bytes).map_err(|why| format!("{name}: {why}"))?;
        plm_import::outline(&name, &text, &selection)
    } else {
        let file = read::file(&name, streams.input)?;
        let mut included = |name: &str| read::named(name, &file.name);
        plm_import::mechanism(&file.name, &file.text, &options, &mut included)
    };
    for notice in &imported.notices {
        writeln!(streams.errors, "{notice}")?;
    }
    let Some(text) = imported.text else { return Ok(Outcome::Wrong) };
    write!(streams.output, "{text}")?;
    Ok(if is_drawing || is_right(&text, streams)? { Outcome::Good } else { Outcome::Wrong })
}

/// Selection of the parts of a drawing.
fn selection(words: &mut Words) -> Result<Selection, Failure> {
    let mut selection = Selection { layers: words.values("--layer"), ..Selection::default() };
    if let Some(text) = words.value("--part") {
        let wrong = || format!("--part wants the number of a part, as in `--part 1`, not `{text}`");
        selection.part = Some(text.parse().ok().filter(|number| *number > 0).ok_or_else(wrong)?);
    }
    if let Some(text) = words.value("--gap") {
        let wrong =
            || format!("--gap wants a length in the unit of the drawing, as in `--gap 0.05`, not `{text}`");
        let gap = text.parse().ok().filter(|gap: &f64| *gap >= 0.0 && gap.is_finite());
        selection.gap = gap.ok_or_else(wrong)?;
    }
    Ok(selection)
}

/// Analyses the written declaration, and writes its diagnostics; false where one is an error.
fn is_right(text: &str, streams: &mut Streams) -> Result<bool, Failure> {
    let mut is_right = true;
    for declaration in Declarations::new("<declaration>", text).checked() {
        let Checked { sources, expansion } = declaration?;
        for diagnostic in expansion.diagnostics.sorted() {
            writeln!(streams.errors, "{}", diagnostic.render(&sources))?;
        }
        is_right &= !expansion.diagnostics.has_errors();
    }
    Ok(is_right)
}
