//! Derivatives of outputs by every method, against a closed form.

use plm_dynamic::{By, Integrator, Mechanism};

/// y = a cos(w t) with w^2 = k/m, and its derivatives.
#[test]
fn derivatives_are_those_of_the_closed_form() {
    let block = Mechanism::from_text(
        "pub Block {
            param load: kg = 2 kg;
            input push: N = 0;
            ground { port o: (0, 0) m; }
            body block { mass: load; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0.3 m, locked; }
            prismatic rail(ground.o, block.o) { stiffness: 40 N/m; drive: push; }
            output block.x in mm;
        }",
    )
    .unwrap();
    let w = 20.0_f64.sqrt();
    // Of each method the largest errors of value and derivative, absolute.
    let methods = [
        ("Dop853:1e-11", 1e-9, 1e-8),
        ("Vern9:1e-11", 1e-9, 1e-8),
        ("Adams:1e-11", 1e-9, 1e-8),
        ("Dopri5:1e-11", 1e-9, 1e-8),
        ("RadauIia5:1e-10", 1e-8, 1e-7),
        ("Rk4:1e-3", 1e-9, 1e-8),
        ("Gauss2:1e-3", 1e-9, 1e-8),
        ("Gauss3:1e-3", 1e-9, 1e-8),
        ("Ros34Pw2:1e-3", 1e-7, 1e-6),
        ("SemiImplicitEuler:1e-4", 1e-3, 1e-3),
        ("MoreauJean:1e-4", 1e-3, 1e-3),
    ];
    let closed: [(By, &dyn Fn(f64) -> f64); 3] = [
        (By::Parameter(0), &|t| 0.3 * t * (w * t).sin() * w / 4.0),
        (By::Start(0), &|t| (w * t).cos()),
        (By::Input(0), &|t| (1.0 - (w * t).cos()) / 40.0),
    ];
    assert_eq!(methods.len(), Integrator::names().count());
    for ((by, slope), (method, of_value, of_slope)) in
        closed.iter().flat_map(|own| methods.map(|method| (*own, method)))
    {
        let method: Integrator = method.parse().unwrap();
        let found = block.derivative(by, method, (1.0, 0.1), &[0], &mut || true).unwrap();
        assert_eq!(found.times.len(), 11);
        for ((t, y), dy) in found.times.iter().zip(&found.values[0]).zip(&found.slopes[0]) {
            let errors = [y - 0.3 * (w * t).cos(), dy - slope(*t)].map(f64::abs);
            assert!(errors[0] < of_value && errors[1] < of_slope, "{method:?} {by:?} {t} {errors:?}");
        }
    }
}
