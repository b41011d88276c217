//! Pixels of a picture: how much of each is covered by a line, by what a closed line holds, and by letters.

use super::letters;
use super::look::{Look, Looks};
use super::mark::{Form, Mark};
use super::paper::{Point, beside};
use super::png;

/// Pixels of the file in a pixel of the picture.
const FINE: f64 = 2.0;
/// Lines of a row of pixels at which the inside of a closed line is found.
const SUBROWS: usize = 4;
/// The most rows of a file: a picture has some 800.
const MOST_ROWS: f64 = 8000.0;
/// Corners of a circle.
const CORNERS: u32 = 96;
/// Length of dashes and of the blanks between them, in pixels of the picture.
const DASH: f64 = 4.0;

/// Rows of pixels.
pub(super) struct Canvas {
    /// The upper left corner, in the picture.
    corner: Point,
    columns: usize,
    rows: usize,
    pixels: Vec<[u8; 3]>,
    /// How much of each pixel is covered by what is drawn, from 0 to 1; zero between two marks.
    covered: Vec<f32>,
}

/// Which windings about a place are inside.
#[derive(Clone, Copy, PartialEq)]
enum Inside {
    NotZero,
    Odd,
}

impl Canvas {
    /// White pixels for a part of the picture.
    pub(super) fn new(corner: Point, [width, height]: Point) -> Self {
        let [columns, rows] = [width, height].map(|size| (FINE * size).clamp(1.0, MOST_ROWS) as usize);
        let (pixels, covered) = (vec![[255; 3]; columns * rows], vec![0.0; columns * rows]);
        Self { corner, columns, rows, pixels, covered }
    }

    pub(super) fn to_png(&self) -> Vec<u8> {
        png::file(self.columns, &self.pixels)
    }

    /// Covers all of it.
    pub(super) fn cover(&mut self, look: Look) {
        if let Some(colour) = look.fill {
            self.pixels.fill(colour);
        }
    }

    pub(super) fn draw(&mut self, mark: &Mark, looks: &Looks) {
        let class = mark.class.as_str();
        match &mark.form {
            Form::Path { points, is_closed } => {
                self.path(&[points], *is_closed, Inside::NotZero, looks.of("path", class));
            }
            Form::Rings(rings) => {
                let rings: Vec<&[Point]> = rings.iter().map(Vec::as_slice).collect();
                self.path(&rings, true, Inside::Odd, looks.of("path", class));
            }
            Form::Circle { at, radius } => {
                let rim = arc(*at, *radius, 0.0, std::f64::consts::TAU);
                self.path(&[&rim], true, Inside::NotZero, looks.of("circle", class));
            }
            Form::Arc { centre, radius, from, to } => {
                let points = arc(*centre, *radius, *from, *to);
                self.path(&[&points], false, Inside::NotZero, looks.of("path", class));
            }
            Form::Text { at, text } => self.text(*at, text, looks.of("text", class)),
        }
    }

    /// Fills what lines hold, then draws the lines.
    fn path(&mut self, lines: &[&[Point]], is_closed: bool, inside: Inside, look: Look) {
        let place = |at: &Point| [0, 1].map(|k| FINE * (at[k] - self.corner[k]));
        let mut lines: Vec<Vec<Point>> = lines.iter().map(|line| line.iter().map(place).collect()).collect();
        if lines.iter().flatten().flatten().any(|x| !x.is_finite()) {
            return;
        }
        if let Some(colour) = look.fill {
            self.fill(&lines, inside);
            self.paint(colour);
        }
        let Some((colour, width)) = look.stroke else { return };
        if is_closed {
            for line in &mut lines {
                line.extend(line.first().copied());
            }
        }
        for line in &lines {
            if look.is_dashed {
                for dash in dashes(line) {
                    self.stroke(&dash, 0.5 * FINE * width);
                }
            } else {
                self.stroke(line, 0.5 * FINE * width);
            }
        }
        self.paint(colour);
    }

    /// Covers what is nearer to a line than half its width, which rounds its ends and corners.
    fn stroke(&mut self, line: &[Point], half: f64) {
        let alone = if line.len() == 1 { [line[0]; 2].to_vec() } else { Vec::new() };
        for ends in line.windows(2).chain(alone.windows(2)) {
            let [a, b] = [ends[0], ends[1]];
            let [columns, rows] = [(0, self.columns), (1, self.rows)].map(|(k, count)| {
                let from = (a[k].min(b[k]) - half - 1.0).max(0.0);
                let to = (a[k].max(b[k]) + half + 1.0).clamp(0.0, count as f64);
                from as usize..to.ceil() as usize
            });
            for row in rows {
                for column in columns.clone() {
                    let at = [column as f64 + 0.5, row as f64 + 0.5];
                    let part = (half + 0.5 - distance(at, a, b)).clamp(0.0, 1.0) as f32;
                    let pixel = &mut self.covered[row * self.columns + column];
                    *pixel = pixel.max(part);
                }
            }
        }
    }

