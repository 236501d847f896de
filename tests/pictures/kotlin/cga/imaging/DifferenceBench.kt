package cga.imaging

import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.random.Random

/**
 * How long a compare takes at 1920×1080, without and with decoding. Not a test; after the tests were compiled:
 *
 *     java -cp CLASSPATH cga.imaging.DifferenceBenchKt [A.png B.png [ODIFF]]
 *
 * ODIFF is the path of another program that compares the same two files (`odiff-bin` of npm).
 */
internal fun main(args: Array<String>) {
    val pixels = WIDTH * HEIGHT
    val a = Random(1).nextBytes(4 * pixels)
    val few = a.copyOf().also { bytes -> repeat(2000) { bytes[Random(it).nextInt(bytes.size)]++ } }
    val tasks = linkedMapOf<String, () -> Unit>()
    tasks.compare("8 bit, identical", bytePicture(a), bytePicture(a.copyOf()))
    tasks.compare("8 bit, 0.1 % of pixels differ", bytePicture(a), bytePicture(few))
    tasks.compare("8 bit, all pixels differ", bytePicture(a), bytePicture(Random(2).nextBytes(a.size)))
    tasks.compare("float, identical", floatPicture(a), floatPicture(a))
    tasks.compare("float, all pixels differ", floatPicture(a), floatPicture(Random(2).nextBytes(a.size)))
    if (args.size >= 2) tasks.files(Path.of(args[0]), Path.of(args[1]), args.getOrNull(2))
    println("median of $ROUNDS interleaved rounds at ${WIDTH}x$HEIGHT, Java ${Runtime.version()}")
    for ((name, times) in measure(tasks)) {
        val median = times.sorted()[times.size / 2] / 1e6
        println("%-50s %9.3f ms %8.0f MP/s".format(name, median, pixels / median / 1e3))
    }
}

private const val WIDTH = 1920
private const val HEIGHT = 1080
private const val ROUNDS = 21
private const val WARM_UP = 10

private fun MutableMap<String, () -> Unit>.compare(
    name: String,
    expected: Picture,
    actual: Picture,
) {
    put("$name: difference") { Difference.between(expected, actual) }
    put("$name: worst 16x16 window") { Window.worst(expected, actual, 16) }
}

private fun MutableMap<String, () -> Unit>.files(
    a: Path,
    b: Path,
    odiff: String?,
) {
    put("decode ${a.fileName}") { PictureFile.read(a) }
    put("decode and compare ${a.fileName} ${b.fileName}") { Difference.between(PictureFile.read(a), PictureFile.read(b)) }
    if (odiff == null || !Path.of(odiff).exists()) return
    for (other in listOf(a, b)) {
        val process = ProcessBuilder(odiff, "$a", "$other").redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD)
        put("odiff ${a.fileName} ${other.fileName}, as a process") { process.start().waitFor() }
    }
}

/** Nanoseconds of each round; the rounds go through all tasks, so that what else the machine does meets all alike. */
private fun measure(tasks: Map<String, () -> Unit>): Map<String, List<Long>> {
    val times = tasks.mapValues { mutableListOf<Long>() }
    repeat(WARM_UP + ROUNDS) { round ->
        for ((name, task) in tasks) {
            val start = System.nanoTime()
            task()
            if (round >= WARM_UP) times.getValue(name) += System.nanoTime() - start
        }
    }
    return times
}

private fun bytePicture(rgba: ByteArray) = BytePicture(ImageData(WIDTH, HEIGHT, rgba), hasAlpha = true)

private fun floatPicture(bytes: ByteArray): FloatPicture =
    FloatPicture(FloatImage(WIDTH, HEIGHT, FloatArray(bytes.size) { bytes[it] / 100f }), hasAlpha = true)
