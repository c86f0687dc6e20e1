//! Tokens → chunks: noun phrases, relations, verbs, measures, and the little words between them.

use super::lexicon::{Class, LookWord, Verb, get, relation_called};
use super::measure::{Measure, measure};
use super::noun::{NounKind, Np, bounded, noun_phrase};
use super::phrases::Phrases;
use super::token::{Token, WordKind};
use crate::brief::{Dim, Pattern, Rel};
use crate::draft;
use std::ops::Range;
use std::sync::OnceLock;

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum ChunkPiece {
    /// A noun phrase.
    Np(Box<Np>),
    /// Looks without a noun: "white", "of galvanised steel".
    Attr(draft::Look),
    /// What stands between two things.
    Rel(Rel),
    /// "to its left": a relation to what was spoken of last.
    ToIts(Rel),
    Verb(Verb),
    /// A length, a size, an area.
    Measure(Measure),
    /// "with".
    With,
    /// "and", "or", "as well as".
    And,
    /// A comma, a dash.
    Comma,
    Colon,
    /// "(".
    Open,
    /// ")".
    Close,
    /// "not", "never".
    Not,
    /// "ideally", "if possible".
    Soft,
    /// "clear", "free": of space.
    Free,
    /// "apart".
    Apart,
    /// "side by side", "in a row", "back to back".
    Pattern(Pattern),
    /// "which", "that", "where".
    Which,
    /// "there is".
    There,
    /// The end of a sentence.
    Stop,
    /// The end of a line.
    Line,
    /// The start of an item of a list.
    Bullet,
    /// A word that is none of these; whether it carries something of its own.
    Word(bool),
}

/// A piece and the tokens it is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Chunk {
    pub piece: ChunkPiece,
    /// Indices of tokens.
    pub at: Range<usize>,
}

impl Chunk {
    /// The noun phrase, if it is one.
    pub fn np(&self) -> Option<&Np> {
        match &self.piece {
            ChunkPiece::Np(np) => Some(np),
            _ => None,
        }
    }
}

fn fixed_phrases() -> &'static Phrases<ChunkPiece> {
    static PHRASES: OnceLock<Phrases<ChunkPiece>> = OnceLock::new();
    let piece = |key: &str| {
        Some(match key {
            "sideBySide" => ChunkPiece::Pattern(Pattern::SideBySide),
            "row" => ChunkPiece::Pattern(Pattern::Row),
            "rows" => ChunkPiece::Pattern(Pattern::Rows(Some(usize::MAX))),
            "circle" => ChunkPiece::Pattern(Pattern::Circle),
            "arc" => ChunkPiece::Pattern(Pattern::Arc),
            "backToBack" => ChunkPiece::Pattern(Pattern::BackToBack),
            "faceToFace" => ChunkPiece::Pattern(Pattern::FaceToFace),
            "leftToRight" => ChunkPiece::Pattern(Pattern::LeftToRight),
            "stacked" => ChunkPiece::Pattern(Pattern::Stacked),
            "opens" => ChunkPiece::Pattern(Pattern::Opens),
            "and" => ChunkPiece::And,
            "with" => ChunkPiece::With,
            "soft" => ChunkPiece::Soft,
            "there" => ChunkPiece::There,
            "word" => ChunkPiece::Word(false),
            "be" => ChunkPiece::Verb(Verb::Be),
            "of" => ChunkPiece::Rel(Rel::Of),
            key => ChunkPiece::ToIts(relation_called(key.strip_prefix("its ")?)?),
        })
    };
    PHRASES.get_or_init(|| Phrases::new(include_str!("../../data/phrases.txt"), piece))
}

/// The chunks of a text. Linear: no look ahead is longer than a phrase.
pub fn chunks(tokens: &[Token]) -> Vec<Chunk> {
    let mut out: Vec<Chunk> = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let (piece, used) = piece(tokens, at, &out);
        let used = used.max(1);
        out.push(Chunk { piece, at: at..at + used });
        at += used;
    }
    out
}

