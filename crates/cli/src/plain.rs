//! Pages of the book for a terminal: without the marks that the tests of the book read, links and numbers of decisions.

/// A page or a section as a person reads it.
pub fn page(text: &str) -> String {
    let mut out = String::new();
    let mut is_code = false;
    for line in text.lines() {
        let fence = line.strip_prefix("```");
        // Behind the language stands what the tests expect.
        let shown = match fence {
            Some(info) => format!("```{}", info.split(' ').next().unwrap_or_default()),
            None if is_code => marked(line),
            None => unlinked(line),
        };
        is_code ^= fence.is_some();
        out.push_str(shown.trim_end());
        out.push('\n');
    }
    out
}

/// A line of a program: `//~ E0201:8` says a code and a column, `//= holds` a result.
fn marked(line: &str) -> String {
    let Some((code, mark)) = line.split_once("//~ ") else { return line.replace("//= ", "// ") };
    let codes: Vec<&str> = mark.split(' ').filter_map(|mark| mark.split(':').next()).collect();
    format!("{code}// {}", codes.join(", "))
}

/// A line of text without the targets of its links and without `(**D49**)`.
fn unlinked(line: &str) -> String {
    let mut out = String::new();
    let mut rest = line;
    while let Some(at) = rest.find("](").or_else(|| rest.find("(**D")) {
        let (before, after) = rest.split_at(at);
        if let Some(target) = after.strip_prefix("](") {
            let Some(end) = target.find(')') else { break };
            match before.rfind('[') {
                // A page of the web can be followed, one of the book cannot.
                Some(open) if !target.starts_with("http") => {
                    out.push_str(&before[..open]);
                    out.push_str(&before[open + 1..]);
                }
                _ => out.push_str(&rest[..at + 2 + end + 1]),
            }
            rest = &target[end + 1..];
        } else {
            let Some(end) = after.find("**)") else { break };
            out.push_str(before.trim_end());
            rest = &after[end + 3..];
        }
    }
    out.push_str(rest);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_links_and_decisions_are_not_shown() {
        let text = "Lengths are in metres, see [units](../reference/units.md#m). (**D49**) More.\n\n\
            ```scene\nassert lmap.pos.y > 1; //~ E0201:8 E0301:9\nassert a; //= holds, margin 0.5 m\n```\n\n\
            ```json layout E0505:2:37\n{}\n```\n[site](https://example.org)\n";
        let shown = "Lengths are in metres, see units. More.\n\n\
            ```scene\nassert lmap.pos.y > 1; // E0201, E0301\nassert a; // holds, margin 0.5 m\n```\n\n\
            ```json\n{}\n```\n[site](https://example.org)\n";
        assert_eq!(page(text), shown);
    }
}
