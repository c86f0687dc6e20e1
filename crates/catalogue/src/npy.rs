//! Arrays of numbers in the files of NumPy (`.npy`, versions 1 to 3): half, single and double precision, in the order of C.
//!
//! A file says how large its array is before the numbers come; it is believed only if the file has just as many bytes.

use crate::faults::Fault;
use crate::features::{beyond, broken};
use crate::limits;

/// What the files begin with.
const MAGIC: &[u8] = b"\x93NUMPY";
/// The header, a literal of Python, is not longer (bytes).
const HEADER: usize = 1 << 16;
/// Arrays have at most so many dimensions.
const DIMENSIONS: usize = 3;

/// How a number is written.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    Half,
    Single,
    Double,
}

/// An array: its extents, and its numbers row by row.
#[derive(Debug)]
pub(crate) struct Array {
    /// One to three extents, none of them 0.
    pub shape: Vec<usize>,
    /// All finite.
    pub numbers: Vec<f32>,
}

/// Reads a file, called `name` in what is said of it.
pub(crate) fn read(bytes: &[u8], name: &str) -> Result<Array, Fault> {
    let wrong = |why: &str| broken(format!("{name}: {why}"));
    let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| wrong("it is not a NumPy .npy file"))?;
    let early = || wrong("it ends early");
    let (length, begin) = match *rest {
        [1, _, a, b, ..] => (usize::from(u16::from_le_bytes([a, b])), 4),
        [2 | 3, _, a, b, c, d, ..] => (u32::from_le_bytes([a, b, c, d]) as usize, 6),
        [version, ..] if !matches!(version, 1..=3) => {
            return Err(wrong(&format!("version {version} of the format is not supported; expected 1, 2 or 3")));
        }
        _ => return Err(early()),
    };
    if length > HEADER {
        return Err(beyond(format!("{name}: its header is {length} bytes long; the maximum is {HEADER}")));
    }
    let header = rest.get(begin..begin + length).ok_or_else(early)?;
    let header = std::str::from_utf8(header).map_err(|_| wrong("its header is not text"))?;
    let (kind, shape) = described(header).map_err(|why| wrong(&why))?;
    if kind.size(&shape).is_none() {
        let most = limits::FEATURES >> 20;
        return Err(beyond(format!("{name}: it declares an array of {shape:?} numbers; the maximum is {most} MB")));
    }
    Array::new(kind, shape, &rest[begin + length..]).map_err(|why| wrong(&why))
}

impl Array {
    /// An array of the numbers that bytes stand for.
    ///
    /// # Errors
    /// The shape is none that is supported, the bytes do not fit it, or a number is not finite.
    pub fn new(kind: Kind, shape: Vec<usize>, data: &[u8]) -> Result<Self, String> {
        if !(1..=DIMENSIONS).contains(&shape.len()) || shape.contains(&0) {
            return Err(format!("its shape is {shape:?}; expected one to {DIMENSIONS} dimensions, none of them 0"));
        }
        let wanted = kind.size(&shape).filter(|wanted| *wanted <= data.len()).ok_or("it ends early")?;
        if data.len() > wanted {
            return Err(format!("it has {} bytes after its array", data.len() - wanted));
        }
        let numbers = kind.numbers(data);
        if let Some(at) = numbers.iter().position(|x| !x.is_finite()) {
            let row = at / (numbers.len() / shape[0]);
            return Err(format!("row {row} has a number that is not finite"));
        }
        Ok(Self { shape, numbers })
    }
}

impl Kind {
    /// By the name that NumPy has for it.
    pub fn named(name: &str) -> Result<Self, String> {
        match name {
            "<f2" => Ok(Self::Half),
            "<f4" => Ok(Self::Single),
            "<f8" => Ok(Self::Double),
            other => Err(format!(
                "it has numbers of type {other:?}; \"<f2\", \"<f4\" and \"<f8\" are supported: use array.astype('<f4')"
            )),
        }
    }

    /// How many bytes an array has, unless they are too many.
    fn size(self, shape: &[usize]) -> Option<usize> {
        let width = match self {
            Self::Half => 2,
            Self::Single => 4,
            Self::Double => 8,
        };
        let count = shape.iter().try_fold(1_usize, |n, extent| n.checked_mul(*extent))?;
        count.checked_mul(width).filter(|n| *n <= limits::FEATURES)
    }

    /// The numbers that bytes stand for.
    pub fn numbers(self, data: &[u8]) -> Vec<f32> {
        match self {
            Self::Half => data.chunks_exact(2).map(|b| half(u16::from_le_bytes([b[0], b[1]]))).collect(),
            Self::Single => data.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect(),
            Self::Double => data
                .chunks_exact(8)
                .map(|b| f64::from_le_bytes([b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]]) as f32)
                .collect(),
        }
    }
}

