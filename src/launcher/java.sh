# shellcheck shell=sh
# The JDK.

has_java() { [ -n "${JAVA_HOME-}" ] || has java; }

# Sets JAVA_HOME, java_version and java_major: the JDK of JAVA_HOME, else the one that the java on the PATH belongs to.
find_jdk() {
    cure='install a JDK 17 or newer, or set JAVA_HOME to one'
    if [ -z "${JAVA_HOME-}" ]; then
        has java || die "there is no Java: $cure"
        java=$(readlink -f "$(command -v java)")
        JAVA_HOME=${java%/bin/java}
        # A shim, as macOS and version managers have it, lies outside its JDK; Java itself knows.
        [ -r "$JAVA_HOME/release" ] ||
            JAVA_HOME=$(java -XshowSettings:properties -version 2>&1 | sed -n 's/^ *java\.home = //p')
    fi
    export JAVA_HOME
    java_version=$(sed -n 's/^JAVA_VERSION="\(.*\)"/\1/p' "$JAVA_HOME/release" 2>/dev/null)
    java_major=${java_version%%[!0-9]*}
    [ -n "$java_major" ] || die "there is no JDK in '$JAVA_HOME': correct JAVA_HOME, or $cure"
    [ "$java_major" -ge 17 ] || die "Java $java_version in $JAVA_HOME is too old: $cure"
    [ -x "$JAVA_HOME/bin/javac" ] || die "Java in $JAVA_HOME is without a compiler: $cure"
}
