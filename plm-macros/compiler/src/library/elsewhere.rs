//! Names that other tools have for the parts of the library.

/// Parts by the names that they have elsewhere (of the manual's, how they begin), and what they are here.
pub(crate) const ELSEWHERE: &[(&[&str], &str)] = &[
    (&["hinge", "pin", "pivot", "rotary", "bearing", "joint"], "a joint that turns is `revolute`"),
    (&["slider", "slide", "translational", "rail", "guide"], "a joint that slides is `prismatic`"),
    (&["fixed", "fix", "rigid", "lock", "clamp"], "a joint that holds is `weld`"),
    (&["slot", "slotted", "pin_in_slot"], "a pin that slides in a slot is `pin_slot`"),
    (
        &["motor", "actuator", "drive", "torque_motor"],
        "a joint is driven by its `drive`, or by a `dc_motor`, `motor_curve`, `servo` or `motion` at its `shaft`",
    ),
    (&["damper", "dashpot", "spring_damper"], "a damper is a `spring` with a `damping`"),
    (
        &["gears", "gear_pair", "gear_joint", "spur_gear", "ring_gear", "internal_gear", "cogwheel"],
        "wheels in mesh are a `gear`; a ring has a negative radius",
    ),
    (&["reducer", "transmission", "ideal_gear"], "a ratio between two shafts is a `gearbox`"),
    (&["epicyclic", "planet", "differential"], "sun, ring and carrier are a `planetary`"),
    (&["pinion", "rack_and_pinion", "rack_pinion"], "a pinion on a rack is a `rack`"),
    (&["worm_gear", "worm_drive"], "a worm and its wheel are a `worm`"),
    (&["screw", "ball_screw", "power_screw", "spindle", "nut"], "a nut on a thread is a `lead_screw`"),
    (
        &["pulley", "tackle", "block_and_tackle", "string", "tether", "cable"],
        "a rope over pulleys is a `rope` with a `fall` for each straight part",
    ),
    (&["drum", "reel", "hoist"], "a drum that winds a rope up is a `winch`"),
    (&["bollard", "wrap"], "a rope round a drum is a `capstan`"),
    (&["v_belt", "flat_belt"], "a belt that may slip is a `belt`"),
    (
        &["timing_belt", "toothed_belt", "sprocket"],
        "what does not slip is a `chain`, which also is a toothed belt",
    ),
    (&["idler", "tensioner"], "an idler on a strand is a `belt_tensioner`"),
    (
        &["universal", "universal_joint", "cardan", "hooke", "constant_velocity"],
        "a universal joint is not planar: its shafts do not lie in the plane; seen from one end it is a `gearbox` of ratio 1",
    ),
    (&["disc_brake", "disk_brake"], "a brake on a shaft is a `brake`"),
    (&["shoe_brake"], "a brake with shoes is a `drum_brake`"),
    (&["overrunning", "one_way_clutch", "sprag", "backstop"], "what holds in one sense is a `freewheel`"),
    (&["gas_strut"], "a strut filled with gas is a `gas_spring`"),
    (&["prescribed_motion", "trajectory", "rheonomic"], "a shaft that moves as it is told has a `motion`"),
    (
        &["nonlinear_spring", "spring_table", "table_spring"],
        "a spring with a curve is a `spring` with a `characteristic`",
    ),
    (&["torque", "moment", "couple"], "a torque on a body is `force name(body.port) { torque: 1 N*m; }`"),
    (&["load", "wrench", "thruster"], "a force at a port is `force`"),
    (
        &["contact", "stop", "bumper", "obstacle", "collision"],
        "what must not be negative is a row: `unilateral name: gap >= 0;`",
    ),
    (&["coulomb", "dry_friction"], "a friction is a row: `friction name: rate(displacement) within bound;`"),
    (&["mass", "link", "bar", "rod", "rigid_body"], "what has a mass is a `body`"),
    (&["fn", "def", "function"], "a formula is a `let`, and what acts on bodies a `part`"),
    (&["plmbod"], "the manual's bodies are `body name { … }`"),
    (&["plmemb"], "the manual's embedding is a port of `ground { … }`"),
    (&["plmzer"], "a port that no part uses is free: leave this out"),
    (&["plmassembly"], "a mechanism is assembled at every start: leave this out"),
    (&["plmcalcul"], "points change axes by `to_absolute` and `to_relative`"),
];
