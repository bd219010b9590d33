#!/usr/bin/env bash
# tests/release.sh FOLDER: the checks of `./run release`. The tree is committed, its version is consistent, and its
# archive builds the Debian packages in the emptied FOLDER without git and without a network: lintian finds no problem,
# and their program prints its commit and correct digits. The archive and the packages stay in FOLDER.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
folder=$1

say() { printf 'release: %s\n' "$*" >&2; }
fail() {
    say "$*"
    exit 1
}

changes=$(git -C "$root" status --porcelain) || fail "$root is not a clone of the repository: a release needs a commit"
[[ -z $changes ]] || fail $'these files differ from the commit, commit or remove them:\n'"$changes"
version=$(cmake -D SOURCE="$root" -P "$root/cmake/check_versions.cmake") || exit 1
commit=$(git -C "$root" rev-parse HEAD)
say "version $version, commit ${commit:0:10}"

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
archive=libration-$version.tar.gz
git -C "$root" archive --format=tar.gz --prefix="libration-$version/" -o "$folder/$archive" HEAD
tar -xzf "$archive"

# All programs of this machine except git.
mkdir programs
for path in ${PATH//:/ }; do # of two with the same name the first is kept
    find "$path/" -maxdepth 1 ! -type d ! -name 'git*' -exec ln -st programs {} + 2>/dev/null || true
done
alone=(env PATH="$folder/programs")
"${alone[@]}" sh -c 'command -v git' && fail "git is still found"
if unshare --map-root-user --net true 2>/dev/null; then
    alone=(unshare --map-root-user --net "${alone[@]}")
else
    say "the network cannot be disabled on this machine: it stays enabled"
fi
# debhelper sets HOME to a separate directory, which contains no cache.
if command -v ccache >/dev/null; then
    alone=(env CCACHE_DIR="$(ccache --get-config cache_dir)" "${alone[@]}")
fi

say "building in $folder/libration-$version"
(cd "libration-$version" && "${alone[@]}" dpkg-buildpackage -us -uc </dev/null >../build.log 2>&1) || {
    tail -n 60 build.log >&2
    fail "the packages could not be built; see $folder/build.log"
}

program=libration-$version/debian/libration/usr/bin/libration
said=$("$program" --version)
[[ $said == "libration $version"$'\n'"commit ${commit:0:10}"$'\n'* ]] ||
    fail "the program is not of this commit, but prints"$'\n'"$said"
# The value computed by mpmath, in tests/reference/motions.csv.
expected=9.6187422004082097481570490483897449729889629705330
said=$("$program" period --energy 1.71 --digits 50)
[[ $said == *"period  $expected"$'\n'* ]] || fail "the period at energy 1.71 is $expected, but the program prints"$'\n'"$said"

if command -v lintian >/dev/null; then
    lintian --allow-root --fail-on error,warning ./*.changes >&2 || fail "lintian reported the problems above"
else
    say "lintian is not installed: skipping its checks"
fi
rm -rf programs "libration-$version"
say "version $version is ready:"
sha256sum "$archive" ./*.deb
