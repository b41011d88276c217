//! What is read of a body is a copy: to set it would move nothing.

plm::mechanism! {
    pub Pendulum {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 1) m; }
        revolute hinge(ground.o, arm.o);
    }
}

fn main() -> Result<(), plm::Fault> {
    let mut sim = Pendulum::new().start()?;
    sim.arm().angle = 3.0;
    sim.step(1.0)
}
