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
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader1: ShaderProgram
    private val gr: Renderable
    private val bike: Renderable
    private val cam = TronCamera()

    private val l1: PointLight
    private val l2: SpotLight
    private val l3: PointLight
    private val l4: PointLight
    private val l5: PointLight
    private val l6: PointLight

    // Motorrad
    private var bX = 0.0f
    private var bZ = 0.0f
    private var bW = 0.0f
    private var bV = 0.0f

    // Farbe vom Motorrad
    private var cR = 1.0f
    private var cG = 1.0f
    private var cB = 1.0f

    // Kamera + Maus
    private var camW = 0.0f
    private var mErst = true
    private var mAlt = 0.0
    private var mNeu = 0.0
    private var mDiff = 0.0
    //private var mAltY = 0.0
    //private var mDiffY = 0.0

    init {
        shader1 = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        // Boden
        val t1 = Texture2D("assets/textures/ground_diff.png", true)
        val t2 = Texture2D("assets/textures/ground_emit.png", true)
        val t3 = Texture2D("assets/textures/ground_spec.png", true)
        t1.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        t2.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        t3.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val mat = Material(t1, t2, t3, 60.0f, Vector2f(64.0f, 64.0f))
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val a1 = VertexAttribute(3, 32, 0)
        val a2 = VertexAttribute(2, 32, 12)
        val a3 = VertexAttribute(3, 32, 20)
        gr = Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, arrayOf(a1, a2, a3), mat)))

        // Motorrad
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        //bike.scaleLocal(Vector3f(0.8f))

        //cam.parent = bike
        //cam.rotateLocal(Math.toRadians(-35.0f), 0.0f, 0.0f)
        //cam.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))

        // 4.2
        l1 = PointLight(Vector3f(0.0f, 1.8f, 0.3f), Vector3f(1.0f, 1.0f, 1.0f))
        l1.parent = bike

        // 4.3
        l2 = SpotLight(Vector3f(0.0f, 1.0f, -1.8f), Vector3f(3.0f, 3.0f, 3.0f), Math.toRadians(12.0f), Math.toRadians(22.0f))
        l2.rotateLocal(Math.toRadians(-10.0f), 0.0f, 0.0f)
        l2.parent = bike

        // 4.6
        l3 = PointLight(Vector3f(-13.0f, 1.7f, -13.0f), Vector3f(7.0f, 0.3f, 0.3f))
        l4 = PointLight(Vector3f(13.0f, 1.7f, -13.0f), Vector3f(0.3f, 0.8f, 8.0f))
        l5 = PointLight(Vector3f(-13.0f, 1.7f, 13.0f), Vector3f(6.0f, 5.0f, 0.0f))
        l6 = PointLight(Vector3f(13.0f, 1.7f, 13.0f), Vector3f(6.0f, 0.0f, 6.0f))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        // alles bewegen
        bike.modelMatrix = Matrix4f().translate(bX, 0.0f, bZ).rotateY(bW).scale(0.8f)
        //cam.modelMatrix = Matrix4f().rotateY(camW).translate(0.0f, 2.0f, 4.0f)
        cam.modelMatrix = Matrix4f().translate(bX, 0.5f, bZ).rotateY(bW + camW).rotateX(-0.5f).translate(0.0f, 0.0f, 3.7f)

        // 4.4
        //cR = sin(t)
        //cG = sin(t)
        //cB = sin(t)
        cR = sin(t * 1.3f) * 0.5f + 0.5f
        cG = sin(t * 0.9f + 2.0f) * 0.5f + 0.5f
        cB = sin(t * 0.5f + 4.0f) * 0.5f + 0.5f
        l1.c = Vector3f(cR, cG, cB)

        shader1.use()
        cam.bind(shader1)
        l1.bind(shader1, "1")
        l2.bind(shader1, "2", cam.getCalculateViewMatrix())
        l3.bind(shader1, "3")
        l4.bind(shader1, "4")
        l5.bind(shader1, "5")
        l6.bind(shader1, "6")

        shader1.setUniform("emC", Vector3f(0.0f, 1.0f, 0.0f))
        gr.render(shader1, cam.getCalculateViewMatrix())
        shader1.setUniform("emC", Vector3f(cR, cG, cB))
        bike.render(shader1, cam.getCalculateViewMatrix())
    }

    fun update(dt: Float, t: Float) {
        bV = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) bV = 5.0f
        if (window.getKeyState(GLFW_KEY_S)) bV = -5.0f
        if (window.getKeyState(GLFW_KEY_A)) bW += 0.25f * bV * dt
        if (window.getKeyState(GLFW_KEY_D)) bW -= 0.25f * bV * dt
        bX -= sin(bW) * bV * dt
        bZ -= cos(bW) * bV * dt
        //bike.translateLocal(Vector3f(0.0f, 0.0f, -5.0f * dt))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        mNeu = xpos
        if (mErst) {
            mAlt = mNeu
            mErst = false
        }
        mDiff = mNeu - mAlt
        camW -= (mDiff * 0.002).toFloat()
        mAlt = mNeu
        //cam.rotateLocal(0.0f, (mDiff * 0.002).toFloat(), 0.0f)
        //cam.rotateAroundPoint(0.0f, (mDiff * 0.002).toFloat(), 0.0f, bike.getWorldPosition())
    }

    fun cleanup() {
        gr.cleanup()
        bike.cleanup()
        shader1.cleanup()
    }
}
