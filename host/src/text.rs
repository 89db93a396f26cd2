//! Text from files, shortened and escaped for messages.

/// The first characters of a text, for a message.
pub(crate) fn excerpt(text: &str) -> String {
    shorten(text, 40)
}

/// Cuts a text to `length` characters and replaces control characters.
pub(crate) fn shorten(text: &str, length: usize) -> String {
    let text = text.trim();
    let visible = |c: char| if c.is_control() { '\u{fffd}' } else { c };
    let short: String = text.chars().take(length).map(visible).collect();
    match text.chars().nth(length) {
        Some(_) => short + "…",
        None => short,
    }
}

/// A count with its noun: 1 component, 1,200 components.
pub(crate) fn things(count: usize, thing: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{} {thing}{plural}", grouped(count))
}

/// A count with a comma between thousands.
pub(crate) fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn excerpts_cut_between_characters() {
        assert_eq!(excerpt("  plain \n"), "plain");
        let long = "ä".repeat(50);
        assert_eq!(excerpt(&long), format!("{}…", "ä".repeat(40)));
    }
}
