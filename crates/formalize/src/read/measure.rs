//! Lengths with what is said of them: "at least 1.2 m wide", "not more than three metres", "5 by 4 m", "30 m²".

use super::number::{area, count, length, unit};
use super::phrases::Phrases;
use super::token::{Token, WordKind};
use crate::brief::{Dim, Op};
use std::sync::OnceLock;

#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// How it binds.
    pub op: Op,
    /// Whether words said how it binds.
    pub said: bool,
    /// Metres: one, or those of a size in their order; for an area, square metres.
    pub values: Vec<f64>,
    /// Which measure of a thing.
    pub dims: Vec<Dim>,
    /// Whether it is an area.
    pub area: bool,
    /// The lower end of a range, whose upper end is the value: "0.6 to 1.2 m".
    pub least: Option<f64>,
    /// Whether it is said to be so much and no more: "exactly 1 m".
    pub exact: bool,
}

impl Measure {
    /// A size of a thing, with no condition.
    pub fn plain(&self) -> bool {
        !self.said
    }
}

/// What is said before a measure, and after it: how it binds, and which measure it is.
struct Bounds {
    before: Phrases<(Op, Option<Dim>)>,
    after: Phrases<(Op, Option<Dim>)>,
}

fn bounds() -> &'static Bounds {
    static BOUNDS: OnceLock<Bounds> = OnceLock::new();
    const OPS: [(&str, Op); 3] = [("least", Op::Least), ("most", Op::Most), ("equal", Op::Equal)];
    const DIMS: [(&str, Dim); 7] = [
        ("width", Dim::Width),
        ("height", Dim::Height),
        ("depth", Dim::Depth),
        ("length", Dim::Length),
        ("across", Dim::Across),
        ("ceiling", Dim::Ceiling),
        ("elevation", Dim::Elevation),
    ];
    let bound = |key: &str| {
        let word = |n: usize| key.split(' ').nth(n).unwrap_or("");
        let op = OPS.iter().find(|(name, _)| *name == word(0))?.1;
        Some((op, DIMS.iter().find(|(name, _)| *name == word(1)).map(|(_, dim)| *dim)))
    };
    BOUNDS.get_or_init(|| {
        let text = include_str!("../../data/measures.txt");
        Bounds {
            before: Phrases::new(text, bound),
            after: Phrases::new(text, |key| key.strip_prefix("after ").and_then(bound)),
        }
    })
}

/// The measure that begins here, and how many tokens it takes.
pub fn measure(rest: &[Token]) -> Option<(Measure, usize)> {
    let Bounds { before: bound, after } = bounds();
    let before = bound.longest(rest).map(|((op, dim), n)| (op, dim, n));
    // Two in a row: "width about 3 m", "at least about".
    let mut used = before.map_or(0, |b| b.2);
    let mut op = before.map_or(Op::Equal, |b| b.0);
    let mut dims: Vec<Dim> = before.and_then(|b| b.1).into_iter().collect();
    if used > 0
        && let Some(((second, dim), n)) = bound.longest(&rest[used..])
    {
        used += n;
        if op == Op::Equal {
            op = second;
        }
        dims.extend(dim);
    }
    let said = op != Op::Equal;
    if let Some((square, n)) = area(&rest[used..]) {
        return Some((
            Measure { op, said, values: vec![square], dims, area: true, least: None, exact: false },
            used + n,
        ));
    }
    let between = range(&rest[used..]).filter(|_| op == Op::Equal);
    let least = between.map(|(least, ..)| least);
    if let Some((_, most, n)) = between {
        let mut used = used + n;
        if let Some((dim, n)) = dim_after(&rest[used..]) {
            dims.push(dim);
            used += n;
        }
        return Some((
            Measure { op: Op::Most, said: true, values: vec![most], dims, area: false, least, exact: false },
            used,
        ));
    }
    let (mut values, n) = size(&rest[used..], !dims.is_empty() && dims.iter().all(|d| *d == Dim::Ceiling))?;
    used += n;
    let mut said = said;
    // "4.2 m square"
    if values.len() == 1 && dims.is_empty() && rest.get(used).is_some_and(|t| t.is("square")) {
        values.push(values[0]);
        used += 1;
    }
    if values.len() == 1
        && let Some((dim, n)) = dim_after(&rest[used..])
    {
        dims.push(dim);
        used += n;
    }
    if let Some(((after, _), n)) = after.longest(&rest[used..]) {
        op = after;
        said = true;
        used += n;
    }
    if values.len() == 1
        && dims.is_empty()
        && let Some((dim, n)) = dim_after(&rest[used..])
    {
        dims.push(dim);
        used += n;
    }
    // "Hung no lower than 1.5 m above the floor": how high it is, and not how tall.
    let floor = |k: usize| rest.get(k).is_some_and(|t| t.is("floor") || t.is("ground"));
    let above = rest.get(used).is_some_and(|t| t.is("above") || t.is("off"));
    if dims == [Dim::Height] && before.is_some() && said && above && floor(used + 2) {
        dims = vec![Dim::Elevation];
        used += 3;
    }
    let exact = op == Op::Equal && rest.first().is_some_and(|t| t.is("exactly") || t.is("precisely"));
    Some((Measure { op, said, values, dims, area: false, least, exact }, used))
}

/// "0.6 to 1.2 m", "between 50 cm and 1 m": both ends, and how many tokens.
fn range(rest: &[Token]) -> Option<(f64, f64, usize)> {
    let between = rest.first()?.is("between");
    let from = usize::from(between || rest[0].is("from"));
    let (low, _) = count(std::slice::from_ref(rest.get(from)?))?;
    let own = rest.get(from + 1).and_then(|t| unit(&t.text));
    let to = from + 1 + usize::from(own.is_some());
    let joins = |t: &&Token| if between { t.is("and") } else { ["to", "-", "–", "—"].iter().any(|w| t.is(w)) };
    rest.get(to).filter(joins)?;
    let (high, n) = length(&rest[to + 1..])?;
    let end = to + 1 + n;
    let low = low * own.or_else(|| unit(&rest[end - 1].text)).unwrap_or(1.0);
    (low > 0.0 && low < high).then_some((low, high, end))
}

