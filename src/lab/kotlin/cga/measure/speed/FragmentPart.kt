package cga.measure.speed

import cga.exercise.game.Step
import cga.framework.Frame
import cga.framework.FrameDraw
import cga.framework.context.OffscreenContext
import cga.measure.Sample
import cga.measure.twin.RecordedFrame
import cga.measure.twin.Recording
import cga.measure.twin.SentUniform
import cga.measure.twin.Twin
import cga.measure.twin.TwinShot
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory

/** What the pixels cost, step by step, and what the order of drawing brings. */
internal object FragmentPart {
    private const val FRAMES = 15
    private const val WARM_UP = 30

    fun measure(settings: SpeedSettings): SpeedSection {
        val folder = createTempDirectory("cga-orders")
        try {
            return SpeedSection(listOf(steps(settings), orders(settings, folder)))
        } finally {
            folder.toFile().deleteRecursively()
        }
    }

    private fun steps(settings: SpeedSettings): SpeedTable =
        Speeds(settings).use { speeds ->
            val draw = { step: Step, count: Int -> speeds.frame(step.sheet, settings.size, 0, count) }
            Step.entries.forEach { draw(it, WARM_UP) }
            val rounds = List(settings.runs) { Step.entries.associateWith { median(draw(it, FRAMES).clock) } }
            val rows =
                Step.entries.map { step ->
                    val (passed, covered) = speeds.fragments(step.sheet, settings.size)
                    val times = rounds.map { it.getValue(step) }
                    val nanos = Sample(times.map { it * 1e6 / passed })
                    SpeedRow("${step.sheet} ${step.title}", Sample(times), one(passed), one(passed.toDouble() / covered), nanos)
                }
            SpeedTable(
                "What a fragment costs",
                "${settings.size}, no samples, ours. *Fragments* pass the depth test; so many times the pixels that are covered is the " +
                    "overdraw. *ns* is the whole frame divided by its fragments.",
                "step",
                listOf("ms a frame", "fragments", "overdraw", "ns a fragment"),
                rows,
            )
        }

    /** One way to draw the recorded frame. */
    private class Order(
        val name: String,
        val frame: RecordedFrame,
        val isCulling: Boolean = true,
    )

    private fun orders(
        settings: SpeedSettings,
        folder: Path,
    ): SpeedTable {
        val twin = Twin.compile(folder)
        val shot = TwinShot(Step.FINAL, settings.size.width, settings.size.height)
        val recorded = OffscreenContext.open(settings.kind).use { RecordedFrame.of(shot) }
        val orders =
            listOf(
                Order("as it is: ground, motorcycle; back faces culled", recorded),
                Order("motorcycle, ground", turned(recorded)),
                Order("back faces drawn", recorded, isCulling = false),
                Order("triangles ordered for a cache of ${TriangleOrder.CACHE} vertices", reordered(recorded, TriangleOrder::forCache)),
                Order("triangles shuffled", reordered(recorded, TriangleOrder::shuffled)),
            )
        val files = orders.mapIndexed { i, order -> Recording.write(order.frame, folder.resolve("$i").createDirectories()) }
        val rounds =
            List(settings.runs + 1) {
                orders.indices.map { i ->
                    median(twin.frameTimes(files[i], settings.kind, FRAMES, own = false, orders[i].isCulling).clocks())
                }
            }.drop(1)
        return SpeedTable(
            "Order",
            "The same frame, drawn by the twin in turns. *Vertices a triangle*: those that a cache of ${TriangleOrder.CACHE} misses, all meshes together.",
            "",
            listOf("ms a frame", "÷ as it is", "vertices a triangle"),
            orders.mapIndexed { i, order ->
                SpeedRow(order.name, Sample(rounds.map { it[i] }), Sample(rounds.map { it[i] / it[0] }), one(misses(order.frame)))
            },
        )
    }

    private fun List<Twin.FrameTime>.clocks() = map { it.clock }.toDoubleArray()

    private fun one(value: Number) = Sample(listOf(value.toDouble()))

    private fun misses(recorded: RecordedFrame): Double {
        val draws = recorded.frame.draws
        return draws.sumOf { TriangleOrder.cacheMisses(it.indices) * it.indices.size } / draws.sumOf { it.indices.size }
    }

    private fun reordered(
        recorded: RecordedFrame,
        order: (IntArray) -> IntArray,
    ): RecordedFrame =
        copy(
            recorded,
            recorded.frame.draws.map { FrameDraw(it.vertices, order(it.indices), it.model, it.tint, it.material) },
            recorded.uniforms,
        )

    /** The motorcycle before the ground: the uniforms of each begin with its tint. */
    private fun turned(recorded: RecordedFrame): RecordedFrame {
        val (first, second) = recorded.uniforms.indices.filter { recorded.uniforms[it].name == FIRST_OF_MODEL }
        val uniforms = recorded.uniforms
        val ground = uniforms.subList(first, second)
        val meshes = ground.count { it.name == LAST_OF_MESH }
        val draws = recorded.frame.draws
        return copy(recorded, draws.drop(meshes) + draws.take(meshes), uniforms.take(first) + uniforms.drop(second) + ground)
    }

    // As Scene.render and Material.bind send them.
    private const val FIRST_OF_MODEL = "emissiveTint"
    private const val LAST_OF_MESH = "tcMultiplier"

    private fun copy(
        recorded: RecordedFrame,
        draws: List<FrameDraw>,
        uniforms: List<SentUniform>,
    ): RecordedFrame {
        val frame =
            recorded.frame.run { Frame(view, projection, ambient, specularModel, gamma, lights, draws) }
        return RecordedFrame(frame, recorded.constants, uniforms, recorded.parameters, recorded.picture, recorded.samples)
    }
}
