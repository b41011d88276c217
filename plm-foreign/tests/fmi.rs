//! What a simulator does with an instance, right and wrong, in Rust.
#![cfg(feature = "fmi")]
#![allow(
    unsafe_code,
    clippy::undocumented_unsafe_blocks,
    clippy::unwrap_used,
    missing_docs,
    reason = "tests"
)]

use std::ffi::CString;
use std::mem::MaybeUninit;
use std::ptr::null_mut;

use plm::Moment;
use plm_foreign::fmi::{Call, Instance, Interface, Variable, border, token};

plm::mechanism! {
    /// A shaft on a spring, which a torque turns round.
    Shaft {
        input drive: N*m = 2 N*m;
        ground { port o: (0, 0) m; }
        body disc { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; start omega: 5 rad/s, locked; }
        revolute bearing(ground.o, disc.o) { stiffness: 0.01 N*m/rad; drive: drive; }
        output disc.angle, bearing.torque;
    }
}

const OK: i32 = 0;
const ERROR: i32 = 3;
const CO_SIMULATION: Interface = Interface::CoSimulation { has_events: false };

fn references(wanted: impl Fn(Variable) -> bool) -> Vec<u32> {
    let all = (0..).map_while(|k| Variable::of(&Shaft::new(), k).map(|variable| (k, variable)));
    all.filter(|(_, variable)| wanted(*variable)).map(|(k, _)| k).collect()
}

/// An importer gives arrays that have no values yet, and is told where a pointer is missing before anything is done.
#[test]
fn rooms_need_no_values_and_wrong_calls_change_nothing() {
    let own = CString::new(token::<Shaft>().as_str()).unwrap();
    let handle = unsafe {
        border::instantiate(Shaft::new(), own.as_ptr(), (CO_SIMULATION, false), (None, null_mut()))
    };
    let angle = references(|variable| variable == Variable::Output(0));
    let mut room = [MaybeUninit::<f64>::uninit(); 1];
    let get = |room: &mut [MaybeUninit<f64>; 1]| unsafe {
        assert_eq!(border::get(handle, (angle.as_ptr(), 1), (room.as_mut_ptr().cast(), 1)), OK);
        room[0].assume_init()
    };
    let (mut flag, mut last) = (true, f64::NAN);
    let flags = [&raw mut flag; 3];
    unsafe {
        assert_eq!(border::with(handle, None, |instance| instance.begin_at(f64::NAN)), ERROR);
        assert_eq!(border::with(handle, Call::EnterInitializationMode, |_| Ok(())), OK);
        assert_eq!(border::with(handle, Call::ExitInitializationMode, Instance::renew), OK);
        let before = get(&mut room);
        assert_eq!(
            border::do_step(handle, (0.0, 0.5), [flags[0], null_mut(), flags[2]], &raw mut last),
            ERROR
        );
        assert_eq!(border::do_step(handle, (0.0, 0.5), flags, null_mut()), ERROR);
        assert_eq!(border::get(handle, (angle.as_ptr(), 1), (null_mut(), 1)), ERROR);
        assert_eq!(get(&mut room).to_bits(), before.to_bits());
        assert_eq!(border::do_step(handle, (0.0, 0.5), flags, &raw mut last), OK);
        assert!(get(&mut room) > before && last == 0.5 && !flag);
        border::free(handle);
    }
}

/// Memory that is no instance, whatever is in it.
#[test]
fn other_memory_is_no_instance() {
    let mut memory = MaybeUninit::<border::Handle<Shaft>>::uninit();
    let (mut flag, mut last) = (true, f64::NAN);
    unsafe {
        memory.as_mut_ptr().cast::<u8>().write_bytes(0xff, size_of_val(&memory));
        let flags = [&raw mut flag; 3];
        assert_eq!(border::with(memory.as_mut_ptr(), None, |_| Ok(())), ERROR);
        assert_eq!(border::do_step(memory.as_mut_ptr(), (0.0, 0.5), flags, &raw mut last), ERROR);
    }
}

/// A solver outside integrates the bare states, which are brought back by whole turns at events; outputs read all turns.
#[test]
fn a_solver_outside_sees_all_turns() {
    let mut instance = Instance::new(Shaft::new(), Interface::ModelExchange);
    instance.renew().unwrap();
    instance.pass(Call::ExitInitializationMode);
    let (h, mut turned) = (1e-3, 0);
    for k in 0..4000 {
        // The midpoint rule.
        let (x, rate) = (*instance.state().unwrap().x(), instance.rates().unwrap());
        let at = |x: [f64; 2], rate: [f64; 2], h: f64| [x[0] + h * rate[0], x[1] + h * rate[1]];
        instance.place(None, Some(at(x, rate, 0.5 * h))).unwrap();
        let middle = instance.rates().unwrap();
        instance.place(Some(h * f64::from(k + 1)), Some(at(x, middle, h))).unwrap();
        if instance.accept().unwrap() {
            turned += u32::from(instance.update().unwrap().states_changed);
        }
    }
    // theta'' = (2 - 0.01 theta)/0.1 with theta(0) = 0, theta'(0) = 5.
    let (w, t) = (f64::sqrt(0.1), 4.0);
    let expected = 200.0 * (1.0 - f64::cos(w * t)) + 5.0 / w * f64::sin(w * t);
    let angle = instance.get(Variable::Output(0)).unwrap();
    // The rule is off by some h^2 w^3 of what has turned.
    assert!((angle - expected).abs() < 1e-3, "{angle} {expected}");
    assert!((instance.get(Variable::Output(1)).unwrap().abs() - (2.0 - 0.01 * angle).abs()).abs() < 1e-12);
    assert!(turned > 10 && instance.state().unwrap().x()[0].abs() < 5.0, "{turned}");
}
