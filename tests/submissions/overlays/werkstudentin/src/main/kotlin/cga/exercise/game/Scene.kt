package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.geometry.degrees
import cga.exercise.components.geometry.rgb
import cga.exercise.components.light.Cone
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*

private const val MOUSE_SENSITIVITY = 0.002f
private const val SPEED = 5.5f
private val TURN = 80.degrees

class Scene(private val window: GameWindow) {

    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground = Renderable(mutableListOf(loadGround()))
    private val motorcycle = loadMotorcycle()
    private val renderables = listOf(ground, motorcycle)

    private val groundGlow: Glow = Glow.Steady(Vector3f(0f, 1f, 0f))
    private val motorcycleGlow: Glow = Glow.Waves(1.1f, 0.7f, 1.6f)

    private val camera = TronCamera(target = motorcycle)

    private val bikeLamp = PointLight(Vector3f(0f, 1.7f, 0.2f), Vector3f(1f), 1f, "lamps[0]").apply {
        parent = motorcycle
    }

    // one per corner of the ground, the bike has lamps[0]
    private val cornerLamps = listOf(
        Vector2f(-15f, -15f) to rgb(0xFF2A1A),
        Vector2f(15f, -15f) to rgb(0x2050FF),
        Vector2f(15f, 15f) to rgb(0xFFC414),
        Vector2f(-15f, 15f) to rgb(0xD42CFF)
    ).mapIndexed { i, (corner, color) ->
        PointLight(Vector3f(corner.x, 1.8f, corner.y), color, 16f, "lamps[${i + 1}]")
    }

    private val lamps = listOf(bikeLamp) + cornerLamps

    private val headlamp = SpotLight(Vector3f(0f, 1f, -1.75f), rgb(0xFFF2D8), 20f, Cone(12.degrees, 20.degrees)).apply {
        rotate((-11).degrees, 0f, 0f)
        parent = motorcycle
    }

    private val controls = mapOf<Int, (Float) -> Unit>(
        GLFW_KEY_W to { dt -> motorcycle.translate(Vector3f(0f, 0f, -SPEED * dt)) },
        GLFW_KEY_S to { dt -> motorcycle.translate(Vector3f(0f, 0f, SPEED * dt)) },
        GLFW_KEY_A to { dt -> motorcycle.rotate(0f, TURN * dt, 0f) },
        GLFW_KEY_D to { dt -> motorcycle.rotate(0f, -TURN * dt, 0f) }
    )

    private var lastCursorX: Double? = null

    init {
        glClearColor(0f, 0f, 0f, 1f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
    }

    fun update(dt: Float, t: Float) {
        controls.filterKeys(window::getKeyState).values.forEach { move -> move(dt) }

        ground.tint = groundGlow.at(t)
        motorcycle.tint = motorcycleGlow.at(t)
        bikeLamp.color = motorcycle.tint
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        shader.use()
        camera.bind(shader)
        lamps.forEach { it.bind(shader) }
        headlamp.bind(shader, camera.getCalculateViewMatrix())
        renderables.forEach { it.render(shader) }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        // nothing to compare with at the first event
        lastCursorX?.let { last ->
            camera.orbit((last - xpos).toFloat() * MOUSE_SENSITIVITY)
        }
        lastCursorX = xpos
    }

    fun cleanup() {
        renderables.forEach(Renderable::cleanup)
        shader.cleanup()
    }

    private fun loadMotorcycle(): Renderable =
        checkNotNull(ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)) { "no motorcycle" }
            .apply { scale(Vector3f(0.8f)) }

    private fun loadGround(): Mesh {
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        // position, texture coordinate, normal
        val stride = 8 * Float.SIZE_BYTES
        val attributes = listOf(3 to 0, 2 to 3, 3 to 5)
            .map { (size, start) -> VertexAttribute(size, stride, start * Float.SIZE_BYTES) }
        val material = Material(
            diff = loadTexture("ground_diff"),
            emit = loadTexture("ground_emit"),
            specular = loadTexture("ground_spec"),
            shininess = 60f,
            tcMultiplier = Vector2f(64f)
        )
        return Mesh(obj.vertexData, obj.indexData, attributes.toTypedArray(), material)
    }

    private fun loadTexture(name: String) = Texture2D("assets/textures/$name.png", true).apply {
        setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
    }
}
