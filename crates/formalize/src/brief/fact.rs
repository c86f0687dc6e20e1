//! A fact of a brief: what is said of things, by itself, with others, or about their place in the room.

use super::ThingOrigin;
use serde::{Deserialize, Serialize};

/// Something said of things.
#[derive(Clone, Debug, PartialEq)]
pub struct Fact {
    /// The things it is said of.
    pub of: Vec<usize>,
    /// Of how many of these, where there are several.
    pub subject: Quantifier,
    /// What is said.
    pub what: FactKind,
    /// With how many of the things on the other side, where there are several.
    pub object: Quantifier,
    /// A preference.
    pub soft: bool,
    /// It is denied.
    pub not: bool,
    /// Where it comes from.
    pub source: ThingOrigin,
}

impl Fact {
    /// A demand that is not denied, and of which nobody says how many it is of.
    pub fn new(of: Vec<usize>, what: FactKind, source: ThingOrigin) -> Self {
        let usual = Quantifier::Usual;
        Self { of, subject: usual, what, object: usual, soft: false, not: false, source }
    }
}

/// Of how many of several things something is said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantifier {
    /// Not said: as many go together as the numbers of both sides suggest.
    #[default]
    Usual,
    /// "each", "every", "all", "both".
    Each,
    /// "any", "one of".
    Any,
    /// "two of".
    Exactly(usize),
}

/// What is said.
#[derive(Clone, Debug, PartialEq)]
pub enum FactKind {
    /// A relation to things.
    Rel(Rel, Vec<usize>),
    /// At a place of the room; which one.
    Place(Rel, Place, Vec<String>),
    /// So far from things.
    Gap(Op, f64, Vec<usize>),
    /// So far from each other.
    Among(Op, f64),
    /// So far from row to row.
    Rows(Op, f64),
    /// So far from the walls.
    Wall(Op, f64),
    /// At least so far from whatever else there is.
    Alone(f64),
    /// So much free space on a side.
    Clear(Side, f64),
    /// So large.
    Size(Dim, Op, f64),
    /// So high above the floor.
    Height(Op, f64),
    /// A way of this width to things.
    Path(f64, Vec<usize>),
    /// How several stand to each other.
    Pattern(Pattern),
}

impl FactKind {
    /// The things on the other side, if there is one.
    pub fn objects(&self) -> Option<&[usize]> {
        match self {
            Self::Rel(_, to) | Self::Gap(_, _, to) | Self::Path(_, to) => Some(to),
            _ => None,
        }
    }

    /// The same, to be changed.
    pub fn objects_mut(&mut self) -> Option<&mut Vec<usize>> {
        match self {
            Self::Rel(_, to) | Self::Gap(_, _, to) | Self::Path(_, to) => Some(to),
            _ => None,
        }
    }
}

/// A side of a thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    Front,
    Behind,
    Left,
    Right,
    Above,
    /// To its left and to its right.
    Sides,
    /// On all sides from which one comes to it.
    Around,
}

/// What two things are to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rel {
    On,
    Under,
    Above,
    Beside,
    Near,
    LeftOf,
    RightOf,
    /// On it, in its left or right half.
    OnLeft,
    OnRight,
    /// In its middle.
    Centre,
    LongSide,
    ShortSide,
    InFrontOf,
    Behind,
    Between,
    Around,
    Facing,
    Opposite,
    Against,
    Along,
    In,
    At,
    Mounted,
    Hang,
    Far,
    Parallel,
    Perpendicular,
    Aligned,
    Visible,
    Reachable,
    /// Beside it at both sides.
    Sides,
    BackTo,
    /// At the wall at which the other is.
    SameWall,
    /// Between it and a wall.
    WallBeyond,
    From,
    Of,
    To,
    Than,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    Wall,
    Corner,
    Ceiling,
    Floor,
    Middle,
    Side,
    End,
    Head,
    Foot,
    Back,
    Front,
    Row,
    Circle,
}

/// How several things stand to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Pattern {
    /// In one line.
    Row,
    /// In so many lines; `None`: in several, nobody says how many.
    Rows(Option<usize>),
    /// In so many groups.
    Groups(usize),
    /// Rows in two halves, with an aisle of so many centimetres down the middle.
    Aisle(u32),
    Circle,
    /// In half a circle.
    Arc,
    /// Beside each other.
    SideBySide,
    BackToBack,
    /// Facing each other.
    FaceToFace,
    /// "left to right".
    LeftToRight,
    /// One on the other.
    Stacked,
    /// Each with room for its doors, drawers and lids.
    Opens,
    /// The same for its doors and lids, to so many degrees.
    OpensBy(u32),
    /// The same for its drawers, so many centimetres out.
    SlidesBy(u32),
}

/// How a measure binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Op {
    /// So much, exactly.
    Equal,
    Least,
    Most,
}

/// Which of a thing's measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Dim {
    Width,
    Height,
    Depth,
    Length,
    Across,
    Ceiling,
    /// No measure of it, but how high above the floor it is.
    Elevation,
}
