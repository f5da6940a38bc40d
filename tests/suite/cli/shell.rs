//! Runs the program in a directory of its own.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};

use super::samples;

/// The program, to be run in a directory that lasts as long as this value.
pub struct Shell {
    directory: PathBuf,
}

/// What a run has printed, and its exit code.
pub struct Run {
    pub out: String,
    pub err: String,
    pub code: i32,
}

impl Run {
    pub fn json(&self) -> serde_json::Value {
        serde_json::from_str(&self.out).expect("JSON on standard output")
    }
}

impl Shell {
    /// A directory with the samples.
    pub fn new() -> Shell {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let name = format!("{}-{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::create_dir_all(&directory).expect("a directory");
        let shell = Shell { directory };
        samples::ALL.iter().for_each(|(name, text)| shell.file(name, text));
        shell
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.directory.join(name)
    }

    pub fn file(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.path(name), bytes).expect("a file");
    }

    pub fn cat(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).expect("a text")
    }

    /// The program, neither on a terminal nor in the colours of one.
    pub fn command<A: AsRef<std::ffi::OsStr>>(
        &self,
        arguments: impl IntoIterator<Item = A>,
    ) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_isogeo"));
        command.args(arguments).current_dir(&self.directory).stdin(Stdio::null());
        command.env("NO_COLOR", "1").env_remove("COLUMNS").env_remove("CLICOLOR_FORCE");
        command
    }

    pub fn run(&self, arguments: &[&str]) -> Run {
        let Output { status, stdout, stderr } =
            self.command(arguments).output().expect("the program starts");
        let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
        let code = status.code().expect("no signal");
        Run { out: text(stdout), err: text(stderr), code }
    }

    /// Runs a line of words.
    pub fn line(&self, line: &str) -> Run {
        self.run(&line.split_whitespace().collect::<Vec<_>>())
    }

    /// A dialogue: lines for the program, or `cat FILE`; standard error is marked with `!`.
    pub fn session(&self, lines: &[&str]) -> String {
        let mut text = String::new();
        for line in lines {
            if let Some(name) = line.strip_prefix("cat ") {
                text += &format!("$ {line}\n{}\n", self.cat(name));
                continue;
            }
            let run = self.line(line);
            text += &format!("$ isogeo {line}\n{}", run.out);
            for complaint in run.err.lines() {
                text += format!("! {complaint}").trim_end();
                text.push('\n');
            }
            text += &format!("[exit {}]\n\n", run.code);
        }
        text
    }
}

impl Drop for Shell {
    fn drop(&mut self) {
        // What is left over lies in the target directory and does no harm.
        let _ = fs::remove_dir_all(&self.directory);
    }
}
