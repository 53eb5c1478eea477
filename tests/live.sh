#!/usr/bin/env bash
# Opens a page of the built book in Chromium, from disk and without a network, and runs its live pictures as a reader
# would: the picture must be the one of the command line to the last pixel, the knobs and the mouse must change it.
# Needs chromium and node, and before it tests/wasm.sh and cargo book.
set -euo pipefail
cd "$(dirname "$0")/.."
browser=
for name in chromium chromium-browser google-chrome; do
  command -v "$name" >/dev/null 2>&1 && { browser=$name; break; }
done
[ -n "$browser" ] || { echo "error: no chromium: install it to test the live pictures" >&2; exit 1; }
compgen -G "target/book/live/course-*.js" >/dev/null ||
  { echo "error: target/book has no live pictures: run tests/wasm.sh, then cargo book" >&2; exit 1; }
folder=$(mktemp -d)
# The browser's other processes may write for a moment after it has ended: what they leave is no failure of the test.
clean() { for _ in 1 2 3 4 5; do rm -rf "$folder" 2>/dev/null && return; sleep 1; done; true; }
trap clean EXIT
# The same pictures by the commands that stand under them.
for picture in sphere far-sphere; do
  size=$([ "$picture" = sphere ] && echo 640x360 || echo 640x320)
  cargo run --quiet -p ray-casting -- "$picture" --size "$size" --no-window --quiet --output "$folder/$picture.png"
done
timeout 300 node tests/live.mjs "$browser" "$folder" "$PWD/target/book/01-ray-casting/spheres.html"
