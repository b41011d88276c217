//! Bodies without mass, in random mechanisms that are driven: what compiles without masses does not depend on them.
//!
//! Constraints are added that prescribe some coordinates, and some bodies lose their masses. A body is refused if and only if it
//! can move. What no diagnostic names, poses, accelerations and reactions, is compared for two choices of the masses.

use std::fmt::Write as _;

use plm_compiler::diag::Code;
use plm_compiler::token::Sources;
use plm_compiler::{Expansion, compile};

use super::scene::{Random, Scene};
use super::{jacobian, rank};

/// Mass and inertia of a body, or none.
type Mass = Option<(f64, f64)>;

/// A scene with its drives.
struct Driven {
    scene: Scene,
    /// Coordinates that are prescribed, and their accelerations.
    drives: Vec<(usize, f64)>,
}

impl Driven {
    /// Prescribes all freedoms, or all but one.
    fn new(random: &mut Random) -> Option<Driven> {
        let bare = if random.below(3) == 0 { Scene::new(random) } else { Scene::sprung(random) };
        let mut scene = Driven { scene: bare, drives: Vec::new() };
        let q = scene.scene.poses();
        let masses = vec![Some((1.0, 0.1)); q.len() / 3];
        let (expansion, _) = scene.compiled(&masses, &[]);
        let mut rows = jacobian(expansion.oracle.as_ref()?, &q);
        let mut known = rank(rows.clone(), vec![0.0; q.len()])?.0;
        let wanted = q.len() - random.below(2);
        for k in (0..q.len()).rev() {
            let row: Vec<f64> = (0..q.len()).map(|column| f64::from(u8::from(column == k))).collect();
            rows.push(row);
            let with = rank(rows.clone(), vec![0.0; q.len()])?.0;
            if with > known && with <= wanted {
                known = with;
                scene.drives.push((k, random.between(0.5, 2.0)));
            } else {
                rows.pop();
            }
        }
        Some(scene)
    }

    fn text(&self, masses: &[Mass], outputs: &[String]) -> String {
        let mut text = self.scene.text();
        for (body, mass) in masses.iter().enumerate() {
            let name = format!("body b{} {{", body + 1);
            let written = mass.map_or(String::new(), |(mass, inertia)| {
                format!(" mass: {mass:?} kg; inertia: {inertia:?} kg*m^2;")
            });
            let usual = " mass: 1 kg; inertia: 0.1 kg*m^2;";
            text = text.replace(&format!("{name}{usual}"), &format!("{name}{written}"));
        }
        let _ = text.split_off(text.rfind('}').unwrap());
        let poses = self.scene.poses();
        for (k, (coordinate, rate)) in self.drives.iter().enumerate() {
            let (member, unit) = [("x", "m"), ("y", "m"), ("angle", "rad")][coordinate % 3];
            let (body, from) = (coordinate / 3 + 1, poses[*coordinate]);
            writeln!(
                text,
                "    constraint d{k}: b{body}.{member} = {from:?} {unit} + {rate:?} {unit}/s^2*t*t;"
            )
            .unwrap();
        }
        text += &outputs.concat();
        text + "}\n"
    }

    fn compiled(&self, masses: &[Mass], outputs: &[String]) -> (Expansion, Sources) {
        let mut sources = Sources::new();
        sources.add_text("declaration", &self.text(masses, outputs));
        (compile(&mut sources), sources)
    }
}

/// Names between the quotes of this list of the emitted layout.
fn listed(code: &str, list: &str) -> Vec<String> {
    let list = code.split(&format!("{list}: const {{")).nth(1).unwrap().split('}').next().unwrap();
    list.split('"').skip(1).step_by(2).map(str::to_owned).collect()
}

/// What the sweep saw.
#[derive(Debug, Default)]
struct Seen {
    free: usize,
    driven: usize,
    /// Reactions that are refused, and those that differ of them.
    refused: usize,
    differ: usize,
    /// Reactions that can be read.
    read: usize,
}

fn agree(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-8 * (1.0 + a.abs().max(b.abs()))
}

