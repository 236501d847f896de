package cga.grading.sandbox

import cga.framework.InputError
import cga.testing.Slow
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.net.InetAddress
import java.net.ServerSocket
import java.net.SocketTimeoutException
import kotlin.io.path.Path
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** What a job can see and reach. */
@Slow
class IsolationTest {
    private val hostile = Hostile()

    @AfterEach
    fun close() = hostile.close()

    @Test
    fun `a well-behaved job does its work`() {
        val outcome = hostile.shell(
            "echo out; echo err >&2; echo \$GREETING > result; cat; id -u",
            environment = mapOf("GREETING" to "hello"),
        )
        assertTrue(outcome.isSuccess) { outcome.errors }
        assertEquals("err\n", outcome.errors)
        val (first, user) = outcome.output.lines()
        assertEquals("out", first)
        assertTrue(user.toInt() > 0) { "it runs as root" }
        assertEquals("hello\n", SafeFiles.read(hostile.scratch, "result", 100).decodeToString())
    }

    @Test
    fun `a folder that is missing is one message, and one that the job may not see a mistake of ours`() {
        val missing = hostile.scratch.resolve("missing")
        val sandbox = Hostile.confined()
        val error = assertThrows(InputError::class.java) { sandbox.run(Job(listOf("true"), missing)) }
        assertTrue("$missing" in error.message.orEmpty()) { error.message }
        assertThrows(IllegalArgumentException::class.java) { Job(listOf("true"), hostile.scratch, workingDirectory = hostile.outside) }
    }

    @Test
    fun `a program that does not exist is a failed exit`() =
        assertEquals(End.Exited(127), Hostile.confined().run(Job(listOf("no-such-program"), hostile.scratch)).end)

    @Test
    fun `deleting HOME deletes what the job itself made, and nothing else`() {
        hostile.outside.resolve("precious").writeText("here")
        val home = Path(System.getProperty("user.home"))
        val outcome = hostile.shell(
            "rm -rf \"\$HOME\"/* ~/* / --no-preserve-root 2>/dev/null; rm -rf $home ${hostile.outside}; ls -A \$HOME",
        )
        assertEquals("", outcome.output)
        assertTrue(home.exists())
        assertEquals("here", hostile.outside.resolve("precious").readText())
    }

    @Test
    fun `neither the machine's users nor a secret beside the scratch folder can be read`() {
        val secret = hostile.outside.resolve("rubric").apply { writeText("the-secret") }
        val outcome = hostile.java(
            "for (var f : new String[] {\"/etc/passwd\", \"/etc/shadow\", \"$secret\", \"${secret.parent}/../outside/rubric\"})" +
                " try { System.out.println(java.nio.file.Files.readString(java.nio.file.Path.of(f))); } catch (java.io.IOException e) { }",
        )
        assertEquals("", outcome.output)
        assertTrue(outcome.isSuccess) { outcome.errors }
        assertEquals(
            "",
            hostile.shell("ls /root /home /etc/passwd /proc/1/root/home /sys 2>/dev/null; cat $secret").output,
        )
    }

    @Test
    fun `nothing is inherited from the environment`() {
        val names = hostile.shell("env | cut -d= -f1 | sort").output.lines().filter { it.isNotEmpty() }
        assertEquals(listOf("HOME", "LANG", "PATH", "PWD", "TMPDIR"), names)
    }

    @Test
    fun `only the scratch folder and the private temporary folder can be written`() {
        val ours = listOf("${hostile.outside}", "${hostile.outside.parent}", "/tmp", ".")
        val places = listOf("/", "/dev", "/etc", "/usr", "/usr/bin", "/proc/sys/kernel") + ours
        val outcome = hostile.shell("for d in ${places.joinToString(" ")}; do (: > \$d/made) 2>/dev/null && echo \$d; done; :")
        // The way to the scratch folder lies in the private temporary folder here, and is as private.
        assertEquals(
            listOf("/tmp", "."),
            outcome.output.lines().filter {
                it.isNotEmpty() && "hostile" !in it
            },
        ) { "${outcome.end} ${outcome.errors}" }
        assertFalse(hostile.outside.resolve("made").exists() || hostile.outside.resolveSibling("made").exists())
        assertFalse(Path("/tmp/made").exists())
    }

    @Test
    fun `a listener on this machine is not reached`() {
        ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use { listener ->
            listener.soTimeout = 1
            val outcome = hostile.java("new java.net.Socket(\"127.0.0.1\", ${listener.localPort}).getOutputStream().write(1);")
            assertEquals(End.Exited(1), outcome.end)
            assertTrue("SocketException" in outcome.errors) { outcome.errors }
            assertThrows(SocketTimeoutException::class.java) { listener.accept() }
        }
    }

    @Test
    fun `no other process is visible`() {
        val outcome = hostile.shell("for p in /proc/[0-9]*; do tr '\\0' ' ' < \$p/cmdline 2>/dev/null; echo; done")
        assertFalse("ConsoleLauncher" in outcome.output || "surefire" in outcome.output || "gradle" in outcome.output) { outcome.output }
        val others = hostile.shell("ls -d /proc/[0-9]* | wc -l").output.trim().toInt()
        // The sandbox's first process, the job's shell, and the two programs of this pipe.
        assertTrue(others <= 5) { "$others processes" }
    }

    @Test
    fun `there are no capabilities, no new ones, and the system call filter is on`() {
        val status = hostile.shell("cat /proc/self/status").output
        for (set in listOf("CapInh", "CapPrm", "CapEff", "CapBnd", "CapAmb")) assertTrue("$set:\t0000000000000000" in status) { status }
        assertTrue("NoNewPrivs:\t1" in status && "Seccomp:\t2" in status) { status }
    }

    @Test
    fun `no namespace can be made and nothing mounted`() {
        assertEquals(End.Exited(1), hostile.shell("unshare --user true").end)
        assertTrue("not permitted" in hostile.shell("unshare --user true").errors)
        assertFalse(hostile.shell("mount -t tmpfs none .").isSuccess)
        assertFalse(hostile.shell("chroot . true").isSuccess)
    }

    @Test
    fun `a link is not followed when results are read`() {
        val secret = hostile.outside.resolve("rubric").apply { writeText("the-secret") }
        assertTrue(hostile.shell("ln -s $secret result; ln -s ${hostile.outside} folder; mkfifo pipe; echo ok > good").isSuccess)
        for (name in listOf("result", "folder/rubric", "pipe", "../outside/rubric", "missing", "")) {
            assertThrows(InputError::class.java, { SafeFiles.read(hostile.scratch, name, 100) }, name)
            assertFalse(SafeFiles.exists(hostile.scratch, name), name)
        }
        assertEquals(listOf("good"), SafeFiles.list(hostile.scratch, 10))
        assertThrows(InputError::class.java) { SafeFiles.read(hostile.scratch, "good", 2) }
        assertEquals("ok\n", SafeFiles.read(hostile.scratch, "good", 3).decodeToString())
    }

    @Test
    fun `a link as scratch content does not give away what it points to`() {
        val precious = hostile.outside.resolve("precious").apply { writeText("here") }
        hostile.scratch.resolve("link").createSymbolicLinkPointingTo(precious)
        val before = java.nio.file.Files.getAttribute(precious, "unix:uid")
        hostile.shell("true")
        assertEquals(before, java.nio.file.Files.getAttribute(precious, "unix:uid"))
        Scratch.delete(hostile.scratch)
        assertFalse(hostile.scratch.exists())
        assertEquals("here", precious.readText())
    }
}
