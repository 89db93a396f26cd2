#!/usr/bin/env bash
# Plants one bug after the other in a copy of the tree and runs the tests that must find it: fails where one does not.
# Takes a few minutes a bug; names of bugs as arguments choose some. The list at the end gives each bug's name, its place, the sound
# code and the spoilt one, and which tests of which package must fail.
set -euo pipefail
cd "$(dirname "$0")/.."

copy=${PLANTED_DIR:-$PWD/target/planted}
mkdir -p "$copy"
export CARGO_TARGET_DIR=${PLANTED_TARGET_DIR:-$copy/target} RUST_BACKTRACE=0
missed=()

# plant NAME FILE SOUND SPOILT PACKAGE TEST
plant() {
  local name=$1 file=$2 sound=$3 spoilt=$4 package=$5 test=$6
  if [[ -n ${chosen:-} && " $chosen " != *" $name "* ]]; then return; fi
  git ls-files -z --cached --others --exclude-standard |
    tar c --null -T - | tar x -C "$copy"
  SOUND=$sound SPOILT=$spoilt perl -0pi -e '
    my $place = index($_, $ENV{SOUND});
    die "the sound code is not there any more\n" if $place < 0;
    substr($_, $place, length $ENV{SOUND}) = $ENV{SPOILT};
  ' "$copy/$file"
  # What the tests are built from is there already, as a rule; what is spoilt need not be fast.
  local profile=()
  if [[ $package != slimbvh-core ]]; then
    profile=(--release)
    for crate in slimbvh slimbvh-tests; do
      profile+=(--config "profile.release.package.$crate.opt-level=1")
      profile+=(--config "profile.release.package.$crate.codegen-units=16")
    done
  fi
  local output
  if output=$(cd "$copy" && cargo test -q "${profile[@]}" -p "$package" "$test" 2>&1); then
    echo "MISSED  $name: $test passes"
    missed+=("$name")
  elif grep -q '^error' <<<"$(grep -v 'test failed' <<<"$output")"; then
    printf '%s\n' "$output" | tail -n 20
    echo "BROKEN  $name does not compile"
    missed+=("$name")
  else
    echo "caught  $name: $(grep -E '^    [a-z0-9_:]+$' <<<"$output" | sort -u | tr -s ' \n' ' ')"
  fi
}

chosen="$*"

plant union-of-boxes core/src/build/refit.rs \
  'max: self.max.max(other.max),' 'max: self.max.min(other.max),' \
  slimbvh-tests trees::
plant odd-end-of-a-range core/src/build/refit.rs \
  'if low & 1 == 1' 'if low & 1 == 0' \
  slimbvh-tests trees::
plant odd-end-of-a-level core/src/build/refit.rs \
  'if left + 1 < below.count' 'if left < below.count' \
  slimbvh-core refit::
plant denormals-are-ordinary core/src/geometry/ray.rs \
  '(smallest >= key(f32::MIN_POSITIVE.to_bits()))' '(smallest >= key(1))' \
  slimbvh-core ray::
plant high-counters-begin-at-zero core/src/build/sort/tile.rs \
  'before.wrapping_add(all << 16)' 'before' \
  slimbvh-core sort::
plant blocks-beyond-the-own core/src/build/scan.rs \
  'while i < end {' 'while i <= end {' \
  slimbvh-core scan::
plant nearer-child-first-for-any core/src/trace/query.rs \
  '(boxes.enter_a <= boxes.enter_b) ^ self.goes_farther_first' 'boxes.enter_a <= boxes.enter_b' \
  slimbvh-tests any_hit_order::
plant number-rounded-to-nearest core/src/codec/lattice_node.rs \
  '(inner as u32 >> shift) & ((1 << BITS) - 1)' '((inner as u32 + ((1 << shift) >> 1)) >> shift) & ((1 << BITS) - 1)' \
  slimbvh-core lattice_node::
plant plane-rounded-to-nearest core/src/geometry/lattice.rs \
  'let steps = x * power_of_two(-step_exponent);
    let [a, b, c, d] = [' 'let steps = x * power_of_two(-step_exponent) + 0.5;
    let [a, b, c, d] = [' \
  slimbvh-core rounded::
plant no-tie-break core/src/trace/collect.rs \
  'a.t < b.t || (a.t == b.t && a.primitive < b.primitive)' 'a.t < b.t || (a.t == b.t && !b.is_hit())' \
  slimbvh-tests answers::
plant no-sign-guard core/src/geometry/orientation.rs \
  'self.volume * side > self.error' 'self.volume * side > 0.0' \
  slimbvh-core orientation::
plant fused-edge core/src/geometry/watertight.rs \
  'let Meeting { t, u, v, met } = meet(&ray.lanes(), &corners, limit);' 'let passage = pass(ray.origin, ray.direction, corners);
    let [sa, sb, sc] = passage.corners;
    let [[_, f0], [_, f1], [_, f2]] = passage.products;
    let fused = |x: f32, y: f32, z: f32| f64::from(x) * f64::from(y) - f64::from(z);
    let d = [fused(sc.x, sb.y, f0), fused(sa.x, sc.y, f1), fused(sb.x, sa.y, f2)];
    let inside = d.iter().all(|d| *d >= 0.0) | d.iter().all(|d| *d <= 0.0);
    let Meeting { t, u, v, met } = meet(&ray.lanes(), &corners, limit);
    let met = met & inside;' \
  slimbvh-tests watertight::
plant fused-orientation core/src/geometry/orientation.rs \
  'let normal = Vec3::new(yz - zy, zx - xz, xy - yx);' 'let fused = |x: f32, y: f32, z: f32| (f64::from(x) * f64::from(y) - f64::from(z)) as f32;
        let normal = Vec3::new(fused(a.y, b.z, zy), fused(a.z, b.x, xz), fused(a.x, b.y, yx));' \
  slimbvh-core orientation::
plant paper10-number-inside core/src/codec/paper10.rs \
  'below + 1
    } else {' 'below
    } else {' \
  slimbvh-core paper10::
plant strangers-in-a-packet core/src/trace/packet.rs \
  'let who = self.who & W::bits(meets);' 'let who = W::bits(meets);' \
  slimbvh-tests packets::
plant scaled-below-the-range core/src/trace/prepare.rs \
  '& is_zero_or_large(far_end)' '' \
  slimbvh-core prepare::
plant axes-of-others core/src/trace/prepare.rs \
  'let alike = ordinary & alike;' 'let _ = alike; let alike = ordinary;' \
  slimbvh-core prepare::
# What fuzzing found is in the seeds.
plant cells-that-underflow core/src/codec/paper10.rs \
  'if decode(number, low, high, opaque_zero) < x {' 'if false {' \
  slimbvh-tests fuzz_seeds::

if ((${#missed[@]})); then
  echo "not caught: ${missed[*]}"
  exit 1
fi
