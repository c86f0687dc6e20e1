//! What became of the words of a request: each that says something is part of the brief, or it is reported.

use super::lexicon::{Class, get};
use super::token::{Token, WordKind};
use crate::brief::{Clause, Note, Word};
use std::ops::Range;

/// The clauses and the words of a request, and notes on those that became nothing.
#[derive(Debug, Default)]
pub struct Account {
    /// In their order.
    pub clauses: Vec<Clause>,
    /// In their order.
    pub words: Vec<Word>,
    /// What became nothing, as far as no other note says so.
    pub notes: Vec<Note>,
}

/// Why there is a note on a word that nothing came of and that seems to change nothing.
pub const BECAME_NOTHING: &str = "this word was not used";
const BECAME_NOTHING_MANY: &str = "these words were not used";
/// Why there is a note on whom or what something is for.
pub const PURPOSE: &str = "this says what or whom it is for, which no statement needs to express";

/// Accounts for the words. `used`: which tokens became part of the brief. `grammar`: which belong to verbs and the like
/// and say nothing of their own. `noted`: what the reader has reported.
pub fn account(tokens: &[Token], used: &[bool], grammar: &[bool], noted: &[Note]) -> Account {
    let mut out = Account::default();
    for clause in clauses(tokens) {
        let at = tokens[clause.start].at.start..tokens[clause.end - 1].at.end;
        let own: Vec<usize> = clause.clone().filter(|i| says_something(tokens, *i, grammar)).collect();
        for i in &own {
            let word = Word { at: tokens[*i].at.clone(), used: used[*i] };
            // What stands for a phrase of the request is that phrase, once.
            match out.words.iter_mut().find(|known| known.at == word.at) {
                Some(known) => known.used &= word.used,
                None => out.words.push(word),
            }
        }
        let understood = own.iter().all(|i| used[*i] || is_purpose(tokens, *i));
        out.clauses.push(Clause { at: at.clone(), understood });
        let told = |notes: &[Note], at: &Range<usize>| {
            notes.iter().chain(noted).any(|note| note.at.start <= at.start && at.end <= note.at.end)
        };
        if !understood && own.iter().all(|i| !used[*i]) {
            // The reader may have said already why.
            if !told(&[], &at) {
                out.notes.push(Note { at, reason: "this was not understood".into() });
            }
            continue;
        }
        let first = out.notes.len();
        for &i in own.iter().filter(|i| !used[**i]) {
            let at = tokens[i].at.clone();
            let reason = match tokens[i].kind {
                WordKind::Number(_) => "no statement uses this number",
                _ if turns(tokens, i) => "this changes the meaning of the request, but no statement can express it",
                _ => continue,
            };
            if !told(&out.notes[first..], &at) {
                out.notes.push(Note { at, reason: reason.into() });
            }
        }
        for run in runs(&own, used, clause.clone()) {
            let untold = |i: &&usize| !told(&out.notes[first..], &tokens[**i].at);
            let left: Vec<usize> = run.iter().filter(untold).copied().collect();
            let (Some(from), Some(to)) = (left.first(), left.last()) else { continue };
            let at = tokens[*from].at.start..tokens[*to].at.end;
            let reason = match left.len() {
                _ if left.iter().all(|i| is_purpose(tokens, *i)) => PURPOSE,
                1 => BECAME_NOTHING,
                _ => BECAME_NOTHING_MANY,
            };
            out.notes.push(Note { at, reason: reason.into() });
        }
    }
    out
}

/// "For customers", "for the children", "for reading": a purpose, of which nothing in the room follows.
fn is_purpose(tokens: &[Token], i: usize) -> bool {
    const BEFORE: [&str; 15] = [
        "the", "my", "our", "your", "their", "his", "her", "a", "an", "some", "all", "young", "elderly", "busy",
        "growing",
    ];
    let lexicon = get();
    let word = &tokens[i];
    let abstracts = lexicon.is(&word.text, Class::Abstract) || lexicon.is(&word.text, Class::Person);
    let one = ["her", "him", "them", "us", "me", "myself", "everyone"].iter().any(|who| word.is(who));
    if !word.word() || !(abstracts || one || word.text.ends_with("ing")) {
        return false;
    }
    // "For a young family".
    let precedes = |t: &&Token| BEFORE.iter().any(|word| t.is(word)) || lexicon.is_look(&t.text);
    let mut before = tokens[..i].iter().rev().skip_while(precedes);
    before.next().is_some_and(|t| t.is("for"))
}

/// Words that became nothing, as far as no used word stands between them.
fn runs(own: &[usize], used: &[bool], clause: Range<usize>) -> Vec<Vec<usize>> {
    let mut out = vec![Vec::new()];
    for i in clause {
        if used[i] {
            out.push(Vec::new());
        } else if own.contains(&i) {
            out.last_mut().expect("there is a first run").push(i);
        }
    }
    out
}

/// Clauses: what stands between signs, as far as it carries something; indices of tokens.
fn clauses(tokens: &[Token]) -> Vec<Range<usize>> {
    let mut out = Vec::new();
    let mut from = 0;
    for i in 0..=tokens.len() {
        let ends = tokens.get(i).is_none_or(|t| {
            matches!(
                t.kind,
                WordKind::Line
                    | WordKind::Bullet
                    | WordKind::Sign('.' | ',' | ';' | ':' | '!' | '?' | '(' | ')' | '—' | '。' | '，')
            )
        });
        if ends {
            if tokens[from..i].iter().any(carries) {
                out.push(from..i);
            }
            from = i + 1;
        }
    }
    out
}

/// Whether a word carries something of its own.
fn carries(token: &Token) -> bool {
    let lexicon = get();
    match token.kind {
        WordKind::Word => !lexicon.is(&token.text, Class::Stop) && !lexicon.is(&token.text, Class::Soft),
        WordKind::Number(_) => true,
        _ => false,
    }
}

/// Whether a word says something here.
fn says_something(tokens: &[Token], i: usize, grammar: &[bool]) -> bool {
    turns(tokens, i) || carries(&tokens[i]) && !grammar[i]
}

/// Whether a word turns what is said into something else: a negation, a comparison, an exception.
pub(super) fn turns(tokens: &[Token], i: usize) -> bool {
    let text = tokens[i].text.as_str();
    let next = |n: usize| tokens.get(i + n).map_or("", |t| t.text.as_str());
    match text {
        "except" | "excepting" | "neither" | "nor" | "never" | "without" | "not" => true,
        "instead" | "either" => true,
        "only" => i == 0 || !matches!(tokens[i - 1].text.as_str(), "not" | "the"),
        "rather" => next(1) == "than",
        _ => {
            let compares = text.ends_with("er") || matches!(text, "more" | "less" | "fewer");
            compares && tokens[i].word() && next(1) == "than"
        }
    }
}
