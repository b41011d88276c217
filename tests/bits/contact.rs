//! Trees, loops and bodies with rows of contact.

use crate::beside_text::same;
use crate::contact_scenes;

/// Bouncing to its end.
#[test]
fn trees_have_the_bits_of_compiled_code() {
    same!(contact_scenes::Ball: 3.0);
}
