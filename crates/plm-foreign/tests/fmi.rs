//! What a simulator does with an instance, right and wrong, in Rust.
#![cfg(feature = "fmi")]
#![allow(
    unsafe_code,
    clippy::undocumented_unsafe_blocks,
    clippy::unwrap_used,
    missing_docs,
    reason = "tests"
)]

use std::ffi::{CStr, CString, c_char, c_void};
use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};

use plm::Moment;
use plm_foreign::fmi::{Call, Instance, Interface, Steps, Variable, Version, ffi, token};

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

plm::mechanism! {
    /// Two rockers, of which neither turns round.
    Rockers {
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.05 kg*m^2; port a: (0, 0) m; port b: (0.8, 0) m; start angle: 60 deg, locked; start omega: 1 rad/s; }
        body coupler { mass: 1 kg; inertia: 0.05 kg*m^2; port b: (0, 0) m; port c: (0.5, 0) m; start angle: 0 deg; }
        body rocker { mass: 1 kg; inertia: 0.05 kg*m^2; port d: (0, 0) m; port c: (0.6, 0) m; start angle: 95 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(rocker.d, ground.d);
        output rocker.angle;
    }
}

const OK: i32 = 0;
const DISCARD: i32 = 2;
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
        let listener = ffi::Listener::three(None, null_mut());
        ffi::instantiate((Shaft::new(), Steps::none()), own.as_ptr(), (CO_SIMULATION, false), listener)
    };
    let angle = references(|variable| variable == Variable::Output(0));
    let mut room = [MaybeUninit::<f64>::uninit(); 1];
    let get = |room: &mut [MaybeUninit<f64>; 1]| unsafe {
        assert_eq!(ffi::get(handle, (angle.as_ptr(), 1), (room.as_mut_ptr().cast(), 1)), OK);
        room[0].assume_init()
    };
    let (mut flag, mut last) = (true, f64::NAN);
    let flags = [&raw mut flag; 3];
    unsafe {
        assert_eq!(ffi::with(handle, None, |instance| instance.begin_at(f64::NAN, None)), ERROR);
        assert_eq!(ffi::with(handle, Call::EnterInitializationMode, |_| Ok(())), OK);
        assert_eq!(ffi::with(handle, Call::ExitInitializationMode, Instance::renew), OK);
        let before = get(&mut room);
        assert_eq!(ffi::do_step(handle, (0.0, 0.5), [flags[0], null_mut(), flags[2]], &raw mut last), ERROR);
        assert_eq!(ffi::do_step(handle, (0.0, 0.5), flags, null_mut()), ERROR);
        assert_eq!(ffi::get(handle, (angle.as_ptr(), 1), (null_mut(), 1)), ERROR);
        assert_eq!(get(&mut room).to_bits(), before.to_bits());
        assert_eq!(ffi::do_step(handle, (0.0, 0.5), flags, &raw mut last), OK);
        assert!(get(&mut room) > before && last == 0.5 && !flag);
        ffi::free(handle);
    }
}

