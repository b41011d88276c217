//! Saved runs go on to the bit; bytes that were changed are refused.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs, reason = "tests")]

use plm::runtime::method::{Gauss, RadauIia5, Ros34Pw2};
use plm::runtime::{Scalar, StartValues};
use plm::{Adams, Dop853, Dopri5, Rk4, SemiImplicitEuler, Sim, Vern9};
use plm_foreign::{By, Either, Foreign, Kind, Object, ObjectBy, Run, Status};

plm::mechanism! {
    /// A loop no link of which goes round, so that each chart is flat somewhere; with a first-order state.
    TripleRocker {
        gravity: 9.81 m/s^2;
        param load: kg = 1 kg;
        input drive: N*m = 1 N*m;
        state lag: N*m = 0;
        rate lag = (drive - lag)/0.2 s;
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (-0.4, 0) m; port a: (0.4, 0) m; start angle: 60 deg, locked; start omega: 3 rad/s; }
        body coupler { mass: load; inertia: 0.1 kg*m^2; port a: (-0.3, 0) m; port b: (0.3, 0) m; start angle: -10 deg; }
        body rocker { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.35, 0) m; port b: (0.35, 0) m; start angle: 95 deg; }
        revolute a0(ground.o, crank.o) { drive: lag; }
        revolute a(crank.a, coupler.a);
        revolute b(coupler.b, rocker.b);
        revolute b0(ground.p, rocker.p) { damping: 0.1 N*m*s/rad; }
        output crank.angle, rocker.angle, b.force;
    }
}

plm::mechanism! {
    /// A loop that is flat at once in all its charts, twice a turn.
    Parallelogram {
        param load: kg = 1 kg;
        input drive: N*m = 0.1 N*m;
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port a: (0.1, 0) m; start angle: 60 deg, locked; start omega: 5 rad/s; }
        body coupler { mass: load; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 0 deg; }
        body rocker { mass: 1 kg; inertia: 0.02 kg*m^2; port p: (-0.1, 0) m; port b: (0.1, 0) m; start angle: 60 deg; }
        revolute a0(ground.o, crank.o) { drive: drive; }
        revolute a(crank.a, coupler.a);
        revolute b(coupler.b, rocker.b);
        revolute b0(ground.p, rocker.p);
        output crank.angle, rocker.angle, b0.force;
    }
}

plm::mechanism! {
    /// Known times and a condition that switches.
    Hopper {
        gravity: 9.81 m/s^2;
        param stiff: N/m = 5000 N/m;
        input push: N = 0 N;
        ground { port o: (0, 0) m, axis: 90 deg; }
        body ball { mass: 1 kg; inertia: 0.01 kg*m^2; port c: (0, 0) m; start y: 0.5 m, locked; }
        prismatic guide(ground.o, ball.c);
        force floor(ball.c) { y: if ball.y < 0.1 m then stiff*(0.1 m - ball.y) - 2 N*s/m*ball.vy else push; }
        force kick(ball.c) { y: if t > 0.37 s then 2 N else 0 N; }
        output ball.y, ball.vy;
    }
}

plm::mechanism! {
    /// It cannot be assembled as declared; with a reach of 1 m it can.
    Wide {
        allow(W0012);
        gravity: 9.81 m/s^2;
        param reach: m = 5 m;
        input drive: N*m = 0 N*m;
        ground { port o: (0, 0) m; port p: (reach, 0); }
        body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port pin: (0.2, 0) m; start angle: 80 deg, locked; }
        body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.9, 0) m; start angle: 20 deg; }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port pin: (0.6, 0) m; start angle: 70 deg; }
        revolute a(ground.o, crank.o) { drive: drive; }
        revolute b(crank.pin, coupler.a);
        revolute c(coupler.b, rocker.pin);
        revolute d(rocker.o, ground.p);
        output crank.angle, rocker.angle;
    }
}

/// The bits of all outputs, and the time.
fn bits<M: Foreign, R: Run<M>>(object: &ObjectBy<M, R>) -> Vec<u64> {
    let outputs = (0..M::OBSERVED.len()).map(|k| object.get(Kind::Output, k).unwrap());
    outputs.chain([object.time().unwrap()]).map(|number| number.to_f64().to_bits()).collect()
}

fn saved<M: Foreign, R: Run<M>>(object: &ObjectBy<M, R>) -> Vec<u8> {
    let mut bytes = vec![0; object.saved_size()];
    object.save(&mut bytes).unwrap();
    bytes
}

