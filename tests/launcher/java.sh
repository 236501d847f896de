#!/bin/sh
# A missing or unfit Java is one line with the command that cures it.
. "$(dirname "$0")/sandbox.sh"

refuses() {
    check "$1: ends with 2" ended 2
    check "$1: says so in one line" [ "$(grep -c '' "$sandbox/err")" = 1 ]
    check "$1: builds nothing" not called mvn
}

rm "$sandbox/bin/java"
cga render
refuses 'no Java'
check 'no Java: what to type' said 'there is no Java: type: sudo apt-get install -y --no-install-recommends openjdk-17-jdk-headless'

echo openjdk-17-jdk-headless >"$sandbox/home/unknown-packages"
cga render
check 'a Debian without 17 has 21' said 'openjdk-21-jdk-headless'

echo 0 >"$sandbox/uid"
cga test
refuses 'no Java for the tests'
check 'root needs no sudo' said 'type: apt-get install'

rm "$sandbox/bin/apt-get"
cga render
check 'elsewhere there is another cure' said 'install a JDK 17 or newer with your package manager'

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
check 'a shim on the PATH is asked where its JDK is' argument "-XX:SharedArchiveFile=$checkout/build/cga/java-21.0.2.jsa"
