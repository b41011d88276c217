//! From declarations to drawings, without rustc in between.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use std::fs;
use std::path::Path;

use plm::view::{Body, Frame, GroundPort, Mechanism, Part, Port, Sense, Shape, Sketch};
use plm_compiler::token::Sources;
use plm_compiler::{Picture, PicturePort, PictureShape, compile, words};

use super::blocks::blocks;

/// A figure: its path in the repository, and what is in the file.
pub(crate) type Drawing = (String, String);

/// Pages of parts whose example is drawn as it stands.
const PLANAR: &[&str] = &[
    "revolute",
    "prismatic",
    "pin_slot",
    "weld",
    "clearance",
    "bushing",
    "stop",
    "latch",
    "lock",
    "ratchet",
    "bristle_friction",
    "torque_limiter",
    "force",
    "spring",
    "jack",
    "sliding_mass",
    "gear",
    "rack",
    "belt",
    "elastic_belt",
    "chain",
    "fall",
    "gas_spring",
    "counterweight",
    "frame_axes",
    "position_sensor",
    "velocity_sensor",
    "acceleration_sensor",
    "point_on_line",
    "point_on_circle",
    "point_on_polyline",
    "ground_profile",
    "circle_on_line",
    "circle_on_circle",
    "circle_on_polyline",
    "polygon_on_line",
    "rolling",
    "rolling_on_circle",
    "point_on_curve",
    "wheel",
    "tyre",
    "cam",
    "oscillating_follower",
    "geneva",
];

/// Demos of the manual with a mechanism to be seen: the file, and the title.
const DEMOS: [(&str, &str); 18] = [
    ("double_pendulum", "DoublePendulum"),
    ("prismatic_joint", "PrismaticJoint, System 1"),
    ("connect_plm_hyd", "ConnectPlmHyd"),
    ("connect_plm_hcd", "ConnectPlmHCD"),
    ("double_arm", "DoubleArm"),
    ("plmpiv00", "PLMPIV00"),
    ("plmpiv10", "PLMPIV10"),
    ("plmtra00", "PLMTRA00"),
    ("plmtra10", "PLMTRA10"),
    ("plmtrpi00", "PLMTRPI00"),
    ("plmj00", "PLMJ00"),
    ("quadrorhomb", "Quadrorhomb"),
    ("plmbod02", "PLMBOD02"),
    ("plmassembly", "PLMASSEMBLY"),
    ("plmemb01", "PLMEMB01"),
    ("plmt01d", "PLMT01D"),
    ("plmt01d01", "PLMT01D01"),
    ("plmcalcul", "PLMCALCUL"),
];

/// All figures.
///
/// # Errors
/// A page or a demo that cannot be read, or that has no declaration which compiles.
pub(crate) fn all(root: &Path) -> Result<Vec<Drawing>, Box<dyn Error>> {
    let mut drawings = Vec::new();
    for block in blocks() {
        drawings.push((format!("docs/src/images/parts/{}.svg", block.name()), block.to_svg()));
    }
    for page in PLANAR.iter().copied() {
        drawings.push((format!("docs/src/images/parts/{page}.svg"), of_part(root, page)?));
    }
    for (file, title) in DEMOS {
        let text = fs::read_to_string(root.join(format!("examples/manual/demos/{file}.rs")))?;
        let declaration = declared(&text).ok_or_else(|| format!("{file}.rs declares no mechanism"))?;
        let sketch = sketch(&picture(declaration)?).titled(title);
        drawings.push((format!("docs/src/images/demos/{file}.svg"), with_directions(file, sketch).to_svg()));
    }
    drawings.extend(images(root)?);
    Ok(drawings)
}

