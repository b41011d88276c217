//! rapier2d in double precision: rigid bodies with impulse joints, its defaults but for the step.

use std::time::Instant;

use rapier2d_f64::prelude::*;

use crate::{Peer, Run, Setting};

pub(crate) const PEERS: &[Peer] =
    &[peer("S1", double_pendulum), peer("S2", four_bar), peer("S6", slider_crank)];

const fn peer(scene: &'static str, run: fn(f64) -> Option<Run>) -> Peer {
    Peer { scene, name: "rapier2d", setting: Setting::Step, run }
}

/// A world of bodies without shapes.
struct World {
    physics: PhysicsWorld,
    ground: RigidBodyHandle,
    bodies: Vec<RigidBodyHandle>,
}

impl World {
    fn new(step: f64) -> Self {
        let mut physics = PhysicsWorld::new();
        physics.integration_parameters.dt = step;
        let ground = physics.bodies.insert(RigidBodyBuilder::fixed());
        Self { physics, ground, bodies: Vec::new() }
    }

    /// A body with G at its origin.
    fn body(&mut self, mass: f64, inertia: f64, [x, y]: [f64; 2], angle: f64) -> RigidBodyHandle {
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(x, y))
            .rotation(angle)
            .can_sleep(false)
            .additional_mass_properties(MassProperties::new(Vector::ZERO, mass, inertia));
        let body = self.physics.bodies.insert(body);
        self.bodies.push(body);
        body
    }

    fn pin(&mut self, a: RigidBodyHandle, at: [f64; 2], b: RigidBodyHandle, b_at: [f64; 2]) {
        let joint = RevoluteJointBuilder::new()
            .local_anchor1(Vector::new(at[0], at[1]))
            .local_anchor2(Vector::new(b_at[0], b_at[1]));
        self.physics.impulse_joints.insert(a, b, joint, true);
    }

    /// One second in steps of the world's size.
    fn run(mut self) -> Option<Run> {
        let steps = (1.0 / self.physics.integration_parameters.dt).round() as u64;
        let begin = Instant::now();
        for _ in 0..steps {
            self.physics.step();
        }
        let seconds = begin.elapsed().as_secs_f64();
        let places = self.bodies.iter().map(|&body| self.physics.bodies[body].translation());
        let measured: Vec<f64> = places.flat_map(|place| [place.x, place.y]).collect();
        let is_finite = measured.iter().copied().all(f64::is_finite);
        is_finite.then_some(Run { seconds, evaluations: steps, measured })
    }
}

fn double_pendulum(step: f64) -> Option<Run> {
    let mut world = World::new(step);
    let half = 0.5_f64.sqrt();
    let arm = world.body(10.0, 0.01, [0.5 * half, 0.5 * half], 45_f64.to_radians());
    let forearm = world.body(10.0, 0.01, [half + 1.0, half], 0.0);
    world.pin(world.ground, [0.0, 0.0], arm, [-0.5, 0.0]);
    world.pin(arm, [0.5, 0.0], forearm, [-1.0, 0.0]);
    world.run()
}

/// The poses at the start are those of the closed loop, to rounding.
fn four_bar(step: f64) -> Option<Run> {
    let mut world = World::new(step);
    let uniform = |length: f64| length * length * length / 12.0;
    let crank = world.body(0.3, uniform(0.3), [0.075, 0.129_903_810_567_665_78], 1.047_197_551_196_597_6);
    let coupler = world.body(
        0.9,
        uniform(0.9),
        [0.543_304_756_535_483_2, 0.478_465_729_804_011_8],
        0.507_400_508_542_062,
    );
    let rocker = world.body(
        0.7,
        uniform(0.7),
        [0.968_304_756_535_483_2, 0.348_561_919_236_346_05],
        1.661_478_397_548_722_2,
    );
    world.pin(world.ground, [0.0, 0.0], crank, [-0.15, 0.0]);
    world.pin(crank, [0.15, 0.0], coupler, [-0.45, 0.0]);
    world.pin(coupler, [0.45, 0.0], rocker, [0.35, 0.0]);
    world.pin(world.ground, [1.0, 0.0], rocker, [-0.35, 0.0]);
    world.run()
}

fn slider_crank(step: f64) -> Option<Run> {
    let mut world = World::new(step);
    let angle = 60_f64.to_radians();
    let (sin, cos) = angle.sin_cos();
    let rod_angle = -(0.2 * sin / 0.6).asin();
    let pin = [0.2 * cos, 0.2 * sin];
    let wrist = pin[0] + 0.6 * rod_angle.cos();
    let crank = world.body(0.2, 0.2 * 0.04 / 12.0, [0.5 * pin[0], 0.5 * pin[1]], angle);
    let rod = world.body(0.6, 0.018, [0.5 * (pin[0] + wrist), 0.5 * pin[1]], rod_angle);
    let slider = world.body(0.5, 0.001, [wrist, 0.0], 0.0);
    world.pin(world.ground, [0.0, 0.0], crank, [-0.1, 0.0]);
    world.pin(crank, [0.1, 0.0], rod, [-0.3, 0.0]);
    world.pin(rod, [0.3, 0.0], slider, [0.0, 0.0]);
    let guide = PrismaticJointBuilder::new(Vector::X);
    world.physics.impulse_joints.insert(world.ground, slider, guide, true);
    // A torque that is added stays until it is reset.
    world.physics.bodies[crank].add_torque(1.0, true);
    world.run()
}
