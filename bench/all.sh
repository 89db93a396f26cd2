#!/usr/bin/env bash
# Everything that is measured beside peers, into a folder:
#
#   bench/all.sh FOLDER [--quick] [arguments of `record`...]
#
# peers.json, peers.txt    peers on the scenes of `slimbvh-lab stress`
# stress.json, stress.txt  slimbvh on them, with the peers' rows beside
# record.md                times, side by side
# page/                    `slimbvh-lab bench`
#
# Peers that need more than Cargo are taken where they are installed. SLIMBVH_SCENES names the folder of real meshes.
# --quick: smaller scenes for stress and bench. Exit codes: 0 done, 1 an answer of slimbvh's is wrong, 2 usage or input.
set -eu

if [ $# -lt 1 ] || [ "${1#-}" != "$1" ]; then
  echo 'usage: bench/all.sh FOLDER [--quick] [arguments of record...]' >&2
  exit 2
fi
mkdir -p "$1" || exit 2
out=$(cd "$1" && pwd)
shift
quick=()
if [ "${1:-}" = --quick ]; then
  quick=(--quick)
  shift
fi
if [ -n "${SLIMBVH_SCENES:-}" ]; then
  SLIMBVH_SCENES=$(cd "$SLIMBVH_SCENES" && pwd)
  export SLIMBVH_SCENES
fi
cd "$(dirname "$0")"
export RUSTFLAGS="${RUSTFLAGS--C target-cpu=native}"

# What is installed.
features=()
if command -v c++ >/dev/null; then
  features+=(tinybvh)
fi
if echo 'int main(void) { return 0; }' | cc -x c - -o /dev/null -lembree3 2>/dev/null; then
  features+=(embree)
fi
flags=()
if [ ${#features[@]} -gt 0 ]; then
  flags=(--features "$(IFS=,; echo "${features[*]}")")
fi
echo "features: ${features[*]:-none}" >&2

# Builds first: nothing is measured while the compiler works.
cargo build --locked --release --bin peers --bin record ${flags[@]+"${flags[@]}"}
cargo build --locked --release --manifest-path ../Cargo.toml -p slimbvh-lab

wrong=0
# Notes that wrong answers were found, and goes on; any other failure ends it.
checked() {
  local code=0
  "$@" || code=$?
  case $code in
    0) ;;
    1) wrong=1 ;;
    *) exit "$code" ;;
  esac
}
bench=(cargo run --locked --release --quiet ${flags[@]+"${flags[@]}"} --bin)
lab=(cargo run --locked --release --quiet --manifest-path ../Cargo.toml -p slimbvh-lab --)

checked "${bench[@]}" record -- --out "$out/record.md" "$@" >/dev/null
"${bench[@]}" peers -- ${quick[@]+"${quick[@]}"} --json "$out/peers.json" >"$out/peers.txt"
checked "${lab[@]}" stress ${quick[@]+"${quick[@]}"} --with "$out/peers.json" --json "$out/stress.json" >"$out/stress.txt"
"${lab[@]}" bench ${quick[@]+"${quick[@]}"} --out "$out/page" >"$out/bench.txt"
exit $wrong
