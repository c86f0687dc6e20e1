//! Tolerances, all in one place, and the options of a check.

use crate::explain::Explain;
use scenelang_layout::convex::Geometry;
use serde::{Deserialize, Serialize};

/// Every tolerance of a judgement. Each is part of a margin, so that a margin ≥ 0 means that the thing holds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Tolerances {
    /// `=` of lengths and plain numbers, equal vectors, pinned vertices (metres).
    pub equal: f64,
    /// `=` of degrees, equal rotations (degrees).
    pub angle: f64,
    /// `<=`, `>=` and physical rules hold down to minus this (metres or degrees).
    pub order: f64,
    /// How deep solids may penetrate, or a box may leave its container; slack of `visible`, `clear`, `reachable` (metres).
    pub contact: f64,
    /// How far the lowest point may be from what carries it (metres).
    pub support: f64,
    /// How far from horizontal a top may be and still carry something (degrees).
    pub level: f64,
    /// How far a door may be from the middle of its wall, beyond the walls' own thickness (metres).
    pub door: f64,
}

impl Default for Tolerances {
    fn default() -> Self {
        Self { equal: 1e-3, angle: 0.1, order: 1e-6, contact: 1e-3, support: 5e-3, level: 1.0, door: 1e-2 }
    }
}

impl Tolerances {
    /// What each is called in settings and reports.
    pub const NAMES: [&str; 7] = ["equal", "angle", "order", "contact", "support", "level", "door"];

    pub fn named(&mut self, name: &str) -> Option<&mut f64> {
        Some(match name {
            "equal" => &mut self.equal,
            "angle" => &mut self.angle,
            "order" => &mut self.order,
            "contact" => &mut self.contact,
            "support" => &mut self.support,
            "level" => &mut self.level,
            "door" => &mut self.door,
            _ => return None,
        })
    }
}

/// Thickness of the walls of a room, unless an option says otherwise (metres).
pub const DEFAULT_ETA: f64 = 0.03;

/// Of what P-OPEN demands that it opens.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Opens {
    /// The doors of rooms, and furniture as far as its asset says is of use.
    #[default]
    All,
    /// The doors of rooms.
    Doors,
    /// Nothing.
    None,
}

impl Opens {
    /// Each, as settings and reports call it.
    pub const NAMES: [(&str, Self); 3] = [("all", Self::All), ("doors", Self::Doors), ("none", Self::None)];

    /// What it is called.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, opens)| *opens == self).map_or("", |(name, _)| *name)
    }
}

/// How to judge, and what to report.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    pub tolerances: Tolerances,
    /// Thickness of the walls of a room (metres).
    pub eta: f64,
    /// What a solid is: its parts, or its box always. Declared support surfaces count with the parts.
    pub geometry: Geometry,
    /// Whether the physical rules apply.
    pub physics: bool,
    /// Of what P-OPEN demands that it opens.
    pub opens: Opens,
    /// How much is said.
    pub detail: Detail,
}

/// How much a report says. No verdict depends on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// Whether physical rows that hold are listed too.
    pub all: bool,
    /// Whether rows that hold say what was measured, too: a sentence takes longer than the verdict.
    pub sentences: bool,
    /// Whether it is said what bars a way, and how wide it is there: that takes longer than the verdict, too.
    pub bars: bool,
    /// For how many violations a move that repairs them is looked for. It is `engine` that looks.
    pub explain: Explain,
    /// Whether contradictions come with their proofs, step by step.
    pub proofs: bool,
    /// How far the room around what opens is measured (metres): more than that counts as that. Where it is finite, what is
    /// missing is known roughly.
    pub clearance: f64,
}

impl Default for Detail {
    fn default() -> Self {
        Self {
            all: false,
            sentences: true,
            bars: true,
            explain: Explain::default(),
            proofs: false,
            clearance: f64::INFINITY,
        }
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            tolerances: Tolerances::default(),
            eta: DEFAULT_ETA,
            geometry: Geometry::default(),
            physics: true,
            opens: Opens::default(),
            detail: Detail::default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_tolerance_has_its_name() {
        let mut tolerances = Tolerances::default();
        for (i, name) in Tolerances::NAMES.iter().enumerate() {
            *tolerances.named(name).unwrap() = i as f64;
        }
        let echoed = serde_json::to_value(tolerances).unwrap();
        let numbers: Vec<f64> = Tolerances::NAMES.iter().map(|name| echoed[*name].as_f64().unwrap()).collect();
        assert_eq!(numbers, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(echoed.as_object().unwrap().len(), Tolerances::NAMES.len());
    }
}
