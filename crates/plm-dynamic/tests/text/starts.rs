//! Where mechanisms begin: switches that are on from the start, bodies of which no start is declared.

use plm_dynamic::Mechanism;

/// A drawer that a latch would hold swings where the release is on from the start, and is held again where it ends beyond the latch.
#[test]
fn a_latch_that_is_released_from_the_start_is_open() {
    let text = "pub Caught {
        input trip: 1 = 1;
        ground { port o: (0, 0) m; }
        body drawer { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start x: 0.2 m, locked; }
        prismatic rail(ground.o, drawer.p) { stiffness: 100 N/m; }
        latch catch(ground.o, drawer.p) { position: 0.2 m; closed: 1; release: trip; }
        output drawer.x, catch.catches;
    }";
    let mut run = Mechanism::from_text(text).unwrap().start_with("Dop853:1e-10".parse().unwrap()).unwrap();
    run.step_to(0.1).unwrap();
    assert_eq!(run.output("catch.catches").unwrap(), 0.0);
    assert!((run.output("drawer.x").unwrap() - 0.2 * 1.0_f64.cos()).abs() < 1e-8);
}

/// A body of which no start is declared stands where its weld puts it, in a part too: at 0 deg it would pull the boom with it.
#[test]
fn a_welded_body_without_a_start_stands_with_what_holds_it() {
    let text = "pub Boom { gravity: 9.81 m/s^2; ground { port o: (0, 0) m; }
        body boom { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; port p: (-1, 0) m, angle: 30 deg; start angle: 90 deg; }
        body near { mass: 2 kg; inertia: 1 kg*m^2; port a: (0.1, 0) m; port b: (0.3, 0) m; }
        body far { mass: 9 kg; inertia: 1 kg*m^2; port b: (0, 0.4) m; }
        revolute pin(ground.o, boom.o); weld second(far.b, near.b); weld first(boom.p, near.a);
        counterweight disc(boom.p) { balances: 10 kg*m; arm: 0.5 m; } output boom.angle; }";
    let run = Mechanism::from_text(text).unwrap().start().unwrap();
    for (body, degrees) in [("boom", 90.0), ("near", 120.0), ("far", 120.0), ("disc.disc", 90.0 + 30.0)] {
        let angle = run.body(body).unwrap().angle.to_degrees();
        assert!((angle - degrees).abs() < 1e-9, "{body}: {angle}");
    }
}
