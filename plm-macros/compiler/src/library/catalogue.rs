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
    "forces": "force" "jack" "spring";
    "contact":
        "cam" "circle_on_circle" "circle_on_line" "circle_on_polyline" "geneva" "ground_profile" "latch" "lock"
        "oscillating_follower" "point_on_circle" "point_on_curve" "point_on_line" "point_on_polyline" "polygon_on_line" "ratchet"
        "rolling" "rolling_on_circle" "stop" "tyre" "wheel";
    "masses": "attached_mass" "attached_rotor" "rotor" "sliding_mass";
    "sensors": "acceleration_sensor" "force_sensor" "position_sensor" "velocity_sensor";
    "lines":
        "bristle_friction" "end_stop" "force_state_spring" "frame_axes" "shaft_ground" "shaft_spring"
        "shaft_velocity" "slider_ground" "slider_spring" "slider_velocity" "torque_state_spring";
    "hydraulics":
        "accumulator" "chamber" "check_valve" "counterbalance_valve" "cylinder" "flow_control" "fluid"
        "hydraulic_motor" "oil_line" "oil_source" "oil_tank" "orifice" "piston" "proportional_valve" "pump"
        "relief_valve" "servo_valve";
    "signals":
        "delay" "hysteresis" "lag" "lag2" "noise" "pid" "ramps" "rate_limit" "sampled_controller" "saturation";
    "pneumatics": "air_chamber" "air_cylinder" "air_orifice" "air_piston" "air_source";
    "transmission":
        "belt" "belt_tensioner" "capstan" "chain" "elastic_belt" "elastic_rope" "fall" "gear" "gearbox"
        "lead_screw" "planetary" "rack" "rope" "winch" "worm";
    "drives":
        "brake" "clutch" "counterweight" "dc_motor" "drum_brake" "freewheel" "gas_spring" "motion"
        "motor_curve" "servo" "torque_limiter";
};

/// Name of each domain of the library and the text that defines it.
pub(crate) const DOMAINS: &[(&str, &str)] = catalogue! {
    "domains": "air" "cable" "oil" "shaft" "slider";
};
