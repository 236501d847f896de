#!/bin/sh
# Which parts are compiled anew when another's interface changes, and that its bodies do not count.
. "$(dirname "$0")/sandbox.sh"
javac=$(readlink -f "$(command -v javac)")
JAVA_HOME=${javac%/bin/javac}
home=$checkout build=$checkout/build/cga
# shellcheck source=src/launcher/incremental.sh
. "$root/src/launcher/incremental.sh"
mkdir -p "$build"
for name in scene cli grader; do
    echo "<module>src/$name</module>" >>"$home/pom.xml"
    mkdir -p "$home/src/$name/kotlin"
done

# compiled SOURCE: the part cli with this class, and all parts as if they had just been compiled.
compiled() {
    for name in scene cli grader; do mkdir -p "$home/target/$name/classes" "$home/target/$name/kotlin-ic/compile" "$home/target/$name/kotlin-ic/test"; done
    echo "$1" >"$sandbox/A.java"
    "$javac" -d "$home/target/cli/classes" "$sandbox/A.java"
}
forgotten() { [ ! -e "$home/target/$1/kotlin-ic/$2" ]; }
all_known() { for part in scene cli grader; do ! forgotten $part compile && ! forgotten $part test || return 1; done; }
changed() { forget_outdated; }
unchanged() { ! forget_outdated; }

compiled 'public class A { public int f() { return 1; } }'
check 'what was never compiled before is not outdated' unchanged
check 'and nothing is forgotten' all_known

compiled 'public class A { public int f() { return new Object() { int two = 2; }.two; } private void g() { } }'
check 'bodies, private members and classes in functions do not count' unchanged
check 'and nothing is forgotten then' all_known

compiled 'public class A { public int f(int x) { return x; } }'
check 'a parameter does' changed
check 'the parts above are compiled anew' forgotten grader compile
check 'and the tests of the part itself' forgotten cli test
check 'but not the part' [ -e "$home/target/cli/kotlin-ic/compile" ]
check 'nor what is below' [ -e "$home/target/scene/kotlin-ic/test" ]

compiled 'public class A { public static final int C = 1; public int f(int x) { return x; } }'
check 'a constant does' changed
compiled 'public class A { public static final int C = 2; public int f(int x) { return x; } }'
check 'and its value' changed
compiled 'public class A { public static final int C = 2; public int f(int x) { return x; } }'
check 'the same once more is no change' unchanged

echo 'inline fun f() = 1' >"$home/src/scene/kotlin/F.kt"
check 'a new inline function does' changed
echo 'inline fun f() = 2' >"$home/src/scene/kotlin/F.kt"
compiled 'public class A { public static final int C = 2; public int f(int x) { return x; } }'
check 'and its body' changed
check 'for all above' forgotten cli compile

rm "$build/interfaces"
compiled 'public class A { }'
begin_incremental
check 'where no interface is known all is compiled anew' forgotten scene compile
