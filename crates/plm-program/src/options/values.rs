//! Values of options, from their words.

use plm_foreign::By;
use plm_foreign::fmi::Version;
use plm_run::{BadOption, unknown};

use crate::arguments::Arguments;

/// Methods by their names.
pub(super) fn methods(text: Option<&str>) -> Result<Vec<By>, BadOption> {
    let named = |name: &str| {
        let known = By::ALL.into_iter().find(|by| by.called().rust.eq_ignore_ascii_case(name));
        known.ok_or_else(|| unknown(name))
    };
    text.iter().flat_map(|text| text.split(',')).map(|name| named(name.trim())).collect()
}

/// A positive time, s.
pub(super) fn time(name: &str, given: &Arguments) -> Result<Option<f64>, BadOption> {
    let Some(word) = given.text(name)? else { return Ok(None) };
    let time = word.parse().ok().filter(|time| *time > 0.0 && f64::is_finite(*time));
    let wrong = || BadOption::new(format!("--{name} wants a positive time in seconds, not `{word}`"));
    time.map(Some).ok_or_else(wrong)
}

/// `mass=3`, as often as it stands there.
pub(super) fn settings(name: &str, given: &Arguments) -> Result<Vec<(String, f64)>, BadOption> {
    let setting = |word: String| {
        let (what, value) = word.split_once('=')?;
        Some((what.trim().to_owned(), value.trim().parse().ok()?))
    };
    let wrong = |word: &str| BadOption::new(format!("--{name} wants NAME=NUMBER, not `{word}`"));
    given.texts(name)?.into_iter().map(|word| setting(word.clone()).ok_or_else(|| wrong(&word))).collect()
}

/// A version of FMI.
pub(super) fn version_of(word: &str) -> Result<Version, BadOption> {
    match word {
        "2" | "2.0" => Ok(Version::Two),
        "3" | "3.0" => Ok(Version::Three),
        _ => Err(BadOption::new(format!("--fmi wants 2 or 3, not `{word}`"))),
    }
}

/// A port; 0 where none was said.
pub(super) fn port_of(word: &str) -> Result<u16, BadOption> {
    if word.is_empty() {
        return Ok(0);
    }
    word.parse().map_err(|_| BadOption::new(format!("--serve wants a port from 1 to 65535, not `{word}`")))
}
