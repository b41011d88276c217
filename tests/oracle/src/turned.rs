//! Text of a declaration whose whole mechanism is turned about the origin.

/// A declaration turned by an angle in deg; none where something in it is said in absolute axes that this does not turn.
pub(crate) fn turned(text: &str, by: f64) -> Option<String> {
    let by = format!("({by:?} deg)");
    let (head, mut rest) = text.split_once('{')?;
    let mut out = format!("{head}{{");
    let mut has_ground = false;
    while let Some((before, kind, inside, after)) = next_block(rest) {
        out += &others(before, &by)?;
        out += &match kind {
            Kind::Ground => {
                has_ground = true;
                format!("ground {{{}}}", ground(inside, &by)?)
            }
            Kind::Body(name) if !inside.contains("start ") && is_welded(text, name) => {
                format!("body {name} {{{inside}}}")
            }
            Kind::Body(name) => format!("body {name} {{{}}}", body(inside, &by)?),
        };
        rest = after;
    }
    out += &others(rest, &by)?;
    has_ground.then_some(out)
}

enum Kind<'a> {
    Ground,
    Body(&'a str),
}

/// The next block of the ground or of a body: what stands before it, its inside, and what follows.
fn next_block(text: &str) -> Option<(&str, Kind<'_>, &str, &str)> {
    let starts = ["ground {", "body "].map(|word| text.find(word).map(|at| (at, word)));
    let (at, word) = starts.into_iter().flatten().min()?;
    let open = at + text[at..].find('{')?;
    let close = matching(text, open)?;
    let name = text[at + word.len()..].split('{').next().unwrap_or_default().trim();
    let kind = if word == "body " { Kind::Body(name) } else { Kind::Ground };
    Some((&text[..at], kind, &text[open + 1..close], &text[close + 1..]))
}

/// The bracket that closes the one at a place.
fn matching(text: &str, open: usize) -> Option<usize> {
    let mut depth = 0;
    for (at, letter) in text.char_indices().skip_while(|(at, _)| *at < open) {
        match letter {
            '{' | '(' | '[' => depth += 1,
            '}' | ')' | ']' => {
                depth -= 1;
                if depth == 0 {
                    return Some(at);
                }
            }
            _ => {}
        }
    }
    None
}

/// Parts of a text between a letter outside of brackets.
pub(crate) fn split(text: &str, by: char) -> Vec<&str> {
    let (mut parts, mut from, mut depth) = (Vec::new(), 0, 0);
    for (at, letter) in text.char_indices() {
        match letter {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            _ if letter == by && depth == 0 => {
                parts.push(&text[from..at]);
                from = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[from..]);
    parts
}

/// Ports of the ground.
fn ground(inside: &str, by: &str) -> Option<String> {
    let mut out = String::new();
    for item in split(inside, ';').into_iter().map(str::trim).filter(|item| !item.is_empty()) {
        let (name, of) = item.strip_prefix("port ")?.split_once(':')?;
        let mut fields = split(of, ',').into_iter();
        let point = fields.next()?.trim();
        let mut angle = String::new();
        let mut others = String::new();
        for field in fields {
            let (key, value) = field.split_once(':')?;
            match key.trim() {
                "axis" | "angle" => angle = format!("({}) + ", value.trim()),
                _ => others += &format!(", {}", field.trim()),
            }
        }
        out += &format!(" port {name}: turn({point}, {by}), axis: {angle}{by}{others};");
    }
    Some(out + " ")
}

/// Is it a weld alone that places a body?
fn is_welded(text: &str, body: &str) -> bool {
    let places = |word: &str| {
        let uses = text.match_indices(word).filter(|(at, _)| text[..*at].trim_end().ends_with(['}', ';']));
        uses.filter_map(|(at, _)| text[at..].split(')').next())
            .any(|joint| joint.contains(&format!("({body}.")) || joint.contains(&format!(", {body}.")))
    };
    places("weld ") && !["revolute ", "prismatic ", "pin_slot "].iter().any(|word| places(word))
}

/// Starts of a body.
fn body(inside: &str, by: &str) -> Option<String> {
    let mut out = String::new();
    let mut starts: Vec<(&str, &str, bool)> = Vec::new();
    for item in split(inside, ';').into_iter().map(str::trim).filter(|item| !item.is_empty()) {
        if item.starts_with("coordinates") || item.starts_with("drawing_angle") {
            return None;
        }
        let Some((key, value)) = item.strip_prefix("start ").and_then(|start| start.split_once(':')) else {
            out += &format!(" {item};");
            continue;
        };
        let locked = value.trim().strip_suffix(", locked");
        starts.push((key.trim(), locked.unwrap_or(value).trim(), locked.is_some()));
    }
    let of = |key: &str| starts.iter().find(|start| start.0 == key);
    for ([x, y], unit) in [(["x", "y"], "m"), (["vx", "vy"], "m/s")] {
        let found = [x, y].map(of);
        if found.iter().all(Option::is_none) {
            continue;
        }
        let locks = found.iter().flatten().filter(|start| start.2).count();
        if locks == 1 {
            return None;
        }
        let [a, b] = found.map(|start| start.map_or(format!("0 {unit}"), |start| start.1.to_owned()));
        let locked = if locks == 2 { ", locked" } else { "" };
        out += &format!(
            " start {x}: turn(({a}, {b}), {by}).x{locked}; start {y}: turn(({a}, {b}), {by}).y{locked};"
        );
    }
    let angle = of("angle").map_or(("0 deg", false), |start| (start.1, start.2));
    out += &format!(" start angle: ({}) + {by}{};", angle.0, if angle.1 { ", locked" } else { "" });
    if let Some((_, omega, locked)) = of("omega") {
        out += &format!(" start omega: {omega}{};", if *locked { ", locked" } else { "" });
    }
    Some(out + " ")
}

/// Items outside the blocks of the ground and of bodies, with gravity turned; none if one that is no output reads absolute axes.
fn others(text: &str, by: &str) -> Option<String> {
    let mut out = String::new();
    let items = split(text, ';');
    let last = items.len() - 1;
    for (k, item) in items.into_iter().enumerate() {
        let words = item.trim();
        if let Some((head, value)) = item.split_once("gravity:").filter(|_| !words.contains("output ")) {
            let value = value.trim();
            let vector =
                if value.starts_with('(') { value.to_owned() } else { format!("(0 m/s^2, -({value}))") };
            out += &format!("{head}gravity: turn({vector}, {by})");
        } else if words.starts_with("output ") || !reads_axes(words) {
            out += item;
        } else {
            return None;
        }
        if k < last {
            out.push(';');
        }
    }
    Some(out)
}

/// Does an item say something in absolute axes?
fn reads_axes(item: &str) -> bool {
    const WORDS: [&str; 15] = [
        ".x",
        ".y",
        ".vx",
        ".vy",
        ".ax",
        ".ay",
        ".angle",
        ".position",
        ".velocity",
        " x:",
        " y:",
        "frame_axes",
        "gravity",
        "sliding_mass",
        "position_sensor",
    ];
    WORDS.iter().any(|word| {
        item.match_indices(word).any(|(at, _)| {
            let next = item[at + word.len()..].chars().next();
            !next.is_some_and(|next| next.is_alphanumeric() || next == '_')
        })
    })
}
