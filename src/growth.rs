//! How time grows with the size of what is worked on, for tests of what must not explode.

use std::time::Instant;

/// Time that this thread has had a processor, where the system tells; else time that went by.
enum ThreadTime {
    Worked(f64),
    Clock(Instant),
}

impl ThreadTime {
    fn now() -> Self {
        Self::worked().map_or_else(|| Self::Clock(Instant::now()), Self::Worked)
    }

    fn worked() -> Option<f64> {
        let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
        text.split(' ').next()?.parse().ok().map(|nanoseconds: f64| nanoseconds * 1e-9)
    }

    fn seconds(&self) -> f64 {
        match self {
            Self::Worked(start) => Self::worked().unwrap_or(*start) - start,
            Self::Clock(start) => start.elapsed().as_secs_f64(),
        }
    }
}

/// The power of the size with which time grows from a small input to one some times as large, as far as other work on the
/// machine lets it be told: the least of a few rounds, the first of which that is below what is hoped for.
pub(crate) fn growth<T>(
    small: usize,
    times: usize,
    hoped: f64,
    make: impl Fn(usize) -> T,
    run: impl Fn(T),
) -> f64 {
    const ROUNDS: usize = 4;
    /// Seconds of work below which the clock is too coarse.
    const LEAST: f64 = 0.1;
    let seconds = |size: usize| {
        let (mut total, mut repeats) = (0.0, 0.0);
        while total < LEAST {
            let input = make(size);
            let start = ThreadTime::now();
            run(input);
            (total, repeats) = (total + start.seconds(), repeats + 1.0);
        }
        total / repeats
    };
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let ratio = seconds(small * times) / seconds(small);
        least = least.min(libm::log(ratio) / libm::log(times as f64));
        if least < hoped {
            break;
        }
    }
    least
}
