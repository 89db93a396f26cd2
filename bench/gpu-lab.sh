#!/usr/bin/env bash
# What only a real GPU can answer, in one call with a budget of its own, without network and without a compiler:
#
#   bench/gpu-lab.sh --build NAME [--steps FOLDER]
#   bench/gpu-lab.sh [--steps FOLDER] [--quick] [--whole] [--seconds N] [--seed N] [--adapter NAME] [--out FOLDER] [SECTION...]
#
# --build NAME     builds this checkout's programs, stripped, into FOLDER/NAME: a step
# --steps FOLDER   the folder of steps (default bench/steps); all in it are run in turn
# --quick          small scenes: a minute or two on a software adapter
# --whole          anything not reached is exit code 1
# --seconds N      the budget (default 240); nothing is begun that would probably end later, and nothing runs longer
# --seed N         of scenes and of bounce rays (default 7)
# --adapter NAME   the GPU with this in its name (default the strongest, software if nothing else)
# --out FOLDER     where the record gpu-lab-ADAPTER.md is written (default bench/record; with --quick none)
# SECTION          parity, stress, rays, stages, builds, peers or large (default all)
#
# One table comes last. Exit codes: 0 done, 1 an answer is wrong, a program failed, or --whole and something was not reached,
# 2 usage or input.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
all=(parity rays stages builds peers large stress)
steps=$here/steps out='' build='' quick=() whole=0 seconds=240 seed=7 adapter=() sections=()

refuse() {
  echo "gpu-lab.sh: $1" >&2
  exit 2
}
number() { [[ $2 =~ ^[0-9]{1,9}$ ]] || refuse "$1 needs a whole number, not '$2'."; }

while [[ $# -gt 0 ]]; do
  case $1 in
    --help | -h)
      sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "$0"
      exit 0
      ;;
    --quick) quick=(--quick) ;;
    --whole) whole=1 ;;
    --build | --steps | --seconds | --seed | --adapter | --out)
      [[ $# -ge 2 ]] || refuse "$1 needs a value."
      case $1 in
        --build) build=$2 ;;
        --steps) steps=$2 ;;
        --seconds) number "$@" && seconds=$2 ;;
        --seed) number "$@" && seed=$2 ;;
        --adapter) adapter=(--adapter "$2") ;;
        --out) out=$2 ;;
      esac
      shift
      ;;
    -*) refuse "there is no option '$1'; --help lists them." ;;
    *)
      [[ " ${all[*]} " == *" $1 "* ]] || refuse "there is no section '$1'; there are ${all[*]}."
      sections+=("$1")
      ;;
  esac
  shift
