//! Pictures that the text alone gives, against those of the compiler.

use plm_draw::{Placed, PortName, Sheet};

use crate::support::{compiled, machines};

fn away(one: &Placed, other: &Placed) -> f64 {
    (one.at[0] - other.at[0]).hypot(one.at[1] - other.at[1])
}

/// Ports whose place is not guessed stand where the compiler's picture has them.
#[test]
fn what_the_text_tells_is_where_it_is_assembled() {
    let (mut exact, mut guessed) = (0, 0);
    for (name, text) in machines() {
        let sketch = Sheet::read(&text, None).sketch();
        let picture = compiled(&text).picture.unwrap();
        for placed in &sketch.picture.ports {
            let Some(own) = picture.port(&placed.name) else { continue };
            if sketch.guessed.contains(&placed.name) {
                guessed += 1;
            } else {
                exact += 1;
                assert!(away(placed, own) < 1e-12, "{name}: {placed:?} {own:?}");
            }
        }
    }
    println!("{exact} places are exact, {guessed} are guessed");
    assert!(exact > 30 && guessed > 100, "{exact} {guessed}");
}

/// A body in its own axes stands at the pin that holds it, and in a chain each at the one before.
#[test]
fn a_chain_hangs_by_its_pins() {
    let text = "\
pub P {
    ground { port o: (1, 2) m; }
    body one { mass: 1 kg; inertia: 1 kg*m^2; port a: (-5, 0) cm; port b: (5, 0) cm; start angle: 90 deg; }
    body two { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (0, 20) cm; start angle: -90 deg; }
    body lost { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; }
    revolute o(ground.o, one.a);
    revolute b(one.b, two.b);
    revolut c((";
    let sketch = Sheet::read(text, None).sketch();
    let at =
        |owner: &str, port: &str| sketch.picture.port(&PortName::new(owner, port)).map(|placed| placed.at);
    let near = |found: Option<[f64; 2]>, x: f64, y: f64| {
        found.is_some_and(|at| (at[0] - x).hypot(at[1] - y) < 1e-12)
    };
    assert!(near(at("ground", "o"), 1.0, 2.0) && near(at("one", "b"), 1.0, 2.1), "{sketch:?}");
    assert!(near(at("two", "c"), 1.2, 2.1), "{sketch:?}");
    assert_eq!(at("lost", "a"), None);
    assert_eq!(sketch.parts.iter().map(|part| &*part.name).collect::<Vec<_>>(), ["o", "b"]);
    assert_eq!(Sheet::read("", None).sketch().picture.ports, []);
}
