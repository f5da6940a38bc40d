//! Families and Christoffel duals, as their users make and check them.

use insta::assert_snapshot;
use isogeo::construct::family::Family;

use super::shell::Shell;

/// The names of what a family says that it proves, of the mesh and of the pair.
fn names(family: Family) -> [String; 2] {
    let (alone, pair) = family.proves();
    let join = |names: Vec<&str>| names.join(",");
    [join(alone.iter().map(|p| p.name()).collect()), join(pair.iter().map(|p| p.name()).collect())]
}

/// Makes a member and checks from its files what the family proves.
fn proves(shell: &Shell, family: Family, options: &str) {
    let name = family.name();
    let run = shell.line(&format!("make {name} {options} -o {name}"));
    assert_eq!(run.code, 0, "{name} {options}: {}", run.err);
    let [alone, pair] = names(family);
    let surface = format!("check {name}/surface.iso.json");
    if !alone.is_empty() {
        let run = shell.line(&format!("{surface} --is {alone}"));
        assert_eq!(run.code, 0, "{name} {options}: {}", run.out);
    }
    let gauss = shell.path(name).join("gauss.iso.json").exists();
    assert_eq!(gauss, !pair.is_empty(), "{name}");
    if gauss {
        let run = shell.line(&format!("{surface} --with {name}/gauss.iso.json --is {pair}"));
        assert_eq!(run.code, 0, "{name} {options}: {}", run.out);
    }
}

#[test]
fn every_family_proves_what_it_says() {
    let shell = Shell::new();
    for family in Family::ALL {
        proves(&shell, family, "");
    }
}

#[test]
fn other_members_do_so_too() {
    let shell = Shell::new();
    for (name, options) in [
        ("paraboloid", "--n 3x2 -p curvatures=-1,2.5"),
        ("saddle", "--n 2x5"),
        ("enneper", "--n 3x4 -p center=-1/2,-1/2"),
        ("enneper", "--n 5x2"),
        ("logarithmoid", "--n 3x3 -p half-angle=4/5,3/5"),
        ("helicoid", "--n 2x3 -p half-angle=4/5,-3/5"),
        ("bonnet", "--n 3x3 -p half-angle=12/13,5/13 -p center=2,1/5"),
        ("weierstrass", "--n 3x4 -p seed=7,mean=3/7"),
        ("circular-net", "--n 3x3 -p seed=12"),
        ("circular-net", "--n 6x6"),
        ("weierstrass", "--n 6x6 -p seed=2"),
        ("conical-net", "--n 3x2 -p seed=3"),
        ("triangle-graph", "--n 3x4 -p formula=x^4/12+y^2/2,step=1/8"),
        ("rotational-cmc", "--n 4x3 -p mean=0,integral=2 -p half-angle=12/13,5/13"),
        ("rotational-constant-k", "--n 4x3 -p curvature=9/4,integral=1/3"),
        ("rotational-constant-k", "--n 4x3 -p curvature=-1/4,integral=4"),
        ("hex-minimal", "--n 3x4 -p half-angle=4/5,3/5,integral=7/3"),
        ("hex-cmc", "--n 3x4 -p mean=3/7,integral=-1/2"),
        ("hex-constant-k", "--n 3x4 -p curvature=4/9"),
    ] {
        let family = Family::from_name(name).expect("a family");
        proves(&shell, family, options);
    }
}

/// Where square roots are irrational, the mesh encloses another one: it says so wherever it goes.
#[test]
fn enclosed_members_are_not_taken_for_exact_ones() {
    let shell = Shell::new();
    for (name, options, expected) in [
        ("rotational-constant-k", "--n 4x3 -p curvature=2", "i-circular,i-conical"),
        ("rotational-constant-k", "--n 4x3 -p curvature=-3,integral=4", "i-circular,i-conical"),
        ("rotational-constant-k", "--n 4x3 -p curvature=-1,integral=2,bits=9", "i-circular"),
        ("rotational-constant-k", "--n 4x3 -p curvature=5/7,integral=-1/3", "i-conical"),
        ("hex-constant-k", "--n 3x4 -p curvature=2", "planar"),
        ("hex-constant-k", "--n 3x4 -p curvature=-40,bits=300", "planar"),
    ] {
        let made = shell.line(&format!("make {name} {options} -o made"));
        assert_eq!(made.code, 0, "{name} {options}: {}", made.err);
        assert!(made.out.contains("NOT exact") && made.out.contains("not proved"), "{}", made.out);
        let surface = "check made/surface.iso.json";
        assert_eq!(shell.line(&format!("{surface} --is {expected}")).code, 0, "{name} {options}");
        let pair = format!("{surface} --with made/gauss.iso.json");
        assert_eq!(shell.line(&format!("{pair} --is f-parallel")).code, 0, "{name} {options}");
        let scribed = if name.starts_with("hex") { "circumscribed" } else { "inscribed" };
        let line = format!("check made/gauss.iso.json --is {scribed}");
        assert_eq!(shell.line(&line).code, 0, "{name} {options}");
        let run = shell.line(&format!("{pair} --is constant-k"));
        assert_eq!(run.code, 1, "{name} {options}");
        assert!(run.out.contains("enclose another mesh"), "{}", run.out);
        let file: serde_json::Value =
            serde_json::from_str(&shell.cat("made/surface.iso.json")).expect("a document");
        let certificate = &file["certificate"]["enclosure"];
        assert_eq!(certificate["property"], "constant-k", "{name} {options}");
        assert!(certificate["roots"].as_array().is_some_and(|roots| roots.len() > 1));
        assert_eq!(
            file["data"]["vertex"]["enclosure"].as_array().map(Vec::len),
            file["vertices"].as_array().map(Vec::len)
        );
        assert_eq!(shell.line("convert made/surface.iso.json surface.obj").code, 0);
        assert!(!shell.cat("surface.obj").contains("coords=exact"));
    }
    let run = shell.line("make rotational-constant-k -p curvature=-2,integral=-1 -o none");
    assert_eq!(run.code, 2);
}

