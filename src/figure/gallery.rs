//! The page that shows all figures.

use std::fmt::Write;

use super::draw::{escaped, svg};
use super::{Exhibit, Figure, Plate};

/// A Markdown page for the folder of the figures: pictures, captions, and what is checked of each mesh.
pub fn gallery(figures: &[(&Figure, Plate)]) -> String {
    let mut page = String::from(
        "# Figures\n\nThe figures of Pottmann and Liu (2007), made anew: the parameters of the paper are \
         not known, so these are others. Every mesh is exact, and what a table says of it has been proved \
         before the picture was drawn. In each folder `fig-NN.json` says the same for programs, with \
         circles and curvatures as exact numbers. All is written by \
         `isogeo figure all --out paper_figures --as json,svg`, and compared by the same with \
         `--check`.\n",
    );
    for (figure, plate) in figures {
        let (number, title, folder) = (figure.number, figure.title, figure.folder());
        // Writing to a string does not fail.
        let _ = write!(
            page,
            "\n## Fig. {number}: {title}\n\n![{title}]({folder}/{folder}.svg)\n\n{}\n\n\
             | mesh | faces | is |\n| --- | --- | --- |\n",
            figure.caption.replace('*', "\\*")
        );
        for exhibit in &plate.exhibits {
            let (name, faces) = (exhibit.name, exhibit.mesh.topology.face_count());
            let says = said(exhibit);
            let _ = writeln!(page, "| [{name}]({folder}/{name}.iso.json) | {faces} | {says} |");
        }
    }
    page
}

/// The same as one HTML page with the pictures in it; each leads to the page of its meshes.
pub fn index(figures: &[(&Figure, Plate)]) -> String {
    let mut page = String::from(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Figures</title>\n\
         <style>body { max-width: 60em; margin: 2em auto; padding: 0 1em; font: 16px/1.45 Palatino, \
         Georgia, serif; color: #1b2a41; } svg { width: 100%; height: auto; }</style>\n</head>\n<body>\n\
         <h1>Figures</h1>\n",
    );
    for (figure, plate) in figures {
        let (number, folder) = (figure.number, figure.folder());
        let (title, caption) = (escaped(figure.title), escaped(figure.caption));
        // Writing to a string does not fail.
        let _ = write!(
            page,
            "<h2>Fig. {number}: {title}</h2>\n<a href=\"{folder}/{folder}.html\">\n{}</a>\n\
             <p>{caption}</p>\n",
            svg(&plate.scene, figure.title)
        );
    }
    page.push_str("</body>\n</html>\n");
    page
}

/// Everything that is checked of an exhibit; the partners in the order in which they come.
fn said(exhibit: &Exhibit) -> String {
    let mut parts: Vec<String> = exhibit.holds.iter().map(|p| p.name().to_owned()).collect();
    parts.extend(exhibit.shown.iter().map(|remark| remark.says.to_owned()));
    let with = exhibit.with.iter();
    parts.extend(with.map(|(image, property)| format!("{} with {image}", property.name())));
    parts.join(", ")
}
