//! Outputs of a driven mechanism whose bodies have no mass: motion can be read, forces cannot.

plm::mechanism! {
    pub Crank {
        ground { port o: (0, 0) m; }
        body crank { port o: (0, 0) m; port pin: (0.1, 0) m; }
        body bob { port pin: (0, 0.2) m; }
        revolute drive(ground.o, crank.o);
        revolute pin(crank.pin, bob.pin);
        constraint turns: crank.angle = 3 rad/s*t;
        constraint hangs: bob.angle = 0 rad;
        output bob.position, crank.alpha, torque = reaction(turns);
    }
}

fn main() -> Result<(), plm::Fault> {
    // Code that uses the mechanism is no mistake.
    let sim = Crank::new().start()?;
    println!("{}", sim.torque());
    Ok(())
}
