package cga.exercise.components.geometry

import cga.exercise.components.texture.Texture2D
import cga.framework.InputError
import cga.testing.FLOAT_ROUNDING
import cga.testing.assertNear
import cga.testing.turn
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.writeText
import kotlin.math.PI

class ModelLoaderTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `pitch, yaw and roll turn positions and normals, and nothing else`() {
        val plain = mesh(ModelLoader.loadModel(triangle()))
        val turned = mesh(ModelLoader.loadModel(triangle(), 0.3f, -1.2f, 2.5f))
        val expected = turn(0.3f, -1.2f, 2.5f)
        for (vertex in 0 until 3) {
            // The matrix's 8 roundings and 3 of the product, on up to three terms no larger than 3.
            val tolerance = 3 * 3 * 11 * FLOAT_ROUNDING
            assertNear(expected.transform(Vector3d(plain.position(vertex))), turned.position(vertex), tolerance)
            assertNear(expected.transform(Vector3d(plain.normal(vertex))), turned.normal(vertex), tolerance)
            assertEquals(plain.texCoord(vertex), turned.texCoord(vertex))
        }
        assertEquals(listOf(0, 1, 2), turned.indexdata.toList())
    }

    @Test
    fun `a quarter's pitch stands z up on y`() {
        val turned = mesh(ModelLoader.loadModel(triangle(), (-PI / 2).toFloat()))
        // The float quarter's cosine, 4.4e-8, and the rounding of 3.
        assertNear(Vector3f(1f, 3f, -2f), turned.position(2), 8 * FLOAT_ROUNDING)
    }

    @Test
    fun `without maps a material has its colours, and its exponent as it stands in the file`() {
        val mtl = "newmtl m\nKd 1 0 0.2\nKs 0 1 0.2\nKe 0 0 1\nNs 12.5\n"
        val material = mesh(ModelLoader.loadModel(triangle(mtl))).material!!
        assertEquals(listOf(255, 0, 51, 255), texel(material.diff))
        assertEquals(listOf(0, 255, 51, 255), texel(material.specular))
        assertEquals(listOf(0, 0, 255, 255), texel(material.emit))
        assertEquals(12.5f, material.shininess)
    }

    @Test
    fun `an exponent below 0 is a mistake of the file`() {
        val error = assertThrows<InputError> { ModelLoader.loadModel(triangle("newmtl m\nNs -1\n")) }
        assertTrue("model.mtl" in error.message.orEmpty() || "model.obj" in error.message.orEmpty()) { error.message }
    }

    @Test
    fun `maps take the colours' places`() {
        for ((name, color) in listOf("d" to 0xFF0000, "s" to 0x00FF00, "e" to 0x0000FF)) picture("$name.png", color)
        val mtl = "newmtl m\nKd 1 1 1\nKs 1 1 1\nKe 1 1 1\nmap_Kd d.png\nmap_Ks s.png\nmap_Ke e.png\n"
        val material = mesh(ModelLoader.loadModel(triangle(mtl))).material!!
        assertEquals(listOf(255, 0, 0, 255), texel(material.diff))
        assertEquals(listOf(0, 255, 0, 255), texel(material.specular))
        assertEquals(listOf(0, 0, 255, 255), texel(material.emit))
    }

    @Test
    fun `a picture named twice is one texture`() {
        picture("p.png", 0xFF0000)
        val material = mesh(ModelLoader.loadModel(triangle("newmtl m\nmap_Kd p.png\nmap_Ke p.png\n"))).material!!
        assertSame(material.diff, material.emit)
    }

    @Test
    fun `a missing picture is named`() {
        val error = assertThrows<InputError> { ModelLoader.loadModel(triangle("newmtl m\nmap_Kd nowhere.png\n")) }
        assertTrue("nowhere.png" in error.message.orEmpty()) { error.message }
    }

    @Test
    fun `our ground is a plane of 44,8 by 44,8 that faces up`() {
        val ground = mesh(ModelLoader.loadModel("assets/ground/ground.obj"))
        val positions = ground.positions()
        assertEquals(setOf(0f), positions.map { it.y }.toSet())
        assertEquals(
            listOf(-22.4f, 22.4f, -22.4f, 22.4f),
            with(positions) {
                listOf(minOf { it.x }, maxOf { it.x }, minOf { it.z }, maxOf { it.z })
            },
        )
        for (vertex in positions.indices) assertEquals(Vector3f(0f, 1f, 0f), ground.normal(vertex))
        assertEquals(60f, ground.material!!.shininess)
    }

    @Test
    fun `our motorcycle has 10,000 to 40,000 triangles in several materials`() {
        val motorcycle = ModelLoader.loadModel("assets/motorcycle/motorcycle.obj")
        assertTrue(motorcycle.meshes.sumOf { it.indexdata.size / 3 } in 10_000..40_000)
        assertTrue(motorcycle.meshes.size >= 4)
    }

    @Test
    fun `our models are sound`() {
        for (path in listOf("assets/ground/ground.obj", "assets/motorcycle/motorcycle.obj")) {
            for (mesh in ModelLoader.loadModel(path).meshes) {
                val vertexCount = mesh.vertexdata.size / 8
                assertTrue(mesh.indexdata.all { it in 0 until vertexCount })
                // The files give four decimals a coordinate, half a unit of the last off: √3 · 0.00005, and then Assimp's roundings.
                for (vertex in 0 until vertexCount) assertNear(1.0, mesh.normal(vertex).length(), 1e-4, path)
                assertNotInsideOut(mesh, path)
                assertPowersOfTwo(mesh.material!!)
            }
        }
    }

    /** Triangles run counter-clockwise seen from where the normals point to, or culling would hide the outside. */
    private fun assertNotInsideOut(mesh: Mesh, path: String) {
        for (first in mesh.indexdata.indices step 3) {
            val (a, b, c) = List(3) { mesh.indexdata[first + it] }
            val face = (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a))
            val normals = mesh.normal(a).add(mesh.normal(b)).add(mesh.normal(c))
            assertTrue(face.dot(normals) > 0f) { "$path: triangle ${first / 3} of a mesh lies inside out" }
        }
    }

    /** As the mipmaps of [cga.framework.image.TextureImage] want it. */
    private fun assertPowersOfTwo(material: Material) {
        for (texture in listOf(material.diff, material.emit, material.specular)) {
            val level = texture.image.levels.first()
            assertEquals(1 to 1, level.width.countOneBits() to level.height.countOneBits())
        }
    }

    /** A file with one pixel. */
    private fun picture(name: String, color: Int) {
        val image = BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).apply { setRGB(0, 0, color) }
        ImageIO.write(image, "png", folder.resolve(name).toFile())
    }

    /** A file with one triangle whose normals differ. */
    private fun triangle(mtl: String = "newmtl m\n"): String {
        folder.resolve("model.mtl").writeText(mtl)
        val obj =
            """
            mtllib model.mtl
            v 0 0 0
            v 1 0 0
            v 1 2 3
            vt 0 0
            vt 1 0
            vt 0.25 0.5
            vn 1 0 0
            vn 0 1 0
            vn 0 0.6 0.8
            usemtl m
            f 1/1/1 2/2/2 3/3/3
            """.trimIndent()
        return folder.resolve("model.obj").also { it.writeText(obj) }.toString()
    }

    private fun mesh(model: Renderable): Mesh = model.meshes.single()

    private fun texel(texture: Texture2D) =
        texture.image.levels
            .single()
            .rgba
            .map { it.toInt() and 0xFF }

    private fun Mesh.positions() = List(vertexdata.size / 8) { position(it) }

    private fun Mesh.position(vertex: Int) = Vector3f(vertexdata[8 * vertex], vertexdata[8 * vertex + 1], vertexdata[8 * vertex + 2])

    private fun Mesh.texCoord(vertex: Int) = vertexdata[8 * vertex + 3] to vertexdata[8 * vertex + 4]

    private fun Mesh.normal(vertex: Int) = Vector3f(vertexdata[8 * vertex + 5], vertexdata[8 * vertex + 6], vertexdata[8 * vertex + 7])

    private operator fun Vector3f.minus(other: Vector3f) = sub(other, Vector3f())
}
