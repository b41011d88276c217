//! Scenes of machines and toys, each against a reference that was made another way.

mod belts;
mod clearance;
mod clearance_steps;
mod compass;
mod impacts;
mod known;
mod limits;
mod one_body;
mod pins;
mod points;
mod reference;
mod shaken;
mod statics;
mod toys;
