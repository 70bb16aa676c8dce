//! Bytes that will be needed soon, asked for in time.

/// Asks for the cache lines of bytes; nothing else happens.
#[inline(always)]
pub(crate) fn ask_for(bytes: &[u8; SHARE]) {
    #[cfg(target_arch = "x86_64")]
    for line in bytes.chunks(LINE) {
        use core::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        #[allow(unsafe_code, reason = "a hint about an address: it reads nothing and cannot fail")]
        // SAFETY: any address is allowed; this one is inside `bytes`.
        unsafe {
            _mm_prefetch::<_MM_HINT_T0>(line.as_ptr().cast());
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = bytes;
}

/// Reads a byte where a new stretch of pages begins, so that the system maps the stretch before its lines are asked for: a line of a
/// page that is not mapped cannot be had in advance, and asking for it costs a search through the tables of pages.
#[inline(always)]
pub(crate) fn map_soon(bytes: &[u8]) {
    let address = bytes.as_ptr().addr();
    if let Some(byte) = bytes.get(address.next_multiple_of(MAPPED_AT_ONCE) - address) {
        core::hint::black_box(*byte);
    }
}

/// Linux maps the 64 KiB around an address that was missing.
const MAPPED_AT_ONCE: usize = 1 << 16;

/// Bytes asked for at once: those of eight records.
const SHARE: usize = 400;

/// Bytes of a line of the cache.
const LINE: usize = 64;
