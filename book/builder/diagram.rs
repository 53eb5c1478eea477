//! A graph as a picture that follows the reader's theme, and as a list of words.

use std::fmt::Write;

use crate::{
    graph::Graph,
    layout::{Layout, Spot},
    output::escape,
};

/// Height of a box.
const HEIGHT: f64 = 30.0;
/// From one layer to the next.
const STEP: f64 = 78.0;
/// Width of a letter, about.
const LETTER: f64 = 8.4;
/// Space at the borders of the picture.
const MARGIN: f64 = 4.0;
/// Width below which a picture is scrolled and not shrunk, so that it stays readable.
const LEAST: f64 = 640.0;
/// Length of an arrow's head.
const HEAD: f64 = 8.0;

/// A drawn graph, ready for a page. `verb` says what an arrow means: 'knows'.
pub(crate) fn draw(graph: &Graph, title: &str, verb: &str) -> String {
    let widths: Vec<_> = graph.names.iter().map(|name| name.chars().count() as f64 * LETTER + 22.0).collect();
    let layout = Layout::new(graph, &widths);
    let words = words(graph);
    let plain: String = words.iter().map(|(who, whom)| format!("{who} {verb} {whom}. ")).collect();
    let (width, height) = (layout.width + 2.0 * MARGIN, layout.layers as f64 * STEP - STEP + HEIGHT + 2.0 * MARGIN);
    let (title, plain) = (escape(title), escape(plain.trim_end()));

    let mut html = String::from("<figure class=\"diagram\">\n<div class=\"scroll\">\n");
    let least = width.min(LEAST);
    let _ = writeln!(
        html,
        "<svg role=\"img\" aria-label=\"{title}\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" \
         height=\"{height:.0}\" style=\"min-width: {least:.0}px\">\n<title>{title}</title>\n<desc>{plain}</desc>"
    );
    // A thing and its arrows are a group, so that they can light up together.
    for (thing, (name, spot)) in graph.names.iter().zip(&layout.spots).enumerate() {
        html.push_str("<g class=\"thing\">\n");
        for (&arrow, way) in graph.arrows.iter().zip(&layout.ways).filter(|((from, _), _)| *from == thing) {
            // An arrow that follows from others ends where another one has its head.
            let _ = match graph.is_implied(arrow) {
                true => writeln!(html, "<g class=\"arrow implied\">{}</g>", line(&layout, way)),
                false => writeln!(html, "<g class=\"arrow\">{}{}</g>", line(&layout, way), head(&layout, way)),
            };
        }
        let (x, y) = middle(&layout, spot);
        let _ = writeln!(
            html,
            "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{HEIGHT}\" rx=\"5\"/>\
             <text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>\n</g>",
            x - spot.width / 2.0,
            y - HEIGHT / 2.0,
            spot.width,
            y + 5.0,
            escape(name),
        );
    }
    let _ = write!(html, "</svg>\n</div>\n<figcaption>{title}. An arrow means '{verb}'");
    if graph.arrows.iter().any(|&arrow| graph.is_implied(arrow)) {
        html.push_str("; it is faint where it follows from others");
    }
    html.push_str(".</figcaption>\n<details>\n<summary>The same in words</summary>\n<ul>\n");
    for (who, whom) in &words {
        let _ = writeln!(html, "<li><code>{}</code> {verb} {}</li>", escape(who), escape(whom));
    }
    html.push_str("</ul>\n</details>\n</figure>");
    html
}

/// Who knows whom, from the top of the diagram to its bottom.
fn words(graph: &Graph) -> Vec<(String, String)> {
    let layers = graph.layers();
    let mut order: Vec<_> = (0..graph.names.len()).collect();
    order.sort_by_key(|&thing| std::cmp::Reverse(layers[thing]));
    let names = |from| graph.known_by(from).map(|to| graph.names[to].as_str()).collect::<Vec<_>>();
    let whom = |from| match names(from).as_slice() {
        [] => "nobody".to_owned(),
        [only] => (*only).to_owned(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    };
    order.into_iter().map(|thing| (graph.names[thing].clone(), whom(thing))).collect()
}

/// The middle of a spot in the picture.
fn middle(layout: &Layout, spot: &Spot) -> (f64, f64) {
    let from_top = (layout.layers - 1 - spot.layer) as f64;
    (spot.x + MARGIN, from_top * STEP + HEIGHT / 2.0 + MARGIN)
}

/// The line of an arrow: smooth from spot to spot, straight through the layers that it passes.
fn line(layout: &Layout, way: &[usize]) -> String {
    let mut data = String::new();
    for (index, step) in way.windows(2).enumerate() {
        let [(x0, y0), (x1, y1)] = [step[0], step[1]].map(|spot| middle(layout, &layout.spots[spot]));
        let is_last = index + 2 == way.len();
        let (top, bottom) = (y0 + HEIGHT / 2.0, y1 - HEIGHT / 2.0 - if is_last { HEAD } else { 0.0 });
        let half = (top + bottom) / 2.0;
        let to = if index == 0 { 'M' } else { 'L' };
        let _ = write!(data, "{to}{x0:.1} {top:.1}C{x0:.1} {half:.1} {x1:.1} {half:.1} {x1:.1} {bottom:.1}");
    }
    format!("<path d=\"{data}\"/>")
}

/// The head of an arrow, on top of the box where it ends.
fn head(layout: &Layout, way: &[usize]) -> String {
    let Some(&last) = way.last() else { return String::new() };
    let (x, y) = middle(layout, &layout.spots[last]);
    let (tip, base, wing) = (y - HEIGHT / 2.0, y - HEIGHT / 2.0 - HEAD, HEAD * 0.45);
    format!("<polygon points=\"{x:.1},{tip:.1} {:.1},{base:.1} {:.1},{base:.1}\"/>", x - wing, x + wing)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn diagram_says_in_words_what_it_shows() {
        let names = ["scene", "shape", "ray"].map(String::from).to_vec();
        let graph = Graph { names, arrows: [(0, 1), (1, 2), (0, 2)].into() };
        let html = draw(&graph, "Who knows whom", "knows");
        assert!(html.contains("<li><code>scene</code> knows shape and ray</li>"), "{html}");
        assert!(html.contains("<li><code>ray</code> knows nobody</li>"), "{html}");
        assert!(
            html.contains("aria-label=\"Who knows whom\"") && html.contains("<desc>scene knows shape and ray."),
            "{html}"
        );
        assert_eq!(html.matches("class=\"arrow implied\"").count(), 1);
        assert_eq!(html.matches("class=\"arrow\"").count(), 2);
        assert!(!html.contains("\n\n") && !html.contains(" id="), "{html}");
    }
}
