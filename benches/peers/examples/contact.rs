//! rapier2d in double precision on the scenes with contact, as rows of docs/src/images/contact-peers/runs.csv.
//!
//! ```sh
//! cargo run --release --manifest-path benches/peers/Cargo.toml --features rapier --example contact > target/plm/contact-rapier.csv
//! ```
//!
//! Two sets of settings. `defaults`: its defaults but for the step. `tight`: 50 iterations, no allowed penetration. No body sleeps.
//! The dry friction of oscillator and slider-crank is a motor of the guide, with no speed and a largest force.
#![allow(
    clippy::unwrap_used,
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    missing_docs,
    reason = "a program that measures"
)]

#[path = "../../../tests/oracle/speed/src/contact_runs/clock.rs"]
mod clock;

use rapier2d_f64::prelude::*;

const GRAVITY: f64 = 9.81;
const STEPS: [f64; 5] = [1e-2, 4e-3, 1e-3, 4e-4, 1e-4];
/// A motor of this factor reaches its speed within a step, if its force does.
const RIGID: f64 = 1e9;

/// A world and the body that is measured.
struct World {
    physics: PhysicsWorld,
    body: RigidBodyHandle,
    steps: u64,
}

#[derive(Clone, Copy)]
struct Settings {
    name: &'static str,
    step: f64,
}

fn reference(scene: &str, name: &str) -> f64 {
    let table = include_str!("../../data/contact.csv");
    let key = format!("{scene},{name},");
    table.lines().find_map(|row| row.strip_prefix(&key)).unwrap().parse().unwrap()
}

impl World {
    fn new(settings: Settings, gravity: f64) -> Self {
        let mut physics = PhysicsWorld::new();
        physics.gravity = Vector::new(0.0, -gravity);
        let parameters = &mut physics.integration_parameters;
        parameters.dt = settings.step;
        if settings.name == "tight" {
            parameters.num_solver_iterations = 50;
            parameters.normalized_allowed_linear_error = 0.0;
        }
        let body = physics.bodies.insert(RigidBodyBuilder::fixed());
        Self { physics, body, steps: 0 }
    }

    fn body(&mut self, (mass, inertia): (f64, f64), [x, y]: [f64; 2], angle: f64) -> RigidBodyHandle {
        let builder =
            RigidBodyBuilder::dynamic().translation(Vector::new(x, y)).rotation(angle).can_sleep(false);
        let properties = MassProperties::new(Vector::ZERO, mass, inertia);
        self.physics.bodies.insert(builder.additional_mass_properties(properties))
    }

    fn shape(&mut self, body: RigidBodyHandle, shape: ColliderBuilder, friction: f64, restitution: f64) {
        let shape = shape.density(0.0).friction(friction).restitution(restitution);
        self.physics.colliders.insert_with_parent(shape, body, &mut self.physics.bodies);
    }

    fn floor(&mut self, friction: f64, restitution: f64) -> RigidBodyHandle {
        let ground = self.physics.bodies.insert(RigidBodyBuilder::fixed());
        let shape = ColliderBuilder::cuboid(500.0, 1.0).translation(Vector::new(0.0, -1.0));
        self.shape(ground, shape, friction, restitution);
        ground
    }

    fn pin(&mut self, a: RigidBodyHandle, at: f64, b: RigidBodyHandle, b_at: f64) {
        let joint = RevoluteJointBuilder::new()
            .local_anchor1(Vector::new(at, 0.0))
            .local_anchor2(Vector::new(b_at, 0.0))
            .contacts_enabled(false);
        self.physics.impulse_joints.insert(a, b, joint, true);
    }

    /// A guide along x with dry friction.
    fn guide(&mut self, body: RigidBodyHandle, friction: f64) {
        let ground = self.physics.bodies.insert(RigidBodyBuilder::fixed());
        let guide =
            PrismaticJointBuilder::new(Vector::X).motor_velocity(0.0, RIGID).motor_max_force(friction);
        self.physics.impulse_joints.insert(ground, body, guide, true);
    }

    fn step_to(&mut self, time: f64) {
        let until = (time / self.physics.integration_parameters.dt).round() as u64;
        while self.steps < until {
            self.physics.step();
            self.steps += 1;
        }
    }

