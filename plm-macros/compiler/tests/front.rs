//! The front end on whole declarations.
#![allow(clippy::unwrap_used, clippy::panic)]

use plm_compiler::diag::Diagnostics;
use plm_compiler::front::parse_and_resolve;
use plm_compiler::model::Model;
use plm_compiler::token::Sources;

fn resolve(text: &str) -> Model {
    let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
    sources.add_text("declaration", text);
    let model = parse_and_resolve(&mut sources, &mut sink);
    let messages: Vec<String> = sink.sorted().iter().map(|diagnostic| diagnostic.render(&sources)).collect();
    assert!(messages.is_empty(), "{}", messages.join("\n"));
    model.unwrap()
}

const DOUBLE_PENDULUM: &str = "
    /// The double pendulum of the manual, section 2.2.
    pub DoublePendulum {
        gravity: 9.81 m/s^2;
        ground { port o0: (0, 0) m; }
        body arm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port o0:  (-0.5, 0) m;
            port p12: ( 0.5, 0) m;
            start angle: 45 deg, locked;
        }
        body forearm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port p12: (-1, 0) m;
            start angle: 0 deg, locked;
        }
        revolute shoulder(ground.o0, arm.o0)    { damping: 1 N*m/(rev/min); }
        revolute elbow(arm.p12, forearm.p12)    { damping: 1 N*m/(rev/min); }
        output shoulder.force, elbow.force, arm.angle in deg;
    }";

#[test]
fn the_double_pendulum_resolves() {
    let model = resolve(DOUBLE_PENDULUM);
    for row in &model.rows {
        println!("{} = {}", row.name, model.graph.display(row.phi));
    }
    for load in &model.loads {
        println!("{} {:?}", load.body, load.force.map(|f| model.graph.display(f).to_string()));
    }
    for output in &model.outputs {
        println!("{} {:?} {}", output.name.text, output.components, output.unit.text);
    }
}
