#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| slimbvh_tests::fuzz::build_and_trace(data));
