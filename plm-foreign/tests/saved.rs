//! Saved runs go on to the bit; bytes that were changed are refused.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs, reason = "tests")]

use plm_foreign::{Foreign, Kind, Object, Status};

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

/// The bits of all outputs, and the time.
fn bits<M: Foreign>(object: &Object<M>) -> Vec<u64> {
    let outputs = (0..M::OBSERVED.len()).map(|k| object.get(Kind::Output, k).unwrap().to_bits());
    outputs.chain([object.time().unwrap().to_bits()]).collect()
}

fn saved<M: Foreign>(object: &Object<M>) -> Vec<u8> {
    let mut bytes = vec![0; object.saved_size()];
    object.save(&mut bytes).unwrap();
    bytes
}

/// At every tenth step the run is saved, and what was saved is stepped beside it from there on.
fn goes_on<M: Foreign>(declared: M, value: f64) -> [u64; 3] {
    let mut object = Object::new(declared);
    object.start().unwrap();
    let mut copy = object;
    for k in 0..300 {
        if k % 10 == 0 {
            copy = Object::saved(declared, &saved(&object)).unwrap();
        }
        for each in [&mut object, &mut copy] {
            match k {
                75 => each.set(Kind::Input, 0, value).unwrap(),
                155 => each.set(Kind::Parameter, 0, 1.5 * each.get(Kind::Parameter, 0).unwrap()).unwrap(),
                _ => {}
            }
            each.step(0.013).unwrap();
        }
        assert_eq!(bits(&object), bits(&copy), "step {k}");
        assert_eq!(saved(&object), saved(&copy), "step {k}");
    }
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
    let status = |bytes: &[u8]| Object::saved(Hopper::new(), bytes).err().map(|trouble| trouble.status());
    assert_eq!(status(&bytes), None);
    for place in 0..bytes.len() {
        let mut other = bytes.clone();
        other[place] ^= 1 << (place % 8);
        assert_eq!(status(&other), Some(Status::Damaged), "byte {place}");
        assert_eq!(status(&bytes[..place]), Some(Status::Damaged), "{place} bytes");
    }
    assert_eq!(status(&[bytes.clone(), vec![0; 8]].concat()), Some(Status::Damaged));
    let other = Object::saved(TripleRocker::new(), &bytes).err().map(|trouble| trouble.status());
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
