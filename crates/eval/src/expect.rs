//! The ground truth of a request, `NAME.expect.json`: what a careful reader takes from it.

use serde::Deserialize;

/// What a program for one request should say. Lengths are metres; names are used once among rooms and things.
#[derive(Clone, Debug, Default, Deserialize)]
pub struct Expectation {
    /// What the case is called.
    pub id: String,
    /// The kind of building: apartment, mall, office, …
    #[serde(default)]
    pub building: String,
    pub rooms: Vec<ExpectedRoom>,
    /// Doors and windows.
    #[serde(default)]
    pub connections: Vec<Connection>,
    pub objects: Vec<ExpectedThing>,
    /// What is asked of their places.
    pub relations: Vec<Relation>,
    /// Measures that are stated.
    pub numeric: Vec<Number>,
}

#[derive(Clone, Debug, Deserialize)]
pub struct ExpectedRoom {
    pub name: String,
    /// What it is, in words.
    #[serde(default)]
    pub kind: Option<String>,
    /// Width, height, depth, where the request gives them.
    #[serde(default)]
    pub size: Option<[f64; 3]>,
}

/// A door or a window.
#[derive(Clone, Debug, Deserialize)]
pub struct Connection {
    /// What it is, in words.
    pub kind: String,
    /// Two rooms, or one and `outside`.
    pub between: Vec<String>,
}

/// An object, or several that are alike.
#[derive(Clone, Debug, Deserialize)]
pub struct ExpectedThing {
    pub name: String,
    /// How many. 0: there must be none. `None`: the request does not say.
    pub count: Option<u32>,
    /// The room it belongs to.
    #[serde(default)]
    pub room: String,
    /// Its colour, in the words of the request.
    #[serde(default)]
    pub colour: Option<String>,
    /// Its material, in the words of the request.
    #[serde(default)]
    pub material: Option<String>,
    /// What else is said of it.
    #[serde(default)]
    pub features: Option<String>,
}

impl ExpectedThing {
    /// Whether the request forbids it.
    pub fn forbidden(&self) -> bool {
        self.count == Some(0)
    }
}

/// What is asked of the place of one thing with respect to another or a room.
#[derive(Clone, Debug, Deserialize)]
pub struct Relation {
    /// Of which things.
    pub subject: OneOrSeveral,
    /// A predicate of the library, or another word; `not_` before it denies it.
    pub relation: String,
    /// With respect to what.
    pub object: OneOrSeveral,
}

/// A measure.
#[derive(Clone, Debug, Deserialize)]
pub struct Number {
    /// The words of the request.
    pub quote: String,
    /// The things that it binds.
    pub between: Vec<String>,
    /// How much.
    pub value: f64,
    /// In which unit: `m`, `cm`, `mm`, `ft`, `in`; another one (`deg`) is taken as it is.
    #[serde(default = "metres")]
    pub unit: String,
}

impl Number {
    /// The value in metres, or in its own unit if that is none of length.
    pub fn metres(&self) -> f64 {
        let factor = match self.unit.as_str() {
            "cm" => 0.01,
            "mm" => 0.001,
            "ft" => 0.3048,
            "in" => 0.0254,
            _ => 1.0,
        };
        self.value * factor
    }
}

fn metres() -> String {
    "m".to_owned()
}

/// One name or several.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum OneOrSeveral {
    One(String),
    Several(Vec<String>),
}

impl OneOrSeveral {
    /// The names.
    pub fn all(&self) -> &[String] {
        match self {
            Self::One(name) => std::slice::from_ref(name),
            Self::Several(names) => names,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_units() {
        let number: Number =
            serde_json::from_str(r#"{"quote": "3 feet", "between": ["a"], "value": 3, "unit": "ft"}"#).unwrap();
        assert!((number.metres() - 0.9144).abs() < 1e-12);
        let relation: Relation =
            serde_json::from_str(r#"{"subject": "a", "relation": "between", "object": ["b", "c"]}"#).unwrap();
        assert_eq!(relation.subject.all(), ["a"]);
        assert_eq!(relation.object.all(), ["b", "c"]);
    }
}
