//! `scenelang syntax`: the lossless tree of a file.

use super::write::Json;
use scenelang_base::TextRange;
use scenelang_lang::syntax::{self, NodeOrToken, SyntaxElement, SyntaxNode, Tree, WalkEvent, range_of};

/// The value of the member `format`.
const FORMAT: &str = "scenelang.syntax/1";

/// The tree of a text, an element a line.
pub fn text(text: &str) -> String {
    Tree(&syntax::parse(text)).to_string()
}

/// The tree of a text as JSON; `file` is how it is called.
pub fn json(file: &str, text: &str) -> String {
    tree(file, &syntax::parse(text))
}

fn tree(file: &str, tree: &SyntaxNode) -> String {
    let mut json = Json::default();
    json.open('{');
    json.member("format", FORMAT);
    json.member("file", file);
    json.name("tree");
    for event in tree.preorder_with_tokens() {
        match event {
            WalkEvent::Enter(element) => enter(&element, &mut json),
            WalkEvent::Leave(NodeOrToken::Node(_)) => {
                json.close(']');
                json.close('}');
            }
            WalkEvent::Leave(NodeOrToken::Token(_)) => json.close('}'),
        }
    }
    json.close('}');
    json.finish()
}

fn enter(element: &SyntaxElement, json: &mut Json) {
    let TextRange { start, end } = range_of(element);
    json.open('{');
    json.member("kind", element.kind().to_string());
    json.member("range", vec![start, end]);
    match element {
        NodeOrToken::Node(_) => {
            json.name("children");
            json.open('[');
        }
        NodeOrToken::Token(token) => json.member("text", token.text()),
    }
}
