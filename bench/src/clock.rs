//! Measures run times on a shared machine, as the minimum and the median of many runs.

use std::time::Instant;

/// Minimum and median of the measured run times \[s\].
#[derive(Debug, Clone, Copy)]
pub struct Time {
    pub least: f64,
    pub median: f64,
}

/// Times several jobs, `runs` times each, after one run without timing. The jobs alternate, so a drift of the
/// machine's speed does not change the ratios of their medians.
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

/// Returns the peak memory of this process so far \[bytes\], if the system reports it.
pub fn peak_memory() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kilobytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024.0 * kilobytes)
}
