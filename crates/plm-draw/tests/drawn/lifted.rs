//! A lifted text with its parameters set is the text that the same drag makes.

use plm_draw::{Drag, Gesture, Sheet, applied, draw, lift};
use plm_dynamic::Mechanism;

use crate::support::{compiled, machines};

/// Poses of all bodies at the start.
fn poses(mechanism: &Mechanism) -> Vec<[f64; 3]> {
    let run = mechanism.start().unwrap();
    let bodies: Vec<String> = run.bodies().map(str::to_owned).collect();
    let of = |name: &String| {
        let body = run.body(name).unwrap();
        [body.x, body.y, body.angle]
    };
    bodies.iter().map(of).collect()
}

/// Both are assembled from starts that differ in the last bits, and assembly ends where its residual is below rounding.
#[test]
fn parameters_of_a_lifted_text_make_the_dragged_one() {
    let mut count = 0;
    for (machine, text) in &machines() {
        let picture = compiled(text).picture.unwrap();
        let sheet = Sheet::read(text, None);
        // One pin of each body, which is enough to meet every form of writing.
        let mut owners = Vec::new();
        for handle in sheet.handles() {
            if handle.turns > 1 || owners.contains(&handle.name.owner) {
                continue;
            }
            let at = picture.port(&handle.name).unwrap().at;
            let to = [at[0] + 0.008, at[1] - 0.003];
            let drag = Drag { port: handle.name.clone(), to, grid: 1e-3, free: false };
            let Ok(drawn) = draw(&sheet, &picture, &Gesture::Drag(drag.clone())) else { continue };
            owners.push(handle.name.owner.clone());
            let lifted = lift(&sheet, &picture, &Drag { to: at, ..drag }).unwrap();
            let mut mechanism = Mechanism::from_text(&lifted.text)
                .unwrap_or_else(|why| panic!("{machine} {}: {why}\n{}", handle.name, lifted.text));
            assert_eq!(lifted.parameters.len(), drawn.values.len(), "{machine} {}", handle.name);
            for (name, value) in lifted.parameters.iter().zip(&drawn.values) {
                mechanism.set_parameter(name, *value).unwrap();
            }
            let made = Mechanism::from_text(&applied(text, &drawn.edits)).unwrap();
            for (found, expected) in poses(&mechanism).iter().zip(poses(&made)) {
                for (found, expected) in found.iter().zip(expected) {
                    let tolerance = 1e-12 * expected.abs().max(1.0);
                    assert!(
                        (found - expected).abs() <= tolerance,
                        "{machine} {}: {found} {expected}",
                        handle.name
                    );
                }
            }
            count += 1;
        }
    }
    println!("{count} drags");
    assert!(count > 40, "{count}");
}
