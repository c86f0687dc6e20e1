//! Names and phrases as lists of plain words: `readingLamp2`, "Reading lamps" and `reading_lamp` are one.

/// Lower-case words in the singular: split at blanks, signs, digits and humps; digits dropped; British spelling of grey
/// folded. What stands in brackets (an index) is dropped.
pub fn words(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    let mut word = String::new();
    let mut was_lower = false;
    let mut depth = 0_usize;
    let chars: Vec<char> = text.chars().collect();
    for (i, &c) in chars.iter().enumerate() {
        match c {
            '[' | '(' => depth += 1,
            ']' | ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        let hump = c.is_uppercase() && (was_lower || chars.get(i + 1).is_some_and(|n| n.is_lowercase()));
        if !c.is_alphabetic() || hump || depth > 0 {
            finish(&mut word, &mut out);
        }
        if c.is_alphabetic() && depth == 0 {
            word.extend(c.to_lowercase());
        }
        was_lower = c.is_lowercase();
    }
    finish(&mut word, &mut out);
    out
}

fn finish(word: &mut String, out: &mut Vec<String>) {
    if !word.is_empty() {
        out.push(singular(&std::mem::take(word)));
    }
}

/// The singular of an English noun by its ending; what does not look like a plural is left alone.
fn singular(word: &str) -> String {
    const ALONE: [&str; 12] = [
        "glass",
        "canvas",
        "stainless",
        "chess",
        "bus",
        "gas",
        "abacus",
        "kiosk",
        "series",
        "tennis",
        "brass",
        "cactus",
    ];
    const IRREGULAR: [(&str, &str); 10] = [
        ("shelves", "shelf"),
        ("knives", "knife"),
        ("people", "person"),
        ("mice", "mouse"),
        ("cacti", "cactus"),
        ("leaves", "leaf"),
        ("loaves", "loaf"),
        ("bookshelves", "bookshelf"),
        ("greys", "gray"),
        ("grey", "gray"),
    ];
    if let Some((_, to)) = IRREGULAR.iter().find(|(from, _)| *from == word) {
        return (*to).to_owned();
    }
    if ALONE.contains(&word) || word.len() < 4 || word.ends_with("ss") || word.ends_with("us") || word.ends_with("is") {
        return word.to_owned();
    }
    if let Some(stem) = word.strip_suffix("ies") {
        return format!("{stem}y");
    }
    for ending in ["xes", "ches", "shes", "sses"] {
        if word.ends_with(ending) {
            return word[..word.len() - 2].to_owned();
        }
    }
    word.strip_suffix('s').unwrap_or(word).to_owned()
}

/// A stable number for a text (FNV-1a), the seed of an object's own variations.
pub(crate) fn hash(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// A small stream of repeatable numbers (splitmix64).
#[derive(Clone, Debug)]
pub(crate) struct Dice(u64);

impl Dice {
    /// The stream of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }
    /// The next number in 0..1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
    /// The next number in lo..hi.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }
    pub fn pick<'a, T>(&mut self, from: &'a [T]) -> &'a T {
        &from[((self.unit() * from.len() as f64) as usize).min(from.len() - 1)]
    }
}
