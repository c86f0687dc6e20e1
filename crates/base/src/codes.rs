//! The table of codes. `E`: cannot be judged, or proved impossible. `W`: warning. `V`: a violation in a layout.
//!
//! E00 files and options, E01 text and syntax, E02 names, E03 types, E04 static proofs, E05 layout files, E06 values,
//! E07 models of the user; W alike; V01 verdicts.

use crate::Severity;
use std::fmt;

/// A stable code such as `E0201`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Code(&'static str);

impl Code {
    /// As written.
    pub fn as_str(self) -> &'static str {
        self.0
    }
    /// The severity its letter says; violations count as errors.
    pub fn severity(self) -> Severity {
        if self.0.starts_with('W') { Severity::Warning } else { Severity::Error }
    }
    /// What it says in general, in a few words.
    pub fn title(self) -> &'static str {
        ALL.iter().find(|(c, _)| *c == self).map_or("", |(_, t)| t)
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

impl fmt::Debug for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

macro_rules! codes {
    ($($name:ident $title:literal)*) => {
        $(#[doc = $title] pub const $name: Code = Code(stringify!($name));)*
        /// All codes with their titles, in the order of the table.
        pub const ALL: &[(Code, &str)] = &[$(($name, $title)),*];
        /// The pages of all codes; a code without one does not compile.
        pub(crate) const PAGES: &[(Code, &str)] = &[$((
            $name,
            include_str!(concat!("../../../spec/src/codes/", stringify!($name), ".md")),
        )),*];
    };
}

codes! {
    E0001 "the file cannot be read"
    E0002 "outside the core language"
    E0003 "the file is not valid UTF-8"
    E0004 "nested too deeply"
    E0005 "the expanded program is too large"
    E0006 "the file is too large"
    E0007 "invalid settings"
    E0008 "no embedded scene"
    E0009 "file outside the workspace"

    E0101 "unexpected character"
    E0102 "unterminated string"
    E0103 "unknown escape in a string"
    E0104 "quotation marks other than `\"`"
    E0105 "unterminated comment"
    E0106 "malformed number"
    E0110 "unexpected token"
    E0111 "missing semicolon"
    E0112 "missing operand"
    E0113 "unbalanced brackets"
    E0114 "comparisons cannot be chained"
    E0115 "unknown statement"
    E0116 "unknown operator"

    E0201 "unknown name"
    E0202 "declared twice"
    E0203 "assigned twice"
    E0204 "circular definition"
    E0205 "index out of range"
    E0206 "the import cannot be used"
    E0207 "unknown property"
    E0208 "unknown function or predicate"
    E0209 "a built-in cannot be redefined"
    E0210 "recursive predicate"
    E0211 "this cannot be assigned"
    E0212 "wrong use of an array"

    E0301 "mismatched types"
    E0302 "expected a condition"
    E0303 "wrong number of arguments"
    E0304 "expected a whole number in the allowed range"
    E0305 "a weight must be a positive number"
    E0306 "value not known before solving"
    E0307 "read but never assigned"
    E0308 "a size that is not greater than 0"

    E0401 "contradictory statements"
    E0402 "a statement that can never hold"

    E0501 "not valid JSON"
    E0502 "not a layout file"
    E0503 "missing member"
    E0504 "value of the wrong type"
    E0505 "number out of range"
    E0506 "not declared in the program"
    E0507 "missing from the layout"
    E0508 "not a simple polygon"
    E0509 "duplicate member"
    E0510 "the program that the layout belongs to has errors"
    E0511 "tilted region"
    E0512 "vertices for a rectangular region"

    E0601 "division by zero"
    E0602 "no real result"
    E0603 "bounds in the wrong order"
    E0604 "random value not recorded in the layout"
    E0605 "variable not recorded in the layout"
    E0606 "direction of a zero vector"
    E0607 "result is not finite"

    E0701 "the model cannot be read"
    E0702 "the model exceeds a limit"
    E0703 "the model refers to other files"
    E0704 "the model has no geometry"
    E0705 "the model card cannot be used"
    E0706 "the features cannot be used"

    W0101 "stray semicolon"
    W0102 "arrow inside an expression"
    W0103 "unused `allow` comment"
    W0201 "declared but never used"
    W0202 "read but never assigned"
    W0203 "a name shadows another"
    W0204 "nearly identical names"
    W0205 "unknown category"
    W0206 "misspelt color or material"
    W0207 "size in units other than metres"
    W0301 "ordering comparison of rotation components"
    W0302 "quantifier over an empty set"
    W0303 "assertion that mentions no object"
    W0304 "statement without effect"
    W0305 "object only kept out of a region"
    W0306 "invalid `Measured:` template"
    W0307 "range that leaves out an element"
    W0401 "redundant: implied by other statements"
    W0402 "a statement that always holds"
    W0403 "program too large for the contradiction search"
    W0404 "a preference that can never hold"
    W0501 "parts do not fill the box"
    W0502 "rooms too close together for their walls"
    W0503 "object inside a wall"
    W0504 "scene edited since export"
    W0505 "incomplete third-party file"
    W0506 "possibly misspelt member of a layout"
    W0601 "no asset for this category"
    W0602 "no usual size for this category"
    W0603 "furniture provider skipped"
    W0604 "drawn as something similar"
    W0701 "mesh is not closed"
    W0702 "implausible size"
    W0703 "unknown front direction"
    W0704 "base is not at the floor"
    W0705 "one convex part for a hollow object"
    W0706 "implausible mass"
    W0707 "no licence stated"

    V0101 "an assertion fails"
    V0102 "two objects collide"
    V0103 "an object is not completely inside any region"
    V0104 "an object is not supported"
    V0105 "the layout contradicts an assignment"
    V0106 "a preference is not met"
    V0107 "a door, drawer or lid cannot open"
}
