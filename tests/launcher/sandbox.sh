# What every launcher test starts with: a throw-away checkout, with stubs for all that ./cga calls and the machine's
# own tools for all else. The checkout's path has blanks and is reached from elsewhere, so every test covers that.
# shellcheck shell=sh
set -eu

root=$(cd "$(dirname "$0")/../.." && pwd -P)
sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
checkout="$sandbox/a check  out"
calls="$sandbox/calls"

scene=$checkout/src/scene/kotlin
mkdir -p "$scene" "$checkout/src/grader/kotlin" "$sandbox/bin" "$sandbox/home" "$sandbox/elsewhere"
cp "$root/cga" "$checkout/cga"
cp -R "$root/src/launcher" "$checkout/src/launcher"
echo 'fun main() = Unit' >"$scene/Main.kt"
(cd "$root/src" && for file in */build.gradle.kts; do mkdir -p "$checkout/src/${file%/*}" && cp "$file" "$checkout/src/$file"; done)
touch "$checkout/pom.xml" "$checkout/build.gradle.kts" "$calls"

for tool in sh awk cat chmod cksum cp date dirname env find grep head ln mkdir mv readlink rm sed sleep sort tail tee touch tr uname; do
    ln -s "$(command -v $tool)" "$sandbox/bin/$tool"
done

# stub NAME: a command that does what stdin says, after it has noted its call.
stub() {
    { printf '#!/bin/sh\necho "%s $*" >>"%s"\n' "$1" "$calls" && cat; } >"$sandbox/bin/$1"
    chmod +x "$sandbox/bin/$1"
}

# jdk FOLDER VERSION: a JDK whose java notes its arguments, and makes the archive of classes that it is asked for; the renders
# that prepare it do nothing.
jdk() {
    mkdir -p "$1/bin"
    echo "JAVA_VERSION=\"$2\"" >"$1/release"
    cat >"$1/bin/java" <<END
#!/bin/sh
case \$1 in
    -Xshare:dump) echo archive >>"$calls" && echo classes >"\${2#*=}" && exit ;;
esac
case \$* in */warm-up.png) exit ;; esac
echo java >>"$calls"
printf '%s\n' "\$@" >"$sandbox/arguments"
env >"$sandbox/environment"
pwd >"$sandbox/folder"
echo 'the picture'
exit 7
END
    chmod +x "$1/bin/java"
    cp "$1/bin/java" "$1/bin/javac"
}

# cga ARGUMENT...: runs the launcher from elsewhere; its status, and what it prints, are kept for the checks.
cga() {
    : >"$calls"
    rm -f "$sandbox/arguments"
    status=0
    # shellcheck disable=SC2086 # a list of assignments
    (cd "$sandbox/elsewhere" && exec env -i HOME="$sandbox/home" PATH="$sandbox/bin" ${environment-} "${launcher:-$checkout/cga}" "$@") \
        >"$sandbox/out" 2>"$sandbox/err" </dev/null || status=$?
}

# check WHAT COMMAND...: fails the test, with all that is known, unless the command succeeds.
check() {
    what=$1
    shift
    "$@" && echo "ok: $what" && return
    echo "FAILED: $what"
    tail -n +1 "$sandbox/out" "$sandbox/err" "$calls"
    echo "status: $status"
    exit 1
}

not() { ! "$@"; }
called() { grep -q -e "^$1" "$calls"; }
said() { grep -q -F -e "$1" "$sandbox/err"; }
printed() { grep -q -F -e "$1" "$sandbox/out"; }
argument() { grep -q -x -F -e "$1" "$sandbox/arguments"; }
ended() { [ "$status" = "$1" ]; }

# The machine that most tests want: JDK 17, Maven, OSMesa, Debian, an ordinary user who must type a password.
jdk "$sandbox/jdk-17" 17.0.1
ln -s "$sandbox/jdk-17/bin/java" "$sandbox/bin/java"
stub mvn <<'END'
mkdir -p build/cga/lib && touch build/cga/lib/joml.jar build/cga/lib/lwjgl-natives-windows.jar build/cga/lib/kotlin-stdlib-2.0.jar
END
stub ldconfig <<'END'
echo 'libOSMesa.so.8 (libc6,x86-64) => /lib/libOSMesa.so.8'
END
stub id <<END
cat "$sandbox/uid"
END
echo 1000 >"$sandbox/uid"
stub sudo <<'END'
[ -e "$HOME/sudoer" ] && shift && "$@"
END
stub apt-get </dev/null
stub apt-cache <<'END'
grep -q -x "$2" "$HOME/virtual-packages" 2>/dev/null || { ! grep -q -x "$2" "$HOME/unknown-packages" 2>/dev/null && echo "Package: $2"; }
END
stub dpkg <<'END'
grep -q -x "$2" "$HOME/installed-packages" && echo 'Status: install ok installed'
END
