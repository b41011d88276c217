//! What a mechanism tells of itself, by number, is what its equations and accessors compute with.

use plm::Described;
use plm::runtime::Ports;
use plm::{Dop853, Rk4};

/// A driven slider-crank on a ground that moves, with lengths and masses that parameters make; in the formulation of `$formulation`.
macro_rules! press {
    ($module:ident, { $($formulation:tt)* }) => {
        mod $module {
            plm::mechanism! {
                /// A press.
                pub Press {
                    gravity: 9.81 m/s^2;
                    $($formulation)*
                    /// Length of the rod.
                    param length: cm = 80 cm;
                    param density: kg/m = 2 kg/m;
                    /// It must be said.
                    param lift: mm;
                    param twice: mm = 2*lift;
                    input push: kN = 0.5 kN;
                    state heat: kPa = 3 kPa;
                    rate heat = 10 Pa/s;
                    /// A spring between two pins that are drawn.
                    part strut(a: frame, b: frame) {
                        param radius: m = 1 cm;
                        picture radius;
                        spring coil(a, b) { stiffness: 50 N/m; free_length: 0.4 m; }
                        jack cylinder(a, b) { piston_diameter: 3*radius; }
                    }
                    ground {
                        port o: (0, if t < 0.25 s then 0 m else lift*sin(3 rad/s*(t - 0.25 s))^3), angle: 5 deg;
                        port rail: (0, 0.1) m, angle: 15 deg, depth: -1 cm;
                        port hook: (0.3, 1) m;
                    }
                    body crank {
                        mass: 1.5 kg; inertia: 0.02 kg*m^2; centre: (0.05, 0.01) m; depth: 2 cm;
                        port o: (0, 0) m; port pin: (0.2, 0) m, angle: 30 deg;
                        contour: (0 m, -1 cm), (length/4, 0 m), (0 m, 1 cm);
                        start angle: 70 deg; start omega: 6 rad/s;
                    }
                    body rod {
                        mass: density*length; inertia: density*length^3/12;
                        port pin: (-length/2, 0); port end: (length/2, 0); port eye: (0, 0.1) m;
                        start angle: -15 deg;
                    }
                    body ram { mass: 3 kg; inertia: 0.05 kg*m^2; port end: (0.1, 0.03) m; }
                    revolute main(ground.o, crank.o) { pin_diameter: length/40; }
                    revolute big_end(crank.pin, rod.pin);
                    revolute small_end(rod.end, ram.end);
                    prismatic guide(ground.rail, ram.end);
                    strut tie(ground.hook, rod.eye) { radius: twice; }
                    force thrust(ram.end) { x: push; }
                    output ram.x in mm, main.force, rod.angle in deg;
                    observe all;
                }
            }
        }
    };
}

press!(loops, {});
press!(absolute, { formulation: absolute; });

fn near(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-12 * (1.0 + expected.abs()), "{what}: {found}, {expected}");
}

/// The number of the observed quantity of this name.
fn column<M: Described>(name: &str) -> usize {
    M::OBSERVED.iter().position(|(known, _)| *known == name).unwrap_or_else(|| panic!("{name}"))
}

/// Ports stand where the accessors have them, and bodies hold the energy that the tables give them.
fn tables_agree<M: Described<S = f64>>(state: &M::State, t: f64, mechanism: &M, energy: f64) {
    let observed = |name: String| M::observed(state, column::<M>(&name)).unwrap();
    let mut kinetic = 0.0;
    for (k, body) in M::TABLES.bodies.iter().enumerate() {
        let pose = M::pose(state, k).unwrap();
        let speed = pose.vx * pose.vx + pose.vy * pose.vy;
        kinetic += mechanism.mass(k).unwrap() * speed / 2.0;
        kinetic += mechanism.inertia(k).unwrap() * pose.omega * pose.omega / 2.0;
        near(pose.x, observed(format!("{}.x", body.name)), body.name);
        near(pose.omega, observed(format!("{}.omega", body.name)), body.name);
        for (j, port) in body.ports.iter().enumerate() {
            let (name, place) = (format!("{}.{port}", body.name), mechanism.port(k, j).unwrap());
            let [x, y] = pose.point(place.x, place.y);
            near(x, observed(format!("{name}.position.x")), &name);
            near(y, observed(format!("{name}.position.y")), &name);
            near(pose.angle + place.angle, observed(format!("{name}.angle")), &name);
        }
        assert_eq!(mechanism.port(k, body.ports.len()), None);
    }
    near(kinetic, energy, "kinetic energy");
    for (j, port) in M::TABLES.ground.iter().enumerate() {
        let place = mechanism.ground(t, j).unwrap();
        near(place.x, observed(format!("ground.{}.position.x", port.name)), port.name);
        near(place.y, observed(format!("ground.{}.position.y", port.name)), port.name);
        near(place.angle, observed(format!("ground.{}.angle", port.name)), port.name);
    }
}

