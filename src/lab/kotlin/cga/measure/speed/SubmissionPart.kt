package cga.measure.speed

import cga.measure.Sample
import kotlin.math.ln

/** What it costs to send a frame of many objects or lights, and how that grows; ours beside the course's way. */
internal object SubmissionPart {
    private val OBJECTS = listOf(1, 10, 100, 1_000, 10_000)
    private val LIGHTS = listOf(1, 4, 16, Submission.MOST_LIGHTS)

    // From here on the objects are what takes the time, not the frame.
    private const val MANY = 100
    private const val MOST_GROWTH = 1.05

    private class Point(
        val way: Way,
        val number: Int,
        val micros: Sample,
        val bytes: Sample,
        val microsWithoutDriver: Sample,
    )

    fun measure(settings: SpeedSettings): SpeedSection =
        Speeds(settings).use { speeds ->
            val objects = points(OBJECTS) { way, n, driver -> measure(settings, speeds, way, n, 1, driver) }
            val lights = points(LIGHTS) { way, n, driver -> measure(settings, speeds, way, 1, n, driver) }
            val ours = objects.getValue(Way.OURS)
            val growth = growth(ours.filter { it.number >= MANY }.map { it.number to it.micros.median })
            SpeedSection(
                listOf(table("By objects", OBJECTS_NOTE, "objects", objects), table("By lights", LIGHTS_NOTE, "lights", lights)),
                listOf(
                    Goal("Growth with the number of objects, as a power, from $MANY on", growth, MOST_GROWTH, ""),
                    Goal("Allocated a frame", ours.maxOf { it.bytes.median }, 0.0, "bytes"),
                ),
                listOf(picture(objects)),
            )
        }

    private class Measured(
        val micros: Sample,
        val bytes: Sample,
    )

    private fun points(
        numbers: List<Int>,
        measure: (Way, Int, Boolean) -> Measured,
    ): Map<Way, List<Point>> {
        val points = numbers.flatMap { n -> Way.entries.map { way -> point(way, n, measure) } }
        return points.groupBy { it.way }
    }

    private fun point(
        way: Way,
        number: Int,
        measure: (Way, Int, Boolean) -> Measured,
    ): Point {
        val driver = measure(way, number, true)
        return Point(way, number, driver.micros, driver.bytes, measure(way, number, false).micros)
    }

    private fun measure(
        settings: SpeedSettings,
        speeds: Speeds,
        way: Way,
        objects: Int,
        lights: Int,
        driver: Boolean,
    ): Measured {
        val count = frames(objects + lights)
        // The first round warms up.
        val rounds = List(settings.runs + 1) { speeds.submission(way, objects, lights, count, driver) }.drop(1)
        return Measured(Sample(rounds.map { median(it.clock) * 1e3 }), Sample(rounds.map { median(it.bytes) }))
    }

    /** About as long a round for all. */
    private fun frames(number: Int) = (20_000 / number).coerceIn(5, 2_000)

    /** The exponent b of the y = a·x^b that fits best: least squares of the logarithms. */
    internal fun growth(points: List<Pair<Int, Double>>): Double {
        val xs = points.map { ln(it.first.toDouble()) }
        val ys = points.map { ln(it.second) }
        val x = xs.average()
        return xs.zip(ys) { a, b -> (a - x) * (b - ys.average()) }.sum() / xs.sumOf { (it - x) * (it - x) }
    }

    private fun table(
        title: String,
        note: String,
        first: String,
        points: Map<Way, List<Point>>,
    ): SpeedTable {
        val rows =
            points.getValue(Way.OURS).zip(points.getValue(Way.COURSE)) { ours, course ->
                SpeedRow(
                    "${ours.number}",
                    listOf(ours.micros, course.micros, ours.microsWithoutDriver, course.microsWithoutDriver, ours.bytes, course.bytes),
                )
            }
        val columns =
            listOf("µs a frame", "µs without Mesa", "heap bytes").flatMap { listOf("ours, $it", "course's way, $it") }
        return SpeedTable(title, note, first, columns, rows)
    }

    private fun picture(points: Map<Way, List<Point>>) =
        LinePicture(
            "performance-submission",
            "Sending a frame",
            "objects",
            "µs an object",
            points.entries
                .flatMap { (way, line) ->
                    listOf(
                        way.title to line.map { it.number.toDouble() to it.micros.median / it.number },
                        "${way.title}, without Mesa" to line.map { it.number.toDouble() to it.microsWithoutDriver.median / it.number },
                    )
                }.toMap(),
        )

    private const val OBJECTS_NOTE =
        "Each object is a triangle with a parent, a material and a draw call of its own: eight uniforms, three textures; 16×16 pixels, " +
            "one light. *The course's way* sends the same numbers as the course's original framework does: glGetUniformLocation at " +
            "each set, world matrices made anew by recursion, names put together at each bind. *Without Mesa*: with a driver that does " +
            "nothing, but still answers queries, of which ours makes none."
    private const val LIGHTS_NOTE = "The same with one object: each light has a parent and sends position, colour and attenuation."
}
