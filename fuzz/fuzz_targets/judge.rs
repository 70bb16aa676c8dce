#![no_main]
libfuzzer_sys::fuzz_target!(|data: &[u8]| polhode_fuzz::motion::judge(data));
