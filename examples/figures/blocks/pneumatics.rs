//! Pneumatic parts.

use plm::view::{Block, Side, Symbol};

pub(super) fn blocks() -> Vec<Block> {
    vec![
        Block::new("air_source", Symbol::Source)
            .input("pressure")
            .port(Side::Right, "port")
            .outward("mass_flow")
            .noting("mass_flow > 0 out of the source"),
        Block::new("air_chamber", Symbol::Volume)
            .port(Side::Left, "port")
            .inward("mass_flow")
            .noting("mass_flow > 0 into the chamber"),
        Block::new("air_orifice", Symbol::Orifice)
            .port(Side::Left, "a")
            .inward("mass_flow")
            .port(Side::Right, "b")
            .outward("mass_flow")
            .noting("mass_flow > 0 from a to b"),
        Block::new("air_piston", Symbol::Piston)
            .port(Side::Left, "chamber")
            .port(Side::Right, "rod")
            .outward("force")
            .noting("opens: forwards (backwards is the mirror image);\nposition and force of the rod count to the right"),
        Block::new("air_cylinder", Symbol::Cylinder)
            .port(Side::Top, "port1")
            .port(Side::Top, "port2")
            .port(Side::Right, "rod")
            .outward("force")
            .noting("displacement from 0 to stroke; force > 0 pushes the rod out"),
    ]
}
