//! Parts of signals.

use plm::view::{Block, Symbol};

pub(super) fn blocks() -> Vec<Block> {
    vec![
        Block::new("force_sensor", Symbol::Text("gain (measured − offset)".into()))
            .input("x")
            .input("y")
            .input("torque")
            .output("signal"),
        Block::new("ramps", Symbol::Ramps).output("value"),
        Block::new("lag", Symbol::Lag).input("signal").output("value"),
        Block::new("lag2", Symbol::Swing).input("signal").output("value"),
        Block::new("sampled_controller", Symbol::Samples).input("error").output("value"),
        Block::new("delay", Symbol::Samples).input("signal").output("value"),
        Block::new("noise", Symbol::Samples).output("value"),
        Block::new("saturation", Symbol::Saturation).input("signal").output("value"),
        Block::new("rate_limit", Symbol::Ramps).input("signal").output("value").output("slope"),
        Block::new("hysteresis", Symbol::Hysteresis).input("signal").output("value").output("active"),
        Block::new("pid", Symbol::Text("P + I + D".into())).input("error").output("value"),
    ]
}