/// Parts of the library without a figure, and how to draw them.
pub(crate) fn missing() -> Option<String> {
    let drawn: Vec<String> = blocks()
        .iter()
        .map(|block| block.name().to_owned())
        .chain(PLANAR.iter().map(ToString::to_string))
        .collect();
    let names = words::parts().iter().map(|(name, _)| *name);
    let mut missing: Vec<&str> = names.filter(|name| !drawn.iter().any(|drawn| drawn == name)).collect();
    missing.sort_unstable();
    (!missing.is_empty()).then(|| {
        format!(
            "parts without a figure: {}. List a part that joins frames in `PLANAR` of examples/figures/draw.rs (it is drawn from \
             the example of its page, or from examples/figures/parts/NAME.plm), and any other part as a box in \
             the folder examples/figures/blocks; then `cargo run --example figures` writes docs/src/images/parts/NAME.svg. Step 5 of \
             docs/src/internals/adding-a-part.md says more",
            missing.join(", ")
        )
    })
}

/// Both mirror images of the loop that the page about assembly declares.
fn images(root: &Path) -> Result<Vec<Drawing>, Box<dyn Error>> {
    let page = fs::read_to_string(root.join("docs/src/running/assembly.md"))?;
    let block = page.split("```plm\n").find(|block| block.contains("branch: left"));
    let (left, _) =
        block.and_then(|block| block.split_once("```")).ok_or("assembly.md asks for no branch")?;
    let drawn = |image: &str| -> Result<Drawing, Box<dyn Error>> {
        let of = picture(&left.replace("branch: left", &format!("branch: {image}")))?;
        let svg = sketch(&of).titled(format!("branch: {image}")).to_svg();
        Ok((format!("docs/src/images/branch_{image}.svg"), svg))
    };
    ["left", "right"].into_iter().map(drawn).collect()
}

/// What stands in the first block with this fence.
fn fenced<'a>(page: &'a str, fence: &str) -> Option<&'a str> {
    let (_, block) = page.split_once(fence)?;
    Some(block.split_once("```")?.0)
}

/// The first mechanism of a Rust file.
fn declared(file: &str) -> Option<&str> {
    let (_, text) = file.split_once("plm::mechanism! {\n")?;
    Some(text.split_once("\n}\n")?.0)
}

/// The figure of a part: its own declaration where it has one, else the example of its page, in which the bars of all
/// examples stand back.
fn of_part(root: &Path, page: &str) -> Result<String, Box<dyn Error>> {
    if let Ok(text) = fs::read_to_string(root.join(format!("examples/figures/parts/{page}.plm"))) {
        let whole = picture(&text)?;
        return Ok(explained(page, sketch(&whole), &whole).to_svg());
    }
    let example = fs::read_to_string(root.join("docs/src/language/declaration.md"))?;
    let example = fenced(&example, "```plm\n").ok_or("declaration.md has no example")?;
    let text = fs::read_to_string(root.join(format!("docs/src/parts/{page}.md")))
        .map_err(|error| format!("docs/src/parts/{page}.md: {error}"))?;
    let items = fenced(&text, "```plm,items\n")
        .ok_or_else(|| format!("docs/src/parts/{page}.md has no example (a block ```plm,items)"))?;
    let (head, rest) = example.split_once('{').ok_or("the example has no items")?;
    let (base, whole) = (picture(example)?, picture(&format!("{head}{{ allow(W0007);\n{items}{rest}"))?);
    let is_new = |name: &&str| !names(&base).any(|known| known == *name);
    let added: Vec<&str> = names(&whole).filter(is_new).collect();
    Ok(explained(page, sketch(&whole).focused_on(added), &whole).to_svg())
}

/// Names of bodies and parts; what is inside of a part has the name of the part.
fn names(of: &Picture) -> impl Iterator<Item = &str> {
    let all = of.bodies.iter().map(|body| &body.name).chain(of.parts.iter().map(|part| &part.name));
    all.map(|name| name.split('.').next().unwrap_or(name))
}

