//! Names that other tools have for the parts of the library.

/// Parts by the names that they have elsewhere (of the manual's, how they begin), and what they are here.
pub(crate) const ELSEWHERE: &[(&[&str], &str)] = &[
    (&["hinge", "pin", "pivot", "rotary", "bearing", "joint"], "a joint that turns is `revolute`"),
    (&["slider", "slide", "translational", "rail", "guide"], "a joint that slides is `prismatic`"),
    (&["fixed", "fix", "rigid", "lock", "clamp"], "a joint that holds is `weld`"),
    (&["slot", "slotted", "pin_in_slot"], "a pin that slides in a slot is `pin_slot`"),
    (
        &["motor", "actuator", "drive", "servo"],
        "a joint is driven by its `drive`: `revolute name(a, b) { drive: 1 N*m; }`",
    ),
    (&["damper", "dashpot", "spring_damper"], "a damper is a `spring` with a `damping`"),
    (&["gear", "gears", "rack", "belt"], "a gear is a row: `constraint name: b.angle = ratio*a.angle;`"),
    (&["torque", "moment", "couple"], "a torque on a body is `force name(body.port) { torque: 1 N*m; }`"),
    (&["load", "wrench", "thruster"], "a force at a port is `force`"),
    (
        &["contact", "stop", "bumper", "obstacle", "collision"],
        "what must not be negative is a row: `unilateral name: gap >= 0;`",
    ),
    (
        &["coulomb", "dry_friction", "brake", "clutch"],
        "a friction is a row: `friction name: rate(displacement) within bound;`",
    ),
    (
        &["gear_pump", "vane_pump", "piston_pump", "variable_pump"],
        "a displacement pump is `pump`, a variable one by its `setting`",
    ),
    (&["orbit_motor", "vane_motor", "hydro_motor"], "a displacement motor is `hydraulic_motor`"),
    (
        &["pressure_relief", "safety_valve", "pressure_relief_valve", "relief"],
        "a pressure relief valve is `relief_valve`",
    ),
    (
        &["non_return_valve", "one_way_valve", "check", "anti_cavitation_valve"],
        "a valve that lets oil go one way is `check_valve`",
    ),
    (
        &["overcentre_valve", "overcenter_valve", "load_holding_valve"],
        "a valve that holds a load is `counterbalance_valve`",
    ),
    (&["flow_regulator", "flow_control_valve", "flow_valve"], "a valve that holds a flow is `flow_control`"),
    (
        &["directional_valve", "four_three_valve", "spool_valve"],
        "a valve of three positions is `proportional_valve` or `servo_valve`",
    ),
    (&["tank", "reservoir"], "oil comes from an `oil_tank`"),
    (&["pneumatic_cylinder"], "a cylinder in air is `air_cylinder`"),
    (&["pneumatic_valve", "nozzle", "air_valve", "air_restriction"], "a restriction of air is `air_orifice`"),
    (&["pneumatic_chamber", "air_tank", "air_vessel"], "a volume of air is `air_chamber`"),
    (&["limiter", "limit", "saturate", "clip"], "a signal between two bounds is `saturation`"),
    (&["slew_rate", "slew_rate_limiter", "rate_limiter"], "a signal of bounded rate is `rate_limit`"),
    (&["relay", "schmitt_trigger", "backlash_switch"], "a switch with hysteresis is `hysteresis`"),
    (&["zero_order_hold", "unit_delay", "transport_delay", "sample_and_hold"], "a sampled signal is `delay`"),
    (
        &["digital_controller", "discrete_pid", "discrete_controller"],
        "a controller at a rate is `sampled_controller`",
    ),
    (&["random", "white_noise", "random_number"], "random numbers by a seed are `noise`"),
    (&["speed_source", "constant_speed", "engine"], "a shaft at a given speed is `shaft_velocity`"),
    (&["mass", "link", "bar", "rod", "rigid_body"], "what has a mass is a `body`"),
    (&["fn", "def", "function"], "a formula is a `let`, and what acts on bodies a `part`"),
    (&["plmbod"], "the manual's bodies are `body name { … }`"),
    (&["plmemb"], "the manual's embedding is a port of `ground { … }`"),
    (&["plmzer"], "a port that no part uses is free: leave this out"),
    (&["plmassembly"], "a mechanism is assembled at every start: leave this out"),
    (&["plmcalcul"], "points change axes by `to_absolute` and `to_relative`"),
];
