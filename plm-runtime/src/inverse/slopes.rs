//! Targets at a moment, and their derivatives by the inputs.

/// Wanted quantities at a moment: accelerations, rates or values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Evaluated<S, const TARGETS: usize, const DRIVES: usize> {
    pub(super) values: [S; TARGETS],
    /// Of each target its derivatives by the inputs.
    pub(super) slopes: [[S; DRIVES]; TARGETS],
    /// Of each input its largest effect on a rate of the state.
    pub(super) scales: [S; DRIVES],
}