/// "wide", "in height", "foot ceiling".
fn dim_after(rest: &[Token]) -> Option<(Dim, usize)> {
    let skip = usize::from(
        rest.first().is_some_and(|t| t.is("in"))
            && rest
                .get(1)
                .is_some_and(|t| matches!(t.text.as_str(), "width" | "height" | "length" | "depth" | "diameter")),
    );
    let dim = match rest.get(skip)?.text.as_str() {
        "wide" | "width" => Dim::Width,
        "high" | "tall" | "height" => Dim::Height,
        "deep" | "depth" => Dim::Depth,
        "long" | "length" => Dim::Length,
        "across" | "diameter" => Dim::Across,
        "ceiling" | "ceilings" => Dim::Ceiling,
        _ => return None,
    };
    // "1 m deep shelf" yes; "2 m high ceiling" is one of the room.
    if dim == Dim::Height && rest.get(skip + 1).is_some_and(|t| t.is("ceiling") || t.is("ceilings")) {
        return Some((Dim::Ceiling, skip + 2));
    }
    Some((dim, skip + 1))
}

/// One length, or several with "by" or "x" between them: each with its unit, or the last's for all. A height of a
/// ceiling needs no unit.
fn size(rest: &[Token], bare: bool) -> Option<(Vec<f64>, usize)> {
    let mut numbers: Vec<(f64, bool)> = Vec::new();
    let mut used = 0;
    let mut last_unit = None;
    let mut dims_between = false;
    loop {
        if let Some((metres, n)) = length(&rest[used..]) {
            numbers.push((metres, true));
            used += n;
            last_unit = rest.get(used - 1).and_then(|t| unit(&t.text));
            if dim_after(&rest[used..]).is_some() && rest.get(used + 1).is_some_and(cross) {
                // "5 m wide by 4 m deep"
                used += 1;
                dims_between = true;
            }
        } else if let Some((n, k)) = count(&rest[used..]).filter(|_| rest[used].kind != WordKind::Sign('\'')) {
            numbers.push((n, false));
            used += k;
        } else {
            break;
        }
        if numbers.len() == 3
            || !rest.get(used).is_some_and(cross)
            || rest
                .get(used + 1)
                .is_none_or(|t| count(std::slice::from_ref(t)).is_none() && length(&rest[used + 1..]).is_none())
        {
            break;
        }
        used += 1;
    }
    if dims_between && dim_after(&rest[used..]).is_some() {
        used += 1;
    }
    if numbers.is_empty() || (numbers.len() == 1 && !numbers[0].1 && !bare) {
        return None;
    }
    if numbers.len() > 1 && numbers.iter().all(|n| !n.1) {
        // "7 by 5": metres, unless such numbers are none of a room or thing.
        if !numbers.iter().all(|n| (0.2..=60.0).contains(&n.0)) {
            return None;
        }
    }
    let scale = last_unit.unwrap_or(1.0);
    let values: Vec<f64> = numbers.iter().map(|(n, has)| if *has { *n } else { n * scale }).collect();
    values.iter().all(|v| *v > 0.0 && *v < 1000.0).then_some((values, used))
}

fn cross(t: &Token) -> bool {
    matches!(t.text.as_str(), "by" | "x" | "*")
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn measures() {
        for (text, op, values, dims) in [
            ("at least 1.2 m wide", Op::Least, vec![1.2], vec![Dim::Width]),
            ("5 by 4 metres", Op::Equal, vec![5.0, 4.0], vec![]),
            ("9 x 8 m, 3.2 m high", Op::Equal, vec![9.0, 8.0], vec![]),
            ("6x4m", Op::Equal, vec![6.0, 4.0], vec![]),
            ("5.4 m by 4.6 m", Op::Equal, vec![5.4, 4.6], vec![]),
            ("ceiling 2.6", Op::Equal, vec![2.6], vec![Dim::Ceiling]),
            ("not more than three metres", Op::Most, vec![3.0], vec![]),
            ("2m or more", Op::Least, vec![2.0], vec![]),
            ("16 feet by 13 feet", Op::Equal, vec![4.8768, 3.9624], vec![]),
            ("no higher than 1.4 m", Op::Most, vec![1.4], vec![Dim::Height]),
        ] {
            let (m, _) = measure(&tokens(text, 100).0).expect(text);
            assert_eq!((m.op, m.dims), (op, dims), "{text}");
            assert_eq!(m.least, None, "{text}");
            assert!(
                m.values.len() == values.len() && m.values.iter().zip(&values).all(|(a, b)| (a - b).abs() < 1e-9),
                "{text}: {:?}",
                m.values
            );
        }
    }

    #[test]
    fn ranges_have_two_ends() {
        for (text, low, high) in [
            ("0.6 to 1.2 m from the wall", 0.6, 1.2),
            ("between 50 cm and 1 m", 0.5, 1.0),
            ("60-90 cm", 0.6, 0.9),
            ("from 2 to 3 metres wide", 2.0, 3.0),
        ] {
            let (m, _) = measure(&tokens(text, 100).0).expect(text);
            assert_eq!((m.op, m.said), (Op::Most, true), "{text}");
            assert!((m.values[0] - high).abs() < 1e-9 && (m.least.unwrap_or(0.0) - low).abs() < 1e-9, "{text}: {m:?}");
        }
    }
}
