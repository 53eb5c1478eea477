#!/usr/bin/env bash
# Compiles common and every chapter to WebAssembly, runs all pictures in node and compares their bits with
# tests/bits.txt. Needs the target wasm32-unknown-unknown: from rustup, or on Debian from the packages rustc-web,
# cargo-web, rust-web-src and lld.
set -euo pipefail
cd "$(dirname "$0")/.."
command=(cargo build)
if command -v rustup >/dev/null 2>&1 && rustup target list --installed | grep wasm32-unknown-unknown >/dev/null; then
  :
elif [ -x /usr/bin/cargo ] && command -v wasm-ld >/dev/null 2>&1; then
  # Debian's compiler ships the sources of the standard library instead of a compiled one.
  export PATH=/usr/bin:$PATH RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld
  command=(/usr/bin/cargo build -Zbuild-std=std,panic_abort)
elif command -v rustup >/dev/null 2>&1; then
  rustup target add wasm32-unknown-unknown
else
  echo "error: no WebAssembly target; try 'rustup target add wasm32-unknown-unknown'" >&2
  exit 1
fi
# A folder of its own, or the two compilers undo each other's work.
options=(--target wasm32-unknown-unknown --target-dir target/wasm --profile wasm --locked)
export RUSTFLAGS="-C target-feature=+simd128"
packages=(-p common)
for manifest in chapters/*/Cargo.toml; do
  packages+=(-p "$(sed -n 's/^name = "\(.*\)"/\1/p' "$manifest" | head -n 1)")
done
"${command[@]}" "${options[@]}" --no-default-features --lib "${packages[@]}"
"${command[@]}" "${options[@]}" --lib -p course
node tests/wasm.mjs target/wasm/wasm32-unknown-unknown/wasm/course.wasm | diff - tests/bits.txt
echo "WebAssembly: same bits"
