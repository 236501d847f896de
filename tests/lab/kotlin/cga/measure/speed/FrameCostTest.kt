package cga.measure.speed

import cga.coach.calls.Interception
import cga.exercise.game.Step
import cga.framework.context.ContextKind
import cga.framework.context.GlFunctions
import cga.framework.cooked.CookedFile
import cga.framework.model.CookedModel
import cga.framework.model.ModelFile
import cga.measure.accuracy.choices.PictureSize
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.lwjgl.opengl.GL
import java.nio.file.Path
import kotlin.io.path.fileSize

/** What a frame costs that no machine's mood changes. */
@Slow
class FrameCostTest {
    private val size = PictureSize(160, 90)

    @Test
    fun `after the warm-up a frame allocates nothing`() {
        Offscreen.openOrSkip(ContextKind.OSMESA).use {
            SteadyFrame(Step.FINAL, size, 0).use { frame ->
                frame.time(60)
                val times = frame.time(61)
                // The median: now and then the JIT compiler allocates on the thread that it takes over.
                assertEquals(0.0, median(times.bytes))
                assertTrue(median(times.clock) > 0)
            }
        }
    }

    /**
     * Of step 4.7: a draw for each mesh; for each of those 5 uniforms of its material; for each of 2 models its tint and 2 matrices; 6 lights
     * of 5, of which the spotlight sends 2 once more, after those of a point light; projection, ambient, specular model, gamma.
     */
    @Test
    fun `a frame makes the calls it needs and asks nothing`() {
        val meshes = listOf("ground", "motorcycle").sumOf { ModelFile.read("assets/$it/$it.obj").meshes.size }
        val calls = callsOfOneFrame()
        assertEquals(meshes, calls.of("glDrawElements"))
        assertEquals(
            5 * meshes + 2 * 3 + 6 * 5 + 2 + 4,
            calls
                .filter {
                    it.startsWith("glUniform")
                }.size,
        ) { "${calls.groupingBy { it }.eachCount()}" }
        assertEquals(1, calls.of("glUseProgram"))
        assertEquals(1, calls.of("glClear"))
        assertEquals(listOf<String>(), calls.filter { it.startsWith("glGet") || it.startsWith("glIs") })
        assertEquals(
            listOf<String>(),
            calls.filter { it.startsWith("glGen") || it.startsWith("glBufferData") || it.startsWith("glTexImage") },
        )
    }

    private fun List<String>.of(function: String) = count { it == function }

    /** The second frame's: the first uploads and compiles. */
    private fun callsOfOneFrame(): List<String> {
        Offscreen.openOrSkip(ContextKind.OSMESA).use {
            val calls = ArrayList<String>()
            val driver = checkNotNull(GL.getFunctionProvider())
            val counted = Interception(driver::getFunctionAddress) { call -> calls.add(call.name).also { call.proceed() } }
            GlFunctions.load(counted::getFunctionAddress)
            SteadyFrame(Step.FINAL, size, 0).use { frame ->
                frame.draw()
                calls.clear()
                frame.draw()
                return calls.toList()
            }
        }
    }

    @Test
    fun `a driver that does nothing is called and makes no picture`() {
        Offscreen.openOrSkip(ContextKind.OSMESA).use {
            SteadyFrame(Step.FINAL, size, 0).use { frame ->
                val without = frame.timeWithoutDriver(50)
                val with = frame.time(50)
                // 14 400 pixels of a 46 000-triangle scene against some hundred calls: no noise bridges a factor of three.
                assertTrue(3 * median(without.thread) < median(with.clock)) { "${median(without.thread)} ${median(with.clock)} ms" }
                assertTrue(frame.fragments().first > 0) { "the driver is back" }
            }
        }
    }

    /** 32 bytes a vertex and 12 a triangle: a cooked model has nothing else but names. */
    @Test
    fun `a cooked model is as large as its numbers`(
        @TempDir folder: Path,
    ) {
        val model = ModelFile.read("assets/motorcycle/motorcycle.obj")
        val file = folder.resolve("model")
        CookedFile(emptyList(), CookedModel.encode(model)).write(file)
        val numbers = model.meshes.sumOf { 4L * it.vertices.size + 4L * it.indices.size }
        assertTrue(file.fileSize() in numbers..numbers + 1024L * model.meshes.size) { "${file.fileSize()} bytes for $numbers" }
    }
}
