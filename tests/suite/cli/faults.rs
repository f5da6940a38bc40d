//! What the system does not give: room, permission, time. Outputs are whole or not there.

use std::fs;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use insta::assert_snapshot;

use super::shell::Shell;

/// The names in the directory of the shell.
fn names(shell: &Shell) -> Vec<String> {
    let entries = fs::read_dir(shell.path("")).expect("a directory").flatten();
    let mut names: Vec<_> = entries.map(|e| e.file_name().to_string_lossy().into()).collect();
    names.sort();
    names
}

/// Runs a line that must fail: nothing is left behind, and a file that was there is as it was.
fn fails(shell: &Shell, line: &str, code: &str) {
    let before = names(shell);
    let run = shell.line(&format!("{line} --format json"));
    assert_eq!((run.code, run.json()["code"].as_str()), (2, Some(code)), "{line}");
    assert_eq!(names(shell), before, "{line}");
}

/// An OBJ file of `n × n` quads.
fn grid(n: usize) -> String {
    let mut text = String::new();
    for (i, j) in (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))) {
        text += &format!("v {i} {j} {}\n", i * j);
    }
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let a = i * (n + 1) + j + 1;
        text += &format!("f {a} {} {} {}\n", a + n + 1, a + n + 2, a + 1);
    }
    text
}

#[test]
fn numbers_and_files_beyond_the_limits() {
    let shell = Shell::new();
    shell.file("exponent.obj", "v 0 0 0\nv 0 0 1e999999999\n");
    shell.file("digits.off", format!("OFF\n1 0 0\n0 0 {}\n", "3".repeat(1_000_000)));
    let long = format!(
        "{{\"format\":\"isogeo-mesh\",\"version\":1,\"field\":\"QQ\",\n\
         \"vertices\":[[\"0\",\"0\",\"{}/7\"]],\"faces\":[]}}",
        "5".repeat(20_000)
    );
    shell.file("digits.iso.json", long);
    shell.file("nested.iso.json", format!("{{\"certificate\":{}", "[".repeat(1_000_000)));
    shell.file("samples.csv", "0 0 0\n1 0 0\n0 1 1e-20000\n");
    symlink("/dev/zero", shell.path("endless.obj")).expect("a link");
    let text = shell.session(&[
        "info exponent.obj",
        "info exponent.obj --format json",
        "info digits.off",
        "check digits.iso.json",
        "check digits.iso.json --max-digits 20000 --is planar",
        "info nested.iso.json",
        "triangulate samples.csv -o samples.obj",
        "triangulate samples.csv -o samples.iso.json --max-digits 20000",
        "info kite.obj --max-digits 0",
        "info kite.obj --max-digits 1000000000",
        "info kite.obj --max-input 20",
        "info kite.obj --max-input 1k",
        "info kite.obj --max-input much",
        "info endless.obj --max-input 1M",
    ]);
    assert_snapshot!(text);
}

#[test]
fn files_that_memory_does_not_suffice_for() {
    if !cfg!(target_os = "linux") {
        return eprintln!("no /proc: how much memory there is remains unknown");
    }
    let shell = Shell::new();
    // It takes no room on the disk.
    let big = |bytes| {
        fs::File::create(shell.path("big.obj")).and_then(|f| f.set_len(bytes)).expect("a file");
    };
    big(1 << 42);
    for line in ["check big.obj", "info big.obj", "convert big.obj out.off"] {
        fails(&shell, line, "isogeo::file::limit");
    }
    // Of what the shell grants only a part is for the bytes of the file.
    big(100_000_000);
    let within = |kilobytes: u32, file: &str| {
        let isogeo = env!("CARGO_BIN_EXE_isogeo");
        let line = format!("ulimit -v {kilobytes}; exec {isogeo} info {file} --format json");
        let run = Command::new("sh").args(["-c", &line]).current_dir(shell.path("")).output();
        let run = run.expect("a shell");
        let report = serde_json::from_slice::<serde_json::Value>(&run.stdout).expect("JSON");
        (run.status.code(), report["code"].as_str().map(str::to_owned))
    };
    assert_eq!(within(1_000_000, "big.obj"), (Some(2), Some("isogeo::file::limit".into())));
    assert_eq!(within(1_000_000, "kite.obj"), (Some(0), None));
}

#[test]
fn a_failed_write_leaves_everything_as_it_was() {
    let shell = Shell::new();
    let old = "v 0 0 0\n";
    shell.file("old.obj", old);
    fails(&shell, "convert kite.obj no/such/folder/out.obj", "isogeo::file::io");

    let read_only = fs::Permissions::from_mode(0o444);
    fs::set_permissions(shell.path("old.obj"), read_only).expect("permissions");
    fails(&shell, "convert kite.obj old.obj", "isogeo::file::io");
    assert_eq!(shell.cat("old.obj"), old);
    let writable = fs::Permissions::from_mode(0o640);
    fs::set_permissions(shell.path("old.obj"), writable).expect("permissions");
    assert_eq!(shell.line("convert kite.obj old.obj").code, 0);
    assert_ne!(shell.cat("old.obj"), old);
    let mode = fs::metadata(shell.path("old.obj")).expect("a file").permissions().mode();
    assert_eq!(mode & 0o777, 0o640, "permissions are kept");

    symlink("/dev/full", shell.path("full.obj")).expect("a link");
    if Path::new("/dev/full").exists() {
        fails(&shell, "convert kite.obj full.obj", "isogeo::file::io");
    }
}