done
[[ ${#sections[@]} -gt 0 ]] || sections=("${all[@]}")

commit() { git -C "$here" describe --always --dirty --abbrev=10 2>/dev/null || echo unknown; }

if [[ -n $build ]]; then
  [[ $build =~ ^[A-Za-z0-9._-]+$ ]] || refuse "a step's name has letters, digits, dots and dashes, not '$build'."
  cargo build --locked --release --manifest-path "$here/Cargo.toml" --bin gpu-lab
  cargo build --locked --release --manifest-path "$here/../Cargo.toml" -p slimbvh-lab
  mkdir -p "$steps/$build"
  strip -o "$steps/$build/gpu-lab" "${CARGO_TARGET_DIR:-$here/target}/release/gpu-lab"
  strip -o "$steps/$build/slimbvh-lab" "${CARGO_TARGET_DIR:-$here/../target}/release/slimbvh-lab"
  commit >"$steps/$build/commit"
  du -sh "$steps/$build"
  exit 0
fi

names=()
for program in "$steps"/*/gpu-lab; do
  [[ -x $program ]] && names+=("$(basename "$(dirname "$program")")")
done
[[ ${#names[@]} -gt 0 ]] || refuse "there is no step in '$steps'; --build NAME makes one."
if [[ -n $out && ! -d $out ]]; then
  refuse "there is no folder '$out'."
fi
[[ -n $out || ${#quick[@]} -gt 0 ]] || out=$here/record

found=$("$steps/${names[0]}/gpu-lab" adapter ${adapter[@]+"${adapter[@]}"}) || exit 2
adapter=(--adapter "$found")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wrong=0
missed=()

# Seconds that a section of one step probably takes on a GPU, and the most that it may.
cost() {
  case $1 in
    parity) echo 15 40 ;;
    rays) echo 10 30 ;;
    stages) echo 6 20 ;;
    builds) echo 6 20 ;;
    peers) echo 12 40 ;;
    large) echo 20 100 ;;
    stress) echo 15 40 ;;
  esac
}

left() { echo $((seconds - SECONDS)); }

# once SECTION STEP: runs it, keeps its rows, and notes what it did not reach.
once() {
  local section=$1 step=$2 likely most code=0 rows=$work/rows
  read -r likely most <<<"$(cost "$section")"
  [[ ${#quick[@]} -eq 0 ]] || likely=2
  if [[ $(left) -lt $likely ]]; then
    missed+=("$section of $step")
    return
  fi
  [[ $most -le $(left) ]] || most=$(left)
  echo "$section of $step, $(left) s left" >&2
  : >"$rows"
  if [[ $section == stress ]]; then
    stress "$step" "$most" >"$rows" || code=$?
  else
    timeout "$most" "$steps/$step/gpu-lab" "$section" ${quick[@]+"${quick[@]}"} --seed "$seed" --seconds "$((most - 1))" \
      "${adapter[@]}" >"$rows" || code=$?
  fi
  # A line that was cut off is no row.
  head -n "$(wc -l <"$rows")" "$rows" >>"$work/$step"
  case $code in
    0) ;;
    1) wrong=1 ;;
    124) missed+=("the rest of $section of $step: it ran for $most s") ;;
    *)
      wrong=1
      missed+=("the rest of $section of $step: it failed with exit code $code")
      ;;
  esac
}

# stress STEP SECONDS: scenes that are hard for tracers, judged by exact answers.
stress() {
  local program=$steps/$1/slimbvh-lab only=() code=0
  if [[ ! -x $program ]]; then
    echo 'missed;stress: the step has no slimbvh-lab'
    return
  fi
  [[ ${#quick[@]} -eq 0 ]] || only=(--only slivers)
  timeout "$2" "$program" stress --quick --backend gpu "${adapter[@]}" ${only[@]+"${only[@]}"} >"$work/stress.log" 2>&1 || code=$?
  case $code in
    1) sed -n '/^Faults/,$p' "$work/stress.log" >&2 ;;&
    0 | 1) echo "row;stress;${only[1]:-all families};exact answers;exit code;$code" ;;
    124) ;;
    *) tail -n 3 "$work/stress.log" >&2 ;;
  esac
  return "$code"
}

for name in "${names[@]}"; do : >"$work/$name"; done
reversed=()
for name in "${names[@]}"; do reversed=("$name" ${reversed[@]+"${reversed[@]}"}); done
for section in "${sections[@]}"; do
  for name in "${names[@]}"; do once "$section" "$name"; done
  # Times are measured twice in opposite order, so that a clock that drifts meets all steps alike.
  case $section in
    rays | stages | builds)
      if [[ ${#names[@]} -gt 1 ]]; then
        for name in "${reversed[@]}"; do once "$section" "$name"; done
      fi
      ;;
  esac
done

table=(table --fact "adapter=$found" --fact "budget=$seconds s, $SECONDS s used")
for name in "${names[@]}"; do
  table+=(--fact "step $name=$(cat "$steps/$name/commit" 2>/dev/null || echo unknown)" "$name=$work/$name")
done
if [[ ${#names[@]} -eq 1 ]]; then
  table+=(--fact "steps=only ${names[0]}, so nothing is compared")
fi
for text in ${missed[@]+"${missed[@]}"}; do table+=(--missed "$text"); done
[[ -z $out ]] || table+=(--out "$out")
"$steps/${names[0]}/gpu-lab" "${table[@]}"
if [[ $whole -eq 1 ]] && { [[ ${#missed[@]} -gt 0 ]] || grep -q '^missed;' "${names[@]/#/$work/}"; }; then
  echo 'gpu-lab.sh: not everything was reached, and --whole is given' >&2
  wrong=1
fi
exit "$wrong"
