#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# fetch_packages.sh DIR: installs the npm packages of package.json into DIR/node_modules.
#
# Takes whatever registry npm is set up for, and runs no package's own scripts. Does nothing where all is there.
# Exit: 0 all there; 1 failed; 2 wrong usage; 77 there is no node or npm.
set -eu

say() { echo "fetch_packages: $*"; }
fail() { echo "fetch_packages: $*" >&2; exit 1; }

if [ $# -ne 1 ] || [ -z "$1" ]; then
  echo "usage: fetch_packages.sh DIR" >&2
  exit 2
fi
here=$(cd -- "$(dirname -- "$0")" && pwd)
mkdir -p -- "$1" || fail "cannot make the folder $1"
dir=$(cd -- "$1" && pwd)
# Written last, so whoever finds it as it should be finds all packages too.
mark=$dir/node_modules/.fetched

if cat "$here/package.json" "$here/package-lock.json" | cmp -s - "$mark"; then
  say "$dir/node_modules is complete, nothing to do"
  exit 0
fi
for tool in node npm; do
  if ! command -v "$tool" >/dev/null; then
    say "skipped, $tool is not installed (Debian's packages nodejs and npm have it)"
    exit 77
  fi
done

say "installing npm packages into $dir/node_modules"
cp -- "$here/package.json" "$here/package-lock.json" "$dir/" || fail "cannot write into $dir"
if ! npm ci --prefix "$dir" --ignore-scripts --no-audit --no-fund --loglevel=error >"$dir/npm.log" 2>&1; then
  cat "$dir/npm.log" >&2
  fail "npm could not install the packages of $here/package.json"
fi
cat "$here/package.json" "$here/package-lock.json" >"$mark.new"
mv -- "$mark.new" "$mark"
say "$dir/node_modules is complete"
