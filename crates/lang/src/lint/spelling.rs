//! W0204: names, and texts of one property, that differ by no more than a slip of the pen; W0205: categories of which
//! nothing is known; W0206: colors and materials that are misspelt.
//!
//! A false alarm would be worse than a slip that is missed. So digits and single letters at the end tell names apart
//! (`chair1`, `chairA`, `posX`), as do first letters (`table`, `cable`); a letter that is another, or missing in the
//! middle of a word, counts only where one of the two is hardly used.

use super::facts::Facts;
use crate::ast::StmtKind;
use crate::items::ItemKind;
use crate::library;
use rustc_hash::FxHashMap;
use scenelang_base::{Applicability, Diagnostic, Edit, Fix, Span, codes};

/// Longer spellings are not compared, and longer texts are no names of kinds.
const LONGEST: usize = 40;
/// So many spellings may share a variant before it was skipped: no hand makes so many slips.
const CROWD: usize = 8;

/// How two spellings differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Slip {
    /// By case or by what separates words.
    Case,
    /// By an `s` at the end.
    Plural,
    /// By two letters that changed places, or one that is doubled.
    Sure,
    /// By a letter in the middle.
    Faint,
}

/// Two spellings of one stem.
struct Stem<'a> {
    text: &'a str,
    /// Ends in digits.
    numbered: bool,
    /// The first place with this stem, and the whole spelling there.
    place: Option<Span>,
    whole: &'a str,
    /// How often it is used.
    used: u32,
    /// For names: what it is.
    kind: Option<ItemKind>,
    /// For texts: whether it is compared somewhere, or else only assigned.
    compared: bool,
    /// For texts: all its places.
    places: Vec<Span>,
}

/// Reports pairs of spellings that are nearly equal.
pub fn check(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    names(facts, out);
    texts(facts, out);
    categories(facts, out);
    colors(facts, out);
}

/// Colors and materials that are none, and nearly are one, each once.
fn colors(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    let mut known: Vec<&str> = Vec::new();
    let texts = facts.statements.iter().flat_map(|linted| linted.uses.texts.iter().map(move |text| (linted, text)));
    for (linted, text) in texts.filter(|(_, t)| !t.compared) {
        let (what, note) = if is_color(&text.property) {
            (
                "color",
                "an unknown color has no effect; a color is a name (`navy`, `light oak`) or a hexadecimal value (`#336699`)",
            )
        } else if is_material(&text.property) {
            ("material", "an unknown material has no effect on how an object looks")
        } else {
            continue;
        };
        let Some(place) = linted.place.span(text.range) else { continue };
        // So long a text is no name.
        if known.contains(&text.text.as_str()) || text.text.len() > LONGEST {
            continue;
        }
        known.push(&text.text);
        if let Some(digits) = text.text.strip_prefix('#')
            && what == "color"
            && (digits.len() != 6 || !digits.bytes().all(|digit| digit.is_ascii_hexdigit()))
        {
            let d = Diagnostic::new(codes::W0206, place, format!("unknown color \"{}\"", text.text));
            out.push(d.note("the value of a color has six hexadecimal digits: `#336699`"));
            continue;
        }
        // Whatever else it is, it is no slip in a name.
        if text.text.contains(|c: char| !c.is_alphanumeric() && !matches!(c, ' ' | '-' | '_')) {
            continue;
        }
        let Some(near) = library::meant_color(&text.text) else { continue };
        let d = Diagnostic::new(codes::W0206, place, format!("unknown {what} \"{}\"", text.text)).note(note);
        out.push(meant(d, place, near));
    }
}

/// The same with a spelling that may be meant, and a fix that writes it.
fn meant(d: Diagnostic, place: Span, near: &str) -> Diagnostic {
    let mut d = d.label(format!("did you mean \"{near}\"?"));
    d.fixes.push(Fix {
        title: format!("write \"{near}\""),
        edits: vec![Edit { place, text: format!("\"{near}\"") }],
        applicability: Applicability::Unsafe,
    });
    d
}

