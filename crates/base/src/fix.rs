//! Fixes applied to a text: whole fixes or nothing of them, and never two that want the same place.
//!
//! Places are bytes of the text as it was before any of them. Which fixes are offered, and whether they may be applied
//! without asking, is said by the diagnostics that carry them.

use crate::{Edit, TextRange};

/// What came of some fixes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Applied {
    /// The text after them.
    pub text: String,
    /// Which were applied, by their number.
    pub made: Vec<usize>,
    /// Which were left out: they want a place that an earlier one has taken, or places that the text does not have.
    pub left: Vec<usize>,
}

/// Applies fixes, each a set of edits, to a text. A fix is applied with all its edits or not at all; of two that overlap
/// the one that is given first is applied.
pub fn apply<'e, F>(text: &str, fixes: F) -> Applied
where
    F: IntoIterator,
    F::Item: IntoIterator<Item = &'e Edit<TextRange>>,
{
    let mut taken: Vec<&Edit<TextRange>> = Vec::new();
    let mut out = Applied::default();
    for (number, fix) in fixes.into_iter().enumerate() {
        let before = taken.clone();
        let fits = fix.into_iter().all(|edit| is_place(text, edit.place) && insert(&mut taken, edit));
        // A fix without edits repairs nothing.
        if fits && taken.len() > before.len() {
            out.made.push(number);
        } else {
            taken = before;
            out.left.push(number);
        }
    }
    let mut at = 0;
    for edit in taken {
        let place = edit.place.bytes();
        out.text.push_str(&text[at..place.start]);
        out.text.push_str(&edit.text);
        at = place.end;
    }
    out.text.push_str(&text[at..]);
    out
}

/// Whether two edits cannot both be made, or not in a certain order: they replace a common byte, one inserts within what
/// the other replaces, or both insert at one point. Touching each other is fine.
pub fn overlap(a: TextRange, b: TextRange) -> bool {
    a == b || (a.start < b.end && b.start < a.end)
}

/// Puts an edit among those that are taken, in the order of the text; false if it overlaps one of them.
fn insert<'e>(taken: &mut Vec<&'e Edit<TextRange>>, edit: &'e Edit<TextRange>) -> bool {
    // An insertion comes before what begins where it stands.
    let key = |e: &Edit<TextRange>| (e.place.start, e.place.end);
    let at = taken.partition_point(|e| key(e) < key(edit));
    let neighbours = [at.checked_sub(1).map(|before| taken[before]), taken.get(at).copied()];
    if neighbours.into_iter().flatten().any(|e| overlap(e.place, edit.place)) {
        return false;
    }
    taken.insert(at, edit);
    true
}

/// Whether the range is one of whole characters of the text.
fn is_place(text: &str, place: TextRange) -> bool {
    text.get(place.start as usize..place.end as usize).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn edit(start: u32, end: u32, text: &str) -> Edit<TextRange> {
        Edit { place: TextRange { start, end }, text: text.into() }
    }

    #[test]
    fn fixes_are_applied_whole_or_not_at_all() {
        type Case<'c> = (&'c [&'c [Edit<TextRange>]], &'c str, &'c [usize]);
        let cases: [Case<'_>; 8] = [
            (&[&[edit(1, 2, "X")], &[edit(3, 3, "+")]], "aXc+def", &[0, 1]),
            (&[&[edit(3, 3, "+")], &[edit(1, 2, "X")]], "aXc+def", &[0, 1]),
            // The second fix wants what the first has; its other edit is not made either.
            (&[&[edit(1, 3, "X")], &[edit(2, 4, "Y"), edit(5, 6, "Z")]], "aXdef", &[0]),
            (&[&[edit(2, 2, "1")], &[edit(2, 2, "2")]], "ab1cdef", &[0]),
            // Touching: before and behind what is replaced.
            (&[&[edit(2, 3, "C")], &[edit(2, 2, "<"), edit(3, 3, ">")]], "ab<C>def", &[0, 1]),
            (&[&[edit(0, 3, "")], &[edit(1, 1, "x")]], "def", &[0]),
            (&[&[edit(4, 9, "x")], &[edit(9, 2, "x")], &[]], "abcdef", &[]),
            // Overlaps itself.
            (&[&[edit(0, 2, "x"), edit(1, 3, "y")]], "abcdef", &[]),
        ];
        for (fixes, text, made) in cases {
            let applied = apply("abcdef", fixes.iter().copied());
            assert_eq!((applied.text.as_str(), applied.made.as_slice()), (text, made));
            assert_eq!(applied.made.len() + applied.left.len(), fixes.len());
        }
        assert_eq!(apply("é", [&[edit(1, 2, "x")][..]]).left, [0]);
    }

    /// Edits that do not overlap, in the order of the text.
    fn disjoint() -> impl Strategy<Value = Vec<Edit<TextRange>>> {
        prop::collection::vec((1u32..5, 0u32..4, "[a-z]{0,3}"), 0..8).prop_map(|parts| {
            let mut at = 0;
            let place = |(skip, len, text): (u32, u32, String)| {
                let start = at + skip;
                at = start + len;
                edit(start, at, &text)
            };
            parts.into_iter().map(place).collect()
        })
    }

    proptest! {
        /// Disjoint edits give the same text in any order, one fix each or all in one.
        #[test]
        fn the_order_of_disjoint_edits_is_of_no_account(edits in disjoint(), seed in any::<u64>()) {
            let text: String = ('A'..='Z').cycle().take(80).collect();
            let straight = apply(&text, edits.iter().map(std::slice::from_ref));
            prop_assert!(straight.left.is_empty());
            prop_assert_eq!(&straight.text, &apply(&text, [&edits]).text);
            let mut shuffled: Vec<usize> = (0..edits.len()).collect();
            shuffled.sort_by_key(|i| seed.rotate_left(*i as u32 * 7) ^ (*i as u64));
            let other = apply(&text, shuffled.iter().map(|i| std::slice::from_ref(&edits[*i])));
            prop_assert_eq!(&straight.text, &other.text);
            // Made from the back, where nothing shifts.
            let mut by_hand = text;
            for edit in edits.iter().rev() {
                by_hand.replace_range(edit.place.bytes(), &edit.text);
            }
            prop_assert_eq!(straight.text, by_hand);
        }

        /// Whatever the edits: no panic, and the length is accounted for.
        #[test]
        fn any_edits_are_applied_or_left(places in prop::collection::vec((0u32..30, 0u32..30), 0..10)) {
            let text = "objekt é lämp; // ünd so";
            let edits: Vec<_> = places.iter().map(|(a, b)| edit(*a, *b, "??")).collect();
            let applied = apply(text, edits.iter().map(std::slice::from_ref));
            let removed: usize = applied.made.iter().map(|i| edits[*i].place.len() as usize).sum();
            prop_assert_eq!(applied.text.len() + removed, text.len() + 2 * applied.made.len());
        }
    }
}
