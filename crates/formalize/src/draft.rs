//! What a request says, before it is a program: a value that can be printed, checked and edited.

pub use crate::brief::{Look, Note, ThingOrigin};
use crate::write::number;

/// A request, read. Names are identifiers of the language, each used once among rooms, openings and things.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draft {
    /// The request itself: every [`Source::Stated`] range is one of bytes in it.
    pub request: String,
    /// Outdoor: no walls, no ceiling.
    pub outdoor: bool,
    /// The regions.
    pub rooms: Vec<DraftRoom>,
    /// Doors and windows.
    pub openings: Vec<Opening>,
    /// The objects.
    pub things: Vec<DraftThing>,
    /// How single elements of arrays look that are told apart: "the first chair is red".
    pub looks: Vec<ElementLook>,
    /// What is asked of them.
    pub statements: Vec<Statement>,
    /// What opens less far than is useful, because its room has no place for more.
    pub narrowed: Vec<Narrowed>,
    /// What a room of its kind has, but was left out again because no layout was found with it: a category and how many.
    pub left_out: Vec<(String, usize)>,
    /// The parts of the request that became no statement.
    pub notes: Vec<Note>,
    /// Whether the program takes over the guidelines of the library.
    pub guided: bool,
    /// Where a search may begin: the name of an object or of an element, its x, y, z in the scene, and its turn. No part of
    /// the program.
    pub places: Vec<(String, [f64; 4])>,
    /// How often nothing was found in rooms as large as their things need; see [`crate::Reading::roomier`].
    pub roomier: usize,
}

impl Draft {
    /// Where a search may begin with something.
    pub fn place_of(&self, name: &str) -> Option<[f64; 4]> {
        self.places.iter().find(|(other, _)| other == name).map(|(_, place)| *place)
    }
}

/// A region of the program.
#[derive(Clone, Debug, PartialEq)]
pub struct DraftRoom {
    /// An identifier of the language.
    pub name: String,
    /// What the request calls it: "meeting room".
    pub kind: String,
    /// Where its origin lies in the scene (x, z of the middle of its floor), in metres.
    pub at: [f64; 2],
    /// Width (x), height (y), depth (z) in metres, inside the walls.
    pub size: [f64; 3],
    /// Whether the request gave the size (else it is what its content needs).
    pub sized: bool,
    /// Width and depth that the rows need which are asked for, in metres; zero without rows.
    pub rows: [f64; 2],
    /// The floor's outline in metres (x, z in the scene), where it is no rectangle.
    pub outline: Option<Vec<[f64; 2]>>,
    /// The look of its floor.
    pub floor: Surface,
    /// The look of its walls.
    pub walls: Surface,
    /// Where it comes from.
    pub source: ThingOrigin,
}

/// How a floor or a wall looks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// A colour the language knows: a CSS name or "#rrggbb".
    pub color: Option<String>,
    /// In one or a few words: "oak".
    pub material: Option<String>,
}

/// A door or a window between two rooms, or from one to the outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// An identifier of the language.
    pub name: String,
    /// Which of the two.
    pub kind: OpeningKind,
    /// What kind of door or window, where it is not a plain one: "garage door".
    pub category: Option<String>,
    /// Indices into [`Draft::rooms`]: one (to the outside) or two.
    pub rooms: Vec<usize>,
    /// Width, height, depth in metres.
    pub size: [f64; 3],
    pub look: Look,
    /// Where it comes from.
    pub source: ThingOrigin,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpeningKind {
    /// To walk through.
    Door,
    /// To look through.
    Window,
}

/// An object of the program, or an array of like ones.
#[derive(Clone, Debug, PartialEq)]
pub struct DraftThing {
    /// An identifier of the language.
    pub name: String,
    /// Lower case, singular, underscores: "office_chair".
    pub category: String,
    /// How many; 1: no array.
    pub count: usize,
    /// Index into [`Draft::rooms`].
    pub room: Option<usize>,
    /// Width, height, depth in metres, as far as the request gives them.
    pub size: Option<[f64; 3]>,
    pub look: Look,
    /// Where each element stands from the first (x and z in metres), and how it is turned (degrees), if the request gives its
    /// rows or groups.
    pub formation: Vec<[f64; 3]>,
    /// Where it comes from.
    pub source: ThingOrigin,
}

