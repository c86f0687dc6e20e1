//! Text as HTML can hold it.

/// A text in an element or in an attribute within double quotes. What a page may not contain becomes U+FFFD.
pub(super) fn escaped(text: &str) -> String {
    let allowed: String = text.chars().map(|c| if is_allowed(c) { c } else { '\u{fffd}' }).collect();
    crate::xml::escaped(&allowed)
}

/// Markup without what a page may not contain.
pub(super) fn clean(markup: &str) -> String {
    markup.chars().filter(|c| is_allowed(*c)).collect()
}

/// Whether a page may contain a character: no control character, nothing that is set apart for programs, and nothing that turns
/// the direction of the text after it.
fn is_allowed(c: char) -> bool {
    let is_set_apart = matches!(c, '\u{fdd0}'..='\u{fdef}') || u32::from(c) & 0xfffe == 0xfffe;
    let turns = matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    matches!(c, '\n' | '\t') || !(c.is_control() || is_set_apart || turns)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_breaks_out() {
        let text = "</td><script>alert('1')</script>\" onload=\"x\" &amp; \u{0}\u{7f}\u{85}\r\u{ffff}\u{202e}灯";
        let want = "&lt;/td&gt;&lt;script&gt;alert('1')&lt;/script&gt;&quot; onload=&quot;x&quot; &amp;amp; \
                    \u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}灯";
        assert_eq!(escaped(text), want);
        assert_eq!(clean("<b>\u{1}a\u{9f}</b>\n"), "<b>a</b>\n");
    }
}
