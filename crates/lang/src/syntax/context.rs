//! What stands, or could stand, at an offset of a file: for completion and signature help.
//!
//! The question is put to the word before: after a dot a property follows, after an operator a value. So the answer is
//! there in half a statement, too.

use super::{NodeKind, SyntaxKind, SyntaxNode, SyntaxToken, from_rowan};
use crate::parse::words::{declares, ends_value, is_constructor, is_word};
use crate::token::Kind;
use scenelang_base::TextRange;

/// What is known of a place in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Context {
    /// What could be written there.
    pub expects: Expects,
    /// The word that the offset is in or at the end of, which a completion replaces; else empty, at the offset.
    pub word: TextRange,
    /// The innermost call whose arguments hold the offset.
    pub call: Option<CallSite>,
}

/// What could be written at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expects {
    /// A statement: a keyword, or a name to assign.
    Statement,
    /// A name that nothing has yet.
    NewName,
    /// A property of what stands before the dot.
    Property {
        /// What stands before the dot.
        of: TextRange,
    },
    /// A property of the object that a filter is asking about.
    OwnProperty,
    /// A value or a condition: a name, a literal, a function, a predicate.
    Value,
    /// An operator, a connective, or a keyword that goes on, for a value ends here.
    Operator,
    ParameterType,
    ImportPath {
        /// What there is of it between the quotation marks.
        written: TextRange,
    },
    /// Text in a string.
    Text {
        /// What there is of it between the quotation marks.
        written: TextRange,
    },
    /// Nothing that could be proposed: in a comment, in a number, where only a bracket can follow.
    Nothing,
}

/// A call and the argument that an offset is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CallSite {
    /// The name of the function or predicate, or the word of an allowance.
    pub callee: TextRange,
    /// Which argument, from 0: as many commas stand before the offset.
    pub argument: usize,
}

/// What stands, or could stand, at an offset of the file (or statement) `root`. Offsets beyond its end mean the end.
pub fn context_at(root: &SyntaxNode, offset: u32) -> Context {
    let end = u32::from(root.text_range().end());
    let offset = offset.min(end);
    let left = root.token_at_offset(offset.into()).left_biased().filter(|t| range(t).start < offset);
    let word = left.clone().filter(|t| is_word(t.text()) && !is_trivia(t));
    let before = match &word {
        Some(word) => word.prev_token(),
        None => left.clone(),
    };
    let before = std::iter::successors(before, SyntaxToken::prev_token).find(|t| !is_trivia(t));
    let expects = match left.as_ref().and_then(|left| within(left, offset)) {
        Some(expects) => expects,
        None if word.as_ref().is_some_and(begins_statement) => Expects::Statement,
        None => before.as_ref().map_or(Expects::Statement, after),
    };
    let word = word.map_or(TextRange::empty(offset), |w| range(&w));
    // Inside a string or a number that is an argument, that is the word before.
    let inside = left.filter(|t| range(t).end > offset && !is_trivia(t)).or(before);
    Context { expects, word, call: inside.as_ref().and_then(|token| call_around(token, offset)) }
}

fn range(token: &SyntaxToken) -> TextRange {
    from_rowan(token.text_range())
}

fn kind(token: &SyntaxToken) -> Option<Kind> {
    token.kind().token()
}

fn is_trivia(token: &SyntaxToken) -> bool {
    kind(token).is_some_and(|k| k.is_trivia() || k == Kind::Bom || k == Kind::OpenComment)
}

fn parent(token: &SyntaxToken) -> Option<NodeKind> {
    token.parent().and_then(|p| p.kind().node())
}

/// Whether a word is the first of what a statement says.
fn begins_statement(word: &SyntaxToken) -> bool {
    let says = |node: &SyntaxNode| {
        let below = node.parent().and_then(|p| p.kind().node()) == Some(NodeKind::Statement);
        below && node.kind().node().is_some_and(NodeKind::is_statement)
    };
    let body = word.parent_ancestors().find(says);
    body.is_some_and(|body| body.text_range().start() == word.text_range().start())
}

/// What is expected within a token, if the token alone decides.
fn within(token: &SyntaxToken, offset: u32) -> Option<Expects> {
    let place = range(token);
    let inside = offset < place.end;
    match kind(token)? {
        Kind::LineComment | Kind::DocComment | Kind::OpenComment => Some(Expects::Nothing),
        Kind::BlockComment if inside => Some(Expects::Nothing),
        Kind::Number | Kind::BadNumber => Some(Expects::Nothing),
        kind @ (Kind::Str | Kind::OpenStr | Kind::OddQuotes) if inside || kind == Kind::OpenStr => {
            let closing = if kind == Kind::OpenStr { 0 } else { token.text().chars().next_back()?.len_utf8() };
            let opening = token.text().chars().next()?.len_utf8();
            let written = TextRange { start: place.start + opening as u32, end: place.end - closing as u32 };
            let imported = previous(token).is_some_and(|t| self::kind(&t) == Some(Kind::Import));
            Some(if imported { Expects::ImportPath { written } } else { Expects::Text { written } })
        }
        _ => None,
    }
}

