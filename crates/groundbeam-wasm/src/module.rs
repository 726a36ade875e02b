//! Exports the WebAssembly functions: a caller writes a text into the memory, and the results replace the text.

use crate::results;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The input text, which `replace` replaces by the results.
static TEXT: Mutex<Vec<u8>> = Mutex::new(Vec::new());

fn text() -> MutexGuard<'static, Vec<u8>> {
    TEXT.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Sets the length of the text in bytes, and returns its address in the memory of the module.
#[unsafe(no_mangle)]
pub extern "C" fn place(length: usize) -> *mut u8 {
    let mut text = text();
    text.resize(length, 0);
    text.as_mut_ptr()
}

/// Computes the results for the input text in the shared memory, replaces the text by them, and returns their
/// length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn replace() -> usize {
    let mut text = text();
    *text = results(&String::from_utf8_lossy(&text)).into_bytes();
    text.len()
}
