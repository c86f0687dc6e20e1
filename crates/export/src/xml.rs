//! XML as MJCF and SDF need it: elements, attributes, text.

use std::fmt::Write;

/// A document as it grows.
#[derive(Debug)]
pub(crate) struct Xml {
    out: String,
    open: Vec<&'static str>,
}

/// Name and value of an attribute.
pub(crate) type Attribute<'a> = (&'static str, &'a str);

impl Xml {
    /// A document without its root.
    pub fn new() -> Self {
        Self { out: "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".into(), open: Vec::new() }
    }

    /// Begins an element that [`Xml::end`] ends.
    pub fn begin(&mut self, tag: &'static str, attributes: &[Attribute<'_>]) {
        self.tag(tag, attributes);
        self.out.push_str(">\n");
        self.open.push(tag);
    }

    /// Ends the element that began last.
    pub fn end(&mut self) {
        if let Some(tag) = self.open.pop() {
            self.indent();
            let _ = writeln!(self.out, "</{tag}>");
        }
    }

    /// An element without content.
    pub fn empty(&mut self, tag: &'static str, attributes: &[Attribute<'_>]) {
        self.tag(tag, attributes);
        self.out.push_str("/>\n");
    }

    /// An element with a text in it.
    pub fn text(&mut self, tag: &'static str, text: &str) {
        self.tag(tag, &[]);
        let _ = writeln!(self.out, ">{}</{tag}>", escaped(text));
    }

    pub fn comment(&mut self, text: &str) {
        self.indent();
        let _ = writeln!(self.out, "<!-- {} -->", escaped(text).replace("--", "- -"));
    }

    /// The document; every element must have ended.
    pub fn finish(self) -> Vec<u8> {
        debug_assert!(self.open.is_empty(), "{:?} are open", self.open);
        self.out.into_bytes()
    }

    fn tag(&mut self, tag: &str, attributes: &[Attribute<'_>]) {
        self.indent();
        let _ = write!(self.out, "<{tag}");
        for (name, value) in attributes {
            let _ = write!(self.out, " {name}=\"{}\"", escaped(value));
        }
    }

    fn indent(&mut self) {
        self.out.extend(std::iter::repeat_n("  ", self.open.len()));
    }
}

/// A text as XML can hold it: signs of its own as entities, and what it has no place for replaced by U+FFFD.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // Else a reader would make blanks of them in an attribute.
            '\n' => out.push_str("&#10;"),
            '\r' => out.push_str("&#13;"),
            '\t' => out.push_str("&#9;"),
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c if c < ' ' => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_nest_and_texts_are_escaped() {
        let mut xml = Xml::new();
        xml.begin("a", &[("name", "x\"<&>\n'")]);
        xml.text("b", "1 < 2\u{0}");
        xml.comment("a -- b");
        xml.empty("c", &[]);
        xml.end();
        let want = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a name=\"x&quot;&lt;&amp;&gt;&#10;'\">\n  \
                    <b>1 &lt; 2\u{fffd}</b>\n  <!-- a - - b -->\n  <c/>\n</a>\n";
        assert_eq!(String::from_utf8(xml.finish()).unwrap(), want);
    }
}
