//! Events that set states.

use crate::beside_text::same;
use crate::event_scenes::{Ball, FourBar, InAbsolute, InTree, Oven};

/// Events of mechanisms from text set the bits of compiled ones.
#[test]
fn mechanisms_from_text_set_the_same_bits() {
    same!(Ball: 1.6, Oven: 2.0, InTree: 1.0, InAbsolute: 1.0, FourBar: 1.0);
}
