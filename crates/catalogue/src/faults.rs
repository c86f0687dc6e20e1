//! What is said of files that cannot be used.

use scenelang_base::door::outside;
use scenelang_base::{Code, Diagnostic, codes};
use std::io::{self, ErrorKind};

/// Why a file cannot be used.
pub(crate) type Fault = Box<Diagnostic>;

pub(crate) fn fault(code: Code, message: impl Into<String>) -> Fault {
    Box::new(Diagnostic::without_place(code, message))
}

/// A model that is not what its format says.
pub(crate) fn broken(message: impl Into<String>) -> Fault {
    fault(codes::E0701, message)
}

/// A model beyond the limits.
pub(crate) fn beyond(message: impl Into<String>) -> Fault {
    fault(codes::E0702, message)
}

/// What the file system says.
pub(crate) fn unreadable(e: &io::Error) -> Fault {
    if let Some(refused) = outside(e) {
        return Box::new(
            Diagnostic::without_place(codes::E0703, "it leads outside of its folder").note(refused.advice()),
        );
    }
    let (code, say) = match e.kind() {
        ErrorKind::FileTooLarge => (codes::E0702, e.to_string()),
        ErrorKind::NotFound => (codes::E0001, "there is no such file".to_owned()),
        _ => (codes::E0001, e.to_string()),
    };
    fault(code, format!("it cannot be read: {say}"))
}
