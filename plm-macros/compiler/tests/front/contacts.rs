//! Rows of contact: displacements, forces, what they say.

use plm_compiler::model::{ContactLaw, Impacts, Model, Range};

use crate::parts::scattered;
use crate::support::{Values, assert_near, output, resolve};

/// A stone over a ramp, with what is written about it.
fn stone(items: &str) -> Model {
    resolve(&format!(
        "pub P {{
            param e: 1 = 0.5;
            input grip: N = 3 N;
            ground {{ port o: (0, 0) m; }}
            body stone {{ mass: 1 kg; inertia: 1 kg*m^2; port a: (2, 0) m; }}
            {items}
        }}"
    ))
}

/// The multiplier of a row, with a value.
fn set(model: &Model, values: &mut Values, row: &str, lambda: f64) {
    let contact = model.contacts.iter().find(|contact| contact.name == row).unwrap();
    values.set(contact.lambda, lambda);
}

#[test]
fn gaps_push_along_their_gradients() {
    let model = stone("unilateral tip: stone.a.y >= 3 m*stone.a.x/(1 m) { restitution: 2*e; }");
    let [contact] = &model.contacts[..] else { panic!("one row") };
    let part = &model.parts[contact.part];
    assert_eq!(
        (contact.name.as_str(), part.name.text.as_str(), part.kind.as_str()),
        ("tip", "tip", "unilateral")
    );
    assert_eq!(contact.unit.text, "m");
    let mut values = scattered(&model, 1);
    let [x, y, theta] = model.bodies[0].q.map(|symbol| values.get(symbol));
    let (sin, cos) = theta.sin_cos();
    let gap = y + 2.0 * sin - 3.0 * (x + 2.0 * cos);
    assert_near(values.at(&model, contact.displacement), gap, "gap");
    let ContactLaw::Unilateral { restitution } = contact.law else { panic!("unilateral") };
    assert_near(values.at(&model, restitution), 1.0, "restitution");
    set(&model, &mut values, "tip", 7.0);
    let [load] = &model.loads[..] else { panic!("one load") };
    assert_eq!((load.body, load.part), (0, contact.part));
    let expected = [-21.0, 7.0, 7.0 * (2.0 * cos + 6.0 * sin)];
    for (force, expected) in load.force.iter().zip(expected) {
        assert_near(values.at(&model, *force), expected, "force");
    }
}

#[test]
fn both_ways_of_writing_a_gap_are_one() {
    for row in ["stone.a.y >= 1 m", "1 m <= stone.a.y", "stone.a.y - 1 m >= 0", "0 m <= stone.a.y - 1 m"] {
        let model = stone(&format!("unilateral tip: {row};"));
        let values = scattered(&model, 2);
        let [_, y, theta] = model.bodies[0].q.map(|symbol| values.get(symbol));
        assert_near(values.at(&model, model.contacts[0].displacement), y + 2.0 * theta.sin() - 1.0, row);
    }
}

/// Limits of a friction, `[lower, upper]` while it slips and while it sticks.
fn limits(model: &Model, values: &Values, row: &str) -> [[f64; 2]; 2] {
    let contact = model.contacts.iter().find(|contact| contact.name == row).unwrap();
    let ContactLaw::Friction { kinetic, adhesion, .. } = contact.law else { panic!("friction") };
    [kinetic, adhesion].map(|both| both.map(|limit| values.at(model, limit)))
}

#[test]
fn frictions_have_limits_on_either_side() {
    let model = stone(
        "friction plain: rate(stone.x) within grip;
         friction belt: rate(stone.y) within -2 N .. 2*grip { static: -3 N..7 N; }
         friction disc: rate(stone.angle) within -1 N*m .. 2 N*m;",
    );
    let values = Values::of(&model);
    assert_eq!(limits(&model, &values, "plain"), [[3.0, 3.0], [3.0, 3.0]]);
    assert_eq!(limits(&model, &values, "belt"), [[2.0, 6.0], [3.0, 7.0]]);
    assert_eq!(limits(&model, &values, "disc"), [[1.0, 2.0], [1.0, 2.0]]);
    let units: Vec<&str> = model.contacts.iter().map(|contact| contact.unit.text.as_str()).collect();
    assert_eq!(units, ["m", "m", "rad"]);
    assert_eq!(model.loads.len(), 3);
}

#[test]
fn bounds_and_outputs_read_reactions_of_contacts() {
    let model = stone(
        "unilateral tip: stone.a.y >= 0 m;
         friction slip: rate(stone.a.x) within 0.4*reaction(tip) { static: 0.6*reaction(tip) + 1 N; }
         output push = reaction(tip), drag = reaction(slip) in N;",
    );
    let mut values = scattered(&model, 3);
    set(&model, &mut values, "tip", 10.0);
    set(&model, &mut values, "slip", -2.0);
    assert_eq!(limits(&model, &values, "slip"), [[4.0, 4.0], [7.0, 7.0]]);
    let shown: Vec<f64> =
        model.outputs.iter().map(|output| values.at(&model, output.components[0])).collect();
    assert_eq!(shown, [10.0, -2.0]);
}

