#!/bin/sh
# What a build that fails, is interrupted or is not alone leaves behind.
. "$(dirname "$0")/sandbox.sh"
stamp="$checkout/build/cga/window.stamp"
builder=$(cat "$sandbox/bin/mvn")

cga render
stub mvn <<'END'
mkdir -p build/cga/lib
echo '[ERROR] Main.kt: (1, 5) Unresolved reference: mian'
echo '[ERROR] Main.kt: (1, 5) Unresolved reference: mian'
echo '[ERROR] [Help 1] a page about nothing'
printf 'no end of a line'
exit 1
END
echo 'fun mian' >"$scene/Main.kt"
cga render
check 'a failing build ends with 2' ended 2
check 'it shows the error' said '(1, 5) Unresolved reference: mian'
check 'once' [ "$(grep -c Unresolved "$sandbox/err")" = 1 ]
check 'without the tool talking about itself' not said 'Help 1'
check 'it names the log' said "$checkout/build/cga/window.log"
check 'the program is not started' not called java
check 'no stamp is left' [ ! -e "$stamp" ]
cga render
check 'the next start tries again' called mvn
check 'and says why' said 'the last build did not finish'

echo "$builder" >"$sandbox/bin/mvn"
cga render
check 'and is well once the source is' called java

# What a terminal does on Ctrl-C: the launcher and the build tool get the signal alike.
stub mvn <<END
mkdir -p build/cga/lib && echo \$\$ >"$sandbox/building" && exec sleep 20
END
echo '// changed' >>"$scene/Main.kt"
: >"$calls"
env -i HOME="$sandbox/home" PATH="$sandbox/bin" "$checkout/cga" render >"$sandbox/out" 2>"$sandbox/err" &
while [ ! -s "$sandbox/building" ]; do sleep 0.1; done
kill -TERM $! "$(cat "$sandbox/building")"
status=0
wait $! || status=$?
check 'an interrupted build ends with 130' ended 130
check 'an interrupted build leaves no stamp' [ ! -e "$stamp" ]
check 'nor a lock' [ ! -h "$checkout/build/cga/lock" ]
check 'nor does it start the program' not called java

{ echo "$builder" && echo 'sleep 2'; } >"$sandbox/bin/mvn"
: >"$calls"
env -i HOME="$sandbox/home" PATH="$sandbox/bin" "$checkout/cga" render >"$sandbox/first" 2>&1 &
while [ ! -h "$checkout/build/cga/lock" ]; do sleep 0.1; done
env -i HOME="$sandbox/home" PATH="$sandbox/bin" "$checkout/cga" render >"$sandbox/second" 2>&1 &
wait
check 'of two launchers one builds' [ "$(grep -c ^mvn "$calls")" = 1 ]
check 'the other says that it waits' grep -q 'waiting for another ./cga' "$sandbox/first" "$sandbox/second"
check 'and both start the program' [ "$(grep -c ^java "$calls")" = 2 ]

echo "$builder" >"$sandbox/bin/mvn"
sh -c 'exit' &
wait $!
ln -s $! "$checkout/build/cga/lock"
echo '// changed' >>"$scene/Main.kt"
cga render
check 'the lock of a launcher that was killed holds nobody up' called java
