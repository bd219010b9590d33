#!/usr/bin/env bash
# Builds the archives of FLINT, Arb, fmt and Highway, which Debian distributes only as shared libraries, for
# `./run static`: from Debian's sources and patches, in the versions of the installed headers.
#
#   static_libraries.sh DIRECTORY    writes DIRECTORY/lib*.a; archives that exist are kept
set -euo pipefail

directory=$(realpath -m "$1")
work=$directory/sources
mkdir -p "$work/lists/partial" "$work/cache" "$work/parts"

# apt-get for the source packages of the system's own repositories, without root and without a change of its lists.
apt() {
    apt-get -qq -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/parts" -o Dir::State::Lists="$work/lists" \
        -o Dir::Cache="$work/cache" -o APT::Sandbox::User="$(id -un)" "$@"
}

list_sources() {
    local file name
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources}; do
        [[ -f $file ]] && grep -q '/debian' "$file" || continue
        name=$(basename "$file")
        [[ $name != sources.list ]] || name=system.list
        sed -E 's/^Types:.*/Types: deb-src/; s/^deb /deb-src /' "$file" >"$work/parts/$name"
    done
    apt update
}

# The patched source of an installed package, in $work/SOURCE.
unpack() { # INSTALLED SOURCE
    local version
    version=$(dpkg-query -W -f '${source:Version}' "$1")
    rm -rf "${work:?}/$2"
    (cd "$work" && apt source --download-only "$2=$version" && dpkg-source -x "$2_${version#*:}.dsc" "$2")
}

# FLINT 2.9 and Arb 2.23 have the same build system. Without -march the code runs on every processor of the architecture.
make_archive() { # INSTALLED SOURCE NAME ARCHIVE CONFIGURE-ARG...
    [[ ! -f $directory/$4 ]] || return 0
    local modules
    unpack "$1" "$2"
    (
        cd "$work/$2"
        ./configure --disable-shared --with-gmp=/usr --with-mpfr=/usr CFLAGS='-O2 -fPIC' "${@:5}"
        [[ $2 != flint ]] || make build/CPimport.h # a source that the target `static` needs without naming it
        # Half of FLINT is about finite fields and polynomials in many variables, which Arb and Libration do not use.
        modules=$(make -s --eval 'list-modules: ; @printf "%s\n" $(BUILD_DIRS)' list-modules |
            grep -vE '^(fq|qadic)|mpoly' | tr '\n' ' ')
        make -j "$(nproc)" static BUILD_DIRS="$modules"
    )
    mv "$work/$2/$3" "$directory/$4"
}

# The few sources of a C++ library.
compile_archive() { # INSTALLED SOURCE ARCHIVE INCLUDE-DIRECTORY FILE...
    [[ ! -f $directory/$3 ]] || return 0
    local file objects=()
    unpack "$1" "$2"
    for file in "${@:5}"; do
        objects+=("$work/$2/$(basename "$file" .cc).o")
        c++ -std=c++17 -O2 -fPIC -I "$work/$2/$4" -c "$work/$2/$file" -o "${objects[-1]}"
    done
    ar rcs "$work/$3" "${objects[@]}"
    mv "$work/$3" "$directory/$3"
}

list_sources
compile_archive libfmt-dev fmtlib libfmt.a include src/format.cc
compile_archive libhwy-dev highway libhwy.a . hwy/aligned_allocator.cc hwy/targets.cc hwy/per_target.cc
make_archive libflint-dev flint libflint.a libflint.a --without-ntl
make_archive libflint-arb-dev flint-arb libarb.a libflint-arb.a --with-flint=/usr
rm -r "$work"
