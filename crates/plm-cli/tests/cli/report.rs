//! `plm report`: equations of motion as LaTeX and MathML.

use super::{plm, root};

fn declaration(name: &str) -> String {
    let path = root().join("plm-macros/compiler/tests/written").join(name).with_extension("plm");
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn equations_are_latex_with_their_coordinates() {
    let said = plm(&["report", "--equations", "-"], &declaration("double_pendulum"));
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    let head = "% DoublePendulum\n% a.angle: $\\varphi_{a}$\n% b.angle: $\\varphi_{b}$\n\\[ ";
    assert!(said.output.starts_with(head), "{}", said.output);
    let both = plm(&["report", "--equations", "--json", "-"], "");
    assert!(both.code == 2 && both.errors.contains("one of --json, --equations and --mathml"), "{both:?}");
}

/// A reader that is not the writer's finds each equation whole.
#[test]
fn mathml_is_well_formed() {
    for name in ["double_pendulum", "slider_crank", "governor"] {
        let said = plm(&["report", "--mathml", "-"], &declaration(name));
        let equations: Vec<&str> =
            said.output.lines().filter(|line| line.starts_with("<math display")).collect();
        assert!(equations.len() >= 2, "{said:?}");
        for equation in equations {
            let read = roxmltree::Document::parse(equation).unwrap();
            assert!(
                read.descendants().any(|node| node.has_tag_name("mover"))
                    || equation.contains("cos")
                    || equation.contains("sin")
            );
        }
    }
}