/// The look of one element of an array, beside that of all of them.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementLook {
    /// The name of the array, and which element of it.
    pub of: String,
    pub element: usize,
    pub look: Look,
}

/// One statement of the program.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Whether it must hold.
    pub demand: Demand,
    /// What is asked for, without keyword, semicolon, `@req` and comments: `near(lamp, sofa, 0.5)`.
    pub text: String,
    /// Where it comes from.
    pub source: ThingOrigin,
    /// Whether it was to hold, and is only preferred because it cannot, or because no layout was found in which it does.
    pub relaxed: bool,
}

/// That an object opens less far than is useful.
#[derive(Clone, Debug, PartialEq)]
pub struct Narrowed {
    /// The object, or the element of an array: `wardrobe[1]`.
    pub object: String,
    /// Whether doors and lids are meant, which turn, or drawers, which slide.
    pub turns: bool,
    /// How far it has to open (degrees or metres).
    pub least: f64,
    /// How far is useful.
    pub useful: f64,
}

impl Narrowed {
    /// The assertion of the program.
    pub fn line(&self) -> String {
        let Self { object, turns, .. } = self;
        let amount = number(self.least);
        if *turns {
            format!("assert opens({object}, {amount}deg);")
        } else {
            format!("assert slides({object}, {amount});")
        }
    }

    /// What it comes to: "`wardrobe` opens 62° of 90°: the room is 3 × 3 m".
    pub fn told(&self, draft: &Draft) -> String {
        let object = &self.object;
        let amount = |x: f64| {
            if self.turns { format!("{}°", number(x)) } else { format!("{:.2} m", (x * 100.0 + 1e-6).floor() / 100.0) }
        };
        let (least, useful) = (amount(self.least), amount(self.useful));
        let found = match (self.least > 0.0, self.turns) {
            (true, true) => format!("`{object}` opens {least} of {useful}"),
            (true, false) => format!("the drawers of `{object}` open {least} of {useful}"),
            (false, true) => format!("`{object}` does not open"),
            (false, false) => format!("the drawers of `{object}` do not open"),
        };
        format!("{found}: {}", self.why(draft))
    }

    /// Why it opens no further.
    pub fn why(&self, draft: &Draft) -> String {
        let name = self.object.split('[').next().unwrap_or(&self.object);
        let room = draft.things.iter().find(|thing| thing.name == name).and_then(|thing| thing.room);
        match room.and_then(|at| draft.rooms.get(at)) {
            Some(DraftRoom { size: [w, _, d], .. }) => format!("the room is {} × {} m", number(*w), number(*d)),
            None => "there is no more space in front of it".to_owned(),
        }
    }
}

/// How much a statement demands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Demand {
    /// It must hold: `assert`.
    Must,
    /// It should hold: `prefer`.
    Prefer,
    /// Neither: a permission or an assignment.
    Given,
}

impl Statement {
    /// The statement that a line of the language is.
    pub fn new(line: &str, source: ThingOrigin) -> Self {
        let line = line.trim().trim_end_matches(';').trim_end();
        let after = |keyword| line.strip_prefix(keyword).filter(|rest| rest.starts_with([' ', '(', '\n']));
        let (demand, text) = match (after("assert"), after("prefer")) {
            (Some(text), _) => (Demand::Must, text),
            (_, Some(text)) => (Demand::Prefer, text),
            (None, None) => (Demand::Given, line),
        };
        Self { demand, text: text.trim_start().to_owned(), source, relaxed: false }
    }

    /// The line of the language that says it.
    pub fn line(&self) -> String {
        let keyword = match self.demand {
            Demand::Must => "assert ",
            Demand::Prefer => "prefer ",
            Demand::Given => "",
        };
        format!("{keyword}{};", self.text)
    }
}
