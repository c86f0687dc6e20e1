//! The grammar in the book, executed: it recognises every program of the book, and every sentence that it makes parses.
//!
//! Its form is that of the W3C: `name ::= …` with `"literal"`, `|`, `?`, `*`, `+` and parentheses. Rules in capitals are
//! tokens; they are made of characters, with `[a-z]` for classes.

use super::{Page, pages};
use crate::blocks::expected;
use rustc_hash::FxHashMap;
use scenelang_base::codes;
use scenelang_lang::parse::{core::check_core, parse_file};
use scenelang_lang::token::{Kind, lex};
use std::collections::BTreeSet;

/// A piece of a rule.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// `"assert"`
    Literal(String),
    /// `[0-9]`: ranges of characters.
    Class(Vec<(char, char)>),
    /// The name of a rule.
    Rule(String),
    /// One after the other.
    Sequence(Vec<Piece>),
    /// One of them.
    Choice(Vec<Piece>),
    /// `x?`
    Optional(Box<Piece>),
    /// `x*`
    Any(Box<Piece>),
    /// `x+`
    Some(Box<Piece>),
}

/// Rules in order.
pub type Rules = Vec<(String, Piece)>;

/// The grammar of a page of the reference.
pub fn of_page(name: &str) -> Rules {
    let pages = pages();
    let page = pages.iter().find(|p| p.path.ends_with(name)).unwrap_or_else(|| panic!("no page {name}"));
    let texts = page.blocks.iter().filter(|b| b.info == "ebnf").map(|b| rules(&b.text));
    texts.flatten().collect()
}

/// Reads rules. A rule begins at the start of a line and goes on in the lines that are indented.
pub fn rules(text: &str) -> Rules {
    let mut joined: Vec<String> = Vec::new();
    for line in text.lines().filter(|l| !l.trim().is_empty()) {
        match joined.last_mut() {
            Some(rule) if line.starts_with(' ') => *rule += line,
            _ => joined.push(line.to_owned()),
        }
    }
    let rule = |line: &String| {
        let (name, body) = line.split_once("::=").unwrap_or_else(|| panic!("no rule: {line}"));
        let chars: Vec<char> = body.chars().collect();
        let mut reader = Reader { chars: &chars, at: 0 };
        let piece = reader.choice();
        reader.blanks();
        assert!(reader.at == chars.len(), "{line}\nwhat is {:?}?", chars[reader.at..].iter().collect::<String>());
        (name.trim().to_owned(), piece)
    };
    joined.iter().map(rule).collect()
}

struct Reader<'c> {
    chars: &'c [char],
    at: usize,
}

impl Reader<'_> {
    fn blanks(&mut self) {
        while self.chars.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
    }
    fn takes(&mut self, c: char) -> bool {
        self.blanks();
        let found = self.chars.get(self.at) == Some(&c);
        self.at += usize::from(found);
        found
    }
    fn until(&mut self, end: char) -> String {
        let rest = &self.chars[self.at..];
        let length = rest.iter().position(|c| *c == end).expect("it closes");
        self.at += length + 1;
        rest[..length].iter().collect()
    }
    fn choice(&mut self) -> Piece {
        let mut all = vec![self.sequence()];
        while self.takes('|') {
            all.push(self.sequence());
        }
        if all.len() == 1 { all.remove(0) } else { Piece::Choice(all) }
    }
    fn sequence(&mut self) -> Piece {
        let mut all = Vec::new();
        loop {
            self.blanks();
            match self.chars.get(self.at) {
                None | Some('|' | ')') => break,
                _ => all.push(self.repeated()),
            }
        }
        if all.len() == 1 { all.remove(0) } else { Piece::Sequence(all) }
    }
    fn repeated(&mut self) -> Piece {
        let mut piece = self.single();
        while let Some(sign) = self.chars.get(self.at) {
            piece = match sign {
                '?' => Piece::Optional(Box::new(piece)),
                '*' => Piece::Any(Box::new(piece)),
                '+' => Piece::Some(Box::new(piece)),
                _ => break,
            };
            self.at += 1;
        }
        piece
    }
    fn single(&mut self) -> Piece {
        let first = self.chars[self.at];
        if first == '"' || first == '\'' {
            self.at += 1;
            return Piece::Literal(self.until(first));
        }
        if self.takes('[') {
            let class: Vec<char> = self.until(']').chars().collect();
            return Piece::Class(class.chunks(3).map(|c| (c[0], c[2])).collect());
        }
        if self.takes('(') {
            let inner = self.choice();
            assert!(self.takes(')'), "a bracket does not close");
            return inner;
        }
        let start = self.at;
        while self.chars.get(self.at).is_some_and(|c| c.is_alphanumeric() || *c == '_' || *c == '-') {
            self.at += 1;
        }
        assert!(self.at > start, "what is {:?}?", self.chars[start..].iter().collect::<String>());
        Piece::Rule(self.chars[start..self.at].iter().collect())
    }
}

