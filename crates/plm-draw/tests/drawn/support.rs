//! Texts, pictures of them, and draws from a seed.

use std::fs;
use std::path::Path;

use plm_compiler::analyse;
use plm_compiler::token::Sources;
use plm_draw::lexer::tokens;
use plm_draw::{Picture, Placed, PortName};

/// A text, compiled.
pub(crate) struct Compiled {
    /// Its ports at the assembled start; none where there is no mechanism.
    pub(crate) picture: Option<Picture>,
    /// Codes and messages of its diagnostics.
    pub(crate) problems: Vec<(String, String)>,
}

pub(crate) fn compiled(text: &str) -> Compiled {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let expansion = analyse(&mut sources);
    let problems = expansion.diagnostics.sorted().into_iter();
    let problems = problems.map(|of| (of.code.id().to_owned(), of.render(&sources))).collect();
    let Some(oracle) = expansion.oracle else { return Compiled { picture: None, problems } };
    let picture = oracle.picture();
    let ground = picture.ground.iter().map(|port| Placed {
        name: PortName::new("ground", &port.name),
        at: [port.place[0], port.place[1]],
        angle: 0.0,
    });
    let of_bodies = picture.bodies.iter().flat_map(|body| {
        let [x, y, angle] = body.pose;
        let (sin, cos) = angle.sin_cos();
        body.ports.iter().map(move |port| {
            let [px, py, _] = port.place;
            let at = [x + cos * px - sin * py, y + sin * px + cos * py];
            Placed { name: PortName::new(&body.name, &port.name), at, angle }
        })
    });
    Compiled { picture: Some(Picture { ports: ground.chain(of_bodies).collect() }), problems }
}

/// The text in the first `mechanism! { … }` of a Rust file.
fn declaration(text: &str) -> String {
    let all = tokens(text);
    let begin = all.windows(3).position(|three| {
        three[0].text(text) == "mechanism" && three[1].is_mark(text, '!') && three[2].is_mark(text, '{')
    });
    let open = begin.map_or(0, |at| at + 2);
    let (mut depth, start) = (0, all[open].range.end);
    for token in &all[open..] {
        depth += i32::from(token.is_mark(text, '{')) - i32::from(token.is_mark(text, '}'));
        if depth == 0 {
            return text[start..token.range.start].to_owned();
        }
    }
    String::new()
}

/// The machines of the gallery by name, in their layout.
pub(crate) fn machines() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/gallery/machines");
    let mut all = Vec::new();
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        if name != "mod" {
            let text =
                plm_draw::layout::formatted(&declaration(&fs::read_to_string(&path).unwrap())).unwrap();
            all.push((name, text));
        }
    }
    all.sort();
    assert_eq!(all.len(), 13, "machines of the gallery");
    all
}

/// Numbers of a seed (G. Marsaglia, Xorshift RNGs, Journal of Statistical Software 8, 2003).
pub(crate) struct Draws(pub(crate) u64);

impl Draws {
    pub(crate) fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 16) as usize % count.max(1)
    }

    pub(crate) fn of<'a, T>(&mut self, all: &'a [T]) -> Option<&'a T> {
        let at = self.below(all.len());
        all.get(at)
    }

    /// From -1 to 1, and half of the time a special one.
    pub(crate) fn number(&mut self) -> f64 {
        match self.below(8) {
            0 | 1 => 0.0,
            2 => 1.0,
            3 => -1.0,
            _ => self.below(2001) as f64 / 1000.0 - 1.0,
        }
    }
}
