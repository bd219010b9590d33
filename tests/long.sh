#!/usr/bin/env bash
# tests/long.sh BUILD: the tests that `./run test --long` runs after the others. Every part runs, even if others fail;
# the exit status is 1 if one failed. BUILD is the directory of a release build with libration-attack in it.
set -uo pipefail

tests=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
build=$1
status=0
# Debian's interpreter first, because the package python3-mpmath belongs to it.
python=python3
[[ -x /usr/bin/python3 ]] && python=/usr/bin/python3

part() { # NAME COMMAND...
    printf '\n== %s\n' "$1"
    "${@:2}" || { printf '== %s: FAILED\n' "$1" >&2 && status=1; }
}

by_integers() { "$build/libration-attack" print 10000 | "$python" "$tests/attack/by_integers.py"; }

both_checkers() { # FOLDER
    local second=("$python" "$tests/certificates/second.py") certificates=("$1"/{pendulum,stiff,zeros,root}.cert)
    gcc -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all "$tests"/../check/c/*.c -lgmp -lz \
        -o "$1/sanitized" &&
        "${second[@]}" --mutations 200 --seed 2 "$1/sanitized" "${certificates[@]}" "$1/orbit.cert" &&
        "${second[@]}" --mutations 2500 --attacks --conditions gcc "$build/libration-check" "${certificates[@]}"
}

certificates() {
    local folder status
    folder=$(mktemp -d) || return
    "$build/libration" reference --problem pendulum --time 1 --digits 5 --certificate "$folder/pendulum.cert" &&
        "$build/libration" reference --problem "x' = -x; y' = 1000*x^2 - 1000*y; x(0) = 1; y(0) = 2" --time 1 \
            --digits 6 --certificate "$folder/stiff.cert" &&
        "$build/libration" reference --problem "x'' = -x; x(0) = 0; x'(0) = 1" --until "x = 0" --count 2 --digits 6 \
            --certificate "$folder/zeros.cert" &&
        "$build/libration" find --problem "x'' = -sin(x); x(0) = 1; x'(0) = 0" --unknown "x'(0)" \
            --such-that "x(2) = 0" --digits 8 --certificate "$folder/root.cert" &&
        "$build/libration" find --problem van_der_pol --periodic --digits 8 --certificate "$folder/orbit.cert" &&
        "$python" "$tests/certificates/attack.py" --mutations 5000 "$folder"/{pendulum,stiff,zeros,root}.cert &&
        "$python" "$tests/certificates/attack.py" --mutations 1000 "$folder"/{orbit,stiff}.cert &&
        "$python" "$tests/certificates/forge.py" --count 5000 --seed 2 "$build/libration" "$build/libration-check"
    status=$?
    ((status != 0)) || both_checkers "$folder" || status=1
    rm -r "$folder"
    return "$status"
}

part 'studies that are killed' "$tests/sweep/kill" "$build" 300
part 'planted faults' "$python" "$tests/faults/plant.py" "$build" --jobs "$(nproc)"
part 'conditions that no test decides both ways' "$python" "$tests/coverage/coverage.py" "$build" --jobs "$(nproc)"
part 'a million random values' "$build/libration-attack" motions 1000000
part 'two hundred thousand statements' "$build/libration-attack" statements 200000 2
part 'ten thousand random values by integers' by_integers
part 'certificates that are false' certificates
part 'fuzzing of the readers' "$tests/fuzz/fuzz.sh" "$build"
part 'the slower tests' "$build/libration-tests" '[.long]'
exit "$status"
