//! The result of a study as a file: a table of text, or an array of NumPy.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

use super::{Gathered, Problem, Quantity};

impl<const P: usize, const C: usize> Gathered<P, C> {
    /// Writes the points that are there, in their order: as `.csv` with the messages of failures in the last column, or as `.npy`, a
    /// structured array of NumPy, with a file `.faults.csv` beside it. Columns of a point that failed are empty, or NaN.
    ///
    /// # Errors
    /// Another ending, or a file that cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), Problem> {
        match path.extension().and_then(OsStr::to_str) {
            Some("csv") => replace(path, |file| self.csv(file)),
            Some("npy") => {
                replace(path, |file| self.npy(file))?;
                replace(&path.with_extension("faults.csv"), |file| self.faults(file))
            }
            _ => Err(Problem::file(path, "a table ends in .csv or .npy")),
        }
    }

    fn csv(&self, file: &mut dyn Write) -> io::Result<()> {
        let columns = self.plan.columns.iter();
        writeln!(file, "index,{}fault", heads(self.plan.points.quantities.iter().chain(columns)))?;
        for (index, outcome) in self.done() {
            write!(file, "{index},{}", cells(&self.point(index)))?;
            match outcome {
                Ok(row) => writeln!(file, "{}", cells(row))?,
                Err(words) => writeln!(file, "{}{}", ",".repeat(C), quoted(words))?,
            }
        }
        Ok(())
    }

    fn faults(&self, file: &mut dyn Write) -> io::Result<()> {
        writeln!(file, "index,{}fault", heads(self.plan.points.quantities.iter()))?;
        for (index, words) in self.failed() {
            writeln!(file, "{index},{}{}", cells(&self.point(index)), quoted(words))?;
        }
        Ok(())
    }

    /// numpy.lib.format, version 2.0: a head that says what the rows are, then the rows, little endian.
    fn npy(&self, file: &mut dyn Write) -> io::Result<()> {
        let quantities = self.plan.points.quantities.iter().chain(&self.plan.columns);
        let fields = quantities.map(|Quantity { name, .. }| format!("('{name}', '<f8'), "));
        let fields = fields.collect::<Vec<_>>().concat();
        let mut head = format!(
            "{{'descr': [('index', '<u8'), {fields}('failed', '|b1')], 'fortran_order': False, 'shape': ({},), }}",
            self.done().count()
        );
        let before = 12;
        // Rows begin at a multiple of 64.
        head.push_str(&" ".repeat((before + head.len() + 1).next_multiple_of(64) - before - head.len() - 1));
        head.push('\n');
        file.write_all(b"\x93NUMPY\x02\x00")?;
        file.write_all(&(head.len() as u32).to_le_bytes())?;
        file.write_all(head.as_bytes())?;
        for (index, outcome) in self.done() {
            let row = outcome.as_ref().copied().unwrap_or([f64::NAN; C]);
            file.write_all(&(index as u64).to_le_bytes())?;
            for value in self.point(index).iter().chain(&row) {
                file.write_all(&value.to_le_bytes())?;
            }
            file.write_all(&[u8::from(outcome.is_err())])?;
        }
        Ok(())
    }

    /// The parameters of a point that is there.
    fn point(&self, index: usize) -> Vec<f64> {
        self.plan.points.at(index).map_or(vec![], |point| point.to_vec())
    }
}

/// The names of columns, each with its unit in brackets and a comma after it.
fn heads<'a>(quantities: impl Iterator<Item = &'a Quantity>) -> String {
    let head = |Quantity { name, unit }: &Quantity| {
        if unit.is_empty() { format!("{name},") } else { format!("{},", quoted(&format!("{name} [{unit}]"))) }
    };
    quantities.map(head).collect::<Vec<_>>().concat()
}

/// Numbers with as many digits as their bits need, a comma after each.
fn cells(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:?},")).collect::<Vec<_>>().concat()
}

/// A cell of text (RFC 4180).
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// Writes a file that is there as a whole, or not at all.
fn replace(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Problem> {
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    let done = || -> io::Result<()> {
        if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            fs::create_dir_all(folder)?;
        }
        let mut file = BufWriter::new(File::create(&part)?);
        write(&mut file)?;
        // Some file systems report only now that they are full.
        file.into_inner()?.sync_all()?;
        fs::rename(&part, path)
    };
    done().map_err(|error| {
        // The first error is reported.
        let _ = fs::remove_file(&part);
        Problem::file(path, error)
    })
}
