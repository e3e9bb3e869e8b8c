# Shared by the scripts of this folder: where things are, how we say what we do, and how tools are found or set up.
# Sourced, never run. Everything here is quick when there is nothing to do.

set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

tools=${XDG_CACHE_HOME:-$HOME/.cache}/robot-motion/tools
locks=$root/target/locks
logs=$root/target/logs
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

# What is built goes into the checkout, and a script that cannot write there would end with a word of mkdir's.
if ! { mkdir -p target && [ -w target ] && [ -x target ]; } 2>/dev/null; then
  fail "Nothing can be written into this checkout." \
    "The scripts put what they build into its folders target and dist: make it writable, or clone it to another place."
fi

have() { command -v "$1" >/dev/null 2>&1; }

# ── One at a time, and several at once ──

# alone FILE WHAT COMMAND…: runs COMMAND while no other script runs one under FILE, and says when it has to wait for
# WHAT. The system lets go of the lock when the command ends, however it ends.
alone() {
  local file=$1 what=$2
  shift 2
  mkdir -p "$(dirname "$file")"
  (
    if ! lock_descriptor now; then
      say "Waiting for $what to end"
      lock_descriptor
    fi
    "$@"
  ) 9>"$file"
}

# Locks descriptor 9: at once or not at all with `now`, else as soon as it is free. A Mac has no flock but has perl.
lock_descriptor() {
  if have flock; then
    flock ${1:+--nonblock} 9
  else
    perl -MFcntl=:flock -e 'open(my $file, ">&=", 9) && flock($file, LOCK_EX | (@ARGV ? LOCK_NB : 0)) or exit 1' "$@"
  fi
}

# beside NAME COMMAND…: starts COMMAND beside what follows, in a process group of its own so that Ctrl-C ends it too.
# await NAME: waits for it to end; where it failed, shows what it printed and stops.
beside_groups=
beside() {
  local name=$1
  shift
  mkdir -p "$logs"
  trap end_what_runs_beside EXIT
  set -m
  "$@" >"$logs/$name" 2>&1 </dev/null &
  set +m
  printf -v "beside_$name" '%s' "$!"
  beside_groups+=" $!"
}
await() {
  local process=beside_$1
  wait "${!process}" || {
    cat "$logs/$1" >&2
    fail "'$1' failed; its messages are above."
  }
}
end_what_runs_beside() {
  local group
  for group in $beside_groups; do kill -TERM -- "-$group" 2>/dev/null || true; done
}

# ── What has to be there ──

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
  [ "$major" -ge 20 ] || fail "Node.js $(node --version) is too old." \
    "Install Node.js 20 or newer from https://nodejs.org."
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

# need_tool PROGRAM CRATE VERSION [cargo install arguments]: PROGRAM of exactly VERSION on PATH: the one already there
# if it matches, else one built once into the user's cache.
need_tool() {
  local program=$1 home=$tools/$2-$3
  if have "$program" && "$program" --version 2>/dev/null | grep -qwF "$3"; then return; fi
  [ -x "$home/bin/$program" ] || alone "$tools/lock" "another script's set-up of tools" install_tool "$@" || exit 1
  PATH=$home/bin:$PATH
}

# The tools run for a second, so they are compiled quickly and not to be quick. What an interrupted set-up has compiled
# is used by the next one.
install_tool() {
  local program=$1 crate=$2 version=$3 home=$tools/$2-$3
  shift 3
  if [ -x "$home/bin/$program" ]; then return; fi
  say "Building $crate $version into $home (once, a minute or two)"
  # A failed or interrupted build leaves nothing that looks like a finished one: the folder gets its name at the end.
  rm -rf "$home".part*
  # No --locked: a lock file inside a crate can name a release that a registry mirror does not hold.
  CARGO_TARGET_DIR=$tools/build CARGO_PROFILE_RELEASE_OPT_LEVEL=0 CARGO_PROFILE_RELEASE_LTO=off \
    CARGO_PROFILE_RELEASE_CODEGEN_UNITS=64 CARGO_PROFILE_RELEASE_DEBUG=0 \
    cargo install "$crate" --version "$version" --root "$home.part" --force "$@" >&2 || {
    rm -rf "$home.part"
    fail "$crate $version could not be built." \
      "Read the messages above; or put $program $version on PATH by other means and run this again."
  }
  rm -rf "$home" "$tools/build"
  mv "$home.part" "$home"
}

