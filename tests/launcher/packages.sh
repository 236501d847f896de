#!/bin/sh
# Which packages ./cga installs, and which it only names.
. "$(dirname "$0")/sandbox.sh"

installs() { called "apt-get install -y --no-install-recommends $1"; }

cga render
check 'with OSMesa here nothing is missing' not said missing

stub ldconfig <<'END'
echo 'libEGL_nvidia.so.0 (libc6,x86-64) => /lib/libEGL_nvidia.so.0'
END
cga render
check 'nor with a driver for EGL' not said missing

stub ldconfig <<'END'
echo 'libEGL.so.1 (libc6,x86-64) => /lib/libEGL.so.1'
END
cga render
check 'a user whom sudo asks for a password gets the command' \
    said 'missing: libosmesa6; type: sudo apt-get update && sudo apt-get install -y --no-install-recommends libosmesa6'
check 'and no installation' not installs ''
check 'the program starts all the same, and can say more' called java

touch "$sandbox/home/sudoer"
cga render
check 'sudo without a password installs' installs libosmesa6
check 'and it is said' said 'installing libosmesa6'
rm "$sandbox/home/sudoer"

echo 0 >"$sandbox/uid"
rm "$sandbox/bin/sudo"
cga render
check 'root installs without sudo' installs libosmesa6
check 'from fresh lists' [ "$(sed -n 's/^apt-get \([a-z]*\).*/\1/p' "$calls" | tr '\n' ' ')" = 'update install ' ]

echo libosmesa6 >"$sandbox/home/unknown-packages"
cga render
check 'a Debian that has dropped OSMesa gets EGL' installs 'libegl1 libgl1-mesa-dri$'
mv "$sandbox/home/unknown-packages" "$sandbox/home/virtual-packages"
cga render
check 'and so does one where only its name is left' installs 'libegl1 libgl1-mesa-dri$'
mv "$sandbox/home/virtual-packages" "$sandbox/home/unknown-packages"
rm "$sandbox/home/unknown-packages"

for command in 'render --context egl' 'render --context=window' 'render --context reference' 'render --context=reference' 'render --help' 'doctor'; do
    # shellcheck disable=SC2086 # a list of arguments
    cga $command
    check "'$command' installs nothing" not called apt-get
done
cga render --context osmesa
check 'who asks for OSMesa gets it' installs libosmesa6
cga golden
check 'the goldens need it too' installs libosmesa6
cga accuracy
check 'and so does the accuracy report' installs libosmesa6

cga run
check 'run without a display renders, so it needs OSMesa' installs libosmesa6
environment=DISPLAY=:0
cga run
check 'with a display it does not' not called apt-get
environment=

stub apt-get <<'END'
[ "$1" = update ] || { echo 'E: the disk is full' && exit 100; }
END
cga render
check 'a failing installation says what to type' said 'to try by hand, type: apt-get update && apt-get install -y --no-install-recommends libosmesa6'
check 'and keeps the reason' grep -q 'the disk is full' "$checkout/build/cga/apt.log"
check 'the program starts all the same' called java

rm "$sandbox/bin/apt-get"
cga render
check 'where there is no apt-get the package is named' said "missing (Debian's names): libosmesa6"
