//! Why loops have no form: what is said where one is asked for.

use std::fmt::Write;

use plm_compiler::compile;
use plm_compiler::token::Sources;

use crate::scene::Random;

/// A ring of bodies of which the first is the ground, with pivots across, all closed as they are drawn.
fn ring(bodies: usize, across: &[[usize; 2]]) -> String {
    let mut random = Random(5);
    let around = (0..bodies).map(|k| [k, (k + 1) % bodies]);
    let joints: Vec<[usize; 2]> = around.chain(across.iter().copied()).collect();
    let mut ports = vec![String::new(); bodies];
    let mut text = String::new();
    for (k, pair) in joints.iter().enumerate() {
        let (x, y) = (random.unit(), random.unit());
        for &body in pair {
            write!(ports[body], "port p{k}: ({x:?}, {y:?}) m; ").unwrap();
        }
        let name = |body: usize| if body == 0 { "ground".to_owned() } else { format!("b{body}") };
        writeln!(text, "revolute j{k}({}.p{k}, {}.p{k});", name(pair[0]), name(pair[1])).unwrap();
    }
    let bodies = ports.iter().enumerate().map(|(body, ports)| match body {
        0 => format!("ground {{ {ports} }}\n"),
        _ => format!("body b{body} {{ mass: 1 kg; inertia: 0.1 kg*m^2; {ports} }}\n"),
    });
    format!("pub Ring {{ formulation: loops;\n{}{text} }}", bodies.collect::<String>())
}

fn told(text: &str) -> String {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    compile(&mut sources).diagnostics.sorted().iter().map(|d| d.render(&sources)).collect()
}

#[test]
fn loops_that_are_too_many_to_be_found_together_are_counted() {
    let across = [[0, 7], [2, 9], [4, 12], [6, 15], [8, 18], [10, 1], [14, 3], [16, 5]];
    // 19 bodies with 28 joints have one freedom and 9 loops of two equations each.
    let said = told(&ring(20, &across));
    let expected = "18 unknowns must be found together, more than the 8 that Newton's iteration takes";
    assert!(said.contains("E0505") && said.contains(expected), "{said}");
}