/// Memory that is no instance, whatever is in it.
#[test]
fn other_memory_is_no_instance() {
    let mut memory = MaybeUninit::<ffi::Handle<Shaft>>::uninit();
    let (mut flag, mut last) = (true, f64::NAN);
    unsafe {
        memory.as_mut_ptr().cast::<u8>().write_bytes(0xff, size_of_val(&memory));
        let flags = [&raw mut flag; 3];
        assert_eq!(ffi::with(memory.as_mut_ptr(), None, |_| Ok(())), ERROR);
        assert_eq!(ffi::do_step(memory.as_mut_ptr(), (0.0, 0.5), flags, &raw mut last), ERROR);
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

/// Behind pointers a method is set by its number as a whole number, and as nothing else.
#[test]
fn a_simulator_sets_a_method_by_its_number() {
    let own = CString::new(token::<Shaft>().as_str()).unwrap();
    let method = references(|variable| variable == Variable::Method);
    let step = references(|variable| variable == Variable::Step);
    let (method, step) = ((method.as_ptr(), 1), (step.as_ptr(), 1));
    let (mut number, mut real) = (0_i32, 0.0);
    unsafe {
        let listener = ffi::Listener::three(None, null_mut());
        let handle =
            ffi::instantiate((Shaft::new(), Steps::none()), own.as_ptr(), (CO_SIMULATION, false), listener);
        assert_eq!(ffi::set_integers(handle, method, ([3_i32].as_ptr(), 1)), OK);
        // A step that is not emitted.
        assert_eq!(ffi::set_integers(handle, method, ([6_i64].as_ptr(), 1)), ERROR);
        assert_eq!(ffi::set_integers(handle, step, ([3_i32].as_ptr(), 1)), ERROR);
        assert_eq!(ffi::set_integers::<Shaft, i64>(handle, method, (null(), 1)), ERROR);
        assert_eq!(ffi::set_integers::<Shaft, i64>(handle, method, (null(), 0)), ERROR);
        assert_eq!(ffi::get_integers(handle, method, (&raw mut number, 1)), OK);
        assert_eq!(ffi::get_integers::<Shaft, i64>(handle, method, (null_mut(), 1)), ERROR);
        assert_eq!(ffi::get(handle, method, (&raw mut real, 1)), ERROR);
        assert_eq!(ffi::get(handle, step, (&raw mut real, 1)), OK);
        ffi::free(handle);
    }
    assert_eq!((number, real), (3, 1e-3));
}

/// What a simulator heard: status, category, message.
type Heard = Vec<(i32, String, String)>;

unsafe extern "C" fn hear(heard: *mut c_void, status: i32, category: *const c_char, message: *const c_char) {
    let text = |at| unsafe { CStr::from_ptr(at) }.to_str().unwrap().to_owned();
    unsafe { &mut *heard.cast::<Heard>() }.push((status, text(category), text(message)));
}

/// A solver's step that leads to where a loop cannot be closed is discarded, with the cause; a shorter one from where it was goes on
/// as if nothing had been.
#[test]
fn a_step_that_is_too_long_is_discarded_and_a_shorter_one_goes_on() {
    let own = CString::new(token::<Rockers>().as_str()).unwrap();
    for version in [Version::Two, Version::Three] {
        let mut heard = Heard::new();
        let listener = match version {
            Version::Two => ffi::Listener::two(None, null_mut(), c"rockers"),
            Version::Three => ffi::Listener::three(Some(hear), (&raw mut heard).cast()),
        };
        let (mut x, mut rates, mut again) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        let (mut event, mut ends) = (true, true);
        unsafe {
            let exchange = (Interface::ModelExchange, false);
            let handle = ffi::instantiate((Rockers::new(), Steps::none()), own.as_ptr(), exchange, listener);
            for call in
                [Call::EnterInitializationMode, Call::ExitInitializationMode, Call::EnterContinuousTimeMode]
            {
                assert_eq!(ffi::with(handle, call, Instance::renew), OK);
            }
            let given = |what, room: &mut [f64; 2]| ffi::give(handle, what, (room.as_mut_ptr(), 2));
            let set = |x: [f64; 2]| ffi::set_states(handle, (x.as_ptr(), 2));
            let complete = |event, ends| ffi::complete(handle, [event, ends]);
            assert_eq!((given(ffi::Given::States, &mut x), given(ffi::Given::Rates, &mut rates)), (OK, OK));
            // No bar of a linkage without Grashof's condition turns round beside another.
            let mut angles = (1..12).map(|k| x[0] + 0.5 * f64::from(k));
            let outcome = angles.find(|angle| {
                assert_eq!(set([*angle, x[1]]), OK);
                given(ffi::Given::Rates, &mut again) != OK
            });
            assert!(outcome.is_some());
            assert_eq!(given(ffi::Given::Rates, &mut again), DISCARD);
            let mut indicators = [0.0];
            assert_eq!(ffi::give(handle, ffi::Given::Indicators, (indicators.as_mut_ptr(), 1)), OK);
            assert_eq!(indicators, [-1.0]);
            // In 2.0 a completed step is not among what can be discarded.
            let outcome = if version == Version::Two { ERROR } else { DISCARD };
            assert_eq!(complete(&raw mut event, &raw mut ends), outcome);
            assert_eq!(set(x), OK);
            assert_eq!(given(ffi::Given::Rates, &mut again), OK);
            assert_eq!(again.map(f64::to_bits), rates.map(f64::to_bits));
            assert_eq!(set([x[0] + 1e-3, x[1]]), OK);
            assert_eq!(complete(&raw mut event, &raw mut ends), OK);
            assert!(!event && !ends);
            // A wrong call is no matter of the step.
            assert_eq!(complete(null_mut(), &raw mut ends), ERROR);
            ffi::free(handle);
        }
        let (wrong, discarded): (Heard, Heard) = heard.into_iter().partition(|(status, ..)| *status == ERROR);
        assert_eq!((wrong.len(), discarded.len()), if version == Version::Two { (0, 0) } else { (1, 3) });
        for (status, category, message) in discarded {
            assert_eq!((status, category.as_str()), (DISCARD, "logStatusDiscard"));
            assert!(message.contains("mechanism locks up"), "{message}");
        }
    }
}

#[test]
fn messages_name_the_variable() {
    let (own, mut heard) = (CString::new(token::<Shaft>().as_str()).unwrap(), Heard::new());
    let listener = ffi::Listener::three(Some(hear), (&raw mut heard).cast());
    let wrong = [
        (references(|variable| variable == Variable::Input(0)).remove(0), f64::NAN),
        (references(|variable| variable == Variable::Output(0)).remove(0), 1.0),
        (9999, 1.0),
    ];
    unsafe {
        let handle =
            ffi::instantiate((Shaft::new(), Steps::none()), own.as_ptr(), (CO_SIMULATION, false), listener);
        for (reference, value) in wrong {
            assert_eq!(ffi::set(handle, (&raw const reference, 1), (&raw const value, 1)), ERROR);
        }
        ffi::free(handle);
    }
    let messages: Vec<&str> = heard.iter().map(|(_, _, message)| message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "drive: the value is infinite or not a number",
            "disc.angle: it can be read, not set",
            "no variable has the value reference 9999"
        ]
    );
}
