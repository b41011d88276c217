//! Numbers over time as text: CSV, and a table with columns that are aligned.

use std::io::{self, Write};

/// Heading of a column with its unit: `arm.angle (deg)`; the name alone of a pure number. As in the tables of compiled programs.
pub(crate) fn heading(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} ({unit})") }
}

/// Writes a line of headings of a CSV file, quoted where they have to be (RFC 4180).
pub(crate) fn csv_headings(headings: &[String], to: &mut dyn Write) -> io::Result<()> {
    let quoted = |heading: &String| {
        let is_plain = !heading.contains([',', '"', '\r', '\n']);
        if is_plain { heading.clone() } else { format!("\"{}\"", heading.replace('"', "\"\"")) }
    };
    writeln!(to, "{}", headings.iter().map(quoted).collect::<Vec<_>>().join(","))
}

/// Writes a line of numbers of a CSV file: for each the shortest text that reads back to the same bits.
pub(crate) fn csv_row(row: &[f64], to: &mut dyn Write) -> io::Result<()> {
    let numbers: Vec<String> = row.iter().map(|number| format!("{number:?}")).collect();
    writeln!(to, "{}", numbers.join(","))
}

/// Digits of the largest number of a column.
const DIGITS: i32 = 6;

/// Writes rows with their headings; points of a column stand below each other.
pub(crate) fn aligned(headings: &[String], rows: &[Vec<f64>], to: &mut dyn Write) -> io::Result<()> {
    let column = |(k, heading): (usize, &String)| {
        let numbers: Vec<f64> = rows.iter().map(|row| row.get(k).copied().unwrap_or(f64::NAN)).collect();
        let texts = std::iter::once(heading.clone()).chain(texts(&numbers)).collect::<Vec<_>>();
        let width = texts.iter().map(|text| text.chars().count()).max().unwrap_or_default();
        texts.into_iter().map(|text| format!("{text:>width$}")).collect::<Vec<_>>()
    };
    let columns: Vec<Vec<String>> = headings.iter().enumerate().map(column).collect();
    for line in 0..=rows.len() {
        let texts: Vec<&str> = columns.iter().map(|column| column[line].as_str()).collect();
        writeln!(to, "{}", texts.join("  "))?;
    }
    Ok(())
}

/// Numbers of a column with as many decimals as its largest one has room for.
fn texts(numbers: &[f64]) -> Vec<String> {
    let sizes = numbers.iter().map(|number| number.abs()).filter(|size| size.is_finite());
    let largest = sizes.fold(0.0, f64::max);
    // Zero has no order of magnitude.
    let order = if largest > 0.0 { largest.log10().floor() } else { 0.0 };
    let text = |number: &f64| {
        let text = if (-4.0..7.0).contains(&order) {
            format!("{number:.0$}", (DIGITS - 1 - order as i32).max(0) as usize)
        } else {
            format!("{number:.0$e}", DIGITS as usize - 1)
        };
        // A number that is rounded to zero has no sign.
        let is_zero = text.starts_with('-') && text.parse::<f64>().is_ok_and(|number| number.abs() <= 0.0);
        if is_zero { text.trim_start_matches('-').to_owned() } else { text }
    };
    numbers.iter().map(text).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{aligned, csv_headings};

    #[test]
    fn columns_are_aligned_and_have_six_digits() {
        let headings = ["time (s)", "force (N)", "small (m)"].map(str::to_owned);
        let rows = [vec![0.0, -1234.5678, 2e-9], vec![0.5, -1e-9, f64::NAN], vec![10.0, 3.0, -1.0e-8]];
        let mut text = Vec::new();
        aligned(&headings, &rows, &mut text).unwrap();
        let expected = "time (s)  force (N)   small (m)\n  \
                        0.0000   -1234.57  2.00000e-9\n  \
                        0.5000       0.00         NaN\n \
                        10.0000       3.00  -1.00000e-8\n";
        let text = String::from_utf8(text).unwrap();
        let squeezed = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(squeezed(&text), squeezed(expected));
        assert!(text.lines().all(|line| line.len() == text.lines().next().unwrap().len()), "{text}");
    }

    #[test]
    fn headings_are_quoted_where_they_have_to_be() {
        let mut text = Vec::new();
        csv_headings(&["a[0,1] (m)".to_owned(), "b".to_owned()], &mut text).unwrap();
        assert_eq!(text, b"\"a[0,1] (m)\",b\n");
    }
}
