//! What `ModelStructure` lists as dependencies: nothing else has an influence, and what is not read is not listed.
#![cfg(feature = "fmi")]
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs, reason = "tests")]

use std::collections::BTreeMap;

use plm_foreign::fmi::{Call, Exchanged, Instance, Interface, Variable, Version};

plm::mechanism! {
    /// A loop, two inputs of which one goes straight to an output, two first-order states, and a condition.
    Loop {
        gravity: 9.81 m/s^2;
        param rod: m = 0.9 m;
        input drive: N*m = 1 N*m;
        input offset: rad = 0.2 rad;
        state lag: N*m = 0;
        state sum: rad*s = 0;
        rate lag = (drive - lag)/0.2 s;
        rate sum = rocker.angle - offset;
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (-0.15, 0) m; port a: (0.15, 0) m; start angle: 60 deg, locked; start omega: 3 rad/s; }
        body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5*rod, 0); port b: (0.5*rod, 0); start angle: 20 deg; }
        body rocker { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.35, 0) m; port b: (0.35, 0) m; start angle: 80 deg; }
        revolute a0(ground.o, crank.o) { drive: lag; }
        revolute a(crank.a, coupler.a);
        revolute b(coupler.b, rocker.b);
        revolute b0(ground.p, rocker.p) { damping: 0.1 N*m*s/rad; }
        output rocker.angle, coupler.omega, b.force;
        output through = sum/(1 s) + offset*2;
        output bent = if crank.angle > 1.5 rad then lag else -lag;
        output signal = sin(3 rad/s*t);
    }
}

plm::mechanism! {
    /// A slide that is moved as the time says, and a pendulum on it.
    Moved {
        gravity: 9.81 m/s^2;
        param arm: m = 0.5 m;
        state warmth: K = 300 K;
        rate warmth = (bob.vx^2*1 s/(1 m^2)*1 K - (warmth - 300 K)/1 s);
        ground { port o: (0.1*sin(2*t/(1 s)), 0) m; }
        body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pin: (0, 0.5) m; start angle: 30 deg, locked; }
        revolute hinge(ground.o, bob.pin);
        output bob.x, bob.vx, bob.angle;
        output stretched = arm*bob.omega;
    }
}

/// The value of an attribute in a line.
fn value<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = line.split_once(&format!(" {name}=\""))?;
    rest.split('"').next()
}

/// Names of all variables.
fn names(text: &str) -> Vec<String> {
    let variables = text.lines().filter(|line| line.contains(" valueReference="));
    variables.filter_map(|line| Some(value(line, "name")?.to_owned())).collect()
}

/// Names of the knowns of every unknown, where they are listed.
fn listed(version: Version, text: &str) -> BTreeMap<String, Vec<String>> {
    let names = names(text);
    // 2.0 counts variables from 1.
    let (attribute, first) = match version {
        Version::Two => ("index", 1),
        Version::Three => ("valueReference", 0),
    };
    let name = |reference: &str| names[reference.parse::<usize>().unwrap() - first].clone();
    let lines = text.lines().filter(|line| line.contains("dependencies="));
    let row = |line: &str| {
        let known = value(line, "dependencies").unwrap().split_whitespace().map(name).collect();
        (name(value(line, attribute).unwrap()), known)
    };
    lines.map(row).collect()
}

/// Every derivative of every unknown at several moments of a run: where it is not zero, its known is listed. Gives the list, and
/// how many derivatives were not zero.
fn looked_at<M: Exchanged>(version: Version, declared: M) -> (BTreeMap<String, Vec<String>>, usize) {
    let mut text = String::new();
    plm_foreign::fmi::description(version, &declared, &mut text).unwrap();
    let (listed, names) = (listed(version, &text), names(&text));
    let all: Vec<Variable> = Variable::all(&declared).collect();
    assert_eq!(names.len(), all.len());
    let knowns = |variable: &Variable| match variable {
        Variable::Time | Variable::Input(_) | Variable::State(_) => true,
        // 2.0 lists what changes while equations hold.
        Variable::Parameter(_) => version == Version::Three,
        _ => false,
    };
    let mut instance = Instance::new(declared, Interface::CoSimulation { has_events: false });
    instance.renew().unwrap();
    instance.pass(Call::ExitInitializationMode);
    let mut count = 0;
    for k in 0..20 {
        instance.step_to(0.1 * f64::from(k) + 0.037, false).unwrap();
        for (known, variable) in all.iter().enumerate().filter(|(_, variable)| knowns(variable)) {
            for (unknown, row) in
                all.iter().enumerate().filter_map(|(k, _)| Some((k, listed.get(&names[k])?)))
            {
                let tangent = instance.tangents(&[(*variable, 1.0)], &[all[unknown]]).unwrap()[0];
                count += usize::from(tangent != 0.0);
                let (unknown, known) = (&names[unknown], &names[known]);
                assert!(tangent == 0.0 || row.contains(known), "{unknown} by {known}: {tangent}; {row:?}");
            }
        }
    }
    (listed, count)
}

#[test]
fn what_is_not_listed_has_no_influence() {
    let (rows, count) = looked_at(Version::Three, Loop::new());
    assert!(count > 200, "{count}");
    let has = |unknown: &str, known: &str| rows[unknown].iter().any(|name| name == known);
    // The one output that reads reactions may depend on all.
    assert!(!rows.contains_key("b.force.x") && rows.len() == 8, "{:?}", rows.keys());
    for (unknown, known, is_listed) in [
        ("rocker.angle", "offset", false),
        ("rocker.angle", "drive", false),
        ("rocker.angle", "time", false),
        ("rocker.angle", "rod", true),
        ("through", "offset", true),
        ("through", "drive", false),
        ("signal", "time", true),
        ("signal", "drive", false),
    ] {
        assert_eq!(has(unknown, known), is_listed, "{unknown} by {known}: {rows:?}");
    }
    // Poses depend on the coordinate, velocities on its rate too; an output looks at its condition when it is read.
    for (unknown, count) in [("rocker.angle", 1), ("coupler.omega", 2), ("bent", 2), ("signal", 0)] {
        let states = rows[unknown].iter().filter(|name| name.starts_with("state("));
        assert_eq!(states.count(), count, "{unknown}: {rows:?}");
    }
}

#[test]
fn poses_of_a_prescribed_motion_depend_on_the_time() {
    let (rows, count) = looked_at(Version::Three, Moved::new());
    assert!(count > 100, "{count}");
    for output in ["bob.x", "bob.vx"] {
        assert!(rows[output].iter().any(|name| name == "time"), "{rows:?}");
    }
}

#[test]
fn version_two_lists_the_same_but_for_parameters() {
    let ((three, _), (two, count)) =
        (looked_at(Version::Three, Loop::new()), looked_at(Version::Two, Loop::new()));
    assert!(count > 100 && two.len() == three.len(), "{count}");
    for (unknown, known) in three {
        let without: Vec<String> = known.into_iter().filter(|name| name != "rod").collect();
        assert_eq!(two[&unknown], without, "{unknown}");
    }
}
