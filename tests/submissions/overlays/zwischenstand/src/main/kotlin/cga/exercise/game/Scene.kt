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
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val boden: Renderable
    private val motorrad: Renderable
    private val kamera: TronCamera

    private val motorradLicht: PointLight
    private val scheinwerfer: SpotLight
    private val eckLichter: List<PointLight>

    private val bodenFarbe = Vector3f(0.0f, 1.0f, 0.0f)

    private var alteMausX = 0.0
    private var ersteBewegung = true

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Boden
        val bodenEmit = ladeTextur("ground_emit.png")
        val bodenDiff = ladeTextur("ground_diff.png")
        val bodenSpec = ladeTextur("ground_spec.png")
        val bodenMaterial = Material(bodenDiff, bodenEmit, bodenSpec, 60.0f, Vector2f(64.0f, 64.0f))
        val bodenObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attribute = arrayOf(
            VertexAttribute(3, 32, 0),
            VertexAttribute(2, 32, 12),
            VertexAttribute(3, 32, 20)
        )
        boden = Renderable()
        boden.meshes.add(Mesh(bodenObj.vertexData, bodenObj.indexData, attribute, bodenMaterial))

        // Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw Exception("Motorrad nicht gefunden")
        motorrad.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))
        println("Motorrad geladen, ${motorrad.meshes.size} Meshes")

        // Kamera
        kamera = TronCamera()
        kamera.rotateLocal(Math.toRadians(-35.0f), 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))
        kamera.parent = motorrad

        // Aufgabe 4.2: Punktlicht ueber dem Motorrad
        motorradLicht = PointLight(Vector3f(0.0f, 1.4f, 0.3f), Vector3f(1.0f, 1.0f, 1.0f))
        motorradLicht.parent = motorrad
        println("Motorradlicht: ${motorradLicht.getWorldPosition()}")

        // Aufgabe 4.3: Scheinwerfer
        scheinwerfer = SpotLight(
            Vector3f(0.0f, 1.0f, -1.6f),
            Vector3f(3.0f, 3.0f, 3.0f),
            Math.toRadians(14.0f),
            Math.toRadians(24.0f)
        )
        scheinwerfer.rotateLocal(Math.toRadians(-11.0f), 0.0f, 0.0f)
        scheinwerfer.parent = motorrad
        println("Scheinwerfer: ${scheinwerfer.getWorldPosition()} Richtung ${scheinwerfer.getWorldZAxis().negate()}")

        // Aufgabe 4.6: Ecken
        eckLichter = listOf(
            PointLight(Vector3f(-17.0f, 1.8f, -17.0f), Vector3f(9.0f, 1.0f, 0.0f)),
            PointLight(Vector3f(17.0f, 1.8f, -17.0f), Vector3f(0.0f, 3.0f, 9.0f)),
            PointLight(Vector3f(-17.0f, 1.8f, 17.0f), Vector3f(8.0f, 0.0f, 7.0f)),
            PointLight(Vector3f(17.0f, 1.8f, 17.0f), Vector3f(8.0f, 7.0f, 0.0f))
        )
        println("Anzahl Ecklichter: ${eckLichter.size}")
    }

    private fun ladeTextur(datei: String): Texture2D {
        val textur = Texture2D("assets/textures/$datei", true)
        textur.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return textur
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        // Aufgabe 4.4: Sinus-Werte der Zeit als RGB
        val rot = (sin(t) + 1.0f) / 2.0f
        val gruen = (sin(t * 0.5f + 2.0f) + 1.0f) / 2.0f
        val blau = (sin(t * 1.7f + 4.0f) + 1.0f) / 2.0f
        val motorradFarbe = Vector3f(rot, gruen, blau)
        motorradLicht.lichtfarbe = motorradFarbe

        shader.use()
        kamera.bind(shader)

        // erst die Lichter ...
        motorradLicht.bind(shader, "bikeLight")
        scheinwerfer.bind(shader, "headLight", kamera.getCalculateViewMatrix())
        shader.setUniform("cornerLightCount", eckLichter.size)
        for (i in eckLichter.indices) {
            eckLichter[i].bind(shader, "cornerLights[$i]")
        }

        // ... dann die Objekte
        shader.setUniform("emissionColor", bodenFarbe)
        boden.render(shader)
        shader.setUniform("emissionColor", motorradFarbe)
        motorrad.render(shader)
    }

    fun update(dt: Float, t: Float) {
        var tempo = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) tempo = 5.0f
        if (window.getKeyState(GLFW_KEY_S)) tempo = -5.0f

        if (tempo != 0.0f) {
            if (window.getKeyState(GLFW_KEY_A)) motorrad.rotateLocal(0.0f, 1.4f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorrad.rotateLocal(0.0f, -1.4f * dt, 0.0f)
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, -tempo * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_P && action == GLFW_PRESS) {
            println("Motorrad: ${motorrad.getWorldPosition()}")
            println("Kamera: ${kamera.getWorldPosition()}")
        }
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (ersteBewegung) {
            alteMausX = xpos
            ersteBewegung = false
        }
        val deltaX = xpos - alteMausX
        alteMausX = xpos
        // println("Maus: x=$xpos deltaX=$deltaX")

        val winkel = (deltaX * 0.002).toFloat()
        kamera.rotateAroundPoint(0.0f, winkel, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        shader.cleanup()
    }
}