    /// `x`, `y` and angle of the body.
    fn place(&self) -> [f64; 3] {
        let body = &self.physics.bodies[self.body];
        [body.translation().x, body.translation().y, body.rotation().angle()]
    }
}

fn row(scene: &str, settings: Settings, error: f64, (seconds, until): (f64, f64), creep: f64, gain: f64) {
    let number = |value: f64| if value.is_finite() { format!("{value:.3e}") } else { String::new() };
    let Settings { name, step } = settings;
    let steps = (until / step).round();
    println!(
        "{scene},Rapier2D,{name},{step:.0e},{},{seconds:.3e},{steps},{},{}",
        number(error),
        number(creep),
        number(gain)
    );
}

/// A box that rests on its lower side, or on its right corner.
fn block(settings: Settings, half: [f64; 2], friction: f64, tilt: f64) -> World {
    let mut world = World::new(settings, GRAVITY);
    world.floor(friction, 0.0);
    let ([b, h], (sin, cos)) = (half, tilt.sin_cos());
    let inertia = (b * b + h * h) / 3.0;
    world.body = world.body((1.0, inertia), [-b * cos + h * sin, b * sin + h * cos], -tilt);
    world.shape(world.body, ColliderBuilder::cuboid(b, h), friction, 0.0);
    world
}

fn pushed(settings: Settings, until: f64) {
    let start = || {
        let mut world = block(settings, [0.1, 0.1], 0.3, 0.0);
        world.physics.bodies[world.body].add_force(Vector::new(0.99 * 0.3 * GRAVITY, 0.0), true);
        world
    };
    let mut world = start();
    world.step_to(0.5 * until);
    let half = world.place()[0];
    world.step_to(until);
    let end = world.place()[0];
    let seconds = clock::seconds(|| start().step_to(until));
    row("block", settings, (end + 0.1).abs(), (seconds, until), 2e6 * (end - half).abs() / until, f64::NAN);
}

fn oscillator(settings: Settings) {
    let start = || {
        let mut world = World::new(settings, 0.0);
        world.body = world.body((1.0, 1.0), [0.1, 0.0], 0.0);
        world.guide(world.body, 0.981);
        world
    };
    let run = |world: &mut World, time: f64| {
        let until = (time / settings.step).round() as u64;
        while world.steps < until {
            let x = world.place()[0];
            let body = &mut world.physics.bodies[world.body];
            body.reset_forces(true);
            body.add_force(Vector::new(-100.0 * x, 0.0), true);
            world.physics.step();
            world.steps += 1;
        }
    };
    let mut world = start();
    run(&mut world, 2.0);
    let rest = world.place()[0];
    run(&mut world, 12.0);
    let creep = 1e5 * (world.place()[0] - rest).abs();
    let seconds = clock::seconds(|| run(&mut start(), 2.0));
    row("oscillator", settings, (rest - reference("oscillator", "x")).abs(), (seconds, 2.0), creep, f64::NAN);
}

/// Maxima after the start. What rises or falls by less than 2 % of the start is noise.
fn peaks(values: &[f64]) -> Vec<f64> {
    let (mut found, mut falls, mut extreme) = (Vec::new(), true, values[0]);
    for &value in values {
        if falls == (value < extreme) {
            extreme = value;
        } else if (value - extreme).abs() > 0.02 * values[0] {
            if !falls {
                found.push(extreme);
            }
            (falls, extreme) = (!falls, value);
        }
    }
    found
}

/// The deviation that is largest by its amount of an energy from `ratio` times the one before it.
fn gain(energies: &[f64], ratio: f64) -> f64 {
    let gains = energies.windows(2).map(|pair| pair[1] / (ratio * pair[0]) - 1.0);
    gains.fold(0.0, |most: f64, gain| if gain.abs() > most.abs() { gain } else { most })
}

fn ball(settings: Settings) {
    let start = || {
        let mut world = World::new(settings, GRAVITY);
        world.floor(0.0, 0.8);
        world.body = world.body((1.0, 0.004), [0.0, 1.1], 0.0);
        world.shape(world.body, ColliderBuilder::ball(0.1), 0.0, 0.8);
        world
    };
    let mut world = start();
    let mut heights = vec![1.0];
    for k in 1..=(3.0 / settings.step).round() as u64 {
        world.step_to(k as f64 * settings.step);
        heights.push(world.place()[1] - 0.1);
    }
    let error = (heights[heights.len() - 1] - reference("ball", "y")).abs();
    let tops: Vec<f64> = [1.0].into_iter().chain(peaks(&heights).into_iter().take(5)).collect();
    let seconds = clock::seconds(|| start().step_to(3.0));
    row("ball", settings, error, (seconds, 3.0), f64::NAN, gain(&tops, 0.64));
}

