#!/usr/bin/env bash
# Draws random models with the program of the pinned commit and writes them with that program's answers.
#
#   verification/pinned/run.sh FOLDER                    the frozen set: the first 200 of every family, and the named ones
#   verification/pinned/run.sh FOLDER FAMILY             the frozen set of one family
#   verification/pinned/run.sh FOLDER FAMILY FROM TO     the models FROM to TO - 1 of a family
#
# FOLDER gets models/, answers/ and certificates/, each with one file for each family. The sources and the build of the
# pinned commit stay in target/pinned, for the next run. The families draw with `powf` and other functions of the system's
# library, so another machine may draw models that differ in their last digits.
set -euo pipefail
commit=28b107eeeb5684cdcbea8310db9e74e5ad57a01d
[ $# = 1 ] || [ $# = 2 ] || [ $# = 4 ] || { sed -n '2,10s/^# \{0,1\}//p' "$0" >&2; exit 2; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
here=$(cd "$(dirname "$0")" && pwd)
root=$(git -C "$here" rev-parse --show-toplevel)
sources=$root/target/pinned/$commit
if [ ! -d "$sources" ]; then
    mkdir -p "$sources.part"
    git -C "$root" archive "$commit" | tar -x -C "$sources.part"
    mv "$sources.part" "$sources"
fi
mkdir -p "$sources/verification/examples/pinned"
cp "$here"/*.rs "$sources/verification/examples/pinned/"
cd "$sources"
exec cargo run --release --locked --quiet -p groundbeam-verification --example pinned -- "$folder" "$@"
