package cga.grading.worker

import cga.framework.RenderTarget
import cga.grading.capture.CapturedDraw
import cga.grading.capture.EventKind
import cga.grading.capture.Moment
import cga.grading.capture.WriteMask
import cga.grading.replay.Replay
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.GL_NEAREST
import kotlin.io.path.exists
import kotlin.math.abs

/** Small programs run in a worker of their own, and what their captures tell. */
@ExtendWith(Offscreen::class)
@Slow
class WorkerTest {
    private fun WorkerProcess.events(kind: EventKind) = capture.events.filter { it.kind == kind }.map { it.text }

    private fun WorkerProcess.draws(frame: Int) = capture.frames[frame].draws

    /** Draws every frame again and compares those that the worker drew, byte for byte. */
    private fun assertReplays(run: WorkerProcess) {
        val capture = run.capture
        assertEquals(Moment.entries, capture.frames.map { it.moment })
        RenderTarget(capture.width, capture.height, capture.samples).use { target ->
            Replay(capture).use { replay ->
                capture.frames.forEachIndexed { number, frame ->
                    replay.draw(number, target)
                    assertEquals(frame.moment.drawn, frame.picture != null)
                    frame.picture?.let { assertArrayEquals(it, target.read().rgba, "frame $number") }
                }
            }
        }
    }

    @Test
    fun `the solution is captured without a complaint, and its pictures come again`() {
        val run = WorkerProcess.ofStudent("Solution")
        assertEquals(0, run.exitCode, "$run")
        val silent = setOf(EventKind.UNIFORM_ABSENT, EventKind.UNIFORM_OVERWRITTEN, EventKind.TEXTURE_FILE)
        assertEquals(emptyList<String>(), run.capture.events.filter { it.kind !in silent }.map { "${it.kind} ${it.text}" })
        assertReplays(run)
        assertEquals(4, run.capture.samples)
        assertTrue(run.capture.frames.all { frame -> frame.steps.count { it is CapturedDraw } > 1 })
        // What is uploaded once is captured once.
        assertEquals(run.capture.buffers.size, run.capture.buffers.distinctBy { it.contentHashCode() }.size)
    }

    @Test
    fun `the script is played with numbers for the time, and with keys and mouse as events and as state`() {
        val run = WorkerProcess.ofStudent("Listener")
        val lines = run.out.trim().lines()
        assertEquals(emptyList<String>(), lines.filter { it.startsWith("update") }, "an update came with another time than its number's")
        assertEquals("frame 0 after 0 updates W false mouse 640.0 360.0", lines.first())
        assertEquals("frame 1 after 1 updates W false mouse 640.0 360.0", lines[1])
        assertEquals("end", lines.last())
        val driven = Moment.DRIVEN.ordinal
        val at = lines.indexOfFirst { it.startsWith("frame $driven ") }
        assertEquals("key 87 action 1 mode 0 held true", lines[at - 1])
        assertTrue("W true" in lines[at], lines[at])
        // 5 s of time and 1 s of driving at 60 updates a second, and the second frame's one.
        val updates = Math.round(Moment.entries.take(driven + 1).sumOf { it.seconds } * 60)
        assertTrue("after $updates updates" in lines[at], lines[at])
        assertTrue("mouse 740.0 360.0 is 740.0 360.0" in lines)
        assertTrue("key 342 action 1 mode 4 held true" in lines)
        assertTrue("key 342 action 0 mode 0 held false" in lines)
        assertReplays(run)
        assertEquals(updates / 60.0, run.capture.frames[driven].time)
    }

    @Test
    fun `a game that asks for the arrow keys only is driven by them`() {
        val lines = WorkerProcess.ofStudent("Rider").out.trim().lines()

        fun held(moment: Moment) = lines.single { it.startsWith("frame ${moment.ordinal} ") }.substringAfter("right ")
        assertEquals("[false, false, false]", held(Moment.TIME_4))
        assertEquals("[true, false, false]", held(Moment.DRIVEN))
        assertEquals("[true, true, false]", held(Moment.STEERED))
        assertEquals("[false, false, false]", held(Moment.MOUSE_RIGHT))
        assertEquals("[true, false, true]", held(Moment.MOUSE_DRIVEN))
    }

    @Test
    fun `callbacks that a student sets on the window are called, and not the window's own`() {
        val run = WorkerProcess.ofStudent("Caller")
        val lines = run.out.trim().lines()
        assertTrue("key 87 action 1 mods 0 held true" in lines, "$run")
        assertTrue("key 342 action 1 mods 4 held true" in lines, "$run")
        assertEquals(Moment.entries.mapNotNull { it.mouse }.map { "cursor ${it.x} ${it.y}" }, lines.filter { it.startsWith("cursor") })
        assertTrue(lines.none { it.startsWith("on") }, "$run")
        assertReplays(run)
    }

