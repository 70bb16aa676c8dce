//! Opens a page in the user's browser.

use std::path::Path;
use std::process::{Command, Stdio};

use polhode_source::shown;

use crate::stderr::tell;

/// Opens a page with the program named in BROWSER, or with that of the system. A failure is only a
/// note, because the page is written.
pub(crate) fn open(page: &Path) {
    let own = std::env::var_os("BROWSER").filter(|name| !name.is_empty());
    let mut command = if let Some(own) = own {
        Command::new(own)
    } else if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(windows) {
        let mut command = Command::new("cmd");
        command.args(["/C", "start", ""]);
        command
    } else {
        Command::new("xdg-open")
    };
    command.arg(page).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    if let Err(error) = command.spawn() {
        tell(&format!("note: cannot start a browser ({error}); open {} yourself\n", shown(page)));
    }
}
