//! Events as a run begins.

use crate::beside_text::same;
use crate::starts_scenes as scenes;

#[test]
fn what_is_set_as_a_run_begins_has_the_bits_of_compiled_code() {
    same!(scenes::Thrown: 1.0, scenes::Started: 1.0);
}
