//! The text form of USD as a tree of prims with the values that were written: as much of it as scenes need, whoever wrote
//! the file. What is not understood is passed over; what breaks off is said.

use std::collections::BTreeMap;

/// Brackets and prims nest no deeper.
const DEEPEST: usize = 100;
/// No more prims are kept.
const MOST: usize = 200_000;

#[derive(Clone, Debug, PartialEq)]
pub(super) enum UsdValue {
    Number(f64),
    /// A string, or a word as it stands: a token, a path.
    Text(String),
    /// A tuple or a list.
    List(Vec<UsdValue>),
    Dictionary(BTreeMap<String, UsdValue>),
}

impl UsdValue {
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// A tuple of numbers, flattened: a matrix is its rows.
    pub fn numbers<const N: usize>(&self) -> Option<[f64; N]> {
        fn all(value: &UsdValue, out: &mut Vec<f64>) {
            match value {
                UsdValue::Number(number) => out.push(*number),
                UsdValue::List(items) => items.iter().for_each(|item| all(item, out)),
                _ => {}
            }
        }
        let mut out = Vec::new();
        all(self, &mut out);
        out.try_into().ok()
    }

    /// The words of a list.
    pub fn texts(&self) -> Vec<&str> {
        match self {
            Self::List(items) => items.iter().filter_map(Self::text).collect(),
            Self::Text(text) => vec![text],
            _ => Vec::new(),
        }
    }

    pub fn get(&self, key: &str) -> Option<&Self> {
        match self {
            Self::Dictionary(members) => members.get(key),
            _ => None,
        }
    }
}

/// A prim, or the layer itself.
#[derive(Clone, Debug, Default)]
pub(super) struct Prim {
    /// `Xform`; empty where none is given.
    pub kind: String,
    pub name: String,
    /// `class`, which is not drawn.
    pub is_class: bool,
    pub metadata: BTreeMap<String, UsdValue>,
    pub values: BTreeMap<String, UsdValue>,
    pub children: Vec<Prim>,
}

impl Prim {
    /// What we have written into it.
    pub fn own(&self, key: &str) -> Option<&str> {
        self.metadata.get("customData")?.get("scenelang")?.get(key)?.text()
    }

    /// Adds what a weaker layer says of the same prim: where both say something, this one counts.
    pub fn add_weaker(&mut self, weaker: Self) {
        if self.kind.is_empty() {
            self.kind = weaker.kind;
        }
        self.is_class |= weaker.is_class;
        for (key, value) in weaker.metadata {
            self.metadata.entry(key).or_insert(value);
        }
        for (key, value) in weaker.values {
            self.values.entry(key).or_insert(value);
        }
        let at: BTreeMap<String, usize> =
            self.children.iter().enumerate().map(|(i, child)| (child.name.clone(), i)).collect();
        for child in weaker.children {
            match at.get(&child.name) {
                Some(&i) => self.children[i].add_weaker(child),
                None => self.children.push(child),
            }
        }
    }
}

/// What is wrong with a text, and in which line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Broken {
    pub line: usize,
    pub say: &'static str,
}

/// Reads a layer.
pub(super) fn parse(text: &str) -> Result<Prim, Broken> {
    let mut parser = Parser { text, at: 0, prims: 0 };
    parser.layer()
}

#[derive(Clone, Debug, PartialEq)]
enum Token<'t> {
    Word(&'t str),
    Text(String),
    Sign(char),
    Line,
    End,
}

struct Parser<'t> {
    text: &'t str,
    at: usize,
    prims: usize,
}

type Step<T> = Result<T, Broken>;

