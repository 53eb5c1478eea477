//! `{{#figure chapter/picture Caption.}}` and `{{#pictures chapter}}`: the pictures that the snapshot tests have
//! pinned, with what they show in words and the command that makes them.

use std::fs;

use common::{
    knob::Knob,
    picture::{Chapter, ORBIT, Picture},
};

use crate::{
    expand::{Block, Page},
    house::House,
    output::{Output, escape},
};

/// Where the tests pin a picture, relative to the root.
pub(crate) fn snapshot(chapter: &str, picture: &str) -> String {
    format!("tests/snapshots/{chapter}/{picture}.snap.png")
}

/// A picture with its caption.
pub(crate) fn block(page: &Page<'_>, name: &str, caption: Block, output: &mut Output) -> Result<Block, String> {
    let (chapter, picture) = page.house.picture(name)?;
    figure(page, chapter, picture, caption, output)
}

/// All pictures of a chapter, each under a heading with its knobs.
pub(crate) fn gallery(page: &Page<'_>, chapter: &str, output: &mut Output) -> Result<Block, String> {
    let chapter = page.house.chapter(chapter)?;
    let mut block = Block::default();
    for picture in chapter.pictures {
        let mut caption = Block::default();
        caption.push(&escape(picture.alt));
        block.push(&format!("\n## `{0}` {{#picture-{0}}}\n", picture.name));
        block.append(figure(page, chapter, picture, caption, output)?);
        block.push(&knobs(picture.knobs));
    }
    Ok(block)
}

/// A picture as HTML, with a caption in Markdown.
fn figure(
    page: &Page<'_>,
    chapter: &Chapter,
    picture: &Picture,
    caption: Block,
    output: &mut Output,
) -> Result<Block, String> {
    let [width, height] = size(page.house, chapter, picture)?;
    let (name, alt) = (picture.name, escape(picture.alt.trim()));
    if alt.is_empty() {
        return Err(format!("the picture `{}/{name}` does not say in `alt` what is to be seen", chapter.name));
    }
    let file = format!("{}pictures/{}/{name}.png", page.to_root(), chapter.name);
    let mut block = Block::default();
    block.push("<figure class=\"picture\">");
    block.push(&format!(
        "<a href=\"{file}\"><img src=\"{file}\" alt=\"{alt}\" width=\"{width}\" height=\"{height}\" loading=\"lazy\"></a>"
    ));
    if let Some(live) = output.module.as_ref().and_then(|module| module.place(page, chapter, picture)) {
        block.push(&output.on_screen(live));
    }
    block.push("<figcaption>\n");
    block.append(caption);
    // As ready HTML, or mdBook makes a dash of the two hyphens.
    let samples = course::poster_samples(chapter.name, picture).map(|n| format!(" --samples {n}")).unwrap_or_default();
    let command = format!("<code class=\"command\">cargo run -p {} -- {name}{samples}</code>", chapter.name);
    block.push(&format!("\n{}\n\n</figcaption>\n</figure>", output.inline(command)));
    output.pictures.insert(format!("{}/{name}", chapter.name));
    Ok(block)
}

/// Width and height in pixels of a pinned picture.
fn size(house: &House, chapter: &Chapter, picture: &Picture) -> Result<[u32; 2], String> {
    let file = snapshot(chapter.name, picture.name);
    let bytes = fs::read(house.path(&file)).map_err(|_| {
        format!(
            "the picture `{}/{}` has no snapshot `{file}`: the tests of the pictures make it",
            chapter.name, picture.name
        )
    })?;
    png_size(&bytes).ok_or_else(|| format!("the snapshot `{file}` is no PNG"))
}

/// Width and height from the header of a PNG: a signature of eight bytes, then the chunk IHDR.
fn png_size(bytes: &[u8]) -> Option<[u32; 2]> {
    let header = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n")?;
    let (width, rest) = header.get(8..)?.split_first_chunk()?;
    let (height, _) = rest.split_first_chunk()?;
    Some([u32::from_be_bytes(*width), u32::from_be_bytes(*height)])
}

/// The knobs of a picture as a table.
fn knobs(knobs: &[Knob]) -> String {
    let is_camera = |knob: &&Knob| ORBIT.iter().any(|orbit| orbit.name == knob.name);
    let rows: String = knobs
        .iter()
        .filter(|knob| !is_camera(knob))
        .map(|knob| {
            let default = knob.show(knob.default());
            format!("| `{}` | {} | {} | {default} |\n", knob.name, escape(knob.what), escape(&knob.range()))
        })
        .collect();
    let table = if rows.is_empty() {
        rows
    } else {
        format!("\n| knob | what it does | values | default |\n|---|---|---|---|\n{rows}")
    };
    let camera: Vec<_> = knobs.iter().filter(is_camera).map(|knob| format!("`{}`", knob.name)).collect();
    let camera =
        if camera.is_empty() { String::new() } else { format!("\nThe camera moves by {}.\n", camera.join(", ")) };
    table + &camera
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn size_is_read_from_the_header() {
        let png = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x02\x80\0\0\x01\xe0\x08\x02";
        assert_eq!(png_size(png), Some([640, 480]));
        assert_eq!(png_size(b"GIF89a"), None);
        assert_eq!(png_size(&png[..17]), None);
    }
}
