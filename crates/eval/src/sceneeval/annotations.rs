//! The benchmark's file: requests, and what each of them asks for, as annotated.

use super::csv;
use std::collections::BTreeSet;

/// The columns that are read.
const COLUMNS: [&str; 7] = ["ID", "Description", "ObjCount", "ObjAttr", "OORel", "OARel", "Difficulty"];
/// More of one thing than this is asked for by nobody.
const MOST: usize = 10_000;
/// The longest ID (bytes): files are named after it.
const LONGEST: usize = 64;

/// The requests of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Benchmark {
    /// In the order of the file.
    pub requests: Vec<AnnotatedRequest>,
    /// Annotations that cannot be read, with line and column: they are not judged.
    pub unread: Vec<String>,
}

/// A request, and what it asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct AnnotatedRequest {
    /// Letters, digits, `-` and `_`.
    pub id: String,
    pub description: String,
    /// `easy`, `medium` or `hard`, or whatever the file says.
    pub difficulty: String,
    /// What is asked for, by measure and then in the order of the file.
    pub annotations: Vec<Annotation>,
}

/// Something that is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Annotation {
    /// How many there are to be.
    pub how: How,
    /// How many.
    pub number: usize,
    pub says: Says,
    /// As written in the file.
    pub text: String,
}

/// How a number is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum How {
    /// Exactly so many.
    Equal,
    /// So many or more.
    AtLeast,
    More,
    /// So many or fewer.
    AtMost,
    Fewer,
}

impl How {
    fn of(word: &str) -> Option<Self> {
        Some(match word {
            "eq" => Self::Equal,
            "ge" => Self::AtLeast,
            "gt" => Self::More,
            "le" => Self::AtMost,
            "lt" => Self::Fewer,
            _ => return None,
        })
    }

    /// Whether so many are as many as wanted.
    pub fn holds(self, found: usize, wanted: usize) -> bool {
        match self {
            Self::Equal => found == wanted,
            Self::AtLeast => found >= wanted,
            Self::More => found > wanted,
            Self::AtMost => found <= wanted,
            Self::Fewer => found < wanted,
        }
    }
}

/// What an annotation is about.
#[derive(Clone, Debug, PartialEq)]
pub enum Says {
    /// So many things of a name.
    Count(String),
    /// So many things of a name with an attribute.
    Attribute(String, String),
    /// So many targets in a relation to a reference.
    Between {
        /// The word of the relation.
        relation: String,
        /// What the others are related to.
        reference: String,
        /// The others.
        targets: Vec<String>,
    },
    /// So many things of a name in a relation to the room or a part of it.
    Place {
        /// The word of the relation.
        relation: String,
        /// The things.
        name: String,
        /// `wall`, `door`, `room`, ….
        element: String,
    },
}

/// What is measured of a layout's faithfulness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// CNT.
    Counts,
    /// ATR.
    Attributes,
    /// OOR.
    Between,
    /// OAR.
    Places,
}

impl Measure {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Counts, Self::Attributes, Self::Between, Self::Places];

    /// As the benchmark calls it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Counts => "CNT",
            Self::Attributes => "ATR",
            Self::Between => "OOR",
            Self::Places => "OAR",
        }
    }

    const fn column(self) -> usize {
        match self {
            Self::Counts => 2,
            Self::Attributes => 3,
            Self::Between => 4,
            Self::Places => 5,
        }
    }
}

impl Annotation {
    /// What it counts for.
    pub fn measure(&self) -> Measure {
        match self.says {
            Says::Count(_) => Measure::Counts,
            Says::Attribute(..) => Measure::Attributes,
            Says::Between { .. } => Measure::Between,
            Says::Place { .. } => Measure::Places,
        }
    }

    /// The names and words of it.
    pub fn words(&self) -> Vec<&str> {
        match &self.says {
            Says::Count(name) => vec![name],
            Says::Attribute(name, adjective) => vec![name, adjective],
            Says::Between { relation, reference, targets } => {
                targets.iter().map(String::as_str).chain([reference.as_str(), relation]).collect()
            }
            Says::Place { relation, name, element } => vec![name, relation, element],
        }
    }

