//! Numbers and measures of a noun phrase: "at least four chairs", "a 55-inch screen".

use super::super::chunk::Dims;
use super::super::measure::{Measure, measure};
use super::super::number;
use super::super::token::Token;
use super::{Det, NounKind, Np, noun_phrase};
use crate::brief::{Dim, Op};

/// "at least four chairs", "only two tables": a noun phrase with what its number is said to be.
pub fn bounded(rest: &[Token]) -> Option<(Np, usize)> {
    let text = |i: usize| rest.get(i).map_or("", |t| t.text.as_str());
    let (words, op, more) = match (text(0), text(1), text(2)) {
        ("at", "least", _) => (2, Op::Least, 0),
        ("at", "most", _) | ("up", "to", _) => (2, Op::Most, 0),
        ("no" | "not", "less" | "fewer", "than") => (3, Op::Least, 0),
        ("no" | "not", "more", "than") => (3, Op::Most, 0),
        ("more", "than", _) => (2, Op::Least, 1),
        ("less" | "fewer", "than", _) => (2, Op::Most, -1),
        ("exactly" | "precisely" | "only" | "just", _, _) => (1, Op::Equal, 0),
        _ => return None,
    };
    let (n, _) = number::count(rest.get(words..)?)?;
    if n.fract() != 0.0 || measure(rest).is_some() || measure(&rest[words..]).is_some() {
        return None;
    }
    let (mut np, used) = noun_phrase(&rest[words..], true)?;
    let counted = np.kind == NounKind::Thing && np.det == Det::Number && np.nth.is_none();
    let count = np.count?.checked_add_signed(more).filter(|n| counted && *n > 0)?;
    np.count = Some(count);
    np.bound = Some(op);
    Some((np, used + words))
}

/// A single measure in inches, and how it is said.
pub(super) fn in_inches(m: &Measure, tokens: &[Token]) -> Option<(f64, String)> {
    let unit = tokens.last().is_some_and(|t| matches!(t.text.as_str(), "inch" | "inches" | "\""));
    let value = *m.values.first().filter(|_| unit && m.values.len() == 1 && m.dims.is_empty())?;
    Some((value, format!("{}-inch", (value / 0.0254 * 10.0).round() / 10.0)))
}

/// Adds sizes given as "2 m wide" or "2 by 1 m".
pub fn add_dims(dims: &mut Dims, values: &[f64], named: &[Dim]) {
    match (values, named) {
        ([one], [dim]) => dims.push((*dim, *one)),
        ([one], []) => dims.push((Dim::Length, *one)),
        (many, _) => {
            for (value, dim) in many.iter().zip([Dim::Width, Dim::Depth, Dim::Height]) {
                dims.push((dim, *value));
            }
        }
    }
}
