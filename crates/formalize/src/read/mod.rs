//! The English reader: a request in plain words, with no model and no network.
//!
//! ```text
//! text ──token──▶ words ──chunk──▶ noun phrases, relations, measures ──clause──▶ Scene ──state──▶ Draft ──mend──▶ Draft
//!                            lexicon, number, measure, noun, rooms          sizes, defaults, usual
//! ```
//!
//! What it knows stands in small tables (`data/`): nouns by how things are in rooms, looks, relations, verbs, rooms and
//! what they have. Its grammar is one of heads: a noun phrase it does not know is a thing all the same, and every word
//! of which nothing came is in the notes. It takes time in proportion to the text.

mod chunk;
mod clause;
mod counts;
mod defaults;
mod grid;
mod lexicon;
mod measure;
mod mend;
mod noun;
mod number;
mod rooms;
mod scene;
mod settle;
mod sizes;
mod state;
mod token;
mod usual;

use crate::arrange::arrange_rooms;
use crate::draft::{Draft, Look, Note, Opening, OpeningKind, Room, Source, Surface, Thing};
use crate::names::{Names, identifier};
use lexicon::{Class, Group, Rel};
use scene::{Scene, What};
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

/// More words than this are not read: the rest is one note.
const MOST_WORDS: usize = 12_000;

