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
        &["contact", "collision", "obstacle", "point_contact", "sphere_contact"],
        "shapes in contact are `point_on_line`, `circle_on_line`, `circle_on_circle` and others; any gap is a row: `unilateral name: gap >= 0;`",
    ),
    (
        &["terrain", "ground_contact", "height_field", "profile"],
        "ground is `ground_profile`, or `point_on_polyline`",
    ),
    (&["stairs", "polyline"], "what stands on a polyline is `point_on_polyline` or `circle_on_polyline`"),
    (&["polygon", "box_contact"], "corners of a body on a line are `polygon_on_line`"),
    (
        &["roll", "rolling_joint", "rolling_wheel"],
        "what rolls without slip is `rolling`, what may slip a `wheel`",
    ),
    (&["tire", "pacejka"], "a wheel with the magic formula is a `tyre`"),
    (&["cam_follower", "follower", "camshaft"], "a cam with its follower is `cam`"),
    (&["geneva_drive", "maltese_cross", "indexer"], "a Geneva drive is `geneva`"),
    (&["curve", "path", "bead", "point_curve"], "a point that keeps to a curve is `point_on_curve`"),
    (&["stop", "bumper"], "what must not be negative is a row: `unilateral name: gap >= 0;`"),
    (
        &["coulomb", "dry_friction", "brake", "clutch"],
        "a friction is a row: `friction name: rate(displacement) within bound;`",
    ),
    (&["mass", "link", "bar", "rod", "rigid_body"], "what has a mass is a `body`"),
    (&["fn", "def"], "a formula is a `let`, and what acts on bodies a `part`"),
    (&["plmbod"], "the manual's bodies are `body name { … }`"),
    (&["plmemb"], "the manual's embedding is a port of `ground { … }`"),
    (&["plmzer"], "a port that no part uses is free: leave this out"),
    (&["plmassembly"], "a mechanism is assembled at every start: leave this out"),
    (&["plmcalcul"], "points change axes by `to_absolute` and `to_relative`"),
];
