package cga.framework

import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.texture.Texture2D
import org.joml.Matrix3f
import org.joml.Vector3f
import org.lwjgl.assimp.*
import org.lwjgl.assimp.Assimp.*
import org.lwjgl.opengl.GL11.*
import java.io.File
import java.nio.ByteBuffer
import java.nio.FloatBuffer
import java.nio.IntBuffer

/** Loads models with their materials through Assimp. */
object ModelLoader {
    private const val FLAGS = aiProcess_Triangulate or aiProcess_GenSmoothNormals or aiProcess_JoinIdenticalVertices
    private val ATTRIBUTES = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

    /** Reads the model and turns it by the given angles (radians), or returns null when it cannot be read. */
    fun loadModel(path: String, pitch: Float, yaw: Float, roll: Float): Renderable? {
        val scene = aiImportFile(path, FLAGS) ?: return null
        val materials = scene.mMaterials() ?: return null
        val meshes = scene.mMeshes() ?: return null
        val rotation = Matrix3f().rotateXYZ(pitch, yaw, roll)
        val textures = HashMap<String, Texture2D>()

        val loaded = Array(scene.mNumMaterials()) {
            loadMaterial(AIMaterial.create(materials.get(it)), File(path).parent, textures)
        }
        val renderable = Renderable()
        for (i in 0 until scene.mNumMeshes()) {
            val mesh = AIMesh.create(meshes.get(i))
            renderable.meshes.add(Mesh(vertexData(mesh, rotation), indexData(mesh), ATTRIBUTES, loaded[mesh.mMaterialIndex()]))
        }
        aiReleaseImport(scene)
        return renderable
    }

    private fun vertexData(mesh: AIMesh, rotation: Matrix3f): FloatArray {
        val positions = mesh.mVertices()
        val normals = mesh.mNormals()!!
        val texCoords = mesh.mTextureCoords(0)
        val data = FloatArray(mesh.mNumVertices() * 8)
        for (i in 0 until mesh.mNumVertices()) {
            val position = positions.get(i).let { Vector3f(it.x(), it.y(), it.z()).mul(rotation) }
            val normal = normals.get(i).let { Vector3f(it.x(), it.y(), it.z()).mul(rotation) }
            data[i * 8] = position.x
            data[i * 8 + 1] = position.y
            data[i * 8 + 2] = position.z
            data[i * 8 + 3] = texCoords?.get(i)?.x() ?: 0f
            data[i * 8 + 4] = texCoords?.get(i)?.y() ?: 0f
            data[i * 8 + 5] = normal.x
            data[i * 8 + 6] = normal.y
            data[i * 8 + 7] = normal.z
        }
        return data
    }

    private fun indexData(mesh: AIMesh): IntArray {
        val faces = mesh.mFaces()
        return IntArray(mesh.mNumFaces() * 3) { faces.get(it / 3).mIndices().get(it % 3) }
    }

    private fun loadMaterial(material: AIMaterial, folder: String, textures: HashMap<String, Texture2D>): Material {
        fun texture(type: Int): Texture2D {
            val name = AIString.calloc()
            val nothing: IntBuffer? = null
            val noFloats: FloatBuffer? = null
            aiGetMaterialTexture(material, type, 0, name, nothing, nothing, noFloats, nothing, nothing, nothing)
            val file = name.dataString()
            name.free()
            return textures.getOrPut(file) { if (file.isEmpty()) black() else load("$folder/$file") }
        }

        val shininess = FloatArray(1)
        aiGetMaterialFloatArray(material, AI_MATKEY_SHININESS, aiTextureType_NONE, 0, shininess, intArrayOf(1))
        return Material(
            texture(aiTextureType_DIFFUSE),
            texture(aiTextureType_EMISSIVE),
            texture(aiTextureType_SPECULAR),
            shininess[0]
        )
    }

    private fun load(path: String): Texture2D {
        val texture = Texture2D(path, true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    private fun black(): Texture2D {
        val pixel = ByteBuffer.allocateDirect(4)
        return Texture2D(pixel, 1, 1, false)
    }
}
