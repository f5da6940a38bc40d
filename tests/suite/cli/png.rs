//! PNG pictures of figures, and builds that do not draw them.

use super::shell::Shell;

#[test]
fn what_is_written_if_nothing_is_said() {
    let shell = Shell::new();
    let run = shell.line("figure 7 --out figures");
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(shell.path("figures/fig-07/fig-07.svg").exists());
    assert_eq!(shell.path("figures/fig-07/fig-07.png").exists(), cfg!(feature = "png"));
}

#[test]
fn builds_with_and_without() {
    let shell = Shell::new();
    let run = shell.line("figure 7 --out figures --as svg,png");
    if cfg!(feature = "png") {
        assert_eq!(run.code, 0, "{}", run.err);
        assert_eq!(shell.line("figure 7 --out figures --as png --check").code, 0);
        std::fs::write(shell.path("figures/fig-07/fig-07.png"), "no picture").expect("a file");
        assert_eq!(shell.line("figure 7 --out figures --as png --check").code, 1);
    } else {
        assert_eq!(run.code, 2);
        assert!(run.err.contains("PNG pictures are not drawn by this build"), "{}", run.err);
        assert!(run.err.contains("cargo install --path . --features png"), "{}", run.err);
        assert!(!shell.path("figures").exists());
    }
    assert!(shell.line("figure --help").out.contains("png:"));
}
