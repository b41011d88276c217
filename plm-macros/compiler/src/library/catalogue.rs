//! Catalogue of the library: a word for each file in `parts/`, by folder.

/// Names and texts of the files of the library.
macro_rules! catalogue {
    ($($folder:literal: $($name:literal)*;)*) => {
        &[$($(($name, include_str!(concat!("../../parts/", $folder, "/", $name, ".plm"))),)*)*]
    };
}

/// Name of each part of the library and the text that defines it.
pub(crate) const PARTS: &[(&str, &str)] = catalogue! {
    "joints": "pin_slot" "prismatic" "revolute" "weld";
    "forces": "force" "jack" "spring";
    "contact":
        "cam" "circle_on_circle" "circle_on_line" "circle_on_polyline" "geneva" "ground_profile" "point_on_circle"
        "point_on_curve" "point_on_line" "point_on_polyline" "polygon_on_line" "rolling" "rolling_on_circle"
        "tyre" "wheel";
    "masses": "attached_mass" "attached_rotor" "rotor" "sliding_mass";
    "sensors": "acceleration_sensor" "force_sensor" "position_sensor" "velocity_sensor";
    "lines":
        "end_stop" "force_state_spring" "frame_axes" "shaft_spring" "slider_ground" "slider_spring"
        "slider_velocity" "torque_state_spring";
    "hydraulics":
        "chamber" "cylinder" "fluid" "oil_line" "oil_source" "oil_tank" "orifice" "piston" "servo_valve";
    "signals": "lag" "lag2" "pid" "ramps";
};

/// Name of each domain of the library and the text that defines it.
pub(crate) const DOMAINS: &[(&str, &str)] = catalogue! {
    "domains": "oil" "shaft" "slider";
};
