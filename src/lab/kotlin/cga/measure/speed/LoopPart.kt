package cga.measure.speed

import cga.framework.Home
import cga.measure.start.Interleaved
import java.io.File
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.name
import kotlin.io.path.walk

/** From an edit to its picture, in copies of the project, and what the first use costs. */
internal object LoopPart {
    /** A round compiles the whole program anew. */
    private const val MOST_ROUNDS = 5

    private const val UNCHANGED = "nothing changed"
    private const val SHADER = "a shader changed"
    private const val MAVEN = "a line of Scene.kt changed, Maven"
    private const val GRADLE = "a line of Scene.kt changed, Gradle's daemon"
    private const val FIRST = "first use of `run`, Maven"
    private const val ALL = "all parts compiled anew by Maven, as before there were parts"
    private const val KOTLINC = "`kotlinc` on the sources of the part scene"

    // What may be missed by: the machine's noise.
    private const val MOST_SHADER = 1.1
    private const val MOST_MAVEN = 6.0
    private const val MOST_GRADLE = 4.0
    private const val MOST_FIRST = 45.0

    /** What of a checkout the launcher needs. */
    private val FILES =
        listOf("cga", "src", "shaders", "assets", "gradle", "pom.xml", "build.gradle.kts", "settings.gradle.kts", "gradle.properties") +
            listOf(".mvn", "tests/program/pom.xml", "tests/program/build.gradle.kts")

    // The time makes each edit another one.
    private const val EDIT = "echo \"private const val EDITED_\$(date +%s%N) = 1\" >>src/scene/kotlin/cga/exercise/game/Scene.kt"
    private const val RENDER = "./cga render --out picture.png"
    private const val BUILD_ALL = "mvn -q -B -o -DwithoutTests -Dmaven.test.skip=true -Dkotlin.compiler.incremental=false package"

    fun measure(settings: SpeedSettings): SpeedSection {
        LauncherJvm.launcher()
        val folder = createTempDirectory("cga-loop")
        try {
            val times = Interleaved.time(commands(folder), minOf(settings.runs, MOST_ROUNDS))
            val table =
                SpeedTable(
                    "From an edit to its picture",
                    "A picture of 1280×720 from the command to its end, in turns, after a round that is not counted; the last three only " +
                        "compile. What a daemon computes counts in the first column only.",
                    "",
                    listOf("s", "processor s"),
                    times.map { (name, time) -> SpeedRow(name, time.seconds, time.processorSeconds) },
                )
            val seconds = times.mapValues { it.value.seconds.median }
            val goals =
                listOfNotNull(
                    Goal("An edit of Scene.kt to its picture with Maven", seconds.getValue(MAVEN), MOST_MAVEN, "s"),
                    seconds[GRADLE]?.let { Goal("The same with Gradle's daemon", it, MOST_GRADLE, "s") },
                    Goal("A changed shader", seconds.getValue(SHADER) / seconds.getValue(UNCHANGED), MOST_SHADER, "times an unchanged one"),
                    Goal("First use of `run`, downloads apart", times.getValue(FIRST).processorSeconds.median, MOST_FIRST, "processor s"),
                )
            return SpeedSection(listOf(table), goals)
        } finally {
            folder.toFile().deleteRecursively()
        }
    }

    private fun commands(folder: Path): Map<String, List<String>> {
        val same = copy(folder.resolve("same"))
        val maven = copy(folder.resolve("maven"))
        val first = copy(folder.resolve("first"))
        val all = copy(folder.resolve("all"))
        val gradle = if (isOnPath("gradle")) copy(folder.resolve("gradle")) else null
        val compiler = compiler()
        return buildMap {
            // Not where the classes change: the second start after a build makes the archive of classes.
            put(UNCHANGED, shell(same, RENDER))
            put(SHADER, shell(same, "echo '// edited' >>shaders/scene.frag && $RENDER"))
            put(MAVEN, shell(maven, "$EDIT && $RENDER"))
            if (gradle != null) put(GRADLE, shell(gradle, "$EDIT && $RENDER", "gradle"))
            put(FIRST, shell(first, "rm -rf build target && env -u DISPLAY -u WAYLAND_DISPLAY ./cga run"))
            put(ALL, shell(all, "rm -rf target && $BUILD_ALL"))
            if (compiler.isNotEmpty()) put(KOTLINC, shell(maven, kotlinc(compiler)))
        }
    }

    private fun copy(folder: Path): Path {
        for (name in FILES) Home.resolve(name).toFile().copyRecursively(folder.resolve(name).toFile())
        folder.resolve("cga").toFile().setExecutable(true)
        return folder
    }

    private fun shell(
        folder: Path,
        command: String,
        tool: String = "maven",
    ) = listOf("sh", "-c", "cd \"$folder\" && export CGA_BUILD=$tool && $command")

    private fun isOnPath(program: String) = System.getenv("PATH").split(File.pathSeparator).any { File(it, program).canExecute() }

    /** The jars of Maven's Kotlin compiler, of the version that this program was compiled with; empty where Maven has none. */
    private fun compiler(): List<Path> {
        val repository = Path.of(System.getProperty("user.home"), ".m2", "repository", "org", "jetbrains")
        if (!repository.exists()) return emptyList()
        val needed =
            Regex(
                "(kotlin-(compiler-embeddable|stdlib|script-runtime|daemon-embeddable)-${KotlinVersion.CURRENT}|" +
                    "kotlinx-coroutines-core-jvm-.*|annotations-.*)\\.jar",
            )
        val jars = repository.walk().filter { it.extension == "jar" && needed.matches(it.name) }.toList()
        return if (jars.any { it.name.startsWith("kotlin-compiler-embeddable") }) jars else emptyList()
    }

    private fun kotlinc(compiler: List<Path>): String {
        val classPath = "\$(ls build/cga/lib/*.jar | grep -v /cga- | tr '\\n' ':')"
        return "java -cp \"${compiler.joinToString(File.pathSeparator)}\" org.jetbrains.kotlin.cli.jvm.K2JVMCompiler " +
            "-no-stdlib -no-reflect -nowarn -d classes -cp \"$classPath\" src/scene/kotlin"
    }
}
