#!/usr/bin/env bash
# tests/fuzz/fuzz.sh BUILD [SECONDS]: fuzzes the readers of numbers, CSV, lists of coefficients and command lines by
# clang's libFuzzer with the address and undefined-behaviour sanitizers, SECONDS each (150: ten minutes in all). BUILD
# is the directory of a release build; objects and findings stay in BUILD/fuzz. Exits with status 1 if one fails; the
# failing input is in BUILD/fuzz/NAME.found-*.
set -euo pipefail

here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$1
folder=$build/fuzz
seconds=${2-150}
mkdir -p "$folder"
rm -f "$folder"/*.o  # header dependencies are not tracked

flags=(-std=c++20 -O1 -g -w -fno-sanitize-recover=all -I"$root/include" -I"$root/src" -I"$root/src/command")
sanitizers=address,undefined
# Code that a target does not recompile is not instrumented, but linked from these; recompiled code comes first.
archives=(-Wl,--allow-multiple-definition "$build"/liblibration-{sweep,proved}.a "$build/liblibration.a")
# The options list the names of all studies.
mapfile -t studies < <(find "$build"/CMakeFiles/libration-{studies,claims}.dir -name '*.o')
libraries=(-lfmt -lsqlite3 -lcrypto -lz -lhwy -lflint-arb -lflint -lmpfr -lgmp -lpthread $(g++ -print-file-name=libquadmath.so))

# The sources of a target in addition to its main file, as patterns.
sources_of() {
    case $1 in
        number) printf '%s\n' "$root"/src/libration/scalar/*.cpp "$root"/src/libration/scalar/*/*.cpp \
            "$root"/src/libration/digits/*.cpp ;;
        csv) printf '%s\n' "$root"/src/command/text/csv_records.cpp ;;
        coefficient_list) printf '%s\n' "$root"/src/libration/scalar/*.cpp "$root"/src/libration/scalar/*/*.cpp \
            "$root"/src/libration/digits/*.cpp ;;
        command_line) printf '%s\n' "$root"/src/libration/scalar/*.cpp "$root"/src/libration/scalar/*/*.cpp \
            "$root"/src/command/option/*.cpp "$root"/src/command/text/*.cpp "$root"/src/command/problem/motion_options.cpp "$root"/src/command/verb/period.cpp ;;
    esac
}

compile() { # TARGET
    local source object objects=() jobs
    jobs=$(nproc)
    while read -r source; do
        object=$folder/$(tr / _ <<<"${source#"$root"/}").o
        objects+=("$object")
        [[ $object -nt $source ]] && continue
        while (($(jobs -rp | wc -l) >= jobs)); do wait -n; done
        clang++ "${flags[@]}" -fsanitize=fuzzer-no-link,$sanitizers -c "$source" -o "$object" &
    done < <(sources_of "$1")
    wait
    clang++ "${flags[@]}" -fsanitize=fuzzer,$sanitizers "$here/$1_fuzz.cpp" "${objects[@]}" "${studies[@]}" "${archives[@]}" "${libraries[@]}" \
        -o "$folder/$1_fuzz"
}

status=0
for target in ${FUZZ_TARGETS-number csv coefficient_list command_line}; do
    compile "$target"
    mkdir -p "$folder/$target.corpus"
    if "$folder/${target}_fuzz" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -max_len=4096 \
        -print_final_stats=1 -artifact_prefix="$folder/$target.found-" -close_fd_mask=1 \
        "$folder/$target.corpus" "$here/$target" >"$folder/$target.log" 2>&1; then
        printf 'fuzz: %s: %s inputs, no failures\n' "$target" \
            "$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/$target.log")"
    else
        printf 'fuzz: %s fails: see %s\n' "$target" "$folder/$target.log" >&2
        status=1
    fi
done
exit "$status"
