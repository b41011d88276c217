//! Scenes of machines and toys, each against a reference that was made another way.

mod one_body;
mod pins;
mod points;
