# shellcheck shell=sh
# Building: only the parts that a command needs, and only when their sources changed.

# The part whose classes a command starts.
part_of() {
    case $1 in
        grade | starter | gradescope) echo grader ;;
        golden | bench | accuracy | soak) echo lab ;;
        *) echo window ;;
    esac
}

# The parts that make up a part, itself the last, as the build files name them.
parts_below() {
    cd "$home/src" && awk -v part="$1" '
        function list(name,    count, i, names) {
            if (listed[name]++) return
            count = split(uses[name], names, " ")
            for (i = 1; i <= count; i++) list(names[i])
            print name
        }
        FNR == 1 { split(FILENAME, folders, "/"); name = folders[2] }
        /^ *(api|implementation)\(project\(":[a-z]+"\)\)/ { split($0, quoted, "\""); uses[name] = uses[name] " " substr(quoted[2], 2) }
        END { list(part) }' ./*/build.gradle.kts
}

# The stamp holds the fingerprint of the sources that the part was built from.
ensure_built() {
    part=$(part_of "$command")
    stamp=$build/$part.stamp
    is_current && return
    { mkdir -p "$build" 2>/dev/null && [ -w "$build" ]; } || die "cannot write to $build, where the program is built"
    trap unlock EXIT
    trap 'exit 130' HUP INT TERM
    lock
    is_current || build_part
    unlock
}

# Whether a command can start without a build tool.
is_built() { [ "$1" != test ] && [ "$1" != corpus ] && [ -e "$build/$(part_of "$1").stamp" ]; }

is_current() {
    sources=$(fingerprint)
    [ -d "$build/lib" ] && [ "$sources" = "$(cat "$stamp" 2>/dev/null)" ]
}

# Contents, not times: a touch or a moved clone changes nothing; a deleted, a renamed or an older file does.
fingerprint() {
    # shellcheck disable=SC2046 # a list of folders
    cd "$home" && { checksums $(parts_below "$part" | sed 's|[a-z]*|src/&|g') && build_files; } | cksum
}

build_files() { checksums pom.xml build.gradle.kts settings.gradle.kts gradle/libs.versions.toml; }

checksums() { find "$@" -type f ! -name '.*' ! -name '*~' -exec cksum {} + 2>/dev/null | sort; }

# Only one launcher can make the symbolic link, which names it. Who finds its owner dead removes it and takes a breath
# before he tries, so that all who saw the same dead owner have removed it by then, and nobody removes a new one.
lock() {
    [ ! -h "$build/lock" ] || say "waiting for another ./cga that is building"
    until ln -s $$ "$build/lock" 2>/dev/null; do
        owner=$(readlink "$build/lock") && ! kill -0 "$owner" 2>/dev/null && rm -f "$build/lock"
        sleep 1
    done
}

unlock() { [ "$(readlink "$build/lock")" != $$ ] || rm -f "$build/lock"; }

build_part() {
    find_build_tool
    why='the last build did not finish'
    [ -e "$build/$part.log" ] || why='first use'
    [ ! -e "$stamp" ] || why='sources changed'
    log=$build/$part.log
    say "building with $tool ($why); its log is $log"
    remove_outdated
    if [ "$tool" = Gradle ]; then set -- "$gradle" --console=plain ":$part:installCga"
    else
        # In Maven itself at first, which takes less of the processor; a daemon, which stays for ten minutes, makes the next edits quick.
        daemon=true
        [ "$why" = 'sources changed' ] || daemon=false
        # The libraries are there already unless the build files changed; `package` copies them.
        phase=prepare-package
        [ -e "$build/$part.classpath" ] || phase=package
        # Cleaning would take the other parts' jars along.
        set -- mvn -B -DwithoutTests -Dmaven.test.skip=true -Dmaven.clean.skip=true "-Dkotlin.compiler.daemon=$daemon" \
            -Dkotlin.compiler.daemon.shutdownDelayMs=600000 -Dkotlin.compiler.incremental=true -pl "src/$part" -am $phase
    fi
    [ "$tool" = Gradle ] || begin_incremental
    run_build "$@"
    [ "$tool" = Gradle ] || ! forget_outdated || run_build "$@"
    list_classpath
    echo "$sources" >"$stamp"
}

# run_build COMMAND...: runs it in the checkout, with its log in $log; the launcher ends where it fails. Its last line need not have an end.
run_build() {
    { (cd "$home" && "$@" 2>&1 </dev/null) || printf '\n%s\n' 'the build failed'; } | tee "$log" | show_progress
    ! grep -q -x 'the build failed' "$log" || build_failed
}

