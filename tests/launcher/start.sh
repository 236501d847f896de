#!/bin/sh
# How ./cga starts the program.
. "$(dirname "$0")/sandbox.sh"

cga
check 'without arguments it prints its help' printed 'Usage: ./cga COMMAND'
check 'and all is well' ended 0
check 'which builds nothing' [ ! -s "$calls" ]
cga --help
check 'so does --help' printed 'Usage: ./cga COMMAND'

# shellcheck disable=SC2016 # a dollar sign is meant
cga render --out 'two  words' '' '*' "it's" 'a\b' '$HOME'
# shellcheck disable=SC2016
printf '%s\n' cga.cli.MainKt render --out 'two  words' '' '*' "it's" 'a\b' '$HOME' >"$sandbox/expected"
tail -n 9 "$sandbox/arguments" >"$sandbox/last"
check 'arguments reach the program unchanged' [ "$(cat "$sandbox/last")" = "$(cat "$sandbox/expected")" ]
check 'stdout is the program'"'"'s' [ "$(cat "$sandbox/out")" = 'the picture' ]
check 'and so is the exit code' ended 7
check 'it runs where the user is' [ "$(cat "$sandbox/folder")" = "$(cd "$sandbox/elsewhere" && pwd -P)" ]
check 'it is told where the checkout is' argument "-Dcga.home=$checkout"
lib=$checkout/build/cga/lib
check "its class path is the libraries for this machine, then our own jars" \
    argument "$lib/joml.jar:$lib/kotlin-stdlib-2.0.jar:$lib/cga-scene.jar:$lib/cga-pictures.jar:$lib/cga-cli.jar:$lib/cga-window.jar"
check 'what it cooks lies with the build' argument "-Dcga.cooked=$checkout/build/cga/cooked"
check 'a short command starts quickly' argument -XX:TieredStopAtLevel=1
check 'and its heap may grow' not argument -XX:+AlwaysPreTouch
check 'right after a build nobody waits for an archive of classes' not called archive
check 'OpenGL is 3.3' grep -q -x MESA_GL_VERSION_OVERRIDE=3.3 "$sandbox/environment"
check 'and GLSL 330' grep -q -x MESA_GLSL_VERSION_OVERRIDE=330 "$sandbox/environment"
check 'a GPU may be used' not grep -q LIBGL_ALWAYS_SOFTWARE "$sandbox/environment"
check 'Java 17 is not given flags that it does not know' not argument --enable-native-access=ALL-UNNAMED

cga render
check 'the next start makes an archive of the libraries and one of all classes' [ "$(grep -c archive "$calls")" = 2 ]
check 'and starts with it' argument "-XX:SharedArchiveFile=$checkout/build/cga/window-17.0.1.jsa"
cga render
check 'which are made once' not called archive

echo '// changed' >>"$scene/Main.kt"
cga render
check 'after an edit it starts with the archive of the libraries' argument "-XX:SharedArchiveFile=$checkout/build/cga/window-libraries-17.0.1.jsa"
check 'and makes none' not called archive
cga render
check 'until it is started once more' [ "$(grep -c archive "$calls")" = 1 ]

environment=MESA_GL_VERSION_OVERRIDE=4.5
cga run
check 'run is compiled in full' not argument -XX:TieredStopAtLevel=1
check 'a version that the user set stays' grep -q -x MESA_GL_VERSION_OVERRIDE=4.5 "$sandbox/environment"

jdk "$sandbox/jdk-25" 25.0.3
environment="JAVA_HOME=$sandbox/jdk-25"
cga doctor
check 'JAVA_HOME is honoured: another JDK has an archive of its own' argument "-XX:SharedArchiveFile=$checkout/build/cga/window-25.0.3.jsa"
check 'and needs no build' not called mvn
check 'Java 25 may access native code' argument --enable-native-access=ALL-UNNAMED

sed 's/&& echo classes.*exit ;;/\&\& exit 1 ;;/' "$sandbox/jdk-17/bin/java" >"$sandbox/jdk-25/bin/java"
rm -f "$checkout"/build/cga/*.jsa
cga doctor
check 'where no archive can be made the program starts without' not argument "-XX:SharedArchiveFile=$checkout/build/cga/window-25.0.3.jsa"
check 'silently' [ ! -s "$sandbox/err" ]
cga doctor
check 'and none is tried again' not called archive

environment=
ln -s "../a check  out/cga" "$sandbox/elsewhere/link"
ln -s "$sandbox/elsewhere/link" "$sandbox/bin/lights"
launcher=$sandbox/bin/lights
cga render
check 'through a chain of links it finds its checkout' argument "-Dcga.home=$checkout"

cga soak --window 1
check 'a soak of the window has its whole heap from the start' argument -XX:+AlwaysPreTouch
cga soak --evaluations 1
check 'one of the shading has it not' not argument -XX:+AlwaysPreTouch
