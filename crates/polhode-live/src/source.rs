//! The pack of the files as they are now.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;

use polhode_source::files::{Asked, Disk, Files as _};

use crate::error::LiveError;
use crate::gather::gather;
use crate::limits;
use crate::options::LiveOptions;
use crate::pack::Pack;

/// Files of a session, which are read again when one is written to.
#[derive(Debug)]
pub(crate) struct Source {
    options: LiveOptions,
    pack: Mutex<Pack>,
    /// Paths that were asked for when the files were last read.
    asked: Mutex<Asked>,
}

impl Source {
    /// Reads the files.
    pub(crate) fn open(options: LiveOptions) -> Result<Self, LiveError> {
        let (asked, gathered) = gather(&options);
        let pack = Pack::of(&gathered?)?;
        Ok(Self { options, pack: Mutex::new(pack), asked: Mutex::new(asked) })
    }

    /// Returns the pack. If files were written to, it reads them again; if they cannot be read, it
    /// returns the last pack until they change again.
    pub(crate) fn pack(&self) -> Pack {
        // While another thread reads the files, the last pack is returned.
        if let Ok(mut asked) = self.asked.try_lock()
            && !asked.is_current(&Disk)
        {
            // A program that saves a file by renaming another one may be about to do so.
            if asked.files().any(|path| !Disk.is_file(path)) {
                thread::sleep(limits::RENAME_TIME);
            }
            let (now, gathered) = gather(&self.options);
            *asked = now;
            if let Ok(pack) = gathered.and_then(|gathered| Pack::of(&gathered)) {
                *self.last() = pack;
            }
        }
        self.last().clone()
    }

    fn last(&self) -> MutexGuard<'_, Pack> {
        self.pack.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
