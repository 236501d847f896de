package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.Lampe
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
    private val shader: ShaderProgram
    private val boden = Renderable()
    private val bike: Renderable
    private val cam = TronCamera()

    private val pl: PointLight
    private val sw: SpotLight

    // 4.6
    private val l2 = Lampe(2, -11.0f, -12.0f, Vector3f(5.0f, 0.4f, 0.2f))
    private val l3 = Lampe(3, 12.0f, -11.0f, Vector3f(0.2f, 0.8f, 5.5f))
    private val l4 = Lampe(4, -13.0f, 11.0f, Vector3f(4.5f, 0.2f, 4.5f))
    private val l5 = Lampe(5, 11.0f, 13.0f, Vector3f(4.5f, 3.6f, 0.2f))

    private val gruen = Vector3f(0.0f, 1.0f, 0.0f)

    // maus
    private var mx = 0.0
    private var erst = true

    init {
        shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // boden
        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val va = arrayOf(
            VertexAttribute(3, 32, 0),
            VertexAttribute(2, 32, 12),
            VertexAttribute(3, 32, 20)
        )
        val texd = Texture2D("assets/textures/ground_diff.png", true)
        val texe = Texture2D("assets/textures/ground_emit.png", true)
        val texs = Texture2D("assets/textures/ground_spec.png", true)
        texd.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texe.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texs.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val bodenmat = Material(texd, texe, texs, 60.0f, Vector2f(64.0f, 64.0f))
        boden.meshes.add(Mesh(res.vertexData, res.indexData, va, bodenmat))

        // bike
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw Exception("bike nicht da")
        bike.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))
        println("bike geladen, ${bike.meshes.size} meshes")

        // kamera
        cam.rotateLocal(Math.toRadians(-33.0f), 0.0f, 0.0f)
        cam.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))
        cam.parent = bike

        // 4.2 licht am bike
        pl = PointLight(Vector3f(0.0f, 0.0f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f))
        pl.parent = bike
        pl.translateLocal(Vector3f(0.0f, 1.6f, 0.3f))   // sonst im boden

        // 4.3 scheinwerfer
        sw = SpotLight(
            Vector3f(0.0f, 1.0f, -1.7f),
            Vector3f(2.5f, 2.5f, 2.2f),
            Math.toRadians(13.0f),
            Math.toRadians(23.0f)
        )
        sw.parent = bike
        sw.rotateLocal(Math.toRadians(-11.0f), 0.0f, 0.0f)

        // TODO ecklichter als PointLight? gerade Lampe, geht auch
        // el = PointLight(Vector3f(10.0f, 1.0f, 10.0f), Vector3f(1.0f, 0.0f, 0.0f))
        println("scene fertig")
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        shader.use()
        cam.bind(shader)

        // 4.4 farbe
        val bikecol = Vector3f(
            Math.abs(Math.sin(t)),
            Math.abs(Math.sin(t * 0.7f + 1.0f)),
            Math.abs(Math.sin(t * 0.4f + 2.0f))
        )
        pl.farbe = bikecol
        // println(bikecol)

        // lichter
        pl.bind(shader, "pl")
        // shader.setUniform("pospl", Vector3f(11.0f, 1.3f, 13.0f))   // ecke, erster versuch 4.6
        sw.bind(shader, "sw", cam.getCalculateViewMatrix())
        l2.an(shader)
        l3.an(shader)
        l4.an(shader)
        l5.an(shader)

        // objekte
        boden.render(shader, gruen)
        bike.render(shader, bikecol)
    }

    fun update(dt: Float, t: Float) {
        // TODO schoener fahren
        if (window.getKeyState(GLFW_KEY_W)) {
            bike.translateLocal(Vector3f(0.0f, 0.0f, -6.0f * dt))
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            bike.translateLocal(Vector3f(0.0f, 0.0f, 4.0f * dt))
        }
        if (window.getKeyState(GLFW_KEY_A)) {
            bike.rotateLocal(0.0f, Math.toRadians(70.0f) * dt, 0.0f)
        }
        if (window.getKeyState(GLFW_KEY_D)) {
            bike.rotateLocal(0.0f, Math.toRadians(-70.0f) * dt, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        // debug
        if (key == GLFW_KEY_P && action == GLFW_PRESS) {
            println("bike ${bike.getWorldPosition()} cam ${cam.getWorldPosition()} licht ${pl.getWorldPosition()}")
        }
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (erst) {
            mx = xpos
            erst = false
        }
        val dx = (xpos - mx).toFloat()
        mx = xpos
        // cam.rotateLocal(0.0f, dx * 0.002f, 0.0f)   // dreht sich um sich selbst
        cam.rotateAroundPoint(0.0f, -dx * 0.002f, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        boden.cleanup()
        bike.cleanup()
        shader.cleanup()
    }
}