fn judge(random: &mut Random, seen: &mut Seen) -> Option<()> {
    let driven = Driven::new(random)?;
    let q = driven.scene.poses();
    let count = q.len() / 3;
    let chosen: Vec<bool> = (0..count).map(|_| random.below(3) > 0).collect();
    let with = |random: &mut Random| -> Vec<Mass> {
        let mass = |missing: &bool| {
            Some(if *missing { (random.between(0.2, 5.0), random.between(0.02, 0.5)) } else { (1.0, 0.1) })
        };
        chosen.iter().map(mass).collect()
    };
    let runs = [with(random), with(random)].map(|masses| driven.compiled(&masses, &[]).0);
    let [one, other] = runs.each_ref().map(|run| run.oracle.as_ref().unwrap());
    let joints = listed(&runs[0].code.as_ref()?.text(), "parts");
    let outputs: Vec<String> = joints
        .iter()
        .filter(|name| name.starts_with('d'))
        .map(|name| format!("    output {name} = reaction({name});\n"))
        .collect();
    let masses: Vec<Mass> = chosen.iter().map(|missing| (!missing).then_some((1.0, 0.1))).collect();
    let (bare, sources) = driven.compiled(&masses, &outputs);
    let jacobian = jacobian(one, &q);
    let known = rank(jacobian.clone(), vec![0.0; q.len()])?.0;
    let anywhere = q.iter().map(|_| random.unit()).collect();
    let v = rank(jacobian.clone(), anywhere)?.1;
    let moves = |body: usize| {
        let held = (0..3).map(|k| (0..q.len()).map(|c| f64::from(u8::from(c == 3 * body + k))).collect());
        rank(jacobian.iter().cloned().chain(held).collect(), vec![0.0; q.len()]).map(|found| found.0 > known)
    };
    let told: Vec<String> = bare
        .diagnostics
        .iter()
        .filter(|of| of.code == Code::MissingValue)
        .map(|of| of.message.clone())
        .collect();
    let about = || {
        let all: String = bare.diagnostics.sorted().iter().map(|of| of.render(&sources)).collect();
        format!("{}\n{all}", driven.text(&masses, &outputs))
    };
    let mut is_free = false;
    for body in (0..count).filter(|&body| chosen[body]) {
        let refused = told.iter().any(|text| text.starts_with(&format!("the body `b{}` moves", body + 1)));
        assert_eq!(refused, moves(body)?, "b{} of\n{}", body + 1, about());
        is_free |= refused;
    }
    if is_free {
        seen.free += 1;
        return Some(());
    }
    seen.driven += 1;
    let x = [&q[..], &v].concat();
    for (a, b) in one.charts(0.0, &x).iter().zip(other.charts(0.0, &x)) {
        assert_eq!(a.pose, b.pose, "{}", about());
        assert!(a.acceleration.iter().zip(&b.acceleration).all(|(a, b)| agree(*a, *b)), "{}", about());
    }
    let (a, b) = (one.dynamics(0.0, &x), other.dynamics(0.0, &x));
    let healthy = [a.last()?, b.last()?].into_iter().all(|health| *health > 1e-4);
    if !healthy {
        return Some(());
    }
    for k in 0..2 * q.len() {
        assert!(agree(a[k], b[k]), "rate {k}: {} and {} of\n{}", a[k], b[k], about());
    }
    for (row, name) in joints.iter().enumerate().filter(|(_, name)| name.starts_with('d')) {
        let refused = told.iter().any(|text| text.starts_with(&format!("the output `{name}` depends")));
        let differs = !agree(a[2 * q.len() + row], b[2 * q.len() + row]);
        assert!(refused || !differs, "{name} differs in\n{}", about());
        seen.refused += usize::from(refused);
        seen.differ += usize::from(refused && differs);
        seen.read += usize::from(!refused);
    }
    Some(())
}

#[test]
fn what_can_be_read_without_masses_does_not_depend_on_them() {
    let count = std::env::var("PLM_SWEEP").map_or(24, |text| text.parse().unwrap());
    let mut seen = Seen::default();
    for k in 0..count {
        // Next to a singular pose nothing can be told.
        let _ = judge(&mut Random((3 << 32) + k), &mut seen);
    }
    println!("{seen:?}");
    // The sweep means something only if it meets all kinds, and the analysis only if it refuses little that is known.
    assert!(seen.free > 3 && seen.driven > 3 && seen.read > 3, "{seen:?}");
    assert!(2 * seen.differ > seen.refused, "{seen:?}");
}
