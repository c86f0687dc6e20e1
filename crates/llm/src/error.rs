//! Why there is no answer. Every text in an error is safe to print: on one line, of limited length, without keys.

use std::fmt;
use std::time::Duration;

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error {
    /// It cannot even be tried: an unknown provider, no key, a base URL that is none.
    Setup(String),
    /// No connection, or it broke.
    Unreachable(String),
    /// No complete answer within this time.
    TimedOut(Duration),
    /// The provider has had enough requests for now.
    Limited {
        /// How long it wants to be left alone.
        wait: Option<Duration>,
        said: String,
    },
    /// The provider has a problem of its own.
    Failed {
        /// The status of HTTP.
        status: u16,
        /// How long it wants to be left alone.
        wait: Option<Duration>,
        said: String,
    },
    /// The provider does not accept the request, and would not the next time.
    Refused {
        /// The status of HTTP.
        status: u16,
        said: String,
    },
    /// The provider does not know this part of a request; from now on it is left out.
    Unsupported(&'static str),
    /// The answer is larger than allowed (bytes).
    TooLarge(u64),
    /// The answer is not what was asked for.
    Malformed(String),
    /// The answer ends at the limit of tokens, in the middle.
    CutShort,
    /// The model, or a filter before it, does not want to answer.
    Declined(String),
    /// The budget is spent: which one.
    Spent(String),
    /// No network is to be used, and the answer is not in the cache.
    Offline,
    /// A recorded conversation has no answer to this.
    OffScript(String),
    /// Somebody ended it.
    Interrupted,
    /// A file could not be read or written.
    File(String),
    /// It was tried so often, and failed like this in the end.
    GaveUp(u32, Box<Error>),
}

impl Error {
    /// Whether the same request may succeed when it is made again.
    pub fn is_passing(&self) -> bool {
        matches!(
            self,
            Self::Unreachable(_)
                | Self::TimedOut(_)
                | Self::Limited { .. }
                | Self::Failed { .. }
                | Self::Unsupported(_)
                | Self::Malformed(_)
        )
    }
    /// How long the provider wants to be left alone.
    pub fn wait(&self) -> Option<Duration> {
        match self {
            Self::Limited { wait, .. } | Self::Failed { wait, .. } => *wait,
            _ => None,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Setup(why) | Self::OffScript(why) | Self::File(why) => f.write_str(why),
            Self::Unreachable(why) => write!(f, "the model cannot be reached: {why}"),
            Self::TimedOut(after) => write!(f, "the model gave no complete answer within {} s", after.as_secs_f64()),
            Self::Limited { said, .. } => write!(f, "the provider has received too many requests (429){}", Said(said)),
            Self::Failed { status, said, .. } => {
                write!(f, "the provider reports an internal error ({status}){}", Said(said))
            }
            Self::Refused { status: 401 | 403, said } => {
                write!(f, "the provider does not accept the key{}", Said(said))
            }
            Self::Refused { status, said } => write!(f, "the provider refuses the request ({status}){}", Said(said)),
            Self::Unsupported(part) => write!(f, "the model does not support `{part}`"),
            Self::TooLarge(limit) => write!(f, "the answer is larger than {limit} bytes"),
            Self::Malformed(why) => write!(f, "the answer does not have the expected form: {why}"),
            Self::CutShort => write!(f, "the answer was cut off at the token limit"),
            Self::Declined(why) => write!(f, "the model refused to answer{}", Said(why)),
            Self::Spent(budget) => write!(f, "the budget is used up: {budget}"),
            Self::Offline => write!(f, "the network is switched off and the answer is not in the cache"),
            Self::Interrupted => write!(f, "interrupted"),
            Self::GaveUp(tries, last) => write!(f, "{last}; tried {tries} times"),
        }
    }
}

impl std::error::Error for Error {}

/// What somebody said, if anything.
struct Said<'a>(&'a str);

impl fmt::Display for Said<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() { Ok(()) } else { write!(f, ": {}", self.0) }
    }
}

/// Text of others, made safe to print: one line, no control characters (they could command a terminal), no marks that
/// turn the direction of writing, at most so many characters.
pub fn plain(text: &str, most: usize) -> String {
    let turns = |c: char| matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let mut out = String::new();
    let mut words = 0;
    for c in text.chars().map(|c| if c.is_control() || turns(c) || c.is_whitespace() { ' ' } else { c }) {
        if c == ' ' && (out.is_empty() || out.ends_with(' ')) {
            continue;
        }
        if words == most {
            out.push('…');
            break;
        }
        out.push(c);
        words += 1;
    }
    out.truncate(out.trim_end().len());
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_of_others_stays_on_its_line() {
        for (text, most, wanted) in [
            ("as it is", 8, "as it is"),
            ("\u{1b}[31mred\u{1b}[0m\r\n\tnext", 99, "[31mred [0m next"),
            ("a\u{202e}b", 10, "a b"),
            ("  1234567890123", 10, "1234567890…"),
            ("äöüäöüäöüäöü", 10, "äöüäöüäöüä…"),
            ("\n\n", 10, ""),
        ] {
            assert_eq!(plain(text, most), wanted, "{text:?}");
        }
    }

    #[test]
    fn only_what_may_pass_is_tried_again() {
        let said = String::new;
        for error in [Error::Malformed(said()), Error::Limited { wait: None, said: said() }, Error::Unsupported("seed")]
        {
            assert!(error.is_passing(), "{error}");
        }
        let refused = Error::Refused { status: 401, said: said() };
        for error in [Error::Setup(said()), refused, Error::TooLarge(1), Error::CutShort, Error::Spent(said())] {
            assert!(!error.is_passing(), "{error}");
        }
    }
}
