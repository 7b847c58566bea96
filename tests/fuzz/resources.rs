//! Measures the time and memory of reading an input.

use std::fmt;
use std::time::{Duration, Instant};

/// Time and memory.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Spent {
    pub(crate) time: Duration,
    /// By how much the memory of the process grew at most; 0 where the system does not tell.
    pub(crate) megabytes: u64,
}

/// The most that any input took, and of how many anything came.
#[derive(Debug, Default)]
pub(crate) struct Watch {
    most: Spent,
    count: u64,
    read_count: u64,
}

impl Watch {
    /// What a call takes.
    pub(crate) fn spent(&mut self, call: impl FnOnce()) -> Spent {
        let before = resident_after_reset();
        let start = Instant::now();
        call();
        let time = start.elapsed();
        let kilobytes = before.and_then(|before| Some(status("VmHWM:")?.saturating_sub(before)));
        let spent = Spent { time, megabytes: kilobytes.unwrap_or(0) / 1024 };
        let Spent { time, megabytes } = &mut self.most;
        (*time, *megabytes) = ((*time).max(spent.time), (*megabytes).max(spent.megabytes));
        spent
    }

    /// Counts an input.
    pub(crate) fn count(&mut self, is_read: bool) {
        self.count += 1;
        self.read_count += u64::from(is_read);
    }

    /// Inputs of which anything came.
    pub(crate) fn read_count(&self) -> u64 {
        self.read_count
    }
}

impl fmt::Display for Watch {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Spent { time, megabytes } = self.most;
        let seconds = time.as_secs_f64();
        write!(
            formatter,
            "{} of {} read, {seconds:.2} s and {megabytes} MB at most",
            self.read_count, self.count
        )
    }
}

/// Kilobytes that the process has now; from here on its peak is counted anew.
fn resident_after_reset() -> Option<u64> {
    // Linux: 5 resets the peak (man 5 proc_pid_clear_refs).
    std::fs::write("/proc/self/clear_refs", "5").ok()?;
    status("VmRSS:")
}

fn status(key: &str) -> Option<u64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(key))?;
    line.trim().trim_end_matches(" kB").parse().ok()
}

/// That memory which is taken and given back is seen. No test of its own: tests run side by side in one process, whose
/// memory this counts.
pub(crate) fn check_that_memory_is_seen() {
    const MEGABYTES: usize = 64;
    if resident_after_reset().is_none() {
        return println!("memory is not looked at: this system does not tell the peak");
    }
    let take = || assert_eq!(std::hint::black_box(vec![1_u8; MEGABYTES << 20]).len(), MEGABYTES << 20);
    let spent = Watch::default().spent(take);
    assert!(spent.megabytes >= MEGABYTES as u64 - 4, "{spent:?}");
}
