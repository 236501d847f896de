package cga.measure.accuracy.choices

import cga.measure.Sample
import cga.measure.accuracy.Figure
import cga.measure.accuracy.MatrixAccuracy
import cga.measure.accuracy.Worker

/** Times of matrix libraries beside their errors, which [MatrixAccuracy] knows. */
internal class MatrixMeasurement(private val runs: Int) {
    /** One way to compute: an implementation, and JOML's options where it has them. */
    private class Way(
        val implementation: String,
        val options: String = "",
    ) {
        val name = implementation + if (options.isEmpty()) "" else " (${options.replace("joml.", "").replace(" ", ", ")})"

        fun worker(warmUp: Int): Worker {
            val properties = options.split(' ').filter { it.isNotEmpty() }.associateWith { "true" }
            return Worker(
                "the timing of $name",
                "cga.measure.accuracy.choices.MatrixWorkerKt",
                listOf(implementation, "$warmUp"),
                properties,
            )
        }
    }

    private val ways =
        listOf(Way("ours")) +
            listOf("", "joml.useMathFma", "joml.sinLookup", "joml.fastmath", "joml.fastmath joml.sinLookup").map { Way("JOML float", it) } +
            Way("JOML double")

    /** The groups; says [what is missing][onMissing] where GLM cannot be timed. */
    fun measure(
        figures: List<Figure>,
        onMissing: (String) -> Unit,
    ): List<MeasuredGroup> {
        val glm = GlmTiming.orNull()
        if (glm == null) onMissing("GLM is not timed: that takes g++ and GLM (apt-get install g++ libglm-dev)")
        val costs = glm.use { times(it) }
        return MatrixTask.entries.map { task -> group(task, costs, figures) }
    }

    /** By task and way. */
    private fun times(glm: GlmTiming?): Map<Pair<MatrixTask, String>, Sample> {
        val times = LinkedHashMap<Pair<MatrixTask, String>, MutableList<Double>>()

        fun add(task: MatrixTask, name: String, nanoseconds: Double) = times.getOrPut(task to name) { ArrayList() }.add(nanoseconds)
        val workers = ways.associateWith { it.worker(WARM_UP * runs) }
        try {
            repeat(runs) {
                for ((way, worker) in workers) for (task in MatrixTask.entries) add(task, way.name, worker.ask(task.name).toDouble())
                val byGlm = glm?.measure().orEmpty()
                for (task in MatrixTask.entries) {
                    for (precision in listOf("float", "double")) {
                        byGlm["${task.operation.label};$precision"]?.let { add(task, "GLM $precision", it) }
                    }
                }
            }
        } finally {
            workers.values.forEach(Worker::close)
        }
        return times.mapValues { Sample(it.value) }
    }

    private fun group(
        task: MatrixTask,
        costs: Map<Pair<MatrixTask, String>, Sample>,
        figures: List<Figure>,
    ): MeasuredGroup {
        val everyday = figures.filter { it.operation == task.operation && it.kind == task.kind }
        val rows =
            costs.filterKeys { it.first == task }.map { (key, cost) ->
                val figure = everyday.first { Way(it.implementation, it.options).name == key.second }
                Measured(key.second, cost, figure.maxUlp, figure.meanUlp)
            }
        return MeasuredGroup(task.title, NOTE, "ns", "ulp of a float", rows)
    }

    private companion object {
        /** Milliseconds for each run: who wants figures to rely on asks for several. */
        const val WARM_UP = 120
        const val NOTE =
            "The oracle's everyday cases, each from its inputs to its result as numbers in memory, in time of the processor; errors " +
                "against long doubles. Ours multiplies in double precision and rounds to floats; JOML double and GLM double are not " +
                "rounded, which OpenGL would ask for and would cost another 0.5 ulp. GLM is compiled with `g++ -O3`."
    }
}
