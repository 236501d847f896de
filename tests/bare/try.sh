#!/usr/bin/env bash
# Tries the README's commands on bare systems: no locale, no JDK, nothing but what debootstrap's smallest variant has.
#
# Usage: tests/bare/try.sh [OPTION]... SUITE...        e.g. tests/bare/try.sh bookworm trixie jammy noble
#
#   --command LINE          a line of shell to run in a fresh clone of HEAD; may be given several times. Default: ./cga run, ./cga test
#   --user NAME             only as root, or only as this ordinary user; default: as root, then as student, each on a system of its own
#   --clone NAME            the name of the clone's folder, such as 'bare üb ung'; default: cga-lights
#   --without-sandbox       on systems that do not allow one, as many containers
#   --maven-repository DIR  a local repository of Maven's to copy in, so that nothing is downloaded again
#   --certificate FILE      an authority (PEM) that the network here wants trusted, such as a proxy's
#   --cache DIR             keep Debian's packages here, from one run to the next
#   --debootstrap OPTION    one more option for debootstrap, such as --no-check-gpg where there is no keyring for Ubuntu
#   --folder DIR            where the systems are made, and removed again; needs some GB. Default: a folder in TMPDIR
#
# Needs root, debootstrap and git. An ordinary user there cannot install packages: what the launcher says to type is typed as root, then the
# line is run once more. Ends with 1 if a line failed; a suite that cannot be had is named and left out.
set -euo pipefail

home=$(cd "$(dirname "$0")/../.." && pwd)
suites=() lines=() users=() more=() results=()
repository='' certificate='' cache='' folder='' clone=cga-lights sandbox=yes
status=0
while [ $# -gt 0 ]; do
    case $1 in
        --without-sandbox) ;;
        --*) [ $# -gt 1 ] || { echo "$1 needs a value" >&2 && exit 2; } ;;
    esac
    case $1 in
        --command) lines+=("$2") && shift ;;
        --user) users+=("$2") && shift ;;
        --clone) clone=$2 && shift ;;
        --without-sandbox) sandbox='' ;;
        --maven-repository) repository=$(realpath "$2") && shift ;;
        --certificate) certificate=$(realpath "$2") && shift ;;
        --cache) mkdir -p "$2" && cache=$(realpath "$2") && shift ;;
        --debootstrap) more+=("$2") && shift ;;
        --folder) folder=$2 && shift ;;
        -*) echo "unknown option $1: see the head of $0" >&2 && exit 2 ;;
        *) suites+=("$1") ;;
    esac
    shift
