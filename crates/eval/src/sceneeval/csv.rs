//! Tables of comma-separated values (RFC 4180): fields with commas, line breaks and doubled quotation marks in them.

/// A row of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CsvRow {
    /// The line that it begins in, from 1.
    pub line: usize,
    pub fields: Vec<String>,
}

/// Reads a table. Empty lines are no rows.
///
/// # Errors
/// A quotation mark that is never closed, or something between a closing one and the next comma: with its line.
pub fn read(text: &str) -> Result<Vec<CsvRow>, String> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut rows = Vec::new();
    let mut chars = text.chars().peekable();
    let mut line = 1;
    while chars.peek().is_some() {
        let mut row = CsvRow { line, fields: Vec::new() };
        loop {
            let (field, ends) = field(&mut chars, &mut line)?;
            row.fields.push(field);
            if ends {
                break;
            }
        }
        if row.fields.iter().any(|field| !field.is_empty()) {
            rows.push(row);
        }
    }
    Ok(rows)
}

/// The next field, and whether its row ends with it.
fn field(chars: &mut std::iter::Peekable<std::str::Chars<'_>>, line: &mut usize) -> Result<(String, bool), String> {
    let mut out = String::new();
    let quoted = chars.next_if_eq(&'"').is_some();
    if quoted {
        let opened = *line;
        loop {
            match chars.next() {
                None => return Err(format!("line {opened}: a quotation mark is never closed")),
                Some('"') if chars.next_if_eq(&'"').is_some() => out.push('"'),
                Some('"') => break,
                Some(c) => {
                    *line += usize::from(c == '\n');
                    out.push(c);
                }
            }
        }
    }
    loop {
        match chars.next() {
            None => return Ok((out, true)),
            Some(',') => return Ok((out, false)),
            Some('\r') if chars.peek() == Some(&'\n') => {}
            Some('\n') => {
                *line += 1;
                return Ok((out, true));
            }
            Some(c) if quoted => {
                return Err(format!("line {line}: expected a comma after the closing quotation mark, found {c:?}"));
            }
            Some(c) => out.push(c),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_and_lines() {
        let rows = read("\u{feff}a,b\r\n1,\"x, \"\"y\"\"\nz\"\n\n2,\n3,it's 5\" wide").unwrap();
        let found: Vec<_> = rows.iter().map(|r| (r.line, r.fields.join("|"))).collect();
        let want = [(1, "a|b"), (2, "1|x, \"y\"\nz"), (5, "2|"), (6, "3|it's 5\" wide")];
        assert_eq!(found, want.map(|(n, text)| (n, text.to_owned())));
        assert_eq!(read(""), Ok(vec![]));
    }

    #[test]
    fn what_is_broken_has_a_line() {
        assert_eq!(read("a\nb,\"c\n\n"), Err("line 2: a quotation mark is never closed".into()));
        assert_eq!(
            read("\"a\nb\"c"),
            Err("line 2: expected a comma after the closing quotation mark, found 'c'".into())
        );
    }
}