/// At every tenth step the run is saved, and what was saved is stepped beside it from there on. As a stranger it is restored
/// from a mechanism with no start at all.
fn goes_on_by<M: Foreign, R: Run<M>>(declared: M, value: f64, step: f64) -> ObjectBy<M, R> {
    let (mut object, mut stranger) = (ObjectBy::<M, R>::new(declared), declared);
    stranger.starts_mut().each(&mut |_, start| (start.value, start.locked) = (M::S::lit(f64::NAN), true));
    object.set_longest_step(M::S::lit(step)).unwrap();
    object.start().unwrap();
    let mut copy = object.clone();
    for k in 0..300 {
        if k % 10 == 0 {
            let bytes = saved(&object);
            copy = ObjectBy::saved(stranger, &bytes).unwrap();
            assert_eq!(saved(&copy), bytes, "step {k}");
        }
        for each in [&mut object, &mut copy] {
            match k {
                75 => each.set(Kind::Input, 0, M::S::lit(value)).unwrap(),
                155 => {
                    let now = each.get(Kind::Parameter, 0).unwrap();
                    each.set(Kind::Parameter, 0, M::S::lit(1.5) * now).unwrap();
                }
                _ => {}
            }
            each.step(M::S::lit(0.013)).unwrap();
        }
        assert_eq!(bits(&object), bits(&copy), "step {k}");
        assert_eq!(saved(&object), saved(&copy), "step {k}");
    }
    object
}

fn goes_on<M: Foreign>(declared: M, value: f64) -> [u64; 3] {
    let object: Object<M> = goes_on_by(declared, value, f64::INFINITY);
    let stats = object.sim().unwrap().stats();
    [stats.charts, stats.near_singular, stats.switches]
}

#[test]
fn a_saved_run_goes_on_to_the_bit() {
    let [charts, _, _] = goes_on(TripleRocker::new(), -2.0);
    let [_, near_singular, _] = goes_on(Parallelogram::new(), 0.3);
    let [_, _, switches] = goes_on(Hopper::new(), 1.0);
    assert!(charts > 2 && near_singular > 3 && switches > 5, "{charts} {near_singular} {switches}");
}

/// By every method; the loop changes charts, the ball switches.
#[test]
fn a_saved_run_of_every_method_goes_on_to_the_bit() {
    fn both<A, B>()
    where
        A: Run<TripleRocker>,
        B: Run<Hopper>,
    {
        goes_on_by::<_, A>(TripleRocker::new(), -2.0, 0.002);
        goes_on_by::<_, B>(Hopper::new(), 1.0, 0.002);
    }
    type On<M, I> = Sim<M, I>;
    both::<On<_, Vern9<_>>, On<_, Vern9<_>>>();
    both::<On<_, Adams<_>>, On<_, Adams<_>>>();
    both::<On<_, Dopri5<_>>, On<_, Dopri5<_>>>();
    both::<On<_, RadauIia5<_>>, On<_, RadauIia5<_>>>();
    both::<On<_, Rk4<_>>, On<_, Rk4<_>>>();
    both::<On<_, SemiImplicitEuler<_>>, On<_, SemiImplicitEuler<_>>>();
    both::<On<_, Gauss<_, 3>>, On<_, Gauss<_, 3>>>();
    both::<On<_, Ros34Pw2<_>>, On<_, Ros34Pw2<_>>>();
}

#[test]
fn a_saved_run_of_single_precision_goes_on_to_the_bit() {
    goes_on_by::<_, Sim<Hopper<f32>, Rk4<f32>>>(Hopper::<f32>::of(), 1.0, 0.002);
    goes_on_by::<_, Sim<TripleRocker<f32>, Dop853<_>>>(TripleRocker::<f32>::of(), -2.0, 0.01);
    let mut object = Object::new(Hopper::<f32>::of());
    object.start().unwrap();
    let other = Object::saved(Hopper::new(), &saved(&object)).err().map(|error| error.status());
    assert_eq!(other, Some(Status::OtherMechanism));
}

/// The declared mechanism is not started for it: this one cannot be.
#[test]
fn a_run_is_restored_where_the_declared_mechanism_cannot_be_assembled() {
    assert_eq!(Object::new(Wide::new()).start().unwrap_err().status(), Status::Assembly);
    let mut object = Object::new(Wide::new());
    object.set(Kind::Parameter, 0, 1.0).unwrap();
    let before = saved(&object);
    object.start().unwrap();
    object.step(0.1).unwrap();
    let mut again = Object::saved(Wide::new(), &saved(&object)).unwrap();
    for each in [&mut object, &mut again] {
        each.step(0.3).unwrap();
    }
    assert_eq!(bits(&object), bits(&again));
    again = Object::saved(Wide::new(), &before).unwrap();
    assert_eq!(again.step(0.1).unwrap_err().status(), Status::NotStarted);
    again.start().unwrap();
}

