# shellcheck shell=sh
# Packages of the machine: which of them a command needs, and how they get here.

# Installs what the command "$@" needs and does not find: as root, or with a sudo that asks nothing. Otherwise it says, in one command
# to type, what is missing. Either way the launcher goes on: whoever cannot do without says so.
install_missing() {
    # shellcheck disable=SC2046 # a list of names
    set -- $(missing_packages "$@")
    [ $# = 0 ] || install "$@"
}

# Debian's names, one a line.
missing_packages() {
    has_java || echo jdk
    has mvn || is_built "$1" || find_gradle || echo maven
    needs_opengl "$@" && ! has_opengl && echo libosmesa6
    needs_sandbox "$@" && ! has bwrap && echo bubblewrap
    [ "$1" != test ] || test_packages
}

needs_opengl() {
    case "$* " in
        *' --help '* | *' -h '* | *' --context'[\ =]egl' '* | *' --context'[\ =]window' '* | *' --context'[\ =]reference' '*) return 1 ;;
        run\ * | soak\ *--window*) [ -z "${DISPLAY-}${WAYLAND_DISPLAY-}" ] ;;
        grade\ *) case "$* " in *' --merge '*) return 1 ;; esac ;;
        render\ * | replay\ * | golden\ * | bench\ * | accuracy\ * | soak\ *) ;;
        *) return 1 ;;
    esac
}

# Off screen, that is: OSMesa; or a GPU's EGL; or Mesa's, which can come without a driver. Only Linux has `ldconfig -p`.
has_opengl() {
    libraries=$(PATH=$PATH:/usr/sbin:/sbin ldconfig -p 2>/dev/null) || return 0
    case $libraries in
        *libOSMesa.so* | *libEGL_nvidia*) return ;;
        *libEGL_mesa*) for driver in /usr/lib*/dri/*_dri.so /usr/lib/*/dri/*_dri.so; do [ -e "$driver" ] && return; done ;;
    esac
    return 1
}

# Submissions run in bubblewrap, which only Linux has.
needs_sandbox() {
    case "$* " in *' --help '* | *' -h '* | *' --merge '* | *' --unsafe-no-sandbox '*) return 1 ;; grade\ * | bench\ *) ;; *) return 1 ;; esac
    [ "$(uname)" = Linux ]
}

test_packages() {
    has dpkg || return
    browser=chromium
    ! has google-chrome || browser=
    for package in libosmesa6 libegl1 libgl1-mesa-dri libgl1 xvfb xdotool openbox g++ libglm-dev shellcheck bubblewrap $browser; do
        is_installed "$package" || echo "$package"
    done
}

is_installed() { dpkg -s "$1" 2>/dev/null | grep -q '^Status: .* installed'; }

# install PACKAGE...
install() {
    if has apt-get; then install_with_apt "$@"
    elif has brew; then say "missing; type: brew install $(echo "$*" | sed 's/jdk/--cask temurin/')"
    else say "missing (Debian's names): $*; install them with your package manager"; fi
}

install_with_apt() {
    find_root && mkdir -p "$build" && $as_root apt-get update >"$build/apt.log" 2>&1 </dev/null
    # shellcheck disable=SC2046 # a list of names
    set -- $(for package; do known_as "$package"; done)
    [ $# != 0 ] || return
    sudo='sudo '
    [ "$(id -u)" != 0 ] || sudo=''
    command_to_type="${sudo}apt-get update && ${sudo}apt-get install -y --no-install-recommends $*"
    [ -n "$as_root" ] || { say "missing: $*; type: $command_to_type" && return; }
    say "installing $*"
    $as_root DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@" >>"$build/apt.log" 2>&1 </dev/null ||
        say "that failed, see $build/apt.log; to try by hand, type: $command_to_type"
}

# The name of a package here, or its successors', or nothing.
known_as() {
    case $1 in
        jdk) if apt_knows openjdk-17-jdk-headless; then echo openjdk-17-jdk-headless
            elif apt_knows openjdk-21-jdk-headless; then echo openjdk-21-jdk-headless
            # No lists yet. Ubuntu 22.04 calls Java 11 its default.
            elif grep -q jammy /etc/os-release; then echo openjdk-17-jdk-headless
            else echo default-jdk-headless; fi ;;
        # Mesa 25.1 dropped OSMesa; a Debian without it has EGL.
        libosmesa6) if apt_knows libosmesa6 || ! apt_knows libegl1; then echo libosmesa6
            else for package in libegl1 libgl1-mesa-dri; do is_installed $package || echo $package; done; fi ;;
        # Ubuntu has Chromium as a snap only.
        chromium) if apt_knows chromium || ! apt_knows libegl1; then echo chromium; fi ;;
        *) echo "$1" ;;
    esac
}

# Sets as_root to what runs a command as root without asking, or to nothing.
find_root() {
    as_root='env'
    [ "$(id -u)" = 0 ] && return
    as_root='sudo -n env'
    sudo -n true 2>/dev/null || { as_root='' && return 1; }
}

# A name that only other packages provide is known, too, and has nothing to show.
apt_knows() { [ -n "$(apt-cache show "$1" 2>/dev/null)" ]; }
