//! Rows of parts: read by index, and with bounds that Rust knows as well.
#![allow(clippy::unwrap_used, missing_docs, unreachable_pub, reason = "tests")]

/// A chain of `$bars` bars of `$length` m in all, and how many they are.
macro_rules! chain {
    ($module:ident, $bars:expr, $length:expr, $($more:tt)*) => {
        mod $module {
            #[allow(dead_code)] // of the scene in absolute coordinates
            pub const BARS: usize = $bars;

            plm::mechanism! {
                pub Chain {
                    gravity: 9.81 m/s^2;
                    $($more)*
                    ground { port o: (0, 0) m; }
                    repeat i in 0..$bars {
                        let reach = $length m/$bars/2;
                        body bar[i] {
                            mass: 1 kg/$bars;
                            inertia: 1 kg*m^2/(12*$bars^3);
                            port a: (-reach, 0 m);
                            port b: (reach, 0 m);
                            start x: (i + 0.5)*$length m/$bars;
                        }
                        output bar[i].angle in deg, lean[i] = bar[i].angle, tip[i] = bar[i].b.position;
                    }
                    revolute pin[0](ground.o, bar[0].a);
                    repeat i in 1..$bars { revolute pin[i](bar[i - 1].b, bar[i].a); }
                }
            }
        }
    };
}

chain!(four, 4, 1.0,);
chain!(five, 2 + 3, 0.5 + 1.5,);
chain!(absolute, 3, 1.5, formulation: absolute;);

#[test]
fn bodies_and_outputs_are_read_by_index() {
    let mut sim = four::Chain::new().start().unwrap();
    sim.step(0.3).unwrap();
    let bodies = [sim.bar_0(), sim.bar_1(), sim.bar_2(), sim.bar_3()];
    let angles = [sim.bar_0_angle(), sim.bar_1_angle(), sim.bar_2_angle(), sim.bar_3_angle()];
    let tips = [sim.tip_0(), sim.tip_1(), sim.tip_2(), sim.tip_3()];
    for i in 0..four::BARS {
        assert_eq!(sim.bar(i), Some(bodies[i]));
        assert_eq!(
            (sim.bar_angle(i), sim.lean(i), sim.tip(i)),
            (Some(angles[i]), Some(angles[i]), Some(tips[i]))
        );
    }
    assert!(bodies.windows(2).all(|two| two[0] != two[1]));
    for wrong in [four::BARS, usize::MAX] {
        assert!(sim.bar(wrong).is_none() && sim.bar_angle(wrong).is_none() && sim.tip(wrong).is_none());
    }
    // In absolute coordinates the bodies stand in the state itself.
    let mut sim = absolute::Chain::new().start().unwrap();
    sim.step(0.3).unwrap();
    assert_eq!(
        (0..4).map(|i| sim.bar(i)).collect::<Vec<_>>(),
        [Some(sim.bar_0()), Some(sim.bar_1()), Some(sim.bar_2()), None]
    );
}

/// What a macro captures is one operand: `2 + 3` bars are five, of `(0.5 + 1.5)/5` m each.
#[test]
fn numbers_come_by_the_arguments_of_a_macro() {
    assert_eq!(five::BARS, 5);
    let sim = five::Chain::new().start().unwrap();
    for i in 0..five::BARS {
        let expected = (i as f64 + 0.5) * 2.0 / 5.0;
        assert!((sim.bar(i).unwrap().x - expected).abs() < 1e-15, "{i}");
        assert!((sim.tip(i).unwrap()[0] - expected - 0.2).abs() < 1e-15, "{i}");
    }
    assert!(sim.bar(five::BARS).is_none());
}

/// Operands as Rust reads them, and units after them.
macro_rules! numbers {
    ($sum:expr, $negative:literal, $path:expr, $pair:expr) => {
        plm::mechanism! {
            pub Numbers {
                allow(W0002);
                let arm_length = $sum m;
                body one { mass: 1 kg; inertia: 1 kg*m^2; port a: $pair m; start x: 2 m; start angle: $sum deg, locked; }
                output product = 2*$sum*$sum;
                output less = 10 - $sum;
                output power = $negative^2;
                output below = $negative m/s;
                output quotient = 1/$sum;
                output of_path = $path;
                output length = arm_length;
                output place = one.a.position;
            }
        }
    };
}

numbers!(1.5 + 0.5, -3, one.x, (1 + 1, 0.5));

#[test]
fn what_a_macro_captures_is_one_operand() {
    let sim = Numbers::new().start().unwrap();
    let found =
        [sim.product(), sim.less(), sim.power(), sim.below(), sim.quotient(), sim.of_path(), sim.length()];
    assert_eq!(found, [8.0, 8.0, 9.0, -3.0, 0.5, 2.0, 2.0]);
    assert!((sim.one().angle - 2_f64.to_radians()).abs() < 1e-15);
}

plm::mechanism! {
    /// Two indices, parts inside, and names that meet.
    pub Grid {
        allow(W0002);
        part leg(a: frame) {
            body foot { mass: 1 kg; inertia: 1 kg*m^2; port k: (0, 0) m; start x: 3 m; }
            weld hold(a, foot.k);
            output side = foot.x;
        }
        repeat i in 0..2 {
            repeat j in 1..3 {
                body node[i][j] { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; start x: (i + 10*j)*1 m, locked; }
                leg stand[i][j](node[i][j].a);
                output stand[i][j].side;
            }
        }
        body step[0] { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; }
        body twin { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; start y: 7 m; }
        body twin[0] { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; start y: 8 m; }
    }
}

#[test]
fn indices_stand_in_the_order_of_the_path() {
    let mut sim = Grid::new().start().unwrap();
    for (i, j) in [(0, 1), (1, 2), (0, 2), (1, 1)] {
        let x = (i + 10 * j) as f64;
        assert_eq!(sim.node(i, j).unwrap().x, x);
        assert_eq!(sim.stand_foot(i, j).unwrap().x, x);
        assert_eq!(sim.stand_side(i, j), Some(x));
    }
    assert!(sim.node(0, 0).is_none() && sim.node(2, 1).is_none());
    // A name that something else has stays with that.
    assert_eq!((sim.twin().y, sim.twin_0().y), (7.0, 8.0));
    sim.step(0.1).unwrap();
    assert_eq!(sim.step_0().x, 0.0);
}