fn rocking(settings: Settings) {
    let alpha = 0.2_f64.atan();
    let start = || block(settings, [0.1, 0.5], 1.0, 0.5 * alpha);
    let mut world = start();
    let mut angles = vec![0.5 * alpha];
    for k in 1..=(2.2 / settings.step).round() as u64 {
        world.step_to(k as f64 * settings.step);
        angles.push(world.place()[2].abs());
    }
    let error = (angles[(1.2 / settings.step).round() as usize] - reference("rocking", "angle")).abs();
    let rise = |angle: &f64| (alpha - angle).cos() - alpha.cos();
    let tops: Vec<f64> = [0.5 * alpha].iter().chain(peaks(&angles).iter().take(3)).map(rise).collect();
    let seconds = clock::seconds(|| start().step_to(1.2));
    row(
        "rocking",
        settings,
        error,
        (seconds, 1.2),
        f64::NAN,
        gain(&tops, reference("rocking", "energy_ratio")),
    );
}

fn crank(settings: Settings) {
    let (phi, omega) = (1.0_f64, 20.0);
    let rod = -(phi.sin() / 3.0).asin();
    let turn = -phi.cos() / (3.0 * rod.cos()) * omega;
    let (pin, pin_rate) =
        ([0.1 * phi.cos(), 0.1 * phi.sin()], [-0.1 * omega * phi.sin(), 0.1 * omega * phi.cos()]);
    let start = || {
        let mut world = World::new(settings, 0.0);
        let ground = world.body;
        let crank = world.body((1.0, 0.02), [0.0; 2], phi);
        let coupler = world.body((0.5, 0.5 * 0.09 / 12.0), [pin[0] + 0.15 * rod.cos(), 0.5 * pin[1]], rod);
        let slider = world.body((2.0, 0.01), [pin[0] + 0.3 * rod.cos(), 0.0], 0.0);
        world.pin(ground, 0.0, crank, 0.0);
        world.pin(crank, 0.1, coupler, -0.15);
        world.pin(coupler, 0.15, slider, 0.0);
        world.guide(slider, 3.0);
        let bodies = &mut world.physics.bodies;
        bodies[crank].set_angvel(omega, true);
        bodies[coupler].set_angvel(turn, true);
        let along = pin_rate[0] - 0.15 * turn * rod.sin();
        bodies[coupler].set_linvel(Vector::new(along, 0.5 * pin_rate[1]), true);
        bodies[slider].set_linvel(Vector::new(pin_rate[0] - 0.3 * turn * rod.sin(), 0.0), true);
        world.body = crank;
        world
    };
    let mut world = start();
    let (mut angle, mut last) = (phi, phi);
    for k in 1..=(1.0 / settings.step).round() as u64 {
        world.step_to(k as f64 * settings.step);
        let now = world.place()[2];
        let turned = now - last;
        angle += turned - std::f64::consts::TAU * (turned / std::f64::consts::TAU).round();
        last = now;
    }
    let seconds = clock::seconds(|| start().step_to(1.0));
    row(
        "slider-crank",
        settings,
        (angle - reference("slider-crank", "angle")).abs(),
        (seconds, 1.0),
        f64::NAN,
        f64::NAN,
    );
}

/// All runs, or those with settings and a step that are named: `-- tight 1e-4`.
fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_wanted = |name: &str| arguments.first().is_none_or(|wanted| wanted == name);
    let is_step = |step: f64| arguments.get(1).is_none_or(|wanted| wanted.parse() == Ok(step));
    for name in ["defaults", "tight"].into_iter().filter(|name| is_wanted(name)) {
        for step in STEPS.into_iter().filter(|step| is_step(*step)) {
            let settings = Settings { name, step };
            ball(settings);
            rocking(settings);
            crank(settings);
            oscillator(settings);
            pushed(settings, 60.0);
        }
    }
    if arguments.is_empty() {
        pushed(Settings { name: "defaults", step: 1e-2 }, 3600.0);
    }
}
