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
    E0003 "the file is not UTF-8 text"
    E0004 "nested too deeply"
    E0005 "the program expands beyond what can be judged"
    E0006 "the file is too large"
    E0007 "settings that cannot be used"
    E0008 "no scene is embedded"
    E0009 "a file outside the workspace"

    E0101 "a character that means nothing here"
    E0102 "a string that does not close"
    E0103 "an unknown escape in a string"
    E0104 "quotation marks that are not straight"
    E0105 "a comment that does not close"
    E0106 "a number that cannot be written so"
    E0110 "something else was expected"
    E0111 "a semicolon is missing"
    E0112 "an operand is missing"
    E0113 "brackets do not match"
    E0114 "comparisons do not chain"
    E0115 "no such statement"
    E0116 "no such operator"

    E0201 "unknown name"
    E0202 "declared twice"
    E0203 "assigned twice"
    E0204 "defined in a circle"
    E0205 "an index outside the array"
    E0206 "the imported file cannot be used"
    E0207 "unknown property"
    E0208 "unknown function or predicate"
    E0209 "a built-in cannot be redefined"
    E0210 "a predicate that refers to itself"
    E0211 "this cannot be assigned"
    E0212 "wrong use of an array"

    E0301 "the types do not fit"
    E0302 "a condition is expected"
    E0303 "wrong number of arguments"
    E0304 "not a whole number in range"
    E0305 "a weight is a positive number"
    E0306 "not static"
    E0307 "read but never assigned"

    E0401 "statements that contradict each other"
    E0402 "a statement that never holds"

    E0501 "not valid JSON"
    E0502 "not a layout file"
    E0503 "a member is missing"
    E0504 "a value of the wrong type"
    E0505 "a number out of range"
    E0506 "an object or region that the program lacks"
    E0507 "an object or region that the layout lacks"
    E0508 "not a simple polygon"
    E0509 "a member given twice"
    E0510 "the program of the layout does not compile"
    E0511 "a tilted region"
    E0512 "vertices that the program does not allow"

    E0601 "division by zero"
    E0602 "no real value"
    E0603 "bounds the wrong way round"
    E0604 "a draw that the layout does not record"
    E0605 "a variable that the layout does not record"
    E0606 "a direction that a zero vector does not have"
    E0607 "a number that is not finite"

    E0701 "a model that cannot be read"
    E0702 "a model beyond the limits"
    E0703 "a model that refers to other files"
    E0704 "a model without a body"
    E0705 "a card that cannot be used"

    W0101 "a stray semicolon"
    W0102 "an arrow inside an expression"
    W0103 "a comment that silences nothing"
    W0201 "declared but never used"
    W0202 "read but never assigned"
    W0203 "a name that hides another"
    W0204 "spelt almost like another"
    W0205 "a category of which nothing is known"
    W0301 "an order comparison of degrees"
    W0302 "holds for lack of objects"
    W0303 "an assertion without any object"
    W0304 "something that says nothing"
    W0305 "kept out of a region"
    W0306 "a template that cannot be used"
    W0401 "implied by other statements"
    W0402 "a statement that always holds"
    W0403 "too large to be searched for contradictions"
    W0501 "parts that do not fill the box"
    W0502 "rooms closer than their walls"
    W0503 "an object crosses a wall"
    W0504 "changed since it was exported"
    W0505 "a file of others that leaves something open"
    W0601 "no asset for this category"
    W0602 "no usual size for this category"
    W0603 "furniture that was passed over"
    W0701 "a mesh that is not closed"
    W0702 "a size that such a thing does not have"
    W0703 "a front that is not known"
    W0704 "a base that is not at the floor"
    W0705 "one part for a hollow thing"
    W0706 "a mass that such a thing does not have"
    W0707 "no licence"

    V0101 "an assertion fails"
    V0102 "two objects collide"
    V0103 "an object is outside every region"
    V0104 "an object is not supported"
    V0105 "the layout differs from an assignment"
    V0106 "a preference is not met"
    V0107 "something does not open"
}
