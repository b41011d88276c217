//! Any name: words of Rust, names that emitted code has itself, and mechanisms that are declared within a function.
#![allow(clippy::unwrap_used, reason = "tests")]
#![allow(non_ascii_idents)] // Among any names are these.
#![deny(unreachable_pub, missing_docs, unused_imports)]

/// A mechanism of each name, in a block of its own: that rustc takes it is the test, and none of them runs.
macro_rules! declared {
    ($($name:ident)*) => {
        [$({
            plm::mechanism! {
                pub $name {
                    param weight: N = 1 N;
                    input push: N = 0 N;
                    body stone { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; }
                    force pull(stone.a) { y: push - weight; }
                    output height = stone.y;
                }
            }
            (stringify!($name), $name { weight: 2.0, ..$name::new() }.weight)
        }),*]
    };
}

#[test]
fn a_mechanism_may_have_any_name() {
    let all = declared! {
        S T I K N X U G Q NQ NC NX NDOF OPERATIONS CONTOURS State Input Held Starts Start BodyStart BodyState Assembly Sim Method
        Operations Option Some None Result Ok Err Scalar Real Fault Plm Core Std Mechanism Mechanism_ Moment Vec String Box
        Two Iterator Fn FnMut Default Clone Copy Debug PartialEq Send Drop Display Type F64 Usize Bool Loop Self_ Arm_ Код 日本
    };
    for (name, weight) in all {
        assert_eq!(weight, 2.0, "{name}");
    }
}

plm::mechanism! {
    /// Keywords of Rust as names of all that can be named.
    pub Keywords {
        gravity: 9.81 m/s^2;
        param r#fn: N*m = 1 N*m;
        param Type: N*m = 1 N*m;
        input match: N*m = 0 N*m;
        input r#where: N*m = 0 N*m;
        state async: m = 0 m;
        rate async = use.x/(1 s);
        let loop = match + Self;
        let Self = dyn;
        param dyn: N*m = 2 N*m;
        ground { port mut: (0, 0) m; }
        body type { mass: 1 kg; inertia: 1 kg*m^2; port const: (0, -1) m; port enum: (0, 1) m; }
        body use { mass: 1 kg; inertia: 1 kg*m^2; port static: (0, -1) m; }
        body crate { mass: 1 kg; inertia: 1 kg*m^2; port super: (0, -1) m; }
        revolute impl(ground.mut, type.const) { drive: fn + Type; }
        revolute move(type.enum, use.static) { drive: loop; }
        revolute box(type.enum, crate.super) { drive: where; }
        output try = move.angle;
        output return = async;
    }
}

#[test]
fn words_of_rust_are_names() {
    let mut mechanism = Keywords { r#fn: 3.0, ..Keywords::new() };
    mechanism.start.r#type.angle = plm::Start::locked(0.25);
    let mut sim = mechanism.start().unwrap();
    (sim.input.r#match, sim.input.r#where) = (0.5, 0.25);
    assert_eq!((sim.r#type().angle, sim.r#return()), (0.25, 0.0));
    sim.step(0.01).unwrap();
    assert!(sim.r#try() != 0.0 && sim.crate_().omega != 0.0 && sim.r#use().x != 0.0);
}

plm::mechanism! {
    /// With a condition, and a known time, that are held beside the inputs.
    pub Wheel {
        input road: m = 0 m;
        ground { port rail: (0, 0) m, axis: 90 deg; }
        let bump = if t > 0.01 s then 0.01 m else 0 m;
        let above = if wheel.y > 0.4 m then 0 N else 10 N;
        body wheel {
            mass: 40 kg;
            inertia: 1 kg*m^2;
            port rail: (0, 0) m, angle: 90 deg;
            start y: 0.3 m;
        }
        prismatic axle(ground.rail, wheel.rail) {
            drive: 150 kN/m*(0.31 m + bump + road - wheel.y) + above;
        }
    }
}

// That every field is given is what is tried: the update is for mechanisms that get another input.
#[allow(clippy::needless_update)]
#[test]
fn inputs_are_written_as_what_they_are_whatever_is_declared() {
    let mut set = Wheel::new().start().unwrap();
    set.input.road = 0.1;
    set.step(0.02).unwrap();
    for input in [wheel::Input { road: 0.1 }, wheel::Input { road: 0.1, ..set.input }] {
        let mut written = Wheel::new().start().unwrap();
        written.input = input;
        written.step(0.02).unwrap();
        assert_eq!(written.wheel(), set.wheel());
    }
    assert!(set.wheel().y > 0.35, "{:?}", set.wheel());
}

plm::mechanism! {
    /// Rows of contact, events and a force that is read, with the names of what is emitted for them.
    pub Rows {
        gravity: 9.81 m/s^2;
        param gap: m = 0.1 m;
        param limit: 1 = 0.3;
        param response: 1 = 2;
        discrete set: 1 = 0;
        discrete holds: 1 = 1;
        discrete exist: 1 = 1;
        let rows = gap*response;
        let contact = limit*response;
        let held = (1 N)*contact;
        body lambda { mass: 1 kg; inertia: 1 kg*m^2; start y: gap; start vx: 1 m/s; }
        constraint dx: lambda.angle = 0;
        unilateral index: lambda.y >= 0 m { when: exist > 0.5; }
        friction mode: rate(lambda.x + rows) within limit*reaction(index) { when: holds > 0.5; }
        when lambda.y < gap/response { set = set + contact; exist = exist; }
        output rows, contact, held, drag = reaction(mode), set, holds, exist, mechanism = lambda.x;
        when t > 9 s { holds = 0; }
    }
}

#[test]
fn names_of_what_is_emitted_for_contact_are_names() {
    let mut sim = Rows::new().start().unwrap();
    sim.step(2.0).unwrap();
    assert_eq!((sim.set(), sim.holds(), sim.lambda().vx), (0.6, 1.0, 0.0));
    assert!((sim.rows() - 0.2).abs() < 1e-15 && (sim.held() - 0.6).abs() < 1e-15);
}

mod shared {
    plm::parts! {
        /// Documented, as everything is.
        #[allow(dead_code)] // Attributes may stand here.
        pub(crate) r#type {
            part pull(a: frame) { force on a: (0, -2 N); }
        }
    }
}

/// Declared by `parts!`, seen from other crates.
pub mod exported {
    plm::parts! {
        /// Documented, as everything is.
        pub push {
            part push(a: frame) { force on a: (0, 2 N); }
        }
    }
}

#[test]
fn shared_parts_have_attributes_and_any_name_and_stand_in_functions_too() {
    plm::parts! {
        local {
            part twist(a: frame) { torque on a: 1 N*m; }
        }
    }
    plm::mechanism! {
        use shared::r#type;
        use exported::push;
        use local;
        Stone {
            body stone { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; }
            pull down(stone.a);
            push up(stone.a);
            twist left(stone.a);
        }
    }
    fn stone_at_start(mechanism: Stone) -> stone::State {
        *mechanism.start().unwrap()
    }
    let mut sim: stone::State = stone_at_start(Stone::new());
    let state = sim;
    sim.input = state.input;
    let mut sim = sim.mechanism.start().unwrap();
    sim.step(1.0).unwrap();
    assert!((sim.stone().omega - 1.0).abs() < 1e-9 && sim.stone().y.abs() < 1e-9);
}
