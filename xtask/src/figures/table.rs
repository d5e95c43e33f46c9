//! Summaries: small tables of text, columns aligned.

use std::fmt;

/// A table with a title.
#[derive(Clone, Debug)]
pub struct Table {
    title: String,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with its header.
    pub fn new<C: Into<String>>(title: &str, header: impl IntoIterator<Item = C>) -> Self {
        Self {
            title: title.to_owned(),
            rows: Vec::new(),
        }
        .row(header)
    }

    /// The same with one more row.
    #[must_use]
    pub fn row<C: Into<String>>(mut self, cells: impl IntoIterator<Item = C>) -> Self {
        self.rows.push(cells.into_iter().map(Into::into).collect());
        self
    }

    fn widths(&self) -> Vec<usize> {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |column| {
            self.rows
                .iter()
                .filter_map(|row| row.get(column))
                .map(|cell: &String| cell.chars().count())
                .max()
        };
        (0..columns)
            .map(|column| width(column).unwrap_or(0))
            .collect()
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.title)?;
        let widths = self.widths();
        for (k, row) in self.rows.iter().enumerate() {
            let line: Vec<String> = row
                .iter()
                .zip(&widths)
                .map(|(cell, width)| format!("{cell:<width$}"))
                .collect();
            writeln!(f, "{}", line.join("  ").trim_end())?;
            if k == 0 {
                let rule: Vec<String> = widths.iter().map(|&width| "-".repeat(width)).collect();
                writeln!(f, "{}", rule.join("  "))?;
            }
        }
        Ok(())
    }
}

/// A number with commas between thousands, as the papers print it.
pub(super) fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{Table, grouped};

    #[test]
    fn thousands_are_parted_by_commas() {
        let texts = [0, 999, 1000, 14_670, 1_000_000].map(grouped);
        assert_eq!(texts, ["0", "999", "1,000", "14,670", "1,000,000"]);
    }

    #[test]
    fn columns_are_as_wide_as_their_widest_cell() {
        let table = Table::new("Angles", ["", "paper", "ours"]).row(["smallest", "46°", "45.7°"]);
        assert_eq!(
            table.to_string(),
            "Angles\n          paper  ours\n--------  -----  -----\nsmallest  46°    45.7°\n"
        );
    }
}
