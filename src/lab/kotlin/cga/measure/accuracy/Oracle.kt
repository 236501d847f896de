package cga.measure.accuracy

import cga.framework.Home
import cga.framework.InputError
import org.joml.Vector3f
import java.nio.file.Path

/**
 * One line of the oracle: [inputs] to an operation and what GLM made of them.
 *
 * @param truth of long doubles, rounded to doubles: right to 2⁻⁵³, or a few times that where the operation itself cancels.
 */
public class OracleCase internal constructor(
    public val operation: Operation,
    public val kind: String,
    private val inputs: FloatArray,
    public val truth: DoubleArray,
    public val glmDouble: DoubleArray,
    public val glmFloat: DoubleArray,
) {
    /** The inputs, one after the other from the first. */
    internal fun input(): Input = Input(inputs)

    internal class Input(private val numbers: FloatArray) {
        private var next = 0

        fun hasMore(): Boolean = next < numbers.size

        fun number(): Float = numbers[next++]

        fun vector(): Vector3f = Vector3f(number(), number(), number())
    }
}

/** The cases that tests/glm/oracle.cpp made. */
public object Oracle {
    /** Where its output is kept. */
    public const val FILE: String = "tests/glm/oracle.txt"

    /** All cases, in the file's order. Throws [InputError] when [file] is missing or not what the oracle writes. */
    public fun read(file: Path = Home.resolve(FILE)): List<OracleCase> =
        Home
            .read(file, "oracle")
            .decodeToString()
            .lines()
            .withIndex()
            .filter { (_, line) -> line.isNotEmpty() && line[0] != '#' }
            .map { (index, line) ->
                runCatching { case(line) }.getOrElse {
                    throw InputError("$file:${index + 1} is no line of the oracle: make the file again as oracle.cpp beside it says.", it)
                }
            }

    private fun case(line: String): OracleCase {
        val (operation, kind, inputs, truth, double) = line.split(';')
        val float = line.substringAfterLast(';')
        return OracleCase(
            Operation.of(operation),
            kind,
            inputs.split(' ').map { it.toFloat() }.toFloatArray(),
            numbers(truth),
            numbers(double),
            numbers(float),
        )
    }

    /** Java reads C's hexadecimal numbers to the bit. */
    private fun numbers(text: String): DoubleArray = text.split(' ').map { it.toDouble() }.toDoubleArray()
}
