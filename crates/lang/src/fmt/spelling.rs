//! How the formatter writes tokens, and which of them it sets apart.

use crate::parse::words::{ends_value, is_constructor};
use crate::token::Kind;

/// The text of a token: the first of the spellings that mean the same.
pub fn spelling(kind: Kind, text: &str) -> &str {
    match kind {
        Kind::And => "and",
        Kind::Or => "or",
        Kind::Not => "not",
        Kind::Arrow | Kind::ArrowSign => "<-",
        Kind::Eq => "=",
        Kind::Ne => "!=",
        Kind::Le => "<=",
        Kind::Ge => ">=",
        _ => text,
    }
}

/// Whether a blank stands between two tokens on one line. `sign`: the first is a minus sign, not an operator.
pub fn blank_between(first: Kind, sign: bool, second: Kind) -> bool {
    use Kind::*;
    match (first, second) {
        (LParen | LBracket | Dot | DotDot, _) | (_, RParen | RBracket | Comma | Semi | Colon | DotDot) => false,
        (Minus, _) if sign => false,
        (_, Dot | LBracket) => !ends_value(first),
        (_, LParen) => !calls(first),
        _ => true,
    }
}

/// Whether `(` after this token begins its arguments.
fn calls(kind: Kind) -> bool {
    use Kind::*;
    is_constructor(kind) || matches!(kind, Ident | Count | AllowCollide | AllowOutside | AllowFloat | Req)
}
