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

mod above;
mod account;
mod activities;
mod aisles;
mod among;
mod amounts;
mod annexes;
mod areas;
mod asides;
mod beyond;
mod buildings;
mod chatter;
mod chunk;
mod clause;
mod compass;
mod compounds;
mod contents;
mod converted;
mod counts;
mod denied;
mod desks;
mod doors;
mod each_with;
mod enclosures;
mod finishes;
mod free_floor;
mod fronted;
mod goods;
mod homes;
pub(crate) mod lexicon;
mod lines;
mod loose;
mod meant;
mod measure;
mod named;
mod noun;
mod number;
mod numbered;
mod open_plan;
mod opening;
mod owner;
mod palette;
mod paraphrase;
mod paths;
mod people;
mod phrases;
mod quantified;
mod reasons;
mod resumed;
mod room_sizes;
mod rooms;
mod seated;
mod senses;
pub(crate) mod several;
mod shares;
mod shorthand;
mod sight;
mod slips;
mod spelling;
mod style;
mod suites;
mod taken_back;
mod talk;
mod token;
mod totals;
mod trades;
mod unknown;
mod unwrapped;
mod walkways;
mod ways;
mod wheeled;
mod whereabouts;
mod which;
mod work;
mod zones;

use crate::brief::{Brief, MOST_GUIDED, Room, Word};
use crate::complete::{Extent, complete};
use crate::compose::compose;
use crate::draft::{Draft, DraftRoom, Note};
use crate::furnish::{furnish, has_place_for_first};
use crate::reconcile::{reconcile, reconcile_quickly};
use account::Account;
pub use account::{BECAME_NOTHING, PURPOSE};
use chunk::ChunkPiece;
use std::ops::Range;
use token::Token;

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
    /// How many clauses there are of which every word that says something became part of the program.
    pub understood: usize,
    /// How many clauses the request has.
    pub clauses: usize,
    /// The clauses, and whether each was understood.
    pub read: Vec<(Range<usize>, bool)>,
    /// What the request rules out, with its words.
    pub absent: Vec<(String, Range<usize>)>,
    /// The words that say something, and whether each became part of the program.
    pub words: Vec<Word>,
    /// Whether nothing came of the request at all.
    pub nothing: bool,
    /// What was furnished, if anything was.
    pub(crate) furnished: Option<Box<Brief>>,
}

impl Reading {
    /// The same with more floor in rooms whose size nobody gave, for requests of which no layout is found with all furniture:
    /// the first time rooms are as large as such rooms usually are, then larger and larger. `None`: every room has its size,
    /// or nothing was added.
    pub fn roomier(&self, times: usize) -> Option<Self> {
        let brief = self.furnished.as_ref()?;
        let is_free = |room: &DraftRoom| !room.sized && room.outline.is_none();
        self.draft.rooms.iter().any(is_free).then(|| furnished(Brief::clone(brief), times))
    }

    /// The words that say something, of which nothing came and no note speaks: lost without a word.
    pub fn silent(&self) -> Vec<Range<usize>> {
        let told = |at: &Range<usize>| self.draft.notes.iter().any(|n| n.at.start <= at.start && at.end <= n.at.end);
        self.words.iter().filter(|word| !word.used && !told(&word.at)).map(|word| word.at.clone()).collect()
    }
}

/// More words than this are not read: the rest is one note.
const MOST_WORDS: usize = 12_000;

