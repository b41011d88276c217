//! Hydraulic parts.

use plm::view::{Block, Side, Symbol};

pub(super) fn blocks() -> Vec<Block> {
    [machines(), valves()].concat()
}

/// Volumes, and what moves or is moved by oil.
fn machines() -> Vec<Block> {
    vec![
        Block::new("fluid", Symbol::Text("oil".into()))
            .input("pressure")
            .output("modulus")
            .output("density")
            .output("viscosity"),
        Block::new("oil_source", Symbol::Source)
            .input("pressure")
            .port(Side::Right, "port")
            .outward("flow")
            .noting("flow > 0 out of the source"),
        Block::new("oil_tank", Symbol::Tank)
            .port(Side::Left, "port")
            .inward("flow")
            .noting("flow > 0 into the tank"),
        Block::new("chamber", Symbol::Volume)
            .port(Side::Left, "port")
            .inward("flow")
            .noting("flow > 0 into the chamber"),
        Block::new("piston", Symbol::Piston)
            .port(Side::Left, "chamber")
            .port(Side::Right, "rod")
            .outward("force")
            .noting("opens: forwards (backwards is the mirror image);\nposition and force of the rod count to the right"),
        Block::new("cylinder", Symbol::Cylinder)
            .port(Side::Top, "port1")
            .port(Side::Top, "port2")
            .port(Side::Right, "rod")
            .outward("force")
            .noting("displacement from 0 to stroke; force > 0 pushes the rod out"),
        Block::new("pump", Symbol::Pump)
            .port(Side::Left, "inlet")
            .inward("flow")
            .port(Side::Right, "outlet")
            .outward("flow")
            .port(Side::Top, "shaft")
            .turning("torque")
            .noting("flow > 0 from inlet to outlet at a positive speed of the shaft"),
        Block::new("hydraulic_motor", Symbol::Motor)
            .port(Side::Left, "a")
            .inward("flow")
            .port(Side::Right, "b")
            .outward("flow")
            .port(Side::Top, "shaft")
            .turning("torque")
            .noting("flow > 0 from a to b turns the shaft towards greater angles"),
        Block::new("accumulator", Symbol::Accumulator)
            .port(Side::Left, "port")
            .inward("flow")
            .noting("flow > 0 into the accumulator"),
        Block::new("oil_line", Symbol::Line)
            .port(Side::Left, "port")
            .inward("flow")
            .port(Side::Right, "end")
            .outward("flow")
            .noting("flow > 0 leaves at end"),
    ]
}

fn valves() -> Vec<Block> {
    let directional = |name| {
        Block::new(name, Symbol::Valve)
            .input("signal")
            .output("opening")
            .port(Side::Top, "a")
            .outward("flow_a")
            .port(Side::Top, "b")
            .outward("flow_b")
            .port(Side::Bottom, "supply")
            .port(Side::Bottom, "tank")
            .noting("signal > 0 opens supply to a and b to tank;\nsignal < 0 opens supply to b and a to tank")
    };
    vec![
        Block::new("orifice", Symbol::Orifice)
            .port(Side::Left, "a")
            .inward("flow")
            .port(Side::Right, "b")
            .outward("flow")
            .noting("flow > 0 from a to b"),
        directional("servo_valve"),
        directional("proportional_valve"),
        Block::new("relief_valve", Symbol::Relief)
            .port(Side::Left, "a")
            .inward("flow")
            .port(Side::Right, "b")
            .outward("flow")
            .noting("flow > 0 from a to b"),
        Block::new("check_valve", Symbol::Check)
            .port(Side::Left, "a")
            .inward("flow")
            .port(Side::Right, "b")
            .outward("flow")
            .noting("flow > 0 from a to b; there is none back"),
        Block::new("flow_control", Symbol::FlowControl)
            .port(Side::Left, "a")
            .inward("flow")
            .port(Side::Right, "b")
            .outward("flow")
            .noting("flow > 0 from a to b"),
        Block::new("counterbalance_valve", Symbol::Relief)
            .port(Side::Left, "load")
            .inward("flow")
            .port(Side::Right, "valve")
            .outward("flow")
            .port(Side::Top, "pilot")
            .noting("flow > 0 from load to valve: the load goes down"),
    ]
}