    /// Covers the inside of closed lines.
    fn fill(&mut self, rings: &[Vec<Point>], inside: Inside) {
        let heights = rings.iter().flatten().map(|at| at[1]);
        let (top, bottom) =
            heights.fold((f64::INFINITY, 0.0_f64), |(low, high), y| (low.min(y), high.max(y)));
        let rows = top.max(0.0) as usize..(bottom.ceil().min(self.rows as f64)) as usize;
        for row in rows {
            for part in 0..SUBROWS {
                let y = row as f64 + (part as f64 + 0.5) / SUBROWS as f64;
                for [from, to] in spans(rings, y, inside) {
                    self.cover_span(row, from, to);
                }
            }
        }
    }

    /// Covers a part of a row as far as one of its lines does.
    fn cover_span(&mut self, row: usize, from: f64, to: f64) {
        let [from, to] = [from, to].map(|x| x.clamp(0.0, self.columns as f64));
        for column in from as usize..to.ceil() as usize {
            let part = to.min(column as f64 + 1.0) - from.max(column as f64);
            let pixel = &mut self.covered[row * self.columns + column];
            *pixel = (*pixel + part as f32 / SUBROWS as f32).min(1.0);
        }
    }

    /// Letters, the middle of whose line is at a place.
    fn text(&mut self, at: Point, text: &str, look: Look) {
        let Some(colour) = look.fill else { return };
        let [x, y] = [0, 1].map(|k| FINE * (at[k] - self.corner[k]));
        let letters = letters::of(text, FINE * look.letters);
        let width: usize = letters.iter().map(|letter| letter.advance).sum();
        let mut left = if look.begins { x } else { x - 0.5 * width as f64 };
        for letter in &letters {
            let top = y - 0.5 * letter.rows.len() as f64;
            for (k, row) in letter.rows.iter().enumerate() {
                for (column, part) in row[letter.ink.clone()].iter().enumerate() {
                    let place = [left.round() + column as f64, top.round() + k as f64];
                    self.cover_pixel(place, f32::from(*part) / 255.0);
                }
            }
            left += letter.advance as f64;
        }
        self.paint(colour);
    }

    fn cover_pixel(&mut self, [column, row]: Point, part: f32) {
        let is_here = (0.0..self.columns as f64).contains(&column) && (0.0..self.rows as f64).contains(&row);
        if is_here {
            self.covered[row as usize * self.columns + column as usize] = part;
        }
    }

    /// Mixes a colour into what is covered, and uncovers it.
    fn paint(&mut self, colour: [u8; 3]) {
        for (pixel, part) in self.pixels.iter_mut().zip(&mut self.covered) {
            if *part > 0.0 {
                for (own, new) in pixel.iter_mut().zip(colour) {
                    *own = (f32::from(*own) + (f32::from(new) - f32::from(*own)) * *part).round() as u8;
                }
                *part = 0.0;
            }
        }
    }
}

/// Points of an arc, as many as its part of a circle has corners.
fn arc(centre: Point, radius: f64, from: f64, to: f64) -> Vec<Point> {
    let count = (f64::from(CORNERS) * (to - from).abs() / std::f64::consts::TAU).ceil().max(1.0);
    (0..=count as u32).map(|k| beside(centre, from + (to - from) * f64::from(k) / count, radius)).collect()
}

/// Distance of a place from a straight line between two others.
fn distance(at: Point, a: Point, b: Point) -> f64 {
    let (along, from) = ([b[0] - a[0], b[1] - a[1]], [at[0] - a[0], at[1] - a[1]]);
    let length = along[0] * along[0] + along[1] * along[1];
    let part = if length > 0.0 { (along[0] * from[0] + along[1] * from[1]) / length } else { 0.0 };
    let part = part.clamp(0.0, 1.0);
    (from[0] - part * along[0]).hypot(from[1] - part * along[1])
}

/// Parts of a height that are inside of closed lines.
fn spans(rings: &[Vec<Point>], y: f64, inside: Inside) -> Vec<[f64; 2]> {
    let mut crossings: Vec<(f64, i32)> = Vec::new();
    for ring in rings {
        for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            if (a[1] <= y) != (b[1] <= y) {
                let x = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                crossings.push((x, if a[1] <= y { 1 } else { -1 }));
            }
        }
    }
    crossings.sort_by(|one, other| one.0.total_cmp(&other.0));
    let (mut winding, mut spans) = (0, Vec::new());
    for ends in crossings.windows(2) {
        winding += ends[0].1;
        if if inside == Inside::Odd { winding % 2 != 0 } else { winding != 0 } {
            spans.push([ends[0].0, ends[1].0]);
        }
    }
    spans
}

