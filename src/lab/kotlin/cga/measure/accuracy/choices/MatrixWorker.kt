package cga.measure.accuracy.choices

import cga.measure.accuracy.Implementation
import cga.measure.accuracy.JomlDouble
import cga.measure.accuracy.JomlFloat
import cga.measure.accuracy.Operation
import cga.measure.accuracy.Oracle
import cga.measure.accuracy.OracleCase
import cga.measure.accuracy.Ours
import java.lang.management.ManagementFactory

private const val ROUNDS = 11
private const val REPEATS = 5000

/** What is computed goes here, so that none of it can be left out. */
@Volatile
private var sink = 0.0

/**
 * Answers every name of a [MatrixTask] with nanoseconds a case. Arguments: the [Implementation]'s name, and for how many milliseconds
 * each task is done before it is measured first, so that the JIT compiler is done with it.
 */
internal fun main(args: Array<String>) {
    val implementation = listOf(Ours, JomlFloat, JomlDouble).first { it.name == args[0] }
    val timings = MatrixTask.entries.associateWith { Timing(implementation, it, args[1].toLong()) }
    for (line in generateSequence(::readlnOrNull)) println(timings.getValue(MatrixTask.valueOf(line)).median())
}

private class Timing(
    private val implementation: Implementation,
    private val task: MatrixTask,
    private val warmUp: Long,
) {
    private val cases: List<OracleCase> by lazy {
        warm(Oracle.read().filter { it.operation == task.operation && it.kind == task.kind })
    }

    fun median(): Double = List(ROUNDS) { nanoseconds(cases) }.sorted()[ROUNDS / 2]

    private fun warm(cases: List<OracleCase>): List<OracleCase> {
        val start = processorTime()
        while (processorTime() - start < 1_000_000 * warmUp) nanoseconds(cases)
        return cases
    }

    private fun nanoseconds(cases: List<OracleCase>): Double {
        val start = processorTime()
        var sum = 0.0
        repeat(REPEATS) { for (i in cases.indices) sum += computed(cases[i]) }
        sink = sum
        return (processorTime() - start) / (REPEATS.toDouble() * cases.size)
    }

    /** Of this thread: a machine that is busy with something else takes nothing away. */
    private fun processorTime(): Long = ManagementFactory.getThreadMXBean().currentThreadCpuTime

    /** All numbers are used: one alone could be computed alone. */
    private fun computed(case: OracleCase): Double {
        val numbers = implementation.compute(task.operation, case.input()) ?: return 0.0
        return numbers.sum()
    }
}

/** An operation of the oracle that is timed, by its everyday cases. */
internal enum class MatrixTask(
    val title: String,
    val operation: Operation,
    val kind: String,
) {
    PLACING("Matrices: move, turn and scale", Operation.PLACING, "any"),
    MODEL_VIEW("Matrices: camera and model, multiplied", Operation.MODEL_VIEW, "10 away"),
    NORMAL_MATRIX("Matrices: normal matrix", Operation.NORMAL_MATRIX, "any"),
}
