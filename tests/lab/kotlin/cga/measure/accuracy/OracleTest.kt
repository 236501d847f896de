package cga.measure.accuracy

import cga.framework.InputError
import cga.testing.Need
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.Path
import kotlin.io.path.readText
import kotlin.io.path.writeText

@Slow
class OracleTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `the oracle's file is what its program writes`() {
        val fresh = folder.resolve("oracle.txt")
        fresh.writeText(run(compiled()))
        if (fresh.readText() != Path(Oracle.FILE).readText()) assertSameButForTheLibrary(Oracle.read(), Oracle.read(fresh))
    }

    @Test
    fun `another C library's last bits are no difference, another case or result is`() {
        assertSameButForTheLibrary(Oracle.read(), withFirstNumber(DOUBLE, Math::nextUp))
        for (field in listOf(INPUTS, TRUTH, DOUBLE, FLOAT)) {
            assertThrows<AssertionError> { assertSameButForTheLibrary(Oracle.read(), withFirstNumber(field) { it + 0.001 }) }
        }
    }

    @Test
    fun `every operation has cases, and every truth is finite`() {
        val cases = Oracle.read()
        assertEquals(Operation.entries, cases.map { it.operation }.distinct())
        for (case in cases) assertTrue(case.truth.all(Double::isFinite)) { "${case.operation}, ${case.kind}: ${case.truth.toList()}" }
    }

    @Test
    fun `numbers are read to the bit`() {
        val file = folder.resolve("oracle.txt")
        file.writeText("# a comment\nattenuation;any;0x1.99999ap-4 -0x1p+0;0x1.fffffffffffffp-2;0x0p+0;-Infinity\n")
        val case = Oracle.read(file).single()
        assertEquals(Operation.ATTENUATION to "any", case.operation to case.kind)
        assertEquals(listOf(0.1f, -1f), case.input().let { listOf(it.number(), it.number()) })
        assertEquals(Math.nextDown(0.5), case.truth.single())
        assertEquals(listOf(0.0, Double.NEGATIVE_INFINITY), case.glmDouble.toList() + case.glmFloat.toList())
    }

    @Test
    fun `a file that is none of the oracle's is refused with its line`() {
        val file = folder.resolve("oracle.txt")
        for (line in listOf("nonsense", "guessing;any;0x0p+0;0x0p+0;0x0p+0;0x0p+0", "attenuation;any;one;0x0p+0;0x0p+0;0x0p+0")) {
            file.writeText("# a comment\n$line\n")
            assertTrue("$file:2 " in assertThrows<InputError> { Oracle.read(file) }.message.orEmpty())
        }
    }

    /** The oracle's cases, with the first number in a [field] of the first case changed. */
    private fun withFirstNumber(
        field: Int,
        change: (Double) -> Double,
    ): List<OracleCase> {
        val lines = Path(Oracle.FILE).readText().lines().toMutableList()
        val fields = lines[1].split(';').toMutableList()
        val first = fields[field].substringBefore(' ')
        fields[field] = java.lang.Double.toHexString(change(first.toDouble())) + fields[field].removePrefix(first)
        lines[1] = fields.joinToString(";")
        val file = folder.resolve("changed.txt")
        file.writeText(lines.joinToString("\n"))
        return Oracle.read(file)
    }

    private fun compiled(): Path {
        val program = folder.resolve("oracle")
        val compiler = ProcessBuilder("g++", "-std=c++17", "-ffp-contract=off", "-o", "$program", "tests/glm/oracle.cpp")
        compiler.environment()["LC_ALL"] = "C"
        val process =
            try {
                compiler.redirectErrorStream(true).start()
            } catch (e: IOException) {
                Need.GLM.skip("needs g++: apt-get install g++ libglm-dev (${e.message})")
            }
        val says = process.inputReader().readText()
        val lacks = listOf("needs GLM: apt-get install libglm-dev", "here long double is no better than double").find { it in says }
        if (lacks != null) Need.GLM.skip(lacks)
        assertEquals(0, process.waitFor(), says)
        return program
    }

    private fun run(program: Path): String {
        val process = ProcessBuilder("$program").redirectErrorStream(true).start()
        val says = process.inputReader().readText()
        assertEquals(0, process.waitFor(), says)
        return says
    }

    /**
     * Another C library may round sines and roots otherwise in the last bit. The truth must not move by what could be seen in the
     * figures, and GLM's own errors, which rounding makes and is chance in, must stay in their order of magnitude.
     */
    private fun assertSameButForTheLibrary(
        stored: List<OracleCase>,
        fresh: List<OracleCase>,
    ) {
        assertEquals(stored.map(::question), fresh.map(::question)) { "oracle.cpp makes other cases: make ${Oracle.FILE} again as it says" }
        for ((old, new) in stored zip fresh) {
            val moved = Errors(old.operation).apply { add(old.truth, new.truth) }.figure(old.kind, "", "")
            assertTrue(moved.notFinite == 0 && moved.maxUlp < 1e-4) { "the truth moved: $moved. If GLM is right, make the file again" }
        }
        for ((old, new) in MatrixAccuracy.glm(stored) zip MatrixAccuracy.glm(fresh)) {
            assertEquals(old.notFinite, new.notFinite)
            assertTrue(new.maxUlp <= 2 * old.maxUlp + 1) { "GLM became worse: $new, was $old. If that is so, make the file again" }
        }
    }

    private fun question(case: OracleCase): List<Any> {
        val input = case.input()
        return listOf(case.operation, case.kind) + generateSequence { if (input.hasMore()) input.number() else null }
    }

    private companion object {
        /** The oracle's columns. */
        const val INPUTS = 2
        const val TRUTH = 3
        const val DOUBLE = 4
        const val FLOAT = 5
    }
}
