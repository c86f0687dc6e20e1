//! The types of the language, and which value fits where.

use crate::ast::TypeWord;
use std::fmt;

/// A type. `Literal` is a bare number that is still free to be a Number or a Degree; `Error` fits everywhere, so that
/// one mistake is reported once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ty {
    /// A bare number literal, or arithmetic of such, or a range variable.
    Literal,
    /// A number: metres or plain.
    Number,
    Degree,
    /// A condition.
    Bool,
    /// Three numbers.
    Vector3,
    /// An orientation.
    Rotation,
    /// Text that names a colour.
    Color,
    /// Text that names a material.
    Material,
    /// Text.
    String,
    Object,
    Region,
    /// A set of objects.
    Objects,
    /// All rooms: a domain of quantifiers.
    Regions,
    /// A floor polygon.
    Polygon,
    /// A domain of whole numbers, `0..5`.
    Range,
    /// A side word: `front`, `left`, …
    Side,
    /// Reported already.
    Error,
}

impl Ty {
    pub fn of(word: TypeWord) -> Self {
        match word {
            TypeWord::Object => Self::Object,
            TypeWord::Region => Self::Region,
            TypeWord::Objects => Self::Objects,
            TypeWord::Number => Self::Number,
            TypeWord::Degree => Self::Degree,
            TypeWord::Bool => Self::Bool,
            TypeWord::Vector3 => Self::Vector3,
            TypeWord::Rotation => Self::Rotation,
            TypeWord::Color => Self::Color,
            TypeWord::Material => Self::Material,
            TypeWord::String => Self::String,
        }
    }
    /// Its name, where a machine wants one; messages say what it is ([`fmt::Display`]).
    pub fn name(self) -> &'static str {
        match self {
            Self::Literal => "Literal",
            Self::Number => "Number",
            Self::Degree => "Degree",
            Self::Bool => "Bool",
            Self::Vector3 => "Vector3",
            Self::Rotation => "Rotation",
            Self::Color => "Color",
            Self::Material => "Material",
            Self::String => "String",
            Self::Object => "Object",
            Self::Region => "Region",
            Self::Objects => "Objects",
            Self::Regions => "Regions",
            Self::Polygon => "Polygon",
            Self::Range => "Range",
            Self::Side => "Side",
            Self::Error => "Error",
        }
    }
    /// Number, Degree or a literal.
    pub fn is_numeric(self) -> bool {
        matches!(self, Self::Literal | Self::Number | Self::Degree)
    }
    /// Color, Material or String.
    pub fn is_text(self) -> bool {
        matches!(self, Self::Color | Self::Material | Self::String)
    }
    /// Whether a value of this type may stand where `wanted` is expected.
    pub fn fits(self, wanted: Ty) -> bool {
        self == wanted
            || self == Self::Error
            || wanted == Self::Error
            || (self == Self::Literal && wanted.is_numeric())
            || (self.is_text() && wanted.is_text())
            || (self == Self::Object && wanted == Self::Objects)
    }
    /// The common type of two numbers, if they go together.
    pub fn join_numeric(self, other: Ty) -> Option<Ty> {
        match (self, other) {
            (a, b) if a == b && a.is_numeric() => Some(a),
            (Self::Literal, b) if b.is_numeric() => Some(b),
            (a, Self::Literal) if a.is_numeric() => Some(a),
            _ => None,
        }
    }
}

impl fmt::Display for Ty {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Literal => "a number",
            Self::Number => "a Number",
            Self::Degree => "a Degree",
            Self::Bool => "a condition",
            Self::Vector3 => "a Vector3",
            Self::Rotation => "a Rotation",
            Self::Color => "a Color",
            Self::Material => "a Material",
            Self::String => "a String",
            Self::Object => "an object",
            Self::Region => "a region",
            Self::Objects => "a set of objects",
            Self::Regions => "a set of regions",
            Self::Polygon => "a polygon",
            Self::Range => "a range of whole numbers",
            Self::Side => "a side",
            Self::Error => "something wrong",
        })
    }
}
