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
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {

    private companion object {
        // ---- Objekte ----
        const val OBJ_BODEN = 0
        const val OBJ_MOTORRAD = 1
        const val OBJ_ANZAHL = 2

        const val MOTORRAD_SKALIERUNG = 0.75f

        // ---- Lichter ----
        const val SLOT_MOTORRAD = 0
        const val SLOT_ECKEN = 1
        const val ECKEN_ANZAHL = 4
        const val SLOT_SCHEINWERFER = SLOT_ECKEN + ECKEN_ANZAHL
        const val LICHT_ANZAHL = SLOT_SCHEINWERFER + 1

        const val WINKEL_INNEN_GRAD = 14.0f
        const val WINKEL_AUSSEN_GRAD = 24.0f

        // x, y, z je Ecke
        val ECKEN_POS = floatArrayOf(
            -13.0f, 1.6f, -13.0f,
            13.0f, 1.6f, -13.0f,
            13.0f, 1.6f, 13.0f,
            -13.0f, 1.6f, 13.0f
        )

        // r, g, b je Ecke
        val ECKEN_FARBE = floatArrayOf(
            6.0f, 0.6f, 0.3f,
            0.4f, 1.5f, 6.5f,
            5.5f, 0.5f, 5.0f,
            5.5f, 4.5f, 0.2f
        )

        // ---- Maus ----
        const val MAUS_FAKTOR = 0.002

        // ---- Farbverlauf des Motorrads: Kreisfrequenz und Phase je Kanal ----
        val FARB_OMEGA = floatArrayOf(0.9f, 1.3f, 0.7f)
        val FARB_PHASE = floatArrayOf(0.0f, 2.1f, 4.2f)

        // ---- Fahren ----
        const val TEMPO = 6.0f          // Einheiten je s
        const val LENKUNG = 1.4f        // rad je s
    }

    private val shader: ShaderProgram
    private val objekte: Array<Renderable>
    private val objektFarben: Array<Vector3f>
    private val lichter: Array<PointLight>
    private val kamera: TronCamera

    private var mausX: Double = 0.0
    private var mausEreignisse: Int = 0

    init {
        shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        objekte = arrayOf(ladeBoden(), ladeMotorrad())
        objektFarben = arrayOf(
            Vector3f(0.0f, 1.0f, 0.0f),
            Vector3f(1.0f, 1.0f, 1.0f)      // wird in render() ueberschrieben
        )
        check(objekte.size == OBJ_ANZAHL)
        val motorrad = objekte[OBJ_MOTORRAD]

        lichter = erzeugeLichter(motorrad)
        check(lichter.size == LICHT_ANZAHL)

        kamera = TronCamera(toRadians(75.0f), 16.0f / 9.0f, 0.1f, 120.0f)
        kamera.parent = motorrad
        kamera.translateLocal(Vector3f(0.0f, 2.5f, 4.6f))
        kamera.rotateLocal(toRadians(-24.0f), 0.0f, 0.0f)

        GLError.checkThrow("Scene.init")
    }

    private fun ladeTextur(pfad: String): Texture2D {
        val tex = Texture2D(pfad, true)
        tex.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return tex
    }

    private fun ladeBoden(): Renderable {
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * 4
        val attribute = arrayOf(
            VertexAttribute(3, stride, 0),
            VertexAttribute(2, stride, 3 * 4),
            VertexAttribute(3, stride, 5 * 4)
        )
        val material = Material(
            ladeTextur("assets/textures/ground_diff.png"),
            ladeTextur("assets/textures/ground_emit.png"),
            ladeTextur("assets/textures/ground_spec.png"),
            60.0f,
            Vector2f(64.0f, 64.0f)
        )
        val boden = Renderable()
        boden.meshes.add(Mesh(obj.vertexData, obj.indexData, attribute, material))
        return boden
    }

    private fun ladeMotorrad(): Renderable {
        val motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
        checkNotNull(motorrad) { "motorcycle.obj nicht gefunden" }
        motorrad.scaleLocal(Vector3f(MOTORRAD_SKALIERUNG))
        return motorrad
    }

    private fun erzeugeLichter(motorrad: Renderable): Array<PointLight> = Array(LICHT_ANZAHL) { i ->
        when (i) {
            SLOT_MOTORRAD -> {
                val licht = PointLight(Vector3f(0.0f, 1.9f, 0.3f), Vector3f(1.0f), i)
                licht.parent = motorrad
                licht
            }
            SLOT_SCHEINWERFER -> {
                val licht = SpotLight(
                    Vector3f(0.0f, 1.1f, -1.7f),
                    Vector3f(3.2f, 3.0f, 2.5f),
                    i,
                    toRadians(WINKEL_INNEN_GRAD),
                    toRadians(WINKEL_AUSSEN_GRAD)
                )
                licht.rotateLocal(toRadians(-11.0f), 0.0f, 0.0f)
                licht.parent = motorrad
                licht
            }
            else -> {
                val k = 3 * (i - SLOT_ECKEN)
                PointLight(
                    Vector3f(ECKEN_POS[k], ECKEN_POS[k + 1], ECKEN_POS[k + 2]),
                    Vector3f(ECKEN_FARBE[k], ECKEN_FARBE[k + 1], ECKEN_FARBE[k + 2]),
                    i
                )
            }
        }
    }

    /** Kanal 0 = r, 1 = g, 2 = b; Ergebnis zwischen 0 und 1 */
    private fun farbkanal(kanal: Int, t: Float): Float =
        0.5f + 0.5f * sin(FARB_OMEGA[kanal] * t + FARB_PHASE[kanal])

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        // 1. Zustand fuer diesen Frame
        val farbe = objektFarben[OBJ_MOTORRAD]
        farbe.set(farbkanal(0, t), farbkanal(1, t), farbkanal(2, t))
        lichter[SLOT_MOTORRAD].lichtfarbe.set(farbe)

        // 2. Kamera
        shader.use()
        kamera.bind(shader)
        val view = kamera.getCalculateViewMatrix()

        // 3. Lichter
        shader.setUniform("u_lightCount", LICHT_ANZAHL)
        for (i in 0 until LICHT_ANZAHL) {
            val licht = lichter[i]
            if (licht is SpotLight) {
                licht.bind(shader, "u_light", view)
            } else {
                licht.bind(shader, "u_light")
            }
        }

        // 4. Objekte
        for (i in 0 until OBJ_ANZAHL) {
            shader.setUniform("u_emitCol", objektFarben[i])
            objekte[i].render(shader, view)
        }
    }

    fun update(dt: Float, t: Float) {
        val motorrad = objekte[OBJ_MOTORRAD]
        val gas = taste(GLFW_KEY_W) - taste(GLFW_KEY_S)
        val lenk = taste(GLFW_KEY_A) - taste(GLFW_KEY_D)
        if (gas == 0) {
            return
        }
        motorrad.rotateLocal(0.0f, gas * lenk * LENKUNG * dt, 0.0f)
        // translateLocal wirkt in skalierten Koordinaten, daher durch die Skalierung teilen
        motorrad.translateLocal(Vector3f(0.0f, 0.0f, -gas * TEMPO * dt / MOTORRAD_SKALIERUNG))
    }

    private fun taste(key: Int): Int = if (window.getKeyState(key)) 1 else 0

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val deltaX = xpos - mausX
        mausX = xpos
        mausEreignisse++
        if (mausEreignisse == 1) {
            return      // erstes Ereignis: es gibt noch keine alte Position
        }

        // Drehpunkt = Ursprung des Motorrads (Parent der Kamera)
        val winkel = (-deltaX * MAUS_FAKTOR).toFloat()
        kamera.rotateAroundPoint(0.0f, winkel, 0.0f, Vector3f(0.0f))
    }

    fun cleanup() {
        for (i in 0 until OBJ_ANZAHL) {
            objekte[i].cleanup()
        }
        shader.cleanup()
    }
}
