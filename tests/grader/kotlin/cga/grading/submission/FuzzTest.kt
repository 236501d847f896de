package cga.grading.submission

import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertTimeoutPreemptively
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory
import java.time.Duration
import kotlin.random.Random

/** The inputs that fuzzing kept (tests/fuzz/run.sh), and some new ones made of them, the same in every run. */
@Slow
class FuzzTest {
    private val targets = mapOf(
        "archive" to ArchiveFuzz::fuzzerTestOneInput,
        "tree" to TreeFuzz::fuzzerTestOneInput,
        "source" to SourceFuzz::fuzzerTestOneInput,
    )

    @TestFactory
    fun `every kept input keeps the contract, and so do inputs made of them`(): List<DynamicTest> =
        targets.map { (name, run) ->
            dynamicTest(name) {
                val corpus = projectRoot.resolve("tests/fuzz/$name").listFiles().orEmpty().sortedBy { it.name }.map { it.readBytes() }
                assertTrue(corpus.size > 20) { "only ${corpus.size} inputs in tests/fuzz/$name" }
                val random = Random(1)
                (corpus + List(MADE) { mutated(corpus, random) }).forEach { assertContract(name, run, it) }
            }
        }

    private fun assertContract(name: String, run: (ByteArray) -> Unit, input: ByteArray) =
        try {
            // Against a hang, and nothing else: an input takes some milliseconds.
            assertTimeoutPreemptively(Duration.ofSeconds(30)) { run(input) }
        } catch (e: Throwable) {
            throw AssertionError("$name, input ${input.joinToString("") { "%02x".format(it) }}", e)
        }

    /** The head of one input and the tail of another, with a few bytes changed. */
    private fun mutated(corpus: List<ByteArray>, random: Random): ByteArray {
        val (head, tail) = List(2) { corpus[random.nextInt(corpus.size)] }
        val bytes = head.copyOf(random.nextInt(head.size + 1)) + tail.drop(random.nextInt(tail.size + 1))
        if (bytes.isNotEmpty()) repeat(random.nextInt(4)) { bytes[random.nextInt(bytes.size)] = random.nextInt().toByte() }
        return bytes
    }

    private companion object {
        const val MADE = 300
    }
}
