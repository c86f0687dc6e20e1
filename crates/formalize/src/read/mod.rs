//! The English reader: a request in plain words, with no model and no network.
//!
//! ```text
//! text ──token──▶ words ──chunk──▶ noun phrases, relations, measures ──clause──▶ Brief
//!                            lexicon, number, measure, noun, rooms
//! ```
//!
//! What it knows stands in small tables (`data/`): nouns by how things are in rooms, looks, relations, verbs, rooms and
//! what they have. Its grammar is one of heads: a noun phrase it does not know is a thing all the same, and every word
//! of which nothing came is in the notes. It takes time in proportion to the text.

mod chunk;
mod clause;
mod counts;
pub(crate) mod lexicon;
mod measure;
mod noun;
mod number;
mod people;
mod rooms;
mod token;

use crate::brief::{Brief, Room};
use crate::complete::{Extent, complete};
use crate::compose::compose;
use crate::draft::{Draft, Note};
use crate::furnish::furnish;
use crate::mend::mend;
use lexicon::Class;
use std::ops::Range;
use token::{Kind, Token};

/// How to read.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Add nothing that the request does not say: no furniture that such rooms have, no doors.
    pub literal: bool,
}

/// What a request says.
#[derive(Clone, Debug)]
pub struct Reading {
    /// It, as a value.
    pub draft: Draft,
    /// How many clauses something came of.
    pub understood: usize,
    /// How many clauses the request has.
    pub clauses: usize,
    /// The clauses, and whether something came of each.
    pub read: Vec<(Range<usize>, bool)>,
    /// What the request rules out, with its words.
    pub absent: Vec<(String, Range<usize>)>,
}

/// What was read.
#[derive(Clone, Debug)]
pub struct Read {
    /// What the request asks for.
    pub brief: Brief,
    /// The clauses, and whether something came of each.
    pub clauses: Vec<(Range<usize>, bool)>,
}

/// More words than this are not read: the rest is one note.
const MOST_WORDS: usize = 12_000;

/// Reads a request as a brief. Any text will do; of one that is no English nothing comes but notes.
pub fn brief(request: &str) -> Read {
    let (mut tokens, end) = token::tokens(request, MOST_WORDS);
    counts::none(&mut tokens);
    let clauses = clauses(&tokens);
    let mut brief = Brief { rooms: vec![Room { name: "room".into(), ..Room::default() }], ..Brief::default() };
    let mut used = vec![false; tokens.len()];
    if english(&tokens) {
        let mut chunks = chunk::chunks(&tokens);
        let found = rooms::find(&mut chunks, &tokens);
        let mut reader = clause::Reader::new(&tokens, &chunks, &found);
        reader.read();
        (brief, used) = (reader.brief, reader.used);
        if !reader.gone.is_empty() {
            brief.remove(&reader.gone);
        }
    }
    people::count(&mut brief.rooms, &tokens);
    let mut notes = Vec::new();
    let clauses = judge(&tokens, &used, &clauses, &mut notes);
    if end < request.len() {
        notes.push(Note { at: end..request.len(), reason: "the request is longer than what is read".into() });
    }
    notes.extend(counts::odd(&tokens).into_iter().map(|(at, reason)| Note { at, reason }));
    brief.notes.splice(0..0, notes);
    brief.request = request.to_owned();
    Read { brief, clauses }
}

/// Reads a request as a draft.
pub fn read(request: &str, options: &Options) -> Reading {
    let Read { brief, clauses } = brief(request);
    let understood = clauses.iter().filter(|c| c.1).count();
    let extent = if understood > 0 && !options.literal { Extent::Usual } else { Extent::Literal };
    let brief = complete(brief, extent);
    let mut draft = compose(&brief);
    draft.notes.splice(0..0, brief.notes.iter().cloned());
    mend(&mut draft);
    if extent == Extent::Usual {
        furnish(&mut draft, &brief);
        // What was added contradicts nothing, either.
        mend(&mut draft);
    }
    draft.notes.sort_by_key(|n| (n.at.start, n.at.end));
    draft.notes.dedup();
    Reading { draft, understood, clauses: clauses.len(), read: clauses, absent: brief.absent }
}

/// Whether enough words are English of the kind that the reader knows.
fn english(tokens: &[Token]) -> bool {
    let words: Vec<&Token> = tokens.iter().filter(|t| t.word()).collect();
    let known = words.iter().filter(|t| lexicon::get().known(&t.text)).count();
    known * 10 >= words.len() * 3
}

/// Clauses: what stands between signs, as far as it carries something; indices of tokens.
fn clauses(tokens: &[Token]) -> Vec<Range<usize>> {
    let mut out = Vec::new();
    let mut from = 0;
    for i in 0..=tokens.len() {
        let ends = tokens.get(i).is_none_or(|t| {
            matches!(
                t.kind,
                Kind::Line
                    | Kind::Bullet
                    | Kind::Sign('.' | ',' | ';' | ':' | '!' | '?' | '(' | ')' | '—' | '。' | '，')
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
    let lexicon = lexicon::get();
    match token.kind {
        Kind::Word => !lexicon.is(&token.text, Class::Stop) && !lexicon.is(&token.text, Class::Soft),
        Kind::Number(_) => true,
        _ => false,
    }
}

/// Which clauses something came of; the others, and longer stretches of words nothing came of, become notes.
fn judge(
    tokens: &[Token],
    used: &[bool],
    clauses: &[Range<usize>],
    notes: &mut Vec<Note>,
) -> Vec<(Range<usize>, bool)> {
    let bytes = |r: &Range<usize>| tokens[r.start].at.start..tokens[r.end - 1].at.end;
    let mut out = Vec::new();
    for clause in clauses {
        let own: Vec<usize> = clause.clone().filter(|i| carries(&tokens[*i])).collect();
        let known = own.iter().filter(|i| used[**i]).count();
        let understood = known > 0;
        out.push((bytes(clause), understood));
        if !understood {
            notes.push(Note { at: bytes(clause), reason: "nothing was understood here".into() });
            continue;
        }
        // Stretches that carry much and gave nothing.
        let mut run: Vec<usize> = Vec::new();
        for i in clause.clone().chain([clause.end]) {
            if i < clause.end && !used[i] {
                if carries(&tokens[i]) {
                    run.push(i);
                }
            } else {
                if let (true, [first, .., last]) = (run.len() >= 3, run.as_slice()) {
                    notes.push(Note {
                        at: tokens[*first].at.start..tokens[*last].at.end,
                        reason: "these words became nothing".into(),
                    });
                }
                run.clear();
            }
        }
    }
    out
}