/// Reads a request as a brief. Any text will do; of one that is no English nothing comes but notes.
pub fn brief(request: &str) -> Brief {
    let (mut tokens, end) = token::tokens(request, MOST_WORDS);
    slips::correct(&mut tokens);
    chatter::courtesy(&mut tokens);
    counts::none(&mut tokens);
    open_plan::joined(&mut tokens);
    ways::plain(&mut tokens);
    let places = numbered::plain(&mut tokens);
    let styles = style::lift(&mut tokens);
    finishes::plain(&mut tokens);
    talk::asking(&mut tokens);
    buildings::plain(&mut tokens);
    converted::plain(&mut tokens);
    suites::plain(&mut tokens);
    let total = totals::plain(&mut tokens);
    room_sizes::plain(&mut tokens);
    enclosures::plain(&mut tokens);
    work::cells(&mut tokens);
    named::titled(&mut tokens);
    named::whole(&mut tokens);
    let mut answers = talk::turns(&mut tokens);
    answers.extend(chatter::beside_the_point(&mut tokens));
    answers.extend(trades::lift(&mut tokens));
    answers.extend(reasons::lift(&mut tokens));
    owner::places(&mut tokens);
    owner::rooms(&mut tokens);
    paraphrase::plain(&mut tokens);
    let unwanted = palette::unwanted(&mut tokens);
    let colors = palette::lift(&mut tokens);
    open_plan::plain(&mut tokens);
    zones::plain(&mut tokens);
    let mut brief = Brief { rooms: vec![Room { name: "room".into(), ..Room::default() }], ..Brief::default() };
    let mut used = vec![false; tokens.len()];
    let mut grammar = vec![false; tokens.len()];
    if english(&tokens) {
        let mut chunks = chunk::chunks(&tokens);
        let found = rooms::find(&mut chunks, &tokens);
        let mut reader = clause::Reader::new(&tokens, &chunks, &found);
        reader.read();
        (brief, used) = (reader.brief, reader.used);
        for said in several::connect(&mut brief, &chunks, &tokens, &found) {
            used[said].fill(true);
        }
        for chunk in chunks
            .iter()
            .filter(|chunk| matches!(chunk.piece, ChunkPiece::Verb(_) | ChunkPiece::Soft | ChunkPiece::There))
        {
            grammar[chunk.at.clone()].fill(true);
        }
        if !reader.gone.is_empty() {
            brief.remove(&reader.gone);
        }
        used[people::count(&mut brief.rooms, &tokens)].fill(true);
        if let Some(colors) = colors {
            palette::say(&mut brief.rooms, colors);
        }
        brief.absent.extend(unwanted);
        style::say(&mut brief.rooms, &styles, request);
        for said in homes::children(&tokens) {
            used[said] = true;
        }
        for said in people::each(&mut brief, &tokens) {
            used[said] = true;
        }
        for said in paths::say(&mut brief, &tokens, &chunks) {
            used[said] = true;
        }
        free_floor::keep_free(&mut brief);
        seated::at_tables(&mut brief);
        if let Some(whole) = found.whole {
            // "a flat with two bedrooms for a family of four": not so many in one bedroom.
            let people = brief.rooms.iter_mut().find_map(|room| room.people.take());
            brief.rooms[whole].people = people;
        }
        brief.request = request.to_owned();
        several::expand(&mut brief, &found.several);
        let fewer = rooms::fewer(&chunks, &tokens, &brief.rooms);
        brief.notes.extend(fewer.into_iter().map(|(at, reason)| Note { at, reason }));
    } else {
        people::count(&mut brief.rooms, &tokens);
    }
    let Account { clauses, words, mut notes } = account::account(&tokens, &used, &grammar, &brief.notes);
    if end < request.len() {
        notes.push(Note {
            at: end..request.len(),
            reason: "the request is too long, and this part was not read".into(),
        });
    }
    notes.extend(answers);
    notes.extend(total.map(|(at, reason)| Note { at, reason }));
    notes.extend(places.into_iter().map(|(at, reason)| Note { at, reason }));
    notes.extend(counts::odd(&tokens).into_iter().map(|(at, reason)| Note { at, reason }));
    brief.notes.splice(0..0, notes);
    brief.request = request.to_owned();
    (brief.clauses, brief.words) = (clauses, words);
    brief
}

/// Reads a request as a draft.
pub fn read(request: &str, options: &Options) -> Reading {
    of_brief(brief(request), options)
}

/// A request as a draft that says what it says and nothing else, whether or not that can hold together.
pub fn as_said(request: &str) -> Draft {
    compose(&complete(brief(request), Extent::Literal))
}

/// A brief as a draft.
pub fn of_brief(mut brief: Brief, options: &Options) -> Reading {
    brief.bound();
    let nothing = brief.words.iter().all(|word| !word.used) && brief.things.is_empty();
    if !nothing && !options.literal {
        return furnished(brief, 0);
    }
    let unknown = unknown::notes(&brief);
    let brief = complete(brief, Extent::Literal);
    let mut draft = compose(&brief);
    crate::furnish::style(&mut draft, &brief);
    crate::furnish::paint(&mut draft, &brief);
    draft.notes.splice(0..0, brief.notes.iter().cloned().chain(unknown));
    let people = brief.rooms.iter().find_map(|room| room.people);
    if let Some(people) = people.filter(|_| brief.things.iter().all(|thing| thing.places.is_none())) {
        let reason = format!("for {people} people: no statement can express this without added objects");
        draft.notes.push(Note { at: people::phrase(&brief.request), reason });
    }
    Reading { nothing, ..reading(draft, brief) }
}

