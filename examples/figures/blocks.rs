//! The parts that lie in no plane: their ports, and which way their flows and forces count.

use plm::view::{Block, Side, Symbol};

/// One box for each page.
pub(crate) fn blocks() -> Vec<Block> {
    [mechanics(), hydraulics(), signals()].concat()
}

fn mechanics() -> Vec<Block> {
    let spring = |name| {
        Block::new(name, Symbol::SpringDamper)
            .port(Side::Left, "a")
            .outward("force")
            .port(Side::Right, "b")
            .outward("force")
            .noting("force > 0 pushes a and b apart")
    };
    let shaft_spring = |name| {
        Block::new(name, Symbol::ShaftSpring)
            .port(Side::Left, "a")
            .port(Side::Right, "b")
            .turning("torque")
            .noting("torque > 0 turns b counter-clockwise, and a the other way")
    };
    vec![
        spring("slider_spring"),
        spring("force_state_spring"),
        shaft_spring("shaft_spring"),
        shaft_spring("torque_state_spring"),
        Block::new("attached_mass", Symbol::Mass).port(Side::Left, "a").inward("force").noting(
            "positions count to the right; the mass moves as the port does;\nforce is what it does to the port",
        ),
        Block::new("rotor", Symbol::Rotor)
            .port(Side::Left, "shaft")
            .turning("angle")
            .port(Side::Top, "frame")
            .noting("angle and torque count counter-clockwise"),
        Block::new("attached_rotor", Symbol::Rotor)
            .port(Side::Left, "a")
            .turning("torque")
            .noting("the rotor turns ratio times as fast as the port;\ntorque is what it does to the port"),
        Block::new("end_stop", Symbol::Stops)
            .port(Side::Left, "a")
            .port(Side::Right, "b")
            .outward("force")
            .noting("a holds both stops; positions and the force on b count to the right"),
        Block::new("slider_ground", Symbol::Ground)
            .port(Side::Right, "slider")
            .outward("force")
            .noting("position and the force on what is attached count to the right"),
        Block::new("slider_velocity", Symbol::Motion)
            .input("velocity")
            .port(Side::Right, "slider")
            .outward("force")
            .noting("velocity and the force on what is attached count to the right"),
    ]
}

fn hydraulics() -> Vec<Block> {
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
        Block::new("orifice", Symbol::Orifice)
            .port(Side::Left, "a")
            .inward("flow")
            .port(Side::Right, "b")
            .outward("flow")
            .noting("flow > 0 from a to b"),
        Block::new("servo_valve", Symbol::Valve)
            .input("signal")
            .output("opening")
            .port(Side::Top, "a")
            .outward("flow_a")
            .port(Side::Top, "b")
            .outward("flow_b")
            .port(Side::Bottom, "supply")
            .port(Side::Bottom, "tank")
            .noting("signal > 0 opens supply to a and b to tank;\nsignal < 0 opens supply to b and a to tank"),
        Block::new("oil_line", Symbol::Line)
            .port(Side::Left, "port")
            .inward("flow")
            .port(Side::Right, "end")
            .outward("flow")
            .noting("flow > 0 leaves at end"),
    ]
}

fn signals() -> Vec<Block> {
    vec![
        Block::new("force_sensor", Symbol::Text("gain (measured − offset)".into()))
            .input("x")
            .input("y")
            .input("torque")
            .output("signal"),
        Block::new("ramps", Symbol::Ramps).output("value"),
        Block::new("lag", Symbol::Lag).input("signal").output("value"),
        Block::new("lag2", Symbol::Swing).input("signal").output("value"),
        Block::new("pid", Symbol::Text("P + I + D".into())).input("error").output("value"),
    ]
}
