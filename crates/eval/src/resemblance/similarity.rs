//! How alike two texts are, from 0 to 1.

use std::collections::BTreeMap;

/// A measure of likeness.
pub trait Similarity: Sync {
    /// What it is called in reports.
    fn name(&self) -> &str;
    /// How alike two texts are, 0 to 1.
    fn of(&self, a: &str, b: &str) -> f64;
}

/// Of letters: twice the trigrams that both texts have over all that they have. Each word counts with one blank before and one
/// after it, in small letters; what is no letter parts words.
#[derive(Clone, Copy, Debug, Default)]
pub struct Lexical;

impl Similarity for Lexical {
    fn name(&self) -> &str {
        "lexical"
    }

    fn of(&self, a: &str, b: &str) -> f64 {
        let (a, b) = (trigrams(a), trigrams(b));
        let count = |of: &BTreeMap<[char; 3], usize>| of.values().sum::<usize>();
        let common: usize = a.iter().map(|(gram, n)| b.get(gram).map_or(0, |m| *n.min(m))).sum();
        let all = count(&a) + count(&b);
        if all == 0 { 0.0 } else { 2.0 * common as f64 / all as f64 }
    }
}

fn trigrams(text: &str) -> BTreeMap<[char; 3], usize> {
    let mut out = BTreeMap::new();
    for word in text.split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty()) {
        let letters: Vec<char> = [' '].into_iter().chain(word.to_lowercase().chars()).chain([' ']).collect();
        for gram in letters.windows(3) {
            *out.entry([gram[0], gram[1], gram[2]]).or_default() += 1;
        }
    }
    out
}

/// Of vectors that somebody's model has made of the texts: their scaled product, as published. The vectors come from a file,
/// so that any model can be used and none is needed to check a figure.
#[derive(Clone, Debug, Default)]
pub struct Embedded {
    name: String,
    vectors: BTreeMap<String, Vec<f64>>,
}

impl Embedded {
    /// Reads lines of JSON, `{"text": …, "vector": […]}`; each vector is brought to length 1. `name` is what reports call it.
    ///
    /// # Errors
    /// The first line that cannot be used, and why.
    pub fn read(name: &str, text: &str) -> Result<Self, String> {
        #[derive(serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Line {
            text: String,
            vector: Vec<f64>,
        }
        let mut out = Self { name: name.to_owned(), vectors: BTreeMap::new() };
        let mut long = None;
        for (n, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
            let bad = |why: String| format!("line {}: {why}", n + 1);
            let line: Line = serde_json::from_str(line).map_err(|e| bad(e.to_string()))?;
            let length = line.vector.iter().map(|x| x * x).sum::<f64>().sqrt();
            if !length.is_normal() || !length.is_finite() {
                return Err(bad("a vector must be longer than 0".to_owned()));
            }
            if *long.get_or_insert(line.vector.len()) != line.vector.len() {
                return Err(bad("all vectors need the same number of entries".to_owned()));
            }
            out.vectors.insert(line.text, line.vector.iter().map(|x| x / length).collect());
        }
        if out.vectors.is_empty() { Err("it contains no vector".to_owned()) } else { Ok(out) }
    }

    /// The first of the texts that there is no vector for.
    pub fn missing<'a>(&self, texts: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
        texts.into_iter().find(|text| !self.vectors.contains_key(*text))
    }
}

impl Similarity for Embedded {
    fn name(&self) -> &str {
        &self.name
    }

    /// 0 where there is no vector for one of them; [`Embedded::missing`] says so before.
    fn of(&self, a: &str, b: &str) -> f64 {
        let Some((a, b)) = self.vectors.get(a).zip(self.vectors.get(b)) else { return 0.0 };
        let product: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
        ((1.0 + product) / 2.0).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_by_hand() {
        // " chair ": 5 trigrams; " armchair ": 8, of which "cha", "hai", "air", "ir " are common.
        assert_eq!(Lexical.of("chair", "armchair"), 8.0 / 13.0);
        assert_eq!(Lexical.of("Chair", "chair"), 1.0);
        assert_eq!(Lexical.of("oak desk", "desk (oak)"), 1.0);
        // " a ": one trigram, twice against once.
        assert_eq!(Lexical.of("a a", "a"), 2.0 / 3.0);
        assert_eq!(Lexical.of("", ""), 0.0);
        assert_eq!(Lexical.of("sofa", "lamp"), 0.0);
    }

    #[test]
    fn vectors_by_hand() {
        let text = "{\"text\": \"a\", \"vector\": [2, 0]}\n\n{\"text\": \"b\", \"vector\": [0, 1]}\n{\"text\": \"c\", \"vector\": [-1, 0]}";
        let by = Embedded::read("m", text).unwrap();
        assert_eq!([by.of("a", "a"), by.of("a", "b"), by.of("a", "c"), by.of("a", "d")], [1.0, 0.5, 0.0, 0.0]);
        assert_eq!((by.missing(["a", "d"]), by.missing(["a"])), (Some("d"), None));
        for (bad, why) in [
            ("", "it contains no vector"),
            ("{\"text\": \"a\", \"vector\": [0, 0]}", "line 1: a vector must be longer than 0"),
            ("{\"text\": \"a\", \"vector\": [1]}\n{\"text\": \"b\", \"vector\": [1, 2]}", "line 2: all vectors"),
            ("{\"text\": \"a\"}", "line 1: missing field"),
        ] {
            assert!(Embedded::read("m", bad).unwrap_err().starts_with(why), "{bad}");
        }
    }
}
