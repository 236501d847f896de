package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.Cone
import cga.exercise.components.light.Hsv
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.set
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground = loadGround()
    private val bike = requireNotNull(ModelLoader.loadModel(BIKE, 0f, 0f, 0f)) { BIKE }.apply { scaleLocal(Vector3f(0.8f)) }
    private val camera = TronCamera(bike)

    private val bikeLight = PointLight(Vector3f(0f, 1.6f, 0.2f), Hsv(0f)).apply { parent = bike }
    private val headlight = SpotLight(Vector3f(0f, 1f, -1.7f), Hsv(0.15f, 0.15f, 3.2f), Cone.ofDegrees(11.0, 24.0)).apply {
        rotateLocal(TILT, 0f, 0f)
        parent = bike
    }
    private val corners = CORNERS.mapIndexed { i, (x, z) ->
        PointLight(Vector3f(x, 2f, z), Hsv(i / 4f, 0.9f, 7f))
    }
    private val lights = listOf(bikeLight, headlight) + corners

    private var lastX: Double? = null

    init {
        glClearColor(0f, 0f, 0f, 1f)
        listOf(GL_CULL_FACE, GL_DEPTH_TEST).forEach { glEnable(it) }
    }

    private fun loadGround(): Renderable {
        val (diff, emit, spec) = listOf("diff", "emit", "spec").map { kind ->
            Texture2D("assets/textures/ground_$kind.png", true).apply {
                setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
            }
        }
        val attributes = listOf(3 to 0, 2 to 12, 3 to 20).map { (n, offset) -> VertexAttribute(n, 32, offset) }
        return with(OBJLoader.loadOBJ("assets/models/ground.obj")) {
            Renderable(mutableListOf(Mesh(vertexData, indexData, attributes.toTypedArray(), Material(diff, emit, spec, 60f, Vector2f(64f)))))
        }
    }

    private fun bikeColor(t: Float) = Hsv(0.12f * t + 0.5f, 0.75f)

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        bikeLight.color = bikeColor(t)

        shader.use()
        camera.bind(shader)
        camera.getCalculateViewMatrix().let { view ->
            lights.forEachIndexed { i, light -> light.bind(shader, "lights[$i]", view) }
        }
        shader["count"] = lights.size

        ground.render(shader, GREEN.toRgb())
        bike.render(shader, bikeColor(t).toRgb())
    }

    private fun pressed(key: Int) = if (window.getKeyState(key)) 1f else 0f

    fun update(dt: Float, t: Float) {
        val way = SPEED * dt * (pressed(GLFW_KEY_W) - pressed(GLFW_KEY_S))
        val curve = pressed(GLFW_KEY_A) - pressed(GLFW_KEY_D)
        bike.rotateLocal(0f, 0.3f * curve * way, 0f)
        bike.translateLocal(Vector3f(0f, 0f, -way))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) = Unit

    fun onMouseMove(xpos: Double, ypos: Double) {
        lastX?.let { camera.orbit = camera.orbit.turned((xpos - it) * MOUSE_FACTOR) }
        lastX = xpos
    }

    fun cleanup() {
        listOf(ground, bike).forEach(Renderable::cleanup)
        shader.cleanup()
    }

    companion object {
        const val BIKE = "assets/models/motorcycle/motorcycle.obj"
        const val SPEED = 5f
        const val TILT = -0.16f
        const val MOUSE_FACTOR = 0.002
        val GREEN = Hsv(1 / 3f)
        val CORNERS = listOf(-15f to -15f, 15f to -15f, 15f to 15f, -15f to 15f)
    }
}
