#!/bin/sh
# A missing or unfit Java is one line with the command that cures it.
. "$(dirname "$0")/sandbox.sh"

refuses() {
    check "$1: ends with 2" ended 2
    check "$1: says so in one line" [ "$(grep -c -v missing "$sandbox/err")" = 1 ]
    check "$1: builds nothing" not called mvn
}

rm "$sandbox/bin/java"
cga render
refuses 'no Java'
check 'no Java: what to type' \
    said 'missing: openjdk-17-jdk-headless; type: sudo apt-get update && sudo apt-get install -y --no-install-recommends openjdk-17-jdk-headless'

echo openjdk-17-jdk-headless >"$sandbox/home/unknown-packages"
cga render
check 'a Debian without 17 has 21' said 'openjdk-21-jdk-headless'

echo 0 >"$sandbox/uid"
cga render
check 'root has it installed' called 'apt-get install -y --no-install-recommends openjdk-21-jdk-headless$'
check 'and where that does not help it ends with 2' ended 2

rm "$sandbox/bin/apt-get"
cga render
check 'elsewhere there is another cure' said "missing (Debian's names): jdk; install them with your package manager"

jdk "$sandbox/jdk-11" 11.0.2
environment="JAVA_HOME=$sandbox/jdk-11"
cga render
refuses 'Java 11'
check 'Java 11: is named' said "Java 11.0.2 in $sandbox/jdk-11 is too old"

environment="JAVA_HOME=$sandbox/nothing"
cga render
refuses 'a wrong JAVA_HOME'
check 'a wrong JAVA_HOME: is named' said "no JDK in '$sandbox/nothing'"

rm "$sandbox/jdk-17/bin/javac"
environment="JAVA_HOME=$sandbox/jdk-17"
cga render
refuses 'a JRE'
check 'a JRE: lacks a compiler' said 'is without a compiler'

jdk "$sandbox/jdk-21" 21.0.2
stub java <<END
echo '    java.home = $sandbox/jdk-21' >&2
END
environment=
cga render
check 'a shim on the PATH is asked where its JDK is' called java
