//! Transmissions, drives and brakes between shafts, sliders and ropes.

use plm::view::{Block, Side, Symbol};

pub(super) fn blocks() -> Vec<Block> {
    [transmission(), ropes(), brakes(), motors()].concat()
}

fn transmission() -> Vec<Block> {
    vec![
        Block::new("planetary", Symbol::Planetary)
            .port(Side::Left, "sun")
            .turning("torque_sun")
            .port(Side::Right, "ring")
            .turning("torque_ring")
            .port(Side::Top, "carrier")
            .turning("torque_carrier")
            .noting("angles count counter-clockwise; torques are what the gear does to the shafts"),
        Block::new("gearbox", Symbol::Gears)
            .port(Side::Left, "a")
            .turning("torque_a")
            .port(Side::Right, "b")
            .turning("torque_b")
            .noting(
                "the ratio is the speed of a over that of b; torques are what the gears do to the shafts",
            ),
        Block::new("worm", Symbol::Worm)
            .port(Side::Left, "a")
            .turning("torque_a")
            .port(Side::Right, "b")
            .turning("torque_b")
            .noting("a is the worm; with a positive lead angle both turn in the same sense"),
        Block::new("lead_screw", Symbol::Screw)
            .port(Side::Left, "screw")
            .turning("torque")
            .port(Side::Right, "nut")
            .outward("force")
            .noting("with a positive lead a positive angle moves the nut towards greater positions"),
    ]
}

fn ropes() -> Vec<Block> {
    vec![
        Block::new("rope", Symbol::Rope)
            .port(Side::Left, "end")
            .noting("falls, winches and tensioners take up its length; tension > 0 pulls"),
        Block::new("elastic_rope", Symbol::Rope)
            .port(Side::Left, "end")
            .noting("falls, winches and tensioners take up its length; tension > 0 pulls"),
        Block::new("winch", Symbol::Winch)
            .port(Side::Left, "rope")
            .port(Side::Right, "a")
            .noting("the shaft winds the rope up where it turns counter-clockwise;\nspeed is that of the rope onto the drum"),
        Block::new("capstan", Symbol::Capstan)
            .port(Side::Left, "near")
            .port(Side::Right, "far")
            .port(Side::Bottom, "drum")
            .turning("torque")
            .noting("a drum that turns towards greater angles pulls in at near and pays out at far"),
        Block::new("belt_tensioner", Symbol::Tensioner)
            .port(Side::Left, "strand")
            .port(Side::Right, "idler")
            .inward("force")
            .noting("the position of the idler counts from the straight strand; force pushes it back"),
    ]
}

fn brakes() -> Vec<Block> {
    vec![
        Block::new("brake", Symbol::Brake)
            .port(Side::Left, "a")
            .turning("torque")
            .noting("speed and the torque on the shaft count counter-clockwise"),
        Block::new("drum_brake", Symbol::Drum)
            .port(Side::Left, "a")
            .turning("torque")
            .noting("with two_leading both shoes lead where the shaft turns counter-clockwise"),
        Block::new("clutch", Symbol::Clutch)
            .port(Side::Left, "a")
            .port(Side::Right, "b")
            .turning("torque")
            .noting("speed is that of b over a; torque > 0 turns b counter-clockwise, and a the other way"),
        Block::new("freewheel", Symbol::Freewheel)
            .port(Side::Left, "a")
            .port(Side::Right, "b")
            .turning("torque")
            .noting("b may be faster than a, counter-clockwise; a takes b along"),
    ]
}

fn motors() -> Vec<Block> {
    vec![
        Block::new("dc_motor", Symbol::ElectricMotor)
            .input("voltage")
            .port(Side::Right, "a")
            .turning("torque")
            .noting("a positive voltage turns the shaft counter-clockwise"),
        Block::new("motor_curve", Symbol::ElectricMotor)
            .input("command")
            .port(Side::Right, "a")
            .turning("torque")
            .noting("a positive command turns the shaft counter-clockwise"),
        Block::new("servo", Symbol::ElectricMotor).input("target").port(Side::Right, "a").turning("torque"),
        Block::new("motion", Symbol::ElectricMotor)
            .input("value")
            .port(Side::Right, "a")
            .turning("torque")
            .noting("torque is what the motion does to the shaft"),
    ]
}
