//! Which method `start_auto` takes, and what the explicit and the stiff method cost: `cargo run --release --features
//! analysis --example auto`.
//!
//! Times are the least of several runs, on whatever machine this is: compare them with each other.

use std::error::Error;
use std::time::Instant;

use plm::view::Arguments;
use plm::{Adams, Dop853, Fault, Method, RadauIia5, Sim, StartAuto, Vern9};

plm::mechanism! {
    /// A mass on a spring and a damper.
    Damped {
        param stiffness: N/m = 1e5 N/m;
        param damping: N*s/m = 1e4 N*s/m;
        ground { port rail: (0, 0) m; }
        body mass { mass: 1 kg; inertia: 1 kg*m^2; port slide: (0, 0) m; start x: 0.1 m, locked; }
        prismatic rail(ground.rail, mass.slide) { stiffness: stiffness; damping: damping; }
    }
}

plm::mechanism! {
    /// Four bars that hang on each other and swing; the last joint is as stiffly damped as is asked for.
    Chain {
        gravity: 9.81 m/s^2;
        param damping: N*m*s/rad = 0 N*m*s/rad;
        ground { port o: (0, 0) m; }
        repeat i in 0..4 {
            body bar[i] {
                mass: 1 kg;
                inertia: 0.1 kg*m^2;
                port a: (0, 0.5) m;
                port b: (0, -0.5) m;
                start angle: 30 deg, locked;
            }
        }
        revolute first(ground.o, bar[0].a);
        revolute second(bar[0].b, bar[1].a);
        revolute third(bar[1].b, bar[2].a);
        revolute last(bar[2].b, bar[3].a) { damping: damping; }
    }
}

plm::mechanism! {
    /// An arm on a jack whose chambers have lines to a closed valve (the manual's 3.2.1).
    Arm {
        gravity: 9.81 m/s^2;
        param bore: m^2 = pi/4*(0.05 m)^2;
        param annulus: m^2 = pi/4*((0.05 m)^2 - (0.03 m)^2);
        param bulk: Pa = 17000 bar;
        param conductance: m^3/s/Pa = 1e-11 m^3/s/Pa;
        ground { port o: (0, 0) m; port foot: (0, -0.25) m; }
        body arm {
            mass: 100 kg;
            inertia: 10 kg*m^2;
            port jack: (-0.5, 0) m;
            port pivot: (-0.8, 0) m;
            start angle: 20 deg, locked;
        }
        revolute pivot(ground.o, arm.pivot);
        jack ram(ground.foot, arm.jack) { free_length: 0.22 m; drive: p1*bore - p2*annulus; }
        state p1: Pa = 25 bar;
        state p2: Pa = 5 bar;
        state line1: Pa = 25 bar;
        state line2: Pa = 5 bar;
        let q1 = conductance*(line1 - p1);
        let q2 = conductance*(line2 - p2);
        rate p1 = bulk/(50e-6 m^3 + bore*ram.displacement)*(q1 - bore*ram.speed);
        rate p2 = bulk/(50e-6 m^3 + annulus*(0.35 m - ram.displacement))*(q2 + annulus*ram.speed);
        rate line1 = -bulk/0.5e-3 m^3*q1;
        rate line2 = -bulk/0.5e-3 m^3*q2;
    }
}

/// The least time of a run, us, and its evaluations.
fn cost<M, I>(start: impl Fn() -> Result<Sim<M, I>, Fault>, time: f64) -> Result<(f64, u64), Fault>
where
    M: plm::Mechanism + plm::System<S = f64>,
    I: Method<M>,
{
    let mut least = f64::INFINITY;
    let mut evaluations = 0;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 0.3 {
        let mut sim = start()?;
        let clock = Instant::now();
        sim.step(time)?;
        least = least.min(clock.elapsed().as_secs_f64());
        evaluations = sim.stats().evaluations;
    }
    Ok((1e6 * least, evaluations))
}

/// A row of the table.
fn compare<M: StartAuto>(name: &str, mechanism: M, time: f64, rtol: f64) -> Result<(), Fault> {
    let explicit = cost(|| mechanism.start_with(Dop853::new(rtol)), time)?;
    let ninth = cost(|| mechanism.start_with(Vern9::new(rtol)), time)?;
    let multistep = cost(|| mechanism.start_with(Adams::new(rtol)), time)?;
    let stiff = cost(|| mechanism.start_with(RadauIia5::new(rtol)), time)?;
    let auto = cost(|| mechanism.start_auto_with(rtol), time)?;
    let sim = mechanism.start_auto_with(rtol)?;
    let choice = sim.method().choice();
    let ratio = choice.pace.map_or(0.0, |pace| choice.decay / pace.rate());
    println!("{name}, {time} s, tolerance {rtol:e}, fastest decay to pace {ratio:.3}");
    println!("  DOP853 {:9.1} us ({} evaluations)", explicit.0, explicit.1);
    println!("  Vern9  {:9.1} us ({} evaluations)", ninth.0, ninth.1);
    println!("  Adams  {:9.1} us ({} evaluations)", multistep.0, multistep.1);
    println!("  Radau  {:9.1} us ({} evaluations)", stiff.0, stiff.1);
    println!("  auto   {:9.1} us: {}", auto.0, choice);
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    if let Some(help) = Arguments::from_args(&[])?.help() {
        println!("{help}");
        return Ok(());
    }
    for rtol in [1e-5, 1e-8, 1e-11] {
        for ratio in [10.0, 30.0, 100.0, 300.0, 1e3, 1e4] {
            // Roots -10 and -10 ratio.
            let (slow, fast) = (10.0, 10.0 * ratio);
            let damped = Damped { stiffness: slow * fast, damping: slow + fast, ..Damped::new() };
            compare(&format!("creep, ratio {ratio}"), damped, 0.3, rtol)?;
        }
        for damping in [0.0, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1e3] {
            let chain = Chain { damping, ..Chain::new() };
            compare(&format!("chain, damping {damping} N m s"), chain, 2.0, rtol)?;
        }
        for conductance in [1e-12, 1e-11, 1e-10, 1e-9, 1e-8] {
            let arm = Arm { conductance, ..Arm::new() };
            compare(&format!("arm, lines {conductance:e} m^3/s/Pa"), arm, 0.5, rtol)?;
        }
    }
    Ok(())
}
