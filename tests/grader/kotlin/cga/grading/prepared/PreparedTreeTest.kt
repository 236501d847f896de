package cga.grading.prepared

import cga.framework.InputError
import cga.grading.submission.MadeUp
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.deleteExisting
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.random.Random

/** What is believed of a job that has read a submission. */
class PreparedTreeTest {
    @TempDir
    lateinit var folder: Path

    private lateinit var tree: PreparedTree
    private val manifest get() = tree.folder.resolve("manifest")

    @BeforeEach
    fun prepare() {
        val umlaut = "src/main/kotlin/cga/exercise/Größe 2.kt" to "package cga.exercise\nfun main() { Game() }\n"
        val java = "src/main/java/Greeter.java" to "/*\npackage .tmp.x\n*/ package cga.exercise;\nclass Greeter { }\n"
        tree = MadeUp.prepare(folder, MadeUp.FILES - "src/main/kotlin/cga/exercise/Main.kt" + umlaut + java)
    }

    @Test
    fun `all that matters arrives, under names of ours`() {
        assertEquals("cga.exercise.Gr__e_2Kt", tree.manifest.mainClass)
        assertEquals("1.3.72", tree.manifest.kotlin)
        assertEquals(listOf("0000/Greeter.java", "0001/Gr__e_2.kt"), tree.manifest.sources.take(2).map { it.file })
        assertEquals("src/main/kotlin/cga/exercise/Größe 2.kt", tree.manifest.sources[1].name)
        assertEquals(listOf("GameWindow.kt (our stand-in)"), tree.manifest.sources.filter { it.isOurs }.map { it.name })
        assertTrue(tree.manifest.sources.none { "framework/GameWindow" in it.name })
        val scene = tree.manifest.sources.single { it.name.endsWith("Scene.kt") }
        assertEquals(MadeUp.SCENE, tree.files().getValue(scene).readText())
        assertTrue("class Scene(private val window: GameWindow)" in tree.files(setOf(scene)).getValue(scene).readText())
        assertTrue(tree.manifest.sources[0] !in tree.files(tree.manifest.sources.toSet()))
    }

    @Test
    fun `names that are not ours are refused`() {
        for (file in listOf("../0000/a.kt", "0000/../a.kt", "0001/a.kt", "0000/a.sh", "/0000/a.kt", "0000/a b.kt", "0000/")) {
            refused(
                file,
                "Main",
            )
        }
        for (name in listOf("-jar", "a..B", "", "a/B", "a.B\u0000", "a.B ")) refused("0000/a.kt", name)
        PreparedTree.write(prepared("0000/Greeter.java", "a.B"), tree.folder)
        assertEquals("a.B", PreparedTree.read(tree.folder).manifest.mainClass)
    }

    @Test
    fun `what is no version of a library is none`() {
        val build = "kotlin_version = '1.${"9".repeat(2000)}'\nimplementation 'a:..:1'\nimplementation 'a:b:1${".1".repeat(2000)}'\n"
        val manifest = MadeUp.prepare(folder.resolve("odd"), MadeUp.FILES + ("build.gradle" to build)).manifest
        assertEquals(null, manifest.kotlin)
        assertEquals(emptyList<NamedLibrary>(), manifest.libraries)
    }

    private fun refused(file: String, main: String) {
        PreparedTree.write(prepared(file, main), tree.folder)
        assertThrows(InputError::class.java) { PreparedTree.read(tree.folder) }
    }

    private fun prepared(file: String, main: String) =
        Prepared(Kind.COURSE, Edition.ALL.first(), main, null, emptyList(), listOf(PreparedSource("x", file)), emptyList())

    @Test
    fun `coordinates of a library cannot lead anywhere`() {
        val (sound, other) = listOf("org.joml", "lwjgl-openal", "1.10.9", "2.8.6-rc_1").to(
            listOf("", ".", "..", "a..b", ".a", "a.", "a/b", "a:b", "a b", "ä", "1".repeat(101), "1.".repeat(20_000) + "1"),
        )
        assertEquals(sound, (sound + other).filter(PreparedTree::isCoordinate))
    }

    @Test
    fun `a link in place of a file or a folder is not followed`() {
        val source = tree.files().values.first()
        val other = folder.resolve("other").apply { writeText("secret") }
        source.deleteExisting()
        source.createSymbolicLinkPointingTo(other)
        assertThrows(InputError::class.java) { PreparedTree.read(tree.folder) }
    }

    @Test
    fun `a damaged manifest is an error and nothing else`() {
        val whole = manifest.readBytes()
        val random = Random(27)
        repeat(TRIES) {
            val bytes = whole.copyOf(if (it % 2 == 0) whole.size else random.nextInt(whole.size))
            repeat(random.nextInt(1, 5)) { if (bytes.isNotEmpty()) bytes[random.nextInt(bytes.size)] = random.nextInt().toByte() }
            manifest.writeBytes(bytes)
            try {
                PreparedTree.read(tree.folder)
            } catch (_: InputError) {
                // As it has to be.
            }
        }
    }

    private companion object {
        const val TRIES = 3000
    }
}
