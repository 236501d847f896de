package cga.exercise.components.geometry

import cga.exercise.components.texture.Texture2D
import cga.framework.model.MaterialData
import cga.framework.model.MeshData
import cga.framework.model.ModelFile
import org.joml.Matrix4d
import org.joml.Vector3f
import org.joml.Vector3fc
import org.lwjgl.opengl.GL33C.*

/** Makes renderables of model files. */
public object ModelLoader {
    private const val STRIDE = MeshData.FLOATS_PER_VERTEX * Float.SIZE_BYTES

    /** Position, texture coordinates, normal: locations 0, 1 and 2 of the shader. */
    private val LAYOUT = arrayOf(VertexAttribute(3, STRIDE, 0), VertexAttribute(2, STRIDE, 12), VertexAttribute(3, STRIDE, 20))

    /**
     * The model in the file at [path], its vertices turned by [pitch], [yaw] and [roll] (radians about x, y and z), for models that
     * were made with other axes than ours (y up, −z forwards). Throws [cga.framework.InputError] naming the file.
     */
    public fun loadModel(
        path: String,
        pitch: Float = 0f,
        yaw: Float = 0f,
        roll: Float = 0f,
    ): Renderable {
        val turn = if (pitch == 0f && yaw == 0f && roll == 0f) null else Matrix4d().rotationOf(pitch, yaw, roll)
        val textures = HashMap<String, Texture2D>()
        return Renderable(
            ModelFile.read(path).meshes.map { Mesh(turned(it.vertices, turn), it.indices, LAYOUT, material(it.material, textures)) },
        )
    }

    private fun turned(
        vertices: FloatArray,
        turn: Matrix4d?,
    ): FloatArray {
        if (turn == null) return vertices
        val vector = Vector3f()
        for (vertex in vertices.indices step MeshData.FLOATS_PER_VERTEX) {
            for (at in intArrayOf(vertex, vertex + 5)) {
                turn.transformDirection(vector.set(vertices[at], vertices[at + 1], vertices[at + 2]))
                vertices[at] = vector.x
                vertices[at + 1] = vector.y
                vertices[at + 2] = vector.z
            }
        }
        return vertices
    }

    private fun material(
        data: MaterialData,
        textures: MutableMap<String, Texture2D>,
    ): Material {
        fun texture(
            map: String?,
            color: Vector3fc,
        ) = if (map == null) Texture2D(color) else textures.getOrPut(map) { mapped(map) }
        return Material(
            diff = texture(data.diffuseMap, data.diffuse),
            emit = texture(data.emissiveMap, data.emissive),
            specular = texture(data.specularMap, data.specular),
            shininess = data.shininess,
        )
    }

    private fun mapped(path: String) =
        Texture2D(path, true).apply { setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR) }
}
