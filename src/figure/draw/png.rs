//! Scenes as PNG.

use resvg::{tiny_skia, usvg};

use super::{Scene, svg};

const DOTS_PER_INCH: f32 = 300.0;
/// The longest side of a picture in millimetres.
const LONGEST: f64 = 2048.0;

/// The scene as a PNG picture for print: 300 dots per inch, which the file says. It shows what [`svg`]
/// shows, with texts in a font that the program brings, and is the same on every machine.
///
/// `None` for scenes without area, and for those with sides of more than two metres.
///
/// ```
/// use isogeo::figure::draw::{Scene, png};
/// let picture = png(&Scene::new(25.4, 12.7)).unwrap_or_default();
/// assert_eq!(picture[16..24], [0, 0, 1, 44, 0, 0, 0, 150]); // 300 by 150
/// ```
pub fn png(scene: &Scene) -> Option<Vec<u8>> {
    if !scene.size.iter().all(|side| (0.0..LONGEST).contains(side)) {
        return None;
    }
    let mut options = usvg::Options { dpi: DOTS_PER_INCH, ..usvg::Options::default() };
    let fonts = options.fontdb_mut();
    fonts.load_font_data(include_bytes!("font/roman.otf").to_vec());
    fonts.set_serif_family("Isogeo Roman");
    let tree = usvg::Tree::from_str(&svg(scene, ""), &options).ok()?;
    let size = tree.size().to_int_size();
    let (width, height) = (size.width(), size.height());
    let mut canvas = tiny_skia::Pixmap::new(width, height)?;
    // The page ends within the last pixels.
    canvas.fill(tiny_skia::Color::WHITE);
    resvg::render(&tree, tiny_skia::Transform::identity(), &mut canvas.as_mut());
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    let per_metre = (DOTS_PER_INCH / 0.0254).round() as u32;
    let unit = png::Unit::Meter;
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit }));
    let colors = canvas.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]);
    let mut writer = encoder.write_header().ok()?;
    writer.write_image_data(&colors.collect::<Vec<u8>>()).ok()?;
    writer.finish().ok()?;
    Some(bytes)
}
