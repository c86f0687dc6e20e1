//! What each token is, for colours: words of the language by their kind, names by what they stand for.

use crate::Snapshot;
use crate::names::{Occurrence, Role, Symbol, occurrences};
use scenelang_base::TextRange;
use scenelang_lang::db::Cancelled;
use scenelang_lang::hir::LocalKind;
use scenelang_lang::items::ItemKind;
use scenelang_lang::token::{Class, Kind, lex};
use scenelang_lang::types::Ty;

macro_rules! legend {
    ($($name:ident $word:literal)*) => {
        /// What a token is to a reader.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum TokenType { $($name),* }
        /// The words of the protocol for these, in the same order.
        pub const TYPES: &[&str] = &[$($word),*];
    };
}

legend! {
    Namespace "namespace" Type "type" Class "class" Parameter "parameter" Variable "variable" Property "property"
    EnumMember "enumMember" Function "function" Keyword "keyword" Comment "comment" String "string" Number "number"
    Operator "operator" Decorator "decorator"
}

/// Words of the protocol for modifiers, by their bit.
pub const MODIFIERS: &[&str] = &["declaration", "modification", "documentation", "defaultLibrary", "readonly"];
const DECLARATION: u32 = 1;
const MODIFICATION: u32 = 2;
const DOCUMENTATION: u32 = 4;
const LIBRARY: u32 = 8;
const READONLY: u32 = 16;

/// A coloured token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// Its bytes.
    pub range: TextRange,
    pub ty: TokenType,
    /// Bits of [`MODIFIERS`].
    pub modifiers: u32,
}

/// The coloured tokens of the main file, in order; those that touch a range, if one is given.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn tokens(snapshot: &Snapshot, within: Option<TextRange>) -> Result<Vec<Token>, Cancelled> {
    let text = snapshot.text();
    let names = occurrences(snapshot, snapshot.main())?;
    let mut names = names.iter().peekable();
    let mut out = Vec::new();
    for token in lex(text) {
        while names.next_if(|o| o.range.end <= token.range.start).is_some() {}
        let name = names.peek().filter(|o| o.range == token.range);
        let seen = within.is_none_or(|r| token.range.start < r.end && r.start < token.range.end);
        let found = match name {
            Some(name) => of_name(name),
            None => of_kind(token.kind, &text[token.range.bytes()]),
        };
        if let Some((ty, modifiers)) = found.filter(|_| seen) {
            out.push(Token { range: token.range, ty, modifiers });
        }
    }
    Ok(out)
}

fn of_name(name: &Occurrence) -> Option<(TokenType, u32)> {
    let role = match name.role {
        Role::Declares => DECLARATION,
        Role::Writes => MODIFICATION,
        Role::Reads => 0,
    };
    Some(match &name.symbol {
        Symbol::Item(_, ItemKind::Object | ItemKind::Array(_)) => (TokenType::Class, role),
        Symbol::Item(_, ItemKind::Region) => (TokenType::Namespace, role),
        Symbol::Item(_, ItemKind::Variable(_)) => (TokenType::Variable, role),
        Symbol::Local { kind: LocalKind::Parameter, .. } => (TokenType::Parameter, role),
        Symbol::Local { kind: LocalKind::Variable, .. } => (TokenType::Variable, role | READONLY),
        Symbol::Predicate(_) => (TokenType::Function, role),
        Symbol::Library(_) | Symbol::BuiltIn(_) => (TokenType::Function, role | LIBRARY),
        Symbol::Property(Ty::Object | Ty::Region, _) => (TokenType::Property, role),
        Symbol::Property(..) | Symbol::Component => (TokenType::Property, role),
        Symbol::Side => (TokenType::EnumMember, role),
        Symbol::AllObjects | Symbol::AllRooms => (TokenType::Class, LIBRARY),
    })
}

fn of_kind(kind: Kind, text: &str) -> Option<(TokenType, u32)> {
    Some(match kind.class() {
        Class::Comment => (TokenType::Comment, 0),
        Class::Documentation => (TokenType::Comment, DOCUMENTATION),
        Class::Number => (TokenType::Number, 0),
        Class::Text => (TokenType::String, 0),
        Class::Declaration | Class::Keyword | Class::Logic => (TokenType::Keyword, 0),
        Class::Type => (TokenType::Type, 0),
        Class::Function => (TokenType::Function, LIBRARY),
        Class::Constant => (TokenType::Keyword, 0),
        Class::Attribute => (TokenType::Decorator, 0),
        Class::Comparison | Class::Arithmetic | Class::Range | Class::Assignment => (TokenType::Operator, 0),
        // Contextual words are names to the lexer.
        Class::Name => match text {
            "prefer" | "weight" | "allowFloat" | "predicate" | "import" | "forall" | "exists" | "count" | "in"
            | "where" | "implies" => (TokenType::Keyword, 0),
            "Object" | "Region" | "Objects" | "String" => (TokenType::Type, 0),
            _ => return None,
        },
        Class::Blank | Class::Accessor | Class::Separator | Class::Terminator | Class::Bracket => return None,
        Class::Error if kind == Kind::OpenComment => (TokenType::Comment, 0),
        Class::Error if matches!(kind, Kind::OpenStr | Kind::OddQuotes) => (TokenType::String, 0),
        Class::Error => return None,
    })
}
