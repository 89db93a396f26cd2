#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| slimbvh_tests::fuzz::wide_codec(data));
