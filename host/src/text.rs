//! Words from files, made fit for messages.

/// The first characters of a name, a word or a line, for a message.
pub(crate) fn excerpt(text: &str) -> String {
    shorten(text, 40)
}

/// Cuts a text to so many characters, and replaces those that a terminal would take for commands.
pub(crate) fn shorten(text: &str, length: usize) -> String {
    let text = text.trim();
    let visible = |c: char| if c.is_control() { '\u{fffd}' } else { c };
    let short: String = text.chars().take(length).map(visible).collect();
    match text.chars().nth(length) {
        Some(_) => short + "…",
        None => short,
    }
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
