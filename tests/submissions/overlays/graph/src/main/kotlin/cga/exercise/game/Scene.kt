package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Node
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val root = Node()
    private val ground = Node(listOf(groundMesh()), Vector3f(0.0f, 1.0f, 0.0f))
    private val motorcycle = Node(ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!.meshes)
    private val pivot = Node()
    private val camera = TronCamera()
    private val own = PointLight("own", Vector3f(0.0f, 1.3f, 0.0f), Vector3f(1.0f))
    private val headlight =
        SpotLight("beam", Vector3f(0.0f, 0.8f, -1.7f), Vector3f(2.5f), toRadians(13.0f), toRadians(24.0f))

    private var lastX: Double? = null

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glEnable(GL_DEPTH_TEST)

        root.attach(ground, motorcycle.attach(pivot.attach(camera), own, headlight))
        listOf(Vector3f(7.0f, 0.5f, 0.0f), Vector3f(0.5f, 7.0f, 2.0f), Vector3f(0.0f, 1.0f, 7.0f), Vector3f(6.0f, 1.0f, 6.0f))
            .forEachIndexed { i, color ->
                val place = Vector3f(if (i % 2 == 0) -16.0f else 16.0f, 1.8f, if (i < 2) -16.0f else 16.0f)
                root.attach(PointLight("corners[$i]", place, color))
            }

        motorcycle.scaleLocal(Vector3f(0.8f))
        camera.translateLocal(Vector3f(0.0f, 2.2f, 3.6f))
        camera.rotateLocal(toRadians(-28.0f), 0.0f, 0.0f)
        headlight.rotateLocal(toRadians(-11.0f), 0.0f, 0.0f)
    }

    private fun groundMesh(): Mesh {
        fun load(kind: String): Texture2D {
            val texture = Texture2D("assets/textures/ground_$kind.png", true)
            texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
            return texture
        }
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        return Mesh(obj.vertexData, obj.indexData, attributes, Material(load("diff"), load("emit"), load("spec"), 60.0f, Vector2f(64.0f)))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        motorcycle.emission = Vector3f(abs(sin(t)), abs(cos(t)), abs(sin(2 * t)))
        own.lightColor = motorcycle.emission

        shader.use()
        camera.bind(shader)
        val view = camera.getCalculateViewMatrix()
        root.visit { it.prepare(shader, view) }
        root.visit { it.draw(shader, camera) }
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -5.0f * dt))
        if (window.getKeyState(GLFW_KEY_S)) motorcycle.translateLocal(Vector3f(0.0f, 0.0f, 5.0f * dt))
        if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotateLocal(0.0f, 1.5f * dt, 0.0f)
        if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotateLocal(0.0f, -1.5f * dt, 0.0f)
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val moved = xpos - (lastX ?: xpos)
        lastX = xpos
        pivot.rotateLocal(0.0f, (moved * -0.002).toFloat(), 0.0f)
    }

    fun cleanup() {
        root.visit { it.cleanup() }
        shader.cleanup()
    }
}
