//! Requests from the page of `polhode live`.

use std::sync::OnceLock;

use polhode_live::{Live, LiveOptions};

/// Largest request body, bytes; a longer one would take too long.
const LONGEST: usize = 4000;

/// Checks that every request gets an answer or a client error (status 4xx), and the same one when
/// repeated.
pub fn live(data: &[u8]) {
    static LIVE: OnceLock<Option<Live>> = OnceLock::new();
    let live = LIVE.get_or_init(|| Live::bind(&LiveOptions::default()).ok());
    let Some(live) = live.as_ref().filter(|_| data.len() <= LONGEST) else { return };
    for path in ["motion", "complete", "open"] {
        let status = live.status_of(path, data);
        assert!(status == 200 || (400..500).contains(&status), "{path}: {status}");
        assert_eq!(status, live.status_of(path, data), "{path}");
    }
}
