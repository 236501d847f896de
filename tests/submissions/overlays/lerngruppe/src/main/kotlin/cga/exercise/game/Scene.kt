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
import kotlin.math.PI
import kotlin.math.sin

/**
 * Blatt 4. Fuer jede Aufgabe vom Blatt eine Methode (erstelle.../binde...),
 * damit wir uns beim Erklaeren nicht verlaufen.
 */
class Scene(private val window: GameWindow) {

    private val shader: ShaderProgram

    private lateinit var ground: Renderable
    private lateinit var motorcycle: Renderable
    private lateinit var camera: TronCamera

    private lateinit var halo: PointLight          // 4.2
    private lateinit var beam: SpotLight           // 4.3
    private val towers = ArrayList<PointLight>()   // 4.6

    // 4.5
    private var firstMouseMove = true
    private var lastX = 0.0

    init {
        shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        erstelleBoden()
        erstelleMotorrad()
        erstelleKamera()
        erstellePunktlicht()
        erstelleScheinwerfer()
        erstelleEcken()
    }

    // ------------------------------------------------------------ Blatt 2/3

    private fun ladeTextur(name: String): Texture2D {
        val texture = Texture2D("assets/textures/$name.png", true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    private fun erstelleBoden() {
        val material = Material(
            ladeTextur("ground_diff"),
            ladeTextur("ground_emit"),
            ladeTextur("ground_spec"),
            60.0f,
            Vector2f(64.0f, 64.0f)
        )
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val pos = VertexAttribute(3, 8 * 4, 0)
        val tex = VertexAttribute(2, 8 * 4, 3 * 4)
        val norm = VertexAttribute(3, 8 * 4, 5 * 4)
        ground = Renderable()
        ground.meshes.add(Mesh(obj.vertexData, obj.indexData, arrayOf(pos, tex, norm), material))
        ground.glowTint = Vector3f(0.0f, 0.9f, 0.35f) // 4.4, statisch
    }

    private fun erstelleMotorrad() {
        motorcycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        motorcycle.scaleLocal(Vector3f(0.7f, 0.7f, 0.7f))
    }

    private fun erstelleKamera() {
        camera = TronCamera()
        camera.parent = motorcycle
        camera.translateLocal(Vector3f(0.0f, 3.4f, 5.0f))
        camera.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
    }

    // ------------------------------------------------------------ 4.2

    private fun erstellePunktlicht() {
        halo = PointLight(Vector3f(0.0f, 2.2f, 0.4f), Vector3f(1.0f, 1.0f, 1.0f))
        halo.parent = motorcycle
    }

    // ------------------------------------------------------------ 4.3

    private fun erstelleScheinwerfer() {
        val gamma = Math.toRadians(13.0f)
        val phi = Math.toRadians(20.0f)
        beam = SpotLight(Vector3f(0.0f, 1.2f, -1.7f), Vector3f(2.4f, 2.3f, 2.0f), gamma, phi)
        beam.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        beam.parent = motorcycle
    }

    // ------------------------------------------------------------ 4.4

    // drei Sinuskurven, je um 120 Grad verschoben, nach [0, 1] gebracht
    private fun farbeZurZeit(t: Float): Vector3f {
        val shift = (2.0 * PI / 3.0).toFloat()
        val r = 0.5f + 0.5f * sin(t)
        val g = 0.5f + 0.5f * sin(t + shift)
        val b = 0.5f + 0.5f * sin(t + 2.0f * shift)
        return Vector3f(r, g, b)
    }

    private fun faerbeMotorrad(t: Float) {
        val farbe = farbeZurZeit(t)
        motorcycle.glowTint = farbe
        halo.rgb = farbe
    }

    // ------------------------------------------------------------ 4.6

    private fun erstelleEcken() {
        val e = 16.0f
        val h = 2.0f
        towers.add(PointLight(Vector3f(-e, h, -e), Vector3f(8.0f, 1.0f, 1.0f)))  // rot
        towers.add(PointLight(Vector3f(e, h, -e), Vector3f(1.0f, 2.0f, 8.0f)))   // blau
        towers.add(PointLight(Vector3f(e, h, e), Vector3f(7.0f, 6.0f, 0.5f)))    // gelb
        towers.add(PointLight(Vector3f(-e, h, e), Vector3f(6.0f, 0.5f, 7.0f)))   // lila
    }

    // ------------------------------------------------------------ binden

    private fun bindePunktlichter() {
        halo.bind(shader, "halo")
        for (i in 0 until towers.size) {
            towers[i].bind(shader, "tower[$i]")
        }
    }

    private fun bindeScheinwerfer() {
        beam.bind(shader, "beam", camera.getCalculateViewMatrix())
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        faerbeMotorrad(t)

        // Reihenfolge (4.2.2): Shader an -> Kamera -> Licht -> Objekte
        shader.use()
        camera.bind(shader)
        shader.setUniform("surroundingLight", Vector3f(0.04f, 0.04f, 0.06f))
        bindePunktlichter()
        bindeScheinwerfer()

        ground.render(shader)
        motorcycle.render(shader)
    }

    fun update(dt: Float, t: Float) {
        val tempo = 6.0f
        val lenkung = 1.2f

        var fahrt = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) fahrt += 1.0f
        if (window.getKeyState(GLFW_KEY_S)) fahrt -= 1.0f

        if (fahrt != 0.0f) {
            if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotateLocal(0.0f, fahrt * lenkung * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotateLocal(0.0f, -fahrt * lenkung * dt, 0.0f)
            motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -fahrt * tempo * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    // ------------------------------------------------------------ 4.5

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouseMove) {
            lastX = xpos
            firstMouseMove = false
        }
        val dx = xpos - lastX
        lastX = xpos

        // Mittelpunkt = Ursprung des Motorrads, denn die Kamera ist sein Kind
        val winkel = (-dx * 0.002).toFloat()
        camera.rotateAroundPoint(0.0f, winkel, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        shader.cleanup()
    }
}
