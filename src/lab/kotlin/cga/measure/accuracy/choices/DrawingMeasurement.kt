package cga.measure.accuracy.choices

import cga.framework.context.ContextKind
import cga.measure.Sample
import cga.measure.accuracy.Worker
import cga.reference.ReferencePicture
import cga.reference.ReferenceRenderer
import java.nio.file.Path
import kotlin.io.path.createTempDirectory

/** Where drawing is measured: [context] null for the first that works, and on a GPU only if not [software]. */
internal class Device(
    private val context: ContextKind?,
    private val software: Boolean,
) {
    fun worker(
        filter: TextureFilter,
        size: PictureSize,
    ): Worker {
        val args = listOfNotNull("${size.width}", "${size.height}", context?.name)
        val environment = filter.environment + ("LIBGL_ALWAYS_SOFTWARE" to if (software) "1" else null)
        return Worker("the measuring of pictures", "cga.measure.accuracy.choices.DrawingWorkerKt", args, environment = environment)
    }
}

/** What one device made of all choices. */
internal class DrawingResult(
    val renderer: String,
    val version: String,
    val groups: List<MeasuredGroup>,
) {
    val isSoftware: Boolean get() = "llvmpipe" in renderer || "softpipe" in renderer
}

/** Times and compares all [DrawingChoices]. The truths are kept, for another device. */
internal class DrawingMeasurement(
    private val size: PictureSize,
    private val runs: Int,
) {
    private val truths = HashMap<TruthKey, ReferencePicture>()

    fun measure(device: Device): DrawingResult {
        val workers = TextureFilter.entries.associateWith { device.worker(it, size) }
        val folder = createTempDirectory("cga-pictures")
        try {
            val (renderer, version) = workers.values.map(Worker::answer).first().split('\t')
            val errors = errors(workers, folder.resolve("picture"))
            val costs = costs(workers)
            return DrawingResult(renderer, version, DrawingGroup.entries.map { group(it, costs, errors) })
        } finally {
            workers.values.forEach(Worker::close)
            folder.toFile().deleteRecursively()
        }
    }

    private fun group(
        group: DrawingGroup,
        costs: List<Sample>,
        errors: List<PictureError>,
    ): MeasuredGroup {
        val all = DrawingChoices.all
        val rows =
            all.indices.filter { all[it].group == group }.map {
                Measured(all[it].name, costs[it], errors[it].max, errors[it].mean, "${all[it].truth}")
            }
        return MeasuredGroup(
            group.title,
            note(group),
            "ms a frame",
            "1/255",
            rows + if (group.isSmall) referenceRows(TruthKey.fine(group)) else emptyList(),
        )
    }

    private fun note(group: DrawingGroup): String =
        when (group) {
            DrawingGroup.LIGHTING ->
                "$size, timed into RGBA8. Compared into RGBA32F with a plain grey surface in the place of all textures, whose own errors " +
                    "would hide that of the lighting. Ours: vectors to the lights per vertex, versines, Blinn-Phong, a cone of 24°."
            DrawingGroup.TARGET ->
                "$size. Compared with textures at their largest level and llvmpipe's float filter: the largest error is that of texture " +
                    "coordinates at a sharp edge of a texture."
            DrawingGroup.FILTER ->
                "$size, timed into RGBA8, compared into RGBA32F. `GALLIVM_PERF=no_aos_sampling` chooses the float filter. With mip " +
                    "levels the error is mostly that of the level, which OpenGL lets a driver approximate."
            DrawingGroup.ANTIALIASING ->
                "${size.small}, timed until the picture is in memory, averaging included. Compared with " +
                    "${TruthKey.FINE}×${TruthKey.FINE} samples a pixel of the reference, in all pixels. Most of the error is " +
                    "that of textures: OpenGL's samples share one colour for each triangle, and so smooth edges only."
            DrawingGroup.EDGES -> "The same with a plain grey surface, which leaves the edges and the highlights."
        }

    /** The reference with few samples, against itself with many: what is left of the error is the samples'. */
    private fun referenceRows(key: TruthKey): List<Measured> {
        val truth = truth(key, size.small)
        val renderer = ReferenceRenderer(Truth.frame(key, size.small), size.small.width, size.small.height)
        return listOf(1, 2, 4).map { grid ->
            val picture = renderer.render(grid)
            val error = PictureError.of(truth.rgb, picture.toFloatImage().rgba) { true }
            val cost = Sample(List(runs) { milliseconds { renderer.render(grid) } })
            Measured("reference, $grid×$grid", cost, error.max, error.mean, "$key")
        }
    }

    /** One run of every choice after the other, and so on: what slows the machine down for a while slows all of them. */
    private fun costs(workers: Map<TextureFilter, Worker>): List<Sample> {
        val times = DrawingChoices.all.map { ArrayList<Double>() }
        repeat(runs) {
            DrawingChoices.all.forEachIndexed { i, choice -> times[i] += workers.getValue(choice.timed.filter).ask("time $i").toDouble() }
        }
        return times.map(::Sample)
    }

    private fun errors(
        workers: Map<TextureFilter, Worker>,
        file: Path,
    ): List<PictureError> {
        workers.getValue(TextureFilter.FLOAT).ask("numbers $file")
        val numbers = readFloats(file)
        val isSame = { surface: IntArray ->
            { pixel: Int ->
                surface[pixel] != ReferencePicture.NO_SURFACE &&
                    surface[pixel] == numbers[4 * pixel].toInt()
            }
        }
        return DrawingChoices.all.mapIndexed { i, choice ->
            workers.getValue(choice.compared.filter).ask("draw $i $file")
            val truth = truth(choice.truth, if (choice.group.isSmall) size.small else size)
            PictureError.of(truth.rgb, readFloats(file), if (choice.group.isSmall) ({ true }) else isSame(truth.surface))
        }
    }

    private fun truth(
        key: TruthKey,
        size: PictureSize,
    ) = truths.getOrPut(key) { Truth.picture(key, size) }

    /** The reference as it is, and started from what OpenGL gets: matrices and lights rounded to floats. */
    fun reference(): MeasuredGroup {
        val key = TruthKey()
        val frame = Truth.frame(key, size)
        val truth = truth(key, size)
        val rounded = ReferenceRenderer(Truth.roundedToFloats(frame), size.width, size.height)
        val double = ReferenceRenderer(frame, size.width, size.height)
        val picture = rounded.render()
        val asFloats = PictureError.of(truth.rgb, truth.toFloatImage().rgba) { true }
        val error = PictureError.of(truth.rgb, picture.toFloatImage().rgba) { truth.surface[it] == picture.surface[it] }
        val times = List(runs) { milliseconds { double.render() } to milliseconds { rounded.render() } }
        val doubleCost = Sample(times.map { it.first })
        val rows =
            listOf(
                Measured("double", doubleCost, 0.0, 0.0),
                Measured("double, the result stored as floats", doubleCost, asFloats.max, asFloats.mean),
                Measured("double, from matrices and lights rounded to floats", Sample(times.map { it.second }), error.max, error.mean),
            )
        return MeasuredGroup("The reference", REFERENCE_NOTE.format(size), "ms a frame", "1/255", rows)
    }

    private companion object {
        const val REFERENCE_NOTE =
            "%s, mip levels included, on all processors. There is no second reference in floats: it would be a second copy of the code " +
                "that defines the truth, and llvmpipe with RGBA32F already is those formulas in floats (see Lighting). What a float " +
                "reference could gain is bounded by the two lower rows: what goes in, and what comes out, rounded to floats."

        fun milliseconds(work: () -> Unit): Double {
            val start = System.nanoTime()
            work()
            return (System.nanoTime() - start) / 1e6
        }
    }
}
