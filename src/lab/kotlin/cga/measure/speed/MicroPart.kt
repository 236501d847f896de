package cga.measure.speed

import cga.framework.InputError
import cga.measure.ChildJvm
import cga.measure.Sample
import cga.measure.speed.micro.ChainBenchmark
import cga.measure.speed.micro.TransformBenchmark
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.openjdk.jmh.generators.core.BenchmarkGenerator
import org.openjdk.jmh.generators.core.FileSystemDestination
import org.openjdk.jmh.generators.reflection.RFGeneratorSource
import java.nio.file.Path
import javax.tools.ToolProvider
import kotlin.io.path.createTempDirectory
import kotlin.io.path.readText
import kotlin.io.path.walk

/**
 * Single operations, with JMH. JMH measures by classes that it writes for each benchmark; they are written and compiled here, at run
 * time, so that neither build needs a step for it.
 */
internal object MicroPart {
    private val BENCHMARKS = listOf(TransformBenchmark::class.java, ChainBenchmark::class.java)

    fun measure(settings: SpeedSettings): SpeedSection {
        val folder = createTempDirectory("cga-micro")
        try {
            generate(folder)
            return SpeedSection(listOf(table(run(folder, settings.runs))))
        } finally {
            folder.toFile().deleteRecursively()
        }
    }

    private fun generate(folder: Path) {
        val source = RFGeneratorSource()
        source.processClasses(*BENCHMARKS.toTypedArray())
        val destination = FileSystemDestination(folder.toFile(), folder.toFile())
        BenchmarkGenerator().apply {
            generate(source, destination)
            complete(source, destination)
        }
        if (destination.hasErrors()) throw InputError("JMH refuses the benchmarks: ${destination.errors.joinToString { it.message }}")
        val compiler = ToolProvider.getSystemJavaCompiler() ?: throw InputError("needs javac: start this with a JDK, not a JRE.")
        val sources = folder.walk().filter { "$it".endsWith(".java") }.map { "$it" }.toList()
        val options = listOf("-proc:none", "-d", "$folder", "-cp", System.getProperty("java.class.path"))
        check(compiler.run(null, null, null, *(options + sources).toTypedArray()) == 0) { "the classes that JMH wrote do not compile" }
    }

    private fun run(
        folder: Path,
        runs: Int,
    ): List<JsonObject> {
        val result = folder.resolve("result.json")
        val jmh = listOf("-f", "1", "-wi", "3", "-w", "300ms", "-i", "$runs", "-r", "300ms", "-bm", "avgt", "-tu", "ns", "-prof", "gc")
        val command =
            ChildJvm.command(
                "org.openjdk.jmh.Main",
                jmh + listOf("-rf", "json", "-rff", "$result", "-foe", "true"),
                classPath = listOf("$folder"),
            )
        val log = folder.resolve("jmh.log").toFile()
        val process = ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log).start()
        if (process.waitFor() != 0) throw InputError("JMH failed: ${log.readLines().takeLast(5).joinToString(" ")}")
        return Json.parseToJsonElement(result.readText()).jsonArray.map { it.jsonObject }
    }

    private fun table(results: List<JsonObject>): SpeedTable =
        SpeedTable(
            "Operations",
            "JMH, one fork, averages of 0.3 s; over the iterations the median (lowest–highest). *Twice* are two operations. The frame " +
                "loop uses `worldModelMatrix` and `normalMatrix`; the others are what students call.",
            "operation",
            listOf("ns", "bytes"),
            results.map { SpeedRow(name(it), sample(it.getValue("primaryMetric").jsonObject), bytes(it)) },
        )

    private fun name(result: JsonObject): String {
        val method = result.getValue("benchmark").jsonPrimitive.content.substringAfterLast('.')
        val length = result["params"]?.jsonObject?.get("length")?.jsonPrimitive?.content ?: return "`$method`"
        return "`$method`, chain of $length"
    }

    private fun sample(metric: JsonObject) = Sample(
        metric
            .getValue("rawData")
            .jsonArray
            .flatMap {
                it.jsonArray
            }.map { it.jsonPrimitive.double },
    )

    private fun bytes(result: JsonObject): Sample? {
        val metrics = result.getValue("secondaryMetrics").jsonObject
        val perOperation = metrics.entries.find { "gc.alloc.rate.norm" in it.key } ?: return null
        // JMH's own bookkeeping is spread over the operations.
        return Sample(listOf(Math.rint(sample(perOperation.value.jsonObject).median)))
    }
}
