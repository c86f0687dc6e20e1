//! A folder of requests with ground truth, read and scored.

use crate::expect::Expectation;
use crate::score::{Score, Share, score};
use scenelang_base::door::Door;
use scenelang_verify::prove::{ProveOptions, prove};
use serde_json::{Map, Value, json};
use std::path::Path;
use std::time::Duration;

/// The value of `format`.
const FORMAT: &str = "scenelang.requests/1";

/// A request to be read.
#[derive(Clone, Copy, Debug)]
pub struct EvalRequest<'a> {
    /// Its file, without `.txt`.
    pub name: &'a str,
    /// What is asked for.
    pub text: &'a str,
}

/// Makes a program of a request, or says why it cannot.
pub type Reader<'a> = dyn Fn(EvalRequest<'_>) -> Result<Reading, String> + 'a;

/// What a reader makes of a request.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// The text of the program.
    pub program: String,
    /// How many clauses the request has; 0 where the reader does not say.
    pub clauses: usize,
    /// How many of them were understood.
    pub understood: usize,
    /// How many words say something; 0 where the reader does not say.
    pub words: usize,
    /// Those of them that became nothing, and of which no note speaks.
    pub silent: Vec<String>,
    /// How long it took, where it was read now.
    pub took: Option<Duration>,
}

/// A request, read and scored.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its file, without `.txt`.
    pub name: String,
    /// Its length in words.
    pub words: usize,
    /// The scores of the program.
    pub score: Score,
    /// What the reader made of it.
    pub reading: Reading,
    /// How many contradictions were proved; `None`: the program does not compile.
    pub contradictions: Option<usize>,
}

impl Case {
    /// Reads a request and scores what came of it.
    pub fn of(request: EvalRequest<'_>, expect: &Expectation, reader: &Reader<'_>) -> Result<Self, String> {
        let reading = reader(request)?;
        let (score, program) = score(expect, &reading.program);
        let options = ProveOptions { redundant: false, ..ProveOptions::default() };
        let contradictions = program.map(|p| prove(&p, &options).contradictions.len());
        let words = request.text.split_whitespace().count();
        Ok(Self { name: request.name.to_owned(), words, score, reading, contradictions })
    }

    /// The clauses that were understood.
    pub fn clauses(&self) -> Share {
        Share { part: self.reading.understood, whole: self.reading.clauses }
    }

    /// The words that say something and were lost without a word.
    pub fn silent(&self) -> Share {
        Share { part: self.reading.silent.len(), whole: self.reading.words }
    }

    /// The mean of all shares but precision and counts, which say nothing about what is missing: to find the worst.
    fn merit(&self) -> f64 {
        let shares = [self.score.recall, self.score.texts, self.score.mentioned, self.score.numbers];
        mean(shares.into_iter().map(Share::value)).unwrap_or(1.0)
    }
}

/// The cases of a folder, in the order of their names.
#[derive(Clone, Debug, Default)]
pub struct Requests {
    pub cases: Vec<Case>,
}

/// Reads each `NAME.txt` of a folder that has a `NAME.expect.json`, and scores what came of it. `follow` hears of each.
pub fn read_folder(
    folder: &Path,
    reader: &Reader<'_>,
    mut follow: impl FnMut(usize, usize),
) -> Result<Requests, String> {
    let say = |path: &Path, e: &dyn std::fmt::Display| format!("{}: {e}", path.display());
    let door = Door::of(folder);
    let text = |path: &Path| {
        let bytes = door.read(path).map_err(|e| say(path, &e))?;
        String::from_utf8(bytes).map_err(|_| say(path, &"this is not valid UTF-8"))
    };
    let mut texts = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|e| say(folder, &e))? {
        let path = entry.map_err(|e| say(folder, &e))?.path();
        if path.extension().is_some_and(|e| e == "txt") && path.with_extension("expect.json").is_file() {
            texts.push(path);
        }
    }
    texts.sort();
    let mut requests = Requests::default();
    for (i, path) in texts.iter().enumerate() {
        follow(i, texts.len());
        let request = text(path)?;
        let truth = path.with_extension("expect.json");
        let expect = text(&truth)?;
        let expect: Expectation = serde_json::from_str(&expect).map_err(|e| say(&truth, &e))?;
        let name = path.file_stem().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        requests.cases.push(Case::of(EvalRequest { name: &name, text: &request }, &expect, reader)?);
    }
    Ok(requests)
}

impl Requests {
    /// The mean over the cases of each share, by name; `None` where no case has any of it.
    pub fn means(&self) -> Vec<(&'static str, Option<f64>)> {
        let names = Score::default().shares().map(|(name, _)| name);
        let of = |n: usize| mean(self.cases.iter().map(|case| case.score.shares()[n].1.value()));
        names.into_iter().enumerate().map(|(n, name)| (name, of(n))).collect()
    }

