//! Random sequences of gestures: no name dangles, and all of them can be taken back.

use plm_draw::{
    Dimension, Drag, Edit, End, Gesture, Picture, PortName, Sheet, TOOLS, Typed, applied, draw, inverse,
    layout,
};

use crate::support::{Compiled, Draws, compiled};

/// Seeds of sequences.
const SEQUENCES: u64 = 200;
/// Gestures of each.
const LENGTH: usize = 15;

/// Texts to begin with.
const TEXTS: [&str; 4] = [
    "",
    "// A comment alone.\n",
    "pub Crank {
    let speed = 60 rev/min; // of the shaft
    ground { port o: (0, 0) mm; port d: (300, 0) mm; }
    // The crank.
    body crank { mass: 1 kg; inertia: rod(1 kg, 100 mm); port a: (-50, 0) mm; port b: (50, 0) mm; start angle: 60 deg; }
    body coupler { mass: 1 kg; inertia: 0.01 kg*m^2; port b: (0, 0) mm; port c: (250, 0) mm; port tip: (125, 60) mm; start angle: 20 deg; }
    /// Swings.
    body rocker { mass: 1 kg; inertia: 0.01 kg*m^2; port d: 0; port c: (200, 0) mm; start x: 300 mm; start angle: 100 deg; }
    revolute o(ground.o, crank.a); revolute b(crank.b, coupler.b);
    revolute c(coupler.c, rocker.c);
    revolute d(ground.d, rocker.d) { damping: 0.1 N*m*s; }
    constraint turns: crank.angle = 60 deg + speed*t;
    output coupler.tip.position, rocker.angle in deg, d.torque;
    observe rocker;
}
",
    "pub Chain { gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m;
        port p: (1, 1) m; }
    repeat i in 0..3 { body bar[i] { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.2, 0) m; port b: (0.2 m, 0); start x: 0.2 m + 0.4 m*i; } }
    revolute hook(ground.o, bar[0].a);
    repeat i in 1..3 { revolute pin[i](bar[i - 1].b, bar[i].a); }
    output bar[2].b.position; }
",
];

/// Diagnostics of names that are not there.
fn dangling(found: &Compiled) -> Vec<&String> {
    let is_unknown =
        |code: &str| matches!(code, "E0201" | "E0202" | "E0203" | "E0204" | "E0205" | "E0206" | "E0213");
    found.problems.iter().filter(|(code, _)| is_unknown(code)).map(|(_, text)| text).collect()
}

/// Names of things that a hand can take away.
fn things(text: &str) -> Vec<String> {
    let words = ["body", "revolute", "spring", "constraint", "let", "weld", "pin_slot", "prismatic"];
    let lines = text.split([';', '{', '}', '\n']).map(str::trim);
    let names = lines.filter_map(|line| {
        let (word, rest) = line.split_once(' ')?;
        let name: String =
            rest.chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect();
        (words.contains(&word) && !name.is_empty()).then_some(name)
    });
    names.collect()
}

