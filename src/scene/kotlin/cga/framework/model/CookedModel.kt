package cga.framework.model

import cga.framework.cooked.CookedFile.Companion.padded
import org.joml.Vector3f
import org.joml.Vector3fc
import java.nio.ByteBuffer
import java.nio.ByteOrder.LITTLE_ENDIAN

/**
 * A model as a cooked file's payload:
 *
 *     int      number of meshes; then of each
 *     int      how many floats the vertices have; and they
 *     int      how many indices there are; and they
 *     floats   diffuse, specular, emissive colour, shininess: ten
 *     strings  name, diffuse, specular, emissive map: the length in bytes, -1 for none, and UTF-8, padded to 4
 */
public object CookedModel {
    private const val COLORS_AND_SHININESS = 10

    public fun encode(model: ModelData): ByteBuffer {
        val bytes = ByteBuffer.allocate(Int.SIZE_BYTES + model.meshes.sumOf(::size)).order(LITTLE_ENDIAN)
        bytes.putInt(model.meshes.size)
        model.meshes.forEach { bytes.put(it) }
        return bytes.flip()
    }

    public fun decode(bytes: ByteBuffer): ModelData = ModelData(List(bytes.getInt()) { mesh(bytes) })

    private fun size(mesh: MeshData): Int =
        2 * Int.SIZE_BYTES + Float.SIZE_BYTES * (mesh.vertices.size + mesh.indices.size + COLORS_AND_SHININESS) +
            strings(mesh.material).sumOf { Int.SIZE_BYTES + padded(it?.toByteArray()?.size ?: 0) }

    private fun ByteBuffer.put(mesh: MeshData) {
        putInt(mesh.vertices.size)
        asFloatBuffer().put(mesh.vertices)
        position(position() + Float.SIZE_BYTES * mesh.vertices.size)
        putInt(mesh.indices.size)
        asIntBuffer().put(mesh.indices)
        position(position() + Int.SIZE_BYTES * mesh.indices.size)
        val material = mesh.material
        for (color in listOf(material.diffuse, material.specular, material.emissive)) {
            putFloat(color.x()).putFloat(color.y()).putFloat(color.z())
        }
        putFloat(material.shininess)
        strings(material).forEach { put(it) }
    }

    private fun ByteBuffer.put(text: String?) {
        val utf8 = text?.toByteArray()
        putInt(utf8?.size ?: -1)
        if (utf8 != null) put(utf8.copyOf(padded(utf8.size)))
    }

    private fun strings(material: MaterialData) = listOf(material.name, material.diffuseMap, material.specularMap, material.emissiveMap)

    private fun mesh(bytes: ByteBuffer): MeshData {
        val vertices = FloatArray(bytes.getInt())
        bytes.asFloatBuffer().get(vertices)
        bytes.position(bytes.position() + Float.SIZE_BYTES * vertices.size)
        val indices = IntArray(bytes.getInt())
        bytes.asIntBuffer().get(indices)
        bytes.position(bytes.position() + Int.SIZE_BYTES * indices.size)
        val (diffuse, specular, emissive) = List(3) { color(bytes) }
        val shininess = bytes.getFloat()
        val (name, diffuseMap, specularMap, emissiveMap) = List(4) { string(bytes) }
        return MeshData(
            vertices,
            indices,
            MaterialData(name.orEmpty(), diffuse, specular, emissive, shininess, diffuseMap, specularMap, emissiveMap),
        )
    }

    private fun color(bytes: ByteBuffer): Vector3fc = Vector3f(bytes.getFloat(), bytes.getFloat(), bytes.getFloat())

    private fun string(bytes: ByteBuffer): String? {
        val length = bytes.getInt()
        if (length < 0) return null
        val utf8 = ByteArray(padded(length))
        bytes.get(utf8)
        return String(utf8, 0, length)
    }
}
