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
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {

    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val boden: Renderable
    private val motorrad: Renderable
    private val kamera = TronCamera()

    // alle Punktlichter in einer Liste, das vom Motorrad ist auch dabei
    private val punktlichter = ArrayList<PointLight>()
    private val strahler = ArrayList<SpotLight>()
    private val motorradLicht: PointLight

    private var letzteMausX: Double? = null

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        // Boden
        val bodenMaterial = Material(
            ladeTextur("ground_diff"), ladeTextur("ground_emit"), ladeTextur("ground_spec"),
            60.0f, Vector2f(64.0f, 64.0f)
        )
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attribute = arrayOf(
            VertexAttribute(3, 8 * 4, 0),
            VertexAttribute(2, 8 * 4, 3 * 4),
            VertexAttribute(3, 8 * 4, 5 * 4)
        )
        boden = Renderable(arrayListOf(Mesh(obj.vertexData, obj.indexData, attribute, bodenMaterial)))
        boden.emissionsFarbe = Vector3f(0.0f, 1.0f, 0.0f)

        // Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        motorrad.scaleLocal(Vector3f(0.8f))

        // Kamera
        kamera.parent = motorrad
        kamera.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.3f, 5.0f))

        // Licht am Motorrad
        motorradLicht = PointLight(Vector3f(0.0f, 1.6f, 0.2f), Vector3f(1.0f, 1.0f, 1.0f))
        motorradLicht.parent = motorrad
        punktlichter.add(motorradLicht)

        // Scheinwerfer
        val scheinwerfer = SpotLight(
            Vector3f(0.0f, 1.1f, -1.7f), Vector3f(3.2f, 3.2f, 2.6f),
            Math.toRadians(13.0f), Math.toRadians(27.0f)
        )
        scheinwerfer.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        scheinwerfer.parent = motorrad
        strahler.add(scheinwerfer)

        // Ecken
        punktlichter.add(PointLight(Vector3f(-16.0f, 1.7f, -16.0f), Vector3f(8.0f, 0.6f, 0.0f)))
        punktlichter.add(PointLight(Vector3f(16.0f, 1.7f, -16.0f), Vector3f(0.0f, 2.0f, 8.0f)))
        punktlichter.add(PointLight(Vector3f(16.0f, 1.7f, 16.0f), Vector3f(6.0f, 6.0f, 0.5f)))
        punktlichter.add(PointLight(Vector3f(-16.0f, 1.7f, 16.0f), Vector3f(6.0f, 0.0f, 7.0f)))
    }

    private fun ladeTextur(name: String): Texture2D {
        val textur = Texture2D("assets/textures/$name.png", true)
        textur.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return textur
    }

    private fun welle(t: Float, tempo: Float) = (sin(t * tempo) + 1.0f) / 2.0f

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        shader.use()
        kamera.bind(shader)
        val sicht = kamera.getCalculateViewMatrix()

        val bunt = Vector3f(welle(t, 1.0f), welle(t, 1.7f), welle(t, 0.6f))
        motorradLicht.farbe = bunt
        motorrad.emissionsFarbe = bunt

        lichterSenden()

        boden.render(shader, sicht)
        motorrad.render(shader, sicht)
    }

    private fun lichterSenden() {
        val sicht = kamera.getCalculateViewMatrix()
        for (i in punktlichter.indices) punktlichter[i].bind(shader, "punktlichter[$i]", sicht)
        for (i in strahler.indices) strahler[i].bind(shader, "strahler[$i]", sicht)
        shader.setUniform("anzahlPunktlichter", punktlichter.size)
        shader.setUniform("anzahlStrahler", strahler.size)
    }

    fun update(dt: Float, t: Float) {
        var tempo = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) tempo = 5.5f
        if (window.getKeyState(GLFW_KEY_S)) tempo = -3.0f

        if (tempo != 0.0f) {
            var lenkung = 0.0f
            if (window.getKeyState(GLFW_KEY_A)) lenkung += 1.4f
            if (window.getKeyState(GLFW_KEY_D)) lenkung -= 1.4f
            motorrad.rotateLocal(0.0f, lenkung * dt, 0.0f)
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, -tempo * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val vorher = letzteMausX ?: xpos
        letzteMausX = xpos
        val winkel = ((vorher - xpos) * 0.002).toFloat()
        // um das Motorrad drehen = um den Ursprung vom Parent
        kamera.rotateAroundPoint(0.0f, winkel, 0.0f, Vector3f(0.0f))
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        shader.cleanup()
    }
}