done
[ ${#suites[@]} -gt 0 ] || { echo "name a suite, such as bookworm: see the head of $0" >&2 && exit 2; }
[ "$(id -u)" = 0 ] || { echo "only root can make a system" >&2 && exit 2; }
command -v debootstrap >/dev/null || { echo "debootstrap is missing: apt-get install debootstrap" >&2 && exit 2; }
[ ${#lines[@]} -gt 0 ] || lines=('./cga run' './cga test')
[ ${#users[@]} -gt 0 ] || users=(root student)
[ -z "$folder" ] || mkdir -p "$folder"
work=$(mktemp -d ${folder:+-p "$folder"} -t cga-bare.XXXXXX)
# Nothing is mounted in this process's namespace, so that nothing but the systems themselves is ever removed.
trap 'rm -rf --one-file-system "$work"' EXIT
trap 'exit 130' INT TERM

# make SUITE: the bare system in $work/SUITE.
make() {
    local options=(--variant=minbase "${more[@]}")
    [ -z "$cache" ] || options+=(--cache-dir="$cache")
    # Ubuntu's own images have universe, where Maven is; debootstrap takes main only.
    ! grep -qs ubuntu "/usr/share/debootstrap/scripts/$1" || options+=("--components=main,universe")
    debootstrap "${options[@]}" "$1" "$work/$1" >"$work/$1.log" 2>&1 || return 1
    # As images come: no list of packages, and none of those that were downloaded.
    rm -rf "$work/$1"/var/lib/apt/lists/* "$work/$1"/var/cache/apt/archives/*.deb
    cp /etc/resolv.conf "$work/$1/etc/resolv.conf"
    # The package ca-certificates takes it over from there.
    [ -z "$certificate" ] || install -D -m 644 "$certificate" "$work/$1/usr/local/share/ca-certificates/here.crt"
    apt-config dump | grep -E '^Acquire::(http|https)::proxy' >"$work/$1/etc/apt/apt.conf.d/proxy" || true
}

# enter SYSTEM USER LINE: runs LINE there, in namespaces of its own, so that all processes and mounts end with it. Who was only chrooted may
# not make the namespaces of a sandbox, nor may a root without CAP_SYS_ADMIN; pivot_root leaves that open.
enter() {
    local directory=/root
    [ "$2" = root ] || directory=/home/$2
    # shellcheck disable=SC2016 # the other shell's own
    unshare --mount --pid --fork --kill-child --propagation private sh -euc '
        mount --bind "$1" "$1"
        cd "$1"
        mount -t proc proc proc
        mount --rbind /dev dev
        [ -z "$4" ] || mount --bind "$4" var/cache/apt/archives
        if [ "$7" = yes ]; then pivot_root . . && umount -l . && cd / && change_root=; else change_root="setpriv --bounding-set=-sys_admin chroot ."; fi
        set -- "$2" "$3" "$5" "$6" env -i HOME="$3" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
            ${http_proxy:+"http_proxy=$http_proxy"} ${https_proxy:+"https_proxy=$https_proxy"}
        user=$1 directory=$2 line=$3 clone=$4
        shift 4
        [ "$user" = root ] || set -- setpriv --reuid "$user" --regid "$user" --init-groups "$@"
        [ ! -d ".$directory/$clone" ] || directory=$directory/$clone
        exec $change_root "$@" sh -c "cd \"\$1\" && eval \"\$2\"" sh "$directory" "$line"
    ' sh "$1" "$2" "$directory" "$cache" "$3" "$clone" "$sandbox" </dev/null
}

# try SUITE USER: all lines, on one copy of the system.
try() {
    local system=$work/system target line begun ended said
    cp -a "$work/$1" "$system"
    target=$system/root
    if [ "$2" != root ]; then
        chroot "$system" useradd --create-home "$2"
        target=$system/home/$2
    fi
    git clone -q --depth 1 "file://$home" "$target/$clone"
    [ -z "$repository" ] || { mkdir "$target/.m2" && cp -r "$repository" "$target/.m2/repository"; }
    [ "$2" = root ] || chroot "$system" chown -R "$2:$2" "/home/$2"
    for line in "${lines[@]}"; do
        echo "=== $1, $2: $line"
        begun=$(date +%s)
        ended=0
        enter "$system" "$2" "$line" 2>&1 | tee "$work/said" || ended=$?
        said=$(sed -n 's/.*type: \(.*\)/\1/p' "$work/said" | tail -n 1)
        if [ "$2" != root ] && [ -n "$said" ]; then
            echo "=== $1, root types: $said"
            enter "$system" root "sudo() { env \"\$@\"; }; export DEBIAN_FRONTEND=noninteractive; $said" >"$work/typed" 2>&1 ||
                tail -n 20 "$work/typed"
            echo "=== $1, $2 again: $line"
            ended=0
            enter "$system" "$2" "$line" 2>&1 || ended=$?
        fi
        [ $ended = 0 ] || status=1
        results+=("$1, $2: $line: exit code $ended, $(($(date +%s) - begun)) s")
    done
    rm -rf --one-file-system "$system"
}

for suite in "${suites[@]}"; do
    if ! make "$suite"; then
        results+=("$suite: cannot be had: $(tail -n 1 "$work/$suite.log")")
        continue
    fi
    for user in "${users[@]}"; do try "$suite" "$user"; done
    rm -rf --one-file-system "${work:?}/$suite"
done
printf '%s\n' '=== Results' "${results[@]}"
exit $status
