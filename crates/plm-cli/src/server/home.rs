//! Answers for the playground that no message of the protocol asks for: the first declaration of a text as files, to take home, and its
//! equations of motion.

use plm_compiler::Oracle;
use plm_compiler::token::Sources;
use plm_dynamic::Mechanism;
use plm_import::{Cutting, Drawing, to_links};
use plm_source::{File, Precision, Version};
use serde_json::{Map, Value, json};

use super::document::Document;
use crate::checked::{Checked, checked, place};
use crate::equations;
use crate::package::{Package, version};

/// Its package of cargo: the name and the files, or why there is none.
pub(super) fn package(document: &Document) -> Value {
    let Some(own) = text(document) else { return Value::Null };
    let mut sources = Sources::new();
    sources.add_text(&document.name, &own);
    match Package::new(&own, &sources, &version()) {
        Ok(Package { name, files }) => json!({ "name": name, "files": files }),
        Err(why) => json!({ "why": why }),
    }
}

/// Its C source, or the files of an FMU of that (`kind` is `c`, `fmi2` or `fmi3`), with what has to be told of them.
pub(super) fn source(document: &Document, params: &Value) -> Value {
    let Some(own) = text(document) else { return Value::Null };
    let version = match params["kind"].as_str() {
        Some("c") => None,
        Some("fmi2") => Some(Version::Two),
        Some("fmi3") => Some(Version::Three),
        Some("dxf") => return links(document, Drawing::Dxf, &params["motion"]),
        Some("svg") => return links(document, Drawing::Svg, &params["motion"]),
        _ => return json!({ "why": "a source is of the kind c, fmi2, fmi3, dxf or svg" }),
    };
    made(&document.name, &own, version).unwrap_or_else(|why| json!({ "why": why }))
}

/// Its links in true size, with layers for a motion: the poses of all bodies at moments of it, x, y and angle of each in turn.
fn links(document: &Document, drawing: Drawing, motion: &Value) -> Value {
    let Some(own) = text(document) else { return Value::Null };
    drawn(&document.name, &own, drawing, motion).unwrap_or_else(|why| json!({ "why": why }))
}

fn drawn(name: &str, text: &str, drawing: Drawing, motion: &Value) -> Result<Value, String> {
    let Checked { sources, expansion } = checked(name, text, None);
    let first = || expansion.diagnostics.sorted().first().map(|of| of.render(&sources)).unwrap_or_default();
    let mechanism = expansion.oracle.as_ref().map(Oracle::assembled).ok_or_else(first)?;
    let count = mechanism.bodies.len();
    let start: Vec<[f64; 3]> = mechanism.bodies.iter().map(|body| body.pose).collect();
    let moments = motion.as_array().into_iter().flatten().map(|moment| {
        let numbers: Vec<f64> = moment.as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
        numbers.chunks_exact(3).map(|pose| [pose[0], pose[1], pose[2]]).collect::<Vec<[f64; 3]>>()
    });
    let motion: Vec<Vec<[f64; 3]>> = std::iter::once(start).chain(moments).collect();
    if motion.iter().any(|poses| poses.len() != count) {
        return Err(format!("a moment of the motion has a pose of each of the {count} bodies: x, y, angle"));
    }
    let links = to_links(&mechanism, &motion, drawing, &Cutting::default(), &|span| place(&sources, span));
    let notices: Vec<String> = links.notices.iter().map(ToString::to_string).collect();
    let files = links.files.into_iter().map(|(name, text)| (name, Value::String(text)));
    Ok(
        json!({ "name": format!("{}_links", mechanism.name), "files": files.collect::<Map<_, _>>(), "notices": notices }),
    )
}

fn made(name: &str, text: &str, version: Option<Version>) -> Result<Value, String> {
    let mechanism = Mechanism::from_named_text(name, text).map_err(|error| error.to_string())?;
    let (files, notices) = match version {
        None => {
            (plm_source::c(&mechanism, Precision::Double).map_err(|failure| failure.to_string())?, Vec::new())
        }
        Some(version) => {
            let made = plm_source::fmu(&mechanism, version, None).map_err(|failure| failure.to_string())?;
            let without = made.without_exchange.iter();
            (made.files, without.map(|refused| format!("co-simulation alone: {refused}")).collect())
        }
    };
    let header =
        files.iter().find_map(|file| file.name.strip_suffix(".h").filter(|name| !name.ends_with("plm_math")));
    let name = header.map(|path| path.rsplit('/').next().unwrap_or(path).to_owned());
    let files = files.into_iter().map(|File { name, text }| (name, Value::String(text)));
    Ok(json!({ "name": name, "files": files.collect::<Map<_, _>>(), "notices": notices }))
}

/// Its equations of motion as they are written for people, or why there are none.
pub(super) fn equations(document: &Document) -> Value {
    let Some(declaration) = document.declarations.first() else { return Value::Null };
    let masked = declaration.excerpt.masked(&document.text);
    let Checked { sources, expansion } = checked(&document.name, &document.text, masked.as_deref());
    if let Some(oracle) = &expansion.oracle {
        return equations::json(&oracle.written());
    }
    let first = expansion.diagnostics.sorted().first().map(|of| of.render(&sources));
    json!({ "why": first.unwrap_or_default() })
}

/// The text of the first declaration.
fn text(document: &Document) -> Option<String> {
    let declaration = document.declarations.first()?;
    Some(declaration.excerpt.own_text(&document.text))
}
