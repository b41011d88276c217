//! What C does with pointers, in Rust, so that Miri can look at it: `cargo +nightly miri test -p plm-foreign --test ffi`.
#![allow(
    unsafe_code,
    clippy::undocumented_unsafe_blocks,
    clippy::unwrap_used,
    missing_docs,
    reason = "tests"
)]

use std::ffi::{CStr, c_char};
use std::mem::MaybeUninit;
use std::ptr::null_mut;

use plm::{Dop853, Rk4, Sim};
use plm_foreign::{Either, Foreign, Kind, Status, ffi, ffi::Block};

plm::mechanism! {
    Pendulum {
        gravity: 9.81 m/s^2;
        param friction: N*m*s/rad = 0.1 N*m*s/rad;
        input drive: N*m = 0;
        ground { port o: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; start angle: 30 deg, locked; }
        revolute hinge(ground.o, bob.pivot) { damping: friction; drive: drive; }
        output bob.angle, bob.omega;
    }
}

/// Memory of an object, with room for a wrong address.
fn memory() -> Vec<MaybeUninit<Block<Pendulum>>> {
    vec![MaybeUninit::zeroed(), MaybeUninit::zeroed()]
}

fn started(memory: &mut [MaybeUninit<Block<Pendulum>>]) -> *mut Block<Pendulum> {
    let object = memory.as_mut_ptr().cast();
    unsafe {
        assert_eq!(ffi::init(object, Block::<Pendulum>::SIZE, Pendulum::new()), 0);
        assert_eq!(ffi::start(object), 0);
    }
    object
}

fn get(object: *mut Block<Pendulum>, kind: Kind, index: usize) -> f64 {
    let mut value = f64::NAN;
    assert_eq!(unsafe { ffi::get(object, kind as i32, index, &raw mut value) }, 0);
    value
}

#[test]
fn a_copy_of_the_bytes_goes_on_to_the_bit() {
    let (mut first, mut second) = (memory(), memory());
    let object = started(&mut first);
    let copy: *mut Block<Pendulum> = second.as_mut_ptr().cast();
    unsafe {
        assert_eq!(ffi::set(object, Kind::Input as i32, 0, 0.5), 0);
        assert_eq!(ffi::step(object, 0.01), 0);
        copy.cast::<u8>().copy_from_nonoverlapping(object.cast(), Block::<Pendulum>::SIZE);
        for each in [object, copy] {
            assert_eq!(ffi::step_to(each, 0.03), 0);
        }
    }
    for index in 0..2 {
        let [ours, copied] = [object, copy].map(|each| get(each, Kind::Output, index).to_bits());
        assert_eq!(ours, copied);
    }
    let mut pose = [f64::NAN; 6];
    assert_eq!(unsafe { ffi::pose(copy, 0, &raw mut pose) }, 0);
    assert_eq!(pose[2].to_bits(), get(copy, Kind::Output, 0).to_bits());
}

#[test]
fn a_saved_run_goes_on_in_another_object() {
    let (mut first, mut second) = (memory(), memory());
    let (object, other) = (started(&mut first), second.as_mut_ptr().cast::<Block<Pendulum>>());
    let mut size = 0;
    unsafe {
        assert_eq!(ffi::step(object, 0.01), 0);
        assert_eq!(ffi::saved_size(object, &raw mut size), 0);
        let mut bytes: Vec<MaybeUninit<u8>> = vec![MaybeUninit::uninit(); size];
        let room: *mut u8 = bytes.as_mut_ptr().cast();
        assert_eq!(ffi::save(object, (room, size - 1)), Status::Memory as i32);
        assert_eq!(ffi::save(object, (null_mut(), size)), Status::Null as i32);
        assert_eq!(ffi::save(object, (room, size)), 0);
        assert_eq!(ffi::init(other, Block::<Pendulum>::SIZE, Pendulum::new()), 0);
        let restore = |size| ffi::restore(other, Pendulum::new(), (room, size));
        assert_eq!(restore(size - 1), Status::Damaged as i32);
        assert_eq!(ffi::step(other, 0.01), Status::NotStarted as i32);
        assert_eq!(restore(size), 0);
        for each in [object, other] {
            assert_eq!(ffi::step(each, 0.01), 0);
        }
    }
    assert_eq!(get(object, Kind::Output, 0).to_bits(), get(other, Kind::Output, 0).to_bits());
}

