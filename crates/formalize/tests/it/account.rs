//! What became of each word of a request: it is part of the program, or it is reported; and what changes the meaning of a
//! clause and has no statement makes none.

use proptest::prelude::*;
use scenelang_formalize::brief::Word;
use scenelang_formalize::draft::ThingOrigin;
use scenelang_formalize::read::PURPOSE;
use scenelang_formalize::{Options, Reading, read};

const LITERAL: Options = Options { literal: true };

/// What the request demands by its own words: statements and things.
fn stated(reading: &Reading) -> Vec<String> {
    let own = |source: &ThingOrigin| matches!(source, ThingOrigin::Stated(_));
    let draft = &reading.draft;
    let things = draft.things.iter().filter(|t| own(&t.source)).map(|t| format!("object {}", t.name));
    things.chain(draft.statements.iter().filter(|s| own(&s.source)).map(|s| s.line())).collect()
}

#[test]
fn what_is_not_understood_makes_no_statement() {
    let (mut seen, mut wrong) = (0, Vec::new());
    for line in include_str!("account.txt").lines().filter(|l| !l.starts_with('#') && !l.is_empty()) {
        let columns: Vec<&str> = line.split("=>").map(str::trim).collect();
        let [request, want, never, listed] = columns[..] else { panic!("{line}") };
        let reading = read(request, &LITERAL);
        let stated = stated(&reading);
        let notes: Vec<&str> = reading.draft.notes.iter().map(|note| &request[note.at.clone()]).collect();
        let pieces = |column: &'static str| column.split(" & ").filter(|piece| !piece.is_empty());
        for piece in pieces(want).filter(|piece| !stated.iter().any(|s| s.contains(piece))) {
            wrong.push(format!("{request}: no `{piece}` in {stated:?}"));
        }
        let statements = || stated.iter().filter(|s| !s.starts_with("object "));
        for piece in pieces(never).filter(|piece| statements().any(|s| s.contains(piece))) {
            wrong.push(format!("{request}: `{piece}` in {stated:?}"));
        }
        for piece in pieces(listed).filter(|piece| !notes.iter().any(|note| note.contains(piece))) {
            wrong.push(format!("{request}: \"{piece}\" is not in {notes:?}"));
        }
        if listed.is_empty() && (reading.understood < reading.clauses || reading.words.iter().any(|w| !w.used)) {
            wrong.push(format!("{request}: not all of it was understood: {:?}", reading.words));
        }
        seen += 1;
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(seen > 10);
}

/// A clause is understood if all its words are, but for those that say whom or what something is for; a word that nothing
/// came of is in a note.
fn accounted(request: &str) {
    let reading = read(request, &LITERAL);
    assert_eq!(reading.read.iter().filter(|clause| clause.1).count(), reading.understood, "{request}");
    for (at, understood) in &reading.read {
        let own = reading.words.iter().filter(|word| at.start <= word.at.start && word.at.end <= at.end);
        let purposes = || reading.draft.notes.iter().filter(|note| note.reason == PURPOSE);
        let is_purpose = |word: &Word| purposes().any(|n| n.at.start <= word.at.start && word.at.end <= n.at.end);
        let accounted = own.clone().all(|word| word.used || is_purpose(word));
        assert_eq!(*understood, accounted, "{request}: {:?}", &request[at.clone()]);
    }
    let silent: Vec<&str> = reading.silent().into_iter().map(|at| &request[at]).collect();
    assert!(silent.is_empty(), "{request}: {silent:?}");
}

#[test]
fn no_word_is_lost_in_silence() {
    crate::support::requests().iter().for_each(|request| accounted(request));
}

#[test]
fn whom_something_is_for_is_no_demand() {
    for request in ["A lounge for guests", "A bench for visitors and a chair for reading", "A desk for my daughter"] {
        let reading = read(request, &LITERAL);
        assert_eq!(reading.understood, reading.clauses, "{request}");
        assert!(reading.draft.notes.iter().all(|note| note.reason == PURPOSE), "{request}: {:?}", reading.draft.notes);
    }
    // What is no purpose is lost all the same.
    let reading = read("A bench for visitors to the gloaming", &LITERAL);
    assert_eq!(reading.understood, 0, "{:?}", reading.draft.notes);
}

proptest! {
    #[test]
    fn any_text_is_accounted_for(words in "([a-z]{1,7}|[0-9]{1,3}|desk|chairs|near|except|than|rather|not|,|\\.|é| ){0,30}") {
        accounted(&words);
    }
}

#[test]
fn a_statement_says_its_own_words() {
    let request = "A meeting room, 6 by 4 m, with a long table, eight chairs around it and a screen on the wall";
    let program = scenelang_formalize::write::write(&read(request, &LITERAL).draft);
    for words in ["a long table", "eight chairs", "eight chairs around it", "a screen on the wall"] {
        assert!(program.contains(&format!("@req(\"{words}\")")), "{words}: {program}");
    }
    assert!(!program.contains("@req(\"A meeting room, 6 by 4 m, with"), "{program}");
}
