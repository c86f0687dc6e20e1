//! Clauses that no statement says: of some and nobody says of which, of the same length as another thing, of what was said
//! before of something else. They are on the list of what was not used.

use super::*;

/// What can be as large or as far as something else.
const MEASURED: [&str; 20] = [
    "long", "wide", "high", "tall", "deep", "large", "big", "small", "low", "far", "close", "near", "thick", "heavy",
    "short", "broad", "narrow", "many", "much", "great",
];

impl Reader<'_> {
    pub(super) fn word_at(&self, i: usize, n: usize) -> &str {
        self.tokens.get(self.chunks[i].at.start + n).map_or("", |t| t.text.as_str())
    }

    fn ends_at(&self, i: usize, n: usize) -> bool {
        self.tokens.get(self.chunks[i].at.start + n).is_none_or(|t| !t.word())
    }

    /// "Most of the chairs face the door", "at least two of them", "exactly two of the chairs", "some tables are …": nobody
    /// says of which, and of the others it may hold as well or must not.
    pub(super) fn some_unsaid(&self, i: usize, end: usize) -> bool {
        let word = |n: usize| self.word_at(i, n);
        let these = |n: usize| matches!(word(n), "the" | "them" | "these" | "those" | "which");
        let counts = |n: usize| {
            let token = self.tokens.get(self.chunks[i].at.start + n);
            token.is_some_and(|t| crate::read::number::count(std::slice::from_ref(t)).is_some())
        };
        let of = match (word(0), word(1)) {
            ("most" | "some" | "many" | "few" | "several", "of") => 1,
            ("a", "few" | "couple" | "number") => 2,
            ("at", "least" | "most") | ("more" | "fewer" | "less", "than") if counts(2) => 3,
            ("exactly" | "precisely" | "just", _) if counts(1) && self.some_only(i, end).is_none() => 2,
            ("some" | "most" | "many" | "several" | "few", _) => return self.some_known(i, end),
            // "in two of the corners"
            (_, "of") if counts(0) => return these(2) && matches!(word(3), "corners" | "walls"),
            _ => return false,
        };
        word(of) == "of" && these(of + 1) && self.known_several(i, end)
    }

    /// "The desk nearest the door", of several: nobody says which of them that is before the room is laid out.
    pub(super) fn nearest_of(&self, i: usize, end: usize) -> bool {
        let superlative =
            |k: usize| k < end && matches!(self.word_at(k, 0), "nearest" | "closest" | "furthest" | "farthest");
        let one = self.np(i, end).filter(|np| np.kind == NounKind::Thing && np.det == Det::Definite && !np.many);
        superlative(i + 1) && one.is_some_and(|np| self.find(np).is_some_and(|o| self.brief.things[o].number.many()))
    }

    /// Whether what is counted here was spoken of before, so that these are some of them: not "most of the wall".
    fn known_several(&self, i: usize, end: usize) -> bool {
        let many = |o: usize| self.brief.things[o].number.many();
        let phrase =
            (i..end.min(i + 3)).find_map(|k| self.np(k, end).filter(|np| np.kind != NounKind::Place(Place::Wall)));
        match phrase {
            Some(np) if np.kind == NounKind::Thing => self.find(np).is_some_and(many),
            Some(np) => np.kind == NounKind::Pronoun,
            None => false,
        }
    }

    /// "Four tables. Some tables are near the door": not two more.
    fn some_known(&self, i: usize, end: usize) -> bool {
        let begins = i == self.s.chunks.start;
        let Some(np) = self.np(i, end).filter(|np| begins && np.kind == NounKind::Thing && np.many) else {
            return false;
        };
        let said = |o: usize| {
            let thing = &self.brief.things[o];
            thing.words == np.words && (thing.number.said().is_some() || thing.number.follows())
        };
        self.find(np).is_some_and(said)
            && matches!(self.piece(i + 1, end), Some(ChunkPiece::Verb(_) | ChunkPiece::Rel(_)))
    }

    /// "A chair for every desk", of which nobody has spoken: so many as nobody knows.
    pub(super) fn for_unknown(&self, i: usize, end: usize) -> bool {
        let each = |np: &&Np| np.kind == NounKind::Thing && np.det == Det::Each && np.known && np.group.is_some();
        let named = |np: &Np| self.chunks[..i].iter().any(|c| c.np().is_some_and(|other| other.words == np.words));
        let unknown = |np: &Np| self.find(np).is_none() && !named(np);
        self.word_at(i, 0) == "for" && self.np(i + 1, end).filter(each).is_some_and(unknown)
    }

    /// "At the same height as the shelf", "the same distance from the table"; where that begins and ends.
    pub(super) fn same_as(&self, i: usize, end: usize) -> Option<Range<usize>> {
        const ALIKE: [&str; 7] = ["height", "distance", "size", "width", "length", "level", "depth"];
        let same = |t: usize| {
            let next = self.tokens.get(t + 1);
            self.tokens[t].is("same") && next.is_some_and(|t| ALIKE.contains(&t.text.as_str()))
        };
        let relates = i > self.s.chunks.start && matches!(self.chunks[i - 1].piece, ChunkPiece::Rel(_));
        if !self.chunks[i].at.clone().any(same) || !relates {
            return None;
        }
        let object = (i + 1..end).find(|k| self.np(*k, end).is_some_and(|np| np.kind == NounKind::Thing));
        Some(i - 1..object.map_or(end, |k| k + 1))
    }

    /// "So does the armchair", "but the armchair does not", "and the bench is not", "the armchair the fireplace": what was
    /// said before is said of another thing, or denied of it; where that begins.
    pub(super) fn as_before(&self, i: usize, end: usize) -> Option<usize> {
        let word = |n: usize| self.word_at(i, n);
        let verb = |n: usize| matches!(word(n), "does" | "do" | "is" | "are" | "has" | "have" | "did");
        let so = word(0) == "so" && verb(1) && self.np(i + 1, end).or(self.np(i + 2, end)).is_some();
        let short = verb(0) && matches!(word(1), "too" | "not" | "likewise" | "so") && self.ends_at(i, 2);
        let denied = matches!(word(0), "doesn't" | "don't" | "isn't" | "aren't") && self.ends_at(i, 1);
        let starts = i > self.s.chunks.start && matches!(self.chunks[i - 1].piece, ChunkPiece::Comma | ChunkPiece::And);
        (so || short || denied || starts && self.no_verb(i, end)).then_some(i)
    }

    /// "…, the armchair the fireplace": two things with nothing between them, after a clause that said how one stands to
    /// another.
    fn no_verb(&self, i: usize, end: usize) -> bool {
        let definite = |k: usize| self.np(k, end).filter(|np| matches!(np.det, Det::Definite | Det::Own));
        let thing = |k: usize| definite(k).is_some_and(|np| np.kind == NounKind::Thing);
        // "…, the other two a lamp"
        let other = definite(i).is_some_and(|np| np.other);
        let given = other && self.np(i + 1, end).is_some_and(|np| np.kind == NounKind::Thing && np.det != Det::None);
        let ends =
            matches!(self.piece(i + 2, end), None | Some(ChunkPiece::Comma | ChunkPiece::Stop | ChunkPiece::And));
        (thing(i) && thing(i + 1) || given) && ends && i > self.s.chunks.start + 1
    }

    /// "A rug as long as the bed", "twice as high as the desk": the chunk after it. Not "as close as possible".
    pub(super) fn as_much(&self, i: usize, end: usize) -> Option<usize> {
        let word = |n: usize| self.word_at(i, n);
        if word(0) != "as" || !MEASURED.contains(&word(1)) || word(2) != "as" {
            return None;
        }
        let second = self.chunks[i].at.start + 2;
        let k = (i..end).find(|k| self.chunks[*k].at.contains(&second))?;
        let np = (k..end.min(k + 3)).find(|k| self.np(*k, end).is_some_and(|np| np.kind == NounKind::Thing))?;
        Some(np + 1)
    }

    /// "The visitors stand by the window": of people, and of no thing, as long as the clause names none that is new.
    pub(super) fn of_people(&self, i: usize, from: usize, to: usize) -> bool {
        const WHERE: [&str; 20] = [
            "sit", "sits", "stand", "stands", "wait", "waits", "lie", "lies", "walk", "walks", "work", "works", "come",
            "comes", "enter", "enters", "arrive", "arrives", "go", "goes",
        ];
        let begins = i == from || matches!(self.chunks[i - 1].piece, ChunkPiece::And | ChunkPiece::Comma);
        let article = usize::from(matches!(self.word_at(i, 0), "the" | "a" | "an" | "our" | "all"));
        let who =
            |word: &str| get().is(word, Class::Person) || get().is(&scenelang_lang::nouns::plural(word), Class::Person);
        let is_new = |np: &Np| np.kind == NounKind::Thing && !matches!(np.det, Det::Definite | Det::Own);
        begins
            && who(self.word_at(i, article))
            && WHERE.contains(&self.word_at(i, article + 1))
            && !(i..to).any(|k| self.np(k, to).is_some_and(is_new))
    }

    /// "One of the pupils uses a wheelchair": what people come with is no thing of the room.
    pub(super) fn comes_with(&self, i: usize) -> bool {
        const WHEELED: [&str; 5] = ["wheelchair", "walker", "pram", "stroller", "crutches"];
        let of = if matches!(self.word_at(i, 0), "one" | "some") && self.word_at(i, 1) == "of" { 3 } else { 0 };
        let person =
            |word: &str| get().is(word, Class::Person) || get().is(&scenelang_lang::nouns::plural(word), Class::Person);
        let article = of + usize::from(of == 0 && matches!(self.word_at(i, 0), "the" | "a" | "an" | "our" | "my"));
        let uses = matches!(self.word_at(i, article + 1), "uses" | "use" | "has" | "needs");
        let what = article + 2 + usize::from(matches!(self.word_at(i, article + 2), "a" | "an"));
        person(self.word_at(i, article)) && uses && WHEELED.contains(&self.word_at(i, what))
    }

    /// "Please make me a classroom": of what is wanted, not of what makes somebody nervous.
    pub(super) fn asks_for(&self, i: usize) -> bool {
        let me = matches!(self.word_at(i, 1), "me" | "us" | "him" | "her");
        me && matches!(self.word_at(i, 2), "a" | "an" | "another" | "one" | "two" | "three" | "some" | "this" | "the")
    }

    /// "So a robot can pass", "so I can check on them": what something is for.
    pub(super) fn so_that(&self, i: usize) -> bool {
        const HANDLED: [&str; 8] = ["walk", "move", "reach", "open", "see", "watch", "pass", "sit"];
        // "So we can get in with equipment", but "so I can get past".
        const PAST: [&str; 7] = ["past", "through", "around", "by", "between", "to", "up"];
        let that = usize::from(self.word_at(i, 1) == "that");
        let who = self.word_at(i, 1 + that);
        let can = (2..5).find(|n| matches!(self.word_at(i, n + that), "can" | "could" | "may" | "fits" | "passes"));
        let robot = || (2..5).any(|n| matches!(self.word_at(i, n + that), "robot" | "robots"));
        let somebody = matches!(who, "i" | "you" | "we" | "she" | "he" | "they" | "people" | "kids" | "staff");
        let new = |can: usize| match self.word_at(i, can + 1 + that) {
            "get" => !PAST.contains(&self.word_at(i, can + 2 + that)),
            verb => !HANDLED.contains(&verb),
        };
        self.word_at(i, 0) == "so" && can.is_some_and(|can| robot() || somebody && new(can))
    }

    /// "We have to be able to wheel a bed out": what people can do there.
    pub(super) fn able_to(&self, i: usize) -> bool {
        const HANDLED: [&str; 8] = ["walk", "move", "reach", "open", "see", "pass", "get", "sit"];
        let who = matches!(self.word_at(i, 0), "we" | "you" | "they" | "i" | "staff" | "people" | "nurses" | "it");
        let able = (1..6).find(|n| self.word_at(i, *n) == "able" && self.word_at(i, n + 1) == "to");
        who && able.is_some_and(|able| !HANDLED.contains(&self.word_at(i, able + 2)))
    }

    /// "12 cm clearance underneath": a space that no statement speaks of.
    pub(super) fn free_beneath(&self, i: usize) -> bool {
        let space = matches!(self.word_at(i, 0), "clearance" | "space" | "room" | "gap");
        let beneath = matches!(self.word_at(i, 1), "underneath" | "beneath" | "below" | "under");
        let ends = self.ends_at(i, 2) || matches!(self.word_at(i, 2), "it" | "them" | "so" | "for" | "and");
        space && beneath && ends
    }
}
