#!/bin/sh
# When ./cga builds, and with what.
. "$(dirname "$0")/sandbox.sh"

cga render
check 'the first use builds with Maven' called 'mvn .*package'
check 'and says so, and why' said 'building with Maven (first use)'
check 'then it starts the program' called java

check 'of the program only the part that the command needs' called 'mvn .* -pl src/window -am package$'
check 'which uses those that its build file names' \
    [ "$(grep '^cga-' "$checkout/build/cga/window.classpath" | tr '\n' ' ')" = 'cga-scene.jar cga-pictures.jar cga-cli.jar cga-window.jar ' ]
check 'without what only tests need' called 'mvn .* -DwithoutTests '
check 'and without cleaning what other parts have in the same folder' called 'mvn .* -Dmaven.clean.skip=true '
check 'it names the log' said "its log is $checkout/build/cga/window.log"

cga render
check 'the second start calls no build tool' not called mvn
check 'and says nothing' [ ! -s "$sandbox/err" ]

touch -t 203001010000 "$scene/Main.kt"
cga render
check 'a touch is no change' not called mvn

mkdir "$checkout/build/cga/cooked"
echo '// changed' >>"$scene/Main.kt"
cga render
check 'a changed source rebuilds' called 'mvn .*'
check 'without copying the libraries again' called 'mvn .* prepare-package$'
check 'and what older classes cooked is gone' [ ! -e "$checkout/build/cga/cooked" ]
check 'and says why' said 'building with Maven (sources changed)'

echo '// changed' >>"$checkout/src/grader/kotlin/Main.kt"
cga render
check 'what changed in another part does not' not called mvn
cga grade --help
check 'a command of that part builds it' called 'mvn .* -pl src/grader -am package$'
cga render
check 'and leaves the first as it is' not called mvn

stub mvn <<'END'
mkdir -p build/cga/lib && touch build/cga/lib/cga-scene.jar
echo 'Downloading from central: a.jar'
echo '[INFO] Building scene 1.0                                                 [2/5]'
echo '[INFO] --- kotlin-maven-plugin:2.4:compile (compile) @ scene ---'
END
echo '// changed' >>"$scene/Main.kt"
cga render
check 'a download is told' said 'downloading libraries'
check 'and how far the build is' said 'compiling scene (1 of 4)'

echo 'val x = 1' >"$scene/Added.kt"
cga render
check 'an added source rebuilds' called mvn

mv "$scene/Added.kt" "$scene/Renamed.kt"
cga render
check 'a renamed source rebuilds' called mvn

rm "$scene/Renamed.kt"
cga render
check 'a deleted source rebuilds' called mvn

for file in pom.xml build.gradle.kts; do
    echo '<!-- changed -->' >>"$checkout/$file"
    cga render
    check "a changed $file rebuilds" called mvn
done

touch "$scene/.Main.kt.swp" "$scene/Main.kt~"
cga render
check 'what an editor leaves beside a source does not rebuild' not called mvn

rm -r "$checkout/build/cga/lib"
cga render
check 'jars that are gone are built again' called mvn

touch "$checkout/build/cga/lib/old-version.jar"
echo '<!-- another version -->' >>"$checkout/pom.xml"
cga render
check 'no jar of an earlier build stays' [ ! -e "$checkout/build/cga/lib/old-version.jar" ]

stub gradle <<'END'
[ "$1" = --version ] && echo 'Gradle 4.4.1' && exit
END
echo '// changed' >>"$checkout/build.gradle.kts"
cga render
check 'a gradle that is too old is left aside' said 'building with Maven'

stub gradle <<'END'
[ "$1" = --version ] && echo 'Gradle 8.7' && exit
mkdir -p build/cga/lib && touch build/cga/lib/cga-scene.jar
END
echo '// changed' >>"$checkout/build.gradle.kts"
cga render
check 'Gradle is preferred where it is at hand' called 'gradle .*:window:installCga'
check 'and said' said 'building with Gradle (sources changed)'
check 'Maven is not called as well' not called mvn

jdk "$sandbox/jdk-25" 25.0.3
environment="JAVA_HOME=$sandbox/jdk-25"
echo '// changed' >>"$checkout/build.gradle.kts"
cga render
check 'but not for a JDK that it does not know yet' said 'building with Maven'
environment=

mkdir -p "$checkout/gradle/wrapper"
printf '%s\n' 'distributionUrl=https\://example.org/gradle-9.9-bin.zip' >"$checkout/gradle/wrapper/gradle-wrapper.properties"
sed "s/^echo \"gradle /echo \"gradlew /" "$sandbox/bin/gradle" >"$checkout/gradlew"
chmod +x "$checkout/gradlew"
echo '// changed' >>"$checkout/build.gradle.kts"
cga render
check 'a wrapper that would have to download first is left aside' not called gradlew

mkdir -p "$sandbox/home/.gradle/wrapper/dists/gradle-9.9-bin/hash"
touch "$sandbox/home/.gradle/wrapper/dists/gradle-9.9-bin/hash/gradle-9.9-bin.zip.ok"
echo '// changed' >>"$checkout/build.gradle.kts"
cga render
check 'a wrapper whose Gradle is there already is taken' called 'gradlew .*:window:installCga'

rm -r "$sandbox/bin/gradle" "$sandbox/bin/mvn" "$sandbox/home/.gradle" "$checkout/build"
cga render
check 'without Gradle and Maven it ends with 2' ended 2
check 'and says what to type' said 'sudo apt-get install -y --no-install-recommends maven'