impl<'t> Parser<'t> {
    fn fail<T>(&self, say: &'static str) -> Step<T> {
        let line = self.text.as_bytes()[..self.at].iter().filter(|b| **b == b'\n').count() + 1;
        Err(Broken { line, say })
    }

    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn token(&mut self) -> Step<Token<'t>> {
        loop {
            let rest = self.rest();
            let Some(c) = rest.chars().next() else { return Ok(Token::End) };
            match c {
                ' ' | '\t' | '\r' | '\u{feff}' => self.at += c.len_utf8(),
                '#' => self.at += rest.find('\n').unwrap_or(rest.len()),
                '\n' | ';' => {
                    self.at += 1;
                    return Ok(Token::Line);
                }
                '"' | '\'' => return self.string(c).map(Token::Text),
                '@' | '<' => return self.quoted(c).map(Token::Text),
                _ if is_word(c) => {
                    let length = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
                    self.at += length;
                    return Ok(Token::Word(&rest[..length]));
                }
                c => {
                    self.at += c.len_utf8();
                    return Ok(Token::Sign(c));
                }
            }
        }
    }

    fn peek(&mut self) -> Step<Token<'t>> {
        let at = self.at;
        let token = self.token();
        self.at = at;
        token
    }

    /// The next token that is no end of a line.
    fn solid(&mut self) -> Step<Token<'t>> {
        loop {
            match self.token()? {
                Token::Line => {}
                token => return Ok(token),
            }
        }
    }

    fn expect(&mut self, sign: char, say: &'static str) -> Step<()> {
        if self.solid()? == Token::Sign(sign) { Ok(()) } else { self.fail(say) }
    }

    /// `@path@`, `@@@path@@@`, `<path>`
    fn quoted(&mut self, open: char) -> Step<String> {
        let close = match open {
            '<' => ">",
            _ if self.rest().starts_with("@@@") => "@@@",
            _ => "@",
        };
        let inner = &self.rest()[close.len()..];
        let Some(length) = inner.find(close) else { return self.fail("a path is not closed") };
        self.at += length + 2 * close.len();
        Ok(inner[..length].to_owned())
    }

    fn string(&mut self, quote: char) -> Step<String> {
        let triple: String = std::iter::repeat_n(quote, 3).collect();
        let is_triple = self.rest().starts_with(&triple);
        let close = if is_triple { triple } else { quote.to_string() };
        self.at += close.len();
        let mut out = String::new();
        loop {
            let rest = self.rest();
            if rest.starts_with(&close) {
                self.at += close.len();
                return Ok(out);
            }
            let plain = rest.find([quote, '\\', '\n']).unwrap_or(rest.len());
            if plain > 0 {
                out.push_str(&rest[..plain]);
                self.at += plain;
                continue;
            }
            match rest.chars().next() {
                Some('\\') => {
                    self.at += 1;
                    self.escape(&mut out);
                }
                Some('\n') if !is_triple => return self.fail("a string is not closed on its line"),
                Some(c) => {
                    out.push(c);
                    self.at += c.len_utf8();
                }
                None => return self.fail("a string is not closed"),
            }
        }
    }

    fn escape(&mut self, out: &mut String) {
        let Some(c) = self.rest().chars().next() else { return };
        self.at += c.len_utf8();
        out.push(match c {
            'n' => '\n',
            'r' => '\r',
            't' => '\t',
            'x' => {
                let hex: String = self.rest().chars().take(2).take_while(char::is_ascii_hexdigit).collect();
                self.at += hex.len();
                u32::from_str_radix(&hex, 16).ok().and_then(char::from_u32).unwrap_or('\u{fffd}')
            }
            other => other,
        });
    }

    fn layer(&mut self) -> Step<Prim> {
        if !self.text.trim_start_matches('\u{feff}').starts_with("#usda ") {
            return self.fail("it does not start with `#usda`");
        }
        let mut root = Prim::default();
        if self.solid_peek()? == Token::Sign('(') {
            self.solid()?;
            root.metadata = self.metadata(0)?;
        }
        self.block(&mut root, 0)?;
        Ok(root)
    }

    fn solid_peek(&mut self) -> Step<Token<'t>> {
        while self.peek()? == Token::Line {
            self.token()?;
        }
        self.peek()
    }

    /// What stands in a prim, up to its bracket; of the layer up to the end.
    fn block(&mut self, prim: &mut Prim, depth: usize) -> Step<()> {
        if depth > DEEPEST {
            return self.fail("prims are nested too deeply");
        }
        loop {
            match self.solid()? {
                Token::End if depth == 0 => return Ok(()),
                Token::Sign('}') if depth > 0 => return Ok(()),
                Token::End => return self.fail("the file ends within a prim"),
                Token::Word(word @ ("def" | "over" | "class")) => {
                    let child = self.prim(word == "class", depth)?;
                    prim.children.push(child);
                }
                Token::Word("variantSet") => self.variants(depth)?,
                Token::Word(word) => self.property(word, prim, depth)?,
                _ => return self.fail("expected a prim or a property"),
            }
        }
    }

    fn prim(&mut self, is_class: bool, depth: usize) -> Step<Prim> {
        self.prims += 1;
        if self.prims > MOST {
            return self.fail("there are too many prims");
        }
        let mut out = Prim { is_class, ..Prim::default() };
        loop {
            match self.solid()? {
                Token::Word(kind) => kind.clone_into(&mut out.kind),
                Token::Text(name) => {
                    out.name = name;
                    break;
                }
                _ => return self.fail("expected the name of a prim"),
            }
        }
        if self.solid_peek()? == Token::Sign('(') {
            self.solid()?;
            out.metadata = self.metadata(depth)?;
        }
        self.expect('{', "expected `{` after the name of a prim")?;
        self.block(&mut out, depth + 1)?;
        Ok(out)
    }

    /// Variants are other looks of a thing: they are passed over.
    fn variants(&mut self, depth: usize) -> Step<()> {
        self.solid()?;
        self.expect('=', "expected `=` after the name of a variant set")?;
        self.expect('{', "a `{` was expected")?;
        self.skip('{', depth)
    }

    /// Passes over all up to the partner of a bracket.
    fn skip(&mut self, open: char, depth: usize) -> Step<()> {
        let mut nested = vec![open];
        while let Some(last) = nested.last().copied() {
            if nested.len() + depth > DEEPEST {
                return self.fail("brackets are nested too deeply");
            }
            match self.solid()? {
                Token::Sign(c @ ('{' | '(' | '[')) => nested.push(c),
                Token::Sign(c @ ('}' | ')' | ']')) if c == partner(last) => drop(nested.pop()),
                Token::Sign('}' | ')' | ']') => return self.fail("brackets do not match"),
                Token::End => return self.fail("the file ends within brackets"),
                _ => {}
            }
        }
        Ok(())
    }

    /// `uniform token[] name = value ( … )`: all that matters is the last word before the sign.
    fn property(&mut self, first: &'t str, prim: &mut Prim, depth: usize) -> Step<()> {
        let mut name = first;
        loop {
            match self.token()? {
                Token::Word(word) => name = word,
                Token::Sign('[' | ']') => {}
                Token::Sign('=') => {
                    let value = self.value(depth)?;
                    prim.values.insert(name.to_owned(), value);
                }
                Token::Sign('(') => self.skip('(', depth)?,
                Token::Sign('}') => {
                    self.at -= 1;
                    return Ok(());
                }
                Token::Line | Token::End => return Ok(()),
                _ => return self.fail("the syntax of a property is not valid"),
            }
        }
    }

    /// `name = value`, a line each, or only a text, up to the bracket.
    fn metadata(&mut self, depth: usize) -> Step<BTreeMap<String, UsdValue>> {
        let mut out = BTreeMap::new();
        let mut name = String::new();
        loop {
            match self.solid()? {
                Token::Sign(')') => return Ok(out),
                Token::Word(word) => word.clone_into(&mut name),
                Token::Sign('[' | ']') | Token::Text(_) => {}
                Token::Sign('=') => drop(out.insert(std::mem::take(&mut name), self.value(depth + 1)?)),
                _ => return self.fail("the syntax of the metadata is not valid"),
            }
        }
    }

    fn value(&mut self, depth: usize) -> Step<UsdValue> {
        if depth > DEEPEST {
            return self.fail("values are nested too deeply");
        }
        match self.solid()? {
            Token::Text(text) => Ok(UsdValue::Text(text)),
            Token::Word(word) => Ok(word.parse().map_or_else(|_| UsdValue::Text(word.to_owned()), UsdValue::Number)),
            Token::Sign(open @ ('(' | '[')) => {
                let mut items = Vec::new();
                loop {
                    match self.solid_peek()? {
                        Token::Sign(c) if c == partner(open) => {
                            self.solid()?;
                            return Ok(UsdValue::List(items));
                        }
                        Token::Sign(',') => drop(self.solid()?),
                        _ => items.push(self.value(depth + 1)?),
                    }
                }
            }
            Token::Sign('{') => self.dictionary(depth),
            _ => self.fail("a value was expected"),
        }
    }

    fn dictionary(&mut self, depth: usize) -> Step<UsdValue> {
        let mut out = BTreeMap::new();
        let mut name = String::new();
        loop {
            match self.solid()? {
                Token::Sign('}') => return Ok(UsdValue::Dictionary(out)),
                // Samples over time have a colon, and members of a dictionary a name in quotes where that is no word.
                Token::Sign('=' | ':') => drop(out.insert(std::mem::take(&mut name), self.value(depth + 1)?)),
                Token::Word(word) => name = word.trim_end_matches(':').to_owned(),
                Token::Text(text) => name = text,
                Token::Sign(',' | '[' | ']') => {}
                _ => return self.fail("the syntax of a dictionary is not valid"),
            }
            // `0: value`, where the colon belongs to the word.
            if self.text[..self.at].ends_with(':') && !name.is_empty() {
                let value = self.value(depth + 1)?;
                out.insert(std::mem::take(&mut name), value);
            }
        }
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | ':' | '.' | '-' | '+' | '!' | '|')
}

