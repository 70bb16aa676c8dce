//! The engine of the interactive page as a WebAssembly module.
//!
//! A worker of the page writes bytes to the memory at `input`, and then calls `put` to add
//! them as a file, or `answer` to have them answered as a request of `polhode_web::Message` in
//! JSON. The answer has `answer_length` bytes and is valid until the next call.
//!
//! The module has one thread, no clock and no access to files, except for two functions of the
//! worker: `now`, milliseconds, for limits of time; and `panicked`, the message of a defect, after
//! which the module must not be called again.
#![cfg(target_arch = "wasm32")]

use std::cell::RefCell;
use std::sync::atomic::{AtomicU64, Ordering};

use polhode_source::files::Memory;
use polhode_web::{Engine, Watch, limits};

mod import {
    #[link(wasm_import_module = "page")]
    // SAFETY: the worker defines both functions with these types (viewer/src/live/worker.ts).
    // Neither changes the memory of the module.
    unsafe extern "C" {
        pub(super) safe fn now() -> f64;
        pub(super) safe fn panicked(text: *const u8, length: usize);
    }
}

#[derive(Default)]
struct Module {
    input: Vec<u8>,
    output: Vec<u8>,
    files: Memory,
    engine: Engine,
}

thread_local! {
    static MODULE: RefCell<Module> = RefCell::default();
}

/// Returns the place of `length` zero bytes that the worker replaces by a file or a request.
// SAFETY: no other exported function of the module has this name; the same below.
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    std::panic::set_hook(Box::new(|defect| {
        let text = defect.to_string();
        import::panicked(text.as_ptr(), text.len());
    }));
    MODULE.with_borrow_mut(|module| {
        module.output = Vec::new();
        module.input = vec![0; length];
        module.input.as_mut_ptr()
    })
}

/// Adds the input as a file: `path_length` bytes of its path in UTF-8, then its content.
#[unsafe(no_mangle)]
pub extern "C" fn put(path_length: usize) {
    MODULE.with_borrow_mut(|module| {
        let input = std::mem::take(&mut module.input);
        let (path, content) = input.split_at(path_length.min(input.len()));
        module.files.insert(String::from_utf8_lossy(path).as_ref(), content);
    });
}

/// Answers the input as a request, and returns the place of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    MODULE.with_borrow_mut(|module| {
        let request = std::mem::take(&mut module.input);
        module.output = module.engine.answer(&request, &module.files, &Within::new());
        module.output.as_ptr()
    })
}

/// Returns the length of the answer, bytes.
#[unsafe(no_mangle)]
pub extern "C" fn answer_length() -> usize {
    MODULE.with_borrow(|module| module.output.len())
}

/// Limit of the time of a computation. The worker ends computations that nobody waits for.
struct Within {
    /// Bits of the time when the computation began, ms.
    begun: AtomicU64,
}

impl Within {
    fn new() -> Self {
        Self { begun: AtomicU64::new(import::now().to_bits()) }
    }
}

impl Watch for Within {
    fn goes_on(&self) -> bool {
        let begun = f64::from_bits(self.begun.load(Ordering::Relaxed));
        import::now() - begun < 1e3 * limits::MOTION.as_secs_f64()
    }

    fn is_wanted(&self) -> bool {
        true
    }

    fn restart(&self) {
        self.begun.store(import::now().to_bits(), Ordering::Relaxed);
    }
}
