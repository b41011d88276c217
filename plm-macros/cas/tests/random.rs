//! Random expressions: every pass keeps values, the tape computes what the nodes say, and the same calls give the
//! same bytes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod support;

use plm_cas::{Expr, Graph, Machine, Tape, share};
use support::random::{Random, grow};
use support::{close, direct};

const SEEDS: std::ops::Range<u64> = 0..150;

/// What rounding may do to an output: some hundred operations on values near 1, and a hundred times what a change of
/// the inputs by two units in the last place does (some of these expressions are sines of large numbers).
fn tolerances(case: &Case, point: &[f64]) -> Vec<f64> {
    let values = |point: &[f64]| direct::nodes(&case.graph, &case.roots, &bindings(case, point));
    let base = values(point);
    let mut tolerances = vec![1e-12; base.len()];
    for i in 0..point.len() {
        let mut moved = point.to_vec();
        moved[i] = moved[i].next_up().next_up();
        for (tolerance, (a, b)) in tolerances.iter_mut().zip(base.iter().zip(values(&moved))) {
            *tolerance += 100.0 * (a - b).abs();
        }
    }
    tolerances
}

struct Case {
    graph: Graph,
    symbols: Vec<Expr>,
    roots: Vec<Expr>,
    points: Vec<Vec<f64>>,
}

fn case(seed: u64, size: usize) -> Case {
    let mut random = Random(seed);
    let mut graph = Graph::new();
    let symbols: Vec<Expr> = ["a", "b", "c", "d", "e"].iter().map(|name| graph.symbol(name)).collect();
    let pool = grow(&mut graph, &mut random, &symbols, size);
    let roots = (0..8).map(|_| *random.one_of(&pool)).chain(pool.last().copied()).collect();
    let points = (0..4).map(|_| symbols.iter().map(|_| random.between(-1.5, 1.5)).collect()).collect();
    Case { graph, symbols, roots, points }
}

fn bindings(case: &Case, point: &[f64]) -> Vec<(Expr, f64)> {
    case.symbols.iter().copied().zip(point.iter().copied()).collect()
}

#[test]
fn the_tape_computes_what_the_nodes_say() {
    for seed in SEEDS {
        let case = case(seed, 30);
        let tape = Tape::new(&case.graph, &case.roots);
        for point in &case.points {
            let tolerances = tolerances(&case, point);
            let expected = direct::nodes(&case.graph, &case.roots, &bindings(&case, point));
            let found = tape.eval(&bindings(&case, point)).unwrap();
            for (i, (a, b)) in expected.iter().zip(&found).enumerate() {
                assert!(
                    close(*a, *b, tolerances[i]),
                    "seed {seed}, root {i}: {a} {b}\n{}",
                    case.graph.sexpr(case.roots[i])
                );
            }
        }
    }
}

#[test]
fn sharing_keeps_values_and_saves_operations() {
    let (mut before_all, mut after_all) = (0, 0);
    for seed in SEEDS {
        let mut case = case(seed, 40);
        let plain = Tape::new(&case.graph, &case.roots);
        let shared_roots = share(&mut case.graph, &case.roots);
        let shared = Tape::new(&case.graph, &shared_roots);
        for point in &case.points {
            let tolerances = tolerances(&case, point);
            let expected = plain.eval(&bindings(&case, point)).unwrap();
            let found = shared.eval(&bindings(&case, point)).unwrap();
            for (i, (a, b)) in expected.iter().zip(&found).enumerate() {
                assert!(close(*a, *b, tolerances[i]), "seed {seed}, root {i}: {a} {b}");
            }
        }
        // A division may be exchanged for a product or two; it costs more than both.
        let cost = |tape: &Tape| tape.count().total() + 3 * tape.count().operations.div as usize;
        // The choice is greedy: against what the tape merges by itself it can lose an operation or two.
        assert!(cost(&shared) <= cost(&plain) + 2, "seed {seed}: {} -> {}", plain.count(), shared.count());
        before_all += cost(&plain);
        after_all += cost(&shared);
    }
    println!("operations {before_all} -> {after_all}");
    assert!(after_all * 100 < before_all * 95);
}

#[test]
fn the_same_calls_give_the_same_bytes() {
    let run = |seed| {
        let mut case = case(seed, 40);
        let symbols = case.symbols.clone();
        let slopes: Vec<Expr> = case.roots.iter().map(|&root| case.graph.diff(root, symbols[0])).collect();
        let shared = share(&mut case.graph, &slopes);
        format!("{:?} {:?}", shared, Tape::new(&case.graph, &shared))
    };
    for seed in 0..20 {
        assert_eq!(run(seed), run(seed));
    }
}

#[test]
fn a_machine_runs_many_times_like_once() {
    let case = case(7, 40);
    let tape = Tape::new(&case.graph, &case.roots);
    let mut machine = Machine::new(&tape, &case.symbols).unwrap();
    let mut outputs = vec![0.0; tape.outputs.len()];
    for point in case.points.iter().chain(&case.points) {
        machine.run(point, &mut outputs);
        let once = tape.eval(&bindings(&case, point)).unwrap();
        assert!(outputs.iter().zip(&once).all(|(a, b)| a.to_bits() == b.to_bits()));
        assert!(tape.outputs.iter().zip(&once).all(|(at, b)| machine.value(*at).to_bits() == b.to_bits()));
    }
}

#[test]
fn substitution_commutes_with_evaluation() {
    for seed in SEEDS {
        let mut case = case(seed, 30);
        let [a, b] = [case.symbols[0], case.symbols[1]];
        let product = case.graph.mul(b, b);
        let new = case.graph.sin(product);
        let replaced = case.graph.substitute(&case.roots, &[(a, new)]);
        assert!(!case.graph.symbols(&replaced).contains(&a));
        for point in &case.points {
            let mut moved = point.clone();
            moved[0] = (point[1] * point[1]).sin();
            let tolerances = tolerances(&case, &moved);
            let expected = direct::nodes(&case.graph, &case.roots, &bindings(&case, &moved));
            let found = direct::nodes(&case.graph, &replaced, &bindings(&case, point));
            for (i, (a, b)) in expected.iter().zip(&found).enumerate() {
                assert!(close(*a, *b, tolerances[i]), "seed {seed}: {a} {b}");
            }
        }
    }
}

#[test]
fn what_is_printed_in_prefix_form_reads_back() {
    for seed in SEEDS {
        // Defined atoms read back as atoms, and all of the stream bear the name d.
        let mut case = case(seed, 12);
        for &root in &case.roots {
            let text = case.graph.sexpr(root);
            if !text.contains(" d)") && !text.contains(" d ") && text != "d" {
                assert_eq!(case.graph.parse_sexpr(&text).unwrap(), root, "seed {seed}: {text}");
            }
        }
    }
}
