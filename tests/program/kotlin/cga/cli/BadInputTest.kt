package cga.cli

import cga.testing.CgaProcess
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestInstance
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import java.nio.file.Files
import java.nio.file.Path
import java.util.stream.Stream
import kotlin.io.path.createDirectory
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/**
 * The program as its users start it, with something wrong: it ends with exit code 2 and one message that names the file or the value and
 * the cure, without a stack trace, and leaves nothing behind.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Slow
class BadInputTest {
    /** The program's shaders and assets, one of them broken at a time. */
    private lateinit var home: Path

    /** Where the program is started, which must stay empty. */
    private lateinit var folder: Path

    @BeforeAll
    fun `copy shaders and assets`(
        @TempDir home: Path,
        @TempDir folder: Path,
    ) {
        this.home = home
        this.folder = folder
        for (name in listOf("shaders", "assets")) projectRoot.resolve(name).copyRecursively(home.resolve(name).toFile())
    }

    @ParameterizedTest
    @MethodSource("wrongArguments")
    fun `a wrong argument`(case: Arguments) = assertRefused(case.args, *case.parts)

    @ParameterizedTest
    @MethodSource("brokenFiles")
    fun `a broken file`(case: Broken) {
        val file = home.resolve(case.path)
        val sound = file.readBytes()
        try {
            case.breakIt(file)
            assertRefused(RENDER, case.named, *case.parts)
        } finally {
            file.toFile().deleteRecursively()
            file.writeBytes(sound)
        }
    }

    @Test
    fun `an unreadable file`() {
        // Linux answers an input/output error for the first page of a process's memory, to root too.
        val unreadable = Path.of("/proc/self/mem")
        assumeTrue(unreadable.exists())
        for (path in listOf("shaders/scene.vert", "assets/ground/ground.obj", "assets/ground/ground_diffuse.png")) {
            val file = home.resolve(path)
            val sound = file.readBytes()
            file.deleteExisting()
            file.createSymbolicLinkPointingTo(unreadable)
            try {
                assertRefused(RENDER, "$file", "cannot be read", "permissions")
            } finally {
                file.deleteExisting()
                file.writeBytes(sound)
            }
        }
    }

    @Test
    fun `a pipe that nobody writes to`(
        @TempDir place: Path,
    ) {
        val pipe = place.resolve("pipe")
        assumeTrue(runCatching { ProcessBuilder("mkfifo", "$pipe").start().waitFor() }.getOrNull() == 0)
        for (args in listOf(
            listOf("replay", "$pipe"),
            listOf("diff", "$pipe", "$pipe"),
        )) {
            assertRefused(args, "$pipe", "is not a plain file")
        }
    }

    @Test
    fun `an output that cannot be written`() {
        for (option in listOf("--out", "--float")) {
            assertRefused(RENDER + listOf(option, "missing/picture"), "missing", "does not exist", "Create it")
            assertRefused(RENDER + listOf(option, "$home"), "$home", "is a folder")
        }
        // In a folder that promises to be writable and is not, even to root.
        assumeTrue(Files.isWritable(Path.of("/proc")))
        assertRefused(RENDER + listOf("--out", "/proc/picture.png"), "/proc/picture.png", "read-only")
    }

    @Test
    fun `a failure keeps the picture that was there`() {
        val picture = folder.resolve("picture.png")
        picture.writeText("old")
        val frag = home.resolve("shaders/scene.frag")
        val sound = frag.readText()
        frag.writeText("no GLSL")
        val process = run(RENDER + listOf("--out", "picture.png"))
        frag.writeText(sound)
        assertEquals(2, process.exitCode, "$process")
        assertEquals("old", picture.readText())
        picture.deleteExisting()
    }

    private fun run(args: List<String>) =
        CgaProcess.cga(*args.toTypedArray(), directory = folder, home = home, env = mapOf("DISPLAY" to null, "WAYLAND_DISPLAY" to null))

    private fun assertRefused(
        args: List<String>,
        vararg parts: String,
    ) {
        val process = run(args)
        assertEquals(2, process.exitCode, "$args: $process")
        // The usage errors' text is wrapped to the terminal's width.
        val message = process.err.replace(Regex("\\s+"), " ")
        for (part in parts) assertTrue(part in message, "'$part' is missing: $process")
        assertEquals(1, Regex("cga: |Error: |Usage: cga \\[").findAll(process.err).count { "Usage" !in it.value }, "one message: $process")
        assertTrue(STACK_TRACE !in process.err, "a stack trace: $process")
        assertEquals("", process.out.trim(), "something on stdout")
        assertEquals(emptyList<Path>(), folder.listDirectoryEntries(), "left behind by $args")
    }

    class Arguments(
        val args: List<String>,
        vararg val parts: String,
    ) {
        override fun toString() = args.joinToString(" ").take(80)
    }

    class Broken(
        val path: String,
        private val what: String,
        vararg val parts: String,
        val named: String = path.substringAfterLast('/'),
        val breakIt: (Path) -> Unit,
    ) {
        override fun toString() = "$path: $what"
    }

    private companion object {
        val RENDER = listOf("render", "--size", "16x9")
        val STACK_TRACE = Regex("""Exception in thread|^\s+at [\w.$]+\(""", RegexOption.MULTILINE)

        fun render(
            option: String,
            value: String,
            vararg parts: String,
        ) = Arguments(listOf("render", option, value), *parts)

        @JvmStatic
        fun wrongArguments(): Stream<Arguments> =
            Stream.of(
                Arguments(listOf("fly"), "fly"),
                Arguments(listOf("render", "--fly"), "--fly"),
                Arguments(listOf("render", "fly"), "fly"),
                Arguments(listOf("render", "--size"), "--size"),
                render("--step", "4.8", "4.8", "4.1, 4.2, 4.3, 4.3.4, 4.4, 4.5, 4.6, 4.7"),
                render("--size", "0x9", "0x9", "1280x720"),
                render("--size", "16x0", "16x0", "1280x720"),
                render("--size", "-1x9", "-1x9", "1280x720"),
                render("--size", "big", "big", "1280x720"),
                render("--size", "99999999999999999999x9", "99999999999999999999x9", "1280x720"),
                render("--size", "999999999x9", "999999999x9", "1x1 to"),
                render("--samples", "-1", "-1", "negative"),
                render("--samples", "many", "many"),
                render("--samples", "1000", "1000 samples", "this driver has 0 to"),
                render("--t", "-1", "-1", "not negative"),
                render("--t", "NaN", "NaN"),
                render("--t", "1e999", "finite"),
                render("--t", "noon", "noon"),
                render("--mouse", "Infinity", "Infinity", "finite"),
                render("--drive", "W", "\"W\"", "as in"),
                render("--drive", "W 1, X 2", "\"X 2\"", "as in"),
                render("--drive", "W 99999999", "9.9999999E7", "3600"),
                render("--drive", "W 1" + "0".repeat(400), "as in"),
                render("--gamma", "0", "gamma"),
                render("--gamma", "1e-45", "gamma"),
                render("--frames", "0", "0", "1 to"),
                render("--fps", "0", "greater than 0"),
                Arguments(listOf("render", "--frames", "2", "--fps", "1e-320"), "1.0E-320", "infinite"),
                render("--context", "vulkan", "vulkan", "osmesa, egl, window"),
                render("--context", "window", "no display", "xvfb-run"),
                render("--specular", "matt", "matt", "blinn-phong"),
                render("--out", "x".repeat(300), "File name too long"),
                render("--out", "x.jpg", "x.jpg", ".png or .apng"),
                render("--out", "", "name", "is empty"),
                render("--float", "x.png", "x.png", ".exr"),
                Arguments(listOf("diff", "", "x.png"), "name of the picture file is empty"),
            )

        @JvmStatic
        fun brokenFiles(): Stream<Broken> =
            Stream.of(
                Broken("shaders/scene.vert", "missing", "does not exist", "put the file there") { it.deleteExisting() },
                Broken("shaders/scene.vert", "a folder", "is a folder") {
                    it.deleteExisting()
                    it.createDirectory()
                },
                Broken("shaders/scene.vert", "no GLSL", "scene.vert:1: error", "this is no GLSL") { it.writeText("this is no GLSL") },
                Broken("shaders/scene.frag", "an undeclared name", "scene.frag:", "error", "fragColor = vec4(colour") {
                    it.change("vec4(inverseGamma", "vec4(colour, inverseGamma")
                },
                Broken(
                    "shaders/scene.vert",
                    "an output that the fragment shader has otherwise",
                    "scene.frag",
                    "do not fit together",
                    "surfaceTexCoord",
                ) {
                    it.change(
                        "out vec2 surfaceTexCoord",
                        "out vec4 surfaceTexCoord",
                        "surfaceTexCoord = texCoord * tcMultiplier",
                        "surfaceTexCoord = vec4(texCoord * tcMultiplier, 0.0, 0.0)",
                    )
                },
                Broken("assets/ground/ground.obj", "missing", "does not exist", "put the file there") { it.deleteExisting() },
                Broken("assets/ground/ground.obj", "empty", "not a readable model", "export it again") { it.writeText("") },
                Broken("assets/ground/ground.obj", "half a line at the end", "not a readable model", "export it again") {
                    it.writeBytes(it.readBytes().copyOf(9000))
                },
                Broken("assets/ground/ground.obj", "a face of vertices that are not there", "not a readable model", "export it again") {
                    it.writeText(it.readText() + "f 1/1/1 2/2/1 99999/1/1\n")
                },
                Broken("assets/ground/ground.mtl", "missing", "does not exist", "put the file there") { it.deleteExisting() },
                Broken(
                    "assets/ground/ground.mtl",
                    "another material",
                    "uses the material ground",
                ) { it.change("newmtl ground", "newmtl lawn") },
                Broken("assets/ground/ground.mtl", "a negative shininess", "Ns -60", "export it again", named = "ground.obj") {
                    it.change("Ns 60", "Ns -60")
                },
                Broken("assets/ground/ground_diffuse.png", "missing", "does not exist", "put the file there") { it.deleteExisting() },
                Broken("assets/ground/ground_diffuse.png", "half", "not a readable picture", "save it again as PNG") {
                    it.writeBytes(it.readBytes().copyOf(2000))
                },
                Broken(
                    "assets/motorcycle/body_emissive.png",
                    "no picture",
                    "not a readable picture",
                    "save it again as PNG",
                ) { it.writeText("PNG") },
            )

        fun Path.change(vararg replacements: String) {
            val changed = replacements.toList().chunked(2).fold(readText()) { text, (old, new) -> text.replace(old, new) }
            check(changed != readText()) { "$this has nothing to replace" }
            writeText(changed)
        }
    }
}
