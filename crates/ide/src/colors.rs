//! Colours in a program: texts that are assigned to a colour, and how else one could be written.

use crate::Snapshot;
use scenelang_assets::{color_names, color_of};
use scenelang_base::TextRange;
use scenelang_lang::ast::{ExprKind, StmtKind};
use scenelang_lang::db::Cancelled;
use scenelang_lang::types::Ty;

/// Red, green, blue.
pub type Rgb = [u8; 3];

/// Texts that name one colour, without their quotation marks, in the order of the text.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn colors(snapshot: &Snapshot) -> Result<Vec<(TextRange, Rgb)>, Cancelled> {
    let mut out = Vec::new();
    for (place, hir) in &snapshot.meanings()?.statements {
        let StmtKind::Assign { value, .. } = &place.stmt.kind else { continue };
        let colour = hir.target.as_ref().is_some_and(|t| t.ty == Ty::Color);
        let expr = place.stmt.expr(*value);
        let ExprKind::Text(text) = &expr.kind else { continue };
        if colour && let Some(rgb) = color_of(text) {
            let TextRange { start, end } = expr.range.shifted(place.offset);
            out.push((TextRange { start: start + 1, end: end - 1 }, rgb));
        }
    }
    Ok(out)
}

/// How a colour is written: exactly, and by the nearest name, if that is near.
pub fn spellings(rgb: Rgb) -> Vec<String> {
    /// How far the nearest name may be.
    const NEAR: u32 = 30;
    let [r, g, b] = rgb;
    let far = |other: Rgb| -> u32 { rgb.iter().zip(other).map(|(x, y)| u32::from(x.abs_diff(y))).sum() };
    let named = color_names().filter_map(|name| Some((far(color_of(name)?), name)));
    let nearest = named.min().filter(|(distance, _)| *distance <= NEAR).map(|(_, name)| name.to_owned());
    std::iter::once(format!("#{r:02x}{g:02x}{b:02x}")).chain(nearest).collect()
}
