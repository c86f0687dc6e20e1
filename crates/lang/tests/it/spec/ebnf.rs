//! Grammars as the book writes them, read. Their form is that of the W3C: `name ::= …` with `"literal"`, `|`, `?`, `*`,
//! `+` and parentheses. Rules in capitals are tokens; they are made of characters, with `[a-z]` for classes.

use super::pages;

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
