//! Arrays of NumPy: the format `.npy`, version 1.0 (NumPy Enhancement Proposal 1, and `numpy.lib.format`).

const MAGIC: &[u8] = b"\x93NUMPY";
/// The header is filled up to a multiple of so many bytes.
const ALIGNMENT: usize = 64;

/// An array, row by row, whose numbers are still bytes.
pub(super) struct Array<'a> {
    pub(super) shape: Vec<usize>,
    kind: Kind,
    data: &'a [u8],
}

/// Storage type of a number.
#[derive(Clone, Copy)]
enum Kind {
    Double,
    Single,
}

impl Array<'_> {
    /// How many numbers came; fewer than the shape says where the file is cut off.
    pub(super) fn len(&self) -> usize {
        let size = match self.kind {
            Kind::Double => size_of::<f64>(),
            Kind::Single => size_of::<f32>(),
        };
        self.data.len() / size
    }

    /// Puts the first numbers into a list, so many of them or as many as came.
    pub(super) fn read_into(&self, numbers: &mut Vec<f64>, count: usize) {
        match self.kind {
            Kind::Double => {
                let all = self.data.as_chunks().0.iter();
                numbers.extend(all.take(count).map(|bytes| f64::from_le_bytes(*bytes)));
            }
            Kind::Single => {
                let all = self.data.as_chunks().0.iter();
                numbers.extend(all.take(count).map(|bytes| f64::from(f32::from_le_bytes(*bytes))));
            }
        }
    }
}

/// The bytes of an array.
pub(super) fn write(shape: &[usize], numbers: &[f64]) -> Vec<u8> {
    // One length is a tuple by a comma after it.
    let shape = shape.iter().map(ToString::to_string).collect::<Vec<String>>().join(", ") + ",";
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({shape}), }}");
    let length = (MAGIC.len() + 4 + header.len() + 1).next_multiple_of(ALIGNMENT) - MAGIC.len() - 4;
    let mut bytes = [MAGIC, &[1, 0], &(length as u16).to_le_bytes()].concat();
    bytes.extend(format!("{header:<width$}\n", width = length - 1).bytes());
    bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    bytes
}

/// The array in these bytes.
///
/// # Errors
/// Why it is none that can be read here.
pub(super) fn read(bytes: &[u8]) -> Result<Array<'_>, String> {
    let cut = || "is cut off in its header".to_owned();
    let rest = bytes.strip_prefix(MAGIC).ok_or("is no array of NumPy")?;
    let (&[major, _], rest) = rest.split_first_chunk().ok_or_else(cut)?;
    let (length, rest) = match major {
        1 => rest.split_first_chunk().map(|(length, rest)| (usize::from(u16::from_le_bytes(*length)), rest)),
        _ => rest.split_first_chunk().map(|(length, rest)| (u32::from_le_bytes(*length) as usize, rest)),
    }
    .ok_or_else(cut)?;
    let (header, data) = rest.split_at_checked(length).ok_or_else(cut)?;
    let header = std::str::from_utf8(header).map_err(|_| "has a header that is no text")?;
    if value_of(header, "fortran_order") != Some("False") {
        return Err("is not stored row by row".to_owned());
    }
    let kind = match value_of(header, "descr").unwrap_or_default() {
        "'<f8'" => Kind::Double,
        "'<f4'" => Kind::Single,
        other => return Err(format!("holds numbers of the kind {other}; `<f8` and `<f4` can be read")),
    };
    let shape = shape(header).ok_or("has no shape")?;
    Ok(Array { shape, kind, data })
}

/// The value of a key in the header, which is a dictionary of Python.
fn value_of<'a>(header: &'a str, key: &str) -> Option<&'a str> {
    let (_, value) = header.split_once(&format!("'{key}':"))?;
    Some(value.split([',', '}']).next()?.trim())
}

fn shape(header: &str) -> Option<Vec<usize>> {
    let (_, value) = header.split_once("'shape':")?;
    let (inside, _) = value.trim_start().strip_prefix('(')?.split_once(')')?;
    let lengths = inside.split(',').map(str::trim).filter(|length| !length.is_empty());
    lengths.map(|length| length.parse().ok()).collect()
}
