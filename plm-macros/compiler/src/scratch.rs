use crate::model::*;
use crate::span::Span;
use crate::units::*;
use plm_cas::*;
fn name(t: &str) -> Name { Name { text: t.into(), span: Span { source: 0, first: 0, last: 0 } } }
#[test]
fn dump() {
    let mut g = Graph::new();
    let time = g.symbol("t");
    let num = |g: &mut Graph, s: &str| { g.number(Number::parse_decimal(s).unwrap()) };
    let gravity = num(&mut g, "9.81");
    let sp = name("x").span;
    let start = |g: &mut Graph, v: &str, locked| { let n = g.number(Number::parse_decimal(v).unwrap()); Start { value: n, locked, given: true, span: sp } };
    let mut bodies = vec![];
    let mut pts = vec![];
    for (n, ports, ang) in [("arm", vec!["-0.5", "0.5"], "0.785398"), ("forearm", vec!["-1"], "0")] {
        let q = ["x", "y", "angle"].map(|c| g.symbol(&format!("{n}.{c}")));
        let v = ["vx", "vy", "omega"].map(|c| g.symbol(&format!("{n}.{c}")));
        let a = ["ax", "ay", "alpha"].map(|c| g.symbol(&format!("{n}.{c}")));
        let (s, c) = (g.sin(q[2]), g.cos(q[2]));
        let mut p = vec![];
        for px in ports {
            let px = if px.starts_with('-') { let k = num(&mut g, &px[1..]); g.neg(k) } else { num(&mut g, px) };
            let dx = g.mul(c, px); let dy = g.mul(s, px);
            pts.push((g.add(q[0], dx), g.add(q[1], dy)));
            p.push(Port { name: name("p"), at: [px, g.zero()], angle: g.zero(), used: true });
        }
        bodies.push(Body { name: name(n), mass: num(&mut g, "10"), mass_span: sp, inertia: num(&mut g, "0.01"), inertia_span: sp, q, v, a, centre: [g.zero(), g.zero()], ports: p,
            start: [start(&mut g, "0", false), start(&mut g, "0", false), start(&mut g, ang, true)], start_velocity: [start(&mut g, "0", false), start(&mut g, "0", false), start(&mut g, "0", false)] });
    }
    let mut rows = vec![];
    let z = g.zero();
    for (k, (a, b)) in [((z, z), pts[0]), (pts[1], pts[2])].into_iter().enumerate() {
        for (ax, (p, q)) in ["x", "y"].iter().zip([(a.0, b.0), (a.1, b.1)]) {
            let phi = g.sub(q, p);
            let nm = format!("{}.{ax}", ["shoulder", "elbow"][k]);
            let lambda = g.symbol(&format!("lambda.{nm}"));
            rows.push(Row { name: nm, part: k, phi, lambda, span: sp, unit: DisplayUnit::si(Dimension::NUMBER) });
        }
    }
    let outputs = vec![Output { name: name("shoulder.force"), components: vec![rows[0].lambda, rows[1].lambda], unit: DisplayUnit::si(Dimension::NUMBER) },
      Output { name: name("arm.angle"), components: vec![bodies[0].q[2]], unit: DisplayUnit::si(Dimension::NUMBER) }];
    let f = |b, p| FrameRef { body: b, port: p };
    let parts = vec![
        Part { name: name("shoulder"), kind: "revolute".into(), pair: Some(Pair::Revolute), frames: vec![f(None, 0), f(Some(0), 0)] },
        Part { name: name("elbow"), kind: "revolute".into(), pair: Some(Pair::Revolute), frames: vec![f(Some(0), 1), f(Some(1), 0)] }];
    let mut loads = vec![];
    let w = g.sub(bodies[1].v[2], bodies[0].v[2]); let d = num(&mut g, "9.549"); let tq = g.mul(d, w);
    let ntq = g.neg(tq);
    loads.push(Load { body: 0, part: 1, force: [z, z, tq] }); loads.push(Load { body: 1, part: 1, force: [z, z, ntq] });
    let model = Model { name: name("DoublePendulum"), visibility: "pub".into(), docs: vec!["The double pendulum.".into()], crate_path: "::plm".into(), graph: Graph::new(), time, gravity, stabilisation: Stabilisation::Projection,
        params: vec![], inputs: vec![], bodies, parts, rows, loads, ground: vec![], states: vec![], outputs, allowed: vec![] };
    let eq = crate::derive::derive(&model, &mut g);
    let prog = crate::formulate::formulate(&model, &eq, &mut g);
    let mut diags = crate::diag::Diagnostics::new();
    let vals = crate::check::defaults(&model, &g);
    let mut report = crate::report::Report::new(&model, &eq, &prog, &g, &vals);
    crate::check::check_reach(&model, &mut diags);
    crate::check::check_assembly(&model, &eq, &prog, &g, &mut report, &mut diags);
    println!("{report}");
    for d in diags.iter() { println!("{} {}", d.code, d.message); }
    let code = crate::emit::emit(&model, &g, &eq, &prog, &report);
    println!("{}", code.text());
}