    @Test
    fun `what changes between two draws is captured as it was at each`() {
        val run = WorkerProcess.ofStudent("Changer")
        assertEquals(emptyList<String>(), run.capture.events.map { "${it.kind} ${it.text}" })
        assertReplays(run)
        assertEquals(0, run.capture.samples)
        val (first, second) = run.draws(0)
        assertNotEquals(first.textures, second.textures)
        assertNotEquals(first.attributes[0].buffer, run.draws(1)[0].attributes[0].buffer)
    }

    @Test
    fun `the lines that sent, bound and drew are told, and who called them`() {
        val run = WorkerProcess.ofStudent("Changer")
        val sources = projectRoot.resolve("tests/grader/kotlin")

        fun code(call: String) = call.split(':').let { (file, line) -> sources.resolve(file).readLines()[line.toInt() - 1] }

        fun chain(caller: Int) = run.capture.chain(caller)
        for (draw in run.capture.draws) {
            val callers = draw.callers
            assertTrue("glDrawElements" in code(chain(callers.draw)[0]))
            assertTrue("glUseProgram(" in code(chain(callers.program)[0]))
            for (unit in draw.textures.keys) assertTrue("glBindTexture(" in code(chain(callers.textures.getValue(unit))[0]))
            val sent = draw.uniforms.filter { it.caller >= 0 }
            assertTrue(sent.isNotEmpty())
            for (uniform in sent) assertTrue("glUniform" in code(chain(uniform.caller)[0]))
            assertEquals("paint()", code(chain(callers.draw)[1]).trim())
        }
    }

    @Test
    fun `cube maps, sampler objects, scissors and colour masks are captured`() {
        val run = WorkerProcess.ofStudent("Stargazer")
        assertEquals(emptyList<String>(), run.capture.events.map { "${it.kind} ${it.text}" })
        assertReplays(run)
        val sky = run.capture.textures.single()
        assertTrue(sky.isCube)
        assertEquals(6 * 4 * 4 * 4, sky.levels.single().size)
        assertEquals(GL_NEAREST, sky.minFilter)
        val writes = run.draws(1).map { it.state.writes }.distinct()
        assertEquals(listOf(WriteMask.ALL, WriteMask(listOf(10, 20, 300, 200), 0b1101)), writes)
    }

    @Test
    fun `what a shader reads from uniform blocks is captured one by one, as it was at each draw`() {
        val run = WorkerProcess.ofStudent("Blockhead")
        assertEquals(emptyList<String>(), run.capture.events.map { "${it.kind} ${it.text}" })
        assertReplays(run)
        val (first, second) = listOf(1, 2).map { frame -> run.draws(frame).single().uniforms.associate { it.name to it.numbers.toList() } }
        assertEquals(
            setOf("bend.turn", "bend.shear", "count", "isOn") + (0..1).flatMap {
                setOf("lamps[$it].color", "lamps[$it].strength")
            },
            first.keys,
        )
        assertEquals(listOf(0.6f, 0.2f, -0.2f, 0.6f), first["bend.turn"])
        assertEquals(listOf(1f, 0f, 0.5f, 1f), first["bend.shear"])
        assertEquals(listOf(0f, 0f, 1f), first["lamps[1].color"])
        assertEquals(listOf(1f), first["isOn"])
        assertEquals(setOf(listOf(1f), listOf(2f)), setOf(first["count"], second["count"]))
    }

    @Test
    fun `where there is no sound card, music is played to nobody`() {
        val run = WorkerProcess.ofStudent("Musician")
        assertEquals(listOf("true 100 true", "false"), run.out.trim().lines())
        assertReplays(run)
    }

    @Test
    fun `a scene that is drawn into a framebuffer first is laid bare, and what would show it left out`() {
        val run = WorkerProcess.ofStudent("PostProcessor")
        assertEquals(0, run.exitCode, "$run")
        assertReplays(run)
        val draws = run.draws(1)
        // The framebuffer is twice as large as the window.
        assertEquals(List(2) { listOf(0, 0, run.capture.width, run.capture.height) }, draws.map { it.state.viewport })
        val picture = run.capture.frames[0].picture ?: error("no picture")
        assertEquals(listOf(0, 128, 0), picture.take(3).map { it.toInt() and 0xFF }, "the corner, which is cleared")
        assertEquals(listOf(EventKind.NOT_CAPTURED), run.capture.events.map { it.kind }.distinct())
        assertTrue(run.capture.events.all { "shows the scene" in it.text })
    }

