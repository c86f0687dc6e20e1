//! A small document language, and its printer: text with places where a line may end.
//!
//! A group is printed on one line if it fits, else every line end that belongs to it directly is taken. Comments are
//! documents too: one that must end its line ends every group around it.

/// A piece of a document.
#[derive(Clone, Debug, PartialEq)]
pub enum Doc {
    /// Text without line breaks, printed as it is.
    Text(String),
    /// A blank, or the end of a line.
    Line,
    /// Nothing, or the end of a line.
    Soft,
    /// The end of a line.
    Hard,
    /// The end of a line and an empty one.
    Empty,
    Comment {
        /// Its text; a block comment may have several lines.
        text: String,
        /// It begins a line.
        own_line: bool,
        /// Nothing may follow it on its last line.
        ends_line: bool,
    },
    /// Two columns further right.
    Indent(Vec<Doc>),
    /// On one line if it fits.
    Group {
        /// Its parts.
        docs: Vec<Doc>,
        /// It holds something that ends a line for certain.
        forced: bool,
    },
}

impl Doc {
    pub fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }
    /// A group of documents.
    pub fn group(docs: Vec<Self>) -> Self {
        let forced = docs.iter().any(Self::forces);
        Self::Group { docs, forced }
    }
    fn forces(&self) -> bool {
        match self {
            Self::Text(_) | Self::Line | Self::Soft => false,
            Self::Hard | Self::Empty => true,
            Self::Comment { text, own_line, ends_line } => *own_line || *ends_line || text.contains('\n'),
            Self::Indent(docs) => docs.iter().any(Self::forces),
            Self::Group { forced, .. } => *forced,
        }
    }
}

/// Prints documents in lines of at most `width` characters, where they can be broken so.
pub fn print(docs: &[Doc], width: usize) -> String {
    let mut printer =
        Printer { width, out: String::new(), column: 0, pending: None, blank: false, after_comment: false };
    printer.print(docs);
    printer.out
}

#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Flat,
    Broken,
}

/// A line end to come.
#[derive(Clone, Copy, Default)]
struct Pending {
    /// With an empty line.
    empty: bool,
    /// How far in the next line begins; `None`: as far as what stands there says.
    indent: Option<usize>,
}

struct Printer {
    width: usize,
    out: String,
    column: usize,
    /// A line end that comes before whatever is printed next.
    pending: Option<Pending>,
    /// A blank goes before what is printed next.
    blank: bool,
    /// A comment was printed on this line: a blank goes before most of what follows.
    after_comment: bool,
}

impl Printer {
    fn print(&mut self, docs: &[Doc]) {
        let mut rest: Vec<(usize, Mode, &Doc)> = docs.iter().rev().map(|d| (0, Mode::Broken, d)).collect();
        while let Some((indent, mode, doc)) = rest.pop() {
            match doc {
                Doc::Text(text) => self.text(text, indent),
                Doc::Line | Doc::Soft if mode == Mode::Broken => self.end_line(false, Some(indent)),
                Doc::Line => self.blank |= self.pending.is_none(),
                Doc::Soft => {}
                Doc::Hard => self.end_line(false, Some(indent)),
                Doc::Empty => self.end_line(true, Some(indent)),
                Doc::Comment { text, own_line, ends_line } => {
                    if *own_line {
                        self.end_line(false, None);
                    }
                    self.comment(text, indent);
                    if *ends_line {
                        self.end_line(false, None);
                    }
                }
                Doc::Indent(docs) => rest.extend(docs.iter().rev().map(|d| (indent + 2, mode, d))),
                Doc::Group { docs, forced } => {
                    let flat = mode == Mode::Flat || !forced && self.fits(docs, &rest, indent);
                    let mode = if flat { Mode::Flat } else { Mode::Broken };
                    rest.extend(docs.iter().rev().map(|d| (indent, mode, d)));
                }
            }
        }
    }

    fn end_line(&mut self, empty: bool, indent: Option<usize>) {
        let before = self.pending.unwrap_or_default();
        self.pending = Some(Pending { empty: empty || before.empty, indent: indent.or(before.indent) });
        self.blank = false;
        self.after_comment = false;
    }

