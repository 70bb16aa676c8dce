//! Requests of the page of `polhode live`.

use std::sync::OnceLock;

use polhode_live::{Live, LiveOptions};

/// Largest size of a request's body; a longer one computes for longer than an input should.
const LONGEST: usize = 4000;

/// Checks that every request is answered, or refused with a status of the page's fault.
///
/// The same request again has the same answer.
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
