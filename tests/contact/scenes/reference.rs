//! References: two blocks on a shaken table, by the four cases of Coulomb's law.

/// Places and velocities of the lower and the upper block.
pub(crate) type Blocks = [f64; 4];

const G: f64 = 9.81;
/// Masses of the lower and the upper block, kg.
const MASS: [f64; 2] = [3.0, 2.0];

/// Two blocks on each other on a table with the place `amplitude sin(10 t)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shaken {
    pub(crate) amplitude: f64,
    pub(crate) rough_table: f64,
    pub(crate) rough_block: f64,
}

impl Shaken {
    fn table(&self, t: f64) -> [f64; 3] {
        let (sin, cos) = (10.0 * t).sin_cos();
        [self.amplitude * sin, 10.0 * self.amplitude * cos, -100.0 * self.amplitude * sin]
    }

    /// Accelerations, slips being `table` and `block`: -1, 0 or 1.
    fn accelerations(&self, t: f64, [table, block]: [f64; 2]) -> [f64; 2] {
        let [below, above] = [self.rough_table * G * (MASS[0] + MASS[1]), self.rough_block * G];
        let lower = if table == 0.0 {
            self.table(t)[2]
        } else if block == 0.0 {
            -table * below / (MASS[0] + MASS[1])
        } else {
            (-table * below + block * above * MASS[1]) / MASS[0]
        };
        [lower, if block == 0.0 { lower } else { -block * above }]
    }

    /// What sticks does so within its bound.
    fn is_possible(&self, t: f64, slips: [f64; 2]) -> bool {
        let [lower, upper] = self.accelerations(t, slips);
        let between = MASS[1] * upper;
        let table = MASS[0] * lower + between;
        (slips[1] != 0.0 || upper.abs() <= self.rough_block * G)
            && (slips[0] != 0.0 || table.abs() <= self.rough_table * G * (MASS[0] + MASS[1]))
    }

    /// Slips that are zero are those whose accelerations fit.
    fn slips(&self, t: f64, rates: [f64; 2]) -> [f64; 2] {
        let of = |rate: f64| if rate == 0.0 { vec![0.0, 1.0, -1.0] } else { vec![rate.signum()] };
        for table in of(rates[0]) {
            for block in of(rates[1]) {
                let slips = [table, block];
                let [lower, upper] = self.accelerations(t, slips);
                let rise = [lower - self.table(t)[2], upper - lower];
                let fits = (0..2).all(|i| {
                    rates[i] != 0.0 || slips[i] * rise[i] >= 0.0 && (slips[i] == 0.0 || rise[i] != 0.0)
                });
                if fits && self.is_possible(t, slips) {
                    return slips;
                }
            }
        }
        panic!("no case fits at {t}: {rates:?}");
    }

    /// Velocities and places after `h`: accelerations are constant, or that of the table.
    fn flow(&self, t: f64, h: f64, state: Blocks, slips: [f64; 2]) -> Blocks {
        let now = self.accelerations(t, slips);
        let (from, to) = (self.table(t), self.table(t + h));
        let [lower_table, upper_table] = [slips[0] == 0.0, slips[0] == 0.0 && slips[1] == 0.0];
        let moved = |i: usize, with_table: bool| {
            let (x, v) = (state[i], state[2 + i]);
            if with_table {
                (x + to[0] - from[0] + (v - from[1]) * h, v + to[1] - from[1])
            } else {
                (x + v * h + 0.5 * now[i] * h * h, v + now[i] * h)
            }
        };
        let (lower, upper) = (moved(0, lower_table), moved(1, upper_table));
        [lower.0, upper.0, lower.1, upper.1]
    }

    /// The state at `end`, from rest beside the table; events are bisected in steps of 0.1 ms.
    pub(crate) fn run(&self, end: f64) -> Blocks {
        let (mut t, mut state) = (0.0, [0.0; 4]);
        let rates = |t: f64, state: &Blocks| [state[2] - self.table(t)[1], state[3] - state[2]];
        let mut slips = self.slips(0.0, rates(0.0, &state).map(|r| if r.abs() < 1e-12 { 0.0 } else { r }));
        while t < end {
            let h = (end - t).min(1e-4);
            let holds = |h: f64| {
                let rate = rates(t + h, &self.flow(t, h, state, slips));
                (0..2).all(|i| slips[i] == 0.0 || slips[i] * rate[i] > 0.0) && self.is_possible(t + h, slips)
            };
            if h <= 1e-13 || holds(h) {
                state = self.flow(t, h, state, slips);
                t += h;
                continue;
            }
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let half = 0.5 * (low + high);
                *(if holds(half) { &mut low } else { &mut high }) = half;
            }
            state = self.flow(t, high, state, slips);
            t += high;
            let rate = rates(t, &state);
            let at_rest = core::array::from_fn(|i| {
                let ends = slips[i] == 0.0 || slips[i] * rate[i] <= 0.0 || rate[i].abs() < 1e-12;
                if ends { 0.0 } else { rate[i] }
            });
            slips = self.slips(t, at_rest);
        }
        state
    }
}
