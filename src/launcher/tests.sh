# shellcheck shell=sh
# Running the tests.

run_tests() {
    fast='' pattern=''
    while [ $# -gt 0 ]; do
        case $1 in
            --fast) fast=true ;;
            --tests=?*) pattern=${1#*=} ;;
            --tests) [ $# -gt 1 ] || die 'test --tests needs a PATTERN'; pattern=$2; shift ;;
            *) die "test takes --fast and --tests PATTERN, not '$1'" ;;
        esac
        shift
    done
    find_build_tool
    mkdir -p "$build"
    log=$build/test.log
    say "testing with $tool; its log is $log"
    export LIBGL_ALWAYS_SOFTWARE=1
    cd "$home" || exit 2
    if [ "$tool" = Gradle ]; then
        set -- "$gradle" --console=plain --continue test ${fast:+-Pfast} ${pattern:+--tests "$pattern"}
    else
        # Maven writes Class#method where Gradle writes Class.method.
        set -- mvn -B -ntp --fail-at-end test ${fast:+-Dfast} \
            ${pattern:+"-Dtest=$(echo "$pattern" | sed 's/\([A-Z][A-Za-z0-9_]*\)\.\([a-z]\)/\1#\2/')" -Dsurefire.failIfNoSpecifiedTests=false}
    fi
    "$@" >"$log" 2>&1 </dev/null
    exit $?
}
