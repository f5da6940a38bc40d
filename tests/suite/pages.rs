//! Pages: self-contained, and a browser that has nothing else shows them.

use std::path::PathBuf;
use std::process::Command;

use isogeo::construct::minimal::saddle;
use isogeo::figure::page::{Sight, page};
use isogeo::scalar::{Field, Rational};

fn saddle_page() -> String {
    let pair = saddle::<Rational>(3, 3).expect("a saddle");
    let mut surface = pair.surface;
    let faces = surface.topology.face_count() as i64;
    let values = (0..faces).map(|n| Rational::from_ratio(n - 4, 3)).collect();
    surface.data.face.insert("K".into(), values);
    let sight = |name: &str, color| Sight {
        name: name.into(),
        mesh: &surface,
        gauss: Some(&pair.gauss),
        color,
    };
    page("A <saddle>", "K & H", &[sight("M", Some("K")), sight("</script>", None)])
}

#[test]
fn a_page_asks_for_nothing_and_cannot_be_broken_out_of() {
    let text = saddle_page();
    assert!(text.contains("default-src 'none'"));
    for word in ["http://", "https://", "src=", "@import", "url("] {
        assert!(!text.contains(word), "{word}");
    }
    assert!(text.contains("<title>A &lt;saddle&gt;</title>") && text.contains("K &amp; H"));
    assert_eq!(text.matches("</script>").count(), 2);
    assert!(text.len() < 60_000, "{} bytes", text.len());
}

/// What the page is asked to do, and to write down where the test finds it.
const PROBE: &str = r##"
<script>
const note = {};
const tally = (c) => {
  const sheet = document.createElement("canvas");
  [sheet.width, sheet.height] = [c.width, c.height];
  const pen = sheet.getContext("2d");
  pen.drawImage(c, 0, 0);
  const pixels = pen.getImageData(0, 0, c.width, c.height).data;
  const colors = new Set();
  for (let i = 0; i < pixels.length; i += 4) colors.add(pixels[i] * 65536 + pixels[i + 1] * 256 + pixels[i + 2]);
  return colors.size;
};
const point = (x, y) => stage.dispatchEvent(new PointerEvent("pointermove", { clientX: x, clientY: y, bubbles: true }));
note.drawn = stage.dataset.drawn;
note.colors = tally(document.querySelector("#stage canvas"));
point(flat[0][3 * 5], flat[0][3 * 5 + 1]);
note.vertex = tip.textContent;
const face = data.meshes[0].faces[0];
const middle = [0, 1].map((k) => face.reduce((sum, v) => sum + flat[0][3 * v + k], 0) / 4);
point(...middle);
note.face = tip.textContent;
state.top = 1; state.sx = 0.5; redraw(); draw();
note.circles = tally(document.querySelectorAll("#stage canvas")[1]);
note.address = location.hash;
note.errors = window.errors;
document.title = "NOTE" + JSON.stringify(note) + "END";
</script>
"##;

fn browser() -> Option<PathBuf> {
    let names = ["chromium", "chromium-browser", "google-chrome"];
    let path = std::env::var_os("PATH")?;
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    names.iter().flat_map(|name| folders.iter().map(move |f| f.join(name))).find(|p| p.is_file())
}

/// What the page wrote down.
fn seen(browser: &PathBuf, query: &str) -> serde_json::Value {
    let folder = std::env::temp_dir().join(format!("isogeo-page-{}-{query}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let trap = "<script>window.errors = []; addEventListener('error', (e) => errors.push(e.message));</script>";
    let text = saddle_page().replace("<style>", &format!("{trap}<style>"));
    let text = text.replace("</body>", &format!("{PROBE}</body>"));
    let file = folder.join("page.html");
    std::fs::write(&file, text).expect("the page");
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader"])
        .args(["--enable-unsafe-swiftshader", "--window-size=900,600", "--dump-dom"])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("file://{}?{query}", file.display()))
        .output()
        .expect("the browser runs");
    let dom = String::from_utf8_lossy(&output.stdout).into_owned();
    let _ = std::fs::remove_dir_all(&folder);
    let note = dom.split_once("NOTE").and_then(|(_, rest)| rest.split_once("END"));
    let note = note.unwrap_or_else(|| panic!("the page wrote nothing:\n{dom}")).0;
    serde_json::from_str(&note.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
        .expect("a note")
}

#[test]
fn a_browser_shows_the_mesh_and_its_exact_numbers() {
    let Some(browser) = browser() else {
        eprintln!("no Chromium here: pages are not looked at");
        return;
    };
    for query in ["canvas", "webgl"] {
        let note = seen(&browser, query);
        assert_eq!(note["drawn"], query);
        assert_eq!(note["errors"], serde_json::json!([]), "{query}");
        assert!(note["colors"].as_u64() > Some(10), "{query}: {}", note["colors"]);
        assert!(note["circles"].as_u64() > Some(5), "{query}: {}", note["circles"]);
        assert_eq!(note["address"], "#sx=0.5&top=1");
        let text = |key: &str| note[key].as_str().unwrap_or_default().to_string();
        assert!(text("vertex").starts_with("M: vertex 5\nx = "), "{}", text("vertex"));
        assert!(text("face").ends_with("K = -4/3"), "{}", text("face"));
    }
}
