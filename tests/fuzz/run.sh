#!/bin/sh
# Throws random bytes at what reads files of unknown origin, and minimises the corpus that is kept beside this script:
#   tests/fuzz/run.sh png|exr|compare|archive|tree|source [RUNS]
# The first three are pictures; the others are what is handed in to the grader.
# It ends at the first input that breaks the contract and keeps it in build/fuzz; put it into the corpus together with the cure.
# Jazzer (https://github.com/CodeIntelligenceTesting/jazzer) comes from Maven Central; the tests do without it.
set -eu
cd "$(dirname "$0")/../.."
part=pictures package=cga.imaging
case ${1-} in
    png) class=PngFuzz ;;
    exr) class=ExrFuzz ;;
    compare) class=CompareFuzz ;;
    archive) class=ArchiveFuzz part=grader ;;
    tree) class=TreeFuzz part=grader ;;
    source) class=SourceFuzz part=grader ;;
    *) sed -n '2,4s/^# *//p' "$0" && exit 2 ;;
esac
[ $part = pictures ] || package=cga.grading.submission
runs=${2:-200000}
corpus=$PWD/tests/fuzz/$1
work=$PWD/build/fuzz
mkdir -p "$work/$1" "$corpus"

mvn -q -B -pl src/$part -am test-compile dependency:build-classpath -Dmdep.skip=false -DincludeScope=test -Dmdep.outputFile="$work/classpath"
for jar in jazzer jazzer-api; do
    mvn -q -B -N dependency:copy -Dmdep.skip=false -Dartifact=com.code-intelligence:$jar:0.30.0 -DoutputDirectory="$work"
done

jazzer() {
    java -Xmx512m -Dcga.home="$PWD" \
        -cp "$work/jazzer-0.30.0.jar:$work/jazzer-api-0.30.0.jar:target/$part/test-classes:target/$part/classes:$(cat "$work/classpath")" \
        com.code_intelligence.jazzer.Jazzer --target_class="$package.$class" \
        --instrumentation_includes="$package.**" --reproducer_path="$work" -artifact_prefix="$work/" "$@"
}

# Five seconds on one input are a hang: others take some milliseconds at most.
jazzer -runs="$runs" -timeout=5 -max_len=2048 "$work/$1" "$corpus"
# What is kept covers what all that was found covers, with the fewest and smallest inputs.
rm -rf "$work/$1.merged" && mkdir "$work/$1.merged"
jazzer -merge=1 "$work/$1.merged" "$corpus" "$work/$1"
rm -rf "$corpus" && mv "$work/$1.merged" "$corpus"
