#!/bin/sh
# ./cga test: what it installs, what it runs.
. "$(dirname "$0")/sandbox.sh"
printf '%s\n' libosmesa6 libegl1 libgl1-mesa-dri libgl1 xvfb xdotool openbox g++ libglm-dev shellcheck bubblewrap chromium >"$sandbox/home/installed-packages"
stub mvn <<END
mkdir -p target/scene/surefire-reports
cp "$sandbox/report" target/scene/surefire-reports/TEST-cga.ATest.xml
pwd >"$sandbox/folder" && env >"$sandbox/environment"
END
cat >"$sandbox/report" <<'END'
<testsuite name="cga.ATest" time="1.5" tests="3">
<testcase name="a" classname="cga.ATest" time="1"/>
<testcase name="b" classname="cga.ATest" time="0"><failure message="1 is not 2"/></testcase>
<testcase name="c" classname="cga.ATest" time="0"><skipped message="needs a GPU"/></testcase>
</testsuite>
END

cga test
check 'Maven tests' called 'mvn -B .*-Dmaven.test.failure.ignore=true -Dcga.tests.together test$'
check 'and it is said' said 'testing with Maven'
check 'the log is named' said "its log is $checkout/build/cga/test.log"
check 'the slowest class is printed' printed '1.5 s  cga.ATest'
check 'and which test failed, and how' printed 'failed: cga.ATest#b: 1 is not 2'
check 'and why one was skipped' printed 'skipped: needs a GPU (1)'
check 'and last how many' [ "$(tail -n 1 "$sandbox/out")" = '1 passed, 1 failed, 1 skipped' ]
check 'a failed test ends with 1' ended 1
check 'it runs in the checkout' [ "$(cat "$sandbox/folder")" = "$(cd "$checkout" && pwd -P)" ]
check 'with software rendering' grep -q -x LIBGL_ALWAYS_SOFTWARE=1 "$sandbox/environment"
check 'nothing is installed where nothing is missing' not called apt-get

cga test --tests '*SpotLightTest'
check 'a pattern is for Maven -Dtest' called 'mvn .* -Dtest=\*SpotLightTest$'
cga test --tests=cga.exercise.SpotLightTest.bind
check 'and a method has its hash' called 'mvn .* -Dtest=cga.exercise.SpotLightTest#bind$'
cga test --fast
check 'the slow ones can be left out' called 'mvn .* -Dcga.tests=fast$'
cga test --quick
check 'an unknown option ends with 2' ended 2
check 'and is named' said "not '--quick'"
cga test --tests
check 'a pattern that is missing ends with 2' ended 2
check 'without a test' not called mvn

sed -i 's/<failure.*failure>//; s/<failure[^>]*>//' "$sandbox/report"
maven=$(cat "$sandbox/bin/mvn")
stub mvn <<END
mkdir -p target/scene/surefire-reports
cp "$sandbox/report" target/scene/surefire-reports/TEST-cga.ATest.xml
echo '[ERROR] Main.kt: (1, 5) Unresolved reference: mian'
printf 'no end of a line'
exit 1
END
cga test
check 'a build that fails behind tests that passed ends with 2' ended 2
check 'and says why' said 'Unresolved reference: mian'
stub mvn <<'END'
echo '[ERROR] Plugin a:b:1 or one of its dependencies could not be resolved: unknown certificate -> [Help 1]'
exit 1
END
cga test
check 'one that fails before any test ends with 2' ended 2
check 'and says so' printed 'no test ran'
check 'and why' said 'could not be resolved: unknown certificate'
echo "$maven" >"$sandbox/bin/mvn"
sed -i 's|classname="cga.ATest" time="0"></testcase>|classname="cga.ATest" time="0"><failure message="1 is not 2"/></testcase>|' "$sandbox/report"

cga corpus --part 2/8 --accept
check 'the guard is a test' called 'mvn .* -Dtest=\*CorpusGuardTest$'
check 'which is told what to judge' grep -q -x CGA_CORPUS=2/8 "$sandbox/environment"
check 'and that it is right' grep -q -x CGA_CORPUS_ACCEPT=true "$sandbox/environment"
check 'it ends as the test does' ended 1
cga corpus plain later
check 'names are handed on' grep -q -x 'CGA_CORPUS=plain later' "$sandbox/environment"
cga corpus
check 'without any it is one for every mistake' grep -q -x CGA_CORPUS=guard "$sandbox/environment"
cga corpus --every
check 'an unknown option of the guard is named' said "not '--every'"

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

stub gradle <<END
[ "\$1" = --version ] && echo 'Gradle 9.3.1' && exit
mkdir -p build/scene/test-results/test && cp "$sandbox/report" build/scene/test-results/test/TEST-cga.ATest.xml
END
cga test --tests '*SpotLightTest'
check 'Gradle tests where it is at hand' called 'gradle --console=plain --continue test --tests \*SpotLightTest$'
check 'and its reports are read' printed '1 passed, 1 failed, 1 skipped'
