//! Functions of the module of the interactive page.

use std::sync::atomic::{AtomicU64, Ordering};

use polhode_source::files::Memory;
use polhode_web::{Engine, Watch, limits};

mod import {
    #[link(wasm_import_module = "page")]
    // SAFETY: the worker defines the function with this type (viewer/src/live/worker.ts). It does
    // not change the memory of the module.
    unsafe extern "C" {
        pub(super) safe fn now() -> f64;
    }
}

/// Session of the page.
#[derive(Default)]
pub(crate) struct Functions(Engine);

impl Functions {
    pub(crate) fn answer(&self, request: &[u8], files: &mut Memory) -> Vec<u8> {
        self.0.answer(request, files, &Within::new())
    }
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