#[test]
fn a_folder_that_may_not_be_written_to() {
    let shell = Shell::new();
    fs::create_dir(shell.path("closed")).expect("a folder");
    let mode = |mode| fs::set_permissions(shell.path("closed"), fs::Permissions::from_mode(mode));
    mode(0o555).expect("permissions");
    if fs::write(shell.path("closed/probe"), "").is_ok() {
        eprintln!("this user may write to every folder: nothing is tested");
    } else {
        fails(&shell, "convert kite.obj closed/out.obj", "isogeo::file::io");
    }
    mode(0o755).expect("permissions");
}

#[test]
fn a_full_disk() {
    let shell = Shell::new();
    fs::create_dir(shell.path("disk")).expect("a folder");
    let disk = shell.path("disk");
    let mounted = Command::new("mount")
        .args(["-t", "tmpfs", "-o", "size=64k", "tmpfs"])
        .arg(&disk)
        .stderr(Stdio::null())
        .status();
    if !mounted.is_ok_and(|status| status.success()) {
        return eprintln!("this user may not mount a small disk: nothing is tested");
    }
    shell.file("large.obj", grid(100));
    shell.file("disk/old.off", "OFF\n");
    for out in ["disk/out.off", "disk/old.off"] {
        let run = shell.line(&format!("convert large.obj {out} --format json"));
        assert_eq!((run.code, run.json()["code"].as_str()), (2, Some("isogeo::file::io")));
    }
    let left: Vec<_> =
        fs::read_dir(&disk).expect("a disk").flatten().map(|e| e.file_name()).collect();
    assert_eq!(left, ["old.off"]);
    assert_eq!(shell.cat("disk/old.off"), "OFF\n");
    assert_eq!(shell.line("convert kite.obj disk/out.off").code, 0, "what fits is written");
    Command::new("umount").arg(&disk).status().expect("the disk is taken away");
}

#[test]
fn a_killed_write_leaves_the_old_file() {
    let shell = Shell::new();
    shell.file("large.obj", grid(150));
    assert_eq!(shell.line("convert large.obj out.off").code, 0);
    let whole = shell.cat("out.off");
    let old = "OFF\n1 0 0\n0 0 0\n";
    let mut killed = 0;
    for wait in (0..40).map(|i| Duration::from_millis(i * 20)) {
        shell.file("out.off", old);
        let mut child = shell
            .command(["convert", "large.obj", "out.off"])
            .stdout(Stdio::null())
            .spawn()
            .expect("the program starts");
        std::thread::sleep(wait);
        let finished = child.try_wait().expect("a process").is_some();
        child.kill().expect("a process");
        child.wait().expect("a process");
        let found = shell.cat("out.off");
        assert!(found == old || found == whole, "{} bytes after {wait:?}", found.len());
        killed += u32::from(!finished);
        if finished {
            assert_eq!(found, whole);
            break;
        }
    }
    assert!(killed > 0, "it was never interrupted");
}

#[test]
fn links_pipes_and_devices_are_written_through() {
    let shell = Shell::new();
    assert_eq!(shell.line("convert kite.obj plain.off").code, 0);
    let plain = shell.cat("plain.off");

    shell.file("end.off", "");
    fs::create_dir(shell.path("away")).expect("a folder");
    symlink("end.off", shell.path("link.off")).expect("a link");
    symlink("away/new.off", shell.path("dangling.off")).expect("a link");
    symlink("/dev/null", shell.path("null.off")).expect("a link");
    for (link, end) in [("link.off", "end.off"), ("dangling.off", "away/new.off")] {
        assert_eq!(shell.line(&format!("convert kite.obj {link}")).code, 0);
        assert_eq!(shell.cat(end), plain);
        assert!(fs::symlink_metadata(shell.path(link)).expect("a link").is_symlink(), "{link}");
    }
    for null in ["null.off", "/dev/null"] {
        assert_eq!(shell.line(&format!("convert kite.obj {null}")).code, 0);
        assert!(fs::metadata(shell.path(null)).expect("a device").file_type().is_char_device());
    }
    assert_eq!(shell.line("convert kite.obj plain.iso.json").code, 0);
    let plain_json = shell.cat("plain.iso.json");
    let run = shell.line("convert kite.obj /dev/stdout");
    assert_eq!((run.code, &run.out), (0, &plain_json));
    assert!(run.err.starts_with("/dev/stdout: "), "{}", run.err);
    // What is appended to stays.
    shell.file("log", "above\n");
    let log = fs::OpenOptions::new().append(true).open(shell.path("log")).expect("a file");
    let status = shell.command(["convert", "kite.obj", "/dev/stdout"]).stdout(log).status();
    assert!(status.expect("the program runs").success());
    assert_eq!(shell.cat("log"), format!("above\n{plain_json}"));

    let made = Command::new("mkfifo").arg(shell.path("pipe.off")).status();
    assert!(made.expect("mkfifo").success());
    let pipe = shell.path("pipe.off");
    let reader = std::thread::spawn(move || fs::read_to_string(pipe).expect("a text"));
    assert_eq!(shell.line("convert kite.obj pipe.off").code, 0);
    assert_eq!(reader.join().expect("the reader"), plain);
}

#[test]
fn an_output_may_be_the_input() {
    let shell = Shell::new();
    assert_eq!(shell.line("move kite.obj --translate 0,0,1 -o moved.obj").code, 0);
    assert_eq!(shell.line("move kite.obj --translate 0,0,1 -o kite.obj").code, 0);
    assert_eq!(shell.cat("kite.obj"), shell.cat("moved.obj"));
}
