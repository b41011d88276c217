//! Catalogue of the library: a word for each file in `parts/`, by folder.

/// Names and texts of the files of the library.
macro_rules! catalogue {
    ($($folder:literal: $($name:literal)*;)*) => {
        &[$($(($name, include_str!(concat!("../../parts/", $folder, "/", $name, ".plm"))),)*)*]
    };
}

/// Name of each part of the library and the text that defines it.
pub(crate) const PARTS: &[(&str, &str)] = catalogue! {
    "joints": "bushing" "clearance" "pin_slot" "prismatic" "revolute" "weld";
    "contacts": "latch" "lock" "ratchet" "stop";
    "forces": "force" "jack" "spring";
    "masses": "attached_mass" "attached_rotor" "rotor" "sliding_mass";
    "sensors": "acceleration_sensor" "force_sensor" "position_sensor" "velocity_sensor";
    "lines":
        "bristle_friction" "end_stop" "force_state_spring" "frame_axes" "shaft_ground" "shaft_spring" "slider_ground"
        "slider_spring" "slider_velocity" "torque_state_spring";
    "hydraulics":
        "chamber" "cylinder" "fluid" "oil_line" "oil_source" "oil_tank" "orifice" "piston" "servo_valve";
    "transmission":
        "belt" "belt_tensioner" "capstan" "chain" "elastic_belt" "elastic_rope" "fall" "gear" "gearbox"
        "lead_screw" "planetary" "rack" "rope" "winch" "worm";
    "drives":
        "brake" "clutch" "counterweight" "dc_motor" "drum_brake" "freewheel" "gas_spring" "motion" "motor_curve"
        "servo";
    "signals": "lag" "lag2" "pid" "ramps";
};

/// Name of each domain of the library and the text that defines it.
pub(crate) const DOMAINS: &[(&str, &str)] = catalogue! {
    "domains": "cable" "oil" "shaft" "slider";
};
