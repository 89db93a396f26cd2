//! What the binary writes when all is well.

#[cfg(feature = "report")]
mod bench;
mod help;
mod info;
mod outputs;
mod reproduce;
mod saved;
mod scenes;
mod stress;
mod views;

use serde_json::Value;

const SMALL: [&str; 4] = ["render", "--size", "160x90", "--json"];

/// An 8-bit RGB picture's sides and bytes.
fn decode(bytes: &[u8]) -> ([u32; 2], Vec<u8>) {
    let decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    let mut reader = decoder.read_info().expect("it is a PNG");
    assert!(reader.info().srgb.is_some());
    let mut pixels = vec![0; reader.output_buffer_size().expect("it fits")];
    let frame = reader.next_frame(&mut pixels).expect("it is whole");
    assert_eq!(frame.color_type, png::ColorType::Rgb);
    assert_eq!(frame.bit_depth, png::BitDepth::Eight);
    ([frame.width, frame.height], pixels)
}

/// JSON and nothing beside.
fn parse(text: &str) -> Value {
    assert!(text.starts_with('{') && text.ends_with("}\n"), "{text}");
    serde_json::from_str(text).expect("it is JSON")
}

/// The names in an object, in order.
fn keys(value: &Value) -> Vec<&str> {
    value
        .as_object()
        .expect("it is an object")
        .keys()
        .map(String::as_str)
        .collect()
}

#[track_caller]
fn number(report: &Value, key: &str) -> f64 {
    report[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key} is {}", report[key]))
}
