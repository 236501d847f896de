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
        reports=test-results/test
        set -- "$gradle" --console=plain --continue test ${fast:+-Pcga.tests=fast} ${pattern:+--tests "$pattern"}
    else
        reports=surefire-reports
        # Maven writes Class#method where Gradle writes Class.method.
        set -- mvn -B -T2 -Dkotlin.compiler.incremental=true -Dmaven.test.failure.ignore=true -Dcga.tests.together test \
            ${fast:+-Dcga.tests=fast} \
            ${pattern:+-Dsurefire.failIfNoSpecifiedTests=false} \
            ${pattern:+"-Dtest=$(echo "$pattern" | sed 's/\([A-Z][A-Za-z0-9_]*\)\.\([a-z]\)/\1#\2/')"}
    fi
    [ "$tool" = Gradle ] || compile_tests
    rm -rf target/*/"$reports" build/*/"$reports"
    { "$@" 2>&1 </dev/null || printf '\n%s\n' 'the build failed'; } | tee "$log" | show_progress
    [ "$tool" = Gradle ] || forget_outdated || :
    # shellcheck source=src/launcher/tests-summary.sh
    . "$home/src/launcher/tests-summary.sh"
    summarize_tests target/*/"$reports" build/*/"$reports"
    passed=$?
    # Where no test failed and the build did, it is the compiler that has something to say. For Maven failed tests are no failure.
    if [ $passed = 0 ] || [ "$tool" = Maven ] || ! has_reports; then ! grep -q -x 'the build failed' "$log" || build_failed; fi
    exit $passed
}

has_reports() {
    for report in target/*/"$reports"/*.xml build/*/"$reports"/*.xml; do [ ! -e "$report" ] || return 0; done
    return 1
}

# What was compiled against an interface that has changed since must not be tested. On a fresh clone there is nothing of the kind.
compile_tests() {
    begin_incremental
    ls -d target/*/kotlin-ic >/dev/null 2>&1 || return 0
    run_build mvn -B -T2 -Dkotlin.compiler.incremental=true test-compile
    forget_outdated || :
}

# The grader's guard, which is a test: what it judges is told by variables. Its report is written into build/corpus.
judge_corpus() {
    CGA_CORPUS='' CGA_CORPUS_ACCEPT=''
    while [ $# -gt 0 ]; do
        case $1 in
            --all) CGA_CORPUS=all ;;
            --part) [ $# -gt 1 ] || die 'corpus --part needs I/N'; CGA_CORPUS=$2; shift ;;
            --accept) CGA_CORPUS_ACCEPT=true ;;
            -*) die "corpus takes --all, --part I/N, --accept and names of submissions, not '$1'" ;;
            *) CGA_CORPUS="$CGA_CORPUS${CGA_CORPUS:+ }$1" ;;
        esac
        shift
    done
    : "${CGA_CORPUS:=guard}"
    export CGA_CORPUS CGA_CORPUS_ACCEPT
    report=$home/build/corpus/report.md
    rm -f "$report"
    (run_tests --tests '*CorpusGuardTest') >&2
    ended=$?
    [ ! -e "$report" ] || cat "$report"
    exit $ended
}
