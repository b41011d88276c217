//! Numbers in JSON, which knows no NaN and no infinity: `null` there, NaN when it is read.

use serde::{Deserialize, Deserializer};

/// For `#[serde(deserialize_with)]`; serde_json writes `null` by itself.
pub(crate) fn or_nan<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(from)?.unwrap_or(f64::NAN))
}
