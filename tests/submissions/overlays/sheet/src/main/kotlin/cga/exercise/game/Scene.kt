package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.Ecklicht
import cga.exercise.components.light.Frontscheinwerfer
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
import org.lwjgl.glfw.GLFW.GLFW_KEY_A
import org.lwjgl.glfw.GLFW.GLFW_KEY_D
import org.lwjgl.glfw.GLFW.GLFW_KEY_S
import org.lwjgl.glfw.GLFW.GLFW_KEY_W
import org.lwjgl.opengl.GL11.*

class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram =
        ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    // Objekte
    private val boden = Renderable()
    private val motorrad: Motorrad
    private val kamera = TronCamera()
    private val bodenFarbe = Vector3f(0.0f, 1.0f, 0.0f)

    // Lichter
    private val punktLicht: PointLight
    private val spotLicht: SpotLight
    private val eckLichter = ArrayList<Ecklicht>()

    // Maus
    private var ersteBewegung = true
    private var alteMausX = 0.0

    init {
        // Boden (Blatt 3)
        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * 4
        val attribute = arrayOf(
            VertexAttribute(3, stride, 0),
            VertexAttribute(2, stride, 3 * 4),
            VertexAttribute(3, stride, 5 * 4)
        )
        val bodenMaterial = Material(
            ladeTextur("assets/textures/ground_diff.png"),
            ladeTextur("assets/textures/ground_emit.png"),
            ladeTextur("assets/textures/ground_spec.png"),
            60.0f,
            Vector2f(64.0f, 64.0f)
        )
        boden.meshes.add(Mesh(res.vertexData, res.indexData, attribute, bodenMaterial))

        // Motorrad
        val modell = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
        if (modell == null) {
            throw IllegalStateException("Motorrad nicht gefunden")
        }
        motorrad = Motorrad(modell)

        // Kamera haengt am Motorrad
        kamera.parent = motorrad
        kamera.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))

        // Lichter (4.2, 4.3)
        punktLicht = PointLight(Vector3f(0.0f, 1.7f, 0.4f), Vector3f(1.0f, 1.0f, 1.0f))
        punktLicht.parent = motorrad
        spotLicht = Frontscheinwerfer(motorrad)

        // Ecken (4.6)
        eckLichter.add(Ecklicht(-1, -1, Vector3f(7.0f, 1.0f, 0.0f)))
        eckLichter.add(Ecklicht(1, -1, Vector3f(0.0f, 2.0f, 7.0f)))
        eckLichter.add(Ecklicht(1, 1, Vector3f(6.0f, 0.0f, 6.0f)))
        eckLichter.add(Ecklicht(-1, 1, Vector3f(6.0f, 6.0f, 1.0f)))

        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
        GLError.checkThrow()
    }

    private fun ladeTextur(pfad: String): Texture2D {
        val textur = Texture2D(pfad, true)
        textur.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return textur
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        kamera.bind(staticShader)

        // 4.4: Punktlicht bekommt die Farbe des Motorrads
        motorrad.faerben(t)
        punktLicht.setLichtfarbe(motorrad.getFarbe())

        // erst die Lichter, dann die Objekte
        punktLicht.bind(staticShader, "punkt")
        spotLicht.bind(staticShader, "spot", kamera.getCalculateViewMatrix())
        for (i in 0 until eckLichter.size) {
            eckLichter[i].bind(staticShader, "ecke" + (i + 1))
        }

        staticShader.setUniform("emissionFarbe", bodenFarbe)
        boden.render(staticShader)
        motorrad.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        var tempo = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) tempo = 6.0f
        if (window.getKeyState(GLFW_KEY_S)) tempo = -3.0f

        var lenkung = 0.0f
        if (window.getKeyState(GLFW_KEY_A)) lenkung += 1.0f
        if (window.getKeyState(GLFW_KEY_D)) lenkung -= 1.0f

        if (tempo != 0.0f) motorrad.fahren(tempo, lenkung, dt)
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        // beim ersten Mal gibt es noch keine alte Position
        if (ersteBewegung) {
            ersteBewegung = false
            alteMausX = xpos
            return
        }
        val differenz = (alteMausX - xpos).toFloat()
        alteMausX = xpos
        kamera.rotateAroundPoint(0.0f, differenz * 0.002f, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        staticShader.cleanup()
    }
}