/// A gesture on a text, half of the time on special places: equal ones, mirrored ones, on an axis.
fn gesture(draws: &mut Draws, text: &str, picture: &Picture) -> Gesture {
    let grid = 1e-3;
    let places: Vec<_> = picture.ports.iter().map(|port| (port.name.clone(), port.at)).collect();
    let missing = (PortName::new("nothing", "a"), [0.0, 0.0]);
    let mut pick = || draws.of(&places).unwrap_or(&missing).clone();
    let [(port, at), (other, there)] = [pick(), pick()];
    let by = [0.1 * draws.number(), 0.1 * draws.number()];
    let to = match draws.below(6) {
        0 => at,
        1 => there,
        2 => [at[0], -at[1]],
        _ => [at[0] + by[0], at[1] + by[1]],
    };
    let free = draws.below(4) == 0;
    let drag = Drag { port: port.clone(), to, grid, free };
    let mut end = |port: &PortName, at: [f64; 2]| match draws.below(4) {
        0 => End::Point(to),
        1 => End::Ground([at[0] + by[0], at[1] + by[1]]),
        _ => End::Port(port.clone()),
    };
    let ends = [end(&port, at), end(&other, there)];
    let names = things(text);
    let name = draws.of(&names).cloned().unwrap_or_default();
    let dimensions = [Dimension::X, Dimension::Y, Dimension::Length, Dimension::Angle];
    match draws.below(20) {
        17 => Gesture::Mirror { port, grid },
        18 => Gesture::Copy { body: port.owner, by, grid },
        19 if free => Gesture::Unlock { port, dimension: dimensions[draws.below(4)] },
        19 => Gesture::Lock { port, dimension: dimensions[draws.below(4)] },
        14 => Gesture::Groove { port, body: other.owner, grid },
        15 => Gesture::Port { body: port.owner, end: ends[1].clone(), grid },
        16 => Gesture::Port { body: port.owner, end: End::Point(to), grid },
        12 => Gesture::Slide { port, toward: to, grid },
        13 => Gesture::Unpin { port },
        0..3 => Gesture::Drag(drag),
        3..5 => Gesture::Bar { ends, grid },
        5 if free => Gesture::GroundPoint { at: to, grid },
        5 => Gesture::Ground { port, grid },
        6 => Gesture::Merge { drag, onto: other },
        7 => Gesture::Motor { body: port.owner },
        8 => {
            let tool = draws.of(&TOOLS).map_or("", |tool| tool.word).to_owned();
            Gesture::Join { tool, ports: [port, other], grid }
        }
        9 => Gesture::Delete { name },
        10 if free => Gesture::RenamePort { from: port, to: format!("end{}", draws.below(1000)) },
        10 if draws.below(2) == 0 => Gesture::DeletePort { port },
        10 => Gesture::Rename { from: name, to: format!("part{}", draws.below(1000)) },
        _ => {
            let dimension = *draws.of(&dimensions).unwrap();
            let text = ["100", "0", "-7.5", "30 mm", "45 deg", "1e2", "x", ""][draws.below(8)].to_owned();
            Gesture::Typed(Typed { port, dimension, text, grid })
        }
    }
}

/// A picture of a text that does not compile: all of its ports, in a row.
fn in_a_row(text: &str) -> Picture {
    let handles = Sheet::read(text, None).handles().into_iter().map(|handle| handle.name).collect::<Vec<_>>();
    let place =
        |(k, name): (usize, PortName)| plm_draw::Placed { name, at: [0.1 * k as f64, 0.0], angle: 0.0 };
    Picture { ports: handles.into_iter().enumerate().map(place).collect() }
}

/// Counts of a sequence: gestures that were drawn, those that were refused, texts with a mechanism.
fn sequence(seed: u64) -> [usize; 3] {
    let [mut done, mut refused, mut assembled] = [0; 3];
    let mut draws = Draws(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let first = TEXTS[draws.below(TEXTS.len())].to_owned();
    let (mut text, mut undo): (String, Vec<Vec<Edit>>) = (first.clone(), Vec::new());
    let mut picture = compiled(&text).picture.unwrap_or_else(|| in_a_row(&text));
    for _ in 0..LENGTH {
        let gesture = gesture(&mut draws, &text, &picture);
        let Ok(drawn) = draw(&Sheet::read(&text, None), &picture, &gesture) else {
            refused += 1;
            continue;
        };
        let made = applied(&text, &drawn.edits);
        let after = compiled(&made);
        let what = format!("seed {seed}, {gesture:?}\n{text}\n{made}");
        assert_eq!(dangling(&after), Vec::<&String>::new(), "{what}");
        if layout::formatted(&text).as_ref() == Ok(&text) {
            assert_eq!(layout::formatted(&made).as_ref(), Ok(&made), "{what}");
        }
        undo.push(inverse(&text, &drawn.edits));
        (text, done) = (made, done + 1);
        assembled += usize::from(after.picture.is_some());
        picture = after.picture.unwrap_or_else(|| in_a_row(&text));
    }
    for edits in undo.iter().rev() {
        text = applied(&text, edits);
    }
    assert_eq!(text, first, "seed {seed}");
    [done, refused, assembled]
}

/// Odd seeds beside even ones: this test is the longest of its program.
#[test]
fn no_name_dangles_and_all_is_undone() {
    let counts = |first| (first..=SEQUENCES).step_by(2).map(sequence).fold([0; 3], sums);
    let [done, refused, assembled] = std::thread::scope(|scope| {
        let beside = scope.spawn(|| counts(1));
        sums(counts(2), beside.join().unwrap())
    });
    println!("{done} gestures, {refused} refused, {assembled} texts with a mechanism");
    assert!(done > 800 && assembled > done / 2, "{done} {assembled}");
}

fn sums(one: [usize; 3], other: [usize; 3]) -> [usize; 3] {
    std::array::from_fn(|k| one[k] + other[k])
}