#[test]
fn parts_hold_rows_of_contact_and_hand_their_reactions_on() {
    let model = stone(
        "part foot(a: frame) {
             param mu: 1;
             unilateral tip: a.y >= 0 { restitution: 0.1; }
             rub slip(a) { push: mu*reaction(tip); }
             output push = reaction(tip);
         }
         part rub(a: frame) {
             input push: N;
             friction f: rate(a.x) within push;
             output drag = reaction(f);
         }
         foot left(stone.a) { mu: 0.5; }
         repeat i in 0..2 { unilateral wall[i]: stone.x <= (i + 1)*1 m; }
         output left.push, drag = left.slip.drag;
         impacts: newton;",
    );
    let names: Vec<&str> = model.contacts.iter().map(|contact| contact.name.as_str()).collect();
    assert_eq!(names, ["left.tip", "left.slip.f", "wall[0]", "wall[1]"]);
    let parts: Vec<&str> =
        model.contacts.iter().map(|contact| model.parts[contact.part].name.text.as_str()).collect();
    assert_eq!(parts, ["left", "left", "wall[0]", "wall[1]"]);
    let mut values = scattered(&model, 4);
    set(&model, &mut values, "left.tip", 8.0);
    assert_eq!(limits(&model, &values, "left.slip.f"), [[4.0, 4.0], [4.0, 4.0]]);
    assert_eq!(model.impacts, Impacts::Newton);
    assert_eq!(model.contacts[1].declared.uses.len(), 2);
}

#[test]
fn what_a_bound_reads_of_states_is_there() {
    let model = stone(
        "state warm: 1 = 2;
         rate warm = 0.1/(1 s);
         friction slip: rate(stone.x) within if t < 1 s then warm*grip else 2*warm*grip;",
    );
    let mut values = Values::of(&model);
    assert_eq!(limits(&model, &values, "slip"), [[6.0, 6.0], [6.0, 6.0]]);
    values.set(model.time, 2.0);
    assert_eq!(limits(&model, &values, "slip"), [[12.0, 12.0], [12.0, 12.0]]);
    assert_eq!(model.impacts, Impacts::Poisson);
}

#[test]
fn what_reads_parameters_alone_is_looked_at_later() {
    let model = stone(
        "param mu: 1 = 0.3;
         param loose: N = 2 N;
         unilateral tip: stone.a.y >= 0 { restitution: e; }
         unilateral top: stone.a.y <= 4 m { restitution: 0.5; }
         friction slip: rate(stone.a.x) within mu*reaction(tip);
         friction belt: rate(stone.angle) within -1 m*loose .. 2 m*grip;",
    );
    let values = Values::of(&model);
    let limits: Vec<(&str, &str, f64)> = model
        .limits
        .iter()
        .map(|limit| (limit.part.as_str(), limit.what.as_str(), values.at(&model, limit.value)))
        .collect();
    let expected =
        [("tip", "restitution", 0.5), ("slip", "factor of the bound", 0.3), ("belt", "lower limit", -2.0)];
    assert_eq!(limits, expected);
    let ranges = [Range::Share, Range::NotNegative, Range::NotPositive];
    assert!(model.limits.iter().map(|limit| limit.range).eq(ranges));
}

/// The push of a floor on a foot, and its friction, carried to the port; on the ground the opposite.
#[test]
fn what_a_contact_does_to_its_ports_is_observed() {
    let model = stone(
        "part foot(sole: frame, floor: frame) {
             unilateral gap: sole.y - floor.y >= 0;
             friction grip: rate(sole.x - floor.x) within 2 N;
         }
         foot left(stone.a, ground.o);
         observe left;",
    );
    let mut values = scattered(&model, 5);
    set(&model, &mut values, "left.gap", 7.0);
    set(&model, &mut values, "left.grip", -2.0);
    for (name, expected) in [("sole", [-2.0, 7.0]), ("floor", [2.0, -7.0])] {
        let force = output(&model, &values, &format!("left.force_on_{name}"));
        assert_near(force[0], expected[0], name);
        assert_near(force[1], expected[1], name);
    }
    // The forces go through the point of the sole.
    assert_near(output(&model, &values, "left.torque_on_sole")[0], 0.0, "torque");
}

/// Of a part's rows, one whose condition never holds is none, and one whose condition always holds has none. What reads them knows it.
#[test]
fn rows_of_a_part_that_never_exist_are_none() {
    let model = stone(
        "part stones(a: frame) {
            repeat k in 0..3 { unilateral floor[k]: a.y >= k*1 m { when: k > 0.5 and (k > 1.5 or a.x < 2 m); } }
        }
        stones three(stone.a);
        output pushes = reaction(three.floor[0]) + reaction(three.floor[2]);
        output open = if is_open(three.floor[0]) then 1 else 0;",
    );
    let found: Vec<(&str, bool)> =
        model.contacts.iter().map(|of| (of.name.as_str(), of.exists.is_some())).collect();
    assert_eq!(found, [("three.floor[1]", true), ("three.floor[2]", false)]);
    let mut values = scattered(&model, 3);
    set(&model, &mut values, "three.floor[2]", 5.0);
    assert_near(output(&model, &values, "pushes")[0], 5.0, "pushes");
    assert_near(output(&model, &values, "open")[0], 1.0, "open");
}