/// Dashes of a line, in pixels of the file.
fn dashes(line: &[Point]) -> Vec<Vec<Point>> {
    let (mut dashes, mut gone) = (Vec::new(), 0.0);
    for ends in line.windows(2) {
        let [a, b] = [ends[0], ends[1]];
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let at = |along: f64| [0, 1].map(|k| a[k] + (b[k] - a[k]) * along / length);
        // Of dashes that go around a corner, both sides are drawn.
        let mut begin = -(gone % (2.0 * FINE * DASH));
        while length > 0.0 && begin < length {
            let (from, to) = (begin.max(0.0), (begin + FINE * DASH).min(length));
            if to > from {
                dashes.push(vec![at(from), at(to)]);
            }
            begin += 2.0 * FINE * DASH;
        }
        gone += length;
    }
    dashes
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLACK: [u8; 3] = [0; 3];

    fn filled(rings: &[&[Point]], inside: Inside) -> f64 {
        let mut canvas = Canvas::new([0.0; 2], [30.0; 2]);
        let look = Look { fill: Some(BLACK), ..Look::default() };
        canvas.path(rings, true, inside, look);
        covered(&canvas)
    }

    /// The covered area, in pixels of the picture.
    fn covered(canvas: &Canvas) -> f64 {
        let parts = canvas.pixels.iter().map(|pixel| 1.0 - f64::from(pixel[0]) / 255.0);
        parts.sum::<f64>() / (FINE * FINE)
    }

    #[test]
    fn areas_are_those_of_geometry() {
        let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
        let (whole, hole) = (square(3.3, 20.7), square(8.1, 12.4));
        let area = |low: f64, high: f64| (high - low) * (high - low);
        let near = |found: f64, expected: f64| {
            assert!((found - expected).abs() < 0.02 * expected, "{found} {expected}");
        };
        near(filled(&[&whole], Inside::NotZero), area(3.3, 20.7));
        near(filled(&[&whole, &hole], Inside::Odd), area(3.3, 20.7) - area(8.1, 12.4));
        near(filled(&[&whole, &hole], Inside::NotZero), area(3.3, 20.7));
        let rim = arc([15.0, 15.0], 9.0, 0.0, std::f64::consts::TAU);
        near(filled(&[&rim], Inside::NotZero), std::f64::consts::PI * 81.0);
    }

    #[test]
    fn a_line_has_its_width_and_round_ends() {
        for (to, width) in [([22.0, 8.0], 3.0), ([8.0, 22.0], 1.6), ([19.0, 21.0], 5.0), ([8.0, 8.0], 6.0)] {
            let mut canvas = Canvas::new([0.0; 2], [30.0; 2]);
            let look = Look { stroke: Some((BLACK, width)), ..Look::default() };
            canvas.path(&[&[[8.0, 8.0], to]], false, Inside::NotZero, look);
            let length = (to[0] - 8.0_f64).hypot(to[1] - 8.0);
            let expected = width * length + 0.25 * std::f64::consts::PI * width * width;
            assert!((covered(&canvas) - expected).abs() < 0.04 * expected, "{} {expected}", covered(&canvas));
        }
    }

    #[test]
    fn dashes_cover_half_of_a_line_also_around_corners() {
        let line: Vec<Point> =
            (0..=40).map(|k| f64::from(k) * 7.3).map(|s| [s, 3.0 * (s / 20.0).sin()]).collect();
        let length = |line: &[Point]| -> f64 {
            line.windows(2).map(|ends| (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1])).sum()
        };
        let drawn: f64 = dashes(&line).iter().map(|dash| length(dash)).sum();
        assert!((drawn - 0.5 * length(&line)).abs() < FINE * DASH, "{drawn} of {}", length(&line));
    }

    #[test]
    fn what_is_beyond_the_edge_is_left_out() {
        let mut canvas = Canvas::new([0.0; 2], [10.0; 2]);
        let look = Look { fill: Some(BLACK), stroke: Some((BLACK, 2.0)), letters: 13.0, ..Look::default() };
        for at in [[-1e9, 5.0], [1e9, 5.0], [5.0, -1e9], [f64::NAN, 1.0], [f64::INFINITY, 1.0]] {
            canvas.path(&[&[at, at, [at[0], at[1] + 1.0]]], true, Inside::NotZero, look);
            canvas.text(at, "far", look);
        }
        assert!(covered(&canvas) < 1e-9, "{}", covered(&canvas));
        canvas.path(&[&[[-5.0, 5.0], [15.0, 5.0]]], false, Inside::NotZero, Look { fill: None, ..look });
        assert!((covered(&canvas) - 20.0).abs() < 0.4, "{}", covered(&canvas));
    }
}
