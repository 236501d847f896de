package cga.grading.sandbox

import cga.testing.Slow
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.UUID

/** Each way of using too much, and how it is reported. */
@Slow
class LimitsTest {
    private val hostile = Hostile()

    @AfterEach
    fun close() = hostile.close()

    @Test
    fun `an endless loop runs out of CPU time`() = assertExceeded(Limit.CPU, hostile.java("while (true) { }", Limits(cpuSeconds = 0.6)))

    @Test
    fun `a job that sleeps runs out of time`() = assertExceeded(Limit.WALL_CLOCK, hostile.shell("sleep 100", Limits(wallSeconds = 0.3)))

    @Test
    fun `time is counted over all processes`() {
        val twoLoops = "sh -c 'while :; do :; done' & sh -c 'while :; do :; done' & wait"
        val outcome = hostile.shell(twoLoops, Limits(cpuSeconds = 1.0))
        assertExceeded(Limit.CPU, outcome)
        assertTrue(outcome.cpuSeconds > 1.0) { "${outcome.cpuSeconds}" }
    }

    @Test
    fun `System exit is an exit with its code`() = assertEquals(End.Exited(42), hostile.java("System.exit(42);").end)

    @Test
    fun `a native crash is a signal`() {
        val crash =
            "var f = Class.forName(\"sun.misc.Unsafe\").getDeclaredField(\"theUnsafe\"); f.setAccessible(true);" +
                "((sun.misc.Unsafe) f.get(null)).putAddress(0, 0);"
        assertEquals(End.Signalled(6), hostile.java(crash).end)
        assertEquals(End.Signalled(11), hostile.shell("kill -SEGV \$\$").end)
    }

    @Test
    fun `a fork bomb is stopped, and nothing of it survives`() {
        val marker = UUID.randomUUID().toString()
        val bomb = "f() { sh -c \"sleep 1000; : $marker\" & f | f & }; f; sleep 1000"
        val outcome = hostile.shell(bomb, Limits(wallSeconds = 10.0, tasks = 60))
        assertExceeded(Limit.PROCESSES, outcome)
        assertFalse(Hostile.isAlive(marker))
    }

    @Test
    fun `a thread bomb is stopped`() {
        val bomb =
            "while (true) try { new Thread(() -> { try { Thread.sleep(100000); } catch (Exception e) { } }).start(); }" +
                "catch (Throwable e) { Thread.sleep(100); }"
        assertExceeded(Limit.PROCESSES, hostile.java(bomb, Limits(tasks = 100)))
    }

    @Test
    fun `ten gigabytes of output are neither kept nor waited for`() {
        val limits = Limits(outputBytes = 1_000_000, keptBytes = 1000)
        for (redirection in listOf("", " >&2")) {
            val outcome = hostile.shell("exec head -c 10000000000 /dev/zero$redirection", limits)
            assertExceeded(Limit.OUTPUT, outcome)
            assertEquals(1000, outcome.output.length + outcome.errors.length)
        }
    }

    @Test
    fun `a file of ten gigabytes does not get that far`() {
        val limits = Limits(diskBytes = 4_000_000)
        assertExceeded(Limit.DISK, hostile.shell("head -c 10000000000 /dev/zero > big", limits))
        assertTrue(hostile.scratch.resolve("big").toFile().length() < 40_000_000)
    }

    @Test
    fun `a job that writes too much and ends at once is found out`() =
        assertExceeded(Limit.DISK, hostile.shell("head -c 3000000 /dev/zero > a; cp a b", Limits(diskBytes = 4_000_000)))

    @Test
    fun `deleted files that are still open count`() {
        val hidden = "exec 3>a; rm a; head -c 3000000 /dev/zero >&3; exec 4>b; rm b; head -c 3000000 /dev/zero >&4; sleep 100"
        assertExceeded(Limit.DISK, hostile.shell(hidden, Limits(diskBytes = 4_000_000)))
    }

    @Test
    fun `many empty files and a deep tree are too much`() {
        val limits = Limits(diskEntries = 50)
        assertExceeded(Limit.DISK, hostile.shell("for i in \$(seq 100); do : > f\$i; done", limits))
        assertExceeded(Limit.DISK, Hostile().use { it.shell("for i in \$(seq 3000); do mkdir -p dddddddd; cd -P dddddddd; done") })
    }

    @Test
    fun `memory is counted as it is used, whoever uses it`() {
        val hog = "var list = new java.util.ArrayList<byte[]>(); while (true) { var a = new byte[1 << 20]; a[0] = 1; list.add(a); }"
        val outcome = hostile.java(hog, Limits(memoryBytes = 300L shl 20), heapMegabytes = 4000)
        assertExceeded(Limit.MEMORY, outcome)
        assertTrue(outcome.peakMemoryBytes > 300L shl 20)
    }

    @Test
    fun `the private temporary folder is small`() {
        val outcome = hostile.shell(FILL_TMP, Limits(temporaryBytes = 1L shl 20, diskBytes = 4_000_000))
        if ("No space left" !in outcome.errors) return assertExceeded(Limit.DISK, outcome)
        assertEquals(End.Exited(1), outcome.end)
    }

    @Test
    fun `where bubblewrap cannot bound it the temporary folder counts as disk, and nothing of it is left`() {
        val sandbox = Hostile.confinedWithoutBounds()
        assertExceeded(Limit.DISK, hostile.shell(FILL_TMP, Limits(diskBytes = 4_000_000), sandbox))
        val pieces = "for i in \$(seq 100); do head -c 100000 /dev/zero > /tmp/\$i; done; sleep 100"
        assertExceeded(Limit.DISK, hostile.shell(pieces, Limits(diskBytes = 4_000_000), sandbox))
        assertEquals(End.Exited(1), hostile.shell("(: > /dev/shm/a) 2>/dev/null || exit 1", sandbox = sandbox).end)
        assertEquals("kept\n", hostile.shell("echo kept > /tmp/a; cat /tmp/a", sandbox = sandbox).output)
        assertEquals(emptyList<String>(), SafeFiles.list(hostile.scratch, 10))
    }

    @Test
    fun `what a job says last is heard, however soon it ends`() {
        val sandbox = Sandbox.unconfined()
        repeat(100) { assertEquals("said\n", hostile.shell("echo said >&2", sandbox = sandbox).errors, "job $it") }
    }

    @Test
    fun `without a sandbox the limits hold all the same`() {
        val marker = UUID.randomUUID().toString()
        val sandbox = Sandbox.unconfined()
        assertExceeded(Limit.WALL_CLOCK, hostile.shell("sleep 100", Limits(wallSeconds = 0.3), sandbox))
        assertExceeded(Limit.OUTPUT, hostile.shell("cat /dev/zero", Limits(outputBytes = 1000), sandbox))
        // The parent is gone before its child is looked for.
        assertEquals(End.Exited(3), hostile.shell("(sh -c \"sleep 1000; : $marker\" &) ; exit 3", sandbox = sandbox).end)
        assertFalse(Hostile.isAlive(marker))
    }

    private companion object {
        const val FILL_TMP = "head -c 100000000 /dev/zero > /tmp/big"
    }

    private fun assertExceeded(limit: Limit, outcome: Outcome) =
        assertEquals(End.Exceeded(limit), outcome.end) { "output: ${outcome.output.take(500)} errors: ${outcome.errors.take(500)}" }
}
