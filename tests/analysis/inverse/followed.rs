//! Runs under the forces of inverse dynamics follow their trajectories to the tolerance of the method, with friction and contact.

use std::f64::consts::PI;

use nalgebra::{SMatrix, SVector};
use plm::dynamic::{Compiled, Small};
use plm::inverse::{Inverse, Wanted};
use plm::runtime::described::by_number;
use plm::runtime::{Described, Mechanism, Ports};
use plm::{Dop853, Dopri5, Method, Moment, Rk4, Sim};

use super::linkages::{FIVE_BAR, FOUR_BAR, PRESS};

/// Coefficients of a force over a piece of time, which is a polynomial of s from -1 to 1.
const COUNT: usize = 12;
type State = <Small as Mechanism>::State;

/// A trajectory of a mechanism and the forces that are to follow it.
struct Case<const N: usize> {
    declaration: String,
    targets: [&'static str; N],
    drives: [&'static str; N],
    motion: fn(f64) -> [[f64; 3]; N],
    end: f64,
    pieces: usize,
}

impl<const N: usize> Case<N> {
    /// `text` has `+ @name@` after each drive.
    fn new(
        text: &str,
        (targets, drives): ([&'static str; N], [&'static str; N]),
        motion: fn(f64) -> [[f64; 3]; N],
        (end, pieces): (f64, usize),
    ) -> Self {
        let half = 0.5 * end / pieces as f64;
        let mut declaration = text.replacen(
            "input ",
            &format!("input at: s = 0; let share = (t - at)/({half:?} s) - 1; input "),
            1,
        );
        for name in drives {
            let unit = if declaration.contains(&format!("input {name}: N*m")) { "N*m" } else { "N" };
            let own: Vec<String> = (0..COUNT).map(|k| format!("input {name}{k}: {unit} = 0; ")).collect();
            let sum = (0..COUNT - 1)
                .rev()
                .fold(format!("{name}{}", COUNT - 1), |sum, k| format!("{name}{k} + share*({sum})"));
            declaration = declaration
                .replacen("input ", &format!("{}input ", own.concat()), 1)
                .replace(&format!("@{name}@"), &sum);
        }
        Self { declaration, targets, drives, motion, end, pieces }
    }

    fn wanted(&self, time: f64) -> Wanted<f64, N> {
        let of = |k: usize| (self.motion)(time).map(|numbers| numbers[k]);
        Wanted { place: of(0), velocity: of(1), acceleration: of(2) }
    }

    /// The coefficients of each force in each piece: polynomials through inverse dynamics at Chebyshev's extrema.
    fn forces(&self, start: &State) -> Vec<[SVector<f64, COUNT>; N]> {
        let inverse = Inverse::new(start.mechanism(), self.targets, self.drives).unwrap();
        let node = |k: usize| -(PI * k as f64 / (COUNT - 1) as f64).cos();
        let powers = SMatrix::<f64, COUNT, COUNT>::from_fn(|k, power| node(k).powi(power as i32));
        let solver = powers.lu();
        let length = self.end / self.pieces as f64;
        let times = (0..self.pieces)
            .flat_map(|piece| (0..COUNT).map(move |k| (piece as f64 + 0.5 * (1.0 + node(k))) * length));
        let mut found = Vec::new();
        inverse.over(start, times, |time| self.wanted(time), |_, inputs| found.push(inputs)).unwrap();
        let of = |values: &[[f64; N]]| {
            std::array::from_fn(|j| solver.solve(&SVector::from_fn(|k, _| values[k][j])).unwrap())
        };
        found.chunks(COUNT).map(of).collect()
    }

    /// The largest deviation from the trajectory at the ends of pieces.
    fn deviation<I: Method<Small> + Copy>(&self, method: I) -> f64 {
        let compiled = Compiled::new("followed.plm", &self.declaration).unwrap_or_else(|why| panic!("{why}"));
        let mechanism: Small = compiled.mechanism().unwrap();
        let mut sim = mechanism.start_with(method).unwrap();
        let forces = self.forces(sim.state());
        let length = self.end / self.pieces as f64;
        let mut worst = 0.0_f64;
        for (piece, force) in forces.iter().enumerate() {
            set(&mut sim, "at", piece as f64 * length);
            for (name, own) in self.drives.into_iter().zip(force) {
                (0..COUNT).for_each(|k| set(&mut sim, &format!("{name}{k}"), own[k]));
            }
            let until = (piece + 1) as f64 * length;
            sim.step_to(until).unwrap();
            for (name, wanted) in self.targets.into_iter().zip(self.wanted(until).place) {
                worst = worst.max((place(sim.state(), name) - wanted).abs());
            }
        }
        worst
    }

    /// Deviations fall with the tolerance of Dormand and Prince's method, below twice the tolerance, and by the fourth power of the step of
    /// Runge and Kutta's, down to what polynomials leave of the forces: a run of nearly no error has that alone.
    fn check(&self) {
        let left = self.deviation(Dop853::new(1e-13));
        assert!(left < 1e-8, "{left:e}");
        let tolerances = [1e-3, 1e-5, 1e-7, 1e-9];
        let found = tolerances.map(|tolerance| self.deviation(Dopri5::new(tolerance)));
        for (found, tolerance) in found.into_iter().zip(tolerances) {
            assert!(found < 2.0 * tolerance + left, "{found:e} at {tolerance:e}, {left:e} are left");
        }
        assert!(found[1] > 5.0 * found[2] && found[2] > 20.0 * found[3], "{found:?}");
        let step = 0.5 * self.end / self.pieces as f64;
        let [one, half, quarter] = [1.0, 0.5, 0.25].map(|part| self.deviation(Rk4::new(part * step)));
        for ratio in [one / half, half / quarter] {
            assert!((8.0..32.0).contains(&ratio), "{one:e} {half:e} {quarter:e}");
        }
    }
}

fn set<I: Method<Small>>(sim: &mut Sim<Small, I>, name: &str, value: f64) {
    let mut names = sim.state().mechanism().input_names().iter();
    let index = names.position(|(own, _)| *own == name).unwrap();
    assert!(by_number::set_input(sim, index, value));
}

fn place(state: &State, name: &str) -> f64 {
    let (body, coordinate) = name.split_once('.').unwrap();
    let body = state.mechanism().tables().bodies.iter().position(|own| own.name == body).unwrap();
    let pose = <Small as Described>::pose(state, body).unwrap();
    if coordinate == "angle" { pose.angle } else { pose.x }
}

/// With dry friction on the crank's pin, by its reaction.
#[test]
fn by_a_four_bar() {
    let text =
        FOUR_BAR.replace("drive: torque;", "drive: torque + @torque@; friction: 0.15; pin_diameter: 30 mm;");
    let motion = |t: f64| [[0.7 + 12.0 * t + 15.0 * t * t, 12.0 + 30.0 * t, 30.0]];
    Case::new(&text, (["crank.angle"], ["torque"]), motion, (0.24, 6)).check();
}

/// With dry friction of the guide and of the crank's pin, by their reactions.
#[test]
fn by_a_slider_crank() {
    let text = PRESS
        .replace("drive: torque;", "drive: torque + @torque@; friction: 0.15; pin_diameter: 40 mm;")
        .replace(
            "prismatic guide(ground.o, slider.end);",
            "prismatic guide(ground.o, slider.end) { friction: 0.2; }",
        );
    let motion = |t: f64| [[0.4 + 20.0 * t - 10.0 * t * t, 20.0 - 20.0 * t, -20.0]];
    Case::new(&text, (["crank.angle"], ["torque"]), motion, (0.12, 6)).check();
}

#[test]
fn by_a_five_bar() {
    let text = FIVE_BAR
        .replace("drive: left;", "drive: left + @left@;")
        .replace("drive: right;", "drive: right + @right@;");
    let motion = |t: f64| {
        let [left, right] = [120_f64, 60.0].map(f64::to_radians);
        [
            [left + 3.0 * t + 13.0 * t * t, 3.0 + 26.0 * t, 26.0],
            [right - 2.0 * t - 9.0 * t * t, -2.0 - 18.0 * t, -18.0],
        ]
    };
    Case::new(&text, (["left_arm.angle", "right_arm.angle"], ["left", "right"]), motion, (0.12, 4)).check();
}

/// A wheel that rolls on a floor, which pushes and grips.
#[test]
fn by_a_wheel_on_a_floor() {
    let text = "pub Rolls {
        gravity: 9.81 m/s^2;
        input pull: N = 0;
        ground { port o: (0, 0) m; }
        body wheel {
            mass: 2 kg; inertia: 0.3 kg*m^2; port hub: (0, 0) m;
            start x: 0.1 m, locked; start y: 0.5 m, locked; start vx: 0.3 m/s, locked; start omega: -0.6 rad/s, locked;
        }
        force spring(wheel.hub) { x: pull + @pull@ - (40 N/m)*sin(wheel.x/(1 m))*(1 m); }
        unilateral floor: wheel.y >= 0.5 m;
        friction grip: rate(wheel.x + (0.5 m)*wheel.angle) within 0.5*reaction(floor);
    }";
    let motion = |t: f64| {
        let (sin, cos) = (5.0 * t).sin_cos();
        [[0.1 + 0.3 * t + 0.2 * (1.0 - cos), 0.3 + sin, 5.0 * cos]]
    };
    Case::new(text, (["wheel.x"], ["pull"]), motion, (0.8, 4)).check();
}
