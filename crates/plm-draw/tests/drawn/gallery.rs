//! Every pin of the gallery's machines is dragged, and the compiler says where it stands then.

use plm_draw::{
    Axes, Drag, Drawn, Gesture, Handle, Picture, Place, Placed, Point, PortName, Sheet, applied, draw,
    inverse,
};

use crate::support::{compiled, machines};

/// The extent of a picture.
fn size(picture: &Picture) -> f64 {
    let along = |axis: usize| {
        let all = || picture.ports.iter().map(move |port| port.at[axis]);
        all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min)
    };
    along(0).max(along(1))
}

/// A step of 1, 2 or 5 times a power of ten.
fn step(about: f64) -> f64 {
    let ten = 10_f64.powf(about.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|part| part * ten).find(|step| *step <= about).unwrap_or(ten)
}

/// Places for a pin: beside it, on the lines through it along the axes, and where it is.
fn targets(at: Point, grid: f64) -> [Point; 4] {
    [[8.0, -3.0], [0.0, 7.0], [-5.0, 0.0], [0.0, 0.0]].map(|by| [at[0] + by[0] * grid, at[1] + by[1] * grid])
}

/// A drag of a port of a machine.
struct Case<'a> {
    machine: &'a str,
    text: &'a str,
    sheet: &'a Sheet<'a>,
    picture: &'a Picture,
    handle: &'a Handle<'a>,
    to: Point,
    grid: f64,
    free: bool,
}

impl Case<'_> {
    fn draw(&self) -> Option<Drawn> {
        let drag = Drag { port: self.handle.name.clone(), to: self.to, grid: self.grid, free: self.free };
        draw(self.sheet, self.picture, &Gesture::Drag(drag)).ok()
    }

    /// Asserts that the edits can be undone, and change no other number.
    fn check(&self, drawn: &Drawn) {
        let Case { machine, text, handle, .. } = self;
        let what = format!("{machine} {} to {:?}", handle.name, self.to);
        let made = applied(text, &drawn.edits);
        assert_eq!(&applied(&made, &inverse(text, &drawn.edits)), text, "{what}: undone");
        let (before, after) = (Sheet::read(text, None), Sheet::read(&made, None));
        for (old, new) in before.handles().iter().zip(after.handles()) {
            assert_eq!(old.name, new.name, "{what}: ports stay");
            let (Place::Numbers { numbers: old, .. }, Place::Numbers { numbers: new, .. }) =
                (&old.place, &new.place)
            else {
                continue;
            };
            for (old, new) in old.iter().zip(new.iter()) {
                // A zero without a unit has none of its own.
                assert!(old.unit.text == new.unit.text || old.value == 0.0, "{what}: {old:?} {new:?}");
            }
        }
        assert_eq!(plm_draw::layout::formatted(&made).as_ref(), Ok(&made), "{what}: layout");
    }

    /// How far the pin is from where the edits say that it is, in the text as it is compiled.
    fn away(&self, drawn: &Drawn) -> f64 {
        let made = applied(self.text, &drawn.edits);
        let after = compiled(&made);
        let found = after.picture.as_ref().and_then(|picture| picture.port(&self.handle.name).cloned());
        let Some(Placed { at, .. }) = found else {
            panic!("{} {}: {:?}", self.machine, self.handle.name, after.problems)
        };
        let to = drawn.to.unwrap();
        (at[0] - to[0]).hypot(at[1] - to[1])
    }
}

/// A pin goes to the pointer. Slides and slots at a pin hold it to a line, and a place of several bodies is none of one pin: of these the
/// edits alone are looked at. What is left is a third of a hundredth of the grid for each number: those of a length, an angle and an end.
#[test]
fn a_pin_of_the_gallery_stands_where_it_was_dragged() {
    let (mut ports, mut expressions, mut drags, mut exact) = (0, 0, 0, 0);
    let mut away = Vec::new();
    for (machine, text) in &machines() {
        let picture = compiled(text).picture.unwrap();
        let grid = step(size(&picture) / 400.0);
        let sheet = Sheet::read(text, None);
        for handle in &sheet.handles() {
            ports += 1;
            if matches!(handle.place, Place::Expression(_)) {
                expressions += 1;
                continue;
            }
            let placed = picture.port(&handle.name).unwrap();
            for (k, to) in targets(placed.at, grid).into_iter().enumerate() {
                let case =
                    Case { machine, text, sheet: &sheet, picture: &picture, handle, to, grid, free: k == 2 };
                let Some(drawn) = case.draw() else { continue };
                drags += 1;
                case.check(&drawn);
                if k == 3 {
                    assert!(drawn.edits.is_empty(), "{machine} {}: {:?}", handle.name, drawn.edits);
                }
                let is_of_many =
                    |name: &PortName| sheet.handles().iter().any(|of| of.name == *name && of.turns > 1);
                let is_alone = drawn.open.is_empty() && !sheet.pin(&handle.name).iter().any(is_of_many);
                if k == 3 || !is_alone {
                    continue;
                }
                exact += 1;
                if case.away(&drawn) > 0.03 * grid {
                    away.push(format!("{machine} {} {k}", handle.name));
                }
            }
        }
    }
    println!("{ports} ports, {expressions} by expressions; {drags} drags, {exact} compiled");
    assert_eq!((ports, expressions), (260, 18));
    assert_eq!(away, Vec::<String>::new());
}

#[test]
fn axes_are_those_of_the_text() {
    let text = "pub P { ground { port o: 0; } body a { coordinates: absolute; drawing_angle: 90 deg; port p: (1, 2) m; } body b { port q: (1, 2) m; } }";
    let sheet = Sheet::read(text, None);
    let axes: Vec<Axes> = sheet.handles().iter().map(|handle| handle.axes).collect();
    assert_eq!(axes, [Axes::Absolute, Axes::Drawing(std::f64::consts::FRAC_PI_2), Axes::Own]);
}
