#!/bin/sh
# What ./cga test says at the end, of reports as Maven and Gradle write them.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd -P)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# shellcheck source=../../src/launcher/tests-summary.sh
. "$root/src/launcher/tests-summary.sh"

# summary FOLDER...: keeps what is printed, and the status.
summary() {
    status=0
    summarize_tests "$@" >"$folder/out" || status=$?
}

# check WHAT COMMAND...: fails the test unless the command succeeds.
check() {
    what=$1 && shift
    "$@" || { echo "FAILED: $what" && cat "$folder/out" && exit 1; } >&2
}

printed() { grep -q -x -F -e "$1" "$folder/out"; }
last() { [ "$(tail -n 1 "$folder/out")" = "$1" ]; }

mkdir "$folder/maven" "$folder/gradle" "$folder/empty"
cat >"$folder/maven/TEST-a.OneTest.xml" <<'END'
<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="a.OneTest" time="1,002.5" tests="4" errors="1" skipped="2" failures="0">
  <testcase name="it&apos;s &lt;good&gt;" classname="a.OneTest" time="2.5">
    <system-out><![CDATA[printed
<testcase name="none" classname="a.OneTest"/>
]]></system-out>
  </testcase>
  <testcase name="one" classname="a.OneTest" time="0.0">
    <skipped type="org.opentest4j.TestAbortedException"><![CDATA[org.opentest4j.TestAbortedException: Assumption failed: root: writes anywhere
	at a.OneTest.one(OneTest.kt:4)
]]></skipped>
  </testcase>
  <testcase name="two" classname="a.OneTest" time="0.0">
    <skipped type="org.opentest4j.TestAbortedException"><![CDATA[org.opentest4j.TestAbortedException: root: writes anywhere
]]></skipped>
  </testcase>
  <testcase name="three" classname="a.OneTest" time="1,000">
    <error message="no &amp;quot;" type="java.io.IOException"><![CDATA[java.io.IOException: no
<failure/>]]></error>
  </testcase>
</testsuite>
END
cat >"$folder/gradle/TEST-b.TwoTest.xml" <<'END'
<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="b.TwoTest" tests="2" skipped="1" failures="0" errors="0" time="0.039">
  <testcase name="adds()" classname="b.TwoTest" time="0.039"/>
  <testcase name="skips()" classname="b.TwoTest" time="0.0">
    <skipped/>
  </testcase>
  <system-out><![CDATA[]]></system-out>
</testsuite>
END

summary "$folder/maven" "$folder/gradle"
check 'the last line is the count' last '2 passed, 1 failed, 3 skipped'
check 'a failure is its exit code' [ $status = 1 ]
check 'what failed is named' printed 'failed: a.OneTest#three: no &quot;'
check 'and where to read more' printed "        $folder/maven/TEST-a.OneTest.xml"
check 'a reason is told once' printed 'skipped: root: writes anywhere (2)'
check 'as is that there is none' printed 'skipped: no reason given (1)'
check 'the slowest class comes first' [ "$(sed -n 2p "$folder/out")" = ' 1002.5 s  a.OneTest' ]

summary "$folder/gradle"
check 'where nothing failed it ends with 0' [ $status = 0 ]
check 'and says so' last '1 passed, 0 failed, 1 skipped'

summary "$folder/empty" "$folder/none"
check 'no report is a failure' [ $status = 1 ]
