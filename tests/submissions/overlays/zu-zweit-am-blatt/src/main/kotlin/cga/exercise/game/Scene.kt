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

class Scene(private val window: GameWindow) {

    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val boden: Renderable
    private val motorrad: Renderable

    // Kamera haengt am Arm, der Arm am Motorrad
    private val kameraArm = Transformable()
    private val kamera = TronCamera()

    private val motorradLicht: PointLight
    private val scheinwerfer: SpotLight
    private val lichter: List<PointLight>

    private val gruen = Vector3f(0f, 1f, 0f)

    private var mausX = 0.0
    private var mausDa = false

    init {
        glClearColor(0f, 0f, 0f, 1f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Boden
        val bodenObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val bodenMaterial = Material(textur("ground_diff"), textur("ground_emit"), textur("ground_spec"), 60f, Vector2f(64f))
        val attribute = arrayOf(
            VertexAttribute(3, 32, 0),
            VertexAttribute(2, 32, 12),
            VertexAttribute(3, 32, 20)
        )
        boden = Renderable()
        boden.meshes.add(Mesh(bodenObj.vertexData, bodenObj.indexData, attribute, bodenMaterial))

        // Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)
            ?: throw Exception("Motorrad nicht gefunden")
        motorrad.scaleLocal(Vector3f(0.8f))

        // Kamera
        kameraArm.parent = motorrad
        kameraArm.translateLocal(Vector3f(0f, 0.4f, 0f))
        kamera.parent = kameraArm
        kamera.rotateLocal(Math.toRadians(-32f), 0f, 0f)
        kamera.translateLocal(Vector3f(0f, 0f, 4.5f))

        // Licht ueber dem Motorrad
        motorradLicht = PointLight(Vector3f(0f, 1.8f, 0.3f), Vector3f(1f), 1.5f)
        motorradLicht.parent = motorrad

        // Scheinwerfer, etwas nach unten gedreht
        scheinwerfer = SpotLight(
            Vector3f(0f, 1.1f, -1.6f), Vector3f(1f, 0.95f, 0.8f), 3.5f,
            Math.toRadians(14f), Math.toRadians(28f)
        )
        scheinwerfer.rotateLocal(Math.toRadians(-13f), 0f, 0f)
        scheinwerfer.parent = motorrad

        // Reihenfolge wie im Shader! 0 = Motorrad, 1 = Scheinwerfer, Rest = Ecken
        lichter = listOf(
            motorradLicht,
            scheinwerfer,
            PointLight(Vector3f(-14f, 1.6f, -14f), Vector3f(1f, 0.1f, 0.1f), 8f),
            PointLight(Vector3f(14f, 1.6f, -14f), Vector3f(0.1f, 0.3f, 1f), 9f),
            PointLight(Vector3f(14f, 1.6f, 14f), Vector3f(1f, 0.8f, 0f), 7f),
            PointLight(Vector3f(-14f, 1.6f, 14f), Vector3f(0.8f, 0.1f, 1f), 8f)
        )
    }

    private fun textur(name: String): Texture2D {
        val t = Texture2D("assets/textures/$name.png", true)
        t.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return t
    }

    // zwischen 0.2 und 1, damit es nie ganz dunkel wird
    private fun welle(t: Float, phase: Float) = 0.6f + 0.4f * sin(t + phase)

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        staticShader.use()
        kamera.bind(staticShader)
        staticShader.setUniform("time", t)

        // Farbe fuers Motorrad und sein Licht
        val puls = Vector3f(welle(t, 0f), welle(0.7f * t, 2f), welle(1.4f * t, 4f))
        motorradLicht.quelle.farbe = puls

        val sicht = kamera.getCalculateViewMatrix()
        lichter.forEachIndexed { i, licht ->
            licht.bind(staticShader, "[$i]", sicht)
        }
        scheinwerfer.bind(staticShader, "[1]", sicht)

        boden.render(staticShader, gruen)
        kamera.bind(staticShader)
        motorrad.render(staticShader, puls)
    }

    fun update(dt: Float, t: Float) {
        if (taste(GLFW_KEY_W)) fahren(6f * dt)
        if (taste(GLFW_KEY_S)) fahren(-3f * dt)
    }

    private fun fahren(weg: Float) {
        if (taste(GLFW_KEY_A)) motorrad.rotateLocal(0f, 0.25f * weg, 0f)
        if (taste(GLFW_KEY_D)) motorrad.rotateLocal(0f, -0.25f * weg, 0f)
        motorrad.translateLocal(Vector3f(0f, 0f, -weg))
    }

    private fun taste(key: Int) = window.getKeyState(key)

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (mausDa) {
            val winkel = (mausX - xpos) * 0.002
            kameraArm.rotateLocal(0f, winkel.toFloat(), 0f)
        }
        mausX = xpos
        mausDa = true
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        staticShader.cleanup()
    }
}