/// A brief as a draft with furniture, in rooms that are `roomier`.
fn furnished(said: Brief, roomier: usize) -> Reading {
    let brief = complete(said.clone(), Extent::Usual);
    // "For my twin girls": whom a room is for is no thing in it.
    let is_in = |brief: &Brief, note: &Note| brief.things.iter().any(|thing| thing.source.at() == note.at);
    let mut unknown = unknown::notes(&said);
    unknown.retain(|note| !is_in(&said, note) || is_in(&brief, note));
    let mut draft = with_room_for_all(&brief, roomier);
    draft.notes.splice(0..0, brief.notes.iter().cloned().chain(unknown));
    draft.guided = draft.things.iter().map(|thing| thing.count).sum::<usize>() <= MOST_GUIDED;
    if !draft.guided {
        let reason =
            format!("the program does not import the guidelines, because it has more than {MOST_GUIDED} objects");
        draft.notes.push(Note { at: 0..0, reason });
    }
    Reading { furnished: Some(Box::new(said)), ..reading(draft, brief) }
}

/// A draft that contradicts itself nowhere, with what became of the words of its brief.
fn reading(mut draft: Draft, brief: Brief) -> Reading {
    reconcile(&mut draft);
    draft.notes.sort_by_key(|n| (n.at.start, n.at.end));
    draft.notes.dedup();
    let clauses: Vec<_> = brief.clauses.into_iter().map(|clause| (clause.at, clause.understood)).collect();
    Reading {
        draft,
        understood: clauses.iter().filter(|clause| clause.1).count(),
        clauses: clauses.len(),
        read: clauses,
        absent: brief.absent,
        words: brief.words,
        nothing: false,
        furnished: None,
    }
}

/// A furnished draft. Of several rooms each has the place that what matters most in it needs: a bedroom grows that has no room for
/// its bed beside its doors.
fn with_room_for_all(brief: &Brief, roomier: usize) -> Draft {
    const GROWN: usize = 3;
    const GROWTH: f64 = 1.12;
    let mut brief = brief.clone();
    // One room that nothing makes smaller has more floor already.
    let times = if brief.rooms.len() == 1 { roomier.saturating_sub(1) } else { roomier };
    for [w, _, d] in brief.rooms.iter_mut().filter_map(|room| room.usual.as_mut()) {
        (*w, *d) = (*w * GROWTH.powi(times as i32), *d * GROWTH.powi(times as i32));
    }
    let furnished = |brief: &Brief| {
        let mut draft = Draft { roomier, ..compose(brief) };
        // What was added contradicts nothing, either, so the close look comes after it.
        reconcile_quickly(&mut draft);
        furnish(&mut draft, brief);
        draft
    };
    let narrow = |draft: &Draft| -> Vec<usize> {
        let free = |at: &usize| !draft.rooms[*at].sized && draft.rooms.len() > 1;
        (0..draft.rooms.len()).filter(free).filter(|at| !has_place_for_first(draft, *at)).collect()
    };
    let mut draft = furnished(&brief);
    let mut rooms = narrow(&draft);
    let mut larger = brief.clone();
    for _ in 0..GROWN {
        if rooms.is_empty() {
            break;
        }
        for at in &rooms {
            if let Some([w, _, d]) = &mut larger.rooms[*at].usual {
                (*w, *d) = (*w * GROWTH, *d * GROWTH);
            }
        }
        let next = furnished(&larger);
        let left = narrow(&next);
        if left.len() < rooms.len() {
            (draft, rooms) = (next, left);
        }
    }
    draft
}

/// Whether enough words are English of the kind that the reader knows.
fn english(tokens: &[Token]) -> bool {
    let words: Vec<&Token> = tokens.iter().filter(|t| t.word()).collect();
    let known = words.iter().filter(|t| lexicon::get().known(&t.text)).count();
    known * 10 >= words.len() * 3
}
