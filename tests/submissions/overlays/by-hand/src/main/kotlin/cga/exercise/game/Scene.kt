package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.LightBlock
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.math.deg
import cga.exercise.components.math.rad
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val boden: Renderable
    private val bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)!!
    private val camera = TronCamera(bike)
    private val bikeLight = PointLight(0f, 1.6f, 0.2f, floatArrayOf(1f, 1f, 1f))
    private val scheinwerfer = SpotLight(0f, 1f, -1.9f, floatArrayOf(3f, 3f, 2.7f), 13.0, 24.0, 9.0)
    private val ecken = listOf(
        PointLight(-17f, 1.5f, -17f, floatArrayOf(7f, 1f, 0f)),
        PointLight(17f, 1.5f, -17f, floatArrayOf(0f, 1f, 7f)),
        PointLight(17f, 1.5f, 17f, floatArrayOf(5f, 0f, 5f))
    )
    private val lights = LightBlock(listOf(bikeLight) + ecken, scheinwerfer)

    private var firstMouse = true
    private var lastX = 0.0

    init {
        val o = OBJLoader.loadOBJ("assets/models/ground.obj")
        val m = Material(tex("ground_diff"), tex("ground_emit"), tex("ground_spec"), 60f, Vector2f(64f, 64f))
        val a = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        boden = Renderable(arrayListOf(Mesh(o.vertexData, o.indexData, a, m)))

        bike.scaleLocal(Vector3f(0.8f))
        bikeLight.parent = bike
        scheinwerfer.parent = bike

        glClearColor(0f, 0f, 0f, 1f)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_CULL_FACE)
    }

    private fun tex(name: String): Texture2D {
        val t = Texture2D("assets/textures/$name.png", true)
        t.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return t
    }

    // one colour of the rainbow: the three are a third of a turn apart
    private fun wave(t: Float, shiftDeg: Double) = (0.5 + 0.5 * sin(rad(50.0 * t + shiftDeg))).toFloat()

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        val rgb = floatArrayOf(wave(t, 90.0), wave(t, 210.0), wave(t, 330.0))
        bikeLight.rgb = rgb
        shader.use()
        val view = camera.view()
        camera.uploadProjection()
        lights.upload(view)
        boden.render(shader, view, floatArrayOf(0f, 1f, 0f))
        bike.render(shader, view, rgb)
    }

    fun update(dt: Float, t: Float) {
        var meters = 0f
        var turnDeg = 0.0
        if (window.getKeyState(GLFW_KEY_W)) meters += 5f * dt
        if (window.getKeyState(GLFW_KEY_S)) meters -= 5f * dt
        if (window.getKeyState(GLFW_KEY_A)) turnDeg += 80.0 * dt
        if (window.getKeyState(GLFW_KEY_D)) turnDeg -= 80.0 * dt
        if (meters == 0f) return
        bike.rotateLocal(0f, rad(if (meters > 0) turnDeg else -turnDeg).toFloat(), 0f)
        bike.translateLocal(Vector3f(0f, 0f, -meters))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            lastX = xpos
            firstMouse = false
        }
        camera.orbitDeg -= deg((xpos - lastX) * 0.002)
        lastX = xpos
    }

    fun cleanup() {
        boden.cleanup()
        bike.cleanup()
        shader.cleanup()
    }
}
