//! Explanations as people read them: what conflicts with a constraint, what to do, and what that does to the other constraints.

use crate::check::{Checked, Judged, Subject};
use crate::explain::{RowRef, SmallestMove, move_in_words, row_in_words};
use crate::report::model::RowKind;
use scenelang_base::codes;
use scenelang_lang::program::{Node, ObjectId, Owner, Pinned, Program};

/// What the words of one report need to know.
pub(super) struct Words<'a> {
    checked: &'a Checked,
    /// Pairs that an assertion already says collide.
    said: Vec<[ObjectId; 2]>,
}

impl<'a> Words<'a> {
    pub fn new(checked: &'a Checked) -> Self {
        let stated = checked.verdict.rows.iter().filter(|row| row.code == codes::V0102 && row.kind == RowKind::Assert);
        let said = stated.filter(|row| row.satisfied == Some(false)).filter_map(|row| match row.objects[..] {
            [a, b] => Some([a, b]),
            _ => None,
        });
        Self { checked, said: said.collect() }
    }

    /// Whether a row is P-COLLIDE of a pair of which an assertion says the same.
    pub fn is_said(&self, row: &Judged) -> bool {
        let Subject::Pair(a, b) = row.subject else { return false };
        self.said.contains(&[a, b]) || self.said.contains(&[b, a])
    }

    /// Whether a row is an assertion that says what P-COLLIDE says as well.
    pub fn says_rule(&self, row: &Judged) -> bool {
        let pairs = self.checked.verdict.rows.iter().filter(|other| other.kind == RowKind::Collision);
        let fails = |other: &Judged| other.satisfied == Some(false) && self.is_said(other);
        let same = |other: &Judged| other.objects.iter().all(|id| row.objects.contains(id));
        row.kind == RowKind::Assert && row.code == codes::V0102 && pairs.into_iter().any(|o| fails(o) && same(o))
    }

    /// Adds what the explanation of a row has to say.
    pub fn explain(&self, row: &Judged, notes: &mut Vec<String>, hints: &mut Vec<String>) {
        let (Some(explanation), Some(program)) = (&row.explanation, &self.checked.program) else { return };
        let name = |rows: &RowRef| row_in_words(program, *rows, |index| self.line(program, index, row));
        // What stands against it does not matter where a move violates nothing.
        let is_free = explanation.repair.as_ref().is_some_and(|repair| repair.breaks.is_empty());
        // What somebody stated is nearer to the reader than a rule.
        let mut opposing: Vec<&RowRef> = explanation.opposing.iter().collect();
        opposing.sort_by_key(|row| !matches!(row.subject, Subject::Statement(_)));
        for against in opposing.into_iter().filter(|_| !is_free) {
            notes.push(format!("{} conflicts with this constraint", name(against)));
        }
        if let Some(repair) = &explanation.repair {
            hints.push(format!("{}{}", move_in_words(program, repair), self.effect(repair, row, &name)));
        } else if let Some((name, sides)) = size_in_layout(program, row) {
            let written: Vec<String> = sides.iter().map(f64::to_string).collect();
            hints.push(format!("set the `scale` of `{name}` in the layout to [{}]", written.join(", ")));
            notes.extend(
                self.other_unit(name, sides)
                    .map(|unit| format!("the layout seems to be in {unit}; lengths in a layout are in metres")),
            );
        } else if explanation.searched {
            notes.push("no repair was found that moves only a few objects".to_owned());
        }
        if !explanation.pinned.is_empty() {
            let pins: Vec<String> = explanation.pinned.iter().map(name).collect();
            let pins = match pins.split_last() {
                Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
                _ => pins.join(", "),
            };
            hints.push(format!(
                "the program assigns the positions and rotations of all objects involved; \
                 change or remove one of these assignments: {pins}"
            ));
        }
    }

    /// Where a statement stands, as seen from a row.
    fn line(&self, program: &Program, index: usize, from: &Judged) -> String {
        let span = program.constraints[index].span;
        let line = self.checked.sources.lines(span).0.line;
        if span.file == from.place.file {
            format!("line {line}")
        } else {
            format!("{}:{line}", self.checked.sources.get(span.file).name())
        }
    }

    /// The unit in which the layout seems to give a size that should be `sides` metres.
    fn other_unit(&self, name: &str, sides: [f64; 3]) -> Option<&'static str> {
        let layout = self.checked.layout.as_ref()?;
        let given = layout.object(name).map(|placed| placed.scale);
        let given = given.or_else(|| layout.region(name).map(|placed| placed.scale))?;
        let is =
            |factor: f64| given.iter().zip(sides).all(|(is, side)| (is - factor * side).abs() <= 0.01 * factor * side);
        [("centimetres", 100.0), ("millimetres", 1000.0)]
            .into_iter()
            .find(|(_, factor)| is(*factor))
            .map(|(unit, _)| unit)
    }

    /// What a move does to the rest.
    fn effect(&self, repair: &SmallestMove, row: &Judged, name: &dyn Fn(&RowRef) -> String) -> String {
        let rows = self.checked.verdict.rows.iter();
        let held = rows.filter(|other| other.kind == RowKind::Assert && other.satisfied == Some(true)).count();
        let broken = repair.breaks.iter().filter(|other| other.kind == RowKind::Assert).count();
        let list = |rows: &[RowRef]| {
            const MOST: usize = 3;
            // Several parts of one object have the same name here.
            let mut names: Vec<String> = Vec::new();
            for name in rows.iter().map(name) {
                if !names.contains(&name) {
                    names.push(name);
                }
            }
            if names.len() > MOST {
                let more = names.len() - MOST;
                names.truncate(MOST);
                names.push(format!("{more} more"));
            }
            match names.split_last() {
                Some((last, [])) => last.clone(),
                Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
                None => String::new(),
            }
        };
        let mut out = String::new();
        if broken > 0 {
            let what = if row.kind == RowKind::Assert { "other assertions" } else { "assertions" };
            out += &format!("; {} of {held} {what} still hold", held - broken);
        }
        out += &match repair.breaks.as_slice() {
            [] => "; the move causes no new violations".to_owned(),
            breaks => format!("; the move violates {}", list(breaks)),
        };
        if !repair.repairs.is_empty() {
            out += &format!(" and also satisfies {}", list(&repair.repairs));
        }
        out
    }
}

/// The size that the program assigns to what the layout gives another one: no move changes that.
fn size_in_layout<'p>(program: &'p Program, row: &Judged) -> Option<(&'p str, [f64; 3])> {
    let Subject::Statement(index) = row.subject else { return None };
    let pin = program.pins.iter().find(|pin| pin.constraint == index && pin.property == Pinned::Scale)?;
    let name = match pin.owner {
        Owner::Object(id) => &program.objects[id.0 as usize].name,
        Owner::Region(id) => &program.regions[id.0 as usize].name,
    };
    let size = pin.values.first()?;
    let Node::Vector(sides) = size.node(size.root) else { return None };
    let number = |side| match size.node(side) {
        Node::Number(number) => Some(*number),
        _ => None,
    };
    let sides = sides.iter().map(|side| number(*side)).collect::<Option<Vec<_>>>()?;
    Some((name, sides.try_into().ok()?))
}