fn piece(tokens: &[Token], at: usize, before: &[Chunk]) -> (ChunkPiece, usize) {
    let rest = &tokens[at..];
    let first = &rest[0];
    if let Some(piece) = sign(first) {
        return (piece, 1);
    }
    if let Some((np, used)) = bounded(rest) {
        return (ChunkPiece::Np(Box::new(np)), used);
    }
    if let Some((pattern, used)) = super::opening::by(rest) {
        return (ChunkPiece::Pattern(pattern), used);
    }
    let sized = || measured(rest).or_else(|| fixed(rest));
    if let Some(found) = sized().or_else(|| rows(rest).map(|(rows, used)| (ChunkPiece::Pattern(rows), used))) {
        return found;
    }
    let lexicon = get();
    if let Some(used) = lexicon.soft(rest).filter(|n| *n > 1 || !matches!(first.text.as_str(), "can" | "could")) {
        return (ChunkPiece::Soft, used);
    }
    if let Some(piece) = little(rest) {
        return (piece, 1);
    }
    let (relation, verb) = (lexicon.relation(rest), lexicon.verb(rest));
    let longest = relation.map_or(0, |r| r.1).max(verb.map_or(0, |v| v.1));
    if let Some(found) = noun_here(rest, before, longest) {
        return found;
    }
    match (relation, verb) {
        (Some((r, n)), v) if v.is_none_or(|(_, m)| n >= m) => return (ChunkPiece::Rel(r), n),
        (_, Some((v, n))) => return (ChunkPiece::Verb(v), n),
        _ => {}
    }
    if lexicon.is(&first.text, Class::Not) {
        return (ChunkPiece::Not, 1);
    }
    if let Some((look, used)) = looks(rest) {
        return (ChunkPiece::Attr(look), used);
    }
    (
        ChunkPiece::Word(
            first.word() && !lexicon.is(&first.text, Class::Stop) && !lexicon.is(&first.text, Class::Abstract),
        ),
        1,
    )
}

/// What a sign is; quotation marks are part of what they enclose.
fn sign(first: &Token) -> Option<ChunkPiece> {
    Some(match first.kind {
        WordKind::Line => ChunkPiece::Line,
        WordKind::Bullet => ChunkPiece::Bullet,
        WordKind::Sign('\'' | '"') | WordKind::Word | WordKind::Number(_) => return None,
        WordKind::Sign(c) => match c {
            '.' | '!' | '?' | ';' | '…' => ChunkPiece::Stop,
            ',' | '—' | '-' | '/' | '|' => ChunkPiece::Comma,
            '&' | '+' => ChunkPiece::And,
            ':' => ChunkPiece::Colon,
            '(' | '[' => ChunkPiece::Open,
            ')' | ']' => ChunkPiece::Close,
            _ => ChunkPiece::Word(false),
        },
    })
}

/// A measure, or a noun phrase that begins with one: "a 2 m wide table".
fn measured(rest: &[Token]) -> Option<(ChunkPiece, usize)> {
    let (m, used) = measure(rest)?;
    let noun =
        noun_phrase(rest, false).filter(|(np, n)| *n > used && np.kind == NounKind::Thing && !np.dims.is_empty());
    Some(match noun {
        Some((np, n)) if m.plain() => (ChunkPiece::Np(Box::new(np)), n),
        _ => (ChunkPiece::Measure(m), used),
    })
}

