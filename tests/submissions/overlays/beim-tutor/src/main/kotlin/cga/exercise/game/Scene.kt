package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.EckLicht
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

class Scene(private val window: GameWindow) {

    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    // Objekte
    private val ground: Renderable
    private val motorrad: Renderable
    private val kamera = TronCamera()

    // Lichter
    private val motorradLicht = PointLight(Vector3f(0.0f, 0.0f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f))
    private val scheinwerfer = SpotLight(
        Vector3f(0.0f, 0.9f, -1.9f),
        Vector3f(2.6f, 2.6f, 2.4f),
        Math.toRadians(13.0f),
        Math.toRadians(23.0f)
    )
    private val ecken = arrayOf(
        EckLicht(-14.0f, -14.0f, Vector3f(1.0f, 0.1f, 0.1f)),
        EckLicht(14.0f, -14.0f, Vector3f(0.1f, 0.3f, 1.0f)),
        EckLicht(14.0f, 14.0f, Vector3f(1.0f, 0.7f, 0.0f)),
        EckLicht(-14.0f, 14.0f, Vector3f(0.8f, 0.1f, 1.0f))
    )

    // 4.4
    private val groundFarbe = Vector3f(0.0f, 1.0f, 0.0f)

    // 4.5
    private var letztesX: Double? = null

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        ground = ladeGround()
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw Exception("Motorrad konnte nicht geladen werden")
        motorrad.scaleLocal(Vector3f(0.8f))
        GLError.checkThrow("Modelle")

        // Kamera haengt am Motorrad
        kamera.parent = motorrad
        kamera.rotateLocal(Math.toRadians(-33.0f), 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.0f, 4.2f))

        // Lichter am Motorrad
        motorradLicht.parent = motorrad
        motorradLicht.translateLocal(Vector3f(0.0f, 1.8f, 0.0f))
        scheinwerfer.parent = motorrad
        scheinwerfer.rotateLocal(Math.toRadians(-9.0f), 0.0f, 0.0f)
    }

    private fun ladeGround(): Renderable {
        val material = Material(
            ladeTextur("assets/textures/ground_diff.png"),
            ladeTextur("assets/textures/ground_emit.png"),
            ladeTextur("assets/textures/ground_spec.png"),
            60.0f,
            Vector2f(64.0f)
        )
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attribute = arrayOf(
            VertexAttribute(3, 32, 0),      // Position
            VertexAttribute(2, 32, 12),     // Texturkoordinate
            VertexAttribute(3, 32, 20)      // Normale
        )
        val mesh = Mesh(obj.vertexData, obj.indexData, attribute, material)
        return Renderable(mutableListOf(mesh))
    }

    private fun ladeTextur(pfad: String): Texture2D {
        val textur = Texture2D(pfad, true)
        textur.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return textur
    }

    // Farbe vom Motorrad zum Zeitpunkt t, jede Komponente zwischen 0 und 1
    private fun motorradFarbe(t: Float): Vector3f {
        val rot = 0.5f + 0.5f * Math.sin(0.9f * t)
        val gruen = 0.5f + 0.5f * Math.sin(1.4f * t + 1.0f)
        val blau = 0.5f + 0.5f * Math.sin(0.6f * t + 3.0f)
        return Vector3f(rot, gruen, blau)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        shader.use()

        // 1. Kamera
        val V = kamera.getCalculateViewMatrix()
        kamera.bind(shader)

        // 2. Lichter (vor den Objekten, sonst kommen sie ein Bild zu spaet)
        val farbe = motorradFarbe(t)
        motorradLicht.farbe = farbe
        motorradLicht.bind(shader, "moto")
        for (i in ecken.indices) {
            ecken[i].bind(shader, "ecke[$i]")
        }
        scheinwerfer.bind(shader, "spot", V)

        // 3. Objekte
        shader.setUniform("farbe_e", groundFarbe)
        ground.render(shader, V)
        shader.setUniform("farbe_e", farbe)
        motorrad.render(shader, V)
    }

    fun update(dt: Float, t: Float) {
        val gas = taste(GLFW_KEY_W) - taste(GLFW_KEY_S)
        val lenkung = taste(GLFW_KEY_A) - taste(GLFW_KEY_D)

        // nur lenken, wenn wir fahren (rueckwaerts andersrum)
        motorrad.rotateLocal(0.0f, gas * lenkung * Math.toRadians(80.0f) * dt, 0.0f)
        motorrad.translateLocal(Vector3f(0.0f, 0.0f, -6.0f * gas * dt))
    }

    // 1, wenn die Taste gedrueckt ist, sonst 0
    private fun taste(key: Int): Float = if (window.getKeyState(key)) 1.0f else 0.0f

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val altesX = letztesX ?: xpos
        letztesX = xpos

        // Winkel = Differenz * 0.002, um die y-Achse vom Motorrad
        val winkel = (altesX - xpos) * 0.002
        kamera.rotateAroundPoint(0.0f, winkel.toFloat(), 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        motorrad.cleanup()
        shader.cleanup()
    }
}
