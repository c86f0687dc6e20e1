//! W0207: `dimensions` that are a usual size in centimetres or millimetres, although lengths are in metres.

use super::facts::Facts;
use crate::ast::{ExprKind, StmtKind};
use crate::library;
use scenelang_base::{Applicability, Diagnostic, Edit, Fix, codes};

/// Units that people write sizes in, and how many of them are a metre.
const OTHERS: [(&str, &str, f64); 2] = [("centimetres", "cm", 100.0), ("millimetres", "mm", 1000.0)];
/// A size is read in another unit where each side is then at most so many times the usual one, and at least its reciprocal.
const ALIKE: f64 = 3.0;

/// Looks at all sizes that are written in plain numbers.
pub fn check(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    for linted in facts.statements {
        let stmt = linted.place.stmt;
        let StmtKind::Assign { name, path, value, .. } = &stmt.kind else { continue };
        if !matches!(path.as_slice(), [property] if property.text == "dimensions") {
            continue;
        }
        let ExprKind::Call(_, sides) = &stmt.expr(*value).kind else { continue };
        let numbers: Vec<f64> = sides.iter().filter_map(|side| plain(&stmt.expr(*side).kind)).collect();
        let Ok(written) = <[f64; 3]>::try_from(numbers) else { continue };
        let Some(category) = facts.text(&name.text, None, "category") else { continue };
        let Some(usual) = library::usual_size(category) else { continue };
        let is_alike = |per_metre: f64| {
            let ratios = written.iter().zip(usual).map(|(side, usual)| side / per_metre / usual.max(0.01));
            ratios.into_iter().all(|ratio| (1.0 / ALIKE..=ALIKE).contains(&ratio))
        };
        // What is possible in metres is meant in metres.
        if is_alike(1.0) {
            continue;
        }
        let Some((unit, suffix, _)) = OTHERS.iter().find(|(_, _, per_metre)| is_alike(*per_metre)) else { continue };
        let Some(place) = linted.place.span(stmt.expr(*value).range) else { continue };
        let [w, h, d] = written;
        let message = format!("`{}` is {w} m wide, {h} m high and {d} m deep", name.text);
        let mut diagnostic = Diagnostic::new(codes::W0207, place, message)
            .label(format!("these are probably {unit}"))
            .note("a number without a unit is in metres");
        let edits = sides.iter().filter_map(|side| {
            let place = linted.place.span(stmt.expr(*side).range)?;
            let ExprKind::Number(number, _) = stmt.expr(*side).kind else { return None };
            Some(Edit { place, text: format!("{number}{suffix}") })
        });
        diagnostic.fixes.push(Fix {
            title: format!("write them in {unit}"),
            edits: edits.collect(),
            applicability: Applicability::Unsafe,
        });
        out.push(diagnostic);
    }
}

/// The value of a number that is written without a unit.
fn plain(kind: &ExprKind) -> Option<f64> {
    match kind {
        ExprKind::Number(value, None) => Some(*value),
        _ => None,
    }
}
