//! When two documents show the same picture: equal but for numbers that differ by less than the eye can see.

/// Largest difference of two numbers, in pixels: `sin` and `cos` differ between machines, pictures do not.
const PIXELS: f64 = 0.01;

/// Whether two SVG documents are equal, numbers being compared with a tolerance of a hundredth of a pixel.
///
/// Colours differ by whole numbers, so they are compared exactly.
#[must_use]
pub fn same_picture(a: &str, b: &str) -> bool {
    let (mut a, mut b) = (Runs(a), Runs(b));
    loop {
        match (a.next(), b.next()) {
            (None, None) => return true,
            (Some(x), Some(y)) if same_run(x, y) => {}
            _ => return false,
        }
    }
}

fn same_run(a: &str, b: &str) -> bool {
    a == b
        || matches!((a.parse::<f64>(), b.parse::<f64>()), (Ok(x), Ok(y)) if (x - y).abs() <= PIXELS)
}

/// The longest pieces of a text that are all number or all something else.
struct Runs<'a>(&'a str);

impl<'a> Iterator for Runs<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let numeric = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
        let kind = numeric(self.0.chars().next()?);
        let end = self.0.find(|c| numeric(c) != kind).unwrap_or(self.0.len());
        let (run, rest) = self.0.split_at(end);
        self.0 = rest;
        Some(run)
    }
}

#[cfg(test)]
mod tests {
    use super::same_picture;

    #[test]
    fn numbers_may_differ_a_little() {
        assert!(same_picture(
            "<path d=\"M1.234 -5Z\"/>",
            "<path d=\"M1.235 -5.001Z\"/>"
        ));
        assert!(!same_picture(
            "<path d=\"M1.234 5Z\"/>",
            "<path d=\"M1.254 5Z\"/>"
        ));
    }

    #[test]
    fn everything_else_is_exact() {
        assert!(!same_picture("#1f4e8c", "#1f4e8d"));
        assert!(!same_picture("#1f4e81", "#1f4e82"));
        assert!(!same_picture("<a/>", "<b/>"));
        assert!(!same_picture("<a/>", "<a/><a/>"));
        assert!(!same_picture("M1 2", "M1"));
    }
}
