//! `scenelang syntax`: the lossless tree of a file.

use super::write::Json;
use crate::args::{Inspect, Plain};
use crate::{FAILED, FINDINGS, GOOD};
use scenelang_base::{Diagnostic, TextRange};
use scenelang_lang::parse::parse_file;
use scenelang_lang::syntax::{self, NodeOrToken, SyntaxElement, SyntaxNode, Tree, WalkEvent, range_of};

/// The value of the member `format`.
const FORMAT: &str = "scenelang.syntax/1";

/// Prints the tree; errors of syntax go to standard error and make the exit code 1.
pub fn run(args: &Inspect) -> u8 {
    let Some((sources, id)) = super::read(&args.file) else { return FAILED };
    let file = sources.get(id);
    let tree = syntax::parse(file.text());
    match args.format {
        Plain::Text => super::print(Tree(&tree)),
        Plain::Json => super::print(format_args!("{}\n", json(file.name(), &tree))),
    }
    let errors: Vec<Diagnostic> = parse_file(file.text())
        .diagnostics
        .into_iter()
        .filter(Diagnostic::is_error)
        .map(|d| d.map_places(|range: TextRange| range.in_file(id)))
        .collect();
    if super::show(&errors, &sources) { FINDINGS } else { GOOD }
}

fn json(file: &str, tree: &SyntaxNode) -> String {
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
