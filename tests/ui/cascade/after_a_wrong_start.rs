//! Code that uses a mechanism with a wrong start adds no errors to it.

plm::mechanism! {
    pub Crane {
        gravity: 9.81 m/s^2;
        param reach: m = 1 m;
        input lift: N = 100 N;
        ground { port o: (0, 0) m; }
        body boom {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port o: (0, 0) m;
            port tip: (1, 0) m;
            start angle: 30 deg, locked;
            start x: 1 m, locked;
        }
        revolute foot(ground.o, boom.o);
        force hook(boom.tip) { y: lift*reach/(1 m); }
        output foot.force, boom.angle in deg, tip = boom.tip.position;
    }
}

fn main() -> Result<(), plm::Fault> {
    let mut sim = Crane { reach: 2.0, ..Crane::new() }.start()?;
    sim.input.lift = 200.0;
    sim.step(0.1)?;
    let height: f64 = sim.boom().y + sim.tip()[1];
    let [x, y] = sim.foot_force();
    sim.run(1.0, 0.1, |state| println!("{} {:?}", state.boom_angle(), state.outputs()))?;
    let steps: u64 = sim.stats().steps;
    println!("{height} {x} {y} {steps} {}", sim.kinetic_energy());
    let mut other = Crane::new();
    other.start.boom.angle = plm::Start::locked(0.1);
    let mut coarse = other.start_with(plm::Rk4::new(1e-3))?;
    coarse.step(0.1)
}
