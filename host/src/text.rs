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

/// The noun of a phrase in the plural, such as `vertices` or `faces with fewer than three corners`, for a count.
pub(crate) fn noun(count: u64, plural: &str) -> String {
    // The first word in the plural is the noun. Names, in quotes or brackets, have none.
    let is_plural = |word: &&str| word.len() > 3 && word.ends_with('s') && !word.ends_with("ss");
    let words = plural.split(['"', '(']).next().unwrap_or_default();
    let word = words.split(' ').find(is_plural).filter(|_| count == 1);
    let Some(word) = word else {
        return plural.to_owned();
    };
    let one = match word {
        "vertices" => "vertex".to_owned(),
        "meshes" => "mesh".to_owned(),
        _ => match word.strip_suffix("ies") {
            Some(stem) => format!("{stem}y"),
            None => word[..word.len() - 1].to_owned(),
        },
    };
    plural.replacen(word, &one, 1)
}

/// A number, with an exponent where it has many digits.
#[cfg(feature = "scenes")]
pub(crate) fn number(value: f64) -> String {
    match value.abs() < 1e16 {
        true => value.to_string(),
        false => format!("{value:e}"),
    }
}

/// `is` or `are`.
pub(crate) const fn are(count: u64) -> &'static str {
    if count == 1 { "is" } else { "are" }
}

/// How few there are: `there are only 3 vertices`.
pub(crate) fn only(count: usize, plural: &str) -> String {
    match count {
        0 => format!("there are no {plural}"),
        _ => {
            let count = count as u64;
            format!("there {} only {count} {}", are(count), noun(count, plural))
        }
    }
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
    fn one_is_singular() {
        for (plural, one) in [
            ("vertices", "vertex"),
            ("faces", "face"),
            ("vertex colours", "vertex colour"),
            ("vertex properties (a, b)", "vertex property (a, b)"),
            (
                "faces with fewer than three corners",
                "face with fewer than three corners",
            ),
            ("rows of \"glass\"", "row of \"glass\""),
            ("meshes that no node holds", "mesh that no node holds"),
            ("extension \"KHR_x\"", "extension \"KHR_x\""),
            ("library \"old houses\"", "library \"old houses\""),
        ] {
            assert_eq!(noun(1, plural), one);
            assert_eq!(noun(2, plural), plural);
        }
        assert_eq!(only(0, "normals"), "there are no normals");
        assert_eq!(only(1, "normals"), "there is only 1 normal");
        assert_eq!(only(12, "vertices"), "there are only 12 vertices");
    }

    #[test]
    fn excerpts_cut_between_characters() {
        assert_eq!(excerpt("  plain \n"), "plain");
        let long = "ä".repeat(50);
        assert_eq!(excerpt(&long), format!("{}…", "ä".repeat(40)));
    }
}
