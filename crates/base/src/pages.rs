//! The pages of the codes: what each says, why, an example, what to do. They are chapters of the language book, and
//! stand in the binary.

use crate::Code;
use crate::codes::PAGES;

impl Code {
    /// Its page, in Markdown. Links in it are relative to the page's place in the book.
    pub fn page(self) -> &'static str {
        PAGES.iter().find(|(code, _)| *code == self).map_or("", |(_, page)| page)
    }

    /// The first paragraph of its page: what it says, in a sentence or two of plain text.
    pub fn summary(self) -> String {
        let lines = self.page().lines().skip(1).skip_while(|line| line.is_empty());
        lines.take_while(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
    }

    /// The code that is written so, in either case.
    pub fn find(text: &str) -> Option<Self> {
        PAGES.iter().map(|(code, _)| *code).find(|code| code.as_str().eq_ignore_ascii_case(text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::codes::{self, ALL};

    #[test]
    fn every_page_is_that_of_its_code() {
        for (code, title) in ALL {
            assert!(code.page().starts_with(&format!("# {code}: {title}\n")), "{code}");
            assert!(code.summary().ends_with(['.', ':']) && !code.summary().contains("]("), "{}", code.summary());
        }
    }

    #[test]
    fn codes_are_found_by_their_text() {
        assert_eq!(Code::find("e0201"), Some(codes::E0201));
        assert_eq!(Code::find("E9999"), None);
    }
}
