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
import cga.framework.GLError
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

    private val suelo = Renderable()
    private val moto = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)!!
    private val camera = TronCamera()

    // 4.2
    private val luzMoto = PointLight(Vector3f(1f), Vector3f(0f, 1.8f, 0.4f), "luces.%s[0]")

    // 4.3 el faro (headlight)
    private val faro = SpotLight(Vector3f(26f, 25f, 20f), Vector3f(0f, 1.1f, -1.9f), "faro.%s", toRadians(15f), toRadians(25f))

    // 4.6 las esquinas: position to color, index 0 is already the motorcycle
    private val esquinas = listOf(
        Vector3f(-17f, 2f, -17f) to Vector3f(20f, 1f, 2f),
        Vector3f(17f, 2f, -17f) to Vector3f(1f, 4f, 22f),
        Vector3f(17f, 2f, 17f) to Vector3f(18f, 11f, 0f),
        Vector3f(-17f, 2f, 17f) to Vector3f(13f, 0f, 19f)
    ).mapIndexed { i, (pos, color) -> PointLight(color, pos, "luces.%s[${i + 1}]") }

    private val luces = listOf(luzMoto) + esquinas

    private val verde = Vector3f(0f, 1f, 0f)
    private var lastX: Double? = null

    init {
        glClearColor(0f, 0f, 0f, 1f); GLError.checkThrow()
        listOf(GL_CULL_FACE, GL_DEPTH_TEST).forEach { glEnable(it) }
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // ground
        val (diff, emit, spec) = listOf("diff", "emit", "spec").map {
            val tex = Texture2D("assets/textures/ground_$it.png", true)
            tex.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
            tex
        }
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attrs = listOf(3 to 0, 2 to 12, 3 to 20).map { (n, offset) -> VertexAttribute(n, 32, offset) }
        val material = Material(diff, emit, spec, 60f, Vector2f(64f, 64f))
        suelo.meshes += Mesh(obj.vertexData, obj.indexData, attrs.toTypedArray(), material)

        moto.scale(Vector3f(0.8f))

        // everything that drives with the motorcycle
        listOf(camera, luzMoto, faro).forEach { it.parent = moto }

        camera.rotate(toRadians(-28f), 0f, 0f)
        camera.translate(Vector3f(0f, 0.4f, 4.6f))

        faro.rotate(toRadians(-12f), 0f, 0f)
        GLError.checkThrow()
    }

    // three sine waves with different phase, values 0..1
    private fun arcoiris(t: Float): Vector3f {
        val (r, g, b) = listOf(0f, 2.1f, 4.2f).map { 0.5f + 0.5f * sin(1.3f * t + it) }
        return Vector3f(r, g, b)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val view = camera.getCalculateViewMatrix()
        val neonMoto = arcoiris(t)
        luzMoto.color = neonMoto

        shader.use()
        camera.bind(shader)
        luces.forEach { it.bind(shader) }
        faro.bind(shader, view)

        suelo.render(shader, view, verde)
        moto.render(shader, view, neonMoto)
    }

    fun update(dt: Float, t: Float) {
        // sum of the values of all the pressed keys
        fun keys(vararg k: Pair<Int, Float>) = k.filter { window.getKeyState(it.first) }.map { it.second }.sum()

        val speed = keys(GLFW_KEY_W to 6f, GLFW_KEY_S to -4f)
        val turn = keys(GLFW_KEY_A to 1f, GLFW_KEY_D to -1f)

        if (speed != 0f) {
            moto.rotate(0f, turn * speed * 0.25f * dt, 0f)
            moto.translate(Vector3f(0f, 0f, -speed * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        // TODO: luz larga (high beam) with L, only if there is time
        // if (key == GLFW_KEY_L && action == GLFW_PRESS) faro.color.mul(2f)
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        // the first time there is no old position (None)
        val dx = xpos - (lastX ?: xpos)
        lastX = xpos

        // the camera is a child of the motorcycle, so for her the motorcycle is (0, 0, 0)
        camera.rotateAroundPoint(0f, (-dx * 0.002).toFloat(), 0f, Vector3f())
    }

    fun cleanup() {
        listOf(suelo, moto).forEach { it.cleanup() }
        shader.cleanup()
    }
}