/// What a header says: `{'descr': '<f2', 'fortran_order': False, 'shape': (3, 768), }`.
fn described(header: &str) -> Result<(Kind, Vec<usize>), String> {
    let after = |key: &str| {
        let quoted = [format!("'{key}':"), format!("\"{key}\":")];
        let at = quoted.iter().find_map(|q| header.find(q.as_str()).map(|at| at + q.len()));
        at.map(|at| header[at..].trim_start()).ok_or_else(|| format!("its header has no `{key}`"))
    };
    let descr = after("descr")?.trim_start_matches(['\'', '"']);
    let kind = Kind::named(descr.split(['\'', '"']).next().unwrap_or_default())?;
    if !after("fortran_order")?.starts_with("False") {
        return Err("it is in Fortran order; write numpy.ascontiguousarray(array)".to_owned());
    }
    let shape = after("shape")?.strip_prefix('(').and_then(|rest| rest.split_once(')')).map(|(inner, _)| inner);
    let extents = shape.into_iter().flat_map(|inner| inner.split(',')).map(str::trim).filter(|part| !part.is_empty());
    let shape: Option<Vec<usize>> = extents.map(|part| part.parse().ok()).collect();
    Ok((kind, shape.ok_or("its header has no shape")?))
}

/// A number of half precision, exactly.
fn half(bits: u16) -> f32 {
    let (sign, exponent, fraction) = (u32::from(bits >> 15), i32::from(bits >> 10 & 0x1f), u32::from(bits & 0x3ff));
    let size = match exponent {
        0 => fraction as f32 * 2_f32.powi(-24),
        0x1f if fraction == 0 => f32::INFINITY,
        0x1f => f32::NAN,
        _ => (1.0 + fraction as f32 / 1024.0) * 2_f32.powi(exponent - 15),
    };
    if sign == 1 { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(header: &str, data: &[u8]) -> Vec<u8> {
        let length = u16::try_from(header.len()).unwrap();
        [MAGIC, &[1, 0], &length.to_le_bytes(), header.as_bytes(), data].concat()
    }

    #[test]
    fn numbers_of_three_precisions_are_read() {
        let bits = [0x3c00_u16, 0xc000, 0x0001, 0x3555];
        let data: Vec<u8> = bits.iter().flat_map(|b| b.to_le_bytes()).collect();
        let read = read(&file("{'descr': '<f2', 'fortran_order': False, 'shape': (2, 2), }\n", &data), "a").unwrap();
        assert_eq!((read.shape, read.numbers), (vec![2, 2], vec![1.0, -2.0, 2_f32.powi(-24), 0.333_251_95]));
        let double: Vec<u8> = [0.5_f64, -3.0].iter().flat_map(|x| x.to_le_bytes()).collect();
        let read =
            super::read(&file("{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }", &double), "a").unwrap();
        assert_eq!((read.shape, read.numbers), (vec![2], vec![0.5, -3.0]));
    }

    #[test]
    fn each_file_that_is_none_says_so_once() {
        let head = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 1), }";
        let good = file(head, &[0; 8]);
        assert!(read(&good, "a").is_ok());
        let with = |from: &str, to: &str| file(&head.replace(from, to), &[0; 8]);
        let nan: Vec<u8> = [0.0_f32, f32::NAN].iter().flat_map(|x| x.to_le_bytes()).collect();
        let mut version = good.clone();
        version[6] = 9;
        for (bytes, code, said) in [
            (b"PK\x03\x04".to_vec(), "E0706", "a: it is not a NumPy .npy file"),
            (good[..7].to_vec(), "E0706", "a: it ends early"),
            (good[..40].to_vec(), "E0706", "a: it ends early"),
            (good[..good.len() - 1].to_vec(), "E0706", "a: it ends early"),
            ([good.clone(), vec![1]].concat(), "E0706", "a: it has 1 bytes after its array"),
            (version, "E0706", "a: version 9 of the format is not supported; expected 1, 2 or 3"),
            (file(head, &nan), "E0706", "a: row 1 has a number that is not finite"),
            (with("<f4", "<i4"), "E0706", "a: it has numbers of type \"<i4\""),
            (with("<f4", "|O"), "E0706", "a: it has numbers of type \"|O\""),
            (with("False", "True"), "E0706", "a: it is in Fortran order"),
            (with("(2, 1)", "(2, 0)"), "E0706", "a: its shape is [2, 0]"),
            (with("(2, 1)", "(2, -1)"), "E0706", "a: its header has no shape"),
            (with("'shape'", "'form'"), "E0706", "a: its header has no `shape`"),
            (
                with("(2, 1)", "(2500000000,)"),
                "E0702",
                "a: it declares an array of [2500000000] numbers; the maximum is",
            ),
            (with("(2, 1)", "(9999999999, 9999999999)"), "E0702", "a: it declares an array of"),
        ] {
            let fault = read(&bytes, "a").unwrap_err();
            assert!(fault.message.starts_with(said) && fault.code.as_str() == code, "{} {}", fault.code, fault.message);
        }
    }
}
