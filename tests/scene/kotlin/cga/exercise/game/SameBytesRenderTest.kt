package cga.exercise.game

import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.context.ContextKind
import cga.framework.context.ContextUnavailable
import cga.framework.context.OffscreenContext
import cga.testing.CgaProcess
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestInstance
import org.junit.jupiter.api.extension.ExtendWith
import java.nio.ByteBuffer
import java.nio.file.Path
import java.security.MessageDigest
import kotlin.math.abs
import kotlin.system.exitProcess

private const val T = 5.5

/** A step is drawn always alike, on whatever of Mesa's contexts and with however many threads, and holds only sound numbers. */
@ExtendWith(Offscreen::class)
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Slow
class SameBytesRenderTest {
    private val shared = scene()

    @Test
    fun `a step drawn alone is the same as one switched to, and twice the same`() {
        for (step in Step.entries) {
            val alone = scene(step)
            repeat(
                2,
            ) {
                assertArrayEquals(
                    floats(step),
                    alone.draw(ColorFormat.RGBA32F, T).use { it.readFloats().rgba },
                    "${step.sheet}, time $it",
                )
            }
            alone.scene.cleanup()
        }
    }

    @Test
    fun `pictures are finite, nowhere negative and opaque`() {
        for (step in Step.entries) {
            val numbers = floats(step)
            assertTrue(numbers.all { it.isFinite() && it >= 0f }, "${step.sheet} has NaN, infinity or less than nothing")
            assertTrue((3 until numbers.size step 4).all { numbers[it] == 1f }, "${step.sheet} is transparent")
        }
    }

    @Test
    fun `no time and no direction gives NaN`() {
        for ((t, mouse) in listOf(0.0 to 0.0, 1e-9 to 400.0, 1e6 to -1e9, 1e300 to 1.0)) {
            val scripted = scene().apply { moveMouseTo(mouse) }
            assertTrue(scripted.draw(ColorFormat.RGBA32F, t).use { it.readFloats().rgba.all(Float::isFinite) }, "t = $t, mouse $mouse")
            scripted.scene.cleanup()
        }
    }

    @Test
    fun `the 8-bit picture is the float picture, clamped and rounded`() {
        for (step in Step.entries) {
            val floats = floats(step)
            val bytes = shared.draw(ColorFormat.RGBA8, T).use { it.read().rgba }

            fun error(i: Int) = abs(floats[i].coerceIn(0f, 1f) * 255.0 - (bytes[i].toInt() and 0xFF))
            val worst = bytes.indices.maxBy(::error)
            // OpenGL 3.3, 2.1.6 rounds 255·f to an integer, nearest preferred; the product itself errs by a float's 2⁻²⁴ of 255.
            assertEquals(0.0, error(worst), 0.5 + 255.0 / (1 shl 24), "${step.sheet}: ${floats[worst]} became ${bytes[worst]}")
        }
    }

    @Test
    fun `all thread counts give the same bytes`() {
        for (threads in listOf("0", "2", "4")) {
            assertEquals(osmesa, digests(ContextKind.OSMESA, "LP_NUM_THREADS" to threads), "LP_NUM_THREADS=$threads")
        }
    }

    @Test
    fun `OSMesa and EGL give the same bytes`() {
        assertEquals(osmesa, digests(ContextKind.EGL))
    }

    private val osmesa by lazy { digests(ContextKind.OSMESA, "LP_NUM_THREADS" to "1") }

    private fun digests(
        kind: ContextKind,
        vararg env: Pair<String, String>,
    ): String {
        val process = CgaProcess.java(StepDigests::class.java.name, listOf(kind.name), Path.of(""), env = mapOf(*env))
        if (process.exitCode == StepDigests.UNAVAILABLE) Offscreen.needed(kind).skip(process.err)
        assertEquals(0, process.exitCode, process.toString())
        assertEquals(Step.entries.size * ColorFormat.entries.size * 2, process.out.trim().lines().size, process.toString())
        return process.out.trim()
    }

    private fun scene(step: Step = Step.FINAL) = ScriptedScene(320, 180, step)

    private fun floats(step: Step): FloatArray {
        shared.scene.step = step
        return shared.draw(ColorFormat.RGBA32F, T).use { it.readFloats().rgba }
    }
}

/** A program of its own: the bytes of every step, 8-bit and float, without and with antialiasing, as a list of digests. */
internal object StepDigests {
    const val UNAVAILABLE = 3

    @JvmStatic
    fun main(args: Array<String>) {
        try {
            OffscreenContext.open(ContextKind.valueOf(args.single())).use { print(ScriptedScene(320, 180)) }
        } catch (e: ContextUnavailable) {
            System.err.println(e.message)
            exitProcess(UNAVAILABLE)
        }
    }

    private fun print(scripted: ScriptedScene) {
        for (step in Step.entries) {
            scripted.scene.step = step
            for (format in ColorFormat.entries) {
                for (samples in listOf(0, 4)) {
                    val bytes = scripted.draw(format, T, samples).use { read(it, format) }
                    println("${step.sheet} $format $samples ${digest(bytes)}")
                }
            }
        }
    }

    private fun read(
        target: RenderTarget,
        format: ColorFormat,
    ): ByteArray {
        if (format == ColorFormat.RGBA8) return target.read().rgba
        val floats = target.readFloats().rgba
        return ByteBuffer.allocate(4 * floats.size).apply { asFloatBuffer().put(floats) }.array()
    }

    private fun digest(bytes: ByteArray): String =
        MessageDigest.getInstance("SHA-256").digest(bytes).joinToString("") { "%02x".format(it) }
}
