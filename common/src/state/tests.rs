//! States are stored to the last bit, and nothing else is taken for one.

use proptest::prelude::*;

use super::*;
use crate::color::Rgb;

fn state() -> State {
    let mut film = Film::new(Size::of::<19, 3>());
    for tile in film.tiles_mut() {
        for (x, y, pixel) in tile.pixels_mut() {
            // Not every pixel has the same number of samples.
            for i in 0..=(x + y) % 3 {
                #[allow(clippy::cast_precision_loss)]
                pixel.add(Rgb::new(x as f32 / 3.0, 1e30, if i == 1 { f32::NAN } else { -0.0 }));
            }
        }
    }
    let entries = [("picture", "ball"), ("knob 'ε'", "0.1"), ("", "")];
    let origin = Origin(entries.map(|(name, value)| (name.into(), value.into())).into());
    State { origin, goal: 7, film }
}

fn bytes_of(state: &State) -> Vec<u8> {
    let mut bytes = Vec::new();
    encode(&mut bytes, &state.origin, state.goal, &state.film).unwrap();
    bytes
}

/// Bytes with a fingerprint that fits.
fn sealed(mut content: Vec<u8>) -> Vec<u8> {
    let seal = Fingerprint::of(&content).bits();
    content.extend(seal.to_le_bytes());
    content
}

/// A file in a folder of its own.
fn file(name: &str) -> std::path::PathBuf {
    let folder = std::env::temp_dir().join(format!("course-state-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder.join("a.state")
}

#[test]
fn every_bit_comes_back() {
    let (state, file) = (state(), file("bits"));
    write(&file, &state.origin, state.goal, &state.film).unwrap();
    let again = read(&file).unwrap();
    assert_eq!((&again.origin, again.goal), (&state.origin, 7));
    assert_eq!(bytes_of(&again), bytes_of(&state));
    assert_eq!(again.film.pixel(1, 0), state.film.pixel(1, 0));
    assert_eq!((again.film.counts(), again.film.bad_samples()), ((1, 3), state.film.bad_samples()));
    check_writable(&file).unwrap();
    std::fs::remove_dir_all(file.parent().unwrap()).unwrap();
}

/// Every byte flipped in every bit, and the file cut off after every byte.
#[test]
fn all_damage_is_refused() {
    let whole = bytes_of(&state());
    assert!(decode(&whole).is_ok());
    for i in 0..whole.len() {
        for bit in 0..8 {
            let mut damaged = whole.clone();
            damaged[i] ^= 1 << bit;
            assert!(decode(&damaged).is_err(), "bit {bit} of byte {i}");
        }
        assert!(decode(&whole[..i]).is_err(), "cut off after {i}");
    }
    assert!(decode(&[&whole[..], &[0]].concat()).is_err());
    assert_eq!(decode(&whole[..5]).unwrap_err(), damaged());
    assert!(decode(b"").unwrap_err().starts_with("it is no state"));
    assert!(decode(b"\x89PNG\r\n\x1a\n").unwrap_err().starts_with("it is no state"));
    let mut newer = whole[..whole.len() - 8].to_vec();
    newer[8] = 2;
    assert_eq!(decode(&sealed(newer)).unwrap_err(), "it is of version 2, and this program reads version 1");
}

#[test]
fn nothing_else_is_replaced() {
    let file = file("else");
    std::fs::write(&file, "my thesis").unwrap();
    assert!(check_writable(&file).unwrap_err().to_string().contains("no state of a rendering"));
    assert_eq!(std::fs::read(&file).unwrap(), b"my thesis");
    assert!(read(&file).unwrap_err().to_string().contains("--save-state makes one"));
    let folder = file.parent().unwrap();
    assert!(check_writable(folder).is_err() && read(folder).is_err());
    assert!(read(&folder.join("missing")).unwrap_err().to_string().starts_with("cannot read "));
    std::fs::write(&file, "").unwrap();
    check_writable(&file).unwrap();
    std::fs::remove_dir_all(folder).unwrap();
}

proptest! {
    /// Not even a file whose fingerprint fits makes a panic.
    #[test]
    fn forged_files_do_not_panic(edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4)) {
        let mut content = bytes_of(&state());
        content.truncate(content.len() - 8);
        for (at, byte) in edits {
            // Mostly near the beginning, where the lengths are.
            let at = at.index(content.len() * 2);
            let at = if at < content.len() { at } else { at % 90 };
            content[at] = byte;
        }
        let _ = decode(&sealed(content));
    }

    #[test]
    fn noise_behind_a_good_beginning_does_not_panic(noise in prop::collection::vec(any::<u8>(), 0..300)) {
        let content = [&MAGIC[..], &VERSION.to_le_bytes(), &noise].concat();
        let _ = decode(&sealed(content));
    }
}
