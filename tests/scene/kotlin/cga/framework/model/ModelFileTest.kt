package cga.framework.model

import cga.framework.InputError
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createDirectory
import kotlin.io.path.deleteExisting
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.random.Random

class ModelFileTest {
    @TempDir
    private lateinit var folder: Path
    private val obj get() = folder.resolve("model.obj")
    private val mtl get() = folder.resolve("model.mtl")

    @Test
    fun `positions, texture coordinates and normals of a triangle`() {
        write(OBJ)
        val mesh = ModelFile.read("$obj").meshes.single()
        val expected =
            setOf(
                listOf(0f, 0f, 0f, 0f, 0f, 0f, 0f, 1f),
                listOf(1f, 0f, 0f, 1f, 0f, 0f, 1f, 0f),
                listOf(1f, 2f, -3f, 0.5f, 0.25f, 1f, 0f, 0f),
            )
        assertEquals(expected, mesh.vertices.toList().chunked(8).toSet())
        assertEquals(expected.toList(), mesh.indices.map { mesh.vertices.toList().chunked(8)[it] }, "the corners' order")
    }

    @Test
    fun `a polygon becomes triangles and equal corners are shared`() {
        write(OBJ + "v 0 2 -3\nf 1/1/1 2/2/1 3/3/1 4/1/1\n")
        val mesh = ModelFile.read("$obj").meshes.single()
        assertEquals(3 + 6, mesh.indices.size)
        assertEquals(3 + 3, mesh.vertices.size / 8, "of the square's corners one is the triangle's first")
    }

    @Test
    fun `without normals they are those of the faces`() {
        write("v 0 0 0\nv 1 0 0\nv 0 0 -1\nf 1 2 3\n")
        val mesh = ModelFile.read("$obj").meshes.single()
        for (vertex in mesh.vertices.toList().chunked(8)) assertEquals(listOf(0f, 1f, 0f), vertex.drop(5))
        for (vertex in mesh.vertices.toList().chunked(8)) assertEquals(listOf(0f, 0f), vertex.subList(3, 5))
    }

    @Test
    fun `materials with colours, shininess and maps beside the model`() {
        write(OBJ)
        val material = ModelFile.read("$obj").meshes.single().material
        assertEquals("paint", material.name)
        assertEquals(Vector3f(0.1f, 0.2f, 0.3f), material.diffuse)
        assertEquals(Vector3f(0.4f, 0.5f, 0.6f), material.specular)
        assertEquals(Vector3f(0.7f, 0.8f, 0.9f), material.emissive)
        assertEquals(42f, material.shininess)
        assertEquals(folder.resolve("d.png").toString(), material.diffuseMap)
        assertEquals(null, material.specularMap)
        assertEquals(folder.resolve("maps/e.png").toString(), material.emissiveMap, "a Windows path")
    }

    @Test
    fun `a mesh for each material`() {
        write(OBJ + "usemtl other\nf 3/1/1 2/2/1 1/3/1\n")
        assertEquals(setOf("paint", "other"), ModelFile.read("$obj").meshes.map { it.material.name }.toSet())
    }

    @Test
    fun `names with spaces and umlauts are found`() {
        val plain = folder.resolve("größe 1").createDirectories()
        plain.resolve("mein gerät.mtl").writeText(MTL)
        plain.resolve("motor rad.obj").writeText(OBJ.replace("model.mtl", "mein gerät.mtl"))
        assertEquals("paint", ModelFile.read("${plain.resolve("motor rad.obj")}").meshes.single().material.name)
    }

    @Test
    fun `what is no model is named, with what is wrong`() {
        val broken =
            mapOf(
                "" to "not a readable model",
                "no model at all, but long enough for one" to "not a readable model",
                OBJ.substringBefore("f ") to "not a readable model",
                OBJ.replace("f 1/1/1", "f 9/1/1") to "not a readable model",
                OBJ.replace("f 1/1/1", "f 0/1/1") to "not a readable model",
                OBJ.replace("f 1/1/1", "f -9/1/1") to "not a readable model",
                OBJ.replace("f 1/1/1", "f x") to "not a readable model",
                OBJ.replace("v 1 0 0", "v 1 nan 0") to "not a finite number",
                OBJ.replace("v 1 0 0", "v 1 inf 0") to "not a finite number",
                OBJ.replace("usemtl paint", "usemtl pain") to "uses the material pain,",
                OBJ.replace("mtllib model.mtl", "") to "uses the material paint,",
                OBJ.replace("model.mtl", "mod\u0000el.mtl") to "names a file that cannot be",
            )
        for ((text, reason) in broken) {
            write(text)
            assertRefused(obj, "model file $obj", reason)
        }
    }

    @Test
    fun `a material file that is missing or broken is named`() {
        write(OBJ)
        mtl.deleteExisting()
        assertRefused(obj, "$mtl", "does not exist")
        mtl.writeText("")
        assertRefused(obj, "$mtl", "defines no material")
        for (ns in listOf("-1", "nan", "inf")) {
            mtl.writeText(MTL.replace("Ns 42", "Ns $ns"))
            assertRefused(obj, "$obj", "shininess")
        }
    }

    @Test
    fun `missing files and folders are named, with the cure`() {
        assertRefused(folder.resolve("missing.obj"), "model file ${folder.resolve("missing.obj")} does not exist", "check the spelling")
        assertRefused(folder.resolve("folder.obj").createDirectory(), "folder.obj is a folder", "name the file in it")
    }

    @Test
    fun `garbage is either read or refused, never more`() {
        val random = Random(7)
        var refused = 0
        repeat(300) { round ->
            val bytes = (OBJ.repeat(2)).toByteArray()
            repeat(random.nextInt(1, 6)) { bytes[random.nextInt(bytes.size)] = random.nextInt(256).toByte() }
            mtl.writeText(MTL)
            obj.writeBytes(if (round % 10 == 0) random.nextBytes(500) else bytes)
            try {
                ModelFile.read("$obj")
            } catch (e: InputError) {
                refused++
                assertTrue("$folder" in e.message.orEmpty(), e.message)
            }
        }
        assertTrue(refused in 30..290, "$refused of 300 refused")
    }

    private fun write(text: String) {
        obj.writeText(text)
        mtl.writeText(MTL)
    }

    private fun assertRefused(
        path: Path,
        vararg parts: String,
    ) {
        val message = assertThrows<InputError>(parts.toList().toString()) { ModelFile.read("$path") }.message.orEmpty()
        for (part in parts) assertTrue(part in message, message)
    }

    private companion object {
        val MTL =
            """
            newmtl other
            newmtl paint
            Kd 0.1 0.2 0.3
            Ks 0.4 0.5 0.6
            Ke 0.7 0.8 0.9
            Ns 42
            map_Kd d.png
            map_Ke maps\e.png
            """.trimIndent()
        val OBJ =
            """
            mtllib model.mtl
            v 0 0 0
            v 1 0 0
            v 1 2 -3
            vt 0 0
            vt 1 0
            vt 0.5 0.25
            vn 0 0 1
            vn 0 1 0
            vn 1 0 0
            usemtl paint
            f 1/1/1 2/2/2 3/3/3

            """.trimIndent()
    }
}
