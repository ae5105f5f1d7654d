#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and runs the libFuzzer targets.
#
#   fuzz.sh build FOLDER                           configures (once) and builds
#   fuzz.sh run FOLDER scene|slides SECONDS        from our own files, with the same random numbers on every run
#   fuzz.sh search FOLDER scene|slides SECONDS     goes on from FOLDER/corpus, which grows, with new random numbers
#
# An input that breaks something is kept in FOLDER/findings. Exit: 0 nothing found; 77 there is no libFuzzer.
set -euo pipefail
source=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../..")

# As ctest shows it: why the test was not run.
skip() {
  echo "skipped, $1; ./dev setup all installs it"
  exit 77
}

require_fuzzer() {
  command -v clang++ >/dev/null || skip "clang++ is not installed"
  [[ -f $(clang++ -print-file-name="libclang_rt.fuzzer-$(uname -m).a") ]] || skip "clang++ comes without libFuzzer"
}

build() {
  local folder=$1
  mkdir -p "$folder"
  exec {lock}>"$folder/.lock"  # several ctest runs may share it
  flock "$lock"
  [[ -f $folder/build.ninja ]] || (cd "$source" && cmake --preset fuzz -B "$folder")
  cmake --build "$folder" --target cagewright_scene_fuzz cagewright_slides_fuzz
}

# seeds TARGET TO: our own files, valid and broken.
seeds() {
  mkdir -p "$2"
  case $1 in
    scene) find "$source/testdata/scenes" -name '*.gl[bt]*' -size -65k -exec cp -t "$2" {} + ;;
    slides) find "$source/testdata/slides" -name '*.json' -exec cp -t "$2" {} + ;;
  esac
}

run() {
  local folder=$1 target=$2 seconds=$3 dictionary=slides fuzz_options=("${@:4}")
  [[ $target == slides ]] || dictionary=gltf
  local program=$folder/bin/cagewright_${target}_fuzz
  [[ -x $program ]] || { echo "$program is not there: fuzz.sh build makes it" >&2; exit 1; }
  corpus=$(mktemp -d)  # not local: the trap comes later
  trap 'rm -rf "$corpus"' EXIT
  seeds "$target" "$corpus/seeds"
  mkdir -p "$corpus/new" "$folder/findings"
  local folders=("$corpus/new" "$corpus/seeds")
  if [[ ${fuzz_options[0]:-} != -seed=* ]]; then
    mkdir -p "$folder/corpus/$target"
    folders=("$folder/corpus/$target" "$corpus/seeds")
  fi
  export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
  if ! timeout -k 5 $((seconds + 100)) "$program" -max_total_time="$seconds" -max_len=65536 -rss_limit_mb=2048 \
    -timeout=10 -print_final_stats=1 -verbosity=0 -dict="$source/host/tests/fuzz/$dictionary.dict" \
    -artifact_prefix="$folder/findings/$target-" ${fuzz_options[0]+"${fuzz_options[@]}"} "${folders[@]}" 2>&1 |
    sed -e '/# Uses: /d' -e '/ecommended dictionary/d'; then
    echo "fuzz.sh: $target has found something; $program with the file named above shows it again"
    exit 1
  fi
}

require_fuzzer
case ${1:-} in
  build) build "$2" ;;
  run) run "$2" "$3" "$4" -seed=1 ;;
  search) run "$2" "$3" "$4" ;;
  *)
    echo "fuzz.sh build|run|search FOLDER ..." >&2
    exit 2
    ;;
esac
