//! What a request says, before it is a program: a value that can be printed, checked and edited.

pub use crate::brief::{Look, Note, Source};

/// A request, read. Names are identifiers of the language, each used once among rooms, openings and things.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draft {
    /// The request itself: every [`Source::Stated`] range is one of bytes in it.
    pub request: String,
    /// Outdoor: no walls, no ceiling.
    pub outdoor: bool,
    /// The regions.
    pub rooms: Vec<Room>,
    /// Doors and windows.
    pub openings: Vec<Opening>,
    /// The objects.
    pub things: Vec<Thing>,
    /// What is asked of them.
    pub statements: Vec<Statement>,
    /// The parts of the request that became no statement.
    pub notes: Vec<Note>,
}

/// A region of the program.
#[derive(Clone, Debug, PartialEq)]
pub struct Room {
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
    /// The floor's outline in metres (x, z in the scene), where it is no rectangle.
    pub outline: Option<Vec<[f64; 2]>>,
    /// The look of its floor.
    pub floor: Surface,
    /// The look of its walls.
    pub walls: Surface,
    /// Where it comes from.
    pub source: Source,
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
    /// Indices into [`Draft::rooms`]: one (to the outside) or two.
    pub rooms: Vec<usize>,
    /// Width, height, depth in metres.
    pub size: [f64; 3],
    /// Its looks.
    pub look: Look,
    /// Where it comes from.
    pub source: Source,
}

/// What kind of opening.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpeningKind {
    /// To walk through.
    Door,
    /// To look through.
    Window,
}

/// An object of the program, or an array of like ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Thing {
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
    /// Its looks.
    pub look: Look,
    /// Where it comes from.
    pub source: Source,
}

/// `assert`, `prefer` or a permission, as the language writes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Without `@req` and without comments: `assert near(lamp, sofa, 0.5);`
    pub text: String,
    /// Where it comes from.
    pub source: Source,
}
