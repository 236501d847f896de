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
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram

    private val boden = Renderable()
    private val motorrad: Renderable
    private val camera = TronCamera()

    // Lichter
    private val bikeLight: PointLight
    private val scheinwerfer: SpotLight
    private val ecken = ArrayList<PointLight>()

    // Maus
    private var firstMouse = true
    private var alteMausX = 0.0

    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        ladeBoden()

        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f) ?: throw Exception("Motorrad nicht gefunden")
        motorrad.scale(Vector3f(0.8f))

        // Kamera hinter das Motorrad
        camera.haengeAn(motorrad)
        camera.neige(32f)
        camera.translate(Vector3f(0f, 0.2f, 4.2f))

        // 4.2 Punktlicht ueber dem Motorrad
        bikeLight = PointLight(Vector3f(0f, 0f, 0.3f), Vector3f(1f), 0)
        bikeLight.hebeAn(1.7f)
        bikeLight.haengeAn(motorrad)

        // 4.3 Scheinwerfer
        scheinwerfer = SpotLight(Vector3f(0f, 0.9f, -1.9f), Vector3f(15f, 15f, 13f), Math.toRadians(14f), Math.toRadians(26f))
        scheinwerfer.neige(10f)
        scheinwerfer.haengeAn(motorrad)

        // 4.6 die vier Ecken
        ecken.add(PointLight(Vector3f(-13f, 1.6f, -13f), Vector3f(20f, 2f, 1f), 1))
        ecken.add(PointLight(Vector3f(13f, 1.6f, -13f), Vector3f(1f, 4f, 20f), 2))
        ecken.add(PointLight(Vector3f(13f, 1.6f, 13f), Vector3f(16f, 1f, 16f), 3))
        ecken.add(PointLight(Vector3f(-13f, 1.6f, 13f), Vector3f(17f, 14f, 1f), 4))
    }

    private fun ladeBoden() {
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        for (tex in listOf(diff, emit, spec)) {
            tex.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        }
        val material = Material(diff, emit, spec, 60f, Vector2f(64f))

        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attrs = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        boden.meshes.add(Mesh(res.vertexData, res.indexData, attrs, material))
        boden.leuchtfarbe = Vector3f(0f, 1f, 0f)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        camera.bind(staticShader)

        bikeLight.bind(staticShader)
        for (ecke in ecken) ecke.bind(staticShader)
        scheinwerfer.bind(staticShader, camera.getCalculateViewMatrix())

        boden.render(staticShader)
        motorrad.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        // 4.4 Motorrad und sein Licht in der gleichen Farbe
        val farbe = Vector3f(0.5f + 0.5f * sin(t), 0.5f + 0.5f * sin(0.8f * t + 2f), 0.5f + 0.5f * cos(0.6f * t))
        motorrad.leuchtfarbe = farbe
        bikeLight.lichtfarbe = farbe

        if (window.getKeyState(GLFW_KEY_W)) motorrad.fahre(5f * dt)
        if (window.getKeyState(GLFW_KEY_S)) motorrad.fahre(-4f * dt)
        if (window.getKeyState(GLFW_KEY_W) || window.getKeyState(GLFW_KEY_S)) {
            if (window.getKeyState(GLFW_KEY_A)) motorrad.lenke(1.3f * dt)
            if (window.getKeyState(GLFW_KEY_D)) motorrad.lenke(-1.3f * dt)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            alteMausX = xpos
            firstMouse = false
        }
        val winkel = (alteMausX - xpos) * 0.002
        alteMausX = xpos
        camera.umkreise(winkel.toFloat())
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        staticShader.cleanup()
    }
}