/// The little words that join others.
fn little(rest: &[Token]) -> Option<ChunkPiece> {
    let lexicon = get();
    let next = rest.get(1);
    let first = rest[0].text.as_str();
    match first {
        "with" if lexicon.relation(rest).is_none_or(|(_, n)| n < 2) => Some(ChunkPiece::With),
        "and" | "or" | "plus" | "nor" => Some(ChunkPiece::And),
        "which" | "where" | "while" | "whose" => Some(ChunkPiece::Which),
        "that"
            if next
                .map(std::slice::from_ref)
                .is_some_and(|next| lexicon.verb(next).is_some() || lexicon.relation(next).is_some()) =>
        {
            Some(ChunkPiece::Which)
        }
        _ if let Some(wide) = super::aisles::aisle(first) => Some(ChunkPiece::Pattern(Pattern::Aisle(wide))),
        "apart" if next.is_none_or(|t| !t.is("from")) => Some(ChunkPiece::Apart),
        "unobstructed" | "clear" | "free" | "empty" | "unblocked" | "clearance"
            if next.is_none_or(|t| !t.is("of") || first != "clear") =>
        {
            Some(ChunkPiece::Free)
        }
        _ => None,
    }
}

/// The noun phrase that begins here, unless what begins here is rather a verb or a relation of so many words: not the
/// verb in "standing desk", "hanging plant", "set of shelves", "leaning mirror".
fn noun_here(rest: &[Token], before: &[Chunk], longest: usize) -> Option<(ChunkPiece, usize)> {
    let last = before.last().map(|c| &c.piece);
    let listed = matches!(
        last,
        Some(
            ChunkPiece::Bullet
                | ChunkPiece::With
                | ChunkPiece::Rel(_)
                | ChunkPiece::Colon
                | ChunkPiece::Verb(Verb::Have | Verb::Carry | Verb::Flank)
        )
    );
    // "Eye test cabin: …": what a line or sentence begins with before a colon.
    let begins = matches!(last, None | Some(ChunkPiece::Stop | ChunkPiece::Line));
    let colon = rest.iter().take(5).find(|t| !t.word()).is_some_and(|t| t.is(":"));
    let listed = listed || begins && colon;
    let (np, used) = noun_phrase(rest, listed)?;
    // "picture frames": one noun of the tables, whatever its first word may be besides.
    let known = used > longest && np.known && np.det == super::noun::Det::None;
    let fresh = !matches!(last, Some(ChunkPiece::Np(_)));
    let noun = longest == 0 || known && listed && np.last == used || known && fresh && get().is_look(&rest[0].text);
    noun.then(|| (ChunkPiece::Np(Box::new(np)), used))
}

/// The longest of these that begins here.
pub fn fixed(rest: &[Token]) -> Option<(ChunkPiece, usize)> {
    let best = fixed_phrases().longest(rest)?;
    let next = rest.get(best.1);
    let open = matches!(best.0, ChunkPiece::ToIts(_)) && next.is_some_and(|t| t.is("of"));
    // "underneath the table", "in front the" are relations to what follows; "on top of", "to the left of" too.
    let follows =
        |t: &&Token| get().is(&t.text, Class::Def) || get().is(&t.text, Class::Det) || get().is(&t.text, Class::Each);
    let takes_object =
        matches!(rest[best.1 - 1].text.as_str(), "underneath" | "between" | "top") && next.filter(follows).is_some();
    // "on the left wall", "to the right half"
    let names =
        |t: &&Token| matches!(t.text.as_str(), "wall" | "side" | "half" | "corner" | "hand" | "end" | "edge" | "part");
    let of_side = matches!(rest[best.1 - 1].text.as_str(), "left" | "right") && next.filter(names).is_some();
    if open || takes_object || of_side {
        return None;
    }
    Some((best.0.clone(), best.1))
}

