//! Sentences that a grammar of the book makes.

use super::ebnf::{Piece, Rules};
use rustc_hash::FxHashMap;

/// Makes sentences of a grammar, the same ones every time.
pub struct Maker<'r> {
    rules: &'r Rules,
    words: &'r Rules,
    depths: FxHashMap<String, usize>,
    state: u64,
}

impl<'r> Maker<'r> {
    /// `words` is the grammar of tokens.
    pub fn new(rules: &'r Rules, words: &'r Rules, state: u64) -> Self {
        Self { rules, words, depths: depths(rules), state }
    }

    fn below(&mut self, n: usize) -> usize {
        self.state = self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.state >> 33) % n as u64) as usize
    }

    /// `fuel` bounds the depth: without it the shortest way out is taken.
    pub fn make(&mut self, piece: &Piece, fuel: usize, out: &mut Vec<String>) {
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
