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
import org.lwjgl.glfw.GLFW.GLFW_KEY_A
import org.lwjgl.glfw.GLFW.GLFW_KEY_D
import org.lwjgl.glfw.GLFW.GLFW_KEY_S
import org.lwjgl.glfw.GLFW.GLFW_KEY_W
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {

    private val phongShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val boden: Renderable
    private val motorrad: Renderable
    private val kamera: TronCamera

    private val punktlicht: PointLight
    private val scheinwerfer: SpotLight

    // Aufgabe 4.6
    private val licht1: PointLight
    private val licht2: PointLight
    private val licht3: PointLight

    // letzte Mausposition (x, y), null bis zum ersten Ereignis
    private var mausAlt: DoubleArray? = null

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        // Boden
        val bodenDiff = textur("assets/textures/ground_diff.png")
        val bodenEmit = textur("assets/textures/ground_emit.png")
        val bodenSpec = textur("assets/textures/ground_spec.png")
        val bodenMaterial = Material(bodenDiff, bodenEmit, bodenSpec, 60.0f, Vector2f(64.0f, 64.0f))
        val bodenObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * Float.SIZE_BYTES
        val layout = arrayOf(
            VertexAttribute(3, stride, 0),
            VertexAttribute(2, stride, 3 * Float.SIZE_BYTES),
            VertexAttribute(3, stride, 5 * Float.SIZE_BYTES)
        )
        boden = Renderable(mutableListOf(Mesh(bodenObj.vertexData, bodenObj.indexData, layout, bodenMaterial)))

        // Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw IllegalStateException("Motorrad nicht gefunden")
        motorrad.scaleLocal(Vector3f(0.8f))

        // Kamera, Kind vom Motorrad
        kamera = TronCamera()
        kamera.rotateLocal(Math.toRadians(-32.0f), 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))
        kamera.parent = motorrad

        // Aufgabe 4.2: Punktlicht ueber dem Motorrad, Farbe kommt in render()
        punktlicht = PointLight(Vector3f(0.0f, 1.7f, 0.2f), Vector3f(1.0f, 1.0f, 1.0f))
        punktlicht.parent = motorrad

        // Aufgabe 4.3: Scheinwerfer vorne, leicht nach unten geneigt
        scheinwerfer = SpotLight(
            Vector3f(0.0f, 1.0f, -1.7f),
            Vector3f(3.0f, 2.9f, 2.6f),
            Math.toRadians(14.0f),
            Math.toRadians(24.0f)
        )
        scheinwerfer.rotateLocal(Math.toRadians(-11.0f), 0.0f, 0.0f)
        scheinwerfer.parent = motorrad

        // Aufgabe 4.6: drei weitere Punktlichter in den Ecken (nicht am Motorrad)
        licht1 = PointLight(Vector3f(-13.0f, 1.5f, -13.0f), Vector3f(8.0f, 0.8f, 0.4f))
        licht2 = PointLight(Vector3f(13.0f, 1.5f, -13.0f), Vector3f(0.4f, 1.0f, 8.0f))
        licht3 = PointLight(Vector3f(13.0f, 1.5f, 13.0f), Vector3f(6.5f, 0.5f, 7.0f))

        GLError.checkThrow("Scene.init")
    }

    private fun textur(pfad: String): Texture2D {
        val tex = Texture2D(pfad, true)
        tex.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return tex
    }

    // Aufgabe 4.4: 0.6 + 0.4 * sin(...) liegt zwischen 0.2 und 1, das Licht geht also nie ganz aus
    private fun farbe(t: Float): Vector3f {
        val r = 0.6f + 0.4f * sin(t)
        val g = 0.6f + 0.4f * sin(0.8f * t + 2.0f)
        val b = 0.6f + 0.4f * sin(1.3f * t + 4.0f)
        return Vector3f(r, g, b)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val motorradFarbe = farbe(t)
        punktlicht.lightCol = motorradFarbe

        phongShader.use()
        kamera.bind(phongShader)

        // Lichter vor den Objekten binden!
        punktlicht.bind(phongShader, "uPoint")
        scheinwerfer.bind(phongShader, "uSpot", kamera.getCalculateViewMatrix())
        licht1.bindNr(phongShader, 1)
        licht2.bindNr(phongShader, 2)
        licht3.bindNr(phongShader, 3)

        // Objekte
        phongShader.setUniform("uEmitCol", Vector3f(0.0f, 1.0f, 0.0f))
        boden.render(phongShader)
        phongShader.setUniform("uEmitCol", motorradFarbe)
        motorrad.render(phongShader)
    }

    fun update(dt: Float, t: Float) {
        // Blatt 3: Fahren
        var v = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) v += 5.0f
        if (window.getKeyState(GLFW_KEY_S)) v -= 5.0f

        // gelenkt wird nur waehrend der Fahrt
        var omega = 0.0f
        if (window.getKeyState(GLFW_KEY_A)) omega += 0.3f * v
        if (window.getKeyState(GLFW_KEY_D)) omega -= 0.3f * v

        motorrad.rotateLocal(0.0f, omega * dt, 0.0f)
        motorrad.translateLocal(Vector3f(0.0f, 0.0f, -v * dt))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val alt = mausAlt
        mausAlt = doubleArrayOf(xpos, ypos)
        if (alt == null) return

        // Aufgabe 4.5: Winkel = Differenz in x * 0.002
        val deltaX = alt[0] - xpos
        val winkel = (deltaX * 0.002).toFloat()
        kamera.rotateAroundPoint(0.0f, winkel, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        phongShader.cleanup()
    }
}
