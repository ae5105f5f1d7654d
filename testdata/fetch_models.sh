#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# fetch_models.sh DIR: gets the real models that tests and benchmarks can use.
#
# They come out of two Debian packages, which are downloaded and unpacked but not installed. No root is needed as long
# as apt knows the packages. DIR then holds the .off models below, and the glTF 2.0 samples in DIR/assimp-gltf2.
# Does nothing where all is there. Exit: 0 all there; 1 failed; 2 wrong usage.
set -eu

models="armadillo bear bull bunny00 camel cow diplodocus double-torus-example elephant elk hand holes lion man
        mannequin-devil pig triceratops turbine"
models_package=libcgal-demo
models_archive=./usr/share/doc/libcgal-dev/data.tar.gz
gltf_package=assimp-testmodels
gltf_folder=./usr/share/assimp/models/glTF2

say() { echo "fetch_models: $*"; }
fail() { echo "fetch_models: $*" >&2; exit 1; }

if [ $# -ne 1 ] || [ -z "$1" ]; then
  echo "usage: fetch_models.sh DIR" >&2
  exit 2
fi
mkdir -p -- "$1" || fail "cannot make the folder $1"
dir=$(cd -- "$1" && pwd)

missing_models() {
  for model in $models; do
    [ -s "$dir/$model.off" ] || echo "$model"
  done
}

wanted=$(missing_models)
if [ -z "$wanted" ] && [ -d "$dir/assimp-gltf2" ]; then
  say "$dir is complete, nothing to do"
  exit 0
fi

for tool in apt-get dpkg-deb tar gzip; do
  command -v "$tool" >/dev/null || fail "$tool is not there; this script needs Debian or a system like it"
done
work=$(mktemp -d "$dir/.fetch.XXXXXX") || fail "cannot write into $dir"
trap 'rm -rf -- "$work"' EXIT
trap 'exit 1' HUP INT TERM

# Leaves the package as $work/$1.deb.
download() {
  say "downloading the package $1"
  mkdir "$work/$1"
  if ! (cd "$work/$1" && apt-get -q download "$1") >"$work/log" 2>&1; then
    [ "$(id -u)" -eq 0 ] || { cat "$work/log" >&2; fail "apt cannot download $1; run 'apt-get update' as root and try again"; }
    say "apt does not have $1 yet, updating its lists"
    apt-get -q update >"$work/log" 2>&1 || { cat "$work/log" >&2; fail "apt-get update failed"; }
    (cd "$work/$1" && apt-get -q download "$1") >"$work/log" 2>&1 || { cat "$work/log" >&2; fail "apt cannot download $1"; }
  fi
  mv "$work/$1"/*.deb "$work/$1.deb"
}

if [ -n "$wanted" ]; then
  download "$models_package"
  # Archives go through files, not pipes, so that a failure of either end is seen.
  dpkg-deb --fsys-tarfile "$work/$models_package.deb" >"$work/files.tar" || fail "$models_package is damaged"
  tar -xf "$work/files.tar" -C "$work" "$models_archive" || fail "$models_package holds no $models_archive"
  tar -xzf "$work/$models_archive" -C "$work" || fail "$models_archive is damaged"
  for model in $wanted; do
    found="$work/data/meshes/$model.off"
    [ -s "$found" ] || fail "$models_package holds no $model.off"
    mv -- "$found" "$dir/$model.off"
  done
  say "put $(echo "$wanted" | wc -l) of 18 models into $dir"
fi

if [ ! -d "$dir/assimp-gltf2" ]; then
  download "$gltf_package"
  dpkg-deb --fsys-tarfile "$work/$gltf_package.deb" >"$work/files.tar" || fail "$gltf_package is damaged"
  tar -xf "$work/files.tar" -C "$work" "$gltf_folder" || fail "$gltf_package holds no $gltf_folder"
  mv -- "$work/$gltf_folder" "$dir/assimp-gltf2"
  say "put the glTF 2.0 samples into $dir/assimp-gltf2"
fi
say "$dir is complete"
