package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
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
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val ground = Renderable()
    private val bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)!!
    private val camera = TronCamera()

    private val light = PointLight(Vector3f(0f, 1.7f, 0f), Vector3f(1f, 1f, 1f))
    private val spot = SpotLight(Vector3f(0f, 1f, -1.7f), Vector3f(3f, 3f, 3f), toRadians(16f), toRadians(28f))
    private val light2 = PointLight(Vector3f(10f, 1f, 10f), Vector3f(5f, 0f, 0f))
    private val light3 = PointLight(Vector3f(-10f, 1f, 10f), Vector3f(0f, 0f, 6f))
    private val light4 = PointLight(Vector3f(10f, 1f, -10f), Vector3f(5f, 4f, 0f))
    private val light5 = PointLight(Vector3f(-10f, 1f, -10f), Vector3f(5f, 0f, 5f))

    private var oldX = -1.0

    init {
        glClearColor(0f, 0f, 0f, 1f)
        glEnable(GL_CULL_FACE)
        glEnable(GL_DEPTH_TEST)

        val emit = Texture2D("assets/textures/ground_emit.png", true)
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        emit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        diff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        spec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val pos = VertexAttribute(3, 32, 0)
        val tex = VertexAttribute(2, 32, 12)
        val nor = VertexAttribute(3, 32, 20)
        ground.meshes.add(Mesh(obj.vertexData, obj.indexData, arrayOf(pos, tex, nor), Material(diff, emit, spec, 60f, Vector2f(64f, 64f))))

        bike.scaleLocal(Vector3f(0.8f))

        camera.parent = bike
        camera.translateLocal(Vector3f(0f, 2.4f, 4f))
        camera.rotateLocal(toRadians(-28f), 0f, 0f)

        light.parent = bike
        spot.parent = bike
        spot.rotateLocal(toRadians(-12f), 0f, 0f)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        shader.use()
        camera.bind(shader)

        val col = Vector3f((sin(t) + 1f) / 2f, (sin(t * 1.5f) + 1f) / 2f, (sin(t * 0.6f + 2f) + 1f) / 2f)
        light.col = col
        light.bind(shader, "light")
        spot.bind(shader, "spot", camera.getCalculateViewMatrix())
        light2.bind(shader, "light2")
        light3.bind(shader, "light3")
        light4.bind(shader, "light4")
        light5.bind(shader, "light5")

        shader.setUniform("emit_col", Vector3f(0f, 1f, 0f))
        ground.render(shader)
        shader.setUniform("emit_col", col)
        bike.render(shader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            bike.translateLocal(Vector3f(0f, 0f, -6f * dt))
            if (window.getKeyState(GLFW_KEY_A)) bike.rotateLocal(0f, 1.5f * dt, 0f)
            if (window.getKeyState(GLFW_KEY_D)) bike.rotateLocal(0f, -1.5f * dt, 0f)
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            bike.translateLocal(Vector3f(0f, 0f, 6f * dt))
            if (window.getKeyState(GLFW_KEY_A)) bike.rotateLocal(0f, -1.5f * dt, 0f)
            if (window.getKeyState(GLFW_KEY_D)) bike.rotateLocal(0f, 1.5f * dt, 0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (oldX == -1.0) oldX = xpos
        val dx = xpos - oldX
        oldX = xpos
        camera.rotateAroundPoint(0f, (-dx * 0.002).toFloat(), 0f, Vector3f(0f, 0f, 0f))
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        shader.cleanup()
    }
}
