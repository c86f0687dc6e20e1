//! Which objects come first where one is placed after the other, and which of two an equation gives its place.
//!
//! First what is in walls, then by how determined and how large an object is: a table before its chairs, a shelf before what
//! stands on it.

use super::Hold;
use super::terms::Term;
use scenelang_layout::Vec3;

/// Comes before everything that stands in a room.
const IN_WALLS: f64 = 10.0;
/// How early an object comes, by its terms, what holds it, and its size.
pub(super) fn of<'t>(terms: impl Iterator<Item = &'t Term>, hold: Hold, size: Vec3) -> f64 {
    let volume: f64 = size.iter().product();
    let large = ((volume.max(1e-9).log10() + 3.0) / 3.5).clamp(0.0, 1.2);
    let (mut alone, mut all) = (0.0, 0.5);
    for term in terms.filter(|t| t.is_hard()) {
        let others = term.objects.len() - 1;
        let weight = 1.0 / others.max(1) as f64;
        all += weight;
        if others == 0 {
            alone += weight;
        }
    }
    let wall = if matches!(hold, Hold::Door(..)) { IN_WALLS } else { 0.0 };
    wall + 1.5 * alone / all + 1.3 * large
}