    /// Reads `quantifier,number,…`.
    fn read(measure: Measure, text: &str) -> Result<Self, String> {
        let parts: Vec<&str> = text.split(',').map(str::trim).collect();
        let shape = match measure {
            Measure::Counts => "quantifier,number,name",
            Measure::Attributes => "quantifier,number,name,attribute",
            Measure::Between => "quantifier,number,relation,index of the reference,name,name,…",
            Measure::Places => "quantifier,number,relation,name,element",
        };
        let [quantifier, number, rest @ ..] = parts.as_slice() else { return Err(format!("it is not {shape}")) };
        let how = How::of(quantifier).ok_or_else(|| format!("{quantifier:?} is not one of eq, ge, gt, le and lt"))?;
        let number = count(number)?;
        if rest.iter().any(|part| part.is_empty()) {
            return Err(format!("part of it is empty; the expected form is {shape}"));
        }
        let own = |text: &&str| (*text).to_owned();
        let says = match (measure, rest) {
            (Measure::Counts, [name]) => Says::Count(own(name)),
            (Measure::Attributes, [name, adjective]) => Says::Attribute(own(name), own(adjective)),
            (Measure::Between, [relation, index, names @ ..]) if names.len() > 1 => {
                let index = count(index)?;
                let reference = names.get(index).ok_or_else(|| {
                    format!("the reference is name {index} (counted from 0), but there are only {} names", names.len())
                })?;
                let targets = names.iter().enumerate().filter(|(i, _)| *i != index).map(|(_, name)| own(name));
                Says::Between { relation: own(relation), reference: own(reference), targets: targets.collect() }
            }
            (Measure::Places, [relation, name]) => {
                Says::Place { relation: own(relation), name: own(name), element: "room".to_owned() }
            }
            (Measure::Places, [relation, name, element]) => {
                Says::Place { relation: own(relation), name: own(name), element: own(element) }
            }
            _ => return Err(format!("it is not {shape}")),
        };
        Ok(Self { how, number, says, text: text.to_owned() })
    }
}

fn count(text: &str) -> Result<usize, String> {
    let digits = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    match text.parse() {
        Ok(number) if digits && number <= MOST => Ok(number),
        _ if digits => Err(format!("{} is more than {MOST}", shortened(text))),
        _ => Err(format!("{:?} is not a whole number", shortened(text))),
    }
}

