//! Names that other tools have for the parts of the library.

/// Parts by the names that they have elsewhere (of the manual's, how they begin), and what they are here.
pub(crate) const ELSEWHERE: &[(&[&str], &str)] = &[
    (&["hinge", "pin", "pivot", "rotary", "bearing", "joint"], "a joint that turns is `revolute`"),
    (&["slider", "slide", "translational", "rail", "guide"], "a joint that slides is `prismatic`"),
    (&["fixed", "fix", "rigid"], "a joint that holds is `weld`"),
    (&["clamp", "locking", "parking_brake"], "what a condition closes and opens is `lock`"),
    (&["lugre", "bristle", "dahl", "dynamic_friction"], "friction with bristles is `bristle_friction`"),
    (&["journal", "journal_bearing", "loose_joint", "clearance_joint"], "a journal with play is `clearance`"),
    (
        &["mount", "rubber_mount", "compliant_joint", "flexure", "field"],
        "springs along and about both axes are `bushing`",
    ),
    (&["pawl", "ratchet_wheel", "one_way"], "a wheel with a pawl is `ratchet`"),
    (&["catch", "detent", "hook", "striker"], "what catches at a position is `latch`"),
    (
        &["limit", "limits", "range"],
        "limits belong to the joint: `revolute name(a, b) { lower_limit: -30 deg; upper_limit: 60 deg; }`",
    ),
    (&["slot", "slotted", "pin_in_slot"], "a pin that slides in a slot is `pin_slot`"),
    (
        &["motor", "actuator", "drive", "servo"],
        "a joint is driven by its `drive`: `revolute name(a, b) { drive: 1 N*m; }`",
    ),
    (&["damper", "dashpot", "spring_damper"], "a damper is a `spring` with a `damping`"),
    (&["gear", "gears", "rack", "belt"], "a gear is a row: `constraint name: b.angle = ratio*a.angle;`"),
    (&["torque", "moment", "couple"], "a torque on a body is `force name(body.port) { torque: 1 N*m; }`"),
    (&["load", "wrench", "thruster"], "a force at a port is `force`"),
    (&["bumper", "obstacle", "hard_stop"], "a face that a point stays in front of is `stop`"),
    (&["contact", "collision"], "what must not be negative is a row: `unilateral name: gap >= 0;`"),
    (
        &["coulomb", "dry_friction", "brake", "clutch"],
        "a friction is a row, `friction name: rate(displacement) within bound;`, and at a joint a parameter: `{ friction: 0.2; }`",
    ),
    (&["mass", "link", "bar", "rod", "rigid_body"], "what has a mass is a `body`"),
    (&["fn", "def", "function"], "a formula is a `let`, and what acts on bodies a `part`"),
    (&["plmbod"], "the manual's bodies are `body name { … }`"),
    (&["plmemb"], "the manual's embedding is a port of `ground { … }`"),
    (&["plmzer"], "a port that no part uses is free: leave this out"),
    (&["plmassembly"], "a mechanism is assembled at every start: leave this out"),
    (&["plmcalcul"], "points change axes by `to_absolute` and `to_relative`"),
];
