//! Scenes as SVG.

use std::fmt::Write;

use super::{Anchor, Item, Scene, Stroke};

/// A number with two decimals and no needless zero.
pub(super) fn number(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// The scene as an SVG document in millimetres; coordinates are rounded to a hundredth.
pub fn svg(scene: &Scene, title: &str) -> String {
    let [width, height] = scene.size.map(number);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" \
         viewBox=\"0 0 {width} {height}\">\n<title>{}</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n\
         <g stroke-linejoin=\"round\" stroke-linecap=\"round\" \
         font-family=\"Latin Modern Roman,Palatino,Georgia,serif\">\n",
        escaped(title)
    );
    let at = |[x, y]: [f64; 2]| (number(x), number(scene.size[1] - y));
    let list = |points: &[[f64; 2]]| {
        let text = points.iter().map(|p| {
            let (x, y) = at(*p);
            format!("{x},{y}")
        });
        text.collect::<Vec<_>>().join(" ")
    };
    for item in &scene.items {
        // Writing to a string does not fail.
        let _ = match item {
            Item::Polygon { corners, fill, stroke } => writeln!(
                out,
                "<polygon points=\"{}\"{}{}/>",
                list(corners),
                fill_of(fill.map(|c| c.to_string())),
                stroke_of(*stroke)
            ),
            Item::Polyline { points, stroke } => writeln!(
                out,
                "<polyline points=\"{}\" fill=\"none\"{}/>",
                list(points),
                stroke_of(Some(*stroke))
            ),
            Item::Circle { center, radius, fill, stroke } => {
                let (x, y) = at(*center);
                writeln!(
                    out,
                    "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\"{}{}/>",
                    number(radius.abs()),
                    fill_of(fill.map(|c| c.to_string())),
                    stroke_of(*stroke)
                )
            }
            Item::Text { at: place, size, anchor, text } => {
                let (x, y) = at(*place);
                let anchor = match anchor {
                    Anchor::Start => "start",
                    Anchor::Middle => "middle",
                    Anchor::End => "end",
                };
                writeln!(
                    out,
                    "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" text-anchor=\"{anchor}\" \
                     fill=\"#1b2a41\">{}</text>",
                    number(*size),
                    escaped(text)
                )
            }
        };
    }
    out.push_str("</g>\n</svg>\n");
    out
}

fn fill_of(color: Option<String>) -> String {
    format!(" fill=\"{}\"", color.as_deref().unwrap_or("none"))
}

fn stroke_of(stroke: Option<Stroke>) -> String {
    stroke.map_or(String::new(), |s| {
        format!(" stroke=\"{}\" stroke-width=\"{}\"", s.color, number(s.width))
    })
}

/// A text in a document of marks.
pub(in crate::figure) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
