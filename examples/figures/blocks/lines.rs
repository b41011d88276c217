//! Parts of one line, of a shaft, and masses on them.

use plm::view::{Block, Side, Symbol};

pub(super) fn blocks() -> Vec<Block> {
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
        Block::new("shaft_velocity", Symbol::Motion)
            .input("speed")
            .port(Side::Right, "shaft")
            .turning("torque")
            .noting("speed and the torque on what is attached count in one sense"),
        Block::new("shaft_ground", Symbol::Ground)
            .port(Side::Right, "shaft")
            .turning("torque")
            .noting("angle and the torque on what is attached count counter-clockwise"),
        Block::new("slider_velocity", Symbol::Motion)
            .input("velocity")
            .port(Side::Right, "slider")
            .outward("force")
            .noting("velocity and the force on what is attached count to the right"),
    ]
}
