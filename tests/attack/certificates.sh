#!/usr/bin/env bash
# tests/attack/certificates.sh BUILD COUNT SEED: certificates of values, zeros and a root, which tests/certificates/attack.py
# makes false on purpose and changes at random COUNT times each. BUILD is the directory of a release build.
set -euo pipefail

tests=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
program=$1/libration
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

"$program" reference --problem pendulum --time 1 --digits 5 --certificate "$folder/pendulum.cert" >/dev/null 2>&1
"$program" reference --problem "x' = -x; y' = 1000*x^2 - 1000*y; x(0) = 1; y(0) = 2" --time 1 --digits 6 \
    --certificate "$folder/stiff.cert" >/dev/null
"$program" reference --problem "x'' = -x; x(0) = 0; x'(0) = 1" --until "x = 0" --count 2 --digits 6 \
    --certificate "$folder/zeros.cert" >/dev/null
"$program" find --problem "x'' = -sin(x); x(0) = 1; x'(0) = 0" --unknown "x'(0)" --such-that "x(2) = 0" --digits 8 \
    --certificate "$folder/root.cert" >/dev/null
python3 "$tests/certificates/attack.py" --mutations "$2" --seed "$3" "$folder"/{pendulum,stiff,zeros,root}.cert
