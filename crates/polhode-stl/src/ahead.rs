//! Bytes that will be needed soon, asked for in time.

/// Asks for the cache lines of bytes; nothing else happens.
#[inline(always)]
pub(crate) fn ask_for(bytes: &[u8]) {
    #[cfg(target_arch = "x86_64")]
    for line in bytes.chunks(64) {
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
