#![no_main]

use isogeo::mesh::file::Format;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| isogeo_fuzz::read(Format::Off, bytes));
