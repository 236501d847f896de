package cga.framework.cooked

import cga.framework.image.CookedTexture
import cga.framework.image.ImageData
import cga.framework.image.TextureImage
import cga.framework.model.CookedModel
import cga.framework.model.MaterialData
import cga.framework.model.MeshData
import cga.framework.model.ModelData
import cga.testing.CgaProcess
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.projectRoot
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.random.Random

@Slow
class CookedSceneTest {
    @Test
    fun `a model keeps every bit`() {
        val odd = floatArrayOf(-0f, Float.MIN_VALUE, 1 / 3f, Float.MAX_VALUE, 0f, 1f, 2f, 3f)
        val material = MaterialData("Lack, grün", Vector3f(0.1f), Vector3f(-0f), Vector3f(3f, 2f, 1f), 60f, "C:\\bild.png", null, "")
        val model = ModelData(listOf(MeshData(odd, intArrayOf(0, 0, 0), material), MeshData(FloatArray(0), IntArray(0), material)))
        val read = CookedModel.decode(CookedModel.encode(model))
        assertEquals(model.meshes.map(::content), read.meshes.map(::content))
    }

    @Test
    fun `a texture keeps every level`() {
        val texture = TextureImage(ImageData(6, 3, Random(1).nextBytes(4 * 6 * 3)), true)
        val read = CookedTexture.decode(CookedTexture.encode(texture))
        assertEquals(listOf(6 to 3, 3 to 1, 1 to 1), read.levels.map { it.width to it.height })
        for ((level, same) in texture.levels zip read.levels) assertArrayEquals(level.rgba, same.rgba)
    }

    /** The whole way: the program's own pictures, with the scene from its sources and cooked. */
    @Test
    fun `a cooked scene is the same picture, and a damaged or outdated one is made again`(
        @TempDir folder: Path,
    ) {
        Offscreen.openOrSkip().close()
        val cooked = folder.resolve("cooked")
        val home = folder.resolve("home")
        for (part in listOf("assets", "shaders")) projectRoot.resolve(part).copyRecursively(home.resolve(part).toFile())

        fun render(name: String): List<Byte> {
            val picture = folder.resolve("$name.png")
            val args = arrayOf("render", "--size", "64x36", "--out", "$picture")
            val env = if (name == "plain") emptyMap() else mapOf("JAVA_TOOL_OPTIONS" to "-Dcga.cooked=$cooked")
            val ended = CgaProcess.cga(*args, directory = folder, home = home, env = env)
            assertEquals(0, ended.exitCode, "$ended")
            return picture.readBytes().asList()
        }
        val plain = render("plain")
        assertTrue(plain == render("cooking"))
        val files = cooked.listDirectoryEntries()
        assertEquals(2 + 24, files.size)
        assertTrue(plain == render("cooked"))
        val body = files.single { "body_emissive" in "$it" }
        val whole = body.readBytes()
        body.writeBytes(whole.copyOf(whole.size / 2))
        assertTrue(plain == render("damaged"))
        assertTrue(whole.contentEquals(body.readBytes()))
        home.resolve("assets/ground/ground_emissive.png").writeBytes(home.resolve("assets/ground/ground_diffuse.png").readBytes())
        assertTrue(plain != render("changed"))
    }

    private fun content(mesh: MeshData): List<Any?> =
        with(mesh.material) {
            listOf(name, diffuse, specular, emissive, shininess, diffuseMap, specularMap, emissiveMap) +
                mesh.vertices.map { it.toRawBits() } + mesh.indices.asList()
        }
}
