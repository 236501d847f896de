package cga.framework.model

import cga.framework.Home
import cga.framework.InputError
import cga.framework.Phases
import cga.framework.cooked.Cooked
import org.joml.Vector3f
import org.joml.Vector3fc
import org.lwjgl.assimp.AIColor4D
import org.lwjgl.assimp.AIMaterial
import org.lwjgl.assimp.AIMesh
import org.lwjgl.assimp.AIScene
import org.lwjgl.assimp.AIString
import org.lwjgl.assimp.Assimp.*
import org.lwjgl.system.MemoryStack
import java.nio.IntBuffer
import java.nio.file.Files
import java.nio.file.Path

/** Reads model files (OBJ and whatever else Assimp knows) to plain data. */
public object ModelFile {
    private const val STEPS =
        aiProcess_Triangulate or aiProcess_JoinIdenticalVertices or aiProcess_GenSmoothNormals or aiProcess_SortByPType or
            aiProcess_PreTransformVertices
    private const val COOKED = "model"

    /** The model in the file at [path] (see [Home]). Throws [InputError] naming the file and what is wrong with it. */
    public fun read(path: String): ModelData = Phases.span("model") { load(path) }

    private fun load(path: String): ModelData {
        val file = Home.resolve(path)
        if (!Files.isRegularFile(file)) Home.read(file, "model")
        // Of other formats it is not known which files beside them they read.
        if (!path.endsWith(".obj", ignoreCase = true)) return parse(file)
        return Cooked.read(file, COOKED, CookedModel::decode)
            ?: Cooked.make(listOf(file) + ObjCheck.libraries(file), COOKED, CookedModel::encode) { parse(file) }
    }

    private fun parse(file: Path): ModelData {
        val scene = aiImportFile(file.toString(), STEPS) ?: throw broken(file, aiGetErrorString() ?: "no reason given")
        try {
            return ModelData(meshes(scene, file))
        } finally {
            aiReleaseImport(scene)
        }
    }

    private fun broken(
        file: Path,
        reason: String,
    ) = InputError("model file $file is not a readable model (${reason.lines().first()}): export it again as OBJ with triangles.")

    private fun meshes(
        scene: AIScene,
        file: Path,
    ): List<MeshData> {
        val materials = scene.mMaterials() ?: throw broken(file, "it holds no materials")
        val meshes = scene.mMeshes() ?: throw broken(file, "it holds no faces")
        return List(meshes.remaining()) { AIMesh.create(meshes[it]) }
            .filter { it.mPrimitiveTypes() and aiPrimitiveType_TRIANGLE != 0 }
            .map { MeshData(vertices(it, file), indices(it), material(AIMaterial.create(materials[it.mMaterialIndex()]), file)) }
            .ifEmpty { throw broken(file, "it holds no triangles") }
    }

    private fun vertices(
        mesh: AIMesh,
        file: Path,
    ): FloatArray {
        val positions = mesh.mVertices()
        val normals = mesh.mNormals() ?: throw broken(file, "it holds no normals")
        val texCoords = mesh.mTextureCoords(0)
        val vertices = FloatArray(mesh.mNumVertices() * MeshData.FLOATS_PER_VERTEX)
        var at = 0
        for (i in 0 until mesh.mNumVertices()) {
            val position = positions[i]
            val normal = normals[i]
            vertices[at++] = position.x()
            vertices[at++] = position.y()
            vertices[at++] = position.z()
            vertices[at++] = texCoords?.get(i)?.x() ?: 0f
            vertices[at++] = texCoords?.get(i)?.y() ?: 0f
            vertices[at++] = normal.x()
            vertices[at++] = normal.y()
            vertices[at++] = normal.z()
        }
        if (!vertices.all(Float::isFinite)) throw broken(file, "a coordinate is not a finite number")
        return vertices
    }

    private fun indices(mesh: AIMesh): IntArray {
        val faces = mesh.mFaces()
        val indices = IntArray(mesh.mNumFaces() * 3)
        for (i in 0 until mesh.mNumFaces()) {
            val corners: IntBuffer = faces[i].mIndices()
            for (corner in 0 until 3) indices[3 * i + corner] = corners[corner]
        }
        return indices
    }

    private fun material(
        material: AIMaterial,
        file: Path,
    ): MaterialData =
        MaterialData(
            name = string { aiGetMaterialString(material, AI_MATKEY_NAME, aiTextureType_NONE, 0, it) }.orEmpty(),
            diffuse = color(material, AI_MATKEY_COLOR_DIFFUSE, file),
            specular = color(material, AI_MATKEY_COLOR_SPECULAR, file),
            emissive = color(material, AI_MATKEY_COLOR_EMISSIVE, file),
            shininess = shininess(material, file),
            diffuseMap = map(material, aiTextureType_DIFFUSE, file),
            specularMap = map(material, aiTextureType_SPECULAR, file),
            emissiveMap = map(material, aiTextureType_EMISSIVE, file),
        )

    private fun color(
        material: AIMaterial,
        key: String,
        file: Path,
    ): Vector3fc =
        MemoryStack.stackPush().use { stack ->
            val read = AIColor4D.calloc(stack)
            aiGetMaterialColor(material, key, aiTextureType_NONE, 0, read)
            val color = Vector3f(read.r(), read.g(), read.b())
            if (!color.isFinite || minOf(color.x, color.y, color.z) < 0f) throw broken(file, "a material has the colour $color")
            color
        }

    private fun shininess(
        material: AIMaterial,
        file: Path,
    ): Float =
        MemoryStack.stackPush().use { stack ->
            val value = stack.callocFloat(1)
            aiGetMaterialFloatArray(material, AI_MATKEY_SHININESS, aiTextureType_NONE, 0, value, stack.ints(1))
            if (!(value[0] >= 0f && value[0].isFinite())) throw broken(file, "a material has the shininess Ns ${value[0]}")
            value[0]
        }

    /** The picture's path, beside the model's own file as MTL means it. */
    private fun map(
        material: AIMaterial,
        type: Int,
        file: Path,
    ): String? {
        val none: IntBuffer? = null
        val name = string { aiGetMaterialTexture(material, type, 0, it, none, none, null, none, none, none) } ?: return null
        return ObjCheck.beside(file, name).toAbsolutePath().toString()
    }

    private fun string(query: (AIString) -> Int): String? =
        MemoryStack.stackPush().use { stack ->
            val text = AIString.calloc(stack)
            if (query(text) == aiReturn_SUCCESS) text.dataString().ifEmpty { null } else null
        }
}
