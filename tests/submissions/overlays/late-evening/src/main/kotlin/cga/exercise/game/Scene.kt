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
import org.lwjgl.glfw.GLFW
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {

    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private var boden = Renderable()
    private var motorrad: Renderable
    private var kamera = TronCamera()

    private var motorLicht: PointLight
    private var frontLicht: SpotLight
    private var lampen = ArrayList<PointLight>()

    private var gruen = Vector3f(0.0f, 1.0f, 0.0f)
    private var bunt = Vector3f(1.0f, 1.0f, 1.0f)

    private var mausAlt = 0.0
    private var ersteMaus = true

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glCullFace(GL_BACK)
        glFrontFace(GL_CCW)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        //Boden
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        diff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        emit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        spec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val material = Material(diff, emit, spec, 60.0f, Vector2f(64.0f, 64.0f))

        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attribute = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        boden.meshes.add(Mesh(obj.vertexData, obj.indexData, attribute, material))

        //Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        motorrad.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        //Punktlicht
        motorLicht = PointLight(Vector3f(0.0f, 1.6f, 0.2f), Vector3f(1.0f, 1.0f, 1.0f))
        motorLicht.parent = motorrad

        //Scheinwerfer
        frontLicht = SpotLight(Vector3f(0.0f, 1.0f, -2.0f), Vector3f(2.5f, 2.5f, 2.5f), Math.toRadians(15.0f), Math.toRadians(28.0f))
        frontLicht.rotateLocal(Math.toRadians(-9.0f), 0.0f, 0.0f)
        frontLicht.parent = motorrad

        //Lampen in den Ecken und eine vorne in der Mitte
        lampen.add(PointLight(Vector3f(14.0f, 1.8f, 14.0f), Vector3f(7.0f, 0.0f, 0.0f)))
        lampen.add(PointLight(Vector3f(14.0f, 1.8f, -14.0f), Vector3f(0.0f, 0.0f, 7.0f)))
        lampen.add(PointLight(Vector3f(-14.0f, 1.8f, -14.0f), Vector3f(6.0f, 3.0f, 0.0f)))
        lampen.add(PointLight(Vector3f(-14.0f, 1.8f, 14.0f), Vector3f(5.0f, 0.0f, 6.0f)))
        lampen.add(PointLight(Vector3f(0.0f, 2.2f, -18.0f), Vector3f(0.0f, 5.0f, 5.0f)))

        //Kamera
        kamera.parent = motorrad
        kamera.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        shader.use()
        kamera.bind(shader)

        motorLicht.bind(shader, "Motor")
        frontLicht.bind(shader, "Front", kamera.getCalculateViewMatrix())
        for (i in 0 until lampen.size) {
            lampen[i].bind(shader, "Lampe[$i]")
        }

        boden.render(shader, gruen)
        motorrad.render(shader, bunt)
    }

    fun update(dt: Float, t: Float) {
        //Farbe vom Motorrad und seinem Licht
        bunt = Vector3f(sin(t) * 0.5f + 0.5f, sin(t * 1.4f + 2.0f) * 0.5f + 0.5f, sin(t * 0.6f + 4.0f) * 0.5f + 0.5f)
        motorLicht.col = bunt

        if (window.getKeyState(GLFW.GLFW_KEY_W)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, -5.0f * dt))
            if (window.getKeyState(GLFW.GLFW_KEY_A)) motorrad.rotateLocal(0.0f, 1.2f * dt, 0.0f)
            if (window.getKeyState(GLFW.GLFW_KEY_D)) motorrad.rotateLocal(0.0f, -1.2f * dt, 0.0f)
        }
        if (window.getKeyState(GLFW.GLFW_KEY_S)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, 5.0f * dt))
            if (window.getKeyState(GLFW.GLFW_KEY_A)) motorrad.rotateLocal(0.0f, -1.2f * dt, 0.0f)
            if (window.getKeyState(GLFW.GLFW_KEY_D)) motorrad.rotateLocal(0.0f, 1.2f * dt, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (ersteMaus) {
            mausAlt = xpos
            ersteMaus = false
        }
        val dx = (mausAlt - xpos) * 0.002
        mausAlt = xpos
        kamera.rotateAroundPoint(0.0f, dx.toFloat(), 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        shader.cleanup()
    }
}
