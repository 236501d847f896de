package cga.measure.accuracy

import cga.measure.ChildJvm

/** What GLM, JOML with its options, and we make of the oracle's cases, against the truth. */
public object MatrixAccuracy {
    /** JOML reads its options once, when it is loaded, so each choice of them gets a JVM of its own. */
    private val OPTIONS = listOf("", "joml.useMathFma", "joml.sinLookup", "joml.fastmath", "joml.fastmath joml.sinLookup")

    /** All figures; takes a few seconds. Throws [cga.framework.InputError] when the oracle's file cannot be read. */
    public fun measure(): List<Figure> = glm(Oracle.read()) + OPTIONS.flatMap(::inJvmWith)

    /** GLM's figures, from the oracle's own results in float and double. */
    internal fun glm(cases: List<OracleCase>): List<Figure> =
        figures(cases, "GLM float", "") { it.glmFloat } + figures(cases, "GLM double", "") { it.glmDouble }

    /** The figures of ours and of JOML's in this JVM, which was started with [options]. */
    internal fun ofThisJvm(
        cases: List<OracleCase>,
        options: String,
    ): List<Figure> =
        listOf(Ours, JomlFloat, JomlDouble).flatMap { implementation ->
            figures(cases, implementation.name, options) { implementation.compute(it.operation, it.input()) }
        }

    /** One figure for every kind of case that [compute] does not answer with null. */
    private fun figures(
        cases: List<OracleCase>,
        implementation: String,
        options: String,
        compute: (OracleCase) -> DoubleArray?,
    ): List<Figure> =
        cases.groupBy { it.operation to it.kind }.mapNotNull { (group, ofKind) ->
            val errors = Errors(group.first)
            for (case in ofKind) errors.add(case.truth, compute(case) ?: return@mapNotNull null)
            errors.figure(group.second, implementation, options)
        }

    private fun inJvmWith(options: String): List<Figure> {
        val properties = options.split(' ').filter { it.isNotEmpty() }.associateWith { "true" }
        val command = ChildJvm.command("cga.measure.accuracy.MatrixAccuracyKt", listOf(options), properties)
        val process = ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start()
        val lines = process.inputReader().readLines()
        check(process.waitFor() == 0) { "${command.joinToString(" ")} ended with exit code ${process.exitValue()}" }
        return lines.map(Figure::ofCsv)
    }
}

/** Prints this JVM's figures as lines of CSV, without the header. The one argument tells how JOML's options were set. */
internal fun main(args: Array<String>) {
    for (figure in MatrixAccuracy.ofThisJvm(Oracle.read(), args[0])) println(figure.toCsv())
}