# Our jars are made anew, so that a program that still runs keeps its own, and the models are cooked by the new classes. Another version of a
# library, or one less, is found in the build files: then all jars go, and the archives of their classes.
remove_outdated() {
    rm -rf "$stamp" "$build/cooked"
    for name in $(parts_below "$part"); do rm -f "$build/lib/cga-$name.jar"; done
    libraries=$(cd "$home" && { build_files && checksums src/*/pom.xml src/*/build.gradle.kts; } | cksum)
    [ "$libraries" != "$(cat "$build/libraries" 2>/dev/null)" ] || return 0
    rm -rf "${build:?}/lib" "$build"/*.stamp "$build"/*.jsa "$build"/*.classpath
    echo "$libraries" >"$build/libraries"
}

# What the build tool tells, one line a step, as it comes: mawk, which is Debian's awk, waits for 4 KiB unless it is interactive.
show_progress() {
    interactive=''
    ! awk -W version 2>&1 </dev/null | grep -q mawk || interactive='-W interactive'
    # shellcheck disable=SC2086 # two words or none
    awk $interactive '
        function say(text) { print "cga:   " text > "/dev/stderr" }
        /^Downloading from/ && downloads++ % 100 == 0 { say(downloads == 1 ? "downloading libraries" : downloads " files downloaded") }
        /^\[INFO\] Building .*\[[0-9]+\/[0-9]+\]/ && $3 != "cga-lights" { step = $NF; gsub(/[][]/, "", step); split(step, of, "/")
            place[$3] = $3 " (" of[1] - 1 " of " of[2] - 1 ")" }
        /--- (kotlin-maven-plugin|kotlin):.*:compile / && $(NF - 1) in place { say("compiling " place[$(NF - 1)]) }
        /T E S T S/ { say("testing") }
        /^\[INFO\] Running / && ++classes % 25 == 0 { say(classes " test classes started") }
        /^corpus: / { say(substr($0, 9)) }
        /^> Task :[a-z]+:(compileKotlin|test)$/ { split($3, of, ":"); say((of[3] == "test" ? "testing " : "compiling ") of[2]) }'
}

# The libraries come first and in one order: an archive of their classes stays good whatever becomes of ours. Native code is that of this
# machine.
list_classpath() {
    case $(uname -sm) in
        'Darwin arm64') natives=macos-arm64 ;;
        Darwin*) natives=macos ;;
        *aarch64) natives=linux-arm64 ;;
        *) natives=linux ;;
    esac
    for jar in "$build/lib"/*.jar; do
        case ${jar##*/} in *-natives-"$natives".jar) ;; cga-* | *-natives-*) continue ;; esac
        echo "${jar##*/}"
    done >"$build/$part.classpath"
    for name in $(parts_below "$part"); do echo "cga-$name.jar"; done >>"$build/$part.classpath"
}

build_failed() {
    # The compiler's lines, each once, without what Maven says of itself; where there are none, the step that failed.
    awk '/^(e: |\[ERROR\] .|[*>] What)/ && !/\] \[Help|e-run Maven|For more information|mvn <args>|After correcting/ {
            sub(/ -> \[Help [0-9]+\]$/, "")
            if (/Failed to execute goal/) step = $0
            else if (!seen[$0]++) { print; said = 1 }
        }
        END { if (!said && step != "") print step }' "$log" | head -n 20 >&2
    die "the build failed; all that $tool said: $log"
}

# Gradle where it is at hand, unless CGA_BUILD is `maven`.
find_build_tool() {
    if [ "${CGA_BUILD-}" != maven ] && find_gradle; then tool=Gradle
    elif has mvn; then tool=Maven
    else die 'neither Gradle nor Maven is here to build it: install Maven, or let ./gradlew download Gradle'; fi
}

# The wrapper where its Gradle has been downloaded already, for a download may hang; else a gradle that knows this JDK.
find_gradle() {
    name=$(sed -n 's|^distributionUrl=.*/\(.*\)\.zip$|\1|p' "$home/gradle/wrapper/gradle-wrapper.properties" 2>/dev/null)
    gradle=$home/gradlew
    for ok in "${GRADLE_USER_HOME:-${HOME-}/.gradle}/wrapper/dists/$name"/*/"$name.zip.ok"; do
        [ -e "$ok" ] && return
    done
    gradle=gradle
    has gradle || return
    oldest=8
    [ "${java_major:-17}" -lt 24 ] || oldest=9
    gradle_major=$(gradle --version 2>/dev/null </dev/null | sed -n 's/^Gradle \([0-9]*\).*/\1/p')
    [ "${gradle_major:-0}" -ge $oldest ]
}