    @Test
    fun `a scene that the window gets as well is a mirror, and captured where it is drawn itself`() {
        val run = WorkerProcess.ofStudent("Mirrored")
        assertEquals(0, run.exitCode, "$run")
        // The first picture was begun as if it were none.
        assertEquals(null, run.capture.frames[0].picture)
        assertEquals(List(run.capture.frames.size) { 2 }, run.capture.frames.indices.map { run.draws(it).size })
        val drawn = run.capture.frames.filter { it.moment.drawn }.drop(1)
        assertTrue(drawn.isNotEmpty() && drawn.all { it.picture != null })
    }

    @Test
    fun `errors are noted with their function, and the student's own glGetError still sees the first`() {
        val run = WorkerProcess.ofStudent("Erring")
        assertEquals("1280 then 0", run.out.trim())
        assertEquals(
            listOf("GL_INVALID_ENUM glEnable", "GL_INVALID_ENUM glBindTexture", "GL_INVALID_OPERATION glUniform3f"),
            run.events(EventKind.GL_ERROR),
        )
        assertEquals(listOf("nowhere"), run.events(EventKind.UNIFORM_ABSENT))
        assertEquals(listOf("glUniform3f color"), run.events(EventKind.UNIFORM_WITHOUT_PROGRAM))
        assertTrue(run.capture.events.all { it.frame == 0 })
        assertReplays(run)
    }

    @Test
    fun `a draw beyond its buffers is left out and told`() {
        val run = WorkerProcess.ofStudent("Reckless")
        assertEquals("alive, error 1280", run.out.trim(), "$run")
        assertEquals(
            listOf(
                "glDrawArrays reads vertex 2999999, beyond the buffer of vertex attribute 0",
                "glDrawElements without an index buffer",
                "glDrawElements reads vertex 3000000, beyond the buffer of vertex attribute 0",
                "glDrawElements reads beyond its index buffer",
            ),
            run.events(EventKind.NOT_CAPTURED),
        )
        assertEquals(1, run.draws(0).size)
        assertReplays(run)
    }

    @Test
    fun `the window's framebuffer is number 0 and can be read, and others are seen`() {
        val run = WorkerProcess.ofStudent("Framer")
        // color·(0.5 + 0.5·y) with y = −1 + 3/48 at the second row: (1, 0.5, 0)·0.03125 in 1/255 is 8, 4, 0; read as bytes R G B A.
        assertEquals(
            listOf("binding 0 read true samples 4 pixel ff000408 error 0", "own true pixel ff000408 error 0"),
            run.out.trim().lines(),
        )
        assertEquals(listOf("glDrawArrays into a framebuffer of the submission's own"), run.events(EventKind.NOT_CAPTURED))
        assertReplays(run)
    }

    @Test
    fun `a shader that does not compile is told, replaced by one with the same uniforms, and the program goes on`() {
        val run = WorkerProcess.ofStudent("Misspelt")
        assertEquals(
            listOf(
                "compiled 1 linked 1", "lights[1].color true", "lights[0].k[2] true", "a true", "b true", "map true", "not false",
            ),
            run.out.trim().lines(),
            "$run",
        )
        val failure = run.events(EventKind.SHADER_FAILED).single()
        assertTrue(failure.startsWith("fragment shader") && "error" in failure, failure)
        assertTrue(run.capture.programs.last().substituted)
        assertFalse(run.capture.programs.first().substituted)
        assertReplays(run)
    }

    @Test
    fun `a shader that only some drivers accept is told and said otherwise, and a later version is taken as it is`() {
        val run = WorkerProcess.ofStudent("Lenient")
        assertEquals("linked 1 later 1", run.out.trim(), "$run")
        val dialect = run.events(EventKind.SHADER_DIALECT).single()
        assertTrue(dialect.startsWith("fragment shader") && "error" in dialect, dialect)
        assertEquals(emptyList<String>(), run.events(EventKind.SHADER_FAILED))
        assertFalse(run.capture.programs.any { it.substituted })
        assertReplays(run)
    }

    @Test
    fun `every liberty of a driver's at once is told, and drawn as it was meant`() {
        val run = WorkerProcess.ofStudent("Sloppy")
        assertEquals("linked 1", run.out.trim(), "$run")
        assertEquals(1, run.events(EventKind.SHADER_DIALECT).size)
        assertEquals(emptyList<String>(), run.events(EventKind.SHADER_FAILED) + run.events(EventKind.LINK_FAILED))
        assertReplays(run)
        // The rounding of a number times 47 and divided by it.
        val (meant, drawn) = listOf(WorkerProcess.ofStudent("Lenient"), run).map { it.capture.frames[0].picture ?: error("no picture") }
        assertTrue(meant.indices.all { abs((meant[it].toInt() and 0xFF) - (drawn[it].toInt() and 0xFF)) <= 1 })
    }

