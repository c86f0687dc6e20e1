//! The lossless syntax tree: every byte of a file, blanks and comments and stray characters too, in exactly one leaf.
//!
//! The tree is made from the tokens and from the ranges of the typed tree ([`crate::ast`]), so there is one parser, and
//! a node stands exactly where the typed tree says. A statement that does not parse is an [`NodeKind::Error`] node with
//! all its tokens, in which names, calls, member accesses and brackets, open ones too, are still nodes: half a
//! statement is what an editor has to stand on.
//!
//! The tree of a statement depends on the statement's text alone and is shared, not copied, when a file's tree is put
//! together ([`file_of`]); so a database can keep it while the text around it changes.
//!
//! | file | what it does |
//! |---|---|
//! | `kind` | kinds of nodes and leaves |
//! | `build` | tokens and ranges → tree |
//! | `outline` | which ranges of a statement are nodes |
//! | `fragments` | the same for tokens that are no statement |
//! | `context` | what stands, or could stand, at an offset: for completion and signature help |
//! | `print` | the tree as text |

mod build;
mod context;
mod fragments;
mod kind;
mod outline;
mod print;

pub use build::{file, file_of, statement_tree};
pub use context::{CallSite, Context, Expects, context_at};
pub use kind::{NodeKind, SceneLanguage, SyntaxKind};
pub use print::Tree;
pub use rowan::{Direction, GreenNode, NodeOrToken, TokenAtOffset, WalkEvent};

use scenelang_base::TextRange;

/// A node in its place.
pub type SyntaxNode = rowan::SyntaxNode<SceneLanguage>;
/// A leaf in its place.
pub type SyntaxToken = rowan::SyntaxToken<SceneLanguage>;
/// A node or a leaf.
pub type SyntaxElement = rowan::SyntaxElement<SceneLanguage>;

/// The tree of a text.
pub fn parse(text: &str) -> SyntaxNode {
    SyntaxNode::new_root(file(text))
}

/// The place of an element, relative to the root of its tree.
pub fn range_of(element: &SyntaxElement) -> TextRange {
    from_rowan(element.text_range())
}

fn from_rowan(range: rowan::TextRange) -> TextRange {
    TextRange { start: range.start().into(), end: range.end().into() }
}

/// The statement that holds the byte at an offset or, if none does, ends there.
pub fn statement_at(root: &SyntaxNode, offset: u32) -> Option<SyntaxNode> {
    let offset = rowan::TextSize::from(offset).min(root.text_range().end());
    let at = root.token_at_offset(offset);
    let statement =
        |token: SyntaxToken| token.parent_ancestors().find(|node| node.kind() == SyntaxKind::Node(NodeKind::Statement));
    at.clone().right_biased().and_then(statement).or_else(|| at.left_biased().and_then(statement))
}

/// What a statement says: usually one node, several where a `;` is missing, none where there is only a comment.
pub fn bodies(statement: &SyntaxNode) -> impl Iterator<Item = SyntaxNode> + use<> {
    statement.children().filter(|node| node.kind().node().is_some_and(NodeKind::is_statement))
}
