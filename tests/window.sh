#!/usr/bin/env bash
# Opens the window of a chapter on a display of its own, presses keys as a person would, and looks at what is saved.
# Needs Xvfb and xdotool.
set -euo pipefail
cd "$(dirname "$0")/.."
cargo build --quiet -p ray-casting
program=$PWD/target/debug/ray-casting
folder=$(mktemp -d)
xvfb=
trap 'kill $xvfb 2>/dev/null || true; rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "error: $1" >&2; cat log >&2; exit 1; }

# A display with a free number, which Xvfb tells.
exec 3>number
Xvfb -displayfd 3 -screen 0 1024x768x24 >/dev/null 2>&1 &
xvfb=$!
exec 3>&-
for _ in $(seq 100); do [ -s number ] && break; sleep 0.1; done
[ -s number ] || { echo "error: Xvfb does not start" >&2; exit 1; }
DISPLAY=:$(cat number)
export DISPLAY
unset WAYLAND_DISPLAY

options=(still-life --size 320x180 --samples 4 --quiet)
"$program" "${options[@]}" --no-window --output plain.png
"$program" "${options[@]}" --set yaw=-5 --no-window --output turned.png

# Holding a key for a moment is what a person does.
key() { xdotool keydown "$1"; sleep 0.1; xdotool keyup "$1"; sleep 0.5; }

"$program" "${options[@]}" --output window.png 2>log &
shown=$!
for _ in $(seq 100); do
  xdotool search --name 'still-life' >/dev/null 2>&1 && break
  kill -0 $shown 2>/dev/null || fail "no window"
  sleep 0.1
done
sleep 1.5
key s
cmp -s window.png plain.png || fail "S does not save the picture that is shown"
rm window.png
key h
key h
key Left
sleep 1
key Escape
for _ in $(seq 50); do kill -0 $shown 2>/dev/null || break; sleep 0.1; done
wait $shown || fail "Esc does not end the program well"
cmp -s window.png turned.png || fail "the arrow key does not turn the camera by 5 degrees"
echo "the window: opens, saves, turns, quits"
