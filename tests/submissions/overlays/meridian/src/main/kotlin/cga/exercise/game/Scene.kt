package cga.exercise.game

import cga.exercise.components.camera.OrbitCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.geometry.attachedTo
import cga.exercise.components.geometry.tilted
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.min

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground = Actor(loadGround(), Vector3f(0.0f, 1.0f, 0.0f))
    private val motorcycle = Actor(loadMotorcycle(), Vector3f(1.0f))
    private val actors = listOf(ground, motorcycle)

    private val camera = OrbitCamera(motorcycle.renderable)

    private val bikeLight = PointLight(Vector3f(0.0f, 1.6f, 0.2f), Vector3f(1.0f)).attachedTo(motorcycle.renderable)
    private val headlight = SpotLight(Vector3f(0.0f, 1.0f, -1.7f), Vector3f(3.2f, 3.1f, 2.7f), toRadians(13.0f), toRadians(24.0f))
        .tilted(-11.0f)
        .attachedTo(motorcycle.renderable)
    private val cornerLights = listOf(
        corner(-1, -1, Vector3f(7.0f, 0.4f, 0.6f)),
        corner(+1, -1, Vector3f(0.4f, 1.0f, 8.0f)),
        corner(-1, +1, Vector3f(6.5f, 4.0f, 0.2f)),
        corner(+1, +1, Vector3f(4.5f, 0.3f, 7.0f))
    )
    private val pointLights = listOf(bikeLight) + cornerLights

    private val palette = Palette(
        1.6f,
        Vector3f(1.0f, 0.25f, 0.15f),
        Vector3f(0.95f, 0.85f, 0.1f),
        Vector3f(0.1f, 0.7f, 1.0f),
        Vector3f(0.8f, 0.2f, 0.9f)
    )

    private var speed = 0.0f
    private var lastMouseX: Double? = null

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
        GLError.checkThrow("in Scene.init")
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val color = palette.at(t)
        motorcycle.glow.set(color)
        bikeLight.color.set(color)

        shader.use()
        camera.bind(shader)
        bindLights()
        actors.forEach { it.draw(shader) }
    }

    private fun bindLights() {
        pointLights.forEachIndexed { i, light -> light.bind(shader, "points[$i]") }
        headlight.bind(shader, "spot", camera.getCalculateViewMatrix())
    }

    fun update(dt: Float, t: Float) {
        val throttle = axis(GLFW_KEY_W, GLFW_KEY_S)
        val steering = axis(GLFW_KEY_A, GLFW_KEY_D)
        // the motorcycle needs a moment to gain speed, and to lose it
        speed += (throttle * TOP_SPEED - speed) * min(INERTIA * dt, 1.0f)
        motorcycle.renderable.rotateLocal(0.0f, steering * TURN_RATE * speed * dt, 0.0f)
        motorcycle.renderable.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
    }

    private fun axis(positive: Int, negative: Int): Float {
        val up = if (window.getKeyState(positive)) 1.0f else 0.0f
        val down = if (window.getKeyState(negative)) 1.0f else 0.0f
        return up - down
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val deltaX = xpos - (lastMouseX ?: xpos)
        lastMouseX = xpos
        camera.orbit(-deltaX.toFloat() * MOUSE_SENSITIVITY)
    }

    fun cleanup() {
        actors.forEach { it.renderable.cleanup() }
        shader.cleanup()
    }

    private companion object {
        const val MOUSE_SENSITIVITY = 0.002f
        const val TOP_SPEED = 7.0f
        const val TURN_RATE = 0.25f
        const val INERTIA = 5.0f
        const val CORNER = 13.0f
        const val CORNER_HEIGHT = 1.8f

        fun corner(x: Int, z: Int, color: Vector3f) = PointLight(Vector3f(x * CORNER, CORNER_HEIGHT, z * CORNER), color)

        fun loadMotorcycle(): Renderable {
            val model = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            requireNotNull(model) { "the motorcycle could not be loaded" }
            model.scaleLocal(Vector3f(0.8f))
            return model
        }

        fun loadGround(): Renderable {
            val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
            val stride = 8 * Float.SIZE_BYTES
            val attributes = arrayOf(
                VertexAttribute(3, stride, 0),
                VertexAttribute(2, stride, 3 * Float.SIZE_BYTES),
                VertexAttribute(3, stride, 5 * Float.SIZE_BYTES)
            )
            val material = Material(groundTexture("diff"), groundTexture("emit"), groundTexture("spec"), 60.0f, Vector2f(64.0f))
            return Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, attributes, material)))
        }

        fun groundTexture(kind: String) = Texture2D("assets/textures/ground_$kind.png", true).apply {
            setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        }
    }
}
