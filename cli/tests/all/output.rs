//! Parsers of the binary's output.

use serde_json::Value;

/// The size and the bytes of an 8-bit RGB PNG.
pub fn decode(bytes: &[u8]) -> ([u32; 2], Vec<u8>) {
    let decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    let mut reader = decoder.read_info().expect("it is a PNG");
    assert!(reader.info().srgb.is_some());
    let mut pixels = vec![0; reader.output_buffer_size().expect("it fits")];
    let frame = reader.next_frame(&mut pixels).expect("it is whole");
    assert_eq!(frame.color_type, png::ColorType::Rgb);
    assert_eq!(frame.bit_depth, png::BitDepth::Eight);
    ([frame.width, frame.height], pixels)
}

/// Parses a text that is one JSON object and nothing else.
pub fn parse(text: &str) -> Value {
    assert!(text.starts_with('{') && text.ends_with("}\n"), "{text}");
    serde_json::from_str(text).expect("it is JSON")
}

/// The keys of an object, in order.
pub fn keys(value: &Value) -> Vec<&str> {
    value
        .as_object()
        .expect("it is an object")
        .keys()
        .map(String::as_str)
        .collect()
}

#[track_caller]
pub fn number(report: &Value, key: &str) -> f64 {
    report[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key} is {}", report[key]))
}

/// The options that a help text lists, by their long names.
pub fn options_in(help: &str) -> Vec<&str> {
    let mut options: Vec<&str> = help
        .lines()
        .filter(|line| line.trim_start().starts_with('-'))
        .flat_map(|line| {
            line.split_whitespace()
                .take(2)
                .find(|word| word.starts_with("--"))
        })
        .map(|word| word.trim_end_matches(','))
        .collect();
    options.sort_unstable();
    options
}
