//! Looking into JSON of others: what is asked for is there and of the right kind, or it is said where it is not.

use scenelang_base::{Code, Diagnostic, FileId, TextRange, codes};
use scenelang_layout::Vec3;
use scenelang_layout::file::json::{Json, JsonNode, find};
use scenelang_layout::polygon::{NotSimple, Polygon};

/// Coordinates and sizes of others are no larger (metres): what is beyond is no room.
pub(crate) const FARTHEST: f64 = 1e5;
/// At most so many things, rooms and openings each: what is beyond is no house.
pub(crate) const MOST: usize = 20_000;

/// A floor has no more corners.
const MOST_CORNERS: usize = 1000;

pub(crate) type Found<T> = Result<T, Box<Diagnostic>>;

/// A value, and how one gets there.
#[derive(Clone, Debug)]
pub(crate) struct At<'a> {
    pub node: &'a JsonNode,
    file: FileId,
    path: String,
}

impl<'a> At<'a> {
    pub fn root(node: &'a JsonNode, file: FileId) -> Self {
        Self { node, file, path: String::new() }
    }

    /// What is wrong at this place.
    pub fn fail<T>(&self, code: Code, say: impl Into<String>) -> Found<T> {
        Err(Box::new(Diagnostic::new(code, self.range().in_file(self.file), say)))
    }

    /// Its beginning: a whole house is no place to point at.
    fn range(&self) -> TextRange {
        let range = self.node.range;
        match self.node.value {
            Json::Object(_) | Json::Array(_) => TextRange::new(range.start as usize, range.start as usize + 1),
            _ => range,
        }
    }

    fn is_not<T>(&self, expected: &str) -> Found<T> {
        let what = if self.path.is_empty() { "the file".to_owned() } else { format!("`{}`", self.path) };
        self.fail(codes::E0504, format!("{what} is {}, expected {expected}", self.node.kind()))
    }

    fn below(&self, node: &'a JsonNode, step: &str) -> Self {
        let dot = if self.path.is_empty() || step.starts_with('[') { "" } else { "." };
        Self { node, file: self.file, path: format!("{}{dot}{step}", self.path) }
    }

    pub fn is_null(&self) -> bool {
        self.node.value == Json::Null
    }

    pub fn is_object(&self) -> bool {
        self.node.members().is_some()
    }

    pub fn is_array(&self) -> bool {
        self.node.items().is_some()
    }

    /// Members in order. Of what is no object that is said.
    pub fn members(&self) -> Found<Vec<(&'a str, Self)>> {
        match self.node.members() {
            Some(members) => Ok(members.iter().map(|m| (m.key.as_str(), self.below(&m.node, &m.key))).collect()),
            None => self.is_not("an object"),
        }
    }

    /// A member that may be missing, or null.
    pub fn maybe(&self, key: &str) -> Found<Option<Self>> {
        match self.node.members() {
            Some(members) => Ok(find(members, key).map(|m| self.below(&m.node, key)).filter(|at| !at.is_null())),
            None => self.is_not("an object"),
        }
    }

    /// A member that must be there.
    pub fn need(&self, key: &str) -> Found<Self> {
        match self.maybe(key)? {
            Some(at) => Ok(at),
            None => {
                let of = if self.path.is_empty() { String::new() } else { format!(" of `{}`", self.path) };
                self.fail(codes::E0503, format!("the member `{key}`{of} is missing"))
            }
        }
    }

    pub fn items(&self) -> Found<Vec<Self>> {
        let Some(items) = self.node.items() else { return self.is_not("an array") };
        if items.len() > MOST {
            return self
                .fail(codes::E0005, format!("`{}` has {} entries; the maximum is {MOST}", self.path, items.len()));
        }
        Ok(items.iter().enumerate().map(|(i, item)| self.below(item, &format!("[{i}]"))).collect())
    }

    /// The items of a member; none if it is missing.
    pub fn list(&self, key: &str) -> Found<Vec<Self>> {
        self.maybe(key)?.map_or(Ok(Vec::new()), |at| at.items())
    }