/// The classes are not those of everything: another surface, or a vertex moved, is refuted.
#[test]
fn families_are_not_those_of_others() {
    let shell = Shell::new();
    for name in ["enneper", "saddle", "rotational-cmc"] {
        let run = shell.line(&format!("make {name} --n 3x3 -o {name}"));
        assert_eq!(run.code, 0, "{}", run.err);
    }
    for (line, code) in [
        ("check enneper/surface.iso.json --with saddle/gauss.iso.json --is i-minimal", 1),
        (
            "check rotational-cmc/surface.iso.json --with rotational-cmc/gauss.iso.json --is i-minimal",
            1,
        ),
        ("check rotational-cmc/surface.iso.json --is i-minimal", 1),
        ("check enneper/surface.iso.json --is i-circular", 1),
    ] {
        assert_eq!(shell.line(line).code, code, "{line}");
    }
    let text = shell.cat("saddle/surface.iso.json").replacen(
        "\"1\",\"-1\",\"0\"",
        "\"1\",\"-1\",\"1/9\"",
        1,
    );
    shell.file("moved.iso.json", text);
    for property in ["planar", "koenigs", "i-minimal", "i-isothermic"] {
        assert_eq!(
            shell.line(&format!("check moved.iso.json --is {property}")).code,
            1,
            "{property}"
        );
    }
}

/// Rounded to a few digits, the classes are possible, no more; and not those of a coarser rounding.
#[test]
fn rounded_members_are_consistent() {
    let shell = Shell::new();
    for line in [
        "make weierstrass --n 3x3 -o made",
        "convert made/surface.iso.json surface.obj --digits 7",
        "convert made/gauss.iso.json gauss.obj --digits 7",
    ] {
        assert_eq!(shell.line(line).code, 0, "{line}");
    }
    for properties in ["koenigs", "i-isothermic", "i-minimal"] {
        let report =
            shell.line(&format!("check surface.obj --is {properties} --format json")).json();
        let verdict = &report["properties"][0]["verdict"];
        // The vertex sense is another: the lift of a circular net.
        let expected = if properties == "i-minimal" { "refuted" } else { "consistent" };
        assert_eq!(verdict, expected, "{properties}: {report}");
        let line = format!("check surface.obj --is {properties} --read-as decimal");
        assert_eq!(shell.line(&line).code, 1, "{line}");
    }
    let line = "check surface.obj --with gauss.obj --is f-parallel,i-minimal";
    assert_eq!(shell.line(line).code, 3);
}

#[test]
fn make() {
    assert_snapshot!(Shell::new().session(&[
        "make saddle --n 1x2 -o saddle",
        "cat saddle/surface.iso.json",
        "cat saddle/gauss.iso.json",
        "make helicoid --n 2x3 -o new/helicoid --format json",
        "make enneper --n 4x4 -p center=1,2 -o enneper",
        "check enneper/surface.iso.json --with enneper/gauss.iso.json --is f-parallel,i-minimal,i-isothermic",
        "make enneper -p center=1/2,0 -o none",
        "make enneper -p centre=1,0 -o none",
        "make enneper -p center=1 -o none --format json",
        "make saddle -p size=1 -o none",
        "make logarithmoid -p half-angle=1/2,1/2 -o none",
        "make rotational-constant-k --n 2x1 -p curvature=2,bits=8 -o enclosed",
        "cat enclosed/surface.iso.json",
        "make rotational-constant-k --n 2x1 -p curvature=2 -o enclosed --format json",
        "make rotational-constant-k -p curvature=2,integral=-1,bits=0 -o none",
        "make hex-constant-k -p curvature=-1 -o none",
        "make hex-cmc -p mean=1,integral=100 -o none",
        "make conical-net --n 9x2 -o none",
        "make enneper --n 4 -o none",
        "make enneper -p 3 -o none",
        "make gyroid -o none",
        "make",
    ]));
}

#[test]
fn christoffel() {
    let shell = Shell::new();
    for family in ["enneper", "hex-minimal", "circular-net", "paraboloid"] {
        let run = shell.line(&format!("make {family} --n 2x2 -o {family}"));
        assert_eq!(run.code, 0, "{}", run.err);
    }
    assert_snapshot!(shell.session(&[
        "christoffel enneper/gauss.iso.json -o dual.iso.json",
        "cat dual.iso.json",
        "check enneper/gauss.iso.json --with dual.iso.json --is christoffel-dual",
        "check dual.iso.json --is i-isothermic,koenigs,i-minimal",
        "christoffel paraboloid/surface.iso.json -o dual.iso.json --format json",
        "check paraboloid/surface.iso.json --with dual.iso.json --is christoffel-dual",
        "christoffel circular-net/surface.iso.json -o none.iso.json",
        "christoffel circular-net/surface.iso.json -o none.iso.json --format json",
        "christoffel hex-minimal/surface.iso.json -o none.iso.json",
        "christoffel twisted.iso.json -o none.iso.json",
        "christoffel printed.obj -o none.iso.json",
        "christoffel vertical.obj -o none.iso.json",
        "christoffel pyramid.off -o none.iso.json",
        "christoffel cloud.obj -o none.obj",
        "check pyramid.off --is koenigs,i-isothermic,i-minimal,a-net",
        "check circular-net/surface.iso.json --is koenigs,i-isothermic,i-minimal",
    ]));
}
