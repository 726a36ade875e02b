//! Times on a machine that others use too: the least and the median of many runs.

use std::time::Instant;

/// Seconds.
#[derive(Debug, Clone, Copy)]
pub struct Time {
    pub least: f64,
    pub median: f64,
}

/// Runs each of some jobs in turn, `runs` times, after one run that is not counted; a ratio of medians of jobs
/// that were run side by side holds although the machine's speed drifts.
pub fn side_by_side<const N: usize>(runs: usize, mut jobs: [&mut dyn FnMut(); N]) -> [Time; N] {
    let mut seconds = [const { Vec::new() }; N];
    for run in 0..=runs {
        for (job, seconds) in jobs.iter_mut().zip(&mut seconds) {
            let began = Instant::now();
            job();
            if run > 0 {
                seconds.push(began.elapsed().as_secs_f64());
            }
        }
    }
    seconds.map(|mut seconds: Vec<f64>| {
        seconds.sort_by(f64::total_cmp);
        Time { least: seconds[0], median: seconds[seconds.len() / 2] }
    })
}

/// The most memory this process has used so far \[bytes\], where the system tells.
pub fn peak_memory() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kilobytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024.0 * kilobytes)
}