/// What a grammar reads: tokens or characters.
trait Input {
    fn length(&self) -> usize;
    /// Ends of a literal that starts at `at`.
    fn literal(&self, at: usize, text: &str) -> Option<usize>;
    /// End of a character of a class, or of a rule that is built in.
    fn class(&self, at: usize, class: &[(char, char)]) -> Option<usize>;
    fn built_in(&self, at: usize, name: &str) -> Option<usize>;
}

/// Where a rule can end: everything that matches, so that the order of alternatives has no say.
struct Recogniser<'r, I> {
    rules: FxHashMap<&'r str, &'r Piece>,
    input: I,
    known: FxHashMap<(&'r str, usize), BTreeSet<usize>>,
}

impl<'r, I: Input> Recogniser<'r, I> {
    fn new(rules: &'r Rules, input: I) -> Self {
        let rules = rules.iter().map(|(name, piece)| (name.as_str(), piece)).collect();
        Self { rules, input, known: FxHashMap::default() }
    }

    fn accepts(&mut self, start: &'r str) -> bool {
        let length = self.input.length();
        self.rule(start, 0).contains(&length)
    }

    fn rule(&mut self, name: &'r str, at: usize) -> BTreeSet<usize> {
        if let Some(known) = self.known.get(&(name, at)) {
            return known.clone();
        }
        let ends = match self.rules.get(name).copied() {
            Some(piece) => self.ends(piece, at),
            None => self.input.built_in(at, name).into_iter().collect(),
        };
        self.known.insert((name, at), ends.clone());
        ends
    }

    fn ends(&mut self, piece: &'r Piece, at: usize) -> BTreeSet<usize> {
        match piece {
            Piece::Literal(text) => self.input.literal(at, text).into_iter().collect(),
            Piece::Class(class) => self.input.class(at, class).into_iter().collect(),
            Piece::Rule(name) => self.rule(name, at),
            Piece::Sequence(all) => {
                let mut ends = BTreeSet::from([at]);
                for piece in all {
                    ends = ends.into_iter().flat_map(|at| self.ends(piece, at)).collect();
                }
                ends
            }
            Piece::Choice(all) => all.iter().flat_map(|piece| self.ends(piece, at)).collect(),
            Piece::Optional(piece) => {
                let mut ends = self.ends(piece, at);
                ends.insert(at);
                ends
            }
            Piece::Any(piece) => {
                let mut ends = self.more(piece, BTreeSet::from([at]));
                ends.insert(at);
                ends
            }
            Piece::Some(piece) => {
                let first = self.ends(piece, at);
                self.more(piece, first)
            }
        }
    }

    fn more(&mut self, piece: &'r Piece, from: BTreeSet<usize>) -> BTreeSet<usize> {
        let (mut all, mut new) = (from.clone(), from);
        while !new.is_empty() {
            let next: BTreeSet<usize> = new.iter().flat_map(|at| self.ends(piece, *at)).collect();
            new = next.difference(&all).copied().collect();
            all.extend(&new);
        }
        all
    }
}

/// Tokens of a program, without blanks and comments.
struct Tokens<'t>(Vec<(Kind, &'t str)>);

