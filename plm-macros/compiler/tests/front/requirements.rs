//! What parts require, and how it is switched off.

use plm_compiler::model::{Model, Range};

use crate::parts::scattered;
use crate::support::{assert_near, resolve};

/// Names of the requirements that are looked at.
fn required(model: &Model) -> Vec<&str> {
    model.switches.iter().filter(|switch| switch.must_hold).map(|switch| switch.name.as_str()).collect()
}

#[test]
fn requirements_are_switched_off_where_a_part_is_used() {
    let of = |use_of_it: &str| {
        resolve(&format!(
            "pub P {{
                part rope(a: frame) {{
                    param strength: N;
                    let tension = 3 N/m*a.x;
                    force on a: (-tension, 0 N);
                    require holds: tension < strength;
                    repeat i in 0..2 {{ require within[i]: a.x < (i + 1)*1 m; }}
                }}
                part two(a: frame) {{ rope left(a) {{ strength: 1 N; within[0]: off; }} rope right(a) {{ strength: 2 N; }} }}
                body stone {{ mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; }}
                part pad(a: frame) {{
                    param width: m;
                    require wide: width >= 10 mm;
                    force on a: (0, width*1 N/m);
                }}
                param broad: m = 20 mm;
                {use_of_it}
            }}"
        ))
    };
    let (on, off) =
        (of("rope r(stone.a) { strength: 1 N; }"), of("rope r(stone.a) { strength: 1 N; holds: off; }"));
    assert_eq!(required(&on), ["r.holds", "r.within[0]", "r.within[1]"]);
    assert_eq!(required(&off), ["r.within[0]", "r.within[1]"]);
    // What it applies stays what it is.
    for model in [&on, &off] {
        let values = scattered(model, 1);
        let x = values.get(model.bodies[0].q[0]);
        assert_near(values.at(model, model.loads[0].force[0]), -3.0 * x, "tension");
    }
    let some = of("rope r(stone.a) { strength: 1 N; within[1]: off; holds: on; }");
    assert_eq!(required(&some), ["r.holds", "r.within[0]"]);
    // Of a part inside, and the outermost has the last word.
    let inside = of("two both(stone.a) { left.holds: off; right.within[1]: off; left.within[0]: on; }");
    assert_eq!(
        required(&inside),
        ["both.left.within[0]", "both.left.within[1]", "both.right.holds", "both.right.within[0]"]
    );
    // One that parameters never let hold is no mistake where it is off.
    let never = "part always(a: frame) { param n: 1 = 2; force on a: (1 N, 0 N); require low: n < 1; }";
    let model = resolve(&format!(
        "pub P {{ {never} body b {{ mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; }} always x(b.a) {{ low: off; }} }}"
    ));
    assert!(required(&model).is_empty());
    // What parameters alone decide is a limit of theirs, not a condition of the motion.
    let model = of("pad p(stone.a) { width: broad; }");
    assert!(required(&model).is_empty());
    let limits = model.limits.iter().map(|limit| (limit.part.as_str(), limit.range));
    assert!(limits.eq([("p.wide", Range::Required)]));
}

#[test]
fn the_library_may_come_below_vacuum_where_it_is_allowed() {
    let of = |fields: &str| {
        resolve(&format!(
            "pub P {{
                ground {{ port o: (0, 0) m; }}
                body block {{ mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }}
                prismatic rail(ground.o, block.o);
                chamber left() {{ {fields} }}
                chamber right();
                output left.pressure, right.pressure;
            }}"
        ))
    };
    assert_eq!(required(&of("")), ["left.above_vacuum", "right.above_vacuum"]);
    assert_eq!(required(&of("above_vacuum: off;")), ["right.above_vacuum"]);
}