    @Test
    fun `what is read and never written is told and 0, and a vector is interpolated as it is received`() {
        val run = WorkerProcess.ofStudent("Unwritten")
        assertEquals("linked [1, 1] true", run.out.trim(), "$run")
        val told = run.events(EventKind.SHADER_DIALECT).single()
        assertTrue(told.startsWith("shader program") && "toSun is read and never written" in told, told)
        assertEquals(emptyList<String>(), run.events(EventKind.LINK_FAILED))
        assertFalse(run.capture.programs.any { it.substituted })
        assertReplays(run)
        assertArrayEquals(WorkerProcess.ofStudent("Lenient").capture.frames[0].picture, run.capture.frames[0].picture)
    }

    @Test
    fun `anisotropic filtering is noted and not drawn`() {
        val run = WorkerProcess.ofStudent("Sharpener")
        assertEquals("in force 1.0 1.0 error ${0x501}", run.out.trim(), "$run")
        assertEquals(listOf(16, 8, 4, 2, 15, 14, 13, 12).map { "$it.0" }, run.events(EventKind.ANISOTROPY))
        assertEquals(1f, run.capture.textures.single().maxAnisotropy)
        assertReplays(run)
    }

    @Test
    fun `the cursor goes on from where a program has put it`() {
        val lines = WorkerProcess.ofStudent("Recentrer").out.trim().lines()
        val ways = listOf("0.0 0.0", "100.0 0.0", "0.0 100.0", "100.0 0.0", "0.0 100.0", "400.0 0.0")
        assertEquals(ways, lines.map { it.substringAfter("moved ").substringBefore(",") })
        assertEquals("mouse 132.0 24.0", lines[1].substringAfter(", "))
    }

    @Test
    fun `whoever asks GLFW or Java itself is told the script's time and keys, and waiting for time comes to an end`() {
        val lines = WorkerProcess.ofStudent("Watcher").out.trim().lines()
        // Each of the seven pictures waits a thousandth of a second.
        assertTrue(lines[5].startsWith("frame 5 W 0 at 5.32 hour 53"), lines[5])
        assertTrue(lines[6].startsWith("frame 6 W 1 at 6.32 hour 63"), lines[6])
        assertEquals(Moment.entries.size, lines.size)
    }

    @Test
    fun `stages that call one vector differently are told and drawn as they were meant`() {
        val run = WorkerProcess.ofStudent("Renamer")
        assertEquals("linked 1", run.out.trim(), "$run")
        assertTrue("spot is read and never written" in run.events(EventKind.LINK_FAILED).single())
        assertFalse(run.capture.programs.any { it.substituted })
        assertReplays(run)
    }

    @Test
    fun `stages that do not fit together are told and replaced`() {
        val run = WorkerProcess.ofStudent("Misfit")
        assertEquals("linked 1", run.out.trim(), "$run")
        assertTrue("place" in run.events(EventKind.LINK_FAILED).single())
        assertTrue(run.capture.programs.last().substituted)
        assertReplays(run)
    }

    @Test
    fun `a program that ends the JVM leaves what it has drawn so far`() {
        val run = WorkerProcess.ofStudent("Quitter")
        assertEquals(7, run.exitCode)
        assertEquals(2, run.capture.frames.size)
    }

    @Test
    fun `an exception amid a frame is told with the student's own lines, and the frame is kept without a picture`() {
        val run = WorkerProcess.ofStudent("Thrower")
        assertEquals(0, run.exitCode)
        val told = run.events(EventKind.EXCEPTION).single()
        assertTrue("the student's own" in told, told)
        assertEquals(3, run.capture.frames.size)
        assertEquals(1, run.draws(2).size)
    }

    @Test
    fun `an exception before there is a window is told`() {
        val run = WorkerProcess.ofStudent("Stillborn")
        assertTrue("no assets" in run.events(EventKind.EXCEPTION).single())
        assertEquals(0, run.capture.frames.size)
    }

    @Test
    fun `a class that is not there is no submission's failure`() {
        val run = WorkerProcess.ofStudent("Nobody")
        assertEquals(2, run.exitCode)
        assertTrue("Nobody" in run.err, run.err)
        assertFalse(run.file.exists())
    }
}