/// No more of a text than a message can take.
fn shortened(text: &str) -> String {
    const SHOWN: usize = 60;
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// Reads the benchmark's file. An annotation that cannot be read is left out, and named.
///
/// # Errors
/// What makes the file unusable: it is no such table, a row has not as many fields as the head, or an ID is missing,
/// there twice, or cannot name a file; with its line.
pub fn read(text: &str) -> Result<Benchmark, String> {
    let rows = csv::read(text)?;
    let Some((head, rows)) = rows.split_first() else { return Err("the file is empty".to_owned()) };
    let place = |name: &str| head.fields.iter().position(|field| field.trim() == name);
    let mut places = [0; COLUMNS.len()];
    for (at, name) in places.iter_mut().zip(COLUMNS) {
        *at = place(name).ok_or_else(|| {
            format!("line {}: there is no column {name}; the columns are {}", head.line, COLUMNS.join(", "))
        })?;
    }
    let mut out = Benchmark::default();
    let mut known = BTreeSet::new();
    for row in rows {
        if row.fields.len() != head.fields.len() {
            let (found, wanted) = (row.fields.len(), head.fields.len());
            return Err(format!("line {}: the row has {found} fields, but the header has {wanted}", row.line));
        }
        let field = |column: usize| row.fields[places[column]].trim();
        let id = field(0);
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        if id.is_empty() || id.len() > LONGEST || !id.chars().all(plain) {
            let say = "is not a valid ID: at most 64 letters, digits, - and _";
            return Err(format!("line {}, column ID: {:?} {say}", row.line, shortened(id)));
        }
        if !known.insert(id.to_ascii_lowercase()) {
            return Err(format!("line {}, column ID: {id} occurs twice", row.line));
        }
        let mut annotations = Vec::new();
        for measure in Measure::ALL {
            let column = measure.column();
            for (n, item) in field(column).split(';').map(str::trim).filter(|item| !item.is_empty()).enumerate() {
                match Annotation::read(measure, item) {
                    Ok(annotation) => annotations.push(annotation),
                    Err(why) => {
                        let (line, name, item) = (row.line, COLUMNS[column], shortened(item));
                        out.unread.push(format!("line {line}, column {name}, item {}: {item:?}: {why}", n + 1));
                    }
                }
            }
        }
        let own = |column: usize| field(column).to_owned();
        out.requests.push(AnnotatedRequest { id: own(0), description: own(1), difficulty: own(6), annotations });
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "ID,Description,ObjCount,ObjAttr,OORel,OARel,Difficulty\n";

    fn file(rows: &str) -> Result<Benchmark, String> {
        read(&format!("{HEAD}{rows}"))
    }

    #[test]
    fn typed() {
        let row = "7,\"A lamp, on a desk.\",\"eq,1,desk; ge,2,lamp\",\"eq,1,desk,oak\",\"eq,1,on,1,lamp,desk\",\
                   \"eq,1,corner,desk,room;gt,0,by,lamp\",easy\n";
        let found = file(row).unwrap();
        assert_eq!(found.unread, Vec::<String>::new());
        let asked = &found.requests[0];
        assert_eq!((asked.id.as_str(), asked.description.as_str()), ("7", "A lamp, on a desk."));
        let of = |n: usize| (asked.annotations[n].how, asked.annotations[n].number, asked.annotations[n].says.clone());
        assert_eq!(of(1), (How::AtLeast, 2, Says::Count("lamp".into())));
        let between = Says::Between { relation: "on".into(), reference: "desk".into(), targets: vec!["lamp".into()] };
        assert_eq!(of(3), (How::Equal, 1, between));
        let place = Says::Place { relation: "by".into(), name: "lamp".into(), element: "room".into() };
        assert_eq!(of(5), (How::More, 0, place));
    }

    #[test]
    fn annotations_that_cannot_be_read() {
        let row = "7,x,\"eq,99999999999999999999,a;eq,-1,a;about,1,a;eq,1\",\"eq,1,a,\",\"eq,1,on,2,a,b;eq,1,on,0,a\",,easy\n";
        let unread = file(row).unwrap().unread;
        let ends = [
            "is more than 10000",
            "\"-1\" is not a whole number",
            "\"about\" is not one of eq, ge, gt, le and lt",
            "it is not quantifier,number,name",
            "part of it is empty; the expected form is quantifier,number,name,attribute",
            "the reference is name 2 (counted from 0), but there are only 2 names",
            "it is not quantifier,number,relation,index of the reference,name,name,…",
        ];
        assert_eq!(unread.len(), ends.len(), "{unread:#?}");
        for (message, end) in unread.iter().zip(ends) {
            assert!(message.ends_with(end), "{message}");
        }
        assert!(unread[5].starts_with("line 2, column OORel, item 1: \"eq,1,on,2,a,b\": "), "{}", unread[5]);
    }

    #[test]
    fn files_that_cannot_be_used() {
        let cases = [
            ("1,x,,,,\n", "line 2: the row has 6 fields, but the header has 7"),
            ("1,x,,,,,easy\n1,y,,,,,easy\n", "line 3, column ID: 1 occurs twice"),
            ("../a,x,,,,,easy\n", "line 2, column ID: \"../a\" is not a valid ID: at most 64 letters, digits, - and _"),
            ("1,\"x,,,,,easy\n", "line 2: a quotation mark is never closed"),
        ];
        for (rows, message) in cases {
            assert_eq!(file(rows), Err(message.to_owned()));
        }
        assert_eq!(read(""), Err("the file is empty".into()));
        let message = read("ID,Description\n").unwrap_err();
        assert!(message.starts_with("line 1: there is no column ObjCount"), "{message}");
    }
}
