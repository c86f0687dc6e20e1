//! A plain table for terminals: columns as wide as their content, numbers to the right.

/// Rows with the same number of cells each; the first is the head.
pub struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    pub fn new(head: &[&str]) -> Self {
        Self { rows: vec![head.iter().map(|s| (*s).to_owned()).collect()] }
    }
    /// Adds a row.
    pub fn row<const N: usize>(&mut self, cells: [String; N]) {
        self.rows.push(Vec::from(cells));
    }
    /// The text, each line indented by two blanks.
    pub fn render(&self) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |c: usize| self.rows.iter().filter_map(|r| r.get(c)).map(|s| s.chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns).map(width).collect();
        let mut out = String::new();
        for (i, row) in self.rows.iter().enumerate() {
            let mut line = String::new();
            for (c, cell) in row.iter().enumerate() {
                let pad = " ".repeat(widths[c] - cell.chars().count());
                let number = is_number(cell) && i > 0;
                line += "  ";
                line += &if number { format!("{pad}{cell}") } else { format!("{cell}{pad}") };
            }
            out += line.trim_end();
            out.push('\n');
            if i == 0 {
                let rule: Vec<String> = widths.iter().map(|w| "─".repeat(*w)).collect();
                out += &format!("  {}\n", rule.join("  "));
            }
        }
        out
    }
}

/// A number, with or without a unit.
fn is_number(cell: &str) -> bool {
    cell.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit()) && cell.split(' ').count() <= 2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up() {
        let mut t = Table::new(&["stage", "seconds"]);
        t.row(["solve".into(), "0.5".into()]);
        t.row(["é".into(), "10.25".into()]);
        assert_eq!(t.render(), "  stage  seconds\n  ─────  ───────\n  solve      0.5\n  é        10.25\n");
        let mut t = Table::new(&["how", "margin"]);
        t.row(["0.5 m right".into(), "-0.37 m".into()]);
        t.row(["up".into(), "12.00 m".into()]);
        assert_eq!(
            t.render(),
            "  how          margin\n  ───────────  ───────\n  0.5 m right  -0.37 m\n  up           12.00 m\n"
        );
    }
}
