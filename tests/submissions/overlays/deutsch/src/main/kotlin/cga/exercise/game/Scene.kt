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
import org.lwjgl.opengl.GL30.*
import kotlin.math.pow
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val kamera = TronCamera()
    private val boden = Renderable()
    private val motorrad: Renderable

    private val motorradLicht: PointLight
    private val eckLichter: MutableList<PointLight>
    private val scheinwerfer: SpotLight

    private var mausX: Double? = null

    init {
        glClearColor(0f, 0f, 0f, 1f); GLError.checkThrow("clear color")
        glEnable(GL_CULL_FACE); glFrontFace(GL_CCW); glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST); glDepthFunc(GL_LESS)

        // Boden
        fun textur(art: String) = Texture2D("assets/textures/ground_$art.png", true).apply {
            setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        }
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val bodenMaterial = Material(textur("diff"), textur("emit"), textur("spec"), 60f, Vector2f(64f))
        boden.meshes += Mesh(
            obj.vertexData, obj.indexData,
            arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20)),
            bodenMaterial
        )

        // Motorrad
        motorrad = requireNotNull(ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f))
        motorrad.scaleLocal(Vector3f(0.8f))

        // Kamera
        kamera.apply {
            rotateLocal(toRadians(-35f), 0f, 0f)
            translateLocal(Vector3f(0f, 0f, 4f))
            parent = motorrad
        }

        // Lichter
        motorradLicht = PointLight(Vector3f(0f, 1f, 0f), Vector3f(1f)).apply { parent = motorrad }
        eckLichter = mutableListOf(
            PointLight(Vector3f(18f, 2f, 18f), Vector3f(5f, 1f, 0f)),
            PointLight(Vector3f(18f, 2f, -18f), Vector3f(0f, 1f, 5f)),
            PointLight(Vector3f(-18f, 2f, 18f), Vector3f(4f, 0f, 4f)),
            PointLight(Vector3f(-18f, 2f, -18f), Vector3f(3f, 4f, 0f))
        )
        scheinwerfer = SpotLight(Vector3f(0f, 1.2f, -2f), Vector3f(2f, 2f, 2.5f), toRadians(10f), toRadians(22f)).apply {
            rotateLocal(toRadians(-9f), 0f, 0f)
            parent = motorrad
        }
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        val regenbogen = Vector3f(sin(t).pow(2), sin(t * 1.5f).pow(2), sin(t * 0.7f + 1f).pow(2))
        motorradLicht.farbe = regenbogen

        shader.use()
        kamera.bind(shader)
        shader.setUniform("ambient", Vector3f(0.05f))
        (listOf(motorradLicht) + eckLichter).forEachIndexed { i, licht -> licht.bind(shader, i.toString()) }
        scheinwerfer.bind(shader, "strahler", kamera.getCalculateViewMatrix())

        shader.setUniform("farbe", Vector3f(0f, 1f, 0f))
        boden.render(shader)

        shader.setUniform("farbe", regenbogen)
        motorrad.render(shader)
    }

    fun update(dt: Float, t: Float) {
        val gas = (if (window.getKeyState(GLFW_KEY_W)) 1 else 0) - (if (window.getKeyState(GLFW_KEY_S)) 1 else 0)
        val lenkung = (if (window.getKeyState(GLFW_KEY_A)) 1 else 0) - (if (window.getKeyState(GLFW_KEY_D)) 1 else 0)
        if (gas != 0) {
            motorrad.rotateLocal(0f, lenkung * gas * 1.5f * dt, 0f)
            motorrad.translateLocal(Vector3f(0f, 0f, -5f * gas * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        mausX?.let { alt ->
            val winkel = ((alt - xpos) * 0.002).toFloat()
            kamera.rotateAroundPoint(0f, winkel, 0f, Vector3f(0f))
        }
        mausX = xpos
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        shader.cleanup()
    }
}
