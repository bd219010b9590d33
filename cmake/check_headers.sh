#!/usr/bin/env bash
# Every public header compiles alone, included twice, and all of them compile together.
# Usage: check_headers.sh INCLUDE_DIR EXTERNAL_DIR[:...] COMPILER FLAG...
# Headers are looked up now, so a new one is tested without configuring again. Two compilers at a time.
set -euo pipefail

include=$1 external=$2
shift 2
compile=("$@" -fsyntax-only -I "$include")
IFS=: read -ra folders <<<"$external"
for folder in "${folders[@]}"; do
    # -isystem /usr/include would reorder the compiler's own folders and break <cstdlib>.
    [[ $folder == /usr/include ]] || compile+=(-isystem "$folder")
done

check() { # HEADER COMPILER FLAG...
    local header=$1 said
    shift
    said=$(printf '#include <%s>\n#include <%s>\n' "$header" "$header" | "$@" -x c++ - 2>&1) && return
    printf '%s does not compile alone:\n%s\n\n' "$header" "$said"
    return 1
}
export -f check

cd "$include"
mapfile -t headers < <(find libration -name '*.hpp' | sort)
((${#headers[@]})) || { echo "no headers in $include/libration" && exit 1; }
printf '%s\0' "${headers[@]}" | xargs -0 -P 2 -I HEADER bash -c 'check "$@"' check HEADER "${compile[@]}" ||
    { echo "some of ${#headers[@]} headers do not compile alone" && exit 1; }
# Together: no two of them define one name. The first has to come before all others, and says so.
printf '#include <%s>\n' libration/scalar/counted.hpp "${headers[@]}" | "${compile[@]}" -x c++ - ||
    { echo "the headers do not compile together" && exit 1; }
echo "${#headers[@]} headers compile alone and together"
