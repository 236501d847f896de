package cga.measure.speed

import cga.framework.Home
import cga.framework.InputError
import cga.measure.Sample
import cga.measure.start.Interleaved
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.exists
import kotlin.io.path.readText

/** The two commands that CI and graders wait for: all golden images, and a handful of submissions. */
internal object CommandPart {
    private const val MOST_SECONDS = 6.0

    /** A round takes half a minute. */
    private const val MOST_ROUNDS = 3
    private const val SUBMISSIONS = 4
    private const val JOBS = 2
    private const val GOLDEN = "`./cga golden`, all cases"
    private const val GRADE = "`./cga grade`, a submission of $SUBMISSIONS, $JOBS at a time"

    fun measure(settings: SpeedSettings): SpeedSection {
        val launcher = LauncherJvm.launcher()
        val folder = createTempDirectory("cga-commands")
        try {
            val results = folder.resolve("results")
            val commands = mapOf(GOLDEN to golden(launcher), GRADE to grade(launcher, submissions(folder), results))
            val times = Interleaved.time(commands, minOf(settings.runs, MOST_ROUNDS))
            val golden = times.getValue(GOLDEN)
            val grading = times.getValue(GRADE).seconds / SUBMISSIONS
            return SpeedSection(
                listOf(
                    // Nobody is charged with the processor time of what ends inside a sandbox.
                    commandTable(listOf(SpeedRow(GOLDEN, golden.seconds, golden.processorSeconds), SpeedRow(GRADE, grading, null))),
                    stageTable((1..SUBMISSIONS).map { stages(results.resolve(name(it))) }),
                ),
                listOf(Goal("Grading a submission, $JOBS at a time", grading.median, MOST_SECONDS, "s")),
            )
        } finally {
            folder.toFile().deleteRecursively()
        }
    }

    private fun name(number: Int) = "course-$number"

    /** Copies of the corpus' own project, in the style of the course's. */
    private fun submissions(folder: Path): List<Path> {
        val project = Home.resolve("tests/submissions/course")
        if (!project.exists()) throw InputError("the project to be graded, $project, is not there: measure in a full checkout.")
        return (1..SUBMISSIONS).map { number -> folder.resolve(name(number)).also { project.toFile().copyRecursively(it.toFile()) } }
    }

    // A GPU's pictures may differ from the approved ones (exit code 1): they take as long.
    private fun golden(launcher: Path) = listOf("sh", "-c", "\"$0\" golden || [ $? = 1 ]", "$launcher")

    // Nothing of an earlier round may be there to be used again.
    private fun grade(
        launcher: Path,
        submissions: List<Path>,
        results: Path,
    ) = listOf("sh", "-c", "rm -rf \"$0\"; exec \"$@\" --out \"$0\"", "$results", "$launcher", "grade") + submissions.map { "$it" } +
        listOf("--jobs", "$JOBS")

    /** Wall seconds of each stage of the submission whose results lie in [folder]. */
    private fun stages(folder: Path): Map<String, Double> {
        val outcome = Json.parseToJsonElement(folder.resolve("outcome.json").readText()).jsonObject
        return outcome.getValue("facts").jsonObject.getValue("seconds").jsonObject.mapValues { it.value.jsonPrimitive.double }
    }

    private fun commandTable(rows: List<SpeedRow>) =
        SpeedTable(
            "Whole commands",
            "In turns, at most $MOST_ROUNDS rounds after one that is not counted. The submission is the corpus' own project in the " +
                "style of the course's; compiling is included, archives and compilers are there already.",
            "",
            listOf("s", "processor s"),
            rows,
        )

    private fun stageTable(submissions: List<Map<String, Double>>) =
        SpeedTable(
            "Stages of grading",
            "By the clock, over the $SUBMISSIONS submissions of the last round, while another one is graded beside.",
            "stage",
            listOf("s"),
            submissions.first().keys.map { stage -> SpeedRow(stage, Sample(submissions.map { it.getValue(stage) })) },
        )
}
