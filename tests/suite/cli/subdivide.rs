//! Subdivision on the command line.

use insta::assert_snapshot;

use super::shell::Shell;

#[test]
fn subdivide() {
    let shell = Shell::new();
    assert_snapshot!(shell.session(&[
        "subdivide third.iso.json -o fine.iso.json",
        "cat fine.iso.json",
        "subdivide third.iso.json --keep-corners -o fine.obj",
        "cat fine.obj",
        "subdivide sigma.iso.json -n 3 --crease 1-4-7,3-4 -o fine.obj --format json",
        "subdivide printed.obj -o fine.obj",
        "subdivide pinched.obj -o fine.off",
        "subdivide sigma.iso.json --scheme dual -o fine.iso.json",
        "check fine.iso.json --is planar",
        "subdivide twisted.iso.json --scheme dual -n 2 --keep-corners -o fine.iso.json",
        "subdivide vertical.obj --scheme dual -o none.obj",
        "subdivide vertical.obj --scheme dual -o none.obj --format json",
        "subdivide sigma.iso.json --scheme dual --crease 1-4 -o none.obj",
        "subdivide sigma.iso.json --crease 0-4 -o none.obj",
        "subdivide sigma.iso.json --crease 4 -o none.obj",
        "subdivide sigma.iso.json --crease 1-x -o none.obj --format json",
        "subdivide sigma.iso.json -n 9 -o none.obj",
    ]));
    assert!(!shell.path("none.obj").exists());
}
