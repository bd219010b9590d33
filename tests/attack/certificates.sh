#!/usr/bin/env bash
# tests/attack/certificates.sh BUILD COUNT SEED: COUNT certificates that are forged from those of problems with closed forms, and
# judged by both checkers (tests/certificates/forge.py). BUILD is the directory of a release build.
set -euo pipefail

tests=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
build=$(cd "$1" && pwd)
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder" # where a forgery that is accepted would be left
python3 "$tests/certificates/forge.py" --count "$2" --seed "$3" "$build/libration" "$build/libration-check" ||
    { cp forgery.cert "$build/" 2>/dev/null && echo "the certificate is $build/forgery.cert" >&2; exit 1; }
