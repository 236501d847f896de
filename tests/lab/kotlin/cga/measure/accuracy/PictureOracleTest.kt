package cga.measure.accuracy

import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.reference.ReferenceRenderer
import cga.testing.Need
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import kotlin.io.path.readBytes
import kotlin.math.abs

/**
 * The reference against a program that shares nothing with it (tests/glm/picture.cpp): models, textures, mip levels, places and angles of
 * lights, the camera and the constants of the scene are read and computed anew there.
 */
@Slow
class PictureOracleTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `every pixel of every step is that of a program that shares nothing with us`() {
        val program = compiled()
        for (step in Step.entries) {
            for (mouse in listOf(0.0, 700.0)) {
                val scene = ScriptedScene(WIDTH, HEIGHT, step).apply {
                    moveMouseTo(mouse)
                    advanceTo(TIME)
                }
                val ours = ReferenceRenderer(scene.scene.frame(), WIDTH, HEIGHT).render().rgb
                val theirs = drawn(program, step, mouse)
                assertEquals(ours.size, theirs.size)
                val worst = ours.indices.maxBy { abs(ours[it] - theirs[it]) }
                val error = 255 * abs(ours[worst] - theirs[worst])
                val where = "at ${worst / 3 % WIDTH}, ${worst / 3 / WIDTH}"
                println("step ${step.sheet}, mouse $mouse: at most %.4f of 255, $where".format(error))
                assertTrue(error <= BOUND) { "step ${step.sheet}, mouse $mouse: $error of 255 $where, ${ours[worst]} and ${theirs[worst]}" }
            }
        }
    }

    private fun drawn(
        program: Path,
        step: Step,
        mouse: Double,
    ): DoubleArray {
        val out = folder.resolve("picture")
        run(listOf("$program", step.sheet, "$TIME", "$mouse", "$WIDTH", "$HEIGHT", "assets", "$out"))
        val numbers = ByteBuffer.wrap(out.readBytes()).order(ByteOrder.nativeOrder()).asDoubleBuffer()
        return DoubleArray(numbers.remaining()).also { numbers.get(it) }
    }

    private fun compiled(): Path {
        val program = folder.resolve("oracle")
        val says =
            try {
                start(listOf("g++", "-std=c++17", "-O2", "-o", "$program", "tests/glm/picture.cpp", "-lpng"))
            } catch (e: IOException) {
                Need.GLM.skip("needs g++: apt-get install g++ libglm-dev libpng-dev (${e.message})")
            }
        val lacks = listOf("needs GLM: apt-get install libglm-dev", "needs libpng: apt-get install libpng-dev").find { it in says.second }
        if (lacks != null) Need.GLM.skip(lacks)
        assertEquals(0, says.first, says.second)
        return program
    }

    private fun run(command: List<String>) = start(command).let { (code, says) -> assertEquals(0, code, says) }

    private fun start(command: List<String>): Pair<Int, String> {
        val builder = ProcessBuilder(command).redirectErrorStream(true)
        builder.environment()["LC_ALL"] = "C"
        val process = builder.start()
        val says = process.inputReader().readText()
        return process.waitFor() to says
    }

    private companion object {
        const val WIDTH = 480
        const val HEIGHT = 270
        const val TIME = 5.3

        /** The scene's matrices and angles are floats, the other program's are not: positions and texture coordinates differ by 1e-7. */
        const val BOUND = 0.02
    }
}
