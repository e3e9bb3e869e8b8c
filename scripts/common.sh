# Shared by the scripts of this folder: where things are, how we say what we do, and how tools are found or set up.
# Sourced, never run. Everything here is quick when there is nothing to do.

set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

tools=${XDG_CACHE_HOME:-$HOME/.cache}/robot-motion/tools
cargo_target=${CARGO_TARGET_DIR:-$root/target}
wasm_pack_version=0.15.1
cargo_mutants_version=27.1.0

# What is being done, on standard error so that a script's own output stays clean.
say() { printf '› %s\n' "$*" >&2; }

# Says what went wrong and what to do about it, then stops.
fail() {
  printf '\n✗ %s\n' "$1" >&2
  shift
  for line in "$@"; do printf '  %s\n' "$line" >&2; done
  exit 1
}

have() { command -v "$1" >/dev/null 2>&1; }

# The version of a package in Cargo.lock.
locked_version() {
  awk -v want="name = \"$1\"" '$0 == want { getline; gsub(/version = |"/, ""); print; exit }' Cargo.lock
}

need_rust() {
  have cargo || fail "cargo is not on PATH." \
    "Install Rust from https://rustup.rs, then run this again."
  have cc || have clang || have link.exe || fail "No C linker (cc) was found; Rust needs one to link." \
    "Debian or Ubuntu: apt-get install gcc libc6-dev; macOS: xcode-select --install; Fedora: dnf install gcc."
}

need_node() {
  have node || fail "node is not on PATH." "Install Node.js 20 or newer from https://nodejs.org, then run this again."
  local major
  major=$(node -p 'process.versions.node.split(".")[0]')
  [ "$major" -ge 20 ] || fail "Node.js $(node --version) is too old." "Install Node.js 20 or newer from https://nodejs.org."
  have npm || fail "npm is not on PATH." "It comes with Node.js; on Debian: apt-get install npm."
}

need_wasm_target() {
  [ -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown" ] && return
  have rustup || fail "This Rust has no wasm32-unknown-unknown target, and rustup is not on PATH to add it." \
    "Install Rust from https://rustup.rs, or your system's package for that target."
  say "Adding Rust's wasm target"
  rustup target add wasm32-unknown-unknown || fail "rustup could not add the wasm target." \
    "Run 'rustup target add wasm32-unknown-unknown' where the network is to be had."
}

# need_tool PROGRAM CRATE VERSION [cargo install arguments]: PROGRAM of exactly VERSION on PATH: the one already there if
# it matches, else one built once into the user's cache.
need_tool() {
  local program=$1 crate=$2 version=$3 home=$tools/$2-$3
  shift 3
  if have "$program" && "$program" --version 2>/dev/null | grep -qwF "$version"; then return; fi
  if [ ! -x "$home/bin/$program" ]; then
    say "Building $crate $version into $home (once, a few minutes)"
    # A failed or interrupted build leaves nothing that looks like a finished one: the folder gets its name at the end.
    local half=$home.part-$$
    # No --locked: a lock file inside a crate can name a release that a registry mirror does not hold.
    cargo install "$crate" --version "$version" --root "$half" --force "$@" >&2 || {
      rm -rf "$half"
      fail "$crate $version could not be built." \
        "Read the messages above; or put $program $version on PATH by other means and run this again."
    }
    rm -rf "$home"
    mv "$half" "$home"
  fi
  PATH=$home/bin:$PATH
}

# need_packages FOLDER: the npm packages of FOLDER/package-lock.json, installed again only when that file has changed.
need_packages() {
  local folder=$1 stamp=$1/node_modules/.robot-motion-lock lock
  need_node
  lock="$(node -p process.versions.modules) $(cksum <"$folder/package-lock.json")"
  if [ ! -f "$stamp" ] || [ "$(cat "$stamp")" != "$lock" ]; then
    say "Installing the npm packages of $folder/"
    (cd "$folder" && npm ci --no-audit --no-fund --loglevel=error >&2) || fail "npm could not install the packages of $folder/." \
      "Read npm's message above; the usual causes are no network or a registry that refuses."
    printf '%s' "$lock" >"$stamp"
  fi
}

# The module names source files where it could trap: without the folder of this machine that they lie in, so that every
# machine builds the same one. (They have to be there to be found; .cargo/config.toml adds the rest of the flags.)
same_paths_everywhere() {
  local flags="" folder
  cargo fetch --quiet
  for folder in "${CARGO_HOME:-$HOME/.cargo}"/registry/src/*/; do
    case $folder in *[[:space:]]*) ;; *) flags+=" --remap-path-prefix=${folder%/}=crates" ;; esac
  done
  export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS=${flags# }
}

# Everything the module's build asks for: wasm-pack finds wasm-bindgen and wasm-opt on PATH and downloads nothing.
need_wasm_tools() {
  need_rust
  need_wasm_target
  same_paths_everywhere
  need_tool wasm-bindgen wasm-bindgen-cli "$(locked_version wasm-bindgen)"
  need_tool wasm-pack wasm-pack "$wasm_pack_version"
  need_packages web
  PATH=$root/web/node_modules/.bin:$PATH
  have wasm-opt || fail "wasm-opt is missing although web/'s packages are installed." \
    "Remove web/node_modules and run this again."
}

# A Chromium for the browser tests, in CHROMIUM: the one named there, the system's, or Debian's where we may install it.
need_chromium() {
  local name
  if [ -n "${CHROMIUM:-}" ]; then
    have "$CHROMIUM" || fail "CHROMIUM names '$CHROMIUM', which is no program." "Correct it, or unset it."
    export CHROMIUM
    return
  fi
  for name in chromium chromium-browser google-chrome google-chrome-stable \
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome" "/Applications/Chromium.app/Contents/MacOS/Chromium"; do
    if have "$name"; then
      CHROMIUM=$(command -v "$name")
      export CHROMIUM
      return
    fi
  done
  if have apt-get && [ "$(id -u)" = 0 ]; then
    say "Installing Debian's chromium for the browser tests"
    (apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq chromium) >&2 || true
    if have chromium; then
      CHROMIUM=$(command -v chromium)
      export CHROMIUM
      return
    fi
  fi
  fail "No Chromium for the browser tests." \
    "Install one (Debian: apt-get install chromium; Fedora: dnf install chromium; macOS: brew install --cask chromium)" \
    "or name one: CHROMIUM=/path/to/chrome ./scripts/test"
}
