//! Equilibria of mechanisms from text: the bits of compiled ones.

use plm::Stabilise;
use plm::dynamic::{Compiled, Small};
use plm::runtime::Described;

use crate::analysis_scenes as scenes;

/// Mechanisms from text come to rest where compiled ones do, on the same rows.
#[test]
fn equilibria_of_texts_are_those_of_compiled_code() {
    fn found<M: Stabilise>(of: M) -> String {
        let found = of.stabilise().unwrap();
        let supports = found.supports.iter().map(|support| (support.name, support.force, support.used));
        format!("{:?}", (&found.values, &found.free, found.iterations, supports.collect::<Vec<_>>()))
    }
    fn same<M: Stabilise + Described>(mechanism: M) {
        let text: Small = Compiled::new("scene.plm", M::DECLARATION).unwrap().mechanism().unwrap();
        assert_eq!(found(mechanism), found(text));
    }
    same(scenes::Slope::new());
    same(scenes::Ladder::new());
    same(scenes::Feet::new());
    same(scenes::wheel::least::Scene::new());
    same(scenes::wheel::absolute::Scene::new());
}
