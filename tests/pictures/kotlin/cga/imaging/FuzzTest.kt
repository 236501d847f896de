package cga.imaging

import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertTimeoutPreemptively
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory
import java.time.Duration
import kotlin.random.Random

/** The inputs that fuzzing kept (tests/fuzz/run.sh), and a few thousand new ones made of them, the same in every run. */
@Slow
class FuzzTest {
    private class Target(
        val name: String,
        val run: (ByteArray) -> Unit,
    ) {
        val corpus: List<ByteArray> =
            projectRoot
                .resolve("tests/fuzz/$name")
                .listFiles()
                .orEmpty()
                .sortedBy { it.name }
                .map { it.readBytes() }
    }

    private val targets =
        listOf(
            Target("png", PngFuzz::fuzzerTestOneInput),
            Target("exr", ExrFuzz::fuzzerTestOneInput),
            Target("compare", CompareFuzz::fuzzerTestOneInput),
        )

    @TestFactory
    fun `every kept input keeps the contract`(): List<DynamicTest> =
        targets.map { target ->
            dynamicTest(target.name) {
                assertTrue(target.corpus.size > 50) { "only ${target.corpus.size} inputs in tests/fuzz/${target.name}" }
                target.corpus.forEach { assertContract(target, it) }
            }
        }

    @TestFactory
    fun `so do inputs made of them`(): List<DynamicTest> =
        targets.map { target ->
            dynamicTest(target.name) {
                val random = Random(1)
                repeat(3000) { assertContract(target, mutated(target.corpus, random)) }
            }
        }

    private fun assertContract(
        target: Target,
        input: ByteArray,
    ) = try {
        // Against a hang, and nothing else: an input takes less than a millisecond.
        assertTimeoutPreemptively(Duration.ofSeconds(30)) { target.run(input) }
    } catch (e: Throwable) {
        throw AssertionError("${target.name}, input ${input.joinToString("") { "%02x".format(it) }}", e)
    }

    /** The head of one input and the tail of another, with a few bytes changed. */
    private fun mutated(
        corpus: List<ByteArray>,
        random: Random,
    ): ByteArray {
        val (head, tail) = List(2) { corpus[random.nextInt(corpus.size)] }
        val bytes = head.copyOf(random.nextInt(head.size + 1)) + tail.drop(random.nextInt(tail.size + 1))
        if (bytes.isNotEmpty()) {
            repeat(random.nextInt(4)) { bytes[random.nextInt(bytes.size)] = EDGES[random.nextInt(EDGES.size)] ?: random.nextInt().toByte() }
        }
        return bytes
    }

    private companion object {
        val EDGES = listOf<Byte?>(0, 1, -1, 127, -128, null, null, null)
    }
}
