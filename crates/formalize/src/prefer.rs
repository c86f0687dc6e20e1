//! Statements that are given up: what must hold becomes what is preferred, and a note says why.

use crate::draft::{Demand, Draft, Note, Opening, OpeningKind, Statement, ThingOrigin};
use crate::write::{clear_space, number};
use scenelang_lang::program::{ConstraintKind, Program};
use std::collections::BTreeMap;

/// Which statements of a draft the constraints of its program are.
pub struct Stated {
    by_constraint: Vec<Option<usize>>,
}

impl Stated {
    /// For the program that was written of the draft.
    pub fn new(draft: &Draft, program: &Program) -> Self {
        let mut by_text: BTreeMap<String, usize> = BTreeMap::new();
        for (i, statement) in draft.statements.iter().enumerate() {
            if statement.demand == Demand::Must {
                by_text.insert(code(&statement.text), i);
            }
        }
        let of = |c: &scenelang_lang::program::Constraint| {
            (c.kind == ConstraintKind::Assert).then(|| by_text.get(&code(&c.text)).copied()).flatten()
        };
        Self { by_constraint: program.constraints.iter().map(of).collect() }
    }

    /// The statement that a constraint is; `None`: it is none that could be given up.
    pub fn of(&self, constraint: usize) -> Option<usize> {
        self.by_constraint.get(constraint).copied().flatten()
    }

    /// How willingly a constraint is given up, the higher, the sooner: first what nobody said, then what was said last.
    /// `None`: never.
    pub fn rank(&self, draft: &Draft, constraint: usize) -> Option<usize> {
        self.of(constraint).map(|i| match &draft.statements[i].source {
            ThingOrigin::Inferred(_) => draft.statements.len() + i,
            ThingOrigin::Stated(_) => i,
        })
    }
}

impl Draft {
    /// Turns assertions, by their indices, into preferences. Whether there were any.
    pub fn prefer(&mut self, mut statements: Vec<usize>, reason: &str) -> bool {
        statements.sort_unstable();
        statements.dedup();
        for &i in &statements {
            let statement = &mut self.statements[i];
            let source = statement.source.clone();
            match weaker(&statement.text) {
                // What is left of it must hold.
                Some(weaker) => {
                    let text = std::mem::replace(&mut statement.text, weaker);
                    self.statements.push(Statement {
                        demand: Demand::Prefer,
                        text,
                        source: source.clone(),
                        relaxed: true,
                    });
                }
                None => (statement.demand, statement.relaxed) = (Demand::Prefer, true),
            }
            self.note(&source, reason);
        }
        !statements.is_empty()
    }

    /// Turns the space that a door is given to open, if nobody asked for it, into a preference. Whether there is such a door.
    pub fn squeeze(&mut self, name: &str) -> bool {
        let is_door = |o: &&Opening| o.kind == OpeningKind::Door && o.name == name;
        let Some(door) = self.openings.iter().find(is_door) else { return false };
        let asked = |s: &Statement| {
            let code = code(&s.text);
            code.contains(&format!("clear({name},"))
        };
        if self.statements.iter().any(asked) {
            return false;
        }
        let depth = number(clear_space(door));
        self.statements.push(Statement {
            demand: Demand::Prefer,
            text: format!("clear({name}, front, {depth}) and clear({name}, behind, {depth})"),
            source: ThingOrigin::Inferred("a door opens freely where there is space for it".to_owned()),
            relaxed: false,
        });
        true
    }

    /// Lets a thing stand in another room than the one it belongs to, which becomes a preference. Whether there is such a thing.
    pub fn let_out(&mut self, name: &str) -> bool {
        let rooms = &self.rooms;
        let found = self.things.iter_mut().find(|thing| thing.name == name);
        let Some((thing, room)) = found.and_then(|thing| rooms.get(thing.room?).map(|room| (thing, room))) else {
            return false;
        };
        let text = match thing.count {
            0 | 1 => format!("inside({name}, {})", room.name),
            _ => format!("forall each in {name}: inside(each, {})", room.name),
        };
        let source = thing.source.clone();
        thing.room = None;
        self.note(&source, "no layout was found with it inside its room, so this is a preference");
        self.statements.push(Statement { demand: Demand::Prefer, text, source, relaxed: true });
        true
    }

    /// Notes that words of the request became no statement, or none that must hold.
    pub fn note(&mut self, source: &ThingOrigin, reason: &str) {
        if let ThingOrigin::Stated(at) = source {
            let note = Note { at: at.clone(), reason: reason.to_owned() };
            if !self.notes.contains(&note) {
                self.notes.push(note);
            }
        }
    }
}

/// What a statement says at least, if the library has a weaker predicate: a plate that finds no room on a full table
/// stays on it, with its middle.
fn weaker(text: &str) -> Option<String> {
    const WEAKER: [(&str, &str); 2] = [("restsOn(", "on("), ("looksAt(", "facing(")];
    let (strong, weak) = WEAKER.iter().find(|(strong, _)| text.contains(strong))?;
    Some(text.replace(strong, weak))
}

/// A statement without blanks.
pub(crate) fn code(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).collect()
}
