//! Facts of a brief as JSON.

use super::{Scope, WireSource};
use crate::brief::{Dim, Fact, FactKind, Op, Pattern, Place, Quantifier, Rel, Side};
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct WireFact {
    of: Vec<String>,
    #[serde(default)]
    subject: Quantifier,
    says: WireWhat,
    #[serde(default)]
    object: Quantifier,
    #[serde(default)]
    demand: WireDemand,
    #[serde(default)]
    denied: bool,
    source: WireSource,
}

#[derive(Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum WireDemand {
    #[default]
    Must,
    Prefer,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
enum WireWhat {
    Relation { relation: Rel, to: Vec<String> },
    Place { relation: Rel, place: Place, which: Vec<String> },
    Gap { bound: Op, metres: f64, to: Vec<String> },
    Apart { bound: Op, metres: f64 },
    Rows { bound: Op, metres: f64 },
    Wall { bound: Op, metres: f64 },
    Alone { metres: f64 },
    Clear { side: Side, metres: f64 },
    Size { measure: Dim, bound: Op, metres: f64 },
    Height { bound: Op, metres: f64 },
    Path { metres: f64, to: Vec<String> },
    Pattern(Pattern),
}

impl WireFact {
    pub(super) fn of(fact: &Fact, things: &[String], request: &str) -> Self {
        let named = |list: &[usize]| list.iter().map(|i| things[*i].clone()).collect::<Vec<_>>();
        let says = match &fact.what {
            FactKind::Rel(relation, to) => WireWhat::Relation { relation: *relation, to: named(to) },
            FactKind::Place(relation, place, which) => {
                WireWhat::Place { relation: *relation, place: *place, which: which.clone() }
            }
            FactKind::Gap(bound, metres, to) => WireWhat::Gap { bound: *bound, metres: *metres, to: named(to) },
            FactKind::Among(bound, metres) => WireWhat::Apart { bound: *bound, metres: *metres },
            FactKind::Rows(bound, metres) => WireWhat::Rows { bound: *bound, metres: *metres },
            FactKind::Wall(bound, metres) => WireWhat::Wall { bound: *bound, metres: *metres },
            FactKind::Alone(metres) => WireWhat::Alone { metres: *metres },
            FactKind::Clear(side, metres) => WireWhat::Clear { side: *side, metres: *metres },
            FactKind::Size(measure, bound, metres) => {
                WireWhat::Size { measure: *measure, bound: *bound, metres: *metres }
            }
            FactKind::Height(bound, metres) => WireWhat::Height { bound: *bound, metres: *metres },
            FactKind::Path(metres, to) => WireWhat::Path { metres: *metres, to: named(to) },
            FactKind::Pattern(pattern) => WireWhat::Pattern(*pattern),
        };
        Self {
            of: named(&fact.of),
            subject: fact.subject,
            says,
            object: fact.object,
            demand: if fact.soft { WireDemand::Prefer } else { WireDemand::Must },
            denied: fact.not,
            source: WireSource::of(&fact.source, request),
        }
    }

    pub(super) fn fact(self, path: &str, scope: &Scope<'_>) -> Result<Fact, String> {
        let things = |member: &str, list: Vec<String>| -> Result<Vec<usize>, String> {
            if list.is_empty() {
                return Err(format!("{path}.{member}: expected the name of a thing"));
            }
            let each = list.iter().enumerate();
            each.map(|(i, id)| scope.a_thing(&format!("{path}.{member}[{i}]"), id)).collect()
        };
        let length = |v: f64| {
            let finite = v.is_finite() && v.abs() <= super::LARGEST;
            if finite { Ok(v) } else { Err(format!("{path}.says: {v} m is not a valid length")) }
        };
        let what = match self.says {
            WireWhat::Relation { relation, to } => FactKind::Rel(relation, things("says.relation.to", to)?),
            WireWhat::Place { relation, place, which } => FactKind::Place(relation, place, which),
            WireWhat::Gap { bound, metres, to } => FactKind::Gap(bound, length(metres)?, things("says.gap.to", to)?),
            WireWhat::Apart { bound, metres } => FactKind::Among(bound, length(metres)?),
            WireWhat::Rows { bound, metres } => FactKind::Rows(bound, length(metres)?),
            WireWhat::Wall { bound, metres } => FactKind::Wall(bound, length(metres)?),
            WireWhat::Alone { metres } => FactKind::Alone(length(metres)?),
            WireWhat::Clear { side, metres } => FactKind::Clear(side, length(metres)?),
            WireWhat::Size { measure, bound, metres } => FactKind::Size(measure, bound, length(metres)?),
            WireWhat::Height { bound, metres } => FactKind::Height(bound, length(metres)?),
            WireWhat::Path { metres, to } => FactKind::Path(length(metres)?, things("says.path.to", to)?),
            WireWhat::Pattern(pattern) => FactKind::Pattern(pattern),
        };
        Ok(Fact {
            of: things("of", self.of)?,
            subject: self.subject,
            what,
            object: self.object,
            soft: matches!(self.demand, WireDemand::Prefer),
            not: self.denied,
            source: scope.source(&format!("{path}.source"), self.source)?,
        })
    }
}
