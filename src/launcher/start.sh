# shellcheck shell=sh
# Starting the program.

start() {
    classpath
    set -- -cp "$classpath" cga.cli.MainKt "$@"
    set -- "-Dcga.home=$home" "-Dcga.cooked=$build/cooked" "-Dcga.natives=$build/natives" -Djava.awt.headless=true "$@"
    # Started for one picture: no optimising compiler, loops compiled early, and a heap in which that is made without a collection. A grader leaves the work and the
    # processor to others.
    case $command in render | doctor | grade) set -- -XX:+UseSerialGC -XX:TieredStopAtLevel=1 -XX:Tier3BackEdgeThreshold=3000 -Xms128m -Xmn96m "$@" ;; esac
    # The whole heap is there from the start: what grows then is a leak, and no heap that fills.
    case $command\ $* in soak\ *--window*) set -- -XX:+UseSerialGC -XX:TieredStopAtLevel=1 -Xms256m -Xmx256m -XX:+AlwaysPreTouch "$@" ;; esac
    [ "$java_major" -lt 24 ] || set -- --enable-native-access=ALL-UNNAMED --sun-misc-unsafe-memory-access=allow "$@"
    # On macOS windows, hidden ones too, belong to the first thread.
    [ "$(uname)" != Darwin ] || set -- -XstartOnFirstThread "$@"
    find_archive
    [ ! -s "$archive" ] || set -- -Xlog:disable "-XX:SharedArchiveFile=$archive" "$@"
    exec "$JAVA_HOME/bin/java" "-Xbootclasspath/a:$stdlib" "$@"
}

# Sets classpath, as the build listed it, and libraries, the first of it, which are not ours. Kotlin's library is also the JDK's own neighbour:
# looking for kotlin-reflect, which is not there, it then does not have the JVM open every jar.
classpath() {
    classpath='' libraries='' stdlib=''
    while read -r jar; do
        classpath=$classpath${classpath:+:}$build/lib/$jar
        case $jar in cga-*) ;; *) libraries=$classpath ;; esac
        case $jar in kotlin-stdlib-[0-9]*) stdlib=$build/lib/$jar ;; esac
    done <"$build/$part.classpath"
}

# Sets archive to one of the classes that a small render loads, parsed and verified once for this JDK: later starts map it. One has all of
# them, another only the libraries', for the time after an edit. Neither is made for the first start after a build: nobody waits for them
# between an edit and its picture.
find_archive() {
    archive=$build/$part-$java_version.jsa
    of_libraries=$build/$part-libraries-$java_version.jsa
    if [ -e "$build/$part.started" ] && [ ! "$stamp" -nt "$build/$part.started" ]; then
        [ -e "$of_libraries" ] || make_archive "$of_libraries" "$libraries"
        [ "$archive" -nt "$stamp" ] || make_archive "$archive" "$classpath"
    else
        : >"$build/$part.started"
    fi
    [ "$archive" -nt "$stamp" ] || archive=$of_libraries
}

# make_archive FILE CLASSPATH: a render before it cooks the models, so that loading those is what it shows. In one step it would leave out
# JOML's classes, which are old. A failure leaves an empty file: then every start is a little slower, and none tries again.
make_archive() {
    classes=$build/classes.$$
    warm_up -Xlog:disable
    warm_up "-XX:DumpLoadedClassList=$classes"
    "$JAVA_HOME/bin/java" -Xshare:dump "-XX:SharedArchiveFile=$1.$$" "-XX:SharedClassListFile=$classes" \
        "-Xbootclasspath/a:$stdlib" -cp "$2" >/dev/null 2>&1 </dev/null
    rm -f "$classes"
    [ -e "$1.$$" ] || : >"$1.$$"
    mv -f "$1.$$" "$1"
}

warm_up() {
    "$JAVA_HOME/bin/java" "$@" "-Xbootclasspath/a:$stdlib" "-Dcga.home=$home" "-Dcga.cooked=$build/cooked" "-Dcga.natives=$build/natives" \
        -Djava.awt.headless=true -cp "$classpath" cga.cli.MainKt render --size 64x36 --out "$build/warm-up.png" >/dev/null 2>&1 </dev/null
}
