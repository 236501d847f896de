# shellcheck shell=sh
# What a run of the tests came to, by the reports that Maven and Gradle leave.

# summarize_tests FOLDER...: reads the reports TEST-*.xml in these folders and prints the ten slowest test classes, why tests were skipped,
# which failed and where to read more, and last the line `N passed, N failed, N skipped`. It fails where a test failed or none ran.
summarize_tests() {
    for reports; do
        shift
        for report in "$reports"/TEST-*.xml; do [ ! -r "$report" ] || set -- "$@" "$report"; done
    done
    [ $# != 0 ] || { echo 'no test ran' && return 1; }
    awk "$tests_summary" "$@"
}

# Both write each element on a line of its own; what a test printed and stack traces are in CDATA, of any number of lines.
# shellcheck disable=SC2016 # the dollars are awk's
tests_summary='
    function attribute(name,    start, value) {
        start = index($0, " " name "=\"")
        if (!start) return ""
        value = substr($0, start + length(name) + 3)
        return text(substr(value, 1, index(value, "\"") - 1))
    }
    function text(value) {
        gsub(/&#10;|&#xa;/, " ", value)
        gsub(/&quot;/, "\"", value)
        gsub(/&apos;|&#39;/, "\047", value)
        gsub(/&lt;/, "<", value)
        gsub(/&gt;/, ">", value)
        gsub(/&amp;/, "\\&", value)
        return value
    }
    # In an attribute, or behind the name of the exception in the first line of its stack trace.
    function message(    value) {
        value = attribute("message")
        if (value == "" && index($0, "<![CDATA[")) {
            value = substr($0, index($0, "<![CDATA[") + 9)
            sub(/\]\]>.*/, "", value)
            sub(/^[A-Za-z0-9.$]*: /, "", value)
        }
        sub(/^Assumption failed: /, "", value)
        return value
    }
    FNR == 1 { inside = 0 }
    !inside && /<testsuite / { seconds = attribute("time"); gsub(/,/, "", seconds); classes[attribute("name")] += seconds }
    !inside && /<testcase / { tests++; test = attribute("classname") "#" attribute("name") }
    !inside && /<skipped/ { skipped++; why = message(); reasons[why == "" ? "no reason given" : why]++ }
    !inside && /<(failure|error)[ >]/ {
        failed++
        failures = failures "failed: " test ": " substr(message(), 1, 200) "\n        " FILENAME "\n"
    }
    /<!\[CDATA\[/ { inside = 1 }
    inside && /\]\]>/ { inside = 0 }
    END {
        print "the slowest test classes:"
        system("") # writes that before what sort writes
        sorted = "sort -rn | head -n 10"
        for (name in classes) printf "%7.1f s  %s\n", classes[name], name | sorted
        close(sorted)
        for (why in reasons) printf "skipped: %s (%d)\n", why, reasons[why]
        printf "%s", failures
        printf "%d passed, %d failed, %d skipped\n", tests - failed - skipped, failed, skipped
        exit failed || !tests
    }
'
