#!/usr/bin/env bash
# Draws the pictures of the documents again, from numbers of the program: docs/pictures/draw.sh [PICTURE...]
# The program is ./run of this tree, or what LIBRATION names.
set -euo pipefail

here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
program=${LIBRATION:-$here/../../run}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

level() { # NAME OPTIONS... : one energy level, theta and omega
    "$program" trajectory "${@:2}" --scalar double --digits 8 --format csv --out "$work/$1.csv"
}

for energy in 0.1 0.5 1 1.5 1.9; do
    level "libration_$energy" --energy "$energy" --times 0:T:121
done
for direction in + -; do
    level "separatrix_$direction" --energy 2 --direction "$direction" --times=-6:6:121
    for energy in 2.1 2.5 3 4; do
        level "rotation_$energy$direction" --energy "$energy" --direction "$direction" --times 0:T:121
    done
done
level swing --energy 1.71 --times 0:T:201
"$program" reference --energy 1.71 --time 0 --digits 12 --format csv --out "$work/constants.csv"

if [[ " $* " == *' one_writer '* || $# == 0 ]]; then
    "$here/../../run" bench journal --model "$work/one_writer.csv" >&2
fi

pictures=("$@")
(($#)) || pictures=(phase_portrait words one_writer)
for picture in "${pictures[@]}"; do
    gnuplot -e "work = '$work'; scripts = '$here/../../studies'; target = '$here/$picture.svg'" "$here/$picture.gp"
done
