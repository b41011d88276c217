//! `plm import`: declarations from URDF, SDF and MJCF, contours from DXF.

use std::path::Path;

use plm_import::Options;

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
    let file = read::file(&words.file()?, streams.input)?;
    let is_drawing = Path::new(&file.name).extension().is_some_and(|end| end.eq_ignore_ascii_case("dxf"));
    let imported = if is_drawing {
        plm_import::outline(&file.name, &file.text)
    } else {
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
