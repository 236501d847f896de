package cga.grading.submission

import cga.framework.Home
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.RandomAccessFile
import java.nio.file.Path
import kotlin.io.path.PathWalkOption
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.exists
import kotlin.io.path.isSymbolicLink
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.relativeTo
import kotlin.io.path.walk
import kotlin.io.path.writeText

/** What a submission names and does not bring along. */
class RunFolderTest {
    @TempDir
    lateinit var folder: Path

    private val started get() = folder.resolve("start")
    private val handedIn get() = folder.resolve("submission")

    /** A submission whose scene names [paths], with the files [files] besides. */
    private fun start(paths: List<String>, files: Map<String, String> = emptyMap()): RunFolder {
        val scene = MadeUp.SCENE.replace("println(", paths.joinToString("\n") { "load(\"$it\")" } + "\nprintln(")
        MadeUp.write(handedIn, MadeUp.FILES + ("src/main/kotlin/cga/exercise/game/Scene.kt" to scene) + files)
        return RunFolder(SubmissionReader.read(handedIn, folder.resolve("unused")), folder.resolve("start"))
    }

    private fun ours(path: String) = Home.resolve("assets/$path").readBytes()

    @Test
    fun `where nothing is missing, the submission starts in a copy of its own folder`() {
        val run = start(listOf("assets/shaders/tron_vert.glsl", "assets/a.png"), mapOf("assets/a.png" to "a"))
        assertEquals(handedIn.walk().map { it.relativeTo(handedIn) }.toSet(), started.walk().map { it.relativeTo(started) }.toSet())
        assertEquals(emptyList<String>(), run.notes)
    }

    @Test
    fun `a missing texture is one of ours of the same role, and all else is the submission's own`() {
        val names = listOf("assets/textures/Ground_Emit.png", "assets/textures/bike_spec.jpg", "assets/textures/there.png")
        val run = start(names, mapOf("assets/textures/there.png" to "own"))
        assertArrayEquals(ours("ground/ground_emissive.png"), started.resolve(names[0]).readBytes())
        assertArrayEquals(ours("motorcycle/body_specular.png"), started.resolve(names[1]).readBytes())
        assertEquals("own", started.resolve(names[2]).readText())
        assertEquals(MadeUp.FILES.getValue("assets/shaders/tron_vert.glsl"), started.resolve("assets/shaders/tron_vert.glsl").readText())
        assertEquals(names.take(2).map { "$it is missing: a file of ours stands in for it." }, run.notes)
        assertFalse(handedIn.resolve(names[0]).exists(), "the submission was touched")
    }

    @Test
    fun `upper and lower case may differ, as on the student's computer, for folders too`() {
        val run = start(
            listOf("assets/Models/Bike.obj", "assets/Shaders/Tron_Vert.glsl"),
            mapOf("assets/models/bike.obj" to "mtllib bike.mtl\n", "assets/models/bike.mtl" to "map_Kd paint.png\n"),
        )
        assertEquals("mtllib bike.mtl\n", started.resolve("assets/Models/Bike.obj").readText())
        assertTrue(started.resolve("assets/Models/bike.mtl").exists())
        // Named by the material only.
        assertArrayEquals(ours("motorcycle/body_diffuse.png"), started.resolve("assets/Models/paint.png").readBytes())
        assertTrue(started.resolve("assets/Shaders/Tron_Vert.glsl").exists())
        assertEquals("assets/Models/Bike.obj is meant to be assets/models/bike.obj: upper and lower case differ.", run.notes.first())
    }

    @Test
    fun `a missing model comes with its material and textures, a missing material with the names that its model uses`() {
        val names = listOf("assets/Light Cycle/cycle.obj", "assets/house.obj")
        val run = start(names, mapOf("assets/house.obj" to "mtllib house.mtl\nusemtl wall\nusemtl roof\n"))
        assertArrayEquals(ours("motorcycle/motorcycle.obj"), started.resolve(names[0]).readBytes())
        assertTrue(started.resolve("assets/Light Cycle/motorcycle.mtl").exists())
        assertTrue(started.resolve("assets/Light Cycle/tyre_diffuse.png").exists())
        val material = started.resolve("assets/house.mtl").readText()
        assertEquals(listOf("wall", "roof"), Regex("newmtl (\\w+)").findAll(material).map { it.groupValues[1] }.toList())
        assertTrue(started.resolve("assets/body_diffuse.png").exists())
    }

    @Test
    fun `a shader, a comment, a path that is put together and one that leads elsewhere are left alone`() {
        val note = "package cga.exercise\n// \"assets/old.png\"\n"
        val run = start(
            listOf("assets/shaders/none.glsl", "../a/b.png", "/etc/b.png", "C:/b/c.png", "\$dir/a.png", "b.png", "textures/x.png"),
            mapOf("assets/textures/x.png" to "x", "src/main/kotlin/cga/exercise/Note.kt" to note),
        )
        assertEquals(emptyList<String>(), run.notes)
    }

    @Test
    fun `links that lead out of a submission stay behind, those within it become what they lead to`() {
        val secret = folder.resolve("secret").createDirectories()
        secret.resolve("bike.obj").writeText("mtllib named-in-secret.mtl\n")
        val assets = handedIn.resolve("assets").createDirectories()
        assets.resolve("models").createSymbolicLinkPointingTo(secret)
        assets.resolve("b.png").createSymbolicLinkPointingTo(folder.resolve("beyond.png"))
        assets.resolve("again").createSymbolicLinkPointingTo(assets)
        handedIn.resolve("shared").createDirectories().resolve("own.png").writeText("own")
        assets.resolve("textures").createSymbolicLinkPointingTo(handedIn.resolve("shared"))
        val run = start(listOf("assets/models/bike.obj", "assets/models/bike.png", "assets/b.png", "assets/textures/own.png"))
        assertTrue(run.notes.none { "named-in-secret" in it }) { "${run.notes}" }
        assertEquals("own", started.resolve("assets/textures/own.png").readText())
        assertArrayEquals(ours("motorcycle/body_diffuse.png"), started.resolve("assets/b.png").readBytes())
        assertFalse(folder.resolve("beyond.png").exists(), "written beyond the link")
        assertEquals(listOf("bike.obj"), secret.walk().map { "${it.fileName}" }.toList(), "something was written beyond the link")
        assertTrue(started.walk(PathWalkOption.INCLUDE_DIRECTORIES).none { it.isSymbolicLink() })
    }

    @Test
    fun `what is too large is left out, and all else is there`() {
        handedIn.resolve("assets").createDirectories()
        RandomAccessFile(handedIn.resolve("assets/huge.bin").toFile(), "rw").use { it.setLength(30L shl 30) }
        val run = start(listOf("assets/a.png"), mapOf("assets/a.png" to "a"))
        assertEquals("a", started.resolve("assets/a.png").readText())
        assertTrue("assets/huge.bin was left out" in run.notes.single()) { "${run.notes}" }
    }
}