# need_packages FOLDER: the npm packages of FOLDER/package-lock.json, installed again only when that file has changed.
need_packages() {
  need_node
  packages_stand "$1" ||
    alone "$locks/packages-${1//\//-}" "another script's set-up of the npm packages of $1/" \
    install_packages "$1" || exit 1
}
packages_lock() { printf '%s' "$(node -p process.versions.modules) $(cksum <"$1/package-lock.json")"; }
packages_stand() { [ "$(cat "$1/node_modules/.robot-motion-lock" 2>/dev/null)" = "$(packages_lock "$1")" ]; }
install_packages() {
  if packages_stand "$1"; then return; fi
  say "Installing the npm packages of $1/"
  (cd "$1" && npm ci --no-audit --no-fund --loglevel=error >&2) || fail "npm could not install the packages of $1/." \
    "Read npm's message above; the usual causes are no network or a registry that refuses."
  packages_lock "$1" >"$1/node_modules/.robot-motion-lock"
}

# The module is the same whoever builds it, wherever.
# - It names source files where it could trap: without the folder of this machine that they lie in. (They have to be
#   there to be found; .cargo/config.toml adds the rest of the flags.)
# - RUSTFLAGS would take the place of the flags of .cargo/config.toml, so the module is built without.
same_module_everywhere() {
  local flags="" folder
  if [ -n "${RUSTFLAGS:-}${CARGO_ENCODED_RUSTFLAGS:-}" ]; then
    say "RUSTFLAGS is set: native code is compiled with it, the wasm module without it (it has flags of its own)"
  fi
  cargo fetch --quiet --locked
  for folder in "${CARGO_HOME:-$HOME/.cargo}"/registry/src/*/; do
    case $folder in *[[:space:]]*) ;; *) flags+=" --remap-path-prefix=${folder%/}=crates" ;; esac
  done
  export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS=${flags# }
}
without_rustflags() { env -u RUSTFLAGS -u CARGO_ENCODED_RUSTFLAGS "$@"; }

# What the module's build asks for: Rust's target, wasm-bindgen of the version in Cargo.lock, and wasm-opt. The
# wasm-bindgen is built without TLS, which only its tests in a remote browser would use.
need_wasm_tools() {
  need_rust
  need_wasm_target
  need_tool wasm-bindgen wasm-bindgen-cli "$(locked_version wasm-bindgen)" --no-default-features \
    --bin wasm-bindgen --bin wasm-bindgen-test-runner
  need_packages web
  PATH=$root/web/node_modules/.bin:$PATH
  have wasm-opt || fail "wasm-opt is missing although web/'s packages are installed." \
    "Remove web/node_modules and run this again."
}

# What the tests in wasm ask for besides: wasm-pack finds wasm-bindgen on PATH and downloads nothing.
need_wasm_pack() { need_tool wasm-pack wasm-pack "$wasm_pack_version"; }

# A Chromium for the browser tests, in CHROMIUM: the one named there, the system's, or Debian's where we may install it.
# The one without a browser around its pages comes first: it needs two thirds of the time. A release is tried in a whole
# one.
need_chromium() {
  local name debian=(chromium-headless-shell chromium)
  if [ -n "${RELEASE:-}" ]; then debian=(chromium); fi
  if [ -n "${CHROMIUM:-}" ]; then
    have "$CHROMIUM" || fail "CHROMIUM names '$CHROMIUM', which is no program." "Correct it, or unset it."
    export CHROMIUM
    return
  fi
  for name in "${debian[@]}" chromium-browser google-chrome google-chrome-stable \
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome" \
    "/Applications/Chromium.app/Contents/MacOS/Chromium"; do
    if have "$name"; then
      CHROMIUM=$(command -v "$name")
      export CHROMIUM
      return
    fi
  done
  if have apt-get && [ "$(id -u)" = 0 ]; then
    say "Installing Debian's Chromium for the browser tests"
    apt-get update -qq >&2 || true
    for name in "${debian[@]}"; do
      DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "$name" >&2 || true
      if have "$name"; then
        CHROMIUM=$(command -v "$name")
        export CHROMIUM
        return
      fi
    done
  fi
  fail "No Chromium for the browser tests." \
    "Install one (Debian: apt-get install chromium; Fedora: dnf install chromium;" \
    "  macOS: brew install --cask chromium)" \
    "or name one: CHROMIUM=/path/to/chrome ./scripts/test"
}
