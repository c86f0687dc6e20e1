//! "Did you mean": the nearest of some names.

/// So many candidates are compared letter by letter: of more, those with the most alike letters, whatever their order. A
/// program with thousands of slips among thousands of names is read in seconds, then.
const MANY: usize = 64;

/// The candidate nearest to `word` by edits (insert, delete, replace, swap of neighbours; case counts half), if it is
/// near enough to be a slip: at most a third of the letters.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (word.chars().count() * 2).div_ceil(3).max(2);
    let mut candidates: Vec<&str> = candidates.into_iter().collect();
    if candidates.len() > MANY {
        let own = letters(word);
        let mut ranked: Vec<(u32, &str)> = candidates.into_iter().map(|c| (unlike(&own, &letters(c)), c)).collect();
        ranked.select_nth_unstable(MANY);
        ranked.truncate(MANY);
        candidates = ranked.into_iter().map(|(_, c)| c).collect();
    }
    candidates
        .into_iter()
        .map(|c| (distance(word, c), c))
        .filter(|(d, _)| *d <= limit)
        .min_by_key(|(d, c)| (*d, c.len(), *c))
        .map(|(_, c)| c)
}

/// How often each letter is in a word, cases and rare signs not told apart.
fn letters(word: &str) -> [u8; 32] {
    let mut out = [0_u8; 32];
    for byte in word.bytes().take(64) {
        out[usize::from(byte & 31)] += 1;
    }
    out
}

/// In how many letters two words differ, whatever their order.
fn unlike(a: &[u8; 32], b: &[u8; 32]) -> u32 {
    a.iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(*b))).sum()
}

/// Restricted Damerau-Levenshtein distance in half edits.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(64).collect(), b.chars().take(64).collect());
    let mut rows = vec![(0..=b.len()).map(|j| j * 2).collect::<Vec<_>>()];
    for i in 1..=a.len() {
        let mut row = vec![i * 2];
        for j in 1..=b.len() {
            let same = match (a[i - 1], b[j - 1]) {
                (x, y) if x == y => 0,
                (x, y) if x.to_lowercase().eq(y.to_lowercase()) => 1,
                _ => 2,
            };
            let mut best = (rows[i - 1][j - 1] + same).min(rows[i - 1][j] + 2).min(row[j - 1] + 2);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 2);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_slips_and_nothing_far() {
        let names = ["chair", "table", "lamp"];
        assert_eq!(nearest("chiar", names), Some("chair"));
        assert_eq!(nearest("Table", names), Some("table"));
        assert_eq!(nearest("lump", names), Some("lamp"));
        assert_eq!(nearest("sofa", names), None);
    }

    #[test]
    fn finds_slips_among_thousands() {
        let names: Vec<String> = (0..5_000).map(|i| format!("chair{i}")).chain(["table".to_owned()]).collect();
        let all = || names.iter().map(String::as_str);
        assert_eq!(nearest("tabel", all()), Some("table"));
        assert_eq!(nearest("chiar1234", all()), Some("chair1234"));
        assert_eq!(
            nearest("chair1234", all().rev().filter(|n| *n != "chair1234")),
            nearest("chair1234", all().filter(|n| *n != "chair1234"))
        );
        assert_eq!(nearest("refrigerator", all()), None);
    }
}
