//! How much memory there is, as far as the system tells.

use std::fs;

/// The bytes of memory that a command takes for every byte of the mesh that it reads, with some to
/// spare: measured on OBJ files of six decimals, `info` takes 7, `convert` 11 and `check` 14.
const FOR_EACH_BYTE: u64 = 16;

/// The largest input that memory suffices for; `None` where the system does not tell.
pub fn largest_input() -> Option<u64> {
    [available(), ceiling(), address_space()]
        .into_iter()
        .flatten()
        .min()
        .map(|bytes| bytes / FOR_EACH_BYTE)
}

/// What can be had without swapping.
fn available() -> Option<u64> {
    let text = fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
}

/// What the control group of the process may have, as in a container.
fn ceiling() -> Option<u64> {
    fs::read_to_string("/sys/fs/cgroup/memory.max").ok()?.trim().parse().ok()
}

/// What `ulimit -v` grants.
fn address_space() -> Option<u64> {
    let text = fs::read_to_string("/proc/self/limits").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    line.split_ascii_whitespace().next()?.parse().ok()
}
