#!/usr/bin/env bash
# Gradescope runs this once, when it builds the autograder's image: everything that needs a network happens here.
set -euo pipefail

root=${AUTOGRADER_ROOT:-/autograder}
program=${AUTOGRADER_PROGRAM:-$root/source/cga/cga}
# shellcheck source=/dev/null # what the instructor chose
. "$root/source/config.sh"

export DEBIAN_FRONTEND=noninteractive
apt-get update
packages=(openjdk-17-jdk-headless bubblewrap)
# Mesa 25.1 dropped OSMesa; what has none has EGL. A name without a package of its own may still be known.
if [ -n "$(apt-cache show libosmesa6 2>/dev/null)" ]; then packages+=(libosmesa6); else packages+=(libegl1 libgl1-mesa-dri); fi
apt-get install -y --no-install-recommends "${packages[@]}"

chmod +x "$program"
# Grades the empty starter as submissions will be, in the sandbox. The image is not built where that fails, and the compiler is fetched
# and made ready once, and not for each submission.
options=()
[ "$CGA_UNSAFE_NO_SANDBOX" != yes ] || options+=(--unsafe-no-sandbox)
warm=$(mktemp -d)
"$program" starter "$warm/starter"
results=$warm/results
# To the grader a starter that crashes is a submission with 0 points like any other; here it is the image's fault.
if ! "$program" grade "$warm/starter" --out "$results" "${options[@]}" || ! grep -q '^starter,graded,' "$results/grades.csv"; then
    [ ! -e "$results/starter/results.json" ] || sed 's/\\n/\n/g' "$results/starter/results.json" >&2
    echo "setup.sh: the starter could not be graded here, so no submission could be; the cause is above" >&2
    exit 1
fi
rm -rf "$warm"
