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

/** Blatt 4. Kotlin: Tobias, Shader: Lena */
class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val boden = Renderable()
    private val motorrad: Renderable
    private val kamera = TronCamera()

    private val motorradLicht: PointLight
    private val frontScheinwerfer: SpotLight
    private val punktLichter = mutableListOf<PointLight>()
    private val scheinwerfer = mutableListOf<SpotLight>()

    private var letztesX = 0.0
    private var ersteMausbewegung = true

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        // Boden
        val schritt = 8 * 4
        val attribute = arrayOf(
            VertexAttribute(3, schritt, 0),
            VertexAttribute(2, schritt, 3 * 4),
            VertexAttribute(3, schritt, 5 * 4)
        )
        val bodenMaterial = Material(
            textur("assets/textures/ground_diff.png"),
            textur("assets/textures/ground_emit.png"),
            textur("assets/textures/ground_spec.png"),
            60.0f,
            Vector2f(64.0f, 64.0f)
        )
        val bodenDaten = OBJLoader.loadOBJ("assets/models/ground.obj")
        boden.meshes.add(Mesh(bodenDaten.vertexData, bodenDaten.indexData, attribute, bodenMaterial))
        boden.leuchtfarbe = Vector3f(0.0f, 1.0f, 0.0f)

        // Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw IllegalArgumentException("Motorrad nicht gefunden")
        motorrad.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        // Kamera
        kamera.parent = motorrad
        kamera.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.5f, 4.5f))

        // Lichter
        motorradLicht = PointLight(Vector3f(0.0f, 1.6f, 0.4f), Vector3f(1.0f, 1.0f, 1.0f))
        motorradLicht.parent = motorrad
        punktLichter.add(motorradLicht)

        frontScheinwerfer = SpotLight(
            Vector3f(0.0f, 1.0f, -1.9f),
            Vector3f(2.5f, 2.5f, 3.0f),
            Math.toRadians(15.0f),
            Math.toRadians(28.0f)
        )
        frontScheinwerfer.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        frontScheinwerfer.parent = motorrad
        scheinwerfer.add(frontScheinwerfer)

        val rand = 16.0f
        punktLichter.add(PointLight(Vector3f(-rand, 2.0f, -rand), Vector3f(9.0f, 1.0f, 0.0f)))
        punktLichter.add(PointLight(Vector3f(rand, 2.0f, -rand), Vector3f(0.0f, 2.0f, 9.0f)))
        punktLichter.add(PointLight(Vector3f(-rand, 2.0f, rand), Vector3f(8.0f, 0.0f, 8.0f)))
        punktLichter.add(PointLight(Vector3f(rand, 2.0f, rand), Vector3f(8.0f, 7.0f, 0.0f)))
    }

    private fun textur(pfad: String): Texture2D {
        val t = Texture2D(pfad, true)
        t.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return t
    }

    /** Sinus auf den Bereich 0.2 bis 1.0 */
    private fun welle(x: Float): Float = 0.6f + 0.4f * sin(x)

    private fun farbeZurZeit(t: Float) = Vector3f(welle(t), welle(1.5f * t + 2.0f), welle(0.8f * t + 4.0f))

    private fun lichterUebergeben() {
        for (i in punktLichter.indices) {
            punktLichter[i].bind(shader, "point_lights[$i]")
        }
        shader.setUniform("num_points", punktLichter.size)

        val sicht = kamera.getCalculateViewMatrix()
        for (i in scheinwerfer.indices) {
            scheinwerfer[i].bind(shader, "spot_lights[$i]", sicht)
        }
        shader.setUniform("num_spots", scheinwerfer.size)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        shader.use()

        val farbe = farbeZurZeit(t)
        motorrad.leuchtfarbe = farbe
        motorradLicht.lichtfarbe = farbe

        kamera.bind(shader)
        lichterUebergeben()
        boden.render(shader)
        motorrad.render(shader)
    }

    fun update(dt: Float, t: Float) {
        val tempo = 6.0f
        val lenkung = Math.toRadians(80.0f)
        if (window.getKeyState(GLFW_KEY_W)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, -tempo * dt))
            if (window.getKeyState(GLFW_KEY_A)) motorrad.rotateLocal(0.0f, lenkung * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorrad.rotateLocal(0.0f, -lenkung * dt, 0.0f)
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, 0.5f * tempo * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (ersteMausbewegung) {
            letztesX = xpos
            ersteMausbewegung = false
        }
        val differenz = letztesX - xpos
        letztesX = xpos
        kamera.umkreisen((differenz * 0.002).toFloat())
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        shader.cleanup()
    }
}
