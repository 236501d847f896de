# shellcheck shell=sh
# Kotlin under Maven compiles a part's changed files only, and does not see that another part, or the part under its tests, has a new interface.

# Without a record of the interfaces nothing is known of what was compiled against them.
begin_incremental() { [ -e "$build/interfaces" ] || rm -rf "$home"/target/*/kotlin-ic; }

# Records the interfaces, and succeeds where a part's has changed: then whatever was compiled against the old one has been forgotten, and the
# next build compiles it anew.
forget_outdated() {
    # In Maven's order: each may use those before it.
    names=$(sed -n 's|.*<module>.*/\(.*\)</module>.*|\1|p' "$home/pom.xml")
    ls -d "$home"/target/*/classes >/dev/null 2>&1 && (read_interfaces) >"$build/interfaces.$$" || return 1
    outdated=''
    for name in $names; do
        [ -z "$outdated" ] || rm -rf "$home/target/$name/kotlin-ic"
        before=$(interface_of "$name" "$build/interfaces")
        if [ -n "$before" ] && [ "$before" != "$(interface_of "$name" "$build/interfaces.$$")" ]; then
            rm -rf "$home/target/$name/kotlin-ic/test"
            outdated=yes
        fi
    done
    mv -f "$build/interfaces.$$" "$build/interfaces"
    [ -n "$outdated" ]
}

# A line of the classes' interfaces for each part, and one of the sources that have inline functions, whose bodies belong to them.
read_interfaces() {
    if [ ! -e "$build/abi/Abi.class" ] || [ "$home/src/launcher/Abi.java" -nt "$build/abi/Abi.class" ]; then
        "$JAVA_HOME/bin/javac" --release 17 -d "$build/abi" "$home/src/launcher/Abi.java" || return 1
    fi
    cd "$home" && "$JAVA_HOME/bin/java" -XX:TieredStopAtLevel=1 -XX:+UseSerialGC -cp "$build/abi" Abi target/*/classes || return 1
    for name in $names; do
        [ ! -d "src/$name/kotlin" ] ||
            echo "inline/$name $(find "src/$name/kotlin" -name '*.kt' -exec grep -l -w inline {} + | sort | xargs cat | cksum)"
    done
}

interface_of() { grep -E "^(target/$1/classes|inline/$1) " "$2" 2>/dev/null; }
