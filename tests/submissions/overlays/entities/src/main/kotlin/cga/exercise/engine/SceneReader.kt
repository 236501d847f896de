package cga.exercise.engine

import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.texture.Texture2D
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.opengl.GL11.*

/** Makes entities from a text; see SceneText.kt for the form. */
class SceneReader {
    val root = Entity("root")
    private val known = hashMapOf("root" to root)
    private lateinit var current: Entity

    fun read(text: String): SceneReader {
        text.lines().map { it.trim() }.filter { it.isNotEmpty() && !it.startsWith("#") }.forEach { line ->
            val words = line.split(Regex(" +"))
            command(words[0], words.drop(1))
        }
        return this
    }

    fun entity(name: String) = known[name] ?: error("no entity $name")

    private fun command(word: String, args: List<String>) {
        when (word) {
            "entity" -> begin(args[0], Entity(args[0]), parentOf(args))
            "point" -> light(args, PointLight(vector(args, "at"), vector(args, "color")))
            "spot" -> light(args, SpotLight(vector(args, "at"), vector(args, "color"), angle(args, "inner"), angle(args, "outer")))
            "at" -> current.node.translateLocal(vector(args))
            "turn" -> current.node.rotateLocal(toRadians(args[0].toFloat()), toRadians(args[1].toFloat()), toRadians(args[2].toFloat()))
            "scale" -> current.node.scaleLocal(Vector3f(args[0].toFloat()))
            "emission" -> current.add(Emission(vector(args)))
            "pulse" -> current.add(Pulse(vector(args)))
            "obj" -> current.add(Shape(listOf(loadObj(args))))
            "model" -> current.add(Shape(checkNotNull(ModelLoader.loadModel(args[0], 0.0f, 0.0f, 0.0f)).meshes))
            else -> error("$word is not known")
        }
    }

    private fun light(args: List<String>, light: PointLight) {
        begin(args[0], Entity(args[0], light), parentOf(args))
        current.add(Lamp(light))
    }

    private fun begin(name: String, entity: Entity, parent: Entity) {
        known[name] = entity
        parent.attach(entity)
        current = entity
    }

    private fun parentOf(args: List<String>) = after(args, "in")?.let { entity(args[it]) } ?: root

    private fun after(args: List<String>, word: String) = args.indexOf(word).takeIf { it >= 0 }?.plus(1)

    private fun vector(args: List<String>, word: String) = vector(args.drop(after(args, word) ?: error("$word is missing")))

    private fun vector(args: List<String>) = Vector3f(args[0].toFloat(), args[1].toFloat(), args[2].toFloat())

    private fun angle(args: List<String>, word: String) = toRadians(args[after(args, word) ?: error("$word is missing")].toFloat())

    private fun loadObj(args: List<String>): Mesh {
        val (path, textures, tiling, shininess) = args
        val (diff, emit, spec) = listOf("diff", "emit", "spec").map {
            Texture2D("assets/textures/${textures}_$it.png", true).also { map ->
                map.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
            }
        }
        val obj = OBJLoader.loadOBJ(path)
        val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        val material = Material(diff, emit, spec, shininess.toFloat(), Vector2f(tiling.toFloat()))
        return Mesh(obj.vertexData, obj.indexData, attributes, material)
    }
}