/// "in four rows", "in two facing rows of four".
fn rows(rest: &[Token]) -> Option<(Pattern, usize)> {
    if !["in", "into", "form", "forms", "forming", "make", "as"].iter().any(|w| rest[0].is(w)) {
        return None;
    }
    let (n, used) = super::number::count(&rest[1..])?;
    let word = |i: usize| rest.get(1 + used + i).map_or("", |t| t.text.as_str());
    let skip = usize::from(matches!(
        word(0),
        "facing" | "straight" | "neat" | "parallel" | "even" | "long" | "equal" | "tidy"
    ));
    if !matches!(word(skip), "rows" | "lines" | "columns" | "row" | "ranks") {
        return None;
    }
    let end = 1 + used + skip + 1;
    let of = rest.get(end).filter(|t| t.is("of")).and_then(|_| super::number::count(&rest[end + 1..]));
    let pattern = if n as usize == 1 { Pattern::Row } else { Pattern::Rows(Some((n as usize).min(50))) };
    Some((pattern, end + of.map_or(0, |(_, k)| k + 1)))
}

/// A run of words for looks, with no noun after it.
pub fn looks(rest: &[Token]) -> Option<(draft::Look, usize)> {
    let mut out = draft::Look::default();
    let mut used = 0;
    while let Some((kind, n)) = look_at(&rest[used..]) {
        add_look(&mut out, kind, &rest[used..used + n]);
        used += n;
    }
    (used > 0).then_some((out, used))
}

/// The look that begins here, in as many words as belong together.
pub fn look_at(rest: &[Token]) -> Option<(LookWord, usize)> {
    let lexicon = get();
    let words = rest.iter().take(3).take_while(|t| t.word()).count();
    let joined = |n: usize| rest[..n].iter().map(|t| t.text.as_str()).collect::<Vec<_>>().join(" ");
    let (kind, n) = (1..=words).rev().find_map(|n| lexicon.look(&joined(n)).map(|l| (l, n)))?;
    if kind == LookWord::Shade || lexicon.look(&rest[n - 1].text) == Some(LookWord::Shade) && kind != LookWord::Material
    {
        // "dark blue"; "deep" alone is a feature.
        return match look_at(&rest[n..]) {
            Some((LookWord::Color, more)) => Some((LookWord::Color, n + more)),
            // "light beech", "dark granite"
            Some((LookWord::Material, more)) if matches!(rest[0].text.as_str(), "dark" | "pale" | "light") => {
                Some((LookWord::Material, n + more))
            }
            _ if matches!(rest[0].text.as_str(), "dark" | "pale" | "bright" | "light") => Some((LookWord::Color, n)),
            // "A steel table".
            _ if n == 1 && matches!(rest[0].text.as_str(), "steel" | "brick" | "slate") => {
                Some((LookWord::Material, n))
            }
            _ => Some((if kind == LookWord::Shade { LookWord::Feature } else { kind }, n)),
        };
    }
    // "moss green", "olive green": a material or colour word before a colour belongs to it.
    let noun_next = rest.get(n).is_some_and(|t| lexicon.noun(&t.text).is_some());
    if kind == LookWord::Color
        && n == 1
        && !noun_next
        && let Some((LookWord::Color, more)) = rest.get(n).and_then(|_| look_at(&rest[n..]))
        && rest[0].text != "white"
        && rest[0].text != "black"
    {
        return Some((LookWord::Color, n + more));
    }
    Some((kind, n))
}

/// Adds words to a look.
pub fn add_look(look: &mut draft::Look, kind: LookWord, tokens: &[Token]) {
    let text = tokens.iter().map(|t| t.text.as_str()).collect::<Vec<_>>().join(" ");
    let join = |old: &mut Option<String>| match old {
        Some(old) if !old.contains(&text) => {
            old.push(' ');
            old.push_str(&text);
        }
        Some(_) => {}
        None => *old = Some(text.clone()),
    };
    match kind {
        // A second colour is of a part: kept among the features.
        LookWord::Color if look.color.is_some() => look.features.push(text),
        LookWord::Color => look.color = Some(text),
        LookWord::Material => join(&mut look.material),
        LookWord::Feature | LookWord::Shade => look.features.push(text),
    }
}

/// Dimensions that a thing was given.
pub type Dims = Vec<(Dim, f64)>;