impl<'t> Tokens<'t> {
    fn of(text: &'t str) -> Self {
        let tokens = lex(text).into_iter().filter(|t| !t.kind.is_trivia());
        Self(tokens.map(|t| (t.kind, &text[t.range.bytes()])).collect())
    }
}

impl Input for Tokens<'_> {
    fn length(&self) -> usize {
        self.0.len()
    }
    fn literal(&self, at: usize, text: &str) -> Option<usize> {
        self.0.get(at).filter(|(_, t)| *t == text).map(|_| at + 1)
    }
    fn class(&self, _: usize, _: &[(char, char)]) -> Option<usize> {
        None
    }
    fn built_in(&self, at: usize, name: &str) -> Option<usize> {
        let kind = match name {
            "NAME" => Kind::Ident,
            "NUMBER" => Kind::Number,
            "STRING" => Kind::Str,
            other => panic!("the grammar has no rule {other}"),
        };
        self.0.get(at).filter(|(k, _)| *k == kind).map(|_| at + 1)
    }
}

struct Characters(Vec<char>);

impl Input for Characters {
    fn length(&self) -> usize {
        self.0.len()
    }
    fn literal(&self, at: usize, text: &str) -> Option<usize> {
        let end = at + text.chars().count();
        (end <= self.0.len() && self.0[at..end].iter().copied().eq(text.chars())).then_some(end)
    }
    fn class(&self, at: usize, class: &[(char, char)]) -> Option<usize> {
        let c = self.0.get(at)?;
        class.iter().any(|(a, b)| a <= c && c <= b).then_some(at + 1)
    }
    fn built_in(&self, at: usize, name: &str) -> Option<usize> {
        let c = *self.0.get(at)?;
        let fits = match name {
            "XID_Start" => unicode_ident::is_xid_start(c),
            "XID_Continue" => unicode_ident::is_xid_continue(c),
            "CHARACTER" => !matches!(c, '"' | '\\' | '\r' | '\n'),
            other => panic!("the grammar has no rule {other}"),
        };
        fits.then_some(at + 1)
    }
}

/// Makes sentences of a grammar, the same ones every time.
struct Maker<'r> {
    rules: &'r Rules,
    words: &'r Rules,
    depths: FxHashMap<String, usize>,
    state: u64,
}

impl<'r> Maker<'r> {
    fn new(rules: &'r Rules, words: &'r Rules, state: u64) -> Self {
        Self { rules, words, depths: depths(rules), state }
    }

    fn below(&mut self, n: usize) -> usize {
        self.state = self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.state >> 33) % n as u64) as usize
    }

    /// `fuel` bounds the depth: without it the shortest way out is taken.
    fn make(&mut self, piece: &Piece, fuel: usize, out: &mut Vec<String>) {
        match piece {
            Piece::Literal(text) => out.push(text.clone()),
            Piece::Class(class) => {
                let (a, b) = class[self.below(class.len())];
                let c = char::from_u32(a as u32 + self.below((b as u32 - a as u32 + 1) as usize) as u32).unwrap();
                out.push(c.to_string());
            }
            Piece::Rule(name) => self.rule(name, fuel, out),
            Piece::Sequence(all) => all.iter().for_each(|p| self.make(p, fuel, out)),
            Piece::Choice(all) => {
                let depth = |p: &Piece| depth(p, self.rules, &self.depths);
                let least = all.iter().map(depth).min().unwrap();
                let open: Vec<&Piece> = all.iter().filter(|p| fuel > 0 || depth(p) == least).collect();
                let chosen = open[self.below(open.len())].clone();
                self.make(&chosen, fuel, out);
            }
            Piece::Optional(p) | Piece::Any(p) => {
                let most = if matches!(piece, Piece::Any(_)) { 3 } else { 2 };
                let times = if fuel == 0 { 0 } else { self.below(most) };
                (0..times).for_each(|_| self.make(p, fuel, out));
            }
            Piece::Some(p) => {
                let times = 1 + if fuel == 0 { 0 } else { self.below(3) };
                (0..times).for_each(|_| self.make(p, fuel, out));
            }
        }
    }

    fn rule(&mut self, name: &str, fuel: usize, out: &mut Vec<String>) {
        const NAMES: [&str; 6] = ["lamp", "a", "stuhl_2", "größe", "_x", "vase"];
        match name {
            "NAME" => out.push(NAMES[self.below(NAMES.len())].to_owned()),
            token if self.is_outside(token) && self.words.iter().any(|(n, _)| n == token) => {
                let piece = self.words.iter().find(|(n, _)| n == token).expect("just found").1.clone();
                let mut characters = Vec::new();
                let mut maker = Maker::new(self.words, self.words, self.state);
                maker.make(&piece, 4, &mut characters);
                self.state = maker.state;
                out.push(characters.concat());
            }
            "CHARACTER" => out.push(["a", "é", " ", "7", ";", "'"][self.below(6)].to_owned()),
            "XID_Start" => out.push(["a", "Z", "日"][self.below(3)].to_owned()),
            "XID_Continue" => out.push(["a", "_", "7", "本"][self.below(4)].to_owned()),
            _ => {
                let found = self.rules.iter().find(|(n, _)| n == name);
                let piece = found.unwrap_or_else(|| panic!("the grammar has no rule {name}")).1.clone();
                self.make(&piece, fuel.saturating_sub(1), out);
            }
        }
    }

    /// Whether a rule belongs to the tokens, and a token is wanted.
    fn is_outside(&self, name: &str) -> bool {
        self.rules.iter().all(|(n, _)| n != name)
    }
}

