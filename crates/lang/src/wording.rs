//! Templates of messages: what a predicate measured, in the words of who wrote the predicate.
//!
//! A line `Measured: …` in the documentation of a predicate is the sentence for a comparison of its body: the first line
//! for the first comparison, the second for the second, `-` for one that needs none. `{value}` stands for the left side of
//! the comparison, `{a}` for a parameter or a variable of a quantifier, `{value + d}` for a sum, `{value:turn 30}` for the
//! angle whose cosine is the left side, if the right side is that of 30°. `{beyond|short of}` is
//! the first text where what was measured is 0 or more, else the second, and the sign is then left out. What the value must
//! be is not part of the sentence: reports add it.

use crate::ast::{ExprId, ExprKind, Stmt};
use crate::program::{NodeId, ObjectId, RegionId, Unit};
use smol_str::SmolStr;
use std::sync::Arc;

/// What a line of documentation begins with that is a template.
pub const MARK: &str = "Measured:";

#[derive(Clone, Debug, PartialEq)]
pub struct Template {
    /// Its pieces, in order.
    pub pieces: Vec<TemplatePiece>,
    /// The names that it speaks of, each once.
    pub names: Vec<SmolStr>,
}

#[derive(Clone, Debug, PartialEq)]
pub enum TemplatePiece {
    /// Text as it stands.
    Text(String),
    /// A name by itself: an index into [`Template::names`].
    Name(usize),
    /// What was measured, plus the terms.
    Value {
        /// Terms, each with whether it is taken away.
        terms: Vec<(bool, Term)>,
        shown: Shown,
    },
    /// One text where what was measured is 0 or more, and one where it is less.
    Choice([String; 2]),
}

/// How a value is shown.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub enum Shown {
    #[default]
    WithUnit,
    /// Without a unit.
    Plain,
    /// As the angle whose cosine it is, at a scale on which what it must be is the cosine of so many degrees.
    Turn(f64),
}

/// A term beside the value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Term {
    /// A number as written.
    Number(SmolStr),
    /// An index into [`Template::names`].
    Name(usize),
}

/// What a name of a template stands for in a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Named {
    Object(ObjectId),
    Region(RegionId),
    Constant(f64, Unit),
    /// A number that the formula computes.
    Node(NodeId, Unit),
}

/// A comparison of a formula with the template for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Wording {
    /// The comparison.
    pub node: NodeId,
    pub template: Arc<Template>,
    /// What its names stand for, in their order.
    pub named: Box<[Named]>,
}

impl Template {
    /// Reads a template.
    ///
    /// # Errors
    /// What is wrong with it, as the end of a sentence.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut template = Self { pieces: Vec::new(), names: Vec::new() };
        let mut rest = text.trim();
        while !rest.is_empty() {
            let Some((before, from)) = rest.split_once('{') else {
                template.text(rest)?;
                break;
            };
            template.text(before)?;
            let Some((inside, after)) = from.split_once('}') else {
                return Err("a `{` without its `}`".to_owned());
            };
            template.placeholder(inside)?;
            rest = after;
        }
        let values = template.pieces.iter().filter(|p| matches!(p, TemplatePiece::Value { .. })).count();
        if values == 1 {
            Ok(template)
        } else {
            Err(format!("{values} occurrences of `{{value}}`, where exactly one is needed"))
        }
    }

    fn text(&mut self, text: &str) -> Result<(), String> {
        if text.contains('}') {
            return Err("a `}` without its `{`".to_owned());
        }
        if !text.is_empty() {
            self.pieces.push(TemplatePiece::Text(text.to_owned()));
        }
        Ok(())
    }

    fn placeholder(&mut self, inside: &str) -> Result<(), String> {
        if let Some((first, second)) = inside.split_once('|') {
            self.pieces.push(TemplatePiece::Choice([first.trim(), second.trim()].map(str::to_owned)));
            return Ok(());
        }
        let (sum, shown) = match inside.split_once(':') {
            Some((sum, how)) => (sum, Shown::read(how.trim())?),
            None => (inside, Shown::WithUnit),
        };
        let sum = sum.trim();
        if is_name(sum) && sum != "value" && shown == Shown::WithUnit {
            let name = self.name(sum);
            self.pieces.push(TemplatePiece::Name(name));
            return Ok(());
        }
        let (mut terms, mut values, mut minus) = (Vec::new(), 0, false);
        let spaced = sum.replace('+', " + ").replace('-', " - ");
        let mut expected = true;
        for word in spaced.split_whitespace() {
            match word {
                "+" | "-" if !expected => (minus, expected) = (word == "-", true),
                "value" if expected && !minus => (values, expected) = (values + 1, false),
                _ if expected && is_name(word) && word != "value" => {
                    let name = self.name(word);
                    terms.push((minus, Term::Name(name)));
                    expected = false;
                }
                _ if expected && word.parse::<f64>().is_ok_and(f64::is_finite) => {
                    terms.push((minus, Term::Number(word.into())));
                    expected = false;
                }
                _ => return Err(format!("`{{{inside}}}`, which is neither a name nor a sum")),
            }
        }
        if values != 1 || expected {
            return Err(format!("`{{{inside}}}`, which is neither a name nor a sum with `value`"));
        }
        self.pieces.push(TemplatePiece::Value { terms, shown });
        Ok(())
    }

    fn name(&mut self, name: &str) -> usize {
        self.names.iter().position(|n| n == name).unwrap_or_else(|| {
            self.names.push(name.into());
            self.names.len() - 1
        })
    }

    /// Whether the names stand for what the template takes them for: terms are numbers.
    pub fn fits(&self, named: &[Named]) -> bool {
        let is_number = |i: usize| matches!(named.get(i), Some(Named::Constant(..) | Named::Node(..)));
        self.pieces.iter().all(|piece| match piece {
            TemplatePiece::Value { terms, .. } => terms.iter().all(|(_, term)| match term {
                Term::Number(_) => true,
                Term::Name(i) => is_number(*i),
            }),
            TemplatePiece::Text(_) | TemplatePiece::Name(_) | TemplatePiece::Choice(_) => true,
        })
    }
}