    /// Ends the line, if that is pending.
    fn start(&mut self, indent: usize) {
        if let Some(pending) = self.pending.take()
            && !self.out.is_empty()
        {
            let indent = pending.indent.unwrap_or(indent);
            self.out.truncate(self.out.trim_end_matches(' ').len());
            self.out.push_str(if pending.empty { "\n\n" } else { "\n" });
            self.out.extend(std::iter::repeat_n(' ', indent));
            self.column = indent;
        }
    }

    fn text(&mut self, text: &str, indent: usize) {
        if self.pending.is_some() {
            if text == " " {
                return;
            }
            self.start(indent);
        } else if self.blank || self.after_comment && !text.starts_with([')', ']', ',', ';', '.', ':', ' ']) {
            self.push(" ");
        }
        self.blank = false;
        self.after_comment = false;
        self.push(text);
    }

    fn comment(&mut self, text: &str, indent: usize) {
        if self.pending.is_some() {
            self.start(indent);
        } else if !self.out.is_empty() && !self.out.ends_with([' ', '(', '[']) {
            self.push(" ");
        }
        self.push(text);
        self.blank = false;
        self.after_comment = true;
    }

    fn push(&mut self, text: &str) {
        self.out.push_str(text);
        self.column = match text.rfind('\n') {
            Some(at) => text[at + 1..].chars().count(),
            None => self.column + text.chars().count(),
        };
    }

    /// Whether documents fit on the rest of the line, up to the next place where the line may end.
    fn fits(&self, docs: &[Doc], rest: &[(usize, Mode, &Doc)], indent: usize) -> bool {
        let column = self.pending.map_or(self.column, |pending| pending.indent.unwrap_or(indent));
        let Some(mut left) = self.width.checked_sub(column) else { return false };
        let mut todo: Vec<(Mode, &Doc)> = docs.iter().rev().map(|d| (Mode::Flat, d)).collect();
        let mut after = rest.iter().rev();
        loop {
            let Some((mode, doc)) = todo.pop().or_else(|| after.next().map(|(_, mode, doc)| (*mode, *doc))) else {
                return true;
            };
            let used = match doc {
                Doc::Text(text) => text.chars().count(),
                Doc::Line if mode == Mode::Flat => 1,
                Doc::Soft if mode == Mode::Flat => 0,
                Doc::Line | Doc::Soft | Doc::Hard | Doc::Empty => return true,
                Doc::Comment { own_line: true, .. } => return true,
                Doc::Comment { text, .. } if text.contains('\n') => return true,
                // What follows a comment that ends the line is on another one.
                Doc::Comment { ends_line: true, .. } => return true,
                Doc::Comment { text, .. } => text.chars().count() + 1,
                Doc::Indent(docs) => {
                    todo.extend(docs.iter().rev().map(|d| (mode, d)));
                    0
                }
                Doc::Group { docs, forced } => {
                    let mode = if *forced { Mode::Broken } else { mode };
                    todo.extend(docs.iter().rev().map(|d| (mode, d)));
                    0
                }
            };
            match left.checked_sub(used) {
                Some(now) => left = now,
                None => return false,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(items: &[&str]) -> Doc {
        let mut inner = vec![Doc::Soft];
        for (i, item) in items.iter().enumerate() {
            if i > 0 {
                inner.extend([Doc::text(","), Doc::Line]);
            }
            inner.push(Doc::text(*item));
        }
        Doc::group(vec![Doc::text("f("), Doc::Indent(inner), Doc::Soft, Doc::text(")")])
    }

    #[test]
    fn groups_break_only_where_they_must() {
        assert_eq!(print(&[list(&["a", "b"]), Doc::text(";")], 8), "f(a, b);");
        assert_eq!(print(&[list(&["a", "b"]), Doc::text(";")], 7), "f(\n  a,\n  b\n);");
        let outer = Doc::group(vec![list(&["a", "b"]), Doc::Line, list(&["c", "d"])]);
        assert_eq!(print(&[outer], 10), "f(a, b)\nf(c, d)");
    }

    #[test]
    fn comments_that_end_a_line_break_the_groups_around_them() {
        let comment = Doc::Comment { text: "// c".into(), own_line: false, ends_line: true };
        let group = Doc::group(vec![Doc::text("a"), comment, Doc::Line, Doc::text("b"), Doc::Line, Doc::text("c")]);
        assert_eq!(print(&[group], 80), "a // c\nb\nc");
    }
}