/// How many rules deep the shortest sentence of each rule is.
fn depths(rules: &Rules) -> FxHashMap<String, usize> {
    let mut known = FxHashMap::default();
    for _ in 0..rules.len() {
        for (name, piece) in rules {
            let depth = 1 + depth(piece, rules, &known);
            known.insert(name.clone(), depth);
        }
    }
    known
}

fn depth(piece: &Piece, rules: &Rules, known: &FxHashMap<String, usize>) -> usize {
    const UNKNOWN: usize = 1000;
    match piece {
        Piece::Literal(_) | Piece::Class(_) | Piece::Optional(_) | Piece::Any(_) => 0,
        Piece::Rule(name) if rules.iter().all(|(n, _)| n != name) => 0,
        Piece::Rule(name) => known.get(name).copied().unwrap_or(UNKNOWN),
        Piece::Sequence(all) => all.iter().map(|p| depth(p, rules, known)).max().unwrap_or(0),
        Piece::Choice(all) => all.iter().map(|p| depth(p, rules, known)).min().unwrap_or(0),
        Piece::Some(p) => depth(p, rules, known),
    }
}

/// Whether what the block says of itself is that its text does not parse.
fn is_broken(text: &str) -> bool {
    expected(text).iter().any(|(_, code, _)| code.starts_with("E01"))
}