macro_rules! places {
    ($name:ident, $module:ident) => {
        #[test]
        fn $name() {
            let declared = $module::Press::new(0.01);
            let mut longer = declared;
            assert!(longer.set_parameter(0, 0.9) && longer.set_parameter(1, 3.0));
            assert!(!longer.set_parameter(4, 1.0));
            assert_eq!((longer.length, longer.density), (0.9, 3.0));
            for mechanism in [declared, longer] {
                let mut sim = mechanism.start_with(Rk4::new(1e-3)).unwrap();
                for _ in 0..4 {
                    tables_agree(sim.state(), sim.time(), &mechanism, sim.kinetic_energy());
                    sim.step(0.1).unwrap();
                }
                assert!(mechanism.ground(0.4, 0).unwrap().y != 0.0, "its ground moves");
            }
        }
    };
}

places!(numbers_of_the_tables_are_those_of_the_motion, loops);
places!(numbers_of_the_tables_are_those_of_the_motion_in_absolute_coordinates, absolute);

/// Names, kinds and frames as they were declared; of what is inside of parts, what joins frames.
#[test]
fn parts_say_whom_they_join() {
    let tables = loops::Press::<f64>::TABLES;
    let joined: Vec<String> = tables
        .parts
        .iter()
        .map(|part| {
            let frames = part.frames.iter().map(|frame| match frame.body {
                Some(body) => {
                    format!("{}.{}", tables.bodies[body].name, tables.bodies[body].ports[frame.port])
                }
                None => format!("ground.{}", tables.ground[frame.port].name),
            });
            let frames: Vec<String> = frames.collect();
            format!("{} {}({})", part.kind, part.name, frames.join(", "))
        })
        .collect();
    assert_eq!(
        joined,
        [
            "revolute main(ground.o, crank.o)",
            "revolute big_end(crank.pin, rod.pin)",
            "revolute small_end(rod.end, ram.end)",
            "prismatic guide(ground.rail, ram.end)",
            "strut tie(ground.hook, rod.eye)",
            "spring tie.coil(ground.hook, rod.eye)",
            "jack tie.cylinder(ground.hook, rod.eye)",
            "force thrust(ram.end)",
        ]
    );
    let pairs: Vec<_> = tables.parts.iter().map(|part| part.pair).collect();
    assert_eq!(pairs[2..6], [Some("revolute"), Some("prismatic"), None, None]);
    assert_eq!(tables.parts[0].frames[1].argument, "b");
}

#[test]
fn sizes_contours_and_depths_follow_the_parameters() {
    let tables = loops::Press::<f64>::TABLES;
    let size = |mechanism: &loops::Press, name: &str| {
        let named = |part: usize, size: usize| {
            format!("{}.{}", tables.parts[part].name, tables.parts[part].sizes[size])
        };
        let all =
            tables.parts.iter().enumerate().flat_map(|(i, part)| (0..part.sizes.len()).map(move |j| (i, j)));
        let (part, size) = all.into_iter().find(|(i, j)| named(*i, *j) == name).unwrap();
        mechanism.size(part, size).unwrap()
    };
    for (length, lift) in [(0.8, 0.01), (1.0, 0.02)] {
        let mechanism = loops::Press { length, ..loops::Press::new(lift) };
        near(size(&mechanism, "main.pin_diameter"), length / 40.0, "pin");
        near(size(&mechanism, "tie.radius"), 2.0 * lift, "a size of one's own");
        near(size(&mechanism, "tie.cylinder.piston_diameter"), 6.0 * lift, "inside of a part");
        near(size(&mechanism, "tie.coil.free_length"), 0.4, "spring");
        // From G, which stands at (0.05, 0.01) from the origin of the crank.
        let corners = [0, 1, 2, 3].map(|point| mechanism.contour(0, point));
        let expected = [[-0.05, -0.02], [length / 4.0 - 0.05, -0.01], [-0.05, 0.0]];
        for (corner, expected) in corners.into_iter().flatten().zip(expected) {
            near(corner[0], expected[0], "x of the contour");
            near(corner[1], expected[1], "y of the contour");
        }
        assert_eq!((corners[3], tables.bodies[0].contour, tables.bodies[1].contour), (None, 3, 0));
        assert_eq!([0, 1].map(|body| mechanism.depth(body).unwrap()), [0.02, 0.0]);
        assert_eq!([0, 1].map(|port| mechanism.ground_depth(port).unwrap()), [0.0, -0.01]);
    }
    assert_eq!(tables.ground.iter().map(|port| port.moves).collect::<Vec<_>>(), [true, false, false]);
}

