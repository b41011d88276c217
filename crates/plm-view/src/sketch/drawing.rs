//! A picture that is done, as a file.

use super::canvas::Canvas;
use super::look;
use super::mark::{Mark, number};
use crate::svg::escape;

/// The frame of a picture with all that is in it.
pub(super) struct Drawing {
    pub(super) title: String,
    pub(super) marks: Vec<Mark>,
    /// In pixels.
    pub(super) width: f64,
    /// Its upper and its lower edge, in pixels.
    pub(super) rows: [f64; 2],
}

impl Drawing {
    pub(super) fn to_svg(&self) -> String {
        let ([top, bottom], style) = (self.rows, look::style());
        let (title, [w, t, h]) = (escape(&self.title), [self.width, top, bottom - top].map(number));
        let mut marks = String::new();
        self.marks.iter().for_each(|mark| mark.write_svg(&mut marks));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{title}\" width=\"{w}\" height=\"{h}\" \
             viewBox=\"0 {t} {w} {h}\">\n<title>{title}</title>\n<style>{style}</style>\n\
             <rect class=\"paper\" y=\"{t}\" width=\"{w}\" height=\"{h}\"/>\n{marks}</svg>\n"
        )
    }

    /// Twice as many pixels in each direction, in the light colours.
    pub(super) fn to_png(&self) -> Vec<u8> {
        let looks = look::Looks::light();
        let [top, bottom] = self.rows;
        let mut canvas = Canvas::new([0.0, top], [self.width, bottom - top]);
        canvas.cover(looks.of("rect", "paper"));
        for mark in &self.marks {
            canvas.draw(mark, &looks);
        }
        canvas.to_png()
    }
}
