//! Misspelt nouns: "armchiars" are armchairs. Only what no other word is likely to be: two letters changed places, a letter
//! is doubled or is not, or one is missing or too many in a long word; the first letter is right, and one noun fits.

use super::lexicon::{get, plural, singular};
use super::token::Token;
use crate::furnish::{kinds, styles};
use scenelang_lang::{library, nouns};

/// Shorter words are too often other words.
const SHORT: usize = 5;
/// From this length on, a letter may be missing or too many.
const LONG: usize = 7;

/// Words of places, which are misspelt as often.
const PLACES: [&str; 14] = [
    "underneath",
    "beneath",
    "opposite",
    "between",
    "against",
    "behind",
    "beside",
    "corner",
    "window",
    "ceiling",
    "bathroom",
    "bedroom",
    "kitchen",
    "entrance",
];

/// Corrects what is misspelt.
pub fn correct(tokens: &mut [Token]) {
    for token in tokens.iter_mut().filter(|token| token.word() && !token.owner) {
        if let Some(meant) = meant(&token.text) {
            token.text = meant;
        }
    }
}

fn meant(word: &str) -> Option<String> {
    let one = singular(word);
    // "Filling", "planner": other forms of verbs.
    let of_verb = ["ing", "er", "ed"].iter().any(|end| one.ends_with(end));
    if one.len() < SHORT || of_verb || !word.chars().all(|c| c.is_ascii_lowercase()) || is_word(word) || is_word(&one) {
        return None;
    }
    let single = nouns::all().iter().map(|noun| noun.name).filter(|name| !name.contains(['_', ' ']));
    let mut fits = single.chain(PLACES).filter(|name| is_slip(&one, name));
    let (first, second) = (fits.next()?, fits.next());
    let found = if plural(word) { nouns::plural(first) } else { first.to_owned() };
    second.is_none().then_some(found)
}

/// Whether a word is known for anything.
fn is_word(word: &str) -> bool {
    get().known(word) || library::is_known(word) || kinds::named(word).is_some() || styles::named(word).is_some()
}

/// Whether a word is a noun with a slip of the pen.
fn is_slip(word: &str, noun: &str) -> bool {
    let (a, b) = (word.as_bytes(), noun.as_bytes());
    if a.first() != b.first() || a.len().abs_diff(b.len()) > 1 {
        return false;
    }
    let same = a.iter().zip(b).take_while(|(x, y)| x == y).count();
    let (long, short) = if a.len() >= b.len() { (a, b) } else { (b, a) };
    if a.len() == b.len() {
        // "Fireplase": a letter that sounds alike.
        let sounds =
            |x: u8, y: u8| [&b"scz"[..], b"iye", b"aeo", b"fv"].iter().any(|all| all.contains(&x) && all.contains(&y));
        if a.len() > LONG && same < a.len() && a[same + 1..] == b[same + 1..] && sounds(a[same], b[same]) {
            return true;
        }
        return same + 1 < a.len()
            && a[same] == b[same + 1]
            && a[same + 1] == b[same]
            && a[same + 2..] == b[same + 2..];
    }
    let one_more = long[same + 1..] == short[same..];
    let doubled = same > 0 && long[same] == long[same - 1];
    one_more && (doubled || short.len() >= LONG && same + 1 < long.len())
}

#[cfg(test)]
mod tests {
    use super::meant;

    #[test]
    fn slips_are_corrected_and_other_words_are_not() {
        for (word, noun) in [
            ("armchiars", "armchairs"),
            ("tabel", "table"),
            ("chiar", "chair"),
            ("refridgerator", "refrigerator"),
            ("wardrobbe", "wardrobe"),
            ("nighstand", "nightstand"),
            ("carpett", "carpet"),
            ("bookshlef", "bookshelf"),
            ("fireplase", "fireplace"),
        ] {
            assert_eq!(meant(word).as_deref(), Some(noun), "{word}");
        }
        for word in [
            "casket", "lamb", "beard", "angel", "planet", "tables", "stables", "trail", "seats", "curtsey", "spool",
            "filling",
        ] {
            assert_eq!(meant(word), None, "{word}");
        }
    }
}