/// With the senses of the part that the page is about.
fn explained(page: &str, sketch: Sketch, picture: &Picture) -> Sketch {
    let about = picture.parts.iter().filter(|part| part.kind == page).map(|part| part.name.as_str());
    let sketch = sketch.titled(page).with_signs(about);
    if page != "force" {
        return sketch;
    }
    // The manual's configurations A, B and C, as parts/force.plm has them; its bar is the only body.
    let bar = picture.bodies.first().map_or(0.0, |body| body.pose[2]);
    let axes = |angle: f64| [Sense::Along(angle, "x".into()), Sense::Along(angle + FRAC_PI_2, "y".into())];
    sketch
        .titled("force: A axes: absolute; B axes: body; C axes: body, angle: 45 deg; D torque")
        .with_senses("A", axes(0.0))
        .with_senses("B", axes(bar))
        .with_senses("C", axes(bar + FRAC_PI_4))
        .with_senses("D", [Sense::Turn("torque".into())])
}

/// What the forces of demos act along, where that is not x and y.
fn with_directions(demo: &str, sketch: Sketch) -> Sketch {
    match demo {
        "plmt01d01" => sketch.with_senses("plmfor00", [Sense::Along(0.0, "x".into())]),
        "plmtrpi00" => sketch.with_senses("motor", [Sense::Turn("torque".into())]),
        _ => sketch,
    }
}

/// A declaration at its start.
///
/// # Errors
/// What the compiler says.
pub(crate) fn picture(declaration: &str) -> Result<Picture, Box<dyn Error>> {
    let mut sources = Sources::new();
    sources.add_text("declaration", declaration);
    for name in sources.named_files() {
        let content = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(&name));
        sources.add_file(&name, content.map_err(|error| error.to_string()));
    }
    let expansion = compile(&mut sources);
    let told = expansion.diagnostics.sorted();
    let told: Vec<String> = told.iter().map(|diagnostic| diagnostic.render(&sources)).collect();
    expansion.oracle.map(|oracle| oracle.picture()).ok_or_else(|| told.join("\n").into())
}

/// The drawing of a mechanism at its start.
pub(crate) fn sketch(picture: &Picture) -> Sketch {
    let poses = picture.bodies.iter().map(|body| body.pose);
    Sketch::new(mechanism(picture), poses).with_gravity(picture.gravity)
}

/// A mechanism as a results file tells of it, without what drawings do not need.
pub(crate) fn mechanism(picture: &Picture) -> Mechanism {
    let bodies = picture.bodies.iter().map(|body| Body {
        name: body.name.clone(),
        mass: 0.0,
        inertia: 0.0,
        depth: 0.0,
        ports: body.ports.iter().map(port).collect(),
        contour: (!body.contour.is_empty()).then(|| body.contour.clone()),
        holes: body.holes.clone(),
    });
    let ground = picture.ground.iter().map(|port| {
        let (name, [x, y, angle]) = (port.name.clone(), port.place);
        GroundPort { name, x, y, angle, depth: 0.0, moves: false }
    });
    let parts = picture.parts.iter().map(|part| {
        let frames = part.frames.iter().map(|(argument, frame)| Frame {
            argument: argument.clone(),
            body: frame.body,
            port: Some(frame.port),
        });
        let (name, kind, pair) = (part.name.clone(), part.kind.clone(), part.pair.map(str::to_owned));
        let sizes = part.sizes.iter().cloned().collect();
        Part {
            name,
            kind,
            pair,
            frames: frames.collect(),
            sizes,
            shapes: part.shapes.iter().map(shape).collect(),
        }
    });
    Mechanism {
        name: picture.name.clone(),
        bodies: bodies.collect(),
        ground: ground.collect(),
        parts: parts.collect(),
        ..Mechanism::default()
    }
}

fn shape(shape: &PictureShape) -> Shape {
    Shape {
        look: shape.look.to_owned(),
        body: shape.at.body,
        port: Some(shape.at.port),
        towards: shape.towards.map(|frame| (frame.body, Some(frame.port))),
        symbol: shape.is_symbol,
        points: shape.points.clone(),
    }
}

fn port(port: &PicturePort) -> Port {
    let (name, [x, y, angle]) = (port.name.clone(), port.place);
    Port { name, x, y, angle }
}
