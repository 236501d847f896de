package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.*
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
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {

    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val boden: Renderable
    private val motorrad: Renderable

    private val kamera = TronCamera()
    // die Kamera haengt an diesem Punkt, gedreht wird nur er
    private val kameraAnker = Transformable()
    private var neigung = 0.0f

    private val motorradLicht: PointLight
    private val scheinwerfer: SpotLight
    private val laterne: SpotLight
    private val ecken = ArrayList<PointLight>()

    private var mausX = 0.0
    private var mausY = 0.0
    private var ersteBewegung = true

    private var speed = 0.0f
    private var debug = false

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()

        boden = bodenLaden()

        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f) ?: throw Exception("Motorrad nicht gefunden")
        motorrad.scale(Vector3f(0.8f))

        // Aufgabe 3.4: Kamera
        kameraAnker.parent = motorrad
        kamera.parent = kameraAnker
        kamera.translate(Vector3f(0.0f, 2.6f, 4.2f))
        kamera.rotate(toRadians(-25.0f), 0.0f, 0.0f)

        // Aufgabe 4.2
        motorradLicht = PointLight(Vector3f(0.0f, 1.5f, 0.0f), Vector3f(1.0f), 0)
        motorradLicht.parent = motorrad

        // Aufgabe 4.3
        scheinwerfer = SpotLight(Vector3f(0.0f, 0.8f, -1.6f), Vector3f(20.0f, 20.0f, 20.0f), 0, toRadians(16.5f), toRadians(20.5f))
        scheinwerfer.rotate(toRadians(-12.0f), 0.0f, 0.0f)
        scheinwerfer.parent = motorrad

        // Aufgabe 4.6
        ecken.add(PointLight(Vector3f(-10.0f, 2.0f, -10.0f), Vector3f(25.0f, 2.0f, 2.0f), 1))
        ecken.add(PointLight(Vector3f(10.0f, 2.0f, -10.0f), Vector3f(2.0f, 3.0f, 30.0f), 2))
        ecken.add(PointLight(Vector3f(-10.0f, 2.0f, 10.0f), Vector3f(20.0f, 2.0f, 22.0f), 3))
        ecken.add(PointLight(Vector3f(10.0f, 2.0f, 10.0f), Vector3f(24.0f, 18.0f, 1.0f), 4))
        laterne = SpotLight(Vector3f(-5.0f, 4.0f, -5.0f), Vector3f(10.0f, 15.0f, 15.0f), 1, toRadians(20.0f), toRadians(35.0f))
        laterne.rotate(toRadians(-75.0f), 0.0f, 0.0f)
    }

    private fun bodenLaden(): Renderable {
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        listOf(diff, emit, spec).forEach { it.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR) }
        val material = Material(diff, emit, spec, 60.0f, Vector2f(64.0f))

        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attribute = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        return Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, attribute, material)))
    }

    private fun disco(t: Float) = Vector3f(
        0.55f + 0.45f * sin(1.1f * t),
        0.55f + 0.45f * sin(1.7f * t + 2.0f),
        0.55f + 0.45f * cos(0.9f * t)
    )

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        kamera.bind(staticShader)

        val farbe = disco(t)
        motorradLicht.color = farbe

        val view = kamera.getCalculateViewMatrix()
        motorradLicht.bind(staticShader)
        ecken.forEach { it.bind(staticShader) }
        scheinwerfer.bind(staticShader, view)
        laterne.bind(staticShader, view)

        motorrad.render(staticShader, farbe)
        boden.render(staticShader, Vector3f(0.0f, 1.0f, 0.0f))
        if (debug) println("t=$t farbe=$farbe pos=${motorrad.getWorldPosition()}")
    }

    fun update(dt: Float, t: Float) {
        speed = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) speed = 6.0f
        if (window.getKeyState(GLFW_KEY_S)) speed = -4.0f
        if (window.getKeyState(GLFW_KEY_LEFT_SHIFT)) speed *= 2.0f
        if (speed == 0.0f) return

        motorrad.translate(Vector3f(0.0f, 0.0f, -speed * dt))
        if (window.getKeyState(GLFW_KEY_A)) motorrad.rotate(0.0f, 0.25f * speed * dt, 0.0f)
        if (window.getKeyState(GLFW_KEY_D)) motorrad.rotate(0.0f, -0.25f * speed * dt, 0.0f)
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_F1 && action == GLFW_PRESS) debug = !debug
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (ersteBewegung) {
            mausX = xpos
            mausY = ypos
            ersteBewegung = false
        }
        val dx = (xpos - mausX).toFloat()
        val dy = (ypos - mausY).toFloat()
        mausX = xpos
        mausY = ypos

        kameraAnker.rotate(0.0f, -dx * 0.002f, 0.0f)

        // hoch und runter, aber nicht unter den Boden
        val neu = (neigung - dy * 0.001f).coerceIn(-0.6f, 0.2f)
        kamera.rotateAroundPoint(neu - neigung, 0.0f, 0.0f, Vector3f(0.0f))
        neigung = neu
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        staticShader.cleanup()
    }
}