    /// The same of the shares that say what is wrong, summed over the cases.
    pub fn faults(&self) -> [(&'static str, Share); 4] {
        let [connections, wrong, weakened] = Score::default().faults().map(|(name, _)| name);
        let nth = |n: usize| self.sum(|case| case.score.faults()[n].1);
        [(connections, nth(0)), (wrong, nth(1)), (weakened, nth(2)), ("silently lost", self.sum(Case::silent))]
    }

    fn sum(&self, of: impl Fn(&Case) -> Share) -> Share {
        let add = |a: Share, b: Share| Share { part: a.part + b.part, whole: a.whole + b.whole };
        self.cases.iter().map(of).fold(Share::default(), add)
    }

    /// How many programs compile.
    pub fn compiled(&self) -> Share {
        Share { part: self.cases.iter().filter(|c| c.contradictions.is_some()).count(), whole: self.cases.len() }
    }

    /// How many programs compile and have no proved contradiction.
    pub fn free(&self) -> Share {
        Share { part: self.cases.iter().filter(|c| c.contradictions == Some(0)).count(), whole: self.cases.len() }
    }

    /// The clauses of all requests that were understood.
    pub fn clauses(&self) -> Share {
        self.sum(Case::clauses)
    }

    /// The longest time for one request.
    pub fn slowest(&self) -> Option<Duration> {
        self.cases.iter().filter_map(|c| c.reading.took).max()
    }

    /// The cases in which most is missing, the worst first.
    pub fn worst(&self, most: usize) -> Vec<&Case> {
        let mut cases: Vec<&Case> = self.cases.iter().filter(|c| !c.score.misses.is_empty()).collect();
        cases.sort_by(|a, b| a.merit().total_cmp(&b.merit()));
        cases.truncate(most);
        cases
    }

    /// Everything. Times are milliseconds.
    pub fn json(&self) -> Value {
        let pair = |share: Share| json!([share.part, share.whole]);
        let means: Map<String, Value> = self.means().into_iter().map(|(n, m)| (n.to_owned(), json!(m))).collect();
        let case = |case: &Case| {
            json!({
                "case": case.name,
                "words": case.words,
                "score": case.score.json(),
                "compiled": case.contradictions.is_some(),
                "contradictions": case.contradictions,
                "clauses": pair(case.clauses()),
                "silent": pair(case.silent()),
                "milliseconds": case.reading.took.map(milliseconds),
            })
        };
        json!({
            "format": FORMAT,
            "mean": means,
            "compiled": pair(self.compiled()),
            "contradiction_free": pair(self.free()),
            "clauses": pair(self.clauses()),
            "faults": self.faults().into_iter().map(|(n, s)| (n.to_owned(), pair(s))).collect::<Map<String, Value>>(),
            "milliseconds": self.slowest().map(milliseconds),
            "cases": self.cases.iter().map(case).collect::<Vec<_>>(),
        })
    }
}

/// To a hundredth.
fn milliseconds(time: Duration) -> f64 {
    (time.as_secs_f64() * 1e5).round() / 100.0
}

fn mean(values: impl Iterator<Item = Option<f64>>) -> Option<f64> {
    let values: Vec<f64> = values.flatten().collect();
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUTH: &str = r#"{ "id": "x", "rooms": [{ "name": "room" }], "relations": [], "numeric": [],
        "objects": [{ "name": "chair", "count": 2 }, { "name": "table", "count": 1 }] }"#;

    fn folder(names: &[&str]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for name in names {
            std::fs::write(folder.path().join(format!("{name}.txt")), name).unwrap();
            std::fs::write(folder.path().join(format!("{name}.expect.json")), TRUTH).unwrap();
        }
        folder
    }

    #[test]
    fn means_and_the_worst() {
        let folder = folder(&["b-broken", "a-good", "c-half", "d-impossible"]);
        std::fs::write(folder.path().join("notes.txt"), "no request: it has no ground truth").unwrap();
        let reader = |request: EvalRequest<'_>| {
            let program = match request.text {
                "a-good" => "object chair[2]; object table;",
                "b-broken" => "object chair[2]; object",
                "c-half" => "object chair; object lamp;",
                _ => "object chair[2]; object table; assert table.pos.x > 1; assert table.pos.x < 0;",
            };
            Ok(Reading {
                program: program.to_owned(),
                clauses: 4,
                understood: 3,
                words: 9,
                silent: vec!["blue".to_owned()],
                took: None,
            })
        };
        let mut heard = Vec::new();
        let all = read_folder(folder.path(), &reader, |n, of| heard.push((n, of))).unwrap();
        assert_eq!(heard, [(0, 4), (1, 4), (2, 4), (3, 4)]);
        let names: Vec<_> = all.cases.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names, ["a-good", "b-broken", "c-half", "d-impossible"]);
        // Recall: 1, 0, 1/2, 1. Precision: 1, of nothing, 1/2, 1. Counts: 1, 0, 0, 1. No relations at all.
        let means = all.means();
        assert_eq!(means[0], ("precision", Some(2.5 / 3.0)));
        assert_eq!(means[1], ("recall", Some(2.5 / 4.0)));
        assert_eq!(means[2], ("counts", Some(0.5)));
        assert_eq!(means[4], ("mentioned", None));
        assert_eq!((all.compiled().part, all.free().part), (3, 2));
        assert_eq!(all.clauses(), Share { part: 12, whole: 16 });
        assert_eq!(all.faults()[3], ("silently lost", Share { part: 4, whole: 36 }));
        let worst: Vec<_> = all.worst(9).iter().map(|c| c.name.as_str()).collect();
        assert_eq!(worst, ["b-broken", "c-half"]);
        assert_eq!(all.json()["cases"][3]["contradictions"], 1);
    }

    #[test]
    fn what_cannot_be_read() {
        let folder = folder(&["a"]);
        let refuse = |request: EvalRequest<'_>| Err(format!("no program for {}", request.name));
        assert_eq!(read_folder(folder.path(), &refuse, |_, _| ()).unwrap_err(), "no program for a");
        std::fs::write(folder.path().join("a.expect.json"), "{").unwrap();
        let empty = |_: EvalRequest<'_>| Ok(Reading::default());
        assert!(read_folder(folder.path(), &empty, |_, _| ()).unwrap_err().contains("a.expect.json"));
        assert!(read_folder(&folder.path().join("none"), &empty, |_, _| ()).is_err());
    }
}