/// The same of an FMU.
#[cfg(feature = "fmi")]
#[test]
fn a_state_of_an_fmu_is_read_where_the_declared_mechanism_cannot_be_assembled() {
    use plm_foreign::fmi::{Call, Instance, Interface, Variable};
    let mut instance = Instance::new(Wide::new(), Interface::CoSimulation { has_events: false });
    let fresh = instance.clone();
    instance.set(Variable::Parameter(0), 1.0).unwrap();
    instance.pass(Call::EnterInitializationMode);
    instance.renew().unwrap();
    instance.pass(Call::ExitInitializationMode);
    instance.step_to(0.1, false).unwrap();
    let mut bytes = vec![0; instance.saved_size()];
    instance.save(&mut bytes).unwrap();
    let mut again = fresh.saved(&bytes).unwrap();
    let ends = [&mut instance, &mut again].map(|each| {
        each.step_to(0.4, false).unwrap();
        each.get(Variable::Output(0)).unwrap().to_bits()
    });
    assert_eq!(ends[0], ends[1]);
}

#[test]
fn a_run_is_restored_by_its_method_where_there_is_one() {
    type Two = Either<Sim<Hopper, Dop853<Hopper>>, Sim<Hopper, Rk4<f64>>>;
    let mut object = ObjectBy::<Hopper, Two>::new(Hopper::new());
    assert_eq!(object.set_method(By::Ros34Pw2).unwrap_err().status(), Status::Choice);
    object.set_method(By::Rk4).unwrap();
    object.set_longest_step(1e-3).unwrap();
    object.start().unwrap();
    object.step(0.2).unwrap();
    let mut again = ObjectBy::<Hopper, Two>::saved(Hopper::new(), &saved(&object)).unwrap();
    let other = Object::saved(Hopper::new(), &saved(&object)).err().map(|error| error.status());
    assert_eq!(other, Some(Status::OtherMechanism));
    for each in [&mut object, &mut again] {
        each.step(0.05).unwrap();
        each.set(Kind::Parameter, 0, 6000.0).unwrap();
        each.set_method(By::Dop853).unwrap();
        each.step(0.05).unwrap();
    }
    assert_eq!(bits(&object), bits(&again));
    object.set(Kind::Parameter, 0, 5000.0).unwrap();
}

#[test]
fn one_that_has_not_started_is_saved_as_it_is_set_up() {
    let mut object = Object::new(Hopper::new());
    object.set(Kind::Parameter, 0, 7000.0).unwrap();
    let mut again = Object::saved(Hopper::new(), &saved(&object)).unwrap();
    assert_eq!(again.step(0.1).unwrap_err().status(), Status::NotStarted);
    for each in [&mut object, &mut again] {
        each.start().unwrap();
        each.step(1.0).unwrap();
    }
    assert_eq!(bits(&object), bits(&again));
}

#[test]
fn bytes_that_were_changed_are_refused() {
    let mut object = Object::new(Hopper::new());
    object.start().unwrap();
    object.step(0.2).unwrap();
    let bytes = saved(&object);
    let status = |bytes: &[u8]| Object::saved(Hopper::new(), bytes).err().map(|error| error.status());
    assert_eq!(status(&bytes), None);
    for place in 0..bytes.len() {
        let mut other = bytes.clone();
        other[place] ^= 1 << (place % 8);
        assert_eq!(status(&other), Some(Status::Damaged), "byte {place}");
        assert_eq!(status(&bytes[..place]), Some(Status::Damaged), "{place} bytes");
    }
    assert_eq!(status(&[bytes.clone(), vec![0; 8]].concat()), Some(Status::Damaged));
    let other = Object::saved(TripleRocker::new(), &bytes).err().map(|error| error.status());
    assert_eq!(other, Some(Status::OtherMechanism));
    let (mut version, end) = (bytes.clone(), bytes.len() - 8);
    version[8] += 1;
    // FNV-1a of what is before the sum.
    let sum = version[..end]
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3));
    version[end..].copy_from_slice(&sum.to_le_bytes());
    assert_eq!(status(&version), Some(Status::OtherVersion));
    let mut room = vec![0; bytes.len() - 1];
    assert_eq!(object.save(&mut room).unwrap_err().status(), Status::Memory);
}
