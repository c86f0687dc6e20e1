//! The tree as text, one element a line: `Member@7..15`, and leaves with what they say: `Ident@7..11 "lamp"`.

use super::{NodeOrToken, SyntaxNode, WalkEvent, range_of};
use std::fmt;

/// A tree, to be written out. Ranges are bytes from the start of the tree's root.
pub struct Tree<'a>(pub &'a SyntaxNode);

impl fmt::Display for Tree<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut depth = 0;
        for event in self.0.preorder_with_tokens() {
            let element = match event {
                WalkEvent::Enter(element) => element,
                WalkEvent::Leave(element) => {
                    depth -= usize::from(element.as_node().is_some());
                    continue;
                }
            };
            let range = range_of(&element);
            write!(f, "{:1$}{2}@{3}..{4}", "", 2 * depth, element.kind(), range.start, range.end)?;
            match element {
                NodeOrToken::Node(_) => depth += 1,
                NodeOrToken::Token(token) => write!(f, " {:?}", token.text())?,
            }
            writeln!(f)?;
        }
        Ok(())
    }
}
