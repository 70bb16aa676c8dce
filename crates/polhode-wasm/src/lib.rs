//! The engine of the interactive page, or the functions of the npm package, as a WebAssembly module.
//!
//! JavaScript writes bytes to the memory at `input`, and then calls `put` to add them as a file, or
//! `answer` to have them answered as a request in JSON: of `polhode_web::Message` (feature `page`),
//! or of `polhode_npm::answer` (feature `package`). The answer has `answer_length` bytes and is
//! valid until the next call.
//!
//! The module has one thread, no clock and no access to files, except for functions that it
//! imports: `now` of the page, milliseconds, for limits of time; and `panicked`, the message of a
//! defect, after which the module must not be called again.
#![cfg(target_arch = "wasm32")]

#[cfg(feature = "package")]
mod package;
#[cfg(feature = "page")]
mod page;

use std::cell::RefCell;

use polhode_source::files::Memory;

#[cfg(feature = "package")]
use package::Functions;
#[cfg(feature = "page")]
use page::Functions;

mod import {
    #[link(wasm_import_module = "page")]
    // SAFETY: JavaScript defines the function with this type (viewer/src/live/worker.ts and
    // npm/src/module.ts). It does not change the memory of the module.
    unsafe extern "C" {
        pub(super) safe fn panicked(text: *const u8, length: usize);
    }
}

#[derive(Default)]
struct Module {
    input: Vec<u8>,
    output: Vec<u8>,
    files: Memory,
    functions: Functions,
}

thread_local! {
    static MODULE: RefCell<Module> = RefCell::default();
}

/// Returns the place of `length` zero bytes that JavaScript replaces by a file or a request.
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
        module.output = module.functions.answer(&request, &mut module.files);
        module.output.as_ptr()
    })
}

/// Returns the length of the answer, bytes.
#[unsafe(no_mangle)]
pub extern "C" fn answer_length() -> usize {
    MODULE.with_borrow(|module| module.output.len())
}
