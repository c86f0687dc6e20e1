//! Keys: from the environment, or from the keyring of the system by its own program; never shown, never written.

use std::fmt;
use std::process::{Command, Stdio};

/// What a key is filed under in a keyring.
const SERVICE: &str = "scenelang";

/// A key. It can be sent, and that is all.
#[derive(Clone, PartialEq, Eq)]
pub struct Key(String);

impl fmt::Debug for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Key(…)")
    }
}

impl Key {
    /// A key, if the text can be one: something, of visible ASCII characters.
    pub fn new(text: &str) -> Option<Self> {
        let text = text.trim();
        (!text.is_empty() && text.bytes().all(|b| b.is_ascii_graphic())).then(|| Self(text.to_owned()))
    }

    pub(super) fn from_environment(variable: &str) -> Option<Self> {
        Self::new(&std::env::var(variable).ok()?)
    }

    /// What the keyring has for the service `scenelang` and the provider as account. It is asked through the program that
    /// the system brings for that, so that nothing need be linked: `security` on macOS, `secret-tool` elsewhere.
    pub(super) fn from_keyring(provider: &str) -> Option<Self> {
        let (program, arguments): (&str, &[&str]) = if cfg!(target_os = "macos") {
            ("security", &["find-generic-password", "-s", SERVICE, "-a", provider, "-w"])
        } else {
            ("secret-tool", &["lookup", "service", SERVICE, "account", provider])
        };
        Self::from_program(program, arguments)
    }

    fn from_program(program: &str, arguments: &[&str]) -> Option<Self> {
        let said = Command::new(program).args(arguments).stdin(Stdio::null()).stderr(Stdio::null()).output().ok()?;
        said.status.success().then(|| String::from_utf8(said.stdout).ok()).flatten().and_then(|text| Self::new(&text))
    }

    /// The text of it, for a header.
    pub(super) fn reveal(&self) -> &str {
        &self.0
    }

    /// Takes the key out of what a server says: whoever echoes it must not get it into a message or a file.
    pub(super) fn redact(&self, bytes: Vec<u8>) -> Vec<u8> {
        let own = self.0.as_bytes();
        if !bytes.windows(own.len()).any(|w| w == own) {
            return bytes;
        }
        let mut out = Vec::with_capacity(bytes.len());
        let mut rest = &bytes[..];
        while let Some((first, more)) = rest.split_first() {
            if let Some(after) = rest.strip_prefix(own) {
                out.extend_from_slice(b"[key]");
                rest = after;
            } else {
                out.push(*first);
                rest = more;
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_is_not_shown() {
        let key = Key::new(" sk-secret\n").unwrap();
        assert_eq!(format!("{key:?} {:?}", Some(&key)), "Key(…) Some(Key(…))");
        assert_eq!(key.reveal(), "sk-secret");
        for bad in ["", "  ", "two words", "line\nbreak", "schlüssel"] {
            assert_eq!(Key::new(bad), None, "{bad:?}");
        }
    }

    #[test]
    fn an_echoed_key_is_taken_out() {
        let key = Key::new("abc").unwrap();
        for (said, wanted) in [("ab", "ab"), ("abcabc", "[key][key]"), ("key: ababc.", "key: ab[key]."), ("", "")] {
            assert_eq!(key.redact(said.into()), wanted.as_bytes(), "{said}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_keyring_is_asked_by_its_program() {
        assert_eq!(Key::from_program("sh", &["-c", "echo stored"]), Key::new("stored"));
        assert_eq!(Key::from_program("sh", &["-c", "echo stored; exit 1"]), None);
        assert_eq!(Key::from_program("sh", &["-c", "true"]), None);
        assert_eq!(Key::from_program("no-such-program-anywhere", &[]), None);
    }
}
