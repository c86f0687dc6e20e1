//! Numbers in text: as short as they can be and still be read back to the same value, with a point, never an exponent.

/// Rounding leaves such traces (metres, radians); they are written as 0.
const NOTHING: f64 = 1e-12;

pub(crate) fn number(v: f64) -> String {
    // Adding 0 turns -0 into 0.
    if v.abs() < NOTHING { "0".into() } else { (v + 0.0).to_string() }
}

/// Numbers with something between them.
pub(crate) fn numbers(values: impl IntoIterator<Item = f64>, between: &str) -> String {
    values.into_iter().map(number).collect::<Vec<_>>().join(between)
}

/// Numbers with a space between them.
pub(crate) fn spaced(values: impl IntoIterator<Item = f64>) -> String {
    numbers(values, " ")
}

/// A colour component, or another figure of which four decimals are enough.
pub(crate) fn coarse(v: f32) -> f64 {
    (f64::from(v) * 1e4).round() / 1e4
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_come_back() {
        for (value, text) in
            [(1.0, "1"), (-0.0, "0"), (0.1, "0.1"), (1e-17, "0"), (-2.5e-7, "-0.00000025"), (1e15, "1000000000000000")]
        {
            assert_eq!(number(value), text);
        }
        let third = 1.0 / 3.0;
        assert_eq!(number(third).parse::<f64>().unwrap(), third);
        assert_eq!(spaced([1.0, 2.5]), "1 2.5");
    }
}
