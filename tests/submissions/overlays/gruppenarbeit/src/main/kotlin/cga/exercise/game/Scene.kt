package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.LightUniforms
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

private const val MOUSE_FACTOR = 0.002
private const val SPEED = 6f
private const val TURN = 1.5f

private val Float.degrees get() = Math.toRadians(this)

/** One colour channel that goes up and down with the time. */
data class Pulse(val speed: Float, val phase: Float) {
    fun at(t: Float) = 0.55f + 0.45f * sin(speed * t + phase)
}

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground = loadGround()
    private val motorcycle = loadMotorcycle()

    private val camera = TronCamera().apply {
        parent = motorcycle
        rotate((-28f).degrees, 0f, 0f)
        translate(Vector3f(0f, 0f, 5f))
    }

    // 4.2
    private val bikeLight = PointLight(Vector3f(0f, 2f, 0.6f), Vector3f(1f), LightUniforms.BIKE).apply {
        parent = motorcycle
    }

    // 4.3
    private val headlight = SpotLight(Vector3f(0f, 1f, -1.7f), Vector3f(4f, 3.9f, 3.5f), 13f.degrees, 24f.degrees).apply {
        rotate((-9f).degrees, 0f, 0f)
        parent = motorcycle
    }

    // 4.6
    private val corners = listOf(
        Vector3f(-17f, 1.6f, -17f) to Vector3f(7f, 1f, 0.5f),
        Vector3f(17f, 1.6f, -17f) to Vector3f(0.5f, 2f, 7f),
        Vector3f(-17f, 1.6f, 17f) to Vector3f(6f, 0.5f, 6f),
        Vector3f(17f, 1.6f, 17f) to Vector3f(5f, 5f, 0.5f)
    ).mapIndexed { i, (position, color) -> PointLight(position, color, LightUniforms.corner(i)) }

    // 4.4
    private val groundTint = Vector3f(0f, 1f, 0f)
    private val pulses = listOf(Pulse(1.1f, 0f), Pulse(0.7f, 2f), Pulse(1.6f, 4f))

    private var lastCursorX: Double? = null

    init {
        glClearColor(0f, 0f, 0f, 1f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
        GLError.checkThrow()
    }

    private fun loadGround(): Renderable {
        fun texture(kind: String) = Texture2D("assets/textures/ground_$kind.png", true).apply {
            setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        }

        val material = Material(texture("diff"), texture("emit"), texture("spec"), 60f, Vector2f(64f))
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val layout = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        return Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, layout, material)))
    }

    private fun loadMotorcycle(): Renderable {
        val bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)
        return requireNotNull(bike) { "no motorcycle" }.apply { scale(Vector3f(0.8f)) }
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val (r, g, b) = pulses.map { it.at(t) }
        val bikeTint = Vector3f(r, g, b)
        bikeLight.color = bikeTint

        shader.use()
        camera.bind(shader)

        // erst die Lichter, dann die Objekte
        bikeLight.bind(shader)
        corners.forEach { it.bind(shader) }
        headlight.bind(shader, camera.getCalculateViewMatrix())

        ground.render(shader, groundTint)
        motorcycle.render(shader, bikeTint)
    }

    fun update(dt: Float, t: Float) {
        val drive = axis(GLFW_KEY_W, GLFW_KEY_S)
        if (drive == 0f) return
        val steer = axis(GLFW_KEY_A, GLFW_KEY_D)

        motorcycle.apply {
            rotate(0f, steer * drive * TURN * dt, 0f)
            translate(Vector3f(0f, 0f, -drive * SPEED * dt))
        }
    }

    /** 1 for the first key, -1 for the second, 0 for none or both */
    private fun axis(plus: Int, minus: Int): Float {
        fun pressed(key: Int) = if (window.getKeyState(key)) 1f else 0f
        return pressed(plus) - pressed(minus)
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        // no jump at the very first event
        lastCursorX?.let { last ->
            val yaw = (last - xpos) * MOUSE_FACTOR
            camera.rotateAroundPoint(0f, yaw.toFloat(), 0f, Vector3f())
        }
        lastCursorX = xpos
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        shader.cleanup()
    }
}
