//! The lossless tree: what it looks like, and promises that hold for any text.

use crate::soup;
use proptest::prelude::*;
use scenelang_base::TextRange;
use scenelang_lang::ast::StmtKind;
use scenelang_lang::chunk::cut;
use scenelang_lang::parse::parse_file;
use scenelang_lang::syntax::{
    self, NodeKind, SyntaxKind, SyntaxNode, Tree, bodies, context_at, range_of, statement_at, statement_tree,
};
use scenelang_lang::token::Kind;
use std::collections::BTreeSet;

/// The texts whose trees stand in `snapshots/`.
const SHOWN: [(&str, &str); 5] = [
    ("declaration", "// before\n/// A lamp\n/// on a table.\n@req(\"light\")\nobject lamp[2]; // after\n"),
    ("assertion", "assert (a.pos).x <-1 and forall c in chair: near(c, a, 30cm) or not c[i + 1].top > 2;"),
    ("definition", "predicate p(Object a, Number d) := count(x in objects where .color = \"red\": x) >= d;"),
    (
        "broken",
        "assert near(lamp, (b.pos.\nobject a, b[2];\nlamp.pos <- vec3(1,\nlamp.color <- \"red;\nprefer x => # y.z;",
    ),
    ("odd", "\u{feff}a <- 1 object b;; /// nothing\n@req(\"x\")"),
];

#[test]
fn trees_look_like_this() {
    for (name, text) in SHOWN {
        insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
            insta::assert_snapshot!(format!("tree-{name}"), Tree(&syntax::parse(text)));
        });
    }
}

/// What holds for every text.
fn check(text: &str) {
    let tree = syntax::parse(text);
    assert_eq!(tree.to_string(), text);
    assert_eq!(tree.kind(), SyntaxKind::Node(NodeKind::File));

    // Leaves follow one another, none is empty; nodes are not empty.
    let mut at = 0;
    for element in tree.descendants_with_tokens() {
        let range = range_of(&element);
        assert!(!range.is_empty() || text.is_empty(), "{element:?} of {text:?}");
        if element.as_token().is_some() {
            assert_eq!(range.start, at, "{text:?}");
            at = range.end;
        }
    }
    assert_eq!(at as usize, text.len());

    // The file is what its statements are, and what stands between them.
    let chunks = cut(text);
    let statements: Vec<SyntaxNode> = tree.children().collect();
    assert_eq!(statements.len(), chunks.chunks.len());
    for (node, chunk) in statements.iter().zip(&chunks.chunks) {
        assert_eq!(range_of(&node.clone().into()), chunk.range);
        assert_eq!(*node.green(), *statement_tree(&text[chunk.range.bytes()]), "{text:?}");
    }
    let between = tree.children_with_tokens().filter_map(|e| e.into_token()?.kind().token());
    for kind in between {
        assert!(kind.is_trivia() || kind == Kind::Bom, "{kind:?} of {text:?}");
    }

    // Every statement of the typed tree is said by a node in its place.
    let places: BTreeSet<TextRange> = statements.iter().flat_map(bodies).map(|body| range_of(&body.into())).collect();
    for (offset, stmt) in &parse_file(text).statements {
        let place = stmt.range.shifted(*offset);
        let among = places.iter().any(|p| p.start <= place.start && place.end <= p.end);
        assert!(among, "{stmt:?} at {place:?} is not among {places:?} of {text:?}");
    }
    for (offset, _) in text.char_indices().chain([(text.len(), ' ')]) {
        let context = context_at(&tree, offset as u32);
        assert!(context.word.start <= offset as u32 && offset as u32 <= context.word.end);
        let _ = statement_at(&tree, offset as u32);
    }
}

/// In a program that parses, every part of the typed tree is a node: one, in its place, of its kind.
fn check_parts(text: &str) {
    let tree = syntax::parse(text);
    let nodes: Vec<(TextRange, NodeKind)> =
        tree.descendants().filter_map(|n| Some((range_of(&n.clone().into()), n.kind().node()?))).collect();
    let one = |range: TextRange, kind: NodeKind| {
        let found = nodes.iter().filter(|n| **n == (range, kind)).count();
        assert_eq!(found, 1, "{kind:?} at {range:?} of {text:?}\n{}", Tree(&tree));
    };
    for (offset, stmt) in &parse_file(text).statements {
        let at = |range: TextRange| range.shifted(*offset);
        stmt.exprs.iter().for_each(|e| one(at(e.range), NodeKind::from(&e.kind)));
        match &stmt.kind {
            StmtKind::Declare { name, .. } => one(at(name.range), NodeKind::Name),
            StmtKind::Assign { target, .. } => one(at(*target), NodeKind::Path),
            StmtKind::Predicate { name, params, .. } => {
                one(at(name.range), NodeKind::Name);
                params.iter().for_each(|p| one(at(p.ty_range.cover(p.name.range)), NodeKind::Parameter));
            }
            _ => {}
        }
        one(at(stmt.range), NodeKind::from(&stmt.kind));
        let attributes = tree.descendants().filter(|n| {
            n.kind() == SyntaxKind::Node(NodeKind::Requirement)
                && stmt.requirements.iter().any(|(_, r)| {
                    let node = range_of(&n.clone().into());
                    node.start < at(*r).start && at(*r).end < node.end
                })
        });
        assert_eq!(attributes.count(), stmt.requirements.len(), "{text:?}");
    }
}

/// Nesting up to the limit and beyond it: no stack is lost.
#[test]
fn deep_statements() {
    for n in [990, 20_000] {
        for (open, close) in [("(", ")"), ("f(", ")"), ("not ", ""), ("-", ""), ("a[", "]"), ("a + (", ")"), ("(", "")]
        {
            let text = format!("assert {}a{};", open.repeat(n), close.repeat(n));
            let tree = syntax::parse(&text);
            assert_eq!(tree.to_string(), text);
            assert!(!Tree(&tree).to_string().is_empty());
            let _ = context_at(&tree, text.len() as u32 / 2);
        }
    }
    for text in [format!("assert a{}", ".b".repeat(20_000)), "a ".repeat(50_000), "(]".repeat(50_000)] {
        assert_eq!(syntax::parse(&text).to_string(), text);
    }
}

#[test]
fn every_prefix_of_the_fixtures_has_a_tree() {
    for (_, text) in crate::syntax::fixtures() {
        for (end, _) in text.char_indices().step_by(7) {
            check(&text[text[..end].rfind("\n\n").unwrap_or(0)..end]);
        }
        check(&text);
    }
}

proptest! {
    #[test]
    fn programs_have_nodes_for_their_parts(text in soup::program()) {
        check(&text);
        check_parts(&text);
    }

    #[test]
    fn any_words_have_a_tree(text in soup::soup()) {
        check(&text);
    }

    #[test]
    fn any_bytes_have_a_tree(bytes in prop::collection::vec(any::<u8>(), 0..80)) {
        check(&String::from_utf8_lossy(&bytes));
    }
}
