//! Contour files: two numbers a line, the points of an outline in their order.
//!
//! Between the numbers stands a comma, a semicolon or blanks. Lines that are empty or begin with `#` are passed over. A first
//! line `x (mm), y (mm)` names the unit; without it the numbers are metres.

use plm_cas::Number;

use crate::units::{Dimension, unit};

/// Error of a file, and where: line and column from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Problem {
    pub(crate) line: usize,
    pub(crate) column: usize,
    pub(crate) what: String,
}

/// A word of a line and its column.
type Word<'a> = (usize, &'a str);

/// The points of a file, m.
pub(crate) fn read(text: &str) -> Result<Vec<[Number; 2]>, Problem> {
    let mut points = Vec::new();
    let mut scale = [Number::ONE; 2];
    let mut is_first = true;
    for (index, content) in text.lines().enumerate() {
        let at = |(column, what): (usize, String)| Problem { line: index + 1, column, what };
        let begin = content.trim_start();
        if begin.is_empty() || begin.starts_with('#') {
            continue;
        }
        let is_heading = std::mem::replace(&mut is_first, false) && begin.starts_with(char::is_alphabetic);
        if is_heading {
            scale = heading(content).map_err(at)?;
            continue;
        }
        let [x, y] = point(content).map_err(at)?;
        points.push([x * scale[0], y * scale[1]]);
    }
    Ok(points)
}

/// The units of `x (mm), y (mm)`.
fn heading(line: &str) -> Result<[Number; 2], (usize, String)> {
    let mut units = words(line, |c| c == ',' || c == ';').into_iter().map(|(column, word)| {
        let Some(open) = word.find('(') else { return Ok(Number::ONE) };
        let name = word[open + 1..].trim_end().trim_end_matches(')').trim();
        let column = column + word[..=open].chars().count();
        match unit(name) {
            Some(unit) if unit.dimension.same(Dimension::LENGTH) => Ok(unit.factor()),
            _ => Err((column, format!("expected a unit of length, found `{name}`"))),
        }
    });
    let missing = (line.chars().count() + 1, "expected the headings of two columns".to_owned());
    let x = units.next().unwrap_or(Err(missing.clone()))?;
    let y = units.next().unwrap_or(Err(missing))?;
    Ok([x, y])
}

fn point(line: &str) -> Result<[Number; 2], (usize, String)> {
    let words = words(line, |c| c == ',' || c == ';' || c.is_whitespace());
    if let Some((column, word)) = words.get(2) {
        return Err((*column, format!("expected the end of the line, found `{word}`")));
    }
    let mut numbers = words.iter().map(|&(column, word)| {
        number(word).ok_or_else(|| (column, format!("expected a number, found `{word}`")))
    });
    let missing = || Err((line.chars().count() + 1, "expected two numbers".to_owned()));
    let x = numbers.next().unwrap_or_else(missing)?;
    let y = numbers.next().unwrap_or_else(missing)?;
    Ok([x, y])
}

fn number(word: &str) -> Option<Number> {
    match word.strip_prefix('-') {
        Some(rest) => Number::parse_decimal(rest).map(|number| -number),
        None => Number::parse_decimal(word.strip_prefix('+').unwrap_or(word)),
    }
}

/// Words between separators, with their columns.
fn words(line: &str, separates: impl Fn(char) -> bool) -> Vec<Word<'_>> {
    let mut words = Vec::new();
    let mut start = None;
    for (column, (at, c)) in line.char_indices().chain([(line.len(), ',')]).enumerate() {
        let ends = separates(c) || at == line.len();
        match start {
            Some((column, from)) if ends => {
                words.push((column, line[from..at].trim_end()));
                start = None;
            }
            None if !ends && !c.is_whitespace() => start = Some((column + 1, at)),
            _ => {}
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::{Number, read};

    fn metres(text: &str) -> Vec<[f64; 2]> {
        let points = read(text).unwrap_or_else(|problem| unreachable!("{problem:?}"));
        points.into_iter().map(|point| point.map(Number::to_f64)).collect()
    }

    #[test]
    fn separators_comments_and_headings_are_read() {
        let expected = [[0.0, -0.1], [0.5, 0.1], [1.5e-3, 0.0]];
        assert_eq!(metres("# outline\n0, -0.1\n\n0.5;0.1\n 1.5e-3  0\n"), expected);
        assert_eq!(metres("x (mm), y (cm)\r\n0,-10\r\n500,10\r\n1.5,0\r\n"), expected);
        assert_eq!(metres("x,y\n+1,2\n"), [[1.0, 2.0]]);
    }

    #[test]
    fn mistakes_are_named_by_line_and_column() {
        let cases = [
            ("0, 0\n\n1, abc\n", (3, 4), "expected a number, found `abc`"),
            ("0, 0\n1\n", (2, 2), "expected two numbers"),
            ("0 0\n1 2 3", (2, 5), "expected the end of the line, found `3`"),
            ("x (kg), y (m)\n", (1, 4), "expected a unit of length, found `kg`"),
            ("x (m)\n", (1, 6), "expected the headings of two columns"),
            ("0, 0\nx, y\n", (2, 1), "expected a number, found `x`"),
        ];
        for (text, place, what) in cases {
            let Err(problem) = read(text) else { unreachable!("{text}") };
            assert_eq!(((problem.line, problem.column), problem.what.as_str()), (place, what), "{text}");
        }
    }
}