/// The token before, trivia left out.
fn previous(token: &SyntaxToken) -> Option<SyntaxToken> {
    std::iter::successors(token.prev_token(), SyntaxToken::prev_token).find(|t| !is_trivia(t))
}

fn after(token: &SyntaxToken) -> Expects {
    let Some(kind) = kind(token) else { return Expects::Statement };
    let before = || previous(token).and_then(|t| self::kind(&t));
    match kind {
        Kind::Semi => Expects::Statement,
        _ if parent(token) == Some(NodeKind::Requirement) => match kind {
            Kind::RParen => Expects::Statement,
            _ => Expects::Nothing,
        },
        Kind::Dot => property(token),
        Kind::LParen | Kind::Comma if parent(token) == Some(NodeKind::Parameters) => Expects::ParameterType,
        Kind::LParen if before() == Some(Kind::Count) => Expects::NewName,
        Kind::LParen if before() == Some(Kind::Req) => Expects::Nothing,
        // Not a keyword before the name is there, but what else should it be?
        Kind::Ident if matches!(token.text(), "forall" | "exists") && parent(token) == Some(NodeKind::NameRef) => {
            Expects::NewName
        }
        Kind::ParamType | Kind::Predicate | Kind::Forall | Kind::Exists => Expects::NewName,
        kind if declares(kind) => Expects::NewName,
        Kind::Import => Expects::ImportPath { written: TextRange::empty(range(token).end) },
        Kind::Req | Kind::AllowCollide | Kind::AllowOutside | Kind::AllowFloat | Kind::Count => Expects::Nothing,
        kind if is_constructor(kind) => Expects::Nothing,
        Kind::RParen if parent(token) == Some(NodeKind::Parameters) => Expects::Nothing,
        Kind::Str if parent(token) == Some(NodeKind::Import) => Expects::Nothing,
        _ if parent(token) == Some(NodeKind::Name) => match before() {
            Some(Kind::Forall | Kind::Exists | Kind::LParen) => Expects::Operator,
            _ => Expects::Nothing,
        },
        kind if ends_value(kind) => Expects::Operator,
        _ => Expects::Value,
    }
}

/// What may follow a dot.
fn property(dot: &SyntaxToken) -> Expects {
    let Some(node) = dot.parent() else { return Expects::Nothing };
    if node.kind() == SyntaxKind::Node(NodeKind::Own) {
        return Expects::OwnProperty;
    }
    // Of what stands before it in the same node: `lamp.pos` in `lamp.pos.y`, a path or a member.
    let start = from_rowan(node.text_range()).start;
    match previous(dot) {
        Some(last) if range(&last).start >= start => {
            Expects::Property { of: TextRange { start, end: range(&last).end } }
        }
        _ => Expects::Nothing,
    }
}

