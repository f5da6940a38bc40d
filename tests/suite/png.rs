//! PNG pictures: their size, their colours, their texts.

use isogeo::figure::Figure;
use isogeo::figure::draw::{Anchor, Color, Item, Scene, png};

struct Picture {
    size: [u32; 2],
    per_metre: Option<(u32, u32)>,
    colors: Vec<[u8; 3]>,
}

impl Picture {
    fn of(scene: &Scene) -> Picture {
        let bytes = png(scene).expect("a picture");
        let decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        let mut reader = decoder.read_info().expect("a head");
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        reader.next_frame(&mut pixels).expect("pixels");
        let info = reader.info();
        assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgb, png::BitDepth::Eight));
        Picture {
            size: [info.width, info.height],
            per_metre: info.pixel_dims.map(|d| (d.xppu, d.yppu)),
            colors: pixels.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect(),
        }
    }

    /// The colour at a place of the scene.
    fn at(&self, [x, y]: [f64; 2]) -> [u8; 3] {
        let pixels = |millimetres: f64| (millimetres * 300.0 / 25.4) as usize;
        self.colors[(self.size[1] as usize - pixels(y) - 1) * self.size[0] as usize + pixels(x)]
    }
}

#[test]
fn a_picture_has_the_size_of_its_scene() {
    let mut scene = Scene::new(50.8, 25.4);
    let corners = vec![[10.0, 5.0], [20.0, 5.0], [20.0, 10.0], [10.0, 10.0]];
    scene.items.push(Item::Polygon { corners, fill: Some(Color::FRONT), stroke: None });
    let picture = Picture::of(&scene);
    assert_eq!((picture.size, picture.per_metre), ([600, 300], Some((11811, 11811))));
    for (at, color) in [
        ([10.2, 5.2], Color::FRONT),
        ([9.8, 5.2], Color::WHITE),
        ([19.8, 9.8], Color::FRONT),
        ([19.8, 10.2], Color::WHITE),
    ] {
        assert_eq!(picture.at(at), color.0, "{at:?}");
    }
    for size in [[0.0, 5.0], [5.0, f64::NAN], [3000.0, 5.0], [f64::INFINITY, 5.0]] {
        assert_eq!(png(&Scene::new(size[0], size[1])), None, "{size:?}");
    }
}

#[test]
fn all_figures_are_white_to_the_edges() {
    for figure in &Figure::ALL {
        let scene = figure.plate().expect("a plate").scene;
        let picture = Picture::of(&scene);
        let pixels = scene.size.map(|s| (s * 300.0 / 25.4).round() as u32);
        assert_eq!(picture.size, pixels, "figure {}", figure.number);
        let [width, height] = picture.size.map(|n| n as usize);
        let edge = |i: usize| {
            [0, width - 1].contains(&(i % width)) || [0, height - 1].contains(&(i / width))
        };
        let rim = picture.colors.iter().enumerate().filter(|(i, _)| edge(*i));
        assert!(
            rim.clone().count() > 2000 && rim.clone().all(|(_, c)| *c == [255; 3]),
            "figure {}",
            figure.number
        );
        let drawn = picture.colors.iter().filter(|c| **c != [255; 3]).count();
        assert!(drawn > picture.colors.len() / 50, "figure {}", figure.number);
    }
}

#[test]
fn the_font_has_all_characters_of_figures() {
    let letter = |c: char| {
        let mut scene = Scene::new(8.0, 8.0);
        scene.text([4.0, 2.0], 5.0, Anchor::Middle, c);
        Picture::of(&scene).colors
    };
    let missing = letter('Ж');
    assert_eq!(letter('τ'), missing);
    let mut characters: Vec<char> = ('!'..='~').chain(['²', 'Σ', '−']).collect();
    for figure in &Figure::ALL {
        let items = figure.plate().expect("a plate").scene.items;
        for item in items {
            if let Item::Text { text, .. } = item {
                characters.extend(text.chars().filter(|c| *c != ' '));
            }
        }
    }
    characters.sort_unstable();
    characters.dedup();
    let pictures: Vec<_> = characters.iter().map(|c| letter(*c)).collect();
    for (i, picture) in pictures.iter().enumerate() {
        assert!(*picture != missing, "{}", characters[i]);
        assert!(!pictures[..i].contains(picture), "{}", characters[i]);
    }
}