/// Reads a request. Any text will do; of one that is no English nothing comes but notes.
pub fn read(request: &str, options: &Options) -> Reading {
    let (mut tokens, end) = token::tokens(request, MOST_WORDS);
    counts::none(&mut tokens);
    let clauses = clauses(&tokens);
    let mut scene =
        Scene { rooms: vec![scene::Room { name: "room".into(), ..Default::default() }], ..Default::default() };
    let mut used = vec![false; tokens.len()];
    if english(&tokens) {
        let mut chunks = chunk::chunks(&tokens);
        let found = rooms::find(&mut chunks, &tokens);
        let mut reader = clause::Reader::new(&tokens, &chunks, &found);
        reader.read();
        (scene, used) = (reader.scene, reader.used);
        if !scene.gone.is_empty() {
            scene.forget();
        }
    }
    let mut notes = Vec::new();
    let read = judge(&tokens, &used, &clauses, &mut notes);
    if end < request.len() {
        notes.push(Note { at: end..request.len(), reason: "the request is longer than what is read".into() });
    }
    notes.extend(counts::odd(&tokens).into_iter().map(|(at, reason)| Note { at, reason }));
    defaults::counted(&mut scene, &tokens);
    let understood = read.iter().filter(|r| r.1).count();
    if understood > 0 && !options.literal {
        defaults::add(&mut scene);
        defaults::seats(&mut scene, &tokens);
    } else {
        defaults::joined(&mut scene);
    }
    let mut draft = drafted(request, &scene);
    draft.notes.splice(0..0, notes);
    mend::mend(&mut draft);
    draft.notes.sort_by_key(|n| (n.at.start, n.at.end));
    draft.notes.dedup();
    Reading { draft, understood, clauses: read.len(), read, absent: scene.absent }
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

/// The draft of what was read.
fn drafted(request: &str, scene: &Scene) -> Draft {
    let mut scene = scene.clone();
    settle::settle(&mut scene, request);
    let scene = &scene;
    let mut names = Names::default();
    let sizes = sizes::things(scene);
    let mut room_sizes = sizes::rooms(scene, &sizes);
    let mut draft = Draft { request: request.to_owned(), ..Draft::default() };
    let room_names: Vec<String> = scene.rooms.iter().map(|r| names.take(&identifier(&r.name, "room"))).collect();
    let mut sizes = sizes;
    sizes::fit_walls(scene, &mut sizes, &room_sizes);
    for (i, item) in scene.items.iter().enumerate().filter(|(_, item)| !item.opening() && item.part.is_none()) {
        let Some([w, h, d]) = room_sizes.get(item.room).copied() else { continue };
        let most = [w.max(d) - 0.1, h - 0.02, w.max(d) - 0.1];
        if (0..3).any(|k| sizes[i][k] > most[k]) {
            (0..3).for_each(|k| sizes[i][k] = sizes[i][k].min(most[k].max(0.05)));
            if item.size.iter().any(Option::is_some) {
                draft
                    .notes
                    .push(Note { at: item.at.clone(), reason: "larger than its room: made as large as fits".into() });
            }
        }
    }
    draft.outdoor = scene.rooms.len() == 1
        && ["terrace", "balcony", "patio", "garden", "courtyard", "playground", "yard", "beer garden", "roof terrace"]
            .iter()
            .any(|o| scene.rooms[0].name.ends_with(o));
    let mut counts: Vec<usize> = (0..scene.items.len())
        .map(|i| if scene.items[i].opening() { scene.count(i).min(8) } else { scene.count(i) })
        .collect();
    let mut given: Vec<Vec<String>> = Vec::new();
    for (i, item) in scene.items.iter().enumerate() {
        let name = identifier(&item.name(), "thing");
        given.push(match &item.part {
            Some(part) => {
                sizes[i] = sizes[part.of];
                let of = |n: usize| match given[part.of].as_slice() {
                    _ if item.opening() => given[part.of].get(n).cloned(),
                    [one] if counts[part.of] == 1 => Some(one.clone()),
                    [set] => Some(format!("{set}[{n}]")),
                    _ => None,
                };
                scene.elements(part).into_iter().filter_map(of).collect()
            }
            // Several doors are told apart by numbers.
            None if item.opening() && counts[i] > 1 => {
                (1..=counts[i]).map(|n| names.take(&format!("{name}{n}"))).collect()
            }
            None => vec![names.take(&name)],
        });
    }
    for (count, given) in counts.iter_mut().zip(&given) {
        // At most as many openings as are made.
        if given.len() > 1 {
            *count = given.len();
        }
    }
    for (i, item) in scene.items.iter().enumerate().filter(|(_, item)| item.part.is_none()) {
        let source = item.inferred.clone().map_or(Source::Stated(item.at.clone()), Source::Inferred);
        if item.opening() {
            let mut rooms = vec![item.room];
            rooms.extend(item.beyond);
            let kind = if item.group == Group::Door { OpeningKind::Door } else { OpeningKind::Window };
            for name in &given[i] {
                let mut size = sizes[i];
                let ceiling =
                    rooms.iter().filter_map(|r| room_sizes.get(*r)).map(|r| r[1]).fold(f64::INFINITY, f64::min);
                size[1] = size[1].min(ceiling - 0.1).max(0.3);
                size[2] = size[2].min(0.12);
                draft.openings.push(Opening {
                    name: name.clone(),
                    kind,
                    rooms: rooms.clone(),
                    size,
                    look: item.look.clone(),
                    source: source.clone(),
                });
            }
        } else {
            draft.things.push(Thing {
                name: given[i][0].clone(),
                category: item.of.iter().fold(item.words.join("_"), |name, of| format!("{name} {of}")),
                count: counts[i],
                room: Some(item.room),
                size: Some(sizes[i]),
                look: item.look.clone(),
                source,
            });
        }
    }
    for (i, room) in scene.rooms.iter().enumerate() {
        let source = if room.at.is_empty() {
            Source::Inferred("the things stand in a room".into())
        } else {
            Source::Stated(room.at.clone())
        };
        let sized = room.size[0].is_some() && room.size[2].is_some();
        let [w, _, d] = room_sizes[i];
        let outline = room.corners.map(|n| polygon(n, w, d));
        draft.rooms.push(Room {
            name: room_names[i].clone(),
            kind: room.name.clone(),
            at: [0.0; 2],
            size: room_sizes[i],
            sized,
            outline,
            floor: surface(&room.floor),
            walls: surface(&room.walls),
            source,
        });
    }
    arrange_rooms(&mut draft);
    for (size, room) in room_sizes.iter_mut().zip(&draft.rooms) {
        *size = room.size;
    }
    let named = state::Named { scene, names: given, counts, rooms: room_names, sizes, room_sizes };
    let mut stated = state::state(&named);
    windows(&named, &mut draft, &mut stated);
    draft.statements = stated.statements;
    draft.notes.extend(stated.notes);
    draft.notes.extend(scene.notes.iter().map(|(at, reason)| Note { at: at.clone(), reason: reason.clone() }));
    draft.notes.extend(limited(scene, &draft));
    for (name, at) in &scene.absent {
        if scene.items.iter().any(|i| i.name() == *name) {
            draft.notes.push(Note { at: at.clone(), reason: format!("{name} is asked for elsewhere") });
        }
    }
    draft
}

/// Numbers of things that follow from others, and sizes of rooms, that are not taken as they are.
fn limited(scene: &Scene, draft: &Draft) -> Vec<Note> {
    let mut out = Vec::new();
    for (i, item) in scene.items.iter().enumerate().filter(|(_, item)| item.per.is_some() && item.part.is_none()) {
        let reason = counts::said(scene.stated(i) as f64);
        out.extend(reason.map(|reason| Note { at: item.at.clone(), reason }));
    }
    for (room, made) in scene.rooms.iter().zip(&draft.rooms) {
        for (said, is) in room.size.iter().zip(made.size) {
            let said = said.filter(|said| (said - is).abs() > 0.001);
            let reason = said.map(|said| format!("no room is so large or so small: {said} m is read as {is} m"));
            out.extend(reason.map(|reason| Note { at: room.at.clone(), reason }));
        }
    }
    out
}

/// A window that something stands under begins above it.
fn windows(named: &state::Named, draft: &mut Draft, out: &mut state::Stated) {
    for fact in named.scene.facts.iter().filter(|f| !f.not) {
        let What::Rel(Rel::Under, to) = &fact.what else { continue };
        for w in to.iter().filter(|w| named.scene.items[**w].group == Group::Window) {
            // As high above it as it reaches from the wall: so `below` has it.
            let top = fact.of.iter().map(|a| named.sizes[*a][1] + named.sizes[*a][2] / 2.0).fold(0.0, f64::max);
            let sill = ((top + 0.05) * 20.0).ceil() / 20.0;
            let ceiling = named.room_sizes.get(named.scene.items[*w].room).map_or(2.7, |s| s[1]);
            // Where the window begins if nothing is said.
            if sill <= ((ceiling - named.sizes[*w][1]) / 2.0).min(0.9) {
                continue;
            }
            for name in &named.names[*w] {
                if let Some(o) = draft.openings.iter_mut().find(|o| o.name == *name) {
                    o.size[1] = o.size[1].min(ceiling - sill - 0.1).max(0.3);
                }
                out.infer(
                    format!("assert {name}.bottom = {};", crate::write::number(sill)),
                    "the window begins above what stands under it",
                );
            }
        }
    }
}

fn surface(look: &Look) -> Surface {
    Surface { color: look.color.clone(), material: look.material.clone() }
}

/// An even polygon with a side at the front, within a width and a depth.
fn polygon(corners: usize, w: f64, d: f64) -> Vec<[f64; 2]> {
    let step = std::f64::consts::TAU / corners as f64;
    let reach = (step / 2.0).cos();
    (0..corners)
        .map(|i| {
            let angle = step * (i as f64 + 0.5);
            [angle.sin() * w / 2.0 / reach, angle.cos() * d / 2.0 / reach].map(|v| (v * 1e4).round() / 1e4)
        })
        .collect()
}