impl Shown {
    fn read(how: &str) -> Result<Self, String> {
        let turn = || how.strip_prefix("turn ")?.trim().parse().ok().filter(|angle| (0.0..=180.0).contains(angle));
        match how {
            "plain" => Ok(Self::Plain),
            _ => turn().map(Self::Turn).ok_or_else(|| {
                format!("`{how}`, where only `plain`, or `turn` with an angle from 0 to 180, is allowed")
            }),
        }
    }
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_') && word.chars().all(|c| c.is_alphanumeric() || c == '_')
}

/// The text of each template in a documentation, in order; `None`: that comparison needs none.
pub fn lines(doc: &str) -> impl Iterator<Item = Option<&str>> {
    doc.lines().filter_map(|line| line.trim().strip_prefix(MARK)).map(|text| Some(text.trim()).filter(|t| *t != "-"))
}

/// The documentation without its templates: what it says to a reader.
pub fn description(doc: &str) -> String {
    let lines: Vec<&str> = doc.lines().filter(|line| !line.trim().starts_with(MARK)).collect();
    lines.join("\n").trim_end().to_owned()
}

/// The comparisons of a statement, in the order of its text: the left side of each.
pub fn comparisons(stmt: &Stmt) -> Vec<ExprId> {
    let mut found: Vec<(u32, ExprId)> = stmt
        .exprs
        .iter()
        .filter_map(|e| match &e.kind {
            ExprKind::Compare(left, rest) => Some((rest.first()?.1.start, *left)),
            _ => None,
        })
        .collect();
    found.sort_unstable_by_key(|(at, _)| *at);
    found.into_iter().map(|(_, left)| left).collect()
}

/// The good templates of a statement, each with the left side of its comparison.
pub fn templates(stmt: &Stmt) -> Vec<(ExprId, Arc<Template>)> {
    let pairs = comparisons(stmt).into_iter().zip(lines(&stmt.doc));
    pairs.filter_map(|(left, text)| Some((left, Arc::new(Template::parse(text?).ok()?)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn templates_are_read() {
        let text = "the back of {a} is {value + d - 0.5} {beyond | short of} the wall of {r}";
        let template = Template::parse(text).unwrap();
        assert_eq!(template.names, ["a", "d", "r"]);
        assert_eq!(
            template.pieces,
            [
                TemplatePiece::Text("the back of ".into()),
                TemplatePiece::Name(0),
                TemplatePiece::Text(" is ".into()),
                TemplatePiece::Value {
                    terms: vec![(false, Term::Name(1)), (true, Term::Number("0.5".into()))],
                    shown: Shown::WithUnit
                },
                TemplatePiece::Text(" ".into()),
                TemplatePiece::Choice(["beyond".into(), "short of".into()]),
                TemplatePiece::Text(" the wall of ".into()),
                TemplatePiece::Name(2),
            ]
        );
        assert!(template.fits(&[
            Named::Object(ObjectId(0)),
            Named::Constant(1.0, Unit::Metre),
            Named::Region(RegionId(0))
        ]));
        assert!(!template.fits(&[Named::Object(ObjectId(0)), Named::Object(ObjectId(1)), Named::Region(RegionId(0))]));
        assert_eq!(
            Template::parse("{value:plain} times").unwrap().pieces[0],
            TemplatePiece::Value { terms: vec![], shown: Shown::Plain }
        );
        assert_eq!(
            Template::parse("{a} looks {value:turn 30} past {b}").unwrap().pieces[2],
            TemplatePiece::Value { terms: vec![], shown: Shown::Turn(30.0) }
        );
    }

    #[test]
    fn what_is_no_template_says_why() {
        for (text, why) in [
            ("{a} is far", "0 occurrences of `{value}`, where exactly one is needed"),
            ("{value} and {value}", "2 occurrences of `{value}`, where exactly one is needed"),
            ("{value", "a `{` without its `}`"),
            ("value} {value}", "a `}` without its `{`"),
            ("{value + }", "`{value + }`, which is neither a name nor a sum with `value`"),
            ("{a + d} {value}", "`{a + d}`, which is neither a name nor a sum with `value`"),
            ("{value * 2}", "`{value * 2}`, which is neither a name nor a sum"),
            ("{- value}", "`{- value}`, which is neither a name nor a sum"),
            ("{value:cm}", "`cm`, where only `plain`, or `turn` with an angle from 0 to 180, is allowed"),
            ("{value:turn 200}", "`turn 200`, where only `plain`, or `turn` with an angle from 0 to 180, is allowed"),
            ("{}", "`{}`, which is neither a name nor a sum with `value`"),
        ] {
            assert_eq!(Template::parse(text).unwrap_err(), why, "{text}");
        }
    }

    #[test]
    fn a_description_has_no_templates() {
        assert_eq!(description("a is near b.\nMeasured: {value}\nMeasured: -"), "a is near b.");
        assert_eq!(lines("x\nMeasured: {value}\nMeasured: -").collect::<Vec<_>>(), [Some("{value}"), None]);
    }
}
