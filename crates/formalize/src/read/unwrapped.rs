//! Requests from files and mails: lines that were broken because they were long go on in the next one, and "6m-by-4m" is "6 by
//! 4 m". Every byte stays where it is.

/// Lines at least so long are broken where no sentence ends (characters).
const LONG: usize = 40;
/// And so long where the next one does not begin like a thing of a list (characters).
const SHORT: usize = 20;
/// How things of a list begin.
const ITEMS: [&str; 10] = ["a", "an", "the", "one", "two", "three", "four", "five", "six", "some"];
/// What a line may end with, or the next one begin with, if a sentence goes on.
const GOES_ON: [&str; 34] = [
    "a", "an", "the", "of", "to", "in", "on", "at", "with", "and", "or", "by", "for", "from", "near", "next",
    "against", "behind", "beside", "between", "under", "above", "over", "is", "are", "has", "have", "must", "should",
    "least", "most", "that", "which", "front",
];

/// A text of the same length without broken lines.
pub fn unwrapped(text: &str) -> String {
    let text = text.replace("-by-", " by ");
    let mut out = text.clone().into_bytes();
    let mut from = 0;
    while let Some(end) = text[from..].find('\n').map(|n| from + n) {
        let next = &text[end + 1..];
        let next = &next[..next.find('\n').unwrap_or(next.len())];
        if goes_on(text[from..end].trim_end(), next) {
            out[end] = b' ';
            if end > 0 && out[end - 1] == b'\r' {
                out[end - 1] = b' ';
            }
        }
        from = end + 1;
    }
    // Only ASCII was written over ASCII.
    String::from_utf8(out).unwrap_or(text)
}

/// Whether a line goes on in the next one: it ends with a word and is long, or one of the two says that there is more to it.
fn goes_on(line: &str, next: &str) -> bool {
    let last = line.rsplit(' ').next().unwrap_or_default();
    let first = next.split(' ').next().unwrap_or_default();
    let ends_in_word =
        line.ends_with(|c: char| c.is_alphanumeric() || c == '\'') || line.ends_with(',') && line.len() >= LONG;
    let begins = next.starts_with(|c: char| c.is_lowercase() || c.is_ascii_digit());
    // "1. A sofa", "2) a lamp": the next of a list.
    let is_item = next.trim_start_matches(|c: char| c.is_ascii_digit()).starts_with(['.', ')', ':']);
    let more = GOES_ON.contains(&last.to_lowercase().as_str()) || GOES_ON.contains(&first) && !ITEMS.contains(&first);
    let is_capital = next.starts_with(char::is_uppercase) && GOES_ON.contains(&last.to_lowercase().as_str());
    let length = line.chars().count();
    let is_prose = length >= LONG || length >= SHORT && !ITEMS.contains(&first);
    ends_in_word && !is_item && (begins && (is_prose || more) || is_capital)
}

#[cfg(test)]
mod tests {
    use super::unwrapped;

    #[test]
    fn long_lines_go_on_and_lists_do_not() {
        for (text, becomes) in [
            (
                "A study with a desk, and the desk is at least\n2 m from the door.\nA lamp",
                "A study with a desk, and the desk is at least 2 m from the door.\nA lamp",
            ),
            ("a lamp next to\nthe TV", "a lamp next to the TV"),
            ("a lamp next to the\nTV", "a lamp next to the TV"),
            ("a desk\na chair\nlamp", "a desk\na chair\nlamp"),
            ("desk\nchair\nlamp", "desk\nchair\nlamp"),
            ("a mirror on the right side\nwall", "a mirror on the right side wall"),
            ("a desk with two drawers\na chair with arms", "a desk with two drawers\na chair with arms"),
            ("Objects\n- a desk\n- a chair", "Objects\n- a desk\n- a chair"),
            ("a 6m-by-4m room", "a 6m by 4m room"),
        ] {
            assert_eq!(unwrapped(text), becomes);
        }
    }
}