/// Also of a run that is under way: what its method remembers decides later bits.
#[test]
fn a_set_that_fails_changes_no_byte() {
    let mut memory = memory();
    let object = started(&mut memory);
    assert_eq!(unsafe { ffi::step(object, 0.1) }, 0);
    let saved = || unsafe {
        let mut size = 0;
        assert_eq!(ffi::saved_size(object, &raw mut size), 0);
        let mut bytes = vec![0_u8; size];
        assert_eq!(ffi::save(object, (bytes.as_mut_ptr(), size)), 0);
        bytes
    };
    let mut failed = 0;
    for (kind, index, value) in (0..11).flat_map(|kind| (0..8).map(move |index| (kind, index, 0.77))).chain([
        (Kind::Input as i32, 0, f64::NAN),
        (Kind::Parameter as i32, 0, f64::INFINITY),
        (Kind::Start as i32, 0, f64::NAN),
    ]) {
        let before = saved();
        if unsafe { ffi::set(object, kind, index, value) } != 0 {
            failed += 1;
            assert_eq!(before, saved(), "kind {kind}, {index}: {value}");
        }
    }
    // Of 91 a parameter, an input and six start values can be set.
    assert_eq!(failed, 83);
}

/// A library of the same declaration with its methods in another order has objects of the same size.
#[test]
fn an_object_of_other_methods_is_none() {
    type Dop = Sim<Pendulum, Dop853<Pendulum>>;
    type Rk = Sim<Pendulum, Rk4<f64>>;
    type Own = ffi::BlockBy<Pendulum, Either<Dop, Rk>>;
    type Other = ffi::BlockBy<Pendulum, Either<Rk, Dop>>;
    assert_eq!(Own::SIZE, Other::SIZE);
    let mut memory = [MaybeUninit::<Own>::zeroed()];
    let object: *mut Own = memory.as_mut_ptr().cast();
    unsafe {
        assert_eq!(ffi::init(object, Own::SIZE, Pendulum::new()), 0);
        assert_eq!(ffi::start(object.cast::<Other>()), Status::NoObject as i32);
        assert_eq!(ffi::start(object), 0);
    }
}

#[test]
fn wrong_pointers_are_told() {
    let mut memory = memory();
    let object: *mut Block<Pendulum> = memory.as_mut_ptr().cast();
    let (size, null) = (Block::<Pendulum>::SIZE, null_mut::<Block<Pendulum>>());
    #[allow(clippy::cast_ptr_alignment, reason = "that is what is told")]
    let askew = object.cast::<u8>().wrapping_add(4).cast::<Block<Pendulum>>();
    let code = |status: Status| status as i32;
    unsafe {
        assert_eq!(ffi::step(object, 0.1), code(Status::NoObject));
        assert_eq!(ffi::step(askew, 0.1), code(Status::NoObject));
        assert_eq!(ffi::step(null, 0.1), code(Status::Null));
        assert_eq!(ffi::init(null, size, Pendulum::new()), code(Status::Null));
        assert_eq!(ffi::init(askew, size, Pendulum::new()), code(Status::Memory));
        assert_eq!(ffi::init(object, size - 1, Pendulum::new()), code(Status::Memory));
        assert_eq!(ffi::init(object, size, Pendulum::new()), 0);
        assert_eq!(ffi::get(object, Kind::Parameter as i32, 0, null_mut()), code(Status::Null));
        assert_eq!(ffi::step(object, 0.1), code(Status::NotStarted));
        assert_eq!(CStr::from_ptr(ffi::text(object)), c"the mechanism has not been started");
        assert_eq!(CStr::from_ptr(ffi::text(null)), c"");
    }
}

#[test]
fn names_are_written_and_found() {
    let pendulum = Pendulum::new();
    assert_eq!(ffi::count(&pendulum, Kind::Start as i32), 6);
    let (mut name, mut index): ([c_char; 12], usize) = ([1; 12], 0);
    let kind = Kind::Start as i32;
    unsafe {
        assert_eq!(ffi::name(&pendulum, kind, 5, (name.as_mut_ptr(), name.len())), 0);
        assert_eq!(CStr::from_ptr(name.as_ptr()), c"bob.omega");
        assert_eq!(ffi::name(&pendulum, kind, 5, (name.as_mut_ptr(), 4)), Status::Memory as i32);
        assert_eq!(CStr::from_ptr(name.as_ptr()), c"bob");
        assert_eq!(ffi::find(&pendulum, kind, c"bob.omega".as_ptr(), &raw mut index), 0);
        assert_eq!(ffi::find(&pendulum, 9, c"bob.omega".as_ptr(), &raw mut index), Status::NoSuch as i32);
    }
    assert_eq!(index, 5);
}

/// Start values count at the next start; inputs stay.
#[test]
fn a_new_start_keeps_inputs() {
    fn of<M: Foreign<S = f64>>(object: &plm_foreign::Object<M>, kind: Kind) -> f64 {
        object.get(kind, 0).unwrap()
    }
    let mut object = plm_foreign::Object::new(Pendulum::new());
    object.start().unwrap();
    object.set(Kind::Input, 0, 3.0).unwrap();
    object.set(Kind::Start, 2, 1.25).unwrap();
    object.start().unwrap();
    assert_eq!((of(&object, Kind::Input), of(&object, Kind::Output)), (3.0, 1.25));
}
