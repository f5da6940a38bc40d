//! Scenes as TikZ, for LaTeX.

use std::fmt::Write;

use super::svg::number;
use super::{Anchor, Color, Item, Scene, Stroke};

/// The scene as a `tikzpicture` in millimetres, to be read by `\input`; it needs the package `tikz`
/// and nothing else. Texts are set in the document's own type.
pub fn tikz(scene: &Scene) -> String {
    let mut out =
        String::from("\\begin{tikzpicture}[x=1mm,y=1mm,line join=round,line cap=round]\n");
    let [width, height] = scene.size.map(number);
    let _ = writeln!(out, "\\useasboundingbox (0,0) rectangle ({width},{height});");
    let at = |[x, y]: [f64; 2]| format!("({},{})", number(x), number(y));
    let path = |points: &[[f64; 2]]| points.iter().map(|p| at(*p)).collect::<Vec<_>>().join("--");
    for item in &scene.items {
        let _ = match item {
            Item::Polygon { corners, fill, stroke } => {
                writeln!(out, "\\path[{}] {}--cycle;", options(*fill, *stroke), path(corners))
            }
            Item::Polyline { points, stroke } => {
                writeln!(out, "\\path[{}] {};", options(None, Some(*stroke)), path(points))
            }
            Item::Circle { center, radius, fill, stroke } => {
                let (options, radius) = (options(*fill, *stroke), number(radius.abs()));
                writeln!(out, "\\path[{options}] {} circle ({radius});", at(*center))
            }
            Item::Text { at: place, anchor, text, .. } => {
                let anchor = match anchor {
                    Anchor::Start => "base west",
                    Anchor::Middle => "base",
                    Anchor::End => "base east",
                };
                let text = escaped(text);
                writeln!(out, "\\node[anchor={anchor},inner sep=0] at {} {{{text}}};", at(*place))
            }
        };
    }
    out.push_str("\\end{tikzpicture}\n");
    out
}

fn color(Color([r, g, b]): Color) -> String {
    format!("{{rgb,255:red,{r};green,{g};blue,{b}}}")
}

fn options(fill: Option<Color>, stroke: Option<Stroke>) -> String {
    let fill = fill.map(|c| format!("fill={}", color(c)));
    let draw = stroke.map(|s| format!("draw={},line width={}mm", color(s.color), number(s.width)));
    fill.into_iter().chain(draw).collect::<Vec<_>>().join(",")
}

/// The text in LaTeX: special characters, and the mathematical ones that captions use.
fn escaped(text: &str) -> String {
    let one = |c: char| match c {
        '\\' => "\\textbackslash{}".to_string(),
        '{' | '}' | '%' | '#' | '&' | '_' | '$' => format!("\\{c}"),
        '^' => "\\textasciicircum{}".into(),
        '~' => "\\textasciitilde{}".into(),
        '<' | '>' | '=' => format!("${c}$"),
        '−' => "$-$".into(),
        '²' => "$^2$".into(),
        'Σ' => "$\\Sigma$".into(),
        'τ' => "$\\tau$".into(),
        '′' => "$'$".into(),
        _ => c.to_string(),
    };
    text.chars().map(one).collect()
}