    pub fn text(&self) -> Found<&'a str> {
        match &self.node.value {
            Json::Text(text) => Ok(text),
            _ => self.is_not("a string"),
        }
    }

    /// A name, which some write as a number.
    pub fn name(&self) -> Found<String> {
        match &self.node.value {
            Json::Text(text) => Ok(text.clone()),
            Json::Number(number) => Ok(number.to_string()),
            _ => self.is_not("a string"),
        }
    }

    pub fn maybe_name(&self, key: &str) -> Found<Option<String>> {
        self.maybe(key)?.map(|at| at.name()).transpose()
    }

    /// Any number that can be in a house.
    pub fn number(&self) -> Found<f64> {
        match self.node.value {
            Json::Number(number) if number.abs() <= FARTHEST => Ok(number),
            Json::Number(number) => {
                let shown = if number.abs() < 1e12 { number.to_string() } else { format!("{number:e}") };
                self.fail(codes::E0505, format!("`{}` is {shown}; the largest absolute value is {FARTHEST}", self.path))
            }
            _ => self.is_not("a number"),
        }
    }

    /// A length that must be more than nothing.
    pub fn length(&self) -> Found<f64> {
        let number = self.number()?;
        if number > 0.0 {
            return Ok(number);
        }
        self.fail(codes::E0505, format!("`{}` is {number}; a length must be greater than 0", self.path))
    }

    /// `{ "x": …, "y": …, "z": … }`
    pub fn xyz(&self) -> Found<Vec3> {
        let of = |key: &str| self.need(key)?.number();
        Ok(Vec3::new(of("x")?, of("y")?, of("z")?))
    }

    /// `[…]`, so many numbers.
    pub fn numbers<const N: usize>(&self) -> Found<[f64; N]> {
        let numbers: Vec<f64> = self.items()?.iter().map(Self::number).collect::<Found<_>>()?;
        let count = numbers.len();
        numbers
            .try_into()
            .or_else(|_| self.fail(codes::E0504, format!("`{}` has {count} numbers, expected {N}", self.path)))
    }

    /// Whether these are the corners of a floor.
    pub fn outline(&self, corners: &[[f64; 2]]) -> Found<Vec<[f64; 2]>> {
        if corners.len() > MOST_CORNERS {
            let say = format!("`{}` has {} corners; the maximum is {MOST_CORNERS}", self.path, corners.len());
            return self.fail(codes::E0005, say);
        }
        let corners = tidied(corners);
        match Polygon::new(&corners) {
            Ok(_) => Ok(corners),
            Err(why @ NotSimple::Crossing(..)) => {
                self.fail(codes::E0508, format!("{why}, counting only distinct vertices"))
            }
            Err(why) => self.fail(codes::E0508, why.to_string()),
        }
    }
}

/// Corners without those that say nothing: one that repeats the one before, or stands on a straight wall.
fn tidied(corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
    const NEAR: f64 = 1e-6;
    let mut out: Vec<[f64; 2]> = Vec::with_capacity(corners.len());
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) > NEAR;
    for &corner in corners {
        if out.last().is_none_or(|last| apart(*last, corner)) {
            out.push(corner);
        }
    }
    while out.len() > 1 && !apart(out[0], out[out.len() - 1]) {
        out.pop();
    }
    let straight = |i: usize| {
        let n = out.len();
        let ([a, b, c], twice) = ([out[(i + n - 1) % n], out[i], out[(i + 1) % n]], NEAR * 2.0);
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
        // Ahead, not back: a spike stays, and is an error.
        (u[0] * v[1] - u[1] * v[0]).abs() <= twice * u[0].hypot(u[1]).max(v[0].hypot(v[1]))
            && u[0] * v[0] + u[1] * v[1] > 0.0
    };
    if out.len() > 3 {
        let kept: Vec<[f64; 2]> = (0..out.len()).filter(|&i| !straight(i)).map(|i| out[i]).collect();
        if kept.len() >= 3 {
            return kept;
        }
    }
    out
}

/// What a file says that is not taken over: members by what they are members of, counted.
#[derive(Debug, Default)]
pub(crate) struct Rest(std::collections::BTreeMap<String, usize>);

impl Rest {
    /// Counts the members of an object that are none of these.
    pub fn of(&mut self, at: &At<'_>, what: &str, known: &[&str]) {
        for member in at.node.members().into_iter().flatten() {
            let says = match &member.node.value {
                Json::Null => false,
                Json::Array(items) => !items.is_empty(),
                Json::Object(members) => !members.is_empty(),
                Json::Text(text) => !text.is_empty(),
                _ => true,
            };
            if says && !known.contains(&member.key.as_str()) {
                let key: String = member.key.chars().take(40).collect();
                *self.0.entry(format!("{what}{key}")).or_default() += 1;
            }
        }
    }

    /// The members by name, with how often each was met.
    pub fn list(&self) -> Vec<String> {
        let one =
            |(name, count): (&String, &usize)| if *count == 1 { name.clone() } else { format!("{name} ({count})") };
        self.0.iter().map(one).collect()
    }
}
