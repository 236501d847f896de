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
import org.lwjgl.glfw.GLFW
import org.lwjgl.opengl.GL11.*

class Scene(private val window: GameWindow) {

    private val staticShader: ShaderProgram
    private val boden: Renderable
    private val motorrad: Renderable
    private val kamera: TronCamera

    private val motorradLicht: PointLight
    private val scheinwerfer: SpotLight
    private val rot: PointLight
    private val blau: PointLight
    private val gelb: PointLight
    private val tuerkis: PointLight

    // ausprobiert, sieht so am besten aus
    private val kameraAbstand = 4.3f
    private val kameraNeigung = Math.toRadians(-28.0f)

    private var ersteBewegung = true
    private var alteMausX = 0.0

    //scene setup
    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        boden = bodenLaden()
        val geladen = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
        if (geladen == null) throw Exception("Motorrad nicht gefunden")
        motorrad = geladen
        motorrad.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        // Kamera
        kamera = TronCamera()
        kamera.parent = motorrad
        kamera.translateLocal(Vector3f(0.0f, 0.6f, 0.0f))
        kamera.rotateLocal(kameraNeigung, 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.0f, kameraAbstand))

        // Punktlicht am Motorrad
        motorradLicht = PointLight(Vector3f(0.0f, 0.0f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f), 1.0f, GLFW.GLFW_KEY_P)
        motorradLicht.parent = motorrad
        motorradLicht.translateLocal(Vector3f(0.0f, 1.7f, 0.2f))

        // Scheinwerfer
        scheinwerfer = SpotLight(
            Vector3f(0.0f, 0.95f, -1.85f), Vector3f(1.0f, 1.0f, 0.9f),
            Math.toRadians(13.0f), Math.toRadians(24.0f), 3.2f, GLFW.GLFW_KEY_L
        )
        scheinwerfer.rotateLocal(Math.toRadians(-11.0f), 0.0f, 0.0f)
        scheinwerfer.parent = motorrad

        // Ecken, 0.9f weil sonst zu hell
        rot = PointLight(Vector3f(-16.0f, 1.6f, -16.0f), Vector3f(9.0f, 0.6f, 0.3f), 0.9f)
        blau = PointLight(Vector3f(16.0f, 1.6f, -16.0f), Vector3f(0.5f, 0.8f, 9.0f), 0.9f)
        gelb = PointLight(Vector3f(16.0f, 1.6f, 16.0f), Vector3f(8.0f, 7.0f, 0.4f), 0.9f)
        tuerkis = PointLight(Vector3f(-16.0f, 1.6f, 16.0f), Vector3f(0.2f, 8.0f, 7.0f), 0.9f)
    }

    private fun bodenLaden(): Renderable {
        val diff = textur("assets/textures/ground_diff.png")
        val emit = textur("assets/textures/ground_emit.png")
        val spec = textur("assets/textures/ground_spec.png")
        val material = Material(diff, emit, spec, 60.0f, Vector2f(64.0f, 64.0f))
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val pos = VertexAttribute(3, 8 * 4, 0)
        val tex = VertexAttribute(2, 8 * 4, 3 * 4)
        val nor = VertexAttribute(3, 8 * 4, 5 * 4)
        val mesh = Mesh(obj.vertexData, obj.indexData, arrayOf(pos, tex, nor), material)
        val r = Renderable()
        r.meshes.add(mesh)
        return r
    }

    private fun textur(datei: String): Texture2D {
        val t = Texture2D(datei, true)
        t.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return t
    }

    /** goes up and down between 0.1 and 0.9 */
    private fun wackeln(t: Float, wieSchnell: Float): Float {
        val s = Math.sin(t * wieSchnell)
        return 0.5f + 0.4f * s
    }

    private fun bunteFarbe(t: Float): Vector3f {
        val r = wackeln(t, 1.0f)
        val g = wackeln(t, 0.6f)
        val b = wackeln(t, 1.7f)
        return Vector3f(r, g, b)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        kamera.bind(staticShader)

        // Motorrad und sein Licht haben dieselbe Farbe
        val farbe = bunteFarbe(t)
        motorradLicht.lightColor = farbe

        motorradLicht.bind(staticShader, "motorradLicht")
        scheinwerfer.bind(staticShader, "scheinwerfer", kamera.getCalculateViewMatrix())
        rot.bind(staticShader, "rot")
        blau.bind(staticShader, "blau")
        gelb.bind(staticShader, "gelb")
        tuerkis.bind(staticShader, "tuerkis")

        boden.renderBunt(staticShader, Vector3f(0.0f, 1.0f, 0.0f))
        motorrad.renderBunt(staticShader, farbe)
    }

    fun update(dt: Float, t: Float) {
        var gas = 0.0f
        var lenken = 0.0f
        if (window.getKeyState(GLFW.GLFW_KEY_W)) gas = gas + 5.5f
        if (window.getKeyState(GLFW.GLFW_KEY_S)) gas = gas - 3.0f
        if (window.getKeyState(GLFW.GLFW_KEY_A)) lenken = lenken + 1.4f
        if (window.getKeyState(GLFW.GLFW_KEY_D)) lenken = lenken - 1.4f
        if (gas < 0.0f) lenken = -lenken
        if (gas != 0.0f) {
            motorrad.rotateLocal(0.0f, lenken * dt, 0.0f)
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, -gas * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (action == GLFW.GLFW_PRESS) {
            motorradLicht.tasteGedrueckt(key)
            scheinwerfer.tasteGedrueckt(key)
        }
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (ersteBewegung) {
            alteMausX = xpos
            ersteBewegung = false
            return
        }
        val unterschied = xpos - alteMausX
        alteMausX = xpos
        val winkel = (unterschied * 0.002).toFloat() * -1.0f

        // zum Motorrad hin, gerade stellen, drehen, alles wieder zurueck
        kamera.translateLocal(Vector3f(0.0f, 0.0f, -kameraAbstand))
        kamera.rotateLocal(-kameraNeigung, 0.0f, 0.0f)
        kamera.rotateLocal(0.0f, winkel, 0.0f)
        kamera.rotateLocal(kameraNeigung, 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.0f, kameraAbstand))
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        staticShader.cleanup()
    }
}
