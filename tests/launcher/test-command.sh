#!/bin/sh
# ./cga test: what it installs, what it runs.
. "$(dirname "$0")/sandbox.sh"
printf '%s\n' libosmesa6 libegl1 libgl1-mesa-dri libgl1 xvfb xdotool openbox g++ libglm-dev shellcheck bubblewrap chromium >"$sandbox/home/installed-packages"
stub mvn <<END
echo 'Tests run: 3' && pwd >"$sandbox/folder" && env >"$sandbox/environment" && exit 1
END

cga test
check 'Maven tests' called 'mvn -B -ntp test$'
check 'and it is said' said 'testing with Maven'
check 'its summary is seen' printed 'Tests run: 3'
check 'its exit code passes through' ended 1
check 'it runs in the checkout' [ "$(cat "$sandbox/folder")" = "$(cd "$checkout" && pwd -P)" ]
check 'with software rendering' grep -q -x LIBGL_ALWAYS_SOFTWARE=1 "$sandbox/environment"
check 'nothing is installed where nothing is missing' not called apt-get

cga test --tests '*SpotLightTest'
check 'a pattern is for Maven -Dtest' called 'mvn -B -ntp test -Dtest=\*SpotLightTest$'
cga test --tests=cga.exercise.SpotLightTest.bind
check 'and a method has its hash' called 'mvn -B -ntp test -Dtest=cga.exercise.SpotLightTest#bind$'
cga test --fast
check 'an unknown option ends with 2' ended 2
check 'and is named' said "not '--fast'"
cga test --tests
check 'a pattern that is missing ends with 2' ended 2
check 'without a test' not called mvn

printf '%s\n' libosmesa6 libegl1 libgl1-mesa-dri libgl1 xdotool openbox shellcheck bubblewrap chromium >"$sandbox/home/installed-packages"
cga test
check 'what the tests need and is missing is named' \
    said 'missing: xvfb g++ libglm-dev; type: sudo apt-get update && sudo apt-get install -y --no-install-recommends xvfb g++ libglm-dev'
check 'the tests run, and tell what they skip' called mvn
echo 0 >"$sandbox/uid"
cga test
check 'root installs it' called 'apt-get install -y --no-install-recommends xvfb g++ libglm-dev$'

echo libosmesa6 >"$sandbox/home/unknown-packages"
printf '%s\n' libegl1 libgl1-mesa-dri libgl1 xvfb xdotool openbox g++ libglm-dev shellcheck bubblewrap chromium >"$sandbox/home/installed-packages"
cga test
check 'a Debian that has dropped OSMesa is not asked for it' not called 'apt-get install'

printf '%s\n' libosmesa6 libegl1 libgl1-mesa-dri libgl1 xvfb xdotool openbox g++ libglm-dev shellcheck bubblewrap >"$sandbox/home/installed-packages"
cga test
check 'a browser is installed' called 'apt-get install -y --no-install-recommends chromium$'
echo chromium >>"$sandbox/home/unknown-packages"
cga test
check 'but not where it comes as a snap only' not called 'apt-get install'
: >"$sandbox/home/unknown-packages"
stub google-chrome </dev/null
cga test
check 'nor where Chrome is at hand' not called 'apt-get install'

stub gradle <<'END'
[ "$1" = --version ] && echo 'Gradle 9.3.1'
END
cga test --tests '*SpotLightTest'
check 'Gradle tests where it is at hand' called 'gradle --console=plain test --tests \*SpotLightTest$'
check 'and its exit code passes through' ended 1