#[test]
fn the_grammar_recognises_the_programs_of_the_book() {
    let rules = of_page("grammar.md");
    let mut wrong = String::new();
    let mut programs = 0;
    for Page { path, blocks, .. } in &pages() {
        for block in blocks.iter().filter(|b| b.is_scene()) {
            // `x <-1` is read as if there were a blank, which the grammar does not say.
            if block.text.contains("W0102") || is_broken(&block.text) {
                continue;
            }
            programs += 1;
            if !Recogniser::new(&rules, Tokens::of(&block.text)).accepts("program") {
                wrong += &format!("{}:{}: not of the grammar\n", path.display(), block.line);
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(programs > 100, "only {programs}");
}

#[test]
fn the_grammar_refuses_what_does_not_parse() {
    let rules = of_page("grammar.md");
    let mut wrong = String::new();
    let mut broken = 0;
    for Page { path, blocks, .. } in &pages() {
        for block in blocks.iter().filter(|b| b.is_scene()) {
            // What is wrong inside one token (a number too large, an escape) is no matter of the grammar.
            let structural = |(_, code, _): &(u32, String, Option<u32>)| code.starts_with("E011");
            if !expected(&block.text).iter().any(structural) {
                continue;
            }
            broken += 1;
            if Recogniser::new(&rules, Tokens::of(&block.text)).accepts("program") {
                wrong += &format!("{}:{}: of the grammar all the same\n", path.display(), block.line);
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(broken > 8, "only {broken}");
}

#[test]
fn what_the_grammars_make_parses() {
    let words = of_page("lexical.md");
    for (page, is_core) in [("grammar.md", false), ("core-grammar.md", true)] {
        let rules = of_page(page);
        let statement = rules.iter().find(|(n, _)| n == "statement").expect("a rule `statement`").1.clone();
        let mut maker = Maker::new(&rules, &words, 7);
        for _ in 0..500 {
            let mut tokens = Vec::new();
            maker.make(&statement, 14, &mut tokens);
            let text = tokens.join(" ");
            // Before a point `prefer` is a name.
            if text.len() > 2000 || text == ";" || text.contains("prefer .") {
                continue;
            }
            let parsed = parse_file(&text);
            // A number may be too large and an escape half a character: no matter of the grammar.
            let errors =
                parsed.diagnostics.iter().filter(|d| d.is_error() && ![codes::E0103, codes::E0106].contains(&d.code));
            let errors: Vec<_> = errors.map(|d| &d.message).collect();
            assert!(errors.is_empty(), "{page} makes {text}\n{errors:?}");
            for (_, stmt) in parsed.statements.iter().filter(|_| is_core) {
                let beyond: Vec<_> = check_core(stmt).into_iter().map(|d| d.message).collect();
                assert!(beyond.is_empty(), "{page} makes {text}\n{beyond:?}");
            }
        }
    }
}

#[test]
fn the_lexical_grammar_makes_and_reads_tokens() {
    let words = of_page("lexical.md");
    let tokens = [("NUMBER", Kind::Number), ("STRING", Kind::Str), ("NAME", Kind::Ident)];
    for (name, kind) in tokens {
        let piece = words.iter().find(|(n, _)| n == name).unwrap_or_else(|| panic!("no rule {name}")).1.clone();
        let mut maker = Maker::new(&words, &words, 11);
        for _ in 0..1000 {
            let mut characters = Vec::new();
            maker.make(&piece, 5, &mut characters);
            let text = characters.concat();
            let made: Vec<Kind> = lex(&text).iter().map(|t| t.kind).collect();
            assert!(made == [kind], "{name} makes {text}, which is {made:?}");
        }
    }
    for Page { path, blocks, .. } in &pages() {
        for block in blocks.iter().filter(|b| b.is_scene()) {
            for token in lex(&block.text) {
                let Some((name, _)) = tokens.iter().find(|(_, kind)| *kind == token.kind) else { continue };
                let text = &block.text[token.range.bytes()];
                let characters = Characters(text.chars().collect());
                let fits = Recogniser::new(&words, characters).accepts(name);
                let escape = *name == "STRING" && is_broken(&block.text);
                assert!(fits || escape, "{}:{}: {text} is no {name}", path.display(), block.line);
            }
        }
    }
}

#[test]
fn every_rule_of_the_grammar_is_used() {
    for page in ["grammar.md", "core-grammar.md", "lexical.md"] {
        let rules = of_page(page);
        let mut used: BTreeSet<&str> = BTreeSet::from(["program", "NUMBER", "STRING", "NAME", "COMMENT"]);
        fn names<'p>(piece: &'p Piece, out: &mut BTreeSet<&'p str>) {
            match piece {
                Piece::Rule(name) => {
                    out.insert(name);
                }
                Piece::Sequence(all) | Piece::Choice(all) => all.iter().for_each(|p| names(p, out)),
                Piece::Optional(p) | Piece::Any(p) | Piece::Some(p) => names(p, out),
                Piece::Literal(_) | Piece::Class(_) => {}
            }
        }
        rules.iter().for_each(|(_, piece)| names(piece, &mut used));
        for (name, _) in &rules {
            assert!(used.contains(name.as_str()), "{page}: nothing uses {name}");
        }
    }
}
