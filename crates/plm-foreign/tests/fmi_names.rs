//! Names of variables of an FMU are unique, whatever a declaration calls its things.
#![cfg(feature = "fmi")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use std::collections::BTreeSet;

use plm_foreign::fmi::Version;

plm::mechanism! {
    Clash {
        param time: s = 2 s;
        param load: kg = 1 kg;
        input force: N = 0;
        state level: m = 0;
        rate level = (force/(1 N)*1 m - level)/time;
        ground { port o: (0, 0) m; }
        body bar { mass: load; inertia: 0.1 kg*m^2; port pivot: (0, 0.4) m; start angle: 30 deg, locked; }
        revolute hinge(ground.o, bar.pivot) { drive: force*0.1 m; }
        output load, force, bar.angle in deg, level;
        observe all;
    }
}

/// The values of an attribute of all variables, in their order.
fn values<'a>(text: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    let lines = text.lines().filter(|line| line.trim_start().starts_with("<Float64"));
    lines
        .map(|line| line.split_once(&start).map_or("", |(_, rest)| rest.split('"').next().unwrap()))
        .collect()
}

#[test]
fn names_are_unique_and_declared_ones_stay() {
    let mut text = String::new();
    plm_foreign::fmi::description(Version::Three, &Clash::new(), &mut text).unwrap();
    let (names, causalities) = (values(&text, "name"), values(&text, "causality"));
    let all: BTreeSet<_> = names.iter().collect();
    assert_eq!(all.len(), names.len(), "{names:?}");
    let of = |name: &str| names.iter().position(|own| *own == name).and_then(|k| causalities.get(k).copied());
    for (name, causality) in [
        ("time", "parameter"),
        ("independent(time)", "independent"),
        ("load", "parameter"),
        ("output(load)", "output"),
        ("force", "input"),
        ("output(force)", "output"),
        ("level", "output"),
        ("start(level)", "parameter"),
        ("bar.angle", "output"),
        ("start(bar.angle)", "parameter"),
    ] {
        assert_eq!(of(name), Some(causality), "{name}: {names:?}");
    }
}
