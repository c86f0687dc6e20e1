//! What a comparison of a predicate measured, by the template of the predicate.

use super::describe::{relation, rounded, with_unit};
use crate::eval::{Scratch, Value};
use scenelang_lang::program::{Comparison, Program, Unit, Wording};
use scenelang_lang::wording::{Named, Shown, TemplatePiece, Term};

/// A comparison that decided.
pub(super) struct Compared {
    /// As it decided: under a `not` by its contrary.
    pub op: Comparison,
    /// Unit of both sides.
    pub unit: Unit,
    /// What was measured.
    pub left: f64,
    /// What it was compared with.
    pub right: f64,
    /// The verdict of the whole.
    pub holds: bool,
}

impl Compared {
    /// The sentence: what was measured, then what it must be.
    pub fn by(&self, wording: &Wording, program: &Program, scratch: &Scratch<f64>) -> String {
        let number = |index: usize| match wording.named.get(index) {
            Some(Named::Constant(n, unit)) => Some((*n, *unit)),
            Some(Named::Node(node, unit)) => match scratch.get(*node) {
                Ok(Value::Number(n)) => Some((n, *unit)),
                _ => None,
            },
            _ => None,
        };
        let name = |index: usize| match wording.named.get(index) {
            Some(Named::Object(id)) => format!("`{}`", program.objects[id.0 as usize].name),
            Some(Named::Region(id)) => format!("`{}`", program.regions[id.0 as usize].name),
            _ => number(index).map_or_else(|| "unknown".to_owned(), |(n, unit)| with_unit(n, unit)),
        };
        let pieces = &wording.template.pieces;
        let choice = pieces.iter().find_map(|piece| match piece {
            TemplatePiece::Choice(texts) => Some(texts),
            _ => None,
        });
        let (shift, shown) = pieces
            .iter()
            .find_map(|piece| match piece {
                TemplatePiece::Value { terms, shown } => Some((terms, *shown)),
                _ => None,
            })
            .map_or((0.0, Shown::WithUnit), |(terms, shown)| {
                let of = |term: &Term| match term {
                    Term::Number(n) => n.parse().unwrap_or(0.0),
                    Term::Name(index) => number(*index).map_or(0.0, |(n, _)| n),
                };
                (terms.iter().map(|(minus, term)| if *minus { -of(term) } else { of(term) }).sum(), shown)
            });
        // What is no more than rounding has no sign.
        let [value, limit] = [self.left + shift, self.right + shift].map(|n| if n.abs() < 5e-5 { 0.0 } else { n });
        let quantity = |n: f64| {
            let n = if choice.is_some() { n.abs() } else { n };
            match shown {
                Shown::WithUnit => with_unit(n, self.unit),
                Shown::Plain => rounded(n),
                Shown::Turn(most) => format!("{}°", rounded((turn(n, limit, most) * 10.0).round() / 10.0)),
            }
        };
        // The larger a cosine, the smaller the angle; and what is at least -0.4 m in front is at most 0.4 m behind.
        let is_mirrored = matches!(shown, Shown::Turn(_)) || choice.is_some() && limit < 0.0;
        let op = if is_mirrored { mirrored(self.op) } else { self.op };
        let side = |texts: &[String; 2], n: f64| texts[usize::from(n < 0.0)].clone();
        let mut out = String::new();
        for piece in pieces {
            out += &match piece {
                TemplatePiece::Text(text) => text.clone(),
                TemplatePiece::Name(index) => name(*index),
                TemplatePiece::Value { .. } => quantity(value),
                TemplatePiece::Choice(texts) => side(texts, value),
            };
        }
        let must = if self.holds { "" } else { "but must be " };
        // "beyond the front" is followed by what it is beyond, "to the right" is not.
        let it = if matches!(pieces.last(), Some(TemplatePiece::Choice(_))) { "" } else { " it" };
        let whither = choice.map_or_else(String::new, |texts| format!(" {}{it}", side(texts, limit)));
        match (choice, op) {
            // "at least 0 m beyond it" says no more than "beyond it".
            (Some([beyond, _]), Comparison::Ge | Comparison::Gt) if limit == 0.0 && !self.holds => {
                format!("{out}, but must be {beyond}{it}")
            }
            (Some([beyond, _]), Comparison::Le | Comparison::Lt) if limit == 0.0 && !self.holds => {
                format!("{out}, but must not be {beyond}{it}")
            }
            _ => format!("{out}, {must}{} {}{whither}", relation(op), quantity(limit)),
        }
    }
}

/// The angle (degrees) whose cosine is to that of `most` as a value to its limit; without a limit there is no direction.
fn turn(value: f64, limit: f64, most: f64) -> f64 {
    let cosine = if limit.abs() > 1e-12 { most.to_radians().cos() * value / limit } else { 1.0 };
    cosine.clamp(-1.0, 1.0).acos().to_degrees()
}

/// The same comparison of what grows as the other falls, such as angles and their cosines.
fn mirrored(op: Comparison) -> Comparison {
    match op {
        Comparison::Lt => Comparison::Gt,
        Comparison::Le => Comparison::Ge,
        Comparison::Gt => Comparison::Lt,
        Comparison::Ge => Comparison::Le,
        Comparison::Eq | Comparison::Ne => op,
    }
}