/// A text as it is quoted in a message.
fn shortened(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// Whether the texts of a property name colors.
fn is_color(property: &str) -> bool {
    matches!(property, "color" | "floorColor" | "wallColor")
}

fn is_material(property: &str) -> bool {
    matches!(property, "material" | "floorMaterial" | "wallMaterial")
}

/// Categories of which neither a usual size nor what they are for is known, each once: where they are assigned, for what
/// no object has is reported where it is compared.
fn categories(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    let mut known: Vec<&str> = Vec::new();
    let texts = facts.statements.iter().flat_map(|linted| linted.uses.texts.iter().map(move |text| (linted, text)));
    for (linted, text) in texts.filter(|(_, t)| t.property == "category" && !t.compared && !t.text.trim().is_empty()) {
        let Some(place) = linted.place.span(text.range) else { continue };
        let mended = |d: &Diagnostic| d.fixes.iter().flat_map(|f| &f.edits).any(|edit| edit.place == place);
        let told = out.iter().any(|d| d.code == codes::W0204 && mended(d));
        // A region has no category, which is an error.
        let of_region = match &linted.place.stmt.kind {
            StmtKind::Assign { name, .. } => facts.names.item(&name.text) == Some(ItemKind::Region),
            _ => false,
        };
        if told || of_region || known.contains(&text.text.as_str()) || library::is_known(&text.text) {
            continue;
        }
        known.push(&text.text);
        let message = format!("unknown category \"{}\"", shortened(&text.text));
        let d = Diagnostic::new(codes::W0205, place, message)
            .note("an object of an unknown category has no usual size and looks like a box; `scenelang categories` lists the known ones");
        let near = library::nearest_category(&text.text);
        out.push(match near {
            Some(near) => meant(d, place, &near),
            None => d,
        });
    }
}

fn names(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    let mut stems: Vec<Stem<'_>> = Vec::new();
    let mut known: FxHashMap<&str, usize> = FxHashMap::default();
    for (name, _) in &facts.order {
        if facts.names.is_poisoned(&name.text) {
            continue;
        }
        let count = |of: &FxHashMap<_, u32>| of.get(&name.text).copied().unwrap_or_default();
        let used = count(&facts.read) + count(&facts.assigned);
        let text = stem(&name.text);
        let at = *known.entry(text).or_insert_with(|| {
            stems.push(Stem {
                text,
                numbered: text.len() < name.text.len(),
                place: facts.declared_at(&name.text),
                whole: &name.text,
                used: 0,
                kind: facts.names.item(&name.text),
                compared: false,
                places: Vec::new(),
            });
            stems.len() - 1
        });
        stems[at].used += used;
    }
    for (first, second, slip) in pairs(&stems, 3) {
        let (a, b) = (&stems[first], &stems[second]);
        let fits = match slip {
            Slip::Case | Slip::Sure => true,
            // `object chair[4]; object chairs;` are a kind of thing and something else.
            Slip::Plural => !a.numbered && !b.numbered && same_kind(a.kind, b.kind),
            Slip::Faint => a.used.min(b.used) <= 1,
        };
        if let (true, Some(at), Some(before)) = (fits, b.place, a.place) {
            let message = format!("`{}` and `{}` are nearly identical", b.whole, a.whole);
            let d = Diagnostic::new(codes::W0204, at, message).related(before, "the other one");
            out.push(d.note("if both are intentional, choose names that are easier to tell apart"));
        }
    }
}

fn same_kind(a: Option<ItemKind>, b: Option<ItemKind>) -> bool {
    match (a, b) {
        (Some(ItemKind::Array(_)), Some(ItemKind::Array(_))) => true,
        (a, b) => a == b,
    }
}

fn texts(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    let group = |property: &str| match property {
        "category" => Some("category"),
        _ if is_color(property) => Some("color"),
        "material" | "floorMaterial" | "wallMaterial" => Some("material"),
        "features" => Some("features"),
        _ => None,
    };
    for property in ["category", "color", "material", "features"] {
        let mut stems: Vec<Stem<'_>> = Vec::new();
        let mut known: FxHashMap<&str, usize> = FxHashMap::default();
        for linted in facts.statements {
            for text in linted.uses.texts.iter().filter(|t| group(&t.property) == Some(property)) {
                let Some(place) = linted.place.span(text.range) else { continue };
                let at = *known.entry(&text.text).or_insert_with(|| {
                    stems.push(Stem {
                        text: &text.text,
                        numbered: false,
                        place: Some(place),
                        whole: &text.text,
                        used: 0,
                        kind: None,
                        compared: false,
                        places: Vec::new(),
                    });
                    stems.len() - 1
                });
                stems[at].used += 1;
                stems[at].compared |= text.compared;
                stems[at].places.push(place);
            }
        }
        for (first, second, slip) in pairs(&stems, 2) {
            let (a, b) = (&stems[first], &stems[second]);
            // A colour that is not asked about may be spelt in two ways.
            let matters = property == "category" || a.compared || b.compared;
            if !matters || slip == Slip::Faint && a.used.min(b.used) > 1 {
                continue;
            }
            // The rarer is the slip; of two that are as rare, the later one.
            let (right, wrong) = if a.used < b.used { (b, a) } else { (a, b) };
            let (Some(at), Some(other)) = (wrong.place, right.place) else { continue };
            let message = format!("\"{}\" and \"{}\" are nearly identical", wrong.whole, right.whole);
            let mut d = Diagnostic::new(codes::W0204, at, message)
                .related(other, "the other one")
                .note("strings are compared exactly, so these two are different");
            if wrong.places.iter().all(|p| p.file == at.file) && !right.whole.contains(['"', '\\']) {
                let edit = |place: &Span| Edit { place: *place, text: format!("\"{}\"", right.whole) };
                d.fixes.push(Fix {
                    title: format!("write \"{}\"", right.whole),
                    edits: wrong.places.iter().map(edit).collect(),
                    applicability: Applicability::Unsafe,
                });
            }
            out.push(d);
        }
    }
}

/// A name without the digits at its end, and what separates them from it.
fn stem(name: &str) -> &str {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    if stem.len() == name.len() { name } else { stem.trim_end_matches('_') }
}

/// Pairs of spellings that differ by a slip, the earlier one first; each pair once, in order.
///
/// Spellings one slip apart become equal when a letter is taken out of each (or of one), or case and separators of
/// both: so each is filed under the hashes of its variants, and only those that meet there are compared.
/// Those with fewer letters than `least` are left out.
fn pairs(stems: &[Stem<'_>], least: usize) -> Vec<(usize, usize, Slip)> {
    let mut variants: Vec<(u64, u32)> = Vec::new();
    for (i, stem) in stems.iter().enumerate() {
        let letters: Vec<u64> = stem
            .text
            .chars()
            .filter(|c| !is_separator(*c))
            .flat_map(char::to_lowercase)
            .map(|c| u64::from(c) + 1)
            .collect();
        if letters.len() < least || letters.len() > LONGEST {
            continue;
        }
        variants.extend(without_one(&letters).map(|hash| (hash, i as u32)));
    }
    variants.sort_unstable();
    variants.dedup();
    let mut out: Vec<(usize, usize)> = Vec::new();
    for bucket in variants.chunk_by(|a, b| a.0 == b.0).filter(|bucket| bucket.len() <= CROWD) {
        for (n, (_, a)) in bucket.iter().enumerate() {
            out.extend(bucket[n + 1..].iter().map(|(_, b)| (*a as usize, *b as usize)));
        }
    }
    out.sort_unstable();
    out.dedup();
    out.into_iter().filter_map(|(a, b)| Some((a, b, slip(stems[a].text, stems[b].text)?))).collect()
}

/// Hashes of the letters, of all of them and with each one taken out.
fn without_one(letters: &[u64]) -> impl Iterator<Item = u64> {
    const BASE: u64 = 0x9e37_79b9_7f4a_7c15;
    // A polynomial of the letters before and behind the one that is out.
    let mut behind = vec![0u64; letters.len() + 1];
    let mut powers = vec![1u64; letters.len() + 1];
    for (i, letter) in letters.iter().rev().enumerate() {
        behind[i + 1] = behind[i].wrapping_add(letter.wrapping_mul(powers[i]));
        powers[i + 1] = powers[i].wrapping_mul(BASE);
    }
    let n = letters.len();
    let mut before = 0u64;
    let mut out = Vec::with_capacity(n + 1);
    out.push(behind[n]);
    for (i, letter) in letters.iter().enumerate() {
        let rest = n - i - 1;
        out.push(before.wrapping_mul(powers[rest]).wrapping_add(behind[rest]));
        before = before.wrapping_mul(BASE).wrapping_add(*letter);
    }
    out.into_iter()
}

fn is_separator(c: char) -> bool {
    matches!(c, '_' | '-' | ' ')
}

/// How two spellings differ, if it is by a slip.
fn slip(a: &str, b: &str) -> Option<Slip> {
    let fold = |s: &str| s.chars().filter(|c| !is_separator(*c)).flat_map(char::to_lowercase).collect::<String>();
    if fold(a) == fold(b) {
        return Some(Slip::Case);
    }
    let found = letters_apart(&a.chars().collect::<Vec<_>>(), &b.chars().collect::<Vec<_>>())?;
    // Two words that are both kinds of furniture are two words.
    let real = |s: &str| library::is_category(&s.to_lowercase());
    (found == Slip::Plural || !(real(a) && real(b))).then_some(found)
}

fn letters_apart(a: &[char], b: &[char]) -> Option<Slip> {
    let same = |x: &[char], y: &[char]| {
        x.len() == y.len() && x.iter().zip(y).all(|(x, y)| x.to_lowercase().eq(y.to_lowercase()))
    };
    let (short, long) = if a.len() <= b.len() { (a, b) } else { (b, a) };
    let at = short.iter().zip(long).take_while(|(x, y)| x.to_lowercase().eq(y.to_lowercase())).count();
    if short.len() == long.len() {
        let (x, y) = (*short.get(at)?, *long.get(at)?);
        if let (Some(&x2), Some(&y2)) = (short.get(at + 1), long.get(at + 1))
            && (x, x2) == (y2, y)
            && same(&short[at + 2..], &long[at + 2..])
        {
            // Capitals that change places are marks: NE, EN.
            return (x.is_lowercase() && x2.is_lowercase() && short.len() >= 4).then_some(Slip::Sure);
        }
        let letters = x.is_alphabetic() && y.is_alphabetic();
        let inner = letters && is_inner(short, at) && is_inner(long, at) && word_length(short, at) >= 6;
        return (inner && same(&short[at + 1..], &long[at + 1..])).then_some(Slip::Faint);
    }
    if long.len() != short.len() + 1 || !same(&short[at..], &long[at + 1..]) {
        return None;
    }
    let more = long[at];
    // `at` is behind all letters that are alike: a doubled one differs at its second place.
    let doubled = at > 0 && long[at - 1] == more && more.is_lowercase();
    match more {
        _ if !more.is_alphabetic() => None,
        _ if doubled && short.len() >= 4 => Some(Slip::Sure),
        's' if at == short.len() && short.len() >= 3 => Some(Slip::Plural),
        _ if is_inner(long, at) && word_length(short, at) >= 5 => Some(Slip::Faint),
        _ => None,
    }
}

/// Whether a letter has letters of its word on both sides.
fn is_inner(text: &[char], at: usize) -> bool {
    at > word(text, at).start && at + 1 < word(text, at).end
}

fn word_length(text: &[char], at: usize) -> usize {
    word(text, at).len()
}

/// The word around a letter: separators, digits and humps end one.
fn word(text: &[char], at: usize) -> std::ops::Range<usize> {
    let breaks = |i: usize| {
        let (before, after) = (text[i - 1], text[i]);
        !before.is_alphabetic() || !after.is_alphabetic() || after.is_uppercase() && !before.is_uppercase()
    };
    let at = at.min(text.len().saturating_sub(1));
    let start = (1..=at).rev().find(|i| breaks(*i)).unwrap_or(0);
    let end = (at + 1..text.len()).find(|i| breaks(*i)).unwrap_or(text.len());
    start..end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_told_from_other_words() {
        use Slip::*;
        let cases = [
            ("chair", "Chair", Some(Case)),
            ("diningTable", "dining_table", Some(Case)),
            ("coffee table", "coffeetable", Some(Case)),
            ("chair", "chiar", Some(Sure)),
            ("chair", "chairr", Some(Sure)),
            ("carpet", "carppet", Some(Sure)),
            ("stool", "stol", Some(Sure)),
            ("chair", "chairs", Some(Plural)),
            ("cabinet", "cabunet", Some(Faint)),
            ("monitor", "montor", Some(Faint)),
            // Other words, other marks.
            ("lamp", "clamp", None),
            ("table", "cable", None),
            ("plan", "plant", None),
            ("table", "tablet", None),
            ("desk", "disk", None),
            ("sofa", "soda", None),
            ("chairA", "chairB", None),
            ("lampL", "lampR", None),
            ("posX", "posY", None),
            ("stepx", "stepz", None),
            ("wallNE", "wallEN", None),
            ("chair", "chair2", None),
            ("row1a", "row2a", None),
            ("rowStep", "lowStep", None),
            ("a", "A", Some(Case)),
            ("chairWest", "chairEast", None),
            ("minX", "maxX", None),
        ];
        for (a, b, expected) in cases {
            assert_eq!(slip(a, b), expected, "{a} {b}");
            assert_eq!(slip(b, a), expected, "{b} {a}");
        }
    }

    #[test]
    fn pairs_are_found_among_many() {
        let words = ["chair", "lamp", "Chair", "chiar", "a", "A", "monitors", "table", "cable", "montors"];
        let stem = |text: &'static str| Stem {
            text,
            numbered: false,
            place: None,
            whole: text,
            used: 0,
            kind: None,
            compared: false,
            places: Vec::new(),
        };
        let stems: Vec<Stem<'_>> = words.into_iter().map(stem).collect();
        let found: Vec<String> =
            pairs(&stems, 3).into_iter().map(|(a, b, _)| format!("{} {}", stems[a].text, stems[b].text)).collect();
        assert_eq!(found, ["chair Chair", "chair chiar", "Chair chiar", "monitors montors"]);
    }

    #[test]
    fn numbers_are_no_part_of_a_stem() {
        assert_eq!([stem("chair12"), stem("lamp_3"), stem("a2b"), stem("x")], ["chair", "lamp", "a2b", "x"]);
    }
}
