//! The parts that lie in no plane: their ports, and which way their flows and forces count.

use plm::view::Block;

mod drives;
mod hydraulics;
mod lines;
mod pneumatics;
mod signals;

/// One box for each page.
pub(crate) fn blocks() -> Vec<Block> {
    [lines::blocks(), drives::blocks(), hydraulics::blocks(), pneumatics::blocks(), signals::blocks()]
        .concat()
}