fn partner(open: char) -> char {
    match open {
        '(' => ')',
        '[' => ']',
        _ => '}',
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layer_is_read_as_it_is_written() {
        let text = "#usda 1.0\n(\n  \"a comment\"\n  customLayerData = {\n dictionary scenelang = {\n string spec = \"\"\"a \"q\"\nb\\\\n\\x41\"\"\"\n }\n }\n \
                    upAxis = \"Y\"\n)\n\ndef Xform \"World\" (\n kind = \"assembly\"\n prepend apiSchemas = [\"A\", \"B\"]\n)\n{\n token outputs:surface\n \
                    double3 xformOp:translate = (1, -2.5, 3e-2) (\n interpolation = \"x\"\n )\n uniform token[] xformOpOrder = [\"xformOp:translate\"]\n \
                    float3 x.timeSamples = {\n 0: (1, 2, 3),\n 1.5: None,\n }\n rel material:binding = </World/Looks/a>\n def \"inner\" { int a = 1; int b = 2 }\n \
                    variantSet \"v\" = {\n \"a\" ( x = 1 ) { def Mesh \"m\" { } }\n }\n over Cube \"two\"\n {\n }\n}\n";
        let root = parse(text).unwrap();
        let own = root.metadata["customLayerData"].get("scenelang").unwrap();
        assert_eq!(own.get("spec").unwrap().text(), Some("a \"q\"\nb\\nA"));
        let world = &root.children[0];
        assert_eq!((world.kind.as_str(), world.name.as_str()), ("Xform", "World"));
        assert_eq!(world.values["xformOp:translate"].numbers(), Some([1.0, -2.5, 0.03]));
        assert_eq!(world.values["xformOpOrder"].texts(), ["xformOp:translate"]);
        assert_eq!(world.values["material:binding"].text(), Some("/World/Looks/a"));
        let names: Vec<&str> = world.children.iter().map(|p| p.name.as_str()).collect();
        assert_eq!(names, ["inner", "two"]);
        assert_eq!(world.children[0].values["b"], UsdValue::Number(2.0));
    }

    #[test]
    fn what_breaks_off_is_said_with_its_line() {
        for (text, line, say) in [
            ("{}", 1, "it does not start with `#usda`"),
            ("#usda 1.0\ndef Xform \"a\"\n{\n", 4, "the file ends within a prim"),
            ("#usda 1.0\ndef Xform \"a\n", 2, "a string is not closed on its line"),
            ("#usda 1.0\ndef Xform \"a\" { float a = }\n", 2, "a value was expected"),
            ("#usda 1.0\ndef \"a\" { float[] a = [1, 2\n", 3, "a value was expected"),
        ] {
            assert_eq!(parse(text).unwrap_err(), Broken { line, say }, "{text}");
        }
        let deep = format!("#usda 1.0\ndef \"a\" {{ float a = {}", "[".repeat(100_000));
        assert_eq!(parse(&deep).unwrap_err().say, "values are nested too deeply");
        let nested = format!("#usda 1.0\n{}", "def \"a\" {".repeat(100_000));
        assert_eq!(parse(&nested).unwrap_err().say, "prims are nested too deeply");
    }
}
