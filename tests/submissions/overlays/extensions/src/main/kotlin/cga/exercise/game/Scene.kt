package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.deg
import cga.exercise.components.shader.send
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs

private infix fun <T : Transformable> T.on(carrier: Transformable): T = apply { parent = carrier }

/** A pure colour of the rainbow; one round has length 1. */
private fun hue(h: Float): Vector3f {
    fun channel(shift: Float) = (abs((h * 6.0f + shift) % 6.0f - 3.0f) - 1.0f).coerceIn(0.0f, 1.0f)
    return Vector3f(channel(0.0f), channel(4.0f), channel(2.0f))
}

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val groundColor: (Float) -> Vector3f = { Vector3f(0.0f, 1.0f, 0.0f) }
    private val bikeColor: (Float) -> Vector3f = { t -> hue(0.08f * t + 0.05f) }

    private val ground = loadGround()
    private val bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        .apply { scaleLocal(Vector3f(0.8f)) }

    private val camera = TronCamera(4.5f, 3.0f) on bike

    private val headlight = SpotLight(Vector3f(0.0f, 1.1f, -1.8f), Vector3f(3.0f, 3.0f, 3.5f), 16.0f.deg, 28.0f.deg)
        .apply { rotateLocal((-11.0f).deg, 0.0f, 0.0f) } on bike

    private val lights: List<PointLight> = listOf(
        PointLight(Vector3f(0.0f, 1.7f, 0.0f), bikeColor) on bike,
        headlight
    ) + (0 until 5).map { PointLight(onCircle(it / 5.0f, 14.0f), hue(it / 5.0f).mul(7.0f)) }

    private var lastX: Double? = null

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        listOf(GL_CULL_FACE, GL_DEPTH_TEST).forEach(::glEnable)
    }

    private fun onCircle(part: Float, radius: Float) =
        Vector3f(0.0f, 1.5f, -radius).rotateY((part * 360.0f + 36.0f).deg)

    private fun loadGround(): Renderable {
        val (diff, emit, spec) = listOf("diff", "emit", "spec").map { kind ->
            Texture2D("assets/textures/ground_$kind.png", true).also {
                it.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
            }
        }
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = listOf(3 to 0, 2 to 12, 3 to 20).map { (n, offset) -> VertexAttribute(n, 32, offset) }
        val material = Material(diff, emit, spec, 60.0f, Vector2f(64.0f))
        return Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, attributes.toTypedArray(), material)))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        val view = camera.getCalculateViewMatrix()

        shader.use()
        camera.bind(shader)
        lights.onEach { it.now = t }.forEachIndexed { i, light ->
            when (light) {
                is SpotLight -> light.bind(shader, "[$i]", view)
                else -> light.bind(shader, "[$i]")
            }
        }

        listOf(ground to groundColor, bike to bikeColor).forEach { (thing, color) ->
            shader.send("glow" to color(t))
            thing.render(shader, view)
        }
    }

    private fun keys(plus: Int, minus: Int): Int =
        listOf(plus to 1, minus to -1).filter { window.getKeyState(it.first) }.map { it.second }.sum()

    fun update(dt: Float, t: Float) {
        val drive = keys(GLFW_KEY_W, GLFW_KEY_S) * dt
        val steer = keys(GLFW_KEY_A, GLFW_KEY_D) * drive
        bike.rotateLocal(0.0f, 1.3f * steer, 0.0f)
        bike.translateLocal(Vector3f(0.0f, 0.0f, -6.5f * drive))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) = Unit

    fun onMouseMove(xpos: Double, ypos: Double) {
        lastX?.let { camera.angle -= 0.002f * (xpos - it).toFloat() }
        lastX = xpos
    }

    fun cleanup() {
        listOf(ground, bike).forEach { it.cleanup() }
        shader.cleanup()
    }
}
