//! Energy and power: what flows in, what is lost, what is stored.

use plm::{Fault, Mechanism, Moment as _, Sim};

use super::sheet::Sheet;

/// Relative tolerance of the runs.
pub const RTOL: f64 = 1e-10;

/// What a mechanism holds and exchanges at a moment.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ledger {
    /// Energy of motion, J.
    pub kinetic: f64,
    /// Energy of gravity, J.
    pub gravity: f64,
    /// Energy in springs, J.
    pub springs: f64,
    /// Power that springs take up, W: the rate of their energy.
    pub absorbed: f64,
    /// Power of drives, W.
    pub supplied: f64,
    /// Power that dampers take, W.
    pub lost: f64,
    /// Power of all forces and torques but gravity and reactions as the equations of motion have it, W.
    pub loads: f64,
}

/// What the ledger of a run leaves open.
#[derive(Clone, Copy, Debug, Default)]
pub struct Balance {
    /// Energy that is not accounted for, as a fraction of what moved.
    pub energy: f64,
    /// The largest power that is not accounted for, as a fraction of the largest that flowed.
    pub power: f64,
}

impl Balance {
    /// What the error of the integrator, kept to `RTOL` a step, may add up to.
    pub const ENERGY: f64 = 10.0 * RTOL;
    /// Rounding.
    pub const POWER: f64 = 1e-12;

    /// The worse of two runs.
    #[must_use]
    pub fn or_worse(self, other: Balance) -> Balance {
        let worse = |a: f64, b: f64| if a.abs() > b.abs() { a } else { b };
        Balance { energy: worse(self.energy, other.energy), power: worse(self.power, other.power) }
    }
}

impl Sheet {
    /// What the balance of energy and power leaves open.
    pub fn balance(&mut self, balance: Balance) {
        self.theory("power balance", balance.power, "of what flowed", 0.0, Balance::POWER);
        self.theory("energy balance", balance.energy, "of what moved", 0.0, Balance::ENERGY);
    }
}

impl Ledger {
    fn stored(&self) -> f64 {
        self.kinetic + self.gravity + self.springs
    }

    /// What the loads should be, less what they are.
    fn unexplained(&self) -> f64 {
        self.supplied - self.lost - self.absorbed - self.loads
    }

    fn flowing(&self) -> f64 {
        self.supplied.abs() + self.lost + self.absorbed.abs()
    }
}

/// Runs on for so many intervals of `every` (s), an even number, and balances the ledger: powers at every sample, energies by
/// Simpson's rule over the run.
pub fn run<M: Mechanism<S = f64>>(
    sim: &mut Sim<M>,
    (intervals, every): (u32, f64),
    ledger: impl Fn(&M::State) -> Ledger,
) -> Result<Balance, Fault> {
    let mut entries: Vec<Ledger> = Vec::new();
    let until = sim.state().time() + f64::from(intervals) * every;
    sim.run(until, every, |state| entries.push(ledger(state)))?;
    let largest = |of: fn(&Ledger) -> f64| entries.iter().map(of).fold(0.0, f64::max);
    let integral = |of: fn(&Ledger) -> f64| -> f64 {
        let threes = entries.windows(3).step_by(2);
        threes.map(|three| every / 3.0 * (of(&three[0]) + 4.0 * of(&three[1]) + of(&three[2]))).sum()
    };
    let stored = [entries.first(), entries.last()].map(|entry| entry.map_or(0.0, Ledger::stored));
    let open = stored[1] - stored[0] - integral(|entry| entry.supplied - entry.lost);
    let moved = largest(|entry| entry.kinetic) + integral(|entry| entry.supplied.abs() + entry.lost);
    let unexplained = largest(|entry| entry.unexplained().abs());
    Ok(Balance { energy: fraction(open, moved), power: fraction(unexplained, largest(Ledger::flowing)) })
}

/// Where nothing flows, nothing may be open.
fn fraction(open: f64, of: f64) -> f64 {
    if of > 0.0 { open / of } else { open }
}
