package cga.grading.pipeline

import cga.framework.Home
import cga.grading.submission.MadeUp
import cga.grading.submission.SubmissionReader
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.walk
import kotlin.io.path.writeText

/** What a submission names and does not bring along. */
class RunFolderTest {
    @TempDir
    lateinit var folder: Path

    private val handedIn get() = folder.resolve("submission")

    /** A submission whose scene names [paths], with the files [files] besides. */
    private fun start(paths: List<String>, files: Map<String, String> = emptyMap()): RunFolder {
        val scene = MadeUp.SCENE.replace("println(", paths.joinToString("\n") { "load(\"$it\")" } + "\nprintln(")
        MadeUp.write(handedIn, MadeUp.FILES + ("src/main/kotlin/cga/exercise/game/Scene.kt" to scene) + files)
        return RunFolder(SubmissionReader.read(handedIn, folder.resolve("unused")), folder.resolve("links"))
    }

    private fun ours(path: String) = Home.resolve("assets/$path").readBytes()

    @Test
    fun `where nothing is missing, the submission starts in its own folder`() {
        val run = start(listOf("assets/shaders/tron_vert.glsl", "assets/a.png"), mapOf("assets/a.png" to "a"))
        assertEquals(handedIn.toRealPath(), run.folder)
        assertEquals(emptyList<String>(), run.notes)
    }

    @Test
    fun `a missing texture is one of ours of the same role, and all else is the submission's own`() {
        val names = listOf("assets/textures/Ground_Emit.png", "assets/textures/bike_spec.jpg", "assets/textures/there.png")
        val run = start(names, mapOf("assets/textures/there.png" to "own"))
        assertArrayEquals(ours("ground/ground_emissive.png"), run.folder.resolve(names[0]).readBytes())
        assertArrayEquals(ours("motorcycle/body_specular.png"), run.folder.resolve(names[1]).readBytes())
        assertEquals("own", run.folder.resolve(names[2]).readText())
        assertEquals(MadeUp.FILES.getValue("assets/shaders/tron_vert.glsl"), run.folder.resolve("assets/shaders/tron_vert.glsl").readText())
        assertEquals(names.take(2).map { "$it is missing: a file of ours stands in for it." }, run.notes)
        assertFalse(handedIn.resolve(names[0]).exists(), "the submission was touched")
    }

    @Test
    fun `upper and lower case may differ, as on the student's computer, for folders too`() {
        val run = start(
            listOf("assets/Models/Bike.obj", "assets/Shaders/Tron_Vert.glsl"),
            mapOf("assets/models/bike.obj" to "mtllib bike.mtl\n", "assets/models/bike.mtl" to "map_Kd paint.png\n"),
        )
        assertEquals("mtllib bike.mtl\n", run.folder.resolve("assets/Models/Bike.obj").readText())
        assertTrue(run.folder.resolve("assets/Models/bike.mtl").exists())
        // Named by the material only.
        assertArrayEquals(ours("motorcycle/body_diffuse.png"), run.folder.resolve("assets/Models/paint.png").readBytes())
        assertTrue(run.folder.resolve("assets/Shaders/Tron_Vert.glsl").exists())
        assertEquals("assets/Models/Bike.obj is meant to be assets/models/bike.obj: upper and lower case differ.", run.notes.first())
    }

    @Test
    fun `a missing model comes with its material and textures, a missing material with the names that its model uses`() {
        val names = listOf("assets/Light Cycle/cycle.obj", "assets/house.obj")
        val run = start(names, mapOf("assets/house.obj" to "mtllib house.mtl\nusemtl wall\nusemtl roof\n"))
        assertArrayEquals(ours("motorcycle/motorcycle.obj"), run.folder.resolve(names[0]).readBytes())
        assertTrue(run.folder.resolve("assets/Light Cycle/motorcycle.mtl").exists())
        assertTrue(run.folder.resolve("assets/Light Cycle/tyre_diffuse.png").exists())
        val material = run.folder.resolve("assets/house.mtl").readText()
        assertEquals(listOf("wall", "roof"), Regex("newmtl (\\w+)").findAll(material).map { it.groupValues[1] }.toList())
        assertTrue(run.folder.resolve("assets/body_diffuse.png").exists())
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
    fun `links of a submission are not followed`() {
        val secret = folder.resolve("secret").createDirectories()
        secret.resolve("bike.obj").writeText("mtllib named-in-secret.mtl\n")
        handedIn.resolve("assets").createDirectories().resolve("models").createSymbolicLinkPointingTo(secret)
        val run = start(listOf("assets/models/bike.obj", "assets/models/bike.png", "assets/missing.png"))
        assertTrue(run.notes.none { "named-in-secret" in it }) { "${run.notes}" }
        assertEquals(listOf("bike.obj"), secret.walk().map { "${it.fileName}" }.toList(), "something was written beyond the link")
    }
}