/// Exponents of metre, kilogram, second, kelvin, ampere, mole, radian; factors and defaults by hand.
#[test]
fn quantities_have_units_and_defaults() {
    let tables = loops::Press::<f64>::TABLES;
    let [length, density, lift, twice] = tables.parameters else { panic!("{:?}", tables.parameters) };
    assert_eq!((length.name, length.unit, length.factor), ("length", "cm", 0.01));
    assert_eq!((length.exponents, length.docs), ([1, 0, 0, 0, 0, 0, 0], "Length of the rod."));
    assert_eq!((density.exponents, density.default), ([-1, 1, 0, 0, 0, 0, 0], Some(2.0)));
    near(length.default.unwrap(), 0.8, "default");
    assert_eq!((lift.default, twice.default), (None, None), "what must be said, and what reads it");
    let [push] = tables.inputs else { panic!("{:?}", tables.inputs) };
    assert_eq!((push.unit, push.factor, push.default), ("kN", 1000.0, Some(500.0)));
    assert_eq!(push.exponents, [1, 1, -2, 0, 0, 0, 0]);
    let [heat] = tables.states else { panic!("{:?}", tables.states) };
    assert_eq!((heat.name, heat.unit, heat.default), ("heat", "kPa", Some(3000.0)));
    let angle = tables.outputs[3];
    assert_eq!((angle.name, angle.unit, angle.exponents), ("rod.angle", "deg", [0, 0, 0, 0, 0, 0, 1]));
    near(angle.factor, std::f64::consts::PI / 180.0, "a degree");
    let outputs: Vec<_> = tables.outputs.iter().map(|output| (output.name, output.unit)).collect();
    assert_eq!(outputs, loops::Press::<f64>::OUTPUTS);
    assert_eq!((tables.name, tables.docs), ("Press", "A press."));
}

#[test]
fn the_report_says_what_was_chosen() {
    let [closed, absolute] = [loops::Press::<f64>::TABLES.report, absolute::Press::<f64>::TABLES.report];
    assert_eq!((closed.rung, closed.formulation), (3, "joint coordinates"));
    assert_eq!(closed.operations, loops::press::OPERATIONS);
    // Nine coordinates and eight rows.
    assert_eq!((closed.degrees_of_freedom, absolute.degrees_of_freedom), (1, 1));
    assert_eq!((absolute.rung, absolute.reason), (5, "it is ordered"));
}

/// By number as by name, in SI whatever an output asks for.
#[test]
fn what_is_observed_is_si_by_number_too() {
    type Press = loops::Press;
    let mut sim = Press::new(0.01).start_with(Dop853::default()).unwrap();
    sim.step(0.2).unwrap();
    let by_number = |name| Press::observed(sim.state(), column::<Press>(name)).unwrap();
    near(by_number("rod.angle"), sim.rod().angle, "an angle that is also an output in degrees");
    near(by_number("ram.x"), sim.ram().x, "a length that is also an output in millimetres");
    let chosen = loops::press::State::<f64>::find(["rod.angle", "ram.x"]).unwrap();
    assert_eq!(chosen.map(|of| of.unit), ["rad", "m"]);
    assert_eq!(sim.observed(chosen), [sim.rod().angle, sim.ram().x]);
    near(sim.outputs()[3], sim.rod().angle.to_degrees(), "the output itself");
    near(Press::state(sim.state(), 0).unwrap(), 3002.0, "a state that rises by 10 Pa in a second");
    assert_eq!(Press::state(sim.state(), 1), None);
    assert_eq!(Press::observed(sim.state(), Press::OBSERVED.len()), None);
}

/// In any scalar; without outputs, parameters and parts there are empty tables.
#[test]
fn every_mechanism_has_tables() {
    mod bare {
        plm::mechanism! {
            pub Stone { allow(W0002); body stone { mass: 2 kg; inertia: 3 kg*m^2; port a: (1, 0) m; } }
        }
    }
    let stone = bare::Stone::<f32>::of();
    assert_eq!((stone.mass(0), stone.inertia(0), stone.mass(1)), (Some(2.0_f32), Some(3.0), None));
    let tables = bare::Stone::<f32>::TABLES;
    assert!(tables.parts.is_empty() && tables.parameters.is_empty() && tables.outputs.is_empty());
    assert!(bare::Stone::<f32>::OBSERVED.is_empty());
    assert_eq!(stone.parameter(0), None);
}