/// The innermost call whose arguments a token is among, or opens.
fn call_around(token: &SyntaxToken, offset: u32) -> Option<CallSite> {
    let closes = |node: &SyntaxNode| kind(token) == Some(Kind::RParen) && node.last_token().as_ref() == Some(token);
    let arguments = token
        .parent_ancestors()
        .take_while(|node| node.kind() != SyntaxKind::Node(NodeKind::Statement))
        .find(|node| node.kind() == SyntaxKind::Node(NodeKind::Arguments) && !closes(node))?;
    let callee = previous(&arguments.first_token()?)?;
    let comma = |t: &SyntaxToken| kind(t) == Some(Kind::Comma) && range(t).end <= offset;
    let commas = arguments.children_with_tokens().filter_map(|e| e.into_token()).filter(comma);
    Some(CallSite { callee: range(&callee), argument: commas.count() })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The context at `|`, in words.
    fn at_bar(marked: &str) -> String {
        let offset = marked.find('|').expect("a mark");
        let text = marked.replacen('|', "", 1);
        let context = context_at(&super::super::parse(&text), offset as u32);
        let slice = |range: TextRange| &text[range.bytes()];
        let expects = match context.expects {
            Expects::Property { of } => format!("property of {}", slice(of)),
            Expects::ImportPath { written } => format!("path {:?}", slice(written)),
            Expects::Text { written } => format!("text {:?}", slice(written)),
            other => format!("{other:?}"),
        };
        let word = if context.word.is_empty() { String::new() } else { format!(" [{}]", slice(context.word)) };
        let call = context.call.map_or(String::new(), |c| format!(" in {} {}", slice(c.callee), c.argument));
        format!("{expects}{word}{call}")
    }

    #[test]
    fn half_typed_statements() {
        let cases = [
            ("|", "Statement"),
            ("  |  ", "Statement"),
            ("obj|", "Statement [obj]"),
            ("object a; ass|\nobject b;", "Statement [ass]"),
            ("object a;|", "Statement"),
            ("@req(\"x\") |", "Statement"),
            ("@req(\"x\") ass|", "Statement [ass]"),
            ("@req(|", "Nothing"),
            ("/// doc\n|", "Statement"),
            ("object |", "NewName"),
            ("object la|;", "NewName [la]"),
            ("object lamp |", "Nothing"),
            ("object chair[|", "Value"),
            ("assert |", "Value"),
            ("assert la|", "Value [la]"),
            ("assert lamp |", "Operator"),
            ("assert lamp a|", "Operator [a]"),
            ("assert lamp.|", "property of lamp"),
            ("assert lamp.|;", "property of lamp"),
            ("assert lamp.|\nobject b;", "property of lamp"),
            ("assert lamp.|\nlamp.color <- \"red\";", "property of lamp"),
            ("assert lamp.p|", "property of lamp [p]"),
            ("assert lamp.pos.| > 1;", "property of lamp.pos"),
            ("assert chair[1].| and b;", "property of chair[1]"),
            ("assert (lamp.pos - b.pos).|", "property of (lamp.pos - b.pos)"),
            ("assert near(lamp, |", "Value in near 1"),
            ("assert near(|", "Value in near 0"),
            ("assert near(lamp, |\nobject b;", "Value in near 1"),
            ("assert near(lamp|)", "Value [lamp] in near 0"),
            ("assert near(lamp, b)| ;", "Operator"),
            ("assert near(lamp, max(1, |), 2);", "Value in max 1"),
            ("assert near(lamp, max(1, 2)|, 2);", "Operator in near 1"),
            ("assert near(lamp, (b.|", "property of b in near 1"),
            ("assert clear(a, fr|, 1);", "Value [fr] in clear 1"),
            ("assert clear(a, front, 1|);", "Nothing in clear 2"),
            ("lamp.pos <- vec3(1,|", "Value in vec3 1"),
            ("lamp.|", "property of lamp"),
            ("lamp.po| <- vec3(1, 2, 3);", "property of lamp [po]"),
            ("lamp.pos.| <- 1;", "property of lamp.pos"),
            ("chair[1].| <- 1;", "property of chair[1]"),
            ("lamp.pos <- |", "Value"),
            ("lamp.pos |", "Operator"),
            ("lamp.color <- \"re|", "text \"re\""),
            ("lamp.color <- \"re|d\";", "text \"red\""),
            ("lamp.color <- \"red\"|;", "Operator"),
            ("import |", "path \"\""),
            ("import \"pa|", "path \"pa\""),
            ("import \"pa|rts.scene\";", "path \"parts.scene\""),
            ("import \"parts.scene\" |", "Nothing"),
            ("predicate |", "NewName"),
            ("predicate near(|", "ParameterType"),
            ("predicate near(Obj|", "ParameterType [Obj]"),
            ("predicate near(Object |", "NewName"),
            ("predicate near(Object a, |", "ParameterType"),
            ("predicate near(Object a, Num|) := a.top > 1;", "ParameterType [Num]"),
            ("predicate near(Object a) |", "Nothing"),
            ("predicate near(Object a) := |", "Value"),
            ("predicate near(Object a) := a.|;", "property of a"),
            ("assert forall |", "NewName"),
            ("assert forall c |", "Operator"),
            ("assert forall c in |", "Value"),
            ("assert forall c in chair: |", "Value"),
            ("assert forall c in chair: c.|", "property of c"),
            ("assert forall c in objects where .|", "OwnProperty"),
            ("assert forall c in objects where .category = \"|\": c.pos.x > 0;", "text \"\""),
            ("assert count(|c in chair: c) > 1;", "NewName"),
            ("allowCollide(|", "Value in allowCollide 0"),
            ("allowCollide(rug, |);", "Value in allowCollide 1"),
            ("allowCollide |", "Nothing"),
            ("// com|ment", "Nothing"),
            ("object a; // comment|", "Nothing"),
            ("assert a /* x | y */ > 1;", "Nothing"),
            ("assert a.pos.x > 3|", "Nothing"),
            ("assert a.pos.x > 3 |", "Operator"),
            ("assert a.pos.x > |;", "Value"),
            ("/* open |", "Nothing"),
        ];
        let wrong: Vec<_> = cases
            .iter()
            .map(|(marked, wanted)| (*marked, at_bar(marked), *wanted))
            .filter(|(_, found, wanted)| found != wanted)
            .collect();
        assert!(wrong.is_empty(), "{wrong:#?}");
    }
}
