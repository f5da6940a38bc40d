//! Scenes as PDF.

use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, Str, TextStr};

use super::{Anchor, Color, Item, Scene, Stroke};

/// Points in a millimetre.
const POINTS: f64 = 72.0 / 25.4;

/// The scene as a PDF page of its size; version 1.5, which every LaTeX takes. Texts are set in Times.
pub fn pdf(scene: &Scene, title: &str) -> Vec<u8> {
    let mut document = Pdf::new();
    document.set_version(1, 5);
    let [catalog, pages, page, content, font, info] = [1, 2, 3, 4, 5, 6].map(Ref::new);
    document.catalog(catalog).pages(pages);
    document.pages(pages).kids([page]).count(1);
    let [width, height] = scene.size.map(points);
    let mut sheet = document.page(page);
    sheet.media_box(Rect::new(0.0, 0.0, width, height)).parent(pages).contents(content);
    sheet.resources().fonts().pair(Name(b"F"), font);
    sheet.finish();
    document
        .type1_font(font)
        .base_font(Name(b"Times-Roman"))
        .encoding_predefined(Name(b"WinAnsiEncoding"));
    document.document_info(info).title(TextStr(title));
    let mut drawn = Content::new();
    drawn.set_line_join(LineJoinStyle::RoundJoin).set_line_cap(LineCapStyle::RoundCap);
    for item in &scene.items {
        draw(&mut drawn, item);
    }
    document.stream(content, &drawn.finish());
    document.finish()
}

/// Millimetres in points, rounded to a thousandth.
fn points(millimetres: f64) -> f32 {
    ((millimetres * POINTS * 1e3).round() / 1e3) as f32
}

fn draw(content: &mut Content, item: &Item) {
    match item {
        Item::Polygon { corners, fill, stroke } => {
            path(content, corners);
            content.close_path();
            paint(content, *fill, *stroke);
        }
        Item::Polyline { points, stroke } => {
            path(content, points);
            paint(content, None, Some(*stroke));
        }
        Item::Circle { center, radius, fill, stroke } => {
            circle(content, *center, radius.abs());
            paint(content, *fill, *stroke);
        }
        Item::Text { at, size, anchor, text } => {
            let bytes: Vec<u8> = text.chars().map(win_ansi).collect();
            // The mean width of a character of Times is near 0.46 of its height.
            let width = 0.46 * size * bytes.len() as f64;
            let shift = match anchor {
                Anchor::Start => 0.0,
                Anchor::Middle => width / 2.0,
                Anchor::End => width,
            };
            color(content, Color::INK, true);
            content.begin_text().set_font(Name(b"F"), points(*size));
            content.next_line(points(at[0] - shift), points(at[1]));
            content.show(Str(&bytes)).end_text();
        }
    }
}

fn path(content: &mut Content, corners: &[[f64; 2]]) {
    for (i, [x, y]) in corners.iter().enumerate() {
        let (x, y) = (points(*x), points(*y));
        if i == 0 {
            content.move_to(x, y)
        } else {
            content.line_to(x, y)
        };
    }
}

/// Four cubic arcs; they miss the circle by 0.03 percent.
fn circle(content: &mut Content, [x, y]: [f64; 2], r: f64) {
    const HANDLE: f64 = 0.552_284_75;
    let at = |u: f64, v: f64| [points(x + r * u), points(y + r * v)];
    let [a, b] = at(1.0, 0.0);
    content.move_to(a, b);
    for [[p, q], [s, t], [u, v]] in [
        [[1.0, HANDLE], [HANDLE, 1.0], [0.0, 1.0]],
        [[-HANDLE, 1.0], [-1.0, HANDLE], [-1.0, 0.0]],
        [[-1.0, -HANDLE], [-HANDLE, -1.0], [0.0, -1.0]],
        [[HANDLE, -1.0], [1.0, -HANDLE], [1.0, 0.0]],
    ] {
        let ([p, q], [s, t], [u, v]) = (at(p, q), at(s, t), at(u, v));
        content.cubic_to(p, q, s, t, u, v);
    }
    content.close_path();
}

fn paint(content: &mut Content, fill: Option<Color>, stroke: Option<Stroke>) {
    if let Some(fill) = fill {
        color(content, fill, true);
    }
    if let Some(stroke) = stroke {
        color(content, stroke.color, false);
        content.set_line_width(points(stroke.width));
    }
    match (fill, stroke) {
        (Some(_), Some(_)) => content.fill_nonzero_and_stroke(),
        (Some(_), None) => content.fill_nonzero(),
        (None, Some(_)) => content.stroke(),
        (None, None) => content.end_path(),
    };
}

fn color(content: &mut Content, Color(rgb): Color, fill: bool) {
    let [r, g, b] = rgb.map(|c| f32::from(c) / 255.0);
    if fill {
        content.set_fill_rgb(r, g, b)
    } else {
        content.set_stroke_rgb(r, g, b)
    };
}

/// A character in the encoding of the font.
fn win_ansi(c: char) -> u8 {
    match c {
        '−' => b'-',
        '′' => b'\'',
        c => u8::try_from(u32::from(c)).unwrap_or(b'?'),
    }
}
